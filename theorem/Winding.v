(** The signed coverage of a mesh is the winding number of its outline, wherever that is defined. *)
From Rasterproof Require Import Specification Boundary.
From Coq Require Import Lia.

Definition closed (c : chain) := forall f : point -> Z, sum (fun e => f (snd e) - f (fst e)) c = 0.

Lemma outline_is_closed m c : outline m c -> closed c.
Proof. intros H f. eapply outline_closed; eassumption. Qed.

Lemma off_in c p a b : off c p -> In (a, b) c -> ~ on_segment a b p.
Proof. unfold off. rewrite Forall_forall. intros H I. exact (H (a, b) I). Qed.

Lemma ends_on_segment a b : on_segment a b a /\ on_segment a b b.
Proof. unfold on_segment, edge. split; split; try ring; rewrite ?Z.sub_diag; lia. Qed.

Lemma sum_closed (f g : directed -> Z) h c : closed c ->
  (forall a b, In (a, b) c -> f (a, b) - g (a, b) = h b - h a) -> sum f c = sum g c.
Proof.
  intros C H. enough (sum f c - sum g c = 0) by lia. rewrite <- sum_minus, <- (C h).
  apply sum_ext. intros [a b] I. apply H; assumption.
Qed.

(** ** The ray does not matter *)

(** A point that is in line with p and none of the corners. *)
Lemma apex l p : exists o, forall v, In v l -> v <> p -> edge o v p <> 0.
Proof.
  assert (exists n, 0 < n /\ forall v, In v l -> Z.abs (py v - py p) < n) as (n & N & B).
  { induction l as [|w l (n & N & B)]; [exists 1; simpl; split; [lia|tauto]|].
    exists (n + Z.abs (py w - py p)). split; [lia|]. intros v [<-|I]; [|specialize (B v I)]; lia. }
  exists (Point (px p + 1) (py p + n)). intros v I D E. specialize (B v I).
  assert (X : n * (px v - px p) = py v - py p) by (unfold edge in E; cbn [px py] in E; lia).
  assert (px v - px p = 0) by nia.
  apply D, point_ext; lia.
Qed.

(** Where no edge of the triangle passes the sample, the tie rule does not matter. *)
Lemma signed_away r s o a b p : edge o a p <> 0 -> edge b o p <> 0 -> ~ on_segment a b p ->
  signed r (Triangle o a b) p = signed s (Triangle o a b) p.
Proof.
  intros A B S. assert (I : forall c d, edge c d p <> 0 -> inside r c d p = inside s c d p).
  { intros c d N. unfold inside. destruct (Z.eqb_spec (edge c d p) 0); [contradiction|].
    rewrite !andb_false_l. reflexivity. }
  unfold signed, covers, turned; cbn [corner_a corner_b corner_c].
  rewrite (I o a), (I b o), (I o b), (I a o); try (rewrite edge_turned; lia); try assumption.
  destruct (Z.eq_dec (edge a b p) 0) as [E|E].
  2: { rewrite (I a b), (I b a); [reflexivity| |]; try (rewrite edge_turned; lia); assumption. }
  assert (O : edge o a p * edge b o p < 0).
  { assert (D : 0 < (px a - px p) * (px b - px p) + (py a - py p) * (py b - py p)).
    { apply Z.nle_gt. intros D. apply S. split; assumption. }
    pose proof (corner_identity o a b p) as C. rewrite E in C.
    apply (f_equal px) in C as X. apply (f_equal py) in C as Y.
    unfold plus, times, minus, origin in X, Y; cbn [px py] in X, Y. revert A B X Y D.
    generalize (edge o a p) (edge b o p) (px a - px p) (px b - px p) (py a - py p) (py b - py p).
    intros u v ax bx ay b_y U V X Y D.
    assert (u * (bx * bx + b_y * b_y) + v * (ax * bx + ay * b_y) = 0).
    { apply (f_equal (Z.mul bx)) in X. apply (f_equal (Z.mul b_y)) in Y. lia. }
    assert (0 <= bx * bx + b_y * b_y) by nia. nia. }
  assert (F : inside s o a p && inside s b o p = false /\ inside s b o p && inside s o a p = false
    /\ inside s o b p && inside s a o p = false).
  { unfold inside. rewrite (edge_turned b o), (edge_turned o a).
    destruct (Z.ltb_spec 0 (edge o a p)), (Z.ltb_spec 0 (edge b o p)),
      (Z.ltb_spec 0 (- edge o a p)), (Z.ltb_spec 0 (- edge b o p)),
      (Z.eqb_spec (edge o a p) 0), (Z.eqb_spec (edge b o p) 0),
      (Z.eqb_spec (- edge o a p) 0), (Z.eqb_spec (- edge b o p) 0); simpl; repeat split; nia. }
  destruct F as (F & _ & G).
  destruct (inside s o a p), (inside s b o p), (inside s o b p), (inside s a o p),
    (inside r a b p), (inside s a b p), (inside r b a p), (inside s b a p); simpl in *;
    try discriminate; reflexivity.
