(* Under forces that are finite sums of harmonics, Coulomb's contact with mu = 1 has a motion from every start: the velocities and
   displacements of the modes, the cosines and the sines are one state, whose rate is a constant matrix. *)
Require Import Reals List Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes Sums Masses Contact OneVelocity FixedPoint Flows NoAccumulation.
Open Scope R_scope.

(* Friction as a force r, and as beta times a value of the sign *)
Lemma allowed_is_coulomb beta v r : 0 <= beta -> allowed beta v r -> exists sigma, coulomb 1 v sigma /\ beta * sigma = r.
Proof.
  intros Hb [A1 [A2 A3]]. destruct (Rtotal_order v 0) as [L|[Z|G]].
  - exists (-1). split; [repeat split; lra | rewrite A2 by exact L; ring].
  - destruct Hb as [P|<-].
    + exists (r / beta). assert (E : beta * (r / beta) = r) by (field; lra). split; [|exact E].
      split; [lra|]. split; [lra|]. intros _. split; apply (Rmult_le_reg_l beta); lra.
    + exists 0. split; [repeat split; lra | lra].
  - exists 1. split; [repeat split; lra | rewrite A1 by exact G; ring].
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
Hypothesis Hb : 0 <= beta.
Variables (n : nat) (omega : nat -> R) (p q : nat -> nat -> R).
Local Notation load := (harmonic_forces n omega p q).

Inductive part := Velocity (i : nat) | Displacement (i : nat) | Cosine (k : nat) | Sine (k : nat).
Definition part_of i := if Nat.ltb i N then Velocity i else if Nat.ltb i (N + N) then Displacement (i - N)
  else if Nat.ltb i (N + N + n) then Cosine (i - (N + N)) else Sine (i - (N + N + n)).
Local Notation m := (N + N + (n + n))%nat.
Lemma part_velocity i : (i < N)%nat -> part_of i = Velocity i.
Proof. intros H. unfold part_of. destruct (Nat.ltb_spec i N); [reflexivity | lia]. Qed.
Lemma part_displacement i : (i < N)%nat -> part_of (N + i) = Displacement i.
Proof.
  intros H. unfold part_of. destruct (Nat.ltb_spec (N + i) N); [lia|]. destruct (Nat.ltb_spec (N + i) (N + N)); [|lia].
  f_equal. lia.
Qed.
Lemma part_cosine k : (k < n)%nat -> part_of (N + N + k) = Cosine k.
Proof.
  intros H. unfold part_of. destruct (Nat.ltb_spec (N + N + k) N); [lia|]. destruct (Nat.ltb_spec (N + N + k) (N + N)); [lia|].
  destruct (Nat.ltb_spec (N + N + k) (N + N + n)); [|lia]. f_equal. lia.
Qed.
Lemma part_sine k : part_of (N + N + (n + k)) = Sine k.
Proof.
  unfold part_of. destruct (Nat.ltb_spec (N + N + (n + k)) N); [lia|].
  destruct (Nat.ltb_spec (N + N + (n + k)) (N + N)); [lia|]. destruct (Nat.ltb_spec (N + N + (n + k)) (N + N + n)); [lia|].
  f_equal. lia.
Qed.

(* The rates of the parts, without friction, and the part of each in the velocity of the contact *)
Definition entry (x y : part) := match x, y with
  | Velocity i, Velocity k => delta k i * - (2 * zeta i / R_ i)
  | Velocity i, Displacement k => delta k i * - / R_ i ^ 2
  | Velocity i, Cosine k => Sum N (fun a => psi a i * p a k)
  | Velocity i, Sine k => Sum N (fun a => psi a i * q a k)
  | Displacement i, Velocity k => delta k i
  | Cosine i, Sine k => delta k i * - omega i
  | Sine i, Cosine k => delta k i * omega i
  | _, _ => 0
  end.
Definition matrix i k := entry (part_of i) (part_of k).
Definition contact_part i := match part_of i with Velocity k => psi j k | _ => 0 end.
Lemma over_parts (F : part -> R) (X : nat -> R) : Sum m (fun k => F (part_of k) * X k) =
  Sum N (fun i => F (Velocity i) * X i) + Sum N (fun i => F (Displacement i) * X (N + i)%nat) +
  (Sum n (fun k => F (Cosine k) * X (N + N + k)%nat) + Sum n (fun k => F (Sine k) * X (N + N + (n + k))%nat)).
