(* The orders of the errors at a resonance: (76)-(80), (83)-(85), for any number of masses. *)
Require Import Reals Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes SteadyMode Sums Masses Contact ContactMotion Misprints Limits.
Open Scope R_scope.

(* ---- What is of the order of zeta^n ---- *)
Lemma near_zero_order n (f h : R -> R) e : 0 < e -> (forall z, 0 < z < e -> f z = h z) -> of_order n f -> of_order n h.
Proof.
  intros He E [B [e0 [H0 H]]]. exists B, (Rmin e e0). split; [apply Rmin_glb_lt; assumption|].
  intros z Hz. pose proof (Rmin_l e e0). pose proof (Rmin_r e e0). rewrite <- E by lra. apply H. lra.
Qed.
Lemma same_order n (f h : R -> R) : (forall z, 0 < z -> f z = h z) -> of_order n f -> of_order n h.
Proof. intros E. apply (near_zero_order n f h 1); [lra|]. intros z Hz. apply E. lra. Qed.
Lemma order_plus n f h : of_order n f -> of_order n h -> of_order n (fun z => f z + h z).
Proof.
  intros [B [e [He H]]] [B' [e' [He' H']]]. exists (B + B'), (Rmin e e'). split; [apply Rmin_glb_lt; assumption|].
  intros z Hz. pose proof (Rmin_l e e'). pose proof (Rmin_r e e'). specialize (H z ltac:(lra)). specialize (H' z ltac:(lra)).
  pose proof (Rabs_triang (f z) (h z)). lra.
Qed.
Lemma order_mult n m f h : of_order n f -> of_order m h -> of_order (n + m) (fun z => f z * h z).
Proof.
  intros [B [e [He H]]] [B' [e' [He' H']]]. exists (B * B'), (Rmin e e'). split; [apply Rmin_glb_lt; assumption|].
  intros z Hz. pose proof (Rmin_l e e'). pose proof (Rmin_r e e'). specialize (H z ltac:(lra)). specialize (H' z ltac:(lra)).
  rewrite Rabs_mult, pow_add. replace (B * B' * (z ^ n * z ^ m)) with (B * z ^ n * (B' * z ^ m)) by ring.
  apply Rmult_le_compat; (apply Rabs_pos || assumption).
Qed.
Lemma order_const c : of_order 0 (fun _ => c).
Proof. exists (Rabs c), 1. split; [lra|]. intros z _. simpl. lra. Qed.
Lemma order_power n : of_order n (fun z => z ^ n).
Proof. exists 1, 1. split; [lra|]. intros z Hz. rewrite Rabs_right by (apply Rle_ge, pow_le; lra). lra. Qed.
Lemma order_id : of_order 1 (fun z => z).
Proof. apply (same_order 1 (fun z => z ^ 1)); [intros; ring | apply order_power]. Qed.
Lemma order_scal n c f : of_order n f -> of_order n (fun z => c * f z).
Proof. apply (order_mult 0 n (fun _ => c)), order_const. Qed.
Lemma order_minus n f h : of_order n f -> of_order n h -> of_order n (fun z => f z - h z).
Proof.
  intros A B. apply (same_order n (fun z => f z + -1 * h z)); [intros; ring|]. apply order_plus; [exact A | apply order_scal, B].
Qed.
Lemma order_weaker n m f : (m <= n)%nat -> of_order n f -> of_order m f.
Proof.
  intros L [B [e [He H]]]. exists (Rabs B), (Rmin e 1). split; [apply Rmin_glb_lt; lra|].
  intros z Hz. pose proof (Rmin_l e 1). pose proof (Rmin_r e 1). apply Rle_trans with (1 := H z ltac:(lra)).
  replace n with (m + (n - m))%nat by lia. rewrite pow_add.
  assert (0 < z ^ m) by (apply pow_lt; lra). assert (0 <= z ^ (n - m) <= 1).
  { split; [apply pow_le; lra|]. rewrite <- (pow1 (n - m)). apply pow_incr. lra. }
  pose proof (Rle_abs B). pose proof (Rabs_pos B).
  apply Rle_trans with (Rabs B * (z ^ m * z ^ (n - m))); [apply Rmult_le_compat_r; nra | apply Rmult_le_compat_l; nra].
Qed.
Lemma order_Sum n m (f : nat -> R -> R) : (forall i, (i < m)%nat -> of_order n (f i)) -> of_order n (fun z => Sum m (fun i => f
  i z)).
Proof.
  induction m; intros H; simpl.
  - apply (order_weaker n n); [lia|]. apply (same_order n (fun z => 0 * z ^ n)); [intros; ring | apply order_scal, order_power].
  - apply order_plus; [apply IHm; intros; apply H; lia | apply H; lia].
Qed.
(* Dividing by zeta, and multiplying with it *)
Lemma order_divided n f : of_order (S n) f -> of_order n (fun z => f z / z).
Proof.
  intros [B [e [He H]]]. exists B, e. split; [exact He|]. intros z Hz. specialize (H z Hz).
  unfold Rdiv. rewrite Rabs_mult, Rabs_Rinv, (Rabs_right z) by lra. apply (Rmult_le_reg_r z); [lra|].
  rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. simpl in H. lra.
Qed.
Lemma order_times n f : of_order n (fun z => f z / z) -> of_order (S n) f.
Proof.
  intros H. apply (same_order (S n) (fun z => z * (f z / z))); [intros; field; lra|]. apply (order_mult 1 n); [apply order_id |
    exact H].
Qed.
(* What has a limit is bounded. *)
Lemma order_of_limit (f : R -> R) l : filterlim f (at_right 0) (locally l) -> of_order 0 f.
Proof.
  intros L. assert (P : locally l (fun y => Rabs (y - l) < 1)).
  { exists (mkposreal 1 Rlt_0_1). intros y Hy. exact Hy. }
  destruct (L _ P) as [e He]. exists (Rabs l + 1), e. split; [apply cond_pos|]. intros z Hz. simpl. rewrite Rmult_1_r.
  assert (A : Rabs (f z - l) < 1).
  { apply He; [|lra]. change (Rabs (z - 0) < e). rewrite Rminus_0_r, Rabs_right; lra. }
  pose proof (Rabs_triang (f z - l) l) as T. replace (f z - l + l) with (f z) in T by ring. lra.
Qed.
Lemma order_of_lim (f : R -> R) l : is_lim f 0 (Finite l) -> of_order 0 f.
Proof. intros L. apply (order_of_limit f l), from_the_right, L. Qed.
Lemma order_of_zero (f : R -> R) : ex_derive f 0 -> f 0 = 0 -> of_order 1 f.
Proof.
  intros [A D] Z. apply order_times, (order_of_lim _ A).
  apply (is_lim_ext (fun z => f z / (z - 0))); [intros; rewrite Rminus_0_r; reflexivity|]. apply slope_limit; assumption.
