(** The winding number is constant along a path that meets no edge of the chain. *)
From Rasterproof Require Import Specification Boundary Winding Coverage Partition Rules.
From Coq Require Import Lia.

(** An end of one lies on the other, or each has its ends on both sides of the other. *)
Definition meet (a b p q : point) : Prop :=
  on_segment a b p \/ on_segment a b q \/ on_segment p q a \/ on_segment p q b
  \/ edge a b p * edge a b q < 0 /\ edge p q a * edge p q b < 0.

Section Step.
Variables p q : point.
Hypothesis distinct : p <> q.

Let u := minus q p.
Definition along : tie_rule := normal (shift_rule u (Point (- py u) (px u))).

Lemma u_nonzero : 0 < dot u u.
Proof. apply nonzero, minus_not_origin. congruence. Qed.

Lemma along_half : half_circle_0 along.
Proof.
  apply normal_half, shift_rule_half. pose proof u_nonzero as N.
  unfold dot, cross in *; cbn [px py] in *. lia.
Qed.

Lemma side_along s a : a <> s ->
  side along s a = (0 <? cross (minus a s) u) || (cross (minus a s) u =? 0) && (0 <? dot (minus a
    s) u).
Proof.
  intros N. unfold side, along. rewrite normal_same by (apply minus_not_origin; assumption).
  unfold shift_rule. do 3 f_equal. unfold cross, dot; cbn [px py]. ring.
Qed.

Lemma cross_along s a : s = p \/ s = q -> cross (minus a s) u = - edge p q a.
Proof. intros [-> | ->]; unfold cross, edge, u, minus; cbn [px py]; ring. Qed.

(** A corner on the line through p and q is behind both or ahead of both. *)
Lemma same_way a : ~ on_segment p q a -> edge p q a = 0 ->
  dot (minus a p) u < 0 /\ dot (minus a q) u < 0 \/ 0 < dot (minus a p) u /\ 0 < dot (minus a q) u.
Proof.
  intros N E. pose proof u_nonzero as U.
  assert (D : 0 < dot (minus p a) (minus q a)).
  { apply Z.nle_gt. intros L. apply N. split; assumption. }
  assert (X : dot (minus a p) u * dot (minus a q) u = dot (minus p a) (minus q a) * dot u u).
  { assert (Z : edge p q a * edge p q a = 0) by (rewrite E; reflexivity).
    transitivity (dot (minus p a) (minus q a) * dot u u - edge p q a * edge p q a);
      [unfold edge, dot, u, minus; cbn [px py]; ring|lia]. }
  assert (P : 0 < dot (minus a p) u * dot (minus a q) u) by (rewrite X; apply Z.mul_pos_pos;
    assumption).
  revert P. generalize (dot (minus a p) u) (dot (minus a q) u). clear. intros s t P.
  destruct (Z.lt_trichotomy s 0) as [L|[->|G]]; [left|lia|right]; split; nia.
Qed.

Lemma same_side a : a <> p -> a <> q -> ~ on_segment p q a -> side along p a = side along q a.
Proof.
  intros P Q N. rewrite !side_along, !cross_along by auto.
  destruct (Z.eq_dec (edge p q a) 0) as [E|E].
  - destruct (same_way a N E); decide_all; simpl; lia || reflexivity.
  - decide_all; simpl; lia || reflexivity.
Qed.

Lemma same_up a b : ~ meet a b p q -> a <> p -> a <> q -> b <> p -> b <> q ->
  side along p a = false -> side along p b = true ->
  (0 <=? edge a b p) = (0 <=? edge a b q).
