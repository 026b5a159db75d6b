//! The motion as a strobe picture.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_scene::{Side, Strobe};
use plotters::prelude::*;

use super::SceneReport;
use crate::stability::PictureError;

/// The longer side of the drawing, the margin, and the header, in pixels.
const LONG: f64 = 860.0;
const MARGIN: f64 = 36.0;
const HEADER: f64 = 56.0;

/// Blue, vermilion, green and purple of the palette by Okabe and Ito.
const INKS: [RGBColor; 4] =
    [RGBColor(0, 114, 178), RGBColor(213, 94, 0), RGBColor(0, 158, 115), RGBColor(204, 121, 167)];

/// Metres to pixels.
struct Scale {
    left: f64,
    top: f64,
    by: f64,
    size: (u32, u32),
}

impl Scale {
    /// All centres with their radii, and the walls that bound them.
    fn of(strobe: &Strobe) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        let mut reach = |point: [f64; 2], radius: f64| {
            for k in 0..2 {
                low[k] = low[k].min(point[k] - radius);
                high[k] = high[k].max(point[k] + radius);
            }
        };
        for (path, radius) in strobe.paths.iter().zip(&strobe.radii) {
            path.iter().for_each(|point| reach(*point, *radius));
        }
        for (side, at) in &strobe.walls {
            match side {
                Side::Floor => low[1] = low[1].min(*at),
                Side::Ceiling => high[1] = high[1].max(*at),
                Side::Left => low[0] = low[0].min(*at),
                Side::Right => high[0] = high[0].max(*at),
            }
        }
        let extent = [high[0] - low[0], high[1] - low[1]];
        let by = LONG / extent[0].max(extent[1]).max(1e-9);
        let pixels = |length: f64, more: f64| whole((length * by).max(160.0) + 2.0 * MARGIN + more);
        let size = (pixels(extent[0], 0.0).max(560), pixels(extent[1], HEADER));
        Self {
            left: low[0],
            top: high[1],
            by,
            size: (size.0.unsigned_abs(), size.1.unsigned_abs()),
        }
    }

    fn at(&self, [x, y]: [f64; 2]) -> (i32, i32) {
        let across = MARGIN + (x - self.left) * self.by;
        (whole(across), whole(HEADER + MARGIN + (self.top - y) * self.by))
    }
}

/// The nearest pixel.
#[allow(clippy::cast_possible_truncation, reason = "a cast from float saturates")]
fn whole(x: f64) -> i32 {
    x.round() as i32
}

/// Many bodies are drawn at the start and at the end alone.
const FEW: usize = 4;

/// The motion as SVG: bodies at equal intervals, with a spoke that turns with them, and their ways;
/// `None` where nothing flies.
///
/// # Errors
/// [`PictureError`], which drawing into a string does not give in practice.
pub fn motion_picture(report: &SceneReport<'_>) -> Result<Option<String>, PictureError> {
    let Some(strobe) = &report.answer.strobe else { return Ok(None) };
    let scale = Scale::of(strobe);
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, scale.size).into_drawing_area();
        root.fill(&WHITE)?;
        let font = |size: i32| ("sans-serif", size).into_font();
        root.draw(&Text::new(report.title.clone(), (12, 8), font(20)))?;
        root.draw(&Text::new(caption(strobe, report), (12, 34), font(13)))?;
        let grey = RGBColor(90, 90, 90);
        let (width, height) = (scale.size.0.cast_signed(), scale.size.1.cast_signed());
        let left = whole(MARGIN) / 3;
        for (side, at) in &strobe.walls {
            let line = match side {
                Side::Floor | Side::Ceiling => {
                    let y = scale.at([0.0, *at]).1;
                    vec![(left, y), (width - left, y)]
                }
                Side::Left | Side::Right => {
                    let x = scale.at([*at, 0.0]).0;
                    vec![(x, whole(HEADER) + left), (x, height - left)]
                }
            };
            root.draw(&PathElement::new(line, grey.stroke_width(3)))?;
        }
        for (index, path) in strobe.paths.iter().enumerate() {
            let ink = INKS[index % INKS.len()];
            let mut points: Vec<(i32, i32)> = path.iter().map(|point| scale.at(*point)).collect();
            points.dedup();
            root.draw(&PathElement::new(points, ink.mix(0.45).stroke_width(1)))?;
        }
        let last = strobe.frames.len().saturating_sub(1);
        for (n, frame) in strobe.frames.iter().enumerate() {
            if strobe.radii.len() > FEW && n != 0 && n != last {
                continue;
            }
            // later is darker
            let strength = if n == last { 1.0 } else { 0.25 + 0.5 * share(n, last) };
            for (index, ((centre, angle), radius)) in
                frame.bodies.iter().zip(&strobe.radii).enumerate()
            {
                let ink = INKS[index % INKS.len()].mix(strength);
                let middle = scale.at(*centre);
                let pixels = whole(radius * scale.by).max(2);
                root.draw(&Circle::new(middle, pixels, ink.stroke_width(2)))?;
                let rim = [centre[0] + radius * angle.cos(), centre[1] + radius * angle.sin()];
                let spoke = vec![middle, scale.at(rim)];
                root.draw(&PathElement::new(spoke, ink.stroke_width(1)))?;
            }
        }
        root.present()?;
    }
    Ok(Some(svg))
}

fn share(n: usize, of: usize) -> f64 {
    let small = |n: usize| f64::from(u32::try_from(n).unwrap_or(u32::MAX));
    small(n) / small(of).max(1.0)
}

fn caption(strobe: &Strobe, report: &SceneReport<'_>) -> String {
    let apart = match &strobe.frames[..] {
        [first, second, ..] => second.time - first.time,
        _ => 0.0,
    };
    let how = match strobe.radii.len() > FEW {
        true => "first and last position, and the ways between".to_owned(),
        false => format!("every {} s, the spoke turns with the body", super::small(apart)),
    };
    let command = &report.command;
    format!("{how}; by {}; kane {}: {command}", report.answer.shown, env!("CARGO_PKG_VERSION"))
}
