//! Pictures of a log: k over α on the curves of laws, e over the phase, and where energy is gained.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

mod energy;
mod phase;
mod ratio;

pub(super) use energy::energy;
pub(super) use phase::phase;
pub(super) use ratio::ratio;

use crate::picture::{Axis, Frame, Point};

/// Pixels of a picture.
const WIDTH: f64 = 860.0;
const HEIGHT: f64 = 400.0;

/// The one plot of a picture, below its legend.
const fn frame(top: f64, beside: f64) -> Frame {
    Frame { at: (0.0, top), size: (WIDTH, HEIGHT - top), head: 10.0, beside }
}

/// The axis of α, from a tenth to ten or as far as the values go, within six decades; and its ends.
fn alpha_axis(values: impl Iterator<Item = f64>) -> (Axis, Point) {
    let ends =
        values.fold((0.1_f64, 10.0_f64), |(low, high), alpha| (low.min(alpha), high.max(alpha)));
    let (low, high) = (ends.0.max(1e-3), ends.1.min(1e3));
    (Axis::logarithmic("alpha", (low, high), number), (low, high))
}

/// The range of values, with room about it and with zero or one value told apart.
fn range(values: impl Iterator<Item = f64>, (least, greatest): Point) -> Point {
    let inside = values.filter(|value| value.is_finite());
    let (low, high) =
        inside.fold((least, greatest), |(low, high), value| (low.min(value), high.max(value)));
    let room = 0.05 * (high - low);
    (low - room, high + room)
}

