//! What is no row is rejected, counted and listed; what is no log is an error.

use std::fmt::Write as _;
use std::io::Read as _;

use kane_impact::laws;
use kane_records::check::Check;
use kane_records::format::Format;
use kane_records::reader::{Kind, ReadFault};
use kane_records::study::{Options, Study, study};
use kane_records::suspicion::Suspicion;
use kane_records::told::Told;
use kane_records::untold::Untold;

const HEAD: &str = "mass,radius,inertia,mu,e,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post";
/// A disc that slides: p_n = 1.5 N·s, p_t = −0.375 N·s.
const GOOD: &str = "1,1,0.5,0.25,0.5,2,-1,0,1.625,0.5,-0.75";

fn studied(log: &str) -> Study {
    study(log.as_bytes(), Kind::Csv, &Options::new(laws())).expect("it is a log")
}

/// The same with the format of its numbers stated.
fn stated(log: &str, format: Format) -> Study {
    let mut options = Options::new(laws());
    options.format = Some(Told::stated(format));
    study(log.as_bytes(), Kind::Csv, &options).expect("the log is a log")
}

fn kinds(study: &Study) -> Vec<(String, u64)> {
    study.rejections.kinds().map(|(kind, count, _)| (kind.to_owned(), count)).collect()
}

#[test]
fn every_line_is_checked_or_listed() {
    let bad = [
        ("ragged row", "1,1,0.5"),
        ("no number in mu", "1,1,0.5,slippery,0.5,2,-1,0,1.625,0.5,-0.75"),
        ("NaN or infinity in vx1_post_m_s", "1,1,0.5,0.25,0.5,2,-1,0,NaN,0.5,-0.75"),
        ("vx1_post_m_s is too large or too small", "1,1,0.5,0.25,0.5,2,-1,0,1e101,0.5,-0.75"),
        ("mass1_kg is too large or too small", "1e-101,1,0.5,0.25,0.5,2,-1,0,1,0.5,-0.75"),
        ("NaN or infinity in vy1_post_m_s", "1,1,0.5,0.25,0.5,2,-1,0,1,inf,-0.75"),
        ("mass1_kg is not above zero", "0,1,0.5,0.25,0.5,2,-1,0,1.625,0.5,-0.75"),
        ("inertia1_kg_m2 is not above zero", "1,1,-0.5,0.25,0.5,2,-1,0,1.625,0.5,-0.75"),
        ("vy1_pre_m_s is empty", "1,1,0.5,0.25,0.5,2,,0,1.625,0.5,-0.75"),
        ("mu is negative", "1,1,0.5,-1,0.5,2,-1,0,1.625,0.5,-0.75"),
        ("stated e is not between 0 and 1", "1,1,0.5,0.25,50,2,-1,0,1.625,0.5,-0.75"),
        ("the bodies move apart before the impact", "1,1,0.5,0.25,0.5,2,1,0,1.625,0.5,-0.75"),
    ];
    let mut log = format!("# a comment\n{HEAD}\n{GOOD}\n");
    bad.iter().for_each(|(_, line)| log.push_str(&format!("{line}\n")));
    log.push_str(&format!("{GOOD}\n"));
    let study = studied(&log);
    let mut expected: Vec<(String, u64)> =
        bad.iter().map(|(kind, _)| ((*kind).to_owned(), 1)).collect();
    expected.sort();
    assert_eq!((study.rows, kinds(&study)), (2, expected));
    // the third line of the file is the first row, as an editor counts
    let (_, _, first) = study.rejections.kinds().next().expect("there are some");
    assert!((4..=13).contains(&first[0].line), "{first:?}");
    assert!(!study.as_expected());
}

#[test]
fn a_normal_that_is_not_of_unit_length_is_rejected() {
    let study = studied(&format!("{HEAD},nx,ny\n{GOOD},0,1\n{GOOD},0,2\n{GOOD},0,1.0000001\n"));
    assert_eq!(kinds(&study), [("the normal is not of unit length".to_owned(), 1)]);
    assert_eq!(study.rows, 2);
}

