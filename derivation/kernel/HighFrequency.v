(* (86), for any number of masses and for one. *)
Require Import Reals Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes SteadyMode Sums Masses Contact OneVelocity ContactMotion Misprints Limits.
Open Scope R_scope.

Theorem eq_67_by_shares : Statements.eq_67_by_shares.
Proof.
  intros s mu Sc. pose proof (mobility_pos s Sc) as Mp. unfold limit_by_shares. f_equal.
  set (m := mobility s) in *.
  assert (Sh : forall f h : nat -> R, Sum (masses s) (fun i => h i / m * f i) = / m * Sum (masses s) (fun i => h i * f i)).
  { intros f h. rewrite <- Sum_scal. apply Sum_ext. intros. unfold Rdiv. ring. }
  rewrite !(Sh _ (fun i => shape s (contact s) i ^ 2)), !(Sh _ (fun i => shape s (contact s) i * shape s (loaded s) i)).
  replace (Sum (masses s) (fun i => shape s (contact s) i * shape s (loaded s) i * (ratio s i ^ 2 * v_re (ratio s i)
    (damping_ratio
    s i)))) with (V_re s (contact s)) by (unfold V_re; apply Sum_ext; intros; ring).
  replace (Sum (masses s) (fun i => shape s (contact s) i * shape s (loaded s) i * (ratio s i ^ 2 * v_im (ratio s i)
    (damping_ratio
    s i)))) with (V_im s (contact s)) by (unfold V_im; apply Sum_ext; intros; ring).
  replace (Sum (masses s) (fun i => shape s (contact s) i ^ 2 * (ratio s i ^ 2 * u (ratio s i) (damping_ratio s i))))
    with (U s (contact s)) by (unfold U; apply Sum_ext; intros; ring).
  replace (Sum (masses s) (fun i => shape s (contact s) i ^ 2 * (g (ratio s i) (damping_ratio s i)
    + 2 * damping_ratio s i * (ratio s i * u (ratio s i) (damping_ratio s i)))))
    with (H_j s) by (unfold H_j; apply Sum_ext; intros; ring).
  unfold V_abs. rewrite <- Rsqr_pow2, Rsqr_sqrt by (apply Rplus_le_le_0_compat; apply pow2_ge_0).
  set (V1 := V_re _ _). set (V2 := V_im _ _). set (Uj := U _ _). set (H := H_j s).
  replace ((/ m * V1) ^ 2 + (/ m * V2) ^ 2) with (/ m ^ 2 * (V1 ^ 2 + V2 ^ 2)) by (field; lra).
  replace ((/ m * Uj) ^ 2 + (/ m * H + mu) ^ 2) with (/ m ^ 2 * (Uj ^ 2 + (H + mu * m) ^ 2)) by (field; lra).
  unfold Rdiv. rewrite Rinv_mult, Rinv_inv.
  replace (/ m ^ 2 * (V1 ^ 2 + V2 ^ 2) * (m ^ 2 * / (Uj ^ 2 + (H + mu * m) ^ 2)))
    with (/ m ^ 2 * m ^ 2 * ((V1 ^ 2 + V2 ^ 2) * / (Uj ^ 2 + (H + mu * m) ^ 2))) by ring.
  rewrite Rinv_l by (apply Rgt_not_eq; nra). ring.
Qed.

(* What (28) and (29) divide by, as a function of e = 1 / R *)
Definition bottom_e z e := cosh (PI * z * e) + cos (PI * w z * e).

(* A limit for e -> 0 of a function of e = 1 / R is one for R -> oo. *)
Lemma by_reciprocal (f h : R -> R) a : is_lim h 0 (Finite a) -> (forall r, 2 < r -> h (/ r) = f r) -> is_lim f p_infty (Finite a).
Proof.
  intros L E. assert (L' : is_lim (fun r => h (/ r)) p_infty a).
  { apply (is_lim_comp h Rinv p_infty _ 0); [exact L | |].
    - replace (Finite 0) with (Rbar_inv p_infty) by reflexivity. apply (is_lim_inv (fun r => r)); [apply is_lim_id |
      discriminate].
    - exists 1. intros r Hr K. injection K as K. pose proof (Rinv_0_lt_compat r ltac:(lra)). lra. }
  apply (is_lim_ext_loc _ f) in L'; [exact L'|]. exists 2. exact E.
