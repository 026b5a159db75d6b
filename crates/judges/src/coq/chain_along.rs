//! Theorems about functions: what holds on a set that reaches up to a limit, and on which all givens
//! hold.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use kane_kernel::{Conclusion, Fuel, Goal, Hypothesis, Link, Relation, Sentence, Side, scope};

use super::NotEmitted;
use super::chain::{Along, Form, Place, Theorem, Theorems, Unchained, said};
use super::family::{Family, Setting, Slot, side};
use super::prose::Prose;
use super::reify::Symbols;

impl Place<'_> {
    /// The theorem of a claim about functions, from its lemma; or of one that rests on such claims.
    pub(super) fn along(
        &self,
        lemma: String,
        name: String,
        x: usize,
        known: &Theorems,
    ) -> Result<Theorem, Unchained> {
        let (cited, goal) = (self.cited()?, &self.accepted.goal);
        let always_when = |form: &Along| form.always_when;
        let when = !goal.when.is_empty() && !self.form.along.as_ref().is_some_and(always_when);
        if cited.iter().all(|i| self.is_given(*i)) {
            let text = format!("Definition {name} := {lemma}.\n");
            let (form, needs) = (self.form.clone(), Vec::new());
            return Ok(Theorem { name, text, needs, form, givens: cited, when });
        }
        let mut used: Vec<&Theorem> = Vec::new();
        for &i in cited.iter().filter(|i| !self.is_given(**i)) {
            for link in 0..said(self.document, i).map_or(0, |s| s.links.len()) {
                let label = || Unchained::Cited(self.document.statements[i].label.clone());
                let theorem = known.get(&(i, link)).ok_or_else(label)?;
                let other = theorem.form.along.as_ref().is_some_and(|along| along.x != x);
                if other || !theorem.form.roots.is_empty() || !theorem.form.slopes.is_empty() {
                    return Err(Unchained::Limits);
                }
                used.push(theorem);
            }
        }
        let forms = || used.iter().map(|t| &t.form).chain([self.form]);
        let mut union: BTreeSet<usize> = forms().flat_map(|f| f.symbols.iter().copied()).collect();
        union.insert(x);
        let mut sides: Vec<Side> = Vec::new();
        for slot in forms().filter_map(|f| f.along.as_ref()).flat_map(|a| &a.slots) {
            if let Slot::Near(side) = slot
                && !sides.contains(side)
            {
                sides.push(side.clone());
            }
        }
        let whole = self.resting();
        let scope = scope(&whole, Fuel::new(u64::MAX)).map_err(NotEmitted::from)?;
        let mut family = Family::new(&scope, &whole, x)?;
        family.symbols = Symbols::of(&self.document.context, union, Vec::new(), Vec::new());
        let setting = Setting::Set { used: sides, point: true };
        let (symbols, written) = (&family.symbols, |v: usize| family.written(v));
        let prose = Prose { name: &written, symbols };
        let says = match &whole.conclusion {
            Conclusion::Link(Link::Limit(l)) => {
                let all = family.claimed(l)?;
                family.tends(&prose, (&all.f, &all.to, &all.sides))?
            }
            _ => family.pointwise(&prose, self.accepted.certificate.finding, &setting)?.1,
        };
        let statement = family.statement(&prose, &says, &setting)?;
        let slots: Vec<Slot> =
            family.supposed(&prose, &setting)?.into_iter().map(|s| s.0).collect();
        let names = symbols.numbered("Premise", slots.len());
        let at = At { place: self, family: &family, slots: &slots, names: &names };
        let when = !goal.when.is_empty() && !family.always_when;
        let (mut premises, mut holes) = (Vec::new(), String::new());
        let mut add = |(term, hole): (String, Option<String>)| {
            premises.push(term);
            hole.iter().for_each(|h| _ = writeln!(holes, "  {{ {h} }}"));
        };
        let (mut intros, mut applied) = (at.symbols(&symbols.order), lemma);
        let _ = write!(intros, " {} {}", family.set(), names.join(" "));
        match &self.form.along {
            Some(form) => {
                let domain = if form.set { family.set() } else { String::new() };
                let _ = write!(applied, " {} {domain}", at.symbols(&self.form.symbols));
                for slot in &form.slots {
                    add(at.premise(slot, self.form, &cited, known)?);
                }
            }
            None => {
                let there = symbols.fresh("When");
                let (here, within, inside) = at.here();
                let _ = write!(intros, " {here} {} {inside}", within.join(" "));
                at.values(&self.form.symbols, true, &mut applied)?;
                for &i in &cited {
                    add(match self.is_given(i) {
                        true => (at.given_at(i)?, None),
                        false => ("_".to_owned(), Some(at.follows_here(i, known)?)),
                    });
                }
                match (goal.when.is_empty(), when) {
                    (true, _) => {}
                    (_, false) => add((at.name(&Slot::When)?, None)),
                    (_, true) => {
                        let _ = write!(intros, " {there}");
                        add((there, None));
                    }
                }
            }
        }
        let proof = format!(
            "Proof. intros {intros}.\n  refine ({applied} {}).\n{holes}Qed.\n",
            premises.join(" "),
        );
        let mut needs: Vec<String> = used.iter().map(|t| t.name.clone()).collect();
        needs.dedup();
        let along =
            Some(Along { x, slots: slots.clone(), set: true, always_when: family.always_when });
        if !self.form.roots.is_empty() || !self.form.slopes.is_empty() {
            return Err(Unchained::Limits);
        }
        let form = Form { symbols: symbols.order.clone(), along, ..self.form.clone() };
        let text = format!("Theorem {name} :\n  {statement}.\n{proof}");
        Ok(Theorem { name, text, needs, form, givens: self.rests_on.to_vec(), when })
    }

    /// The claim, resting on givens alone.
    fn resting(&self) -> Goal {
        let given = |i: &usize| said(self.document, *i);
        let sentences: Vec<Sentence> = self.rests_on.iter().filter_map(given).collect();
        let hypothesis = |sentence| Hypothesis { sentence, given: true };
        let goal = &self.accepted.goal;
        Goal {
            context: self.document.context.clone(),
            hypotheses: sentences.into_iter().map(hypothesis).collect(),
            ..goal.clone()
        }
    }
}