Proof.
  rewrite !Sum_two_parts. f_equal; f_equal; apply Sum_ext; intros i Hi.
  - rewrite part_velocity by exact Hi. reflexivity.
  - rewrite part_displacement by exact Hi. reflexivity.
  - rewrite part_cosine by exact Hi. reflexivity.
  - rewrite part_sine. reflexivity.
Qed.
Lemma Sum_none k (f : nat -> R) : Sum k (fun i => 0 * f i) = 0.
Proof. apply Sum_zero. intros; ring. Qed.
Lemma Sum_one k i c (f : nat -> R) : (i < k)%nat -> Sum k (fun a => delta a i * c * f a) = c * f i.
Proof.
  intros Hi. rewrite <- (Sum_delta k i (fun a => c * f a) Hi). apply Sum_ext. intros; ring.
Qed.
Lemma velocity_row X i : (i < N)%nat -> mul m matrix X i = - (2 * zeta i / R_ i) * X i + - / R_ i ^ 2 * X (N + i)%nat +
  (Sum n (fun k => Sum N (fun a => psi a i * p a k) * X (N + N + k)%nat) +
   Sum n (fun k => Sum N (fun a => psi a i * q a k) * X (N + N + (n + k))%nat)).
Proof.
  intros Hi. unfold mul, matrix. rewrite (over_parts (entry (part_of i))), part_velocity by exact Hi. simpl entry.
  rewrite !Sum_one by exact Hi. reflexivity.
Qed.
Lemma displacement_row X i : (i < N)%nat -> mul m matrix X (N + i) = X i.
Proof.
  intros Hi. unfold mul, matrix. rewrite (over_parts (entry (part_of (N + i)))), part_displacement by exact Hi. simpl entry.
  rewrite (Sum_delta N i X Hi), !Sum_none. ring.
Qed.
Lemma cosine_row X k : (k < n)%nat -> mul m matrix X (N + N + k) = - omega k * X (N + N + (n + k))%nat.
Proof.
  intros Hk. unfold mul, matrix. rewrite (over_parts (entry (part_of (N + N + k)))), part_cosine by exact Hk. simpl entry.
  rewrite !Sum_none, (Sum_one n k _ (fun a => X (N + N + (n + a))%nat)) by exact Hk. ring.
Qed.
Lemma sine_row X k : (k < n)%nat -> mul m matrix X (N + N + (n + k)) = omega k * X (N + N + k)%nat.
Proof.
  intros Hk. unfold mul, matrix. rewrite (over_parts (entry (part_of (N + N + (n + k))))), part_sine. simpl entry.
  rewrite !Sum_none, (Sum_one n k _ (fun a => X (N + N + a)%nat)) by exact Hk. ring.
Qed.
Lemma contact_velocity X t : speed m contact_part X t = Sum N (fun i => psi j i * X i t).
Proof.
  unfold speed, dot, contact_part.
  rewrite (over_parts (fun x => match x with Velocity k => psi j k | _ => 0 end) (fun i => X i t)), !Sum_none. ring.
Qed.
Lemma contact_part_positive : 0 < size m contact_part.
Proof.
  apply Rlt_le_trans with (1 := mobility_pos s Hs). unfold size. rewrite !Sum_two_parts.
  assert (P : forall k f, 0 <= Sum k (fun i => contact_part (f i) * contact_part (f i)))
    by (intros; apply Sum_nonneg; intros; apply Rle_0_sqr).
  pose proof (P N (fun i => N + i)%nat). pose proof (P n (fun i => N + N + i)%nat).
  pose proof (P n (fun i => N + N + (n + i))%nat).
  assert (mobility s = Sum N (fun i => contact_part i * contact_part i)); [|lra].
  apply Sum_ext. intros i Hi. unfold contact_part. rewrite part_velocity by exact Hi. ring.
Qed.

