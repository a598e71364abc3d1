(* Finite sums, and that a square matrix with an inverse on one side has it on the other. *)
Require Import Reals Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements.
Open Scope R_scope.

Lemma Sum_ext n f h : (forall i, (i < n)%nat -> f i = h i) -> Sum n f = Sum n h.
Proof. induction n; intros H; simpl; [reflexivity|]. rewrite IHn by (intros; apply H; lia). rewrite H by lia. reflexivity. Qed.
Lemma Sum_plus n f h : Sum n (fun i => f i + h i) = Sum n f + Sum n h.
Proof. induction n; simpl; [ring|]. rewrite IHn. ring. Qed.
Lemma Sum_minus n f h : Sum n (fun i => f i - h i) = Sum n f - Sum n h.
Proof. induction n; simpl; [ring|]. rewrite IHn. ring. Qed.
Lemma Sum_scal n c f : Sum n (fun i => c * f i) = c * Sum n f.
Proof. induction n; simpl; [ring|]. rewrite IHn. ring. Qed.
Lemma Sum_scal_r n c f : Sum n (fun i => f i * c) = Sum n f * c.
Proof. induction n; simpl; [ring|]. rewrite IHn. ring. Qed.
Lemma Sum_opp n f : Sum n (fun i => - f i) = - Sum n f.
Proof. induction n; simpl; [ring|]. rewrite IHn. ring. Qed.
Lemma Sum_zero n f : (forall i, (i < n)%nat -> f i = 0) -> Sum n f = 0.
Proof. induction n; intros H; simpl; [reflexivity|]. rewrite IHn, H by (intros; try apply H; lia). ring. Qed.
Lemma Sum_swap n m (f : nat -> nat -> R) : Sum n (fun i => Sum m (fun k => f i k)) = Sum m (fun k => Sum n (fun i => f i k)).
Proof. induction n; simpl; [symmetry; apply Sum_zero; reflexivity|]. rewrite IHn, <- Sum_plus. reflexivity. Qed.
Lemma Sum_nonneg n f : (forall i, (i < n)%nat -> 0 <= f i) -> 0 <= Sum n f.
Proof. induction n; intros H; simpl; [lra|]. pose proof (H n ltac:(lia)). assert (0 <= Sum n f) by (apply IHn; intros; apply H;
  lia). lra. Qed.
Lemma Sum_le n f h : (forall i, (i < n)%nat -> f i <= h i) -> Sum n f <= Sum n h.
Proof. induction n; intros H; simpl; [lra|]. pose proof (H n ltac:(lia)). assert (Sum n f <= Sum n h) by (apply IHn; intros;
  apply H; lia). lra. Qed.
Lemma Sum_nonneg_zero n f : (forall i, (i < n)%nat -> 0 <= f i) -> Sum n f = 0 -> forall i, (i < n)%nat -> f i = 0.
Proof.
  induction n; intros H E i Hi; [lia|]. simpl in E. pose proof (H n ltac:(lia)).
  assert (0 <= Sum n f) by (apply Sum_nonneg; intros; apply H; lia).
  destruct (Nat.eq_dec i n) as [->|]; [lra|]. apply IHn; [intros; apply H; lia | lra | lia].
Qed.
Lemma Sum_abs n f : Rabs (Sum n f) <= Sum n (fun i => Rabs (f i)).
Proof. induction n; simpl; [rewrite Rabs_R0; lra|]. pose proof (Rabs_triang (Sum n f) (f n)). lra. Qed.
Lemma Sum_part n f i : (forall i, (i < n)%nat -> 0 <= f i) -> (i < n)%nat -> f i <= Sum n f.
Proof.
  induction n; intros H Hi; [lia|]. simpl. pose proof (H n ltac:(lia)).
  assert (0 <= Sum n f) by (apply Sum_nonneg; intros; apply H; lia).
  destruct (Nat.eq_dec i n) as [->|]; [lra|]. assert (f i <= Sum n f) by (apply IHn; [intros; apply H; lia | lia]). lra.
Qed.
Lemma delta_same a : delta a a = 1.
Proof. unfold delta. rewrite Nat.eqb_refl. reflexivity. Qed.
Lemma delta_other a b : a <> b -> delta a b = 0.
Proof. unfold delta. intros H. destruct (Nat.eqb_spec a b); [contradiction | reflexivity]. Qed.
Lemma delta_sym a b : delta a b = delta b a.
Proof. unfold delta. rewrite Nat.eqb_sym. reflexivity. Qed.
Lemma Sum_delta n k f : (k < n)%nat -> Sum n (fun i => delta i k * f i) = f k.
Proof.
  induction n; intros H; [lia|]. simpl. destruct (Nat.eq_dec k n) as [->|].
  - rewrite delta_same, Sum_zero; [ring|]. intros i Hi. rewrite delta_other by lia. ring.
  - rewrite IHn, (delta_other n k) by lia. ring.
