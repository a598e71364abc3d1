(* Where (57) is largest: up to 2 R_i >= w_i at the start. *)
Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes SteadyMode Sums Masses Contact Misprints.
Open Scope R_scope.

(* A combination of cosine and sine that is not positive at the start cannot be negative between two places in (0, 2 pi) at
   which it is not. *)
Lemma interpolated a c y1 y2 y3 : let S y := a * cos y + c * sin y in
  S y2 * sin (y3 - y1) = S y1 * sin (y3 - y2) + S y3 * sin (y2 - y1).
Proof.
  intros S. unfold S. rewrite !sin_minus.
  pose proof (sin2_cos2 y1) as E1. pose proof (sin2_cos2 y2) as E2. pose proof (sin2_cos2 y3) as E3. unfold Rsqr in *. ring.
Qed.

Lemma no_return a c y1 y2 y3 : let S y := a * cos y + c * sin y in
  a <= 0 -> 0 < y1 -> y1 < y2 -> y2 < y3 -> y3 < 2 * PI -> 0 <= S y1 -> S y2 < 0 -> 0 < S y3 -> False.
Proof.
  intros S Ha H1 H12 H23 H3 S1 S2 S3. pose proof PI_RGT_0.
  destruct (Rlt_le_dec (y3 - y1) PI) as [L|L].
  - pose proof (interpolated a c y1 y2 y3) as E. fold S in E. cbv zeta in E.
    pose proof (sin_gt_0 (y3 - y1) ltac:(lra) L). pose proof (sin_gt_0 (y3 - y2) ltac:(lra) ltac:(lra)).
    pose proof (sin_gt_0 (y2 - y1) ltac:(lra) ltac:(lra)).
    change (S y2 * sin (y3 - y1) = S y1 * sin (y3 - y2) + S y3 * sin (y2 - y1)) in E. nra.
  - assert (M : S (y3 - PI) = - S y3).
    { unfold S. rewrite sin_minus, cos_minus, sin_PI, cos_PI. ring. }
    destruct (Req_dec y1 (y3 - PI)) as [Q|Q]; [rewrite Q in S1; lra|].
    pose proof (interpolated a c 0 y1 (y3 - PI)) as E.
    change (S y1 * sin (y3 - PI - 0) = S 0 * sin (y3 - PI - y1) + S (y3 - PI) * sin (y1 - 0)) in E.
    rewrite !Rminus_0_r, M in E. replace (S 0) with a in E by (unfold S; rewrite cos_0, sin_0; ring).
    pose proof (sin_gt_0 y1 H1 ltac:(lra)). pose proof (sin_gt_0 (y3 - PI) ltac:(lra) ltac:(lra)).
    pose proof (sin_gt_0 (y3 - PI - y1) ltac:(lra) ltac:(lra)). nra.
Qed.

Lemma mean_value (f f' : R -> R) a b : a < b -> (forall t, is_derive f t (f' t)) ->
  exists c, a < c < b /\ f b - f a = f' c * (b - a).
