(* Proofs of what is said of one mode. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements.
Open Scope R_scope.

Lemma w_pos z : 0 <= z < 1 -> 0 < w z.
Proof. intros H. apply sqrt_lt_R0. nra. Qed.
Lemma w_sq z : 0 <= z < 1 -> w z * w z = 1 - z * z.
Proof. intros H. apply sqrt_sqrt. nra. Qed.

Lemma eq_23 : Statements.eq_23.
Proof. intros r z H. unfold v_re, v_im. split; field; exact H. Qed.

(* Rates of the building blocks. *)
Lemma d_rate r z t : 0 < r -> 0 <= z < 1 -> is_derive (d r z) t (- (q r z t / r)).
Proof.
  intros Hr Hz. pose proof (w_pos z Hz) as Hw. pose proof (w_sq z Hz) as W. unfold d, q.
  auto_derive; [trivial|].
  set (e := exp _). set (c := cos _). set (s := sin _).
  replace (- (/ w z * e * s / r)) with (- ((w z * w z + z * z) / w z * e * s / r)) by (rewrite W; field; lra).
  field; lra.
Qed.

Lemma q_rate r z t : 0 < r -> 0 <= z < 1 -> is_derive (q r z) t (q_prime r z t).
Proof.
  intros Hr Hz. pose proof (w_pos z Hz) as Hw. unfold q, q_prime.
  auto_derive; [trivial|]. set (e := exp _). set (c := cos _). set (s := sin _). field; lra.
Qed.

Definition q_second r z t := - (2 * z / r * q_prime r z t + q r z t / (r * r)).
Lemma q_prime_rate r z t : 0 < r -> 0 <= z < 1 -> is_derive (q_prime r z) t (q_second r z t).
Proof.
  intros Hr Hz. pose proof (w_pos z Hz) as Hw. pose proof (w_sq z Hz) as W. unfold q_second, q, q_prime.
  auto_derive; [trivial|]. set (e := exp _). set (c := cos _). set (s := sin _).
  replace (/ w z * e * s / (r * r)) with ((w z * w z + z * z) / w z * e * s / (r * r)) by (rewrite W; field; lra).
  field; lra.
Qed.

Theorem eq_A_9 : Statements.eq_A_9.
Proof. intros r z t Hr Hz. split; [apply d_rate | apply q_rate]; assumption. Qed.

Lemma d_by_q r z t : 0 < r -> 0 <= z < 1 -> d r z t = r * q_prime r z t + 2 * z * q r z t.
Proof. intros Hr Hz. pose proof (w_pos z Hz). unfold d, q, q_prime. field; lra. Qed.

(* Wronski's determinant of d and R q *)
Lemma wronskian r z t : 0 < r -> 0 <= z < 1 -> d r z t * (r * q_prime r z t) + q r z t * q r z t = exp (- (2 * z * t / r)).
Proof.
  intros Hr Hz. pose proof (w_pos z Hz) as Hw. pose proof (w_sq z Hz) as W. unfold d, q, q_prime.
  replace (- (2 * z * t / r)) with (- z * t / r + - z * t / r) by (field; lra). rewrite exp_plus.
  set (e := exp _). pose proof (sin2_cos2 (w z * t / r)) as T. unfold Rsqr in T. set (c := cos _) in *. set (s := sin _) in *.
  replace (e * (c + z / w z * s) * (r * (/ r * e * (c - z / w z * s))) + / w z * e * s * (/ w z * e * s))
    with (e * e * (c * c + (1 - z * z) / (w z * w z) * (s * s))) by (field; lra).
  rewrite <- W. replace (w z * w z / (w z * w z)) with 1 by (field; lra). rewrite Rmult_1_l. replace (c * c + s * s) with 1 by
    lra. ring.
Qed.

Lemma at_start r z : 0 < r -> 0 <= z < 1 -> d r z 0 = 1 /\ q r z 0 = 0 /\ q_prime r z 0 = / r.
Proof.
  intros Hr Hz. pose proof (w_pos z Hz). unfold d, q, q_prime.
  replace (- z * 0 / r) with 0 by (field; lra). replace (w z * 0 / r) with 0 by (field; lra).
  rewrite exp_0, cos_0, sin_0. repeat split; field; lra.
Qed.

(* A function that does not change inside has one value. *)
Lemma constant_inside (f : R -> R) T : 0 < T -> (forall t, 0 <= t <= T -> continuous f t) -> (forall t, 0 < t < T -> is_derive f
  t 0) ->
  forall t, 0 <= t <= T -> f t = f 0.
Proof.
  intros HT Hc Hd t Ht. destruct (MVT_gen f 0 t (fun _ => 0)) as [c [_ E]].
  - intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. apply Hd. lra.
  - intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. apply continuity_pt_filterlim. apply Hc. lra.
  - lra.
Qed.

Lemma continuous_of_derive (f : R -> R) t a : is_derive f t a -> continuous f t.
Proof. intros H. apply (ex_derive_continuous (K := R_AbsRing) (V := R_NormedModule)). exists a. exact H. Qed.

Lemma second_of r a b c : 0 < r -> r ^ 2 * a + b + c = 0 -> a = - (b + c) / r ^ 2.
Proof.
  intros Hr H. assert (r ^ 2 <> 0) by nra. apply (Rmult_eq_reg_l (r ^ 2)); [|assumption].
  replace (r ^ 2 * (- (b + c) / r ^ 2)) with (- (b + c)) by (field; lra). lra.
Qed.

(* The free motion is determined by its start. *)
Lemma free_motion r z T (y y1 y2 : R -> R) : 0 < r -> 0 <= z < 1 -> 0 < T ->
  (forall t, 0 <= t <= T -> continuous y t /\ continuous y1 t) ->
  (forall t, 0 < t < T -> is_derive y t (y1 t) /\ is_derive y1 t (y2 t) /\ r ^ 2 * y2 t + 2 * z * r * y1 t + y t = 0) ->
  forall t, 0 <= t <= T -> y t = d r z t * y 0 + r * q r z t * y1 0 /\ y1 t = - (q r z t / r) * y 0 + r * q_prime r z t * y1 0.
Proof.
  intros Hr Hz HT Hc He t Ht.
  set (E := fun t => exp (2 * z * t / r)).
  set (c1 := fun t => E t * (y t * (r * q_prime r z t) - y1 t * (r * q r z t))).
  set (c2 := fun t => E t * (y1 t * d r z t + y t * (q r z t / r))).
  assert (E' : forall t, is_derive E t (2 * z / r * E t)).
  { intros x. unfold E. auto_derive; [trivial|]. unfold Rdiv. ring. }
  assert (Q0 := at_start r z Hr Hz). destruct Q0 as [D0 [Q0 P0]].
  assert (CE : forall t, continuous E t) by (intros x; eapply continuous_of_derive, E').
  assert (CD : forall t, continuous (d r z) t) by (intros x; eapply continuous_of_derive, d_rate; assumption).
  assert (CQ : forall t, continuous (q r z) t) by (intros x; eapply continuous_of_derive, q_rate; assumption).
  assert (CP : forall t, continuous (q_prime r z) t) by (intros x; eapply continuous_of_derive, q_prime_rate; assumption).
  assert (E0 : E 0 = 1) by (unfold E; replace (2 * z * 0 / r) with 0 by (field; lra); apply exp_0).
  assert (C1 : c1 t = c1 0).
  { apply (constant_inside c1 T); [lra| | |lra].
    - intros x Hx. destruct (Hc x Hx) as [Cy Cy1]. unfold c1.
      apply (continuous_mult (K := R_AbsRing)); [apply CE|]. apply (continuous_minus (V := R_NormedModule)).
      + apply (continuous_mult (K := R_AbsRing)); [exact Cy|]. apply (continuous_mult (K := R_AbsRing)); [apply
        continuous_const|apply CP].
      + apply (continuous_mult (K := R_AbsRing)); [exact Cy1|]. apply (continuous_mult (K := R_AbsRing)); [apply
        continuous_const|apply CQ].
    - intros x Hx. destruct (He x Hx) as [Dy [Dy1 Eq]]. unfold c1.
      evar_last.
      { apply (is_derive_mult (K := R_AbsRing) E); [apply E' | | intros; apply Rmult_comm].
        apply (is_derive_minus (V := R_NormedModule)).
        - apply (is_derive_mult (K := R_AbsRing) y); [exact Dy | | intros; apply Rmult_comm].
          apply (is_derive_scal (q_prime r z)), q_prime_rate; assumption.
        - apply (is_derive_mult (K := R_AbsRing) y1); [exact Dy1 | | intros; apply Rmult_comm].
          apply (is_derive_scal (q r z)), q_rate; assumption. }
      unfold plus, minus, opp, mult, scal; simpl; unfold mult; simpl. unfold q_second, plus, opp; simpl.
      replace (y2 x) with (- (2 * z * r * y1 x + y x) / r ^ 2) by (symmetry; apply second_of; assumption).
      field; lra. }
  assert (C2 : c2 t = c2 0).
  { apply (constant_inside c2 T); [lra| | |lra].
    - intros x Hx. destruct (Hc x Hx) as [Cy Cy1]. unfold c2.
      apply (continuous_mult (K := R_AbsRing)); [apply CE|]. apply (continuous_plus (V := R_NormedModule)).
      + apply (continuous_mult (K := R_AbsRing)); [exact Cy1|apply CD].
      + apply (continuous_mult (K := R_AbsRing)); [exact Cy|]. apply (continuous_mult (K := R_AbsRing)); [apply CQ|apply
        continuous_const].
    - intros x Hx. destruct (He x Hx) as [Dy [Dy1 Eq]]. unfold c2.
      evar_last.
      { apply (is_derive_mult (K := R_AbsRing) E); [apply E' | | intros; apply Rmult_comm].
        apply (is_derive_plus (V := R_NormedModule)).
        - apply (is_derive_mult (K := R_AbsRing) y1); [exact Dy1 | apply d_rate; assumption | intros; apply Rmult_comm].
        - apply (is_derive_mult (K := R_AbsRing) y); [exact Dy | | intros; apply Rmult_comm].
          apply (is_derive_ext (fun t => / r * q r z t)); [intros; unfold Rdiv; apply Rmult_comm|].
          apply (is_derive_scal (q r z)), q_rate; assumption. }
      unfold plus, mult, scal; simpl; unfold mult, plus; simpl. rewrite (d_by_q r z x) by assumption.
      replace (y2 x) with (- (2 * z * r * y1 x + y x) / r ^ 2) by (symmetry; apply second_of; assumption).
      field; lra. }
  assert (W := wronskian r z t Hr Hz).
  assert (EE : E t * exp (- (2 * z * t / r)) = 1).
  { unfold E. rewrite <- exp_plus. replace (2 * z * t / r + - (2 * z * t / r)) with 0 by ring. apply exp_0. }
  unfold c1 in C1. unfold c2 in C2. rewrite Q0, P0, E0 in C1. rewrite D0, Q0, E0 in C2.
  replace (1 * (y 0 * (r * / r) - y1 0 * (r * 0))) with (y 0) in C1 by (field; lra).
  replace (1 * (y1 0 * 1 + y 0 * (0 / r))) with (y1 0) in C2 by (field; lra).
  rewrite <- C1, <- C2. rewrite <- W in EE. split.
  - replace (y t) with (y t * (E t * (d r z t * (r * q_prime r z t) + q r z t * q r z t))) at 1 by (rewrite EE; ring).
    field; lra.
  - replace (y1 t) with (y1 t * (E t * (d r z t * (r * q_prime r z t) + q r z t * q r z t))) at 1 by (rewrite EE; ring).
    field; lra.
Qed.
