//! Stretches of one variable at values of another, a panel a case.

use plotters::prelude::*;

use super::scale::Scale;
use super::sheet::{Area, font, footer, px, sheet, upx};
use super::{Figure, NUMBERS, PALETTE, Panel, WORDS};
use crate::stability::PictureError;

/// Size of a panel, in pixels of the picture; panels in a row.
const PANEL: (i32, i32) = (240, 250);
const COLUMNS: usize = 4;
const HEADER: i32 = 44;

pub(super) fn draw(figure: &Figure, panels: &[Panel]) -> Result<String, PictureError> {
    let rows = panels.len().div_ceil(COLUMNS).max(1);
    let body = PANEL.1 * i32::try_from(rows).unwrap_or(1);
    let width = PANEL.0 * i32::try_from(COLUMNS).unwrap_or(1);
    let height = HEADER + body + footer(&figure.notes);
    sheet((width, height), &figure.title, &figure.notes, |root| {
        let (_, rest) = root.split_vertically(px(HEADER));
        let (body, _) = rest.split_vertically(px(body));
        for (panel, area) in panels.iter().zip(body.split_evenly((rows, COLUMNS))) {
            draw_panel(&area, figure, panel)?;
        }
        Ok(())
    })
}

fn draw_panel(area: &Area<'_>, figure: &Figure, panel: &Panel) -> Result<(), PictureError> {
    let [body, law] = &panel.case;
    area.draw(&Text::new(law.clone(), (px(62), px(6)), font(WORDS)))?;
    area.draw(&Text::new(body.clone(), (px(62), px(24)), font(NUMBERS)))?;
    let (x, y) = (&figure.x, &figure.y);
    let mut chart = ChartBuilder::on(area)
        .margin_top(px(44))
        .margin_left(px(10))
        .margin_right(px(14))
        .margin_bottom(px(8))
        .x_label_area_size(px(40))
        .y_label_area_size(px(50))
        .build_cartesian_2d(Scale::from(x), Scale::from(y))?;
    chart
        .configure_mesh()
        .x_desc(x.label.clone())
        .y_desc(y.label.clone())
        .axis_desc_style(font(NUMBERS))
        .label_style(font(NUMBERS))
        .axis_style(BLACK.stroke_width(upx(1)))
        .set_all_tick_mark_size(px(5))
        .light_line_style(TRANSPARENT)
        .bold_line_style(RGBColor(225, 225, 225).stroke_width(upx(1)))
        .draw()?;
    let plot = chart.plotting_area();
    // a bar is nearly as high as the axis has room for each value
    let (_, rows) = plot.get_pixel_range();
    let half = (rows.end - rows.start) / 27;
    let (columns, lines) = area.get_pixel_range();
    for stretch in &panel.stretches {
        let to = stretch.to.unwrap_or(x.range.1);
        let (left, middle) = plot.map_coordinate(&(stretch.from, stretch.y));
        let (right, _) = plot.map_coordinate(&(to, stretch.y));
        let corners = [
            (left - columns.start, middle - half - lines.start),
            (right - columns.start, middle + half - lines.start),
        ];
        area.draw(&Rectangle::new(corners, PALETTE[1].mix(0.75).filled()))?;
        area.draw(&Rectangle::new(corners, BLACK.stroke_width(upx(1))))?;
    }
    Ok(())
}
