//! Names and titles that speak the languages in which reports are written are shown as text.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::{kane, scratch};

/// Ends what a title may stand in, and begins what each language obeys.
const HOSTILE: &str = r#"</title></text><script>alert(1)</script> " onmouseover=x' $\input{x}$ \write18{x} | \| `x` ``` [l](javascript:x) ![i](x) <!-- --> ]]> (* *) {{x}} %x #x ~~~ **b** &lt; =1+1;=1+1"#;

/// Runs a verb on files of two kinds, of which one is hostile, and compares what is written.
fn nothing_is_obeyed(what: &str, ending: &str, text: impl Fn(&str) -> String, verb: &[&str]) {
    let dir = scratch(&format!("injection-{what}"));
    let written = |kind: &str, name: &str, title: &str| {
        let file = dir.join(format!("{name}.{ending}"));
        fs::write(&file, text(title)).expect("the scratch directory is ours");
        let file = file.to_str().expect("UTF-8").to_owned();
        let out = dir.join(kind);
        let arguments = [&[verb[0], &file], &verb[1..], &["--out", out.to_str().expect("UTF-8")]];
        let run = kane(&arguments.concat());
        assert!(run.code < 2 && !run.stdout.is_empty(), "{what}: {}", run.stderr);
        let entries =
            fs::read_dir(&out).expect("it was made").map(|entry| entry.expect("readable"));
        entries.map(|entry| entry.path()).collect::<Vec<_>>()
    };
    let plain = written("plain", "plain", "a title");
    let hostile =
        written("hostile", r"=x <img src=q onerror=x> $\input{z}$ `b` [l](x) a|b", HOSTILE);
    assert_eq!(plain.len(), hostile.len(), "{what}: {hostile:?}");
    let known: BTreeSet<String> = plain.iter().flat_map(|path| obeyed(path)).collect();
    for path in &hostile {
        let new: Vec<String> = obeyed(path).difference(&known).cloned().collect();
        assert_eq!(new, Vec::<String>::new(), "{what}: {}", path.display());
    }
}

/// What a reader of a file obeys in it: tags with their attributes, commands, links, formulas of spreadsheets.
fn obeyed(path: &Path) -> BTreeSet<String> {
    let text = fs::read_to_string(path).expect("UTF-8");
    match path.extension().and_then(|ending| ending.to_str()) {
        Some("html" | "svg" | "xml") => tags(&text),
        Some("md") => {
            let bare = without_code(&text);
            let links = bare.match_indices("](").filter(|(at, _)| !bare[..*at].ends_with('\\'));
            let links = links.map(|(at, _)| bare[at..].chars().take(30).collect());
            tags(&bare).into_iter().chain(links).collect()
        }
        Some("tex") => commands(&text),
        Some("csv") => {
            // a comma in quotes ends no cell; a semicolon does, where a comma is decimal
            let mut quoted = false;
            let ends = |c: char| {
                quoted ^= c == '"';
                matches!(c, '\n' | ';') || (c == ',' && !quoted)
            };
            text.split(ends).filter(|cell| is_computed(cell)).map(str::to_owned).collect()
        }
        _ => BTreeSet::new(),
    }
}

/// Each tag with the names of its attributes.
fn tags(text: &str) -> BTreeSet<String> {
    let tag = |inside: &str| {
        let inside = inside.split('>').next().unwrap_or_default();
        // values, in quotes, are of any kind
        let bare: String = inside.split('"').step_by(2).collect::<Vec<_>>().join("\"");
        bare.split_whitespace()
            .map(|word| word.split('=').next().unwrap_or_default())
            .collect::<Vec<_>>()
            .join(" ")
    };
    let all = text.split('<').skip(1).map(tag);
    // which attributes an element has differs from one to the next
    all.flat_map(|tag| tag.split(' ').map(|word| format!("<{word}")).collect::<Vec<_>>()).collect()
}

/// The commands of LaTeX but for those that stand for a character, and what is special there.
fn commands(text: &str) -> BTreeSet<String> {
    const CHARACTERS: [&str; 4] =
        ["\\textbackslash", "\\textasciicircum", "\\textasciitilde", "\\scriptsize"];
    let mut found = BTreeSet::new();
    let mut rest = text;
    while let Some(at) = rest.find(['\\', '%', '^', '&', '#']) {
        let special = &rest[at..];
        let letters = special[1..].find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(0);
        let length = if special.starts_with('\\') { 1 + letters.max(1) } else { 1 };
        let (command, after) = special.split_at(length);
        let is_character = command.len() == 2 && command.starts_with('\\');
        if !is_character && !CHARACTERS.contains(&command) {
            found.insert(command.to_owned());
        }
        rest = after;
    }
    found
}

