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
| Deriv (j i n : nat) (f : expr)
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
  | Deriv j _ _ _ => nth j l 0
  | Undefined => 0
  end.
Fixpoint conj (l : list Prop) : Prop :=
  match l with [] => True | [p] => p | p :: l' => p /\ conj l' end.
Definition arrow (l : list Prop) (p : Prop) : Prop := match l with [] => p | _ => conj l -> p end.
Definition branch (p : Prop) (l : list Prop) : list Prop :=
  match l with [] => [] | _ => [p -> conj l] end.
Definition divides (l : list R) (b : expr) (v : R) : list Prop :=
  match b with Num (Zpos _) _ | Num (Zneg _) _ => [] | _ => [v <> 0] end.
(** Another value in the list. *)
Fixpoint upd (i : nat) (x : R) (l : list R) : list R :=
  match l, i with [], _ => [] | _ :: l, O => x :: l | y :: l, S i => y :: upd i x l end.
Fixpoint mentions (i : nat) (e : expr) : bool :=
  match e with
  | Num _ _ | Undefined => false
  | Var k => Nat.eqb i k
  | Neg a | Pow a _ | Abs a => mentions i a
  | Add a b | Sub a b | Mul a b | Div a b | Min a b | Max a b => mentions i a || mentions i b
  | Root _ _ | Deriv _ _ _ _ => true
  | If x _ y a b => mentions i x || mentions i y || mentions i a || mentions i b
  end.
(** The conditions under which an expression is differentiable by symbol [i], or at least continuous
    in it: no choice changes near the point. Absolute values, minima and maxima that are to be
    differentiated are written as choices. *)
Fixpoint near_conds (smooth : bool) (i : nat) (l : list R) (e : expr) : list Prop :=
  match e with
  | Num _ _ | Var _ => []
  | Neg a | Pow a _ => near_conds smooth i l a
  | Add a b | Sub a b | Mul a b => near_conds smooth i l a ++ near_conds smooth i l b
  | Div a b => near_conds smooth i l a ++ near_conds smooth i l b ++ divides l b (ev l b)
  | Abs a => if smooth then [False] else near_conds smooth i l a
  | Min a b | Max a b => if smooth then [False] else near_conds smooth i l a ++ near_conds smooth i l b
  | If x r y a b => near_conds false i l x ++ near_conds false i l y ++
      (if mentions i x || mentions i y then [ev l x <> ev l y] else []) ++
      branch (related r (ev l x) (ev l y)) (near_conds smooth i l a) ++
      branch (~ related r (ev l x) (ev l y)) (near_conds smooth i l b)
  | Root _ _ | Deriv _ _ _ _ | Undefined => [False]
  end.
(** [v] is the derivative of [F] at [a], or a further one. *)
Fixpoint derives (n : nat) (F : R -> R) (a v : R) : Prop :=
  match n with
  | O => derivable_pt_lim F a v
  | S n => exists (G : R -> R) (d : R), 0 < d /\ (forall x, Rabs (x - a) < d -> derivable_pt_lim F x (G x)) /\ derives n G a v
  end.
(** The conditions under which an expression is defined; a number other than 0 divides. *)
Fixpoint conds (l : list R) (e : expr) : list Prop :=
  match e with
  | Num _ _ | Var _ => []
  | Neg a | Pow a _ | Abs a => conds l a
  | Add a b | Sub a b | Mul a b | Min a b | Max a b => conds l a ++ conds l b
  | Div a b => conds l a ++ conds l b ++ divides l b (ev l b)
  | Root _ a => conds l a ++ [0 <= ev l a]
  | If x r y a b => conds l x ++ conds l y ++
      branch (related r (ev l x) (ev l y)) (conds l a) ++
      branch (~ related r (ev l x) (ev l y)) (conds l b)
  | Deriv _ i _ f => near_conds true i l f
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

(** What an expression is near a point, in a variable [v]. *)
Definition steadily (r : rel) (x y : frac) : pieces bool :=
  let gap := match r with Lt | Le => fadd y (fneg x) | _ => fadd x (fneg y) end in
  let (more, less) := match r with Eq => (false, false) | Ne => (true, true) | _ => (true, false) end in
  [([A (sign_poly gap) SP], Some more); ([A (pneg (sign_poly gap)) SP], Some less); ([A (fst gap) SZ], None)].
Definition steadily_compared (varies : bool) (r : rel) (ps qs : pieces frac) : pieces bool :=
  let test := if varies then steadily r else compare r in
  match r with
  | Lt | Le => both qs ps (fun y x => test x y) | _ => both ps qs test
  end.
