(* What (48) leaves out, and (52) with it, at a given damping. *)
Require Import Reals Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes SteadyMode Sums Masses OneVelocity.
Open Scope R_scope.

Section Mode.
Variables r z : R.
Hypothesis Hr : 0 < r.
Hypothesis Hz : 0 <= z < 1.
Local Notation G := (g r z).
Local Notation U := (u r z).

(* What the harmonic part lacks of the braces, and its rates: a vibration from rest under a bounded force *)
Definition rest t := G * cos t + U * sin t + braces r z t.
Definition rest_prime t := - G * sin t + U * cos t + braces_prime r z t.
Definition rest_second t := - G * cos t - U * sin t + braces_second r z t.
Lemma rest_rate t : is_derive rest t (rest_prime t) /\ is_derive rest_prime t (rest_second t).
Proof.
  split; unfold rest, rest_prime; apply (is_derive_plus (V := R_NormedModule)); try (apply braces_rate; assumption); try (apply
    braces_prime_rate; assumption); auto_derive; trivial; ring.
Qed.
Lemma rest_starts : rest 0 = 0 /\ rest_prime 0 = 0.
Proof.
  destruct (at_start r z Hr Hz) as [D [Q Q1]]. unfold rest, rest_prime, braces, braces_prime. rewrite cos_0, sin_0, D, Q, Q1.
  split; field; lra.
Qed.
Local Notation F := (force_left_out r z).
Lemma rest_equation t : Rabs (r ^ 2 * rest_second t + 2 * z * r * rest_prime t + rest t) <= F.
Proof.
  pose proof (braces_equation r z t Hr Hz) as B. pose proof (COS_bound t). pose proof (SIN_bound t).
  replace (r ^ 2 * rest_second t + 2 * z * r * rest_prime t + rest t) with
    (1 + ((1 - r ^ 2) * (G * cos t + U * sin t) + 2 * z * r * (U * cos t - G * sin t))) by (unfold rest, rest_prime, rest_second; lra).
  assert (Two : forall a b, -1 <= a <= 1 -> -1 <= b <= 1 -> Rabs (G * a + U * b) <= Rabs G + Rabs U).
  { intros a b Ha Hb. eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult.
    assert (Rabs a <= 1) by (apply Rabs_le; lra). assert (Rabs b <= 1) by (apply Rabs_le; lra).
    pose proof (Rabs_pos G). pose proof (Rabs_pos U). apply Rplus_le_compat.
    - rewrite <- (Rmult_1_r (Rabs G)) at 2. apply Rmult_le_compat_l; assumption.
    - rewrite <- (Rmult_1_r (Rabs U)) at 2. apply Rmult_le_compat_l; assumption. }
  unfold force_left_out. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_R1. apply Rplus_le_compat_l.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult, Rmult_plus_distr_r. apply Rplus_le_compat.
  - apply Rmult_le_compat_l; [apply Rabs_pos | apply Two; lra].
  - rewrite <- !Rabs_mult, Rabs_mult, (Rabs_right (2 * z * r)) by nra. apply Rmult_le_compat_l; [nra|].
    replace (U * cos t - G * sin t) with (G * (- sin t) + U * cos t) by ring. apply Two; lra.
Qed.
Lemma force_positive : 0 < F.
Proof.
  unfold force_left_out. pose proof (Rabs_pos (1 - r ^ 2)). pose proof (Rabs_pos G). pose proof (Rabs_pos U).
  assert (0 <= 2 * z * r) by nra. assert (0 <= (Rabs (1 - r ^ 2) + 2 * z * r) * (Rabs G + Rabs U)) by (apply Rmult_le_pos; lra). lra.
Qed.

