//! A canvas: what is drawn, in order, as SVG.

use std::fmt::Write as _;

use kane_algebra::syntax::visible;

use super::palette::{Ink, Pen, STYLE};
use super::trace::trace;
use super::{LEADING, NUMBERS, Point, TITLE, broken, count};
use crate::words;

/// Where words stand from their place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// A picture in the making.
pub(crate) struct Canvas {
    width: f64,
    height: f64,
    title: String,
    notes: Vec<String>,
    body: String,
}

/// Left and right of words.
const MARGIN: f64 = 12.0;

impl Canvas {
    /// A canvas of this size for what is drawn, with room above for a title and below for notes, which are also the
    /// description of the picture.
    pub(crate) fn new((width, height): Point, title: &str, notes: &[String]) -> Self {
        let columns = Self::columns(width);
        let notes: Vec<String> = notes.iter().flat_map(|note| broken(note, columns)).collect();
        Self { width, height, title: title.to_owned(), notes, body: String::new() }
    }

    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it saturates")]
    fn columns(width: f64) -> usize {
        ((width - 2.0 * MARGIN) / (0.52 * NUMBERS)) as usize
    }

    /// A line through points.
    pub(crate) fn line(&mut self, points: &[Point], pen: Pen) {
        if points.len() > 1 {
            self.path(&trace(points), pen);
        }
    }

    /// Lines of one pen as one element.
    pub(crate) fn lines<'a>(&mut self, lines: impl IntoIterator<Item = &'a [Point]>, pen: Pen) {
        let all: String = lines.into_iter().filter(|line| line.len() > 1).map(trace).collect();
        if !all.is_empty() {
            self.path(&all, pen);
        }
    }

    fn path(&mut self, d: &str, pen: Pen) {
        let class = pen.ink.class_with("line");
        let width = short(pen.width);
        let _ = write!(self.body, "<path{class} stroke-width=\"{width}\"");
        if !pen.dashes.is_empty() {
            let _ = write!(self.body, " stroke-dasharray=\"{}\"", pen.dashes);
        }
        if pen.strength < 1.0 {
            let _ = write!(self.body, " opacity=\"{}\"", short(pen.strength));
        }
        let _ = writeln!(self.body, " d=\"{d}\"/>");
    }

    /// An area within points.
    pub(crate) fn area(&mut self, points: &[Point], ink: Ink, strength: f64) {
        let class = ink.class();
        let opacity = opacity(strength);
        let d = trace(points);
        let _ = writeln!(self.body, "<path{class} fill=\"currentColor\"{opacity} d=\"{d}Z\"/>");
    }

    /// Upright rectangles of one ink, each by two corners, as one element.
    pub(crate) fn boxes(&mut self, boxes: &[(Point, Point)], ink: Ink, strength: f64) {
        if boxes.is_empty() {
            return;
        }
        let mut d = String::new();
        for ((left, top), (right, bottom)) in boxes {
            let (width, height) = (short(right - left), short(bottom - top));
            let _ = write!(
                d,
                "M{} {}h{width}v{height}h{}z",
                short(*left),
                short(*top),
                short(left - right)
            );
        }
        let (class, opacity) = (ink.class(), opacity(strength));
        let _ = writeln!(self.body, "<path{class} fill=\"currentColor\"{opacity} d=\"{d}\"/>");
    }

    /// A disc.
    pub(crate) fn dot(&mut self, at: Point, radius: f64, ink: Ink) {
        let (class, place) = (ink.class(), place(at, radius));
        let _ = writeln!(self.body, "<circle{class} fill=\"currentColor\" {place}/>");
    }

    /// A circle.
    pub(crate) fn ring(&mut self, at: Point, radius: f64, pen: Pen) {
        let (class, place) = (pen.ink.class_with("line"), place(at, radius));
        let (width, opacity) = (short(pen.width), opacity(pen.strength));
        let _ = writeln!(self.body, "<circle{class} stroke-width=\"{width}\"{opacity} {place}/>");
    }

    /// Words in one line, their middle at this height.
    pub(crate) fn words(&mut self, at: Point, words: &str, size: f64, anchor: Anchor) {
        self.set(at, words, size, (anchor, Ink::Text), "");
    }

    /// The same in an ink of its own.
    pub(crate) fn inked(&mut self, at: Point, words: &str, size: f64, anchor: Anchor, ink: Ink) {
        self.set(at, words, size, (anchor, ink), "");
    }

    /// The same in a heavier weight.
    pub(crate) fn bold(&mut self, at: Point, words: &str, size: f64) {
        self.set(at, words, size, (Anchor::Start, Ink::Text), " font-weight=\"bold\"");
    }

    /// Words from below to above, that begin, or have their middle, at this place.
    pub(crate) fn upright(&mut self, (x, y): Point, words: &str, size: f64, anchor: Anchor) {
        let turn = format!(" transform=\"rotate(-90 {} {})\"", short(x), short(y));
        self.set((x, y), words, size, (anchor, Ink::Text), &turn);
    }

    fn set(
        &mut self,
        (x, y): Point,
        words: &str,
        size: f64,
        (anchor, ink): (Anchor, Ink),
        more: &str,
    ) {
        if words.is_empty() {
            return;
        }
        let class = match anchor {
            Anchor::Start => ink.class(),
            Anchor::Middle => ink.class_with("middle"),
            Anchor::End => ink.class_with("end"),
        };
        let font = short(size);
        let font =
            if font == short(NUMBERS) { String::new() } else { format!(" font-size=\"{font}\"") };
        // a little more than a third of the size below the middle is the base line
        let base = y + 0.36 * size;
        // what is turned, turns about its place
        let (y, down) =
            if more.contains("rotate") { (short(y), " dy=\".36em\"") } else { (short(base), "") };
        let _ = writeln!(
            self.body,
            "<text{class} x=\"{}\" y=\"{y}\"{down}{font}{more}>{}</text>",
            short(x),
            shown(words)
        );
    }

    /// The picture as SVG: the body between its title and its notes.
    pub(crate) fn finish(self) -> String {
        let above = if self.title.is_empty() { 0.0 } else { 2.0 * TITLE };
        let below =
            LEADING * count(self.notes.len()) + if self.notes.is_empty() { 0.0 } else { 12.0 };
        let body = self.body.clone();
        let (width, height) = (self.width, self.height + above + below);
        let described = self.notes.join(" ");
        let mut frame = Self { body: String::new(), ..self };
        let title = frame.title.clone();
        frame.words((MARGIN, 20.0), &title, TITLE, Anchor::Start);
        let lines = std::mem::take(&mut frame.notes);
        for (line, note) in lines.iter().enumerate() {
            let y = height - below + LEADING * (count(line) + 0.6);
            frame.words((MARGIN, y), note, NUMBERS, Anchor::Start);
        }
        let (w, h, title) = (short(width), short(height), shown(&title));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"kane\" role=\"img\" width=\"{w}\" height=\"{h}\" viewBox=\"0 0 {w} {h}\">\n\
             <title>{title}</title>\n<desc>{}</desc>\n<style>{STYLE}</style>\n\
             <rect class=\"p\" fill=\"currentColor\" width=\"{w}\" height=\"{h}\"/>\n{}\
             <g transform=\"translate(0 {})\">\n{body}</g>\n</svg>\n",
            shown(&described),
            frame.body,
            short(above),
        )
    }
}

