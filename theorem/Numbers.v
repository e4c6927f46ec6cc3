(** Barycentrics, and edge values by steps. *)
From Rasterproof Require Import Specification Boundary.
From Coq Require Import QArith Lia.
Local Open Scope Z_scope.

(** The three edge values put the sample where it is. *)
Theorem barycentrics_place_the_sample a b c p :
  plus (times (edge b c p) a) (plus (times (edge c a p) b) (times (edge a b p) c))
  = times (edge a b c) p.
Proof. unfold edge, plus, times; cbn [px py]. f_equal; ring. Qed.

Definition barycentric (e area : Z) : Q := (inject_Z e / inject_Z area)%Q.

Theorem barycentrics_sum_to_one a b c p : edge a b c <> 0 ->
  (barycentric (edge b c p) (edge a b c) + barycentric (edge c a p) (edge a b c)
   + barycentric (edge a b p) (edge a b c) == 1)%Q.
Proof.
  intros N. unfold barycentric.
  assert (M : ~ (inject_Z (edge a b c) == 0)%Q).
  { intros E. apply N. unfold Qeq, inject_Z in E; cbn in E. lia. }
  assert (S : (inject_Z (edge b c p) + inject_Z (edge c a p) + inject_Z (edge a b p)
    == inject_Z (edge a b c))%Q).
  { rewrite <- !inject_Z_plus. rewrite <- (area_identity a b c p).
    replace (edge b c p + edge c a p + edge a b p) with (edge a b p + edge b c p + edge c a p) by
      ring.
    reflexivity. }
  transitivity ((inject_Z (edge b c p) + inject_Z (edge c a p) + inject_Z (edge a b p))
    / inject_Z (edge a b c))%Q; [field; assumption|].
  rewrite S. field. assumption.
Qed.

(** A walk over samples: whole steps in x and y, in any order. *)
Definition walk (p : point) (steps : list point) : point := fold_left plus steps p.
Definition stepped (a b : point) (e : Z) (steps : list point) : Z :=
  fold_left (fun v s => v + (px b - px a) * py s - (py b - py a) * px s) steps e.

Theorem stepped_is_direct a b p steps :
  stepped a b (edge a b p) steps = edge a b (walk p steps).
Proof.
  revert p. induction steps as [|s l IH]; intros p; [reflexivity|].
  unfold stepped, walk in *. cbn [fold_left]. rewrite <- IH. f_equal.
  unfold edge, plus; cbn [px py]. ring.
Qed.

Example barycentrics_are_not_vacuous :
  barycentric (edge (Point 8 0) (Point 0 8) (Point 2 3)) (edge (Point 0 0) (Point 8 0) (Point 0 8))
  = (24 # 64)%Q.
Proof. vm_compute. reflexivity. Qed.

Example steps_are_not_vacuous :
  stepped (Point 0 0) (Point 8 3) 0 [Point 1 0; Point 0 1; Point (-3) 2] = 30.
Proof. vm_compute. reflexivity. Qed.