Qed.

Section Mode.
Variable z : R.
Hypothesis Hz : 0 <= z < 1.
Let Hw : 0 < w z := w_pos z Hz.

Lemma bottom_above r : 2 < r -> 0 < bottom_e z (/ r).
Proof.
  intros Hr. pose proof PI_RGT_0 as P. pose proof (w_sq z Hz) as W. assert (w z <= 1) by nra. unfold bottom_e.
  assert (Ri : 0 < / r < / 2) by (split; [apply Rinv_0_lt_compat | apply Rinv_lt_contravar]; lra).
  assert (WR : 0 < w z * / r < / 2).
  { split; [apply Rmult_lt_0_compat; lra | apply Rle_lt_trans with (1 * / r); [apply Rmult_le_compat_r; lra | lra]]. }
  assert (0 < cos (PI * w z * / r)) by (rewrite Rmult_assoc; apply cos_gt_0; nra). assert (0 < cosh (PI * z * / r)) by (unfold
    cosh; pose proof (exp_pos (PI * z * / r)); pose proof (exp_pos (- (PI * z * / r))); lra).
  lra.
Qed.

Lemma bottom_limit_e : is_lim (bottom_e z) 0 2.
Proof.
  apply limit_value; [unfold bottom_e, cosh; auto_derive; trivial | unfold bottom_e; rewrite !Rmult_0_r, cosh_0, cos_0; ring].
Qed.

(* What (23) divides by, likewise *)
Lemma resonance_denominator r : 2 < r ->
  ((/ r) ^ 2 - 1) ^ 2 + (2 * z * / r) ^ 2 = / r ^ 4 * ((1 - r * r) ^ 2 + (2 * z * r) ^ 2) /\
  (1 - r * r) ^ 2 + (2 * z * r) ^ 2 <> 0.
Proof.
  intros Hr. split; [field; lra|]. assert (3 < r * r) by nra. assert (0 < (1 - r * r) ^ 2) by nra. pose proof (pow2_ge_0 (2 * z
    * r)). lra.
Qed.

Lemma v_at_infinity : is_lim (fun r => r ^ 2 * v_re r z) p_infty (-1) /\ is_lim (fun r => r ^ 2 * v_im r z) p_infty 0.
Proof.
  split; [apply (by_reciprocal _ (fun e => (e ^ 2 - 1) / ((e ^ 2 - 1) ^ 2 + (2 * z * e) ^ 2)))
    | apply (by_reciprocal _ (fun e => - (2 * z * e) / ((e ^ 2 - 1) ^ 2 + (2 * z * e) ^ 2)))];
    try (apply limit_value; [auto_derive; simpl; nra | field]);
    intros r Hr; destruct (resonance_denominator r Hr) as [E D]; rewrite E; unfold v_re, v_im;
    field; repeat split; try lra; intro K; apply D; rewrite <- K; ring.
Qed.

Lemma sine_limit : is_lim (fun e => sin (PI * w z * e) / (e - 0) / (w z * bottom_e z e)) 0 (PI / 2).
Proof.
  pose proof PI_RGT_0 as P. replace (PI / 2) with (PI * w z / (w z * 2)) by (field; lra).
  apply ratio_limit; [| apply (product_limit (fun _ => w z)); [apply is_lim_const | exact bottom_limit_e] | nra].
  apply (slope_limit (fun e => sin (PI * w z * e))); [rewrite Rmult_0_r; apply sin_0|]. auto_derive; [trivial|]. rewrite
    Rmult_0_r, cos_0. ring.
Qed.

Lemma angles r : theta r z = PI * w z * / r /\ decay r z = PI * z * / r.
Proof. split; reflexivity. Qed.

Lemma u_at_infinity : is_lim (fun r => r ^ 2 * u r z) p_infty (PI / 2).
Proof.
  apply (by_reciprocal _ _ _ sine_limit). intros r Hr. pose proof (bottom_above r Hr) as B. unfold u, bottom_e in *.
  destruct (angles r) as [-> ->]. set (c := cosh _ + cos _) in *. field. repeat split; lra.
Qed.

