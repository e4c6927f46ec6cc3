(** A half-circle is, on a finite mesh, an infinitesimal shift of the sample;
    so a sample on the outline
    counts what the winding number is just beside it. The shift by e*u with e = n/m is written
      without
    fractions: m*p + n*u among corners m*a. *)
From Rasterproof Require Import Specification Boundary Winding Coverage Partition Rules.
From Coq Require Import Lia.

Definition moved (m n : Z) (u p : point) : point := plus (times m p) (times n u).

Lemma edge_moved m n u a b p :
  edge (times m a) (times m b) (moved m n u p) = m * (m * edge a b p + n * cross (minus b a) u).
Proof. unfold edge, moved, cross, minus, plus, times; cbn [px py]; ring. Qed.

(** Of owned directions, one has all others on one side. *)
Lemma extreme r l : half_circle_0 r -> Forall (fun d => r d = true) l -> l <> [] ->
  exists w, r w = true /\ Forall (fun d => 0 <= cross d w) l.
Proof.
  intros H. induction l as [|d l IH]; [congruence|]. intros F _. inversion F as [|? ? D L]; subst.
  destruct l as [|e l].
  { exists d. split; [assumption|]. constructor; [unfold cross; lia|constructor]. }
  destruct IH as (w & W & A); [assumption|discriminate|].
  destruct (Z.leb_spec 0 (cross d w)) as [P|N].
  { exists w. split; [assumption|]. constructor; assumption. }
  exists d. split; [assumption|]. constructor; [unfold cross; lia|].
  rewrite Forall_forall in *. intros f I. specialize (A f I). specialize (L f I).
  apply Z.nlt_ge. intros C. simpl in *.
  apply (owned_combination r H (cross f w) (- cross d w) (- cross f d) d f w); auto; try lia.
  unfold cross, plus, times, origin; cbn [px py]. f_equal; ring.
Qed.

Lemma bound {A} (f : A -> Z) l : exists k, 0 < k /\ Forall (fun e => Z.abs (f e) < k) l.
Proof.
  induction l as [|e l (k & K & F)]; [exists 1; split; [lia|constructor]|].
  exists (k + Z.abs (f e)). split; [lia|]. constructor; [lia|].
  eapply Forall_impl; [|exact F]. intros; simpl in *; lia.
Qed.

Lemma shift_of_owned r l : half_circle_0 r -> Forall (fun d => r d = true) l ->
  exists u, Forall (fun d => 0 < cross d u) l.
Proof.
  intros H F. destruct l as [|d l]; [exists origin; constructor|].
  destruct (extreme r (d :: l) H F) as (w & W & A); [discriminate|].
  destruct (bound (fun e => dot e w) (d :: l)) as (k & K & B).
  exists (plus (times k w) (Point (- py w) (px w))).
  rewrite Forall_forall in *. intros e I. specialize (A e I). specialize (B e I).
  specialize (F e I).
  simpl in *.
  replace (cross e (plus (times k w) (Point (- py w) (px w)))) with (k * cross e w + dot e w)
    by (unfold cross, dot, plus, times; cbn [px py]; ring).
  destruct (Z.eq_dec (cross e w) 0) as [Z|N]; [|nia].
  enough (0 < dot e w) by lia. apply Z.nle_gt. intros D.
  pose proof (nonzero w (owned_not_origin r H w W)) as Q.
  apply (owned_combination r H (dot w w) (- dot e w) 0 e w w); auto; try lia.
  unfold cross, dot, plus, times, origin in *; cbn [px py] in *.
  f_equal.
  - apply (f_equal (Z.mul (py w))) in Z. lia.
  - apply (f_equal (Z.mul (px w))) in Z. lia.
Qed.

(** The directions of a finite mesh cannot tell a half-circle from a shift. *)
Theorem half_circle_is_a_shift r l : half_circle r -> exists u, u <> origin /\
  Forall (fun d => d <> origin -> if r d then 0 < cross d u else cross d u < 0) l.
