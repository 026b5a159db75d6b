//! Editors that say what makes no sense. None of it ends the conversation, or shows a wrong verdict.

use serde_json::{Value, json};

use crate::WALL;
use crate::client::{Client, URI};

impl Client {
    /// The code of the error that a request without sense gets.
    pub(crate) fn at_error(&mut self, method: &str) -> i64 {
        let answer = self.ask(method, &Value::Null);
        answer["error"]["code"].as_i64().expect("it is an error")
    }
}

#[test]
fn what_is_no_message_gets_an_error_and_the_next_one_its_answer() {
    let mut client = Client::new();
    let nested = "[".repeat(50_000);
    for body in ["{", "null", "[]", "{\"id\": 1}", "\u{fffe}", "{\"method\": 3}", "true", &nested] {
        client.raw(format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes());
        let answer = client.answer(&Value::Null);
        assert_eq!(answer["error"]["code"], -32700, "{body}");
    }
    client.raw(b"Content-Length: 4\r\nContent-Type: text\r\n\r\n\xff\xfe\x00{");
    assert_eq!(client.answer(&Value::Null)["error"]["code"], -32700);
    client.open(WALL);
    assert_eq!(client.margin().len(), 3);
}

#[test]
fn a_stream_that_is_no_conversation_is_an_error() {
    for bytes in [&b"hello\n"[..], b"Content-Length: x\r\n\r\n", b"\r\n\r\n", b"\xff\xff\n"] {
        let mut client = Client::silent();
        client.raw(bytes);
        assert!(client.hang_up().is_err());
    }
}

#[test]
fn nothing_is_answered_before_initialize_and_it_comes_once() {
    let mut client = Client::silent();
    assert_eq!(client.at_error("textDocument/hover"), -32002);
    assert_eq!(client.at_error("shutdown"), -32002);
    let answer = client.ask("initialize", &json!({}));
    assert_eq!(answer["result"]["serverInfo"]["name"], "kane");
    assert_eq!(client.at_error("initialize"), -32600);
}

#[test]
fn requests_without_sense_get_errors() {
    let mut client = Client::new();
    client.open(WALL);
    assert_eq!(client.at_error("kane/fly"), -32601);
    let methods = [
        "hover",
        "inlayHint",
        "definition",
        "references",
        "prepareRename",
        "completion",
        "rename",
        "documentSymbol",
    ];
    let place = |line: Value| json!({ "line": line, "character": 0 });
    let params = [
        json!(null),
        json!([1, 2]),
        json!({ "textDocument": 3 }),
        json!({ "textDocument": { "uri": "file:///other.md" }, "position": place(json!(0)) }),
    ];
    let placed = [json!(-1), json!(1.5), json!("0"), json!(null), json!({}), json!([0])];
    for method in methods {
        let method = format!("textDocument/{method}");
        for params in &params {
            let answer = client.ask(&method, params);
            assert!(answer["error"]["code"].is_i64(), "{method} {params} {answer}");
        }
        for line in placed.iter().filter(|_| !method.ends_with("documentSymbol")) {
            let range = json!({ "start": place(line.clone()), "end": place(line.clone()) });
            let uri = json!({ "uri": URI });
            let position = place(line.clone());
            let params = json!({ "textDocument": uri, "position": position, "range": range, "newName": "z" });
            let answer = client.ask(&method, &params);
            assert!(answer["error"]["code"].is_i64(), "{method} {params} {answer}");
        }
    }
    // far outside of the text is its end, as the protocol has it
    let far = u64::MAX;
    assert_eq!(client.at("textDocument/hover", (far, far)), Value::Null);
    assert_eq!(client.at("textDocument/definition", (far, 0)), Value::Null);
    assert_eq!(client.margin().len(), 3);
}

