//! The motion as a strobe picture.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_scene::{Side, Strobe};

use super::{SceneReport, brief, notes};
use crate::picture::{Anchor, Canvas, Ink, NUMBERS, Pen, Point, count};

/// The longer side of the drawing, and the margin.
const LONG: f64 = 860.0;
const MARGIN: f64 = 36.0;
/// Above the drawing, for the bar.
const HEAD: f64 = 34.0;

/// Metres to pixels.
struct Scale {
    left: f64,
    top: f64,
    by: f64,
    size: Point,
}

impl Scale {
    /// All centres with their radii, and the walls that bound them.
    fn of(strobe: &Strobe) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for (path, radius) in strobe.paths.iter().zip(&strobe.radii) {
            for point in path {
                for k in 0..2 {
                    low[k] = low[k].min(point[k] - radius);
                    high[k] = high[k].max(point[k] + radius);
                }
            }
        }
        for (side, at) in &strobe.walls {
            match side {
                Side::Floor => low[1] = low[1].min(*at),
                Side::Ceiling => high[1] = high[1].max(*at),
                Side::Left => low[0] = low[0].min(*at),
                Side::Right => high[0] = high[0].max(*at),
                Side::Plane(_) | Side::Back | Side::Front => {}
            }
        }
        let extent = [high[0] - low[0], high[1] - low[1]];
        let by = LONG / extent[0].max(extent[1]).max(1e-9);
        let pixels = |length: f64| (length * by).max(160.0) + 2.0 * MARGIN;
        let size = (pixels(extent[0]).max(560.0), pixels(extent[1]) + HEAD);
        Self { left: low[0], top: high[1], by, size }
    }

    /// A bar of a round length at the right, with the length.
    fn bar(&self, canvas: &mut Canvas) {
        let most = 150.0 / self.by;
        let ten = 10_f64.powf(most.log10().floor());
        let length = [5.0, 2.0, 1.0].map(|n| n * ten).into_iter().find(|length| *length <= most);
        let length = length.unwrap_or(ten);
        let right = self.size.0 - 16.0;
        let left = right - length * self.by;
        let ends =
            [(left, 20.0), (left, 28.0), (left, 24.0), (right, 24.0), (right, 20.0), (right, 28.0)];
        canvas.line(&ends, Pen::new(Ink::Text, 1.0));
        canvas.words((left, 10.0), &format!("{} m", brief(length)), NUMBERS, Anchor::Start);
    }

    fn at(&self, [x, y]: [f64; 2]) -> Point {
        (MARGIN + (x - self.left) * self.by, HEAD + MARGIN + (self.top - y) * self.by)
    }
}

/// The part of a straight line that is within a rectangle.
fn within(through: Point, along: [f64; 2], inside: [(f64, f64); 2]) -> Option<[Point; 2]> {
    let (mut from, mut to) = (f64::NEG_INFINITY, f64::INFINITY);
    for ((start, step), (low, high)) in
        [(through.0, along[0]), (through.1, along[1])].into_iter().zip(inside)
    {
        let ends = [(low - start) / step, (high - start) / step];
        if step == 0.0 {
            if start < low || high < start {
                return None;
            }
            continue;
        }
        from = from.max(ends[0].min(ends[1]));
        to = to.min(ends[0].max(ends[1]));
    }
    let at = |t: f64| (through.0 + t * along[0], through.1 + t * along[1]);
    (from < to).then(|| [at(from), at(to)])
}

/// Many bodies are drawn at the start and at the end alone.
const FEW: usize = 4;

/// The motion as SVG: bodies at equal intervals, with a spoke that turns with them, and their ways.
pub(super) fn motion_picture(report: &SceneReport<'_>, strobe: &Strobe) -> String {
    let scale = Scale::of(strobe);
    let mut canvas = Canvas::new(scale.size, &report.title, &notes(report, &caption(strobe)));
    let (width, height) = scale.size;
    let edge = MARGIN / 3.0;
    for (side, at) in &strobe.walls {
        let line = match side {
            Side::Floor | Side::Ceiling => {
                let y = scale.at([0.0, *at]).1;
                [(edge, y), (width - edge, y)]
            }
            Side::Left | Side::Right => {
                let x = scale.at([*at, 0.0]).0;
                [(x, HEAD + edge), (x, height - edge)]
            }
            // what is behind or in front covers the sheet
            Side::Plane(_) | Side::Back | Side::Front => continue,
        };
        canvas.line(&line, Pen::new(Ink::Quiet, 3.0));
    }
    let inside = [(edge, width - edge), (HEAD + edge, height - edge)];
    for (point, along) in &strobe.planes {
        let through = scale.at(*point);
        // the picture's y is downwards
        if let Some(line) = within(through, [along[0], -along[1]], inside) {
            canvas.line(&line, Pen::new(Ink::Quiet, 3.0));
        }
    }
    for (index, path) in strobe.paths.iter().enumerate() {
        let mut points: Vec<Point> = path.iter().map(|point| scale.at(*point)).collect();
        points.dedup();
        canvas.line(&points, Pen::new(Ink::Series(index), 1.0).faint(0.6));
    }
    let last = strobe.frames.len().saturating_sub(1);
    for (n, frame) in strobe.frames.iter().enumerate() {
        if strobe.radii.len() > FEW && n != 0 && n != last {
            continue;
        }
        // later is darker
        let strength = if n == last { 1.0 } else { 0.3 + 0.45 * count(n) / count(last).max(1.0) };
        for (index, (body, radius)) in frame.bodies.iter().zip(&strobe.radii).enumerate() {
            // what rests is drawn once, at the end
            if strobe.frames.get(n + 1).is_some_and(|next| next.bodies.get(index) == Some(body)) {
                continue;
            }
            let (centre, angle) = body;
            let middle = scale.at(*centre);
            let ink = Ink::Series(index);
            if !strobe.corners.is_empty() {
                let outline = outline(&strobe.corners, *centre, *angle);
                let outline: Vec<Point> = outline.into_iter().map(|at| scale.at(at)).collect();
                canvas.line(&outline, Pen::new(ink, 2.0).faint(strength));
                continue;
            }
            canvas.ring(middle, (radius * scale.by).max(2.0), Pen::new(ink, 2.0).faint(strength));
            if strobe.is_in_space {
                continue;
            }
            let rim = [centre[0] + radius * angle.cos(), centre[1] + radius * angle.sin()];
            canvas.line(&[middle, scale.at(rim)], Pen::new(ink, 1.0).faint(strength));
        }
    }
    numbers(&mut canvas, &scale, strobe);
    arrows(&mut canvas, &scale, strobe);
    scale.bar(&mut canvas);
    canvas.finish()
}

