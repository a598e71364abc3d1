(* The equations that do not hold as printed, each with its witness; and two steady motions for mu > 1. *)
Require Import Reals List Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes SteadyMode Sums Masses Contact OneVelocity ContactMotion.
Open Scope R_scope.

(* ---- One undamped mode ---- *)
Lemma w_0 : w 0 = 1.
Proof. unfold w. rewrite Rmult_0_l, Rminus_0_r. apply sqrt_1. Qed.
Lemma decay_0 r : decay r 0 = 0.
Proof. unfold decay, Rdiv. ring. Qed.
Lemma theta_0 r : theta r 0 = PI / r.
Proof. unfold theta. rewrite w_0. unfold Rdiv. ring. Qed.
Lemma exp_0_damping r t : exp (- 0 * t / r) = 1.
Proof. replace (- 0 * t / r) with 0 by (unfold Rdiv; ring). apply exp_0. Qed.
Lemma g_0 r : g r 0 = 0.
Proof. unfold g. rewrite decay_0, sinh_0. unfold Rdiv. ring. Qed.
Lemma u_0 r : u r 0 = sin (PI / r) / (r * (1 + cos (PI / r))).
Proof. unfold u. rewrite decay_0, theta_0, w_0, cosh_0, Rmult_1_r. reflexivity. Qed.
Lemma phase_0 r t : w 0 * t / r = t / r.
Proof. rewrite w_0. unfold Rdiv. ring. Qed.
Lemma q_0 r t : q r 0 t = sin (t / r).
Proof. unfold q. rewrite exp_0_damping, phase_0, w_0, Rinv_1. ring. Qed.
Lemma q_prime_0 r t : q_prime r 0 t = / r * cos (t / r).
Proof. unfold q_prime. rewrite exp_0_damping, phase_0. unfold Rdiv. ring. Qed.
Lemma admissible_0 r : 0 < r -> 1 + cos (PI / r) <> 0 -> r <> 1 -> admissible r 0.
Proof.
  intros Hr Hc H1. split; [exact Hr|]. split; [lra|]. split.
  - rewrite decay_0, theta_0, cosh_0. exact Hc.
  - replace ((1 - r * r) ^ 2 + (2 * 0 * r) ^ 2) with ((1 - r * r) * (1 - r * r)) by ring.
    assert (1 - r * r <> 0) by (replace (1 - r * r) with ((1 - r) * (1 + r)) by ring; apply Rmult_integral_contrapositive;
      split; lra).
    apply Rmult_integral_contrapositive; split; assumption.
Qed.
Lemma braces_start r z : 0 < r -> 0 <= z < 1 -> braces r z 0 = - g r z.
Proof. intros Hr Hz. unfold braces. destruct (at_start r z Hr Hz) as [D0 [Q0 _]]. rewrite D0, Q0. ring. Qed.
Lemma printed_start r : 0 < r -> braces_printed r 0 0 = 1.
Proof.
  intros Hr. unfold braces_printed. destruct (at_start r 0 Hr ltac:(lra)) as [_ [Q0 _]].
  rewrite Q0, exp_0_damping, phase_0. replace (0 / r) with 0 by (unfold Rdiv; ring). rewrite sin_0. unfold Rdiv. ring.
Qed.
Lemma cosh_above x : x <> 0 -> 1 < cosh x.
Proof.
  intros H. unfold cosh. pose proof (exp_pos x) as P. pose proof (exp_pos (- x)) as P'.
  assert (E : exp x * exp (- x) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0).
  assert (N : exp x <> exp (- x)) by (intro K; apply exp_inv in K; lra).
  set (a := exp x) in *. set (b := exp (- x)) in *. assert (0 < (a - b) * (a - b)) by (destruct (Rtotal_order a b) as [L|[L|L]];
    [nra | lra | nra]).
  apply Rnot_le_lt. intros L. assert ((a + b) * (a + b) <= 2 * 2) by (apply Rmult_le_compat; lra). nra.
Qed.

(* R = 1/2, R = 2 and R = 2/5, without damping *)
Lemma half : PI / (1 / 2) = 2 * PI. Proof. field. Qed.
Lemma fifths : PI / (2 / 5) = PI / 2 + 2 * PI. Proof. field. Qed.
Lemma admissible_half : admissible (1 / 2) 0.
Proof. apply admissible_0; [lra | rewrite half, cos_2PI; lra | lra]. Qed.
Lemma admissible_2 : admissible 2 0.
Proof. apply admissible_0; [lra | rewrite cos_PI2; lra | lra]. Qed.
Lemma admissible_fifths : admissible (2 / 5) 0.
Proof. apply admissible_0; [lra | rewrite fifths, cos_plus, cos_PI2, sin_2PI; lra | lra]. Qed.
Lemma admissible_resonant z : 0 < z < 1 -> admissible 1 z.
Proof.
  intros Hz. split; [lra|]. split; [lra|]. split.
  - pose proof (COS_bound (theta 1 z)). pose proof PI_RGT_0. assert (Dz : decay 1 z <> 0) by (unfold decay, Rdiv; rewrite
    Rinv_1, Rmult_1_r; apply Rmult_integral_contrapositive; split; lra).
    pose proof (cosh_above (decay 1 z) Dz). lra.
  - assert (0 < z * z) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
