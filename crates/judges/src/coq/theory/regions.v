(** ** The regions are right *)

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
  - match goal with H : arrow _ _ |- _ => rewrite arrow_imp in H; rename H into D0 end.
    match goal with H : (_ < _)%nat |- _ => rename H into L0 end.
    apply spec_each with (near_value true off e l i a).
    + apply near_spec; trivial.
    + exact (fun N => N).
    + intros x V. apply spec_everywhere. split; [apply V|]. cbn [ev]. apply derives_slopes with l a; trivial.
      apply D0. apply V.
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
