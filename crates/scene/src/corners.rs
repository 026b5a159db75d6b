//! The corners of a body that is not round.

use kane_number::{Number, Rational};

/// A rigid convex body by its corners, from the centre of mass at the start, counterclockwise; two are
/// those of a rod; m.
#[derive(Clone, Debug, PartialEq)]
pub struct Corners<N>(pub Vec<[N; 2]>);

impl<N> Corners<N> {
    /// The same in another number system.
    pub fn map<M>(&self, mut to: impl FnMut(&N) -> M) -> Corners<M> {
        Corners(self.0.iter().map(|[x, y]| [to(x), to(y)]).collect())
    }
}

/// What is wrong with a list of corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotConvex {
    /// A polygon has at least three.
    #[error("a polygon has 3 to 64 corners; a body with two is a [rod]")]
    Count,
    /// They turn to the right, or not at all, at this one, from 0.
    #[error("the polygon does not turn to the left at corner {}; corners go counterclockwise around a convex body", .0 + 1)]
    Turn(usize),
    /// They go around more than once.
    #[error("the corners go around more than once")]
    Winding,
}

/// The most corners of a polygon.
const MOST: usize = 64;

impl Corners<Rational> {
    /// The corners of a uniform polygon from its centre of mass, and J/m about it; exact, for corners given
    /// from any point:
    ///
    /// ```text
    /// c = Σ (a + b)·(a×b)/(3·Σ a×b)      J/m = Σ (a×b)·(a·a + a·b + b·b)/(6·Σ a×b) − c·c
    /// ```
    ///
    /// # Errors
    /// [`NotConvex`].
    pub fn of_polygon(given: &[[Rational; 2]]) -> Result<(Self, Rational), NotConvex> {
        if given.len() < 3 || given.len() > MOST {
            return Err(NotConvex::Count);
        }
        let zero = Rational::default();
        let count = given.len();
        let side = |i: usize| {
            let (a, b) = (&given[i % count], &given[(i + 1) % count]);
            [&b[0] - &a[0], &b[1] - &a[1]]
        };
        let cross = |a: &[Rational; 2], b: &[Rational; 2]| &a[0] * &b[1] - &a[1] * &b[0];
        let dot = |a: &[Rational; 2], b: &[Rational; 2]| &a[0] * &b[0] + &a[1] * &b[1];
        for i in 0..count {
            if cross(&side(i), &side(i + 1)) <= zero {
                return Err(NotConvex::Turn((i + 1) % count));
            }
        }
        // once around: the sides point upwards once in a row, and downwards once
        let upwards = |i: usize| {
            let [x, y] = side(i);
            y > zero || (y == zero && x > zero)
        };
        if (0..count).filter(|i| upwards(*i) && !upwards(i + 1)).count() != 1 {
            return Err(NotConvex::Winding);
        }
        let (mut area, mut first, mut second) = (zero.clone(), [zero.clone(), zero.clone()], zero);
        for i in 0..count {
            let (a, b) = (&given[i], &given[(i + 1) % count]);
            let part = cross(a, b);
            for k in 0..2 {
                first[k] += &part * (&a[k] + &b[k]);
            }
            second += &part * (dot(a, a) + dot(a, b) + dot(b, b));
            area += part;
        }
        let integer = |n: i64| Rational::from_integer(n.into());
        let centre = first.map(|sum| sum / (&area * integer(3)));
        let inertia = second / (area * integer(6)) - dot(&centre, &centre);
        let arms = given.iter().map(|[x, y]| [x - &centre[0], y - &centre[1]]);
        Ok((Self(arms.collect()), inertia))
    }

    /// The two ends of a thin uniform rod along x, and J/m = l²/12; exact.
    #[must_use]
    pub fn of_rod(length: &Rational) -> (Self, Rational) {
        let half = length / Rational::one().double();
        let ends = Self(vec![[-half.clone(), Rational::default()], [half, Rational::default()]]);
        (ends, length * length / Rational::from_integer(12.into()))
    }
}

#[cfg(test)]
mod tests {
    use kane_number::{Rational, parse};

    use super::{Corners, NotConvex};

    fn points(list: &[[&str; 2]]) -> Vec<[Rational; 2]> {
        list.iter().map(|pair| pair.map(|x| parse(x).expect("a number"))).collect()
    }

    #[test]
    fn a_rectangle_has_its_middle_and_its_inertia() {
        let given = points(&[["1", "1"], ["4", "1"], ["4", "3"], ["1", "3"]]);
        let (corners, inertia) = Corners::of_polygon(&given).expect("it is convex");
        let expected = points(&[["-3/2", "-1"], ["3/2", "-1"], ["3/2", "1"], ["-3/2", "1"]]);
        assert_eq!(corners.0, expected);
        // (a² + b²)/12
        assert_eq!(inertia, parse("13/12").expect("a number"));
    }

    #[test]
    fn a_triangle_has_its_inertia() {
        // about the centre of mass a right triangle has (a² + b²)/18
        let given = points(&[["0", "0"], ["3", "0"], ["0", "2"]]);
        let (corners, inertia) = Corners::of_polygon(&given).expect("it is convex");
        assert_eq!(corners.0[0], [parse("-1").expect("1"), parse("-2/3").expect("2/3")]);
        assert_eq!(inertia, parse("13/18").expect("a number"));
    }

    #[test]
    fn what_is_not_convex_is_refused() {
        let clockwise = points(&[["0", "0"], ["0", "1"], ["1", "0"]]);
        assert_eq!(Corners::of_polygon(&clockwise), Err(NotConvex::Turn(1)));
        let straight = points(&[["0", "0"], ["1", "0"], ["2", "0"], ["1", "1"]]);
        assert_eq!(Corners::of_polygon(&straight), Err(NotConvex::Turn(1)));
        let star = points(&[["0", "3"], ["-2", "-3"], ["3", "1"], ["-3", "1"], ["2", "-3"]]);
        assert_eq!(Corners::of_polygon(&star), Err(NotConvex::Winding));
        assert_eq!(Corners::of_polygon(&star[..2]), Err(NotConvex::Count));
    }
}