Qed.
(* Reciprocals and roots of what is a constant but for terms of the order of zeta^n *)
Lemma order_away n f c : of_order (S n) (fun z => f z - c) -> 0 < c -> exists e, 0 < e /\ forall z, 0 < z < e -> c / 2 < f z.
Proof.
  intros A Hc. apply (order_weaker (S n) 1) in A; [|lia]. destruct A as [B [e [He H]]]. pose proof (Rabs_pos B).
  assert (Q : 0 < c / (2 * (Rabs B + 1))) by (apply Rdiv_lt_0_compat; lra).
  exists (Rmin e (c / (2 * (Rabs B + 1)))). split; [apply Rmin_glb_lt; assumption|].
  intros z Hz. pose proof (Rmin_l e (c / (2 * (Rabs B + 1)))). pose proof (Rmin_r e (c / (2 * (Rabs B + 1)))).
  specialize (H z ltac:(lra)). rewrite pow_1 in H. pose proof (Rle_abs B). apply Rabs_le_between in H.
  assert (z * (2 * (Rabs B + 1)) < c).
  { apply Rlt_le_trans with (c / (2 * (Rabs B + 1)) * (2 * (Rabs B + 1))); [apply Rmult_lt_compat_r; lra | right; field; lra]. }
  assert (B * z <= Rabs B * z) by (apply Rmult_le_compat_r; lra). nra.
Qed.
Lemma order_bounded_below n f c : 0 < c -> (exists e, 0 < e /\ forall z, 0 < z < e -> c <= f z) -> forall h, of_order n h ->
  of_order n (fun z => h z / f z).
