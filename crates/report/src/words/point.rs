//! A witness: a point, and what every statement says there in numbers.

use kane_audit::{Assignment, Comparison, Measured, Said, Speaker};
use kane_kernel::Expr;

use super::lines::Sentence;
use super::teller::Teller;
use super::value::{assigned, in_numbers, measured};

/// Relations of givens that are not cited of which it is told what they say.
const MOST_BESIDE: usize = 12;

impl Teller<'_> {
    /// The values, those of definitions, and a line for each relation of a statement.
    pub(super) fn point(
        &mut self,
        depth: usize,
        values: &[Assignment],
        definitions: &[(usize, Measured)],
        said: &[Said],
    ) {
        let pen = &self.pen;
        let one = |i: usize| pen.write(|f| assigned(f, &values[i..=i]).concat());
        let at = match values.len() {
            0 => Sentence::of("At every point"),
            count => {
                Sentence::of("At the point").and(Sentence::list((0..count).map(one).collect()))
            }
        };
        let one = |(i, value): &(usize, Measured)| {
            let told = pen.write(|f| {
                let name = f.expr(&Expr::Let(*i));
                match value {
                    Measured::None(_) => format!("{name} is {}", measured(f, value)),
                    value => f.compared(&name, "=", &measured(f, value)),
                }
            });
            match value {
                Measured::None(why) if !why.is_undefined() => None,
                _ => Some(told),
            }
        };
        let defined: Vec<_> = definitions.iter().filter_map(one).collect();
        let nothing_defined = defined.is_empty();
        let defined = Sentence::list(defined);
        let at = match nothing_defined {
            true => at,
            false => at.end(",").and(Sentence::of("where")).and(defined),
        };
        self.say(depth, at.end(":"));
        self.all_said(depth + 1, said);
    }

    /// Whether all givens that are not cited hold there, or which of them fail, and a line for each relation.
    pub(super) fn beside(&mut self, depth: usize, all: bool, values: &[Assignment], said: &[Said]) {
        let lead = match all {
            true => "All else that is assumed above holds there too",
            false => "What is assumed above and not cited fails there",
        };
        let one = |i: usize| self.pen.write(|f| assigned(f, &values[i..=i]).concat());
        let lead = match values.len() {
            0 => Sentence::of(lead),
            count => {
                let values = Sentence::list((0..count).map(one).collect());
                Sentence::of(lead).end(",").and(Sentence::of("with")).and(values)
            }
        };
        self.say(depth, lead.end(":"));
        let told = said.len().min(MOST_BESIDE);
        self.all_said(depth + 1, &said[..told]);
        if said.len() > told {
            let more = format!("and {} more", said.len() - told);
            self.say(depth + 1, Sentence::of(&more).end("."));
        }
    }

    /// A line for each relation of a statement.
    fn all_said(&mut self, depth: usize, said: &[Said]) {
        for said in said {
            let label = match said.of {
                Speaker::Hypothesis(h) | Speaker::Idle(h) => match self.labels.get(h) {
                    Some(label) => Some(*label),
                    // a given behind the cited claims
                    None => continue,
                },
                Speaker::Condition | Speaker::Claim => None,
            };
            let told = self.said(label, said);
            self.say(depth, told);
        }
    }

    /// `(4), v_y = -e*v_y0: 0 = 0`
    fn said(&self, label: Option<&str>, said: &Said) -> Sentence {
        let whose = self.pen.write(|f| match (label, said.of) {
            (Some(label), _) => f.words(label),
            (None, Speaker::Condition) => "the condition".to_owned(),
            (None, _) => "the claim".to_owned(),
        });
        let says = self.pen.write(|f| f.relation(&said.relation));
        let numbers = self.pen.write(|f| match &said.comparison {
            Comparison::Truth(true) => "true".to_owned(),
            Comparison::Truth(false) => "false".to_owned(),
            told => in_numbers(f, &said.relation, told),
        });
        let whose = match said.of {
            Speaker::Idle(_) => whose.and(Sentence::of("says nothing there, since")),
            _ => whose.end(","),
        };
        let told = whose.and(says).end(":").and(numbers);
        if said.parts.is_empty() {
            return told;
        }
        let part = |i: usize| {
            let (relation, comparison) = &said.parts[i];
            self.pen.write(|f| {
                format!("{} is {}", f.relation(relation), in_numbers(f, relation, comparison))
            })
        };
        let parts = Sentence::list((0..said.parts.len()).map(part).collect());
        told.end(";").and(parts)
    }
}