(* The root of the energy grows by at most F / r in unit time. *)
Lemma root_of_energy e t : 0 < e -> 0 <= t -> sqrt (rest t * rest t + r ^ 2 * (rest_prime t * rest_prime t) + e * e) <= e + F / r * t.
Proof.
  intros He Ht. set (E := fun t => rest t * rest t + r ^ 2 * (rest_prime t * rest_prime t) + e * e).
  pose proof force_positive as Fp. assert (R2 : 0 < r ^ 2) by nra.
  assert (Ep : forall x, 0 < E x) by (intros x; unfold E; pose proof (Rle_0_sqr (rest x)); pose proof (Rle_0_sqr (rest_prime x)); unfold
    Rsqr in *; nra).
  assert (Dl : forall x, is_derive (fun t => sqrt (E t) - F / r * t) x
    (/ (2 * sqrt (E x)) * (2 * rest_prime x * (rest x + r ^ 2 * rest_second x)) - F / r)).
  { intros x. destruct (rest_rate x) as [D1 D2]. apply (is_derive_minus (V := R_NormedModule)).
    - evar_last.
      { apply (is_derive_comp sqrt E).
        - apply is_derive_Reals, derivable_pt_lim_sqrt, Ep.
        - unfold E. apply (is_derive_plus (V := R_NormedModule)); [|apply (is_derive_const (K := R_AbsRing) (V := R_NormedModule))].
          apply (is_derive_plus (V := R_NormedModule)); [|apply is_derive_scal];
            apply (is_derive_mult (K := R_AbsRing)); try eassumption; intros; apply Rmult_comm. }
      unfold scal, plus, mult, zero; simpl; unfold mult; simpl. ring.
    - auto_derive; [trivial | ring]. }
  assert (Le : sqrt (E t) - F / r * t <= sqrt (E 0) - F / r * 0).
  { apply (not_growing nil (fun t => sqrt (E t) - F / r * t) 0 t Ht); [intros x _; eapply continuous_of_derive, Dl|].
    intros x Hx _. eexists. split; [apply Dl|]. pose proof (rest_equation x) as Eq. apply Rabs_le_between in Eq.
    set (p := rest_prime x) in *. set (f := r ^ 2 * rest_second x + 2 * z * r * p + rest x) in *.
    replace (rest x + r ^ 2 * rest_second x) with (f - 2 * z * r * p) by (unfold f; ring).
    pose proof (sqrt_lt_R0 _ (Ep x)) as Sp. assert (SS : sqrt (E x) * sqrt (E x) = E x) by (apply sqrt_sqrt, Rlt_le, Ep).
    assert (Pl : r * Rabs p <= sqrt (E x)).
    { apply Rsqr_incr_0_var; [|lra]. unfold Rsqr. rewrite SS. unfold E. fold p.
      replace (r * Rabs p * (r * Rabs p)) with (r ^ 2 * (Rabs p * Rabs p)) by ring. rewrite <- Rabs_mult, (Rabs_right (p * p)) by (apply
        Rle_ge, Rle_0_sqr). pose proof (Rle_0_sqr (rest x)). unfold Rsqr in *. nra. }
    assert (Pw : p * (f - 2 * z * r * p) <= Rabs p * F).
    { assert (0 <= 2 * z * r * (p * p)) by (apply Rmult_le_pos; [nra | apply Rle_0_sqr]).
      assert (p * f <= Rabs p * F).
      { apply Rle_trans with (1 := Rle_abs _). rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos | apply Rabs_le; lra]. }
      lra. }
    apply (Rmult_le_reg_r (sqrt (E x) * r)); [apply Rmult_lt_0_compat; lra|].
    replace ((/ (2 * sqrt (E x)) * (2 * p * (f - 2 * z * r * p)) - F / r) * (sqrt (E x) * r)) with
      (p * (f - 2 * z * r * p) * r - F * sqrt (E x)) by (field; lra).
    assert (p * (f - 2 * z * r * p) * r <= Rabs p * F * r) by (apply Rmult_le_compat_r; lra).
    assert (F * (r * Rabs p) <= F * sqrt (E x)) by (apply Rmult_le_compat_l; lra). lra. }
  destruct rest_starts as [R0 R1]. unfold E in Le at 2. rewrite R0, R1 in Le.
  replace (0 * 0 + r ^ 2 * (0 * 0) + e * e) with (e * e) in Le by ring. rewrite sqrt_square in Le by lra. fold (E t). lra.
Qed.

