//! Chromium, told what to do in its own protocol.
//!
//! Debian's `chromium` listens on two pipes (`--remote-debugging-pipe`) for JSON that ends in a zero byte. That takes
//! no port, no further program and no crate beside `serde_json`.

use std::io::{self, BufRead as _, BufReader, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use serde_json::{Value, json};

/// Seconds after which a browser is ended whatever it does, so that a test cannot hang.
const PATIENCE: &str = "300";

/// A browser with one page.
pub(crate) struct Chromium {
    child: Child,
    to: ChildStdin,
    from: BufReader<ChildStdout>,
    page: Option<String>,
    calls: u64,
    /// what the browser has told unasked since the page was opened
    events: Vec<Value>,
}

/// The program, if it is installed.
pub(crate) fn installed() -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    let names = ["chromium", "chromium-browser", "google-chrome"];
    std::env::split_paths(&path)
        .flat_map(|dir| names.map(|name| dir.join(name)))
        .find(|file| file.is_file())
}

/// Says on the terminal, past the test harness, that a test is skipped; where the program must be there, fails.
pub(crate) fn skip(program: &str, required_by: &str) {
    assert!(
        std::env::var_os(required_by).is_none_or(|value| value.is_empty()),
        "{required_by} is set, but {program} is not installed"
    );
    let _ = writeln!(io::stderr(), "skipped: {program} is not installed");
}

impl Chromium {
    /// Starts the program with a profile of its own, which must not exist.
    pub(crate) fn start(program: &Path, profile: &Path) -> Self {
        let mut child = Command::new("sh")
            // the protocol's pipes are 3 and 4; what the program prints is of no interest
            .args(["-c", r#"exec timeout "$@" 3<&0 4>&1 0</dev/null 1>/dev/null"#, "sh", PATIENCE])
            .arg(program)
            .args(["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run"])
            .args(["--disable-background-networking", "--disable-component-update"])
            .args(["--disable-sync", "--remote-debugging-pipe"])
            .arg(format!("--user-data-dir={}", profile.display()))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("a shell starts");
        let to = child.stdin.take().expect("it is piped");
        let from = BufReader::new(child.stdout.take().expect("it is piped"));
        let mut chromium = Self { child, to, from, page: None, calls: 0, events: Vec::new() };
        let made = chromium.call("Target.createTarget", json!({ "url": "about:blank" }));
        let target = json!({ "targetId": made["targetId"], "flatten": true });
        let session = chromium.call("Target.attachToTarget", target);
        chromium.page = session["sessionId"].as_str().map(str::to_owned);
        for domain in ["Page", "Runtime", "Network", "Log"] {
            chromium.call(&format!("{domain}.enable"), json!({}));
        }
        chromium
    }

    /// Calls a method and returns its result.
    pub(crate) fn call(&mut self, method: &str, params: Value) -> Value {
        self.calls += 1;
        let mut message = json!({ "id": self.calls, "method": method, "params": params });
        if let Some(page) = &self.page {
            message["sessionId"] = json!(page);
        }
        self.to.write_all(format!("{message}\0").as_bytes()).expect("the browser listens");
        loop {
            let mut answer = self.receive();
            if answer["id"] == self.calls {
                assert!(answer["error"].is_null(), "{method}: {}", answer["error"]);
                return answer["result"].take();
            }
            self.events.push(answer);
        }
    }

    fn receive(&mut self) -> Value {
        let mut bytes = Vec::new();
        self.from.read_until(0, &mut bytes).expect("the browser answers");
        bytes.pop();
        serde_json::from_slice(&bytes).expect("the browser lives and speaks JSON")
    }

    /// Opens the page in a window of this width, in the scheme `light` or `dark`, and waits until it is there.
    pub(crate) fn open(&mut self, url: &str, width: usize, scheme: &str) {
        self.call(
            "Emulation.setDeviceMetricsOverride",
            json!({ "width": width, "height": 900, "deviceScaleFactor": 1, "mobile": false }),
        );
        let features = json!([
            { "name": "prefers-color-scheme", "value": scheme },
            // places are exact at once
            { "name": "prefers-reduced-motion", "value": "reduce" },
        ]);
        self.call("Emulation.setEmulatedMedia", json!({ "features": features }));
        // another page first: going to an address that differs in its anchor alone would load nothing
        for address in ["about:blank", url] {
            self.events.clear();
            self.call("Page.navigate", json!({ "url": address }));
            while !self.told("Page.loadEventFired") {
                let event = self.receive();
                self.events.push(event);
            }
        }
    }

    /// Whether an event of this name has come since the page was opened.
    pub(crate) fn told(&self, method: &str) -> bool {
        self.events(method).next().is_some()
    }

    /// The parameters of all events of this name since the page was opened.
    pub(crate) fn events<'a>(&'a self, method: &'a str) -> impl Iterator<Item = &'a Value> {
        let named = self.events.iter().filter(move |event| event["method"] == method);
        named.map(|event| &event["params"])
    }

    /// The value of an expression in the page.
    pub(crate) fn value(&mut self, expression: &str) -> Value {
        let asked =
            json!({ "expression": expression, "returnByValue": true, "awaitPromise": true });
        let mut answer = self.call("Runtime.evaluate", asked);
        assert!(answer["exceptionDetails"].is_null(), "{expression}: {answer}");
        answer["result"]["value"].take()
    }

    /// Presses and releases the mouse at a place of the window.
    pub(crate) fn click(&mut self, x: f64, y: f64) {
        for kind in ["mouseMoved", "mousePressed", "mouseReleased"] {
            let event = json!({ "type": kind, "x": x, "y": y, "button": "left", "clickCount": 1 });
            self.call("Input.dispatchMouseEvent", event);
        }
    }

    /// Presses and releases the Enter key.
    pub(crate) fn enter(&mut self) {
        for (kind, text) in [("keyDown", "\r"), ("keyUp", "")] {
            let event = json!({
                "type": kind, "key": "Enter", "code": "Enter", "windowsVirtualKeyCode": 13, "text": text,
            });
            self.call("Input.dispatchKeyEvent", event);
        }
    }
}

impl Drop for Chromium {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
