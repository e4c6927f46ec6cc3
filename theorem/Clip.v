(** Around the eye: what a closed surface counts is the same in every direction, and two surfaces of
    one rim differ by a constant. *)
From Rasterproof Require Import Specification ClipSpecification Boundary Coverage Partition Shift
  Arc.
From Coq Require Import Lia.

(** ** A ray moved off all edges counts what the tie rule says *)

Definition eventually (f : Z -> Prop) : Prop := exists k, forall n, k <= n -> f n.

Lemma eventually_both f g : eventually f -> eventually g -> eventually (fun n => f n /\ g n).
Proof. intros [k F] [l G]. exists (Z.max k l). intros n N. split; [apply F|apply G]; lia. Qed.

Lemma eventually_all {A} (f : A -> Z -> Prop) l : (forall e, In e l -> eventually (f e)) ->
  eventually (fun n => Forall (fun e => f e n) l).
Proof.
  induction l as [|e l IH]; intros H; [exists 0; constructor|].
  destruct (H e) as [k K]; [left; reflexivity|].
  destruct IH as [j J]; [intros; apply H; right; assumption|].
  exists (Z.max k j). intros n N. constructor; [apply K|apply J]; lia.
Qed.

Lemma eventually_sign x y z : eventually (fun n => sign3 (n * n * x + n * y + z)
  = match sign3 x, sign3 y with Eq, Eq => sign3 z | Eq, s => s | s, _ => s end).
Proof.
  exists (1 + Z.abs y + Z.abs z). intros n N.
  assert (B : Z.abs y + Z.abs z < n) by lia. clear N.
  destruct (Z.lt_trichotomy x 0) as [X|[->|X]].
  - assert (n * (n * x + y) <= - n) by nia. assert (E : n * n * x + n * y + z < 0) by lia.
    unfold sign3. rewrite (proj2 (Z.compare_lt_iff x 0) X). exact (proj2 (Z.compare_lt_iff _ 0) E).
  - unfold sign3 at 2. cbn [Z.compare]. destruct (Z.lt_trichotomy y 0) as [Y|[->|Y]].
    + assert (E : n * n * 0 + n * y + z < 0) by nia. unfold sign3.
      rewrite (proj2 (Z.compare_lt_iff y 0) Y). exact (proj2 (Z.compare_lt_iff _ 0) E).
    + cbn. f_equal. ring.
    + assert (E : n * n * 0 + n * y + z > 0) by nia. unfold sign3.
      rewrite (proj2 (Z.compare_gt_iff y 0) ltac:(lia)). apply Z.compare_gt_iff. lia.
  - assert (n <= n * (n * x + y)) by nia. assert (E : n * n * x + n * y + z > 0) by lia.
    unfold sign3. rewrite (proj2 (Z.compare_gt_iff x 0) ltac:(lia)). apply Z.compare_gt_iff. lia.
Qed.

Definition dot3 (m p : vertex) := vx m * vx p + vy m * vy p + vw m * vw p.
Definition nudged (p : vertex) (u : point) (s : vertex) (n : Z) : vertex :=
  vertex_plus (vertex_times (n * n) p)
    (vertex_plus (vertex_times n (Vertex (px u) (py u) 0)) s).

(** Some point lies in none of finitely many planes. *)
Lemma off_planes l : Forall (fun m => m <> eye) l -> exists s, Forall (fun m => dot3 m s <> 0) l.
Proof.
  intros F. rewrite Forall_forall in F.
  destruct (eventually_all (fun m n => dot3 m (Vertex 1 n (n * n)) <> 0) l) as [k K].
  - intros m I. destruct (eventually_sign (vw m) (vy m) (vx m)) as [k K]. exists k. intros n N.
    specialize (K n N). specialize (F m I). unfold dot3; cbn [vx vy vw].
    replace (vx m * 1 + vy m * n + vw m * (n * n)) with (n * n * vw m + n * vy m + vx m) by ring.
    intros E. rewrite E in K. apply F.
    destruct (vw m) eqn:W, (vy m) eqn:Y, (vx m) eqn:X; try discriminate.
    apply vertex_ext; assumption.
  - exists (Vertex 1 k (k * k)). apply K. lia.
Qed.

