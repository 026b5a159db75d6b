//! Lines and points over zones, in one plot.

use plotters::prelude::*;

use super::legend::{Legend, border, fill, looks};
use super::pixels::{Pixel, Window, height};
use super::scale::Scale;
use super::sheet::{Area, font, footer, px, sheet, upx};
use super::{Axis, Figure, Kind, NUMBERS, Series, WORDS, Zone, labels};
use crate::stability::PictureError;

/// The plot with its axes, the column of the legend beside it, and the title above, in pixels of the
/// picture.
const PLOT: (i32, i32) = (580, 560);
const LEGEND: i32 = 380;
const HEADER: i32 = 40;
/// The room of the axes' words.
const AXES: (i32, i32) = (72, 46);

pub(super) fn draw(
    figure: &Figure,
    series: &[Series],
    zones: &[Zone],
) -> Result<String, PictureError> {
    let legend = Legend::of(series, zones);
    let body = PLOT.1.max(legend.height() + 16);
    let height = HEADER + body + footer(&figure.notes);
    sheet((PLOT.0 + LEGEND, height), &figure.title, &figure.notes, |root| {
        let plot = Plot::of(root, figure, series, zones, height - HEADER - PLOT.1)?;
        plot.zones(root)?;
        plot.series(root, series)?;
        legend.draw(root, (PLOT.0 + 12, HEADER + 8))
    })
}

/// What is drawn, in pixels.
struct Plot {
    window: Window,
    /// by series, the points of every stretch without a break
    stretches: Vec<Vec<Vec<Pixel>>>,
    /// by zone, its borders, and whether it is above
    borders: Vec<Vec<(Vec<Pixel>, bool)>>,
}

impl Plot {
    /// Draws the axes and the mesh, and finds the pixels of everything else.
    fn of(
        root: &Area<'_>,
        figure: &Figure,
        series: &[Series],
        zones: &[Zone],
        below: i32,
    ) -> Result<Self, PictureError> {
        let mut chart = ChartBuilder::on(root)
            .margin_top(px(HEADER))
            .margin_left(px(12))
            .margin_right(px(LEGEND))
            .margin_bottom(px(below))
            .x_label_area_size(px(AXES.1))
            .y_label_area_size(px(AXES.0))
            .build_cartesian_2d(Scale::from(&figure.x), Scale::from(&figure.y))?;
        chart
            .configure_mesh()
            .x_desc(figure.x.label.clone())
            .y_desc(figure.y.label.clone())
            .axis_desc_style(font(WORDS))
            .label_style(font(NUMBERS))
            .axis_style(BLACK.stroke_width(upx(1)))
            .set_all_tick_mark_size(px(5))
            .light_line_style(TRANSPARENT)
            .bold_line_style(RGBColor(225, 225, 225).stroke_width(upx(1)))
            .draw()?;
        let area = chart.plotting_area();
        let (columns, rows) = area.get_pixel_range();
        let window = Window {
            left: columns.start,
            right: columns.end - 1,
            top: rows.start,
            bottom: rows.end - 1,
        };
        let is_seen = |(x, y): (f64, f64)| {
            let off = |axis: &Axis, value: f64| axis.is_logarithmic && value <= 0.0;
            !off(&figure.x, x) && !off(&figure.y, y)
        };
        let pixel = |at: (f64, f64)| is_seen(at).then(|| area.map_coordinate(&at));
        let stretches = |one: &Series| {
            let points = one.points.iter().map(|(x, y)| pixel((*x, (*y)?)));
            let points: Vec<Option<Pixel>> = points.collect();
            let parts = points.split(Option::is_none);
            parts.map(|part| part.iter().copied().flatten().collect()).collect()
        };
        let border = |border: &super::Border| {
            let points = border.points.iter().filter_map(|at| pixel(*at)).collect();
            (points, border.is_zone_above)
        };
        Ok(Self {
            window,
            stretches: series.iter().map(stretches).collect(),
            borders: zones.iter().map(|zone| zone.borders.iter().map(border).collect()).collect(),
        })
    }

    fn zones(&self, area: &Area<'_>) -> Result<(), PictureError> {
        let Window { left, right, top, bottom } = self.window;
        for (index, borders) in self.borders.iter().enumerate() {
            let mut polygons = Vec::new();
            for (line, is_above) in borders {
                let edge = if *is_above { top } else { bottom };
                let inside = |(x, y): &Pixel| (*x.clamp(&left, &right), *y.clamp(&top, &bottom));
                let mut polygon: Vec<Pixel> = line.iter().map(inside).collect();
                polygon.extend([(right, edge), (left, edge)]);
                polygons.push(polygon);
            }
            let is_inside = |(x, y): Pixel| {
                borders.iter().any(|(line, is_above)| {
                    height(line, x).is_some_and(|at| if *is_above { y < at } else { y > at })
                })
            };
            fill(area, index, &polygons, &self.window, is_inside)?;
            for (line, _) in borders {
                for part in self.window.cut(line) {
                    border(area, index, part)?;
                }
            }
        }
        Ok(())
    }

    /// The measured points that are seen.
    fn points(&self, series: &[Series]) -> Vec<Pixel> {
        let is_measured = |(one, _): &(&Series, _)| one.kind == Kind::Measured;
        let measured = series.iter().zip(&self.stretches).filter(is_measured);
        let points = measured.flat_map(|(_, stretches)| stretches.iter().flatten().copied());
        points.filter(|at| self.window.holds(*at)).collect()
    }

    fn series(&self, area: &Area<'_>, series: &[Series]) -> Result<(), PictureError> {
        let looks = looks(series);
        let parts: Vec<Vec<Vec<Pixel>>> = self
            .stretches
            .iter()
            .map(|stretches| stretches.iter().flat_map(|s| self.window.cut(s)).collect())
            .collect();
        let numbered = labels::places(&parts, &self.points(series), &self.window);
        let lines = || looks.iter().enumerate().filter(|(_, look)| look.is_line());
        // the first on top
        for (index, look) in lines().rev() {
            for part in parts.get(index).into_iter().flatten() {
                look.line(area, part)?;
            }
        }
        for (index, look) in lines() {
            for at in numbered.get(index).into_iter().flatten() {
                look.mark(area, *at)?;
            }
        }
        for (look, stretches) in looks.iter().zip(&self.stretches) {
            let points = stretches.iter().flatten().filter(|at| self.window.holds(**at));
            for at in points.filter(|_| !look.is_line()) {
                look.mark(area, *at)?;
            }
        }
        Ok(())
    }
}
