(** What the theorems are about. It is all that has to be read to know what [main] and
    [coverage_is_winding] say.

    Coordinates are integers: the finite numbers of a file become integers over a common
    denominator. x points right and y points down, as in Direct3D. A triangle is positive if its
    area by [edge] is. *)
From Coq Require Export ZArith List Permutation Bool.
Export ListNotations.
Global Open Scope Z_scope.

Record point := Point { px : Z; py : Z }.

Definition plus (a b : point) := Point (px a + px b) (py a + py b).
Definition minus (a b : point) := Point (px a - px b) (py a - py b).
Definition times (k : Z) (a : point) := Point (k * px a) (k * py a).
Definition origin := Point 0 0.

(** The edge function: twice the signed area of the triangle a b p. *)
Definition edge (a b p : point) :=
  (px b - px a) * (py p - py a) - (py b - py a) * (px p - px a).

(** ** Coverage *)

(** A tie rule by direction: which edges own the samples that lie on them. *)
Definition tie_rule := point -> bool.
Definition by_direction (r : tie_rule) := forall k d, 0 < k -> r (times k d) = r d.

Definition inside (r : tie_rule) (a b p : point) : bool :=
  (0 <? edge a b p) || (edge a b p =? 0) && r (minus b a).

Record triangle := Triangle { corner_a : point; corner_b : point; corner_c : point }.
Definition area (t : triangle) := edge (corner_a t) (corner_b t) (corner_c t).
Definition turned (t : triangle) := Triangle (corner_a t) (corner_c t) (corner_b t).

(** A positive triangle covers what is inside its three edges. *)
Definition covers (r : tie_rule) (t : triangle) (p : point) : bool :=
  inside r (corner_a t) (corner_b t) p && inside r (corner_b t) (corner_c t) p
  && inside r (corner_c t) (corner_a t) p.

(** A negative one covers, with sign -1, what it covers turned over; a flat one covers nothing. *)
Definition signed (r : tie_rule) (t : triangle) (p : point) : Z :=
  if 0 <? area t then Z.b2z (covers r t p)
  else if area t <? 0 then - Z.b2z (covers r (turned t) p)
  else 0.

(** A mesh is any list of triangles: flat, repeated, folded and overlapping ones included. *)
Definition mesh := list triangle.
Definition sum {A} (f : A -> Z) (l : list A) : Z := fold_right (fun e s => f e + s) 0 l.
Definition signed_coverage (r : tie_rule) (m : mesh) (p : point) : Z :=
  sum (fun t => signed r t p) m.
Definition owners (r : tie_rule) (m : mesh) (p : point) : Z :=
  sum (fun t => Z.b2z (covers r t p)) m.
Definition positive (m : mesh) := Forall (fun t => 0 < area t) m.

(** ** Winding number, which knows no triangle and no tie rule *)

Definition directed := (point * point)%type.
Definition chain := list directed.
Definition reverse (e : directed) : directed := (snd e, fst e).

(** What a directed edge adds at p: where it crosses the ray that goes from p to the right, +1 if it
    goes to larger y, -1 if to smaller. *)
Definition crossing (p : point) (e : directed) : Z :=
  let (a, b) := e in
  if (py a <=? py p) && (py p <? py b) && (0 <? edge a b p) then 1
  else if (py b <=? py p) && (py p <? py a) && (edge a b p <? 0) then -1
  else 0.
Definition winding (c : chain) (p : point) : Z := sum (crossing p) c.

Definition on_segment (a b p : point) : Prop :=
  edge a b p = 0
  /\ (px a - px p) * (px b - px p) + (py a - py p) * (py b - py p) <= 0.
Definition off (c : chain) (p : point) : Prop := Forall (fun e => ~ on_segment (fst e) (snd e) p) c.

Definition triangle_boundary (t : triangle) : chain :=
  [(corner_a t, corner_b t); (corner_b t, corner_c t); (corner_c t, corner_a t)].
Definition boundary (m : mesh) : chain := flat_map triangle_boundary m.

(** What is left of the boundary after pairs of opposite edges were taken away. *)
Definition outline (m : mesh) (c : chain) : Prop :=
  exists pairs, Permutation (boundary m) (c ++ pairs ++ map reverse pairs).

(** ** The statement *)

(** Where a mesh of positive triangles surrounds a sample once, one triangle covers it. *)
Definition partitions (r : tie_rule) : Prop := forall m c p,
  positive m -> outline m c -> off c p -> winding c p = 1 -> owners r m p = 1.

(** A half-open half-circle: of two opposite directions one, and with two directions their sum. *)
Definition half_circle (r : tie_rule) : Prop :=
  (forall d, d <> origin -> r (times (-1) d) = negb (r d))
  /\ (forall d e, d <> origin -> e <> origin -> r d = true -> r e = true -> r (plus d e) = true).

(** What OpenGL and Vulkan state: a sample between the ends of a common edge has one owner. *)
Definition common_edge (r : tie_rule) : Prop := forall a b c d p,
  0 < edge a b c -> 0 < edge b a d -> on_segment a b p -> p <> a -> p <> b ->
  owners r [Triangle a b c; Triangle b a d] p = 1.

(** ** Direct3D's words *)

(** Of the triangle with the edge a b and the third corner c. A top edge is exactly horizontal,
    and the triangle is below it. A left edge is not horizontal, and the triangle is right of it. *)
Definition top (a b c : point) : bool := (py a =? py b) && (py a <? py c).
Definition left (a b c : point) : bool :=
  let right_of_line (upper lower : point) :=
    (px lower - px upper) * (py c - py upper) <? (px c - px upper) * (py lower - py upper) in
  if py a <? py b then right_of_line a b else if py b <? py a then right_of_line b a else false.
Definition within (a b c p : point) : bool :=
  (0 <? edge a b p * edge a b c) || (edge a b p =? 0) && (top a b c || left a b c).
Definition direct3d (t : triangle) (p : point) : bool :=
  let (a, b, c) := t in within a b c p && within b c a p && within c a b p.

(** The same as a tie rule by direction. *)
Definition top_left (d : point) : bool := (py d <? 0) || (py d =? 0) && (0 <? px d).
