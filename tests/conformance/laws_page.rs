//! `docs/laws.md` is made of what the laws say of themselves: their docstrings, and the catalogue.
//!
//! Only the first table has words of its own, who and when, and k(α) on a sphere as a formula; the
//! formulas are judged by the auditor: they follow from what the laws state, and they are what the code
//! says exactly.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;

use kane::audit::Verdict;
use kane::impact::{Alpha, Law, LawInfo, Restitution, laws};
use kane::number::{Rational, parse};

use crate::support::{judged, root};

const PAGE: &str = "docs/laws.md";
const WRITE: &str = "KANE_WRITE_DOCS";

/// What the catalogue says of a law.
struct Entry {
    info: &'static LawInfo,
    parameters: Vec<(&'static str, Rational)>,
    normal: Option<Rational>,
    /// Whether the law stands in a frame of its own.
    turned: bool,
    /// k at some α, where it is rational.
    values: Vec<(Rational, Rational)>,
}

fn entry(law: &Law) -> Entry {
    let value = |alpha: &Rational| {
        let ratios = law.over().ratios(&Alpha::Finite(alpha.clone()))?;
        Some((alpha.clone(), ratios.k))
    };
    Entry {
        info: law.info,
        parameters: law.parameters(),
        normal: law.normal_collision(),
        turned: law.has_frame(),
        values: alphas().iter().filter_map(value).collect(),
    }
}

fn catalogue() -> Vec<Entry> {
    laws().iter().map(entry).collect()
}

/// The landmarks of the laws; at the last five Smith's square root is rational.
fn alphas() -> Vec<Rational> {
    let text = "1/100 1/10 1/4 2/5 1/2 3/5 3/4 1 3/2 2 3 5 10 100 5/4 13/6 25/8 41/10 82/15";
    text.split(' ').map(|alpha| parse(alpha).expect("a literal")).collect()
}

/// A law's docstring: the name of the type, and its lines without the slashes.
struct Docstring {
    name: String,
    lines: Vec<String>,
}

/// The docstrings of all public structs of the laws, by the id that each states.
fn docstrings() -> BTreeMap<String, Docstring> {
    let mut out = BTreeMap::new();
    let folder = root().join("crates/impact/src/laws");
    for entry in fs::read_dir(folder).expect("the laws are there") {
        let path = entry.expect("the folder is readable").path();
        let source = fs::read_to_string(path).expect("the source is UTF-8");
        let mut lines = Vec::new();
        for line in source.lines() {
            if let Some(text) = line.strip_prefix("///") {
                lines.push(text.strip_prefix(' ').unwrap_or(text).to_owned());
            } else if let Some(name) = line.strip_prefix("pub struct ") {
                let name = name.split([' ', ';', '{']).next().unwrap_or_default().to_owned();
                let all = lines.join(" ");
                let id = all.split("(id `").nth(1).and_then(|rest| rest.split('`').next());
                if let Some(id) = id {
                    let lines = std::mem::take(&mut lines);
                    out.insert(id.to_owned(), Docstring { name, lines });
                }
            } else if !line.starts_with("#[") {
                lines.clear();
            }
        }
    }
    out
}

/// Intra-documentation links as plain inline code.
fn without_links(line: &str) -> String {
    let mut out = String::new();
    let mut rest = line;
    while let Some((before, link)) = rest.split_once("[`") {
        let Some((text, after)) = link.split_once("`]") else { break };
        let _ = write!(out, "{before}`{text}`");
        rest = match after.strip_prefix('(').and_then(|target| target.split_once(')')) {
            Some((_, after)) => after,
            None => after,
        };
    }
    out + rest
}

/// A formula of the derivation language for reading.
fn shown(formula: &str) -> String {
    let greek = formula.replace("alpha", "α").replace("beta0", "β0").replace("eta", "η");
    greek.replace("sqrt", "√").replace('*', "·").replace('-', "−")
}

fn formula(info: &LawInfo) -> String {
    let piece = |(until, formula): &(&str, &str)| match *until {
        "" => format!("`{}`", shown(formula)),
        until => format!("`{}` up to `α = {until}`, then ", shown(formula)),
    };
    match info.on_a_sphere {
        [] => "not by `α` alone".into(),
        pieces => pieces.iter().map(piece).collect(),
    }
}

const fn hypothesis(entry: &Entry) -> &'static str {
    match entry.info.restitution {
        Restitution::Newton if entry.turned => "Newton, in a turned frame",
        other => other.name(),
    }
}

fn defaults(entry: &Entry) -> String {
    let one = |(name, value): &(&str, Rational)| format!("`{} = {value}`", shown(name));
    match entry.parameters.len() {
        0 => "–".into(),
        _ => entry.parameters.iter().map(one).collect::<Vec<_>>().join(", "),
    }
}

