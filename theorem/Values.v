(** Perspective and screen weights: what they are, how they hang together, and derivatives. *)
From Coq Require Import Lia QArith Qfield.
From Rasterproof Require Import Specification ClipSpecification ValueSpecification.
Local Open Scope Z_scope.

Ltac open_values :=
  unfold horizon, on_screen, combined, beta_a, beta_b, beta_c, det, vertex_plus, vertex_times in *;
  cbn [vx vy vw] in *.

(** Cramer's rule: the three factors put the ray where it is. *)
Theorem weights_place_the_ray a b c p :
  vertex_plus (vertex_times (beta_a a b c p) a)
    (vertex_plus (vertex_times (beta_b a b c p) b) (vertex_times (beta_c a b c p) c))
  = vertex_times (det a b c) p.
Proof. open_values. f_equal; ring. Qed.

(** Any combination of the corners on the ray has weights in the proportion of these factors. *)
Lemma weights_are_proportional a b c p i j k t :
  vertex_plus (vertex_times i a) (vertex_plus (vertex_times j b) (vertex_times k c))
  = vertex_times t p ->
  i * det a b c = t * beta_a a b c p /\ j * det a b c = t * beta_b a b c p
  /\ k * det a b c = t * beta_c a b c p.
Proof.
  intros E.
  assert (X : forall u v, i * det u v a + j * det u v b + k * det u v c = t * det u v p).
  { intros u v. transitivity (det u v (vertex_times t p)).
    - rewrite <- E. open_values. ring.
    - open_values. ring. }
  pose proof (X b c) as A. pose proof (X c a) as B. pose proof (X a b) as C. clear X E.
  assert (Z0 : forall u v, det u v u = 0 /\ det u v v = 0) by (intros; split; unfold det; ring).
  assert (T : forall u v w, det v w u = det u v w) by (intros; unfold det; ring).
  destruct (Z0 a b) as [A1 A2], (Z0 b c) as [B1 B2], (Z0 c a) as [C1 C2].
  unfold beta_a, beta_b, beta_c.
  rewrite B1, B2, (T a b c) in A. rewrite C1, C2, <- (T c a b) in B. rewrite A1, A2 in C.
  repeat split; lia.
Qed.

(** The value is one number, and it is the quotient that is computed. *)
Theorem value_is_the_quotient a b c p ua ub uc num den : det a b c <> 0 -> den <> 0 ->
  value_in_perspective a b c p ua ub uc num den
  <-> horizon a b c p <> 0 /\ num * horizon a b c p = den * combined a b c p ua ub uc.
Proof.
  intros D N. split.
  - intros (i & j & k & m & t & S & M & E & V).
    destruct (weights_are_proportional _ _ _ _ _ _ _ _ E) as (A & B & C).
    assert (H : m * det a b c = t * horizon a b c p).
    { unfold horizon, combined. rewrite <- S. lia. }
    assert (T : t <> 0) by (intros ->; rewrite Z.mul_0_l in H; nia).
    split; [intros Q; rewrite Q, Z.mul_0_r in H; nia|].
    apply (Z.mul_reg_l _ _ t T).
    transitivity (num * m * det a b c); [rewrite <- Z.mul_assoc, H; ring|].
    rewrite V. unfold combined.
    transitivity (den * (i * det a b c * ua + j * det a b c * ub + k * det a b c * uc)); [ring|].
    rewrite A, B, C. ring.
  - intros [H V]. exists (beta_a a b c p), (beta_b a b c p), (beta_c a b c p), (horizon a b c p).
    exists (det a b c). repeat split.
    + unfold horizon, combined. ring.
    + exact H.
    + apply weights_place_the_ray.
    + rewrite V. unfold combined. ring.
Qed.

Lemma screen_factors_sum a b c p : on_screen a b c p 1 1 1 = det a b c * vw p.
Proof. open_values. ring. Qed.

Theorem screen_value_is_the_quotient a b c p ua ub uc num den :
  det a b c <> 0 -> den <> 0 -> vw a <> 0 -> vw b <> 0 -> vw c <> 0 -> vw p <> 0 ->
  value_on_screen a b c p ua ub uc num den
  <-> num * (det a b c * vw p) = den * on_screen a b c p ua ub uc.
Proof.
  intros D N WA WB WC WP.
  assert (Cancel : forall f x y, f <> 0 -> f * x = f * y -> x = y).
  { intros f x y F Q. exact (Z.mul_reg_l _ _ _ F Q). }
  split.
  - intros (i & j & k & m & S & M & E & V).
    assert (E' : vertex_plus (vertex_times (vw p * i * vw b * vw c) a)
      (vertex_plus (vertex_times (vw p * j * vw c * vw a) b)
         (vertex_times (vw p * k * vw a * vw b) c))
      = vertex_times (m * (vw a * vw b * vw c)) p).
    { rewrite <- E. unfold vertex_times, vertex_plus; cbn [vx vy vw]. f_equal; ring. }
    destruct (weights_are_proportional _ _ _ _ _ _ _ _ E') as (A & B & C). clear E E'.
    assert (A' : vw p * i * det a b c = m * vw a * beta_a a b c p).
    { apply (Cancel (vw b * vw c)); [nia|].
      transitivity (vw p * i * vw b * vw c * det a b c); [ring|]. rewrite A. ring. }
    assert (B' : vw p * j * det a b c = m * vw b * beta_b a b c p).
    { apply (Cancel (vw c * vw a)); [nia|].
      transitivity (vw p * j * vw c * vw a * det a b c); [ring|]. rewrite B. ring. }
    assert (C' : vw p * k * det a b c = m * vw c * beta_c a b c p).
    { apply (Cancel (vw a * vw b)); [nia|].
      transitivity (vw p * k * vw a * vw b * det a b c); [ring|]. rewrite C. ring. }
    apply (Cancel m); [assumption|].
    transitivity (num * m * (det a b c * vw p)); [ring|]. rewrite V.
    transitivity (den * (vw p * i * det a b c * ua + vw p * j * det a b c * ub
      + vw p * k * det a b c * uc)); [ring|].
    rewrite A', B', C'. unfold on_screen, combined. ring.
  - intros V.
    exists (vw a * beta_a a b c p), (vw b * beta_b a b c p), (vw c * beta_c a b c p).
    exists (det a b c * vw p). repeat split.
    + rewrite <- screen_factors_sum. unfold on_screen, combined. ring.
    + nia.
    + pose proof (weights_place_the_ray a b c p) as W. unfold vertex_times, vertex_plus in W.
      injection W as X Y Z. unfold vertex_times, vertex_plus; cbn [vx vy vw].
      f_equal.
      * transitivity (vw a * vw b * vw c * vw p * (det a b c * vx p)); [rewrite <- X; ring|ring].
      * transitivity (vw a * vw b * vw c * vw p * (det a b c * vy p)); [rewrite <- Y; ring|ring].
      * transitivity (vw a * vw b * vw c * vw p * (det a b c * vw p)); [rewrite <- Z; ring|ring].
    + rewrite V. unfold on_screen, combined. ring.
Qed.

(** Weights as rationals. *)
Local Open Scope Q_scope.
Lemma not_zero z : z <> 0%Z -> ~ inject_Z z == 0.
Proof. intros N E. apply N. unfold Qeq, inject_Z in E; cbn in E. lia. Qed.

Lemma sum_of_quotients x y z s : (x + y + z)%Z = s -> s <> 0%Z ->
  inject_Z x / inject_Z s + inject_Z y / inject_Z s + inject_Z z / inject_Z s == 1.
Proof.
  intros E N. apply not_zero in N.
  assert (S : inject_Z x + inject_Z y + inject_Z z == inject_Z s).
  { rewrite <- E, !inject_Z_plus. reflexivity. }
  transitivity ((inject_Z x + inject_Z y + inject_Z z) / inject_Z s); [field; assumption|].
  rewrite S. field. assumption.
Qed.

Theorem perspective_weights_sum_to_one a b c p : horizon a b c p <> 0%Z ->
  inject_Z (beta_a a b c p) / inject_Z (horizon a b c p)
  + inject_Z (beta_b a b c p) / inject_Z (horizon a b c p)
  + inject_Z (beta_c a b c p) / inject_Z (horizon a b c p) == 1.
Proof. apply sum_of_quotients. unfold horizon, combined. ring. Qed.

Theorem screen_weights_sum_to_one a b c p : det a b c <> 0%Z -> vw p <> 0%Z ->
  inject_Z (vw a * beta_a a b c p) / inject_Z (det a b c * vw p)
  + inject_Z (vw b * beta_b a b c p) / inject_Z (det a b c * vw p)
  + inject_Z (vw c * beta_c a b c p) / inject_Z (det a b c * vw p) == 1.
Proof.
  intros D W. apply sum_of_quotients; [|nia].
  rewrite <- screen_factors_sum. unfold on_screen, combined. ring.
Qed.

(** A perspective weight is the screen weight over its corner's w, over the sum of these. *)
Definition over_w (beta w d : Z) : Q := inject_Z (w * beta) / inject_Z d / inject_Z w.

Theorem perspective_weights_are_screen_weights_over_w a b c p : det a b c <> 0%Z ->
  vw a <> 0%Z -> vw b <> 0%Z -> vw c <> 0%Z -> vw p <> 0%Z -> horizon a b c p <> 0%Z ->
  let d := (det a b c * vw p)%Z in
  let mu_a := over_w (beta_a a b c p) (vw a) d in
  let mu_b := over_w (beta_b a b c p) (vw b) d in
  let mu_c := over_w (beta_c a b c p) (vw c) d in
  inject_Z (beta_a a b c p) / inject_Z (horizon a b c p) == mu_a / (mu_a + mu_b + mu_c).
Proof.
  intros D WA WB WC WP H d mu_a mu_b mu_c.
  assert (ND : ~ inject_Z d == 0) by (apply not_zero; unfold d; nia).
  assert (O : forall beta w, w <> 0%Z -> over_w beta w d == inject_Z beta / inject_Z d).
  { intros beta w W. apply not_zero in W. unfold over_w. rewrite inject_Z_mult.
    field. split; assumption. }
  subst mu_a mu_b mu_c. rewrite !O by assumption.
  assert (S : inject_Z (beta_a a b c p) + inject_Z (beta_b a b c p) + inject_Z (beta_c a b c p)
    == inject_Z (horizon a b c p)).
  { rewrite <- !inject_Z_plus. apply inject_Z_injective. unfold horizon, combined. ring. }
  apply not_zero in H. rewrite <- S in H |- *. field. split; assumption.
Qed.
Local Open Scope Z_scope.

(** ** What follows *)

Theorem equal_values_stay_equal a b c p u num den : det a b c <> 0 -> den <> 0 ->
  value_in_perspective a b c p u u u num den -> num = den * u.
Proof.
  intros D N V. apply value_is_the_quotient in V as [H V]; [|assumption..].
  apply (Z.mul_reg_r _ _ _ H). rewrite V. unfold horizon, combined. ring.
Qed.

Theorem vertices_keep_their_values a b c n ua ub uc num den :
  det a b c <> 0 -> den <> 0 -> n <> 0 ->
  value_in_perspective a b c (vertex_times n a) ua ub uc num den -> num = den * ua.
Proof.
  intros D N P V. apply value_is_the_quotient in V as [H V]; [|assumption..].
  assert (F : forall x y z, combined a b c (vertex_times n a) x y z = n * det a b c * x).
  { intros. open_values. ring. }
  unfold horizon in *. rewrite !F in V. rewrite F in H.
  apply (Z.mul_reg_l _ _ (n * det a b c)); nia.
Qed.

(** On an edge the corner off it has no say, so neighbours agree there. *)
Theorem neighbours_agree_along_their_edge a b c d p ua ub uc ud num den num' den' :
  det a b c <> 0 -> det b a d <> 0 -> den <> 0 -> den' <> 0 -> det a b p = 0 ->
  value_in_perspective a b c p ua ub uc num den ->
  value_in_perspective b a d p ub ua ud num' den' -> num * den' = num' * den.
Proof.
  intros D D' N N' E V V'.
  apply value_is_the_quotient in V as [H V]; [|assumption..].
  apply value_is_the_quotient in V' as [H' V']; [|assumption..].
  (* Three terms that add to 0, of which the first is 0. *)
  assert (P : det b c p * det a d p = det c a p * det d b p).
  { assert (I : det a b p * det c d p - det a c p * det b d p + det a d p * det b c p = 0).
    { unfold det. ring. }
    rewrite E in I. replace (det c a p) with (- det a c p) by (unfold det; ring).
    replace (det d b p) with (- det b d p) by (unfold det; ring). lia. }
  assert (E' : det b a p = 0) by (unfold det in *; lia).
  unfold horizon, combined, beta_a, beta_b, beta_c in *. rewrite E in *. rewrite E' in *.
  set (x := det b c p) in *. set (y := det c a p) in *.
  set (x' := det d b p) in *. set (y' := det a d p) in *.
  assert (K : (x * ua + y * ub) * (x' + y') = (x' * ua + y' * ub) * (x + y)).
  { apply Z.sub_move_0_r. transitivity ((x * y' - y * x') * (ua - ub)); [ring|]. rewrite P. ring. }
  apply (Z.mul_reg_r _ _ ((x + y) * (x' + y'))); [nia|].
  transitivity (num * (x * 1 + y * 1 + 0 * 1) * (den' * (x' + y'))); [ring|]. rewrite V.
  transitivity (den * (num' * (y' * 1 + x' * 1 + 0 * 1)) * (x + y)); [|ring]. rewrite V'.
  transitivity (den * den' * ((x * ua + y * ub) * (x' + y'))); [ring|]. rewrite K. ring.
Qed.

(** Numerators and denominators are linear in the ray: a / w is affine on the screen. *)
Theorem factors_are_linear a b c p s k ua ub uc :
  combined a b c (vertex_plus p (vertex_times k s)) ua ub uc
  = combined a b c p ua ub uc + k * combined a b c s ua ub uc.
Proof. open_values. ring. Qed.

(** From p to p + k s the value changes by k times the slope over both denominators: exactly, for
    any k. As the second one goes to the first, this is the derivative. *)
Theorem values_differ_by_the_slope a b c p s k ua ub uc :
  let q := vertex_plus p (vertex_times k s) in
  combined a b c q ua ub uc * horizon a b c p - combined a b c p ua ub uc * horizon a b c q
  = k * slope a b c p s ua ub uc.
Proof.
  intros q. unfold slope. unfold horizon at 1 2 3 4. unfold q. rewrite !factors_are_linear. ring.
Qed.

(** Where all w are equal, perspective is linear on the screen. *)
Theorem equal_w_is_linear a b c p ua ub uc num den : det a b c <> 0 -> den <> 0 -> vw p <> 0 ->
  vw a <> 0 -> vw b = vw a -> vw c = vw a ->
  value_in_perspective a b c p ua ub uc num den <-> value_on_screen a b c p ua ub uc num den.
Proof.
  intros D N P W B C.
  rewrite value_is_the_quotient, screen_value_is_the_quotient by congruence.
  rewrite <- screen_factors_sum.
  assert (S : forall x y z, on_screen a b c p x y z = vw a * combined a b c p x y z).
  { intros. unfold on_screen, combined. rewrite B, C. ring. }
  assert (H : vw a * horizon a b c p = det a b c * vw p).
  { rewrite <- screen_factors_sum, S. reflexivity. }
  rewrite !S. unfold horizon in *. split.
  - intros [_ V]. transitivity (vw a * (num * combined a b c p 1 1 1)); [ring|]. rewrite V. ring.
  - intros V. split; [nia|]. apply (Z.mul_reg_l _ _ (vw a) W).
    transitivity (num * (vw a * combined a b c p 1 1 1)); [ring|]. rewrite V. ring.
Qed.

Definition near := Vertex 0 0 1.
Definition middle := Vertex 8 0 2.
Definition far := Vertex 0 16 4.

(** At the ray (2, 1, 1) the screen's weights are 1/4, 1/2, 1/4. *)
Example perspective_is_not_affine :
  value_in_perspective near middle far (Vertex 2 1 1) 0 8 0 32 9
  /\ value_on_screen near middle far (Vertex 2 1 1) 0 8 0 4 1.
Proof.
  split.
  - apply value_is_the_quotient; [discriminate..|]. vm_compute. split; [discriminate|reflexivity].
  - apply screen_value_is_the_quotient; [discriminate..|]. vm_compute. reflexivity.
Qed.

Example behind_the_eye : value_in_perspective (Vertex 0 0 (-1)) middle far (Vertex 2 1 1) 0 8 0
  (combined (Vertex 0 0 (-1)) middle far (Vertex 2 1 1) 0 8 0)
  (horizon (Vertex 0 0 (-1)) middle far (Vertex 2 1 1)).
Proof.
  apply value_is_the_quotient; [discriminate..|]. vm_compute. split; [discriminate|reflexivity].
Qed.