Lemma rest_bounds t : 0 <= t -> Rabs (rest t) <= F / r * t /\ Rabs (rest_prime t) <= F / r ^ 2 * t.
Proof.
  intros Ht. assert (R2 : 0 < r ^ 2) by nra. pose proof force_positive as Fp.
  assert (B : forall e, 0 < e -> Rabs (rest t) <= e + F / r * t /\ r * Rabs (rest_prime t) <= e + F / r * t).
  { intros e He. pose proof (root_of_energy e t He Ht) as Q. set (E := rest t * rest t + r ^ 2 * (rest_prime t * rest_prime t) + e * e) in *.
    pose proof (Rle_0_sqr (rest t)) as S0. pose proof (Rle_0_sqr (rest_prime t)) as S1. unfold Rsqr in S0, S1.
    assert (0 <= r ^ 2 * (rest_prime t * rest_prime t)) by (apply Rmult_le_pos; lra). assert (0 <= E) by (unfold E; nra).
    split; (apply Rle_trans with (2 := Q)); (apply Rsqr_incr_0_var; [|apply sqrt_pos]); unfold Rsqr; rewrite sqrt_sqrt by assumption; unfold E.
    - rewrite <- Rabs_mult, Rabs_right by lra. nra.
    - replace (r * Rabs (rest_prime t) * (r * Rabs (rest_prime t))) with (r ^ 2 * (Rabs (rest_prime t) * Rabs (rest_prime t))) by ring.
      rewrite <- Rabs_mult, (Rabs_right (rest_prime t * rest_prime t)) by lra. nra. }
  split.
  - apply le_epsilon. intros e He. destruct (B e He). lra.
  - apply (Rmult_le_reg_l r); [exact Hr|]. replace (r * (F / r ^ 2 * t)) with (F / r * t) by (field; lra).
    apply le_epsilon. intros e He. destruct (B e He). lra.
Qed.

Lemma mode_left_out_bounds t : 0 <= t <= PI -> Rabs (rest t) <= mode_left_out r z.
Proof.
  intros [T0 T1]. pose proof force_positive as Fp. assert (R2 : 0 < r ^ 2) by nra. unfold mode_left_out.
  assert (Ir : 0 < / r) by (apply Rinv_0_lt_compat, Hr). assert (Ir2 : 0 < / r ^ 2) by (apply Rinv_0_lt_compat, R2).
  assert (A : Rabs (rest t) <= F * (PI / r)).
  { destruct (rest_bounds t T0) as [B _]. replace (F / r * t) with (F * (t / r)) in B by (field; lra).
    apply Rle_trans with (1 := B). apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_r; lra. }
  assert (Q : forall sg, sg = 1 \/ sg = -1 -> sg * rest t <= F / (2 * r ^ 2) * t ^ 2).
  { intros sg Hsg. assert (Le : sg * rest t - F / (2 * r ^ 2) * t ^ 2 <= sg * rest 0 - F / (2 * r ^ 2) * 0 ^ 2).
    { apply (not_growing nil (fun t => sg * rest t - F / (2 * r ^ 2) * t ^ 2) 0 t T0).
      - intros x _. eapply continuous_of_derive, (is_derive_minus (V := R_NormedModule)).
        + apply is_derive_scal, rest_rate.
        + auto_derive; [trivial | reflexivity].
      - intros x Hx _. exists (sg * rest_prime x - F / r ^ 2 * x). split.
        + apply (is_derive_minus (V := R_NormedModule)); [apply is_derive_scal, rest_rate | auto_derive; [trivial | field; lra]].
        + destruct (rest_bounds x ltac:(lra)) as [_ B]. apply Rabs_le_between in B. destruct Hsg as [-> | ->]; lra. }
    destruct rest_starts as [R0 _]. rewrite R0 in Le. lra. }
  assert (B : Rabs (rest t) <= F * (PI ^ 2 / (2 * r ^ 2))).
  { apply Rle_trans with (F / (2 * r ^ 2) * t ^ 2).
    - pose proof (Q 1 (or_introl eq_refl)). pose proof (Q (-1) (or_intror eq_refl)). apply Rabs_le. lra.
    - replace (F * (PI ^ 2 / (2 * r ^ 2))) with (F / (2 * r ^ 2) * PI ^ 2) by (field; lra).
      apply Rmult_le_compat_l; [apply Rlt_le, Rdiv_lt_0_compat; lra | apply pow_incr; lra]. }
  unfold Rmin. destruct (Rle_dec (PI / r) (PI ^ 2 / (2 * r ^ 2))); assumption.
