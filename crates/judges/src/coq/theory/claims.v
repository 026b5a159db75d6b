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
  | Add a b | Sub a b | Mul a b | Div a b | Min a b | Max a b => rootless a && rootless b
  | Root _ _ | Deriv _ _ _ _ => false
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
Proof. induction e; simpl; intro H; split_bools; auto; discriminate. Qed.
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

Definition depth : nat := 4000.
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
(** The last part of a conjunction. *)
Ltac ends H := first [exact H | ends constr:(proj2 H)].
Ltac has_roots :=
  cbv beta iota zeta delta [rooted_goal rooted_all rooted_sentence rooted_conclusion rooted_rel rooted
    ranges premises conditions claim when links lhs rhs];
  repeat match goal with
  | |- _ /\ _ => split | |- True => exact I | |- Forall _ [] => apply Forall_nil
  | |- Forall _ (_ :: _) => apply Forall_cons | |- (_ < _)%nat => apply Nat.ltb_lt; reflexivity
  | H : _ |- _ => exact H
  end.
