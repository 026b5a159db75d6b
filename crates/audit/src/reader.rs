//! From a Markdown document to statements, or to the list of everything wrong with it.
//!
//! Fenced blocks tagged `kane` hold statements. A statement begins at the margin of its block and
//! goes on over the indented lines that follow; `#` starts a comment, which ends with its line; a line
//! ends at LF, CR or CRLF; the clauses of a claim come
//! in the order `as`, `when`, `from`, `using`, `by`, `expect`. Three decisions that the language page leaves
//! open:
//!
//! - A label is what stands between parentheses on one line, or a word of letters, digits and
//!   `- _ ' .`; `(9)` and `9` are the same label. A `let` without a label goes by its name.
//! - A definition may be cited, to no effect: definitions are known everywhere.
//! - `contradiction` and `not implied` take a `when` too.

mod angle;
mod blocks;
mod bounds;
mod citation;
mod determined;
mod differentiation;
mod dollars;
mod existence;
mod exponential;
mod hint;
mod interior;
mod label;
mod sequence;
mod statement;
mod survey;
mod symbol;
mod tie;
mod unit;
mod wanted;

use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::ops::Range;

use kane_algebra::syntax::{Diagnostic, Lines, Scope, is_control, is_hidden, visible};

use crate::Document;
use crate::document::digest;
use crate::motion::Motion;
use crate::origin::Origin;
use crate::outline::{Outline, Survey};
use blocks::Blocks;
use citation::Draft;
use unit::Dimension;
use wanted::Wanted;

/// Bytes of a file.
pub const MAX_FILE_BYTES: usize = 16 << 20;
/// Statements of a document.
pub const MAX_STATEMENTS: usize = 100_000;
/// Symbols of a document.
const MAX_SYMBOLS: usize = 100_000;
/// Faults after which reading stops.
const MAX_FAULTS: usize = 200;
/// Names above which no nearest one is sought.
const MAX_CANDIDATES: usize = 10_000;
/// Times that a document is read again because an angle or a derivative was met.
const MAX_READINGS: usize = 100;

/// Reads the document `bytes`, which goes by the name `name` in messages.
///
/// Time grows with the length of the text; memory stays within a small multiple of it.
///
/// # Errors
/// Everything that is wrong, in the order of the text, up to 200 faults.
pub fn read(name: &str, bytes: &[u8]) -> Result<Document, Vec<Diagnostic>> {
    read_with(name, bytes, None)
}

/// Reads a document as [`read`] does, and says what stands where, also where there are errors.
#[must_use]
pub fn survey(name: &str, bytes: &[u8]) -> Survey {
    let mut found = (Outline::default(), Origin::default());
    let document = read_with(name, bytes, Some(&mut found));
    let (outline, origin) = found;
    Survey { document, outline, origin }
}

