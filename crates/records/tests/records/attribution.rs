//! Logs made by equations that are written out here: what they follow is found, with its numbers.

use std::fmt::Write as _;

use kane_impact::laws;
use kane_records::friction::FrictionLaw;
use kane_records::reader::Kind;
use kane_records::restitution::{Factor, NormalLaw};
use kane_records::study::{Options, Study, study};
use kane_records::untold::Untold;

/// A disc of 1 kg and 1 m: j_p = 3.
#[derive(Clone, Copy)]
struct Impact {
    vx: f64,
    approach: f64,
    mu: f64,
    e: f64,
    phase: f64,
}

/// Speeds, slips, coefficients and phases that vary by themselves.
fn impacts() -> Vec<Impact> {
    let mut all = Vec::new();
    for speed in [0.2, 0.5, 0.8, 1.25, 2.0, 3.1] {
        for slip in [-4.0, -1.1, 0.15, 0.6, 2.3, 7.0] {
            for e in [0.25, 0.8] {
                for phase in [0.1, 0.6] {
                    all.push(Impact { vx: slip, approach: speed, mu: 0.23, e, phase });
                }
            }
        }
    }
    all
}

/// The log in which the impacts have this e, and this p_t given p_n.
fn log(
    impacts: &[Impact],
    e: impl Fn(&Impact) -> f64,
    friction: impl Fn(&Impact, f64) -> f64,
) -> String {
    let mut text = String::from(
        "mass,radius,inertia,mu,e,phase,pair,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post\n",
    );
    for impact in impacts {
        let Impact { vx, approach, mu, e: stated, phase } = impact;
        let p_n = (1.0 + e(impact)) * approach;
        let p_t = friction(impact, p_n);
        let (x, y, spin) = (vx + p_t, p_n - approach, 2.0 * p_t);
        let _ = writeln!(
            text,
            "1,1,0.5,{mu},{stated},{phase},steel on steel,{vx},-{approach},0,{x},{y},{spin}"
        );
    }
    text
}

fn coulomb(impact: &Impact, bound: f64) -> f64 {
    (-impact.vx / 3.0).clamp(-bound, bound)
}

fn studied(log: &str) -> Study {
    study(log.as_bytes(), Kind::Csv, &Options::new(laws())).expect("it is a log")
}

fn normal(study: &Study) -> NormalLaw {
    study.restitution.as_ref().expect("there are rows").law
}

#[test]
fn a_threshold_of_speed_is_found_with_its_value() {
    let e = |impact: &Impact| if impact.approach < 1.0 { 0.0 } else { impact.e };
    let study = studied(&log(&impacts(), e, |impact, p| coulomb(impact, impact.mu * p)));
    let NormalLaw::Threshold(found) = normal(&study) else { panic!("{:?}", normal(&study)) };
    assert_eq!((found.factor, found.between), (Factor::Speed, (0.8, 1.25)));
    assert!(found.misses_below && found.instead == 0.0);
    // friction is judged by the normal impulse that was measured, and has no part in this
    assert_eq!(study.friction[0].law, FrictionLaw::Coulomb);
    assert_eq!(study.friction[0].consistent, study.friction[0].rows);
}

#[test]
fn what_restitution_depends_on_is_found_in_a_sweep() {
    let by_phase = |impact: &Impact| 0.1 + impact.phase;
    let study = studied(&log(&impacts(), by_phase, |impact, p| coulomb(impact, impact.mu * p)));
    assert_eq!(normal(&study), NormalLaw::Depends);
    let found = study.restitution.expect("there are rows").depends;
    assert_eq!(found.iter().map(|(of, _)| *of).collect::<Vec<_>>(), [Factor::Phase]);
    assert!((found[0].1 - 1.0).abs() < 1e-9, "{found:?}");

    let study = studied(&log(&impacts(), |_| 0.4, |impact, p| coulomb(impact, impact.mu * p)));
    assert_eq!(normal(&study), NormalLaw::Constant);
}

