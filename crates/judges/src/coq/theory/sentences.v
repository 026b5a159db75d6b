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
