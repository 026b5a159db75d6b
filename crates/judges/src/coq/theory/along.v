(** ** What is supposed holds along a germ *)

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
(** Where the denominator is not 0 this compares y with n/d. *)
Definition relates (k : sense) (d y n : R) : Prop :=
  match k with Same => d * y = n | AtLeast => 0 <= d * (d * y - n) | AtMost => d * (d * y - n) <= 0 end.
Lemma against_spec off e l f num den k : agrees off e l -> rootless f = true ->
  spec e (against off f num den k) (fun b => match b with
    | Some true => total l f /\ relates k (peval e den) (ev l f) (peval e num)
    | Some false => total l f /\ ~ relates k (peval e den) (ev l f) (peval e num)
    | None => ~ total l f end).
Proof.
  intros AG RT. unfold against. apply spec_each with (is_value e l f).
  - apply regions_spec; trivial. apply rootless_rooted; trivial.
  - trivial.
  - intros v [C [D N]]. assert (Z : peval e (psub (pmul den (fst v)) (pmul num (snd v))) =
      peval e (snd v) * (peval e den * ev l f - peval e num)).
    { rewrite peval_sub, !peval_mul, <- N. ring. }
    set (gap := psub _ _) in *. assert (B : peval e (pmul (pmul den (snd v)) gap) =
      peval e (snd v) * peval e (snd v) * (peval e den * (peval e den * ev l f - peval e num))).
    { rewrite !peval_mul, Z. ring. }
    assert (P : 0 < peval e (snd v) * peval e (snd v)) by (destruct (Rdichotomy _ _ D); nra).
    set (w := peval e den * (peval e den * ev l f - peval e num)) in *.
    destruct k; apply spec_either; unfold holds; cbn [asign apoly relates]; rewrite ?peval_neg, ?Z, ?B; fold w;
      intro H; split; trivial.
    + apply Rmult_integral in H as [H|H]; [tauto|lra].
    + intro Q. apply H. rewrite Q. ring.
    + nra.
    + nra.
    + nra.
    + nra.
Qed.
Lemma equals_holds off e l f num den : agrees off e l -> rootless f = true ->
  total l f -> peval e den * ev l f = peval e num -> some_case e (equals off f num den).
Proof.
  intros AG RT T Q. apply (select_spec e _ _ is_true True (against_spec off e l f num den Same AG RT)); trivial.
  intros [[|]|]; simpl; tauto.
Qed.
Lemma differs_not off e l f num den k : agrees off e l -> rootless f = true ->
  ~ some_case e (differs off f num den k) -> total l f /\ relates k (peval e den) (ev l f) (peval e num).
Proof.
  intros AG RT N. pose proof (against_spec off e l f num den k AG RT) as S.
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

Record supposed (g : family) (D : list (R -> Prop)) (used : list side) (l : R -> list R) : Prop := Supposed {
  constants_hold : forall p, Forall (fun P : Prop => P) (constantly g l p);
  domain_near : forall s, In s used -> small (fun t => Forall (fun d : R -> Prop => d (germ_point s t)) D);
  functions_hold : Forall (fun P : Prop => P) (functionally g D true l);
  variable_read : forall p, nth (variable g) (l p) 0 = p;
  constants_fixed : forall p q i, In i (fixed g) -> nth i (l p) 0 = nth i (l q) 0
}.
Definition in_domain (g : family) (D : list (R -> Prop)) (l : R -> list R) (p : R) : Prop :=
  Forall (fun P : Prop => P) (domain g D l p).

Section Sound.
Variables (g : family) (Ds : list (R -> Prop)) (used : list side) (l : R -> list R).
Hypothesis W : well_formed g used = true.
Hypothesis H : supposed g Ds used l.
Let off := offset g.

