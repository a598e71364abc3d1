(* Coulomb's contact with mu = 1, as an equation x' = A x - r b with a constant matrix A: v = b.x is the velocity of the contact,
   and the friction r is beta where v > 0, - beta where v < 0, and between them where v = 0. From every start there is a motion,
   and in a finite time it has a finite number of events. *)
Require Import Reals List Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes Sums OneVelocity FixedPoint Slopes Flows.
Open Scope R_scope.

Section Contact.
Variables (m : nat) (A : nat -> nat -> R) (b : nat -> R) (beta : R).
Hypothesis Hb : 0 < size m b.
Hypothesis Hbeta : 0 <= beta.
Local Notation dot := (dot m).
Local Notation mul := (mul m).
Local Notation length := (length m).

(* The velocity of the contact, and the friction that would leave it unchanged; the friction that a velocity allows; and that
   the equation holds at the time t *)
Definition speed (X : nat -> R -> R) t := dot b (fun i => X i t).
Definition hold (X : nat -> R -> R) t := dot b (mul A (fun i => X i t)) / size m b.
Definition allowed v r := (0 < v -> r = beta) /\ (v < 0 -> r = - beta) /\ - beta <= r <= beta.
Definition moves (X : nat -> R -> R) t := exists r, allowed (speed X t) r /\
  forall i, (i < m)%nat -> is_derive (X i) t (mul A (fun k => X k t) i - r * b i).
(* Continuity on a closed interval *)
Definition continuous_between (X : nat -> R -> R) a c := forall i t, (i < m)%nat -> a <= t <= c -> continuous (X i) t.

Lemma dot_ext c x y : (forall i, (i < m)%nat -> x i = y i) -> dot c x = dot c y.
Proof. intros H. apply Sum_ext. intros i Hi. rewrite H by exact Hi. reflexivity. Qed.
Lemma mul_ext B x y i : (forall k, (k < m)%nat -> x k = y k) -> mul B x i = mul B y i.
Proof. intros H. apply Sum_ext. intros k Hk. rewrite H by exact Hk. reflexivity. Qed.
Lemma dot_minus c x y : dot c (fun i => x i - y i) = dot c x - dot c y.
Proof. unfold dot. rewrite <- Sum_minus. apply Sum_ext. intros; ring. Qed.
Lemma mul_minus B x y i : mul B (fun k => x k - y k) i = mul B x i - mul B y i.
Proof. unfold mul. rewrite <- Sum_minus. apply Sum_ext. intros; ring. Qed.
Lemma dot_rate c (X : nat -> R -> R) e t : (forall i, (i < m)%nat -> is_derive (X i) t (e i)) ->
  is_derive (fun t => dot c (fun i => X i t)) t (dot c e).
Proof.
  intros H. apply (is_derive_Sum m (fun i t => c i * X i t) (fun i t => c i * e i)). intros i Hi.
  apply is_derive_scal, H, Hi.
Qed.
Lemma dot_continuous c (X : nat -> R -> R) t : (forall i, (i < m)%nat -> continuous (X i) t) ->
  continuous (fun t => dot c (fun i => X i t)) t.
Proof. intros H. apply (continuous_Sum m (fun i t => c i * X i t)). intros i Hi. apply continuous_scaled, H, Hi. Qed.
Lemma dot_mul c B x : dot c (mul B x) = dot (fun k => dot c (fun i => B i k)) x.
Proof.
  unfold dot, mul. rewrite (Sum_ext m _ (fun i => Sum m (fun k => c i * B i k * x k)))
    by (intros; rewrite <- Sum_scal; apply Sum_ext; intros; ring).
  rewrite Sum_swap. apply Sum_ext. intros. apply Sum_scal_r.
Qed.
Lemma hold_continuous X t : (forall i, (i < m)%nat -> continuous (X i) t) -> continuous (hold X) t.
Proof.
  intros H. apply (continuous_mult (K := R_AbsRing) (fun t => dot b (mul A (fun i => X i t))) (fun _ => / size m b));
    [|apply continuous_const].
  apply (dot_continuous b (fun i t => mul A (fun k => X k t) i)). intros i _. apply (dot_continuous (A i)), H.
Qed.
Lemma speed_rate X t r : (forall i, (i < m)%nat -> is_derive (X i) t (mul A (fun k => X k t) i - r * b i)) ->
  is_derive (speed X) t (size m b * (hold X t - r)).
Proof.
  intros H. evar_last; [apply (dot_rate b X _ t H)|]. rewrite (dot_minus b _ (fun i => r * b i)). unfold hold.
  replace (dot b (fun i => r * b i)) with (r * size m b)
    by (unfold size, dot; rewrite <- Sum_scal; apply Sum_ext; intros; ring). field. lra.
Qed.

Lemma moves_near X Y t e : 0 < e -> (forall i x, (i < m)%nat -> Rabs (x - t) < e -> X i x = Y i x) -> moves X t -> moves Y t.
Proof.
  intros He E [r [Ar D]].
  assert (Et : forall i, (i < m)%nat -> X i t = Y i t) by (intros; apply E; [assumption | rewrite Rminus_diag_eq, Rabs_R0; auto]).
  exists r. split.
  - unfold speed in *. rewrite <- (dot_ext b (fun i => X i t)) by exact Et. exact Ar.
  - intros i Hi. rewrite <- (mul_ext A (fun k => X k t)) by exact Et.
    apply (near_derive (X i) _ t _ e He); [intros; apply E; assumption | apply D, Hi].
Qed.
Lemma shifted_rate (f : R -> R) c t k : is_derive f (t - c) k -> is_derive (fun t => f (t - c)) t k.
Proof.
  intros D. evar_last; [apply (is_derive_comp f (fun t => t - c)); [exact D | auto_derive; [exact I | reflexivity]]|].
  unfold scal; simpl; unfold mult; simpl. ring.
Qed.
Lemma moves_later X c t : moves X (t - c) -> moves (fun i t => X i (t - c)) t.
Proof. intros [r [Ar D]]. exists r. split; [exact Ar|]. intros i Hi. apply (shifted_rate (X i)), D, Hi. Qed.
Lemma mirrored_dot c x : dot c (fun i => - x i) = - dot c x.
Proof. unfold dot. rewrite <- Sum_opp. apply Sum_ext. intros; ring. Qed.
Lemma moves_mirrored X t : moves X t -> moves (fun i t => - X i t) t.
Proof.
  intros [r [[A1 [A2 A3]] D]]. exists (- r). split.
  - unfold speed in *. rewrite (mirrored_dot b (fun i => X i t)).
    split; [|split]; [intros H; rewrite A2 by lra; ring | intros H; rewrite A1 by lra; ring | lra].
  - intros i Hi. evar_last; [apply opposite, D, Hi|]. unfold Flows.mul.
    rewrite (Sum_ext m (fun k => A i k * - X k t) (fun k => - (A i k * X k t))), Sum_opp by (intros; ring). ring.
Qed.

(* ---- Distances grow at a bounded rate ---- *)
Lemma pairing x : dot x (mul A x) <= norm m A * size m x.
Proof.
  unfold norm, dot, mul. rewrite <- Sum_scal_r. apply Sum_le. intros i Hi. unfold Flows.length.
  rewrite <- Sum_scal, <- Sum_scal_r. apply Sum_le. intros k Hk. apply Rle_trans with (1 := Rle_abs _).
  rewrite !Rabs_mult. replace (Rabs (x i) * (Rabs (A i k) * Rabs (x k))) with (Rabs (A i k) * (Rabs (x i) * Rabs (x k))) by ring.
  apply Rmult_le_compat_l; [apply Rabs_pos|]. pose proof (size_part m x i Hi) as P. pose proof (size_part m x k Hk) as Q.
  assert (E : forall z, Rabs z * Rabs z = z * z) by (intros; rewrite <- Rabs_mult; apply Rabs_right, Rle_ge, Rle_0_sqr).
  rewrite <- E in P, Q. pose proof (Rle_0_sqr (Rabs (x i) - Rabs (x k))) as S. unfold Rsqr in S. lra.
Qed.
Lemma growth (d : nat -> R -> R) a c : a <= c -> continuous_between d a c ->
  mostly (fun t => exists e, e * speed d t <= 0 /\
    forall i, (i < m)%nat -> is_derive (d i) t (mul A (fun k => d k t) i + e * b i)) a c ->
  size m (fun i => d i c) <= size m (fun i => d i a) * exp (2 * norm m A * (c - a)).
