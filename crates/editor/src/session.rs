//! The conversation with an editor: who may ask what when, and which answers wait for verdicts.

use std::collections::BTreeMap;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::ops::Range;
use std::sync::mpsc::{Sender, channel};
use std::thread;

use lsp_server::{ErrorCode, Message, Notification, Request, RequestId};
use serde_json::{Value, json};

use crate::document::{Open, label_at};
use crate::event::Event;
use crate::findings::Findings;
use crate::judging::{self, Job};
use crate::message::{self, Refusal, answer, capabilities, notification, untimely};
use crate::position::{Position, bytes};
use crate::transport::{self, Incoming};
use crate::{completion, labels, rename};

/// Documents that may be open at once.
const MOST_OPEN: usize = 1_000;
/// Requests that wait for verdicts at once.
const MOST_WAITING: usize = 1_000;

/// How a conversation ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// the editor said that it would end it, and did
    Orderly,
    /// without that
    Abrupt,
}

/// Talks with an editor until it says `exit`, or the input ends.
///
/// # Errors
/// The output cannot be written, the input cannot be read or has no messages in it, or the system gives
/// no thread.
pub fn serve(input: impl Read + Send + 'static, output: impl Write) -> io::Result<End> {
    let (events, inbox) = channel();
    let jobs = judging::start(events.clone())?;
    thread::Builder::new().name("reader".to_owned()).spawn(move || {
        let mut input = BufReader::new(input);
        read(&mut input, &events);
    })?;
    let mut session = Session::new(output, jobs);
    // never longer than the reader lives: it says when the input ends
    for event in inbox {
        if let Some(end) = session.take(event)? {
            return Ok(end);
        }
    }
    Ok(End::Abrupt)
}

/// Reads messages until there are no more.
fn read(input: &mut impl BufRead, events: &Sender<Event>) {
    loop {
        let event = match transport::next(input) {
            Ok(incoming) => Event::Incoming(incoming),
            Err(error) => Event::Broken(error),
        };
        let is_last = matches!(event, Event::Broken(_) | Event::Incoming(Incoming::End));
        if events.send(event).is_err() || is_last {
            return;
        }
    }
}

/// How far the conversation has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    Before,
    Open,
    ShutDown,
}

/// A request that waits until a text is judged.
#[derive(Debug)]
struct Waiting {
    id: RequestId,
    uri: String,
    what: Wanted,
}

#[derive(Debug)]
enum Wanted {
    /// verdicts in the margin of these bytes
    Hints(Range<usize>),
    /// the proof or the witness of what stands here
    Hover(usize),
}

struct Session<W> {
    output: W,
    jobs: Sender<Job>,
    stage: Stage,
    open: BTreeMap<String, Open>,
    waiting: Vec<Waiting>,
    /// hovers that are being told, with the document and its version
    telling: Vec<(RequestId, Value)>,
    /// whether the editor takes a hint that hints have changed, and how often it was given
    refreshes: Option<i32>,
}

impl<W: Write> Session<W> {
    fn new(output: W, jobs: Sender<Job>) -> Self {
        let (open, waiting, telling) = (BTreeMap::new(), Vec::new(), Vec::new());
        Self { output, jobs, stage: Stage::Before, open, waiting, telling, refreshes: None }
    }

    /// Takes an event; how the conversation ends, if it does.
    fn take(&mut self, event: Event) -> io::Result<Option<End>> {
        match event {
            Event::Broken(error) => return Err(error),
            Event::Incoming(Incoming::End) => return Ok(Some(self.end())),
            Event::Incoming(Incoming::Unreadable(why)) => self.refuse_unreadable(&why)?,
            Event::Incoming(Incoming::Message(message)) => match message {
                Message::Request(request) => self.request(request)?,
                Message::Notification(said) if said.method == "exit" => {
                    return Ok(Some(self.end()));
                }
                Message::Notification(said) => self.notified(said)?,
                // answers to `refresh`, which says nothing that matters
                Message::Response(_) => {}
            },
            Event::Judged { uri, version, findings } => self.judged(&uri, version, findings)?,
            Event::Told { id, told } => self.told(&id, told)?,
        }
        Ok(None)
    }

