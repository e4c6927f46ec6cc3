(** What a triangle's attribute is at a sample. Vertices (x, y, w) have w of any sign, as in
    ClipSpecification; the sample is the ray through p. Attributes are integers over a common
    denominator, a value is num / den. *)
From Rasterproof Require Import Specification ClipSpecification.

(** An attribute is linear on the triangle's plane. So its value where the ray meets the plane is
    that of any combination of the corners there, whatever its three weights i / m, j / m, k / m. *)
Definition value_in_perspective (a b c p : vertex) (ua ub uc num den : Z) : Prop :=
  exists i j k m t, i + j + k = m /\ m <> 0
    /\ vertex_plus (vertex_times i a) (vertex_plus (vertex_times j b) (vertex_times k c))
       = vertex_times t p
    /\ num * m = den * (i * ua + j * ub + k * uc).

(** The same of the corners' projections (x / w, y / w, 1), which combine to that of p on the
    screen. Written without division: all times the four w. *)
Definition value_on_screen (a b c p : vertex) (ua ub uc num den : Z) : Prop :=
  exists i j k m, i + j + k = m /\ m <> 0
    /\ vertex_times (vw p)
         (vertex_plus (vertex_times (i * vw b * vw c) a)
            (vertex_plus (vertex_times (j * vw c * vw a) b) (vertex_times (k * vw a * vw b) c)))
       = vertex_times (m * (vw a * vw b * vw c)) p
    /\ num * m = den * (i * ua + j * ub + k * uc).

(** ** What is computed *)

(** The factors of the corners, over their sum and over the determinant. *)
Definition beta_a (a b c p : vertex) := det b c p.
Definition beta_b (a b c p : vertex) := det c a p.
Definition beta_c (a b c p : vertex) := det a b p.
Definition combined (a b c p : vertex) (ua ub uc : Z) :=
  beta_a a b c p * ua + beta_b a b c p * ub + beta_c a b c p * uc.
Definition horizon (a b c p : vertex) := combined a b c p 1 1 1.
Definition on_screen (a b c p : vertex) (ua ub uc : Z) :=
  combined a b c p (vw a * ua) (vw b * ub) (vw c * uc).

(** The numerators, over the square of the same denominator, of how fast the value changes along s:
    for s = (1, 0, 0) and (0, 1, 0) the derivatives, where p has w = 1. *)
Definition slope (a b c p s : vertex) (ua ub uc : Z) :=
  combined a b c s ua ub uc * horizon a b c p - combined a b c p ua ub uc * horizon a b c s.
