(** * Near a point: derivatives *)

Definition locally (a : R) (P : R -> Prop) : Prop := exists d, 0 < d /\ forall x, Rabs (x - a) < d -> P x.
Lemma locally_here a P : locally a P -> P a.
Proof. intros [d [D H]]. apply H. rewrite Rminus_diag_eq, Rabs_R0; trivial. Qed.
Lemma locally_all a (P : R -> Prop) : (forall x, P x) -> locally a P.
Proof. intro H. exists 1. split; [lra|auto]. Qed.
Lemma locally_and a (P Q S : R -> Prop) : (forall x, P x -> Q x -> S x) -> locally a P -> locally a Q -> locally a S.
Proof.
  intros W [c [C F]] [d [D G]]. exists (Rmin c d). split; [apply Rmin_glb_lt; trivial|].
  intros x X. pose proof (Rmin_l c d). pose proof (Rmin_r c d). apply W; [apply F|apply G]; lra.
Qed.
Lemma locally_weaken a (P Q : R -> Prop) : (forall x, P x -> Q x) -> locally a P -> locally a Q.
Proof. intros W [c [C F]]. exists c. auto. Qed.
(** It also holds near the points that are near. *)
Lemma locally_twice a P : locally a P -> locally a (fun x => locally x P).
Proof.
  intros [d [D H]]. exists (d / 2). split; [lra|]. intros x X. exists (d / 2). split; [lra|].
  intros y Y. apply H. replace (y - a) with ((y - x) + (x - a)) by ring.
  pose proof (Rabs_triang (y - x) (x - a)). lra.
Qed.
Lemma continuous_alt f a : continuity_pt f a <-> (forall eps, 0 < eps -> locally a (fun x => Rabs (f x - f a) < eps)).
Proof.
  unfold continuity_pt, continue_in, limit1_in, limit_in, D_x, no_cond, R_met, Base, dist, R_dist, locally.
  split; intros H eps P; destruct (H eps P) as [d [D F]]; exists d; (split; [trivial|]).
  - intros x X. destruct (Req_dec x a) as [->|N]; [rewrite Rminus_diag_eq, Rabs_R0; trivial|].
    apply F. repeat split; auto.
  - intros x [_ X]. auto.
Qed.
Lemma continuous_near f g a : locally a (fun x => f x = g x) -> continuity_pt f a -> continuity_pt g a.
Proof.
  rewrite !continuous_alt. intros E H eps P. specialize (H eps P). pose proof (locally_here _ _ E) as E0.
  cbn beta in E0. revert E H. apply locally_and. intros x <- . rewrite E0. trivial.
Qed.
Lemma continuous_positive f a : continuity_pt f a -> 0 < f a -> locally a (fun x => 0 < f x).
Proof.
  rewrite continuous_alt. intros H P. generalize (H _ P). apply locally_weaken. intros x X. apply Rabs_def2 in X. lra.
Qed.
Lemma continuous_nonzero f a : continuity_pt f a -> f a <> 0 -> locally a (fun x => f x <> 0).
Proof.
  rewrite continuous_alt. intros H P. generalize (H _ (Rabs_pos_lt _ P)). apply locally_weaken.
  intros x X Z0. rewrite Z0, Rminus_0_l, Rabs_Ropp in X. lra.
Qed.
Lemma continuous_steady f a c : (forall x, f x = c) -> continuity_pt f a.
Proof. intro H. apply continuity_pt_const. intros x y. rewrite !H. trivial. Qed.
Lemma continuous_pow f a n : continuity_pt f a -> continuity_pt (fun x => f x ^ n) a.
Proof.
  intro H. induction n as [|n IH]; simpl; [apply continuous_steady with 1; trivial|].
  apply (continuity_pt_mult f (fun x => f x ^ n)); trivial.