Proof.
  intros Hc [e [He H]] h [B [e' [He' H']]]. exists (B / c), (Rmin e e'). split; [apply Rmin_glb_lt; assumption|].
  intros z Hz. pose proof (Rmin_l e e'). pose proof (Rmin_r e e'). specialize (H z ltac:(lra)). specialize (H' z ltac:(lra)).
  unfold Rdiv. rewrite Rabs_mult, Rabs_Rinv, (Rabs_right (f z)) by lra.
  apply Rle_trans with (B * z ^ n * / f z); [apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat; lra | lra]|].
  replace (B * / c * z ^ n) with (B * z ^ n * / c) by ring. apply Rmult_le_compat_l; [|apply Rinv_le_contravar; lra].
  apply Rle_trans with (2 := H'), Rabs_pos.
Qed.
Lemma order_inverse n f c : 0 < c -> of_order (S n) (fun z => f z - c) -> of_order (S n) (fun z => / f z - / c).
Proof.
  intros Hc A. destruct (order_away n f c A Hc) as [e [He H]].
  apply (near_zero_order (S n) (fun z => - / c * ((f z - c) / f z)) _ e He); [intros z Hz; specialize (H z Hz); field; lra|].
  apply order_scal, (order_bounded_below (S n) f (c / 2)); [lra | | exact A].
  exists e. split; [exact He|]. intros z Hz. left. apply H, Hz.
Qed.
Lemma order_root n f c : 0 < c -> of_order (S n) (fun z => f z - c ^ 2) -> of_order (S n) (fun z => sqrt (f z) - c).
Proof.
  intros Hc A. assert (C2 : 0 < c ^ 2) by nra. destruct (order_away n f (c ^ 2) A C2) as [e [He H]].
  apply (near_zero_order (S n) (fun z => (f z - c ^ 2) / (sqrt (f z) + c)) _ e He).
  - intros z Hz. specialize (H z Hz). pose proof (sqrt_pos (f z)). pose proof (sqrt_sqrt (f z) ltac:(lra)) as Q.
    rewrite <- Q at 1. field. lra.
  - apply (order_bounded_below (S n) (fun z => sqrt (f z) + c) c); [exact Hc | | exact A].
    exists 1. split; [lra|]. intros z _. pose proof (sqrt_pos (f z)). lra.
Qed.
(* What is a constant but for terms of some order, for products *)
Lemma order_product n f h a b : of_order n (fun z => f z - a) -> of_order n (fun z => h z - b) ->
  of_order n (fun z => f z * h z - a * b).
Proof.
  intros A B. apply (same_order n (fun z => (f z - a) * (h z - b) + (b * (f z - a) + a * (h z - b)))); [intros; ring|].
  apply order_plus; [apply (order_weaker (n + n) n); [lia | apply order_mult; assumption] |].
  apply order_plus; apply order_scal; assumption.
Qed.
Lemma order_zero_const n (f : R -> R) a : (forall z, 0 < z -> f z = a) -> of_order n (fun z => f z - a).
Proof.
  intros H. apply (same_order n (fun z => 0 * z ^ n)); [intros z Hz; rewrite H by exact Hz; ring | apply order_scal, order_power].
Qed.

(* ---- One mode at R_i = 1 ---- *)
(* 1 + cos(pi w) is of fourth order. *)
Lemma cosine_limit : is_lim (fun z => (1 + cos (PI * w z)) / z ^ 4) 0 (PI ^ 2 / 8).
Proof.
  pose proof PI_RGT_0 as P. replace (PI ^ 2 / 8) with (PI / 2 * (PI / 2) / 2) by field.
  apply (near_zero (fun z => top z / z ^ 2 * (top z / z ^ 2) / (1 - cos (PI * w z)))).
  - intros z H H0. pose proof (w_near z H) as Hw. assert (w z <= 1).
    { unfold w. rewrite <- sqrt_1 at 2. apply sqrt_le_1_alt. pose proof (pow2_ge_0 z). lra. }
    assert (cos (PI * w z) < cos 0) by (apply cos_decreasing_1; nra). rewrite cos_0 in *. unfold top.
    pose proof (sin2_cos2 (PI * w z)) as T. unfold Rsqr in T. set (c := cos _) in *. set (d := sin _) in *.
    replace (d / z ^ 2 * (d / z ^ 2)) with (d * d / z ^ 4) by (field; exact H0). replace (d * d) with ((1 + c) * (1 - c)) by lra.
    field. split; lra.
  - apply ratio_limit; [apply product_limit; apply top_limit | | lra].
    apply limit_value; [auto_derive; exact (proj1 (w_derivatives 0 ltac:(rewrite Rabs_R0; lra)))|].
    rewrite w_0, Rmult_1_r, cos_PI. ring.
Qed.
Lemma second_function_limit : is_lim (fun z => z * second_function_at_resonance z) 0 (2 / PI).
Proof.
  pose proof PI_RGT_0 as P. replace (2 / PI) with (PI / (PI ^ 2 / 2)) by (field; lra).
  apply (not_at_zero (fun z => sinh (z * PI) / z / ((cosh (z * PI) - 1) / z ^ 2))).
  - intros z H. pose proof (cosh_not_one z H). unfold second_function_at_resonance. field. split; assumption.
  - apply ratio_limit; [apply sinh_limit | apply cosh_limit | nra].
Qed.
Lemma eq_79_both_sides : is_lim (fun z => (g 1 z / second_function_at_resonance z - 1) / z ^ 2) 0 (- (3 / 4)).
Proof.
  pose proof PI_RGT_0 as P. replace (- (3 / 4)) with ((-1 * (PI * (PI ^ 2 / 8)) + -1 / 1 * (PI / 2 * (PI ^ 2 / 2))) / (PI * (PI
    ^ 2 / 2)))
    by (field; lra).
  apply (near_zero (fun z => (-1 * (sinh (z * PI) / z * ((1 + cos (PI * w z)) / z ^ 4))
    + -1 / w z * (top z / z ^ 2 * ((cosh (z * PI) - 1) / z ^ 2))) / (sinh (z * PI) / z * (bottom z / z ^ 2)))).
  - intros z H H0. pose proof (w_near z H). pose proof (bottom_not_zero z H0) as B. pose proof (sinh_not_zero z H0).
    pose proof (cosh_not_one z H0). unfold g, theta, decay, second_function_at_resonance, top, bottom in *.
    replace (PI * w z / 1) with (PI * w z) by field. replace (PI * z / 1) with (z * PI) by field. field. repeat split; try lra;
      assumption.
  - apply ratio_limit; [| apply product_limit; [apply sinh_limit | apply bottom_limit] | apply Rgt_not_eq, Rmult_lt_0_compat;
    nra].
    apply is_lim_plus'; apply product_limit.
    + apply is_lim_const.
    + apply product_limit; [apply sinh_limit | apply cosine_limit].
    + apply ratio_limit; [apply is_lim_const | apply w_limit | lra].
    + apply product_limit; [apply top_limit | apply cosh_limit].
Qed.
Theorem eq_79 : Statements.eq_79.
Proof. apply from_the_right, eq_79_both_sides. Qed.
(* (29) at R_i = 1 less (79) *)
Lemma g_at_resonance : of_order 1 (fun z => g 1 z - second_function_at_resonance z).
Proof.
  pose proof PI_RGT_0 as P.
  apply (same_order 1 (fun z => z * ((g 1 z / second_function_at_resonance z - 1) / z ^ 2 * (z * second_function_at_resonance
    z)))).
  - intros z H. pose proof (sinh_not_zero z ltac:(lra)). pose proof (cosh_not_one z ltac:(lra)). unfold
    second_function_at_resonance.
    field. repeat split; try lra; assumption.
  - apply (order_mult 1 0); [apply order_id | apply (order_mult 0 0)].
    + apply (order_of_lim _ (- (3 / 4))), eq_79_both_sides.
    + apply (order_of_lim _ (2 / PI)), second_function_limit.
Qed.

Theorem eq_84 : Statements.eq_84.
Proof.
  intros b. pose proof PI_RGT_0 as P.
  set (q := fun z => 1 - 4 * b ^ 2 * (z * u 1 z) ^ 2).
  set (H := fun z => -2 * b ^ 2 * (u 1 z * u 1 z) / (1 + sqrt (q z))
    - b * ((g 1 z / second_function_at_resonance z - 1) / z ^ 2 * (z * second_function_at_resonance z))).
  assert (Lu := u_at_resonance). assert (Q : is_lim q 0 1).
  { replace 1 with (1 - 4 * b ^ 2 * (0 * / PI * (0 * / PI))) by ring. unfold q.
    apply is_lim_minus'; [apply is_lim_const|]. apply product_limit; [apply is_lim_const|].
    apply (is_lim_ext (fun z => z * u 1 z * (z * u 1 z))); [intros; ring|].
    apply product_limit; apply (product_limit (fun z => z)); (apply is_lim_id || exact Lu). }
  assert (LH : is_lim H 0 (3 * b / (2 * PI) - b ^ 2 / PI ^ 2)).
  { replace (3 * b / (2 * PI) - b ^ 2 / PI ^ 2) with (-2 * b ^ 2 * (/ PI * / PI) / (1 + sqrt 1) - b * (- (3 / 4) * (2 / PI)))
      by (rewrite sqrt_1; field; lra).
    apply is_lim_minus'.
    - apply ratio_limit; [| | rewrite sqrt_1; lra].
      + apply product_limit; [apply is_lim_const | apply product_limit; exact Lu].
      + apply is_lim_plus'; [apply is_lim_const|]. apply (is_lim_comp_continuous q sqrt 0 1 Q), continuous_sqrt.
    - apply product_limit; [apply is_lim_const|]. apply product_limit; [apply eq_79_both_sides | apply second_function_limit]. }
  apply from_the_right in LH. eapply filterlim_ext_loc; [|exact LH].
  assert (A : of_order 2 (fun z => q z - 1)).
  { apply (same_order 2 (fun z => -4 * b ^ 2 * (z * u 1 z * (z * u 1 z)))); [intros; unfold q; ring|]. apply order_scal.
    apply (order_mult 1 1); apply (order_mult 1 0 (fun z => z)); (apply order_id || apply (order_of_lim _ (/ PI)), Lu). }
  destruct (order_away 1 q 1 A ltac:(lra)) as [e [He B]]. exists (mkposreal e He). intros z Hz Hp.
  change (Rabs (z - 0) < e) in Hz. rewrite Rminus_0_r, Rabs_right in Hz by lra. specialize (B z ltac:(lra)).
  destruct (single_values 1 z b) as [E1 [E2 [E3 [E4 _]]]]. unfold H, X_j, root. rewrite V_abs_sq, E1, E2, E3, E4.
  change (friction (single_mass 1 z b)) with b.
  assert (R : sqrt ((1 ^ 2 * v_re 1 z) ^ 2 + (1 ^ 2 * v_im 1 z) ^ 2 - (b * (1 ^ 2 * u 1 z)) ^ 2) = sqrt (q z) / (2 * z)).
  { replace (_ - _) with ((/ (2 * z)) ^ 2 * q z).
    - rewrite sqrt_mult, sqrt_pow2 by (try apply pow2_ge_0; try (apply Rlt_le, Rinv_0_lt_compat); lra). field. lra.
    - unfold q. destruct (eq_76_77 z Hp) as [-> [-> _]]. field. lra. }
  rewrite R. pose proof (sqrt_sqrt (q z) ltac:(lra)) as S. pose proof (sqrt_pos (q z)) as S0.
  pose proof (sinh_not_zero z ltac:(lra)). pose proof (cosh_not_one z ltac:(lra)).
  assert (C : second_function_at_resonance z <> 0).
  { unfold second_function_at_resonance. apply Rmult_integral_contrapositive. split; [assumption | apply Rinv_neq_0_compat;
    assumption]. }
  set (c := second_function_at_resonance z) in *. set (r := sqrt (q z)) in *.
  replace (-2 * b ^ 2 * (u 1 z * u 1 z) / (1 + r)) with ((r - 1) / (2 * z ^ 2)).
  - field. repeat split; lra.
  - replace (-2 * b ^ 2 * (u 1 z * u 1 z)) with ((r * r - 1) / (2 * z ^ 2)) by (rewrite S; unfold q; field; lra). field. split;
    lra.
Qed.

(* ---- The other modes ---- *)
Section Other_mode.
Variables r c : R.
Hypothesis Hr : 0 < r.
Hypothesis Off : 1 + cos (PI / r) <> 0.
Lemma not_resonant : 1 - r * r <> 0.
Proof.
  intros E. apply Off. assert (r = 1) by nra. subst. replace (PI / 1) with PI by field. rewrite cos_PI. ring.
Qed.
Lemma scaled_derivable (f : R -> R) : ex_derive f 0 -> ex_derive (fun z => f (c * z)) 0.
Proof.
  intros D. apply (ex_derive_comp f (fun z => c * z) 0); [rewrite Rmult_0_r; exact D|]. auto_derive. trivial.
Qed.
Lemma order_scaled (f : R -> R) : ex_derive f 0 -> f 0 = 0 -> of_order 1 (fun z => f (c * z)).
Proof. intros D Z. apply order_of_zero; [apply scaled_derivable, D | rewrite Rmult_0_r; exact Z]. Qed.
Lemma bounded_scaled (f : R -> R) : ex_derive f 0 -> of_order 0 (fun z => f (c * z)).
Proof.
  intros D. apply (order_of_lim _ (f (c * 0))). apply limit_value; [apply scaled_derivable, D | reflexivity].
Qed.
Lemma other_g : of_order 1 (fun z => g r (c * z)).
Proof.
  apply order_scaled; [|apply g_0]. unfold g, cosh, sinh, theta, decay, w. auto_derive.
  replace (1 + - (0 * 0)) with 1 by ring. rewrite sqrt_1. replace (PI * 0 * / r) with 0 by ring. replace (PI * 1 * / r) with
    (PI / r) by (unfold Rdiv; ring).
  rewrite Ropp_0, exp_0. repeat split; lra.
Qed.
Lemma other_u : of_order 0 (fun z => u r (c * z)).
Proof.
  apply bounded_scaled. unfold u, cosh, theta, decay, w. auto_derive.
  replace (1 + - (0 * 0)) with 1 by ring. rewrite sqrt_1. replace (PI * 0 * / r) with 0 by ring. replace (PI * 1 * / r) with
    (PI / r) by (unfold Rdiv; ring).
  rewrite Ropp_0, exp_0. repeat split; try lra.
  apply Rmult_integral_contrapositive. split; [lra|]. replace ((1 + 1) * / 2) with 1 by field. exact Off.
Qed.
Lemma other_v_re : of_order 0 (fun z => v_re r (c * z)).
Proof.
  pose proof not_resonant as N. apply bounded_scaled. unfold v_re. auto_derive.
  replace (2 * 0 * r) with 0 by ring. pose proof (pow2_ge_0 (1 - r * r)). intros E. apply N. simpl in E. nra.
Qed.
Lemma other_v_im : of_order 1 (fun z => v_im r (c * z)).
Proof.
  pose proof not_resonant as N. apply order_scaled; [|unfold v_im, Rdiv; ring]. unfold v_im. auto_derive.
  replace (2 * 0 * r) with 0 by ring. intros E. apply N. simpl in E. nra.
Qed.
End Other_mode.

(* A sum over the modes in which one is at its resonance *)
Lemma order_of_sum n N p (f : nat -> R -> R) h : (p < N)%nat -> of_order n (fun z => f p z - h z) ->
  (forall i, (i < N)%nat -> i <> p -> of_order n (f i)) -> of_order n (fun z => Sum N (fun i => f i z) - h z).
Proof.
  intros Hp A B. apply (same_order n (fun z => Sum N (fun i => f i z - delta i p * h z))).
  - intros z _. rewrite Sum_minus. f_equal. apply (Sum_delta N p (fun _ => h z) Hp).
  - apply order_Sum. intros i Hi. destruct (Nat.eq_dec i p) as [->|D].
    + apply (same_order n (fun z => f p z - h z)); [intros; rewrite delta_same; ring | exact A].
    + apply (same_order n (f i)); [intros; rewrite delta_other by exact D; ring | apply B; assumption].
Qed.

(* What tends to a number is above any smaller one near zeta = 0, and below any larger one. *)
Lemma above_near_zero (f : R -> R) l a : is_lim f 0 (Finite l) -> a < l -> exists e, 0 < e /\ forall z, 0 < z < e -> a < f z.
Proof.
  intros L H. apply is_lim_spec in L. destruct (L (mkposreal (l - a) ltac:(lra))) as [e He]. exists e. split; [apply cond_pos|].
  intros z Hz. assert (A : Rabs (f z - l) < l - a).
  { apply He; [|lra]. change (Rabs (z - 0) < e). rewrite Rminus_0_r, Rabs_right; lra. }
  apply Rabs_lt_between in A. lra.
Qed.

(* The root of a square of something positive, changed a little *)
Lemma order_root_near n E m m0 : 0 < m0 -> (exists e, 0 < e /\ forall z, 0 < z < e -> m0 < m z) ->
  of_order (S n) (fun z => E z - m z ^ 2) -> of_order (S n) (fun z => sqrt (E z) - m z).
Proof.
  intros Hm [e1 [He1 M]] A.
  assert (A' : of_order (S n) (fun z => E z - m z ^ 2 + m0 ^ 2 - m0 ^ 2)) by
    (apply (same_order _ (fun z => E z - m z ^ 2)); [intros; ring | exact A]).
  destruct (order_away n (fun z => E z - m z ^ 2 + m0 ^ 2) (m0 ^ 2) A' ltac:(nra)) as [e2 [He2 Q]].
  assert (He : 0 < Rmin e1 e2) by (apply Rmin_glb_lt; assumption).
  apply (near_zero_order (S n) (fun z => (E z - m z ^ 2) / (sqrt (E z) + m z)) _ (Rmin e1 e2) He).
  - intros z Hz. pose proof (Rmin_l e1 e2). pose proof (Rmin_r e1 e2). specialize (M z ltac:(lra)). specialize (Q z ltac:(lra)).
    assert (0 <= E z) by nra. pose proof (sqrt_pos (E z)). pose proof (sqrt_sqrt (E z) ltac:(lra)) as S.
    rewrite <- S at 1. field. lra.
  - apply (order_bounded_below (S n) (fun z => sqrt (E z) + m z) m0); [exact Hm | | exact A].
    exists e1. split; [exact He1|]. intros z Hz. pose proof (sqrt_pos (E z)). specialize (M z Hz). lra.
Qed.

Section At_resonance.
Variables (s : scene) (c : nat -> R) (p : nat).
Hypothesis Hs : at_resonance s c p.
Local Notation N := (masses s).
Local Notation psi := (shape s).
Local Notation j := (contact s).
Local Notation l := (loaded s).
Local Notation beta := (friction s).
Local Notation at_ z := (lightly_damped s c z).
Local Notation h z := (z * second_function_at_resonance z).

Lemma order_over_modes n a (f : R -> R -> R) (h : R -> R) : of_order n (fun z => a p * f 1 z - h z) ->
  (forall r k, 0 < r -> 1 + cos (PI / r) <> 0 -> of_order n (fun z => f r (k * z))) ->
  of_order n (fun z => Sum N (fun i => a i * f (ratio s i) (c i * z)) - h z).
Proof.
  intros A B. destruct Hs as [Hp [R1 [C1 Oth]]]. apply (order_of_sum n N p (fun i z => a i * f (ratio s i) (c i * z))); [exact
    Hp | |].
  - rewrite R1, C1. apply (same_order n (fun z => a p * f 1 z - h z)); [intros; rewrite Rmult_1_l; reflexivity | exact A].
  - intros i Hi D. destruct (Oth i Hi) as [_ [Hr O]]. apply order_scal, B; [exact Hr | apply O, D].
Qed.
Lemma order_over_modes_0 n a (f : R -> R -> R) : of_order n (fun z => f 1 z) ->
  (forall r k, 0 < r -> 1 + cos (PI / r) <> 0 -> of_order n (fun z => f r (k * z))) ->
  of_order n (fun z => Sum N (fun i => a i * f (ratio s i) (c i * z))).
Proof.
  intros A B. apply (same_order n (fun z => Sum N (fun i => a i * f (ratio s i) (c i * z)) - 0)); [intros; ring|].
  apply (order_over_modes n a f (fun _ => 0)); [|exact B].
  apply (same_order n (fun z => a p * f 1 z)); [intros; ring | apply order_scal, A].
Qed.

Lemma order_V_re k : of_order 0 (fun z => V_re (at_ z) k).
Proof.
  apply (same_order 0 (fun z => Sum N (fun i => (psi k i * psi l i * ratio s i ^ 2) * v_re (ratio s i) (c i * z))));
    [reflexivity|].
  apply (order_over_modes_0 0 _ v_re); [|intros; apply other_v_re; assumption].
  apply (same_order 0 (fun _ => 0)); [intros z Hz; symmetry; apply eq_76_77, Hz | apply order_const].
Qed.
Lemma order_V_im k : of_order 1 (fun z => V_im (at_ z) k + psi k p * psi l p / (2 * z)).
Proof.
  destruct Hs as [Hp [R1 [C1 _]]].
  apply (same_order 1 (fun z => Sum N (fun i => (psi k i * psi l i * ratio s i ^ 2) * v_im (ratio s i) (c i * z))
    - - (psi k p * psi l p / (2 * z)))); [intros; unfold V_im; simpl; ring|].
  apply (order_over_modes 1 _ v_im (fun z => - (psi k p * psi l p / (2 * z)))); [|intros; apply other_v_im; assumption].
  apply (same_order 1 (fun z => 0 * z ^ 1)); [|apply order_scal, order_power].
  intros z Hz. rewrite R1. destruct (eq_76_77 z Hz) as [_ [-> _]]. field. lra.
Qed.
Lemma order_G k : of_order 1 (fun z => G (at_ z) k - psi k p * psi j p * second_function_at_resonance z).
Proof.
  destruct Hs as [Hp [R1 _]].
  apply (same_order 1 (fun z => Sum N (fun i => (psi k i * psi j i * ratio s i ^ 2) * g (ratio s i) (c i * z))
    - psi k p * psi j p * second_function_at_resonance z)); [reflexivity|].
  apply (order_over_modes 1 _ g (fun z => psi k p * psi j p * second_function_at_resonance z)); [|intros; apply other_g;
    assumption].
  apply (same_order 1 (fun z => (psi k p * psi j p) * (g 1 z - second_function_at_resonance z))); [intros; rewrite R1; ring|].
  apply order_scal, g_at_resonance.
Qed.
Lemma order_U k : of_order 0 (fun z => U (at_ z) k).
Proof.
  apply (same_order 0 (fun z => Sum N (fun i => (psi k i * psi j i * ratio s i ^ 2) * u (ratio s i) (c i * z)))); [reflexivity|].
  apply (order_over_modes_0 0 _ u); [apply (order_of_lim _ (/ PI)), u_at_resonance | intros; apply other_u; assumption].
Qed.
Lemma order_H : of_order 1 (fun z => H_j (at_ z) - psi j p ^ 2 * second_function_at_resonance z).
Proof.
  destruct Hs as [Hp [R1 _]].
  apply (same_order 1 (fun z => Sum N (fun i => psi j i ^ 2 * (fun r z => g r z + 2 * z * r * u r z) (ratio s i) (c i * z))
    - psi j p ^ 2 * second_function_at_resonance z)); [reflexivity|].
  apply (order_over_modes 1 _ (fun r z => g r z + 2 * z * r * u r z) (fun z => psi j p ^ 2 * second_function_at_resonance z)).
  - apply (same_order 1 (fun z => psi j p ^ 2 * (g 1 z - second_function_at_resonance z + z * (2 * u 1 z)))); [intros; ring|].
    apply order_scal, order_plus; [apply g_at_resonance|]. apply (order_mult 1 0 (fun z => z)); [apply order_id|].
    apply order_scal, (order_of_lim _ (/ PI)), u_at_resonance.
  - intros r k Hr O. apply order_plus; [apply other_g; assumption|].
    apply (same_order 1 (fun z => z * (2 * k * r * u r (k * z)))); [intros; ring|].
    apply (order_mult 1 0 (fun z => z)); [apply order_id|]. apply order_scal, other_u; assumption.
Qed.

(* The same times zeta *)
Lemma hat n f : of_order n f -> of_order (S n) (fun z => z * f z).
Proof. intros A. apply (order_mult 1 n (fun z => z)); [apply order_id | exact A]. Qed.
Lemma hat_V_abs_sq k : of_order 2 (fun z => (z * V_abs (at_ z) k) ^ 2 - (Rabs (psi k p * psi l p) / 2) ^ 2).
Proof.
  set (a := psi k p * psi l p).
  apply (same_order 2 (fun z => z * V_re (at_ z) k * (z * V_re (at_ z) k)
    + (z * (V_im (at_ z) k + a / (2 * z)) * (z * (V_im (at_ z) k + a / (2 * z))) - a * (z * (V_im (at_ z) k + a / (2 * z)))))).
  - intros z Hz. replace ((Rabs a / 2) ^ 2) with (a ^ 2 / 4) by (rewrite <- (pow2_abs a); field).
    rewrite Rpow_mult_distr, V_abs_sq. field. lra.
  - pose proof (hat 1 _ (order_V_im k)) as A. fold a in A. apply order_plus.
    + apply (order_mult 1 1); apply (hat 0), order_V_re.
    + apply order_minus; [|apply order_scal, A]. apply (order_weaker (2 + 2) 2); [lia|]. apply (order_mult 2 2); exact A.
Qed.
Lemma hat_V_abs k : psi k p * psi l p <> 0 -> of_order 2 (fun z => z * V_abs (at_ z) k - Rabs (psi k p * psi l p) / 2).
Proof.
  intros Ha. pose proof (Rabs_pos_lt _ Ha).
  apply (same_order 2 (fun z => sqrt ((z * V_abs (at_ z) k) ^ 2) - Rabs (psi k p * psi l p) / 2)).
  - intros z Hz. rewrite sqrt_pow2; [reflexivity|]. apply Rmult_le_pos; [lra | apply sqrt_pos].
  - apply (order_root 1); [lra | apply hat_V_abs_sq].
Qed.

(* A mass and a load that take part in the resonant mode *)
Hypothesis Hj : psi j p <> 0.
Hypothesis Hl : psi l p <> 0.
Let a k := psi k p * psi l p.
Let b k := psi k p * psi j p.
Let aj : a j <> 0. Proof. apply Rmult_integral_contrapositive. split; assumption. Qed.
Let ajp : 0 < Rabs (a j). Proof. apply Rabs_pos_lt, aj. Qed.

Lemma order_h : of_order 0 (fun z => h z).
Proof. apply (order_of_lim _ (2 / PI)), second_function_limit. Qed.
Lemma hat_G k : of_order 2 (fun z => z * G (at_ z) k - b k * h z).
Proof.
  apply (same_order 2 (fun z => z * (G (at_ z) k - b k * second_function_at_resonance z))); [intros; ring|].
  apply hat, order_G.
Qed.
Lemma hat_U k : of_order 1 (fun z => z * U (at_ z) k).
Proof. apply hat, order_U. Qed.
(* Re and Im of V_k / V_j *)
Definition P_k k z := (V_re (at_ z) k * V_re (at_ z) j + V_im (at_ z) k * V_im (at_ z) j) / V_abs (at_ z) j ^ 2.
Definition Q_k k z := (V_im (at_ z) k * V_re (at_ z) j - V_re (at_ z) k * V_im (at_ z) j) / V_abs (at_ z) j ^ 2.
Lemma contact_responds : exists e, 0 < e /\ forall z, 0 < z < e -> Rabs (a j) / 4 < z * V_abs (at_ z) j /\ 0 < V_abs (at_ z) j.
Proof.
  destruct (order_away 1 _ _ (hat_V_abs j aj) ltac:(fold (a j); lra)) as [e [He H]]. fold (a j) in H. exists e. split;
    [exact He|].
  intros z Hz. specialize (H z Hz). split; [lra|]. apply Rnot_le_lt. intros K. nra.
Qed.
Lemma hat_V_im k : of_order 2 (fun z => z * V_im (at_ z) k + a k / 2).
Proof.
  apply (same_order 2 (fun z => z * (V_im (at_ z) k + psi k p * psi l p / (2 * z)))); [intros; unfold a; field; lra|].
  apply hat, order_V_im.
Qed.
Lemma hat_V_re k : of_order 1 (fun z => z * V_re (at_ z) k).
Proof. apply hat, order_V_re. Qed.
Lemma divided_by_V n f : of_order n f -> of_order n (fun z => f z / (z * V_abs (at_ z) j) ^ 2).
Proof.
  destruct contact_responds as [e [He H]]. apply (order_bounded_below n (fun z => (z * V_abs (at_ z) j) ^ 2) ((Rabs (a j) / 4)
    ^ 2)); [nra|].
  exists e. split; [exact He|]. intros z Hz. destruct (H z Hz) as [A _]. apply pow_incr. lra.
Qed.
Lemma order_P k : of_order 2 (fun z => P_k k z - a k / a j).
Proof.
  destruct contact_responds as [e [He H]].
  apply (near_zero_order 2 (fun z => (z * V_re (at_ z) k * (z * V_re (at_ z) j)
    + (z * V_im (at_ z) k * (z * V_im (at_ z) j) - - (a k / 2) * - (a j / 2))
    - a k / a j * ((z * V_abs (at_ z) j) ^ 2 - (Rabs (a j) / 2) ^ 2)) / (z * V_abs (at_ z) j) ^ 2) _ e He).
  - intros z Hz. destruct (H z Hz) as [_ V]. unfold P_k. replace ((Rabs (a j) / 2) ^ 2) with (a j ^ 2 / 4) by
      (rewrite <- (pow2_abs (a j)); field). field. repeat split; try lra; exact aj.
  - apply divided_by_V. apply order_minus; [apply order_plus|].
    + apply (order_mult 1 1); apply hat_V_re.
    + apply order_product; [apply (same_order 2 (fun z => z * V_im (at_ z) k + a k / 2)) |
        apply (same_order 2 (fun z => z * V_im (at_ z) j + a j / 2))]; try (intros; ring); apply hat_V_im.
    + apply order_scal, hat_V_abs_sq.
Qed.
Lemma order_Q k : of_order 1 (fun z => Q_k k z).
Proof.
  destruct contact_responds as [e [He H]].
  apply (near_zero_order 1 (fun z => (z * V_im (at_ z) k * (z * V_re (at_ z) j) - z * V_re (at_ z) k * (z * V_im (at_ z) j))
    / (z * V_abs (at_ z) j) ^ 2) _ e He).
  - intros z Hz. destruct (H z Hz) as [_ V]. unfold Q_k. field. lra.
  - assert (B : forall k, of_order 0 (fun z => z * V_im (at_ z) k)).
    { intros k0. apply (same_order 0 (fun z => z * V_im (at_ z) k0 + a k0 / 2 + - (a k0 / 2))); [intros; ring|].
      apply order_plus; [apply (order_weaker 2 0); [lia | apply hat_V_im] | apply order_const]. }
    apply divided_by_V, order_minus; [apply (order_mult 0 1) | apply (order_mult 1 0)]; (apply B || apply hat_V_re).
Qed.
Lemma hat_root : of_order 2 (fun z => z * root (at_ z) - Rabs (a j) / 2).
Proof.
  apply (same_order 2 (fun z => sqrt ((z * V_abs (at_ z) j) ^ 2 - (beta * (z * U (at_ z) j)) ^ 2) - Rabs (a j) / 2)).
  - intros z Hz. unfold root. replace ((z * V_abs (at_ z) j) ^ 2 - (beta * (z * U (at_ z) j)) ^ 2)
      with (z ^ 2 * (V_abs (at_ z) j ^ 2 - (beta * U (at_ z) j) ^ 2)) by ring.
    rewrite sqrt_mult_alt, sqrt_pow2 by (try apply pow2_ge_0; lra). reflexivity.
  - apply (order_root 1); [lra|].
    apply (same_order 2 (fun z => (z * V_abs (at_ z) j) ^ 2 - (Rabs (a j) / 2) ^ 2 - beta ^ 2 * (z * U (at_ z) j * (z * U (at_
      z) j))));
      [intros; ring|].
    apply order_minus; [apply hat_V_abs_sq|]. apply order_scal, (order_mult 1 1); apply hat_U.
Qed.

(* (52) by these *)
Definition E_k k z := V_abs (at_ z) k ^ 2 + beta ^ 2 * (G (at_ z) k ^ 2 + U (at_ z) k ^ 2)
  - 2 * beta * (root (at_ z) * (G (at_ z) k * P_k k z - U (at_ z) k * Q_k k z)
    + beta * U (at_ z) j * (G (at_ z) k * Q_k k z + U (at_ z) k * P_k k z)).
Lemma X_k_by_parts k z : 0 < V_abs (at_ z) j -> X_k (at_ z) k = sqrt (E_k k z).
Proof.
  intros V. unfold X_k, E_k. f_equal. change (contact (at_ z)) with j. change (friction (at_ z)) with beta.
  destruct (argument_all (at_ z) k) as [C1 S1]. destruct (argument_all (at_ z) j) as [C2 S2].
  assert (Pe : P_k k z = V_abs (at_ z) k / V_abs (at_ z) j * cos (V_arg (at_ z) k - V_arg (at_ z) j)).
  { unfold P_k. rewrite <- C1, <- S1, <- C2, <- S2, cos_minus. field. lra. }
  assert (Qe : Q_k k z = V_abs (at_ z) k / V_abs (at_ z) j * sin (V_arg (at_ z) k - V_arg (at_ z) j)).
  { unfold Q_k. rewrite <- C1, <- S1, <- C2, <- S2, sin_minus. field. lra. }
  rewrite Pe, Qe. ring.
Qed.
Let m k z := Rabs (a k) / 2 - Rabs (b k) * h z * beta.
Lemma signs k : Rabs (a j) * (b k * (a k / a j)) = Rabs (a k) * Rabs (b k).
Proof.
  unfold a, b. rewrite !Rabs_mult. replace (psi k p * psi j p * (psi k p * psi l p / (psi j p * psi l p))) with (psi k p ^ 2)
    by (field; split; assumption).
  rewrite <- (pow2_abs (psi k p)). ring.
Qed.
Lemma hat_E k : of_order 2 (fun z => z ^ 2 * E_k k z - m k z ^ 2).
Proof.
  apply (same_order 2 (fun z =>
    ((z * V_abs (at_ z) k) ^ 2 - (Rabs (a k) / 2) ^ 2)
    + (beta ^ 2 * ((z * G (at_ z) k - b k * h z) * (z * G (at_ z) k + b k * h z) + z * U (at_ z) k * (z * U (at_ z) k))
    + -2 * beta * ((z * root (at_ z) * (z * G (at_ z) k * P_k k z) - Rabs (a j) / 2 * (b k * h z * (a k / a j)))
      + (-1 * (z * root (at_ z) * (z * U (at_ z) k * Q_k k z))
        + beta * (z * U (at_ z) j * (z * G (at_ z) k * Q_k k z + z * U (at_ z) k * P_k k z))))))).
  - intros z Hz. unfold E_k, m. pose proof (signs k) as S.
    replace (Rabs (a j) / 2 * (b k * h z * (a k / a j))) with (Rabs (a j) * (b k * (a k / a j)) * h z / 2) by (unfold Rdiv; ring).
    rewrite S.
    assert (B2 : Rabs (b k) * Rabs (b k) = b k * b k) by (rewrite <- Rabs_mult; apply Rabs_right; nra).
    set (A := Rabs (a k)) in *. set (B := Rabs (b k)) in *. set (hz := h z).
    replace ((A / 2 - B * hz * beta) ^ 2) with (A ^ 2 / 4 - A * B * hz * beta + b k * b k * hz ^ 2 * beta ^ 2) by (rewrite <-
      B2; field).
    field.
  - assert (BG : of_order 0 (fun z => z * G (at_ z) k)).
    { apply (same_order 0 (fun z => z * G (at_ z) k - b k * h z + b k * h z)); [intros; ring|].
      apply order_plus; [apply (order_weaker 2 0); [lia | apply hat_G] | apply order_scal, order_h]. }
    assert (BP : of_order 0 (fun z => P_k k z)).
    { apply (same_order 0 (fun z => P_k k z - a k / a j + a k / a j)); [intros; ring|].
      apply order_plus; [apply (order_weaker 2 0); [lia | apply order_P] | apply order_const]. }
    assert (BR : of_order 0 (fun z => z * root (at_ z))).
    { apply (same_order 0 (fun z => z * root (at_ z) - Rabs (a j) / 2 + Rabs (a j) / 2)); [intros; ring|].
      apply order_plus; [apply (order_weaker 2 0); [lia | apply hat_root] | apply order_const]. }
    apply order_plus; [apply hat_V_abs_sq|]. apply order_plus; apply order_scal; apply order_plus.
    + apply (order_mult 2 0); [apply hat_G|]. apply order_plus; [exact BG | apply order_scal, order_h].
    + apply (order_mult 1 1); apply hat_U.
    + apply (same_order 2 (fun z => (z * root (at_ z) - Rabs (a j) / 2) * (z * G (at_ z) k * P_k k z)
        + Rabs (a j) / 2 * ((z * G (at_ z) k - b k * h z) * P_k k z + b k * (h z * (P_k k z - a k / a j))))); [intros; ring|].
      apply order_plus.
      * apply (order_mult 2 0); [apply hat_root | apply (order_mult 0 0); [exact BG | exact BP]].
      * apply order_scal, order_plus; [apply (order_mult 2 0); [apply hat_G | exact BP]|].
        apply order_scal, (order_mult 0 2); [apply order_h | apply order_P].
    + apply order_plus; apply order_scal.
      * apply (order_mult 0 2); [exact BR|]. apply (order_mult 1 1); [apply hat_U | apply order_Q].
      * apply (order_mult 1 1); [apply hat_U|]. apply order_plus; [apply (order_mult 0 1); [exact BG | apply order_Q] |
          apply (order_mult 1 0); [apply hat_U | exact BP]].
Qed.

Lemma m_positive k : psi k p <> 0 -> 0 <= beta < PI / 4 * Rabs (psi l p / psi j p) ->
  exists m0, 0 < m0 /\ exists e, 0 < e /\ forall z, 0 < z < e -> m0 < m k z.
Proof.
  intros Hk [B0 B1]. pose proof PI_RGT_0 as P. pose proof (Rabs_pos_lt _ Hk). pose proof (Rabs_pos_lt _ Hj). pose proof
    (Rabs_pos_lt _ Hl).
  assert (Lm : is_lim (m k) 0 (Rabs (a k) / 2 - Rabs (b k) * (2 / PI) * beta)).
  { unfold m. apply is_lim_minus'; [apply is_lim_const|]. apply product_limit; [|apply is_lim_const].
    apply product_limit; [apply is_lim_const | apply second_function_limit]. }
  assert (Pos : 0 < Rabs (a k) / 2 - Rabs (b k) * (2 / PI) * beta).
  { unfold a, b. rewrite !Rabs_mult. unfold Rdiv in B1. rewrite Rabs_mult, Rabs_Rinv in B1 by exact Hj.
    set (K := Rabs (psi k p)) in *. set (J := Rabs (psi j p)) in *. set (L := Rabs (psi l p)) in *.
    assert (J * beta < PI / 4 * L).
    { replace (PI / 4 * L) with (J * (PI * / 4 * (L * / J))) by (field; lra). apply Rmult_lt_compat_l; lra. }
    replace (K * L / 2 - K * J * (2 / PI) * beta) with (K * (2 / PI) * (PI / 4 * L - J * beta)) by (field; lra).
    apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; [lra | apply Rdiv_lt_0_compat; lra] | lra]. }
  exists ((Rabs (a k) / 2 - Rabs (b k) * (2 / PI) * beta) / 2). split; [lra|]. apply (above_near_zero _ _ _ Lm). lra.
Qed.

Lemma order_X_k k : psi k p <> 0 -> 0 <= beta < PI / 4 * Rabs (psi l p / psi j p) ->
  of_order 1 (fun z => X_k (at_ z) k - (Rabs (a k) / (2 * z) - Rabs (b k) * second_function_at_resonance z * beta)).
Proof.
  intros Hk Hb. destruct (m_positive k Hk Hb) as [m0 [Hm M]]. destruct contact_responds as [e [He V]].
  apply (near_zero_order 1 (fun z => (sqrt (z ^ 2 * E_k k z) - m k z) / z) _ e He).
  - intros z Hz. destruct (V z Hz) as [_ Vj]. rewrite X_k_by_parts by exact Vj.
    rewrite sqrt_mult_alt, sqrt_pow2 by (try apply pow2_ge_0; lra). unfold m. field. lra.
  - apply order_divided, (order_root_near 1 _ _ m0); [exact Hm | exact M | apply hat_E].
Qed.

Lemma order_limit mu : of_order 1 (fun z =>
  sqrt (V_abs (at_ z) j ^ 2 / (U (at_ z) j ^ 2 + (H_j (at_ z) + mu * mobility (at_ z)) ^ 2))
  - Rabs (psi l p / psi j p) * ((cosh (z * PI) - 1) / (2 * z * sinh (z * PI)))).
Proof.
  pose proof PI_RGT_0 as P. set (bj := psi j p ^ 2). assert (Bj : 0 < bj) by (unfold bj; nra).
  set (t := fun z => Rabs (a j) / 2 / (bj * h z)).
  set (D := fun z => (z * U (at_ z) j) ^ 2 + (z * (H_j (at_ z) + mu * mobility (at_ z))) ^ 2).
  assert (LB : is_lim (fun z => bj * h z) 0 (bj * (2 / PI))) by (apply product_limit; [apply is_lim_const | apply
    second_function_limit]).
  assert (Pp : 0 < 2 / PI) by (apply Rdiv_lt_0_compat; lra).
  assert (B2 : 0 < bj * (2 / PI)) by (apply Rmult_lt_0_compat; assumption).
  destruct (above_near_zero _ _ (bj * (2 / PI) / 2) LB ltac:(lra)) as [e1 [He1 Bh]].
  assert (HD : of_order 1 (fun z => D z - (bj * h z) ^ 2)).
  { apply (same_order 1 (fun z => z * U (at_ z) j * (z * U (at_ z) j)
      + (z * (H_j (at_ z) - bj * second_function_at_resonance z) + mu * mobility s * z)
        * (z * (H_j (at_ z) - bj * second_function_at_resonance z) + mu * mobility s * z + 2 * bj * h z))).
    - intros z Hz. unfold D. change (mobility (at_ z)) with (mobility s). ring.
    - assert (H1 : of_order 1 (fun z => z * (H_j (at_ z) - bj * second_function_at_resonance z) + mu * mobility s * z)).
      { apply order_plus; [apply (order_weaker 2 1); [lia | apply hat, order_H] | apply order_scal, order_id]. }
      apply order_plus; [apply (order_weaker 2 1); [lia | apply (order_mult 1 1); apply hat_U]|].
      apply (order_mult 1 0); [exact H1|]. apply order_plus; [apply (order_weaker 1 0); [lia | exact H1] | apply order_scal,
        order_h]. }
  assert (HV := hat_V_abs_sq j). fold (a j) in HV.
  set (d0 := (bj * (2 / PI) / 2) ^ 2). assert (D0 : 0 < d0) by (unfold d0; nra).
  assert (HD' : of_order 1 (fun z => D z - (bj * h z) ^ 2 + d0 - d0)) by
    (apply (same_order 1 (fun z => D z - (bj * h z) ^ 2)); [intros; ring | exact HD]).
  destruct (order_away 0 (fun z => D z - (bj * h z) ^ 2 + d0) d0 HD' D0) as [e2 [He2 Dl]].
  assert (Bl : forall z, 0 < z < e1 -> d0 <= (bj * h z) ^ 2) by (intros z Hz; apply pow_incr; specialize (Bh z Hz); lra).
  assert (He : 0 < Rmin e1 e2) by (apply Rmin_glb_lt; assumption).
  assert (Dp : forall z, 0 < z < Rmin e1 e2 -> d0 / 2 <= D z).
  { intros z Hz. pose proof (Rmin_l e1 e2). pose proof (Rmin_r e1 e2). specialize (Bl z ltac:(lra)). specialize (Dl z
    ltac:(lra)). lra. }
  apply (near_zero_order 1 (fun z => sqrt ((z * V_abs (at_ z) j) ^ 2 / D z) - t z) _ (Rmin e1 e2) He).
  - intros z Hz. specialize (Dp z Hz). pose proof (Rmin_l e1 e2). specialize (Bh z ltac:(lra)). f_equal.
    + f_equal. unfold D in *. set (X := H_j _ + _) in *. set (Y := U _ _) in *.
      replace ((z * Y) ^ 2 + (z * X) ^ 2) with (z ^ 2 * (Y ^ 2 + X ^ 2)) in * by ring. field. split; [|lra].
      intros K. rewrite K in Dp. lra.
    + unfold t, a, bj, second_function_at_resonance. rewrite Rabs_mult.
      replace (Rabs (psi l p / psi j p)) with (Rabs (psi l p) * / Rabs (psi j p)) by (unfold Rdiv; rewrite Rabs_mult, Rabs_Rinv by
        exact Hj; reflexivity).
      rewrite <- (pow2_abs (psi j p)). pose proof (Rabs_pos_lt _ Hj). pose proof (sinh_not_zero z ltac:(lra)).
      pose proof (cosh_not_one z ltac:(lra)). field. repeat split; try lra; assumption.
  - assert (Lt : is_lim t 0 (Rabs (a j) / 2 / (bj * (2 / PI)))) by (apply ratio_limit; [apply is_lim_const | exact LB | lra]).
    assert (T0 : 0 < Rabs (a j) / 2 / (bj * (2 / PI))) by (apply Rdiv_lt_0_compat; lra).
    apply (order_root_near 0 _ t (Rabs (a j) / 2 / (bj * (2 / PI)) / 2)); [lra | apply (above_near_zero _ _ _ Lt); lra |].
    apply (near_zero_order 1 (fun z => (((z * V_abs (at_ z) j) ^ 2 - (Rabs (a j) / 2) ^ 2) * (bj * h z * (bj * h z))
      - (Rabs (a j) / 2) ^ 2 * (D z - (bj * h z) ^ 2)) / (D z * (bj * h z) ^ 2)) _ (Rmin e1 e2) He).
    + intros z Hz. specialize (Dp z Hz). pose proof (Rmin_l e1 e2). specialize (Bh z ltac:(lra)). unfold t.
      set (y := bj * h z) in *. field. split; lra.
    + apply (order_bounded_below 1 (fun z => D z * (bj * h z) ^ 2) (d0 / 2 * d0)); [nra | |].
      * exists (Rmin e1 e2). split; [exact He|]. intros z Hz. pose proof (Rmin_l e1 e2). apply Rmult_le_compat; try lra; [apply
        Dp, Hz | apply Bl; lra].
      * apply order_minus; [|apply order_scal, HD]. apply (order_weaker 2 1); [lia|]. apply (order_mult 2 0); [exact HV|].
        apply (order_mult 0 0); apply order_scal, order_h.
Qed.
End At_resonance.

Theorem eq_76_77_order : Statements.eq_76_77_order.
Proof.
  intros s c p k Hs. split; [apply (order_V_re s c p Hs)|]. split; [apply (order_V_im s c p Hs)|]. intros Ha.
  apply (same_order 1 (fun z => (z * V_abs (lightly_damped s c z) k - Rabs (shape s k p * shape s (loaded s) p) / 2) / z));
    [intros; field; lra | apply order_divided, (hat_V_abs s c p Hs k Ha)].
Qed.
Theorem eq_80_order : Statements.eq_80_order.
Proof. intros s c p k Hs. split; [apply (order_G s c p Hs) | apply (order_U s c p Hs)]. Qed.

Theorem eq_83_order : Statements.eq_83_order.
Proof. intros s c p k Hs Hk Hj Hl Hb. apply order_X_k; assumption. Qed.
Theorem eq_85_order : Statements.eq_85_order.
Proof. intros s c p mu Hs Hj Hl. apply order_limit; assumption. Qed.
