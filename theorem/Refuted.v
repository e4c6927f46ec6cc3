(** What is not true: rules that look like top-left, and what they do to a mesh. *)
From Rasterproof Require Import Specification Boundary Winding Coverage Partition Rules Examples.
From Coq Require Import Lia.

(** A rule that gives both directions of an edge alike does not partition. *)
Theorem symmetric_rules_do_not_partition r d : by_direction r -> d <> origin ->
  r (times (-1) d) = r d -> ~ partitions r.
Proof.
  intros D N E P. apply main in P as [O _]; [|assumption]. rewrite O in E by assumption.
  destruct (r d); discriminate.
Qed.

Definition top_left_without_top (d : point) : bool := py d <? 0.
Definition top_left_symmetric (d : point) : bool := negb (py d =? 0) || (0 <? px d).

Theorem without_second_tie_break : ~ partitions top_left_without_top.
Proof.
  apply (symmetric_rules_do_not_partition _ (Point 1 0)); [|discriminate|reflexivity].
  intros k d K. unfold top_left_without_top, times; cbn [px py]. decide_all; reflexivity || nia.
Qed.

Theorem symmetric_top_left : ~ partitions top_left_symmetric.
Proof.
  apply (symmetric_rules_do_not_partition _ (Point 0 1)); [|discriminate|reflexivity].
  intros k d K. unfold top_left_symmetric, times; cbn [px py].
  decide_all; simpl; reflexivity || (exfalso; nia).
Qed.

Theorem inclusive_does_not_partition : ~ partitions (fun _ => true).
Proof.
  apply (symmetric_rules_do_not_partition _ (Point 1 0)); [|discriminate|reflexivity].
  intros k d K. reflexivity.
Qed.

Theorem exclusive_does_not_partition : ~ partitions (fun _ => false).
Proof.
  apply (symmetric_rules_do_not_partition _ (Point 1 0)); [|discriminate|reflexivity].
  intros k d K. reflexivity.
Qed.

(** Two triangles above and below a horizontal edge, the sample on it: no owner; left and right of
    a vertical one: two. *)
Definition stacked : mesh :=
  [Triangle (Point 0 4) (Point 8 4) (Point 4 8); Triangle (Point 8 4) (Point 0 4) (Point 4 0)].
Definition beside : mesh :=
  [Triangle (Point 4 0) (Point 4 8) (Point 0 4); Triangle (Point 4 8) (Point 4 0) (Point 8 4)].

Example wrong_owners :
  owners top_left_without_top stacked (Point 4 4) = 0 /\ owners top_left stacked (Point 4 4) = 1
  /\ owners top_left_symmetric beside (Point 4 4) = 2 /\ owners top_left beside (Point 4 4) = 1.
Proof. repeat split; evaluate. Qed.

(** A vertex that all triangles around it own, or none: what corners without a rule do. *)
Example inclusive_hub : owners (fun _ => true) hub origin = 6
  /\ owners (fun _ => false) hub origin = 0.
Proof. split; evaluate. Qed.