/// Markdown without its code: blocks in fences, and spans.
fn without_code(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(at) = rest.find('`') {
        let ticks = rest[at..].find(|c| c != '`').unwrap_or(1);
        let fence = "`".repeat(ticks);
        if rest[..at].ends_with('\\') {
            out.push_str(&rest[..=at]);
            rest = &rest[at + 1..];
            continue;
        }
        out.push_str(&rest[..at]);
        let behind = &rest[at + ticks..];
        let mut from = 0;
        let end = loop {
            let Some(found) = behind[from..].find(&fence) else { break None };
            let ended = from + found + ticks;
            if !behind[ended..].starts_with('`') && !behind[..from + found].ends_with('`') {
                break Some(ended);
            }
            from = ended + behind[ended..].find(|c| c != '`').unwrap_or(0);
        };
        let Some(end) = end else { return out + behind };
        rest = &behind[end..];
    }
    out + rest
}

/// Whether a spreadsheet computes the cell.
fn is_computed(cell: &str) -> bool {
    let cell = cell.trim_start_matches(['"', ' ']);
    cell.starts_with(['=', '+', '-', '@'])
        && !cell.starts_with("-inf")
        && cell.parse::<f64>().is_err()
}

#[test]
fn formulas_whose_names_speak_html_or_code_are_shown_as_text() {
    let formula = |title: &str| {
        let [x, y] =
            if title == HOSTILE { ["<img/src=q/onerror=x>", "=@*/--"] } else { ["x", "y"] };
        let title = title.replace('\\', "\\\\").replace('"', "\\\"");
        format!(
            "(FPCore ({x} {y}) :name \"{title}\" :precision binary64 :pre (and (<= 1 {x} 2) (<= 1 {y} 2)) (- (sqrt (+ 1 {x})) (sqrt (* {x} {y}))))"
        )
    };
    nothing_is_obeyed("floats", "fpcore", formula, &["stability"]);
    nothing_is_obeyed("prices", "fpcore", formula, &["chart", "--quick"]);
}

/// The text of a file, with another title.
fn titled(toml: &str, title: &str) -> String {
    let old = toml.lines().find(|line| line.starts_with("title")).expect("it has a title");
    let title = title.replace('\\', "\\\\").replace('"', "\\\"");
    toml.replace(old, &format!("title = \"{title}\""))
}

#[test]
fn scenes_and_collisions_whose_titles_speak_html_or_latex_are_shown_as_text() {
    for (what, scene) in [
        ("motion", include_str!("../../docs/scenes/two-spheres.toml")),
        ("impulse", include_str!("../../docs/scenes/rod-jam.toml")),
    ] {
        nothing_is_obeyed(what, "toml", |title| titled(scene, title), &["scene", "--compare"]);
    }
    let collision = include_str!("../../docs/collisions/ellipse.toml");
    nothing_is_obeyed("collision", "toml", |title| titled(collision, title), &["collide"]);
}

/// A log whose rows, pairs, columns and numbers are called so.
fn log(title: &str) -> String {
    let cell = format!("\"{}\"", title.replace('"', "\"\""));
    let head = "mass,inertia,rx,ry,mu,e,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post,id,pair";
    let row = |numbers: &str| format!("1,0.4,0,-1,{numbers},{cell},{cell},1\n");
    let rows = [
        "0.1,0.5,2.123456789,-1,0,1.973456789,0.5,-0.375",
        "0.1,0.5,2.123456789,-1,0,2.973456789,0.5,-0.75",
        &format!("0.1,{cell},2.123456789,-1,0,2.973456789,0.5,-0.75"),
    ];
    format!("{head},{cell}\n{}", rows.map(row).concat())
}

#[test]
fn logs_whose_columns_and_rows_speak_html_or_latex_are_shown_as_text() {
    nothing_is_obeyed("log", "csv", log, &["check"]);
    let dir = scratch("injection-compared");
    let file = dir.join("a <img src=q> **b** ```.csv");
    fs::write(&file, log(HOSTILE)).expect("the scratch directory is ours");
    let file = file.to_str().expect("UTF-8");
    for format in ["markdown", "junit"] {
        let run = kane(&["check", file, "--baseline", file, "--format", format]);
        assert_eq!(run.code, 0, "{}", run.stderr);
        assert!(!without_code(&run.stdout).contains("<img"), "{}", run.stdout);
    }
}
