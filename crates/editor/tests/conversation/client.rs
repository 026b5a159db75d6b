//! A scripted editor.

use std::io::{self, BufRead, BufReader, PipeReader, PipeWriter, Read, Write};
use std::thread::{self, JoinHandle};

use kane_editor::{End, serve};
use serde_json::{Value, json};

/// An editor, and the server that it talks with, in a thread.
pub(crate) struct Client {
    to: Option<PipeWriter>,
    from: BufReader<PipeReader>,
    server: JoinHandle<io::Result<End>>,
    asked: i64,
    /// messages that came while something else was waited for
    passed: Vec<Value>,
}

pub(crate) const URI: &str = "file:///papers/d.md";

impl Client {
    /// Before `initialize`.
    pub(crate) fn silent() -> Self {
        let (input, to) = io::pipe().expect("there are pipes");
        let (from, output) = io::pipe().expect("there are pipes");
        let server = thread::spawn(move || serve(input, output));
        let from = BufReader::new(from);
        Self { to: Some(to), from, server, asked: 0, passed: Vec::new() }
    }

    pub(crate) fn new() -> Self {
        let mut client = Self::silent();
        let answer = client.ask("initialize", &json!({ "capabilities": {} }));
        assert_eq!(answer["result"]["capabilities"]["hoverProvider"], true);
        client.say("initialized", &json!({}));
        client
    }

    pub(crate) fn raw(&mut self, bytes: &[u8]) {
        self.to.as_mut().expect("it is open").write_all(bytes).expect("the server reads");
    }

    fn send(&mut self, message: &Value) {
        let body = message.to_string();
        self.raw(format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes());
    }

    pub(crate) fn say(&mut self, method: &str, params: &Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// Sends a request; its id.
    pub(crate) fn begin(&mut self, method: &str, params: &Value) -> i64 {
        self.asked += 1;
        let id = self.asked;
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        id
    }

    /// Sends a request and waits for the answer.
    pub(crate) fn ask(&mut self, method: &str, params: &Value) -> Value {
        let id = self.begin(method, params);
        self.answer(&json!(id))
    }

    /// The answer to a request.
    pub(crate) fn answer(&mut self, id: &Value) -> Value {
        self.wait(|message| message.get("method").is_none() && message["id"] == *id)
    }

    /// The next message of this kind.
    pub(crate) fn wait(&mut self, wanted: impl Fn(&Value) -> bool) -> Value {
        if let Some(at) = self.passed.iter().position(&wanted) {
            return self.passed.remove(at);
        }
        loop {
            let message = self.next().expect("the server goes on");
            if wanted(&message) {
                return message;
            }
            self.passed.push(message);
        }
    }

    fn next(&mut self) -> Option<Value> {
        let mut length = 0;
        loop {
            let mut line = String::new();
            if self.from.read_line(&mut line).expect("it is text") == 0 {
                return None;
            }
            if line == "\r\n" {
                break;
            }
            if let Some(value) = line.strip_prefix("Content-Length: ") {
                length = value.trim().parse().expect("it is a number");
            }
        }
        let mut body = vec![0; length];
        self.from.read_exact(&mut body).expect("the message is whole");
        Some(serde_json::from_slice(&body).expect("it is JSON"))
    }

    pub(crate) fn open(&mut self, text: &str) {
        let document = json!({ "uri": URI, "languageId": "markdown", "version": 1, "text": text });
        self.say("textDocument/didOpen", &json!({ "textDocument": document }));
    }

    /// Replaces the whole text.
    pub(crate) fn replace(&mut self, version: i64, text: &str) {
        self.change(version, &json!([{ "text": text }]));
    }

    pub(crate) fn change(&mut self, version: i64, changes: &Value) {
        let document = json!({ "uri": URI, "version": version });
        let params = json!({ "textDocument": document, "contentChanges": changes });
        self.say("textDocument/didChange", &params);
    }

    /// The diagnostics of a version.
    pub(crate) fn diagnostics(&mut self, version: i64) -> Vec<Value> {
        let said = self.wait(|message| {
            message["method"] == "textDocument/publishDiagnostics"
                && message["params"]["version"] == version
        });
        said["params"]["diagnostics"].as_array().expect("they are a list").clone()
    }

    /// What is asked at a place of the document.
    pub(crate) fn at(&mut self, method: &str, (line, character): (u64, u64)) -> Value {
        let position = json!({ "line": line, "character": character });
        let params = json!({ "textDocument": { "uri": URI }, "position": position });
        let answer = self.ask(method, &params);
        assert!(answer.get("error").is_none(), "{answer}");
        answer["result"].clone()
    }

    pub(crate) fn rename(&mut self, (line, character): (u64, u64), new: &str) -> Value {
        let position = json!({ "line": line, "character": character });
        let uri = json!({ "uri": URI });
        let params = json!({ "textDocument": uri, "position": position, "newName": new });
        self.ask("textDocument/rename", &params)
    }

    /// The verdicts in the margin of all lines: line and words.
    pub(crate) fn margin(&mut self) -> Vec<(u64, String)> {
        let range = json!({
            "start": { "line": 0, "character": 0 },
            "end": { "line": 1_000_000, "character": 0 },
        });
        let params = json!({ "textDocument": { "uri": URI }, "range": range });
        let answer = self.ask("textDocument/inlayHint", &params);
        let hints = answer["result"].as_array().expect("it is a list").clone();
        let told = |hint: &Value| {
            let line = hint["position"]["line"].as_u64().expect("it is a number");
            (line, hint["label"].as_str().expect("it is text").to_owned())
        };
        hints.iter().map(told).collect()
    }

    /// How the conversation ends, with everything that was still said.
    pub(crate) fn hang_up(mut self) -> io::Result<End> {
        self.to = None;
        while self.next().is_some() {}
        self.server.join().expect("the server does not panic")
    }
}
