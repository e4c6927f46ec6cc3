(** The main theorem: a tie rule by direction partitions every mesh if and only if it is a
    half-circle. *)
From Rasterproof Require Import Specification Boundary Winding Coverage.
From Coq Require Import Lia.

Definition cross (d e : point) := px d * py e - py d * px e.
Definition dot (d e : point) := px d * px e + py d * py e.

Lemma cons_permutation {A} (x : A) l m n : List.Add x m n -> Permutation l m -> Permutation (x ::
  l) n.
Proof. intros D P. rewrite P. apply Permutation_Add; assumption. Qed.

Ltac find := solve [apply Add_head | apply Add_cons; find].
Ltac permutation := repeat (eapply cons_permutation; [find|]); apply perm_nil.

Lemma nonzero d : d <> origin -> 0 < dot d d.
Proof.
  intros N. unfold dot. assert (px d <> 0 \/ py d <> 0); [|nia].
  destruct (Z.eq_dec (px d) 0), (Z.eq_dec (py d) 0); auto. elim N. apply point_ext; assumption.
Qed.

Lemma inside_tie r a b p : edge a b p = 0 -> inside r a b p = r (minus b a).
Proof. intros E. unfold inside. rewrite E. reflexivity. Qed.

Lemma inside_strictly r a b p : 0 < edge a b p -> inside r a b p = true.
Proof. intros E. unfold inside. rewrite (proj2 (Z.ltb_lt _ _) E). reflexivity. Qed.

Lemma off_edges c p : Forall (fun e => edge (fst e) (snd e) p <> 0) c -> off c p.
Proof. apply Forall_impl. intros e N [E _]. contradiction. Qed.

(** Decides a comparison that follows from what is known. *)
Ltac settle :=
  match goal with
  | |- context [?x <=? ?y] => first
      [rewrite (proj2 (Z.leb_le x y)) by lia | rewrite (proj2 (Z.leb_gt x y)) by lia]
  | |- context [?x <? ?y] => first
      [rewrite (proj2 (Z.ltb_lt x y)) by lia | rewrite (proj2 (Z.ltb_ge x y)) by lia]
  end.

Section Necessity.
Variable r : tie_rule.
Hypothesis direction : by_direction r.
Hypothesis parts : partitions r.

(** Two triangles on either side of an edge through the sample. *)
Lemma opposite_of_partition d : d <> origin -> r (times (-1) d) = negb (r d).
Proof.
  intros N. apply nonzero in N. destruct d as [x y]. unfold dot in N; cbn [px py] in N.
  set (d := Point x y). set (e := Point (-x) (-y)). set (f := Point (-y) x).
  set (g := Point y (-x)).
  assert (S : edge e d f = 2 * (x * x + y * y) /\ edge d e g = 2 * (x * x + y * y)
    /\ edge d f origin = x * x + y * y /\ edge f e origin = x * x + y * y
    /\ edge e g origin = x * x + y * y /\ edge g d origin = x * x + y * y
    /\ edge e d origin = 0 /\ edge d e origin = 0).
  { unfold edge, d, e, f, g, origin; cbn [px py]. repeat split; ring. }
  destruct S as (S1 & S2 & S3 & S4 & S5 & S6 & S7 & S8).
  assert (P : owners r [Triangle e d f; Triangle d e g] origin = 1).
  { apply parts with (c := [(d, f); (f, e); (e, g); (g, d)]).
    - repeat constructor; unfold area; cbn [corner_a corner_b corner_c]; lia.
    - exists [(e, d)]. cbn. permutation.
    - apply off_edges. repeat constructor; cbn [fst snd]; lia.
    - unfold winding. sums. unfold crossing. rewrite S3, S4, S5, S6.
      unfold d, e, f, g, origin; cbn [px py]. assert (x <> 0 \/ y <> 0) by nia.
      clear - H N. decide_all; simpl; lia. }
  unfold owners in P. sums. unfold covers in P; cbn [corner_a corner_b corner_c] in P.
  rewrite (inside_tie r e d), (inside_tie r d e), (inside_strictly r d f), (inside_strictly r f e),
    (inside_strictly r e g), (inside_strictly r g d) in P by lia.
  replace (minus d e) with (times 2 d) in P by (unfold d, e; points).
  replace (minus e d) with (times 2 e) in P by (unfold d, e; points).
  rewrite !direction in P by lia.
  replace (times (-1) d) with e by (unfold d, e; points).
  destruct (r d), (r e); simpl in P; lia || reflexivity.