Qed.
Lemma continuous_abs f a : continuity_pt f a -> continuity_pt (fun x => Rabs (f x)) a.
Proof. intro H. apply (continuity_pt_comp f Rabs); trivial. apply Rcontinuity_abs. Qed.
Lemma continuous_min f g a : continuity_pt f a -> continuity_pt g a -> continuity_pt (fun x => Rmin (f x) (g x)) a.
Proof.
  intros F G. apply continuous_near with (fun x => (f x + g x - Rabs (f x - g x)) * / 2).
  - apply locally_all. intro x. unfold Rmin, Rabs. destruct Rle_dec, Rcase_abs; lra.
  - apply (continuity_pt_mult (fun x => f x + g x - Rabs (f x - g x)) (fun _ => / 2)).
    + apply (continuity_pt_minus (fun x => f x + g x) (fun x => Rabs (f x - g x))).
      * apply (continuity_pt_plus f g); trivial.
      * apply (continuous_abs (fun x => f x - g x)). apply (continuity_pt_minus f g); trivial.
    + apply continuous_steady with (/ 2); trivial.
Qed.
Lemma continuous_max f g a : continuity_pt f a -> continuity_pt g a -> continuity_pt (fun x => Rmax (f x) (g x)) a.
Proof.
  intros F G. apply continuous_near with (fun x => f x + g x - Rmin (f x) (g x)).
  - apply locally_all. intro x. unfold Rmin, Rmax. destruct Rle_dec; lra.
  - apply (continuity_pt_minus (fun x => f x + g x) (fun x => Rmin (f x) (g x))).
    + apply (continuity_pt_plus f g); trivial.
    + apply continuous_min; trivial.
Qed.

Lemma upd_same i x l : (i < length l)%nat -> nth i (upd i x l) 0 = x.
Proof.
  revert l. induction i as [|i IH]; intros [|y l] H; simpl in *; try (inversion H; fail); trivial.
  apply IH, Nat.succ_lt_mono, H.
Qed.
Lemma upd_other i k x l : k <> i -> nth k (upd i x l) 0 = nth k l 0.
Proof.
  revert k l. induction i as [|i IH]; intros [|k] [|y l] H; simpl; trivial; try tauto. apply IH. auto.
Qed.
Lemma upd_here i l : upd i (nth i l 0) l = l.
Proof. revert i. induction l as [|y l IH]; intros [|i]; simpl; trivial. rewrite IH; trivial. Qed.
Lemma mentions_not i e l x : mentions i e = false -> ev (upd i x l) e = ev l e.
Proof.
  induction e; simpl; intro M; repeat (apply orb_false_iff in M as [M ?]);
    rewrite ?IHe, ?IHe1, ?IHe2, ?IHe3, ?IHe4 by trivial; trivial; try discriminate.
  apply upd_other. apply Nat.eqb_neq in M. auto.
Qed.
(** All variables of polynomials as they are, but one. *)
Definition move (e : nat -> R) (v : nat) (x : R) : nat -> R := fun k => if Nat.eqb k v then x else e k.

Definition near_value (smooth : bool) (off : nat) (e : nat -> R) (l : list R) (i : nat) (a : expr) (q : option frac) : Prop :=
  match q with
  | Some q => conj (near_conds smooth i l a) /\
      continuity_pt (fun x => ev (upd i x l) a) (nth i l 0) /\ stands e (ev l a) q /\
      (smooth = true -> locally (nth i l 0) (fun x => stands (move e (off + i) x) (ev (upd i x l) a) q))
  | None => ~ conj (near_conds smooth i l a)
  end.

Section Near.
Variables (off : nat) (e : nat -> R) (l : list R) (i : nat).
Hypothesis AG : agrees off e l.
Hypothesis L : (i < length l)%nat.
Let a0 := nth i l 0.
Let at_ x := upd i x l.