#[test]
fn friction_is_named_by_the_bound_that_it_has() {
    let best = |friction: &dyn Fn(&Impact, f64) -> f64| {
        let study = studied(&log(&impacts(), |impact| impact.e, friction));
        let best = study.friction[0].clone();
        assert_eq!(best.consistent, best.rows, "{best:?}");
        best.law
    };
    let near = |a: f64, b: f64| (a - b).abs() < 1e-9;
    let share = best(&|impact, p| coulomb(impact, 0.4 * impact.mu * p));
    assert!(matches!(share, FrictionLaw::Share(share) if near(share, 0.4)), "{share:?}");
    let bound = best(&|impact, p| coulomb(impact, impact.mu * p / (1.0 + impact.e)));
    assert_eq!(bound, FrictionLaw::Compression);
    assert_eq!(best(&|_, _| 0.0), FrictionLaw::None);
    let walton = best(&|impact, p| (-1.6 * impact.vx / 3.0).clamp(-impact.mu * p, impact.mu * p));
    assert!(matches!(walton, FrictionLaw::Walton(beta) if near(beta, 0.6)), "{walton:?}");
    let fading = best(&|impact, p| {
        // i = 1/(1 + alpha), alpha = 3*mu*p/(2*v)
        -impact.vx.signum() * impact.mu * p / (1.0 + 1.5 * impact.mu * p / impact.vx.abs())
    });
    assert_eq!(fading, FrictionLaw::WangSuLi);
    let uncapped = best(&|impact, p| -impact.vx.signum() * impact.mu * p);
    assert_eq!(uncapped, FrictionLaw::Uncapped);
}

#[test]
fn coefficients_are_intervals_that_hold_the_truth() {
    let study =
        studied(&log(&impacts(), |impact| impact.e, |impact, p| coulomb(impact, impact.mu * p)));
    assert_eq!(study.pairs, ["steel on steel"]);
    assert_eq!(study.fits.len(), 2, "one for each stated e");
    for (fit, e) in study.fits.iter().zip([0.25, 0.8]) {
        let [found, mu] = [fit.restitution, fit.friction].map(|fitted| fitted.expect("told"));
        for (fitted, truth) in [(found, e), (mu, 0.23)] {
            assert!(fitted.one_value && fitted.low <= truth && truth <= fitted.high, "{fitted:?}");
            assert!(fitted.high - fitted.low < 1e-9, "{fitted:?}");
        }
    }
}

#[test]
fn what_the_rows_leave_open_is_said() {
    let half = |impact: &Impact, p: f64| coulomb(impact, impact.mu * p / (1.0 + impact.e));
    let one: Vec<Impact> = impacts().into_iter().filter(|impact| impact.e == 0.25).collect();
    let study = studied(&log(&one, |impact| impact.e, half));
    let mu = study.untold.iter().find_map(|open| match open {
        Untold::ConstantRestitution(mu) => Some(*mu),
        _ => None,
    });
    assert!(mu.is_some_and(|mu| (mu - 0.23 / 1.25).abs() < 1e-9), "{:?}", study.untold);
    assert!(study.untold.contains(&Untold::Round));
    assert!(study.untold.contains(&Untold::Same(Factor::Stated)));
    // with two values of e it is told
    let study = studied(&log(&impacts(), |impact| impact.e, half));
    let open = |open: &Untold| matches!(open, Untold::ConstantRestitution(_));
    assert!(!study.untold.iter().any(open), "{:?}", study.untold);

    let slow: Vec<Impact> = impacts()
        .into_iter()
        .filter(|impact| impact.vx.abs() < 0.2 && impact.approach > 1.0)
        .collect();
    let study = studied(&log(&slow, |impact| impact.e, |impact, p| coulomb(impact, impact.mu * p)));
    assert!(study.untold.contains(&Untold::NothingSlides), "{:?}", study.untold);
}

#[test]
fn a_restitution_above_one_is_legitimate_without_a_gain() {
    // what is lost along the tangent comes back along the normal
    let one = [Impact { vx: 3.0, approach: 1.0, mu: 0.23, e: 1.0, phase: 0.5 }];
    let study = studied(&log(&one, |_| 1.1, |impact, p| coulomb(impact, impact.mu * p)));
    assert_eq!((study.energy.bouncy, study.rows), (1, 1));
    let gain = kane_records::check::Check::Energy;
    assert_eq!(study.checked(gain).map(|checked| checked.failed), Some(0));
}

