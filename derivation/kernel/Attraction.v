(* For mu = 1 and damping in all modes every motion tends to the steady one: its velocities, and its displacements where the
  steady
   contact moves. *)
Require Import Reals List Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes SteadyMode Sums Masses OneVelocity Slopes.
Open Scope R_scope.

Lemma from_some_on N (P : nat -> nat -> Prop) : (forall i, (i < N)%nat -> exists n0, forall n, (n0 <= n)%nat -> P i n) ->
  exists n0, forall i n, (i < N)%nat -> (n0 <= n)%nat -> P i n.
Proof.
  induction N; intros H; [exists O; intros; lia|]. destruct IHN as [n0 H0]; [intros; apply H; lia|].
  destruct (H N ltac:(lia)) as [n1 H1]. exists (max n0 n1). intros i n Hi Hn.
  destruct (Nat.eq_dec i N) as [->|]; [apply H1; lia | apply H0; lia].
Qed.

(* A motion seen from the start of the period n *)
Definition shifted (n : nat) (f : nat -> R -> R) (a : nat) (t : R) := f a (t + 2 * PI * INR n).

Lemma shifted_is_a_motion s load y y1 n : (forall a t, load a (t + 2 * PI) = load a t) -> (forall T, 0 < T -> motion_under s load T y y1) ->
  motion_under s load (2 * PI) (shifted n y) (shifted n y1).
Proof.
  intros Per H. pose proof PI_RGT_0 as P. pose proof (pos_INR n) as Pn. set (c := 2 * PI * INR n).
  assert (Hc : 0 <= c) by (unfold c; apply Rmult_le_pos; lra). destruct (H (2 * PI + c) ltac:(lra)) as [Cy [L Ey]].
  assert (Co : forall a t, load a (t + c) = load a t).
  { intros a t. unfold c. clear - Per. induction n; [simpl; f_equal; ring|].
    rewrite S_INR, <- IHn, <- (Per a (t + 2 * PI * INR n)). f_equal. ring. }
  assert (Mv : forall (f : R -> R) t k, is_derive f (t + c) k -> is_derive (fun t => f (t + c)) t k).
  { intros f t k D. evar_last. { apply (is_derive_comp f (fun t => t + c)); [exact D | auto_derive; [trivial | reflexivity]]. }
    unfold scal; simpl; unfold mult; simpl. ring. }
  split.
  - intros a t Ha Ht. destruct (Cy a (t + c) Ha ltac:(lra)) as [C1 C2].
    assert (Sh : forall f : R -> R, continuous f (t + c) -> continuous (fun t => f (t + c)) t).
    { intros f Cf. apply (continuous_comp (fun t => t + c) f); [|exact Cf]. apply (continuous_plus (V := R_NormedModule)); [apply
        continuous_id | apply continuous_const]. }
    split; apply Sh; assumption.
  - exists (map (fun t => t - c) L). intros t Ht NL. destruct (Ey (t + c)) as [y2 [sg [Cs Es]]]; [lra | |].
    + intros I. apply NL, in_map_iff. exists (t + c). split; [ring | exact I].
    + exists y2, sg. split; [exact Cs|]. intros a Ha. destruct (Es a Ha) as [D1 [D2 Q]].
      split; [apply (Mv (y a)), D1 | split; [apply (Mv (y1 a)), D2|]]. rewrite Co in Q. exact Q.
Qed.

Section Pair.
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
Variables (load : nat -> R -> R) (y y1 z z1 : nat -> R -> R).
Hypothesis Hp : forall a t, load a (t + 2 * PI) = load a t.
Hypothesis HY : forall T, 0 < T -> motion_under s load T y y1.
Hypothesis HZ : steady_under s load (2 * PI) z z1.
Let HYn n := shifted_is_a_motion s load y y1 n Hp HY.
Let p n := gap s (shifted n y) z.
Let p1 n := gap s (shifted n y1) z1.
Let E n := energy s (shifted n y) (shifted n y1) z z1.

