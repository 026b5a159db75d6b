(** * Witnesses *)

Fixpoint horner (t : R) (cs : list Z) : R :=
  match cs with [] => 0 | c :: cs => IZR c + t * horner t cs end.
(** A coordinate of a point: a polynomial in one algebraic number, over a denominator. *)
Definition at_ (t : R) (cs : list Z) (d : positive) : R := horner t cs / IZR (Zpos d).
(** A coordinate as the data below write it. *)
Definition c_ (coefficients : list Z) (d : positive) : list Z * positive := (coefficients, d).
Arguments c_ coefficients%Z d%positive.
Arguments at_ t%R cs%Z d%positive.
Fixpoint horner_poly (cs : list Z) : poly :=
  match cs with [] => [] | c :: cs => padd (pconst c) (pmul (pvar 0) (horner_poly cs)) end.
(** An algebraic number: where a polynomial changes from negative to positive between two fractions. *)
Record root := Generator { modulus : list Z; low : Z * positive; high : Z * positive }.
Record witness := Witness { coordinates : list (list Z * positive); theta : option root; closings : list proof }.

Definition entails (st : atoms) (a : atom) (p : proof) : bool := refute None depth [] (st ++ [anot a]) p.
Definition fixes (v : nat) (cs : list Z) (d : positive) : atom :=
  A (psub (pscale (Zpos d) (pvar v)) (horner_poly cs)) SZ.
Definition sign_at (cs : list Z) (q : Z * positive) (s : sign) : bool :=
  entails [fixes 0 [fst q] (snd q)] (A (match s with SP => horner_poly cs | _ => pneg (horner_poly cs) end) SP)
    (Substitute 0 0 [] Absurd).
Definition root_atoms (r : option root) : atoms :=
  match r with
  | None => []
  | Some r => [A (horner_poly (modulus r)) SZ;
      A (psub (pscale (Zpos (snd (low r))) (pvar 0)) (pconst (fst (low r)))) SP;
      A (psub (pconst (fst (high r))) (pscale (Zpos (snd (high r))) (pvar 0))) SP]
  end.
Definition witness_atoms (w : witness) : atoms :=
  mapi (fun i c => fixes (S i) (fst c) (snd c)) 0 (coordinates w) ++ root_atoms (theta w).
Fixpoint chain (i n : nat) (last : proof) : proof :=
  match n with O => last | S n => Substitute i (S i) [] (chain (S i) n last) end.
Definition closing (w : witness) (last : proof) : proof :=
  chain 0 (length (coordinates w))
    (match theta w with None => last | Some _ => Substitute (length (coordinates w)) 0 [] last end).
Definition follows (w : witness) (a : atom) : bool :=
  existsb (fun last => entails (witness_atoms w) a (closing w last)) (closings w).
Definition root_exists (r : option root) : bool :=
  match r with None => true | Some r =>
    sign_at (modulus r) (low r) SNN && sign_at (modulus r) (high r) SP &&
    Z.ltb (fst (low r) * Zpos (snd (high r))) (fst (high r) * Zpos (snd (low r)))
  end.
Definition satisfied (w : witness) (fs : list cases) : bool :=
  forallb (existsb (forallb (follows w))) fs.
Definition refuted_by (g : goal) (w : witness) : bool :=
  satisfied w (map (fun r => where_all 1 [r]) (ranges g) ++ snd (point_state 1 g)).

Lemma entails_sound st a p e : entails st a p = true -> all_hold e st -> holds e a.
Proof.
  unfold entails. intros C H. destruct (holds_dec e a) as [|N]; trivial. exfalso.
  apply (refute_sound None depth _ _ p e I C); [|constructor].
  apply Forall_app; split; trivial. apply Forall_cons; [apply anot_holds; trivial|apply Forall_nil].
Qed.
Lemma horner_eval e cs : peval e (horner_poly cs) = horner (e 0%nat) cs.
Proof.
  induction cs as [|c cs IH]; cbn [horner_poly horner]; trivial.
  rewrite peval_add, peval_const, peval_mul, peval_var, IH. trivial.
Qed.
Lemma fixes_holds e v cs d : e v = at_ (e 0%nat) cs d -> holds e (fixes v cs d).
Proof.
  intro H. unfold fixes, holds; cbn [asign apoly]. rewrite peval_sub, peval_scale, peval_var, horner_eval, H.
  unfold at_. field. apply not_0_IZR; discriminate.
Qed.
Lemma horner_continuous cs : continuity (fun t => horner t cs).
Proof.
  induction cs as [|c cs IH]; cbn [horner].
  - apply continuity_const. intros x y; trivial.
  - apply continuity_plus; [apply continuity_const; intros x y; trivial|].
    apply continuity_mult; trivial. apply derivable_continuous, derivable_id.
