//! What is shown of an audit.

use kane_algebra::syntax::{Notation as _, latex_name, surface, visible};
use kane_audit::{
    Audit, Beside, Body, Claim, Content, Judgement, LinkJudgement, Proof, Statement, Variable,
    Verdict,
};
use kane_judges::Judge;
use kane_kernel::{Conclusion, Context, Goal, Link, Sentence};

use crate::origin::Origin;
use crate::place::Place;
use crate::words::{self, Form, Formulas, Line, Subject};

/// An audit, the statements of it that are shown, and the command that shows them again.
#[derive(Clone, Debug)]
pub struct Report<'a> {
    /// the judged document
    pub audit: &'a Audit,
    /// indices of the statements that are shown, ascending
    pub shown: Vec<usize>,
    /// a command that prints this report
    pub command: String,
    /// pictures that belong to the document, for the forms that can show them
    pub pictures: &'a [Picture],
    /// other judges that were asked, or should have been
    pub judges: &'a [Judge],
    /// where to read on, in a sentence without its full stop
    pub pointer: Option<&'a str>,
    /// what is beside its page
    pub place: Place,
}

/// A picture that belongs to a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Picture {
    /// what it shows, for those who do not see it
    pub title: &'static str,
    /// the picture itself, one `svg` element
    pub svg: &'static str,
}

impl<'a> Report<'a> {
    /// A report of every statement.
    #[must_use]
    pub fn new(audit: &'a Audit, command: impl Into<String>) -> Self {
        Self {
            audit,
            shown: (0..audit.document.statements.len()).collect(),
            command: visible(&command.into()).into_owned(),
            pictures: &[],
            judges: &[],
            pointer: None,
            place: Place::default(),
        }
    }

    /// The same report with where to read on, for its text.
    #[must_use]
    pub const fn with_pointer(mut self, pointer: &'a str) -> Self {
        self.pointer = Some(pointer);
        self
    }

    /// The same report with links to what is beside its page.
    #[must_use]
    pub fn placed(mut self, place: Place) -> Self {
        self.place = place;
        self
    }

    /// The same report with pictures.
    #[must_use]
    pub const fn with_pictures(mut self, pictures: &'a [Picture]) -> Self {
        self.pictures = pictures;
        self
    }

    /// The same report with the answers of other judges.
    #[must_use]
    pub const fn with_judges(mut self, judges: &'a [Judge]) -> Self {
        self.judges = judges;
        self
    }

    /// The same report, narrowed to these statements.
    #[must_use]
    pub fn only(mut self, indices: &[usize]) -> Self {
        self.shown.retain(|index| indices.contains(index));
        self
    }

    /// Whether every statement that is shown ends as its author expects.
    #[must_use]
    pub fn as_expected(&self) -> bool {
        self.entries().all(|entry| entry.judgement.as_expected())
    }

    /// The statements that are shown, with their judgements.
    pub(crate) fn entries(&self) -> impl Iterator<Item = Entry<'a>> + '_ {
        let audit = self.audit;
        self.shown.iter().filter_map(move |&index| Entry::new(audit, index))
    }
}

/// One statement and its judgement.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Entry<'a> {
    audit: &'a Audit,
    index: usize,
    pub(crate) statement: &'a Statement,
    pub(crate) judgement: &'a Judgement,
}

impl<'a> Entry<'a> {
    /// The entry at `index`, if the audit has one.
    pub(crate) fn new(audit: &'a Audit, index: usize) -> Option<Self> {
        let statement = audit.document.statements.get(index)?;
        let judgement = audit.judgements.get(index)?;
        Some(Self { audit, index, statement, judgement })
    }

