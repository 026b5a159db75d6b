//! `kane lsp` as an editor starts it: what it says on its streams, and how it ends. What it answers is
//! held in `crates/editor`.

use std::io::{Read, Write};
use std::process::Stdio;

use serde_json::{Value, json};

use super::{Run, command, finish, kane};

/// The messages as they stand on the stream.
fn framed(messages: &[Value]) -> String {
    let frame = |message: &Value| {
        let body = message.to_string();
        format!("Content-Length: {}\r\n\r\n{body}", body.len())
    };
    messages.iter().map(frame).collect()
}

/// What the program says to this input, which then ends.
fn told(arguments: &[&str], input: &str) -> Run {
    let mut program = command();
    program.arg("lsp").args(arguments);
    program.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = program.spawn().expect("the program starts");
    let mut stdin = child.stdin.take().expect("it is piped");
    stdin.write_all(input.as_bytes()).expect("the program reads");
    drop(stdin);
    finish(child.wait_with_output().expect("the program ends"))
}

/// The messages on a stream.
fn messages(stream: &str) -> Vec<Value> {
    let mut rest = stream;
    let mut found = Vec::new();
    while let Some(header) = rest.strip_prefix("Content-Length: ") {
        let (length, body) = header.split_once("\r\n\r\n").expect("a header ends");
        let (body, after) = body.split_at(length.parse().expect("it is a number"));
        found.push(serde_json::from_str(body).expect("it is JSON"));
        rest = after;
    }
    assert_eq!(rest, "", "nothing else is said on the stream");
    found
}

fn beginning() -> Vec<Value> {
    let initialize = json!({ "jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {} });
    vec![initialize, json!({ "jsonrpc": "2.0", "method": "initialized", "params": {} })]
}

#[test]
fn an_editor_that_ends_the_conversation_gets_exit_code_zero_and_another_one_not() {
    let mut whole = beginning();
    whole.push(json!({ "jsonrpc": "2.0", "id": "b", "method": "shutdown" }));
    whole.push(json!({ "jsonrpc": "2.0", "method": "exit" }));
    for arguments in [&[][..], &["--stdio"]] {
        let run = told(arguments, &framed(&whole));
        assert_eq!((run.code, run.stderr.as_str()), (0, ""));
        let said = messages(&run.stdout);
        assert_eq!(said[0]["result"]["serverInfo"]["name"], "kane");
        assert_eq!((&said[1]["id"], &said[1]["result"]), (&json!("b"), &Value::Null));
    }
    for input in [&*framed(&beginning()), ""] {
        let left = told(&[], input);
        assert!(left.code == 1 && left.stderr.contains("the input ended"), "{}", left.stderr);
    }
    let broken = told(&[], "this is no editor\n");
    assert_eq!(broken.code, 2);
    assert!(broken.stderr.contains("broke off") && broken.stdout.is_empty(), "{}", broken.stderr);
}

#[test]
fn a_document_is_judged_in_an_editor_as_on_the_command_line() {
    let ball = include_str!("../../docs/derivations/bouncing-ball.md");
    let mut program = command();
    program.arg("lsp").stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null());
    let mut child = program.spawn().expect("the program starts");
    let mut stdin = child.stdin.take().expect("it is piped");
    let mut asked = beginning();
    let uri = "file:///bouncing-ball.md";
    let document = json!({ "uri": uri, "version": 1, "languageId": "markdown", "text": ball });
    let open = json!({ "textDocument": document });
    asked.push(json!({ "jsonrpc": "2.0", "method": "textDocument/didOpen", "params": open }));
    let place = |line: u32| json!({ "line": line, "character": 0 });
    let range = json!({ "start": place(0), "end": place(1_000_000) });
    let hints = json!({ "textDocument": { "uri": uri }, "range": range });
    asked.push(json!({
        "jsonrpc": "2.0", "id": 2, "method": "textDocument/inlayHint", "params": hints,
    }));
    stdin.write_all(framed(&asked).as_bytes()).expect("the program reads");
    // the input stays open until the verdicts have come
    let mut out = child.stdout.take().expect("it is piped");
    let (mut stream, mut piece) = (Vec::new(), [0; 4_096]);
    while !String::from_utf8_lossy(&stream).contains("\"id\":2,") {
        let read = out.read(&mut piece).expect("the program writes");
        assert!(read > 0, "it ended without the verdicts");
        stream.extend_from_slice(&piece[..read]);
    }
    drop(stdin);
    out.read_to_end(&mut stream).expect("the program ends");
    child.wait().expect("it ends");
    let said = messages(&String::from_utf8(stream).expect("it is UTF-8"));
    let hints = said.iter().find(|message| message["id"] == 2).expect("it is answered");
    let mut margin: Vec<(u64, String)> = Vec::new();
    for hint in hints["result"].as_array().expect("it is a list") {
        let label = hint["label"].as_str().expect("it is text").to_owned();
        margin.push((hint["position"]["line"].as_u64().expect("a number"), label));
    }

    let report = kane(&["audit", "docs/derivations/bouncing-ball.md", "--format", "json"]);
    let report: Value = serde_json::from_str(&report.stdout).expect("it is JSON");
    let statements = report["documents"][0]["statements"].as_array().expect("it is a list");
    let claims: Vec<&Value> = statements.iter().filter(|s| s["kind"] == "claim").collect();
    assert_eq!(claims.len(), margin.len());
    assert!(!claims.is_empty());
    for (claim, (line, label)) in claims.iter().zip(&margin) {
        let verdict = claim["verdict"].as_str().expect("it is text");
        assert!(label.contains(verdict), "{label} {claim}");
        // the statement may go on over further lines
        assert!(claim["line"].as_u64().expect("a number") <= line + 1, "{claim}");
    }
}
