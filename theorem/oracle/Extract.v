(** The specification as an OCaml program, with zarith's integers for Z. *)
From Rasterproof Require Import Specification Findings.
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlZBigInt.

Extraction "coverage.ml" counts.
