(* Proofs of derivations, checked by Coq and its standard library alone.

   The first part of this file is the theory: polynomials with integer coefficients, what a statement
   says and where it is defined, the rules of proof, and that they are sound; witnesses, limits and
   functions where a claim below needs them. The second part has, for each claim, the claim as data,
   the certificate as data, and a lemma that says the claim in full. *)

From Coq Require Import Reals Lra List ZArith Bool Arith.
Import ListNotations.
Open Scope R_scope.

(** * Polynomials with integer coefficients: exponents by variable, and a coefficient *)

Definition mono := list nat.
Definition poly := list (mono * Z).
(** A term as the data below write it. *)
Definition m_ (exponents : list nat) (c : Z) : mono * Z := (exponents, c).
Arguments m_ exponents%nat c%Z.

Fixpoint meval (e : nat -> R) (i : nat) (m : mono) : R :=
  match m with [] => 1 | n :: m' => e i ^ n * meval e (S i) m' end.
Fixpoint peval (e : nat -> R) (p : poly) : R :=
  match p with [] => 0 | (m, c) :: q => IZR c * meval e 0 m + peval e q end.

Fixpoint mcmp (a b : mono) : comparison :=
  match a, b with
  | [], [] => Eq | [], _ => Lt | _, [] => Gt
  | x :: a', y :: b' => match Nat.compare x y with Eq => mcmp a' b' | c => c end
  end.
Fixpoint mmul (a b : mono) : mono :=
  match a, b with
  | [], _ => b | _, [] => a
  | x :: a', y :: b' => (x + y)%nat :: mmul a' b'
  end.

Fixpoint padd (p : poly) : poly -> poly :=
  fix go (q : poly) : poly :=
  match p, q with
  | [], _ => q
  | _, [] => p
  | (m, c) :: p', (n, d) :: q' =>
    match mcmp m n with
    | Eq => if Z.eqb (c + d) 0 then padd p' q' else (m, (c + d)%Z) :: padd p' q'
    | Lt => (m, c) :: padd p' q
    | Gt => (n, d) :: go q'
    end
  end.
Definition tmul (m : mono) (c : Z) (p : poly) : poly :=
  map (fun t => (mmul m (fst t), (c * snd t)%Z)) p.
Definition pscale (c : Z) (p : poly) : poly := if Z.eqb c 0 then [] else tmul [] c p.
Definition pneg := pscale (-1).
Fixpoint pmul' (p q : poly) : poly :=
  match p with [] => [] | (m, c) :: p' => padd (tmul m c q) (pmul' p' q) end.
Definition pmul (p q : poly) : poly :=
  if Nat.leb (length p) (length q) then pmul' p q else pmul' q p.
Definition pconst (c : Z) : poly := if Z.eqb c 0 then [] else [([], c)].
Definition pone := pconst 1.
Definition pvar (i : nat) : poly := [(repeat 0%nat i ++ [1%nat], 1%Z)].
Fixpoint ppow (p : poly) (n : nat) : poly := match n with O => pone | S n => pmul p (ppow p n) end.
Definition psub (p q : poly) := padd p (pneg q).

Fixpoint meqb (a b : mono) : bool :=
  match a, b with
  | [], [] => true | x :: a', y :: b' => Nat.eqb x y && meqb a' b' | _, _ => false
  end.
Fixpoint peqb (p q : poly) : bool :=
  match p, q with
  | [], [] => true
  | (m, c) :: p', (n, d) :: q' => Z.eqb c d && meqb m n && peqb p' q'
  | _, _ => false
  end.
Definition as_const (p : poly) : option Z :=
  match p with [] => Some 0%Z | [([], c)] => Some c | _ => None end.
Definition content (p : poly) : Z := fold_left (fun g t => Z.gcd g (snd t)) p 0%Z.
Definition prim (p : poly) : poly :=
  let g := content p in
  let q := map (fun t => (fst t, Z.div (snd t) g)) p in
  if Z.ltb 1 g && peqb (pscale g q) p then q else p.

Definition degree (v : nat) (p : poly) : nat := fold_left (fun d t => Nat.max d (nth v (fst t) 0%nat)) p 0%nat.
Fixpoint trim (m : mono) : mono :=
  match m with [] => [] | n :: m' => match n, trim m' with O, [] => [] | _, m'' => n :: m'' end end.
Fixpoint clear (v : nat) (m : mono) : mono :=
  match v, m with _, [] => [] | O, _ :: m' => O :: m' | S v, n :: m' => n :: clear v m' end.
Definition top (v : nat) (p : poly) : poly :=
  let d := degree v p in
  map (fun t => (trim (clear v (fst t)), snd t)) (filter (fun t => Nat.eqb (nth v (fst t) 0%nat) d) p).

Lemma mcmp_eq a b : mcmp a b = Eq -> a = b.
Proof.
  revert b; induction a as [|x a IH]; destruct b as [|y b]; simpl; try discriminate; trivial.
  destruct (Nat.compare_spec x y); try discriminate. intro; subst; f_equal; auto.
