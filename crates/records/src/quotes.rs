//! Quotes and line ends of a CSV file, followed while its bytes pass by: a quote that nothing closes would make
//! one cell of all the lines behind it, and CR LF a line of its own of each LF.

use std::io::{Error, ErrorKind, Read, Result};

use memchr::{memchr, memchr_iter, memchr2, memrchr};

use crate::opening::LONGEST;

/// A CSV file whose quotes are seen to, and of which every line ends at LF. Reading it is an error where a quote opens a cell and nothing closes it,
/// where a cell goes on behind the quote that closes it, and where a record is longer than 16 MiB.
#[derive(Debug)]
pub struct Quotes<R> {
    input: R,
    delimiter: u8,
    state: State,
    /// the line of the next byte, from 1
    line: u64,
    /// the line in which the cell opens
    opened: u64,
    /// whether a cell goes on in another line
    goes_on: bool,
    /// bytes of the record so far
    length: usize,
    /// the byte that came last, as it was written
    last: u8,
}

/// What may stand before the text of a file in UTF-8.
const MARK: &[u8] = b"\xef\xbb\xbf";

/// Where in a record the next byte stands, as RFC 4180 has it, with comments between records.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    /// at its beginning
    Record,
    /// at the beginning of another cell
    Cell,
    /// in a cell without quotes
    Plain,
    /// behind the quote that opens a cell
    Open,
    /// behind a quote that closes it, or is the first of two that stand for one
    Closed,
    /// in a comment
    Comment,
}

impl<R: Read> Quotes<R> {
    /// A file from its beginning, with cells separated by this byte.
    pub const fn new(input: R, delimiter: u8) -> Self {
        Self {
            input,
            delimiter,
            state: State::Record,
            line: 1,
            opened: 1,
            goes_on: false,
            length: 0,
            last: b'\n',
        }
    }

    /// Whether a cell of what was read goes on in another line.
    #[must_use]
    pub const fn goes_on(&self) -> bool {
        self.goes_on
    }

    /// Follows bytes without a quote and without the sign of a comment: only what stands behind their last line
    /// end matters.
    fn pass(&mut self, bytes: &[u8]) {
        let lines = u64::try_from(memchr_iter(b'\n', bytes).count()).unwrap_or(0);
        self.line += lines;
        if self.state == State::Open {
            self.goes_on |= lines > 0;
            self.length += bytes.len();
            return;
        }
        let end = memrchr(b'\n', bytes);
        let rest = end.map_or(bytes, |end| &bytes[end + 1..]);
        self.length = if end.is_some() { rest.len() } else { self.length + rest.len() };
        self.state = match rest.last() {
            Some(last) if *last == self.delimiter => State::Cell,
            Some(_) => State::Plain,
            None if end.is_some() => State::Record,
            None => self.state,
        };
    }

    /// Follows bytes one by one.
    fn follow(&mut self, bytes: &[u8]) -> Result<()> {
        for &byte in bytes {
            self.length += 1;
            self.state = match (self.state, byte) {
                (State::Record, b'#') => State::Comment,
                (State::Comment, b'\n') => State::Record,
                (State::Comment, _) => State::Comment,
                (State::Record | State::Cell, b'"') => {
                    self.opened = self.line;
                    State::Open
                }
                (State::Open, b'"') => State::Closed,
                (State::Open, _) | (State::Closed, b'"') => State::Open,
                (_, b'\n') => State::Record,
                (_, byte) if byte == self.delimiter => State::Cell,
                (State::Closed, b' ' | b'\t') => State::Closed,
                (State::Closed, _) => {
                    return Err(
                        self.fault("opens, and the cell goes on behind the one that closes it")
                    );
                }
                _ => State::Plain,
            };
            self.line += u64::from(byte == b'\n');
            self.goes_on |= self.state == State::Open && byte == b'\n';
            if self.state == State::Record {
                self.length = 0;
            }
        }
        Ok(())
    }

    /// The next bytes with LF in place of CR LF and CR, and behind the last line; how many there are.
    fn lines(&mut self, buffer: &mut [u8]) -> Result<usize> {
        loop {
            let read = self.input.read(buffer)?;
            let Some(&last) = buffer[..read].last() else {
                let is_cut = !matches!(self.last, b'\n' | b'\r') && self.state != State::Open;
                self.last = b'\n';
                return Ok(match buffer.first_mut() {
                    Some(first) if is_cut => {
                        *first = b'\n';
                        1
                    }
                    _ => 0,
                });
            };
            let before = std::mem::replace(&mut self.last, last);
            let kept = with_line_feeds(&mut buffer[..read], before);
            if kept > 0 {
                return Ok(kept);
            }
        }
    }

    fn fault(&self, why: &str) -> Error {
        Error::new(ErrorKind::InvalidData, format!("line {}: a quote {why}", self.opened))
    }
}

