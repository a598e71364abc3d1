(* What is proved of rounding in double precision: the relative error of (23) in the three forms that the library evaluates, and
   what (28) and (29) add to the errors of the exponential, sine and cosine that they are computed from.

   An operation is rounded correctly where its result is the exact one times 1 + e, with |e| at most 2^-53; so it is for
   rounding to nearest with 53 binary digits, as long as nothing overflows or underflows. Doubling is exact. "Units" are 2^-52, the
   spacing of numbers at 1. *)
Require Import Reals.
From Flocq Require Import Core.
From Kernel Require Import Statements.
Open Scope R_scope.

Definition unit_roundoff := / 2 ^ 53.
Definition rounds_correctly (rnd : R -> R) := forall x, exists e, Rabs e <= unit_roundoff /\ rnd x = x * (1 + e).
(* the computed value is off by at most so many units, relative to the exact one *)
Definition off_by (units computed exact : R) := Rabs (computed - exact) <= units * (2 * unit_roundoff) * Rabs exact.

(* Rounding to nearest, ties to even, with 53 digits *)
Definition nearest_rounds_correctly : Prop := rounds_correctly (round radix2 (FLX_exp 53) ZnearestE).

Section Forms.
Variable rnd : R -> R.
(* complex_response_off_resonance, complex_response_near_resonance, complex_response_high_frequency of the library, operation by
  operation *)
Definition computed_a R_i := rnd (rnd (1 - R_i) * rnd (1 + R_i)).
Definition computed_b R_i zeta := rnd (2 * zeta * R_i).
Definition off_resonance_re R_i zeta :=
  let a := computed_a R_i in let b := computed_b R_i zeta in rnd (1 / rnd (a + rnd (b * rnd (b / a)))).
Definition off_resonance_im R_i zeta := - rnd (rnd (rnd (zeta * (2 * R_i)) / computed_a R_i) * off_resonance_re R_i zeta).
Definition near_resonance_quotient R_i zeta := rnd (computed_a R_i / computed_b R_i zeta).
Definition near_resonance_sum R_i zeta := rnd (computed_b R_i zeta + rnd (computed_a R_i * near_resonance_quotient R_i zeta)).
Definition near_resonance_re R_i zeta := rnd (near_resonance_quotient R_i zeta / near_resonance_sum R_i zeta).
Definition near_resonance_im R_i zeta := rnd (- 1 / near_resonance_sum R_i zeta).
Definition high_frequency_A R_i := let p := rnd (1 / R_i) in rnd (rnd (p * p) - 1).
Definition high_frequency_D R_i zeta :=
  let A := high_frequency_A R_i in let B := rnd (2 * zeta * rnd (1 / R_i)) in rnd (rnd (A * A) + rnd (B * B)).
Definition high_frequency_re R_i zeta := rnd (rnd (rnd (high_frequency_A R_i / high_frequency_D R_i zeta) / R_i) / R_i).
Definition high_frequency_im R_i zeta := - rnd (rnd (rnd (rnd (2 * zeta / high_frequency_D R_i zeta) / R_i) / R_i) / R_i).
End Forms.

(* Off resonance, where b <= |a|: the real part, the larger one, is off by at most 4 units, the imaginary part by 7. *)
Definition v_off_resonance : Prop := forall rnd R_i zeta, rounds_correctly rnd -> 0 < R_i < 2 -> R_i <> 1 -> 0 <= zeta ->
  2 * zeta * R_i <= Rabs (1 - R_i * R_i) ->
  off_by 4 (off_resonance_re rnd R_i zeta) (v_re R_i zeta) /\ off_by 7 (off_resonance_im rnd R_i zeta) (v_im R_i zeta).
