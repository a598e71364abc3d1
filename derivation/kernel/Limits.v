(* Limits: (70)-(72), and Sections 4.1 and 4.2. *)
Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes SteadyMode Sums Masses Contact ContactMotion Misprints.
Open Scope R_scope.

Lemma from_the_right (f : R -> R) (a l : R) : is_lim f a (Finite l) -> filterlim f (at_right a) (locally l).
Proof.
  intros L. unfold is_lim in L. simpl in L. eapply filterlim_filter_le_1; [|exact L].
  intros P [e He]. exists e. intros t Ht Hp. apply He; [exact Ht | lra].
Qed.
Lemma limit_of_derivable (f : R -> R) a : ex_derive f a -> is_lim f a (f a).
Proof. intros D. apply is_lim_continuity. apply continuity_pt_filterlim. apply (ex_derive_continuous (K := R_AbsRing) (V :=
  R_NormedModule) f a D). Qed.
Lemma limit_value (f : R -> R) (a l : R) : ex_derive f a -> f a = l -> is_lim f a l.
Proof. intros D <-. apply limit_of_derivable, D. Qed.
Lemma one_limit (f : R -> R) a l l' : is_lim f a (Finite l) -> is_lim f a (Finite l') -> l = l'.
Proof. intros A B. apply is_lim_unique in A. apply is_lim_unique in B. rewrite A in B. injection B. auto. Qed.

(* The second derivative from a double zero *)
Lemma second_slope (f f1 : R -> R) (A r : R) : 0 < r -> f 0 = 0 -> f1 0 = 0 -> (forall z, Rabs z < r -> is_derive f z (f1 z)) ->
  is_derive f1 0 A ->
  is_lim (fun z => f z / z ^ 2) 0 (A / 2).
Proof.
  intros Hr F0 F1 D D1. apply is_derive_Reals in D1. apply is_lim_spec. intros eps. pose proof (cond_pos eps) as He.
  destruct (D1 (eps / 2) ltac:(lra)) as [del Hd].
  assert (P : 0 < Rmin del r) by (apply Rmin_glb_lt; [apply cond_pos | exact Hr]). exists (mkposreal _ P). intros y Hy Hy0.
  pose proof (Rmin_l del r). pose proof (Rmin_r del r). change (Rabs (y - 0) < Rmin del r) in Hy. rewrite Rminus_0_r in Hy.
  destruct (MVT_gen (fun z => f z - A / 2 * z ^ 2) 0 y (fun z => f1 z - A * z)) as [c [Hc E]].
  - intros z Hz. evar_last.
    { apply (is_derive_minus (V := R_NormedModule)); [apply D | apply is_derive_scal, (is_derive_pow (fun z => z) 2 z 1),
      (is_derive_id (K := R_AbsRing))].
      unfold Rmin, Rmax, Rabs in *. destruct (Rle_dec 0 y); destruct (Rcase_abs z); destruct (Rcase_abs y); lra. }
    unfold minus, plus, opp; simpl. field.
  - intros z Hz. apply continuity_pt_filterlim. apply (ex_derive_continuous (K := R_AbsRing) (V := R_NormedModule) (fun z => f z
    - A / 2 * z ^ 2) z).
    apply (ex_derive_minus (V := R_NormedModule) f (fun z => A / 2 * z ^ 2)).
    + exists (f1 z). apply D. unfold Rmin, Rmax, Rabs in *. destruct (Rle_dec 0 y); destruct (Rcase_abs z); destruct (Rcase_abs
      y); lra.
    + auto_derive. trivial.
  - assert (Hcy : Rabs c <= Rabs y) by (unfold Rmin, Rmax, Rabs in *; destruct (Rle_dec 0 y); destruct (Rcase_abs c); destruct
    (Rcase_abs y); lra).
    assert (Hs : Rabs (f1 c - A * c) <= eps / 2 * Rabs y).
    { destruct (Req_dec c 0) as [->|C0].
      - rewrite F1. replace (0 - A * 0) with 0 by ring. rewrite Rabs_R0. apply Rmult_le_pos; [lra | apply Rabs_pos].
      - specialize (Hd c C0 ltac:(lra)). rewrite Rplus_0_l, F1, Rminus_0_r in Hd.
        replace (f1 c - A * c) with ((f1 c / c - A) * c) by (field; exact C0). rewrite Rabs_mult.
        apply Rmult_le_compat; [apply Rabs_pos | apply Rabs_pos | lra | exact Hcy]. }
    rewrite F0 in E. replace (f y / y ^ 2 - A / 2) with ((f y - A / 2 * y ^ 2 - (0 - A / 2 * 0 ^ 2)) / y ^ 2) by (field; exact
      Hy0).
    rewrite E, Rminus_0_r. replace ((f1 c - A * c) * y / y ^ 2) with ((f1 c - A * c) / y) by (field; exact Hy0).
    assert (Py : 0 < Rabs y) by (apply Rabs_pos_lt; exact Hy0). unfold Rdiv. rewrite Rabs_mult, Rabs_Rinv by exact Hy0.
    apply Rle_lt_trans with (eps / 2); [|lra]. apply (Rmult_le_reg_r (Rabs y)); [exact Py|]. rewrite Rmult_assoc, Rinv_l,
      Rmult_1_r by lra. exact Hs.
