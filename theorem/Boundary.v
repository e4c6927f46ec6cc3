(** Every triangle covers, signed, what its boundary says: for any half-circle,
    flat triangles included.

    [turn r p a b] is what the edge a b adds where the ray from p goes in the direction in which [r]
    shifts the sample. The winding number follows in Winding.v. *)
From Rasterproof Require Import Specification.
From Coq Require Import Lia Btauto.

Lemma sum_cons {A} (f : A -> Z) e l : sum f (e :: l) = f e + sum f l.
Proof. reflexivity. Qed.

Lemma sum_nil {A} (f : A -> Z) : sum f [] = 0.
Proof. reflexivity. Qed.

Global Opaque sum.
Ltac sums := repeat rewrite ?sum_cons, ?sum_nil in *.
Ltac by_list l := induction l; simpl app; simpl map; sums; lia.

Lemma sum_app {A} (f : A -> Z) l m : sum f (l ++ m) = sum f l + sum f m.
Proof. by_list l. Qed.

Lemma sum_permutation {A} (f : A -> Z) l m : Permutation l m -> sum f l = sum f m.
Proof. induction 1; sums; lia. Qed.

Lemma sum_map {A B} (f : B -> Z) (g : A -> B) l : sum f (map g l) = sum (fun e => f (g e)) l.
Proof. by_list l. Qed.

Lemma sum_ext {A} (f g : A -> Z) l : (forall e, In e l -> f e = g e) -> sum f l = sum g l.
Proof. induction l; intros H; sums; [lia|]. rewrite H, IHl; firstorder. Qed.

Lemma sum_minus {A} (f g : A -> Z) l : sum (fun e => f e - g e) l = sum f l - sum g l.
Proof. by_list l. Qed.

Lemma sum_opposite {A} (f : A -> Z) l : sum (fun e => - f e) l = - sum f l.
Proof. by_list l. Qed.

Lemma sum_zero {A} (f : A -> Z) l : (forall e, f e = 0) -> sum f l = 0.
Proof. intros H. induction l; sums; rewrite ?H; lia. Qed.

(** What changes its sign with an edge cannot tell a boundary from an outline. *)
Lemma sum_outline g m c : (forall e, g (reverse e) = - g e) -> outline m c ->
  sum g (boundary m) = sum g c.
Proof.
  intros H (pairs & P). rewrite (sum_permutation _ _ _ P), !sum_app, sum_map.
  rewrite (sum_ext _ _ pairs (fun e _ => H e)), sum_opposite. lia.
Qed.

Lemma sum_boundary g m : sum g (boundary m) = sum (fun t => sum g (triangle_boundary t)) m.
Proof.
  induction m as [|t m IH]; [reflexivity|]. sums. rewrite <- IH, <- sum_app. reflexivity.
Qed.

(** An outline is closed: what is a difference of its ends adds up to nothing. *)
Lemma outline_closed (f : point -> Z) m c : outline m c -> sum (fun e => f (snd e) - f (fst e)) c
  = 0.
Proof.
  intros H. rewrite <- (sum_outline _ m c); [|intros []; simpl; lia|assumption].
  rewrite sum_boundary. apply sum_zero. intros []. unfold triangle_boundary; simpl. sums. simpl.
  lia.
Qed.

(** ** Points *)

Lemma point_ext a b : px a = px b -> py a = py b -> a = b.
Proof. destruct a, b; simpl; intros; subst; reflexivity. Qed.

Lemma point_dec (a b : point) : {a = b} + {a <> b}.
Proof. decide equality; apply Z.eq_dec. Qed.

Ltac points := apply point_ext; unfold plus, minus, times, origin; cbn [px py]; lia.

Lemma minus_not_origin a p : a <> p -> minus a p <> origin.
Proof.
  intros N E. apply N, point_ext; [apply (f_equal px) in E|apply (f_equal py) in E];
    unfold minus, origin in E; cbn [px py] in E; lia.
Qed.

Lemma area_identity a b c p : edge a b p + edge b c p + edge c a p = edge a b c.
Proof. unfold edge; ring. Qed.

(** The identity that everything rests on. *)
Lemma corner_identity a b c p :
  plus (times (edge a b p) (minus c p)) (plus (times (edge b c p) (minus a p))
    (times (edge c a p) (minus b p))) = origin.
Proof. unfold edge, plus, times, minus, origin; simpl; f_equal; ring. Qed.