Qed.
Lemma Sum_delta_r n k f : (k < n)%nat -> Sum n (fun i => f i * delta i k) = f k.
Proof. intros H. rewrite <- (Sum_delta n k f H). apply Sum_ext. intros. ring. Qed.
Lemma Sum_single n k f : (k < n)%nat -> (forall i, (i < n)%nat -> i <> k -> f i = 0) -> Sum n f = f k.
Proof.
  intros Hk H. rewrite <- (Sum_delta n k f Hk). apply Sum_ext. intros i Hi.
  destruct (Nat.eq_dec i k) as [->|]; [rewrite delta_same; ring | rewrite H, delta_other by assumption; ring].
Qed.

Lemma Sum_two_parts n k f : Sum (n + k) f = Sum n f + Sum k (fun i => f (n + i)%nat).
Proof. induction k; [rewrite Nat.add_0_r; simpl; ring|]. rewrite Nat.add_succ_r. simpl. rewrite IHk. ring. Qed.

Lemma is_derive_Sum n (f h : nat -> R -> R) t : (forall i, (i < n)%nat -> is_derive (f i) t (h i t)) ->
  is_derive (fun t => Sum n (fun i => f i t)) t (Sum n (fun i => h i t)).
Proof.
  induction n; intros H; simpl.
  - apply (is_derive_const (K := R_AbsRing) (V := R_NormedModule) 0).
  - apply (is_derive_plus (K := R_AbsRing) (V := R_NormedModule)); [apply IHn; intros; apply H; lia | apply H; lia].
Qed.
Lemma continuous_Sum n (f : nat -> R -> R) t : (forall i, (i < n)%nat -> continuous (f i) t) ->
  continuous (fun t => Sum n (fun i => f i t)) t.
Proof.
  induction n; intros H; simpl.
  - apply continuous_const.
  - apply (continuous_plus (V := R_NormedModule)); [apply IHn; intros; apply H; lia | apply H; lia].
Qed.
Lemma continuous_scaled (f : R -> R) c t : continuous f t -> continuous (fun t => c * f t) t.
Proof. intros H. apply (continuous_mult (K := R_AbsRing)); [apply continuous_const | exact H]. Qed.

(* n equations in n + 1 unknowns have a solution that is not zero. *)
Lemma zero_column n (f : nat -> R) : (forall i, (i < n)%nat -> f i = 0) \/ exists p, (p < n)%nat /\ f p <> 0.
Proof.
  induction n; [left; intros; lia|]. destruct IHn as [H|[p [Hp Hf]]]; [|right; exists p; split; [lia | exact Hf]].
  destruct (Req_EM_T (f n) 0) as [E|E]; [left | right; exists n; split; [lia | exact E]].
  intros i Hi. destruct (Nat.eq_dec i n) as [->|]; [exact E | apply H; lia].
Qed.

Lemma underdetermined n : forall a : nat -> nat -> R, exists x, (exists k, (k < S n)%nat /\ x k <> 0) /\
  forall i, (i < n)%nat -> Sum (S n) (fun k => a i k * x k) = 0.