Qed.

(** Six triangles around the sample. *)
Lemma hexagon d e : 0 < cross d e -> r d = true -> r e = true -> r (plus d e) = true.
Proof.
  intros C D E. destruct (r (plus d e)) eqn:F; [reflexivity|exfalso].
  set (u := times (-1) d). set (v := times (-1) (plus d e)). set (w := times (-1) e).
  set (f := plus d e) in *.
  assert (S : edge origin d f = cross d e /\ edge origin f e = cross d e /\ edge origin e u =
    cross d e
    /\ edge origin u v = cross d e /\ edge origin v w = cross d e /\ edge origin w d = cross d e).
  { unfold edge, cross, u, v, w, f, plus, times, origin; cbn [px py]. repeat split; ring. }
  destruct S as (S1 & S2 & S3 & S4 & S5 & S6).
  assert (T : forall a b, edge a b origin = edge origin a b) by (intros; unfold edge, origin;
    cbn [px py]; ring).
  assert (P : owners r [Triangle origin d f; Triangle origin f e; Triangle origin e u;
    Triangle origin u v; Triangle origin v w; Triangle origin w d] origin = 1).
  { apply parts with (c := [(d, f); (f, e); (e, u); (u, v); (v, w); (w, d)]).
    - repeat constructor; unfold area; cbn [corner_a corner_b corner_c]; lia.
    - exists [(origin, d); (origin, f); (origin, e); (origin, u); (origin, v); (origin, w)].
      cbn [boundary flat_map triangle_boundary app corner_a corner_b corner_c map reverse fst snd].
      permutation.
    - apply off_edges. repeat constructor; cbn [fst snd]; rewrite T; lia.
    - unfold winding. sums. unfold crossing. rewrite !T, S1, S2, S3, S4, S5, S6.
      assert (Y : py d <> 0 \/ py e <> 0) by (unfold cross in C; nia).
      unfold u, v, w, f, plus, times, origin; cbn [px py].
      rewrite (proj2 (Z.ltb_lt 0 (cross d e)) C), (proj2 (Z.ltb_ge (cross d e) 0)) by lia.
      clear - Y.
      destruct (Z.lt_trichotomy (py d) 0) as [|[|]], (Z.lt_trichotomy (py e) 0) as [|[|]],
        (Z.lt_trichotomy (py d + py e) 0) as [|[|]]; try lia; repeat settle; reflexivity. }
  assert (O : forall a, a <> origin -> r (minus origin a) = negb (r a)).
  { intros a N. rewrite <- opposite_of_partition by assumption. f_equal; points. }
  assert (M : forall a, r (minus a origin) = r a) by (intros; f_equal; points).
  assert (Nd : d <> origin) by (intros ->; unfold cross, origin in C; cbn in C; lia).
  assert (Nf : f <> origin).
  { intros Z. assert (X : cross d f = cross d e) by (unfold cross, f, plus; cbn [px py]; ring).
    rewrite Z in X. unfold cross, origin in *; cbn [px py] in *; lia. }
  assert (U : r (minus origin u) = true).
  { replace (minus origin u) with d by (unfold u; points). assumption. }
  assert (Tie : forall a, edge origin a origin = 0 /\ edge a origin origin = 0).
  { intros. unfold edge, origin; cbn [px py]; split; ring. }
  unfold owners in P. sums. unfold covers in P; cbn [corner_a corner_b corner_c] in P.
  rewrite (inside_tie r origin d), (inside_tie r f origin), (inside_tie r origin e),
    (inside_tie r u origin) in P by apply Tie.
  rewrite (inside_strictly r d f), (inside_strictly r e u) in P by (rewrite T; lia).
  rewrite U, !M, (O f Nf), D, E, F in P. simpl in P.
  repeat match type of P with context [Z.b2z ?b] => destruct b; simpl in P end; lia.
Qed.

Lemma plus_of_partition d e : d <> origin -> e <> origin -> r d = true -> r e = true ->
  r (plus d e) = true.
