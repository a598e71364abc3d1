(* Linear equations x' = B x + w with constant coefficients have solutions on the whole axis, power series in t; and a function
   that is such a series has one sign on an interval that begins or ends at 0. *)
Require Import Reals List Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes Sums OneVelocity Slopes.
Open Scope R_scope.

Lemma same_sign x y : 0 < x * y -> 0 < x /\ 0 < y \/ x < 0 /\ y < 0.
Proof. intros H. destruct (Rtotal_order x 0) as [X|[->|X]]; [right | lra | left]; split; nra. Qed.

(* ---- Power series that converge everywhere ---- *)
Definition entire (a : nat -> R) := CV_radius a = p_infty.
Lemma entire_radius a x : entire a -> Rbar_lt (Rabs x) (CV_radius a).
Proof. intros ->. exact I. Qed.
Lemma entire_by_bounds a : (forall r, exists M, forall n, Rabs (a n * r ^ n) <= M) -> entire a.
Proof.
  intros H. unfold entire. destruct (CV_radius_bounded a) as [Up _]. destruct (CV_radius a) as [c| |]; [| reflexivity |].
  - exfalso. pose proof (Up (c + 1) (H _)) as L. simpl in L. lra.
  - exfalso. exact (Up 0 (H _)).
Qed.
Lemma entire_plus a b : entire a -> entire b -> entire (fun k => a k + b k).
Proof.
  intros A B. pose proof (CV_radius_plus a b) as H. rewrite A, B in H. unfold entire.
  change (fun k => a k + b k) with (PS_plus a b).
  destruct (CV_radius (PS_plus a b)); [contradiction | reflexivity | contradiction].
Qed.
Lemma entire_scal c a : entire a -> entire (fun k => c * a k).
Proof.
  intros A. unfold entire. destruct (Req_dec c 0) as [->|N]; [|rewrite <- A; apply (CV_radius_scal c a N)].
  rewrite (CV_radius_ext _ (fun _ => 0)) by (intros; ring). apply CV_radius_const_0.
Qed.
Lemma entire_Sum m (c : nat -> R) (a : nat -> nat -> R) : (forall i, (i < m)%nat -> entire (a i)) ->
  entire (fun k => Sum m (fun i => c i * a i k)) /\
  forall t, PSeries (fun k => Sum m (fun i => c i * a i k)) t = Sum m (fun i => c i * PSeries (a i) t).
Proof.
  induction m; intros H; simpl; [split; [apply CV_radius_const_0 | apply PSeries_const_0]|].
  destruct IHm as [E P]; [intros; apply H; lia|]. pose proof (H m ltac:(lia)) as Hm. split.
  - apply (entire_plus (fun k => Sum m (fun i => c i * a i k))); [exact E | apply entire_scal, Hm].
  - intros t. rewrite <- P, <- PSeries_scal, <- PSeries_plus.
    + reflexivity.
    + apply CV_radius_inside, entire_radius, E.
    + apply CV_radius_inside, entire_radius, (entire_scal (c m) (a m)), Hm.
Qed.
Lemma entire_constant c : let a := fun k : nat => match k with O => c | _ => 0 end in entire a /\ forall t, PSeries a t = c.
Proof.
  intros a. assert (E : entire a).
  { apply entire_by_bounds. intros r. exists (Rabs c). intros [|n]; simpl; [rewrite Rmult_1_r; lra|].
    rewrite Rmult_0_l, Rabs_R0. apply Rabs_pos. }
  split; [exact E|]. intros t. rewrite PSeries_decr_1 by apply CV_radius_inside, entire_radius, E.
  unfold PS_decr_1. simpl. rewrite PSeries_const_0. ring.
Qed.

Definition analytic (f : R -> R) := exists a, entire a /\ forall t, f t = PSeries a t.
Lemma analytic_plus_constant f c : analytic f -> analytic (fun t => f t + c).
Proof.
  intros [a [A E]]. destruct (entire_constant c) as [B P]. set (b := fun k : nat => _) in *.
  exists (fun k => a k + b k). split; [apply entire_plus; assumption|]. intros t. rewrite E, <- (P t) at 1. symmetry.
  apply PSeries_plus; apply CV_radius_inside, entire_radius; assumption.
