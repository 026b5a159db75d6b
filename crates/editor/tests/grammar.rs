//! The grammar for highlighting knows the words of the language, and the extension has its files.

use std::path::PathBuf;

use serde_json::Value;

fn extension() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../editors/vscode")
}

fn json(file: &str) -> Value {
    let text = std::fs::read_to_string(extension().join(file)).expect("the file is there");
    serde_json::from_str(&text).expect("it is JSON")
}

#[test]
fn every_reserved_word_of_the_language_is_highlighted() {
    let page = include_str!("../../../docs/derivation-language.md");
    let (_, reserved) = page.split_once("Reserved are `").expect("the page lists them");
    let (reserved, _) = reserved.split_once('`').expect("the list ends");
    let grammar = json("syntaxes/kane.tmLanguage.json").to_string();
    let words: Vec<&str> = reserved.split_whitespace().collect();
    assert!(words.len() > 15, "{words:?}");
    let further = ["var", "let", "given", "claim", "as", "sin", "cos", "tan", "pi", "in"];
    for word in words.into_iter().chain(further) {
        let stands = |(at, _): (usize, &str)| {
            let around = [grammar[..at].chars().last(), grammar[at + word.len()..].chars().next()];
            around.iter().all(|c| c.is_some_and(|c| "(|)".contains(c)))
        };
        let alone = grammar.contains(&format!("\\\\b{word}(?="));
        assert!(alone || grammar.match_indices(word).any(stands), "`{word}` is not highlighted");
    }
}

#[test]
fn every_file_that_the_extension_names_is_there() {
    let package = json("package.json");
    let mut files = vec![package["main"].as_str().expect("it has one").to_owned()];
    for list in ["languages", "grammars"] {
        for entry in package["contributes"][list].as_array().expect("it is a list") {
            let paths =
                ["path", "configuration"].into_iter().filter_map(|name| entry[name].as_str());
            files.extend(paths.map(str::to_owned));
        }
    }
    assert_eq!(files.len(), 4);
    for file in files {
        assert!(extension().join(&file).is_file(), "{file}");
    }
    let scopes =
        ["syntaxes/kane.tmLanguage.json", "syntaxes/markdown-kane.tmLanguage.json"].map(json);
    for (grammar, entry) in
        scopes.iter().zip(package["contributes"]["grammars"].as_array().expect("a list"))
    {
        assert_eq!(grammar["scopeName"], entry["scopeName"]);
    }
}
