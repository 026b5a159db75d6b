//! Conversations with a scripted editor.

mod client;
mod hostile;

use client::{Client, URI};
use kane_editor::End;
use serde_json::{Value, json};

const WALL: &str = "# Wall\n\n```kane\nvar m > 0, u > 0, v, 0 <= e <= 1\ngiven (1): v = -e*u\nlet loss := \
                    1/2*m*u^2 - 1/2*m*v^2\nclaim energy: loss >= 0 from (1)\nclaim strict: loss > 0 from \
                    energy, (1)\nclaim open: loss > 0 from (1) expect refuted\n```\n\nprose\n";

#[test]
fn errors_appear_at_their_places_with_advice() {
    let mut client = Client::new();
    client.open(&WALL.replace("v = -e*u", "v = -ee*u"));
    let [fault] = &client.diagnostics(1)[..] else { panic!("there is one") };
    assert_eq!(fault["range"]["start"], json!({ "line": 4, "character": 16 }));
    assert_eq!(fault["range"]["end"], json!({ "line": 4, "character": 18 }));
    assert_eq!((&fault["severity"], &fault["source"]), (&json!(1), &json!("kane")));
    let message = fault["message"].as_str().expect("it is text");
    assert_eq!(message, "unknown symbol `ee`\ndid you mean `e`?");
    assert_eq!(client.margin(), []);
    // and go when it is mended
    client.replace(2, WALL);
    assert!(client.diagnostics(2).iter().all(|found| found["code"] != "syntax"));
}

#[test]
fn every_claim_has_its_verdict_in_the_margin_and_a_wrong_one_is_a_diagnostic() {
    let mut client = Client::new();
    client.open(WALL);
    let [found] = &client.diagnostics(1)[..] else { panic!("there is one") };
    assert_eq!((&found["code"], &found["severity"]), (&json!("refuted"), &json!(1)));
    assert_eq!(found["range"]["start"], json!({ "line": 7, "character": 6 }));
    let message = found["message"].as_str().expect("it is text");
    assert!(
        message.starts_with("refuted: loss > 0") && message.contains("left side 0"),
        "{message}"
    );
    let expected = [(6, "✓ proved"), (7, "✗ refuted"), (8, "✓ refuted, as expected")];
    assert_eq!(client.margin(), expected.map(|(line, label)| (line, label.to_owned())));
}

#[test]
fn hovering_shows_the_proof_or_the_witness_also_where_a_statement_is_cited() {
    let mut client = Client::new();
    client.open(WALL);
    let told = |hover: Value| hover["contents"]["value"].as_str().unwrap_or_default().to_owned();
    let proof = told(client.at("textDocument/hover", (6, 2)));
    assert!(proof.contains("loss >= 0") && proof.contains("the kernel accepted"), "{proof}");
    let witness = told(client.at("textDocument/hover", (7, 0)));
    assert!(witness.contains("refuted") && witness.contains("e = 1"), "{witness}");
    // on `(1)` behind `from`
    let cited = client.at("textDocument/hover", (6, 31));
    assert_eq!(cited["range"]["start"], json!({ "line": 6, "character": 29 }));
    assert!(told(cited).contains("v = -e*u"));
    assert_eq!(client.at("textDocument/hover", (10, 0)), Value::Null);
}

#[test]
fn labels_and_names_lead_to_where_they_are_declared() {
    let mut client = Client::new();
    client.open(WALL);
    let place = |found: &Value| found["range"]["start"].clone();
    let cited = client.at("textDocument/definition", (7, 30));
    assert_eq!((&cited["uri"], place(&cited)), (&json!(URI), json!({ "line": 6, "character": 6 })));
    let symbol = client.at("textDocument/definition", (4, 17));
    assert_eq!(place(&symbol), json!({ "line": 3, "character": 26 }));
    let definition = client.at("textDocument/definition", (6, 16));
    assert_eq!(place(&definition), json!({ "line": 5, "character": 4 }));
    assert_eq!(client.at("textDocument/definition", (11, 2)), Value::Null);
    let everywhere = client.at("textDocument/references", (4, 7));
    assert_eq!(everywhere.as_array().map(Vec::len), Some(4));
    let params = json!({ "textDocument": { "uri": URI } });
    let symbols = client.ask("textDocument/documentSymbol", &params);
    let symbols = symbols["result"].as_array().expect("they are a list").clone();
    let names: Vec<&Value> = symbols.iter().map(|symbol| &symbol["name"]).collect();
    assert_eq!(names, ["(1)", "loss", "energy", "strict", "open"]);
}

/// The text with the edits of a rename.
fn renamed(text: &str, answer: &Value) -> String {
    let edits = answer["result"]["changes"][URI].as_array();
    let mut edits = edits.expect("there are edits").clone();
    edits.reverse();
    let mut lines: Vec<String> = text.split('\n').map(str::to_owned).collect();
    for edit in edits {
        let number = |place: &str| {
            let found = edit.pointer(place).and_then(Value::as_u64).expect("it is a number");
            usize::try_from(found).expect("it is small")
        };
        let line = &mut lines[number("/range/start/line")];
        let (start, end) = (number("/range/start/character"), number("/range/end/character"));
        // all of these documents are ASCII
        line.replace_range(start..end, edit["newText"].as_str().expect("it is text"));
    }
    lines.join("\n")
}

