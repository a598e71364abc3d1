(* Forces on every mass, each with a phase of its own: the closed form and its domain. *)
Require Import Reals List Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes SteadyMode Sums Masses Contact OneVelocity ContactMotion.
Open Scope R_scope.

Section Out_of_phase.
Variable s : scene.
Variables p q : nat -> R.
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
Local Notation load_on_mode := (load_on_mode s).
Local Notation V_re_under := (V_re_under s p q).
Local Notation V_im_under := (V_im_under s p q).
Local Notation V_abs_under := (V_abs_under s p q).
Local Notation root_under := (root_under s p q).
Local Notation X_j_under := (X_j_under s p q).
Local Notation responds_under := (responds_under s p q).
Local Notation is_phase_under := (is_phase_under s p q).
Local Notation friction_velocity := (friction_velocity s).
Local Notation x_prime_under := (x_prime_under s p q).
Local Notation x_under := (x_under s p q).
Local Notation forces_at := (forces_at p q).
Local Notation half_period_motion_under := (half_period_motion_under s p q).
Local Notation steady_half_period_under := (steady_half_period_under s p q).
Local Notation slides_under := (slides_under s p q).
Local Notation holding_friction_under := (holding_friction_under s p q).
Hypothesis Hs : is_scene s.

(* What the forces add to the paper's: a harmonic motion *)
Let Z_re k := V_re_under k - V_re s k.
Let Z_im k := V_im_under k - V_im s k.
Let z phi k t := Z_re k * cos (t + phi) - Z_im k * sin (t + phi).
Let z1 phi k t := - (Z_re k * sin (t + phi) + Z_im k * cos (t + phi)).
Let z2 phi k t := - z phi k t.

Lemma z_rates phi k t : is_derive (z phi k) t (z1 phi k t) /\ is_derive (z1 phi k) t (z2 phi k t).
Proof. unfold z, z1, z2, z. split; auto_derive; trivial; ring. Qed.
Lemma z_mirrored phi k : mirrored (z phi k) (z1 phi k).
Proof. unfold mirrored, z, z1. rewrite cos_shift_pi, sin_shift_pi, !Rplus_0_l. split; ring. Qed.

Lemma on_modes f a : (a < N)%nat -> Sum N (fun i => MP s a i * load_on_mode f i) = f a.
Proof.
  intros Ha. unfold Statements.load_on_mode. rewrite (Sum_ext N _ (fun i => Sum N (fun b => MP s a i * psi b i * f b)))
    by (intros; rewrite <- Sum_scal; apply Sum_ext; intros; ring).
  rewrite Sum_swap. rewrite (Sum_ext N _ (fun b => delta b a * f b)); [apply Sum_delta, Ha|].
  intros b Hb. rewrite Sum_scal_r, (complete_1 s Hs a b Ha Hb), delta_sym. reflexivity.
Qed.

Lemma z_row phi a t : (a < N)%nat ->
  Sum N (fun b => M a b * z2 phi b t + C a b * z1 phi b t + K a b * z phi b t) = forces_at phi t a - delta a l * cos (t + phi).
Proof.
  intros Ha.
  set (f0 := fun i => R_ i ^ 2 * ((load_on_mode p i - psi l i) * v_cos (R_ i) (zeta i) phi t - load_on_mode q i * v_sin (R_
    i) (zeta i) phi t)).
  set (f1 := fun i => - (R_ i ^ 2 * ((load_on_mode p i - psi l i) * v_sin (R_ i) (zeta i) phi t + load_on_mode q i * v_cos
    (R_ i) (zeta i) phi t))).
  assert (E0 : forall b, z phi b t = Sum N (fun i => psi b i * f0 i)).
  { intros b. unfold z, Z_re, Z_im, Statements.V_re_under, Statements.V_im_under, V_re, V_im, f0, v_cos, v_sin.
    rewrite <- !Sum_minus, <- !Sum_scal_r, <- Sum_minus. apply Sum_ext. intros; ring. }
  assert (E1 : forall b, z1 phi b t = Sum N (fun i => psi b i * f1 i)).
  { intros b. unfold z1, Z_re, Z_im, Statements.V_re_under, Statements.V_im_under, V_re, V_im, f1, v_cos, v_sin.
    rewrite <- !Sum_minus, <- !Sum_scal_r, <- Sum_plus, <- Sum_opp. apply Sum_ext. intros; ring. }
  rewrite (Sum_ext N _ (fun b => M a b * Sum N (fun i => psi b i * - f0 i) + C a b * Sum N (fun i => psi b i * f1 i)
    + K a b * Sum N (fun i => psi b i * f0 i))).
  2: { intros b _. unfold z2. rewrite <- E0, <- E1. rewrite (Sum_ext N (fun i => psi b i * - f0 i) (fun i => - (psi b i * f0
    i)))
    by (intros; ring). rewrite Sum_opp, <- E0. reflexivity. }
  rewrite (row s Hs a) by exact Ha.
  rewrite (Sum_ext N _ (fun i => MP s a i * load_on_mode p i * cos (t + phi) - MP s a i * load_on_mode q i * sin (t + phi)
    - MP s a i * psi l i * cos (t + phi))).
  - rewrite !Sum_minus, !Sum_scal_r, !on_modes by exact Ha. rewrite (complete_1 s Hs a l Ha (Hl s Hs)). unfold
    Statements.forces_at. ring.
  - intros i Hi. pose proof (Hadm s Hs i Hi) as [Hr [_ [_ Hv]]]. destruct (eq_23 (R_ i) (zeta i) Hv) as [A B].
    unfold f0, f1, v_cos, v_sin. set (vr := v_re (R_ i) (zeta i)) in *. set (vi := v_im (R_ i) (zeta i)) in *.
    set (c := cos (t + phi)). set (d := sin (t + phi)). set (Pi := load_on_mode p i). set (Qi := load_on_mode q i).
    transitivity (MP s a i * ((Pi - psi l i) * (c * ((1 - R_ i * R_ i) * vr - 2 * zeta i * R_ i * vi)
      - d * ((1 - R_ i * R_ i) * vi + 2 * zeta i * R_ i * vr))
      - Qi * (d * ((1 - R_ i * R_ i) * vr - 2 * zeta i * R_ i * vi) + c * ((1 - R_ i * R_ i) * vi + 2 * zeta i * R_ i * vr)))).
    + field. lra.
    + rewrite A, B. ring.
Qed.

Lemma x_under_is phi k t : x_under phi k t = x s phi k t + z phi k t.
Proof. rewrite x_form. unfold Statements.x_under, z, Z_re, Z_im. ring. Qed.
Lemma x_prime_under_is phi k t : x_prime_under phi k t = x_prime s phi k t + z1 phi k t.
Proof.
  unfold Statements.x_prime_under, z1, Z_re, Z_im, Statements.friction_velocity. pose proof (superposition_sin s k phi t) as E.
  assert (X : x_prime s phi k t = - (V_re s k * sin (t + phi) + V_im s k * cos (t + phi)) + beta *
    Sum N (fun i => psi k i * psi j i * R_ i ^ 2 * braces_prime (R_ i) (zeta i) t)); [|rewrite X; ring].
  rewrite <- E. unfold x_prime. rewrite <- Sum_scal, <- Sum_opp, <- Sum_plus. apply Sum_ext. intros; unfold eta_prime. ring.
Qed.
Let x2_under phi k t := x_second s phi k t + z2 phi k t.

Lemma derive_sum (f h : R -> R) t a b : is_derive f t a -> is_derive h t b -> is_derive (fun t => f t + h t) t (a + b).
Proof. intros A B. apply (is_derive_plus (V := R_NormedModule) f h t a b A B). Qed.
Lemma x_under_derive phi k t : is_derive (x_under phi k) t (x_prime_under phi k t) /\ is_derive (x_prime_under phi k) t
  (x2_under phi k t).
Proof.
  destruct (z_rates phi k t) as [A B]. split.
  - rewrite x_prime_under_is. apply (is_derive_ext (fun t => x s phi k t + z phi k t)); [intros; symmetry; apply x_under_is|].
    apply derive_sum; [apply x_derive, Hs | exact A].
  - apply (is_derive_ext (fun t => x_prime s phi k t + z1 phi k t)); [intros; symmetry; apply x_prime_under_is|].
    apply derive_sum; [apply x_prime_derive, Hs | exact B].
Qed.
Lemma rows_add (Y2 Y1 Y0 W2 W1 W0 : nat -> R) a :
  Sum N (fun b => M a b * (Y2 b + W2 b) + C a b * (Y1 b + W1 b) + K a b * (Y0 b + W0 b)) =
  Sum N (fun b => M a b * Y2 b + C a b * Y1 b + K a b * Y0 b) + Sum N (fun b => M a b * W2 b + C a b * W1 b + K a b * W0 b).
Proof. rewrite <- Sum_plus. apply Sum_ext. intros; ring. Qed.
Lemma x_under_equation phi a t : (a < N)%nat ->
  Sum N (fun b => M a b * x2_under phi b t + C a b * x_prime_under phi b t + K a b * x_under phi b t) = delta a j * beta +
    forces_at phi t a.
Proof.
  intros Ha. rewrite (Sum_ext N _ (fun b => M a b * (x_second s phi b t + z2 phi b t) + C a b * (x_prime s phi b t + z1 phi b t)
    + K a b * (x s phi b t + z phi b t))) by (intros; rewrite x_under_is, x_prime_under_is; reflexivity).
  rewrite (rows_add (fun b => x_second s phi b t) (fun b => x_prime s phi b t) (fun b => x s phi b t)
    (fun b => z2 phi b t) (fun b => z1 phi b t) (fun b => z phi b t)), (x_equation s Hs phi a t Ha), z_row by exact Ha. ring.
Qed.
Lemma x_under_mirrored phi k : mirrored (x_under phi k) (x_prime_under phi k).
Proof.
  destruct (x_mirrored s Hs phi k) as [A B], (z_mirrored phi k) as [A' B']. unfold mirrored.
  rewrite !x_under_is, !x_prime_under_is, A, B, A', B'. split; ring.
Qed.
Lemma x_under_initial phi k : (k < N)%nat ->
  V_re_under k * cos phi - V_im_under k * sin phi = x_under phi k 0 + beta * G s k /\
  V_re_under k * sin phi + V_im_under k * cos phi = - (x_prime_under phi k 0 + beta * U s k).
Proof.
  intros Hk. destruct (x_initial s Hs phi k Hk) as [A B]. rewrite x_under_is, x_prime_under_is. unfold z, z1, Z_re, Z_im.
    rewrite Rplus_0_l.
  split; lra.
Qed.

Lemma V_abs_under_sq k : V_abs_under k ^ 2 = V_re_under k ^ 2 + V_im_under k ^ 2.
Proof. unfold Statements.V_abs_under. rewrite <- Rsqr_pow2, Rsqr_sqrt; [reflexivity | nra]. Qed.
Lemma root_under_sq : responds_under -> root_under ^ 2 = V_abs_under j ^ 2 - (beta * U s j) ^ 2.
Proof.
  intros [HV HU]. unfold Statements.root_under. rewrite <- (Rsqr_pow2 (sqrt _)), Rsqr_sqrt; [reflexivity|].
  pose proof (Rabs_pos (beta * U s j)). rewrite <- (pow2_abs (beta * U s j)). nra.
Qed.

Lemma steady_ phi : responds_under -> is_phase_under phi -> exists x2,
  steady_half_period_under phi (x_under phi) (x_prime_under phi) x2 /\ x_under phi j 0 = X_j_under.
Proof.
  intros H [P1 P2]. exists (x2_under phi). destruct (x_under_initial phi j (Hj s Hs)) as [E1 E2]. split; [split; [|split;
    [|split]]|].
  - intros a _ t _. destruct (x_under_derive phi a t) as [A B]. split; eapply continuous_of_derive; [exact A | exact B].
  - intros t _ a Ha. destruct (x_under_derive phi a t) as [A B]. split; [exact A | split; [exact B | apply x_under_equation,
    Ha]].
  - intros k _. apply x_under_mirrored.
  - lra.
  - unfold Statements.X_j_under. lra.
Qed.

Lemma unique_under phi y y1 y2 : (forall a, (a < N)%nat -> continuous_on_half_period (y a) (y1 a)) ->
  half_period_motion_under phi y y1 y2 ->
  (forall k, (k < N)%nat -> mirrored (y k) (y1 k)) ->
  forall k t, (k < N)%nat -> 0 <= t <= PI -> y k t = x_under phi k t /\ y1 k t = x_prime_under phi k t.
Proof.
  intros Cy H Mi k t Hk Ht.
  destruct (unique s Hs phi (fun a t => y a t + - z phi a t) (fun a t => y1 a t + - z1 phi a t) (fun a t => y2 a t + - z2 phi
    a t))
    with (k := k) (t := t) as [E1 E2]; try assumption.
  - intros a Ha x Hx. destruct (Cy a Ha x Hx) as [A B], (z_rates phi a x) as [A' B'].
    split; apply (continuous_plus (V := R_NormedModule)); try assumption; apply (continuous_opp (V := R_NormedModule));
      eapply continuous_of_derive; [exact A' | exact B'].
  - intros x Hx a Ha. destruct (H x Hx a Ha) as [A [B E]], (z_rates phi a x) as [A' B'].
    split; [|split]; [apply derive_sum; [exact A | apply (is_derive_opp (V := R_NormedModule)), A'] |
      apply derive_sum; [exact B | apply (is_derive_opp (V := R_NormedModule)), B'] |].
    rewrite (rows_add (fun b => y2 b x) (fun b => y1 b x) (fun b => y b x) (fun b => - z2 phi b x) (fun b => - z1 phi b x)
      (fun b => - z phi b x)), E.
    rewrite (Sum_ext N (fun b => M a b * - z2 phi b x + C a b * - z1 phi b x + K a b * - z phi b x)
      (fun b => - (M a b * z2 phi b x + C a b * z1 phi b x + K a b * z phi b x))) by (intros; ring).
    rewrite Sum_opp, z_row by exact Ha. ring.
  - intros a Ha. destruct (Mi a Ha) as [A B], (z_mirrored phi a) as [A' B']. unfold mirrored. rewrite A, B, A', B'. split; ring.
  - rewrite x_under_is, x_prime_under_is. lra.
Qed.

Lemma initial_values_under phi y y1 y2 : (forall a, (a < N)%nat -> continuous_on_half_period (y a) (y1 a)) ->
  half_period_motion_under phi y y1 y2 -> (forall k, (k < N)%nat -> mirrored (y k) (y1 k)) -> forall k, (k < N)%nat ->
  V_re_under k * cos phi - V_im_under k * sin phi = y k 0 + beta * G s k /\ V_re_under k * sin phi + V_im_under k * cos phi =
    - (y1 k 0 + beta * U s k).
Proof.
  intros Cy H Mi k Hk. pose proof PI_RGT_0. destruct (unique_under phi y y1 y2 Cy H Mi k 0 Hk) as [-> ->]; [lra|]. apply
    x_under_initial, Hk.
Qed.

Lemma no_other_ phi y y1 y2 : responds_under -> steady_half_period_under phi y y1 y2 -> 0 <= y j 0 + beta * G s j ->
  is_phase_under phi /\ y j 0 = X_j_under /\
  forall k t, (k < N)%nat -> 0 <= t <= PI -> y k t = x_under phi k t /\ y1 k t = x_prime_under phi k t.
Proof.
  intros H [Cy [Hm [Mi V0]]] Hp.
  destruct (initial_values_under phi y y1 y2 Cy Hm Mi j (Hj s Hs)) as [E1 E2]. rewrite V0, Rplus_0_l in E2.
  pose proof (root_under_sq H) as RS. pose proof (sqrt_pos (V_abs_under j ^ 2 - (beta * U s j) ^ 2)) as RP. fold root_under
    in RP.
  pose proof (V_abs_under_sq j) as VS. pose proof (circle (V_re_under j) (V_im_under j) phi) as CI. rewrite E1, E2 in CI.
  assert (Q : y j 0 + beta * G s j = root_under) by nra.
  split; [|split].
  - unfold Statements.is_phase_under. rewrite E1, E2. split; [exact Q | reflexivity].
  - unfold Statements.X_j_under. lra.
  - intros k t Hk Ht. apply (unique_under phi y y1 y2); assumption.
Qed.

Lemma velocity_under phi t : V_re_under j * sin phi + V_im_under j * cos phi = - (beta * U s j) ->
  x_prime_under phi j t = beta * D s t - (V_re_under j * cos phi - V_im_under j * sin phi) * sin t.
Proof.
  intros E. assert (F : friction_velocity j t = D s t - U s j * cos t).
  { unfold Statements.friction_velocity, D, U. rewrite <- Sum_scal_r, <- Sum_minus. apply Sum_ext. intros i Hi.
    pose proof (Hadm s Hs i Hi) as [A [B _]]. rewrite demand_by_braces by assumption. ring. }
  unfold Statements.x_prime_under. rewrite F, sin_plus, cos_plus.
  transitivity (beta * D s t - (V_re_under j * cos phi - V_im_under j * sin phi) * sin t - cos t * (V_re_under j * sin phi +
    V_im_under j * cos phi
    + beta * U s j)); [ring|]. rewrite E. ring.
Qed.

Lemma slides_under_iff phi : is_phase_under phi -> (slides_under phi <-> forall t, 0 < t < PI -> beta * demand s t <
  root_under).
Proof.
  intros [P1 P2]. split; intros H t Ht; specialize (H t Ht); pose proof (sin_gt_0 t ltac:(lra) ltac:(lra)) as S.
  - rewrite velocity_under, P1 in H by exact P2. change (demand s t) with (D s t / sin t). apply (Rmult_lt_reg_r (sin t));
    [exact S|].
    replace (beta * (D s t / sin t) * sin t) with (beta * D s t) by (field; lra). lra.
  - rewrite velocity_under, P1 by exact P2. change (demand s t) with (D s t / sin t) in H. apply (Rmult_lt_compat_r (sin t))
    in H; [|exact S].
    replace (beta * (D s t / sin t) * sin t) with (beta * D s t) in H by (field; lra). lra.
Qed.

Lemma holding_under_is phi : is_phase_under phi -> holding_friction_under phi = (root_under - beta * H_j s) / mobility s.
Proof.
  intros [P1 P2]. pose proof (mobility_pos s Hs) as Mp.
  assert (A : x2_under phi j 0 = beta * (H_j s + mobility s) - root_under).
  { destruct (x_under_derive phi j 0) as [_ B]. apply is_derive_unique in B. rewrite <- B. apply is_derive_unique.
    apply (is_derive_ext (fun t => beta * D s t - (V_re_under j * cos phi - V_im_under j * sin phi) * sin t));
      [intros; symmetry; apply velocity_under, P2|].
    evar_last. { apply (is_derive_minus (V := R_NormedModule)); apply is_derive_scal; [apply D_rate, Hs | apply
      is_derive_sin]. }
    destruct (D_ends s Hs) as [_ [_ [E0 _]]]. rewrite E0, cos_0, P1. unfold minus, plus, opp; simpl. ring. }
  unfold Statements.holding_friction_under. apply (Rmult_eq_reg_r (mobility s)); [|lra].
  replace ((root_under - beta * H_j s) / mobility s * mobility s) with (beta * mobility s - x2_under phi j 0) by (rewrite A;
    field; lra).
  replace (Sum N (fun a => Sum N (fun i => psi j i * psi a i) * (Sum N (fun b => C a b * x_prime_under phi b 0 + K a b *
    x_under phi b 0)
    - forces_at phi 0 a)) / mobility s * mobility s) with (Sum N (fun a => Sum N (fun i => psi j i * psi a i) *
    (Sum N (fun b => C a b * x_prime_under phi b 0 + K a b * x_under phi b 0) - forces_at phi 0 a))) by (field; lra).
  rewrite (Sum_ext N _ (fun a => delta a j * (Sum N (fun i => psi j i * psi a i) * beta) - Sum N (fun b => Sum N (fun i =>
    psi j i
    * psi a i) * M a b * x2_under phi b 0))).
  - rewrite Sum_minus, (Sum_delta N j (fun a => Sum N (fun i => psi j i * psi a i) * beta) (Hj s Hs)). f_equal.
    + unfold mobility. rewrite Rmult_comm. f_equal. apply Sum_ext. intros; ring.
    + rewrite Sum_swap. rewrite (Sum_ext N _ (fun b => delta b j * x2_under phi b 0)); [apply (Sum_delta N j (fun b =>
      x2_under phi b 0) (Hj s Hs))|].
      intros b Hb. rewrite Sum_scal_r. f_equal. rewrite delta_sym. apply (modes_are_complete_ s Hs j b (Hj s Hs) Hb).
  - intros a Ha. pose proof (x_under_equation phi a 0 Ha) as E.
    rewrite (Sum_ext N (fun b => M a b * x2_under phi b 0 + C a b * x_prime_under phi b 0 + K a b * x_under phi b 0)
      (fun b => M a b * x2_under phi b 0 + (C a b * x_prime_under phi b 0 + K a b * x_under phi b 0))) in E by (intros; ring).
    rewrite Sum_plus in E.
    replace (Sum N (fun b => C a b * x_prime_under phi b 0 + K a b * x_under phi b 0) - forces_at phi 0 a)
      with (delta a j * beta - Sum N (fun b => M a b * x2_under phi b 0)) by lra.
    transitivity (Sum N (fun i => psi j i * psi a i) * (delta a j * beta) - Sum N (fun i => psi j i * psi a i) * Sum N (fun b
      => M a b * x2_under phi b 0)); [ring|].
    rewrite <- (Sum_scal N _ (fun b => M a b * x2_under phi b 0)). f_equal; [ring|]. apply Sum_ext. intros; ring.
Qed.

Lemma holding_under_above mu phi : is_phase_under phi ->
  (mu * beta < holding_friction_under phi <-> beta * (H_j s + mu * mobility s) < root_under) /\
  (holding_friction_under phi < - (mu * beta) <-> root_under < beta * (H_j s - mu * mobility s)).
Proof.
  intros P. rewrite holding_under_is by assumption. pose proof (mobility_pos s Hs) as Mp.
  assert (E : (root_under - beta * H_j s) / mobility s * mobility s = root_under - beta * H_j s) by (field; lra).
  split; split; intros H.
  - apply (Rmult_lt_compat_r (mobility s)) in H; [|exact Mp]. rewrite E in H. lra.
  - apply (Rmult_lt_reg_r (mobility s)); [exact Mp|]. rewrite E. lra.
  - apply (Rmult_lt_compat_r (mobility s)) in H; [|exact Mp]. rewrite E in H. lra.
  - apply (Rmult_lt_reg_r (mobility s)); [exact Mp|]. rewrite E. lra.
Qed.
Lemma phase_responds_under phi : 0 < V_abs_under j -> is_phase_under phi -> responds_under.
Proof.
  intros V [P1 P2]. split; [exact V|]. apply Rnot_lt_le. intros H.
  pose proof (V_abs_under_sq j) as Vs. pose proof (pow2_abs (beta * U s j)) as A.
  assert (Z : root_under = 0) by (unfold Statements.root_under; apply sqrt_neg_0; nra).
  pose proof (circle (V_re_under j) (V_im_under j) phi) as Ci. rewrite P1, P2, Z in Ci. nra.
Qed.
Lemma sliding_start_under phi : is_phase_under phi -> slides_under phi -> beta * (H_j s + mobility s) <= root_under.
Proof.
  intros [P1 P2] H. destruct (D_ends s Hs) as [D0 [_ [E0 _]]].
  assert (beta * (H_j s + mobility s) - root_under <= 0); [|lra]. apply (slope_nonpos (fun t => beta * D s t - root_under *
    sin t)).
  - rewrite D0, sin_0. ring.
  - evar_last. { apply (is_derive_minus (V := R_NormedModule)); apply is_derive_scal; [apply D_rate, Hs | apply
    is_derive_sin]. }
    rewrite E0, cos_0. unfold minus, plus, opp; simpl. ring.
  - intros t Ht. specialize (H t Ht). rewrite velocity_under, P1 in H by exact P2. exact H.
Qed.
Lemma some_phase_under : responds_under -> exists phi, is_phase_under phi.
Proof.
  intros H. pose proof (root_under_sq H) as RS. pose proof (V_abs_under_sq j) as VS. destruct H as [HV _].
  set (a := V_re_under j) in *. set (b := V_im_under j) in *. set (r := root_under) in *. set (w := - (beta * U s j)).
  set (c := (a * r + b * w) / V_abs_under j ^ 2). set (d := (a * w - b * r) / V_abs_under j ^ 2).
  assert (Vn : V_abs_under j ^ 2 <> 0) by (apply pow_nonzero; lra).
  assert (Q : r ^ 2 + w ^ 2 = V_abs_under j ^ 2) by (unfold w; rewrite RS; ring).
  assert (S1 : c ^ 2 + d ^ 2 = 1).
  { unfold c, d. transitivity ((a ^ 2 + b ^ 2) * (r ^ 2 + w ^ 2) / (V_abs_under j ^ 2 * V_abs_under j ^ 2)); [field; lra|].
    rewrite Q, <- VS. field. lra. }
  destruct (atan2_is_the_angle c d) as [A B].
  { destruct (Req_dec c 0) as [Z|Z]; [right | left; exact Z]. intros Z'. rewrite Z, Z' in S1. lra. }
  rewrite S1, sqrt_1, Rmult_1_l in A. rewrite S1, sqrt_1, Rmult_1_l in B. exists (atan2 d c). unfold
    Statements.is_phase_under. rewrite A, B. fold a b.
  change (a * c - b * d = r /\ a * d + b * c = w). unfold c, d.
  split; [transitivity ((a ^ 2 + b ^ 2) * r / V_abs_under j ^ 2) | transitivity ((a ^ 2 + b ^ 2) * w / V_abs_under j ^ 2)];
    try (field; lra); rewrite <- VS; field; lra.
Qed.
Lemma closed_form_under phi : is_phase_under phi -> slides_under phi ->
  steady_under s (fun a t => forces_at phi t a) (2 * PI) (continued (x_under phi)) (continued (x_prime_under phi)).
Proof.
  intros _ SL. apply (continued_is_steady s _ _ _ (x2_under phi)).
  - apply x_under_derive.
  - apply x_under_mirrored.
  - intros a t Ha. apply x_under_equation, Ha.
  - intros a t. unfold Statements.forces_at. replace (t + PI + phi) with (t + phi + PI) by ring. rewrite neg_cos, neg_sin. ring.
  - exact SL.
Qed.
End Out_of_phase.

Lemma one_force s k : is_scene s -> V_re_under s (fun a => delta a (loaded s)) (fun _ => 0) k = V_re s k /\
  V_im_under s (fun a => delta a (loaded s)) (fun _ => 0) k = V_im s k.
Proof.
  intros Hs. assert (P : forall i, load_on_mode s (fun a => delta a (loaded s)) i = shape s (loaded s) i).
  { intros i. unfold Statements.load_on_mode. apply (Sum_delta_r _ _ (fun a => shape s a i) (Hl s Hs)). }
  assert (Q : forall i, load_on_mode s (fun _ => 0) i = 0) by (intros; apply Sum_zero; intros; ring).
  unfold Statements.V_re_under, Statements.V_im_under, V_re, V_im. split; apply Sum_ext; intros i _; rewrite P, Q; ring.
Qed.

Lemma boundary_under s p q mu S : is_scene s -> 1 <= mu -> 0 < friction s -> 0 < V_abs_under s p q (contact s) ->
  supremum_of_demand s S ->
  ((exists phi, is_phase_under s p q phi /\ slides_under s p q phi /\ mu * friction s < Rabs (holding_friction_under s p q
    phi)) <->
   friction s < limit_69_under s p q mu S).
Proof.
  intros Hs Hm Hb HV L. unfold limit_69_under. pose proof (static_demand_pos s mu Hs Hm) as SP. pose proof (mobility_pos s
    Hs) as Mp.
  set (m := Rmax S (H_j s + mu * mobility s)). assert (Pm : 0 < m) by (pose proof (Rmax_r S (H_j s + mu * mobility s)); unfold
    m; lra).
  pose proof (limit_of_root (friction s) (V_abs_under s p q (contact s)) (U s (contact s)) m Pm Hb) as LB.
  change (sqrt (V_abs_under s p q (contact s) ^ 2 - (friction s * U s (contact s)) ^ 2)) with (root_under s p q) in LB.
  split.
  - intros [phi [P [SL HH]]]. apply LB. destruct (holding_under_above s p q Hs mu phi P) as [A B].
    split; [apply (phase_responds_under s p q phi HV P)|].
    pose proof (proj1 (slides_under_iff s p q Hs phi P) SL) as Sl.
    assert (St : friction s * (H_j s + mobility s) <= root_under s p q).
    { apply (sliding_start_under s p q Hs phi P SL). }
    assert (X : friction s * (H_j s + mu * mobility s) < root_under s p q).
    { apply A. unfold Rabs in HH. destruct (Rcase_abs (holding_friction_under s p q phi)); [|exact HH].
      exfalso. assert (HN : root_under s p q < friction s * (H_j s - mu * mobility s)) by (apply B; lra).
      assert (friction s * (H_j s - mu * mobility s) < friction s * (H_j s + mobility s)) by (apply Rmult_lt_compat_l; nra).
        lra. }
    unfold m, Rmax. destruct (Rle_dec S (H_j s + mu * mobility s)); [exact X|].
    destruct (supremum s S Hs L) as [Q|[t [Ht Q]]]; [nra|].
    apply Rle_lt_trans with (friction s * demand s t); [apply Rmult_le_compat_l; lra | apply Sl, Ht].
  - intros HL. destruct (proj2 LB (conj HV HL)) as [H X]. destruct (some_phase_under s p q H) as [phi P]. exists phi.
    destruct (holding_under_above s p q Hs mu phi P) as [A B]. split; [exact P|].
    assert (X1 : friction s * S <= friction s * m) by (apply Rmult_le_compat_l; [lra | apply Rmax_l]).
    assert (X2 : friction s * (H_j s + mu * mobility s) <= friction s * m) by (apply Rmult_le_compat_l; [lra | apply Rmax_r]).
    split.
    + apply (slides_under_iff s p q Hs phi P). intros t Ht. destruct L as [Up _]. assert (demand s t <= S) by (apply Up;
      exists t; auto).
      assert (friction s * demand s t <= friction s * S) by (apply Rmult_le_compat_l; lra). lra.
    + apply Rlt_le_trans with (holding_friction_under s p q phi); [apply A; lra | apply Rle_abs].
Qed.

Theorem one_force_is_among_them : forall s p q, Statements.one_force_is_among_them s p q.
Proof. intros s p q Hs -> -> k. apply (one_force s k Hs). Qed.
Theorem steady_motion_under_forces : forall s p q, Statements.steady_motion_under_forces s p q.
Proof. intros s p q Hs H phi P. apply (steady_ s p q Hs phi H P). Qed.
Theorem no_other_motion_under_forces : forall s p q, Statements.no_other_motion_under_forces s p q.
Proof. intros s p q Hs H phi y y1 y2 S Y. apply (no_other_ s p q Hs phi y y1 y2 H S Y). Qed.
Lemma root_of_sum_under s p q : X_j_under s p q + friction s * G s (contact s) = root_under s p q.
Proof. unfold X_j_under. ring. Qed.
Theorem slides_iff_under_forces : forall s p q, Statements.slides_iff_under_forces s p q.
Proof. intros s p q Hs phi P. rewrite root_of_sum_under. apply (slides_under_iff s p q Hs phi P). Qed.
Theorem eq_66_under_forces : forall s p q, Statements.eq_66_under_forces s p q.
Proof. intros s p q Hs phi P. rewrite root_of_sum_under. apply (holding_under_is s p q Hs phi P). Qed.
Theorem eq_69_under_forces : forall s p q, Statements.eq_69_under_forces s p q.
Proof. intros s p q mu S Hs Hm Hb HV L. apply (boundary_under s p q mu S Hs Hm Hb HV L). Qed.
Theorem closed_form_is_steady_under_forces : forall s p q, Statements.closed_form_is_steady_under_forces s p q.
Proof. intros s p q Hs phi P SL. apply (closed_form_under s p q Hs phi P SL). Qed.