    /// `let`, `given` or `claim`.
    pub(crate) fn kind(&self) -> &'static str {
        match self.statement.body {
            Body::Let(_) | Body::Defined(_) => "let",
            Body::Given(_) => "given",
            Body::Claim(_) => "claim",
        }
    }

    /// The symbols and definitions of the document.
    pub(crate) fn context(&self) -> &'a Context {
        &self.audit.document.context
    }

    pub(crate) fn is_claim(&self) -> bool {
        matches!(self.statement.body, Body::Claim(_))
    }

    /// Whether it is claimed under conditions that might be met nowhere.
    pub(crate) fn supposes(&self) -> bool {
        let document = &self.audit.document;
        let has_premise = self.judgement.hypotheses.iter().any(|i| !document.is_convention(*i));
        has_premise || self.claim().is_none_or(|claim| !claim.when.is_empty())
    }

    /// Whether it says that the premises contradict each other.
    pub(crate) fn is_contradiction(&self) -> bool {
        matches!(self.claim(), Some(claim) if matches!(claim.content, Content::Contradiction))
    }

    /// Whether the label is a number in parentheses: an equation of the text under audit.
    pub(crate) fn is_equation(&self) -> bool {
        self.origin() == Origin::Printed
    }

    /// Who says it: the text under audit in an equation or in words, or its auditor.
    pub(crate) fn origin(&self) -> Origin {
        let is_definition = matches!(self.statement.body, Body::Let(_) | Body::Defined(_));
        Origin::of(&self.statement.label, is_definition)
    }

    /// The statement as written, on one line and without comments.
    pub(crate) fn source(&self) -> String {
        let source = self.audit.document.on_one_line(self.statement.span.clone());
        if source.is_empty() { self.saying() } else { source }
    }

    /// What the statement says as written: without its kind and label, and without what it cites and expects.
    ///
    /// What the language says of an exponential is written nowhere, and is what it says.
    pub(crate) fn saying(&self) -> String {
        let document = &self.audit.document;
        let said = document.on_one_line(self.statement.parts.saying());
        match &self.statement.body {
            Body::Given(sentence) if said.is_empty() => {
                let relations: Vec<_> = sentence.relations().cloned().collect();
                Formulas::new(Form::Plain, &document.context, &[]).relations(&relations)
            }
            _ => said,
        }
    }

    /// The claim, if it is one.
    pub(crate) fn claim(&self) -> Option<&'a Claim> {
        match &self.statement.body {
            Body::Claim(claim) => Some(claim),
            Body::Let(_) | Body::Defined(_) | Body::Given(_) => None,
        }
    }

    /// The statements that it names, in their order: those that it cites, and the one that it says does not follow.
    pub(crate) fn premises(&self) -> Vec<usize> {
        let Some(claim) = self.claim() else { return Vec::new() };
        let mut premises = claim.from.clone();
        premises.extend(self.denied());
        premises.sort_unstable();
        premises.dedup();
        premises
    }

    /// The statement that a `not implied` is about.
    pub(crate) fn denied(&self) -> Option<usize> {
        match self.claim()?.content {
            Content::NotImplied(index) => Some(index),
            Content::Links(_) | Content::Contradiction | Content::Sought(_) => None,
        }
    }

    /// What it says in LaTeX, as its author wrote it, and its conditions; `None` for what is said in words.
    pub(crate) fn said(&self) -> Option<(String, Option<String>)> {
        self.surface().or_else(|| self.written_out())
    }

    /// What is judged instead of what is said, where vectors, functions and angles are written out.
    pub(crate) fn judged(
        &self,
        said: &(String, Option<String>),
    ) -> Option<(String, Option<String>)> {
        self.written_out().filter(|judged| judged != said)
    }

    fn surface(&self) -> Option<(String, Option<String>)> {
        let document = &self.audit.document;
        let is_own = |name: &str| {
            document.statements.iter().any(|statement| {
                let is_definition = matches!(statement.body, Body::Let(_) | Body::Defined(_));
                let said = is_definition.then(|| document.on_one_line(statement.parts.saying()));
                let behind = said.as_deref().and_then(|said| said.strip_prefix(name));
                behind.is_some_and(|behind| behind.trim_start().starts_with('('))
            })
        };
        surface(&self.saying(), self.context(), &is_own)
    }

    fn written_out(&self) -> Option<(String, Option<String>)> {
        let context = self.context();
        let (links, when) = match &self.statement.body {
            Body::Let(index) => return Some((self.definition(*index)?, None)),
            Body::Defined(parts) if parts.is_empty() => return None,
            Body::Defined(parts) => {
                let parts: Option<Vec<_>> = parts.iter().map(|i| self.definition(*i)).collect();
                return Some((parts?.join(",\\; "), None));
            }
            Body::Given(sentence) => (sentence.links.clone(), &sentence.when),
            Body::Claim(claim) => match &claim.content {
                Content::Links(links) => {
                    (links.iter().map(|(link, _)| link.clone()).collect(), &claim.when)
                }
                Content::Contradiction | Content::NotImplied(_) | Content::Sought(_) => {
                    return None;
                }
            },
        };
        let document = &self.audit.document;
        let written = when.iter().map(|r| document.relation_as_written(r)).collect::<Vec<_>>();
        let when = (!when.is_empty()).then(|| written[..].latex(context));
        let links: Vec<Link> = links.iter().map(|link| document.link_as_written(link)).collect();
        let said = Sentence { when: Vec::new(), links };
        (!said.links.is_empty()).then(|| (said.latex(context), when))
    }

    /// A definition in LaTeX.
    fn definition(&self, index: usize) -> Option<String> {
        let context = self.context();
        let definition = context.lets.get(index)?;
        let (name, body) = (
            latex_name(&definition.name),
            self.audit.document.as_written(&definition.body).latex(context),
        );
        Some(format!("{name} := {body}"))
    }

    /// The whole statement in LaTeX; `None` for what is said in words.
    pub(crate) fn formula(&self) -> Option<String> {
        let (said, when) = self.said()?;
        Some(match when {
            Some(when) => format!("{said} \\quad\\text{{when }} {when}"),
            None => said,
        })
    }

    /// Labels of the statements at these indices.
    pub(crate) fn labels(&self, indices: &[usize]) -> Vec<&'a str> {
        let statements = &self.audit.document.statements;
        indices
            .iter()
            .filter_map(|&index| statements.get(index))
            .map(|s| s.label.as_str())
            .collect()
    }

    /// The entries at these indices.
    pub(crate) fn cited(&self, indices: &[usize]) -> Vec<Self> {
        indices.iter().filter_map(|&index| Self::new(self.audit, index)).collect()
    }

    /// The first of the worst links.
    pub(crate) fn decisive(&self) -> Option<(usize, &'a LinkJudgement)> {
        let worst = self.judgement.links.iter().map(|link| link.verdict).max()?;
        self.judgement.links.iter().enumerate().find(|(_, link)| link.verdict == worst)
    }

    /// Why the verdict is what it is, in the words of the first of the worst links.
    pub(crate) fn decisive_reason(&self, form: Form) -> Option<String> {
        let links = &self.judgement.links;
        self.decisive().map(|(index, link)| {
            let reason = self.reason(link, form);
            match links.len() {
                1 => reason,
                n if links.iter().all(|other| other.verdict == link.verdict) => {
                    format!("{n} links: {reason}")
                }
                n => match self.claim().and_then(|c| self.audit.document.stage(c, index)) {
                    Some(stage) => format!("{}: {reason}", words::words(&stage, form)),
                    None => format!("link {} of {n}: {reason}", index + 1),
                },
            }
        })
    }

    /// Why the verdict on a link is what it is.
    pub(crate) fn reason(&self, link: &LinkJudgement, form: Form) -> String {
        let label = |index: usize| self.labels(&[index]).concat();
        let mut reason = words::reason(link, self.context(), &label, form);
        if link.verdict != Verdict::Proved
            && let Some(claim) = self.claim()
            && let Some(place) =
                self.judgement.links.iter().position(|other| std::ptr::eq(other, link))
            && let Some((constants, along)) = self.audit.document.constants_along(claim, place)
        {
            reason.push_str("; ");
            reason.push_str(&words::nothing_varies(&constants, along, self.context(), form));
        }
        match self.claim().and_then(|claim| words::found(claim, self.context(), form)) {
            Some(found) => format!("{found}{reason}"),
            None => reason,
        }
    }

    /// The proof or the witness of a link, line by line.
    pub(crate) fn steps(&self, link: &LinkJudgement, form: Form) -> Vec<Line> {
        let Some(accepted) = link.accepted.as_deref() else { return Vec::new() };
        let labels = self.labels(&self.judgement.hypotheses);
        let goal = &accepted.goal;
        let mut lines = Subject { goal, labels: &labels }.steps(&link.steps(), form);
        if let Some(beside) = &link.beside {
            lines.extend(self.beside(beside, goal, form));
        }
        lines
    }

    /// What the givens that are not cited say at the witness of a goal.
    fn beside(&self, beside: &Beside, goal: &Goal, form: Form) -> Vec<Line> {
        let document = &self.audit.document;
        let (context, hypotheses) = (document.context.clone(), Vec::new());
        let (behind, when, conclusion) = (Vec::new(), Vec::new(), Conclusion::Contradiction);
        let of = Goal { context, hypotheses, behind, when, conclusion };
        let labels = self.labels(&beside.givens);
        let variables = (0..of.context.vars.len()).map(Variable::Symbol).collect();
        let proof = Proof { variables, steps: vec![beside.step(document, goal)] };
        Subject { goal: &of, labels: &labels }.steps(&proof, form)
    }

    /// What a link of the claim says, in the notation of documents.
    pub(crate) fn link_text(&self, link: usize) -> String {
        self.audit.document.link(self.index, link)
    }

    /// What a link of the claim says, in LaTeX.
    pub(crate) fn link_latex(&self, index: usize) -> String {
        match self.claim().map(|claim| &claim.content) {
            Some(Content::Links(links)) => {
                let link = links.get(index % links.len().max(1));
                link.map_or_else(String::new, |(link, _)| {
                    self.audit.document.link_as_written(link).latex(self.context())
                })
            }
            Some(Content::Contradiction) => "\\text{contradiction}".to_owned(),
            Some(Content::Sought(_)) => {
                format!("\\text{{{}}}", words::words(&self.link_text(index), Form::Latex))
            }
            Some(Content::NotImplied(denied)) => {
                format!("\\text{{not implied }}{}", self.labels(&[*denied]).concat())
            }
            None => String::new(),
        }
    }

    /// Whether the statement, or one link of it, is refuted.
    pub(crate) fn is_refuted(&self) -> bool {
        let refuted = |verdict| verdict == Verdict::Refuted;
        refuted(self.judgement.verdict)
            || self.judgement.links.iter().any(|link| refuted(link.verdict))
    }

    /// How the verdict stands to what the author expects; `None` where that goes without saying.
    pub(crate) fn expectation(&self) -> Option<String> {
        match self.judgement.expect {
            // only a claim can surprise
            _ if !self.is_claim() => None,
            Some(Verdict::Proved) | None if self.judgement.as_expected() => None,
            // where nothing is written, the verdict alone says that it is not proved
            None => None,
            Some(_) if self.judgement.as_expected() => Some("expected".to_owned()),
            Some(expect) => Some(format!("NOT EXPECTED (should be {expect})")),
        }
    }

    /// Why it is unsupported, and what it would be otherwise.
    pub(crate) fn support(&self) -> Option<String> {
        (self.judgement.verdict == Verdict::Unsupported).then(|| {
            let cited = self.labels(&self.judgement.unproved).join(", ");
            format!("cites {cited}, not proved; else {}", self.judgement.conditional)
        })
    }
}

