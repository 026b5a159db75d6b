//! Following labels and names to where they are declared and used.

use kane_algebra::syntax::canonical_name;
use kane_audit::Kind;
use serde_json::{Value, json};

use crate::document::{Open, label_at, word_at};
use crate::message::Refusal;

/// Where the label or the name at a byte is declared.
pub(crate) fn definition(uri: &str, document: &mut Open, at: usize) -> Result<Value, Refusal> {
    let text = document.text.clone();
    let outline = document.outline(uri);
    let place = match label_at(outline, at) {
        Some((index, _)) => outline.labels.get(index).map(|label| label.place.clone()),
        None => {
            let inside = outline.blocks.iter().any(|block| block.contains(&at));
            let word = word_at(&text, at).filter(|_| inside).map(|range| &text[range]);
            let name = word.map(canonical_name);
            let name = name.and_then(|name| outline.names.iter().find(|n| n.text == name));
            name.map(|name| name.place.clone())
        }
    };
    Ok(match place {
        Some(place) => json!({ "uri": uri, "range": document.range(&place) }),
        None => Value::Null,
    })
}

/// Everywhere where the label at a byte is written.
pub(crate) fn references(uri: &str, document: &mut Open, at: usize) -> Result<Value, Refusal> {
    let outline = document.outline(uri);
    let Some((index, _)) = label_at(outline, at) else { return Ok(Value::Null) };
    let own = outline.labels.get(index).map(|label| label.place.clone());
    let cited = outline.citations.iter().filter(|citation| citation.cites == Some(index));
    let mut places: Vec<_> = own.into_iter().chain(cited.map(|c| c.place.clone())).collect();
    places.sort_by_key(|place| place.start);
    let shown = places.iter().map(|place| json!({ "uri": uri, "range": document.range(place) }));
    Ok(shown.collect::<Vec<_>>().into())
}

/// The statements of a document that can be cited.
pub(crate) fn symbols(uri: &str, document: &mut Open) -> Value {
    let labels = document.outline(uri).labels.clone();
    let shown = labels.iter().map(|label| {
        // the protocol has kinds of a programming language: a constant, a property, a function
        let (kind, detail) = match label.kind {
            Kind::Let => (14, "let"),
            Kind::Given => (7, "given"),
            Kind::Claim => (12, "claim"),
            Kind::Broken => (13, "with an error"),
        };
        json!({
            "name": label.text,
            "detail": detail,
            "kind": kind,
            "range": document.range(&label.statement),
            "selectionRange": document.range(&label.place),
        })
    });
    shown.collect::<Vec<_>>().into()
}