Fixpoint near_regions (smooth : bool) (off i : nat) (e : expr) : pieces frac :=
  let go := near_regions smooth off i in
  match e with
  | Num n d => value (pconst n, pconst (Zpos d))
  | Var k => value (pvar (off + k), pone)
  | Neg a => each (go a) (fun x => value (fneg x))
  | Add a b => both (go a) (go b) (fun x y => value (fadd x y))
  | Sub a b => both (go a) (go b) (fun x y => value (fadd x (fneg y)))
  | Mul a b => both (go a) (go b) (fun x y => value (fmul x y))
  | Div a b => both (go a) (go b) (fun x y =>
      either (A (fst y) SNZ) (Some (pmul (fst x) (snd y), pmul (snd x) (fst y))) None)
  | Pow a n => each (go a) (fun x => value (ppow (fst x) n, ppow (snd x) n))
  | Abs a => if smooth then everywhere None else
      each (go a) (fun x => either (A (sign_poly x) SNN) (Some x) (Some (fneg x)))
  | Min a b => if smooth then everywhere None else both (go a) (go b) (fun x y =>
      either (A (sign_poly (fadd y (fneg x))) SNN) (Some x) (Some y))
  | Max a b => if smooth then everywhere None else both (go a) (go b) (fun x y =>
      either (A (sign_poly (fadd x (fneg y))) SNN) (Some x) (Some y))
  | If x r y a b =>
      each (steadily_compared (mentions i x || mentions i y) r (near_regions false off i x) (near_regions false off i y))
        (fun t : bool => if t then go a else go b)
  | Root _ _ | Deriv _ _ _ _ | Undefined => everywhere None
  end.
(** The derivative of a polynomial by a variable, and of a fraction. *)
Fixpoint lessen (v : nat) (m : mono) : mono :=
  match v, m with _, [] => [] | O, n :: m => pred n :: m | S v, n :: m => n :: lessen v m end.
Fixpoint pderiv (v : nat) (p : poly) : poly :=
  match p with
  | [] => []
  | (m, c) :: p => padd (pscale (Z.of_nat (nth v m 0%nat)) [(trim (lessen v m), c)]) (pderiv v p)
  end.
Definition slope (v : nat) (x : frac) : frac :=
  match as_const (snd x) with
  | Some _ => (pderiv v (fst x), snd x)
  | None => (psub (pmul (pderiv v (fst x)) (snd x)) (pmul (fst x) (pderiv v (snd x))), pmul (snd x) (snd x))
  end.
Fixpoint slopes (n v : nat) (x : frac) : frac :=
  match n with O => slope v x | S n => slopes n v (slope v x) end.

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
  | Deriv _ i n f => each (near_regions true off i f) (fun x => value (slopes n (off + i) x))
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
Lemma pos_neq (d : positive) : IZR (Zpos d) <> 0. Proof. apply not_0_IZR; discriminate. Qed.
Lemma pos_pos (d : positive) : 0 < IZR (Zpos d). Proof. apply IZR_lt; reflexivity. Qed.

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
Lemma stands_mul e u v x y : stands e u x -> stands e v y -> stands e (u * v) (fmul x y).
Proof.
  intros [D N] [F G]. unfold stands; simpl; rewrite !peval_mul, <- N, <- G.
  split; [apply Rmult_integral_contrapositive; auto|ring].
Qed.
Lemma stands_div e u v x y : stands e u x -> stands e v y -> v <> 0 ->
  stands e (u / v) (pmul (fst x) (snd y), pmul (snd x) (fst y)).
Proof.
  intros [D N] [F G] V. unfold stands; simpl; rewrite !peval_mul, <- N, <- G.
  split; [repeat apply Rmult_integral_contrapositive_currified; trivial|field; trivial].
Qed.
Lemma stands_pow e u x n : stands e u x -> stands e (u ^ n) (ppow (fst x) n, ppow (snd x) n).
Proof.
  intros [D N]. unfold stands; simpl. rewrite !peval_pow, <- N.
  split; [apply pow_nonzero; trivial|rewrite Rpow_mult_distr; trivial].
Qed.
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
(** Variables of square roots and of derivatives have their values. *)
Fixpoint rooted (l : list R) (e : expr) : Prop :=
  match e with
  | Num _ _ | Var _ | Undefined => True
  | Neg a | Pow a _ | Abs a => rooted l a
  | Add a b | Sub a b | Mul a b | Div a b | Min a b | Max a b => rooted l a /\ rooted l b
  | Root i a => (0 <= ev l a -> 0 <= nth i l 0 /\ nth i l 0 * nth i l 0 = ev l a) /\ rooted l a
  | If x _ y a b => rooted l x /\ rooted l y /\ rooted l a /\ rooted l b
  | Deriv j i n f => (i < length l)%nat /\
      arrow (near_conds true i l f) (derives n (fun x => ev (upd i x l) f) (nth i l 0) (nth j l 0))
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