/// Whether gravity acts before or after the impact is the engine's: what falls within the step then stays in the
/// velocities, and is neither a slip, nor a penetration, nor another restitution.
#[test]
fn gravity_after_the_impact_is_no_fault() {
    let mut log = String::from(
        "mass,radius,inertia,mu,e,dt,gravity_x_m_s2,gravity_y_m_s2,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post\n",
    );
    let [gx, gy, dt] = [3.0, -9.5, 0.01];
    for place in 1..30 {
        let (mu, a, u) = (0.3, 1.0, 0.31 * f64::from(place));
        let e = f64::from(place % 3) * 0.45;
        let normal = (1.0 + e) * a;
        let friction = -(u / 3.0).min(mu * normal);
        let (x, y, spin) = (u + friction + gx * dt, e * a + gy * dt, 2.0 * friction);
        log.push_str(&format!("1,1,0.5,{mu},{e},{dt},{gx},{gy},{u},-{a},0,{x},{y},{spin}\n"));
    }
    let study = study(log.as_bytes(), Kind::Csv, &Options::new(laws())).expect("it is a log");
    assert!(study.as_expected(), "{:?}", study.checks);
    let named = study.consistent_laws().any(|fit| fit.law.info.id == "kane-levinson");
    assert!(named, "{:?}", study.laws.first());
    for fit in &study.fits {
        let (stated, e) =
            (fit.stated[1].expect("e is stated"), fit.restitution.expect("it bounces"));
        assert!(e.one_value && e.low <= stated && stated <= e.high, "{fit:?}");
    }
}

/// What is uncertain by gravity is uncertain of the slip before and after alike, and not of each by itself.
#[test]
fn gravity_after_the_impact_hides_no_law_of_friction() {
    let mut log = String::from(
        "mass,radius,inertia,mu,e,dt,gravity_x_m_s2,gravity_y_m_s2,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post\n",
    );
    let [gx, gy, dt] = [9.0, -9.5, 0.02];
    for place in 1..60 {
        let (mu, a, u) = (0.9, 1.0, 0.1 * f64::from(place));
        let e = f64::from(place % 3) * 0.45;
        let normal = (1.0 + e) * a;
        let friction = -(1.6 * u / 3.0).min(mu * normal);
        let (x, y, spin) = (u + friction + gx * dt, e * a + gy * dt, 2.0 * friction);
        log.push_str(&format!("1,1,0.5,{mu},{e},{dt},{gx},{gy},{u},-{a},0,{x},{y},{spin}\n"));
    }
    let best = studied(&log).friction[0].clone();
    let FrictionLaw::Walton(beta) = best.law else { panic!("{best:?}") };
    assert!((beta - 0.6).abs() < 1e-9 && best.consistent == best.rows, "{best:?}");
}

#[test]
fn beta_of_walton_is_told_by_what_every_row_allows() {
    // two impacts turn the slip back on the cone, and one comes to rest within a tolerance of 0.3 of its slip
    let mut log = String::from(
        "mass,radius,inertia,mu,e,dt,gravity_x_m_s2,gravity_y_m_s2,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post\n",
    );
    for (u, mu) in [(1.0, 0.45), (1.0, 0.4), (2.0, 9.0)] {
        let friction = -(1.5 * u / 3.0_f64).min(mu);
        let (x, spin) = (u + friction, 2.0 * friction);
        log.push_str(&format!("1,1,0.5,{mu},0,0.01,60,0,{},-1,0,{x},0,{spin}\n", u - 0.6));
    }
    let study = studied(&log);
    let walton = study.friction.iter().find(|fit| matches!(fit.law, FrictionLaw::Walton(_)));
    let walton = walton.expect("slip is turned back");
    assert_eq!(walton.consistent, walton.rows, "{walton:?}");
}

#[test]
fn laws_that_no_row_tells_apart_are_tied() {
    // wherever friction is Coulomb's it stops the slip or slides; Wang, Su and Li's fades
    let fading = |impact: &Impact, p: f64| {
        -impact.vx.signum() * impact.mu * p / (1.0 + 1.5 * impact.mu * p / impact.vx.abs())
    };
    let tied = |every: usize| {
        let rows = impacts();
        let place = |impact: &Impact| {
            let same = |other: &Impact| std::ptr::eq(other, impact);
            rows.iter().position(same).unwrap_or_default()
        };
        let friction = |impact: &Impact, p: f64| match place(impact) % every {
            0 => fading(impact, p),
            _ => coulomb(impact, impact.mu * p),
        };
        let fits = studied(&log(&rows, |impact| impact.e, friction)).friction;
        assert!(fits[0].tied && fits[0].consistent < fits[0].rows, "{:?}", fits[0]);
        let mut tied: Vec<&str> =
            fits.iter().filter(|fit| fit.tied).map(|fit| fit.law.id()).collect();
        tied.sort_unstable();
        tied.join(" ")
    };
    // 72 rows of either law, then 48 and 96
    assert_eq!(tied(2), "coulomb wang-su-li");
    assert_eq!(tied(3), "coulomb");
    // a law that gives every row is not tied with one that misses a single one
    let all =
        studied(&log(&impacts(), |impact| impact.e, |impact, p| coulomb(impact, impact.mu * p)));
    assert!(all.friction.iter().all(|fit| fit.tied == (fit.consistent == fit.rows)));
}
