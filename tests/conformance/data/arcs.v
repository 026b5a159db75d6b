(* What `(arc theta)` says holds of the sine and the cosine of Coq's library. *)
Require Import Reals Lra.
Open Scope R_scope.

(* what starts at 0 and has no negative slope is not negative *)
Lemma rises : forall f g, f 0 = 0 -> (forall x, derivable_pt_lim f x (g x)) ->
  (forall x, 0 <= x -> 0 <= g x) -> forall x, 0 <= x -> 0 <= f x.
Proof.
  intros f g Z D P x H. destruct (Req_dec x 0) as [E | N].
  - rewrite E, Z. lra.
  - destruct (MVT_cor2 f g 0 x) as [c [E [L M]]]; [lra | intros; apply D |].
    rewrite Z in E. assert (Q := P c ltac:(lra)).
    assert (0 <= g c * (x - 0)) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma sin_le : forall x, 0 <= x -> 0 <= x - sin x.
Proof.
  apply (rises (fun y => y - sin y) (fun y => 1 - cos y)).
  - rewrite sin_0; lra.
  - intros y. apply derivable_pt_lim_minus; [apply derivable_pt_lim_id | apply derivable_pt_lim_sin].
  - intros y _. assert (B := COS_bound y). lra.
Qed.

Lemma minus_sin_le : forall x, 0 <= x -> 0 <= x + sin x.
Proof.
  apply (rises (fun y => y + sin y) (fun y => 1 + cos y)).
  - rewrite sin_0; lra.
  - intros y. apply derivable_pt_lim_plus; [apply derivable_pt_lim_id | apply derivable_pt_lim_sin].
  - intros y _. assert (B := COS_bound y). lra.
Qed.

Lemma square_sin_le : forall x, sin x * sin x <= x * x.
Proof.
  assert (P : forall x, 0 <= x -> sin x * sin x <= x * x).
  { intros x H. assert (A := sin_le x H). assert (B := minus_sin_le x H).
    destruct (Rle_dec 0 (sin x)); [apply Rmult_le_compat; lra |].
    replace (sin x * sin x) with (- sin x * - sin x) by ring. apply Rmult_le_compat; lra. }
  intros x. destruct (Rle_dec 0 x) as [H | H]; [apply P; exact H |].
  assert (Q := P (- x) ltac:(lra)). rewrite sin_neg in Q. lra.
Qed.

Lemma cos_ge : forall x, 1 - x ^ 2 / 2 <= cos x.
Proof.
  intros x. assert (H : cos x = 1 - 2 * sin (x / 2) * sin (x / 2)).
  { replace x with (2 * (x / 2)) at 1 by field. apply cos_2a_sin. }
  assert (S := square_sin_le (x / 2)). lra.
Qed.

Lemma sin_ge : forall x, 0 <= x -> 0 <= sin x - (x - x ^ 3 / 6).
Proof.
  apply (rises (fun y => sin y - (y - y ^ 3 / 6)) (fun y => cos y - (1 - y ^ 2 / 2))).
  - rewrite sin_0; lra.
  - intros y. apply derivable_pt_lim_minus; [apply derivable_pt_lim_sin |].
    apply derivable_pt_lim_minus; [apply derivable_pt_lim_id |].
    replace (y ^ 2 / 2) with ((INR 3 * y ^ 2) * / 6) by (simpl; field).
    replace (fun y0 => y0 ^ 3 / 6) with (mult_real_fct (/ 6) (fun y0 => y0 ^ 3)) by (unfold mult_real_fct; apply FunctionalExtensionality.functional_extensionality; intros; field).
    rewrite (Rmult_comm (INR 3 * y ^ 2)). apply derivable_pt_lim_scal. apply (derivable_pt_lim_pow y 3).
  - intros y _. assert (B := cos_ge y). lra.
Qed.

Lemma cos_le : forall x, 0 <= x -> 0 <= (1 - x ^ 2 / 2 + x ^ 4 / 24) - cos x.
Proof.
  apply (rises (fun y => (1 - y ^ 2 / 2 + y ^ 4 / 24) - cos y) (fun y => (0 - y + y ^ 3 / 6) - - sin y)).
  - rewrite cos_0; lra.
  - intros y. apply derivable_pt_lim_minus; [| apply derivable_pt_lim_cos].
    apply derivable_pt_lim_plus.
    + apply derivable_pt_lim_minus; [apply derivable_pt_lim_const |].
      replace y with (/ 2 * (INR 2 * y ^ 1)) at 2 by (simpl; field).
      replace (fun y0 => y0 ^ 2 / 2) with (mult_real_fct (/ 2) (fun y0 => y0 ^ 2)) by (unfold mult_real_fct; apply FunctionalExtensionality.functional_extensionality; intros; field).
      apply derivable_pt_lim_scal. apply (derivable_pt_lim_pow y 2).
    + replace (y ^ 3 / 6) with (/ 24 * (INR 4 * y ^ 3)) by (simpl; field).
      replace (fun y0 => y0 ^ 4 / 24) with (mult_real_fct (/ 24) (fun y0 => y0 ^ 4)) by (unfold mult_real_fct; apply FunctionalExtensionality.functional_extensionality; intros; field).
      apply derivable_pt_lim_scal. apply (derivable_pt_lim_pow y 4).
  - intros y H. assert (B := sin_ge y H). lra.
Qed.

Lemma arc : forall u, u ^ 2 - u ^ 4 / 6 <= u * sin u <= u ^ 2 /\ 1 - u ^ 2 / 2 <= cos u <= 1 - u ^ 2 / 2 + u ^ 4 / 24.
Proof.
  assert (P : forall u, 0 <= u -> u ^ 2 - u ^ 4 / 6 <= u * sin u <= u ^ 2 /\ 1 - u ^ 2 / 2 <= cos u <= 1 - u ^ 2 / 2 + u ^ 4 / 24).
  { intros u H. assert (A := sin_le u H). assert (B := sin_ge u H). assert (C := cos_ge u). assert (D := cos_le u H).
    assert (0 <= u * (u - sin u)) by (apply Rmult_le_pos; lra).
    assert (0 <= u * (sin u - (u - u ^ 3 / 6))) by (apply Rmult_le_pos; lra).
    repeat split; lra. }
  intros u. destruct (Rle_dec 0 u) as [H | H]; [apply P; exact H |].
  assert (Q := P (- u) ltac:(lra)). rewrite sin_neg, cos_neg in Q.
  replace ((- u) ^ 2) with (u ^ 2) in Q by ring. replace ((- u) ^ 4) with (u ^ 4) in Q by ring.
  replace (- u * - sin u) with (u * sin u) in Q by ring. exact Q.
Qed.
