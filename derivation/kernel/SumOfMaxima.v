(* (56) is not necessary: two masses without damping whose modes demand most at different times. *)
Require Import Reals Lra Lia Psatz List.
From Coquelicot Require Import Coquelicot.
From Kernel Require Import Statements Modes SteadyMode Sums Masses Contact ContactMotion Misprints LargestDemand Threshold.
Open Scope R_scope.

(* Contact and load on the first mass; the modes have R = 2/5 and R = 2/7. *)
Definition scene_56 : scene :=
  Scene 2 (entry 1 0 0 1) (fun _ _ => 0) (entry (841 / 100) (- (72 / 25)) (- (72 / 25)) (1009 / 100))
    (entry (4 / 5) (3 / 5) (3 / 5) (- (4 / 5))) (fun i => match i with O => 2 / 5 | _ => 2 / 7 end) (fun _ => 0) 0 0 (1 / 7).

Lemma sevenths : PI / (2 / 7) = - (PI / 2) + 2 * INR 2 * PI. Proof. simpl. field. Qed.
Lemma sin_sevenths : sin (PI / (2 / 7)) = -1.
Proof. rewrite sevenths, sin_period, sin_neg, sin_PI2. ring. Qed.
Lemma cos_sevenths : cos (PI / (2 / 7)) = 0.
Proof. rewrite sevenths, cos_period, cos_neg, cos_PI2. ring. Qed.
Lemma admissible_sevenths : admissible (2 / 7) 0.
Proof. apply admissible_0; [lra | rewrite cos_sevenths; lra | lra]. Qed.
Lemma u_sevenths : u (2 / 7) 0 = - (7 / 2).
Proof. rewrite u_0, sin_sevenths, cos_sevenths. field. Qed.
Lemma scene_56_is_a_scene : is_scene scene_56.
Proof.
  split; [simpl; lia|]. split; [simpl; lia|]. split.
  - intros i Hi. simpl in Hi. destruct i as [|i]; [apply admissible_fifths | apply admissible_sevenths].
  - split; [|split]; intros i a Hi Ha; simpl in Hi, Ha; (destruct i as [|[|i]]; [| |lia]); (destruct a as [|[|a]]; [| |lia]);
    simpl; unfold delta; simpl; field.
Qed.
Lemma scene_56_values : V_abs scene_56 0 = 404 / 2625 /\ U scene_56 0 = 134 / 875.
Proof.
  split.
  - unfold V_abs. apply sqrt_of_square; [lra|]. unfold V_re, V_im, v_re, v_im. simpl. field.
  - unfold U. simpl. rewrite u_fifths, u_sevenths. field.
Qed.

(* What the modes demand, times sin(tau) *)
Definition first_mode t := 2 / 5 * (sin (5 / 2 * t) - cos (5 / 2 * t) + cos t).
Definition second_mode t := 2 / 7 * (sin (7 / 2 * t) + cos (7 / 2 * t) - cos t).
Lemma first_demand t : demand_of_mode (2 / 5) 0 t = first_mode t.
Proof.
  unfold demand_of_mode, first_mode. rewrite g_0, u_fifths, q_0, q_prime_0. replace (t / (2 / 5)) with (5 / 2 * t) by field.
    field.
Qed.
Lemma second_demand t : demand_of_mode (2 / 7) 0 t = second_mode t.
Proof.
  unfold demand_of_mode, second_mode. rewrite g_0, u_sevenths, q_0, q_prime_0. replace (t / (2 / 7)) with (7 / 2 * t) by field.
    field.
Qed.

(* The demand of both stays below 106/100. *)
Definition margin t := 106 / 100 * sin t - (16 / 25 * first_mode t + 9 / 25 * second_mode t).
Definition margin_rate t := 106 / 100 * cos t - (16 / 25 * (2 / 5 * (5 / 2 * cos (5 / 2 * t) + 5 / 2 * sin (5 / 2 * t) - sin t))
  + 9 / 25 * (2 / 7 * (7 / 2 * cos (7 / 2 * t) - 7 / 2 * sin (7 / 2 * t) + sin t))).
Lemma margin_derive t : is_derive margin t (margin_rate t).
Proof. unfold margin, margin_rate, first_mode, second_mode. auto_derive; [trivial | ring]. Qed.
Lemma rises_at_the_start t : 0 <= t <= 1 / 10 -> 0 < margin_rate t.
Proof. intros T. unfold margin_rate. by_boxes (t :: nil). Qed.
Lemma positive_between t : 1 / 10 <= t <= 29 / 10 -> 0 < margin t.
Proof. intros T. unfold margin, first_mode, second_mode. by_boxes (t :: nil). Qed.
Lemma falls_at_the_end t : 29 / 10 <= t <= 315 / 100 -> margin_rate t < 0.
Proof. intros T. unfold margin_rate. by_boxes (t :: nil). Qed.
Lemma margin_ends : margin 0 = 0 /\ margin PI = 0.
Proof.
  unfold margin, first_mode, second_mode. split.
  - rewrite !Rmult_0_r, sin_0, cos_0. ring.
  - replace (5 / 2 * PI) with (PI / (2 / 5)) by field. replace (7 / 2 * PI) with (PI / (2 / 7)) by field.
    rewrite sin_sevenths, cos_sevenths, fifths. replace (PI / 2 + 2 * PI) with (PI / 2 + 2 * INR 1 * PI) by (simpl; ring).
    rewrite sin_period, cos_period, sin_PI2, cos_PI2, sin_PI, cos_PI. field.
