//! Clean impacts of which an earlier version raised an alarm, or did not name the law: found by random logs, see
//! `scripts/adversary`.

use kane_impact::laws;
use kane_records::check::Check;
use kane_records::format::Format;
use kane_records::reader::Kind;
use kane_records::schema::{Axis, Column, Side, When};
use kane_records::study::{Options, Study, study};
use kane_records::told::Told;

fn studied(log: &str, told: Option<Told>) -> Study {
    let mut options = Options::new(laws());
    options.format = told;
    study(log.as_bytes(), Kind::Csv, &options).expect("it is a log")
}

fn gives_all(study: &Study, law: &str) -> bool {
    study.consistent_laws().any(|fit| fit.law.info.id == law && !fit.fitted)
}

/// An engine looks once a step, and the contact acted at an arm that is shorter by 8 % than the radius: W is another.
#[test]
fn a_law_is_asked_about_the_arm_at_which_the_impulse_acted() {
    let head = "mass,inertia,radius,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post,nx,ny,mu,e,dt,gx,gy";
    for (law, digits, row) in [
        (
            "tilted-2002",
            5,
            "0.76755,0.073317,0.49003,11.57,10.247,0.039445,1.9658,-2.3774,1.5783,-0.59024,-0.80723,0.219,0.019,0.004166667,0,-9.81",
        ),
        (
            "brach",
            6,
            "1.26704,1.40508,1.1918,0.0244579,4.44464,-0.274229,0.150008,-2.6879,3.39002,0.500011,-0.866019,0.554,0.617,0.004166667,0,-9.81",
        ),
    ] {
        let mut told = Told::stated(Format::Significant(digits));
        for column in [
            Column::Mass(Side::First),
            Column::Inertia(Side::First),
            Column::Radius(Side::First),
            Column::Normal(Axis::X),
            Column::Normal(Axis::Y),
        ] {
            told.own[column.index()] = Some(Format::Significant(digits).into());
        }
        let found = studied(&format!("{head}\n{row}\n"), Some(told));
        assert!(gives_all(&found, law), "{law}: {:?}", found.laws);
        // without a time step the arm is what it is
        let still = row.replace("0.004166667,0,-9.81", ",,");
        assert!(!gives_all(&studied(&format!("{head}\n{still}\n"), Some(told)), law), "{law}");
    }
}

/// The spin turns by 0.02 rad/s about the axis of the contact and by 4 rad/s about others, which is rounded as well.
#[test]
fn a_spin_beside_the_plane_is_rounded_into_the_one_within() {
    let log = "mass,inertia,radius,vx_pre,vy_pre,vx_post,vy_post,nx,ny,mu,e,vz_pre,vz_post,nz,omega_x_pre,omega_y_pre,omega_pre,omega_x_post,omega_y_post,omega_post\n\
        0.3852088962911003,0.8378988009276109,1.4526213850903584,0.251649473855713,-0.02794908976705125,-0.08246114000297322,0.05849928180029596,-0.21315623329406558,0.044770090057837324,0.151,0.345,-1.1429035410133528,0.3930123606884905,0.9759918335949841,0.8128077122517605,-0.1754834190285627,-3.90224973867048,0.8232322025598013,-0.17635212655423277,-3.8999331852686936\n";
    let mut options = Options::new(laws());
    options.extent = 0.0;
    let found = study(log.as_bytes(), Kind::Csv, &options).expect("it is a log");
    assert!(found.as_expected(), "{:?}", found.checks);
    let more = found.checked(Check::Moment).and_then(|checked| checked.worst);
    assert!(more.is_some_and(|(_, finding)| finding.residual > 7e-15), "{more:?}");
}

/// Discs of the inertia J that slide under Coulomb's friction, each number as `show` writes it.
fn discs(inertia: f64, show: impl Fn(usize, f64) -> String) -> String {
    let mut log = String::from(
        "inertia,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post,mass,radius,mu,e\n",
    );
    for i in 1..60 {
        let (x, y) = (3.0 + f64::from(i) / 3.1, -0.9 - f64::from(i) / 71.0);
        let (push, e, mu) = (-1.5 * y, 0.5, 0.05);
        let rub = -mu * push;
        let cells = [inertia, x, y, 0.0, x + rub, e * -y, rub / inertia];
        let cells: Vec<String> = cells.iter().enumerate().map(|(k, x)| show(k, *x)).collect();
        log.push_str(&format!("{},1,1,{mu},{e}\n", cells.join(",")));
    }
    log
}

#[test]
fn settings_that_were_printed_to_fifteen_decimals_are_off_by_half_of_the_last() {
    // J = 1/3000 has 12 digits in 15 decimals, and the spin goes up to 80 rad/s
    let found = studied(&discs(1.0 / 3000.0, |_, x| format!("{x:.15}")), None);
    let moment = found.checked(Check::Moment).expect("it is asked");
    assert_eq!(moment.failed, 0, "{moment:?}");
    assert_eq!(found.precision.told.format, Format::Binary64);
}

#[test]
fn a_column_in_binary32_is_told_among_decimals_of_the_same_step() {
    // the spins are small, so that their shortest decimals are nine as those of all others are
    #[allow(clippy::cast_possible_truncation, reason = "the format in question")]
    let show = |k: usize, x: f64| match k {
        0 => x.to_string(),
        6 => (x as f32).to_string(),
        _ => format!("{x:.9}"),
    };
    let found = studied(&discs(0.5, show), None);
    let spin = Column::Spin(Side::First, Axis::Z, When::Post);
    let own = found.precision.told.own[spin.index()].expect("it has its own");
    assert_eq!(own.format, Format::Binary32, "{:?}", found.precision.told.format);
    assert!(found.as_expected(), "{:?}", found.checks);
}