#[test]
fn a_change_that_makes_no_sense_takes_the_verdicts_away() {
    let back =
        json!({ "start": { "line": 3, "character": 0 }, "end": { "line": 2, "character": 0 } });
    let changes = [
        json!([{ "range": back, "text": "x" }]),
        json!([{ "range": 3, "text": "x" }]),
        json!([3]),
        json!([{ "text": 7 }]),
    ];
    for change in changes {
        let mut client = Client::new();
        client.open(WALL);
        assert_eq!(client.diagnostics(1).len(), 1);
        client.change(2, &change);
        let empty = client.wait(|said| said["method"] == "textDocument/publishDiagnostics");
        assert_eq!(empty["params"]["diagnostics"], json!([]));
        client.wait(|said| said["method"] == "window/showMessage");
        let params =
            json!({ "textDocument": { "uri": URI }, "position": { "line": 6, "character": 2 } });
        let answer = client.ask("textDocument/hover", &params);
        assert!(answer["error"]["code"].is_i64(), "{answer}");
        // until it is opened again
        client.open(WALL);
        assert_eq!(client.margin().len(), 3);
    }
}

#[test]
fn notifications_about_nothing_change_nothing() {
    let mut client = Client::new();
    client.open(WALL);
    for method in ["didOpen", "didChange", "didClose", "didSave", "didFly"] {
        for params in [json!(null), json!([]), json!({ "textDocument": { "uri": 3 } })] {
            client.say(&format!("textDocument/{method}"), &params);
        }
        let other = json!({ "textDocument": { "uri": "file:///other.md", "version": 9 } });
        client.say(&format!("textDocument/{method}"), &other);
    }
    client.say("$/cancelRequest", &json!({ "id": 77 }));
    client.say("$/cancelRequest", &json!({ "id": { "a": 1 } }));
    assert_eq!(client.margin().len(), 3);
}

#[test]
fn a_huge_text_is_an_error_and_a_long_one_is_not() {
    let mut client = Client::new();
    client.open(&"x".repeat((16 << 20) + 1));
    let faults = client.diagnostics(1);
    assert!(faults[0]["message"].as_str().is_some_and(|said| said.contains("are the most")));
    let prose = "Prose with 𝛂 in it. ".repeat(20);
    let long = format!("{}{WALL}", format!("{prose}\n\n").repeat(2_000));
    client.replace(2, &long);
    assert_eq!(client.margin().len(), 3);
    let lines = vec!["```kane"; 300].join("\n");
    client.replace(3, &lines);
    assert!(!client.diagnostics(3).is_empty());
}

#[test]
fn what_a_document_says_stays_text() {
    let mut client = Client::new();
    let label = "````` <b>[x][command:y]</b>";
    client.open(&format!("# T\n\n````````kane\nvar x > 0\nclaim ({label}): x > 1\n````````\n"));
    assert_eq!(client.diagnostics(1).len(), 1);
    let hover = client.at("textDocument/hover", (4, 2));
    let shown = hover["contents"]["value"].as_str().expect("it is text").to_owned();
    let fence: String = shown.chars().take_while(|c| *c == '`').collect();
    assert!(fence.len() > 5 && shown.ends_with(&fence) && shown.contains(label), "{shown}");
}

#[test]
fn a_request_that_waits_is_cancelled_or_told_that_the_text_has_changed() {
    let mut client = Client::new();
    // takes a while, so that the requests wait
    let slow = "# T\n\n```kane\nvar x, y, z\nclaim a: x^8*y^2 + y^8*z^2 + z^8*x^2 + x^4*y^4*z^4 >= x*y*z - 1/1000\n```\n";
    client.open(slow);
    let params =
        json!({ "textDocument": { "uri": URI }, "position": { "line": 4, "character": 2 } });
    let cancelled = client.begin("textDocument/hover", &params);
    let changed = client.begin("textDocument/hover", &params);
    client.say("$/cancelRequest", &json!({ "id": cancelled }));
    client.replace(2, WALL);
    let codes = [cancelled, changed].map(|id| client.answer(&json!(id))["error"]["code"].clone());
    // each has one answer: where the claim was quick, the proof
    for (code, expected) in codes.iter().zip([-32800, -32801]) {
        assert!(*code == expected || code.is_null(), "{codes:?}");
    }
    assert_eq!(client.margin().len(), 3);
}
