(** Signed coverage is the winding number of the outline; what follows from it for meshes. *)
From Rasterproof Require Import Specification Boundary Winding.
From Coq Require Import Lia.

(** What a rule says of an edge of length zero does not matter: only flat triangles have one. *)
Definition normal (r : tie_rule) (d : point) : bool := negb ((px d =? 0) && (py d =? 0)) && r d.

Lemma normal_same r d : d <> origin -> normal r d = r d.
Proof.
  intros N. unfold normal. destruct (Z.eqb_spec (px d) 0), (Z.eqb_spec (py d) 0); try reflexivity.
  elim N. apply point_ext; assumption.
Qed.

Lemma normal_half r : half_circle r -> half_circle_0 (normal r).
Proof.
  intros [O S]. split; [split|reflexivity].
  - intros d N. assert (M : times (-1) d <> origin).
    { intros E. apply N. apply point_ext; [apply (f_equal px) in E|apply (f_equal py) in E];
        unfold times, origin in *; cbn [px py] in *; lia. }
    rewrite !normal_same by assumption. apply O; assumption.
  - intros d e D E. rewrite (normal_same r d), (normal_same r e) by assumption. intros A B.
    rewrite normal_same; [apply S; assumption|]. intros Z.
    assert (N : e = times (-1) d).
    { apply point_ext; [apply (f_equal px) in Z|apply (f_equal py) in Z];
        unfold plus, times, origin in *; cbn [px py] in *; lia. }
    rewrite N, O, A in B by assumption. discriminate.
Qed.

Lemma edge_distinct a b p : edge a b p <> 0 -> minus a b <> origin /\ minus b a <> origin.
Proof.
  intros N. split; intros E; apply N; apply (f_equal px) in E as X; apply (f_equal py) in E as Y;
    unfold minus, origin, edge in *; cbn [px py] in *.
  - replace (px a) with (px b) by lia. replace (py a) with (py b) by lia. ring.
  - replace (px a) with (px b) by lia. replace (py a) with (py b) by lia. ring.
Qed.

Lemma signed_same r s t p : (forall d, d <> origin -> r d = s d) -> signed r t p = signed s t p.
Proof.
  intros H. destruct t as [a b c]. unfold signed, area, covers, turned.
  cbn [corner_a corner_b corner_c].
  destruct (Z.eq_dec (edge a b c) 0) as [Z|N]; [rewrite Z; reflexivity|].
  pose proof (edge_distinct a b c N).
  pose proof (edge_distinct b c a ltac:(replace (edge b c a) with (edge a b c) by (unfold edge;
    ring);
    assumption)).
  pose proof (edge_distinct c a b ltac:(replace (edge c a b) with (edge a b c) by (unfold edge;
    ring);
    assumption)).
  assert (I : forall u v, minus v u <> origin -> inside r u v p = inside s u v p).
  { intros u v D. unfold inside. rewrite H by assumption. reflexivity. }
  rewrite !I by tauto. reflexivity.
Qed.

Lemma coverage_is_turns r m p : half_circle r ->
  signed_coverage r m p = sum (turn (normal r) p) (boundary m).
Proof.
  intros H. unfold signed_coverage. rewrite sum_boundary. apply sum_ext. intros t _.
  rewrite (signed_same r (normal r)) by (intros; symmetry; apply normal_same; assumption).
  apply triangle_is_its_boundary, normal_half, H.
Qed.

(** Any mesh, any half-circle, any sample that is on no edge of the outline. *)
Theorem coverage_is_winding r m c p : half_circle r -> outline m c -> off c p ->
  signed_coverage r m p = winding c p.
Proof.
  intros H C O. pose proof (normal_half r H) as N. rewrite coverage_is_turns by assumption.
  rewrite (winding_is_turns (normal r)) by eauto using outline_is_closed.
  apply sum_outline with (1 := turn_reverse (normal r) p) (2 := C).
Qed.

(** Samples on the outline included: the outline alone decides. *)
Theorem same_outline_same_coverage r m n c p : half_circle r -> outline m c -> outline n c ->
  signed_coverage r m p = signed_coverage r n p.
Proof.
  intros H M N. rewrite !coverage_is_turns by assumption.
  rewrite (sum_outline _ _ _ (turn_reverse (normal r) p) M).
  symmetry. apply (sum_outline _ _ _ (turn_reverse (normal r) p) N).
Qed.

Theorem closed_meshes_cancel r m p : half_circle r -> outline m [] -> signed_coverage r m p = 0.
Proof. intros H M. rewrite (coverage_is_winding r m [] p H M); [reflexivity|constructor]. Qed.

Lemma owners_signed r m p : positive m -> owners r m p = signed_coverage r m p.
Proof.
  intros P. apply sum_ext. intros t I. unfold positive in P. rewrite Forall_forall in P.
  unfold signed. rewrite (proj2 (Z.ltb_lt 0 (area t))) by (apply P; assumption). reflexivity.
Qed.

Theorem half_circle_partitions r : half_circle r -> partitions r.
Proof.
  intros H m c p P O F W. rewrite owners_signed, <- W by assumption.
  apply coverage_is_winding; assumption.
Qed.

(** ** Order, rotation, reversal, splitting *)

Theorem order_changes_nothing r m n p : Permutation m n -> signed_coverage r m p = signed_coverage
  r n p.
Proof. apply sum_permutation. Qed.

Theorem rotation_changes_nothing r a b c p :
  signed r (Triangle b c a) p = signed r (Triangle a b c) p.
