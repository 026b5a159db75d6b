//! Figures for print: curves over one variable and maps of a plane, as SVG with their data as CSV.
//!
//! Colours are those of Okabe and Ito, and colour never tells anything alone: lines bear the number
//! of their legend and differ in their dashes, zones in their hatching, points in their shape. Legends
//! stand beside the plot.

mod curves;
mod data;
mod labels;
mod legend;
mod map;

use crate::picture;

/// A figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// What its files are called, without an ending.
    pub stem: &'static str,
    /// What it shows, in a line.
    pub title: String,
    /// What one must know to read it, a line each.
    pub notes: Vec<String>,
    /// The variable.
    pub x: Axis,
    /// The quantity.
    pub y: Axis,
    /// What is drawn.
    pub content: Content,
}

/// What a figure draws.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// Lines and points, over zones.
    Curves {
        /// Lines and points, in the order of the legend.
        series: Vec<Series>,
        /// At most two, the graver first.
        zones: Vec<Zone>,
    },
    /// Stretches of the variable, one panel a case.
    Map(Vec<Panel>),
}

/// An axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// The symbol, a column's name in the data.
    pub symbol: &'static str,
    /// What it is, with its unit.
    pub label: String,
    /// From where to where it is shown; a logarithmic axis is positive.
    pub range: (f64, f64),
    /// Where it bears numbers.
    pub ticks: Vec<f64>,
    /// Whether it is logarithmic.
    pub is_logarithmic: bool,
}

/// What kind of thing a series is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// A rigid law: a line.
    Law,
    /// A process in time: a line.
    Process,
    /// What was measured: points.
    Measured,
}

/// A line or points.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// What it shows; several names share a line.
    pub names: Vec<String>,
    /// What kind of thing it is.
    pub kind: Kind,
    /// x, and y where there is one; a line is broken where there is none.
    pub points: Vec<(f64, Option<f64>)>,
    /// How far each point may be off to either side, where that is told; otherwise empty.
    pub bars: Vec<f64>,
    /// To how many decimals y is written.
    pub decimals: usize,
}

/// A part of the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Zone {
    /// What holds inside.
    pub name: String,
    /// Beyond any of these it begins.
    pub borders: Vec<Border>,
}

/// A border of a zone, from left to right.
#[derive(Clone, Debug, PartialEq)]
pub struct Border {
    /// The points of the border.
    pub points: Vec<(f64, f64)>,
    /// Whether the zone is above it.
    pub is_zone_above: bool,
}

/// A map's panel.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// The body, and the law.
    pub case: [String; 2],
    /// The stretches.
    pub stretches: Vec<Stretch>,
    /// Places that are marked by a ring.
    pub marks: Vec<(f64, f64)>,
    /// Whether the law's name bears a mark, which the notes explain.
    pub is_marked: bool,
}

/// A stretch of x at one y.
#[derive(Clone, Debug, PartialEq)]
pub struct Stretch {
    /// Where.
    pub y: f64,
    /// Where it begins.
    pub from: f64,
    /// Where it ends, or the end of the axis.
    pub to: Option<f64>,
}

/// The figure as SVG; the bytes depend on the figure alone.
#[must_use]
pub fn svg(figure: &Figure) -> String {
    match &figure.content {
        Content::Curves { series, zones } => curves::draw(figure, series, zones),
        Content::Map(panels) => map::draw(figure, panels),
    }
}

pub use data::{csv, text};