Qed.
End Mode.

Lemma Sum_abs_le n f h : (forall i, (i < n)%nat -> Rabs (f i) <= h i) -> Rabs (Sum n f) <= Sum n h.
Proof.
  induction n; intros H; simpl; [rewrite Rabs_R0; lra|]. pose proof (Rabs_triang (Sum n f) (f n)). pose proof (H n ltac:(lia)).
  assert (Rabs (Sum n f) <= Sum n h) by (apply IHn; intros; apply H; lia). lra.
Qed.

Theorem eq_48_error : forall s, Statements.eq_48_error s.
Proof.
  intros s Hs Re Hb phi Ph k t Hk Ht. rewrite (eq_41 s Hs Re phi Ph k t Hk). unfold left_out, G, U, friction_motion.
  match goal with |- Rabs ?a <= _ => replace a with (friction s * Sum (masses s) (fun i => shape s k i * shape s (contact s) i *
    ratio s i ^ 2 * (g (ratio s i) (damping_ratio s i) * cos t + u (ratio s i) (damping_ratio s i) * sin t +
    braces (ratio s i) (damping_ratio s i) t))) end.
  2: { rewrite (Sum_ext _ _ (fun i => shape s k i * shape s (contact s) i * ratio s i ^ 2 * g (ratio s i) (damping_ratio s i) * cos t
         + shape s k i * shape s (contact s) i * ratio s i ^ 2 * u (ratio s i) (damping_ratio s i) * sin t
         + shape s k i * shape s (contact s) i * ratio s i ^ 2 * braces (ratio s i) (damping_ratio s i) t)) by (intros; ring).
       rewrite !Sum_plus, !Sum_scal_r. ring. }
  rewrite Rabs_mult, (Rabs_right (friction s)) by lra. apply Rmult_le_compat_l; [exact Hb|]. apply Sum_abs_le. intros i Hi.
  destruct Hs as [_ [_ [Ad _]]]. destruct (Ad i Hi) as [Rp [Zp _]]. rewrite Rabs_mult.
  rewrite (Rabs_mult (shape s k i * shape s (contact s) i)), (Rabs_right (ratio s i ^ 2)) by (apply Rle_ge, pow_le; lra).
  apply Rmult_le_compat_l; [|exact (mode_left_out_bounds _ _ Rp Zp t Ht)].
  apply Rmult_le_pos; [apply Rabs_pos | apply pow_le; lra].
Qed.

(* a cos t + b sin t is at most the root of the squares, which it reaches between 0 and PI. *)
Lemma one_harmonic a b : let A := sqrt (a ^ 2 + b ^ 2) in
  (forall t, Rabs (a * cos t + b * sin t) <= A) /\ (exists t, 0 <= t <= PI /\ Rabs (a * cos t + b * sin t) = A).
