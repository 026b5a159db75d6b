//! How often plain floats decide a comparison wrongly.

use kane_floats::decision::{Decision, Share, decisions, share};
use kane_floats::{Core, Machine};

/// A comparison of a formula in one format. The inputs were drawn: next to where the comparison turns, and over
/// the whole domain; those that count as wrong are wrong exactly.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decided {
    /// the comparison
    pub decision: Decision,
    /// inputs drawn over the domain
    pub drawn: usize,
    /// those of them that are decided wrongly
    pub wrong: usize,
    /// inputs drawn next to ties
    pub near: usize,
    /// those of them that are decided wrongly
    pub wrong_near: usize,
    /// an input that is decided wrongly, and whether the comparison holds there
    pub example: Option<(Vec<String>, bool)>,
}

/// All comparisons of a formula in the format of `M`.
pub(super) fn decided<M: Machine>(core: &Core) -> Vec<Decided> {
    let one = |decision: Decision| {
        let Share { drawn, wrong, near, wrong_near, tie } = share::<M>(core, &decision)?;
        let example = tie.map(|tie| (tie.at.into_iter().map(shortest::<M>).collect(), tie.holds));
        Some(Decided { decision, drawn, wrong, near, wrong_near, example })
    };
    decisions(core).into_iter().filter_map(one).collect()
}

/// The shortest decimal that names a float.
pub(super) fn shortest<M: Machine>(float: M) -> String {
    if float.magnitude_bits() == 0 { "0".to_owned() } else { format!("{float:e}") }
}
