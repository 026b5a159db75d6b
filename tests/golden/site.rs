//! A site: its index as text, that every link leads to something, and that nothing is loaded from elsewhere.

use std::collections::{BTreeMap, BTreeSet};

use kane::audit::{Audit, Options, audit, read};
use kane::figures::{experiment, figures, timed};
use kane::impact::laws;
use kane::matrix::{Selection, matrix};
use kane::measure::chart::{Effort, table};
use kane::measure::examine;
use kane::measure::growth::counted;
use kane::report::chart::ChartReport;
use kane::report::growth::GrowthReport;
use kane::report::matrix::MatrixReport;
use kane::report::scene::SceneReport;
use kane::report::site::{File, Site, index};
use kane::report::stability::StabilityReport;
use kane::report::{Page, Report};

use crate::schemas::{assert_valid, assert_valid_if_ours};
use crate::settings;

/// A document that is shipped, judged.
fn judged(stem: &str) -> Audit {
    let path = format!("{}/docs/derivations/{stem}.md", env!("CARGO_MANIFEST_DIR"));
    let bytes = std::fs::read(path).expect("it is shipped");
    let document = read(&format!("{stem}.md"), &bytes).expect("it is well formed");
    audit(document, &Options::default(), &mut |_, _| {})
}

/// Of some laws, some properties, the documents that take less than seconds, one scene, one collision; and with times
/// that were taken once.
#[test]
fn a_site_in_small() {
    let some = |ids: &[&str]| Some(ids.iter().map(|id| (*id).to_owned()).collect());
    let selection = Selection {
        laws: some(&["wang-su-li", "smith-1991", "kane-levinson", "brach", "keller-printed"]),
        properties: some(&["C1", "energy-tangential", "energy-sphere", "energy", "subdivision"]),
    };
    let matrix = matrix(laws(), &selection, &mut |_, _| {});
    let stems = ["oblique-collision", "bouncing-ball"];
    let audits: Vec<(&str, Audit)> = stems.iter().map(|stem| (*stem, judged(stem))).collect();
    let root = env!("CARGO_MANIFEST_DIR");
    let times = std::fs::read_to_string(format!("{root}/docs/data/times.csv")).expect("kept");
    let times = timed(table(), &times);
    let stability = examine(&audits[0].1.document, true, &mut |_, _| {});
    let growth = counted(Effort::Quick);
    let figures = figures(&mut |_, _| {}).expect("the half-space settles");
    let fits = experiment::fits(laws());
    let toml =
        |name: &str| std::fs::read_to_string(format!("{root}/docs/{name}")).expect("shipped");
    let (ball, pendulum) = (toml("scenes/backspin.toml"), toml("collisions/double-pendulum.toml"));
    let scene = kane::scene::read::scene("backspin.toml", &ball).expect("well formed");
    let effort = kane::scene::Effort::Chosen;
    let answer = kane::scene::answer(&scene, laws(), None, effort, &mut |_, _| {});
    let answer = answer.expect("it has an answer");
    let question = kane::scene::read::collision("double-pendulum.toml", &pendulum);
    let collision = kane::collide::answer(&question.expect("well formed"), laws());
    let collision = collision.expect("the bodies meet");
    let machine = String::new;
    let site = Site {
        audits: audits
            .iter()
            .map(|(stem, audit)| ((*stem).to_owned(), Report::new(audit, "kane audit")))
            .collect(),
        matrix: MatrixReport { matrix: &matrix, command: "kane laws".to_owned() },
        laws: include_str!("../../docs/laws.md"),
        chart: ChartReport {
            all: &times.methods,
            machine: times.machine.clone(),
            command: "kane chart".to_owned(),
        },
        stability: StabilityReport {
            stability: &stability,
            accounts: &[],
            command: "kane stability --full-line".to_owned(),
        },
        growth: GrowthReport { growth: &growth, machine: machine(), command: String::new() },
        figures: &figures,
        fits: &fits,
        collisions: vec![("double-pendulum".to_owned(), &collision)],
        scenes: vec![(
            "backspin".to_owned(),
            SceneReport {
                answer: &answer,
                title: scene.title.clone(),
                command: "kane scene docs/scenes/backspin.toml".to_owned(),
                is_compared: false,
            },
        )],
        command: "kane site --out DIR".to_owned(),
    };
    let shown = index(&site).text(Page::default());
    settings().bind(|| insta::assert_snapshot!("index", shown));
    let files = site.files();
    assert_eq!(files, site.files(), "the same in every run");
    every_link_leads_to_something(&files);
    nothing_is_loaded_from_elsewhere(&files);
    a_screen_reader_walks_through_every_page(&files);
    for (file, name) in [
        ("derivations/oblique-collision.json", "audit"),
        ("derivations/oblique-collision.cert.json", "certificate"),
        ("collisions/double-pendulum.json", "collide"),
        ("scenes/backspin.json", "scene"),
        ("laws.json", "laws"),
        ("chart.json", "chart"),
        ("stability.json", "stability"),
        ("growth.json", "growth"),
        ("index.json", "site"),
    ] {
        let found = files.iter().find(|found| found.name() == file).expect("the site has it");
        assert_valid(name, &found.text);
    }
    files.iter().for_each(|file| assert_valid_if_ours(&file.text));
    every_page_is_found_from_the_index_and_has_its_data(&files);
}