Qed.

(* ---- (70)-(72) ---- *)
Lemma mode_demand_limit r z : admissible r z -> is_lim (fun t => demand_of_mode r z t / sin t) 0 (1 + g r z + 2 * z * r * u r z).
Proof.
  intros A. pose proof A as [Hr [Hz _]]. destruct (demand_ends r z A) as [D0 [_ [E0 _]]]. pose proof PI_RGT_0.
  replace (1 + g r z + 2 * z * r * u r z) with ((r ^ 2 * braces_second r z 0 - u r z * r ^ 2 * sin 0) / cos 0) by (rewrite E0,
    sin_0, cos_0; field).
  apply (quotient_limit (demand_of_mode r z) sin 0); [exact D0 | apply sin_0 | apply demand_rate; assumption | apply
    is_derive_sin | rewrite cos_0; lra |].
  exists PI. split; [lra|]. intros t Ht H0. apply sin_not_zero; [|exact H0]. apply Rabs_lt_between in Ht. lra.
Qed.
Lemma line_limit a b : is_lim (fun t => a + b * t) 0 a.
Proof. replace (Finite a) with (Finite (a + b * 0)) by (f_equal; ring). apply (limit_of_derivable (fun t => a + b * t)).
  auto_derive. trivial. Qed.
Lemma not_at_zero (f h : R -> R) l : (forall t, t <> 0 -> f t = h t) -> is_lim f 0 l -> is_lim h 0 l.
Proof. intros E. apply is_lim_ext_loc. exists (mkposreal 1 Rlt_0_1). intros t _ Ht. apply E, Ht. Qed.

Theorem eq_70_71 : Statements.eq_70_71.
Proof.
  intros r z A. split; [apply mode_demand_limit, A|]. destruct A as [Hr _].
  apply (not_at_zero (fun t => (1 + g r z + 2 * z * r * u r z) + (- (1 + g r z) * z / r - u r z * z ^ 2) * t)); [|apply
    line_limit].
  intros t Ht. unfold expansion. field. lra.
