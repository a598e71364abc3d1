(* The closed form over a whole period is a motion of Coulomb's contact; steady motions for mu = 1 mirror themselves. *)
Require Import Reals List Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes SteadyMode Sums Masses Contact OneVelocity.
Open Scope R_scope.

(* The load of (75) depends on the state at its time only, and turns over with it. *)
Lemma load_same s phi phi' (y y1 z z1 : nat -> R -> R) t t' : cos (t + phi) = cos (t' + phi') ->
  (forall a, (a < masses s)%nat -> y a t = z a t' /\ y1 a t = z1 a t') -> load_at s phi y y1 t = load_at s phi' z z1 t'.
Proof.
  intros C E. unfold load_at, holding_load. f_equal. apply Sum_ext. intros a Ha. rewrite C. f_equal. f_equal.
  apply Sum_ext. intros b Hb. destruct (E b Hb) as [-> ->]. reflexivity.
Qed.
Lemma load_opposite s phi (y y1 z z1 : nat -> R -> R) t t' : cos (t + phi) = - cos (t' + phi) ->
  (forall a, (a < masses s)%nat -> y a t = - z a t' /\ y1 a t = - z1 a t') -> load_at s phi y y1 t = - load_at s phi z z1 t'.
Proof.
  intros C E. unfold load_at, holding_load. rewrite C. transitivity (- (Sum (masses s) (fun a => Sum (masses s) (fun i => shape s
    (contact s) i * shape s a i) * (Sum (masses s) (fun b => damping s a b * z1 b t' + stiffness s a b * z b t') - delta a (loaded
    s) * cos (t' + phi)))) / mobility s); [|unfold Rdiv; ring]. f_equal.
  rewrite <- Sum_opp. apply Sum_ext. intros a Ha.
  rewrite (Sum_ext _ (fun b => damping s a b * y1 b t + stiffness s a b * y b t) (fun b => - (damping s a b * z1 b t' +
    stiffness s
    a b * z b t'))) by (intros b Hb; destruct (E b Hb) as [-> ->]; ring). rewrite Sum_opp. ring.
Qed.
Lemma half_turn t phi : cos (t + phi) = - cos (t + PI + phi) /\ cos (t + phi) = - cos (t - PI + phi).
Proof.
  replace (t + PI + phi) with (t + phi + PI) by ring. rewrite neg_cos. split; [ring|].
  replace (t + phi) with (t - PI + phi + PI) by ring. rewrite neg_cos. ring.
Qed.

(* A motion mirrored and moved by half a period *)
Definition turned_over (f : nat -> R -> R) (a : nat) := joined PI (fun t => - f a (t + PI)) (fun t => - f a (t - PI)).

Lemma turned_over_is_a_motion s mu phi y y1 : is_scene s -> steady_contact_motion s mu phi (2 * PI) y y1 ->
  steady_contact_motion s mu phi (2 * PI) (turned_over y) (turned_over y1).
Proof.
  intros Hs [[Cy [[L Ey] St]] Py]. pose proof PI_RGT_0 as P.
  assert (Sh : forall (f : R -> R) c t, continuous f (t + c) -> continuous (fun t => - f (t + c)) t).
  { intros f c t Cf. apply (continuous_opp (V := R_NormedModule)). apply (continuous_comp (fun t => t + c) f); [|exact Cf].
    apply (continuous_plus (V := R_NormedModule)); [apply continuous_id | apply continuous_const]. }
  assert (CJ : forall (f : nat -> R -> R) a t, (a < masses s)%nat -> (forall t, 0 <= t <= 2 * PI -> continuous (f a) t) -> f a
    (2 * PI) = f a 0 -> 0 <= t <= 2 * PI ->
    continuous (turned_over f a) t).
  { intros f a t Ha Cf E Ht. unfold turned_over. apply joined_continuous.
    - intros H. apply Sh, Cf. lra.
    - intros H. apply (Sh (f a) (- PI)), Cf. lra.
    - replace (PI + PI) with (2 * PI) by ring. replace (PI - PI) with 0 by ring. rewrite E. reflexivity. }
  split; [split; [|split]|].
  - intros a t Ha Ht. split; apply CJ; try assumption; try (apply Py, Ha); intros x Hx; apply Cy; assumption.
  - exists (PI :: map (fun t => t - PI) L ++ map (fun t => t + PI) L)%list. intros t Ht NL.
    assert (NP : t <> PI) by (intro; apply NL; left; auto).
    assert (N1 : ~ In (t + PI) L) by (intro I; apply NL; right; apply in_or_app; left; apply in_map_iff; exists (t + PI); split;
      [ring | exact I]).
    assert (N2 : ~ In (t - PI) L) by (intro I; apply NL; right; apply in_or_app; right; apply in_map_iff; exists (t - PI);
      split; [ring | exact I]).
    assert (Main : forall c, (c = PI \/ c = - PI) -> 0 < t + c < 2 * PI -> ~ In (t + c) L ->
      (exists e, 0 < e /\ forall f a x, Rabs (x - t) < e -> - f a (x + c) = turned_over f a x) ->
      exists (y2 : nat -> R) sigma, coulomb mu (turned_over y1 (contact s) t) sigma /\
      forall a, (a < masses s)%nat -> is_derive (turned_over y a) t (turned_over y1 a t) /\ is_derive (turned_over y1 a) t (y2
        a) /\
      Sum (masses s) (fun b => mass s a b * y2 b + damping s a b * turned_over y1 b t + stiffness s a b * turned_over y b t)
      + friction s * delta a (contact s) * sigma = delta a (loaded s) * cos (t + phi)).
    { intros c Hc Hin NI [e [He Loc]]. destruct (Ey (t + c) Hin NI) as [y2 [sg [Cs Es]]]. exists (fun a => - y2 a), (- sg).
      assert (V : forall f a, turned_over f a t = - f a (t + c)) by (intros; symmetry; apply Loc; rewrite Rminus_diag_eq,
        Rabs_R0 by reflexivity; exact He).
      assert (DS : forall (f : nat -> R -> R) a k, is_derive (f a) (t + c) k -> is_derive (turned_over f a) t (- k)).
      { intros f a k D. apply (near_derive (fun x => - f a (x + c)) _ t (- k) e He (Loc f a)). apply (is_derive_opp (V :=
        R_NormedModule)).
        evar_last. { apply (is_derive_comp (f a) (fun x => x + c)); [exact D | auto_derive; [trivial | reflexivity]]. }
        unfold scal; simpl; unfold mult; simpl. ring. }
      split; [rewrite V; apply coulomb_is_odd, Cs|]. intros a Ha. destruct (Es a Ha) as [D1 [D2 Q]]. split; [|split].
      - rewrite V. apply DS, D1.
      - apply DS, D2.
      - rewrite (Sum_ext _ _ (fun b => - (mass s a b * y2 b + damping s a b * y1 b (t + c) + stiffness s a b * y b (t + c)))) by
        (intros; rewrite !V; ring).
        rewrite Sum_opp. replace (cos (t + phi)) with (- cos (t + c + phi)); [lra|].
        destruct Hc as [->| ->].
        + replace (t + PI + phi) with (t + phi + PI) by ring. rewrite neg_cos. ring.
        + replace (t + - PI + phi) with (- (PI - (t + phi))) by ring. rewrite cos_neg. replace (PI - (t + phi)) with (- (t +
          phi) + PI) by ring. rewrite neg_cos, cos_neg. ring. }
    destruct (Rlt_dec t PI) as [B|B].
    + apply (Main PI); [left; reflexivity | lra | exact N1 |]. exists (PI - t). split; [lra|]. intros f a x Hx. apply
      Rabs_lt_between in Hx.
      unfold turned_over. rewrite joined_before by lra. reflexivity.
    + apply (Main (- PI)); [right; reflexivity | lra | exact N2 |]. exists (t - PI). split; [lra|]. intros f a x Hx. apply
      Rabs_lt_between in Hx.
      unfold turned_over. rewrite joined_after by lra. reflexivity.
  - pose proof (Hj s Hs) as J. intros t Ht V0 HL. destruct (Rlt_dec t PI) as [B|B].
    + assert (V : forall f a, turned_over f a t = - f a (t + PI)) by (intros; unfold turned_over; rewrite joined_before by lra;
      reflexivity).
      rewrite (load_opposite s phi _ _ y y1 t (t + PI)), Rabs_Ropp in HL by (try apply half_turn; intros; rewrite !V; split;
        reflexivity).
      rewrite V in V0. destruct (St (t + PI) ltac:(lra) ltac:(lra) HL) as [t' [Ht' Z]]. exists (t' - PI). split; [lra|].
      intros x Hx. unfold turned_over. rewrite joined_before, Z by lra. ring.
    + assert (V : forall f a x, (f = y \/ f = y1) -> (a < masses s)%nat -> PI <= x -> turned_over f a x = - f a (x - PI)).
      { intros f a x Hf Ha Hx. unfold turned_over. destruct (Req_dec x PI) as [->|N]; [|rewrite joined_after by lra; reflexivity].
        rewrite joined_before by lra. replace (PI + PI) with (2 * PI) by ring. replace (PI - PI) with 0 by ring.
        destruct (Py a Ha) as [E1 E2]. destruct Hf as [-> | ->]; congruence. }
      rewrite (load_opposite s phi _ _ y y1 t (t - PI)), Rabs_Ropp in HL by (try apply half_turn; intros; rewrite !V by (auto;
        lra); split; reflexivity).
      rewrite V in V0 by (auto; lra). destruct (St (t - PI) ltac:(lra) ltac:(lra) HL) as [t' [Ht' Z]].
      exists (Rmin (t' + PI) (2 * PI)). pose proof (Rmin_l (t' + PI) (2 * PI)). split; [split; [apply Rmin_glb_lt; lra | apply
        Rmin_r]|].
      intros x Hx. rewrite V, Z by (auto; lra). ring.
  - intros a Ha. unfold turned_over. rewrite !(joined_after PI _ _ (2 * PI)), !(joined_before PI _ _ 0) by lra. rewrite
    Rplus_0_l. replace (2 * PI - PI) with PI by ring. split; reflexivity.
Qed.

Theorem steady_motion_is_symmetric : forall s, Statements.steady_motion_is_symmetric s.
Proof.
  intros s Hs Hz Hb phi y y1 H. pose proof PI_RGT_0. pose proof (turned_over_is_a_motion s 1 phi y y1 Hs H) as H'.
  assert (F : forall f f1, steady_contact_motion s 1 phi (2 * PI) f f1 ->
    steady_under s (fun a t => delta a (loaded s) * cos (t + phi)) (2 * PI) f f1)
    by (intros f f1 [A B]; split; [apply contact_motions_are_under_a_load, A | exact B]).
  apply F in H, H'. split.
  - intros k t Hk Ht. rewrite (one_steady_velocity s Hs Hz Hb _ (2 * PI) _ _ _ _ ltac:(lra) H H' k t Hk ltac:(lra)).
    unfold turned_over. rewrite joined_before by lra. ring.
  - intros Mv k t Hk Ht. rewrite (one_steady_motion s Hs Hz Hb _ (2 * PI) _ _ _ _ ltac:(lra) H H' Mv k t Hk ltac:(lra)).
    unfold turned_over. rewrite joined_before by lra. ring.
Qed.

(* A motion over half a period that ends in its mirror image, continued by its mirror image *)
Lemma continued_motion s load y y1 : (forall a t, load a (t + PI) = - load a t) -> motion_under s load PI y y1 ->
  (forall k, (k < masses s)%nat -> y k PI = - y k 0 /\ y1 k PI = - y1 k 0) ->
  steady_under s load (2 * PI) (continued y) (continued y1).
Proof.
  intros Ly [Cy [L Ey]] My. pose proof PI_RGT_0 as Pp.
  assert (CJ : forall (f : nat -> R -> R) a, continued f a = joined PI (f a) (fun t => - f a (t - PI))) by reflexivity.
  assert (Sh : forall (f : R -> R) t, continuous f (t - PI) -> continuous (fun t => - f (t - PI)) t).
  { intros f t Cf. apply (continuous_opp (V := R_NormedModule)). apply (continuous_comp (fun t => t - PI) f); [|exact Cf].
    apply (continuous_minus (V := R_NormedModule)); [apply continuous_id | apply continuous_const]. }
  split; [split|].
  - intros a t Ha Ht. rewrite !CJ. destruct (My a Ha) as [M1 M2].
    split; apply joined_continuous; try (intros; apply Cy; [exact Ha | lra]); try (intros; apply Sh, Cy; [exact Ha | lra]);
      replace (PI - PI) with 0 by ring; assumption.
  - exists (PI :: L ++ map (fun t => t + PI) L)%list. intros t Ht NL. assert (NP : t <> PI) by (intro; apply NL; left; auto).
    destruct (Rlt_dec t PI) as [B|B].
    + destruct (Ey t ltac:(lra)) as [y2 [sg [Cs Es]]]; [intros I; apply NL; right; apply in_or_app; left; exact I|].
      exists y2, sg.
      assert (Loc : forall (f : nat -> R -> R) a z, Rabs (z - t) < PI - t -> f a z = continued f a z)
        by (intros f a z Hx; apply Rabs_lt_between in Hx; rewrite CJ, joined_before by lra; reflexivity).
      assert (V : forall f a, continued f a t = f a t) by (intros; rewrite CJ; apply joined_before; lra).
      split; [rewrite V; exact Cs|]. intros a Ha. destruct (Es a Ha) as [D1 [D2 Q]]. rewrite V. split; [|split].
      * apply (near_derive (y a) _ t _ (PI - t) ltac:(lra) (Loc _ a)), D1.
      * apply (near_derive (y1 a) _ t _ (PI - t) ltac:(lra) (Loc _ a)), D2.
      * rewrite (Sum_ext _ _ (fun b => mass s a b * y2 b + damping s a b * y1 b t + stiffness s a b * y b t))
          by (intros; rewrite !V; reflexivity). exact Q.
    + destruct (Ey (t - PI) ltac:(lra)) as [y2 [sg [Cs Es]]].
      { intros I. apply NL. right. apply in_or_app. right. apply in_map_iff. exists (t - PI). split; [ring | exact I]. }
      exists (fun a => - y2 a), (- sg).
      assert (Loc : forall (f : nat -> R -> R) a z, Rabs (z - t) < t - PI -> - f a (z - PI) = continued f a z)
        by (intros f a z Hx; apply Rabs_lt_between in Hx; rewrite CJ, joined_after by lra; reflexivity).
      assert (V : forall f a, continued f a t = - f a (t - PI)) by (intros; rewrite CJ, joined_after by lra; reflexivity).
      assert (DS : forall (f : R -> R) k, is_derive f (t - PI) k -> is_derive (fun z => - f (z - PI)) t (- k)).
      { intros f k D. apply (is_derive_opp (V := R_NormedModule)).
        evar_last. { apply (is_derive_comp f (fun x => x - PI)); [exact D | auto_derive; [trivial | reflexivity]]. }
        unfold scal; simpl; unfold mult; simpl. ring. }
      split; [rewrite V; apply coulomb_is_odd, Cs|]. intros a Ha. destruct (Es a Ha) as [D1 [D2 Q]]. rewrite V. split; [|split].
      * apply (near_derive (fun z => - y a (z - PI)) _ t _ (t - PI) ltac:(lra) (Loc _ a)), DS, D1.
      * apply (near_derive (fun z => - y1 a (z - PI)) _ t _ (t - PI) ltac:(lra) (Loc _ a)), DS, D2.
      * rewrite (Sum_ext _ _ (fun b => - (mass s a b * y2 b + damping s a b * y1 b (t - PI) + stiffness s a b * y b (t - PI))))
          by (intros; rewrite !V; ring).
        rewrite Sum_opp. pose proof (Ly a (t - PI)) as E. replace (t - PI + PI) with t in E by ring. lra.
  - intros a Ha. rewrite !CJ, !(joined_after PI _ _ (2 * PI)), !(joined_before PI _ _ 0) by lra.
    replace (2 * PI - PI) with PI by ring. destruct (My a Ha) as [M1 M2]. rewrite M1, M2. split; ring.
Qed.

(* So it is if the contact moves to smaller x throughout: friction then has one sign over the half-period. *)
Lemma continued_is_steady s load (y y1 y2 : nat -> R -> R) :
  (forall a t, is_derive (y a) t (y1 a t) /\ is_derive (y1 a) t (y2 a t)) -> (forall a, mirrored (y a) (y1 a)) ->
  (forall a t, (a < masses s)%nat ->
    Sum (masses s) (fun b => mass s a b * y2 b t + damping s a b * y1 b t + stiffness s a b * y b t) =
    delta a (contact s) * friction s + load a t) ->
  (forall a t, load a (t + PI) = - load a t) -> (forall t, 0 < t < PI -> y1 (contact s) t < 0) ->
  steady_under s load (2 * PI) (continued y) (continued y1).
Proof.
  intros Dy My Ey Ly SL. apply continued_motion; [exact Ly | | intros k _; apply My].
  split.
  - intros a t _ _. destruct (Dy a t). split; eapply continuous_of_derive; eassumption.
  - exists nil. intros t Ht _. exists (fun a => y2 a t), (-1). split; [pose proof (SL t Ht); repeat split; lra|].
    intros a Ha. destruct (Dy a t) as [D1 D2]. split; [exact D1 | split; [exact D2|]]. rewrite (Ey a t Ha). ring.
Qed.

(* The closed form, continued by its mirror image *)
Theorem closed_form_is_a_contact_motion : forall s, Statements.closed_form_is_a_contact_motion s.
Proof.
  intros s mu Hs Hmu Hr phi P SL HF. pose proof PI_RGT_0 as Pp.
  destruct (continued_is_steady s (fun a t => delta a (loaded s) * cos (t + phi)) (x s phi) (x_prime s phi) (x_second s phi))
    as [[Cy [L Ey]] Py]; try exact SL.
  - intros a t. split; [apply x_derive | apply x_prime_derive]; exact Hs.
  - intros a. apply x_mirrored, Hs.
  - intros a t Ha. apply x_equation; assumption.
  - intros a t. replace (t + PI + phi) with (t + phi + PI) by ring. rewrite neg_cos. ring.
  - assert (CJ : forall (f : nat -> R -> R) a, continued f a = joined PI (f a) (fun t => - f a (t - PI))) by reflexivity.
    split; [split; [exact Cy | split] | exact Py].
    + exists L. intros t Ht NL. destruct (Ey t Ht NL) as [y2 [sigma [[C1 [C2 C3]] E]]]. exists y2, sigma. split; [|exact E].
      split; [exact C1 | split; [exact C2 | intros V0; specialize (C3 V0); lra]].
    + intros t Ht V0 HL. exfalso. destruct (Req_dec t 0) as [->|N0]; [|destruct (Rtotal_order t PI) as [Lt|[->|Lt]]].
      * rewrite (load_same s phi phi _ _ (x s phi) (x_prime s phi) 0 0) in HL by (try reflexivity; intros; rewrite !CJ,
          !joined_before by lra; split; reflexivity).
        unfold load_at in HL. rewrite Rplus_0_l in HL. unfold holding_friction in HF. lra.
      * rewrite CJ, joined_before in V0 by lra. pose proof (SL t ltac:(lra)). lra.
      * rewrite (load_opposite s phi _ _ (x s phi) (x_prime s phi) PI 0), Rabs_Ropp in HL.
        -- unfold load_at in HL. rewrite Rplus_0_l in HL. unfold holding_friction in HF. lra.
        -- destruct (half_turn PI phi) as [_ ->]. replace (PI - PI) with 0 by ring. reflexivity.
        -- intros a _. rewrite !CJ, !joined_before by lra. apply (x_mirrored s Hs phi a).
      * rewrite CJ, joined_after in V0 by lra. pose proof (SL (t - PI) ltac:(lra)). lra.
Qed.

(* Where static friction holds the turning point it would rest there for some time. *)
Theorem closed_form_needs_54b : forall s, Statements.closed_form_needs_54b s.
Proof.
  intros s mu Hs phi P SL [[_ [_ St]] _]. pose proof PI_RGT_0 as Pp. apply Rnot_lt_le. intros L.
  assert (CJ : forall (f : nat -> R -> R) a, continued f a = joined PI (f a) (fun t => - f a (t - PI))) by reflexivity.
  assert (V0 : x_prime s phi (contact s) 0 = 0) by (destruct (x_initial s Hs phi (contact s) (Hj s Hs)), P; lra).
  destruct (St 0) as [t' [Ht' Z]]; [lra | rewrite CJ, joined_before by lra; exact V0 | |].
  - rewrite (load_same s phi phi _ _ (x s phi) (x_prime s phi) 0 0) by (try reflexivity; intros; rewrite !CJ, !joined_before by
    lra;
      split; reflexivity).
    unfold load_at. rewrite Rplus_0_l. exact L.
  - set (t := Rmin t' (PI / 2)). pose proof (Rmin_l t' (PI / 2)). pose proof (Rmin_r t' (PI / 2)).
    assert (0 < t) by (apply Rmin_glb_lt; lra). specialize (Z t ltac:(unfold t in *; lra)). rewrite CJ, joined_before in Z by
      (unfold
      t in *; lra).
    pose proof (SL t ltac:(unfold t in *; lra)). lra.
Qed.