Lemma edge_turned a b p : edge b a p = - edge a b p.
Proof. unfold edge; ring. Qed.

(** ** A half-circle that owns no edge of length zero *)

Definition half_circle_0 r := half_circle r /\ r origin = false.

Section Half_circle.
Variable r : tie_rule.
Hypothesis half : half_circle_0 r.

Lemma owned_not_origin d : r d = true -> d <> origin.
Proof. pose proof (proj2 half) as O. intros H ->. congruence. Qed.

Lemma owned_plus d e : r d = true -> r e = true -> r (plus d e) = true.
Proof. destruct half as [[_ S] _]. intros. apply S; auto using owned_not_origin. Qed.

Lemma owned_opposite d : d <> origin -> r (times (-1) d) = negb (r d).
Proof. destruct half as [[S _] _]. apply S. Qed.

Lemma owned_not_opposite d : r d = true -> r (times (-1) d) = true -> False.
Proof. intros H. rewrite owned_opposite, H by auto using owned_not_origin. discriminate. Qed.

Lemma owned_times k d : 0 < k -> r d = true -> r (times k d) = true.
Proof.
  intros K H. replace k with (Z.of_nat (S (Z.to_nat (k - 1)))) by lia.
  induction (Z.to_nat (k - 1)) as [|n IH].
  - change (Z.of_nat 1) with 1. replace (times 1 d) with d by points. assumption.
  - replace (times (Z.of_nat (S (S n))) d) with (plus (times (Z.of_nat (S n)) d) d);
    [apply owned_plus; assumption|].
    rewrite (Nat2Z.inj_succ (S n)). apply point_ext; unfold plus, times, Z.succ; cbn [px py]; ring.
Qed.

(** Three owned directions do not add up to nothing, in whatever lengths. *)
Lemma owned_combination i j k u v w : r u = true -> r v = true -> r w = true ->
  0 <= i -> 0 <= j -> 0 <= k -> 0 < i + j + k ->
  plus (times i u) (plus (times j v) (times k w)) = origin -> False.
Proof.
  intros U V W I J K S E. pose proof (proj2 half) as O.
  assert (D : forall n d, 0 <= n -> r d = true -> n = 0 \/ 0 < n /\ r (times n d) = true).
  { intros n d N R. destruct (Z.eq_dec n 0); [left|right; split; [|apply owned_times]]; auto; lia. }
  assert (Z0 : forall d, times 0 d = origin) by (intros; points).
  assert (P0 : forall d, plus origin d = d) by (intros; points).
  assert (P1 : forall d, plus d origin = d) by (intros; points).
  destruct (D i u I U) as [->|[? Ri]], (D j v J V) as [->|[? Rj]], (D k w K W) as [->|[? Rk]];
    rewrite ?Z0, ?P0, ?P1 in E; try lia;
    match type of E with ?x = _ => assert (r x = true) by auto using owned_plus; congruence end.
Qed.

(** Which side of the line through p a corner lies on; p itself counts with the side not owned. *)
Definition side (p a : point) : bool := r (minus a p).

Definition turn (p : point) (e : directed) : Z :=
  let (a, b) := e in
  if negb (side p a) && side p b && (0 <=? edge a b p) then 1
  else if side p a && negb (side p b) && (edge a b p <=? 0) then -1
  else 0.

Lemma turn_reverse p e : turn p (reverse e) = - turn p e.
Proof.
  destruct e as [a b]. unfold turn, reverse; simpl. rewrite (edge_turned a b).
  destruct (side p a), (side p b); simpl; try reflexivity;
    destruct (Z.leb_spec 0 (- edge a b p)), (Z.leb_spec (edge a b p) 0),
      (Z.leb_spec 0 (edge a b p)), (Z.leb_spec (- edge a b p) 0); lia.
Qed.

Lemma side_opposite p a : a <> p -> side p a = false -> r (minus p a) = true.
Proof.
  intros N S. replace (minus p a) with (times (-1) (minus a p)) by points.
  unfold side in S. rewrite owned_opposite, S; auto using minus_not_origin.
Qed.

(** An edge that goes from one side to the other is owned as it goes. *)
Lemma side_up p a b : side p a = false -> side p b = true -> r (minus b a) = true.
Proof.
  intros A B. destruct (point_dec a p) as [->|N]; [exact B|].
  replace (minus b a) with (plus (minus b p) (minus p a)) by points.
  apply owned_plus; [exact B|]. apply side_opposite; assumption.
