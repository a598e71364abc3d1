(* What is proved of the paper, in the paper's order and with its numbers.

   How to read this file without knowing Coq: a "Definition" names a quantity or a statement. "forall" is "for all",
   "exists" is "there is", "/\" is "and", "\/" is "or", "->" is "implies", "<->" is "if and only if", "~" is "not", "<>" is
   "differs from". "fun t => ..." is the function of t that follows the arrow. "is_derive f t a" says that the function f
   has the derivative a at t; "is_lim" and "filterlim" are limits. Each statement ends with a full stop; the proofs are in
   the other files, and the kernel of Coq checks that each of them proves the statement of the same name here. Masses are a,
   b, k, j, l and modes are i; both are counted from 0. *)
Require Import Reals List.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* f 0 + f 1 + ... + f (n - 1) *)
Fixpoint Sum (n : nat) (f : nat -> R) : R := match n with O => 0 | S m => Sum m f + f m end.

(* Kronecker's delta *)
Definition delta (a b : nat) : R := if Nat.eqb a b then 1 else 0.

(* ---- One mode: Sections 2.1, 2.2 and the Appendix ----------------------------------------------------------------- *)

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
  exists y1 y2, forall t, let y := general_solution R_i zeta psi_j psi_l beta phi A B in
    is_derive y t (y1 t) /\ is_derive y1 t (y2 t) /\
    R_i ^ 2 * y2 t + 2 * zeta * R_i * y1 t + y t = R_i ^ 2 * (psi_j * beta + psi_l * cos (t + phi)).

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

(* (26), (27), (A.13), (A.14): a motion that solves (20) and mirrors itself starts with these values. The load term is v
   cos(phi). *)
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

(* ---- A scene: any number of masses and modes ---------------------------------------------------------------------- *)

Record scene := Scene {
  masses : nat;                      (* N *)
  mass : nat -> nat -> R;            (* entries of M, C, K of (7): mass a b is M_ab *)
  damping : nat -> nat -> R;
  stiffness : nat -> nat -> R;
  shape : nat -> nat -> R;           (* (14): shape k i is psi_ki, mass k in mode i *)
  ratio : nat -> R;                  (* R_i of (22) *)
  damping_ratio : nat -> R;          (* zeta_i of (18) *)
  contact : nat;                     (* j: the mass with the contact *)
  loaded : nat;                      (* l: the mass that the load acts on *)
  friction : R                       (* beta of (11) *)
}.

(* (4)-(7), (11): a motion X of the masses m, c, k with the friction force F and the load P cos(omega t) solves (6) after
   the scaling (5). sgn is the sign of the contact's velocity, or a value of its set where that is zero; the scaled velocity
   has the same sign. *)
Definition eq_6 : Prop := forall n (m c k : nat -> nat -> R) (X X1 X2 : nat -> R -> R) (sgn : R -> R) F P k_1 omega j l tau,
  0 < omega -> 0 < k_1 -> 0 < P ->
  (forall a, is_derive (X a) (tau / omega) (X1 a (tau / omega)) /\ is_derive (X1 a) (tau / omega) (X2 a (tau / omega))) ->
  (forall a, (a < n)%nat -> Sum n (fun b => m a b * X2 b (tau / omega) + c a b * X1 b (tau / omega) + k a b * X b (tau / omega))
    + F * delta a j * sgn (tau / omega) = P * delta a l * cos (omega * (tau / omega))) ->
  let x := fun a t => k_1 / P * X a (t / omega) in
  let x1 := fun a t => k_1 / (P * omega) * X1 a (t / omega) in
  let x2 := fun a t => k_1 / (P * omega ^ 2) * X2 a (t / omega) in
  (forall a, is_derive (x a) tau (x1 a tau) /\ is_derive (x1 a) tau (x2 a tau)) /\
  (forall a, (a < n)%nat ->
    Sum n (fun b => omega ^ 2 / k_1 * m a b * x2 b tau + omega / k_1 * c a b * x1 b tau + / k_1 * k a b * x b tau)
    + F / P * delta a j * sgn (tau / omega) = delta a l * cos tau).

(* (8)-(10): the scaled masses are gamma_i r^2. *)
Definition eq_8 : Prop := forall omega k_1 m_1 m_i, 0 < omega -> 0 < k_1 -> 0 < m_1 ->
  omega ^ 2 / k_1 * m_i = m_i / m_1 * (omega * sqrt (m_1 / k_1)) ^ 2.

(* The angle of the point (x, y), as the program's atan2 gives it. *)
Definition atan2 (y x : R) : R :=
  if Rlt_dec 0 x then atan (y / x)
  else if Rlt_dec x 0 then (if Rle_dec 0 y then atan (y / x) + PI else atan (y / x) - PI)
  else if Rlt_dec 0 y then PI / 2 else if Rlt_dec y 0 then - (PI / 2) else 0.

Definition atan2_is_the_angle : Prop := forall x y, x <> 0 \/ y <> 0 ->
  sqrt (x ^ 2 + y ^ 2) * cos (atan2 y x) = x /\ sqrt (x ^ 2 + y ^ 2) * sin (atan2 y x) = y.

(* (60): cosine and sine of the phase and the argument of v, by the initial values of a mode. *)
Definition eq_60 : Prop := forall R_i zeta psi_j psi_l beta phi y y1 y2, admissible R_i zeta -> psi_l <> 0 ->
  continuous_on_half_period y y1 -> modal_equation R_i zeta psi_j psi_l beta phi y y1 y2 -> mirrored y y1 ->
  let angle := atan2 (v_im R_i zeta) (v_re R_i zeta) in
  cos (phi + angle) = (y 0 + psi_j * R_i ^ 2 * g R_i zeta * beta) / (psi_l * R_i ^ 2 * v_abs R_i zeta) /\
  sin (phi + angle) = - ((y1 0 + psi_j * R_i ^ 2 * u R_i zeta * beta) / (psi_l * R_i ^ 2 * v_abs R_i zeta)).
(* (61): the argument of v. *)
Definition eq_61 : Prop := forall R_i zeta, (1 - R_i * R_i) ^ 2 + (2 * zeta * R_i) ^ 2 <> 0 ->
  cos (atan2 (v_im R_i zeta) (v_re R_i zeta)) = v_abs R_i zeta * (1 - R_i ^ 2) /\
  sin (atan2 (v_im R_i zeta) (v_re R_i zeta)) = - (v_abs R_i zeta * (2 * zeta * R_i)).

(* (47) for X cos(tau - f), with tau the time at which it is largest in modulus: the angle is phi_j + f. *)
Definition eq_47 : Prop := forall X f phi_j tau, 0 < X -> 0 <= tau <= PI ->
  (forall t, 0 <= t <= PI -> Rabs (X * cos (t - f)) <= Rabs (X * cos (tau - f))) ->
  let phi_k := if Rle_dec 0 (X * cos (tau - f)) then phi_j + tau else phi_j + tau + PI in
  cos phi_k = cos (phi_j + f) /\ sin phi_k = sin (phi_j + f).

(* (1): the matrices of a chain of n masses, whose spring a stands before mass a *)
Definition chain_mass (m : nat -> R) (a b : nat) := m a * delta a b.
Definition spring_after (n : nat) (k : nat -> R) (a : nat) := if Nat.ltb (S a) n then k (S a) else 0.
Definition chain_stiffness (n : nat) (k : nat -> R) (a b : nat) :=
  (k a + spring_after n k a) * delta a b - spring_after n k a * delta b (S a) - k a * delta a (S b).
(* Row a of K x is the force of its two springs: the first one ends at the wall, and after the last mass there is none. *)
Definition eq_1 : Prop := forall n k x a, (a < n)%nat ->
  Sum n (fun b => chain_stiffness n k a b * x b) =
  k a * (x a - match a with O => 0 | S p => x p end) + spring_after n k a * (x a - x (S a)).
(* (73): the scaled stiffness of the chain has the ratios of the springs for its springs. *)
Definition eq_73 : Prop := forall n k k_1 a b, 0 < k_1 ->
  / k_1 * chain_stiffness n k a b = chain_stiffness n (fun i => k i / k_1) a b.

Section All_masses.
Variable s : scene.
Local Notation N := (masses s).
Local Notation M := (mass s).
Local Notation C := (damping s).
Local Notation K := (stiffness s).
Local Notation psi := (shape s).
Local Notation R_ := (ratio s).
Local Notation zeta := (damping_ratio s).
Local Notation j := (contact s).
Local Notation l := (loaded s).
Local Notation beta := (friction s).

(* What the paper asks of a scene: (15), (17) and (18), with Omega_i = 1 / R_i, and modes that are admissible. *)
Definition is_scene :=
  (j < N)%nat /\ (l < N)%nat /\
  (forall i, (i < N)%nat -> admissible (R_ i) (zeta i)) /\
  (forall i a, (i < N)%nat -> (a < N)%nat -> Sum N (fun b => K a b * psi b i) = / (R_ i ^ 2) * Sum N (fun b => M a b
    * psi b i)) /\
  (forall i k, (i < N)%nat -> (k < N)%nat -> Sum N (fun a => psi a i * Sum N (fun b => M a b * psi b k)) = delta i k) /\
  (forall i k, (i < N)%nat -> (k < N)%nat ->
    Sum N (fun a => psi a i * Sum N (fun b => C a b * psi b k)) = delta i k * (2 * zeta i / R_ i)).

(* The mode shapes are complete: M Psi Psi^T = I and Psi Psi^T M = I follow from (17). *)
Definition modes_are_complete : Prop := is_scene -> forall a b, (a < N)%nat -> (b < N)%nat ->
  Sum N (fun i => Sum N (fun c => M a c * psi c i) * psi b i) = delta a b /\
  Sum N (fun c => Sum N (fun i => psi a i * psi c i) * M c b) = delta a b.

(* (19): the damping matrix by its modes. *)
Definition eq_19 : Prop := is_scene -> forall a b, (a < N)%nat -> (b < N)%nat ->
  C a b = Sum N (fun i => 2 * zeta i / R_ i * Sum N (fun c => M a c * psi c i) * Sum N (fun c => M b c * psi c i)).

Definition V_re k := Sum N (fun i => psi k i * psi l i * R_ i ^ 2 * v_re (R_ i) (zeta i)).      (* (33) *)
Definition V_im k := Sum N (fun i => psi k i * psi l i * R_ i ^ 2 * v_im (R_ i) (zeta i)).
Definition V_abs k := sqrt (V_re k ^ 2 + V_im k ^ 2).
Definition V_arg k := atan2 (V_im k) (V_re k).
Definition U k := Sum N (fun i => psi k i * psi j i * R_ i ^ 2 * u (R_ i) (zeta i)).             (* (34) *)
Definition G k := Sum N (fun i => psi k i * psi j i * R_ i ^ 2 * g (R_ i) (zeta i)).             (* (35) *)
Definition root := sqrt (V_abs j ^ 2 - (beta * U j) ^ 2).
Definition X_j := - beta * G j + root.                                                           (* (38) *)
(* the response reaches the contact, and the root of (38) is real *)
Definition responds := 0 < V_abs j /\ Rabs (beta * U j) <= V_abs j.
(* (31), (32) with x_j'(0) = 0: V_j cos(phi) and V_j sin(phi) *)
Definition is_phase (phi : R) := V_re j * cos phi - V_im j * sin phi = root /\
  V_re j * sin phi + V_im j * cos phi = - (beta * U j).
(* (13), (30), (41) as corrected *)
Definition x (phi : R) k t := Sum N (fun i => psi k i * eta (R_ i) (zeta i) (psi j i) (psi l i) beta phi t).
Definition x_prime (phi : R) k t := Sum N (fun i => psi k i * eta_prime (R_ i) (zeta i) (psi j i) (psi l i) beta phi t).
(* the sum in (41), (46) *)
Definition friction_motion k t := Sum N (fun i => psi k i * psi j i * R_ i ^ 2 * braces (R_ i) (zeta i) t).

(* (12): the equation of motion while the contact moves to smaller x, so that Sgn(x_j') = -1 *)
Definition half_period_motion (phi : R) (y y1 y2 : nat -> R -> R) := forall t, 0 < t < PI -> forall a, (a < N)%nat ->
  is_derive (y a) t (y1 a t) /\ is_derive (y1 a) t (y2 a t) /\
  Sum N (fun b => M a b * y2 b t + C a b * y1 b t + K a b * y b t) = delta a j * beta + delta a l * cos (t + phi).
(* a motion of (12) that mirrors itself, (25), and starts with the contact at rest, (30) *)
Definition steady_half_period (phi : R) (y y1 y2 : nat -> R -> R) :=
  (forall a, (a < N)%nat -> continuous_on_half_period (y a) (y1 a)) /\ half_period_motion phi y y1 y2 /\
  (forall k, (k < N)%nat -> mirrored (y k) (y1 k)) /\ y1 j 0 = 0.

(* (16), (20): the modal coordinates of a motion of (12) solve (20), each by itself, and the motion is their sum (13). *)
Definition eq_16_20 : Prop := is_scene -> forall phi y y1 y2, half_period_motion phi y y1 y2 ->
  let modal := fun (f : nat -> R -> R) i t => Sum N (fun a => Sum N (fun c => psi c i * M c a) * f a t) in
  (forall i, (i < N)%nat -> modal_equation (R_ i) (zeta i) (psi j i) (psi l i) beta phi (modal y i) (modal y1 i) (modal y2 i)) /\
  (forall k t, (k < N)%nat -> y k t = Sum N (fun i => psi k i * modal y i t) /\ y1 k t = Sum N (fun i => psi k i * modal y1 i t)).

(* (31), (32), (42), (43): the initial values of every mass of a motion that mirrors itself *)
Definition eq_31_32_42_43 : Prop := is_scene -> forall phi y y1 y2,
  (forall a, (a < N)%nat -> continuous_on_half_period (y a) (y1 a)) -> half_period_motion phi y y1 y2 ->
  (forall k, (k < N)%nat -> mirrored (y k) (y1 k)) -> forall k, (k < N)%nat ->
  V_re k * cos phi - V_im k * sin phi = y k 0 + beta * G k /\
  V_re k * sin phi + V_im k * cos phi = - (y1 k 0 + beta * U k).

(* (36), (37): the same with the modulus and the argument of V_j *)
Definition eq_36_37 : Prop := is_scene -> responds -> forall phi, is_phase phi ->
  cos (phi + V_arg j) = (X_j + beta * G j) / V_abs j /\ sin (phi + V_arg j) = - (beta * U j / V_abs j).

(* (39): there is a phase, and (39) is it; any other differs by full turns. *)
Definition eq_39 : Prop := responds ->
  is_phase (atan2 (- (beta * U j / V_abs j)) (sqrt (1 - (beta * U j / V_abs j) ^ 2)) - V_arg j) /\
  (forall phi phi', is_phase phi -> is_phase phi' -> exists turns : Z, phi' = phi + 2 * PI * IZR turns).

(* (38), (41): x solves (12), mirrors itself, and its contact starts from rest at X_j. *)
Definition steady_motion : Prop := is_scene -> responds -> forall phi, is_phase phi -> exists x2,
  steady_half_period phi (x phi) (x_prime phi) x2 /\ x phi j 0 = X_j.

(* There is no other: the half-period problem determines the motion, (38) and the phase. *)
Definition no_other_motion : Prop := is_scene -> responds -> forall phi y y1 y2,
  steady_half_period phi y y1 y2 -> 0 <= y j 0 + beta * G j ->
  is_phase phi /\ y j 0 = X_j /\
  forall k t, (k < N)%nat -> 0 <= t <= PI -> y k t = x phi k t /\ y1 k t = x_prime phi k t.

(* Without the response condition: where |beta U_j| > |V_j|, no motion of this kind exists, as the root of (38) is not real. *)
Definition no_motion_without_root : Prop := is_scene -> V_abs j < Rabs (beta * U j) ->
  forall phi y y1 y2, ~ steady_half_period phi y y1 y2.

(* The sign of the root in (38): with the other sign the contact would start in the wrong direction. *)
Definition sign_of_the_root : Prop := is_scene -> 0 < beta -> forall phi y y1 y2,
  steady_half_period phi y y1 y2 -> (forall t, 0 < t < PI -> y1 j t < 0) -> 0 < y j 0 + beta * G j.

(* (41) in the paper's form, *)
Definition eq_41 : Prop := is_scene -> responds -> forall phi, is_phase phi -> forall k t, (k < N)%nat ->
  x phi k t = (x phi k 0 + beta * G k) * cos t + (x_prime phi k 0 + beta * U k) * sin t + beta * friction_motion k t.
(* and (44), (45), (46) with the modulus and the argument of V_k, in real numbers *)
Definition eq_44_45 : Prop := is_scene -> responds -> forall phi, is_phase phi -> forall k, (k < N)%nat ->
  let D := V_arg k - V_arg j in
  x phi k 0 = - beta * G k + V_abs k / V_abs j * (root * cos D + beta * U j * sin D) /\
  x_prime phi k 0 = - beta * U k + V_abs k / V_abs j * (beta * U j * cos D - root * sin D).
Definition eq_46 : Prop := is_scene -> responds -> forall phi, is_phase phi -> forall k t, (k < N)%nat ->
  let D := V_arg k - V_arg j in
  x phi k t = V_abs k / V_abs j * (root * cos (t + D) + beta * U j * sin (t + D)) + beta * friction_motion k t.

(* (49)-(53): the one-harmonic approximation of (48), exact as an identity: cosine part, sine part, amplitude, and phase.
   (50) and (52) as corrected. *)
Definition X_kC k := V_abs k / V_abs j * (root * cos (V_arg k - V_arg j) + beta * U j * sin (V_arg k - V_arg j)) - beta * G k.
Definition X_kS k := V_abs k / V_abs j * (beta * U j * cos (V_arg k - V_arg j) - root * sin (V_arg k - V_arg j)) - beta * U k.
Definition X_k k := sqrt (V_abs k ^ 2 + beta ^ 2 * (G k ^ 2 + U k ^ 2)
  - 2 * beta * (V_abs k / V_abs j) *
    (root * (G k * cos (V_arg k - V_arg j) - U k * sin (V_arg k - V_arg j))
     + beta * U j * (G k * sin (V_arg k - V_arg j) + U k * cos (V_arg k - V_arg j)))).
Definition eq_49_50_51 : Prop := is_scene -> responds -> forall phi, is_phase phi -> forall k, (k < N)%nat ->
  X_kC k = x phi k 0 /\ X_kS k = x_prime phi k 0.
Definition eq_52_53 : Prop := responds -> forall k,
  X_k k = sqrt (X_kC k ^ 2 + X_kS k ^ 2) /\
  (X_k k <> 0 -> forall phi_kj, cos phi_kj = X_kC k / X_k k -> sin phi_kj = X_kS k / X_k k ->
    forall t, X_kC k * cos t + X_kS k * sin t = X_k k * cos (t - phi_kj)).
(* What (48) leaves out at a given damping. Its one harmonic has the initial values of the motion. What the motion has besides is
   beta R_i^2 times a function of each mode. It starts from rest, and vibrates under a force that is nowhere above force_left_out. *)
Definition force_left_out R_i zeta := 1 + (Rabs (1 - R_i ^ 2) + 2 * zeta * R_i) * (Rabs (g R_i zeta) + Rabs (u R_i zeta)).
Definition mode_left_out R_i zeta := force_left_out R_i zeta * Rmin (PI / R_i) (PI ^ 2 / (2 * R_i ^ 2)).
Definition left_out k := beta * Sum N (fun i => Rabs (psi k i * psi j i) * R_ i ^ 2 * mode_left_out (R_ i) (zeta i)).
Definition eq_48_error : Prop := is_scene -> responds -> 0 <= beta -> forall phi, is_phase phi ->
  forall k t, (k < N)%nat -> 0 <= t <= PI ->
  Rabs (x phi k t - (x phi k 0 * cos t + x_prime phi k 0 * sin t)) <= left_out k.
(* (52): the largest |x_k| of the half-period is X_k but for that, from above and from below. *)
Definition eq_52_error : Prop := is_scene -> responds -> 0 <= beta -> forall phi, is_phase phi -> forall k, (k < N)%nat ->
  (forall t, 0 <= t <= PI -> Rabs (x phi k t) <= X_k k + left_out k) /\
  (exists t, 0 <= t <= PI /\ X_k k - left_out k <= Rabs (x phi k t)).
(* (81)-(83) leave out what U_j does in the root of (38): at any frequency that lowers the amplitude of the contact, by at most
   this. *)
Definition eq_38_without_U : Prop := responds ->
  0 <= V_abs j - beta * G j - X_j <= (beta * U j) ^ 2 / V_abs j.
(* (52) reduces to (38) for k = j *)
Definition eq_52_is_38_at_the_contact : Prop := responds -> X_k j = Rabs X_j.

(* ---- Where it is a motion of Coulomb's contact: Section 2.6 ------------------------------------------------------- *)

(* (54a) *)
Definition slides (phi : R) := forall t, 0 < t < PI -> x_prime phi j t < 0.
(* (57) as corrected, summed over the modes before the maximum is taken *)
Definition demand t := Sum N (fun i => psi j i ^ 2 * demand_of_mode (R_ i) (zeta i) t) / sin t.
(* (54b): the load on the contact at the turning point *)
Definition contact_load (phi : R) :=
  Sum N (fun k => C j k * x_prime phi k 0 + K j k * x phi k 0) - delta l j * cos phi.
(* (64), and the sum of (65), which is the entry jj of the inverse of M *)
Definition H_j := Sum N (fun i => psi j i ^ 2 * (g (R_ i) (zeta i) + 2 * zeta i * R_ i * u (R_ i) (zeta i))).
Definition mobility := Sum N (fun i => psi j i ^ 2).
(* no inertia couples the contact to another mass; so it is for the chain (1) *)
Definition contact_inertia_alone := forall a, (a < N)%nat -> a <> j -> M j a = 0.
(* (75) for any M: the load that friction has to balance if the contact is not to be accelerated, where the masses have the
   displacements y and the velocities y1, and the load is c. The first sum is the entry ja of the inverse of M. *)
Definition holding_load (c : R) (y y1 : nat -> R) :=
  Sum N (fun a => Sum N (fun i => psi j i * psi a i) * (Sum N (fun b => C a b * y1 b + K a b * y b) - delta a l * c)) / mobility.
(* the same at the turning point of the closed form *)
Definition holding_friction (phi : R) := holding_load (cos phi) (fun k => x phi k 0) (fun k => x_prime phi k 0).

(* (65): where the contact's inertia is alone, M_jj = gamma_j r^2, *)
Definition eq_65 : Prop := is_scene -> contact_inertia_alone -> mobility = / M j j.
(* and then the friction that would hold it balances the load of (54b), (75). *)
Definition holding_friction_is_the_load : Prop := is_scene -> contact_inertia_alone ->
  (forall c y y1, holding_load c y y1 = Sum N (fun k => C j k * y1 k + K j k * y k) - delta l j * c) /\
  (forall phi, holding_friction phi = contact_load phi).
(* For any M: the contact is not accelerated if and only if the friction force F is opposite to this load. *)
Definition holding_load_holds : Prop := is_scene -> forall c F (y y1 y2 : nat -> R),
  (forall a, (a < N)%nat -> Sum N (fun b => M a b * y2 b + C a b * y1 b + K a b * y b) + F * delta a j = delta a l * c) ->
  (y2 j = 0 <-> F = - holding_load c y y1).

(* (55) with the sum under one maximum: the contact slides throughout if and only if beta times the demand stays below the
   root. *)
Definition slides_iff : Prop := is_scene -> responds -> forall phi, is_phase phi ->
  (slides phi <-> forall t, 0 < t < PI -> beta * demand t < X_j + beta * G j).
(* (66) *)
Definition eq_66 : Prop := is_scene -> responds -> forall phi, is_phase phi ->
  holding_friction phi = (X_j + beta * G j - beta * H_j) / mobility.
(* the demand at the start: (71), summed; it is positive in each mode *)
Definition demand_at_start : Prop := is_scene -> filterlim demand (at_right 0) (locally (H_j + mobility)) /\ 0 < mobility /\
  0 < H_j + mobility.

(* A phase exists if and only if the root of (38) is real. *)
Definition phase_exists_iff : Prop := 0 < V_abs j -> ((exists phi, is_phase phi) <-> responds).

(* (58), (67): a condition "beta D below the root" as a limit of beta *)
Definition as_a_limit_of_beta : Prop := forall D, 0 < D -> 0 < beta ->
  (responds /\ beta * D < root <-> 0 < V_abs j /\ beta < sqrt (V_abs j ^ 2 / (U j ^ 2 + D ^ 2))).

(* (67): there is a closed form that static friction does not hold at its turning point. *)
Definition eq_67 : Prop := forall mu, is_scene -> 1 <= mu -> 0 < beta -> 0 < V_abs j ->
  ((exists phi, is_phase phi /\ mu * beta < holding_friction phi) <->
   beta < sqrt (V_abs j ^ 2 / (U j ^ 2 + (H_j + mu * mobility) ^ 2))).
(* (68) as corrected: only where H_j exceeds mu times the mobility can the load overcome friction in the other direction, *)
Definition eq_68 : Prop := forall mu, is_scene -> 1 <= mu -> 0 < beta -> responds -> forall phi, is_phase phi ->
  (holding_friction phi < - (mu * beta) <->
   0 < H_j - mu * mobility /\ sqrt (V_abs j ^ 2 / (U j ^ 2 + (H_j - mu * mobility) ^ 2)) < beta).
(* and then the contact does not slide: (58) and (68) exclude each other. *)
Definition eq_68_excludes_58 : Prop := forall mu, is_scene -> 1 <= mu -> 0 < beta -> responds -> forall phi, is_phase phi ->
  holding_friction phi < - (mu * beta) -> ~ slides phi.

(* (69) has the supremum of the summed demand over the half-period. There is one. *)
Definition supremum_of_demand (S : R) := is_lub (fun y => exists t, 0 < t < PI /\ y = demand t) S.
Definition demand_has_a_supremum : Prop := is_scene -> exists S, supremum_of_demand S.
Definition limit_69 (mu S : R) := sqrt (V_abs j ^ 2 / (U j ^ 2 + Rmax S (H_j + mu * mobility) ^ 2)).
(* (69): there is a closed form with both conditions (54) if and only if beta is below the limit. *)
Definition eq_69 : Prop := forall mu S, is_scene -> 1 <= mu -> 0 < beta -> 0 < V_abs j -> supremum_of_demand S ->
  ((exists phi, is_phase phi /\ slides phi /\ mu * beta < Rabs (holding_friction phi)) <-> beta < limit_69 mu S).

(* Where 2 R_i >= w_i in every mode, the limit (69) is (67): the largest demand is that at the start. *)
Definition eq_67_is_the_limit : Prop := forall mu, is_scene -> (forall i, (i < N)%nat -> w (zeta i) <= 2 * R_ i) -> 1 <= mu ->
  0 < beta -> 0 < V_abs j ->
  ((exists phi, is_phase phi /\ slides phi /\ mu * beta < Rabs (holding_friction phi)) <->
   beta < sqrt (V_abs j ^ 2 / (U j ^ 2 + (H_j + mu * mobility) ^ 2))).

(* (56): the sum of the modes' own maxima is sufficient. *)
Definition sum_of_maxima_is_sufficient : Prop := forall S : nat -> R, is_scene -> 0 < beta -> responds ->
  (forall i t, (i < N)%nat -> 0 < t < PI -> demand_of_mode (R_ i) (zeta i) t / sin t <= S i) ->
  beta * Sum N (fun i => psi j i ^ 2 * S i) < X_j + beta * G j -> forall phi, is_phase phi -> slides phi.

(* ---- Coulomb's contact at all times ------------------------------------------------------------------------------- *)

(* (2), (3): the values that the sign of the velocity may take; at rest any between -mu and mu *)
Definition coulomb (mu velocity sigma : R) :=
  (0 < velocity -> sigma = 1) /\ (velocity < 0 -> sigma = -1) /\ (velocity = 0 -> - mu <= sigma <= mu).
(* The load that static friction has to balance at the time t *)
Definition load_at (phi : R) (y y1 : nat -> R -> R) t := holding_load (cos (t + phi)) (fun k => y k t) (fun k => y1 k t).
(* (74): the contact is at rest, and static friction can hold it. *)
Definition sticks (mu phi : R) (y y1 : nat -> R -> R) t := y1 j t = 0 /\ Rabs (load_at phi y y1 t) <= mu * beta.
(* A motion of (6) from the time 0 to T, from any start: displacements and velocities are continuous; the equation holds with a
   value that Coulomb's law allows at all times but a finite number, the times at which the contact turns, stops or breaks
   away; and a contact at rest whose load is less than static friction can balance stays at rest for some time. *)
Definition contact_motion (mu phi T : R) (y y1 : nat -> R -> R) :=
  (forall a t, (a < N)%nat -> 0 <= t <= T -> continuous (y a) t /\ continuous (y1 a) t) /\
  (exists exceptions : list R, forall t, 0 < t < T -> ~ In t exceptions -> exists (y2 : nat -> R) sigma,
    coulomb mu (y1 j t) sigma /\
    forall a, (a < N)%nat -> is_derive (y a) t (y1 a t) /\ is_derive (y1 a) t (y2 a) /\
      Sum N (fun b => M a b * y2 b + C a b * y1 b t + K a b * y b t) + beta * delta a j * sigma = delta a l * cos (t + phi)) /\
  (forall t, 0 <= t < T -> y1 j t = 0 -> Rabs (load_at phi y y1 t) < mu * beta ->
    exists t', t < t' <= T /\ forall x, t <= x <= t' -> y1 j x = 0).
(* A steady motion returns to its values after the time T. *)
Definition steady_contact_motion (mu phi T : R) (y y1 : nat -> R -> R) :=
  contact_motion mu phi T y y1 /\ forall a, (a < N)%nat -> y a T = y a 0 /\ y1 a T = y1 a 0.
(* the half-period motion, continued by its mirror image over the second half of the period *)
Definition continued (f : nat -> R -> R) (a : nat) (t : R) := if Rle_dec t PI then f a t else - f a (t - PI).

(* Where (54) holds the closed form is a steady motion of the contact with Coulomb's friction, *)
Definition closed_form_is_a_contact_motion : Prop := forall mu, is_scene -> 1 <= mu -> responds -> forall phi, is_phase phi ->
  slides phi -> mu * beta < Rabs (holding_friction phi) ->
  steady_contact_motion mu phi (2 * PI) (continued (x phi)) (continued (x_prime phi)).
(* and where static friction can more than hold its turning point it is none. *)
Definition closed_form_needs_54b : Prop := forall mu, is_scene -> forall phi, is_phase phi -> slides phi ->
  steady_contact_motion mu phi (2 * PI) (continued (x phi)) (continued (x_prime phi)) ->
  mu * beta <= Rabs (holding_friction phi).

(* Forces on any masses, in phase or out of phase, with or without a constant part, need mu = 1 only: a motion of (6) with Coulomb's
   friction under a load on each mass. The paper's load is delta a l * cos (t + phi); forces out of phase are
   p a * cos t - q a * sin t. (74) need not be asked for here. *)
Definition motion_under (load : nat -> R -> R) (T : R) (y y1 : nat -> R -> R) :=
  (forall a t, (a < N)%nat -> 0 <= t <= T -> continuous (y a) t /\ continuous (y1 a) t) /\
  (exists exceptions : list R, forall t, 0 < t < T -> ~ In t exceptions -> exists (y2 : nat -> R) sigma,
    coulomb 1 (y1 j t) sigma /\
    forall a, (a < N)%nat -> is_derive (y a) t (y1 a t) /\ is_derive (y1 a) t (y2 a) /\
      Sum N (fun b => M a b * y2 b + C a b * y1 b t + K a b * y b t) + beta * delta a j * sigma = load a t).
Definition steady_under (load : nat -> R -> R) (T : R) (y y1 : nat -> R -> R) :=
  motion_under load T y y1 /\ forall a, (a < N)%nat -> y a T = y a 0 /\ y1 a T = y1 a 0.

(* The contact reverses twice a period; time counts from a reversal to smaller x. *)
Definition reverses_twice (y1 : nat -> R -> R) := y1 j 0 = 0 /\ exists b, 0 < b < 2 * PI /\
  (forall t, 0 < t < b -> y1 j t < 0) /\ (forall t, b < t < 2 * PI -> 0 < y1 j t).
(* (69) is the boundary of the regime: with damping in all modes there is a steady motion, of whatever form, that reverses twice
   a period and never sticks, (74), if and only if beta is below the limit. From the limit on every steady motion has a stop or
   reverses more often. *)
Definition eq_69_is_the_boundary : Prop := forall mu S, is_scene -> (forall i, (i < N)%nat -> 0 < zeta i) -> 1 <= mu -> 0 < beta
  ->
  0 < V_abs j -> supremum_of_demand S ->
  ((exists phi y y1, steady_contact_motion mu phi (2 * PI) y y1 /\ reverses_twice y1 /\
     forall t, 0 <= t <= 2 * PI -> ~ sticks mu phi y y1 t) <-> beta < limit_69 mu S).

(* Where the contact slides, X_j of (38) is its largest displacement. *)
Definition X_j_is_the_largest : Prop := is_scene -> forall phi, is_phase phi -> slides phi ->
  x phi j 0 = X_j /\ forall t, 0 <= t <= 2 * PI -> Rabs (continued (x phi) j t) <= X_j.

(* For mu = 1 and damping in all modes, any two steady motions under the same forces have the same velocities, *)
Definition one_steady_velocity : Prop := is_scene -> (forall i, (i < N)%nat -> 0 < zeta i) -> 0 <= beta -> forall load T y y1 z z1,
  0 < T -> steady_under load T y y1 -> steady_under load T z z1 ->
  forall k t, (k < N)%nat -> 0 < t < T -> y1 k t = z1 k t.
(* and, where the contact is not at rest at all times, the same displacements. *)
Definition one_steady_motion : Prop := is_scene -> (forall i, (i < N)%nat -> 0 < zeta i) -> 0 <= beta -> forall load T y y1 z z1,
  0 < T -> steady_under load T y y1 -> steady_under load T z z1 ->
  (exists t, 0 < t < T /\ y1 j t <> 0) -> forall k t, (k < N)%nat -> 0 <= t <= T -> y k t = z k t.
(* The paper's motions are among them. *)
Definition contact_motions_are_under_a_load : Prop := forall phi T y y1,
  contact_motion 1 phi T y y1 -> motion_under (fun a t => delta a l * cos (t + phi)) T y y1.
(* Hence for mu = 1, damping in all modes, the period 2 pi and a finite number of exceptions in it, the assumption (25) is a
   theorem for the velocities, and for the displacements where the contact is not at rest at all times. Where it is, it may
   rest anywhere between two positions. *)
Definition steady_motion_is_symmetric : Prop := is_scene -> (forall i, (i < N)%nat -> 0 < zeta i) -> 0 <= beta -> forall phi y y1,
  steady_contact_motion 1 phi (2 * PI) y y1 ->
  (forall k t, (k < N)%nat -> 0 < t < PI -> y1 k (t + PI) = - y1 k t) /\
  ((exists t, 0 < t < 2 * PI /\ y1 j t <> 0) -> forall k t, (k < N)%nat -> 0 <= t <= PI -> y k (t + PI) = - y k t).

(* Attraction, for mu = 1, damping in all modes and forces of period 2 pi: the velocities of every motion, from any start, tend to
   those of a steady motion, *)
Definition velocities_are_attracted : Prop := is_scene -> (forall i, (i < N)%nat -> 0 < zeta i) -> 0 <= beta ->
  forall load, (forall a t, load a (t + 2 * PI) = load a t) ->
  forall y y1 z z1, (forall T, 0 < T -> motion_under load T y y1) -> steady_under load (2 * PI) z z1 ->
  forall eps, 0 < eps -> exists n0 : nat, forall n k t, (n0 <= n)%nat -> (k < N)%nat -> 0 <= t <= 2 * PI ->
  Rabs (y1 k (t + 2 * PI * INR n) - z1 k t) < eps.
(* and so do the displacements where the contact of the steady motion is not at rest at all times. *)
Definition displacements_are_attracted : Prop := is_scene -> (forall i, (i < N)%nat -> 0 < zeta i) -> 0 <= beta ->
  forall load, (forall a t, load a (t + 2 * PI) = load a t) ->
  forall y y1 z z1, (forall T, 0 < T -> motion_under load T y y1) -> steady_under load (2 * PI) z z1 ->
  (exists t, 0 < t < 2 * PI /\ z1 j t <> 0) ->
  forall eps, 0 < eps -> exists n0 : nat, forall n k t, (n0 <= n)%nat -> (k < N)%nat -> 0 <= t <= 2 * PI ->
  Rabs (y k (t + 2 * PI * INR n) - z k t) < eps.

(* Existence, for mu = 1 and forces that are finite sums of harmonics, of any frequencies and phases, on all masses; omega k = 0
   is a constant part. The paper's load is one harmonic on one mass. *)
Definition harmonic_forces (n : nat) (omega : nat -> R) (p q : nat -> nat -> R) (a : nat) (t : R) :=
  Sum n (fun k => p a k * cos (omega k * t) + q a k * sin (omega k * t)).
(* With or without damping, but with no undamped mode at a pole, as in `is_scene`, from every start there is a motion for all
   times, which in any finite time obeys the law at all instants but a finite number, *)
Definition contact_has_a_motion : Prop := is_scene -> 0 <= beta -> forall n omega p q (u v : nat -> R),
  exists y y1, (forall T, motion_under (harmonic_forces n omega p q) T y y1) /\
    forall k, (k < N)%nat -> y k 0 = u k /\ y1 k 0 = v k.
(* and under any forces two motions with the same start are the same. *)
Definition contact_has_one_motion : Prop := is_scene -> 0 <= beta -> forall load T y y1 z z1,
  motion_under load T y y1 -> motion_under load T z z1 ->
  (forall k, (k < N)%nat -> y k 0 = z k 0 /\ y1 k 0 = z1 k 0) ->
  forall k t, (k < N)%nat -> 0 <= t <= T -> y k t = z k t /\ y1 k t = z1 k t.
(* (74) need not be asked for: every motion under the paper's load has it. *)
Definition eq_74_follows : Prop := is_scene -> forall phi T y y1,
  motion_under (fun a t => delta a l * cos (t + phi)) T y y1 -> contact_motion 1 phi T y y1.
(* With damping in all modes one of the motions over the time from 0 to T ends where it starts: it is steady, for forces of
   period T. *)
Definition steady_motion_exists : Prop := is_scene -> (forall i, (i < N)%nat -> 0 < zeta i) -> 0 <= beta ->
  forall n omega p q T, 0 < T -> exists z z1, steady_under (harmonic_forces n omega p q) T z z1.
(* For forces of period 2 pi the velocities of every motion tend to those of this one. *)
Definition steady_motion_exists_and_attracts : Prop := is_scene -> (forall i, (i < N)%nat -> 0 < zeta i) -> 0 <= beta ->
  forall n omega p q, let load := harmonic_forces n omega p q in (forall a t, load a (t + 2 * PI) = load a t) ->
  exists z z1, steady_under load (2 * PI) z z1 /\
  forall y y1, (forall T, 0 < T -> motion_under load T y y1) ->
  forall eps, 0 < eps -> exists n0 : nat, forall n k t, (n0 <= n)%nat -> (k < N)%nat -> 0 <= t <= 2 * PI ->
  Rabs (y1 k (t + 2 * PI * INR n) - z1 k t) < eps.
(* The same for the paper's load, with (74) *)
Definition steady_contact_motion_exists : Prop := is_scene -> (forall i, (i < N)%nat -> 0 < zeta i) -> 0 <= beta -> forall phi,
  exists z z1, steady_contact_motion 1 phi (2 * PI) z z1.
(* For forces that change their sign after half a period, as the paper's load does, there is a steady motion that mirrors itself,
   (25), in its displacements too. *)
Definition mirrored_steady_motion_exists : Prop := is_scene -> (forall i, (i < N)%nat -> 0 < zeta i) -> 0 <= beta ->
  forall n omega p q, let load := harmonic_forces n omega p q in (forall a t, load a (t + PI) = - load a t) ->
  exists z z1, steady_under load (2 * PI) z z1 /\
  forall k t, (k < N)%nat -> 0 <= t <= PI -> z k (t + PI) = - z k t /\ z1 k (t + PI) = - z1 k t.
End All_masses.

(* ---- Forces on all masses, each with a phase of its own ------------------------------------------------------------ *)

Section Under_forces.
Variable s : scene.
(* Mass a bears p a * cos (t + phi) - q a * sin (t + phi), the real part of (p a + i q a) exp(i (t + phi)); `loaded s` does not count. *)
Variables p q : nat -> R.
Local Notation N := (masses s).
Local Notation M := (mass s).
Local Notation C := (damping s).
Local Notation K := (stiffness s).
Local Notation psi := (shape s).
Local Notation R_ := (ratio s).
Local Notation zeta := (damping_ratio s).
Local Notation j := (contact s).
Local Notation beta := (friction s).

Definition forces_at (phi t : R) a := p a * cos (t + phi) - q a * sin (t + phi).
Definition load_on_mode (f : nat -> R) i := Sum N (fun a => psi a i * f a).
(* (33): the load on a mode is complex. (34), (35) do not depend on the load. *)
Definition V_re_under k := Sum N (fun i => psi k i * R_ i ^ 2 *
  (load_on_mode p i * v_re (R_ i) (zeta i) - load_on_mode q i * v_im (R_ i) (zeta i))).
Definition V_im_under k := Sum N (fun i => psi k i * R_ i ^ 2 *
  (load_on_mode p i * v_im (R_ i) (zeta i) + load_on_mode q i * v_re (R_ i) (zeta i))).
Definition V_abs_under k := sqrt (V_re_under k ^ 2 + V_im_under k ^ 2).
(* The paper's load is one of them. *)
Definition one_force_is_among_them : Prop := is_scene s -> p = (fun a => delta a (loaded s)) -> q = (fun _ => 0) -> forall k,
  V_re_under k = V_re s k /\ V_im_under k = V_im s k.

(* (38), its root and its phase, and (46) with its rate *)
Definition root_under := sqrt (V_abs_under j ^ 2 - (beta * U s j) ^ 2).
Definition X_j_under := - beta * G s j + root_under.
Definition responds_under := 0 < V_abs_under j /\ Rabs (beta * U s j) <= V_abs_under j.
Definition is_phase_under (phi : R) := V_re_under j * cos phi - V_im_under j * sin phi = root_under /\
  V_re_under j * sin phi + V_im_under j * cos phi = - (beta * U s j).
Definition friction_velocity k t := Sum N (fun i => psi k i * psi j i * R_ i ^ 2 * braces_prime (R_ i) (zeta i) t).
Definition x_under (phi : R) k t := V_re_under k * cos (t + phi) - V_im_under k * sin (t + phi) + beta * friction_motion s k t.
Definition x_prime_under (phi : R) k t :=
  - (V_re_under k * sin (t + phi) + V_im_under k * cos (t + phi)) + beta * friction_velocity k t.
(* (12), (25), (30) under these forces *)
Definition half_period_motion_under (phi : R) (y y1 y2 : nat -> R -> R) := forall t, 0 < t < PI -> forall a, (a < N)%nat ->
  is_derive (y a) t (y1 a t) /\ is_derive (y1 a) t (y2 a t) /\
  Sum N (fun b => M a b * y2 b t + C a b * y1 b t + K a b * y b t) = delta a j * beta + forces_at phi t a.
Definition steady_half_period_under (phi : R) (y y1 y2 : nat -> R -> R) :=
  (forall a, (a < N)%nat -> continuous_on_half_period (y a) (y1 a)) /\ half_period_motion_under phi y y1 y2 /\
  (forall k, (k < N)%nat -> mirrored (y k) (y1 k)) /\ y1 j 0 = 0.
(* (38), (41), (46): the closed form solves (12), mirrors itself, and its contact starts from rest at X_j; there is no other. *)
Definition steady_motion_under_forces : Prop := is_scene s -> responds_under -> forall phi, is_phase_under phi -> exists x2,
  steady_half_period_under phi (x_under phi) (x_prime_under phi) x2 /\ x_under phi j 0 = X_j_under.
Definition no_other_motion_under_forces : Prop := is_scene s -> responds_under -> forall phi y y1 y2,
  steady_half_period_under phi y y1 y2 -> 0 <= y j 0 + beta * G s j ->
  is_phase_under phi /\ y j 0 = X_j_under /\
  forall k t, (k < N)%nat -> 0 <= t <= PI -> y k t = x_under phi k t /\ y1 k t = x_prime_under phi k t.

(* (54a); the friction that would hold the contact at its turning point, (75) for any M; (69). The demand is that of one force. *)
Definition slides_under (phi : R) := forall t, 0 < t < PI -> x_prime_under phi j t < 0.
Definition holding_friction_under (phi : R) := Sum N (fun a => Sum N (fun i => psi j i * psi a i) *
  (Sum N (fun b => C a b * x_prime_under phi b 0 + K a b * x_under phi b 0) - forces_at phi 0 a)) / mobility s.
Definition limit_69_under (mu S : R) := sqrt (V_abs_under j ^ 2 / (U s j ^ 2 + Rmax S (H_j s + mu * mobility s) ^ 2)).
Definition slides_iff_under_forces : Prop := is_scene s -> forall phi, is_phase_under phi ->
  (slides_under phi <-> forall t, 0 < t < PI -> beta * demand s t < X_j_under + beta * G s j).
Definition eq_66_under_forces : Prop := is_scene s -> forall phi, is_phase_under phi ->
  holding_friction_under phi = (X_j_under + beta * G s j - beta * H_j s) / mobility s.
Definition eq_69_under_forces : Prop := forall mu S, is_scene s -> 1 <= mu -> 0 < beta -> 0 < V_abs_under j ->
  supremum_of_demand s S ->
  ((exists phi, is_phase_under phi /\ slides_under phi /\ mu * beta < Rabs (holding_friction_under phi)) <->
   beta < limit_69_under mu S).
(* For mu = 1 the closed form that slides is a steady motion of Coulomb's contact; `one_steady_motion` says that there is no other. *)
Definition closed_form_is_steady_under_forces : Prop := is_scene s -> forall phi, is_phase_under phi -> slides_under phi ->
  steady_under s (fun a t => forces_at phi t a) (2 * PI) (continued (x_under phi)) (continued (x_prime_under phi)).
End Under_forces.

(* ---- Two scenes for examples -------------------------------------------------------------------------------------- *)

(* One mass, with any R_i, zeta_i and beta *)
Definition single_mass (R_i zeta_i beta : R) : scene :=
  Scene 1 (fun _ _ => 1) (fun _ _ => 2 * zeta_i / R_i) (fun _ _ => / R_i ^ 2) (fun _ _ => 1) (fun _ => R_i) (fun _ => zeta_i) 0
    0 beta.
(* Two equal masses; the first has the load and the contact. R = (1/2, 1), zeta = (0, 1/2), and the mode shapes (3, 4)/5 and
   (4, -3)/5 *)
Definition entry (x y z v : R) (a b : nat) : R := match a, b with O, O => x | O, _ => y | _, O => z | _, _ => v end.
Definition two_masses (beta : R) : scene :=
  Scene 2 (entry 1 0 0 1) (entry (16 / 25) (-12 / 25) (-12 / 25) (9 / 25)) (entry (52 / 25) (36 / 25) (36 / 25) (73 / 25))
    (entry (3 / 5) (4 / 5) (4 / 5) (-3 / 5)) (fun i => match i with O => 1 / 2 | _ => 1 end) (fun i => match i with O => 0 | _
      => 1 / 2 end) 0 0 beta.
Definition examples_are_scenes : Prop :=
  (forall R_i zeta beta, admissible R_i zeta -> is_scene (single_mass R_i zeta beta)) /\
    (forall beta, is_scene (two_masses beta)).

(* ---- The equations that do not hold as printed, each with a scene in which it fails ------------------------------- *)

(* the braces as printed: sine and cosine exchanged in the bracket *)
Definition braces_printed R_i zeta t :=
  1 - (1 + g R_i zeta) * exp (- zeta * t / R_i) * (sin (w zeta * t / R_i) + zeta / w zeta * cos (w zeta * t / R_i))
    - u R_i zeta * R_i * q R_i zeta t.
Definition eq_40_as_printed : Prop := ~ forall R_i zeta psi_j psi_l beta phi y y1 y2, admissible R_i zeta ->
  continuous_on_half_period y y1 -> modal_equation R_i zeta psi_j psi_l beta phi y y1 y2 -> mirrored y y1 ->
    forall t, 0 <= t <= PI ->
  y t = (y 0 + psi_j * R_i ^ 2 * g R_i zeta * beta) * cos t + (y1 0 + psi_j * R_i ^ 2 * u R_i zeta * beta) * sin t
        + beta * psi_j * R_i ^ 2 * braces_printed R_i zeta t.
Definition friction_motion_printed s k t :=
  Sum (masses s) (fun i => shape s k i * shape s (contact s) i * ratio s i ^ 2
    * braces_printed (ratio s i) (damping_ratio s i) t).
Definition eq_41_as_printed : Prop := ~ forall s phi k t, is_scene s -> responds s -> is_phase s phi -> (k < masses s)%nat ->
  0 <= t <= PI ->
  x s phi k t = (x s phi k 0 + friction s * G s k) * cos t + (x_prime s phi k 0 + friction s * U s k) * sin t + friction s
    * friction_motion_printed s k t.
Definition eq_46_as_printed : Prop := ~ forall s phi k t, is_scene s -> responds s -> is_phase s phi -> (k < masses s)%nat ->
  0 <= t <= PI ->
  let D := V_arg s k - V_arg s (contact s) in
  x s phi k t = V_abs s k / V_abs s (contact s) * (root s * cos (t + D) + friction s * U s (contact s) * sin (t + D))
    + friction s * friction_motion_printed s k t.

(* (44), (45): the real part of what is printed lacks the term with the sine. *)
Definition eq_44_as_printed : Prop := ~ forall s phi k, is_scene s -> responds s -> is_phase s phi -> (k < masses s)%nat ->
  x s phi k 0 = - friction s * G s k + V_abs s k / V_abs s (contact s) * root s * cos (V_arg s k - V_arg s (contact s)).
Definition eq_45_as_printed : Prop := ~ forall s phi k, is_scene s -> responds s -> is_phase s phi -> (k < masses s)%nat ->
  x_prime s phi k 0 = friction s * (V_abs s k / V_abs s (contact s) * U s (contact s) * cos (V_arg s k - V_arg s (contact s))
    - U s k).

(* (49): with x_k0 = a + i b and x_k0' = c + i e as (44) and (45) print them, the second expression has another real part than
   the first. *)
Definition eq_49_as_printed : Prop := ~ forall s phi k t, is_scene s -> responds s -> is_phase s phi -> (k < masses s)%nat ->
  let D := V_arg s k - V_arg s (contact s) in
  let a := - friction s * G s k + V_abs s k / V_abs s (contact s) * root s * cos D in
  let b := V_abs s k / V_abs s (contact s) * root s * sin D in
  let c := friction s * (V_abs s k / V_abs s (contact s) * U s (contact s) * cos D - U s k) in
  let e := friction s * (V_abs s k / V_abs s (contact s) * U s (contact s) * sin D) in
  a * cos t + c * sin t = (a + e) * cos t - (b - c) * sin t.

(* (50): the ratio |V_k| / |V_j| multiplies the first term only. *)
Definition eq_50_as_printed : Prop := ~ forall s phi k, is_scene s -> responds s -> is_phase s phi -> (k < masses s)%nat ->
  let D := V_arg s k - V_arg s (contact s) in
  x s phi k 0 = V_abs s k / V_abs s (contact s) * root s * cos D + friction s * U s (contact s) * sin D - friction s * G s k.

(* (52): the sign of U_k sin(D) *)
Definition eq_52_as_printed : Prop := ~ forall s k, is_scene s -> responds s -> (k < masses s)%nat ->
  let D := V_arg s k - V_arg s (contact s) in
  sqrt (X_kC s k ^ 2 + X_kS s k ^ 2) =
  sqrt (V_abs s k ^ 2 + friction s ^ 2 * (G s k ^ 2 + U s k ^ 2) - 2 * friction s * (V_abs s k / V_abs s (contact s)) *
    (root s * (G s k * cos D + U s k * sin D) + friction s * U s (contact s) * (G s k * sin D + U s k * cos D))).

(* (56) is not necessary: a scene slides although beta times the sum of the modes' own suprema exceeds what it has to stay
  below. *)
Definition eq_56_as_printed : Prop := ~ forall s (S : nat -> R) phi, is_scene s -> 0 < friction s -> responds s -> is_phase s
  phi ->
  (forall i, (i < masses s)%nat ->
    is_lub (fun y => exists t, 0 < t < PI /\ y = demand_of_mode (ratio s i) (damping_ratio s i) t / sin t) (S i)) ->
  slides s phi -> friction s * Sum (masses s) (fun i => shape s (contact s) i ^ 2 * S i) < X_j s + friction s * G s (contact s).

(* (57) as printed: the other bracket, and no cosine of tau *)
Definition demand_printed R_i zeta t :=
  ((1 + g R_i zeta) * exp (- zeta * t / R_i) * (R_i / w zeta) * sin (w zeta * t / R_i)
   - u R_i zeta * R_i ^ 2 * exp (- zeta * t / R_i) * (sin (w zeta * t / R_i) + zeta / w zeta * cos (w zeta * t / R_i))) / sin t.
(* With it, (55) to (58) admit a scene in which the contact does not slide throughout, *)
Definition eq_57_as_printed : Prop := ~ forall s S phi, is_scene s -> 0 < friction s -> responds s -> is_phase s phi ->
  (forall i t, (i < masses s)%nat -> 0 < t < PI -> demand_printed (ratio s i) (damping_ratio s i) t <= S i) ->
  friction s * Sum (masses s) (fun i => shape s (contact s) i ^ 2 * S i) < X_j s + friction s * G s (contact s) -> slides s phi.
(* and so does (69). *)
Definition eq_69_as_printed : Prop := ~ forall s S mu phi, is_scene s -> 0 < friction s -> 1 <= mu -> responds s ->
  is_phase s phi ->
  (forall i t, (i < masses s)%nat -> 0 < t < PI -> demand_printed (ratio s i) (damping_ratio s i) t <= S i) ->
  friction s < sqrt (V_abs s (contact s) ^ 2 / (U s (contact s) ^ 2 +
    Rmax (Sum (masses s) (fun i => shape s (contact s) i ^ 2 * S i)) (H_j s + mu * mobility s) ^ 2)) -> slides s phi.

(* (63) follows from (59), mode by mode, *)
Definition eq_63_is_eq_59 : Prop := forall R_i zeta psi_j psi_l beta phi y y1 y2, admissible R_i zeta -> psi_l <> 0 ->
  continuous_on_half_period y y1 -> modal_equation R_i zeta psi_j psi_l beta phi y y1 y2 -> mirrored y y1 ->
  2 * zeta / R_i * y1 0 + / R_i ^ 2 * y 0 - psi_l * cos phi
  = y 0 - beta * psi_j * ((1 - R_i ^ 2) * g R_i zeta + 2 * zeta * R_i * u R_i zeta).
(* but neither is a condition: the contact of a scene slides and breaks away, (54), while a mode does not satisfy (59), (63). *)
Definition eq_59_63_as_printed : Prop := ~ forall s mu phi, is_scene s -> contact_inertia_alone s -> 0 < friction s ->
  1 <= mu -> responds s -> is_phase s phi ->
  slides s phi -> mu * friction s < Rabs (contact_load s phi) -> forall i, (i < masses s)%nat ->
  shape s (contact s) i * mu * friction s <
  Rabs (2 * damping_ratio s i / ratio s i * eta_prime (ratio s i) (damping_ratio s i) (shape s (contact s) i) (shape s (loaded
    s) i) (friction s) phi 0
    + / ratio s i ^ 2 * eta (ratio s i) (damping_ratio s i) (shape s (contact s) i) (shape s (loaded s) i) (friction s) phi 0
    - shape s (loaded s) i * cos phi).

(* (68) as printed, without the condition on the sign of H_j - mu / (gamma_j r^2), does not give (66). *)
Definition eq_68_as_printed : Prop := ~ forall s mu phi, is_scene s -> 0 < friction s -> 1 <= mu -> responds s ->
  is_phase s phi ->
  sqrt (V_abs s (contact s) ^ 2 / (U s (contact s) ^ 2 + (H_j s - mu * mobility s) ^ 2)) < friction s ->
  mu * friction s < Rabs (X_j s + friction s * G s (contact s) - friction s * H_j s) / mobility s.

(* (70): the expansion of (57) at the start has the bracket with this sign; as printed it tends to another value than (57)
   does. *)
Definition expansion R_i zeta t := ((1 + g R_i zeta) * (1 - zeta * t / R_i) * t - u R_i zeta * R_i ^ 2 * ((1 - zeta
  * t / R_i) ^ 2 - 1)) / t.
Definition expansion_printed R_i zeta t := ((1 + g R_i zeta) * (1 - zeta * t / R_i) * t - u R_i zeta * R_i ^ 2 * (1 - (1 - zeta
  * t / R_i) ^ 2)) / t.
Definition eq_70_71 : Prop := forall R_i zeta, admissible R_i zeta ->
  is_lim (fun t => demand_of_mode R_i zeta t / sin t) 0 (1 + g R_i zeta + 2 * zeta * R_i * u R_i zeta) /\
  is_lim (expansion R_i zeta) 0 (1 + g R_i zeta + 2 * zeta * R_i * u R_i zeta).
Definition eq_70_as_printed : Prop := ~ forall R_i zeta l, admissible R_i zeta ->
  is_lim (fun t => demand_of_mode R_i zeta t / sin t) 0 (Finite l) -> is_lim (expansion_printed R_i zeta) 0 (Finite l).
(* Where 2 R_i >= w_i, (57) as corrected is nowhere larger than what it tends to at the start, (71). *)
Definition eq_57_largest_at_start : Prop := forall R_i zeta t, admissible R_i zeta -> w zeta <= 2 * R_i -> 0 < t < PI ->
  demand_of_mode R_i zeta t / sin t <= 1 + g R_i zeta + 2 * zeta * R_i * u R_i zeta.
(* Twice the slope of (57) at the start. Beside the start (57) is above (71) where it is positive, and below where it is
   negative. *)
Definition slope_at_start R_i zeta := u R_i zeta * (1 - R_i ^ 2 - 4 * zeta ^ 2) - 2 * zeta * (1 + g R_i zeta) / R_i.
Definition eq_57_beside_the_start : Prop := forall R_i zeta, admissible R_i zeta ->
  let at_start := 1 + g R_i zeta + 2 * zeta * R_i * u R_i zeta in
  (0 < slope_at_start R_i zeta -> exists d, 0 < d /\ forall t, 0 < t < d -> at_start < demand_of_mode R_i zeta t / sin t) /\
  (slope_at_start R_i zeta < 0 -> exists d, 0 < d /\ forall t, 0 < t < d -> demand_of_mode R_i zeta t / sin t < at_start).
(* The damping from which on (57) rises from the start at no frequency lies between 0.138 and 0.141. *)
Definition eq_57_threshold : Prop :=
  (forall zeta, 0 <= zeta <= 138 / 1000 -> exists R_i, admissible R_i zeta /\ 0 < slope_at_start R_i zeta) /\
  (forall R_i zeta, admissible R_i zeta -> 141 / 1000 <= zeta -> slope_at_start R_i zeta <= 0).
(* (72): what all modes demand at the start is H_j and the sum of (65). *)
Definition eq_72 : Prop := forall s, is_scene s -> is_lim (demand s) 0 (H_j s + mobility s).

(* (81): (52) with |V_j| for the root and (78) for the angle; as printed it has another term. *)
Definition eq_81 : Prop := forall V_k V_j G_k U_k U_j beta sign, 0 < V_j -> sign = 1 \/ sign = -1 ->
  V_k ^ 2 + beta ^ 2 * (G_k ^ 2 + U_k ^ 2) - 2 * beta * (V_k / V_j) * (V_j * (G_k * sign - U_k * 0) + beta * U_j * (G_k * 0
    + U_k * sign))
  = V_k ^ 2 + beta ^ 2 * (G_k ^ 2 + U_k ^ 2) - 2 * beta * (V_k * (sign * G_k) + beta * (sign * (V_k / V_j)) * U_j * U_k).
Definition eq_81_as_printed : Prop := ~ forall V_k V_j G_k U_k U_j beta sign, 0 < V_k -> 0 < V_j -> 0 <= beta -> sign = 1 \/
  sign = -1 -> sign * G_k = Rabs G_k ->
  V_k ^ 2 + beta ^ 2 * (G_k ^ 2 + U_k ^ 2) - 2 * beta * (V_k / V_j) * (V_j * (G_k * sign - U_k * 0) + beta * U_j * (G_k * 0
    + U_k * sign))
  = V_k ^ 2 + beta ^ 2 * (G_k ^ 2 + U_k ^ 2) - beta * (2 * V_k * Rabs G_k - Rabs U_j * Rabs U_k).

(* (88), third line: a held contact under the load carries cos(tau) alone; static friction holds it for ever if and only if
   beta is not below 1 / mu. *)
Definition eq_88_third_line : Prop := forall mu beta, 0 < mu -> ((forall t, Rabs (cos t) <= mu * beta) <-> 1 / mu <= beta).

(* (A.7) as printed: the sign of the first term *)
Definition eq_A_7_as_printed : Prop := ~ forall R_i zeta psi_j psi_l beta phi y0 y10 t, admissible R_i zeta ->
  is_derive (from_start R_i zeta psi_j psi_l beta phi y0 y10) t
    (q R_i zeta t / R_i * y0 + R_i * q_prime R_i zeta t * y10 + psi_j * R_i ^ 2 * (q R_i zeta t / R_i) * beta -
     psi_l * R_i ^ 2 * ((v_re R_i zeta * cos phi - v_im R_i zeta * sin phi) * (sin t - q R_i zeta t / R_i) +
                        (v_re R_i zeta * sin phi + v_im R_i zeta * cos phi) * (cos t - R_i * q_prime R_i zeta t))).

(* ---- mu > 1: more than one steady motion -------------------------------------------------------------------------- *)

(* For mu > 1 a scene with damping has two steady motions with different velocities under the same load: one slides and
   breaks away from each of its turning points, (54), the other rests for ever. *)
Definition two_motions : Prop := exists s mu phi y y1 z z1, is_scene s /\ (forall i, (i < masses s)%nat ->
  0 < damping_ratio s i) /\
  0 < friction s /\ 1 < mu /\
  steady_contact_motion s mu phi (2 * PI) y y1 /\ steady_contact_motion s mu phi (2 * PI) z z1 /\
  (forall t, 0 < t < PI -> y1 (contact s) t < 0) /\ mu * friction s < Rabs (contact_load s phi) /\ y = continued (x s phi) /\
  (forall t, z1 (contact s) t = 0).

(* ---- Limits and resonance: Section 4.1, 4.2 ----------------------------------------------------------------------- *)

(* (28), (29) for vanishing damping, off the poles *)
Definition undamped_limits : Prop := forall R_i, 0 < R_i -> 1 + cos (PI / R_i) <> 0 ->
  filterlim (u R_i) (at_right 0) (locally (sin (PI / R_i) / (R_i * (1 + cos (PI / R_i))))) /\
    filterlim (g R_i) (at_right 0) (locally 0) /\
  g R_i 0 = 0.
(* at R_i = 1 the first damping function tends to 1/pi, and zeta g to 2/pi: the second one grows without bound *)
Definition limits_at_resonance : Prop :=
  filterlim (u 1) (at_right 0) (locally (/ PI)) /\ filterlim (fun zeta => zeta * g 1 zeta) (at_right 0) (locally (2 / PI)).
(* (23), (76), (77): at R_i = 1 the response of a damped mode is -i / (2 zeta). *)
Definition eq_76_77 : Prop := forall zeta, 0 < zeta ->
  v_re 1 zeta = 0 /\ v_im 1 zeta = - / (2 * zeta) /\ v_abs 1 zeta = / (2 * zeta).
(* (83)-(85): the estimate (84) vanishes at beta times this; (85) is where (83) vanishes for the mass in contact, k = j. *)
Definition eq_85_is_the_zero_of_83 : Prop := forall psi_l psi_j zeta, 0 < zeta -> psi_j <> 0 ->
  let beta := Rabs (psi_l / psi_j) * ((cosh (zeta * PI) - 1) / (2 * zeta * sinh (zeta * PI))) in
  Rabs (psi_j * psi_l) / (2 * zeta) - Rabs (psi_j * psi_j) * (sinh (zeta * PI) / (cosh (zeta * PI) - 1)) * beta = 0.
(* (85) tends to |psi_l / psi_j| pi / 4 for vanishing damping. *)
Definition eq_85_undamped : Prop :=
  filterlim (fun zeta => (cosh (zeta * PI) - 1) / (2 * zeta * sinh (zeta * PI))) (at_right 0) (locally (PI / 4)).
(* The orders of the errors: f is of the order of zeta^n for zeta -> 0. *)
Definition of_order (n : nat) (f : R -> R) := exists B e, 0 < e /\ forall zeta, 0 < zeta < e -> Rabs (f zeta) <= B * zeta ^ n.
(* (79) *)
Definition second_function_at_resonance zeta := sinh (zeta * PI) / (cosh (zeta * PI) - 1).
(* (79) against (29) at R_i = 1: the relative error is of second order, with the factor 3/4. *)
Definition eq_79 : Prop :=
  filterlim (fun zeta => (g 1 zeta / second_function_at_resonance zeta - 1) / zeta ^ 2) (at_right 0) (locally (- (3 / 4))).
(* (38) of one mass at r = 1 less (84): of first order, with this factor *)
Definition eq_84 : Prop := forall beta,
  filterlim (fun zeta => (X_j (single_mass 1 zeta beta) - (1 / (2 * zeta) - second_function_at_resonance zeta * beta)) / zeta)
    (at_right 0) (locally (3 * beta / (2 * PI) - beta ^ 2 / PI ^ 2)).
(* What (83) and (85) leave out at a given damping, for the mass in contact, where mode m is at its resonance: the other modes, U_j, the
   error of (79), and the terms of (67) besides G_j *)
Section At_a_resonance.
Variable s : scene.
Variable m : nat.
Local Notation N := (masses s).
Local Notation psi := (shape s).
Local Notation R_ := (ratio s).
Local Notation zeta := (damping_ratio s).
Local Notation j := (contact s).
Local Notation l := (loaded s).
Local Notation beta := (friction s).
Definition without_m (f : nat -> R) i := if Nat.eqb i m then 0 else f i.
Definition V_of_others := Sum N (without_m (fun i => Rabs (psi j i * psi l i) * R_ i ^ 2 * v_abs (R_ i) (zeta i))).
Definition G_of_others := Sum N (without_m (fun i => psi j i ^ 2 * R_ i ^ 2 * Rabs (g (R_ i) (zeta i)))).
Definition H_of_others := Sum N (without_m (fun i => psi j i ^ 2 * Rabs (g (R_ i) (zeta i) + 2 * zeta i * R_ i * u (R_ i) (zeta i)))).
Definition error_79 := Rabs (g 1 (zeta m) - second_function_at_resonance (zeta m)).
Definition X_83 := Rabs (psi j m * psi l m) / (2 * zeta m) - psi j m ^ 2 * second_function_at_resonance (zeta m) * beta.
Definition eq_83_error : Prop := is_scene s -> responds s -> 0 <= beta -> (m < N)%nat -> R_ m = 1 -> 0 < zeta m ->
  Rabs (X_j s - X_83) <= V_of_others + beta * (G_of_others + psi j m ^ 2 * error_79) + (beta * U s j) ^ 2 / V_abs s j.
Definition beta_85 := Rabs (psi l m / psi j m) * ((cosh (zeta m * PI) - 1) / (2 * zeta m * sinh (zeta m * PI))).
Definition eq_85_error : Prop := forall mu, is_scene s -> (m < N)%nat -> R_ m = 1 -> 0 < zeta m -> psi j m <> 0 -> 1 <= mu ->
  let D := H_j s + mu * mobility s in
  Rabs (sqrt (V_abs s j ^ 2 / (U s j ^ 2 + D ^ 2)) - beta_85) <=
  (V_of_others + beta_85 * (Rabs (U s j) + H_of_others + psi j m ^ 2 * (error_79 + 2 * zeta m * Rabs (u 1 (zeta m)))
    + mu * mobility s)) / sqrt (U s j ^ 2 + D ^ 2).
End At_a_resonance.
(* A scene with damping ratios c i zeta, by (19) *)
Definition lightly_damped (s : scene) (c : nat -> R) (zeta : R) : scene :=
  Scene (masses s) (mass s) (fun a b => Sum (masses s) (fun i => 2 * (c i * zeta) / ratio s i *
    Sum (masses s) (fun e => mass s a e * shape s e i) * Sum (masses s) (fun e => mass s b e * shape s e i)))
    (stiffness s) (shape s) (ratio s) (fun i => c i * zeta) (contact s) (loaded s) (friction s).
(* Mode p is at its resonance, and no other at a pole of (28) without damping. *)
Definition at_resonance (s : scene) (c : nat -> R) (p : nat) := (p < masses s)%nat /\ ratio s p = 1 /\ c p = 1 /\
  forall i, (i < masses s)%nat -> 0 <= c i /\ 0 < ratio s i /\ (i <> p -> 1 + cos (PI / ratio s i) <> 0).
(* (76), (77): the real part of V_k is of order 0, its imaginary part and its modulus are those printed but for terms of first
   order *)
Definition eq_76_77_order : Prop := forall s c p k, at_resonance s c p ->
  of_order 0 (fun zeta => V_re (lightly_damped s c zeta) k) /\
  of_order 1 (fun zeta => V_im (lightly_damped s c zeta) k + shape s k p * shape s (loaded s) p / (2 * zeta)) /\
  (shape s k p * shape s (loaded s) p <> 0 ->
   of_order 1 (fun zeta => V_abs (lightly_damped s c zeta) k - Rabs (shape s k p * shape s (loaded s) p) / (2 * zeta))).
(* (80), and U_k *)
Definition eq_80_order : Prop := forall s c p k, at_resonance s c p ->
  of_order 1 (fun zeta => G (lightly_damped s c zeta) k - shape s k p * shape s (contact s) p * second_function_at_resonance
    zeta) /\
  of_order 0 (fun zeta => U (lightly_damped s c zeta) k).
(* (83): (52) at a resonance is (83) but for a term of first order. (83) grows like 1 / zeta: the relative error is of second
   order. *)
Definition eq_83_order : Prop := forall s c p k, at_resonance s c p ->
  shape s k p <> 0 -> shape s (contact s) p <> 0 -> shape s (loaded s) p <> 0 ->
  0 <= friction s < PI / 4 * Rabs (shape s (loaded s) p / shape s (contact s) p) ->
  of_order 1 (fun zeta => X_k (lightly_damped s c zeta) k - (Rabs (shape s k p * shape s (loaded s) p) / (2 * zeta)
    - Rabs (shape s k p * shape s (contact s) p) * second_function_at_resonance zeta * friction s)).
(* (85): (67) at a resonance is (85) but for a term of first order. *)
Definition eq_85_order : Prop := forall s c p mu, at_resonance s c p ->
  shape s (contact s) p <> 0 -> shape s (loaded s) p <> 0 ->
  of_order 1 (fun zeta => let s' := lightly_damped s c zeta in
    sqrt (V_abs s' (contact s) ^ 2 / (U s' (contact s) ^ 2 + (H_j s' + mu * mobility s') ^ 2))
    - Rabs (shape s (loaded s) p / shape s (contact s) p) * ((cosh (zeta * PI) - 1) / (2 * zeta * sinh (zeta * PI)))).
(* (86) as corrected: the limit (67) of one mass, M = r^2 = R^2, for large frequencies *)
Definition limit_of_single_mass mu zeta R_i :=
  sqrt (v_abs R_i zeta ^ 2 / (u R_i zeta ^ 2 + (/ R_i ^ 2 * (g R_i zeta + 2 * zeta * R_i * u R_i zeta) + mu / R_i ^ 2) ^ 2)).
Definition eq_86 : Prop := forall mu zeta, 0 < mu -> 0 <= zeta < 1 ->
  filterlim (limit_of_single_mass mu zeta) (Rbar_locally p_infty) (locally (2 / sqrt (4 * mu ^ 2 + PI ^ 2))).
Definition eq_86_as_printed : Prop := ~ forall mu zeta, 1 <= mu -> 0 <= zeta < 1 ->
  filterlim (limit_of_single_mass mu zeta) (Rbar_locally p_infty) (locally (2 / sqrt (4 * mu + PI ^ 2))).

(* (67) for any number of masses: all is divided by the sum of (65). a i is the share of mode i in it, and b i what mode i has in
   the same sum with the shape of the loaded mass for one of the two factors. *)
Definition limit_by_shares (n : nat) (a b R_ zeta : nat -> R) (mu : R) :=
  sqrt ((Sum n (fun i => b i * (R_ i ^ 2 * v_re (R_ i) (zeta i))) ^ 2 +
         Sum n (fun i => b i * (R_ i ^ 2 * v_im (R_ i) (zeta i))) ^ 2) /
        (Sum n (fun i => a i * (R_ i ^ 2 * u (R_ i) (zeta i))) ^ 2 +
         (Sum n (fun i => a i * (g (R_ i) (zeta i) + 2 * zeta i * (R_ i * u (R_ i) (zeta i)))) + mu) ^ 2)).
Definition eq_67_by_shares : Prop := forall s mu, is_scene s ->
  sqrt (V_abs s (contact s) ^ 2 / (U s (contact s) ^ 2 + (H_j s + mu * mobility s) ^ 2)) =
  limit_by_shares (masses s) (fun i => shape s (contact s) i ^ 2 / mobility s)
    (fun i => shape s (contact s) i * shape s (loaded s) i / mobility s) (ratio s) (damping_ratio s) mu.
(* Where no inertia couples the contact to another mass, the second shares add up to 1 for j = l and to 0 for j not l. *)
Definition sum_of_shares : Prop := forall s, is_scene s -> contact_inertia_alone s ->
  Sum (masses s) (fun i => shape s (contact s) i ^ 2 / mobility s) = 1 /\
  Sum (masses s) (fun i => shape s (contact s) i * shape s (loaded s) i / mobility s) = delta (contact s) (loaded s).
(* (86) as corrected, both lines, for any number of masses: the frequency ratios of all modes grow with r. *)
Definition eq_86_all_masses : Prop := forall n (a b rho zeta : nat -> R) mu, 0 < mu -> Sum n a = 1 ->
  (forall i, (i < n)%nat -> 0 < rho i /\ 0 <= zeta i < 1) ->
  filterlim (fun r => limit_by_shares n a b (fun i => r * rho i) zeta mu) (Rbar_locally p_infty)
    (locally (Rabs (Sum n b) * (2 / sqrt (4 * mu ^ 2 + PI ^ 2)))).

(* ---- One system at all frequencies --------------------------------------------------------------------------------- *)

(* The scene s at r times its frequency: (7), (8), (22). The shapes of (17) and the modes' ratios scale with it. *)
Definition at_frequency (s : scene) (r : R) : scene :=
  Scene (masses s) (fun a b => r ^ 2 * mass s a b) (fun a b => r * damping s a b) (stiffness s) (fun k i => shape s k i / r)
    (fun i => r * ratio s i) (damping_ratio s) (contact s) (loaded s) (friction s).
Definition at_frequency_is_a_scene : Prop := forall s r, is_scene s -> 0 < r ->
  (forall i, (i < masses s)%nat -> admissible (r * ratio s i) (damping_ratio s i)) -> is_scene (at_frequency s r).
(* The shares of the modes in (65) are the same at all frequencies. *)
Definition shares_are_constant : Prop := forall s r k i, is_scene s -> 0 < r ->
  mobility (at_frequency s r) = mobility s / r ^ 2 /\
  shape (at_frequency s r) (contact s) i * shape (at_frequency s r) k i / mobility (at_frequency s r) =
  shape s (contact s) i * shape s k i / mobility s.
(* L is the limit (69) of the system by its frequency. *)
Definition is_limit_69 (s : scene) (mu : R) (L : R -> R) := forall r S, 0 < r -> is_scene (at_frequency s r) ->
  supremum_of_demand (at_frequency s r) S -> L r = limit_69 (at_frequency s r) mu S.
(* (86) as corrected, both lines: the limit of (69) for large frequencies. *)
Definition eq_86_from_eq_69 : Prop := forall s mu L, is_scene s -> contact_inertia_alone s -> 1 <= mu -> is_limit_69 s mu L ->
  (exists r0, forall r, r0 < r -> is_scene (at_frequency s r)) /\
  filterlim L (Rbar_locally p_infty) (locally (delta (contact s) (loaded s) * (2 / sqrt (4 * mu ^ 2 + PI ^ 2)))).
(* Amplitudes, (38) and (52), vanish for large frequencies. *)
Definition amplitudes_vanish : Prop := forall s k e, is_scene s -> (k < masses s)%nat -> 0 < e ->
  exists r0, forall r, r0 < r -> responds (at_frequency s r) -> X_k (at_frequency s r) k < e /\ Rabs (X_j (at_frequency s r)) < e.
(* (67) for small frequencies, with damping in all modes: it tends to 0 as r^2 does, and y are the displacements under the load at
   rest, (K^-1)_kl. *)
Definition eq_67_low_frequency : Prop := forall s mu (y : nat -> R), is_scene s -> contact_inertia_alone s -> 1 <= mu ->
  (forall i, (i < masses s)%nat -> 0 < damping_ratio s i) ->
  (forall a, (a < masses s)%nat -> Sum (masses s) (fun b => stiffness s a b * y b) = delta a (loaded s)) ->
  filterlim (fun r => let s' := at_frequency s r in
    sqrt (V_abs s' (contact s) ^ 2 / (U s' (contact s) ^ 2 + (H_j s' + mu * mobility s') ^ 2)) / r ^ 2) (at_right 0)
    (locally (Rabs (y (contact s)) * mass s (contact s) (contact s) / (1 + mu))).

(* and so does the limit (69) itself, with the same factor. *)
Definition eq_69_low_frequency : Prop := forall s mu L (y : nat -> R), is_scene s -> contact_inertia_alone s -> 1 <= mu ->
  (forall i, (i < masses s)%nat -> 0 < damping_ratio s i) ->
  (forall a, (a < masses s)%nat -> Sum (masses s) (fun b => stiffness s a b * y b) = delta a (loaded s)) ->
  is_limit_69 s mu L ->
  (exists r0, 0 < r0 /\ forall r, 0 < r < r0 -> is_scene (at_frequency s r)) /\
  filterlim (fun r => L r / r ^ 2) (at_right 0) (locally (Rabs (y (contact s)) * mass s (contact s) (contact s) / (1 + mu))).

(* ---- Invariant points, and a contact that is held: Section 4.3 ------------------------------------------------------ *)

(* (87): without damping, the square of the amplitude (52); with friction it is what it is without where U_k = 0, and where (87)
   holds. *)
Definition eq_87 : Prop := forall s k, is_scene s -> (forall i, (i < masses s)%nat -> damping_ratio s i = 0) -> responds s ->
  X_k s k ^ 2 = V_re s k ^ 2 + friction s ^ 2 * (U s k ^ 2 - 2 * (V_re s k / V_re s (contact s)) * (U s (contact s) * U s k)) /\
  (0 < friction s -> U s k <> 0 ->
   (X_k s k = V_abs s k <-> 1 - 2 * (V_re s k / V_re s (contact s)) * (U s (contact s) / U s k) = 0)).

(* A motion with the contact held: X_re k cos(tau) - X_im k sin(tau) solves all rows of (6) but that of the contact. *)
Definition held_motion (s : scene) (X_re X_im : nat -> R) := X_re (contact s) = 0 /\ X_im (contact s) = 0 /\
  forall a, (a < masses s)%nat -> a <> contact s ->
  Sum (masses s) (fun b => (stiffness s a b - mass s a b) * X_re b - damping s a b * X_im b) = delta a (loaded s) /\
  Sum (masses s) (fun b => (stiffness s a b - mass s a b) * X_im b + damping s a b * X_re b) = 0.
(* The amplitude of the load that friction has to balance in the row of the contact *)
Definition held_load (s : scene) (X_re X_im : nat -> R) :=
  let j := contact s in
  sqrt ((Sum (masses s) (fun b => (stiffness s j b - mass s j b) * X_re b - damping s j b * X_im b) - delta j (loaded s)) ^ 2 +
        Sum (masses s) (fun b => (stiffness s j b - mass s j b) * X_im b + damping s j b * X_re b) ^ 2).
(* (88) as corrected: this is a steady motion of Coulomb's contact if and only if beta is not below the amplitude over mu. *)
Definition rests (s : scene) (mu : R) (X_re X_im : nat -> R) := steady_contact_motion s mu 0 (2 * PI)
  (fun k t => X_re k * cos t - X_im k * sin t) (fun k t => - (X_re k * sin t + X_im k * cos t)).
Definition eq_88 : Prop := forall s mu X_re X_im, (contact s < masses s)%nat -> 0 < mu -> 0 < friction s ->
  held_motion s X_re X_im -> (rests s mu X_re X_im <-> held_load s X_re X_im / mu <= friction s).
(* The first two lines: a chain without a damper at the contact, with the load on another mass and one neighbour p that moves. *)
Definition eq_88_by_spring : Prop := forall s X_re X_im p, contact_inertia_alone s -> (contact s < masses s)%nat ->
  (p < masses s)%nat -> p <> contact s -> loaded s <> contact s -> held_motion s X_re X_im ->
  (forall b, (b < masses s)%nat -> b <> contact s -> damping s (contact s) b = 0) ->
  (forall b, (b < masses s)%nat -> b <> contact s -> b <> p -> stiffness s (contact s) b = 0 \/ X_re b = 0 /\ X_im b = 0) ->
  held_load s X_re X_im = Rabs (stiffness s (contact s) p) * sqrt (X_re p ^ 2 + X_im p ^ 2).
(* A held contact divides a chain: with the load on one side of it, the masses on the other side may rest. *)
Definition held_contact_divides : Prop := forall s X_re X_im (side : nat -> bool), held_motion s X_re X_im ->
  side (loaded s) = true -> (forall a b, (a < masses s)%nat -> (b < masses s)%nat -> a <> contact s -> b <> contact s ->
    side a <> side b -> mass s a b = 0 /\ damping s a b = 0 /\ stiffness s a b = 0) ->
  held_motion s (fun k => if side k then X_re k else 0) (fun k => if side k then X_im k else 0).
(* The scene of two masses with the contact on the second: the spring between them is 36/25. *)
Definition two_masses_held (beta : R) : scene :=
  Scene 2 (entry 1 0 0 1) (entry (16 / 25) (12 / 25) (12 / 25) (9 / 25)) (entry (52 / 25) (- (36 / 25)) (- (36 / 25)) (73 / 25))
    (entry (3 / 5) (4 / 5) (- (4 / 5)) (3 / 5)) (fun i => match i with O => 1 / 2 | _ => 1 end) (fun i => match i with O => 0 | _
      => 1 / 2 end) 1 0 beta.
(* (88), first line, read as (69): below the bound the contact slides, and from it on it is held. Where a damping force reaches
   the contact it need not be. *)
Definition eq_88_without_the_damping_force : Prop := ~ forall s mu X_re X_im p, is_scene s -> contact_inertia_alone s ->
  contact s = S p -> (loaded s < contact s)%nat -> 1 <= mu -> 0 < friction s -> held_motion s X_re X_im ->
  (forall b, (contact s < b)%nat -> X_re b = 0 /\ X_im b = 0) ->
  - stiffness s (contact s) p * sqrt (X_re p ^ 2 + X_im p ^ 2) / mu <= friction s -> rests s mu X_re X_im.

(* What is proved of rounding stands in RoundingStatements.v. *)
