(* Section 4.3: invariant points, (87), and a contact that is held for ever, (88). *)
Require Import Reals Lra Lia Psatz PeanoNat List.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes SteadyMode Sums Masses Contact OneVelocity ContactMotion Misprints.
Open Scope R_scope.

Theorem eq_87 : Statements.eq_87.
Proof.
  intros s k Sc Z R. pose proof (V_abs_sq s k) as Qk. pose proof (V_abs_sq s (contact s)) as Qj.
  assert (I : forall a, V_im s a = 0).
  { intros a. apply Sum_zero. intros i Hi. rewrite Z by exact Hi. unfold v_im, Rdiv. ring. }
  assert (Gk : G s k = 0) by (apply Sum_zero; intros i Hi; rewrite Z, g_0 by exact Hi; ring).
  pose proof R as [Vj _]. rewrite I in Qk, Qj. assert (Vr : V_re s (contact s) <> 0) by (intros E; rewrite E in Qj; nra).
  assert (E : X_k s k ^ 2 = V_re s k ^ 2 + friction s ^ 2 * (U s k ^ 2 - 2 * (V_re s k / V_re s (contact s)) * (U s (contact s)
    * U s k))).
  { destruct (eq_52_53 s R k) as [X _]. rewrite X, <- Rsqr_pow2, Rsqr_sqrt by (apply Rplus_le_le_0_compat; apply pow2_ge_0).
    rewrite X_kC_kS by exact R. rewrite Gk, Qk.
    destruct (argument_all s k) as [C1 S1]. destruct (argument_all s (contact s)) as [C2 S2]. rewrite I in S1, S2.
    assert (Vr2 : V_re s (contact s) ^ 2 = V_abs s (contact s) ^ 2) by lra.
    set (A := V_abs s (contact s)) in *. set (B := V_abs s k) in *. set (x := V_arg s k) in *. set (y := V_arg s (contact s))
      in *.
    assert (Pe : B / A * cos (x - y) = V_re s k / V_re s (contact s)).
    { rewrite cos_minus. transitivity ((B * cos x * (A * cos y) + B * sin x * (A * sin y)) / A ^ 2); [field; lra|].
      rewrite C1, C2, S1, S2, <- Vr2. field. exact Vr. }
    assert (Qe : B / A * sin (x - y) = 0).
    { rewrite sin_minus. transitivity ((B * sin x * (A * cos y) - B * cos x * (A * sin y)) / A ^ 2); [field; lra|].
      rewrite C1, C2, S1, S2. unfold Rdiv. ring. }
    rewrite <- Pe. set (b := friction s) in *.
    transitivity (V_re s k ^ 2 + 0 ^ 2 + b ^ 2 * U s k ^ 2 + 2 * b * root s * U s k * (B / A * sin (x - y))
      - 2 * b ^ 2 * U s (contact s) * U s k * (B / A * cos (x - y))); [ring|]. rewrite Qe. ring. }
  split; [exact E|]. intros Hb Hu. set (F := 1 - 2 * (V_re s k / V_re s (contact s)) * (U s (contact s) / U s k)).
  assert (EF : X_k s k ^ 2 = V_abs s k ^ 2 + (friction s * U s k) ^ 2 * F) by (rewrite E, Qk; unfold F; field; split; assumption).
  assert (P : 0 < (friction s * U s k) ^ 2) by (apply pow2_gt_0, Rmult_integral_contrapositive; split; lra).
  split; intros H.
  - rewrite H in EF. apply (Rmult_eq_reg_l ((friction s * U s k) ^ 2)); lra.
  - rewrite H in EF. apply Rsqr_inj; [apply sqrt_pos | apply sqrt_pos | rewrite !Rsqr_pow2; lra].
Qed.

