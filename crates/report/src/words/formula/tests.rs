use kane_audit::{Body, Content};
use kane_kernel::{Limit, Link};

use super::*;

const FORMS: [Form; 3] = [Form::Plain, Form::Html, Form::Latex];

/// The context of a, b, c, and the links of claims in them.
fn read(claims: &str) -> (Context, Vec<Link>) {
    let text = format!("```kane\nvar a, b, c\n{claims}```\n");
    let document = kane_audit::read("f.md", text.as_bytes()).expect("it is well formed");
    let links = document.statements.iter().flat_map(|s| match &s.body {
        Body::Claim(claim) => match &claim.content {
            Content::Links(links) => links.iter().map(|(link, _)| link.clone()).collect(),
            _ => Vec::new(),
        },
        _ => Vec::new(),
    });
    let links = links.collect();
    (document.context, links)
}

fn formulas(form: Form) -> Formulas {
    Formulas::new(form, &read("").0, &[])
}

/// What is left for a reader: without tags, and with the signs that their names stand for.
fn seen(set: &str) -> String {
    let mut out = String::new();
    for part in set.split('<') {
        out.push_str(part.split_once('>').map_or(part, |(_, text)| text));
    }
    out.replace("&gt;", ">").replace("&lt;", "<")
}

#[test]
fn what_is_taken_away_stands_in_parentheses_if_it_is_a_sum() {
    let html = formulas(Form::Html);
    let [a, b, c] = [0, 1, 2].map(Expr::Var);
    let add = |x: &Expr, y: &Expr| Expr::Add(x.clone().into(), y.clone().into());
    let sub = |x: &Expr, y: &Expr| Expr::Sub(x.clone().into(), y.clone().into());
    let told = |e: &Expr| seen(&html.expr(e));
    assert_eq!(told(&sub(&a, &b)), "a − b");
    assert_eq!(told(&sub(&a, &add(&b, &c))), "a − (b+c)");
    assert_eq!(told(&sub(&a, &sub(&b, &c))), "a − (b−c)");
    assert_eq!(told(&add(&a, &Expr::Neg(b.into()))), "a + (−b)");
}

#[test]
fn numbers_are_whole_up_to_eighty_letters_and_nearly_told_beyond() {
    for form in FORMS {
        let formulas = formulas(form);
        let told = |digits: usize| {
            let number = "7".repeat(digits).parse().expect("a number");
            formulas.number(&number).replace('$', "").replace("\\allowbreak{}", "")
        };
        for digits in [12, 13, 80] {
            assert_eq!(told(digits), "7".repeat(digits));
        }
        assert_eq!([81, 82].map(told), ["about 7.7778e80", "about 7.7778e81"]);
    }
    // a long number may be broken between its groups of digits
    let latex = |digits: usize| {
        formulas(Form::Latex).number(&"7".repeat(digits).parse().expect("a number"))
    };
    assert!(!latex(12).contains("\\allowbreak") && latex(13).contains("\\allowbreak"));
    let half = formulas(Form::Html).number(&BigRational::new(1.into(), 2.into()));
    assert!(half.contains("<mfrac"), "{half}");
    assert_eq!(formulas(Form::Html).number(&BigRational::from_integer((-3).into())), "−3");
}

#[test]
fn words_between_relations_say_the_same_in_each_form() {
    let (context, links) = read(
        "claim one: a = 1 or b > 2\nclaim two: a = 1 implies b > 2\n\
         claim three: (a = 1 or b > 2) iff c != 0\n",
    );
    let wanted = ["a = 1 or b > 2", "a = 1 implies b > 2", "(a = 1 or b > 2) iff c != 0"];
    for (link, wanted) in links.iter().zip(wanted) {
        let Link::Relation(relation) = link else { unreachable!("it has no limit") };
        let told = |form| Formulas::new(form, &context, &[]).relation(relation);
        assert_eq!(told(Form::Plain), wanted);
        assert_eq!(seen(&told(Form::Html)), wanted.replace("!=", "≠"));
        let latex = told(Form::Latex).replace("\\ne ", "!= ").replace('$', "");
        assert_eq!(latex, wanted);
    }
}

