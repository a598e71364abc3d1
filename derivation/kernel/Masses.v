(* Proofs of (12)-(53) for any number of masses. *)
Require Import Reals Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes SteadyMode Sums.
Open Scope R_scope.

Theorem eq_6 : Statements.eq_6.
Proof.
  intros n m c k X X1 X2 sgn F P k1 om j l tau Hom Hk HP D E x x1 x2. split.
  - intros a. destruct (D a) as [D1 D2]. split; unfold x, x1, x2.
    + evar_last. { apply is_derive_scal. apply (is_derive_comp (X a) (fun t => t / om)); [exact D1|]. auto_derive;
      [trivial|reflexivity]. }
      unfold scal; simpl; unfold mult; simpl. field; lra.
    + evar_last. { apply is_derive_scal. apply (is_derive_comp (X1 a) (fun t => t / om)); [exact D2|]. auto_derive;
      [trivial|reflexivity]. }
      unfold scal; simpl; unfold mult; simpl. field; lra.
  - intros a Ha. replace (cos tau) with (cos (om * (tau / om))) by (f_equal; field; lra).
    apply (Rmult_eq_reg_l P); [|lra]. transitivity (P * delta a l * cos (om * (tau / om))); [|ring]. rewrite <- (E a Ha),
      Rmult_plus_distr_l.
    f_equal; [|field; lra]. rewrite <- Sum_scal. apply Sum_ext. intros b _. unfold x, x1, x2. field; lra.
Qed.

Theorem eq_8 : Statements.eq_8.
Proof.
  intros om k1 m1 mi Hom Hk Hm. rewrite Rpow_mult_distr. rewrite <- (Rsqr_pow2 (sqrt _)), Rsqr_sqrt; [field; lra|].
  apply Rlt_le, Rdiv_lt_0_compat; assumption.
Qed.

(* The angle of a point *)
Lemma sqrt_of_square a b c : 0 <= a -> a * a = b ^ 2 + c ^ 2 -> sqrt (b ^ 2 + c ^ 2) = a.
Proof. intros H E. rewrite <- E. apply sqrt_square, H. Qed.

Theorem atan2_is_the_angle : Statements.atan2_is_the_angle.
Proof.
  intros x y H.
  assert (A : forall x, 0 < x -> sqrt (x ^ 2 + y ^ 2) = x * sqrt (1 + (y / x) ^ 2)).
  { intros a Ha. apply sqrt_of_square.
    - apply Rmult_le_pos; [lra | apply sqrt_pos].
    - replace (a * sqrt (1 + (y / a) ^ 2) * (a * sqrt (1 + (y / a) ^ 2))) with (a * a * (sqrt (1 + (y / a) ^ 2) * sqrt (1 + (y /
      a) ^ 2))) by ring.
      rewrite sqrt_sqrt by nra. field; lra. }
  assert (S : forall z, 0 < sqrt (1 + z ^ 2)) by (intros z; apply sqrt_lt_R0; nra).
  assert (CS : forall z, cos (atan z) = 1 / sqrt (1 + z ^ 2) /\ sin (atan z) = z / sqrt (1 + z ^ 2)).
  { intros z. rewrite cos_atan, sin_atan. unfold Rsqr. replace (z * z) with (z ^ 2) by ring. auto. }
  unfold atan2. destruct (Rlt_dec 0 x) as [P|P].
  - rewrite (A x P). destruct (CS (y / x)) as [C1 C2]. rewrite C1, C2. pose proof (S (y / x)). split; field; lra.
  - destruct (Rlt_dec x 0) as [Q|Q].
    + specialize (A (- x) ltac:(lra)). replace ((- x) ^ 2) with (x ^ 2) in A by ring. replace ((y / - x) ^ 2) with ((y / x) ^ 2)
      in A by (field; lra).
      rewrite A. destruct (CS (y / x)) as [C1 C2]. pose proof (S (y / x)). destruct (Rle_dec 0 y).
      * rewrite neg_cos, neg_sin, C1, C2. split; field; lra.
      * replace (atan (y / x) - PI) with (- (- atan (y / x) + PI)) by ring. rewrite cos_neg, sin_neg, neg_cos, neg_sin, cos_neg,
        sin_neg, C1, C2.
        split; field; lra.
    + assert (x = 0) by lra. subst x. assert (y <> 0) by (destruct H; lra). destruct (Rlt_dec 0 y).
      * rewrite cos_PI2, sin_PI2. rewrite (sqrt_of_square y) by (try lra; ring). split; ring.
      * destruct (Rlt_dec y 0); [|lra]. rewrite cos_neg, sin_neg, cos_PI2, sin_PI2, (sqrt_of_square (- y)) by (try lra; ring).
        split; ring.
Qed.

