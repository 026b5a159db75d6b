//! The shipped scenes as the program prints them, and the table of stress.

use std::path::Path;

use kane::impact::laws;
use kane::report::Page;
use kane::report::scene::{
    SceneReport, compare_picture, json, ledger_picture, models_csv, picture, sheet, states_csv,
    stress_csv, stress_picture,
};
use kane::scene::{Effort, answer, read, stress};

use crate::schemas::assert_valid;
use crate::{assert_kept, settings};

fn shipped(name: &str, effort: Effort, check: impl FnOnce(&SceneReport<'_>)) {
    let file = format!("docs/scenes/{name}.toml");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(&file);
    let source = read::load(&path).expect("the scene is shipped");
    let scene = read::scene(&file, &source).expect("it is well formed");
    let answer = answer(&scene, laws(), None, effort, &mut |_, _| {}).expect("it has an answer");
    let command = format!("kane scene {file}");
    let (title, is_compared) = (scene.title.clone(), effort == Effort::All);
    check(&SceneReport { answer: &answer, title, command, is_compared });
}

#[test]
fn every_shipped_scene_is_answered_and_drawn() {
    let names = [
        "alumina",
        "backspin",
        "billiard-cushion",
        "cradle-apart",
        "cradle-in-space",
        "cradle-touching",
        "discs",
        "double-pendulum",
        "dropped-rod",
        "paper-sphere",
        "putt",
        "rest",
        "rod-jam",
        "squeezed",
        "superball",
        "superball-groove",
        "table-tennis",
        "tennis-clay",
        "tumbling-brick",
        "two-spheres",
    ];
    for name in names {
        shipped(name, Effort::Chosen, |report| {
            let shown = sheet(report).text(Page::default());
            for line in shown.lines() {
                assert!(line.chars().count() <= 100, "more than 100 columns: {line}");
            }
            settings().bind(|| insta::assert_snapshot!(name, shown));
            assert_valid("scene", &json(report));
            // every scene has its picture; what flies into an impact has a ledger too
            let drawn = picture(report).expect("it has a picture");
            let shows = match name {
                "rod-jam" | "double-pendulum" => "impulse",
                "cradle-touching" => "contact",
                _ => "motion",
            };
            assert_eq!(drawn.name, shows, "{name}");
            let ledger = ledger_picture(report);
            let flies = report.answer.sums.last().is_some_and(|last| last.time > 0.0);
            assert_eq!(ledger.is_some(), shows == "motion" && flies, "{name}");
            for svg in std::iter::once(&drawn.svg).chain(&ledger) {
                assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
                assert!(!svg.contains("NaN"));
                // every curve and every mark is on the sheet
                for place in [" x=\"-", " y=\"-", " cx=\"-", " cy=\"-"] {
                    assert!(!svg.contains(place), "{name}: outside of the sheet");
                }
                let paths = svg.split(" d=\"").skip(1).filter_map(|rest| rest.split('"').next());
                for path in paths {
                    let is_outside = ["M-", "L-", " -"].iter().any(|place| path.contains(place));
                    assert!(!is_outside, "{name}: {path} is outside of the sheet");
                }
                assert!(svg.contains("<title>") && svg.contains("<desc>"), "{name}");
                assert!(svg.contains("prefers-color-scheme:dark"), "{name}");
            }
            assert_eq!(Some(drawn), picture(report), "the same in every run");
        });
    }
    let shipped = std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/scenes"));
    let files =
        shipped.expect("the scenes are shipped").map(|entry| entry.expect("readable").path());
    let scenes = files.filter(|path| path.extension().is_some_and(|end| end == "toml"));
    assert_eq!(scenes.count(), names.len(), "every scene has its snapshot");
}

#[test]
fn all_forms_of_a_report_tell_the_same() {
    shipped("backspin", Effort::All, |report| {
        assert_valid("scene", &json(report));
        let value: serde_json::Value = serde_json::from_str(&json(report)).expect("it is JSON");
        assert_eq!(value["chosen"], "routh-newton/f32");
        let models = value["models"].as_array().expect("a list");
        assert_eq!(models_csv(report).lines().count(), models.len() + 1);
        let impacts = value["impacts"].as_array().expect("a list");
        // one body: a row at the start, one an impact, one for the end, and the head
        assert_eq!(states_csv(report).lines().count(), impacts.len() + 3);
        assert!(sheet(report).markdown().contains("| `wang-su-li/f64` |"));
        let picture = compare_picture(report);
        assert!(picture.contains("routh-newton/f32, f64") || picture.contains("routh-newton/f64"));
    });
}

#[test]
fn the_page_holds_all_and_loads_nothing() {
    for name in ["alumina", "backspin", "rod-jam"] {
        shipped(name, Effort::Chosen, |report| {
            let page = sheet(report).html();
            assert_eq!(page, sheet(report).html(), "the same in every run");
            assert!(page.starts_with("<!DOCTYPE html>") && page.trim_end().ends_with("</html>"));
            // pictures and nothing from elsewhere
            let pictures = if report.answer.bounces.is_empty() { 1 } else { 2 };
            assert_eq!(page.matches("<svg").count(), pictures, "{name}");
            let without_font = page.replace("url(data:font/woff2;base64,", "");
            for loads in ["<img", "<link", "<script", "src=", "url(", "@import"] {
                assert!(!without_font.contains(loads), "{name}: {loads}");
            }
            for asked in &report.answer.lines {
                // a quantity is set for people, and has its name as a title
                let names = [
                    format!("<code>{}</code>", asked.quantity),
                    format!("title=\"{}\"", asked.quantity),
                ];
                assert!(names.iter().any(|name| page.contains(name)), "{name}");
            }
            for judged in &report.answer.judged {
                assert!(page.contains(&format!("<code>{}</code>", judged.model)), "{name}");
            }
            for place in ["id=\"why\"", "id=\"models\"", "footer", &report.command] {
                assert!(page.contains(place), "{name}: {place}");
            }
        });
    }
}

#[test]
fn the_committed_stress_is_the_program_s() {
    let rows = stress::rows(laws());
    let picture = stress_picture(&rows);
    for (file, shown) in
        [("docs/data/scene-stress.csv", stress_csv(&rows)), ("docs/data/scene-stress.svg", picture)]
    {
        assert_kept(file, &shown);
    }
}
