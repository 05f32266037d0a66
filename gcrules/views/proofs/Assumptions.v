(* ---- theorems under assumptions

   In these R is a field in which any two elements are equal or not: `inverse_left` and `decided` are hypotheses of such
   a theorem, beside what it says of its points; theorems without assumptions do not have them. What is given vanishes
   (= number G 0), what must not vanish does not (<> number G 0).

   A point on an extensor that is not zero is written as what it is there: on a join of points as a combination of these
   (on_2_of_plane and so on). Points of which nothing says that they are independent are dependent in one of some ways:
   one of them is a combination of the others (dependent_3_of_plane and so on), and the claim is replayed in each. That
   an extensor vanishes follows from another one of the same value, closed by further points (`follows_sound`). *)

Local Open Scope ring_scope.

Section Placing.

Variable G : geometry.

Lemma number_0 : number G 0 = zero G.
Proof. apply scale_0. Qed.

(* the point with number i is written as the expression e *)
Fixpoint put (i : nat) (e x : expression) : expression :=
  match x with
  | Point j => if Nat.eqb i j then e else x
  | Number _ => x
  | Sum y z => Sum (put i e y) (put i e z)
  | Join y z => Join (put i e y) (put i e z)
  | Meet y z => Meet (put i e y) (put i e z)
  | Bracket y => Bracket (put i e y)
  | Superbracket a b c d f g =>
    Superbracket (put i e a) (put i e b) (put i e c) (put i e d) (put i e f) (put i e g)
  | Power y n => Power (put i e y) n
  end.

Lemma put_value : forall at_ i e x, point G (at_ i) = value G at_ e -> value G at_ (put i e x) = value G at_ x.
Proof.
  intros at_ i e x H. induction x; cbn [put value]; try congruence.
  destruct (Nat.eqb i i0) eqn:E; [|reflexivity]. apply Nat.eqb_eq in E. subst i0. symmetry. exact H.
Qed.

