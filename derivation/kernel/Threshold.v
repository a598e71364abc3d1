(* The damping from which on (57) rises from the start at no frequency. Bounds on boxes are by the tactics of the library
   Interval, with integers of Coq itself, so that nothing but the axioms of the reals is assumed. *)
Require Import Reals Lra Psatz List.
From Coquelicot Require Import Coquelicot.
From Interval.Float Require Specific_stdz Specific_ops.
From Interval.Interval Require Float_full.
From Interval.Tactics Require Interval_helper.
From Kernel Require Import Statements Modes SteadyMode Contact LargestDemand.
Open Scope R_scope.

Module Numbers := Specific_ops.SpecificFloat Specific_stdz.StdZRadix2.
Module Intervals := Float_full.FloatIntervalFull Numbers.
Module Boxes := Interval_helper.IntervalTacticAux Intervals.
Ltac by_boxes variables :=
  Boxes.do_interval (@None R) variables (Numbers.PtoP 20) 10%nat 60%nat false false Interval_helper.itm_naive.

(* The slope has the sign of this function of theta and kappa = zeta / w. *)
Definition sign_of_slope t k :=
  sin t * (1 - PI ^ 2 / ((1 + k ^ 2) * t ^ 2) - 2 * k ^ 2 / (1 + k ^ 2)) - 2 * k / (1 + k ^ 2) * (exp (k * t) + cos t).

Lemma negative_in_the_box t k : 6 <= t <= 12 -> 1424 / 10000 <= k <= 31 / 100 -> sign_of_slope t k < 0.
Proof. intros T K. unfold sign_of_slope. by_boxes (t :: k :: nil). Qed.

Lemma negative_beyond k : 1424 / 10000 <= k <= 31 / 100 -> 1 <= 2 * k / (1 + k ^ 2) * (exp (k * 12) - 1).
Proof. intros K. by_boxes (k :: nil). Qed.

Lemma positive_at_808 k : 0 <= k <= 13934 / 100000 -> 0 < sign_of_slope (808 / 100) k.
Proof. intros K. unfold sign_of_slope. by_boxes (k :: nil). Qed.

Lemma cos_808 : -1 / 2 <= cos (808 / 100).
Proof. by_boxes (@nil R). Qed.
Lemma pi_between : 314 / 100 <= PI <= 315 / 100.
Proof. split; by_boxes (@nil R). Qed.

Lemma kappa r z : 0 < r -> 0 <= z < 1 -> let k := z / w z in let t := theta r z in
  z ^ 2 = k ^ 2 / (1 + k ^ 2) /\ z * w z = k / (1 + k ^ 2) /\ r ^ 2 = PI ^ 2 / ((1 + k ^ 2) * t ^ 2) /\ decay r z = k * t.
Proof.
  intros Hr Hz k t. pose proof (w_pos z Hz) as Hw. pose proof (w_sq z Hz) as W. pose proof PI_RGT_0.
  assert (K : 1 + k ^ 2 = / (w z * w z)).
  { unfold k. replace (1 + (z / w z) ^ 2) with ((w z * w z + z * z) / (w z * w z)) by (field; lra).
    replace (w z * w z + z * z) with 1 by lra. field. lra. }
  rewrite K. unfold k, t, theta, decay. repeat split; field; lra.
Qed.

Lemma slope_by_sign r z : admissible r z ->
  slope_at_start r z * (r * w z * (cosh (decay r z) + cos (theta r z))) = sign_of_slope (theta r z) (z / w z) /\
  0 < r * w z * (cosh (decay r z) + cos (theta r z)).
