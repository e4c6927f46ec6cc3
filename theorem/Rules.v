(** The rules that are in use: shifts, the eight along the axes, Direct3D's words;
    and those that fail. *)
From Rasterproof Require Import Specification Boundary Winding Coverage Partition.
From Coq Require Import Lia Btauto.

(** The rule of the shift by e*u + e^2*v, for e that goes to 0. *)
Definition shift_rule (u v d : point) : bool :=
  (0 <? cross d u) || (cross d u =? 0) && (0 <? cross d v).

Theorem shift_rule_by_direction u v : by_direction (shift_rule u v).
Proof.
  intros k d K. unfold shift_rule.
  replace (cross (times k d) u) with (k * cross d u) by (unfold cross, times; cbn [px py]; ring).
  replace (cross (times k d) v) with (k * cross d v) by (unfold cross, times; cbn [px py]; ring).
  generalize (cross d u) (cross d v). intros s t.
  destruct (Z.ltb_spec 0 s), (Z.ltb_spec 0 (k * s)), (Z.eqb_spec s 0), (Z.eqb_spec (k * s) 0),
    (Z.ltb_spec 0 t), (Z.ltb_spec 0 (k * t)); simpl; try reflexivity; exfalso; nia.
Qed.

Theorem shift_rule_half u v : cross u v <> 0 -> half_circle (shift_rule u v).
Proof.
  intros N. split.
  - intros d D. assert (X : cross d u <> 0 \/ cross d v <> 0).
    { destruct (Z.eq_dec (cross d u) 0) as [A|]; [|auto].
      destruct (Z.eq_dec (cross d v) 0) as [B|]; [|auto].
      elim D. unfold cross in *. apply point_ext; cbn [px py]; [|].
      - apply (Z.mul_cancel_l _ _ _ N). apply (f_equal (Z.mul (px v))) in A.
        apply (f_equal (Z.mul (px u))) in B. cbn. lia.
      - apply (Z.mul_cancel_l _ _ _ N). apply (f_equal (Z.mul (py v))) in A.
        apply (f_equal (Z.mul (py u))) in B. cbn. lia. }
    unfold shift_rule.
    replace (cross (times (-1) d) u) with (- cross d u) by (unfold cross, times; cbn [px py]; ring).
    replace (cross (times (-1) d) v) with (- cross d v) by (unfold cross, times; cbn [px py]; ring).
    revert X. generalize (cross d u) (cross d v). intros. decide_all; simpl; lia || reflexivity.
  - intros d e _ _. unfold shift_rule.
    replace (cross (plus d e) u) with (cross d u + cross e u)
      by (unfold cross, plus; cbn [px py]; ring).
    replace (cross (plus d e) v) with (cross d v + cross e v)
      by (unfold cross, plus; cbn [px py]; ring).
    generalize (cross d u) (cross d v) (cross e u) (cross e v). intros.
    decide_all; simpl in *; try reflexivity; try discriminate; lia.
Qed.

(** The sample moves by (sign_x e, sign_y e^2), or by (sign_x e^2, sign_y e) if y moves first. *)
Definition axis_rule (sign_x sign_y : Z) (y_first : bool) : tie_rule :=
  if y_first then shift_rule (Point 0 sign_y) (Point sign_x 0)
  else shift_rule (Point sign_x 0) (Point 0 sign_y).

Theorem eight_rules_partition x y f : x = 1 \/ x = -1 -> y = 1 \/ y = -1 -> partitions (axis_rule
  x y f).
Proof.
  intros X Y. apply half_circle_partitions. destruct f; apply shift_rule_half;
    unfold cross; cbn [px py]; lia.
Qed.

Theorem top_left_is_a_shift d : top_left d = axis_rule 1 1 false d.
Proof.
  unfold top_left, axis_rule, shift_rule, cross; cbn [px py]. decide_all; simpl; reflexivity || lia.
Qed.

Theorem top_left_half : half_circle top_left.
Proof.
  destruct (shift_rule_half (Point 1 0) (Point 0 1)) as [O S]; [discriminate|].
  split; [intros d N|intros d e N M]; rewrite !top_left_is_a_shift; [apply O|apply S]; assumption.
Qed.

Theorem top_left_partitions : partitions top_left.
Proof. apply half_circle_partitions, top_left_half. Qed.

