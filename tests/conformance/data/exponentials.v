(* What `(exp x)` and `(log x)` say holds of the exponential and the logarithm of Coq's library. *)
Require Import Reals Lra.
Open Scope R_scope.
Lemma exp_bound : forall x n, n > 0 -> exp (x / n) >= 1 + x / n /\ exp (x / n) * (1 - x / n) <= 1.
Proof.
  intros x n _. split.
  - apply Rle_ge, exp_ineq1_le.
  - assert (H : 1 + - (x / n) <= exp (- (x / n))) by apply exp_ineq1_le.
    assert (P := exp_pos (x / n)).
    assert (E : exp (x / n) * exp (- (x / n)) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0).
    rewrite <- E. apply Rmult_le_compat_l; lra.
Qed.
Lemma log_bound : forall x, x > 0 -> ln x <= x - 1 /\ x * ln x >= x - 1.
Proof.
  intros x P.
  assert (H : 1 + ln x <= exp (ln x)) by apply exp_ineq1_le.
  assert (G : 1 + - ln x <= exp (- ln x)) by apply exp_ineq1_le.
  rewrite exp_Ropp, exp_ln in G by lra. rewrite exp_ln in H by lra.
  split; [lra |].
  assert (M : x * (1 + - ln x) <= x * / x) by (apply Rmult_le_compat_l; lra).
  rewrite Rinv_r in M by lra. lra.
Qed.