Proof.
  induction n; intros a.
  - exists (fun _ => 1). split; [exists O; split; [lia | lra] | intros; lia].
  - destruct (zero_column (S n) (fun i => a i (S n))) as [H|[p [Hp Hf]]].
    + exists (fun k => delta k (S n)). split; [exists (S n); split; [lia | rewrite delta_same; lra]|].
      intros i Hi. rewrite Sum_delta_r by lia. apply H, Hi.
    + set (sw := fun i => if Nat.eqb i p then n else i).
      destruct (IHn (fun i k => a (sw i) k - a (sw i) (S n) / a p (S n) * a p k)) as [x [[k [Hk Hx]] E]].
      set (P := Sum (S n) (fun k => a p k * x k)).
      set (y := fun k => if Nat.eqb k (S n) then - P / a p (S n) else x k). exists y. split.
      * exists k. split; [lia|]. unfold y. destruct (Nat.eqb_spec k (S n)); [lia | exact Hx].
      * assert (Y : forall i, Sum (S (S n)) (fun k => a i k * y k) = Sum (S n) (fun k => a i k * x k) + a i (S n) * (- P / a p
        (S n))).
        { intros i. change (Sum (S (S n)) (fun k => a i k * y k)) with (Sum (S n) (fun k => a i k * y k) + a i (S n) * y (S n)).
          f_equal.
          - apply Sum_ext. intros c Hc. unfold y. destruct (Nat.eqb_spec c (S n)); [lia | reflexivity].
          - unfold y. rewrite Nat.eqb_refl. reflexivity. }
        assert (Z : forall i, (i < n)%nat -> Sum (S n) (fun k => a (sw i) k * x k) = a (sw i) (S n) / a p (S n) * P).
        { intros i Hi. unfold P. rewrite <- Sum_scal. apply Rminus_diag_uniq. rewrite <- Sum_minus. rewrite <- (E i Hi). apply
          Sum_ext. intros; ring. }
        intros i Hi. rewrite Y. destruct (Nat.eq_dec i p) as [->|Hip].
        -- fold P. field. exact Hf.
        -- destruct (Nat.eq_dec i n) as [->|Hin].
           ++ assert (Hpn : (p < n)%nat) by lia. specialize (Z p Hpn). unfold sw in Z. rewrite Nat.eqb_refl in Z. rewrite Z.
             field. exact Hf.
           ++ assert (Hi' : (i < n)%nat) by lia. specialize (Z i Hi'). unfold sw in Z.
              destruct (Nat.eqb_spec i p); [contradiction|]. rewrite Z. field. exact Hf.
Qed.

Lemma product_applied n (A B : nat -> nat -> R) z : (forall i k, (i < n)%nat -> (k < n)%nat -> Sum n (fun a => A i a * B a k) =
  delta i k) ->
  forall i, (i < n)%nat -> Sum n (fun a => A i a * Sum n (fun c => B a c * z c)) = z i.
Proof.
  intros H i Hi. transitivity (Sum n (fun c => Sum n (fun a => A i a * B a c) * z c)).
  - rewrite (Sum_ext n _ (fun a => Sum n (fun c => A i a * B a c * z c))) by (intros; rewrite <- Sum_scal; apply Sum_ext;
    intros; ring).
    rewrite Sum_swap. apply Sum_ext. intros. apply Sum_scal_r.
  - rewrite (Sum_ext n _ (fun c => delta c i * z c)) by (intros; rewrite H, delta_sym by assumption; reflexivity).
    apply Sum_delta, Hi.
Qed.

Lemma other_inverse n (A B : nat -> nat -> R) : (forall i k, (i < n)%nat -> (k < n)%nat -> Sum n (fun a => A i a * B a k) =
  delta i k) ->
  forall i k, (i < n)%nat -> (k < n)%nat -> Sum n (fun a => B i a * A a k) = delta i k.
Proof.
  intros H i k Hi Hk. set (y := fun c => delta c k).
  destruct (underdetermined n (fun i c => if Nat.eqb c n then y i else B i c)) as [x [[m [Hm Hx]] E]].
  assert (E' : forall i, (i < n)%nat -> Sum n (fun c => B i c * x c) + y i * x n = 0).
  { intros a Ha. rewrite <- (E a Ha). simpl. rewrite Nat.eqb_refl. f_equal. apply Sum_ext. intros c Hc.
    destruct (Nat.eqb_spec c n); [lia | reflexivity]. }
  assert (Xn : x n <> 0).
  { intros Z. destruct (Nat.eq_dec m n) as [->|]; [contradiction|]. apply Hx.
    rewrite <- (product_applied n A B x H m) by lia. apply Sum_zero. intros a Ha. specialize (E' a Ha). rewrite Z in E'.
    replace (Sum n (fun c => B a c * x c)) with 0 by lra. ring. }
  set (z := fun c => - x c / x n).
  assert (Y : forall i, (i < n)%nat -> y i = Sum n (fun c => B i c * z c)).
  { intros a Ha. unfold z. rewrite (Sum_ext n _ (fun c => - / x n * (B a c * x c))) by (intros; field; exact Xn).
    rewrite Sum_scal. specialize (E' a Ha). replace (Sum n (fun c => B a c * x c)) with (- (y a * x n)) by lra. field. exact Xn. }
  transitivity (Sum n (fun a => B i a * Sum n (fun c => A a c * y c))).
  - apply Sum_ext. intros a Ha. f_equal. symmetry. unfold y. apply (Sum_delta_r n k (A a)). exact Hk.
  - transitivity (y i); [|reflexivity]. rewrite (Y i Hi). apply Sum_ext. intros a Ha. f_equal.
    rewrite <- (product_applied n A B z H a Ha). apply Sum_ext. intros c Hc. f_equal. apply Y, Hc.
Qed.
