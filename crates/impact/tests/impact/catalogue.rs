//! Laws by their ids, and their parameters by name.

use kane_impact::{Provenance, law, laws, set_parameter};
use kane_number::Rational;

#[test]
fn a_parameter_of_a_law_is_what_its_data_say() {
    let mut seen = 0;
    for law in laws() {
        let defaults = law.info.parameters.iter().map(|p| (p.name, p.default()));
        assert_eq!(law.parameters(), defaults.collect::<Vec<_>>(), "{}", law.info.id);
        for parameter in law.info.parameters {
            let value = Rational::new(3.into(), 7.into());
            assert!(parameter.admits(&parameter.default()) && parameter.admits(&value));
            let changed = law.with(parameter.name, &value).expect("the law has it");
            let found = changed.parameters().into_iter().filter(|(_, x)| *x == value);
            assert_eq!(found.collect::<Vec<_>>(), [(parameter.name, value)]);
            seen += 1;
        }
        assert!(law.with("no such parameter", &Rational::from_integer(1.into())).is_none());
    }
    assert_eq!(seen, 10);
}

/// The words in which a source says what was read.
#[test]
fn what_is_known_of_a_law_is_what_its_source_says() {
    for law in laws() {
        let source = law.info.source.to_lowercase();
        let has = |words: &[&str]| words.iter().any(|words| source.contains(words));
        let original = !has(&["original not consulted", "originals not consulted"]);
        let an_abstract = has(&["abstract consulted", "sequel consulted"]);
        let known = match (original, an_abstract) {
            (true, true) => Provenance::Abstract,
            (true, false) => Provenance::Original,
            (false, true) => Provenance::OthersAndAbstract,
            (false, false) => Provenance::Others,
        };
        let said = known != Provenance::Original || has(&["original consulted"]);
        assert!(said && known == law.info.known_by, "{}", law.info.id);
    }
}

#[test]
fn a_law_is_found_by_its_id_and_no_two_share_one() {
    for (place, known) in laws().iter().enumerate() {
        assert_eq!(law(known.info.id).map(|law| law.info), Some(known.info));
        let first = laws().iter().position(|other| other.info.id == known.info.id);
        assert_eq!(first, Some(place));
    }
    assert!(law("no such law").is_none());
}

#[test]
fn a_parameter_that_is_set_reaches_its_law_and_no_other() {
    let mut seen = 0;
    for (place, law) in laws().iter().enumerate() {
        for parameter in law.info.parameters {
            let value = Rational::new(3.into(), 7.into());
            let mut adjusted = laws().to_vec();
            let name = format!("{}.{}", law.info.id, parameter.name);
            set_parameter(&mut adjusted, &name, &Rational::from_integer(1.into())).unwrap();
            set_parameter(&mut adjusted, &name, &value).unwrap();
            let mut expected = laws().to_vec();
            expected[place] = law.with(parameter.name, &value).unwrap();
            assert_eq!(adjusted, expected, "{name}");
            seen += 1;
        }
    }
    assert_eq!(seen, 10);
    let far = Rational::from_integer((-9).into());
    let refused = set_parameter(&mut laws().to_vec(), "walton.beta0", &far).unwrap_err();
    assert_eq!(refused.to_string(), "walton.beta0 is -9, but must be from 0 to 1");
}