impl<R: Read> Read for Quotes<R> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        let read = self.lines(buffer)?;
        let bytes = &buffer[..read];
        let first = self.state == State::Record && self.line == 1;
        let bytes = bytes.strip_prefix(MARK).filter(|_| first).unwrap_or(bytes);
        if read == 0 && !buffer.is_empty() && self.state == State::Open {
            return Err(self.fault("opens that nothing closes"));
        }
        let plain = !matches!(self.state, State::Comment | State::Closed);
        if plain && memchr2(b'"', b'#', bytes).is_none() {
            self.pass(bytes);
        } else {
            self.follow(bytes)?;
        }
        if self.length <= LONGEST {
            Ok(read)
        } else if self.state == State::Open {
            Err(self.fault("opens that nothing closes in 16 MiB"))
        } else {
            let why = format!("line {} has no end in 16 MiB", self.line);
            Err(Error::new(ErrorKind::InvalidData, why))
        }
    }
}

/// Puts LF in place of CR LF and CR; how many bytes are left of these, which follow one `before`.
fn with_line_feeds(bytes: &mut [u8], mut before: u8) -> usize {
    if before != b'\r' && memchr(b'\r', bytes).is_none() {
        return bytes.len();
    }
    let mut kept = 0;
    for at in 0..bytes.len() {
        let byte = bytes[at];
        if (before, byte) != (b'\r', b'\n') {
            bytes[kept] = if byte == b'\r' { b'\n' } else { byte };
            kept += 1;
        }
        before = byte;
    }
    kept
}

#[cfg(test)]
mod tests {
    use std::io::BufReader;

    use super::*;

    /// What is said of a text that comes in parts of so many bytes.
    fn said(text: &str, part: usize) -> Option<String> {
        let mut quotes = Quotes::new(text.as_bytes(), b',');
        let mut buffer = vec![0; part];
        loop {
            match quotes.read(&mut buffer) {
                Ok(0) => return None,
                Ok(_) => {}
                Err(error) => return Some(error.to_string()),
            }
        }
    }

    #[test]
    fn every_line_ends_at_a_line_feed_however_the_bytes_come() {
        for part in [1, 2, 3, 5, 1000] {
            for (text, lines) in [
                ("", ""),
                ("a", "a\n"),
                ("a\n", "a\n"),
                ("a\r\nb\r\n", "a\nb\n"),
                ("a\rb\r", "a\nb\n"),
                ("a\r\r\n\nb", "a\n\n\nb\n"),
                ("\"a\r\nb\"\r\nc", "\"a\nb\"\nc\n"),
            ] {
                let (mut quotes, mut read) = (Quotes::new(text.as_bytes(), b','), String::new());
                let mut buffer = vec![0; part];
                loop {
                    match quotes.read(&mut buffer).expect("its quotes are closed") {
                        0 => break,
                        n => read.push_str(std::str::from_utf8(&buffer[..n]).expect("it is ASCII")),
                    }
                }
                assert_eq!(read, lines, "{text:?} in parts of {part}");
            }
        }
    }

    #[test]
    fn quotes_are_followed_however_the_bytes_come() {
        for part in [1, 2, 3, 5, 1000] {
            for whole in [
                "a,b\n1,2\n",
                "\"a\",\"b, c\"\n\"1\"\"2\",\"3\n4\"\n",
                "# it's \"said\n# ,\"\na\n5\" pipe,2\n",
                "a,b\r\n\"1\" ,\"2\"\r\n",
                "\"\"",
                "a,# no comment\n1,2",
            ] {
                assert_eq!(said(whole, part), None, "{whole}");
            }
            for (text, why) in [
                ("a,b\n1,\"2\n3,4\n", "line 2: a quote opens that nothing closes"),
                ("a,b\n\n\"", "line 3: a quote opens that nothing closes"),
                ("a,b\n1,\"2\n3,\"4\n", "line 2: a quote opens, and the cell goes on behind"),
                ("# \"\na\n\"1\"\"\n", "line 3: a quote opens that nothing closes"),
            ] {
                let said = said(text, part).expect(text);
                assert!(said.starts_with(why), "{part}: {said}");
            }
        }
    }

    #[test]
    fn a_mark_of_utf_8_is_no_text() {
        let log = "\u{feff}\"a\n1\n";
        assert!(said(log, 1000).is_some_and(|said| said.starts_with("line 1: a quote opens")));
        assert_eq!(said("\u{feff}\"a\",b\n1,2\n", 1000), None);
    }

    #[test]
    fn a_record_without_an_end_is_not_held() {
        for (start, why) in [("a\n\"", "line 2: a quote opens"), ("a\n1", "line 2 has no end")] {
            let endless = start.as_bytes().chain(std::io::repeat(b'1'));
            let error = std::io::copy(
                &mut BufReader::new(Quotes::new(endless, b',')),
                &mut std::io::sink(),
            );
            assert!(error.is_err_and(|error| error.to_string().starts_with(why)), "{why}");
        }
    }
}