Definition settled (r : tie_rule) (p q : vertex) (e : vertex * vertex) : Prop :=
  det (fst e) (snd e) q <> 0 /\ beside r (fst e) (snd e) p = (0 <? det (fst e) (snd e) q)
  \/ forall o, det (fst e) (snd e) o = 0.

Lemma det_nudged a b p u s n : det a b (nudged p u s n)
  = n * n * det a b p + n * cross (direction a b) u + det a b s.
Proof.
  unfold det, nudged, cross, direction, vertex_plus, vertex_times; cbn [vx vy vw px py]. ring.
Qed.

Lemma flat_or_direction a b p : vw p <> 0 ->
  direction a b <> origin \/ det a b p <> 0 \/ forall o, det a b o = 0.
Proof.
  intros W. destruct (point_dec (direction a b) origin) as [D|D]; [right|left; assumption].
  apply (f_equal px) in D as X. apply (f_equal py) in D as Y.
  unfold direction, origin in X, Y; cbn [px py] in X, Y.
  assert (E : forall o, det a b o = (vx a * vy b - vy a * vx b) * vw o).
  { intros o. unfold det. replace (vy a * vw b - vw a * vy b) with (- (vw a * vy b - vy a * vw b))
      by ring. rewrite X, Y. ring. }
  destruct (Z.eq_dec (vx a * vy b - vy a * vx b) 0) as [N|N].
  - right. intros o. rewrite E, N. reflexivity.
  - left. rewrite E. nia.
Qed.

Lemma settle r p edges planes : half_circle r -> vw p <> 0 -> Forall (fun m => m <> eye) planes ->
  exists q, Forall (settled r p q) edges /\ Forall (fun m => dot3 m q <> 0) planes.
Proof.
  intros H W P. destruct (off_planes planes P) as (s & S).
  destruct (half_circle_is_a_shift r (map (fun e => direction (fst e) (snd e)) edges) H)
    as (u & U & D).
  rewrite Forall_forall in S, D.
  destruct (eventually_both _ _
    (eventually_all (fun e n => settled r p (nudged p u s n) e) edges
       ltac:(intros [a b] I; specialize (D _ (in_map _ _ _ I)); cbn [fst snd] in D;
         destruct (eventually_sign (det a b p) (cross (direction a b) u) (det a b s)) as [k K];
         exists k; intros n N; specialize (K n N); unfold settled; cbn [fst snd];
         rewrite <- det_nudged in K;
         destruct (flat_or_direction a b p W) as [V|[V|V]]; [left|left|right; assumption];
         unfold beside; destruct (det a b p) as [|e|e]; simpl in K; simpl;
         [specialize (D V)|..]; try congruence;
         try (destruct (r (direction a b))); destruct (cross (direction a b) u);
         try lia; simpl in K; destruct (det a b (nudged p u s n)); try discriminate;
         split; congruence || reflexivity))
    (eventually_all (fun m n => dot3 m (nudged p u s n) <> 0) planes
       ltac:(intros m I; specialize (S m I);
         destruct (eventually_sign (dot3 m p) (dot3 m (Vertex (px u) (py u) 0)) (dot3 m s))
           as [k K];
         exists k; intros n N; specialize (K n N); intros E;
         replace (n * n * dot3 m p + n * dot3 m (Vertex (px u) (py u) 0) + dot3 m s)
           with (dot3 m (nudged p u s n)) in K
           by (unfold dot3, nudged, vertex_plus, vertex_times; cbn [vx vy vw]; ring);
         rewrite E in K;
         destruct (dot3 m p), (dot3 m (Vertex (px u) (py u) 0)), (dot3 m s);
         simpl in K; congruence))) as [k K].
  exists (nudged p u s k). apply K. lia.
Qed.

Definition both_ways (m : surface) := edges_of m ++ map opposite (edges_of m).

Lemma seen_is_count r m p q t : Forall (settled r p q) (both_ways m) -> In t m ->
  seen r t p = count_at t q.