fn section(out: &mut String, entry: &Entry, doc: &Docstring) {
    let _ = write!(
        out,
        "\n## {}\n\n*{}.* In code: `kane::impact::laws::{}`.\n\n",
        entry.info.id,
        entry.info.who(),
        doc.name
    );
    for line in &doc.lines {
        let _ = writeln!(out, "{}", without_links(line));
    }
    let _ = writeln!(out, "\nSource: {}.", entry.info.source.replace('*', "\\*"));
    let _ = write!(
        out,
        "\nIn the derivation language, with momentum and restitution understood{}:\n\n```text\n{}\n```\n\n",
        if entry.turned { ", in the turned frame and where it does not couple" } else { "" },
        entry.info.statement
    );
    let _ = writeln!(out, "- parameters beyond μ and e: {}", defaults(entry));
    for own in entry.info.parameters {
        let _ = writeln!(out, "  - `{}`: {}, {}", shown(own.name), own.meaning, own.domain());
    }
    let _ = writeln!(out, "- restitution: {}", hypothesis(entry));
    let limit = entry
        .normal
        .as_ref()
        .map_or_else(|| "none".into(), |k| format!("`{}`", shown(&k.to_string())));
    let _ = writeln!(out, "- limit of k in normal collision, `α → ∞`: {limit}");
    let gap = entry.info.gap.unwrap_or("nothing, it is total");
    let _ = writeln!(out, "- what it lacks: {gap}");
}

fn page() -> String {
    let (entries, docs) = (catalogue(), docstrings());
    let mut out = String::from(HEAD);
    out.push_str("\n| law | who and when | k on a sphere | own parameters | restitution | known by |\n|---|---|---|---|---|---|\n");
    for entry in &entries {
        let _ = writeln!(
            out,
            "| [`{0}`](#{0}) | {1} | {2} | {3} | {4} | {5} |",
            entry.info.id,
            entry.info.who(),
            formula(entry.info),
            defaults(entry),
            hypothesis(entry),
            entry.info.known_by.name(),
        );
    }
    out.push_str(TAIL);
    out.push_str(WITHOUT);
    for entry in &entries {
        section(&mut out, entry, &docs[entry.info.id]);
    }
    out
}

const HEAD: &str = "\
<!-- Made from the docstrings in crates/impact/src/laws; see CONTRIBUTING.md for how to make it again. -->

# The laws

Every law that the program knows, with its default parameters, in the order of tables and reports: the paper's, then by the year of the idea. A law takes the state of a contact and gives the impulse; momentum and restitution are not its to choose.

Symbols, as in the paper: `k = v_t⁺/v_t` is the slip after by before, `i_x` the friction by that of full sliding, `α` the collision parameter, `e` the restitution, `μ` Coulomb's coefficient. `W` is the Delassus operator of the contact with its entries `W_tt`, `W_tn`, `W_nn`; a contact *couples* if `W_tn ≠ 0`. A sphere on a plane does not couple. Impulses are `p_t` along the tangent and `p_n` along the normal, which on a sphere are the paper's `−I_x` and `I_y`; `a` is the speed of approach.
";

const TAIL: &str = "
*Known by* says on what the formula rests. **original**: the publication was read. **abstract**: of the publication only the abstract was at hand, and the formula was derived anew from what it says. **through others**: the formula is the one that other publications quote under that name; the original was not consulted, so that this page is no evidence of what it says. The paragraph *Source* of each law tells more.

The formulas for k on a sphere are proved: they follow from what each law states, for every `α > 0`.

On a sphere many of these are the same law. They differ on contacts that couple.

*Exact in exact numbers* means that the same code, run in rational numbers or in algebraic ones where it takes a root, makes no error at all. Bounds in ulps are for floats; *heuristic* means that none has been derived.
";

const WITHOUT: &str = "
Publications that are named beside these laws, and have no law of their own here:

| publication | what is known | why it has no law |
|---|---|---|
| Rémond | the name alone; the reference could not be identified, and is perhaps to S. Rémond's work on the packing and flow of grains | no formula could be attributed to it |
| Donahue, Hrenya, Zelinskaya and Nakagawa 2008 | abstract consulted: normal collisions of three spheres in a row, Phys. Fluids 20, 113301 | no friction and no oblique impact; it comes with the scene of the cradle |
| Stronge 1991 | abstract consulted: both parts of the impulse always dissipate; that the energetic coefficient is free of the angle of incidence is from memory | it is the law `stronge-1990`, whose e is that coefficient |
| Chatterjee and Ruina 1998, in space | as for `chatterjee-ruina` | a function of its own, `ChatterjeeRuina::impulse_in_space`, as the laws here are planar |
";

