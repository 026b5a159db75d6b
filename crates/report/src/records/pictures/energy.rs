//! Where energy is gained.

use kane_records::study::Study;

use super::{HEIGHT, WIDTH, alpha_axis, frame, number, range};
use crate::picture::{Axis, Canvas, Ink, Key, Panel, Pen, Shape, legend, mark};

/// A gain beyond which a spot is drawn at the border.
const FAR: f64 = 2.0;

/// The picture; `None` where no energy is gained, or no row of those that show it slips.
pub(in crate::records) fn energy(study: &Study) -> Option<String> {
    if !study.spots.iter().any(|spot| spot.gains && spot.alpha.is_some()) {
        return None;
    }
    let spots = study.spots.iter().filter_map(|spot| {
        let alpha = spot.alpha.filter(|alpha| *alpha > 0.0)?;
        Some(((alpha, spot.gain.clamp(-1.0, FAR)), spot.gains))
    });
    let spots: Vec<_> = spots.collect();
    let title = "The change of energy by the energy before: where energy is created";
    let notes = [
        "A disc is an impact that creates energy beyond the tolerance of the check, a ring one that does not. \
         alpha = mu*W_tt*p_n/(2*|slip|): left of 1/2 friction slides all the time. Where the gain is beyond twice the \
         energy before, it is drawn there."
            .to_owned(),
    ];
    let mut canvas = Canvas::new((WIDTH, HEIGHT), title, &notes);
    let keys = [
        (Key::Mark(Shape::Disc, Ink::VERMILION), "energy is created"),
        (Key::Mark(Shape::Ring, Ink::BLUE), "it is not"),
    ];
    let top = legend(&mut canvas, (60.0, 4.0), WIDTH - 60.0, &keys) + 10.0;
    let (alpha, (low, high)) = alpha_axis(spots.iter().map(|((alpha, _), _)| *alpha));
    let axes = (
        alpha,
        Axis::linear("gain", range(spots.iter().map(|((_, gain), _)| *gain), (-1.0, 0.2)), number),
    );
    let panel = Panel::new(&mut canvas, frame(top, 14.0), axes, "");
    panel.line(&mut canvas, [(low, 0.0), (high, 0.0)], Pen::new(Ink::Text, 1.5));
    // those that gain are drawn last, on top
    for wanted in [false, true] {
        for (at, gains) in &spots {
            let Some(at) = panel.at(*at).filter(|at| *gains == wanted && panel.window.holds(*at))
            else {
                continue;
            };
            let (shape, ink) =
                if wanted { (Shape::Disc, Ink::VERMILION) } else { (Shape::Ring, Ink::BLUE) };
            mark(&mut canvas, at, shape, ink);
        }
    }
    Some(canvas.finish())
}
