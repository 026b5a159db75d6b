//! What every report for programs has: what it is, what wrote it and by which command, and the line feed at its end.

use kane_algebra::syntax::is_hidden;
use serde::Serialize;

/// The name and the version of a report's format.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Schema {
    pub(crate) name: &'static str,
    pub(crate) version: u32,
}

/// The program that wrote it.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Program {
    name: &'static str,
    version: &'static str,
}

/// A report's data under what all reports have.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Envelope<'a, T> {
    schema: Schema,
    program: Program,
    command: &'a str,
    #[serde(flatten)]
    data: T,
}

/// A report's data for programs, in the envelope of all reports.
pub(crate) fn enveloped(schema: Schema, command: &str, data: impl Serialize) -> String {
    written(&Envelope { schema, program: Program::THIS, command, data })
}

/// A report for programs as text, ended by a line feed. What cannot be seen is escaped.
pub(crate) fn written(report: &impl Serialize) -> String {
    let json = serde_json::to_string_pretty(report)
        .expect("numbers, strings, lists and maps with string keys always serialise");
    let mut out = String::with_capacity(json.len() + 1);
    for c in json.chars() {
        if is_hidden(c) {
            let mut units = [0; 2];
            out.extend(c.encode_utf16(&mut units).iter().map(|unit| format!("\\u{unit:04x}")));
        } else {
            out.push(c);
        }
    }
    out.push('\n');
    out
}

/// The same JSON with one line for each item at the top, and within an item no space between what it is made of but behind
/// a colon near the top, where this program looks for its name.
pub(crate) fn folded(json: &str) -> String {
    let mut out = String::with_capacity(json.len());
    let (mut depth, mut quoted, mut escaped) = (0_usize, false, false);
    for c in json.chars() {
        if quoted {
            out.push(c);
            quoted = c != '"' || escaped;
            escaped = c == '\\' && !escaped;
            continue;
        }
        match c {
            '"' => quoted = true,
            '{' | '[' => depth += 1,
            '}' | ']' => depth = depth.saturating_sub(1),
            '\n' if depth > 1 => continue,
            ' ' if depth > 2 || !out.ends_with(':') => continue,
            _ => {}
        }
        out.push(c);
    }
    out
}

/// The schema of a report's data in the envelope of all reports.
#[cfg(feature = "schema")]
pub(crate) fn schema_enveloped<T: schemars::JsonSchema>(title: &str) -> serde_json::Value {
    schema_of::<Envelope<'static, T>>(title)
}

/// The schema of a whole report, as it is written.
#[cfg(feature = "schema")]
pub(crate) fn schema_of<T: schemars::JsonSchema>(title: &str) -> serde_json::Value {
    let settings = schemars::generate::SchemaSettings::draft2020_12().for_serialize();
    let mut schema = settings.into_generator().into_root_schema_for::<T>();
    schema.insert("title".to_owned(), title.into());
    schema.to_value()
}

impl Program {
    /// This program.
    pub(crate) const THIS: Self = Self { name: "kane", version: env!("CARGO_PKG_VERSION") };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folding_leaves_the_data_as_they_are() {
        let value = serde_json::json!({
            "schema": { "name": "kane-x", "version": 1 },
            "a": [[1, { "b": "two  words: \"{ [ \\" }], [], {}],
            "c": " \\\\\" \n",
        });
        let pretty = written(&value);
        let short = folded(&pretty);
        let read = |text: &str| serde_json::from_str::<serde_json::Value>(text).expect("JSON");
        assert_eq!(read(&short), value);
        assert!(short.len() < pretty.len() && short.ends_with("}\n"), "{short}");
        assert!(short.contains("\"name\": \"kane-x\""), "{short}");
        assert_eq!(folded(&short), short);
    }
}
