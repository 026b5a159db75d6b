//! A page in fewer characters that mean the same to a browser.
//!
//! HTML lets a page leave out the quotes around plain values of attributes and the ends of what its next neighbour ends
//! anyway: items, rows, cells, terms. Within pictures and formulas an element without content may end in its own tag. The
//! pages of a site have a hundred thousand of these.

/// The page, shorter.
pub(crate) fn shortened(page: &str) -> String {
    let mut out = String::with_capacity(page.len());
    let mut rest = page;
    while let Some((words, tag, after)) = next_tag(rest) {
        out.push_str(words);
        rest = after;
        if let Some(name) = tag.strip_prefix('/') {
            let empty = SHAPES.contains(&name) && out.ends_with('>');
            if empty && is_start_of(&out, name) {
                out.pop();
                out.push_str(" />");
            } else if !is_left_out(name, after) {
                push(&mut out, tag);
            }
        } else {
            push(&mut out, &unquoted(tag));
        }
    }
    out.push_str(rest);
    // an identifier of one sign is set as a parenthesis that does not stretch
    out.replace("<mo stretchy=false>(</mo>", "<mi>(</mi>")
        .replace("<mo stretchy=false>)</mo>", "<mi>)</mi>")
}

/// Shapes of SVG that have no content.
const SHAPES: [&str; 5] = ["rect", "path", "circle", "line", "mspace"];

/// Words, the inside of the tag behind them, and what follows; comments and declarations are words.
fn next_tag(text: &str) -> Option<(&str, &str, &str)> {
    let mut from = 0;
    loop {
        let open = from + text.get(from..)?.find('<')?;
        let inside = text.get(open + 1..)?;
        let is_tag = inside.starts_with(|c: char| c == '/' || c.is_ascii_alphabetic());
        if !is_tag {
            from = open + 1;
            continue;
        }
        let close = end_of_tag(inside)?;
        return Some((&text[..open], &inside[..close], &inside[close + 1..]));
    }
}

/// Where a tag ends: at the first bracket that is not within quotes.
fn end_of_tag(inside: &str) -> Option<usize> {
    let mut is_quoted = false;
    inside.bytes().position(|byte| {
        is_quoted ^= byte == b'"';
        byte == b'>' && !is_quoted
    })
}

fn push(out: &mut String, tag: &str) {
    out.push('<');
    out.push_str(tag);
    out.push('>');
}

/// Whether the last tag is the start of this element.
fn is_start_of(out: &str, name: &str) -> bool {
    let start = out.rfind('<').and_then(|at| out.get(at + 1..));
    start
        .and_then(|start| start.strip_prefix(name))
        .is_some_and(|rest| rest.starts_with([' ', '>']))
}

/// Whether the end of this element follows from what comes next.
fn is_left_out(name: &str, after: &str) -> bool {
    let starts = |tags: &[&str]| tags.iter().any(|tag| after.starts_with(tag));
    match name {
        "li" => starts(&["<li>", "<li ", "</ol>", "</ul>"]),
        "td" | "th" => starts(&["<td>", "<td ", "<th>", "<th ", "</tr>"]),
        "tr" => starts(&["<tr>", "<tr ", "</tbody>", "</thead>"]),
        "dt" => starts(&["<dd>", "<dd "]),
        "dd" => starts(&["</div>", "</dl>"]),
        "p" => starts(&["<p>", "<p ", "<ol>", "<ol ", "</div>", "</li>", "</details>"]),
        _ => false,
    }
}

/// A tag without the quotes that it does not need.
fn unquoted(tag: &str) -> String {
    let mut out = String::with_capacity(tag.len());
    for (number, part) in tag.split('"').enumerate() {
        let is_value = number % 2 == 1;
        if is_value && !is_plain(part) {
            out.push('"');
            out.push_str(part);
            out.push('"');
        } else if !is_value && number > 0 && part.starts_with('/') {
            // behind a value without quotes a slash would belong to it
            out.push(' ');
            out.push_str(part);
        } else {
            out.push_str(part);
        }
    }
    out
}

/// Whether a value is one without quotes, too.
fn is_plain(value: &str) -> bool {
    let is_special = |c: char| c.is_ascii_whitespace() || "\"'=<>`".contains(c);
    !value.is_empty() && !value.contains(is_special) && !value.ends_with('/')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_browser_adds_is_left_out() {
        for (page, short) in [
            (
                "<ol class=\"steps\"><li class=\"d0\">a</li><li>b</li></ol>",
                "<ol class=steps><li class=d0>a<li>b</ol>",
            ),
            (
                "<tr><td>1</td><th scope=\"row\">2</th></tr><tr></tr>",
                "<tr><td>1<th scope=row>2<tr></tr>",
            ),
            ("<div><p>a</p><p>b</p></div><p>c</p>d", "<div><p>a<p>b</div><p>c</p>d"),
            (
                "<rect x=\"1\" y=\"2\"></rect><text x=\"1\"></text>",
                "<rect x=1 y=2 /><text x=1></text>",
            ),
            ("<mo stretchy=\"false\">(</mo><mi>a</mi>", "<mi>(</mi><mi>a</mi>"),
            ("<path d=\"M0 0\"/><circle r=\"5\"/>", "<path d=\"M0 0\" /><circle r=5 />"),
        ] {
            assert_eq!(shortened(page), short);
        }
    }

    #[test]
    fn words_and_values_stay_as_they_are() {
        for page in [
            "a < b <!-- <li>x</li> --> c",
            "<a href=\"a/\">1</a>",
            "<a title=\"a > b\" href=\"x y\">1</a>",
            "<a title=\"\">1</a>",
            "<li>a</li> and b",
            "",
        ] {
            assert_eq!(shortened(page), page);
        }
    }
}
