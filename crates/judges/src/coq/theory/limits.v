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
(** Close to a point there are others. *)
Lemma near_point s Q : near s Q -> exists x, Q x.
Proof.
  rewrite near_small. intros [d [D H]]. exists (germ_point s (d / 2)). apply H. lra.
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

(** A premise is about constants, about the limit variable alone, or about functions of it. Of one
    that is not about constants, [parts] has what it says of constants all the same. *)
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
  parts : list sentence;
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
Definition moving (also : bool) (g : family) : list sentence :=
  map snd (filter (fun q => (is_role Along (fst q) || (also && is_role Narrows (fst q))) && speaks (snd q)) (roled g)).
Definition spoken_parts (g : family) : list sentence := filter speaks (parts g).
Definition premise_tends (l : R -> list R) (v : list R) (q : premise_limit) : list Prop :=
  match q with Some (ss, f, y) => [conj (tends l v f (Finite y) ss)] | None => [] end.

(** What is supposed: of constants; that the domain reaches up to the limits; of functions there.
    The domain is a set of values of the variable, inside its declared range. *)
Definition constantly (g : family) (l : R -> list R) (p : R) : list Prop :=
  map (says (l p)) (constant_ranges g) ++ map (says_all (l p)) (with_role Everywhere g) ++
  map (says_all (l p)) (spoken_parts g) ++
  (if always_when g then match conditions (body g) with [] => [] | rs => [conj (flat (l p) rs)] end else []) ++
  flat_map (premise_tends l (l p)) (premised g).
Definition domain (g : family) (D : list (R -> Prop)) (l : R -> list R) (p : R) : list Prop :=
  map (says (l p)) (variable_ranges g) ++ map (fun d : R -> Prop => d p) D.
Definition reached (D : list (R -> Prop)) (used : list side) : list Prop :=
  match D with [] => [] | _ => map (fun s => near s (fun x => conj (map (fun d : R -> Prop => d x) D))) used end.
Definition functionally (g : family) (D : list (R -> Prop)) (also : bool) (l : R -> list R) : list Prop :=
  match function_ranges g with
  | [] => []
  | rs => [forall x, imply (map (says (l x)) (variable_ranges g)) (conj (map (says (l x)) rs))]
  end ++
  map (fun h => forall x, imply (domain g D l x) (says_all (l x) h)) (moving also g).
(** What a lemma supposes: on a set of which nothing else is known, or on the values of the variable
    that premises about it alone allow. *)
Record setting := Setting { sets : list (R -> Prop); sides_reached : list side; all_premises : bool }.
Definition given_all (g : family) (c : setting) (l : R -> list R) : list Prop :=
  constantly g l 0 ++ reached (sets c) (sides_reached c) ++ functionally g (sets c) (all_premises c) l.
Definition states_limit (g : family) (c : setting) (l : R -> list R) (f : expr) (to : target) (ss : list side) : Prop :=
  imply (given_all g c l) (conj (tends l (l 0) f to ss)).
Definition states_point (g : family) (c : setting) (l : R -> list R) : Prop :=
  imply (given_all g c l)
    (forall x, imply (domain g (sets c) l x)
      (arrow (if always_when g then [] else flat (l x) (conditions (body g))) (concludes (l x) (claim (body g))))).

(** ** What is known at a point, of constants, and along a germ *)

Definition offset (g : family) : nat := S (length (premised g)).
(** How a function compares with a quotient: it is equal, at least, or at most. *)
Inductive sense := Same | AtLeast | AtMost.
Definition against (off : nat) (f : expr) (num den : poly) (k : sense) : pieces bool :=
  each (regions off f) (fun v =>
    let gap := psub (pmul den (fst v)) (pmul num (snd v)) in
    let both := pmul (pmul den (snd v)) gap in
    match k with
    | Same => either (A gap SZ) (Some true) (Some false)
    | AtLeast => either (A (pneg both) SP) (Some false) (Some true)
    | AtMost => either (A both SP) (Some false) (Some true)
    end).