Lemma wf : forallb simple (all_ranges g) = true /\
  (forall s, In s used -> forallb (side_within s) (variable_ranges g) = true) /\
  length (roles g) = length (premises (body g)) /\
  (forall p, Forall (rooted_rel (l p)) (all_ranges g)) /\
  (forall p, Forall (rooted_sentence (l p)) (premises (body g))) /\
  (forall p, rooted_all (l p) (conditions (body g))) /\
  (forall p, rooted_conclusion (l p) (claim (body g))) /\
  (forall ss f v, In (Some (ss, f, v)) (premised g) -> rootless f = true /\ rootless v = true) /\
  (forall p h, In h (parts g) -> rooted_sentence (l p) h).
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
  - match goal with G : forallb rootless_sentence (parts g) = true, I0 : In _ (parts g) |- _ =>
      rewrite forallb_forall in G; apply (rootless_rooted_sentence (l p) _ (G _ I0)) end.
  - match goal with G : forallb rootless_sentence (parts g) = true, I0 : In _ (parts g) |- _ =>
      rewrite forallb_forall in G; apply (rootless_rooted_sentence (l p) _ (G _ I0)) end.
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
  Forall (says_all (l p)) (spoken_parts g) /\
  (always_when g = true -> conj (flat (l p) (conditions (body g)))) /\
  (forall ss f v, In (Some (ss, f, v)) (premised g) -> conj (tends l (l p) f (Finite v) ss)).
Proof.
  pose proof (constants_hold g Ds used l H p) as C. unfold constantly in C.
  apply Forall_app in C as [C1 C]. apply Forall_app in C as [C2 C]. apply Forall_app in C as [C5 C].
  apply Forall_app in C as [C3 C4].
  apply (proj1 (Forall_props _ _)) in C1. apply (proj1 (Forall_props _ _)) in C2. apply (proj1 (Forall_props _ _)) in C5.
  split; [trivial|split; [trivial|split; [trivial|split]]].
  - intro A0. rewrite A0 in C3. destruct (conditions (body g)); [simpl; trivial|]. inversion C3; trivial.
  - intros ss f v I0. apply (proj1 (Forall_flat_map _ _ _)) in C4. rewrite Forall_forall in C4.
    specialize (C4 _ I0). simpl in C4. inversion C4; trivial.
Qed.
Lemma everywhere_holds p h : In (Everywhere, h) (roled g) -> says_all (l p) h.
Proof.
  intro I0. apply (role_holds Everywhere); trivial; [|apply silent].
  intros k K. destruct (constantly_parts p) as [_ [E _]]. rewrite Forall_forall in E. auto.
Qed.
Lemma part_holds p h : In h (parts g) -> says_all (l p) h.
Proof.
  intro I0. destruct (speaks h) eqn:S; [|apply silent; trivial].
  destruct (constantly_parts p) as [_ [_ [E _]]]. rewrite Forall_forall in E. apply E, filter_In. auto.
Qed.
Lemma along_holds p h : in_domain g Ds l p -> In h (premises (body g)) -> says_all (l p) h.
Proof.
  intros I1 I0. assert (M : In h (moving true g) -> says_all (l p) h).
  { intro K. pose proof (functions_hold g Ds used l H) as F. unfold functionally in F. apply Forall_app in F as [_ F].
    rewrite Forall_map, Forall_forall in F. specialize (F h K p). rewrite imply_all in F. auto. }
  destruct (speaks h) eqn:S; [|apply silent; trivial].
  destruct (premise_roled h I0) as [r J]. destruct r; [apply everywhere_holds; trivial| |];
    apply M; unfold moving; apply in_map_iff; eexists; (split; [|apply filter_In; split; [exact J|]]); trivial;
    cbn [fst snd]; rewrite S; trivial.
