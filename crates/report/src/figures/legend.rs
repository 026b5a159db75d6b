//! The legend, a column beside the plot.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use super::{Kind, Series, Zone};
use crate::picture::{
    Anchor, Canvas, Ink, LEADING, NUMBERS, Pen, Point, WORDS, Window, broken, count,
};

/// From one entry to the next, where the words begin, and how many characters fit.
const GAP: f64 = 4.0;
const INDENT: f64 = 46.0;
const COLUMNS: usize = 46;

/// How a series looks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Look {
    kind: Kind,
    /// its place among those of its kind
    place: usize,
    /// its number in the legend
    number: usize,
}

/// The zones, the graver first, and whether their hatching rises.
pub(super) const ZONES: [(Ink, bool); 2] = [(Ink::VERMILION, true), (Ink::SKY, false)];

/// The looks of the series, in their order.
pub(super) fn looks(series: &[Series]) -> Vec<Look> {
    let place = |index: usize, kind| series.iter().take(index).filter(|s| s.kind == kind).count();
    let look = |(index, one): (usize, &Series)| Look {
        kind: one.kind,
        place: place(index, one.kind),
        number: index + 1,
    };
    series.iter().enumerate().map(look).collect()
}

impl Look {
    const fn ink(self) -> Ink {
        match self.kind {
            Kind::Law => Ink::Series(self.place),
            Kind::Process | Kind::Measured => Ink::Text,
        }
    }

    pub(super) const fn is_line(self) -> bool {
        !matches!(self.kind, Kind::Measured)
    }

    /// Colour, width and dashes of a line.
    pub(super) fn pen(self) -> Pen {
        let dashes = match (self.kind, self.place) {
            (Kind::Law, place) => ["", "9 5", "2 4"][place % 3],
            (_, place) => ["", "9 5", "2 4", "16 4"][place % 4],
        };
        Pen::new(self.ink(), if self.place == 0 { 3.0 } else { 2.0 }).dashed(dashes)
    }

    /// The pen of error bars.
    pub(super) const fn bar(self) -> Pen {
        Pen::new(Ink::Text, 1.0).faint(0.7)
    }

    /// Draws the number of a line, or the shape of a point.
    pub(super) fn mark(self, canvas: &mut Canvas, at: Point) {
        let open = Pen::new(Ink::Text, 1.6);
        let (x, y) = at;
        match (self.is_line(), self.place) {
            (true, _) => {
                canvas.dot(at, 9.0, Ink::Paper);
                canvas.ring(at, 9.0, Pen::new(self.ink(), 1.0));
                canvas.words(at, &self.number.to_string(), NUMBERS, Anchor::Middle);
            }
            (false, 0) => canvas.dot(at, 4.0, Ink::Text),
            (false, 1) => {
                canvas.dot(at, 4.0, Ink::Paper);
                canvas.ring(at, 4.0, open);
            }
            (false, 2) => {
                canvas.area(
                    &[(x, y - 5.0), (x + 4.5, y + 3.5), (x - 4.5, y + 3.5)],
                    Ink::Text,
                    1.0,
                );
            }
            (false, _) => {
                canvas.line(&[(x - 4.0, y - 4.0), (x + 4.0, y + 4.0)], open);
                canvas.line(&[(x - 4.0, y + 4.0), (x + 4.0, y - 4.0)], open);
            }
        }
    }
}

/// Draws the inside of a zone, the `index`th: a tint and hatching.
pub(super) fn fill(
    canvas: &mut Canvas,
    index: usize,
    polygons: &[Vec<Point>],
    window: &Window,
    is_inside: impl Fn(Point) -> bool,
) {
    let (ink, rises) = ZONES[index.min(1)];
    for polygon in polygons {
        canvas.area(polygon, ink, 0.10);
    }
    let lines = window.hatch(rises, 14.0, is_inside);
    canvas.lines(lines.iter().map(Vec::as_slice), Pen::new(ink, 1.0).faint(0.55));
}

/// An entry: what stands before its words, and the words in lines.
enum Entry {
    Heading(&'static str),
    Series(Look, Vec<String>),
    Zone(usize, Vec<String>),
}

impl Entry {
    fn height(&self) -> f64 {
        let lines = match self {
            Self::Heading(_) => 1,
            Self::Series(_, lines) | Self::Zone(_, lines) => lines.len(),
        };
        LEADING * count(lines) + GAP
    }
}

/// The legend of a figure.
pub(super) struct Legend(Vec<Entry>);

impl Legend {
    pub(super) fn of(series: &[Series], zones: &[Zone]) -> Self {
        let mut entries = Vec::new();
        let mut kind = None;
        for (one, look) in series.iter().zip(looks(series)) {
            if kind.replace(one.kind) != Some(one.kind) {
                entries.push(Entry::Heading(match one.kind {
                    Kind::Law => "Rigid laws",
                    Kind::Process => "Processes in time",
                    Kind::Measured => "Measured",
                }));
            }
            entries.push(Entry::Series(look, broken(&one.names.join(", "), COLUMNS)));
        }
        if !zones.is_empty() {
            entries.push(Entry::Heading("Zones"));
        }
        let zone = |(index, zone): (usize, &Zone)| Entry::Zone(index, broken(&zone.name, COLUMNS));
        entries.extend(zones.iter().enumerate().map(zone));
        Self(entries)
    }

    pub(super) fn height(&self) -> f64 {
        self.0.iter().map(Entry::height).sum()
    }

    /// Draws it with its upper left corner here.
    pub(super) fn draw(&self, canvas: &mut Canvas, (left, mut y): Point) {
        let right = left + 38.0;
        for entry in &self.0 {
            let middle = y + LEADING / 2.0;
            let words: &[String] = match entry {
                Entry::Heading(words) => {
                    canvas.bold((left, middle), words, WORDS);
                    &[]
                }
                Entry::Series(look, words) => {
                    // the dashes of a line are seen beside its number
                    if look.is_line() {
                        canvas.line(&[(left - 8.0, middle), (right, middle)], look.pen());
                        look.mark(canvas, (right - 9.0, middle));
                    } else {
                        look.mark(canvas, (left + 15.0, middle));
                    }
                    words
                }
                Entry::Zone(index, words) => {
                    let (top, bottom) = (y + 1.0, y + LEADING - 3.0);
                    let window = Window { left, right, top, bottom };
                    let corners = vec![(left, top), (right, top), (right, bottom), (left, bottom)];
                    fill(canvas, *index, &[corners], &window, |_| true);
                    words
                }
            };
            for (line, words) in words.iter().enumerate() {
                let at = (left + INDENT, middle + LEADING * count(line));
                canvas.words(at, words, WORDS, Anchor::Start);
            }
            y += entry.height();
        }
    }
}