#[test]
fn an_obstacle_that_moves_needs_a_mass() {
    let head = format!("{HEAD},vx2_pre,vy2_pre,omega2_pre,vx2_post,vy2_post,omega2_post");
    let study = studied(&format!("{head}\n{GOOD},0,0,0,0,0,0\n{GOOD},,,,,,\n{GOOD},0,1,0,0,1,0\n"));
    assert_eq!((study.rows, kinds(&study)), (2, vec![("mass2_kg is empty".to_owned(), 1)]));
}

#[test]
fn what_is_no_log_is_an_error() {
    let fault = |log: &str, kind| study(log.as_bytes(), kind, &Options::new(laws()));
    assert!(matches!(fault("", Kind::JsonLines), Err(ReadFault::Empty)));
    assert!(fault("", Kind::Csv).is_err());
    let said = |log: &str| fault(log, Kind::Csv).expect_err("it is none").to_string();
    assert!(said("a,b\n1,2\n").contains("columns are missing: mass1_kg"));
    assert!(said(&HEAD.replace("omega_pre", "omega_pre_deg_s")).contains("is in deg_s"));
    assert!(said(&format!("{HEAD},vx_before")).contains("both mean vx1_pre_m_s"));
    assert!(matches!(fault("[1]", Kind::JsonLines), Err(ReadFault::FirstLine(1, _))));
}

#[test]
fn json_lines_are_the_same_log() {
    let names: Vec<&str> = HEAD.split(',').collect();
    let cells: Vec<String> = names
        .iter()
        .zip(GOOD.split(','))
        .map(|(name, cell)| format!("\"{name}\":{cell}"))
        .collect();
    let line = format!("{{{}}}", cells.join(","));
    let arrays = "{\"mass\":1,\"radius\":1,\"inertia\":0.5,\"mu\":0.25,\"e\":0.5,\"v_pre\":[2,-1],\"omega_pre\":0,\"v_post\":[1.625,0.5],\"omega_post\":-0.75}";
    for log in [format!("{line}\n\n{line}\nnull\n"), format!("{arrays}\n{arrays}\n{{\"a\":1}}\n")] {
        let study = study(log.as_bytes(), Kind::JsonLines, &Options::new(laws()));
        let study = study.expect("it is a log");
        assert_eq!((study.rows, study.rejections.total()), (2, 1));
        assert!(study.checks.iter().all(|checked| checked.failed == 0), "{:?}", study.checks);
    }
}

/// Rows of discs that slide, from the equations alone.
fn discs(change: impl Fn(&mut [f64; 11])) -> String {
    let mut log = format!("{HEAD}\n");
    for i in 0..12 {
        let (vx, mu, e) = (2.0 + f64::from(i) / 7.0, 0.1 + f64::from(i) / 91.0, 0.7);
        let p = [-mu * 1.7, 1.7];
        let mut row =
            [1.0, 1.0, 0.5, mu, e, vx, -1.0, 0.3, vx + p[0], -1.0 + p[1], 0.3 + p[0] / 0.5];
        change(&mut row);
        let cells: Vec<String> = row.iter().map(f64::to_string).collect();
        let _ = writeln!(log, "{}", cells.join(","));
    }
    log
}

#[test]
fn wrong_units_and_axes_are_suspected() {
    assert_eq!(studied(&discs(|_| {})).suspicions, []);
    let degrees = studied(&discs(|row| [7, 10].iter().for_each(|&i| row[i] *= 57.29577951308232)));
    assert_eq!(degrees.suspicions, [Suspicion::Degrees]);
    let clockwise = studied(&discs(|row| [7, 10].iter().for_each(|&i| row[i] *= -1.0)));
    assert_eq!(clockwise.suspicions, [Suspicion::Turned]);
    let down = studied(&discs(|row| [6, 9].iter().for_each(|&i| row[i] *= -1.0)));
    assert_eq!(down.suspicions, [Suspicion::Down]);
    let lever = studied(&discs(|row| row[2] *= 1.02));
    assert!(
        matches!(lever.suspicions[..], [Suspicion::Lever(ratio)] if (ratio - 1.02).abs() < 1e-9)
    );
}