Qed.

Lemma side_down p a b : side p a = true -> side p b = false -> r (minus b a) = false.
Proof.
  intros A B. destruct (r (minus b a)) eqn:E; [|reflexivity]. exfalso.
  apply (owned_not_opposite (minus b a)); [assumption|].
  replace (times (-1) (minus b a)) with (minus a b) by points. eapply side_up; eassumption.
Qed.

Definition sign (s : bool) : Z := if s then 1 else -1.

Lemma owned_side p a : a <> p -> r (times (sign (side p a)) (minus a p)) = true.
Proof.
  intros N. destruct (side p a) eqn:S; simpl.
  - replace (times 1 (minus a p)) with (minus a p) by points. exact S.
  - replace (times (-1) (minus a p)) with (minus p a) by points. apply side_opposite; assumption.
Qed.

(** The signs of the three edge values, each taken with the side of the corner across. *)
Lemma corner_signs p a b c k : a <> p -> b <> p -> c <> p -> k = 1 \/ k = -1 ->
  0 <= k * (sign (side p c) * edge a b p) -> 0 <= k * (sign (side p a) * edge b c p) ->
  0 <= k * (sign (side p b) * edge c a p) ->
  sign (side p c) * edge a b p = 0 /\ sign (side p a) * edge b c p = 0
    /\ sign (side p b) * edge c a p = 0.
Proof.
  intros A B C K I J L.
  assert (S : forall s, sign s * sign s = 1) by (intros []; reflexivity).
  destruct (Z.eq_dec (k * (sign (side p c) * edge a b p) + k * (sign (side p a) * edge b c p)
    + k * (sign (side p b) * edge c a p)) 0) as [Z|N]; [destruct K; subst; lia|exfalso].
  eapply (owned_combination _ _ _ _ _ _ (owned_side p c C) (owned_side p a A) (owned_side p b B) I
    J L);
    [lia|].
  pose proof (corner_identity a b c p) as E.
  apply (f_equal px) in E as X. apply (f_equal py) in E as Y. unfold plus, times, minus,
    origin in *.
  cbn [px py] in *. pose proof (S (side p a)). pose proof (S (side p b)). pose proof (S (side p c)).
  f_equal.
  - transitivity (k * (sign (side p c) * sign (side p c)) * (edge a b p * (px c - px p))
      + k * (sign (side p a) * sign (side p a)) * (edge b c p * (px a - px p))
      + k * (sign (side p b) * sign (side p b)) * (edge c a p * (px b - px p))); [ring|].
    rewrite !S. lia.
  - transitivity (k * (sign (side p c) * sign (side p c)) * (edge a b p * (py c - py p))
      + k * (sign (side p a) * sign (side p a)) * (edge b c p * (py a - py p))
      + k * (sign (side p b) * sign (side p b)) * (edge c a p * (py b - py p))); [ring|].
    rewrite !S. lia.
Qed.

Definition turns p a b c := turn p (a, b) + turn p (b, c) + turn p (c, a).

Lemma signed_rotated a b c p : signed r (Triangle b c a) p = signed r (Triangle a b c) p.
Proof.
  unfold signed, area, turned, covers; simpl.
  replace (edge b c a) with (edge a b c) by (unfold edge; ring).
  destruct (0 <? edge a b c), (edge a b c <? 0); try reflexivity;
    repeat match goal with |- context [inside ?s ?u ?v ?q] => destruct (inside s u v q) end;
      reflexivity.
Qed.

Lemma turns_rotated a b c p : turns p b c a = turns p a b c.
Proof. unfold turns; lia. Qed.

Ltac cases :=
  repeat match goal with
  | |- context [?x <? ?y] => destruct (Z.ltb_spec x y)
  | |- context [?x <=? ?y] => destruct (Z.leb_spec x y)
  | |- context [?x =? ?y] => destruct (Z.eqb_spec x y)
  end.