Lemma u_half : u (1 / 2) 0 = 0.
Proof. rewrite u_0, half, sin_2PI. unfold Rdiv. ring. Qed.
Lemma u_2 : u 2 0 = 1 / 2.
Proof. rewrite u_0, sin_PI2, cos_PI2. field. Qed.
Lemma u_fifths : u (2 / 5) 0 = 5 / 2.
Proof. rewrite u_0, fifths, sin_plus, cos_plus, sin_PI2, cos_PI2, sin_2PI, cos_2PI. field. Qed.

(* ---- The example scenes ---- *)
Lemma single_values r z b : let s := single_mass r z b in
  V_re s (contact s) = r ^ 2 * v_re r z /\ V_im s (contact s) = r ^ 2 * v_im r z /\ U s (contact s) = r ^ 2 * u r z /\
  G s (contact s) = r ^ 2 * g r z /\ H_j s = g r z + 2 * z * r * u r z /\ mobility s = 1.
Proof. intros s. unfold V_re, V_im, U, G, H_j, mobility, s. simpl. repeat split; ring. Qed.
Lemma single_demand r z b t : demand (single_mass r z b) t = demand_of_mode r z t / sin t.
Proof. unfold demand. simpl. f_equal. ring. Qed.

Lemma single_is_a_scene r z b : admissible r z -> is_scene (single_mass r z b).
Proof.
  intros A. pose proof A as [Hr _]. split; [simpl; lia|]. split; [simpl; lia|]. split; [intros; exact A|].
  split; [|split]; intros i a Hi Ha; simpl in Hi, Ha; assert (i = O) by lia; assert (a = O) by lia; subst; simpl; unfold delta;
    simpl; field; lra.
Qed.

Theorem examples_are_scenes : Statements.examples_are_scenes.
Proof.
  split; [intros r z b A; apply single_is_a_scene, A|]. intros b. split; [simpl; lia|]. split; [simpl; lia|]. split.
  - intros i Hi. simpl in Hi. destruct i as [|i]; [apply admissible_half | apply (admissible_resonant (1 / 2)); lra].
  - split; [|split]; intros i a Hi Ha; simpl in Hi, Ha; (destruct i as [|[|i]]; [| |lia]); (destruct a as [|[|a]]; [| |lia]);
    simpl; unfold delta; simpl; field.
Qed.

(* ---- (40), (41), (46), (49), (A.7) ---- *)
Theorem eq_40_as_printed : Statements.eq_40_as_printed.
Proof.
  intros H. pose proof admissible_half as A. pose proof PI_RGT_0.
  assert (Cy : continuous_on_half_period (eta (1 / 2) 0 1 1 1 0) (eta_prime (1 / 2) 0 1 1 1 0))
    by (intros t _; split; eapply continuous_of_derive; [apply eta_rate | apply eta_prime_rate]; lra).
  assert (Ey : modal_equation (1 / 2) 0 1 1 1 0 (eta (1 / 2) 0 1 1 1 0) (eta_prime (1 / 2) 0 1 1 1 0) (eta_second (1 / 2) 0 1 1
    1 0))
    by (intros t _; split; [apply eta_rate; lra | split; [apply eta_prime_rate; lra | apply eta_equation, A]]).
  pose proof (eta_mirrored (1 / 2) 0 1 1 1 0 A) as Mi.
  pose proof (H _ _ _ _ _ _ _ _ _ A Cy Ey Mi 0 ltac:(lra)) as E. pose proof (eq_40 _ _ _ _ _ _ A _ _ _ Cy Ey Mi 0 ltac:(lra)) as
    E'.
  rewrite printed_start, g_0, cos_0, sin_0 in E by lra. rewrite braces_start, g_0, cos_0, sin_0 in E' by lra. lra.
Qed.

Lemma half_scene b : let s := single_mass (1 / 2) 0 b in responds s /\ friction_motion s 0 0 = 0 /\ friction_motion_printed s 0
  0 = 1 / 4.
Proof.
  intros s. destruct (single_values (1 / 2) 0 b) as [E1 [E2 [E3 _]]]. fold s in E1, E2, E3. split; [split|split].
  - unfold V_abs. rewrite E1, E2. apply sqrt_lt_R0. unfold v_re, v_im. lra.
  - rewrite E3, u_half. replace (friction s * ((1 / 2) ^ 2 * 0)) with 0 by ring. rewrite Rabs_R0. apply sqrt_pos.
  - unfold friction_motion, s. simpl. rewrite braces_start, g_0 by lra. ring.
  - unfold friction_motion_printed, s. simpl. rewrite printed_start by lra. field.
Qed.
Theorem eq_41_as_printed : Statements.eq_41_as_printed.
Proof.
  intros H. destruct (half_scene 1) as [R [F P]]. set (s := single_mass (1 / 2) 0 1) in *. destruct (some_phase s R) as [phi Ph].
  pose proof (single_is_a_scene (1 / 2) 0 1 admissible_half) as S. pose proof PI_RGT_0. assert (K : (0 < masses s)%nat) by
    (simpl; lia).
  pose proof (H s phi 0%nat 0 S R Ph K ltac:(lra)) as E. pose proof (eq_41 s S R phi Ph 0%nat 0 K) as E'. rewrite F in E'.
    rewrite P in E.
  rewrite E in E' at 1. change (friction s) with 1 in *. lra.
