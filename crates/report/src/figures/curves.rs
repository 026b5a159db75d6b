//! Lines and points over zones, in one plot.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use super::legend::{Legend, Look, ZONES, fill, looks};
use super::{Figure, Kind, Series, Zone, labels};
use crate::picture::{Canvas, Frame, Panel, Pen, Point, height};

/// The plot with its axes, and the column of the legend beside it.
const PLOT: Point = (580.0, 560.0);
const LEGEND: f64 = 380.0;

pub(super) fn draw(figure: &Figure, series: &[Series], zones: &[Zone]) -> String {
    let legend = Legend::of(series, zones);
    let size = (PLOT.0 + LEGEND, PLOT.1.max(legend.height() + 16.0));
    let mut canvas = Canvas::new(size, &figure.title, &figure.notes);
    let frame = Frame { at: (8.0, 0.0), size: PLOT, head: 8.0, beside: 8.0 };
    let panel = Panel::new(&mut canvas, frame, (figure.x.drawn(), figure.y.drawn()), "");
    for (index, zone) in zones.iter().enumerate() {
        draw_zone(&mut canvas, &panel, index, zone);
    }
    draw_series(&mut canvas, &panel, series);
    legend.draw(&mut canvas, (PLOT.0 + 20.0, 8.0));
    canvas.finish()
}

fn draw_zone(canvas: &mut Canvas, panel: &Panel, index: usize, zone: &Zone) {
    let window = panel.window;
    let borders: Vec<(Vec<Point>, bool)> = zone
        .borders
        .iter()
        .map(|border| (panel.places(border.points.iter().copied()), border.is_zone_above))
        .collect();
    let polygons: Vec<Vec<Point>> = borders
        .iter()
        .map(|(line, is_above)| {
            let edge = if *is_above { window.top } else { window.bottom };
            let inside = |(x, y): &Point| {
                (x.clamp(window.left, window.right), y.clamp(window.top, window.bottom))
            };
            let corners = [(window.right, edge), (window.left, edge)];
            line.iter().map(inside).chain(corners).collect()
        })
        .collect();
    let is_inside = |(x, y): Point| {
        borders.iter().any(|(line, is_above)| {
            height(line, x).is_some_and(|at| if *is_above { y < at } else { y > at })
        })
    };
    fill(canvas, index, &polygons, &window, is_inside);
    for (line, _) in &borders {
        let parts = window.cut(line);
        canvas.lines(parts.iter().map(Vec::as_slice), Pen::new(ZONES[index.min(1)].0, 1.0));
    }
}

fn draw_series(canvas: &mut Canvas, panel: &Panel, series: &[Series]) {
    let looks = looks(series);
    // by series, the places of every stretch without a break
    let stretches: Vec<Vec<Vec<Point>>> = series
        .iter()
        .map(|one| {
            let places: Vec<Option<Point>> =
                one.points.iter().map(|(x, y)| panel.at((*x, (*y)?))).collect();
            let parts = places.split(Option::is_none);
            parts.map(|part| part.iter().copied().flatten().collect()).collect()
        })
        .collect();
    let window = panel.window;
    let parts: Vec<Vec<Vec<Point>>> = stretches
        .iter()
        .map(|stretches| stretches.iter().flat_map(|stretch| window.cut(stretch)).collect())
        .collect();
    let seen = |index: usize| -> Vec<Point> {
        stretches[index].iter().flatten().copied().filter(|at| window.holds(*at)).collect()
    };
    let measured = (0..series.len()).filter(|index| series[*index].kind == Kind::Measured);
    let numbered = labels::places(&parts, &measured.flat_map(seen).collect::<Vec<_>>(), &window);
    let lines = || looks.iter().enumerate().filter(|(_, look)| look.is_line());
    // the first on top
    for (index, look) in lines().rev() {
        canvas.lines(parts[index].iter().map(Vec::as_slice), look.pen());
    }
    for (index, look) in lines() {
        for at in &numbered[index] {
            look.mark(canvas, *at);
        }
    }
    for (one, look) in series.iter().zip(&looks).filter(|(_, look)| !look.is_line()) {
        draw_bars(canvas, panel, one, look.bar());
    }
    for (index, look) in
        looks.iter().enumerate().filter(|(_, look): &(usize, &Look)| !look.is_line())
    {
        for at in seen(index) {
            look.mark(canvas, at);
        }
    }
}

/// What each point may be off, as far as it is in the window.
fn draw_bars(canvas: &mut Canvas, panel: &Panel, series: &Series, pen: Pen) {
    let ends = series.points.iter().zip(&series.bars).filter_map(|((x, y), bar)| {
        let y = (*y)?;
        Some([panel.at((*x, y - bar))?, panel.at((*x, y + bar))?])
    });
    let parts: Vec<Vec<Point>> = ends.flat_map(|ends| panel.window.cut(&ends)).collect();
    canvas.lines(parts.iter().map(Vec::as_slice), pen);
}