Lemma turns_at_corner b c p : signed r (Triangle p b c) p = turns p p b c.
Proof.
  assert (O : side p p = false).
  { unfold side. replace (minus p p) with origin by points. apply half. }
  assert (U : forall a, a <> p -> r (minus p a) = negb (side p a)).
  { intros a N. unfold side. replace (minus p a) with (times (-1) (minus a p)) by points.
    apply owned_opposite, minus_not_origin, N. }
  assert (E1 : edge p b p = 0) by (unfold edge; ring).
  assert (E2 : edge c p p = 0) by (unfold edge; ring).
  assert (E3 : edge b p p = 0) by (unfold edge; ring).
  assert (E4 : edge p c p = 0) by (unfold edge; ring).
  assert (E5 : edge p b c = edge b c p) by (unfold edge; ring).
  unfold signed, area, turned, covers, inside, turns, turn; simpl.
  rewrite E1, E2, E3, E4, E5, O, (edge_turned b c); simpl.
  assert (B : b = p \/ b <> p) by (destruct (point_dec b p); auto).
  assert (C : c = p \/ c <> p) by (destruct (point_dec c p); auto).
  destruct B as [->|B].
  { rewrite E4, O. simpl. destruct (side p c); reflexivity. }
  destruct C as [->|C].
  { rewrite E3, O. simpl. destruct (side p b); reflexivity. }
  rewrite !U by assumption. fold (side p b) (side p c).
  destruct (side p b), (side p c); simpl; cases; simpl; lia.
Qed.

Lemma signed_turned t p : signed r (turned t) p = - signed r t p.
Proof.
  destruct t as [a b c]. unfold signed, area, turned; cbn [corner_a corner_b corner_c].
  replace (edge a c b) with (- edge a b c) by (unfold edge; ring). cases; lia.
Qed.

Lemma turns_turned p a b c : turns p a c b = - turns p a b c.
Proof.
  unfold turns. pose proof (turn_reverse p (a, b)) as E. pose proof (turn_reverse p (b, c)) as F.
  pose proof (turn_reverse p (c, a)) as G. unfold reverse in *; cbn [fst snd] in *. lia.
Qed.

Lemma signed_is_turns p a b c : 0 <= edge a b c -> signed r (Triangle a b c) p = turns p a b c.
Proof.
  intros Area. destruct (point_dec a p) as [->|A]; [apply turns_at_corner|].
  destruct (point_dec b p) as [->|B].
  { rewrite <- signed_rotated, <- turns_rotated. apply turns_at_corner. }
  destruct (point_dec c p) as [->|C].
  { rewrite <- signed_rotated, <- turns_rotated, <- signed_rotated, <- turns_rotated.
    apply turns_at_corner. }
  pose proof (corner_signs p a b c 1 A B C (or_introl eq_refl)) as P.
  pose proof (corner_signs p a b c (-1) A B C (or_intror eq_refl)) as N.
  pose proof (area_identity a b c p) as S.
  pose proof (side_up p a b) as Uab. pose proof (side_down p a b) as Dab.
  pose proof (side_up p b c) as Ubc. pose proof (side_down p b c) as Dbc.
  pose proof (side_up p c a) as Uca. pose proof (side_down p c a) as Dca.
  unfold signed, area, covers, inside, turns, turn; cbn [corner_a corner_b corner_c].
  replace (edge a b c <? 0) with false by (symmetry; apply Z.ltb_ge; assumption).
  set (x := edge a b p) in *. set (y := edge b c p) in *. set (z := edge c a p) in *.
  set (w := edge a b c) in *. clearbody x y z w.
  destruct (side p a), (side p b), (side p c); cbn [sign] in *;
    try rewrite Uab by reflexivity; try rewrite Dab by reflexivity;
    try rewrite Ubc by reflexivity; try rewrite Dbc by reflexivity;
    try rewrite Uca by reflexivity; try rewrite Dca by reflexivity;
    clear Uab Dab Ubc Dbc Uca Dca; rewrite !Z.mul_1_l in P;
    rewrite ?Z.mul_1_l, ?Z.opp_involutive in *;
    destruct w, x, y, z; simpl; rewrite ?andb_false_r; try reflexivity;
    exfalso; clear A B C; lia.
Qed.

(** The theorem of this file. *)
Theorem triangle_is_its_boundary t p : signed r t p = sum (turn p) (triangle_boundary t).
Proof.
  destruct t as [a b c].
  transitivity (turns p a b c).
  2: { unfold turns, triangle_boundary; cbn [corner_a corner_b corner_c]. sums. lia. }
  destruct (Z.leb_spec 0 (edge a b c)); [apply signed_is_turns; assumption|].
  apply Z.opp_inj. rewrite <- signed_turned, <- turns_turned. apply signed_is_turns.
  replace (edge a c b) with (- edge a b c) by (unfold edge; ring). lia.
Qed.

End Half_circle.
