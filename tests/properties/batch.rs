//! Columns against the single lane, bit for bit where that is the contract, and against exact
//! numbers where it is a bound.

use kane_impact::batch::{self, Batched, Columns, Contacts, Survey};
use kane_impact::laws::{
    GarwinCapped, Smith1991, Walton, WangSuLi, WhittakerStop, WhittakerUncapped,
};
use kane_impact::{Alpha, ImpactLaw, Ratios, laws};
use kane_number::{Rational, decode, error_in_ulps};
use proptest::prelude::*;

use crate::strategies::{alpha, exact};
use crate::{cases, rational, two_to};

fn columns<L: Batched>(law: &L, alpha: &[f64]) -> Vec<Ratios<f64>> {
    let (mut k, mut impulse, mut energy) =
        (vec![9.0; alpha.len()], vec![9.0; alpha.len()], vec![9.0; alpha.len()]);
    let out = Columns { k: &mut k, impulse: &mut impulse, energy: &mut energy };
    batch::evaluate(law, alpha, out);
    let rows = k.into_iter().zip(impulse).zip(energy);
    rows.map(|((k, impulse), energy)| Ratios { k, impulse, energy }).collect()
}

fn single<L: ImpactLaw>(law: &L, alpha: f64) -> Ratios<f64> {
    law.ratios(&Alpha::new(alpha).expect("α ≥ 0")).expect("finite")
}

/// The same floats; −0 equals 0. From one product the single lane rounds half of Δe and doubles it:
/// in the subnormal range, in units of 2^−1074, the product is off by 1/2, its half by 1/4 + 1/2, and
/// so Δe by 3/2; the columns are off by 1/4 + 1/2. Both are whole: they differ by 2 at most.
fn equals_the_single_lane<L: Batched>(law: &L, alphas: &[f64]) -> Result<(), TestCaseError> {
    let least = f64::from_bits(1);
    for (&alpha, mut row) in alphas.iter().zip(columns(law, alphas)) {
        let single = single(law, alpha);
        if single.energy.abs() < 2.0 * f64::MIN_POSITIVE {
            prop_assert!(
                (row.energy - single.energy).abs() <= 2.0 * least,
                "{row:?} and {single:?}"
            );
            row.energy = single.energy;
        }
        if law.id() == WangSuLi.id() {
            row.k = single.k; // which has a bound of its own
        }
        prop_assert_eq!(row, single, "{} at α = {}", law.id(), alpha);
    }
    Ok(())
}

fn size(number: Rational) -> Rational {
    if number < rational(0, 1) { -number } else { number }
}

/// Columns of up to 40 rows, so that every remainder of a vector's width occurs.
fn some() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(alpha(), 0..40)
}

proptest! {
    #![proptest_config(cases(5_000))]

    #[test]
    fn columns_are_the_single_lane(alphas in some()) {
        equals_the_single_lane(&WangSuLi, &alphas)?;
        equals_the_single_lane(&WhittakerUncapped, &alphas)?;
        equals_the_single_lane(&WhittakerStop, &alphas)?;
        equals_the_single_lane(&GarwinCapped, &alphas)?;
        equals_the_single_lane(&Walton::default(), &alphas)?;
    }
}