Qed.
Lemma sign_at_sound cs q s : sign_at cs q s = true ->
  match s with SP => 0 < horner (IZR (fst q) / IZR (Zpos (snd q))) cs
  | _ => horner (IZR (fst q) / IZR (Zpos (snd q))) cs < 0 end.
Proof.
  intro C. set (e := fun i : nat => match i with O => IZR (fst q) / IZR (Zpos (snd q)) | _ => 0 end).
  assert (K : holds e (fixes 0 [fst q] (snd q))).
  { apply fixes_holds. unfold at_; simpl. field. apply pos_neq. }
  pose proof (entails_sound _ _ _ e C (Forall_cons _ K (Forall_nil _))) as H.
  unfold holds in H; cbn [asign apoly] in H.
  destruct s; rewrite ?peval_neg, horner_eval in H; cbn [e] in H; lra.
Qed.
Lemma root_found r : root_exists r = true ->
  exists t, forall e, e 0%nat = t -> all_hold e (root_atoms r).
Proof.
  destruct r as [[cs [a b] [c d]]|]; [|exists 0; intros; constructor].
  unfold root_exists; cbn [modulus low high fst snd]. intro H. split_bools.
  match goal with H : sign_at _ _ SNN = true |- _ => apply sign_at_sound in H; rename H into L end.
  match goal with H : sign_at _ _ SP = true |- _ => apply sign_at_sound in H; rename H into U end.
  match goal with H : Z.ltb _ _ = true |- _ => apply Z.ltb_lt, IZR_lt in H; rewrite !mult_IZR in H; rename H into LT end.
  cbn [fst snd] in *.
  pose proof (pos_pos b). pose proof (pos_pos d).
  assert (Q : IZR a / IZR (Zpos b) < IZR c / IZR (Zpos d)).
  { apply Rmult_lt_reg_r with (IZR (Zpos b) * IZR (Zpos d)); [apply Rmult_lt_0_compat; trivial|].
    replace (IZR a / IZR (Zpos b) * (IZR (Zpos b) * IZR (Zpos d))) with (IZR a * IZR (Zpos d)) by (field; lra).
    replace (IZR c / IZR (Zpos d) * (IZR (Zpos b) * IZR (Zpos d))) with (IZR c * IZR (Zpos b)) by (field; lra).
    trivial. }
  destruct (IVT (fun t => horner t cs) _ _ (horner_continuous cs) Q L U) as [t [[T1 T2] Z0]].
  cbn beta in Z0, L, U.
  assert (t <> IZR a / IZR (Zpos b)) by (intro; subst t; rewrite Z0 in L; revert L; apply Rlt_irrefl).
  assert (t <> IZR c / IZR (Zpos d)) by (intro; subst t; rewrite Z0 in U; revert U; apply Rlt_irrefl).
  exists t. intros e E. unfold root_atoms; cbn [modulus low high fst snd].
  repeat apply Forall_cons; try apply Forall_nil; unfold holds; cbn [asign apoly];
    rewrite ?peval_sub, ?peval_scale, ?peval_const, ?peval_var, ?horner_eval, E; trivial.
  - assert (IZR a / IZR (Zpos b) * IZR (Zpos b) < t * IZR (Zpos b)) by (apply Rmult_lt_compat_r; lra).
    replace (IZR a / IZR (Zpos b) * IZR (Zpos b)) with (IZR a) in * by (field; lra). lra.
  - assert (t * IZR (Zpos d) < IZR c / IZR (Zpos d) * IZR (Zpos d)) by (apply Rmult_lt_compat_r; lra).
    replace (IZR c / IZR (Zpos d) * IZR (Zpos d)) with (IZR c) in * by (field; lra). lra.
Qed.
Definition place (w : witness) (t : R) : list R := map (fun c => at_ t (fst c) (snd c)) (coordinates w).
Lemma witness_holds w t more : (forall e : nat -> R, e 0%nat = t -> all_hold e (root_atoms (theta w))) ->
  all_hold (values (t :: place w t ++ more)) (witness_atoms w).
