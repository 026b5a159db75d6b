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
  (function_ranges g = [] \/ narrowing F = []) /\
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

Lemma met_domain :
  (forall h, In h (narrowing F) -> only_says (fun i => mem i (fixed g) || Nat.eqb i (variable g)) h = true) /\
  (forall h, In h (spoken_parts g) -> only_says (fun i => mem i (fixed g)) h = true /\ plainly (subst_says es h) = true) /\
  (forall h, In h (domain_premises g F) -> rootless_sentence h = true) /\
  well_formed (alone g F) used = true /\
  (forall s, In s used -> exists w, within_shown g F used s w = true).
Proof.
  unfold meets in M. fold es in M. cbv zeta in M. split_bools.
  repeat match goal with G : forallb _ _ = true |- _ => rewrite forallb_forall in G end.
  repeat match goal with |- _ /\ _ => split end; trivial.
  - intros h I0. match goal with G : forall x, In x (spoken_parts g) -> _ |- _ => specialize (G h I0) end. split_bools. auto.
  - intros s I0. match goal with G : forall x, In x used -> _ |- _ => specialize (G s I0) as E0 end.
    apply existsb_exists in E0 as [[s' w] [_ E0]]. split_bools. exists w. trivial.
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
Lemma narrow_says h p : In h (narrowing F) -> (says_all [p] (subst_says es h) <-> says_all (l p) h).
Proof.
  intro I0. destruct met_domain as [N _]. apply (subst_sentence es p _ (narrow_total p) h (N h I0)).
Qed.
Lemma domain_there p : in_domain g (narrowed_sets F l) l p <->
  Forall (says [p]) (domain_ranges g F) /\ Forall (says_all [p]) (domain_premises g F).
Proof.
  unfold in_domain, domain, domain_ranges, domain_premises, narrowed_sets. fold es.
  rewrite map_map, Forall_app, !Forall_props, !Forall_map.
  assert (A0 : Forall (says (l p)) (variable_ranges g) <-> Forall (fun r => says [p] (subst_rel es r)) (variable_ranges g)).
  { rewrite !Forall_forall. split; intros H r I0; pose proof I0 as J; apply filter_In in J as [J _];
      apply (subst_related es p (fun _ => true) r (range_only r J)); auto. }
  assert (A1 : Forall (fun h => says_all (l p) h) (narrowing F) <-> Forall (fun h => says_all [p] (subst_says es h)) (narrowing F)).
  { rewrite !Forall_forall. split; intros H h I0; apply narrow_says; auto. }
  tauto.
Qed.
Lemma shown_on_domain h c p : on_domain g F h c = true -> in_domain g (narrowed_sets F l) l p -> says_all [p] (subst_says es h).
Proof.
  unfold on_domain. intros C D. apply domain_there in D as [D1 D2].
  apply proved with (l := [p]) in C. unfold states, at_point_of in C. rewrite imply_all, arrow_imp in C.
  cbn [ranges premises conditions claim concludes] in C. apply C; [|exact I].
  apply Forall_app; split; apply (proj2 (Forall_props _ _)).
  - destruct (fst c); [trivial|constructor].
  - rewrite Forall_forall in *. intros k K. apply filter_In in K as [K _]. auto.
Qed.
Lemma range_there i p : in_domain g (narrowed_sets F l) l p -> (i < length es)%nat -> i <> variable g ->
  conj (flat [p] (links (subst_says es (range_of g i)))).
Proof.
  intros D L N. destruct met as [_ [Rp _]].
  destruct (all2_in _ _ _ i Rp) as [c [_ C]]; [apply in_seq; simpl; auto with arith|].
  apply orb_true_iff in C as [C|C]; [apply Nat.eqb_eq in C; contradiction|]. split_bools.
  match goal with G : on_domain _ _ _ _ = true |- _ => pose proof (shown_on_domain _ _ _ G D) as S end.
  unfold says_all in S. rewrite arrow_imp in S. apply S. exact I.
Qed.
Lemma domain_total p : in_domain g (narrowed_sets F l) l p -> forall i : nat, true = true -> total [p] (nth i es (Num 0 1)).
Proof.
  intros D i _. destruct (Nat.lt_ge_cases i (length es)) as [L|G].
  - destruct (Nat.eq_dec i (variable g)) as [->|N]; [rewrite variable_place; exact I|].
    apply (range_flat i p). apply range_there; trivial.
  - rewrite nth_overflow by trivial. exact I.
Qed.
Lemma along_there h p : In h (with_role Along g) -> in_domain g (narrowed_sets F l) l p -> says_all (l p) h.
Proof.
  intros I0 D. destruct (with_role_shown _ _ I0) as [S [c C]]. unfold premise_shown in C. cbn [fst snd] in C. split_bools.
  match goal with G : negb (speaks h) || _ = true |- _ => rewrite S in G; simpl in G; rename G into P end.
  apply (subst_sentence es p (fun _ => true) (domain_total p D)); trivial. apply shown_on_domain with c; trivial.
Qed.
Lemma alone_supposed : supposed (alone g F) [] used (fun x => [x]).
Proof.
  destruct met as [_ [_ [_ [_ [_ [_ [_ [_ [_ [_ [R0 _]]]]]]]]]]]. split.
  - intro p. unfold constantly.
    assert (K : constant_ranges (alone g F) = []).
    { unfold constant_ranges. cbn [fixed alone]. induction (all_ranges _); simpl; trivial. }
    rewrite K. repeat constructor.
  - intros s _. exists 1. split; [lra|]. intros. constructor.
  - unfold functionally. change (function_ranges (alone g F)) with (function_ranges (family_of g F)). rewrite R0. constructor.
  - trivial.
  - intros p q i [].
Qed.
Let own_sets := map (fun h p => says_all [p] h) (domain_premises g F).
Lemma near_there s : In s used -> small (fun t => Forall (fun d : R -> Prop => d (germ_point s t)) own_sets).
Proof.
  intro Is. destruct met_domain as [_ [_ [Rl [Wf Wi]]]]. destruct (Wi s Is) as [w C]. clear Wi.
  pose proof (germ_there (alone g F) [] used (fun x => [x]) Wf alone_supposed 0 s Is) as [d Ge].
  unfold within_shown in C. cbv zeta in C. split_bools. set (a := alone g F) in *.
  set (env := at_point a [0]) in *. set (pc := passing_of a used) in *.
  match goal with G : refute _ _ _ [] (within_positive w) = true |- _ => rename G into Cp end.
  match goal with G : all2 _ _ _ = true |- _ => rename G into Ci end.
  match goal with G : mentions_only _ (within_num w) = true |- _ => rename G into Mn end.
  match goal with G : mentions_only _ (within_den w) = true |- _ => rename G into Md end.
  assert (Free : forall e, some_cases e (map (fun _ => nothing) (domain_premises g F) ++ [nothing])).
  { intro e. apply Forall_app; split; [|apply Forall_cons; [apply nothing_holds|apply Forall_nil]].
    apply Forall_map, Forall_forall. intros. apply nothing_holds. }
  assert (PP : 0 < peval env (within_num w) /\ 0 < peval env (within_den w)).
  { destruct (Rlt_dec 0 (peval env (within_num w))) as [N0|N0];
      [destruct (Rlt_dec 0 (peval env (within_den w))) as [D0|D0]; [tauto|]|];
      exfalso; apply (refute_sound None depth _ _ _ env I Cp (Forall_nil _)); apply Forall_app; (split; [apply Free|]);
      (apply Forall_cons; [|apply Forall_nil]).
    - exists [anot (A (within_den w) SP)]. split; [right; left; trivial|]. apply Forall_cons; [|apply Forall_nil]. apply anot_holds. exact D0.
    - exists [anot (A (within_num w) SP)]. split; [left; trivial|]. apply Forall_cons; [|apply Forall_nil]. apply anot_holds. exact N0. }
  destruct PP as [Pn Pd]. destruct Ge as [Dp [Es _]].
  exists (Rmin d (peval env (within_num w) / peval env (within_den w))).
  split; [apply Rmin_glb_lt; trivial; apply Rdiv_lt_0_compat; trivial|]. intros t [T U].
  pose proof (Rmin_l d (peval env (within_num w) / peval env (within_den w))).
  pose proof (Rmin_r d (peval env (within_num w) / peval env (within_den w))).
  destruct (Es t ltac:(lra)) as [OS _].
  assert (G : all_hold (on_germ a (fun x => [x]) s t) (germ_atoms pc s (within_num w) (within_den w) [])).
  { apply germ_atoms_hold with env t; trivial; try apply Forall_nil. lra. }
  pose proof (agrees_germ a (fun x => [x]) s t) as AG. set (e := on_germ a (fun x => [x]) s t) in *.
  unfold own_sets. apply Forall_map, Forall_forall. intros h I0.
  destruct (all2_in _ _ _ h Ci I0) as [p [_ Cp']].
  pose proof (rootless_rooted_sentence [germ_point s t] h (Rl h I0)) as RT.
  destruct (says_all_dec [germ_point s t] h e (offset a) AG RT) as [|N]; trivial. exfalso.
  apply (refute_sound None depth _ _ _ e I Cp' G). apply Forall_app; split; [apply Free|].
  apply Forall_cons; [|apply Forall_nil]. apply (fails_spec (offset a) e _ h AG RT). exact N.
Qed.
Lemma supposed_family : supposed (family_of g F) own_sets used (fun x => [x]).
Proof.
  destruct met as [_ [_ [_ [_ [_ [_ [_ [_ [E0 [A0 [R0 _]]]]]]]]]]]. split.
  - intro p. unfold constantly. rewrite E0. cbn [always_when family_of conditions body premised flat_map map].
    assert (K : constant_ranges (family_of g F) = []).
    { unfold constant_ranges. cbn [fixed family_of]. induction (all_ranges _); simpl; trivial. }
    assert (S0 : spoken_parts (family_of g F) = []).
    { unfold spoken_parts. cbn [parts family_of]. induction (domain_premises g F); simpl; trivial. }
    rewrite K, S0. constructor.
  - exact near_there.
  - unfold functionally. rewrite R0. apply Forall_map, Forall_forall. intros h I0 x. rewrite imply_all. intro Dx.
    unfold domain in Dx. apply Forall_app in Dx as [_ Dx]. unfold own_sets in Dx. rewrite map_map in Dx.
    apply (proj1 (Forall_props _ _)) in Dx. rewrite Forall_forall in Dx. apply Dx.
    unfold moving in I0. apply in_map_iff in I0 as [q [<- I0]]. apply filter_In in I0 as [I0 _].
    apply (roled_premise (family_of g F)) in I0. exact I0.
  - trivial.
  - intros p q i [].
Qed.
Lemma limit_there f to cs : proves_limit (family_of g F) used f to cs = true -> forall s c, In (s, c) cs ->
  match to with Finite v => total [0] v | _ => True end /\ reaches (fun x => [x]) [0] f to s.
Proof.
  unfold proves_limit. intros C s c I0. split_bools.
  match goal with G : forallb _ cs = true |- _ => rewrite forallb_forall in G; specialize (G _ I0); cbn [fst snd] in G end.
  eapply (side_sound (family_of g F) own_sets used (fun x => [x])); [eassumption|apply supposed_family|eassumption].
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
Lemma all_met : Forall (fun P : Prop => P) (given_all g (narrowed_to F) l).
Proof.
  destruct met as [_ [_ [_ [_ [Ln [Fr [_ [Aw [_ [_ [_ Pr]]]]]]]]]]]. unfold given_all. apply Forall_app; split;
    [|apply Forall_app; split; [cbn [narrowed_to sets sides_reached]; destruct (narrowed_sets _ _); constructor|]].
  - unfold constantly. apply Forall_app; split; [|apply Forall_app; split; [|apply Forall_app; split; [|apply Forall_app; split]]].
    + apply (proj2 (Forall_props _ _)). apply Forall_forall. intros r I0. apply filter_In in I0 as [I0 C].
      apply (proj2 (range_flat (subject r) 0 (fixed_there _ 0 (mem_in _ _ C)))); trivial. apply range_only; trivial.
    + apply (proj2 (Forall_props _ _)). apply Forall_forall. intros h I0.
      destruct (with_role_shown _ _ I0) as [S [c C]]. unfold premise_shown in C. cbn [fst snd] in C. split_bools.
      match goal with G : negb (speaks h) || _ = true |- _ => rewrite S in G; simpl in G; rename G into P end.
      match goal with G : only_says (fun i => mem i _) h = true |- _ => apply (subst_sentence es 0 _ (fixed_total 0) h G) end.
      apply plainly_says; trivial.
    + apply (proj2 (Forall_props _ _)). apply Forall_forall. intros h I0. destruct met_domain as [_ [Sp _]].
      destruct (Sp h I0) as [Oh Ph]. apply (subst_sentence es 0 _ (fixed_total 0) h Oh). apply plainly_says; trivial.
    + destruct (always_when g) eqn:AW; [|constructor]. destruct (Aw eq_refl) as [->|[O P]]; [constructor|].
      destruct (conditions (body g)) as [|r rs]; [constructor|]. apply Forall_cons; [|constructor].
      apply (subst_flat es 0 _ (fixed_total 0) _ O). apply (plainly_says _ [0] P).
    + apply Forall_flat_map, Forall_forall. intros q I0. destruct (all2_in _ _ _ q Pr I0) as [cs [_ C]].
      apply premised_there with cs; trivial.
  - unfold functionally. apply Forall_app; split.
    + destruct (function_ranges g) as [|r0 rs] eqn:E; [constructor|]. apply Forall_cons; [|constructor].
      destruct Fr as [Fr|Fr]; [discriminate|]. intro x. rewrite imply_all. intro V. rewrite <- E.
      assert (D : in_domain g (narrowed_sets F l) l x).
      { unfold in_domain, domain, narrowed_sets. rewrite Fr. cbn [map]. rewrite app_nil_r. trivial. }
      apply conj_all. apply (proj2 (Forall_props _ _)). apply Forall_forall. intros r I0. apply filter_In in I0 as [I0 C].
      split_bools. apply (proj2 (range_flat (subject r) x (range_there _ x D (Ln r I0)
        ltac:(intro Q; rewrite Q, Nat.eqb_refl in *; discriminate)))); trivial. apply range_only; trivial.
    + apply Forall_map, Forall_forall. intros h I0 x. rewrite imply_all. intro D. apply along_there; trivial.
      unfold moving in I0. unfold with_role. apply in_map_iff in I0 as [q [E I0]]. apply in_map_iff. exists q.
      split; trivial. apply filter_In in I0 as [I0 C]. apply filter_In. split; trivial.
      cbn [narrowed_to all_premises andb] in C. rewrite orb_false_r in C. trivial.
Qed.
End Met.

(** ** They refute *)

(** The conclusion fails at a point of the domain. *)
Definition refutes_point (g : family) (F : functions) (used : list side) (w : witness) : bool :=
  let es := exprs F in
  meets g F used && Nat.eqb (length (coordinates w)) 1 &&
  forallb (only_rel (fun _ => true)) (conditions (body g)) && only_conclusion (fun _ => true) (claim (body g)) &&
  refutes (at_point_of g F true (if always_when g then [] else map (subst_rel es) (conditions (body g)))
    (subst_conclusion es (claim (body g)))) w.
Theorem point_refuted g F used w : refutes_point g F used w = true -> ~ states_point g (narrowed_to F) (along (exprs F)).
Proof.
  unfold refutes_point. cbv zeta. intros C S. split_bools.
  match goal with G : meets _ _ _ = true |- _ => rename G into M end.
  match goal with G : refutes _ _ = true |- _ => apply (refuted _ w G) end.
  match goal with G : Nat.eqb (length _) 1 = true |- _ => apply Nat.eqb_eq in G; rename G into L end.
  assert (P : exists x, place w 0 = [x]).
  { unfold place. destruct (coordinates w) as [|c [|d cs]]; try discriminate. eexists; reflexivity. }
  destruct P as [x ->]. unfold states_point in S. rewrite imply_all in S. specialize (S (all_met g F used M) x).
  unfold states, at_point_of. cbn [ranges premises conditions claim]. rewrite imply_all. intro HA. apply Forall_app in HA as [HR HP].
  apply (proj1 (Forall_props _ _)) in HR. apply (proj1 (Forall_props _ _)) in HP.
  assert (D : in_domain g (narrowed_sets F (along (exprs F))) (along (exprs F)) x).
  { apply (domain_there g F used M). split; trivial. rewrite Forall_forall in *. intros h I0.
    destruct (speaks h) eqn:Sp; [apply HP; apply filter_In; auto|].
    unfold speaks, says_all in *. destruct (links h); [|discriminate]. rewrite arrow_imp. destruct (given h); simpl; trivial. }
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
  ~ states_limit g (narrowed_to F) (along (exprs F)) f to ss.
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
