(** * The rules of proof *)

Record term := T { weight : Z; square : poly; factors : list (nat * nat) }.
Record side := Side { point : option (Z * positive); above : bool }.
(** A number as the data below write it. *)
Definition q_ (n : Z) (d : positive) : Z * positive := (n, d).
Inductive proof :=
| Absurd
| Assume (formula : nat) (each_case : list proof)
| Split (p : poly) (each_side : list (bool * sign * proof))
| Substitute (equation var : nat) (lead : list (nat * nat)) (rest : proof)
| Positive (terms : list term) (cofactors : list (nat * poly))
| Pass (s : side) (num den : poly) (positive inside : proof) (a : atom) (along rest : proof).

Definition is_order (s : sign) : bool := match s with SNN | SP => true | _ => false end.
Definition nth_atom (l : atoms) (i : nat) : atom := nth i l (A [] SZ).
Fixpoint product (l : atoms) (fs : list (nat * nat)) : poly :=
  match fs with [] => pone | (i, n) :: fs => pmul (ppow (apoly (nth_atom l i)) n) (product l fs) end.
Definition nonzero_factor (l : atoms) (f : nat * nat) : bool :=
  match asign (nth_atom l (fst f)) with SP | SNZ => true | _ => false end.
Definition positive_factor (l : atoms) (f : nat * nat) : bool :=
  match asign (nth_atom l (fst f)) with SP => true | SNZ => Nat.even (snd f) | _ => false end.
Definition nonnegative_factor (l : atoms) (f : nat * nat) : bool :=
  match asign (nth_atom l (fst f)) with SNN => true | _ => positive_factor l f end.

Fixpoint remainder (fuel v : nat) (rule lead : poly) (odd : bool) (p : poly) : bool * poly :=
  match fuel with
  | O => (odd, p)
  | S fuel =>
    if Nat.ltb (degree v p) (degree v rule) then (odd, p) else
    let shift := repeat 0%nat v ++ [(degree v p - degree v rule)%nat] in
    remainder fuel v rule lead (negb odd)
      (psub (pmul p lead) (pmul (tmul (trim shift) 1 (top v p)) rule))
  end.
Definition reduce (v : nat) (rule lead : poly) (always_positive : bool) (a : atom) : atom :=
  let (odd, r) := remainder (S (degree v (apoly a))) v rule lead false (apoly a) in
  let r := if is_order (asign a) && negb always_positive && odd then pmul r lead else r in
  A (prim r) (asign a).

Fixpoint mapi {X Y} (f : nat -> X -> Y) (i : nat) (l : list X) : list Y :=
  match l with [] => [] | x :: l => f i x :: mapi f (S i) l end.

Fixpoint only_in (ks : list nat) (i : nat) (m : mono) : bool :=
  match m with
  | [] => true | n :: m => (Nat.eqb n 0 || existsb (Nat.eqb i) ks) && only_in ks (S i) m
  end.
Definition mentions_only (ks : list nat) (p : poly) : bool := forallb (fun t => only_in ks 0 (fst t)) p.
Definition at0 (p : poly) : poly := filter (fun t => Nat.eqb (nth 0 (fst t) 0%nat) 0) p.

(** What is known along the germs x = a ± t and x = ± 1/t. *)
Record passing := Passing {
  constants : list nat;
  var : nat;
  ranges_along : atoms;
  leaves : list cases;
  along_sides : list (side * (list nat * list cases))
}.
Definition seqb_side (s t : side) : bool :=
  Bool.eqb (above s) (above t) &&
  match point s, point t with
  | None, None => true | Some (n, d), Some (m, c) => Z.eqb n m && Pos.eqb d c | _, _ => false
  end.
Definition along_side (pc : passing) (s : side) : option (list nat * list cases) :=
  option_map snd (find (fun p => seqb_side s (fst p)) (along_sides pc)).
Definition binding (x : nat) (s : side) : atom :=
  let step := if above s then pvar 0 else pneg (pvar 0) in
  A (match point s with
     | Some (n, d) => psub (padd (pconst (- n)) (pscale (Zpos d) (pvar x))) (pscale (Zpos d) step)
     | None => psub (pmul (pvar x) step) pone
     end) SZ.
Definition germ_atoms (pc : passing) (s : side) (num den : poly) (st : atoms) : atoms :=
  ranges_along pc ++ filter (fun a => mentions_only (constants pc) (apoly a)) st ++
  [A (pvar 0) SP; A (psub num (pmul den (pvar 0))) SP; binding (var pc) s].