Lemma periods_follow n : E n (2 * PI) = E (S n) 0.
Proof.
  destruct HZ as [_ Pz]. unfold E, energy, gap, modal, shifted. apply Sum_ext. intros i Hi.
  assert (T : 2 * PI + 2 * PI * INR n = 0 + 2 * PI * INR (S n)) by (rewrite S_INR; ring). rewrite T.
  rewrite (Sum_ext N (fun a => W s i a * (y1 a (0 + 2 * PI * INR (S n)) - z1 a (2 * PI))) (fun a => W s i a * (y1 a (0 + 2 * PI *
    INR (S n)) - z1 a 0))) by (intros a Ha; destruct (Pz a Ha); congruence).
  rewrite (Sum_ext N (fun a => W s i a * (y a (0 + 2 * PI * INR (S n)) - z a (2 * PI))) (fun a => W s i a * (y a (0 + 2 * PI *
    INR (S n)) - z a 0))) by (intros a Ha; destruct (Pz a Ha); congruence).
  reflexivity.
Qed.
Lemma falls n a b : 0 <= a -> a <= b -> b <= 2 * PI -> E n b <= E n a.
Proof. apply (energy_falls s Hs load (2 * PI) _ _ z z1 Hz Hb (HYn n) (proj1 HZ)). Qed.

Lemma parts_of_energy n i t : (i < N)%nat -> p1 n i t * p1 n i t <= 2 * E n t /\ / R_ i ^ 2 * (p n i t * p n i t) <= 2 * E n t.
Proof.
  intros Hi. assert (T : forall k, (k < N)%nat -> 0 <= p1 n k t * p1 n k t /\ 0 <= / R_ k ^ 2 * (p n k t * p n k t)).
  { intros k Hk. pose proof (Hratio s Hs k Hk). split; [nra|]. apply Rmult_le_pos; [apply Rlt_le, Rinv_0_lt_compat, pow_lt; lra |
      nra]. }
  assert (Q : / 2 * (p1 n i t * p1 n i t + / R_ i ^ 2 * (p n i t * p n i t)) <= E n t).
  { apply (Sum_part N (fun i => / 2 * (p1 n i t * p1 n i t + / R_ i ^ 2 * (p n i t * p n i t)))); [|exact Hi].
    intros k Hk. destruct (T k Hk). lra. }
  destruct (T i Hi). lra.
Qed.
Lemma energy_positive n t : 0 <= E n t.
Proof.
  apply Sum_nonneg. intros k Hk. pose proof (Hratio s Hs k Hk). assert (0 <= / R_ k ^ 2 * (p n k t * p n k t)).
  { apply Rmult_le_pos; [apply Rlt_le, Rinv_0_lt_compat, pow_lt; lra | apply Rle_0_sqr]. }
  pose proof (Rle_0_sqr (p1 n k t)). unfold Rsqr in *. unfold p, p1 in *. lra.
Qed.
Lemma energy_below n t : 0 <= t <= 2 * PI -> E n t <= E 0 0.
Proof.
  intros Ht. assert (Q : E n 0 <= E 0 0).
  { clear Ht. induction n; [lra|]. rewrite <- periods_follow. pose proof PI_RGT_0. pose proof (falls n 0 (2 * PI) ltac:(lra)
      ltac:(lra) ltac:(lra)). lra. }
  pose proof (falls n 0 t ltac:(lra) ltac:(lra) ltac:(lra)). lra.
Qed.

(* What the energy loses in a period tends to 0. *)
Lemma loss_vanishes h : 0 < h -> exists n0, forall n, (n0 <= n)%nat -> E n 0 - E n (2 * PI) < h.
Proof.
  intros Hh. set (e := fun n => E n 0).
  assert (De : Un_decreasing e).
  { intros n. unfold e. rewrite <- periods_follow. pose proof PI_RGT_0. apply falls; lra. }
  assert (Lb : has_lb e).
  { exists 0. intros v [n ->]. unfold opp_seq. pose proof (energy_positive n 0). unfold e. lra. }
  destruct (decreasing_cv e De Lb) as [l Cv]. destruct (Cv h Hh) as [n0 H0]. exists n0. intros n Hn.
  specialize (H0 n ltac:(lia)). unfold R_dist in H0. apply Rabs_lt_between in H0.
  pose proof (decreasing_ineq e l De Cv (S n)) as B. unfold e in *. rewrite <- periods_follow in B. lra.