Proof.
  intros A. assert (AA : A * A = a ^ 2 + b ^ 2) by (apply sqrt_sqrt; nra). pose proof (sqrt_pos (a ^ 2 + b ^ 2)) as A0. fold A in A0.
  split.
  - intros t. rewrite <- (Rabs_right A) by lra. apply Rsqr_le_abs_0. unfold Rsqr. rewrite AA.
    pose proof (sin2_cos2 t) as CS. unfold Rsqr in CS. pose proof (Rle_0_sqr (a * sin t - b * cos t)) as Z. unfold Rsqr in Z.
    replace (a ^ 2 + b ^ 2) with ((a ^ 2 + b ^ 2) * (sin t * sin t + cos t * cos t)) by (rewrite CS; ring). nra.
  - destruct A0 as [P|Z].
    + assert (Main : forall a b, a ^ 2 + b ^ 2 = A * A -> 0 <= b -> exists t, 0 <= t <= PI /\ a * cos t + b * sin t = A).
      { intros a' b' E B. exists (acos (a' / A)). assert (L : -1 <= a' / A <= 1).
        { assert (- A <= a' <= A) by (split; nra). split; apply (Rmult_le_reg_r A); try lra; unfold Rdiv;
            rewrite Rmult_assoc, Rinv_l by lra; lra. }
        split; [apply acos_bound|]. rewrite cos_acos, sin_acos by exact L.
        replace (sqrt (1 - Rsqr (a' / A))) with (b' / A).
        - apply (Rmult_eq_reg_r A); [|lra]. replace ((a' * (a' / A) + b' * (b' / A)) * A) with (a' ^ 2 + b' ^ 2) by (field; lra). exact E.
        - symmetry. replace (1 - Rsqr (a' / A)) with (b' / A * (b' / A)).
          + apply sqrt_square. apply Rmult_le_pos; [exact B | apply Rlt_le, Rinv_0_lt_compat, P].
          + unfold Rsqr. apply (Rmult_eq_reg_r (A * A)); [|nra].
            replace (b' / A * (b' / A) * (A * A)) with (b' ^ 2) by (field; lra).
            replace ((1 - a' / A * (a' / A)) * (A * A)) with (A * A - a' ^ 2) by (field; lra). lra. }
      destruct (Rle_dec 0 b) as [B|B].
      * destruct (Main a b ltac:(lra) B) as [t [Ht E]]. exists t. split; [exact Ht|]. rewrite E. apply Rabs_right. lra.
      * destruct (Main (- a) (- b) ltac:(rewrite AA; ring) ltac:(lra)) as [t [Ht E]]. exists t. split; [exact Ht|].
        replace (a * cos t + b * sin t) with (- A) by lra. rewrite Rabs_Ropp. apply Rabs_right. lra.
    + exists 0. pose proof PI_RGT_0. split; [lra|]. rewrite <- Z in AA.
      assert (a = 0) by nra. assert (b = 0) by nra. subst a b. rewrite <- Z, !Rmult_0_l, Rplus_0_l. apply Rabs_R0.
Qed.

Theorem eq_52_error : forall s, Statements.eq_52_error s.
Proof.
  intros s Hs Re Hb phi Ph k Hk. pose proof (fun t => eq_48_error s Hs Re Hb phi Ph k t Hk) as B.
  destruct (eq_52_53 s Re k) as [E _]. destruct (eq_49_50_51 s Hs Re phi Ph k Hk) as [EC ES]. rewrite EC, ES in E.
  destruct (one_harmonic (x s phi k 0) (x_prime s phi k 0)) as [Up [t0 [H0 At]]]. rewrite <- E in Up, At. split.
  - intros t Ht. specialize (B t Ht). specialize (Up t). apply Rabs_le_between in B. apply Rabs_le_between in Up. apply Rabs_le. lra.
  - exists t0. split; [exact H0|]. specialize (B t0 H0). rewrite <- At.
    set (h := x s phi k 0 * cos t0 + x_prime s phi k 0 * sin t0) in *. pose proof (Rabs_triang (x s phi k t0) (- (x s phi k t0 - h))) as T.
    rewrite Rabs_Ropp in T. replace (x s phi k t0 + - (x s phi k t0 - h)) with h in T by ring. lra.
Qed.

Theorem eq_38_without_U : forall s, Statements.eq_38_without_U s.
Proof.
  intros s [V0 B]. unfold X_j. assert (Bs : (friction s * U s (contact s)) ^ 2 <= V_abs s (contact s) ^ 2).
  { replace ((friction s * U s (contact s)) ^ 2) with (Rabs (friction s * U s (contact s)) ^ 2) by (rewrite <- !Rsqr_pow2, <- Rsqr_abs;
      reflexivity). apply pow_incr. split; [apply Rabs_pos | exact B]. }
  pose proof (sqrt_pos (V_abs s (contact s) ^ 2 - (friction s * U s (contact s)) ^ 2)) as R0. fold (root s) in R0.
  assert (RR : root s * root s = V_abs s (contact s) ^ 2 - (friction s * U s (contact s)) ^ 2) by (apply sqrt_sqrt; lra).
  set (v := V_abs s (contact s)) in *. set (b := friction s * U s (contact s)) in *. assert (Rv : root s <= v) by nra.
  split; [lra|]. replace (v - friction s * G s (contact s) - (- friction s * G s (contact s) + root s)) with (v - root s) by ring.
  apply (Rmult_le_reg_r v); [exact V0|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. nra.
Qed.