/// The same impact seen in space: the plane turned about the normal by an angle of 3:4:5, and the
/// normal along z.
fn spatial(after: [f64; 3], spin: [f64; 3]) -> String {
    let names = "m,radius,inertia,mu,e,nx,ny,nz,vx_pre,vy_pre,vz_pre,wx_pre,wy_pre,wz_pre,vx_post,vy_post,vz_post,wx_post,wy_post,wz_post";
    let [x, y, z] = after;
    let [a, b, c] = spin;
    format!("{names}\n1,1,0.5,0.25,0.5,0,0,1,1.2,1.6,-1,0,0,0,{x},{y},{z},{a},{b},{c}\n")
}

#[test]
fn a_row_in_space_is_taken_where_friction_stays_in_a_plane() {
    // slip 2 along (3/5, 4/5, 0); p_t = −0.375; the spin is about (−4/5, 3/5, 0)
    let spin = [-0.8 * 0.75, 0.6 * 0.75, 0.0];
    let study = studied(&spatial([0.975, 1.3, 0.5], spin));
    assert_eq!(study.rejections.total(), 0, "{:?}", kinds(&study));
    assert!(study.checks.iter().all(|checked| checked.failed == 0), "{:?}", study.checks);
    assert!(study.consistent_laws().any(|fit| fit.law.info.id == "kane-levinson"));

    for (after, spin, why) in [
        ([1.2, 1.225, 0.5], spin, "leaves the plane"),
        ([0.975, 1.3, 0.5], [spin[0], spin[1], 0.4], "leaves the plane"),
    ] {
        let study = studied(&spatial(after, spin));
        assert_eq!((study.rows, study.rejections.of_kind(why)), (0, 1), "{:?}", kinds(&study));
    }
}

#[test]
fn two_bodies_must_push_each_other_alike() {
    let head = "m1,m2,r1,r2,j1,j2,nx,ny,mu,e,vx1_pre,vy1_pre,omega1_pre,vx2_pre,vy2_pre,omega2_pre,vx1_post,vy1_post,omega1_post,vx2_post,vy2_post,omega2_post";
    // equal discs without friction exchange their normal velocities at e = 1; the normal is x
    let row = |second: f64| {
        format!("{head}\n1,1,1,1,0.5,0.5,1,0,0,1,-2,0.25,0,1,0,0,1,0.25,0,{second},0,0\n")
    };
    let good = studied(&row(-2.0));
    assert!(good.as_expected(), "{:?}", good.checks);
    assert_eq!(good.checked(Check::Reaction).map(|checked| checked.rows), Some(1));
    let bad = stated(&row(-1.9), Format::Binary64);
    assert_eq!(bad.checked(Check::Reaction).map(|checked| checked.failed), Some(1));
}

/// How a check fared: rows that fail, and rows that are undecided.
fn fared(study: &Study, check: Check) -> (u64, u64) {
    study.checked(check).map_or((0, 0), |checked| (checked.failed, checked.undecided))
}

#[test]
fn a_short_number_does_not_excuse_a_row() {
    // e is off by 1e-6, and the number that tells of it has six decimals as if it were rounded
    let off = GOOD.replace("0.5,-0.75", "0.500001,-0.75");
    let log = format!("{HEAD}\n{GOOD}\n{off}\n{GOOD}\n");
    let study = studied(&log);
    assert_eq!(fared(&study, Check::Restitution), (0, 1));
    assert!(
        !study.as_expected()
            && study.untold.contains(&Untold::Format(Told {
                or: Some(Format::Binary64),
                decimals: Some(6),
                ..Told::stated(Format::Significant(6))
            }))
    );
    assert_eq!(fared(&stated(&log, Format::Binary64), Check::Restitution), (1, 0));
    assert!(stated(&log, Format::Decimals(6)).as_expected());
    // one number with all its digits tells the format of all
    let study =
        studied(&format!("{log}{}\n", GOOD.replace("2,-1,0,1.625", "2.1,-1,0,1.7250000000000003")));
    assert_eq!(fared(&study, Check::Restitution), (1, 0));
    // and a miss that no rounding makes is a failure in any format
    let study = studied(&log.replace("0.500001", "0.530001"));
    assert_eq!(fared(&study, Check::Restitution), (1, 0));
}