Proof.
  intros F I. rewrite Forall_forall in F. destruct t as [a b c].
  assert (E : forall e, In e (face_edges (Face a b c)) ->
    settled r p q e /\ settled r p q (opposite e)).
  { intros e J. assert (In e (edges_of m)) by (apply in_flat_map; eexists; split; eassumption).
    split; apply F, in_or_app; [left|right; apply in_map]; assumption. }
  unfold seen, facing, shows, turned_face, count_at; cbn [vertex_a vertex_b vertex_c].
  destruct (Z.eq_dec (det a b c) 0) as [->|D]; [reflexivity|].
  assert (S : forall u v w, In (u, v) (face_edges (Face a b c)) -> det u v w <> 0 ->
    beside r u v p = is (sign3 (det u v q)) Gt /\ beside r v u p = is (sign3 (det u v q)) Lt).
  { intros u v w J N. destruct (E (u, v) J) as [[[_ X]|X] [[_ Y]|Y]]; cbn [fst snd opposite] in *;
      try (specialize (X w); congruence);
      try (specialize (Y w); rewrite det_turned in Y; lia).
    rewrite X, Y, (det_turned u v), <- sign_positive. split; [reflexivity|].
    destruct (det u v q); reflexivity. }
  destruct (S a b c) as [A1 A2]; [left; reflexivity|assumption|].
  destruct (S b c a) as [B1 B2];
    [right; left; reflexivity|rewrite (det_rotated a b c); assumption|].
  destruct (S c a b) as [C1 C2];
    [right; right; left; reflexivity|rewrite <- (det_rotated c a b); assumption|].
  rewrite A1, B1, C1, A2, B2, C2. destruct (det a b c) eqn:Z; [congruence|reflexivity|].
  simpl. repeat match goal with |- context [is ?s Lt] => destruct (is s Lt) end; reflexivity.
Qed.

(** ** The theorems *)

(** A plane through the eye and v. *)
Definition plane_of (v : vertex) : vertex :=
  if (vx v =? 0) && (vy v =? 0) then Vertex 1 0 0 else Vertex (vy v) (- vx v) 0.
Definition normal_of (v p : vertex) : vertex :=
  Vertex (vy v * vw p - vw v * vy p) (vw v * vx p - vx v * vw p) (vx v * vy p - vy v * vx p).

Lemma plane_of_spec v : plane_of v <> eye /\ dot3 (plane_of v) v = 0.
Proof.
  unfold plane_of, dot3, eye. destruct (Z.eqb_spec (vx v) 0), (Z.eqb_spec (vy v) 0);
    cbn [andb vx vy vw]; (split; [intros E; injection E; lia|lia]).
Qed.

(** A ray off a plane through v is not in line with v. *)
Lemma normal_of_spec v p : v <> eye -> dot3 (plane_of v) p <> 0 -> normal_of v p <> eye.
Proof.
  intros N P E. destruct (plane_of_spec v) as [_ V].
  assert (X : normal_of v p = eye -> forall m, dot3 m v = 0 -> dot3 m p = 0).
  { clear - N. intros E m M. injection E as E1 E2 E3. unfold dot3 in *.
    assert (H : vx v * dot3 m p = 0 /\ vy v * dot3 m p = 0 /\ vw v * dot3 m p = 0).
    { unfold dot3. repeat split.
      - transitivity (vx p * (vx m * vx v + vy m * vy v + vw m * vw v)
          + vy m * (vx v * vy p - vy v * vx p) - vw m * (vw v * vx p - vx v * vw p)); [ring|].
        rewrite M, E2, E3. ring.
      - transitivity (vy p * (vx m * vx v + vy m * vy v + vw m * vw v)
          - vx m * (vx v * vy p - vy v * vx p) + vw m * (vy v * vw p - vw v * vy p)); [ring|].
        rewrite M, E1, E3. ring.
      - transitivity (vw p * (vx m * vx v + vy m * vy v + vw m * vw v)
          + vx m * (vw v * vx p - vx v * vw p) - vy m * (vy v * vw p - vw v * vy p)); [ring|].
        rewrite M, E1, E2. ring. }
    fold (dot3 m p). destruct H as (H1 & H2 & H3). destruct (Z.eq_dec (dot3 m p) 0) as [|Q];
      [assumption|]. elim N. apply vertex_ext; unfold eye; cbn [vx vy vw]; nia. }
  apply P. exact (X E _ V).
Qed.

Definition corners (m : surface) := map fst (edges_of m).

