(* What is proved of rounding: the relative error of (23) in double precision, in the three forms that the library evaluates.

   An operation is rounded correctly where its result is the exact one times 1 + e, with |e| at most 2^-53; so it is for
     rounding to nearest
   with 53 binary digits, as long as nothing overflows or underflows. Doubling is exact. "Units" are 2^-52, the spacing of
     numbers at 1. *)
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
