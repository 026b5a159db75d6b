//! Cases: what is excluded at once is said in a line, and if one case is left, the proof goes on in it.

use kane_audit::{Source, Step};
use kane_kernel::{Atom, Poly};

use super::lines::Sentence;
use super::teller::{Branch, Teller};

impl Teller<'_> {
    /// Cases of an assumption.
    pub(super) fn cases(&mut self, depth: usize, source: Source, branches: Vec<Branch<'_>>) {
        let mut briefs: Vec<Option<Sentence>> =
            branches.iter().map(|branch| self.brief(branch.then)).collect();
        let open = |briefs: &[Option<Sentence>]| briefs.iter().filter(|b| b.is_none()).count();
        if open(&briefs) == 0 {
            // the longest is what the proof is about
            let letters = |b: &Option<Sentence>| b.as_ref().map_or(0, Sentence::letters);
            let longest = (0..briefs.len()).rev().max_by_key(|i| letters(&briefs[*i]));
            longest.into_iter().for_each(|i| briefs[i] = None);
        }
        let alone = open(&briefs) == 1;
        let head = (!alone).then(|| {
            let count = match branches.len() {
                0 => "in no case.".to_owned(),
                n => format!("one of {n} cases."),
            };
            self.source(source).end(":").begun().and(Sentence::of(&count))
        });
        let closed = branches.iter().zip(&briefs);
        let closed = closed.filter_map(|(branch, brief)| Some((branch, brief.as_ref()?)));
        self.excluded(depth, head, closed);
        let open = branches.iter().zip(&briefs).filter(|(_, brief)| brief.is_none());
        for (number, (branch, _)) in open.enumerate() {
            if alone {
                let what = Step::Assume { source, atoms: branch.atoms.clone() };
                let first = (!branch.atoms.is_empty()).then_some(what);
                let steps: Vec<Step> =
                    first.into_iter().chain(branch.then.iter().cloned()).collect();
                self.all(depth, &steps);
            } else {
                let case = Sentence::of(&format!("Case {}:", number + 1));
                self.say(depth + 1, case.and(self.atoms(&branch.atoms)).end("."));
                self.all(depth + 2, branch.then);
            }
        }
    }

    /// What is excluded at once: in one sentence where another condition alone does it, else a line each.
    fn excluded<'b>(
        &mut self,
        depth: usize,
        head: Option<Sentence>,
        closed: impl Iterator<Item = (&'b Branch<'b>, &'b Sentence)>,
    ) {
        let (mut together, mut apart): (Vec<Sentence>, Vec<Sentence>) = (Vec::new(), Vec::new());
        // a case that contradicts itself is none
        for (branch, brief) in closed.filter(|(branch, _)| !contradicts_itself(branch)) {
            let (all, told) = match self.by_others(branch) {
                Some(told) => (&mut together, told),
                None => (&mut apart, self.atoms(&branch.atoms).end(":").and(brief.clone())),
            };
            if !all.contains(&told) {
                all.push(told);
            }
        }
        let excluded = |told| Sentence::of("Excluded:").and(told);
        let together =
            (!together.is_empty()).then(|| excluded(Sentence::joined(together, ";").end(".")));
        let inner = depth + usize::from(head.is_some());
        match (head, together) {
            (Some(head), Some(together)) => self.say(depth, head.and(together)),
            (one, other) => one.into_iter().chain(other).for_each(|told| self.say(depth, told)),
        }
        for told in apart {
            self.say(inner, excluded(told));
        }
    }

    /// `alpha = 0 by alpha > 0`: what a branch assumes against other conditions.
    fn by_others(&self, branch: &Branch<'_>) -> Option<Sentence> {
        let [step] = branch.then else { return None };
        let others: Vec<Atom> = match step {
            Step::Factors { atom, factors } if branch.atoms.contains(atom) => {
                factors.iter().map(|f| f.0.clone()).collect()
            }
            Step::Clash(atoms) => {
                atoms.iter().filter(|atom| !branch.atoms.contains(atom)).cloned().collect()
            }
            Step::SignsOfCoefficients { atom, bounds, ranges: false, sum: None }
                if branch.atoms.contains(atom) =>
            {
                bounds.clone()
            }
            _ => return None,
        };
        let what = self.atoms(&branch.atoms);
        let others: Vec<&Atom> = others.iter().filter(|a| !branch.atoms.contains(a)).collect();
        if others.is_empty() {
            return None;
        }
        Some(what.and(Sentence::of("by")).and(self.against(others.into_iter())))
    }

    /// Cases by the sign of a polynomial.
    pub(super) fn signs(
        &mut self,
        depth: usize,
        poly: &Poly,
        [zero, positive, negative]: [&Vec<Step>; 3],
    ) {
        // the sign of −x is told as that of x
        let is_opposite = self.pen.plain.poly(poly).starts_with('-');
        let (poly, positive, negative) = match is_opposite {
            true => (&poly.neg(), negative, positive),
            false => (poly, positive, negative),
        };
        let mut groups: Vec<(Vec<&str>, &Vec<Step>)> = Vec::new();
        for (sign, then) in [("=", zero), (">", positive), ("<", negative)] {
            match groups.iter_mut().find(|(_, known)| self.is_told_as(known, then)) {
                Some((signs, _)) => signs.push(sign),
                None => groups.push((vec![sign], then)),
            }
        }
        let briefs: Vec<Option<Sentence>> =
            groups.iter().map(|(_, then)| self.brief(then)).collect();
        let open = briefs.iter().filter(|b| b.is_none()).count();
        if open > 1 {
            let told = self.pen.write(|f| format!("Distinguish the sign of {}:", f.poly(poly)));
            self.say(depth, told);
        }
        let closed = groups.iter().zip(&briefs).filter(|(_, brief)| brief.is_some());
        let plainly = closed.map(|((_, then), _)| then.as_slice()).all(is_plain);
        if let (1, true, Some(at)) = (open, plainly, briefs.iter().position(Option::is_none)) {
            let (signs, then) = &groups[at];
            let why = "by the ranges of its symbols or what is said of it.";
            let left = Sentence::of("There is left").and(self.sign(poly, signs)).end(",");
            self.say(depth, left.and(Sentence::of(why)));
            return self.all(depth, then);
        }
        let inner = if open > 1 { depth + 1 } else { depth };
        for ((signs, _), brief) in groups.iter().zip(&briefs) {
            if let Some(brief) = brief {
                let case = self.sign(poly, signs).end(",");
                self.say(inner, Sentence::of("If").and(case).and(brief.clone()));
            }
        }
        for ((signs, then), _) in groups.iter().zip(&briefs).filter(|(_, brief)| brief.is_none()) {
            let what = if open > 1 { "Case" } else { "There is left" };
            self.say(inner, Sentence::of(what).and(self.sign(poly, signs)).end("."));
            self.all(if open > 1 { depth + 2 } else { depth }, then);
        }
    }

    fn sign(&self, poly: &Poly, signs: &[&str]) -> Sentence {
        let sign = match signs {
            ["=", ">"] => ">=",
            ["=", "<"] => "<=",
            [">", "<"] => "!=",
            [one] => one,
            _ => return Sentence::of("whatever its sign"),
        };
        self.pen.write(|f| f.against_zero(poly, sign))
    }

    /// Whether two branches are told in the same words.
    fn is_told_as(&self, a: &[Step], b: &[Step]) -> bool {
        a == b
            || are_alike(a, b)
                && steps(a) + steps(b) <= MOST_COMPARED
                && self.told(a) == self.told(b)
    }
}

