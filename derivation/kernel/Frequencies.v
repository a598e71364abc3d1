(* One system at all frequencies: (86) as the limit of (69), amplitudes that vanish, and (67), (69) at small frequencies. *)
Require Import Reals Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes SteadyMode Sums Masses Contact OneVelocity Slopes ContactMotion
  LargestDemand Misprints Limits HighFrequency Attraction.
Open Scope R_scope.

Theorem at_frequency_is_a_scene : Statements.at_frequency_is_a_scene.
Proof.
  intros s r Hs Hr A. pose proof (fun i Hi => Hratio s Hs i Hi) as Rp. destruct Hs as [J [Lo [_ [St [Or Da]]]]].
  split; [exact J|]. split; [exact Lo|]. split; [exact A|]. cbn [masses mass damping stiffness shape ratio damping_ratio
    at_frequency].
  split; [|split].
  - intros i a Hi Ha. rewrite (Sum_ext _ (fun b => stiffness s a b * (shape s b i / r)) (fun b => / r * (stiffness s a b * shape
    s b i)))
      by (intros; unfold Rdiv; ring).
    rewrite (Sum_ext _ (fun b => r ^ 2 * mass s a b * (shape s b i / r)) (fun b => r * (mass s a b * shape s b i))) by (intros;
      field;
      lra).
    rewrite !Sum_scal, (St i a Hi Ha). specialize (Rp i Hi). field. lra.
  - intros i k Hi Hk. rewrite <- (Or i k Hi Hk). apply Sum_ext. intros a Ha.
    rewrite (Sum_ext _ (fun b => r ^ 2 * mass s a b * (shape s b k / r)) (fun b => r * (mass s a b * shape s b k))) by (intros;
      field;
      lra). rewrite Sum_scal. field. lra.
  - intros i k Hi Hk. transitivity (/ r * (delta i k * (2 * damping_ratio s i / ratio s i))); [|specialize (Rp i Hi); field; lra].
    rewrite <- (Da i k Hi Hk), <- Sum_scal. apply Sum_ext. intros a Ha.
    rewrite (Sum_ext _ (fun b => r * damping s a b * (shape s b k / r)) (fun b => damping s a b * shape s b k)) by (intros;
      field; lra).
    field. lra.
Qed.

Lemma mobility_at s r : 0 < r -> mobility (at_frequency s r) = mobility s / r ^ 2.
Proof.
  intros Hr. unfold mobility. cbn [masses shape contact at_frequency]. unfold Rdiv. rewrite <- Sum_scal_r. apply Sum_ext. intros
    i _.
  field. lra.
Qed.
Theorem shares_are_constant : Statements.shares_are_constant.
Proof.
  intros s r k i Hs Hr. split; [apply mobility_at, Hr|]. rewrite mobility_at by exact Hr. pose proof (mobility_pos s Hs).
  cbn [shape contact at_frequency]. field. lra.
Qed.

Lemma high_mode z R_i : 0 <= z < 1 -> 2 < R_i -> admissible R_i z /\ w z <= 2 * R_i.
Proof.
  intros Hz Hr. pose proof (w_sq z Hz). pose proof (w_pos z Hz). split; [|nra]. split; [lra|]. split; [exact Hz|]. split.
  - apply Rgt_not_eq. exact (bottom_above z Hz R_i Hr).
  - apply (resonance_denominator z Hz R_i Hr).
Qed.

(* Above this frequency the ratios of all modes exceed 2. *)
Lemma high_frequency s : is_scene s -> exists r0, 0 < r0 /\ forall r, r0 < r -> is_scene (at_frequency s r) /\
  forall i, (i < masses s)%nat -> w (damping_ratio s i) <= 2 * (r * ratio s i).
Proof.
  intros Hs. assert (P : forall i, (i < masses s)%nat -> 0 <= 2 / ratio s i).
  { intros i Hi. pose proof (Hratio s Hs i Hi). apply Rlt_le, Rdiv_lt_0_compat; lra. }
  exists (1 + Sum (masses s) (fun i => 2 / ratio s i)). pose proof (Sum_nonneg _ _ P) as P0. split; [lra|]. intros r Hr.
  assert (Hi2 : forall i, (i < masses s)%nat -> 2 < r * ratio s i).
  { intros i Hi. pose proof (Hratio s Hs i Hi) as Ri. pose proof (Sum_part (masses s) (fun i => 2 / ratio s i) i P Hi) as Q.
    cbv beta in Q. apply Rle_lt_trans with (2 / ratio s i * ratio s i); [right; field; lra|]. apply Rmult_lt_compat_r; lra. }
  assert (M : forall i, (i < masses s)%nat -> admissible (r * ratio s i) (damping_ratio s i) /\ w (damping_ratio s i) <= 2 * (r *
    ratio s i)).
  { intros i Hi. destruct (Hadm s Hs i Hi) as [_ [Hz _]]. apply high_mode; [exact Hz | apply Hi2, Hi]. }
  split; [apply at_frequency_is_a_scene; [exact Hs | lra | intros i Hi; apply M, Hi] | intros i Hi; apply M, Hi].
Qed.

Lemma shares_ext n a a' b b' R_ z mu : (forall i, (i < n)%nat -> a i = a' i /\ b i = b' i) ->
  limit_by_shares n a b R_ z mu = limit_by_shares n a' b' R_ z mu.
