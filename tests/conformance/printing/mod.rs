//! What is shown is what was judged: random statements, printed in every notation, are read back by
//! readers that know nothing of the printers.

mod generator; // random statements with every kind of node
mod judges; // what is put to Coq and z3
mod labels; // labels and prose that would speak for the auditor
mod latex; // a reader of LaTeX
mod mathml; // a reader of MathML
mod terms; // a reader of Coq's terms

use std::collections::HashMap;

use kane::algebra::syntax::{Notation, parse_expr, parse_relations, parse_sentence};
use kane::audit::{Audit, Options, audit, read};
use kane::kernel::{Context, Expr, Sentence};
use kane::report::{Report, html};

use crate::many::many;
use crate::support::Chance;
use generator::{ALL, DEFINED, FUNCTION, PLAIN, Wanted};
use latex::{Names, Reader, Token};

fn context() -> Context {
    generator::scope().into_context()
}

/// The names as a person writes them in LaTeX.
fn names() -> Names {
    let plain = PLAIN.iter().enumerate().map(|(i, (_, set))| (*set, Expr::Var(i)));
    let function = (FUNCTION.1, Expr::Var(PLAIN.len()));
    let defined = DEFINED.iter().enumerate().map(|(i, (_, set, _))| (*set, Expr::Let(i)));
    let symbols: HashMap<String, Expr> =
        plain.chain([function]).chain(defined).map(|(set, e)| (set.to_owned(), e)).collect();
    Names { symbols, functions: vec![Expr::Var(PLAIN.len())] }
}

#[test]
fn plain_text_reads_back_as_the_same_statement() {
    let (scope, context) = (generator::scope(), context());
    let mut chance = Chance::new(1);
    for _ in 0..many(3000) {
        let depth = 1 + chance.below(4);
        let sentence = generator::sentence(depth, ALL, &mut chance);
        let text = sentence.plain(&context);
        match parse_sentence(&text, &scope) {
            Ok(back) => assert_eq!(back, sentence, "{text}"),
            Err(faults) => panic!("{text}: {faults:?}"),
        }
        let relations = generator::relations(2, ALL, &mut chance);
        let text = relations.plain(&context);
        assert_eq!(parse_relations(&text, &scope), Ok(relations), "{text}");
    }
}

#[test]
fn numbers_that_nobody_wrote_read_back_as_their_value() {
    let (scope, context) = (generator::scope(), context());
    let mut chance = Chance::new(2);
    let wanted = Wanted { numbers: true, ..ALL };
    for _ in 0..many(3000) {
        let e = generator::expression(3, wanted, &mut chance);
        let text = e.plain(&context);
        match parse_expr(&text, &scope) {
            Ok(back) => assert_eq!(back, generator::spelled(&e), "{text}"),
            Err(faults) => panic!("{text}: {faults:?}"),
        }
    }
}

#[test]
fn latex_reads_back_as_the_same_statement() {
    let (context, names) = (context(), names());
    let mut chance = Chance::new(3);
    for round in 0..many(6000) {
        let depth = 1 + chance.below(4);
        let wanted = Wanted { numbers: round % 2 == 0, ..ALL };
        let sentence = generator::sentence(depth, wanted, &mut chance);
        let latex = sentence.latex(&context);
        let back = latex::tokens(&latex).and_then(|tokens| Reader::new(tokens, &names).sentence());
        let plain = sentence.plain(&context);
        assert_eq!(back, Ok(generator::spelled_sentence(&sentence)), "{plain}\n{latex}");
    }
}

/// What `$…$` in a document is read as, by the names that the symbols are declared under; nothing if the
/// formula is refused, or has a name that is not declared.
fn between_dollars(latex: &str) -> Option<Sentence> {
    let read = kane::latex::statement(latex, &mut kane::latex::Names::default()).ok()?;
    // a subscript without its line is the same name in print
    let text = read.text().replace("k_W", "kW");
    parse_sentence(&text, &generator::scope()).ok()
}

/// What the program prints, its own reader of LaTeX takes for the same, or refuses.
#[test]
fn latex_between_dollars_reads_back_as_the_same_statement() {
    let context = context();
    let mut chance = Chance::new(5);
    let (mut all, mut taken) = (0, 0);
    for _ in 0..many(6000) {
        let depth = 1 + chance.below(3);
        let sentence = generator::sentence(depth, ALL, &mut chance);
        let latex = sentence.latex(&context);
        all += 1;
        if let Some(back) = between_dollars(&latex) {
            taken += 1;
            assert_eq!(back, generator::spelled_sentence(&sentence), "{latex}");
        }
    }
    assert!(5 * taken > all, "{taken} of {all} are read");
}

