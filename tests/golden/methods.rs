//! The committed table of errors and counted costs. Times are in no table that is compared.

use kane::figures::timed;
use kane::measure::chart::table;
use kane::number::System;
use kane::report::Page;
use kane::report::chart::{ChartReport, committed, csv, json, sheet, speed_accuracy};

use crate::assert_kept;

#[test]
fn the_committed_methods_are_the_program_s() {
    assert_kept("docs/data/methods.csv", &committed(&table()));
}

/// The times are kept, so that the figure is the same in every run, on whatever machine.
#[test]
fn the_figure_of_speed_and_accuracy_is_that_of_the_kept_times() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/data/times.csv");
    let kept = timed(table(), &std::fs::read_to_string(path).expect("they are kept"));
    let without = kept.methods.iter().filter(|one| one.time.is_none()).count();
    assert_eq!(without, 0, "every method has a time; take them anew with --times");
    let report = ChartReport {
        all: &kept.methods,
        machine: kept.machine.clone(),
        command: "kane chart".to_owned(),
    };
    let drawn = speed_accuracy(&report);
    assert_kept("docs/figures/speed-accuracy.svg", &drawn);
    // a method that is slower is elsewhere
    let mut slower = kept.methods.clone();
    for one in &mut slower {
        if let Some(time) = one.time.as_mut().filter(|_| one.method.name == "(16)") {
            time.median *= 10;
        }
    }
    assert_ne!(speed_accuracy(&ChartReport { all: &slower, ..report }), drawn);
}

/// What Gappa proves of all inputs holds of those that were measured, and each has the other beside it.
#[test]
fn no_measured_error_is_above_its_proved_bound() {
    let all = table();
    let float = |system| matches!(system, System::F32 | System::F64);
    let (mut bounded, mut without) = (0, Vec::new());
    for one in all.iter().filter(|one| float(one.method.system)) {
        let name = format!("{} {} {}", one.method.quantity, one.method.name, one.method.system);
        let Some(proved) = &one.proved else {
            if one.method.law == "wang-su-li" {
                without.push(name);
            }
            continue;
        };
        let ulps: f64 = kane::number::encode(&proved.ulps, kane::number::Rounding::NearestEven);
        // a measured error is given in whole hundredths of its logarithm, so half of one may be lost or gained
        let measured = proved.measured.expect("floats are measured in ulps") as f64;
        assert!(measured - 0.5 <= 100.0 * ulps.log2(), "{name}: 2^({measured}/100) > {ulps}");
        // and no bound is so wide that it says nothing
        assert!(measured + 150.0 >= 100.0 * ulps.log2(), "{name}: 2^({measured}/100) and {ulps}");
        bounded += 1;
    }
    assert_eq!(bounded, 14, "seven methods in two formats");
    assert!(without.iter().any(|name| name == "i_x (9) f64"), "{without:?}");

    let report = ChartReport { all: &all, machine: String::new(), command: String::new() };
    let shown = sheet(&report).text(Page::default());
    assert!(shown.contains("65/128") && shown.contains("none"), "{shown}");
    assert!(shown.contains("† proved to alpha = 2^24 only"), "{shown}");
    assert!(
        sheet(&report).markdown().contains("| 65/128 |") && csv(&report).contains(",65/128,2^30,")
    );
    let value: serde_json::Value = serde_json::from_str(&json(&report)).expect("it is JSON");
    let methods = value["methods"].as_array().expect("a list");
    let proved = methods.iter().filter(|method| method["proved"]["ulps"].is_string());
    assert_eq!(proved.count(), bounded);
}