    fn end(&self) -> End {
        if self.stage == Stage::ShutDown { End::Orderly } else { End::Abrupt }
    }

    fn send(&mut self, message: &Message) -> io::Result<()> {
        message.write(&mut self.output)
    }

    /// An error that belongs to no request, since none could be read.
    fn refuse_unreadable(&mut self, why: &str) -> io::Result<()> {
        let error = json!({ "code": ErrorCode::ParseError as i32, "message": why });
        let body = json!({ "jsonrpc": "2.0", "id": Value::Null, "error": error }).to_string();
        write!(self.output, "Content-Length: {}\r\n\r\n{body}", body.len())?;
        self.output.flush()
    }

    fn request(&mut self, request: Request) -> io::Result<()> {
        let Request { id, method, params } = request;
        let untimely_one = match (self.stage, method.as_str()) {
            (Stage::Before, "initialize") => {
                self.stage = Stage::Open;
                let refreshes = "/capabilities/workspace/inlayHint/refreshSupport";
                let takes = params.pointer(refreshes).and_then(Value::as_bool).unwrap_or(false);
                self.refreshes = takes.then_some(0);
                return self.send(&answer(id, Ok(capabilities())));
            }
            (Stage::Before, _) => (ErrorCode::ServerNotInitialized, "`initialize` comes first"),
            (Stage::Open, "initialize") => (ErrorCode::InvalidRequest, "`initialize` comes once"),
            (Stage::Open, "shutdown") => {
                self.stage = Stage::ShutDown;
                return self.send(&answer(id, Ok(Value::Null)));
            }
            (Stage::Open, _) => return self.asked(id, &method, &params),
            (Stage::ShutDown, _) => (ErrorCode::InvalidRequest, "it was shut down"),
        };
        self.send(&untimely(id, untimely_one.0, untimely_one.1))
    }

    /// A request about a document.
    fn asked(&mut self, id: RequestId, method: &str, params: &Value) -> io::Result<()> {
        let result = match method {
            "textDocument/hover" => {
                return self.wait(id, params, |document, params| {
                    let position = params.get("position").and_then(Position::of)?;
                    Some(Wanted::Hover(document.byte(position)))
                });
            }
            "textDocument/inlayHint" => {
                return self.wait(id, params, |document, params| {
                    let text = document.text.clone();
                    Some(Wanted::Hints(bytes(&text, document.lines(), params.get("range")?)?))
                });
            }
            "textDocument/definition" => self.at(params, labels::definition),
            "textDocument/references" => self.at(params, labels::references),
            "textDocument/prepareRename" => self.at(params, rename::prepare),
            "textDocument/completion" => self.at(params, completion::at),
            "textDocument/rename" => match params.get("newName").and_then(Value::as_str) {
                Some(new) => {
                    self.at(params, |uri, document, at| rename::rename(uri, document, at, new))
                }
                None => Err(Refusal::Parameters("`newName`")),
            },
            "textDocument/documentSymbol" => {
                self.document(params).map(|(uri, document)| labels::symbols(uri, document))
            }
            _ => Err(Refusal::Unknown(method.to_owned())),
        };
        self.send(&answer(id, result))
    }