Definition all_put (places : list (nat * expression)) (x : expression) : expression :=
  fold_left (fun y '(i, e) => put i e y) places x.

Fixpoint placed (at_ : nat -> vector G) (places : list (nat * expression)) : Prop :=
  match places with
  | [] => True
  | (i, e) :: others => point G (at_ i) = value G at_ e /\ placed at_ others
  end.

Lemma all_put_value : forall at_ places x, placed at_ places -> value G at_ (all_put places x) = value G at_ x.
Proof.
  intros at_. induction places as [|[i e] others IH]; intros x H; [reflexivity|]. destruct H as [H H'].
  transitivity (value G at_ (put i e x)); [exact (IH _ H') | exact (put_value _ _ _ _ H)].
Qed.

Theorem replay_placed : forall at_ ideal n x y places relations,
  (forall i, (i < ideal)%nat -> infinite G (at_ i)) -> placed at_ places ->
  replay (rank G) ideal n (all_put places x) (all_put places y) relations = true -> value G at_ x = value G at_ y.
Proof.
  intros at_ ideal n x y places relations Hi Hp H.
  rewrite <- (all_put_value at_ places x Hp), <- (all_put_value at_ places y Hp).
  exact (replay_sound G at_ ideal n _ _ relations Hi H).
Qed.

(* ---- what vanishes because something else does *)

Definition nothing (A : list term) : bool := match collected A with [] => true | _ => false end.

(* closed by further points, x is y or its negative and the sum of relations *)
Definition follows_by (zero : list term -> bool) (d ideal n : nat) (x y : expression) (relations : list relation) :=
  let rest := flat_map (multiplied d ideal) relations in
  Nat.leb ideal n && points_below n x && points_below n y &&
  match both (fun A B => both (fun C D => zero (C ++ negated D ++ rest) || zero (C ++ D ++ rest))
                           (closed d ideal n A) (closed d ideal n B))
             (expand d ideal x) (expand d ideal y) with
  | Some (Some b) => b
  | _ => false
  end.

Definition follows := follows_by nothing.

Lemma closed_value : forall at_ ideal n A C, (forall i, (i < ideal)%nat -> infinite G (at_ i)) ->
  closed (rank G) ideal n A = Some C -> exists m,
  (m = length (snd (hd (0%Z, [], []) A))) /\
  terms_value G at_ C = if Nat.eqb m 0 then terms_value G at_ A
    else scalar G (top G (join G (terms_value G at_ A) (W G at_ (seq n (rank G - m))))).
Proof.
  intros at_ ideal n A C Hi H. unfold closed in H. destruct A as [|[[c m] r] A'] eqn:E.
  - injection H as <-. exists 0%nat. split; reflexivity.
  - rewrite <- E in *. cbv zeta in H. exists (length r). split; [rewrite E; reflexivity|].
    destruct (forallb (fun t => Nat.eqb (length (snd t)) (length r)) A && Nat.leb (length r) (rank G)); [|discriminate].
    destruct (Nat.eqb (length r) 0); injection H as <-; [reflexivity|].
    exact (closing_value G at_ ideal Hi A _).
Qed.

Lemma closed_zero : forall at_ ideal n A C, (forall i, (i < ideal)%nat -> infinite G (at_ i)) ->
  closed (rank G) ideal n A = Some C -> terms_value G at_ A = zero G -> terms_value G at_ C = zero G.
Proof.
  intros at_ ideal n A C Hi H Z. destruct (closed_value at_ ideal n A C Hi H) as (m & _ & V). rewrite V, Z.
  destruct (Nat.eqb m 0); [reflexivity|]. rewrite (linear_zero G _ (join_linear_l G _)), (top_zero G). apply scale_0.
Qed.

Lemma nothing_value : forall at_ A, nothing A = true -> terms_value G at_ A = zero G.
Proof.
  intros at_ A H. unfold nothing in H. rewrite <- collected_value. destruct (collected A); [reflexivity|discriminate].
Qed.

(* further points behind the first n *)
Definition extended (at_ : nat -> vector G) (n : nat) (l : list (vector G)) (i : nat) : vector G :=
  if Nat.ltb i n then at_ i else nth (i - n) l (at_ 0%nat).

Lemma extended_below : forall at_ n l i, (i < n)%nat -> at_ i = extended at_ n l i.
Proof. intros at_ n l i Li. unfold extended. apply Nat.ltb_lt in Li. rewrite Li. reflexivity. Qed.

(* what vanishes with all points that close it vanishes *)
Lemma closed_everywhere : forall at_ ideal n x A C, (forall i, (i < ideal)%nat -> infinite G (at_ i)) ->
  (ideal <= n)%nat -> points_below n x = true -> expand (rank G) ideal x = Some A ->
  closed (rank G) ideal n A = Some C ->
  (forall l, length l = (rank G - length (snd (hd (0%Z, [], []) A)))%nat ->
    terms_value G (extended at_ n l) C = zero G) ->
  value G at_ x = zero G.
Proof.
  intros at_ ideal n x A C Hi Hn Hx EA EC CZ.
  assert (Hie : forall l i, (i < ideal)%nat -> infinite G (extended at_ n l i)).
  { intros l i Li. rewrite <- extended_below by lia. apply Hi, Li. }
  rewrite (expand_value G at_ ideal Hi x A EA).
  destruct (closed_value at_ ideal n A C Hi EC) as (m & Hm & V). rewrite <- Hm in CZ.
  destruct (Nat.eqb m 0) eqn:E0.
  { set (l := repeat (at_ 0%nat) (rank G - m)).
    assert (L : terms_value G (extended at_ n l) C = zero G) by (apply CZ; unfold l; apply repeat_length).
    destruct (closed_value (extended at_ n l) ideal n A C (Hie l) EC) as (m' & Hm' & V').
    rewrite Hm' in *. rewrite Hm in E0. rewrite E0 in V'. rewrite V' in L.
    rewrite <- (expand_value G _ ideal (Hie l) x A EA) in L. rewrite <- (expand_value G at_ ideal Hi x A EA).
    rewrite (value_agrees G at_ (extended at_ n l) n x (extended_below at_ n l) Hx). exact L. }
  unfold closed in EC. destruct A as [|[[c0 m0] r0] A'] eqn:EA'; [cbn in Hm; subst m; discriminate|].
  rewrite <- EA' in *. replace (snd (hd (0%Z, [], []) A)) with r0 in Hm by (rewrite EA'; reflexivity). cbv zeta in EC.
  destruct (forallb (fun t => Nat.eqb (length (snd t)) (length r0)) A && Nat.leb (length r0) (rank G)) eqn:EF; [|discriminate].
  apply andb_true_iff in EF. destruct EF as [EF EL]. apply Nat.leb_le in EL. rewrite <- Hm in *.
  apply (closing_zero G (rank G - m) m); [apply pure_terms, EF | lia |].
  intros l Hl. pose proof (extended_below at_ n l) as He. specialize (Hie l). specialize (CZ l Hl).
  assert (N : scalar G (top G (join G (terms_value G (extended at_ n l) A)
    (W G (extended at_ n l) (seq n (rank G - m))))) = zero G).
  { rewrite E0 in EC. injection EC as EC. transitivity (terms_value G (extended at_ n l) C); [|exact CZ].
    rewrite <- EC. symmetry. exact (closing_value G _ ideal Hie A _). }
  apply scalar_zero in N.
  rewrite <- (expand_value G at_ ideal Hi x A EA), (value_agrees G at_ (extended at_ n l) n x He Hx).
  rewrite (expand_value G _ ideal Hie x A EA).
  replace (span G l) with (W G (extended at_ n l) (seq n (rank G - m))); [exact N|]. unfold W. f_equal.
  rewrite <- Hl. apply (nth_ext _ _ (at_ 0%nat) (at_ 0%nat)); [rewrite length_map_; apply length_seq_|].
  intros i Li. rewrite length_map_, length_seq_ in Li.
  rewrite (nth_indep _ _ (extended at_ n l 0%nat)) by (rewrite length_map_, length_seq_; exact Li).
  rewrite map_nth, seq_nth by exact Li. unfold extended.
  replace (Nat.ltb (n + i) n) with false by (symmetry; apply Nat.ltb_ge; lia). f_equal. lia.
Qed.

Lemma follows_by_sound : forall test at_ ideal n x y relations,
  (forall l A, test A = true -> terms_value G (extended at_ n l) A = number G 0) ->
  (forall i, (i < ideal)%nat -> infinite G (at_ i)) -> value G at_ y = number G 0 ->
  follows_by test (rank G) ideal n x y relations = true -> value G at_ x = number G 0.
Proof.
  intros test at_ ideal n x y relations HZ Hi Y H. rewrite number_0 in *. unfold follows_by in H. cbv zeta in H.
  rewrite !andb_true_iff in H. destruct H as [[[Hn Hx] Hy] H]. apply Nat.leb_le in Hn.
  destruct (expand (rank G) ideal x) as [A|] eqn:EA; [|discriminate].
  destruct (expand (rank G) ideal y) as [B|] eqn:EB; [|discriminate]. cbn [both] in H.
  destruct (closed (rank G) ideal n A) as [C|] eqn:EC; [|discriminate].
  destruct (closed (rank G) ideal n B) as [D|] eqn:ED; [|discriminate]. cbn [both] in H.
  apply (closed_everywhere at_ ideal n x A C Hi Hn Hx EA EC). intros l _.
  specialize (HZ l). pose proof (extended_below at_ n l) as He. set (e := extended at_ n l) in *.
  assert (Hie : forall i, (i < ideal)%nat -> infinite G (e i)).
  { intros i Li. rewrite <- He by lia. apply Hi, Li. }
  assert (Z : terms_value G e D = zero G).
  { apply (closed_zero e ideal n B D Hie ED). rewrite <- (expand_value G e ideal Hie y B EB).
    rewrite <- (value_agrees G at_ e n y He Hy). exact Y. }
  apply orb_true_iff in H. destruct H as [H|H]; apply HZ in H;
    rewrite !vals_app, (relations_value G e ideal Hie relations), plus_zero_r in H.
  - rewrite negated_value, Z, scale_zero, plus_zero_r in H. exact H.
  - rewrite Z, plus_zero_r in H. exact H.
Qed.

Theorem follows_sound : forall at_ ideal n x y relations,
  (forall i, (i < ideal)%nat -> infinite G (at_ i)) -> value G at_ y = number G 0 ->
  follows (rank G) ideal n x y relations = true -> value G at_ x = number G 0.
Proof.
  intros at_ ideal n x y relations. apply follows_by_sound. intros. rewrite number_0. apply nothing_value. assumption.
Qed.

(* ---- fractions: a bracket r stands for 1 / N, and what vanishes times a power of N does *)

Fixpoint repeated (x : R) (k : nat) : R := match k with O => 1 | S k' => x * repeated x k' end.
Fixpoint repeated_whole (c : Z) (k : nat) : Z := match k with O => 1%Z | S k' => (c * repeated_whole c k')%Z end.

Lemma whole_repeated : forall c k, whole (repeated_whole c k) = repeated (whole c) k.
Proof. intros c. induction k; cbn [repeated repeated_whole]; [apply whole_1 | rewrite whole_mul, IHk; reflexivity]. Qed.

Lemma repeated_one : forall x y k, x * y = 1 -> repeated x k * repeated y k = 1.
Proof.
  intros x y k H. induction k; cbn [repeated]; [ring|].
  transitivity ((x * y) * (repeated x k * repeated y k)); [ring | rewrite H, IHk; ring].
Qed.

Lemma repeated_plus : forall x j k, repeated x (j + k) = repeated x j * repeated x k.
Proof. intros x j k. induction j; cbn [repeated Nat.add]; [ring | rewrite IHj; ring]. Qed.

(* how often a bracket is a factor, and the other factors *)
Fixpoint taken (r : row) (m : list row) : nat * list row :=
  match m with
  | [] => (0%nat, [])
  | s :: m' => let (k, rest) := taken r m' in
    match compare_rows r s with Eq => (S k, rest) | _ => (k, s :: rest) end
  end.

Lemma taken_value : forall at_ r m,
  monomial_value G at_ m = repeated (bracket_value G at_ r) (fst (taken r m)) * monomial_value G at_ (snd (taken r m)).
Proof.
  intros at_ r. induction m as [|s m IH]; cbn [taken]; [cbn; ring|].
  destruct (taken r m) as [k rest]. cbn [fst snd] in IH.
  change (monomial_value G at_ (s :: m)) with (bracket_value G at_ s * monomial_value G at_ m). rewrite IH.
  destruct (compare_rows r s) eqn:E; [apply compare_rows_eq in E; subst s | |]; cbn [fst snd repeated]; [ring | |];
    change (monomial_value G at_ (s :: rest)) with (bracket_value G at_ s * monomial_value G at_ rest); ring.
Qed.

Definition cleared (c : Z) (r : row) (e : nat) (t : term) : term :=
  let '(x, m, l) := t in
  ((x * repeated_whole c (e - fst (taken r m)))%Z, snd (taken r m), l).

Fixpoint most (r : row) (A : list term) : nat :=
  match A with [] => 0%nat | t :: A' => Nat.max (fst (taken r (snd (fst t)))) (most r A') end.

Lemma cleared_value : forall at_ c r e A, whole c * bracket_value G at_ r = 1 -> (most r A <= e)%nat ->
  terms_value G at_ (map (cleared c r e) A) = scale G (repeated (whole c) e) (terms_value G at_ A).
Proof.
  intros at_ c r e A H. induction A as [|[[x m] l] A IH]; intros L; [symmetry; apply scale_zero|].
  cbn [most fst snd] in L. change (terms_value G at_ (map (cleared c r e) ((x, m, l) :: A))) with
    (plus G (term_value G at_ (cleared c r e (x, m, l))) (terms_value G at_ (map (cleared c r e) A))).
  change (terms_value G at_ ((x, m, l) :: A)) with (plus G (term_value G at_ (x, m, l)) (terms_value G at_ A)).
  rewrite scale_plus, IH by lia. f_equal. cbn [cleared term_value]. rewrite <- scale_mul. f_equal.
  rewrite (taken_value at_ r m), whole_mul, whole_repeated. set (k := fst (taken r m)) in *.
  replace (repeated (whole c) e) with (repeated (whole c) (e - k) * repeated (whole c) k)
    by (rewrite <- repeated_plus; f_equal; lia).
  pose proof (repeated_one _ _ k H) as O.
  transitivity (whole x * repeated (whole c) (e - k) * monomial_value G at_ (snd (taken r m))
    * (repeated (whole c) k * repeated (bracket_value G at_ r) k)); [rewrite O; ring | ring].
Qed.

Definition nothing_in_fractions (c : Z) (r : row) (A : list term) : bool := nothing (map (cleared c r (most r A)) A).

Lemma nothing_in_fractions_value : forall at_ c r A, whole c * bracket_value G at_ r = 1 ->
  nothing_in_fractions c r A = true -> terms_value G at_ A = zero G.
Proof.
  intros at_ c r A H Z. apply (nothing_value at_) in Z. rewrite (cleared_value at_ c r _ A H) in Z by lia.
  rewrite <- (scale_1 G (terms_value G at_ A)), <- (repeated_one _ _ (most r A) H).
  replace (repeated (whole c) (most r A) * repeated (bracket_value G at_ r) (most r A))
    with (repeated (bracket_value G at_ r) (most r A) * repeated (whole c) (most r A)) by ring.
  rewrite scale_mul, Z. apply scale_zero.
Qed.

Definition follows_in_fractions (c : Z) (r : row) := follows_by (nothing_in_fractions c r).

Theorem follows_in_fractions_sound : forall c r at_ ideal n x y relations,
  whole c * bracket_value G at_ r = 1 -> forallb (fun i => Nat.ltb i n) r = true ->
  (forall i, (i < ideal)%nat -> infinite G (at_ i)) -> value G at_ y = number G 0 ->
  follows_in_fractions c r (rank G) ideal n x y relations = true -> value G at_ x = number G 0.
Proof.
  intros c r at_ ideal n x y relations H L. apply follows_by_sound. intros l A. rewrite number_0.
  apply nothing_in_fractions_value. rewrite <- H. f_equal. unfold bracket_value, W. do 2 f_equal.
  apply map_ext_in. intros i I. symmetry. apply extended_below. rewrite forallb_forall in L. apply Nat.ltb_lt, L, I.
Qed.

(* closed by k further points, x is y or its negative, in which these points have numbers from n on *)
Definition for_all (d ideal n k : nat) (x y : expression) : bool :=
  Nat.leb ideal n && points_below n x &&
  match expand d ideal x, expand d ideal y with
  | Some A, Some B =>
    Nat.eqb (d - length (snd (hd (0%Z, [], []) A))) k &&
    match closed d ideal n A with Some C => nothing (C ++ negated B) || nothing (C ++ B) | None => false end
  | _, _ => false
  end.

Theorem for_all_sound : forall at_ ideal n k x y, (forall i, (i < ideal)%nat -> infinite G (at_ i)) ->
  (forall l, length l = k -> value G (extended at_ n l) y = number G 0) ->
  for_all (rank G) ideal n k x y = true -> value G at_ x = number G 0.
Proof.
  intros at_ ideal n k x y Hi Y H. rewrite number_0 in *. unfold for_all in H.
  rewrite !andb_true_iff in H. destruct H as [[Hn Hx] H]. apply Nat.leb_le in Hn.
  destruct (expand (rank G) ideal x) as [A|] eqn:EA; [|discriminate].
  destruct (expand (rank G) ideal y) as [B|] eqn:EB; [|discriminate].
  apply andb_true_iff in H. destruct H as [K H]. apply Nat.eqb_eq in K.
  destruct (closed (rank G) ideal n A) as [C|] eqn:EC; [|discriminate].
  apply (closed_everywhere at_ ideal n x A C Hi Hn Hx EA EC). intros l Hl. rewrite K in Hl. specialize (Y l Hl).
  assert (Hie : forall i, (i < ideal)%nat -> infinite G (extended at_ n l i)).
  { intros i Li. rewrite <- extended_below by lia. apply Hi, Li. }
  rewrite (expand_value G _ ideal Hie y B EB) in Y.
  apply orb_true_iff in H. destruct H as [H|H]; apply (nothing_value (extended at_ n l)) in H; rewrite !vals_app in H.
  - rewrite negated_value, Y, scale_zero, plus_zero_r in H. exact H.
  - rewrite Y, plus_zero_r in H. exact H.
Qed.

(* an expression of one step *)
Definition of_step (d ideal k : nat) (x : expression) : bool :=
  match expand d ideal x with
  | Some A => forallb (fun t : term => Nat.eqb (length (snd t)) k) A
  | None => false
  end.

Lemma of_step_sound : forall at_ ideal k x, (forall i, (i < ideal)%nat -> infinite G (at_ i)) ->
  of_step (rank G) ideal k x = true -> pure G k (value G at_ x).
Proof.
  intros at_ ideal k x Hi H. unfold of_step in H. destruct (expand (rank G) ideal x) as [A|] eqn:E; [|discriminate].
  rewrite (expand_value G at_ ideal Hi x A E). apply pure_terms, H.
Qed.

Lemma join_nothing_l : forall A, join G (number G 0) A = number G 0.
Proof. intros. rewrite number_0. apply (linear_zero G _ (join_linear_l G _)). Qed.
Lemma join_nothing_r : forall A, join G A (number G 0) = number G 0.
Proof. intros. rewrite number_0. apply (linear_zero G _ (join_linear_r G _)). Qed.
Lemma meet_nothing_l : forall A, meet G (number G 0) A = number G 0.
Proof. intros. rewrite number_0. apply (linear_zero G _ (meet_linear_l G _)). Qed.
Lemma meet_nothing_r : forall A, meet G A (number G 0) = number G 0.
Proof. intros. rewrite number_0. apply (linear_zero G _ (meet_linear_r G _)). Qed.
Lemma bracket_nothing : bracket (number G 0) = number G 0.
Proof. unfold bracket. rewrite number_0, (top_zero G). apply scale_0. Qed.

(* a point of two extensors is on their meet *)
Lemma on_meet : forall A B p, join G A (point G p) = number G 0 -> join G (point G p) B = number G 0 ->
  join G (meet G A B) (point G p) = number G 0.
Proof.
  intros A B p HA HB. pose proof (meet_join G A p B) as H. rewrite HA, HB, number_0 in H.
  rewrite (linear_zero G _ (meet_linear_l G B)), (linear_zero G _ (meet_linear_r G A)),
    (linear_zero G _ (involution_linear G)), plus_zero_r in H.
  rewrite number_0. symmetry. exact H.
Qed.

End Placing.

Ltac vanishes :=
  repeat first
    [rewrite join_nothing_l | rewrite join_nothing_r | rewrite meet_nothing_l | rewrite meet_nothing_r | rewrite bracket_nothing];
  reflexivity.

(* what is assumed, also for all points *)
Ltac assumed := first [assumption | match goal with H : forall _, _ |- _ => solve [apply H] end].

(* ---- a field *)

Variable inverse : R -> R.
Hypothesis inverse_left : forall x, x <> 0 -> inverse x * x = 1.
Hypothesis decided : forall x y : R, x = y \/ x <> y.

Lemma cancelled : forall (G : geometry) (A B : extensor G), join G (bracket A) B = number G 0 -> B <> number G 0 -> bracket A = number G 0.
Proof.
  intros G A B H N. rewrite number_0 in *. unfold bracket in *. rewrite join_scale_l, join_one_l in H.
  destruct (decided (top G A) 0) as [E|E]; [rewrite E; apply scale_0|]. exfalso. apply N.
  rewrite <- (scale_1 G B), <- (inverse_left _ E), scale_mul, H. apply scale_zero.
Qed.

Lemma cancelled_twice : forall (G : geometry) (A B : extensor G),
  join G (join G (bracket A) (bracket A)) B = number G 0 -> B <> number G 0 -> bracket A = number G 0.
Proof.
  intros G A B H N. rewrite number_0 in *. unfold bracket in *.
  rewrite !join_scale_l, !join_one_l, join_scale_l, join_one_l in H.
  destruct (decided (top G A) 0) as [E|E]; [rewrite E; apply scale_0|]. exfalso. apply N.
  rewrite <- (scale_1 G B), <- (inverse_left _ E), scale_mul.
  rewrite <- (scale_1 G (scale G (top G A) B)), <- (inverse_left _ E), scale_mul, H, !scale_zero. reflexivity.
Qed.

Lemma divided : forall (G : geometry) w (A B : extensor G), w <> 0 -> scale G w A = B -> A = scale G (inverse w) B.
Proof. intros G w A B N H. rewrite <- H, <- scale_mul, (inverse_left _ N), scale_1. reflexivity. Qed.

Local Open Scope extensor_scope.

(* ---- points on joins; a scalar x is written as a bracket of (x, 0, 0) *)

Definition plane_scalar (x : R) : vector plane := Vector3 x 0 0.
Definition plane_2 : vector plane := Vector3 0 1 0.
Definition plane_3 : vector plane := Vector3 0 0 1.

Lemma plane_scalar_value : forall x (A : extensor plane),
  bracket (plane_scalar x ∨ plane_2 ∨ plane_3) · A = scale plane x A.
Proof.
  intros x A. unfold bracket. rewrite join_scale_l, join_one_l. f_equal. cbn. ring.
Qed.

Lemma plane_decided : forall A B : extensor plane, A = B \/ A <> B.
Proof.
  intros [a a1 a2 a3 a12 a13 a23 a123] [b b1 b2 b3 b12 b13 b23 b123].
  destruct (decided a b), (decided a1 b1), (decided a2 b2), (decided a3 b3), (decided a12 b12), (decided a13 b13),
    (decided a23 b23), (decided a123 b123); [left; congruence | right; congruence ..].
Qed.

Lemma plane_is_point : forall E : extensor plane, pure plane 1 E -> exists p : vector plane, E = p.
Proof.
  intros [a a1 a2 a3 a12 a13 a23 a123] H. exists (Vector3 a1 a2 a3). cbn in *. decompose [and] H. clear H.
  repeat match goal with H : _ <> _ -> _ |- _ =>
    (let E := type of H in let N := fresh in
     match E with ?k <> ?n -> _ => assert (N : k <> n) by lia end; specialize (H N); clear N) || clear H end.
  repeat match goal with H : _ /\ _ |- _ => destruct H end. subst. reflexivity.
Qed.
Lemma bracket_times : forall (G : geometry) (A B : extensor G), bracket A · B = scale G (top G A) B.
Proof. intros. unfold bracket. rewrite join_scale_l, join_one_l. reflexivity. Qed.

Lemma below_0 : forall (G : geometry) (at_ : nat -> vector G) i, (i < 0)%nat -> infinite G (at_ i).
Proof. intros. lia. Qed.


Definition space_scalar (x : R) : vector space := Vector4 x 0 0 0.
Definition space_2 : vector space := Vector4 0 1 0 0.
Definition space_3 : vector space := Vector4 0 0 1 0.
Definition space_4 : vector space := Vector4 0 0 0 1.

Lemma space_scalar_value : forall x (A : extensor space),
  bracket (space_scalar x ∨ space_2 ∨ space_3 ∨ space_4) · A = scale space x A.
Proof.
  intros x A. unfold bracket. rewrite join_scale_l, join_one_l. f_equal. cbn. ring.
Qed.

Lemma space_decided : forall A B : extensor space, A = B \/ A <> B.
Proof.
  intros [a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234]
    [b b1 b2 b3 b4 b12 b13 b14 b23 b24 b34 b123 b124 b134 b234 b1234].
  assert (together : forall P Q, (P \/ ~ P) -> (Q \/ ~ Q) -> (P /\ Q) \/ ~ (P /\ Q)) by tauto.
  assert (D : (a = b /\ a1 = b1 /\ a2 = b2 /\ a3 = b3 /\ a4 = b4 /\ a12 = b12 /\ a13 = b13 /\ a14 = b14 /\
    a23 = b23 /\ a24 = b24 /\ a34 = b34 /\ a123 = b123 /\ a124 = b124 /\ a134 = b134 /\ a234 = b234 /\ a1234 = b1234) \/
    ~ (a = b /\ a1 = b1 /\ a2 = b2 /\ a3 = b3 /\ a4 = b4 /\ a12 = b12 /\ a13 = b13 /\ a14 = b14 /\
    a23 = b23 /\ a24 = b24 /\ a34 = b34 /\ a123 = b123 /\ a124 = b124 /\ a134 = b134 /\ a234 = b234 /\ a1234 = b1234)).
  { repeat apply together; apply decided. }
  destruct D as [D|D]; [left | right].
  - decompose [and] D. subst. reflexivity.
  - intros E. apply D. injection E as -> -> -> -> -> -> -> -> -> -> -> -> -> -> -> ->. repeat split.
Qed.

Lemma space_is_point : forall E : extensor space, pure space 1 E -> exists p : vector space, E = p.
Proof.
  intros [a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234] H. exists (Vector4 a1 a2 a3 a4).
  cbn in *. decompose [and] H. clear H.
  repeat match goal with H : _ <> _ -> _ |- _ =>
    (let E := type of H in let N := fresh in
     match E with ?k <> ?n -> _ => assert (N : k <> n) by lia end; specialize (H N); clear N) || clear H end.
  repeat match goal with H : _ /\ _ |- _ => destruct H end. subst. reflexivity.
Qed.

Lemma plane_split_1 : forall p x y z : vector plane,
  bracket (p ∨ y ∨ z) · x = bracket (x ∨ y ∨ z) · p + (p ∨ x) ∧ (y ∨ z).
Proof.
  intros. refine (replay_sound plane (fun i => nth i [p; x; y; z] x) 0 4
    (Join (Bracket (Join (Join (Point 0) (Point 2)) (Point 3))) (Point 1))
    (Sum (Join (Bracket (Join (Join (Point 1) (Point 2)) (Point 3))) (Point 0)) (Meet (Join (Point 0) (Point 1)) (Join (Point 2) (Point 3)))) [] (below_0 _ _) _).
  vm_compute. reflexivity.
Qed.

Lemma on_1_of_plane : forall (E : extensor plane) (x : vector plane),
  pure plane 1 E -> E <> number plane 0 -> E ∨ x = number plane 0 ->
  forall A B : extensor plane, (forall s : vector plane,
    point plane x = bracket (s ∨ plane_2 ∨ plane_3) · E -> A = B) -> A = B.
Proof.
  intros E x pure_E N L A B K. destruct (plane_decided A B) as [T|no]; [exact T|]. exfalso. apply N.
  destruct (plane_is_point E pure_E) as [p ->].
  rewrite number_0 in *.
  apply (closing_zero plane 2 1).
  - rewrite <- (join_one_r plane (p)). rewrite <- ?join_assoc. repeat apply pure_join. apply pure_one.
  - reflexivity.
  - intros l Hl. destruct l as [|y [|z [|]]]; try discriminate. cbn [span fold_right].
    rewrite join_one_r. rewrite ?join_assoc.
    destruct (decided (top plane (p ∨ y ∨ z)) 0) as [w|w]; [exact w|]. exfalso. apply no.
    pose proof (plane_split_1 p x y z) as S. rewrite L in S.
    rewrite (linear_zero plane _ (meet_linear_l plane _)), plus_zero_r, !bracket_times in S.
    apply (divided plane _ _ _ w) in S. rewrite ?scale_plus, <- ?scale_mul in S.
    rewrite <- ?plane_scalar_value in S. exact (K _ S).
Qed.

Lemma plane_split_2 : forall p q x y : vector plane,
  bracket (p ∨ q ∨ y) · x = bracket (x ∨ q ∨ y) · p + bracket (p ∨ x ∨ y) · q + (p ∨ q ∨ x) ∧ (y).
Proof.
  intros. refine (replay_sound plane (fun i => nth i [p; q; x; y] x) 0 4
    (Join (Bracket (Join (Join (Point 0) (Point 1)) (Point 3))) (Point 2))
    (Sum (Sum (Join (Bracket (Join (Join (Point 2) (Point 1)) (Point 3))) (Point 0)) (Join (Bracket (Join (Join (Point 0) (Point 2)) (Point 3))) (Point 1))) (Meet (Join (Join (Point 0) (Point 1)) (Point 2)) (Point 3))) [] (below_0 _ _) _).
  vm_compute. reflexivity.
Qed.

Lemma on_2_of_plane : forall (E F : extensor plane) (x : vector plane),
  pure plane 1 E -> pure plane 1 F -> E ∨ F <> number plane 0 -> E ∨ F ∨ x = number plane 0 ->
  forall A B : extensor plane, (forall s u : vector plane,
    point plane x = bracket (s ∨ plane_2 ∨ plane_3) · E + bracket (u ∨ plane_2 ∨ plane_3) · F -> A = B) -> A = B.
Proof.
  intros E F x pure_E pure_F N L A B K. destruct (plane_decided A B) as [T|no]; [exact T|]. exfalso. apply N.
  destruct (plane_is_point E pure_E) as [p ->].
  destruct (plane_is_point F pure_F) as [q ->].
  rewrite number_0 in *.
  apply (closing_zero plane 1 2).
  - rewrite <- (join_one_r plane (p ∨ q)). rewrite <- ?join_assoc. repeat apply pure_join. apply pure_one.
  - reflexivity.
  - intros l Hl. destruct l as [|y [|]]; try discriminate. cbn [span fold_right].
    rewrite join_one_r. rewrite ?join_assoc.
    destruct (decided (top plane (p ∨ q ∨ y)) 0) as [w|w]; [exact w|]. exfalso. apply no.
    pose proof (plane_split_2 p q x y) as S. rewrite L in S.
    rewrite (linear_zero plane _ (meet_linear_l plane _)), plus_zero_r, !bracket_times in S.
    apply (divided plane _ _ _ w) in S. rewrite ?scale_plus, <- ?scale_mul in S.
    rewrite <- ?plane_scalar_value in S. exact (K _ _ S).
Qed.

Lemma space_split_1 : forall p x y z t : vector space,
  bracket (p ∨ y ∨ z ∨ t) · x = bracket (x ∨ y ∨ z ∨ t) · p + (p ∨ x) ∧ (y ∨ z ∨ t).
Proof.
  intros. refine (replay_sound space (fun i => nth i [p; x; y; z; t] x) 0 5
    (Join (Bracket (Join (Join (Join (Point 0) (Point 2)) (Point 3)) (Point 4))) (Point 1))
    (Sum (Join (Bracket (Join (Join (Join (Point 1) (Point 2)) (Point 3)) (Point 4))) (Point 0)) (Meet (Join (Point 0) (Point 1)) (Join (Join (Point 2) (Point 3)) (Point 4)))) [] (below_0 _ _) _).
  vm_compute. reflexivity.
Qed.

Lemma on_1_of_space : forall (E : extensor space) (x : vector space),
  pure space 1 E -> E <> number space 0 -> E ∨ x = number space 0 ->
  forall A B : extensor space, (forall s : vector space,
    point space x = bracket (s ∨ space_2 ∨ space_3 ∨ space_4) · E -> A = B) -> A = B.
Proof.
  intros E x pure_E N L A B K. destruct (space_decided A B) as [T|no]; [exact T|]. exfalso. apply N.
  destruct (space_is_point E pure_E) as [p ->].
  rewrite number_0 in *.
  apply (closing_zero space 3 1).
  - rewrite <- (join_one_r space (p)). rewrite <- ?join_assoc. repeat apply pure_join. apply pure_one.
  - reflexivity.
  - intros l Hl. destruct l as [|y [|z [|t [|]]]]; try discriminate. cbn [span fold_right].
    rewrite join_one_r. rewrite ?join_assoc.
    destruct (decided (top space (p ∨ y ∨ z ∨ t)) 0) as [w|w]; [exact w|]. exfalso. apply no.
    pose proof (space_split_1 p x y z t) as S. rewrite L in S.
    rewrite (linear_zero space _ (meet_linear_l space _)), plus_zero_r, !bracket_times in S.
    apply (divided space _ _ _ w) in S. rewrite ?scale_plus, <- ?scale_mul in S.
    rewrite <- ?space_scalar_value in S. exact (K _ S).
Qed.

Lemma space_split_2 : forall p q x y z : vector space,
  bracket (p ∨ q ∨ y ∨ z) · x = bracket (x ∨ q ∨ y ∨ z) · p + bracket (p ∨ x ∨ y ∨ z) · q + (p ∨ q ∨ x) ∧ (y ∨ z).
Proof.
  intros. refine (replay_sound space (fun i => nth i [p; q; x; y; z] x) 0 5
    (Join (Bracket (Join (Join (Join (Point 0) (Point 1)) (Point 3)) (Point 4))) (Point 2))
    (Sum (Sum (Join (Bracket (Join (Join (Join (Point 2) (Point 1)) (Point 3)) (Point 4))) (Point 0)) (Join (Bracket (Join (Join (Join (Point 0) (Point 2)) (Point 3)) (Point 4))) (Point 1))) (Meet (Join (Join (Point 0) (Point 1)) (Point 2)) (Join (Point 3) (Point 4)))) [] (below_0 _ _) _).
  vm_compute. reflexivity.
Qed.

Lemma on_2_of_space : forall (E F : extensor space) (x : vector space),
  pure space 1 E -> pure space 1 F -> E ∨ F <> number space 0 -> E ∨ F ∨ x = number space 0 ->
  forall A B : extensor space, (forall s u : vector space,
    point space x = bracket (s ∨ space_2 ∨ space_3 ∨ space_4) · E + bracket (u ∨ space_2 ∨ space_3 ∨ space_4) · F -> A = B) -> A = B.
Proof.
  intros E F x pure_E pure_F N L A B K. destruct (space_decided A B) as [T|no]; [exact T|]. exfalso. apply N.
  destruct (space_is_point E pure_E) as [p ->].
  destruct (space_is_point F pure_F) as [q ->].
  rewrite number_0 in *.
  apply (closing_zero space 2 2).
  - rewrite <- (join_one_r space (p ∨ q)). rewrite <- ?join_assoc. repeat apply pure_join. apply pure_one.
  - reflexivity.
  - intros l Hl. destruct l as [|y [|z [|]]]; try discriminate. cbn [span fold_right].
    rewrite join_one_r. rewrite ?join_assoc.
    destruct (decided (top space (p ∨ q ∨ y ∨ z)) 0) as [w|w]; [exact w|]. exfalso. apply no.
    pose proof (space_split_2 p q x y z) as S. rewrite L in S.
    rewrite (linear_zero space _ (meet_linear_l space _)), plus_zero_r, !bracket_times in S.
    apply (divided space _ _ _ w) in S. rewrite ?scale_plus, <- ?scale_mul in S.
    rewrite <- ?space_scalar_value in S. exact (K _ _ S).
Qed.

Lemma space_split_3 : forall p q r x y : vector space,
  bracket (p ∨ q ∨ r ∨ y) · x = bracket (x ∨ q ∨ r ∨ y) · p + bracket (p ∨ x ∨ r ∨ y) · q + bracket (p ∨ q ∨ x ∨ y) · r + (p ∨ q ∨ r ∨ x) ∧ (y).
Proof.
  intros. refine (replay_sound space (fun i => nth i [p; q; r; x; y] x) 0 5
    (Join (Bracket (Join (Join (Join (Point 0) (Point 1)) (Point 2)) (Point 4))) (Point 3))
    (Sum (Sum (Sum (Join (Bracket (Join (Join (Join (Point 3) (Point 1)) (Point 2)) (Point 4))) (Point 0)) (Join (Bracket (Join (Join (Join (Point 0) (Point 3)) (Point 2)) (Point 4))) (Point 1))) (Join (Bracket (Join (Join (Join (Point 0) (Point 1)) (Point 3)) (Point 4))) (Point 2))) (Meet (Join (Join (Join (Point 0) (Point 1)) (Point 2)) (Point 3)) (Point 4))) [] (below_0 _ _) _).
  vm_compute. reflexivity.
Qed.

Lemma on_3_of_space : forall (E F H : extensor space) (x : vector space),
  pure space 1 E -> pure space 1 F -> pure space 1 H -> E ∨ F ∨ H <> number space 0 -> E ∨ F ∨ H ∨ x = number space 0 ->
  forall A B : extensor space, (forall s u v : vector space,
    point space x = bracket (s ∨ space_2 ∨ space_3 ∨ space_4) · E + bracket (u ∨ space_2 ∨ space_3 ∨ space_4) · F + bracket (v ∨ space_2 ∨ space_3 ∨ space_4) · H -> A = B) -> A = B.
Proof.
  intros E F H x pure_E pure_F pure_H N L A B K. destruct (space_decided A B) as [T|no]; [exact T|]. exfalso. apply N.
  destruct (space_is_point E pure_E) as [p ->].
  destruct (space_is_point F pure_F) as [q ->].
  destruct (space_is_point H pure_H) as [r ->].
  rewrite number_0 in *.
  apply (closing_zero space 1 3).
  - rewrite <- (join_one_r space (p ∨ q ∨ r)). rewrite <- ?join_assoc. repeat apply pure_join. apply pure_one.
  - reflexivity.
  - intros l Hl. destruct l as [|y [|]]; try discriminate. cbn [span fold_right].
    rewrite join_one_r. rewrite ?join_assoc.
    destruct (decided (top space (p ∨ q ∨ r ∨ y)) 0) as [w|w]; [exact w|]. exfalso. apply no.
    pose proof (space_split_3 p q r x y) as S. rewrite L in S.
    rewrite (linear_zero space _ (meet_linear_l space _)), plus_zero_r, !bracket_times in S.
    apply (divided space _ _ _ w) in S. rewrite ?scale_plus, <- ?scale_mul in S.
    rewrite <- ?space_scalar_value in S. exact (K _ _ _ S).
Qed.

(* ---- points that depend on each other *)

Ltac plane_point_pure := intros; match goal with |- pure plane 1 _ => rewrite <- (join_one_r plane); apply pure_join, pure_one end.
Ltac space_point_pure := intros; match goal with |- pure space 1 _ => rewrite <- (join_one_r space); apply pure_join, pure_one end.
Ltac rest_plane := rewrite ?plus_zero_r; rewrite ?plus_zero; try reflexivity; try apply plus_comm.
Ltac rest_space := rewrite ?plus_zero_r; rewrite ?plus_zero; rewrite <- ?plus_assoc; rewrite ?plus_zero; try reflexivity; try apply plus_comm.

Lemma dependent_2_of_plane : forall p x : vector plane, p ∨ x = number plane 0 ->
  forall A B : extensor plane,
  (forall s : vector plane, point plane x = bracket (s ∨ plane_2 ∨ plane_3) · p -> A = B)
   -> (forall s : vector plane, point plane p = bracket (s ∨ plane_2 ∨ plane_3) · x -> A = B)
  -> A = B.
Proof.
  intros p x L A B Kx Kp.
  destruct (plane_decided (p) (number plane 0)) as [Z|N].
  - apply (Kp (plane_scalar 0)). rewrite plane_scalar_value, Z, scale_0. apply number_0.
  - apply (on_1_of_plane (p : extensor plane) x); try assumption; plane_point_pure.
Qed.

Lemma dependent_3_of_plane : forall p q x : vector plane, p ∨ q ∨ x = number plane 0 ->
  forall A B : extensor plane,
  (forall s u : vector plane, point plane x = bracket (s ∨ plane_2 ∨ plane_3) · p + bracket (u ∨ plane_2 ∨ plane_3) · q -> A = B)
   -> (forall s u : vector plane, point plane p = bracket (s ∨ plane_2 ∨ plane_3) · x + bracket (u ∨ plane_2 ∨ plane_3) · q -> A = B)
   -> (forall s u : vector plane, point plane q = bracket (s ∨ plane_2 ∨ plane_3) · p + bracket (u ∨ plane_2 ∨ plane_3) · x -> A = B)
  -> A = B.
Proof.
  intros p q x L A B Kx Kp Kq.
  destruct (plane_decided (p ∨ q) (number plane 0)) as [Z|N].
  - apply (dependent_2_of_plane p q Z A B).
    + intros s E. apply (Kq s (plane_scalar 0)). rewrite E, plane_scalar_value, scale_0. rest_plane.
    + intros s E. apply (Kp (plane_scalar 0) s). rewrite E, plane_scalar_value, scale_0. rest_plane.
  - apply (on_2_of_plane (p : extensor plane) (q : extensor plane) x); try assumption; plane_point_pure.
Qed.

Lemma dependent_2_of_space : forall p x : vector space, p ∨ x = number space 0 ->
  forall A B : extensor space,
  (forall s : vector space, point space x = bracket (s ∨ space_2 ∨ space_3 ∨ space_4) · p -> A = B)
   -> (forall s : vector space, point space p = bracket (s ∨ space_2 ∨ space_3 ∨ space_4) · x -> A = B)
  -> A = B.
Proof.
  intros p x L A B Kx Kp.
  destruct (space_decided (p) (number space 0)) as [Z|N].
  - apply (Kp (space_scalar 0)). rewrite space_scalar_value, Z, scale_0. apply number_0.
  - apply (on_1_of_space (p : extensor space) x); try assumption; space_point_pure.
Qed.

Lemma dependent_3_of_space : forall p q x : vector space, p ∨ q ∨ x = number space 0 ->
  forall A B : extensor space,
  (forall s u : vector space, point space x = bracket (s ∨ space_2 ∨ space_3 ∨ space_4) · p + bracket (u ∨ space_2 ∨ space_3 ∨ space_4) · q -> A = B)
   -> (forall s u : vector space, point space p = bracket (s ∨ space_2 ∨ space_3 ∨ space_4) · x + bracket (u ∨ space_2 ∨ space_3 ∨ space_4) · q -> A = B)
   -> (forall s u : vector space, point space q = bracket (s ∨ space_2 ∨ space_3 ∨ space_4) · p + bracket (u ∨ space_2 ∨ space_3 ∨ space_4) · x -> A = B)
  -> A = B.
Proof.
  intros p q x L A B Kx Kp Kq.
  destruct (space_decided (p ∨ q) (number space 0)) as [Z|N].
  - apply (dependent_2_of_space p q Z A B).
    + intros s E. apply (Kq s (space_scalar 0)). rewrite E, space_scalar_value, scale_0. rest_space.
    + intros s E. apply (Kp (space_scalar 0) s). rewrite E, space_scalar_value, scale_0. rest_space.
  - apply (on_2_of_space (p : extensor space) (q : extensor space) x); try assumption; space_point_pure.
Qed.

Lemma dependent_4_of_space : forall p q r x : vector space, p ∨ q ∨ r ∨ x = number space 0 ->
  forall A B : extensor space,
  (forall s u v : vector space, point space x = bracket (s ∨ space_2 ∨ space_3 ∨ space_4) · p + bracket (u ∨ space_2 ∨ space_3 ∨ space_4) · q + bracket (v ∨ space_2 ∨ space_3 ∨ space_4) · r -> A = B)
   -> (forall s u v : vector space, point space p = bracket (s ∨ space_2 ∨ space_3 ∨ space_4) · x + bracket (u ∨ space_2 ∨ space_3 ∨ space_4) · q + bracket (v ∨ space_2 ∨ space_3 ∨ space_4) · r -> A = B)
   -> (forall s u v : vector space, point space q = bracket (s ∨ space_2 ∨ space_3 ∨ space_4) · p + bracket (u ∨ space_2 ∨ space_3 ∨ space_4) · x + bracket (v ∨ space_2 ∨ space_3 ∨ space_4) · r -> A = B)
   -> (forall s u v : vector space, point space r = bracket (s ∨ space_2 ∨ space_3 ∨ space_4) · p + bracket (u ∨ space_2 ∨ space_3 ∨ space_4) · q + bracket (v ∨ space_2 ∨ space_3 ∨ space_4) · x -> A = B)
  -> A = B.
Proof.
  intros p q r x L A B Kx Kp Kq Kr.
  destruct (space_decided (p ∨ q ∨ r) (number space 0)) as [Z|N].
  - apply (dependent_3_of_space p q r Z A B).
    + intros s u E. apply (Kr s u (space_scalar 0)). rewrite E, space_scalar_value, scale_0. rest_space.
    + intros s u E. apply (Kp (space_scalar 0) u s). rewrite E, space_scalar_value, scale_0. rest_space.
    + intros s u E. apply (Kq s (space_scalar 0) u). rewrite E, space_scalar_value, scale_0. rest_space.
  - apply (on_3_of_space (p : extensor space) (q : extensor space) (r : extensor space) x); try assumption; space_point_pure.
Qed.

(* ---- points on a line of space that is no join of two points, and on what joins it with a point *)

Lemma space_scaled_point : forall x (p : vector space), exists q : vector space, scale space x p = q.
Proof.
  intros x [a b c d]. exists (Vector4 (x * a) (x * b) (x * c) (x * d)). cbn. apply space_equal; ring.
Qed.

Lemma space_is_line : forall E : extensor space, pure space 2 E -> exists p12 p13 p14 p23 p24 p34,
  E = Extensor4 0 0 0 0 0 p12 p13 p14 p23 p24 p34 0 0 0 0 0.
Proof.
  intros [a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234] H. exists a12, a13, a14, a23, a24, a34.
  cbn in H. decompose [and] H. clear H.
  repeat match goal with H : _ <> _ -> _ |- _ =>
    (let E := type of H in let N := fresh in
     match E with ?k <> ?n -> _ => assert (N : k <> n) by lia end; specialize (H N); clear N) || clear H end.
  repeat match goal with H : _ /\ _ |- _ => destruct H end. subst. reflexivity.
Qed.

Local Open Scope ring_scope.
Lemma line_point : forall p12 p13 p14 p23 p24 p34 x y z w,
  space_join (Extensor4 0 0 0 0 0 p12 p13 p14 p23 p24 p34 0 0 0 0 0) (space_point (Vector4 x y z w)) =
  Extensor4 0 0 0 0 0 0 0 0 0 0 0 (p12 * z - p13 * y + p23 * x) (p12 * w - p14 * y + p24 * x)
    (p13 * w - p14 * z + p34 * x) (p23 * w - p24 * z + p34 * y) 0.
Proof. intros. cbn. apply space_equal; ring. Qed.

Lemma point_line : forall p12 p13 p14 p23 p24 p34 x y z w,
  space_join (space_point (Vector4 x y z w)) (Extensor4 0 0 0 0 0 p12 p13 p14 p23 p24 p34 0 0 0 0 0) =
  Extensor4 0 0 0 0 0 0 0 0 0 0 0 (p12 * z - p13 * y + p23 * x) (p12 * w - p14 * y + p24 * x)
    (p13 * w - p14 * z + p34 * x) (p23 * w - p24 * z + p34 * y) 0.
Proof. intros. cbn. apply space_equal; ring. Qed.

Lemma full_plane_point : forall f123 f124 f134 f234 x y z w,
  space_join (Extensor4 0 0 0 0 0 0 0 0 0 0 0 f123 f124 f134 f234 0) (space_point (Vector4 x y z w)) =
  Extensor4 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 (f123 * w - f124 * z + f134 * y - f234 * x).
Proof. intros. cbn. apply space_equal; ring. Qed.

Lemma line_plane : forall p12 p13 p14 p23 p24 p34 f123 f124 f134 f234,
  space_meet (Extensor4 0 0 0 0 0 p12 p13 p14 p23 p24 p34 0 0 0 0 0)
    (Extensor4 0 0 0 0 0 0 0 0 0 0 0 f123 f124 f134 f234 0) =
  space_point (Vector4 (p12 * f134 - p13 * f124 + p14 * f123) (p12 * f234 - p23 * f124 + p24 * f123)
    (p13 * f234 - p23 * f134 + p34 * f123) (p14 * f234 - p24 * f134 + p34 * f124)).
Proof. intros. cbn. apply space_equal; ring. Qed.

Lemma plane_line : forall p12 p13 p14 p23 p24 p34 f123 f124 f134 f234,
  space_meet (Extensor4 0 0 0 0 0 0 0 0 0 0 0 f123 f124 f134 f234 0)
    (Extensor4 0 0 0 0 0 p12 p13 p14 p23 p24 p34 0 0 0 0 0) =
  space_point (Vector4 (p12 * f134 - p13 * f124 + p14 * f123) (p12 * f234 - p23 * f124 + p24 * f123)
    (p13 * f234 - p23 * f134 + p34 * f123) (p14 * f234 - p24 * f134 + p34 * f124)).
Proof. intros. cbn. apply space_equal; ring. Qed.

Lemma all_point : forall f x y z w,
  space_meet (Extensor4 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 f) (space_point (Vector4 x y z w)) =
  space_point (Vector4 (f * x) (f * y) (f * z) (f * w)).
Proof. intros. cbn. apply space_equal; ring. Qed.

Lemma scaled_point : forall f x y z w,
  space_scale f (space_point (Vector4 x y z w)) = space_point (Vector4 (f * x) (f * y) (f * z) (f * w)).
Proof. intros. cbn. apply space_equal; ring. Qed.

Lemma plus_points : forall x y z w x' y' z' w',
  space_plus (space_point (Vector4 x y z w)) (space_point (Vector4 x' y' z' w')) =
  space_point (Vector4 (x + x') (y + y') (z + z') (w + w')).
Proof. intros. cbn. apply space_equal; ring. Qed.

Lemma equal_points : forall x y z w x' y' z' w', x = x' -> y = y' -> z = z' -> w = w' ->
  space_point (Vector4 x y z w) = space_point (Vector4 x' y' z' w').
Proof. intros. subst. reflexivity. Qed.

Ltac by_coordinates :=
  cbn [space point plus scale top join meet];
  rewrite ?line_value, ?line_point, ?point_line, ?full_plane_point, ?line_plane, ?plane_line, ?all_point;
  rewrite ?line_value, ?line_point, ?point_line, ?full_plane_point, ?line_plane, ?plane_line, ?all_point;
  cbn [space_top]; rewrite ?scaled_point, ?plus_points;
  apply equal_points; ring.

Local Open Scope extensor_scope.

Lemma space_line_split : forall (E : extensor space) (x y z : vector space), pure space 2 E ->
  scale space (top space (E ∨ y ∨ z)) x = E ∧ (x ∨ y ∨ z) + (E ∨ x) ∧ (y ∨ z).
Proof.
  intros E [] [] [] H. destruct (space_is_line E H) as (p12 & p13 & p14 & p23 & p24 & p34 & ->).
  by_coordinates.
Qed.

Lemma on_line_of_space : forall (E : extensor space) (x : vector space),
  pure space 2 E -> E <> number space 0 -> E ∨ x = number space 0 ->
  forall A B : extensor space, (forall a b c : vector space, point space x = E ∧ (a ∨ b ∨ c) -> A = B) -> A = B.
Proof.
  intros E x P N L A B K. destruct (space_decided A B) as [T|no]; [exact T|]. exfalso. apply N.
  rewrite number_0 in *. apply (closing_zero space 2 2); [exact P | reflexivity |].
  intros l Hl. destruct l as [|y [|z [|]]]; try discriminate. cbn [span fold_right].
  rewrite join_one_r, join_assoc.
  destruct (decided (top space (E ∨ y ∨ z)) 0) as [w|w]; [exact w|]. exfalso. apply no.
  pose proof (space_line_split E x y z P) as S. rewrite L in S.
  rewrite (linear_zero space _ (meet_linear_l space _)), plus_zero_r in S.
  apply (divided space _ _ _ w) in S. rewrite <- meet_scale_r, <- !join_scale_l in S.
  destruct (space_scaled_point (inverse (top space (E ∨ y ∨ z))) x) as [a Ea]. rewrite Ea in S.
  exact (K a y z S).
Qed.

Lemma space_plane_split : forall (p : vector space) (E : extensor space) (x y : vector space), pure space 2 E ->
  scale space (top space (p ∨ E ∨ y)) x =
  scale space (top space (x ∨ E ∨ y)) p + E ∧ (x ∨ p ∨ y) + (p ∨ E ∨ x) ∧ y.
Proof.
  intros [] E [] [] H. destruct (space_is_line E H) as (p12 & p13 & p14 & p23 & p24 & p34 & ->).
  by_coordinates.
Qed.

Lemma on_point_and_line_of_space : forall (E F : extensor space) (x : vector space),
  pure space 1 E -> pure space 2 F -> E ∨ F <> number space 0 -> E ∨ F ∨ x = number space 0 ->
  forall A B : extensor space,
  (forall s a b c : vector space,
    point space x = bracket (s ∨ space_2 ∨ space_3 ∨ space_4) · E + F ∧ (a ∨ b ∨ c) -> A = B) -> A = B.
Proof.
  intros E F x PE PF N L A B K. destruct (space_decided A B) as [T|no]; [exact T|]. exfalso. apply N.
  destruct (space_is_point E PE) as [p ->].
  rewrite number_0 in *. apply (closing_zero space 1 3); [apply pure_join, PF | reflexivity |].
  intros l Hl. destruct l as [|y [|]]; try discriminate. cbn [span fold_right].
  rewrite join_one_r.
  destruct (decided (top space (p ∨ F ∨ y)) 0) as [w|w]; [exact w|]. exfalso. apply no.
  pose proof (space_plane_split p F x y PF) as S. rewrite L in S.
  rewrite (linear_zero space _ (meet_linear_l space _)), plus_zero_r in S.
  apply (divided space _ _ _ w) in S. rewrite scale_plus, <- scale_mul, <- meet_scale_r, <- !join_scale_l in S.
  destruct (space_scaled_point (inverse (top space (p ∨ F ∨ y))) x) as [a Ea]. rewrite Ea in S.
  rewrite <- space_scalar_value in S. exact (K _ a p y S).
Qed.

(* ---- points on a line of the plane, or a plane of space, that is a sum of such *)

Lemma plane_is_line : forall E : extensor plane, pure plane 2 E -> exists p12 p13 p23,
  E = Extensor3 0 0 0 0 p12 p13 p23 0.
Proof.
  intros [a a1 a2 a3 a12 a13 a23 a123] H. exists a12, a13, a23. cbn in H. decompose [and] H. clear H.
  repeat match goal with H : _ <> _ -> _ |- _ =>
    (let E := type of H in let N := fresh in
     match E with ?k <> ?n -> _ => assert (N : k <> n) by lia end; specialize (H N); clear N) || clear H end.
  repeat match goal with H : _ /\ _ |- _ => destruct H end. subst. reflexivity.
Qed.

Lemma space_is_plane : forall E : extensor space, pure space 3 E -> exists f123 f124 f134 f234,
  E = Extensor4 0 0 0 0 0 0 0 0 0 0 0 f123 f124 f134 f234 0.
Proof.
  intros [a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234] H. exists a123, a124, a134, a234.
  cbn in H. decompose [and] H. clear H.
  repeat match goal with H : _ <> _ -> _ |- _ =>
    (let E := type of H in let N := fresh in
     match E with ?k <> ?n -> _ => assert (N : k <> n) by lia end; specialize (H N); clear N) || clear H end.
  repeat match goal with H : _ /\ _ |- _ => destruct H end. subst. reflexivity.
Qed.

Lemma hyperplane_of_plane : forall (E : extensor plane) (x y : vector plane), pure plane 2 E ->
  scale plane (top plane (E ∨ y)) x = E ∧ (x ∨ y) + (E ∨ x) ∧ y.
Proof.
  intros E [] [] H. destruct (plane_is_line E H) as (p12 & p13 & p23 & ->). cbn. apply plane_equal; ring.
Qed.

Lemma hyperplane_of_space : forall (E : extensor space) (x y : vector space), pure space 3 E ->
  scale space (top space (E ∨ y)) x = E ∧ (x ∨ y) + (E ∨ x) ∧ y.
Proof.
  intros E [] [] H. destruct (space_is_plane E H) as (f123 & f124 & f134 & f234 & ->). by_coordinates.
Qed.

Lemma plane_scaled_point : forall x (p : vector plane), exists q : vector plane, scale plane x p = q.
Proof. intros x [a b c]. exists (Vector3 (x * a) (x * b) (x * c)). cbn. apply plane_equal; ring. Qed.

Lemma on_hyperplane_of_plane : forall (E : extensor plane) (x : vector plane),
  pure plane 2 E -> E <> number plane 0 -> E ∨ x = number plane 0 ->
  forall A B : extensor plane, (forall a b : vector plane, point plane x = E ∧ (a ∨ b) -> A = B) -> A = B.
Proof.
  intros E x P N L A B K. destruct (plane_decided A B) as [T|no]; [exact T|]. exfalso. apply N.
  rewrite number_0 in *. apply (closing_zero plane 1 2); [exact P | reflexivity |].
  intros l Hl. destruct l as [|y [|]]; try discriminate. cbn [span fold_right]. rewrite join_one_r.
  destruct (decided (top plane (E ∨ y)) 0) as [w|w]; [exact w|]. exfalso. apply no.
  pose proof (hyperplane_of_plane E x y P) as S. rewrite L in S.
  rewrite (linear_zero plane _ (meet_linear_l plane _)), plus_zero_r in S.
  apply (divided plane _ _ _ w) in S. rewrite <- meet_scale_r, <- join_scale_l in S.
  destruct (plane_scaled_point (inverse (top plane (E ∨ y))) x) as [a Ea]. rewrite Ea in S.
  exact (K a y S).
Qed.

Lemma on_hyperplane_of_space : forall (E : extensor space) (x : vector space),
  pure space 3 E -> E <> number space 0 -> E ∨ x = number space 0 ->
  forall A B : extensor space, (forall a b : vector space, point space x = E ∧ (a ∨ b) -> A = B) -> A = B.
Proof.
  intros E x P N L A B K. destruct (space_decided A B) as [T|no]; [exact T|]. exfalso. apply N.
  rewrite number_0 in *. apply (closing_zero space 1 3); [exact P | reflexivity |].
  intros l Hl. destruct l as [|y [|]]; try discriminate. cbn [span fold_right]. rewrite join_one_r.
  destruct (decided (top space (E ∨ y)) 0) as [w|w]; [exact w|]. exfalso. apply no.
  pose proof (hyperplane_of_space E x y P) as S. rewrite L in S.
  rewrite (linear_zero space _ (meet_linear_l space _)), plus_zero_r in S.
  apply (divided space _ _ _ w) in S. rewrite <- meet_scale_r, <- join_scale_l in S.
  destruct (space_scaled_point (inverse (top space (E ∨ y))) x) as [a Ea]. rewrite Ea in S.
  exact (K a y S).
Qed.

(* ---- points that are said to be equal to an expression *)

Lemma equal_to : forall (G : geometry) (X W : extensor G), X + number G (-1) · W = number G 0 ->
  forall A B : extensor G, (X = W -> A = B) -> A = B.
Proof.
  intros G X W H A B K. apply K. rewrite number_0 in H. unfold number in H. rewrite join_scale_l, join_one_l in H.
  rewrite <- (plus_zero_r G X). replace (zero G) with (plus G (scale G (whole (-1)) W) W) at 1.
  - rewrite plus_assoc, H. apply plus_zero.
  - rewrite <- (scale_1 G W) at 2. rewrite <- scale_add. rewrite <- whole_1, <- whole_add.
    change (-1 + 1)%Z with 0%Z. rewrite whole_0. apply scale_0.
Qed.

(* ---- fractions *)

Theorem replay_in_fractions : forall (G : geometry) c r at_ ideal n x y places relations,
  whole c * bracket_value G at_ r = 1 -> forallb (fun i => Nat.ltb i n) r = true ->
  (forall i, (i < ideal)%nat -> infinite G (at_ i)) -> placed G at_ places ->
  follows_in_fractions c r (rank G) ideal n (Sum (all_put places x) (Join (Number (-1)) (all_put places y))) (Number 0)
    relations = true ->
  value G at_ x = value G at_ y.
Proof.
  intros G c r at_ ideal n x y places relations Hc L Hi Hp H.
  apply (follows_in_fractions_sound G c r at_ ideal n _ (Number 0) _ Hc L Hi (eq_refl _)) in H. cbn [value] in H.
  rewrite !(all_put_value G at_ places _ Hp) in H. exact (equal_to G _ _ H _ _ (fun e => e)).
Qed.

Lemma plane_inverse : forall c, number plane c <> number plane 0 ->
  exists s : vector plane, whole c * top plane (span plane [s; plane_2; plane_3]) = 1.
Proof.
  intros c H. exists (plane_scalar (inverse (whole c))).
  assert (N : whole c <> 0). { intros Z. apply H. unfold number. rewrite Z, whole_0. reflexivity. }
  rewrite <- (inverse_left _ N). cbn. ring.
Qed.

Lemma space_inverse : forall c, number space c <> number space 0 ->
  exists s : vector space, whole c * top space (span space [s; space_2; space_3; space_4]) = 1.
Proof.
  intros c H. exists (space_scalar (inverse (whole c))).
  assert (N : whole c <> 0). { intros Z. apply H. unfold number. rewrite Z, whole_0. reflexivity. }
  rewrite <- (inverse_left _ N). cbn. ring.
Qed.

(* ---- points on two lines of space that meet: E ∨ a is a plane through the line E *)

Lemma space_lines_split : forall (E F : extensor space) (a p : vector space), pure space 2 E -> pure space 2 F ->
  F ∨ p = zero space -> ((E ∨ a) ∧ F) ∨ p = scale space (top space (E ∨ a ∨ p)) F.
Proof.
  intros E F a p H H' Fp. pose proof (meet_join space (E ∨ a) p F) as S.
  assert (pF : (p ∨ F : extensor space) = zero space).
  { rewrite <- Fp. destruct (space_is_line F H') as (q12 & q13 & q14 & q23 & q24 & q34 & ->). destruct p.
    cbn. apply space_equal; ring. }
  rewrite pF, (linear_zero space _ (meet_linear_r space _)), (linear_zero space _ (involution_linear space)),
    plus_zero_r in S.
  rewrite <- S. apply pure_full.
  change (rank space) with 4%nat. rewrite !join_reverse. do 2 apply pure_join, pure_involution. exact H.
Qed.

Lemma on_meeting_lines_of_space : forall (E F : extensor space) (p x : vector space),
  pure space 2 E -> pure space 2 F -> E ∨ p <> number space 0 -> F <> number space 0 -> F ∨ p = number space 0 ->
  E ∨ x = number space 0 -> F ∨ x = number space 0 ->
  forall A B : extensor space, (forall a : vector space, point space x = (E ∨ a) ∧ F -> A = B) -> A = B.
Proof.
  intros E F p x PE PF N M Fp Ex Fx A B K. destruct (space_decided A B) as [T|no]; [exact T|]. exfalso. apply N.
  rewrite number_0 in *.
  apply (closing_zero space 1 3); [rewrite join_reverse; apply pure_join, pure_involution, PE | reflexivity |].
  intros l Hl. destruct l as [|a [|]]; try discriminate. cbn [span fold_right].
  rewrite join_one_r.
  assert (turned : (E ∨ p ∨ a : extensor space) = scale space (- (1)) (E ∨ a ∨ p)).
  { rewrite <- !join_assoc, join_swap, join_scale_r. reflexivity. }
  rewrite turned, top_scale.
  destruct (decided (top space (E ∨ a ∨ p)) 0) as [w|w]; [rewrite w; ring|]. exfalso. apply no.
  assert (PY : pure space 1 ((E ∨ a) ∧ F)).
  { destruct (space_is_line E PE) as (p12 & p13 & p14 & p23 & p24 & p34 & ->).
    destruct (space_is_line F PF) as (q12 & q13 & q14 & q23 & q24 & q34 & ->).
    destruct a as [x1 x2 x3 x4]. cbn. repeat apply conj; intros; repeat apply conj; try ring; lia. }
  apply (on_1_of_space ((E ∨ a) ∧ F) x PY).
  - intros Y. apply M. pose proof (space_lines_split E F a p PE PF Fp) as S.
    rewrite Y, number_0, (linear_zero space _ (join_linear_l space _)) in S.
    rewrite (divided space _ F _ w (eq_sym S)). apply scale_zero.
  - pose proof (space_lines_split E F a x PE PF Fx) as S. rewrite <- (join_assoc space E) in S.
    assert (ax : (E ∨ (a ∨ x) : extensor space) = zero space).
    { rewrite join_swap, join_scale_r, join_assoc, Ex, (linear_zero space _ (join_linear_l space _)). apply scale_zero. }
    rewrite ax, (top_zero space), scale_0 in S. rewrite number_0. exact S.
  - intros s S. destruct s as [s1 s2 s3 s].
    set (c := top space ((Vector4 s1 s2 s3 s : vector space) ∨ space_2 ∨ space_3 ∨ space_4)).
    destruct (space_scaled_point c a) as [b Eb]. apply (K b). rewrite S, bracket_times. fold c.
    rewrite <- Eb, join_scale_r, meet_scale_l. reflexivity.
Qed.

(* a line that is on a plane: their meet vanishes in either sequence *)
Lemma turned_of_space : forall E F : extensor space, pure space 2 E -> pure space 3 F ->
  E ∧ F = number space 0 -> F ∧ E = number space 0.
Proof.
  intros E [b b1 b2 b3 b4 b12 b13 b14 b23 b24 b34 b123 b124 b134 b234 b1234] PE H M.
  destruct (space_is_line E PE) as (p12 & p13 & p14 & p23 & p24 & p34 & ->).
  cbn in H. decompose [and] H. clear H.
  repeat match goal with H : _ <> _ -> _ |- _ =>
    (let E := type of H in let N := fresh in
     match E with ?k <> ?n -> _ => assert (N : k <> n) by lia end; specialize (H N); clear N) || clear H end.
  repeat match goal with H : _ /\ _ |- _ => destruct H end. subst.
  rewrite <- M. cbn. apply space_equal; ring.
Qed.

Local Open Scope nat_scope.
Local Open Scope extensor_scope.