fn pages(files: &[File]) -> impl Iterator<Item = &File> {
    files.iter().filter(|file| file.path.ends_with(".html"))
}

/// The values of an attribute, with quotes or without, that stand behind these words.
fn addresses<'a>(page: &'a str, before: &str) -> Vec<&'a str> {
    let value = |rest: &'a str| match rest.strip_prefix('"') {
        Some(rest) => rest.split('"').next(),
        None => rest.split([' ', '>']).next(),
    };
    page.split(before).skip(1).filter_map(value).collect()
}

/// Where an address leads, seen from a page: a file of the site and a place in it; `None` for the web.
fn target(page: &str, address: &str) -> Option<(String, String)> {
    if address.contains("://") || address.starts_with("mailto:") {
        return None;
    }
    let (file, place) = address.split_once('#').unwrap_or((address, ""));
    if file.is_empty() {
        return Some((page.to_owned(), place.to_owned()));
    }
    let mut parts: Vec<&str> = page.split('/').collect();
    parts.pop();
    for part in file.split('/') {
        match part {
            ".." => _ = parts.pop().expect("no link leaves the site"),
            part => parts.push(part),
        }
    }
    Some((parts.join("/"), place.to_owned()))
}

fn every_link_leads_to_something(files: &[File]) {
    let ids: BTreeMap<&str, BTreeSet<&str>> = files
        .iter()
        .map(|file| (file.path.as_str(), addresses(&file.text, " id=").into_iter().collect()))
        .collect();
    let mut between = 0;
    for page in pages(files) {
        for address in addresses(&page.text, "href=") {
            let Some((file, place)) = target(&page.path, address) else { continue };
            let ids = ids.get(file.as_str());
            assert!(ids.is_some(), "{}: {address} leads nowhere", page.path);
            let is_there = ids.is_some_and(|ids| ids.contains(place.as_str()));
            assert!(place.is_empty() || is_there, "{}: {address} has no such place", page.path);
            between += usize::from(file != page.path);
        }
    }
    assert!(between > 100, "{between} links between files");
    assert_eq!(target("a/b.html", "../c.html#d"), Some(("c.html".to_owned(), "d".to_owned())));
}