#[cfg(test)]
mod tests {
    use kane_audit::{Options, audit, read};

    use super::*;

    #[test]
    fn what_nothing_was_found_for_is_shown_as_it_is_written() {
        let text = b"```kane\nvar x\nclaim c: exists m: m > x, m < x expect undecided\n```\n";
        let document = read("found.md", text).expect("it is well formed");
        let audit = audit(document, &Options::default(), &mut |_, _| {});
        let report = Report::new(&audit, "kane audit found.md");
        for page in [crate::html(&report), crate::latex(&report), crate::markdown(&report)] {
            assert!(!page.contains("contradict"), "{page}");
            let plain =
                page.replace("&gt;", ">").replace("\\textgreater{}", ">").replace("$>$", ">");
            let said = ["exists m: m > x", "\\exists\\, m:\\; m > x,\\; m < x"];
            assert!(said.iter().any(|said| plain.contains(said)), "{page}");
        }
    }

    fn judged(statements: &str) -> Audit {
        let text = format!("```kane\n{statements}\n```\n");
        let document = read("report.md", text.as_bytes()).expect("it is well formed");
        audit(document, &Options::default(), &mut |_, _| {})
    }

    #[test]
    fn what_does_not_end_as_it_is_expected_is_said_not_to() {
        let audit = judged(
            "var x\ngiven g: x > 1\nclaim a: x^2 >= 0\nclaim b: x^2 >= 0 expect proved\n\
             claim c: x^2 >= 0 expect refuted\nclaim d: x > 5\nclaim e: x > 5 expect refuted\n\
             claim f: x > 5 expect proved",
        );
        let report = Report::new(&audit, "kane audit report.md");
        let told: Vec<(&str, Option<String>)> =
            report.entries().map(|e| (e.statement.label.as_str(), e.expectation())).collect();
        let some = |text: &str| Some(text.to_owned());
        assert_eq!(
            told,
            [
                ("g", None),
                ("a", None),
                ("b", None),
                ("c", some("NOT EXPECTED (should be refuted)")),
                ("d", None),
                ("e", some("expected")),
                ("f", some("NOT EXPECTED (should be proved)")),
            ]
        );
        assert!(!report.as_expected());
        // these are
        for shown in [0, 1, 2, 5] {
            assert!(report.clone().only(&[shown]).as_expected());
        }
        for shown in [3, 4, 6] {
            assert!(!report.clone().only(&[shown]).as_expected());
        }
    }