Qed.
Lemma ranges_there p : Forall (says (l p)) (variable_ranges g) -> Forall (says (l p)) (all_ranges g).
Proof.
  intro V. destruct (constantly_parts p) as [C _]. apply Forall_forall. intros r I0.
  rewrite Forall_forall in C, V.
  destruct (mem (subject r) (fixed g)) eqn:E1.
  { apply C. apply filter_In. auto. }
  destruct (Nat.eqb (subject r) (variable g)) eqn:E2.
  { apply V. apply filter_In. rewrite E1, E2. auto. }
  pose proof (functions_hold g Ds used l H) as F. unfold functionally in F. apply Forall_app in F as [F _].
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
  2: { apply (small_weaken _ _ G). intros t _. rewrite (variable_read g Ds used l H). trivial. }
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
  intros AG Z. destruct wf as [_ [_ [_ [_ [RP [RC [_ [_ PT]]]]]]]]. destruct (constantly_parts p) as [_ [_ [_ [CW _]]]].
  unfold some_cases, free_formulas. apply Forall_app; split; [|apply Forall_app; split; trivial].
  - apply Forall_map, Forall_forall. intros [[r h] k] I0. cbn [fst snd].
    pose proof (in_combine_l _ _ _ _ I0) as I1. pose proof (in_combine_r _ _ _ _ I0) as I2.
    destruct (is_role Everywhere r) eqn:E.
    + destruct r; try discriminate. apply (holds_spec (offset g) e (l p) h AG); [|apply everywhere_holds; trivial].
      specialize (RP p). rewrite Forall_forall in RP. apply RP. apply (roled_premise (Everywhere, h)); trivial.
    + apply (holds_spec (offset g) e (l p) k AG); [apply PT|apply part_holds]; trivial.
  - apply Forall_cons; [|apply Forall_nil]. destruct (always_when g); [|apply nothing_holds].
    apply (where_all_spec (offset g) e (l p)); auto.
Qed.
Lemma values_hold e p : agrees off e (l p) ->
  (forall j ss f v, nth_error (premised g) j = Some (Some (ss, f, v)) -> e (S j) = ev (l p) v) ->
  some_cases e (mapi (value_cases (offset g)) 0 (premised g)).
Proof.
  intros AG Z. destruct wf as [_ [_ [_ [_ [_ [_ [_ [RL _]]]]]]]]. destruct (constantly_parts p) as [_ [_ [_ [_ CT]]]].
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
  intros I0 S. destruct (constantly_parts p) as [_ [_ [_ [_ CT]]]]. specialize (CT _ _ _ I0). unfold tends in CT.
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
  intro Is. destruct wf as [Si [Sd [_ [RR [RP [RC [_ [RL _]]]]]]]].
  pose proof (small_and _ _ (side_within_small s Is) (domain_near g Ds used l H s Is)) as S1.
  assert (S2 : small (fun t => forall q, In q (premised g) -> match q with
    | Some (ss, f, v) => has_side s ss = true -> total (l (germ_point s t)) f | None => True end)).
  { apply small_all. intros [[[ss f] v]|] I1; [|exists 1; split; [lra|trivial]].
    destruct (has_side s ss) eqn:Hs.
    - destruct (premised_germ s ss f v p I1 Hs) as [S _]. apply (small_weaken _ _ S). auto.
    - exists 1. split; [lra|]. discriminate. }
  destruct (small_and _ _ S1 S2) as [d H1].
  destruct H1 as [Dp F].
  exists d. split; [trivial|split].
  - intros t T. destruct (F t T) as [[F1 F0] F2]. pose proof (agrees_germ g l s t) as AG.
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
      - apply binding_holds with t; [lra|trivial|]. rewrite A1. apply (variable_read g Ds used l H).
      - intros k K. apply in_map_iff in K as [i [<- Ii]]. rewrite A1, (agrees_point g (l p) i).
        apply (constants_fixed g Ds used l H); trivial. }
    split; [apply OS; trivial|].
    + right. assert (ID : in_domain g Ds l x).
      { unfold in_domain, domain. apply Forall_app; split; apply (proj2 (Forall_props _ _)); trivial. }
      unfold germ_formulas. apply Forall_app; split; [|apply Forall_app; split; trivial].
      apply formulas_hold with (l x); [exact AG|apply RP|]. apply Forall_forall. intros h I1.
      apply filter_In in I1 as [I1 _]. apply along_holds; trivial.
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