Lemma corner_in m t v : In t m -> v = vertex_a t \/ v = vertex_b t \/ v = vertex_c t ->
  In v (corners m).
Proof.
  intros I V. unfold corners. apply in_map_iff.
  destruct V as [->|[->| ->]]; eexists (_, _); (split; [reflexivity|]); apply in_flat_map;
    exists t; (split; [assumption|]); unfold face_edges; simpl; eauto.
Qed.

Lemma corner_not_eye m v : misses_the_eye m -> In v (corners m) -> v <> eye.
Proof.
  intros A I ->. apply in_map_iff in I as ([a b] & E & I). cbn [fst] in E. subst a.
  apply in_flat_map in I as (t & I & J). unfold misses_the_eye in A. rewrite Forall_forall in A.
  apply (A t I). unfold holds_eye, face_edges in *.
  destruct J as [J|[J|[J|[]]]]; injection J as J _; rewrite J;
    [exists 1, 0, 0|exists 0, 1, 0|exists 0, 0, 1]; repeat (split; [lia|]); apply vertex_ext;
    unfold vertex_plus, vertex_times, eye; cbn [vx vy vw]; ring.
Qed.

Lemma sum_rim g m c : (forall e, g (opposite e) = - g e) -> rim m c ->
  sum g (edges_of m) = sum g c.
Proof.
  intros H (pairs & P). rewrite (sum_permutation _ _ _ P), !sum_app, sum_map.
  rewrite (sum_ext _ _ pairs (fun e _ => H e)), sum_opposite. lia.
Qed.

Lemma sum_edges g m : sum g (edges_of m) = sum (fun t => sum g (face_edges t)) m.
Proof.
  induction m as [|t m IH]; [reflexivity|]. sums. rewrite <- IH, <- sum_app. reflexivity.
Qed.

Lemma rays_apart r m p q : half_circle r -> misses_the_eye m -> vw p <> 0 -> vw q <> 0 ->
  exists p' q', forall l, incl l m ->
    seen_coverage r l p - seen_coverage r l q = sum (crosses p' q') (edges_of l).
