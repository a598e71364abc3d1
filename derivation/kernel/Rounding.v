(* Proofs of what is said of rounding. *)
Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core Relative.
From Kernel Require Import Statements RoundingStatements.
Open Scope R_scope.

Lemma unit_small : 0 < unit_roundoff <= / 1000000.
Proof. unfold unit_roundoff. split; [apply Rinv_0_lt_compat, pow_lt; lra|]. apply Rinv_le_contravar; [lra|]. simpl. lra. Qed.

Theorem nearest_rounds_correctly : RoundingStatements.nearest_rounds_correctly.
Proof.
  intros x. destruct (relative_error_N_FLX_ex radix2 53 ltac:(lia) (fun n => negb (Z.even n)) x) as [e [He E]]. exists e. split;
    [|exact E].
  eapply Rle_trans; [exact He|]. apply Req_le. unfold unit_roundoff. simpl. lra.
Qed.

(* x is y up to k times the unit roundoff *)
Definition within (k x y : R) := exists e, Rabs e <= k * unit_roundoff /\ x = y * (1 + e).
Definition slack := / 1000.

Lemma within_exact x : within 0 x x.
Proof. exists 0. rewrite Rabs_R0. split; [lra | ring]. Qed.
Lemma within_more k l x y : k <= l -> within k x y -> within l x y.
Proof. intros H [e [He E]]. exists e. split; [|exact E]. pose proof unit_small. nra. Qed.
Lemma within_mult k l x y x' y' : 0 <= k <= 16 -> 0 <= l <= 16 -> within k x y -> within l x' y' -> within (k + l + slack) (x *
  x') (y * y').
Proof.
  intros Hk Hl [e [He ->]] [f [Hf ->]]. exists (e + f + e * f). split; [|ring]. pose proof unit_small as U.
  eapply Rle_trans; [apply Rabs_triang|]. pose proof (Rabs_triang e f). rewrite Rabs_mult. pose proof (Rabs_pos e). pose proof
    (Rabs_pos f).
  assert (Rabs e * Rabs f <= 16 * unit_roundoff * (16 * unit_roundoff)) by (apply Rmult_le_compat; nra).
  assert (16 * unit_roundoff * (16 * unit_roundoff) <= slack * unit_roundoff) by (unfold slack; nra). lra.
Qed.
Lemma within_inv l x y : 0 <= l <= 16 -> y <> 0 -> within l x y -> within (l + slack) (/ x) (/ y).
Proof.
  intros Hl Hy [f [Hf ->]]. pose proof unit_small as U. pose proof (Rabs_pos f).
  assert (B : Rabs f <= / 10000) by (eapply Rle_trans; [exact Hf | nra]). assert (P : 0 < 1 + f) by (unfold Rabs in B; destruct
    (Rcase_abs f); lra).
  exists (- f / (1 + f)). split; [|field; split; [lra | exact Hy]].
  unfold Rdiv. rewrite Rabs_mult, Rabs_Ropp, (Rabs_right (/ (1 + f))) by (apply Rle_ge, Rlt_le, Rinv_0_lt_compat, P).
  apply (Rmult_le_reg_r (1 + f)); [exact P|]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  assert (LU : 0 <= l * unit_roundoff) by nra.
  assert (F : - (l * unit_roundoff) <= f) by (unfold Rabs in Hf; destruct (Rcase_abs f); lra).
  assert (G : (l + slack) * unit_roundoff * (1 - l * unit_roundoff) <= (l + slack) * unit_roundoff * (1 + f))
    by (apply Rmult_le_compat_l; [apply Rmult_le_pos; unfold slack; lra | lra]).
  assert (S : (l + slack) * (l * unit_roundoff) <= slack).
  { apply Rle_trans with (17 * (16 * / 1000000)); [apply Rmult_le_compat; unfold slack; nra | unfold slack; lra]. }
  assert ((l + slack) * (l * unit_roundoff) * unit_roundoff <= slack * unit_roundoff) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma within_div k l x y x' y' : 0 <= k <= 16 -> 0 <= l <= 15 -> y' <> 0 -> within k x y -> within l x' y' -> within (k + l + 2
  * slack) (x / x') (y / y').
Proof.
  intros Hk Hl Hy A B. unfold Rdiv. apply (within_more (k + (l + slack) + slack)); [lra|]. apply within_mult; [exact Hk | unfold
    slack; lra | exact A|].
  apply within_inv; [lra | exact Hy | exact B].
