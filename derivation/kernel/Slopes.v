(* What the slope of a continuous function says, where it is known but for a finite number of times before any time that precedes
   the end. *)
Require Import Reals List Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes Sums OneVelocity.
Open Scope R_scope.

Lemma above_near (f : R -> R) c t : continuous f t -> c < f t -> exists e, 0 < e /\ forall x, Rabs (x - t) < e -> c < f x.
Proof.
  intros Cf P. destruct (Cf (fun v => c < v)) as [e He]; [apply (open_gt c), P|].
  exists e. split; [apply cond_pos | exact He].
Qed.

(* At all times of an open interval, but for a finite number of times before any time that precedes its end *)
Definition mostly (P : R -> Prop) a c := forall c', c' < c -> exists L : list R, forall t, a < t < c' -> ~ In t L -> P t.
Lemma mostly_weaker (P Q : R -> Prop) a c : (forall t, a < t < c -> P t -> Q t) -> mostly P a c -> mostly Q a c.
Proof. intros H O c' Hc. destruct (O c' Hc) as [L HL]. exists L. intros t Ht N. apply H; [lra | apply HL; assumption]. Qed.
Lemma mostly_both (P Q : R -> Prop) a c : mostly P a c -> mostly Q a c -> mostly (fun t => P t /\ Q t) a c.
Proof.
  intros O O' c' Hc. destruct (O c' Hc) as [L HL]. destruct (O' c' Hc) as [L' HL']. exists (L ++ L')%list. intros t Ht N.
  split; [apply HL | apply HL']; try exact Ht; intros I; apply N, in_or_app; [left | right]; exact I.
Qed.
Lemma mostly_inside (P : R -> Prop) a c a' c' : a <= a' -> c' <= c -> mostly P a c -> mostly P a' c'.
Proof.
  intros Ha Hc O d Hd. destruct (O d ltac:(lra)) as [L HL]. exists L. intros t Ht N. apply HL; [lra | exact N].
Qed.
Lemma mostly_of_list (L : list R) (P : R -> Prop) a c : (forall t, a < t < c -> ~ In t L -> P t) -> mostly P a c.
Proof. intros H c' Hc. exists L. intros t Ht. apply H. lra. Qed.
Lemma mostly_somewhere (P : R -> Prop) a c u v : mostly P a c -> a <= u -> u < v -> v <= c -> exists t, u < t < v /\ P t.
Proof.
  intros O Hu Huv Hv. destruct (O ((u + v) / 2) ltac:(lra)) as [L HL].
  destruct (time_left L u ((u + v) / 2) ltac:(lra)) as [t [Ht N]]. exists t. split; [lra|]. apply HL; [lra | exact N].
Qed.

Lemma not_growing_mostly f a c : a <= c -> (forall t, a <= t <= c -> continuous f t) ->
  mostly (fun t => exists k, is_derive f t k /\ k <= 0) a c -> f c <= f a.
Proof.
  intros Hac Cf O. destruct (Req_dec a c) as [->|N]; [lra|]. apply Rnot_lt_le. intros G.
  destruct (above_near f (f a) c) as [e [He H]]; [apply Cf; lra | exact G |].
  set (t := Rmax ((a + c) / 2) (c - e / 2)).
  assert (Ht : a < t < c /\ Rabs (t - c) < e).
  { pose proof (Rmax_l ((a + c) / 2) (c - e / 2)). pose proof (Rmax_r ((a + c) / 2) (c - e / 2)).
    assert (t < c) by (apply Rmax_lub_lt; lra). split; [unfold t in *; lra|]. rewrite Rabs_left by lra. unfold t in *. lra. }
  destruct Ht as [Ht Hd]. pose proof (H t Hd). destruct (O t ltac:(lra)) as [L HL].
  assert (f t <= f a); [|lra]. apply (not_growing L f a t); [lra | intros; apply Cf; lra | exact HL].
Qed.
Lemma sloped (f : R -> R) B t : (continuous f t -> continuous (fun t => f t - B * t) t) /\
  forall k, is_derive f t k -> is_derive (fun t => f t - B * t) t (k - B).
Proof.
  split.
  - intros Cf. apply (continuous_minus (V := R_NormedModule) f); [exact Cf | apply continuous_scaled, continuous_id].
  - intros k D. apply (is_derive_minus (V := R_NormedModule) f); [exact D | auto_derive; [exact I | ring]].
Qed.
Lemma growth_mostly f a c B : a <= c -> (forall t, a <= t <= c -> continuous f t) ->
  mostly (fun t => exists k, is_derive f t k /\ k <= B) a c -> f c - f a <= B * (c - a).
Proof.
  intros Hac Cf O. assert (f c - B * c <= f a - B * a); [|lra].
  apply (not_growing_mostly (fun t => f t - B * t)); [exact Hac | intros; apply sloped, Cf; assumption |].
  apply mostly_weaker with (2 := O). intros t _ [k [D Hk]]. exists (k - B). split; [apply sloped, D | lra].
Qed.
Lemma opposite (f : R -> R) t : (continuous f t -> continuous (fun t => - f t) t) /\
  forall k, is_derive f t k -> is_derive (fun t => - f t) t (- k).
Proof. split; [apply (continuous_opp (V := R_NormedModule)) | intros k; apply (is_derive_opp (V := R_NormedModule))]. Qed.
Lemma slope_mostly f a c B : a <= c -> (forall t, a <= t <= c -> continuous f t) ->
  mostly (fun t => exists k, is_derive f t k /\ Rabs k <= B) a c -> Rabs (f c - f a) <= B * (c - a).
Proof.
  intros Hac Cf O. apply Rabs_le. split; [|apply (growth_mostly f); [exact Hac | exact Cf |]].
  - assert (- f c - - f a <= B * (c - a)); [|lra].
    apply (growth_mostly (fun t => - f t)); [exact Hac | intros; apply opposite, Cf; assumption |].
    apply mostly_weaker with (2 := O). intros t _ [k [D Hk]]. apply Rabs_le_between in Hk. exists (- k).
    split; [apply opposite, D | lra].
  - apply mostly_weaker with (2 := O). intros t _ [k [D Hk]]. apply Rabs_le_between in Hk. exists k. split; [exact D | lra].
Qed.
Lemma bounded_slope (L : list R) f a b B : a <= b -> (forall t, a <= t <= b -> continuous f t) ->
  (forall t, a < t < b -> ~ In t L -> exists k, is_derive f t k /\ Rabs k <= B) -> Rabs (f b - f a) <= B * (b - a).
Proof. intros Hab Cf H. apply slope_mostly; [exact Hab | exact Cf | apply (mostly_of_list L), H]. Qed.

(* A function that rises where it is negative does not become negative. *)
Lemma square_of_negative x : is_derive (fun x => Rmin x 0 * Rmin x 0) x (2 * Rmin x 0).
Proof.
  destruct (Rtotal_order x 0) as [L|[->|G]].
  - rewrite Rmin_left by lra. apply (near_derive (fun x => x * x) _ x _ (- x)); [lra | | auto_derive; [exact I | ring]].
    intros z Hz. apply Rabs_lt_between in Hz. rewrite Rmin_left by lra. reflexivity.
  - apply is_derive_Reals. intros eps He. exists (mkposreal eps He). intros h Hn Hh. simpl in Hh.
    rewrite Rplus_0_l, (Rmin_left 0 0) by lra. apply Rabs_lt_between in Hh. unfold Rmin. destruct (Rle_dec h 0).
    + replace ((h * h - 0 * 0) / h - 2 * 0) with h by (field; exact Hn). apply Rabs_lt_between. exact Hh.
    + replace ((0 * 0 - 0 * 0) / h - 2 * 0) with 0 by (field; exact Hn). rewrite Rabs_R0. exact He.
  - rewrite Rmin_right by lra. replace (2 * 0) with 0 by ring.
    apply (near_derive (fun _ => 0) _ x _ x); [lra | | apply (is_derive_const (K := R_AbsRing) (V := R_NormedModule))].
    intros z Hz. apply Rabs_lt_between in Hz. rewrite Rmin_right by lra. ring.
Qed.
Lemma stays_above f a c : a <= c -> (forall t, a <= t <= c -> continuous f t) ->
  mostly (fun t => exists k, is_derive f t k /\ (f t < 0 -> 0 <= k)) a c -> 0 <= f a -> 0 <= f c.
Proof.
  intros Hac Cf O Fa.
  assert (H : Rmin (f c) 0 * Rmin (f c) 0 <= Rmin (f a) 0 * Rmin (f a) 0).
  { apply (not_growing_mostly (fun t => Rmin (f t) 0 * Rmin (f t) 0)); [exact Hac | |].
    - intros t Ht. apply (continuous_comp f (fun x => Rmin x 0 * Rmin x 0)); [apply Cf, Ht|].
      eapply continuous_of_derive, square_of_negative.
    - apply mostly_weaker with (2 := O). intros t _ [k [D Hk]]. exists (k * (2 * Rmin (f t) 0)). split.
      + apply (is_derive_comp (fun x => Rmin x 0 * Rmin x 0) f t); [apply square_of_negative | exact D].
      + destruct (Rlt_dec (f t) 0) as [L|G]; [|rewrite Rmin_right by lra; lra].
        rewrite Rmin_left by lra. pose proof (Hk L). assert (0 <= k * (- f t)) by (apply Rmult_le_pos; lra). lra. }
  rewrite (Rmin_right (f a)) in H by lra. apply Rnot_lt_le. intros L. rewrite Rmin_left in H by lra.
  assert (0 < - f c * - f c) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