#[test]
fn rounded_decimals_raise_no_alarm() {
    for decimals in 2..=9 {
        for rows in [1, 2, 3, 12] {
            let text = discs(|row| {
                let rounded = |x: f64| format!("{x:.decimals$}").parse().expect("a float");
                (5..11).for_each(|i| row[i] = rounded(row[i]));
            });
            let log: Vec<&str> = text.lines().take(rows + 1).collect();
            let study = studied(&log.join("\n"));
            for checked in &study.checks {
                assert_eq!(checked.failed, 0, "{decimals} {rows} {checked:?}");
            }
            // the numbers of twelve impacts are enough to tell
            let doubt = study.precision.told.or.is_some();
            assert!(doubt || study.as_expected(), "{decimals} {rows} {:?}", study.checks);
            assert!(!doubt || rows < 12 || decimals < 4, "{decimals}");
            let stated =
                stated(&log.join("\n"), Format::Decimals(u8::try_from(decimals).expect("few")));
            assert!(stated.as_expected(), "{decimals} {rows} {:?}", stated.checks);
        }
    }
}

#[test]
fn each_column_is_judged_by_its_own_digits() {
    let rounded = |places: [usize; 3], digits: bool| {
        discs(|row| {
            for i in 5..11 {
                let n = places[(i - 5) % 3];
                let text = if digits {
                    format!("{:.*e}", n - 1, row[i])
                } else {
                    format!("{:.*}", n, row[i])
                };
                row[i] = text.parse().expect("a float");
            }
        })
    };
    // v_x, v_y and omega, as decimals and as digits
    for places in [[6, 6, 3], [3, 7, 7], [7, 3, 5]] {
        for digits in [false, true] {
            let log = rounded(places, digits);
            let study = studied(&log);
            assert!(study.checks.iter().all(|checked| checked.failed == 0), "{:?}", study.checks);
        }
    }
    // a spin that is off by more than its own three decimals is found
    let mut lines: Vec<String> = rounded([6, 6, 3], false).lines().map(str::to_owned).collect();
    let last = lines.pop().expect("it has rows");
    let (rest, spin) = last.rsplit_once(',').expect("it has cells");
    let spin: f64 = spin.parse().expect("a float");
    lines.push(format!("{rest},{}", spin + 0.02));
    let study = studied(&lines.join("\n"));
    assert_eq!(study.checked(Check::Moment).map(|checked| checked.failed), Some(1));
}

#[test]
fn a_quote_that_nothing_closes_is_an_error() {
    let fault = |log: &str| {
        let told = study(log.as_bytes(), Kind::Csv, &Options::new(laws()));
        told.expect_err("a cell holds the rest").to_string()
    };
    let head = format!("{HEAD},id,note");
    let log = format!("{head}\n{GOOD},a,b\n{GOOD},\"c,d\n{GOOD},e,f\n");
    assert_eq!(fault(&log), "cannot read: line 3: a quote opens that nothing closes");
    // another stray quote closes it, and both rows would be one
    let log = format!("{head}\n{GOOD},\"a,b\n{GOOD},\"c,d\n");
    assert!(
        fault(&log).contains("line 2: a quote opens, and the cell goes on behind"),
        "{}",
        fault(&log)
    );
    // a line end within quotes is a part of a cell, as ever
    let study = studied(&format!("{head}\n{GOOD},a,\"two\nlines\"\n{GOOD},b,\n"));
    assert_eq!((study.rows, study.rejections.total()), (2, 0));
}

#[test]
fn a_line_is_counted_as_an_editor_counts_however_lines_end() {
    let head = format!("# of an engine\n\n{HEAD},id,pair");
    let bad = GOOD.replacen('1', "one", 1);
    let text = format!(
        "{head}\n{bad},a,\n# a comment\n\n{bad},b,\n{GOOD},c,\"two\nlines\"\n{bad},d,\"two\nlines\""
    );
    for end in ["\n", "\r\n", "\r"] {
        let study = studied(&text.replace('\n', end));
        let lines: Vec<u64> = study
            .rejections
            .kinds()
            .flat_map(|(_, _, listed)| listed.iter().map(|r| r.line))
            .collect();
        assert_eq!(lines, [4, 7, 10], "{end:?}");
    }
}