Proof.
  intros E. assert (A : forall f, Sum n (fun i => a i * f i) = Sum n (fun i => a' i * f i)) by (intros; apply Sum_ext; intros i
    Hi;
    destruct (E i Hi) as [-> _]; reflexivity).
  assert (B : forall f, Sum n (fun i => b i * f i) = Sum n (fun i => b' i * f i)) by (intros; apply Sum_ext; intros i Hi;
    destruct (E i Hi) as [_ ->]; reflexivity).
  unfold limit_by_shares. rewrite (A (fun i => R_ i ^ 2 * u (R_ i) (z i))), (A (fun i => g (R_ i) (z i) + 2 * z i * (R_ i * u
    (R_ i) (z
    i)))), (B (fun i => R_ i ^ 2 * v_re (R_ i) (z i))), (B (fun i => R_ i ^ 2 * v_im (R_ i) (z i))). reflexivity.
Qed.

Theorem eq_86_from_eq_69 : Statements.eq_86_from_eq_69.
Proof.
  intros s mu L Hs Al Hm HL. destruct (high_frequency s Hs) as [r0 [Hr0 Hi]]. split; [exists r0; intros r Hr; apply Hi, Hr|].
  destruct (sum_of_shares s Hs Al) as [SA SB].
  set (a := fun i => shape s (contact s) i ^ 2 / mobility s) in *.
  set (b := fun i => shape s (contact s) i * shape s (loaded s) i / mobility s) in *.
  assert (Lim := eq_86_all_masses (masses s) a b (ratio s) (damping_ratio s) mu ltac:(lra) SA (fun i Hi => conj (Hratio s Hs i Hi)
    (proj1 (proj2 (Hadm s Hs i Hi))))).
  rewrite SB in Lim. replace (Rabs (delta (contact s) (loaded s))) with (delta (contact s) (loaded s)) in Lim.
  2: { symmetry. apply Rabs_right. unfold delta. destruct (Nat.eqb _ _); lra. }
  apply (is_lim_ext_loc (fun r => limit_by_shares (masses s) a b (fun i => r * ratio s i) (damping_ratio s) mu) L p_infty
    (delta (contact s) (loaded s) * (2 / sqrt (4 * mu ^ 2 + PI ^ 2)))); [|exact Lim].
  exists r0. intros r Hr. destruct (Hi r Hr) as [Sc Low]. pose proof (mobility_pos _ Sc) as Mp.
  rewrite (HL r _ ltac:(lra) Sc (supremum_at_start _ Sc Low)). unfold limit_69. rewrite Rmax_right by nra.
  rewrite (eq_67_by_shares _ mu Sc). cbn [masses ratio damping_ratio contact loaded at_frequency]. apply shares_ext. intros i _.
  destruct (shares_are_constant s r (contact s) i Hs ltac:(lra)) as [_ E1].
  destruct (shares_are_constant s r (loaded s) i Hs ltac:(lra)) as [_ E2].
  unfold a, b. rewrite E2, <- Rsqr_pow2, <- Rsqr_pow2. unfold Rsqr. rewrite E1. split; reflexivity.
Qed.

(* ---- Amplitudes at large frequencies ---- *)
Lemma falls_like_square n a c (f : nat -> R -> R) : (forall i, (i < n)%nat -> is_lim (f i) p_infty (Finite (c i))) ->
  is_lim (fun r => / r ^ 2 * Sum n (fun i => a i * f i r)) p_infty 0.
Proof.
  intros H. assert (Q : is_lim (fun r => / r ^ 2) p_infty 0).
  { apply (by_reciprocal _ (fun e => e ^ 2)); [apply limit_value; [auto_derive; trivial | ring] | intros r Hr; field; lra]. }
  replace 0 with (0 * Sum n (fun i => a i * c i)) by ring.
  pose proof (is_lim_mult _ _ _ _ _ Q (Sum_limit n a c f H) I) as M. exact M.
Qed.
Lemma small_at_infinity (f h : R -> R) d : is_lim f p_infty 0 -> (forall r, 0 < r -> h r = f r) -> 0 < d ->
  exists r0, 0 < r0 /\ forall r, r0 < r -> Rabs (h r) < d.
Proof.
  intros L E Hd. apply is_lim_spec in L. destruct (L (mkposreal d Hd)) as [r0 H]. pose proof (Rmax_l 1 r0). pose proof (Rmax_r 1
    r0).
  exists (Rmax 1 r0). split; [lra|]. intros r Hr. specialize (H r ltac:(lra)). rewrite Rminus_0_r in H. rewrite E by lra. exact H.
Qed.

Lemma amplitude_bound s k : responds s -> X_k s k <= 4 * V_abs s k + Rabs (friction s) * (Rabs (G s k) + Rabs (U s k)) /\
  Rabs (X_j s) <= V_abs s (contact s) + Rabs (friction s) * Rabs (G s (contact s)).
Proof.
  intros Re. destruct (eq_52_53 s Re k) as [E _]. pose proof (root_sq s Re) as RS. pose proof (root_pos s) as RP.
  destruct Re as [HV HU]. assert (Vk : 0 <= V_abs s k) by apply sqrt_pos.
  assert (RV : root s <= V_abs s (contact s)) by (pose proof (pow2_ge_0 (friction s * U s (contact s))); nra).
  set (D := V_arg s k - V_arg s (contact s)) in *. pose proof (COS_bound D) as CD. pose proof (SIN_bound D) as SD.
  assert (Bd : forall p q c d, Rabs p <= V_abs s (contact s) -> Rabs q <= V_abs s (contact s) -> -1 <= c <= 1 -> -1 <= d <= 1 ->
    Rabs (V_abs s k / V_abs s (contact s) * (p * c + q * d)) <= 2 * V_abs s k).
  { intros p q c d Hp Hq Hc Hd. rewrite Rabs_mult, (Rabs_right (V_abs s k / V_abs s (contact s))) by (apply Rle_ge,
    Rmult_le_pos; [exact
      Vk | apply Rlt_le, Rinv_0_lt_compat, HV]).
    replace (2 * V_abs s k) with (V_abs s k / V_abs s (contact s) * (2 * V_abs s (contact s))) by (field; lra).
    apply Rmult_le_compat_l; [apply Rmult_le_pos; [exact Vk | apply Rlt_le, Rinv_0_lt_compat, HV]|].
    apply Rle_trans with (1 := Rabs_triang _ _). rewrite !Rabs_mult.
    assert (Rabs c <= 1) by (apply Rabs_le; lra). assert (Rabs d <= 1) by (apply Rabs_le; lra).
    assert (Rabs p * Rabs c <= V_abs s (contact s) * 1) by (apply Rmult_le_compat; try apply Rabs_pos; assumption).
    assert (Rabs q * Rabs d <= V_abs s (contact s) * 1) by (apply Rmult_le_compat; try apply Rabs_pos; assumption). lra. }
  assert (Rr : Rabs (root s) <= V_abs s (contact s)) by (rewrite Rabs_right; lra). split.
  - assert (BC : Rabs (X_kC s k) <= 2 * V_abs s k + Rabs (friction s) * Rabs (G s k)).
    { unfold X_kC. fold D. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp, (Rabs_mult (friction s) (G s k)).
      pose proof (Bd (root s) (friction s * U s (contact s)) (cos D) (sin D) Rr HU CD SD). lra. }
    assert (BS : Rabs (X_kS s k) <= 2 * V_abs s k + Rabs (friction s) * Rabs (U s k)).
    { unfold X_kS. fold D. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp, (Rabs_mult (friction s) (U s k)).
      pose proof (Bd (friction s * U s (contact s)) (root s) (cos D) (- sin D) HU Rr CD ltac:(lra)) as B.
      replace (friction s * U s (contact s) * cos D + root s * - sin D) with (friction s * U s (contact s) * cos D - root s *
        sin D) in B
        by ring. lra. }
    rewrite E. apply Rle_trans with (Rabs (X_kC s k) + Rabs (X_kS s k)); [|lra].
    pose proof (Rabs_pos (X_kC s k)). pose proof (Rabs_pos (X_kS s k)).
    rewrite <- (sqrt_square (Rabs (X_kC s k) + Rabs (X_kS s k))) by lra. apply sqrt_le_1_alt.
    rewrite <- (pow2_abs (X_kC s k)), <- (pow2_abs (X_kS s k)). nra.
  - unfold X_j. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_mult, Rabs_Ropp. lra.
Qed.

Lemma V_abs_below s k : V_abs s k <= Rabs (V_re s k) + Rabs (V_im s k).
Proof.
  unfold V_abs. pose proof (Rabs_pos (V_re s k)). pose proof (Rabs_pos (V_im s k)).
  rewrite <- (sqrt_square (Rabs (V_re s k) + Rabs (V_im s k))) by lra. apply sqrt_le_1_alt.
  rewrite <- (pow2_abs (V_re s k)), <- (pow2_abs (V_im s k)). nra.
Qed.

Lemma all_small s k d : is_scene s -> 0 < d -> exists r0, forall r, r0 < r -> let s' := at_frequency s r in
  Rabs (V_re s' k) < d /\ Rabs (V_im s' k) < d /\ Rabs (G s' k) < d /\ Rabs (U s' k) < d.
Proof.
  intros Hs Hd. pose proof (fun i Hi => proj1 (proj2 (Hadm s Hs i Hi))) as Z. pose proof (fun i Hi => Hratio s Hs i Hi) as Rp.
  destruct (small_at_infinity _ (fun r => V_re (at_frequency s r) k) d (falls_like_square (masses s) (fun i => shape s k i *
    shape s
    (loaded s) i) (fun _ => -1) (fun i r => (r * ratio s i) ^ 2 * v_re (r * ratio s i) (damping_ratio s i)) (fun i Hi => scaled
      _ _ _
    (Rp i Hi) (proj1 (v_at_infinity _ (Z i Hi)))))) as [r1 [_ H1]]; [|exact Hd|].
  { intros r Hr. unfold V_re. rewrite <- Sum_scal. apply Sum_ext. intros i _. cbn [shape ratio damping_ratio loaded at_frequency].
    field. lra. }
  destruct (small_at_infinity _ (fun r => V_im (at_frequency s r) k) d (falls_like_square (masses s) (fun i => shape s k i *
    shape s
    (loaded s) i) (fun _ => 0) (fun i r => (r * ratio s i) ^ 2 * v_im (r * ratio s i) (damping_ratio s i)) (fun i Hi => scaled _
      _ _
    (Rp i Hi) (proj2 (v_at_infinity _ (Z i Hi)))))) as [r2 [_ H2]]; [|exact Hd|].
  { intros r Hr. unfold V_im. rewrite <- Sum_scal. apply Sum_ext. intros i _. cbn [shape ratio damping_ratio loaded at_frequency].
    field. lra. }
  destruct (small_at_infinity _ (fun r => U (at_frequency s r) k) d (falls_like_square (masses s) (fun i => shape s k i * shape s
    (contact s) i) (fun _ => PI / 2) (fun i r => (r * ratio s i) ^ 2 * u (r * ratio s i) (damping_ratio s i)) (fun i Hi =>
      scaled _ _ _
    (Rp i Hi) (u_at_infinity _ (Z i Hi))))) as [r3 [_ H3]]; [|exact Hd|].
  { intros r Hr. unfold U. rewrite <- Sum_scal. apply Sum_ext. intros i _. cbn [shape ratio damping_ratio contact at_frequency].
    field. lra. }
  assert (LG := Sum_limit (masses s) (fun i => shape s k i * shape s (contact s) i * ratio s i ^ 2) (fun _ => 0) (fun i r => g
    (r * ratio
    s i) (damping_ratio s i)) (fun i Hi => scaled _ _ _ (Rp i Hi) (g_at_infinity _))).
  cbv beta in LG.
  rewrite (Sum_zero (masses s) (fun i => shape s k i * shape s (contact s) i * ratio s i ^ 2 * 0)) in LG by (intros; ring).
  destruct (small_at_infinity _ (fun r => G (at_frequency s r) k) d LG) as [r4 [_ H4]]; [|exact Hd|].
  { intros r Hr. unfold G. apply Sum_ext. intros i _. cbn [shape ratio damping_ratio contact at_frequency]. field. lra. }
  exists (Rmax (Rmax r1 r2) (Rmax r3 r4)). intros r Hr s'. pose proof (Rmax_l (Rmax r1 r2) (Rmax r3 r4)). pose proof (Rmax_r
    (Rmax r1
    r2) (Rmax r3 r4)). pose proof (Rmax_l r1 r2). pose proof (Rmax_r r1 r2). pose proof (Rmax_l r3 r4). pose proof (Rmax_r r3 r4).
  repeat split; [apply H1 | apply H2 | apply H4 | apply H3]; lra.
Qed.

Theorem amplitudes_vanish : Statements.amplitudes_vanish.
Proof.
  intros s k e Hs Hk He. pose proof (Rabs_pos (friction s)) as B0. set (B := Rabs (friction s)) in *.
  set (d := e / (9 + 2 * B)). assert (Hd : 0 < d) by (apply Rdiv_lt_0_compat; lra).
  assert (Ed : d * (9 + 2 * B) = e) by (unfold d; field; lra).
  destruct (all_small s k d Hs Hd) as [r1 H1]. destruct (all_small s (contact s) d Hs Hd) as [r2 H2].
  exists (Rmax r1 r2). intros r Hr Re. pose proof (Rmax_l r1 r2). pose proof (Rmax_r r1 r2).
  destruct (H1 r ltac:(lra)) as [A1 [A2 [A3 A4]]]. destruct (H2 r ltac:(lra)) as [C1 [C2 [C3 _]]].
  destruct (amplitude_bound (at_frequency s r) k Re) as [Xk Xj]. pose proof (V_abs_below (at_frequency s r) k).
  pose proof (V_abs_below (at_frequency s r) (contact s)).
  change (friction (at_frequency s r)) with (friction s) in *. change (contact (at_frequency s r)) with (contact s) in *. fold B
    in Xk,
    Xj.
  assert (M1 : B * (Rabs (G (at_frequency s r) k) + Rabs (U (at_frequency s r) k)) <= B * (2 * d)) by (apply Rmult_le_compat_l;
    lra).
  assert (M2 : B * Rabs (G (at_frequency s r) (contact s)) <= B * d) by (apply Rmult_le_compat_l; lra).
  split; [|assert (0 <= B * d) by (apply Rmult_le_pos; lra)]; lra.
Qed.

(* ---- Small frequencies ---- *)
Local Notation tends f a := (filterlim f (at_right 0) (locally (a : R))).
Lemma tends_plus (f h : R -> R) a b : tends f a -> tends h b -> tends (fun r => f r + h r) (a + b).
Proof. intros F H. exact (filterlim_comp_2 _ _ _ F H (filterlim_plus (V := R_NormedModule) a b)). Qed.
Lemma tends_mult (f h : R -> R) a b : tends f a -> tends h b -> tends (fun r => f r * h r) (a * b).
Proof. intros F H. exact (filterlim_comp_2 _ _ _ F H (filterlim_mult (K := R_AbsRing) a b)). Qed.
Lemma tends_const a : tends (fun _ => a) a.
Proof. apply filterlim_const. Qed.
Lemma tends_through (f h : R -> R) a : tends f a -> continuous h a -> tends (fun r => h (f r)) (h a).
Proof. intros F H. exact (filterlim_comp _ _ _ f h _ _ _ F H). Qed.
Lemma tends_sum n (f : nat -> R -> R) (a : nat -> R) c : Sum n a = c -> (forall i, (i < n)%nat -> tends (f i) (a i)) ->
  tends (fun r => Sum n (fun i => f i r)) c.
Proof.
  intros <-. induction n; intros H; simpl; [apply tends_const|]. apply tends_plus; [apply IHn; intros; apply H; lia | apply H;
    lia].
Qed.
Lemma tends_ext (f h : R -> R) a : (forall r, 0 < r -> f r = h r) -> tends f a -> tends h a.
Proof. intros E. apply filterlim_ext_loc. exists (mkposreal 1 Rlt_0_1). intros r _ Hr. apply E, Hr. Qed.
Lemma tends_scaled (f : R -> R) rho a : 0 < rho -> tends f a -> tends (fun r => f (r * rho)) a.
Proof.
  intros Hr F. apply (filterlim_comp _ _ _ (fun r => r * rho) f (at_right 0) (at_right 0)); [|exact F].
  intros P [e He]. assert (Ee : 0 < e / rho) by (apply Rdiv_lt_0_compat; [apply cond_pos | exact Hr]).
  exists (mkposreal _ Ee). intros r Br Pr. apply He; [|apply Rmult_lt_0_compat; assumption].
  change (Rabs (r - 0) < e / rho) in Br. change (Rabs (r * rho - 0) < e). rewrite Rminus_0_r in *.
  rewrite Rabs_mult, (Rabs_right rho) by lra. apply (Rmult_lt_compat_r rho) in Br; [|exact Hr].
  replace (e / rho * rho) with (e : R) in Br by (field; lra). exact Br.
Qed.
Lemma tends_by_square (f : R -> R) c B : 0 <= B -> (forall r, 0 < r < 1 -> Rabs (f r - c) <= B * r ^ 2) -> tends f c.
Proof.
  intros HB H P [e He]. pose proof (cond_pos e) as Ep. set (d := Rmin 1 (e / (B + 1))).
  assert (Hd : 0 < d) by (apply Rmin_glb_lt; [lra | apply Rdiv_lt_0_compat; lra]). exists (mkposreal d Hd). intros r Br Pr.
  change (Rabs (r - 0) < d) in Br. rewrite Rminus_0_r, Rabs_right in Br by lra. unfold d in Br. pose proof (Rmin_l 1 (e / (B +
    1))).
  pose proof (Rmin_r 1 (e / (B + 1))). apply He. change (Rabs (f r - c) < e). apply Rle_lt_trans with (1 := H r ltac:(lra)).
  assert (r * (B + 1) < e).
  { replace (e : R) with (e / (B + 1) * (B + 1)) by (field; lra). apply Rmult_lt_compat_r; lra. } nra.
Qed.

Section Mode.
Variable z : R.
Hypothesis Hz : 0 < z < 1.
Let Hw : 0 < w z := w_pos z ltac:(lra).

Lemma sinh_above_identity y : 0 <= y -> y <= sinh y.
Proof.
  intros Hy. assert (F : (fun t => t - sinh t) y <= (fun t => t - sinh t) 0); [|cbv beta in F; rewrite sinh_0 in F; lra].
  apply (not_growing nil (fun t => t - sinh t) 0 y Hy).
  - intros t _. apply (ex_derive_continuous (K := R_AbsRing) (V := R_NormedModule)). unfold sinh. auto_derive. trivial.
  - intros t Ht _. exists (1 - cosh t). split; [unfold sinh, cosh; auto_derive; [trivial | field]|]. pose proof (cosh_above t
    ltac:(lra)).
    lra.
Qed.
Lemma cosh_grows x : 0 <= x -> 1 + x ^ 2 / 2 <= cosh x.
Proof.
  intros Hx. assert (E : cosh x = 1 + 2 * sinh (x / 2) ^ 2).
  { unfold cosh, sinh. replace x with (x / 2 + x / 2) at 1 2 by field. rewrite Ropp_plus_distr, !exp_plus.
    assert (P : exp (x / 2) * exp (- (x / 2)) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0).
    set (a := exp (x / 2)) in *. set (b := exp (- (x / 2))) in *. transitivity (1 + (a * a + b * b - 2 * (a * b)) / 2); [rewrite
      P;
      field | field]. }
  rewrite E. pose proof (sinh_above_identity (x / 2) ltac:(lra)). nra.
Qed.
Lemma divisor_grows r : 0 < r < 1 -> z ^ 2 / (2 * r ^ 2) <= cosh (decay r z) + cos (theta r z) /\ 0 < z ^ 2 / (2 * r ^ 2).
Proof.
  intros Hr. assert (Rr : 0 < r ^ 2) by (apply pow_lt; lra). assert (Zz : 0 < z ^ 2) by (apply pow_lt; lra).
  split; [|apply Rdiv_lt_0_compat; lra]. pose proof (COS_bound (theta r z)). pose proof PI2_1. pose proof PI_RGT_0.
  assert (X : 0 < decay r z) by (unfold decay; apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra).
  pose proof (cosh_grows (decay r z) ltac:(lra)) as C.
  assert (Q : decay r z ^ 2 = PI ^ 2 * (z ^ 2 / r ^ 2)) by (unfold decay; field; lra).
  assert (Zr : 0 < z ^ 2 / r ^ 2) by (apply Rdiv_lt_0_compat; assumption). assert (1 <= PI ^ 2) by nra.
  replace (z ^ 2 / (2 * r ^ 2)) with (z ^ 2 / r ^ 2 / 2) by (field; lra). nra.
Qed.
Lemma quotient_small r n B : 0 < r < 1 -> Rabs n <= B -> Rabs (n / (cosh (decay r z) + cos (theta r z))) <= 2 * B / z ^ 2 * r ^ 2.
Proof.
  intros Hr Hn. destruct (divisor_grows r Hr) as [D P]. set (c := cosh _ + cos _) in *. assert (Zz : 0 < z ^ 2) by (apply
    pow_lt; lra).
  pose proof (Rabs_pos n). unfold Rdiv at 1. rewrite Rabs_mult, Rabs_inv, (Rabs_right c) by lra.
  apply Rle_trans with (B * / (z ^ 2 / (2 * r ^ 2))).
  - apply Rmult_le_compat; [lra | apply Rlt_le, Rinv_0_lt_compat; lra | exact Hn | apply Rinv_le_contravar; assumption].
  - right. field. split; lra.
Qed.
Lemma u_bound r : 0 < r < 1 -> Rabs (r * u r z) <= 2 * / w z / z ^ 2 * r ^ 2.
Proof.
  intros Hr. destruct (divisor_grows r Hr) as [D P].
  replace (r * u r z) with (sin (theta r z) / w z / (cosh (decay r z) + cos (theta r z))) by (unfold u; field; repeat split; lra).
  apply quotient_small; [exact Hr|]. unfold Rdiv. rewrite Rabs_mult, (Rabs_right (/ w z)) by (apply Rle_ge, Rlt_le,
    Rinv_0_lt_compat, Hw).
  pose proof (SIN_bound (theta r z)). rewrite <- (Rmult_1_l (/ w z)) at 2. apply Rmult_le_compat_r; [apply Rlt_le,
    Rinv_0_lt_compat, Hw | apply Rabs_le; lra].
Qed.
Lemma g_bound r : 0 < r < 1 -> Rabs (g r z - 1) <= 2 * (2 + z / w z) / z ^ 2 * r ^ 2.
Proof.
  intros Hr. assert (Q : 0 < z / w z) by (apply Rdiv_lt_0_compat; lra). destruct (divisor_grows r Hr) as [D P]. pose proof
    PI_RGT_0.
  assert (X : 0 < decay r z) by (unfold decay; apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra).
  replace (g r z - 1) with ((- exp (- decay r z) - z / w z * sin (theta r z) - cos (theta r z)) / (cosh (decay r z) + cos (theta r
    z))).
  2: { unfold g. replace (exp (- decay r z)) with (cosh (decay r z) - sinh (decay r z)) by (unfold cosh, sinh; field). field.
    split;
    lra. }
  apply quotient_small; [exact Hr|]. pose proof (SIN_bound (theta r z)). pose proof (COS_bound (theta r z)).
  pose proof (exp_pos (- decay r z)). assert (exp (- decay r z) < 1) by (rewrite <- exp_0; apply exp_increasing; lra).
  apply Rabs_le. nra.
Qed.
Lemma bounds_positive : 0 <= 2 * / w z / z ^ 2 /\ 0 <= 2 * (2 + z / w z) / z ^ 2.
Proof.
  assert (0 < / w z) by (apply Rinv_0_lt_compat, Hw). assert (0 < z / w z) by (apply Rdiv_lt_0_compat; lra).
  split; (apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat, pow_lt; lra]).
