(** No main statement is empty: of each, a case that satisfies all that it assumes, evaluated. *)
From Rasterproof Require Import Specification Boundary Winding Coverage Reduced Partition Rules
  Shift Path.
From Coq Require Import Lia.

Ltac evaluate := vm_compute; reflexivity.
Ltac off_all :=
  repeat constructor; cbn [fst snd]; intros [E D]; vm_compute in E, D; try discriminate;
    now apply D.
Ltac positive_all := repeat constructor.

(** ** A hub: partitions, and one owner of a common edge is not enough *)

Definition hub_outline : chain :=
  [(Point 1 1, Point (-1) 2); (Point (-1) 2, Point (-2) 1); (Point (-2) 1, Point (-1) (-1));
   (Point (-1) (-1), Point 1 (-2)); (Point 1 (-2), Point 2 (-1)); (Point 2 (-1), Point 1 1)].

Lemma hub_has_outline : outline hub hub_outline.
Proof.
  exists [(origin, Point 1 1); (origin, Point (-1) 2); (origin, Point (-2) 1);
    (origin, Point (-1) (-1)); (origin, Point 1 (-2)); (origin, Point 2 (-1))].
  cbn. permutation.
Qed.

Example hub_is_a_case : positive hub /\ outline hub hub_outline /\ off hub_outline origin
  /\ winding hub_outline origin = 1 /\ owners top_left hub origin = 1
  /\ owners three_lobes hub origin = 3.
Proof.
  repeat split; try evaluate; [positive_all|apply hub_has_outline|off_all].
Qed.

(** The spokes cancel. *)
Example hub_reduced : reduced (boundary hub) = hub_outline.
Proof. evaluate. Qed.

(** ** A common edge: both halves of a square, the sample on the diagonal *)

Definition halves : mesh :=
  [Triangle (Point 0 0) (Point 8 8) (Point 0 8); Triangle (Point 8 8) (Point 0 0) (Point 8 0)].

Example halves_are_a_case : positive halves /\ on_segment (Point 0 0) (Point 8 8) (Point 4 4)
  /\ owners top_left halves (Point 4 4) = 1 /\ owners three_lobes halves (Point 4 4) = 1
  /\ owners (fun _ => true) halves (Point 4 4) = 2 /\ owners (fun _ => false) halves (Point 4 4) =
    0.
Proof.
  repeat split; try evaluate; [positive_all|vm_compute; discriminate].
Qed.

(** ** Any mesh: a negative triangle, a flat one, one repeated, the sample on an inner edge *)

Definition folded : mesh :=
  halves ++ halves ++ [Triangle (Point 0 0) (Point 0 8) (Point 8 8);
    Triangle (Point 0 0) (Point 4 4) (Point 8 8); Triangle (Point 3 3) (Point 3 3) (Point 3 3)].

(** Of the diagonal, two whole edges stay, and the two halves that the flat triangle brought. *)
Definition folded_outline : chain :=
  let o := Point 0 0 in let q := Point 8 8 in let h := Point 4 4 in let d := Point 3 3 in
  [(o, Point 8 0); (Point 8 0, q); (o, Point 8 0); (Point 8 0, q); (q, Point 0 8); (Point 0 8, o);
   (q, o); (q, o); (o, h); (h, q); (d, d); (d, d); (d, d)].

Example folded_is_a_case : outline folded folded_outline
  /\ off folded_outline (Point 2 5) /\ off folded_outline (Point 5 2)
  /\ signed_coverage top_left folded (Point 2 5) = 1 /\ winding folded_outline (Point 2 5) = 1
  /\ signed_coverage top_left folded (Point 5 2) = 2 /\ winding folded_outline (Point 5 2) = 2
  /\ signed_coverage top_left folded (Point 4 4) = 2.
Proof.
  split; [|split; [off_all|split; [off_all|repeat split; evaluate]]].
  exists [(Point 0 0, Point 8 8); (Point 0 0, Point 8 8); (Point 8 8, Point 0 8);
    (Point 0 8, Point 0 0)].
  cbn. permutation.
Qed.

(** A tetrahedron seen from the front: closed, and each sample inside is covered. *)
Definition closed_mesh : mesh :=
  let a := Point 0 0 in let b := Point 9 0 in let c := Point 0 9 in let d := Point 3 3 in
  [Triangle a b d; Triangle b c d; Triangle c a d; Triangle a c b].

Example closed_mesh_is_a_case : outline closed_mesh []
  /\ map (fun p => signed_coverage top_left closed_mesh p) [Point 1 1; Point 3 3; Point 2 2] = [0;
    0; 0]
  /\ map (fun p => sum (fun t => Z.abs (signed top_left t p)) closed_mesh)
       [Point 1 1; Point 3 3; Point 2 2] = [2; 2; 2].
Proof.
  split; [|split; evaluate].
  exists [(Point 0 0, Point 9 0); (Point 9 0, Point 3 3); (Point 3 3, Point 0 0);
    (Point 9 0, Point 0 9); (Point 0 9, Point 3 3); (Point 0 9, Point 0 0)].
  cbn. permutation.
Qed.

(** ** The shift: a sample on an edge, on either side of it *)

Example shift_is_a_case :
  map (fun e : directed => let (a, b) := e in
         (inside top_left a b (Point 4 4),
          strictly_inside (times 10000 a) (times 10000 b) (Point (10000 * 4 + 100) (10000 * 4 +
            1))))
    [(Point 0 0, Point 8 8); (Point 8 8, Point 0 0); (Point 0 4, Point 8 4); (Point 8 4, Point 0 4)]
  = [(false, false); (true, true); (true, true); (false, false)].
Proof. evaluate. Qed.

(** ** Direct3D's words: both windings, on a top, a left, a bottom and a right edge *)

Example direct3d_is_a_case :
  let t := Triangle (Point 0 0) (Point 8 0) (Point 0 8) in
  map (fun p => (direct3d t p, direct3d (turned t) p))
    [Point 4 0; Point 0 4; Point 4 4; Point 0 0; Point 8 0; Point 0 8; Point 1 1]
  = [(true, true); (true, true); (false, false); (true, true); (false, false); (false, false);
    (true, true)].
Proof. evaluate. Qed.

(** ** The eight rules differ: who owns the four sides of a square *)

Example eight_rules_are_eight :
  let sides := [Point 1 0; Point 0 1; Point 1 1; Point 1 (-1)] in
  map (fun r => map r sides)
    [axis_rule 1 1 false; axis_rule 1 (-1) false; axis_rule (-1) 1 false; axis_rule (-1) (-1) false;
     axis_rule 1 1 true; axis_rule 1 (-1) true; axis_rule (-1) 1 true; axis_rule (-1) (-1) true]
  = [[true; false; false; true]; [false; false; false; true]; [true; true; true; false];
     [false; true; true; false]; [true; false; true; true]; [false; false; false; false];
     [true; true; true; true]; [false; true; false; false]].
Proof. evaluate. Qed.

(** ** The winding number: constant along a path, 0 far away *)

Example path_is_a_case : let c := square (Point 0 0) (Point 8 8) in
  Forall (fun e => ~ meet (fst e) (snd e) (Point 1 1) (Point 6 5)) c
  /\ winding c (Point 1 1) = 1 /\ winding c (Point 6 5) = 1 /\ winding c (Point 9 5) = 0.
Proof.
  repeat split; try evaluate.
  repeat constructor; cbn [fst snd px py]; unfold meet, on_segment; intros H; vm_compute in H;
    intuition congruence.
Qed.
