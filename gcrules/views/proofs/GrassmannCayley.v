(* Theorems of Grassmann-Cayley algebra, replayed: coqc FILE.v prints of each "Closed under the global context", that is,
   proved without axioms. It was written for Coq 8.16 and uses nothing that later releases lack.

   R is any commutative ring. A point is a vector of coordinates (x, y, z, w), in the plane (x, y, w), w = 0 at infinity
   (`infinite`). An extensor is given by all its coordinates: those of a line ab are a_i b_j - a_j b_i. Of these
       A ∨ B   join: the exterior product, by coordinates (space_join, plane_join)
       A ∧ B   meet, by coordinates (space_meet, plane_meet); the splitting formula is proved of it (splits_value)
       A · B   join where one of both is a scalar: their product
       bracket A        the last coordinate of A, as a scalar: a determinant (bracket_of_space, bracket_of_plane)
       superbracket     the determinant of the 6 x 6 coordinates of six lines (space_super); in the plane three lines
                        have their meet instead (lines_of_plane)
   An equation of extensors says that all their coordinates are equal; scalars have one that is not zero.

   A proof is a list of exchange relations with multipliers. `replay` expands both sides into polynomials in brackets,
   subtracts the relations, closing extensors by further points, and asks whether nothing is left; `replay_sound` proves
   that then both sides are equal at all points. *)

From Coq Require Import Arith ZArith Ring Ring_theory InitialRing List Bool Lia.
Import ListNotations.

(* ---- formal polynomials in brackets: points are numbers, a row of numbers is a bracket or a join of points *)

Notation row := (list nat).
Notation term := (Z * list row * row)%type.

Fixpoint insert_point (x : nat) (l : row) : option (bool * row) :=
  match l with
  | [] => Some (false, [x])
  | y :: l' =>
    match Nat.compare x y with
    | Eq => None
    | Lt => Some (false, x :: l)
    | Gt => match insert_point x l' with Some (s, k) => Some (negb s, y :: k) | None => None end
    end
  end.

Fixpoint sort_points (l : row) : option (bool * row) :=
  match l with
  | [] => Some (false, [])
  | x :: l' =>
    match sort_points l' with
    | None => None
    | Some (s, k) => match insert_point x k with Some (t, k') => Some (xorb s t, k') | None => None end
    end
  end.

Definition signed (negative : bool) (c : Z) : Z := if negative then Z.opp c else c.

Definition sorted_bracket (d ideal : nat) (l : row) : option (bool * row) :=
  if Nat.eqb (length l) d then
    match sort_points l with
    | Some (s, k) => if forallb (fun i => Nat.ltb i ideal) k then None else Some (s, k)
    | None => None
    end
  else None.

Fixpoint compare_rows (a b : row) : comparison :=
  match a, b with
  | [], [] => Eq
  | [], _ => Lt
  | _, [] => Gt
  | x :: a', y :: b' => match Nat.compare x y with Eq => compare_rows a' b' | c => c end
  end.

Fixpoint compare_monomials (a b : list row) : comparison :=
  match a, b with
  | [], [] => Eq
  | [], _ => Lt
  | _, [] => Gt
  | x :: a', y :: b' => match compare_rows x y with Eq => compare_monomials a' b' | c => c end
  end.

Fixpoint insert_row (r : row) (m : list row) : list row :=
  match m with
  | [] => [r]
  | s :: m' => match compare_rows r s with Gt => s :: insert_row r m' | _ => r :: m end
  end.

Fixpoint product (m : list row) : list row -> list row :=
  match m with
  | [] => fun k => k
  | r :: m' =>
    fix product_m (k : list row) : list row :=
      match k with
      | [] => m
      | s :: k' => match compare_rows r s with Gt => s :: product_m k' | _ => r :: product m' k end
      end
  end.

