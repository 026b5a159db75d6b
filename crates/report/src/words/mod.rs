//! Proofs, witnesses and reasons in words: one wording for every form of a report.
//!
//! What is said stands in the steps as data. Here it becomes sentences, in which formulas are set from
//! their expressions: as text, as MathML, or in math mode of LaTeX.

mod attempt;
mod branch;
mod decimal;
mod fences;
mod formula;
mod lines;
mod point;
mod prose;
mod reason;
mod shape;
mod step;
mod teller;
#[cfg(test)]
mod told;
mod value;

use kane_algebra::syntax::Notation as _;
use kane_audit::{Claim, Judgement, LinkJudgement, Proof};
use kane_kernel::{Context, Expr, Goal};

pub(crate) use formula::{Formulas, escaped};
pub(crate) use prose::Prose;
pub(crate) use reason::nothing_varies;

/// In which form sentences are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// text, with formulas in the notation of documents
    Plain,
    /// HTML, with formulas in MathML
    Html,
    /// LaTeX
    Latex,
}

/// Lines after which a proof is cut.
const MAX_LINES: usize = kane_audit::MAX_STEPS;

/// A sentence of a proof or a witness, and how far it is indented.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Line {
    pub(crate) depth: usize,
    pub(crate) text: String,
    /// whether a reader looks it up, and does not follow it
    pub(crate) folded: bool,
}

/// What sentences about a goal take their names from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Subject<'a> {
    pub(crate) goal: &'a Goal,
    /// names of the goal's hypotheses
    pub(crate) labels: &'a [&'a str],
}

impl Subject<'_> {
    /// A proof or a witness, line by line.
    pub(crate) fn steps(self, proof: &Proof, form: Form) -> Vec<Line> {
        let mut lines = step::lines(self.labels, (form, &self.goal.context), proof);
        if lines.len() > MAX_LINES {
            lines.truncate(MAX_LINES);
            let text = words("(the rest of this proof is left out here)", form);
            lines.push(Line { depth: 0, text, folded: false });
        }
        lines
    }

    /// A proof or a witness in one sentence.
    pub(crate) fn reason(self, reason: &kane_audit::Reason, form: Form) -> String {
        reason::sentence(self.goal, reason, form)
    }

    /// A value for each symbol of a model: its name, and what it is.
    pub(crate) fn values(
        self,
        values: &[kane_audit::Assignment],
        form: Form,
    ) -> Vec<(String, String)> {
        let formulas = Formulas::new(form, &self.goal.context, &[]);
        values
            .iter()
            .map(|given| (formulas.symbol(given.symbol), value::value(&formulas, &given.value)))
            .collect()
    }
}

/// A word or a sentence without formulas in it.
pub(crate) fn words(text: &str, form: Form) -> String {
    match form {
        Form::Plain => text.to_owned(),
        Form::Html => escaped(text),
        Form::Latex => crate::tex::escape(text),
    }
}

/// Why a link's verdict is what it is, in one sentence. The context is that of the document, where
/// statements have these labels.
pub(crate) fn reason(
    link: &LinkJudgement,
    context: &Context,
    label: &dyn Fn(usize) -> String,
    form: Form,
) -> String {
    if let (Some(accepted), Some(reason)) = (link.accepted.as_deref(), link.reason()) {
        let told = Subject { goal: &accepted.goal, labels: &[] }.reason(&reason, form);
        let name = |(v, value): &(usize, u32)| {
            let n = Expr::Var(*v);
            let n = match form {
                Form::Latex => format!("${}={value}$", n.latex(context)),
                _ => words(&format!("{} = {value}", n.plain(context)), form),
            };
            format!("for {n}, ")
        };
        let at: String = link.at.iter().map(name).collect();
        return reason::standing(link, &(at + &told), label, form);
    }
    match (&link.unreached, &link.open) {
        (Some(unreached), _) => reason::unreached(unreached, context, label, form),
        (None, Some(open)) => {
            let tried = link.attempt.as_ref();
            let tried = tried.map(|attempt| attempt::remark(attempt, context, form));
            words(&open.to_string(), form) + &tried.unwrap_or_default()
        }
        (None, None) => String::new(),
    }
}

/// The witness that was found for what a claim says exists; `None` where none was looked for or found.
pub(crate) fn found(claim: &Claim, context: &Context, form: Form) -> Option<String> {
    let formulas = Formulas::new(form, context, &[]);
    let name = |name: &str| Formulas::of_letter(form, name).symbol(0);
    let pairs = claim.found.iter().map(|(y, value)| (name(y), formulas.expr(value)));
    let pairs: Vec<(String, String)> = pairs.collect();
    (!pairs.is_empty()).then(|| format!("for {}, which was found: ", equations(&pairs, form)))
}

/// The same as text, of a link whose document is not at hand.
pub(crate) fn reason_alone(link: &LinkJudgement) -> String {
    reason(link, &Context::default(), &|_| "a premise".to_owned(), Form::Plain)
}

/// The values for which the hypotheses of a claim hold; `None` where none were found.
pub(crate) fn example(judgement: &Judgement, form: Form) -> Option<Vec<(String, String)>> {
    let met = judgement.met.as_deref()?;
    let subject = Subject { goal: &met.goal, labels: &[] };
    Some(subject.values(&judgement.example()?, form))
}