/// The document; what stands where is noted as far as it is read.
fn read_with(
    name: &str,
    bytes: &[u8],
    survey: Option<&mut (Outline, Origin)>,
) -> Result<Document, Vec<Diagnostic>> {
    if bytes.len() > MAX_FILE_BYTES {
        let message = format!("the file has {} bytes; {MAX_FILE_BYTES} are the most", bytes.len());
        return Err(vec![Diagnostic::at_start(name, message)]);
    }
    let text = match std::str::from_utf8(bytes) {
        // a mark of the byte order, which some editors write first, would hide a heading or a fence
        Ok(text) => lines_ended_by_line_feeds(text.strip_prefix('\u{feff}').unwrap_or(text)),
        Err(_) => return Err(vec![Diagnostic::not_utf8(name, bytes)]),
    };
    let mut blocks = blocks::find(&text);
    let (text, origin) = match dollars::read(&text, &blocks) {
        Ok(read) => read,
        Err(faults) => {
            // the formulas stay as they are, and what is found of the rest is found in them
            if let Some((outline, _)) = survey {
                let reader = read_wanted(&text, &blocks);
                *outline = reader.outline(&text, &blocks.ranges, &Origin::default());
            }
            let reader = Reader { faults, ..Reader::default() };
            return Err(reader.diagnostics(name, &text));
        }
    };
    if let Cow::Owned(read) = &text {
        blocks = blocks::find(read);
    }
    let text = text.as_ref();
    let mut reader = read_wanted(text, &blocks);
    if let Some((outline, found)) = survey {
        *outline = reader.outline(text, &blocks.ranges, &origin);
        *found = origin;
    }
    if reader.faults.is_empty() {
        reader.check_units();
    }
    let undetermined = reader.undetermined();
    let statements = if reader.faults.len() < MAX_FAULTS { reader.resolve() } else { Vec::new() };
    if reader.scope.is_exhausted() {
        let message = "definitions use each other too often to be checked".to_owned();
        reader.faults.push(Fault::new(0..0, message));
    }
    if reader.faults.is_empty() {
        let motion = Motion {
            rates: reader.scope.rates().clone(),
            angles: reader.scope.angles().collect(),
            measured: reader.scope.measured().collect(),
            exponentials: reader.scope.exponentials().cloned().collect(),
            stands_for: reader.stands_for(),
            derived: reader.derived,
            undetermined,
        };
        return Ok(Document {
            motion,
            sequences: reader.scope.sequences().clone(),
            derivatives: reader.scope.derivatives(),
            name: visible(name).into_owned(),
            text: text.to_owned(),
            title: blocks.title.as_deref().map(|title| visible(title).into_owned()),
            context: reader.scope.into_context(),
            statements,
            digest: digest(bytes),
        });
    }
    Err(reader.diagnostics(name, text))
}

/// Reads the statements of a text, and again while an angle or a derivative is met that was not known.
fn read_wanted(text: &str, blocks: &Blocks) -> Reader {
    let mut wanted = Wanted::default();
    (0..MAX_READINGS)
        .find_map(|reading| {
            let reader = read_once(text, blocks, wanted.clone());
            // where something new was met, the faults are those of not having known it
            let is_last = reader.met == wanted || reading + 1 == MAX_READINGS;
            wanted.clone_from(&reader.met);
            is_last.then_some(reader)
        })
        .expect("the last reading ends the search")
}

/// Reads the statements of a text, in which these angles and derivatives are known.
fn read_once(text: &str, blocks: &Blocks, wanted: Wanted) -> Reader {
    let faults = blocks.faults.clone();
    let mut reader = Reader { met: wanted.clone(), wanted, faults, ..Reader::default() };
    reader.refuse_hidden(&blocks.code);
    let mut lines = Lines::new(text);
    for (count, span) in blocks.statements.iter().cloned().enumerate() {
        if count == MAX_STATEMENTS {
            let message = format!("more than {MAX_STATEMENTS} statements");
            reader.faults.push(Fault::new(span, message));
            break;
        }
        if reader.faults.len() >= MAX_FAULTS {
            break;
        }
        let line = lines.place(span.start).line;
        (reader.line, reader.count) = (line, count);
        reader.statement(&blocks.code, span, line);
    }
    reader.meet_limits();
    reader
}

/// The text with a line feed in place of each carriage return that no line feed follows, so that all
/// of the reader agrees on where lines end. No byte moves.
fn lines_ended_by_line_feeds(text: &str) -> Cow<'_, str> {
    let lone = |at: usize| text.as_bytes().get(at + 1) != Some(&b'\n');
    if !text.match_indices('\r').any(|(at, _)| lone(at)) {
        return Cow::Borrowed(text);
    }
    let ended = |(at, c): (usize, char)| if c == '\r' && lone(at) { '\n' } else { c };
    Cow::Owned(text.char_indices().map(ended).collect())
}

/// Something wrong at a place in the text.
#[derive(Clone, Debug)]
struct Fault {
    span: Range<usize>,
    message: String,
    note: Option<String>,
    /// the name that nothing declares, to be compared with all names at the end
    unknown: Option<String>,
}

impl Fault {
    fn new(span: Range<usize>, message: String) -> Self {
        Self { span, message, note: None, unknown: None }
    }