Proof.
  intros A. pose proof A as [Hr [Hz [HD _]]]. split.
  - rewrite slope_factor by exact A. destruct (kappa r z Hr Hz) as [E1 [E2 [E3 E4]]]. unfold sign_of_slope. rewrite <- E4.
    rewrite <- E3. replace (2 * (z / w z) ^ 2 / (1 + (z / w z) ^ 2)) with (2 * ((z / w z) ^ 2 / (1 + (z / w z) ^ 2))) by (unfold
      Rdiv; ring).
    replace (2 * (z / w z) / (1 + (z / w z) ^ 2)) with (2 * (z / w z / (1 + (z / w z) ^ 2))) by (unfold Rdiv; ring).
    rewrite <- E1, <- E2. ring.
  - repeat apply Rmult_lt_0_compat; [exact Hr | apply w_pos, Hz | apply denominator_pos; assumption].
Qed.

Lemma square_of_kappa k c : 0 <= c -> 0 <= k -> k <= c \/ c ^ 2 / (1 + c ^ 2) < k ^ 2 / (1 + k ^ 2).
Proof.
  intros Hc Hk. destruct (Rle_lt_dec k c) as [L|L]; [left; exact L | right].
  assert (0 <= c ^ 2) by nra. assert (c ^ 2 < k ^ 2) by nra.
  apply (Rmult_lt_reg_r ((1 + c ^ 2) * (1 + k ^ 2))); [nra|].
  replace (c ^ 2 / (1 + c ^ 2) * ((1 + c ^ 2) * (1 + k ^ 2))) with (c ^ 2 * (1 + k ^ 2)) by (field; lra).
  replace (k ^ 2 / (1 + k ^ 2) * ((1 + c ^ 2) * (1 + k ^ 2))) with (k ^ 2 * (1 + c ^ 2)) by (field; lra). nra.
Qed.

Lemma below_from_the_threshold r z : admissible r z -> 141 / 1000 <= z -> slope_at_start r z <= 0.
Proof.
  intros A T. pose proof A as [Hr [Hz [HD _]]]. pose proof (w_pos z Hz) as Hw. pose proof (w_sq z Hz) as W.
  pose proof pi_between as Hpi. destruct (Rle_lt_dec (w z) (2 * r)) as [Low|High]; [apply starts_falling; assumption|].
  destruct (slope_by_sign r z A) as [E P]. destruct (kappa r z Hr Hz) as [E1 [E2 [E3 E4]]].
  set (k := z / w z) in *. set (t := theta r z) in *.
  assert (Hk : 0 < k) by (unfold k; apply Rdiv_lt_0_compat; lra).
  assert (Ht : 6 < t).
  { unfold t, theta. apply (Rmult_lt_reg_r r); [lra|]. replace (PI * w z / r * r) with (PI * w z) by (field; lra). nra. }
  assert (G : sign_of_slope t k <= 0).
  { assert (F : -1 <= 1 - PI ^ 2 / ((1 + k ^ 2) * t ^ 2) - 2 * k ^ 2 / (1 + k ^ 2) <= 1).
    { rewrite <- E3. replace (2 * k ^ 2 / (1 + k ^ 2)) with (2 * (k ^ 2 / (1 + k ^ 2))) by (unfold Rdiv; ring). rewrite <- E1.
      assert (4 * r ^ 2 < w z * w z) by nra. assert (0 <= r ^ 2) by nra. assert (z ^ 2 < 1) by nra. split; nra. }
    pose proof (SIN_bound t) as SB. pose proof (COS_bound t) as CB.
    assert (LS : sin t * (1 - PI ^ 2 / ((1 + k ^ 2) * t ^ 2) - 2 * k ^ 2 / (1 + k ^ 2)) <= 1).
    { set (x := 1 - _ - _) in *. apply Rle_trans with (Rabs (sin t * x)); [apply Rle_abs|]. rewrite Rabs_mult.
      assert (Rabs (sin t) <= 1) by (apply Rabs_le; lra). assert (Rabs x <= 1) by (apply Rabs_le; lra).
      pose proof (Rabs_pos (sin t)). pose proof (Rabs_pos x). nra. }
    assert (Kp : 0 < 2 * k / (1 + k ^ 2)) by (apply Rdiv_lt_0_compat; nra).
    assert (EX : 1 + k * t < exp (k * t)) by (apply exp_ineq1; nra).
    destruct (Rle_lt_dec (29 / 100) z) as [Z|Z].
    - assert (1 <= 2 * k / (1 + k ^ 2) * (k * t)).
      { replace (2 * k / (1 + k ^ 2) * (k * t)) with (2 * (k ^ 2 / (1 + k ^ 2)) * t) by (field; nra). rewrite <- E1. nra. }
      assert (2 * k / (1 + k ^ 2) * (k * t) <= 2 * k / (1 + k ^ 2) * (exp (k * t) + cos t)) by (apply Rmult_le_compat_l; lra).
      unfold sign_of_slope. lra.
    - assert (Kt : k <= 31 / 100).
      { destruct (square_of_kappa k (31 / 100)) as [L|L]; [lra | lra | exact L |]. rewrite <- E1 in L. nra. }
      assert (Kb : 1424 / 10000 <= k).
      { apply Rnot_lt_le. intros L. destruct (square_of_kappa (1424 / 10000) k) as [Q|Q]; [lra | lra | lra |].
        rewrite <- E1 in Q. nra. }
      destruct (Rle_lt_dec t 12) as [B|B]; [apply Rlt_le, negative_in_the_box; lra|].
      pose proof (negative_beyond k ltac:(lra)) as N.
      assert (exp (k * 12) < exp (k * t)) by (apply exp_increasing; nra).
      assert (2 * k / (1 + k ^ 2) * (exp (k * 12) - 1) <= 2 * k / (1 + k ^ 2) * (exp (k * t) + cos t)) by (apply
        Rmult_le_compat_l; lra).
      unfold sign_of_slope. lra. }
  apply Rnot_lt_le. intros Pos. pose proof (Rmult_lt_0_compat _ _ Pos P). lra.