/// Two readers of LaTeX that share nothing, and a formula that nobody printed: both may refuse, but they
/// never read two things.
#[test]
fn two_readers_of_latex_never_read_two_things() {
    let (context, names) = (context(), names());
    let mut chance = Chance::new(6);
    let pieces = [
        "x",
        "y",
        r"\mu ",
        r"\alpha ",
        "E",
        "^{2}",
        "^2",
        "_",
        "(",
        ")",
        r"\left(",
        r"\right)",
        "+",
        "-",
        "/",
        "=",
        "<",
        ",",
        r"\frac{1}{2}",
        r"\frac",
        "{",
        "}",
        "2",
        "3",
        "|",
        r"\cdot ",
        r"\sqrt{x}",
        "'",
        " ",
        "0.5",
        r"\Delta ",
        "d",
        r"\text{when }",
        r"\to ",
        r"\min",
        r"\begin{cases}",
        "&",
        r"\\",
        "w",
        "k",
    ];
    let mut both = 0;
    for _ in 0..many(30_000) {
        let sentence = generator::sentence(1 + chance.below(2), ALL, &mut chance);
        let mut latex = sentence.latex(&context);
        for _ in 0..=chance.below(3) {
            let places: Vec<usize> = latex.char_indices().map(|(at, _)| at).collect();
            let at = places[chance.below(places.len())];
            let piece = pieces[chance.below(pieces.len())];
            if chance.below(2) == 0 {
                latex.insert_str(at, piece);
            } else {
                let end = at + latex[at..].chars().next().map_or(0, char::len_utf8);
                latex.replace_range(at..end, piece);
            }
        }
        // a wide space parts two formulas, or is a space: papers have it as the former
        if latex.replace(r"\quad\text", "").contains(r"\quad") {
            continue;
        }
        let theirs =
            latex::tokens(&latex).and_then(|tokens| Reader::new(tokens, &names).sentence());
        if let (Some(ours), Ok(theirs)) = (between_dollars(&latex), theirs) {
            both += 1;
            assert_eq!(ours, theirs, "{latex}");
        }
    }
    assert!(both > 100, "{both}");
}

#[test]
fn words_of_the_language_are_no_names_between_dollars() {
    for word in kane::algebra::syntax::RESERVED {
        let latex = format!(r"\mathrm{{{word}}} = 1");
        assert!(
            kane::latex::statement(&latex, &mut kane::latex::Names::default()).is_err(),
            "{word}"
        );
    }
}

/// The given sentences as a judged document.
fn given(sentences: &[Sentence]) -> Audit {
    let mut text = format!("```kane\n{}", generator::declarations());
    for (n, sentence) in sentences.iter().enumerate() {
        text.push_str(&format!("given g{n}: {}\n", sentence.plain(&context())));
    }
    text.push_str("```\n");
    let document = read("random.md", text.as_bytes()).unwrap_or_else(|faults| {
        unreachable!("{}", faults.iter().map(ToString::to_string).collect::<String>())
    });
    audit(document, &Options::default(), &mut |_, _| {})
}

/// The formulas of an article of a page: what is said, and its conditions.
fn formulas(article: &str, names: &Names) -> Result<Sentence, String> {
    let mut tokens = Vec::new();
    for (n, math) in article.match_indices("<math ").map(|(at, _)| &article[at..]).enumerate() {
        if n > 0 {
            tokens.push(Token::Words("when".to_owned()));
        }
        tokens.extend(mathml::element(math)?.0.inside()?);
    }
    Reader::new(tokens, names).sentence()
}

#[test]
fn the_page_shows_the_statements_that_were_judged() {
    let names = names();
    let mut chance = Chance::new(4);
    for _ in 0..many(5) {
        let sentences: Vec<Sentence> =
            (0..300).map(|_| generator::sentence(1 + chance.below(4), ALL, &mut chance)).collect();
        let page = html(&Report::new(&given(&sentences), "kane audit random.md"));
        let articles = page.split("<article class=\"s given").skip(1);
        assert_eq!(articles.clone().count(), sentences.len());
        for (article, sentence) in articles.zip(&sentences) {
            let article = article.split("</article>").next().unwrap_or_default();
            let said = article.split("class=\"note\"").next().unwrap_or_default();
            let plain = sentence.plain(&context());
            assert_eq!(formulas(said, &names).as_ref(), Ok(sentence), "{plain}\n{said}");
        }
    }
}

/// The reader is no rubber stamp: what people would misread, it reads as they do, or refuses.
#[test]
fn the_reader_of_latex_is_as_easily_misled_as_people_are() {
    let names = names();
    let read = |latex: &str| {
        let sentence = Reader::new(latex::tokens(latex)?, &names).sentence()?;
        Ok::<_, String>(sentence.plain(&context()))
    };
    let slope = r"\frac{\mathrm{d}}{\mathrm{d}x}";
    for (latex, meaning) in [
        (format!(r"{slope}\left(-x^{{2}}\right)^{{2}} = 1"), "d((-x^2)^2, x) = 1"),
        (format!(r"{slope}\left(x\right) y = 1"), "d(x*y, x) = 1"),
        (format!(r"{slope}\left(x\right) \cdot y = 1"), "d(x, x)*y = 1"),
        (r"-x^{2} = 1".to_owned(), "-x^2 = 1"),
        (r"\Delta E = 1".to_owned(), "DeltaE = 1"),
        (r"\Delta \cdot E = 1".to_owned(), "Delta*E = 1"),
    ] {
        assert_eq!(read(&latex).as_deref(), Ok(meaning), "{latex}");
    }
    for refused in [
        r"2 3 = 1",
        r"2 \frac{1}{3} = 1",
        r"k \left(x\right) = 1",
        r"x^{2}^{3} = 1",
        r"\begin{cases} x & \text{if } x < 1 \end{cases} + 1 = y",
    ] {
        assert!(read(refused).is_err(), "{refused}");
    }
}