Qed.
Lemma u_at_zero : tends (fun r => r * u r z) 0.
Proof.
  apply (tends_by_square _ 0 (2 * / w z / z ^ 2)); [apply bounds_positive|]. intros r Hr. rewrite Rminus_0_r. apply u_bound, Hr.
Qed.
Lemma g_at_zero : tends (fun r => g r z) 1.
Proof. apply (tends_by_square _ 1 (2 * (2 + z / w z) / z ^ 2)); [apply bounds_positive | apply g_bound]. Qed.
Lemma v_at_zero : tends (fun r => v_re r z) 1 /\ tends (fun r => v_im r z) 0.
Proof.
  split; apply from_the_right, limit_value; try (unfold v_re, v_im; auto_derive; lra); unfold v_re, v_im; field; lra.
Qed.
Lemma low_admissible r : 0 < r < 1 -> admissible r z.
Proof.
  intros Hr. destruct (divisor_grows r Hr) as [D P]. split; [lra|]. split; [lra|]. split; [lra|].
  assert (0 < 2 * z * r) by (apply Rmult_lt_0_compat; lra). pose proof (pow2_ge_0 (1 - r * r)). nra.
Qed.

(* The parts of (57) at the time t: the decay, q and its rate *)
Section Time.
Variables (r t : R).
Hypothesis Hr : 0 < r < 1.
Hypothesis Ht : 0 <= t.
Let a := exp (- z * t / r).
Let b := w z * t / r.
Lemma w_at_most_1 : w z <= 1.
Proof. pose proof (w_sq z ltac:(lra)). nra. Qed.
Lemma decay_below : 0 < a /\ a * (1 + z * t / r) <= 1 /\ a <= 1 /\ 1 - z * t / r <= a.
Proof.
  set (x := z * t / r). assert (X : 0 <= x) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | apply Rlt_le, Rinv_0_lt_compat;
    lra]).
  assert (E : a = exp (- x)) by (unfold a, x; f_equal; field; lra). pose proof (exp_pos x) as P. pose proof (exp_pos (- x)) as P'.
  assert (U : exp (- x) * exp x = 1) by (rewrite <- exp_plus, Rplus_opp_l; apply exp_0).
  pose proof (exp_ineq1_le x). pose proof (exp_ineq1_le (- x)). rewrite E. repeat split; nra.
