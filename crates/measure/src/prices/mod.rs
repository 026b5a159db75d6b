//! What the digits of anyone's formula cost: its forms in every number system, by digits and by the clock.

mod columns;
mod digits;

use kane_floats::rigor::{Bounded, Goal, bounded};
use kane_floats::{Core, Machine, Precision, fused, worst};
use kane_number::{DoubleDouble, Interval, Rational, System};

use crate::certify::{Account, Work, account};
use crate::chart::{Effort, FormNumber, Run, Time, timed};
use columns::Columns;
use digits::{reference, right};

/// A form of a formula.
#[derive(Clone, Debug)]
pub struct Form {
    /// what it is called: `given`, `repair 1`, and the same with `fused`
    pub name: String,
    /// the form; the auditor has proved that a repair is equal to the formula as given
    pub core: Core,
    /// the bound on its error in ulps, in `f32` and `f64`
    pub bounds: [Option<Bounded>; 2],
}

/// A form in a number system.
#[derive(Clone, Debug)]
pub struct Way {
    /// which form, by index
    pub form: usize,
    /// where it ran
    pub system: System,
    /// hundredths of decimal digits that are right at the worst input tried; `i64::MAX` if all answers are exact
    pub worst: i64,
    /// the same at the median input
    pub median: i64,
    /// the worst input
    pub at: Vec<f64>,
    /// how many inputs were tried
    pub tried: usize,
    /// one evaluation, over a column of inputs
    pub time: Time,
    /// whether nothing else is both faster and better
    pub on_front: bool,
}

/// All that was measured of a formula.
#[derive(Clone, Debug)]
pub struct Prices {
    /// what it is called
    pub label: String,
    /// its forms, as given first
    pub forms: Vec<Form>,
    /// by form and system; systems that have no answers, as fractions for roots, are left out
    pub ways: Vec<Way>,
}

/// Inputs that are drawn over the domain, beside the worst ones of each form, and rows of a column that is timed.
const DRAWN: usize = 400;
const ROWS: usize = 128;

/// Charts a formula: as given, fused as compilers contract it, and repaired, each in `f32`, `f64`, double-double,
/// intervals and fractions. Digits are exact, at the same inputs for all forms: those drawn, and the worst that
/// the search finds for each of them in the format (in `f64` for the wider systems). Times are of this machine:
/// an evaluation's share of a pass over a column, one operation after another.
///
/// # Errors
/// The name of an argument that has no float in its range.
pub fn prices(
    label: &str,
    core: &Core,
    work: Work,
    effort: Effort,
    progress: &mut dyn FnMut(usize, usize),
) -> Result<Prices, String> {
    let both = Core { precision: None, ..core.clone() };
    let account = account(label, &both, Work { repairs: work.repairs.max(2), ..work });
    let forms = forms(&account, work)?;
    let narrow = inputs::<f32>(&forms, work)?;
    let wide = inputs::<f64>(&forms, work)?;
    let mut ways = Vec::new();
    let mut runs: Vec<Run<'_>> = Vec::new();
    for (index, form) in forms.iter().enumerate() {
        one::<f32>(index, form, core, &narrow, &mut ways, &mut runs);
        one::<f64>(index, form, core, &wide, &mut ways, &mut runs);
        one::<DoubleDouble>(index, form, core, &wide, &mut ways, &mut runs);
        one::<Interval>(index, form, core, &wide, &mut ways, &mut runs);
        one::<Rational>(index, form, core, &wide, &mut ways, &mut runs);
    }
    let times = timed(runs, effort, progress);
    for (way, time) in ways.iter_mut().zip(times) {
        way.time = time;
    }
    mark_front(&mut ways);
    Ok(Prices { label: label.to_owned(), forms, ways })
}

/// The formula, its repairs in either format, and all of them fused.
fn forms(account: &Account, work: Work) -> Result<Vec<Form>, String> {
    let mut cores = vec![("given".to_owned(), account.core.clone())];
    let repairs = account.formats.iter().rev().flatten().flat_map(|found| &found.repairs);
    for repair in repairs {
        if cores.iter().all(|(_, known)| known.text() != repair.core.text()) {
            cores.push((format!("repair {}", cores.len()), repair.core.clone()));
        }
    }
    for (name, core) in cores.clone() {
        if let Some(fused) = fused(&core)
            && cores.iter().all(|(_, known)| known.text() != fused.text())
        {
            cores.push((format!("{name}, fused"), fused));
        }
    }
    let form = |(name, core): (String, Core)| {
        let narrow = bounded::<f32>(&core, work.inputs, Goal::Ulps, work.budget)?;
        let wide = bounded::<f64>(&core, work.inputs, Goal::Ulps, work.budget)?;
        // without a bound where an operation may fail; where the value may be 0 all bits may be lost, which is one
        let told = |bound: Bounded| bound.pole.is_none().then_some(bound);
        Ok(Form { name, core, bounds: [told(narrow), told(wide)] })
    };
    cores.into_iter().map(form).collect()
}

/// Inputs of a format by column: drawn over the domain, and the worst of every form.
fn inputs<M: Machine>(forms: &[Form], work: Work) -> Result<Vec<Vec<f64>>, String> {
    let Some(given) = forms.first() else { return Ok(Vec::new()) };
    let mut rows: Vec<Vec<f64>> = kane_floats::points::<M>(&given.core, DRAWN)?
        .into_iter()
        .map(|at| at.into_iter().map(M::wide).collect())
        .collect();
    for form in forms {
        for goal in [Goal::Ulps, Goal::Absolute] {
            if let Some(worst) = worst::<M>(&form.core, &[], goal, work.effort) {
                rows.push(worst.at.into_iter().map(M::wide).collect());
            }
        }
    }
    let count = given.core.arguments.len();
    let column = |index: usize| rows.iter().filter_map(|row| row.get(index).copied()).collect();
    Ok((0..count).map(column).collect())
}

