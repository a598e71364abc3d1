(* (69) is the boundary of the regime: whatever steady motion reverses twice a period and never sticks is the closed form. *)
Require Import Reals List Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes SteadyMode Sums Masses Contact OneVelocity ContactMotion.
Open Scope R_scope.

Lemma zero_at_end (f : R -> R) b : 0 < b -> continuous f 0 -> (forall t, 0 < t < b -> f t = 0) -> f 0 = 0.
Proof.
  intros Hb Cf Z. destruct (Req_dec (f 0) 0) as [E|E]; [exact E|]. exfalso. destruct (nonzero_near f 0 Cf E) as [e [He N]].
  set (t := Rmin e b / 2). assert (0 < Rmin e b) by (apply Rmin_glb_lt; assumption). pose proof (Rmin_l e b). pose proof (Rmin_r
    e b).
  apply (N t); [unfold t; rewrite Rminus_0_r, Rabs_right; lra | apply Z; unfold t; lra].
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

(* A motion that solves (12) but at a finite number of times solves it at all times. *)
Lemma no_exceptions phi y y1 L : (forall a, (a < N)%nat -> continuous_on_half_period (y a) (y1 a)) ->
  (forall t, 0 < t < PI -> ~ In t L -> exists y2 : nat -> R, forall a, (a < N)%nat ->
    is_derive (y a) t (y1 a t) /\ is_derive (y1 a) t (y2 a) /\
    Sum N (fun b => M a b * y2 b + C a b * y1 b t + K a b * y b t) = delta a j * beta + delta a l * cos (t + phi)) ->
  exists y2, half_period_motion s phi y y1 y2.