Qed.
Lemma b_positive : 0 <= b /\ b <= t / r.
Proof.
  pose proof w_at_most_1. assert (0 <= t / r) by (apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat; lra]).
  replace b with (w z * (t / r)) by (unfold b; field; lra). split; [apply Rmult_le_pos; lra|]. nra.
Qed.
Lemma sine_below : Rabs (sin b) <= b.
Proof.
  destruct b_positive as [[P| <-] _]; [|rewrite sin_0, Rabs_R0; lra].
  pose proof (sin_lt_x b P). pose proof (sin_above b P). apply Rabs_le. lra.
Qed.
Lemma q_below : r * q r z t <= a * t.
Proof.
  destruct decay_below as [A _]. pose proof sine_below as S. apply Rabs_le_between in S.
  replace (r * q r z t) with (r / w z * a * sin b) by (unfold q; fold a b; field; lra).
  replace (a * t) with (r / w z * a * b) by (unfold b; field; lra).
  apply Rmult_le_compat_l; [|lra]. apply Rmult_le_pos; [apply Rlt_le, Rdiv_lt_0_compat; lra | lra].
Qed.
Lemma rate_form : r * q_prime r z t = a * (cos b - z / w z * sin b).
Proof. unfold q_prime. fold a b. field. lra. Qed.
Lemma rate_near_cosine : Rabs (r * q_prime r z t - cos t) <= 4 * (t / r).
Proof.
  rewrite rate_form. destruct decay_below as [A0 [_ [A1 A2]]]. destruct b_positive as [B0 B1]. pose proof sine_below as S.
  assert (Cb : 1 - cos b <= b) by (pose proof (cos_above b B0); pose proof (COS_bound b); nra).
  assert (Ct : 1 - cos t <= t) by (pose proof (cos_above t Ht); pose proof (COS_bound t); nra).
  assert (Tr : 0 <= t / r) by lra. assert (T1 : t <= t / r).
  { replace t with (t / r * r) at 1 by (field; lra). nra. }
  assert (Zt : z * t / r <= t / r) by (unfold Rdiv in *; nra).
  assert (Zb : Rabs (z / w z * sin b) <= t / r).
  { rewrite Rabs_mult, (Rabs_right (z / w z)) by (apply Rle_ge, Rlt_le, Rdiv_lt_0_compat; lra).
    apply Rle_trans with (z / w z * b); [apply Rmult_le_compat_l; [apply Rlt_le, Rdiv_lt_0_compat; lra | exact S]|].
    replace (z / w z * b) with (z * t / r) by (unfold b; field; lra). exact Zt. }
  pose proof (COS_bound b). pose proof (COS_bound t). apply Rabs_le_between in Zb. set (k := z / w z * sin b) in *.
  assert (K1 : - (t / r) <= a * k <= t / r) by nra. assert (K2 : a - b <= a * cos b <= 1) by nra. apply Rabs_le. lra.
