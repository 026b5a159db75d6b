//! Bounds, worst inputs and repairs of formulas, of a document or of FPCore.
//!
//! What is here is put together from three rooms: float programs bound the errors, the auditor proves that a
//! repair is equal, and the document says over what.

mod core;
mod decided;
mod equal;

use kane_audit::Verdict;
use kane_floats::rigor::{Bounded, Budget, Cell, Goal, Inputs, bounded, lossy};
use kane_floats::{Core, Effort, Machine, Operation, Precision, Proposal, Worst, repairs, worst};

use crate::{Formula, Ranges};

pub use decided::Decided;

/// How much work to spend on a formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Work {
    /// of every bound
    pub budget: Budget,
    /// of every search
    pub effort: Effort,
    /// repairs that are shown to the auditor, at most
    pub repairs: usize,
    /// whether inputs are floats, or real numbers that are rounded first
    pub inputs: Inputs,
}

impl Default for Work {
    fn default() -> Self {
        Self {
            budget: Budget::default(),
            effort: Effort::default(),
            repairs: 3,
            inputs: Inputs::Floats,
        }
    }
}

impl Work {
    /// A fifth of it, for documents of many formulas.
    #[must_use]
    pub fn brief() -> Self {
        let budget = Budget { cells: 2_500, ratio: 1.05 };
        let effort = Effort { drawn: 1_500, climbs: 6, rounds: 30 };
        Self { budget, effort, repairs: 2, inputs: Inputs::Floats }
    }
}

/// An input with its exact error.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// the inputs, by the shortest decimals that name them in the format
    pub at: Vec<String>,
    /// what the machine returns
    pub computed: String,
    /// the exact value, rounded to the format
    pub exact: String,
    /// the error, rounded down: absolute, or in ulps
    pub error: f64,
    /// the same, rounded up
    pub error_at_most: f64,
}

/// A formula in one format.
#[derive(Clone, Debug)]
pub struct Certified {
    /// the format
    pub precision: Precision,
    /// the error
    pub absolute: Bounded,
    /// the error in ulps of the exact value
    pub ulps: Bounded,
    /// the input with the greatest error that was found
    pub worst: Option<Found>,
    /// the same for the error in ulps
    pub worst_in_ulps: Option<Found>,
    /// boxes outside of which no input loses more than half of the bits; none if none does. Rigorous
    pub half_lost: Vec<Cell>,
    /// the comparisons on which the value depends, and how often plain floats decide them wrongly
    pub decided: Vec<Decided>,
    /// equal forms with smaller errors, the best first
    pub repairs: Vec<Repair>,
    /// forms that looked better and that the auditor did not prove equal
    pub unproved: usize,
}

/// An equal form that loses less.
#[derive(Clone, Debug)]
pub struct Repair {
    /// the formula
    pub core: Core,
    /// its error
    pub absolute: Bounded,
    /// its error in ulps
    pub ulps: Bounded,
    /// its greatest error in ulps that was found
    pub worst_in_ulps: Option<Found>,
}

/// A formula with all that was found of it.
#[derive(Clone, Debug)]
pub struct Account {
    /// what it is called
    pub label: String,
    /// the formula over the ranges that were examined
    pub core: Core,
    /// by format; `Err` with the name of an input that has no float in its range
    pub formats: Vec<Result<Certified, String>>,
}

/// How many operations of each kind a formula takes: the price of a form, where time depends on the machine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Price {
    /// sums, differences, products, fused operations
    pub light: usize,
    /// quotients and roots
    pub heavy: usize,
}

/// The price of a formula.
#[must_use]
pub fn price(core: &Core) -> Price {
    let needed = core.program.needed(core.root);
    let mut price = Price::default();
    for (operation, _) in core.program.operations().iter().zip(needed).filter(|(_, used)| *used) {
        match operation {
            Operation::Div(..) | Operation::Sqrt(_) => price.heavy += 1,
            other if other.rounds() => price.light += 1,
            _ => {}
        }
    }
    price
}

/// A formula of a document as a float program over these ranges.
#[must_use]
pub fn core_of(formula: &Formula, ranges: &Ranges) -> Core {
    let inputs = formula.inputs.iter().map(|input| ranges.narrowed(input)).collect();
    core::core(&Formula { inputs, ..formula.clone() })
}

/// Bounds the errors of a formula in the format that it asks for, or in both; looks for the worst inputs; and
/// proposes equal forms where digits are lost. Bounds are rigorous, errors that are found exact, repairs
/// proved equal by the auditor; what the searches miss is not said to be absent. Deterministic.
#[must_use]
pub fn account(label: &str, core: &Core, work: Work) -> Account {
    let formats = match core.precision {
        Some(precision) => vec![precision],
        None => Precision::ALL.to_vec(),
    };
    let formats = formats.into_iter().map(|precision| match precision {
        Precision::F32 => certified::<f32>(core, work),
        Precision::F64 => certified::<f64>(core, work),
    });
    Account { label: label.to_owned(), core: core.clone(), formats: formats.collect() }
}

