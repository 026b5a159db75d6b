(** ** The rules are sound *)

(** A claim at a point of the domain. *)
Lemma point_sound p pf :
  refute (Some (passing_of g used)) depth (point_formulas g) (range_atoms (offset g) (ranges (body g))) pf = true ->
  in_domain g Ds l p ->
  arrow (if always_when g then [] else flat (l p) (conditions (body g))) (concludes (l p) (claim (body g))).
Proof.
  intros C I0. destruct wf as [Si [_ [_ [RR [RP [RC [RL _]]]]]]]. rewrite arrow_imp. intro CW.
  pose proof (agrees_point g (l p)) as AG. set (e := at_point g (l p)) in *.
  destruct (failure_spec (offset g) e (l p) (claim (body g)) AG (RL p)) as [Fa [|N]]; trivial.
  exfalso. apply (refute_sound (Some (passing_of g used)) depth _ _ pf e (germs_there p) C).
  - apply ranges_hold with (l p); trivial.
    + specialize (RR p). apply Forall_app in RR. apply RR.
    + unfold all_ranges in Si. rewrite forallb_app in Si. split_bools. trivial.
    + unfold in_domain, domain in I0. apply Forall_app in I0 as [I0 _]. apply (proj1 (Forall_props _ _)) in I0.
      pose proof (ranges_there p I0) as Q. apply Forall_app in Q. apply Q.
  - unfold point_formulas. apply Forall_app; split; [|apply Forall_app; split; [|apply Forall_app; split; [|apply Fa; trivial]]].
    + apply formulas_hold with (l p); [exact AG|apply RP|]. apply Forall_forall. intros h I1.
      apply filter_In in I1 as [I1 _]. apply along_holds; trivial.
    + apply values_hold with p; trivial. intros; eapply at_values; eassumption.
    + apply Forall_cons; [|apply Forall_nil]. apply (where_all_spec (offset g) e (l p)); [exact AG|apply RC|].
      destruct (always_when g) eqn:AW; [apply constantly_parts; trivial|trivial].
Qed.

(** A limit from one side. *)
Lemma lower_eval e n q : divisible n q = true -> peval e q = e 0%nat ^ n * peval e (lower n q).
Proof.
  assert (Tr : forall m i, meval e i (trim m) = meval e i m).
  { induction m as [|k m IH]; intro i; simpl; trivial. specialize (IH (S i)).
    destruct k, (trim m); simpl in *; rewrite <- ?IH; trivial; ring. }
  induction q as [|[m c] q IH]; cbn [divisible forallb lower map peval fst snd]; intro D; [ring|].
  apply andb_true_iff in D as [D Dq]. rewrite (IH Dq), Tr. unfold lower. destruct m as [|k m].
  - apply Nat.eqb_eq in D; subst. simpl. ring.
  - apply Nat.leb_le in D. simpl meval. replace (e 0%nat ^ k) with (e 0%nat ^ n * e 0%nat ^ (k - n)).
    + ring.
    + rewrite <- pow_add. replace (n + (k - n))%nat with k; [trivial|].
      rewrite Nat.add_comm. symmetry. apply Nat.sub_add. trivial.
Qed.
Lemma small_near f c eps : germ_limit f c -> 0 < eps -> small (fun t => Rabs (f t - c) < eps).
Proof. rewrite germ_limit_alt. intros G E. apply G; trivial. Qed.
Lemma polynomial_tends p s d q :
  germ (passing_of g used) (at_point g (l p)) s (known_limits g s) (germ_formulas g s) d (on_germ g l s) ->
  mentions_only (0%nat :: constants (passing_of g used) ++ known_limits g s) q = true ->
  germ_limit (fun t => peval (on_germ g l s t) q) (peval (at_point g (l p)) (at0 q)).
Proof.
  intros Ge M. rewrite at0_eval. apply germ_limit_poly with (1 := M). intros k [<-|Ik].
  - cbn [at_zero]. apply germ_limit_near with (fun t => t) d; [apply Ge| |apply lim_x]. trivial.
  - replace (at_zero (at_point g (l p)) k) with (at_point g (l p) k).
    + eapply germ_known; eassumption.
    + destruct k; trivial.
