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