Variables u v : nat -> R.
Definition start i := match part_of i with
  | Velocity k => modal s v k
  | Displacement k => modal s u k
  | Cosine _ => 1
  | Sine _ => 0
  end.

Lemma clock X T k t : motion m matrix contact_part beta start X T -> (k < n)%nat -> 0 <= t <= T ->
  X (N + N + k)%nat t = cos (omega k * t) /\ X (N + N + (n + k))%nat t = sin (omega k * t).
Proof.
  intros [SX [CX [L M]]] Hk Ht. set (c := (N + N + k)%nat). set (d := (N + N + (n + k))%nat).
  assert (Hc : (c < m)%nat) by (unfold c; lia). assert (Hd : (d < m)%nat) by (unfold d; lia).
  set (f := fun t => (X c t - cos (omega k * t)) * (X c t - cos (omega k * t)) +
    (X d t - sin (omega k * t)) * (X d t - sin (omega k * t))).
  assert (Z : f t = f 0).
  { apply (steady_inside L f 0 T); [lra | | | exact Ht].
    - intros z Hz. assert (C : forall i (g : R -> R), (i < m)%nat -> continuous g z -> continuous (fun t => X i t - g t) z).
      { intros i g Hi Cg. apply (continuous_minus (V := R_NormedModule) (X i) g); [apply CX; [exact Hi | lra] | exact Cg]. }
      assert (Cc : continuous (fun t => cos (omega k * t)) z)
        by (eapply continuous_of_derive; auto_derive; [exact I | reflexivity]).
      assert (Cd : continuous (fun t => sin (omega k * t)) z)
        by (eapply continuous_of_derive; auto_derive; [exact I | reflexivity]).
      apply (continuous_plus (V := R_NormedModule)); apply (continuous_mult (K := R_AbsRing)); apply C; assumption.
    - intros z Hz N0. destruct (M z Hz N0) as [r [_ D]]. pose proof (D c Hc) as Dc. pose proof (D d Hd) as Dd.
      unfold c in Dc at 2 3. unfold d in Dd at 2 3. rewrite cosine_row in Dc by exact Hk. rewrite sine_row in Dd by exact Hk.
      unfold contact_part in Dc, Dd. rewrite part_cosine in Dc by exact Hk. rewrite part_sine in Dd.
      fold c d in Dc, Dd. rewrite Rmult_0_r, Rminus_0_r in Dc, Dd. unfold f.
      evar_last; [auto_derive; [repeat split; eexists; eassumption|]|reflexivity].
      change (fun x => X c x) with (X c). change (fun x => X d x) with (X d).
      rewrite (is_derive_unique _ _ _ Dc), (is_derive_unique _ _ _ Dd). fold c d. ring. }
  assert (F0 : f 0 = 0).
  { unfold f. rewrite !SX by (assumption || lra). unfold start, c, d. rewrite part_cosine, part_sine by exact Hk.
    rewrite Rmult_0_r, cos_0, sin_0. ring. }
  rewrite F0 in Z. unfold f in Z. pose proof (Rle_0_sqr (X c t - cos (omega k * t))) as P1.
  pose proof (Rle_0_sqr (X d t - sin (omega k * t))) as P2. unfold Rsqr in P1, P2.
  split; apply Rminus_diag_uniq.
  - destruct (Rmult_integral (X c t - cos (omega k * t)) (X c t - cos (omega k * t))); lra.
  - destruct (Rmult_integral (X d t - sin (omega k * t)) (X d t - sin (omega k * t))); lra.
Qed.

Lemma from_every_start : exists y y1, (forall T, motion_under s load T y y1) /\
  forall k, (k < N)%nat -> y k 0 = u k /\ y1 k 0 = v k.
