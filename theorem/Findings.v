(** The exact coverage of the findings' cases: written by scripts/finding_theorems from
    docs/findings/*.json, whose unit is multiplied until all corners and pixel centres are integers.
    What the libraries counted instead is in docs/findings.md. *)
From Rasterproof Require Import Specification.

(** How many triangles, of either winding, cover the centre of each pixel. *)
Definition counts (m : mesh) (p : point) : Z := sum (fun t => Z.abs (signed top_left t p)) m.
Definition pixels (half : Z) (width height : nat) : list (list point) :=
  map (fun j => map (fun i => Point (half * (2 * Z.of_nat i + 1)) (half * (2 * Z.of_nat j + 1)))
         (seq 0 width)) (seq 0 height).
Definition picture (m : mesh) (half : Z) (width height : nat) : list (list Z) :=
  map (map (counts m)) (pixels half width height).

Definition allegro5_seam_gap : mesh :=
  [Triangle (Point 15711488 2522611712)
     (Point 302582 (-566910976))
     (Point 0 (-1610612736));
   Triangle (Point 15711488 2522611712)
     (Point 0 0)
     (Point 302582 (-566910976))].

Theorem allegro5_seam_gap_exactly :
  picture allegro5_seam_gap 1048576 3 3 =
    [[1; 1; 1];
     [1; 1; 1];
     [1; 1; 1]].
Proof. vm_compute. reflexivity. Qed.

Definition allegro5_seam_overlap : mesh :=
  [Triangle (Point (-64) 2)
     (Point (-16) (-16))
     (Point 128 128);
   Triangle (Point (-16) (-16))
     (Point 0 (-8))
     (Point 128 128)].

Theorem allegro5_seam_overlap_exactly :
  picture allegro5_seam_overlap 1 3 3 =
    [[1; 1; 1];
     [1; 1; 1];
     [1; 1; 1]].
Proof. vm_compute. reflexivity. Qed.

Definition cairo_beyond_vertex : mesh :=
  [Triangle (Point 12 6)
     (Point 16384 32)
     (Point 0 16)].

Theorem cairo_beyond_vertex_exactly :
  picture cairo_beyond_vertex 2 12 5 =
    [[0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0];
     [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0];
     [0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1];
     [0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1];
     [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]].
Proof. vm_compute. reflexivity. Qed.

Definition cairo_hole_filled : mesh :=
  [Triangle (Point 6 (-8))
     (Point 0 0)
     (Point 6 8);
   Triangle (Point 8 (-8))
     (Point 8 8)
     (Point 24 0)].

Theorem cairo_hole_filled_exactly :
  picture cairo_hole_filled 1 16 1 =
    [[1; 1; 1; 0; 1; 1; 1; 1; 1; 1; 1; 0; 0; 0; 0; 0]].
Proof. vm_compute. reflexivity. Qed.

Definition cairo_wide_triangle : mesh :=
  [Triangle (Point (-8388608) (-2))
     (Point 8388608 8)
     (Point (-8388608) 18)].

Theorem cairo_wide_triangle_exactly :
  picture cairo_wide_triangle 1 8 8 =
    [[0; 0; 0; 0; 0; 0; 0; 0];
     [0; 0; 0; 0; 0; 0; 0; 0];
     [1; 1; 1; 1; 1; 1; 1; 1];
     [1; 1; 1; 1; 1; 1; 1; 1];
     [1; 1; 1; 1; 1; 1; 1; 1];
     [1; 1; 1; 1; 1; 1; 1; 1];
     [0; 0; 0; 0; 0; 0; 0; 0];
     [0; 0; 0; 0; 0; 0; 0; 0]].
Proof. vm_compute. reflexivity. Qed.

Definition freetype_mono_seam : mesh :=
  [Triangle (Point 56 26)
     (Point 20 (-64))
     (Point (-28) 56);
   Triangle (Point 56 26)
     (Point (-28) 56)
     (Point 20 76)].

Theorem freetype_mono_seam_exactly :
  picture freetype_mono_seam 4 8 8 =
    [[1; 1; 1; 1; 1; 1; 0; 0];
     [1; 1; 1; 1; 1; 1; 0; 0];
     [1; 1; 1; 1; 1; 1; 1; 0];
     [1; 1; 1; 1; 1; 1; 1; 0];
     [1; 1; 1; 1; 1; 1; 0; 0];
     [1; 1; 1; 1; 1; 0; 0; 0];
     [1; 1; 1; 1; 1; 0; 0; 0];
     [1; 1; 1; 1; 0; 0; 0; 0]].
Proof. vm_compute. reflexivity. Qed.

Definition gd_large_triangle : mesh :=
  [Triangle (Point 0 (-128))
     (Point 67108864 8)
     (Point 0 8)].

Theorem gd_large_triangle_exactly :
  picture gd_large_triangle 1 4 4 =
    [[1; 1; 1; 1];
     [1; 1; 1; 1];
     [1; 1; 1; 1];
     [1; 1; 1; 1]].
Proof. vm_compute. reflexivity. Qed.

Definition llvmpipe_far_corners : mesh :=
  [Triangle (Point (-8192) 0)
     (Point 0 (-4096))
     (Point 8 8)].

Theorem llvmpipe_far_corners_exactly :
  picture llvmpipe_far_corners 1 3 3 =
    [[1; 1; 1];
     [1; 1; 1];
     [1; 1; 1]].
Proof. vm_compute. reflexivity. Qed.

Definition pixman_wide_triangle : mesh :=
  [Triangle (Point (-57344) 0)
     (Point 0 8)
     (Point 8192 0)].

Theorem pixman_wide_triangle_exactly :
  picture pixman_wide_triangle 1 5 5 =
    [[1; 1; 1; 1; 1];
     [1; 1; 1; 1; 1];
     [1; 1; 1; 1; 1];
     [1; 1; 1; 1; 1];
     [0; 0; 0; 0; 0]].
Proof. vm_compute. reflexivity. Qed.

Definition qt5_far_seam_gap : mesh :=
  [Triangle (Point 14336 0)
     (Point 266 88)
     (Point (-509952) (-135168));
   Triangle (Point 266 88)
     (Point 0 64)
     (Point (-509952) (-135168))].

Theorem qt5_far_seam_gap_exactly :
  picture qt5_far_seam_gap 8 3 3 =
    [[1; 1; 1];
     [1; 1; 1];
     [1; 1; 1]].
Proof. vm_compute. reflexivity. Qed.

Definition qt5_far_seam_overlap : mesh :=
  [Triangle (Point (-177152) (-399360))
     (Point 274 496)
     (Point 0 1703936);
   Triangle (Point 274 496)
     (Point (-177152) (-399360))
     (Point 256 0)].

Theorem qt5_far_seam_overlap_exactly :
  picture qt5_far_seam_overlap 32 3 3 =
    [[1; 1; 1];
     [1; 1; 1];
     [1; 1; 1]].
Proof. vm_compute. reflexivity. Qed.

Definition sdl2_false_rectangle : mesh :=
  [Triangle (Point 10 8)
     (Point 0 8)
     (Point 10 (-2));
   Triangle (Point 0 8)
     (Point 10 8)
     (Point 10 12)].

Theorem sdl2_false_rectangle_exactly :
  picture sdl2_false_rectangle 1 6 8 =
    [[0; 0; 0; 1; 1; 0];
     [0; 0; 1; 1; 1; 0];
     [0; 1; 1; 1; 1; 0];
     [1; 1; 1; 1; 1; 0];
     [0; 1; 1; 1; 1; 0];
     [0; 0; 0; 0; 1; 0];
     [0; 0; 0; 0; 0; 0];
     [0; 0; 0; 0; 0; 0]].
Proof. vm_compute. reflexivity. Qed.

Definition sdl2_large_triangle : mesh :=
  [Triangle (Point (-16384) 24576)
     (Point 0 (-28672))
     (Point 24576 24576)].

Theorem sdl2_large_triangle_exactly :
  picture sdl2_large_triangle 1 6 6 =
    [[1; 1; 1; 1; 1; 1];
     [1; 1; 1; 1; 1; 1];
     [1; 1; 1; 1; 1; 1];
     [1; 1; 1; 1; 1; 1];
     [1; 1; 1; 1; 1; 1];
     [1; 1; 1; 1; 1; 1]].
Proof. vm_compute. reflexivity. Qed.

Definition skia_far_seam_gap : mesh :=
  [Triangle (Point (-12) 4)
     (Point 8 0)
     (Point (-4) (-32768));
   Triangle (Point 8 0)
     (Point (-12) 4)
     (Point 6 32)].

Theorem skia_far_seam_gap_exactly :
  picture skia_far_seam_gap 1 3 3 =
    [[1; 1; 1];
     [1; 1; 1];
     [1; 1; 1]].
Proof. vm_compute. reflexivity. Qed.

Definition skia_far_seam_overlap : mesh :=
  [Triangle (Point 12 4)
     (Point (-32) (-8))
     (Point (-32768) (-32));
   Triangle (Point (-32) (-8))
     (Point 12 4)
     (Point (-8) (-128))].

Theorem skia_far_seam_overlap_exactly :
  picture skia_far_seam_overlap 1 3 3 =
    [[1; 1; 1];
     [1; 1; 1];
     [0; 0; 0]].
Proof. vm_compute. reflexivity. Qed.

Definition skia_vertex_on_centre : mesh :=
  [Triangle (Point 6 6)
     (Point (-4) (-8))
     (Point 0 28);
   Triangle (Point 6 6)
     (Point 0 28)
     (Point 20 (-4));
   Triangle (Point 6 6)
     (Point 20 (-4))
     (Point (-4) (-8))].

Theorem skia_vertex_on_centre_exactly :
  picture skia_vertex_on_centre 2 3 3 =
    [[1; 1; 1];
     [1; 1; 1];
     [1; 1; 1]].
Proof. vm_compute. reflexivity. Qed.

Definition softpipe_seam_gap : mesh :=
  [Triangle (Point 0 16)
     (Point (-4) 8)
     (Point 52 (-32));
   Triangle (Point 52 (-32))
     (Point (-4) 8)
     (Point 0 0)].

Theorem softpipe_seam_gap_exactly :
  picture softpipe_seam_gap 1 3 3 =
    [[1; 1; 1];
     [1; 1; 1];
     [1; 1; 1]].
Proof. vm_compute. reflexivity. Qed.

Definition softpipe_seam_overlap : mesh :=
  [Triangle (Point 94 (-74))
     (Point 0 (-32))
     (Point (-96) 192);
   Triangle (Point 96 0)
     (Point (-96) 192)
     (Point 94 (-74))].

Theorem softpipe_seam_overlap_exactly :
  picture softpipe_seam_overlap 8 3 3 =
    [[1; 1; 1];
     [1; 1; 1];
     [1; 1; 1]].
Proof. vm_compute. reflexivity. Qed.
