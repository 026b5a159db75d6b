//! The opening of a log: all up to the end of the line that has its names, read ahead.

use std::io::{BufRead, Chain, Cursor, Error, ErrorKind, Read as _, Result};

/// A log whose opening was read ahead, to be read from its beginning.
pub type Whole<R> = Chain<Cursor<Vec<u8>>, R>;

/// How long comments and names may be together.
pub(crate) const LONGEST: usize = 1 << 24;

/// Reads a log up to the end of its first line that is neither empty nor a comment, however the bytes come:
/// what a pipe gives at once may end within a name. A line ends with a line feed or a carriage return. Gives
/// these bytes, and the log with them put back.
///
/// # Errors
/// Those of reading, and one if there is no such end in the first 16 MiB.
pub fn opening<R: BufRead>(mut input: R) -> Result<(Vec<u8>, Whole<R>)> {
    let (mut start, mut begin) = (Vec::new(), 0);
    loop {
        let chunk = input.fill_buf()?;
        let end = chunk.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
        let taken = end.map_or(chunk.len(), |end| end + 1);
        start.extend_from_slice(&chunk[..taken]);
        input.consume(taken);
        if taken == 0 || end.is_some() && !is_passed_over(&start[begin..]) {
            return Ok((start.clone(), Cursor::new(start).chain(input)));
        }
        if end.is_some() {
            begin = start.len();
        } else if start.len() > LONGEST {
            return Err(Error::new(ErrorKind::InvalidData, "the first line has no end in 16 MiB"));
        }
    }
}

/// What bytes are that are no text of a log, by how they begin.
#[must_use]
pub fn foreign(start: &[u8]) -> Option<&'static str> {
    const BEGINNINGS: [(&[u8], &str); 7] = [
        (b"PAR1", "Parquet, which `kane-lake check` reads"),
        (b"ARROW1", "Arrow, which `kane-lake check` reads"),
        (b"\xff\xfe", "text in UTF-16; save it as UTF-8"),
        (b"\xfe\xff", "text in UTF-16; save it as UTF-8"),
        (b"\x1f\x8b", "compressed; unpack it first"),
        (b"PK\x03\x04", "a packed file or a spreadsheet; save it as CSV"),
        (b"\x28\xb5\x2f\xfd", "compressed; unpack it first"),
    ];
    let known =
        BEGINNINGS.iter().find(|(bytes, _)| start.starts_with(bytes)).map(|(_, what)| *what);
    known.or_else(|| start.contains(&0).then_some("no text: it begins with bytes of zero"))
}

/// Whether a line has no names.
#[must_use]
pub fn is_passed_over(line: &[u8]) -> bool {
    line.starts_with(b"#") || line.trim_ascii().is_empty()
}

#[cfg(test)]
mod tests {
    use std::io::BufReader;

    use super::*;

    #[test]
    fn the_opening_is_whole_however_the_bytes_come() {
        let log = "# a comment\n\r\nmass,qvel[0] before\n1,2\n3,4\n";
        for capacity in [1, 3, 1000] {
            let input = BufReader::with_capacity(capacity, log.as_bytes());
            let (start, mut whole) = opening(input).expect("it is readable");
            assert_eq!(start, b"# a comment\n\r\nmass,qvel[0] before\n");
            assert_eq!(foreign(&start), None);
            let mut text = String::new();
            whole.read_to_string(&mut text).expect("it is readable");
            assert_eq!(text, log);
        }
        let (start, _) = opening("a,b\r1,2\r".as_bytes()).expect("it is readable");
        assert_eq!(start, b"a,b\r");
        let (start, _) = opening("no end".as_bytes()).expect("it is readable");
        assert_eq!(start, b"no end");
    }

    #[test]
    fn a_file_without_lines_is_not_held() {
        let zeros = BufReader::new(std::io::repeat(0));
        assert_eq!(foreign(b"PAR1\0\0"), Some("Parquet, which `kane-lake check` reads"));
        assert!(foreign(b"m\0a\0").is_some_and(|what| what.contains("no text")));
        assert!(opening(zeros).is_err_and(|error| error.to_string().contains("16 MiB")));
    }
}