(** ** Direct3D's words *)

Lemma within_positive a b c p : 0 < edge a b c -> within a b c p = inside top_left a b p.
Proof.
  intros A. unfold within, inside.
  assert ((0 <? edge a b p * edge a b c) = (0 <? edge a b p)) as ->.
  { destruct (Z.ltb_spec 0 (edge a b p)), (Z.ltb_spec 0 (edge a b p * edge a b c));
      try reflexivity; nia. }
  assert (top a b c || left a b c = top_left (minus b a)) as ->; [|reflexivity].
  unfold top, left, top_left, minus, edge in *; cbn [px py].
  destruct (Z.compare_spec (py a) (py b)) as [E|L|G].
  - rewrite E in *. assert (0 < (px b - px a) * (py c - py b)) by lia.
    destruct (Z.ltb_spec (py b) (py c)), (Z.ltb_spec 0 (px b - px a)); try (exfalso; nia);
      decide_all; simpl; reflexivity || lia.
  - decide_all; simpl; reflexivity || lia.
  - decide_all; simpl; reflexivity || lia.
Qed.

Lemma within_reversed a b c p : within a b c p = within b a c p.
Proof.
  unfold within. f_equal.
  - f_equal. rewrite (edge_turned a b), (edge_turned a b). ring.
  - f_equal; [rewrite (edge_turned a b); decide_all; lia || reflexivity|].
    unfold top, left. f_equal; decide_all; simpl; lia || reflexivity.
Qed.

Theorem direct3d_is_top_left t p : area t <> 0 ->
  direct3d t p = if 0 <? area t then covers top_left t p else covers top_left (turned t) p.
Proof.
  destruct t as [a b c]. unfold area, turned, direct3d, covers; cbn [corner_a corner_b corner_c].
  intros N. assert (R : edge b c a = edge a b c /\ edge c a b = edge a b c) by
    (unfold edge; split; ring). destruct R as [R1 R2].
  destruct (Z.ltb_spec 0 (edge a b c)).
  - rewrite !within_positive by lia. reflexivity.
  - rewrite (within_reversed a b), (within_reversed b c), (within_reversed c a).
    rewrite !within_positive by (rewrite edge_turned; lia). btauto.
Qed.

(** ** A common edge *)

Lemma on_common_edge r a b c d p : 0 < edge a b c -> 0 < edge b a d -> on_segment a b p ->
  p <> a -> p <> b ->
  owners r [Triangle a b c; Triangle b a d] p = Z.b2z (r (minus b a)) + Z.b2z (r (minus a b)).
Proof.
  intros C D [E S] A B.
  assert (N : forall v, p <> v -> 0 < dot (minus v p) (minus v p)).
  { intros v V. apply nonzero. intros Z. apply V. symmetry.
    apply point_ext; [apply (f_equal px) in Z|apply (f_equal py) in Z];
      unfold minus, origin in *; cbn [px py] in *; lia. }
  assert (Q : forall u v w, 0 < edge u v w -> edge u v p = 0 ->
    dot (minus u p) (minus v p) <= 0 -> p <> u -> p <> v -> 0 < edge v w p /\ 0 < edge w u p).
  { intros u v w W Z T U V. pose proof (N u U) as Nu. pose proof (N v V) as Nv.
    pose proof (area_identity u v w p) as I. pose proof (corner_identity u v w p) as J.
    rewrite Z in I, J. apply (f_equal px) in J as X. apply (f_equal py) in J as Y.
    unfold edge in Z. unfold dot, plus, times, minus, origin in *; cbn [px py] in *.
    assert (D1 : edge v w p * dot (minus u p) (minus v p) + edge w u p * dot (minus v p) (minus v
      p) = 0).
    { unfold dot, minus; cbn [px py]. apply (f_equal (Z.mul (px v - px p))) in X.
      apply (f_equal (Z.mul (py v - py p))) in Y. lia. }
    assert (D2 : edge v w p * dot (minus u p) (minus u p) + edge w u p * dot (minus u p) (minus v
      p) = 0).
    { unfold dot, minus; cbn [px py]. apply (f_equal (Z.mul (px u - px p))) in X.
      apply (f_equal (Z.mul (py u - py p))) in Y. lia. }
    unfold dot, minus in D1, D2; cbn [px py] in D1, D2. clear X Y Z.
    revert T Nu Nv I W D1 D2.
    generalize ((px u - px p) * (px v - px p) + (py u - py p) * (py v - py p))
      ((px v - px p) * (px v - px p) + (py v - py p) * (py v - py p))
      ((px u - px p) * (px u - px p) + (py u - py p) * (py u - py p))
      (edge v w p) (edge w u p) (edge u v w).
    clear. intros uv vv uu s t area T U V I W D1 D2. nia. }
  assert (S' : dot (minus a p) (minus b p) <= 0) by (unfold dot, minus; cbn [px py]; assumption).
  destruct (Q a b c C E S' A B) as [P1 P2].
  destruct (Q b a d D) as [P3 P4]; auto.
  { rewrite edge_turned; lia. }
  { unfold dot in *; lia. }
  unfold owners. sums. unfold covers; cbn [corner_a corner_b corner_c].
  rewrite (inside_tie r a b), (inside_tie r b a), (inside_strictly r b c), (inside_strictly r c a),
    (inside_strictly r a d), (inside_strictly r d b) by (assumption || rewrite edge_turned; lia).
  rewrite !andb_true_r. lia.
Qed.

(** Of two opposite directions one: that is all that a common edge asks for. *)
Definition antisymmetric (r : tie_rule) := forall d, d <> origin -> r (times (-1) d) = negb (r d).

Theorem antisymmetric_common_edge r : antisymmetric r -> common_edge r.
Proof.
  intros H a b c d p C D S A B. rewrite on_common_edge by assumption.
  replace (minus a b) with (times (-1) (minus b a)) by points.
  rewrite H; [destruct (r (minus b a)); reflexivity|].
  apply (edge_distinct a b c). lia.
Qed.

(** Ties that are inside for all, and for none. *)
Theorem inclusive_ties_cover_twice a b c d p : 0 < edge a b c -> 0 < edge b a d -> on_segment a b
  p ->
  p <> a -> p <> b -> owners (fun _ => true) [Triangle a b c; Triangle b a d] p = 2.
Proof. intros. rewrite on_common_edge by assumption. reflexivity. Qed.

Theorem exclusive_ties_leave_gaps a b c d p : 0 < edge a b c -> 0 < edge b a d -> on_segment a b p
  ->
  p <> a -> p <> b -> owners (fun _ => false) [Triangle a b c; Triangle b a d] p = 0.
Proof. intros. rewrite on_common_edge by assumption. reflexivity. Qed.

(** ** One owner of a common edge is not enough *)

(** The sign of sin 3 angle, times the length cubed; where it is 0, the side of larger x. *)
Definition three_lobes (d : point) : bool :=
  let s := py d * (3 * (px d * px d) - py d * py d) in (0 <? s) || (s =? 0) && (0 <? px d).

Theorem three_lobes_common_edge : common_edge three_lobes.
Proof.
  apply antisymmetric_common_edge. intros [x y] N. unfold three_lobes, times; cbn [px py].
  replace (-1 * y * (3 * (-1 * x * (-1 * x)) - -1 * y * (-1 * y))) with (- (y * (3 * (x * x) - y *
    y)))
    by ring.
  assert (Z : y * (3 * (x * x) - y * y) = 0 -> x <> 0).
  { intros E X. subst x. assert (y = 0) by nia. subst y. now elim N. }
  revert Z. generalize (y * (3 * (x * x) - y * y)). intros s Z.
  decide_all; simpl; lia || reflexivity.
Qed.

Theorem three_lobes_by_direction : by_direction three_lobes.
Proof.
  intros k [x y] K. unfold three_lobes, times; cbn [px py].
  replace (k * y * (3 * (k * x * (k * x)) - k * y * (k * y)))
    with (k * k * k * (y * (3 * (x * x) - y * y))) by ring.
  generalize (y * (3 * (x * x) - y * y)). intros s. assert (0 < k * k * k) by nia.
  destruct (Z.ltb_spec 0 s), (Z.ltb_spec 0 (k * k * k * s)), (Z.eqb_spec s 0),
    (Z.eqb_spec (k * k * k * s) 0), (Z.ltb_spec 0 x), (Z.ltb_spec 0 (k * x)); simpl;
      try reflexivity;
    exfalso; nia.
Qed.

(** A hub of six triangles around the origin, whose outline surrounds it once. *)
Definition hub : mesh :=
  let spoke a b := Triangle origin a b in
  let (a, b) := (Point 1 1, Point (-1) 2) in
  let (c, d) := (Point (-2) 1, Point (-1) (-1)) in
  let (e, f) := (Point 1 (-2), Point 2 (-1)) in
  [spoke a b; spoke b c; spoke c d; spoke d e; spoke e f; spoke f a].

Example three_owners : owners three_lobes hub origin = 3.
Proof. vm_compute. reflexivity. Qed.

Example top_left_has_one_owner : owners top_left hub origin = 1.
Proof. vm_compute. reflexivity. Qed.

Theorem common_edge_does_not_partition : exists r, by_direction r /\ common_edge r /\ ~ partitions
  r.
Proof.
  exists three_lobes. repeat split; [apply three_lobes_by_direction|apply three_lobes_common_edge|].
  intros P. apply main in P as [_ S]; [|apply three_lobes_by_direction].
  specialize (S (Point 1 1) (Point (-2) 1) ltac:(discriminate) ltac:(discriminate) eq_refl eq_refl).
  discriminate.
Qed.