Qed.

Theorem any_ray r s c p : half_circle_0 r -> half_circle_0 s -> closed c -> off c p ->
  sum (turn r p) c = sum (turn s p) c.
Proof.
  intros R S C O. destruct (apex (map fst c ++ map snd c) p) as (o & A).
  assert (E : forall a b, In (a, b) c -> edge o a p <> 0 /\ edge o b p <> 0).
  { intros a b I. pose proof (off_in c p a b O I) as N. pose proof (ends_on_segment a b) as [Ea Eb].
    split; apply A; try (intros ->; tauto); apply in_or_app; [left|right].
    - apply (in_map fst) in I. assumption.
    - apply (in_map snd) in I. assumption. }
  apply sum_closed with (h := fun v => turn r p (o, v) - turn s p (o, v)); [assumption|].
  intros a b I. destruct (E a b I) as [Ea Eb].
  pose proof (signed_away r s o a b p Ea) as H. rewrite edge_turned in H.
  specialize (H ltac:(lia) (off_in c p a b O I)).
  rewrite !triangle_is_its_boundary in H by assumption.
  unfold triangle_boundary in H; cbn [corner_a corner_b corner_c] in H; sums.
  pose proof (turn_reverse r p (o, b)) as X. pose proof (turn_reverse s p (o, b)) as Y.
  unfold reverse in *; cbn [fst snd] in *. lia.
Qed.

(** The rule whose ray goes to the right. *)
Definition to_the_right (d : point) : bool := (0 <? py d) || (py d =? 0) && (px d <? 0).

Ltac decide_all :=
  repeat match goal with
  | |- context [?x <? ?y] => destruct (Z.ltb_spec x y)
  | |- context [?x <=? ?y] => destruct (Z.leb_spec x y)
  | |- context [?x =? ?y] => destruct (Z.eqb_spec x y)
  | H : context [?x <? ?y] |- _ => destruct (Z.ltb_spec x y)
  | H : context [?x =? ?y] |- _ => destruct (Z.eqb_spec x y)
  end.

Lemma to_the_right_half : half_circle_0 to_the_right.
Proof.
  split; [split|reflexivity].
  - intros [x y] N. unfold to_the_right, times; cbn [px py].
    assert (x <> 0 \/ y <> 0) by (destruct (Z.eq_dec x 0), (Z.eq_dec y 0); auto; subst; now elim N).
    decide_all; simpl; try reflexivity; lia.
  - intros [x y] [u v] _ _. unfold to_the_right, plus; cbn [px py].
    intros. decide_all; simpl in *; try reflexivity; try discriminate; lia.
Qed.

Lemma crossing_is_turn p a b : ~ on_segment a b p -> crossing p (a, b) = turn to_the_right p (a, b).
Proof.
  intros N. unfold crossing, turn, side, to_the_right.
  assert (E : edge a b p = px (minus a p) * py (minus b p) - py (minus a p) * px (minus b p)).
  { unfold edge, minus; cbn [px py]; ring. }
  assert (M : edge a b p = 0 ->
    0 < px (minus a p) * px (minus b p) + py (minus a p) * py (minus b p)).
  { intros Z. apply Z.nle_gt. intros L. apply N. split; assumption. }
  replace (py a <=? py p) with (py (minus a p) <=? 0).
  2: { unfold minus; cbn [px py]. decide_all; lia. }
  replace (py b <=? py p) with (py (minus b p) <=? 0).
  2: { unfold minus; cbn [px py]. decide_all; lia. }
  replace (py p <? py a) with (0 <? py (minus a p)).
  2: { unfold minus; cbn [px py]. decide_all; lia. }
  replace (py p <? py b) with (0 <? py (minus b p)).
  2: { unfold minus; cbn [px py]. decide_all; lia. }
  revert E M. generalize (edge a b p) (px (minus a p)) (py (minus a p)) (px (minus b p)) (py
    (minus b p)).
  clear. intros e u v x y E M.
  assert (S : e = 0 -> v * y < 0 -> False).
  { intros Z L. specialize (M Z). assert (u * x > 0) by lia. assert (u * y = v * x) by lia.
    assert (u * y * (u * y) > 0) by nia. nia. }
  assert (T : e = 0 -> v * y = 0 -> 0 < u * x) by lia.
  clear M. destruct v as [|v|v], y as [|y|y], e as [|e|e]; simpl (_ && _); try reflexivity;
    try (exfalso; apply S; lia);
    destruct u as [|u|u], x as [|x|x]; try reflexivity; exfalso; clear S;
    try specialize (T eq_refl eq_refl); nia.
Qed.

Theorem winding_is_turns r c p : half_circle_0 r -> closed c -> off c p -> winding c p = sum (turn
  r p) c.
Proof.
  intros R C O. rewrite (any_ray r to_the_right); auto using to_the_right_half.
  apply sum_ext. intros [a b] I. apply crossing_is_turn. eapply off_in; eassumption.
Qed.
