(** The specification as an OCaml program, with zarith's integers for Z. *)
From Rasterproof Require Import Specification ClipSpecification ValueSpecification Findings.
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlZBigInt.

(** How many triangles of clip space, seen from either side, the ray of a sample meets. *)
Definition seen_counts (m : surface) (p : vertex) : Z :=
  sum (fun t => Z.abs (seen top_left t p)) m.

Definition weights := (beta_a, beta_b, beta_c, horizon, on_screen, slope).

Extraction "coverage.ml" counts seen_counts weights.