Definition equals (off : nat) (f : expr) (num den : poly) : cases := select is_true (against off f num den Same).
Definition differs (off : nat) (f : expr) (num den : poly) (k : sense) : cases :=
  select (fun v => negb (is_true v)) (against off f num den k).
Definition nothing : cases := [[]].
Definition has_side (s : side) (ss : list side) : bool := existsb (seqb_side s) ss.
Definition value_cases (off : nat) (i : nat) (q : premise_limit) : cases :=
  match q with Some (_, _, v) => equals off v (pvar (S i)) pone | None => nothing end.
Definition function_cases (off : nat) (s : side) (i : nat) (q : premise_limit) : cases :=
  match q with Some (ss, f, _) => if has_side s ss then equals off f (pvar (S i)) pone else nothing | None => nothing end.
Definition free_formulas (g : family) (limits : list cases) : list cases :=
  map (fun q => where_holds (offset g) (if is_role Everywhere (fst (fst q)) then snd (fst q) else snd q) true)
    (combine (roled g) (parts g)) ++
  limits ++
  [if always_when g then where_all (offset g) (conditions (body g)) else nothing].
Definition constant_formulas (g : family) : list cases :=
  free_formulas g (mapi (value_cases (offset g)) 0 (premised g)).
(** That the premises hold close to the limit is supposed. *)
Definition leaving : list cases := [[]].
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
    (range_atoms (offset g) (all_ranges g)) leaving
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
  rootless_goal (body g) && forallb rootless_rel (more g) && forallb rootless_sentence (parts g) &&
  forallb (fun q : premise_limit => match q with Some (_, f, v) => rootless f && rootless v | None => true end) (premised g).

Record bound := Bound {
  radius_num : poly; radius_den : poly; radius_positive : proof; germ_within : proof;
  limit_num : poly; limit_den : poly; order : nat; compares : sense; comparison_proved : proof; ends : proof }.
Inductive side_proof := By (b : bound) | Between (lower upper : bound).
Definition lower (n : nat) (p : poly) : poly :=
  map (fun t => (trim (match fst t with [] => [] | k :: m => (k - n)%nat :: m end), snd t)) p.
Definition divisible (n : nat) (p : poly) : bool :=
  forallb (fun t => match fst t with [] => Nat.eqb n 0 | k :: _ => Nat.leb n k end) p.
Definition misses (off : nat) (num den : poly) (order : nat) (to : target) : cases :=
  match to with
  | Finite v => differs off v num den Same ++ [[A den SZ]]
  | PlusInf => [[anot (A (pmul num den) SP)]]
  | MinusInf => [[anot (A (pneg (pmul num den)) SP)]]
  end.
Definition bounds (g : family) (used : list side) (f : expr) (to : target) (s : side) (c : bound) : bool :=
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
  refute None depth leaving st' (germ_within c) &&
  refute None depth (germ_formulas g s ++ [differs off f num den (compares c)]) st' (comparison_proved c) &&
  mentions_only zs num && divisible (order c) den && mentions_only zs (lower (order c) den) &&
  match to with Finite v => Nat.eqb (order c) 0 && rootless v | _ => Nat.ltb 0 (order c) end && rootless f &&
  refute (Some pc) depth (fs ++ [misses off (at0 num) (at0 (lower (order c) den)) (order c) to]) st (ends c).
Definition shows (g : family) (used : list side) (f : expr) (to : target) (s : side) (c : side_proof) : bool :=
  match c with
  | By b => bounds g used f to s b &&
      match compares b, to with Same, _ | AtLeast, PlusInf | AtMost, MinusInf => true | _, _ => false end
  | Between b c => bounds g used f to s b && bounds g used f to s c &&
      match compares b, compares c, to with AtLeast, AtMost, Finite _ => true | _, _, _ => false end
  end.
Definition proves_limit (g : family) (used : list side) (f : expr) (to : target) (cs : list (side * side_proof)) : bool :=
  well_formed g used && forallb (fun c => shows g used f to (fst c) (snd c)) cs.
Definition proves_point (g : family) (used : list side) (p : proof) : bool :=
  well_formed g used &&
  refute (Some (passing_of g used)) depth (point_formulas g) (range_atoms (offset g) (ranges (body g))) p.
