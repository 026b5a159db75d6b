use std::collections::BTreeSet;

use kane_records::check::Verdict;

use super::super::made_up::{law_fit, of_a_log};
use super::*;

fn checked(rows: u64, failed: u64, undecided: u64, excused: Option<&'static str>) -> Checked {
    let finding = Finding { residual: 0.25, scale: 1.0, tolerance: 0.125, verdict: Verdict::Fails };
    let worst = Some((3, finding));
    Checked { rows, failed, undecided, excused, worst, ..Checked::none(Check::Reaction) }
}

#[test]
fn a_check_holds_or_fails_or_is_undecided_or_was_not_asked() {
    let of = |rows, failed, undecided, law| verdict(&checked(rows, failed, undecided, law));
    assert_eq!(of(0, 0, 0, None), "not asked");
    assert_eq!(of(5, 0, 0, None), "holds");
    assert_eq!(of(5, 0, 2, None), "undecided in 2");
    assert_eq!(of(5, 1, 0, None), "FAILS in 1");
    assert_eq!(of(5, 1, 2, None), "FAILS in 1, undecided in 2");
    assert_eq!(of(5, 1, 2, Some("routh")), "fails in 1, as routh has it");
    let said = |failed, undecided| told(&checked(5, failed, undecided, None)).1;
    assert_eq!(said(0, 0), "holds in 5 rows");
    let worst = format!(", the worst 0.25 of 0.125 {}", Check::Reaction.unit());
    assert_eq!(said(2, 0), format!("FAILS in 2 of 5 rows{worst}"));
    assert_eq!(said(0, 2), format!("undecided in 2 of 5 rows{worst}"));
    assert_eq!(said(1, 1), format!("FAILS in 1, undecided in 1 of 5 rows{worst}"));
}

#[test]
fn each_check_asks_something_else() {
    let all = [
        Check::Reaction,
        Check::Moment,
        Check::Pull,
        Check::Penetration,
        Check::Cone,
        Check::Opposes,
        Check::Sticks,
        Check::Energy,
        Check::Restitution,
        Check::Order,
    ];
    for words in [all.map(asks), all.map(asks_briefly)] {
        assert!(words.iter().all(|words| words.len() > 5), "{words:?}");
        assert_eq!(words.iter().collect::<BTreeSet<_>>().len(), all.len());
    }
}

#[test]
fn an_interval_says_whether_it_has_an_end_and_is_one_value() {
    let of = |low, high, one_value| interval(&Fitted { low, high, rows: 1, one_value });
    assert_eq!(of(0.25, f64::INFINITY, true), "at least 0.25");
    assert_eq!(of(f64::NEG_INFINITY, f64::INFINITY, true), "any value");
    assert_eq!(of(0.25, 0.25, true), "0.25");
    assert_eq!(of(0.25, 0.5, true), "0.25 to 0.5");
    assert_eq!(of(0.25, 0.5, false), "0.25 to 0.5, not one value");
}

#[test]
fn floats_are_told_in_few_digits() {
    let told = [0.0, 0.5, -0.25, 1.0, 0.123_456, 99_999.5, 1e5, 0.001, 0.000_94, -2e-7].map(brief);
    let wanted =
        ["0", "0.5", "-0.25", "1", "0.1235", "99999.5", "1.0e5", "0.001", "9.4e-4", "-2.0e-7"];
    assert_eq!(told, wanted);
}

#[test]
fn each_law_of_friction_has_words_and_a_name_of_its_own() {
    use FrictionLaw::{Compression, Coulomb, None, Share, Smith, Uncapped, Walton, WangSuLi};
    let all = [None, Coulomb, Compression, Share(0.75), Walton(0.5), Smith, WangSuLi, Uncapped];
    for words in [all.map(friction), all.map(friction_name)] {
        assert!(words.iter().all(|words| words.len() >= 4), "{words:?}");
        assert_eq!(words.iter().collect::<BTreeSet<_>>().len(), all.len());
    }
    assert!(friction(Share(0.75)).contains("0.75*mu*p_n"));
    assert!(friction(Walton(0.5)).ends_with("beta0 = 0.5"));
    assert_eq!([0, 7].map(at_line), [String::new(), " (line 7)".to_owned()]);
    assert_eq!([0, 7].map(before), [String::new(), "line 7: ".to_owned()]);
}