Qed.
Lemma quotient_tends (f den num : R -> R) d0 n0 : germ_limit den d0 -> germ_limit num n0 -> d0 <> 0 ->
  small (fun t => den t * f t = num t) -> germ_limit f (n0 / d0).
Proof.
  intros D N Z S.
  destruct (small_and _ _ S (small_near den d0 (Rabs d0) D (Rabs_pos_lt _ Z))) as [c [C F]].
  apply germ_limit_near with (fun t => num t * / den t) c; trivial.
  - intros t T. destruct (F t T) as [E A0].
    assert (den t <> 0) by (intro Q; rewrite Q, Rminus_0_l, Rabs_Ropp in A0; lra).
    rewrite <- E. field; trivial.
  - unfold Rdiv. apply limit_mul; trivial. apply limit_inv; trivial.
Qed.
Lemma pow_below t n : 0 < t < 1 -> 0 < t ^ S n <= t.
Proof.
  intro T. induction n as [|n IH]; [simpl; lra|]. change (t ^ S (S n)) with (t * t ^ S n). nra.
Qed.
Lemma quotient_diverges (f q num : R -> R) q0 n0 n : germ_limit q q0 -> germ_limit num n0 -> 0 < n0 * q0 ->
  small (fun t => t ^ S n * q t * f t = num t) -> forall b, small (fun t => f t > b).
Proof.
  intros Q N P Sm b.
  assert (Z : q0 <> 0) by (intro E; rewrite E in P; lra).
  assert (R0 : 0 < n0 / q0).
  { replace (n0 / q0) with (n0 * q0 * / (q0 * q0)) by (field; trivial).
    apply Rmult_lt_0_compat; trivial. apply Rinv_0_lt_compat. destruct (Rdichotomy _ _ Z); nra. }
  assert (L : germ_limit (fun t => t ^ S n * f t) (n0 / q0)).
  { apply (quotient_tends _ q num q0 n0); trivial. apply (small_weaken _ _ Sm). intros t _ E. rewrite <- E. ring. }
  destruct (small_near _ _ (n0 / q0 / 2) L ltac:(lra)) as [c [C F]].
  set (r := n0 / q0) in *. assert (B : 0 < Rabs b + 1) by (pose proof (Rabs_pos b); lra).
  exists (Rmin c (Rmin 1 (r / 2 / (Rabs b + 1)))).
  assert (0 < r / 2 / (Rabs b + 1)) by (apply Rdiv_lt_0_compat; lra).
  split; [repeat apply Rmin_glb_lt; lra|]. intros t [T U].
  pose proof (Rmin_l c (Rmin 1 (r / 2 / (Rabs b + 1)))). pose proof (Rmin_r c (Rmin 1 (r / 2 / (Rabs b + 1)))).
  pose proof (Rmin_l 1 (r / 2 / (Rabs b + 1))). pose proof (Rmin_r 1 (r / 2 / (Rabs b + 1))).
  specialize (F t ltac:(lra)). apply Rabs_def2 in F as [_ F].
  pose proof (pow_below t n ltac:(lra)) as [P1 P2]. set (w := t ^ S n) in *.
  assert (V : t * (Rabs b + 1) < r / 2).
  { replace (r / 2) with (r / 2 / (Rabs b + 1) * (Rabs b + 1)) by (field; lra). apply Rmult_lt_compat_r; lra. }
  pose proof (Rle_abs b).
  assert (w * (Rabs b + 1) <= t * (Rabs b + 1)) by (apply Rmult_le_compat_r; lra).
  assert (w * (Rabs b + 1) < w * f t) by lra.
  assert (Rabs b + 1 < f t) by (apply Rmult_lt_reg_l with w; trivial). lra.