(** A polynomial or its opposite, and which of its signs -1, 0 and 1 have a case. *)
Definition sided (opposite : bool) (q : poly) : poly := if opposite then pneg q else q.
Definition admitted (each : list (bool * sign * proof)) (v : Z) : bool :=
  existsb (fun c : bool * sign * proof => admits (snd (fst c)) (if fst (fst c) then Z.opp v else v)) each.

Fixpoint refute (pc : option passing) (fuel : nat) (fs : list cases) (st : atoms) (p : proof) : bool :=
  match fuel with O => false | S fuel =>
  match p with
  | Absurd => existsb (fun a => match decided a with Some false => true | _ => false end) st
  | Assume f ps =>
    (fix go (cs : cases) (ps : list proof) := match cs, ps with
     | [], [] => true
     | c :: cs, p :: ps => refute pc fuel fs (st ++ c) p && go cs ps
     | _, _ => false end) (nth f fs [[]]) ps
  | Split q each =>
    forallb (admitted each) [-1; 0; 1]%Z &&
    forallb (fun c : bool * sign * proof => refute pc fuel fs (st ++ [A (sided (fst (fst c)) q) (snd (fst c))]) (snd c)) each
  | Substitute i v lead rest =>
    let eq := nth_atom st i in
    let want := prim (product st lead) in
    let have := prim (top v (apoly eq)) in
    let rule := if peqb have want then apoly eq else pneg (apoly eq) in
    let l := top v rule in
    let pos := forallb (positive_factor st) lead in
    match asign eq with SZ => true | _ => false end && forallb (nonzero_factor st) lead &&
    peqb (prim l) want &&
    refute pc fuel fs (mapi (fun j a =>
      if Nat.eqb j i then (if Nat.eqb (degree v (apoly eq)) 1 then A [] SZ else a)
      else reduce v rule l pos a) 0 st) rest
  | Positive ts cs =>
    forallb (fun t => Z.ltb 0 (weight t) && forallb (nonnegative_factor st) (factors t)) ts &&
    forallb (fun c => match asign (nth_atom st (fst c)) with SZ => true | _ => false end) cs &&
    existsb (fun t => forallb (positive_factor st) (factors t) &&
      match as_const (square t) with Some c => negb (Z.eqb c 0) | None => false end) ts &&
    match fold_left (fun s c => padd s (pmul (apoly (nth_atom st (fst c))) (snd c))) cs
      (fold_left (fun s t => padd s (pscale (weight t) (pmul (pmul (square t) (square t)) (product st (factors t))))) ts [])
    with [] => true | _ => false end
  | Pass s num den pos inside a along rest =>
    match pc with None => false | Some pc' =>
    match along_side pc' s with None => false | Some (zs, formulas) =>
    mentions_only (constants pc') num && mentions_only (constants pc') den &&
    refute pc fuel (fs ++ [[[anot (A num SP)]; [anot (A den SP)]]]) st pos &&
    match asign a with SZ | SNN => true | _ => false end &&
    mentions_only (0%nat :: constants pc' ++ zs) (apoly a) &&
    (let st' := germ_atoms pc' s num den st in
     refute None fuel (leaves pc') st' inside && refute None fuel formulas (st' ++ [anot a]) along) &&
    refute pc fuel fs (st ++ [A (at0 (apoly a)) (asign a)]) rest
    end end
  end end.

(** ** They are sound *)

Lemma nth_holds e st i : all_hold e st -> holds e (nth_atom st i).
Proof.
  intro H. unfold nth_atom. destruct (nth_in_or_default i st (A [] SZ)) as [I| ->].
  - apply (all_in e st); trivial.
  - reflexivity.
Qed.
Lemma product_nonzero e st fs : all_hold e st -> forallb (nonzero_factor st) fs = true ->
  peval e (product st fs) <> 0.
Proof.
  intros H. induction fs as [|[i n] fs IH]; cbn [forallb product]; intro F.
  - unfold pone. rewrite peval_const. lra.
  - apply andb_true_iff in F as [F G]. rewrite peval_mul, peval_pow.
    apply Rmult_integral_contrapositive_currified; auto. apply pow_nonzero.
    pose proof (nth_holds e st i H) as K. unfold nonzero_factor in F; cbn [fst] in F. unfold holds in K.
    destruct (asign (nth_atom st i)); try discriminate; lra.
Qed.
Lemma pow_even x n : Nat.even n = true -> 0 <= x ^ n /\ (x <> 0 -> 0 < x ^ n).
Proof.
  intro E. apply Nat.even_spec in E as [k ->]. rewrite pow_mult. assert (0 <= x ^ 2) by (simpl; nra).
  split; [apply pow_le; trivial|]. intro X. apply pow_lt. simpl; destruct (Rdichotomy _ _ X); nra.
Qed.
Lemma factor_sign e st f : all_hold e st ->
  (positive_factor st f = true -> 0 < peval e (apoly (nth_atom st (fst f))) ^ snd f) /\
  (nonnegative_factor st f = true -> 0 <= peval e (apoly (nth_atom st (fst f))) ^ snd f).
Proof.
  intro H. pose proof (nth_holds e st (fst f) H) as K. unfold nonnegative_factor, positive_factor.
  unfold holds in K. destruct (asign (nth_atom st (fst f))); split; intro F; try discriminate.
  - apply pow_even; trivial.
  - apply Rlt_le, pow_even; trivial.
  - apply pow_le; trivial.
  - apply pow_lt; trivial.
  - apply Rlt_le, pow_lt; trivial.
Qed.
Lemma product_positive e st fs : all_hold e st -> forallb (positive_factor st) fs = true ->
  0 < peval e (product st fs).
Proof.
  intros H. induction fs as [|[i n] fs IH]; cbn [forallb product]; intro F.
  - unfold pone. rewrite peval_const. lra.
  - apply andb_true_iff in F as [F G]. rewrite peval_mul, peval_pow.
    apply Rmult_lt_0_compat; auto. apply (factor_sign e st (i, n) H); trivial.
Qed.
Lemma product_nonnegative e st fs : all_hold e st -> forallb (nonnegative_factor st) fs = true ->
  0 <= peval e (product st fs).
Proof.
  intros H. induction fs as [|[i n] fs IH]; cbn [forallb product]; intro F.
  - unfold pone. rewrite peval_const. lra.
  - apply andb_true_iff in F as [F G]. rewrite peval_mul, peval_pow.
    apply Rmult_le_pos; auto. apply (factor_sign e st (i, n) H); trivial.
Qed.

Lemma remainder_eval e v rule lead fuel p odd odd' r : peval e rule = 0 ->
  remainder fuel v rule lead odd p = (odd', r) ->
  exists k, peval e r = peval e lead ^ k * peval e p /\ odd' = xorb odd (Nat.odd k).
Proof.
  intro Z. revert p odd. induction fuel as [|fuel IH]; cbn [remainder]; intros p odd.
  - intro H; inversion H; subst. exists 0%nat. rewrite xorb_false_r. split; [simpl; ring|trivial].
  - destruct (Nat.ltb _ _).
    + intro H; inversion H; subst. exists 0%nat. rewrite xorb_false_r. split; [simpl; ring|trivial].
    + intro H. destruct (IH _ _ H) as [k [E O]]. exists (S k). split.
      * rewrite E, peval_sub, !peval_mul, Z. simpl; ring.
      * rewrite O, Nat.odd_succ, <- Nat.negb_odd. destruct odd, (Nat.odd k); trivial.
Qed.
Lemma reduce_holds e v rule lead pos a : peval e rule = 0 -> peval e lead <> 0 ->
  (pos = true -> 0 < peval e lead) -> holds e a -> holds e (reduce v rule lead pos a).
Proof.
  intros Z L P H. unfold reduce.
  destruct (remainder (S (degree v (apoly a))) v rule lead false (apoly a)) as [odd r] eqn:E.
  destruct (remainder_eval e _ _ _ _ _ _ _ _ Z E) as [k [V O]].
  set (q := if is_order (asign a) && negb pos && odd then pmul r lead else r).
  assert (Q : exists c, c <> 0 /\ (is_order (asign a) = true -> 0 < c) /\ peval e q = c * peval e (apoly a)).
  { assert (N : peval e lead ^ k <> 0) by (apply pow_nonzero; trivial).
    unfold q. destruct (is_order (asign a)); simpl.
    - destruct pos; simpl.
      + exists (peval e lead ^ k). repeat split; trivial. intros _. apply pow_lt; auto.
      + destruct odd.
        * exists (peval e lead ^ (k + 1)). rewrite peval_mul, V, pow_add.
          assert (Ev : Nat.even (k + 1) = true).
          { rewrite Nat.add_1_r, Nat.even_succ. rewrite xorb_false_l in O; auto. }
          rewrite <- pow_add. repeat split; [apply pow_nonzero; trivial|intros _; apply pow_even; trivial|].
          rewrite pow_add; ring.
        * exists (peval e lead ^ k). assert (Ev : Nat.even k = true).
          { rewrite xorb_false_l in O. rewrite <- Nat.negb_odd, <- O; trivial. }
          repeat split; trivial. intros _; apply pow_even; trivial.
    - exists (peval e lead ^ k). repeat split; trivial. discriminate. }
  destruct Q as [c [C [CP Q]]]. destruct (prim_eval e q) as [g [G GE]]. rewrite GE in Q.
  unfold holds in *; cbn [asign apoly].
  assert (K : peval e (prim q) = (c / g) * peval e (apoly a)).
  { apply Rmult_eq_reg_l with g; [|lra]. rewrite Q. field; lra. }
  rewrite K. assert (C' : c / g <> 0).
  { apply Rmult_integral_contrapositive_currified; trivial. apply Rinv_neq_0_compat; lra. }
  assert (CG : 0 < c -> 0 < c / g) by (intro; apply Rdiv_lt_0_compat; trivial).
  destruct (asign a); simpl in CP; specialize (fun H => CG (CP H)).
  - rewrite H; ring.
  - apply Rmult_integral_contrapositive_currified; trivial.
  - apply Rmult_le_pos; trivial. apply Rlt_le; auto.
  - apply Rmult_lt_0_compat; auto.
Qed.
Lemma sided_holds e q (o : bool) s v : (v = -1)%Z /\ peval e q < 0 \/ v = 0%Z /\ peval e q = 0 \/ v = 1%Z /\ 0 < peval e q ->
  admits s (if o then Z.opp v else v) = true -> holds e (A (sided o q) s).
Proof.
  intros H M. unfold holds, sided; cbn [asign apoly].
  destruct o; rewrite ?peval_neg; destruct H as [[-> H]|[[-> H]|[-> H]]]; destruct s;
    cbn in M; try discriminate; first [lra | intro; lra].
Qed.
Lemma mapi_holds e f (l : atoms) : (forall i a, holds e a -> holds e (f i a)) ->
  forall i, all_hold e l -> all_hold e (mapi f i l).
Proof. intros F. induction l; simpl; intros i H; constructor; inversion H; subst; auto. Qed.

Lemma only_in_eval e e' ks m : forall i, only_in ks i m = true -> (forall k, In k ks -> e k = e' k) ->
  meval e i m = meval e' i m.
Proof.
  induction m as [|n m IH]; simpl; intros i O E; trivial.
  apply andb_true_iff in O as [O P]. rewrite (IH _ P E). f_equal.
  apply orb_true_iff in O as [O|O]; [apply Nat.eqb_eq in O; subst; trivial|].
  apply existsb_exists in O as [k [K Q]]. apply Nat.eqb_eq in Q; subst. rewrite E; trivial.
Qed.
Lemma mentions_eval e e' ks p : mentions_only ks p = true -> (forall k, In k ks -> e k = e' k) ->
  peval e p = peval e' p.
Proof.
  induction p as [|[m c] p IH]; cbn [mentions_only forallb peval fst]; intros M E; trivial.
  apply andb_true_iff in M as [M N]. rewrite (only_in_eval e e' ks m 0 M E). f_equal. apply IH; trivial.
Qed.
Definition at_zero (e : nat -> R) : nat -> R := fun i => match i with O => 0 | _ => e i end.
Lemma meval_at_zero e m i : meval (at_zero e) (S i) m = meval e (S i) m.
Proof. revert i; induction m; simpl; intros; trivial. rewrite IHm; trivial. Qed.
Lemma at0_eval e p : peval e (at0 p) = peval (at_zero e) p.
Proof.
  induction p as [|[m c] p IH]; simpl; trivial. destruct m as [|[|n] m]; simpl.
  - rewrite IH; ring.
  - rewrite IH, meval_at_zero; ring.
  - rewrite IH. rewrite Rmult_0_l. ring.
Qed.
