(** * Conditions: a polynomial and its sign *)

Inductive sign := SZ | SNZ | SNN | SP.
Record atom := A { apoly : poly; asign : sign }.
Definition holds (e : nat -> R) (a : atom) : Prop :=
  match asign a with
  | SZ => peval e (apoly a) = 0 | SNZ => peval e (apoly a) <> 0
  | SNN => 0 <= peval e (apoly a) | SP => 0 < peval e (apoly a)
  end.
Definition admits (s : sign) (c : Z) : bool :=
  match s with
  | SZ => Z.eqb c 0 | SNZ => negb (Z.eqb c 0) | SNN => Z.leb 0 c | SP => Z.ltb 0 c
  end.
Definition decided (a : atom) : option bool := option_map (admits (asign a)) (as_const (apoly a)).
Definition anot (a : atom) : atom :=
  match asign a with
  | SZ => A (apoly a) SNZ | SNZ => A (apoly a) SZ
  | SNN => A (pneg (apoly a)) SP | SP => A (pneg (apoly a)) SNN
  end.
Definition seqb (s t : sign) : bool :=
  match s, t with SZ, SZ | SNZ, SNZ | SNN, SNN | SP, SP => true | _, _ => false end.
Definition aeqb (a b : atom) : bool := seqb (asign a) (asign b) && peqb (apoly a) (apoly b).

Lemma decided_holds e a b : decided a = Some b -> (holds e a <-> b = true).
Proof.
  unfold decided, holds. destruct (as_const (apoly a)) as [c|] eqn:E; [|discriminate].
  rewrite (as_const_eval e _ _ E). simpl. intro H; inversion H; clear H; subst. destruct (asign a); simpl.
  - rewrite Z.eqb_eq. split; [apply eq_IZR_R0|intros ->; trivial].
  - rewrite negb_true_iff, Z.eqb_neq. split; [intros H ->; auto|intros H F; apply H, eq_IZR_R0, F].
  - rewrite Z.leb_le. split; [apply le_IZR|apply IZR_le].
  - rewrite Z.ltb_lt. split; [apply lt_IZR|apply IZR_lt].
Qed.
Lemma anot_holds e a : holds e (anot a) <-> ~ holds e a.
Proof.
  unfold holds, anot. destruct (asign a); simpl; rewrite ?peval_neg; lra. Qed.
Lemma holds_dec e a : holds e a \/ ~ holds e a.
Proof.
  unfold holds. destruct (asign a); try lra; destruct (Req_dec (peval e (apoly a)) 0); tauto.
Qed.
Lemma aeqb_eq a b : aeqb a b = true -> a = b.
Proof.
  unfold aeqb; intro H; apply andb_true_iff in H as [H G]; apply peqb_eq in G.
  destruct a as [p s], b as [q t]; simpl in *; subst. destruct s, t; try discriminate; trivial.
Qed.

Definition atoms := list atom.
Definition cases := list atoms.
Notation all_hold e := (Forall (holds e)).
Definition some_case (e : nat -> R) (c : cases) : Prop := exists a, In a c /\ all_hold e a.
Definition some_cases (e : nat -> R) (fs : list cases) := Forall (some_case e) fs.

Fixpoint joined (a b : atoms) : option atoms :=
  match b with
  | [] => Some a
  | x :: b' =>
    match decided x with
    | Some true => joined a b'
    | Some false => None
    | None => if existsb (aeqb (anot x)) a then None
              else if existsb (aeqb x) a then joined a b' else joined (a ++ [x]) b'
    end
  end.
Lemma all_in e l x : all_hold e l -> In x l -> holds e x.
Proof. intros H I. rewrite Forall_forall in H; auto. Qed.
Lemma joined_spec e b a :
  match joined a b with
  | Some c => all_hold e c <-> all_hold e a /\ all_hold e b
  | None => ~ (all_hold e a /\ all_hold e b)
  end.
Proof.
  revert a; induction b as [|x b IH]; simpl; intro a.
  { split; [intro; split; trivial; constructor|tauto]. }
  assert (C : all_hold e (x :: b) <-> holds e x /\ all_hold e b) by apply Forall_cons_iff.
  destruct (decided x) as [[|]|] eqn:D.
  - pose proof (proj2 (decided_holds e _ _ D) eq_refl). specialize (IH a).
    destruct (joined a b); tauto.
  - pose proof (decided_holds e _ _ D) as F. assert (~ holds e x) by (rewrite F; discriminate). tauto.
  - destruct (existsb (aeqb (anot x)) a) eqn:E.
    + apply existsb_exists in E as [y [I Y]]. apply aeqb_eq in Y; subst.
      intros [Ha Hx]. pose proof (all_in _ _ _ Ha I) as N. rewrite anot_holds in N. tauto.
    + destruct (existsb (aeqb x) a) eqn:F.
      * apply existsb_exists in F as [y [I Y]]. apply aeqb_eq in Y; subst.
        specialize (IH a). pose proof (fun H => all_in e a y H I). destruct (joined a b); tauto.
      * specialize (IH (a ++ [x])). destruct (joined (a ++ [x]) b);
          rewrite Forall_app in IH; pose proof (Forall_cons_iff (holds e) x []);
          pose proof (Forall_nil (holds e)); tauto.