#[test]
fn a_line_without_an_end_is_not_held() {
    let endless = |start: &str, kind| {
        let start = std::io::Cursor::new(start.as_bytes().to_vec());
        let log = std::io::BufReader::new(start.chain(std::io::repeat(b'1')));
        let told = study(log, kind, &Options::new(laws()));
        told.expect_err("there is no end").to_string()
    };
    assert!(
        endless(&format!("{HEAD}\n{GOOD}\n"), Kind::Csv).contains("line 3 has no end in 16 MiB")
    );
    assert!(endless(&format!("{HEAD}\n\""), Kind::Csv).contains("line 2: a quote opens"));
    assert!(endless("{\"mass\":", Kind::JsonLines).contains("line 1 has no end in 16 MiB"));
}

#[test]
fn gravity_within_the_step_is_taken_off() {
    // v⁺ = v + g·dt + p, with the rebound of the velocity after gravity has acted
    let head = format!("{HEAD},gravity_x_m_s2,gravity_y_m_s2,dt_s");
    let (g, dt) = (-9.81, 1.0 / 64.0);
    let before = -1.0 + g * dt;
    let (mu, e) = (0.25, 0.5);
    let p = -(1.0 + e) * before;
    let row = format!(
        "1,1,0.5,{mu},{e},2,-1,0,{},{},{},0,{g},{dt}",
        2.0 - mu * p,
        before + p,
        -mu * p / 0.5
    );
    let study = studied(&format!("{head}\n{row}\n"));
    assert!(study.as_expected(), "{:?}", study.checks);
    let without = studied(&format!("{head}\n{}\n", row.replace(",-9.81,", ",0,")));
    assert!(without.checked(Check::Cone).is_some_and(|checked| checked.rows == 1));
    assert!(!without.as_expected(), "the step is seen where gravity is not stated");
}

#[test]
fn a_verdict_at_its_tolerance_is_exact() {
    // binary64, one row, e off by a little less and a little more than the tolerance that is reported
    let off = |miss: f64| {
        let row = format!("1,1,0.5,0.25,0.5,2,-1,0,1.625,{:e},-0.75", 0.5 + miss);
        let mut options = Options::new(laws());
        options.extent = 0.0;
        // a miss of 1e-9 alone might be one of nine decimals
        options.format = Some(Told::stated(Format::Binary64));
        let log = format!("{HEAD}\n{row}\n");
        let study = study(log.as_bytes(), Kind::Csv, &options).expect("it is a log");
        let checked = study.checked(Check::Restitution).expect("it is asked").clone();
        let (_, finding) = checked.worst.expect("there is a row");
        (checked.failed, checked.near, finding)
    };
    let (_, _, finding) = off(1e-9);
    let tolerance = finding.tolerance;
    assert!(tolerance > 0.0 && tolerance < 1e-12);
    let unit = f64::EPSILON / 4.0;
    let steps = (tolerance / unit).floor();
    let (inside, outside) = (off(unit * (steps - 4.0)), off(unit * (steps + 8.0)));
    assert_eq!((inside.0, inside.1), (0, 1), "{:?}", inside.2);
    assert_eq!((outside.0, outside.1), (1, 1), "{:?}", outside.2);
}

#[test]
fn rounding_along_a_normal_that_leans_is_no_moment() {
    let mut log = "mass1_kg,inertia1_kg_m2,radius1_m,normal_x,normal_y,vx1_pre_m_s,vy1_pre_m_s,\
                   omega1_pre_rad_s,vx1_post_m_s,vy1_post_m_s,omega1_post_rad_s\n"
        .to_owned();
    // straight impacts on planes that lean by all sorts of angles, without a spin
    for i in 1..60 {
        let (x, y) = (0.1 * f64::from(i)).sin_cos();
        let [before, after] = [-5.3, 3.1].map(|speed: f64| [speed * x, speed * y]);
        let [[a, b], [c, d]] = [before, after];
        log += &format!("1.7,0.41,0.9,{x},{y},{a},{b},0,{c},{d},0\n");
    }
    let study = studied(&log);
    assert!(study.as_expected() && study.rows == 59, "{:?}", study.checks);
}
