(* Let a map T of m numbers never increase the distance of two points. It has a fixed point if the points x = r T(x), 0 < r < 1,
   are bounded. *)
Require Import Reals Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Sums.
Open Scope R_scope.

Lemma abs_from_squares a b : 0 <= b -> a * a <= b * b -> Rabs a <= b.
Proof. intros Hb H. apply Rabs_le. split; nra. Qed.
Lemma abs_below_from_squares a b : 0 < b -> a * a < b * b -> Rabs a < b.
Proof. intros Hb H. apply Rabs_lt_between. split; nra. Qed.

(* The square of the length of x *)
Definition size (m : nat) (x : nat -> R) := Sum m (fun i => x i * x i).
Lemma size_nonneg m x : 0 <= size m x.
Proof. apply Sum_nonneg. intros i _. apply Rle_0_sqr. Qed.
Lemma size_part m x i : (i < m)%nat -> x i * x i <= size m x.
Proof. intros Hi. apply (Sum_part m (fun i => x i * x i)); [intros; apply Rle_0_sqr | exact Hi]. Qed.
Lemma size_ext m x y : (forall i, (i < m)%nat -> x i = y i) -> size m x = size m y.
Proof. intros H. apply Sum_ext. intros i Hi. rewrite H by exact Hi. reflexivity. Qed.
Lemma size_scal m c x : size m (fun i => c * x i) = c * c * size m x.
Proof. unfold size. rewrite <- Sum_scal. apply Sum_ext. intros; ring. Qed.

Section Map.
Variable m : nat.

(* Convergence of each of the m numbers *)
Definition tends (x : nat -> nat -> R) (L : nat -> R) := forall i, (i < m)%nat -> is_lim_seq (fun n => x n i) (L i).
Lemma distance_vanishes x L : tends x L -> is_lim_seq (fun n => size m (fun i => x n i - L i)) 0.
Proof.
  unfold tends, size. induction m as [|k IH]; intros H; [apply is_lim_seq_const|]. simpl.
  replace 0 with (0 + (L k - L k) * (L k - L k)) by ring.
  apply is_lim_seq_plus'; [apply IH; intros; apply H; lia|].
  apply is_lim_seq_mult'; apply is_lim_seq_minus'; first [apply is_lim_seq_const | apply H; lia].
Qed.

Variable T : (nat -> R) -> nat -> R.
Hypothesis HT : forall x y, size m (fun i => T x i - T y i) <= size m (fun i => x i - y i).

Lemma image_tends x L : tends x L -> tends (fun n => T (x n)) (T L).
Proof.
  intros H i Hi. apply is_lim_seq_spec. intros e. pose proof (cond_pos e) as He.
  pose proof (distance_vanishes x L H) as D. apply is_lim_seq_spec in D. destruct (D (mkposreal (e * e) ltac:(nra))) as [n0 Q].
  exists n0. intros n Hn. specialize (Q n Hn). simpl in Q. rewrite Rminus_0_r in Q.
  rewrite Rabs_right in Q by apply Rle_ge, size_nonneg.
  apply abs_below_from_squares; [exact He|]. pose proof (HT (x n) L).
  pose proof (size_part m (fun i => T (x n) i - T L i) i Hi) as P. cbv beta in P. lra.
Qed.

(* r times the map is a contraction: its iterates converge to a point that is r times its image. *)
Section Contraction.
Variable r : R.
Hypothesis Hr : 0 < r < 1.
Fixpoint iterate (n : nat) : nat -> R := match n with O => fun _ => 0 | S k => fun i => r * T (iterate k) i end.
Let D := size m (fun i => iterate 1 i - iterate 0 i).
Lemma step_size n : size m (fun i => iterate (S n) i - iterate n i) <= (r ^ n * r ^ n) * D.
Proof.
  induction n; [unfold D; rewrite pow_O; lra|].
  rewrite (size_ext m _ (fun i => r * (T (iterate (S n)) i - T (iterate n) i))) by (intros; simpl; ring).
  rewrite size_scal. pose proof (HT (iterate (S n)) (iterate n)) as H.
  replace (r ^ S n * r ^ S n * D) with (r * r * (r ^ n * r ^ n * D)) by (simpl; ring).
  apply Rmult_le_compat_l; [nra | lra].