Fixpoint merge (a : list term) : list term -> list term :=
  match a with
  | [] => fun b => b
  | (c, m, r) :: a' =>
    fix merge_a (b : list term) : list term :=
      match b with
      | [] => a
      | (c', m', r') :: b' =>
        match compare_rows r r' with
        | Lt => (c, m, r) :: merge a' b
        | Gt => (c', m', r') :: merge_a b'
        | Eq =>
          match compare_monomials m m' with
          | Lt => (c, m, r) :: merge a' b
          | Gt => (c', m', r') :: merge_a b'
          | Eq => let s := Z.add c c' in if Z.eqb s 0 then merge a' b' else (s, m, r) :: merge a' b'
          end
        end
      end
  end.

Fixpoint push (a : list term) (stack : list (option (list term))) : list (option (list term)) :=
  match stack with
  | [] => [Some a]
  | None :: stack' => Some a :: stack'
  | Some b :: stack' => None :: push (merge b a) stack'
  end.

Definition collected (a : list term) : list term :=
  fold_right (fun x b => match x with Some y => merge y b | None => b end) []
    (fold_right (fun t stack => push [t] stack) [] a).

Definition negated (a : list term) : list term := map (fun '(c, m, r) => (Z.opp c, m, r)) a.

Fixpoint splits_of_reverse (l : row) : list (bool * row * row) :=
  match l with
  | [] => [(false, [], [])]
  | x :: l' =>
    flat_map (fun '(s, P, Q) => [(s, P, Q ++ [x]); (xorb s (Nat.odd (length Q)), P ++ [x], Q)]) (splits_of_reverse l')
  end.

(* all ways to divide a row into n points P and the others Q, with the sign of the rearrangement *)
Definition splits (n : nat) (l : row) : list (bool * row * row) :=
  filter (fun '(_, P, _) => Nat.eqb (length P) n) (splits_of_reverse (rev l)).

(* the superbracket of the lines ab, cd, ef, gh, ij, kl (McMillan and White): negative or not, three brackets *)
Definition superbracket_terms {T : Type} (a b c d e f g h i j k l : T) : list (bool * list T * list T * list T) :=
  [ (true, [a; b; c; d], [e; f; g; i], [h; j; k; l]);
    (false, [a; b; c; d], [e; f; h; i], [g; j; k; l]);
    (false, [a; b; c; d], [e; f; g; j], [h; i; k; l]);
    (true, [a; b; c; d], [e; f; h; j], [g; i; k; l]);
    (false, [a; b; c; e], [d; f; g; h], [i; j; k; l]);
    (true, [a; b; d; e], [c; f; g; h], [i; j; k; l]);
    (true, [a; b; c; f], [d; e; g; h], [i; j; k; l]);
    (false, [a; b; d; f], [c; e; g; h], [i; j; k; l]);
    (true, [a; b; c; e], [d; g; h; i], [f; j; k; l]);
    (false, [a; b; d; e], [c; g; h; i], [f; j; k; l]);
    (false, [a; b; c; f], [d; g; h; i], [e; j; k; l]);
    (false, [a; b; c; e], [d; g; h; j], [f; i; k; l]);
    (true, [a; b; d; f], [c; g; h; i], [e; j; k; l]);
    (true, [a; b; d; e], [c; g; h; j], [f; i; k; l]);
    (true, [a; b; c; f], [d; g; h; j], [e; i; k; l]);
    (false, [a; b; d; f], [c; g; h; j], [e; i; k; l]);
    (false, [a; b; c; g], [d; e; f; i], [h; j; k; l]);
    (true, [a; b; d; g], [c; e; f; i], [h; j; k; l]);
    (true, [a; b; c; h], [d; e; f; i], [g; j; k; l]);
    (true, [a; b; c; g], [d; e; f; j], [h; i; k; l]);
    (false, [a; b; d; h], [c; e; f; i], [g; j; k; l]);
    (false, [a; b; d; g], [c; e; f; j], [h; i; k; l]);
    (false, [a; b; c; h], [d; e; f; j], [g; i; k; l]);
    (true, [a; b; d; h], [c; e; f; j], [g; i; k; l]) ].

Inductive expression :=
  | Point (i : nat)
  | Number (c : Z)
  | Sum (x y : expression)
  | Join (x y : expression)
  | Meet (x y : expression)
  | Bracket (x : expression)
  | Superbracket (u v w x y z : expression)
  | Power (x : expression) (n : nat).

Definition times (f : term -> term -> list term) (A B : list term) : list term :=
  collected (flat_map (fun a => flat_map (f a) B) A).

Definition joined (a b : term) : list term :=
  let '(c, m, r) := a in
  let '(c', m', r') := b in
  match sort_points (r ++ r') with
  | Some (s, k) => [(signed s (Z.mul c c'), product m m', k)]
  | None => []
  end.

Definition met (d ideal : nat) (a b : term) : list term :=
  let '(c, m, r) := a in
  let '(c', m', r') := b in
  flat_map (fun '(s, P, Q) =>
    match sorted_bracket d ideal (P ++ r') with
    | Some (t, k) => [(signed (xorb s t) (Z.mul c c'), insert_row k (product m m'), Q)]
    | None => []
    end) (splits (d - length r') r).

Definition bracketed (d ideal : nat) (a : term) : list term :=
  let '(c, m, r) := a in
  match sorted_bracket d ideal r with
  | Some (s, k) => [(signed s c, insert_row k m, [])]
  | None => []
  end.

Definition three_brackets (d ideal : nat) (c : Z) (m : list row) (t : bool * row * row * row) : list term :=
  let '(s, x, y, z) := t in
  match sorted_bracket d ideal x, sorted_bracket d ideal y, sorted_bracket d ideal z with
  | Some (s1, k1), Some (s2, k2), Some (s3, k3) =>
    [(signed (xorb s (xorb s1 (xorb s2 s3))) c, insert_row k1 (insert_row k2 (insert_row k3 m)), [])]
  | _, _, _ => []
  end.

Definition is_line (t : term) : bool := Nat.eqb (length (snd t)) 2.

Definition ends (r : row) : nat * nat := (nth 0 r 0%nat, nth 1 r 0%nat).

Definition superbracketed (d ideal : nat) (t1 t2 t3 t4 t5 t6 : term) : list term :=
  let '(c1, m1, r1) := t1 in let '(c2, m2, r2) := t2 in let '(c3, m3, r3) := t3 in
  let '(c4, m4, r4) := t4 in let '(c5, m5, r5) := t5 in let '(c6, m6, r6) := t6 in
  let '(a, b) := ends r1 in let '(c, d') := ends r2 in let '(e, f) := ends r3 in
  let '(g, h) := ends r4 in let '(i, j) := ends r5 in let '(k, l) := ends r6 in
  flat_map (three_brackets d ideal (c1 * (c2 * (c3 * (c4 * (c5 * c6)))))%Z
      (product m1 (product m2 (product m3 (product m4 (product m5 m6))))))
    (superbracket_terms a b c d' e f g h i j k l).

Definition both {T} (f : list term -> list term -> T) (A B : option (list term)) : option T :=
  match A, B with Some a, Some b => Some (f a b) | _, _ => None end.

Fixpoint expand (d ideal : nat) (x : expression) : option (list term) :=
  match x with
  | Point i => Some [(1%Z, [], [i])]
  | Number c => Some (if Z.eqb c 0 then [] else [(c, [], [])])
  | Sum x y => both (fun A B => collected (A ++ B)) (expand d ideal x) (expand d ideal y)
  | Join x y => both (times joined) (expand d ideal x) (expand d ideal y)
  | Meet x y => both (times (met d ideal)) (expand d ideal x) (expand d ideal y)
  | Bracket x => option_map (fun A => collected (flat_map (bracketed d ideal) A)) (expand d ideal x)
  | Power x n =>
    option_map (fun A => Nat.iter n (times joined A) [(1%Z, [], [])]) (expand d ideal x)
  | Superbracket u v w x y z =>
    match expand d ideal u, expand d ideal v, expand d ideal w, expand d ideal x, expand d ideal y, expand d ideal z with
    | Some A, Some B, Some C, Some D, Some E, Some F =>
      if Nat.eqb d 4 && forallb (forallb is_line) [A; B; C; D; E; F] then
        Some (collected (flat_map (fun t1 => flat_map (fun t2 => flat_map (fun t3 => flat_map (fun t4 =>
          flat_map (fun t5 => flat_map (superbracketed d ideal t1 t2 t3 t4 t5) F) E) D) C) B) A))
      else None
    | _, _, _, _, _, _ => None
    end
  end.

Fixpoint points_below (n : nat) (x : expression) : bool :=
  match x with
  | Point i => Nat.ltb i n
  | Number _ => true
  | Sum x y | Join x y | Meet x y => points_below n x && points_below n y
  | Bracket x | Power x _ => points_below n x
  | Superbracket u v w x y z => forallb (fun b => b) [points_below n u; points_below n v; points_below n w; points_below n x; points_below n y; points_below n z]
  end.

(* ---- exchange relations *)

Notation relation := (row * row * nat * list (Z * list row))%type.

Definition two_brackets (d ideal : nat) (c : Z) (u v : row) : list (Z * row * row) :=
  match sorted_bracket d ideal u, sorted_bracket d ideal v with
  | Some (s, u'), Some (t, v') => [(signed (xorb s t) c, u', v')]
  | _, _ => []
  end.

Definition exchange (d ideal : nat) (u v : row) (k : nat) : list (Z * row * row) :=
  two_brackets d ideal 1 u v ++
  flat_map (fun '(s, P, Q) => two_brackets d ideal (signed s (-1)) (P ++ firstn k u) (Q ++ skipn k u)) (splits (d - k) v).

Definition multiplied (d ideal : nat) (x : relation) : list term :=
  let '(u, v, k, multiplier) := x in
  if Nat.eqb (length u) d && Nat.eqb (length v) d && Nat.leb k d then
    let found := exchange d ideal u v k in
    flat_map (fun '(c, m) => map (fun '(z, a, b) => (Z.opp (Z.mul c z), insert_row a (insert_row b m), [])) found) multiplier
  else [].

Definition closed (d ideal n : nat) (A : list term) : option (list term) :=
  match A with
  | [] => Some []
  | (_, _, r) :: _ =>
    let k := length r in
    if forallb (fun t => Nat.eqb (length (snd t)) k) A && Nat.leb k d then
      Some (if Nat.eqb k 0 then A
            else flat_map (fun '(c, m, r) => bracketed d ideal (c, m, r ++ seq n (d - k))) A)
    else None
  end.

Definition replay (d ideal n : nat) (x y : expression) (relations : list relation) : bool :=
  Nat.leb ideal n && points_below n x && points_below n y &&
  match both (fun A B => collected (A ++ negated B)) (expand d ideal x) (expand d ideal y) with
  | Some A =>
    match closed d ideal n A with
    | Some B => match collected (B ++ flat_map (multiplied d ideal) relations) with [] => true | _ => false end
    | None => false
    end
  | None => false
  end.

(* lengths, under names that no release changes *)
Lemma length_app_ : forall (T : Type) (a b : list T), length (a ++ b) = (length a + length b)%nat.
Proof. induction a; intros; [reflexivity|]. cbn. f_equal. apply IHa. Qed.

Lemma length_map_ : forall (S T : Type) (f : S -> T) a, length (map f a) = length a.
Proof. induction a; [reflexivity|]. cbn. f_equal. apply IHa. Qed.

Lemma length_seq_ : forall n k, length (seq k n) = n.
Proof. induction n; intros; [reflexivity|]. cbn. f_equal. apply IHn. Qed.

Lemma length_firstn_ : forall (T : Type) n (a : list T), length (firstn n a) = Nat.min n (length a).
Proof. induction n; destruct a; try reflexivity. cbn. f_equal. apply IHn. Qed.

Section Commutative_ring.

Variable R : Type.
Variables (rO rI : R) (radd rmul rsub : R -> R -> R) (ropp : R -> R).
Hypothesis R_ring : ring_theory rO rI radd rmul rsub ropp eq.
Add Ring R_ring : R_ring.

Declare Scope ring_scope.
Delimit Scope ring_scope with ring.
Local Open Scope ring_scope.
Notation "0" := rO : ring_scope.
Notation "1" := rI : ring_scope.
Infix "+" := radd : ring_scope.
Infix "-" := rsub : ring_scope.
Infix "*" := rmul : ring_scope.
Notation "- x" := (ropp x) : ring_scope.

(* ---- whole numbers in the ring *)

Definition whole : Z -> R := gen_phiZ rO rI radd rmul ropp.

Lemma whole_morphism :
  ring_morph rO rI radd rmul rsub ropp eq 0%Z 1%Z Z.add Z.mul Z.sub Z.opp Zeq_bool whole.
Proof. exact (gen_phiZ_morph (Eqsth R) (Eq_ext radd rmul ropp) R_ring). Qed.

Lemma whole_0 : whole 0 = 0. Proof. reflexivity. Qed.
Lemma whole_1 : whole 1 = 1. Proof. reflexivity. Qed.
Lemma whole_add : forall a b, whole (a + b) = whole a + whole b.
Proof. exact (morph_add whole_morphism). Qed.
Lemma whole_mul : forall a b, whole (a * b) = whole a * whole b.
Proof. exact (morph_mul whole_morphism). Qed.
Lemma whole_opp : forall a, whole (- a) = - whole a.
Proof. exact (morph_opp whole_morphism). Qed.

Definition sign (negative : bool) : R := if negative then - (1) else 1.

Lemma sign_xorb : forall s t, sign (xorb s t) = sign s * sign t.
Proof. destruct s, t; cbn; ring. Qed.

Lemma whole_signed : forall s c, whole (signed s c) = sign s * whole c.
Proof. destruct s; intros; cbn [signed sign]; rewrite ?whole_opp; ring. Qed.

Definition linear_form {E : Type} (plus : E -> E -> E) (scale : R -> E -> E) (f : E -> R) : Prop :=
  (forall A B, f (plus A B) = f A + f B) /\ (forall x A, f (scale x A) = x * f A).

(* ---- what a proof uses of the algebra of joins and meets *)

Record geometry := Geometry {
  rank : nat;
  vector : Type;
  extensor : Type;
  zero : extensor;
  one : extensor;
  plus : extensor -> extensor -> extensor;
  scale : R -> extensor -> extensor;
  join : extensor -> extensor -> extensor;
  meet : extensor -> extensor -> extensor;
  top : extensor -> R;
  point : vector -> extensor;
  super : extensor -> extensor -> extensor -> extensor -> extensor -> extensor -> R;
  infinite : vector -> Prop;
  flat : extensor -> Prop;
  pure : nat -> extensor -> Prop;
  involution : extensor -> extensor;
  plus_comm : forall A B, plus A B = plus B A;
  plus_assoc : forall A B C, plus A (plus B C) = plus (plus A B) C;
  plus_zero : forall A, plus zero A = A;
  scale_plus : forall x A B, scale x (plus A B) = plus (scale x A) (scale x B);
  scale_add : forall x y A, scale (x + y) A = plus (scale x A) (scale y A);
  scale_mul : forall x y A, scale (x * y) A = scale x (scale y A);
  scale_1 : forall A, scale 1 A = A;
  scale_0 : forall A, scale 0 A = zero;
  join_plus_l : forall A B C, join (plus A B) C = plus (join A C) (join B C);
  join_plus_r : forall A B C, join A (plus B C) = plus (join A B) (join A C);
  join_scale_l : forall x A B, join (scale x A) B = scale x (join A B);
  join_scale_r : forall x A B, join A (scale x B) = scale x (join A B);
  join_assoc : forall A B C, join A (join B C) = join (join A B) C;
  join_one_l : forall A, join one A = A;
  join_one_r : forall A, join A one = A;
  join_same : forall p, join (point p) (point p) = zero;
  join_swap : forall p q, join (point p) (point q) = scale (- (1)) (join (point q) (point p));
  meet_plus_l : forall A B C, meet (plus A B) C = plus (meet A C) (meet B C);
  meet_plus_r : forall A B C, meet A (plus B C) = plus (meet A B) (meet A C);
  meet_scale_l : forall x A B, meet (scale x A) B = scale x (meet A B);
  meet_scale_r : forall x A B, meet A (scale x B) = scale x (meet A B);
  meet_one : forall B, meet one B = scale (top B) one;
  meet_join : forall A p B, meet (join A (point p)) B =
    plus (join (meet A B) (point p)) (involution (meet A (join (point p) B)));
  involution_plus : forall A B, involution (plus A B) = plus (involution A) (involution B);
  involution_scale : forall x A, involution (scale x A) = scale x (involution A);
  involution_one : involution one = one;
  involution_join : forall p A,
    involution (join (point p) A) = scale (- (1)) (join (point p) (involution A));
  top_plus : forall A B, top (plus A B) = top A + top B;
  top_scale : forall x A, top (scale x A) = x * top A;
  pure_one : pure 0 one;
  pure_join : forall k p A, pure k A -> pure (S k) (join (point p) A);
  pure_plus : forall k A B, pure k A -> pure k B -> pure k (plus A B);
  pure_scale : forall k x A, pure k A -> pure k (scale x A);
  pure_top : forall k A, pure k A -> k <> rank -> top A = 0;
  pure_full : forall A B, pure rank A -> meet A B = scale (top A) B;
  join_reverse : forall A p, join A (point p) = join (point p) (involution A);
  pure_involution : forall k A, pure k A -> pure k (involution A);
  pure_last : forall A, pure rank A -> top A = 0 -> A = zero;
  zero_test : forall A, (forall p, join A (point p) = zero) -> top A = 0 -> A = zero;
  scalar_zero : forall x, scale x one = zero -> x = 0;
  flat_one : flat one;
  flat_join : forall p A, infinite p -> flat A -> flat (join (point p) A);
  flat_top : forall A, flat A -> top A = 0;
  super_linear_1 : forall B C D E F, linear_form plus scale (fun A => super A B C D E F);
  super_linear_2 : forall A C D E F, linear_form plus scale (fun B => super A B C D E F);
  super_linear_3 : forall A B D E F, linear_form plus scale (fun C => super A B C D E F);
  super_linear_4 : forall A B C E F, linear_form plus scale (fun D => super A B C D E F);
  super_linear_5 : forall A B C D F, linear_form plus scale (fun E => super A B C D E F);
  super_linear_6 : forall A B C D E, linear_form plus scale (fun F => super A B C D E F);
  super_points : rank = 4%nat -> forall a b c d e f g h i j k l,
    let line p q := join (point p) (join (point q) one) in
    super (line a b) (line c d) (line e f) (line g h) (line i j) (line k l) =
    fold_right (fun t s =>
      (let '(negative, x, y, z) := t in
       let bracket v := top (fold_right (fun p B => join (point p) B) one v) in
       sign negative * (bracket x * (bracket y * bracket z))) + s) 0
      (superbracket_terms a b c d e f g h i j k l)
}.

(* ---- expressions and what they say *)

Definition number (G : geometry) (c : Z) : extensor G := scale G (whole c) (one G).
Definition bracket (G : geometry) (A : extensor G) : extensor G := scale G (top G A) (one G).
Definition superbracket (G : geometry) (A B C D E F : extensor G) : extensor G := scale G (super G A B C D E F) (one G).
Definition power (G : geometry) (A : extensor G) (n : nat) : extensor G := Nat.iter n (join G A) (one G).

Fixpoint value (G : geometry) (at_ : nat -> vector G) (x : expression) : extensor G :=
  match x with
  | Point i => point G (at_ i)
  | Number c => number G c
  | Sum x y => plus G (value G at_ x) (value G at_ y)
  | Join x y => join G (value G at_ x) (value G at_ y)
  | Meet x y => meet G (value G at_ x) (value G at_ y)
  | Bracket x => bracket G (value G at_ x)
  | Superbracket u v w x y z =>
    superbracket G (value G at_ u) (value G at_ v) (value G at_ w) (value G at_ x) (value G at_ y) (value G at_ z)
  | Power x n => power G (value G at_ x) n
  end.

(* ---- replaying a proof is sound *)

Section Soundness.

Variable G : geometry.
Notation d := (rank G).
Local Notation ext := (extensor G).
Local Notation O0 := (zero G).
Local Notation I1 := (one G).
Local Notation pl := (plus G).
Local Notation sc := (scale G).
Local Notation jn := (join G).
Local Notation mt := (meet G).
Local Notation tp := (top G).
Local Notation pt := (point G).

Definition linear (f : ext -> ext) : Prop :=
  (forall A B, f (pl A B) = pl (f A) (f B)) /\ (forall x A, f (sc x A) = sc x (f A)).

Lemma linear_zero : forall f, linear f -> f O0 = O0.
Proof.
  intros f [_ H]. transitivity (f (sc 0 O0)); [rewrite scale_0; reflexivity|]. rewrite H. apply scale_0.
Qed.

Definition sum {T} (f : T -> ext) (l : list T) : ext := fold_right (fun t s => pl (f t) s) O0 l.

Lemma plus_zero_r : forall A, pl A O0 = A.
Proof. intros. rewrite plus_comm. apply plus_zero. Qed.

Lemma scale_zero : forall x, sc x O0 = O0.
Proof.
  intros. transitivity (sc x (sc 0 O0)); [rewrite scale_0; reflexivity|].
  rewrite <- scale_mul. replace (x * 0) with 0 by ring. apply scale_0.
Qed.

Lemma sum_app : forall T (f : T -> ext) a b, sum f (a ++ b) = pl (sum f a) (sum f b).
Proof.
  induction a as [|x a IH]; intros; [symmetry; apply plus_zero|].
  change (pl (f x) (sum f (a ++ b)) = pl (pl (f x) (sum f a)) (sum f b)). rewrite IH. apply plus_assoc.
Qed.

Lemma sum_flat_map : forall S T (f : T -> ext) (g : S -> list T) l, sum f (flat_map g l) = sum (fun t => sum f (g t)) l.
Proof. induction l as [|x l IH]; [reflexivity|]. cbn [flat_map]. rewrite sum_app, IH. reflexivity. Qed.

Lemma sum_map : forall S T (f : T -> ext) (g : S -> T) l, sum f (map g l) = sum (fun t => f (g t)) l.
Proof. induction l as [|x l IH]; [reflexivity|]. cbn [map sum fold_right]. f_equal. exact IH. Qed.

Lemma sum_ext : forall T (f g : T -> ext) l, (forall t, In t l -> f t = g t) -> sum f l = sum g l.
Proof.
  induction l as [|x l IH]; intros H; [reflexivity|]. cbn [sum fold_right].
  rewrite (H x (or_introl eq_refl)). f_equal. apply IH. intros t Ht. apply H. right. exact Ht.
Qed.

Lemma plus_swap : forall A B C D, pl (pl A B) (pl C D) = pl (pl A C) (pl B D).
Proof. intros. rewrite <- !plus_assoc. f_equal. rewrite !plus_assoc. f_equal. apply plus_comm. Qed.

Lemma sum_plus : forall T (f g : T -> ext) l, sum (fun t => pl (f t) (g t)) l = pl (sum f l) (sum g l).
Proof.
  induction l as [|x l IH]; [symmetry; apply plus_zero|]. cbn [sum fold_right].
  fold (sum (fun t => pl (f t) (g t)) l). rewrite IH. apply plus_swap.
Qed.

Lemma linear_sum : forall T (f : T -> ext) l h, linear h -> h (sum f l) = sum (fun t => h (f t)) l.
Proof.
  induction l as [|x l IH]; intros h H; [apply linear_zero, H|]. cbn [sum fold_right].
  destruct H as [H H']. rewrite H. f_equal. apply IH. split; assumption.
Qed.

Lemma scale_linear : forall x, linear (sc x).
Proof.
  split; intros; [apply scale_plus|]. rewrite <- !scale_mul. f_equal. ring.
Qed.

Lemma scale_sum : forall T (f : T -> ext) l x, sc x (sum f l) = sum (fun t => sc x (f t)) l.
Proof. intros. apply (linear_sum _ f l (sc x)), scale_linear. Qed.

Lemma sum_zero : forall T (f : T -> ext) l, (forall t, In t l -> f t = O0) -> sum f l = O0.
Proof.
  induction l as [|x l IH]; intros H; [reflexivity|]. cbn [sum fold_right].
  rewrite (H x (or_introl eq_refl)), plus_zero. apply IH. intros t Ht. apply H. right. exact Ht.
Qed.

Lemma sum_filter : forall T (f : T -> ext) (p : T -> bool) l,
  (forall t, In t l -> p t = false -> f t = O0) -> sum f (filter p l) = sum f l.
Proof.
  induction l as [|x l IH]; intros H; [reflexivity|]. cbn [filter].
  assert (E : sum f (filter p l) = sum f l) by (apply IH; intros t Ht; apply H; right; exact Ht).
  destruct (p x) eqn:Hx; cbn [sum fold_right]; fold (sum f l).
  - fold (sum f (filter p l)). rewrite E. reflexivity.
  - rewrite (H x (or_introl eq_refl) Hx), plus_zero. exact E.
Qed.

Lemma join_linear_l : forall B, linear (fun A => jn A B).
Proof. split; intros; [apply join_plus_l | apply join_scale_l]. Qed.
Lemma join_linear_r : forall A, linear (jn A).
Proof. split; intros; [apply join_plus_r | apply join_scale_r]. Qed.
Lemma meet_linear_l : forall B, linear (fun A => mt A B).
Proof. split; intros; [apply meet_plus_l | apply meet_scale_l]. Qed.
Lemma meet_linear_r : forall A, linear (mt A).
Proof. split; intros; [apply meet_plus_r | apply meet_scale_r]. Qed.
Lemma involution_linear : linear (involution G).
Proof. split; intros; [apply involution_plus | apply involution_scale]. Qed.

Definition scalar (x : R) : ext := sc x I1.

Lemma linear_form_scalar : forall f, linear_form pl sc f -> linear (fun A => scalar (f A)).
Proof.
  intros f [H H']; split; intros; unfold scalar; rewrite ?H, ?H'; [apply scale_add | apply scale_mul].
Qed.

Lemma top_form : linear_form pl sc tp.
Proof. split; intros; [apply top_plus | apply top_scale]. Qed.

Lemma compose_linear : forall f g, linear f -> linear g -> linear (fun A => f (g A)).
Proof. intros f g [H1 H2] [H3 H4]. split; intros; [rewrite H3; apply H1 | rewrite H4; apply H2]. Qed.

Lemma top_zero : tp O0 = 0.
Proof. transitivity (tp (sc 0 O0)); [rewrite scale_0; reflexivity|]. rewrite top_scale. ring. Qed.

Lemma join_sum_l : forall T (f : T -> ext) l B, jn (sum f l) B = sum (fun t => jn (f t) B) l.
Proof. intros. exact (linear_sum _ f l _ (join_linear_l B)). Qed.
Lemma join_sum_r : forall T (f : T -> ext) l A, jn A (sum f l) = sum (fun t => jn A (f t)) l.
Proof. intros. exact (linear_sum _ f l _ (join_linear_r A)). Qed.
Lemma involution_sum : forall T (f : T -> ext) l, involution G (sum f l) = sum (fun t => involution G (f t)) l.
Proof. intros. exact (linear_sum _ f l _ involution_linear). Qed.
Lemma form_sum : forall T (f : T -> ext) l h,
  linear_form pl sc h -> scalar (h (sum f l)) = sum (fun t => scalar (h (f t))) l.
Proof. intros. exact (linear_sum _ f l _ (linear_form_scalar h H)). Qed.

(* ---- joins of points and brackets *)

Section Points.

Variable at_ : nat -> vector G.
Variable ideal : nat.
Hypothesis ideal_infinite : forall i, (i < ideal)%nat -> infinite G (at_ i).

Definition span (l : list (vector G)) : ext := fold_right (fun p B => jn (pt p) B) I1 l.
Definition W (l : row) : ext := span (map at_ l).
Definition bracket_value (l : row) : R := tp (W l).
Local Notation br := bracket_value.

Lemma W_cons : forall x l, W (x :: l) = jn (pt (at_ x)) (W l). Proof. reflexivity. Qed.

Lemma W_app : forall l k, W (l ++ k) = jn (W l) (W k).
Proof.
  induction l as [|x l IH]; intros; cbn [app]; [symmetry; apply join_one_l|].
  rewrite !W_cons, IH. apply join_assoc.
Qed.

Lemma W_swap : forall x y l, W (x :: y :: l) = sc (- (1)) (W (y :: x :: l)).
Proof. intros. rewrite !W_cons, !join_assoc, join_swap, join_scale_l. reflexivity. Qed.

Lemma W_same : forall x l, W (x :: x :: l) = O0.
Proof. intros. rewrite !W_cons, join_assoc, join_same. apply (linear_zero _ (join_linear_l _)). Qed.

Lemma W_cons_scale : forall x l k s, W l = sc s (W k) -> W (x :: l) = sc s (W (x :: k)).
Proof. intros x l k s H. rewrite !W_cons, H. apply join_scale_r. Qed.

Lemma W_pure : forall l, pure G (length l) (W l).
Proof. induction l as [|x l IH]; [apply pure_one | apply pure_join, IH]. Qed.

Lemma W_involution : forall l, involution G (W l) = sc (sign (Nat.odd (length l))) (W l).
Proof.
  induction l as [|x l IH]; [cbn; rewrite scale_1; apply involution_one|].
  rewrite W_cons, involution_join, IH, join_scale_r, <- scale_mul. f_equal.
  cbn [length]. rewrite Nat.odd_succ, <- Nat.negb_odd. destruct (Nat.odd (length l)); cbn; ring.
Qed.

Lemma insert_point_value : forall x l,
  match insert_point x l with
  | Some (s, k) => W (x :: l) = sc (sign s) (W k)
  | None => W (x :: l) = O0
  end.
Proof.
  intros x. induction l as [|y l IH]; cbn [insert_point].
  - cbn [sign]. rewrite scale_1. reflexivity.
  - destruct (Nat.compare x y) eqn:E.
    + apply Nat.compare_eq in E. subst y. apply W_same.
    + cbn [sign]. rewrite scale_1. reflexivity.
    + destruct (insert_point x l) as [[s k]|].
      * rewrite W_swap, (W_cons_scale y _ _ _ IH), <- scale_mul. f_equal. destruct s; cbn; ring.
      * rewrite W_swap, W_cons, IH, (linear_zero _ (join_linear_r _)). apply scale_zero.
Qed.

Lemma sort_points_value : forall l,
  match sort_points l with
  | Some (s, k) => W l = sc (sign s) (W k)
  | None => W l = O0
  end.
Proof.
  induction l as [|x l IH]; cbn [sort_points].
  - cbn [sign]. rewrite scale_1. reflexivity.
  - destruct (sort_points l) as [[s k]|].
    + pose proof (insert_point_value x k) as H. rewrite (W_cons_scale x _ _ _ IH).
      destruct (insert_point x k) as [[t k']|]; rewrite H.
      * rewrite <- scale_mul, sign_xorb. reflexivity.
      * apply scale_zero.
    + rewrite W_cons, IH. apply (linear_zero _ (join_linear_r _)).
Qed.

Lemma wrong_length : forall l, length l <> d -> br l = 0.
Proof. intros l H. exact (pure_top G _ _ (W_pure l) H). Qed.

Lemma all_ideal : forall l, forallb (fun i => Nat.ltb i ideal) l = true -> br l = 0.
Proof.
  intros l H. apply flat_top. revert H. induction l as [|x l IH]; intros H; [apply flat_one|].
  cbn [forallb] in H. apply andb_true_iff in H. destruct H as [H H'].
  apply flat_join; [|exact (IH H')]. apply ideal_infinite. apply Nat.ltb_lt. exact H.
Qed.

Lemma sorted_bracket_value : forall l,
  match sorted_bracket d ideal l with
  | Some (s, k) => br l = sign s * br k
  | None => br l = 0
  end.
Proof.
  intros l. unfold sorted_bracket. destruct (Nat.eqb (length l) d) eqn:E.
  - pose proof (sort_points_value l) as H. destruct (sort_points l) as [[s k]|].
    + assert (H' : br l = sign s * br k) by (unfold bracket_value; rewrite H; apply top_scale).
      destruct (forallb (fun i => Nat.ltb i ideal) k) eqn:F; [|exact H'].
      rewrite H', (all_ideal k F). ring.
    + unfold bracket_value. rewrite H. apply top_zero.
  - apply wrong_length. apply Nat.eqb_neq. exact E.
Qed.

(* ---- monomials and terms *)

Definition monomial_value (m : list row) : R := fold_right (fun r x => br r * x) 1 m.
Local Notation mv := monomial_value.

Definition term_value (t : term) : ext := let '(c, m, r) := t in sc (whole c * mv m) (W r).
Definition terms_value : list term -> ext := sum term_value.
Local Notation val := term_value.
Local Notation vals := terms_value.

Lemma insert_row_value : forall r m, mv (insert_row r m) = br r * mv m.
Proof.
  intros r. induction m as [|s m IH]; cbn [insert_row]; [reflexivity|].
  destruct (compare_rows r s); try reflexivity.
  change (br s * mv (insert_row r m) = br r * (br s * mv m)). rewrite IH. ring.
Qed.

Lemma product_value : forall m k, mv (product m k) = mv m * mv k.
Proof.
  induction m as [|r m IH]; intros k; [change (mv k = 1 * mv k); ring|].
  induction k as [|s k IHk]; [change (mv (r :: m) = mv (r :: m) * 1); ring|].
  cbn [product]. destruct (compare_rows r s).
  - change (br r * mv (product m (s :: k)) = br r * mv m * mv (s :: k)). rewrite IH. ring.
  - change (br r * mv (product m (s :: k)) = br r * mv m * mv (s :: k)). rewrite IH. ring.
  - change (br s * mv (product (r :: m) k) = br r * mv m * (br s * mv k)). rewrite IHk.
    change (mv (r :: m)) with (br r * mv m). ring.
Qed.

Lemma vals_app : forall a b, vals (a ++ b) = pl (vals a) (vals b).
Proof. intros. apply sum_app. Qed.

Lemma vals_cons : forall t a, vals (t :: a) = pl (val t) (vals a).
Proof. reflexivity. Qed.

Lemma compare_rows_eq : forall a b, compare_rows a b = Eq -> a = b.
Proof.
  induction a as [|x a IH]; destruct b as [|y b]; cbn [compare_rows]; intros H; try discriminate; [reflexivity|].
  destruct (Nat.compare x y) eqn:E; try discriminate. apply Nat.compare_eq in E. subst y. f_equal. apply IH, H.
Qed.

Lemma compare_monomials_eq : forall a b, compare_monomials a b = Eq -> a = b.
Proof.
  induction a as [|x a IH]; destruct b as [|y b]; cbn [compare_monomials]; intros H; try discriminate; [reflexivity|].
  destruct (compare_rows x y) eqn:E; try discriminate. apply compare_rows_eq in E. subst y. f_equal. apply IH, H.
Qed.

Lemma plus_left_comm : forall A B C, pl A (pl B C) = pl B (pl A C).
Proof. intros. rewrite !plus_assoc. f_equal. apply plus_comm. Qed.

Lemma merge_value : forall a b, vals (merge a b) = pl (vals a) (vals b).
Proof.
  induction a as [|[[c m] r] a IH]; [intros; symmetry; apply plus_zero|].
  induction b as [|[[c' m'] r'] b IHb]; [symmetry; apply plus_zero_r|].
  cbn [merge].
  destruct (compare_rows r r') eqn:E.
  - destruct (compare_monomials m m') eqn:F.
    + apply compare_rows_eq in E. apply compare_monomials_eq in F. subst r' m'. cbn zeta.
      assert (H : pl (vals ((c, m, r) :: a)) (vals ((c', m, r) :: b)) =
                  pl (sc (whole (c + c') * mv m) (W r)) (pl (vals a) (vals b))).
      { rewrite !vals_cons. cbn [term_value]. rewrite plus_swap. f_equal.
        rewrite <- scale_add, whole_add. f_equal. ring. }
      rewrite H. destruct (Z.eqb (c + c') 0) eqn:Z0.
      * apply Z.eqb_eq in Z0. rewrite Z0, whole_0, IH.
        replace (0 * mv m) with 0 by ring. rewrite scale_0, plus_zero. reflexivity.
      * rewrite vals_cons, IH. reflexivity.
    + rewrite vals_cons, IH, (vals_cons (c, m, r) a), <- plus_assoc. reflexivity.
    + rewrite (vals_cons (c', m', r')), (vals_cons (c', m', r')).
      change (pl (val (c', m', r')) (vals (merge ((c, m, r) :: a) b)) =
              pl (vals ((c, m, r) :: a)) (pl (val (c', m', r')) (vals b))).
      rewrite IHb. apply plus_left_comm.
  - rewrite vals_cons, IH, (vals_cons (c, m, r) a), <- plus_assoc. reflexivity.
  - rewrite (vals_cons (c', m', r')), (vals_cons (c', m', r')).
    change (pl (val (c', m', r')) (vals (merge ((c, m, r) :: a) b)) =
            pl (vals ((c, m, r) :: a)) (pl (val (c', m', r')) (vals b))).
    rewrite IHb. apply plus_left_comm.
Qed.

Definition stack_value : list (option (list term)) -> ext :=
  sum (fun x => match x with Some a => vals a | None => O0 end).

Lemma push_value : forall stack a, stack_value (push a stack) = pl (vals a) (stack_value stack).
Proof.
  induction stack as [|[b|] stack IH]; intros; cbn [push].
  - reflexivity.
  - change (pl O0 (stack_value (push (merge b a) stack)) = pl (vals a) (pl (vals b) (stack_value stack))).
    rewrite plus_zero, IH, merge_value, plus_assoc. f_equal. apply plus_comm.
  - change (pl (vals a) (stack_value stack) = pl (vals a) (pl O0 (stack_value stack))).
    rewrite plus_zero. reflexivity.
Qed.

Lemma collected_value : forall a, vals (collected a) = vals a.
Proof.
  intros a. unfold collected.
  set (stack := fold_right _ [] a).
  assert (H : stack_value stack = vals a).
  { subst stack. induction a as [|t a IH]; [reflexivity|]. cbn [fold_right].
    rewrite push_value, IH. change (pl (pl (val t) O0) (vals a) = pl (val t) (vals a)).
    rewrite plus_zero_r. reflexivity. }
  rewrite <- H. clear H. induction stack as [|[b|] stack IH]; [reflexivity| |]; cbn [fold_right].
  - rewrite merge_value, IH. reflexivity.
  - rewrite IH. symmetry. apply plus_zero.
Qed.

Lemma negated_value : forall a, vals (negated a) = sc (- (1)) (vals a).
Proof.
  intros a. unfold vals, negated. rewrite sum_map, scale_sum. apply sum_ext. intros [[c m] r] _.
  cbn [term_value]. rewrite <- scale_mul, whole_opp. f_equal. ring.
Qed.

(* ---- meets: the splitting formula *)

Lemma W_one : forall x, W [x] = pt (at_ x).
Proof. intros. apply join_one_r. Qed.

Lemma splits_of_reverse_value : forall r B,
  mt (W (rev r)) B = sum (fun t => let '(s, P, Q) := t in sc (sign s * tp (jn (W P) B)) (W Q)) (splits_of_reverse r).
Proof.
  induction r as [|x r IH]; intros B.
  - change (mt I1 B = pl (sc (1 * tp (jn I1 B)) I1) O0).
    rewrite plus_zero_r, meet_one, join_one_l. f_equal. ring.
  - cbn [rev splits_of_reverse].
    rewrite W_app, W_one, meet_join, !IH, join_sum_l, involution_sum, <- sum_plus, sum_flat_map.
    apply sum_ext. intros [[s P] Q] _. cbn [sum fold_right].
    rewrite plus_zero_r, join_scale_l, involution_scale, W_involution, <- scale_mul, !W_app, !W_one, <- join_assoc.
    f_equal. f_equal. rewrite sign_xorb. ring.
Qed.

Lemma splits_value : forall r l,
  mt (W r) (W l) = sum (fun t => let '(s, P, Q) := t in sc (sign s * br (P ++ l)) (W Q)) (splits (d - length l) r).
Proof.
  intros. unfold splits. rewrite sum_filter.
  - rewrite <- (rev_involutive r) at 1. rewrite splits_of_reverse_value. apply sum_ext. intros [[s P] Q] _.
    unfold bracket_value. rewrite W_app. reflexivity.
  - intros [[s P] Q] _ H. apply Nat.eqb_neq in H. rewrite wrong_length.
    + replace (sign s * 0) with 0 by ring. apply scale_0.
    + rewrite length_app_. lia.
Qed.

(* ---- products of sums *)

Lemma times_value : forall f (h : ext -> ext -> ext),
  (forall B, linear (fun A => h A B)) -> (forall A, linear (h A)) ->
  (forall a b, vals (f a b) = h (val a) (val b)) ->
  forall A B, vals (times f A B) = h (vals A) (vals B).
Proof.
  intros f h H1 H2 H A B. unfold times. rewrite collected_value. unfold terms_value at 1. rewrite sum_flat_map.
  transitivity (sum (fun a => h (val a) (vals B)) A).
  - apply sum_ext. intros a _. rewrite sum_flat_map. transitivity (sum (fun b => h (val a) (val b)) B).
    + apply sum_ext. intros b _. apply H.
    + symmetry. exact (linear_sum _ val B (h (val a)) (H2 (val a))).
  - symmetry. exact (linear_sum _ val A (fun X => h X (vals B)) (H1 (vals B))).
Qed.

Lemma one_term : forall t, vals [t] = val t.
Proof. intros. apply plus_zero_r. Qed.

Lemma joined_value : forall a b, vals (joined a b) = jn (val a) (val b).
Proof.
  intros [[c m] r] [[c' m'] r']. cbn [joined term_value].
  rewrite join_scale_l, join_scale_r, <- W_app.
  pose proof (sort_points_value (r ++ r')) as H. destruct (sort_points (r ++ r')) as [[s k]|]; rewrite H.
  - rewrite one_term. cbn [term_value]. rewrite <- !scale_mul, product_value, whole_signed, whole_mul. f_equal. ring.
  - rewrite !scale_zero. reflexivity.
Qed.

Lemma met_value : forall a b, vals (met d ideal a b) = mt (val a) (val b).
Proof.
  intros [[c m] r] [[c' m'] r']. cbn [met term_value].
  rewrite meet_scale_l, meet_scale_r, splits_value, !scale_sum. unfold terms_value. rewrite sum_flat_map.
  apply sum_ext. intros [[s P] Q] _.
  pose proof (sorted_bracket_value (P ++ r')) as H. destruct (sorted_bracket d ideal (P ++ r')) as [[t k]|]; rewrite H.
  - change (vals [(signed (xorb s t) (c * c')%Z, insert_row k (product m m'), Q)] =
      sc (whole c * mv m) (sc (whole c' * mv m') (sc (sign s * (sign t * br k)) (W Q)))).
    rewrite one_term. cbn [term_value].
    rewrite <- !scale_mul, insert_row_value, product_value, whole_signed, whole_mul, sign_xorb. f_equal. ring.
  - replace (sign s * 0) with 0 by ring. rewrite scale_0, !scale_zero. reflexivity.
Qed.

Lemma bracketed_value : forall a, vals (bracketed d ideal a) = scalar (tp (val a)).
Proof.
  intros [[c m] r]. cbn [bracketed term_value]. rewrite top_scale. fold (br r).
  pose proof (sorted_bracket_value r) as H. destruct (sorted_bracket d ideal r) as [[s k]|]; rewrite H.
  - rewrite one_term. cbn [term_value]. rewrite insert_row_value, whole_signed. unfold scalar.
    change (W []) with I1. f_equal. ring.
  - replace (whole c * mv m * 0) with 0 by ring. symmetry. apply scale_0.
Qed.

Lemma brackets_value : forall A, vals (flat_map (bracketed d ideal) A) = scalar (tp (vals A)).
Proof.
  intros. unfold terms_value. rewrite sum_flat_map, (form_sum _ val A tp top_form).
  apply sum_ext. intros t _. apply bracketed_value.
Qed.

(* ---- the superbracket *)

Lemma three_brackets_value : forall c m t,
  vals (three_brackets d ideal c m t) =
  scalar (whole c * mv m * (let '(s, x, y, z) := t in sign s * (br x * (br y * br z)))).
Proof.
  intros c m [[[s x] y] z]. cbn [three_brackets].
  pose proof (sorted_bracket_value x) as X. pose proof (sorted_bracket_value y) as Y.
  pose proof (sorted_bracket_value z) as Z.
  assert (zero_of : forall q, q = 0 -> vals [] = scalar q) by (intros q ->; symmetry; apply scale_0).
  destruct (sorted_bracket d ideal x) as [[s1 k1]|]; [|apply zero_of; rewrite X; ring].
  destruct (sorted_bracket d ideal y) as [[s2 k2]|]; [|apply zero_of; rewrite Y; ring].
  destruct (sorted_bracket d ideal z) as [[s3 k3]|]; [|apply zero_of; rewrite Z; ring].
  rewrite one_term, X, Y, Z. cbn [term_value]. rewrite !insert_row_value, whole_signed, !sign_xorb.
  change (W []) with I1. unfold scalar. f_equal. ring.
Qed.

Lemma scalar_fold : forall T (f : T -> R) x l,
  scalar (x * fold_right (fun t s => f t + s) 0 l) = sum (fun t => scalar (x * f t)) l.
Proof.
  intros. induction l as [|t l IH]; cbn [fold_right sum].
  - unfold scalar. replace (x * 0) with 0 by ring. apply scale_0.
  - fold (sum (fun t => scalar (x * f t)) l). rewrite <- IH. unfold scalar. rewrite <- scale_add. f_equal. ring.
Qed.

Lemma line_row : forall t, is_line t = true -> exists c m a b, t = (c, m, [a; b]).
Proof.
  intros [[c m] r] H. apply Nat.eqb_eq in H. cbn [snd] in H.
  destruct r as [|a [|b [|e r]]]; try discriminate. exists c, m, a, b. reflexivity.
Qed.

Lemma superbracketed_value : d = 4%nat -> forall t1 t2 t3 t4 t5 t6,
  forallb is_line [t1; t2; t3; t4; t5; t6] = true ->
  vals (superbracketed d ideal t1 t2 t3 t4 t5 t6) =
  scalar (super G (val t1) (val t2) (val t3) (val t4) (val t5) (val t6)).
Proof.
  intros D t1 t2 t3 t4 t5 t6 H. cbn [forallb] in H. rewrite !andb_true_iff in H.
  destruct H as (H1 & H2 & H3 & H4 & H5 & H6 & _).
  apply line_row in H1, H2, H3, H4, H5, H6.
  destruct H1 as (c1 & m1 & a & b & ->), H2 as (c2 & m2 & c & e & ->), H3 as (c3 & m3 & f & g & ->),
    H4 as (c4 & m4 & h & i & ->), H5 as (c5 & m5 & j & k & ->), H6 as (c6 & m6 & l & n & ->).
  cbn [term_value superbracketed ends nth].
  rewrite (proj2 (super_linear_1 G _ _ _ _ _)), (proj2 (super_linear_2 G _ _ _ _ _)),
    (proj2 (super_linear_3 G _ _ _ _ _)), (proj2 (super_linear_4 G _ _ _ _ _)),
    (proj2 (super_linear_5 G _ _ _ _ _)), (proj2 (super_linear_6 G _ _ _ _ _)).
  rewrite (super_points G D (at_ a) (at_ b) (at_ c) (at_ e) (at_ f) (at_ g) (at_ h) (at_ i) (at_ j) (at_ k) (at_ l) (at_ n)
    : super G (W [a; b]) (W [c; e]) (W [f; g]) (W [h; i]) (W [j; k]) (W [l; n]) = _).
  unfold terms_value. rewrite sum_flat_map.
  transitivity (sum (fun t => scalar (whole (c1 * (c2 * (c3 * (c4 * (c5 * c6))))) *
    mv (product m1 (product m2 (product m3 (product m4 (product m5 m6))))) *
    (let '(s, x, y, z) := t in sign s * (br x * (br y * br z))))) (superbracket_terms a b c e f g h i j k l n)).
  - apply sum_ext. intros t _. apply three_brackets_value.
  - rewrite <- scalar_fold. f_equal. rewrite !product_value, !whole_mul.
    change (superbracket_terms (at_ a) (at_ b) (at_ c) (at_ e) (at_ f) (at_ g) (at_ h) (at_ i) (at_ j) (at_ k) (at_ l) (at_ n))
      with (map (fun t => let '(s, x, y, z) := t in (s, map at_ x, map at_ y, map at_ z))
        (superbracket_terms a b c e f g h i j k l n)).
    generalize (superbracket_terms a b c e f g h i j k l n). intros terms.
    assert (E : forall q, fold_right (fun t s => (let '(negative, x, y, z) := t in
        sign negative * (tp (span x) * (tp (span y) * tp (span z)))) + s) 0
        (map (fun t => let '(s, x, y, z) := t in (s, map at_ x, map at_ y, map at_ z)) q) =
      fold_right (fun t s => (let '(s, x, y, z) := t in sign s * (br x * (br y * br z))) + s) 0 q).
    { induction q as [|[[[s x] y] z] q IH]; [reflexivity|]. cbn [map fold_right]. rewrite IH. reflexivity. }
    unfold span in E. rewrite E. ring.
Qed.

Lemma superbrackets_value : d = 4%nat -> forall A B C D E F,
  forallb (forallb is_line) [A; B; C; D; E; F] = true ->
  vals (flat_map (fun t1 => flat_map (fun t2 => flat_map (fun t3 => flat_map (fun t4 =>
          flat_map (fun t5 => flat_map (superbracketed d ideal t1 t2 t3 t4 t5) F) E) D) C) B) A) =
  scalar (super G (vals A) (vals B) (vals C) (vals D) (vals E) (vals F)).
Proof.
  intros D4 A B C D E F H. cbn [forallb] in H. rewrite !andb_true_iff in H.
  destruct H as (H1 & H2 & H3 & H4 & H5 & H6 & _). rewrite forallb_forall in H1, H2, H3, H4, H5, H6.
  unfold terms_value.
  rewrite sum_flat_map, (form_sum _ _ _ _ (super_linear_1 G _ _ _ _ _)). apply sum_ext. intros t1 T1.
  rewrite sum_flat_map, (form_sum _ _ _ _ (super_linear_2 G _ _ _ _ _)). apply sum_ext. intros t2 T2.
  rewrite sum_flat_map, (form_sum _ _ _ _ (super_linear_3 G _ _ _ _ _)). apply sum_ext. intros t3 T3.
  rewrite sum_flat_map, (form_sum _ _ _ _ (super_linear_4 G _ _ _ _ _)). apply sum_ext. intros t4 T4.
  rewrite sum_flat_map, (form_sum _ _ _ _ (super_linear_5 G _ _ _ _ _)). apply sum_ext. intros t5 T5.
  rewrite sum_flat_map, (form_sum _ _ _ _ (super_linear_6 G _ _ _ _ _)). apply sum_ext. intros t6 T6.
  apply superbracketed_value; [exact D4|]. cbn [forallb].
  rewrite (H1 _ T1), (H2 _ T2), (H3 _ T3), (H4 _ T4), (H5 _ T5), (H6 _ T6). reflexivity.
Qed.

(* ---- expressions *)

Lemma power_value : forall A n, vals (Nat.iter n (times joined A) [(1%Z, [], [])]) = Nat.iter n (jn (vals A)) I1.
Proof.
  intros. induction n as [|n IH].
  - change (pl (sc (1 * 1) I1) O0 = I1). rewrite plus_zero_r. replace (1 * 1) with 1 by ring. apply scale_1.
  - change (vals (times joined A (Nat.iter n (times joined A) [(1%Z, [], [])])) = jn (vals A) (Nat.iter n (jn (vals A)) I1)).
    rewrite (times_value joined jn join_linear_l join_linear_r joined_value), IH. reflexivity.
Qed.

Lemma expand_value : forall x A, expand d ideal x = Some A -> value G at_ x = vals A.
Proof.
  assert (two : forall T (f : list term -> list term -> T) a b C, both f a b = Some C ->
    exists A B, a = Some A /\ b = Some B /\ f A B = C).
  { intros T f [A|] [B|] C H; try discriminate. exists A, B. inversion H. repeat split; reflexivity. }
  induction x as [i|c|x IHx y IHy|x IHx y IHy|x IHx y IHy|x IHx|u IHu v IHv w IHw x IHx y IHy z IHz|x IHx n];
    intros A H; cbn [expand] in H; cbn [value].
  - inversion H. rewrite one_term. cbn [term_value]. rewrite W_one, whole_1. cbn [monomial_value fold_right].
    replace (1 * 1) with 1 by ring. symmetry. apply scale_1.
  - destruct (Z.eqb c 0) eqn:E; inversion H; unfold number.
    + apply Z.eqb_eq in E. subst c. rewrite whole_0. apply scale_0.
    + rewrite one_term. cbn [term_value monomial_value fold_right]. change (W []) with I1. f_equal. ring.
  - apply two in H. destruct H as (B & C & HB & HC & <-). rewrite (IHx _ HB), (IHy _ HC), collected_value.
    symmetry. apply vals_app.
  - apply two in H. destruct H as (B & C & HB & HC & <-). rewrite (IHx _ HB), (IHy _ HC).
    symmetry. exact (times_value joined jn join_linear_l join_linear_r joined_value B C).
  - apply two in H. destruct H as (B & C & HB & HC & <-). rewrite (IHx _ HB), (IHy _ HC).
    symmetry. exact (times_value (met d ideal) mt meet_linear_l meet_linear_r met_value B C).
  - destruct (expand d ideal x) as [B|]; [|discriminate]. inversion H. rewrite collected_value, brackets_value, (IHx B eq_refl).
    reflexivity.
  - destruct (expand d ideal u) as [A1|]; [|discriminate]. destruct (expand d ideal v) as [A2|]; [|discriminate].
    destruct (expand d ideal w) as [A3|]; [|discriminate]. destruct (expand d ideal x) as [A4|]; [|discriminate].
    destruct (expand d ideal y) as [A5|]; [|discriminate]. destruct (expand d ideal z) as [A6|]; [|discriminate].
    destruct (Nat.eqb d 4 && forallb (forallb is_line) [A1; A2; A3; A4; A5; A6]) eqn:E; [|discriminate].
    apply andb_true_iff in E. destruct E as [E1 E2]. apply Nat.eqb_eq in E1. inversion H.
    rewrite collected_value, (superbrackets_value E1 _ _ _ _ _ _ E2).
    rewrite (IHu _ eq_refl), (IHv _ eq_refl), (IHw _ eq_refl), (IHx _ eq_refl), (IHy _ eq_refl), (IHz _ eq_refl).
    reflexivity.
  - destruct (expand d ideal x) as [B|]; [|discriminate]. inversion H. rewrite power_value, (IHx B eq_refl). reflexivity.
Qed.

(* ---- relations *)

Definition pair_value (t : Z * row * row) : ext := let '(z, u, v) := t in scalar (whole z * (br u * br v)).

Lemma two_brackets_value : forall c u v,
  sum pair_value (two_brackets d ideal c u v) = scalar (whole c * (br u * br v)).
Proof.
  intros. unfold two_brackets. pose proof (sorted_bracket_value u) as U. pose proof (sorted_bracket_value v) as V.
  assert (zero_of : forall q, q = 0 -> sum pair_value [] = scalar q) by (intros q ->; symmetry; apply scale_0).
  destruct (sorted_bracket d ideal u) as [[s u']|]; [|apply zero_of; rewrite U; ring].
  destruct (sorted_bracket d ideal v) as [[t v']|]; [|apply zero_of; rewrite V; ring].
  rewrite U, V. cbn [sum fold_right pair_value]. rewrite plus_zero_r, whole_signed, sign_xorb. f_equal. ring.
Qed.

(* the exchange relation: the meet of v, all of space, and the first points of u is [v] times these; split v *)
Lemma exchange_value : forall u v k, length u = d -> length v = d -> (k <= d)%nat ->
  sum pair_value (exchange d ideal u v k) = O0.
Proof.
  intros u v k Hu Hv Hk. unfold exchange. rewrite sum_app, two_brackets_value, whole_1, sum_flat_map.
  assert (K : length (firstn k u) = k) by (rewrite length_firstn_; lia).
  pose proof (pure_full G (W v) (W (firstn k u))) as E. rewrite <- Hv in E at 1. specialize (E (W_pure v)).
  rewrite splits_value, K in E.
  apply (f_equal (fun A => scalar (- (1) * tp (jn A (W (skipn k u)))))) in E.
  rewrite join_scale_l, <- W_app, firstn_skipn, top_scale in E. fold (br v) (br u) in E.
  assert (L : linear_form pl sc (fun A => - (1) * tp (jn A (W (skipn k u))))).
  { split; intros; [rewrite join_plus_l, top_plus | rewrite join_scale_l, top_scale]; ring. }
  rewrite (form_sum _ _ _ _ L) in E.
  transitivity (pl (scalar (1 * (br u * br v))) (scalar (- (1) * (br v * br u)))).
  - f_equal. rewrite <- E. apply sum_ext. intros [[s P] Q] _.
    rewrite two_brackets_value, whole_signed, join_scale_l, top_scale, <- W_app. f_equal.
    change (whole (-1)) with (- (1)). unfold bracket_value. ring.
  - unfold scalar. rewrite <- scale_add. replace (_ + _) with 0 by ring. apply scale_0.
Qed.

Lemma multiplied_value : forall x, vals (multiplied d ideal x) = O0.
Proof.
  intros [[[u v] k] multiplier]. cbn [multiplied].
  destruct (Nat.eqb (length u) d && Nat.eqb (length v) d && Nat.leb k d) eqn:E; [|reflexivity].
  rewrite !andb_true_iff in E. destruct E as [[E1 E2] E3]. apply Nat.eqb_eq in E1, E2. apply Nat.leb_le in E3.
  cbv zeta. unfold terms_value. rewrite sum_flat_map. apply sum_zero. intros [c m] _. rewrite sum_map.
  transitivity (sc (- (whole c * mv m)) (sum pair_value (exchange d ideal u v k))).
  - rewrite scale_sum. apply sum_ext. intros [[z a] b] _. cbn [term_value pair_value].
    rewrite !insert_row_value, whole_opp, whole_mul. change (W []) with I1. unfold scalar. rewrite <- scale_mul.
    f_equal. ring.
  - rewrite exchange_value by assumption. apply scale_zero.
Qed.

Lemma relations_value : forall l, vals (flat_map (multiplied d ideal) l) = O0.
Proof. intros. unfold terms_value. rewrite sum_flat_map. apply sum_zero. intros x _. apply multiplied_value. Qed.

Lemma pure_terms : forall k A, forallb (fun t : term => Nat.eqb (length (snd t)) k) A = true -> pure G k (vals A).
Proof.
  intros k. induction A as [|[[c m] r] A IH]; intros H.
  - change (pure G k O0). rewrite <- (scale_0 G (W (repeat 0%nat k))). apply pure_scale.
    rewrite <- (repeat_length 0%nat k) at 1. apply W_pure.
  - cbn [forallb snd] in H. apply andb_true_iff in H. destruct H as [H H']. apply Nat.eqb_eq in H.
    apply pure_plus; [|exact (IH H')]. apply pure_scale. rewrite <- H. apply W_pure.
Qed.

Lemma closing_value : forall A l,
  vals (flat_map (fun t => let '(c, m, r) := t in bracketed d ideal (c, m, r ++ l)) A) = scalar (tp (jn (vals A) (W l))).
Proof.
  intros. unfold terms_value. rewrite sum_flat_map, join_sum_l, (form_sum _ _ _ _ top_form).
  apply sum_ext. intros [[c m] r] _. etransitivity; [apply bracketed_value|]. cbn [term_value].
  rewrite W_app, join_scale_l. reflexivity.
Qed.

End Points.

Lemma closing_zero : forall m k A, pure G k A -> (k + m = d)%nat ->
  (forall l, length l = m -> tp (jn A (span l)) = 0) -> A = O0.
Proof.
  induction m as [|m IH]; intros k A P K H.
  - apply pure_last; [replace d with k by lia; exact P|]. rewrite <- (H [] eq_refl). f_equal. symmetry. apply join_one_r.
  - apply zero_test; [|apply (pure_top G k); [exact P | lia]].
    intros p. apply (IH (S k)); [rewrite join_reverse; apply pure_join, pure_involution, P | lia|].
    intros l L. rewrite <- join_assoc. apply (H (p :: l)). cbn. f_equal. exact L.
Qed.

Lemma value_agrees : forall e e' n x, (forall i, (i < n)%nat -> e i = e' i) -> points_below n x = true ->
  value G e x = value G e' x.
Proof.
  intros e e' n x A. induction x; cbn [points_below value forallb]; intros H;
    rewrite ?andb_true_iff in H; repeat match goal with H : _ /\ _ |- _ => destruct H end;
    repeat match goal with IH : ?P -> value _ _ _ = _, H : ?P |- _ => rewrite (IH H); clear IH end; try reflexivity.
  f_equal. apply A. apply Nat.ltb_lt. exact H.
Qed.

Theorem replay_sound : forall at_ ideal n x y relations,
  (forall i, (i < ideal)%nat -> infinite G (at_ i)) ->
  replay d ideal n x y relations = true ->
  value G at_ x = value G at_ y.
Proof.
  intros at_ ideal n x y relations Hi H. unfold replay in H.
  rewrite !andb_true_iff in H. destruct H as [[[Hn Hx] Hy] H]. apply Nat.leb_le in Hn.
  destruct (expand d ideal x) as [A|] eqn:EA; [|discriminate].
  destruct (expand d ideal y) as [B|] eqn:EB; [|discriminate]. cbn [both] in H.
  set (D := collected (A ++ negated B)) in H.
  destruct (closed d ideal n D) as [C|] eqn:EC; [|discriminate].
  assert (difference : forall e, (forall i, (i < ideal)%nat -> infinite G (e i)) ->
    terms_value e D = pl (value G e x) (sc (- (1)) (value G e y))).
  { intros e He. unfold D. rewrite collected_value, vals_app, negated_value.
    rewrite (expand_value e ideal He x A EA), (expand_value e ideal He y B EB). reflexivity. }
  assert (nothing : forall e, (forall i, (i < ideal)%nat -> infinite G (e i)) -> terms_value e C = O0).
  { intros e He. destruct (collected (C ++ flat_map (multiplied d ideal) relations)) eqn:E; [|discriminate].
    apply (f_equal (terms_value e)) in E. rewrite collected_value, vals_app, (relations_value e ideal He), plus_zero_r in E.
    exact E. }
  assert (Z : terms_value at_ D = O0).
  { destruct D as [|[[c m] r] D'] eqn:ED; [reflexivity|]. rewrite <- ED in *. clear ED.
    unfold closed in EC. destruct D as [|[[c0 m0] r0] D0] eqn:ED; [reflexivity|]. rewrite <- ED in *. clear ED.
    cbv zeta in EC.
    destruct (forallb (fun t => Nat.eqb (length (snd t)) (length r0)) D && Nat.leb (length r0) d) eqn:EF; [|discriminate].
    apply andb_true_iff in EF. destruct EF as [EF EL]. apply Nat.leb_le in EL.
    destruct (Nat.eqb (length r0) 0) eqn:E0; injection EC as E; [rewrite E; apply nothing, Hi|].
    apply (closing_zero (d - length r0) (length r0)); [apply pure_terms, EF | lia |].
    intros l Hl.
    set (e := fun i => if Nat.ltb i n then at_ i else nth (i - n) l (at_ 0%nat)).
    assert (He : forall i, (i < n)%nat -> at_ i = e i).
    { intros i Li. unfold e. apply Nat.ltb_lt in Li. rewrite Li. reflexivity. }
    assert (Hie : forall i, (i < ideal)%nat -> infinite G (e i)).
    { intros i Li. rewrite <- He by lia. apply Hi, Li. }
    assert (N : scalar (tp (jn (terms_value e D) (W e (seq n (d - length r0))))) = O0).
    { transitivity (terms_value e C); [|apply nothing, Hie].
      rewrite <- E. symmetry. exact (closing_value e ideal Hie D _). }
    apply scalar_zero in N. rewrite (difference at_ Hi), (value_agrees at_ e n x He Hx), (value_agrees at_ e n y He Hy).
    rewrite <- (difference e Hie).
    replace (span l) with (W e (seq n (d - length r0))); [exact N|]. unfold W. f_equal.
    rewrite <- Hl. apply (nth_ext _ _ (at_ 0%nat) (at_ 0%nat)); [rewrite length_map_; apply length_seq_|].
    intros i Li. rewrite length_map_, length_seq_ in Li.
    rewrite (nth_indep _ _ (e 0%nat)) by (rewrite length_map_, length_seq_; exact Li).
    rewrite map_nth, seq_nth by exact Li. unfold e.
    replace (Nat.ltb (n + i) n) with false by (symmetry; apply Nat.ltb_ge; lia). f_equal. lia. }
  rewrite (difference at_ Hi) in Z.
  rewrite <- (plus_zero_r (value G at_ x)).
  replace O0 with (pl (sc (- (1)) (value G at_ y)) (value G at_ y)).
  - rewrite plus_assoc, Z. apply plus_zero.
  - rewrite <- (scale_1 G (value G at_ y)) at 2. rewrite <- scale_add. replace (- (1) + 1) with 0 by ring. apply scale_0.
Qed.

End Soundness.

(* ---- determinants *)

Fixpoint expansion (f : nat -> list nat -> R) (before after : list nat) : R :=
  match after with
  | [] => 0
  | c :: after' => f c (before ++ after') - expansion f (before ++ [c]) after'
  end.

(* the determinant of some rows at some columns, expanded along the first row *)
Fixpoint determinant (rows : list (nat -> R)) (columns : list nat) : R :=
  match rows with
  | [] => 1
  | r :: rows' => expansion (fun c others => r c * determinant rows' others) [] columns
  end.

Lemma expansion_plus : forall f g h, (forall c l, f c l = g c l + h c l) ->
  forall after before, expansion f before after = expansion g before after + expansion h before after.
Proof. intros f g h H. induction after; intros; cbn [expansion]; [ring|]. rewrite H, IHafter. ring. Qed.

Lemma expansion_scale : forall f g x, (forall c l, f c l = x * g c l) ->
  forall after before, expansion f before after = x * expansion g before after.
Proof. intros f g x H. induction after; intros; cbn [expansion]; [ring|]. rewrite H, IHafter. ring. Qed.

Lemma determinant_plus : forall r s t, (forall c, r c = s c + t c) -> forall before after columns,
  determinant (before ++ r :: after) columns =
  determinant (before ++ s :: after) columns + determinant (before ++ t :: after) columns.
Proof.
  intros r s t H. induction before; intros; cbn [app determinant]; apply expansion_plus; intros.
  - rewrite H. ring.
  - rewrite IHbefore. ring.
Qed.

Lemma determinant_scale : forall r s x, (forall c, r c = x * s c) -> forall before after columns,
  determinant (before ++ r :: after) columns = x * determinant (before ++ s :: after) columns.
Proof.
  intros r s x H. induction before; intros; cbn [app determinant]; apply expansion_scale; intros.
  - rewrite H. ring.
  - rewrite IHbefore. ring.
Qed.

(* ---- plane: extensors of the projective plane: a scalar, three coordinates of points, three of lines (12, 13, 23), one of the plane *)

Inductive vector3 := Vector3 (x y w : R).

Inductive extensor3 := Extensor3 (a a1 a2 a3 a12 a13 a23 a123 : R).

Definition plane_zero := Extensor3 0 0 0 0 0 0 0 0.

Definition plane_one := Extensor3 1 0 0 0 0 0 0 0.

Definition plane_plus '(Extensor3 a a1 a2 a3 a12 a13 a23 a123) '(Extensor3 b b1 b2 b3 b12 b13 b23 b123) : extensor3 :=
  Extensor3
    (a + b)
    (a1 + b1) (a2 + b2) (a3 + b3)
    (a12 + b12) (a13 + b13) (a23 + b23)
    (a123 + b123).

Definition plane_scale (x : R) '(Extensor3 a a1 a2 a3 a12 a13 a23 a123) : extensor3 :=
  Extensor3
    (x * a)
    (x * a1) (x * a2) (x * a3)
    (x * a12) (x * a13) (x * a23)
    (x * a123).

(* the exterior product *)
Definition plane_join '(Extensor3 a a1 a2 a3 a12 a13 a23 a123) '(Extensor3 b b1 b2 b3 b12 b13 b23 b123) : extensor3 :=
  Extensor3
    (a * b)
    (a * b1 + a1 * b)
    (a * b2 + a2 * b)
    (a * b3 + a3 * b)
    (a * b12 + a1 * b2 - a2 * b1 + a12 * b)
    (a * b13 + a1 * b3 - a3 * b1 + a13 * b)
    (a * b23 + a2 * b3 - a3 * b2 + a23 * b)
    (a * b123 + a1 * b23 - a2 * b13 + a3 * b12 + a12 * b3 - a13 * b2 + a23 * b1 + a123 * b).

(* e_J meets e_K in their common basis points, with the sign in which J = (P, J ∩ K) and (P, K) are rearranged,
   P being what K lacks: the splitting formula [P K] (J without P) at basis points *)
Definition plane_meet '(Extensor3 a a1 a2 a3 a12 a13 a23 a123) '(Extensor3 b b1 b2 b3 b12 b13 b23 b123) : extensor3 :=
  Extensor3
    (a * b123 + a1 * b23 - a2 * b13 + a3 * b12 + a12 * b3 - a13 * b2 + a23 * b1 + a123 * b)
    (a1 * b123 + a12 * b13 - a13 * b12 + a123 * b1)
    (a2 * b123 + a12 * b23 - a23 * b12 + a123 * b2)
    (a3 * b123 + a13 * b23 - a23 * b13 + a123 * b3)
    (a12 * b123 + a123 * b12)
    (a13 * b123 + a123 * b13)
    (a23 * b123 + a123 * b23)
    (a123 * b123).

Definition plane_top '(Extensor3 a a1 a2 a3 a12 a13 a23 a123) : R := a123.

Definition plane_point '(Vector3 x y w) : extensor3 :=
  Extensor3
    0
    x y w
    0 0 0
    0.

Definition plane_infinite '(Vector3 x y w) : Prop := w = 0.

Definition plane_flat '(Extensor3 a a1 a2 a3 a12 a13 a23 a123) : Prop :=
  a3 = 0 /\ a13 = 0 /\ a23 = 0 /\ a123 = 0.

Definition plane_pure (k : nat) '(Extensor3 a a1 a2 a3 a12 a13 a23 a123) : Prop :=
  (k <> 0%nat -> a = 0) /\
  (k <> 1%nat -> a1 = 0 /\ a2 = 0 /\ a3 = 0) /\
  (k <> 2%nat -> a12 = 0 /\ a13 = 0 /\ a23 = 0) /\
  (k <> 3%nat -> a123 = 0).

Definition plane_involution '(Extensor3 a a1 a2 a3 a12 a13 a23 a123) : extensor3 :=
  Extensor3
    a
    (- a1) (- a2) (- a3)
    a12 a13 a23
    (- a123).

Definition plane_super (A B C D E F : extensor3) : R := 0. (* in the plane three lines have their meet *)

Lemma plane_equal : forall a a1 a2 a3 a12 a13 a23 a123 b b1 b2 b3 b12 b13 b23 b123,
  a = b -> a1 = b1 -> a2 = b2 -> a3 = b3 -> a12 = b12 -> a13 = b13 -> a23 = b23 -> a123 = b123 ->
  Extensor3 a a1 a2 a3 a12 a13 a23 a123 = Extensor3 b b1 b2 b3 b12 b13 b23 b123.
Proof. intros; subst; reflexivity. Qed.

Ltac plane_ring :=
  intros;
  repeat match goal with A : extensor3 |- _ => destruct A | p : vector3 |- _ => destruct p end;
  unfold plane_zero, plane_one;
  cbn [plane_zero plane_one plane_plus plane_scale plane_join plane_meet plane_top plane_point plane_involution];
  try (apply plane_equal; ring); try ring.

Lemma plane_plus_comm : forall A B, plane_plus A B = plane_plus B A.
Proof. plane_ring. Qed.
Lemma plane_plus_assoc : forall A B C, plane_plus A (plane_plus B C) = plane_plus (plane_plus A B) C.
Proof. plane_ring. Qed.
Lemma plane_plus_zero : forall A, plane_plus plane_zero A = A.
Proof. plane_ring. Qed.
Lemma plane_scale_plus : forall x A B, plane_scale x (plane_plus A B) = plane_plus (plane_scale x A) (plane_scale x B).
Proof. plane_ring. Qed.
Lemma plane_scale_add : forall x y A, plane_scale (x + y) A = plane_plus (plane_scale x A) (plane_scale y A).
Proof. plane_ring. Qed.
Lemma plane_scale_mul : forall x y A, plane_scale (x * y) A = plane_scale x (plane_scale y A).
Proof. plane_ring. Qed.
Lemma plane_scale_1 : forall A, plane_scale 1 A = A.
Proof. plane_ring. Qed.
Lemma plane_scale_0 : forall A, plane_scale 0 A = plane_zero.
Proof. plane_ring. Qed.
Lemma plane_join_plus_l : forall A B C, plane_join (plane_plus A B) C = plane_plus (plane_join A C) (plane_join B C).
Proof. plane_ring. Qed.
Lemma plane_join_plus_r : forall A B C, plane_join A (plane_plus B C) = plane_plus (plane_join A B) (plane_join A C).
Proof. plane_ring. Qed.
Lemma plane_join_scale_l : forall x A B, plane_join (plane_scale x A) B = plane_scale x (plane_join A B).
Proof. plane_ring. Qed.
Lemma plane_join_scale_r : forall x A B, plane_join A (plane_scale x B) = plane_scale x (plane_join A B).
Proof. plane_ring. Qed.
Lemma plane_meet_plus_l : forall A B C, plane_meet (plane_plus A B) C = plane_plus (plane_meet A C) (plane_meet B C).
Proof. plane_ring. Qed.
Lemma plane_meet_plus_r : forall A B C, plane_meet A (plane_plus B C) = plane_plus (plane_meet A B) (plane_meet A C).
Proof. plane_ring. Qed.
Lemma plane_meet_scale_l : forall x A B, plane_meet (plane_scale x A) B = plane_scale x (plane_meet A B).
Proof. plane_ring. Qed.
Lemma plane_meet_scale_r : forall x A B, plane_meet A (plane_scale x B) = plane_scale x (plane_meet A B).
Proof. plane_ring. Qed.
Lemma plane_join_assoc : forall A B C, plane_join A (plane_join B C) = plane_join (plane_join A B) C.
Proof. plane_ring. Qed.
Lemma plane_join_one_l : forall A, plane_join plane_one A = A.
Proof. plane_ring. Qed.
Lemma plane_join_one_r : forall A, plane_join A plane_one = A.
Proof. plane_ring. Qed.
Lemma plane_join_same : forall p, plane_join (plane_point p) (plane_point p) = plane_zero.
Proof. plane_ring. Qed.
Lemma plane_join_swap : forall p q, plane_join (plane_point p) (plane_point q) = plane_scale (- (1)) (plane_join (plane_point q) (plane_point p)).
Proof. plane_ring. Qed.
Lemma plane_meet_one : forall B, plane_meet plane_one B = plane_scale (plane_top B) plane_one.
Proof. plane_ring. Qed.
Lemma plane_meet_join : forall A p B, plane_meet (plane_join A (plane_point p)) B =
  plane_plus (plane_join (plane_meet A B) (plane_point p)) (plane_involution (plane_meet A (plane_join (plane_point p) B))).
Proof. plane_ring. Qed.
Lemma plane_involution_plus : forall A B, plane_involution (plane_plus A B) = plane_plus (plane_involution A) (plane_involution B).
Proof. plane_ring. Qed.
Lemma plane_involution_scale : forall x A, plane_involution (plane_scale x A) = plane_scale x (plane_involution A).
Proof. plane_ring. Qed.
Lemma plane_involution_one : plane_involution plane_one = plane_one.
Proof. plane_ring. Qed.
Lemma plane_involution_join : forall p A, plane_involution (plane_join (plane_point p) A) =
  plane_scale (- (1)) (plane_join (plane_point p) (plane_involution A)).
Proof. plane_ring. Qed.
Lemma plane_top_plus : forall A B, plane_top (plane_plus A B) = plane_top A + plane_top B.
Proof. plane_ring. Qed.
Lemma plane_top_scale : forall x A, plane_top (plane_scale x A) = x * plane_top A.
Proof. plane_ring. Qed.

Lemma plane_pure_one : plane_pure 0 plane_one.
Proof. cbn. repeat split; intros; try reflexivity; contradiction. Qed.

Lemma plane_pure_join : forall k p A, plane_pure k A -> plane_pure (S k) (plane_join (plane_point p) A).
Proof.
  intros k [x y w] [a a1 a2 a3 a12 a13 a23 a123] H. cbn in H. decompose [and] H. clear H.
  cbn [plane_join plane_point plane_pure]. repeat apply conj; intros K;
    repeat match goal with H : ?k <> ?n -> _ |- _ => (let E := fresh in assert (E : k <> n) by lia; specialize (H E); clear E) || clear H end;
    repeat match goal with H : _ /\ _ |- _ => destruct H end; subst; repeat apply conj; ring.
Qed.

Lemma plane_pure_plus : forall k A B, plane_pure k A -> plane_pure k B -> plane_pure k (plane_plus A B).
Proof.
  intros k [a a1 a2 a3 a12 a13 a23 a123] [b b1 b2 b3 b12 b13 b23 b123] H H'. cbn in H, H'. decompose [and] H. decompose [and] H'. clear H H'.
  cbn [plane_plus plane_pure]. repeat apply conj; intros K;
    repeat match goal with H : _ <> _ -> _ |- _ => specialize (H K) || clear H end;
    repeat match goal with H : _ /\ _ |- _ => destruct H end; subst; repeat apply conj; ring.
Qed.

Lemma plane_pure_scale : forall k x A, plane_pure k A -> plane_pure k (plane_scale x A).
Proof.
  intros k x [a a1 a2 a3 a12 a13 a23 a123] H. cbn in H. decompose [and] H. clear H.
  cbn [plane_scale plane_pure]. repeat apply conj; intros K;
    repeat match goal with H : _ <> _ -> _ |- _ => specialize (H K) || clear H end;
    repeat match goal with H : _ /\ _ |- _ => destruct H end; subst; repeat apply conj; ring.
Qed.

Lemma plane_pure_top : forall k A, plane_pure k A -> k <> 3%nat -> plane_top A = 0.
Proof. intros k [a a1 a2 a3 a12 a13 a23 a123] H K. cbn in H. decompose [and] H. cbn. auto. Qed.

Lemma plane_pure_full : forall A B, plane_pure 3 A -> plane_meet A B = plane_scale (plane_top A) B.
Proof.
  intros [a a1 a2 a3 a12 a13 a23 a123] [b b1 b2 b3 b12 b13 b23 b123] H. cbn in H. decompose [and] H. clear H.
  repeat match goal with H : ?k <> ?n -> _ |- _ => (let E := fresh in assert (E : k <> n) by lia; specialize (H E); clear E) || clear H end;
  repeat match goal with H : _ /\ _ |- _ => destruct H end; subst. plane_ring.
Qed.

Lemma plane_scalar_zero : forall x, plane_scale x plane_one = plane_zero -> x = 0.
Proof.
  intros x H. apply (f_equal (fun A => let '(Extensor3 a a1 a2 a3 a12 a13 a23 a123) := A in a)) in H. cbn in H. rewrite <- H. ring.
Qed.

Lemma plane_flat_one : plane_flat plane_one.
Proof. cbn. repeat split. Qed.

Lemma plane_flat_join : forall p A, plane_infinite p -> plane_flat A -> plane_flat (plane_join (plane_point p) A).
Proof.
  intros [x y w] [a a1 a2 a3 a12 a13 a23 a123] H H'. cbn in H, H'. decompose [and] H'. subst. cbn. repeat split; ring.
Qed.

Lemma plane_flat_top : forall A, plane_flat A -> plane_top A = 0.
Proof. intros [a a1 a2 a3 a12 a13 a23 a123] H. cbn in H. decompose [and] H. assumption. Qed.

Lemma plane_join_reverse : forall A p, plane_join A (plane_point p) = plane_join (plane_point p) (plane_involution A).
Proof. plane_ring. Qed.

Lemma plane_pure_involution : forall k A, plane_pure k A -> plane_pure k (plane_involution A).
Proof.
  intros k [a a1 a2 a3 a12 a13 a23 a123] H. cbn in H. decompose [and] H. clear H.
  cbn [plane_involution plane_pure]. repeat apply conj; intros K;
    repeat match goal with H : _ <> _ -> _ |- _ => specialize (H K) || clear H end;
    repeat match goal with H : _ /\ _ |- _ => destruct H end; subst; repeat apply conj; ring.
Qed.

Lemma plane_pure_last : forall A, plane_pure 3 A -> plane_top A = 0 -> A = plane_zero.
Proof.
  intros [a a1 a2 a3 a12 a13 a23 a123] H T. cbn in H, T. decompose [and] H. clear H.
  repeat match goal with H : ?k <> ?n -> _ |- _ => (let E := fresh in assert (E : k <> n) by lia; specialize (H E); clear E) || clear H end;
  repeat match goal with H : _ /\ _ |- _ => destruct H end; subst. reflexivity.
Qed.

Lemma plane_zero_test : forall A, (forall p, plane_join A (plane_point p) = plane_zero) -> plane_top A = 0 -> A = plane_zero.
Proof.
  intros [a a1 a2 a3 a12 a13 a23 a123] H T. cbn [plane_top] in T. unfold plane_zero in *. apply plane_equal.
  - transitivity ((let '(Extensor3 a a1 a2 a3 a12 a13 a23 a123) := plane_join (Extensor3 a a1 a2 a3 a12 a13 a23 a123) (plane_point (Vector3 0 0 1)) in a3)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity ((let '(Extensor3 a a1 a2 a3 a12 a13 a23 a123) := plane_join (Extensor3 a a1 a2 a3 a12 a13 a23 a123) (plane_point (Vector3 0 0 1)) in a13)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity ((let '(Extensor3 a a1 a2 a3 a12 a13 a23 a123) := plane_join (Extensor3 a a1 a2 a3 a12 a13 a23 a123) (plane_point (Vector3 0 0 1)) in a23)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity (- (let '(Extensor3 a a1 a2 a3 a12 a13 a23 a123) := plane_join (Extensor3 a a1 a2 a3 a12 a13 a23 a123) (plane_point (Vector3 0 1 0)) in a23)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity ((let '(Extensor3 a a1 a2 a3 a12 a13 a23 a123) := plane_join (Extensor3 a a1 a2 a3 a12 a13 a23 a123) (plane_point (Vector3 0 0 1)) in a123)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity (- (let '(Extensor3 a a1 a2 a3 a12 a13 a23 a123) := plane_join (Extensor3 a a1 a2 a3 a12 a13 a23 a123) (plane_point (Vector3 0 1 0)) in a123)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity ((let '(Extensor3 a a1 a2 a3 a12 a13 a23 a123) := plane_join (Extensor3 a a1 a2 a3 a12 a13 a23 a123) (plane_point (Vector3 1 0 0)) in a123)); [cbn; ring | rewrite H; cbn; ring].
  - exact T.
Qed.

Lemma plane_super_linear_1 : forall B C D E F, linear_form plane_plus plane_scale (fun A => plane_super A B C D E F).
Proof. split; intros; unfold plane_super; ring. Qed.
Lemma plane_super_linear_2 : forall A C D E F, linear_form plane_plus plane_scale (fun B => plane_super A B C D E F).
Proof. split; intros; unfold plane_super; ring. Qed.
Lemma plane_super_linear_3 : forall A B D E F, linear_form plane_plus plane_scale (fun C => plane_super A B C D E F).
Proof. split; intros; unfold plane_super; ring. Qed.
Lemma plane_super_linear_4 : forall A B C E F, linear_form plane_plus plane_scale (fun D => plane_super A B C D E F).
Proof. split; intros; unfold plane_super; ring. Qed.
Lemma plane_super_linear_5 : forall A B C D F, linear_form plane_plus plane_scale (fun E => plane_super A B C D E F).
Proof. split; intros; unfold plane_super; ring. Qed.
Lemma plane_super_linear_6 : forall A B C D E, linear_form plane_plus plane_scale (fun F => plane_super A B C D E F).
Proof. split; intros; unfold plane_super; ring. Qed.

Definition plane : geometry := {|
  rank := 3; vector := vector3; extensor := extensor3;
  zero := plane_zero;
  one := plane_one;
  plus := plane_plus;
  scale := plane_scale;
  join := plane_join;
  meet := plane_meet;
  top := plane_top;
  point := plane_point;
  super := plane_super;
  infinite := plane_infinite;
  flat := plane_flat;
  pure := plane_pure;
  involution := plane_involution;
  plus_comm := plane_plus_comm;
  plus_assoc := plane_plus_assoc;
  plus_zero := plane_plus_zero;
  scale_plus := plane_scale_plus;
  scale_add := plane_scale_add;
  scale_mul := plane_scale_mul;
  scale_1 := plane_scale_1;
  scale_0 := plane_scale_0;
  join_plus_l := plane_join_plus_l;
  join_plus_r := plane_join_plus_r;
  join_scale_l := plane_join_scale_l;
  join_scale_r := plane_join_scale_r;
  join_assoc := plane_join_assoc;
  join_one_l := plane_join_one_l;
  join_one_r := plane_join_one_r;
  join_same := plane_join_same;
  join_swap := plane_join_swap;
  meet_plus_l := plane_meet_plus_l;
  meet_plus_r := plane_meet_plus_r;
  meet_scale_l := plane_meet_scale_l;
  meet_scale_r := plane_meet_scale_r;
  meet_one := plane_meet_one;
  meet_join := plane_meet_join;
  involution_plus := plane_involution_plus;
  involution_scale := plane_involution_scale;
  involution_one := plane_involution_one;
  involution_join := plane_involution_join;
  top_plus := plane_top_plus;
  top_scale := plane_top_scale;
  pure_one := plane_pure_one;
  pure_join := plane_pure_join;
  pure_plus := plane_pure_plus;
  pure_scale := plane_pure_scale;
  pure_top := plane_pure_top;
  pure_full := plane_pure_full;
  join_reverse := plane_join_reverse;
  pure_involution := plane_pure_involution;
  pure_last := plane_pure_last;
  zero_test := plane_zero_test;
  scalar_zero := plane_scalar_zero;
  flat_one := plane_flat_one;
  flat_join := plane_flat_join;
  flat_top := plane_flat_top;
  super_linear_1 := plane_super_linear_1;
  super_linear_2 := plane_super_linear_2;
  super_linear_3 := plane_super_linear_3;
  super_linear_4 := plane_super_linear_4;
  super_linear_5 := plane_super_linear_5;
  super_linear_6 := plane_super_linear_6;
  super_points := (fun H : 3%nat = 4%nat => match Nat.neq_succ_diag_r 3 H with end)
|}.

(* ---- space: extensors of projective space: a scalar, four coordinates of points, six of lines (12, 13, 14, 23, 24, 34),
   four of planes (123, 124, 134, 234), one of space *)

Inductive vector4 := Vector4 (x y z w : R).

Inductive extensor4 := Extensor4 (a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234 : R).

Definition space_zero := Extensor4 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0.

Definition space_one := Extensor4 1 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0.

Definition space_plus '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) '(Extensor4 b b1 b2 b3 b4 b12 b13 b14 b23 b24 b34 b123 b124 b134 b234 b1234) : extensor4 :=
  Extensor4
    (a + b)
    (a1 + b1) (a2 + b2) (a3 + b3) (a4 + b4)
    (a12 + b12) (a13 + b13) (a14 + b14) (a23 + b23) (a24 + b24) (a34 + b34)
    (a123 + b123) (a124 + b124) (a134 + b134) (a234 + b234)
    (a1234 + b1234).

Definition space_scale (x : R) '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) : extensor4 :=
  Extensor4
    (x * a)
    (x * a1) (x * a2) (x * a3) (x * a4)
    (x * a12) (x * a13) (x * a14) (x * a23) (x * a24) (x * a34)
    (x * a123) (x * a124) (x * a134) (x * a234)
    (x * a1234).

(* the exterior product *)
Definition space_join '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) '(Extensor4 b b1 b2 b3 b4 b12 b13 b14 b23 b24 b34 b123 b124 b134 b234 b1234) : extensor4 :=
  Extensor4
    (a * b)
    (a * b1 + a1 * b)
    (a * b2 + a2 * b)
    (a * b3 + a3 * b)
    (a * b4 + a4 * b)
    (a * b12 + a1 * b2 - a2 * b1 + a12 * b)
    (a * b13 + a1 * b3 - a3 * b1 + a13 * b)
    (a * b14 + a1 * b4 - a4 * b1 + a14 * b)
    (a * b23 + a2 * b3 - a3 * b2 + a23 * b)
    (a * b24 + a2 * b4 - a4 * b2 + a24 * b)
    (a * b34 + a3 * b4 - a4 * b3 + a34 * b)
    (a * b123 + a1 * b23 - a2 * b13 + a3 * b12 + a12 * b3 - a13 * b2 + a23 * b1 + a123 * b)
    (a * b124 + a1 * b24 - a2 * b14 + a4 * b12 + a12 * b4 - a14 * b2 + a24 * b1 + a124 * b)
    (a * b134 + a1 * b34 - a3 * b14 + a4 * b13 + a13 * b4 - a14 * b3 + a34 * b1 + a134 * b)
    (a * b234 + a2 * b34 - a3 * b24 + a4 * b23 + a23 * b4 - a24 * b3 + a34 * b2 + a234 * b)
    (a * b1234 + a1 * b234 - a2 * b134 + a3 * b124 - a4 * b123 + a12 * b34 - a13 * b24 + a14 * b23 + a23 * b14 - a24 * b13 + a34 * b12 + a123 * b4 - a124 * b3 + a134 * b2 - a234 * b1 + a1234 * b).

(* e_J meets e_K in their common basis points, with the sign in which J = (P, J ∩ K) and (P, K) are rearranged,
   P being what K lacks: the splitting formula [P K] (J without P) at basis points *)
Definition space_meet '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) '(Extensor4 b b1 b2 b3 b4 b12 b13 b14 b23 b24 b34 b123 b124 b134 b234 b1234) : extensor4 :=
  Extensor4
    (a * b1234 + a1 * b234 - a2 * b134 + a3 * b124 - a4 * b123 + a12 * b34 - a13 * b24 + a14 * b23 + a23 * b14 - a24 * b13 + a34 * b12 + a123 * b4 - a124 * b3 + a134 * b2 - a234 * b1 + a1234 * b)
    (a1 * b1234 + a12 * b134 - a13 * b124 + a14 * b123 + a123 * b14 - a124 * b13 + a134 * b12 + a1234 * b1)
    (a2 * b1234 + a12 * b234 - a23 * b124 + a24 * b123 + a123 * b24 - a124 * b23 + a234 * b12 + a1234 * b2)
    (a3 * b1234 + a13 * b234 - a23 * b134 + a34 * b123 + a123 * b34 - a134 * b23 + a234 * b13 + a1234 * b3)
    (a4 * b1234 + a14 * b234 - a24 * b134 + a34 * b124 + a124 * b34 - a134 * b24 + a234 * b14 + a1234 * b4)
    (a12 * b1234 + a123 * b124 - a124 * b123 + a1234 * b12)
    (a13 * b1234 + a123 * b134 - a134 * b123 + a1234 * b13)
    (a14 * b1234 + a124 * b134 - a134 * b124 + a1234 * b14)
    (a23 * b1234 + a123 * b234 - a234 * b123 + a1234 * b23)
    (a24 * b1234 + a124 * b234 - a234 * b124 + a1234 * b24)
    (a34 * b1234 + a134 * b234 - a234 * b134 + a1234 * b34)
    (a123 * b1234 + a1234 * b123)
    (a124 * b1234 + a1234 * b124)
    (a134 * b1234 + a1234 * b134)
    (a234 * b1234 + a1234 * b234)
    (a1234 * b1234).

Definition space_top '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) : R := a1234.

Definition space_point '(Vector4 x y z w) : extensor4 :=
  Extensor4
    0
    x y z w
    0 0 0 0 0 0
    0 0 0 0
    0.

Definition space_infinite '(Vector4 x y z w) : Prop := w = 0.

Definition space_flat '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) : Prop :=
  a4 = 0 /\ a14 = 0 /\ a24 = 0 /\ a34 = 0 /\ a124 = 0 /\ a134 = 0 /\ a234 = 0 /\ a1234 = 0.

Definition space_pure (k : nat) '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) : Prop :=
  (k <> 0%nat -> a = 0) /\
  (k <> 1%nat -> a1 = 0 /\ a2 = 0 /\ a3 = 0 /\ a4 = 0) /\
  (k <> 2%nat -> a12 = 0 /\ a13 = 0 /\ a14 = 0 /\ a23 = 0 /\ a24 = 0 /\ a34 = 0) /\
  (k <> 3%nat -> a123 = 0 /\ a124 = 0 /\ a134 = 0 /\ a234 = 0) /\
  (k <> 4%nat -> a1234 = 0).

Definition space_involution '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) : extensor4 :=
  Extensor4
    a
    (- a1) (- a2) (- a3) (- a4)
    a12 a13 a14 a23 a24 a34
    (- a123) (- a124) (- a134) (- a234)
    a1234.

(* the six coordinates of a line *)
Definition line_coordinate (A : extensor4) (c : nat) : R :=
  let '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) := A in nth c [a12; a13; a14; a23; a24; a34] 0.

Definition space_super (A B C D E F : extensor4) : R :=
  determinant [line_coordinate A; line_coordinate B; line_coordinate C; line_coordinate D; line_coordinate E; line_coordinate F]
    (seq 0 6).

Lemma space_equal : forall a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234 b b1 b2 b3 b4 b12 b13 b14 b23 b24 b34 b123 b124 b134 b234 b1234,
  a = b -> a1 = b1 -> a2 = b2 -> a3 = b3 -> a4 = b4 -> a12 = b12 -> a13 = b13 -> a14 = b14 -> a23 = b23 -> a24 = b24 -> a34 = b34 -> a123 = b123 -> a124 = b124 -> a134 = b134 -> a234 = b234 -> a1234 = b1234 ->
  Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234 = Extensor4 b b1 b2 b3 b4 b12 b13 b14 b23 b24 b34 b123 b124 b134 b234 b1234.
Proof. intros; subst; reflexivity. Qed.

Ltac space_ring :=
  intros;
  repeat match goal with A : extensor4 |- _ => destruct A | p : vector4 |- _ => destruct p end;
  unfold space_zero, space_one;
  cbn [space_zero space_one space_plus space_scale space_join space_meet space_top space_point space_involution];
  try (apply space_equal; ring); try ring.

Lemma space_plus_comm : forall A B, space_plus A B = space_plus B A.
Proof. space_ring. Qed.
Lemma space_plus_assoc : forall A B C, space_plus A (space_plus B C) = space_plus (space_plus A B) C.
Proof. space_ring. Qed.
Lemma space_plus_zero : forall A, space_plus space_zero A = A.
Proof. space_ring. Qed.
Lemma space_scale_plus : forall x A B, space_scale x (space_plus A B) = space_plus (space_scale x A) (space_scale x B).
Proof. space_ring. Qed.
Lemma space_scale_add : forall x y A, space_scale (x + y) A = space_plus (space_scale x A) (space_scale y A).
Proof. space_ring. Qed.
Lemma space_scale_mul : forall x y A, space_scale (x * y) A = space_scale x (space_scale y A).
Proof. space_ring. Qed.
Lemma space_scale_1 : forall A, space_scale 1 A = A.
Proof. space_ring. Qed.
Lemma space_scale_0 : forall A, space_scale 0 A = space_zero.
Proof. space_ring. Qed.
Lemma space_join_plus_l : forall A B C, space_join (space_plus A B) C = space_plus (space_join A C) (space_join B C).
Proof. space_ring. Qed.
Lemma space_join_plus_r : forall A B C, space_join A (space_plus B C) = space_plus (space_join A B) (space_join A C).
Proof. space_ring. Qed.
Lemma space_join_scale_l : forall x A B, space_join (space_scale x A) B = space_scale x (space_join A B).
Proof. space_ring. Qed.
Lemma space_join_scale_r : forall x A B, space_join A (space_scale x B) = space_scale x (space_join A B).
Proof. space_ring. Qed.
Lemma space_meet_plus_l : forall A B C, space_meet (space_plus A B) C = space_plus (space_meet A C) (space_meet B C).
Proof. space_ring. Qed.
Lemma space_meet_plus_r : forall A B C, space_meet A (space_plus B C) = space_plus (space_meet A B) (space_meet A C).
Proof. space_ring. Qed.
Lemma space_meet_scale_l : forall x A B, space_meet (space_scale x A) B = space_scale x (space_meet A B).
Proof. space_ring. Qed.
Lemma space_meet_scale_r : forall x A B, space_meet A (space_scale x B) = space_scale x (space_meet A B).
Proof. space_ring. Qed.
Lemma space_join_assoc : forall A B C, space_join A (space_join B C) = space_join (space_join A B) C.
Proof. space_ring. Qed.
Lemma space_join_one_l : forall A, space_join space_one A = A.
Proof. space_ring. Qed.
Lemma space_join_one_r : forall A, space_join A space_one = A.
Proof. space_ring. Qed.
Lemma space_join_same : forall p, space_join (space_point p) (space_point p) = space_zero.
Proof. space_ring. Qed.
Lemma space_join_swap : forall p q, space_join (space_point p) (space_point q) = space_scale (- (1)) (space_join (space_point q) (space_point p)).
Proof. space_ring. Qed.
Lemma space_meet_one : forall B, space_meet space_one B = space_scale (space_top B) space_one.
Proof. space_ring. Qed.
Lemma space_meet_join : forall A p B, space_meet (space_join A (space_point p)) B =
  space_plus (space_join (space_meet A B) (space_point p)) (space_involution (space_meet A (space_join (space_point p) B))).
Proof. space_ring. Qed.
Lemma space_involution_plus : forall A B, space_involution (space_plus A B) = space_plus (space_involution A) (space_involution B).
Proof. space_ring. Qed.
Lemma space_involution_scale : forall x A, space_involution (space_scale x A) = space_scale x (space_involution A).
Proof. space_ring. Qed.
Lemma space_involution_one : space_involution space_one = space_one.
Proof. space_ring. Qed.
Lemma space_involution_join : forall p A, space_involution (space_join (space_point p) A) =
  space_scale (- (1)) (space_join (space_point p) (space_involution A)).
Proof. space_ring. Qed.
Lemma space_top_plus : forall A B, space_top (space_plus A B) = space_top A + space_top B.
Proof. space_ring. Qed.
Lemma space_top_scale : forall x A, space_top (space_scale x A) = x * space_top A.
Proof. space_ring. Qed.

Lemma space_pure_one : space_pure 0 space_one.
Proof. cbn. repeat split; intros; try reflexivity; contradiction. Qed.

Lemma space_pure_join : forall k p A, space_pure k A -> space_pure (S k) (space_join (space_point p) A).
Proof.
  intros k [x y z w] [a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234] H. cbn in H. decompose [and] H. clear H.
  cbn [space_join space_point space_pure]. repeat apply conj; intros K;
    repeat match goal with H : ?k <> ?n -> _ |- _ => (let E := fresh in assert (E : k <> n) by lia; specialize (H E); clear E) || clear H end;
    repeat match goal with H : _ /\ _ |- _ => destruct H end; subst; repeat apply conj; ring.
Qed.

Lemma space_pure_plus : forall k A B, space_pure k A -> space_pure k B -> space_pure k (space_plus A B).
Proof.
  intros k [a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234] [b b1 b2 b3 b4 b12 b13 b14 b23 b24 b34 b123 b124 b134 b234 b1234] H H'. cbn in H, H'. decompose [and] H. decompose [and] H'. clear H H'.
  cbn [space_plus space_pure]. repeat apply conj; intros K;
    repeat match goal with H : _ <> _ -> _ |- _ => specialize (H K) || clear H end;
    repeat match goal with H : _ /\ _ |- _ => destruct H end; subst; repeat apply conj; ring.
Qed.

Lemma space_pure_scale : forall k x A, space_pure k A -> space_pure k (space_scale x A).
Proof.
  intros k x [a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234] H. cbn in H. decompose [and] H. clear H.
  cbn [space_scale space_pure]. repeat apply conj; intros K;
    repeat match goal with H : _ <> _ -> _ |- _ => specialize (H K) || clear H end;
    repeat match goal with H : _ /\ _ |- _ => destruct H end; subst; repeat apply conj; ring.
Qed.

Lemma space_pure_top : forall k A, space_pure k A -> k <> 4%nat -> space_top A = 0.
Proof. intros k [a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234] H K. cbn in H. decompose [and] H. cbn. auto. Qed.

Lemma space_pure_full : forall A B, space_pure 4 A -> space_meet A B = space_scale (space_top A) B.
Proof.
  intros [a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234] [b b1 b2 b3 b4 b12 b13 b14 b23 b24 b34 b123 b124 b134 b234 b1234] H. cbn in H. decompose [and] H. clear H.
  repeat match goal with H : ?k <> ?n -> _ |- _ => (let E := fresh in assert (E : k <> n) by lia; specialize (H E); clear E) || clear H end;
  repeat match goal with H : _ /\ _ |- _ => destruct H end; subst. space_ring.
Qed.

Lemma space_scalar_zero : forall x, space_scale x space_one = space_zero -> x = 0.
Proof.
  intros x H. apply (f_equal (fun A => let '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) := A in a)) in H. cbn in H. rewrite <- H. ring.
Qed.

Lemma space_flat_one : space_flat space_one.
Proof. cbn. repeat split. Qed.

Lemma space_flat_join : forall p A, space_infinite p -> space_flat A -> space_flat (space_join (space_point p) A).
Proof.
  intros [x y z w] [a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234] H H'. cbn in H, H'. decompose [and] H'. subst. cbn. repeat split; ring.
Qed.

Lemma space_flat_top : forall A, space_flat A -> space_top A = 0.
Proof. intros [a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234] H. cbn in H. decompose [and] H. assumption. Qed.

Lemma space_join_reverse : forall A p, space_join A (space_point p) = space_join (space_point p) (space_involution A).
Proof. space_ring. Qed.

Lemma space_pure_involution : forall k A, space_pure k A -> space_pure k (space_involution A).
Proof.
  intros k [a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234] H. cbn in H. decompose [and] H. clear H.
  cbn [space_involution space_pure]. repeat apply conj; intros K;
    repeat match goal with H : _ <> _ -> _ |- _ => specialize (H K) || clear H end;
    repeat match goal with H : _ /\ _ |- _ => destruct H end; subst; repeat apply conj; ring.
Qed.

Lemma space_pure_last : forall A, space_pure 4 A -> space_top A = 0 -> A = space_zero.
Proof.
  intros [a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234] H T. cbn in H, T. decompose [and] H. clear H.
  repeat match goal with H : ?k <> ?n -> _ |- _ => (let E := fresh in assert (E : k <> n) by lia; specialize (H E); clear E) || clear H end;
  repeat match goal with H : _ /\ _ |- _ => destruct H end; subst. reflexivity.
Qed.

Lemma space_zero_test : forall A, (forall p, space_join A (space_point p) = space_zero) -> space_top A = 0 -> A = space_zero.
Proof.
  intros [a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234] H T. cbn [space_top] in T. unfold space_zero in *. apply space_equal.
  - transitivity ((let '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) := space_join (Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) (space_point (Vector4 0 0 0 1)) in a4)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity ((let '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) := space_join (Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) (space_point (Vector4 0 0 0 1)) in a14)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity ((let '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) := space_join (Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) (space_point (Vector4 0 0 0 1)) in a24)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity ((let '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) := space_join (Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) (space_point (Vector4 0 0 0 1)) in a34)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity (- (let '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) := space_join (Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) (space_point (Vector4 0 0 1 0)) in a34)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity ((let '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) := space_join (Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) (space_point (Vector4 0 0 0 1)) in a124)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity ((let '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) := space_join (Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) (space_point (Vector4 0 0 0 1)) in a134)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity (- (let '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) := space_join (Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) (space_point (Vector4 0 0 1 0)) in a134)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity ((let '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) := space_join (Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) (space_point (Vector4 0 0 0 1)) in a234)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity (- (let '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) := space_join (Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) (space_point (Vector4 0 0 1 0)) in a234)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity ((let '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) := space_join (Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) (space_point (Vector4 0 1 0 0)) in a234)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity ((let '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) := space_join (Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) (space_point (Vector4 0 0 0 1)) in a1234)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity (- (let '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) := space_join (Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) (space_point (Vector4 0 0 1 0)) in a1234)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity ((let '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) := space_join (Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) (space_point (Vector4 0 1 0 0)) in a1234)); [cbn; ring | rewrite H; cbn; ring].
  - transitivity (- (let '(Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) := space_join (Extensor4 a a1 a2 a3 a4 a12 a13 a14 a23 a24 a34 a123 a124 a134 a234 a1234) (space_point (Vector4 1 0 0 0)) in a1234)); [cbn; ring | rewrite H; cbn; ring].
  - exact T.
Qed.

(* ---- the formula of the superbracket *)

Definition front (P : extensor4) (c d : vector4) : R := space_top (space_join P (space_join (space_point c) (space_point d))).
Definition back (c d : vector4) (Q : extensor4) : R := space_top (space_join (space_point c) (space_join (space_point d) Q)).
Definition four (a b c d : vector4) : R :=
  space_top (space_join (space_point a) (space_join (space_point b) (space_join (space_point c) (space_point d)))).

Lemma line_value : forall x y z w x' y' z' w',
  space_join (space_point (Vector4 x y z w)) (space_point (Vector4 x' y' z' w')) =
  Extensor4 0 0 0 0 0 (x * y' - y * x') (x * z' - z * x') (x * w' - w * x') (y * z' - z * y') (y * w' - w * y') (z * w' - w * z') 0 0 0 0 0.
Proof. space_ring. Qed.

Definition pairing (p12 p13 p14 p23 p24 p34 : R) (c d : vector4) : R :=
  let '(Vector4 x y z w) := c in
  let '(Vector4 x' y' z' w') := d in
  p12 * (z * w' - w * z') - p13 * (y * w' - w * y') + p14 * (y * z' - z * y') +
  p23 * (x * w' - w * x') - p24 * (x * z' - z * x') + p34 * (x * y' - y * x').

Lemma front_value : forall p12 p13 p14 p23 p24 p34 c d,
  front (Extensor4 0 0 0 0 0 p12 p13 p14 p23 p24 p34 0 0 0 0 0) c d = pairing p12 p13 p14 p23 p24 p34 c d.
Proof. intros p12 p13 p14 p23 p24 p34 [x y z w] [x' y' z' w']. cbn. ring. Qed.

Lemma back_value : forall q12 q13 q14 q23 q24 q34 c d,
  back c d (Extensor4 0 0 0 0 0 q12 q13 q14 q23 q24 q34 0 0 0 0 0) = pairing q12 q13 q14 q23 q24 q34 c d.
Proof. intros q12 q13 q14 q23 q24 q34 [x y z w] [x' y' z' w']. cbn. ring. Qed.

Lemma four_value : forall x y z w x' y' z' w' c d, four (Vector4 x y z w) (Vector4 x' y' z' w') c d =
  pairing (x * y' - y * x') (x * z' - z * x') (x * w' - w * x') (y * z' - z * y') (y * w' - w * y') (z * w' - w * z') c d.
Proof.
  intros. rewrite <- front_value, <- line_value. unfold four, front. rewrite space_join_assoc. reflexivity.
Qed.

Lemma six_lines : forall p12 p13 p14 p23 p24 p34 q12 q13 q14 q23 q24 q34 c d e f g h i j,
  let P := Extensor4 0 0 0 0 0 p12 p13 p14 p23 p24 p34 0 0 0 0 0 in
  let Q := Extensor4 0 0 0 0 0 q12 q13 q14 q23 q24 q34 0 0 0 0 0 in
  let line a b := space_join (space_point a) (space_point b) in
  space_super P (line c d) (line e f) (line g h) (line i j) Q =
   - (front P c d * (four e f g i * back h j Q))
    + (front P c d * (four e f h i * back g j Q))
    + (front P c d * (four e f g j * back h i Q))
    - (front P c d * (four e f h j * back g i Q))
    + (front P c e * (four d f g h * back i j Q))
    - (front P d e * (four c f g h * back i j Q))
    - (front P c f * (four d e g h * back i j Q))
    + (front P d f * (four c e g h * back i j Q))
    - (front P c e * (four d g h i * back f j Q))
    + (front P d e * (four c g h i * back f j Q))
    + (front P c f * (four d g h i * back e j Q))
    + (front P c e * (four d g h j * back f i Q))
    - (front P d f * (four c g h i * back e j Q))
    - (front P d e * (four c g h j * back f i Q))
    - (front P c f * (four d g h j * back e i Q))
    + (front P d f * (four c g h j * back e i Q))
    + (front P c g * (four d e f i * back h j Q))
    - (front P d g * (four c e f i * back h j Q))
    - (front P c h * (four d e f i * back g j Q))
    - (front P c g * (four d e f j * back h i Q))
    + (front P d h * (four c e f i * back g j Q))
    + (front P d g * (four c e f j * back h i Q))
    + (front P c h * (four d e f j * back g i Q))
    - (front P d h * (four c e f j * back g i Q)).
Proof.
  intros; destruct c, d, e, f, g, h, i, j. unfold P, Q, line.
  rewrite !line_value, !front_value, !back_value, !four_value. unfold pairing.
  cbv [space_super determinant expansion seq line_coordinate nth app]. ring.
Qed.

Lemma line_coordinates : forall a b, exists p12 p13 p14 p23 p24 p34,
  space_join (space_point a) (space_point b) = Extensor4 0 0 0 0 0 p12 p13 p14 p23 p24 p34 0 0 0 0 0.
Proof. intros [x y z w] [x' y' z' w']. do 6 eexists. cbn. apply space_equal; try reflexivity; ring. Qed.

Lemma space_super_points : 4%nat = 4%nat -> forall a b c d e f g h i j k l,
  let line p q := space_join (space_point p) (space_join (space_point q) space_one) in
  space_super (line a b) (line c d) (line e f) (line g h) (line i j) (line k l) =
  fold_right (fun t s =>
    (let '(negative, x, y, z) := t in
     let bracket v := space_top (fold_right (fun p B => space_join (space_point p) B) space_one v) in
     sign negative * (bracket x * (bracket y * bracket z))) + s) 0
    (superbracket_terms a b c d e f g h i j k l).
Proof.
  intros _ a b c d e f g h i j k l. cbv zeta. unfold superbracket_terms. cbn [fold_right sign].
  rewrite !space_join_one_r.
  assert (F : forall x y, four a b x y = front (space_join (space_point a) (space_point b)) x y).
  { intros. unfold four, front. rewrite space_join_assoc. reflexivity. }
  repeat match goal with |- context [space_top (space_join (space_point ?p) (space_join (space_point ?q)
    (space_join (space_point ?r) (space_point ?s))))] =>
    lazymatch s with
    | l => change (space_top (space_join (space_point p) (space_join (space_point q)
             (space_join (space_point r) (space_point s))))) with (back p q (space_join (space_point k) (space_point l)))
    | _ => change (space_top (space_join (space_point p) (space_join (space_point q)
             (space_join (space_point r) (space_point s))))) with (four p q r s)
    end end.
  rewrite !F.
  destruct (line_coordinates a b) as (p12 & p13 & p14 & p23 & p24 & p34 & ->).
  destruct (line_coordinates k l) as (q12 & q13 & q14 & q23 & q24 & q34 & ->).
  etransitivity; [apply six_lines|]. ring.
Qed.

Lemma line_coordinate_plus : forall A B c,
  line_coordinate (space_plus A B) c = line_coordinate A c + line_coordinate B c.
Proof. intros [] [] c. do 6 (destruct c; [reflexivity|]). cbn. destruct c; ring. Qed.

Lemma line_coordinate_scale : forall x A c, line_coordinate (space_scale x A) c = x * line_coordinate A c.
Proof. intros x [] c. do 6 (destruct c; [reflexivity|]). cbn. destruct c; ring. Qed.

Lemma space_super_linear_1 : forall B C D E F, linear_form space_plus space_scale (fun A => space_super A B C D E F).
Proof.
  intros. split; intros.
  - apply (determinant_plus _ _ _ (line_coordinate_plus _ _) []).
  - apply (determinant_scale _ _ _ (line_coordinate_scale _ _) []).
Qed.
Lemma space_super_linear_2 : forall A C D E F, linear_form space_plus space_scale (fun B => space_super A B C D E F).
Proof.
  intros. split; intros.
  - apply (determinant_plus _ _ _ (line_coordinate_plus _ _) [line_coordinate A]).
  - apply (determinant_scale _ _ _ (line_coordinate_scale _ _) [line_coordinate A]).
Qed.
Lemma space_super_linear_3 : forall A B D E F, linear_form space_plus space_scale (fun C => space_super A B C D E F).
Proof.
  intros. split; intros.
  - apply (determinant_plus _ _ _ (line_coordinate_plus _ _) [line_coordinate A; line_coordinate B]).
  - apply (determinant_scale _ _ _ (line_coordinate_scale _ _) [line_coordinate A; line_coordinate B]).
Qed.
Lemma space_super_linear_4 : forall A B C E F, linear_form space_plus space_scale (fun D => space_super A B C D E F).
Proof.
  intros. split; intros.
  - apply (determinant_plus _ _ _ (line_coordinate_plus _ _) [line_coordinate A; line_coordinate B; line_coordinate C]).
  - apply (determinant_scale _ _ _ (line_coordinate_scale _ _) [line_coordinate A; line_coordinate B; line_coordinate C]).
Qed.
Lemma space_super_linear_5 : forall A B C D F, linear_form space_plus space_scale (fun E => space_super A B C D E F).
Proof.
  intros. split; intros.
  - apply (determinant_plus _ _ _ (line_coordinate_plus _ _) [line_coordinate A; line_coordinate B; line_coordinate C; line_coordinate D]).
  - apply (determinant_scale _ _ _ (line_coordinate_scale _ _) [line_coordinate A; line_coordinate B; line_coordinate C; line_coordinate D]).
Qed.
Lemma space_super_linear_6 : forall A B C D E, linear_form space_plus space_scale (fun F => space_super A B C D E F).
Proof.
  intros. split; intros.
  - apply (determinant_plus _ _ _ (line_coordinate_plus _ _) [line_coordinate A; line_coordinate B; line_coordinate C; line_coordinate D; line_coordinate E]).
  - apply (determinant_scale _ _ _ (line_coordinate_scale _ _) [line_coordinate A; line_coordinate B; line_coordinate C; line_coordinate D; line_coordinate E]).
Qed.

Definition space : geometry := {|
  rank := 4; vector := vector4; extensor := extensor4;
  zero := space_zero;
  one := space_one;
  plus := space_plus;
  scale := space_scale;
  join := space_join;
  meet := space_meet;
  top := space_top;
  point := space_point;
  super := space_super;
  infinite := space_infinite;
  flat := space_flat;
  pure := space_pure;
  involution := space_involution;
  plus_comm := space_plus_comm;
  plus_assoc := space_plus_assoc;
  plus_zero := space_plus_zero;
  scale_plus := space_scale_plus;
  scale_add := space_scale_add;
  scale_mul := space_scale_mul;
  scale_1 := space_scale_1;
  scale_0 := space_scale_0;
  join_plus_l := space_join_plus_l;
  join_plus_r := space_join_plus_r;
  join_scale_l := space_join_scale_l;
  join_scale_r := space_join_scale_r;
  join_assoc := space_join_assoc;
  join_one_l := space_join_one_l;
  join_one_r := space_join_one_r;
  join_same := space_join_same;
  join_swap := space_join_swap;
  meet_plus_l := space_meet_plus_l;
  meet_plus_r := space_meet_plus_r;
  meet_scale_l := space_meet_scale_l;
  meet_scale_r := space_meet_scale_r;
  meet_one := space_meet_one;
  meet_join := space_meet_join;
  involution_plus := space_involution_plus;
  involution_scale := space_involution_scale;
  involution_one := space_involution_one;
  involution_join := space_involution_join;
  top_plus := space_top_plus;
  top_scale := space_top_scale;
  pure_one := space_pure_one;
  pure_join := space_pure_join;
  pure_plus := space_pure_plus;
  pure_scale := space_pure_scale;
  pure_top := space_pure_top;
  pure_full := space_pure_full;
  join_reverse := space_join_reverse;
  pure_involution := space_pure_involution;
  pure_last := space_pure_last;
  zero_test := space_zero_test;
  scalar_zero := space_scalar_zero;
  flat_one := space_flat_one;
  flat_join := space_flat_join;
  flat_top := space_flat_top;
  super_linear_1 := space_super_linear_1;
  super_linear_2 := space_super_linear_2;
  super_linear_3 := space_super_linear_3;
  super_linear_4 := space_super_linear_4;
  super_linear_5 := space_super_linear_5;
  super_linear_6 := space_super_linear_6;
  super_points := space_super_points
|}.

(* ---- what the coordinates mean *)

Lemma bracket_of_space : forall a b c d : vector4,
  space_top (space_join (space_join (space_join (space_point a) (space_point b)) (space_point c)) (space_point d)) =
  determinant (map (fun p i => let '(Vector4 x y z w) := p in nth i [x; y; z; w] 0) [a; b; c; d]) [0; 1; 2; 3]%nat.
Proof. intros [] [] [] []. cbn. ring. Qed.

Lemma bracket_of_plane : forall a b c : vector3,
  plane_top (plane_join (plane_join (plane_point a) (plane_point b)) (plane_point c)) =
  determinant (map (fun p i => let '(Vector3 x y w) := p in nth i [x; y; w] 0) [a; b; c]) [0; 1; 2]%nat.
Proof. intros [] [] []. cbn. ring. Qed.

Lemma lines_of_plane : forall a12 a13 a23 b12 b13 b23 c12 c13 c23,
  plane_meet (plane_meet (Extensor3 0 0 0 0 a12 a13 a23 0) (Extensor3 0 0 0 0 b12 b13 b23 0))
    (Extensor3 0 0 0 0 c12 c13 c23 0) =
  plane_scale (determinant (map (fun l i => nth i l 0) [[a12; a13; a23]; [b12; b13; b23]; [c12; c13; c23]]) [0; 1; 2]%nat)
    plane_one.
Proof. intros. cbn. apply plane_equal; ring. Qed.

(* ---- notation of the theorems *)

Definition origin_of_space : vector space := Vector4 0 0 0 1.
Definition origin_of_plane : vector plane := Vector3 0 0 1.

Arguments bracket {G} A.
Arguments superbracket {G} A B C D E F.
Arguments power {G} A n.
Coercion point : vector >-> extensor.
Notation "A ∨ B" := (join _ A B) (at level 40, left associativity).
Notation "A ∧ B" := (meet _ A B) (at level 45, left associativity).
Notation "A · B" := (join _ A B) (at level 46, left associativity, only parsing).
Declare Scope extensor_scope.
Bind Scope extensor_scope with extensor.
Notation "A + B" := (plus _ A B) : extensor_scope.
Local Open Scope nat_scope.
Local Open Scope extensor_scope.

Definition times_brackets (c : Z) (m : list row) : Z * list row := (c, m).
Definition exchange_of (u v : row) (k : nat) (m : list (Z * list row)) : relation := (u, v, k, m).