Lemma move_agrees x : agrees off (move e (off + i) x) (at_ x).
Proof.
  intro k. unfold move, at_. destruct (Nat.eqb_spec (off + k) (off + i)) as [E|N].
  - apply Nat.add_cancel_l in E. subst. rewrite upd_same; trivial.
  - rewrite upd_other; [apply AG|]. intros ->. tauto.
Qed.
Lemma here a : ev (at_ a0) a = ev l a.
Proof. unfold at_, a0. rewrite upd_here. trivial. Qed.
Lemma move_here k : move e (off + i) a0 k = e k.
Proof. unfold move, a0. destruct (Nat.eqb_spec k (off + i)) as [->|]; trivial. symmetry. apply AG. Qed.

Lemma spec_near s a b c ps qs next :
  spec e ps (near_value s off e l i a) -> spec e qs (near_value s off e l i b) ->
  (conj (near_conds s i l c) -> conj (near_conds s i l a) /\ conj (near_conds s i l b)) ->
  (forall x y, near_value s off e l i a (Some x) -> near_value s off e l i b (Some y) ->
    spec e (next x y) (near_value s off e l i c)) ->
  spec e (both ps qs next) (near_value s off e l i c).
Proof.
  intros P Q C N. eapply spec_both; [exact P|exact Q| | |exact N]; unfold near_value; tauto.
Qed.
Lemma spec_near_one s a c ps next :
  spec e ps (near_value s off e l i a) ->
  (conj (near_conds s i l c) -> conj (near_conds s i l a)) ->
  (forall x, near_value s off e l i a (Some x) -> spec e (next x) (near_value s off e l i c)) ->
  spec e (each ps next) (near_value s off e l i c).
Proof.
  intros P C N. eapply spec_each; [exact P| |exact N]; unfold near_value; tauto.
Qed.

Definition stays (r : rel) (x y : expr) (t : bool) : Prop :=
  if t then related r (ev l x) (ev l y) /\ locally a0 (fun z => related r (ev (at_ z) x) (ev (at_ z) y))
  else ~ related r (ev l x) (ev l y) /\ locally a0 (fun z => ~ related r (ev (at_ z) x) (ev (at_ z) y)).
Definition guard_conds (x y : expr) : Prop :=
  conj (near_conds false i l x) /\ conj (near_conds false i l y) /\
  (mentions i x || mentions i y = true -> ev l x <> ev l y).
Definition guard_value r x y (t : option bool) : Prop :=
  match t with Some t => guard_conds x y /\ stays r x y t | None => ~ guard_conds x y end.
Lemma steadily_spec r x y p q : mentions i x || mentions i y = true ->
  near_value false off e l i x (Some p) -> near_value false off e l i y (Some q) ->
  spec e (steadily r p q) (guard_value r x y).
