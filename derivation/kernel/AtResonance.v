(* What (83) and (85) leave out at a given damping: the triangle inequality in the sums over the modes. *)
Require Import Reals Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes SteadyMode Sums Masses Contact Misprints Limits.
Open Scope R_scope.

Section Others.
Variable s : scene.
Variable m : nat.
Local Notation N := (masses s).
Local Notation psi := (shape s).
Local Notation R_ := (ratio s).
Local Notation zeta := (damping_ratio s).
Local Notation j := (contact s).
Local Notation l := (loaded s).
Local Notation beta := (friction s).
Hypothesis Hs : is_scene s.

Lemma sum_without f : (m < N)%nat -> Sum N f = f m + Sum N (without_m m f).
Proof.
  intros Hm. rewrite <- (Sum_delta N m f Hm), <- Sum_plus. apply Sum_ext. intros i _. unfold without_m.
  destruct (Nat.eqb_spec i m) as [->|E]; [rewrite delta_same; ring | rewrite delta_other by exact E; ring].
Qed.
Lemma norm_of_sum n f h : Cmod (Sum n f, Sum n h) <= Sum n (fun i => Cmod (f i, h i)).
Proof.
  induction n as [|n IH]; simpl.
  - replace (0, 0) with (RtoC 0) by reflexivity. rewrite Cmod_0. lra.
  - eapply Rle_trans; [apply (Cmod_triangle (Sum n f, Sum n h) (f n, h n)) | ]. lra.
Qed.
Lemma scaled_norm c a b : Cmod (c * a, c * b) = Rabs c * Cmod (a, b).
Proof. rewrite <- Cmod_R, <- Cmod_mult. f_equal. unfold Cmult, RtoC; simpl. f_equal; ring. Qed.

Lemma V_at_resonance : (m < N)%nat -> R_ m = 1 -> 0 < zeta m ->
  Rabs (V_abs s j - Rabs (psi j m * psi l m) / (2 * zeta m)) <= V_of_others s m.
Proof.
  intros Hm HR Hz. set (c := fun i => psi j i * psi l i * R_ i ^ 2).
  set (A := (c m * v_re (R_ m) (zeta m), c m * v_im (R_ m) (zeta m)) : Coquelicot.Complex.C).
  set (B := (Sum N (without_m m (fun i => c i * v_re (R_ i) (zeta i))), Sum N (without_m m (fun i => c i * v_im (R_ i) (zeta
    i)))) : Coquelicot.Complex.C).
  assert (E : V_abs s j = Cmod (Cplus A B)).
  { assert (E1 : V_re s j = c m * v_re (R_ m) (zeta m) + Sum N (without_m m (fun i => c i * v_re (R_ i) (zeta i))))
      by (apply (sum_without (fun i => c i * v_re (R_ i) (zeta i)) Hm)).
    assert (E2 : V_im s j = c m * v_im (R_ m) (zeta m) + Sum N (without_m m (fun i => c i * v_im (R_ i) (zeta i))))
      by (apply (sum_without (fun i => c i * v_im (R_ i) (zeta i)) Hm)).
    unfold V_abs. rewrite E1, E2. reflexivity. }
  assert (EA : Cmod A = Rabs (psi j m * psi l m) / (2 * zeta m)).
  { unfold A. rewrite scaled_norm. unfold c. rewrite HR. unfold Cmod; simpl fst; simpl snd. unfold v_re, v_im.
    replace ((1 - 1 * 1) / ((1 - 1 * 1) ^ 2 + (2 * zeta m * 1) ^ 2)) with 0 by (field; lra).
    replace (- (2 * zeta m * 1) / ((1 - 1 * 1) ^ 2 + (2 * zeta m * 1) ^ 2)) with (- / (2 * zeta m)) by (field; lra).
    replace (0 ^ 2 + (- / (2 * zeta m)) ^ 2) with (/ (2 * zeta m) * / (2 * zeta m)) by ring.
    rewrite sqrt_square by (apply Rlt_le, Rinv_0_lt_compat; lra). rewrite pow1, Rmult_1_r. reflexivity. }
  assert (EB : Cmod B <= V_of_others s m).
  { unfold B. eapply Rle_trans; [apply norm_of_sum|]. apply Sum_le. intros i Hi. unfold without_m. destruct (Nat.eqb i m).
    - replace (0, 0) with (RtoC 0) by reflexivity. rewrite Cmod_0. lra.
    - rewrite scaled_norm. unfold c. rewrite Rabs_mult, (Rabs_right (R_ i ^ 2)) by (apply Rle_ge, pow2_ge_0). apply Rle_refl. }
  rewrite E, <- EA. apply Rabs_le. pose proof (Cmod_triangle A B). pose proof (Cmod_triangle (Cplus A B) (Copp B)) as T.
  replace (Cplus (Cplus A B) (Copp B)) with A in T by (unfold Cplus, Copp; destruct A, B; simpl; f_equal; ring).
  rewrite Cmod_opp in T. lra.