    /// The document of a request, with its address.
    fn document<'p>(&mut self, params: &'p Value) -> Result<(&'p str, &mut Open), Refusal> {
        let uri = params.pointer("/textDocument/uri").and_then(Value::as_str);
        let uri = uri.ok_or(Refusal::Parameters("`textDocument`"))?;
        let unknown = || Refusal::Cannot(format!("the document `{uri}` is not open"));
        Ok((uri, self.open.get_mut(uri).ok_or_else(unknown)?))
    }

    /// What is found at the place of a request.
    fn at(
        &mut self,
        params: &Value,
        find: impl FnOnce(&str, &mut Open, usize) -> Result<Value, Refusal>,
    ) -> Result<Value, Refusal> {
        let (uri, document) = self.document(params)?;
        let position = params.get("position").and_then(Position::of);
        let position = position.ok_or(Refusal::Parameters("`position`"))?;
        let at = document.byte(position);
        find(uri, document, at)
    }

    /// Answers as soon as the text is judged, maybe at once.
    fn wait(
        &mut self,
        id: RequestId,
        params: &Value,
        wanted: impl FnOnce(&mut Open, &Value) -> Option<Wanted>,
    ) -> io::Result<()> {
        let found = self.document(params).and_then(|(uri, document)| {
            let what = wanted(document, params).ok_or(Refusal::Parameters("place"))?;
            Ok((uri.to_owned(), what))
        });
        match found {
            Err(refusal) => self.send(&answer(id, Err(refusal))),
            Ok(_) if self.waiting.len() >= MOST_WAITING => {
                let refusal = Refusal::Cannot("too many requests wait".to_owned());
                self.send(&answer(id, Err(refusal)))
            }
            Ok((uri, what)) => {
                self.waiting.push(Waiting { id, uri: uri.clone(), what });
                self.serve_waiting(&uri)
            }
        }
    }

    /// Answers what waits for the verdicts on a document, if it is judged.
    fn serve_waiting(&mut self, uri: &str) -> io::Result<()> {
        let judged = self.open.get(uri).is_some_and(|document| document.findings.is_some());
        if !judged {
            return Ok(());
        }
        let (ready, rest): (Vec<Waiting>, Vec<Waiting>) =
            std::mem::take(&mut self.waiting).into_iter().partition(|w| w.uri == uri);
        self.waiting = rest;
        for Waiting { id, what, .. } in ready {
            let Some(document) = self.open.get_mut(uri) else { continue };
            let result = match what {
                Wanted::Hover(at) => match covered(uri, document, at) {
                    Some((statement, place)) => {
                        let version = document.version;
                        self.telling.push((id.clone(), place));
                        let uri = uri.to_owned();
                        self.job(Job::Explain { id, uri, version, statement })?;
                        continue;
                    }
                    None => Value::Null,
                },
                Wanted::Hints(within) => {
                    let text = document.text.clone();
                    let lines = document.lines().clone();
                    let findings = document.findings.as_ref();
                    findings.map_or(Value::Null, |f| f.hints(&text, &lines, &within).into())
                }
            };
            self.send(&answer(id, Ok(result)))?;
        }
        Ok(())
    }

    fn notified(&mut self, said: Notification) -> io::Result<()> {
        if self.stage != Stage::Open {
            return Ok(());
        }
        let Notification { method, params } = said;
        let uri = params.pointer("/textDocument/uri").and_then(Value::as_str);
        let version = params.pointer("/textDocument/version").and_then(Value::as_i64).unwrap_or(0);
        match (method.as_str(), uri) {
            ("textDocument/didOpen", Some(uri)) => {
                let text = params.pointer("/textDocument/text").and_then(Value::as_str);
                let known = self.open.contains_key(uri);
                if let Some(text) = text.filter(|_| known || self.open.len() < MOST_OPEN) {
                    self.open.insert(uri.to_owned(), Open::new(version, text.to_owned()));
                    self.judge(uri)?;
                }
            }
            ("textDocument/didChange", Some(uri)) => {
                let changes = params.get("contentChanges").and_then(Value::as_array);
                let changes = changes.map_or(&[][..], Vec::as_slice);
                let Some(document) = self.open.get_mut(uri) else { return Ok(()) };
                if document.change(version, changes).is_none() {
                    return self.out_of_step(uri);
                }
                self.abandon(uri, "the text has changed")?;
                self.judge(uri)?;
            }
            ("textDocument/didClose", Some(uri)) if self.open.remove(uri).is_some() => {
                self.abandon(uri, "the document was closed")?;
                self.publish(uri, None, Vec::new())?;
                self.job(Job::Close { uri: uri.to_owned() })?;
            }
            ("$/cancelRequest", _) => {
                let id = params.get("id").cloned().unwrap_or_default();
                if let Ok(id) = serde_json::from_value::<RequestId>(id)
                    && let Some(at) = self.waiting.iter().position(|waiting| waiting.id == id)
                {
                    self.waiting.remove(at);
                    self.send(&untimely(id, ErrorCode::RequestCanceled, "cancelled"))?;
                }
            }
            // what is not known may be passed over
            _ => {}
        }
        Ok(())
    }

    /// Says that a change makes no sense: what is shown from here on would be of another text, so that
    /// nothing is shown until the document is opened again.
    fn out_of_step(&mut self, uri: &str) -> io::Result<()> {
        self.open.remove(uri);
        self.abandon(uri, "the text is not known any more")?;
        self.publish(uri, None, Vec::new())?;
        self.job(Job::Close { uri: uri.to_owned() })?;
        let message = format!("kane: a change of {uri} makes no sense; close and open it again");
        self.send(&notification("window/showMessage", json!({ "type": 1, "message": message })))
    }

    /// Refuses what waits for verdicts on a text that is no more.
    fn abandon(&mut self, uri: &str, why: &str) -> io::Result<()> {
        let (old, rest): (Vec<Waiting>, Vec<Waiting>) =
            std::mem::take(&mut self.waiting).into_iter().partition(|w| w.uri == uri);
        self.waiting = rest;
        for waiting in old {
            self.send(&untimely(waiting.id, ErrorCode::ContentModified, why))?;
        }
        Ok(())
    }

    /// Has the text of a document judged.
    fn judge(&mut self, uri: &str) -> io::Result<()> {
        let Some(document) = self.open.get(uri) else { return Ok(()) };
        let (version, text) = (document.version, document.text.clone());
        self.job(Job::Judge { uri: uri.to_owned(), version, text })
    }

    fn job(&mut self, job: Job) -> io::Result<()> {
        let gone = |_| io::Error::other("the thread that judges has ended");
        self.jobs.send(job).map_err(gone)
    }

    /// Shows what was found, if it was found of the text that the editor has.
    fn judged(&mut self, uri: &str, version: i64, findings: Findings) -> io::Result<()> {
        let Some(document) = self.open.get_mut(uri).filter(|d| d.version == version) else {
            return Ok(());
        };
        let text = document.text.clone();
        let diagnostics = findings.diagnostics(&text, document.lines());
        document.findings = Some(findings);
        self.publish(uri, Some(version), diagnostics)?;
        if let Some(number) = &mut self.refreshes {
            *number = number.wrapping_add(1);
            let number = *number;
            self.send(&message::refresh(number))?;
        }
        self.serve_waiting(uri)
    }

    fn publish(&mut self, uri: &str, version: Option<i64>, found: Vec<Value>) -> io::Result<()> {
        let mut params = json!({ "uri": uri, "diagnostics": found });
        if let Some(version) = version {
            params["version"] = version.into();
        }
        self.send(&notification("textDocument/publishDiagnostics", params))
    }

    fn told(&mut self, id: &RequestId, told: Option<String>) -> io::Result<()> {
        let Some(at) = self.telling.iter().position(|(telling, _)| telling == id) else {
            return Ok(());
        };
        let (id, place) = self.telling.swap_remove(at);
        let shown =
            |text| json!({ "contents": { "kind": "markdown", "value": text }, "range": place });
        self.send(&answer(id, Ok(told.map_or(Value::Null, shown))))
    }
}

/// The statement at a byte: the one that is cited there, or the one in which it stands; with its place.
fn covered(uri: &str, document: &mut Open, at: usize) -> Option<(usize, Value)> {
    let outline = document.outline(uri);
    let cited = label_at(outline, at).map(|(index, place)| {
        (outline.labels.get(index).map_or(at, |label| label.statement.start), Some(place))
    });
    let (start, place) = cited.unwrap_or((at, None));
    let stated = document.findings.as_ref()?.stated();
    let covers = |range: &Range<usize>| range.start <= start && start <= range.end;
    // what was derived from a statement stands where it is cited: the outermost is meant
    let widest = |(_, found): &(usize, &crate::findings::Stated)| found.place.len();
    let (statement, found) =
        stated.iter().enumerate().filter(|(_, found)| covers(&found.place)).max_by_key(widest)?;
    let place = place.unwrap_or_else(|| found.place.clone());
    Some((statement, document.range(&place)))
}
