//! Checks that need no impact law, and how each row fares.

/// A check of one row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Check {
    /// The impulses on the two bodies, or the logged one and m·Δv, add up to nothing.
    Reaction,
    /// J·Δω = r × p: the impulse acts at the contact point.
    Moment,
    /// p_n ≥ 0.
    Pull,
    /// u_n⁺ ≥ 0.
    Penetration,
    /// |p_t| ≤ μ·p_n.
    Cone,
    /// Friction does not push the way in which the contact slides afterwards.
    Opposes,
    /// Friction below its bound leaves no slip.
    Sticks,
    /// ΔT ≤ 0.
    Energy,
    /// u_n⁺ = e·a.
    Restitution,
    /// Time does not go back.
    Order,
}

/// On what a check rests.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ground {
    /// Momentum and energy: no law of impact is an excuse.
    Mechanics,
    /// Rigid surfaces, Coulomb's friction, the stated restitution: a law may say otherwise.
    Constitutive,
    /// The log's own order.
    Log,
}

impl Check {
    /// All checks, in the order of reports.
    pub const ALL: [Self; 10] = [
        Self::Reaction,
        Self::Moment,
        Self::Pull,
        Self::Penetration,
        Self::Energy,
        Self::Restitution,
        Self::Cone,
        Self::Opposes,
        Self::Sticks,
        Self::Order,
    ];

    /// Its place in [`ALL`](Self::ALL).
    #[must_use]
    pub fn place(self) -> usize {
        Self::ALL.iter().position(|check| *check == self).unwrap_or(0)
    }

    /// Its name for programs.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Reaction => "reaction",
            Self::Moment => "moment",
            Self::Pull => "pull",
            Self::Penetration => "penetration",
            Self::Cone => "cone",
            Self::Opposes => "opposes",
            Self::Sticks => "sticks",
            Self::Energy => "energy",
            Self::Restitution => "restitution",
            Self::Order => "order",
        }
    }

    /// On what it rests.
    #[must_use]
    pub const fn ground(self) -> Ground {
        match self {
            Self::Reaction | Self::Moment | Self::Pull | Self::Energy => Ground::Mechanics,
            // about a normal that turns, as Saitoh et al. have it, the way apart is another one
            Self::Penetration | Self::Cone | Self::Opposes | Self::Sticks | Self::Restitution => {
                Ground::Constitutive
            }
            Self::Order => Ground::Log,
        }
    }

    /// The unit of its residual.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Reaction | Self::Pull | Self::Cone => "N·s",
            Self::Moment => "N·m·s",
            Self::Penetration | Self::Opposes | Self::Sticks | Self::Restitution => "m/s",
            Self::Energy => "J",
            Self::Order => "s",
        }
    }
}

/// Whether a check holds of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// It holds.
    Holds,
    /// It holds if the numbers were rounded as they seem to be, and fails if they are of the stricter format that they
    /// may be of as well; which, the log does not tell, see [`Told`](crate::told::Told).
    Undecided,
    /// It fails.
    Fails,
}

/// What a check says of a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finding {
    /// what is left, at least 0
    pub residual: f64,
    /// how much may be left
    pub tolerance: f64,
    /// the scale of the quantity
    pub scale: f64,
    /// whether it holds
    pub verdict: Verdict,
}

impl Finding {
    /// The residual by the scale of the quantity: 1 is all of it.
    #[must_use]
    pub fn size(&self) -> f64 {
        if self.residual > 0.0 { self.residual / self.scale.max(f64::MIN_POSITIVE) } else { 0.0 }
    }

    /// Whether the check holds, if that is decided.
    #[must_use]
    pub const fn holds(&self) -> Option<bool> {
        match self.verdict {
            Verdict::Holds => Some(true),
            Verdict::Undecided => None,
            Verdict::Fails => Some(false),
        }
    }

    /// Whether the check fails.
    #[must_use]
    pub const fn fails(&self) -> bool {
        matches!(self.verdict, Verdict::Fails)
    }

    /// Whether the verdict is near its tolerance, within a factor of two.
    #[must_use]
    #[inline]
    pub fn is_near(&self) -> bool {
        self.residual > self.tolerance / 2.0 && self.residual <= 2.0 * self.tolerance
    }
}
