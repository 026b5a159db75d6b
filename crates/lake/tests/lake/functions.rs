//! The functions of a query give what `kane_records` gives of the same row.

use datafusion::prelude::SessionContext;
use kane_lake::{Asked, Numbers, Quantity, register};
use kane_records::case::Case;
use kane_records::check::Check;
use kane_records::header::Header;
use kane_records::reader::{Kind, Pairs, Sink, read};
use kane_records::rejection::Rejected;
use kane_records::row::Row;
use kane_records::told::Told;

use crate::{column, opened, recorded, session};

const LOG: &str = "rapier2d-0.36.1_tight";

/// The rows of a log.
struct Rows(Vec<Row>);

impl Sink for Rows {
    fn header(&mut self, _: &Header, _: &Pairs) {}

    fn row(&mut self, row: &Row) {
        self.0.push(row.clone());
    }

    fn reject(&mut self, rejected: Rejected) {
        unreachable!("{rejected:?}");
    }

    fn end(&mut self, _: &Pairs) {}
}

fn rows() -> Vec<Row> {
    let text = std::fs::read(recorded(LOG)).expect("it is there");
    let mut rows = Rows(Vec::new());
    read(text.as_slice(), Kind::Csv, &[], &mut rows).expect("it is a log");
    rows.0
}

/// What the room of records says of a row, as text.
fn expected(asked: Asked, case: &Case<'_>) -> String {
    let finding = |check: Check| case.finding(check);
    match asked {
        Asked::Quantity(quantity) => quantity.of(case).map_or(String::new(), |x| format!("{x:?}")),
        Asked::Residual(check) => {
            finding(check).map_or(String::new(), |found| format!("{:?}", found.residual))
        }
        Asked::Holds(check) => finding(check)
            .and_then(|found| found.holds())
            .map_or(String::new(), |holds| holds.to_string()),
        Asked::Fails => {
            let fails =
                |check: &Check| finding(*check).is_some_and(|found| found.holds() == Some(false));
            let names: Vec<_> = Check::ALL.into_iter().filter(fails).map(Check::id).collect();
            names.join(" ")
        }
        Asked::Rejected => String::new(),
    }
}

#[tokio::test]
async fn every_function_of_a_row_is_that_of_the_room_of_records() {
    let (session, _) = opened(&recorded(LOG), 1).await;
    let rows = rows();
    let precision = Numbers::new(Told::of(&rows)).precision();
    for asked in Asked::all() {
        let told = column(&session, &format!("SELECT {}() FROM log", asked.function())).await;
        assert_eq!(told.len(), rows.len());
        for (row, told) in rows.iter().zip(&told) {
            let case = Case::of(row, false, &precision).expect("it is a row");
            let expected = expected(asked, &case);
            let same = match (told.parse::<f64>(), expected.parse::<f64>()) {
                (Ok(a), Ok(b)) => a == b,
                _ => *told == expected,
            };
            assert!(same, "{asked:?} of line {}: {told} and {expected}", row.line);
        }
    }
}

#[tokio::test]
async fn quantities_are_those_of_the_log_itself() {
    // a disc: W_tt = 3, p_n = m·(1 + e)·a, u_t = v + ω·r, ΔT by energies before and after
    let (session, _) = opened(&recorded(LOG), 2).await;
    for (ours, theirs) in [
        (Quantity::NormalImpulse, "vy_post - vy_pre"),
        (Quantity::TangentialImpulse, "vx_post - vx_pre"),
        (Quantity::SlipBefore, "vx_pre + omega_pre"),
        (Quantity::SlipAfter, "vx_post + omega_post"),
        (Quantity::Restitution, "-vy_post / vy_pre"),
        (Quantity::Ratio, "(vx_post + omega_post) / (vx_pre + omega_pre)"),
        (Quantity::Alpha, "1.5 * mu * (vy_post - vy_pre) / abs(vx_pre + omega_pre)"),
        (Quantity::ConeExcess, "abs(vx_post - vx_pre) - mu * (vy_post - vy_pre)"),
        (
            Quantity::EnergyGain,
            "(vx_post * vx_post + vy_post * vy_post + inertia * omega_post * omega_post \
              - vx_pre * vx_pre - vy_pre * vy_pre - inertia * omega_pre * omega_pre) / 2",
        ),
    ] {
        let query = format!("SELECT max(abs({}() - ({theirs}))) FROM log", ours.function());
        let most: f64 = column(&session, &query).await[0].parse().expect("a float");
        assert!(most < 1e-12, "{ours:?}: {most}");
    }
}