Proof.
  intros Hab Hd. destruct (MVT_cor2 f f' a b Hab) as [c [E I]].
  - intros c _. apply is_derive_Reals, Hd.
  - exists c. split; [exact I | exact E].
Qed.

Section Mode.
Variables r z : R.
Hypothesis A : admissible r z.
Hypothesis Low : w z <= 2 * r.
Let Hr : 0 < r := proj1 A.
Let Hz : 0 <= z < 1 := proj1 (proj2 A).
Let HD : cosh (decay r z) + cos (theta r z) <> 0 := proj1 (proj2 (proj2 A)).

Local Notation f := (demand_of_mode r z).
(* the rate of what (57) divides by sin tau; its own rate, with it added; and what the rate of the quotient has the sign of *)
Let f1 t := 1 - braces r z t - 2 * z * r * braces_prime r z t - u r z * r ^ 2 * sin t.
Let alpha := slope_at_start r z.
Let gamma := (r ^ 2 - 1) * ((1 + g r z) / (r * w z) + u r z * z / w z)
  + 2 * z * (z / w z * ((1 + g r z) / r + 2 * z * u r z) - u r z / w z).
Let S y := alpha * cos y + gamma * sin y.
Let W t := f1 t * sin t - f t * cos t.

Lemma f_rate t : is_derive f t (f1 t).
Proof.
  evar_last; [apply demand_rate; assumption|]. pose proof (braces_equation r z t Hr Hz). unfold f1. lra.
Qed.

Lemma f1_rate t : is_derive f1 t (exp (- z * t / r) * S (w z * t / r) - f t).
Proof.
  unfold f1. evar_last.
  { apply (is_derive_minus (V := R_NormedModule)).
    - apply (is_derive_minus (V := R_NormedModule)).
      + apply (is_derive_minus (V := R_NormedModule)); [apply is_derive_const | apply braces_rate; assumption].
      + apply is_derive_scal, braces_prime_rate; assumption.
    - apply is_derive_scal, is_derive_sin. }
  unfold minus, plus, opp, zero; simpl. rewrite demand_by_braces by exact Hr.
  unfold S, alpha, slope_at_start, gamma, braces_prime, braces_second, q_second, q_prime, q.
  pose proof (w_pos z Hz). set (e := exp _). set (c := cos (w z * t / r)). set (s := sin (w z * t / r)).
  field. lra.
Qed.

Lemma W_rate t : is_derive W t (exp (- z * t / r) * S (w z * t / r) * sin t).
Proof.
  unfold W. evar_last.
  { apply (is_derive_minus (V := R_NormedModule)); apply (is_derive_mult (K := R_AbsRing));
      [apply f1_rate | apply is_derive_sin | intros; apply Rmult_comm | apply f_rate | apply is_derive_cos | intros; apply
    Rmult_comm]. }
  unfold minus, plus, opp, mult; simpl. ring.
Qed.

Lemma W_ends : W 0 = 0 /\ W PI = 0.
Proof.
  destruct (demand_ends r z A) as [E0 [E1 _]]. unfold W. rewrite E0, E1, sin_0, sin_PI. split; ring.
Qed.

Lemma slope_factor : alpha * (r * w z * (cosh (decay r z) + cos (theta r z)))
  = sin (theta r z) * (1 - r ^ 2 - 2 * z ^ 2) - 2 * z * w z * (exp (decay r z) + cos (theta r z)).
Proof.
  pose proof (denominator_pos r z Hr Hz HD). pose proof (w_pos z Hz).
  replace (exp (decay r z)) with (cosh (decay r z) + sinh (decay r z)) by (unfold cosh, sinh; field).
  unfold alpha, slope_at_start, u, g. field. repeat split; lra.
Qed.

Lemma starts_falling : alpha <= 0.
Proof.
  pose proof (denominator_pos r z Hr Hz HD) as P. pose proof (w_pos z Hz) as Hw. pose proof (w_sq z Hz) as Hw2.
  pose proof PI_RGT_0 as Hpi.
  pose proof slope_factor as E.
  assert (Q : 0 < r * w z * (cosh (decay r z) + cos (theta r z))) by (repeat apply Rmult_lt_0_compat; assumption).
  apply Rnot_lt_le. intros Pos. assert (0 < alpha * (r * w z * (cosh (decay r z) + cos (theta r z)))) as X by (apply
    Rmult_lt_0_compat; assumption).
  rewrite E in X. clear E.
  assert (T0 : 0 < theta r z) by (unfold theta; apply Rdiv_lt_0_compat; nra).
  assert (D0 : 0 <= decay r z) by (unfold decay; apply Rmult_le_pos; [nra | apply Rlt_le, Rinv_0_lt_compat, Hr]).
  assert (EX : 1 + decay r z <= exp (decay r z)).
  { destruct (Req_dec (decay r z) 0) as [Z|Z]; [rewrite Z, exp_0; lra | apply Rlt_le, exp_ineq1, Z]. }
  pose proof (COS_bound (theta r z)) as CB. pose proof (SIN_bound (theta r z)) as SB.
  assert (Z0 : 0 <= 2 * z * w z * (exp (decay r z) + cos (theta r z) - decay r z)) by (apply Rmult_le_pos; [nra | lra]).
  destruct (Rle_lt_dec (theta r z) PI) as [L|L].
  - assert (w z <= r).
    { unfold theta in L. apply (Rmult_le_compat_r r) in L; [|lra].
      replace (PI * w z / r * r) with (PI * w z) in L by (field; lra). nra. }
    pose proof (sin_ge_0 (theta r z) ltac:(lra) L). assert (w z * w z <= r * r) by nra.
    assert (0 <= 2 * z * w z * decay r z) by (apply Rmult_le_pos; nra). nra.
  - assert (r < w z).
    { unfold theta in L. apply (Rmult_lt_compat_r r) in L; [|lra].
      replace (PI * w z / r * r) with (PI * w z) in L by (field; lra). nra. }
    assert (theta r z <= 2 * PI).
    { unfold theta. apply (Rmult_le_reg_r r); [lra|]. replace (PI * w z / r * r) with (PI * w z) by (field; lra). nra. }
    pose proof (sin_le_0 (theta r z) ltac:(lra) ltac:(lra)) as SN.
    assert (w z * decay r z >= z * PI).
    { unfold decay. apply Rle_ge. replace (w z * (PI * z / r)) with (z * PI * (w z / r)) by (field; lra).
      assert (1 <= w z / r) by (apply (Rmult_le_reg_r r); [lra|]; replace (w z / r * r) with (w z) by (field; lra); lra).
      assert (0 <= z * PI) by nra. nra. }
    assert (K : 2 * z * (w z * decay r z) >= 2 * z * (z * PI)) by (apply Rle_ge, Rmult_le_compat_l; lra).
    assert (P3 : 1 < PI) by (pose proof PI2_1; lra).
    assert (z * z <= z * z * PI) by nra.
    assert (r * r <= w z * w z) by nra.
    assert (N : - sin (theta r z) * (r ^ 2 + 2 * z ^ 2 - 1) <= 1 * (z * z)).
    { destruct (Rle_lt_dec (r ^ 2 + 2 * z ^ 2 - 1) 0); [nra|]. apply Rmult_le_compat; nra. }
    nra.
Qed.

(* The quotient rises and falls with the sign of W, which does not become negative again. *)
Lemma sign_of_W t : 0 < t < PI -> (forall s, 0 < s <= t -> W s <= 0) \/ (forall s, t <= s < PI -> 0 <= W s).
Proof.
  intros Ht. destruct W_ends as [W0 W1]. pose proof starts_falling as Al. pose proof (w_pos z Hz) as Hw.
  assert (MV : forall a b, 0 <= a -> a < b -> b <= PI -> exists c, a < c < b /\
    W b - W a = exp (- z * c / r) * S (w z * c / r) * sin c * (b - a) /\ 0 < exp (- z * c / r) * sin c * (b - a)).
  { intros a b Ha Hab Hb. destruct (mean_value W _ a b Hab W_rate) as [c [I E]]. exists c. split; [exact I|]. split; [exact E|].
    repeat apply Rmult_lt_0_compat; [apply exp_pos | apply sin_gt_0; lra | lra]. }
  assert (Y : forall a b, a < b -> w z * a / r < w z * b / r).
  { intros a b Hab. apply Rmult_lt_compat_r; [apply Rinv_0_lt_compat, Hr | nra]. }
  assert (Top : forall a, 0 < a < PI -> 0 < w z * a / r < 2 * PI).
  { intros a Ha. split; [apply Rdiv_lt_0_compat; nra|]. apply (Rmult_lt_reg_r r); [lra|].
    replace (w z * a / r * r) with (w z * a) by (field; lra). apply Rle_lt_trans with (2 * r * a); nra. }
  destruct (Rlt_le_dec (W t) 0) as [N|N]; [left | right]; intros a Ia; apply Rnot_lt_le; intros La.
  - assert (a <> t) by (intros ->; lra).
    destruct (MV 0 a) as [c1 [I1 [E1 P1]]]; [lra | lra | lra |]. destruct (MV a t) as [c2 [I2 [E2 P2]]]; [lra | lra | lra |].
    destruct (MV t PI) as [c3 [I3 [E3 P3]]]; [lra | lra | lra |].
    apply (no_return alpha gamma (w z * c1 / r) (w z * c2 / r) (w z * c3 / r)); try apply Y; try apply Top; try lra;
      change (alpha * cos ?y + gamma * sin ?y) with (S y); nra.
  - assert (a <> t) by (intros ->; lra).
    destruct (MV 0 t) as [c1 [I1 [E1 P1]]]; [lra | lra | lra |]. destruct (MV t a) as [c2 [I2 [E2 P2]]]; [lra | lra | lra |].
    destruct (MV a PI) as [c3 [I3 [E3 P3]]]; [lra | lra | lra |].
    apply (no_return alpha gamma (w z * c1 / r) (w z * c2 / r) (w z * c3 / r)); try apply Y; try apply Top; try lra;
      change (alpha * cos ?y + gamma * sin ?y) with (S y); nra.
Qed.

Lemma quotient_rate t : 0 < t < PI -> is_derive (fun t => f t / sin t) t (W t / sin t ^ 2).
Proof.
  intros Ht. pose proof (sin_gt_0 t ltac:(lra) ltac:(lra)).
  evar_last. { apply is_derive_div; [apply f_rate | apply is_derive_sin | lra]. }
  unfold W. field. lra.
Qed.

Lemma quotient_difference a b : 0 < a -> a < b -> b < PI ->
  exists c, a < c < b /\ f b / sin b - f a / sin a = W c / sin c ^ 2 * (b - a).
Proof.
  intros Ha Hab Hb. destruct (MVT_cor2 (fun t => f t / sin t) (fun t => W t / sin t ^ 2) a b Hab) as [c [E I]].
  - intros c Hc. apply is_derive_Reals, quotient_rate. lra.
  - exists c. split; [exact I | exact E].
Qed.

(* Near the start the quotient is on that side of its limit on which its slope is. *)
Lemma near_the_start sign : sign = 1 \/ sign = -1 -> 0 < sign * alpha -> exists d, 0 < d /\ forall t, 0 < t < d ->
  0 < sign * (f t / sin t - (1 + g r z + 2 * z * r * u r z)).
Proof.
  intros Sg Pos. pose proof (w_pos z Hz) as Hw. pose proof PI_RGT_0 as Hpi.
  assert (CS : is_lim (fun t => sign * S (w z * t / r)) 0 (sign * alpha)).
  { set (F := fun t => sign * S (w z * t / r)).
    assert (X : is_lim F 0 (F 0)).
    { apply is_lim_continuity, continuity_pt_filterlim.
      apply (ex_derive_continuous (K := R_AbsRing) (V := R_NormedModule)). unfold F, S. auto_derive. trivial. }
    replace (F 0) with (sign * alpha) in X; [exact X|].
    unfold F. replace (w z * 0 / r) with 0 by (field; lra). unfold S. rewrite cos_0, sin_0. ring. }
  apply is_lim_spec in CS. destruct (CS (mkposreal _ Pos)) as [d Hd]. simpl in Hd. pose proof (cond_pos d) as Pd.
  set (d' := Rmin d PI). assert (Id : 0 < d' /\ d' <= d /\ d' <= PI).
  { unfold d'. split; [apply Rmin_glb_lt; lra | split; [apply Rmin_l | apply Rmin_r]]. }
  assert (SP : forall t, 0 < t < d' -> 0 < sign * S (w z * t / r)).
  { intros t Ht. assert (B : Rabs (sign * S (w z * t / r) - sign * alpha) < sign * alpha).
    { apply Hd; [|lra]. change (Rabs (t - 0) < d). rewrite Rminus_0_r, Rabs_right; lra. }
    apply Rabs_lt_between in B. lra. }
  assert (WP : forall t, 0 < t < d' -> 0 < sign * W t).
  { intros t Ht. destruct (mean_value W _ 0 t ltac:(lra) W_rate) as [c [Ic E]]. rewrite (proj1 W_ends), Rminus_0_r in E.
    rewrite E. pose proof (SP c ltac:(lra)). pose proof (sin_gt_0 c ltac:(lra) ltac:(lra)). pose proof (exp_pos (- z * c / r)).
    replace (sign * (exp (- z * c / r) * S (w z * c / r) * sin c * (t - 0)))
      with (exp (- z * c / r) * (sign * S (w z * c / r)) * sin c * t) by ring.
    apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]|]; lra. }
  assert (Up : forall a b, 0 < a -> a < b -> b < d' -> 0 < sign * (f b / sin b - f a / sin a)).
  { intros a b Ha Hab Hb. destruct (quotient_difference a b) as [c [Ic E]]; [lra | lra | lra |]. rewrite E.
    pose proof (WP c ltac:(lra)). pose proof (sin_gt_0 c ltac:(lra) ltac:(lra)).
    replace (sign * (W c / sin c ^ 2 * (b - a))) with (sign * W c * / sin c ^ 2 * (b - a)) by (unfold Rdiv; ring).
    assert (0 < / sin c ^ 2) by (apply Rinv_0_lt_compat; nra).
    apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra. }
  exists d'. split; [lra|]. intros t Ht. pose proof (single_is_a_scene r z 0 A) as Sc.
  destruct (demand_limits _ Sc) as [L0 _]. destruct (single_values r z 0) as [_ [_ [_ [_ [EH EM]]]]]. rewrite EH, EM in L0.
  set (m := f (t / 2) / sin (t / 2)). assert (Um : 0 < sign * (f t / sin t - m)) by (apply Up; lra).
  apply Rlt_le_trans with (1 := Um). apply Rnot_lt_le. intros Below.
  set (e := sign * ((1 + g r z + 2 * z * r * u r z) - m)).
  assert (He : 0 < e) by (unfold e; destruct Sg as [-> | ->]; lra).
  apply is_lim_spec in L0. destruct (L0 (mkposreal e He)) as [h Hh]. simpl in Hh. pose proof (cond_pos h) as Ph.
  set (a := Rmin (h / 2) (t / 4)). assert (Ia : 0 < a < t / 2 /\ a < h).
  { unfold a. pose proof (Rmin_l (h / 2) (t / 4)). pose proof (Rmin_r (h / 2) (t / 4)).
    assert (0 < Rmin (h / 2) (t / 4)) by (apply Rmin_glb_lt; lra). lra. }
  assert (B : Rabs (demand (single_mass r z 0) a - (g r z + 2 * z * r * u r z + 1)) < e).
  { apply Hh; [|lra]. change (Rabs (a - 0) < h). rewrite Rminus_0_r, Rabs_right; lra. }
  rewrite single_demand in B. apply Rabs_lt_between in B.
  pose proof (Up a (t / 2) ltac:(lra) ltac:(lra) ltac:(lra)) as Ua. fold m in Ua.
  unfold e in B. destruct Sg as [-> | ->]; lra.
Qed.

Lemma largest_at_start t : 0 < t < PI -> f t / sin t <= 1 + g r z + 2 * z * r * u r z.
Proof.
  intros Ht. pose proof (single_is_a_scene r z 0 A) as Sc. destruct (demand_limits _ Sc) as [L0 L1].
  destruct (single_values r z 0) as [_ [_ [_ [_ [EH EM]]]]]. rewrite EH, EM in L0, L1.
  assert (SQ : forall c, 0 < c < PI -> 0 < / sin c ^ 2).
  { intros c Hc. apply Rinv_0_lt_compat. pose proof (sin_gt_0 c ltac:(lra) ltac:(lra)). nra. }
  apply Rnot_lt_le. intros Above.
  destruct (sign_of_W t Ht) as [N|N].
  - set (e := f t / sin t - (1 + g r z + 2 * z * r * u r z)). assert (He : 0 < e) by (unfold e; lra).
    apply is_lim_spec in L0. destruct (L0 (mkposreal e He)) as [d Hd]. simpl in Hd. pose proof (cond_pos d).
    set (a := Rmin (d / 2) (t / 2)). assert (Ia : 0 < a < t /\ a < d).
    { unfold a. pose proof (Rmin_l (d / 2) (t / 2)). pose proof (Rmin_r (d / 2) (t / 2)).
      assert (0 < Rmin (d / 2) (t / 2)) by (apply Rmin_glb_lt; lra). lra. }
    assert (B : Rabs (demand (single_mass r z 0) a - (g r z + 2 * z * r * u r z + 1)) < e).
    { apply Hd; [|lra]. change (Rabs (a - 0) < d). rewrite Rminus_0_r, Rabs_right; lra. }
    rewrite single_demand in B. apply Rabs_lt_between in B.
    destruct (quotient_difference a t) as [c [Ic E]]; [lra | lra | lra |].
    pose proof (N c ltac:(lra)). pose proof (SQ c ltac:(lra)).
    assert (W c / sin c ^ 2 * (t - a) <= 0) by (unfold Rdiv; apply Rmult_le_0_r; [apply Rmult_le_0_r|]; lra). unfold e in B. lra.
  - apply is_lim_spec in L1. destruct (L1 (mkposreal 2 ltac:(lra))) as [d Hd]. simpl in Hd. pose proof (cond_pos d).
    set (a := Rmax (PI - d / 2) ((t + PI) / 2)). assert (Ia : t < a < PI /\ PI - d < a).
    { unfold a. pose proof (Rmax_l (PI - d / 2) ((t + PI) / 2)). pose proof (Rmax_r (PI - d / 2) ((t + PI) / 2)).
      assert (Rmax (PI - d / 2) ((t + PI) / 2) < PI) by (apply Rmax_lub_lt; lra). lra. }
    assert (B : Rabs (demand (single_mass r z 0) a - (g r z + 2 * z * r * u r z - 1)) < 2).
    { apply Hd; [|lra]. change (Rabs (a - PI) < d). rewrite Rabs_left1; lra. }
    rewrite single_demand in B. apply Rabs_lt_between in B.
    destruct (quotient_difference t a) as [c [Ic E]]; [lra | lra | lra |].
    pose proof (N c ltac:(lra)). pose proof (SQ c ltac:(lra)).
    assert (0 <= W c / sin c ^ 2 * (a - t)) by (unfold Rdiv; apply Rmult_le_pos; [apply Rmult_le_pos|]; lra). lra.
Qed.
End Mode.

Theorem eq_57_largest_at_start : Statements.eq_57_largest_at_start.
Proof. intros r z t A Low Ht. apply largest_at_start; assumption. Qed.

Theorem eq_57_beside_the_start : Statements.eq_57_beside_the_start.
Proof.
  intros r z A. split; intros S.
  - destruct (near_the_start r z A 1 (or_introl eq_refl) ltac:(lra)) as [d [Hd H]]. exists d. split; [exact Hd|].
    intros t Ht. specialize (H t Ht). lra.
  - destruct (near_the_start r z A (-1) (or_intror eq_refl) ltac:(lra)) as [d [Hd H]]. exists d. split; [exact Hd|].
    intros t Ht. specialize (H t Ht). lra.
Qed.

(* All modes: *)
Lemma demand_largest_at_start s : is_scene s -> (forall i, (i < masses s)%nat -> w (damping_ratio s i) <= 2 * ratio s i) ->
  forall t, 0 < t < PI -> demand s t <= H_j s + mobility s.
Proof.
  intros Sc Low t Ht. unfold demand, H_j, mobility, Rdiv. rewrite <- Sum_scal_r, <- Sum_plus. apply Sum_le. intros i Hi.
  destruct Sc as [_ [_ [Adm _]]]. pose proof (largest_at_start _ _ (Adm i Hi) (Low i Hi) t Ht) as L. unfold Rdiv in L.
  pose proof (pow2_ge_0 (shape s (contact s) i)). nra.
Qed.

Lemma supremum_at_start s : is_scene s -> (forall i, (i < masses s)%nat -> w (damping_ratio s i) <= 2 * ratio s i) ->
  supremum_of_demand s (H_j s + mobility s).
Proof.
  intros Sc Low. pose proof (demand_largest_at_start s Sc Low) as Top. pose proof (mobility_pos s Sc) as Mp.
  destruct (demand_limits s Sc) as [L0 _]. pose proof PI_RGT_0.
  split; [intros y [t [Ht ->]]; apply Top, Ht|]. intros b Up. apply Rnot_lt_le. intros Above.
  apply is_lim_spec in L0. destruct (L0 (mkposreal (H_j s + mobility s - b) ltac:(lra))) as [d Hd]. simpl in Hd.
  pose proof (cond_pos d). set (a := Rmin (d / 2) 1). assert (Ia : 0 < a <= 1 /\ a < d).
  { unfold a. pose proof (Rmin_l (d / 2) 1). pose proof (Rmin_r (d / 2) 1).
    assert (0 < Rmin (d / 2) 1) by (apply Rmin_glb_lt; lra). lra. }
  assert (P1 : 1 < PI) by (pose proof PI2_1; lra).
  assert (B : Rabs (demand s a - (H_j s + mobility s)) < H_j s + mobility s - b).
  { apply Hd; [|lra]. change (Rabs (a - 0) < d). rewrite Rminus_0_r, Rabs_right; lra. }
  apply Rabs_lt_between in B. assert (demand s a <= b) by (apply Up; exists a; split; [lra | reflexivity]). lra.
Qed.

Theorem eq_67_is_the_limit : forall s, Statements.eq_67_is_the_limit s.
Proof.
  intros s mu Sc Low Hm Hb HV. pose proof (mobility_pos s Sc) as Mp.
  pose proof (eq_69 s mu _ Sc Hm Hb HV (supremum_at_start s Sc Low)) as E. unfold limit_69 in E. rewrite Rmax_right in E by nra.
    exact E.
Qed.