Proof.
  intros M Ap Aq Bp Bq A B.
  assert (N1 : ~ on_segment a b q) by (unfold meet in M; tauto).
  assert (N2 : ~ on_segment p q a) by (unfold meet in M; tauto).
  assert (N3 : ~ on_segment p q b) by (unfold meet in M; tauto).
  assert (N4 : ~ (edge a b p * edge a b q < 0 /\ edge p q a * edge p q b < 0)) by
    (unfold meet in M; tauto).
  rewrite side_along, cross_along in A, B by auto.
  assert (I : edge a b q - edge a b p = edge p q a - edge p q b) by
    (unfold edge; ring).
  assert (SA : 0 < edge p q a \/ edge p q a = 0 /\ dot (minus a p) u < 0).
  { pose proof (same_way a N2). revert A. decide_all; simpl; intros; try discriminate; lia. }
  assert (SB : edge p q b < 0 \/ edge p q b = 0 /\ 0 < dot (minus b q) u).
  { pose proof (same_way b N3). revert B. decide_all; simpl; intros; try discriminate; lia. }
  destruct (Z.leb_spec 0 (edge a b p)), (Z.leb_spec 0 (edge a b q)); try reflexivity; exfalso;
    [lia|].
  pose proof u_nonzero as U.
  destruct SA as [SA|[SA DA]], SB as [SB|[SB DB]].
  - destruct (Z.eq_dec (edge a b q) 0) as [Z|Z]; [|apply N4; nia].
    apply N1. split; [assumption|].
    (* q is on the line a b, and a and b are on either side of the line p q *)
    assert (X : edge p q a * dot (minus b q) (minus b q) = edge p q b * dot (minus a q) (minus b
      q)).
    { transitivity (edge p q b * dot (minus a q) (minus b q)
        - edge a b q * dot u (minus b q)); [unfold edge, dot, u, minus; cbn [px py]; ring|].
      rewrite Z. ring. }
    pose proof (nonzero _ (minus_not_origin b q Bq)) as V.
    change ((px a - px q) * (px b - px q) + (py a - py q) * (py b - py q))
      with (dot (minus a q) (minus b q)).
    nia.
  - assert (X : dot u u * edge a b q = - dot (minus b q) u * (edge p q a - edge p q b)
      + edge p q b * dot (minus a b) u).
    { unfold edge, dot, u, minus; cbn [px py]; ring. }
    nia.
  - assert (X : dot u u * edge a b p = - dot (minus a p) u * (edge p q a - edge p q b)
      + edge p q a * dot (minus a b) u).
    { unfold edge, dot, u, minus; cbn [px py]; ring. }
    nia.
  - lia.
Qed.

Lemma same_turn a b : ~ meet a b p q -> turn along p (a, b) = turn along q (a, b).
Proof.
  intros M.
  assert (D : a <> p /\ a <> q /\ b <> p /\ b <> q).
  { pose proof (ends_on_segment a b). repeat split; intros ->; apply M; unfold meet; tauto. }
  destruct D as (Ap & Aq & Bp & Bq).
  assert (SA : side along p a = side along q a) by (apply same_side; unfold meet in M; tauto).
  assert (SB : side along p b = side along q b) by (apply same_side; unfold meet in M; tauto).
  assert (R : ~ meet b a p q).
  { intros R. apply M. unfold meet, on_segment in *.
    rewrite (edge_turned a b), (edge_turned a b) in R. lia. }
  unfold turn. rewrite <- SA, <- SB.
  destruct (side along p a) eqn:A, (side along p b) eqn:B; simpl; try reflexivity.
  - pose proof (same_up b a R Bp Bq Ap Aq B A) as S. rewrite !(edge_turned a b) in S.
    revert S. decide_all; intros; lia || reflexivity || discriminate.
  - rewrite (same_up a b M) by assumption. reflexivity.
Qed.

End Step.

Theorem winding_constant c p q : closed c -> Forall (fun e => ~ meet (fst e) (snd e) p q) c ->
  winding c p = winding c q.
Proof.
  intros C F. destruct (point_dec p q) as [->|D]; [reflexivity|].
  assert (O : off c p /\ off c q).
  { split; eapply Forall_impl; try exact F; cbn beta; unfold meet; intros; tauto. }
  destruct O as [P Q]. pose proof (along_half p q D) as A.
  rewrite !(winding_is_turns (along p q)) by assumption.
  apply sum_ext. intros [a b] I. apply same_turn; [assumption|].
  rewrite Forall_forall in F. apply (F (a, b) I).
Qed.

(** Any ray: right, left, up and down give one number. *)
Theorem every_ray c p : closed c -> off c p -> forall u v, cross u v <> 0 ->
  winding c p = sum (turn (normal (shift_rule u v)) p) c.
Proof. intros. apply winding_is_turns; auto using normal_half, shift_rule_half. Qed.

(** Around a square it is 1 inside. *)
Definition square (a b : point) : chain :=
  [(a, Point (px b) (py a)); (Point (px b) (py a), b); (b, Point (px a) (py b));
    (Point (px a) (py b), a)].

Theorem winding_square a b p : px a < px p < px b -> py a < py p < py b -> winding (square a b) p
  = 1.
Proof.
  intros X Y. unfold winding, square. sums. unfold crossing; cbn [px py].
  assert (0 < edge (Point (px b) (py a)) b p) by (unfold edge; cbn [px py]; nia).
  assert (0 < edge (Point (px a) (py b)) a p) by (unfold edge; cbn [px py]; nia).
  repeat settle. reflexivity.
Qed.
