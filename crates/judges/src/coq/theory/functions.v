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
  | Deriv _ _ _ _ => Undefined
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
  | Add a b | Sub a b | Mul a b | Div a b | Min a b | Max a b => only ok a && only ok b
  | Root _ _ | Deriv _ _ _ _ => false
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
  unfold total. induction e; cbn [subst conds only]; intro O; split_bools; try discriminate; try reflexivity;
    rewrite ?conj_app, ?conj_branch, ?divides_spec; rewrite ?subst_ev by (eapply only_any; eassumption);
    rewrite ?IHe, ?IHe1, ?IHe2, ?IHe3, ?IHe4 by trivial; fold l; try reflexivity.
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
    premised limit. The flag says whether the declared range of the limit variable is used. Premises
    that say something of the limit variable alone narrow the domain; that it reaches up to the limits
    is proved. *)
Record within := Within { within_num : poly; within_den : poly; within_positive : proof; within_inside : list proof }.
Record functions := Functions {
  exprs : list expr;
  range_proofs : list (bool * proof);
  premise_proofs : list (bool * proof);
  limit_proofs : list (list (side * side_proof));
  narrowing : list sentence;
  reaching : list (side * within)
}.
(** That a symbol is defined and in its declared range. *)
Definition range_of (g : family) (i : nat) : sentence :=
  Says true [] (Rel (Var i) Eq (Var i) :: filter (fun r => Nat.eqb (subject r) i) (all_ranges g)).
(** What bounds the domain, in the limit variable alone; and a claim at a point of it. *)
Definition domain_ranges (g : family) (F : functions) := map (subst_rel (exprs F)) (variable_ranges g).
Definition domain_premises (g : family) (F : functions) := map (subst_says (exprs F)) (narrowing F).
Definition at_point_of (g : family) (F : functions) (ranged : bool) (cs : list relation) (c : conclusion) : goal :=
  Goal (if ranged then domain_ranges g F else []) (domain_premises g F) cs c.
Definition on_domain (g : family) (F : functions) (h : sentence) (q : bool * proof) : bool :=
  proves (at_point_of g F (fst q) [] (Sentence (subst_says (exprs F) h))) (snd q).
(** A goal along the limit variable in which no other symbol is left. *)
Definition family_of (g : family) (F : functions) : family :=
  Family (Goal [] (domain_premises g F) [] Falsehood) (domain_ranges g F) 0 []
    (map (fun _ => Narrows) (domain_premises g F)) (map (fun _ => Says true [] []) (domain_premises g F)) true [].
Definition narrowed_sets (F : functions) (l : R -> list R) : list (R -> Prop) :=
  map (fun h p => says_all (l p) h) (narrowing F).
(** The values of the limit variable that premises allow. *)
Definition narrowed_to (F : functions) : setting := Setting (narrowed_sets F (along (exprs F))) [] false.
(** The limit variable in its range, and nothing else. *)
Definition alone (g : family) (F : functions) : family :=
  Family (Goal [] [] [] Falsehood) (domain_ranges g F) 0 [] [] [] true [].

Definition is_nil {X} (l : list X) : bool := match l with [] => true | _ => false end.
Fixpoint all2 {X Y} (f : X -> Y -> bool) (l : list X) (m : list Y) : bool :=
  match l, m with [], [] => true | x :: l, y :: m => f x y && all2 f l m | _, _ => false end.
Definition premised_shown (g : family) (F : functions) (used : list side) (q : premise_limit)
  (cs : list (side * side_proof)) : bool :=
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
  | Narrows => true
  | Everywhere =>
      only_says (fun i => mem i (fixed g)) (snd q) &&
      (negb (speaks (snd q)) || plainly (subst_says (exprs F) (snd q)))
  | Along => negb (speaks (snd q)) || on_domain g F (snd q) c
  end.
Definition within_shown (g : family) (F : functions) (used : list side) (s : side) (w : within) : bool :=
  let a := alone g F in
  let pc := passing_of a used in
  let free := map (fun _ => nothing) (domain_premises g F) ++ [nothing] in
  mentions_only (constants pc) (within_num w) && mentions_only (constants pc) (within_den w) &&
  refute None depth (free ++ [[[anot (A (within_num w) SP)]; [anot (A (within_den w) SP)]]]) [] (within_positive w) &&
  all2 (fun h p => refute None depth (free ++ [where_holds (offset a) h false])
      (germ_atoms pc s (within_num w) (within_den w) []) p)
    (domain_premises g F) (within_inside w).
(** The functions meet the premises: those about constants by arithmetic, those about functions on the
    whole domain. Declared ranges of functions hold beyond a domain that premises narrow, so there may
    not be both. *)
Definition meets (g : family) (F : functions) (used : list side) : bool :=
  let es := exprs F in
  match nth (variable g) es Undefined with Var 0 => true | _ => false end && negb (mem (variable g) (fixed g)) &&
  all2 (fun i c => Nat.eqb i (variable g) ||
      (only_says (fun _ => true) (range_of g i) && on_domain g F (range_of g i) c))
    (seq 0 (length es)) (range_proofs F) &&
  forallb (fun i => plainly (subst_says es (range_of g i))) (fixed g) &&
  forallb simple (all_ranges g) &&
  forallb (fun r => Nat.ltb (subject r) (length es)) (all_ranges g) &&
  (is_nil (function_ranges g) || is_nil (narrowing F)) &&
  forallb (fun h => only_says (fun i => mem i (fixed g) || Nat.eqb i (variable g)) h) (narrowing F) &&
  forallb (fun h => only_says (fun i => mem i (fixed g)) h && plainly (subst_says es h)) (spoken_parts g) &&
  forallb rootless_sentence (domain_premises g F) && well_formed (alone g F) used &&
  forallb (fun s => existsb (fun q => seqb_side s (fst q) && within_shown g F used s (snd q)) (reaching F)) used &&
  all2 (premise_shown g F) (roled g) (premise_proofs F) &&
  (negb (always_when g) || is_nil (conditions (body g)) ||
    (forallb (only_rel (fun i => mem i (fixed g))) (conditions (body g)) &&
     plainly (subst_says es (Says true [] (conditions (body g)))))) &&
  is_nil (with_role Everywhere (family_of g F)) && is_nil (with_role Along (family_of g F)) &&
  is_nil (function_ranges (family_of g F)) &&
  all2 (premised_shown g F used) (premised g) (limit_proofs F).
