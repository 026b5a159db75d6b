//! Where a function of a rational number that has few values changes its value.

use crate::Rational;

/// Where what applies at x changes between neighbours of an ascending grid: two fractions on either side
/// of each change, at the distance of the neighbours halved so often. Heuristic: two changes between the
/// same neighbours may hide each other.
#[must_use]
pub fn changes<S: PartialEq>(
    grid: &[Rational],
    halvings: u32,
    applies: impl Fn(&Rational) -> S,
) -> Vec<[Rational; 2]> {
    let mut asked = grid.iter().map(|x| (x, applies(x)));
    let Some(mut before) = asked.next() else { return Vec::new() };
    let mut out = Vec::new();
    for after in asked {
        if after.1 != before.1 {
            let (mut lower, mut upper) = (before.0.clone(), after.0.clone());
            for _ in 0..halvings {
                let middle = (&lower + &upper) / Rational::from_integer(2.into());
                let side = if applies(&middle) == before.1 { &mut lower } else { &mut upper };
                *side = middle;
            }
            out.push([lower, upper]);
        }
        before = after;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_change_lies_between_two_fractions_of_which_one_is_before_it_and_one_behind() {
        let number = |n: i64, d: i64| Rational::new(n.into(), d.into());
        let places = [number(1, 3), number(7, 5), number(29, 10)];
        let passed = |x: &Rational| places.iter().filter(|place| *place <= x).count();
        let grid: Vec<Rational> = [-1, 0, 2, 4, 8, 14, 15].map(|n| number(n, 4)).to_vec();
        for halvings in [0, 1, 5, 20] {
            let found = changes(&grid, halvings, passed);
            assert_eq!(found.len(), places.len());
            // between 0 and 1/2, 1 and 2, 2 and 7/2
            let gaps = [number(1, 2), number(1, 1), number(3, 2)];
            for (([lower, upper], place), gap) in found.iter().zip(&places).zip(gaps) {
                assert!(lower < place && place <= upper, "{lower}, {place}, {upper}");
                assert_eq!((upper - lower) * crate::power_of(2, halvings.into()), gap);
            }
        }
        assert!(changes(&grid, 3, |_| 0).is_empty(), "nothing changes");
        assert!(changes(&grid[..1], 3, passed).is_empty() && changes(&[], 3, passed).is_empty());
    }
}