/// Inside the proof of a theorem about functions.
struct At<'a, 'g> {
    place: &'a Place<'a>,
    family: &'a Family<'a, 'g>,
    slots: &'a [Slot],
    names: &'a [String],
}

impl At<'_, '_> {
    /// Constants, then functions.
    fn symbols(&self, symbols: &[usize]) -> String {
        let others = symbols.iter().copied().filter(|v| *v != self.family.x);
        let (constants, functions): (Vec<usize>, Vec<usize>) =
            others.partition(|v| self.family.is_constant(*v));
        let all = constants.iter().chain(&functions).map(|v| self.family.symbols.name(*v));
        all.collect::<Vec<_>>().join(" ")
    }

    fn name(&self, slot: &Slot) -> Result<String, NotEmitted> {
        let place = self.slots.iter().position(|s| s == slot);
        place.map(|i| self.names[i].clone()).ok_or(NotEmitted::Step("a premise of another kind"))
    }

    /// The place of a given among the premises of the theorem.
    fn given(&self, statement: usize) -> Result<usize, NotEmitted> {
        let place = self.place.rests_on.iter().position(|i| *i == statement);
        place.ok_or(NotEmitted::Symbol)
    }

    /// A premise of the lemma: a term, or a hole and the script that fills it.
    fn premise(
        &self,
        slot: &Slot,
        form: &Form,
        cited: &[usize],
        known: &Theorems,
    ) -> Result<(String, Option<String>), Unchained> {
        let (i, again): (usize, fn(usize) -> Slot) = match slot {
            Slot::Functions => return Ok((self.functions(&form.symbols)?, None)),
            Slot::Limit(h, link) => {
                let i = cited[*h];
                if self.place.is_given(i) {
                    return Ok((self.name(&Slot::Limit(self.given(i)?, *link))?, None));
                }
                let theorem = known.get(&(i, *link)).ok_or(Unchained::Limits)?;
                return Ok((format!("({})", self.applied(theorem, None)?), None));
            }
            Slot::Everywhere(h) => (cited[*h], Slot::Everywhere),
            Slot::Part(h) => (cited[*h], Slot::Part),
            Slot::Moving(h) => (cited[*h], Slot::Moving),
            other => return Ok((self.name(other)?, None)),
        };
        if self.place.is_given(i) {
            return Ok((self.name(&again(self.given(i)?))?, None));
        }
        let moving = matches!(slot, Slot::Moving(_));
        Ok(("_".to_owned(), Some(self.follows(i, moving, known)?)))
    }