Proof.
  intros M [C1 [K1 [S1 _]]] [C2 [K2 [S2 _]]].
  pose proof (stands_sub _ _ _ _ _ S1 S2) as S. pose proof (stands_sub _ _ _ _ _ S2 S1) as T.
  pose proof (stands_sign _ _ _ S) as [k [K SK]]. pose proof (stands_sign _ _ _ T) as [j [J TJ]].
  destruct (pos_mult k (ev l x - ev l y) K) as [PK _]. destruct (pos_mult j (ev l y - ev l x) J) as [PJ _].
  destruct (pos_mult k (- (ev l x - ev l y)) K) as [QK _]. destruct (pos_mult j (- (ev l y - ev l x)) J) as [QJ _].
  assert (Z1 : peval e (fst (fadd p (fneg q))) = 0 <-> ev l x = ev l y).
  { destruct S as [D N]. rewrite <- N. split; [|intro E; rewrite E; ring]. intro Q0. apply Rmult_integral in Q0 as [Q0|Q0]; [lra|tauto]. }
  assert (Z2 : peval e (fst (fadd q (fneg p))) = 0 <-> ev l x = ev l y).
  { destruct T as [D N]. rewrite <- N. split; [|intro E; rewrite E; ring]. intro Q0. apply Rmult_integral in Q0 as [Q0|Q0]; [lra|tauto]. }
  assert (More : ev l x > ev l y -> locally a0 (fun z => ev (at_ z) x > ev (at_ z) y)).
  { intro G. assert (V : locally a0 (fun z => 0 < ev (at_ z) x - ev (at_ z) y)).
    { apply (continuous_positive (fun z => ev (at_ z) x - ev (at_ z) y)).
      - apply (continuity_pt_minus (fun z => ev (at_ z) x) (fun z => ev (at_ z) y)); trivial.
      - rewrite !here. lra. }
    revert V. apply locally_weaken. intros z. lra. }
  assert (Less : ev l x < ev l y -> locally a0 (fun z => ev (at_ z) x < ev (at_ z) y)).
  { intro G. assert (V : locally a0 (fun z => 0 < ev (at_ z) y - ev (at_ z) x)).
    { apply (continuous_positive (fun z => ev (at_ z) y - ev (at_ z) x)).
      - apply (continuity_pt_minus (fun z => ev (at_ z) y) (fun z => ev (at_ z) x)); trivial.
      - rewrite !here. lra. }
    revert V. apply locally_weaken. intros z. lra. }
  assert (G : forall t : bool, ev l x <> ev l y ->
    (ev l x > ev l y -> if t then forall u v : R, u > v -> related r u v else forall u v : R, u > v -> ~ related r u v) ->
    (ev l x < ev l y -> if t then forall u v : R, u < v -> related r u v else forall u v : R, u < v -> ~ related r u v) ->
    guard_value r x y (Some t)).
  { intros t N Up Down. split; [split; [trivial|split; trivial]|]. unfold stays.
    destruct (Rtotal_order (ev l x) (ev l y)) as [O|[O|O]]; [|tauto|].
    - specialize (Down O). destruct t; (split; [auto|]); generalize (Less O); apply locally_weaken; intros z; auto.
    - specialize (Up O). destruct t; (split; [auto|]); generalize (More O); apply locally_weaken; intros z; auto. }
  assert (Z0 : ev l x = ev l y -> guard_value r x y None).
  { intros E [_ [_ N]]. apply N; trivial. }
  unfold spec, steadily. split.
  - intros c I0 H. destruct r; destruct I0 as [<-|[<-|[<-|[]]]]; cbn [fst snd] in *;
      apply Forall_cons_iff in H as [H _]; unfold holds in H; cbn [asign apoly] in H;
      rewrite ?peval_neg, ?SK, ?TJ, ?Z1, ?Z2 in H;
      try (apply Z0; exact H);
      (apply G; [nra| |]; intro O; try (exfalso; nra); cbn [related]; intros; lra).
  - assert (E : exists c, In c (steadily r p q) /\ all_hold e (fst c)); [|exact E].
    destruct (Req_dec (ev l x) (ev l y)) as [E|N].
    + exists ([A (fst (match r with Lt | Le => fadd q (fneg p) | _ => fadd p (fneg q) end)) SZ], None).
      split; [destruct r; right; right; left; trivial|]. apply Forall_cons; [|apply Forall_nil].
      unfold holds; destruct r; cbn [asign apoly]; rewrite ?Z1, ?Z2; trivial.
    + destruct r; unfold steadily;
        (destruct (Rtotal_order (ev l x) (ev l y)) as [O|[O|O]]; [|tauto|]);
        [eexists; split; [right; left; reflexivity|] |eexists; split; [left; reflexivity|]
        |eexists; split; [right; left; reflexivity|] |eexists; split; [left; reflexivity|]
        |eexists; split; [left; reflexivity|] |eexists; split; [right; left; reflexivity|]
        |eexists; split; [left; reflexivity|] |eexists; split; [right; left; reflexivity|]
        |eexists; split; [right; left; reflexivity|] |eexists; split; [left; reflexivity|]
        |eexists; split; [right; left; reflexivity|] |eexists; split; [left; reflexivity|]];
        (apply Forall_cons; [|apply Forall_nil]); unfold holds; cbn [asign apoly fst]; rewrite ?peval_neg, ?SK, ?TJ; nra.