Lemma u_falls : is_lim (fun r => r * u r z) p_infty 0.
Proof.
  apply (by_reciprocal _ (fun e => e * (sin (PI * w z * e) / (e - 0) / (w z * bottom_e z e)))).
  - replace 0 with (0 * (PI / 2)) at 2 by ring. apply (product_limit (fun e => e)); [apply is_lim_id | exact sine_limit].
  - intros r Hr. pose proof (bottom_above r Hr) as B. unfold u, bottom_e in *.
    destruct (angles r) as [-> ->]. set (c := cosh _ + cos _) in *. field. repeat split; lra.
Qed.

Lemma g_at_infinity : is_lim (fun r => g r z) p_infty 0.
Proof.
  apply (by_reciprocal _ (fun e => (sinh (PI * z * e) - z / w z * sin (PI * w z * e)) / bottom_e z e)).
  - replace 0 with (0 / 2) at 2 by field. apply ratio_limit; [| exact bottom_limit_e | lra].
    apply limit_value; [unfold sinh; auto_derive; trivial | rewrite !Rmult_0_r, sinh_0, sin_0; ring].
  - intros r Hr. unfold g, bottom_e. destruct (angles r) as [-> ->]. reflexivity.
Qed.
End Mode.

Lemma scaled (f : R -> R) a rho : 0 < rho -> is_lim f p_infty (Finite a) -> is_lim (fun r => f (r * rho)) p_infty (Finite a).
Proof.
  intros Hr L. apply (is_lim_comp f (fun r => r * rho) p_infty a p_infty); [exact L | | exists 0; intros; discriminate].
  apply (is_lim_ext (fun r => rho * r)); [intros; ring|].
  replace p_infty with (Rbar_mult rho p_infty) at 2.
  - apply (is_lim_scal_l (fun r => r)), is_lim_id.
  - simpl. destruct (Rle_dec 0 rho) as [H|H]; [|lra]. destruct (Rle_lt_or_eq_dec 0 rho H); [reflexivity | lra].
Qed.

Lemma Sum_limit n (a c : nat -> R) (f : nat -> R -> R) : (forall i, (i < n)%nat -> is_lim (f i) p_infty (Finite (c i))) ->
  is_lim (fun r => Sum n (fun i => a i * f i r)) p_infty (Sum n (fun i => a i * c i)).
Proof.
  induction n; intros H; simpl; [apply is_lim_const|]. apply is_lim_plus'; [apply IHn; intros; apply H; lia|].
  apply (is_lim_scal_l (f n) (a n) p_infty (c n)), H. lia.
Qed.

Lemma square_limit (f : R -> R) p a : is_lim f p (Finite a) -> is_lim (fun e => f e ^ 2) p (a ^ 2).
Proof.
  intros L. apply (is_lim_ext (fun e => f e * f e)); [intros; ring|].
  replace (Finite (a ^ 2)) with (Rbar_mult a a) by (simpl; f_equal; ring). apply is_lim_mult; [exact L | exact L | exact I].
Qed.

Theorem sum_of_shares : Statements.sum_of_shares.
Proof.
  intros s Sc Al. pose proof (mobility_pos s Sc) as Mp. pose proof (mobility_alone s Sc Al) as Mo.
  split; unfold Rdiv; rewrite Sum_scal_r; [apply Rinv_r; lra|].
  assert (E : mass s (contact s) (contact s) * Sum (masses s) (fun i => shape s (contact s) i * shape s (loaded s) i)
    = delta (contact s) (loaded s)).
  { rewrite <- (complete_1 s Sc _ _ (Hj s Sc) (Hl s Sc)), <- Sum_scal. apply Sum_ext. intros i Hi.
    unfold MP. rewrite (Sum_single (masses s) (contact s) (fun c => mass s (contact s) c * shape s c i));
      [ring | apply Hj, Sc | intros c Hc Hcj; rewrite Al by assumption; ring]. }
  rewrite <- E. replace (/ mobility s) with (mass s (contact s) (contact s)); [ring|].
  apply (Rmult_eq_reg_r (mobility s)); [rewrite Mo; field; lra | lra].
Qed.

