(* Proofs of what is said of rounding. *)
Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core Relative.
From Kernel Require Import Statements Modes RoundingStatements.
Open Scope R_scope.

Lemma unit_small : 0 < unit_roundoff <= / 100000000.
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
Lemma within_mult k l x y x' y' : 0 <= k <= 64 -> 0 <= l <= 64 -> within k x y -> within l x' y' -> within (k + l + slack) (x *
  x') (y * y').
Proof.
  intros Hk Hl [e [He ->]] [f [Hf ->]]. exists (e + f + e * f). split; [|ring]. pose proof unit_small as U.
  eapply Rle_trans; [apply Rabs_triang|]. pose proof (Rabs_triang e f). rewrite Rabs_mult. pose proof (Rabs_pos e). pose proof
    (Rabs_pos f).
  assert (Rabs e * Rabs f <= 64 * unit_roundoff * (64 * unit_roundoff)) by (apply Rmult_le_compat; nra).
  assert (64 * unit_roundoff * (64 * unit_roundoff) <= slack * unit_roundoff) by (unfold slack; nra). lra.
Qed.
Lemma within_inv l x y : 0 <= l <= 64 -> y <> 0 -> within l x y -> within (l + slack) (/ x) (/ y).
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
  { apply Rle_trans with (65 * (64 * / 100000000)); [apply Rmult_le_compat; unfold slack; nra | unfold slack; lra]. }
  assert ((l + slack) * (l * unit_roundoff) * unit_roundoff <= slack * unit_roundoff) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Lemma within_div k l x y x' y' : 0 <= k <= 64 -> 0 <= l <= 60 -> y' <> 0 -> within k x y -> within l x' y' -> within (k + l + 2
  * slack) (x / x') (y / y').
Proof.
  intros Hk Hl Hy A B. unfold Rdiv. apply (within_more (k + (l + slack) + slack)); [lra|]. apply within_mult; [exact Hk | unfold
    slack; lra | exact A|].
  apply within_inv; [lra | exact Hy | exact B].
Qed.
Lemma within_rnd rnd k x y : rounds_correctly rnd -> 0 <= k <= 60 -> within k x y -> within (k + 1 + slack) (rnd x) y.
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

(* ---- (28), (29) ---- *)
Lemma within_of_off k x y : 0 <= k -> off_by k x y -> within (2 * k) x y.
Proof.
  intros Hk H. unfold off_by in H. pose proof unit_small as U. destruct (Req_dec y 0) as [->|Y].
  - rewrite Rabs_R0, Rmult_0_r, Rminus_0_r in H. pose proof (Rabs_pos x). exists 0. rewrite Rabs_R0. split; [nra|].
    assert (X : Rabs x = 0) by lra. rewrite Rmult_0_l. destruct (Req_dec x 0) as [E|E]; [exact E | apply Rabs_no_R0 in E;
      contradiction].
  - exists ((x - y) / y). split; [|field; exact Y]. unfold Rdiv. rewrite Rabs_mult, Rabs_Rinv by exact Y.
    pose proof (Rabs_pos_lt y Y). apply (Rmult_le_reg_r (Rabs y)); [lra|]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. lra.
