(* For mu = 1 the energy of the difference of two motions falls; two steady motions of a damped scene have the same velocities. *)
Require Import Reals List Lra Lia Psatz PeanoNat.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes SteadyMode Sums Masses.
Open Scope R_scope.

(* Equal in the neighbourhood of a time *)
Lemma near_derive (f h : R -> R) t a e : 0 < e -> (forall x, Rabs (x - t) < e -> f x = h x) -> is_derive f t a -> is_derive h t a.
Proof. intros He H D. apply (is_derive_ext_loc f); [|exact D]. exists (mkposreal e He). intros x Hx. apply H, Hx. Qed.
Lemma near_continuous (f h : R -> R) t e : 0 < e -> (forall x, Rabs (x - t) < e -> f x = h x) -> continuous f t -> continuous h t.
Proof. intros He H D. apply (continuous_ext_loc (T := R_UniformSpace) (U := R_UniformSpace) h f t); [|exact D]. exists
  (mkposreal e He). intros x Hx. apply H, Hx. Qed.

(* A function that is f up to c and h afterwards *)
Definition joined (c : R) (f h : R -> R) (t : R) := if Rle_dec t c then f t else h t.
Lemma joined_before c f h t : t <= c -> joined c f h t = f t.
Proof. intros H. unfold joined. destruct (Rle_dec t c); [reflexivity | contradiction]. Qed.
Lemma joined_after c f h t : c < t -> joined c f h t = h t.
Proof. intros H. unfold joined. destruct (Rle_dec t c); [lra | reflexivity]. Qed.
Lemma joined_continuous c f h t : (t <= c -> continuous f t) -> (c <= t -> continuous h t) -> f c = h c -> continuous (joined c
  f h) t.
Proof.
  intros Cf Ch E. destruct (Rtotal_order t c) as [L|[->|G]].
  - apply (near_continuous f _ t (c - t)); [lra | | apply Cf; lra]. intros x Hx. apply Rabs_lt_between in Hx. rewrite
    joined_before by lra. reflexivity.
  - specialize (Cf (Rle_refl c)). specialize (Ch (Rle_refl c)). apply continuity_pt_filterlim in Cf. apply
    continuity_pt_filterlim in Ch.
    apply continuity_pt_filterlim. intros e He. destruct (Cf e He) as [a [Ha Fa]]. destruct (Ch e He) as [b [Hb Fb]].
    exists (Rmin a b). split; [apply Rmin_glb_lt; assumption|]. intros x [Dx Hx]. pose proof (Rmin_l a b). pose proof (Rmin_r a
      b).
    rewrite (joined_before c f h c) by lra. simpl in *. destruct (Rle_dec x c) as [X|X].
    + rewrite joined_before by lra. apply Fa. split; [exact Dx | lra].
    + rewrite joined_after by lra. rewrite E. apply Fb. split; [exact Dx | lra].
  - apply (near_continuous h _ t (t - c)); [lra | | apply Ch; lra]. intros x Hx. apply Rabs_lt_between in Hx. rewrite
    joined_after by lra. reflexivity.
Qed.

(* A continuous function that does not grow but at a finite number of times does not grow. *)
Lemma not_growing (L : list R) : forall (f : R -> R) a b, a <= b -> (forall t, a <= t <= b -> continuous f t) ->
  (forall t, a < t < b -> ~ In t L -> exists c, is_derive f t c /\ c <= 0) -> f b <= f a.
Proof.
  induction L as [|p L IH]; intros f a b Hab Cf H.
  - destruct (Req_dec a b) as [->|N]; [lra|].
    set (df := fun x => if Rlt_dec a x then (if Rlt_dec x b then Derive f x else 0) else 0).
    assert (Q : forall x, df x <= 0).
    { intros x. unfold df. destruct (Rlt_dec a x); [|lra]. destruct (Rlt_dec x b); [|lra].
      destruct (H x ltac:(lra)) as [k [D Hk]]; [intros []|]. apply is_derive_unique in D. lra. }
    destruct (MVT_gen f a b df) as [c [_ E]].
    + intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. unfold df. destruct (Rlt_dec a x); [|lra]. destruct (Rlt_dec x
      b); [|lra].
      destruct (H x Hx) as [c [D _]]; [intros []|]. apply Derive_correct. exists c. exact D.
    + intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. apply continuity_pt_filterlim. apply Cf, Hx.
    + specialize (Q c). nra.
  - destruct (Rlt_dec a p) as [A|A]; [destruct (Rlt_dec p b) as [B|B]|].
    + apply Rle_trans with (f p); apply IH; try lra.
      * intros t Ht. apply Cf. lra.
      * intros t Ht N. apply H; [lra|]. intros [<-|I]; [lra | contradiction].
      * intros t Ht. apply Cf. lra.
      * intros t Ht N. apply H; [lra|]. intros [<-|I]; [lra | contradiction].
    + apply IH; try assumption. intros t Ht N. apply H; [lra|]. intros [<-|I]; [lra | contradiction].
    + apply IH; try assumption. intros t Ht N. apply H; [lra|]. intros [<-|I]; [lra | contradiction].
