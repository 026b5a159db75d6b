//! The report of a small audit, in every format.

use kane::audit::{Options, read};
use kane::judges::{Answer, Judge};
use kane::report::{Page, Report, certificates, explain, html, json, latex, markdown, text};

use crate::fixture::audit;
use crate::schemas::assert_valid;
use crate::settings;

/// Compares with `snapshots/reports/NAME.snap`.
fn assert_report(name: &str, shown: &str) {
    settings().bind(|| insta::assert_snapshot!(name, shown));
}

#[test]
fn text_in_a_file_lets_reasons_run_on() {
    let audit = audit();
    assert_report("text_file", &text(&Report::new(&audit, "kane audit wall.md"), Page::default()));
}

#[test]
fn text_on_a_terminal_fits_it_and_shows_surprises_in_red() {
    let audit = audit();
    let page = Page { width: Some(90), colour: true };
    let shown = text(&Report::new(&audit, "kane audit wall.md"), page);
    assert_report("text_terminal", &shown.replace('\u{1b}', "ESC"));
}

#[test]
fn a_narrow_page_is_never_overrun() {
    let audit = audit();
    let report = Report::new(&audit, "kane audit wall.md");
    for width in [0, 10, 20, 40, 60, 80, 120] {
        let shown = text(&report, Page { width: Some(width), colour: false });
        let table = shown.split("\n\n").nth(1).expect("a table follows the news");
        for line in table.lines() {
            // the verdict and the label are always shown in full
            assert!(line.chars().count() <= width.max(22), "{width} columns, but: {line}");
        }
    }
}

#[test]
fn one_statement_alone() {
    let audit = audit();
    let report = Report::new(&audit, "kane audit --only 16 wall.md").only(&[4]);
    assert_report("text_only", &text(&report, Page::default()));
}

#[test]
fn markdown_of_every_verdict() {
    let audit = audit();
    assert_report("markdown", &markdown(&Report::new(&audit, "kane audit wall.md")));
}

