//! A picture as its reader sees it, for tests: what stands where, and what that is by the numbers at the axes.

use super::Point;

/// What a picture shows, in the order in which it was drawn.
pub(crate) struct Seen {
    /// the class, the place, and what is written there; what is turned is left out
    words: Vec<(String, Point, String)>,
    circles: Vec<Circle>,
    lines: Vec<Line>,
}

/// A disc or a ring.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Circle {
    pub(crate) class: String,
    pub(crate) at: Point,
    pub(crate) radius: f64,
}

/// A line or an area, by its corners; a box is one of them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Line {
    pub(crate) class: String,
    pub(crate) points: Vec<Point>,
}

/// The scales of a plot, told from the numbers at its axes.
pub(crate) struct Scales {
    x: Scale,
    y: Scale,
}

/// Two numbers of an axis and where they stand.
struct Scale {
    numbers: [f64; 2],
    pixels: [f64; 2],
    is_logarithmic: bool,
}

fn attribute<'a>(element: &'a str, name: &str) -> Option<&'a str> {
    let (_, rest) = element.split_once(&format!(" {name}=\""))?;
    rest.split('"').next()
}

fn number(text: &str) -> f64 {
    text.parse().expect("a number")
}

/// The corners of a path: the first of each part from the last one, as every other.
fn corners(d: &str) -> Vec<Vec<Point>> {
    let mut parts: Vec<Vec<Point>> = Vec::new();
    let mut at = (0.0, 0.0);
    let mut rest = d;
    while let Some(letter) = rest.chars().next() {
        rest = &rest[1..];
        let end = rest.find(|c: char| c.is_ascii_alphabetic()).unwrap_or(rest.len());
        // a sign begins a number as a space does
        let spaced = rest[..end].replace('-', " -");
        let numbers: Vec<f64> = spaced.split_whitespace().map(number).collect();
        rest = &rest[end..];
        match (letter, numbers.as_slice()) {
            ('M', [x, y]) => {
                at = (*x, *y);
                parts.push(vec![at]);
                continue;
            }
            ('l', [x, y]) => at = (at.0 + x, at.1 + y),
            ('h', [x]) => at.0 += x,
            ('v', [y]) => at.1 += y,
            ('z' | 'Z', []) => continue,
            _ => panic!("no path: {d}"),
        }
        parts.last_mut().expect("a path begins somewhere").push(at);
    }
    parts
}

impl Seen {
    pub(crate) fn of(svg: &str) -> Self {
        let (mut words, mut circles, mut lines) = (Vec::new(), Vec::new(), Vec::new());
        let body = svg.split_once("<g transform").map_or("", |(_, body)| body);
        for element in body.lines() {
            let class = attribute(element, "class").unwrap_or_default().to_owned();
            let place = |x: &str, y: &str| {
                let of = |name| attribute(element, name).map(number);
                Some((of(x)?, of(y)?))
            };
            if element.starts_with("<text") && !element.contains("rotate") {
                let text = element.split(['>', '<']).nth(2).unwrap_or_default();
                words.extend(place("x", "y").map(|at| (class, at, text.to_owned())));
            } else if element.starts_with("<circle") {
                let radius = attribute(element, "r").map_or(0.0, number);
                circles.extend(place("cx", "cy").map(|at| Circle { class, at, radius }));
            } else if let Some(d) = attribute(element, "d") {
                let each = corners(d).into_iter();
                lines.extend(each.map(|points| Line { class: class.clone(), points }));
            }
        }
        Self { words, circles, lines }
    }

    /// Where these words stand.
    pub(crate) fn place(&self, words: &str) -> Option<Point> {
        self.words.iter().find(|(.., text)| text == words).map(|(_, at, _)| *at)
    }

    pub(crate) fn circles(&self) -> &[Circle] {
        &self.circles
    }

    pub(crate) fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// The scales of the plot that was drawn first: numbers at the left end there, those below have their middle there.
    pub(crate) fn scales(&self, [is_x_logarithmic, is_y_logarithmic]: [bool; 2]) -> Scales {
        let across = |(x, y): Point| (x, y - 0.36 * super::NUMBERS);
        let ends = |class: &str, turned: fn(Point) -> Point, is_logarithmic| {
            let of_class = self.words.iter().filter(|(of, ..)| of == class);
            let numbers = of_class
                .filter_map(|(_, at, text)| Some((text.parse::<f64>().ok()?, turned(across(*at)))));
            let all: Vec<(f64, Point)> = numbers.collect();
            let first = all.first().expect("a number at an axis");
            // in one row, or one column, and on in one direction: then another plot begins
            let axis = all.iter().filter(|(_, at)| at.1 == first.1.1).collect::<Vec<_>>();
            let way = |pair: &[&(f64, Point)]| pair[1].1.0 > pair[0].1.0;
            let on = axis.windows(2).take_while(|pair| way(pair) == way(&axis[..2])).count();
            let last = axis[on];
            let (numbers, pixels) = ([first.0, last.0], [first.1.0, last.1.0]);
            assert!(pixels[0] != pixels[1], "two numbers at an axis");
            Scale { numbers, pixels, is_logarithmic }
        };
        Scales {
            x: ends("middle", |at| at, is_x_logarithmic),
            y: ends("end", |(x, y)| (y, x), is_y_logarithmic),
        }
    }
}

impl Scale {
    fn value(&self, pixel: f64) -> f64 {
        let [[a, b], [p, q]] = [self.numbers, self.pixels];
        let share = (pixel - p) / (q - p);
        match self.is_logarithmic {
            true => a * (b / a).powf(share),
            false => a + share * (b - a),
        }
    }
}

impl Scales {
    /// What a place says, to three digits: places are rounded to a hundredth of a pixel.
    pub(crate) fn told(&self, (x, y): Point) -> (String, String) {
        let brief = |value: f64| {
            let text = format!("{value:.3}");
            let text = text.trim_end_matches('0').trim_end_matches('.');
            if text == "-0" { "0".to_owned() } else { text.to_owned() }
        };
        // three digits of a number above 1 are fewer places
        let rounded = |value: f64| {
            let digits = if value.abs() >= 9.995 { 1.0 } else { 100.0 };
            brief((value * digits).round() / digits)
        };
        (rounded(self.x.value(x)), rounded(self.y.value(y)))
    }
}
