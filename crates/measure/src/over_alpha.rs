//! What every law says of a sphere on a plane, over α, exactly.

use std::collections::BTreeSet;

use kane_impact::{Alpha, Contact, Law, Ratios};
use kane_number::{Algebraic, Rational, changes};

/// All laws over α; what coincides is kept once.
#[derive(Clone, Debug)]
pub struct OverAlpha {
    /// Where the laws were asked, ascending: the decimals of a grid, and for every change of a law's
    /// regime two fractions that enclose it.
    pub alphas: Vec<Rational>,
    /// The curves, in the order of the laws.
    pub curves: Vec<Curve>,
    /// The laws that say nothing in terms of α alone.
    pub without: Vec<&'static str>,
}

/// A curve, and the laws that it belongs to.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Laws that give exactly the same k, `i_x` and Δe at every α that was asked.
    pub laws: Vec<&'static str>,
    /// By α; `None` where the laws have no finite value. Exact.
    pub ratios: Vec<Option<Ratios<Algebraic>>>,
}

/// Asks the laws for α from 1/50 to 20.
#[must_use]
pub fn over_alpha(laws: &[Law]) -> OverAlpha {
    let grid = grid();
    // where some law changes its regime, a curve may have a corner or jump
    let borders = laws.iter().flat_map(|law| changes(&grid, HALVINGS, |alpha| state(law, alpha)));
    let mut alphas: BTreeSet<Rational> = borders.flatten().collect();
    alphas.extend(grid);
    let alphas = alphas.into_iter().collect();
    let mut asked = OverAlpha { alphas, curves: Vec::new(), without: Vec::new() };
    laws.iter().for_each(|law| asked.ask(law));
    asked
}

/// Decimals of two or three digits, about 48 to the decade.
fn grid() -> Vec<Rational> {
    let mantissas = || (20..50).step_by(2).chain((50..100).step_by(4)).chain((100..200).step_by(5));
    let decades = [1000, 100, 10];
    let of = |unit: i32| mantissas().map(move |n| Rational::new(n.into(), unit.into()));
    let last = Rational::from_integer(20.into());
    decades.into_iter().flat_map(of).chain([last]).collect()
}

/// How often the stretch between neighbours of the grid is halved around a change of regime.
const HALVINGS: u32 = 12;

/// Which regime applies, and whether the law accepts what it gives.
fn state(law: &Law, alpha: &Rational) -> Option<(usize, bool)> {
    let law = law.over();
    let contact = Contact::of_alpha(alpha.clone());
    if law.frame(&contact).is_some() {
        return None;
    }
    let index = law.place(&contact)?;
    // a root need not be rational, so that its absence would tell nothing
    let has_root = law.regimes().get(index)?.equation(&contact).is_some();
    Some((index, has_root || law.ratios(&Alpha::Finite(alpha.clone())).is_some()))
}

impl OverAlpha {
    fn ask(&mut self, law: &Law) {
        let exactly = law.over();
        let ask = |alpha: &Rational| exactly.ratios(&Alpha::Finite(Algebraic::from(alpha.clone())));
        let ratios: Vec<_> = self.alphas.iter().map(ask).collect();
        if ratios.iter().all(Option::is_none) {
            self.without.push(law.info.id);
        } else if let Some(curve) = self.curves.iter_mut().find(|curve| curve.ratios == ratios) {
            curve.laws.push(law.info.id);
        } else {
            self.curves.push(Curve { laws: vec![law.info.id], ratios });
        }
    }
}