Theorem eq_86_all_masses : Statements.eq_86_all_masses.
Proof.
  intros n a b rho zeta mu Hm Ha Hmodes. pose proof PI_RGT_0 as P.
  assert (Lim : forall a0 (f : R -> R -> R) c, (forall z, 0 <= z < 1 -> is_lim (fun r => f r z) p_infty (Finite c)) ->
    is_lim (fun r => Sum n (fun i => a0 i * f (r * rho i) (zeta i))) p_infty (Sum n a0 * c)).
  { intros a0 f c H. rewrite <- Sum_scal_r. apply (Sum_limit n a0 (fun _ => c) (fun i r => f (r * rho i) (zeta i))). intros i
    Hi. destruct (Hmodes i Hi) as [Hr Hz].
    apply (scaled (fun r => f r (zeta i))); [exact Hr | apply H, Hz]. }
  assert (L1 := Lim b (fun r z => r ^ 2 * v_re r z) _ (fun z Hz => proj1 (v_at_infinity z Hz))).
  assert (L2 := Lim b (fun r z => r ^ 2 * v_im r z) _ (fun z Hz => proj2 (v_at_infinity z Hz))).
  assert (L3 := Lim a (fun r z => r ^ 2 * u r z) _ u_at_infinity).
  assert (L4 := Lim a (fun r z => g r z + 2 * z * (r * u r z)) 0).
  assert (L5 : forall z, 0 <= z < 1 -> is_lim (fun r => g r z + 2 * z * (r * u r z)) p_infty 0).
  { intros z Hz. assert (X : is_lim (fun r => g r z + 2 * z * (r * u r z)) p_infty (0 + 2 * z * 0)).
    { apply is_lim_plus'; [apply g_at_infinity|].
      apply (is_lim_scal_l (fun r => r * u r z) (2 * z) p_infty 0), u_falls, Hz. }
    replace (0 + 2 * z * 0) with 0 in X by ring. exact X. }
  specialize (L4 L5). cbv beta in L1, L2, L3, L4. rewrite Ha in L3, L4. set (c := Sum n b) in *.
  assert (LN := is_lim_plus' _ _ _ _ _ (square_limit _ _ _ L1) (square_limit _ _ _ L2)).
  assert (LD := is_lim_plus' _ _ _ _ _ (square_limit _ _ _ L3)
    (square_limit _ _ _ (is_lim_plus' _ _ _ _ _ L4 (is_lim_const mu p_infty)))).
  assert (Nz : (1 * (PI / 2)) ^ 2 + (1 * 0 + mu) ^ 2 <> 0) by (apply Rgt_not_eq; nra).
  assert (LQ : is_lim (fun r => (Sum n (fun i => b i * ((r * rho i) ^ 2 * v_re (r * rho i) (zeta i))) ^ 2
      + Sum n (fun i => b i * ((r * rho i) ^ 2 * v_im (r * rho i) (zeta i))) ^ 2) /
    (Sum n (fun i => a i * ((r * rho i) ^ 2 * u (r * rho i) (zeta i))) ^ 2
      + (Sum n (fun i => a i * (g (r * rho i) (zeta i) + 2 * zeta i * (r * rho i * u (r * rho i) (zeta i)))) + mu) ^ 2)) p_infty
    (((c * -1) ^ 2 + (c * 0) ^ 2) / ((1 * (PI / 2)) ^ 2 + (1 * 0 + mu) ^ 2))).
  { pose proof (is_lim_div _ _ p_infty _ _ LN LD) as Q. simpl in Q.
    apply Q; [intros K; injection K as K; apply Nz; simpl; lra | exact I]. }
  pose proof (is_lim_comp_continuous _ sqrt p_infty _ LQ (continuous_sqrt _)) as LC.
  assert (Q : 0 < 4 * mu ^ 2 + PI ^ 2) by nra. pose proof (sqrt_lt_R0 _ Q) as Qs.
  replace (Rabs c * (2 / sqrt (4 * mu ^ 2 + PI ^ 2))) with (sqrt (((c * -1) ^ 2 + (c * 0) ^ 2) / ((1 * (PI / 2)) ^ 2 + (1 * 0 +
    mu)
    ^ 2))); [exact LC|].
  replace (((c * -1) ^ 2 + (c * 0) ^ 2) / ((1 * (PI / 2)) ^ 2 + (1 * 0 + mu) ^ 2))
    with ((Rabs c * (2 / sqrt (4 * mu ^ 2 + PI ^ 2))) * (Rabs c * (2 / sqrt (4 * mu ^ 2 + PI ^ 2)))).
  - apply sqrt_square, Rmult_le_pos; [apply Rabs_pos | apply Rlt_le, Rdiv_lt_0_compat; lra].
  - replace (Rabs c * (2 / sqrt (4 * mu ^ 2 + PI ^ 2)) * (Rabs c * (2 / sqrt (4 * mu ^ 2 + PI ^ 2))))
      with (Rabs c ^ 2 * (4 / (sqrt (4 * mu ^ 2 + PI ^ 2) * sqrt (4 * mu ^ 2 + PI ^ 2)))) by (field; lra).
    rewrite sqrt_sqrt, pow2_abs by lra. field. repeat split; nra.
Qed.

(* One mass is the mode whose share is 1. *)
Lemma single_by_shares mu z r : 0 < r ->
  limit_of_single_mass mu z r = limit_by_shares 1%nat (fun _ => 1) (fun _ => 1) (fun _ => r) (fun _ => z) mu.
Proof.
  intros Hr. unfold limit_of_single_mass, limit_by_shares, v_abs. cbn [Sum]. f_equal.
  rewrite <- Rsqr_pow2, Rsqr_sqrt by (apply Rplus_le_le_0_compat; apply pow2_ge_0).
  set (V1 := v_re r z). set (V2 := v_im r z). set (U := u r z). set (G := g r z).
  replace (U ^ 2 + (/ r ^ 2 * (G + 2 * z * r * U) + mu / r ^ 2) ^ 2)
    with (/ r ^ 4 * ((0 + 1 * (r ^ 2 * U)) ^ 2 + (0 + 1 * (G + 2 * z * (r * U)) + mu) ^ 2)) by (field; lra).
  replace ((0 + 1 * (r ^ 2 * V1)) ^ 2 + (0 + 1 * (r ^ 2 * V2)) ^ 2) with (r ^ 4 * (V1 ^ 2 + V2 ^ 2)) by ring.
  set (X := (0 + 1 * (r ^ 2 * U)) ^ 2 + _). unfold Rdiv. rewrite Rinv_mult, Rinv_inv. ring.
Qed.

Theorem eq_86 : Statements.eq_86.
Proof.
  intros mu z Hm Hz.
  assert (L := eq_86_all_masses 1%nat (fun _ => 1) (fun _ => 1) (fun _ => 1) (fun _ => z) mu Hm ltac:(simpl; ring)
    ltac:(intros; lra)).
  cbn [Sum] in L. rewrite Rplus_0_l, Rabs_R1, Rmult_1_l in L.
  apply (is_lim_ext_loc _ (limit_of_single_mass mu z) p_infty (2 / sqrt (4 * mu ^ 2 + PI ^ 2))) in L; [exact L|].
  exists 0. intros r Hr. rewrite single_by_shares by exact Hr. unfold limit_by_shares. rewrite Rmult_1_r. reflexivity.
Qed.
Theorem eq_86_as_printed : Statements.eq_86_as_printed.
Proof.
  intros H. specialize (H 2 0 ltac:(lra) ltac:(lra)). pose proof (eq_86 2 0 ltac:(lra) ltac:(lra)) as E. pose proof PI_RGT_0 as P.
  assert (X : 2 / sqrt (4 * 2 + PI ^ 2) = 2 / sqrt (4 * 2 ^ 2 + PI ^ 2)).
  { apply (one_limit (limit_of_single_mass 2 0) p_infty); [exact H | exact E]. }
  assert (A : 0 < 4 * 2 + PI ^ 2) by nra. assert (B : 0 < 4 * 2 ^ 2 + PI ^ 2) by nra.
  assert (C : sqrt (4 * 2 + PI ^ 2) < sqrt (4 * 2 ^ 2 + PI ^ 2)) by (apply sqrt_lt_1_alt; lra).
  pose proof (sqrt_lt_R0 _ A). pose proof (sqrt_lt_R0 _ B). set (p := sqrt (4 * 2 + PI ^ 2)) in *. set (q := sqrt (4 * 2 ^ 2 +
    PI ^ 2)) in *.
  assert (2 * q = 2 * p); [|lra]. transitivity (2 / p * (p * q)); [field; lra|]. rewrite X. field; lra.
Qed.
