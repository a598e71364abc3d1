(* For mu = 1: from every start there is a motion (`EveryStart.v`), and no other; (74) follows under the paper's load; and with
   damping in all modes there is a steady motion. The map from the state at the start of a period to the state at its end
   increases no distance, and damping bounds it. *)
Require Import Reals List Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes SteadyMode Sums Masses Contact OneVelocity ContactMotion Attraction FixedPoint Slopes
  NoAccumulation EveryStart.
Open Scope R_scope.

(* For a mode under a force f, V = p1^2 + 2 c p p1 + w^2 p^2 has a rate of at most - c V + f^2 / c. *)
Lemma storage_rate c w zeta p p1 p2 f : 0 < c -> c = zeta * w -> 0 <= zeta <= 1 ->
  p2 + 2 * zeta * w * p1 + w ^ 2 * p = f ->
  2 * p1 * p2 + 2 * c * (p1 * p1 + p * p2) + 2 * w ^ 2 * (p * p1) <=
  - c * (p1 * p1 + 2 * c * (p * p1) + w ^ 2 * (p * p)) + f * f / c.
Proof.
  intros Hc Ec Hz E. replace p2 with (f - 2 * c * p1 - w ^ 2 * p) by (rewrite <- E, Ec; ring).
  assert (S : 0 <= (c * (p1 + c * p) - f) * (c * (p1 + c * p) - f) / c).
  { apply Rmult_le_pos; [apply Rle_0_sqr | apply Rlt_le, Rinv_0_lt_compat, Hc]. }
  assert (Q : 0 <= c * ((w ^ 2 - c * c) * (p * p))).
  { apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; [|apply Rle_0_sqr]. rewrite Ec.
    replace (w ^ 2 - zeta * w * (zeta * w)) with ((1 - zeta * zeta) * (w * w)) by ring.
    apply Rmult_le_pos; [nra | apply Rle_0_sqr]. }
  replace ((c * (p1 + c * p) - f) * (c * (p1 + c * p) - f) / c) with
    (c * ((p1 + c * p) * (p1 + c * p)) - 2 * f * (p1 + c * p) + f * f / c) in S by (field; lra).
  lra.
Qed.

Section Scene.
Variable s : scene.
Local Notation N := (masses s).
Local Notation psi := (shape s).
Local Notation R_ := (ratio s).
Local Notation zeta := (damping_ratio s).
Local Notation j := (contact s).
Local Notation beta := (friction s).
Hypothesis Hs : is_scene s.
Hypothesis Hz : forall i, (i < N)%nat -> 0 < zeta i.
Hypothesis Hb : 0 <= beta.

(* The state of a motion: the velocities of the modes, and their displacements by R_i *)
Definition state (y y1 : nat -> R -> R) t i :=
  if Nat.ltb i N then modal s (fun a => y1 a t) i else / R_ (i - N) * modal s (fun a => y a t) (i - N).
Lemma state_velocity y y1 t i : (i < N)%nat -> state y y1 t i = modal s (fun a => y1 a t) i.
Proof. intros Hi. unfold state. destruct (Nat.ltb_spec i N); [reflexivity | lia]. Qed.
Lemma state_displacement y y1 t i : state y y1 t (N + i) = / R_ i * modal s (fun a => y a t) i.
Proof. unfold state. destruct (Nat.ltb_spec (N + i) N); [lia|]. replace (N + i - N)%nat with i by lia. reflexivity. Qed.

(* The motion has the state x at the time t. *)
Definition at_state (x : nat -> R) y y1 t := forall i, (i < N + N)%nat -> state y y1 t i = x i.
Definition displacement_of (x : nat -> R) k := Sum N (fun i => psi k i * (R_ i * x (N + i)%nat)).
Definition velocity_of (x : nat -> R) k := Sum N (fun i => psi k i * x i).
Lemma start_in_state x y y1 t : (forall k, (k < N)%nat -> y k t = displacement_of x k /\ y1 k t = velocity_of x k) ->
  at_state x y y1 t.
Proof.
  intros H i Hi. destruct (Nat.lt_ge_cases i N) as [L|G].
  - rewrite state_velocity by exact L. unfold modal. rewrite <- (product_applied N (W s) psi x (W_psi s Hs) i L).
    apply Sum_ext. intros a Ha. destruct (H a Ha) as [_ ->]. reflexivity.
  - replace i with (N + (i - N))%nat by lia. set (k := (i - N)%nat) in *. assert (Hk : (k < N)%nat) by lia.
    rewrite state_displacement.
    pose proof (product_applied N (W s) psi (fun i => R_ i * x (N + i)%nat) (W_psi s Hs) k Hk) as P. cbv beta in P.
    unfold modal. rewrite (Sum_ext N _ (fun a => W s k a * Sum N (fun c => psi a c * (R_ c * x (N + c)%nat))))
      by (intros a Ha; destruct (H a Ha) as [-> _]; reflexivity).
    rewrite P. pose proof (Hratio s Hs k Hk). field. lra.
