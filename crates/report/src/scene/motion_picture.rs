//! The motion as a strobe picture.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_scene::{Side, Strobe};
use plotters::prelude::*;

use super::SceneReport;
use super::chart_frame::INKS;
use crate::stability::PictureError;

/// The longer side of the drawing, the margin, and the header, in pixels.
const LONG: f64 = 860.0;
const MARGIN: f64 = 36.0;
const HEADER: f64 = 56.0;

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

    /// A bar of a round length beside the caption, with the length.
    fn bar(&self, root: &super::chart_frame::Area<'_>) -> Result<(), PictureError> {
        let most = 150.0 / self.by;
        let ten = 10_f64.powf(most.log10().floor());
        let length = [5.0, 2.0, 1.0].map(|n| n * ten).into_iter().find(|length| *length <= most);
        let length = length.unwrap_or(ten);
        let right = self.size.0.cast_signed() - 16;
        let left = right - whole(length * self.by);
        let bar = vec![(left, 36), (left, 44), (left, 40), (right, 40), (right, 36), (right, 44)];
        root.draw(&PathElement::new(bar, BLACK.stroke_width(1)))?;
        let words = format!("{} m", super::brief(length));
        root.draw(&Text::new(words, (left, 18), ("sans-serif", 13).into_font()))?;
        Ok(())
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

/// The motion as SVG: bodies at equal intervals, with a spoke that turns with them, and their ways.
pub(super) fn motion_picture(
    report: &SceneReport<'_>,
    strobe: &Strobe,
) -> Result<String, PictureError> {
    let scale = Scale::of(strobe);
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, scale.size).into_drawing_area();
        root.fill(&WHITE)?;
        let font = |size: i32| ("sans-serif", size).into_font();
        root.draw(&Text::new(report.title.clone(), (12, 8), font(20)))?;
        root.draw(&Text::new(caption(strobe), (12, 34), font(13)))?;
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
        scale.bar(&root)?;
        root.present()?;
    }
    Ok(svg)
}

fn share(n: usize, of: usize) -> f64 {
    let small = |n: usize| f64::from(u32::try_from(n).unwrap_or(u32::MAX));
    small(n) / small(of).max(1.0)
}

fn caption(strobe: &Strobe) -> String {
    let apart = match &strobe.frames[..] {
        [first, second, ..] => second.time - first.time,
        _ => 0.0,
    };
    match strobe.radii.len() > FEW {
        true => "first and last position (dark), and the ways between".to_owned(),
        false => {
            format!(
                "every {} s, later is darker; the spoke turns with the body",
                super::brief(apart)
            )
        }
    }
}
