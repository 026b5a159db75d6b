//! The search along one input: every binade, the zeros of the exact value, and around the worst.

use crate::{Dyadic, DyadicNumber, Fault, Format, Formula, Plain, Program, Sample, judge};

use super::Subject;
use crate::Axis;

/// Bits of the reference at inputs near 1, and further ones for each binade away from it: a formula
/// that is quadratic in the input may cancel twice as many, and a third is in reserve.
const BITS: u64 = 256;
const BITS_PER_BINADE: u64 = 3;
/// Certain bits of the reference that are enough.
const NEEDED: i64 = 96;

/// The reference arithmetic for inputs so many binades away from 1.
pub(super) fn reference(binades: u64) -> Dyadic {
    Dyadic { bits: BITS + BITS_PER_BINADE * binades }
}

/// The value of a program in the reference arithmetic. Where all that is left of a sum that cancels
/// exactly is rounding, that counts as 0.
pub(super) fn reference_value(
    program: &Program,
    arithmetic: &Dyadic,
    inputs: &[DyadicNumber],
) -> Option<DyadicNumber> {
    let value = program.value(arithmetic, inputs)?;
    if value.certain_bits() >= NEEDED {
        return Some(value);
    }
    // once more with twice the bits; what is then no different from 0 is taken for 0
    let value = program.value(&Dyadic { bits: 2 * arithmetic.bits }, inputs)?;
    Some(if value.certain_bits() > 0 { value } else { DyadicNumber::zero() })
}

/// A formula of one input, ready to be asked about any float.
pub(super) struct Probe<'a, F: Format> {
    pub(super) formula: &'a Formula,
    /// whether the input is below 0; places are those of its magnitude
    pub(super) negative: bool,
    constants: Vec<Option<F>>,
    /// formulas of the same value, for inputs at which this one has none
    equals: Vec<&'a Formula>,
}

/// One input and what the formula did there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tried {
    pub(super) place: u64,
    pub(super) sample: Sample,
    /// −1, 0 or 1
    sign: i8,
}

impl<'a, F: Format> Probe<'a, F> {
    pub(super) fn new(subject: &'a Subject, index: usize, negative: bool) -> Option<Self> {
        let formula = subject.formulas.get(index)?;
        let constants = formula.program.constants(&Plain::<F>::new());
        let equals = subject.equal.get(index).into_iter().flatten();
        let equals = equals.filter_map(|other| subject.formulas.get(*other)).collect();
        Some(Self { formula, negative, constants, equals })
    }

    fn at(&self, place: u64) -> F {
        F::signed(self.negative, place)
    }

    /// What the formula returns.
    pub(super) fn computed(&self, place: u64) -> Option<F> {
        self.all_computed(place).pop().flatten()
    }

    /// The results of all operations.
    pub(super) fn all_computed(&self, place: u64) -> Vec<Option<F>> {
        self.formula.program.values(&Plain::<F>::new(), &self.constants, &[self.at(place)])
    }

    /// The exact value, by the formula or by an equal one; `None` outside the domain.
    pub(super) fn exact(&self, place: u64) -> Option<DyadicNumber> {
        let input = self.at(place).exactly()?;
        let binades = if input.is_zero() { 0 } else { input.binade().unsigned_abs() };
        let arithmetic = reference(binades);
        let inputs = [input];
        if !self.formula.admits(&arithmetic, &inputs) {
            return None;
        }
        reference_value(&self.formula.program, &arithmetic, &inputs).or_else(|| {
            let mut equals = self.equals.iter().filter(|form| form.admits(&arithmetic, &inputs));
            equals.find_map(|form| reference_value(&form.program, &arithmetic, &inputs))
        })
    }

    /// The exact results of all operations.
    pub(super) fn all_exact(&self, place: u64) -> Vec<Option<DyadicNumber>> {
        let Some(input) = self.at(place).exactly() else { return vec![] };
        let binades = if input.is_zero() { 0 } else { input.binade().unsigned_abs() };
        let arithmetic = reference(binades);
        let constants = self.formula.program.constants(&arithmetic);
        self.formula.program.values(&arithmetic, &constants, &[input])
    }

    /// The judgement; `None` outside the domain. A formula without any value in floats, where no
    /// case applies, counts as NaN.
    pub(super) fn ask(&self, place: u64) -> Option<Tried> {
        let exact = self.exact(place)?;
        let all = 100 * i64::from(F::PRECISION);
        let sample = match self.computed(place) {
            Some(computed) => judge(computed, &exact),
            None => Sample { fault: Some(Fault::Nan), lost: all },
        };
        let sign = if exact.is_zero() {
            0
        } else if exact.is_negative() {
            -1
        } else {
            1
        };
        Some(Tried { place, sample, sign })
    }
}