#[test]
fn a_limit_says_what_tends_where_and_from_which_side() {
    let (context, links) = read(
        "claim a: 1/a -> oo as a -> 0+\nclaim b: 1/a -> -oo as a -> 0-\n\
         claim c: 1/a -> 0 as a -> -oo\nclaim d: a -> 2 as a -> 2\nclaim e: a -> oo as a -> oo\n",
    );
    let limits: Vec<&Limit> = links
        .iter()
        .filter_map(|link| match link {
            Link::Limit(limit) => Some(limit),
            Link::Relation(_) => None,
        })
        .collect();
    let told = |form| {
        let formulas = Formulas::new(form, &context, &[]);
        limits.iter().map(|l| formulas.limit(l)).collect::<Vec<_>>()
    };
    let plain = [
        "1/a -> oo as a -> 0+",
        "1/a -> -oo as a -> 0-",
        "1/a -> 0 as a -> -oo",
        "a -> 2 as a -> 2",
        "a -> oo as a -> oo",
    ];
    assert_eq!(told(Form::Plain), plain);
    // without tags 1/a is two letters
    let html = plain
        .map(|l| l.replace("1/a", "1a").replace("->", "→").replace("oo", "∞").replace('-', "−"));
    let seen: Vec<String> = told(Form::Html).iter().map(|limit| seen(limit)).collect();
    assert_eq!(seen, html);
}

#[test]
fn a_quotient_keeps_what_is_above_and_below_apart() {
    let (a, b, c) = (Poly::var(0), Poly::var(1), Poly::var(2));
    let fuel = kane_kernel::Fuel::new(1_000);
    let ab = a.mul(&b, &fuel).expect("it is short");
    let named = formulas(Form::Plain).named(&Shapes::for_proof());
    let told = |num: &Poly, den: &Poly| named.ratio(&(num.clone(), den.clone()));
    let (sum, twice, square) = (a.add(&b), c.scale(&2.into()), Poly::power(2, 2));
    assert_eq!(told(&ab, &twice), "a*b/(2*c)");
    assert_eq!(told(&sum, &c), "(a + b)/c");
    assert_eq!(told(&a, &sum), "a/(a + b)");
    assert_eq!(told(&a, &square), "a/c^2");
    assert_eq!(told(&a.neg(), &c), "(-a)/c");
    assert_eq!(told(&sum, &Poly::one()), "a + b");
    // without names each part stands in parentheses
    let plain = formulas(Form::Plain);
    assert_eq!(plain.quotient(&(a.clone(), c.clone())), "(a)/(c)");
    let html = formulas(Form::Html);
    assert_eq!(seen(&html.quotient(&(sum.clone(), Poly::one()))), "a + b");
    let fraction = |num: &Poly, den: &Poly| {
        let told = html.quotient(&(num.clone(), den.clone()));
        (told.contains("<mfrac"), seen(&told))
    };
    let terms = |count: u32| Poly::sum((0..count).map(|n| (vec![(0, n + 1)], 1.into())));
    assert!(fraction(&terms(4), &c).0 && fraction(&c, &terms(4)).0);
    for (num, den) in [(terms(5), c.clone()), (c.clone(), terms(5))] {
        let (over, told) = fraction(&num, &den);
        assert!(
            !over && told.contains(")/(") | told.contains(")/c") | told.contains("c/("),
            "{told}"
        );
    }
    let latex = formulas(Form::Latex);
    assert!(latex.quotient(&(a.clone(), c)).contains("\\frac"));
    assert_eq!(latex.quotient(&(a, Poly::one())), "$a$");
}

#[test]
fn up_to_forty_terms_are_written_out() {
    let terms = |count: u32| Poly::sum((0..count).map(|n| (vec![(0, n + 1)], 1.into())));
    let plain = formulas(Form::Plain);
    assert_eq!(plain.poly(&terms(40)).matches("a^").count(), 39);
    assert_eq!(plain.poly(&terms(41)), "(a polynomial with 41 terms)");
    assert_eq!(plain.poly(&terms(42)), "(a polynomial with 42 terms)");
}