/// Whether a sign contradicts the ranges of the symbols, all terms having the other, or another condition on the same polynomial.
fn is_plain(then: &[Step]) -> bool {
    match then {
        [Step::SignsOfCoefficients { bounds, sum: None, .. }] => bounds.is_empty(),
        [Step::Clash(_)] => true,
        _ => false,
    }
}

/// Whether what a branch assumes is all that is needed against it, and needs no argument.
fn contradicts_itself(branch: &Branch<'_>) -> bool {
    let [step] = branch.then else { return false };
    let clash: Vec<&Atom> = match step {
        Step::Clash(atoms) => atoms.iter().collect(),
        Step::Factors { atom, factors } => {
            std::iter::once(atom).chain(factors.iter().map(|f| &f.0)).collect()
        }
        _ => return false,
    };
    clash.iter().all(|atom| branch.atoms.contains(atom))
}

/// Steps of two branches of which it is asked whether they read alike.
const MOST_COMPARED: usize = 24;

/// Whether steps are of the same kinds: others do not read alike, and what is nested is told once more to compare it.
fn are_alike(a: &[Step], b: &[Step]) -> bool {
    let kind = std::mem::discriminant::<Step>;
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| kind(a) == kind(b))
}

/// Steps, with those inside them.
fn steps(all: &[Step]) -> usize {
    let inner = |step: &Step| match step {
        Step::Cases { cases, .. } => cases.iter().map(|(_, then)| steps(then)).sum(),
        Step::Split { zero, positive, negative, .. } => {
            [zero, positive, negative].into_iter().map(|then| steps(then)).sum()
        }
        _ => 0,
    };
    all.iter().map(|step| 1 + inner(step)).sum()
}
