//! Whether reports for programs are as the shipped JSON Schemas say.
//!
//! The checker knows the keywords that our schemas have and fails on any other. It is stricter than a reader should be:
//! what a schema does not name is an error, so that nothing is written that is not documented.

use serde_json::{Map, Value};

/// A report for programs is as the shipped schema of its verb says.
#[track_caller]
pub(crate) fn assert_valid(verb: &str, report: &str) {
    assert_value(verb, &serde_json::from_str(report).expect("a report is JSON"));
}

/// What the program wrote is as the schema says that it names itself by. What is no report of ours is passed over.
#[track_caller]
pub(crate) fn assert_valid_if_ours(text: &str) {
    let Ok(value) = serde_json::from_str::<Value>(text) else { return };
    let name = value.pointer("/schema/name").and_then(Value::as_str);
    match name.and_then(|name| name.strip_prefix("kane-")) {
        Some(verb) => assert_value(verb, &value),
        None if value.get("format").is_some() && value.get("claims").is_some() => {
            assert_value("certificate", &value);
        }
        None => {}
    }
}

#[track_caller]
fn assert_value(verb: &str, report: &Value) {
    let path = format!("{}/docs/schema/{verb}.json", env!("CARGO_MANIFEST_DIR"));
    let schema = std::fs::read_to_string(&path).expect("every report has a schema");
    let schema: Value = serde_json::from_str(&schema).expect("a schema is JSON");
    let faults = faults(&schema, report);
    assert!(faults.is_empty(), "{verb}: {:#?}", &faults[..faults.len().min(10)]);
}

/// What of a value is not as its schema says.
pub(crate) fn faults(schema: &Value, value: &Value) -> Vec<String> {
    let mut checker = Checker { root: schema, faults: Vec::new() };
    checker.check(schema, value, "$");
    checker.faults
}

/// Keywords that say nothing of a value, or that are looked up by others.
const SILENT: [&str; 8] =
    ["$schema", "$defs", "title", "description", "format", "default", "minimum", "maximum"];

struct Checker<'a> {
    root: &'a Value,
    faults: Vec<String>,
}

impl<'a> Checker<'a> {
    fn fault(&mut self, at: &str, what: impl std::fmt::Display) {
        self.faults.push(format!("{at}: {what}"));
    }

    fn check(&mut self, schema: &'a Value, value: &Value, at: &str) {
        let schema = match schema {
            Value::Bool(true) => return,
            Value::Bool(false) => return self.fault(at, "nothing is allowed here"),
            Value::Object(schema) => schema,
            other => unreachable!("{other} is no schema"),
        };
        for (keyword, given) in schema {
            match keyword.as_str() {
                "$ref" => {
                    let pointer = given.as_str().and_then(|r| r.strip_prefix('#'));
                    let target = pointer.and_then(|pointer| self.root.pointer(pointer));
                    let target = target.expect("a reference leads somewhere");
                    self.check(target, value, at);
                }
                "type" => self.typed(given, value, at),
                "const" if value != given => self.fault(at, format!("{value} is not {given}")),
                "enum" if !given.as_array().is_some_and(|all| all.contains(value)) => {
                    self.fault(at, format!("{value} is none of {given}"));
                }
                "anyOf" | "oneOf" => {
                    let all = given.as_array().expect("a list");
                    let fits = all.iter().any(|one| {
                        let mut inner = Checker { root: self.root, faults: Vec::new() };
                        inner.check(one, value, at);
                        inner.faults.is_empty()
                    });
                    if !fits {
                        self.fault(at, "it fits none of the alternatives");
                    }
                }
                "required" => {
                    for name in given.as_array().expect("a list").iter().filter_map(Value::as_str) {
                        if value.as_object().is_some_and(|object| !object.contains_key(name)) {
                            self.fault(at, format!("{name} is missing"));
                        }
                    }
                }
                "properties" | "additionalProperties" => {}
                "items" => self.items(given, schema, value, at),
                "prefixItems" => {
                    let parts = given.as_array().expect("a list").iter();
                    let values = value.as_array().map(Vec::as_slice).unwrap_or_default();
                    for (n, (part, value)) in parts.zip(values).enumerate() {
                        self.check(part, value, &format!("{at}[{n}]"));
                    }
                }
                "minItems" | "maxItems" => {
                    let Some(items) = value.as_array() else { continue };
                    let count = items.len() as u64;
                    let bound = given.as_u64().expect("a count");
                    if (keyword == "minItems") != (count >= bound) && count != bound {
                        self.fault(at, format!("{count} items"));
                    }
                }
                "const" | "enum" => {}
                silent if SILENT.contains(&silent) => {}
                other => unreachable!("the checker does not know {other}"),
            }
        }
        self.properties(schema, value, at);
    }

    fn typed(&mut self, types: &Value, value: &Value, at: &str) {
        let is = |name: &str| match name {
            "null" => value.is_null(),
            "boolean" => value.is_boolean(),
            "integer" => value.is_i64() || value.is_u64(),
            "number" => value.is_number(),
            "string" => value.is_string(),
            "array" => value.is_array(),
            "object" => value.is_object(),
            other => unreachable!("{other} is no type"),
        };
        let fits = match types {
            Value::String(name) => is(name),
            Value::Array(names) => names.iter().filter_map(Value::as_str).any(is),
            other => unreachable!("{other} is no type"),
        };
        if !fits {
            self.fault(at, format!("{value} is not of type {types}"));
        }
    }

    fn items(&mut self, given: &'a Value, schema: &Map<String, Value>, value: &Value, at: &str) {
        let skip = schema.get("prefixItems").and_then(Value::as_array).map_or(0, Vec::len);
        let values = value.as_array().map(Vec::as_slice).unwrap_or_default();
        for (n, value) in values.iter().enumerate().skip(skip) {
            self.check(given, value, &format!("{at}[{n}]"));
        }
    }

    fn properties(&mut self, schema: &'a Map<String, Value>, value: &Value, at: &str) {
        let Some(object) = value.as_object() else { return };
        let known = schema.get("properties").and_then(Value::as_object);
        let others = schema.get("additionalProperties");
        for (name, value) in object {
            let at = format!("{at}.{name}");
            match (known.and_then(|known| known.get(name)), others) {
                (Some(own), _) => self.check(own, value, &at),
                (None, Some(others)) => self.check(others, value, &at),
                (None, None) if known.is_some() => self.fault(&at, "it is not documented"),
                (None, None) => {}
            }
        }
    }
}