Qed.

Lemma steady_inside (L : list R) (f : R -> R) a b : a <= b -> (forall t, a <= t <= b -> continuous f t) ->
  (forall t, a < t < b -> ~ In t L -> is_derive f t 0) -> forall t, a <= t <= b -> f t = f a.
Proof.
  intros Hab Cf H t Ht. apply Rle_antisym.
  - apply (not_growing L f a t); [lra | intros; apply Cf; lra|]. intros x Hx N. exists 0. split; [apply H; [lra | exact N] | lra].
  - apply Ropp_le_cancel. apply (not_growing L (fun t => - f t) a t); [lra | intros; apply (continuous_opp (V :=
    R_NormedModule)), Cf; lra|].
    intros x Hx N. exists 0. split; [|lra]. replace 0 with (- 0) by ring. apply (is_derive_opp (V := R_NormedModule)), H; [lra |
      exact N].
Qed.

(* Outside a finite number of times there is always a time left. *)
Lemma time_left (L : list R) : forall a b, a < b -> exists x, a < x < b /\ ~ In x L.
Proof.
  induction L as [|p L IH]; intros a b Hab.
  - exists ((a + b) / 2). split; [lra | intros []].
  - destruct (IH a b Hab) as [x [Hx N]]. destruct (Req_dec x p) as [->|E].
    + destruct (IH p b ltac:(lra)) as [x [Hx' N']]. exists x. split; [lra|]. intros [E|I]; [lra | contradiction].
    + exists x. split; [exact Hx|]. intros [E'|I]; [apply E; auto | contradiction].
Qed.
Lemma zero_at (L : list R) (f : R -> R) a b t : a < t < b -> continuous f t -> (forall x, a < x < b -> ~ In x L -> f x = 0) -> f
  t = 0.
Proof.
  intros Ht Cf H. destruct (Req_dec (f t) 0) as [E|E]; [exact E|]. exfalso. apply continuity_pt_filterlim in Cf.
  destruct (Cf (Rabs (f t)) (Rabs_pos_lt _ E)) as [d [Hd Q]].
  destruct (time_left L t (Rmin b (t + d))) as [x [Hx N]]; [apply Rmin_glb_lt; lra|].
  pose proof (Rmin_l b (t + d)). pose proof (Rmin_r b (t + d)).
  specialize (Q x). simpl in Q. unfold R_dist in Q. rewrite (H x ltac:(lra) N) in Q. rewrite Rminus_0_l, Rabs_Ropp in Q.
  assert (Rabs (f t) < Rabs (f t)); [|lra]. apply Q. split; [split; [exact I | lra]|]. rewrite Rabs_right; lra.
Qed.

(* Two values that Coulomb's law with mu = 1 allows, at two velocities: the friction on the difference takes no energy out of it
  below zero. *)
Lemma coulomb_is_monotone v w a b : coulomb 1 v a -> coulomb 1 w b -> 0 <= (a - b) * (v - w).
Proof.
  intros [A1 [A2 A3]] [B1 [B2 B3]].
  destruct (Rtotal_order v 0) as [V|[V|V]]; destruct (Rtotal_order w 0) as [W|[W|W]];
    try (pose proof (A1 V)); try (pose proof (A2 V)); try (pose proof (A3 V));
    try (pose proof (B1 W)); try (pose proof (B2 W)); try (pose proof (B3 W)); subst; nra.
Qed.
Lemma coulomb_is_bounded v a : coulomb 1 v a -> -1 <= a <= 1.
Proof. intros [P [M Z]]. destruct (Rtotal_order v 0) as [V|[V|V]]; [rewrite M | apply Z | rewrite P]; lra. Qed.
Lemma coulomb_is_odd mu v a : coulomb mu v a -> coulomb mu (- v) (- a).
Proof. intros [A1 [A2 A3]]. split; [|split]; intros H; [rewrite A2 | rewrite A1 |  assert (v = 0) by lra; specialize (A3 H0)];
  lra. Qed.

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

(* The difference of two motions in each mode, and its energy *)
Definition gap (f h : nat -> R -> R) i t := modal s (fun a => f a t - h a t) i.
Definition energy (y y1 z z1 : nat -> R -> R) t :=
  Sum N (fun i => / 2 * (gap y1 z1 i t * gap y1 z1 i t + / R_ i ^ 2 * (gap y z i t * gap y z i t))).

Section Pair.
Variables (load : nat -> R -> R) (T : R) (y y1 z z1 : nat -> R -> R).
Hypothesis Hz : forall i, (i < N)%nat -> 0 < zeta i.
Hypothesis Hb : 0 <= beta.
Hypothesis HY : motion_under s load T y y1.
Hypothesis HZ : motion_under s load T z z1.
Let p := gap y z.
Let p1 := gap y1 z1.
Let E := energy y y1 z z1.

Lemma gap_continuous i t : 0 <= t <= T -> continuous (p i) t /\ continuous (p1 i) t.
Proof.
  destruct HY as [Cy _], HZ as [Cz _]. intros Ht. split; unfold p, p1, gap; apply (modal_continuous s (fun a t => _ )); intros a
    Ha; destruct (Cy a t Ha Ht), (Cz a t Ha Ht); apply (continuous_minus (V := R_NormedModule)); assumption.
Qed.

(* f is the difference of the two signs of friction. *)
Lemma gap_equation : exists L, forall t, 0 < t < T -> ~ In t L -> exists (p2 : nat -> R) f,
  0 <= f * (y1 j t - z1 j t) /\ Rabs f <= 2 /\ (0 < y1 j t * z1 j t -> f = 0) /\
  forall i, (i < N)%nat -> is_derive (p i) t (p1 i t) /\ is_derive (p1 i) t (p2 i) /\
    p2 i + 2 * zeta i / R_ i * p1 i t + / R_ i ^ 2 * p i t = - (psi j i * (beta * f)).
Proof.
  destruct HY as [_ [Ly Ey]], HZ as [_ [Lz Ez]]. exists (Ly ++ Lz)%list.
  intros t Ht NL. assert (NY : ~ In t Ly) by (intro; apply NL, in_or_app; left; assumption). assert (NZ : ~ In t Lz) by
    (intro; apply NL, in_or_app; right; assumption).
  destruct (Ey t Ht NY) as [y2 [a [Ca Ea]]]. destruct (Ez t Ht NZ) as [z2 [b [Cb Eb]]].
  exists (modal s (fun k => y2 k - z2 k)), (a - b). split; [apply coulomb_is_monotone; assumption|]. split; [|split].
  - pose proof (coulomb_is_bounded _ _ Ca). pose proof (coulomb_is_bounded _ _ Cb). apply Rabs_le. lra.
  - intros P. destruct Ca as [A1 [A2 _]], Cb as [B1 [B2 _]]. destruct (Rtotal_order (y1 j t) 0) as [V|[V|V]];
      destruct (Rtotal_order (z1 j t) 0) as [W|[W|W]]; nra.
  - intros i Hi. split; [|split].
    + apply (modal_derive s (fun a t => y a t - z a t) (fun a t => y1 a t - z1 a t)). intros k Hk. destruct (Ea k Hk) as [D _].
      destruct (Eb k Hk) as [D' _].
      apply (is_derive_minus (V := R_NormedModule)); assumption.
    + apply (modal_derive s (fun a t => y1 a t - z1 a t) (fun a t => y2 a - z2 a)). intros k Hk. destruct (Ea k Hk) as [_ [D
      _]]. destruct (Eb k Hk) as [_ [D' _]].
      apply (is_derive_minus (V := R_NormedModule)); assumption.
    + unfold p, p1, gap. rewrite (modal_rows s Hs (fun k => y2 k - z2 k) (fun k => y1 k t - z1 k t) (fun k => y k t - z k t)
      (fun k
      => - (beta * delta k j * (a - b)))); [| |exact Hi].
      * rewrite (Sum_ext N _ (fun k => delta k j * - (psi k i * (beta * (a - b))))) by (intros; ring).
        apply (Sum_delta N j (fun k => - (psi k i * (beta * (a - b))))), Hj, Hs.
      * intros k Hk. destruct (Ea k Hk) as [_ [_ Q]]. destruct (Eb k Hk) as [_ [_ Q']].
        rewrite (Sum_ext N _ (fun b => (M k b * y2 b + C k b * y1 b t + K k b * y b t) - (M k b * z2 b + C k b * z1 b t + K k b
          * z b t))) by (intros; ring).
        rewrite Sum_minus. lra.
Qed.

Lemma energy_continuous t : 0 <= t <= T -> continuous E t.
Proof.
  intros Ht. apply (continuous_Sum N (fun i t => / 2 * (p1 i t * p1 i t + / R_ i ^ 2 * (p i t * p i t)))). intros i Hi.
  destruct (gap_continuous i t Ht) as [A B].
  apply continuous_scaled. apply (continuous_plus (V := R_NormedModule)); [|apply continuous_scaled]; apply (continuous_mult
    (K := R_AbsRing)); assumption.
Qed.

(* It falls, by the damping and by the friction. *)
Lemma energy_rate : exists L, forall t, 0 < t < T -> ~ In t L ->
  exists c, is_derive E t c /\ c <= - Sum N (fun i => 2 * zeta i / R_ i * (p1 i t * p1 i t)).
Proof.
  destruct gap_equation as [L Eq]. exists L.
  intros t Ht NL. destruct (Eq t Ht NL) as [p2 [f [Hf [_ [_ Q]]]]]. exists (Sum N (fun i => p1 i t * (p2 i + / R_ i ^ 2 * p i
    t))).
  split.
  - apply (is_derive_Sum N (fun i t => / 2 * (p1 i t * p1 i t + / R_ i ^ 2 * (p i t * p i t))) (fun i t => p1 i t * (p2 i + /
      R_ i ^ 2 * p i t))).
    intros i Hi. destruct (Q i Hi) as [D1 [D2 _]].
    evar_last.
    { apply is_derive_scal. apply (is_derive_plus (V := R_NormedModule)); [|apply is_derive_scal].
      - apply (is_derive_mult (K := R_AbsRing) (p1 i) (p1 i)); [exact D2 | exact D2 | intros; apply Rmult_comm].
      - apply (is_derive_mult (K := R_AbsRing) (p i) (p i)); [exact D1 | exact D1 | intros; apply Rmult_comm]. }
    unfold plus, mult; simpl. pose proof (Hratio s Hs i Hi). field; lra.
  - rewrite (Sum_ext N _ (fun i => - (beta * f) * (psi j i * p1 i t) - 2 * zeta i / R_ i * (p1 i t * p1 i t))).
    + rewrite Sum_minus, Sum_scal. unfold p1, gap. rewrite <- (physical s Hs (fun a => y1 a t - z1 a t) j (Hj s Hs)).
      assert (0 <= beta * (f * (y1 j t - z1 j t))) by (apply Rmult_le_pos; assumption). lra.
    + intros i Hi. destruct (Q i Hi) as [_ [_ Q3]]. replace (/ R_ i ^ 2 * p i t) with (- (psi j i * (beta * f)) - p2 i - 2 *
        zeta i / R_ i * p1 i t) by lra. ring.
Qed.

Lemma loss_pos t i : (i < N)%nat -> 0 <= 2 * zeta i / R_ i * (p1 i t * p1 i t).
Proof.
  intros Hi. pose proof (Hz i Hi). pose proof (Hratio s Hs i Hi). apply Rmult_le_pos; [|nra].
  apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat; assumption].
Qed.
Lemma energy_falls a b : 0 <= a -> a <= b -> b <= T -> E b <= E a.
Proof.
  intros H0 Hab H1. destruct energy_rate as [L E']. apply (not_growing L E a b Hab); [intros; apply energy_continuous; lra|].
  intros t Ht NL. destruct (E' t ltac:(lra) NL) as [c [D Q]]. exists c. split; [exact D|]. pose proof (Sum_nonneg N _ (loss_pos
    t)). lra.
Qed.

(* Where it does not fall, the velocities are the same. *)
Lemma at_rest : 0 < T -> E T = E 0 -> forall i t, (i < N)%nat -> 0 < t < T -> p1 i t = 0.
Proof.
  intros HT PE. assert (Const : forall t, 0 <= t <= T -> E t = E 0).
  { intros t Ht. pose proof (energy_falls 0 t ltac:(lra) ltac:(lra) ltac:(lra)). pose proof (energy_falls t T ltac:(lra)
      ltac:(lra) ltac:(lra)). lra. }
  destruct energy_rate as [L E'].
  assert (Rest : forall i t, (i < N)%nat -> 0 < t < T -> ~ In t L -> p1 i t = 0).
  { intros i t Hi Ht NL. destruct (E' t Ht NL) as [c [D Q]].
    assert (c = 0).
    { rewrite <- (is_derive_unique _ _ _ D). apply is_derive_unique. assert (Hm : 0 < Rmin t (T - t)) by (apply Rmin_glb_lt; lra).
      apply (near_derive (fun _ => E 0) E t 0 (Rmin t (T - t))); [exact Hm | | apply (is_derive_const (K := R_AbsRing) (V :=
        R_NormedModule))].
      intros x Hx. symmetry. apply Const. apply Rabs_lt_between in Hx. pose proof (Rmin_l t (T - t)). pose proof (Rmin_r t (T -
        t)). lra. }
    assert (Z : Sum N (fun i => 2 * zeta i / R_ i * (p1 i t * p1 i t)) = 0) by (pose proof (Sum_nonneg N _ (loss_pos t)); lra).
    pose proof (Sum_nonneg_zero N _ (loss_pos t) Z i Hi) as Z1. pose proof (Hz i Hi). pose proof (Hratio s Hs i Hi).
    assert (0 < 2 * zeta i / R_ i) by (apply Rdiv_lt_0_compat; lra). simpl in Z1.
    destruct (Rmult_integral _ _ Z1) as [Z2|Z2]; [lra | destruct (Rmult_integral _ _ Z2); assumption]. }
  intros i t Hi Ht.
  apply (zero_at L (p1 i) 0 T t); [exact Ht | apply gap_continuous; lra | intros x Hx NL; apply Rest; assumption].
Qed.
End Pair.

(* Steady motions: the energy returns to its value. *)
Lemma one_velocity load T y y1 z z1 : (forall i, (i < N)%nat -> 0 < zeta i) -> 0 <= beta -> 0 < T ->
  steady_under s load T y y1 -> steady_under s load T z z1 ->
  forall i t, (i < N)%nat -> 0 < t < T -> gap y1 z1 i t = 0.
Proof.
  intros Hz Hb HT [HY Py] [HZ Pz]. apply (at_rest load T y y1 z z1 Hz Hb HY HZ HT). unfold energy, gap, modal.
  apply Sum_ext. intros i Hi.
  rewrite (Sum_ext N (fun a => W s i a * (y1 a T - z1 a T)) (fun a => W s i a * (y1 a 0 - z1 a 0))) by (intros a Ha; destruct
    (Py a Ha), (Pz a Ha); congruence).
  rewrite (Sum_ext N (fun a => W s i a * (y a T - z a T)) (fun a => W s i a * (y a 0 - z a 0))) by (intros a Ha; destruct (Py
    a Ha), (Pz a Ha); congruence).
  reflexivity.
Qed.

Lemma nonzero_near (f : R -> R) t : continuous f t -> f t <> 0 -> exists e, 0 < e /\ forall x, Rabs (x - t) < e -> f x <> 0.
Proof.
  intros Cf N. assert (Nb : locally (f t) (fun v => v <> 0)) by (apply (open_neq 0), N).
  destruct (Cf _ Nb) as [e He]. exists e. split; [apply cond_pos | exact He].
Qed.

(* Where the contact moves the difference of two steady motions vanishes with the difference of the two signs of friction. *)
Lemma one_motion load T y y1 z z1 : (forall i, (i < N)%nat -> 0 < zeta i) -> 0 <= beta -> 0 < T ->
  steady_under s load T y y1 -> steady_under s load T z z1 ->
  (exists t, 0 < t < T /\ y1 j t <> 0) -> forall i t, (i < N)%nat -> 0 <= t <= T -> gap y z i t = 0.
Proof.
  intros Hz Hb HT Sy Sz [tm [Htm Mv]] i.
  assert (V := one_velocity load T y y1 z z1 Hz Hb HT Sy Sz). destruct Sy as [HY _], Sz as [HZ _].
  destruct (gap_equation load T y y1 z z1 HY HZ) as [L Eq].
  assert (Const : forall t, (i < N)%nat -> 0 <= t <= T -> gap y z i t = gap y z i 0).
  { intros t Hi. apply (steady_inside L (gap y z i) 0 T); [lra | intros; apply (gap_continuous load T y y1 z z1 HY HZ);
    assumption|].
    intros x Hx NL. destruct (Eq x Hx NL) as [p2 [f [_ [_ [_ Q]]]]]. destruct (Q i Hi) as [D _]. rewrite (V i x Hi Hx) in D. exact
      D. }
  intros t Hi Ht. rewrite (Const t Hi Ht).
  destruct (nonzero_near (y1 j) tm) as [e [He Ne]]; [apply HY; [apply Hj, Hs | lra] | exact Mv |].
  destruct (time_left L tm (Rmin T (tm + e))) as [x [Hx NL]]; [apply Rmin_glb_lt; lra|].
  pose proof (Rmin_l T (tm + e)). pose proof (Rmin_r T (tm + e)). assert (Hxx : 0 < x < T) by lra.
  assert (Nx : y1 j x <> 0) by (apply Ne; rewrite Rabs_right; lra).
  destruct (Eq x Hxx NL) as [p2 [f [_ [_ [F Q]]]]]. destruct (Q i Hi) as [_ [D2 Q3]].
  assert (Same : y1 j x = z1 j x).
  { apply Rminus_diag_uniq. rewrite (physical s Hs (fun a => y1 a x - z1 a x) j (Hj s Hs)). apply Sum_zero. intros k Hk.
    change (psi j k * gap y1 z1 k x = 0). rewrite V by assumption. ring. }
  assert (P2 : p2 i = 0).
  { rewrite <- (is_derive_unique _ _ _ D2). apply is_derive_unique. apply (near_derive (fun _ => 0) (gap y1 z1 i) x 0 (Rmin x (T -
      x))); [apply Rmin_glb_lt; lra | | apply (is_derive_const (K := R_AbsRing) (V := R_NormedModule))].
    intros w Hw. apply Rabs_lt_between in Hw. pose proof (Rmin_l x (T - x)). pose proof (Rmin_r x (T - x)). rewrite V;
      [reflexivity
      | exact Hi | lra]. }
  rewrite F in Q3 by (rewrite <- Same; assert (0 < Rsqr (y1 j x)) by (apply Rlt_0_sqr, Nx); unfold Rsqr in *; lra).
  rewrite P2, (V i x Hi Hxx), (Const x Hi ltac:(lra)) in Q3. pose proof (Hratio s Hs i Hi).
  assert (0 < / R_ i ^ 2) by (apply Rinv_0_lt_compat, pow_lt; assumption). apply (Rmult_eq_reg_l (/ R_ i ^ 2)); lra.
Qed.
End Scene.

Lemma no_gap s (f h : nat -> R -> R) k t : is_scene s -> (k < masses s)%nat -> (forall i, (i < masses s)%nat -> gap s f h i t =
  0) ->
  f k t = h k t.
Proof.
  intros Hs Hk Z. apply Rminus_diag_uniq. rewrite (physical s Hs (fun a => f a t - h a t) k Hk). apply Sum_zero. intros i Hi.
  change (shape s k i * gap s f h i t = 0). rewrite Z by exact Hi. ring.
Qed.
Theorem one_steady_velocity : forall s, Statements.one_steady_velocity s.
Proof.
  intros s Hs Hz Hb load T y y1 z z1 HT Hy Hzz k t Hk Ht. apply (no_gap s y1 z1 k t Hs Hk). intros i Hi.
  apply (one_velocity s Hs load T y y1 z z1 Hz Hb HT Hy Hzz i t Hi Ht).
Qed.
Theorem one_steady_motion : forall s, Statements.one_steady_motion s.
Proof.
  intros s Hs Hz Hb load T y y1 z z1 HT Hy Hzz Mv k t Hk Ht. apply (no_gap s y z k t Hs Hk). intros i Hi.
  apply (one_motion s Hs load T y y1 z z1 Hz Hb HT Hy Hzz Mv i t Hi Ht).
Qed.
Theorem contact_motions_are_under_a_load : forall s, Statements.contact_motions_are_under_a_load s.
Proof. intros s phi T y y1 [Cy [Ey _]]. split; assumption. Qed.
