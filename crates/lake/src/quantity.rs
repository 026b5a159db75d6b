//! What can be asked of an impact in a query.

use kane_records::case::Case;
use kane_records::check::Check;

/// A number that follows of an impact, in SI units.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// ΔT, the change of kinetic energy; J. Above 0 it was created.
    EnergyGain,
    /// its part from work along the normal; J
    NormalWork,
    /// its part from work along the tangent and of rotation, which is that of friction; J
    FrictionWork,
    /// the kinetic energy before; J
    EnergyBefore,
    /// |p_t| − μ·p_n: how far friction is outside of its cone; N·s
    ConeExcess,
    /// p_n of the first body; N·s
    NormalImpulse,
    /// p_t of the first body; N·s
    TangentialImpulse,
    /// a = −u_n; m/s
    Approach,
    /// u_t before; m/s
    SlipBefore,
    /// u_t⁺; m/s
    SlipAfter,
    /// u_n⁺; m/s
    Separation,
    /// e as measured, −u_n⁺/u_n
    Restitution,
    /// k = u_t⁺/u_t: 1 where there is no friction, 0 where it stops the slip, −1 where it turns it back
    Ratio,
    /// α = μ·W_tt·p_n/(2·|u_t|) with the measured p_n: 1/2 where sliding friction just ends the slip
    Alpha,
}

impl Quantity {
    /// All of them.
    pub const ALL: [Self; 14] = [
        Self::EnergyGain,
        Self::NormalWork,
        Self::FrictionWork,
        Self::EnergyBefore,
        Self::ConeExcess,
        Self::NormalImpulse,
        Self::TangentialImpulse,
        Self::Approach,
        Self::SlipBefore,
        Self::SlipAfter,
        Self::Separation,
        Self::Restitution,
        Self::Ratio,
        Self::Alpha,
    ];

    /// The name of its function.
    #[must_use]
    pub const fn function(self) -> &'static str {
        match self {
            Self::EnergyGain => "kane_energy_gain",
            Self::NormalWork => "kane_normal_work",
            Self::FrictionWork => "kane_friction_work",
            Self::EnergyBefore => "kane_energy_before",
            Self::ConeExcess => "kane_cone_excess",
            Self::NormalImpulse => "kane_normal_impulse",
            Self::TangentialImpulse => "kane_tangential_impulse",
            Self::Approach => "kane_approach",
            Self::SlipBefore => "kane_slip_before",
            Self::SlipAfter => "kane_slip_after",
            Self::Separation => "kane_separation",
            Self::Restitution => "kane_restitution",
            Self::Ratio => "kane_k",
            Self::Alpha => "kane_alpha",
        }
    }

    /// What it is, in a line.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::EnergyGain => "change of kinetic energy; J",
            Self::NormalWork => "its part along the normal; J",
            Self::FrictionWork => "its part along the tangent and of rotation; J",
            Self::EnergyBefore => "kinetic energy before; J",
            Self::ConeExcess => "|p_t| - mu*p_n, above 0 outside of the cone; N s",
            Self::NormalImpulse => "p_n on body 1; N s",
            Self::TangentialImpulse => "p_t on body 1; N s",
            Self::Approach => "approach speed of the contact point; m/s",
            Self::SlipBefore => "slip of the contact point before; m/s",
            Self::SlipAfter => "slip of the contact point after; m/s",
            Self::Separation => "speed at which the contact point leaves; m/s",
            Self::Restitution => "e as measured",
            Self::Ratio => "k = (slip after)/(slip before)",
            Self::Alpha => "mu*W_tt*p_n/(2*|slip before|), 1/2 where sliding just ends",
        }
    }

    /// Its value; `None` where the row does not have it. In floats, off by some roundings.
    #[must_use]
    pub fn of(self, case: &Case<'_>) -> Option<f64> {
        let facts = &case.facts;
        let ([p_t, p_n], [u_t, u_n]) = (facts.impulse, facts.before);
        let [normal, tangential, rotational] = facts.energy;
        let slips = u_t.abs() > case.tolerance.slip_before;
        let approaches = -u_n > case.tolerance.separation;
        match self {
            Self::EnergyGain => Some(facts.energy.iter().sum()),
            Self::NormalWork => Some(normal),
            Self::FrictionWork => Some(tangential + rotational),
            Self::EnergyBefore => Some(case.energy_before()),
            Self::ConeExcess => Some(p_t.abs() - case.given.friction? * p_n),
            Self::NormalImpulse => Some(p_n),
            Self::TangentialImpulse => Some(p_t),
            Self::Approach => Some(-u_n),
            Self::SlipBefore => Some(u_t),
            Self::SlipAfter => Some(facts.after[0]),
            Self::Separation => Some(facts.after[1]),
            Self::Restitution => approaches.then(|| -facts.after[1] / u_n),
            Self::Ratio => slips.then(|| facts.after[0] / u_t),
            Self::Alpha => {
                let friction = case.given.friction?;
                slips.then(|| friction * case.event.delassus().tt() * p_n / (2.0 * u_t.abs()))
            }
        }
    }
}

/// What a scalar function gives of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Asked {
    /// a quantity
    Quantity(Quantity),
    /// the residual of a check, null where it has nothing to ask
    Residual(Check),
    /// whether a check holds, null likewise
    Holds(Check),
    /// the checks that fail, by name, separated by blanks
    Fails,
    /// why the row cannot be checked, null where it can
    Rejected,
}

impl Asked {
    /// Every function of a row.
    #[must_use]
    pub fn all() -> Vec<Self> {
        // the order of rows is nobody's who sees one row at a time
        let checks = || Check::ALL.into_iter().filter(|check| *check != Check::Order);
        let mut all: Vec<Self> = Quantity::ALL.map(Self::Quantity).to_vec();
        all.extend(checks().map(Self::Residual));
        all.extend(checks().map(Self::Holds));
        all.extend([Self::Fails, Self::Rejected]);
        all
    }

    /// The name of its function.
    #[must_use]
    pub fn function(self) -> String {
        match self {
            Self::Quantity(quantity) => quantity.function().to_owned(),
            Self::Residual(check) => format!("kane_residual_{}", check.id()),
            Self::Holds(check) => format!("kane_holds_{}", check.id()),
            Self::Fails => "kane_fails".to_owned(),
            Self::Rejected => "kane_rejected".to_owned(),
        }
    }

    /// What it gives, in a line.
    #[must_use]
    pub fn meaning(self) -> String {
        match self {
            Self::Quantity(quantity) => quantity.meaning().to_owned(),
            Self::Residual(check) => {
                format!("what is left of the check `{}`; {}", check.id(), check.unit())
            }
            Self::Holds(check) => format!("whether the check `{}` holds", check.id()),
            Self::Fails => "the checks that fail, separated by blanks".to_owned(),
            Self::Rejected => "why the row cannot be checked, or null".to_owned(),
        }
    }
}
