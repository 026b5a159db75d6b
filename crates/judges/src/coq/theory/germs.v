(** ** Limits of polynomials along a germ *)

Definition germ_limit (f : R -> R) (l : R) : Prop := limit1_in f (fun t => 0 < t) l 0.
Lemma germ_limit_alt f l : germ_limit f l <->
  (forall eps, 0 < eps -> exists d, 0 < d /\ forall t, 0 < t < d -> Rabs (f t - l) < eps).
Proof.
  unfold germ_limit, limit1_in, limit_in, R_met, Base, dist, R_dist. split; intros H eps P.
  - destruct (H eps P) as [d [D E]]. exists d. split; trivial. intros t T.
    apply E. split; [tauto|]. rewrite Rminus_0_r, Rabs_pos_eq; lra.
  - destruct (H eps P) as [d [D E]]. exists d. split; trivial. intros t [T Q].
    apply E. rewrite Rminus_0_r, Rabs_pos_eq in Q; lra.
Qed.
Lemma germ_limit_near f g l d : 0 < d -> (forall t, 0 < t < d -> f t = g t) -> germ_limit f l -> germ_limit g l.
Proof.
  rewrite !germ_limit_alt. intros D E H eps P. destruct (H eps P) as [c [C F]]. exists (Rmin c d).
  split; [apply Rmin_glb_lt; trivial|]. intros t [T U].
  pose proof (Rmin_l c d). pose proof (Rmin_r c d). rewrite <- E by lra. apply F; lra.
Qed.
Lemma germ_limit_const c : germ_limit (fun _ => c) c.
Proof. rewrite germ_limit_alt. intros eps P. exists 1. split; [lra|]. intros. rewrite Rminus_diag_eq, Rabs_R0; trivial. Qed.
Lemma germ_limit_pow f l n : germ_limit f l -> germ_limit (fun t => f t ^ n) (l ^ n).
Proof.
  intro H. induction n; simpl; [apply germ_limit_const|]. apply limit_mul; trivial.
Qed.
Lemma germ_limit_mono (e : R -> nat -> R) l ks m : forall i, only_in ks i m = true ->
  (forall k, In k ks -> germ_limit (fun t => e t k) (l k)) ->
  germ_limit (fun t => meval (e t) i m) (meval l i m).
Proof.
  induction m as [|n m IH]; simpl; intros i O E; [apply germ_limit_const|].
  apply andb_true_iff in O as [O P]. apply limit_mul; [|apply IH; trivial].
  apply orb_true_iff in O as [O|O].
  - apply Nat.eqb_eq in O; subst. apply (germ_limit_const 1).
  - apply existsb_exists in O as [k [K Q]]. apply Nat.eqb_eq in Q; subst. apply germ_limit_pow; auto.
Qed.
Lemma germ_limit_poly (e : R -> nat -> R) l ks p : mentions_only ks p = true ->
  (forall k, In k ks -> germ_limit (fun t => e t k) (l k)) ->
  germ_limit (fun t => peval (e t) p) (peval l p).
Proof.
  induction p as [|[m c] p IH]; cbn [mentions_only forallb peval fst]; intros M E; [apply germ_limit_const|].
  apply andb_true_iff in M as [M N]. apply limit_plus; [|apply IH; trivial].
  apply limit_mul; [apply germ_limit_const|apply germ_limit_mono with ks; trivial].
Qed.
Lemma germ_limit_nonneg f l d : germ_limit f l -> 0 < d -> (forall t, 0 < t < d -> 0 <= f t) -> 0 <= l.
Proof.
  rewrite germ_limit_alt. intros H D F. destruct (Rle_dec 0 l) as [|N]; trivial. exfalso.
  destruct (H (- l) ltac:(lra)) as [c [C G]]. set (t := Rmin c d / 2).
  assert (0 < Rmin c d) by (apply Rmin_glb_lt; trivial).
  pose proof (Rmin_l c d). pose proof (Rmin_r c d).
  specialize (G t ltac:(unfold t; lra)). specialize (F t ltac:(unfold t; lra)).
  rewrite Rabs_pos_eq in G; lra.
