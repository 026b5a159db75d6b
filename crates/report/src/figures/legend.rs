//! The legend, a column beside the plot.

use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::hatch::Hatch;
use super::pixels::{Pixel, Window};
use super::sheet::{Area, font, px, upx, wrapped};
use super::{Kind, NUMBERS, PALETTE, Series, WORDS, Zone};
use crate::stability::PictureError;

/// From one line of words to the next, and from one entry to the next; pixels of the picture.
const LINE: i32 = 17;
const GAP: i32 = 4;
/// Where the words begin, and how many characters fit.
const INDENT: i32 = 46;
const COLUMNS: usize = 42;

/// How a series looks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Look {
    kind: Kind,
    /// its place among those of its kind
    place: usize,
    /// its number in the legend
    number: usize,
}

/// Length and gap of dashes, in pixels of the picture; the first is a full line.
const DASHES: [Option<(i32, i32)>; 4] = [None, Some((9, 5)), Some((2, 4)), Some((16, 4))];
/// The zones, the graver first.
const ZONES: [(RGBColor, Hatch); 2] =
    [(RGBColor(213, 94, 0), Hatch::Rising), (RGBColor(86, 180, 233), Hatch::Falling)];

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
    fn colour(self) -> RGBColor {
        match self.kind {
            Kind::Law => PALETTE.into_iter().cycle().nth(self.place).unwrap_or(BLACK),
            Kind::Process | Kind::Measured => BLACK,
        }
    }

    pub(super) const fn is_line(self) -> bool {
        !matches!(self.kind, Kind::Measured)
    }

    /// Draws a line in its colour and its dashes.
    pub(super) fn line(self, area: &Area<'_>, points: &[Pixel]) -> Result<(), PictureError> {
        let style = self.colour().stroke_width(if self.place == 0 { upx(3) } else { upx(2) });
        let dashes = if self.kind == Kind::Law { 3 } else { 4 };
        match DASHES.get(self.place % dashes).copied().flatten() {
            None => area.draw(&PathElement::new(points.to_vec(), style))?,
            Some((dash, gap)) => {
                area.draw(&DashedPathElement::new(
                    points.iter().copied(),
                    px(dash),
                    px(gap),
                    style,
                ))?;
            }
        }
        Ok(())
    }

    /// Draws the number of a line, or the shape of a point.
    pub(super) fn mark(self, area: &Area<'_>, at: Pixel) -> Result<(), PictureError> {
        let (full, open) = (BLACK.filled(), BLACK.stroke_width(upx(2)));
        if self.is_line() {
            area.draw(&Circle::new(at, px(9), WHITE.filled()))?;
            area.draw(&Circle::new(at, px(9), self.colour().stroke_width(upx(1))))?;
            let centre = Pos::new(HPos::Center, VPos::Center);
            let font = font(NUMBERS).pos(centre);
            area.draw(&Text::new(self.number.to_string(), at, font))?;
            return Ok(());
        }
        match self.place {
            0 => area.draw(&Circle::new(at, px(4), full))?,
            1 => {
                area.draw(&Circle::new(at, px(4), WHITE.filled()))?;
                area.draw(&Circle::new(at, px(4), open))?;
            }
            2 => area.draw(&TriangleMarker::new(at, px(6), full))?,
            _ => area.draw(&Cross::new(at, px(4), open))?,
        }
        Ok(())
    }
}

/// Draws the inside of a zone, the `index`th: a tint and hatching.
pub(super) fn fill(
    area: &Area<'_>,
    index: usize,
    polygons: &[Vec<Pixel>],
    window: &Window,
    is_inside: impl Fn(Pixel) -> bool,
) -> Result<(), PictureError> {
    let (colour, hatch) = ZONES[index.min(1)];
    for polygon in polygons {
        area.draw(&Polygon::new(polygon.clone(), colour.mix(0.10).filled()))?;
    }
    for line in hatch.lines(window, px(14), is_inside) {
        area.draw(&PathElement::new(line.to_vec(), colour.mix(0.55).stroke_width(upx(1))))?;
    }
    Ok(())
}

/// The border of a zone.
pub(super) fn border(area: &Area<'_>, index: usize, line: Vec<Pixel>) -> Result<(), PictureError> {
    let (colour, _) = ZONES[index.min(1)];
    area.draw(&PathElement::new(line, colour.stroke_width(upx(1))))?;
    Ok(())
}

/// An entry: what stands before its words, and the words in lines.
enum Entry {
    Heading(&'static str),
    Series(Look, Vec<String>),
    Zone(usize, Vec<String>),
}

impl Entry {
    fn height(&self) -> i32 {
        let lines = match self {
            Self::Heading(_) => 1,
            Self::Series(_, lines) | Self::Zone(_, lines) => lines.len(),
        };
        LINE * i32::try_from(lines).unwrap_or(1) + GAP
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
            entries.push(Entry::Series(look, wrapped(&one.names.join(", "), COLUMNS)));
        }
        if !zones.is_empty() {
            entries.push(Entry::Heading("Zones"));
        }
        let zone = |(index, zone): (usize, &Zone)| Entry::Zone(index, wrapped(&zone.name, COLUMNS));
        entries.extend(zones.iter().enumerate().map(zone));
        Self(entries)
    }

    /// How high it is, in pixels of the picture.
    pub(super) fn height(&self) -> i32 {
        self.0.iter().map(Entry::height).sum()
    }

    /// Draws it with its upper left corner here, in pixels of the picture.
    pub(super) fn draw(&self, area: &Area<'_>, (x, mut y): Pixel) -> Result<(), PictureError> {
        for entry in &self.0 {
            let middle = px(y + LINE / 2 - 1);
            let (left, right) = (px(x), px(x + 38));
            let words: &[String] = match entry {
                Entry::Heading(words) => {
                    let bold = ("sans-serif", px(WORDS)).into_font().style(FontStyle::Bold);
                    area.draw(&Text::new(*words, (left, px(y)), bold))?;
                    &[]
                }
                Entry::Series(look, words) => {
                    if look.is_line() {
                        look.line(area, &[(left, middle), (right, middle)])?;
                    }
                    look.mark(area, (px(x + 19), middle))?;
                    words
                }
                Entry::Zone(index, words) => {
                    let (top, bottom) = (px(y - 1), px(y + LINE - 3));
                    let window = Window { left, right, top, bottom };
                    let corners = vec![(left, top), (right, top), (right, bottom), (left, bottom)];
                    fill(area, *index, std::slice::from_ref(&corners), &window, |_| true)?;
                    let around: Vec<Pixel> =
                        corners.iter().chain(corners.first()).copied().collect();
                    border(area, *index, around)?;
                    words
                }
            };
            for (line, at) in words.iter().zip((y..).step_by(17)) {
                area.draw(&Text::new(line.clone(), (px(x + INDENT), px(at)), font(WORDS)))?;
            }
            y += entry.height();
        }
        Ok(())
    }
}