Proof.
  intros H. pose proof (normal_half r H) as N.
  set (owned := fun d => if normal r d then d else times (-1) d).
  assert (O : forall d, d <> origin -> normal r (owned d) = true).
  { intros d D. unfold owned. destruct (normal r d) eqn:E; [assumption|].
    rewrite (owned_opposite _ N), E by assumption. reflexivity. }
  set (unit := Point 1 0). assert (U : unit <> origin) by discriminate.
  destruct (shift_of_owned (normal r)
    (map owned (unit :: filter (fun d => negb ((px d =? 0) && (py d =? 0))) l)) N) as (u & F).
  { rewrite Forall_forall. intros e I. apply in_map_iff in I as (d & <- & I). apply O.
    destruct I as [<-|I]; [assumption|]. apply filter_In in I as [_ I]. intros ->. discriminate. }
  rewrite Forall_forall in F. exists u. split.
  { intros ->. assert (X : 0 < cross (owned unit) origin) by (apply F, in_map; left; reflexivity).
    unfold cross, origin in X; cbn [px py] in X. lia. }
  apply Forall_forall. intros d I D. specialize (F (owned d)).
  assert (I' : In d (filter (fun d => negb ((px d =? 0) && (py d =? 0))) l)).
  { apply filter_In. split; [assumption|]. destruct (Z.eqb_spec (px d) 0), (Z.eqb_spec (py d) 0);
      try reflexivity. elim D. apply point_ext; assumption. }
  specialize (F ltac:(apply in_map; right; assumption)). unfold owned in F.
  rewrite normal_same in F by assumption.
  destruct (r d); [assumption|]. unfold cross, times in *; cbn [px py] in F. lia.
Qed.

(** ** All shifts that are small enough *)

Definition strictly_inside (a b p : point) : bool := 0 <? edge a b p.

Theorem shift_decides r c p : half_circle r -> exists u k, u <> origin /\ 0 < k /\
  forall m n, 0 < n -> n * k <= m -> forall a b, In (a, b) c -> a <> b ->
    edge (times m a) (times m b) (moved m n u p) <> 0
    /\ inside r a b p = strictly_inside (times m a) (times m b) (moved m n u p).
Proof.
  intros H. set (direction := fun e : directed => minus (snd e) (fst e)).
  destruct (half_circle_is_a_shift r (map direction c) H) as (u & U & F).
  destruct (bound (fun e => cross (direction e) u) c) as (k & K & B).
  rewrite Forall_forall in F, B. exists u, k. split; [assumption|]. split; [assumption|].
  intros m n N M a b I D. specialize (F _ (in_map direction _ _ I)). specialize (B _ I).
  unfold direction in F, B; cbn [fst snd] in F, B. specialize (F (minus_not_origin b a (not_eq_sym
    D))).
  unfold strictly_inside, inside. rewrite edge_moved.
  revert F B. generalize (edge a b p) (cross (minus b a) u). intros e s F B.
  assert (0 < m) by nia. assert (Z.abs (n * s) < m) by nia.
  destruct (Z.lt_trichotomy e 0) as [L|[->|G]].
  - assert (m * e + n * s < 0) by nia. assert (m * (m * e + n * s) < 0) by nia.
    split; [lia|]. decide_all; simpl; lia || reflexivity.
  - destruct (r (minus b a)).
    + assert (0 < n * s) by nia. assert (0 < m * (m * 0 + n * s)) by nia.
      split; [lia|]. decide_all; simpl; lia || reflexivity.
    + assert (n * s < 0) by nia. assert (m * (m * 0 + n * s) < 0) by nia.
      split; [lia|]. decide_all; simpl; lia || reflexivity.
  - assert (0 < m * e + n * s) by nia. assert (0 < m * (m * e + n * s)) by nia.
    split; [lia|]. decide_all; simpl; lia || reflexivity.
Qed.

(** ** A sample on the outline *)

Definition scaled_triangle (k : Z) (t : triangle) : triangle :=
  Triangle (times k (corner_a t)) (times k (corner_b t)) (times k (corner_c t)).

Lemma scaled_boundary k m : boundary (map (scaled_triangle k) m) = scaled k (boundary m).
Proof.
  induction m as [|[a b c] m IH]; [reflexivity|].
  unfold boundary in *. cbn [map flat_map]. rewrite IH. reflexivity.
Qed.

Lemma scaled_outline k m c : outline m c -> outline (map (scaled_triangle k) m) (scaled k c).
Proof.
  intros (l & P). exists (scaled k l). rewrite scaled_boundary.
  apply (Permutation_map (fun e => (times k (fst e), times k (snd e)))) in P.
  unfold scaled. rewrite P, !map_app, !map_map. reflexivity.
Qed.

Lemma squares x y : x * x + y * y <= 0 -> x = 0 /\ y = 0.
Proof. intros. assert (0 <= x * x) by nia. assert (0 <= y * y) by nia. split; nia. Qed.

Theorem coverage_is_winding_beside r m c p : half_circle r -> outline m c ->
  exists u k, u <> origin /\ 0 < k /\ forall s n, 0 < n -> n * k <= s ->
    off (scaled s c) (moved s n u p)
    /\ signed_coverage r m p = winding (scaled s c) (moved s n u p).
Proof.
  intros H O. destruct (shift_decides r (c ++ boundary m ++ map reverse (boundary m)) p H)
    as (u & k & U & K & D).
  destruct (bound (fun w => w) [px u; py u]) as (q & Q & B).
  exists u, (k + q). split; [assumption|]. split; [lia|]. intros s n N S.
  specialize (D s n N ltac:(nia)).
  assert (F : off (scaled s c) (moved s n u p)).
  { apply Forall_forall. intros e I. apply in_map_iff in I as ([a b] & <- & I). cbn [fst snd].
    destruct (point_dec a b) as [<-|A].
    - intros [_ L]. inversion B as [|? ? B1 B2]; subst. inversion B2 as [|? ? B3 _]; subst.
      unfold moved, times, plus in L; cbn [px py] in L.
      apply squares in L as [X Y]. clear - X Y B1 B3 S N U Q K.
      assert (Z.abs (n * px u) < s) by nia. assert (Z.abs (n * py u) < s) by nia.
      assert (A1 : px a = px p) by nia. assert (A2 : py a = py p) by nia. rewrite A1 in X.
      rewrite A2 in Y.
      apply U, point_ext; unfold origin; cbn [px py]; nia.
    - intros [E _]. apply (D a b) in E; auto. apply in_or_app; auto. }
  split; [assumption|].
  rewrite <- (coverage_is_winding r (map (scaled_triangle s) m)) by auto using scaled_outline.
  unfold signed_coverage. rewrite sum_map. apply sum_ext. intros t I. destruct t as [a b d].
  assert (J : forall v w, In (v, w) (triangle_boundary (Triangle a b d)) -> v <> w ->
    inside r v w p = inside r (times s v) (times s w) (moved s n u p)
    /\ inside r w v p = inside r (times s w) (times s v) (moved s n u p)).
  { intros v w V W. assert (In (v, w) (boundary m)).
    { apply in_flat_map. eexists; split; eassumption. }
    assert (X : forall v w, In (v, w) (c ++ boundary m ++ map reverse (boundary m)) -> v <> w ->
      inside r v w p = inside r (times s v) (times s w) (moved s n u p)).
    { intros v' w' V' W'. destruct (D v' w' V' W') as [E ->]. unfold strictly_inside, inside.
      decide_all; simpl; lia || reflexivity. }
    split; apply X; auto; apply in_or_app; right; apply in_or_app; [left; assumption|right].
    apply in_map_iff. exists (v, w). split; [reflexivity|assumption]. }
  assert (P : 0 < s) by nia.
  unfold signed, area, covers, turned, scaled_triangle; cbn [corner_a corner_b corner_c].
  replace (edge (times s a) (times s b) (times s d)) with (s * s * edge a b d)
    by (unfold edge, times; cbn [px py]; ring).
  assert ((0 <? s * s * edge a b d) = (0 <? edge a b d)) as ->.
  { destruct (Z.ltb_spec 0 (edge a b d)), (Z.ltb_spec 0 (s * s * edge a b d)); try reflexivity;
    nia. }
  assert ((s * s * edge a b d <? 0) = (edge a b d <? 0)) as ->.
  { destruct (Z.ltb_spec (edge a b d) 0), (Z.ltb_spec (s * s * edge a b d) 0); try reflexivity;
    nia. }
  destruct (Z.eq_dec (edge a b d) 0) as [->|A]; [reflexivity|].
  destruct (J a b) as [-> ->]; [left; reflexivity|intros ->; apply A; unfold edge; ring|].
  destruct (J b d) as [-> ->]; [right; left; reflexivity|intros ->; apply A; unfold edge; ring|].
  destruct (J d a) as [-> ->]; [right; right; left; reflexivity|intros ->; apply A; unfold edge;
    ring|].
  reflexivity.
Qed.

(** ** Top-left: the shift by (e, e^2), for every e = n/m that is small enough *)

Theorem top_left_is_the_shift a b p : a <> b -> exists k, 0 < k /\
  forall m n, 0 < n -> n * k <= m ->
    let shifted := Point (m * m * px p + m * n) (m * m * py p + n * n) in
    edge (times (m * m) a) (times (m * m) b) shifted <> 0
    /\ inside top_left a b p = strictly_inside (times (m * m) a) (times (m * m) b) shifted.
Proof.
  intros D. set (x := px b - px a). set (y := py b - py a).
  exists (1 + Z.abs x + Z.abs y). split; [lia|]. intros m n N M. cbn zeta.
  assert (E : edge (times (m * m) a) (times (m * m) b) (Point (m * m * px p + m * n) (m * m * py p
    + n * n))
    = m * m * (m * m * edge a b p + n * (n * x - m * y))).
  { unfold edge, times, x, y; cbn [px py]; ring. }
  unfold strictly_inside, inside, top_left, minus; cbn [px py]. rewrite E. fold x y.
  assert (Mn : n <= m) by (clear -N M; nia). assert (P : 0 < m * m) by (clear -N Mn; nia).
  assert (X : x <> 0 \/ y <> 0).
  { destruct (Z.eq_dec x 0), (Z.eq_dec y 0); auto. elim D. apply point_ext; lia. }
  clear E. clearbody x y. revert X. generalize (edge a b p). intros e X.
  set (t := n * (n * x - m * y)).
  assert (Nx : Z.abs (n * x) < m) by (clear -N M; nia).
  assert (B : Z.abs t < m * m).
  { assert (Z.abs (n * x - m * y) <= m * (Z.abs x + Z.abs y)) by (clear -N Mn; nia).
    assert (Z.abs t <= n * (m * (Z.abs x + Z.abs y))) by (unfold t; clear -N H; nia).
    assert (m * (n * (Z.abs x + Z.abs y)) <= m * (m - n)) by (clear -N M Mn; nia).
    clear -H0 H1 N Mn; nia. }
  assert (T : (0 < t <-> y < 0 \/ y = 0 /\ 0 < x) /\ t <> 0).
  { unfold t. clear -Nx N Mn X. destruct (Z.lt_trichotomy y 0) as [L|[->|G]].
    - assert (0 < n * x - m * y) by nia. assert (0 < n * (n * x - m * y)) by nia. lia.
    - replace (n * x - m * 0) with (n * x) by ring. destruct (Z.lt_trichotomy x 0) as [|[|]].
      + assert (n * x < 0) by nia. assert (n * (n * x) < 0) by nia. lia.
      + lia.
      + assert (0 < n * x) by nia. assert (0 < n * (n * x)) by nia. lia.
    - assert (n * x - m * y < 0) by nia. assert (n * (n * x - m * y) < 0) by nia. lia. }
  clearbody t. clear M Nx. assert (S : 0 < m * m * e + t <-> 0 < e \/ e = 0 /\ 0 < t) by nia.
  assert (S0 : m * m * e + t <> 0) by nia.
  split; [nia|].
  destruct (Z.ltb_spec 0 (m * m * (m * m * e + t))) as [W|W];
    [assert (V : 0 < m * m * e + t) by nia|assert (V : ~ 0 < m * m * e + t) by nia];
    clear W P B S0; decide_all; simpl; lia || reflexivity.
Qed.