#[test]
fn a_label_is_renamed_wherever_it_is_written_and_nothing_else() {
    let mut client = Client::new();
    client.open(WALL);
    let range = client.at("textDocument/prepareRename", (6, 8));
    assert_eq!(
        (&range["placeholder"], &range["range"]["end"]["character"]),
        (&json!("energy"), &json!(12))
    );
    let answer = client.rename((7, 33), "no-gain");
    assert_eq!(renamed(WALL, &answer), WALL.replace("energy", "no-gain"));
    // parentheses stay, and come where they are needed
    assert_eq!(renamed(WALL, &client.rename((4, 7), "2")), WALL.replace("(1)", "(2)"));
    let answer = client.rename((6, 8), "no gain");
    assert_eq!(renamed(WALL, &answer), WALL.replace("energy", "(no gain)"));
    for refused in ["strict", "(1)", "from", "", "a#b", "a\nb", "a)b", "loss", "("] {
        let answer = client.rename((6, 8), refused);
        assert!(answer.get("error").is_some(), "{refused:?}: {answer}");
    }
    // a definition goes by its name, and formulas would have to change
    assert!(client.rename((5, 5), "gain").get("error").is_some());
    assert_eq!(client.at("textDocument/prepareRename", (5, 5)), Value::Null);
    client.replace(2, &WALL.replace("from (1) expect refuted", "from"));
    assert!(client.rename((6, 8), "free").get("error").is_some());
}

#[test]
fn labels_complete_where_they_are_cited_and_symbols_in_formulas() {
    let mut client = Client::new();
    client.open(&WALL.replace("prose", "```kane\nclaim next: lo > 0 from en\n```"));
    let offered = |found: Value| -> Vec<String> {
        let items = found.as_array().expect("they are a list").clone();
        items.iter().filter_map(|item| Some(item["label"].as_str()?.to_owned())).collect()
    };
    let cited = client.at("textDocument/completion", (12, 26));
    assert_eq!(cited[2]["textEdit"]["range"]["start"]["character"], 24);
    assert_eq!(offered(cited), ["open", "strict", "energy", "loss", "(1)"]);
    let symbols = offered(client.at("textDocument/completion", (12, 14)));
    assert!(
        ["loss", "mu", "e", "sqrt", "from"]
            .iter()
            .filter(|s| symbols.contains(&(**s).to_owned()))
            .count()
            == 4
    );
    let begin = offered(client.at("textDocument/completion", (12, 2)));
    assert_eq!(begin, ["var", "let", "given", "claim"]);
    // in prose, and on the line of a fence, nothing
    assert_eq!(offered(client.at("textDocument/completion", (0, 3))), [""; 0]);
    assert_eq!(offered(client.at("textDocument/completion", (2, 5))), [""; 0]);
}

#[test]
fn places_count_units_of_utf_16_and_lines_may_end_as_they_like() {
    let text = "# 𝛂\r\n\r\n```kane\r\nvar μ > 0 # 𝛂𝛃\r\ngiven (𝛂): $\\mu = \\frac{1}{2}$ when μ < 𝒙\r\n```\r\n";
    let mut client = Client::new();
    client.open(text);
    // behind two letters outside of the BMP, and a formula that is read in another notation
    let faults = client.diagnostics(1);
    let [fault] = &faults[..] else { panic!("{faults:?}") };
    assert_eq!(fault["range"]["start"], json!({ "line": 4, "character": 41 }), "{fault}");
    assert_eq!(fault["range"]["end"], json!({ "line": 4, "character": 43 }), "{fault}");
    // it is mended by typing over it
    let range = fault["range"].clone();
    client.change(2, &json!([{ "range": range, "text": "1" }]));
    assert_eq!(client.diagnostics(2), [Value::Null; 0]);
    client.replace(3, &text.replace("\r\n", "\r"));
    assert_eq!(client.diagnostics(3)[0]["range"]["start"], json!({ "line": 4, "character": 41 }));
}

#[test]
fn what_is_typed_piece_by_piece_is_the_text_that_is_judged() {
    let mut client = Client::new();
    client.open("");
    let mut version = 1;
    for (number, line) in WALL.split_inclusive('\n').enumerate() {
        // first with a letter too many, which is then taken away
        version += 1;
        let here = json!({ "line": number, "character": 0 });
        let after = json!({ "line": number, "character": 1 });
        client.change(version, &json!([
            { "range": { "start": here, "end": here }, "text": format!("𝛂{line}") },
            { "range": { "start": here, "end": { "line": number, "character": 2 } }, "text": "x" },
            { "range": { "start": here, "end": after }, "text": "" },
        ]));
    }
    let typed = client.margin();
    let mut other = Client::new();
    other.open(WALL);
    assert_eq!(typed, other.margin());
    assert_eq!(typed.len(), 3);
}

#[test]
fn only_the_newest_text_is_shown() {
    let mut client = Client::new();
    client.open(WALL);
    for version in 2..40 {
        client.replace(version, &WALL.replace("loss > 0", &format!("loss > {version}")));
    }
    // asked while older texts may still be judged
    let hints = client.margin();
    assert_eq!(hints.len(), 3);
    let last = client.diagnostics(39);
    assert!(last[0]["message"].as_str().is_some_and(|said| said.contains("loss > 39")), "{last:?}");
}

#[test]
fn a_document_without_statements_says_nothing() {
    let mut client = Client::new();
    client.open("# Notes\n\n```rust\nlet claim = 1;\n```\n");
    assert_eq!(client.diagnostics(1), [Value::Null; 0]);
    assert_eq!(client.margin(), []);
}

#[test]
fn a_conversation_ends_as_the_protocol_says() {
    let mut client = Client::new();
    assert_eq!(client.ask("shutdown", &Value::Null)["result"], Value::Null);
    assert_eq!(client.at_error("textDocument/hover"), -32600);
    client.say("exit", &Value::Null);
    assert_eq!(client.hang_up().expect("it ends well"), End::Orderly);
    // without a word
    assert_eq!(Client::new().hang_up().expect("it ends well"), End::Abrupt);
}