Qed.
Lemma rest_of_sum f h : (m < N)%nat -> (forall i, (i < N)%nat -> Rabs (f i) <= h i) -> Rabs (Sum N f - f m) <= Sum N
  (without_m m h).
Proof.
  intros Hm H. rewrite (sum_without f Hm). replace (f m + Sum N (without_m m f) - f m) with (Sum N (without_m m f)) by ring.
  apply Rabs_le. assert (P : forall i, (i < N)%nat -> - without_m m h i <= without_m m f i <= without_m m h i).
  { intros i Hi. unfold without_m. destruct (Nat.eqb i m); [lra|]. apply Rabs_le_between, H, Hi. }
  split; [rewrite <- Sum_opp|]; apply Sum_le; intros i Hi; apply (P i Hi).
Qed.
Lemma root_near_V : responds s -> V_abs s j - (beta * U s j) ^ 2 / V_abs s j <= root s <= V_abs s j.
Proof.
  intros H. pose proof (root_sq s H) as RS. pose proof (root_pos s) as RP. destruct H as [HV HU].
  set (V := V_abs s j) in *. set (b := beta * U s j) in *. set (r := root s) in *. split; [|nra].
  apply (Rmult_le_reg_r V); [exact HV|]. replace ((V - b ^ 2 / V) * V) with (V ^ 2 - b ^ 2) by (field; lra). rewrite <- RS.
  assert (r <= V) by nra. nra.
Qed.

Lemma error_83 : responds s -> 0 <= beta -> (m < N)%nat -> R_ m = 1 -> 0 < zeta m -> Rabs (X_j s - X_83 s m) <= (V_of_others
  s m + beta * (G_of_others s m + psi j m ^ 2 * error_79 s m) + (beta * U s j) ^ 2 / V_abs s j).
Proof.
  intros H Hb Hm HR Hz. pose proof (V_at_resonance Hm HR Hz) as EV. pose proof (root_near_V H) as ER.
  assert (EG : Rabs (G s j - psi j m ^ 2 * g 1 (zeta m)) <= G_of_others s m).
  { unfold G. pose proof (rest_of_sum (fun i => psi j i * psi j i * R_ i ^ 2 * g (R_ i) (zeta i))
      (fun i => psi j i ^ 2 * R_ i ^ 2 * Rabs (g (R_ i) (zeta i))) Hm) as E. cbv beta in E. rewrite HR in E.
    replace (psi j m * psi j m * 1 ^ 2 * g 1 (zeta m)) with (psi j m ^ 2 * g 1 (zeta m)) in E by ring. apply E.
    intros i _. rewrite Rabs_mult, Rabs_right by (apply Rle_ge; pose proof (pow2_ge_0 (psi j i)); pose proof (pow2_ge_0 (R_
      i)); nra).
    right. ring. }
  set (d := g 1 (zeta m) - second_function_at_resonance (zeta m)).
  assert (Ed : Rabs (psi j m ^ 2 * d) = psi j m ^ 2 * Rabs d) by (rewrite Rabs_mult, (Rabs_right (psi j m ^ 2)) by
    (apply Rle_ge, pow2_ge_0); reflexivity).
  unfold X_j, X_83, error_79. fold d. rewrite <- Ed. apply Rabs_le_between in EV. apply Rabs_le_between in EG.
  pose proof (Rabs_le_between (psi j m ^ 2 * d) (Rabs (psi j m ^ 2 * d))) as [Q _]. specialize (Q (Rle_refl _)). 
  replace (psi j m ^ 2 * second_function_at_resonance (zeta m)) with (psi j m ^ 2 * g 1 (zeta m) - psi j m ^ 2 * d) by
    (unfold d; ring).
  set (e := Rabs (psi j m ^ 2 * d)) in *. set (f := psi j m ^ 2 * d) in *. set (a := psi j m ^ 2 * g 1 (zeta m)) in *.
  set (w := (beta * U s j) ^ 2 / V_abs s j) in *. apply Rabs_le.
  assert (B1 : beta * (- G_of_others s m - e) <= beta * (G s j - a + f)) by (apply Rmult_le_compat_l; lra).
  assert (B2 : beta * (G s j - a + f) <= beta * (G_of_others s m + e)) by (apply Rmult_le_compat_l; lra).
  assert (W : 0 <= w) by (apply Rmult_le_pos; [apply pow2_ge_0 | apply Rlt_le, Rinv_0_lt_compat, H]). lra.