Qed.
Lemma nonzero_near f c : germ_limit f c -> c <> 0 -> small (fun t => f t <> 0).
Proof.
  intros G N. apply (small_weaken _ _ (small_near f c (Rabs c) G (Rabs_pos_lt _ N))). intros t _ A0 Q.
  rewrite Q, Rminus_0_l, Rabs_Ropp in A0. lra.
Qed.
Definition on_its_side (k : sense) (y q : R) : Prop :=
  match k with Same => y = q | AtLeast => q <= y | AtMost => y <= q end.
Lemma relates_quotient k d y n : d <> 0 -> relates k d y n -> on_its_side k y (n / d).
Proof.
  intros D K. assert (P : 0 < d * d) by (destruct (Rdichotomy _ _ D); nra).
  assert (E : d * d * (n / d) = d * n) by (field; trivial).
  destruct k; cbn [relates on_its_side] in *.
  - rewrite <- K. field; trivial.
  - apply Rmult_le_reg_l with (d * d); trivial. rewrite E. lra.
  - apply Rmult_le_reg_l with (d * d); trivial. rewrite E. lra.
Qed.
Definition ends_at (q : R -> R) (v : list R) (to : target) : Prop :=
  match to with
  | Finite y => germ_limit q (ev v y)
  | PlusInf => forall b, small (fun t => q t > b)
  | MinusInf => forall b, small (fun t => q t < b)
  end.
(** A quotient to which a function compares close to the limit, and which tends there. *)
Lemma bound_sound f to s c : bounds g used f to s c = true ->
  match to with Finite v => total (l 0) v | _ => True end /\
  exists q, ends_at q (l 0) to /\
    small (fun t => total (l (germ_point s t)) f /\ on_its_side (compares c) (ev (l (germ_point s t)) f) (q t)).
