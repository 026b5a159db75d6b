//! What happens in a conversation.

use std::io;

use lsp_server::RequestId;

use crate::findings::Findings;
use crate::transport::Incoming;

/// What happens.
#[derive(Debug)]
pub(crate) enum Event {
    /// the editor says something
    Incoming(Incoming),
    /// the editor cannot be read any more
    Broken(io::Error),
    /// a text was judged
    Judged { uri: String, version: i64, findings: Findings },
    /// a proof or a witness was told
    Told { id: RequestId, told: Option<String> },
}