proptest! {
    #![proptest_config(cases(500))]

    #[test]
    fn the_plain_quotient_keeps_its_bound(alphas in some()) {
        for (&alpha, row) in alphas.iter().zip(columns(&WangSuLi, &alphas)) {
            let truth = WangSuLi.ratios(&Alpha::Finite(exact(alpha))).expect("finite");
            let error = size(error_in_ulps(row.k, &truth.k)?);
            prop_assert!(error <= rational(9, 4), "k is off by {} ulp at α = {}", error, alpha);
        }
    }

    /// k, i_x and Δe within 6u, 5u and 10u of the roots of k² − 2α·k + (1 − 2α) = 0, told by signs:
    /// the quadratic is positive above its roots and at the lower end negative only between them.
    #[test]
    fn the_weighted_mean_keeps_its_bounds(alphas in some()) {
        for (&alpha, row) in alphas.iter().zip(columns(&Smith1991, &alphas)) {
            let truth = exact(alpha);
            let one = rational(1, 1);
            if alpha <= 0.5 {
                prop_assert_eq!(row.impulse, 1.0);
                prop_assert!(size(error_in_ulps(row.k, &(&one - &truth - &truth))?) <= rational(1, 2));
                let error = size(decode(row.energy)? - (truth - one));
                prop_assert!(error <= two_to(-53));
                continue;
            }
            // the second order is far below a hundredth of u
            let unit = two_to(-53) * rational(101, 100);
            let least = two_to(-1074);
            // −k is the root of x² + 2α·x − (2α − 1) between 0 and 1, and increases through it
            let twice = &truth + &truth;
            let below = |x: &Rational| x * x + &twice * x < &twice - &one;
            let (low, high) = {
                let k = -decode(row.k)?;
                let width = &k * &unit * rational(6, 1) + &least;
                (&k - &width, k + width)
            };
            prop_assert!(below(&low) && !below(&high), "k = {} at α = {alpha}", row.k);
            // i_x = (1 + x)/(2α), so x = 2α·i_x − 1
            let share = decode(row.impulse)?;
            let width = &share * &unit * rational(5, 1) + &least;
            let reflected = |share: Rational| &twice * share - &one;
            let (low, high) = (reflected(&share - &width), reflected(share + width));
            prop_assert!(low < rational(0, 1) || below(&low), "i_x = {} at α = {alpha}", row.impulse);
            prop_assert!(!below(&high), "i_x = {} at α = {alpha}", row.impulse);
            // −Δe = (1 + x)(1 − x)/(4α), so x² = 1 + 4α·Δe
            let lost = -decode(row.energy)?;
            let width = &lost * &unit * rational(10, 1) + &least;
            let square = |lost: Rational| &one - rational(2, 1) * &twice * lost;
            // y = x² and x² + 2α·x < 2α − 1 ⟺ 2α·x < 2α − 1 − y
            let square_is_below = |y: &Rational| {
                let rest = &twice - &one - y;
                *y < rational(0, 1) || (rest > rational(0, 1) && &twice * &twice * y < &rest * &rest)
            };
            let (low, high) = (square(&lost + &width), square(lost - width));
            prop_assert!(square_is_below(&low), "Δe = {} at α = {alpha}", row.energy);
            prop_assert!(!square_is_below(&high), "Δe = {} at α = {alpha}", row.energy);
        }
    }

    #[test]
    fn contacts_are_the_rows_of_their_alpha(
        contacts in prop::collection::vec((-9.0..9.0, 0.0..9.0, 0.1..9.0), 0..20),
    ) {
        let column = |of: fn(&(f64, f64, f64)) -> f64| contacts.iter().map(of).collect::<Vec<_>>();
        let (slip, sliding, mobility) = (column(|c| c.0), column(|c| c.1), column(|c| c.2));
        let alphas = column(|c| c.1 * c.2 / (2.0 * c.0.abs()));
        let rows = contacts.len();
        let (mut k, mut impulse, mut energy) = (vec![9.0; rows], vec![9.0; rows], vec![9.0; rows]);
        let out = Columns { k: &mut k, impulse: &mut impulse, energy: &mut energy };
        let contacts = Contacts { slip: &slip, sliding: &sliding, mobility: &mobility };
        batch::evaluate_contacts(&WangSuLi, contacts, out);
        for (row, expected) in columns(&WangSuLi, &alphas).into_iter().enumerate() {
            let row = Ratios { k: k[row], impulse: impulse[row], energy: energy[row] };
            prop_assert_eq!(row, expected);
        }
    }

    /// For every law whose k is a function of α: the very floats of the law, and where it has fractions, within
    /// 20 units of 2^-52 of them, or of 1 where k goes through 0 (each law states 15 at most).
    #[test]
    fn rows_of_any_law_are_those_of_the_law(alphas in prop::collection::vec(0.0..4.0, 1..9)) {
        for law in laws().iter().filter(|law| !law.has_frame()) {
            let [mut k, mut impulse, mut energy] = [(); 3].map(|()| vec![9.0; alphas.len()]);
            let out = Columns { k: &mut k, impulse: &mut impulse, energy: &mut energy };
            batch::evaluate_singly(law, &alphas, out);
            let rows = k.iter().zip(&impulse).zip(&energy);
            for (&alpha, ((&k, &impulse), &energy)) in alphas.iter().zip(rows) {
                let Some(single) = law.over().ratios(&Alpha::Finite(alpha)) else {
                    prop_assert!([k, impulse, energy].iter().all(|of| of.is_nan()));
                    continue;
                };
                prop_assert_eq!(Ratios { k, impulse, energy }, single);
                let Some(truth) = law.over().ratios(&Alpha::Finite(exact(alpha))) else { continue };
                for (got, truth) in
                    [(k, truth.k), (impulse, truth.impulse), (energy, truth.energy)]
                {
                    let off = size(exact(got) - &truth);
                    let unit = (size(truth) + rational(1, 1)) * two_to(-52);
                    prop_assert!(off <= unit * rational(20, 1), "{} at {alpha}", law.info.id);
                }
            }
            let found = batch::survey_singly(law, &alphas);
            let outside = k.iter().filter(|k| k.is_nan()).count();
            let gains = energy.iter().filter(|&&energy| energy > 0.0).count();
            prop_assert_eq!(found.rows, alphas.len());
            prop_assert_eq!(found.gains, u64::try_from(gains).expect("few"), "{}", law.info.id);
            prop_assert_eq!(found.outside, u64::try_from(outside).expect("few"), "{}", law.info.id);
        }
    }

    /// A row without a meaning is NaN alone, and so is every row of a law with a frame of its own.
    #[test]
    fn a_row_of_any_law_without_a_meaning_is_nan(alpha in 0.0..3.0) {
        for law in laws() {
            let [mut k, mut impulse, mut energy] = [[9.0; 4]; 3];
            let out = Columns { k: &mut k, impulse: &mut impulse, energy: &mut energy };
            batch::evaluate_singly(law, &[alpha, -1.0, f64::NAN, alpha], out);
            prop_assert!([k, impulse, energy].iter().all(|of| of[1].is_nan() && of[2].is_nan()));
            prop_assert!(!law.has_frame() || k[0].is_nan());
            prop_assert_eq!(k[0].to_bits(), k[3].to_bits());
        }
    }

    /// i_x = 1/α has no value there: no exact number either, and no panic.
    #[test]
    fn the_superball_has_no_answer_where_nothing_slides_it(exponent in 1_i32..60) {
        let garwin = kane_impact::laws::Garwin;
        prop_assert_eq!(garwin.ratios(&Alpha::Finite(rational(0, 1))), None);
        prop_assert_eq!(garwin.ratios(&Alpha::Finite(0.0)), None);
        let alpha = two_to(-exponent);
        let found = garwin.ratios(&Alpha::Finite(alpha.clone())).expect("α > 0");
        prop_assert_eq!(found.impulse * alpha, rational(1, 1));
    }

    #[test]
    fn a_survey_is_what_the_rows_say(alphas in some()) {
        survey_agrees(&WangSuLi, &alphas);
        survey_agrees(&WhittakerUncapped, &alphas);
        survey_agrees(&Walton::default(), &alphas);
        survey_agrees(&Smith1991, &alphas);
        let paper = batch::survey(&WangSuLi, &alphas);
        prop_assert_eq!((paper.outside, paper.gains, paper.beyond_cone), (0, 0, 0));
    }
}