(* Near resonance, where |a| <= b: the imaginary part, the larger one, is off by at most 4 units, the real part by 7. *)
Definition v_near_resonance : Prop := forall rnd R_i zeta, rounds_correctly rnd -> 0 < R_i < 2 -> 0 < zeta ->
  Rabs (1 - R_i * R_i) <= 2 * zeta * R_i ->
  off_by 4 (near_resonance_im rnd R_i zeta) (v_im R_i zeta) /\ off_by 7 (near_resonance_re rnd R_i zeta) (v_re R_i zeta).
(* At high frequency both parts are off by at most 6 units. *)
Definition v_high_frequency : Prop := forall rnd R_i zeta, rounds_correctly rnd -> 2 <= R_i -> 0 <= zeta ->
  off_by 6 (high_frequency_re rnd R_i zeta) (v_re R_i zeta) /\ off_by 6 (high_frequency_im rnd R_i zeta) (v_im R_i zeta).

(* (28) and (29) from computed values of exp(-delta/2), exp(-delta) - 1, sine and cosine of theta/2, and w:
   damping_functions_half_angle and, for u, damping_functions_small_argument of the library, operation by operation. *)
Section Damping_functions.
Variable rnd : R -> R.
Variables root_E E_minus_one s c w : R.
Definition half_angle_E := rnd (root_E * root_E).
Definition half_angle_denominator := rnd (rnd (E_minus_one * E_minus_one) + rnd (rnd (4 * half_angle_E * c) * c)).
Definition half_angle_u R_i :=
  rnd (rnd (rnd (rnd (rnd (rnd (root_E * s) * c) / half_angle_denominator) * rnd (4 / w)) / R_i) * root_E).
Definition half_angle_g zeta := - rnd (rnd (rnd (E_minus_one * rnd (1 + half_angle_E))
  + rnd (rnd (rnd (4 * half_angle_E * rnd (zeta / w)) * s) * c)) / half_angle_denominator).
Definition small_argument_u R_i sinh_half := rnd (rnd (rnd (rnd (s * c) / rnd (rnd (sinh_half * sinh_half) + rnd (c * c))) / w)
  / R_i).
End Damping_functions.
(* Where these values are off by at most eta units each, u is off by at most 9 eta + 6 units. g is a difference: its error is as
   many units of the sum of the two terms. *)
Definition damping_functions_by_half_angle : Prop := forall rnd eta R_i zeta root_E E_minus_one s c w_, rounds_correctly rnd ->
  0 <= eta <= 2 -> admissible R_i zeta -> let E := exp (- decay R_i zeta) in
  off_by eta root_E (exp (- decay R_i zeta / 2)) -> off_by eta E_minus_one (E - 1) ->
  off_by eta s (sin (theta R_i zeta / 2)) -> off_by eta c (cos (theta R_i zeta / 2)) -> off_by eta w_ (w zeta) ->
  off_by (9 * eta + 6) (half_angle_u rnd root_E E_minus_one s c w_ R_i) (u R_i zeta) /\
  Rabs (half_angle_g rnd root_E E_minus_one s c w_ zeta - g R_i zeta) <= (9 * eta + 6) * (2 * unit_roundoff) *
    (((1 - E) * (1 + E) + 4 * E * (zeta / w zeta) * Rabs (sin (theta R_i zeta / 2) * cos (theta R_i zeta / 2))) /
     ((1 - E) ^ 2 + 4 * E * cos (theta R_i zeta / 2) ^ 2)).
(* At R_i of 5/4 and more the library divides by the square of the hyperbolic sine and of the cosine: 5 eta + 4 units. *)
Definition u_by_small_arguments : Prop := forall rnd eta R_i zeta sinh_half s c w_, rounds_correctly rnd ->
  0 <= eta <= 2 -> admissible R_i zeta -> off_by eta sinh_half (sinh (decay R_i zeta / 2)) ->
  off_by eta s (sin (theta R_i zeta / 2)) -> off_by eta c (cos (theta R_i zeta / 2)) -> off_by eta w_ (w zeta) ->
  off_by (5 * eta + 4) (small_argument_u rnd s c w_ R_i sinh_half) (u R_i zeta).
