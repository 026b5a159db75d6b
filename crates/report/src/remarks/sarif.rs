//! Remarks as SARIF 2.1.0 (OASIS, 2020), which scanners of code and editors read.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use super::{Level, Remark};
use crate::envelope::written;

/// The remarks of one run, ended by a line feed. A relative file stays relative to where the run was.
#[must_use]
pub fn sarif(remarks: &[Remark]) -> String {
    let rules: BTreeSet<&str> = remarks.iter().map(|remark| remark.rule.as_str()).collect();
    let rules: Vec<Value> = rules.into_iter().map(|id| json!({ "id": id })).collect();
    let results: Vec<Value> = remarks.iter().map(result).collect();
    written(&json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": "kane",
                "semanticVersion": env!("CARGO_PKG_VERSION"),
                "rules": rules,
            }},
            "columnKind": "unicodeCodePoints",
            "results": results,
        }],
    }))
}

fn result(remark: &Remark) -> Value {
    // a result of another kind than `fail` has the level `none`: section 3.27.10
    let (kind, level) = match remark.level {
        Level::Error => ("fail", "error"),
        Level::Note => ("informational", "none"),
        Level::Pass => ("pass", "none"),
    };
    let mut place = json!({ "artifactLocation": { "uri": uri(&remark.file) } });
    if let Some(line) = remark.line {
        place["region"] = json!({ "startLine": line });
    }
    json!({
        "ruleId": remark.rule,
        "kind": kind,
        "level": level,
        "message": { "text": format!("{}: {}", remark.title, remark.message) },
        "locations": [{ "physicalLocation": place }],
    })
}

/// The file as a reference of RFC 3986.
fn uri(file: &str) -> String {
    let file = file.strip_prefix("./").unwrap_or(file);
    let mut out = String::new();
    for byte in file.bytes() {
        match byte {
            b'\\' if cfg!(windows) => out.push('/'),
            b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => {
                out.push(char::from(byte));
            }
            _ => out.push_str(&format!("%{byte:02X}")),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::uri;

    #[test]
    fn a_name_of_a_file_is_a_reference() {
        assert_eq!(uri("./docs/a b.md"), "docs/a%20b.md");
        assert_eq!(uri("docs/50%/é#1.md"), "docs/50%25/%C3%A9%231.md");
        assert_eq!(uri("c:notes.md"), "c%3Anotes.md");
    }
}