Qed.
Lemma rate_below : 1 <= t -> Rabs (r * q_prime r z t) <= r / z * (1 + z / w z).
Proof.
  intros T1. rewrite rate_form. destruct decay_below as [A0 [A1 _]]. assert (Zw : 0 < z / w z) by (apply Rdiv_lt_0_compat; lra).
  assert (Az : a <= r / z).
  { apply (Rmult_le_reg_r (z / r)); [apply Rdiv_lt_0_compat; lra|]. replace (r / z * (z / r)) with 1 by (field; lra).
    replace (z * t / r) with (z / r * t) in A1 by (field; lra). assert (0 < z / r) by (apply Rdiv_lt_0_compat; lra). nra. }
  assert (F : Rabs (cos b - z / w z * sin b) <= 1 + z / w z) by (pose proof (COS_bound b); pose proof (SIN_bound b); apply
    Rabs_le; nra).
  rewrite Rabs_mult, (Rabs_right a) by lra. apply Rmult_le_compat; [lra | apply Rabs_pos | exact Az | exact F].
Qed.
Lemma q_bounded : Rabs (q r z t) <= / w z.
Proof.
  destruct decay_below as [A0 [_ [A1 _]]]. unfold q. fold a b. assert (W : 0 < / w z) by (apply Rinv_0_lt_compat, Hw).
  rewrite Rmult_assoc, Rabs_mult, (Rabs_right (/ w z)) by lra. rewrite <- (Rmult_1_r (/ w z)) at 2. apply Rmult_le_compat_l;
    [lra|].
  pose proof (SIN_bound b). apply Rabs_le. nra.
Qed.
End Time.

Lemma sine_above_half t : 0 < t <= PI / 2 -> t / 2 <= sin t /\ t * (1 - t ^ 2 / 6) <= sin t /\ t < 16 / 10.
Proof.
  intros Ht. pose proof sixteen_tenths. pose proof (sin_above_cubic t ltac:(lra)). split; [|split; [|lra]]; nra.
Qed.

(* At small ratios (57) is nowhere much larger than at the start. *)
Lemma low_demand kappa : 0 < kappa -> exists d, 0 < d /\ forall r t, 0 < r < d -> 0 < t < PI ->
  demand_of_mode r z t / sin t <= 1 + g r z + 2 * z * r * u r z + kappa.