/// Tries every binade, then closes in on the zeros of the exact value, where a sum that cancels
/// shows, and climbs from the worst inputs to worse neighbours. In the order of the places.
pub(super) fn scan<F: Format>(probe: &Probe<'_, F>, axis: &Axis) -> Vec<Tried> {
    let mut samples: Vec<Tried> =
        axis.places::<F>(1).into_iter().filter_map(|place| probe.ask(place)).collect();
    let mut more = Vec::new();
    for (left, right) in samples.iter().zip(samples.iter().skip(1)) {
        if left.sign != right.sign {
            let zero = zero(probe, left, right.place);
            more.extend(around(axis, zero));
            more.extend(beside(axis, zero));
        }
    }
    // where the domain begins or ends within the axis, as at the guard of a case
    let ends = [samples.first(), samples.last()];
    for (place, end) in ends.into_iter().flatten().map(|s| s.place).zip([axis.first, axis.last]) {
        if place != end {
            let edge = domain_edge(probe, end, place);
            more.extend(around(axis, edge));
            more.extend(beside(axis, edge));
        }
    }
    // there, as at a zero, little may be left of the value, and digits are lost on some floats only
    let ends: Vec<u64> = ends.into_iter().flatten().map(|end| end.place).collect();
    for end in ends {
        more.extend(beside(axis, end));
    }
    samples.extend(more.into_iter().filter_map(|place| probe.ask(place)));
    samples.sort_by_key(|tried| tried.place);
    samples.dedup_by_key(|tried| tried.place);

    let mut worst: Vec<Tried> =
        samples.iter().filter(|s| s.sample.fault.is_none()).copied().collect();
    worst.sort_by_key(|s| (-s.sample.lost, s.place));
    for start in worst.into_iter().take(4) {
        samples.extend(climb(probe, axis, start));
    }
    samples.sort_by_key(|tried| tried.place);
    samples.dedup_by_key(|tried| tried.place);
    samples
}

/// The place next to a change of sign between a sample and a later place.
fn zero<F: Format>(probe: &Probe<'_, F>, left: &Tried, right: u64) -> u64 {
    let (mut low, mut high) = (left.place, right);
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        match probe.ask(middle) {
            Some(tried) if tried.sign == left.sign => low = middle,
            Some(tried) if tried.sign == 0 => return middle,
            _ => high = middle,
        }
    }
    high
}

/// The place within the domain that is next to one outside.
fn domain_edge<F: Format>(probe: &Probe<'_, F>, mut outside: u64, mut inside: u64) -> u64 {
    while outside.abs_diff(inside) > 1 {
        let middle = outside.min(inside) + outside.abs_diff(inside) / 2;
        if probe.exact(middle).is_some() { inside = middle } else { outside = middle }
    }
    inside
}

/// Places around one, at distances that double.
fn around(axis: &Axis, center: u64) -> Vec<u64> {
    let mut places = vec![center];
    for bit in 0..52 {
        let step = 1_u64 << bit;
        places.extend([center.saturating_add(step), center.saturating_sub(step)]);
    }
    places.retain(|place| axis.holds(*place));
    places
}

/// Places on both sides of one, several in every doubling of the distance, the same in every run.
fn beside(axis: &Axis, center: u64) -> Vec<u64> {
    const IN_A_DOUBLING: u64 = 12;
    let mut places = Vec::new();
    let mut seed = center;
    for bit in 1..52 {
        let from = 1_u64 << bit;
        for _ in 0..IN_A_DOUBLING {
            // a step of a linear congruential generator, by its upper bits
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let step = from + (seed >> 11) % from;
            places.extend([center.saturating_add(step), center.saturating_sub(step)]);
        }
    }
    places.retain(|place| axis.holds(*place));
    places
}

/// Goes from a place to a worse one nearby, for as long as there is one.
fn climb<F: Format>(probe: &Probe<'_, F>, axis: &Axis, start: Tried) -> Vec<Tried> {
    let mut seen = vec![];
    let mut best = start;
    for _ in 0..6 {
        let near = around(axis, best.place).into_iter().take(49);
        let found: Vec<Tried> = near.filter_map(|place| probe.ask(place)).collect();
        let next = found.iter().max_by_key(|s| (s.sample.lost, u64::MAX - s.place)).copied();
        seen.extend(found);
        match next {
            Some(next) if next.sample.lost > best.sample.lost => best = next,
            _ => break,
        }
    }
    seen
}

/// The worst of every binade of the input.
pub(super) fn profile<F: Format>(samples: &[Tried]) -> Vec<(i64, i64, Option<Fault>)> {
    let mut profile: Vec<(i64, i64, Option<Fault>)> = Vec::new();
    for tried in samples {
        let Some(input) = F::at(tried.place).exactly() else { continue };
        if input.is_zero() {
            continue;
        }
        let binade = input.binade();
        match profile.last_mut() {
            Some((last, lost, fault)) if *last == binade => {
                *lost = (*lost).max(tried.sample.lost);
                *fault = (*fault).max(tried.sample.fault);
            }
            _ => profile.push((binade, tried.sample.lost, tried.sample.fault)),
        }
    }
    profile
}
