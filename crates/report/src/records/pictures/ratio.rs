//! k over α, on the curves of laws of friction.

use kane_records::friction::FrictionLaw;
use kane_records::scatter::{Spot, curve, stated};
use kane_records::study::Study;

use super::super::wording::{brief, friction_name};
use super::{HEIGHT, WIDTH, alpha_axis, frame, number, range};
use crate::picture::{Axis, Canvas, Ink, Key, Panel, Pen, Point, Shape, legend, mark};

/// Points of a curve.
const POINTS: u32 = 300;
/// k beyond which a spot is drawn at the border.
const FAR: f64 = 1.5;

/// The spots with α and k.
fn placed(spots: &[Spot]) -> Vec<(Point, &Spot)> {
    let mut placed = Vec::new();
    for spot in spots {
        if let (Some(alpha @ 0.0..), Some(ratio)) = (spot.alpha, spot.ratio) {
            placed.push(((alpha, ratio.clamp(-FAR, FAR)), spot));
        }
    }
    placed
}

/// Whether a law is another for another e.
fn asks_restitution(law: FrictionLaw) -> bool {
    [0.5, 1.0, 2.0].iter().any(|alpha| curve(law, 0.0, *alpha) != curve(law, 1.0, *alpha))
}

/// The picture; `None` where no row has both.
pub(in crate::records) fn ratio(study: &Study) -> Option<String> {
    let spots = placed(&study.spots);
    if spots.is_empty() {
        return None;
    }
    let e = stated(&study.spots);
    let best = study.friction.first().map(|fit| fit.law);
    let mut laws = vec![FrictionLaw::Coulomb];
    laws.extend(best.filter(|law| *law != FrictionLaw::Coulomb));
    let title = "The tangential velocity ratio of the impacts, on the curves of laws of friction";
    let notes = [
        "k is the slip after by the slip that there would be without friction, alpha = mu*W_tt*p_n/(2*|slip|) with the \
         measured p_n: at 1/2 sliding friction just ends the slip. A spot is an impact of the log; its shape and colour \
         tell the stated e. Where k is beyond 1.5, it is drawn there."
            .to_owned(),
    ];
    let mut canvas = Canvas::new((WIDTH, HEIGHT), title, &notes);
    let kinds =
        [(Shape::Disc, Ink::BLUE), (Shape::Square, Ink::VERMILION), (Shape::Triangle, Ink::GREEN)];
    let names: Vec<String> = e.iter().map(|e| format!("e = {}", brief(*e))).collect();
    let keys =
        names.iter().zip(kinds).map(|(name, (shape, ink))| (Key::Mark(shape, ink), name.as_str()));
    let keys: Vec<(Key, &str)> = keys.collect();
    let top = legend(&mut canvas, (60.0, 4.0), WIDTH - 60.0, &keys) + 10.0;
    let (alpha, (low, high)) = alpha_axis(spots.iter().map(|((alpha, _), _)| *alpha));
    let axes =
        (alpha, Axis::linear("k", range(spots.iter().map(|((_, k), _)| *k), (-0.2, 1.0)), number));
    let panel = Panel::new(&mut canvas, frame(top, 210.0), axes, "");
    let mut lines = Vec::new();
    for (place, law) in laws.into_iter().enumerate() {
        let pens = [Pen::new(Ink::Text, 1.5), Pen::new(Ink::PURPLE, 1.5).dashed("6 4")];
        let pen = pens[place.min(1)];
        let each: &[f64] = if asks_restitution(law) { &e } else { e.get(..1).unwrap_or(&[]) };
        for restitution in each {
            let at = |step: u32| low * (high / low).powf(f64::from(step) / f64::from(POINTS));
            let points = (0..=POINTS)
                .filter_map(|step| Some((at(step), curve(law, *restitution, at(step))?)));
            let of = if asks_restitution(law) {
                format!(", e = {}", brief(*restitution))
            } else {
                String::new()
            };
            let bound = if law == FrictionLaw::Compression {
                "mu*p_n/(1 + e)".to_owned()
            } else {
                friction_name(law)
            };
            lines.push((bound + &of, points.collect::<Vec<_>>(), pen));
        }
    }
    panel.ended(&mut canvas, &lines);
    for (at, spot) in &spots {
        let Some(at) = panel.at(*at).filter(|at| panel.window.holds(*at)) else { continue };
        let own = spot.stated.or(spot.restitution).unwrap_or(f64::NAN);
        let nearest =
            e.iter().enumerate().min_by(|a, b| (a.1 - own).abs().total_cmp(&(b.1 - own).abs()));
        let (shape, ink) = kinds[nearest.map_or(0, |(place, _)| place)];
        mark(&mut canvas, at, shape, ink);
    }
    Some(canvas.finish())
}