#[test]
fn a_statement_is_set_as_its_author_wrote_it() {
    let text = "```kane\nvar t, a > 0, theta(t), w(t) in R^3, J in R^3x3\n\
                let T := dot(w, J*w)/2\nlet h(x) := a*x^2\n\
                given euler: J*d(w, t) = -cross(w, J*w)\n\
                claim double: sin(2*theta) = 2*sin(theta)*cos(theta)\n\
                claim scaled: h(2*a)/h(a) = 4 when a > 1\n\
                claim plain: a/(1 + a)^2 < 1\n```\n";
    let document = read("top.md", text.as_bytes()).expect("it can be read");
    let audit = kane::audit::audit(document, &Options::default(), &mut |_, _| {});
    let report = Report::new(&audit, "kane audit top.md");
    let shown = markdown(&report);
    let formulas: Vec<&str> = shown
        .split("```math\n")
        .skip(1)
        .map(|rest| rest.split_once("\n```").expect("it ends").0)
        .collect();
    insta::assert_snapshot!(formulas.join("\n"), @r"
    \cos(\theta)^{2} + \sin(\theta)^{2} = 1
    T := \frac{w \cdot (J w)}{2}
    h(x) := a x^{2}
    J \frac{d w}{d t} = -w \times (J w)
    \sin(2 \theta) = 2 \sin(\theta) \cos(\theta)
    \frac{h(2 a)}{h(a)} = 4 \quad\text{when } a > 1
    \frac{a}{(1 + a)^{2}} < 1
    ");
    let page = html(&report);
    let folded = page.matches("<summary>written out</summary>").count();
    assert_eq!(folded, 4, "what is judged stands below what is written in another way");
    for formula in ["w \\cdot (J w)", "\\sin(2 \\theta)", "-w \\times (J w)"] {
        assert!(latex(&report).contains(formula), "{formula}");
    }
}

#[test]
fn json_of_every_verdict() {
    let audit = audit();
    let report = Report::new(&audit, "kane audit wall.md");
    assert_valid("certificate", &certificates(&report));
    let json = json(&[report]);
    assert_valid("audit", &json);
    assert_report("json", &json);
}

#[test]
fn an_explanation_can_be_followed_on_paper() {
    let audit = audit();
    let all = (0..audit.document.statements.len()).filter_map(|index| explain(&audit, index));
    assert_report("explain", &all.collect::<Vec<_>>().join("\n----\n"));
}

#[test]
fn a_page_of_every_verdict() {
    let audit = audit();
    let shown = html(&Report::new(&audit, "kane audit wall.md"));
    // style and script are files of their own in the source; the snapshot shows what they are applied to
    let body = shown.split_once("<body>").expect("it has a body").1;
    let body = body.split_once("<script>").expect("it ends in a script").0;
    // a tag a line, for whoever compares two of them
    assert_report("html", &body.replace("><", ">\n<"));
}

/// What the page says before the words of a document with these lines in it.
fn findings(lines: &str) -> String {
    let text = format!("# Fall\n\n```kane\n{lines}```\n");
    let document = read("fall.md", text.as_bytes()).expect("it can be read");
    let audit = kane::audit::audit(document, &Options::default(), &mut |_, _| {});
    let page = html(&Report::new(&audit, "kane audit fall.md"));
    page.split_once("<section class=\"findings\"").map_or_else(String::new, |(_, rest)| {
        rest.split_once("</section>").map_or(rest, |(section, _)| section).to_owned()
    })
}

#[test]
fn a_page_begins_with_what_fails_and_what_is_proved_in_its_place() {
    let fall = "var g > 0, t > 0, v\ngiven law: v = -g*t\n";
    let told = findings(&format!(
        "{fall}claim (1): v = g*t from law expect refuted\nclaim repair: v = -g*t from law\n\
         claim other: v < 0 from law\nclaim on: v^2 = g^2*t^2 from (1)\n"
    ));
    for part in
        [">(1)</a>", "From the same, proved: <a href=\"#s-repair\"", "Cited by <a href=\"#s-on\""]
    {
        assert!(told.contains(part), "{part} in {told}");
    }
    assert!(!told.contains("s-other"), "another left side, in {told}");
    assert_eq!(findings(&format!("{fall}claim repair: v = -g*t from law\n")), "");
}

/// A claim of the same left side from more, or under other conditions, is none in its place.
#[test]
fn what_is_proved_from_more_is_not_said_to_be_from_the_same() {
    let told = findings(
        "var x, y\ngiven a: x >= 1\ngiven b: y = 2*x\nclaim wrong: y = x from a\n\
         claim more: y = 2*x from a, b\nclaim narrow: y = 2*x when x > 3 from b\n",
    );
    assert!(told.contains("s-wrong") && !told.contains("From the same"), "{told}");
}

#[test]
fn a_page_of_one_statement_leads_nowhere_else() {
    let audit = audit();
    let shown = html(&Report::new(&audit, "kane audit --only 16 wall.md").only(&[4]));
    assert_eq!(shown.matches("<article").count(), 1);
    for link in shown.split("href=\"#").skip(1) {
        let anchor = link.split('"').next().expect("it is closed");
        assert!(shown.contains(&format!("id=\"{anchor}\"")), "#{anchor} leads nowhere");
    }
}

#[test]
fn latex_of_every_verdict() {
    let audit = audit();
    let shown = latex(&Report::new(&audit, "kane audit wall.md"));
    let body = shown.split_once("\\begin{document}").expect("it has a body").1;
    assert_report("latex", body);
}

#[test]
fn a_limit_by_bounds_is_told_in_each_notation() {
    let text = "```kane\nvar x > 0\nclaim root: sqrt(x + 1) -> 1 as x -> 0\n```\n";
    let document = kane::audit::read("root.md", text.as_bytes()).expect("it is well formed");
    let audit = kane::audit::audit(document, &Options::default(), &mut |_, _| {});
    let told = explain(&audit, 0).expect("it is a claim");
    assert!(
        told.contains("sqrt(x + 1) >= 1 - t") && told.contains("sqrt(x + 1) <= 1 + t"),
        "{told}"
    );
    let report = Report::new(&audit, "kane audit root.md");
    let set = latex(&report);
    assert!(set.contains("\\sqrt{x + 1} \\ge 1 - t") && !set.contains(['≤', '≥']), "{set}");
    assert!(html(&report).contains("</math> ≥ "), "the page has the sign itself");
}

#[test]
fn the_page_and_the_appendix_of_the_paper_hold_all_that_the_report_holds() {
    let bytes = include_bytes!("../../docs/derivations/oblique-collision.md");
    let document = kane::audit::read("oblique-collision.md", bytes).expect("it is well formed");
    let audit = kane::audit::audit(document, &Options::default(), &mut |_, _| {});
    let report = Report::new(&audit, "kane audit");
    let statements = audit.document.statements.len();

    let page = html(&report);
    // a fifth of it is pictures; a term of a proof takes twice the bytes in MathML that it takes as letters
    assert!(page.len() < 1_200_000, "{} bytes", page.len());
    assert_eq!(page, html(&report), "the same in every run");
    assert_eq!(page.matches("<article").count(), statements);
    assert!(!page.contains("class=\"tex\""), "every formula is converted");
    assert!(!page.contains("<merror"), "every formula is converted");
    for (index, start) in page.match_indices("href=\"") {
        let link = page[index + start.len()..].split('"').next().expect("it is closed");
        let anchor = link.strip_prefix('#').expect("it stays in the page");
        assert!(page.contains(&format!("id=\"{anchor}\"")), "#{anchor} leads nowhere");
    }
    let ids: Vec<_> = page.split(" id=\"").skip(1).map(|rest| rest.split('"').next()).collect();
    let mut distinct = ids.clone();
    distinct.sort_unstable();
    distinct.dedup();
    assert_eq!(ids.len(), distinct.len(), "no two elements share an anchor");
    let certificates = audit.judgements.iter().flat_map(|j| &j.links).flat_map(|l| &l.certificate);
    let appendix = latex(&report);
    for certificate in certificates {
        assert!(page.contains(certificate) && appendix.contains(certificate), "{certificate}");
    }
    assert_eq!(appendix.matches("\n\\statement{").count(), statements);
    for text in [&page, &appendix] {
        // of the document, as `sha256sum` tells it
        assert!(text.contains(&audit.document.sha256()));
    }
}

/// Of two judges one accepts a claim, denies another and was not asked a third; the other is not installed.
#[test]
fn answers_of_other_judges_stand_beside_each_claim() {
    let audit = audit();
    let at = |label: &str| audit.document.statements.iter().position(|s| s.label == label);
    let at = |label: &str| at(label).expect("the statement is there");
    let answers = [
        ((at("(16)"), 0), Answer::Agrees),
        ((at("(1)"), 0), Answer::Disagrees("it is <true>".to_owned())),
        ((at("range"), 0), Answer::Agrees),
        ((at("range"), 1), Answer::Undecided("no answer within 10 s".to_owned())),
        ((at("μ-lim"), 0), Answer::NotAsked("not emitted: a limit".to_owned())),
    ];
    let judges = [
        Judge {
            name: "z3".to_owned(),
            answers: answers.into_iter().collect(),
            asked: true,
            axioms: Vec::new(),
        },
        Judge { name: "Coq".to_owned(), ..Judge::default() },
    ];
    let without = Report::new(&audit, "kane audit wall.md");
    let report = without.clone().with_judges(&judges);
    let page = html(&report);
    let note = |label: &str| {
        let (_, article) = page.split_once(&format!("id=\"s-{label}\"")).expect("a statement");
        article.split("</article>").next().expect("it is closed").to_owned()
    };
    assert!(note("16").contains("✓</span> z3: agrees</p>"), "{}", note("16"));
    assert!(note("16").contains("?</span> Coq: not checked</p>"), "{}", note("16"));
    assert!(note("1").contains("✗</span> z3: DISAGREES; it is &lt;true&gt;</p>"), "{}", note("1"));
    assert!(note("1").contains("judge surprise"), "a disagreement stands out");
    let half = "?</span> z3: 1 agrees, 1 undecided; no answer within 10 s</p>";
    assert!(note("range").contains(half), "{}", note("range"));
    assert!(note("_-lim").contains("z3: not asked; not emitted: a limit"), "{}", note("_-lim"));
    assert!(!note("2").contains("z3"), "a premise is put to nobody");

    let news = ["z3: 1 DISAGREE, 2 agree, 1 undecided, 1 not asked", "Coq: NOT CHECKED"];
    for (form, text) in [("html", &page), ("md", &markdown(&report)), ("tex", &latex(&report))] {
        for line in news {
            let at = text.find(line).unwrap_or_else(|| panic!("{line} is not in {form}"));
            let first = text.find("(16)").expect("the first statements");
            assert!(form == "html" || at < first, "{form}: it comes first");
        }
    }
    assert!(latex(&report).contains("z3: DISAGREES; it is"));
    assert!(markdown(&report).contains("| (1) | refuted | DISAGREES | not checked |"));
    let value: serde_json::Value =
        serde_json::from_str(&json(std::slice::from_ref(&report))).expect("it is JSON");
    assert!(value["judges"][0]["summary"]["z3"].as_str().is_some_and(|s| s == news[0]));
    // the head of the page has a font in it, in letters and digits
    let page = html(&without);
    let body = page.split_once("<body>").expect("a body").1.to_owned();
    for text in [body, markdown(&without), latex(&without), json(&[without])] {
        assert!(!text.contains("z3") && !text.contains("\"judges\""), "nobody was asked");
    }
}

#[test]
fn the_digest_is_that_of_sha_256() {
    // FIPS 180-2, appendix B.1, gives the digest of `abc`
    let document = kane::audit::read("abc.md", b"abc").expect("a text without statements");
    let expected = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
    assert_eq!(document.sha256(), expected);
}

#[test]
fn the_title_of_a_section_fits_into_a_graph_of_one_column() {
    let text = "# D\n\n```kane\nvar m > 0\nclaim a: m + 1 > 0\n```\n";
    let document = read("d.md", text.as_bytes()).expect("it is well formed");
    let audit = kane::audit::audit(document, &Options::default(), &mut |_, _| {});
    let page = html(&Report::new(&audit, "kane audit d.md"));
    let (before, _) = page.split_once(">Before the first section</text>").expect("it has a title");
    let (_, svg) = before.rsplit_once("viewBox=\"0 0 ").expect("in a picture");
    let width: u32 = svg.split_once(' ').expect("a size").0.parse().expect("a number");
    // letters of 7 pixels, and a margin at either side
    assert!(width >= 7 * 24 + 24, "{width}");
}