Qed.
Lemma margin_positive t : 0 < t < PI -> 0 < margin t.
Proof.
  intros T. destruct margin_ends as [M0 M1]. pose proof pi_between as Pb.
  destruct (Rle_lt_dec t (1 / 10)) as [A|A].
  - destruct (mean_value margin margin_rate 0 t ltac:(lra) margin_derive) as [x [Hx E]]. rewrite M0 in E.
    pose proof (rises_at_the_start x ltac:(lra)). nra.
  - destruct (Rle_lt_dec t (29 / 10)) as [B|B]; [apply positive_between; lra|].
    destruct (mean_value margin margin_rate t PI ltac:(lra) margin_derive) as [x [Hx E]]. rewrite M1 in E.
    pose proof (falls_at_the_end x ltac:(lra)). nra.
Qed.
Lemma modes_at_their_own_times : 107 / 100 <= 16 / 25 * (first_mode (1 / 2) / sin (1 / 2)) + 9 / 25 * (second_mode (1 / 20) /
  sin (1 / 20)).
Proof. unfold first_mode, second_mode. by_boxes (@nil R). Qed.

(* The supremum of a mode's demand *)
Lemma supremum_of_mode r z : admissible r z -> exists S, is_lub (fun y => exists t, 0 < t < PI /\ y = demand_of_mode r z t /
  sin t) S.
Proof.
  intros A. destruct (largest_demand (single_mass r z 0) (single_is_a_scene r z 0 A)) as [B [HB _]].
  destruct (completeness (fun y => exists t, 0 < t < PI /\ y = demand_of_mode r z t / sin t)) as [S HS]; [| |exists S; exact HS].
  - exists B. intros y [t [Ht ->]]. rewrite <- (single_demand r z 0). apply HB, Ht.
  - exists (demand_of_mode r z 1 / sin 1), 1. pose proof pi_between. split; [lra | reflexivity].
Qed.

Theorem eq_56_as_printed : Statements.eq_56_as_printed.
Proof.
  intros H. pose proof scene_56_is_a_scene as Sc. destruct scene_56_values as [EV EU].
  assert (R : responds scene_56).
  { unfold responds. simpl contact. rewrite EV, EU. simpl friction. rewrite Rabs_right; lra. }
  destruct (some_phase scene_56 R) as [phi P]. pose proof (root_sq scene_56 R) as RS. simpl contact in RS. rewrite EV, EU in RS.
  simpl friction in RS. pose proof (root_pos scene_56) as R0. set (r := root scene_56) in *.
  assert (Lo : 106 / 700 < r) by nra. assert (Up : r < 107 / 700) by nra.
  destruct (supremum_of_mode _ _ admissible_fifths) as [S1 H1]. destruct (supremum_of_mode _ _ admissible_sevenths) as [S2 H2].
  assert (Sl : slides scene_56 phi).
  { apply (slides_iff_ scene_56 Sc phi P). intros t Ht. pose proof (margin_positive t Ht) as M. unfold margin in M.
    pose proof (sin_gt_0 t ltac:(lra) ltac:(lra)) as Sp. unfold demand. simpl. rewrite first_demand, second_demand.
    set (n := 0 + _ + _). assert (N : n < 106 / 100 * sin t) by (unfold n; lra).
    assert (n / sin t < 106 / 100) by (apply (Rmult_lt_reg_r (sin t)); [exact Sp|]; replace (n / sin t * sin t) with n by
      (field; lra); exact N).
    change (1 / 7 * (n / sin t) < r). lra. }
  pose proof pi_between as Pb.
  assert (L1 : first_mode (1 / 2) / sin (1 / 2) <= S1) by (apply H1; exists (1 / 2); rewrite first_demand; split; [lra |
    reflexivity]).
  assert (L2 : second_mode (1 / 20) / sin (1 / 20) <= S2) by (apply H2; exists (1 / 20); rewrite second_demand; split; [lra |
    reflexivity]).
  specialize (H scene_56 (fun i => match i with O => S1 | _ => S2 end) phi Sc ltac:(simpl; lra) R P).
  assert (Lu : forall i, (i < masses scene_56)%nat -> is_lub (fun y => exists t, 0 < t < PI /\
    y = demand_of_mode (ratio scene_56 i) (damping_ratio scene_56 i) t / sin t) (match i with O => S1 | _ => S2 end)).
  { intros i Hi. simpl in Hi. destruct i as [|i]; [exact H1 | exact H2]. }
  specialize (H Lu Sl). rewrite root_of_sum in H. fold r in H. simpl in H. pose proof modes_at_their_own_times. lra.
Qed.