Qed.
Lemma steadily_compared_spec r x y ps qs :
  spec e ps (near_value false off e l i x) -> spec e qs (near_value false off e l i y) ->
  spec e (steadily_compared (mentions i x || mentions i y) r ps qs) (guard_value r x y).
Proof.
  intros P Q.
  assert (T : forall p q, near_value false off e l i x (Some p) -> near_value false off e l i y (Some q) ->
    spec e ((if mentions i x || mentions i y then steadily r else compare r) p q) (guard_value r x y)).
  { intros p q V W. destruct (mentions i x || mentions i y) eqn:M; [apply steadily_spec; trivial|].
    apply orb_false_iff in M as [Mx My]. pose proof V as [C1 [_ [S1 _]]]. pose proof W as [C2 [_ [S2 _]]].
    eapply spec_weaken; [apply (compare_spec e r _ _ _ _ S1 S2)|].
    assert (GC : guard_conds x y) by (split; [trivial|split; [trivial|rewrite Mx, My; discriminate]]).
    intros [[|]|]; cbn [guard_value stays]; [| |tauto]; intro H; (split; [trivial|split; [trivial|]]);
      apply locally_all; intro z; unfold at_; rewrite !mentions_not by trivial; trivial. }
  unfold steadily_compared. unfold guard_value in *; unfold guard_conds in *.
  destruct r; (eapply spec_both; [eassumption|eassumption| | |]; unfold near_value at 1; try tauto;
    intros; try (unfold near_value in *; tauto); apply T; trivial).
Qed.

