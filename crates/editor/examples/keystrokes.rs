//! How long an editor waits for an answer: types into a document at many places, and prints the time from
//! each keystroke to the verdicts on the text with it.
//!
//! `cargo run --release -p kane-editor --example keystrokes -- docs/derivations/oblique-collision.md`

use std::io::{self, BufRead, BufReader, PipeReader, PipeWriter, Read, Write};
use std::time::{Duration, Instant};

use kane_editor::serve;
use serde_json::{Value, json};

/// Statements into which is typed.
const PLACES: usize = 12;

fn main() -> io::Result<()> {
    let path = std::env::args()
        .nth(1)
        .unwrap_or_else(|| "docs/derivations/oblique-collision.md".to_owned());
    let text = std::fs::read_to_string(&path)?;
    let (input, to) = io::pipe()?;
    let (from, output) = io::pipe()?;
    let server = std::thread::spawn(move || serve(input, output));
    let mut editor = Editor { to, from: BufReader::new(from), version: 0 };
    editor.send("initialize", Some(1), json!({ "capabilities": {} }))?;
    editor.send("initialized", None, json!({}))?;
    let open = editor.show(&text, true)?;
    println!("{path}: opened and judged in {} ms", open.as_millis());

    for (name, within) in [("a claim", "claim "), ("a given", "given "), ("a definition", "let ")] {
        let lines: Vec<usize> = text
            .match_indices(&format!("\n{within}"))
            .filter_map(|(at, _)| Some(at + 1 + text[at + 1..].find('\n')?))
            .collect();
        let step = lines.len().div_ceil(PLACES).max(1);
        let mut times = Vec::new();
        for end in lines.iter().step_by(step) {
            // blanks and a comment, letter by letter, and all of it taken back
            for typed in [" ", " #", " # x", "", " ", "  "] {
                let edited = format!("{}{typed}{}", &text[..*end], &text[*end..]);
                times.push(editor.show(&edited, false)?);
            }
        }
        report(&format!("typing at the end of {name}"), &mut times);
    }
    // what changes what a claim says: a digit of its formula
    let mut times = Vec::new();
    for (at, _) in text.match_indices("\nclaim ") {
        let line = &text[at + 1..][..text[at + 1..].find('\n').unwrap_or(0)];
        let Some(colon) = line.find(": ") else { continue };
        let Some(digit) = line[colon..].find(['1', '2']) else { continue };
        let place = at + 1 + colon + digit;
        let mut edited = text.clone();
        edited.replace_range(place..place + 1, "3");
        times.push(editor.show(&edited, false)?);
        times.push(editor.show(&text, false)?);
    }
    report("another digit in a claim, and back", &mut times);
    drop(editor);
    let _ = server.join();
    Ok(())
}

fn report(what: &str, times: &mut [Duration]) {
    times.sort_unstable();
    let at = |part: usize| times.get((times.len() * part / 100).min(times.len().saturating_sub(1)));
    let shown = |time: Option<&Duration>| time.map_or(0.0, |time| time.as_secs_f64() * 1e3);
    println!(
        "{what}: {} keystrokes; median {:.1} ms, 95 % within {:.1} ms, worst {:.1} ms",
        times.len(),
        shown(at(50)),
        shown(at(95)),
        shown(times.last()),
    );
}

struct Editor {
    to: PipeWriter,
    from: BufReader<PipeReader>,
    version: i64,
}

impl Editor {
    fn send(&mut self, method: &str, id: Option<i64>, params: Value) -> io::Result<()> {
        let mut message = json!({ "jsonrpc": "2.0", "method": method, "params": params });
        if let Some(id) = id {
            message["id"] = id.into();
        }
        let body = message.to_string();
        write!(self.to, "Content-Length: {}\r\n\r\n{body}", body.len())
    }

    /// Gives the server this text; the time until its diagnostics are there.
    fn show(&mut self, text: &str, is_first: bool) -> io::Result<Duration> {
        self.version += 1;
        let (uri, version) = ("file:///paper.md", self.version);
        let start = Instant::now();
        if is_first {
            let document =
                json!({ "uri": uri, "version": version, "languageId": "markdown", "text": text });
            self.send("textDocument/didOpen", None, json!({ "textDocument": document }))?;
        } else {
            let document = json!({ "uri": uri, "version": version });
            let changes = json!([{ "text": text }]);
            let params = json!({ "textDocument": document, "contentChanges": changes });
            self.send("textDocument/didChange", None, params)?;
        }
        while self.next()?["params"]["version"] != version {}
        Ok(start.elapsed())
    }

    fn next(&mut self) -> io::Result<Value> {
        let mut length = 0;
        loop {
            let mut line = String::new();
            if self.from.read_line(&mut line)? == 0 {
                return Err(io::Error::other("the server has ended"));
            }
            if line == "\r\n" {
                break;
            }
            if let Some(value) = line.strip_prefix("Content-Length: ") {
                length = value.trim().parse().map_err(io::Error::other)?;
            }
        }
        let mut body = vec![0; length];
        self.from.read_exact(&mut body)?;
        serde_json::from_slice(&body).map_err(io::Error::other)
    }
}