Qed.
Lemma meval_mul e a b i : meval e i (mmul a b) = meval e i a * meval e i b.
Proof.
  revert b i; induction a as [|x a IH]; destruct b as [|y b]; simpl; intros; try lra.
  rewrite IH, pow_add; ring.
Qed.
Lemma peval_add e p q : peval e (padd p q) = peval e p + peval e q.
Proof.
  revert q; induction p as [|[m c] p IH]. { destruct q; simpl; lra. }
  induction q as [|[n d] q IHq]. { simpl; lra. }
  simpl in *. destruct (mcmp m n) eqn:E.
  - apply mcmp_eq in E; subst. destruct (Z.eqb_spec (c + d) 0) as [Z0|Z0].
    + rewrite IH. replace (IZR c * meval e 0 n + peval e p + (IZR d * meval e 0 n + peval e q))
        with (IZR (c + d) * meval e 0 n + peval e p + peval e q) by (rewrite plus_IZR; ring).
      rewrite Z0; ring.
    + simpl. rewrite IH, plus_IZR; ring.
  - simpl. rewrite IH; simpl; ring.
  - simpl. rewrite IHq; ring.
Qed.
Lemma peval_tmul e m c p : peval e (tmul m c p) = IZR c * meval e 0 m * peval e p.
Proof. induction p as [|[n d] p IH]; simpl; [ring|]. rewrite IH, meval_mul, mult_IZR; ring. Qed.
Lemma peval_scale e c p : peval e (pscale c p) = IZR c * peval e p.
Proof.
  unfold pscale. destruct (Z.eqb_spec c 0); [subst; simpl; ring|]. rewrite peval_tmul; simpl; ring.
Qed.
Lemma peval_neg e p : peval e (pneg p) = - peval e p.
Proof. unfold pneg; rewrite peval_scale; ring. Qed.
Lemma peval_sub e p q : peval e (psub p q) = peval e p - peval e q.
Proof. unfold psub; rewrite peval_add, peval_neg; ring. Qed.
Lemma peval_mul' e p q : peval e (pmul' p q) = peval e p * peval e q.
Proof. induction p as [|[m c] p IH]; simpl; [ring|]. rewrite peval_add, peval_tmul, IH; ring. Qed.
Lemma peval_mul e p q : peval e (pmul p q) = peval e p * peval e q.
Proof. unfold pmul; destruct Nat.leb; rewrite peval_mul'; ring. Qed.
Lemma peval_const e c : peval e (pconst c) = IZR c.
Proof. unfold pconst; destruct (Z.eqb_spec c 0); subst; simpl; ring. Qed.
Lemma meval_var e i k : meval e k (repeat 0%nat i ++ [1%nat]) = e (k + i)%nat.
Proof.
  revert k; induction i; simpl; intros.
  - rewrite Nat.add_0_r; ring.
  - rewrite IHi; replace (S k + i)%nat with (k + S i)%nat by (rewrite Nat.add_succ_r; trivial); ring.
Qed.
Lemma peval_var e i : peval e (pvar i) = e i.
Proof. unfold pvar; simpl; rewrite meval_var; simpl; ring. Qed.
Lemma peval_pow e p n : peval e (ppow p n) = peval e p ^ n.
Proof. induction n as [|n IH]; [apply (peval_const e 1)|]. simpl ppow. rewrite peval_mul, IH; trivial. Qed.
Lemma meqb_eq a b : meqb a b = true -> a = b.
Proof.
  revert b; induction a; destruct b; simpl; try discriminate; trivial.
  intro H; apply andb_true_iff in H as [H G]; apply Nat.eqb_eq in H; subst; f_equal; auto.
Qed.
Lemma peqb_eq p q : peqb p q = true -> p = q.
Proof.
  revert q; induction p as [|[m c] p IH]; destruct q as [|[n d] q]; simpl; try discriminate; trivial.
  intro H; apply andb_true_iff in H as [H G]; apply andb_true_iff in H as [H F].
  apply Z.eqb_eq in H; apply meqb_eq in F; subst; f_equal; auto.
Qed.
Lemma as_const_eval e p c : as_const p = Some c -> peval e p = IZR c.
Proof.
  destruct p as [|[[|n m] d] [|t p]]; simpl; intro H; inversion H; subst; simpl; ring.
Qed.
Lemma prim_eval e p : exists g, 0 < g /\ peval e p = g * peval e (prim p).
Proof.
  unfold prim. destruct (_ && _) eqn:E; [|exists 1; split; lra].
  apply andb_true_iff in E as [G H]. apply peqb_eq in H. apply Z.ltb_lt in G.
  exists (IZR (content p)); split. { apply IZR_lt. apply Z.lt_trans with 1%Z; trivial; reflexivity. }
  rewrite <- peval_scale, H; trivial.
Qed.