Qed.

Lemma between a b : Rabs a <= b -> - b <= a <= b.
Proof. intros H. apply Rabs_le_between, H. Qed.
Lemma error_85 mu : (m < N)%nat -> R_ m = 1 -> 0 < zeta m -> psi j m <> 0 -> 1 <= mu ->
  Rabs (sqrt (V_abs s j ^ 2 / (U s j ^ 2 + (H_j s + mu * mobility s) ^ 2)) - beta_85 s m) <=
  (V_of_others s m + beta_85 s m * (Rabs (U s j) + H_of_others s m + psi j m ^ 2 * (error_79 s m + 2 * zeta m * Rabs (u 1
    (zeta m)))
    + mu * mobility s)) / sqrt (U s j ^ 2 + (H_j s + mu * mobility s) ^ 2).
Proof.
  intros Hm HR Hz Hp Hmu. pose proof (between _ _ (V_at_resonance Hm HR Hz)) as EV.
  pose proof (start_demand_pos s Hs) as SP. pose proof (mobility_pos s Hs) as Mp.
  set (D := H_j s + mu * mobility s). assert (PD : 0 < D) by (unfold D; nra).
  assert (PQ : 0 < U s j ^ 2 + D ^ 2) by nra. set (E := sqrt (U s j ^ 2 + D ^ 2)). assert (PE : 0 < E) by (apply sqrt_lt_R0,
    PQ).
  assert (EE : E * E = U s j ^ 2 + D ^ 2) by (apply sqrt_sqrt; lra).
  assert (V0 : 0 <= V_abs s j) by apply sqrt_pos.
  assert (L : sqrt (V_abs s j ^ 2 / (U s j ^ 2 + D ^ 2)) = V_abs s j / E).
  { rewrite <- EE. replace (V_abs s j ^ 2 / (E * E)) with (V_abs s j / E * (V_abs s j / E)) by (field; lra).
    apply sqrt_square, Rmult_le_pos; [exact V0 | apply Rlt_le, Rinv_0_lt_compat, PE]. }
  fold D. rewrite L. pose proof PI_RGT_0. assert (ZP : 0 < zeta m * PI) by nra.
  pose proof (sinh_above _ ZP). pose proof (cosh_above (zeta m * PI) ltac:(lra)).
  set (g79 := second_function_at_resonance (zeta m)). set (b := beta_85 s m).
  pose proof (Rabs_pos_lt _ Hp) as Pp.
  assert (Id : b * (psi j m ^ 2 * g79) = Rabs (psi j m * psi l m) / (2 * zeta m)).
  { unfold b, beta_85, g79, second_function_at_resonance. rewrite Rabs_mult. unfold Rdiv at 1. rewrite Rabs_mult, Rabs_Rinv
    by exact Hp.
    rewrite <- (pow2_abs (psi j m)). field. repeat split; lra. }
  assert (B0 : 0 <= b).
  { unfold b, beta_85. apply Rmult_le_pos; [apply Rabs_pos|]. apply Rlt_le, Rdiv_lt_0_compat; [lra | nra]. }
  assert (EH : Rabs (H_j s - psi j m ^ 2 * (g 1 (zeta m) + 2 * zeta m * u 1 (zeta m))) <= H_of_others s m).
  { unfold H_j. pose proof (rest_of_sum (fun i => psi j i ^ 2 * (g (R_ i) (zeta i) + 2 * zeta i * R_ i * u (R_ i) (zeta i)))
      (fun i => psi j i ^ 2 * Rabs (g (R_ i) (zeta i) + 2 * zeta i * R_ i * u (R_ i) (zeta i))) Hm) as Q. cbv beta in Q.
        rewrite HR in Q.
    replace (2 * zeta m * 1 * u 1 (zeta m)) with (2 * zeta m * u 1 (zeta m)) in Q by ring. apply Q.
    intros i _. rewrite Rabs_mult, Rabs_right by (apply Rle_ge, pow2_ge_0). apply Rle_refl. }
  apply between in EH. pose proof (between _ _ (Rle_refl (Rabs (g 1 (zeta m) - g79)))) as Q1.
  pose proof (between _ _ (Rle_refl (Rabs (u 1 (zeta m))))) as Q2. pose proof (between _ _ (Rle_refl (Rabs (U s j)))) as Q3.
  set (T := Rabs (U s j) + H_of_others s m + psi j m ^ 2 * (Rabs (g 1 (zeta m) - g79) + 2 * zeta m * Rabs (u 1 (zeta m))) +
    mu * mobility s).
  assert (P2 : 0 <= psi j m ^ 2) by apply pow2_ge_0.
  assert (S1 : - (psi j m ^ 2 * (Rabs (g 1 (zeta m) - g79) + 2 * zeta m * Rabs (u 1 (zeta m)))) <=
    psi j m ^ 2 * (g 1 (zeta m) - g79 + 2 * zeta m * u 1 (zeta m)) <=
    psi j m ^ 2 * (Rabs (g 1 (zeta m) - g79) + 2 * zeta m * Rabs (u 1 (zeta m)))).
  { assert (2 * zeta m * u 1 (zeta m) <= 2 * zeta m * Rabs (u 1 (zeta m))) by (apply Rmult_le_compat_l; lra).
    assert (2 * zeta m * - u 1 (zeta m) <= 2 * zeta m * Rabs (u 1 (zeta m))) by (apply Rmult_le_compat_l; lra).
    rewrite <- Ropp_mult_distr_r_reverse. split; apply Rmult_le_compat_l; lra. }
  assert (E1 : D <= E) by (apply Rsqr_incr_0_var; [unfold Rsqr; rewrite EE; nra | lra]).
  assert (E2 : E <= D + Rabs (U s j)).
  { apply Rsqr_incr_0_var; [|pose proof (Rabs_pos (U s j)); lra]. unfold Rsqr. rewrite EE, <- (pow2_abs (U s j)).
    pose proof (Rabs_pos (U s j)). nra. }
  assert (MM : 0 <= mu * mobility s) by nra.
  assert (DT : - T <= psi j m ^ 2 * g79 - E <= T).
  { assert (X : D - psi j m ^ 2 * g79 = (H_j s - psi j m ^ 2 * (g 1 (zeta m) + 2 * zeta m * u 1 (zeta m)))
      + psi j m ^ 2 * (g 1 (zeta m) - g79 + 2 * zeta m * u 1 (zeta m)) + mu * mobility s) by (unfold D; ring).
    unfold T. lra. }
  assert (BT : b * - T <= b * (psi j m ^ 2 * g79 - E) <= b * T) by (split; apply Rmult_le_compat_l; lra).
  replace (V_abs s j / E - b) with ((V_abs s j - b * (psi j m ^ 2 * g79) + b * (psi j m ^ 2 * g79 - E)) / E) by (field; lra).
  unfold Rdiv at 1. rewrite Rabs_mult, (Rabs_right (/ E)) by (apply Rle_ge, Rlt_le, Rinv_0_lt_compat, PE).
  apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat, PE|]. unfold error_79. fold g79 b T. rewrite Id. apply Rabs_le. lra.
Qed.
End Others.

Theorem eq_83_error : forall s m, Statements.eq_83_error s m.
Proof. intros s m Hs H Hb Hm HR Hz. apply (error_83 s m H Hb Hm HR Hz). Qed.
Theorem eq_85_error : forall s m, Statements.eq_85_error s m.
Proof. intros s m mu Hs Hm HR Hz Hp Hmu. apply (error_85 s m Hs mu Hm HR Hz Hp Hmu). Qed.
