//! The thread that judges. It takes texts and gives findings; of several texts of a document it judges
//! the newest, and leaves one that it is judging when a newer one comes.

use std::collections::{HashMap, VecDeque};
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
use std::thread;

use kane_audit::{Audit, Memo, Options, audit_again, survey};
use kane_report::explain;
use lsp_server::RequestId;

use crate::document::name;
use crate::event::Event;
use crate::findings::Findings;

/// Bytes of the stack on which documents are read and judged.
const STACK: usize = 64 << 20;
/// Characters of a proof that are shown; `kane audit --explain` shows all of it.
const MAX_SHOWN: usize = 20_000;

/// What the thread is to do.
#[derive(Debug)]
pub(crate) enum Job {
    /// judge this text
    Judge { uri: String, version: i64, text: Arc<str> },
    /// tell the proof or the witness of a statement of the text that was judged last
    Explain { id: RequestId, uri: String, version: i64, statement: usize },
    /// forget a document
    Close { uri: String },
}

/// A document that was judged.
#[derive(Debug, Default)]
struct Known {
    memo: Memo,
    audit: Option<(i64, Audit)>,
}

/// Starts the thread. It ends when nobody can give it jobs any more.
///
/// # Errors
/// The system gives no thread.
pub(crate) fn start(events: Sender<Event>) -> io::Result<Sender<Job>> {
    let (jobs, inbox) = channel();
    // audits stay in the thread: what they share is not for several
    let judge =
        move || Judge { inbox, waiting: VecDeque::new(), events, known: HashMap::new() }.run();
    thread::Builder::new().name("judge".to_owned()).stack_size(STACK).spawn(judge)?;
    Ok(jobs)
}

struct Judge {
    inbox: Receiver<Job>,
    waiting: VecDeque<Job>,
    events: Sender<Event>,
    known: HashMap<String, Known>,
}

impl Judge {
    fn run(mut self) {
        loop {
            if self.waiting.is_empty() {
                match self.inbox.recv() {
                    Ok(job) => self.waiting.push_back(job),
                    Err(_) => return,
                }
            }
            collect(&self.inbox, &mut self.waiting);
            let Some(job) = self.waiting.pop_front() else { continue };
            let event = match job {
                Job::Judge { uri, .. } if is_superseded(&self.waiting, &uri) => None,
                Job::Judge { uri, version, text } => self.judge(uri, version, &text),
                Job::Explain { id, uri, version, statement } => {
                    let known = self.known.get(&uri).and_then(|known| known.audit.as_ref());
                    let known = known.filter(|(judged, _)| *judged == version);
                    let told = known.and_then(|(_, audit)| told(audit, statement));
                    Some(Event::Told { id, told })
                }
                Job::Close { uri } => {
                    self.known.remove(&uri);
                    None
                }
            };
            if event.is_some_and(|event| self.events.send(event).is_err()) {
                return;
            }
        }
    }

    /// What is found of a text; `None` if a newer one came in between.
    fn judge(&mut self, uri: String, version: i64, text: &str) -> Option<Event> {
        let Self { inbox, waiting, known, .. } = self;
        let known = known.entry(uri.clone()).or_default();
        let mut go_on = |_, _| collect(inbox, waiting) && !is_superseded(waiting, &uri);
        let judged = || {
            let found = survey(name(&uri), text.as_bytes());
            let document = match found.document {
                Ok(document) => document,
                Err(faults) => return Some((Findings::faults(faults, &found.origin), None)),
            };
            let options = Options::default();
            let audit = audit_again(document, &options, &mut known.memo, &mut go_on)?;
            Some((Findings::of(&audit, &found.origin), Some((version, audit))))
        };
        // what the judge knew when it failed is not used again
        let (findings, audit) = match catch_unwind(AssertUnwindSafe(judged)) {
            Ok(judged) => judged?,
            Err(_) => {
                *known = Known::default();
                (Findings::broken(), None)
            }
        };
        known.audit = audit;
        Some(Event::Judged { uri, version, findings })
    }
}

/// Takes in all jobs that have come; whether more can come.
fn collect(inbox: &Receiver<Job>, waiting: &mut VecDeque<Job>) -> bool {
    loop {
        match inbox.try_recv() {
            Ok(job) => waiting.push_back(job),
            Err(TryRecvError::Empty) => return true,
            Err(TryRecvError::Disconnected) => return false,
        }
    }
}

/// Whether a newer text of the document waits, or it was closed.
fn is_superseded(waiting: &VecDeque<Job>, uri: &str) -> bool {
    waiting.iter().any(|job| match job {
        Job::Judge { uri: newer, .. } | Job::Close { uri: newer } => newer == uri,
        Job::Explain { .. } => false,
    })
}

/// The proof or the witness of a statement as Markdown.
fn told(audit: &Audit, statement: usize) -> Option<String> {
    let mut text = explain(audit, statement)?;
    if let Some((cut, _)) = text.char_indices().nth(MAX_SHOWN) {
        text.truncate(cut);
        text.push_str("\n…\n(the rest is in `kane audit --explain`)\n");
    }
    // a fence that is longer than any in the text, so that nothing in it ends the block
    let ticks = text.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat((ticks + 1).max(3));
    Some(format!("{fence}text\n{text}{}{fence}", if text.ends_with('\n') { "" } else { "\n" }))
}