Proof.
  unfold bounds. intro C. cbv zeta in C. split_bools.
  match goal with G : has_side s used = true |- _ => rename G into Hs; apply has_side_in in Hs end.
  match goal with G : match to with Finite _ => _ | _ => _ end = true |- _ => rename G into Ho end.
  match goal with G : rootless f = true |- _ => rename G into Rf end.
  match goal with G : divisible _ _ = true |- _ => rename G into Di end.
  match goal with G : refute _ _ (_ ++ [misses _ _ _ _ _]) _ _ = true |- _ => rename G into Ce end.
  match goal with G : refute _ _ (_ ++ [differs _ _ _ _ _]) _ _ = true |- _ => rename G into Ci end.
  match goal with G : refute _ _ leaving _ _ = true |- _ => rename G into Cw end.
  match goal with G : refute _ _ _ _ (radius_positive c) = true |- _ => rename G into Cp end.
  match goal with G : mentions_only _ (limit_num c) = true |- _ => rename G into Mn end.
  match goal with G : mentions_only _ (lower _ _) = true |- _ => rename G into Md end.
  match goal with G : mentions_only _ (radius_num c) = true |- _ => rename G into Mrn end.
  match goal with G : mentions_only _ (radius_den c) = true |- _ => rename G into Mrd end.
  pose proof (germs_there 0) as GS. pose proof (known_here 0) as K0. pose proof (ranges_here 0) as R0.
  destruct (germ_there 0 s Hs) as [d Ge].
  pose proof (agrees_point g (l 0)) as AG.
  pose proof (polynomial_tends 0 s d _ Ge Mn) as Ln. pose proof (polynomial_tends 0 s d _ Ge Md) as Ld.
  set (env := at_point g (l 0)) in *. set (pc := passing_of g used) in *.
  set (st := range_atoms (offset g) (constant_ranges g)) in *.
  assert (PP : 0 < peval env (radius_num c) /\ 0 < peval env (radius_den c)).
  { destruct (Rlt_dec 0 (peval env (radius_num c))) as [N0|N0];
      [destruct (Rlt_dec 0 (peval env (radius_den c))) as [D0|D0]; [tauto|]|];
      exfalso; apply (refute_sound (Some pc) depth _ _ _ env GS Cp R0); apply Forall_app; split; trivial;
      (apply Forall_cons; [|apply Forall_nil]).
    - exists [anot (A (radius_den c) SP)]. split; [right; left; trivial|]. apply Forall_cons; [|apply Forall_nil]. apply anot_holds. exact D0.
    - exists [anot (A (radius_num c) SP)]. split; [left; trivial|]. apply Forall_cons; [|apply Forall_nil]. apply anot_holds. exact N0. }
  destruct PP as [Pn Pd].
  assert (HN : forall fs st p fuel env, refute None fuel fs st p = true -> all_hold env st -> some_cases env fs -> False).
  { intros. eapply (refute_sound None); [exact I|eassumption..]. }
  destruct (germ_inside pc env s _ _ d (on_germ g l s) _ _ st HN Ge R0 Mrn Mrd Pn Pd depth _ Cw) as [d' [D' [_ Gi]]].
  assert (Id : small (fun t => total (l (germ_point s t)) f /\
    relates (compares c) (peval (on_germ g l s t) (limit_den c)) (ev (l (germ_point s t)) f)
      (peval (on_germ g l s t) (limit_num c)))).
  { exists d'. split; trivial. intros t T. destruct (Gi t T) as [G1 G2].
    apply (differs_not (offset g) (on_germ g l s t) (l (germ_point s t))); [apply agrees_germ|trivial|].
    intro Wr. apply (HN _ _ _ _ _ Ci G1). apply Forall_app; split; trivial. apply Forall_cons; [trivial|apply Forall_nil]. }
  assert (Ms : ~ some_case env (misses (offset g) (at0 (limit_num c)) (at0 (lower (order c) (limit_den c))) (order c) to)).
  { intro Wr. apply (refute_sound (Some pc) depth _ _ _ env GS Ce R0). apply Forall_app; split; trivial.
    apply Forall_cons; [trivial|apply Forall_nil]. }
  set (q := lower (order c) (limit_den c)) in *.
  set (Q := fun t => peval (on_germ g l s t) (limit_num c) / peval (on_germ g l s t) (limit_den c)).
  assert (Nz : peval env (at0 q) <> 0 -> small (fun t => peval (on_germ g l s t) (limit_den c) <> 0)).
  { intro N0. apply (small_weaken _ _ (nonzero_near _ _ Ld N0)). intros t T N1. rewrite (lower_eval _ _ _ Di).
    apply Rmult_integral_contrapositive_currified; trivial. apply pow_nonzero.
    change (on_germ g l s t 0%nat) with t. lra. }
  assert (Il : peval env (at0 q) <> 0 ->
    small (fun t => t ^ order c * peval (on_germ g l s t) q * Q t = peval (on_germ g l s t) (limit_num c))).
  { intro N0. apply (small_weaken _ _ (Nz N0)). intros t _ N1.
    change (t ^ order c) with (on_germ g l s t 0%nat ^ order c). unfold q. rewrite <- (lower_eval _ _ _ Di).
    unfold Q. field. trivial. }
  assert (Qs : peval env (at0 q) <> 0 -> small (fun t => total (l (germ_point s t)) f /\
    on_its_side (compares c) (ev (l (germ_point s t)) f) (Q t))).
  { intro N0. apply (small_weaken _ _ (small_and _ _ Id (Nz N0))). intros t _ [[T0 K] N1].
    split; [trivial|apply relates_quotient; trivial]. }
  assert (Sg : forall p : poly, ~ some_case env [[anot (A p SP)]] -> 0 < peval env p).
  { intros p N. destruct (holds_dec env (A p SP)) as [Y|Y]; [exact Y|]. exfalso. apply N.
    exists [anot (A p SP)]. split; [left; trivial|]. apply Forall_cons; [apply anot_holds; trivial|apply Forall_nil]. }
  destruct to as [v| |]; cbn [misses] in Ms.
  - apply andb_true_iff in Ho as [Ho Rv]. apply Nat.eqb_eq in Ho.
    assert (M1 : ~ some_case env (differs (offset g) v (at0 (limit_num c)) (at0 q) Same)).
    { intros [a [Ia Ha]]. apply Ms. exists a. split; trivial. apply in_app_iff; auto. }
    assert (M2 : peval env (at0 q) <> 0).
    { intro Z0. apply Ms. exists [A (at0 q) SZ]. split; [apply in_app_iff; right; left; trivial|].
      apply Forall_cons; [exact Z0|apply Forall_nil]. }
    destruct (differs_not _ _ _ _ _ _ _ AG Rv M1) as [Tv Ev_]. cbn [relates] in Ev_. split; trivial.
    exists Q. split; [|apply Qs; trivial]. cbn [ends_at].
    replace (ev (l 0) v) with (peval env (at0 (limit_num c)) / peval env (at0 q)) by (rewrite <- Ev_; field; trivial).
    apply quotient_tends with (1 := Ld) (2 := Ln) (3 := M2). apply (small_weaken _ _ (Il M2)).
    intros t _ E. rewrite <- E, Ho. simpl. ring.
  - split; trivial. apply Nat.ltb_lt in Ho. destruct (order c) as [|n] eqn:On; [inversion Ho|].
    apply Sg in Ms. rewrite peval_mul in Ms.
    assert (N0 : peval env (at0 q) <> 0) by (intro E; rewrite E in Ms; lra).
    exists Q. split; [|apply Qs; trivial]. exact (quotient_diverges _ _ _ _ _ n Ld Ln Ms (Il N0)).
  - split; trivial. apply Nat.ltb_lt in Ho. destruct (order c) as [|n] eqn:On; [inversion Ho|].
    apply Sg in Ms. rewrite peval_neg, peval_mul in Ms.
    assert (N0 : peval env (at0 q) <> 0) by (intro E; rewrite E in Ms; lra).
    exists Q. split; [|apply Qs; trivial]. intro b.
    assert (Ln' : germ_limit (fun t => - peval (on_germ g l s t) (limit_num c)) (- peval env (at0 (limit_num c))))
      by (apply limit_Ropp; trivial).
    assert (Ms' : 0 < - peval env (at0 (limit_num c)) * peval env (at0 q)) by lra.
    assert (Il' : small (fun t => t ^ S n * peval (on_germ g l s t) q * - Q t =
      - peval (on_germ g l s t) (limit_num c))).
    { apply (small_weaken _ _ (Il N0)). intros t _ E. rewrite <- E. ring. }
    apply (small_weaken _ _ (quotient_diverges _ _ _ _ _ n Ld Ln' Ms' Il' (- b))). intros t _ K. lra.
Qed.
Lemma side_sound f to s c : shows g used f to s c = true ->
  match to with Finite v => total (l 0) v | _ => True end /\ reaches l (l 0) f to s.
Proof.
  destruct c as [b|b c]; cbn [shows]; intro C; split_bools.
  - match goal with G : bounds _ _ _ _ _ b = true |- _ => destruct (bound_sound f to s b G) as [T0 [q [Q S]]] end.
    split; trivial. match goal with G : match compares b with _ => _ end = true |- _ => revert G S end.
    destruct to as [v| |]; cbn [reaches ends_at] in *; destruct (compares b); try discriminate;
      cbn [on_its_side]; intros _ S; [intros eps E|intro y..]; apply near_small.
    1: apply (small_weaken _ _ (small_and _ _ S (small_near _ _ eps Q E))).
    2-5: apply (small_weaken _ _ (small_and _ _ S (Q y))).
    all: intros t _ [[T1 K] D]; apply conj_app; split; [exact T1|]; apply conj_one; try lra. rewrite K. exact D.
  - match goal with G : bounds _ _ _ _ _ b = true |- _ => destruct (bound_sound f to s b G) as [T0 [p [P S]]] end.
    match goal with G : bounds _ _ _ _ _ c = true |- _ => destruct (bound_sound f to s c G) as [_ [q [Q U]]] end.
    split; trivial. match goal with G : match compares b with _ => _ end = true |- _ => revert G S U end.
    destruct (compares b); try discriminate. destruct (compares c); try discriminate.
    destruct to as [v| |]; try discriminate. cbn [reaches ends_at on_its_side] in *. intros _ S U eps E. apply near_small.
    apply (small_weaken _ _ (small_and _ _ (small_and _ _ S U)
      (small_and _ _ (small_near _ _ eps P E) (small_near _ _ eps Q E)))).
    intros t _ [[[T1 K] [_ M]] [D F]]. apply conj_app. split; [exact T1|]. apply conj_one.
    apply Rabs_def2 in D. apply Rabs_def2 in F. apply Rabs_def1; lra.
Qed.
End Sound.

(** The list of values has the limit variable where it should be, and constants do not vary. *)
Inductive steady (g : family) (l : R -> list R) : Prop := Steady :
  (forall p, nth (variable g) (l p) 0 = p) ->
  (forall p q, map (fun i => nth i (l p) 0) (fixed g) = map (fun i => nth i (l q) 0) (fixed g)) ->
  (forall p, constantly g l p = constantly g l 0) -> steady g l.
(** A set of values of the variable on which nothing is known but what is supposed. *)
Definition on_set (D : list (R -> Prop)) (used : list side) : setting := Setting D used true.
Lemma reached_small D used s : Forall (fun P : Prop => P) (reached D used) -> In s used ->
  small (fun t => Forall (fun d : R -> Prop => d (germ_point s t)) D).
Proof.
  destruct D as [|d D]; cbn [reached]; intros F I0.
  - exists 1. split; [lra|]. intros. constructor.
  - apply (proj1 (Forall_props _ _)) in F. rewrite Forall_forall in F. specialize (F s I0). apply near_small in F.
    apply (small_weaken _ _ F). intros t _ C. rewrite conj_all, Forall_map in C. exact C.
Qed.
Lemma steady_supposed g D used l : steady g l -> Forall (fun P : Prop => P) (given_all g (on_set D used) l) ->
  supposed g D used l.
Proof.
  intros [V F C] H. unfold given_all in H. apply Forall_app in H as [H1 H]. apply Forall_app in H as [H2 H3]. split; trivial.
  - intro p. rewrite C. trivial.
  - intros s I0. apply reached_small with (1 := H2); trivial.
  - intros p q i I0. specialize (F p q). revert F I0. induction (fixed g) as [|j js IH]; simpl; [intros _ []|].
    intros E [->|I0]; inversion E; auto.
Qed.
(** A limit that is proved from its sides is the limit. *)
Theorem limit_proved g used f to cs D l : proves_limit g used f to cs = true -> negb (Nat.eqb (length cs) 0) = true ->
  steady g l -> states_limit g (on_set D used) l f to (map fst cs).
Proof.
  unfold proves_limit, states_limit. intros C N S. apply andb_true_iff in C as [W C]. rewrite imply_all. intro H.
  pose proof (steady_supposed g D used l S H) as Su. rewrite forallb_forall in C. unfold tends.
  assert (A0 : forall c, In c cs -> match to with Finite v => total (l 0) v | _ => True end /\ reaches l (l 0) f to (fst c)).
  { intros c I0. apply (side_sound g D used l W Su f to (fst c) (snd c)). auto. }
  apply conj_app. split.
  - destruct cs as [|c cs]; [discriminate|]. destruct (A0 c (or_introl eq_refl)) as [T _]. destruct to; simpl; trivial.
  - apply conj_all. rewrite Forall_map, Forall_map, Forall_forall. intros c I0. apply A0. trivial.
Qed.
Theorem point_proved g used p D l : proves_point g used p = true -> steady g l -> states_point g (on_set D used) l.
Proof.
  unfold proves_point, states_point. intros C S. apply andb_true_iff in C as [W C]. rewrite imply_all. intro H.
  pose proof (steady_supposed g D used l S H) as Su. intro x. rewrite imply_all. intro I0.
  apply (point_sound g D used l W Su x p C I0).
Qed.