/// A form in a system: its digits, and a run to be timed; nothing if it has no answer at most inputs.
fn one<'a, N: FormNumber + 'a>(
    index: usize,
    form: &'a Form,
    given: &Core,
    inputs: &[Vec<f64>],
    ways: &mut Vec<Way>,
    runs: &mut Vec<Run<'a>>,
) {
    let columns = Columns::<N>::new(&form.core, inputs);
    columns.run();
    let row = |row: usize| -> Vec<f64> {
        inputs.iter().filter_map(|column| column.get(row).copied()).collect()
    };
    let mut found: Vec<(i64, Vec<f64>)> = Vec::new();
    let mut none = 0;
    for (place, value) in columns.values().into_iter().enumerate() {
        let at = row(place);
        let Some(exact) = reference(given, &at) else { continue };
        let answer = value.and_then(|value| value.answer());
        none += usize::from(answer.is_none());
        found.push((right(answer.as_ref(), &exact), at));
    }
    if 2 * none >= found.len() {
        return;
    }
    let tried = found.len();
    found.sort_by_key(|(digits, _)| *digits);
    let median = found.get(tried / 2).map_or(0, |(digits, _)| *digits);
    let Some((worst, at)) = found.into_iter().next() else { return };
    let time = Time { median: 0, quartiles: (0, 0), rounds: 0 };
    let system = N::SYSTEM;
    ways.push(Way { form: index, system, worst, median, at, tried, time, on_front: false });
    let some: Vec<Vec<f64>> =
        inputs.iter().map(|column| column.iter().copied().take(ROWS).collect()).collect();
    let rows = some.first().map_or(1, Vec::len);
    let timed = Columns::<N>::new(&form.core, &some);
    runs.push((Box::new(move || timed.run()), rows));
}

fn mark_front(ways: &mut [Way]) {
    let beats = |a: &Way, b: &Way| {
        let (x, y) = (a.time.median, b.time.median);
        x <= y && a.worst >= b.worst && (x < y || a.worst > b.worst)
    };
    let front: Vec<bool> =
        ways.iter().map(|way| !ways.iter().any(|other| beats(other, way))).collect();
    for (way, on_front) in ways.iter_mut().zip(front) {
        way.on_front = on_front;
    }
}

impl Way {
    /// The proved bound on its error, in ulps of the format, if it is a float's.
    #[must_use]
    pub fn bound<'a>(&self, prices: &'a Prices) -> Option<(&'a Bounded, Precision)> {
        let [narrow, wide] = &prices.forms.get(self.form)?.bounds;
        match self.system {
            System::F32 => Some((narrow.as_ref()?, Precision::F32)),
            System::F64 => Some((wide.as_ref()?, Precision::F64)),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kane_floats::fpcore;

    #[test]
    fn a_repair_has_more_digits_and_every_system_is_there() {
        let text = "(FPCore (x) :pre (<= 1 x 100000) (- (/ 1 x) (/ 1 (+ x 1))))";
        let core = fpcore::read("t", text).unwrap().remove(0);
        let found = prices("f", &core, Work::brief(), Effort::Quick, &mut |_, _| {}).unwrap();
        let of = |name: &str, system: System| {
            let form = found.forms.iter().position(|form| form.name == name).unwrap();
            found.ways.iter().find(|way| way.form == form && way.system == system).unwrap()
        };
        let (given, repair) = (of("given", System::F64), of("repair 1", System::F64));
        // 2^-53 is 16 digits, of which a subtraction of neighbours at 10^5 loses 5
        assert!((900..1_200).contains(&given.worst), "{given:?}");
        assert!(repair.worst > 1_500, "{repair:?}");
        assert!(given.at[0] > 1e4, "{given:?}");
        assert_eq!(of("given", System::Rational).worst, i64::MAX);
        assert!(of("given", System::DoubleDouble).worst > 2_400);
        assert!(of("given", System::Interval).worst <= given.worst);
        assert!(found.ways.iter().all(|way| way.time.rounds > 0));
        let front: Vec<&Way> = found.ways.iter().filter(|way| way.on_front).collect();
        assert!(front.iter().any(|way| way.system == System::Rational), "exact is on the front");
        let (bound, _) = repair.bound(&found).unwrap();
        assert!(bound.bound < 8.0, "{bound:?}");
    }

    #[test]
    fn a_form_that_may_lose_all_is_told_from_one_that_may_fail() {
        let bound = |formula: &str| {
            let text = format!("(FPCore (x) :pre (<= 1 x 1000000000) {formula})");
            let core = fpcore::read("t", &text).unwrap().remove(0);
            let found = prices("f", &core, Work::brief(), Effort::Quick, &mut |_, _| {}).unwrap();
            let given = |way: &&Way| way.form == 0 && way.system == System::F64;
            found.ways.iter().find(given).unwrap().bound(&found).map(|(bound, _)| bound.bound)
        };
        assert_eq!(bound("(- (sqrt (+ (* x x) 1)) x)"), Some(f64::INFINITY));
        assert_eq!(bound("(/ 1 (- x 2))"), None);
    }

    /// Fractions have no irrational roots, so that they are no way to evaluate one.
    #[test]
    fn a_system_without_answers_is_left_out() {
        let core = fpcore::read("t", "(FPCore (x) :pre (<= 2 x 3) (sqrt x))").unwrap().remove(0);
        let found = prices("f", &core, Work::brief(), Effort::Quick, &mut |_, _| {}).unwrap();
        assert!(found.ways.iter().all(|way| way.system != System::Rational));
        assert_eq!(found.ways.len(), 4);
    }
}