Qed.
Lemma analytic_Sum m (c : nat -> R) (f : nat -> R -> R) (a : nat -> nat -> R) :
  (forall i, (i < m)%nat -> entire (a i) /\ forall t, f i t = PSeries (a i) t) ->
  analytic (fun t => Sum m (fun i => c i * f i t)).
Proof.
  intros H. destruct (entire_Sum m c a) as [E P]; [intros; apply H; assumption|].
  exists (fun k => Sum m (fun i => c i * a i k)). split; [exact E|]. intros t. rewrite P. apply Sum_ext. intros i Hi.
  f_equal. apply H, Hi.
Qed.
Lemma analytic_derivative f : analytic f -> exists f1, analytic f1 /\ forall t, is_derive f t (f1 t).
Proof.
  intros [a [A E]]. exists (PSeries (PS_derive a)). split.
  - exists (PS_derive a). split; [unfold entire; rewrite CV_radius_derive; exact A | reflexivity].
  - intros t. apply (is_derive_ext (PSeries a)); [intros; symmetry; apply E|]. apply is_derive_PSeries, entire_radius, A.
Qed.
Lemma analytic_continuous f t : analytic f -> continuous f t.
Proof. intros A. destruct (analytic_derivative f A) as [f1 [_ D]]. eapply continuous_of_derive, D. Qed.

(* The first power whose coefficient is not zero *)
Lemma first_power f : analytic f -> (forall t, f t = 0) \/
  exists n h, analytic h /\ h 0 <> 0 /\ forall t, f t = t ^ n * h t.
Proof.
  intros [a [A E]].
  assert (Q : forall n, (forall k, (k < n)%nat -> a k = 0) \/ exists k, a k <> 0 /\ forall i, (i < k)%nat -> a i = 0).
  { induction n as [|n [Z|P]]; [left; intros; lia | | right; exact P].
    destruct (Req_dec (a n) 0) as [Z0|N]; [left | right; exists n; split; assumption].
    intros k Hk. destruct (Nat.eq_dec k n) as [->|]; [exact Z0 | apply Z; lia]. }
  destruct (Classical_Prop.classic (exists k, a k <> 0 /\ forall i, (i < k)%nat -> a i = 0)) as [[n [N Z]]|None].
  - right. exists n, (PSeries (PS_decr_n a n)). split; [|split].
    + exists (PS_decr_n a n). split; [|reflexivity]. clear - A. induction n as [|n IH]; [exact A|].
      unfold entire in *. rewrite <- IH, <- (CV_radius_decr_1 (PS_decr_n a n)). apply CV_radius_ext.
      intros k. unfold PS_decr_1, PS_decr_n. f_equal. lia.
    + rewrite PSeries_0. unfold PS_decr_n. rewrite Nat.add_0_r. exact N.
    + intros t. rewrite E. apply PSeries_decr_n_aux, Z.
  - left. intros t. rewrite E, (PSeries_ext a (fun _ => 0)), PSeries_const_0; [reflexivity|].
    intros n. destruct (Q (S n)) as [Z|P]; [apply Z; lia | contradiction].
Qed.
(* After 0 the function has one sign for some time. *)
Lemma sign_after f : analytic f -> exists e, 0 < e /\
  ((forall t, 0 < t < e -> f t = 0) \/ (forall t, 0 < t < e -> 0 < f t) \/ (forall t, 0 < t < e -> f t < 0)).