Qed.
Theorem eq_46_as_printed : Statements.eq_46_as_printed.
Proof.
  intros H. destruct (half_scene 1) as [R [F P]]. set (s := single_mass (1 / 2) 0 1) in *. destruct (some_phase s R) as [phi Ph].
  pose proof (single_is_a_scene (1 / 2) 0 1 admissible_half) as S. pose proof PI_RGT_0. assert (K : (0 < masses s)%nat) by
    (simpl; lia).
  pose proof (H s phi 0%nat 0 S R Ph K ltac:(lra)) as E. pose proof (eq_46 s S R phi Ph 0%nat 0 K) as E'. cbv zeta in E, E'.
    rewrite F in E'. rewrite P in E.
  rewrite E in E'. change (friction s) with 1 in *. lra.
Qed.
Theorem eq_A_7_as_printed : Statements.eq_A_7_as_printed.
Proof.
  intros H. specialize (H 2 0 0 0 0 0 1 0 PI admissible_2). pose proof (from_start_rate 2 0 0 0 0 0 1 0 PI ltac:(lra)
    ltac:(lra)) as E.
  apply is_derive_unique in H. apply is_derive_unique in E. rewrite H in E. unfold from_start_prime in E. rewrite q_0, sin_PI2
    in E. lra.
Qed.

(* ---- (44), (45), (50), (52): two masses ---- *)
Lemma two_scene b : is_scene (two_masses b).
Proof. apply examples_are_scenes. Qed.
Lemma u_resonant : 0 < u 1 (1 / 2).
Proof.
  assert (Hz : 0 <= 1 / 2 < 1) by lra. pose proof (w_pos (1 / 2) Hz) as P. pose proof (w_sq (1 / 2) Hz) as Q. pose proof PI_RGT_0.
  assert (w (1 / 2) < 1) by nra. destruct (admissible_resonant (1 / 2) ltac:(lra)) as [_ [_ [D _]]]. apply denominator_pos in D;
    [|lra|lra].
  unfold u. apply Rdiv_lt_0_compat.
  - unfold theta. replace (PI * w (1 / 2) / 1) with (PI * w (1 / 2)) by field. apply sin_gt_0; nra.
  - apply Rmult_lt_0_compat; [lra | exact D].
Qed.
Lemma two_values b : let s := two_masses b in
  V_re s 0 = 3 / 25 /\ V_im s 0 = - (16 / 25) /\ V_re s 1 = 4 / 25 /\ V_im s 1 = 12 / 25 /\
  U s 0 = 16 / 25 * u 1 (1 / 2) /\ U s 1 = - (12 / 25 * u 1 (1 / 2)).
Proof.
  assert (A1 : v_re (1 / 2) 0 = 4 / 3) by (unfold v_re; field). assert (A2 : v_im (1 / 2) 0 = 0) by (unfold v_im; field).
  assert (B1 : v_re 1 (1 / 2) = 0) by (unfold v_re; field). assert (B2 : v_im 1 (1 / 2) = - (1)) by (unfold v_im; field).
  intros s. unfold V_re, V_im, U, s. simpl. rewrite A1, A2, B1, B2, u_half. repeat split; field.
Qed.
Lemma two_facts b : let s := two_masses b in
  V_abs s 0 ^ 2 = 265 / 625 /\ V_abs s 1 ^ 2 = 160 / 625 /\ 0 < V_abs s 0 /\ 0 < V_abs s 1 /\ V_abs s 1 < V_abs s 0 /\ 0 < sin
    (V_arg s 1 - V_arg s 0).
Proof.
  intros s. destruct (two_values b) as [E1 [E2 [E3 [E4 _]]]]. fold s in E1, E2, E3, E4.
  pose proof (V_abs_sq s 0) as Q0. pose proof (V_abs_sq s 1) as Q1. rewrite E1, E2 in Q0. rewrite E3, E4 in Q1.
  assert (P0 : 0 < V_abs s 0) by (unfold V_abs; rewrite E1, E2; apply sqrt_lt_R0; lra).
  assert (P1 : 0 < V_abs s 1) by (unfold V_abs; rewrite E3, E4; apply sqrt_lt_R0; lra).
  repeat split; try lra; try nra.
  destruct (argument_all s 0) as [C0 S0]. destruct (argument_all s 1) as [C1 S1].
  rewrite E1 in C0. rewrite E2 in S0. rewrite E3 in C1. rewrite E4 in S1. rewrite sin_minus.
  apply (Rmult_lt_reg_l (V_abs s 0 * V_abs s 1)); [apply Rmult_lt_0_compat; assumption|]. rewrite Rmult_0_r.
  replace (V_abs s 0 * V_abs s 1 * (sin (V_arg s 1) * cos (V_arg s 0) - cos (V_arg s 1) * sin (V_arg s 0)))
    with ((V_abs s 1 * sin (V_arg s 1)) * (V_abs s 0 * cos (V_arg s 0)) - (V_abs s 1 * cos (V_arg s 1)) * (V_abs s 0 * sin
      (V_arg s 0))) by ring.
  rewrite C0, S0, C1, S1. lra.