Lemma near_spec s a : spec e (near_regions s off i a) (near_value s off e l i a).
Proof.
  assert (Nz : forall x : frac, forall u, stands e u x -> peval e (fst x) <> 0 <-> u <> 0).
  { intros x u [D N]. rewrite <- N. split; intros H Z0; apply H; [rewrite Z0; ring|].
    apply Rmult_integral in Z0 as [Z0|Z0]; tauto. }
  revert s. induction a; intro s; cbn [near_regions].
  - apply spec_everywhere. split; [exact I|split; [|split; [apply stands_num|]]].
    + apply continuous_steady with (num n d); trivial.
    + intros _. apply locally_all. intro. apply stands_num.
  - apply spec_everywhere. cbn [near_value near_conds ev]. split; [exact I|split; [|split]].
    + destruct (Nat.eq_dec i0 i) as [->|N].
      * apply continuous_near with (fun x => x).
        -- apply locally_all. intro. rewrite upd_same; trivial.
        -- apply derivable_continuous_pt, derivable_pt_id.
      * apply continuous_steady with (nth i0 l 0). intro. apply upd_other; trivial.
    + rewrite <- AG. apply stands_var.
    + intros _. apply locally_all. intro x. change (upd i x l) with (at_ x). rewrite <- (move_agrees x i0). apply stands_var.
  - apply spec_near_one with a; auto. intros x [C [K [S G]]]. apply spec_everywhere.
    cbn [near_value near_conds ev]. split; [trivial|split; [|split]].
    + apply (continuity_pt_opp (fun x => ev (upd i x l) a)); trivial.
    + apply stands_neg; trivial.
    + intro H. generalize (G H). apply locally_weaken. intro. apply stands_neg.
  - apply spec_near with a1 a2; auto; cbn [near_conds]; [rewrite conj_app; auto|].
    intros x y [C [K [S G]]] [C' [K' [S' G']]]. apply spec_everywhere. cbn [near_value near_conds ev]. rewrite conj_app.
    split; [auto|split; [|split]].
    + apply (continuity_pt_plus (fun x => ev (upd i x l) a1) (fun x => ev (upd i x l) a2)); trivial.
    + apply stands_add; trivial.
    + intro H. generalize (G H) (G' H). apply locally_and. intros z. apply stands_add.
  - apply spec_near with a1 a2; auto; cbn [near_conds]; [rewrite conj_app; auto|].
    intros x y [C [K [S G]]] [C' [K' [S' G']]]. apply spec_everywhere. cbn [near_value near_conds ev]. rewrite conj_app.
    split; [auto|split; [|split]].
    + apply (continuity_pt_minus (fun x => ev (upd i x l) a1) (fun x => ev (upd i x l) a2)); trivial.
    + apply stands_sub; trivial.
    + intro H. generalize (G H) (G' H). apply locally_and. intros z. apply stands_sub.
  - apply spec_near with a1 a2; auto; cbn [near_conds]; [rewrite conj_app; auto|].
    intros x y [C [K [S G]]] [C' [K' [S' G']]]. apply spec_everywhere. cbn [near_value near_conds ev]. rewrite conj_app.
    split; [auto|split; [|split]].
    + apply (continuity_pt_mult (fun x => ev (upd i x l) a1) (fun x => ev (upd i x l) a2)); trivial.
    + apply stands_mul; trivial.
    + intro H. generalize (G H) (G' H). apply locally_and. intros z. apply stands_mul.
  - apply spec_near with a1 a2; auto; cbn [near_conds]; [rewrite !conj_app; tauto|].
    intros x y [C [K [S G]]] [C' [K' [S' G']]]. pose proof (Nz _ _ S') as Z0.
    apply spec_either; unfold holds; cbn [asign apoly]; rewrite Z0; intro V.
    + cbn [near_value near_conds ev]. rewrite !conj_app, divides_spec.
      split; [auto|split; [|split]].
      * apply (continuity_pt_div (fun x => ev (upd i x l) a1) (fun x => ev (upd i x l) a2)); trivial.
        rewrite here. trivial.
      * apply stands_div; trivial.
      * intro H. assert (Lz : locally a0 (fun z => ev (at_ z) a2 <> 0)).
        { apply (continuous_nonzero (fun z => ev (at_ z) a2)); trivial. rewrite here; trivial. }
        generalize (locally_and _ _ _ _ (fun z A1 A2 => Logic.conj A1 A2) (G H) (G' H)) Lz. apply locally_and.
        intros z [A1 A2] A3. apply stands_div; trivial.
    + cbn [near_value near_conds]. rewrite !conj_app, divides_spec. tauto.
  - apply spec_near_one with a; auto. intros x [C [K [S G]]]. apply spec_everywhere.
    cbn [near_value near_conds ev]. split; [trivial|split; [|split]].
    + apply (continuous_pow (fun x => ev (upd i x l) a)); trivial.
    + apply stands_pow; trivial.
    + intro H. generalize (G H). apply locally_weaken. intro. apply stands_pow.
  - destruct s; [apply spec_everywhere; simpl; tauto|].
    apply spec_near_one with a; auto. intros x [C [K [S G]]].
    pose proof (stands_sign _ _ _ S) as [k [Kp SK]]. destruct (pos_mult k (ev l a) Kp) as [_ P].
    apply spec_either; unfold holds; cbn [asign apoly]; rewrite SK, P; intro Q0; cbn [near_value near_conds ev];
      (split; [trivial|split; [apply (continuous_abs (fun x => ev (upd i x l) a)); trivial|split; [|discriminate]]]).
    + rewrite Rabs_pos_eq; trivial.
    + rewrite Rabs_left by lra. apply stands_neg; trivial.
  - destruct s; [apply spec_everywhere; simpl; tauto|].
    apply spec_near with a1 a2; auto; cbn [near_conds]; [rewrite conj_app; auto|].
    intros x y [C [K [S G]]] [C' [K' [S' G']]].
    pose proof (stands_sign _ _ _ (stands_sub _ _ _ _ _ S' S)) as [k [Kp SK]].
    destruct (pos_mult k (ev l a2 - ev l a1) Kp) as [_ P].
    apply spec_either; unfold holds; cbn [asign apoly]; rewrite SK, P; intro Q0; cbn [near_value near_conds ev]; rewrite conj_app;
      (split; [auto|split; [apply (continuous_min (fun x => ev (upd i x l) a1) (fun x => ev (upd i x l) a2)); trivial|split; [|discriminate]]]).
    + rewrite Rmin_left by lra; trivial.
    + rewrite Rmin_right by lra; trivial.
  - destruct s; [apply spec_everywhere; simpl; tauto|].
    apply spec_near with a1 a2; auto; cbn [near_conds]; [rewrite conj_app; auto|].
    intros x y [C [K [S G]]] [C' [K' [S' G']]].
    pose proof (stands_sign _ _ _ (stands_sub _ _ _ _ _ S S')) as [k [Kp SK]].
    destruct (pos_mult k (ev l a1 - ev l a2) Kp) as [_ P].
    apply spec_either; unfold holds; cbn [asign apoly]; rewrite SK, P; intro Q0; cbn [near_value near_conds ev]; rewrite conj_app;
      (split; [auto|split; [apply (continuous_max (fun x => ev (upd i x l) a1) (fun x => ev (upd i x l) a2)); trivial|split; [|discriminate]]]).
    + rewrite Rmax_left by lra; trivial.
    + rewrite Rmax_right by lra; trivial.
  - apply spec_everywhere. simpl; tauto.
  - assert (Cs : conj (near_conds s i l (If a1 r a2 a3 a4)) <-> guard_conds a1 a2 /\
      (related r (ev l a1) (ev l a2) -> conj (near_conds s i l a3)) /\
      (~ related r (ev l a1) (ev l a2) -> conj (near_conds s i l a4))).
    { cbn [near_conds]. unfold guard_conds. rewrite !conj_app, !conj_branch.
      destruct (mentions i a1 || mentions i a2); simpl; intuition discriminate. }
    apply spec_each with (guard_value r a1 a2).
    + apply steadily_compared_spec; auto.
    + unfold guard_value, near_value. rewrite Cs. tauto.
    + intros t [GC T].
      assert (Ch : forall b, (if t then b = a3 else b = a4) ->
        ev l (If a1 r a2 a3 a4) = ev l b /\ locally a0 (fun z => ev (at_ z) b = ev (at_ z) (If a1 r a2 a3 a4)) /\
        (conj (near_conds s i l (If a1 r a2 a3 a4)) <-> conj (near_conds s i l b))).
      { unfold stays in T. intros b E. rewrite Cs. cbn [ev]. destruct t; subst b; destruct T as [T0 T1];
          (split; [apply choose_spec; trivial|split; [|tauto]]); revert T1; apply locally_weaken; intros z T1;
          symmetry; apply choose_spec; trivial. }
      assert (Go : forall b, (if t then b = a3 else b = a4) -> spec e (near_regions s off i b) (near_value s off e l i b) ->
        spec e (near_regions s off i b) (near_value s off e l i (If a1 r a2 a3 a4))).
      { intros b E Sb. destruct (Ch b E) as [E0 [E1 E2]]. eapply spec_weaken; [exact Sb|].
        intros [q|]; unfold near_value; rewrite E2; [|tauto]. rewrite E0. intros [C [K [S G]]].
        split; [trivial|split; [|split; [trivial|]]].
        - apply (continuous_near _ _ _ E1 K).
        - intro H. generalize E1 (G H). apply locally_and. intros z E3 S3. unfold at_ in E3. rewrite <- E3. exact S3. }
      destruct t; apply Go; trivial; auto.
  - apply spec_everywhere. simpl; tauto.
  - apply spec_everywhere. simpl; tauto.
Qed.
End Near.