Qed.
Lemma step_part n i : (i < m)%nat -> Rabs (iterate (S n) i - iterate n i) <= r ^ n * (1 + D).
Proof.
  intros Hi. assert (D0 : 0 <= D) by apply size_nonneg. assert (Pn : 0 < r ^ n) by (apply pow_lt; lra).
  apply abs_from_squares; [apply Rmult_le_pos; lra|]. pose proof (step_size n) as H.
  pose proof (size_part m (fun i => iterate (S n) i - iterate n i) i Hi) as P. cbv beta in P.
  apply Rle_trans with (1 := P), Rle_trans with (1 := H).
  replace (r ^ n * (1 + D) * (r ^ n * (1 + D))) with (r ^ n * r ^ n * ((1 + D) * (1 + D))) by ring.
  apply Rmult_le_compat_l; [nra | nra].
Qed.
Definition multiple i : R := Lim_seq (fun n => iterate n i).
Lemma iterates_tend : tends iterate multiple.
Proof.
  intros i Hi. apply Lim_seq_correct'.
  assert (E : ex_series (fun n => iterate (S n) i - iterate n i)).
  { apply (ex_series_le (K := R_AbsRing) (V := R_CompleteNormedModule) _ (fun n => r ^ n * (1 + D))).
    - intros n. apply step_part, Hi.
    - apply (ex_series_scal_r (1 + D) (fun n => r ^ n)), ex_series_geom. rewrite Rabs_right; lra. }
  destruct E as [L HL]. exists L. apply is_lim_seq_incr_1.
  apply (is_lim_seq_ext (sum_n (fun n => iterate (S n) i - iterate n i))); [|exact HL].
  intros n. induction n; [rewrite sum_O; simpl; ring|]. rewrite sum_Sn, IHn. unfold plus; simpl; ring.
Qed.
Lemma multiple_is_one i : (i < m)%nat -> multiple i = r * T multiple i.
Proof.
  intros Hi. pose proof (iterates_tend i Hi) as A. apply is_lim_seq_incr_1 in A.
  pose proof (image_tends _ _ iterates_tend i Hi) as B.
  apply (is_lim_seq_scal_l _ r) in B. apply is_lim_seq_unique in A, B. simpl in A, B. rewrite A in B. injection B. auto.
Qed.
End Contraction.

