(* What is proved of the paper, in the paper's order and with its numbers.

   How to read this file without knowing Coq: a "Definition" names a quantity or a statement. "forall" is "for all", "exists" is "there is",
   "/\" is "and", "\/" is "or", "->" is "implies", "<->" is "if and only if", "~" is "not", "<>" is "differs from". "fun t => ..." is the
   function of t that follows the arrow. "is_derive f t a" says that the function f has the derivative a at t; "is_lim" and "filterlim" are
   limits. Each statement ends with a full stop; the proofs are in the other files, and the kernel of Coq checks that each of them proves
   the statement of the same name here. Masses are a, b, k, j, l and modes are i; both are counted from 0. *)
Require Import Reals List.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* f 0 + f 1 + ... + f (n - 1) *)
Fixpoint Sum (n : nat) (f : nat -> R) : R := match n with O => 0 | S m => Sum m f + f m end.

(* Kronecker's delta *)
Definition delta (a b : nat) : R := if Nat.eqb a b then 1 else 0.

(* ---- One mode: Sections 2.1, 2.2 and the Appendix --------------------------------------------------------------------------------- *)

Section One_mode.
Variables (R_i zeta : R).
Definition w := sqrt (1 - zeta * zeta).
Definition theta := PI * w / R_i.
Definition decay := PI * zeta / R_i.
(* (23): real and imaginary part of 1 / (1 - R_i^2 + i 2 zeta R_i) *)
Definition v_re := (1 - R_i * R_i) / ((1 - R_i * R_i) ^ 2 + (2 * zeta * R_i) ^ 2).
Definition v_im := - (2 * zeta * R_i) / ((1 - R_i * R_i) ^ 2 + (2 * zeta * R_i) ^ 2).
Definition v_abs := sqrt (v_re ^ 2 + v_im ^ 2).
(* (28), (29) *)
Definition u := sin theta / (R_i * w * (cosh decay + cos theta)).
Definition g := (sinh decay - zeta / w * sin theta) / (cosh decay + cos theta).
(* (A.8), and (A.9) for the derivative of q *)
Definition d (t : R) := exp (- zeta * t / R_i) * (cos (w * t / R_i) + zeta / w * sin (w * t / R_i)).
Definition q (t : R) := / w * exp (- zeta * t / R_i) * sin (w * t / R_i).
Definition q_prime (t : R) := / R_i * exp (- zeta * t / R_i) * (cos (w * t / R_i) - zeta / w * sin (w * t / R_i)).
(* the braces of (40) as corrected, and their rate *)
Definition braces (t : R) := 1 - (1 + g) * d t - u * R_i * q t.
Definition braces_prime (t : R) := (1 + g) * q t / R_i - u * R_i * q_prime t.
(* what (57) as corrected divides by sin tau *)
Definition demand_of_mode (t : R) := (1 + g) * R_i * q t - u * R_i ^ 2 * (R_i * q_prime t - cos t).

(* a mode that is underdamped, off the poles of (28), (29) and not undamped at resonance *)
Definition admissible :=
  0 < R_i /\ 0 <= zeta < 1 /\ cosh decay + cos theta <> 0 /\ (1 - R_i * R_i) ^ 2 + (2 * zeta * R_i) ^ 2 <> 0.

Variables (psi_j psi_l beta phi : R).
(* "v cos(t + phi)" and "v sin(t + phi)": real part of v exp(i (t + phi)), and of -i v exp(i (t + phi)) *)
Definition v_cos (t : R) := v_re * cos (t + phi) - v_im * sin (t + phi).
Definition v_sin (t : R) := v_re * sin (t + phi) + v_im * cos (t + phi).
(* (40), (A.15) as corrected, with (26), (27) for its first two terms *)
Definition eta (t : R) := psi_l * R_i ^ 2 * v_cos t + beta * psi_j * R_i ^ 2 * braces t.
Definition eta_prime (t : R) := - (psi_l * R_i ^ 2 * v_sin t) + beta * psi_j * R_i ^ 2 * braces_prime t.
(* (20) on the half-period in which the contact goes from its maximum to its minimum; Omega_i = 1 / R_i, (22), multiplied out.
   y1 and y2 are the velocity and the acceleration. *)
Definition modal_equation (y y1 y2 : R -> R) := forall t, 0 < t < PI ->
  is_derive y t (y1 t) /\ is_derive y1 t (y2 t) /\
  R_i ^ 2 * y2 t + 2 * zeta * R_i * y1 t + y t = R_i ^ 2 * (psi_j * beta + psi_l * cos (t + phi)).
(* (25), (A.4) *)
Definition mirrored (y y1 : R -> R) := y PI = - y 0 /\ y1 PI = - y1 0.
(* y and y1 reach their values at 0 and PI as limits *)
Definition continuous_on_half_period (y y1 : R -> R) := forall t, 0 <= t <= PI -> continuous y t /\ continuous y1 t.
(* (21), (A.2) *)
Definition general_solution (A B t : R) :=
  exp (- zeta * t / R_i) * (A * cos (w * t / R_i) + B * sin (w * t / R_i)) + psi_j * R_i ^ 2 * beta + psi_l * R_i ^ 2 * v_cos t.
(* (A.6) and (A.7); the sign of the first term of (A.7) is the corrected one *)
Definition from_start (y0 y10 t : R) :=
  d t * y0 + R_i * q t * y10 + psi_j * R_i ^ 2 * (1 - d t) * beta +
  psi_l * R_i ^ 2 * ((v_re * cos phi - v_im * sin phi) * (cos t - d t) + (v_re * sin phi + v_im * cos phi) * (R_i * q t - sin t)).
Definition from_start_prime (y0 y10 t : R) :=
  - (q t / R_i) * y0 + R_i * q_prime t * y10 + psi_j * R_i ^ 2 * (q t / R_i) * beta -
  psi_l * R_i ^ 2 * ((v_re * cos phi - v_im * sin phi) * (sin t - q t / R_i) +
                     (v_re * sin phi + v_im * cos phi) * (cos t - R_i * q_prime t)).
(* (A.11) without the factor v of (A, B, P, Q), which stands with the cosine and the sine *)
Definition coefficient_A := - psi_l * R_i ^ 2 * (1 + d PI).
Definition coefficient_B := psi_l * R_i ^ 3 * q PI.
Definition coefficient_C (y0 y10 : R) := (1 + d PI) * y0 + R_i * q PI * y10 + psi_j * R_i ^ 2 * (1 - d PI) * beta.
Definition coefficient_P := psi_l * R_i * q PI.
Definition coefficient_Q := psi_l * R_i ^ 2 * (1 + R_i * q_prime PI).
Definition coefficient_R (y0 y10 : R) := - (q PI / R_i) * y0 + (1 + R_i * q_prime PI) * y10 + psi_j * R_i * q PI * beta.
End One_mode.

(* (23) is the reciprocal of 1 - R_i^2 + i 2 zeta R_i: the product has real part 1 and imaginary part 0. *)
Definition eq_23 : Prop := forall R_i zeta, (1 - R_i * R_i) ^ 2 + (2 * zeta * R_i) ^ 2 <> 0 ->
  (1 - R_i * R_i) * v_re R_i zeta - 2 * zeta * R_i * v_im R_i zeta = 1 /\
  (1 - R_i * R_i) * v_im R_i zeta + 2 * zeta * R_i * v_re R_i zeta = 0.

(* (A.9): the derivatives of d and q. *)
Definition eq_A_9 : Prop := forall R_i zeta t, 0 < R_i -> 0 <= zeta < 1 ->
  is_derive (d R_i zeta) t (- (q R_i zeta t / R_i)) /\ is_derive (q R_i zeta) t (q_prime R_i zeta t).

(* (20), (21), (A.1), (A.2): whatever A and B are, (21) solves (20) at every time. *)
Definition eq_21_solves_eq_20 : Prop := forall R_i zeta psi_j psi_l beta phi A B, admissible R_i zeta ->
  exists y1 y2, modal_equation R_i zeta psi_j psi_l beta phi (general_solution R_i zeta psi_j psi_l beta phi A B) y1 y2.

(* (A.5), (A.6): (21) with the constants (A.5) is (A.6), and it starts with the displacement y0 and the velocity y10. *)
Definition eq_A_5 : Prop := forall R_i zeta psi_j psi_l beta phi y0 y10 t, admissible R_i zeta ->
  let A := y0 - psi_j * R_i ^ 2 * beta - psi_l * R_i ^ 2 * v_cos R_i zeta phi 0 in
  let B := R_i / w zeta * (y10 + psi_l * R_i ^ 2 * v_sin R_i zeta phi 0) + zeta * A / w zeta in
  general_solution R_i zeta psi_j psi_l beta phi A B t = from_start R_i zeta psi_j psi_l beta phi y0 y10 t /\
  from_start R_i zeta psi_j psi_l beta phi y0 y10 0 = y0 /\ from_start_prime R_i zeta psi_j psi_l beta phi y0 y10 0 = y10.

(* (A.7): the rate of (A.6), with the first sign corrected. *)
Definition eq_A_7 : Prop := forall R_i zeta psi_j psi_l beta phi y0 y10 t, admissible R_i zeta ->
  is_derive (from_start R_i zeta psi_j psi_l beta phi y0 y10) t (from_start_prime R_i zeta psi_j psi_l beta phi y0 y10 t).

(* (21), (A.6) are complete: every solution of (20) that starts with y 0 and y1 0 is (A.6), and its velocity is (A.7). *)
Definition eq_A_6_is_every_solution : Prop := forall R_i zeta psi_j psi_l beta phi y y1 y2, admissible R_i zeta ->
  continuous_on_half_period y y1 -> modal_equation R_i zeta psi_j psi_l beta phi y y1 y2 -> forall t, 0 <= t <= PI ->
  y t = from_start R_i zeta psi_j psi_l beta phi (y 0) (y1 0) t /\
  y1 t = from_start_prime R_i zeta psi_j psi_l beta phi (y 0) (y1 0) t.

(* (A.10), (A.11): that (A.6) mirrors itself after half a period is the linear system (A.10) with the coefficients (A.11). *)
Definition eq_A_10 : Prop := forall R_i zeta psi_j psi_l beta phi y0 y10, admissible R_i zeta ->
  (mirrored (from_start R_i zeta psi_j psi_l beta phi y0 y10) (from_start_prime R_i zeta psi_j psi_l beta phi y0 y10) <->
   coefficient_A R_i zeta psi_l * v_cos R_i zeta phi 0 + coefficient_B R_i zeta psi_l * v_sin R_i zeta phi 0
     + coefficient_C R_i zeta psi_j beta y0 y10 = 0 /\
   coefficient_P R_i zeta psi_l * v_cos R_i zeta phi 0 + coefficient_Q R_i zeta psi_l * v_sin R_i zeta phi 0
     + coefficient_R R_i zeta psi_j beta y0 y10 = 0).

(* (A.12): where the load acts on the mode, the system has the solution (A.12); its determinant is not zero. *)
Definition eq_A_12 : Prop := forall R_i zeta psi_j psi_l beta y0 y10 c s, admissible R_i zeta -> psi_l <> 0 ->
  let A := coefficient_A R_i zeta psi_l in let B := coefficient_B R_i zeta psi_l in
  let C := coefficient_C R_i zeta psi_j beta y0 y10 in let P := coefficient_P R_i zeta psi_l in
  let Q := coefficient_Q R_i zeta psi_l in let D := coefficient_R R_i zeta psi_j beta y0 y10 in
  A * Q - B * P <> 0 /\
  (A * c + B * s + C = 0 /\ P * c + Q * s + D = 0 <->
   c = (B * D - C * Q) / (A * Q - B * P) /\ s = (C * P - A * D) / (A * Q - B * P)).

(* (26), (27), (A.13), (A.14): a motion that solves (20) and mirrors itself starts with these values. The load term is v cos(phi). *)
Definition eq_26_27 : Prop := forall R_i zeta psi_j psi_l beta phi y y1 y2, admissible R_i zeta ->
  continuous_on_half_period y y1 -> modal_equation R_i zeta psi_j psi_l beta phi y y1 y2 -> mirrored y y1 ->
  psi_l * R_i ^ 2 * v_cos R_i zeta phi 0 = y 0 + psi_j * R_i ^ 2 * g R_i zeta * beta /\
  psi_l * R_i ^ 2 * v_sin R_i zeta phi 0 = - (y1 0 + psi_j * R_i ^ 2 * u R_i zeta * beta).

(* (40), (A.15): a mode has a steady motion, *)
Definition mode_has_a_steady_motion : Prop := forall R_i zeta psi_j psi_l beta phi, admissible R_i zeta -> exists y2,
  (forall t, is_derive (eta R_i zeta psi_j psi_l beta phi) t (eta_prime R_i zeta psi_j psi_l beta phi t) /\
             is_derive (eta_prime R_i zeta psi_j psi_l beta phi) t (y2 t)) /\
  modal_equation R_i zeta psi_j psi_l beta phi (eta R_i zeta psi_j psi_l beta phi) (eta_prime R_i zeta psi_j psi_l beta phi) y2 /\
  mirrored (eta R_i zeta psi_j psi_l beta phi) (eta_prime R_i zeta psi_j psi_l beta phi).

(* and there is no other: whatever solves (20) and mirrors itself is (40) as corrected. *)
Definition mode_has_no_other : Prop := forall R_i zeta psi_j psi_l beta phi, admissible R_i zeta -> forall y y1 y2,
  continuous_on_half_period y y1 -> modal_equation R_i zeta psi_j psi_l beta phi y y1 y2 -> mirrored y y1 ->
  forall t, 0 <= t <= PI -> y t = eta R_i zeta psi_j psi_l beta phi t /\ y1 t = eta_prime R_i zeta psi_j psi_l beta phi t.

(* (40), (A.15) in the paper's own form, by the initial values of the motion. *)
Definition eq_40 : Prop := forall R_i zeta psi_j psi_l beta phi, admissible R_i zeta -> forall y y1 y2,
  continuous_on_half_period y y1 -> modal_equation R_i zeta psi_j psi_l beta phi y y1 y2 -> mirrored y y1 ->
  forall t, 0 <= t <= PI ->
  y t = (y 0 + psi_j * R_i ^ 2 * g R_i zeta * beta) * cos t + (y1 0 + psi_j * R_i ^ 2 * u R_i zeta * beta) * sin t
        + beta * psi_j * R_i ^ 2 * braces R_i zeta t.

(* (62), from (60) and (61): the cosine of the phase by the initial values. *)
Definition eq_62 : Prop := forall R_i zeta psi_j psi_l beta phi y y1 y2, admissible R_i zeta -> psi_l <> 0 ->
  continuous_on_half_period y y1 -> modal_equation R_i zeta psi_j psi_l beta phi y y1 y2 -> mirrored y y1 ->
  cos phi = (y 0 + psi_j * R_i ^ 2 * g R_i zeta * beta) / (psi_l * R_i ^ 2) * (1 - R_i ^ 2)
            + (y1 0 + psi_j * R_i ^ 2 * u R_i zeta * beta) / (psi_l * R_i ^ 2) * (2 * zeta * R_i).