#[test]
fn a_suspicion_says_by_how_much_and_what_to_do() {
    assert_eq!(
        suspicion(&Suspicion::Degrees),
        "spins look like degrees a second: J*dw is 57.3 times r x p; convert them to rad/s"
    );
    assert_eq!(
        suspicion(&Suspicion::Revolutions),
        "spins look like revolutions a minute: J*dw is 9.55 times r x p; convert them to rad/s"
    );
    assert!(suspicion(&Suspicion::Turned).starts_with("spins count the other way"));
    assert_eq!(
        suspicion(&Suspicion::Lever(2.5)),
        "J*dw is 2.5 times r x p in most rows: an arm, a radius, a mass or an inertia is off by that much"
    );
    assert!(suspicion(&Suspicion::Down).starts_with("most bodies move apart before they collide"));
}

#[test]
fn a_pair_is_called_by_its_materials_and_what_is_stated_of_it() {
    let study = Study { pairs: vec!["steel on ice".to_owned()], ..of_a_log() };
    let of = |of_pair, stated| {
        let fit = PairFit { pair: of_pair, stated, ..study.fits[0] };
        pair(&fit, &study)
    };
    assert_eq!(of(0, [Some(0.25), Some(0.5)]), "steel on ice, mu = 0.25, e = 0.5");
    assert_eq!(of(0, [None, Some(0.5)]), "steel on ice, e = 0.5");
    // the log has one pair
    assert_eq!(of(1, [Some(0.25), None]), "mu = 0.25");
    assert_eq!(of(1, [None, None]), "nothing stated");
}

#[test]
fn a_law_is_told_with_what_was_fitted_of_it_alone() {
    let of = |id: &str, fitted| {
        super::law(&law_fit(kane_impact::law(id).expect("it is known"), fitted, 10))
    };
    assert_eq!([of("routh-newton", true), of("walton", false)], ["routh-newton", "walton"]);
    let fitted = of("walton", true);
    assert!(fitted.starts_with("walton, beta0 = "), "{fitted}");
}

#[test]
fn what_a_log_leaves_open_is_told_with_what_it_is_about() {
    let same = |factor| {
        let open = Untold::Same(factor);
        format!("{}: {}", untold_label(&open), untold(&open))
    };
    let seen = "cannot be seen";
    assert_eq!(
        same(Factor::Speed),
        format!("speed: all impacts have one approach speed: a threshold of speed {seen}")
    );
    let on = format!("what depends on it {seen}");
    assert_eq!(same(Factor::Slip), format!("slip: all impacts have one slip: {on}"));
    let differ = "no two impacts differ in";
    assert_eq!(same(Factor::Stated), format!("e: {differ} the stated e: {on}"));
    let phase = "their phase within the step";
    assert_eq!(same(Factor::Phase), format!("phase: {differ} {phase}: {on}"));
    assert_eq!(same(Factor::Step), format!("time step: {differ} their time step: {on}"));
    let constant = Untold::ConstantRestitution(0.2);
    assert_eq!(untold_label(&constant), "mu");
    assert!(untold(&constant).ends_with("another friction coefficient, mu = 0.2"));
    assert_eq!(untold_label(&Untold::NothingSlides), "mu");
    assert_eq!(untold(&Untold::NothingSlides), "no impact slides on: mu has a lower bound alone");
    assert_eq!(untold_label(&Untold::NothingSticks), "slip");
    assert!(untold(&Untold::NothingSticks).starts_with("every impact slides on: "));
    let laws = Untold::SameFriction(vec![FrictionLaw::Smith, FrictionLaw::Walton(0.25)]);
    assert_eq!(untold_label(&laws), "friction");
    assert_eq!(untold(&laws), "these give the same impulses here: Smith; Walton, beta0 = 0.25");
    assert_eq!(untold_label(&Untold::Round), "laws");
    assert!(untold(&Untold::Round).starts_with("no row couples normal and tangent"));
    assert_eq!(untold_label(&Untold::NoCoefficients), "mu and e");
    assert!(untold(&Untold::NoCoefficients).starts_with("mu or e is not stated"));
    let mut told = of_a_log().precision.told;
    (told.format, told.or) = (Format::Decimals(3), Some(Format::Binary32));
    let open = Untold::Format(told);
    assert_eq!(untold_label(&open), "numbers");
    let expected = format!(
        "the numbers may have been rounded to {}, and may be {}: ",
        Format::Decimals(3).name(),
        Format::Binary32.name()
    );
    assert!(untold(&open).starts_with(&expected), "{}", untold(&open));
}