(* ---- A held contact ---- *)
Section Held.
Variables (s : scene) (X_re X_im : nat -> R).
Local Notation N := (masses s).
Local Notation M := (mass s).
Local Notation C := (damping s).
Local Notation K := (stiffness s).
Local Notation j := (contact s).
Hypothesis H : held_motion s X_re X_im.
Let y k t := X_re k * cos t - X_im k * sin t.
Let y1 k t := - (X_re k * sin t + X_im k * cos t).
Let y2 k t := - (X_re k * cos t - X_im k * sin t).
Let A := Sum N (fun b => (K j b - M j b) * X_re b - C j b * X_im b) - delta j (loaded s).
Let B := Sum N (fun b => (K j b - M j b) * X_im b + C j b * X_re b).

Lemma held_rates k t : is_derive (y k) t (y1 k t) /\ is_derive (y1 k) t (y2 k t).
Proof. unfold y, y1, y2. split; auto_derive; trivial; ring. Qed.
Lemma held_row a t : Sum N (fun b => M a b * y2 b t + C a b * y1 b t + K a b * y b t) =
  Sum N (fun b => (K a b - M a b) * X_re b - C a b * X_im b) * cos t -
  Sum N (fun b => (K a b - M a b) * X_im b + C a b * X_re b) * sin t.
Proof.
  rewrite <- !Sum_scal_r, <- Sum_minus. apply Sum_ext. intros b _. unfold y, y1, y2. ring.
Qed.
Lemma amplitude t : Rabs (A * cos t - B * sin t) <= sqrt (A ^ 2 + B ^ 2).
Proof.
  rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold Rsqr. pose proof (sin2_cos2 t) as T. unfold Rsqr in T.
  assert (A ^ 2 + B ^ 2 = (A ^ 2 + B ^ 2) * (sin t * sin t + cos t * cos t)) by (rewrite T; ring).
  pose proof (pow2_ge_0 (A * sin t + B * cos t)). nra.
Qed.
Lemma amplitude_is_reached : exists t, 0 < t < 2 * PI /\ Rabs (A * cos t - B * sin t) = sqrt (A ^ 2 + B ^ 2).
Proof.
  pose proof PI_RGT_0 as P. set (L := sqrt (A ^ 2 + B ^ 2)).
  assert (L0 : 0 <= L) by apply sqrt_pos.
  assert (T : exists f, L * cos f = A /\ L * sin f = - B).
  { destruct (Req_dec A 0) as [Ea|Ea]; [destruct (Req_dec B 0) as [Eb|Eb]|].
    - exists 0. unfold L. rewrite Ea, Eb. replace (0 ^ 2 + 0 ^ 2) with 0 by ring. rewrite sqrt_0. split; ring.
    - exists (atan2 (- B) A). unfold L. replace (A ^ 2 + B ^ 2) with (A ^ 2 + (- B) ^ 2) by ring. apply atan2_is_the_angle.
      right. lra.
    - exists (atan2 (- B) A). unfold L. replace (A ^ 2 + B ^ 2) with (A ^ 2 + (- B) ^ 2) by ring. apply atan2_is_the_angle.
      left. exact Ea. }
  destruct T as [f [Ca Sb]].
  assert (V : forall t, sin (t - f) = 0 -> Rabs (A * cos t - B * sin t) = L).
  { intros t Z. replace (A * cos t - B * sin t) with (L * cos (t - f)) by (rewrite cos_minus, <- Ca; replace B with (- (L * sin
    f)) by lra; ring).
    pose proof (sin2_cos2 (t - f)) as Q. rewrite Z in Q. unfold Rsqr in Q.
    assert (Rabs (cos (t - f)) = 1).
    { assert (D : (cos (t - f) - 1) * (cos (t - f) + 1) = 0) by lra. apply Rmult_integral in D. unfold Rabs. destruct
      (Rcase_abs _); lra. }
    rewrite Rabs_mult, H0, (Rabs_right L); lra. }
  (* a time between 0 and 2 pi that differs from f by a multiple of pi *)
  destruct (archimed (- (f / PI))) as [U1 U2]. set (n := up (- (f / PI))) in *.
  exists (f + IZR n * PI). split.
  - assert (F : f = f / PI * PI) by (field; lra). split.
    + assert (0 < (f / PI + IZR n) * PI) by (apply Rmult_lt_0_compat; lra). lra.
    + assert ((f / PI + IZR n) * PI <= 1 * PI) by (apply Rmult_le_compat_r; lra). lra.
  - apply V. replace (f + IZR n * PI - f) with (IZR n * PI) by ring. apply sin_eq_0_1. exists n. reflexivity.
