(** A boundary can be reduced until no two opposite edges are left; and what its winding number says
    of meshes of positive triangles. *)
From Rasterproof Require Import Specification Boundary Winding Coverage.
From Coq Require Import Lia.

Definition same (e f : directed) : bool :=
  (px (fst e) =? px (fst f)) && (py (fst e) =? py (fst f))
  && (px (snd e) =? px (snd f)) && (py (snd e) =? py (snd f)).

Lemma same_iff e f : same e f = true <-> e = f.
Proof.
  unfold same. rewrite !andb_true_iff, !Z.eqb_eq. split; [|intros ->; auto].
  destruct e as [a b], f as [c d]; cbn [fst snd]. intros [[[A B] C] D].
  f_equal; apply point_ext; assumption.
Qed.

(** The chain without one edge that is e, where there is one. *)
Fixpoint without (e : directed) (c : chain) : option chain :=
  match c with
  | [] => None
  | f :: c => if same e f then Some c else option_map (cons f) (without e c)
  end.

Definition add (e : directed) (c : chain) : chain :=
  match without (reverse e) c with Some rest => rest | None => e :: c end.
Definition reduced (c : chain) : chain := fold_right add [] c.

Lemma without_some e c rest : without e c = Some rest -> Permutation c (e :: rest).
Proof.
  revert rest. induction c as [|f c IH]; intros rest; cbn; [discriminate|].
  destruct (same e f) eqn:S.
  - intros [= <-]. apply same_iff in S. subst. reflexivity.
  - destruct (without e c) as [w|]; cbn; [|discriminate]. intros [= <-].
    rewrite (IH w eq_refl). apply perm_swap.
Qed.

Lemma without_none e c : without e c = None -> ~ In e c.
Proof.
  induction c as [|f c IH]; cbn; [tauto|]. destruct (same e f) eqn:S; [discriminate|].
  destruct (without e c); cbn; [discriminate|]. intros _ [<-|I]; [|apply IH; auto].
  enough (same f f = true) by congruence. apply same_iff; reflexivity.
Qed.

Lemma reduced_takes_pairs c :
  exists pairs, Permutation c (reduced c ++ pairs ++ map reverse pairs).
Proof.
  induction c as [|e c (pairs & P)]; [exists []; constructor|].
  change (reduced (e :: c)) with (add e (reduced c)). unfold add.
  destruct (without (reverse e) (reduced c)) as [rest|] eqn:W.
  - exists (e :: pairs). apply without_some in W.
    transitivity (e :: (reverse e :: rest) ++ pairs ++ map reverse pairs).
    + apply perm_skip. rewrite P at 1. apply Permutation_app_tail, W.
    + cbn [map app]. rewrite <- Permutation_middle. apply perm_skip.
      rewrite <- (Permutation_middle pairs), <- Permutation_middle. reflexivity.
  - exists pairs. cbn [app]. apply perm_skip. assumption.
Qed.

Theorem reduced_is_outline m : outline m (reduced (boundary m)).
Proof. apply reduced_takes_pairs. Qed.

Theorem reduced_has_no_opposites c e : reverse e <> e -> In e (reduced c) ->
  ~ In (reverse e) (reduced c).
Proof.
  intros N. induction c as [|f c IH]; [intros []|].
  change (reduced (f :: c)) with (add f (reduced c)). unfold add.
  destruct (without (reverse f) (reduced c)) as [rest|] eqn:W.
  - apply without_some in W. intros A B. apply IH; rewrite W; right; assumption.
  - apply without_none in W. assert (R : reverse (reverse e) = e) by (destruct e; reflexivity).
    intros [->|A] [B|B]; [congruence|contradiction| |apply IH; assumption].
    subst f. rewrite R in W. contradiction.
Qed.

(** Any mesh, any half-circle, any sample on no edge of the reduced boundary. *)
Theorem coverage_is_winding_of_the_reduced_boundary r m p : half_circle r ->
  off (reduced (boundary m)) p -> signed_coverage r m p = winding (reduced (boundary m)) p.
Proof. intros H O. apply coverage_is_winding; auto using reduced_is_outline. Qed.

(** Of positive triangles: as many owners as the winding number says; none where it is 0. *)
Theorem owners_are_winding r m c p : half_circle r -> positive m -> outline m c -> off c p ->
  owners r m p = winding c p.
Proof. intros. rewrite owners_signed by assumption. apply coverage_is_winding; assumption. Qed.

Theorem outside_has_no_owner r m c p : half_circle r -> positive m -> outline m c -> off c p ->
  winding c p = 0 -> Forall (fun t => covers r t p = false) m.
Proof.
  intros H P O F W. rewrite <- (owners_are_winding r m c p H P O F) in W. unfold owners in W.
  clear P O. induction m as [|t m IH]; constructor; sums.
  - assert (0 <= sum (fun t => Z.b2z (covers r t p)) m).
    { clear. induction m as [|t m IH]; sums; [lia|]. destruct (covers r t p); cbn [Z.b2z]; lia. }
    destruct (covers r t p); cbn [Z.b2z] in W; [lia|reflexivity].
  - apply IH. assert (0 <= sum (fun t => Z.b2z (covers r t p)) m).
    { clear. induction m as [|u m IH]; sums; [lia|]. destruct (covers r u p); cbn [Z.b2z]; lia. }
    destruct (covers r t p); cbn [Z.b2z] in W; lia.
Qed.
