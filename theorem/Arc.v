(** Between two rays that lie on no edge, what a triangle counts changes by the edges that cross the
    arc between them. Ten signs decide it, and a table of all of them, computed, does what cases
    would. *)
From Rasterproof Require Import Specification ClipSpecification Boundary.
From Coq Require Import Lia.

Lemma vertex_ext a b : vx a = vx b -> vy a = vy b -> vw a = vw b -> a = b.
Proof. destruct a, b; simpl; intros; subst; reflexivity. Qed.

Lemma corner_identity_3 a b c p :
  vertex_plus (vertex_times (det b c p) a)
    (vertex_plus (vertex_times (det c a p) b) (vertex_times (det a b p) c))
  = vertex_times (det a b c) p.
Proof. unfold vertex_plus, vertex_times, det; cbn [vx vy vw]. f_equal; ring. Qed.

Lemma det_turned a b p : det b a p = - det a b p.
Proof. unfold det; ring. Qed.

Lemma det_rotated a b p : det b p a = det a b p.
Proof. unfold det; ring. Qed.

(** ** Signs *)

Definition sign3 (x : Z) : comparison := x ?= 0.
Definition product (s t : comparison) : comparison :=
  match s, t with Eq, _ | _, Eq => Eq | Lt, Lt | Gt, Gt => Gt | _, _ => Lt end.
Definition is (s t : comparison) : bool :=
  match s, t with Lt, Lt | Eq, Eq | Gt, Gt => true | _, _ => false end.
(** Whether three numbers of these signs can add up to nothing. *)
Definition balanced (s t u : comparison) : bool :=
  is s Eq && is t Eq && is u Eq
  || (is s Lt || is t Lt || is u Lt) && (is s Gt || is t Gt || is u Gt).

Ltac by_sign := unfold sign3; repeat match goal with
  |- context [?x ?= 0] => destruct (Z.compare_spec x 0) end; subst; simpl; try reflexivity; try nia.

Lemma sign_product x y : sign3 (x * y) = product (sign3 x) (sign3 y).
Proof. destruct x, y; reflexivity. Qed.

Lemma sign_opposite x : sign3 (- x) = CompOpp (sign3 x).
Proof. destruct x; reflexivity. Qed.

Lemma sign_balanced x y z : x + y + z = 0 -> balanced (sign3 x) (sign3 y) (sign3 z) = true.
Proof. intros. by_sign. Qed.

Lemma sign_positive x : (0 <? x) = is (sign3 x) Gt.
Proof. destruct x; reflexivity. Qed.

(** What a triangle counts, by the signs of its determinant and of its edges at a ray. *)
Definition count (d x y z : comparison) : Z :=
  match d with
  | Gt => Z.b2z (is x Gt && is y Gt && is z Gt)
  | Lt => - Z.b2z (is x Lt && is y Lt && is z Lt)
  | Eq => 0
  end.

(** What an edge adds that crosses the arc from q to p: by its signs at p and q, and the sides of
    the arc that its ends lie on. *)
Definition cross_by (x y s t : comparison) : Z :=
  match x, y, s, t with Gt, Lt, Lt, Gt => 1 | Lt, Gt, Gt, Lt => -1 | _, _, _, _ => 0 end.
Definition crosses (p q : vertex) (e : vertex * vertex) : Z :=
  let (a, b) := e in
  cross_by (sign3 (det a b p)) (sign3 (det a b q)) (sign3 (det a p q)) (sign3 (det b p q)).

Lemma crosses_opposite p q e : crosses p q (opposite e) = - crosses p q e.
Proof.
  destruct e as [a b]. unfold crosses, opposite; cbn [fst snd].
  rewrite (det_turned a b p), (det_turned a b q), !sign_opposite.
  destruct (sign3 (det a b p)), (sign3 (det a b q)), (sign3 (det a p q)), (sign3 (det b p q));
    reflexivity.
Qed.