Qed.
Theorem eq_70_as_printed : Statements.eq_70_as_printed.
Proof.
  intros H. assert (A : admissible 1 (1 / 2)) by (apply admissible_resonant; lra). pose proof (mode_demand_limit 1 (1 / 2) A) as
    L.
  pose proof (H 1 (1 / 2) _ A L) as P. pose proof u_resonant as U0. set (v := u 1 (1 / 2)) in *. set (k := g 1 (1 / 2)) in *.
  assert (P' : is_lim (expansion_printed 1 (1 / 2)) 0 (1 + k - v)).
  { apply (not_at_zero (fun t => (1 + k - v) + (- (1 + k) / 2 + v / 4) * t)); [|apply line_limit]. intros t Ht. unfold
    expansion_printed. fold v k. field. exact Ht. }
  pose proof (one_limit _ _ _ _ P P') as E. lra.
Qed.
Theorem eq_72 : Statements.eq_72.
Proof. intros s Hs. apply (demand_limits s Hs). Qed.

(* ---- Vanishing damping ---- *)
Lemma w_derivable z : -1 < z < 1 -> 0 < 1 - z * z.
Proof. intros H. nra. Qed.

Theorem undamped_limits : Statements.undamped_limits.
Proof.
  intros r Hr Hc. split; [|split; [|apply g_0]].
  - rewrite <- u_0. apply from_the_right. apply (limit_of_derivable (u r)). unfold u, cosh, theta, decay, w. auto_derive.
    replace (1 + - (0 * 0)) with 1 by ring. rewrite sqrt_1. replace (PI * 0 * / r) with 0 by ring. replace (PI * 1 * / r) with
      (PI / r) by (unfold Rdiv; ring).
    rewrite Ropp_0, exp_0. repeat split; try lra.
    apply Rmult_integral_contrapositive. split; [lra|]. replace ((1 + 1) * / 2) with 1 by field. exact Hc.
  - apply from_the_right. apply limit_value; [|apply g_0]. unfold g, cosh, sinh, theta, decay, w. auto_derive.
    replace (1 + - (0 * 0)) with 1 by ring. rewrite sqrt_1. replace (PI * 0 * / r) with 0 by ring. replace (PI * 1 * / r) with
      (PI / r) by (unfold Rdiv; ring).
    rewrite Ropp_0, exp_0. repeat split; lra.
Qed.

(* cosh(pi zeta) + cos(pi w), and sin(pi w), near zeta = 0 *)
Definition bottom z := cosh (z * PI) + cos (PI * w z).
Definition bottom_prime z := PI * sinh (z * PI) + sin (PI * w z) * PI * (z / w z).
Definition top z := sin (PI * w z).
Definition top_prime z := - (cos (PI * w z) * PI * (z / w z)).
Lemma w_rate z : Rabs z < 1 -> is_derive w z (- (z / w z)).
Proof.
  intros H. apply Rabs_lt_between in H. pose proof (w_derivable z H). unfold w. auto_derive; [lra|].
  replace (1 + - (z * z)) with (1 - z * z) by ring. pose proof (sqrt_lt_R0 _ H0). field. lra.
Qed.
Lemma w_derivatives z : Rabs z < 1 -> ex_derive w z /\ Derive w z = - (z / w z).
Proof. intros H. pose proof (w_rate z H) as D. split; [eexists; exact D | apply is_derive_unique; exact D]. Qed.
Lemma bottom_rate z : Rabs z < 1 -> is_derive bottom z (bottom_prime z).
Proof.
  intros H. destruct (w_derivatives z H) as [D E]. unfold bottom, bottom_prime, cosh, sinh. auto_derive; [exact D|].
  change (fun x => w x) with w. rewrite E. set (a := z / w z). field.
Qed.
Lemma top_rate z : Rabs z < 1 -> is_derive top z (top_prime z).
Proof. intros H. destruct (w_derivatives z H) as [D E]. unfold top, top_prime. auto_derive; [exact D|]. change (fun x => w x)
  with w. rewrite E. ring. Qed.
Lemma at_zero : w 0 = 1 /\ bottom 0 = 0 /\ bottom_prime 0 = 0 /\ top 0 = 0 /\ top_prime 0 = 0.
Proof.
  unfold bottom, bottom_prime, top, top_prime. rewrite w_0, Rmult_1_r, Rmult_0_l, cosh_0, sinh_0, cos_PI, sin_PI. repeat split;
    unfold Rdiv; ring.
Qed.
Lemma bottom_second : is_derive bottom_prime 0 (PI ^ 2).
Proof.
  destruct (w_derivatives 0 ltac:(rewrite Rabs_R0; lra)) as [D E]. unfold bottom_prime, sinh. auto_derive.
  - repeat split; try exact D. rewrite w_0. lra.
  - change (fun x => w x) with w. rewrite E, w_0. replace (0 * PI) with 0 by ring. rewrite Ropp_0, exp_0. replace (PI * 1) with
    PI by ring. rewrite sin_PI, cos_PI. field.
Qed.
Lemma top_second : is_derive top_prime 0 PI.
Proof.
  destruct (w_derivatives 0 ltac:(rewrite Rabs_R0; lra)) as [D E]. unfold top_prime. auto_derive.
  - repeat split; try exact D. rewrite w_0. lra.
  - change (fun x => w x) with w. rewrite E, w_0. replace (PI * 1) with PI by ring. rewrite sin_PI, cos_PI. field.
Qed.
Lemma bottom_limit : is_lim (fun z => bottom z / z ^ 2) 0 (PI ^ 2 / 2).
Proof. destruct at_zero as [_ [A [B _]]]. apply (second_slope bottom bottom_prime (PI ^ 2) 1); [lra | exact A | exact B | apply
  bottom_rate | apply bottom_second]. Qed.
Lemma top_limit : is_lim (fun z => top z / z ^ 2) 0 (PI / 2).
Proof. destruct at_zero as [_ [_ [_ [A B]]]]. apply (second_slope top top_prime PI 1); [lra | exact A | exact B | apply top_rate
  | apply top_second]. Qed.
Lemma w_limit : is_lim w 0 1.
Proof. rewrite <- w_0. apply limit_of_derivable. apply (w_derivatives 0). rewrite Rabs_R0. lra. Qed.
Lemma bottom_not_zero z : z <> 0 -> bottom z <> 0.
Proof.
  intros H. pose proof PI_RGT_0. unfold bottom. pose proof (COS_bound (PI * w z)).
  pose proof (cosh_above (z * PI) ltac:(apply Rmult_integral_contrapositive; split; lra)). lra.
Qed.
Lemma product_limit (f h : R -> R) a b : is_lim f 0 (Finite a) -> is_lim h 0 (Finite b) -> is_lim (fun z => f z * h z) 0 (a * b).
Proof. intros A B. change (Finite (a * b)) with (Rbar_mult a b). apply is_lim_mult; [exact A | exact B | exact I]. Qed.
Lemma ratio_limit (f h : R -> R) a b : is_lim f 0 (Finite a) -> is_lim h 0 (Finite b) -> b <> 0 -> is_lim (fun z => f z / h z) 0
  (a / b).
Proof.
  intros A B Hb. change (Finite (a / b)) with (Rbar_div a b). apply is_lim_div; [exact A | exact B | | exact I]. intros K. apply
    Hb. injection K. auto.
Qed.
Lemma near_zero (f h : R -> R) l : (forall z, Rabs z < 1 -> z <> 0 -> f z = h z) -> is_lim f 0 l -> is_lim h 0 l.
Proof.
  intros E. apply is_lim_ext_loc. exists (mkposreal 1 Rlt_0_1). intros z Hz Hz0. apply E; [|exact Hz0].
  change (Rabs (z - 0) < 1) in Hz. rewrite Rminus_0_r in Hz. exact Hz.
Qed.
Lemma w_near z : Rabs z < 1 -> 0 < w z.
Proof. intros H. apply Rabs_lt_between in H. apply sqrt_lt_R0, w_derivable, H. Qed.

Lemma sinh_above x : 0 < x -> 0 < sinh x.
Proof. intros H. unfold sinh. pose proof (exp_increasing (- x) x ltac:(lra)). lra. Qed.
Lemma sinh_not_zero z : z <> 0 -> sinh (z * PI) <> 0.
Proof.
  intros H. pose proof PI_RGT_0. destruct (Rlt_dec 0 z) as [L|L]; [apply Rgt_not_eq, sinh_above; nra|].
  pose proof (sinh_above (- (z * PI)) ltac:(nra)) as S. unfold sinh in *. rewrite Ropp_involutive in S. lra.
Qed.
Lemma cosh_not_one z : z <> 0 -> cosh (z * PI) - 1 <> 0.
Proof.
  intros H. pose proof PI_RGT_0. pose proof (Misprints.cosh_above (z * PI) ltac:(apply Rmult_integral_contrapositive; split;
    lra)). lra.
Qed.
Lemma sinh_limit : is_lim (fun z => sinh (z * PI) / z) 0 PI.
Proof.
  apply (is_lim_ext (fun z => sinh (z * PI) / (z - 0))); [intros; rewrite Rminus_0_r; reflexivity|].
  apply (slope_limit (fun z => sinh (z * PI)) 0); [rewrite Rmult_0_l; apply sinh_0|].
  unfold sinh. auto_derive; [trivial|]. replace (0 * PI) with 0 by ring. rewrite Ropp_0, exp_0. field.
Qed.
Lemma cosh_limit : is_lim (fun z => (cosh (z * PI) - 1) / z ^ 2) 0 (PI ^ 2 / 2).
Proof.
  apply (second_slope (fun z => cosh (z * PI) - 1) (fun z => PI * sinh (z * PI)) (PI ^ 2) 1);
    [lra | rewrite Rmult_0_l, cosh_0; ring | rewrite Rmult_0_l, sinh_0; ring | |].
  - intros z _. unfold cosh, sinh. auto_derive; [trivial|]. field.
  - unfold sinh. auto_derive; [trivial|]. replace (0 * PI) with 0 by ring. rewrite Ropp_0, exp_0. field.
Qed.
Lemma u_at_resonance : is_lim (u 1) 0 (/ PI).
Proof.
  pose proof PI_RGT_0 as P. replace (/ PI) with (PI / 2 / (1 * (PI ^ 2 / 2))) by (field; lra).
  apply (near_zero (fun z => top z / z ^ 2 / (w z * (bottom z / z ^ 2)))).
  - intros z H H0. pose proof (w_near z H). pose proof (bottom_not_zero z H0) as B. unfold u, theta, decay, top, bottom in *.
    replace (PI * w z / 1) with (PI * w z) by field. replace (PI * z / 1) with (z * PI) by field. field. repeat split; try lra;
      assumption.
  - apply ratio_limit; [apply top_limit | apply product_limit; [apply w_limit | apply bottom_limit] | nra].
Qed.

Theorem limits_at_resonance : Statements.limits_at_resonance.
Proof.
  pose proof PI_RGT_0 as P. split; apply from_the_right.
  - exact u_at_resonance.
  - replace (2 / PI) with (PI / (PI ^ 2 / 2)) by (field; lra).
    apply (near_zero (fun z => (sinh (z * PI) - z / w z * top z) / (z - 0) / (bottom z / z ^ 2))).
    + intros z H H0. pose proof (w_near z H). pose proof (bottom_not_zero z H0) as B. unfold g, theta, decay, top, bottom in *.
      replace (PI * w z / 1) with (PI * w z) by field. replace (PI * z / 1) with (z * PI) by field. rewrite Rminus_0_r. field.
        repeat split; try lra; assumption.
    + apply ratio_limit; [|apply bottom_limit | nra]. apply (slope_limit (fun z => sinh (z * PI) - z / w z * top z)).
      * rewrite Rmult_0_l, sinh_0. unfold Rdiv. ring.
      * destruct (w_derivatives 0 ltac:(rewrite Rabs_R0; lra)) as [D E]. unfold sinh, top. auto_derive.
        -- repeat split; try exact D. rewrite w_0. lra.
        -- change (fun x => w x) with w. rewrite E, w_0. replace (0 * PI) with 0 by ring. rewrite Ropp_0, exp_0. replace (PI *
          1) with PI by ring. rewrite sin_PI, cos_PI. field.
Qed.

(* ---- Resonance ---- *)
Theorem eq_76_77 : Statements.eq_76_77.
Proof.
  intros z Hz. assert (A : v_re 1 z = 0) by (unfold v_re; replace (1 - 1 * 1) with 0 by ring; unfold Rdiv; ring).
  assert (B : v_im 1 z = - / (2 * z)) by (unfold v_im; field; repeat split; nra).
  split; [exact A|]. split; [exact B|]. unfold v_abs. rewrite A, B. apply sqrt_of_square; [|ring].
  apply Rlt_le, Rinv_0_lt_compat. lra.
Qed.

Theorem eq_85_is_the_zero_of_83 : Statements.eq_85_is_the_zero_of_83.
Proof.
  intros pl pj z Hz Hp b. pose proof PI_RGT_0. assert (ZP : 0 < z * PI) by nra. pose proof (sinh_above _ ZP). pose proof
    (cosh_above (z * PI) ltac:(lra)).
  pose proof (Rabs_pos_lt pj Hp). assert (Q : Rabs (pl / pj) = Rabs pl / Rabs pj) by (unfold Rdiv; rewrite Rabs_mult, Rabs_Rinv
    by exact Hp; reflexivity).
  unfold b. rewrite Q, !Rabs_mult. field. repeat split; lra.
Qed.
Theorem eq_85_undamped : Statements.eq_85_undamped.
Proof.
  pose proof PI_RGT_0 as P. apply from_the_right. replace (PI / 4) with (PI ^ 2 / 2 / (2 * PI)) by (field; lra).
  apply (not_at_zero (fun z => (cosh (z * PI) - 1) / z ^ 2 / (2 * (sinh (z * PI) / z)))).
  - intros z Hz. pose proof (sinh_not_zero z Hz). field. split; assumption.
  - apply ratio_limit; [apply cosh_limit | apply (product_limit (fun _ => 2)); [apply is_lim_const | apply sinh_limit] | lra].
Qed.