Proof.
  intros H A P Q.
  destruct (settle r p (both_ways m) (map plane_of (corners m)) H P) as (p' & Ep & Np).
  { apply Forall_forall. intros v I. apply in_map_iff in I as (w & <- & _). apply plane_of_spec. }
  rewrite Forall_forall in Np.
  destruct (settle r q (both_ways m) (map (fun v => normal_of v p') (corners m)) H Q)
    as (q' & Eq & Nq).
  { apply Forall_forall. intros v I. apply in_map_iff in I as (w & <- & I).
    apply normal_of_spec; [exact (corner_not_eye m w A I)|apply Np, in_map; assumption]. }
  rewrite Forall_forall in Nq. exists p', q'. intros l L.
  rewrite sum_edges. unfold seen_coverage. rewrite <- sum_minus. apply sum_ext. intros t I.
  apply L in I. rewrite (seen_is_count r m p p' t Ep I), (seen_is_count r m q q' t Eq I).
  destruct t as [a b c].
  assert (C : forall e, In e (face_edges (Face a b c)) -> clear p' q' e).
  { intros e J. rewrite Forall_forall in Ep, Eq.
    assert (K : In e (both_ways m)).
    { apply in_or_app; left. apply in_flat_map; eexists; split; eassumption. }
    destruct (Ep e K) as [[X _]|X]; [|right; assumption].
    destruct (Eq e K) as [[Y _]|Y]; [left; split; assumption|right; assumption]. }
  assert (N : forall v, In v (corners m) -> det v p' q' <> 0).
  { intros v V. specialize (Nq _ (in_map _ _ _ V)). unfold normal_of, dot3 in Nq.
    cbn [vx vy vw] in Nq. exact Nq. }
  unfold misses_the_eye in A. rewrite Forall_forall in A.
  apply difference; try (apply C; simpl; tauto); try (apply N, (corner_in m _ _ I); simpl; tauto).
  exact (A _ I).
Qed.

(** Two surfaces of one rim differ by a constant. *)
Theorem same_rim_differs_by_a_constant r m n c p q : half_circle r -> misses_the_eye m ->
  misses_the_eye n -> rim m c -> rim n c -> vw p <> 0 -> vw q <> 0 ->
  seen_coverage r m p - seen_coverage r n p = seen_coverage r m q - seen_coverage r n q.
Proof.
  intros H M N Rm Rn P Q.
  destruct (rays_apart r (m ++ n) p q H) as (p' & q' & E); try assumption.
  { apply Forall_app. split; assumption. }
  pose proof (E m (incl_appl n (incl_refl m))) as X.
  pose proof (E n (incl_appr m (incl_refl n))) as Y.
  rewrite (sum_rim _ m c (crosses_opposite p' q') Rm) in X.
  rewrite (sum_rim _ n c (crosses_opposite p' q') Rn) in Y. lia.
Qed.

Theorem closed_surfaces_count_the_same r : half_circle r -> same_in_every_direction r.
Proof.
  intros H m p q M R P Q.
  pose proof (same_rim_differs_by_a_constant r m [] [] p q H M (Forall_nil _) R) as E.
  specialize (E ltac:(exists []; constructor) P Q). unfold seen_coverage in *. sums. lia.
Qed.

(** ** What is seen is what the ray meets *)

Definition meets_ray (t : face) (p : vertex) : Prop := exists i j k n,
  0 <= i /\ 0 <= j /\ 0 <= k /\ 0 < n
  /\ vertex_plus (vertex_times i (vertex_a t))
       (vertex_plus (vertex_times j (vertex_b t)) (vertex_times k (vertex_c t)))
     = vertex_times n p.
Definition within_edges (t : face) (p : vertex) : Prop := let (a, b, c) := t in
  0 <= facing t * det a b p /\ 0 <= facing t * det b c p /\ 0 <= facing t * det c a p.

(** Edges included: the tie rule only says which of two triangles takes those. *)
Theorem the_ray_meets_what_it_shows t p : facing t <> 0 -> meets_ray t p <-> within_edges t p.
Proof.
  destruct t as [a b c]. unfold meets_ray, within_edges, facing; cbn [vertex_a vertex_b vertex_c].
  intros D. split.
  - intros (i & j & k & n & I & J & K & N & E).
    assert (X : forall u v, n * det u v p = i * det u v a + j * det u v b + k * det u v c).
    { intros u v. transitivity (det u v (vertex_times n p)).
      - unfold det, vertex_times; cbn [vx vy vw]; ring.
      - rewrite <- E. unfold det, vertex_plus, vertex_times; cbn [vx vy vw]; ring. }
    pose proof (X a b) as X1. pose proof (X b c) as X2. pose proof (X c a) as X3. clear X E.
    assert (forall u v, det u v u = 0 /\ det u v v = 0) as Z0.
    { intros; split; unfold det; ring. }
    destruct (Z0 a b) as [A1 A2], (Z0 b c) as [B1 B2], (Z0 c a) as [C1 C2].
    assert (R1 : det b c a = det a b c) by (unfold det; ring).
    assert (R2 : det c a b = det a b c) by (unfold det; ring).
    rewrite A1, A2 in X1. rewrite B1, B2, R1 in X2. rewrite C1, C2, R2 in X3.
    revert X1 X2 X3 D. generalize (det a b c) (det a b p) (det b c p) (det c a p). clear - I J K N.
    intros d x y z X Y Z D.
    assert (S : forall e v, 0 <= e -> n * v = e * d -> 0 <= d * v).
    { intros e v Ge Ev. assert (n * (d * v) = e * (d * d)).
      { transitivity (d * (n * v)); [ring|rewrite Ev; ring]. }
      assert (0 <= e * (d * d)) by nia. nia. }
    repeat split; [apply (S k)|apply (S i)|apply (S j)]; lia.
  - intros (X & Y & Z).
    exists (det a b c * det b c p), (det a b c * det c a p), (det a b c * det a b p),
      (det a b c * det a b c).
    repeat (split; [nia|]). pose proof (corner_identity_3 a b c p) as E.
    apply (f_equal (vertex_times (det a b c))) in E.
    transitivity (vertex_times (det a b c) (vertex_times (det a b c) p)); [rewrite <- E|];
      apply vertex_ext; unfold vertex_plus, vertex_times; cbn [vx vy vw]; ring.
Qed.

(** The vertex that projects to a. *)
Definition ahead (k : Z) (a : point) : vertex := Vertex (k * px a) (k * py a) k.

Lemma det_ahead i j n a b p : det (ahead i a) (ahead j b) (ahead n p) = i * j * n * edge a b p.
Proof. unfold det, ahead, edge; cbn [vx vy vw]; ring. Qed.

Lemma positive_multiple k x : 0 < k -> (0 <? k * x) = (0 <? x) /\ (k * x <? 0) = (x <? 0)
  /\ (k * x =? 0) = (x =? 0).
Proof.
  intros K. repeat split;
    [destruct (Z.ltb_spec 0 (k * x)), (Z.ltb_spec 0 x)
    |destruct (Z.ltb_spec (k * x) 0), (Z.ltb_spec x 0)
    |destruct (Z.eqb_spec (k * x) 0), (Z.eqb_spec x 0)]; reflexivity || nia.
Qed.

(** Before the eye it is the coverage in the plane. *)
Theorem before_the_eye_it_is_the_plane r a b c p i j k n : half_circle r ->
  0 < i -> 0 < j -> 0 < k -> 0 < n ->
  seen r (Face (ahead i a) (ahead j b) (ahead k c)) (ahead n p) = signed r (Triangle a b c) p.
Proof.
  intros H I J K N. unfold seen, signed, facing, area, shows, covers, turned, turned_face.
  cbn [vertex_a vertex_b vertex_c corner_a corner_b corner_c]. rewrite det_ahead.
  assert (S : forall s t u v, 0 < s -> 0 < t -> edge u v p <> 0 \/ u <> v ->
    beside r (ahead s u) (ahead t v) (ahead n p) = inside r u v p).
  { intros s t u v S T D. unfold beside, inside. rewrite det_ahead.
    destruct (positive_multiple (s * t * n) (edge u v p) ltac:(nia)) as (-> & _ & ->).
    destruct (Z.eqb_spec (edge u v p) 0) as [E|E]; [|reflexivity].
    assert (V : minus v u <> origin) by (apply minus_not_origin; intuition congruence).
    rewrite <- (half_circle_by_direction r (minus v u) (s * t)) by (assumption || nia).
    do 3 f_equal. unfold direction, ahead, times, minus; cbn [vx vy vw px py]. f_equal; ring. }
  destruct (positive_multiple (i * j * k) (edge a b c) ltac:(nia)) as (-> & -> & _).
  destruct (Z.eq_dec (edge a b c) 0) as [->|D]; [reflexivity|].
  assert (a <> b) by (intros ->; apply D; unfold edge; ring).
  assert (b <> c) by (intros ->; apply D; unfold edge; ring).
  assert (c <> a) by (intros ->; apply D; unfold edge; ring).
  rewrite !S by auto. reflexivity.
Qed.

(** A closed surface before the eye counts nothing: nothing is behind it. *)
Theorem closed_surfaces_before_the_eye_cancel r m p : half_circle r -> rim m [] -> vw p <> 0 ->
  Forall (fun t => 0 < vw (vertex_a t) /\ 0 < vw (vertex_b t) /\ 0 < vw (vertex_c t)) m ->
  seen_coverage r m p = 0.
Proof.
  intros H R P F. rewrite Forall_forall in F.
  rewrite (closed_surfaces_count_the_same r H m p (Vertex 0 0 (-1))); try assumption; [| |easy].
  - transitivity (sum (fun _ : face => 0) m); [|apply sum_zero; reflexivity].
    apply sum_ext. intros [a b c] I. specialize (F _ I).
    cbn [vertex_a vertex_b vertex_c] in F. destruct F as (A & B & C).
    pose proof (corner_identity_3 a b c (Vertex 0 0 (-1))) as E. apply (f_equal vw) in E.
    unfold seen, facing, shows, turned_face, beside, vertex_plus, vertex_times in *.
    cbn [vertex_a vertex_b vertex_c vx vy vw] in *.
    rewrite (det_turned c a), (det_turned b c), (det_turned a b) in *.
    revert E. generalize (det a b c) (det a b (Vertex 0 0 (-1))) (det b c (Vertex 0 0 (-1)))
      (det c a (Vertex 0 0 (-1))). intros d x y z E.
    destruct (Z.ltb_spec 0 d), (Z.ltb_spec d 0); try reflexivity; try lia;
      destruct x, y, z; simpl; rewrite ?andb_false_r; try reflexivity; exfalso; nia.
  - apply Forall_forall. intros t I (i & j & k & X & Y & Z & S & E). specialize (F t I).
    apply (f_equal vw) in E. unfold vertex_plus, vertex_times, eye in E. cbn [vw] in E. nia.
Qed.

(** ** Cases that are evaluated *)

(** Around the eye; its faces turn to it. *)
Definition pyramid (height : Z) : surface :=
  let a := Vertex 3 0 height in let b := Vertex (-2) 2 height in let c := Vertex (-2) (-2) height in
  let d := Vertex 0 0 (-5) in
  [Face a b c; Face b a d; Face c b d; Face a c d].

Lemma not_held t : facing t <> 0 -> ~ holds_eye t.
Proof.
  destruct t as [a b c]. unfold facing, holds_eye; cbn [vertex_a vertex_b vertex_c].
  intros D (i & j & k & I & J & K & S & E).
  assert (X : forall u v, i * det u v a + j * det u v b + k * det u v c = 0).
  { intros u v. transitivity (det u v eye); [|unfold det, eye; cbn [vx vy vw]; ring].
    rewrite <- E. unfold det, vertex_plus, vertex_times; cbn [vx vy vw]; ring. }
  pose proof (X b c) as X1. pose proof (X c a) as X2. pose proof (X a b) as X3.
  assert (Z0 : forall u v, det u v u = 0 /\ det u v v = 0) by (intros; split; unfold det; ring).
  destruct (Z0 a b) as [A1 A2], (Z0 b c) as [B1 B2], (Z0 c a) as [C1 C2].
  assert (R1 : det b c a = det a b c) by (unfold det; ring).
  assert (R2 : det c a b = det a b c) by (unfold det; ring).
  rewrite A1, A2 in X3. rewrite B1, B2, R1 in X1. rewrite C1, C2, R2 in X2. nia.
Qed.

Lemma pyramid_is_closed height : rim (pyramid height) [].
Proof.
  pose (a := Vertex 3 0 height). pose (b := Vertex (-2) 2 height).
  pose (c := Vertex (-2) (-2) height). pose (d := Vertex 0 0 (-5)).
  exists [(a, b); (b, c); (c, a); (a, d); (d, b); (d, c)]. unfold a, b, c, d. cbn. permutation.
Qed.

Definition some_rays : list vertex :=
  [Vertex 0 0 1; Vertex 1 0 1; Vertex 3 0 4; Vertex 7 5 1; Vertex (-1) 0 2; Vertex 0 0 (-1)].

Example pyramid_is_a_case : misses_the_eye (pyramid 4) /\ rim (pyramid 4) []
  /\ map (seen_coverage top_left (pyramid 4)) some_rays = [1; 1; 1; 1; 1; 1].
Proof.
  split; [|split; [apply pyramid_is_closed|vm_compute; reflexivity]].
  repeat constructor; apply not_held; vm_compute; discriminate.
Qed.

(** Its base counts where the rest does not, a corner of it included. *)
Example pyramid_without_its_base : map (seen_coverage top_left (tl (pyramid 4))) some_rays
  = [0; 1; 1; 1; 0; 1] /\ map (seen_coverage top_left [hd (Face eye eye eye) (pyramid 4)])
  some_rays = [1; 0; 0; 0; 1; 0].
Proof. split; vm_compute; reflexivity. Qed.

(** With the eye on a face the sides see it, and their opposites do not. *)
Theorem the_eye_must_not_lie_on_the_surface : ~ (forall m p q, rim m [] -> vw p <> 0 -> vw q <> 0 ->
  seen_coverage top_left m p = seen_coverage top_left m q).
Proof.
  intros H. specialize (H (pyramid 0) (Vertex 0 0 1) (Vertex 0 0 (-1)) (pyramid_is_closed 0)).
  vm_compute in H. assert (0 = 1) by (apply H; discriminate). discriminate.
Qed.
