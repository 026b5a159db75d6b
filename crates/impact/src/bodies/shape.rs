//! The shapes that need no more than a mass and a few lengths.

use std::str::FromStr;

use kane_number::{Number, Rational, Real};

use super::{Direction, Motion, PlanarBody};

/// A round body, by how its mass is spread.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Shape {
    /// A solid sphere, J = 2/5·m·r².
    Sphere,
    /// A thin spherical shell, J = 2/3·m·r².
    HollowSphere,
    /// A solid disc or cylinder on its edge, J = 1/2·m·r².
    Disc,
    /// A thin hoop on its edge, J = m·r².
    Hoop,
}

/// A word that names no shape.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is no shape; known are sphere, hollow-sphere, disc and hoop")]
pub struct UnknownShape(pub String);

impl FromStr for Shape {
    type Err = UnknownShape;

    fn from_str(word: &str) -> Result<Self, Self::Err> {
        Self::ALL
            .into_iter()
            .find(|shape| shape.name() == word)
            .ok_or_else(|| UnknownShape(word.to_owned()))
    }
}

impl Shape {
    /// All shapes.
    pub const ALL: [Self; 4] = [Self::Sphere, Self::HollowSphere, Self::Disc, Self::Hoop];

    /// The word for it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Sphere => "sphere",
            Self::HollowSphere => "hollow-sphere",
            Self::Disc => "disc",
            Self::Hoop => "hoop",
        }
    }

    /// J/(m·r²), exact.
    #[must_use]
    pub fn gyration(self) -> Rational {
        let (numer, denom) = match self {
            Self::Sphere => (2, 5),
            Self::HollowSphere => (2, 3),
            Self::Disc => (1, 2),
            Self::Hoop => (1, 1),
        };
        Rational::new(numer.into(), denom.into())
    }

    /// j_p = 1 + m·r²/J, the tangential by the normal mobility: 7/2, 5/2, 3 and 2; exact.
    #[must_use]
    pub fn mobility_ratio(self) -> Rational {
        Rational::one() + self.gyration().recip()
    }

    /// The body of mass m (kg) and radius r (m) that touches an obstacle below it.
    #[must_use]
    pub fn body<N: Number>(self, mass: N, radius: N, before: Motion<N>) -> PlanarBody<N> {
        let inertia = radius.square() * &mass * N::from_rational(&self.gyration());
        PlanarBody { mass, inertia, arm: [N::zero(), -radius], before }
    }
}

impl<N: Real> PlanarBody<N> {
    /// A thin uniform rod of mass m (kg) and length l (m) that touches with its tip, J = m·l²/12.
    ///
    /// `direction` is that of the rod from the tip up to the centre: (cos, sin) of its angle with
    /// the surface. Exact in exact numbers.
    #[must_use]
    pub fn rod_tip(mass: N, length: N, direction: &Direction<N>, before: Motion<N>) -> Self {
        let half_length = super::half(length.clone());
        let twelve = N::from_rational(&Rational::from_integer(12.into()));
        Self {
            inertia: length.square() * &mass / twelve,
            arm: [-(half_length.clone() * &direction.cos), -(half_length * &direction.sin)],
            mass,
            before,
        }
    }

    /// A uniform ellipse of mass m (kg) and half-axes a, b (m), J = m·(a² + b²)/4, that rests on an
    /// obstacle below it with its first axis in the given direction; `None` where the number system
    /// does not hold the height h of the centre.
    ///
    /// h² = a²·sin² + b²·cos², and the contact point is at (−(a² − b²)·sin·cos/h, −h). Exact where
    /// the root is.
    #[must_use]
    pub fn ellipse(
        mass: N,
        [a, b]: [N; 2],
        direction: &Direction<N>,
        before: Motion<N>,
    ) -> Option<Self> {
        let (a2, b2) = (a.square(), b.square());
        let square = a2.clone() * direction.sin.square() + b2.clone() * direction.cos.square();
        let upper = a + &b;
        let coefficients = [-square, N::zero(), N::one()];
        let height = N::greatest_root(&coefficients, &N::zero(), &upper)?;
        let product = direction.sin.clone() * &direction.cos;
        let along = ((a2.clone() - &b2) * product).checked_div(&height)?;
        let four = N::one().double().double();
        let inertia = (a2 + b2) * &mass / four;
        Some(Self { mass, inertia, arm: [-along, -height], before })
    }
}
