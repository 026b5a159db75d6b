//! Labels as people type them.

use kane::algebra::syntax::nearest;
use kane::audit::Document;

/// Indices of the statements that are called so: by the label itself, or for `9` by `(9)`.
pub(super) fn find(document: &Document, wanted: &str) -> Vec<usize> {
    let called = |name: &str| {
        let statements = document.statements.iter().enumerate();
        statements.filter(|(_, s)| s.label == name).map(|(index, _)| index).collect::<Vec<_>>()
    };
    let exact = called(wanted);
    if exact.is_empty() { called(&format!("({wanted})")) } else { exact }
}

/// What to say when no document has the label.
pub(super) fn unknown<'a>(
    documents: impl IntoIterator<Item = &'a Document>,
    wanted: &str,
) -> String {
    let labels: Vec<&str> =
        documents.into_iter().flat_map(|d| &d.statements).map(|s| s.label.as_str()).collect();
    let inner = |label: &'a str| label.trim_start_matches('(').trim_end_matches(')');
    let bare = wanted.trim_start_matches('(').trim_end_matches(')');
    let near = nearest(bare, labels.iter().map(|label| inner(label)));
    match near.and_then(|near| labels.iter().find(|label| inner(label) == near)) {
        Some(label) => format!("no statement is labelled `{wanted}`; did you mean `{label}`?"),
        None => format!("no statement is labelled `{wanted}`"),
    }
}