Theorem eq_61 : Statements.eq_61.
Proof.
  intros r z H. assert (H' : 0 < (1 - r * r) ^ 2 + (2 * z * r) ^ 2)
    by (pose proof (pow2_ge_0 (1 - r * r)); pose proof (pow2_ge_0 (2 * z * r)); apply Rnot_le_lt; intro; apply H; lra). set (D
      := (1 - r * r) ^ 2 + (2 * z * r) ^ 2) in *.
  assert (E : v_re r z ^ 2 + v_im r z ^ 2 = / D) by (unfold v_re, v_im; fold D; unfold D in *; field; lra).
  assert (Hn : v_re r z <> 0 \/ v_im r z <> 0).
  { destruct (Req_dec (v_re r z) 0) as [Z|Z]; [right | left; exact Z]. intros Z'. rewrite Z, Z' in E.
    assert (/ D > 0) by (apply Rinv_0_lt_compat; lra). lra. }
  destruct (atan2_is_the_angle _ _ Hn) as [C S]. unfold v_abs. set (m := sqrt _) in *.
  assert (Hm : m * m = / D) by (unfold m; rewrite sqrt_sqrt; [exact E | nra]).
  assert (m <> 0) by (intro Z; rewrite Z in Hm; assert (/ D > 0) by (apply Rinv_0_lt_compat; lra); lra).
  split; apply (Rmult_eq_reg_l m); try assumption; [rewrite C | rewrite S].
  - replace (m * (m * (1 - r ^ 2))) with (m * m * (1 - r ^ 2)) by ring. rewrite Hm. unfold v_re. fold D. field; lra.
  - replace (m * - (m * (2 * z * r))) with (- (m * m * (2 * z * r))) by ring. rewrite Hm. unfold v_im. fold D. field; lra.
Qed.

Theorem eq_60 : Statements.eq_60.
Proof.
  intros r z pj pl b f y y1 y2 A Hl Cy Ey M. pose proof A as [Hr [_ [_ Hv]]].
  destruct (eq_26_27 r z pj pl b f y y1 y2 A Cy Ey M) as [C S]. unfold v_cos, v_sin in C, S. rewrite Rplus_0_l in C, S.
  destruct (eq_61 r z Hv) as [C1 S1]. cbv zeta.
  assert (N : v_re r z <> 0 \/ v_im r z <> 0).
  { destruct (Req_dec (v_re r z) 0) as [Z|Z]; [right | left; exact Z]. intros Z'. destruct (eq_23 r z Hv) as [E _].
    rewrite Z, Z' in E. lra. }
  destruct (atan2_is_the_angle _ _ N) as [C2 S2]. change (sqrt (v_re r z ^ 2 + v_im r z ^ 2)) with (v_abs r z) in C2, S2.
  assert (V : v_abs r z <> 0) by (intros Z; rewrite Z in C2, S2; lra).
  rewrite cos_plus, sin_plus. set (c := cos (atan2 _ _)) in *. set (d := sin (atan2 _ _)) in *.
  assert (Nz : pl * r ^ 2 * v_abs r z <> 0).
  { repeat apply Rmult_integral_contrapositive_currified; try assumption; try lra. }
  split; apply (Rmult_eq_reg_l (pl * r ^ 2 * v_abs r z)); try exact Nz.
  - replace (pl * r ^ 2 * v_abs r z * ((y 0 + pj * r ^ 2 * g r z * b) / (pl * r ^ 2 * v_abs r z))) with (y 0 + pj * r ^ 2 * g r
    z * b)
      by (field; repeat split; try assumption; lra). rewrite <- C, <- C2, <- S2. ring.
  - replace (pl * r ^ 2 * v_abs r z * - ((y1 0 + pj * r ^ 2 * u r z * b) / (pl * r ^ 2 * v_abs r z))) with (- (y1 0 + pj * r ^ 2
    * u r
      z * b)) by (field; repeat split; try assumption; lra). rewrite <- S, <- C2, <- S2. ring.
Qed.

(* A time between 0 and pi at which the cosine is 1 or -1 *)
Lemma extreme_cosine f : exists t, 0 <= t <= PI /\ Rabs (cos (t - f)) = 1.
Proof.
  pose proof PI_RGT_0 as P. destruct (archimed (- (f / PI))) as [U1 U2]. set (n := up (- (f / PI))) in *.
  exists (f + IZR n * PI). assert (F : f = f / PI * PI) by (field; lra). split; [split|].
  - assert (0 < (f / PI + IZR n) * PI) by (apply Rmult_lt_0_compat; lra). lra.
  - assert ((f / PI + IZR n) * PI <= 1 * PI) by (apply Rmult_le_compat_r; lra). lra.
  - replace (f + IZR n * PI - f) with (IZR n * PI) by ring. pose proof (sin2_cos2 (IZR n * PI)) as Q.
    rewrite (sin_eq_0_1 (IZR n * PI)) in Q by (exists n; reflexivity). unfold Rsqr in Q.
    assert (D : (cos (IZR n * PI) - 1) * (cos (IZR n * PI) + 1) = 0) by lra. apply Rmult_integral in D. unfold Rabs.
    destruct (Rcase_abs _); lra.
Qed.
Theorem eq_47 : Statements.eq_47.
Proof.
  intros X f pj tau HX Ht H phi_k. destruct (extreme_cosine f) as [t [Hit E]]. specialize (H t Hit).
  rewrite !Rabs_mult, E in H. assert (A : 1 <= Rabs (cos (tau - f))) by (rewrite (Rabs_right X) in H by lra; nra).
  pose proof (COS_bound (tau - f)) as B. pose proof (sin2_cos2 (tau - f)) as Q. unfold Rsqr in Q.
  assert (S : sin (tau - f) = 0) by (unfold Rabs in A; destruct (Rcase_abs _); nra).
  assert (T : forall c, pj + tau + c = pj + f + ((tau - f) + c)) by (intros; ring). unfold phi_k.
  destruct (Rle_dec 0 (X * cos (tau - f))) as [P|P].
  - assert (C : cos (tau - f) = 1) by (unfold Rabs in A; destruct (Rcase_abs _); nra).
    replace (pj + tau) with (pj + f + (tau - f)) by ring. set (q := pj + f). rewrite (cos_plus q), (sin_plus q), C, S. split;
      ring.
  - assert (C : cos (tau - f) = -1) by (unfold Rabs in A; destruct (Rcase_abs _); nra).
    rewrite (T PI). set (q := pj + f). rewrite (cos_plus q), (sin_plus q), neg_cos, neg_sin, C, S. split; ring.
Qed.

Theorem eq_1 : Statements.eq_1.
Proof.
  intros n k x a Ha. unfold chain_stiffness.
  rewrite (Sum_ext n _ (fun b => delta b a * ((k a + spring_after n k a) * x b) - delta b (S a) * (spring_after n k a * x b) - k
    a *
    (delta a (S b) * x b))) by (intros; rewrite (delta_sym a i); ring).
  rewrite !Sum_minus, Sum_scal, (Sum_delta n a (fun b => (k a + spring_after n k a) * x b) Ha).
  assert (A : Sum n (fun b => delta b (S a) * (spring_after n k a * x b)) = spring_after n k a * x (S a)).
  { destruct (Nat.ltb_spec (S a) n) as [L|L]; [apply (Sum_delta n (S a) (fun b => spring_after n k a * x b) L)|].
    unfold spring_after. destruct (Nat.ltb_spec (S a) n); [lia|]. rewrite Rmult_0_l. apply Sum_zero. intros; ring. }
  assert (B : Sum n (fun b => delta a (S b) * x b) = match a with O => 0 | S p => x p end).
  { destruct a as [|p]; [apply Sum_zero; intros; rewrite delta_other by lia; ring|].
    rewrite <- (Sum_delta n p x) by lia. apply Sum_ext. intros b _. f_equal. unfold delta.
    destruct (Nat.eqb_spec (S p) (S b)), (Nat.eqb_spec b p); try reflexivity; lia. }
  rewrite A, B. ring.
Qed.
Theorem eq_73 : Statements.eq_73.
Proof.
  intros n k k1 a b Hk. unfold chain_stiffness, spring_after. destruct (Nat.ltb (S a) n); field; lra.
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

Lemma Hj : (j < N)%nat. Proof. apply Hs. Qed.
Lemma Hl : (l < N)%nat. Proof. apply Hs. Qed.
Lemma Hadm i : (i < N)%nat -> admissible (R_ i) (zeta i). Proof. apply Hs. Qed.
Lemma Hratio i : (i < N)%nat -> 0 < R_ i. Proof. intros H. apply (Hadm i H). Qed.

(* M Psi, and Psi^T M *)
Definition MP a i := Sum N (fun c => M a c * psi c i).
Definition W i a := Sum N (fun c => psi c i * M c a).
Definition modal (f : nat -> R) i := Sum N (fun a => W i a * f a).

Lemma complete_1 a b : (a < N)%nat -> (b < N)%nat -> Sum N (fun i => MP a i * psi b i) = delta a b.
Proof.
  apply (other_inverse N (fun i a => psi a i) (fun a i => MP a i)). intros i k Hi Hk.
  destruct Hs as [_ [_ [_ [_ [H _]]]]]. apply (H i k Hi Hk).
Qed.
Lemma W_psi i k : (i < N)%nat -> (k < N)%nat -> Sum N (fun a => W i a * psi a k) = delta i k.
Proof.
  intros Hi Hk. destruct Hs as [_ [_ [_ [_ [H _]]]]]. rewrite <- (H i k Hi Hk). unfold W.
  rewrite (Sum_ext N _ (fun a => Sum N (fun c => psi c i * (M c a * psi a k)))) by (intros; rewrite <- Sum_scal_r; apply
    Sum_ext; intros; ring).
  rewrite Sum_swap. apply Sum_ext. intros. apply Sum_scal.
Qed.
Lemma psi_W a b : (a < N)%nat -> (b < N)%nat -> Sum N (fun i => psi a i * W i b) = delta a b.
Proof. apply (other_inverse N W psi). exact W_psi. Qed.

Lemma W_is_MP i b : (i < N)%nat -> (b < N)%nat -> W i b = MP b i.
Proof.
  intros Hi Hb. destruct Hs as [_ [_ [_ [_ [H _]]]]].
  transitivity (Sum N (fun a => MP a i * delta a b)); [|apply (Sum_delta_r N b (fun a => MP a i) Hb)].
  transitivity (Sum N (fun k => delta k i * W k b)); [symmetry; apply (Sum_delta N i (fun k => W k b) Hi)|].
  rewrite (Sum_ext N (fun a => MP a i * delta a b) (fun a => Sum N (fun k => MP a i * psi a k * W k b))).
  - rewrite Sum_swap. apply Sum_ext. intros k Hk. rewrite Sum_scal_r. f_equal. rewrite <- (H k i Hk Hi).
    apply Sum_ext. intros a Ha. unfold MP. ring.
  - intros a Ha. rewrite <- (psi_W a b Ha Hb), <- Sum_scal. apply Sum_ext. intros; ring.
Qed.

Lemma damping_of_mode a k : (a < N)%nat -> (k < N)%nat -> Sum N (fun b => C a b * psi b k) = 2 * zeta k / R_ k * MP a k.
Proof.
  intros Ha Hk. destruct Hs as [_ [_ [_ [_ [_ H]]]]].
  transitivity (Sum N (fun c => delta c a * Sum N (fun b => C c b * psi b k))); [symmetry; apply (Sum_delta N a (fun c => Sum N
    (fun b => C c b * psi b k)) Ha)|].
  rewrite (Sum_ext N _ (fun c => Sum N (fun i => MP a i * (psi c i * Sum N (fun b => C c b * psi b k))))).
  - rewrite Sum_swap. rewrite (Sum_ext N _ (fun i => delta i k * (2 * zeta i / R_ i * MP a i))).
    + apply (Sum_delta N k (fun i => 2 * zeta i / R_ i * MP a i) Hk).
    + intros i Hi. rewrite Sum_scal, (H i k Hi Hk). ring.
  - intros c Hc. rewrite delta_sym, <- (complete_1 a c Ha Hc), <- Sum_scal_r. apply Sum_ext. intros; ring.
Qed.

Lemma stiffness_of_mode a i : (a < N)%nat -> (i < N)%nat -> Sum N (fun b => K a b * psi b i) = / R_ i ^ 2 * MP a i.
Proof. intros Ha Hi. destruct Hs as [_ [_ [_ [H _]]]]. apply (H i a Hi Ha). Qed.

Lemma applied (A : nat -> nat -> R) a f : Sum N (fun b => A a b * Sum N (fun i => psi b i * f i)) = Sum N (fun i => Sum N (fun b
  => A a b * psi b i) * f i).
Proof.
  rewrite (Sum_ext N _ (fun b => Sum N (fun i => A a b * psi b i * f i))) by (intros; rewrite <- Sum_scal; apply Sum_ext;
    intros; ring).
  rewrite Sum_swap. apply Sum_ext. intros. apply Sum_scal_r.
Qed.

(* A row of M x'' + C x' + K x for x = Psi f *)
Lemma row a f2 f1 f0 : (a < N)%nat ->
  Sum N (fun b => M a b * Sum N (fun i => psi b i * f2 i) + C a b * Sum N (fun i => psi b i * f1 i) + K a b * Sum N (fun i =>
    psi b i * f0 i))
  = Sum N (fun i => MP a i * (f2 i + 2 * zeta i / R_ i * f1 i + / R_ i ^ 2 * f0 i)).
Proof.
  intros Ha. rewrite !Sum_plus, !applied, <- !Sum_plus. apply Sum_ext. intros i Hi.
  rewrite damping_of_mode, stiffness_of_mode by assumption. unfold MP. ring.
Qed.

Lemma physical f a : (a < N)%nat -> f a = Sum N (fun i => psi a i * modal f i).
Proof.
  intros Ha. unfold modal. rewrite (Sum_ext N _ (fun i => Sum N (fun b => psi a i * W i b * f b))) by (intros; rewrite <-
    Sum_scal; apply Sum_ext; intros; ring).
  rewrite Sum_swap. rewrite (Sum_ext N _ (fun b => delta b a * f b)) by (intros; rewrite Sum_scal_r, psi_W, delta_sym by
    assumption; reflexivity).
  symmetry. apply Sum_delta, Ha.
Qed.

(* The rows of the equation of motion, each mode by itself *)
Lemma modal_rows Y2 Y1 Y0 r : (forall a, (a < N)%nat -> Sum N (fun b => M a b * Y2 b + C a b * Y1 b + K a b * Y0 b) = r a) ->
  forall i, (i < N)%nat -> modal Y2 i + 2 * zeta i / R_ i * modal Y1 i + / R_ i ^ 2 * modal Y0 i = Sum N (fun a => psi a i * r a).
Proof.
  intros H i Hi. set (e := fun i => modal Y2 i + 2 * zeta i / R_ i * modal Y1 i + / R_ i ^ 2 * modal Y0 i). change (e i = Sum N
    (fun a => psi a i * r a)).
  assert (E : forall a, (a < N)%nat -> r a = Sum N (fun k => MP a k * e k)).
  { intros a Ha. rewrite <- (H a Ha). unfold e. rewrite <- row by exact Ha. apply Sum_ext. intros b Hb.
    rewrite <- !physical by exact Hb. reflexivity. }
  rewrite (Sum_ext N _ (fun a => Sum N (fun k => psi a i * MP a k * e k))) by (intros; rewrite E, <- Sum_scal by assumption;
    apply Sum_ext; intros; ring).
  rewrite Sum_swap. destruct Hs as [_ [_ [_ [_ [O _]]]]].
  rewrite (Sum_ext N _ (fun k => delta k i * e k)); [symmetry; apply Sum_delta, Hi|].
  intros k Hk. rewrite Sum_scal_r, (delta_sym k i), <- (O i k Hi Hk). reflexivity.
Qed.

Lemma modes_are_complete_ a b : (a < N)%nat -> (b < N)%nat ->
  Sum N (fun i => Sum N (fun c => M a c * psi c i) * psi b i) = delta a b /\
  Sum N (fun c => Sum N (fun i => psi a i * psi c i) * M c b) = delta a b.
Proof.
  intros Ha Hb. split; [apply (complete_1 a b Ha Hb)|].
  rewrite (Sum_ext N _ (fun c => Sum N (fun i => psi a i * psi c i * M c b))) by (intros; symmetry; apply Sum_scal_r).
  rewrite Sum_swap, <- (psi_W a b Ha Hb). apply Sum_ext. intros i Hi. unfold W. rewrite <- Sum_scal. apply Sum_ext. intros; ring.
Qed.

Lemma eq_19_ a b : (a < N)%nat -> (b < N)%nat ->
  C a b = Sum N (fun i => 2 * zeta i / R_ i * Sum N (fun c => M a c * psi c i) * Sum N (fun c => M b c * psi c i)).
Proof.
  intros Ha Hb. transitivity (Sum N (fun c => C a c * delta c b)); [symmetry; apply (Sum_delta_r N b (C a) Hb)|].
  rewrite (Sum_ext N _ (fun c => C a c * Sum N (fun i => psi c i * W i b))) by (intros; rewrite psi_W by assumption; reflexivity).
  rewrite applied. apply Sum_ext. intros i Hi. rewrite damping_of_mode, W_is_MP by assumption. unfold MP. ring.
Qed.

(* The modal coordinates of a motion of (12) *)
Lemma modal_derive (f h : nat -> R -> R) t i : (forall a, (a < N)%nat -> is_derive (f a) t (h a t)) ->
  is_derive (fun t => modal (fun a => f a t) i) t (modal (fun a => h a t) i).
Proof. intros H. unfold modal. apply (is_derive_Sum N (fun a t => W i a * f a t) (fun a t => W i a * h a t)). intros a Ha. apply
  is_derive_scal, H, Ha. Qed.
Lemma modal_continuous (f : nat -> R -> R) t i : (forall a, (a < N)%nat -> continuous (f a) t) -> continuous (fun t => modal
  (fun a => f a t) i) t.
Proof. intros H. unfold modal. apply (continuous_Sum N (fun a t => W i a * f a t)). intros a Ha. apply continuous_scaled, H, Ha.
  Qed.

Lemma load_on_modes i c : (i < N)%nat -> Sum N (fun a => psi a i * (delta a j * beta + delta a l * c)) = psi j i * beta + psi l
  i * c.
Proof.
  intros Hi. rewrite (Sum_ext N _ (fun a => delta a j * (psi a i * beta) + delta a l * (psi a i * c))) by (intros; ring).
  rewrite Sum_plus, (Sum_delta N j (fun a => psi a i * beta)), (Sum_delta N l (fun a => psi a i * c)) by (apply Hj || apply Hl).
    reflexivity.
Qed.

Lemma modal_motion phi y y1 y2 i : half_period_motion s phi y y1 y2 -> (i < N)%nat ->
  modal_equation (R_ i) (zeta i) (psi j i) (psi l i) beta phi (fun t => modal (fun a => y a t) i) (fun t => modal (fun a => y1 a
    t) i) (fun t => modal (fun a => y2 a t) i).
Proof.
  intros H Hi t Ht. pose proof (Hratio i Hi). split; [|split].
  - apply modal_derive. intros a Ha. apply (H t Ht a Ha).
  - apply modal_derive. intros a Ha. apply (H t Ht a Ha).
  - rewrite <- (load_on_modes i (cos (t + phi)) Hi).
    rewrite <- (modal_rows (fun a => y2 a t) (fun a => y1 a t) (fun a => y a t)); [field; lra | | exact Hi].
    intros a Ha. apply (H t Ht a Ha).
Qed.

Lemma eq_16_20_ phi y y1 y2 : half_period_motion s phi y y1 y2 ->
  let md := fun (f : nat -> R -> R) i t => Sum N (fun a => Sum N (fun c => psi c i * M c a) * f a t) in
  (forall i, (i < N)%nat -> modal_equation (R_ i) (zeta i) (psi j i) (psi l i) beta phi (md y i) (md y1 i) (md y2 i)) /\
  (forall k t, (k < N)%nat -> y k t = Sum N (fun i => psi k i * md y i t) /\ y1 k t = Sum N (fun i => psi k i * md y1 i t)).
Proof.
  intros H md. split.
  - intros i Hi. apply (modal_motion phi y y1 y2 i H Hi).
  - intros k t Hk. split; [apply (physical (fun a => y a t) k Hk) | apply (physical (fun a => y1 a t) k Hk)].
Qed.

Lemma modal_mirrored (y y1 : nat -> R -> R) i : (forall k, (k < N)%nat -> mirrored (y k) (y1 k)) ->
  mirrored (fun t => modal (fun a => y a t) i) (fun t => modal (fun a => y1 a t) i).
Proof.
  intros H. unfold mirrored, modal. rewrite <- !Sum_opp. split; apply Sum_ext; intros a Ha; destruct (H a Ha) as [E1 E2];
    rewrite ?E1, ?E2; ring.
Qed.
Lemma modal_continuous_half (y y1 : nat -> R -> R) i : (forall a, (a < N)%nat -> continuous_on_half_period (y a) (y1 a)) ->
  continuous_on_half_period (fun t => modal (fun a => y a t) i) (fun t => modal (fun a => y1 a t) i).
Proof. intros H t Ht. split; apply modal_continuous; intros a Ha; apply (H a Ha t Ht). Qed.

Lemma superposition_cos k phi t : Sum N (fun i => psi k i * (psi l i * R_ i ^ 2 * v_cos (R_ i) (zeta i) phi t)) = V_re s k * cos
  (t + phi) - V_im s k * sin (t + phi).
Proof. unfold V_re, V_im, v_cos. rewrite <- !Sum_scal_r, <- Sum_minus. apply Sum_ext. intros; ring. Qed.
Lemma superposition_sin k phi t : Sum N (fun i => psi k i * (psi l i * R_ i ^ 2 * v_sin (R_ i) (zeta i) phi t)) = V_re s k * sin
  (t + phi) + V_im s k * cos (t + phi).
Proof. unfold V_re, V_im, v_sin. rewrite <- !Sum_scal_r, <- Sum_plus. apply Sum_ext. intros; ring. Qed.

Lemma initial_values phi y y1 y2 : (forall a, (a < N)%nat -> continuous_on_half_period (y a) (y1 a)) -> half_period_motion s phi
  y y1 y2 ->
  (forall k, (k < N)%nat -> mirrored (y k) (y1 k)) -> forall k, (k < N)%nat ->
  V_re s k * cos phi - V_im s k * sin phi = y k 0 + beta * G s k /\ V_re s k * sin phi + V_im s k * cos phi = - (y1 k 0 + beta *
    U s k).
Proof.
  intros Cy H Mi k Hk.
  assert (E : forall i, (i < N)%nat ->
    psi l i * R_ i ^ 2 * v_cos (R_ i) (zeta i) phi 0 = modal (fun a => y a 0) i + psi j i * R_ i ^ 2 * g (R_ i) (zeta i) * beta /\
    psi l i * R_ i ^ 2 * v_sin (R_ i) (zeta i) phi 0 = - (modal (fun a => y1 a 0) i + psi j i * R_ i ^ 2 * u (R_ i) (zeta i) *
      beta)).
  { intros i Hi. apply (eq_26_27 _ _ _ _ _ _ (fun t => modal (fun a => y a t) i) (fun t => modal (fun a => y1 a t) i) (fun t =>
    modal (fun a => y2 a t) i)).
    - apply Hadm, Hi.
    - apply modal_continuous_half, Cy.
    - apply modal_motion; assumption.
    - apply modal_mirrored, Mi. }
  rewrite (physical (fun a => y a 0) k Hk), (physical (fun a => y1 a 0) k Hk).
  rewrite <- (Rplus_0_l phi), <- superposition_cos, <- superposition_sin. unfold G, U.
  rewrite <- !Sum_scal, <- !Sum_plus, <- Sum_opp. split; apply Sum_ext; intros i Hi; destruct (E i Hi) as [E1 E2]; rewrite ?E1,
    ?E2; ring.
Qed.

(* x and its rate *)
Lemma x_derive phi k t : is_derive (x s phi k) t (x_prime s phi k t).
Proof.
  unfold x, x_prime. 
  apply (is_derive_Sum N (fun i t => psi k i * eta (R_ i) (zeta i) (psi j i) (psi l i) beta phi t)
    (fun i t => psi k i * eta_prime (R_ i) (zeta i) (psi j i) (psi l i) beta phi t)).
  intros i Hi. pose proof (Hadm i Hi) as [A [B _]]. apply is_derive_scal, eta_rate; assumption.
Qed.
Definition x_second phi k t := Sum N (fun i => psi k i * eta_second (R_ i) (zeta i) (psi j i) (psi l i) beta phi t).
Lemma x_prime_derive phi k t : is_derive (x_prime s phi k) t (x_second phi k t).
Proof.
  apply (is_derive_Sum N (fun i t => psi k i * eta_prime (R_ i) (zeta i) (psi j i) (psi l i) beta phi t)
    (fun i t => psi k i * eta_second (R_ i) (zeta i) (psi j i) (psi l i) beta phi t)).
  intros i Hi. pose proof (Hadm i Hi) as [A [B _]]. apply is_derive_scal, eta_prime_rate; assumption.
Qed.
Lemma x_equation phi a t : (a < N)%nat ->
  Sum N (fun b => M a b * x_second phi b t + C a b * x_prime s phi b t + K a b * x s phi b t) = delta a j * beta + delta a l *
    cos (t + phi).
Proof.
  intros Ha. unfold x_second, x_prime, x. rewrite row by exact Ha.
  rewrite (Sum_ext N _ (fun i => beta * (MP a i * psi j i) + cos (t + phi) * (MP a i * psi l i))).
  - rewrite Sum_plus, !Sum_scal, !complete_1 by (exact Ha || apply Hj || apply Hl). ring.
  - intros i Hi. pose proof (Hratio i Hi). pose proof (eta_equation (R_ i) (zeta i) (psi j i) (psi l i) beta phi t (Hadm i Hi))
    as E.
    replace (eta_second (R_ i) (zeta i) (psi j i) (psi l i) beta phi t + 2 * zeta i / R_ i * eta_prime (R_ i) (zeta i) (psi j i)
      (psi l i) beta phi t
      + / R_ i ^ 2 * eta (R_ i) (zeta i) (psi j i) (psi l i) beta phi t) with (psi j i * beta + psi l i * cos (t + phi)); [ring|].
    apply (Rmult_eq_reg_l (R_ i ^ 2)); [|apply pow_nonzero; lra]. rewrite <- E. field; lra.
Qed.
Lemma x_mirrored phi k : mirrored (x s phi k) (x_prime s phi k).
Proof.
  unfold mirrored, x, x_prime. rewrite <- !Sum_opp. split; apply Sum_ext; intros i Hi;
  destruct (eta_mirrored (R_ i) (zeta i) (psi j i) (psi l i) beta phi (Hadm i Hi)) as [E1 E2]; rewrite ?E1, ?E2; ring.
Qed.
Lemma x_half phi : half_period_motion s phi (x s phi) (x_prime s phi) (x_second phi).
Proof. intros t Ht a Ha. split; [apply x_derive | split; [apply x_prime_derive | apply x_equation, Ha]]. Qed.
Lemma x_continuous phi k : continuous_on_half_period (x s phi k) (x_prime s phi k).
Proof. intros t _. split; eapply continuous_of_derive; [apply x_derive | apply x_prime_derive]. Qed.

Lemma x_initial phi k : (k < N)%nat ->
  V_re s k * cos phi - V_im s k * sin phi = x s phi k 0 + beta * G s k /\ V_re s k * sin phi + V_im s k * cos phi = - (x_prime s
    phi k 0 + beta * U s k).
Proof.
  intros Hk. apply (initial_values phi (x s phi) (x_prime s phi) (x_second phi)); [| apply x_half | | exact Hk].
  - intros a _. apply x_continuous.
  - intros a _. apply x_mirrored.
Qed.

Lemma x_form phi k t : x s phi k t = V_re s k * cos (t + phi) - V_im s k * sin (t + phi) + beta * friction_motion s k t.
Proof. rewrite <- superposition_cos. unfold x, friction_motion. rewrite <- Sum_scal, <- Sum_plus. apply Sum_ext. intros; unfold
  eta. ring. Qed.

Lemma unique phi y y1 y2 : (forall a, (a < N)%nat -> continuous_on_half_period (y a) (y1 a)) -> half_period_motion s phi y y1 y2
  ->
  (forall k, (k < N)%nat -> mirrored (y k) (y1 k)) -> forall k t, (k < N)%nat -> 0 <= t <= PI -> y k t = x s phi k t /\ y1 k t =
    x_prime s phi k t.
Proof.
  intros Cy H Mi k t Hk Ht.
  rewrite (physical (fun a => y a t) k Hk), (physical (fun a => y1 a t) k Hk). unfold x, x_prime.
  assert (E : forall i, (i < N)%nat -> modal (fun a => y a t) i = eta (R_ i) (zeta i) (psi j i) (psi l i) beta phi t /\
    modal (fun a => y1 a t) i = eta_prime (R_ i) (zeta i) (psi j i) (psi l i) beta phi t).
  { intros i Hi. apply (mode_has_no_other _ _ _ _ _ _ (Hadm i Hi) (fun t => modal (fun a => y a t) i) (fun t => modal (fun a =>
    y1 a t) i) (fun t => modal (fun a => y2 a t) i)).
    - apply modal_continuous_half, Cy.
    - apply modal_motion; assumption.
    - apply modal_mirrored, Mi.
    - exact Ht. }
  split; apply Sum_ext; intros i Hi; destruct (E i Hi) as [E1 E2]; rewrite ?E1, ?E2; reflexivity.
Qed.
End Scene.

Theorem modes_are_complete : forall s, Statements.modes_are_complete s.
Proof. intros s H. apply (modes_are_complete_ s H). Qed.
Theorem eq_19 : forall s, Statements.eq_19 s.
Proof. intros s H. apply (eq_19_ s H). Qed.
Theorem eq_16_20 : forall s, Statements.eq_16_20 s.
Proof. intros s H. apply (eq_16_20_ s H). Qed.
Theorem eq_31_32_42_43 : forall s, Statements.eq_31_32_42_43 s.
Proof. intros s H. apply (initial_values s H). Qed.

(* The root of (38) *)
Lemma V_abs_sq s k : V_abs s k ^ 2 = V_re s k ^ 2 + V_im s k ^ 2.
Proof. unfold V_abs. rewrite <- Rsqr_pow2, Rsqr_sqrt; [reflexivity | nra]. Qed.
Lemma root_sq s : responds s -> root s ^ 2 = V_abs s (contact s) ^ 2 - (friction s * U s (contact s)) ^ 2.
Proof.
  intros [HV HU]. unfold root. rewrite <- (Rsqr_pow2 (sqrt _)), Rsqr_sqrt; [reflexivity|].
  pose proof (Rabs_pos (friction s * U s (contact s))). rewrite <- (pow2_abs (friction s * U s (contact s))). nra.
Qed.
Lemma root_pos s : 0 <= root s.
Proof. apply sqrt_pos. Qed.
Lemma root_of_sum s : X_j s + friction s * G s (contact s) = root s.
Proof. unfold X_j. ring. Qed.

Lemma argument s k : 0 < V_abs s k -> V_abs s k * cos (V_arg s k) = V_re s k /\ V_abs s k * sin (V_arg s k) = V_im s k.
Proof.
  intros H. apply atan2_is_the_angle. pose proof (V_abs_sq s k). 
  destruct (Req_dec (V_re s k) 0) as [Z|Z]; [right | left; exact Z]. intros Z'. rewrite Z, Z' in H0. nra.
Qed.
Lemma argument_all s k : V_abs s k * cos (V_arg s k) = V_re s k /\ V_abs s k * sin (V_arg s k) = V_im s k.
Proof.
  pose proof (sqrt_pos (V_re s k ^ 2 + V_im s k ^ 2)) as P. change (0 <= V_abs s k) in P. destruct P as [P|P]; [apply argument,
    P|].
  pose proof (V_abs_sq s k) as E. rewrite <- P in *. assert (V_re s k = 0) by nra. assert (V_im s k = 0) by nra. lra.
Qed.

Lemma phase_by_argument s phi : responds s -> (is_phase s phi <->
  V_abs s (contact s) * cos (phi + V_arg s (contact s)) = root s /\
  V_abs s (contact s) * sin (phi + V_arg s (contact s)) = - (friction s * U s (contact s))).
Proof.
  intros [HV _]. destruct (argument s (contact s) HV) as [C S]. unfold is_phase. rewrite cos_plus, sin_plus, <- C, <- S.
  split; intros [E1 E2]; split; [rewrite <- E1 | rewrite <- E2 | rewrite <- E1 | rewrite <- E2]; ring.
Qed.

Theorem eq_36_37 : forall s, Statements.eq_36_37 s.
Proof.
  intros s _ H phi P. apply phase_by_argument in P; [|exact H]. destruct P as [P1 P2]. destruct H as [HV _]. rewrite root_of_sum.
  split; apply (Rmult_eq_reg_l (V_abs s (contact s))); try lra; [rewrite P1 | rewrite P2]; field; lra.
Qed.

Lemma full_turns a b : cos a = cos b -> sin a = sin b -> exists turns : Z, b = a + 2 * PI * IZR turns.
Proof.
  intros C S. assert (E : cos (b - a) = 1).
  { rewrite cos_minus, C, S. pose proof (sin2_cos2 b) as T. unfold Rsqr in T. lra. }
  assert (Z : sin ((b - a) / 2) = 0).
  { replace (b - a) with (2 * ((b - a) / 2)) in E by field. rewrite cos_2a_sin in E. nra. }
  apply sin_eq_0_0 in Z. destruct Z as [k Hk]. exists k. lra.
Qed.

Theorem eq_39 : forall s, Statements.eq_39 s.
Proof.
  intros s H. pose proof H as [HV HU]. pose proof (root_sq s H) as RS. pose proof (root_pos s) as RP. split.
  - apply phase_by_argument; [exact H|].
    set (V := V_abs s (contact s)) in *. set (b := friction s * U s (contact s)) in *. set (a := V_arg s (contact s)).
    replace (atan2 (- (b / V)) (sqrt (1 - (b / V) ^ 2)) - a + a) with (atan2 (- (b / V)) (sqrt (1 - (b / V) ^ 2))) by ring.
    assert (Q : sqrt (1 - (b / V) ^ 2) = root s / V).
    { replace (1 - (b / V) ^ 2) with ((root s / V) * (root s / V)); [apply sqrt_square, Rmult_le_pos; [exact RP | apply Rlt_le,
      Rinv_0_lt_compat, HV]|].
      replace ((b / V) ^ 2) with (b ^ 2 / V ^ 2) by (field; lra). replace (root s / V * (root s / V)) with (root s ^ 2 / V ^ 2)
        by (field; lra). rewrite RS. field; lra. }
    rewrite Q.
    destruct (atan2_is_the_angle (root s / V) (- (b / V))) as [A1 A2].
    { destruct (Req_dec (root s / V) 0) as [Z|Z]; [right | left; exact Z]. intros Z'.
      assert (b = 0) by (apply (Rmult_eq_reg_r (/ V)); [unfold Rdiv in Z'; lra | apply Rinv_neq_0_compat; lra]).
      assert (root s = 0) by (apply (Rmult_eq_reg_r (/ V)); [unfold Rdiv in Z; lra | apply Rinv_neq_0_compat; lra]). nra. }
    replace (sqrt ((root s / V) ^ 2 + (- (b / V)) ^ 2)) with 1 in *.
    + rewrite Rmult_1_l in A1, A2. rewrite A1, A2. split; field; lra.
    + symmetry. apply sqrt_of_square; [lra|]. replace ((root s / V) ^ 2 + (- (b / V)) ^ 2) with ((root s ^ 2 + b ^ 2) / V ^ 2)
      by (field; lra). rewrite RS. field; lra.
  - intros phi phi' P P'. apply phase_by_argument in P; [|exact H]. apply phase_by_argument in P'; [|exact H].
    destruct P as [P1 P2], P' as [Q1 Q2].
    destruct (full_turns (phi + V_arg s (contact s)) (phi' + V_arg s (contact s))) as [k Hk].
    + apply (Rmult_eq_reg_l (V_abs s (contact s))); lra.
    + apply (Rmult_eq_reg_l (V_abs s (contact s))); lra.
    + exists k. lra.
Qed.

Theorem steady_motion : forall s, Statements.steady_motion s.
Proof.
  intros s Hs H phi [P1 P2]. exists (x_second s phi).
  destruct (x_initial s Hs phi (contact s) (Hj s Hs)) as [E1 E2]. split; [split; [|split; [|split]]|].
  - intros a _. apply x_continuous, Hs.
  - apply x_half, Hs.
  - intros k _. apply x_mirrored, Hs.
  - lra.
  - unfold X_j. lra.
Qed.

Lemma circle a b phi : (a * cos phi - b * sin phi) ^ 2 + (a * sin phi + b * cos phi) ^ 2 = a ^ 2 + b ^ 2.
Proof. pose proof (sin2_cos2 phi) as T. unfold Rsqr in T. set (c := cos phi) in *. set (d := sin phi) in *. assert (T' : d * d =
  1 - c * c) by lra. ring [T']. Qed.

Theorem no_other_motion : forall s, Statements.no_other_motion s.
Proof.
  intros s Hs H phi y y1 y2 [Cy [Hm [Mi V0]]] Hp.
  destruct (initial_values s Hs phi y y1 y2 Cy Hm Mi (contact s) (Hj s Hs)) as [E1 E2]. rewrite V0, Rplus_0_l in E2.
  pose proof (root_sq s H) as RS. pose proof (root_pos s) as RP. pose proof (V_abs_sq s (contact s)) as VS.
  pose proof (circle (V_re s (contact s)) (V_im s (contact s)) phi) as CI. rewrite E1, E2 in CI.
  assert (Q : y (contact s) 0 + friction s * G s (contact s) = root s) by nra.
  split; [|split].
  - unfold is_phase. rewrite E1, E2. split; [exact Q | reflexivity].
  - unfold X_j. lra.
  - intros k t Hk Ht. apply (unique s Hs phi y y1 y2); assumption.
Qed.

Theorem no_motion_without_root : forall s, Statements.no_motion_without_root s.
Proof.
  intros s Hs HV phi y y1 y2 [Cy [Hm [Mi V0]]].
  destruct (initial_values s Hs phi y y1 y2 Cy Hm Mi (contact s) (Hj s Hs)) as [E1 E2]. rewrite V0, Rplus_0_l in E2.
  pose proof (circle (V_re s (contact s)) (V_im s (contact s)) phi) as CI. rewrite E1, E2 in CI.
  pose proof (V_abs_sq s (contact s)) as VS. assert (0 <= V_abs s (contact s)) by apply sqrt_pos.
  pose proof (pow2_abs (friction s * U s (contact s))) as A.
  replace ((- (friction s * U s (contact s))) ^ 2) with ((friction s * U s (contact s)) ^ 2) in CI by ring.
  assert (V_abs s (contact s) ^ 2 < Rabs (friction s * U s (contact s)) ^ 2) by nra.
  pose proof (pow2_ge_0 (y (contact s) 0 + friction s * G s (contact s))). lra.
Qed.

Theorem eq_41 : forall s, Statements.eq_41 s.
Proof.
  intros s Hs _ phi _ k t Hk. destruct (x_initial s Hs phi k Hk) as [E1 E2].
  rewrite x_form by exact Hs. rewrite <- E1. replace (x_prime s phi k 0 + friction s * U s k) with (- (V_re s k * sin phi + V_im
    s k * cos phi)) by lra.
  rewrite cos_plus, sin_plus. ring.
Qed.

Lemma turned s phi k t : responds s -> is_phase s phi -> let D := V_arg s k - V_arg s (contact s) in
  V_re s k * cos (t + phi) - V_im s k * sin (t + phi) =
    V_abs s k / V_abs s (contact s) * (root s * cos (t + D) + friction s * U s (contact s) * sin (t + D)) /\
  V_re s k * sin (t + phi) + V_im s k * cos (t + phi) =
    V_abs s k / V_abs s (contact s) * (root s * sin (t + D) - friction s * U s (contact s) * cos (t + D)).
Proof.
  intros H P D. apply phase_by_argument in P; [|exact H]. destruct P as [P1 P2]. destruct H as [HV _].
  destruct (argument_all s k) as [C S]. rewrite <- P1.
  replace (friction s * U s (contact s)) with (- (V_abs s (contact s) * sin (phi + V_arg s (contact s)))) by lra. rewrite <- C,
    <- S.
  assert (A : t + phi + V_arg s k = t + D + (phi + V_arg s (contact s))) by (unfold D; ring).
  split.
  - transitivity (V_abs s k * cos (t + phi + V_arg s k)); [rewrite (cos_plus (t + phi)); ring|]. rewrite A, (cos_plus (t + D)).
    field; lra.
  - transitivity (V_abs s k * sin (t + phi + V_arg s k)); [rewrite (sin_plus (t + phi)); ring|]. rewrite A, (sin_plus (t + D)).
    field; lra.
Qed.

Theorem eq_46 : forall s, Statements.eq_46 s.
Proof.
  intros s Hs H phi P k t Hk D. rewrite x_form by exact Hs. destruct (turned s phi k t H P) as [E _]. rewrite E. reflexivity.
Qed.
Theorem eq_44_45 : forall s, Statements.eq_44_45 s.
Proof.
  intros s Hs H phi P k Hk D. destruct (turned s phi k 0 H P) as [T1 T2]. rewrite !Rplus_0_l in T1, T2. fold D in T1, T2.
  destruct (x_initial s Hs phi k Hk) as [E1 E2]. split; [rewrite E1 in T1 | rewrite E2 in T2]; lra.
Qed.
Theorem eq_49_50_51 : forall s, Statements.eq_49_50_51 s.
Proof.
  intros s Hs H phi P k Hk. destruct (eq_44_45 s Hs H phi P k Hk) as [E1 E2]. unfold X_kC, X_kS. rewrite E1, E2. split; ring.
Qed.

Lemma X_kC_kS s k : responds s -> X_kC s k ^ 2 + X_kS s k ^ 2 = V_abs s k ^ 2 + friction s ^ 2 * (G s k ^ 2 + U s k ^ 2)
  - 2 * friction s * (V_abs s k / V_abs s (contact s)) *
    (root s * (G s k * cos (V_arg s k - V_arg s (contact s)) - U s k * sin (V_arg s k - V_arg s (contact s)))
     + friction s * U s (contact s) * (G s k * sin (V_arg s k - V_arg s (contact s)) + U s k * cos (V_arg s k - V_arg s (contact
       s)))).
Proof.
  intros H. pose proof (root_sq s H) as RS. destruct H as [HV _]. unfold X_kC, X_kS.
  set (D := V_arg s k - V_arg s (contact s)). pose proof (sin2_cos2 D) as T. unfold Rsqr in T. set (c := cos D) in *. set (d :=
    sin D) in *.
  set (b := friction s) in *. set (Uj := U s (contact s)) in *. set (r := root s) in *. set (Vj := V_abs s (contact s)) in *.
    set (Vk := V_abs s k).
  assert (T' : d * d = 1 - c * c) by lra. assert (R' : r * r = Vj ^ 2 - (b * Uj) ^ 2) by (rewrite <- RS; ring).
  transitivity ((Vk / Vj) ^ 2 * (r ^ 2 + (b * Uj) ^ 2) + b ^ 2 * (G s k ^ 2 + U s k ^ 2)
    - 2 * b * (Vk / Vj) * (r * (G s k * c - U s k * d) + b * Uj * (G s k * d + U s k * c))).
  - ring [T' R'].
  - rewrite RS. field; lra.
Qed.

Theorem eq_52_53 : forall s, Statements.eq_52_53 s.
Proof.
  intros s H k. pose proof (X_kC_kS s k H) as E. split.
  - unfold X_k. rewrite E. reflexivity.
  - intros Hn f C S t. rewrite cos_minus, C, S. field. exact Hn.
Qed.

Theorem eq_52_is_38_at_the_contact : forall s, Statements.eq_52_is_38_at_the_contact s.
Proof.
  intros s H. destruct (eq_52_53 s H (contact s)) as [E _]. rewrite E. destruct H as [HV _]. unfold X_kC, X_kS, X_j.
  replace (V_arg s (contact s) - V_arg s (contact s)) with 0 by ring. rewrite cos_0, sin_0.
  replace (V_abs s (contact s) / V_abs s (contact s)) with 1 by (field; lra).
  rewrite <- sqrt_Rsqr_abs. f_equal. unfold Rsqr. ring.
Qed.
