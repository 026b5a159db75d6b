//! Polynomials of whose three signs one is left.

use kane_kernel::{Atom, Poly, Sign, State};

use crate::argument::{Argument, Rules as _};

/// A polynomial that is zero, or positive, and why it has neither other sign.
pub(super) struct Settled {
    pub(super) poly: Poly,
    /// [`Sign::Zero`] or [`Sign::Positive`]
    pub(super) sign: Sign,
    /// that it is not zero, if it is positive, and not positive, if it is zero
    pub(super) other: Argument,
    /// that it is not negative
    pub(super) negative: Argument,
}

impl Settled {
    /// A polynomial that is positive, if the arguments show that it is not zero and not negative.
    pub(super) fn positive(
        state: &State<'_, '_>,
        poly: Poly,
        zero: Argument,
        negative: Argument,
    ) -> Option<Self> {
        let sure = closes(state, Sign::Zero, poly.clone(), &zero)
            && closes(state, Sign::Positive, poly.neg(), &negative);
        sure.then_some(Self { poly, sign: Sign::Positive, other: zero, negative })
    }

    /// What is known by it.
    pub(super) fn atom(&self) -> Atom {
        Atom::new(self.poly.clone(), self.sign)
    }

    /// The split on the sign, once an argument shows that the one that is left contradicts itself, too.
    pub(super) fn split(self, left: Argument) -> Argument {
        let Self { poly, sign, other, negative } = self;
        let (zero, positive) = if sign == Sign::Zero { (left, other) } else { (other, left) };
        let [zero, positive, negative] = [zero, positive, negative].map(Box::new);
        Argument::Split { poly, zero, positive, negative }
    }
}

/// A polynomial that is positive, or at least not negative.
pub(super) struct NotNegative {
    pub(super) poly: Poly,
    /// why it is not zero, if that is known
    pub(super) zero: Option<Argument>,
    /// why it is not negative
    pub(super) negative: Argument,
}

impl NotNegative {
    /// A polynomial that is not negative, if the argument shows it, and not zero, if there is one that shows that.
    pub(super) fn new(
        state: &State<'_, '_>,
        poly: Poly,
        zero: Option<Argument>,
        negative: Argument,
    ) -> Option<Self> {
        let zero = zero.filter(|zero| closes(state, Sign::Zero, poly.clone(), zero));
        closes(state, Sign::Positive, poly.neg(), &negative).then_some(Self {
            poly,
            zero,
            negative,
        })
    }
}

/// Whether an argument shows that a polynomial has not this sign.
fn closes(state: &State<'_, '_>, sign: Sign, poly: Poly, argument: &Argument) -> bool {
    state.with(Atom::new(poly, sign)).closes(argument).is_ok()
}