    /// The declared range of the variable, by names, and what is known of a point.
    fn here(&self) -> (String, Vec<String>, String) {
        let symbols = &self.family.symbols;
        let ends = symbols.range(self.family.x).len();
        (symbols.fresh("here"), symbols.numbered("Within", ends), symbols.fresh("Inside"))
    }

    /// That a cited claim is true where it is defined, at a point of the set or of constants.
    fn follows(&self, i: usize, moving: bool, known: &Theorems) -> Result<String, Unchained> {
        let sentence = said(self.place.document, i).ok_or(NotEmitted::Symbol)?;
        let (here, within, inside) = self.here();
        let mut script = String::new();
        let along = |link| known.get(&(i, link)).is_some_and(|t| t.form.along.is_some());
        let somewhere = !moving && (0..sentence.links.len()).any(along);
        if moving {
            let _ = write!(script, "intros {here} {} {inside}. ", within.join(" "));
        } else if somewhere {
            // What is said of constants at each point of the set holds, since it has points.
            let near = self.slots.iter().position(|s| matches!(s, Slot::Near(_)));
            let (Some(near), []) = (near, &within[..]) else {
                return Err(Unchained::Limits);
            };
            if let Slot::Near(at) = &self.slots[near] {
                let (name, set) = (&self.names[near], self.family.set());
                let point = format!("near_point {} {set} {name}", side(at));
                let _ = write!(script, "destruct ({point}) as [{here} {inside}]. ");
            }
        }
        self.said(&sentence, (i, moving || somewhere), known, &mut script)?;
        Ok(script)
    }

    /// The same at a point that is there already.
    fn follows_here(&self, i: usize, known: &Theorems) -> Result<String, Unchained> {
        let sentence = said(self.place.document, i).ok_or(NotEmitted::Symbol)?;
        let mut script = String::new();
        self.said(&sentence, (i, true), known, &mut script)?;
        Ok(script)
    }

    fn said(
        &self,
        sentence: &Sentence,
        (i, moving): (usize, bool),
        known: &Theorems,
        script: &mut String,
    ) -> Result<(), Unchained> {
        let symbols = &self.family.symbols;
        let written = |v: usize| self.family.written(v);
        let prose = Prose { name: &written, symbols };
        let there = symbols.fresh("There");
        if !sentence.when.is_empty() {
            let _ = write!(script, "intro {there}. ");
        }
        let relations: Vec<(usize, &Relation)> = sentence
            .links
            .iter()
            .enumerate()
            .filter_map(|(link, l)| match l {
                Link::Relation(r) => Some((link, r)),
                Link::Limit(_) => None,
            })
            .collect();
        for (n, (link, r)) in relations.iter().enumerate() {
            let r: Relation = symbols.expanded([*r])?.remove(0);
            if !prose.defined(&r)?.is_empty() {
                script.push_str("intros _. ");
            }
            let theorem = known.get(&(i, *link)).ok_or(Unchained::Limits)?;
            let when = (!sentence.when.is_empty()).then_some(there.as_str());
            let applied = self.applied(theorem, Some((moving, when)))?;
            match n + 1 == relations.len() {
                true => _ = write!(script, "ends ({applied})."),
                false => _ = write!(script, "split. {{ ends ({applied}). }} "),
            }
        }
        Ok(())
    }

    /// A theorem applied: as a whole, or at a point of the set or of constants, under conditions.
    fn applied(
        &self,
        theorem: &Theorem,
        at: Option<(bool, Option<&str>)>,
    ) -> Result<String, Unchained> {
        let (form, mut out) = (&theorem.form, theorem.name.clone());
        let (here, within, inside) = self.here();
        let point = format!("{here} {}", within.join(" "));
        let when = at.and_then(|(_, when)| when).unwrap_or_default();
        let Some(along) = &form.along else {
            let (moving, _) = at.ok_or(Unchained::Limits)?;
            self.at_point(theorem, moving, &mut out)?;
            let _ = write!(out, " {}", if theorem.when { when } else { "" });
            return Ok(out);
        };
        let _ = write!(out, " {}", self.symbols(&form.symbols));
        if along.set {
            let _ = write!(out, " {}", self.family.set());
        }
        for slot in &along.slots {
            let renamed = |i: &usize| self.given(theorem.givens[*i]);
            let term = match slot {
                Slot::Functions => self.functions(&form.symbols)?,
                Slot::When => when.to_owned(),
                Slot::Everywhere(i) => self.name(&Slot::Everywhere(renamed(i)?))?,
                Slot::Part(i) => self.name(&Slot::Part(renamed(i)?))?,
                Slot::Moving(i) => self.name(&Slot::Moving(renamed(i)?))?,
                Slot::Limit(i, link) => self.name(&Slot::Limit(renamed(i)?, *link))?,
                other => self.name(other)?,
            };
            let _ = write!(out, " {term}");
        }
        if let Some((moving, _)) = at {
            if !moving {
                return Err(Unchained::Limits);
            }
            let set = if along.set { inside.as_str() } else { "" };
            let _ = write!(out, " {point} {set} {}", if theorem.when { when } else { "" });
        }
        Ok(out)
    }

