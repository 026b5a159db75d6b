//! `docs/laws.md`: what is said about each law, as data and in its docstring.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use kane::impact::{Law, LawInfo, Restitution, laws as all};

use crate::NotMade;

/// A law's docstring: the name of the type, and its lines without the slashes. It is the prose of the
/// law's section; what is told of every law alike is in [`LawInfo`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Docstring {
    /// the type's name
    pub name: String,
    /// without the slashes
    pub lines: Vec<String>,
}

/// The docstrings of all laws of the checkout at `root`, by the id that each states.
///
/// # Errors
/// [`NotMade`] if the sources cannot be read.
pub fn docstrings(root: &Path) -> Result<BTreeMap<String, Docstring>, NotMade> {
    let unread = |error: std::io::Error| NotMade::because("laws.md", error);
    let mut out = BTreeMap::new();
    for entry in fs::read_dir(root.join("crates/impact/src/laws")).map_err(unread)? {
        let source = fs::read_to_string(entry.map_err(unread)?.path()).map_err(unread)?;
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
    Ok(out)
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

fn hypothesis(law: &Law) -> &'static str {
    match law.info.restitution {
        Restitution::Newton if law.has_frame() => "Newton, in a turned frame",
        other => other.name(),
    }
}

fn defaults(law: &Law) -> String {
    let parameters = law.parameters();
    let one = |(name, value): &(&str, _)| format!("`{} = {value}`", shown(name));
    match parameters.len() {
        0 => "–".into(),
        _ => {
            let invented = law.invented();
            let one = |own: &(&str, _)| {
                let mark = if invented.contains(&own.0) { " (invented)" } else { "" };
                one(own) + mark
            };
            parameters.iter().map(one).collect::<Vec<_>>().join(", ")
        }
    }
}

fn section(out: &mut String, law: &Law, doc: &Docstring) {
    let LawInfo { id, statement, source, parameters, .. } = law.info;
    let who = law.info.who();
    let _ = write!(out, "\n## {id}\n\n*{who}.* In code: `kane::impact::laws::{}`.\n\n", doc.name);
    for line in &doc.lines {
        let _ = writeln!(out, "{}", without_links(line));
    }
    let _ = writeln!(out, "\nSource: {}.", source.replace('*', "\\*"));
    if !law.info.engines.is_empty() {
        let _ = writeln!(out, "\nMet elsewhere: {}.", law.info.engines);
    }
    let frame =
        if law.has_frame() { ", in the turned frame and where it does not couple" } else { "" };
    let _ = write!(
        out,
        "\nIn the derivation language, with momentum and restitution understood{frame}:\n\n```text\n{statement}\n```\n\n"
    );
    let _ = writeln!(out, "- parameters beyond μ and e: {}", defaults(law));
    for own in *parameters {
        let _ = writeln!(out, "  - `{}`: {}, {}", shown(own.name), own.meaning, own.domain());
    }
    let _ = writeln!(out, "- restitution: {}", hypothesis(law));
    let limit = law.normal_collision();
    let limit = limit.map_or_else(|| "none".into(), |k| format!("`{}`", shown(&k.to_string())));
    let _ = writeln!(out, "- limit of k in normal collision, `α → ∞`: {limit}");
    if let Some(caveat) = law.info.caveat {
        let _ = writeln!(out, "- caution: {caveat}");
    }
    let gap = law.info.lacks().unwrap_or_else(|| "nothing, it is total".into());
    let _ = writeln!(out, "- what it lacks: {gap}");
}

/// The page.
///
/// # Errors
/// [`NotMade`] if a law has no docstring.
pub fn laws(root: &Path) -> Result<String, NotMade> {
    let docs = docstrings(root)?;
    let told = |law: &Law| {
        let id = law.info.id;
        docs.get(id).ok_or_else(|| NotMade::because("laws.md", format!("{id} has no docstring")))
    };
    let mut out = String::from(HEAD);
    out.push_str("\n| law | who and when | k on a sphere | own parameters | restitution | known by |\n|---|---|---|---|---|---|\n");
    for law in all() {
        let _ = writeln!(
            out,
            "| [`{0}`](#{0}) | {1} | {2} | {3} | {4} | {5} |",
            law.info.id,
            law.info.who(),
            formula(law.info),
            defaults(law),
            hypothesis(law),
            law.info.known_by.name(),
        );
    }
    out.push_str(TAIL);
    out.push_str(WITHOUT);
    for law in all() {
        section(&mut out, law, told(law)?);
    }
    Ok(out)
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
