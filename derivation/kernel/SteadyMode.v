(* Proofs of (20)-(27), (40), (62) and (A.1)-(A.15) for one mode. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes.
Open Scope R_scope.

Definition braces_second r z t := (1 + g r z) * q_prime r z t / r - u r z * r * q_second r z t.
Definition eta_second r z pj pl b f t := - (pl * r ^ 2 * v_cos r z f t) + b * pj * r ^ 2 * braces_second r z t.

Lemma v_cos_rate r z f t : is_derive (v_cos r z f) t (- v_sin r z f t).
Proof. unfold v_cos, v_sin. auto_derive; [trivial|]. ring. Qed.
Lemma v_sin_rate r z f t : is_derive (v_sin r z f) t (v_cos r z f t).
Proof. unfold v_cos, v_sin. auto_derive; [trivial|]. ring. Qed.

(* Rates of combinations, as one tactic: the goal is is_derive of an expression in d, q, q_prime, v_cos, v_sin. *)
Lemma Derive_d r z t : 0 < r -> 0 <= z < 1 -> ex_derive (d r z) t /\ Derive (d r z) t = - (q r z t / r).
Proof. intros. pose proof (d_rate r z t H H0). split; [eexists; eassumption | apply is_derive_unique; assumption]. Qed.
Lemma Derive_q r z t : 0 < r -> 0 <= z < 1 -> ex_derive (q r z) t /\ Derive (q r z) t = q_prime r z t.
Proof. intros. pose proof (q_rate r z t H H0). split; [eexists; eassumption | apply is_derive_unique; assumption]. Qed.
Lemma Derive_q_prime r z t : 0 < r -> 0 <= z < 1 -> ex_derive (q_prime r z) t /\ Derive (q_prime r z) t = q_second r z t.
Proof. intros. pose proof (q_prime_rate r z t H H0). split; [eexists; eassumption | apply is_derive_unique; assumption]. Qed.
Lemma Derive_v_cos r z f t : ex_derive (v_cos r z f) t /\ Derive (v_cos r z f) t = - v_sin r z f t.
Proof. pose proof (v_cos_rate r z f t). split; [eexists; eassumption | apply is_derive_unique; assumption]. Qed.
Lemma Derive_v_sin r z f t : ex_derive (v_sin r z f) t /\ Derive (v_sin r z f) t = v_cos r z f t.
Proof. pose proof (v_sin_rate r z f t). split; [eexists; eassumption | apply is_derive_unique; assumption]. Qed.

Ltac rates r z t Hr Hz :=
  destruct (Derive_d r z t Hr Hz) as [? Xd]; destruct (Derive_q r z t Hr Hz) as [? Xq];
  destruct (Derive_q_prime r z t Hr Hz) as [? Xp];
  auto_derive; [repeat split; try assumption; try apply Derive_v_cos; try apply Derive_v_sin |
    repeat match goal with
    | |- context [Derive (fun x => d r z x) t] => change (fun x => d r z x) with (d r z)
    | |- context [Derive (fun x => q r z x) t] => change (fun x => q r z x) with (q r z)
    | |- context [Derive (fun x => q_prime r z x) t] => change (fun x => q_prime r z x) with (q_prime r z)
    | |- context [Derive (fun x => v_cos r z ?f x) t] => change (fun x => v_cos r z f x) with (v_cos r z f)
    | |- context [Derive (fun x => v_sin r z ?f x) t] => change (fun x => v_sin r z f x) with (v_sin r z f)
    end;
    rewrite ?Xd, ?Xq, ?Xp; repeat rewrite (proj2 (Derive_v_cos _ _ _ _)); repeat rewrite (proj2 (Derive_v_sin _ _ _ _))].

Lemma braces_rate r z t : 0 < r -> 0 <= z < 1 -> is_derive (braces r z) t (braces_prime r z t).
Proof. intros Hr Hz. unfold braces, braces_prime. rates r z t Hr Hz. field; lra. Qed.
Lemma braces_prime_rate r z t : 0 < r -> 0 <= z < 1 -> is_derive (braces_prime r z) t (braces_second r z t).
Proof. intros Hr Hz. unfold braces_prime, braces_second. rates r z t Hr Hz. field; lra. Qed.

Lemma eta_rate r z pj pl b f t : 0 < r -> 0 <= z < 1 -> is_derive (eta r z pj pl b f) t (eta_prime r z pj pl b f t).
Proof.
  intros Hr Hz. unfold eta, eta_prime.
  evar_last. { apply (is_derive_plus (V := R_NormedModule)); apply is_derive_scal; [apply v_cos_rate | apply braces_rate;
    assumption]. }
  unfold plus; simpl. ring.
Qed.
Lemma eta_prime_rate r z pj pl b f t : 0 < r -> 0 <= z < 1 -> is_derive (eta_prime r z pj pl b f) t (eta_second r z pj pl b f t).
Proof.
  intros Hr Hz. unfold eta_prime, eta_second.
  evar_last.
  { apply (is_derive_plus (V := R_NormedModule)).
    - apply (is_derive_opp (V := R_NormedModule)). apply is_derive_scal, v_sin_rate.
    - apply is_derive_scal, braces_prime_rate; assumption. }
  unfold plus, opp; simpl. ring.
Qed.

Lemma braces_equation r z t : 0 < r -> 0 <= z < 1 -> r ^ 2 * braces_second r z t + 2 * z * r * braces_prime r z t + braces r z t
  = 1.
Proof.
  intros Hr Hz. unfold braces, braces_prime, braces_second, q_second. rewrite (d_by_q r z t Hr Hz). field; lra.
Qed.

Lemma load_equation r z f t : (1 - r * r) ^ 2 + (2 * z * r) ^ 2 <> 0 ->
  (1 - r ^ 2) * v_cos r z f t - 2 * z * r * v_sin r z f t = cos (t + f).
Proof. intros H. unfold v_cos, v_sin, v_re, v_im. field. intro K. apply H. rewrite <- K. ring. Qed.

Lemma eta_equation r z pj pl b f t : admissible r z ->
  r ^ 2 * eta_second r z pj pl b f t + 2 * z * r * eta_prime r z pj pl b f t + eta r z pj pl b f t
  = r ^ 2 * (pj * b + pl * cos (t + f)).
Proof.
  intros [Hr [Hz [_ Hv]]]. rewrite <- (load_equation r z f t Hv). unfold eta, eta_prime, eta_second.
  pose proof (braces_equation r z t Hr Hz) as B.
  transitivity (r ^ 2 * pl * ((1 - r ^ 2) * v_cos r z f t - 2 * z * r * v_sin r z f t)
     + r ^ 2 * b * pj * (r ^ 2 * braces_second r z t + 2 * z * r * braces_prime r z t + braces r z t)); [ring|].
  rewrite B. ring.
Qed.

(* (28) and (29) make what friction adds to a mode change sign after half a period. *)
Lemma at_pi r z : 0 < r -> 0 <= z < 1 -> d r z PI = exp (- decay r z) * (cos (theta r z) + z / w z * sin (theta r z)) /\
  q r z PI = / w z * exp (- decay r z) * sin (theta r z) /\
  q_prime r z PI = / r * exp (- decay r z) * (cos (theta r z) - z / w z * sin (theta r z)).
Proof.
  intros Hr Hz. unfold d, q, q_prime, decay, theta.
  replace (- z * PI / r) with (- (PI * z / r)) by (field; lra). replace (w z * PI / r) with (PI * w z / r) by (field; lra). auto.
Qed.

Lemma hyperbolic x : exp (- x) * cosh x = (1 + exp (- x) * exp (- x)) / 2 /\ exp (- x) * sinh x = (1 - exp (- x) * exp (- x)) /
  2 /\ 0 < exp (- x).
Proof.
  assert (E : exp (- x) * exp x = 1) by (rewrite <- exp_plus, Rplus_opp_l; apply exp_0).
  unfold cosh, sinh. pose proof (exp_pos (- x)). repeat split; lra.
Qed.

Lemma braces_mirrored r z : 0 < r -> 0 <= z < 1 -> cosh (decay r z) + cos (theta r z) <> 0 -> mirrored (braces r z)
  (braces_prime r z).
Proof.
  intros Hr Hz HD. destruct (at_start r z Hr Hz) as [D0 [Q0 P0]]. destruct (at_pi r z Hr Hz) as [D1 [Q1 P1]].
  pose proof (w_pos z Hz) as Hw. pose proof (w_sq z Hz) as W.
  destruct (hyperbolic (decay r z)) as [EC [ES Ep]].
  pose proof (sin2_cos2 (theta r z)) as T. unfold Rsqr in T.
  unfold mirrored, braces, braces_prime. rewrite D0, Q0, P0, D1, Q1, P1. unfold u, g.
  set (e := exp (- decay r z)) in *. set (C := cosh _) in *. set (S := sinh _) in *. set (c := cos _) in *. set (s := sin _) in *.
  assert (C1 : C = (1 + e * e) / 2 / e) by (apply (Rmult_eq_reg_l e); [rewrite EC; field; lra | lra]).
  assert (S1 : S = (1 - e * e) / 2 / e) by (apply (Rmult_eq_reg_l e); [rewrite ES; field; lra | lra]).
  assert (D : 1 + e * e + 2 * e * c <> 0).
  { intro K. apply HD. rewrite C1. apply (Rmult_eq_reg_l (2 * e)); [|lra]. transitivity (1 + e * e + 2 * e * c); [field; lra |
    rewrite K; ring]. }
  rewrite C1, S1. assert (T' : s * s = 1 - c * c) by lra.
  split; apply Rminus_diag_uniq; (field_simplify; [|repeat split; try lra; intro K; apply D; lra]);
    match goal with |- ?n / ?m = 0 => replace n with 0 by ring [T' W] end; unfold Rdiv; ring.
Qed.

Lemma cos_shift_pi x : cos (PI + x) = - cos x.
Proof. rewrite Rplus_comm. apply neg_cos. Qed.
Lemma sin_shift_pi x : sin (PI + x) = - sin x.
Proof. rewrite Rplus_comm. apply neg_sin. Qed.

Lemma eta_mirrored r z pj pl b f : admissible r z -> mirrored (eta r z pj pl b f) (eta_prime r z pj pl b f).
Proof.
  intros [Hr [Hz [HD Hv]]]. destruct (braces_mirrored r z Hr Hz HD) as [B B'].
  unfold mirrored, eta, eta_prime. rewrite B, B'. unfold v_cos, v_sin. rewrite cos_shift_pi, sin_shift_pi, Rplus_0_l. split; ring.
Qed.

Theorem mode_has_a_steady_motion : Statements.mode_has_a_steady_motion.
Proof.
  intros r z pj pl b f A. pose proof A as [Hr [Hz _]]. exists (eta_second r z pj pl b f).
  split; [|split; [|apply eta_mirrored; exact A]].
  - intros t. split; [apply eta_rate | apply eta_prime_rate]; assumption.
  - intros t _. split; [apply eta_rate | split; [apply eta_prime_rate | apply eta_equation]]; assumption.
Qed.

(* Two solutions of (20) differ by a free motion. *)
Lemma difference r z pj pl b f y y1 y2 x x1 x2 T : 0 < r -> 0 <= z < 1 -> 0 < T ->
  (forall t, 0 <= t <= T -> continuous y t /\ continuous y1 t) -> (forall t, 0 <= t <= T -> continuous x t /\ continuous x1 t) ->
  (forall t, 0 < t < T -> is_derive y t (y1 t) /\ is_derive y1 t (y2 t) /\
    r ^ 2 * y2 t + 2 * z * r * y1 t + y t = r ^ 2 * (pj * b + pl * cos (t + f))) ->
  (forall t, 0 < t < T -> is_derive x t (x1 t) /\ is_derive x1 t (x2 t) /\
    r ^ 2 * x2 t + 2 * z * r * x1 t + x t = r ^ 2 * (pj * b + pl * cos (t + f))) ->
  forall t, 0 <= t <= T ->
  y t - x t = d r z t * (y 0 - x 0) + r * q r z t * (y1 0 - x1 0) /\
  y1 t - x1 t = - (q r z t / r) * (y 0 - x 0) + r * q_prime r z t * (y1 0 - x1 0).
Proof.
  intros Hr Hz HT Cy Cx Ey Ex t Ht.
  apply (free_motion r z T (fun t => y t - x t) (fun t => y1 t - x1 t) (fun t => y2 t - x2 t)); try assumption.
  - intros s Hs. destruct (Cy s Hs), (Cx s Hs). split; apply (continuous_minus (V := R_NormedModule)); assumption.
  - intros s Hs. destruct (Ey s Hs) as [A1 [A2 A3]], (Ex s Hs) as [B1 [B2 B3]].
    split; [|split]; [apply (is_derive_minus (V := R_NormedModule)); assumption ..|]. lra.
Qed.

(* A free motion that mirrors itself is at rest. *)
Lemma free_and_mirrored r z a b : 0 < r -> 0 <= z < 1 -> cosh (decay r z) + cos (theta r z) <> 0 ->
  d r z PI * a + r * q r z PI * b = - a -> - (q r z PI / r) * a + r * q_prime r z PI * b = - b -> a = 0 /\ b = 0.
Proof.
  intros Hr Hz HD E1 E2.
  assert (Det : (1 + d r z PI) * (1 + r * q_prime r z PI) + q r z PI * q r z PI <> 0).
  { pose proof (wronskian r z PI Hr Hz) as W. pose proof (d_by_q r z PI Hr Hz) as D.
    destruct (at_pi r z Hr Hz) as [D1 [Q1 P1]].
    replace (- (2 * z * PI / r)) with (- decay r z + - decay r z) in W by (unfold decay; field; lra). rewrite exp_plus in W.
    destruct (hyperbolic (decay r z)) as [EC [_ Ep]]. set (e := exp (- decay r z)) in *.
    assert (X : d r z PI + r * q_prime r z PI = 2 * e * cos (theta r z)) by (rewrite D1, P1; field; split; [pose proof (w_pos z
      Hz)|]; lra).
    intro K. apply HD. apply (Rmult_eq_reg_l (2 * e)); [|lra].
    replace (2 * e * (cosh (decay r z) + cos (theta r z))) with (2 * (e * cosh (decay r z)) + 2 * e * cos (theta r z)) by ring.
    rewrite EC, <- X. lra. }
  set (D := d r z PI) in *. set (Q := q r z PI) in *. set (P := q_prime r z PI) in *.
  assert (E2' : - Q * a + (1 + r * P) * r * b = 0).
  { transitivity (r * (- (Q / r) * a + r * P * b + b)); [field; lra | rewrite E2; ring]. }
  split.
  - apply (Rmult_eq_reg_l ((1 + D) * (1 + r * P) + Q * Q)); [|exact Det].
    transitivity ((1 + r * P) * (D * a + r * Q * b + a) - Q * (- Q * a + (1 + r * P) * r * b)); [ring | rewrite E1, E2'; ring].
  - apply (Rmult_eq_reg_l (((1 + D) * (1 + r * P) + Q * Q) * r)); [|apply Rmult_integral_contrapositive; split; [exact Det |
    lra]].
    transitivity ((1 + D) * (- Q * a + (1 + r * P) * r * b) + Q * (D * a + r * Q * b + a)); [ring | rewrite E1, E2'; ring].
Qed.

Theorem mode_has_no_other : Statements.mode_has_no_other.
Proof.
  intros r z pj pl b f A y y1 y2 Cy Ey [M1 M2] t Ht. pose proof A as [Hr [Hz [HD Hv]]].
  assert (PIp := PI_RGT_0). destruct (eta_mirrored r z pj pl b f A) as [N1 N2].
  assert (D := difference r z pj pl b f y y1 y2 (eta r z pj pl b f) (eta_prime r z pj pl b f) (eta_second r z pj pl b f) PI Hr
    Hz PIp Cy).
  assert (Z : y 0 - eta r z pj pl b f 0 = 0 /\ y1 0 - eta_prime r z pj pl b f 0 = 0).
  { apply (free_and_mirrored r z); try assumption; symmetry.
    - etransitivity; [|apply D; try lra; try assumption]. rewrite M1, N1. ring.
      + intros s _. split; eapply continuous_of_derive; [apply eta_rate | apply eta_prime_rate]; assumption.
      + intros s _. split; [apply eta_rate | split; [apply eta_prime_rate | apply eta_equation]]; assumption.
    - etransitivity; [|apply D; try lra; try assumption]. rewrite M2, N2. ring.
      + intros s _. split; eapply continuous_of_derive; [apply eta_rate | apply eta_prime_rate]; assumption.
      + intros s _. split; [apply eta_rate | split; [apply eta_prime_rate | apply eta_equation]]; assumption. }
  destruct D with (t := t) as [D1 D2]; try assumption.
  - intros s _. split; eapply continuous_of_derive; [apply eta_rate | apply eta_prime_rate]; assumption.
  - intros s _. split; [apply eta_rate | split; [apply eta_prime_rate | apply eta_equation]]; assumption.
  - destruct Z as [Z1 Z2]. rewrite Z1, Z2 in D1, D2. split; lra.
Qed.

Theorem eq_26_27 : Statements.eq_26_27.
Proof.
  intros r z pj pl b f y y1 y2 A Cy Ey M. pose proof A as [Hr [Hz _]]. pose proof PI_RGT_0.
  destruct (mode_has_no_other r z pj pl b f A y y1 y2 Cy Ey M 0) as [E1 E2]; [lra|]. rewrite E1, E2.
  unfold eta, eta_prime, braces, braces_prime. destruct (at_start r z Hr Hz) as [D0 [Q0 P0]]. rewrite D0, Q0, P0.
  split; field; lra.
Qed.

Theorem eq_40 : Statements.eq_40.
Proof.
  intros r z pj pl b f A y y1 y2 Cy Ey M t Ht.
  destruct (mode_has_no_other r z pj pl b f A y y1 y2 Cy Ey M t Ht) as [E _]. rewrite E.
  destruct (eq_26_27 r z pj pl b f y y1 y2 A Cy Ey M) as [C S].
  replace (y 0 + pj * r ^ 2 * g r z * b) with (pl * r ^ 2 * v_cos r z f 0) by exact C.
  replace (y1 0 + pj * r ^ 2 * u r z * b) with (- (pl * r ^ 2 * v_sin r z f 0)) by (rewrite S; ring).
  unfold eta, v_cos, v_sin. rewrite Rplus_0_l, cos_plus, sin_plus. ring.
Qed.

Theorem eq_62 : Statements.eq_62.
Proof.
  intros r z pj pl b f y y1 y2 A Hl Cy Ey M. pose proof A as [Hr [Hz [_ Hv]]].
  destruct (eq_26_27 r z pj pl b f y y1 y2 A Cy Ey M) as [C S].
  replace (y1 0 + pj * r ^ 2 * u r z * b) with (- (pl * r ^ 2 * v_sin r z f 0)) by (rewrite S; ring). rewrite <- C.
  rewrite <- (Rplus_0_l f) at 1. rewrite <- (load_equation r z f 0 Hv). field; split; lra.
Qed.

Lemma from_start_rate r z pj pl b f y0 y10 t : 0 < r -> 0 <= z < 1 ->
  is_derive (from_start r z pj pl b f y0 y10) t (from_start_prime r z pj pl b f y0 y10 t).
Proof. intros Hr Hz. unfold from_start, from_start_prime. rates r z t Hr Hz. field; lra. Qed.

Theorem eq_A_7 : Statements.eq_A_7.
Proof. intros r z pj pl b f y0 y10 t [Hr [Hz _]]. apply from_start_rate; assumption. Qed.

Definition from_start_second r z pj pl b f y0 y10 t :=
  - (q_prime r z t / r) * y0 + r * q_second r z t * y10 + pj * r ^ 2 * (q_prime r z t / r) * b -
  pl * r ^ 2 * ((v_re r z * cos f - v_im r z * sin f) * (cos t - q_prime r z t / r) +
                (v_re r z * sin f + v_im r z * cos f) * (- sin t - r * q_second r z t)).

Lemma from_start_prime_rate r z pj pl b f y0 y10 t : 0 < r -> 0 <= z < 1 ->
  is_derive (from_start_prime r z pj pl b f y0 y10) t (from_start_second r z pj pl b f y0 y10 t).
Proof. intros Hr Hz. unfold from_start_prime, from_start_second. rates r z t Hr Hz. field; lra. Qed.

Lemma from_start_equation r z pj pl b f y0 y10 t : admissible r z ->
  r ^ 2 * from_start_second r z pj pl b f y0 y10 t + 2 * z * r * from_start_prime r z pj pl b f y0 y10 t + from_start r z pj pl
    b f y0 y10 t
  = r ^ 2 * (pj * b + pl * cos (t + f)).
Proof.
  intros [Hr [Hz [_ Hv]]]. rewrite <- (load_equation r z f t Hv).
  unfold from_start, from_start_prime, from_start_second, q_second, v_cos, v_sin.
  rewrite (d_by_q r z t Hr Hz), cos_plus, sin_plus. field; lra.
Qed.

Lemma from_start_at_0 r z pj pl b f y0 y10 : 0 < r -> 0 <= z < 1 ->
  from_start r z pj pl b f y0 y10 0 = y0 /\ from_start_prime r z pj pl b f y0 y10 0 = y10.
Proof.
  intros Hr Hz. destruct (at_start r z Hr Hz) as [D0 [Q0 P0]]. unfold from_start, from_start_prime.
  rewrite D0, Q0, P0, cos_0, sin_0. split; field; lra.
Qed.

Theorem eq_A_6_is_every_solution : Statements.eq_A_6_is_every_solution.
Proof.
  intros r z pj pl b f y y1 y2 A Cy Ey t Ht. pose proof A as [Hr [Hz _]]. pose proof PI_RGT_0.
  destruct (difference r z pj pl b f y y1 y2 (from_start r z pj pl b f (y 0) (y1 0)) (from_start_prime r z pj pl b f (y 0) (y1 0))
    (from_start_second r z pj pl b f (y 0) (y1 0)) PI) with (t := t) as [D1 D2]; try assumption.
  - intros s _. split; eapply continuous_of_derive; [apply from_start_rate | apply from_start_prime_rate]; assumption.
  - intros s _. split; [apply from_start_rate | split; [apply from_start_prime_rate | apply from_start_equation]]; assumption.
  - destruct (from_start_at_0 r z pj pl b f (y 0) (y1 0) Hr Hz) as [E1 E2]. rewrite E1, E2 in D1, D2. split; lra.
Qed.

Lemma constants r z pj pl b f y0 y10 t : admissible r z ->
  general_solution r z pj pl b f (y0 - pj * r ^ 2 * b - pl * r ^ 2 * v_cos r z f 0)
    (r / w z * (y10 + pl * r ^ 2 * v_sin r z f 0) + z * (y0 - pj * r ^ 2 * b - pl * r ^ 2 * v_cos r z f 0) / w z) t
  = from_start r z pj pl b f y0 y10 t.
Proof.
  intros [Hr [Hz _]]. pose proof (w_pos z Hz). unfold general_solution, from_start, d, q, v_cos, v_sin.
  rewrite Rplus_0_l, cos_plus, sin_plus. field; lra.
Qed.

Theorem eq_A_5 : Statements.eq_A_5.
Proof.
  intros r z pj pl b f y0 y10 t A A1 B. pose proof A as [Hr [Hz _]]. split; [apply constants; exact A | apply from_start_at_0;
    assumption].
Qed.

Theorem eq_21_solves_eq_20 : Statements.eq_21_solves_eq_20.
Proof.
  intros r z pj pl b f A B H. pose proof H as [Hr [Hz _]]. pose proof (w_pos z Hz).
  set (y0 := A + pj * r ^ 2 * b + pl * r ^ 2 * v_cos r z f 0).
  set (y10 := w z / r * B - z / r * A - pl * r ^ 2 * v_sin r z f 0).
  exists (from_start_prime r z pj pl b f y0 y10), (from_start_second r z pj pl b f y0 y10). intros t. cbv zeta.
  split; [|split; [apply from_start_prime_rate; assumption|]].
  - apply (is_derive_ext (from_start r z pj pl b f y0 y10)); [|apply from_start_rate; assumption].
    intros s. rewrite <- constants by exact H. f_equal; unfold y0, y10; field; lra.
  - rewrite <- (from_start_equation r z pj pl b f y0 y10 t H). f_equal.
    rewrite <- constants by exact H. f_equal; unfold y0, y10; field; lra.
Qed.

Theorem eq_A_10 : Statements.eq_A_10.
Proof.
  intros r z pj pl b f y0 y10 [Hr [Hz _]]. unfold mirrored.
  destruct (from_start_at_0 r z pj pl b f y0 y10 Hr Hz) as [E1 E2]. rewrite E1, E2.
  unfold from_start, from_start_prime, coefficient_A, coefficient_B, coefficient_C, coefficient_P, coefficient_Q, coefficient_R,
    v_cos, v_sin.
  rewrite Rplus_0_l, cos_PI, sin_PI.
  split; intros [H1 H2]; split.
  - rewrite <- (Rminus_diag_eq _ _ H1). ring.
  - rewrite <- (Rminus_diag_eq _ _ H2). field; lra.
  - apply Rminus_diag_uniq. etransitivity; [|exact H1]. ring.
  - apply Rminus_diag_uniq. etransitivity; [|exact H2]. field; lra.
Qed.

Theorem eq_A_12 : Statements.eq_A_12.
Proof.
  intros r z pj pl b y0 y10 c s [Hr [Hz [HD _]]] Hl A B C P Q D.
  assert (Det : A * Q - B * P <> 0).
  { unfold A, B, P, Q, coefficient_A, coefficient_B, coefficient_P, coefficient_Q.
    replace (_ - _) with (- (pl * pl * r ^ 4) * ((1 + d r z PI) * (1 + r * q_prime r z PI) + q r z PI * q r z PI)) by ring.
    apply Rmult_integral_contrapositive. split.
    - apply Ropp_neq_0_compat. apply Rmult_integral_contrapositive. split; [nra | apply pow_nonzero; lra].
    - intro K.
      destruct (free_and_mirrored r z (r * (1 + r * q_prime r z PI)) (q r z PI) Hr Hz HD) as [X Y].
      + transitivity (r * ((1 + d r z PI) * (1 + r * q_prime r z PI) + q r z PI * q r z PI) - r * (1 + r * q_prime r z PI));
        [ring|].
        rewrite K. ring.
      + field; lra.
      + rewrite Y in *. assert (Z : 1 + r * q_prime r z PI = 0) by nra.
        destruct (free_and_mirrored r z 0 1 Hr Hz HD); [rewrite Y; ring | nra | lra]. }
  split; [exact Det|]. split.
  - intros [E1 E2]. split; apply (Rmult_eq_reg_r (A * Q - B * P)); try exact Det.
    + replace ((B * D - C * Q) / (A * Q - B * P) * (A * Q - B * P)) with (B * D - C * Q) by (field; exact Det).
      replace C with (- (A * c + B * s)) by lra. replace D with (- (P * c + Q * s)) by lra. ring.
    + replace ((C * P - A * D) / (A * Q - B * P) * (A * Q - B * P)) with (C * P - A * D) by (field; exact Det).
      replace C with (- (A * c + B * s)) by lra. replace D with (- (P * c + Q * s)) by lra. ring.
  - intros [E1 E2]. rewrite E1, E2. split; field; exact Det.
Qed.