Definition possible (d x y z x' y' z' s t u : comparison) : bool :=
  Bool.eqb (is x Eq) (is x' Eq) && Bool.eqb (is y Eq) (is y' Eq) && Bool.eqb (is z Eq) (is z' Eq)
  && (is d Eq || negb (is x Eq || is y Eq || is z Eq))
  && (negb (is d Eq) || balanced x y z && balanced x' y' z')
  && balanced (product s y) (product t z) (product u x)
  && balanced (product s y') (product t z') (product u x')
  && balanced (product d s) (product x z') (CompOpp (product x' z))
  && balanced (product d t) (product y x') (CompOpp (product y' x))
  && balanced (product d u) (product z y') (CompOpp (product z' y))
  && negb (is s Eq || is t Eq || is u Eq).
Definition right (d x y z x' y' z' s t u : comparison) : bool :=
  count d x y z - count d x' y' z'
  =? cross_by x x' s t + cross_by y y' t u + cross_by z z' u s.

Definition every (f : comparison -> bool) : bool := f Lt && f Eq && f Gt.

Lemma every_spec f : every f = true -> forall s, f s = true.
Proof. unfold every. rewrite !andb_true_iff. intros [[] ?] []; assumption. Qed.

(** All 59,049 of them. *)
Lemma table : every (fun d => every (fun x => every (fun y => every (fun z => every (fun x' =>
  every (fun y' => every (fun z' => every (fun s => every (fun t => every (fun u =>
  implb (possible d x y z x' y' z' s t u) (right d x y z x' y' z' s t u))))))))))) = true.
Proof. vm_compute. reflexivity. Qed.

Lemma table_spec d x y z x' y' z' s t u : possible d x y z x' y' z' s t u = true ->
  count d x y z - count d x' y' z' = cross_by x x' s t + cross_by y y' t u + cross_by z z' u s.
Proof.
  intros P. apply Z.eqb_eq. change (right d x y z x' y' z' s t u = true).
  pose proof table as T.
  pose proof (every_spec _ T d) as T1. cbv beta in T1. pose proof (every_spec _ T1 x) as T2.
  cbv beta in T2. pose proof (every_spec _ T2 y) as T3. cbv beta in T3.
  pose proof (every_spec _ T3 z) as T4. cbv beta in T4. pose proof (every_spec _ T4 x') as T5.
  cbv beta in T5. pose proof (every_spec _ T5 y') as T6. cbv beta in T6.
  pose proof (every_spec _ T6 z') as T7. cbv beta in T7. pose proof (every_spec _ T7 s) as T8.
  cbv beta in T8. pose proof (every_spec _ T8 t) as T9. cbv beta in T9.
  pose proof (every_spec _ T9 u) as T10. cbv beta in T10. rewrite P in T10. exact T10.
Qed.

(** ** Rays that lie on no edge *)

(** An edge whose ends lie on one line through the eye is on no ray's side. *)
Definition clear (p q : vertex) (e : vertex * vertex) : Prop :=
  det (fst e) (snd e) p <> 0 /\ det (fst e) (snd e) q <> 0
  \/ forall o, det (fst e) (snd e) o = 0.

Lemma mixed a b c p : ~ holds_eye (Face a b c) -> det a b c = 0 ->
  balanced (sign3 (det a b p)) (sign3 (det b c p)) (sign3 (det c a p)) = true.
Proof.
  intros N D. pose proof (corner_identity_3 a b c p) as I. rewrite D in I.
  replace (vertex_times 0 p) with eye in I by (apply vertex_ext; reflexivity).
  assert (U : forall k, k = 1 \/ k = -1 -> 0 <= k * det a b p -> 0 <= k * det b c p ->
    0 <= k * det c a p -> 0 < k * (det a b p + det b c p + det c a p) -> False).
  { intros k K X Y Z S. apply N. exists (k * det b c p), (k * det c a p), (k * det a b p).
    cbn [vertex_a vertex_b vertex_c]. repeat (split; [lia|]).
    apply (f_equal (vertex_times k)) in I.
    transitivity (vertex_times k eye); [rewrite <- I|];
      apply vertex_ext; unfold vertex_plus, vertex_times, eye; cbn [vx vy vw]; ring. }
  pose proof (U 1 (or_introl eq_refl)) as U1. pose proof (U (-1) (or_intror eq_refl)) as U2.
  clear - U1 U2. revert U1 U2. generalize (det a b p) (det b c p) (det c a p). intros x y z U1 U2.
  destruct x, y, z; try reflexivity; exfalso; lia.
Qed.

Lemma clear_zero p q a b : clear p q (a, b) ->
  Bool.eqb (is (sign3 (det a b p)) Eq) (is (sign3 (det a b q)) Eq) = true.
Proof.
  intros [[P Q]|Z]; cbn [fst snd] in *.
  - destruct (det a b p), (det a b q); try congruence; reflexivity.
  - rewrite !Z. reflexivity.
Qed.

Lemma clear_nonzero p q a b c : clear p q (a, b) -> det a b c <> 0 ->
  is (sign3 (det a b p)) Eq = false.
Proof.
  intros [[P Q]|Z] N; cbn [fst snd] in *; [|congruence].
  destruct (det a b p); congruence || reflexivity.
Qed.

Definition count_at (t : face) (p : vertex) : Z :=
  let (a, b, c) := t in
  count (sign3 (det a b c)) (sign3 (det a b p)) (sign3 (det b c p)) (sign3 (det c a p)).

Lemma difference p q a b c : ~ holds_eye (Face a b c) ->
  clear p q (a, b) -> clear p q (b, c) -> clear p q (c, a) ->
  det a p q <> 0 -> det b p q <> 0 -> det c p q <> 0 ->
  count_at (Face a b c) p - count_at (Face a b c) q = sum (crosses p q) (face_edges (Face a b c)).
Proof.
  intros N X Y Z A B C. unfold face_edges, count_at, crosses; cbn [vertex_a vertex_b vertex_c].
  sums. rewrite Z.add_0_r, Z.add_assoc. apply table_spec. unfold possible.
  rewrite !clear_zero by assumption.
  assert (S : forall v, det v p q <> 0 -> is (sign3 (det v p q)) Eq = false).
  { intros v V. destruct (det v p q); congruence || reflexivity. }
  rewrite !S by assumption.
  assert (E : is (sign3 (det a b c)) Eq || negb (is (sign3 (det a b p)) Eq
    || is (sign3 (det b c p)) Eq || is (sign3 (det c a p)) Eq) = true).
  { destruct (Z.eq_dec (det a b c) 0) as [->|D]; [reflexivity|].
    rewrite (clear_nonzero p q a b c), (clear_nonzero p q b c a), (clear_nonzero p q c a b);
      [apply orb_true_r|assumption| |assumption| |assumption|assumption].
    - rewrite <- (det_rotated c a b). assumption.
    - rewrite (det_rotated a b c). assumption. }
  rewrite E.
  assert (M : negb (is (sign3 (det a b c)) Eq)
    || balanced (sign3 (det a b p)) (sign3 (det b c p)) (sign3 (det c a p))
       && balanced (sign3 (det a b q)) (sign3 (det b c q)) (sign3 (det c a q)) = true).
  { destruct (Z.eq_dec (det a b c) 0) as [D|D].
    - rewrite !mixed by assumption. apply orb_true_r.
    - destruct (det a b c); congruence || reflexivity. }
  rewrite M. rewrite <- !sign_product, <- !sign_opposite.
  rewrite !sign_balanced; [reflexivity|..]; unfold det; ring.
Qed.