Qed.

Lemma rises_below_the_threshold z : 0 <= z <= 138 / 1000 -> exists r, admissible r z /\ 0 < slope_at_start r z.
Proof.
  intros Hz0. assert (Hz : 0 <= z < 1) by lra. pose proof (w_pos z Hz) as Hw. pose proof (w_sq z Hz) as W.
  pose proof pi_between as Hpi. set (r := PI * w z / (808 / 100)). exists r.
  assert (Hr : 0 < r) by (unfold r; apply Rdiv_lt_0_compat; nra).
  assert (T : theta r z = 808 / 100) by (unfold theta, r; field; lra).
  assert (w z <= 1) by nra. assert (r < 1 / 2) by (unfold r; apply (Rmult_lt_reg_r (808 / 100)); [lra|];
    replace (PI * w z / (808 / 100) * (808 / 100)) with (PI * w z) by field; nra).
  assert (A : admissible r z).
  { split; [exact Hr|]. split; [exact Hz|]. split.
    - rewrite T. pose proof cos_808. assert (1 <= cosh (decay r z)); [|lra].
      destruct (Req_dec (decay r z) 0) as [E|E]; [rewrite E, cosh_0; lra | apply Rlt_le, Misprints.cosh_above, E].
    - assert (0 < (1 - r * r) ^ 2) by nra. pose proof (pow2_ge_0 (2 * z * r)). lra. }
  split; [exact A|]. destruct (slope_by_sign r z A) as [E P]. rewrite T in E.
  destruct (kappa r z Hr Hz) as [E1 _]. assert (Hk : 0 <= z / w z) by (apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat,
    Hw]).
  assert (K : z / w z <= 13934 / 100000).
  { destruct (square_of_kappa (z / w z) (13934 / 100000)) as [L|L]; [lra | lra | exact L |]. rewrite <- E1 in L. nra. }
  pose proof (positive_at_808 (z / w z) ltac:(lra)) as S. rewrite <- E in S.
  apply (Rmult_lt_reg_r (r * w z * (cosh (decay r z) + cos (theta r z)))); [exact P|]. rewrite Rmult_0_l, T. exact S.
Qed.

Theorem eq_57_threshold : Statements.eq_57_threshold.
Proof. split; [exact rises_below_the_threshold | exact below_from_the_threshold]. Qed.