Proof.
  intros Hk. destruct bounds_positive as [B0 B1]. set (Bu := 2 * / w z / z ^ 2) in *. set (Bg := 2 * (2 + z / w z) / z ^ 2) in *.
  assert (Zw : 0 < z / w z) by (apply Rdiv_lt_0_compat; lra). assert (W : 0 < / w z) by (apply Rinv_0_lt_compat, Hw).
  assert (Iz : 0 < / z) by (apply Rinv_0_lt_compat; lra).
  set (X := 3 * (/ z * (1 + z / w z))). assert (X0 : 0 < X) by (unfold X; nra).
  set (Y := 2 * z * (/ z * (1 + z / w z)) + / w z + 1). assert (Y0 : 0 < Y) by (unfold Y; assert (0 < / z * (1 + z / w z)) by
    nra; nra).
  set (A := 2 * (X + Bu * Y) + 10 * Bu + Bg + 1). assert (A0 : 1 <= A) by (unfold A; assert (0 <= Bu * Y) by nra; lra).
  set (d := Rmin z (Rmin (/ A) (kappa / A))). exists d.
  assert (Hd : 0 < d) by (unfold d; repeat apply Rmin_glb_lt; [lra | apply Rinv_0_lt_compat; lra | apply Rdiv_lt_0_compat; lra]).
  split; [exact Hd|]. intros r t Hr Ht.
  pose proof (Rmin_l z (Rmin (/ A) (kappa / A))) as M1. pose proof (Rmin_r z (Rmin (/ A) (kappa / A))) as M2.
  pose proof (Rmin_l (/ A) (kappa / A)). pose proof (Rmin_r (/ A) (kappa / A)). fold d in M1, M2.
  assert (Rz : r < z) by lra. assert (R1 : 0 < r < 1) by lra.
  assert (RA : r * A <= 1) by (apply Rle_trans with (/ A * A); [apply Rmult_le_compat_r; lra | right; field; lra]).
  assert (RK : r * A <= kappa) by (apply Rle_trans with (kappa / A * A); [apply Rmult_le_compat_r; lra | right; field; lra]).
  pose proof (u_bound r R1) as Ub. pose proof (g_bound r R1) as Gb. fold Bu in Ub. fold Bg in Gb. set (e := r * u r z) in *.
  assert (Sq : r ^ 2 <= r) by nra. assert (E1 : Rabs e <= Bu * r) by (apply Rle_trans with (1 := Ub), Rmult_le_compat_l; lra).
  assert (G1 : Rabs (g r z - 1) <= 1).
  { apply Rle_trans with (1 := Gb). apply Rle_trans with (Bg * r); [apply Rmult_le_compat_l; lra|]. unfold A in RA.
    assert (0 <= r * (Bu * Y)) by (apply Rmult_le_pos; [lra | nra]). assert (0 <= r * Bu) by nra. nra. }
  apply Rabs_le_between in G1. pose proof (Rabs_pos e) as Ep.
  assert (EK : 10 * Rabs e + 2 * (r * X + Rabs e * Y) <= kappa).
  { apply Rle_trans with (2 := RK). unfold A. assert (Rabs e * Y <= Bu * r * Y) by (apply Rmult_le_compat_r; lra).
    assert (0 <= r * Bg) by nra. nra. }
  pose proof (Rle_abs e) as Ea. pose proof (Rle_abs (- e)) as Eb. rewrite Rabs_Ropp in Eb.
  assert (Start : 0 < 1 + g r z + 2 * z * e).
  { replace (2 * z * e) with (2 * z * r * u r z) by (unfold e; ring). apply mode_demand_positive, low_admissible, R1. }
  replace (2 * z * r * u r z) with (2 * z * e) by (unfold e; ring).
  pose proof (sin_gt_0 t ltac:(lra) ltac:(lra)) as St. apply (Rmult_le_reg_r (sin t)); [exact St|].
  replace (demand_of_mode r z t / sin t * sin t) with (demand_of_mode r z t) by (field; lra).
  assert (P0 : 0 <= r * X) by nra. assert (P1 : 0 <= Rabs e * Y) by nra.
  destruct (Rle_dec t (PI / 2)) as [Le|Gt].
  - destruct (sine_above_half t ltac:(lra)) as [S1 [S2 S3]]. destruct (decay_below r t R1 ltac:(lra)) as [D0 [D1 [D2 D3]]].
    pose proof (q_below r t R1 ltac:(lra)) as Q. pose proof (rate_near_cosine r t R1 ltac:(lra)) as P.
    set (a := exp (- z * t / r)) in *.
    assert (Ta : a * t <= sin t).
    { assert (Zr : t <= z * t / r) by (apply (Rmult_le_reg_r r); [lra|]; replace (z * t / r * r) with (z * t) by (field; lra);
      nra).
      assert (F : 0 < 1 - t ^ 2 / 6) by nra.
      assert (F1 : 1 <= (1 - t ^ 2 / 6) * (1 + z * t / r)).
      { apply Rle_trans with ((1 - t ^ 2 / 6) * (1 + t)); [|apply Rmult_le_compat_l; lra].
        assert (0 <= t * (1 - t / 6 - t ^ 2 / 6)) by (apply Rmult_le_pos; nra). nra. }
      assert (a <= 1 - t ^ 2 / 6) by nra. nra. }
    unfold demand_of_mode. replace ((1 + g r z) * r * q r z t) with ((1 + g r z) * (r * q r z t)) by ring.
    replace (u r z * r ^ 2 * (r * q_prime r z t - cos t)) with (e * (r * (r * q_prime r z t - cos t))) by (unfold e; ring).
    assert (T1 : (1 + g r z) * (r * q r z t) <= (1 + g r z) * sin t) by (apply Rmult_le_compat_l; lra).
    assert (T2 : Rabs (e * (r * (r * q_prime r z t - cos t))) <= Rabs e * (4 * t)).
    { rewrite !Rabs_mult, (Rabs_right r) by lra. apply Rmult_le_compat_l; [exact Ep|].
      apply Rle_trans with (r * (4 * (t / r))); [apply Rmult_le_compat_l; lra | right; field; lra]. }
    assert (T3 : Rabs e * (4 * t) <= Rabs e * (8 * sin t)) by (apply Rmult_le_compat_l; lra).
    assert (T4 : - (2 * Rabs e) <= 2 * z * e) by nra.
    apply Rabs_le_between in T2. assert (T5 : (8 * Rabs e) * sin t <= (2 * z * e + kappa) * sin t) by (apply Rmult_le_compat_r;
      lra). lra.
  - assert (Dp : demand_of_mode r z PI = 0) by (apply (demand_ends r z), low_admissible, R1).
    assert (Bd : Rabs (demand_of_mode r z PI - demand_of_mode r z t) <= (r * X + Rabs e * Y) * (PI - t)).
    { apply (bounded_slope nil); [lra | |].
      - intros x _. eapply continuous_of_derive, demand_rate; lra.
      - intros x Hx _. eexists. split; [apply demand_rate; lra|]. pose proof PI2_1.
        pose proof (rate_below r x R1 ltac:(lra) ltac:(lra)) as Rb. pose proof (q_bounded r x R1 ltac:(lra)) as Qb.
        unfold braces_second. set (p := r * q_prime r z x) in *.
        replace (r ^ 2 * ((1 + g r z) * q_prime r z x / r - u r z * r * q_second r z x) - u r z * r ^ 2 * sin x)
          with ((1 + g r z) * p + e * (2 * z * p + q r z x - r * sin x)) by (unfold p, e, q_second; field; lra).
        assert (Rp : r / z * (1 + z / w z) = r * (/ z * (1 + z / w z))) by (unfold Rdiv; ring). rewrite Rp in Rb.
        set (k := / z * (1 + z / w z)) in *. assert (K0 : 0 < k) by (unfold k; nra).
        assert (Pk : Rabs p <= k) by nra. apply Rle_trans with (1 := Rabs_triang _ _). rewrite !Rabs_mult.
        apply Rplus_le_compat.
        + rewrite (Rabs_right (1 + g r z)) by lra. unfold X. fold k. pose proof (Rabs_pos p). nra.
        + apply Rmult_le_compat_l; [exact Ep|]. unfold Y. fold k. pose proof (SIN_bound x).
          apply Rabs_le_between in Pk, Qb. assert (0 < z * k) by nra. apply Rabs_le. nra. }
    rewrite Dp, Rminus_0_l, Rabs_Ropp in Bd.
    assert (Sp : (PI - t) / 2 <= sin t) by (rewrite <- (sin_PI_x t); apply sine_above_half; lra).
    pose proof (Rle_abs (demand_of_mode r z t)).
    assert ((r * X + Rabs e * Y) * (PI - t) <= (r * X + Rabs e * Y) * (2 * sin t)) by (apply Rmult_le_compat_l; lra).
    assert (kappa * sin t <= (1 + g r z + 2 * z * e + kappa) * sin t) by (apply Rmult_le_compat_r; lra).
    assert (2 * (r * X + Rabs e * Y) * sin t <= kappa * sin t) by (apply Rmult_le_compat_r; lra). lra.
Qed.
End Mode.

