//! Messages on a stream: a header with the length, an empty line, and JSON.

use std::io::{self, BufRead, Read};

use lsp_server::Message;

/// Bytes of a message. The largest document that is read, every byte of it escaped, is smaller.
const MAX_MESSAGE_BYTES: u64 = 128 << 20;
/// Bytes of a line of a header.
const MAX_HEADER_BYTES: u64 = 4 << 10;

/// What comes next on the stream.
#[derive(Debug)]
pub(crate) enum Incoming {
    /// a message
    Message(Message),
    /// something whose end is known, but that is no message; why
    Unreadable(String),
    /// the stream has ended
    End,
}

/// Reads the next message. What is no message is passed over, as far as its length is known.
///
/// # Errors
/// The stream cannot be read, or there is no length, so that nobody knows where the next message begins.
pub(crate) fn next(input: &mut impl BufRead) -> io::Result<Incoming> {
    let Some(length) = header(input)? else { return Ok(Incoming::End) };
    if length > MAX_MESSAGE_BYTES {
        io::copy(&mut input.take(length), &mut io::sink())?;
        let reason = format!("a message of {length} bytes; {MAX_MESSAGE_BYTES} are the most");
        return Ok(Incoming::Unreadable(reason));
    }
    // room is taken as bytes arrive, whatever the header promises
    let mut body = Vec::new();
    let read = input.take(length).read_to_end(&mut body)?;
    if (read as u64) < length {
        return Ok(Incoming::End);
    }
    Ok(match serde_json::from_slice(&body) {
        Ok(message) => Incoming::Message(message),
        Err(error) => Incoming::Unreadable(format!("this is no message: {error}")),
    })
}

/// The length of the body that follows; `None` at the end of the stream.
fn header(input: &mut impl BufRead) -> io::Result<Option<u64>> {
    let broken = |what: &str| io::Error::new(io::ErrorKind::InvalidData, what.to_owned());
    let mut length = None;
    loop {
        let mut line = Vec::new();
        input.take(MAX_HEADER_BYTES).read_until(b'\n', &mut line)?;
        if line.is_empty() {
            return Ok(None);
        }
        let line = String::from_utf8(line).map_err(|_| broken("a header that is not UTF-8"))?;
        if !line.ends_with('\n') {
            return Err(broken("a header that does not end"));
        }
        let line = line.trim_end();
        if line.is_empty() {
            let length = length.ok_or_else(|| broken("a message without `Content-Length`"))?;
            return Ok(Some(length));
        }
        let (name, value) =
            line.split_once(':').ok_or_else(|| broken("a header without a colon"))?;
        if name.trim().eq_ignore_ascii_case("content-length") {
            let value = value.trim().parse().map_err(|_| broken("`Content-Length` is no number"));
            length = Some(value?);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(body: &str) -> String {
        format!("Content-Length: {}\r\n\r\n{body}", body.len())
    }

    #[test]
    fn a_message_that_is_none_is_passed_over() {
        let good = r#"{"jsonrpc":"2.0","method":"a"}"#;
        let deep = "[".repeat(100_000);
        let stream: String = ["{", &deep, "1", "\u{0}", good].map(frame).concat();
        let mut input = stream.as_bytes();
        for _ in 0..4 {
            assert!(matches!(next(&mut input), Ok(Incoming::Unreadable(_))));
        }
        assert!(matches!(next(&mut input), Ok(Incoming::Message(Message::Notification(_)))));
        assert!(matches!(next(&mut input), Ok(Incoming::End)));
    }

    #[test]
    fn a_promise_of_more_than_there_is_takes_no_room() {
        for length in ["99999999", "18446744073709551615"] {
            let stream = format!("Content-Length: {length}\r\n\r\n{{}}");
            let next = next(&mut stream.as_bytes());
            assert!(matches!(next, Ok(Incoming::End | Incoming::Unreadable(_))), "{next:?}");
        }
    }

    #[test]
    fn a_stream_without_lengths_is_an_error() {
        let long = "x".repeat(10_000);
        for stream in ["\r\n{}", "Content-Length: -1\r\n\r\n", "Length 3\r\n\r\n", "Content", &long]
        {
            assert!(next(&mut stream.as_bytes()).is_err(), "{stream}");
        }
    }
}
