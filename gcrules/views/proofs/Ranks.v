(* ---- any rank

   In rank d + 1 an extensor is A + B ∨ e, where A and B are extensors in rank d and e is the last basis point. Joins are
   exterior products: e ∨ C = C' ∨ e, where C' is C with the sign of its step (`lifted_involution`). Of meets the splitting
   formula leaves what follows, as A and C do not span e. There is no superbracket here. *)

Local Open Scope ring_scope.

Fixpoint lifted (d : nat) : Type :=
  match d with O => R | S d' => (lifted d' * lifted d')%type end.

Fixpoint coordinates_of (d : nat) : Type :=
  match d with O => unit | S d' => (coordinates_of d' * R)%type end.

Fixpoint lifted_zero (d : nat) : lifted d :=
  match d with O => 0 | S d' => (lifted_zero d', lifted_zero d') end.

Fixpoint lifted_one (d : nat) : lifted d :=
  match d with O => 1 | S d' => (lifted_one d', lifted_zero d') end.

Fixpoint lifted_plus (d : nat) : lifted d -> lifted d -> lifted d :=
  match d with
  | O => fun x y => x + y
  | S d' => fun '(A, B) '(C, D) => (lifted_plus d' A C, lifted_plus d' B D)
  end.

Fixpoint lifted_scale (d : nat) (x : R) : lifted d -> lifted d :=
  match d with
  | O => fun y => x * y
  | S d' => fun '(A, B) => (lifted_scale d' x A, lifted_scale d' x B)
  end.