Proof.
  intros Hac Cd O. set (k := - (2 * norm m A)). set (S := fun t => size m (fun i => d i t)).
  assert (H : S c * exp (k * c) <= S a * exp (k * a)).
  { apply (not_growing_mostly (fun t => S t * exp (k * t))); [exact Hac | |].
    - intros t Ht. apply (continuous_mult (K := R_AbsRing) S).
      + apply (continuous_Sum m (fun i t => d i t * d i t)). intros i Hi.
        apply (continuous_mult (K := R_AbsRing)); apply Cd; assumption.
      + eapply continuous_of_derive. auto_derive; [exact I | reflexivity].
    - apply mostly_weaker with (2 := O). intros t _ [e [He D]].
      exists ((2 * (dot (fun i => d i t) (mul A (fun i => d i t)) + e * speed d t) + k * S t) * exp (k * t)). split.
      + evar_last.
        { apply (is_derive_mult (K := R_AbsRing) S (fun t => exp (k * t))); [| |intros; apply Rmult_comm].
          - apply (is_derive_Sum m (fun i t => d i t * d i t)
              (fun i t => 2 * (d i t * mul A (fun k => d k t) i + e * (b i * d i t)))). intros i Hi.
            evar_last.
            { apply (is_derive_mult (K := R_AbsRing) (d i) (d i)); [apply D, Hi | apply D, Hi | intros; apply Rmult_comm]. }
            unfold plus, mult; simpl. ring.
          - auto_derive; [exact I | reflexivity]. }
        unfold plus, mult; simpl. unfold speed, Flows.dot. rewrite Sum_scal, Sum_plus, Sum_scal. ring.
      + pose proof (pairing (fun i => d i t)) as P. fold (S t) in P. pose proof (exp_pos (k * t)) as Ep.
        assert (0 <= - (2 * (dot (fun i => d i t) (mul A (fun i => d i t)) + e * speed d t) + k * S t) * exp (k * t));
          [apply Rmult_le_pos; [unfold k; lra | lra] | lra]. }
  fold (S c) (S a). apply (Rmult_le_reg_r (exp (k * c))); [apply exp_pos|].
  rewrite Rmult_assoc, <- exp_plus. replace (2 * norm m A * (c - a) + k * c) with (k * a) by (unfold k; ring). exact H.
Qed.
Lemma no_growth (d : nat -> R -> R) a c : a <= c -> continuous_between d a c ->
  mostly (fun t => exists e, e * speed d t <= 0 /\
    forall i, (i < m)%nat -> is_derive (d i) t (mul A (fun k => d k t) i + e * b i)) a c ->
  (forall i, (i < m)%nat -> d i a = 0) -> forall i, (i < m)%nat -> d i c = 0.
Proof.
  intros Hac Cd O Z i Hi. pose proof (growth d a c Hac Cd O) as H.
  assert (Za : size m (fun i => d i a) = 0) by (apply Sum_zero; intros n Hn; rewrite (Z n Hn); ring).
  rewrite Za, Rmult_0_l in H.
  pose proof (size_part m (fun i => d i c) i Hi) as P. cbv beta in P. pose proof (Rle_0_sqr (d i c)) as Q. unfold Rsqr in Q.
  destruct (Rmult_integral (d i c) (d i c)); lra.