Proof.
  intros A. destruct (first_power f A) as [Z|[n [h [B [N E]]]]]; [exists 1; split; [lra | left; intros; apply Z]|].
  destruct (above_near (fun t => h t * h 0) 0 0) as [e [He P]].
  - apply (continuous_mult (K := R_AbsRing)); [apply analytic_continuous, B | apply continuous_const].
  - assert (0 < Rsqr (h 0)) by (apply Rlt_0_sqr, N). unfold Rsqr in *. lra.
  - exists e. split; [exact He|]. right.
    assert (Q : forall t, 0 < t < e -> 0 < t ^ n /\ 0 < h t * h 0).
    { intros t Ht. split; [apply pow_lt; lra | apply P; rewrite Rminus_0_r, Rabs_right; lra]. }
    destruct (Rtotal_order (h 0) 0) as [L|[Z|G]]; [right | contradiction | left]; intros t Ht; destruct (Q t Ht) as [Tn Hh];
      rewrite E; destruct (same_sign _ _ Hh); try lra.
    + rewrite <- (Rmult_0_r (t ^ n)). apply Rmult_lt_compat_l; lra.
    + apply Rmult_lt_0_compat; lra.
Qed.
(* If it falls to 0 at 0 and is not negative before, it is 0 before, or its rate is large against its value. *)
Lemma falls_before f f1 c e : analytic f -> (forall t, is_derive f t (f1 t)) -> f 0 = 0 -> 0 < e ->
  (forall t, - e < t < 0 -> 0 <= f t) -> exists d, 0 < d <= e /\
  ((forall t, - d < t < 0 -> f t = 0) \/ (forall t, - d < t < 0 -> f1 t + c * f t <= 0)).
Proof.
  intros A D F0 He P. destruct (first_power f A) as [Z|[n [h [B [N E]]]]]; [exists e; split; [lra | left; intros; apply Z]|].
  destruct (analytic_derivative h B) as [h1 [B1 D1]].
  assert (Hn : (0 < n)%nat).
  { destruct n; [|lia]. exfalso. apply N. rewrite E in F0. simpl in F0. lra. }
  destruct (above_near (fun t => h t * (INR n * h t + t * (h1 t + c * h t))) 0 0) as [d [Hd Q]].
  - assert (Ch : continuous h 0) by apply analytic_continuous, B. assert (Ch1 : continuous h1 0) by apply analytic_continuous, B1.
    apply (continuous_mult (K := R_AbsRing) h); [exact Ch|].
    apply (continuous_plus (V := R_NormedModule) (fun t => INR n * h t)); [apply continuous_scaled, Ch|].
    apply (continuous_mult (K := R_AbsRing) (fun t => t)); [apply continuous_id|].
    apply (continuous_plus (V := R_NormedModule) h1); [exact Ch1 | apply continuous_scaled, Ch].
  - assert (0 < Rsqr (h 0)) by (apply Rlt_0_sqr, N). unfold Rsqr in *. pose proof (lt_INR 0 n Hn) as Pn. simpl in Pn.
    replace (h 0 * (INR n * h 0 + 0 * (h1 0 + c * h 0))) with (INR n * (h 0 * h 0)) by ring. apply Rmult_lt_0_compat; lra.
  - exists (Rmin d e). pose proof (Rmin_l d e). pose proof (Rmin_r d e).
    split; [split; [apply Rmin_glb_lt; assumption | lra]|]. right. intros t Ht.
    assert (X : 0 < h t * (INR n * h t + t * (h1 t + c * h t))).
    { apply Q. rewrite Rminus_0_r, Rabs_left by lra. lra. }
    assert (F1 : t * f1 t = t ^ n * (INR n * h t + t * h1 t)).
    { assert (Dp : is_derive f t (INR n * t ^ pred n * h t + t ^ n * h1 t)).
      { apply (is_derive_ext (fun t => t ^ n * h t)); [intros; symmetry; apply E|].
        apply (is_derive_mult (K := R_AbsRing) (fun t => t ^ n) h); [| apply D1 | intros; apply Rmult_comm].
        auto_derive; [exact I | ring]. }
      rewrite <- (is_derive_unique _ _ _ (D t)), (is_derive_unique _ _ _ Dp).
      destruct n; [lia|]. simpl pred. rewrite <- (tech_pow_Rmult t n). ring. }
    assert (Tn : t ^ n <> 0) by (apply pow_nonzero; lra).
    assert (Pf : 0 <= t ^ n * h t) by (rewrite <- E; apply P; lra).
    assert (Y : 0 <= t * (f1 t + c * f t)).
    { set (z := INR n * h t + t * (h1 t + c * h t)) in *.
      replace (t * (f1 t + c * f t)) with (t ^ n * z) by (rewrite (E t); unfold z; lra).
      assert (H2 : 0 < h t * h t) by (destruct (same_sign _ _ X); [|rewrite <- Rmult_opp_opp]; apply Rmult_lt_0_compat; lra).
      apply (Rmult_le_reg_l (h t * h t)); [exact H2|]. rewrite Rmult_0_r.
      replace (h t * h t * (t ^ n * z)) with (t ^ n * h t * (h t * z)) by ring. apply Rmult_le_pos; [exact Pf | lra]. }
    apply Rnot_lt_le. intros G. assert (0 < - t * (f1 t + c * f t)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(* ---- Matrices ---- *)
Section Flow.
Variable m : nat.
Definition dot (c x : nat -> R) := Sum m (fun i => c i * x i).
Definition mul (B : nat -> nat -> R) (x : nat -> R) i := Sum m (fun k => B i k * x k).
(* The sum of the components without their signs *)
Definition length (x : nat -> R) := Sum m (fun i => Rabs (x i)).
Lemma length_nonneg x : 0 <= length x.
Proof. apply Sum_nonneg. intros. apply Rabs_pos. Qed.
Lemma length_part x i : (i < m)%nat -> Rabs (x i) <= length x.
Proof. intros Hi. apply (Sum_part m (fun i => Rabs (x i))); [intros; apply Rabs_pos | exact Hi]. Qed.
Lemma dot_bound c x : Rabs (dot c x) <= length c * length x.
Proof.
  apply Rle_trans with (1 := Sum_abs m _). unfold length at 1. rewrite <- Sum_scal_r. apply Sum_le. intros k Hk.
  rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos | apply length_part, Hk].
