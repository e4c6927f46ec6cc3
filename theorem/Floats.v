(** Where stepping in floating point is exact: all coordinates are multiples of 2^-s in a box of
    side W, in units of 2^-s, and W^2 <= 2^prec. This is the only file about real numbers: it rests
    on the axioms that Coq's standard library has for them. *)
From Rasterproof Require Import Specification Numbers.
From Flocq Require Import Core.
From Coq Require Import Reals Lia Lra.
Local Open Scope Z_scope.

Section Format.
Variables prec emin : Z.
Context {prec_positive : Prec_gt_0 prec}.
(** How it rounds does not matter. *)
Variable rnd : R -> Z.
Context {valid : Valid_rnd rnd}.

Notation format := (generic_format radix2 (FLT_exp emin prec)).
Notation rounded := (round radix2 (FLT_exp emin prec) rnd).

(** n steps of 2^e *)
Definition on (e n : Z) : R := (IZR n * bpow radix2 e)%R.

Lemma in_format e n : emin <= e -> Z.abs n <= 2 ^ prec -> format (on e n).
Proof.
  intros E N. destruct (Z.eq_dec (Z.abs n) (2 ^ prec)) as [P|P].
  - pose proof prec_positive as G. unfold Prec_gt_0 in G.
    assert (Q : format (bpow radix2 (prec + e))).
    { apply generic_format_bpow. unfold FLT_exp. lia. }
    unfold on. destruct (Z.abs_eq_or_opp n) as [A|A].
    + replace n with (2 ^ prec) by lia. rewrite bpow_plus in Q. rewrite <- IZR_Zpower in Q by lia.
      exact Q.
    + replace n with (- 2 ^ prec) by lia. rewrite opp_IZR, Ropp_mult_distr_l_reverse.
      apply generic_format_opp. rewrite bpow_plus in Q. rewrite <- IZR_Zpower in Q by lia. exact Q.
  - apply generic_format_FLT. exists (Float radix2 n e).
    + reflexivity.
    + cbn [Fnum]. change (Z.pow_pos 2) with (Z.pow_pos radix2). cbn. lia.
    + assumption.
Qed.

Lemma rounds_to_itself e n : emin <= e -> Z.abs n <= 2 ^ prec -> rounded (on e n) = on e n.
Proof. intros. apply round_generic; auto using in_format. Qed.

Lemma on_plus e m n : (on e m + on e n)%R = on e (m + n).
Proof. unfold on. rewrite plus_IZR. ring. Qed.
Lemma on_minus e m n : (on e m - on e n)%R = on e (m - n).
Proof. unfold on. rewrite minus_IZR. ring. Qed.
Lemma on_times e f m n : (on e m * on f n)%R = on (e + f) (m * n).
Proof. unfold on. rewrite mult_IZR, bpow_plus. ring. Qed.

(** ** What a kernel computes: each operation rounded *)

Variable s : Z.  (** bits below the pixel *)
Definition coordinate (n : Z) : R := on (- s) n.

Definition float_edge (a b p : point) : R :=
  rounded (rounded (rounded (coordinate (px b) - coordinate (px a))
                    * rounded (coordinate (py p) - coordinate (py a)))
           - rounded (rounded (coordinate (py b) - coordinate (py a))
                      * rounded (coordinate (px p) - coordinate (px a)))).

(** A step of l along x or y adds one product to the value, which is rounded again. *)
Inductive step := Along_x (l : Z) | Along_y (l : Z).
Definition move (d : step) : point :=
  match d with Along_x l => Point l 0 | Along_y l => Point 0 l end.
Definition float_increment (a b : point) (d : step) : R :=
  match d with
  | Along_x l => rounded (coordinate l * rounded (coordinate (py a) - coordinate (py b)))
  | Along_y l => rounded (coordinate l * rounded (coordinate (px b) - coordinate (px a)))
  end.
Definition float_stepped (a b : point) (start : R) (l : list step) : R :=
  fold_left (fun v d => rounded (v + float_increment a b d)) l start.
(** A product for the index in place of additions. *)
Definition float_indexed (a b : point) (start : R) (d : step) : R :=
  rounded (start + float_increment a b d).
Definition float_fused (a b : point) (start : R) (d : step) : R :=
  match d with
  | Along_x l => rounded (start + coordinate l * rounded (coordinate (py a) - coordinate (py b)))
  | Along_y l => rounded (start + coordinate l * rounded (coordinate (px b) - coordinate (px a)))
  end.

(** ** The box *)

Variables (W : Z) (corner : point).
Definition in_box (p : point) : Prop :=
  px corner <= px p <= px corner + W /\ py corner <= py p <= py corner + W.
(** All points that are passed, the last included. *)
Fixpoint passes (p : point) (l : list step) : Prop :=
  in_box p /\ match l with [] => True | d :: k => passes (plus p (move d)) k end.

Hypothesis fits : W * W <= 2 ^ prec.
Hypothesis fine : emin <= - s + - s.
Hypothesis not_below : 0 <= s.

Lemma affine c k t : 0 <= t <= W -> Z.abs c <= W * W -> Z.abs (c + k * W) <= W * W ->
  Z.abs (c + k * t) <= W * W.
Proof. intros. destruct (Z.le_gt_cases 0 k); nia. Qed.

(** An edge function takes its extremes at corners of the box. *)
Lemma edge_in_box a b p : in_box a -> in_box b -> in_box p -> Z.abs (edge a b p) <= W * W.
Proof.
  unfold in_box. intros A B P. set (x := px a - px corner). set (y := py a - py corner).
  set (u := px b - px corner). set (v := py b - py corner). set (z := px p - px corner).
  set (w := py p - py corner).
  replace (edge a b p) with (x * (v - w) + u * (w - y) + z * (y - v))
    by (unfold edge, x, y, u, v, z, w; ring).
  assert (0 <= x <= W) by (unfold x; lia). assert (0 <= y <= W) by (unfold y; lia).
  assert (0 <= u <= W) by (unfold u; lia). assert (0 <= v <= W) by (unfold v; lia).
  assert (0 <= z <= W) by (unfold z; lia). assert (0 <= w <= W) by (unfold w; lia).
  clearbody x y u v z w. clear A B P.
  assert (D : forall i j, 0 <= i <= W -> 0 <= j <= W -> Z.abs (W * (i - j)) <= W * W)
    by (intros; nia).
  assert (E : forall i j k, (i = 0 \/ i = W) -> (j = 0 \/ j = W) -> (k = 0 \/ k = W) ->
    Z.abs (i * (v - w) + j * (w - y) + k * (y - v)) <= W * W).
  { intros i j k [->| ->] [->| ->] [->| ->];
      match goal with |- Z.abs ?t <= _ =>
        first [replace t with 0 by ring; nia
              |replace t with (W * (v - w)) by ring; apply D; assumption
              |replace t with (W * (w - y)) by ring; apply D; assumption
              |replace t with (W * (y - v)) by ring; apply D; assumption
              |replace t with (W * (v - y)) by ring; apply D; assumption
              |replace t with (W * (w - v)) by ring; apply D; assumption
              |replace t with (W * (y - w)) by ring; apply D; assumption] end. }
  assert (F : forall j k, (j = 0 \/ j = W) -> (k = 0 \/ k = W) ->
    Z.abs (x * (v - w) + j * (w - y) + k * (y - v)) <= W * W).
  { intros j k J K. replace (x * (v - w) + j * (w - y) + k * (y - v))
      with (j * (w - y) + k * (y - v) + (v - w) * x) by ring.
    apply affine; [assumption| |].
    - replace (j * (w - y) + k * (y - v)) with (0 * (v - w) + j * (w - y) + k * (y - v)) by ring.
      apply E; auto.
    - replace (j * (w - y) + k * (y - v) + (v - w) * W)
        with (W * (v - w) + j * (w - y) + k * (y - v)) by ring. apply E; auto. }
  assert (G : forall k, (k = 0 \/ k = W) ->
    Z.abs (x * (v - w) + u * (w - y) + k * (y - v)) <= W * W).
  { intros k K. replace (x * (v - w) + u * (w - y) + k * (y - v))
      with (x * (v - w) + k * (y - v) + (w - y) * u) by ring.
    apply affine; [assumption| |].
    - replace (x * (v - w) + k * (y - v)) with (x * (v - w) + 0 * (w - y) + k * (y - v)) by ring.
      apply F; auto.
    - replace (x * (v - w) + k * (y - v) + (w - y) * W)
        with (x * (v - w) + W * (w - y) + k * (y - v)) by ring. apply F; auto. }
  replace (x * (v - w) + u * (w - y) + z * (y - v))
    with (x * (v - w) + u * (w - y) + (y - v) * z) by ring.
  apply affine; [assumption| |].
  - replace (x * (v - w) + u * (w - y)) with (x * (v - w) + u * (w - y) + 0 * (y - v)) by ring.
    apply G; auto.
  - replace (x * (v - w) + u * (w - y) + (y - v) * W)
      with (x * (v - w) + u * (w - y) + W * (y - v)) by ring. apply G; auto.
Qed.

Lemma difference_in_box m n : - W <= m - n <= W ->
  rounded (coordinate m - coordinate n) = coordinate (m - n).
Proof.
  intros D. unfold coordinate. rewrite on_minus. apply rounds_to_itself; [lia|]. nia.
Qed.

(** The value in units of 2^-2s, exactly. *)
Definition value (n : Z) : R := on (- s + - s) n.

Lemma product_in_box m n : - W <= m <= W -> - W <= n <= W ->
  rounded (coordinate m * coordinate n) = value (m * n).
Proof.
  intros M N. unfold coordinate, value. rewrite on_times. apply rounds_to_itself; [lia|]. nia.
Qed.

Theorem float_edge_is_exact a b p : in_box a -> in_box b -> in_box p ->
  float_edge a b p = value (edge a b p).
Proof.
  intros A B P. pose proof (edge_in_box a b p A B P) as E. unfold float_edge, in_box in *.
  rewrite !difference_in_box, !product_in_box by lia. unfold value. rewrite on_minus.
  apply rounds_to_itself; [assumption|]. unfold edge in *. lia.
Qed.

Lemma increment_is_exact a b p d : in_box a -> in_box b -> in_box p -> in_box (plus p (move d)) ->
  float_increment a b d = value (edge a b (plus p (move d)) - edge a b p).
Proof.
  intros A B P Q. unfold float_increment, in_box in *.
  destruct d as [l|l]; unfold move, plus in *; cbn [px py] in *;
    (rewrite difference_in_box, product_in_box by lia); f_equal; unfold edge; cbn [px py]; ring.
Qed.

Theorem float_stepped_is_exact a b p l : in_box a -> in_box b -> passes p l ->
  float_stepped a b (float_edge a b p) l = value (edge a b (walk p (map move l))).
Proof.
  intros A B. revert p. induction l as [|d l IH]; intros p H.
  - destruct H as [P _]. apply float_edge_is_exact; assumption.
  - destruct H as [P H]. assert (Q : in_box (plus p (move d))) by (destruct l; apply H).
    unfold float_stepped in *. cbn [fold_left map].
    rewrite (increment_is_exact a b p d), float_edge_is_exact by assumption. unfold value at 1 2.
    rewrite on_plus.
    replace (edge a b p + (edge a b (plus p (move d)) - edge a b p))
      with (edge a b (plus p (move d))) by ring.
    rewrite rounds_to_itself by (assumption || pose proof (edge_in_box a b _ A B Q); lia).
    change (on (- s + - s)) with value.
    rewrite <- float_edge_is_exact by assumption. apply IH. assumption.
Qed.

(** Stepped is direct, the same number, at every point that is passed. *)
Theorem float_stepped_is_direct a b p l : in_box a -> in_box b -> passes p l ->
  float_stepped a b (float_edge a b p) l = float_edge a b (walk p (map move l)).
Proof.
  intros A B H. rewrite float_stepped_is_exact by assumption. symmetry.
  apply float_edge_is_exact; try assumption. revert p H. induction l as [|d l IH]; intros p H.
  - apply H.
  - apply (IH (plus p (move d))). apply H.
Qed.

Theorem float_indexed_is_direct a b p d : in_box a -> in_box b -> in_box p ->
  in_box (plus p (move d)) ->
  float_indexed a b (float_edge a b p) d = float_edge a b (plus p (move d))
  /\ float_fused a b (float_edge a b p) d = float_edge a b (plus p (move d)).
Proof.
  intros A B P Q. pose proof (float_stepped_is_direct a b p [d] A B (conj P (conj Q I))) as S.
  split; [exact S|]. cbn in S. rewrite <- S.
  pose proof (increment_is_exact a b p d A B P Q) as E. unfold float_fused, in_box in *.
  destruct d as [l|l]; cbn [float_increment] in *; unfold move, plus in *; cbn [px py] in *;
    rewrite difference_in_box in * by lia; rewrite product_in_box in * by lia;
    unfold coordinate at 1 2; rewrite on_times; reflexivity.
Qed.

(** No value is near the largest float: it is at most 2^prec in size. *)
Theorem float_values_are_small a b p : in_box a -> in_box b -> in_box p ->
  (Rabs (float_edge a b p) <= IZR (2 ^ prec))%R.
Proof.
  intros A B P. rewrite float_edge_is_exact by assumption. unfold value, on.
  rewrite Rabs_mult, <- abs_IZR, (Rabs_pos_eq (bpow _ _)) by apply bpow_ge_0.
  assert (M : (IZR (Z.abs (edge a b p)) <= IZR (2 ^ prec))%R).
  { apply IZR_le. pose proof (edge_in_box a b p A B P). lia. }
  assert (S : (bpow radix2 (- s + - s) <= bpow radix2 0)%R) by (apply bpow_le; lia).
  cbn in S. pose proof (bpow_ge_0 radix2 (- s + - s)).
  assert (0 <= IZR (Z.abs (edge a b p)))%R by (apply IZR_le; lia).
  rewrite <- (Rmult_1_r (IZR (2 ^ prec))). apply Rmult_le_compat; assumption.
Qed.

(** Beyond 2^prec odd integers are no floats: so is E one unit beyond the sizes below. *)
Lemma odd_not_in_format n : Z.odd n = true -> 2 ^ prec < Z.abs n -> ~ format (IZR n).
Proof.
  intros O N F. apply FLT_format_generic in F; [|assumption].
  destruct F as [[m e] X M _]. cbn [Fnum] in M. unfold F2R in X; cbn [Fnum Fexp] in X.
  destruct (Z.le_gt_cases e 0) as [E|E].
  - assert (B : (bpow radix2 e <= 1)%R) by (apply (bpow_le radix2 e 0 E)).
    assert (Y : (Rabs (IZR n) <= Rabs (IZR m))%R).
    { rewrite X, Rabs_mult, (Rabs_pos_eq (bpow _ _)) by apply bpow_ge_0.
      rewrite <- (Rmult_1_r (Rabs (IZR m))) at 2. apply Rmult_le_compat_l;
        [apply Rabs_pos|assumption]. }
    rewrite <- !abs_IZR in Y. apply le_IZR in Y.
    change (Z.pow radix2 prec) with (2 ^ prec) in M. lia.
  - rewrite <- IZR_Zpower, <- mult_IZR in X by lia. apply eq_IZR in X.
    replace e with (1 + (e - 1)) in X by lia. rewrite Z.pow_add_r in X by lia.
    change (radix_val radix2) with 2 in X. rewrite X in O.
    replace (m * (2 ^ 1 * 2 ^ (e - 1))) with (2 * (m * 2 ^ (e - 1))) in O by ring.
    rewrite Z.odd_mul in O. discriminate.
Qed.

Lemma float_edge_in_format a b p : format (float_edge a b p).
Proof. apply generic_format_round; exact _. Qed.

End Format.

(** ** binary32 and binary64 *)

#[export] Instance prec_24 : Prec_gt_0 24 := eq_refl.
#[export] Instance prec_53 : Prec_gt_0 53 := eq_refl.

Theorem binary32_stepped_is_direct rnd {valid : Valid_rnd rnd} s corner a b p l : 0 <= s <= 74 ->
  in_box 4096 corner a -> in_box 4096 corner b -> passes 4096 corner p l ->
  float_stepped 24 (-149) rnd s a b (float_edge 24 (-149) rnd s a b p) l
  = float_edge 24 (-149) rnd s a b (walk p (map move l)).
Proof. intros S. apply float_stepped_is_direct; try exact _; lia. Qed.

Theorem binary64_stepped_is_direct rnd {valid : Valid_rnd rnd} s corner a b p l : 0 <= s <= 537 ->
  in_box 94906265 corner a -> in_box 94906265 corner b -> passes 94906265 corner p l ->
  float_stepped 53 (-1074) rnd s a b (float_edge 53 (-1074) rnd s a b p) l
  = float_edge 53 (-1074) rnd s a b (walk p (map move l)).
Proof. intros S. apply float_stepped_is_direct; try exact _; lia. Qed.

(** One unit more, and E is not exact. *)
Theorem binary32_box_is_sharp rnd {valid : Valid_rnd rnd} :
  let a := Point 0 0 in let b := Point 0 4097 in let p := Point 4097 0 in
  float_edge 24 (-149) rnd 0 a b p <> value 0 (edge a b p).
Proof.
  cbn zeta. intros E. pose proof (float_edge_in_format 24 (-149) rnd 0 (Point 0 0) (Point 0 4097)
    (Point 4097 0)) as F.
  rewrite E in F. unfold value, on in F. cbn [bpow Z.opp Z.add] in F. rewrite Rmult_1_r in F.
  revert F. apply odd_not_in_format; [exact _|reflexivity|vm_compute; reflexivity].
Qed.

Theorem binary64_box_is_sharp rnd {valid : Valid_rnd rnd} :
  let a := Point 0 0 in let b := Point 1 94906266 in let p := Point 94906266 1 in
  float_edge 53 (-1074) rnd 0 a b p <> value 0 (edge a b p).
Proof.
  cbn zeta. intros E. pose proof (float_edge_in_format 53 (-1074) rnd 0 (Point 0 0)
    (Point 1 94906266) (Point 94906266 1)) as F.
  rewrite E in F. unfold value, on in F. cbn [bpow Z.opp Z.add] in F. rewrite Rmult_1_r in F.
  revert F. apply odd_not_in_format; [exact _|vm_compute; reflexivity|vm_compute; reflexivity].
Qed.

(** A walk that satisfies what they assume. *)
Example a_walk_is_a_case :
  let a := Point 0 0 in let b := Point 8 3 in let p := Point 1 1 in
  let l := [Along_x 2; Along_y 3; Along_x (-1)] in
  in_box 4096 origin a /\ in_box 4096 origin b /\ passes 4096 origin p l
  /\ edge a b (walk p (map move l)) = 26.
Proof. unfold passes, in_box, walk, edge; cbn. lia. Qed.