Qed.
Lemma difference_rate (X Y : nat -> R -> R) t r r' :
  (forall i, (i < m)%nat -> is_derive (X i) t (mul A (fun k => X k t) i - r * b i)) ->
  (forall i, (i < m)%nat -> is_derive (Y i) t (mul A (fun k => Y k t) i - r' * b i)) ->
  forall i, (i < m)%nat -> is_derive (fun t => X i t - Y i t) t (mul A (fun k => X k t - Y k t) i + (r' - r) * b i).
Proof.
  intros D D' i Hi. evar_last; [apply (is_derive_minus (V := R_NormedModule)); [apply D, Hi | apply D', Hi]|].
  rewrite mul_minus. unfold minus, plus, opp; simpl. ring.
Qed.
Lemma difference_continuous X Y a c : continuous_between X a c -> continuous_between Y a c ->
  continuous_between (fun i t => X i t - Y i t) a c.
Proof. intros C C' i t Hi Ht. apply (continuous_minus (V := R_NormedModule)); [apply C | apply C']; assumption. Qed.
Lemma allowed_monotone v v' r r' : allowed v r -> allowed v' r' -> (r' - r) * (v - v') <= 0.
Proof.
  intros [A1 [A2 A3]] [B1 [B2 B3]]. destruct (Rtotal_order v v') as [L|[->|G]].
  - assert (r <= r') by (destruct (Rlt_dec v 0); [rewrite A2 by assumption; lra | rewrite B1 by lra; lra]).
    assert (0 <= (r' - r) * (v' - v)) by (apply Rmult_le_pos; lra). lra.
  - lra.
  - assert (r' <= r) by (destruct (Rlt_dec v' 0); [rewrite B2 by assumption; lra | rewrite A1 by lra; lra]).
    assert (0 <= (r - r') * (v - v')) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma same_motion X Y a c : a <= c -> continuous_between X a c -> continuous_between Y a c ->
  mostly (moves X) a c -> mostly (moves Y) a c ->
  (forall i, (i < m)%nat -> X i a = Y i a) -> forall i, (i < m)%nat -> X i c = Y i c.
Proof.
  intros Hac C C' O O' E i Hi. apply Rminus_diag_uniq.
  apply (no_growth (fun i t => X i t - Y i t) a c Hac); [apply difference_continuous; assumption | | | exact Hi].
  - apply mostly_weaker with (2 := mostly_both _ _ a c O O'). intros t _ [[r [Ar D]] [r' [Ar' D']]]. exists (r' - r).
    split; [|apply difference_rate; assumption]. unfold speed. rewrite dot_minus. apply allowed_monotone; assumption.
  - intros k Hk. rewrite (E k Hk). ring.
Qed.

(* ---- The flows: slip to one side, s = 1, or to the other, s = -1, and stick ---- *)
Definition slip (s : R) (x : nat -> R) := flow m A (fun i => - (s * beta) * b i) x.
Definition stuck i k := A i k - b i * (dot b (fun i => A i k) / size m b).
Definition stick (x : nat -> R) := flow m stuck (fun _ => 0) x.
Lemma slip_rate s x i t : (i < m)%nat -> is_derive (slip s x i) t (mul A (fun k => slip s x k t) i - s * beta * b i).
Proof. intros Hi. evar_last; [apply (flow_rate m A (fun i => - (s * beta) * b i) x i t Hi)|]. unfold slip. ring. Qed.
Lemma mul_stuck x i : mul stuck x i = mul A x i - b i * (dot b (mul A x) / size m b).
Proof.
  rewrite dot_mul. unfold mul, dot at 1, stuck. unfold Rdiv. rewrite <- Sum_scal_r, <- Sum_scal, <- Sum_minus.
  apply Sum_ext. intros; ring.
Qed.
Lemma stick_rate x i t : (i < m)%nat ->
  is_derive (stick x i) t (mul A (fun k => stick x k t) i - hold (stick x) t * b i).
Proof.
  intros Hi. evar_last; [apply (flow_rate m stuck (fun _ => 0) x i t Hi)|]. rewrite mul_stuck. unfold stick, hold. ring.
Qed.
Lemma slip_start s x i : slip s x i 0 = x i.
Proof. exact (flow_start m A _ x i). Qed.
Lemma stick_start x i : stick x i 0 = x i.
Proof. exact (flow_start m stuck _ x i). Qed.
Lemma slip_continuous s x a c : continuous_between (slip s x) a c.
Proof. intros i t Hi _. exact (flow_continuous m A _ x i t Hi). Qed.
Lemma stick_continuous x a c : continuous_between (stick x) a c.
Proof. intros i t Hi _. exact (flow_continuous m stuck _ x i t Hi). Qed.
Lemma slip_analytic s x : analytic (speed (slip s x)).
Proof. exact (flow_analytic m A _ x b). Qed.
Lemma stick_speed x t : 0 <= t -> speed (stick x) t = dot b x.
Proof.
  intros Ht. rewrite (steady_inside nil (speed (stick x)) 0 t); [| exact Ht | | | lra].
  - apply dot_ext. intros. apply stick_start.
  - intros u Hu. apply dot_continuous. intros i Hi. apply (stick_continuous x u u); [exact Hi | lra].
  - intros u _ _. replace 0 with (size m b * (hold (stick x) u - hold (stick x) u)) by ring.
    apply speed_rate. intros i Hi. apply stick_rate, Hi.
Qed.
Lemma slip_moves s x t : s = 1 \/ s = -1 -> 0 <= s * speed (slip s x) t \/ beta = 0 -> moves (slip s x) t.
Proof.
  intros Hs H. exists (s * beta). split; [|intros i Hi; apply slip_rate, Hi].
  destruct Hs as [-> | ->]; (split; [|split]); destruct H; lra.
Qed.
Lemma stick_moves x t : 0 <= t -> dot b x = 0 -> - beta <= hold (stick x) t <= beta -> moves (stick x) t.
Proof.
  intros Ht Z H. exists (hold (stick x) t). split; [|intros i Hi; apply stick_rate, Hi].
  rewrite stick_speed, Z by exact Ht. split; [lra | split; [lra | exact H]].
Qed.

(* ---- Forward: from every state there is a motion for some time without an event. ---- *)
Lemma analytic_line f h a c : analytic f -> (forall t, h t = a * f t + c) -> analytic h.
Proof.
  intros [p [P E]] H. destruct (analytic_plus_constant (fun t => a * f t) c) as [q [Q F]].
  - exists (fun k => a * p k). split; [apply entire_scal, P|]. intros t. rewrite E. symmetry. apply PSeries_scal.
  - exists q. split; [exact Q|]. intros t. rewrite H. apply F.
Qed.
Lemma slip_or_not s x : s = 1 \/ s = -1 -> exists e, 0 < e /\
  ((forall t, 0 < t < e -> moves (slip s x) t) \/ (forall t, 0 < t < e -> s * speed (slip s x) t < 0)).
Proof.
  intros Hs. destruct (sign_after (fun t => s * speed (slip s x) t)) as [e [He H]].
  - apply (analytic_line (speed (slip s x)) _ s 0); [apply slip_analytic | intros; ring].
  - exists e. split; [exact He|]. destruct H as [Z|[P|M]]; [left | left | right; exact M];
      intros t Ht; apply slip_moves; try exact Hs; left; [rewrite Z by exact Ht; lra | apply Rlt_le, P, Ht].
Qed.
Lemma stick_or_slip s x e : s = 1 \/ s = -1 -> 0 < e -> (forall t, 0 < t < e -> s * speed (slip s x) t < 0) -> dot b x = 0 ->
  exists e', 0 < e' /\ forall t, 0 < t < e' -> s * hold (stick x) t <= beta.
Proof.
  intros Hs He N Z. destruct (sign_after (fun t => s * hold (stick x) t - beta)) as [d [Hd H]].
  - apply (analytic_line (fun t => dot (fun k => dot b (fun i => A i k)) (fun i => stick x i t)) _ (s / size m b) (- beta));
      [exact (flow_analytic m stuck _ x _)|]. intros t. unfold hold. rewrite dot_mul. field. lra.
  - exists d. split; [exact Hd|]. destruct H as [P|[P|P]]; intros t Ht; pose proof (P t Ht) as Pt; cbv beta in Pt; try lra.
    exfalso. set (c := Rmin d e / 2). pose proof (Rmin_l d e). pose proof (Rmin_r d e).
    assert (Hm : 0 < Rmin d e) by (apply Rmin_glb_lt; assumption).
    assert (E : forall i, (i < m)%nat -> stick x i c - slip s x i c = 0).
    { apply (no_growth (fun i t => stick x i t - slip s x i t) 0 c); [unfold c; lra | | |].
      - apply difference_continuous; [apply stick_continuous | apply slip_continuous].
      - apply (mostly_of_list nil). intros u Hu _. exists (s * beta - hold (stick x) u). split.
        + unfold speed. rewrite dot_minus. fold (speed (stick x) u) (speed (slip s x) u). rewrite stick_speed, Z by lra.
          pose proof (N u ltac:(unfold c in Hu; lra)) as Nu. pose proof (P u ltac:(unfold c in Hu; lra)) as Pu. cbv beta in Pu.
          assert (Q : 0 < (s * hold (stick x) u - beta) * - (s * speed (slip s x) u)) by (apply Rmult_lt_0_compat; lra).
          destruct Hs as [-> | ->]; lra.
        + apply difference_rate; [intros; apply stick_rate | intros; apply slip_rate]; assumption.
      - intros i Hi. rewrite stick_start, slip_start. ring. }
    assert (S : speed (stick x) c = speed (slip s x) c).
    { apply dot_ext. intros i Hi. specialize (E i Hi). lra. }
    rewrite stick_speed, Z in S by (unfold c; lra). pose proof (N c ltac:(unfold c; lra)) as Nc. rewrite <- S in Nc. lra.
Qed.
Lemma sign_at_start s x e : 0 < e -> (forall t, 0 < t < e -> s * speed (slip s x) t < 0) -> s * dot b x <= 0.
Proof.
  intros He N. apply Rnot_lt_le. intros G. replace (dot b x) with (speed (slip s x) 0) in G
    by (apply dot_ext; intros; apply slip_start).
  destruct (above_near (fun t => s * speed (slip s x) t) 0 0) as [d [Hd P]]; [| exact G |].
  - apply continuous_scaled, dot_continuous. intros i Hi. apply (slip_continuous s x 0 0); [exact Hi | lra].
  - pose proof (Rmin_l d e). pose proof (Rmin_r d e). assert (0 < Rmin d e) by (apply Rmin_glb_lt; assumption).
    pose proof (N (Rmin d e / 2) ltac:(lra)) as Q.
    pose proof (P (Rmin d e / 2) ltac:(rewrite Rminus_0_r, Rabs_right; lra)) as Q'. cbv beta in Q'. lra.
Qed.
Lemma forward x : exists e Y, 0 < e /\ continuous_between Y 0 e /\ (forall i, (i < m)%nat -> Y i 0 = x i) /\
  forall t, 0 < t < e -> moves Y t.
Proof.
  assert (P1 : 1 = 1 \/ 1 = -1) by (left; reflexivity). assert (M1 : -1 = 1 \/ -1 = -1) by (right; reflexivity).
  destruct (slip_or_not 1 x P1) as [e [He [G|N]]].
  { exists e, (slip 1 x). split; [exact He|]. split; [apply slip_continuous|]. split; [intros; apply slip_start | exact G]. }
  destruct (slip_or_not (-1) x M1) as [e' [He' [G|N']]].
  { exists e', (slip (-1) x). split; [exact He'|]. split; [apply slip_continuous|]. split; [intros; apply slip_start | exact G]. }
  pose proof (sign_at_start 1 x e He N). pose proof (sign_at_start (-1) x e' He' N'). assert (Z : dot b x = 0) by lra.
  destruct (stick_or_slip 1 x e P1 He N Z) as [d [Hd Up]]. destruct (stick_or_slip (-1) x e' M1 He' N' Z) as [d' [Hd' Lo]].
  exists (Rmin d d'), (stick x). pose proof (Rmin_l d d'). pose proof (Rmin_r d d').
  split; [apply Rmin_glb_lt; assumption|]. split; [apply stick_continuous|]. split; [intros; apply stick_start|].
  intros t Ht. apply stick_moves; [lra | exact Z |]. specialize (Up t ltac:(lra)). specialize (Lo t ltac:(lra)). lra.
Qed.

(* ---- Backward: before any time the contact slips to one side or sticks for some time. ---- *)
(* A motion up to the time c, before which events might accumulate *)
Definition arrives X a c := a < c /\ continuous_between X a c /\ mostly (moves X) a c.
Lemma arrives_later X a c a' : arrives X a c -> a <= a' -> a' < c -> arrives X a' c.
Proof.
  intros [H [C O]] Ha Hc. split; [exact Hc|]. split; [intros i t Hi Ht; apply C; [exact Hi | lra]|].
  apply (mostly_inside _ a c); [exact Ha | lra | exact O].
Qed.
Lemma speed_continuous X a c t : continuous_between X a c -> a <= t <= c -> continuous (speed X) t.
Proof. intros C Ht. apply dot_continuous. intros i Hi. apply C; assumption. Qed.

(* A motion is a flow Y with the friction r where both have the friction or the velocity in common. *)
Lemma follows X a c Y r : arrives X a c ->
  (forall i u, (i < m)%nat -> is_derive (Y i) u (mul A (fun k => Y k u) i - r u * b i)) ->
  (forall i, (i < m)%nat -> Y i a = X i a) ->
  (forall u r', a < u < c -> allowed (speed X u) r' -> (r u - r') * (speed X u - speed Y u) <= 0) ->
  forall u i, a < u < c -> (i < m)%nat -> X i u = Y i u.
Proof.
  intros [H [C O]] D E F u i Hu Hi. apply Rminus_diag_uniq.
  apply (no_growth (fun i t => X i t - Y i t) a u); [lra | | | | exact Hi].
  - apply difference_continuous; intros k t Hk Ht; [apply C; [exact Hk | lra] | eapply continuous_of_derive, D, Hk].
  - apply mostly_weaker with (2 := mostly_inside _ a c a u (Rle_refl a) ltac:(lra) O). intros t Ht [r' [Ar D']].
    exists (r t - r'). split; [unfold speed; rewrite dot_minus; apply F; [lra | exact Ar]|].
    apply difference_rate; [exact D' | intros; apply D; assumption].
  - intros k Hk. rewrite (E k Hk). ring.
Qed.
Lemma follows_and_moves X a c Y r : (forall i u, (i < m)%nat -> is_derive (Y i) u (mul A (fun k => Y k u) i - r u * b i)) ->
  (forall u i, a < u < c -> (i < m)%nat -> X i u = Y i u) ->
  (forall u, a < u < c -> allowed (speed Y u) (r u)) -> forall u, a < u < c -> moves X u.
Proof.
  intros D E Al u Hu. apply (moves_near Y X u (Rmin (u - a) (c - u))).
  - apply Rmin_glb_lt; lra.
  - intros i x Hi Hx. symmetry. apply E; [|exact Hi]. apply Rabs_lt_between in Hx.
    pose proof (Rmin_l (u - a) (c - u)). pose proof (Rmin_r (u - a) (c - u)). lra.
  - exists (r u). split; [apply Al, Hu | intros i Hi; apply D, Hi].
Qed.
Lemma slipping_moves s X a c : s = 1 \/ s = -1 -> arrives X a c -> (forall t, a < t < c -> 0 < s * speed X t) ->
  forall t, a < t < c -> moves X t.
Proof.
  intros Hs Ar P. set (Y := fun i t => slip s (fun k => X k a) i (t - a)).
  assert (D : forall i u, (i < m)%nat -> is_derive (Y i) u (mul A (fun k => Y k u) i - s * beta * b i)).
  { intros i u Hi. apply (shifted_rate (slip s (fun k => X k a) i)), slip_rate, Hi. }
  assert (E : forall u i, a < u < c -> (i < m)%nat -> X i u = Y i u).
  { apply (follows X a c Y (fun _ => s * beta) Ar D).
    - intros i Hi. unfold Y. rewrite Rminus_diag_eq by reflexivity. apply slip_start.
    - intros u r Hu [A1 [A2 _]]. specialize (P u Hu).
      destruct Hs as [-> | ->]; [rewrite A1 by lra | rewrite A2 by lra]; lra. }
  apply (follows_and_moves X a c Y (fun _ => s * beta) D E). intros u Hu. specialize (P u Hu).
  replace (speed X u) with (speed Y u) in P by (apply dot_ext; intros i Hi; symmetry; apply E; assumption).
  split; [|split]; destruct Hs as [-> | ->]; lra.
Qed.
Lemma resting_moves X a c : arrives X a c -> (forall t, a < t < c -> speed X t = 0) -> forall t, a < t < c -> moves X t.
Proof.
  intros Ar Z. pose proof Ar as [Hac [C O]].
  assert (Za : speed X a = 0).
  { destruct (Req_dec (speed X a) 0) as [E|N]; [exact E|]. exfalso.
    destruct (nonzero_near (speed X) a) as [e [He P]]; [apply (speed_continuous X a c); [exact C | lra] | exact N |].
    pose proof (Rmin_l e (c - a)). pose proof (Rmin_r e (c - a)). assert (0 < Rmin e (c - a)) by (apply Rmin_glb_lt; lra).
    apply (P (a + Rmin e (c - a) / 2)); [rewrite Rabs_right; lra | apply Z; lra]. }
  assert (Hold : forall t, a < t < c -> Rabs (hold X t) <= beta).
  { intros t Ht. apply Rnot_lt_le. intros G.
    destruct (above_near (fun t => Rabs (hold X t)) beta t) as [e [He P]]; [| exact G |].
    - apply (continuous_comp (hold X) Rabs); [apply hold_continuous; intros; apply C; [assumption | lra] | apply continuous_Rabs].
    - pose proof (Rmin_l (t + e) c). pose proof (Rmin_r (t + e) c). assert (t < Rmin (t + e) c) by (apply Rmin_glb_lt; lra).
      destruct (mostly_somewhere _ _ _ t (Rmin (t + e) c) O) as [u [Hu [r [[_ [_ B]] D]]]]; [lra | lra | lra |].
      assert (R0 : size m b * (hold X u - r) = 0).
      { rewrite <- (is_derive_unique _ _ _ (speed_rate X u r D)). apply is_derive_unique.
        apply (near_derive (fun _ => 0) (speed X) u 0 (Rmin (u - a) (c - u))); [apply Rmin_glb_lt; lra | |
          apply (is_derive_const (K := R_AbsRing) (V := R_NormedModule))].
        intros x Hx. apply Rabs_lt_between in Hx. pose proof (Rmin_l (u - a) (c - u)). pose proof (Rmin_r (u - a) (c - u)).
        symmetry. apply Z. lra. }
      assert (hold X u = r) by (apply Rmult_integral in R0; lra).
      specialize (P u ltac:(rewrite Rabs_right; lra)). cbv beta in P.
      assert (Rabs (hold X u) <= beta) by (apply Rabs_le; lra). lra. }
  set (Y := fun i t => stick (fun k => X k a) i (t - a)).
  assert (D : forall i u, (i < m)%nat -> is_derive (Y i) u (mul A (fun k => Y k u) i - hold Y u * b i)).
  { intros i u Hi. apply (shifted_rate (stick (fun k => X k a) i)), (stick_rate (fun k => X k a) i (u - a) Hi). }
  assert (S : forall u, a <= u -> speed Y u = 0).
  { intros u Hu. transitivity (speed (stick (fun k => X k a)) (u - a)); [reflexivity|]. rewrite stick_speed by lra. exact Za. }
  assert (E : forall u i, a < u < c -> (i < m)%nat -> X i u = Y i u).
  { apply (follows X a c Y (hold Y) Ar D).
    - intros i Hi. unfold Y. rewrite Rminus_diag_eq by reflexivity. apply stick_start.
    - intros u r Hu _. rewrite Z, S by lra. lra. }
  apply (follows_and_moves X a c Y (hold Y) D E). intros u Hu. rewrite S by lra.
  replace (hold Y u) with (hold X u)
    by (unfold hold; f_equal; apply dot_ext; intros i _; apply mul_ext; intros k Hk; apply E; assumption).
  pose proof (Hold u Hu) as Q. apply Rabs_le_between in Q. split; [lra | split; [lra | exact Q]].
Qed.

(* The contact rests throughout before the time c, or moves to one side. *)
Definition settles X a c := exists a', a <= a' < c /\ ((forall t, a' < t < c -> speed X t = 0) \/
  (forall t, a' < t < c -> 0 < speed X t) \/ (forall t, a' < t < c -> speed X t < 0)).
Lemma settled_moves X a c : arrives X a c -> settles X a c -> exists a', a <= a' < c /\ forall t, a' < t < c -> moves X t.
Proof.
  intros Ar [a' [Ha S]]. exists a'. split; [exact Ha|]. pose proof (arrives_later X a c a' Ar ltac:(lra) ltac:(lra)) as Ar'.
  destruct S as [Z|[P|N]].
  - apply resting_moves; assumption.
  - apply (slipping_moves 1); [left; reflexivity | exact Ar' | intros t Ht; specialize (P t Ht); lra].
  - apply (slipping_moves (-1)); [right; reflexivity | exact Ar' | intros t Ht; specialize (N t Ht); lra].
Qed.

(* The difference d between a motion that ends at rest and never was below, and the slip that ends as it does: the friction on it
   has one sign, so that it is about a multiple of - b. *)
Section Cone.
Variables (d : nat -> R -> R) (a c : R).
Hypothesis Cd : continuous_between d a c.
Hypothesis Zd : forall i, (i < m)%nat -> d i c = 0.
Hypothesis Dd : mostly (fun t => exists r, 0 <= r /\
  forall i, (i < m)%nat -> is_derive (d i) t (mul A (fun k => d k t) i + r * b i)) a c.
Let al := Flows.length m b * norm m A + norm m stuck.
Lemma al_nonneg : 0 <= al.
Proof.
  pose proof (length_nonneg m b). pose proof (norm_nonneg m A). pose proof (norm_nonneg m stuck).
  assert (0 <= length b * norm m A) by (apply Rmult_le_pos; assumption). unfold al. lra.
Qed.
Lemma pull_bound x : Rabs (dot b (mul A x)) <= al * length x.
Proof.
  apply Rle_trans with (1 := dot_bound m b _). pose proof (length_nonneg m x). pose proof (length_nonneg m b).
  apply Rle_trans with (length b * (norm m A * length x)); [apply Rmult_le_compat_l; [assumption | apply mul_length]|].
  pose proof (Rmult_le_pos _ _ (norm_nonneg m stuck) H). unfold al. lra.
Qed.
Lemma stuck_bound x i : (i < m)%nat -> Rabs (mul stuck x i) <= al * length x.
Proof.
  intros Hi. apply Rle_trans with (1 := length_part m (mul stuck x) i Hi), Rle_trans with (1 := mul_length m stuck x).
  pose proof (length_nonneg m x). pose proof (length_nonneg m b).
  assert (0 <= length b * norm m A * length x) by (repeat apply Rmult_le_pos; try assumption; apply norm_nonneg).
  unfold al. lra.
Qed.
Let across i t := d i t - b i * (speed d t / size m b).
Lemma friction_rate t r : (forall i, (i < m)%nat -> is_derive (d i) t (mul A (fun k => d k t) i + r * b i)) ->
  is_derive (speed d) t (dot b (mul A (fun i => d i t)) + size m b * r) /\
  forall i, (i < m)%nat -> is_derive (across i) t (mul stuck (fun k => d k t) i).
Proof.
  intros D. assert (S : is_derive (speed d) t (dot b (mul A (fun i => d i t)) + size m b * r)).
  { evar_last; [apply (speed_rate d t (- r)); intros i Hi; evar_last; [apply D, Hi | ring]|]. unfold hold. field. lra. }
  split; [exact S|]. intros i Hi. evar_last.
  { apply (is_derive_minus (V := R_NormedModule) (d i)); [apply D, Hi|].
    apply is_derive_scal, (is_derive_mult (K := R_AbsRing) (speed d) (fun _ => / size m b));
      [exact S | apply (is_derive_const (K := R_AbsRing) (V := R_NormedModule)) | intros; apply Rmult_comm]. }
  rewrite mul_stuck. unfold minus, plus, opp, mult, zero; simpl. field. lra.
Qed.
Lemma cone : exists e k, 0 < e /\ 0 < k /\ forall t, a <= t -> c - e < t <= c -> length (fun i => d i t) <= - k * speed d t.
Proof.
  set (K := Sum m (fun _ => 1)). set (B := length b / size m b + 1).
  assert (HK : 0 <= K) by (apply Sum_nonneg; intros; lra).
  assert (HB : 0 < B).
  { pose proof (length_nonneg m b). assert (0 <= length b / size m b); [|unfold B; lra].
    apply Rmult_le_pos; [assumption | apply Rlt_le, Rinv_0_lt_compat, Hb]. }
  pose proof al_nonneg as Ha.
  assert (G0 : 0 <= al * (K + B)) by (apply Rmult_le_pos; lra). set (e := / (4 * (al * (K + B) + 1))).
  assert (He : 0 < e) by (apply Rinv_0_lt_compat; lra).
  assert (Ge : al * (K + B) * e <= / 4).
  { apply Rle_trans with ((al * (K + B) + 1) * e); [apply Rmult_le_compat_r; lra | apply Req_le; unfold e; field; lra]. }
  exists e, (2 * B). split; [exact He|]. split; [lra|]. intros t Hat Ht.
  destruct (continuity_ab_maj (fun t => length (fun i => d i t)) t c) as [u [Max Hu]]; [lra | |].
  { intros x Hx. apply continuity_pt_filterlim. apply (continuous_Sum m (fun i t => Rabs (d i t))). intros i Hi.
    apply (continuous_comp (d i) Rabs); [apply Cd; [exact Hi | lra] | apply continuous_Rabs]. }
  cbv beta in Max. set (M := length (fun i => d i u)) in *. pose proof (length_nonneg m (fun i => d i u)) as HM. fold M in HM.
  assert (Cs : forall x, t <= x <= c -> continuous (speed d) x) by (intros; apply (speed_continuous d a c); [exact Cd | lra]).
  assert (Up : forall x y, t <= x -> x <= y -> y <= c -> speed d x <= speed d y + al * M * (y - x)).
  { intros x y Hx Hxy Hy. assert (- speed d y - - speed d x <= al * M * (y - x)); [|lra].
    apply (growth_mostly (fun t => - speed d t)); [exact Hxy | intros; apply opposite, Cs; lra |].
    apply mostly_weaker with (2 := mostly_inside _ a c x y ltac:(lra) ltac:(lra) Dd). intros z Hz [r [Hr D]].
    destruct (friction_rate z r D) as [S _]. exists (- (dot b (mul A (fun i => d i z)) + size m b * r)).
    split; [apply opposite, S|]. pose proof (pull_bound (fun i => d i z)) as Q. apply Rabs_le_between in Q.
    assert (0 <= size m b * r) by (apply Rmult_le_pos; lra).
    assert (al * length (fun i => d i z) <= al * M) by (apply Rmult_le_compat_l; [exact Ha | apply Max; lra]). lra. }
  assert (Zs : speed d c = 0) by (apply Sum_zero; intros i Hi; rewrite (Zd i Hi); ring).
  assert (Across : forall i, (i < m)%nat -> Rabs (across i u) <= al * M * (c - u)).
  { intros i Hi.
    replace (across i u) with (- (across i c - across i u)) by (unfold across; rewrite Zs, (Zd i Hi); unfold Rdiv; ring).
    rewrite Rabs_Ropp. apply slope_mostly; [lra | |].
    - intros x Hx. apply (continuous_minus (V := R_NormedModule) (d i)); [apply Cd; [exact Hi | lra]|].
      apply continuous_scaled, (continuous_mult (K := R_AbsRing) (speed d) (fun _ => / size m b));
        [apply Cs; lra | apply continuous_const].
    - apply mostly_weaker with (2 := mostly_inside _ a c u c ltac:(lra) ltac:(lra) Dd). intros z Hz [r [Hr D]].
      exists (mul stuck (fun k => d k z) i). split; [apply (friction_rate z r D), Hi|].
      apply Rle_trans with (1 := stuck_bound _ i Hi), Rmult_le_compat_l; [exact Ha | apply Max; lra]. }
  pose proof (Up u c ltac:(lra) ltac:(lra) ltac:(lra)) as F1. rewrite Zs in F1.
  pose proof (Up t u ltac:(lra) ltac:(lra) ltac:(lra)) as F2.
  set (p := al * M * e). assert (Hp : 0 <= p) by (repeat apply Rmult_le_pos; lra).
  assert (Short : forall x, 0 <= x <= e -> al * M * x <= p).
  { intros x Hx. apply Rmult_le_compat_l; [apply Rmult_le_pos; assumption | lra]. }
  assert (S1 : al * M * (c - u) <= p) by (apply Short; lra). assert (S2 : al * M * (u - t) <= p) by (apply Short; lra).
  assert (Small : (K + B) * p <= M * / 4).
  { replace ((K + B) * p) with (M * (al * (K + B) * e)) by (unfold p; ring). apply Rmult_le_compat_l; assumption. }
  assert (Pk : 0 <= K * p) by (apply Rmult_le_pos; assumption).
  assert (Pb : 0 <= B * p) by (apply Rmult_le_pos; lra).
  assert (Total : M <= K * p + B * Rabs (speed d u)).
  { apply Rle_trans with (Sum m (fun i => 1 * p + Rabs (b i) * (Rabs (speed d u) / size m b))).
    - apply Sum_le. intros i Hi. replace (d i u) with (across i u + b i * (speed d u / size m b)) by (unfold across; ring).
      apply Rle_trans with (1 := Rabs_triang _ _). specialize (Across i Hi). rewrite Rabs_mult. unfold Rdiv at 1.
      rewrite (Rabs_mult (speed d u)), (Rabs_right (/ size m b)) by (apply Rle_ge, Rlt_le, Rinv_0_lt_compat, Hb).
      unfold Rdiv. lra.
    - rewrite Sum_plus, !Sum_scal_r. fold K. apply Rplus_le_compat_l. change (Sum m (fun i => Rabs (b i))) with (length b).
      pose proof (Rabs_pos (speed d u)). replace (length b * (Rabs (speed d u) / size m b)) with
        (length b / size m b * Rabs (speed d u)) by (field; lra). apply Rmult_le_compat_r; [assumption | unfold B; lra]. }
  apply Rle_trans with M; [apply Max; lra|].
  assert (B1 : B * speed d u <= B * p) by (apply Rmult_le_compat_l; lra).
  assert (B2 : B * speed d t <= B * speed d u + B * p).
  { rewrite <- Rmult_plus_distr_l. apply Rmult_le_compat_l; lra. }
  destruct (Rle_dec 0 (speed d u)) as [P|N].
  - rewrite Rabs_right in Total by lra. lra.
  - rewrite Rabs_left in Total by lra. lra.
Qed.
End Cone.

(* A contact that only moves to larger values before it rests at c. While it slips, its velocity has a rate of at most
   f1 + al k f, where f is the velocity of the slip with the same end, and f1 is its rate. *)
Lemma one_sided X a c : arrives X a c -> (forall t, a < t < c -> 0 <= speed X t) -> speed X c = 0 -> settles X a c.
Proof.
  intros Ar P Zc. pose proof Ar as [Hac [C O]]. set (x := fun i => X i c). set (S := fun i t => slip 1 x i (t - c)).
  set (d := fun i t => X i t - S i t). set (f := speed (slip 1 x)).
  assert (DS : forall i u, (i < m)%nat -> is_derive (S i) u (mul A (fun k => S k u) i - 1 * beta * b i)).
  { intros i u Hi. apply (shifted_rate (slip 1 x i)), (slip_rate 1 x i (u - c) Hi). }
  assert (Cd : continuous_between d a c).
  { apply difference_continuous; [exact C|]. intros i t Hi _. eapply continuous_of_derive, DS, Hi. }
  assert (Dot : forall t, speed d t = speed X t - f (t - c)) by (intros; apply (dot_minus b (fun i => X i t))).
  destruct (cone d a c Cd) as [e [k [He [Hk Cone]]]].
  { intros i Hi. unfold d, S. rewrite (Rminus_diag_eq c c), slip_start by reflexivity. unfold x. ring. }
  { apply mostly_weaker with (2 := O). intros t _ [r [[_ [_ B]] D]]. exists (beta - r). split; [lra|]. intros i Hi.
    replace (beta - r) with (1 * beta - r) by ring. apply (difference_rate X S t r (1 * beta) D); [intros; apply DS; assumption|].
    exact Hi. }
  set (al := length b * norm m A + norm m stuck) in *.
  set (f1 := fun u => size m b * (hold (slip 1 x) u - 1 * beta)).
  assert (Df : forall u, is_derive f u (f1 u)) by (intros u; apply speed_rate; intros i Hi; apply slip_rate, Hi).
  set (e' := Rmin e (c - a)). assert (He' : 0 < e') by (apply Rmin_glb_lt; lra).
  assert (E1 : e' <= e) by apply Rmin_l. assert (E2 : e' <= c - a) by apply Rmin_r.
  assert (Near : forall t, c - e' < t < c -> 0 <= - k * speed d t /\ length (fun i => d i t) <= - k * speed d t /\
    0 <= speed X t).
  { intros t Ht. pose proof (Cone t ltac:(lra) ltac:(lra)) as Q. pose proof (length_nonneg m (fun i => d i t)).
    split; [lra|]. split; [exact Q | apply P; lra]. }
  assert (Below : forall t, c - e' < t < c -> speed d t <= 0).
  { intros t Ht. destruct (Near t Ht) as [Q _]. apply Rnot_lt_le. intros G.
    assert (0 < k * speed d t) by (apply Rmult_lt_0_compat; assumption). lra. }
  destruct (falls_before f f1 (al * k) e') as [h [Hh F]].
  - apply slip_analytic.
  - exact Df.
  - transitivity (speed X c); [|exact Zc]. apply dot_ext. intros; apply slip_start.
  - exact He'.
  - intros u Hu. pose proof (Below (u + c) ltac:(lra)) as Q. destruct (Near (u + c) ltac:(lra)) as [_ [_ V]].
    rewrite Dot in Q. replace (u + c - c) with u in Q by ring. lra.
  - destruct F as [F|F].
    { exists (c - h). split; [lra|]. left. intros t Ht. pose proof (Below t ltac:(lra)) as Q.
      destruct (Near t ltac:(lra)) as [_ [_ V]]. rewrite Dot, F in Q by lra. lra. }
    assert (Falls : mostly (fun t => exists k, is_derive (fun t => - speed X t) t k /\ (- speed X t < 0 -> 0 <= k)) (c - h) c).
    { apply mostly_weaker with (2 := mostly_inside _ a c (c - h) c ltac:(lra) ltac:(lra) O).
      intros t Ht [r [[A1 _] D]]. exists (- (size m b * (hold X t - r))). split; [apply opposite, speed_rate, D|].
      intros V. rewrite A1 by lra. destruct (Near t ltac:(lra)) as [N1 [N2 N3]]. specialize (F (t - c) ltac:(lra)).
      pose proof (pull_bound (fun i => d i t)) as Q. fold al in Q. apply Rabs_le_between in Q.
      assert (Hd : size m b * (hold X t - hold (slip 1 x) (t - c)) = dot b (mul A (fun i => d i t))).
      { transitivity (dot b (fun i => mul A (fun k => X k t) i - mul A (fun k => S k t) i));
          [|apply dot_ext; intros; symmetry; apply mul_minus].
        rewrite (dot_minus b (mul A (fun k => X k t)) (mul A (fun k => S k t))). unfold hold, S. field. lra. }
      assert (al * length (fun i => d i t) <= al * (- k * speed d t)) by (apply Rmult_le_compat_l; [apply al_nonneg | exact N2]).
      assert (0 <= al * k * speed X t) by (repeat apply Rmult_le_pos; try lra; apply al_nonneg).
      rewrite Dot in H. unfold f1 in F. lra. }
    destruct (Classical_Prop.classic (exists t, c - h < t < c /\ speed X t <= 0)) as [[t0 [H0 V0]]|None].
    + exists t0. split; [lra|]. left. intros t Ht. apply Rle_antisym; [|apply P; lra].
      assert (0 <= - speed X t); [|lra]. apply (stays_above (fun t => - speed X t) t0 t); [lra | | | lra].
      * intros u Hu. apply opposite, (speed_continuous X a c); [exact C | lra].
      * apply (mostly_inside _ (c - h) c); [lra | lra | exact Falls].
    + exists (c - h). split; [lra|]. right. left. intros t Ht. apply Rnot_le_lt. intros V. apply None.
      exists t. split; assumption.
Qed.

(* Where the friction that would hold the contact is above - beta, it cannot start to slip to smaller values. *)
Lemma settles_above X a c : arrives X a c -> speed X c = 0 -> - beta < hold X c -> settles X a c.
Proof.
  intros Ar Zc Hc. pose proof Ar as [Hac [C O]].
  destruct (above_near (hold X) (- beta) c) as [e [He P]]; [| exact Hc |].
  { apply hold_continuous. intros; apply C; [assumption | lra]. }
  set (h := Rmin e (c - a)). assert (Hh : 0 < h) by (apply Rmin_glb_lt; lra).
  assert (E1 : h <= e) by apply Rmin_l. assert (E2 : h <= c - a) by apply Rmin_r.
  destruct (Classical_Prop.classic (exists t, c - h < t < c /\ 0 <= speed X t)) as [[t0 [H0 V0]]|None].
  - destruct (one_sided X t0 c) as [a' [Ha S]].
    + apply (arrives_later X a); [exact Ar | lra | lra].
    + intros t Ht. apply (stays_above (speed X) t0 t); [lra | | | exact V0].
      * intros u Hu. apply (speed_continuous X a c); [exact C | lra].
      * apply mostly_weaker with (2 := mostly_inside _ a c t0 t ltac:(lra) ltac:(lra) O). intros u Hu [r [[_ [A2 _]] D]].
        exists (size m b * (hold X u - r)). split; [apply speed_rate, D|]. intros V. rewrite A2 by exact V.
        specialize (P u ltac:(rewrite Rabs_left; lra)). apply Rmult_le_pos; lra.
    + exact Zc.
    + exists a'. split; [lra | exact S].
  - exists (c - h). split; [lra|]. right. right. intros t Ht. apply Rnot_le_lt. intros V. apply None. exists t. split; assumption.
Qed.
Lemma backward X a c : 0 < beta -> arrives X a c -> exists a', a <= a' < c /\ forall t, a' < t < c -> moves X t.
Proof.
  intros Hp Ar. apply settled_moves; [exact Ar|]. pose proof Ar as [Hac [C O]].
  assert (Near : forall s, 0 < s * speed X c -> exists h, 0 < h <= c - a /\ forall t, c - h < t < c -> 0 < s * speed X t).
  { intros s P. destruct (above_near (fun t => s * speed X t) 0 c) as [e [He Q]]; [| exact P |].
    - apply continuous_scaled, (speed_continuous X a c); [exact C | lra].
    - pose proof (Rmin_l e (c - a)). pose proof (Rmin_r e (c - a)). exists (Rmin e (c - a)).
      split; [split; [apply Rmin_glb_lt; lra | lra]|]. intros t Ht. apply Q. rewrite Rabs_left; lra. }
  destruct (Rtotal_order (speed X c) 0) as [L|[Z|G]].
  - destruct (Near (-1) ltac:(lra)) as [h [Hh P]]. exists (c - h). split; [lra|]. right. right.
    intros t Ht. specialize (P t Ht). lra.
  - destruct (Rlt_dec (- beta) (hold X c)) as [Q|Q]; [apply settles_above; assumption|].
    assert (V : forall t, speed (fun i t => - X i t) t = - speed X t) by (intros; apply (mirrored_dot b (fun i => X i t))).
    destruct (settles_above (fun i t => - X i t) a c) as [a' [Ha S]].
    + split; [exact Hac|]. split; [intros i t Hi Ht; apply opposite, C; assumption|].
      apply mostly_weaker with (2 := O). intros t _. apply moves_mirrored.
    + rewrite V, Z. ring.
    + assert (E : hold (fun i t => - X i t) c = - hold X c); [|rewrite E; lra].
      unfold hold. rewrite !dot_mul, (mirrored_dot _ (fun i => X i c)). field. lra.
    + exists a'. split; [exact Ha|].
      destruct S as [S|[S|S]]; [left | right; right | right; left]; intros t Ht; specialize (S t Ht); rewrite V in S; lra.
  - destruct (Near 1 ltac:(lra)) as [h [Hh P]]. exists (c - h). split; [lra|]. right. left. intros t Ht. specialize (P t Ht). lra.
Qed.

(* ---- The motion from a start: at rest in it before the time 0, so that its beginning needs no word of its own ---- *)
Section Start.
Variable x : nat -> R.
Definition motion X T := (forall i t, (i < m)%nat -> t <= 0 -> X i t = x i) /\
  (forall i t, (i < m)%nat -> t <= T -> continuous (X i) t) /\
  exists L : list R, forall t, 0 < t < T -> ~ In t L -> moves X t.
Lemma motion_continuous X T a c : motion X T -> c <= T -> continuous_between X a c.
Proof. intros [_ [C _]] Hc i t Hi Ht. apply C; [exact Hi | lra]. Qed.
Lemma motion_mostly X T a c : motion X T -> 0 <= a -> c <= T -> mostly (moves X) a c.
Proof. intros [_ [_ [L M]]] Ha Hc. apply (mostly_of_list L). intros t Ht. apply M. lra. Qed.
Lemma shorter X T T' : motion X T -> T' <= T -> motion X T'.
Proof.
  intros [S [C [L M]]] H. split; [exact S|]. split; [intros i t Hi Ht; apply C; [exact Hi | lra]|].
  exists L. intros t Ht. apply M. lra.
Qed.
Lemma motions_agree X Y T T' i t : motion X T -> motion Y T' -> t <= T -> t <= T' -> (i < m)%nat -> X i t = Y i t.
Proof.
  intros HX HY Ht Ht' Hi. pose proof HX as [SX _]. pose proof HY as [SY _].
  destruct (Rle_dec t 0) as [N|P]; [rewrite SX, SY by assumption; reflexivity|].
  apply (same_motion X Y 0 t); [lra | | | | | | exact Hi].
  - apply (motion_continuous X T); assumption.
  - apply (motion_continuous Y T'); assumption.
  - apply (motion_mostly X T); [exact HX | lra | exact Ht].
  - apply (motion_mostly Y T'); [exact HY | lra | exact Ht'].
  - intros k Hk. rewrite SX, SY by (assumption || lra). reflexivity.
Qed.

(* The value that all motions have which last so long *)
Definition the_motion i t : R := iota (fun v => exists X T, motion X T /\ t <= T /\ X i t = v).
Lemma the_motion_is X T i t : motion X T -> t <= T -> (i < m)%nat -> the_motion i t = X i t.
Proof.
  intros H Ht Hi. apply (iota_unique (K := R_AbsRing) (V := R_CompleteNormedModule)).
  - intros v [Y [T' [HY [Ht' E]]]]. rewrite <- E. apply (motions_agree Y X T' T); assumption.
  - exists X, T. split; [exact H|]. split; [exact Ht | reflexivity].
Qed.

(* Friction takes energy out: the state stays bounded, and its rate too. *)
Lemma bounded T : 0 <= T -> exists B, 0 <= B /\ forall X t, motion X t -> t <= T -> forall i u v, (i < m)%nat ->
  0 <= u -> u <= v -> v <= t -> Rabs (X i v - X i u) <= B * (v - u).
Proof.
  intros HT. set (Q := size m x * exp (2 * norm m A * T)). set (l := Sum m (fun _ => 1 + Q)).
  assert (Q0 : 0 <= Q) by (apply Rmult_le_pos; [apply size_nonneg | apply Rlt_le, exp_pos]).
  assert (l0 : 0 <= l) by (apply Sum_nonneg; intros; lra).
  exists (norm m A * l + beta * length b). pose proof (norm_nonneg m A) as HA. pose proof (length_nonneg m b) as Lb.
  assert (P1 : 0 <= norm m A * l) by (apply Rmult_le_pos; assumption).
  assert (P2 : 0 <= beta * length b) by (apply Rmult_le_pos; assumption).
  split; [lra|]. intros X t HX Ht i u v Hi Hu Huv Hv. pose proof HX as [SX _].
  assert (Size : forall z, 0 <= z <= t -> size m (fun i => X i z) <= Q).
  { intros z Hz. apply Rle_trans with (size m (fun i => X i 0) * exp (2 * norm m A * (z - 0))).
    - apply growth; [lra | apply (motion_continuous X t); [exact HX | lra] |].
      apply mostly_weaker with (2 := motion_mostly X t 0 z HX (Rle_refl 0) ltac:(lra)). intros y _ [r [[A1 [A2 _]] D]].
      exists (- r). split; [|intros k Hk; evar_last; [apply D, Hk | ring]].
      destruct (Rtotal_order (speed X y) 0) as [L|[Z|G]].
      + rewrite A2 by exact L. assert (0 <= beta * - speed X y) by (apply Rmult_le_pos; lra). lra.
      + rewrite Z. lra.
      + rewrite A1 by exact G. assert (0 <= beta * speed X y) by (apply Rmult_le_pos; lra). lra.
    - rewrite (size_ext m (fun i => X i 0) x) by (intros k Hk; apply SX; [exact Hk | lra]).
      apply Rmult_le_compat_l; [apply size_nonneg|].
      assert (Le : 2 * norm m A * (z - 0) <= 2 * norm m A * T) by (apply Rmult_le_compat_l; lra).
      destruct (Rle_lt_or_eq_dec _ _ Le) as [L|E]; [apply Rlt_le, exp_increasing, L | rewrite E; lra]. }
  assert (Len : forall z, 0 <= z <= t -> length (fun i => X i z) <= l).
  { intros z Hz. apply Sum_le. intros k Hk. pose proof (Size z Hz) as S. pose proof (size_part m (fun i => X i z) k Hk) as P.
    cbv beta in P. pose proof (Rle_0_sqr (X k z - 1)) as R1. pose proof (Rle_0_sqr (X k z + 1)) as R2.
    pose proof (Rle_0_sqr (X k z)) as R3. unfold Rsqr in *. apply Rabs_le. lra. }
  apply slope_mostly; [exact Huv | |].
  - intros z Hz. apply (motion_continuous X t u v); [exact HX | exact Hv | exact Hi | exact Hz].
  - apply mostly_weaker with (2 := motion_mostly X t u v HX Hu Hv). intros z Hz [r [[_ [_ Br]] D]].
    exists (mul A (fun k => X k z) i - r * b i). split; [apply D, Hi|].
    pose proof (Rabs_triang (mul A (fun k => X k z) i) (- (r * b i))) as Tr. rewrite Rabs_Ropp in Tr.
    assert (T1 : Rabs (mul A (fun k => X k z) i) <= norm m A * l).
    { apply Rle_trans with (1 := length_part m (mul A (fun k => X k z)) i Hi), Rle_trans with (1 := mul_length m A _).
      apply Rmult_le_compat_l; [exact HA | apply Len; lra]. }
    assert (T2 : Rabs (r * b i) <= beta * length b).
    { rewrite Rabs_mult. apply Rmult_le_compat; [apply Rabs_pos | apply Rabs_pos | apply Rabs_le; lra | apply length_part, Hi]. }
    unfold Rminus. lra.
Qed.

Lemma longer X T : motion X T -> 0 <= T -> exists T' Y, T < T' /\ motion Y T'.
Proof.
  intros [SX [CX [L M]]] HT. destruct (forward (fun i => X i T)) as [e [Y [He [CY [Y0 MY]]]]].
  set (Z := fun i => joined T (X i) (fun t => Y i (t - T))). exists (T + e / 2), Z. split; [lra|].
  assert (ZX : forall i t, t <= T -> Z i t = X i t) by (intros; apply joined_before; assumption).
  split; [intros i t Hi Ht; rewrite ZX by lra; apply SX; assumption|]. split.
  - intros i t Hi Ht. apply joined_continuous.
    + intros. apply CX; assumption.
    + intros H. apply (continuous_comp (fun t => t - T) (Y i)); [|apply CY; [exact Hi | lra]].
      apply (continuous_minus (V := R_NormedModule)); [apply continuous_id | apply continuous_const].
    + rewrite Rminus_diag_eq by reflexivity. symmetry. apply Y0, Hi.
  - exists (T :: L)%list. intros t Ht N. destruct (Rtotal_order t T) as [B|[->|A']].
    + apply (moves_near X Z t (T - t)); [lra | | apply M; [lra | intros I; apply N; right; exact I]].
      intros i z Hi Hz. apply Rabs_lt_between in Hz. symmetry. apply ZX. lra.
    + exfalso. apply N. left. reflexivity.
    + apply (moves_near (fun i t => Y i (t - T)) Z t (t - T)); [lra | | apply moves_later, MY; lra].
      intros i z Hi Hz. apply Rabs_lt_between in Hz. unfold Z. rewrite joined_after by lra. reflexivity.
Qed.

(* Motions to all times before c give one to c. *)
Lemma closed c : 0 < beta -> 0 < c -> (forall t, t < c -> exists X T, motion X T /\ t < T) -> exists X, motion X c.
Proof.
  intros Hp Hc Ex. destruct (bounded c) as [B [HB Lip]]; [lra|].
  assert (Lip' : forall i u v, (i < m)%nat -> 0 <= u -> u <= v -> v < c -> Rabs (the_motion i v - the_motion i u) <= B * (v - u)).
  { intros i u v Hi Hu Huv Hv. destruct (Ex v Hv) as [X [T [HX HT]]].
    rewrite !(the_motion_is X T) by (assumption || lra).
    apply (Lip X (Rmin T c)); [apply (shorter X T); [exact HX | apply Rmin_l] | apply Rmin_r | exact Hi | exact Hu | exact Huv |].
    apply Rmin_glb; lra. }
  assert (Lim : forall i, (i < m)%nat -> exists z : R, filterlim (the_motion i) (at_left c) (locally z)).
  { intros i Hi. apply (filterlim_locally_cauchy (F := at_left c) (the_motion i)). intros eps.
    set (h := eps / (B + 1)). assert (Hh : 0 < h) by (apply Rdiv_lt_0_compat; [apply cond_pos | lra]).
    assert (Eh : B * h < eps) by (assert (E : (B + 1) * h = eps) by (unfold h; field; lra); lra).
    exists (fun u => Rmax 0 (c - h) < u < c). split.
    - assert (Hm : 0 < c - Rmax 0 (c - h)).
      { assert (Rmax 0 (c - h) < c); [apply Rmax_lub_lt|]; lra. }
      exists (mkposreal _ Hm). intros u Hu Lu. split; [|exact Lu]. apply Rabs_lt_between in Hu. simpl in Hu.
      unfold minus, plus, opp in Hu; simpl in Hu. lra.
    - intros u v Hu Hv. pose proof (Rmax_l 0 (c - h)). pose proof (Rmax_r 0 (c - h)).
      assert (W : forall u v, Rmax 0 (c - h) < u -> u <= v -> v < c -> Rabs (the_motion i v - the_motion i u) < eps).
      { intros u' v' H1 H2 H3. apply Rle_lt_trans with (B * (v' - u')); [apply Lip'; (assumption || lra)|].
        apply Rle_lt_trans with (2 := Eh), Rmult_le_compat_l; lra. }
      change (Rabs (the_motion i v - the_motion i u) < eps).
      destruct (Rle_dec u v); [apply W; lra | rewrite Rabs_minus_sym; apply W; lra]. }
  set (Y := fun i t => if Rlt_dec t c then the_motion i t
    else iota (fun z : R => filterlim (the_motion i) (at_left c) (locally z))).
  assert (Before : forall X T i t, motion X T -> t <= T -> t < c -> (i < m)%nat -> X i t = Y i t).
  { intros X T i t HX Ht Htc Hi. unfold Y. destruct (Rlt_dec t c); [|lra]. symmetry. apply (the_motion_is X T); assumption. }
  assert (Cont : forall i t, (i < m)%nat -> t <= c -> continuous (Y i) t).
  { intros i t Hi Ht. destruct (Req_dec t c) as [->|N].
    - destruct (Lim i Hi) as [z Hz]. assert (Yc : forall t, c <= t -> Y i t = z).
      { intros u Hu. unfold Y. destruct (Rlt_dec u c); [lra|].
        apply (iota_filterlim_locally (K := R_AbsRing) (V := R_CompleteNormedModule) (F := at_left c)).
        exact Hz. }
      apply filterlim_locally. intros eps. rewrite Yc by lra. apply filterlim_locally with (eps := eps) in Hz.
      destruct Hz as [h Hh]. exists h. intros u Hu. destruct (Rlt_dec u c) as [L|G].
      + unfold Y. destruct (Rlt_dec u c); [|lra]. apply Hh; assumption.
      + rewrite Yc by lra. apply ball_center.
    - destruct (Ex t ltac:(lra)) as [X [T [HX HT]]]. pose proof (Rmin_l (T - t) (c - t)). pose proof (Rmin_r (T - t) (c - t)).
      apply (near_continuous (X i) _ t (Rmin (T - t) (c - t))); [apply Rmin_glb_lt; lra | |].
      + intros u Hu. apply Rabs_lt_between in Hu. apply (Before X T); (assumption || lra).
      + destruct HX as [_ [C _]]. apply C; [exact Hi | lra]. }
  assert (Local : forall X T t, motion X T -> t < T -> t < c -> moves X t -> moves Y t).
  { intros X T t HX HT Ht. pose proof (Rmin_l (T - t) (c - t)). pose proof (Rmin_r (T - t) (c - t)).
    apply (moves_near X Y t (Rmin (T - t) (c - t))); [apply Rmin_glb_lt; lra|].
    intros i u Hi Hu. apply Rabs_lt_between in Hu. apply (Before X T); (assumption || lra). }
  destruct (backward Y 0 c Hp) as [a [Ha Good]].
  { split; [exact Hc|]. split; [intros i t Hi Ht; apply Cont; [exact Hi | lra]|]. intros t Ht.
    destruct (Ex t Ht) as [X [T [HX HT]]]. pose proof HX as [_ [_ [L M]]]. exists L. intros u Hu N.
    apply (Local X T); [exact HX | lra | lra | apply M; [lra | exact N]]. }
  destruct (Ex a ltac:(lra)) as [X [T [HX HT]]]. pose proof HX as [SX [_ [L M]]]. exists Y. split; [|split].
  - intros i t Hi Ht. rewrite <- (Before X T) by (assumption || lra). apply SX; assumption.
  - exact Cont.
  - exists L. intros t Ht N. destruct (Rlt_dec t T) as [B'|G]; [|apply Good; lra].
    apply (Local X T); [exact HX | exact B' | lra | apply M; [lra | exact N]].
Qed.

Lemma motion_at_once : exists X, motion X 0.
Proof.
  exists (fun i _ => x i). split; [reflexivity|]. split; [intros; apply continuous_const|]. exists nil. intros t Ht. lra.
Qed.
Lemma motion_without_friction T : beta = 0 -> exists X, motion X T.
Proof.
  intros H0. set (X := fun i => joined 0 (fun _ => x i) (slip 1 x i)). exists X. split; [|split].
  - intros i t _ Ht. apply joined_before, Ht.
  - intros i t Hi _. apply joined_continuous; [intros; apply continuous_const | | symmetry; apply slip_start].
    intros _. apply (slip_continuous 1 x t t); [exact Hi | lra].
  - exists nil. intros t Ht _. apply (moves_near (slip 1 x) X t t); [lra | | apply slip_moves; [left | right]; auto].
    intros i u _ Hu. apply Rabs_lt_between in Hu. symmetry. apply joined_after. lra.
Qed.
Lemma motion_exists T : exists X, motion X T.
Proof.
  destruct Hbeta as [Hp|H0]; [|apply motion_without_friction; auto].
  destruct (Rle_dec T 0) as [N|P]; [destruct motion_at_once as [X HX]; exists X; apply (shorter X 0); assumption|].
  set (E := fun t => t <= T /\ exists X, motion X t).
  destruct (completeness E) as [c [Up Least]].
  - exists T. intros t [Ht _]. exact Ht.
  - exists 0. split; [lra | exact motion_at_once].
  - assert (Hc : 0 <= c) by (apply Up; split; [lra | exact motion_at_once]).
    assert (HcT : c <= T) by (apply Least; intros t [Ht _]; exact Ht).
    assert (HX : exists X, motion X c).
    { destruct (Req_dec c 0) as [->|N]; [exact motion_at_once|].
      destruct (Classical_Prop.classic (exists X, motion X c)) as [Y|None]; [exact Y|]. apply closed; [exact Hp | lra |].
      intros t Ht. apply Classical_Prop.NNPP. intros No. assert (c <= t); [|lra]. apply Least. intros u [_ [X HX]].
      apply Rnot_lt_le. intros G. apply No. exists X, u. split; assumption. }
    destruct HX as [X HX]. destruct (Req_dec c T) as [<-|N]; [exists X; exact HX|]. exfalso.
    destruct (longer X c HX Hc) as [T' [Y [HT HY]]]. pose proof (Rmin_l T T'). pose proof (Rmin_r T T').
    assert (c < Rmin T T') by (apply Rmin_glb_lt; lra). assert (Rmin T T' <= c); [|lra].
    apply Up. split; [assumption|]. exists Y. apply (shorter Y T'); assumption.
Qed.
(* One motion for all times *)
Lemma motion_for_ever : exists X, forall T, motion X T.
Proof.
  exists the_motion. intros T. destruct (motion_exists (T + 1)) as [X HX]. pose proof HX as [SX [CX [L M]]].
  assert (E : forall i t, (i < m)%nat -> t <= T + 1 -> X i t = the_motion i t)
    by (intros; symmetry; apply (the_motion_is X (T + 1)); assumption).
  split; [|split].
  - intros i t Hi Ht. destruct (motion_exists 0) as [Y HY]. rewrite (the_motion_is Y 0) by assumption. apply HY; assumption.
  - intros i t Hi Ht. apply (near_continuous (X i) _ t 1); [lra | | apply CX; [exact Hi | lra]].
    intros u Hu. apply Rabs_lt_between in Hu. apply E; [exact Hi | lra].
  - exists L. intros t Ht N. apply (moves_near X the_motion t 1); [lra | | apply M; [lra | exact N]].
    intros i u Hi Hu. apply Rabs_lt_between in Hu. apply E; [exact Hi | lra].
Qed.
End Start.
End Contact.