Proof.
  intros Cy Ey.
  set (q := fun i t => modal s (fun a => y a t) i). set (q1 := fun i t => modal s (fun a => y1 a t) i).
  set (f0 := fun i => from_start (R_ i) (zeta i) (psi j i) (psi l i) beta phi (q i 0) (q1 i 0)).
  set (f1 := fun i => from_start_prime (R_ i) (zeta i) (psi j i) (psi l i) beta phi (q i 0) (q1 i 0)).
  set (f2 := fun i => from_start_second (R_ i) (zeta i) (psi j i) (psi l i) beta phi (q i 0) (q1 i 0)).
  assert (D01 : forall i t, (i < N)%nat -> is_derive (f0 i) t (f1 i t) /\ is_derive (f1 i) t (f2 i t)).
  { intros i t Hi. destruct (Hadm s Hs i Hi) as [Hr [Hz _]]. split; [apply from_start_rate | apply from_start_prime_rate];
      assumption. }
  assert (Same : forall i t, (i < N)%nat -> 0 <= t <= PI -> q i t = f0 i t /\ q1 i t = f1 i t).
  { intros i t Hi Ht. pose proof (Hadm s Hs i Hi) as A. pose proof A as [Hr [Hz _]].
    destruct (from_start_at_0 (R_ i) (zeta i) (psi j i) (psi l i) beta phi (q i 0) (q1 i 0) Hr Hz) as [S0 S1].
    set (e := fun t => q i t - f0 i t). set (e1 := fun t => q1 i t - f1 i t).
    set (F := fun t => e1 t * e1 t + / R_ i ^ 2 * (e t * e t)).
    assert (Ce : forall t, 0 <= t <= PI -> continuous e t /\ continuous e1 t).
    { intros x Hx. destruct (modal_continuous_half s y y1 i Cy x Hx) as [C0 C1]. destruct (D01 i x Hi) as [D0 D1].
      split; apply (continuous_minus (V := R_NormedModule)); try assumption; eapply continuous_of_derive; [exact D0 | exact D1]. }
    assert (Fall : F t <= F 0).
    { apply (not_growing L F 0 t); [lra | |].
      - intros x Hx. destruct (Ce x ltac:(lra)) as [C0 C1]. apply (continuous_plus (V := R_NormedModule)); [|apply
          continuous_scaled]; apply (continuous_mult (K := R_AbsRing)); assumption.
      - intros x Hx NL. destruct (Ey x ltac:(lra) NL) as [y2 Q]. set (q2 := modal s y2 i). destruct (D01 i x Hi) as [D0 D1].
        assert (De : is_derive e x (e1 x)).
        { apply (is_derive_minus (V := R_NormedModule)); [|exact D0]. apply (modal_derive s y y1). intros a Ha. apply (Q a Ha). }
        assert (De1 : is_derive e1 x (q2 - f2 i x)).
        { apply (is_derive_minus (V := R_NormedModule)); [|exact D1]. apply (modal_derive s y1 (fun a _ => y2 a)). intros a Ha.
          apply
            (Q a Ha). }
        exists (2 * e1 x * (q2 - f2 i x + / R_ i ^ 2 * e x)). split.
        + evar_last.
          { apply (is_derive_plus (V := R_NormedModule)); [|apply is_derive_scal].
            - apply (is_derive_mult (K := R_AbsRing) e1 e1); [exact De1 | exact De1 | intros; apply Rmult_comm].
            - apply (is_derive_mult (K := R_AbsRing) e e); [exact De | exact De | intros; apply Rmult_comm]. }
          unfold plus, mult; simpl. ring.
        + assert (E2 : q2 - f2 i x + / R_ i ^ 2 * e x = - (2 * zeta i / R_ i * e1 x)).
          { pose proof (from_start_equation (R_ i) (zeta i) (psi j i) (psi l i) beta phi (q i 0) (q1 i 0) x A) as Ef.
            fold (f0 i) (f1 i) (f2 i) in Ef.
            pose proof (modal_rows s Hs y2 (fun a => y1 a x) (fun a => y a x) (fun a => delta a j * beta + delta a l *
              cos (x + phi)) (fun a Ha => proj2 (proj2 (Q a Ha))) i Hi) as Eq.
            cbv beta in Eq. rewrite (load_on_modes s Hs i (cos (x + phi)) Hi) in Eq. fold q2 in Eq. change (modal s (fun a => y1
              a x) i) with (q1 i x)
              in Eq. change (modal s (fun a => y a x) i) with (q i x) in Eq.
            assert (Ef' : f2 i x + 2 * zeta i / R_ i * f1 i x + / R_ i ^ 2 * f0 i x = psi j i * beta + psi l i * cos (x + phi)).
            { apply (Rmult_eq_reg_l (R_ i ^ 2)); [|apply pow_nonzero; lra]. rewrite <- Ef. unfold f0, f1, f2. field. lra. }
            unfold e, e1. lra. }
          rewrite E2. assert (0 <= 2 * zeta i / R_ i) by (apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat, Hr]).
          pose proof (Rle_0_sqr (e1 x)) as Sq. unfold Rsqr in Sq.
          assert (0 <= 2 * zeta i / R_ i * (e1 x * e1 x)) by (apply Rmult_le_pos; assumption). lra. }
    assert (F0 : F 0 = 0) by (unfold F, e, e1, f0, f1; rewrite S0, S1; ring).
    assert (Ip : 0 < / R_ i ^ 2) by (apply Rinv_0_lt_compat, pow_lt, Hr).
    pose proof (Rle_0_sqr (e t)) as P0. pose proof (Rle_0_sqr (e1 t)) as P1. unfold Rsqr in P0, P1. unfold F in Fall, F0.
    assert (0 <= / R_ i ^ 2 * (e t * e t)) by (apply Rmult_le_pos; lra).
    assert (Z1 : e1 t * e1 t = 0) by lra. assert (Z0 : e t * e t = 0) by (apply (Rmult_eq_reg_l (/ R_ i ^ 2)); lra).
    apply Rmult_integral in Z0. apply Rmult_integral in Z1. unfold e, e1 in *. lra. }
  assert (Form : forall a t, (a < N)%nat -> 0 <= t <= PI -> y a t = Sum N (fun i => psi a i * f0 i t) /\ y1 a t = Sum N (fun i =>
    psi a i * f1 i t)).
  { intros a t Ha Ht. rewrite (physical s Hs (fun a => y a t) a Ha), (physical s Hs (fun a => y1 a t) a Ha).
    split; apply Sum_ext; intros i Hi; destruct (Same i t Hi Ht) as [E0 E1]; [rewrite <- E0 | rewrite <- E1]; reflexivity. }
  exists (fun a t => Sum N (fun i => psi a i * f2 i t)). intros t Ht a Ha.
  assert (Ee : 0 < Rmin t (PI - t)) by (apply Rmin_glb_lt; lra). pose proof (Rmin_l t (PI - t)). pose proof (Rmin_r t (PI - t)).
  split; [|split].
  - apply (near_derive (fun t => Sum N (fun i => psi a i * f0 i t)) _ t _ _ Ee).
    + intros x Hx. apply Rabs_lt_between in Hx. symmetry. apply Form; [exact Ha | lra].
    + rewrite (proj2 (Form a t Ha ltac:(lra))). apply (is_derive_Sum N (fun i t => psi a i * f0 i t) (fun i t => psi a i * f1 i
      t)).
      intros i Hi. apply is_derive_scal, D01, Hi.
  - apply (near_derive (fun t => Sum N (fun i => psi a i * f1 i t)) _ t _ _ Ee).
    + intros x Hx. apply Rabs_lt_between in Hx. symmetry. apply Form; [exact Ha | lra].
    + apply (is_derive_Sum N (fun i t => psi a i * f1 i t) (fun i t => psi a i * f2 i t)).
      intros i Hi. apply is_derive_scal, D01, Hi.
  - rewrite (Sum_ext N _ (fun b => M a b * Sum N (fun i => psi b i * f2 i t) + C a b * Sum N (fun i => psi b i * f1 i t) + K a b *
      Sum N (fun i => psi b i * f0 i t))) by (intros b Hb; destruct (Form b t Hb ltac:(lra)) as [-> ->]; reflexivity).
    rewrite (row s Hs a (fun i => f2 i t) (fun i => f1 i t) (fun i => f0 i t) Ha).
    rewrite (Sum_ext N _ (fun i => beta * (MP s a i * psi j i) + cos (t + phi) * (MP s a i * psi l i))).
    + rewrite Sum_plus, !Sum_scal, !(complete_1 s Hs) by (exact Ha || apply Hj, Hs || apply Hl, Hs). ring.
    + intros i Hi. pose proof (Hadm s Hs i Hi) as A. pose proof A as [Hr _].
      pose proof (from_start_equation (R_ i) (zeta i) (psi j i) (psi l i) beta phi (q i 0) (q1 i 0) t A) as Ef.
      assert (Ef' : f2 i t + 2 * zeta i / R_ i * f1 i t + / R_ i ^ 2 * f0 i t = psi j i * beta + psi l i * cos (t + phi)).
      { apply (Rmult_eq_reg_l (R_ i ^ 2)); [|apply pow_nonzero; lra]. rewrite <- Ef. unfold f0, f1, f2. field. lra. }
      rewrite Ef'. ring.
Qed.

(* Where the contact never sticks, it does not matter by how much static friction exceeds the kinetic one. *)
Lemma without_static_friction mu phi y y1 : 1 <= mu -> 0 < beta -> steady_contact_motion s mu phi (2 * PI) y y1 ->
  reverses_twice s
  y1 -> (forall t, 0 <= t <= 2 * PI -> ~ sticks s mu phi y y1 t) -> steady_contact_motion s 1 phi (2 * PI) y y1.
Proof.
  intros Hm Hb [[Cy [[L Ey] _]] Py] [V0 [b [Hbb [Neg Pos]]]] NS. split; [|exact Py]. split; [exact Cy|]. split.
  - exists (b :: L). intros t Ht NL. destruct (Ey t Ht) as [y2 [sg [Co Es]]]; [intros I; apply NL; right; exact I|].
    exists y2, sg. split; [|exact Es]. destruct Co as [C1 [C2 _]]. split; [exact C1|]. split; [exact C2|]. intros Z. exfalso.
    destruct (Rtotal_order t b) as [B|[->|B]]; [pose proof (Neg t ltac:(lra)); lra | apply NL; left; reflexivity | pose proof
      (Pos t
      ltac:(lra)); lra].
  - intros t Ht Z HL. exfalso. apply (NS t ltac:(lra)). split; [exact Z|]. nra.
Qed.

Lemma is_the_closed_form mu phi y y1 : (forall i, (i < N)%nat -> 0 < zeta i) -> 1 <= mu -> 0 < beta -> 0 < V_abs s j ->
  steady_contact_motion s mu phi (2 * PI) y y1 -> reverses_twice s y1 ->
  (forall t, 0 <= t <= 2 * PI -> ~ sticks s mu phi y y1 t) ->
  is_phase s phi /\ slides s phi /\ mu * beta < Rabs (holding_friction s phi).
Proof.
  intros Hz Hm Hb HV Hy Rv NS. pose proof PI_RGT_0 as Pp. pose proof (Hj s Hs) as J.
  pose proof (without_static_friction mu phi y y1 Hm Hb Hy Rv NS) as H1.
  destruct (steady_motion_is_symmetric s Hs Hz ltac:(lra) phi y y1 H1) as [Sv Sd].
  destruct Hy as [[Cy [[L Ey] _]] _]. destruct Rv as [V0 [b [Hbb [Neg Pos]]]].
  assert (Eb : b = PI).
  { destruct (Rtotal_order b PI) as [B|[B|B]]; [exfalso | exact B | exfalso].
    - pose proof (Sv j ((b + PI) / 2) J ltac:(lra)) as E. pose proof (Pos ((b + PI) / 2) ltac:(lra)). pose proof (Pos ((b + PI)
      / 2 +
        PI) ltac:(lra)). lra.
    - pose proof (Sv j ((b - PI) / 2) J ltac:(lra)) as E. pose proof (Neg ((b - PI) / 2) ltac:(lra)). pose proof (Neg ((b - PI)
      / 2 +
        PI) ltac:(lra)). lra. }
  subst b. specialize (Sd ltac:(exists (PI / 2); split; [lra | pose proof (Neg (PI / 2) ltac:(lra)); lra])).
  assert (Ch : forall a, (a < N)%nat -> continuous_on_half_period (y a) (y1 a)) by (intros a Ha t Ht; apply Cy; [exact Ha | lra]).
  destruct (no_exceptions phi y y1 L Ch) as [y2 Hm2].
  { intros t Ht NL. destruct (Ey t ltac:(lra) NL) as [y2 [sg [[_ [Sg _]] Es]]]. exists y2. rewrite (Sg (Neg t Ht)) in Es.
    intros a Ha. destruct (Es a Ha) as [D1 [D2 Q]]. split; [exact D1|]. split; [exact D2|]. lra. }
  assert (Mi : forall k, (k < N)%nat -> mirrored (y k) (y1 k)).
  { intros k Hk. split; [rewrite <- (Rplus_0_l PI) at 1; apply Sd; [exact Hk | lra]|].
    apply Rminus_diag_uniq. replace (y1 k PI - - y1 k 0) with (y1 k (0 + PI) + y1 k 0) by (rewrite Rplus_0_l; ring).
    apply (zero_at_end (fun t => y1 k (t + PI) + y1 k t) PI); [lra | | intros t Ht; rewrite Sv by assumption; ring].
    apply (continuous_plus (V := R_NormedModule)); [|apply Cy; [exact Hk | lra]].
    apply (continuous_comp (fun t => t + PI) (y1 k)); [apply (continuous_plus (V := R_NormedModule)); [apply continuous_id | apply
      continuous_const] | apply Cy; [exact Hk | lra]]. }
  assert (St : steady_half_period s phi y y1 y2) by (split; [exact Ch|]; split; [exact Hm2|]; split; [exact Mi | exact V0]).
  assert (Re : responds s).
  { split; [exact HV|]. apply Rnot_lt_le. intros Lt. apply (no_motion_without_root s Hs Lt phi y y1 y2 St). }
  pose proof (sign_of_the_root s Hs Hb phi y y1 y2 St Neg) as Sg.
  destruct (no_other_motion s Hs Re phi y y1 y2 St ltac:(lra)) as [P [_ Same]].
  split; [exact P|]. split.
  - intros t Ht. destruct (Same j t J ltac:(lra)) as [_ <-]. apply Neg, Ht.
  - apply Rnot_le_lt. intros Lo. apply (NS 0 ltac:(lra)). split; [exact V0|].
    rewrite (load_same s phi phi y y1 (x s phi) (x_prime s phi) 0 0) by (try reflexivity; intros a Ha; apply Same; exact Ha ||
      lra).
    unfold load_at. rewrite Rplus_0_l. exact Lo.
Qed.
End Scene.

Theorem eq_69_is_the_boundary : forall s, Statements.eq_69_is_the_boundary s.
Proof.
  intros s mu S Hs Hz Hm Hb HV L. pose proof PI_RGT_0 as Pp. rewrite <- (eq_69 s mu S Hs Hm Hb HV L). split.
  - intros [phi [y [y1 [Hy [Rv NS]]]]]. exists phi. apply (is_the_closed_form s Hs mu phi y y1); assumption.
  - intros [phi [P [SL HF]]]. pose proof (phase_responds s phi HV P) as Re.
    pose proof (closed_form_is_a_contact_motion s mu Hs Hm Re phi P SL HF) as Hy.
    exists phi, (continued (x s phi)), (continued (x_prime s phi)). split; [exact Hy|].
    assert (CJ : forall (f : nat -> R -> R) a, continued f a = joined PI (f a) (fun t => - f a (t - PI))) by reflexivity.
    assert (V0 : x_prime s phi (contact s) 0 = 0) by (destruct (x_initial s Hs phi (contact s) (Hj s Hs)), P; lra).
    split.
    + split; [rewrite CJ, joined_before by lra; exact V0|]. exists PI. split; [lra|]. split; intros t Ht; rewrite CJ.
      * rewrite joined_before by lra. apply SL, Ht.
      * rewrite joined_after by lra. pose proof (SL (t - PI) ltac:(lra)). lra.
    + assert (At0 : forall t f, t = 0 \/ t = 2 * PI -> forall a, (a < masses s)%nat -> f = x s phi \/ f = x_prime s phi ->
        continued f a t = f a 0).
      { intros t f Ht a Ha Hf. destruct Ht as [-> | ->].
        - rewrite CJ, joined_before by lra. reflexivity.
        - destruct Hy as [_ Py]. destruct (Py a Ha) as [E1 E2]. destruct Hf as [-> | ->]; [rewrite E1 | rewrite E2];
            rewrite CJ, joined_before by lra; reflexivity. }
      assert (End : forall t, t = 0 \/ t = 2 * PI -> load_at s phi (continued (x s phi)) (continued (x_prime s phi)) t =
        holding_friction s phi).
      { intros t Ht. rewrite (load_same s phi phi _ _ (x s phi) (x_prime s phi) t 0).
        - unfold load_at. rewrite Rplus_0_l. reflexivity.
        - destruct Ht as [-> | ->]; [reflexivity|]. replace (2 * PI + phi) with (0 + phi + 2 * INR 1 * PI) by (simpl; ring). apply
            cos_period.
        - intros a Ha. split; apply At0; auto. }
      intros t Ht [Z Lo]. destruct (Req_dec t 0) as [E|N0]; [|destruct (Req_dec t (2 * PI)) as [E|N1]; [|destruct (Rtotal_order
        t PI)
        as [B|[->|B]]]].
      * rewrite End in Lo by (left; exact E). lra.
      * rewrite End in Lo by (right; exact E). lra.
      * rewrite CJ, joined_before in Z by lra. pose proof (SL t ltac:(lra)). lra.
      * rewrite (load_opposite s phi _ _ (x s phi) (x_prime s phi) PI 0), Rabs_Ropp in Lo.
        -- unfold load_at in Lo. rewrite Rplus_0_l in Lo. unfold holding_friction in HF. lra.
        -- destruct (half_turn PI phi) as [_ ->]. replace (PI - PI) with 0 by ring. reflexivity.
        -- intros a _. rewrite !CJ, !joined_before by lra. apply (x_mirrored s Hs phi a).
      * rewrite CJ, joined_after in Z by lra. pose proof (SL (t - PI) ltac:(lra)). lra.
Qed.

Theorem X_j_is_the_largest : forall s, Statements.X_j_is_the_largest s.
Proof.
  intros s Hs phi [P1 P2] SL. pose proof PI_RGT_0. set (x := x s phi (contact s)).
  destruct (x_initial s Hs phi (contact s) (Hj s Hs)) as [E1 _]. destruct (x_mirrored s Hs phi (contact s)) as [Mi _].
  assert (X0 : x 0 = X_j s) by (unfold x, X_j; lra).
  assert (Fall : forall a b, 0 <= a -> a <= b -> b <= PI -> x b <= x a).
  { intros a b Ha Hab Hb. apply (not_growing nil x a b Hab).
    - intros t _. eapply continuous_of_derive, x_derive, Hs.
    - intros t Ht _. exists (x_prime s phi (contact s) t). split; [apply x_derive, Hs | apply Rlt_le, SL; lra]. }
  assert (In : forall t, 0 <= t <= PI -> - X_j s <= x t <= X_j s).
  { intros t Ht. rewrite <- X0 at 2. pose proof (Fall 0 t ltac:(lra) ltac:(lra) ltac:(lra)). pose proof (Fall t PI ltac:(lra)
      ltac:(lra) ltac:(lra)). change (x PI = - x 0) in Mi. lra. }
  split; [exact X0|]. intros t Ht. apply Rabs_le. unfold continued. fold x. destruct (Rle_dec t PI).
  - apply In. lra.
  - pose proof (In (t - PI) ltac:(lra)). lra.
Qed.