fn certified<M: Machine>(core: &Core, work: Work) -> Result<Certified, String> {
    let absolute = bounded::<M>(core, work.inputs, Goal::Absolute, work.budget)?;
    let ulps = bounded::<M>(core, work.inputs, Goal::Ulps, work.budget)?;
    let half_lost = lossy::<M>(core, work.inputs, work.budget.cells / 4)?;
    let found = worst::<M>(core, &absolute.worst, Goal::Absolute, work.effort);
    let found_in_ulps = worst::<M>(core, &ulps.worst, Goal::Ulps, work.effort);
    let points: Vec<Vec<M>> =
        found.iter().chain(&found_in_ulps).map(|worst| worst.at.clone()).collect();
    let proposals = match work.repairs {
        0 => Vec::new(),
        _ => repairs::<M>(core, &points).map_or_else(Vec::new, |(_, found)| found),
    };
    let (mut kept, mut unproved) = (Vec::new(), 0);
    for Proposal { core: form, .. } in proposals.into_iter().take(work.repairs) {
        if equal::equal(core, &form) != Some(Verdict::Proved) {
            unproved += 1;
            continue;
        }
        let absolute = bounded::<M>(&form, work.inputs, Goal::Absolute, work.budget)?;
        let ulps = bounded::<M>(&form, work.inputs, Goal::Ulps, work.budget)?;
        let worst = worst::<M>(&form, &ulps.worst, Goal::Ulps, work.effort);
        let worst_in_ulps = worst.map(|worst| told(&worst, Goal::Ulps));
        kept.push(Repair { core: form, absolute, ulps, worst_in_ulps });
    }
    Ok(Certified {
        precision: M::FORMAT,
        absolute,
        ulps,
        worst: found.map(|worst| told(&worst, Goal::Absolute)),
        worst_in_ulps: found_in_ulps.map(|worst| told(&worst, Goal::Ulps)),
        half_lost,
        decided: decided::decided::<M>(core),
        repairs: kept,
        unproved,
    })
}

fn told<M: Machine>(worst: &Worst<M>, goal: Goal) -> Found {
    let text = decided::shortest::<M>;
    let exact = worst.compared.exact.middle();
    Found {
        at: worst.at.iter().map(|float| text(*float)).collect(),
        computed: text(worst.computed),
        exact: text(kane_number::encode(&exact, kane_number::Rounding::NearestEven)),
        error: worst.error(goal),
        error_at_most: worst.error_at_most(goal),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kane_floats::fpcore;

    fn read(text: &str) -> Core {
        fpcore::read("t.fpcore", text).unwrap().remove(0)
    }

    #[test]
    fn the_auditor_tells_equal_forms_from_others() {
        let old = read("(FPCore (x) :pre (<= 1 x 9) (- (sqrt (+ x 1)) (sqrt x)))");
        let new = read("(FPCore (x) :pre (<= 1 x 9) (/ 1 (+ (sqrt (+ x 1)) (sqrt x))))");
        assert_eq!(equal::equal(&old, &new), Some(Verdict::Proved));
        let other = read("(FPCore (x) :pre (<= 1 x 9) (/ 1 (- (sqrt (+ x 1)) (sqrt x))))");
        assert_ne!(equal::equal(&old, &other), Some(Verdict::Proved));
        let fused = read("(FPCore (x) :pre (<= 1 x 9) (fma x x 1))");
        let apart = read("(FPCore (x) :pre (<= 1 x 9) (+ (* x x) 1))");
        assert_eq!(equal::equal(&fused, &apart), Some(Verdict::Proved));
        // x/x is 1 where x is not 0, and on this domain it may be
        let one = read("(FPCore (x) :pre (<= -1 x 1) 1)");
        let quotient = read("(FPCore (x) :pre (<= -1 x 1) (/ x x))");
        assert_ne!(equal::equal(&one, &quotient), Some(Verdict::Proved));
    }

    #[test]
    fn a_document_s_formula_is_the_same_program() {
        let text = b"```kane\nvar x > 0\nlet f := cases{x < 1: x^2; x < 2: sqrt(x); else: 1/x} - min(x, 1)\n```\n";
        let document = kane_audit::read("d.md", text).unwrap();
        let found = crate::formulas(&document);
        let formula = &found.formulas[0];
        let core = core_of(formula, &Ranges::default());
        let runner = kane_floats::Runner::<f64>::new(&core.program);
        for x in [0.25, 1.5, 7.0] {
            let plain = formula.program.value(&crate::Plain::<f64>::new(), &[x]);
            assert_eq!(runner.value(core.root, &[x]), plain);
        }
        let lower = core.arguments[0].lower.as_ref().unwrap();
        assert_eq!(lower.value, kane_number::parse("1e-6").unwrap());
    }

    #[test]
    fn a_cancellation_has_a_bound_a_witness_and_a_proved_repair() {
        let core =
            read("(FPCore (x) :precision binary64 :pre (<= 1 x 1000) (- (sqrt (+ x 1)) (sqrt x)))");
        let work = Work {
            budget: Budget { cells: 600, ratio: 1.05 },
            effort: Effort { drawn: 600, climbs: 3, rounds: 10 },
            repairs: 1,
            inputs: Inputs::Floats,
        };
        let account = account("t", &core, work);
        let [Ok(found)] = account.formats.as_slice() else { panic!("one format") };
        let witness = found.worst_in_ulps.as_ref().unwrap();
        assert!(witness.error <= found.ulps.bound && witness.error > 100.0);
        let repair = found.repairs.first().unwrap();
        assert!(repair.ulps.bound < 8.0 && repair.ulps.bound < witness.error, "{repair:?}");
        assert_eq!(price(&core), Price { light: 2, heavy: 2 });
    }
}