Qed.

Lemma two_example : exists b phi, let s := two_masses b in is_scene s /\ responds s /\ is_phase s phi /\ 0 < root s /\ 0 <
  friction s /\
  0 < friction s * U s (contact s) /\ U s 1 < 0.
Proof.
  set (V := V_abs (two_masses 0) 0). set (Uj := U (two_masses 0) 0). destruct (two_facts 0) as [_ [_ [HV _]]]. fold V in HV.
  destruct (two_values 0) as [_ [_ [_ [_ [E5 E6]]]]]. fold Uj in E5. pose proof u_resonant as UR. assert (HU : 0 < Uj) by lra.
  set (b := V / (2 * Uj)). assert (Hb : 0 < b) by (apply Rdiv_lt_0_compat; lra). set (s := two_masses b).
  assert (BU : friction s * U s (contact s) = V / 2) by (change (b * Uj = V / 2); unfold b; field; lra).
  assert (R : responds s) by (split; [exact HV | rewrite BU, Rabs_right; [change (V / 2 <= V) | ]; lra]).
  destruct (some_phase s R) as [phi P]. exists b, phi. cbv zeta. fold s.
  split; [apply two_scene|]. split; [exact R|]. split; [exact P|]. split.
  - unfold root. rewrite BU. apply sqrt_lt_R0. change (0 < V ^ 2 - (V / 2) ^ 2). nra.
  - split; [exact Hb|]. split; [rewrite BU; lra|]. destruct (two_values b) as [_ [_ [_ [_ [_ E]]]]]. change (U (two_masses b) 1
    < 0). rewrite E. lra.
Qed.

Theorem eq_44_as_printed : Statements.eq_44_as_printed.
Proof.
  intros H. destruct two_example as [b [phi [S [R [P [Rp [Fp [Bp Un]]]]]]]]. destruct (two_facts b) as [_ [_ [V0 [V1 [VL D]]]]].
    set (s := two_masses b) in *.
  pose proof (H s phi 1%nat S R P ltac:(simpl; lia)) as E. destruct (eq_44_45 s S R phi P 1%nat ltac:(simpl; lia)) as [E' _].
    cbv zeta in E'.
  change (contact s) with 0%nat in *.
  assert (Q : 0 < V_abs s 1 / V_abs s 0 * (friction s * U s 0 * sin (V_arg s 1 - V_arg s 0)))
    by (apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat | apply Rmult_lt_0_compat]; assumption).
  lra.
Qed.
Theorem eq_45_as_printed : Statements.eq_45_as_printed.
Proof.
  intros H. destruct two_example as [b [phi [S [R [P [Rp [Fp [Bp Un]]]]]]]]. destruct (two_facts b) as [_ [_ [V0 [V1 [VL D]]]]].
    set (s := two_masses b) in *.
  pose proof (H s phi 1%nat S R P ltac:(simpl; lia)) as E. destruct (eq_44_45 s S R phi P 1%nat ltac:(simpl; lia)) as [_ E'].
    cbv zeta in E'.
  change (contact s) with 0%nat in *.
  assert (Q : 0 < V_abs s 1 / V_abs s 0 * (root s * sin (V_arg s 1 - V_arg s 0)))
    by (apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat | apply Rmult_lt_0_compat]; assumption).
  lra.
Qed.
Theorem eq_49_as_printed : Statements.eq_49_as_printed.
Proof.
  intros H. destruct two_example as [b [phi [S [R [P [Rp [Fp [Bp Un]]]]]]]]. destruct (two_facts b) as [_ [_ [V0 [V1 [VL D]]]]].
    set (s := two_masses b) in *.
  pose proof (H s phi 1%nat 0 S R P ltac:(simpl; lia)) as E. cbv zeta in E. rewrite cos_0, sin_0 in E.
  change (contact s) with 0%nat in *.
  assert (Q : 0 < V_abs s 1 / V_abs s 0 * (friction s * U s 0 * sin (V_arg s 1 - V_arg s 0)))
    by (apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat | apply Rmult_lt_0_compat]; assumption).
  lra.
Qed.
Theorem eq_50_as_printed : Statements.eq_50_as_printed.
Proof.
  intros H. destruct two_example as [b [phi [S [R [P [Rp [Fp [Bp Un]]]]]]]]. destruct (two_facts b) as [_ [_ [V0 [V1 [VL D]]]]].
    set (s := two_masses b) in *.
  pose proof (H s phi 1%nat S R P ltac:(simpl; lia)) as E. destruct (eq_44_45 s S R phi P 1%nat ltac:(simpl; lia)) as [E' _].
    cbv zeta in E, E'.
  change (contact s) with 0%nat in *.
  assert (L : V_abs s 1 / V_abs s 0 < 1) by (apply (Rmult_lt_reg_r (V_abs s 0)); [exact V0 | unfold Rdiv; rewrite Rmult_assoc,
    Rinv_l; lra]).
  assert (Q : 0 < (1 - V_abs s 1 / V_abs s 0) * (friction s * U s 0 * sin (V_arg s 1 - V_arg s 0)))
    by (apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; assumption]).
  lra.
