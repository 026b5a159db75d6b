//! An impact as attribution sees it: a contact, what was measured at it, and how well.

use kane_impact::{Contact, Delassus};

use crate::acted::Acted;
use crate::case::Case;
use crate::check::Check;
use crate::event::Given;

/// What attribution keeps of a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Seen {
    /// the line of the file
    pub line: u64,
    /// the pair of materials
    pub pair: u32,
    /// u_t before; m/s
    pub slip: f64,
    /// g·Δt against a fixed body, along tangent and normal, which is in the velocities before and after: gravity may
    /// act after the impact as well; m/s
    pub fall: [f64; 2],
    /// a = −u_n before; m/s
    pub approach: f64,
    /// u_t⁺; m/s
    pub slip_after: f64,
    /// u_n⁺; m/s
    pub separation: f64,
    /// p_t; N·s
    pub tangential: f64,
    /// p_n; N·s
    pub normal: f64,
    /// W_tt, W_tn, W_nn; 1/kg
    pub mobility: [f64; 3],
    /// what is stated
    pub given: Given,
    /// tolerances of u_t⁺, of u_n⁺, of p_t and of p_n
    pub within: [f64; 4],
    /// 1 − y'/y of the stated arm y and that at which the impulse acted, along the normal; NaN where there is too
    /// little friction to tell
    pub arm: f64,
    /// by how much the arm may differ
    pub arm_within: f64,
    /// J·Δω by r × p of the first body, which mechanics has at 1; NaN where there is too little to tell
    pub turned: f64,
    /// the stretching of errors by the contact, W_tt·W_nn/det W
    pub stretch: f64,
    /// ΔT by the energy before, and whether energy rises beyond its tolerance
    pub gain: (f64, bool),
    /// the contact at the arm at which the impulse acted, where the time step leaves that open
    acted: Option<Acted>,
}

impl Seen {
    /// Of a case.
    #[must_use]
    pub fn of(case: &Case<'_>) -> Self {
        let (facts, tolerance) = (&case.facts, &case.tolerance);
        let w = case.event.delassus();
        let mobility = [*w.tt(), *w.tn(), *w.nn()];
        let [tt, tn, nn] = mobility;
        let stretch = tt * nn / w.determinant().max(tt * nn * f64::EPSILON);
        let [p_t, p_n] = facts.impulse;
        let body = &case.event.first;
        // J·Δω = x·p_n − y'·p_t gives the y' at which the impulse acted
        let y = body.arm[1];
        let told = p_t.abs() > 100.0 * tolerance.tangential && y != 0.0;
        let arm = if told { facts.moment / p_t / y } else { f64::NAN };
        let spin = body.before[2].abs() + body.after[2].abs();
        let shift = case.shift();
        let lever_arm = body.arm[0] * p_n - body.arm[1] * p_t;
        let turns = lever_arm.abs() > 100.0 * tolerance.moment;
        let turned = if turns { 1.0 + facts.moment / lever_arm } else { f64::NAN };
        let coupling = if tn == 0.0 { 0.0 } else { spin * tolerance.arm * body.arm[0].abs() };
        // what settings that were rounded do to what a law makes of them
        let [du_t, du_n] = [0, 1].map(|k: usize| (facts.after[k] - facts.before[k]).abs());
        let rubbed = tolerance.friction * tt * p_n.abs();
        let bounced = tolerance.elasticity * facts.before[1].abs();
        let settings = [
            2.0 * tolerance.mobility * du_t + rubbed + bounced,
            2.0 * tolerance.mobility * du_n + bounced,
        ];
        Self {
            line: case.row.line,
            pair: case.row.pair,
            slip: facts.before[0],
            // both bodies of a pair fall alike
            fall: if case.event.second.is_some() { [0.0; 2] } else { case.event.kick },
            approach: -facts.before[1],
            slip_after: facts.after[0],
            separation: facts.after[1],
            tangential: p_t,
            normal: p_n,
            mobility,
            given: case.given,
            within: [
                tolerance.slip + shift + settings[0],
                tolerance.separation + coupling + settings[1],
                tolerance.tangential,
                tolerance.normal,
            ],
            arm,
            arm_within: tolerance.arm + tolerance.mobility,
            turned,
            stretch,
            gain: gain(case),
            acted: Acted::of(case),
        }
    }