Qed.
Lemma same_state x y y1 z z1 t t' : at_state x y y1 t -> at_state x z z1 t' ->
  forall k, (k < N)%nat -> y k t = z k t' /\ y1 k t = z1 k t'.
Proof.
  intros H H' k Hk. split.
  - rewrite (physical s Hs (fun a => y a t) k Hk), (physical s Hs (fun a => z a t') k Hk). apply Sum_ext. intros i Hi. f_equal.
    pose proof (H (N + i)%nat ltac:(lia)) as A. rewrite <- (H' (N + i)%nat ltac:(lia)), !state_displacement in A.
    pose proof (Hratio s Hs i Hi). apply (Rmult_eq_reg_l (/ R_ i)); [exact A | apply Rinv_neq_0_compat; lra].
  - rewrite (physical s Hs (fun a => y1 a t) k Hk), (physical s Hs (fun a => z1 a t') k Hk). apply Sum_ext. intros i Hi. f_equal.
    pose proof (H i ltac:(lia)) as A. rewrite <- (H' i ltac:(lia)), !state_velocity in A by exact Hi. exact A.
Qed.

Lemma size_of_difference y y1 z z1 t :
  size (N + N) (fun i => state y y1 t i - state z z1 t i) = 2 * energy s y y1 z z1 t.
Proof.
  assert (G : forall f h : nat -> R -> R, forall i, gap s f h i t = modal s (fun a => f a t) i - modal s (fun a => h a t) i).
  { intros f h i. unfold gap, modal. rewrite <- Sum_minus. apply Sum_ext. intros; ring. }
  unfold size. rewrite Sum_two_parts. unfold energy. rewrite <- Sum_scal, <- Sum_plus. apply Sum_ext. intros i Hi.
  rewrite !state_displacement, !state_velocity, !G by exact Hi. pose proof (Hratio s Hs i Hi). field. lra.
Qed.

(* The contact law has a motion from every start, and the forces are bounded. *)
Definition solvable (load : nat -> R -> R) (T : R) := forall u v : nat -> R,
  exists y y1, motion_under s load T y y1 /\ forall k, (k < N)%nat -> y k 0 = u k /\ y1 k 0 = v k.
Definition bounded_on (load : nat -> R -> R) (T : R) :=
  exists B, forall a t, (a < N)%nat -> 0 <= t <= T -> Rabs (load a t) <= B.

Section Load.
Variables (load : nat -> R -> R) (T : R).
Hypothesis HT : 0 < T.

(* Two motions are not further apart at the end than at the start. *)
Lemma not_apart x x' y y1 z z1 : motion_under s load T y y1 -> motion_under s load T z z1 ->
  at_state x y y1 0 -> at_state x' z z1 0 ->
  size (N + N) (fun i => state y y1 T i - state z z1 T i) <= size (N + N) (fun i => x i - x' i).
Proof.
  intros HY HZ A B. rewrite <- (size_ext (N + N) (fun i => state y y1 0 i - state z z1 0 i) (fun i => x i - x' i))
    by (intros i Hi; rewrite A, B by exact Hi; reflexivity).
  rewrite !size_of_difference.
  pose proof (energy_falls s Hs load T y y1 z z1 Hz Hb HY HZ 0 T ltac:(lra) ltac:(lra) ltac:(lra)). lra.
Qed.
Lemma one_end x y y1 z z1 : motion_under s load T y y1 -> motion_under s load T z z1 ->
  at_state x y y1 0 -> at_state x z z1 0 -> forall i, (i < N + N)%nat -> state y y1 T i = state z z1 T i.
Proof.
  intros HY HZ A B i Hi. pose proof (not_apart x x y y1 z z1 HY HZ A B) as H.
  assert (Z : size (N + N) (fun i => x i - x i) = 0) by (apply Sum_zero; intros; ring). rewrite Z in H.
  pose proof (size_part (N + N) (fun i => state y y1 T i - state z z1 T i) i Hi) as P. cbv beta in P. nra.
Qed.

(* The map from the state at the time 0 to the state at T. As there is one end only, it needs no choice. *)
Definition ends_at (x : nat -> R) i c := exists y y1, motion_under s load T y y1 /\ at_state x y y1 0 /\ state y y1 T i = c.
Definition end_state (x : nat -> R) i : R := iota (ends_at x i).
Lemma end_state_is_reached x y y1 : motion_under s load T y y1 -> at_state x y y1 0 -> at_state (end_state x) y y1 T.
Proof.
  intros HY A i Hi. symmetry. apply (iota_unique (K := R_AbsRing) (V := R_CompleteNormedModule) (ends_at x i)).
  - intros c [z [z1 [HZ [B E]]]]. rewrite <- E. apply (one_end x z z1 y y1); assumption.
  - exists y, y1. auto.
Qed.

Hypothesis HL : solvable load T.
Lemma from_state x : exists y y1, motion_under s load T y y1 /\ at_state x y y1 0 /\ at_state (end_state x) y y1 T.
Proof.
  destruct (HL (displacement_of x) (velocity_of x)) as [y [y1 [HY H]]]. pose proof (start_in_state x y y1 0 H) as A.
  exists y, y1. split; [exact HY|]. split; [exact A | apply end_state_is_reached; assumption].
Qed.
Lemma end_states_not_apart x x' : size (N + N) (fun i => end_state x i - end_state x' i) <= size (N + N) (fun i => x i - x' i).
Proof.
  destruct (from_state x) as [y [y1 [HY [A E]]]]. destruct (from_state x') as [z [z1 [HZ [B F]]]].
  rewrite <- (size_ext (N + N) (fun i => state y y1 T i - state z z1 T i) (fun i => end_state x i - end_state x' i))
    by (intros i Hi; rewrite E, F by exact Hi; reflexivity).
  apply (not_apart x x' y y1 z z1); assumption.
Qed.

(* The equation of one mode of a motion, with a force that the load and the friction bound *)
Variable B : R.
Hypothesis HB : forall a t, (a < N)%nat -> 0 <= t <= T -> Rabs (load a t) <= B.
Definition largest_force i := Sum N (fun a => Rabs (psi a i)) * (B + beta).
Definition displacement (y : nat -> R -> R) i t := modal s (fun a => y a t) i.
Lemma mode_of_motion y y1 : motion_under s load T y y1 -> exists L, forall t, 0 < t < T -> ~ In t L -> forall i, (i < N)%nat ->
  exists p2 f, Rabs f <= largest_force i /\ is_derive (displacement y i) t (displacement y1 i t) /\
  is_derive (displacement y1 i) t p2 /\
  p2 + 2 * zeta i * / R_ i * displacement y1 i t + (/ R_ i) ^ 2 * displacement y i t = f.
Proof.
  intros [_ [L E]]. exists L. intros t Ht NL i Hi. destruct (E t Ht NL) as [y2 [a [Ca Ea]]].
  exists (modal s y2 i), (Sum N (fun k => psi k i * (load k t - beta * delta k j * a))). split; [|split; [|split]].
  - apply Rle_trans with (1 := Sum_abs N _). unfold largest_force. rewrite <- Sum_scal_r. apply Sum_le. intros k Hk.
    rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos|]. pose proof (HB k t Hk ltac:(lra)) as Bk.
    pose proof (coulomb_is_bounded _ _ Ca) as Ba.
    assert (Rabs (beta * delta k j * a) <= beta).
    { unfold delta. destruct (Nat.eqb k j); [|rewrite Rmult_0_r, Rmult_0_l, Rabs_R0; exact Hb]. apply Rabs_le. nra. }
    pose proof (Rabs_triang (load k t) (- (beta * delta k j * a))) as Tr. rewrite Rabs_Ropp in Tr. unfold Rminus. lra.
  - apply (modal_derive s y y1). intros k Hk. apply (Ea k Hk).
  - apply (modal_derive s y1 (fun a t => y2 a)). intros k Hk. apply (Ea k Hk).
  - unfold displacement. rewrite <- (modal_rows s Hs y2 (fun k => y1 k t) (fun k => y k t) _) with (i := i); [| |exact Hi].
    + rewrite pow_inv. unfold Rdiv. reflexivity.
    + intros k Hk. destruct (Ea k Hk) as [_ [_ Q]]. lra.
Qed.
Lemma displacement_continuous y y1 i t : motion_under s load T y y1 -> 0 <= t <= T ->
  continuous (displacement y i) t /\ continuous (displacement y1 i) t.
Proof. intros [C _] Ht. split; apply (modal_continuous s); intros a Ha; apply (C a t Ha Ht). Qed.

(* V of mode i, with c = zeta_i / R_i and w = 1 / R_i, and its bound where the start of a motion is r times its end, 0 < r < 1 *)
Definition decay_of i := zeta i * / R_ i.
Lemma decay_positive i : (i < N)%nat -> 0 < decay_of i.
Proof. intros Hi. apply Rmult_lt_0_compat; [apply Hz, Hi | apply Rinv_0_lt_compat, (Hratio s Hs i Hi)]. Qed.
Definition storage (y y1 : nat -> R -> R) i t :=
  displacement y1 i t * displacement y1 i t + 2 * decay_of i * (displacement y i t * displacement y1 i t) +
  (/ R_ i) ^ 2 * (displacement y i t * displacement y i t).
Definition largest_storage i := largest_force i * largest_force i / decay_of i / decay_of i.
Lemma storage_above y y1 i t : (i < N)%nat -> (1 - zeta i) * (displacement y1 i t * displacement y1 i t +
  / R_ i * displacement y i t * (/ R_ i * displacement y i t)) <= storage y y1 i t.
Proof.
  intros Hi. pose proof (Hz i Hi) as Zi. unfold storage, decay_of. set (p1 := displacement y1 i t). set (p := displacement y i t).
  assert (0 <= zeta i * ((p1 + / R_ i * p) * (p1 + / R_ i * p))) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). lra.
Qed.
Lemma damping_below_1 i : (i < N)%nat -> zeta i < 1.
Proof. intros Hi. apply (Hadm s Hs i Hi). Qed.
Lemma storage_positive y y1 i t : (i < N)%nat -> 0 <= storage y y1 i t.
Proof.
  intros Hi. apply Rle_trans with (2 := storage_above y y1 i t Hi). pose proof (damping_below_1 i Hi).
  apply Rmult_le_pos; [lra|]. apply Rplus_le_le_0_compat; apply Rle_0_sqr.
Qed.

(* (V - bound) exp(c t) does not grow. *)
Lemma storage_falls y y1 i : motion_under s load T y y1 -> (i < N)%nat ->
  (storage y y1 i T - largest_storage i) * exp (decay_of i * T) <= storage y y1 i 0 - largest_storage i.
Proof.
  intros HY Hi. pose proof (decay_positive i Hi) as Hc. pose proof (Hz i Hi) as Zi. pose proof (damping_below_1 i Hi) as Z1.
  set (c := decay_of i) in *. set (k := largest_storage i).
  replace (storage y y1 i 0 - k) with ((storage y y1 i 0 - k) * exp (c * 0)) by (rewrite Rmult_0_r, exp_0; ring).
  destruct (mode_of_motion y y1 HY) as [L E].
  apply (not_growing L (fun t => (storage y y1 i t - k) * exp (c * t)) 0 T); [lra | |].
  - intros t Ht. destruct (displacement_continuous y y1 i t HY Ht) as [C0 C1].
    assert (Ce : continuous (fun t => exp (c * t)) t) by (eapply continuous_of_derive; auto_derive; [trivial | reflexivity]).
    assert (Cs : continuous (storage y y1 i) t).
    { apply (continuous_plus (V := R_NormedModule)); [apply (continuous_plus (V := R_NormedModule))|].
      - apply (continuous_mult (K := R_AbsRing) (displacement y1 i) (displacement y1 i)); assumption.
      - apply continuous_scaled, (continuous_mult (K := R_AbsRing) (displacement y i) (displacement y1 i)); assumption.
      - apply continuous_scaled, (continuous_mult (K := R_AbsRing) (displacement y i) (displacement y i)); assumption. }
    apply (continuous_mult (K := R_AbsRing) (fun t => storage y y1 i t - k) (fun t => exp (c * t))); [|exact Ce].
    apply (continuous_minus (V := R_NormedModule) (storage y y1 i) (fun _ => k)); [exact Cs | apply continuous_const].
  - intros t Ht NL. destruct (E t Ht NL i Hi) as [p2 [f [Hf [D0 [D1 Q]]]]].
    set (p := displacement y i) in *. set (p1 := displacement y1 i) in *.
    set (V' := 2 * p1 t * p2 + 2 * c * (p1 t * p1 t + p t * p2) + 2 * (/ R_ i) ^ 2 * (p t * p1 t)).
    exists ((V' + c * (storage y y1 i t - k)) * exp (c * t)). split.
    + unfold storage. fold p p1 c. evar_last.
      { apply (is_derive_mult (K := R_AbsRing) (fun t => p1 t * p1 t + 2 * c * (p t * p1 t) + (/ R_ i) ^ 2 * (p t * p t) - k)
          (fun t => exp (c * t))); [| |intros; apply Rmult_comm].
        - apply (is_derive_minus (V := R_NormedModule)); [|apply (is_derive_const (K := R_AbsRing) (V := R_NormedModule))].
          apply (is_derive_plus (V := R_NormedModule)); [apply (is_derive_plus (V := R_NormedModule))|].
          + apply (is_derive_mult (K := R_AbsRing) p1 p1); [exact D1 | exact D1 | intros; apply Rmult_comm].
          + apply is_derive_scal, (is_derive_mult (K := R_AbsRing) p p1); [exact D0 | exact D1 | intros; apply Rmult_comm].
          + apply is_derive_scal, (is_derive_mult (K := R_AbsRing) p p); [exact D0 | exact D0 | intros; apply Rmult_comm].
        - auto_derive; [trivial | reflexivity]. }
      unfold minus, plus, opp, mult, zero; simpl. unfold V'. ring.
    + assert (S : V' <= - c * storage y y1 i t + f * f / c).
      { unfold V', storage. fold p p1 c. apply (storage_rate c (/ R_ i) (zeta i)); [exact Hc | reflexivity | lra | exact Q]. }
      assert (F : f * f / c <= c * k).
      { replace (c * k) with (largest_force i * largest_force i / c) by (unfold k, largest_storage; fold c; field; lra).
        apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat, Hc|]. apply Rabs_le_between in Hf.
        assert (0 <= (largest_force i - f) * (largest_force i + f)) by (apply Rmult_le_pos; lra). lra. }
      assert (0 <= - (V' + c * (storage y y1 i t - k)) * exp (c * t)) by (apply Rmult_le_pos; [lra | apply Rlt_le, exp_pos]). lra.
Qed.
(* Of a motion whose start is r times its end *)
Lemma storage_of_multiple y y1 i r : motion_under s load T y y1 -> (i < N)%nat -> -1 < r < 1 ->
  displacement y i 0 = r * displacement y i T -> displacement y1 i 0 = r * displacement y1 i T ->
  storage y y1 i T <= largest_storage i.
Proof.
  intros HY Hi Hr E0 E1. pose proof (storage_falls y y1 i HY Hi) as H. pose proof (decay_positive i Hi) as Hc.
  assert (V0 : storage y y1 i 0 = r * r * storage y y1 i T) by (unfold storage; rewrite E0, E1; ring).
  pose proof (storage_positive y y1 i T Hi) as Pv. rewrite V0 in H.
  assert (Rr : 0 <= (1 - r * r) * storage y y1 i T) by (apply Rmult_le_pos; [nra | exact Pv]).
  assert (Ex : 1 < exp (decay_of i * T)) by (rewrite <- exp_0; apply exp_increasing, Rmult_lt_0_compat; lra).
  apply Rnot_lt_le. intros Big.
  assert (0 < (storage y y1 i T - largest_storage i) * (exp (decay_of i * T) - 1)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
Lemma multiples_are_bounded : exists b, forall r x, -1 < r < 1 -> (forall i, (i < N + N)%nat -> x i = r * end_state x i) ->
  size (N + N) x <= b.
Proof.
  exists (Sum N (fun i => largest_storage i / (1 - zeta i))). intros r x Hr Hx.
  destruct (from_state x) as [y [y1 [HY [A E]]]].
  apply Rle_trans with (size (N + N) (end_state x)).
  { rewrite (size_ext (N + N) x (fun i => r * end_state x i)) by exact Hx. rewrite size_scal.
    assert (0 <= (1 - r * r) * size (N + N) (end_state x)) by (apply Rmult_le_pos; [nra | apply size_nonneg]). lra. }
  unfold size. rewrite Sum_two_parts, <- Sum_plus. apply Sum_le. intros i Hi.
  pose proof (damping_below_1 i Hi) as Z1. pose proof (Hratio s Hs i Hi) as Ri.
  assert (I1 : (i < N + N)%nat) by lia. assert (I2 : (N + i < N + N)%nat) by lia.
  pose proof (Hx i I1) as X1. pose proof (Hx (N + i)%nat I2) as X2.
  rewrite <- (E i I1), <- (A i I1), !state_velocity in X1 by exact Hi.
  rewrite <- (E _ I2), <- (A _ I2), !state_displacement in X2.
  rewrite <- (E i I1), <- (E _ I2), state_displacement, state_velocity by exact Hi.
  fold (displacement y1 i T) (displacement y i T) in *. fold (displacement y1 i 0) (displacement y i 0) in *.
  apply (Rmult_le_reg_l (1 - zeta i)); [lra|].
  replace ((1 - zeta i) * (largest_storage i / (1 - zeta i))) with (largest_storage i) by (field; lra).
  apply Rle_trans with (1 := storage_above y y1 i T Hi), (storage_of_multiple y y1 i r HY Hi Hr); [|exact X1].
  apply (Rmult_eq_reg_l (/ R_ i)); [lra | apply Rinv_neq_0_compat; lra].
Qed.
(* A motion that ends in its start, k = 1, or in its mirror image, k = -1 *)
Lemma returns k : k = 1 \/ k = -1 -> exists x y y1, motion_under s load T y y1 /\ at_state x y y1 0 /\
  at_state (fun i => k * x i) y y1 T.
Proof.
  intros Hk. assert (K2 : k * k = 1) by (destruct Hk as [-> | ->]; ring).
  destruct (fixed_point (N + N) (fun x i => k * end_state x i)) as [x Fx].
  - intros x x'. rewrite (size_ext (N + N) _ (fun i => k * (end_state x i - end_state x' i))) by (intros; ring).
    rewrite size_scal, K2, Rmult_1_l. apply end_states_not_apart.
  - destruct multiples_are_bounded as [b Hbd]. exists b. intros r x Hr Hx. apply (Hbd (r * k)); [destruct Hk as [-> | ->]; lra|].
    intros i Hi. rewrite (Hx i Hi) at 1. ring.
  - destruct (from_state x) as [y [y1 [HY [A E]]]]. exists x, y, y1. split; [exact HY|]. split; [exact A|].
    intros i Hi. rewrite (E i Hi), <- (Fx i Hi), <- Rmult_assoc, K2. ring.
Qed.
Lemma a_steady_motion : exists z z1, steady_under s load T z z1.
Proof.
  destruct (returns 1 ltac:(left; reflexivity)) as [x [y [y1 [HY [A E]]]]]. exists y, y1. split; [exact HY|].
  apply (same_state x); [|exact A]. intros i Hi. rewrite (E i Hi). ring.
Qed.
Lemma a_mirrored_motion : exists z z1, motion_under s load T z z1 /\
  forall k, (k < N)%nat -> z k T = - z k 0 /\ z1 k T = - z1 k 0.
Proof.
  destruct (returns (-1) ltac:(right; reflexivity)) as [x [y [y1 [HY [A E]]]]]. exists y, y1. split; [exact HY|].
  assert (Op : forall f : nat -> R -> R, forall i t, modal s (fun a => - f a t) i = - modal s (fun a => f a t) i).
  { intros f i t. unfold modal. rewrite <- Sum_opp. apply Sum_ext. intros; ring. }
  apply (same_state (fun i => -1 * x i) y y1 (fun a t => - y a t) (fun a t => - y1 a t) T 0 E).
  intros i Hi. rewrite <- (A i Hi). unfold state. rewrite !Op. destruct (Nat.ltb i N); ring.
Qed.
End Load.
End Scene.

(* ---- Forces that are sums of harmonics ---- *)
Theorem contact_has_a_motion : forall s, Statements.contact_has_a_motion s.
Proof. intros s Hs Hb n omega p q u v. apply from_every_start; assumption. Qed.
Lemma harmonic_forces_solvable s n omega p q T : is_scene s -> 0 <= friction s -> solvable s (harmonic_forces n omega p q) T.
Proof.
  intros Hs Hb u v. destruct (contact_has_a_motion s Hs Hb n omega p q u v) as [y [y1 [H St]]]. exists y, y1.
  split; [apply H | exact St].
Qed.
Lemma harmonic_forces_bounded s n omega p q T : bounded_on s (harmonic_forces n omega p q) T.
Proof.
  set (B := fun a => Sum n (fun k => Rabs (p a k) + Rabs (q a k))).
  assert (B0 : forall a, 0 <= B a).
  { intros a. apply Sum_nonneg. intros k _. pose proof (Rabs_pos (p a k)). pose proof (Rabs_pos (q a k)). lra. }
  exists (Sum (masses s) B). intros a t Ha _.
  apply Rle_trans with (B a); [|apply (Sum_part (masses s) B); [intros; apply B0 | exact Ha]].
  apply Rle_trans with (1 := Sum_abs n _), Sum_le. intros k _. apply Rle_trans with (1 := Rabs_triang _ _).
  assert (P : forall x y, -1 <= y <= 1 -> Rabs (x * y) <= Rabs x).
  { intros x y Hy. rewrite Rabs_mult. rewrite <- (Rmult_1_r (Rabs x)) at 2.
    apply Rmult_le_compat_l; [apply Rabs_pos | apply Rabs_le, Hy]. }
  apply Rplus_le_compat; apply P; [apply COS_bound | apply SIN_bound].
Qed.
(* The paper's load is one harmonic. *)
Lemma paper_load_is_harmonic (l : nat) phi : (fun a t => delta a l * cos (t + phi)) =
  harmonic_forces 1 (fun _ => 1) (fun a _ => delta a l * cos phi) (fun a _ => - (delta a l * sin phi)).
Proof.
  apply FunctionalExtensionality.functional_extensionality. intros a. apply FunctionalExtensionality.functional_extensionality.
  intros t. unfold harmonic_forces. simpl. rewrite Rmult_1_l, cos_plus. ring.
Qed.

Theorem contact_has_one_motion : forall s, Statements.contact_has_one_motion s.
Proof.
  intros s Hs Hb load T y y1 z z1 HY HZ St k t Hk Ht. set (E := energy s y y1 z z1).
  assert (E0 : E 0 = 0).
  { apply Sum_zero. intros i Hi. assert (Z : gap s y z i 0 = 0 /\ gap s y1 z1 i 0 = 0).
    { split; apply Sum_zero; intros a Ha; destruct (St a Ha) as [E0 E1]; rewrite ?E0, ?E1; ring. }
    destruct Z as [-> ->]. ring. }
  assert (Et : E t <= E 0).
  { destruct (energy_rate s Hs load T y y1 z z1 Hb HY HZ) as [L Er].
    apply (not_growing L E); [lra | intros; apply (energy_continuous s load T y y1 z z1 HY HZ); lra |].
    intros x Hx NL. destruct (Er x ltac:(lra) NL) as [c [D Q]]. exists c. split; [exact D|].
    assert (0 <= Sum (masses s) (fun i => 2 * damping_ratio s i / ratio s i * (gap s y1 z1 i x * gap s y1 z1 i x))); [|lra].
    apply Sum_nonneg. intros i Hi. destruct (Hadm s Hs i Hi) as [Ri [Zi _]].
    apply Rmult_le_pos; [|apply Rle_0_sqr]. apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat, Ri]. }
  apply (same_state s Hs (state s z z1 t)); [|intros i _; reflexivity | exact Hk].
  intros i Hi. pose proof (size_of_difference s Hs y y1 z z1 t) as S. fold E in S.
  pose proof (size_part _ (fun i => state s y y1 t i - state s z z1 t i) i Hi) as P. cbv beta in P. nra.
Qed.

(* (74): while the load is below the limit, friction takes a velocity back to zero. *)
Theorem eq_74_follows : forall s, Statements.eq_74_follows s.
Proof.
  intros s Hs phi T y y1 [C [L E]]. split; [exact C|]. split; [exists L; exact E|].
  intros t Ht V0 HL. rewrite Rmult_1_l in HL. set (j := contact s) in *.
  assert (Cl : forall t, 0 <= t <= T -> continuous (load_at s phi y y1) t).
  { intros x Hx. unfold load_at, holding_load.
    apply (continuous_mult (K := R_AbsRing) (fun t => Sum (masses s) (fun a => Sum (masses s) (fun i => shape s (contact s) i *
      shape s a i) * (Sum (masses s) (fun b => damping s a b * y1 b t + stiffness s a b * y b t) - delta a (loaded s) *
      cos (t + phi)))) (fun _ => / mobility s)); [|apply continuous_const].
    apply (continuous_Sum (masses s) (fun a t => Sum (masses s) (fun i => shape s (contact s) i * shape s a i) *
      (Sum (masses s) (fun b => damping s a b * y1 b t + stiffness s a b * y b t) - delta a (loaded s) * cos (t + phi)))).
    intros a _. apply continuous_scaled, (continuous_minus (V := R_NormedModule)).
    - apply (continuous_Sum (masses s) (fun b t => damping s a b * y1 b t + stiffness s a b * y b t)). intros b Hbn.
      destruct (C b x Hbn Hx). apply (continuous_plus (V := R_NormedModule)); apply continuous_scaled; assumption.
    - apply continuous_scaled. eapply continuous_of_derive. auto_derive; [exact I | reflexivity]. }
  destruct (above_near (fun t => - Rabs (load_at s phi y y1 t)) (- friction s) t) as [e [He P]]; [| lra |].
  { apply opposite, (continuous_comp (load_at s phi y y1) Rabs); [apply Cl; lra | apply continuous_Rabs]. }
  set (t' := Rmin (t + e / 2) T). pose proof (Rmin_l (t + e / 2) T). pose proof (Rmin_r (t + e / 2) T).
  exists t'. split; [split; [apply Rmin_glb_lt; lra | assumption]|]. intros x Hx. fold t' in H, H0.
  assert (Rate : mostly (fun u =>
    exists k, is_derive (y1 j) u k /\ (0 < y1 j u -> k <= 0) /\ (y1 j u < 0 -> 0 <= k)) t x).
  { apply (mostly_of_list L). intros u Hu NL. destruct (E u ltac:(lra) NL) as [y2 [sg [[C1 [C2 _]] Q]]]. exists (y2 j).
    split; [apply Q, (Hj s Hs)|].
    assert (Y2 : y2 j = - mobility s * (friction s * sg + load_at s phi y y1 u)).
    { apply (acceleration_by_load s Hs (cos (u + phi)) (friction s * sg) (fun k => y k u) (fun k => y1 k u) y2).
      intros a Ha. destruct (Q a Ha) as [_ [_ Row]]. cbv beta in Row. fold j. lra. }
    rewrite Y2.
    specialize (P u ltac:(rewrite Rabs_right; lra)). cbv beta in P. assert (A : Rabs (load_at s phi y y1 u) <= friction s) by lra.
    apply Rabs_le_between in A. pose proof (mobility_pos s Hs) as Mp. split; intros V.
    - rewrite C1 by exact V. assert (0 <= mobility s * (friction s * 1 + load_at s phi y y1 u)) by (apply Rmult_le_pos; lra). lra.
    - rewrite C2 by exact V. assert (0 <= mobility s * - (friction s * -1 + load_at s phi y y1 u)) by (apply Rmult_le_pos; lra).
      lra. }
  assert (Cv : forall u, t <= u <= x -> continuous (y1 j) u) by (intros u Hu; apply (C j u (Hj s Hs)); lra).
  apply Rle_antisym.
  - assert (0 <= - y1 j x); [|lra].
    apply (stays_above (fun u => - y1 j u) t x); [lra | intros; apply opposite, Cv; assumption | | lra].
    apply mostly_weaker with (2 := Rate). intros u _ [k [D [Up _]]]. exists (- k). split; [apply opposite, D|].
    intros V. specialize (Up ltac:(lra)). lra.
  - apply (stays_above (y1 j) t x); [lra | exact Cv | | lra]. apply mostly_weaker with (2 := Rate).
    intros u _ [k [D [_ Lo]]]. exists k. split; [exact D | exact Lo].
Qed.

Theorem steady_motion_exists : forall s, Statements.steady_motion_exists s.
Proof.
  intros s Hs Hz Hb n omega p q T HT. destruct (harmonic_forces_bounded s n omega p q T) as [B HB].
  exact (a_steady_motion s Hs Hz Hb _ T HT (harmonic_forces_solvable s n omega p q T Hs Hb) B HB).
Qed.
Theorem mirrored_steady_motion_exists : forall s, Statements.mirrored_steady_motion_exists s.
Proof.
  intros s Hs Hz Hb n omega p q load Ly. pose proof PI_RGT_0 as Pp.
  destruct (harmonic_forces_bounded s n omega p q PI) as [B HB].
  destruct (a_mirrored_motion s Hs Hz Hb load PI Pp (harmonic_forces_solvable s n omega p q PI Hs Hb) B HB) as [y [y1 [HY My]]].
  exists (continued y), (continued y1).
  split; [apply continued_motion; assumption|]. intros k t Hk Ht. unfold continued.
  destruct (Rle_dec t PI); [|lra]. destruct (Rle_dec (t + PI) PI).
  - assert (t = 0) by lra. subst t. rewrite Rplus_0_l. apply My, Hk.
  - replace (t + PI - PI) with t by ring. split; reflexivity.
Qed.

Theorem steady_motion_exists_and_attracts : forall s, Statements.steady_motion_exists_and_attracts s.
Proof.
  intros s Hs Hz Hb n omega p q load Per. pose proof PI_RGT_0.
  destruct (steady_motion_exists s Hs Hz Hb n omega p q (2 * PI) ltac:(lra)) as [z [z1 HZ]]. exists z, z1. split; [exact HZ|].
  intros y y1 HY. apply (velocities_are_attracted s Hs Hz Hb load Per y y1 z z1 HY HZ).
Qed.

Theorem steady_contact_motion_exists : forall s, Statements.steady_contact_motion_exists s.
Proof.
  intros s Hs Hz Hb phi. pose proof PI_RGT_0.
  destruct (steady_motion_exists s Hs Hz Hb 1%nat (fun _ => 1) (fun a _ => delta a (loaded s) * cos phi)
    (fun a _ => - (delta a (loaded s) * sin phi)) (2 * PI) ltac:(lra)) as [z [z1 [HZ Pz]]].
  rewrite <- paper_load_is_harmonic in HZ. exists z, z1. split; [apply eq_74_follows; assumption | exact Pz].
Qed.