Fixpoint lifted_involution (d : nat) : lifted d -> lifted d :=
  match d with
  | O => fun x => x
  | S d' => fun '(A, B) => (lifted_involution d' A, lifted_scale d' (- (1)) (lifted_involution d' B))
  end.

Fixpoint lifted_join (d : nat) : lifted d -> lifted d -> lifted d :=
  match d with
  | O => fun x y => x * y
  | S d' => fun '(A, B) '(C, D) =>
    (lifted_join d' A C, lifted_plus d' (lifted_join d' A D) (lifted_join d' B (lifted_involution d' C)))
  end.

Fixpoint lifted_meet (d : nat) : lifted d -> lifted d -> lifted d :=
  match d with
  | O => fun x y => x * y
  | S d' => fun '(A, B) '(C, D) =>
    (lifted_plus d' (lifted_meet d' A D) (lifted_involution d' (lifted_meet d' B (lifted_involution d' C))),
     lifted_meet d' B D)
  end.

Fixpoint lifted_top (d : nat) : lifted d -> R :=
  match d with O => fun x => x | S d' => fun '(A, B) => lifted_top d' B end.

Fixpoint lifted_point (d : nat) : coordinates_of d -> lifted d :=
  match d with
  | O => fun _ => 0
  | S d' => fun '(p, w) => (lifted_point d' p, lifted_scale d' w (lifted_one d'))
  end.

Fixpoint origin (d : nat) : coordinates_of d :=
  match d with O => tt | S d' => (origin d', 1) end.

Fixpoint lifted_pure (d k : nat) : lifted d -> Prop :=
  match d with
  | O => fun x => k <> 0%nat -> x = 0
  | S d' => fun '(A, B) => lifted_pure d' k A /\ match k with O => B = lifted_zero d' | S k' => lifted_pure d' k' B end
  end.

Definition lifted_infinite (d : nat) : coordinates_of (S d) -> Prop := fun '(p, w) => w = 0.
Definition lifted_flat (d : nat) : lifted (S d) -> Prop := fun '(A, B) => B = lifted_zero d.

(* one coordinate: the basis points that it is of are those where the list says yes, from the last one on *)
Fixpoint coordinate (d : nat) (l : list bool) : lifted d -> R :=
  match d with
  | O => fun x => x
  | S d' => fun '(A, B) => if hd false l then coordinate d' (tl l) B else coordinate d' (tl l) A
  end.

Lemma by_coordinate : forall d A B, (forall l, coordinate d l A = coordinate d l B) -> A = B.
Proof.
  induction d; [intros A B H; exact (H [])|]. intros [A B] [C D] H.
  f_equal; apply IHd; intros l; [exact (H (false :: l)) | exact (H (true :: l))].
Qed.

Lemma coordinate_zero : forall d l, coordinate d l (lifted_zero d) = 0.
Proof. induction d; intros; [reflexivity|]. cbn. destruct (hd false l); apply IHd. Qed.
Lemma coordinate_plus : forall d l A B, coordinate d l (lifted_plus d A B) = coordinate d l A + coordinate d l B.
Proof. induction d; intros; [reflexivity|]. destruct A, B. cbn. destruct (hd false l); apply IHd. Qed.
Lemma coordinate_scale : forall d l x A, coordinate d l (lifted_scale d x A) = x * coordinate d l A.
Proof. induction d; intros; [reflexivity|]. destruct A. cbn. destruct (hd false l); apply IHd. Qed.

(* equations of sums and multiples *)
Ltac linear_ring :=
  apply by_coordinate; intros; rewrite ?coordinate_plus, ?coordinate_scale, ?coordinate_plus, ?coordinate_scale;
  repeat (rewrite coordinate_plus || rewrite coordinate_scale || rewrite coordinate_zero); ring.

Lemma lifted_plus_comm : forall d A B, lifted_plus d A B = lifted_plus d B A.
Proof. intros. linear_ring. Qed.
Lemma lifted_plus_assoc : forall d A B C, lifted_plus d A (lifted_plus d B C) = lifted_plus d (lifted_plus d A B) C.
Proof. intros. linear_ring. Qed.
Lemma lifted_plus_zero : forall d A, lifted_plus d (lifted_zero d) A = A.
Proof. intros. linear_ring. Qed.
Lemma lifted_scale_plus : forall d x A B,
  lifted_scale d x (lifted_plus d A B) = lifted_plus d (lifted_scale d x A) (lifted_scale d x B).
Proof. intros. linear_ring. Qed.
Lemma lifted_scale_add : forall d x y A,
  lifted_scale d (x + y) A = lifted_plus d (lifted_scale d x A) (lifted_scale d y A).
Proof. intros. linear_ring. Qed.
Lemma lifted_scale_mul : forall d x y A, lifted_scale d (x * y) A = lifted_scale d x (lifted_scale d y A).
Proof. intros. linear_ring. Qed.
Lemma lifted_scale_1 : forall d A, lifted_scale d 1 A = A.
Proof. intros. linear_ring. Qed.
Lemma lifted_scale_0 : forall d A, lifted_scale d 0 A = lifted_zero d.
Proof. intros. linear_ring. Qed.
Lemma lifted_scale_zero : forall d x, lifted_scale d x (lifted_zero d) = lifted_zero d.
Proof. intros. linear_ring. Qed.

Lemma lifted_involution_plus : forall d A B,
  lifted_involution d (lifted_plus d A B) = lifted_plus d (lifted_involution d A) (lifted_involution d B).
Proof. induction d; intros; [reflexivity|]. destruct A, B. cbn. rewrite !IHd. f_equal. linear_ring. Qed.
Lemma lifted_involution_scale : forall d x A,
  lifted_involution d (lifted_scale d x A) = lifted_scale d x (lifted_involution d A).
Proof. induction d; intros; [reflexivity|]. destruct A. cbn. rewrite !IHd. f_equal. linear_ring. Qed.
Lemma lifted_involution_zero : forall d, lifted_involution d (lifted_zero d) = lifted_zero d.
Proof. intros. rewrite <- (lifted_scale_0 d (lifted_zero d)), lifted_involution_scale, !lifted_scale_0. reflexivity. Qed.
Lemma lifted_involution_one : forall d, lifted_involution d (lifted_one d) = lifted_one d.
Proof. induction d; [reflexivity|]. cbn. rewrite IHd, lifted_involution_zero, lifted_scale_zero. reflexivity. Qed.
Lemma lifted_involution_twice : forall d A, lifted_involution d (lifted_involution d A) = A.
Proof.
  induction d; intros; [reflexivity|]. destruct A. cbn. rewrite lifted_involution_scale, !IHd. f_equal. linear_ring.
Qed.

Lemma lifted_join_plus_l : forall d A B C,
  lifted_join d (lifted_plus d A B) C = lifted_plus d (lifted_join d A C) (lifted_join d B C).
Proof. induction d; intros; [cbn; ring|]. destruct A, B, C. cbn. rewrite !IHd. f_equal. linear_ring. Qed.
Lemma lifted_join_plus_r : forall d A B C,
  lifted_join d A (lifted_plus d B C) = lifted_plus d (lifted_join d A B) (lifted_join d A C).
Proof.
  induction d; intros; [cbn; ring|]. destruct A, B, C. cbn. rewrite lifted_involution_plus, !IHd. f_equal. linear_ring.
Qed.
Lemma lifted_join_scale_l : forall d x A B, lifted_join d (lifted_scale d x A) B = lifted_scale d x (lifted_join d A B).
Proof. induction d; intros; [cbn; ring|]. destruct A, B. cbn. rewrite !IHd. f_equal. linear_ring. Qed.
Lemma lifted_join_scale_r : forall d x A B, lifted_join d A (lifted_scale d x B) = lifted_scale d x (lifted_join d A B).
Proof.
  induction d; intros; [cbn; ring|]. destruct A, B. cbn. rewrite lifted_involution_scale, !IHd. f_equal. linear_ring.
Qed.
Lemma lifted_join_zero_l : forall d A, lifted_join d (lifted_zero d) A = lifted_zero d.
Proof. intros. rewrite <- (lifted_scale_0 d (lifted_zero d)), lifted_join_scale_l, !lifted_scale_0. reflexivity. Qed.
Lemma lifted_join_zero_r : forall d A, lifted_join d A (lifted_zero d) = lifted_zero d.
Proof. intros. rewrite <- (lifted_scale_0 d (lifted_zero d)), lifted_join_scale_r, !lifted_scale_0. reflexivity. Qed.
Lemma lifted_join_one_l : forall d A, lifted_join d (lifted_one d) A = A.
Proof.
  induction d; intros; [cbn; ring|]. destruct A. cbn. rewrite !IHd, lifted_join_zero_l. f_equal. linear_ring.
Qed.
Lemma lifted_join_one_r : forall d A, lifted_join d A (lifted_one d) = A.
Proof.
  induction d; intros; [cbn; ring|]. destruct A. cbn. rewrite lifted_involution_one, !IHd, lifted_join_zero_r.
  f_equal. linear_ring.
Qed.

Lemma lifted_involution_of_join : forall d A B,
  lifted_involution d (lifted_join d A B) = lifted_join d (lifted_involution d A) (lifted_involution d B).
Proof.
  induction d; intros; [reflexivity|]. destruct A, B. cbn.
  rewrite lifted_involution_plus, !IHd, lifted_join_scale_l, lifted_join_scale_r. f_equal. linear_ring.
Qed.

Lemma lifted_join_assoc : forall d A B C, lifted_join d A (lifted_join d B C) = lifted_join d (lifted_join d A B) C.
Proof.
  induction d; intros; [cbn; ring|]. destruct A, B, C. cbn.
  rewrite lifted_involution_of_join, lifted_join_plus_r, lifted_join_plus_l, !IHd. f_equal. linear_ring.
Qed.

Lemma lifted_involution_point : forall d p,
  lifted_involution d (lifted_point d p) = lifted_scale d (- (1)) (lifted_point d p).
Proof.
  induction d; intros; [cbn; ring|]. destruct p. cbn. rewrite IHd, lifted_involution_scale, lifted_involution_one.
  reflexivity.
Qed.

Lemma lifted_join_same : forall d p, lifted_join d (lifted_point d p) (lifted_point d p) = lifted_zero d.
Proof.
  induction d; intros; [cbn; ring|]. destruct p. cbn.
  rewrite IHd, lifted_involution_point, !lifted_join_scale_r, lifted_join_scale_l, lifted_join_one_l, lifted_join_one_r.
  f_equal. linear_ring.
Qed.
Lemma lifted_join_swap : forall d p q, lifted_join d (lifted_point d p) (lifted_point d q) =
  lifted_scale d (- (1)) (lifted_join d (lifted_point d q) (lifted_point d p)).
Proof.
  induction d; intros; [cbn; ring|]. destruct p, q. cbn.
  rewrite IHd, !lifted_involution_point, !lifted_join_scale_r, !lifted_join_scale_l, !lifted_join_one_l, !lifted_join_one_r.
  f_equal. linear_ring.
Qed.
Lemma lifted_join_reverse : forall d A p,
  lifted_join d A (lifted_point d p) = lifted_join d (lifted_point d p) (lifted_involution d A).
Proof.
  induction d; intros; [cbn; ring|]. destruct A as [A B], p as [p w]. cbn.
  rewrite lifted_involution_point, lifted_involution_twice, !lifted_join_scale_r, !lifted_join_scale_l, !IHd,
    lifted_join_one_l, lifted_join_one_r. f_equal. linear_ring.
Qed.
Lemma lifted_involution_join : forall d p A, lifted_involution d (lifted_join d (lifted_point d p) A) =
  lifted_scale d (- (1)) (lifted_join d (lifted_point d p) (lifted_involution d A)).
Proof. intros. rewrite lifted_involution_of_join, lifted_involution_point. apply lifted_join_scale_l. Qed.

Lemma lifted_meet_plus_l : forall d A B C,
  lifted_meet d (lifted_plus d A B) C = lifted_plus d (lifted_meet d A C) (lifted_meet d B C).
Proof.
  induction d; intros; [cbn; ring|]. destruct A, B, C. cbn. rewrite !IHd, lifted_involution_plus. f_equal. linear_ring.
Qed.
Lemma lifted_meet_plus_r : forall d A B C,
  lifted_meet d A (lifted_plus d B C) = lifted_plus d (lifted_meet d A B) (lifted_meet d A C).
Proof.
  induction d; intros; [cbn; ring|]. destruct A, B, C. cbn. rewrite !lifted_involution_plus, !IHd, lifted_involution_plus.
  f_equal. linear_ring.
Qed.
Lemma lifted_meet_scale_l : forall d x A B, lifted_meet d (lifted_scale d x A) B = lifted_scale d x (lifted_meet d A B).
Proof.
  induction d; intros; [cbn; ring|]. destruct A, B. cbn. rewrite !IHd, lifted_involution_scale. f_equal. linear_ring.
Qed.
Lemma lifted_meet_scale_r : forall d x A B, lifted_meet d A (lifted_scale d x B) = lifted_scale d x (lifted_meet d A B).
Proof.
  induction d; intros; [cbn; ring|]. destruct A, B. cbn. rewrite lifted_involution_scale, !IHd, lifted_involution_scale.
  f_equal. linear_ring.
Qed.
Lemma lifted_meet_zero_l : forall d A, lifted_meet d (lifted_zero d) A = lifted_zero d.
Proof. intros. rewrite <- (lifted_scale_0 d (lifted_zero d)), lifted_meet_scale_l, !lifted_scale_0. reflexivity. Qed.

Lemma lifted_top_plus : forall d A B, lifted_top d (lifted_plus d A B) = lifted_top d A + lifted_top d B.
Proof. induction d; intros; [reflexivity|]. destruct A, B. apply IHd. Qed.
Lemma lifted_top_scale : forall d x A, lifted_top d (lifted_scale d x A) = x * lifted_top d A.
Proof. induction d; intros; [reflexivity|]. destruct A. apply IHd. Qed.
Lemma lifted_top_zero : forall d, lifted_top d (lifted_zero d) = 0.
Proof. induction d; [reflexivity | apply IHd]. Qed.

Lemma lifted_meet_one : forall d B, lifted_meet d (lifted_one d) B = lifted_scale d (lifted_top d B) (lifted_one d).
Proof.
  induction d; intros; [cbn; ring|]. destruct B. cbn.
  rewrite IHd, !lifted_meet_zero_l, lifted_involution_zero, lifted_scale_zero. f_equal. linear_ring.
Qed.

Lemma lifted_meet_join : forall d A p B, lifted_meet d (lifted_join d A (lifted_point d p)) B =
  lifted_plus d (lifted_join d (lifted_meet d A B) (lifted_point d p))
    (lifted_involution d (lifted_meet d A (lifted_join d (lifted_point d p) B))).
Proof.
  induction d; intros; [cbn; ring|]. destruct A as [A A'], p as [p w], B as [C D]. cbn.
  rewrite !lifted_involution_point, !lifted_join_scale_r, !lifted_join_scale_l, !lifted_join_one_l, !lifted_join_one_r.
  rewrite !lifted_meet_plus_l, !lifted_meet_plus_r, !lifted_meet_scale_l, !lifted_meet_scale_r, !IHd,
    !lifted_involution_of_join, !lifted_involution_point.
  repeat (rewrite lifted_involution_plus || rewrite lifted_involution_scale || rewrite lifted_involution_twice
    || rewrite lifted_involution_of_join || rewrite lifted_involution_point || rewrite lifted_join_scale_l
    || rewrite lifted_join_scale_r || rewrite lifted_join_plus_l || rewrite lifted_join_plus_r
    || rewrite lifted_meet_scale_r || rewrite lifted_meet_scale_l).
  f_equal; linear_ring.
Qed.

Lemma lifted_pure_zero : forall d k, lifted_pure d k (lifted_zero d).
Proof.
  induction d; intros k; [intros _; reflexivity|]. split; [apply IHd|]. destruct k; [reflexivity | apply IHd].
Qed.
Lemma lifted_pure_plus : forall d k A B,
  lifted_pure d k A -> lifted_pure d k B -> lifted_pure d k (lifted_plus d A B).
Proof.
  induction d; intros k A B; cbn.
  - intros HA HB N. rewrite (HA N), (HB N). ring.
  - destruct A, B. intros [HA HA'] [HB HB']. split; [apply IHd; assumption|].
    destruct k; [subst; apply lifted_plus_zero | apply IHd; assumption].
Qed.
Lemma lifted_pure_scale : forall d k x A, lifted_pure d k A -> lifted_pure d k (lifted_scale d x A).
Proof.
  induction d; intros k x A; cbn.
  - intros H N. rewrite (H N). ring.
  - destruct A. intros [H H']. split; [apply IHd, H|]. destruct k; [subst; apply lifted_scale_zero | apply IHd, H'].
Qed.
Lemma lifted_pure_involution : forall d k A, lifted_pure d k A -> lifted_pure d k (lifted_involution d A).
Proof.
  induction d; intros k A; cbn; [exact (fun H => H)|]. destruct A. intros [H H']. split; [apply IHd, H|].
  destruct k; [subst; rewrite lifted_involution_zero; apply lifted_scale_zero | apply lifted_pure_scale, IHd, H'].
Qed.
Lemma lifted_pure_one : forall d, lifted_pure d 0 (lifted_one d).
Proof. induction d; [intros N; contradiction|]. split; [exact IHd | reflexivity]. Qed.
Lemma lifted_pure_join : forall d k p A,
  lifted_pure d k A -> lifted_pure d (S k) (lifted_join d (lifted_point d p) A).
Proof.
  induction d; intros k p A; cbn; [intros; ring|]. destruct p as [p w], A as [A B]. intros [HA HB].
  split; [apply IHd, HA|]. rewrite lifted_join_scale_l, lifted_join_one_l.
  apply lifted_pure_plus; [|apply lifted_pure_scale, lifted_pure_involution, HA].
  destruct k; [subst; rewrite lifted_join_zero_r; apply lifted_pure_zero | apply IHd, HB].
Qed.
Lemma lifted_pure_top : forall d k A, lifted_pure d k A -> k <> d -> lifted_top d A = 0.
Proof.
  induction d; intros k A; cbn; [intros H N; exact (H N)|]. destruct A as [A B]. intros [_ H] N.
  destruct k; [subst; apply lifted_top_zero | apply (IHd k); [exact H | congruence]].
Qed.
Lemma lifted_pure_beyond : forall d k A, lifted_pure d k A -> (d < k)%nat -> A = lifted_zero d.
Proof.
  induction d; intros k A; cbn; [intros H L; apply H; lia|]. destruct A as [A B]. intros [HA HB] L.
  f_equal; [apply (IHd k); [exact HA | lia]|]. destruct k; [exact HB | apply (IHd k); [exact HB | lia]].
Qed.
Lemma lifted_pure_full : forall d A B, lifted_pure d d A -> lifted_meet d A B = lifted_scale d (lifted_top d A) B.
Proof.
  induction d; intros A B; [reflexivity|]. destruct A as [A A'], B as [C D]. intros [HA HA']. cbn.
  rewrite (lifted_pure_beyond d (S d) A HA) by lia.
  rewrite !lifted_meet_zero_l, !(IHd A' _ HA'), lifted_involution_scale, lifted_involution_twice, lifted_plus_zero.
  reflexivity.
Qed.
Lemma lifted_pure_last : forall d A, lifted_pure d d A -> lifted_top d A = 0 -> A = lifted_zero d.
Proof.
  induction d; intros A; [exact (fun _ H => H)|]. destruct A as [A B]. intros [HA HB] T. cbn.
  f_equal; [apply (lifted_pure_beyond d (S d) A HA); lia | exact (IHd B HB T)].
Qed.
Lemma lifted_zero_test : forall d A,
  (forall p, lifted_join d A (lifted_point d p) = lifted_zero d) -> lifted_top d A = 0 -> A = lifted_zero d.
Proof.
  induction d; intros A H T; [exact T|]. destruct A as [A B].
  assert (K : forall p w, lifted_plus d (lifted_scale d w A) (lifted_scale d (- (1)) (lifted_join d B (lifted_point d p)))
    = lifted_zero d).
  { intros p w. specialize (H (p, w)). cbn in H. injection H as _ H.
    rewrite lifted_involution_point, !lifted_join_scale_r, lifted_join_one_r in H. exact H. }
  assert (Z : forall p, lifted_join d B (lifted_point d p) = lifted_zero d).
  { intros p. rewrite <- (lifted_scale_zero d (- (1))), <- (K p 0). linear_ring. }
  cbn. f_equal; [|exact (IHd B Z T)]. rewrite <- (K (origin d) 1), Z. linear_ring.
Qed.
Lemma lifted_scalar_zero : forall d x, lifted_scale d x (lifted_one d) = lifted_zero d -> x = 0.
Proof.
  induction d; cbn; intros x H; [rewrite <- H; ring|]. injection H as H _. exact (IHd x H).
Qed.
Lemma lifted_flat_join : forall d p A, lifted_infinite d p -> lifted_flat d A ->
  lifted_flat d (lifted_join (S d) (lifted_point (S d) p) A).
Proof.
  intros d [p w] [A B]. cbn. intros -> ->. rewrite lifted_join_zero_r, lifted_scale_0, lifted_join_zero_l.
  apply lifted_plus_zero.
Qed.
Lemma lifted_flat_top : forall d A, lifted_flat d A -> lifted_top (S d) A = 0.
Proof. intros d [A B]. cbn. intros ->. apply lifted_top_zero. Qed.

Lemma no_form : forall d, linear_form (lifted_plus d) (lifted_scale d) (fun _ => 0).
Proof. split; intros; ring. Qed.

Definition of_rank (d : nat) (other : S d <> 4%nat) : geometry := {|
  rank := S d; vector := coordinates_of (S d); extensor := lifted (S d);
  zero := lifted_zero (S d);
  one := lifted_one (S d);
  plus := lifted_plus (S d);
  scale := lifted_scale (S d);
  join := lifted_join (S d);
  meet := lifted_meet (S d);
  top := lifted_top (S d);
  point := lifted_point (S d);
  super := fun _ _ _ _ _ _ => 0;
  infinite := lifted_infinite d;
  flat := lifted_flat d;
  pure := lifted_pure (S d);
  involution := lifted_involution (S d);
  plus_comm := lifted_plus_comm (S d);
  plus_assoc := lifted_plus_assoc (S d);
  plus_zero := lifted_plus_zero (S d);
  scale_plus := lifted_scale_plus (S d);
  scale_add := lifted_scale_add (S d);
  scale_mul := lifted_scale_mul (S d);
  scale_1 := lifted_scale_1 (S d);
  scale_0 := lifted_scale_0 (S d);
  join_plus_l := lifted_join_plus_l (S d);
  join_plus_r := lifted_join_plus_r (S d);
  join_scale_l := lifted_join_scale_l (S d);
  join_scale_r := lifted_join_scale_r (S d);
  join_assoc := lifted_join_assoc (S d);
  join_one_l := lifted_join_one_l (S d);
  join_one_r := lifted_join_one_r (S d);
  join_same := lifted_join_same (S d);
  join_swap := lifted_join_swap (S d);
  meet_plus_l := lifted_meet_plus_l (S d);
  meet_plus_r := lifted_meet_plus_r (S d);
  meet_scale_l := lifted_meet_scale_l (S d);
  meet_scale_r := lifted_meet_scale_r (S d);
  meet_one := lifted_meet_one (S d);
  meet_join := lifted_meet_join (S d);
  involution_plus := lifted_involution_plus (S d);
  involution_scale := lifted_involution_scale (S d);
  involution_one := lifted_involution_one (S d);
  involution_join := lifted_involution_join (S d);
  top_plus := lifted_top_plus (S d);
  top_scale := lifted_top_scale (S d);
  pure_one := lifted_pure_one (S d);
  pure_join := lifted_pure_join (S d);
  pure_plus := lifted_pure_plus (S d);
  pure_scale := lifted_pure_scale (S d);
  pure_top := lifted_pure_top (S d);
  pure_full := lifted_pure_full (S d);
  join_reverse := lifted_join_reverse (S d);
  pure_involution := lifted_pure_involution (S d);
  pure_last := lifted_pure_last (S d);
  zero_test := lifted_zero_test (S d);
  scalar_zero := lifted_scalar_zero (S d);
  flat_one := eq_refl : lifted_flat d (lifted_one (S d));
  flat_join := lifted_flat_join d;
  flat_top := lifted_flat_top d;
  super_linear_1 := fun _ _ _ _ _ => no_form (S d);
  super_linear_2 := fun _ _ _ _ _ => no_form (S d);
  super_linear_3 := fun _ _ _ _ _ => no_form (S d);
  super_linear_4 := fun _ _ _ _ _ => no_form (S d);
  super_linear_5 := fun _ _ _ _ _ => no_form (S d);
  super_linear_6 := fun _ _ _ _ _ => no_form (S d);
  super_points := fun four => match other four with end
|}.

(* ---- what the coordinates mean: a bracket is a determinant *)

Lemma bracket_in_rank_2 : forall x y x' y',
  lifted_top 2 (lifted_join 2 (lifted_point 2 (tt, x, y)) (lifted_point 2 (tt, x', y'))) =
  determinant (map (fun p i => nth i p 0) [[x; y]; [x'; y']]) [0; 1]%nat.
Proof. intros. cbn. ring. Qed.

Lemma bracket_in_rank_5 : forall p q r s t : coordinates_of 5,
  lifted_top 5 (fold_right (fun x A => lifted_join 5 (lifted_point 5 x) A) (lifted_one 5) [p; q; r; s; t]) =
  determinant (map (fun x i => let '(_, x1, x2, x3, x4, x5) := x in nth i [x1; x2; x3; x4; x5] 0) [p; q; r; s; t])
    [0; 1; 2; 3; 4]%nat.
Proof.
  intros p q r s t.
  repeat match goal with x : coordinates_of 5 |- _ => destruct x as (((((? & ?) & ?) & ?) & ?) & ?) end. cbn. ring.
Qed.

Local Open Scope nat_scope.
Local Open Scope extensor_scope.