Qed.
Lemma within_add k x y x' y' : 0 <= k -> 0 <= y * y' -> within k x y -> within k x' y' -> within k (x + x') (y + y').
Proof.
  intros Hk Hs A B. destruct (Rle_lt_dec (Rabs y') (Rabs y)) as [L|L].
  - apply (within_more ((k + k) / 2)); [lra|]. apply within_plus; [lra | exact Hs | exact L | exact A | exact B].
  - rewrite (Rplus_comm x), (Rplus_comm y). apply (within_more ((k + k) / 2)); [lra|].
    apply within_plus; [lra | lra | lra | exact B | exact A].
Qed.
Lemma within_abs k x y : within k x y -> Rabs (x - y) <= k * unit_roundoff * Rabs y.
Proof.
  intros [e [He ->]]. replace (y * (1 + e) - y) with (y * e) by ring. rewrite Rabs_mult, Rmult_comm.
  apply Rmult_le_compat_r; [apply Rabs_pos | exact He].
Qed.

Section Damping.
Variable rnd : R -> R.
Hypothesis Hr : rounds_correctly rnd.
Variable f : R.
Hypothesis Hf : 0 <= f <= 4.
Lemma times k l m x y x' y' : 0 <= k <= 58 -> 0 <= l <= 58 -> k + l <= 58 -> k + l + 1 + 2 * slack <= m -> within k x y ->
  within l x' y' ->
  within m (rnd (x * x')) (y * y').
Proof.
  intros Hk Hl Hs Hm A B. apply (within_more (k + l + slack + 1 + slack)); [lra|]. apply (within_rnd rnd); [exact Hr | unfold
    slack; lra|].
  apply within_mult; [lra | lra | exact A | exact B].
Qed.
Lemma over k l m x y x' y' : 0 <= k <= 58 -> 0 <= l <= 58 -> k + l <= 58 -> k + l + 1 + 3 * slack <= m -> y' <> 0 -> within k x
  y ->
  within l x' y' -> within m (rnd (x / x')) (y / y').
Proof.
  intros Hk Hl Hs Hm Hy A B. apply (within_more (k + l + 2 * slack + 1 + slack)); [lra|]. apply (within_rnd rnd); [exact Hr |
    unfold slack; lra|].
  apply within_div; [lra | lra | exact Hy | exact A | exact B].
Qed.
Lemma add k m x y x' y' : 0 <= k <= 58 -> k + 1 + slack <= m -> 0 <= y * y' -> within k x y -> within k x' y' ->
  within m (rnd (x + x')) (y + y').
Proof.
  intros Hk Hm Hs A B. apply (within_more (k + 1 + slack)); [exact Hm|]. apply (within_rnd rnd); [exact Hr | lra|].
  apply within_add; [lra | exact Hs | exact A | exact B].
Qed.
Ltac small := unfold slack; lra.

Variables root_E E1 s c w_ rE e1 S C W : R.
Hypothesis A1 : within f root_E rE.
Hypothesis A2 : within f E1 e1.
Hypothesis A3 : within f s S.
Hypothesis A4 : within f c C.
Hypothesis A5 : within f w_ W.
Hypothesis HW : W <> 0.
Let E := rE * rE.
Let D := e1 * e1 + 4 * E * C * C.
Hypothesis HD : D <> 0.
Lemma E_within : within (2 * f + 1 + / 100) (half_angle_E rnd root_E) E.
Proof. unfold half_angle_E. apply (times f f); try small; exact A1. Qed.
Lemma four_within : within (2 * f + 1 + / 50) (4 * half_angle_E rnd root_E) (4 * E).
Proof.
  apply (within_more (0 + (2 * f + 1 + / 100) + slack)); [small|]. apply within_mult; [lra | small | apply within_exact | apply
    E_within].
Qed.
Lemma D_within : within (4 * f + 4 + / 10) (half_angle_denominator rnd root_E E1 c) D.
Proof.
  unfold half_angle_denominator. apply (add (4 * f + 3 + / 20)); [small | small | | |].
  - unfold E. replace (e1 * e1 * (4 * (rE * rE) * C * C)) with ((2 * e1 * rE * C) * (2 * e1 * rE * C)) by ring. apply Rle_0_sqr.
  - apply (within_more (2 * f + 1 + / 100)); [lra|]. apply (times f f); try small; exact A2.
  - apply (times (3 * f + 2 + / 30) f); try small; [|exact A4]. apply (times (2 * f + 1 + / 50) f); try small; [apply
    four_within | exact A4].
Qed.
Lemma u_within r : 0 < r -> within (9 * f + 11 + 1 / 2) (half_angle_u rnd root_E E1 s c w_ r) (rE * S * C / D * (4 / W) / r * rE).
Proof.
  intros R. unfold half_angle_u. apply (times (8 * f + 10 + 2 / 5) f); try small; [|exact A1].
  apply (over (8 * f + 9 + 3 / 10) 0); try small; [|apply within_exact].
  apply (times (7 * f + 7 + 1 / 5) (f + 1 + / 100)); try small.
  - apply (over (3 * f + 2 + / 50) (4 * f + 4 + / 10)); try small; [| apply D_within].
    apply (times (2 * f + 1 + / 100) f); try small; [|exact A4]. apply (times f f); try small; [exact A1 | exact A3].
  - apply (over 0 f); try small; [apply within_exact | exact A5].
Qed.
(* the two terms of g *)
Lemma g_close z : Rabs (half_angle_g rnd root_E E1 s c w_ z - - ((e1 * (1 + E) + 4 * E * (z / W) * S * C) / D))
  <= (9 * f + 11 + 1 / 2) * unit_roundoff * ((Rabs (e1 * (1 + E)) + Rabs (4 * E * (z / W) * S * C)) / Rabs D).
Proof.
  pose proof unit_small as U. set (a := e1 * (1 + E)). set (b := 4 * E * (z / W) * S * C).
  assert (Wa : within (3 * f + 3 + / 10) (rnd (E1 * rnd (1 + half_angle_E rnd root_E))) a).
  { apply (times f (2 * f + 2 + / 20)); try small; [exact A2|]. apply (add (2 * f + 1 + / 100)); try small.
    - unfold E. rewrite Rmult_1_l. apply Rle_0_sqr.
    - apply (within_more 0); [small | apply within_exact].
    - apply E_within. }
  assert (Wb : within (5 * f + 5 + / 10) (rnd (rnd (rnd (4 * half_angle_E rnd root_E * rnd (z / w_)) * s) * c)) b).
  { apply (times (4 * f + 4 + / 15) f); try small; [|exact A4]. apply (times (3 * f + 3 + / 20) f); try small; [|exact A3].
    apply (times (2 * f + 1 + / 50) (f + 1 + / 100)); try small; [apply four_within|].
    apply (over 0 f); try small; [apply within_exact | exact A5]. }
  unfold half_angle_g. set (ca := rnd (E1 * _)) in *. set (cb := rnd (rnd (rnd (4 * _ * _) * s) * c)) in *.
  set (T := Rabs a + Rabs b). assert (T0 : 0 <= T) by (unfold T; pose proof (Rabs_pos a); pose proof (Rabs_pos b); lra).
  set (k := 5 * f + 5 + / 10) in *. assert (K : 5 <= k <= 26) by (unfold k; lra).
  assert (Sm : Rabs (ca + cb - (a + b)) <= k * unit_roundoff * T).
  { pose proof (within_abs _ _ _ (within_more (3 * f + 3 + / 10) k _ _ ltac:(unfold k; lra) Wa)). pose proof (within_abs _ _ _
    Wb).
    replace (ca + cb - (a + b)) with (ca - a + (cb - b)) by ring. pose proof (Rabs_triang (ca - a) (cb - b)). unfold T. lra. }
  destruct (Hr (ca + cb)) as [e [He Es]].
  assert (AB : Rabs (a + b) <= T) by apply Rabs_triang.
  assert (S2 : Rabs (rnd (ca + cb) - (a + b)) <= (k + 1 + / 10) * unit_roundoff * T).
  { rewrite Es. replace ((ca + cb) * (1 + e) - (a + b)) with ((ca + cb - (a + b)) * (1 + e) + (a + b) * e) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult.
    assert (Rabs (1 + e) <= 1 + unit_roundoff) by (eapply Rle_trans; [apply Rabs_triang|]; rewrite Rabs_R1; lra).
    assert (Rabs (ca + cb - (a + b)) * Rabs (1 + e) <= k * unit_roundoff * T * (1 + unit_roundoff))
      by (apply Rmult_le_compat; try apply Rabs_pos; assumption).
    assert (Rabs (a + b) * Rabs e <= T * unit_roundoff) by (apply Rmult_le_compat; try apply Rabs_pos; assumption).
    assert (k * unit_roundoff <= / 10) by (apply Rle_trans with (26 * (/ 100000000)); [apply Rmult_le_compat; lra | lra]).
    assert (k * unit_roundoff * unit_roundoff <= / 10 * unit_roundoff) by (apply Rmult_le_compat_r; lra).
    assert (k * unit_roundoff * unit_roundoff * T <= / 10 * unit_roundoff * T) by (apply Rmult_le_compat_r; assumption). lra. }
  (* the quotient of the exact sum is within, and the sum's own error is divided *)
  pose proof D_within as WD. set (cd := half_angle_denominator rnd root_E E1 c) in *.
  destruct (within_inv (4 * f + 4 + / 10) _ _ ltac:(lra) HD WD) as [q [Hq Eq]]. destruct (Hr (rnd (ca + cb) / cd)) as [e' [He'
    Es']].
  rewrite Es'. unfold Rdiv at 1. rewrite Eq. set (n := rnd (ca + cb)) in *.
  replace (- (n * (/ D * (1 + q)) * (1 + e')) - - ((a + b) / D))
    with (- / D * ((n - (a + b)) * ((1 + q) * (1 + e')) + (a + b) * (q + e' + q * e'))) by (field; exact HD).
  rewrite Rabs_mult, Rabs_Ropp, Rabs_Rinv by exact HD.
  replace ((9 * f + 11 + 1 / 2) * unit_roundoff * (T / Rabs D)) with (/ Rabs D * ((9 * f + 11 + 1 / 2) * unit_roundoff * T))
    by (unfold Rdiv; ring).
  apply Rmult_le_compat_l; [apply Rlt_le, Rinv_0_lt_compat, Rabs_pos_lt, HD|].
  eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult.
  set (l := 4 * f + 4 + / 10 + slack) in *. assert (L : 4 <= l <= 21) by (unfold l, slack; lra).
  assert (B1 : Rabs (q + e' + q * e') <= (l + 1 + / 1000) * unit_roundoff).
  { eapply Rle_trans; [apply Rabs_triang|]. pose proof (Rabs_triang q e'). rewrite Rabs_mult.
    assert (Rabs q * Rabs e' <= l * unit_roundoff * unit_roundoff) by (apply Rmult_le_compat; try apply Rabs_pos; assumption).
    assert (l * unit_roundoff <= / 1000) by (apply Rle_trans with (21 * (/ 100000000)); [apply Rmult_le_compat; lra | lra]).
    assert (l * unit_roundoff * unit_roundoff <= / 1000 * unit_roundoff) by (apply Rmult_le_compat_r; lra). lra. }
  assert (B2 : Rabs (1 + q) * Rabs (1 + e') <= 1 + / 1000).
  { rewrite <- Rabs_mult. replace ((1 + q) * (1 + e')) with (1 + (q + e' + q * e')) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_R1. assert ((l + 1 + / 1000) * unit_roundoff <= / 1000) by
      (apply Rle_trans with (23 * (/ 100000000)); [apply Rmult_le_compat; lra | lra]). lra. }
  assert (Rabs (n - (a + b)) * (Rabs (1 + q) * Rabs (1 + e')) <= (k + 1 + / 10) * unit_roundoff * T * (1 + / 1000)).
  { apply Rmult_le_compat; [apply Rabs_pos | apply Rmult_le_pos; apply Rabs_pos | exact S2 | exact B2]. }
  assert (Rabs (a + b) * Rabs (q + e' + q * e') <= T * ((l + 1 + / 1000) * unit_roundoff)) by (apply Rmult_le_compat; try apply
    Rabs_pos; assumption).
  assert (X : (k + 1 + / 10) * (1 + / 1000) + (l + 1 + / 1000) <= 9 * f + 11 + 1 / 2) by (unfold k, l, slack; lra).
  assert (((k + 1 + / 10) * (1 + / 1000) + (l + 1 + / 1000)) * (unit_roundoff * T) <= (9 * f + 11 + 1 / 2) * (unit_roundoff * T))
    by (apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | exact X]). lra.
Qed.
Lemma small_u_within r sh SH : 0 < r -> SH * SH + C * C <> 0 -> within f sh SH ->
  within (5 * f + 6 + 1 / 2) (small_argument_u rnd s c w_ r sh) (S * C / (SH * SH + C * C) / W / r).
Proof.
  intros R Q A6. unfold small_argument_u. apply (over (5 * f + 5 + 2 / 5) 0); try small; [|apply within_exact].
  apply (over (4 * f + 4 + 1 / 5) f); try small; [| exact A5].
  apply (over (2 * f + 1 + / 100) (2 * f + 2 + / 20)); try small.
  - apply (times f f); try small; [exact A3 | exact A4].
  - apply (add (2 * f + 1 + / 100)); try small.
    + replace (SH * SH * (C * C)) with (SH * C * (SH * C)) by ring. apply Rle_0_sqr.
    + apply (times f f); try small; exact A6.
    + apply (times f f); try small; exact A4.
Qed.
End Damping.

Lemma half_angle_forms r z : let E := exp (- decay r z) in let S := sin (theta r z / 2) in let C := cos (theta r z / 2) in
  exp (- decay r z / 2) * exp (- decay r z / 2) = E /\ sin (theta r z) = 2 * S * C /\
  2 * E * (cosh (decay r z) + cos (theta r z)) = (E - 1) * (E - 1) + 4 * E * C * C /\
  2 * E * sinh (decay r z) = (1 - E) * (1 + E) /\ 0 < E /\
  cosh (decay r z) + cos (theta r z) = 2 * (sinh (decay r z / 2) * sinh (decay r z / 2) + C * C).
Proof.
  intros E S C. assert (EE : exp (- decay r z / 2) * exp (- decay r z / 2) = E) by (unfold E; rewrite <- exp_plus; f_equal;
    field).
  assert (Inv : E * exp (decay r z) = 1) by (unfold E; rewrite <- exp_plus, Rplus_opp_l; apply exp_0).
  assert (Ct : cos (theta r z) = 2 * C * C - 1) by (unfold C; rewrite <- cos_2a_cos; f_equal; field).
  split; [exact EE|]. split; [unfold S, C; rewrite <- sin_2a; f_equal; field|]. split.
  - rewrite Ct. unfold cosh. fold E. replace (2 * E * ((exp (decay r z) + E) / 2 + (2 * C * C - 1)))
      with (E * exp (decay r z) + E * E + 2 * E * (2 * C * C - 1)) by field. rewrite Inv. ring.
  - split; [unfold sinh; fold E; replace (2 * E * ((exp (decay r z) - E) / 2)) with (E * exp (decay r z) - E * E) by field;
    rewrite Inv; ring|].
    split; [apply exp_pos|]. rewrite Ct. unfold cosh, sinh. fold E.
    assert (P : exp (decay r z / 2) * exp (decay r z / 2) = exp (decay r z)) by (rewrite <- exp_plus; f_equal; field).
    assert (M : exp (decay r z / 2) * exp (- (decay r z / 2)) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0).
    replace (- (decay r z / 2)) with (- decay r z / 2) in * by field. set (x := exp (decay r z / 2)) in *. set (y := exp (-
      decay r z / 2)) in *.
    rewrite <- P, <- EE. replace (2 * ((x - y) / 2 * ((x - y) / 2) + C * C)) with ((x * x + y * y - 2 * (x * y)) / 2 + 2 * C *
      C) by field.
    rewrite M. field.
Qed.

Theorem damping_functions_by_half_angle : RoundingStatements.damping_functions_by_half_angle.
Proof.
  intros rnd eta r z root_E E1 s c w_ Hr He A E H1 H2 H3 H4 H5. pose proof A as [Rp [Hz [HD _]]]. pose proof (w_pos z Hz) as Wp.
  apply within_of_off in H1, H2, H3, H4, H5; try lra.
  destruct (half_angle_forms r z) as [EE [Sn [Dn [Sh [Ep _]]]]]. fold E in EE, Dn, Sh, Ep.
  set (S := sin (theta r z / 2)) in *. set (C := cos (theta r z / 2)) in *. set (rE := exp (- decay r z / 2)) in *.
  assert (D0 : (E - 1) * (E - 1) + 4 * (rE * rE) * C * C <> 0).
  { rewrite EE, <- Dn. apply Rmult_integral_contrapositive. split; lra. }
  assert (Hf : 0 <= 2 * eta <= 4) by lra. split.
  - apply (within_off (9 * (2 * eta) + 11 + 1 / 2)); [lra|].
    replace (u r z) with (rE * S * C / ((E - 1) * (E - 1) + 4 * (rE * rE) * C * C) * (4 / w z) / r * rE);
      [apply (u_within rnd Hr (2 * eta) Hf); try assumption; lra|].
    rewrite EE, <- Dn. unfold u. rewrite Sn. replace (rE * S * C / (2 * E * (cosh (decay r z) + cos (theta r z))) * (4 / w z) /
      r * rE)
      with ((rE * rE) * S * C / (2 * E * (cosh (decay r z) + cos (theta r z))) * (4 / w z) / r) by (unfold Rdiv; ring).
    rewrite EE. field. repeat split; lra.
  - pose proof (g_close rnd Hr (2 * eta) Hf root_E E1 s c w_ rE (E - 1) S C (w z) H1 H2 H3 H4 H5 ltac:(lra) D0 z) as G.
    rewrite EE in G. rewrite EE in D0. pose proof unit_small as U.
    replace (- (((E - 1) * (1 + E) + 4 * E * (z / w z) * S * C) / ((E - 1) * (E - 1) + 4 * E * C * C))) with (g r z) in G.
    + eapply Rle_trans; [exact G|].
      assert (E <= 1). { unfold E. rewrite <- exp_0. destruct (Req_dec (decay r z) 0) as [Z|Z]; [rewrite Z, Ropp_0; lra|].
        left. apply exp_increasing. assert (0 <= decay r z); [|lra]. unfold decay. pose proof PI_RGT_0.
        apply Rmult_le_pos; [nra | apply Rlt_le, Rinv_0_lt_compat, Rp]. }
      assert (Zw : 0 <= z / w z) by (apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat, Wp]).
      replace (Rabs ((E - 1) * (1 + E))) with ((1 - E) * (1 + E)) by (rewrite <- (Rabs_Ropp ((E - 1) * (1 + E))), Rabs_right;
        nra).
      replace (Rabs (4 * E * (z / w z) * S * C)) with (4 * E * (z / w z) * Rabs (S * C)).
      2: { rewrite (Rmult_assoc _ S), (Rabs_mult (4 * E * (z / w z))), (Rabs_right (4 * E * (z / w z))); [reflexivity|].
        apply Rle_ge, Rmult_le_pos; lra. }
      replace (Rabs ((E - 1) * (E - 1) + 4 * E * C * C)) with ((1 - E) ^ 2 + 4 * E * C ^ 2).
      2: { rewrite Rabs_right; [ring|]. apply Rle_ge. pose proof (Rle_0_sqr (E - 1)) as Q1. pose proof (Rle_0_sqr C) as Q2.
        unfold Rsqr in *.
        assert (0 <= 4 * E * (C * C)) by (apply Rmult_le_pos; lra). lra. }
      apply Rmult_le_compat_r; [|nra]. apply Rmult_le_pos.
      * apply Rplus_le_le_0_compat; [nra|]. apply Rmult_le_pos; [apply Rmult_le_pos; lra | apply Rabs_pos].
      * apply Rlt_le, Rinv_0_lt_compat. replace ((1 - E) ^ 2 + 4 * E * C ^ 2) with ((E - 1) * (E - 1) + 4 * E * C * C) by ring.
        pose proof (Rle_0_sqr (E - 1)) as Q1. pose proof (Rle_0_sqr C) as Q2. unfold Rsqr in *.
        assert (0 <= 4 * E * (C * C)) by (apply Rmult_le_pos; lra). lra.
    + rewrite <- Dn. unfold g. rewrite Sn. replace ((E - 1) * (1 + E)) with (- (2 * E * sinh (decay r z))) by (rewrite Sh;
      ring). field. repeat split; lra.
Qed.
Theorem u_by_small_arguments : RoundingStatements.u_by_small_arguments.
Proof.
  intros rnd eta r z sh s c w_ Hr He A H1 H3 H4 H5. pose proof A as [Rp [Hz [HD _]]]. pose proof (w_pos z Hz) as Wp.
  apply within_of_off in H1, H3, H4, H5; try lra. destruct (half_angle_forms r z) as [_ [Sn [_ [_ [_ Dn]]]]].
  set (S := sin (theta r z / 2)) in *. set (C := cos (theta r z / 2)) in *. set (SH := sinh (decay r z / 2)) in *.
  apply (within_off (5 * (2 * eta) + 6 + 1 / 2)); [lra|].
  replace (u r z) with (S * C / (SH * SH + C * C) / w z / r).
  - apply (small_u_within rnd Hr (2 * eta)); try assumption; try lra.
  - unfold u. rewrite Sn, Dn. field. repeat split; try lra.
Qed.
