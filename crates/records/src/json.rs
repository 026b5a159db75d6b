//! A line of JSON as the cells of a row.

use std::fmt;

use serde::de::{Deserialize, Deserializer, Error as _, MapAccess, Visitor};
use serde_json::Value;

use crate::rejection::Reason;

/// The members of an object in their order; a name that stands twice is an error, and not the last of them.
struct Members(Vec<(String, Value)>);

impl<'de> Deserialize<'de> for Members {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Object;
        impl<'de> Visitor<'de> for Object {
            type Value = Members;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Members, A::Error> {
                let mut members: Vec<(String, Value)> = Vec::new();
                while let Some((name, value)) = map.next_entry::<String, Value>()? {
                    if members.iter().any(|(known, _)| *known == name) {
                        return Err(A::Error::custom(format!("`{name}` stands twice")));
                    }
                    members.push((name, value));
                }
                Ok(Members(members))
            }
        }
        deserializer.deserialize_map(Object)
    }
}

/// The cells of a JSON object; arrays and objects inside become `name_x` or `name_key`.
///
/// # Errors
/// [`Reason::NotJson`], with the column.
pub(crate) fn cells(line: &[u8]) -> Result<Vec<(String, Value)>, Reason> {
    if line.trim_ascii_start().starts_with(b"[") {
        let why = "an array begins here; a log has one object a line";
        return Err(Reason::NotJson(why.to_owned()));
    }
    let Members(members) = serde_json::from_slice(line).map_err(|error| fault(&error))?;
    let mut cells = Vec::with_capacity(members.len());
    for (name, value) in members {
        match value {
            Value::Array(items) if items.len() <= 3 => {
                for (axis, item) in ["x", "y", "z"].iter().zip(items) {
                    cells.push((format!("{name}_{axis}"), item));
                }
            }
            Value::Object(inside) => {
                cells.extend(inside.into_iter().map(|(key, item)| (format!("{name}_{key}"), item)));
            }
            other => cells.push((name, other)),
        }
    }
    Ok(cells)
}

/// What is wrong, with the column; the line is the log's, and not the one that the parser counts.
fn fault(error: &serde_json::Error) -> Reason {
    if error.is_eof() {
        return Reason::NotJson("the line ends within the object".to_owned());
    }
    let text = error.to_string();
    let what = text.split(" at line ").next().unwrap_or(&text);
    Reason::NotJson(format!("{what}, column {}", error.column()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn members_keep_their_order_and_stand_once() {
        let found = cells(br#"{"v": [1, 2], "b": {"m": 3}, "a": 4}"#).expect("it is an object");
        let names: Vec<&str> = found.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["v_x", "v_y", "b_m", "a"]);
        let why = |line: &[u8]| cells(line).expect_err("it is none").to_string();
        assert!(why(br#"{"mu": 0.3, "mu": 0.9}"#).contains("`mu` stands twice, column"));
        assert!(why(br#"{"mu": 0.3"#).contains("ends within"));
        assert!(why(br#"{"mu": NaN}"#).contains("column 8"));
        assert!(why(b"[1]").contains("one object a line"));
    }

    /// A parser that is off by a unit in the last place takes floats of 24 bits for others.
    #[test]
    fn numbers_are_the_nearest_floats() {
        let single = 0.011_632_964_946_329_594_f64;
        let found = cells(b"{\"x\": 0.011632964946329594}").expect("it is an object");
        assert_eq!(found[0].1.as_f64().map(f64::to_bits), Some(single.to_bits()));
    }
}
