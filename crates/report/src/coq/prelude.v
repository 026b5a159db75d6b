(* Proofs of derivations, checked by Coq and its standard library alone.

   The first part of this file is the same for every document: polynomials with integer
   coefficients, what a statement says and where it is defined, the rules of proof, and that they
   are sound. The second part has, for each claim, the claim as data, the certificate as data, and a
   lemma that says the claim in full. *)

From Coq Require Import Reals Lra List ZArith Bool Arith.
Import ListNotations.
Open Scope R_scope.

(** * Polynomials with integer coefficients: exponents by variable, and a coefficient *)

Definition mono := list nat.
Definition poly := list (mono * Z).

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

(** * Conditions: a polynomial and its sign *)

Inductive sign := SZ | SNZ | SNN | SP.
Record atom := A { apoly : poly; asign : sign }.
Definition holds (e : nat -> R) (a : atom) : Prop :=
  match asign a with
  | SZ => peval e (apoly a) = 0 | SNZ => peval e (apoly a) <> 0
  | SNN => 0 <= peval e (apoly a) | SP => 0 < peval e (apoly a)
  end.
Definition admits (s : sign) (c : Z) : bool :=
  match s with
  | SZ => Z.eqb c 0 | SNZ => negb (Z.eqb c 0) | SNN => Z.leb 0 c | SP => Z.ltb 0 c
  end.
Definition decided (a : atom) : option bool := option_map (admits (asign a)) (as_const (apoly a)).
Definition anot (a : atom) : atom :=
  match asign a with
  | SZ => A (apoly a) SNZ | SNZ => A (apoly a) SZ
  | SNN => A (pneg (apoly a)) SP | SP => A (pneg (apoly a)) SNN
  end.
Definition seqb (s t : sign) : bool :=
  match s, t with SZ, SZ | SNZ, SNZ | SNN, SNN | SP, SP => true | _, _ => false end.
Definition aeqb (a b : atom) : bool := seqb (asign a) (asign b) && peqb (apoly a) (apoly b).

Lemma decided_holds e a b : decided a = Some b -> (holds e a <-> b = true).
Proof.
  unfold decided, holds. destruct (as_const (apoly a)) as [c|] eqn:E; [|discriminate].
  rewrite (as_const_eval e _ _ E). simpl. intro H; inversion H; clear H; subst. destruct (asign a); simpl.
  - rewrite Z.eqb_eq. split; [apply eq_IZR_R0|intros ->; trivial].
  - rewrite negb_true_iff, Z.eqb_neq. split; [intros H ->; auto|intros H F; apply H, eq_IZR_R0, F].
  - rewrite Z.leb_le. split; [apply le_IZR|apply IZR_le].
  - rewrite Z.ltb_lt. split; [apply lt_IZR|apply IZR_lt].
Qed.
Lemma anot_holds e a : holds e (anot a) <-> ~ holds e a.
Proof.
  unfold holds, anot. destruct (asign a); simpl; rewrite ?peval_neg; lra. Qed.
Lemma holds_dec e a : holds e a \/ ~ holds e a.
Proof.
  unfold holds. destruct (asign a); try lra; destruct (Req_dec (peval e (apoly a)) 0); tauto.
Qed.
Lemma aeqb_eq a b : aeqb a b = true -> a = b.
Proof.
  unfold aeqb; intro H; apply andb_true_iff in H as [H G]; apply peqb_eq in G.
  destruct a as [p s], b as [q t]; simpl in *; subst. destruct s, t; try discriminate; trivial.
Qed.

Definition atoms := list atom.
Definition cases := list atoms.
Notation all_hold e := (Forall (holds e)).
Definition some_case (e : nat -> R) (c : cases) : Prop := exists a, In a c /\ all_hold e a.
Definition some_cases (e : nat -> R) (fs : list cases) := Forall (some_case e) fs.

Fixpoint joined (a b : atoms) : option atoms :=
  match b with
  | [] => Some a
  | x :: b' =>
    match decided x with
    | Some true => joined a b'
    | Some false => None
    | None => if existsb (aeqb (anot x)) a then None
              else if existsb (aeqb x) a then joined a b' else joined (a ++ [x]) b'
    end
  end.
Lemma all_in e l x : all_hold e l -> In x l -> holds e x.
Proof. intros H I. rewrite Forall_forall in H; auto. Qed.
Lemma joined_spec e b a :
  match joined a b with
  | Some c => all_hold e c <-> all_hold e a /\ all_hold e b
  | None => ~ (all_hold e a /\ all_hold e b)
  end.
Proof.
  revert a; induction b as [|x b IH]; simpl; intro a.
  { split; [intro; split; trivial; constructor|tauto]. }
  assert (C : all_hold e (x :: b) <-> holds e x /\ all_hold e b) by apply Forall_cons_iff.
  destruct (decided x) as [[|]|] eqn:D.
  - pose proof (proj2 (decided_holds e _ _ D) eq_refl). specialize (IH a).
    destruct (joined a b); tauto.
  - pose proof (decided_holds e _ _ D) as F. assert (~ holds e x) by (rewrite F; discriminate). tauto.
  - destruct (existsb (aeqb (anot x)) a) eqn:E.
    + apply existsb_exists in E as [y [I Y]]. apply aeqb_eq in Y; subst.
      intros [Ha Hx]. pose proof (all_in _ _ _ Ha I) as N. rewrite anot_holds in N. tauto.
    + destruct (existsb (aeqb x) a) eqn:F.
      * apply existsb_exists in F as [y [I Y]]. apply aeqb_eq in Y; subst.
        specialize (IH a). pose proof (fun H => all_in e a y H I). destruct (joined a b); tauto.
      * specialize (IH (a ++ [x])). destruct (joined (a ++ [x]) b);
          rewrite Forall_app in IH; pose proof (Forall_cons_iff (holds e) x []);
          pose proof (Forall_nil (holds e)); tauto.
Qed.

(** * Regions: what something is where conditions hold *)

Definition pieces (T : Type) := list (atoms * option T).
Definition spec {T} (e : nat -> R) (ps : pieces T) (G : option T -> Prop) : Prop :=
  (forall p, In p ps -> all_hold e (fst p) -> G (snd p)) /\
  (exists p, In p ps /\ all_hold e (fst p)).
Definition everywhere {T} (v : option T) : pieces T := [([], v)].
Definition either {T} (a : atom) (x y : option T) : pieces T := [([a], x); ([anot a], y)].
Definition each {T U} (ps : pieces T) (next : T -> pieces U) : pieces U :=
  flat_map (fun p =>
    flat_map (fun q => match joined (fst p) (fst q) with Some a => [(a, snd q)] | None => [] end)
      (match snd p with None => everywhere None | Some v => next v end)) ps.
Definition both {T U V} (ps : pieces T) (qs : pieces U) (next : T -> U -> pieces V) : pieces V :=
  each ps (fun x => each qs (next x)).

Lemma spec_everywhere {T} e (v : option T) (G : option T -> Prop) : G v -> spec e (everywhere v) G.
Proof.
  intro H; split; [intros p [<-|[]] _; trivial|].
  exists ([], v); split; [left; trivial|constructor].
Qed.
Lemma spec_either {T} e a (x y : option T) (G : option T -> Prop) :
  (holds e a -> G x) -> (~ holds e a -> G y) -> spec e (either a x y) G.
Proof.
  intros X Y; split.
  - intros p [<-|[<-|[]]] H; simpl in *; inversion H; subst; auto. apply Y, anot_holds; trivial.
  - destruct (holds_dec e a).
    + exists ([a], x); split; [left; trivial|repeat constructor; trivial].
    + exists ([anot a], y); split; [right; left; trivial|].
      constructor; [apply anot_holds; trivial|constructor].
Qed.
Lemma spec_each {T U} e (ps : pieces T) (next : T -> pieces U) G (H : option U -> Prop) :
  spec e ps G -> (G None -> H None) -> (forall v, G (Some v) -> spec e (next v) H) ->
  spec e (each ps next) H.
Proof.
  intros [A E] N S.
  assert (B : forall p, In p ps -> all_hold e (fst p) ->
    spec e (match snd p with None => everywhere None | Some v => next v end) H).
  { intros p I P. specialize (A p I P). destruct (snd p); [apply S; trivial|].
    apply spec_everywhere; auto. }
  split.
  - intros r I R. apply in_flat_map in I as [p [Ip I]]. apply in_flat_map in I as [q [Iq I]].
    pose proof (joined_spec e (fst q) (fst p)) as J. destruct (joined (fst p) (fst q)); [|destruct I].
    destruct I as [<-|[]]. simpl in *. apply J in R as [P Q]. apply (proj1 (B p Ip P) q Iq Q).
  - destruct E as [p [Ip P]]. destruct (proj2 (B p Ip P)) as [q [Iq Q]].
    pose proof (joined_spec e (fst q) (fst p)) as J. destruct (joined (fst p) (fst q)) as [c|] eqn:C; [|tauto].
    exists (c, snd q); split; [|apply J; split; trivial].
    apply in_flat_map; exists p; split; trivial. apply in_flat_map; exists q; split; trivial.
    rewrite C; left; trivial.
Qed.
Lemma spec_both {T U V} e (ps : pieces T) (qs : pieces U) (next : T -> U -> pieces V) G K (H : option V -> Prop) :
  spec e ps G -> spec e qs K -> (G None -> H None) -> (forall x, G (Some x) -> K None -> H None) ->
  (forall x y, G (Some x) -> K (Some y) -> spec e (next x y) H) -> spec e (both ps qs next) H.
Proof.
  intros. apply spec_each with G; auto. intros x X. apply spec_each with K; auto. intro; eauto.
Qed.
Lemma spec_weaken {T} e (ps : pieces T) (G H : option T -> Prop) :
  spec e ps G -> (forall v, G v -> H v) -> spec e ps H.
Proof. intros [A B] I; split; auto. Qed.

(** * Expressions, where they are defined, and their regions *)

Inductive rel := Eq | Ne | Lt | Le | Gt | Ge.
Inductive expr :=
| Num (n : Z) (d : positive)
| Var (i : nat)
| Neg (a : expr)
| Add (a b : expr) | Sub (a b : expr) | Mul (a b : expr) | Div (a b : expr)
| Pow (a : expr) (n : nat)
| Abs (a : expr) | Min (a b : expr) | Max (a b : expr)
| Root (i : nat) (a : expr)
| If (l : expr) (r : rel) (m a b : expr)
| Slope (a d : expr)
| Undefined.
Record relation := Rel { lhs : expr; comparison : rel; rhs : expr }.

Definition num (n : Z) (d : positive) : R :=
  match d with xH => IZR n | _ => IZR n / IZR (Zpos d) end.
Definition related (r : rel) (x y : R) : Prop :=
  match r with
  | Eq => x = y | Ne => x <> y | Lt => x < y | Le => x <= y | Gt => x > y | Ge => x >= y
  end.
Definition choose (r : rel) (x y a b : R) : R :=
  match r with
  | Eq => if Req_EM_T x y then a else b | Ne => if Req_EM_T x y then b else a
  | Lt => if Rlt_dec x y then a else b | Le => if Rle_dec x y then a else b
  | Gt => if Rgt_dec x y then a else b | Ge => if Rge_dec x y then a else b
  end.
Fixpoint ev (l : list R) (e : expr) : R :=
  match e with
  | Num n d => num n d
  | Var i => nth i l 0
  | Neg a => - ev l a
  | Add a b => ev l a + ev l b | Sub a b => ev l a - ev l b
  | Mul a b => ev l a * ev l b | Div a b => ev l a / ev l b
  | Pow a n => ev l a ^ n
  | Abs a => Rabs (ev l a) | Min a b => Rmin (ev l a) (ev l b) | Max a b => Rmax (ev l a) (ev l b)
  | Root i _ => nth i l 0
  | If x r y a b => choose r (ev l x) (ev l y) (ev l a) (ev l b)
  | Slope _ d => ev l d
  | Undefined => 0
  end.
Fixpoint conj (l : list Prop) : Prop :=
  match l with [] => True | [p] => p | p :: l' => p /\ conj l' end.
Definition arrow (l : list Prop) (p : Prop) : Prop := match l with [] => p | _ => conj l -> p end.
Definition branch (p : Prop) (l : list Prop) : list Prop :=
  match l with [] => [] | _ => [p -> conj l] end.
Definition divides (l : list R) (b : expr) (v : R) : list Prop :=
  match b with Num (Zpos _) _ | Num (Zneg _) _ => [] | _ => [v <> 0] end.
(** The conditions under which an expression is defined; a number other than 0 divides. *)
Fixpoint conds (l : list R) (e : expr) : list Prop :=
  match e with
  | Num _ _ | Var _ => []
  | Neg a | Pow a _ | Abs a => conds l a
  | Add a b | Sub a b | Mul a b | Min a b | Max a b | Slope a b => conds l a ++ conds l b
  | Div a b => conds l a ++ conds l b ++ divides l b (ev l b)
  | Root _ a => conds l a ++ [0 <= ev l a]
  | If x r y a b => conds l x ++ conds l y ++
      branch (related r (ev l x) (ev l y)) (conds l a) ++
      branch (~ related r (ev l x) (ev l y)) (conds l b)
  | Undefined => [False]
  end.
Definition total (l : list R) (e : expr) : Prop := conj (conds l e).

Definition frac := (poly * poly)%type.
Definition fadd (x y : frac) : frac :=
  if peqb (snd x) (snd y) then (padd (fst x) (fst y), snd x)
  else (padd (pmul (fst x) (snd y)) (pmul (fst y) (snd x)), pmul (snd x) (snd y)).
Definition fneg (x : frac) : frac := (pneg (fst x), snd x).
Definition fmul (x y : frac) : frac := (pmul (fst x) (fst y), pmul (snd x) (snd y)).
Definition sign_poly (x : frac) : poly :=
  match as_const (snd x) with
  | Some c => pscale (Z.sgn c) (fst x) | None => pmul (fst x) (snd x)
  end.
Definition compare (r : rel) (x y : frac) : pieces bool :=
  let gap := match r with Lt | Le => fadd y (fneg x) | _ => fadd x (fneg y) end in
  let a := match r with
    | Eq => A (fst gap) SZ | Ne => A (fst gap) SNZ
    | Lt | Gt => A (sign_poly gap) SP | Le | Ge => A (sign_poly gap) SNN
    end in
  either a (Some true) (Some false).
(** The larger side of an inequality is looked at first. *)
Definition compared (r : rel) (ps qs : pieces frac) : pieces bool :=
  match r with
  | Lt | Le => both qs ps (fun y x => compare r x y) | _ => both ps qs (compare r)
  end.
Definition value (x : frac) : pieces frac := everywhere (Some x).

(** [off] variables come before those of expressions: t and limits. *)
Fixpoint regions (off : nat) (e : expr) : pieces frac :=
  match e with
  | Num n d => value (pconst n, pconst (Zpos d))
  | Var i => value (pvar (off + i), pone)
  | Neg a => each (regions off a) (fun x => value (fneg x))
  | Add a b => both (regions off a) (regions off b) (fun x y => value (fadd x y))
  | Sub a b => both (regions off a) (regions off b) (fun x y => value (fadd x (fneg y)))
  | Mul a b => both (regions off a) (regions off b) (fun x y => value (fmul x y))
  | Div a b => both (regions off a) (regions off b) (fun x y =>
      either (A (fst y) SNZ) (Some (pmul (fst x) (snd y), pmul (snd x) (fst y))) None)
  | Pow a n => each (regions off a) (fun x => value (ppow (fst x) n, ppow (snd x) n))
  | Abs a => each (regions off a) (fun x => either (A (sign_poly x) SNN) (Some x) (Some (fneg x)))
  | Min a b => both (regions off a) (regions off b) (fun x y =>
      either (A (sign_poly (fadd y (fneg x))) SNN) (Some x) (Some y))
  | Max a b => both (regions off a) (regions off b) (fun x y =>
      either (A (sign_poly (fadd x (fneg y))) SNN) (Some x) (Some y))
  | Root i a => each (regions off a) (fun x =>
      let s := pvar (off + i) in
      let a := A (sign_poly x) SNN in
      [([a; A s SNN; A (psub (pmul (pmul s s) (snd x)) (fst x)) SZ], Some (s, pone)); ([anot a], None)])
  | If x r y a b =>
      each (compared r (regions off x) (regions off y))
        (fun t : bool => if t then regions off a else regions off b)
  | Slope a d => each (regions off a) (fun _ => regions off d)
  | Undefined => everywhere None
  end.
Definition truth (off : nat) (r : relation) : pieces bool :=
  compared (comparison r) (regions off (lhs r)) (regions off (rhs r)).

Lemma conj_all l : conj l <-> Forall (fun p : Prop => p) l.
Proof.
  induction l as [|p [|q l] IH]; simpl in *.
  - split; auto.
  - split; intro H; [repeat constructor; trivial|inversion H; trivial].
  - rewrite Forall_cons_iff, <- IH; tauto.
Qed.
Lemma conj_app l m : conj (l ++ m) <-> conj l /\ conj m.
Proof. rewrite !conj_all. apply Forall_app. Qed.
Lemma conj_cons p l : conj (p :: l) <-> p /\ conj l.
Proof. rewrite !conj_all. apply Forall_cons_iff. Qed.
Lemma conj_one (p : Prop) : conj [p] <-> p.
Proof. simpl; tauto. Qed.
Lemma conj_branch p l : conj (branch p l) <-> (p -> conj l).
Proof. destruct l; simpl; tauto. Qed.
Lemma arrow_imp l p : arrow l p <-> (conj l -> p).
Proof. destruct l; simpl; tauto. Qed.
Lemma choose_spec r x y a b :
  (related r x y -> choose r x y a b = a) /\ (~ related r x y -> choose r x y a b = b).
Proof.
  destruct r; simpl; try destruct Req_EM_T; try destruct Rlt_dec; try destruct Rle_dec;
    try destruct Rgt_dec; try destruct Rge_dec; split; intro; trivial; lra.
Qed.
Lemma num_eq n d : num n d * IZR (Zpos d) = IZR n.
Proof. unfold num; destruct d; try (field; apply not_0_IZR; discriminate); ring. Qed.

Definition stands (e : nat -> R) (v : R) (x : frac) : Prop :=
  peval e (snd x) <> 0 /\ v * peval e (snd x) = peval e (fst x).
Lemma stands_add e u v x y : stands e u x -> stands e v y -> stands e (u + v) (fadd x y).
Proof.
  intros [D N] [F G]. unfold fadd, stands. destruct (peqb (snd x) (snd y)) eqn:E; simpl.
  - apply peqb_eq in E. rewrite peval_add, <- N, <- G, <- E in *. split; trivial. rewrite E; ring.
  - rewrite peval_add, !peval_mul, <- N, <- G. split; [apply Rmult_integral_contrapositive; auto|ring].