Qed.

Let V := 1 + 2 * E 0 0.
Lemma speeds n i t : (i < N)%nat -> 0 <= t <= 2 * PI -> Rabs (p1 n i t) <= V /\ Rabs (/ R_ i ^ 2 * p n i t) <= V * / R_ i.
Proof.
  intros Hi Ht. destruct (parts_of_energy n i t Hi) as [A B]. pose proof (energy_below n t Ht) as Lo. pose proof (Hratio s Hs i
    Hi).
  assert (Sq : forall x, x * x <= 2 * E n t -> Rabs x <= V).
  { intros x Hx. unfold V. apply Rabs_le. assert (x <= 1 + x * x) by nra. assert (- x <= 1 + x * x) by nra. lra. }
  split; [apply Sq, A|]. replace (/ R_ i ^ 2 * p n i t) with (/ R_ i * p n i t * / R_ i) by (field; lra).
  rewrite Rabs_mult, (Rabs_right (/ R_ i)) by (apply Rle_ge, Rlt_le, Rinv_0_lt_compat; lra).
  apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat; lra|]. apply Sq.
  replace (/ R_ i * p n i t * (/ R_ i * p n i t)) with (/ R_ i ^ 2 * (p n i t * p n i t)) by (field; lra). exact B.
Qed.

(* The difference of the velocities changes at a bounded rate, so that it cannot be large for a moment only. *)
Lemma bounded_acceleration i : (i < N)%nat -> exists B, 0 < B /\ forall n a b, 0 <= a -> a <= b -> b <= 2 * PI ->
  Rabs (p1 n i b - p1 n i a) <= B * (b - a).
Proof.
  intros Hi. pose proof (Hratio s Hs i Hi) as Ri. pose proof (Hz i Hi) as Zi. pose proof (energy_positive 0 0) as E0.
  assert (c0 : 0 < 2 * zeta i / R_ i) by (apply Rdiv_lt_0_compat; lra).
  assert (Ip : 0 < / R_ i) by (apply Rinv_0_lt_compat, Ri). assert (V0 : 1 <= V) by (unfold V; lra).
  pose proof (Rabs_pos (psi j i)) as Ap.
  exists (2 * zeta i / R_ i * V + V * / R_ i + Rabs (psi j i) * (beta * 2)). split.
  - assert (0 < 2 * zeta i / R_ i * V) by (apply Rmult_lt_0_compat; lra). assert (0 < V * / R_ i) by (apply Rmult_lt_0_compat;
    lra).
    assert (0 <= Rabs (psi j i) * (beta * 2)) by (apply Rmult_le_pos; lra). lra.
  - intros n a b H0 Hab H1. destruct (gap_equation s Hs load (2 * PI) _ _ z z1 (HYn n) (proj1 HZ)) as [L Eq].
    apply (bounded_slope L); [exact Hab | intros; apply (gap_continuous s load (2 * PI) _ _ z z1 (HYn n) (proj1 HZ)); lra |].
    intros t Ht NL. destruct (Eq t ltac:(lra) NL) as [p2 [f [_ [F [_ Q]]]]]. destruct (Q i Hi) as [_ [D Q3]]. exists (p2 i).
    split; [exact D|]. destruct (speeds n i t Hi ltac:(lra)) as [S1 S2].
    assert (X : Rabs (2 * zeta i / R_ i * p1 n i t) <= 2 * zeta i / R_ i * V).
    { rewrite Rabs_mult, (Rabs_right (2 * zeta i / R_ i)) by lra. apply Rmult_le_compat_l; [lra | exact S1]. }
    assert (Y : Rabs (psi j i * (beta * f)) <= Rabs (psi j i) * (beta * 2)).
    { rewrite !Rabs_mult, (Rabs_right beta) by lra. apply Rmult_le_compat_l; [exact Ap|]. apply Rmult_le_compat_l; lra. }
    apply Rabs_le_between in X, Y, S2. fold (p1 n) (p n) in Q3. apply Rabs_le. lra.