Qed.
Theorem eq_52_as_printed : Statements.eq_52_as_printed.
Proof.
  intros H. destruct two_example as [b [phi [S [R [P [Rp [Fp [Bp Un]]]]]]]]. destruct (two_facts b) as [_ [_ [V0 [V1 [VL D]]]]].
    set (s := two_masses b) in *.
  pose proof (H s 1%nat S R ltac:(simpl; lia)) as E. cbv zeta in E. pose proof (X_kC_kS s 1 R) as K. change (contact s) with
    0%nat in *.
  assert (Q : 0 < friction s * (V_abs s 1 / V_abs s 0) * (root s * (- U s 1) * sin (V_arg s 1 - V_arg s 0))).
  { apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; [exact Fp | apply Rdiv_lt_0_compat; assumption]|].
    apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; lra | exact D]. }
  apply Rlt_not_eq in E; [exact E|]. apply sqrt_lt_1_alt. split; [nra|]. rewrite K. lra.
Qed.

(* ---- (57), (68), (69): one mass without damping ---- *)
Lemma scene_2 : let s := single_mass 2 0 (5 / 8) in is_scene s /\ responds s /\ root s ^ 2 = 31 / 144 /\ H_j s = 0 /\ mobility s
  = 1 /\
  V_abs s (contact s) ^ 2 = 16 / 9 /\ U s (contact s) = 2 /\ 0 < V_abs s (contact s).
Proof.
  intros s. destruct (single_values 2 0 (5 / 8)) as [E1 [E2 [E3 [_ [E5 E6]]]]]. fold s in E1, E2, E3, E5, E6. rewrite u_2 in E3.
    rewrite g_0, u_2 in E5.
  assert (V : V_abs s (contact s) ^ 2 = 16 / 9) by (rewrite V_abs_sq, E1, E2; unfold v_re, v_im; field).
  assert (P : 0 < V_abs s (contact s)) by (unfold V_abs; rewrite E1, E2; apply sqrt_lt_R0; unfold v_re, v_im; lra).
  assert (Us : U s (contact s) = 2) by (rewrite E3; field).
  assert (R : responds s).
  { split; [exact P|]. rewrite Us. change (Rabs (5 / 8 * 2) <= V_abs s (contact s)). rewrite Rabs_right by lra. nra. }
  split; [apply single_is_a_scene, admissible_2|]. split; [exact R|]. split.
  - rewrite root_sq, V, Us by exact R. change (friction s) with (5 / 8). field.
  - repeat split; try assumption; [rewrite E5; ring].
Qed.
Lemma scene_2_sticks phi : let s := single_mass 2 0 (5 / 8) in is_phase s phi -> ~ slides s phi.
Proof.
  intros s P SL. destruct scene_2 as [S [R [RS [Hh [Mo _]]]]]. fold s in S, R, RS, Hh, Mo. pose proof (sliding_start s S phi P
    SL) as L.
  rewrite Hh, Mo in L. change (friction s) with (5 / 8) in L. nra.
Qed.
Theorem eq_57_as_printed : Statements.eq_57_as_printed.
Proof.
  intros H. destruct scene_2 as [S [R [RS _]]]. set (s := single_mass 2 0 (5 / 8)) in *. destruct (some_phase s R) as [phi P].
  apply (scene_2_sticks phi P). apply (H s (fun _ => 0) phi S); [simpl; lra | exact R | exact P | |].
  - intros i t _ Ht. simpl. unfold demand_printed. rewrite g_0, u_2, exp_0_damping, phase_0, w_0.
    apply Req_le. unfold Rdiv. rewrite Rinv_1. replace (_ - _) with 0 by field. ring.
  - rewrite root_of_sum. pose proof (root_pos s). assert (root s <> 0) by (intro Z; rewrite Z in RS; lra). simpl. lra.
Qed.
Theorem eq_68_as_printed : Statements.eq_68_as_printed.
Proof.
  intros H. destruct scene_2 as [S [R [RS [Hh [Mo [V [Us VP]]]]]]]. set (s := single_mass 2 0 (5 / 8)) in *. destruct
    (some_phase s R) as [phi P].
  pose proof (root_pos s) as RP. specialize (H s 1 phi S ltac:(simpl; lra) ltac:(lra) R P). rewrite root_of_sum, Hh, Mo, V, Us
    in H.
  change (friction s) with (5 / 8) in H. assert (L : 1 * (5 / 8) < Rabs (root s - 5 / 8 * 0) / 1).
  { apply H. apply above_sqrt; lra. }
  rewrite Rabs_right in L by lra. nra.
Qed.

Lemma cos_above x : 0 <= x -> 1 - x * x / 2 <= cos x.
Proof.
  intros H. assert (E : cos x = 1 - 2 * sin (x / 2) * sin (x / 2)) by (rewrite <- cos_2a_sin; f_equal; field). rewrite E.
    destruct (Req_dec x 0) as [->|N].
  - replace (0 / 2) with 0 by field. rewrite sin_0. lra.
  - pose proof (sin_lt_x (x / 2) ltac:(lra)). pose proof (sin_above (x / 2) ltac:(lra)). nra.