/// A page loads what the site's pages share, and nothing else: its policy says so, and what it names is there.
fn nothing_is_loaded_from_elsewhere(files: &[File]) {
    let has = |path: &str| files.iter().any(|file| file.path == path);
    let mut used = BTreeSet::new();
    for page in pages(files) {
        let head = page.text.split("</head>").next().expect("a head");
        let policy = "default-src 'none'; style-src 'self'; script-src 'self'; font-src data:;";
        assert!(head.contains(policy), "{}", page.path);
        let styles = addresses(head, "<link rel=stylesheet href=");
        let scripts = addresses(&page.text, "<script src=");
        for address in styles.iter().chain(&scripts) {
            let (file, _) = target(&page.path, address).expect("it is beside the page");
            assert!(has(&file), "{}: {address} is not there", page.path);
            used.insert(file);
        }
        let fonts = styles.iter().filter(|style| style.ends_with("/maths.css")).count();
        assert_eq!(fonts, usize::from(page.text.contains("<math")), "{}", page.path);
        let loaded = page.text.matches("<link").count() + page.text.matches(" src=").count();
        assert_eq!(loaded, styles.len() + scripts.len(), "{}", page.path);
        for other in ["<style", "url(", "<img", "<iframe", "@import", " style="] {
            assert!(!page.text.contains(other), "{}: {other}", page.path);
        }
    }
    let shared: BTreeSet<String> = files
        .iter()
        .map(|file| file.path.clone())
        .filter(|path| path.starts_with("shared/"))
        .collect();
    assert_eq!(used, shared, "each shared file is used by a page");
    for file in files.iter().filter(|file| shared.contains(&file.path)) {
        let fonts = file.text.matches("url(data:font/woff2;base64,").count();
        assert_eq!(file.text.matches("url(").count(), fonts, "{}", file.path);
        assert!(!file.text.contains("@import"), "{}", file.path);
    }
}

/// The levels of headings in order, of elements and of those that are told to be headings.
fn headings(page: &str) -> Vec<u8> {
    let digit = |rest: &str| rest.bytes().next().filter(u8::is_ascii_digit).map(|byte| byte - b'0');
    let of = |mark: &'static str| {
        page.match_indices(mark)
            .filter_map(move |(at, _)| Some((at, digit(&page[at + mark.len()..])?)))
    };
    let all: BTreeMap<usize, u8> = of("<h").chain(of(" aria-level=")).collect();
    all.into_values().collect()
}

/// What a checker of accessible pages found once, so that it stays away: gaps between levels of headings, heads of columns
/// without a word, and regions of one name.
fn a_screen_reader_walks_through_every_page(files: &[File]) {
    for page in pages(files) {
        let mut last = 0;
        for level in headings(&page.text) {
            assert!(level <= last + 1, "{}: a heading {level} behind one of {last}", page.path);
            last = level;
        }
        assert!(last > 0, "{} has headings", page.path);
        let ends = ["</th>", "<th", "<td", "</tr>"];
        let is_empty = |cell: &&str| {
            cell.split_once('>').is_some_and(|c| ends.iter().any(|end| c.1.starts_with(end)))
        };
        let empty = page.text.split("<th").skip(1).filter(is_empty).count();
        assert_eq!(empty, 0, "{}: heads of columns without a word", page.path);
        let named = addresses(&page.text, "role=region aria-label=");
        let titles: Vec<&str> = page.text.split("<h2").skip(1).collect();
        for name in named {
            let twice = titles.iter().any(|title| title.contains(&format!(">{name}</h2>")));
            assert!(!twice, "{}: two regions are called {name}", page.path);
        }
    }
    assert_eq!(headings("<html><h1>a</h1><p aria-level=3></p><h2>"), [1, 3, 2]);
}

fn every_page_is_found_from_the_index_and_has_its_data(files: &[File]) {
    let index = files.iter().find(|file| file.path == "index.html").expect("an index");
    let led: BTreeSet<String> = addresses(&index.text, "href=")
        .into_iter()
        .filter_map(|address| target("index.html", address))
        .map(|(file, _)| file)
        .collect();
    for page in pages(files) {
        assert!(page.path == "index.html" || led.contains(&page.path), "{} is lost", page.path);
        let all = addresses(&page.text, "href=");
        assert!(all.iter().any(|to| to.ends_with("index.html#pages") || page.path == "index.html"));
        let is_data = |to: &&str| {
            let name = to.trim_end_matches(".gz");
            name.ends_with(".json") || name.ends_with(".csv")
        };
        let has_data = all.iter().any(is_data);
        assert!(has_data, "{} leads to no data", page.path);
    }
    assert_eq!(index.text.matches("<svg").count(), 4, "four pictures");
}