Qed.

(** Values at a point of a germ: t, the declared ranges, x = a ± t or ± 1/t, and the constants. *)
Definition on_side (pc : passing) (env : nat -> R) (s : side) (t : R) (e : nat -> R) : Prop :=
  e 0%nat = t /\ all_hold e (ranges_along pc) /\ holds e (binding (var pc) s) /\
  (forall k, In k (constants pc) -> e k = env k).
(** A germ on which, where it does not leave the domain, the premises hold, and what its variables
    tend to. *)
Definition germ (pc : passing) (env : nat -> R) (s : side) (zs : list nat) (fs : list cases)
  (d : R) (e : R -> nat -> R) : Prop :=
  0 < d /\
  (forall t, 0 < t < d -> on_side pc env s t (e t) /\
    ((exists e', on_side pc env s t e' /\ some_cases e' (leaves pc)) \/ some_cases (e t) fs)) /\
  (forall k, In k zs -> germ_limit (fun t => e t k) (env k)).
Definition germs (pc : option passing) (env : nat -> R) : Prop :=
  match pc with
  | None => True
  | Some pc => forall s zs fs, along_side pc s = Some (zs, fs) -> existsb (Nat.eqb 0) (constants pc ++ zs) = false
     /\ exists d e, germ pc env s zs fs d e
  end.

Lemma germ_known pc env s zs fs d e k : germ pc env s zs fs d e -> In k (constants pc ++ zs) ->
  germ_limit (fun t => e t k) (env k).
Proof.
  intros [D [E Z]] I. apply in_app_iff in I as [I|I]; auto.
  apply germ_limit_near with (fun _ => env k) d; trivial; [|apply germ_limit_const].
  intros t T. symmetry. apply E; trivial.
Qed.

(** The germ inside a radius that depends on constants. *)
Lemma germ_atoms_hold pc env s t e num den st : on_side pc env s t e -> all_hold env st ->
  mentions_only (constants pc) num = true -> mentions_only (constants pc) den = true ->
  0 < peval env den -> 0 < t < peval env num / peval env den -> all_hold e (germ_atoms pc s num den st).
Proof.
  intros [Et [Er [Eb Ec]]] H M N Q [T U]. unfold germ_atoms. apply Forall_app; split; trivial. apply Forall_app; split.
  - apply Forall_forall. intros a J. apply filter_In in J as [J K].
    pose proof (all_in env st a H J) as L. unfold holds in *.
    rewrite (mentions_eval e env (constants pc) (apoly a) K Ec). trivial.
  - repeat apply Forall_cons; trivial; unfold holds; cbn [asign apoly].
    + rewrite peval_var, Et. lra.
    + rewrite peval_sub, peval_mul, peval_var, Et.
      rewrite (mentions_eval e env _ _ M Ec), (mentions_eval e env _ _ N Ec).
      assert (t * peval env den < peval env num); [|lra].
      replace (peval env num) with (peval env num / peval env den * peval env den) by (field; lra).
      apply Rmult_lt_compat_r; lra.
Qed.
Lemma germ_inside pc env s zs fs d e num den st :
  (forall fs st p fuel env, refute None fuel fs st p = true -> all_hold env st -> some_cases env fs -> False) ->
  germ pc env s zs fs d e -> all_hold env st ->
  mentions_only (constants pc) num = true -> mentions_only (constants pc) den = true ->
  0 < peval env num -> 0 < peval env den ->
  forall fuel inside, refute None fuel (leaves pc) (germ_atoms pc s num den st) inside = true ->
  exists d', 0 < d' /\ d' <= d /\ forall t, 0 < t < d' ->
    all_hold (e t) (germ_atoms pc s num den st) /\ some_cases (e t) fs.
Proof.
  intros IH [D [E Z]] H M N P Q fuel inside I.
  exists (Rmin d (peval env num / peval env den)).
  split; [apply Rmin_glb_lt; trivial; apply Rdiv_lt_0_compat; trivial|].
  split; [apply Rmin_l|]. intros t [T U].
  pose proof (Rmin_l d (peval env num / peval env den)).
  pose proof (Rmin_r d (peval env num / peval env den)).
  assert (G : forall e', on_side pc env s t e' -> all_hold e' (germ_atoms pc s num den st)).
  { intros e' S. apply germ_atoms_hold with env t; trivial. lra. }
  destruct (E t ltac:(lra)) as [S [[e' [S' L]]|F]]; split; auto. exfalso. eapply IH; eauto.
Qed.

Theorem refute_sound pc : forall fuel fs st p env,
  germs pc env -> refute pc fuel fs st p = true -> all_hold env st -> some_cases env fs -> False.
Proof.
  assert (G : forall pc,
    (pc = None \/ forall fs st p fuel env, refute None fuel fs st p = true -> all_hold env st -> some_cases env fs -> False) ->
    forall fuel fs st p env, germs pc env -> refute pc fuel fs st p = true -> all_hold env st -> some_cases env fs -> False).
  2: { apply G. right. intros. eapply (G None); [left; trivial|exact I|eassumption..]. }
  clear pc. intros pc HN. induction fuel as [|fuel IH]; [discriminate|].
  intros fs st p env GS. destruct p as [|formula each_case|q each|equation var0 lead rest|terms cofactors
    |s num0 den positive inside a along rest]; cbn [refute]; intros C H F.
  - apply existsb_exists in C as [a [I D]]. destruct (decided a) as [[|]|] eqn:E; try discriminate.
    pose proof (all_in _ _ _ H I) as K. apply (decided_holds env) in E. rewrite E in K; discriminate.
  - assert (S : some_case env (nth formula fs [[]])).
    { destruct (nth_in_or_default formula fs [[]]) as [I| ->].
      - unfold some_cases in F. rewrite Forall_forall in F. auto.
      - exists []. split; [left; trivial|constructor]. }
    revert each_case C S. generalize (nth formula fs [[]]).
    induction c as [|c cs IHc]; intros ps C [a [I K]]; [destruct I|].
    destruct ps as [|p ps]; [discriminate|]. apply andb_true_iff in C as [C D].
    destruct I as [->|I].
    + apply (IH _ _ _ env GS C); trivial. apply Forall_app; split; trivial.
    + apply (IHc ps D). exists a; split; trivial.
  - apply andb_true_iff in C as [V C]. rewrite forallb_forall in V, C.
    assert (K : exists v, In v [-1; 0; 1]%Z /\
      ((v = -1)%Z /\ peval env q < 0 \/ v = 0%Z /\ peval env q = 0 \/ v = 1%Z /\ 0 < peval env q)).
    { destruct (Rtotal_order (peval env q) 0) as [L|[L|L]].
      - exists (-1)%Z. split; [left; trivial|tauto].
      - exists 0%Z. split; [right; left; trivial|tauto].
      - exists 1%Z. split; [right; right; left; trivial|]. right; right. split; trivial. }
    destruct K as [v [I K]]. specialize (V v I). unfold admitted in V.
    apply existsb_exists in V as [[[o s] p] [J M]]. cbn [fst snd] in M.
    apply (IH _ _ _ env GS (C _ J)); trivial. cbn [fst snd]. apply Forall_app; split; trivial.
    apply Forall_cons; [|apply Forall_nil]. apply sided_holds with v; trivial.
  - apply andb_true_iff in C as [C R]. apply andb_true_iff in C as [C L]. apply andb_true_iff in C as [S X].
    destruct (asign (nth_atom st equation)) eqn:Sg; try discriminate.
    apply peqb_eq in L.
    set (rule := if peqb _ _ then _ else _) in *. set (l := top var0 rule) in *.
    pose proof (nth_holds env st equation H) as K. unfold holds in K. rewrite Sg in K.
    assert (Z : peval env rule = 0).
    { unfold rule. destruct (peqb _ _); rewrite ?peval_neg, K; ring. }
    pose proof (product_nonzero env st lead H X) as PN.
    destruct (prim_eval env l) as [g [Gp Ge]]. destruct (prim_eval env (product st lead)) as [h [Hp He]].
    assert (LN : peval env l <> 0).
    { rewrite Ge, L. intro Q. apply Rmult_integral in Q as [Q|Q]; [lra|]. apply PN. rewrite He, Q; ring. }
    assert (LP : forallb (positive_factor st) lead = true -> 0 < peval env l).
    { intro Q. pose proof (product_positive env st lead H Q) as PP. rewrite Ge, L. rewrite He in PP.
      apply Rmult_lt_0_compat; trivial. apply Rmult_lt_reg_l with h; trivial. rewrite Rmult_0_r; trivial. }
    apply (IH _ _ _ env GS R); trivial. apply mapi_holds; trivial. intros i a Ha.
    destruct (Nat.eqb i equation); [|apply reduce_holds; trivial].
    destruct (Nat.eqb _ 1); trivial. reflexivity.
  - apply andb_true_iff in C as [C S]. apply andb_true_iff in C as [C X]. apply andb_true_iff in C as [T0 E0].
    set (w := fun t => IZR (weight t) * (peval env (square t) * peval env (square t) * peval env (product st (factors t)))).
    assert (W : forall t, In t terms -> 0 <= w t).
    { intros t I. rewrite forallb_forall in T0. specialize (T0 t I). apply andb_true_iff in T0 as [Wt Ft].
      unfold w. apply Rmult_le_pos; [apply IZR_le, Z.lt_le_incl, Z.ltb_lt; trivial|].
      apply Rmult_le_pos; [nra|]. apply product_nonnegative; trivial. }
    assert (W1 : exists t, In t terms /\ 0 < w t).
    { apply existsb_exists in X as [t [I X]]. apply andb_true_iff in X as [Pf Sq]. exists t; split; trivial.
      rewrite forallb_forall in T0. specialize (T0 t I). apply andb_true_iff in T0 as [Wt _].
      destruct (as_const (square t)) as [c|] eqn:Ec; [|discriminate]. apply (as_const_eval env) in Ec.
      unfold w. rewrite Ec. apply negb_true_iff, Z.eqb_neq in Sq. apply not_0_IZR in Sq.
      apply Rmult_lt_0_compat; [apply IZR_lt, Z.ltb_lt; trivial|].
      apply Rmult_lt_0_compat; [destruct (Rdichotomy _ _ Sq); nra|]. apply product_positive; trivial. }
    assert (Wp : forall ts s, 0 < s \/ (0 <= s /\ exists t, In t ts /\ 0 < w t) -> (forall t, In t ts -> 0 <= w t) ->
      0 < fold_left (fun s t => s + w t) ts s).
    { induction ts as [|t ts IHt]; simpl; intros s Hs Hw.
      - destruct Hs as [Hs|[_ [t [[] _]]]]; trivial.
      - apply IHt; [|auto]. pose proof (Hw t (or_introl eq_refl)).
        destruct Hs as [Hs|[Hs [u [[->|I] U]]]]; [left; lra|left; lra|]. right. split; [lra|eauto]. }
    assert (E1 : forall ts s, peval env (fold_left (fun s t => padd s
        (pscale (weight t) (pmul (pmul (square t) (square t)) (product st (factors t))))) ts s) =
      fold_left (fun s t => s + w t) ts (peval env s)).
    { induction ts as [|t ts IHt]; simpl; intros; trivial. rewrite IHt. f_equal.
      rewrite peval_add, peval_scale, !peval_mul. trivial. }
    assert (E2 : forall cs, forallb (fun c => match asign (nth_atom st (fst c)) with SZ => true | _ => false end) cs = true ->
      forall s, peval env (fold_left (fun s c => padd s (pmul (apoly (nth_atom st (fst c))) (snd c))) cs s) = peval env s).
    { induction cs as [|c cs IHc]; cbn [forallb fold_left]; intros B s; trivial.
      apply andb_true_iff in B as [B D]. rewrite IHc by trivial. rewrite peval_add, peval_mul.
      pose proof (nth_holds env st (fst c) H) as K. unfold holds in K.
      destruct (asign (nth_atom st (fst c))); try discriminate. rewrite K; ring. }
    match type of S with match ?s with _ => _ end = _ => destruct s eqn:Q; [|discriminate] end.
    assert (peval env [] = 0) as Z by trivial. rewrite <- Q, E2, E1 in Z by trivial.
    assert (0 < fold_left (fun s t => s + w t) terms (peval env [])); [|lra].
    apply Wp; trivial. right. split; [simpl; lra|trivial].
  - destruct pc as [pc|]; [|discriminate]. destruct HN as [HN|HN]; [discriminate|].
    destruct (along_side pc s) as [[zs fm]|] eqn:AS; [|discriminate].
    destruct (GS s zs fm AS) as [Z0 [d [e Ge]]].
    apply andb_true_iff in C as [C R]. apply andb_true_iff in C as [C IA]. apply andb_true_iff in IA as [In_ Al].
    apply andb_true_iff in C as [C Ka]. apply andb_true_iff in C as [C Sa]. apply andb_true_iff in C as [C Po].
    apply andb_true_iff in C as [Mn Md].
    assert (PP : 0 < peval env num0 /\ 0 < peval env den).
    { destruct (Rlt_dec 0 (peval env num0)) as [N0|N0]; [destruct (Rlt_dec 0 (peval env den)) as [D0|D0]; [tauto|]|];
        exfalso; apply (IH _ _ _ env GS Po); trivial; apply Forall_app; split; trivial; (apply Forall_cons; [|apply Forall_nil]).
      - exists [anot (A den SP)]. split; [right; left; trivial|]. apply Forall_cons; [|apply Forall_nil]. apply anot_holds. exact D0.
      - exists [anot (A num0 SP)]. split; [left; trivial|]. apply Forall_cons; [|apply Forall_nil]. apply anot_holds. exact N0. }
    destruct PP as [Pn Pd].
    destruct (germ_inside pc env s zs fm d e num0 den st HN Ge H Mn Md Pn Pd fuel inside In_) as [d' [D' [Dd Gi]]].
    assert (Ha : forall t, 0 < t < d' -> holds (e t) a).
    { intros t Ht. destruct (Gi t Ht) as [G1 G2]. destruct (holds_dec (e t) a) as [|N]; trivial. exfalso.
      apply (HN _ _ _ fuel (e t) Al); trivial. apply Forall_app; split; trivial. apply Forall_cons; [|apply Forall_nil].
      apply anot_holds; trivial. }
    assert (L : germ_limit (fun t => peval (e t) (apoly a)) (peval env (at0 (apoly a)))).
    { rewrite at0_eval. apply germ_limit_poly with (1 := Ka). intros k [<-|Ik].
      - cbn [at_zero]. apply germ_limit_near with (fun t => t) d; [apply Ge| |].
        + intros t Ht. symmetry. apply (proj1 (proj2 Ge) t Ht).
        + apply lim_x.
      - assert (at_zero env k = env k) as ->.
        { destruct k; trivial. assert (existsb (Nat.eqb 0) (constants pc ++ zs) = true); [|congruence].
          apply existsb_exists. exists 0%nat. split; trivial. }
        eapply germ_known; eassumption. }
    apply (IH _ _ _ env GS R); trivial. apply Forall_app; split; trivial. apply Forall_cons; [|apply Forall_nil].
    unfold holds in *; cbn [asign apoly]. destruct (asign a); try discriminate.
    + assert (0 <= peval env (at0 (apoly a))).
      { apply germ_limit_nonneg with (1 := L) (2 := D'). intros t Ht. rewrite (Ha t Ht); lra. }
      assert (0 <= - peval env (at0 (apoly a))); [|lra].
      apply (germ_limit_nonneg (fun t => - peval (e t) (apoly a)) _ d' (limit_Ropp _ _ _ _ L) D').
      intros t Ht. rewrite (Ha t Ht); lra.
    + apply germ_limit_nonneg with (1 := L) (2 := D'). auto.
Qed.