Proof.
  destruct (motion_for_ever m matrix contact_part beta contact_part_positive Hb start) as [X HX].
  exists (fun k t => Sum N (fun i => psi k i * X (N + i)%nat t)), (fun k t => Sum N (fun i => psi k i * X i t)). split.
  - intros T. pose proof (HX T) as [SX [CX [L M]]]. split.
    + intros a t Ha Ht. split; [apply (continuous_Sum N (fun i t => psi a i * X (N + i)%nat t)) |
        apply (continuous_Sum N (fun i t => psi a i * X i t))]; intros i Hi; apply continuous_scaled, CX; lia || lra.
    + exists L. intros t Ht NL. destruct (M t Ht NL) as [r [Ar D]]. rewrite contact_velocity in Ar.
      destruct (allowed_is_coulomb beta _ r Hb Ar) as [sigma [Cs Er]].
      set (x2 := fun i => mul m matrix (fun k => X k t) i - r * psi j i).
      assert (DV : forall i, (i < N)%nat -> is_derive (X i) t (x2 i)).
      { intros i Hi. evar_last; [apply (D i); lia|]. unfold x2, contact_part. rewrite part_velocity by exact Hi. reflexivity. }
      assert (DD : forall i, (i < N)%nat -> is_derive (X (N + i)%nat) t (X i t)).
      { intros i Hi. evar_last; [apply (D (N + i)%nat); lia|]. unfold contact_part.
        rewrite displacement_row, part_displacement by exact Hi. ring. }
      exists (fun k => Sum N (fun i => psi k i * x2 i)), sigma. split; [exact Cs|]. intros a Ha. split; [|split].
      * apply (is_derive_Sum N (fun i t => psi a i * X (N + i)%nat t) (fun i t => psi a i * X i t)). intros i Hi.
        apply is_derive_scal, DD, Hi.
      * apply (is_derive_Sum N (fun i t => psi a i * X i t) (fun i t => psi a i * x2 i)). intros i Hi.
        apply is_derive_scal, DV, Hi.
      * rewrite (row s Hs a x2 (fun i => X i t) (fun i => X (N + i)%nat t) Ha).
        rewrite (Sum_ext N _ (fun i => Sum N (fun c => MP s a i * psi c i * load c t) - MP s a i * psi j i * r)).
        -- rewrite Sum_minus, Sum_swap, Sum_scal_r, (complete_1 s Hs a j Ha (Hj s Hs)).
           rewrite (Sum_ext N _ (fun c => delta c a * load c t))
             by (intros c Hc; rewrite Sum_scal_r, (complete_1 s Hs a c Ha Hc), delta_sym; reflexivity).
           rewrite (Sum_delta N a (fun c => load c t) Ha). rewrite <- Er. ring.
        -- intros i Hi. unfold x2. rewrite velocity_row by exact Hi. unfold Rdiv.
           transitivity (MP s a i * (Sum n (fun k => Sum N (fun c => psi c i * p c k) * cos (omega k * t)) +
             Sum n (fun k => Sum N (fun c => psi c i * q c k) * sin (omega k * t))) - MP s a i * psi j i * r).
           { rewrite (Sum_ext n (fun k => Sum N (fun a => psi a i * p a k) * X (N + N + k)%nat t)
               (fun k => Sum N (fun c => psi c i * p c k) * cos (omega k * t)))
               by (intros k Hk; destruct (clock X T k t (HX T) Hk ltac:(lra)) as [-> _]; reflexivity).
             rewrite (Sum_ext n (fun k => Sum N (fun a => psi a i * q a k) * X (N + N + (n + k))%nat t)
               (fun k => Sum N (fun c => psi c i * q c k) * sin (omega k * t)))
               by (intros k Hk; destruct (clock X T k t (HX T) Hk ltac:(lra)) as [_ ->]; reflexivity). ring. }
           f_equal. rewrite <- Sum_plus, <- Sum_scal.
           rewrite (Sum_ext n _ (fun k => Sum N (fun c =>
               MP s a i * psi c i * (p c k * cos (omega k * t) + q c k * sin (omega k * t)))))
             by (intros k Hk; rewrite <- !Sum_scal_r, <- Sum_plus, <- Sum_scal; apply Sum_ext; intros; ring).
           rewrite Sum_swap. apply Sum_ext. intros c Hc. rewrite Sum_scal. reflexivity.
  - intros k Hk. destruct (HX 0) as [SX _]. rewrite (physical s Hs u k Hk), (physical s Hs v k Hk).
    split; apply Sum_ext; intros i Hi; f_equal; rewrite SX by (lia || lra); unfold start;
      [rewrite part_displacement | rewrite part_velocity]; auto.
Qed.
End Scene.