Theorem eq_67_low_frequency : Statements.eq_67_low_frequency.
Proof.
  intros s mu y Hs Al Hm Hz Hy. set (N := masses s) in *. set (j := contact s) in *. set (l := loaded s) in *. pose proof
    (mobility_pos s
    Hs) as Mp. pose proof (mobility_alone s Hs Al) as Mo. fold j in Mo.
  pose proof (fun i Hi => Hratio s Hs i Hi) as Rp. fold N in Rp.
  assert (Z : forall i, (i < N)%nat -> 0 < damping_ratio s i < 1) by (intros i Hi; destruct (Hadm s Hs i Hi) as [_ [Q _]]; pose
    proof (Hz
    i Hi); lra).
  set (D := Sum N (fun i => shape s j i * shape s l i * ratio s i ^ 2)).
  assert (Yj : y j = D).
  { rewrite (physical s Hs y j (Hj s Hs)). apply Sum_ext. intros i Hi.
    pose proof (modal_rows s Hs (fun _ => 0) (fun _ => 0) y (fun a => delta a l)) as E. specialize (E ltac:(intros a Ha;
      transitivity
      (Sum N (fun b => stiffness s a b * y b)); [apply Sum_ext; intros; ring | apply Hy, Ha]) i Hi). cbv beta in E.
    assert (M0 : modal s (fun _ => 0) i = 0) by (apply Sum_zero; intros; ring). rewrite M0 in E.
    rewrite (Sum_ext (masses s) (fun a => shape s a i * delta a l) (fun a => delta a l * shape s a i)) in E by (intros; ring).
    rewrite (Sum_delta (masses s) l (fun a => shape s a i) (Hl s Hs)) in E. specialize (Rp i Hi).
    replace (modal s y i) with (ratio s i ^ 2 * shape s l i); [ring|]. rewrite <- E. field. lra. }
  assert (TA : tends (fun r => Sum N (fun i => shape s j i * shape s l i * ratio s i ^ 2 * v_re (r * ratio s i) (damping_ratio s
    i))) D).
  { apply (tends_sum N (fun i r => _) (fun i => shape s j i * shape s l i * ratio s i ^ 2 * 1)); [apply Sum_ext; intros; ring|].
    intros i Hi. apply tends_mult; [apply tends_const|].
    apply (tends_scaled (fun r => v_re r (damping_ratio s i))); [apply Rp, Hi | apply v_at_zero]. }
  assert (TB : tends (fun r => Sum N (fun i => shape s j i * shape s l i * ratio s i ^ 2 * v_im (r * ratio s i) (damping_ratio s
    i))) 0).
  { apply (tends_sum N (fun i r => _) (fun i => shape s j i * shape s l i * ratio s i ^ 2 * 0)); [apply Sum_zero; intros;
    ring|]. intros i Hi. apply tends_mult; [apply tends_const|].
    apply (tends_scaled (fun r => v_im r (damping_ratio s i))); [apply Rp, Hi | apply v_at_zero]. }
  assert (TR : tends (fun r => r) 0) by (apply from_the_right, is_lim_id).
  assert (TC : tends (fun r => Sum N (fun i => shape s j i ^ 2 * (r * ratio s i * (r * ratio s i * u (r * ratio s i)
    (damping_ratio s
    i))))) 0).
  { apply (tends_sum N (fun i r => _) (fun i => shape s j i ^ 2 * (0 * 0))); [apply Sum_zero; intros; ring|]. intros i Hi. apply
    tends_mult; [apply tends_const|]. apply tends_mult.
    - apply (tends_scaled (fun r => r)); [apply Rp, Hi | exact TR].
    - apply (tends_scaled (fun r => r * u r (damping_ratio s i))); [apply Rp, Hi | apply u_at_zero, Z, Hi]. }
  assert (TH : tends (fun r => Sum N (fun i => shape s j i ^ 2 * (g (r * ratio s i) (damping_ratio s i) + 2 * damping_ratio s i
    * (r *
    ratio s i * u (r * ratio s i) (damping_ratio s i))))) (mobility s)).
  { apply (tends_sum N (fun i r => _) (fun i => shape s j i ^ 2 * (1 + 2 * damping_ratio s i * 0))); [apply Sum_ext; intros;
    unfold j;
      ring|]. intros i Hi. apply tends_mult; [apply tends_const|]. apply tends_plus.
    - apply (tends_scaled (fun r => g r (damping_ratio s i))); [apply Rp, Hi | apply g_at_zero, Z, Hi].
    - apply tends_mult; [apply tends_const|]. apply (tends_scaled (fun r => r * u r (damping_ratio s i))); [apply Rp, Hi | apply
        u_at_zero, Z, Hi]. }
  set (fA := fun r => Sum N (fun i => shape s j i * shape s l i * ratio s i ^ 2 * v_re (r * ratio s i) (damping_ratio s i))) in *.
  set (fB := fun r => Sum N (fun i => shape s j i * shape s l i * ratio s i ^ 2 * v_im (r * ratio s i) (damping_ratio s i))) in *.
  set (fC := fun r => Sum N (fun i => shape s j i ^ 2 * (r * ratio s i * (r * ratio s i * u (r * ratio s i) (damping_ratio s
    i))))) in *.
  set (fH := fun r => Sum N (fun i => shape s j i ^ 2 * (g (r * ratio s i) (damping_ratio s i) + 2 * damping_ratio s i * (r *
    ratio s i * u (r * ratio s i) (damping_ratio s i))))) in *.
  set (den := fun r => fC r * fC r + (fH r + mu * mobility s) * (fH r + mu * mobility s)).
  assert (TD : tends den (0 * 0 + (mobility s + mu * mobility s) * (mobility s + mu * mobility s))).
  { apply tends_plus; [apply tends_mult; exact TC|]. apply tends_mult; apply tends_plus; try exact TH; apply tends_const. }
  assert (Pm : 0 < mobility s + mu * mobility s) by nra.
  set (d0 := 0 * 0 + (mobility s + mu * mobility s) * (mobility s + mu * mobility s)) in *.
  assert (Pd : 0 < d0) by (unfold d0; nra).
  assert (TQ : tends (fun r => sqrt ((fA r * fA r + fB r * fB r) * / den r)) (sqrt ((D * D + 0 * 0) * / d0))).
  { apply (tends_through (fun r => (fA r * fA r + fB r * fB r) * / den r) sqrt); [|apply continuous_sqrt].
    apply tends_mult; [apply tends_plus; apply tends_mult; assumption|].
    apply (tends_through den Rinv); [exact TD | apply continuous_Rinv; lra]. }
  replace (Rabs (y j) * mass s j j / (1 + mu)) with (sqrt ((D * D + 0 * 0) * / d0)).
  2: { rewrite Yj. replace (mass s j j) with (/ mobility s) by (apply (Rmult_eq_reg_r (mobility s)); [rewrite Mo; field; lra |
    lra]).
    replace ((D * D + 0 * 0) * / d0) with (Rsqr (D / (mobility s + mu * mobility s))) by (unfold d0, Rsqr; field; nra).
    rewrite sqrt_Rsqr_abs. unfold Rdiv. rewrite Rabs_mult, (Rabs_right (/ (mobility s + mu * mobility s))) by (apply Rle_ge,
      Rlt_le,
      Rinv_0_lt_compat, Pm). field. lra. }
  apply (tends_ext (fun r => sqrt ((fA r * fA r + fB r * fB r) * / den r))); [|exact TQ]. intros r Hr.
  cbv beta zeta. set (s' := at_frequency s r).
  assert (R2 : 0 < r ^ 2) by (apply pow_lt, Hr).
  assert (EA : V_re s' j = fA r).
  { unfold V_re, fA. apply Sum_ext. intros i _. cbn [s' shape ratio damping_ratio loaded at_frequency]. fold l. field. lra. }
  assert (EB : V_im s' j = fB r).
  { unfold V_im, fB. apply Sum_ext. intros i _. cbn [s' shape ratio damping_ratio loaded at_frequency]. fold l. field. lra. }
  assert (EC : U s' j = / r ^ 2 * fC r).
  { unfold U, fC. rewrite <- Sum_scal. apply Sum_ext. intros i _. cbn [s' shape ratio damping_ratio contact at_frequency]. fold j.
    field. lra. }
  assert (EH : H_j s' = / r ^ 2 * fH r).
  { unfold H_j, fH. rewrite <- Sum_scal. apply Sum_ext. intros i _. cbn [s' shape ratio damping_ratio contact at_frequency].
    fold j.
    field. lra. }
  change (contact s') with j. rewrite V_abs_sq, EA, EB, EC, EH. unfold s' at 1. rewrite mobility_at by exact Hr.
  assert (Q : 0 <= (fA r * fA r + fB r * fB r) * / den r).
  { unfold den. set (p := fC r). set (q := fH r + mu * mobility s). assert (0 <= p * p + q * q) by nra.
    destruct (Req_dec (p * p + q * q) 0) as [->|N0]; [rewrite Rinv_0; lra|]. apply Rmult_le_pos; [nra | apply Rlt_le,
      Rinv_0_lt_compat; lra]. }
  replace ((fA r ^ 2 + fB r ^ 2) / ((/ r ^ 2 * fC r) ^ 2 + (/ r ^ 2 * fH r + mu * (mobility s / r ^ 2)) ^ 2))
    with (r ^ 2 * r ^ 2 * ((fA r * fA r + fB r * fB r) * / den r)).
  - rewrite (sqrt_mult (r ^ 2 * r ^ 2) ((fA r * fA r + fB r * fB r) * / den r)) by (exact Q || (apply Rmult_le_pos; lra)).
    rewrite sqrt_square by lra. field. lra.
  - unfold den. replace ((/ r ^ 2 * fC r) ^ 2 + (/ r ^ 2 * fH r + mu * (mobility s / r ^ 2)) ^ 2) with (/ (r ^ 2 * r ^ 2) * (fC
    r * fC r +
      (fH r + mu * mobility s) * (fH r + mu * mobility s))) by (field; lra).
    unfold Rdiv. rewrite Rinv_mult, Rinv_inv. ring.
Qed.

(* The limit (69) lies between (67) and (67) with a slightly larger mu. *)
Lemma from_some_below n (P : nat -> R -> Prop) : (forall i, (i < n)%nat -> exists d, 0 < d /\ forall r, 0 < r < d -> P i r) ->
  exists d, 0 < d /\ forall i r, (i < n)%nat -> 0 < r < d -> P i r.
Proof.
  induction n; intros H; [exists 1; split; [lra | intros; lia]|]. destruct IHn as [d0 [P0 H0]]; [intros; apply H; lia|].
  destruct (H n ltac:(lia)) as [d1 [P1 H1]]. exists (Rmin d0 d1). split; [apply Rmin_glb_lt; assumption|]. intros i r Hi Hr.
  pose proof (Rmin_l d0 d1). pose proof (Rmin_r d0 d1). destruct (Nat.eq_dec i n) as [->|]; [apply H1; lra | apply H0; [lia |
    lra]].
Qed.

Lemma tends_near (f : R -> R) c e : tends f c -> 0 < e -> exists d, 0 < d /\ forall r, 0 < r < d -> Rabs (f r - c) < e.
Proof.
  intros F He. destruct (F (fun v => Rabs (v - c) < e)) as [d Hd]; [exists (mkposreal e He); intros v Hv; exact Hv|].
  exists d. split; [apply cond_pos|]. intros r Hr. apply Hd; [|lra]. change (Rabs (r - 0) < d). rewrite Rminus_0_r, Rabs_right;
    lra.
Qed.

Lemma decreasing_limit V U0 D D' : 0 < D -> D <= D' -> sqrt (V ^ 2 / (U0 ^ 2 + D' ^ 2)) <= sqrt (V ^ 2 / (U0 ^ 2 + D ^ 2)).
Proof.
  intros HD Le. apply sqrt_le_1_alt. apply Rmult_le_compat_l; [apply pow2_ge_0|]. apply Rinv_le_contravar; nra.
Qed.

Theorem eq_69_low_frequency : Statements.eq_69_low_frequency.
Proof.
  intros s mu L y Hs Al Hm Hz Hy HL. pose proof (mobility_pos s Hs) as Mp. pose proof (fun i Hi => Hratio s Hs i Hi) as Rp.
  assert (Z : forall i, (i < masses s)%nat -> 0 < damping_ratio s i < 1) by (intros i Hi; destruct (Hadm s Hs i Hi) as [_ [Q
    _]]; pose
    proof (Hz i Hi); lra).
  assert (Low : exists d, 0 < d /\ forall r, 0 < r < d -> is_scene (at_frequency s r)).
  { destruct (from_some_below (masses s) (fun i r => r * ratio s i < 1)) as [d [Hd H]].
    - intros i Hi. pose proof (Rp i Hi). exists (/ ratio s i). split; [apply Rinv_0_lt_compat; assumption|]. intros r Hr.
      apply Rlt_le_trans with (/ ratio s i * ratio s i); [apply Rmult_lt_compat_r; lra | right; field; lra].
    - exists d. split; [exact Hd|]. intros r Hr. apply at_frequency_is_a_scene; [exact Hs | lra|]. intros i Hi.
      apply (low_admissible _ (Z i Hi)). split; [apply Rmult_lt_0_compat; [lra | apply Rp, Hi] | apply H; assumption]. }
  split; [exact Low|]. destruct Low as [d0 [P0 Sc]].
  set (c := Rabs (y (contact s)) * mass s (contact s) (contact s)). assert (C0 : 0 <= c).
  { apply Rmult_le_pos; [apply Rabs_pos|]. pose proof (mobility_alone s Hs Al). nra. }
  intros P [e He]. pose proof (cond_pos e) as Ep.
  (* a mu' whose limit is near *)
  set (kappa := Rmin 1 (e / (2 * (c + 1)))). assert (Hk : 0 < kappa) by (apply Rmin_glb_lt; [lra | apply Rdiv_lt_0_compat; lra]).
  assert (Kc : c / (1 + mu) - e / 2 <= c / (1 + (mu + kappa))).
  { assert (K : kappa * (2 * (c + 1)) <= e).
    { apply Rle_trans with (e / (2 * (c + 1)) * (2 * (c + 1))); [apply Rmult_le_compat_r; [lra | apply Rmin_r] | right; field;
      lra]. }
    assert (c / (1 + mu) - c / (1 + (mu + kappa)) = c * kappa / ((1 + mu) * (1 + (mu + kappa)))) by (field; lra).
    assert (0 <= c * kappa) by nra. assert (c * kappa / ((1 + mu) * (1 + (mu + kappa))) <= c * kappa).
    { rewrite <- (Rmult_1_r (c * kappa)) at 2. apply Rmult_le_compat_l; [assumption|]. rewrite <- Rinv_1. apply
      Rinv_le_contravar; nra. }
    nra. }
  pose proof (eq_67_low_frequency s mu y Hs Al Hm Hz Hy) as F1.
  pose proof (eq_67_low_frequency s (mu + kappa) y Hs Al ltac:(lra) Hz Hy) as F2. fold c in F1, F2.
  destruct (tends_near _ _ (e / 2) F1 ltac:(lra)) as [d1 [P1 N1]]. destruct (tends_near _ _ (e / 2) F2 ltac:(lra)) as [d2 [P2
    N2]].
  destruct (from_some_below (masses s) (fun i r => forall t, 0 < t < PI -> demand_of_mode (r * ratio s i) (damping_ratio s i) t
    / sin t
    <= 1 + g (r * ratio s i) (damping_ratio s i) + 2 * damping_ratio s i * (r * ratio s i) * u (r * ratio s i) (damping_ratio s
      i) +
    kappa)) as [d3 [P3 N3]].
  { intros i Hi. destruct (low_demand _ (Z i Hi) kappa Hk) as [d [Hd H]]. pose proof (Rp i Hi).
    exists (d / ratio s i). split; [apply Rdiv_lt_0_compat; assumption|]. intros r Hr t Ht. apply H; [|exact Ht].
    split; [apply Rmult_lt_0_compat; lra|]. apply Rlt_le_trans with (d / ratio s i * ratio s i); [apply Rmult_lt_compat_r; lra |
      right;
      field; lra]. }
  set (d := Rmin (Rmin d0 d1) (Rmin d2 d3)). assert (Hd : 0 < d) by (unfold d; repeat apply Rmin_glb_lt; assumption).
  exists (mkposreal d Hd). intros r Br Pr. change (Rabs (r - 0) < d) in Br. rewrite Rminus_0_r, Rabs_right in Br by lra.
  pose proof (Rmin_l (Rmin d0 d1) (Rmin d2 d3)) as M1. pose proof (Rmin_r (Rmin d0 d1) (Rmin d2 d3)) as M2. pose proof (Rmin_l d0 d1).
  pose proof (Rmin_r d0 d1). pose proof (Rmin_l d2 d3). pose proof (Rmin_r d2 d3). fold d in M1, M2.
  specialize (N1 r ltac:(lra)). specialize (N2 r ltac:(lra)). specialize (Sc r ltac:(lra)). cbv zeta in N1, N2.
  set (s' := at_frequency s r) in *. destruct (demand_has_a_supremum s' Sc) as [S HS].
  pose proof (mobility_pos s' Sc) as Mp'. pose proof (static_demand_pos s' mu Sc Hm) as SP.
  assert (Sb : S <= H_j s' + (1 + kappa) * mobility s').
  { apply (proj2 HS). intros v [t [Ht ->]]. unfold demand, H_j, mobility, Rdiv. rewrite <- Sum_scal_r, <- Sum_scal, <- Sum_plus.
    apply Sum_le. intros i Hi. pose proof (N3 i r Hi ltac:(lra) t Ht) as B. unfold Rdiv in B.
    cbn [s' shape ratio damping_ratio contact at_frequency]. pose proof (pow2_ge_0 (shape s (contact s) i / r)).
    set (k := (shape s (contact s) i / r) ^ 2) in *. rewrite Rmult_assoc.
    apply Rle_trans with (k * (1 + g (r * ratio s i) (damping_ratio s i) + 2 * damping_ratio s i * (r * ratio s i) * u (r *
      ratio s i)
      (damping_ratio s i) + kappa)); [apply Rmult_le_compat_l; [assumption | exact B] | right; ring]. }
  assert (Up : Rmax S (H_j s' + mu * mobility s') <= H_j s' + (mu + kappa) * mobility s') by (apply Rmax_lub; nra).
  pose proof (Rmax_r S (H_j s' + mu * mobility s')) as Dn.
  pose proof (HL r S Pr Sc HS) as EL. fold s' in EL. unfold limit_69 in EL.
  pose proof (decreasing_limit (V_abs s' (contact s')) (U s' (contact s')) _ _ SP Dn) as A1.
  pose proof (decreasing_limit (V_abs s' (contact s')) (U s' (contact s')) _ _ (Rlt_le_trans _ _ _ SP Dn) Up) as A2. rewrite <- EL in A1, A2.
  assert (R2 : 0 < / r ^ 2) by (apply Rinv_0_lt_compat, pow_lt, Pr).
  apply (Rmult_le_compat_r (/ r ^ 2)) in A1; [|lra]. apply (Rmult_le_compat_r (/ r ^ 2)) in A2; [|lra].
  change (contact s) with (contact s') in N1, N2. unfold Rdiv at 1 in N1. unfold Rdiv at 1 in N2.
  apply He. change (Rabs (L r / r ^ 2 - c / (1 + mu)) < e). unfold Rdiv at 1. apply Rabs_lt_between in N1, N2. apply
    Rabs_lt_between.
  fold s' in N1, N2. split; lra.
Qed.