Qed.

(** * Regions: what something is where conditions hold *)

Definition pieces (T : Type) := list (atoms * option T).
Definition spec {T} (e : nat -> R) (ps : pieces T) (G : option T -> Prop) : Prop :=
  (forall p, In p ps -> all_hold e (fst p) -> G (snd p)) /\
  (exists p, In p ps /\ all_hold e (fst p)).
Definition everywhere {T} (v : option T) : pieces T := [([], v)].
Definition either {T} (a : atom) (x y : option T) : pieces T := [([a], x); ([anot a], y)].
Definition each {T U} (ps : pieces T) (next : T -> pieces U) : pieces U :=
  flat_map (fun p =>
    flat_map (fun q => match joined (fst p) (fst q) with Some a => [(a, snd q)] | None => [] end)
      (match snd p with None => everywhere None | Some v => next v end)) ps.
Definition both {T U V} (ps : pieces T) (qs : pieces U) (next : T -> U -> pieces V) : pieces V :=
  each ps (fun x => each qs (next x)).

Lemma spec_everywhere {T} e (v : option T) (G : option T -> Prop) : G v -> spec e (everywhere v) G.
Proof.
  intro H; split; [intros p [<-|[]] _; trivial|].
  exists ([], v); split; [left; trivial|constructor].
Qed.
Lemma spec_either {T} e a (x y : option T) (G : option T -> Prop) :
  (holds e a -> G x) -> (~ holds e a -> G y) -> spec e (either a x y) G.
Proof.
  intros X Y; split.
  - intros p [<-|[<-|[]]] H; simpl in *; inversion H; subst; auto. apply Y, anot_holds; trivial.
  - destruct (holds_dec e a).
    + exists ([a], x); split; [left; trivial|repeat constructor; trivial].
    + exists ([anot a], y); split; [right; left; trivial|].
      constructor; [apply anot_holds; trivial|constructor].
Qed.
Lemma spec_each {T U} e (ps : pieces T) (next : T -> pieces U) G (H : option U -> Prop) :
  spec e ps G -> (G None -> H None) -> (forall v, G (Some v) -> spec e (next v) H) ->
  spec e (each ps next) H.
Proof.
  intros [A E] N S.
  assert (B : forall p, In p ps -> all_hold e (fst p) ->
    spec e (match snd p with None => everywhere None | Some v => next v end) H).
  { intros p I P. specialize (A p I P). destruct (snd p); [apply S; trivial|].
    apply spec_everywhere; auto. }
  split.
  - intros r I R. apply in_flat_map in I as [p [Ip I]]. apply in_flat_map in I as [q [Iq I]].
    pose proof (joined_spec e (fst q) (fst p)) as J. destruct (joined (fst p) (fst q)); [|destruct I].
    destruct I as [<-|[]]. simpl in *. apply J in R as [P Q]. apply (proj1 (B p Ip P) q Iq Q).
  - destruct E as [p [Ip P]]. destruct (proj2 (B p Ip P)) as [q [Iq Q]].
    pose proof (joined_spec e (fst q) (fst p)) as J. destruct (joined (fst p) (fst q)) as [c|] eqn:C; [|tauto].
    exists (c, snd q); split; [|apply J; split; trivial].
    apply in_flat_map; exists p; split; trivial. apply in_flat_map; exists q; split; trivial.
    rewrite C; left; trivial.
Qed.
Lemma spec_both {T U V} e (ps : pieces T) (qs : pieces U) (next : T -> U -> pieces V) G K (H : option V -> Prop) :
  spec e ps G -> spec e qs K -> (G None -> H None) -> (forall x, G (Some x) -> K None -> H None) ->
  (forall x y, G (Some x) -> K (Some y) -> spec e (next x y) H) -> spec e (both ps qs next) H.
Proof.
  intros. apply spec_each with G; auto. intros x X. apply spec_each with K; auto. intro; eauto.
Qed.
Lemma spec_weaken {T} e (ps : pieces T) (G H : option T -> Prop) :
  spec e ps G -> (forall v, G v -> H v) -> spec e ps H.
Proof. intros [A B] I; split; auto. Qed.