Qed.
Lemma rests_by_amplitude mu : (j < N)%nat -> 0 < mu -> 0 < friction s -> (rests s mu X_re X_im <-> held_load s X_re X_im / mu
  <= friction s).
Proof.
  intros Hj Hm Hb. set (L := held_load s X_re X_im). assert (EL : L = sqrt (A ^ 2 + B ^ 2)) by reflexivity.
  assert (Side : L / mu <= friction s <-> L <= mu * friction s).
  { split; intros Q; [replace L with (mu * (L / mu)) by (field; lra); apply Rmult_le_compat_l; lra|].
    apply (Rmult_le_reg_l mu); [exact Hm|]. replace (mu * (L / mu)) with L by (field; lra). exact Q. }
  rewrite Side. clear Side. destruct H as [Z1 [Z2 Rows]]. split.
  - intros [[_ [[exc E] _]] _]. rewrite EL. destruct amplitude_is_reached as [t0 [Ht0 T0]]. rewrite <- T0. apply Rnot_lt_le.
    intros G.
    assert (Cn : continuous (fun t => Rabs (A * cos t - B * sin t)) t0).
    { apply (continuous_comp (fun t => A * cos t - B * sin t) Rabs); [|apply continuous_Rabs].
      apply (ex_derive_continuous (K := R_AbsRing) (V := R_NormedModule)). auto_derive. trivial. }
    assert (Nb : locally (Rabs (A * cos t0 - B * sin t0)) (fun v => mu * friction s < v)) by (apply (open_gt (mu * friction
      s)); exact G).
    destruct (Cn _ Nb) as [e He].
    assert (Ee : 0 < Rmin e (2 * PI - t0)) by (apply Rmin_glb_lt; [apply cond_pos | lra]).
    destruct (time_left exc t0 (t0 + Rmin e (2 * PI - t0)) ltac:(lra)) as [t [Ht Nt]].
    pose proof (Rmin_l e (2 * PI - t0)). pose proof (Rmin_r e (2 * PI - t0)).
    destruct (E t ltac:(lra) Nt) as [y2' [sg [Co Eq]]]. destruct (Eq j Hj) as [_ [_ Row]].
    assert (Same : forall b, (b < N)%nat -> y2' b = y2 b t).
    { intros b Hbn. destruct (Eq b Hbn) as [_ [D2 _]]. destruct (held_rates b t) as [_ D2'].
      apply is_derive_unique in D2. apply is_derive_unique in D2'. rewrite <- D2, <- D2'. reflexivity. }
    assert (S : Sum N (fun b => M j b * y2' b + C j b * - (X_re b * sin t + X_im b * cos t) + K j b * (X_re b * cos t - X_im b
      * sin t))
      = Sum N (fun b => M j b * y2 b t + C j b * y1 b t + K j b * y b t)) by (apply Sum_ext; intros b Hbn; rewrite Same by
        exact Hbn; reflexivity).
    rewrite S, held_row, delta_same, Rplus_0_r in Row.
    assert (V0 : - (X_re j * sin t + X_im j * cos t) = 0) by (rewrite Z1, Z2; ring).
    destruct Co as [_ [_ Co]]. specialize (Co V0).
    assert (Ld : A * cos t - B * sin t = - (friction s * sg)) by (unfold A, B; lra).
    specialize (He t). cbv beta in He. rewrite Ld, Rabs_Ropp, Rabs_mult, (Rabs_right (friction s)) in He by lra.
    assert (Rabs sg <= mu) by (apply Rabs_le; lra).
    assert (friction s * Rabs sg <= friction s * mu) by (apply Rmult_le_compat_l; lra).
    assert (Bt : ball t0 e t) by (change (Rabs (t - t0) < e); rewrite Rabs_right; lra). specialize (He Bt). lra.
  - intros Q. assert (V0 : forall t, - (X_re j * sin t + X_im j * cos t) = 0) by (intros; rewrite Z1, Z2; ring).
    split; [split; [|split]|].
    + intros a t _ _. destruct (held_rates a t) as [D1 D2]. split; eapply continuous_of_derive; [exact D1 | exact D2].
    + exists nil. intros t Ht _. exists (fun b => y2 b t), (- (A * cos t - B * sin t) / friction s).
      pose proof (amplitude t) as Am. rewrite <- EL in Am. apply Rabs_le_between in Am. split.
      * specialize (V0 t). split; [intros; lra|]. split; [intros; lra|]. intros _.
        set (v := A * cos t - B * sin t) in *. assert (E : - v / friction s * friction s = - v) by (field; lra).
        split; apply (Rmult_le_reg_r (friction s)); lra.
      * intros a Ha. destruct (held_rates a t) as [D1 D2]. split; [exact D1|]. split; [exact D2|].
        change (Sum N (fun b => M a b * y2 b t + C a b * y1 b t + K a b * y b t) + friction s * delta a j * (- (A * cos t - B *
          sin t) / friction s)
          = delta a (loaded s) * cos (t + 0)).
        rewrite held_row, Rplus_0_r. destruct (Nat.eq_dec a j) as [->|Na].
        -- rewrite delta_same. unfold A, B. field. lra.
        -- destruct (Rows a Ha Na) as [-> ->]. rewrite (delta_other a j) by exact Na. field. lra.
    + intros t Ht _ _. exists (2 * PI). split; [lra | intros; apply V0].
    + intros a _. rewrite sin_2PI, cos_2PI, sin_0, cos_0. split; ring.
Qed.
End Held.

Theorem eq_88 : Statements.eq_88.
Proof. intros s mu X_re X_im Hj Hm Hb H. apply rests_by_amplitude; assumption. Qed.

Theorem eq_88_by_spring : Statements.eq_88_by_spring.
Proof.
  intros s X_re X_im p Al Hj Hp Np Nl [Z1 [Z2 _]] Hd Hk. unfold held_load. rewrite (delta_other (contact s)) by auto.
  rewrite (Sum_single _ p _ Hp), (Sum_single _ p _ Hp).
  - rewrite Al, Hd by assumption. rewrite <- sqrt_Rsqr_abs, <- sqrt_mult_alt by apply Rle_0_sqr. f_equal. unfold Rsqr. ring.
  - intros b Hb Nb. destruct (Nat.eq_dec b (contact s)) as [->|E]; [rewrite Z1, Z2; ring|].
    rewrite Al, Hd by assumption. destruct (Hk b Hb E Nb) as [-> | [-> ->]]; ring.
  - intros b Hb Nb. destruct (Nat.eq_dec b (contact s)) as [->|E]; [rewrite Z1, Z2; ring|].
    rewrite Al, Hd by assumption. destruct (Hk b Hb E Nb) as [-> | [-> ->]]; ring.
Qed.

Theorem held_contact_divides : Statements.held_contact_divides.
Proof.
  intros s X_re X_im side [Z1 [Z2 Rows]] Hl Div. split; [|split]; cbv beta.
  - rewrite Z1. destruct (side (contact s)); reflexivity.
  - rewrite Z2. destruct (side (contact s)); reflexivity.
  - intros a Ha Na. destruct (side a) eqn:Sa.
    + destruct (Rows a Ha Na) as [E1 E2]. split; [rewrite <- E1 | apply eq_trans with (2 := E2)]; apply Sum_ext; intros b Hb;
      cbv beta; (destruct (Nat.eq_dec b (contact s)) as [->|Nb];
        [rewrite Z1, Z2; destruct (side (contact s)); ring|]); (destruct (side b) eqn:Sb; [reflexivity|]);
        destruct (Div a b Ha Hb Na Nb) as [-> [-> ->]]; try ring; rewrite Sa, Sb; discriminate.
    + split; [rewrite delta_other by (intros ->; rewrite Hl in Sa; discriminate)|]; apply Sum_zero; intros b Hb;
        (destruct (Nat.eq_dec b (contact s)) as [->|Nb]; [rewrite Z1, Z2; destruct (side (contact s)); ring|]);
        (destruct (side b) eqn:Sb; [|ring]);
        destruct (Div a b Ha Hb Na Nb) as [-> [-> ->]]; try ring; rewrite Sa, Sb; discriminate.
Qed.

(* ---- Two masses, the contact on the second ---- *)
Lemma two_held_scene b : is_scene (two_masses_held b).
Proof.
  split; [simpl; lia|]. split; [simpl; lia|]. split.
  - intros i Hi. simpl in Hi. destruct i as [|i]; [apply admissible_half | apply (admissible_resonant (1 / 2)); lra].
  - split; [|split]; intros i a Hi Ha; simpl in Hi, Ha; (destruct i as [|[|i]]; [| |lia]); (destruct a as [|[|a]]; [| |lia]);
    simpl; unfold delta; simpl; field.
Qed.
Definition held_re (k : nat) := match k with O => 135 / 197 | _ => 0 end.
Definition held_im (k : nat) := match k with O => - (80 / 197) | _ => 0 end.
Lemma two_held_motion b : held_motion (two_masses_held b) held_re held_im.
Proof.
  split; [reflexivity|]. split; [reflexivity|]. intros a Ha Na. simpl in Ha, Na. assert (a = 0%nat) by lia. subst.
  simpl. unfold delta. simpl. split; field.
Qed.
Lemma two_held_load b : held_load (two_masses_held b) held_re held_im = sqrt (288 / 197).
Proof. unfold held_load. f_equal. simpl. unfold delta. simpl. field. Qed.
Lemma two_held_alone b : contact_inertia_alone (two_masses_held b).
Proof. intros a Ha Na. simpl in Ha, Na. assert (a = 0%nat) by lia. subst. reflexivity. Qed.
Lemma two_held_slips b : 0 < b -> b * b < 288 / 197 -> ~ rests (two_masses_held b) 1 held_re held_im.
Proof.
  intros Hb Hl R. apply (eq_88 (two_masses_held b) 1 held_re held_im) in R; [| simpl; lia | lra | exact Hb | apply
    two_held_motion].
  rewrite two_held_load in R. simpl in R. unfold Rdiv in R at 1. rewrite Rinv_1, Rmult_1_r in R.
  pose proof (sqrt_pos (288 / 197)). pose proof (sqrt_sqrt (288 / 197) ltac:(lra)).
  assert (sqrt (288 / 197) * sqrt (288 / 197) <= b * b) by (apply Rmult_le_compat; assumption). lra.
Qed.
Lemma two_held_spring : - stiffness (two_masses_held 0) 1 0 * sqrt (held_re 0 ^ 2 + held_im 0 ^ 2) / 1 = sqrt (36 * 36 / 985).
Proof.
  simpl. replace (36 * 36 / 985) with ((36 / 25) ^ 2 * (125 / 197)) by field. rewrite sqrt_mult, sqrt_pow2 by lra.
  replace (135 / 197 * (135 / 197 * 1) + - (80 / 197) * (- (80 / 197) * 1)) with (125 / 197) by field. field.
Qed.
Theorem eq_88_without_the_damping_force : Statements.eq_88_without_the_damping_force.
Proof.
  intros H. apply (two_held_slips (6 / 5)); [lra | lra|].
  apply (H (two_masses_held (6 / 5)) 1 held_re held_im 0%nat); [apply two_held_scene | apply two_held_alone | reflexivity |
    simpl; lia | lra
    | simpl; lra | apply two_held_motion | |].
  - intros b Hb. simpl in Hb. destruct b; [lia|]. split; reflexivity.
  - change (- stiffness (two_masses_held 0) 1 0 * sqrt (held_re 0 ^ 2 + held_im 0 ^ 2) / 1 <= 6 / 5). rewrite two_held_spring.
    replace (6 / 5) with (sqrt ((6 / 5) ^ 2)) by (apply sqrt_pow2; lra). apply sqrt_le_1_alt. lra.
Qed.
