//! The impulse at a contact.

use kane_number::Number;

/// The impulse on the body over a whole collision; N·s.
///
/// In the literature's signs: `normal` ≥ 0 pushes the surfaces apart, and `tangential` is along
/// the tangent in which the slip is counted, so that friction which opposes a positive slip is
/// negative. The paper's I_x is −`tangential` and its I_y is `normal`.
#[derive(Clone, Debug, PartialEq)]
pub struct Impulse<N> {
    /// `p_t`, of either sign.
    pub tangential: N,
    /// `p_n` ≥ 0.
    pub normal: N,
}

impl<N: Number> Impulse<N> {
    /// The impulse in the mirror, where the tangent points the other way.
    #[must_use]
    pub fn mirrored(self) -> Self {
        Self { tangential: -self.tangential, normal: self.normal }
    }

    /// The same impulse in another number system.
    pub fn map<M>(&self, to: impl Fn(&N) -> M) -> Impulse<M> {
        Impulse { tangential: to(&self.tangential), normal: to(&self.normal) }
    }
}
