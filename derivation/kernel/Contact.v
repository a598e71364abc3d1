(* Proofs of (54)-(72): where the closed form is a motion of Coulomb's contact. *)
Require Import Reals Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes SteadyMode Sums Masses.
Open Scope R_scope.

(* ---- Limits of quotients ---- *)
Lemma slope_limit (f : R -> R) a A : f a = 0 -> is_derive f a A -> is_lim (fun t => f t / (t - a)) a A.
Proof.
  intros Fa D. apply is_derive_Reals in D. apply is_lim_spec. intros eps. destruct (D eps (cond_pos eps)) as [del Hd].
  exists del. intros t Ht Hta. assert (E : forall b : R, a + (b - a) = b) by (intros; ring). specialize (Hd (t - a)).
  rewrite E, Fa, Rminus_0_r in Hd. apply Hd; [|exact Ht]. intros Z. apply Hta. rewrite <- (E t), Z. apply Rplus_0_r.
Qed.

Lemma quotient_limit (f h : R -> R) a A B : f a = 0 -> h a = 0 -> is_derive f a A -> is_derive h a B -> B <> 0 ->
  (exists r, 0 < r /\ forall t, Rabs (t - a) < r -> t <> a -> h t <> 0) -> is_lim (fun t => f t / h t) a (A / B).
Proof.
  intros Fa Ha DF DH HB [r [Hr Hn]].
  apply (is_lim_ext_loc (fun t => (f t / (t - a)) / (h t / (t - a)))).
  - exists (mkposreal r Hr). intros t Ht Hta. assert (h t <> 0) by (apply Hn; [exact Ht | exact Hta]). field. split; lra.
  - change (Finite (A / B)) with (Rbar_div A B). apply is_lim_div; [apply slope_limit; assumption | apply slope_limit;
    assumption | | ].
    + intros K. apply HB. injection K. auto.
    + unfold ex_Rbar_div. simpl. exact I.
Qed.

Lemma sin_not_zero t : - PI < t < PI -> t <> 0 -> sin t <> 0.
Proof.
  intros H H0. destruct (Rlt_dec 0 t) as [P|P]; [apply Rgt_not_eq, sin_gt_0; lra|].
  apply Rlt_not_eq. rewrite <- (Ropp_involutive t), sin_neg. apply Ropp_lt_gt_0_contravar, sin_gt_0; lra.
Qed.

Lemma slope_nonpos (h : R -> R) A : h 0 = 0 -> is_derive h 0 A -> (forall t, 0 < t < PI -> h t < 0) -> A <= 0.
Proof.
  intros H0 D N. apply Rnot_lt_le. intros P. apply is_derive_Reals in D. destruct (D (A / 2) ltac:(lra)) as [del Hd].
  pose proof PI_RGT_0. set (t := Rmin (del / 2) (PI / 2)).
  assert (T : 0 < t < PI /\ t < del).
  { pose proof (cond_pos del). unfold t. pose proof (Rmin_l (del / 2) (PI / 2)). pose proof (Rmin_r (del / 2) (PI / 2)).
    assert (0 < Rmin (del / 2) (PI / 2)) by (apply Rmin_glb_lt; lra). lra. }
  specialize (Hd t ltac:(lra)). rewrite Rabs_right in Hd by lra. specialize (Hd ltac:(lra)).
  rewrite Rplus_0_l, H0, Rminus_0_r in Hd. apply Rabs_lt_between in Hd. pose proof (N t ltac:(lra)) as Ht.
  assert (h t / t < 0) by (unfold Rdiv; pose proof (Rinv_0_lt_compat t ltac:(lra)); nra). lra.
Qed.

(* ---- One mode ---- *)
Lemma sin_above x : 0 < x -> - x <= sin x.
Proof.
  intros H. pose proof PI2_3_2. unfold PI2 in *. destruct (Rle_dec x PI); [pose proof (sin_ge_0 x ltac:(lra) ltac:(lra)); lra|].
    pose proof (SIN_bound x). lra.
Qed.

Lemma denominator_pos r z : 0 < r -> 0 <= z < 1 -> cosh (decay r z) + cos (theta r z) <> 0 -> 0 < cosh (decay r z) + cos (theta
  r z).
Proof.
  intros Hr Hz HD. pose proof (COS_bound (theta r z)).
  assert (1 <= cosh (decay r z)).
  { unfold cosh. set (a := decay r z). pose proof (exp_pos a). pose proof (exp_pos (- a)).
    assert (E : exp a * exp (- a) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0).
    set (p := exp a) in *. set (p' := exp (- a)) in *. apply Rnot_lt_le. intros L.
    assert ((p + p') * (p + p') < 2 * 2) by (apply Rmult_le_0_lt_compat; lra). pose proof (pow2_ge_0 (p - p')). nra. }
  lra.
Qed.

Lemma mode_demand_positive r z : admissible r z -> 0 < 1 + g r z + 2 * z * r * u r z.
Proof.
  intros [Hr [Hz [HD _]]]. pose proof (denominator_pos r z Hr Hz HD) as P. pose proof (w_pos z Hz) as Hw. pose proof PI_RGT_0.
  replace (1 + g r z + 2 * z * r * u r z) with ((exp (decay r z) + cos (theta r z) + z / w z * sin (theta r z)) / (cosh (decay r
    z) + cos (theta r z))).
  - apply Rdiv_lt_0_compat; [|exact P].
    assert (T : 0 < theta r z) by (unfold theta; apply Rdiv_lt_0_compat; nra).
    assert (S : - decay r z <= z / w z * sin (theta r z)).
    { replace (- decay r z) with (z / w z * - theta r z) by (unfold decay, theta; field; lra).
      apply Rmult_le_compat_l; [apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat, Hw] | apply sin_above, T]. }
    pose proof (COS_bound (theta r z)). destruct (Req_dec (decay r z) 0) as [Z|Z].
    + rewrite Z in *. rewrite exp_0. rewrite cosh_0 in P. lra.
    + pose proof (exp_ineq1 (decay r z) Z). lra.
  - unfold g, u. assert (EX : exp (decay r z) = cosh (decay r z) + sinh (decay r z)) by (unfold cosh, sinh; field).
    rewrite EX. field. repeat split; lra.
Qed.

(* what (57) divides by sin tau, and its rate *)
Lemma demand_by_braces r z t : 0 < r -> demand_of_mode r z t = r ^ 2 * braces_prime r z t + u r z * r ^ 2 * cos t.
Proof. intros Hr. unfold demand_of_mode, braces_prime. field; lra. Qed.

Lemma demand_rate r z t : 0 < r -> 0 <= z < 1 -> is_derive (demand_of_mode r z) t (r ^ 2 * braces_second r z t - u r z * r ^ 2 *
  sin t).
Proof.
  intros Hr Hz. apply (is_derive_ext (fun t => r ^ 2 * braces_prime r z t + u r z * r ^ 2 * cos t)); [intros; symmetry; apply
    demand_by_braces, Hr|].
  evar_last. { apply (is_derive_plus (V := R_NormedModule)); apply is_derive_scal; [apply braces_prime_rate; assumption | apply
    is_derive_cos]. }
  unfold plus; simpl. ring.
Qed.

Lemma demand_ends r z : admissible r z -> demand_of_mode r z 0 = 0 /\ demand_of_mode r z PI = 0 /\
  r ^ 2 * braces_second r z 0 = 1 + g r z + 2 * z * r * u r z /\ r ^ 2 * braces_second r z PI = 1 - (g r z + 2 * z * r * u r z).
Proof.
  intros [Hr [Hz [HD Hv]]]. rewrite !demand_by_braces by exact Hr. rewrite cos_0, cos_PI.
  pose proof (braces_equation r z 0 Hr Hz) as E0. pose proof (braces_equation r z PI Hr Hz) as E1.
  destruct (braces_mirrored r z Hr Hz HD) as [B B']. rewrite B, B' in *.
  assert (X : braces r z 0 = - g r z /\ braces_prime r z 0 = - u r z).
  { unfold braces, braces_prime. destruct (at_start r z Hr Hz) as [D0 [Q0 P0]]. rewrite D0, Q0, P0. split; field; lra. }
  destruct X as [X1 X2]. rewrite X1, X2 in *. repeat split; try ring; lra.
Qed.

Section Scene.
Variable s : scene.
Local Notation N := (masses s).
Local Notation M := (mass s).
Local Notation C := (damping s).
Local Notation K := (stiffness s).
Local Notation psi := (shape s).
Local Notation R_ := (ratio s).
Local Notation zeta := (damping_ratio s).
Local Notation j := (contact s).
Local Notation l := (loaded s).
Local Notation beta := (friction s).
Hypothesis Hs : is_scene s.
Hint Resolve Hj Hl Hadm Hratio : core.

Definition D t := Sum N (fun i => psi j i ^ 2 * demand_of_mode (R_ i) (zeta i) t).
Definition D' t := Sum N (fun i => psi j i ^ 2 * (R_ i ^ 2 * braces_second (R_ i) (zeta i) t - u (R_ i) (zeta i) * R_ i ^ 2 *
  sin t)).
Lemma D_rate t : is_derive D t (D' t).
Proof.
  apply (is_derive_Sum N (fun i t => psi j i ^ 2 * demand_of_mode (R_ i) (zeta i) t)
    (fun i t => psi j i ^ 2 * (R_ i ^ 2 * braces_second (R_ i) (zeta i) t - u (R_ i) (zeta i) * R_ i ^ 2 * sin t))).
  intros i Hi. destruct (Hadm s Hs i Hi) as [A [B _]]. apply is_derive_scal, demand_rate; assumption.
Qed.
Lemma D_ends : D 0 = 0 /\ D PI = 0 /\ D' 0 = H_j s + mobility s /\ D' PI = mobility s - H_j s.
Proof.
  unfold D, D', H_j, mobility. rewrite <- Sum_plus, <- Sum_minus, sin_0, sin_PI.
  split; [|split; [|split]]; [apply Sum_zero | apply Sum_zero | apply Sum_ext | apply Sum_ext]; intros i Hi;
    destruct (demand_ends (R_ i) (zeta i) (Hadm s Hs i Hi)) as [E1 [E2 [E3 E4]]]; rewrite ?E1, ?E2, ?E3, ?E4; ring.
Qed.

Lemma mobility_pos : 0 < mobility s.
Proof.
  assert (P : 0 <= mobility s) by (apply Sum_nonneg; intros; apply pow2_ge_0). destruct P as [P|P]; [exact P|]. exfalso.
  assert (Z : forall i, (i < N)%nat -> psi j i ^ 2 = 0) by (apply Sum_nonneg_zero; [intros; apply pow2_ge_0 | symmetry; exact P]).
  pose proof (complete_1 s Hs j j (Hj s Hs) (Hj s Hs)) as E. rewrite delta_same in E. rewrite Sum_zero in E; [lra|].
  intros i Hi. specialize (Z i Hi). assert (psi j i = 0) by nra. rewrite H. ring.
Qed.

Lemma start_demand_pos : 0 < H_j s + mobility s.
Proof.
  assert (E : H_j s + mobility s = Sum N (fun i => psi j i ^ 2 * (1 + g (R_ i) (zeta i) + 2 * zeta i * R_ i * u (R_ i) (zeta
    i)))).
  { unfold H_j, mobility. rewrite <- Sum_plus. apply Sum_ext. intros; ring. }
  assert (P : forall i, (i < N)%nat -> 0 <= psi j i ^ 2 * (1 + g (R_ i) (zeta i) + 2 * zeta i * R_ i * u (R_ i) (zeta i))).
  { intros i Hi. pose proof (mode_demand_positive _ _ (Hadm s Hs i Hi)). pose proof (pow2_ge_0 (psi j i)). nra. }
  rewrite E. pose proof (Sum_nonneg N _ P) as Q. destruct Q as [Q|Q]; [exact Q|]. exfalso.
  pose proof (Sum_nonneg_zero N _ P (eq_sym Q)) as Z. pose proof mobility_pos as Mp. unfold mobility in Mp. rewrite Sum_zero in
    Mp; [lra|].
  intros i Hi. specialize (Z i Hi). pose proof (mode_demand_positive _ _ (Hadm s Hs i Hi)).
  destruct (Rmult_integral _ _ Z); [assumption | lra].
Qed.

Lemma demand_limits : is_lim (demand s) 0 (H_j s + mobility s) /\ is_lim (demand s) PI (H_j s - mobility s).
Proof.
  destruct D_ends as [D0 [D1 [E0 E1]]]. pose proof PI_RGT_0. split.
  - replace (H_j s + mobility s) with (D' 0 / cos 0) by (rewrite E0, cos_0; field).
    apply (quotient_limit D sin 0); [exact D0 | apply sin_0 | apply D_rate | apply is_derive_sin | rewrite cos_0; lra |].
    exists PI. split; [lra|]. intros t Ht H0. apply sin_not_zero; [|exact H0]. apply Rabs_lt_between in Ht. lra.
  - replace (H_j s - mobility s) with (D' PI / cos PI) by (rewrite E1, cos_PI; field).
    apply (quotient_limit D sin PI); [exact D1 | apply sin_PI | apply D_rate | apply is_derive_sin | rewrite cos_PI; lra |].
    exists PI. split; [lra|]. intros t Ht H0. replace t with (t - PI + PI) by ring. rewrite neg_sin. apply Ropp_neq_0_compat,
      sin_not_zero; [|lra].
    apply Rabs_lt_between in Ht. lra.
Qed.

(* the contact's velocity *)
Lemma velocity phi t : V_re s j * sin phi + V_im s j * cos phi = - (beta * U s j) ->
  x_prime s phi j t = beta * D t - (V_re s j * cos phi - V_im s j * sin phi) * sin t.
Proof.
  intros E. transitivity (- (V_re s j * sin (t + phi) + V_im s j * cos (t + phi)) + beta * (D t - U s j * cos t)).
  - rewrite <- superposition_sin. unfold x_prime, D, U. rewrite <- Sum_scal_r, <- Sum_minus, <- Sum_scal, <- Sum_opp, <- Sum_plus.
    apply Sum_ext. intros i Hi. rewrite demand_by_braces by eauto. unfold eta_prime. ring.
  - rewrite sin_plus, cos_plus. transitivity (beta * D t - (V_re s j * cos phi - V_im s j * sin phi) * sin t - cos t * (V_re s j
    * sin phi + V_im s j * cos phi + beta * U s j)); [ring|].
    rewrite E. ring.
Qed.

Lemma acceleration_at_start phi : V_re s j * sin phi + V_im s j * cos phi = - (beta * U s j) ->
  x_second s phi j 0 = beta * (H_j s + mobility s) - (V_re s j * cos phi - V_im s j * sin phi).
Proof.
  intros E. pose proof (x_prime_derive s Hs phi j 0) as A. apply is_derive_unique in A. rewrite <- A. apply is_derive_unique.
  apply (is_derive_ext (fun t => beta * D t - (V_re s j * cos phi - V_im s j * sin phi) * sin t)); [intros; symmetry; apply
    velocity, E|].
  evar_last. { apply (is_derive_minus (V := R_NormedModule)); apply is_derive_scal; [apply D_rate | apply is_derive_sin]. }
  destruct D_ends as [_ [_ [E0 _]]]. rewrite E0, cos_0. unfold minus, plus, opp; simpl. ring.
Qed.

Lemma slides_iff_ phi : is_phase s phi -> (slides s phi <-> forall t, 0 < t < PI -> beta * demand s t < root s).
Proof.
  intros [P1 P2]. split; intros H t Ht; specialize (H t Ht); pose proof (sin_gt_0 t ltac:(lra) ltac:(lra)) as S.
  - rewrite velocity, P1 in H by exact P2. change (demand s t) with (D t / sin t). apply (Rmult_lt_reg_r (sin t)); [exact S|].
    replace (beta * (D t / sin t) * sin t) with (beta * D t) by (field; lra). lra.
  - rewrite velocity, P1 by exact P2. change (demand s t) with (D t / sin t) in H. apply (Rmult_lt_compat_r (sin t)) in H;
    [|exact S].
    replace (beta * (D t / sin t) * sin t) with (beta * D t) in H by (field; lra). lra.
Qed.

Lemma sliding_start phi : is_phase s phi -> slides s phi -> beta * (H_j s + mobility s) <= root s.
Proof.
  intros [P1 P2] H. pose proof (acceleration_at_start phi P2) as A. rewrite P1 in A.
  assert (x_second s phi j 0 <= 0); [|lra]. apply (slope_nonpos (x_prime s phi j)); [| apply x_prime_derive, Hs | exact H].
  rewrite velocity, sin_0 by exact P2. destruct D_ends as [D0 _]. rewrite D0. ring.
Qed.

(* The load on a contact at rest, in the modes *)
Lemma holding_by_modes c y y1 : mobility s * holding_load s c y y1 =
  Sum N (fun i => psi j i * (2 * zeta i / R_ i * modal s y1 i + / R_ i ^ 2 * modal s y i - psi l i * c)).
Proof.
  pose proof mobility_pos as Mp. set (e := fun i => 2 * zeta i / R_ i * modal s y1 i + / R_ i ^ 2 * modal s y i - psi l i * c).
  assert (Ro : forall a, (a < N)%nat -> Sum N (fun b => C a b * y1 b + K a b * y b) - delta a l * c = Sum N (fun i => MP s a i *
    e i)).
  { intros a Ha. rewrite <- (complete_1 s Hs a l Ha (Hl s Hs)), <- Sum_scal_r.
    rewrite (Sum_ext N (fun b => C a b * y1 b + K a b * y b) (fun b => M a b * Sum N (fun i => psi b i * 0)
      + C a b * Sum N (fun i => psi b i * modal s y1 i) + K a b * Sum N (fun i => psi b i * modal s y i))).
    - rewrite (row s Hs a (fun _ => 0)) by exact Ha. rewrite <- Sum_minus. apply Sum_ext. intros i _. unfold e. ring.
    - intros b Hbn. rewrite <- !(physical s Hs _ b Hbn). rewrite (Sum_zero N (fun i => psi b i * 0)) by (intros; ring). ring. }
  unfold holding_load. replace (mobility s * (Sum N _ / mobility s)) with (Sum N (fun a => Sum N (fun i => psi j i * psi a i)
    * (Sum N (fun b => C a b * y1 b + K a b * y b) - delta a l * c))) by (field; lra).
  rewrite (Sum_ext N _ (fun a => Sum N (fun i => Sum N (fun k => psi j k * (psi a k * (MP s a i * e i)))))).
  - rewrite Sum_swap. apply Sum_ext. intros i Hi. rewrite Sum_swap. fold (e i).
    rewrite (Sum_ext N _ (fun k => delta k i * (psi j k * e i))); [apply (Sum_delta N i (fun k => psi j k * e i) Hi)|].
    intros k Hk. destruct Hs as [_ [_ [_ [_ [O _]]]]]. rewrite <- (O k i Hk Hi), <- Sum_scal_r. apply Sum_ext. intros a Ha. unfold
      MP. ring.
  - intros a Ha. rewrite Ro by exact Ha. rewrite <- Sum_scal. apply Sum_ext. intros i _. rewrite <- Sum_scal_r. apply Sum_ext.
    intros; ring.
Qed.

Lemma acceleration_by_load c F y y1 y2 :
  (forall a, (a < N)%nat -> Sum N (fun b => M a b * y2 b + C a b * y1 b + K a b * y b) + F * delta a j = delta a l * c) ->
  y2 j = - mobility s * (F + holding_load s c y y1).
Proof.
  intros H. rewrite (physical s Hs y2 j (Hj s Hs)).
  transitivity (- (mobility s * F + mobility s * holding_load s c y y1)); [|ring].
  rewrite holding_by_modes. unfold mobility. rewrite <- Sum_scal_r, <- Sum_plus, <- Sum_opp. apply Sum_ext. intros i Hi.
  assert (E : modal s y2 i + 2 * zeta i / R_ i * modal s y1 i + / R_ i ^ 2 * modal s y i = psi l i * c - psi j i * F).
  { rewrite (modal_rows s Hs y2 y1 y (fun a => delta a l * c - F * delta a j)) by (try exact Hi; intros a Ha; rewrite <- (H a Ha);
      ring).
    rewrite (Sum_ext N _ (fun a => delta a l * (psi a i * c) - delta a j * (psi a i * F))) by (intros; ring).
    rewrite Sum_minus, (Sum_delta N l (fun a => psi a i * c)), (Sum_delta N j (fun a => psi a i * F)) by (apply Hj || apply Hl;
      exact Hs). reflexivity. }
  replace (modal s y2 i) with (psi l i * c - psi j i * F - 2 * zeta i / R_ i * modal s y1 i - / R_ i ^ 2 * modal s y i) by lra.
    ring.
Qed.

Lemma holding_ phi : is_phase s phi -> holding_friction s phi = (root s - beta * H_j s) / mobility s.
Proof.
  intros [P1 P2]. pose proof mobility_pos as Mp. pose proof (acceleration_at_start phi P2) as A. rewrite P1 in A.
  pose proof (acceleration_by_load (cos phi) (- beta) (fun k => x s phi k 0) (fun k => x_prime s phi k 0) (fun k => x_second s
    phi k
    0)) as E. cbv beta in E. rewrite E in A.
  - apply (Rmult_eq_reg_l (mobility s)); [|lra]. unfold holding_friction.
    replace (mobility s * ((root s - beta * H_j s) / mobility s)) with (root s - beta * H_j s) by (field; lra). lra.
  - intros a Ha. rewrite (x_equation s Hs phi a 0 Ha), Rplus_0_l. ring.
Qed.

Lemma mobility_alone : contact_inertia_alone s -> M j j * mobility s = 1.
Proof.
  intros H. rewrite <- (delta_same j), <- (complete_1 s Hs j j (Hj s Hs) (Hj s Hs)). unfold mobility. rewrite <- Sum_scal. apply
    Sum_ext. intros i Hi.
  unfold MP. rewrite (Sum_single N j (fun c => M j c * psi c i)); [ring | apply Hj, Hs |]. intros c Hc Hcj. rewrite H by
    assumption. ring.
Qed.

Lemma load_alone c y y1 : contact_inertia_alone s ->
  holding_load s c y y1 = Sum N (fun k => C j k * y1 k + K j k * y k) - delta l j * c.
Proof.
  intros H. pose proof (mobility_alone H) as Mo. pose proof mobility_pos as Mp. unfold holding_load.
  rewrite (Sum_ext N _ (fun a => delta a j * (mobility s * (Sum N (fun b => C a b * y1 b + K a b * y b) - delta a l * c)))).
  - rewrite (Sum_delta N j (fun a => mobility s * (Sum N (fun b => C a b * y1 b + K a b * y b) - delta a l * c)) (Hj s Hs)),
      (delta_sym l j). field. lra.
  - intros a Ha. rewrite <- Rmult_assoc. f_equal. rewrite (delta_sym a j), <- (complete_1 s Hs j a (Hj s Hs) Ha).
    rewrite <- Sum_scal_r. apply Sum_ext. intros i Hi. unfold MP.
    rewrite (Sum_single N j (fun c => M j c * psi c i)) by (try apply Hj, Hs; intros e He Hej; rewrite H by assumption; ring).
    transitivity (psi j i * psi a i * (M j j * mobility s)); [rewrite Mo|]; ring.
Qed.
Lemma holding_is_load phi : contact_inertia_alone s -> holding_friction s phi = contact_load s phi.
Proof. intros H. unfold holding_friction. rewrite load_alone by exact H. reflexivity. Qed.
End Scene.

Theorem eq_65 : forall s, Statements.eq_65 s.
Proof.
  intros s Hs H. pose proof (mobility_alone s Hs H). assert (mass s (contact s) (contact s) <> 0) by (intro Z; rewrite Z in *;
    lra).
  apply (Rmult_eq_reg_l (mass s (contact s) (contact s))); [|assumption]. rewrite H0. field. assumption.
Qed.
Theorem holding_friction_is_the_load : forall s, Statements.holding_friction_is_the_load s.
Proof. intros s Hs H. split; [intros; apply load_alone | intros; apply holding_is_load]; assumption. Qed.
Theorem holding_load_holds : forall s, Statements.holding_load_holds s.
Proof.
  intros s Hs c F y y1 y2 H. rewrite (acceleration_by_load s Hs c F y y1 y2 H). pose proof (mobility_pos s Hs). split; intros E;
    [|
    rewrite E; ring].
  destruct (Rmult_integral _ _ E); lra.
Qed.
Theorem slides_iff : forall s, Statements.slides_iff s.
Proof. intros s Hs _ phi P. rewrite root_of_sum. apply slides_iff_; assumption. Qed.
Theorem eq_66 : forall s, Statements.eq_66 s.
Proof. intros s Hs _ phi P. rewrite root_of_sum. apply holding_; assumption. Qed.

Theorem demand_at_start : forall s, Statements.demand_at_start s.
Proof.
  intros s Hs. split; [|split; [apply mobility_pos, Hs | apply start_demand_pos, Hs]].
  destruct (demand_limits s Hs) as [L _]. unfold is_lim in L. simpl in L.
  eapply filterlim_filter_le_1; [|exact L]. intros P [e He]. exists e. intros t Ht Hp. apply He; [exact Ht | lra].
Qed.

Lemma below_sqrt b z : 0 < b -> 0 <= z -> (b < sqrt z <-> b * b < z).
Proof.
  intros Hb Hz. split; intros H.
  - rewrite <- (sqrt_sqrt z Hz). nra.
  - rewrite <- (sqrt_square b) by lra. apply sqrt_lt_1_alt. nra.
Qed.
Lemma above_sqrt b z : 0 < b -> 0 <= z -> (sqrt z < b <-> z < b * b).
Proof.
  intros Hb Hz. split; intros H.
  - rewrite <- (sqrt_sqrt z Hz). pose proof (sqrt_pos z). nra.
  - rewrite <- (sqrt_square b) by lra. apply sqrt_lt_1_alt. lra.
Qed.
Lemma below_quotient b v n : 0 < n -> (b * b < v / n <-> b * b * n < v).
Proof.
  intros Hn. split; intros H.
  - apply (Rmult_lt_compat_r n) in H; [|exact Hn]. replace (v / n * n) with v in H by (field; lra). exact H.
  - apply (Rmult_lt_reg_r n); [exact Hn|]. replace (v / n * n) with v by (field; lra). exact H.
Qed.

Lemma limit_of_root b V Uj D : 0 < D -> 0 < b ->
  ((0 < V /\ Rabs (b * Uj) <= V) /\ b * D < sqrt (V ^ 2 - (b * Uj) ^ 2) <-> 0 < V /\ b < sqrt (V ^ 2 / (Uj ^ 2 + D ^ 2))).
Proof.
  intros HD Hb. assert (P : 0 < Uj ^ 2 + D ^ 2) by nra.
  assert (Q : 0 <= V ^ 2 / (Uj ^ 2 + D ^ 2)) by (apply Rmult_le_pos; [nra | apply Rlt_le, Rinv_0_lt_compat, P]).
  assert (RS : Rabs (b * Uj) <= V -> sqrt (V ^ 2 - (b * Uj) ^ 2) ^ 2 = V ^ 2 - (b * Uj) ^ 2).
  { intros H. rewrite <- (Rsqr_pow2 (sqrt _)), Rsqr_sqrt; [reflexivity|]. pose proof (Rabs_pos (b * Uj)).
    rewrite <- (pow2_abs (b * Uj)). nra. }
  rewrite (below_sqrt b _ Hb Q), (below_quotient b _ _ P). pose proof (sqrt_pos (V ^ 2 - (b * Uj) ^ 2)) as R0.
  set (r := sqrt (V ^ 2 - (b * Uj) ^ 2)) in *. split.
  - intros [[HV H] HR]. split; [exact HV|]. specialize (RS H).
    assert (b * D * (b * D) < r * r) by (apply Rmult_le_0_lt_compat; nra). nra.
  - intros [HV HL]. pose proof (pow2_ge_0 (b * D)) as BD. assert (H : Rabs (b * Uj) <= V).
    { apply Rsqr_incr_0_var; [|lra]. rewrite <- Rsqr_abs. unfold Rsqr. nra. }
    split; [split; assumption|]. specialize (RS H).
    apply Rnot_le_lt. intros L. assert (r * r <= b * D * (b * D)) by (apply Rmult_le_compat; lra). nra.
Qed.
Lemma limit_of_beta s D : 0 < D -> 0 < friction s ->
  (responds s /\ friction s * D < root s <->
   0 < V_abs s (contact s) /\ friction s < sqrt (V_abs s (contact s) ^ 2 / (U s (contact s) ^ 2 + D ^ 2))).
Proof. exact (limit_of_root (friction s) (V_abs s (contact s)) (U s (contact s)) D). Qed.

Theorem as_a_limit_of_beta : forall s, Statements.as_a_limit_of_beta s.
Proof. intros s D HD Hb. apply limit_of_beta; assumption. Qed.

Lemma holding_above s mu phi : is_scene s -> is_phase s phi ->
  (mu * friction s < holding_friction s phi <-> friction s * (H_j s + mu * mobility s) < root s) /\
  (holding_friction s phi < - (mu * friction s) <-> root s < friction s * (H_j s - mu * mobility s)).
Proof.
  intros Hs P. rewrite holding_ by assumption. pose proof (mobility_pos s Hs) as Mp.
  assert (E : (root s - friction s * H_j s) / mobility s * mobility s = root s - friction s * H_j s) by (field; lra).
  split; split; intros H.
  - apply (Rmult_lt_compat_r (mobility s)) in H; [|exact Mp]. rewrite E in H. lra.
  - apply (Rmult_lt_reg_r (mobility s)); [exact Mp|]. rewrite E. lra.
  - apply (Rmult_lt_compat_r (mobility s)) in H; [|exact Mp]. rewrite E in H. lra.
  - apply (Rmult_lt_reg_r (mobility s)); [exact Mp|]. rewrite E. lra.
Qed.

Lemma static_demand_pos s mu : is_scene s -> 1 <= mu -> 0 < H_j s + mu * mobility s.
Proof. intros Hs Hm. pose proof (start_demand_pos s Hs). pose proof (mobility_pos s Hs). nra. Qed.

Lemma phase_responds s phi : 0 < V_abs s (contact s) -> is_phase s phi -> responds s.
Proof.
  intros V [P1 P2]. split; [exact V|]. apply Rnot_lt_le. intros H.
  pose proof (V_abs_sq s (contact s)) as Vs. pose proof (pow2_abs (friction s * U s (contact s))) as A.
  assert (Z : root s = 0) by (unfold root; apply sqrt_neg_0; nra).
  pose proof (circle (V_re s (contact s)) (V_im s (contact s)) phi) as C. rewrite P1, P2, Z in C. nra.
Qed.
Lemma some_phase s : responds s -> exists phi, is_phase s phi.
Proof. intros H. eexists. apply (proj1 (eq_39 s H)). Qed.
Theorem phase_exists_iff : forall s, Statements.phase_exists_iff s.
Proof. intros s V. split; [intros [phi P]; apply (phase_responds s phi V P) | apply some_phase]. Qed.

Theorem eq_67 : forall s, Statements.eq_67 s.
Proof.
  intros s mu Hs Hm Hb HV. pose proof (limit_of_beta s _ (static_demand_pos s mu Hs Hm) Hb) as L. split.
  - intros [phi [P H]]. apply L. split; [apply (phase_responds s phi HV P) | apply (holding_above s mu phi Hs P), H].
  - intros H. destruct (proj2 L (conj HV H)) as [Re Ro]. destruct (some_phase s Re) as [phi P]. exists phi. split; [exact P|].
    apply (holding_above s mu phi Hs P), Ro.
Qed.

Theorem eq_68 : forall s, Statements.eq_68 s.
Proof.
  intros s mu Hs Hm Hb H phi P. rewrite (proj2 (holding_above s mu phi Hs P)).
  pose proof (root_sq s H) as RS. pose proof (root_pos s) as RP. set (E := H_j s - mu * mobility s). set (b := friction s) in *.
  set (V := V_abs s (contact s)) in *. set (Uj := U s (contact s)) in *.
  assert (Q : 0 < E -> 0 < Uj ^ 2 + E ^ 2 /\ 0 <= V ^ 2 / (Uj ^ 2 + E ^ 2)).
  { intros HE. assert (0 < Uj ^ 2 + E ^ 2) by nra. split; [assumption|]. apply Rmult_le_pos; [nra | apply Rlt_le,
    Rinv_0_lt_compat; assumption]. }
  split.
  - intros L. assert (HE : 0 < E) by nra. destruct (Q HE) as [Q1 Q2]. split; [exact HE|]. apply above_sqrt; try assumption.
    apply (Rmult_lt_reg_r (Uj ^ 2 + E ^ 2)); [exact Q1|]. replace (V ^ 2 / (Uj ^ 2 + E ^ 2) * (Uj ^ 2 + E ^ 2)) with (V ^ 2) by
      (field; lra). nra.
  - intros [HE L]. destruct (Q HE) as [Q1 Q2]. apply above_sqrt in L; try assumption.
    apply (Rmult_lt_compat_r (Uj ^ 2 + E ^ 2)) in L; [|exact Q1]. replace (V ^ 2 / (Uj ^ 2 + E ^ 2) * (Uj ^ 2 + E ^ 2)) with (V
      ^ 2) in L by (field; lra).
    assert (0 < b * E) by (apply Rmult_lt_0_compat; assumption). nra.
Qed.

Theorem eq_68_excludes_58 : forall s, Statements.eq_68_excludes_58 s.
Proof.
  intros s mu Hs Hm Hb H phi P HH SL. apply (proj2 (holding_above s mu phi Hs P)) in HH.
  pose proof (sliding_start s Hs phi P SL). pose proof (mobility_pos s Hs).
  assert (friction s * (H_j s - mu * mobility s) < friction s * (H_j s + mobility s)) by (apply Rmult_lt_compat_l; nra). lra.
Qed.

Theorem sign_of_the_root : forall s, Statements.sign_of_the_root s.
Proof.
  intros s Hs Hb phi y y1 y2 [Cy [Hm [Mi V0]]] SL.
  destruct (initial_values s Hs phi y y1 y2 Cy Hm Mi (contact s) (Hj s Hs)) as [E1 E2]. rewrite V0, Rplus_0_l in E2.
  rewrite <- E1. pose proof (acceleration_at_start s Hs phi E2) as A. pose proof (start_demand_pos s Hs).
  assert (x_second s phi (contact s) 0 <= 0); [|nra]. apply (slope_nonpos (x_prime s phi (contact s))).
  - rewrite velocity, sin_0 by (exact Hs || exact E2). destruct (D_ends s Hs) as [D0 _]. rewrite D0. ring.
  - apply x_prime_derive, Hs.
  - intros t Ht. destruct (unique s Hs phi y y1 y2 Cy Hm Mi (contact s) t (Hj s Hs) ltac:(lra)) as [_ Q]. rewrite <- Q. apply
    SL, Ht.
Qed.

Theorem sum_of_maxima_is_sufficient : forall s, Statements.sum_of_maxima_is_sufficient s.
Proof.
  intros s S Hs Hb H HS L phi P. rewrite root_of_sum in L. apply slides_iff_; try assumption. intros t Ht.
  apply Rle_lt_trans with (2 := L). apply Rmult_le_compat_l; [lra|]. unfold demand, Rdiv. rewrite <- Sum_scal_r. apply Sum_le.
    intros i Hi.
  rewrite Rmult_assoc. apply Rmult_le_compat_l; [apply pow2_ge_0 | apply HS; assumption].
Qed.

(* The demand is bounded; its supremum is reached inside, or is not above its limits at the ends. *)
Lemma largest_demand s : is_scene s -> exists B, (forall t, 0 < t < PI -> demand s t <= B) /\
  (B <= H_j s + mobility s \/ exists t, 0 < t < PI /\ B = demand s t).
Proof.
  intros Hs. destruct (demand_limits s Hs) as [L0 L1]. pose proof PI_RGT_0. pose proof (mobility_pos s Hs).
  set (f := fun t => if Req_EM_T t 0 then H_j s + mobility s else if Req_EM_T t PI then H_j s - mobility s else demand s t).
  assert (Cf : forall t, 0 <= t <= PI -> continuity_pt f t).
  { intros t Ht. apply continuity_pt_filterlim'. unfold f at 2. destruct (Req_EM_T t 0) as [->|N0]; [|destruct (Req_EM_T t PI)
    as [->|N1]].
    - apply (is_lim_ext_loc (demand s) f) in L0; [exact L0|]. exists (mkposreal PI H). intros x Hx Hx0. unfold f.
      apply Rabs_lt_between in Hx. rewrite Rminus_0_r in Hx. simpl in Hx. destruct (Req_EM_T x 0); [contradiction|]. destruct
        (Req_EM_T x PI); [lra | reflexivity].
    - apply (is_lim_ext_loc (demand s) f) in L1; [exact L1|]. exists (mkposreal PI H). intros x Hx Hx0. unfold f.
      apply Rabs_lt_between in Hx. unfold minus, plus, opp in Hx; simpl in Hx. destruct (Req_EM_T x 0); [lra|]. destruct
        (Req_EM_T x PI); [contradiction | reflexivity].
    - assert (Hin : 0 < t < PI) by lra. assert (Q : 0 < Rmin t (PI - t)) by (apply Rmin_glb_lt; lra).
      assert (LD : is_lim (demand s) t (demand s t)); [|apply (is_lim_ext_loc (demand s) f) in LD; [exact LD|]].
      + apply (is_lim_continuity (demand s) t). apply continuity_pt_filterlim.
        apply (ex_derive_continuous (K := R_AbsRing) (V := R_NormedModule) (demand s) t).
        exists ((D' s t * sin t - D s t * cos t) / sin t ^ 2). apply is_derive_div; [apply D_rate, Hs | apply is_derive_sin |
          apply sin_not_zero; lra].
      + exists (mkposreal _ Q). intros x Hx _. apply Rabs_lt_between in Hx. unfold minus, plus, opp in Hx; simpl in Hx.
        pose proof (Rmin_l t (PI - t)). pose proof (Rmin_r t (PI - t)). unfold f. destruct (Req_EM_T x 0); [lra|]. destruct
          (Req_EM_T x PI); [lra | reflexivity]. }
  destruct (continuity_ab_maj f 0 PI ltac:(lra) Cf) as [p [Hp Ip]].
  exists (f p). split.
  - intros t Ht. specialize (Hp t ltac:(lra)). unfold f in Hp at 1.
    destruct (Req_EM_T t 0); [lra|]. destruct (Req_EM_T t PI); [lra|]. exact Hp.
  - unfold f. destruct (Req_EM_T p 0); [left; lra|]. destruct (Req_EM_T p PI); [left; lra|]. right. exists p. split; [lra |
    reflexivity].
Qed.

Lemma supremum s S : is_scene s -> is_lub (fun y => exists t, 0 < t < PI /\ y = demand s t) S ->
  S <= H_j s + mobility s \/ exists t, 0 < t < PI /\ S <= demand s t.
Proof.
  intros Hs [Up Le]. destruct (largest_demand s Hs) as [B [HB Q]].
  assert (SB : S <= B) by (apply Le; intros y [t [Ht ->]]; apply HB, Ht).
  destruct Q as [Q|[t [Ht E]]]; [left; lra | right; exists t; split; [exact Ht | lra]].
Qed.

Theorem demand_has_a_supremum : forall s, Statements.demand_has_a_supremum s.
Proof.
  intros s Hs. destruct (largest_demand s Hs) as [B [HB _]].
  destruct (completeness (fun y => exists t, 0 < t < PI /\ y = demand s t)) as [S L]; [| | exists S; exact L].
  - exists B. intros y [t [Ht ->]]. apply HB, Ht.
  - exists (demand s 1), 1. pose proof PI2_1. split; [lra | reflexivity].
Qed.

Lemma conditions_54 s mu S phi : is_scene s -> 1 <= mu -> 0 < friction s -> 0 < V_abs s (contact s) ->
  supremum_of_demand s S -> is_phase s phi ->
  (responds s /\ slides s phi /\ mu * friction s < Rabs (holding_friction s phi) <-> friction s < limit_69 s mu S).
Proof.
  intros Hs Hm Hb HV L P. unfold limit_69. pose proof (static_demand_pos s mu Hs Hm) as SP. pose proof (mobility_pos s Hs) as Mp.
  set (m := Rmax S (H_j s + mu * mobility s)). assert (Pm : 0 < m) by (pose proof (Rmax_r S (H_j s + mu * mobility s)); unfold
    m; lra).
  pose proof (limit_of_beta s m Pm Hb) as LB. destruct (holding_above s mu phi Hs P) as [A B].
  split.
  - intros [H [SL HH]]. apply LB. split; [exact H|].
    assert (X : friction s * (H_j s + mu * mobility s) < root s).
    { apply A. unfold Rabs in HH. destruct (Rcase_abs (holding_friction s phi)); [|exact HH].
      exfalso. apply (eq_68_excludes_58 s mu Hs Hm Hb H phi P); [lra | exact SL]. }
    unfold m, Rmax. destruct (Rle_dec S (H_j s + mu * mobility s)); [exact X|].
    destruct (supremum s S Hs L) as [Q|[t [Ht Q]]]; [nra|].
    apply Rle_lt_trans with (friction s * demand s t); [apply Rmult_le_compat_l; lra | apply (slides_iff_ s Hs phi P);
      assumption].
  - intros HL. destruct (proj2 LB (conj HV HL)) as [H X]. split; [exact H|].
    assert (X1 : friction s * S <= friction s * m) by (apply Rmult_le_compat_l; [lra | apply Rmax_l]).
    assert (X2 : friction s * (H_j s + mu * mobility s) <= friction s * m) by (apply Rmult_le_compat_l; [lra | apply Rmax_r]).
    split.
    + apply (slides_iff_ s Hs phi P). intros t Ht. destruct L as [Up _]. assert (demand s t <= S) by (apply Up; exists t; auto).
      assert (friction s * demand s t <= friction s * S) by (apply Rmult_le_compat_l; lra). lra.
    + apply Rlt_le_trans with (holding_friction s phi); [apply A; lra | apply Rle_abs].
Qed.

Theorem eq_69 : forall s, Statements.eq_69 s.
Proof.
  intros s mu S Hs Hm Hb HV L. split.
  - intros [phi [P H]]. apply (conditions_54 s mu S phi Hs Hm Hb HV L P). split; [apply (phase_responds s phi HV P) | exact H].
  - intros H. assert (Re : responds s).
    { pose proof (Rmax_r S (H_j s + mu * mobility s)). pose proof (static_demand_pos s mu Hs Hm).
      apply (limit_of_beta s (Rmax S (H_j s + mu * mobility s))); [lra | exact Hb | split; [exact HV | exact H]]. }
    destruct (some_phase s Re) as [phi P]. exists phi. split; [exact P | apply (conditions_54 s mu S phi Hs Hm Hb HV L P), H].
Qed.
