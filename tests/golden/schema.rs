//! The shipped JSON Schemas: that they are those of the types, and that their checker finds faults.

use crate::assert_kept;
use crate::schemas::faults;

#[test]
fn the_schemas_in_the_documentation_are_those_of_the_types() {
    for (name, schema) in kane_report::schemas() {
        let text = serde_json::to_string_pretty(&schema).expect("it is JSON") + "\n";
        assert_kept(&format!("docs/schema/{name}.json"), &text);
    }
}

#[test]
fn the_checker_finds_every_kind_of_fault() {
    let schema = serde_json::json!({
        "type": "object",
        "properties": {
            "a": { "type": ["string", "null"] },
            "b": { "type": "array", "items": { "$ref": "#/$defs/n" } },
            "c": { "anyOf": [{ "const": 1 }, { "enum": ["x", "y"] }] },
            "d": { "type": "array", "prefixItems": [{ "type": "string" }], "items": { "type": "boolean" }, "maxItems": 2 },
        },
        "required": ["a"],
        "$defs": { "n": { "type": "integer", "minimum": 0 } },
    });
    let good = serde_json::json!({ "a": null, "b": [1, 2], "c": "y", "d": ["p", true] });
    assert_eq!(faults(&schema, &good), [""; 0]);
    for (bad, what) in [
        (serde_json::json!({}), "$: a is missing"),
        (serde_json::json!({ "a": 1 }), "$.a: 1 is not of type"),
        (serde_json::json!({ "a": "", "b": [1, 1.5] }), "$.b[1]: 1.5 is not of type"),
        (serde_json::json!({ "a": "", "c": "z" }), "$.c: it fits none"),
        (serde_json::json!({ "a": "", "d": [1] }), "$.d[0]: 1 is not"),
        (serde_json::json!({ "a": "", "d": ["", 1] }), "$.d[1]: 1 is not"),
        (serde_json::json!({ "a": "", "d": ["", true, true] }), "$.d: 3 items"),
        (serde_json::json!({ "a": "", "e": 1 }), "$.e: it is not documented"),
        (serde_json::json!([]), "$: [] is not of type"),
    ] {
        let found = faults(&schema, &bad);
        assert!(found.iter().any(|fault| fault.starts_with(what)), "{bad}: {found:?}");
    }
}