Qed.
Lemma stands_neg e u x : stands e u x -> stands e (- u) (fneg x).
Proof. intros [D N]. unfold stands; simpl. rewrite peval_neg, <- N. split; trivial. ring. Qed.
Lemma stands_sub e u v x y : stands e u x -> stands e v y -> stands e (u - v) (fadd x (fneg y)).
Proof. intros. apply stands_add; trivial. apply stands_neg; trivial. Qed.
Lemma stands_sign e v x : stands e v x -> exists k, 0 < k /\ peval e (sign_poly x) = k * v.
Proof.
  intros [D N]. unfold sign_poly. destruct (as_const (snd x)) as [c|] eqn:E.
  - pose proof (as_const_eval e _ _ E) as C. rewrite C in *. rewrite peval_scale, <- N.
    destruct (Z.sgn_spec c) as [[H ->]|[[H ->]|[H ->]]].
    + exists (IZR c). split; [apply IZR_lt; trivial|ring].
    + subst; lra.
    + exists (- IZR c). split; [apply IZR_lt in H; lra|]. change (IZR (- (1))) with (-1). ring.
  - exists (peval e (snd x) * peval e (snd x)). rewrite peval_mul, <- N.
    split; [destruct (Rdichotomy _ _ D); nra|ring].
Qed.

Lemma pos_mult k v : 0 < k -> (0 < k * v <-> 0 < v) /\ (0 <= k * v <-> 0 <= v).
Proof.
  intro K; split; split; intro H.
  - apply Rmult_lt_reg_l with k; trivial; rewrite Rmult_0_r; trivial.
  - apply Rmult_lt_0_compat; trivial.
  - apply Rmult_le_reg_l with k; trivial; rewrite Rmult_0_r; trivial.
  - apply Rmult_le_pos; lra.
Qed.
Lemma compare_spec e r u v x y : stands e u x -> stands e v y ->
  spec e (compare r x y) (fun b => match b with
    | Some true => related r u v | Some false => ~ related r u v | None => False end).
Proof.
  intros X Y. unfold compare.
  pose proof (stands_sub _ _ _ _ _ X Y) as S. pose proof (stands_sub _ _ _ _ _ Y X) as T.
  pose proof (stands_sign _ _ _ S) as [k [K SK]]. pose proof (stands_sign _ _ _ T) as [j [J TJ]].
  destruct (pos_mult k (u - v) K), (pos_mult j (v - u) J).
  destruct S as [D N].
  assert (Z : peval e (fst (fadd x (fneg y))) = 0 <-> u = v).
  { rewrite <- N. split; [|intro; subst; ring]. intro Q. apply Rmult_integral in Q as [Q|Q]; [lra|tauto]. }
  destruct r; apply spec_either; unfold holds; simpl; rewrite ?SK, ?TJ, ?Z; lra.
Qed.