Proof. apply signed_rotated. Qed.

Theorem reversal_changes_the_sign r t p : signed r (turned t) p = - signed r t p.
Proof. apply signed_turned. Qed.

(** A triangle that is split at a point of the line through an edge. *)
Theorem splitting_changes_nothing r a b c d p : half_circle r -> edge a b d = 0 ->
  signed_coverage r [Triangle a d c; Triangle d b c] p = signed_coverage r [Triangle a b c] p.
Proof.
  intros H D. assert (F : signed r (Triangle a d b) p = 0).
  { unfold signed, area; cbn [corner_a corner_b corner_c].
    replace (edge a d b) with (- edge a b d) by (unfold edge; ring). rewrite D. reflexivity. }
  assert (E : signed_coverage r [Triangle a d c; Triangle d b c] p
    = signed_coverage r [Triangle a b c; Triangle a d b] p).
  { rewrite !coverage_is_turns by assumption. unfold boundary, triangle_boundary.
    cbn [flat_map app corner_a corner_b corner_c]. sums.
    pose proof (turn_reverse (normal r) p (d, c)) as X. pose proof (turn_reverse (normal r) p (b,
      a)) as Y.
    unfold reverse in *; cbn [fst snd] in *. lia. }
  rewrite E. unfold signed_coverage. sums. lia.
Qed.

(** ** What a winding number has to be *)

Theorem winding_reversed c p : closed c -> off c p -> winding (map reverse c) p = - winding c p.
Proof.
  intros C O.
  assert (OR : off (map reverse c) p).
  { apply Forall_forall. intros e I. apply in_map_iff in I as ([a b] & <- & I). unfold reverse; cbn.
    intros [E D]. apply (off_in c p a b O I). split; [rewrite edge_turned; lia|lia]. }
  unfold winding. rewrite sum_map, <- sum_opposite. apply sum_ext. intros [a b] I.
  pose proof (crossing_is_turn p a b (off_in c p a b O I)) as X.
  pose proof (crossing_is_turn p b a (off_in _ p b a OR (in_map reverse _ _ I))) as Y.
  unfold reverse; cbn [fst snd]. rewrite X, Y. apply (turn_reverse to_the_right p (a, b)).
Qed.

Definition scaled (k : Z) (c : chain) : chain := map (fun e => (times k (fst e),
  times k (snd e))) c.

Theorem winding_scaled k c p : 0 < k -> winding (scaled k c) (times k p) = winding c p.
Proof.
  intros K. unfold winding, scaled. rewrite sum_map. apply sum_ext. intros [a b] _.
  unfold crossing; cbn [fst snd].
  replace (edge (times k a) (times k b) (times k p)) with (k * k * edge a b p)
    by (unfold edge, times; cbn [px py]; ring).
  unfold times; cbn [px py]. generalize (edge a b p). intros e.
  assert (0 < k * k) by nia.
  assert (L : forall u v, (k * u <=? k * v) = (u <=? v)).
  { intros. destruct (Z.leb_spec u v), (Z.leb_spec (k * u) (k * v)); try reflexivity; nia. }
  assert (M : forall u v, (k * u <? k * v) = (u <? v)).
  { intros. destruct (Z.ltb_spec u v), (Z.ltb_spec (k * u) (k * v)); try reflexivity; nia. }
  rewrite !L, !M.
  assert ((0 <? k * k * e) = (0 <? e)) as -> by
    (destruct (Z.ltb_spec 0 e), (Z.ltb_spec 0 (k * k * e)); try reflexivity; nia).
  assert ((k * k * e <? 0) = (e <? 0)) as -> by
    (destruct (Z.ltb_spec e 0), (Z.ltb_spec (k * k * e) 0); try reflexivity; nia).
  reflexivity.
Qed.

(** Left of, right of, above and below all corners it is 0. *)
Definition all_corners (P : point -> Prop) (c : chain) := Forall (fun e => P (fst e) /\ P (snd e))
  c.

Theorem winding_far c p : closed c ->
  all_corners (fun v => px v < px p) c \/ all_corners (fun v => px p < px v) c
  \/ all_corners (fun v => py v < py p) c \/ all_corners (fun v => py p < py v) c ->
  winding c p = 0.
Proof.
  intros C F. transitivity (sum (fun e : directed => 0) c); [|apply sum_zero; reflexivity].
  unfold all_corners in F. rewrite !Forall_forall in F.
  assert (right : (forall e, In e c -> px p < px (fst e) /\ px p < px (snd e)) ->
    winding c p = sum (fun _ => 0) c).
  { intros G. apply sum_closed with (h := fun v => Z.b2z (py p <? py v)); [assumption|].
    intros a b I. destruct (G _ I) as [A B]. unfold crossing; cbn [fst snd] in *.
    assert (py a <= py p < py b -> 0 < edge a b p) by (unfold edge; nia).
    assert (py b <= py p < py a -> edge a b p < 0) by (unfold edge; nia).
    decide_all; simpl; lia. }
  destruct F as [F|[F|[F|F]]]; [|auto| |]; apply sum_ext; intros [a b] I; destruct (F _ I) as [A B];
    unfold crossing; cbn [fst snd] in *.
  - assert (py a <= py p < py b -> edge a b p < 0) by (unfold edge; nia).
    assert (py b <= py p < py a -> 0 < edge a b p) by (unfold edge; nia).
    decide_all; simpl; lia.
  - decide_all; simpl; lia.
  - decide_all; simpl; lia.
Qed.
