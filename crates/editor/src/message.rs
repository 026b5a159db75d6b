//! What is sent to the editor.

use lsp_server::{ErrorCode, Message, Notification, Request, RequestId, Response};
use serde_json::{Value, json};

/// Why a request has no answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Refusal {
    /// the method is not known
    Unknown(String),
    /// the parameters are not those of the method
    Parameters(&'static str),
    /// it cannot be done; why
    Cannot(String),
}

/// The answer to a request.
pub(crate) fn answer(id: RequestId, result: Result<Value, Refusal>) -> Message {
    let response = match result {
        Ok(value) => Response::new_ok(id, value),
        Err(Refusal::Unknown(method)) => {
            error(id, ErrorCode::MethodNotFound, format!("`{method}` is not known"))
        }
        Err(Refusal::Parameters(what)) => {
            error(id, ErrorCode::InvalidParams, format!("the parameters have no {what}"))
        }
        Err(Refusal::Cannot(why)) => error(id, ErrorCode::RequestFailed, why),
    };
    response.into()
}

fn error(id: RequestId, code: ErrorCode, message: String) -> Response {
    Response::new_err(id, code as i32, message)
}

/// That a request comes at a wrong time.
pub(crate) fn untimely(id: RequestId, code: ErrorCode, why: &str) -> Message {
    error(id, code, why.to_owned()).into()
}

/// A message that is no answer.
pub(crate) fn notification(method: &str, params: Value) -> Message {
    Notification { method: method.to_owned(), params }.into()
}

/// Asks the editor for the verdicts in the margin to be asked for again.
pub(crate) fn refresh(number: i32) -> Message {
    let method = "workspace/inlayHint/refresh".to_owned();
    Request { id: number.into(), method, params: Value::Null }.into()
}

/// What the server can do.
pub(crate) fn capabilities() -> Value {
    json!({
        "capabilities": {
            "positionEncoding": "utf-16",
            "textDocumentSync": { "openClose": true, "change": 2 },
            "hoverProvider": true,
            "definitionProvider": true,
            "referencesProvider": true,
            "documentSymbolProvider": true,
            "renameProvider": { "prepareProvider": true },
            "completionProvider": { "triggerCharacters": ["("] },
            "inlayHintProvider": true,
        },
        "serverInfo": { "name": "kane", "version": env!("CARGO_PKG_VERSION") },
    })
}