(** The list of values of an expression's variables, inside the values of all variables. *)
Definition agrees (off : nat) (e : nat -> R) (l : list R) : Prop := forall i, e (off + i)%nat = nth i l 0.
(** Variables of square roots have their values. *)
Fixpoint rooted (l : list R) (e : expr) : Prop :=
  match e with
  | Num _ _ | Var _ | Undefined => True
  | Neg a | Pow a _ | Abs a => rooted l a
  | Add a b | Sub a b | Mul a b | Div a b | Min a b | Max a b | Slope a b => rooted l a /\ rooted l b
  | Root i a => (0 <= ev l a -> 0 <= nth i l 0 /\ nth i l 0 * nth i l 0 = ev l a) /\ rooted l a
  | If x _ y a b => rooted l x /\ rooted l y /\ rooted l a /\ rooted l b
  end.
Definition is_value (e : nat -> R) (l : list R) (a : expr) (x : option frac) : Prop :=
  match x with Some x => total l a /\ stands e (ev l a) x | None => ~ total l a end.

Lemma divides_spec l b : conj (divides l b (ev l b)) <-> ev l b <> 0.
Proof.
  assert (N : forall n d, n <> 0%Z -> num n d <> 0).
  { intros n d H K. apply H, eq_IZR. rewrite <- (num_eq n d), K. apply Rmult_0_l. }
  destruct b as [[|n|n] d| | | | | | | | | | | | | |]; simpl; try tauto;
    (split; [intros _; apply N; discriminate|trivial]).
Qed.
Lemma stands_num e n d : stands e (num n d) (pconst n, pconst (Zpos d)).
Proof.
  unfold stands; cbn [fst snd]. rewrite !peval_const, num_eq. split; [apply not_0_IZR; discriminate|trivial].
Qed.
Lemma stands_var e i : stands e (e i) (pvar i, pone).
Proof. unfold stands; cbn [fst snd]. unfold pone. rewrite peval_var, peval_const. split; [lra|ring]. Qed.

Lemma compared_spec e l r a b ps qs : spec e ps (is_value e l a) -> spec e qs (is_value e l b) ->
  spec e (compared r ps qs) (fun t => match t with
    | Some true => total l a /\ total l b /\ related r (ev l a) (ev l b)
    | Some false => total l a /\ total l b /\ ~ related r (ev l a) (ev l b)
    | None => ~ (total l a /\ total l b) end).
Proof.
  intros P Q.
  assert (C : forall x y, is_value e l a (Some x) -> is_value e l b (Some y) ->
    spec e (compare r x y) (fun t => match t with
      | Some true => total l a /\ total l b /\ related r (ev l a) (ev l b)
      | Some false => total l a /\ total l b /\ ~ related r (ev l a) (ev l b)
      | None => ~ (total l a /\ total l b) end)).
  { intros x y [C S] [D T]. eapply spec_weaken; [apply compare_spec; eassumption|].
    intros [[|]|]; tauto. }
  unfold compared. destruct r;
    (eapply spec_both; [eassumption|eassumption| | |]; unfold is_value at 1; try tauto;
     intros; try (unfold is_value in *; tauto); apply C; trivial).
Qed.
Lemma spec_operands e l a b c ps qs next :
  spec e ps (is_value e l a) -> spec e qs (is_value e l b) -> (total l c -> total l a /\ total l b) ->
  (forall x y, total l a /\ stands e (ev l a) x -> total l b /\ stands e (ev l b) y ->
    spec e (next x y) (is_value e l c)) -> spec e (both ps qs next) (is_value e l c).
Proof.
  intros P Q C N. eapply spec_both; [exact P|exact Q| | |]; simpl; intros; try tauto. apply N; trivial.
Qed.

Lemma regions_spec off e l a : agrees off e l -> rooted l a -> spec e (regions off a) (is_value e l a).
Proof.
  intro AG. induction a; simpl; intro RT;
    repeat match goal with H : _ /\ _ |- _ => destruct H end;
    repeat match goal with H : ?P -> spec _ _ _, G : ?P |- _ => specialize (H G) end.
  - apply spec_everywhere. split; [exact I|apply stands_num].
  - apply spec_everywhere. split; [exact I|]. cbn [ev]. rewrite <- AG. apply stands_var.
  - apply spec_each with (is_value e l a); trivial. intros x [C S]. apply spec_everywhere.
    split; [trivial|apply stands_neg; trivial].
  - apply spec_operands with a1 a2; trivial; unfold total; cbn [conds]; [rewrite !conj_app; tauto|].

    intros x y [C S] [D T]; apply spec_everywhere. unfold is_value, total; cbn [conds ev].
    rewrite conj_app. split; [tauto|]. apply stands_add; trivial.
  - apply spec_operands with a1 a2; trivial; unfold total; cbn [conds]; [rewrite !conj_app; tauto|].

    intros x y [C S] [D T]; apply spec_everywhere. unfold is_value, total; cbn [conds ev].
    rewrite conj_app. split; [tauto|]. apply stands_sub; trivial.
  - apply spec_operands with a1 a2; trivial; unfold total; cbn [conds]; [rewrite !conj_app; tauto|].

    intros x y [C [D N]] [F [G M]]; apply spec_everywhere. unfold is_value, total; cbn [conds ev].
    rewrite conj_app. split; [tauto|].
    unfold stands; simpl; rewrite !peval_mul, <- N, <- M.
    split; [apply Rmult_integral_contrapositive; auto|ring].
  - apply spec_operands with a1 a2; trivial; unfold total; cbn [conds]; [rewrite !conj_app; tauto|].

    intros x y [C [D N]] [F [G M]]. apply spec_either; unfold holds; simpl; intro Q0; unfold is_value, total; cbn [conds ev]; rewrite !conj_app.
    + assert (V : ev l a2 <> 0) by (intro V; apply Q0; rewrite <- M, V; ring).
      rewrite divides_spec. split; [tauto|]. unfold stands; simpl; rewrite !peval_mul, <- N, <- M.
      split; [repeat apply Rmult_integral_contrapositive_currified; trivial|field; trivial].
    + rewrite divides_spec. intros [_ [_ V]]. apply Q0. rewrite <- M. apply Rmult_integral_contrapositive_currified; trivial.
  - apply spec_each with (is_value e l a); trivial. intros x [C [D N]]. apply spec_everywhere.
    split; [trivial|]. unfold stands; simpl. rewrite !peval_pow, <- N.
    split; [apply pow_nonzero; trivial|rewrite Rpow_mult_distr; trivial].
  - apply spec_each with (is_value e l a); trivial. intros x [C S].
    pose proof (stands_sign _ _ _ S) as [k [K SK]]. destruct (pos_mult k (ev l a) K) as [_ P].
    apply spec_either; unfold holds; simpl; rewrite SK, P; intro Q0; (split; [trivial|]); simpl.
    + rewrite Rabs_pos_eq; trivial.
    + rewrite Rabs_left by lra. apply stands_neg; trivial.
  - apply spec_operands with a1 a2; trivial; unfold total; cbn [conds]; [rewrite !conj_app; tauto|].

    intros x y [C S] [D T].
    pose proof (stands_sign _ _ _ (stands_sub _ _ _ _ _ T S)) as [k [K SK]].
    destruct (pos_mult k (ev l a2 - ev l a1) K) as [_ P].
    apply spec_either; unfold holds; simpl; rewrite SK, P; intro Q0;
      unfold is_value, total; cbn [conds ev]; rewrite conj_app; (split; [tauto|]).
    + rewrite Rmin_left by lra; trivial.
    + rewrite Rmin_right by lra; trivial.
  - apply spec_operands with a1 a2; trivial; unfold total; cbn [conds]; [rewrite !conj_app; tauto|].

    intros x y [C S] [D T].
    pose proof (stands_sign _ _ _ (stands_sub _ _ _ _ _ S T)) as [k [K SK]].
    destruct (pos_mult k (ev l a1 - ev l a2) K) as [_ P].
    apply spec_either; unfold holds; simpl; rewrite SK, P; intro Q0;
      unfold is_value, total; cbn [conds ev]; rewrite conj_app; (split; [tauto|]).
    + rewrite Rmax_left by lra; trivial.
    + rewrite Rmax_right by lra; trivial.
  - apply spec_each with (is_value e l a); trivial.
    { unfold is_value, total; cbn [conds]; rewrite conj_app; tauto. }
    intros x [C S]. pose proof (stands_sign _ _ _ S) as [k [K SK]]. destruct (pos_mult k (ev l a) K) as [_ P].
    assert (E : peval e (pvar (off + i)) = nth i l 0) by (rewrite peval_var, AG; trivial).
    match goal with H : 0 <= ev l a -> _ |- _ => rename H into SQ end.
    assert (Q : 0 <= ev l a ->
      peval e (psub (pmul (pmul (pvar (off + i)) (pvar (off + i))) (snd x)) (fst x)) = 0).
    { intro Q. rewrite peval_sub, !peval_mul, E, (proj2 (SQ Q)). destruct S as [_ N]. lra. }
    split.
    + intros p [<-|[<-|[]]] Q0; cbn [fst snd] in *.
      * apply Forall_cons_iff in Q0 as [H1 H2]. unfold holds in H1; cbn [asign apoly] in H1. rewrite SK, P in H1.
        unfold is_value, total; cbn [conds]. rewrite conj_app. split; [simpl; tauto|].
        cbn [ev]. rewrite <- AG. apply stands_var.
      * apply Forall_cons_iff in Q0 as [H1 H2]. apply anot_holds in H1. unfold holds in H1; cbn [asign apoly] in H1.
        rewrite SK, P in H1. unfold is_value, total; cbn [conds]; rewrite conj_app; simpl; tauto.
    + destruct (Rle_dec 0 (ev l a)) as [Q0|Q0].
      * eexists; split; [left; reflexivity|].
        cbn [fst]. repeat apply Forall_cons; try apply Forall_nil; unfold holds; cbn [asign apoly].
        -- rewrite SK, P; trivial.
        -- rewrite E; apply SQ; trivial.
        -- apply Q; trivial.
      * eexists; split; [right; left; reflexivity|].
        cbn [fst]. repeat apply Forall_cons; try apply Forall_nil. apply anot_holds. unfold holds; cbn [asign apoly].
        rewrite SK, P; trivial.
  - apply spec_each with (fun b => match b with
      | Some true => total l a1 /\ total l a2 /\ related r (ev l a1) (ev l a2)
      | Some false => total l a1 /\ total l a2 /\ ~ related r (ev l a1) (ev l a2)
      | None => ~ (total l a1 /\ total l a2) end).
    + apply compared_spec; trivial.
    + unfold is_value, total; cbn [conds]; rewrite !conj_app; tauto.
    + destruct (choose_spec r (ev l a1) (ev l a2) (ev l a3) (ev l a4)) as [Y N].
      intros [|] [C [D T]]; [specialize (Y T)|specialize (N T)].
      * eapply spec_weaken; [eassumption|].
        intros [x|]; unfold is_value, total; cbn [conds ev]; rewrite ?Y, !conj_app, !conj_branch; tauto.
      * eapply spec_weaken; [eassumption|].
        intros [x|]; unfold is_value, total; cbn [conds ev]; rewrite ?N, !conj_app, !conj_branch; tauto.
  - apply spec_each with (is_value e l a1); trivial.
    + unfold is_value, total; cbn [conds]; rewrite conj_app; tauto.
    + intros x [C S]. eapply spec_weaken; [eassumption|].
      intros [y|]; unfold is_value, total; cbn [conds ev]; rewrite conj_app; tauto.
  - apply spec_everywhere. unfold is_value, total; simpl; tauto.
Qed.

Definition defined_rel (l : list R) (r : relation) : Prop := total l (lhs r) /\ total l (rhs r).
Definition says (l : list R) (r : relation) : Prop := related (comparison r) (ev l (lhs r)) (ev l (rhs r)).
Definition rooted_rel (l : list R) (r : relation) : Prop := rooted l (lhs r) /\ rooted l (rhs r).
Definition is_truth (l : list R) (r : relation) (b : option bool) : Prop :=
  match b with
  | Some true => defined_rel l r /\ says l r | Some false => defined_rel l r /\ ~ says l r
  | None => ~ defined_rel l r
  end.
Lemma truth_spec off e l r : agrees off e l -> rooted_rel l r -> spec e (truth off r) (is_truth l r).
Proof.
  intros AG [X Y]. unfold truth. eapply spec_weaken.
  - apply compared_spec; apply regions_spec; eassumption.
  - unfold is_truth, defined_rel, says. intros [[|]|]; tauto.
Qed.

(** * Sentences and goals *)

Definition select {T} (f : option T -> bool) (ps : pieces T) : cases :=
  map fst (filter (fun p => f (snd p)) ps).
Lemma select_spec {T} e (ps : pieces T) G f (P : Prop) :
  spec e ps G -> (forall v, G v -> (f v = true <-> P)) -> (P <-> some_case e (select f ps)).
Proof.
  intros [A [p [I H]]] F; split.
  - intro Q. exists (fst p); split; trivial. apply in_map, filter_In. split; trivial.
    apply (F (snd p)); auto.
  - intros [a [J K]]. apply in_map_iff in J as [q [<- J]]. apply filter_In in J as [J L].
    apply (F (snd q)); auto.
Qed.
Lemma spec_some {T} e (ps : pieces T) G : spec e ps G -> exists v, G v.
Proof. intros [A [p [I H]]]. eauto. Qed.

Fixpoint truths (off : nat) (rs : list relation) : pieces bool :=
  match rs with
  | [] => everywhere (Some true)
  | r :: rs => each (truth off r) (fun t : bool => if t then truths off rs else everywhere (Some false))
  end.
Definition conds_rel (l : list R) (r : relation) : list Prop := conds l (lhs r) ++ conds l (rhs r).
Fixpoint flat (l : list R) (rs : list relation) : list Prop :=
  match rs with [] => [] | r :: rs => conds_rel l r ++ says l r :: flat l rs end.
(** What relations say where they are defined, read from left to right. *)
Fixpoint spoken (l : list R) (rs : list relation) : Prop :=
  match rs with
  | [] => True | [r] => arrow (conds_rel l r) (says l r)
  | r :: rs => arrow (conds_rel l r) (says l r /\ spoken l rs)
  end.
Definition rooted_all (l : list R) (rs : list relation) : Prop := Forall (rooted_rel l) rs.
Lemma flat_cons l r rs : conj (flat l (r :: rs)) <-> defined_rel l r /\ says l r /\ conj (flat l rs).
Proof.
  unfold defined_rel, total. cbn [flat]. unfold conds_rel. rewrite !conj_app, conj_cons. tauto.
Qed.
Lemma spoken_cons l r rs : spoken l (r :: rs) <-> (defined_rel l r -> says l r /\ spoken l rs).
Proof.
  unfold defined_rel, total. destruct rs as [|q rs]; cbn [spoken]; rewrite arrow_imp; unfold conds_rel;
    rewrite conj_app; tauto.
Qed.
Lemma truths_spec off e l rs : agrees off e l -> rooted_all l rs ->
  spec e (truths off rs) (fun b => match b with
    | Some true => conj (flat l rs) /\ spoken l rs | Some false => ~ conj (flat l rs) /\ ~ spoken l rs
    | None => ~ conj (flat l rs) /\ spoken l rs end).
Proof.
  intros AG RT. induction RT as [|r rs X RT IH]; cbn [truths].
  - apply spec_everywhere. simpl; tauto.
  - apply spec_each with (is_truth l r); [apply truth_spec; trivial| |].
    + unfold is_truth. rewrite flat_cons, spoken_cons. tauto.
    + intros [|]; unfold is_truth; intros [D S].
      * eapply spec_weaken; [exact IH|]. intros [[|]|]; rewrite flat_cons, spoken_cons; tauto.
      * apply spec_everywhere. rewrite flat_cons, spoken_cons. tauto.
Qed.

Record sentence := Says { given : bool; when : list relation; links : list relation }.
Definition says_all (l : list R) (h : sentence) : Prop :=
  arrow (flat l (when h)) (if given h then conj (flat l (links h)) else spoken l (links h)).
Definition is_true (b : option bool) : bool := match b with Some b => b | None => false end.
Definition under (off : nat) (h : sentence) : pieces bool :=
  each (map (fun p => (fst p, Some (is_true (snd p)))) (truths off (when h)))
    (fun applies : bool => if applies then truths off (links h) else everywhere (Some true)).
Definition where_holds (off : nat) (h : sentence) (b : bool) : cases :=
  select (fun v => Bool.eqb (match v with Some b => b | None => negb (given h) end) b) (under off h).
Definition rooted_sentence l h := rooted_all l (when h) /\ rooted_all l (links h).

Lemma spec_map {T U} e (ps : pieces T) (f : option T -> option U) (G : option T -> Prop) (H : option U -> Prop) :
  spec e ps G -> (forall v, G v -> H (f v)) -> spec e (map (fun p => (fst p, f (snd p))) ps) H.
Proof.
  intros [A [p [I P]]] F; split.
  - intros q J Q. apply in_map_iff in J as [r [<- J]]. simpl in *. auto.
  - exists (fst p, f (snd p)); split; trivial. apply in_map_iff; eauto.
Qed.
Lemma under_spec off e l h : agrees off e l -> rooted_sentence l h ->
  spec e (under off h) (fun v =>
    ((match v with Some b => b | None => negb (given h) end) = true <-> says_all l h)).
Proof.
  intros AG [W L]. unfold under, says_all.
  apply spec_each with (fun b => match b with
    | Some true => conj (flat l (when h)) | Some false => ~ conj (flat l (when h)) | None => False end).
  - apply (spec_map e _ (fun v => Some (is_true v)) _ _ (truths_spec off e l _ AG W)).
    intros [[|]|]; simpl; tauto.
  - tauto.
  - intros [|] C.
    + eapply spec_weaken; [apply truths_spec; eassumption|].
      intros [[|]|]; rewrite arrow_imp; destruct (given h); simpl; intuition discriminate.
    + apply spec_everywhere. rewrite arrow_imp. tauto.
Qed.
Lemma holds_spec off e l h : agrees off e l -> rooted_sentence l h ->
  (says_all l h <-> some_case e (where_holds off h true)).
Proof.
  intros AG RT. unfold where_holds. apply select_spec with (1 := under_spec off e l h AG RT).
  intros v V. rewrite <- V. rewrite eqb_true_iff. tauto.
Qed.
Lemma fails_spec off e l h : agrees off e l -> rooted_sentence l h ->
  (~ says_all l h <-> some_case e (where_holds off h false)).
Proof.
  intros AG RT. unfold where_holds. apply select_spec with (1 := under_spec off e l h AG RT).
  intros v V. rewrite <- V. rewrite eqb_true_iff.
  destruct v as [[|]|]; destruct (given h); simpl; intuition congruence.
Qed.
Lemma says_all_dec l h e off : agrees off e l -> rooted_sentence l h -> says_all l h \/ ~ says_all l h.
Proof.
  intros AG RT. destruct (spec_some _ _ _ (under_spec off e l h AG RT)) as [v V]. rewrite <- V.
  destruct v as [[|]|]; destruct (given h); simpl; intuition congruence.
Qed.

(** What is concluded at a point. *)
Inductive conclusion :=
| Holds (r : relation) | IfDefined (r : relation) | Defined (r : relation)
| Sentence (h : sentence) | Falsehood.
Definition concludes (l : list R) (c : conclusion) : Prop :=
  match c with
  | Holds r => conj (conds_rel l r ++ [says l r])
  | IfDefined r => arrow (conds_rel l r) (says l r)
  | Defined r => conj (conds_rel l r)
  | Sentence h => says_all l h
  | Falsehood => False
  end.
Definition failure (off : nat) (c : conclusion) : list cases :=
  match c with
  | Holds r => [select (fun v => negb (is_true v)) (truth off r)]
  | IfDefined r => [select (fun v => match v with Some false => true | _ => false end) (truth off r)]
  | Defined r => [select (fun v => match v with None => true | _ => false end) (truth off r)]
  | Sentence h => [where_holds off h false]
  | Falsehood => []
  end.
Definition rooted_conclusion l c :=
  match c with
  | Holds r | IfDefined r | Defined r => rooted_rel l r | Sentence h => rooted_sentence l h | Falsehood => True
  end.
Lemma failure_spec off e l c : agrees off e l -> rooted_conclusion l c ->
  (~ concludes l c <-> Forall (some_case e) (failure off c)) /\ (concludes l c \/ ~ concludes l c).
Proof.
  intros AG. assert (O : forall x, Forall (some_case e) [x] <-> some_case e x).
  { intro x. rewrite Forall_cons_iff. pose proof (Forall_nil (some_case e)). tauto. }
  destruct c as [r|r|r|h|]; cbn [rooted_conclusion concludes failure]; intro RT; rewrite ?O.
  1-3: pose proof (truth_spec off e l r AG RT) as S;
    assert (C : conj (conds_rel l r) <-> defined_rel l r) by (apply conj_app).
  1-3: split; [apply select_spec with (1 := S)|destruct (spec_some _ _ _ S) as [v V]].
  1,3,5: intros v V.
  1-6: destruct v as [[|]|]; unfold is_truth in V;
    rewrite ?arrow_imp, ?conj_app, ?conj_one, ?C; simpl; intuition congruence.
  - split; [apply fails_spec; trivial|]. apply says_all_dec with e off; trivial.
  - pose proof (Forall_nil (some_case e)). tauto.
Qed.

(** * The rules of proof *)

Record term := T { weight : Z; square : poly; factors : list (nat * nat) }.
Record side := Side { point : option (Z * positive); above : bool }.
Inductive proof :=
| Absurd
| Assume (formula : nat) (each_case : list proof)
| Split (p : poly) (zero positive negative : proof)
| Substitute (equation var : nat) (lead : list (nat * nat)) (rest : proof)
| Cancel (a : nat) (by_ : list (nat * nat)) (quotient : poly) (rest : proof)
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

Fixpoint refute (pc : option passing) (fuel : nat) (fs : list cases) (st : atoms) (p : proof) : bool :=
  match fuel with O => false | S fuel =>
  match p with
  | Absurd => existsb (fun a => match decided a with Some false => true | _ => false end) st
  | Assume f ps =>
    (fix go (cs : cases) (ps : list proof) := match cs, ps with
     | [], [] => true
     | c :: cs, p :: ps => refute pc fuel fs (st ++ c) p && go cs ps
     | _, _ => false end) (nth f fs [[]]) ps
  | Split q z pos neg =>
    refute pc fuel fs (st ++ [A q SZ]) z && refute pc fuel fs (st ++ [A q SP]) pos &&
    refute pc fuel fs (st ++ [A (pneg q) SP]) neg
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
  | Cancel i by_ q rest =>
    let a := nth_atom st i in
    forallb (if is_order (asign a) then positive_factor st else nonzero_factor st) by_ &&
    peqb (prim (pmul (product st by_) q)) (prim (apoly a)) &&
    refute pc fuel fs (mapi (fun j b => if Nat.eqb j i then A q (asign a) else b) 0 st) rest
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
  intros fs st p env GS. destruct p as [|formula each_case|q z pos neg|equation var0 lead rest|a by_ quotient rest|terms cofactors
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
  - apply andb_true_iff in C as [C N]. apply andb_true_iff in C as [Z P].
    assert (W : forall a, holds env a -> all_hold env (st ++ [a])).
    { intros. apply Forall_app; split; trivial. apply Forall_cons; [trivial|apply Forall_nil]. }
    destruct (Rtotal_order (peval env q) 0) as [L|[L|L]].
    + apply (IH _ _ _ env GS N); trivial. apply W. unfold holds; simpl. rewrite peval_neg; lra.
    + apply (IH _ _ _ env GS Z); trivial. apply W. trivial.
    + apply (IH _ _ _ env GS P); trivial. apply W. unfold holds; simpl; lra.
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
  - apply andb_true_iff in C as [C R]. apply andb_true_iff in C as [Fs Q]. apply peqb_eq in Q.
    pose proof (nth_holds env st a H) as K.
    destruct (prim_eval env (pmul (product st by_) quotient)) as [g [Gp Ge]].
    destruct (prim_eval env (apoly (nth_atom st a))) as [h [Hp He]].
    rewrite peval_mul, Q in Ge.
    assert (V : peval env (apoly (nth_atom st a)) = h / g * peval env (product st by_) * peval env quotient).
    { rewrite He. replace (h / g * peval env (product st by_) * peval env quotient)
        with (h / g * (peval env (product st by_) * peval env quotient)) by ring. rewrite Ge. field; lra. }
    assert (HG : 0 < h / g) by (apply Rdiv_lt_0_compat; trivial).
    apply (IH _ _ _ env GS R); trivial. apply mapi_holds; trivial. intros i b Hb.
    destruct (Nat.eqb i a); trivial. unfold holds in *; cbn [asign apoly].
    destruct (asign (nth_atom st a)); cbn [is_order] in Fs; rewrite V in K.
    + pose proof (product_nonzero env st by_ H Fs). apply Rmult_integral in K as [K|K]; trivial.
      apply Rmult_integral in K as [K|K]; [lra|tauto].
    + intro Z; apply K; rewrite Z; ring.
    + pose proof (product_positive env st by_ H Fs). apply pos_mult in K; trivial. apply Rmult_lt_0_compat; trivial.
    + pose proof (product_positive env st by_ H Fs). apply pos_mult in K; trivial. apply Rmult_lt_0_compat; trivial.
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

(** * Claims at a point *)

Record goal := Goal {
  ranges : list relation; premises : list sentence; conditions : list relation; claim : conclusion
}.
Fixpoint imply (hs : list Prop) (c : Prop) : Prop :=
  match hs with [] => c | h :: hs => h -> imply hs c end.
Definition speaks (h : sentence) : bool := match links h with [] => false | _ => true end.
(** What a goal says of a point. *)
Definition states (g : goal) (l : list R) : Prop :=
  imply (map (says l) (ranges g) ++ map (says_all l) (filter speaks (premises g)))
    (arrow (flat l (conditions g)) (concludes l (claim g))).

Definition range_atoms (off : nat) (rs : list relation) : atoms :=
  flat_map (fun r => match select is_true (truth off r) with [a] => a | _ => [] end) rs.
Definition formulas (off : nat) (hs : list sentence) : list cases :=
  map (fun h => where_holds off h true) hs.
Definition where_all (off : nat) (rs : list relation) : cases := select is_true (truths off rs).

Fixpoint rootless (e : expr) : bool :=
  match e with
  | Num _ _ | Var _ | Undefined => true
  | Neg a | Pow a _ | Abs a => rootless a
  | Add a b | Sub a b | Mul a b | Div a b | Min a b | Max a b | Slope a b => rootless a && rootless b
  | Root _ _ => false
  | If x _ y a b => rootless x && rootless y && rootless a && rootless b
  end.
Definition rootless_rel (r : relation) := rootless (lhs r) && rootless (rhs r).
Definition rootless_sentence (h : sentence) := forallb rootless_rel (when h) && forallb rootless_rel (links h).
Definition rootless_goal (g : goal) : bool :=
  forallb rootless_rel (ranges g) && forallb rootless_sentence (premises g) &&
  forallb rootless_rel (conditions g) &&
  match claim g with
  | Holds r | IfDefined r | Defined r => rootless_rel r | Sentence h => rootless_sentence h | Falsehood => true
  end.
Definition rooted_goal (l : list R) (g : goal) : Prop :=
  rooted_all l (ranges g) /\ Forall (rooted_sentence l) (premises g) /\
  rooted_all l (conditions g) /\ rooted_conclusion l (claim g).
Ltac split_bools := repeat match goal with H : _ && _ = true |- _ => apply andb_true_iff in H as [? ?] end.
Lemma rootless_rooted l e : rootless e = true -> rooted l e.
Proof. induction e; simpl; intro H; split_bools; auto. discriminate. Qed.
Lemma rootless_rooted_rel l r : rootless_rel r = true -> rooted_rel l r.
Proof. unfold rootless_rel. intro H. split_bools. split; apply rootless_rooted; trivial. Qed.
Lemma rootless_rooted_all l rs : forallb rootless_rel rs = true -> rooted_all l rs.
Proof.
  intro H. apply Forall_forall. rewrite forallb_forall in H. intros. apply rootless_rooted_rel; auto.
Qed.
Lemma rootless_rooted_sentence l h : rootless_sentence h = true -> rooted_sentence l h.
Proof. unfold rootless_sentence. intro H. split_bools. split; apply rootless_rooted_all; trivial. Qed.
Lemma rootless_rooted_goal l g : rootless_goal g = true -> rooted_goal l g.
Proof.
  unfold rootless_goal. intro H. split_bools. repeat split; try (apply rootless_rooted_all; trivial).
  - apply Forall_forall. match goal with H : forallb rootless_sentence _ = true |- _ => rewrite forallb_forall in H end.
    intros. apply rootless_rooted_sentence; auto.
  - destruct (claim g); simpl; trivial; try (apply rootless_rooted_rel; trivial).
    apply rootless_rooted_sentence; trivial.
Qed.

Lemma imply_all hs c : imply hs c <-> (Forall (fun p : Prop => p) hs -> c).
Proof.
  induction hs as [|h hs IH]; simpl.
  - split; auto.
  - rewrite IH, Forall_cons_iff. tauto.
Qed.
Lemma Forall_props {X} (f : X -> Prop) l : Forall (fun p : Prop => p) (map f l) <-> Forall f l.
Proof. apply Forall_map. Qed.
(** Ranges compare a symbol with a number: both are defined. *)
Definition simple (r : relation) : bool :=
  match lhs r, rhs r with Var _, Num _ _ => true | _, _ => false end.
Lemma simple_defined l r : simple r = true -> defined_rel l r.
Proof.
  unfold simple, defined_rel, total. destruct (lhs r); try discriminate. destruct (rhs r); try discriminate.
  simpl; tauto.
Qed.
Lemma range_holds off e l r : agrees off e l -> rooted_rel l r -> simple r = true -> says l r ->
  all_hold e (match select is_true (truth off r) with [a] => a | _ => [] end).
Proof.
  intros AG RT Si S. pose proof (truth_spec off e l r AG RT) as T.
  assert (C : some_case e (select is_true (truth off r))).
  { apply (select_spec e _ _ is_true True T); trivial. intros v V. pose proof (simple_defined l r Si).
    unfold is_truth in V. destruct v as [[|]|]; simpl; tauto. }
  destruct C as [a [I H]]. destruct (select is_true (truth off r)) as [|b [|c cs]]; try constructor.
  destruct I as [->|[]]; trivial.
Qed.
Lemma ranges_hold off e l rs : agrees off e l -> rooted_all l rs -> forallb simple rs = true ->
  Forall (says l) rs -> all_hold e (range_atoms off rs).
Proof.
  intros AG RT Si S. unfold range_atoms. apply Forall_flat_map. rewrite Forall_forall in *.
  rewrite forallb_forall in Si. unfold rooted_all in RT. rewrite Forall_forall in RT.
  intros r I. apply range_holds with l; auto.
Qed.
Lemma formulas_hold off e l hs : agrees off e l -> Forall (rooted_sentence l) hs ->
  Forall (says_all l) (filter speaks hs) -> some_cases e (formulas off hs).
Proof.
  intros AG RT S. unfold formulas, some_cases. apply Forall_map. rewrite Forall_forall in *.
  intros h I. apply holds_spec with l; auto. destruct (speaks h) eqn:Sp.
  - apply S. apply filter_In; tauto.
  - unfold speaks in Sp. unfold says_all. destruct (links h); [|discriminate]. rewrite arrow_imp.
    destruct (given h); simpl; trivial.
Qed.
Lemma where_all_spec off e l rs : agrees off e l -> rooted_all l rs ->
  (conj (flat l rs) <-> some_case e (where_all off rs)).
Proof.
  intros AG RT. unfold where_all. apply select_spec with (1 := truths_spec off e l rs AG RT).
  intros [[|]|]; simpl; intuition congruence.
Qed.

Definition depth : nat := 400.
Definition point_state (off : nat) (g : goal) : atoms * list cases :=
  (range_atoms off (ranges g),
   formulas off (premises g) ++ [where_all off (conditions g)] ++ failure off (claim g)).
Definition accepted (g : goal) (p : proof) : bool :=
  forallb simple (ranges g) && (let s := point_state 0 g in refute None depth (snd s) (fst s) p).

Definition values (l : list R) : nat -> R := fun i => nth i l 0.

(** A goal whose opposite is refuted is true. *)
Theorem proved_rooted g p l : accepted g p = true -> rooted_goal l g -> states g l.
Proof.
  unfold accepted, states. intros C [RR [RP [RC RL]]]. apply andb_true_iff in C as [Si C].
  rewrite imply_all, arrow_imp. intros H W. apply Forall_app in H as [HR HP].
  apply (proj1 (Forall_props _ _)) in HR. apply (proj1 (Forall_props _ _)) in HP.
  assert (AG : agrees 0 (values l) l) by (intro; trivial).
  destruct (failure_spec 0 (values l) l (claim g) AG RL) as [F [|N]]; trivial.
  exfalso. apply (refute_sound None depth _ _ p (values l) I C).
  - apply ranges_hold with l; trivial.
  - cbn [snd point_state]. apply Forall_app; split; [apply formulas_hold with l; trivial|].
    apply Forall_app; split; [|apply F; trivial].
    apply Forall_cons; [apply where_all_spec with l; trivial|apply Forall_nil].
Qed.
Definition proves (g : goal) (p : proof) : bool := accepted g p && rootless_goal g.
Theorem proved g p l : proves g p = true -> states g l.
Proof. unfold proves. intro H. split_bools. apply proved_rooted with p; trivial. apply rootless_rooted_goal; trivial. Qed.

(** * Witnesses *)

Fixpoint horner (t : R) (cs : list Z) : R :=
  match cs with [] => 0 | c :: cs => IZR c + t * horner t cs end.
(** A coordinate of a point: a polynomial in one algebraic number, over a denominator. *)
Definition at_ (t : R) (cs : list Z) (d : positive) : R := horner t cs / IZR (Zpos d).
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
  rootless_goal g &&
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
Lemma pos_neq (d : positive) : IZR (Zpos d) <> 0. Proof. apply not_0_IZR; discriminate. Qed.
Lemma pos_pos (d : positive) : 0 < IZR (Zpos d). Proof. apply IZR_lt; reflexivity. Qed.
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
Lemma witness_holds w t : (forall e : nat -> R, e 0%nat = t -> all_hold e (root_atoms (theta w))) ->
  all_hold (values (t :: place w t)) (witness_atoms w).
Proof.
  intro T. apply Forall_app; split; [|apply T; trivial].
  set (e := values (t :: place w t)).
  assert (G : forall i cs, (forall j, e (S (i + j)) = nth j (map (fun c => at_ t (fst c) (snd c)) cs) 0) ->
    all_hold e (mapi (fun i c => fixes (S i) (fst c) (snd c)) i cs)).
  { intros i cs; revert i; induction cs as [|c cs IH]; intros i E; simpl; [constructor|].
    apply Forall_cons.
    - apply fixes_holds. specialize (E 0%nat). rewrite Nat.add_0_r in E. exact E.
    - apply IH. intro j. specialize (E (S j)). rewrite <- plus_n_Sm in E. exact E. }
  apply G. intro j. trivial.
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
Lemma refuted_there g w t : refuted_by g w = true ->
  (forall e : nat -> R, e 0%nat = t -> all_hold e (root_atoms (theta w))) -> ~ states g (place w t).
Proof.
  unfold refuted_by. intros C T0. split_bools. pose proof (witness_holds w t T0) as T.
  set (l := place w t) in *. set (e := values (t :: l)) in *.
  assert (AG : agrees 1 e l) by (intro; trivial).
  match goal with H : satisfied _ _ = true |- _ => pose proof (satisfied_sound _ _ e H T) as F end.
  match goal with H : rootless_goal g = true |- _ => destruct (rootless_rooted_goal l g H) as [RR [RP [RC RL]]] end.
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
(** A point with rational coordinates. *)
Definition refutes (g : goal) (w : witness) : bool :=
  refuted_by g w && match theta w with None => true | _ => false end.
Theorem refuted g w : refutes g w = true ->
  ~ states g (place w 0).
Proof.
  unfold refutes. intro C. split_bools. apply refuted_there; trivial. destruct (theta w); [discriminate|]. constructor.
Qed.
(** A point at an algebraic number, which exists by the intermediate value theorem. *)
Definition refutes_at_root (g : goal) (w : witness) : bool := refuted_by g w && root_exists (theta w).
Theorem refuted_root g w : refutes_at_root g w = true -> exists t, ~ states g (place w t).
Proof.
  unfold refutes_at_root. intro C. split_bools. match goal with H : root_exists _ = true |- _ => destruct (root_found _ H) as [t T] end.
  exists t. apply refuted_there; trivial.
Qed.

(** * Limits *)

(** What holds close to a point on one side of it, or far out. *)
Definition near (s : side) (Q : R -> Prop) : Prop :=
  match point s, above s with
  | Some (n, d), true => exists delta, delta > 0 /\ forall x, num n d < x < num n d + delta -> Q x
  | Some (n, d), false => exists delta, delta > 0 /\ forall x, num n d - delta < x < num n d -> Q x
  | None, true => exists bound, forall x, x > bound -> Q x
  | None, false => exists bound, forall x, x < bound -> Q x
  end.
Definition germ_point (s : side) (t : R) : R :=
  match point s, above s with
  | Some (n, d), true => num n d + t | Some (n, d), false => num n d - t
  | None, true => / t | None, false => - / t
  end.
Definition small (Q : R -> Prop) : Prop := exists d, 0 < d /\ forall t, 0 < t < d -> Q t.
Lemma small_and P Q : small P -> small Q -> small (fun t => P t /\ Q t).
Proof.
  intros [c [C F]] [d [D G]]. exists (Rmin c d). split; [apply Rmin_glb_lt; trivial|].
  intros t T. pose proof (Rmin_l c d). pose proof (Rmin_r c d). split; [apply F|apply G]; lra.
Qed.
Lemma small_weaken (P Q : R -> Prop) : small P -> (forall t, 0 < t -> P t -> Q t) -> small Q.
Proof. intros [c [C F]] W. exists c. split; trivial. intros t T. apply W; [lra|auto]. Qed.
Lemma small_all {X} (l : list X) (P : X -> R -> Prop) : (forall x, In x l -> small (P x)) ->
  small (fun t => forall x, In x l -> P x t).
Proof.
  induction l as [|x l IH]; intro H.
  - exists 1. split; [lra|]. intros t _ x [].
  - destruct (small_and _ _ (H x (or_introl eq_refl)) (IH (fun y I => H y (or_intror I)))) as [d [D F]].
    exists d. split; trivial. intros t T y [<-|J]; destruct (F t T) as [G1 G2]; [exact G1|exact (G2 y J)].
Qed.
Lemma inv_big d t : 0 < t -> 0 < d -> t < / d -> d < / t.
Proof.
  intros T D L. rewrite <- (Rinv_inv d). apply Rinv_lt_contravar; trivial. apply Rmult_lt_0_compat; trivial.
  apply Rinv_0_lt_compat; trivial.
Qed.
Lemma near_small s Q : near s Q <-> small (fun t => Q (germ_point s t)).
Proof.
  unfold near, small, germ_point. destruct (point s) as [[n d]|], (above s); split; intros [c H].
  - destruct H as [C H]. exists c. split; [lra|]. intros t T. apply H; lra.
  - destruct H as [C H]. exists c. split; [lra|]. intros x X.
    replace x with (num n d + (x - num n d)) by ring. apply H; lra.
  - destruct H as [C H]. exists c. split; [lra|]. intros t T. apply H; lra.
  - destruct H as [C H]. exists c. split; [lra|]. intros x X.
    replace x with (num n d - (num n d - x)) by ring. apply H; lra.
  - assert (P : 0 < Rabs c + 1) by (pose proof (Rabs_pos c); lra).
    exists (/ (Rabs c + 1)). split; [apply Rinv_0_lt_compat; trivial|]. intros t [T U]. apply H.
    pose proof (inv_big _ t T P U). pose proof (Rle_abs c). lra.
  - destruct H as [C H]. exists (/ c). intros x X. pose proof (Rinv_0_lt_compat c C).
    rewrite <- (Rinv_inv x). apply H. split; [apply Rinv_0_lt_compat; lra|].
    rewrite <- (Rinv_inv c). apply Rinv_lt_contravar; trivial. apply Rmult_lt_0_compat; lra.
  - assert (P : 0 < Rabs c + 1) by (pose proof (Rabs_pos c); lra).
    exists (/ (Rabs c + 1)). split; [apply Rinv_0_lt_compat; trivial|]. intros t [T U]. apply H.
    pose proof (inv_big _ t T P U). pose proof (Rle_abs (- c)). rewrite Rabs_Ropp in *. lra.
  - destruct H as [C H]. exists (- / c). intros x X. pose proof (Rinv_0_lt_compat c C).
    replace x with (- / (/ - x)) by (rewrite Rinv_inv; ring). apply H. split; [apply Rinv_0_lt_compat; lra|].
    rewrite <- (Rinv_inv c). apply Rinv_lt_contravar; [apply Rmult_lt_0_compat; lra|]. lra.
Qed.
Lemma near_weaken s (P Q : R -> Prop) : near s P -> (forall x, P x -> Q x) -> near s Q.
Proof. rewrite !near_small. intros H W. apply (small_weaken _ _ H). auto. Qed.

Inductive target := Finite (v : expr) | PlusInf | MinusInf.
(** f is defined close to the point, and as close to its limit as one likes; the limit is read at [v]. *)
Definition reaches (l : R -> list R) (v : list R) (f : expr) (to : target) (s : side) : Prop :=
  match to with
  | Finite y => forall eps, eps > 0 ->
      near s (fun x => conj (conds (l x) f ++ [Rabs (ev (l x) f - ev v y) < eps]))
  | PlusInf => forall b, near s (fun x => conj (conds (l x) f ++ [ev (l x) f > b]))
  | MinusInf => forall b, near s (fun x => conj (conds (l x) f ++ [ev (l x) f < b]))
  end.
Definition tends (l : R -> list R) (v : list R) (f : expr) (to : target) (ss : list side) : list Prop :=
  match to with Finite y => conds v y | _ => [] end ++ map (reaches l v f to) ss.

(** A premise is about constants, about the limit variable alone, or about functions of it. *)
Inductive role := Everywhere | Narrows | Along.
Definition is_role (a b : role) : bool :=
  match a, b with Everywhere, Everywhere | Narrows, Narrows | Along, Along => true | _, _ => false end.
Definition premise_limit := option (list side * expr * expr).
Record family := Family {
  body : goal;
  more : list relation;
  variable : nat;
  fixed : list nat;
  roles : list role;
  always_when : bool;
  premised : list premise_limit
}.
Definition mem (i : nat) (l : list nat) : bool := existsb (Nat.eqb i) l.
Definition subject (r : relation) : nat := match lhs r with Var i => i | _ => 0%nat end.
Definition all_ranges (g : family) := ranges (body g) ++ more g.
Definition constant_ranges (g : family) := filter (fun r => mem (subject r) (fixed g)) (all_ranges g).
Definition variable_ranges (g : family) :=
  filter (fun r => negb (mem (subject r) (fixed g)) && Nat.eqb (subject r) (variable g)) (all_ranges g).
Definition function_ranges (g : family) :=
  filter (fun r => negb (mem (subject r) (fixed g)) && negb (Nat.eqb (subject r) (variable g))) (all_ranges g).
Definition roled (g : family) := combine (roles g) (premises (body g)).
Definition with_role (r : role) (g : family) : list sentence :=
  map snd (filter (fun q => is_role r (fst q) && speaks (snd q)) (roled g)).
Definition premise_tends (l : R -> list R) (v : list R) (q : premise_limit) : list Prop :=
  match q with Some (ss, f, y) => [conj (tends l v f (Finite y) ss)] | None => [] end.

(** What is supposed: of constants; in the domain; of functions there. *)
Definition constantly (g : family) (l : R -> list R) (p : R) : list Prop :=
  map (says (l p)) (constant_ranges g) ++ map (says_all (l p)) (with_role Everywhere g) ++
  (if always_when g then match conditions (body g) with [] => [] | rs => [conj (flat (l p) rs)] end else []) ++
  flat_map (premise_tends l (l p)) (premised g).
Definition domain (g : family) (l : R -> list R) (p : R) : list Prop :=
  map (says (l p)) (variable_ranges g) ++ map (says_all (l p)) (with_role Narrows g).
Definition functionally (g : family) (l : R -> list R) : list Prop :=
  match function_ranges g with
  | [] => []
  | rs => [forall x, imply (map (says (l x)) (variable_ranges g)) (conj (map (says (l x)) rs))]
  end ++
  map (fun h => forall x, imply (domain g l x) (says_all (l x) h)) (with_role Along g).
Definition states_limit (g : family) (l : R -> list R) (f : expr) (to : target) (ss : list side) : Prop :=
  imply (constantly g l 0 ++ functionally g l) (conj (tends l (l 0) f to ss)).
Definition states_point (g : family) (l : R -> list R) : Prop :=
  imply (constantly g l 0 ++ functionally g l)
    (forall x, imply (domain g l x)
      (arrow (if always_when g then [] else flat (l x) (conditions (body g))) (concludes (l x) (claim (body g))))).

(** ** What is known at a point, of constants, and along a germ *)

Definition offset (g : family) : nat := S (length (premised g)).
Definition stands_for (off : nat) (f : expr) (num den : poly) : pieces bool :=
  each (regions off f) (fun v =>
    either (A (psub (pmul den (fst v)) (pmul num (snd v))) SZ) (Some true) (Some false)).
Definition equals (off : nat) (f : expr) (num den : poly) : cases := select is_true (stands_for off f num den).
Definition differs (off : nat) (f : expr) (num den : poly) : cases :=
  select (fun v => negb (is_true v)) (stands_for off f num den).
Definition nothing : cases := [[]].
Definition has_side (s : side) (ss : list side) : bool := existsb (seqb_side s) ss.
Definition value_cases (off : nat) (i : nat) (q : premise_limit) : cases :=
  match q with Some (_, _, v) => equals off v (pvar (S i)) pone | None => nothing end.
Definition function_cases (off : nat) (s : side) (i : nat) (q : premise_limit) : cases :=
  match q with Some (ss, f, _) => if has_side s ss then equals off f (pvar (S i)) pone else nothing | None => nothing end.
Definition free_formulas (g : family) (limits : list cases) : list cases :=
  map (fun q => if is_role Everywhere (fst q) then where_holds (offset g) (snd q) true else nothing) (roled g) ++
  limits ++
  [if always_when g then where_all (offset g) (conditions (body g)) else nothing].
Definition constant_formulas (g : family) : list cases :=
  free_formulas g (mapi (value_cases (offset g)) 0 (premised g)).
Definition leaving (g : family) : list cases :=
  constant_formulas g ++ [flat_map (fun h => where_holds (offset g) h false) (with_role Narrows g)].
Definition germ_formulas (g : family) (s : side) : list cases :=
  formulas (offset g) (premises (body g)) ++
  mapi (function_cases (offset g) s) 0 (premised g) ++
  [if always_when g then where_all (offset g) (conditions (body g)) else nothing].
Definition point_formulas (g : family) : list cases :=
  formulas (offset g) (premises (body g)) ++ mapi (value_cases (offset g)) 0 (premised g) ++
  [where_all (offset g) (conditions (body g))] ++ failure (offset g) (claim (body g)).
Definition known_limits (g : family) (s : side) : list nat :=
  flat_map (fun l : list nat => l) (mapi (fun i q => match q with
    | Some (ss, _, _) => if has_side s ss then [S i] else [] | None => [] end) 0 (premised g)).
Definition passing_of (g : family) (used : list side) : passing :=
  Passing (map (Nat.add (offset g)) (fixed g)) (offset g + variable g)
    (range_atoms (offset g) (all_ranges g)) (leaving g)
    (map (fun s => (s, (known_limits g s, germ_formulas g s))) used).

(** A declared range that reaches up to the limit on this side. *)
Definition side_within (s : side) (r : relation) : bool :=
  match rhs r, point s with
  | Num m c, None => match comparison r, above s with
      | Gt, true | Ge, true | Lt, false | Le, false => true | _, _ => false end
  | Num m c, Some (n, d) => match comparison r, above s with
      | Gt, true | Ge, true => Z.leb (m * Zpos d) (n * Zpos c)
      | Gt, false | Ge, false => Z.ltb (m * Zpos d) (n * Zpos c)
      | Lt, true | Le, true => Z.ltb (n * Zpos c) (m * Zpos d)
      | Lt, false | Le, false => Z.leb (n * Zpos c) (m * Zpos d)
      | _, _ => false end
  | _, _ => false
  end.
Definition well_formed (g : family) (used : list side) : bool :=
  forallb simple (all_ranges g) && forallb (fun s => forallb (side_within s) (variable_ranges g)) used &&
  Nat.eqb (length (roles g)) (length (premises (body g))) &&
  rootless_goal (body g) && forallb rootless_rel (more g) &&
  forallb (fun q : premise_limit => match q with Some (_, f, v) => rootless f && rootless v | None => true end) (premised g).

Record side_proof := SideProof {
  radius_num : poly; radius_den : poly; radius_positive : proof; germ_within : proof;
  limit_num : poly; limit_den : poly; order : nat; identity : proof; ends : proof }.
Definition lower (n : nat) (p : poly) : poly :=
  map (fun t => (trim (match fst t with [] => [] | k :: m => (k - n)%nat :: m end), snd t)) p.
Definition divisible (n : nat) (p : poly) : bool :=
  forallb (fun t => match fst t with [] => Nat.eqb n 0 | k :: _ => Nat.leb n k end) p.
Definition misses (off : nat) (num den : poly) (order : nat) (to : target) : cases :=
  match to with
  | Finite v => differs off v num den ++ [[A den SZ]]
  | PlusInf => [[anot (A (pmul num den) SP)]]
  | MinusInf => [[anot (A (pneg (pmul num den)) SP)]]
  end.
Definition shows (g : family) (used : list side) (f : expr) (to : target) (s : side) (c : side_proof) : bool :=
  let pc := passing_of g used in
  let off := offset g in
  let st := range_atoms off (constant_ranges g) in
  let fs := constant_formulas g in
  let num := limit_num c in let den := limit_den c in
  let st' := germ_atoms pc s (radius_num c) (radius_den c) st in
  let zs := 0%nat :: constants pc ++ known_limits g s in
  has_side s used &&
  mentions_only (constants pc) (radius_num c) && mentions_only (constants pc) (radius_den c) &&
  refute (Some pc) depth (fs ++ [[[anot (A (radius_num c) SP)]; [anot (A (radius_den c) SP)]]]) st (radius_positive c) &&
  refute None depth (leaving g) st' (germ_within c) &&
  refute None depth (germ_formulas g s ++ [differs off f num den]) st' (identity c) &&
  mentions_only zs num && divisible (order c) den && mentions_only zs (lower (order c) den) &&
  match to with Finite v => Nat.eqb (order c) 0 && rootless v | _ => Nat.ltb 0 (order c) end && rootless f &&
  refute (Some pc) depth (fs ++ [misses off (at0 num) (at0 (lower (order c) den)) (order c) to]) st (ends c).
Definition proves_limit (g : family) (used : list side) (f : expr) (to : target) (cs : list (side * side_proof)) : bool :=
  well_formed g used && forallb (fun c => shows g used f to (fst c) (snd c)) cs.
Definition proves_point (g : family) (used : list side) (p : proof) : bool :=
  well_formed g used &&
  refute (Some (passing_of g used)) depth (point_formulas g) (range_atoms (offset g) (ranges (body g))) p.

(** ** They are sound *)

Lemma seqb_side_eq s t : seqb_side s t = true -> s = t.
Proof.
  unfold seqb_side. destruct s as [[[n d]|] a], t as [[[m c]|] b]; cbn [point above]; intro H; split_bools;
    try discriminate.
  - f_equal; [|apply eqb_prop; trivial]. f_equal; f_equal; [apply Z.eqb_eq|apply Pos.eqb_eq]; trivial.
  - f_equal. apply eqb_prop; trivial.
Qed.
Lemma has_side_in s ss : has_side s ss = true -> In s ss.
Proof.
  unfold has_side. intro H. apply existsb_exists in H as [t [I H]]. apply seqb_side_eq in H; subst; trivial.
Qed.
Lemma stands_for_spec off e l f num den : agrees off e l -> rootless f = true ->
  spec e (stands_for off f num den) (fun b => match b with
    | Some true => total l f /\ peval e den * ev l f = peval e num
    | Some false => total l f /\ peval e den * ev l f <> peval e num
    | None => ~ total l f end).
Proof.
  intros AG RT. unfold stands_for. apply spec_each with (is_value e l f).
  - apply regions_spec; trivial. apply rootless_rooted; trivial.
  - trivial.
  - intros v [C [D N]]. assert (Z : peval e (psub (pmul den (fst v)) (pmul num (snd v))) =
      peval e (snd v) * (peval e den * ev l f - peval e num)).
    { rewrite peval_sub, !peval_mul, <- N. ring. }
    apply spec_either; unfold holds; cbn [asign apoly]; rewrite Z; intro H; split; trivial.
    + apply Rmult_integral in H as [H|H]; [tauto|lra].
    + intro Q. apply H. rewrite Q. ring.
Qed.
Lemma equals_holds off e l f num den : agrees off e l -> rootless f = true ->
  total l f -> peval e den * ev l f = peval e num -> some_case e (equals off f num den).
Proof.
  intros AG RT T Q. apply (select_spec e _ _ is_true True (stands_for_spec off e l f num den AG RT)); trivial.
  intros [[|]|]; simpl; tauto.
Qed.
Lemma differs_not off e l f num den : agrees off e l -> rootless f = true ->
  ~ some_case e (differs off f num den) -> total l f /\ peval e den * ev l f = peval e num.
Proof.
  intros AG RT N. pose proof (stands_for_spec off e l f num den AG RT) as S.
  destruct S as [A0 [p [I0 H]]]. pose proof (A0 p I0 H) as G.
  assert (K : is_true (snd p) = true).
  { destruct (is_true (snd p)) eqn:E; trivial. exfalso. apply N. exists (fst p). split; trivial.
    unfold differs, select. apply in_map, filter_In. rewrite E. split; trivial. }
  destruct (snd p) as [[|]|]; simpl in K; try discriminate; trivial.
Qed.

Definition limit_values (g : family) (l : list R) : list R :=
  map (fun q : premise_limit => match q with Some (_, _, v) => ev l v | None => 0 end) (premised g).
Definition function_values (g : family) (s : side) (l : list R) : list R :=
  map (fun q : premise_limit => match q with Some (ss, f, _) => if has_side s ss then ev l f else 0 | None => 0 end)
    (premised g).
Definition at_point (g : family) (l : list R) : nat -> R := values (0 :: limit_values g l ++ l).
Definition on_germ (g : family) (l : R -> list R) (s : side) (t : R) : nat -> R :=
  values (t :: function_values g s (l (germ_point s t)) ++ l (germ_point s t)).

Lemma agrees_after t zs l n : length zs = n -> agrees (S n) (values (t :: zs ++ l)) l.
Proof.
  intros <- i. unfold values. cbn [nth Nat.add]. rewrite app_nth2_plus. trivial.
Qed.
Lemma agrees_point g l : agrees (offset g) (at_point g l) l.
Proof. apply agrees_after. unfold limit_values. apply map_length. Qed.
Lemma agrees_germ g l s t : agrees (offset g) (on_germ g l s t) (l (germ_point s t)).
Proof. apply agrees_after. unfold function_values. apply map_length. Qed.

Lemma mapi_nth {X Y} (f : nat -> X -> Y) (P : Y -> Prop) l : forall i,
  (forall j x, nth_error l j = Some x -> P (f (i + j)%nat x)) -> Forall P (mapi f i l).
Proof.
  induction l as [|x l IH]; simpl; intros i H; constructor.
  - specialize (H 0%nat x eq_refl). rewrite Nat.add_0_r in H. trivial.
  - apply IH. intros j y E. specialize (H (S j) y E). rewrite <- plus_n_Sm in H. trivial.
Qed.
Lemma value_read {X} (h : X -> R) ps l (t : R) j q : nth_error ps j = Some q ->
  values (t :: map h ps ++ l) (S j) = h q.
Proof.
  intro E. unfold values. cbn [nth]. rewrite app_nth1.
  - rewrite nth_indep with (d' := h q).
    + rewrite map_nth. f_equal. apply nth_error_nth. trivial.
    + rewrite map_length. apply nth_error_Some. congruence.
  - rewrite map_length. apply nth_error_Some. congruence.
Qed.
Lemma nothing_holds e : some_case e nothing.
Proof. exists []. split; [left; trivial|constructor]. Qed.

Record supposed (g : family) (l : R -> list R) : Prop := Supposed {
  constants_hold : forall p, Forall (fun P : Prop => P) (constantly g l p);
  functions_hold : Forall (fun P : Prop => P) (functionally g l);
  variable_read : forall p, nth (variable g) (l p) 0 = p;
  constants_fixed : forall p q i, In i (fixed g) -> nth i (l p) 0 = nth i (l q) 0
}.
Definition in_domain (g : family) (l : R -> list R) (p : R) : Prop := Forall (fun P : Prop => P) (domain g l p).

Section Sound.
Variables (g : family) (used : list side) (l : R -> list R).
Hypothesis W : well_formed g used = true.
Hypothesis H : supposed g l.
Let off := offset g.

Lemma wf : forallb simple (all_ranges g) = true /\
  (forall s, In s used -> forallb (side_within s) (variable_ranges g) = true) /\
  length (roles g) = length (premises (body g)) /\
  (forall p, Forall (rooted_rel (l p)) (all_ranges g)) /\
  (forall p, Forall (rooted_sentence (l p)) (premises (body g))) /\
  (forall p, rooted_all (l p) (conditions (body g))) /\
  (forall p, rooted_conclusion (l p) (claim (body g))) /\
  (forall ss f v, In (Some (ss, f, v)) (premised g) -> rootless f = true /\ rootless v = true).
Proof.
  unfold well_formed in W. split_bools.
  match goal with G : rootless_goal _ = true |- _ => pose proof (fun p => rootless_rooted_goal (l p) _ G) as RG end.
  repeat split; trivial; try (intro p; apply RG).
  - intros s I0. match goal with G : forallb _ used = true |- _ => rewrite forallb_forall in G; auto end.
  - apply Nat.eqb_eq; trivial.
  - intro p. apply Forall_app; split; [apply RG|]. apply rootless_rooted_all; trivial.
  - match goal with G : forallb _ (premised g) = true, I0 : In _ (premised g) |- _ => rewrite forallb_forall in G; apply G in I0 end.
    split_bools; trivial.
  - match goal with G : forallb _ (premised g) = true, I0 : In _ (premised g) |- _ => rewrite forallb_forall in G; apply G in I0 end.
    split_bools; trivial.
Qed.

Lemma roled_premise q : In q (roled g) -> In (snd q) (premises (body g)).
Proof. destruct q as [r h]. unfold roled. intro I0. apply in_combine_r in I0. trivial. Qed.
Lemma premise_roled h : In h (premises (body g)) -> exists r, In (r, h) (roled g).
Proof.
  destruct wf as [_ [_ [L _]]]. intro I0. apply In_nth_error in I0 as [n E].
  assert (K : exists r, nth_error (roles g) n = Some r).
  { destruct (nth_error (roles g) n) eqn:F; [eauto|]. apply nth_error_None in F.
    assert (n < length (premises (body g)))%nat by (apply nth_error_Some; congruence).
    rewrite L in F. apply Nat.lt_nge in H0. tauto. }
  destruct K as [r F]. exists r. unfold roled. clear L.
  revert n E F. generalize (premises (body g)). generalize (roles g).
  induction l0 as [|a l0 IH]; intros [|b m] [|n]; simpl; try discriminate.
  - intros E F. inversion E; inversion F; subst. left; trivial.
  - intros E F. right. apply IH with n; trivial.
Qed.
Lemma role_holds r h (P : sentence -> Prop) : In (r, h) (roled g) ->
  (forall h, In h (with_role r g) -> P h) -> (speaks h = false -> P h) -> P h.
Proof.
  intros I0 F N. destruct (speaks h) eqn:E; [|auto]. apply F. unfold with_role. apply in_map_iff.
  exists (r, h). split; trivial. apply filter_In. split; trivial. simpl. rewrite E. destruct r; trivial.
Qed.
Lemma silent p h : speaks h = false -> says_all (l p) h.
Proof.
  unfold speaks, says_all. destruct (links h); [|discriminate]. intros _. rewrite arrow_imp.
  destruct (given h); simpl; trivial.
Qed.
Lemma constantly_parts p :
  Forall (says (l p)) (constant_ranges g) /\ Forall (says_all (l p)) (with_role Everywhere g) /\
  (always_when g = true -> conj (flat (l p) (conditions (body g)))) /\
  (forall ss f v, In (Some (ss, f, v)) (premised g) -> conj (tends l (l p) f (Finite v) ss)).
Proof.
  pose proof (constants_hold g l H p) as C. unfold constantly in C.
  apply Forall_app in C as [C1 C]. apply Forall_app in C as [C2 C]. apply Forall_app in C as [C3 C4].
  apply (proj1 (Forall_props _ _)) in C1. apply (proj1 (Forall_props _ _)) in C2.
  split; [trivial|split; [trivial|split]].
  - intro A0. rewrite A0 in C3. destruct (conditions (body g)); [simpl; trivial|]. inversion C3; trivial.
  - intros ss f v I0. apply (proj1 (Forall_flat_map _ _ _)) in C4. rewrite Forall_forall in C4.
    specialize (C4 _ I0). simpl in C4. inversion C4; trivial.
Qed.
Lemma everywhere_holds p h : In (Everywhere, h) (roled g) -> says_all (l p) h.
Proof.
  intro I0. apply (role_holds Everywhere); trivial; [|apply silent].
  intros k K. destruct (constantly_parts p) as [_ [E _]]. rewrite Forall_forall in E. auto.
Qed.
Lemma along_holds p h : in_domain g l p -> In h (premises (body g)) -> says_all (l p) h.
Proof.
  intros D I0. destruct (premise_roled h I0) as [[| |] J].
  - apply everywhere_holds; trivial.
  - apply (role_holds Narrows); trivial; [|apply silent]. intros k K. unfold in_domain, domain in D.
    apply Forall_app in D as [_ D]. apply (proj1 (Forall_props _ _)) in D. rewrite Forall_forall in D. auto.
  - apply (role_holds Along); trivial; [|apply silent]. intros k K.
    pose proof (functions_hold g l H) as F. unfold functionally in F. apply Forall_app in F as [_ F].
    rewrite Forall_map, Forall_forall in F. specialize (F k K p). rewrite imply_all in F. auto.
Qed.
Lemma ranges_there p : Forall (says (l p)) (variable_ranges g) -> Forall (says (l p)) (all_ranges g).
Proof.
  intro V. destruct (constantly_parts p) as [C _]. apply Forall_forall. intros r I0.
  rewrite Forall_forall in C, V.
  destruct (mem (subject r) (fixed g)) eqn:E1.
  { apply C. apply filter_In. auto. }
  destruct (Nat.eqb (subject r) (variable g)) eqn:E2.
  { apply V. apply filter_In. rewrite E1, E2. auto. }
  pose proof (functions_hold g l H) as F. unfold functionally in F. apply Forall_app in F as [F _].
  assert (J : In r (function_ranges g)) by (apply filter_In; rewrite E1, E2; auto).
  destruct (function_ranges g) as [|r0 rs]; [destruct J|]. apply Forall_inv in F. specialize (F p).
  rewrite imply_all in F. rewrite conj_all in F.
  assert (G : Forall (says (l p)) (r0 :: rs)).
  { apply (proj1 (Forall_props _ _)). apply F. apply (proj2 (Forall_props _ _)).
    apply Forall_forall. trivial. }
  rewrite Forall_forall in G. auto.
Qed.

Lemma within_small s r : simple r = true -> side_within s r = true -> subject r = variable g ->
  small (fun t => says (l (germ_point s t)) r).
Proof.
  unfold simple, side_within, says, subject. destruct r as [a c b]; cbn [lhs rhs comparison].
  destruct a; try discriminate. destruct b as [m k| | | | | | | | | | | | | |]; try discriminate.
  intros _ C V. subst i. cbn [ev].
  assert (G : small (fun t => related c (germ_point s t) (num m k))).
  2: { apply (small_weaken _ _ G). intros t _. rewrite (variable_read g l H). trivial. }
  unfold germ_point. destruct s as [[[n d]|] [|]]; cbn [point above] in *.
  - assert (Le_ : (m * Zpos d <= n * Zpos k)%Z -> num m k <= num n d).
    { intro L. apply IZR_le in L. rewrite !mult_IZR in L. pose proof (num_eq m k). pose proof (num_eq n d).
      pose proof (pos_pos k). pose proof (pos_pos d).
      apply Rmult_le_reg_r with (IZR (Zpos d) * IZR (Zpos k)); [apply Rmult_lt_0_compat; trivial|]. nra. }
    assert (Lt_ : (n * Zpos k < m * Zpos d)%Z -> num n d < num m k).
    { intro L. apply IZR_lt in L. rewrite !mult_IZR in L. pose proof (num_eq m k). pose proof (num_eq n d).
      pose proof (pos_pos k). pose proof (pos_pos d).
      apply Rmult_lt_reg_r with (IZR (Zpos d) * IZR (Zpos k)); [apply Rmult_lt_0_compat; trivial|]. nra. }
    destruct c; try discriminate; try (apply Z.leb_le, Le_ in C); try (apply Z.ltb_lt, Lt_ in C); cbn [related];
      try (exists 1; split; [lra|]; intros; lra); exists (num m k - num n d); (split; [lra|]; intros; lra).
  - assert (Le_ : (n * Zpos k <= m * Zpos d)%Z -> num n d <= num m k).
    { intro L. apply IZR_le in L. rewrite !mult_IZR in L. pose proof (num_eq m k). pose proof (num_eq n d).
      pose proof (pos_pos k). pose proof (pos_pos d).
      apply Rmult_le_reg_r with (IZR (Zpos d) * IZR (Zpos k)); [apply Rmult_lt_0_compat; trivial|]. nra. }
    assert (Lt_ : (m * Zpos d < n * Zpos k)%Z -> num m k < num n d).
    { intro L. apply IZR_lt in L. rewrite !mult_IZR in L. pose proof (num_eq m k). pose proof (num_eq n d).
      pose proof (pos_pos k). pose proof (pos_pos d).
      apply Rmult_lt_reg_r with (IZR (Zpos d) * IZR (Zpos k)); [apply Rmult_lt_0_compat; trivial|]. nra. }
    destruct c; try discriminate; try (apply Z.leb_le, Le_ in C); try (apply Z.ltb_lt, Lt_ in C); cbn [related];
      try (exists 1; split; [lra|]; intros; lra); exists (num n d - num m k); (split; [lra|]; intros; lra).
  - assert (P : 0 < Rabs (num m k) + 1) by (pose proof (Rabs_pos (num m k)); lra).
    exists (/ (Rabs (num m k) + 1)). split; [apply Rinv_0_lt_compat; trivial|]. intros t [T U].
    pose proof (inv_big _ t T P U). pose proof (Rle_abs (num m k)).
    destruct c; try discriminate; cbn [related]; lra.
  - assert (P : 0 < Rabs (num m k) + 1) by (pose proof (Rabs_pos (num m k)); lra).
    exists (/ (Rabs (num m k) + 1)). split; [apply Rinv_0_lt_compat; trivial|]. intros t [T U].
    pose proof (inv_big _ t T P U). pose proof (Rle_abs (- num m k)). rewrite Rabs_Ropp in *.
    destruct c; try discriminate; cbn [related]; lra.
Qed.
Lemma side_within_small s : In s used -> small (fun t => Forall (says (l (germ_point s t))) (variable_ranges g)).
Proof.
  intro I0. destruct wf as [Si [Sd _]]. specialize (Sd s I0). rewrite forallb_forall in Si, Sd.
  assert (S : small (fun t => forall r, In r (variable_ranges g) -> says (l (germ_point s t)) r)).
  { apply small_all. intros r J. pose proof J as K. apply filter_In in K as [K K2]. apply andb_true_iff in K2 as [_ K2].
    apply Nat.eqb_eq in K2. apply within_small; auto. }
  apply (small_weaken _ _ S). intros t _ F. apply Forall_forall. trivial.
Qed.
Lemma free_formulas_hold e p ls : agrees off e (l p) -> some_cases e ls -> some_cases e (free_formulas g ls).
Proof.
  intros AG Z. destruct wf as [_ [_ [_ [_ [RP [RC _]]]]]]. destruct (constantly_parts p) as [_ [_ [CW _]]].
  unfold some_cases, free_formulas. apply Forall_app; split; [|apply Forall_app; split; trivial].
  - apply Forall_map, Forall_forall. intros [r h] I0. cbn [fst snd].
    destruct (is_role Everywhere r) eqn:E; [|apply nothing_holds]. destruct r; try discriminate.
    apply (holds_spec (offset g) e (l p) h AG); [|apply everywhere_holds; trivial].
    specialize (RP p). rewrite Forall_forall in RP. apply RP. apply (roled_premise (Everywhere, h)); trivial.
  - apply Forall_cons; [|apply Forall_nil]. destruct (always_when g); [|apply nothing_holds].
    apply (where_all_spec (offset g) e (l p)); auto.
Qed.
Lemma values_hold e p : agrees off e (l p) ->
  (forall j ss f v, nth_error (premised g) j = Some (Some (ss, f, v)) -> e (S j) = ev (l p) v) ->
  some_cases e (mapi (value_cases (offset g)) 0 (premised g)).
Proof.
  intros AG Z. destruct wf as [_ [_ [_ [_ [_ [_ [_ RL]]]]]]]. destruct (constantly_parts p) as [_ [_ [_ CT]]].
  apply mapi_nth. intros j [[[ss f] v]|] E; [|apply nothing_holds]. cbn [value_cases Nat.add].
  pose proof (nth_error_In _ _ E) as I0. destruct (RL _ _ _ I0) as [_ Rv].
  apply equals_holds with (l p); trivial.
  - specialize (CT _ _ _ I0). unfold tends in CT. apply conj_app in CT. apply CT.
  - unfold pone. rewrite peval_const, peval_var, (Z _ _ _ _ E). ring.
Qed.
Lemma known_limit_in s k : In k (known_limits g s) ->
  exists j ss f v, k = S j /\ nth_error (premised g) j = Some (Some (ss, f, v)) /\ has_side s ss = true.
Proof.
  unfold known_limits. intro I0. apply in_flat_map in I0 as [zs [J K]].
  assert (G : forall ps i, In zs (mapi (fun i (q : premise_limit) => match q with
    | Some (ss, _, _) => if has_side s ss then [S i] else [] | None => [] end) i ps) ->
    exists j ss f v, k = S (i + j) /\ nth_error ps j = Some (Some (ss, f, v)) /\ has_side s ss = true).
  { induction ps as [|q ps IH]; intros i; simpl; [intros []|]. intros [E|I1].
    - destruct q as [[[ss f] v]|]; [|subst; destruct K]. destruct (has_side s ss) eqn:Hs; [|subst; destruct K].
      subst. destruct K as [<-|[]]. exists 0%nat, ss, f, v. rewrite Nat.add_0_r. auto.
    - destruct (IH _ I1) as [j [ss [f [v [E1 [E2 E3]]]]]]. exists (S j), ss, f, v.
      rewrite <- plus_n_Sm. auto. }
  destruct (G _ _ J) as [j [ss [f [v G']]]]. exists j, ss, f, v. trivial.
Qed.
Lemma premised_near s ss f v p : In (Some (ss, f, v)) (premised g) -> has_side s ss = true ->
  reaches l (l p) f (Finite v) s.
Proof.
  intros I0 S. destruct (constantly_parts p) as [_ [_ [_ CT]]]. specialize (CT _ _ _ I0). unfold tends in CT.
  apply conj_app in CT as [_ CT]. rewrite conj_all, Forall_map, Forall_forall in CT. apply CT.
  apply has_side_in; trivial.
Qed.
Lemma premised_germ s ss f v p : In (Some (ss, f, v)) (premised g) -> has_side s ss = true ->
  small (fun t => total (l (germ_point s t)) f) /\
  germ_limit (fun t => ev (l (germ_point s t)) f) (ev (l p) v).
Proof.
  intros I0 S. pose proof (premised_near s ss f v p I0 S) as N. cbn [reaches] in N. split.
  - specialize (N 1 ltac:(lra)). apply near_small in N. apply (small_weaken _ _ N).
    intros t _ C. apply conj_app in C. apply C.
  - apply germ_limit_alt. intros eps E. specialize (N eps E). apply near_small in N as [d [D F]].
    exists d. split; trivial. intros t T. specialize (F t T). apply conj_app in F as [_ F].
    rewrite conj_one in F. trivial.
Qed.
Lemma binding_holds s t e : 0 < t -> e 0%nat = t -> e (offset g + variable g)%nat = germ_point s t ->
  holds e (binding (offset g + variable g) s).
Proof.
  intros T E0 Ex. unfold holds, binding; cbn [asign apoly]. unfold germ_point in Ex.
  assert (Pn : peval e (pneg (pvar 0)) = - t) by (rewrite peval_neg, peval_var, E0; trivial).
  destruct s as [[[n d]|] [|]]; cbn [point above] in *; unfold pone;
    rewrite ?peval_sub, ?peval_add, ?peval_scale, ?peval_mul, ?peval_const, ?Pn, ?peval_var, ?E0, Ex;
    rewrite ?opp_IZR; try (pose proof (num_eq n d)); try nra; field; lra.
Qed.

Lemma narrows_rooted h p : In h (with_role Narrows g) -> rooted_sentence (l p) h.
Proof.
  intro I0. unfold with_role in I0. apply in_map_iff in I0 as [q [<- I0]]. apply filter_In in I0 as [I0 _].
  destruct wf as [_ [_ [_ [_ [RP _]]]]]. specialize (RP p). rewrite Forall_forall in RP. apply RP, roled_premise; trivial.
Qed.
Lemma narrowed e x : agrees (offset g) e (l x) ->
  Forall (says_all (l x)) (with_role Narrows g) \/ exists h, In h (with_role Narrows g) /\ ~ says_all (l x) h.
Proof.
  intro AG. assert (R0 : forall h, In h (with_role Narrows g) -> rooted_sentence (l x) h)
    by (intros; apply narrows_rooted; trivial).
  revert R0. induction (with_role Narrows g) as [|h hs IH]; intro R0; [left; constructor|].
  destruct (says_all_dec (l x) h e (offset g) AG (R0 h (or_introl eq_refl))) as [Y|N].
  - destruct IH as [F|[k [I0 N]]]; [intros k I0; apply R0; right; trivial|left; constructor; trivial|].
    right. exists k. split; [right; trivial|trivial].
  - right. exists h. split; [left; trivial|trivial].
Qed.

Lemma no_zero s : existsb (Nat.eqb 0) (constants (passing_of g used) ++ known_limits g s) = false.
Proof.
  cbn [constants passing_of]. destruct (existsb (Nat.eqb 0) _) eqn:E; trivial. exfalso.
  apply existsb_exists in E as [k [K E]]. apply Nat.eqb_eq in E; subst k.
  apply in_app_iff in K as [K|K].
  - apply in_map_iff in K as [i [K _]]. unfold offset in K. discriminate.
  - apply known_limit_in in K as [j [_ [_ [_ [K _]]]]]. discriminate.
Qed.
Lemma germ_there p s : In s used -> exists d,
  germ (passing_of g used) (at_point g (l p)) s (known_limits g s) (germ_formulas g s) d (on_germ g l s).
Proof.
  intro Is. destruct wf as [Si [Sd [_ [RR [RP [RC [_ RL]]]]]]].
  pose proof (side_within_small s Is) as S1.
  assert (S2 : small (fun t => forall q, In q (premised g) -> match q with
    | Some (ss, f, v) => has_side s ss = true -> total (l (germ_point s t)) f | None => True end)).
  { apply small_all. intros [[[ss f] v]|] I1; [|exists 1; split; [lra|trivial]].
    destruct (has_side s ss) eqn:Hs.
    - destruct (premised_germ s ss f v p I1 Hs) as [S _]. apply (small_weaken _ _ S). auto.
    - exists 1. split; [lra|]. discriminate. }
  destruct (small_and _ _ S1 S2) as [d [D F]].
  exists d. split; [trivial|split].
  - intros t T. destruct (F t T) as [F1 F2]. pose proof (agrees_germ g l s t) as AG.
    set (e := on_germ g l s t) in *. set (x := germ_point s t) in *.
    assert (CF : some_cases e (mapi (function_cases (offset g) s) 0 (premised g))).
    { apply mapi_nth. intros j [[[ss f] v]|] E; [|apply nothing_holds]. cbn [function_cases Nat.add].
      destruct (has_side s ss) eqn:Hs; [|apply nothing_holds].
      pose proof (nth_error_In _ _ E) as I1. destruct (RL _ _ _ I1) as [Rf _].
      apply equals_holds with (l x); trivial.
      - apply (F2 _ I1 Hs).
      - unfold pone. rewrite peval_const, peval_var. unfold e, on_germ, function_values.
        rewrite (value_read _ _ _ _ _ _ E), Hs. fold x. ring. }
    assert (CW : some_cases e [if always_when g then where_all (offset g) (conditions (body g)) else nothing]).
    { apply Forall_cons; [|apply Forall_nil]. destruct (always_when g) eqn:AW; [|apply nothing_holds].
      apply (where_all_spec (offset g) e (l x)); [exact AG|apply RC|]. apply (constantly_parts x); trivial. }
    assert (OS : forall e, e 0%nat = t -> agrees (offset g) e (l x) ->
      on_side (passing_of g used) (at_point g (l p)) s t e).
    { intros e1 E0 A1. split; [trivial|split; [|split]].
      - apply ranges_hold with (l x); [exact A1|apply RR|exact Si|apply ranges_there; trivial].
      - apply binding_holds with t; [lra|trivial|]. rewrite A1. apply (variable_read g l H).
      - intros k K. apply in_map_iff in K as [i [<- Ii]]. rewrite A1, (agrees_point g (l p) i).
        apply (constants_fixed g l H); trivial. }
    split; [apply OS; trivial|].
    + destruct (narrowed e x AG) as [N|[h [I1 N]]].
      * right. assert (ID : in_domain g l x).
        { unfold in_domain, domain. apply Forall_app; split; apply (proj2 (Forall_props _ _)); trivial. }
        unfold germ_formulas. apply Forall_app; split; [|apply Forall_app; split; trivial].
        apply formulas_hold with (l x); [exact AG|apply RP|]. apply Forall_forall. intros h I1.
        apply filter_In in I1 as [I1 _]. apply along_holds; trivial.
      * left. set (e' := values (t :: limit_values g (l x) ++ l x)).
        assert (A1 : agrees (offset g) e' (l x)) by (apply agrees_after; unfold limit_values; apply map_length).
        exists e'. split; [apply OS; trivial|]. apply Forall_app; split.
        -- apply free_formulas_hold with x; trivial. apply values_hold with x; trivial.
           intros j ss f v E. unfold e', limit_values. rewrite (value_read _ _ _ _ _ _ E). trivial.
        -- apply Forall_cons; [|apply Forall_nil].
           assert (C : some_case e' (where_holds (offset g) h false)).
           { apply (fails_spec (offset g) e' (l x)); trivial. apply narrows_rooted; trivial. }
           destruct C as [a [Ia Ha]]. exists a; split; trivial. apply in_flat_map. exists h; auto.
  - intros k K. apply known_limit_in in K as [j [ss [f [v [-> [E Hs]]]]]].
    pose proof (nth_error_In _ _ E) as I1. destruct (premised_germ s ss f v p I1 Hs) as [_ G].
    assert (E1 : at_point g (l p) (S j) = ev (l p) v).
    { unfold at_point, limit_values. rewrite (value_read _ _ _ _ _ _ E). trivial. }
    rewrite E1. apply germ_limit_near with (fun t => ev (l (germ_point s t)) f) d; trivial.
    intros t T. unfold on_germ, function_values. rewrite (value_read _ _ _ _ _ _ E), Hs. trivial.
Qed.

Lemma germs_there p : germs (Some (passing_of g used)) (at_point g (l p)).
Proof.
  intros s zs fs AS. unfold along_side, passing_of in AS. cbn [along_sides] in AS.
  destruct (find _ _) as [[s' q]|] eqn:Fi; [|discriminate]. apply find_some in Fi as [I0 Q].
  cbn [option_map snd fst] in AS, Q. apply seqb_side_eq in Q; subst s'.
  apply in_map_iff in I0 as [s' [Eq_ Is]]. inversion Eq_; subst s' q. inversion AS; subst zs fs. clear Eq_ AS.
  split; [apply no_zero|]. destruct (germ_there p s Is) as [d G]. exists d, (on_germ g l s). exact G.
Qed.

Lemma at_values p j ss f v : nth_error (premised g) j = Some (Some (ss, f, v)) ->
  at_point g (l p) (S j) = ev (l p) v.
Proof. intro E. unfold at_point, limit_values. rewrite (value_read _ _ _ _ _ _ E). trivial. Qed.
Lemma known_here p : some_cases (at_point g (l p)) (constant_formulas g).
Proof.
  apply free_formulas_hold with p; [apply agrees_point|].
  apply values_hold with p; [apply agrees_point|]. intros; eapply at_values; eassumption.
Qed.
Lemma ranges_here p : all_hold (at_point g (l p)) (range_atoms (offset g) (constant_ranges g)).
Proof.
  destruct wf as [Si [_ [_ [RR _]]]]. apply ranges_hold with (l p).
  - apply agrees_point.
  - specialize (RR p). unfold rooted_all. rewrite Forall_forall in *. intros r I0. apply filter_In in I0 as [I0 _]. auto.
  - rewrite forallb_forall in *. intros r I0. apply filter_In in I0 as [I0 _]. auto.
  - apply constantly_parts.
Qed.

(** A claim at a point of the domain. *)
Lemma point_sound p pf :
  refute (Some (passing_of g used)) depth (point_formulas g) (range_atoms (offset g) (ranges (body g))) pf = true ->
  in_domain g l p ->
  arrow (if always_when g then [] else flat (l p) (conditions (body g))) (concludes (l p) (claim (body g))).
Proof.
  intros C D. destruct wf as [Si [_ [_ [RR [RP [RC [RL _]]]]]]]. rewrite arrow_imp. intro CW.
  pose proof (agrees_point g (l p)) as AG. set (e := at_point g (l p)) in *.
  destruct (failure_spec (offset g) e (l p) (claim (body g)) AG (RL p)) as [Fa [|N]]; trivial.
  exfalso. apply (refute_sound (Some (passing_of g used)) depth _ _ pf e (germs_there p) C).
  - apply ranges_hold with (l p); trivial.
    + specialize (RR p). apply Forall_app in RR. apply RR.
    + unfold all_ranges in Si. rewrite forallb_app in Si. split_bools. trivial.
    + unfold in_domain, domain in D. apply Forall_app in D as [D _]. apply (proj1 (Forall_props _ _)) in D.
      pose proof (ranges_there p D) as Q. apply Forall_app in Q. apply Q.
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
Lemma side_sound f to s c : shows g used f to s c = true ->
  match to with Finite v => total (l 0) v | _ => True end /\ reaches l (l 0) f to s.
Proof.
  unfold shows. intro C. cbv zeta in C. split_bools.
  match goal with G : has_side s used = true |- _ => rename G into Hs; apply has_side_in in Hs end.
  match goal with G : match to with Finite _ => _ | _ => _ end = true |- _ => rename G into Ho end.
  match goal with G : rootless f = true |- _ => rename G into Rf end.
  match goal with G : divisible _ _ = true |- _ => rename G into Di end.
  match goal with G : refute _ _ (_ ++ [misses _ _ _ _ _]) _ _ = true |- _ => rename G into Ce end.
  match goal with G : refute _ _ (_ ++ [differs _ _ _ _]) _ _ = true |- _ => rename G into Ci end.
  match goal with G : refute _ _ (leaving g) _ _ = true |- _ => rename G into Cw end.
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
    peval (on_germ g l s t) (limit_den c) * ev (l (germ_point s t)) f = peval (on_germ g l s t) (limit_num c))).
  { exists d'. split; trivial. intros t T. destruct (Gi t T) as [G1 G2].
    apply (differs_not (offset g) (on_germ g l s t) (l (germ_point s t))); [apply agrees_germ|trivial|].
    intro Wr. apply (HN _ _ _ _ _ Ci G1). apply Forall_app; split; trivial. apply Forall_cons; [trivial|apply Forall_nil]. }
  assert (Ms : ~ some_case env (misses (offset g) (at0 (limit_num c)) (at0 (lower (order c) (limit_den c))) (order c) to)).
  { intro Wr. apply (refute_sound (Some pc) depth _ _ _ env GS Ce R0). apply Forall_app; split; trivial.
    apply Forall_cons; [trivial|apply Forall_nil]. }
  assert (Il : small (fun t => t ^ order c * peval (on_germ g l s t) (lower (order c) (limit_den c)) *
    ev (l (germ_point s t)) f = peval (on_germ g l s t) (limit_num c))).
  { apply (small_weaken _ _ Id). intros t _ [_ E]. rewrite <- E, (lower_eval _ _ _ Di). trivial. }
  assert (Db : forall P : R -> Prop, small P -> small (fun t => total (l (germ_point s t)) f /\ P t)).
  { intros P S. apply small_and; trivial. apply (small_weaken _ _ Id). tauto. }
  set (q := lower (order c) (limit_den c)) in *.
  assert (Sg : forall p : poly, ~ some_case env [[anot (A p SP)]] -> 0 < peval env p).
  { intros p N. destruct (holds_dec env (A p SP)) as [Y|Y]; [exact Y|]. exfalso. apply N.
    exists [anot (A p SP)]. split; [left; trivial|]. apply Forall_cons; [apply anot_holds; trivial|apply Forall_nil]. }
  destruct to as [v| |]; cbn [misses] in Ms.
  - apply andb_true_iff in Ho as [Ho Rv]. apply Nat.eqb_eq in Ho.
    assert (M1 : ~ some_case env (differs (offset g) v (at0 (limit_num c)) (at0 q))).
    { intros [a [Ia Ha]]. apply Ms. exists a. split; trivial. apply in_app_iff; auto. }
    assert (M2 : peval env (at0 q) <> 0).
    { intro Q. apply Ms. exists [A (at0 q) SZ]. split; [apply in_app_iff; right; left; trivial|].
      apply Forall_cons; [exact Q|apply Forall_nil]. }
    destruct (differs_not _ _ _ _ _ _ AG Rv M1) as [Tv Ev_]. split; trivial.
    assert (L : germ_limit (fun t => ev (l (germ_point s t)) f) (ev (l 0) v)).
    { replace (ev (l 0) v) with (peval env (at0 (limit_num c)) / peval env (at0 q)) by (rewrite <- Ev_; field; trivial).
      apply quotient_tends with (1 := Ld) (2 := Ln) (3 := M2). apply (small_weaken _ _ Il).
      intros t _ E. rewrite <- E, Ho. simpl. ring. }
    intros eps E. apply near_small. apply (small_weaken _ _ (Db _ (small_near _ _ eps L E))).
    intros t _ [T1 T2]. apply conj_app. split; [exact T1|]. apply conj_one. exact T2.
  - split; trivial. apply Nat.ltb_lt in Ho. destruct (order c) as [|n] eqn:On; [inversion Ho|].
    apply Sg in Ms. rewrite peval_mul in Ms. intro b. apply near_small.
    apply (small_weaken _ _ (Db _ (quotient_diverges _ _ _ _ _ n Ld Ln Ms Il b))).
    intros t _ [T1 T2]. apply conj_app. split; [exact T1|]. apply conj_one. exact T2.
  - split; trivial. apply Nat.ltb_lt in Ho. destruct (order c) as [|n] eqn:On; [inversion Ho|].
    apply Sg in Ms. rewrite peval_neg, peval_mul in Ms. intro b. apply near_small.
    assert (Ln' : germ_limit (fun t => - peval (on_germ g l s t) (limit_num c)) (- peval env (at0 (limit_num c))))
      by (apply limit_Ropp; trivial).
    assert (Ms' : 0 < - peval env (at0 (limit_num c)) * peval env (at0 q)) by lra.
    assert (Il' : small (fun t => t ^ S n * peval (on_germ g l s t) q * - ev (l (germ_point s t)) f =
      - peval (on_germ g l s t) (limit_num c))).
    { apply (small_weaken _ _ Il). intros t _ E. rewrite <- E. ring. }
    apply (small_weaken _ _ (Db _ (quotient_diverges _ _ _ _ _ n Ld Ln' Ms' Il' (- b)))).
    intros t _ [T1 T2]. apply conj_app. split; [exact T1|]. apply conj_one. lra.
Qed.
End Sound.

(** The list of values has the limit variable where it should be, and constants do not vary. *)
Inductive steady (g : family) (l : R -> list R) : Prop := Steady :
  (forall p, nth (variable g) (l p) 0 = p) ->
  (forall p q, map (fun i => nth i (l p) 0) (fixed g) = map (fun i => nth i (l q) 0) (fixed g)) ->
  (forall p, constantly g l p = constantly g l 0) -> steady g l.
Lemma steady_supposed g l : steady g l -> Forall (fun P : Prop => P) (constantly g l 0 ++ functionally g l) -> supposed g l.
Proof.
  intros [V F C] H. apply Forall_app in H as [H1 H2]. split; trivial.
  - intro p. rewrite C. trivial.
  - intros p q i I0. specialize (F p q). revert F I0. induction (fixed g) as [|j js IH]; simpl; [intros _ []|].
    intros E [->|I0]; inversion E; auto.
Qed.
(** A limit that is proved from its sides is the limit. *)
Theorem limit_proved g used f to cs l : proves_limit g used f to cs = true -> negb (Nat.eqb (length cs) 0) = true ->
  steady g l -> states_limit g l f to (map fst cs).
Proof.
  unfold proves_limit, states_limit. intros C N S. apply andb_true_iff in C as [W C]. rewrite imply_all. intro H.
  pose proof (steady_supposed g l S H) as Su. rewrite forallb_forall in C. unfold tends.
  assert (A0 : forall c, In c cs -> match to with Finite v => total (l 0) v | _ => True end /\ reaches l (l 0) f to (fst c)).
  { intros c I0. apply (side_sound g used l W Su f to (fst c) (snd c)). auto. }
  apply conj_app. split.
  - destruct cs as [|c cs]; [discriminate|]. destruct (A0 c (or_introl eq_refl)) as [T _]. destruct to; simpl; trivial.
  - apply conj_all. rewrite Forall_map, Forall_map, Forall_forall. intros c I0. apply A0. trivial.
Qed.
Theorem point_proved g used p l : proves_point g used p = true -> steady g l -> states_point g l.
Proof.
  unfold proves_point, states_point. intros C S. apply andb_true_iff in C as [W C]. rewrite imply_all. intro H.
  pose proof (steady_supposed g l S H) as Su. intro x. rewrite imply_all. intro D.
  apply (point_sound g used l W Su x p C D).
Qed.

(** * Functions that meet the premises *)

(** Expressions in place of the symbols. *)
Fixpoint subst (es : list expr) (e : expr) : expr :=
  match e with
  | Num n d => Num n d
  | Var i => nth i es (Num 0 1)
  | Neg a => Neg (subst es a)
  | Add a b => Add (subst es a) (subst es b) | Sub a b => Sub (subst es a) (subst es b)
  | Mul a b => Mul (subst es a) (subst es b) | Div a b => Div (subst es a) (subst es b)
  | Pow a n => Pow (subst es a) n
  | Abs a => Abs (subst es a)
  | Min a b => Min (subst es a) (subst es b) | Max a b => Max (subst es a) (subst es b)
  | Root i a => Root i (subst es a)
  | If x r y a b => If (subst es x) r (subst es y) (subst es a) (subst es b)
  | Slope a d => Slope (subst es a) (subst es d)
  | Undefined => Undefined
  end.
Definition subst_rel es r := Rel (subst es (lhs r)) (comparison r) (subst es (rhs r)).
Definition subst_says es h := Says (given h) (map (subst_rel es) (when h)) (map (subst_rel es) (links h)).
Definition subst_conclusion es c :=
  match c with
  | Holds r => Holds (subst_rel es r) | IfDefined r => IfDefined (subst_rel es r)
  | Defined r => Defined (subst_rel es r) | Sentence h => Sentence (subst_says es h) | Falsehood => Falsehood
  end.
(** An expression without roots that mentions certain symbols only. *)
Fixpoint only (ok : nat -> bool) (e : expr) : bool :=
  match e with
  | Num _ _ | Undefined => true
  | Var i => ok i
  | Neg a | Pow a _ | Abs a => only ok a
  | Add a b | Sub a b | Mul a b | Div a b | Min a b | Max a b | Slope a b => only ok a && only ok b
  | Root _ _ => false
  | If x _ y a b => only ok x && only ok y && only ok a && only ok b
  end.
Definition only_rel ok r := only ok (lhs r) && only ok (rhs r).
Definition only_says ok h := forallb (only_rel ok) (when h) && forallb (only_rel ok) (links h).

Definition along (es : list expr) (p : R) : list R := map (ev [p]) es.
Lemma subst_ev es p e : only (fun _ => true) e = true -> ev [p] (subst es e) = ev (along es p) e.
Proof.
  induction e; cbn [subst ev only]; intro O; split_bools; rewrite ?IHe, ?IHe1, ?IHe2, ?IHe3, ?IHe4; trivial; try discriminate.
  unfold along. rewrite <- (map_nth (ev [p])). trivial.
Qed.
Lemma only_any ok e : only ok e = true -> only (fun _ => true) e = true.
Proof. induction e; cbn [only]; intro O; split_bools; rewrite ?IHe, ?IHe1, ?IHe2, ?IHe3, ?IHe4; trivial. Qed.

Lemma subst_forward es p e : only (fun _ => true) e = true -> total [p] (subst es e) -> total (along es p) e.
Proof.
  unfold total. induction e; cbn [subst conds only]; intro O; split_bools; try discriminate; try tauto;
    rewrite ?conj_app, ?conj_branch, ?divides_spec; rewrite ?subst_ev by trivial; try tauto.
  intros; exact I.
Qed.

Section Substitution.
Variables (es : list expr) (p : R) (ok : nat -> bool).
Let l := along es p.
Hypothesis T : forall i, ok i = true -> total [p] (nth i es (Num 0 1)).

Lemma subst_total e : only ok e = true -> (total [p] (subst es e) <-> total l e).
Proof.
  unfold total. induction e; cbn [subst conds only]; intro O; split_bools; try discriminate; try tauto;
    rewrite ?conj_app, ?conj_branch, ?divides_spec; rewrite ?subst_ev by (eapply only_any; eassumption);
    rewrite ?IHe, ?IHe1, ?IHe2, ?IHe3, ?IHe4 by trivial; fold l; try tauto.
  - split; [intros _; exact I|intros _; exact (T _ O)].
Qed.
Lemma subst_related r : only_rel ok r = true -> (says [p] (subst_rel es r) <-> says l r).
Proof.
  unfold only_rel, says, subst_rel. intro O. split_bools. cbn [comparison lhs rhs].
  rewrite !subst_ev by (eapply only_any; eassumption). tauto.
Qed.
Lemma subst_defined r : only_rel ok r = true -> (defined_rel [p] (subst_rel es r) <-> defined_rel l r).
Proof.
  unfold only_rel, defined_rel, subst_rel. intro O. split_bools. cbn [lhs rhs]. rewrite !subst_total by trivial. tauto.
Qed.
Lemma subst_flat rs : forallb (only_rel ok) rs = true -> (conj (flat [p] (map (subst_rel es) rs)) <-> conj (flat l rs)).
Proof.
  induction rs as [|r rs IH]; cbn [map forallb]; intro O; [tauto|]. split_bools.
  rewrite !flat_cons, subst_defined, subst_related, IH by trivial. tauto.
Qed.
Lemma subst_spoken rs : forallb (only_rel ok) rs = true -> (spoken [p] (map (subst_rel es) rs) <-> spoken l rs).
Proof.
  induction rs as [|r rs IH]; cbn [map forallb]; intro O; [simpl; tauto|]. split_bools.
  rewrite !spoken_cons, subst_defined, subst_related, IH by trivial. tauto.
Qed.
Lemma subst_sentence h : only_says ok h = true -> (says_all [p] (subst_says es h) <-> says_all l h).
Proof.
  unfold only_says, says_all, subst_says. intro O. split_bools. cbn [when links given]. rewrite !arrow_imp, subst_flat by trivial.
  destruct (given h); rewrite ?subst_flat, ?subst_spoken by trivial; tauto.
Qed.
Definition only_conclusion c :=
  match c with Holds r | IfDefined r | Defined r => only_rel ok r | Sentence h => only_says ok h | Falsehood => true end.
Lemma subst_concludes c : only_conclusion c = true -> (concludes [p] (subst_conclusion es c) <-> concludes l c).
Proof.
  assert (C : forall l r, conj (conds_rel l r) <-> defined_rel l r) by (intros; apply conj_app).
  destruct c; cbn [only_conclusion subst_conclusion concludes]; intro O;
    rewrite ?arrow_imp, ?conj_app, ?conj_one, ?C, ?subst_defined, ?subst_related, ?subst_sentence by trivial; tauto.
Qed.
End Substitution.

(** What holds of closed expressions by arithmetic alone. *)
Definition plainly (h : sentence) : bool :=
  rootless_sentence h && match where_holds 0 h false with [] => true | _ => false end.
Lemma agrees_values l : agrees 0 (values l) l.
Proof. intro. trivial. Qed.
Lemma plainly_says h l : plainly h = true -> says_all l h.
Proof.
  unfold plainly. intro C. split_bools.
  match goal with G : rootless_sentence h = true |- _ => pose proof (rootless_rooted_sentence l h G) as RT end.
  destruct (says_all_dec l h (values l) 0 (agrees_values l) RT) as [|N]; trivial. exfalso.
  apply (fails_spec 0 _ l h (agrees_values l) RT) in N. destruct N as [a [I0 _]].
  destruct (where_holds 0 h false); [destruct I0|discriminate].
Qed.

(** Expressions for all symbols, the limit variable being variable 0, and the proofs that they meet
    the premises: for each symbol, that it is defined and in its range; for each premise; for each
    premised limit. The flag says whether the declared range of the limit variable is used. *)
Record functions := Functions {
  exprs : list expr;
  range_proofs : list (bool * proof);
  premise_proofs : list (bool * proof);
  limit_proofs : list (list (side * side_proof))
}.
Definition range_of (g : family) (i : nat) : sentence :=
  Says true [] (Rel (Var i) Eq (Var i) :: filter (fun r => Nat.eqb (subject r) i) (all_ranges g)).
Definition domain_ranges (g : family) (F : functions) := map (subst_rel (exprs F)) (variable_ranges g).
Definition domain_premises (g : family) (F : functions) := map (subst_says (exprs F)) (with_role Narrows g).
Definition at_point_of (g : family) (F : functions) (ranged : bool) (cs : list relation) (c : conclusion) : goal :=
  Goal (if ranged then domain_ranges g F else []) (domain_premises g F) cs c.
Definition on_domain (g : family) (F : functions) (h : sentence) (q : bool * proof) : bool :=
  proves (at_point_of g F (fst q) [] (Sentence (subst_says (exprs F) h))) (snd q).
Definition family_of (g : family) (F : functions) : family :=
  Family (Goal [] (domain_premises g F) [] Falsehood) (domain_ranges g F) 0 []
    (map (fun _ => Narrows) (domain_premises g F)) true [].
Definition is_nil {X} (l : list X) : bool := match l with [] => true | _ => false end.
Fixpoint all2 {X Y} (f : X -> Y -> bool) (l : list X) (m : list Y) : bool :=
  match l, m with [], [] => true | x :: l, y :: m => f x y && all2 f l m | _, _ => false end.
Definition premised_shown (g : family) (F : functions) (used : list side) (q : premise_limit) (cs : list (side * side_proof)) : bool :=
  match q with
  | Some (ss, f, v) =>
    all2 (fun s c => seqb_side s (fst c)) ss cs && negb (is_nil cs) &&
    proves_limit (family_of g F) used (subst (exprs F) f) (Finite (subst (exprs F) v)) cs &&
    only (fun _ => true) f && only (fun i => mem i (fixed g)) v
  | None => false
  end.
Definition premise_shown (g : family) (F : functions) (q : role * sentence) (c : bool * proof) : bool :=
  only_says (fun _ => true) (snd q) && 
  match fst q with
  | Narrows => only_says (fun i => mem i (fixed g) || Nat.eqb i (variable g)) (snd q)
  | Everywhere => only_says (fun i => mem i (fixed g)) (snd q) && (negb (speaks (snd q)) || plainly (subst_says (exprs F) (snd q)))
  | Along => negb (speaks (snd q)) || on_domain g F (snd q) c
  end.
Definition meets (g : family) (F : functions) (used : list side) : bool :=
  let es := exprs F in
  match nth (variable g) es Undefined with Var 0 => true | _ => false end && negb (mem (variable g) (fixed g)) &&
  all2 (fun i c => Nat.eqb i (variable g) || (only_says (fun _ => true) (range_of g i) && on_domain g F (range_of g i) c))
    (seq 0 (length es)) (range_proofs F) &&
  forallb (fun i => plainly (subst_says es (range_of g i))) (fixed g) &&
  forallb simple (all_ranges g) &&
  forallb (fun r => Nat.ltb (subject r) (length es)) (all_ranges g) &&
  (is_nil (function_ranges g) || is_nil (with_role Narrows g)) &&
  all2 (premise_shown g F) (roled g) (premise_proofs F) &&
  (negb (always_when g) || is_nil (conditions (body g)) ||
    (forallb (only_rel (fun i => mem i (fixed g))) (conditions (body g)) && plainly (subst_says es (Says true [] (conditions (body g)))))) &&
  is_nil (with_role Everywhere (family_of g F)) && is_nil (with_role Along (family_of g F)) &&
  is_nil (function_ranges (family_of g F)) &&
  all2 (premised_shown g F used) (premised g) (limit_proofs F).

(** ** They do meet them *)

Lemma all2_in {X Y} (f : X -> Y -> bool) l m x : all2 f l m = true -> In x l -> exists y, In y m /\ f x y = true.
Proof.
  revert m. induction l as [|a l IH]; intros [|b m]; simpl; try discriminate; [intros _ []|].
  intros C [->|I0]; split_bools; [eauto|]. destruct (IH m) as [y [J K]]; eauto.
Qed.
Lemma is_nil_eq {X} (l : list X) : is_nil l = true -> l = [].
Proof. destruct l; [trivial|discriminate]. Qed.
Lemma flat_in l rs r : conj (flat l rs) -> In r rs -> defined_rel l r /\ says l r.
Proof.
  induction rs as [|q rs IH]; [intros _ []|]. rewrite flat_cons. intros [D [S F]] [->|I0]; auto.
Qed.
Lemma mem_in i l : mem i l = true -> In i l.
Proof. unfold mem. intro C. apply existsb_exists in C as [j [J E]]. apply Nat.eqb_eq in E; subst; trivial. Qed.

Section Met.
Variables (g : family) (F : functions) (used : list side).
Hypothesis M : meets g F used = true.
Let es := exprs F.
Let l : R -> list R := along es.

Lemma met : nth (variable g) es Undefined = Var 0 /\
  all2 (fun i c => Nat.eqb i (variable g) || (only_says (fun _ => true) (range_of g i) && on_domain g F (range_of g i) c))
    (seq 0 (length es)) (range_proofs F) = true /\
  (forall i, In i (fixed g) -> plainly (subst_says es (range_of g i)) = true) /\
  forallb simple (all_ranges g) = true /\
  (forall r, In r (all_ranges g) -> (subject r < length es)%nat) /\
  (function_ranges g = [] \/ with_role Narrows g = []) /\
  all2 (premise_shown g F) (roled g) (premise_proofs F) = true /\
  (always_when g = true -> conditions (body g) = [] \/
    (forallb (only_rel (fun i => mem i (fixed g))) (conditions (body g)) = true /\
     plainly (subst_says es (Says true [] (conditions (body g)))) = true)) /\
  with_role Everywhere (family_of g F) = [] /\ with_role Along (family_of g F) = [] /\
  function_ranges (family_of g F) = [] /\
  all2 (premised_shown g F used) (premised g) (limit_proofs F) = true.
Proof.
  unfold meets in M. fold es in M. cbv zeta in M. split_bools.
  repeat match goal with |- _ /\ _ => split end; trivial; try (apply is_nil_eq; trivial).
  - destruct (nth (variable g) es Undefined); try discriminate. destruct i; [trivial|discriminate].
  - match goal with G : forallb _ (fixed g) = true |- _ => rewrite forallb_forall in G; exact G end.
  - intros r I0. apply Nat.ltb_lt. match goal with G : forallb (fun r => Nat.ltb _ _) _ = true |- _ => rewrite forallb_forall in G; auto end.
  - match goal with G : is_nil (function_ranges g) || _ = true |- _ => apply orb_true_iff in G as [G|G]; apply is_nil_eq in G; auto end.
  - intro A0. match goal with G : negb (always_when g) || _ || _ = true |- _ => rewrite A0 in G; simpl in G; apply orb_true_iff in G as [G|G] end.
    + left. apply is_nil_eq; trivial.
    + right. split_bools; auto.
Qed.

Lemma variable_place : nth (variable g) es (Num 0 1) = Var 0.
Proof.
  destruct met as [V _]. rewrite <- V. apply nth_indep.
  destruct (Nat.lt_ge_cases (variable g) (length es)) as [|G]; trivial.
  rewrite nth_overflow in V by trivial. discriminate.
Qed.
Lemma range_flat i p : conj (flat [p] (links (subst_says es (range_of g i)))) ->
  total [p] (nth i es (Num 0 1)) /\ forall r, only_rel (fun _ => true) r = true -> In r (all_ranges g) -> subject r = i -> says (l p) r.
Proof.
  intro C. split.
  - apply (flat_in _ _ (subst_rel es (Rel (Var i) Eq (Var i))) C). left; trivial.
  - intros r O I0 Sr. apply (subst_related es p (fun _ => true) r O).
    apply (flat_in _ _ (subst_rel es r) C). right. apply in_map, filter_In. split; trivial. apply Nat.eqb_eq; trivial.
Qed.
Lemma simple_only r : simple r = true -> only_rel (fun _ => true) r = true.
Proof. unfold simple, only_rel. destruct (lhs r); try discriminate. destruct (rhs r); try discriminate. trivial. Qed.
Lemma range_only r : In r (all_ranges g) -> only_rel (fun _ => true) r = true.
Proof.
  destruct met as [_ [_ [_ [Si _]]]]. rewrite forallb_forall in Si. intro I0. apply simple_only. auto.
Qed.
Lemma fixed_there i p : In i (fixed g) -> conj (flat [p] (links (subst_says es (range_of g i)))).
Proof.
  intro I0. destruct met as [_ [_ [Pl _]]]. pose proof (plainly_says _ [p] (Pl i I0)) as S.
  unfold says_all in S. rewrite arrow_imp in S. apply S. exact I.
Qed.
Lemma fixed_total p i : mem i (fixed g) = true -> total [p] (nth i es (Num 0 1)).
Proof. intro C. apply mem_in in C. apply (range_flat i p). apply fixed_there; trivial. Qed.
Lemma narrow_total p i : (mem i (fixed g) || Nat.eqb i (variable g)) = true -> total [p] (nth i es (Num 0 1)).
Proof.
  intro C. apply orb_true_iff in C as [C|C]; [apply fixed_total; trivial|].
  apply Nat.eqb_eq in C; subst. rewrite variable_place. exact I.
Qed.
Lemma roled_shown r h : In (r, h) (roled g) -> exists c, premise_shown g F (r, h) c = true.
Proof.
  destruct met as [_ [_ [_ [_ [_ [_ [P _]]]]]]]. intro I0. destruct (all2_in _ _ _ _ P I0) as [c [_ C]]. eauto.
Qed.
Lemma with_role_shown r h : In h (with_role r g) -> speaks h = true /\ exists c, premise_shown g F (r, h) c = true.
Proof.
  unfold with_role. intro I0. apply in_map_iff in I0 as [[q k] [<- I0]]. apply filter_In in I0 as [I0 C].
  cbn [fst snd] in *. apply andb_true_iff in C as [C S]. split; trivial.
  apply roled_shown. destruct q, r; try discriminate; trivial.
Qed.
Lemma narrow_says h p : In h (with_role Narrows g) -> (says_all [p] (subst_says es h) <-> says_all (l p) h).
Proof.
  intro I0. destruct (with_role_shown _ _ I0) as [_ [c C]]. unfold premise_shown in C. cbn [fst snd] in C. split_bools.
  match goal with G : only_says (fun i => _ || _) h = true |- _ => apply (subst_sentence es p _ (narrow_total p) h G) end.
Qed.
Lemma domain_there p : in_domain g l p <->
  Forall (says [p]) (domain_ranges g F) /\ Forall (says_all [p]) (domain_premises g F).
Proof.
  unfold in_domain, domain, domain_ranges, domain_premises. fold es. rewrite Forall_app, !Forall_props, !Forall_map.
  assert (A0 : Forall (says (l p)) (variable_ranges g) <-> Forall (fun r => says [p] (subst_rel es r)) (variable_ranges g)).
  { rewrite !Forall_forall. split; intros H r I0; pose proof I0 as J; apply filter_In in J as [J _];
      apply (subst_related es p (fun _ => true) r (range_only r J)); auto. }
  assert (A1 : Forall (says_all (l p)) (with_role Narrows g) <-> Forall (fun h => says_all [p] (subst_says es h)) (with_role Narrows g)).
  { rewrite !Forall_forall. split; intros H h I0; apply narrow_says; auto. }
  tauto.
Qed.
Lemma shown_on_domain h c p : on_domain g F h c = true -> in_domain g l p -> says_all [p] (subst_says es h).
Proof.
  unfold on_domain. intros C D. apply domain_there in D as [D1 D2].
  apply proved with (l := [p]) in C. unfold states, at_point_of in C. rewrite imply_all, arrow_imp in C.
  cbn [ranges premises conditions claim concludes] in C. apply C; [|exact I].
  apply Forall_app; split; apply (proj2 (Forall_props _ _)).
  - destruct (fst c); [trivial|constructor].
  - rewrite Forall_forall in *. intros k K. apply filter_In in K as [K _]. auto.
Qed.
Lemma range_there i p : in_domain g l p -> (i < length es)%nat -> i <> variable g ->
  conj (flat [p] (links (subst_says es (range_of g i)))).
Proof.
  intros D L N. destruct met as [_ [Rp _]].
  destruct (all2_in _ _ _ i Rp) as [c [_ C]]; [apply in_seq; simpl; auto with arith|].
  apply orb_true_iff in C as [C|C]; [apply Nat.eqb_eq in C; contradiction|]. split_bools.
  match goal with G : on_domain _ _ _ _ = true |- _ => pose proof (shown_on_domain _ _ _ G D) as S end.
  unfold says_all in S. rewrite arrow_imp in S. apply S. exact I.
Qed.
Lemma domain_total p : in_domain g l p -> forall i : nat, true = true -> total [p] (nth i es (Num 0 1)).
Proof.
  intros D i _. destruct (Nat.lt_ge_cases i (length es)) as [L|G].
  - destruct (Nat.eq_dec i (variable g)) as [->|N]; [rewrite variable_place; exact I|].
    apply (range_flat i p). apply range_there; trivial.
  - rewrite nth_overflow by trivial. exact I.
Qed.
Lemma along_there h p : In h (with_role Along g) -> in_domain g l p -> says_all (l p) h.
Proof.
  intros I0 D. destruct (with_role_shown _ _ I0) as [S [c C]]. unfold premise_shown in C. cbn [fst snd] in C. split_bools.
  match goal with G : negb (speaks h) || _ = true |- _ => rewrite S in G; simpl in G; rename G into P end.
  apply (subst_sentence es p (fun _ => true) (domain_total p D)); trivial. apply shown_on_domain with c; trivial.
Qed.
Lemma supposed_family : supposed (family_of g F) (fun x => [x]).
Proof.
  destruct met as [_ [_ [_ [_ [_ [_ [_ [_ [E0 [A0 [R0 _]]]]]]]]]]]. split.
  - intro p. unfold constantly. rewrite E0. cbn [always_when family_of conditions body premised flat_map map].
    assert (K : constant_ranges (family_of g F) = []).
    { unfold constant_ranges. cbn [fixed family_of]. induction (all_ranges _); simpl; trivial. }
    rewrite K. constructor.
  - unfold functionally. rewrite A0, R0. constructor.
  - trivial.
  - intros p q i [].
Qed.
Lemma limit_there f to cs : proves_limit (family_of g F) used f to cs = true -> forall s c, In (s, c) cs ->
  match to with Finite v => total [0] v | _ => True end /\ reaches (fun x => [x]) [0] f to s.
Proof.
  unfold proves_limit. intros C s c I0. split_bools. 
  match goal with G : forallb _ cs = true |- _ => rewrite forallb_forall in G; specialize (G _ I0); cbn [fst snd] in G end.
  eapply (side_sound (family_of g F) used (fun x => [x])); [eassumption|apply supposed_family|eassumption].
Qed.
Lemma reaches_along f v s : only (fun _ => true) f = true -> only (fun _ => true) v = true ->
  reaches (fun x => [x]) [0] (subst es f) (Finite (subst es v)) s -> reaches l (l 0) f (Finite v) s.
Proof.
  intros Of Ov C eps E. specialize (C eps E). apply (near_weaken _ _ _ C). intros x K. apply conj_app in K as [K1 K2].
  apply conj_app. split; [apply subst_forward; trivial|]. rewrite conj_one in *. rewrite !subst_ev in K2 by trivial. trivial.
Qed.
Lemma premised_there q cs : premised_shown g F used q cs = true ->
  Forall (fun P : Prop => P) (premise_tends l (l 0) q).
Proof.
  destruct q as [[[ss f] v]|]; [|discriminate]. cbn [premised_shown premise_tends]. fold es. intro C. split_bools.
  match goal with G : only _ f = true |- _ => rename G into Of end. match goal with G : only _ v = true |- _ => rename G into Ov; apply only_any in Ov end.
  match goal with G : proves_limit _ _ _ _ _ = true |- _ => pose proof (limit_there _ _ _ G) as L end.
  match goal with G : all2 _ ss cs = true |- _ => rename G into S end.
  apply Forall_cons; [|constructor]. unfold tends. apply conj_app. split.
  - destruct cs as [|[s c] cs]; [discriminate|]. destruct (L s c (or_introl eq_refl)) as [T _]. apply subst_forward; trivial.
  - apply conj_all. apply (proj2 (Forall_props _ _)). apply Forall_forall. intros s I0.
    destruct (all2_in _ _ _ s S I0) as [[s' c] [J Q]]. cbn [fst] in Q. apply seqb_side_eq in Q; subst s'.
    apply reaches_along; trivial. apply (L s c J).
Qed.
Lemma all_met : Forall (fun P : Prop => P) (constantly g l 0 ++ functionally g l).
Proof.
  destruct met as [_ [_ [_ [_ [Ln [Fr [_ [Aw [_ [_ [_ Pr]]]]]]]]]]]. apply Forall_app; split.
  - unfold constantly. apply Forall_app; split; [|apply Forall_app; split; [|apply Forall_app; split]].
    + apply (proj2 (Forall_props _ _)). apply Forall_forall. intros r I0. apply filter_In in I0 as [I0 C].
      apply (proj2 (range_flat (subject r) 0 (fixed_there _ 0 (mem_in _ _ C)))); trivial. apply range_only; trivial.
    + apply (proj2 (Forall_props _ _)). apply Forall_forall. intros h I0.
      destruct (with_role_shown _ _ I0) as [S [c C]]. unfold premise_shown in C. cbn [fst snd] in C. split_bools.
      match goal with G : negb (speaks h) || _ = true |- _ => rewrite S in G; simpl in G; rename G into P end.
      match goal with G : only_says (fun i => mem i _) h = true |- _ => apply (subst_sentence es 0 _ (fixed_total 0) h G) end.
      apply plainly_says; trivial.
    + destruct (always_when g) eqn:AW; [|constructor]. destruct (Aw eq_refl) as [->|[O P]]; [constructor|].
      destruct (conditions (body g)) as [|r rs]; [constructor|]. apply Forall_cons; [|constructor].
      apply (subst_flat es 0 _ (fixed_total 0) _ O). apply (plainly_says _ [0] P). 
    + apply Forall_flat_map, Forall_forall. intros q I0. destruct (all2_in _ _ _ q Pr I0) as [cs [_ C]].
      apply premised_there with cs; trivial.
  - unfold functionally. apply Forall_app; split.
    + destruct (function_ranges g) as [|r0 rs] eqn:E; [constructor|]. apply Forall_cons; [|constructor].
      destruct Fr as [Fr|Fr]; [discriminate|]. intro x. rewrite imply_all. intro V. rewrite <- E.
      assert (D : in_domain g l x).
      { unfold in_domain, domain. rewrite Fr, app_nil_r. trivial. }
      apply conj_all. apply (proj2 (Forall_props _ _)). apply Forall_forall. intros r I0. apply filter_In in I0 as [I0 C].
      split_bools. apply (proj2 (range_flat (subject r) x (range_there _ x D (Ln r I0)
        ltac:(intro Q; rewrite Q, Nat.eqb_refl in *; discriminate)))); trivial. apply range_only; trivial.
    + apply Forall_map, Forall_forall. intros h I0 x. rewrite imply_all. intro D. apply along_there; trivial.
Qed.
End Met.

(** ** They refute *)

(** The conclusion fails at a point of the domain. *)
Definition refutes_point (g : family) (F : functions) (used : list side) (w : witness) : bool :=
  let es := exprs F in
  meets g F used && Nat.eqb (length (coordinates w)) 1 &&
  match theta w with None => true | _ => false end &&
  forallb (only_rel (fun _ => true)) (conditions (body g)) && only_conclusion (fun _ => true) (claim (body g)) &&
  refuted_by (at_point_of g F true (if always_when g then [] else map (subst_rel es) (conditions (body g)))
    (subst_conclusion es (claim (body g)))) w.
Theorem point_refuted g F used w : refutes_point g F used w = true -> ~ states_point g (along (exprs F)).
Proof.
  unfold refutes_point. cbv zeta. intros C S. split_bools.
  match goal with G : meets _ _ _ = true |- _ => rename G into M end.
  match goal with G : match theta w with None => _ | _ => _ end = true |- _ => rename G into Th end.
  match goal with G : refuted_by _ _ = true |- _ => apply (refuted_there _ w 0 G) end.
  { destruct (theta w); [discriminate|]. constructor. }
  match goal with G : Nat.eqb (length _) 1 = true |- _ => apply Nat.eqb_eq in G; rename G into L end.
  assert (P : exists x, place w 0 = [x]).
  { unfold place. destruct (coordinates w) as [|c [|d cs]]; try discriminate. eexists; reflexivity. }
  destruct P as [x ->]. unfold states_point in S. rewrite imply_all in S. specialize (S (all_met g F used M) x).
  unfold states, at_point_of. cbn [ranges premises conditions claim]. rewrite imply_all. intro HA. apply Forall_app in HA as [HR HP].
  apply (proj1 (Forall_props _ _)) in HR. apply (proj1 (Forall_props _ _)) in HP.
  assert (D : in_domain g (along (exprs F)) x).
  { apply (domain_there g F used M). split; trivial. rewrite Forall_forall in *. intros h I0. apply HP.
    apply filter_In. split; trivial. unfold domain_premises in I0. apply in_map_iff in I0 as [k [<- I0]].
    destruct (with_role_shown g F used M _ _ I0) as [Sp _]. unfold speaks, subst_says in *. cbn [links].
    destruct (links k); trivial. }
  rewrite imply_all in S. specialize (S D). rewrite arrow_imp in *.
  pose proof (domain_total g F used M x D) as T0. intro W.
  match goal with G : only_conclusion _ _ = true |- _ => apply (subst_concludes (exprs F) x (fun _ => true) T0 _ G) end.
  apply S. destruct (always_when g); trivial.
  match goal with G : forallb _ (conditions _) = true |- _ => apply (subst_flat (exprs F) x (fun _ => true) T0 _ G) end.
  trivial.
Qed.

(** A function has one limit on a side. *)
Lemma near_some s Q : near s Q -> exists x, Q x.
Proof. rewrite near_small. intros [d [D F]]. exists (germ_point s (d / 2)). apply F. lra. Qed.
Lemma near_and s (P Q : R -> Prop) : near s P -> near s Q -> near s (fun x => P x /\ Q x).
Proof. rewrite !near_small. apply small_and. Qed.
Definition same_end (v v' : list R) (to to' : target) : Prop :=
  match to, to' with
  | Finite a, Finite b => ev v a = ev v' b
  | PlusInf, PlusInf | MinusInf, MinusInf => True
  | _, _ => False
  end.
Lemma one_limit l v f to l' v' f' to' s : (forall x, ev (l x) f = ev (l' x) f') ->
  reaches l v f to s -> reaches l' v' f' to' s -> same_end v v' to to'.
Proof.
  intros E H H'.
  assert (K : forall P Q : R -> Prop, near s (fun x => conj (conds (l x) f ++ [P (ev (l x) f)])) ->
    near s (fun x => conj (conds (l' x) f' ++ [Q (ev (l' x) f')])) -> exists y, P y /\ Q y).
  { intros P Q A0 B0. destruct (near_some _ _ (near_and _ _ _ A0 B0)) as [x [X Y]].
    apply conj_app in X as [_ X]. apply conj_app in Y as [_ Y]. rewrite conj_one in *. exists (ev (l x) f).
    split; trivial. rewrite E. trivial. }
  destruct to as [a| |], to' as [b| |]; cbn [same_end reaches] in *; trivial.
  - destruct (Req_dec (ev v a) (ev v' b)) as [|N]; trivial. exfalso.
    assert (P : Rabs (ev v a - ev v' b) > 0) by (apply Rabs_pos_lt; lra).
    set (e := Rabs (ev v a - ev v' b) / 2). assert (P2 : e > 0) by (unfold e; lra).
    destruct (K (fun y => Rabs (y - ev v a) < e) (fun y => Rabs (y - ev v' b) < e) (H e P2) (H' e P2)) as [y [Y Y']].
    unfold e in *; clear e P2.
    revert P Y Y'. unfold Rabs. repeat destruct Rcase_abs; lra.
  - destruct (K (fun y => Rabs (y - ev v a) < 1) (fun y => y > ev v a + 1) (H 1 ltac:(lra)) (H' _)) as [y [Y Y']].
    apply Rabs_def2 in Y. lra.
  - destruct (K (fun y => Rabs (y - ev v a) < 1) (fun y => y < ev v a - 1) (H 1 ltac:(lra)) (H' _)) as [y [Y Y']].
    apply Rabs_def2 in Y. lra.
  - destruct (K (fun y => y > ev v' b + 1) (fun y => Rabs (y - ev v' b) < 1) (H _) (H' 1 ltac:(lra))) as [y [Y Y']].
    apply Rabs_def2 in Y'. lra.
  - destruct (K (fun y => y > 0) (fun y => y < 0) (H _) (H' _)) as [y [Y Y']]. lra.
  - destruct (K (fun y => y < ev v' b - 1) (fun y => Rabs (y - ev v' b) < 1) (H _) (H' 1 ltac:(lra))) as [y [Y Y']].
    apply Rabs_def2 in Y'. lra.
  - destruct (K (fun y => y < 0) (fun y => y > 0) (H _) (H' _)) as [y [Y Y']]. lra.
Qed.

(** Two ends that visibly differ. *)
Definition apart (es : list expr) (to to' : target) : bool :=
  match to, to' with
  | Finite a, Finite b =>
      let r := Rel (subst es a) Eq b in rootless_rel r && is_nil (select is_true (truth 0 r))
  | PlusInf, PlusInf | MinusInf, MinusInf => false
  | _, _ => true
  end.
(** The limit is another one: [found], from the side [s]. *)
Definition refutes_limit (g : family) (F : functions) (used : list side) (f : expr) (to : target) (ss : list side)
  (s : side) (found : target) (c : side_proof) : bool :=
  meets g F used && has_side s ss && only (fun _ => true) f &&
  match to with Finite v => only (fun i => mem i (fixed g)) v | _ => true end &&
  proves_limit (family_of g F) used (subst (exprs F) f) found [(s, c)] && apart (exprs F) to found.
Theorem limit_refuted g F used f to ss s found c : refutes_limit g F used f to ss s found c = true ->
  ~ states_limit g (along (exprs F)) f to ss.
Proof.
  unfold refutes_limit, states_limit. intros C S. split_bools.
  match goal with G : meets _ _ _ = true |- _ => rename G into M end.
  match goal with G : has_side s ss = true |- _ => apply has_side_in in G; rename G into Is end.
  match goal with G : only _ f = true |- _ => rename G into Of end.
  match goal with G : match to with Finite _ => _ | _ => _ end = true |- _ => rename G into Ov end.
  match goal with G : proves_limit _ _ _ _ _ = true |- _ =>
    destruct (limit_there g F used M _ _ _ G s c (or_introl eq_refl)) as [Tf Rf] end.
  match goal with G : apart _ _ _ = true |- _ => rename G into Ap end.
  rewrite imply_all in S. specialize (S (all_met g F used M)). unfold tends in S. apply conj_app in S as [S1 S2].
  rewrite conj_all, Forall_map, Forall_forall in S2. specialize (S2 s Is).
  pose proof (one_limit _ _ _ _ _ _ _ _ _ (fun x => eq_sym (subst_ev (exprs F) x f Of)) S2 Rf) as E.
  destruct to as [a| |], found as [b| |]; cbn [same_end apart] in *; try contradiction; try discriminate.
  cbv zeta in Ap. split_bools. set (r := Rel (subst (exprs F) a) Eq b) in *.
  match goal with G : is_nil _ = true |- _ => apply is_nil_eq in G; rename G into N end.
  match goal with G : rootless_rel r = true |- _ => pose proof (rootless_rooted_rel [0] r G) as RT end.
  pose proof (truth_spec 0 (values [0]) [0] r (agrees_values [0]) RT) as Sp.
  assert (Y : some_case (values [0]) (select is_true (truth 0 r))).
  { apply (select_spec _ _ _ is_true True Sp); trivial. intros v V.
    assert (D : defined_rel [0] r).
    { split; [|exact Tf]. apply (subst_total (exprs F) 0 _ (fixed_total g F used M 0) a Ov). exact S1. }
    assert (Q : says [0] r).
    { unfold says, r. cbn [comparison lhs rhs related]. rewrite subst_ev by (eapply only_any; exact Ov). exact E. }
    unfold is_truth in V. destruct v as [[|]|]; simpl; tauto. }
  rewrite N in Y. destruct Y as [x [[] _]].
Qed.

(** * Ways to write the data below *)

Definition m_ (exponents : list nat) (c : Z) : mono * Z := (exponents, c).
Definition c_ (coefficients : list Z) (d : positive) : list Z * positive := (coefficients, d).
Definition q_ (n : Z) (d : positive) : Z * positive := (n, d).
Arguments m_ exponents%nat c%Z.
Arguments c_ coefficients%Z d%positive.
Arguments at_ t%R cs%Z d%positive.
Ltac has_roots := unfold rooted_goal, rooted_all, rooted_sentence, rooted_conclusion, rooted_rel; simpl;
  repeat match goal with
  | |- _ /\ _ => split | |- True => exact I | |- Forall _ [] => apply Forall_nil
  | |- Forall _ (_ :: _) => apply Forall_cons | |- _ -> _ => assumption
  | |- rooted _ _ => progress cbn [lhs rhs rooted]
  end.