Proof.
  intro T. apply Forall_app; split; [|apply T; trivial].
  set (e := values (t :: place w t ++ more)).
  assert (G : forall i cs, (forall j, (j < length cs)%nat -> e (S (i + j)) = nth j (map (fun c => at_ t (fst c) (snd c)) cs) 0) ->
    all_hold e (mapi (fun i c => fixes (S i) (fst c) (snd c)) i cs)).
  { intros i cs; revert i; induction cs as [|c cs IH]; intros i E; simpl; [constructor|].
    apply Forall_cons.
    - apply fixes_holds. specialize (E 0%nat (Nat.lt_0_succ _)). rewrite Nat.add_0_r in E. exact E.
    - apply IH. intros j J. specialize (E (S j) (proj1 (Nat.succ_lt_mono _ _) J)). rewrite <- plus_n_Sm in E. exact E. }
  apply G. intros j J. unfold e, values. cbn [nth Nat.add]. apply app_nth1. unfold place. rewrite map_length. trivial.
Qed.
Lemma satisfied_sound w fs e : satisfied w fs = true -> all_hold e (witness_atoms w) -> some_cases e fs.
Proof.
  unfold satisfied. intros C H.
  assert (F : forall a, follows w a = true -> holds e a).
  { intros a Ha. apply existsb_exists in Ha as [p [_ E]]. eapply entails_sound; eassumption. }
  rewrite forallb_forall in C. apply Forall_forall. intros c I. specialize (C c I).
  apply existsb_exists in C as [a [J L]]. exists a; split; trivial. rewrite forallb_forall in L.
  apply Forall_forall. auto.
Qed.
Lemma refuted_there g w t more : refuted_by g w = true -> rooted_goal (place w t ++ more) g ->
  (forall e : nat -> R, e 0%nat = t -> all_hold e (root_atoms (theta w))) -> ~ states g (place w t ++ more).
Proof.
  unfold refuted_by. intros C [RR [RP [RC RL]]] T0. pose proof (witness_holds w t more T0) as T.
  set (l := place w t ++ more) in *. set (e := values (t :: l)) in *.
  assert (AG : agrees 1 e l) by (intro; trivial).
  pose proof (satisfied_sound _ _ e C T) as F.
  cbn [snd point_state] in F. unfold some_cases in F. apply Forall_app in F as [FR F].
  apply Forall_app in F as [FP F]. apply Forall_app in F as [FC FF].
  unfold states. rewrite imply_all, arrow_imp. intro S.
  apply (proj1 (failure_spec 1 e l (claim g) AG RL)); trivial. apply S; clear S.
  - apply Forall_app; split; apply (proj2 (Forall_props _ _)).
    + rewrite Forall_map in FR. rewrite Forall_forall in *. intros r Ir. specialize (FR r Ir).
      apply (where_all_spec 1 e l [r] AG) in FR; [apply flat_cons in FR; tauto|].
      unfold rooted_all in RR. rewrite Forall_forall in RR. apply Forall_cons; [auto|apply Forall_nil].
    + rewrite Forall_forall in *. intros h Ih. apply filter_In in Ih as [Ih _].
      apply holds_spec with (e := e) (off := 1%nat); auto.
      apply FP. unfold formulas. apply in_map_iff. eauto.
  - apply (where_all_spec 1 e l _ AG RC). inversion FC; trivial.
Qed.
Lemma place_only g w t : rootless_goal g = true -> refuted_by g w = true ->
  (forall e : nat -> R, e 0%nat = t -> all_hold e (root_atoms (theta w))) -> ~ states g (place w t).
Proof.
  intros RG C T. rewrite <- (app_nil_r (place w t)). apply refuted_there; trivial. apply rootless_rooted_goal; trivial.
Qed.
(** A point with rational coordinates; what stands behind them are roots and derivatives. *)
Definition refutes_rooted (g : goal) (w : witness) : bool :=
  refuted_by g w && match theta w with None => true | _ => false end.
Theorem refuted_rooted g w more : refutes_rooted g w = true -> rooted_goal (place w 0 ++ more) g ->
  ~ states g (place w 0 ++ more).
Proof.
  unfold refutes_rooted. intros C RG. split_bools. apply refuted_there; trivial. destruct (theta w); [discriminate|]. constructor.
Qed.
Definition refutes (g : goal) (w : witness) : bool := rootless_goal g && refutes_rooted g w.
Theorem refuted g w : refutes g w = true ->
  ~ states g (place w 0).
Proof.
  unfold refutes, refutes_rooted. intro C. split_bools. apply place_only; trivial. destruct (theta w); [discriminate|]. constructor.
Qed.
(** A point at an algebraic number, which exists by the intermediate value theorem. *)
Definition refutes_at_root (g : goal) (w : witness) : bool := rootless_goal g && refuted_by g w && root_exists (theta w).
Theorem refuted_root g w : refutes_at_root g w = true -> exists t, ~ states g (place w t).
Proof.
  unfold refutes_at_root. intro C. split_bools. match goal with H : root_exists _ = true |- _ => destruct (root_found _ H) as [t T] end.
  exists t. apply place_only; trivial.
Qed.