/// The least of a ring in which a number has room, in pixels.
const ROOM: f64 = 9.0;

/// Bodies by their numbers, at the start and at the end; one alone needs none.
fn numbers(canvas: &mut Canvas, scale: &Scale, strobe: &Strobe) {
    let ends = [strobe.frames.first(), strobe.frames.last()];
    if strobe.radii.len() < 2 {
        return;
    }
    for (index, radius) in strobe.radii.iter().enumerate() {
        let mut drawn: Option<[f64; 2]> = None;
        for frame in ends.iter().flatten() {
            let Some((centre, _)) = frame.bodies.get(index) else { continue };
            // what rests has one number
            if drawn.replace(*centre) == Some(*centre) {
                continue;
            }
            let ((x, y), reach) = (scale.at(*centre), radius * scale.by);
            let y = if reach < ROOM { y - reach - 8.0 } else { y };
            canvas.words((x, y), &(index + 1).to_string(), NUMBERS, Anchor::Middle);
        }
    }
}

/// An arrow from where the motion ends, by the velocity: the fastest is as long as this, in pixels.
const ARROW: f64 = 30.0;

/// Where bodies go on after the last impact.
fn arrows(canvas: &mut Canvas, scale: &Scale, strobe: &Strobe) {
    let Some(last) = strobe.frames.last() else { return };
    let fastest = strobe.leaving.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max);
    for (index, ((centre, _), [vx, vy])) in last.bodies.iter().zip(&strobe.leaving).enumerate() {
        let speed = vx.hypot(*vy);
        // what hardly moves has no direction to show
        if speed <= 0.05 * fastest {
            continue;
        }
        let (x, y) = scale.at(*centre);
        let (along, up) = (vx / speed, -vy / speed);
        let radius = strobe.radii.get(index).copied().unwrap_or(0.0);
        let is_round = strobe.corners.is_empty();
        let reach = if is_round { (radius * scale.by).max(2.0) + 3.0 } else { 0.0 };
        let length = ARROW * speed / fastest;
        let at =
            |far: f64, beside: f64| (x + along * far - up * beside, y + up * far + along * beside);
        let tip = reach + length;
        let pen = Pen::new(Ink::Series(index), 1.5);
        canvas.line(&[at(reach, 0.0), at(tip, 0.0)], pen);
        canvas.line(&[at(tip - 6.0, 3.5), at(tip, 0.0), at(tip - 6.0, -3.5)], pen);
    }
}

/// The corners of a body that is turned, and the first again.
fn outline(corners: &[[f64; 2]], [x, y]: [f64; 2], angle: f64) -> Vec<[f64; 2]> {
    let (sin, cos) = angle.sin_cos();
    let at = |[a, b]: &[f64; 2]| [x + a * cos - b * sin, y + a * sin + b * cos];
    corners.iter().chain(corners.first()).map(at).collect()
}

fn caption(strobe: &Strobe) -> String {
    let apart = brief(strobe.apart);
    let impacts = if strobe.shows_impacts { " and at each impact" } else { "" };
    let goes_on = match strobe.leaving.is_empty() {
        true => "",
        false => " Arrows: velocities after the last impact.",
    };
    if strobe.apart == 0.0 {
        return format!("The impact, at the start.{goes_on}");
    }
    match strobe.radii.len() > FEW {
        true => format!("First and last position (full), and the ways between.{goes_on}"),
        false if !strobe.corners.is_empty() => format!(
            "Every {apart} s{impacts}, later is stronger; the line is the way of the centre.{goes_on}"
        ),
        false if strobe.is_in_space => {
            format!("Seen along z. Every {apart} s{impacts}, later is stronger.{goes_on}")
        }
        false => format!(
            "Every {apart} s{impacts}, later is stronger; the spoke turns with the body.{goes_on}"
        ),
    }
}
