//! The page of the paper in a browser. Without Chromium these tests are skipped, unless `KANE_REQUIRE_BROWSER` is set.

use std::path::PathBuf;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use serde_json::Value;

use crate::chromium::{Chromium, installed, skip};
use crate::{kane, scratch};

/// The directory with the reports of the paper.
static REPORTS: LazyLock<PathBuf> = LazyLock::new(|| {
    let dir = scratch("browser");
    let run = kane(&["audit", "--out", dir.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    dir
});

/// One browser for all tests: its start takes longer than what they do. It ends when this process closes its pipe.
static BROWSER: LazyLock<Option<Mutex<Chromium>>> = LazyLock::new(|| {
    let program = installed()?;
    Some(Mutex::new(Chromium::start(&program, &scratch("chromium"))))
});

/// The browser, or nothing and a message.
pub(crate) fn browser() -> Option<MutexGuard<'static, Chromium>> {
    if BROWSER.is_none() {
        skip("chromium", "KANE_REQUIRE_BROWSER");
    }
    BROWSER.as_ref().map(|browser| browser.lock().unwrap_or_else(PoisonError::into_inner))
}

fn address() -> String {
    format!("file://{}", REPORTS.join("oblique-collision.html").display())
}

/// The report of the same run for programs.
fn report() -> Value {
    let json = std::fs::read_to_string(REPORTS.join("oblique-collision.json"));
    serde_json::from_str(&json.expect("it was written")).expect("it is JSON")
}

/// How many elements are seen.
pub(crate) fn seen(browser: &mut Chromium, selector: &str) -> usize {
    let expression = format!(
        "[...document.querySelectorAll({selector:?})].filter(e => e.checkVisibility()).length"
    );
    number(&browser.value(&expression))
}

pub(crate) fn number(value: &Value) -> usize {
    value.as_u64().and_then(|number| usize::try_from(number).ok()).expect("a number")
}

/// Everything that a quiet page gives no cause for.
pub(crate) fn noise(browser: &Chromium, page: &str) -> Vec<String> {
    let requests = browser.events("Network.requestWillBeSent");
    // the font that a page has in it passes for a request, which asks nobody
    let is_own = |url: &str| url == page || url.starts_with("data:font/woff2;base64,");
    let foreign = requests.filter(|event| !event["request"]["url"].as_str().is_some_and(is_own));
    let complaints = ["Runtime.consoleAPICalled", "Runtime.exceptionThrown", "Log.entryAdded"];
    foreign
        .chain(complaints.iter().flat_map(|name| browser.events(name)))
        .map(ToString::to_string)
        .collect()
}

#[test]
fn the_page_loads_nothing_and_complains_of_nothing() {
    let Some(mut browser) = browser() else { return };
    let page = address();
    browser.open(&page, 1400, "light");
    browser.value("document.querySelectorAll('details').forEach(d => d.open = true)");
    assert_eq!(noise(&browser, &page), Vec::<String>::new());
    // this test would hear of it: a message, and a picture that the page's policy refuses
    browser.value("console.log('planted')");
    let refused = "new Promise(done => { const i = new Image(); i.onerror = () => done(1); i.src = 'http://127.0.0.1:9/' })";
    browser.value(refused);
    assert_eq!(browser.events("Runtime.consoleAPICalled").count(), 1);
    assert!(noise(&browser, &page).len() >= 2, "{:?}", noise(&browser, &page));
}

#[test]
fn a_filter_leaves_the_statements_of_its_verdict() {
    let Some(mut browser) = browser() else { return };
    browser.open(&address(), 1400, "light");
    let report = report();
    let document = &report["documents"][0];
    let all = document["statements"].as_array().expect("a list").len();
    let refuted = number(&document["summary"]["verdicts"]["refuted"]);
    assert_eq!(seen(&mut browser, "article"), all);
    browser.value(
        "document.querySelectorAll('input[name=v]:not([value=refuted])').forEach(b => b.click())",
    );
    assert_eq!(seen(&mut browser, "article"), refuted);
    assert_eq!(seen(&mut browser, "article.refuted"), refuted);
    assert_eq!(seen(&mut browser, "div.words"), 0);
    let told = browser.value("document.querySelector('.filter output').textContent");
    assert_eq!(told, format!("{refuted} of {all} statements"));
    // a link to a statement that is filtered away brings its verdict back
    browser
        .value("document.querySelector('article.refuted .cites a[href=\"#s-text-I_y\"]').click()");
    browser.value("new Promise(done => setTimeout(done, 50))");
    assert_eq!(seen(&mut browser, "#s-text-I_y"), 1);
}

#[test]
fn a_filter_leaves_the_statements_of_its_origin() {
    let Some(mut browser) = browser() else { return };
    browser.open(&address(), 1400, "light");
    browser.value(
        "document.querySelectorAll('input[name=o]:not([value=printed])').forEach(b => b.click())",
    );
    assert_eq!(seen(&mut browser, "article"), 29, "the equations of the paper");
    assert_eq!(seen(&mut browser, "article[data-o=printed]"), 29);
    // the words stay, and a link to what is filtered away brings its origin back
    assert!(seen(&mut browser, "div.words") > 10);
    browser.value("location.hash = '#s-jp-range'");
    browser.value("new Promise(done => setTimeout(done, 50))");
    assert_eq!(seen(&mut browser, "#s-jp-range"), 1);
}

#[test]
fn a_node_of_the_graph_leads_to_its_statement() {
    let Some(mut browser) = browser() else { return };
    browser.open(&address(), 1400, "light");
    let node = "document.querySelector('a.n[href=\"#s-16\"]')";
    let place = browser.value(&format!(
        "(() => {{ {node}.scrollIntoView({{ block: 'center', inline: 'center' }});
                   const r = {node}.getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2] }})()"
    ));
    let (x, y) = (place[0].as_f64().expect("a number"), place[1].as_f64().expect("a number"));
    browser.click(x, y);
    assert_eq!(browser.value("location.hash"), "#s-16");
    let top = browser.value("document.getElementById('s-16').getBoundingClientRect().top");
    let top = top.as_f64().expect("a number");
    assert!((0.0..900.0).contains(&top), "the statement is at {top} of a window 900 high");
    // and the graph tells what it rests on: (9) and (15) among others, not (25)
    browser.value(&format!("{node}.focus()"));
    let on = |label: &str| {
        format!("document.querySelector('a.n[href=\"#s-{label}\"]').classList.contains('on')")
    };
    for (label, picked) in [("16", true), ("9", true), ("15", true), ("17", true), ("25", false)] {
        assert_eq!(browser.value(&on(label)), picked, "({label})");
    }
}