    fn diagnostic(self, name: &str, lines: &mut Lines<'_>) -> Diagnostic {
        let mut diagnostic = Diagnostic::among(name, lines, self.span, self.message);
        diagnostic.note = self.note;
        diagnostic
    }

    fn with_note(self, note: impl Into<String>) -> Self {
        Self { note: Some(note.into()), ..self }
    }
}

/// What has been read so far.
#[derive(Debug, Default)]
struct Reader {
    scope: Scope,
    drafts: Vec<Draft>,
    /// statement by the key of its label
    labels: HashMap<String, usize>,
    /// where each symbol is declared
    var_sites: Vec<usize>,
    /// where each definition stands
    let_sites: Vec<usize>,
    /// what is known of angles before the text is read
    wanted: Wanted,
    /// the same, with what was met in the text
    met: Wanted,
    /// by angle, the statement of what holds of it
    circles: BTreeMap<usize, usize>,
    /// by symbol, the statement of the bounds that are expressions
    ranges: BTreeMap<usize, usize>,
    /// by angle that stands by itself, too, the statement of what its point is beside it
    arcs: BTreeMap<usize, usize>,
    /// by what stands for an exponential or a logarithm, the statement of what holds of it
    exponentials: BTreeMap<usize, usize>,
    /// by derived statement, what it is the derivative of
    derived: BTreeMap<usize, usize>,
    /// the dimensions of the symbols that have a unit
    units: HashMap<usize, Dimension>,
    /// the words of the statements that could not be read
    lost: HashSet<String>,
    /// the number of the statement that is being read
    count: usize,
    /// its line
    line: usize,
    faults: Vec<Fault>,
}

impl Reader {
    /// Notes each character of the blocks that cannot be seen: in a label or a comment it could make
    /// a report say what the auditor does not.
    fn refuse_hidden(&mut self, code: &str) {
        let hidden = code.char_indices().filter(|(_, c)| is_hidden(*c)).take(MAX_FAULTS);
        for (at, c) in hidden {
            let kind = if is_control(c) { "control" } else { "invisible" };
            let message = format!("{kind} character U+{:04X} among statements", u32::from(c));
            self.faults.push(Fault::new(at..at + c.len_utf8(), message));
        }
    }

    fn diagnostics(mut self, name: &str, text: &str) -> Vec<Diagnostic> {
        let mut faults = std::mem::take(&mut self.faults);
        let is_lost =
            |fault: &Fault| fault.unknown.as_ref().is_some_and(|name| self.may_be_lost(name));
        // a statement may be lost by an unknown name of its own
        if faults.iter().any(|fault| !is_lost(fault)) {
            faults.retain(|fault| !is_lost(fault));
        }
        // what stands between parentheses behind an unknown function is no factor that lacks its sign
        let is_called = |end: usize| text.get(end..).is_some_and(|text| text.starts_with('('));
        let unknown = faults.iter().filter(|fault| fault.unknown.is_some());
        let called: HashSet<usize> =
            unknown.map(|fault| fault.span.end).filter(|end| is_called(*end)).collect();
        faults.retain(|fault| fault.unknown.is_some() || !called.contains(&fault.span.start));
        faults.sort_by_key(|fault| (fault.span.start, fault.span.end));
        let cut = faults.len() > MAX_FAULTS;
        faults.truncate(MAX_FAULTS);
        let mut lines = Lines::new(text);
        let mut diagnostics: Vec<Diagnostic> = faults
            .into_iter()
            .map(|mut fault| {
                if let Some(unknown) = &fault.unknown {
                    fault.note = Some(self.hint_at_unknown(unknown, &fault.span, text));
                }
                fault.diagnostic(name, &mut lines)
            })
            .collect();
        if cut || diagnostics.len() == MAX_FAULTS {
            let message = format!("{MAX_FAULTS} errors are shown; there may be more");
            diagnostics.push(Diagnostic::at_start(name, message));
        }
        diagnostics
    }
}