#[test]
fn the_page_of_laws_is_what_the_laws_say() {
    let (path, page) = (root().join(PAGE), page());
    if std::env::var_os(WRITE).is_some() {
        fs::write(path, page).expect("the page can be written");
        return;
    }
    let committed = fs::read_to_string(path).unwrap_or_default();
    let line = committed.lines().zip(page.lines()).position(|(a, b)| a != b);
    assert!(
        committed == page,
        "{PAGE} is not what the laws say, first in line {}; make it again with\n    {WRITE}=1 cargo test --test conformance page_of_laws",
        line.unwrap_or_else(|| committed.lines().count().min(page.lines().count())) + 1,
    );
}

#[test]
fn every_law_states_its_formula_domain_exactness_and_bound() {
    let docs = docstrings();
    for entry in catalogue() {
        let doc = docs
            .get(entry.info.id)
            .unwrap_or_else(|| unreachable!("{} has a docstring", entry.info.id));
        let text = doc.lines.join("\n");
        for asked in [" = ", "Domain: ", "xact in\nexact", "n floats"] {
            let plain = text.replace('\n', " ");
            assert!(plain.contains(&asked.replace('\n', " ")), "{}: no `{asked}`", entry.info.id);
        }
        // a line that begins like a quotation or a list would be shown as one
        let marked =
            |line: &&String| line.starts_with(['>', '#', '+', '*', '-']) && !line.starts_with("**");
        assert_eq!(doc.lines.iter().find(marked), None, "{}", entry.info.id);
    }
    assert_eq!(docs.len(), laws().len(), "every struct with an id is in the catalogue");
}

/// What leads from Smith's statement to the square root, for the auditor.
const SMITH: &str = "\
claim neg: k <= 0 when alpha >= 1/2 from (9), s0
claim quad: k^2 - 2*alpha*k + 1 - 2*alpha = 0 when k <= 0 from (9), s1
claim factors: (alpha - k - sqrt(alpha^2 + 2*alpha - 1))*(alpha - k + sqrt(alpha^2 + 2*alpha - 1)) = 0
    when alpha >= 1/2 from neg, quad
claim positive: alpha - k + sqrt(alpha^2 + 2*alpha - 1) > 0 when alpha >= 1/2 from neg
";

/// The formulas in the first table against the laws' statements, for every α > 0 and every value of
/// the laws' parameters.
#[test]
fn the_formulas_for_the_sphere_follow_from_the_statements() {
    for entry in catalogue() {
        let mut text = String::from(
            "var alpha > 0, k, i_x, share, eta, 0 <= beta0 <= 1, -1 <= e_t <= 1\n\
             given (9): 2*alpha*i_x = 1 - k\n",
        );
        let mut from = String::from("(9)");
        for (n, line) in entry.info.statement.lines().enumerate() {
            let _ = writeln!(text, "given s{n}: {line}");
            let _ = write!(from, ", s{n}");
        }
        if entry.info.id == "smith-1991" {
            text.push_str(SMITH);
            from.push_str(", factors, positive");
        }
        let mut lower = "0";
        for (n, (until, formula)) in entry.info.on_a_sphere.iter().enumerate() {
            let upper =
                if until.is_empty() { String::new() } else { format!(", alpha <= {until}") };
            let _ = writeln!(
                text,
                "claim formula-{n}: k = {formula} when alpha > {lower}{upper} from {from}"
            );
            lower = until;
        }
        let audit = judged(&text);
        for (statement, judgement) in audit.document.statements.iter().zip(&audit.judgements) {
            let fine = matches!(judgement.verdict, Verdict::Proved | Verdict::Assumed);
            assert!(fine, "{}: {} is {}", entry.info.id, statement.label, judgement.verdict);
        }
    }
}

/// The formulas in the first table against the code, judged by the auditor.
#[test]
fn the_formulas_for_the_sphere_are_those_of_the_code() {
    let mut text = String::from("var alpha > 0, share, eta, beta0, e_t\n");
    let mut claims = 0;
    for entry in catalogue() {
        assert!(entry.values.len() >= 8 || entry.turned, "{} has values", entry.info.id);
        let parameters: String =
            entry.parameters.iter().map(|(name, value)| format!(", {name} = {value}")).collect();
        for (n, (alpha, k)) in entry.values.iter().enumerate() {
            let pieces = entry.info.on_a_sphere;
            let inside = |(until, _): &&(&str, &str)| {
                until.is_empty() || *alpha <= parse(until).expect("a literal")
            };
            let (_, formula) = pieces.iter().find(inside).expect("the last piece is open");
            let _ = writeln!(
                text,
                "claim {}-{n}: {formula} = {k} when alpha = {alpha}{parameters}",
                entry.info.id
            );
            claims += 1;
        }
    }
    let audit = judged(&text);
    for (statement, judgement) in audit.document.statements.iter().zip(&audit.judgements) {
        assert_eq!(judgement.verdict, Verdict::Proved, "{}", statement.label);
    }
    println!("{claims} values of k(α) in the page of laws are proved");
    assert!(claims >= 250, "the suite is there");
}
