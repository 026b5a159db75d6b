//! Remarks as the commands by which a step of a GitHub workflow puts them beside lines.

use super::{Level, Remark};

/// A line for every remark but those that pass, of which a workflow would show the first ten alone.
#[must_use]
pub fn workflow(remarks: &[Remark]) -> String {
    let mut out = String::new();
    for remark in remarks {
        let command = match remark.level {
            Level::Error => "error",
            Level::Note => "notice",
            Level::Pass => continue,
        };
        let line = remark.line.map(|line| format!(",line={line}")).unwrap_or_default();
        let (file, title) = (property(&remark.file), property(&remark.title));
        let message = escaped(&remark.message);
        out.push_str(&format!("::{command} file={file}{line},title={title}::{message}\n"));
    }
    out
}

/// Text that ends at a line feed.
fn escaped(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// Text that ends at a colon or a comma, too.
fn property(text: &str) -> String {
    escaped(text).replace(':', "%3A").replace(',', "%2C")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_text_ends_a_command_or_begins_another() {
        let remark = |level| Remark {
            file: "a,b:c.md".to_owned(),
            line: Some(3),
            level,
            rule: "refuted".to_owned(),
            title: "claim (1), 100%".to_owned(),
            message: "refuted\n::error::mine %0A".to_owned(),
        };
        let shown = workflow(&[remark(Level::Error), remark(Level::Pass), remark(Level::Note)]);
        let lines: Vec<&str> = shown.lines().collect();
        assert_eq!(
            lines,
            [
                "::error file=a%2Cb%3Ac.md,line=3,title=claim (1)%2C 100%25::refuted%0A::error::mine %250A",
                "::notice file=a%2Cb%3Ac.md,line=3,title=claim (1)%2C 100%25::refuted%0A::error::mine %250A",
            ]
        );
    }
}