#[test]
fn what_a_log_is_says_how_much_of_it_was_read_and_how_its_format_is_known() {
    let mut study = of_a_log();
    study.precision.told.format = Format::Binary64;
    study.precision.told.or = None;
    study.precision.told.own.fill(None);
    (study.rows, study.sampled) = (10, 10);
    let facts = |study: &Study| log_facts(&RecordsReport { study, log: "log", command: "" });
    let name = Format::Binary64.name();
    let head = format!("10 rows checked, numbers in {name}");
    assert_eq!(facts(&study), format!("{head} (as the numbers tell)"));
    study.sampled = 7;
    let of_them = "; laws are named on 7 of them";
    assert_eq!(facts(&study), format!("{head} (as the numbers tell){of_them}"));
    study.precision.told.or = Some(Format::Binary32);
    let or = Format::Binary32.name();
    assert_eq!(facts(&study), format!("{head} (or {or}, which too few tell){of_them}"));
    study.format_stated = true;
    assert_eq!(facts(&study), format!("{head} (as stated){of_them}"));
    (study.rows, study.sampled) = (0, 0);
    assert_eq!(facts(&study), format!("0 rows checked, numbers in {name} (as stated)"));
    study.format_stated = false;
    assert_eq!(facts(&study), "0 rows checked");
}

#[test]
fn one_row_and_one_digit_are_no_plurals() {
    let mut study = of_a_log();
    study.rows = 1;
    study.format_stated = true;
    study.precision.told = kane_records::told::Told::stated(Format::Significant(1));
    let facts = log_facts(&RecordsReport { study: &study, log: "log", command: "" });
    assert!(facts.starts_with("1 row checked, numbers in 1 digit (as stated)"), "{facts}");
    // a name is read back as what it names
    for format in [Format::Significant(1), Format::Decimals(1)] {
        assert_eq!(format.name().parse(), Ok(format));
    }
}

#[test]
fn a_worst_row_has_its_name_and_a_command_that_shows_it_again() {
    let of = |line, id: &str, replay| Worst {
        line,
        id: id.to_owned(),
        check: Check::Cone,
        finding: Finding { residual: 0.25, scale: 1.0, tolerance: 0.125, verdict: Verdict::Fails },
        replay,
    };
    let flags = || Replay::Flags("--alpha 1/2".to_owned());
    assert_eq!(name(&of(7, "first", flags())), "line 7 (first)");
    assert_eq!([name(&of(7, "", flags())), name(&of(0, "", flags()))], ["line 7", "a row"]);
    let file = || Replay::File("title".to_owned());
    let study = of_a_log();
    let by = |log, command, worst: &Worst| {
        replayed(worst, &RecordsReport { study: &study, log, command })
    };
    let told = |worst: &Worst| by("log.csv", "", worst);
    let command = "kane check 'a b.csv' --map mu=f";
    assert_eq!(
        by("a b.csv", command, &of(7, "", file())),
        format!("{command} --row 7 > row-7.toml; kane collide row-7.toml")
    );
    let hostile = by("$(x).csv", "kane.check", &of(7, "", file()));
    assert!(hostile.starts_with("kane check '$(x).csv' --row 7 "), "{hostile}");
    assert_eq!(told(&of(0, "", flags())), "kane collide --alpha 1/2");
    assert_eq!(
        told(&of(7, "", file())),
        "kane check log.csv --row 7 > row-7.toml; kane collide row-7.toml"
    );
    assert_eq!(
        told(&of(0, "", file())),
        "kane collide FILE, with the collision that is in the JSON"
    );
    assert_eq!(
        residual(Check::Cone, &of(7, "", file()).finding),
        format!("0.25 of 0.125 {}", Check::Cone.unit())
    );
}