/// Pairs `name = value` with commas between.
pub(crate) fn equations(pairs: &[(String, String)], form: Form) -> String {
    let pairs: Vec<String> =
        pairs.iter().map(|(name, value)| formula::joined(form, name, "=", value)).collect();
    pairs.join(", ")
}

#[cfg(test)]
mod tests {
    use kane_audit::{Options, audit, read};

    use super::*;

    fn reasons(statements: &str, form: Form) -> Vec<String> {
        let text = format!("```kane\n{statements}\n```\n");
        let document = read("words.md", text.as_bytes()).expect("it is well formed");
        let audit = audit(document, &Options::default(), &mut |_, _| {});
        let context = &audit.document.context;
        let links = audit.judgements.iter().flat_map(|judgement| &judgement.links);
        links.map(|link| reason(link, context, &|_| String::new(), form)).collect()
    }

    const ARTICLE: &str = "var a, b\nclaim c: a^2 + b^2 >= 2*a*b\nclaim f: a = 0 expect refuted";

    #[test]
    fn the_article_is_a_word_and_the_variable_a_formula() {
        let plain = reasons(ARTICLE, Form::Plain);
        assert_eq!(plain[0], "by a sum of non-negative terms");
        assert_eq!(reasons(ARTICLE, Form::Html)[0], plain[0]);
        assert_eq!(reasons(ARTICLE, Form::Latex)[0], plain[0]);
        let standing = "false under all that was assumed, at ";
        let value = plain[1].strip_prefix(&format!("{standing}a = ")).expect("a point");
        let (value, _) = value.split_once(':').expect("what is found there");
        let html = &reasons(ARTICLE, Form::Html)[1];
        let at = format!("{standing}<math><mi>a</mi></math> = {}:", value.replace('-', "−"));
        assert!(html.starts_with(&at), "{html}");
        let latex = &reasons(ARTICLE, Form::Latex)[1];
        assert!(latex.starts_with(&format!("{standing}$a = {value}$:")), "{latex}");
    }

    #[test]
    fn what_fails_for_one_number_in_the_place_of_an_index_says_for_which() {
        let counted = "var n in N\nlet s(0) := 0, s(n + 1) := s(n) + 2\n\
            claim c: s(n) > 1 for n >= 0 expect refuted";
        for (form, index) in [(Form::Plain, "n = 0"), (Form::Html, "n = 0"), (Form::Latex, "$n=0$")]
        {
            let told = &reasons(counted, form)[0];
            assert!(told.contains(&format!("for {index}, ")), "{told}");
        }
    }

    #[test]
    fn a_witness_that_was_found_is_told_and_one_that_is_named_is_not() {
        let told = |claim: &str, form: Form| {
            let text = format!("```kane\nvar x\nclaim c: {claim}\n```\n");
            let document = read("words.md", text.as_bytes()).expect("it is well formed");
            let audit = audit(document, &Options::default(), &mut |_, _| {});
            let claims = audit.document.statements.iter().filter_map(|s| match &s.body {
                kane_audit::Body::Claim(claim) => Some(claim),
                _ => None,
            });
            claims.map(|claim| found(claim, &audit.document.context, form)).collect::<Vec<_>>()
        };
        let sum = "exists y: x + y = 3";
        let [Some(plain)] = &told(sum, Form::Plain)[..] else { unreachable!("one is found") };
        let value = plain.strip_prefix("for y = ").expect("a name and a value");
        let value = value.strip_suffix(", which was found: ").expect("it ends so");
        // put in for y, it makes the claim true
        let put_in = format!("```kane\nvar x\nclaim c: x + ({value}) = 3\n```\n");
        let document = read("words.md", put_in.as_bytes()).expect("it is well formed");
        let audit = audit(document, &Options::default(), &mut |_, _| {});
        assert_eq!(audit.judgements[0].verdict, kane_audit::Verdict::Proved);
        assert_eq!(told("exists y: x + y = 3 by y := 3 - x", Form::Plain), [None]);
        assert_eq!(told("x^2 >= 0", Form::Plain), [None]);
    }

    #[test]
    fn formulas_of_the_matrix_stand_between_backticks() {
        let told = "no energy, `0 <= e <= 1`, a law of `mu`";
        let of = |form| Prose::new(form).sentence(told);
        assert_eq!(of(Form::Plain), kane_matrix::unmarked(told));
        assert_eq!(
            of(Form::Html),
            "no energy, 0 ≤ <math><mi>e</mi></math> ≤ 1, a law of <math><mi>μ</mi></math>"
        );
        assert_eq!(of(Form::Latex), "no energy, $0 \\le e \\le 1$, a law of $\\mu$");
    }

    #[test]
    fn every_formula_of_a_template_or_a_symbol_list_is_known() {
        let html = Prose::new(Form::Html);
        for text in kane_matrix::SYMBOLS_IN_WORDS.split('`').skip(1).step_by(2) {
            let set = html.formula(text);
            assert!(set.contains("<math>"), "{text} is no formula: {set}");
        }
    }
}