Qed.
Lemma within_rnd rnd k x y : rounds_correctly rnd -> 0 <= k <= 15 -> within k x y -> within (k + 1 + slack) (rnd x) y.
Proof.
  intros Hr Hk A. destruct (Hr x) as [e [He E]]. rewrite E. replace y with (y * 1) by ring. apply within_mult; [lra | lra |
    exact A|].
  exists e. split; [lra | ring].
Qed.
Lemma within_opp k x y : within k x y -> within k (- x) (- y).
Proof. intros [e [He ->]]. exists e. split; [exact He | ring]. Qed.
(* two terms of one sign, of which the second is not the larger and is off by not less *)
Lemma within_plus k l x y x' y' : 0 <= k <= l -> 0 <= y * y' -> Rabs y' <= Rabs y -> within k x y -> within l x' y' ->
  within ((k + l) / 2) (x + x') (y + y').
Proof.
  intros Hk Hs Hle [e [He ->]] [f [Hf ->]]. pose proof unit_small as U.
  assert (S : Rabs (y + y') = Rabs y + Rabs y').
  { unfold Rabs in *. destruct (Rcase_abs y); destruct (Rcase_abs y'); destruct (Rcase_abs (y + y')); nra. }
  destruct (Req_dec (y + y') 0) as [Z|Z].
  - rewrite Z, Rabs_R0 in S. pose proof (Rabs_pos y). pose proof (Rabs_pos y').
    assert (y = 0) by (unfold Rabs in *; destruct (Rcase_abs y); destruct (Rcase_abs y'); lra).
    assert (y' = 0) by (unfold Rabs in *; destruct (Rcase_abs y); destruct (Rcase_abs y'); lra). subst.
    exists 0. rewrite Rabs_R0. split; [nra | ring].
  - exists ((y * e + y' * f) / (y + y')). split; [|field; exact Z].
    unfold Rdiv. rewrite Rabs_mult, Rabs_Rinv by exact Z. assert (P : 0 < Rabs (y + y')) by (apply Rabs_pos_lt, Z).
    apply (Rmult_le_reg_r (Rabs (y + y'))); [exact P|]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult, S.
    assert (Rabs y * Rabs e <= Rabs y * (k * unit_roundoff)) by (apply Rmult_le_compat_l; [apply Rabs_pos | exact He]).
    assert (Rabs y' * Rabs f <= Rabs y' * (l * unit_roundoff)) by (apply Rmult_le_compat_l; [apply Rabs_pos | exact Hf]).
    assert (0 <= (Rabs y - Rabs y') * ((l - k) * unit_roundoff)) by (apply Rmult_le_pos; [lra | nra]). nra.
Qed.
Lemma within_off k units x y : k <= 2 * units -> within k x y -> off_by units x y.
Proof.
  intros H [e [He ->]]. unfold off_by. replace (y * (1 + e) - y) with (y * e) by ring. rewrite Rabs_mult, (Rmult_comm (Rabs y)).
  apply Rmult_le_compat_r; [apply Rabs_pos|]. pose proof unit_small. nra.
Qed.

Section Forms.
Variable rnd : R -> R.
Hypothesis Hr : rounds_correctly rnd.

Lemma a_within r : within (3 + 4 * slack) (computed_a rnd r) (1 - r * r).
Proof.
  unfold computed_a. replace (1 - r * r) with ((1 - r) * (1 + r)) by ring.
  apply (within_more (0 + 1 + slack + (0 + 1 + slack) + slack + 1 + slack)); [lra|]. unfold slack.
  apply (within_rnd rnd); [exact Hr | lra|]. apply within_mult; [lra | lra | |]; apply (within_rnd rnd); try exact Hr; try lra;
    apply within_exact.
Qed.
Lemma b_within r z : within (1 + slack) (computed_b rnd r z) (2 * z * r).
Proof. unfold computed_b. apply (within_more (0 + 1 + slack)); [lra|]. apply (within_rnd rnd); [exact Hr | lra | apply
  within_exact]. Qed.

Lemma off_re_within r z : 1 - r * r <> 0 -> Rabs (2 * z * r) <= Rabs (1 - r * r) ->
  within (7 + / 10) (off_resonance_re rnd r z) (1 / (1 - r * r + 2 * z * r * (2 * z * r / (1 - r * r)))).
Proof.
  intros Ha Hba. set (a := 1 - r * r) in *. set (b := 2 * z * r) in *. unfold off_resonance_re. cbv zeta.
  pose proof (a_within r) as A. fold a in A. pose proof (b_within r z) as B. fold b in B.
  set (ca := computed_a rnd r) in *. set (cb := computed_b rnd r z) in *.
  assert (Q : within (5 + / 100) (rnd (cb / ca)) (b / a)).
  { apply (within_more (1 + slack + (3 + 4 * slack) + 2 * slack + 1 + slack)); [unfold slack; lra|].
    apply (within_rnd rnd); [exact Hr | unfold slack; lra|]. apply within_div; [unfold slack; lra | unfold slack; lra | exact Ha
      | exact B | exact A]. }
  assert (T : within (7 + / 50) (rnd (cb * rnd (cb / ca))) (b * (b / a))).
  { apply (within_more (1 + slack + (5 + / 100) + slack + 1 + slack)); [unfold slack; lra|].
    apply (within_rnd rnd); [exact Hr | unfold slack; lra|]. apply within_mult; [unfold slack; lra | lra | exact B | exact Q]. }
  assert (Sg : 0 <= a * (b * (b / a))) by (replace (a * (b * (b / a))) with (b * b) by (field; exact Ha); nra).
  assert (Le : Rabs (b * (b / a)) <= Rabs a).
  { unfold Rdiv. rewrite !Rabs_mult, Rabs_Rinv by exact Ha. pose proof (Rabs_pos_lt a Ha). pose proof (Rabs_pos b).
    apply (Rmult_le_reg_r (Rabs a)); [lra|]. replace (Rabs b * (Rabs b * / Rabs a) * Rabs a) with (Rabs b * Rabs b) by (field;
      lra). nra. }
  assert (Sum : within (6 + / 20) (rnd (ca + rnd (cb * rnd (cb / ca)))) (a + b * (b / a))).
  { apply (within_more ((3 + 4 * slack + (7 + / 50)) / 2 + 1 + slack)); [unfold slack; lra|].
    apply (within_rnd rnd); [exact Hr | unfold slack; lra|]. apply within_plus; [unfold slack; lra | exact Sg | exact Le | exact
      A | exact T]. }
  assert (Nz : a + b * (b / a) <> 0).
  { intros Z. assert (E : a * a + b * b = 0) by (replace (a * a + b * b) with (a * (a + b * (b / a))) by (field; exact Ha);
    rewrite Z; ring).
    assert (0 < a * a) by (destruct (Rtotal_order a 0) as [L|[L|L]]; [nra | contradiction | nra]). nra. }
  apply (within_more (0 + (6 + / 20) + 2 * slack + 1 + slack)); [unfold slack; lra|].
  apply (within_rnd rnd); [exact Hr | unfold slack; lra|]. apply within_div; [lra | lra | exact Nz | apply within_exact | exact
    Sum].
Qed.

Lemma near_within r z : 2 * z * r <> 0 -> Rabs (1 - r * r) <= Rabs (2 * z * r) ->
  within (5 + / 100) (near_resonance_quotient rnd r z) ((1 - r * r) / (2 * z * r)) /\
  within (6 + / 20) (near_resonance_sum rnd r z) (2 * z * r + (1 - r * r) * ((1 - r * r) / (2 * z * r))) /\
  2 * z * r + (1 - r * r) * ((1 - r * r) / (2 * z * r)) <> 0.
Proof.
  intros Hb Hab. set (a := 1 - r * r) in *. set (b := 2 * z * r) in *.
  pose proof (a_within r) as A. fold a in A. pose proof (b_within r z) as B. fold b in B.
  unfold near_resonance_sum, near_resonance_quotient. set (ca := computed_a rnd r) in *. set (cb := computed_b rnd r z) in *.
  assert (Q : within (5 + / 100) (rnd (ca / cb)) (a / b)).
  { apply (within_more (3 + 4 * slack + (1 + slack) + 2 * slack + 1 + slack)); [unfold slack; lra|].
    apply (within_rnd rnd); [exact Hr | unfold slack; lra|]. apply within_div; [unfold slack; lra | unfold slack; lra | exact Hb
      | exact A | exact B]. }
  assert (T : within (9 + / 50) (rnd (ca * rnd (ca / cb))) (a * (a / b))).
  { apply (within_more (3 + 4 * slack + (5 + / 100) + slack + 1 + slack)); [unfold slack; lra|].
    apply (within_rnd rnd); [exact Hr | unfold slack; lra|]. apply within_mult; [unfold slack; lra | lra | exact A | exact Q]. }
  assert (Sg : 0 <= b * (a * (a / b))) by (replace (b * (a * (a / b))) with (a * a) by (field; exact Hb); nra).
  assert (Le : Rabs (a * (a / b)) <= Rabs b).
  { unfold Rdiv. rewrite !Rabs_mult, Rabs_Rinv by exact Hb. pose proof (Rabs_pos_lt b Hb). pose proof (Rabs_pos a).
    apply (Rmult_le_reg_r (Rabs b)); [lra|]. replace (Rabs a * (Rabs a * / Rabs b) * Rabs b) with (Rabs a * Rabs a) by (field;
      lra). nra. }
  split; [exact Q|]. split.
  - apply (within_more ((1 + slack + (9 + / 50)) / 2 + 1 + slack)); [unfold slack; lra|].
    apply (within_rnd rnd); [exact Hr | unfold slack; lra|]. apply within_plus; [unfold slack; lra | exact Sg | exact Le | exact
      B | exact T].
  - intros Z. assert (E : b * b + a * a = 0) by (replace (b * b + a * a) with (b * (b + a * (a / b))) by (field; exact Hb);
    rewrite Z; ring).
    assert (0 < b * b) by (destruct (Rtotal_order b 0) as [L|[L|L]]; [nra | contradiction | nra]). nra.
Qed.

Lemma high_within r z : 2 <= r -> within (2 + / 50) (high_frequency_A rnd r) (/ r * / r - 1) /\
  within (6 + / 10) (high_frequency_D rnd r z) ((/ r * / r - 1) * (/ r * / r - 1) + 2 * z * / r * (2 * z * / r)) /\
  0 < (/ r * / r - 1) * (/ r * / r - 1) + 2 * z * / r * (2 * z * / r).
Proof.
  intros H. assert (P : within (1 + 4 * slack) (rnd (1 / r)) (/ r)).
  { apply (within_more (0 + 1 + slack)); [unfold slack; lra|]. apply (within_rnd rnd); [exact Hr | lra|]. replace (1 / r) with
    (/ r) by (field; lra). apply within_exact. }
  assert (Ip : 0 < / r <= / 2) by (split; [apply Rinv_0_lt_compat; lra | apply Rinv_le_contravar; lra]).
  assert (P2 : within (3 + / 80) (rnd (rnd (1 / r) * rnd (1 / r))) (/ r * / r)).
  { apply (within_more (1 + 4 * slack + (1 + 4 * slack) + slack + 1 + slack)); [unfold slack; lra|].
    apply (within_rnd rnd); [exact Hr | unfold slack; lra|]. apply within_mult; [unfold slack; lra | unfold slack; lra | exact P
      | exact P]. }
  set (p := / r) in *. assert (Hp2 : 0 < p * p <= / 4) by (split; nra).
  assert (A0 : within (1 + / 80) (rnd (rnd (1 / r) * rnd (1 / r)) - 1) (p * p - 1)).
  { destruct P2 as [e [He E]]. rewrite E. exists (p * p * e / (p * p - 1)). split; [|field; lra].
    unfold Rdiv. rewrite !Rabs_mult, Rabs_Rinv, (Rabs_left (p * p - 1)), (Rabs_right p) by lra. pose proof unit_small. pose
      proof (Rabs_pos e).
    apply (Rmult_le_reg_r (- (p * p - 1))); [lra|]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    assert (p * p * Rabs e <= / 4 * ((3 + / 80) * unit_roundoff)) by (apply Rmult_le_compat; lra).
    assert ((1 + / 80) * unit_roundoff * (3 / 4) <= (1 + / 80) * unit_roundoff * - (p * p - 1)) by (apply Rmult_le_compat_l;
      nra). lra. }
  assert (A : within (2 + / 50) (high_frequency_A rnd r) (p * p - 1)).
  { unfold high_frequency_A. apply (within_more (1 + / 80 + 1 + slack)); [unfold slack; lra|]. apply (within_rnd rnd); [exact Hr
    | lra | exact A0]. }
  split; [exact A|]. assert (Pos : 0 < (p * p - 1) * (p * p - 1) + 2 * z * p * (2 * z * p)) by nra. split; [|exact Pos].
  assert (B : within (2 + / 50) (rnd (2 * z * rnd (1 / r))) (2 * z * p)).
  { apply (within_more (0 + (1 + 4 * slack) + slack + 1 + slack)); [unfold slack; lra|]. apply (within_rnd rnd); [exact Hr |
    unfold slack; lra|].
    apply within_mult; [lra | unfold slack; lra | apply within_exact | exact P]. }
  unfold high_frequency_D. cbv zeta. set (cA := high_frequency_A rnd r) in *. set (cB := rnd (2 * z * rnd (1 / r))) in *.
  assert (A2 : within (5 + / 20) (rnd (cA * cA)) ((p * p - 1) * (p * p - 1))).
  { apply (within_more (2 + / 50 + (2 + / 50) + slack + 1 + slack)); [unfold slack; lra|]. apply (within_rnd rnd); [exact Hr |
    unfold slack; lra|].
    apply within_mult; [lra | lra | exact A | exact A]. }
  assert (B2 : within (5 + / 20) (rnd (cB * cB)) (2 * z * p * (2 * z * p))).
  { apply (within_more (2 + / 50 + (2 + / 50) + slack + 1 + slack)); [unfold slack; lra|]. apply (within_rnd rnd); [exact Hr |
    unfold slack; lra|].
    apply within_mult; [lra | lra | exact B | exact B]. }
  apply (within_more ((5 + / 20 + (5 + / 20)) / 2 + 1 + slack)); [unfold slack; lra|]. apply (within_rnd rnd); [exact Hr | lra|].
  destruct (Rle_dec (Rabs (2 * z * p * (2 * z * p))) (Rabs ((p * p - 1) * (p * p - 1)))) as [L|L].
  - apply within_plus; [lra | | exact L | exact A2 | exact B2]. apply Rmult_le_pos; nra.
  - rewrite (Rplus_comm (rnd _)), (Rplus_comm ((p * p - 1) * (p * p - 1))). apply within_plus; [lra | | lra | exact B2 | exact
    A2]. apply Rmult_le_pos; nra.
Qed.
End Forms.

Lemma off_one r : 0 < r -> r <> 1 -> 1 - r * r <> 0.
Proof. intros H H1. replace (1 - r * r) with ((1 - r) * (1 + r)) by ring. apply Rmult_integral_contrapositive. split; lra. Qed.

Theorem v_off_resonance : RoundingStatements.v_off_resonance.
Proof.
  intros rnd r z Hr Hz H1 Hzz Hle. assert (Ha : 1 - r * r <> 0) by (apply off_one; lra).
  assert (Hb : 0 <= 2 * z * r) by (apply Rmult_le_pos; lra).
  pose proof (off_re_within rnd Hr r z Ha ltac:(rewrite (Rabs_right (2 * z * r)) by lra; exact Hle)) as Re.
  assert (D : (1 - r * r) ^ 2 + (2 * z * r) ^ 2 <> 0).
  { pose proof (pow2_ge_0 (2 * z * r)). assert (0 < (1 - r * r) ^ 2); [|lra]. destruct (Rtotal_order (1 - r * r) 0) as
    [L|[L|L]]; [nra | contradiction | nra]. }
  assert (E : 1 / (1 - r * r + 2 * z * r * (2 * z * r / (1 - r * r))) = v_re r z).
  { unfold v_re. field. repeat split; try assumption; intro K; apply D; rewrite <- K; ring. }
  rewrite E in Re. split; [apply (within_off (7 + / 10)); [lra | exact Re]|].
  replace (v_im r z) with (- (z * (2 * r) / (1 - r * r) * v_re r z)) by (unfold v_re, v_im; field; split; assumption).
  apply (within_off (13 + / 2)); [lra|]. unfold off_resonance_im. apply within_opp.
  apply (within_more (5 + / 100 + (7 + / 10) + slack + 1 + slack)); [unfold slack; lra|].
  apply (within_rnd rnd); [exact Hr | unfold slack; lra|]. apply within_mult; [lra | lra | | exact Re].
  apply (within_more (1 + slack + (3 + 4 * slack) + 2 * slack + 1 + slack)); [unfold slack; lra|].
  apply (within_rnd rnd); [exact Hr | unfold slack; lra|]. apply within_div; [unfold slack; lra | unfold slack; lra | exact Ha |
    | apply a_within, Hr].
  apply (within_more (0 + 1 + slack)); [lra|]. apply (within_rnd rnd); [exact Hr | lra | apply within_exact].
Qed.

Theorem v_near_resonance : RoundingStatements.v_near_resonance.
Proof.
  intros rnd r z Hr Hz Hzz Hle. assert (Hb : 0 < 2 * z * r) by nra.
  destruct (near_within rnd Hr r z ltac:(lra) ltac:(rewrite (Rabs_right (2 * z * r)) by lra; exact Hle)) as [Q [S Nz]].
  assert (D : (1 - r * r) ^ 2 + (2 * z * r) ^ 2 <> 0) by (pose proof (pow2_ge_0 (1 - r * r)); assert (0 < (2 * z * r) ^ 2) by
    nra; lra).
  assert (E1 : v_im r z = - 1 / (2 * z * r + (1 - r * r) * ((1 - r * r) / (2 * z * r)))).
  { unfold v_im. field. repeat split; try lra; intro K; apply D; rewrite <- K; ring. }
  assert (E2 : v_re r z = (1 - r * r) / (2 * z * r) / (2 * z * r + (1 - r * r) * ((1 - r * r) / (2 * z * r)))).
  { unfold v_re. field. repeat split; try lra; intro K; apply D; rewrite <- K; ring. }
  split.
  - rewrite E1. apply (within_off (7 + / 10)); [lra|]. apply (within_more (0 + (6 + / 20) + 2 * slack + 1 + slack)); [unfold
    slack; lra|].
    apply (within_rnd rnd); [exact Hr | unfold slack; lra|]. apply within_div; [lra | lra | exact Nz | apply within_exact |
      exact S].
  - rewrite E2. apply (within_off (12 + / 2)); [lra|]. apply (within_more (5 + / 100 + (6 + / 20) + 2 * slack + 1 + slack));
    [unfold slack; lra|].
    apply (within_rnd rnd); [exact Hr | unfold slack; lra|]. apply within_div; [lra | lra | exact Nz | exact Q | exact S].
Qed.

Theorem v_high_frequency : RoundingStatements.v_high_frequency.
Proof.
  intros rnd r z Hr Hz Hzz. destruct (high_within rnd Hr r z Hz) as [A [D Pos]].
  set (e := (/ r * / r - 1) * (/ r * / r - 1) + 2 * z * / r * (2 * z * / r)) in *.
  assert (Rn : forall k x y, 0 <= k <= 14 -> within k x y -> within (k + 1 + / 100) (rnd (x / r)) (y / r)).
  { intros k x y Hk W. apply (within_more (k + 0 + 2 * slack + 1 + slack)); [unfold slack; lra|]. apply (within_rnd rnd); [exact
    Hr | unfold slack; lra|].
    apply within_div; [lra | lra | lra | exact W | apply within_exact]. }
  assert (F : e = ((1 - r * r) ^ 2 + (2 * z * r) ^ 2) / r ^ 4) by (unfold e; field; lra).
  assert (Dn : (1 - r * r) ^ 2 + (2 * z * r) ^ 2 <> 0).
  { intros K. rewrite K in F. unfold Rdiv in F. rewrite Rmult_0_l in F. lra. }
  split.
  - replace (v_re r z) with ((/ r * / r - 1) / e / r / r) by (rewrite F; unfold v_re; field; split; [exact Dn | lra]).
    apply (within_off (2 + / 50 + (6 + / 10) + 2 * slack + 1 + slack + 1 + / 100 + 1 + / 100)); [unfold slack; lra|].
    unfold high_frequency_re. apply Rn; [unfold slack; lra|]. apply Rn; [unfold slack; lra|].
    apply (within_rnd rnd); [exact Hr | unfold slack; lra|]. apply within_div; [lra | lra | lra | exact A | exact D].
  - replace (v_im r z) with (- (2 * z / e / r / r / r)) by (rewrite F; unfold v_im; field; split; [exact Dn | lra]).
    unfold high_frequency_im. apply (within_off (0 + (6 + / 10) + 2 * slack + 1 + slack + 1 + / 100 + 1 + / 100 + 1 + / 100));
      [unfold slack; lra|]. apply within_opp.
    apply Rn; [unfold slack; lra|]. apply Rn; [unfold slack; lra|]. apply Rn; [unfold slack; lra|].
    apply (within_rnd rnd); [exact Hr | unfold slack; lra|]. apply within_div; [lra | lra | lra | apply within_exact | exact D].
Qed.