impl Axis {
    /// The axis as it is drawn.
    fn drawn(&self) -> picture::Axis {
        let name = |tick: &f64| (*tick, tick.to_string().replace('-', "−"));
        let ticks = self.ticks.iter().map(name).collect();
        picture::Axis::told(&self.label, self.range, ticks).with_logarithms(self.is_logarithmic)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::seen::Seen;

    fn axis(symbol: &'static str, range: (f64, f64), ticks: &[f64], is_logarithmic: bool) -> Axis {
        Axis { symbol, label: symbol.to_owned(), range, ticks: ticks.to_vec(), is_logarithmic }
    }

    fn series(name: &str, kind: Kind, points: &[(f64, Option<f64>)]) -> Series {
        Series {
            names: vec![name.to_owned()],
            kind,
            points: points.to_vec(),
            bars: Vec::new(),
            decimals: 2,
        }
    }

    fn curves() -> Figure {
        let law = series(
            "a law",
            Kind::Law,
            &[
                (1.0, Some(0.25)),
                (10.0, Some(0.5)),
                (20.0, None),
                (50.0, Some(1.0)),
                (100.0, Some(0.75)),
            ],
        );
        let process =
            series("a process", Kind::Process, &[(1.0, Some(-0.5)), (100.0, Some(-0.001))]);
        let measured = Series {
            bars: vec![0.125, 0.25],
            ..series("spheres", Kind::Measured, &[(2.0, Some(0.5)), (20.0, Some(-0.25))])
        };
        let other = series("rods", Kind::Measured, &[(5.0, Some(0.75)), (7.0, None)]);
        let border =
            |y, is_zone_above| Border { points: vec![(1.0, y), (100.0, y)], is_zone_above };
        let zones = vec![
            Zone { name: "energy is created".to_owned(), borders: vec![border(0.9, true)] },
            Zone { name: "outside".to_owned(), borders: vec![border(-0.75, false)] },
        ];
        Figure {
            stem: "made-up",
            title: "Made up".to_owned(),
            notes: vec!["A note.".to_owned()],
            x: axis("alpha", (1.0, 100.0), &[1.0, 10.0, 100.0], true),
            y: axis("k", (-1.0, 1.0), &[0.0, 0.5, 1.0], false),
            content: Content::Curves { series: vec![law, process, measured, other], zones },
        }
    }

    fn map() -> Figure {
        let panel = Panel {
            case: ["a rod".to_owned(), "a law".to_owned()],
            stretches: vec![
                Stretch { y: 0.5, from: 0.25, to: Some(0.75) },
                Stretch { y: 1.0, from: 0.5, to: None },
            ],
            marks: vec![(0.5, 0.25)],
            is_marked: true,
        };
        Figure {
            x: axis("mu", (0.0, 2.0), &[0.0, 1.0, 2.0], false),
            y: axis("e", (0.0, 1.0), &[0.0, 1.0], false),
            content: Content::Map(vec![panel]),
            ..curves()
        }
    }

    #[test]
    fn the_data_of_a_figure_are_its_points_its_bars_and_its_borders() {
        assert_eq!(
            csv(&curves()),
            "# Made up\n# A note.\n# 1 (law): a law\n# 2 (process): a process\n# 3 (measured): spheres\n\
             # 4 (measured): rods\n# A (zone): energy is created\n# B (zone): outside\n\
             series,alpha,k\n\
             1,1,0.25\n1,10,0.50\n1,50,1.00\n1,100,0.75\n\
             2,1,-0.50\n2,100,0.00\n\
             3,2.0000,0.50\n3,20.0000,-0.25\n3 bar,2.0000,0.12\n3 bar,20.0000,0.25\n\
             4,5.0000,0.75\n\
             A above,1,0.900000\nA above,100,0.900000\n\
             B below,1,-0.750000\nB below,100,-0.750000\n"
        );
        assert_eq!(
            csv(&map()),
            "# Made up\n# A note.\nbody,law,e,mu_from,mu_to\n\
             a rod,a law,0.5000,0.2500,0.7500\n\
             a rod,a law,1.0000,0.5000,\n"
        );
        assert_eq!(
            text(&[curves(), map()]),
            "made-up: Made up\n   1 law: a law\n   2 process: a process\n   3 measured: spheres\n   4 measured: rods\n     \
             zone: energy is created\n     zone: outside\n\n\
             made-up: Made up\n     a rod, a law\n\n"
        );
    }

    fn pair(x: &str, y: &str) -> (String, String) {
        (x.to_owned(), y.to_owned())
    }

    #[test]
    fn what_was_measured_stands_where_it_was_measured_with_its_bars() {
        let seen = Seen::of(&svg(&curves()));
        let scales = seen.scales([true, false]);
        // discs of the first series of points; one more is in the legend
        let discs = seen.circles().iter().filter(|c| c.radius == 4.0 && c.class.is_empty());
        let discs: Vec<_> = discs.map(|circle| scales.told(circle.at)).collect();
        assert_eq!(discs[..2], [pair("2", "0.5"), pair("20", "-0.25")]);
        let rings = seen.circles().iter().filter(|c| c.radius == 4.0 && c.class == "line");
        let rings: Vec<_> = rings.map(|circle| scales.told(circle.at)).collect();
        assert_eq!(rings[0], pair("5", "0.75"));
        assert_eq!([discs.len(), rings.len()], [3, 2]);
        let upright: Vec<[(String, String); 2]> = seen
            .lines()
            .iter()
            .filter(|line| line.points.len() == 2 && line.class == "line")
            .map(|line| [0, 1].map(|end| scales.told(line.points[end])))
            .filter(|[from, to]| from.0 == to.0 && from.1 != to.1)
            .collect();
        for (x, low, high) in [("2", "0.38", "0.63"), ("20", "-0.5", "0")] {
            assert!(upright.contains(&[pair(x, low), pair(x, high)]), "{upright:?}");
        }
    }

    #[test]
    fn a_line_goes_through_its_points_and_is_broken_where_there_is_none() {
        let seen = Seen::of(&svg(&curves()));
        let scales = seen.scales([true, false]);
        let through = |class: &str| -> Vec<Vec<(String, String)>> {
            let lines = seen.lines().iter().filter(|line| line.class == class);
            lines.map(|line| line.points.iter().map(|at| scales.told(*at)).collect()).collect()
        };
        let of_law = through("c0 line");
        assert!(of_law.contains(&vec![pair("1", "0.25"), pair("10", "0.5")]), "{of_law:?}");
        assert!(of_law.contains(&vec![pair("50", "1"), pair("100", "0.75")]), "{of_law:?}");
        let of_process = through("line");
        assert!(of_process.contains(&vec![pair("1", "-0.5"), pair("100", "0")]), "{of_process:?}");
        // borders of the zones, in their inks
        assert!(through("c1 line").contains(&vec![pair("1", "0.9"), pair("100", "0.9")]));
        assert!(through("c5 line").contains(&vec![pair("1", "-0.75"), pair("100", "-0.75")]));
    }

    #[test]
    fn a_zone_is_filled_on_its_side_of_the_border() {
        let seen = Seen::of(&svg(&curves()));
        let scales = seen.scales([true, false]);
        let filled = |class: &str| -> Vec<Vec<(String, String)>> {
            let areas = seen.lines().iter().filter(|line| line.class == class);
            areas.map(|area| area.points.iter().map(|at| scales.told(*at)).collect()).collect()
        };
        let corners = |at: &str, edge: &str| {
            vec![pair("1", at), pair("100", at), pair("100", edge), pair("1", edge)]
        };
        assert_eq!(filled("c1")[0], corners("0.9", "1"));
        assert_eq!(filled("c5")[0], corners("-0.75", "-1"));
        // hatching stays inside
        let hatched = |class: &str, inside: fn(f64) -> bool| {
            let lines = seen.lines().iter().filter(|line| line.class == class);
            let ends = lines.flat_map(|line| &line.points).map(|at| scales.told(*at));
            let in_plot = ends.filter(|(x, _)| x.parse().is_ok_and(|x: f64| x <= 100.0));
            in_plot.map(|(_, y)| y.parse::<f64>().expect("a number")).all(inside)
        };
        assert!(hatched("c1 line", |y| y >= 0.88), "above 0.9, but for a step of hatching");
        assert!(hatched("c5 line", |y| y <= -0.73), "below -0.75, but for a step of hatching");
    }

    #[test]
    fn the_number_of_a_line_lies_on_it_and_stands_beside_its_name_in_the_legend() {
        let seen = Seen::of(&svg(&curves()));
        // rings of the radius of numbers: on the lines first, then in the legend
        let numbers: Vec<_> = seen.circles().iter().filter(|c| c.radius == 9.0).collect();
        let rings: Vec<_> = numbers.iter().filter(|c| c.class.ends_with("line")).collect();
        let legend = |name: &str| seen.place(name).expect(name).1 - 0.36 * picture::WORDS;
        for (name, class) in [("a law", "c0 line"), ("a process", "line")] {
            let beside = rings.iter().find(|c| (c.at.1 - legend(name)).abs() < 0.02);
            assert_eq!(beside.map(|c| c.class.as_str()), Some(class), "{name}");
            let on_line = rings.iter().find(|ring| {
                let near = |line: &picture::seen::Line| {
                    line.class == class
                        && line.points.windows(2).any(|two| {
                            let ((x1, y1), (x2, y2)) = (two[0], two[1]);
                            let share = (ring.at.0 - x1) / (x2 - x1);
                            (0.0..=1.0).contains(&share)
                                && (y1 + share * (y2 - y1) - ring.at.1).abs() < 0.05
                                && ring.at.0 < 580.0
                        })
                };
                ring.class == class && seen.lines().iter().any(near)
            });
            assert!(on_line.is_some(), "{name}: {rings:?}");
        }
        for heading in ["Rigid laws", "Processes in time", "Measured", "Zones"] {
            assert!(seen.place(heading).is_some(), "{heading}");
        }
        let order = ["Rigid laws", "a law", "a process", "spheres", "rods", "energy is created"];
        let heights = order.map(legend);
        assert!(heights.is_sorted_by(|a, b| a < b), "{heights:?}");
    }

    #[test]
    fn a_stretch_of_a_map_is_as_long_as_it_is_or_goes_on_to_the_end() {
        let seen = Seen::of(&svg(&map()));
        let scales = seen.scales([false, false]);
        let boxes: Vec<_> = seen.lines().iter().filter(|line| line.class == "c1").collect();
        let told = |index: usize| {
            let [first, _, last, _] = boxes[index].points[..] else { panic!("a box") };
            let middle = (first.1 + last.1) / 2.0;
            (scales.told((first.0, middle)), scales.told((last.0, middle)).0)
        };
        assert_eq!(told(0), (pair("0.25", "0.5"), "0.75".to_owned()));
        assert_eq!(told(1), (pair("0.5", "1"), "2".to_owned()));
        let marks: Vec<_> = seen.circles().iter().map(|circle| scales.told(circle.at)).collect();
        assert_eq!(marks, [pair("0.5", "0.25")]);
        assert!(seen.place("a law†").is_some() && seen.place("a rod").is_some());
    }
}