#[tokio::test]
async fn a_query_groups_and_filters_by_the_functions() {
    let (session, _) = opened(&recorded(LOG), 3).await;
    let rows = rows();
    let query = "SELECT count(*) FROM log WHERE NOT kane_holds_sticks()";
    let slid: usize = column(&session, query).await[0].parse().expect("a count");
    assert!(slid > 0 && slid < rows.len());
    let query = "SELECT count(*) FROM log GROUP BY kane_fails() ORDER BY kane_fails()";
    let counts = column(&session, query).await;
    assert_eq!(counts, [(rows.len() - slid).to_string(), slid.to_string()]);
    let query = "SELECT kane_sentence() FROM log GROUP BY restitution ORDER BY restitution";
    let sentences = column(&session, query).await;
    assert_eq!(sentences.len(), 3);
    // at e = 0 the bound of the compression is Coulomb's
    assert!(sentences[0].contains("Coulomb's, which stops the slip"), "{sentences:?}");
    assert!(sentences[2].contains("below the cone") && !sentences[0].contains("below the cone"));
    let query = "SELECT kane_report() FROM log";
    let report: serde_json::Value =
        serde_json::from_str(&column(&session, query).await[0]).expect("it is JSON");
    assert_eq!(report["rows"], rows.len());
}

/// Impacts of a sphere whose columns have other names and one of which cannot be checked.
const TABLE: &str = "CREATE TABLE impacts AS SELECT * FROM (VALUES \
    ('ice', 1.0, 0.4, 2.0, -1.0, 0.0, 1.625, 0.5, -0.9375), \
    ('ice', 0.0, 0.4, 2.0, -1.0, 0.0, 1.625, 0.5, -0.9375), \
    ('steel', 1.0, 0.4, 2.0, -1.0, 0.0, 3.625, 0.5, -0.9375)) \
    AS t(material, mass, inertia, speed_in, vy_pre, omega_pre, vx_post, vy_post, omega_post)";

async fn made() -> SessionContext {
    let session = session(1);
    register(&session).expect("it takes functions");
    session.sql(TABLE).await.expect("a table").collect().await.expect("it is made");
    session
}

#[tokio::test]
async fn a_struct_names_columns_that_are_called_otherwise() {
    let session = made().await;
    let of = |function: &str| {
        format!(
            "SELECT {function}(named_struct('mass', mass, 'inertia', inertia, 'arm_x', 0.0, 'arm_y', -1.0, \
             'vx_pre', speed_in, 'vy_pre', vy_pre, 'omega_pre', omega_pre, 'vx_post', vx_post, \
             'vy_post', vy_post, 'omega_post', omega_post), 'f64') FROM impacts"
        )
    };
    let gains = column(&session, &of("kane_energy_gain")).await;
    assert_eq!(gains[1], "", "a body without mass has none");
    let gains: Vec<f64> =
        [&gains[0], &gains[2]].map(|gain| gain.parse().expect("a float")).to_vec();
    assert!(gains[0] < 0.0 && gains[1] > 0.0, "{gains:?}");
    let reasons = column(&session, &of("kane_rejected")).await;
    assert_eq!(reasons, ["", "mass1_kg is not above zero: 0", ""]);
    // the format of numbers is a text that is known
    let wrong = of("kane_energy_gain").replace("'f64'", "'f65'");
    let told = session.sql(&wrong).await.expect("it is a query").collect().await;
    assert!(told.expect_err("it is no format").to_string().contains("is no format of numbers"));
}

#[tokio::test]
async fn a_table_without_the_columns_is_an_error_that_names_them() {
    let session = made().await;
    let frame = session.sql("SELECT kane_energy_gain() FROM impacts").await;
    let told = match frame {
        Ok(frame) => frame.collect().await.expect_err("columns are missing").to_string(),
        Err(error) => error.to_string(),
    };
    assert!(told.contains("columns are missing: vx1_pre_m_s"), "{told}");
}

#[tokio::test]
async fn columns_of_binary32_are_judged_as_such() {
    let session = made().await;
    let table = "CREATE TABLE single AS SELECT mass, inertia, 0.0 AS arm_x, -1.0 AS arm_y, \
        speed_in AS vx_pre, vy_pre, omega_pre, CAST(vx_post * 1.000001 AS FLOAT) AS vx_post, \
        CAST(vy_post AS FLOAT) AS vy_post, CAST(omega_post AS FLOAT) AS omega_post FROM impacts \
        WHERE material = 'ice' AND mass > 0";
    session.sql(table).await.expect("a table").collect().await.expect("it is made");
    assert_eq!(column(&session, "SELECT kane_holds_moment() FROM single").await, ["true"]);
    let wide = "SELECT kane_holds_moment() FROM (SELECT mass, inertia, arm_x, arm_y, vx_pre, vy_pre, \
        omega_pre, CAST(vx_post AS DOUBLE) AS vx_post, CAST(vy_post AS DOUBLE) AS vy_post, \
        CAST(omega_post AS DOUBLE) AS omega_post FROM single)";
    assert_eq!(column(&session, wide).await, ["false"]);
}
