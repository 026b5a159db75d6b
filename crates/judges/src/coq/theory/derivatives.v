(** ** The derivative of a fraction *)

Lemma derives_near F G a v : locally a (fun x => F x = G x) -> derivable_pt_lim F a v -> derivable_pt_lim G a v.
Proof.
  intros [d [D H]]. apply (derivable_pt_lim_locally_ext F G a (a - d) (a + d)).
  - lra.
  - intros z Z. apply H. apply Rabs_def1; lra.
Qed.
Lemma meval_far e v x m : forall k, (v < k)%nat -> meval (move e v x) k m = meval e k m.
Proof.
  induction m as [|n m IH]; intros k K; simpl; trivial. rewrite IH by auto. unfold move.
  destruct (Nat.eqb_spec k v) as [->|]; trivial. exfalso. apply (Nat.lt_irrefl v); trivial.
Qed.
Lemma meval_trim e m : forall k, meval e k (trim m) = meval e k m.
Proof.
  induction m as [|n m IH]; intro k; simpl; trivial. specialize (IH (S k)).
  destruct n, (trim m); simpl in *; rewrite <- ?IH; trivial; ring.
Qed.
Lemma move_moved e v x k : k <> v -> move e v x k = e k.
Proof. unfold move. destruct (Nat.eqb_spec k v); tauto. Qed.
Lemma move_new e v x : move e v x v = x.
Proof. unfold move. rewrite Nat.eqb_refl. trivial. Qed.

(** At [a] all variables have the values [move e v a]. *)
Lemma mono_derives e a m : forall v k,
  derivable_pt_lim (fun x => meval (move e (v + k) x) k m) a (INR (nth v m 0%nat) * meval (move e (v + k) a) k (lessen v m)).
Proof.
  induction m as [|n m IH]; intros v k.
  - replace (INR (nth v [] 0%nat) * _) with 0 by (destruct v; simpl; ring). apply (derivable_pt_lim_const 1).
  - destruct v as [|v]; cbn [nth lessen meval Nat.add].
    + apply derivable_pt_lim_ext with (fun x => meval e (S k) m * x ^ n).
      * intro x. rewrite move_new, meval_far by auto. ring.
      * rewrite move_new, meval_far by auto.
        replace (INR n * (a ^ pred n * meval e (S k) m)) with (meval e (S k) m * (INR n * a ^ pred n)) by ring.
        apply (derivable_pt_lim_scal (fun x => x ^ n)). apply derivable_pt_lim_pow.
    + assert (E : forall x, move e (S (v + k)) x k = e k).
      { intro x. apply move_moved. pose proof (Nat.le_add_l k v) as J. intro E. rewrite E in J at 1.
        apply (Nat.nle_succ_diag_l _ J). }
      rewrite E. apply derivable_pt_lim_ext with (fun x => e k ^ n * meval (move e (S (v + k)) x) (S k) m).
      * intro x. rewrite E. trivial.
      * replace (INR (nth v m 0%nat) * (e k ^ n * meval (move e (S (v + k)) a) (S k) (lessen v m)))
          with (e k ^ n * (INR (nth v m 0%nat) * meval (move e (S (v + k)) a) (S k) (lessen v m))) by ring.
        apply (derivable_pt_lim_scal (fun x => meval (move e (S (v + k)) x) (S k) m)).
        specialize (IH v (S k)). rewrite <- plus_n_Sm in IH. exact IH.
Qed.
Lemma poly_derives e v a p :
  derivable_pt_lim (fun x => peval (move e v x) p) a (peval (move e v a) (pderiv v p)).
Proof.
  induction p as [|[m c] p IH]; cbn [peval pderiv]; [apply (derivable_pt_lim_const 0)|].
  rewrite peval_add, peval_scale. cbn [peval]. rewrite meval_trim, <- INR_IZR_INZ.
  apply (derivable_pt_lim_plus (fun x => IZR c * meval (move e v x) 0 m) (fun x => peval (move e v x) p)); trivial.
  pose proof (mono_derives e a m v 0) as M. rewrite Nat.add_0_r in M.
  replace (INR (nth v m 0%nat) * (IZR c * meval (move e v a) 0 (lessen v m) + 0))
    with (IZR c * (INR (nth v m 0%nat) * meval (move e v a) 0 (lessen v m))) by ring.
  apply (derivable_pt_lim_scal (fun x => meval (move e v x) 0 m)). exact M.
Qed.

(** [F] is the fraction [q] near [a]. *)
Definition fraction (e : nat -> R) (v : nat) (F : R -> R) (a : R) (q : frac) : Prop :=
  locally a (fun x => stands (move e v x) (F x) q).
Definition frac_value (e : nat -> R) (q : frac) : R := peval e (fst q) / peval e (snd q).
Lemma stands_value e w q : stands e w q <-> peval e (snd q) <> 0 /\ w = frac_value e q.
Proof.
  unfold stands, frac_value. split; intros [D N]; (split; [trivial|]).
  - rewrite <- N. field; trivial.
  - rewrite N. field; trivial.
Qed.
Lemma frac_derives e v F a q : fraction e v F a q ->
  peval (move e v a) (snd (slope v q)) <> 0 /\ derivable_pt_lim F a (frac_value (move e v a) (slope v q)).