Qed.
Lemma sin_above_cubic x : 0 <= x -> x - x ^ 3 / 6 <= sin x.
Proof.
  intros H. assert (L : (fun t => t - t ^ 3 / 6 - sin t) x <= (fun t => t - t ^ 3 / 6 - sin t) 0); [|cbv beta in L; rewrite
    sin_0 in L; lra].
  apply (not_growing nil (fun t => t - t ^ 3 / 6 - sin t) 0 x); [exact H | |].
  - intros t _. apply (ex_derive_continuous (K := R_AbsRing) (V := R_NormedModule)). auto_derive. trivial.
  - intros t Ht _. exists (1 - t * t / 2 - cos t). split; [auto_derive; [trivial | field]|]. pose proof (cos_above t
    ltac:(lra)). lra.
Qed.
Lemma sixteen_tenths : PI < 3.2.
Proof.
  (* sin (PI / 6) = 1 / 2 *)
  apply Rnot_le_lt. intros L. pose proof PI_4. pose proof (sin_above_cubic (16 / 30) ltac:(lra)) as B.
  pose proof (sin_incr_1 (16 / 30) (PI / 6) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as I. rewrite sin_PI6 in I.
    lra.
Qed.
Lemma scene_fifths : let s := single_mass (2 / 5) 0 (4 / 25) in is_scene s /\ responds s /\ root s ^ 2 = 16 / 441 - 16 * 16 /
  (250 * 250) /\ H_j s = 0 /\ mobility s = 1 /\
  V_abs s (contact s) ^ 2 = 16 / 441 /\ U s (contact s) = 2 / 5.
Proof.
  intros s. destruct (single_values (2 / 5) 0 (4 / 25)) as [E1 [E2 [E3 [_ [E5 E6]]]]]. fold s in E1, E2, E3, E5, E6. rewrite
    u_fifths in E3. rewrite g_0, u_fifths in E5.
  assert (V : V_abs s (contact s) ^ 2 = 16 / 441) by (rewrite V_abs_sq, E1, E2; unfold v_re, v_im; field).
  assert (P : 0 < V_abs s (contact s)) by (unfold V_abs; rewrite E1, E2; apply sqrt_lt_R0; unfold v_re, v_im; lra).
  assert (Us : U s (contact s) = 2 / 5) by (rewrite E3; field).
  assert (R : responds s).
  { split; [exact P|]. rewrite Us. change (Rabs (4 / 25 * (2 / 5)) <= V_abs s (contact s)). rewrite Rabs_right by lra. nra. }
  split; [apply single_is_a_scene, admissible_fifths|]. split; [exact R|]. split.
  - rewrite root_sq, V, Us by exact R. change (friction s) with (4 / 25). field.
  - repeat split; try assumption; [rewrite E5; ring].
Qed.
Theorem eq_69_as_printed : Statements.eq_69_as_printed.
Proof.
  intros H. destruct scene_fifths as [S [R [RS [Hh [Mo [V Us]]]]]]. set (s := single_mass (2 / 5) 0 (4 / 25)) in *. destruct
    (some_phase s R) as [phi P].
  pose proof PI_RGT_0 as Pp. pose proof sixteen_tenths as Pu. pose proof (root_pos s) as RP.
  assert (SL : slides s phi).
  { apply (H s (fun _ => 0) 1 phi S); [simpl; lra | lra | exact R | exact P | |].
    - intros i t _ Ht. simpl. unfold demand_printed. rewrite g_0, u_fifths, exp_0_damping, phase_0, w_0.
      apply Req_le. unfold Rdiv. rewrite Rinv_1. replace (_ - _) with 0 by field. ring.
    - rewrite Hh, Mo, V, Us. simpl. rewrite Rmax_right by lra. apply below_sqrt; [lra | lra |]. lra. }
  apply (slides_iff_ s S phi P) with (t := PI / 5) in SL; [|lra]. unfold s in SL at 2. rewrite single_demand in SL. change
    (friction s) with (4 / 25) in SL.
  unfold demand_of_mode in SL. rewrite g_0, u_fifths, q_0, q_prime_0 in SL. replace (PI / 5 / (2 / 5)) with (PI / 2) in SL by
    field.
  rewrite sin_PI2, cos_PI2 in SL. pose proof (cos_above (PI / 5) ltac:(lra)) as C. pose proof (sin_lt_x (PI / 5) ltac:(lra)) as
    Sx. pose proof (sin_gt_0 (PI / 5) ltac:(lra) ltac:(lra)) as Sp.
  assert (X2 : PI / 5 * (PI / 5) <= 64 / 100 * (64 / 100)) by (apply Rmult_le_compat; lra).
  assert (D : 11215 / 10000 <= ((1 + 0) * (2 / 5) * 1 - 5 / 2 * (2 / 5) ^ 2 * (2 / 5 * (/ (2 / 5) * 0) - cos (PI / 5))) / sin
    (PI / 5)).
  { apply (Rmult_le_reg_r (sin (PI / 5))); [exact Sp|]. match goal with |- _ <= ?n / ?m * _ => replace (n / m * m) with n by
    (field; lra) end. lra. }
  assert (L : 4 / 25 * (11215 / 10000) < root s) by lra.
  assert (4 / 25 * (11215 / 10000) * (4 / 25 * (11215 / 10000)) < root s * root s) by (apply Rmult_le_0_lt_compat; lra). lra.
Qed.

(* ---- (59), (63), (81), (88) ---- *)
Theorem eq_63_is_eq_59 : Statements.eq_63_is_eq_59.
Proof.
  intros r z pj pl b f y y1 y2 A Hl Cy Ey M. rewrite (eq_62 r z pj pl b f y y1 y2 A Hl Cy Ey M). destruct A as [Hr _]. field. lra.
Qed.
Theorem eq_81 : Statements.eq_81.
Proof. intros Vk Vj Gk Uk Uj b sg HV _. field. lra. Qed.
Theorem eq_81_as_printed : Statements.eq_81_as_printed.
Proof.
  intros H. specialize (H 1 1 1 1 1 1 1 ltac:(lra) ltac:(lra) ltac:(lra) (or_introl eq_refl)). rewrite !Rabs_R1 in H. specialize
    (H ltac:(lra)). lra.
Qed.
Theorem eq_88_third_line : Statements.eq_88_third_line.
Proof.
  intros mu b Hm. assert (E : 1 / mu * mu = 1) by (field; lra). split; intros H.
  - specialize (H 0). rewrite cos_0, Rabs_R1 in H. apply (Rmult_le_reg_r mu); [exact Hm | lra].
  - intros t. pose proof (COS_bound t). assert (1 <= mu * b) by (apply (Rmult_le_compat_r mu) in H; lra). unfold Rabs. destruct
    (Rcase_abs (cos t)); lra.
Qed.
(* With little friction a scene slides and breaks away. *)
Lemma little_friction (f : R -> scene) V m : (forall b, is_scene (f b)) -> (forall b, friction (f b) = b) ->
  (forall b, V_abs (f b) (contact (f b)) = V) -> (forall b, U (f b) (contact (f b)) = U (f 0) (contact (f 0))) -> (forall b, H_j
    (f b) = H_j (f 0)) ->
  (forall b, mobility (f b) = 1) -> (forall b t, demand (f b) t = demand (f 0) t) -> 0 < m -> 2 * m <= V ->
  exists b, 0 < b <= m /\ responds (f b) /\ forall phi, is_phase (f b) phi -> slides (f b) phi /\ V - m < holding_friction (f b)
    phi.
Proof.
  intros Sc Fr HV HU HH HM HD Hm HmV. destruct (largest_demand (f 0) (Sc 0)) as [B [HB _]].
  set (Uj := U (f 0) (contact (f 0))) in *. set (H := H_j (f 0)) in *. pose proof (Rabs_pos Uj) as U0. pose proof (Rabs_pos H)
    as H0. pose proof (Rabs_pos B) as B0.
  set (E := 1 + Rabs Uj + Rabs H + Rabs B). assert (HE : 1 <= E) by (unfold E; lra). set (b := m / E).
  assert (BE : b * E = m) by (unfold b; field; lra). assert (Hb : 0 < b) by (apply Rdiv_lt_0_compat; lra).
  assert (SM : b + b * Rabs Uj + b * Rabs H + b * Rabs B = m) by (rewrite <- BE; unfold E; ring).
  assert (P1 : 0 <= b * Rabs Uj) by nra. assert (P2 : 0 <= b * Rabs H) by nra. assert (P3 : 0 <= b * Rabs B) by nra.
  exists b. split; [lra|].
  assert (AU : Rabs (friction (f b) * U (f b) (contact (f b))) = b * Rabs Uj) by (rewrite Fr, HU, Rabs_mult, (Rabs_right b) by
    lra; reflexivity).
  assert (R : responds (f b)) by (split; rewrite ?AU, HV; lra). split; [exact R|].
  assert (Rt : V - b * Rabs Uj <= root (f b)).
  { pose proof (root_sq (f b) R) as RS. pose proof (root_pos (f b)). rewrite HV, <- (pow2_abs (friction (f b) * U (f b) (contact
    (f b)))), AU in RS. apply Rnot_lt_le. intros L.
    assert (root (f b) * root (f b) < (V - b * Rabs Uj) * (V - b * Rabs Uj)) by (apply Rmult_le_0_lt_compat; lra).
    assert (0 <= b * Rabs Uj * (V - b * Rabs Uj)) by (apply Rmult_le_pos; lra). nra. }
  intros phi P. split.
  - apply (slides_iff_ (f b) (Sc b) phi P). intros t Ht. rewrite Fr, HD. specialize (HB t Ht). pose proof (Rle_abs B).
    assert (b * demand (f 0) t <= b * Rabs B) by (apply Rmult_le_compat_l; lra). lra.
  - rewrite (holding_ (f b) (Sc b) phi P), Fr, HH, HM. fold H. pose proof (Rle_abs H).
    assert (b * H <= b * Rabs H) by (apply Rmult_le_compat_l; lra). unfold Rdiv. rewrite Rinv_1. lra.
Qed.

Theorem eq_59_63_as_printed : Statements.eq_59_63_as_printed.
Proof.
  intros H. set (V := V_abs (two_masses 0) 0). destruct (two_facts 0) as [VS [_ [VP _]]]. fold V in VS, VP. assert (VL : 13 / 20
    <= V) by nra.
  destruct (little_friction two_masses V (1 / 4)) as [b [Hb [R Q]]]; try reflexivity; try (intros; apply two_scene); try lra.
  { intros b. unfold mobility. simpl. field. }
  set (s := two_masses b) in *. destruct (some_phase s R) as [phi P]. destruct (Q phi P) as [SL HF].
  assert (Al : contact_inertia_alone s) by (intros a Ha Na; simpl in Ha, Na; assert (a = 1%nat) by lia; subst; reflexivity).
  set (mu := 1 / 3 / b). assert (MB : mu * b = 1 / 3) by (unfold mu; field; lra). assert (Mu : 1 <= mu) by nra.
  specialize (H s mu phi (two_scene b) Al ltac:(simpl; lra) Mu R P SL). rewrite <- holding_is_load in H by (assumption || apply
    two_scene).
  change (friction s) with b in H. rewrite MB in H. specialize (H ltac:(rewrite Rabs_right; lra) 0%nat ltac:(simpl; lia)). simpl
    in H.
  replace (2 * 0 / (1 / 2) * eta_prime (1 / 2) 0 (3 / 5) (3 / 5) b phi 0 + / (1 / 2 * (1 / 2 * 1)) * eta (1 / 2) 0 (3 / 5) (3 /
    5) b phi 0 - 3 / 5 * cos phi)
    with (1 / 5 * cos phi) in H.
  - pose proof (COS_bound phi). replace (3 / 5 * mu * b) with (1 / 5) in H by (rewrite Rmult_assoc, MB; field).
    rewrite Rabs_mult, (Rabs_right (1 / 5)) in H by lra. assert (Rabs (cos phi) <= 1) by (unfold Rabs; destruct (Rcase_abs (cos
      phi)); lra). lra.
  - unfold eta. rewrite braces_start, g_0 by lra. unfold v_cos. rewrite Rplus_0_l.
    assert (A1 : v_re (1 / 2) 0 = 4 / 3) by (unfold v_re; field). assert (A2 : v_im (1 / 2) 0 = 0) by (unfold v_im; field).
      rewrite A1, A2. field.
Qed.

(* ---- mu > 1 ---- *)
Theorem two_motions : Statements.two_motions.
Proof.
  assert (A : admissible 1 (1 / 4)) by (apply admissible_resonant; lra).
  assert (HV : forall b, V_abs (single_mass 1 (1 / 4) b) (contact (single_mass 1 (1 / 4) b)) = 2).
  { intros b. destruct (single_values 1 (1 / 4) b) as [E1 [E2 _]]. unfold V_abs. rewrite E1, E2. apply sqrt_of_square; [lra|].
    unfold v_re, v_im. field. }
  destruct (little_friction (single_mass 1 (1 / 4)) 2 (1 / 2)) as [b [Hb [R Q]]]; try reflexivity; try exact HV; try lra.
  { intros b. apply single_is_a_scene, A. }
  { intros b. apply (single_values 1 (1 / 4) b). }
  set (s := single_mass 1 (1 / 4) b) in *. destruct (some_phase s R) as [phi P]. destruct (Q phi P) as [SL HF].
  pose proof (single_is_a_scene 1 (1 / 4) b A) as S. fold s in S.
  assert (Al : contact_inertia_alone s) by (intros a Ha Na; simpl in Ha, Na; lia).
  set (mu := 5 / 4 / b). assert (MB : mu * b = 5 / 4) by (unfold mu; field; lra). assert (Mu : 1 < mu) by nra.
  exists s, mu, phi, (continued (x s phi)), (continued (x_prime s phi)), (fun _ _ => 0), (fun _ _ => 0).
  split; [exact S|]. split; [intros; simpl; lra|]. split; [simpl; lra|]. split; [exact Mu|].
  assert (HB : mu * friction s < Rabs (holding_friction s phi)) by (change (friction s) with b; rewrite MB, Rabs_right; lra).
  split; [apply closed_form_is_a_contact_motion; try assumption; lra|]. split; [|split; [|split; [|split]]].
  - split; [|intros; split; reflexivity]. split; [intros; split; apply continuous_const|]. split; [|intros t Ht _ _; exists (2 *
    PI);
      split; [lra | reflexivity]]. exists nil. intros t _ _.
    exists (fun _ => 0), (cos (t + phi) / b). split.
    + split; [intros; lra|]. split; [intros; lra|]. intros _. pose proof (COS_bound (t + phi)).
      assert (E : cos (t + phi) / b * b = cos (t + phi)) by (field; lra). split; apply (Rmult_le_reg_r b); lra.
    + intros a Ha. simpl in Ha. assert (a = 0%nat) by lia. subst. simpl. unfold delta. simpl.
      split; [apply (is_derive_const (K := R_AbsRing) (V := R_NormedModule))|]. split; [apply (is_derive_const (K := R_AbsRing)
        (V := R_NormedModule))|]. field; lra.
  - intros t Ht. unfold continued. destruct (Rle_dec t PI); [apply SL, Ht | lra].
  - rewrite <- holding_is_load by assumption. exact HB.
  - reflexivity.
  - reflexivity.
Qed.