Qed.

Lemma velocity_gap i h : (i < N)%nat -> 0 < h -> exists n0, forall n, (n0 <= n)%nat -> forall t, 0 <= t <= 2 * PI ->
  Rabs (p1 n i t) < h.
Proof.
  intros Hi Hh. destruct (bounded_acceleration i Hi) as [B [HB Lip]]. pose proof PI_RGT_0 as Pp.
  pose proof (Hratio s Hs i Hi) as Ri. pose proof (Hz i Hi) as Zi. assert (c0 : 0 < 2 * zeta i / R_ i) by (apply Rdiv_lt_0_compat;
    lra).
  set (c := 2 * zeta i / R_ i) in *. set (d := Rmin PI (h / (2 * B))).
  assert (Hd : 0 < d <= PI) by (split; [apply Rmin_glb_lt; [lra | apply Rdiv_lt_0_compat; lra] | apply Rmin_l]).
  assert (Bd : B * d <= h / 2).
  { replace (h / 2) with (B * (h / (2 * B))) by (field; lra). apply Rmult_le_compat_l; [lra | apply Rmin_r]. }
  set (k := c * (h / 2 * (h / 2))). assert (Hk : 0 < k) by (unfold k; apply Rmult_lt_0_compat; [lra | nra]).
  destruct (loss_vanishes (k * d)) as [n0 H0]; [apply Rmult_lt_0_compat; lra|]. exists n0. intros n Hn t Ht.
  specialize (H0 n Hn). apply Rnot_le_lt. intros Big.
  assert (Loss : forall a b, 0 <= a -> b <= 2 * PI -> b = a + d -> (t = a \/ t = b) -> False).
  { intros a b Ha Hb' Eb Hab.
    assert (Large : forall x, a <= x <= b -> h / 2 <= Rabs (p1 n i x)).
    { intros x Hx. assert (W : Rabs (p1 n i t - p1 n i x) <= B * d).
      { destruct Hab as [-> | ->].
        - rewrite Rabs_minus_sym. apply Rle_trans with (B * (x - a)); [apply Lip; lra | apply Rmult_le_compat_l; lra].
        - apply Rle_trans with (B * (b - x)); [apply Lip; lra | apply Rmult_le_compat_l; lra]. }
      pose proof (Rabs_triang_inv (p1 n i t) (p1 n i t - p1 n i x)) as Tr.
      replace (p1 n i t - (p1 n i t - p1 n i x)) with (p1 n i x) in Tr by ring. lra. }
    destruct (energy_rate s Hs load (2 * PI) _ _ z z1 Hb (HYn n) (proj1 HZ)) as [L E'].
    assert (F : E n b + k * b <= E n a + k * a).
    { apply (not_growing L (fun t => E n t + k * t) a b); [lra | |].
      - intros x Hx. apply (continuous_plus (V := R_NormedModule)).
        + apply (energy_continuous s load (2 * PI) _ _ z z1 (HYn n) (proj1 HZ)). lra.
        + apply continuous_scaled, continuous_id.
      - intros x Hx NL. destruct (E' x ltac:(lra) NL) as [e [D Q]]. exists (e + k). split.
        + apply (is_derive_plus (V := R_NormedModule)); [exact D | auto_derive; [trivial | ring]].
        + assert (P : c * (p1 n i x * p1 n i x) <= Sum N (fun i => 2 * zeta i / R_ i * (p1 n i x * p1 n i x))).
          { apply (Sum_part N (fun i => 2 * zeta i / R_ i * (p1 n i x * p1 n i x))); [|exact Hi].
            intros k' Hk'. apply (loss_pos s Hs (shifted n y1) z1 Hz x k' Hk'). }
          fold (p1 n) in Q. specialize (Large x ltac:(lra)).
          assert (Sq : h / 2 * (h / 2) <= p1 n i x * p1 n i x).
          { replace (p1 n i x * p1 n i x) with (Rabs (p1 n i x) * Rabs (p1 n i x)) by (rewrite <- Rabs_mult; apply Rabs_right;
              apply Rle_ge, Rle_0_sqr). apply Rmult_le_compat; lra. }
          assert (k <= c * (p1 n i x * p1 n i x)) by (unfold k; apply Rmult_le_compat_l; lra). lra. }
    pose proof (falls n 0 a ltac:(lra) ltac:(lra) ltac:(lra)). pose proof (falls n b (2 * PI) ltac:(lra) ltac:(lra) ltac:(lra)).
    rewrite Eb in *. lra. }
  destruct (Rle_lt_dec t PI) as [L|L].
  - apply (Loss t (t + d)); try lra; left; reflexivity.
  - apply (Loss (t - d) t); try lra; right; reflexivity.
Qed.

(* What holds of each mode holds of the masses. *)
Lemma of_masses (f h : nat -> R -> R) :
  (forall i e, (i < N)%nat -> 0 < e -> exists n0, forall n, (n0 <= n)%nat -> forall t, 0 <= t <= 2 * PI ->
    Rabs (gap s (shifted n f) h i t) < e) ->
  forall e, 0 < e -> exists n0 : nat, forall n k t, (n0 <= n)%nat -> (k < N)%nat -> 0 <= t <= 2 * PI ->
  Rabs (f k (t + 2 * PI * INR n) - h k t) < e.
Proof.
  intros H e He. set (A := Sum N (fun k => Sum N (fun i => Rabs (psi k i)))).
  assert (A1 : forall k, 0 <= Sum N (fun i => Rabs (psi k i))) by (intros; apply Sum_nonneg; intros; apply Rabs_pos).
  assert (A0 : 0 <= A) by (apply Sum_nonneg; intros; apply A1).
  set (d := e / (1 + A)). assert (Hd : 0 < d) by (apply Rdiv_lt_0_compat; lra).
  assert (Ed : d * (1 + A) = e) by (unfold d; field; lra).
  destruct (from_some_on N (fun i n => forall t, 0 <= t <= 2 * PI -> Rabs (gap s (shifted n f) h i t) < d)) as [n0 H0].
  { intros i Hi. apply H; assumption. }
  exists n0. intros n k t Hn Hk Ht.
  pose proof (physical s Hs (fun a => shifted n f a t - h a t) k Hk) as Ph. cbv beta in Ph.
  change (f k (t + 2 * PI * INR n)) with (shifted n f k t). rewrite Ph.
  apply Rle_lt_trans with (Sum N (fun i => Rabs (psi k i) * d)).
  - apply Rle_trans with (1 := Sum_abs N _). apply Sum_le. intros i Hi. rewrite Rabs_mult.
    apply Rmult_le_compat_l; [apply Rabs_pos|]. apply Rlt_le, (H0 i n Hi Hn t Ht).
  - rewrite Sum_scal_r. assert (Sum N (fun i => Rabs (psi k i)) <= A) by (apply (Sum_part N (fun k => Sum N (fun i => Rabs (psi k
      i)))); [intros; apply A1 | exact Hk]).
    apply Rle_lt_trans with (A * d); [apply Rmult_le_compat_r; lra | lra].
Qed.

(* While both contacts move in the same direction each mode of the difference is free, and its velocity is small for a while
  only if
   its displacement is. *)
Lemma displacement_gap i h : (exists t, 0 < t < 2 * PI /\ z1 j t <> 0) -> (i < N)%nat -> 0 < h ->
  exists n0, forall n, (n0 <= n)%nat -> forall t, 0 <= t <= 2 * PI -> Rabs (p n i t) < h.
Proof.
  intros [tm [Htm Mv]] Hi Hh. pose proof PI_RGT_0 as Pp. pose proof (Hratio s Hs i Hi) as Ri. pose proof (Hz i Hi) as Zi.
  set (m := Rabs (z1 j tm) / 2). assert (Hm : 0 < m) by (unfold m; pose proof (Rabs_pos_lt _ Mv); lra).
  assert (Cz : continuous (z1 j) tm) by (destruct HZ as [[Cz _] _]; apply Cz; [apply Hj, Hs | lra]).
  apply continuity_pt_filterlim in Cz. destruct (Cz m Hm) as [d [Hd Near]].
  set (b := Rmin (tm + d / 2) ((tm + 2 * PI) / 2)). assert (Ib : tm < b < 2 * PI /\ b < tm + d).
  { unfold b. pose proof (Rmin_l (tm + d / 2) ((tm + 2 * PI) / 2)). pose proof (Rmin_r (tm + d / 2) ((tm + 2 * PI) / 2)).
    assert (tm < Rmin (tm + d / 2) ((tm + 2 * PI) / 2)) by (apply Rmin_glb_lt; lra). lra. }
  assert (Sgn : forall x, tm < x < b -> Rabs (z1 j x - z1 j tm) < m).
  { intros x Hx. apply (Near x). split; [split; [exact I | lra] | simpl; unfold R_dist; rewrite Rabs_right; lra]. }
  clearbody b. set (r := / R_ i ^ 2). assert (Hr : 0 < r) by (apply Rinv_0_lt_compat, pow_lt; lra).
  set (c := 2 * zeta i / R_ i). assert (Hc : 0 < c) by (apply Rdiv_lt_0_compat; lra).
  set (Q := (2 + c * (2 * PI) + r * (2 * PI) * (2 * PI)) / (r * (b - tm))).
  assert (Rb : 0 < r * (b - tm)) by (apply Rmult_lt_0_compat; lra).
  assert (Num : 0 < 2 + c * (2 * PI) + r * (2 * PI) * (2 * PI)).
  { assert (0 < c * (2 * PI)) by (apply Rmult_lt_0_compat; lra). assert (0 < r * (2 * PI)) by (apply Rmult_lt_0_compat; lra).
    assert (0 < r * (2 * PI) * (2 * PI)) by (apply Rmult_lt_0_compat; lra). lra. }
  assert (HQ : 0 < Q) by (apply Rdiv_lt_0_compat; assumption).
  set (e := h / (Q + 2 * PI + 1)). assert (He : 0 < e) by (apply Rdiv_lt_0_compat; lra).
  assert (Ee : e * (Q + 2 * PI + 1) = h) by (unfold e; field; lra).
  destruct (velocity_gap i e Hi He) as [n1 H1].
  destruct (of_masses y1 z1 (fun i e Hi He => velocity_gap i e Hi He) m Hm) as [n2 H2].
  exists (max n1 n2). intros n Hn. specialize (H1 n ltac:(lia)).
  assert (Cp := fun x Hx => gap_continuous s load (2 * PI) _ _ z z1 (HYn n) (proj1 HZ) i x Hx).
  destruct (gap_equation s Hs load (2 * PI) _ _ z z1 (HYn n) (proj1 HZ)) as [L Eq].
  assert (Near' : forall u v, 0 <= u -> u <= v -> v <= 2 * PI -> Rabs (p n i v - p n i u) <= e * (2 * PI)).
  { intros u v Hu Huv Hv. apply Rle_trans with (e * (v - u)); [|apply Rmult_le_compat_l; lra].
    apply (bounded_slope L); [exact Huv | intros; apply Cp; lra |]. intros x Hx NL. destruct (Eq x ltac:(lra) NL) as [p2 [f [_
      [_ [_
      Q']]]]]. destruct (Q' i Hi) as [D _].
    exists (p1 n i x). split; [exact D | apply Rlt_le, H1; lra]. }
  assert (Line : forall k t, is_derive (fun t => k * t) t k) by (intros; auto_derive; [trivial | ring]).
  set (w := p n i tm). set (H := fun x => p1 n i x + c * p n i x + r * w * x).
  assert (Slope : Rabs (H b - H tm) <= r * (e * (2 * PI)) * (b - tm)).
  { apply (bounded_slope L); [lra | |].
    - intros x Hx. destruct (Cp x ltac:(lra)) as [C0 C1]. unfold H. repeat apply (continuous_plus (V := R_NormedModule));
        [exact C1 | apply continuous_scaled, C0 | apply continuous_scaled, continuous_id].
    - intros x Hx NL. destruct (Eq x ltac:(lra) NL) as [p2 [f [_ [_ [F Q']]]]]. destruct (Q' i Hi) as [D1 [D2 Q3]].
      rewrite F, !Rmult_0_r, Ropp_0 in Q3.
      + exists (p2 i + c * p1 n i x + r * w). split.
        * unfold H. apply (is_derive_plus (V := R_NormedModule)); [|apply Line].
          apply (is_derive_plus (V := R_NormedModule)); [exact D2 | apply is_derive_scal, D1].
        * fold (p1 n) (p n) c r in Q3. replace (p2 i + c * p1 n i x + r * w) with (- (r * (p n i x - w))) by lra.
          rewrite Rabs_Ropp, Rabs_mult, (Rabs_right r) by lra. apply Rmult_le_compat_l; [lra | apply Near'; lra].
      + specialize (H2 n j x ltac:(lia) (Hj s Hs) ltac:(lra)). specialize (Sgn x Hx).
        change (y1 j (x + 2 * PI * INR n)) with (shifted n y1 j x) in H2. apply Rabs_lt_between in H2, Sgn. unfold m in *.
        destruct (Rcase_abs (z1 j tm)) as [Ng|Ps].
        * rewrite Rabs_left in * by exact Ng. nra.
        * rewrite Rabs_right in * by exact Ps. nra. }
  assert (Small : Rabs w <= e * Q).
  { pose proof (H1 tm ltac:(lra)) as U1. pose proof (H1 b ltac:(lra)) as U2. pose proof (Near' tm b ltac:(lra) ltac:(lra)
    ltac:(lra))
      as U3.
    assert (U4 : Rabs (c * (p n i b - p n i tm)) <= c * (e * (2 * PI))) by (rewrite Rabs_mult, (Rabs_right c) by lra; apply
      Rmult_le_compat_l; lra).
    assert (U5 : r * (e * (2 * PI)) * (b - tm) <= r * (e * (2 * PI)) * (2 * PI)).
    { apply Rmult_le_compat_l; [|lra]. apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; lra. }
    assert (U6 : Rabs (r * (b - tm) * w) <= e * (2 + c * (2 * PI) + r * (2 * PI) * (2 * PI))).
    { replace (r * (b - tm) * w) with (H b - H tm - (p1 n i b - p1 n i tm) - c * (p n i b - p n i tm)) by (unfold H; ring).
      apply Rabs_lt_between in U1, U2. apply Rabs_le_between in U4, Slope. apply Rabs_le. lra. }
    rewrite Rabs_mult, (Rabs_right (r * (b - tm))) in U6 by lra.
    apply (Rmult_le_reg_l (r * (b - tm))); [exact Rb|]. apply Rle_trans with (1 := U6). apply Req_le. unfold Q. field. lra. }
  intros t Ht. assert (Far : Rabs (p n i t - w) <= e * (2 * PI)).
  { unfold w. destruct (Rle_dec tm t); [apply Near'; lra | rewrite Rabs_minus_sym; apply Near'; lra]. }
  apply Rabs_le_between in Far, Small. apply Rabs_lt_between. lra.
Qed.
End Pair.

Theorem velocities_are_attracted : forall s, Statements.velocities_are_attracted s.
Proof.
  intros s Hs Hz Hb load Hp y y1 z z1 HY HZ. apply (of_masses s Hs). intros i e Hi He.
  apply (velocity_gap s Hs Hz Hb load y y1 z z1 Hp HY HZ i e Hi He).
Qed.
Theorem displacements_are_attracted : forall s, Statements.displacements_are_attracted s.
Proof.
  intros s Hs Hz Hb load Hp y y1 z z1 HY HZ Mv. apply (of_masses s Hs). intros i e Hi He.
  apply (displacement_gap s Hs Hz Hb load y y1 z z1 Hp HY HZ i e Mv Hi He).
Qed.
