(** What the theorems about clip space are about: vertices (x, y, w) with w of any sign, seen from
    the eye, the origin. The sample (x, y) is the ray from the eye through (x, y, 1), or through
    any (k x, k y, k) with k > 0, so that all are integers. *)
From Rasterproof Require Import Specification.

Record vertex := Vertex { vx : Z; vy : Z; vw : Z }.

Definition vertex_plus (a b : vertex) := Vertex (vx a + vx b) (vy a + vy b) (vw a + vw b).
Definition vertex_times (k : Z) (a : vertex) := Vertex (k * vx a) (k * vy a) (k * vw a).
Definition eye := Vertex 0 0 0.

(** The determinant of three rows: as a function of p, the homogeneous edge function of a b. *)
Definition det (a b p : vertex) :=
  (vy a * vw b - vw a * vy b) * vx p + (vw a * vx b - vx a * vw b) * vy p
  + (vx a * vy b - vy a * vx b) * vw p.

(** In which direction the edge runs past the sample: wa wb times the difference of the projected
    ends, so along it if both w have one sign, against it if not. *)
Definition direction (a b : vertex) : point :=
  Point (vw a * vx b - vx a * vw b) (vw a * vy b - vy a * vw b).

Definition beside (r : tie_rule) (a b p : vertex) : bool :=
  (0 <? det a b p) || (det a b p =? 0) && r (direction a b).

Record face := Face { vertex_a : vertex; vertex_b : vertex; vertex_c : vertex }.
Definition facing (t : face) := det (vertex_a t) (vertex_b t) (vertex_c t).
Definition turned_face (t : face) := Face (vertex_a t) (vertex_c t) (vertex_b t).
Definition shows (r : tie_rule) (t : face) (p : vertex) : bool :=
  beside r (vertex_a t) (vertex_b t) p && beside r (vertex_b t) (vertex_c t) p
  && beside r (vertex_c t) (vertex_a t) p.

(** +1 or -1 by the side that the ray sees; a triangle in a plane through the eye covers nothing. *)
Definition seen (r : tie_rule) (t : face) (p : vertex) : Z :=
  if 0 <? facing t then Z.b2z (shows r t p)
  else if facing t <? 0 then - Z.b2z (shows r (turned_face t) p)
  else 0.

Definition surface := list face.
Definition seen_coverage (r : tie_rule) (m : surface) (p : vertex) : Z :=
  sum (fun t => seen r t p) m.

(** The eye is a point of the triangle. *)
Definition holds_eye (t : face) : Prop := exists i j k,
  0 <= i /\ 0 <= j /\ 0 <= k /\ 0 < i + j + k
  /\ vertex_plus (vertex_times i (vertex_a t))
       (vertex_plus (vertex_times j (vertex_b t)) (vertex_times k (vertex_c t))) = eye.
Definition misses_the_eye (m : surface) : Prop := Forall (fun t => ~ holds_eye t) m.

Definition face_edges (t : face) : list (vertex * vertex) :=
  [(vertex_a t, vertex_b t); (vertex_b t, vertex_c t); (vertex_c t, vertex_a t)].
Definition edges_of (m : surface) := flat_map face_edges m.
Definition opposite (e : vertex * vertex) := (snd e, fst e).
(** What is left of its edges after pairs of opposite ones were taken away. *)
Definition rim (m : surface) (c : list (vertex * vertex)) : Prop :=
  exists pairs, Permutation (edges_of m) (c ++ pairs ++ map opposite pairs).

(** ** The statement *)

Definition same_in_every_direction (r : tie_rule) : Prop := forall m p q,
  misses_the_eye m -> rim m [] -> vw p <> 0 -> vw q <> 0 ->
  seen_coverage r m p = seen_coverage r m q.