fn survey_agrees<L: Batched>(law: &L, alphas: &[f64]) {
    let rows = columns(law, alphas);
    let count = |holds: fn(&Ratios<f64>) -> bool| {
        u64::try_from(rows.iter().filter(|row| holds(row)).count()).expect("few")
    };
    let expected = Survey {
        rows: alphas.len(),
        outside: 0,
        gains: count(|row| row.energy > 0.0),
        beyond_cone: count(|row| row.impulse > 1.0),
        greatest_energy: rows.iter().map(|row| row.energy).fold(f64::NEG_INFINITY, f64::max),
        least_k: rows.iter().map(|row| row.k).fold(f64::INFINITY, f64::min),
    };
    assert_eq!(batch::survey(law, alphas), expected);
}

/// Where the plain quotient is off by nearly 9/4 ulp, and the limit of normal collision.
#[test]
fn the_worst_alpha_and_the_last_one() {
    let worst = 2.0_f64.powi(56) / 7.0;
    let near: Vec<f64> = (-40..40)
        .map(|steps: i64| f64::from_bits(worst.to_bits().wrapping_add_signed(steps)))
        .collect();
    let greatest = near.iter().zip(columns(&WangSuLi, &near)).map(|(&alpha, row)| {
        let truth = WangSuLi.ratios(&Alpha::Finite(exact(alpha))).expect("finite");
        size(error_in_ulps(row.k, &truth.k).expect("finite"))
    });
    let greatest = greatest.max().expect("eighty of them");
    assert!(rational(224, 100) < greatest && greatest <= rational(9, 4), "{greatest}");

    let last = [f64::MAX, f64::INFINITY];
    let limit = columns(&WangSuLi, &last);
    assert_eq!((limit[0].k, limit[1].k, limit[1].impulse), (-1.0, -1.0, 0.0));
    for law in [Walton::default(), Walton { restitution: rational(1, 3) }] {
        assert_eq!(columns(&law, &last)[1], single(&law, f64::INFINITY));
    }
    assert_eq!(columns(&WhittakerStop, &last)[1], single(&WhittakerStop, f64::INFINITY));
    assert_eq!(columns(&GarwinCapped, &last)[1], single(&GarwinCapped, f64::INFINITY));
    assert_eq!(columns(&Smith1991, &last)[1], single(&Smith1991, f64::INFINITY));
}

#[test]
fn rows_that_are_no_collisions_are_counted() {
    let survey = batch::survey(&WhittakerUncapped, &[f64::NAN, -1.0, 2.0, -0.0, f64::INFINITY]);
    assert_eq!((survey.rows, survey.outside, survey.gains), (5, 2, 2));
    assert_eq!((survey.greatest_energy, survey.least_k), (f64::INFINITY, f64::NEG_INFINITY));
    let none = batch::survey(&WangSuLi, &[]);
    assert_eq!((none.rows, none.outside, none.least_k), (0, 0, f64::INFINITY));
}