Qed.
Definition norm (B : nat -> nat -> R) := Sum m (fun i => length (B i)).
Lemma norm_nonneg B : 0 <= norm B.
Proof. apply Sum_nonneg. intros. apply length_nonneg. Qed.
Lemma mul_length B x : length (mul B x) <= norm B * length x.
Proof. unfold norm. rewrite <- Sum_scal_r. apply Sum_le. intros i _. apply dot_bound. Qed.

(* ---- The flow of x' = B x + w ---- *)
Variables (B : nat -> nat -> R) (w x : nat -> R).
Fixpoint coefficient (k : nat) : nat -> R :=
  match k with O => x | S n => fun i => (mul B (coefficient n) i + match n with O => w i | _ => 0 end) / INR (S n) end.
Definition flow i t := PSeries (fun k => coefficient k i) t.

Lemma coefficient_entire i : (i < m)%nat -> entire (fun k => coefficient k i).
Proof.
  intros Hi. apply entire_by_bounds. intros r. set (u := fun k => length (coefficient k) * Rabs r ^ k).
  assert (U0 : forall k, 0 <= u k) by (intros; apply Rmult_le_pos; [apply length_nonneg | apply pow_le, Rabs_pos]).
  destruct (nfloor_ex (norm B * Rabs r)) as [n0 [_ Hn]]; [apply Rmult_le_pos; [apply norm_nonneg | apply Rabs_pos]|].
    rewrite <- S_INR in Hn.
  assert (Step : forall k, (0 < k)%nat -> (n0 <= k)%nat -> u (S k) <= u k).
  { intros k Hk Hk0. destruct k as [|n]; [lia|]. unfold u.
    assert (P : 0 < INR (S (S n))) by (apply lt_0_INR; lia).
    assert (L : length (coefficient (S (S n))) * INR (S (S n)) <= norm B * length (coefficient (S n))).
    { apply Rle_trans with (2 := mul_length B (coefficient (S n))). unfold length at 1. rewrite <- Sum_scal_r.
      apply Sum_le. intros a _. apply Req_le.
      change (coefficient (S (S n)) a) with ((mul B (coefficient (S n)) a + 0) / INR (S (S n))).
      rewrite Rplus_0_r. unfold Rdiv. rewrite Rabs_mult, Rabs_inv, (Rabs_right (INR (S (S n)))) by lra. field. lra. }
    apply (Rmult_le_reg_r (INR (S (S n)))); [exact P|]. rewrite <- (tech_pow_Rmult (Rabs r) (S n)).
    assert (Q : norm B * Rabs r <= INR (S (S n))).
    { apply Rlt_le, Rlt_le_trans with (1 := Hn), le_INR. lia. }
    pose proof (length_nonneg (coefficient (S n))) as L0. pose proof (Rabs_pos r) as R0.
    assert (Pn : 0 <= Rabs r ^ S n) by apply pow_le, R0. set (p := Rabs r ^ S n) in *.
    set (a := length (coefficient (S n))) in *. set (a' := length (coefficient (S (S n)))) in *.
    replace (a' * (Rabs r * p) * INR (S (S n))) with (a' * INR (S (S n)) * (Rabs r * p)) by ring.
    apply Rle_trans with (norm B * a * (Rabs r * p)); [apply Rmult_le_compat_r; [apply Rmult_le_pos; assumption | exact L]|].
    replace (norm B * a * (Rabs r * p)) with (norm B * Rabs r * (a * p)) by ring. rewrite (Rmult_comm (a * p)).
    apply Rmult_le_compat_r; [apply Rmult_le_pos; assumption | exact Q]. }
  exists (Sum (S (S n0)) u). intros n. apply Rle_trans with (u n).
  - unfold u. rewrite Rabs_mult, RPow_abs. apply Rmult_le_compat_r; [apply Rabs_pos | apply length_part, Hi].
  - induction n as [|n IH].
    + apply (Sum_part (S (S n0)) u); [intros; apply U0 | lia].
    + destruct (Nat.lt_ge_cases (S n) (S (S n0))) as [L|G].
      * apply (Sum_part (S (S n0)) u); [intros; apply U0 | exact L].
      * apply Rle_trans with (2 := IH), Step; lia.
Qed.
Lemma flow_start i : flow i 0 = x i.
Proof. unfold flow. rewrite PSeries_0. reflexivity. Qed.
Lemma flow_rate i t : (i < m)%nat -> is_derive (flow i) t (mul B (fun k => flow k t) i + w i).
Proof.
  intros Hi. pose proof (coefficient_entire i Hi) as E.
  destruct (entire_Sum m (B i) (fun k n => coefficient n k) coefficient_entire) as [ES PS].
  destruct (entire_constant (w i)) as [EC PC]. set (a := fun k : nat => _) in EC, PC.
  evar_last; [apply is_derive_PSeries, entire_radius, E|]. unfold mul, flow. rewrite <- PS, <- (PC t) at 1.
  rewrite <- PSeries_plus by (apply CV_radius_inside, entire_radius; assumption).
  apply PSeries_ext. intros n. unfold PS_derive, PS_plus. simpl coefficient. unfold mul, plus, a. simpl plus.
  change (INR (S n) * ((Sum m (fun k => B i k * coefficient n k) + match n with O => w i | _ => 0 end) / INR (S n)) =
    Sum m (fun k => B i k * coefficient n k) + match n with O => w i | _ => 0 end).
  field. apply not_0_INR. lia.
Qed.
Lemma flow_continuous i t : (i < m)%nat -> continuous (flow i) t.
Proof. intros Hi. eapply continuous_of_derive, flow_rate, Hi. Qed.
Lemma flow_analytic c : analytic (fun t => dot c (fun i => flow i t)).
Proof.
  apply (analytic_Sum m c flow (fun i k => coefficient k i)). intros i Hi.
  split; [apply coefficient_entire, Hi | reflexivity].
Qed.
End Flow.