Proof.
  intro H. pose proof (locally_here _ _ H) as [D _]. set (ea := move e v a) in *.
  pose proof (poly_derives e v a (fst q)) as Dn. pose proof (poly_derives e v a (snd q)) as Dd. fold ea in Dn, Dd.
  assert (E : locally a (fun x => peval (move e v x) (fst q) / peval (move e v x) (snd q) = F x)).
  { generalize H. apply locally_weaken. intros x S. apply stands_value in S as [_ ->]. trivial. }
  assert (Q : derivable_pt_lim F a ((peval ea (pderiv v (fst q)) * peval ea (snd q) - peval ea (pderiv v (snd q)) * peval ea (fst q)) / Rsqr (peval ea (snd q)))).
  { apply (derives_near _ _ _ _ E).
    apply (derivable_pt_lim_div (fun x => peval (move e v x) (fst q)) (fun x => peval (move e v x) (snd q))); trivial. }
  unfold slope, frac_value. destruct (as_const (snd q)) as [c|] eqn:C; cbn [fst snd].
  - split; trivial. apply (derives_near _ _ _ _ E).
    apply derivable_pt_lim_ext with (fun x => / IZR c * peval (move e v x) (fst q)).
    + intro x. rewrite (as_const_eval _ _ _ C). unfold Rdiv. ring.
    + rewrite (as_const_eval _ _ _ C). unfold Rdiv. rewrite Rmult_comm.
      apply (derivable_pt_lim_scal (fun x => peval (move e v x) (fst q))). exact Dn.
  - rewrite !peval_sub, !peval_mul. split; [apply Rmult_integral_contrapositive; auto|].
    replace (peval ea (fst q) * peval ea (pderiv v (snd q))) with (peval ea (pderiv v (snd q)) * peval ea (fst q)) by ring.
    exact Q.
Qed.
Lemma slope_fraction e v F G a q : fraction e v F a q -> locally a (fun x => derivable_pt_lim F x (G x)) ->
  fraction e v G a (slope v q).
Proof.
  intros H K. generalize (locally_twice _ _ H) K. apply locally_and. intros x Hx Kx.
  destruct (frac_derives e v F x q Hx) as [D E]. apply stands_value. split; trivial.
  eapply uniqueness_limite; eassumption.
Qed.
Lemma derives_value e v n : forall F a q w, fraction e v F a q -> derives n F a w -> stands (move e v a) w (slopes n v q).
Proof.
  induction n as [|n IH]; cbn [derives slopes]; intros F a q w H K.
  - destruct (frac_derives e v F a q H) as [D E]. apply stands_value. split; trivial.
    eapply uniqueness_limite; eassumption.
  - destruct K as [G [d [D [K1 K2]]]]. apply (IH G); trivial. apply (slope_fraction e v F); trivial. exists d; auto.
Qed.
Lemma derives_exists e v n : forall F a q, fraction e v F a q -> derives n F a (frac_value (move e v a) (slopes n v q)).
Proof.
  induction n as [|n IH]; cbn [derives slopes]; intros F a q H.
  - apply (frac_derives e v F a q H).
  - assert (K : locally a (fun x => derivable_pt_lim F x (frac_value (move e v x) (slope v q)))).
    { generalize (locally_twice _ _ H). apply locally_weaken. intros x Hx. apply (frac_derives e v F x q Hx). }
    pose proof (slope_fraction e v F (fun x => frac_value (move e v x) (slope v q)) a q H K) as Hs.
    destruct K as [d [D K]]. exists (fun x => frac_value (move e v x) (slope v q)), d. split; [trivial|split; [trivial|]].
    apply IH. trivial.
Qed.
Lemma peval_same e e' p : (forall k, e k = e' k) -> peval e p = peval e' p.
Proof.
  intro E. induction p as [|[m c] p IH]; simpl; trivial. rewrite IH. f_equal. f_equal.
  generalize 0%nat. induction m as [|n m IHm]; intro k; simpl; trivial. rewrite E, IHm. trivial.
Qed.
Lemma stands_same e e' w q : (forall k, e k = e' k) -> stands e w q -> stands e' w q.
Proof. intros E. unfold stands. rewrite !(peval_same e e' _ E). trivial. Qed.
Lemma derives_slopes off e l i a n w q : agrees off e l -> (i < length l)%nat ->
  near_value true off e l i a (Some q) -> derives n (fun x => ev (upd i x l) a) (nth i l 0) w ->
  stands e w (slopes n (off + i) q).
Proof.
  intros AG L [_ [_ [_ G]]] D. apply stands_same with (move e (off + i) (nth i l 0)).
  - apply move_here; trivial.
  - apply derives_value with (2 := D). apply G. trivial.
Qed.
(** Where an expression is differentiable, there is a number that is its derivative. *)
Lemma slope_exists n i f l : (i < length l)%nat ->
  exists w, arrow (near_conds true i l f) (derives n (fun x => ev (upd i x l) f) (nth i l 0) w).
Proof.
  intro L. set (e := fun k => nth k l 0). assert (AG : agrees 0 e l) by (intro; trivial).
  destruct (near_spec 0 e l i AG L true f) as [A0 [[c [q|]] [I0 H]]]; specialize (A0 _ I0 H); cbn [snd near_value] in A0.
  - destruct A0 as [_ [_ [_ G]]]. eexists. apply arrow_imp. intros _. apply (derives_exists e i n _ _ q). apply G. trivial.
  - exists 0. apply arrow_imp. tauto.
Qed.