/// Words as XML, which has no way to write control characters.
fn shown(text: &str) -> String {
    words::escaped(&visible(text))
}

fn place((x, y): Point, radius: f64) -> String {
    format!("cx=\"{}\" cy=\"{}\" r=\"{}\"", short(x), short(y), short(radius))
}

fn opacity(strength: f64) -> String {
    if strength < 1.0 { format!(" opacity=\"{}\"", short(strength)) } else { String::new() }
}

/// A number to a hundredth, in as few characters as that takes.
fn short(number: f64) -> String {
    let text = format!("{number:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_has_a_title_a_description_and_a_dark_version() {
        let mut canvas = Canvas::new((100.0, 50.0), "k < 0 & more", &["what it shows".to_owned()]);
        canvas.line(&[(0.0, 1.0 / 3.0), (10.0, -0.001)], Pen::new(Ink::BLUE, 2.0));
        let svg = canvas.finish();
        assert!(svg.contains("<title>k &lt; 0 &amp; more</title>\n<desc>what it shows</desc>"));
        assert!(svg.contains("prefers-color-scheme:dark"));
        assert!(svg.contains("class=\"c0 line\" stroke-width=\"2\" d=\"M0 .33l10-.33\""));
    }

    #[test]
    fn words_of_a_picture_are_seen_and_end_nothing() {
        let hostile = "</desc><script>\u{1b}\u{202e}\n";
        let mut canvas = Canvas::new((100.0, 50.0), hostile, &[hostile.to_owned()]);
        canvas.words((1.0, 1.0), hostile, TITLE, Anchor::Start);
        let svg = canvas.finish();
        let shown = r"&lt;/desc&gt;&lt;script&gt;\u{1b}\u{202e}";
        // as title, description, their lines, and words
        assert_eq!(svg.matches(shown).count(), 5, "{svg}");
        assert!(!svg.contains("<script") && !svg.contains(['\u{1b}', '\u{202e}']), "{svg}");
    }
}