#[test]
fn a_proof_unfolds_by_keyboard() {
    let Some(mut browser) = browser() else { return };
    browser.open(&address(), 1400, "light");
    let details = "document.querySelector('#s-16 > details')";
    assert_eq!(browser.value(&format!("{details}.open")), false);
    browser.value(&format!("{details}.querySelector('summary').focus()"));
    browser.enter();
    assert_eq!(browser.value(&format!("{details}.open")), true);
    assert_eq!(seen(&mut browser, "#s-16 .steps"), 1);
}

#[test]
fn the_page_fits_a_telephone_and_a_desk() {
    let Some(mut browser) = browser() else { return };
    for width in [400, 1400] {
        browser.open(&address(), width, "light");
        browser.value("document.querySelectorAll('details').forEach(d => d.open = true)");
        let reach = number(&browser.value("document.documentElement.scrollWidth"));
        assert!(reach <= width, "{reach} px in a window of {width}");
        // smallest letters outside of the graph, which scrolls and has its statement beside it
        let smallest = browser.value(
            "Math.min(...[...document.querySelectorAll('body *')]
                .filter(e => !e.closest('svg, math, sub, sup, script, .quiet') && e.checkVisibility()
                    && [...e.childNodes].some(n => n.nodeType === 3 && n.data.trim()))
                .map(e => parseFloat(getComputedStyle(e).fontSize)))",
        );
        let smallest = smallest.as_f64().expect("a number");
        assert!(smallest >= 11.0, "{smallest} px at {width}");
        // something wider than the window would be noticed
        browser.value("document.body.append(Object.assign(document.createElement('pre'), { style: 'width: 2000px', textContent: 'wide' }))");
        assert!(number(&browser.value("document.documentElement.scrollWidth")) > width);
    }
}

#[test]
fn text_stands_out_from_its_ground_in_both_schemes() {
    let Some(mut browser) = browser() else { return };
    for scheme in ["light", "dark"] {
        browser.open(&address(), 1400, scheme);
        let worst = browser.value(CONTRAST);
        let worst = worst.as_array().expect("a list");
        assert!(worst.len() > 300, "only {} colours were compared", worst.len());
        for pair in worst {
            // WCAG 2.2, success criterion 1.4.3, level AA
            assert!(pair[0].as_f64().expect("a number") >= 4.5, "{scheme}: {pair}");
        }
        let ground = browser.value("getComputedStyle(document.body).backgroundColor");
        let dark = ground == "rgb(21, 23, 26)";
        assert_eq!(dark, scheme == "dark", "{ground}");
        // a grey that is too close to both grounds would be noticed
        browser.value("document.querySelector('.counts').style.color = '#777'");
        let worst = browser.value(CONTRAST)[0][0].as_f64().expect("a number");
        assert!(worst < 4.5, "{worst}");
    }
}

/// The contrast of every text with what is behind it, by the formula of WCAG 2.2, with the text.
const CONTRAST: &str = r"(() => {
    const numbers = (colour) => colour.match(/[\d.]+/g).map(Number);
    const light = (colour) => {
        const [r, g, b] = numbers(colour).slice(0, 3).map((c) => c / 255)
            .map((c) => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const ground = (e) => {
        const drawn = e.closest('a.n')?.querySelector('rect');
        if (drawn) return getComputedStyle(drawn).fill;
        for (; e; e = e.parentElement) {
            const colour = getComputedStyle(e).backgroundColor;
            if (numbers(colour)[3] !== 0) return colour;
        }
        return 'rgb(255, 255, 255)';
    };
    const texts = [...document.querySelectorAll('body *')].filter((e) => !e.closest('script, title, .quiet')
        && e.checkVisibility() && [...e.childNodes].some((n) => n.nodeType === 3 && n.data.trim()));
    return texts.map((e) => {
        const style = getComputedStyle(e);
        const ink = e.closest('svg') ? style.fill : style.color;
        const [low, high] = [light(ink), light(ground(e))].sort((a, b) => a - b);
        return [(high + 0.05) / (low + 0.05), e.textContent.slice(0, 40), ink, ground(e)];
    }).sort((a, b) => a[0] - b[0]);
})()";

#[test]
fn without_scripts_everything_is_there_to_read() {
    let Some(mut browser) = browser() else { return };
    browser.call("Emulation.setScriptExecutionDisabled", serde_json::json!({ "value": true }));
    browser.open(&address(), 1400, "light");
    let statements = report()["documents"][0]["statements"].as_array().expect("a list").len();
    assert_eq!(seen(&mut browser, "article"), statements);
    assert_eq!(seen(&mut browser, "form.filter"), 0, "what needs a script is not offered");
    assert_eq!(browser.value("getComputedStyle(document.querySelector('.e')).opacity > 0"), true);
    browser.call("Emulation.setScriptExecutionDisabled", serde_json::json!({ "value": false }));
}