/// A number at an axis.
fn number(value: f64) -> String {
    let text = format!("{value:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use kane_records::reader::Kind;
    use kane_records::scatter::Spot;
    use kane_records::study::{Options, Study, study};

    use super::*;
    use crate::picture::seen::Seen;

    /// The study of a log of impacts that lose their slip, with other spots.
    fn of(spots: Vec<Spot>) -> Study {
        let head =
            "mass,radius,inertia,mu,restitution,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post";
        let row = "1,1,0.4,0.3,0.5,2,-1,0,1.55,0.5,-1.125";
        let text = format!("{head}\n{}", format!("{row}\n").repeat(10));
        let study = study(text.as_bytes(), Kind::Csv, &Options::new(&[])).expect("it can be read");
        Study { spots, ..study }
    }

    fn spot(alpha: f64, ratio: f64) -> Spot {
        Spot {
            alpha: Some(alpha),
            ratio: Some(ratio),
            restitution: Some(0.25),
            stated: Some(0.5),
            phase: Some(0.0),
            gain: -0.5,
            gains: false,
        }
    }

    fn pair(x: &str, y: &str) -> (String, String) {
        (x.to_owned(), y.to_owned())
    }

    /// What the marks say, those of the legend left out.
    fn told(svg: &str, keys: usize, logarithmic: bool) -> Vec<(String, String)> {
        let seen = Seen::of(svg);
        let scales = seen.scales([logarithmic, false]);
        let marks = seen.circles().iter().skip(keys);
        marks.map(|circle| scales.told(circle.at)).collect()
    }

    #[test]
    fn a_spot_of_k_stands_at_its_alpha_and_with_its_sign() {
        let spots =
            vec![spot(0.5, 0.25), spot(2.0, -0.5), spot(5.0, 7.0), spot(0.2, -7.0), spot(1.0, 0.0)];
        let svg = ratio(&of(spots)).expect("a picture");
        // what is beyond 1.5 is drawn there
        let expected = [
            pair("0.5", "0.25"),
            pair("2", "-0.5"),
            pair("5", "1.5"),
            pair("0.2", "-1.5"),
            pair("1", "0"),
        ];
        assert_eq!(told(&svg, 1, true), expected);
        let nothing = Spot { alpha: None, ..spot(1.0, 1.0) };
        assert!(ratio(&of(vec![nothing])).is_none());
        assert!(ratio(&of(vec![Spot { ratio: None, ..spot(1.0, 1.0) }])).is_none());
        let svg = ratio(&of(vec![nothing, spot(0.5, 0.25)])).expect("a picture");
        assert_eq!(told(&svg, 1, true), [pair("0.5", "0.25")]);
    }

    #[test]
    fn a_spot_of_k_has_the_shape_of_the_stated_e_that_is_nearest() {
        let stated = |e: f64, alpha: f64| Spot { stated: Some(e), ..spot(alpha, 0.5) };
        let svg = ratio(&of(vec![stated(0.5, 0.5), stated(0.9, 2.0), stated(0.5, 5.0)]));
        let svg = svg.expect("a picture");
        // discs for the first, squares for the second; the legend has one of each
        assert_eq!(told(&svg, 1, true), [pair("0.5", "0.5"), pair("5", "0.5")]);
        assert!(svg.contains(">e = 0.5<") && svg.contains(">e = 0.9<"), "{svg}");
    }

    #[test]
    fn the_axes_of_k_reach_as_far_as_its_spots() {
        let svg = ratio(&of(vec![spot(0.01, 0.1), spot(200.0, 0.3)])).expect("a picture");
        assert_eq!(told(&svg, 1, true), [pair("0.01", "0.1"), pair("200", "0.3")]);
        let svg = ratio(&of(vec![spot(1.0, 0.1)])).expect("a picture");
        let seen = Seen::of(&svg);
        let on_axis = |name: &str| seen.place(name).is_some();
        assert!(on_axis("0.1") && on_axis("10") && !on_axis("0.01") && !on_axis("100"), "{svg}");
    }

    #[test]
    fn coulomb_s_curve_falls_from_one_to_zero_at_one_half() {
        let svg = ratio(&of(vec![spot(1.0, 0.5)])).expect("a picture");
        let seen = Seen::of(&svg);
        let scales = seen.scales([true, false]);
        let curve = seen.lines().iter().filter(|line| line.class == "line");
        let curve = curve.max_by_key(|line| line.points.len()).expect("a curve");
        let ends = [curve.points.first(), curve.points.last()];
        let ends = ends.map(|end| scales.told(*end.expect("it has ends")));
        // k = 1 − 2α while friction slides
        assert_eq!(ends, [pair("0.1", "0.8"), pair("10", "0")]);
        let corner = curve.points.iter().map(|at| scales.told(*at)).find(|(_, k)| k == "0");
        assert_eq!(corner.map(|(alpha, _)| alpha).as_deref(), Some("0.5"));
    }

    #[test]
    fn a_law_that_asks_e_has_a_curve_for_each_and_others_have_one() {
        use kane_records::friction::{FrictionFit, FrictionLaw};
        let stated = |e: f64, alpha: f64| Spot { stated: Some(e), ..spot(alpha, 0.5) };
        let names = |law| {
            let fit = FrictionFit {
                law,
                rows: 10,
                consistent: 10,
                close: 10,
                rough: 10,
                worst: 0.0,
                median: 0.0,
                worst_line: 0,
                tied: false,
            };
            let study = of(vec![stated(0.5, 0.5), stated(0.9, 2.0)]);
            let svg = ratio(&Study { friction: vec![fit], ..study }).expect("a picture");
            let seen = Seen::of(&svg);
            let all = [
                "Coulomb, stops the slip",
                "mu*p_n/(1 + e), e = 0.5",
                "mu*p_n/(1 + e), e = 0.9",
                "Walton, beta0 = 0.25",
            ];
            all.into_iter().filter(|name| seen.place(name).is_some()).collect::<Vec<_>>()
        };
        let coulomb = "Coulomb, stops the slip";
        let of_e = ["mu*p_n/(1 + e), e = 0.5", "mu*p_n/(1 + e), e = 0.9"];
        assert_eq!(names(FrictionLaw::Compression), [coulomb, of_e[0], of_e[1]]);
        assert_eq!(names(FrictionLaw::Walton(0.25)), [coulomb, "Walton, beta0 = 0.25"]);
        assert_eq!(names(FrictionLaw::Coulomb), [coulomb]);
    }

    #[test]
    fn a_disc_is_where_energy_is_created_and_a_ring_where_it_is_not() {
        let gain = |alpha: f64, gain: f64, gains: bool| Spot { gain, gains, ..spot(alpha, 0.0) };
        let spots = vec![
            gain(0.5, 0.25, true),
            gain(2.0, -0.5, false),
            gain(5.0, 9.0, true),
            gain(0.2, -9.0, false),
            gain(0.0, 0.75, true),
        ];
        let svg = energy(&of(spots)).expect("a picture");
        // rings first; what is beyond the axis is drawn at its end, and what has no alpha nowhere
        let expected = [pair("2", "-0.5"), pair("0.2", "-1"), pair("0.5", "0.25"), pair("5", "2")];
        assert_eq!(told(&svg, 2, true), expected);
        let seen = Seen::of(&svg);
        let classes: Vec<bool> =
            seen.circles().iter().skip(2).map(|c| c.class.contains("line")).collect();
        assert_eq!(classes, [true, true, false, false]);
        assert!(energy(&of(vec![gain(0.5, 0.25, false)])).is_none());
        let unslipped = Spot { alpha: None, ..gain(0.5, 0.25, true) };
        assert!(energy(&of(vec![unslipped, gain(0.5, 0.25, false)])).is_none());
    }

    #[test]
    fn the_line_of_no_gain_is_at_zero() {
        let gains = Spot { gain: 0.25, gains: true, ..spot(0.5, 0.0) };
        let svg = energy(&of(vec![gains])).expect("a picture");
        let seen = Seen::of(&svg);
        let scales = seen.scales([true, false]);
        let ends = |line: &crate::picture::seen::Line| match line.points.as_slice() {
            [a, b] => Some([scales.told(*a), scales.told(*b)]),
            _ => None,
        };
        let expected = [pair("0.1", "0"), pair("10", "0")];
        let lines: Vec<_> = seen.lines().iter().filter(|l| l.class == "line").collect();
        assert!(lines.iter().any(|line| ends(line).as_ref() == Some(&expected)), "{svg}");
    }

    #[test]
    fn restitution_stands_at_its_phase_beside_what_is_stated() {
        let at = |phase: f64, e: f64, stated: Option<f64>| Spot {
            phase: Some(phase),
            restitution: Some(e),
            stated,
            ..spot(1.0, 0.0)
        };
        let spots = vec![
            at(0.25, 0.5, Some(0.8)),
            at(0.75, 1.25, Some(0.2)),
            at(0.5, 9.0, Some(0.8)),
            at(1.0, -9.0, None),
            Spot { phase: None, ..at(0.0, 0.0, None) },
        ];
        let svg = phase(&of(spots)).expect("a picture");
        let expected =
            [pair("0.25", "0.5"), pair("0.75", "1.25"), pair("0.5", "3"), pair("1", "-3")];
        assert_eq!(told(&svg, 1, false), expected);
        let seen = Seen::of(&svg);
        let scales = seen.scales([false, false]);
        let levels: Vec<String> = seen
            .lines()
            .iter()
            .filter(|line| line.class == "line" && line.points.len() == 2)
            .map(|line| scales.told(line.points[0]).1)
            .filter(|level| level == "0.8" || level == "0.2")
            .collect();
        assert_eq!(levels, ["0.2", "0.8"]);
        // with one phase alone there is nothing to see
        assert!(phase(&of(vec![at(0.5, 0.5, None), at(0.5, 0.75, None)])).is_none());
        assert!(phase(&of(vec![])).is_none());
    }

    #[test]
    fn numbers_at_axes_have_no_zeros_behind_them() {
        let told = [0.0, -0.0, -0.0001, 0.5, 1.0, -1.25, 100.0, 0.125_4].map(number);
        assert_eq!(told, ["0", "0", "0", "0.5", "1", "-1.25", "100", "0.125"]);
        let infinite = [1.0, f64::INFINITY, f64::NAN, 4.0];
        assert_eq!(range(infinite.into_iter(), (0.0, 1.0)), (-0.2, 4.2));
        assert_eq!(range([].into_iter(), (-1.0, 1.0)), (-1.1, 1.1));
    }
}