Proof.
  intros N M D E. destruct (Z.lt_trichotomy (cross d e) 0) as [L|[Z|G]].
  - replace (plus d e) with (plus e d) by points. apply hexagon; auto. unfold cross in *; lia.
  - pose proof (nonzero d N) as S. pose proof (nonzero e M) as R.
    assert (X : times (dot d d) e = times (dot d e) d).
    { unfold cross, dot, times in *; apply point_ext; cbn [px py];
        [transitivity (px d * (px d * px e) + py d * (py d * px e)); [ring|];
         replace (py d * px e) with (px d * py e) by lia; ring
        |transitivity (px d * (px d * py e) + py d * (py d * py e)); [ring|];
         replace (px d * py e) with (py d * px e) by lia; ring]. }
    destruct (Z.lt_trichotomy (dot d e) 0) as [L|[Y|G]].
    + exfalso. assert (B : times (dot d d) e = times (- dot d e) (times (-1) d)).
      { rewrite X. unfold times; cbn [px py]. f_equal; ring. }
      rewrite <- (direction (dot d d) e), B, direction, opposite_of_partition, D in E; lia || auto.
    + exfalso. rewrite Y in X. apply M.
      apply point_ext; [apply (f_equal px) in X|apply (f_equal py) in X];
        unfold times, origin in *; cbn [px py] in *; nia.
    + rewrite <- (direction (dot d d) (plus d e)) by assumption.
      replace (times (dot d d) (plus d e)) with (times (dot d d + dot d e) d).
      { rewrite direction by lia. assumption. }
      apply (f_equal px) in X as X1. apply (f_equal py) in X as X2.
      unfold times, plus in *; cbn [px py] in *. f_equal; lia.
  - apply hexagon; assumption.
Qed.

Lemma partition_is_half_circle : half_circle r.
Proof. split; auto using opposite_of_partition, plus_of_partition. Qed.

End Necessity.

Theorem main r : by_direction r -> (partitions r <-> half_circle r).
Proof. intros D. split; [apply partition_is_half_circle; assumption|apply half_circle_partitions].
Qed.

(** That a rule is by direction need not be asked of a half-circle. *)
Theorem half_circle_by_direction r d k : half_circle r -> 0 < k -> d <> origin ->
  r (times k d) = r d.
Proof.
  intros H K N. pose proof (normal_half r H) as M.
  assert (Q : forall e, e <> origin -> times k e <> origin).
  { intros e E Z. apply E. apply point_ext; [apply (f_equal px) in Z|apply (f_equal py) in Z];
      unfold times, origin in *; cbn [px py] in *; nia. }
  assert (T : forall e, e <> origin -> r e = true -> r (times k e) = true).
  { intros e E R. rewrite <- normal_same in * by auto. apply owned_times; assumption. }
  destruct (r d) eqn:R; [auto|].
  assert (O : times (-1) d <> origin).
  { intros Z. apply N. apply point_ext; [apply (f_equal px) in Z|apply (f_equal py) in Z];
      unfold times, origin in *; cbn [px py] in *; lia. }
  specialize (T (times (-1) d) O). rewrite (proj1 H), R in T by assumption. specialize (T eq_refl).
  replace (times k (times (-1) d)) with (times (-1) (times k d)) in T.
  - rewrite (proj1 H) in T by auto. destruct (r (times k d)); [discriminate|reflexivity].
  - unfold times; cbn [px py]; f_equal; ring.
Qed.

(** A half-circle is an order of the plane that a translation does not change: of two points one is
    before the other, and what is before something before a third is before the third. *)
Theorem half_circle_is_an_order r : half_circle r <->
  (forall a b, a <> b -> r (minus a b) = negb (r (minus b a)))
  /\ (forall a b c, a <> b -> b <> c -> r (minus b a) = true -> r (minus c b) = true ->
      r (minus c a) = true).
Proof.
  split; intros [O S]; split.
  - intros a b N. rewrite <- O by (apply minus_not_origin; congruence). f_equal; points.
  - intros a b c N M A B. replace (minus c a) with (plus (minus b a) (minus c b)) by points.
    apply S; auto; apply minus_not_origin; congruence.
  - intros d N. specialize (O origin d (not_eq_sym N)).
    replace (minus origin d) with (times (-1) d) in O by points.
    replace (minus d origin) with d in O by points. assumption.
  - intros d e N M D E. replace (plus d e) with (minus e (times (-1) d)) by points.
    apply (S _ origin).
    + intros Z. apply N. apply point_ext; [apply (f_equal px) in Z|apply (f_equal py) in Z];
        unfold times, origin in *; cbn [px py] in *; lia.
    + congruence.
    + replace (minus origin (times (-1) d)) with d by points. assumption.
    + replace (minus e origin) with e by points. assumption.
Qed.