(* Of two such points the one with the larger r is the longer one, and the difference of their sizes bounds their distance. *)
Lemma multiples_apart r r' x y : 0 < r < 1 -> 0 < r' < 1 -> r < r' ->
  (forall i, (i < m)%nat -> x i = r * T x i) -> (forall i, (i < m)%nat -> y i = r' * T y i) ->
  size m (fun i => x i - y i) <= size m y - size m x.
Proof.
  intros Hr Hr' Lt Hx Hy. set (e := (1 - r) / r). set (d := (1 - r') / r').
  assert (Hd : 0 < d) by (apply Rdiv_lt_0_compat; lra).
  assert (He : d < e).
  { assert (/ r' < / r) by (apply Rinv_lt_contravar; [apply Rmult_lt_0_compat|]; lra).
    replace e with (/ r - 1) by (unfold e; field; lra). replace d with (/ r' - 1) by (unfold d; field; lra). lra. }
  assert (Tx : forall i, (i < m)%nat -> T x i = (1 + e) * x i) by (intros i Hi; rewrite (Hx i Hi); unfold e; field; lra).
  assert (Ty : forall i, (i < m)%nat -> T y i = (1 + d) * y i) by (intros i Hi; rewrite (Hy i Hi); unfold d; field; lra).
  pose proof (HT x y) as H.
  rewrite (size_ext m _ (fun i => (1 + e) * x i - (1 + d) * y i)) in H by (intros; rewrite Tx, Ty; auto).
  set (xx := size m x). set (yy := size m y). set (xy := Sum m (fun i => x i * y i)).
  assert (Q : forall a b, size m (fun i => a * x i - b * y i) = a * a * xx - 2 * (a * b) * xy + b * b * yy).
  { intros a b. unfold size, xx, yy, xy, size. rewrite <- !Sum_scal, <- Sum_minus, <- Sum_plus. apply Sum_ext. intros; ring. }
  rewrite Q in H. pose proof (Q 1 1) as Q1. pose proof (Q e d) as Q2.
  pose proof (size_nonneg m (fun i => e * x i - d * y i)) as P2.
  pose proof (size_nonneg m (fun i => 1 * x i - 1 * y i)) as P1.
  rewrite (size_ext m (fun i => 1 * x i - 1 * y i) (fun i => x i - y i)) in Q1, P1 by (intros; ring).
  rewrite Q2 in P2. rewrite Q1 in P1. rewrite Q1 in H. rewrite Q1.
  assert (M : (e + d) * (1 * 1 * xx - 2 * (1 * 1) * xy + 1 * 1 * yy) <= (e - d) * (yy - xx)) by lra.
  assert (G : 0 <= yy - xx \/ yy - xx < 0) by lra. destruct G as [G|G]; [|exfalso; nra].
  apply (Rmult_le_reg_l (e + d)); [lra|]. nra.
Qed.

Hypothesis bounded : exists B, forall r x, 0 < r < 1 -> (forall i, (i < m)%nat -> x i = r * T x i) -> size m x <= B.

(* The factors n + 1 by n + 2 tend to 1. *)
Definition factor (n : nat) := 1 - / (INR n + 2).
Lemma factor_range n : 0 < factor n < 1.
Proof.
  pose proof (pos_INR n). unfold factor. assert (0 < / (INR n + 2)) by (apply Rinv_0_lt_compat; lra).
  assert (/ (INR n + 2) <= / 2) by (apply Rinv_le_contravar; lra). lra.
Qed.
Lemma factor_grows n k : (n < k)%nat -> factor n < factor k.
Proof.
  intros H. apply lt_INR in H. pose proof (pos_INR n). unfold factor.
  assert (/ (INR k + 2) < / (INR n + 2)) by (apply Rinv_lt_contravar; [apply Rmult_lt_0_compat|]; lra). lra.
Qed.
Lemma factor_tends : is_lim_seq factor 1.
Proof.
  assert (E : is_lim_seq (fun n => / (INR n + 2)) 0).
  { replace (Finite 0) with (Rbar_inv p_infty) by reflexivity. apply is_lim_seq_inv; [|discriminate].
    eapply is_lim_seq_plus; [apply is_lim_seq_INR | apply is_lim_seq_const | reflexivity]. }
  replace 1 with (1 - 0) by ring. apply is_lim_seq_minus'; [apply is_lim_seq_const | exact E].
Qed.

Theorem fixed_point : exists x, forall i, (i < m)%nat -> T x i = x i.
Proof.
  set (x := fun n => multiple (factor n)).
  assert (Hx : forall n i, (i < m)%nat -> x n i = factor n * T (x n) i).
  { intros n i Hi. apply multiple_is_one; [apply factor_range | exact Hi]. }
  assert (Apart : forall n k, (n <= k)%nat -> size m (fun i => x n i - x k i) <= size m (x k) - size m (x n)).
  { intros n k H. destruct (Nat.eq_dec n k) as [->|N].
    - apply Req_le. rewrite Rminus_diag_eq by reflexivity. apply Sum_zero. intros; ring.
    - apply (multiples_apart (factor n) (factor k)); auto using factor_range. apply factor_grows. lia. }
  destruct bounded as [B HB].
  assert (Lim : ex_finite_lim_seq (fun n => size m (x n))).
  { apply (ex_finite_lim_seq_incr _ B).
    - intros n. pose proof (Apart n (S n) ltac:(lia)). pose proof (size_nonneg m (fun i => x n i - x (S n) i)). lra.
    - intros n. apply (HB (factor n)); [apply factor_range | apply Hx]. }
  apply ex_lim_seq_cauchy_corr in Lim.
  set (L := fun i => real (Lim_seq (fun n => x n i))).
  assert (Tends : tends x L).
  { intros i Hi. apply Lim_seq_correct', ex_lim_seq_cauchy_corr. intros e. pose proof (cond_pos e) as He.
    destruct (Lim (mkposreal (e * e) ltac:(nra))) as [n0 Q]. exists n0.
    assert (W : forall n k, (n0 <= n)%nat -> (n <= k)%nat -> Rabs (x n i - x k i) < e).
    { intros n k Hn Hk. specialize (Q k n ltac:(lia) ltac:(lia)). simpl in Q. apply Rabs_lt_between in Q.
      apply abs_below_from_squares; [exact He|]. pose proof (Apart n k Hk).
      pose proof (size_part m (fun i => x n i - x k i) i Hi) as P. cbv beta in P. lra. }
    intros n k Hn Hk. destruct (Nat.le_ge_cases n k); [apply W; lia | rewrite Rabs_minus_sym; apply W; lia]. }
  exists L. intros i Hi.
  pose proof (image_tends x L Tends i Hi) as A. pose proof (is_lim_seq_mult' _ _ _ _ factor_tends A) as C.
  apply (is_lim_seq_ext _ (fun n => x n i)) in C; [|intros n; rewrite (Hx n i Hi) at 1; reflexivity].
  pose proof (Tends i Hi) as D. apply is_lim_seq_unique in C, D. rewrite C in D. injection D. lra.
Qed.
End Map.