    #[test]
    fn a_statement_is_refuted_if_one_link_of_it_is_whatever_becomes_of_the_others() {
        let audit = judged(
            "var x\nclaim (1): x > 0, x/(x - x) = 1 expect ill-defined\n\
             claim (2): x/(x - x) = 1 expect ill-defined\nclaim (3): x > 0, x^2 >= 0 expect refuted\n\
             claim (4): x^2 >= 0",
        );
        let refuted: Vec<bool> =
            Report::new(&audit, "kane audit").entries().map(|e| e.is_refuted()).collect();
        assert_eq!(audit.judgements[0].verdict, Verdict::IllDefined);
        assert_eq!(refuted, [true, false, true, false]);
    }

    #[test]
    fn a_claim_supposes_something_if_it_has_premises_or_conditions() {
        let audit = judged(
            "var x\ngiven g: x > 1\nclaim a: x^2 >= 0\nclaim b: x > 0 when x > 2\n\
             claim c: x > 0 from g\ngiven h: x < 0\nclaim d: contradiction from g, h\n\
             claim e: not implied h from g",
        );
        let report = Report::new(&audit, "kane audit");
        let of = |label: &str| {
            let found = report.entries().find(|e| e.statement.label == label);
            found.expect("it is there")
        };
        assert_eq!(["a", "b", "c", "d"].map(|l| of(l).supposes()), [false, true, true, true]);
        let contradictions = ["a", "b", "c", "d", "e"].map(|l| of(l).is_contradiction());
        assert_eq!(contradictions, [false, false, false, true, false]);
        // what is said not to follow is named, too
        let (g, h) = (0, 4);
        assert_eq!(of("e").denied(), Some(h));
        assert_eq!(of("e").premises(), [g, h]);
        assert_eq!(of("c").denied(), None);
        assert_eq!(of("c").premises(), [g]);
    }

    #[test]
    fn that_nothing_varies_is_said_where_a_limit_is_not_proved() {
        let audit = judged(
            "var x, c\ngiven tied: c < x\nclaim a: c -> 0 as x -> oo from tied expect refuted\n\
             claim b: c -> c as x -> oo from tied\nclaim d: c -> 0 as x -> oo expect refuted",
        );
        let report = Report::new(&audit, "kane audit");
        let reasons: Vec<String> =
            report.entries().filter_map(|e| e.decisive_reason(Form::Plain)).collect();
        let varies =
            reasons.iter().map(|r| r.contains("nothing in it varies with x: c is a constant"));
        assert_eq!(varies.collect::<Vec<_>>(), [true, false, false], "{reasons:?}");
    }
}
