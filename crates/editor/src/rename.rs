//! Renaming a label wherever it is written. What comes out is read again before it is proposed: it has
//! to be the same document but for the label.

use std::ops::Range;

use kane_audit::{Outline, survey};
use serde_json::{Value, json};

use crate::document::{Open, label_at, name};
use crate::message::Refusal;

/// What would be renamed at a byte, and its present name.
pub(crate) fn prepare(uri: &str, document: &mut Open, at: usize) -> Result<Value, Refusal> {
    let outline = document.outline(uri);
    let renamed = label_at(outline, at)
        .and_then(|(index, place)| Some((outline.labels.get(index)?, place)))
        .filter(|(label, _)| !label.is_name);
    let Some((label, place)) = renamed else { return Ok(Value::Null) };
    let placeholder = bare(&label.text).to_owned();
    Ok(json!({ "range": document.range(&place), "placeholder": placeholder }))
}

/// The changes that give the label at a byte another name.
pub(crate) fn rename(
    uri: &str,
    document: &mut Open,
    at: usize,
    new: &str,
) -> Result<Value, Refusal> {
    let refuse = |why: &str| Err(Refusal::Cannot(why.to_owned()));
    let text = document.text.clone();
    let found = document.survey(uri);
    if found.document.is_err() {
        return refuse("a document with errors is not renamed in: a citation could be missed");
    }
    let outline = &found.outline;
    let Some((index, _)) = label_at(outline, at) else { return refuse("there is no label here") };
    let Some(label) = outline.labels.get(index) else { return refuse("there is no label here") };
    if label.is_name {
        return refuse(
            "this definition goes by its name; give it a label, or change the name by hand",
        );
    }
    let cited = outline.citations.iter().filter(|citation| citation.cites == Some(index));
    let mut places: Vec<Range<usize>> = cited.map(|citation| citation.place.clone()).collect();
    places.push(label.place.clone());
    places.sort_by_key(|place| place.start);
    places.dedup();
    let edits: Vec<(Range<usize>, String)> = places
        .into_iter()
        .map(|place| {
            let written = spelled(&text[place.clone()], new);
            (place, written)
        })
        .collect();
    if !is_same_but_for(uri, &text, outline, &edits) {
        return refuse("it would be another document: the label is no label, or is taken");
    }
    let edits =
        edits.iter().map(|(place, new)| json!({ "range": document.range(place), "newText": new }));
    let edits: Value = edits.collect::<Vec<_>>().into();
    Ok(json!({ "changes": { uri: edits } }))
}

/// A label without its parentheses.
fn bare(label: &str) -> &str {
    let inside = label.strip_prefix('(').and_then(|rest| rest.strip_suffix(')'));
    inside.unwrap_or(label).trim()
}

/// The new label as it is written in a place of the old one: with parentheses where there were some, or
/// where it needs them.
fn spelled(old: &str, new: &str) -> String {
    let word = |label: &str| {
        label.starts_with(char::is_alphanumeric)
            && label.chars().all(|c| c.is_alphanumeric() || "-_'′.".contains(c))
    };
    let inside = bare(new);
    if old.starts_with('(') || new.starts_with('(') || !word(inside) {
        format!("({inside})")
    } else {
        inside.to_owned()
    }
}

/// Whether the text with these edits can be read, has the same statements and cites the same ones.
fn is_same_but_for(
    uri: &str,
    text: &str,
    before: &Outline,
    edits: &[(Range<usize>, String)],
) -> bool {
    let mut edited = text.to_owned();
    for (place, new) in edits.iter().rev() {
        edited.replace_range(place.clone(), new);
    }
    let after = survey(name(uri), edited.as_bytes());
    let shape = |outline: &Outline| {
        let kinds: Vec<_> = outline.labels.iter().map(|l| (l.kind, l.is_name)).collect();
        let cites: Vec<_> = outline.citations.iter().map(|citation| citation.cites).collect();
        let names: Vec<_> = outline.names.iter().map(|name| name.text.clone()).collect();
        (kinds, cites, names)
    };
    after.document.is_ok() && shape(before) == shape(&after.outline)
}