    /// The arguments of a theorem about points, at a point of the set or for constants alone.
    fn at_point(&self, theorem: &Theorem, moving: bool, out: &mut String) -> Result<(), Unchained> {
        self.values(&theorem.form.symbols, moving, out)?;
        for i in &theorem.givens {
            let _ = write!(out, " {}", self.given_at(*i)?);
        }
        Ok(())
    }

    /// What a given says at a point of the set.
    fn given_at(&self, statement: usize) -> Result<String, NotEmitted> {
        let (i, (here, within, inside)) = (self.given(statement)?, self.here());
        match self.name(&Slot::Everywhere(i)) {
            Ok(name) => Ok(name),
            Err(_) => {
                let name = self.name(&Slot::Moving(i))?;
                Ok(format!("({name} {here} {} {inside})", within.join(" ")))
            }
        }
    }

    /// The values of symbols at a point of the set, or of constants alone, and their ranges.
    fn values(&self, of: &[usize], moving: bool, out: &mut String) -> Result<(), Unchained> {
        let (symbols, x) = (&self.family.symbols, self.family.x);
        let (here, within, _) = self.here();
        let point = format!("{here} {}", within.join(" "));
        let constant = |v: usize| self.family.is_constant(v);
        if !moving && !of.iter().all(|v| constant(*v)) {
            return Err(Unchained::Limits);
        }
        for &v in of {
            let name = symbols.name(v);
            let _ = match (constant(v), v == x) {
                (true, _) => write!(out, " {name}"),
                (_, true) => write!(out, " {here}"),
                _ => write!(out, " ({name} {here})"),
            };
        }
        for &v in of {
            for (end, _) in symbols.range(v).iter().enumerate() {
                let term = match (constant(v), v == x) {
                    (true, _) => self.name(&Slot::Range(v, end))?,
                    (_, true) => within[end].clone(),
                    _ => self.function_range(v, end, &point)?,
                };
                let _ = write!(out, " {term}");
            }
        }
        Ok(())
    }

    /// The ends of the declared ranges of functions, in order.
    fn ends(&self, symbols: &[usize]) -> Vec<(usize, usize)> {
        let of_x = |v: &&usize| **v != self.family.x && !self.family.is_constant(**v);
        let functions = symbols.iter().filter(of_x);
        functions
            .flat_map(|v| (0..self.family.symbols.range(*v).len()).map(|end| (*v, end)))
            .collect()
    }

    /// An end of the range of a function at a point.
    fn function_range(&self, v: usize, end: usize, point: &str) -> Result<String, NotEmitted> {
        let all = self.ends(&self.family.symbols.order);
        let place = all.iter().position(|e| *e == (v, end)).ok_or(NotEmitted::Symbol)?;
        let whole = format!("({} {point})", self.name(&Slot::Functions)?);
        let rest = (0..place).fold(whole, |term, _| format!("(proj2 {term})"));
        Ok(if place + 1 == all.len() { rest } else { format!("(proj1 {rest})") })
    }

    /// The ranges of some functions, from those of all.
    fn functions(&self, symbols: &[usize]) -> Result<String, NotEmitted> {
        let (here, within, _) = self.here();
        let point = format!("{here} {}", within.join(" "));
        let mut terms = Vec::new();
        for (v, end) in self.ends(symbols) {
            terms.push(self.function_range(v, end, &point)?);
        }
        let last = terms.pop().ok_or(NotEmitted::Symbol)?;
        let all = terms.into_iter().rfold(last, |rest, one| format!("(Logic.conj {one} {rest})"));
        Ok(format!("(fun {point} => {all})"))
    }
}