    /// An impact of a body of W = 1 with a slip of 1 and an approach of 1, where μ = 1 and nothing is
    /// uncertain: what a law of friction is drawn on.
    pub(crate) fn plain() -> Self {
        Self {
            line: 0,
            pair: 0,
            slip: 1.0,
            fall: [0.0; 2],
            approach: 1.0,
            slip_after: 1.0,
            separation: 1.0,
            tangential: 0.0,
            normal: 1.0,
            mobility: [1.0, 0.0, 1.0],
            given: Given { friction: Some(1.0), restitution: Some(1.0), ..Given::default() },
            within: [0.0; 4],
            arm: f64::NAN,
            arm_within: 0.0,
            turned: f64::NAN,
            stretch: 1.0,
            gain: (0.0, false),
            acted: None,
        }
    }

    /// The same impact if gravity acts after it; `None` where that is no other one.
    #[must_use]
    pub fn before_gravity(&self) -> Option<Self> {
        let [t, n] = self.fall;
        (t != 0.0 || n != 0.0).then(|| Self {
            slip: self.slip - t,
            approach: self.approach + n,
            slip_after: self.slip_after - t,
            separation: self.separation - n,
            fall: [0.0; 2],
            ..self.clone()
        })
    }

    /// The same impact at the arm at which the impulse acted; `None` where the stated one is known or is all there is.
    #[must_use]
    pub fn where_it_acted(&self) -> Option<Self> {
        let Acted { slip, slip_after, mobility } = self.acted?;
        Some(Self { slip, slip_after, mobility, acted: None, ..self.clone() })
    }

    /// e as measured, −u_n⁺/u_n; `None` for a contact that does not approach.
    #[must_use]
    pub fn observed_restitution(&self) -> Option<f64> {
        (self.approach > 0.0).then(|| self.separation / self.approach)
    }

    /// u_t if the normal impulse alone had acted.
    #[must_use]
    pub fn slip_without_friction(&self) -> f64 {
        self.slip + self.mobility[1] * self.normal
    }

    /// The friction that ends with no slip.
    #[must_use]
    pub fn stopping(&self) -> f64 {
        -self.slip_without_friction() / self.mobility[0]
    }

    /// Whether the contact couples normal and tangent by more than the arm is uncertain.
    #[must_use]
    pub fn couples(&self) -> bool {
        let [tt, tn, nn] = self.mobility;
        tn.abs() > self.arm_within.max(1e-9) * (tt * nn).sqrt()
    }

    /// The contact as a law sees it, with these coefficients. A coupling that may be rounding alone would keep laws
    /// from being the ones of spheres, and is left out.
    #[must_use]
    pub fn contact(&self, friction: f64, restitution: f64) -> Contact<f64> {
        let tn = if self.couples() { self.mobility[1] } else { 0.0 };
        self.with_coupling(tn, friction, restitution)
    }

    /// The same with the coupling as it is stated, where that is left out.
    #[must_use]
    pub(crate) fn coupled(&self, friction: f64, restitution: f64) -> Option<Contact<f64>> {
        let tn = self.mobility[1];
        (tn != 0.0 && !self.couples()).then(|| self.with_coupling(tn, friction, restitution))
    }

    fn with_coupling(&self, tn: f64, friction: f64, restitution: f64) -> Contact<f64> {
        let w = Delassus::unchecked(self.mobility[0], tn, self.mobility[2]);
        Contact::unchecked(self.slip, self.approach.max(0.0), w, friction, restitution)
    }

    /// Whether slip is left beyond doubt.
    #[must_use]
    pub fn slips_after(&self) -> bool {
        self.slip_after.abs() > self.within[0]
    }
}

fn gain(case: &Case<'_>) -> (f64, bool) {
    let change: f64 = case.facts.energy.iter().sum();
    let share = change / case.energy_before().max(f64::MIN_POSITIVE);
    (share, case.finding(Check::Energy).is_some_and(|finding| finding.fails()))
}
