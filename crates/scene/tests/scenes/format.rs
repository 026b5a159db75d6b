//! What bad files get: a message that points at the place.

use kane_scene::read::scene;

const GOOD: &str = r#"title = "A ball"
friction = 0.2
restitution = "3/4"
gravity_m_s2 = 9.81
floor_m = 0

[[body]]
mass_kg = 1
radius_m = 0.1
position_m = [0, 1]
velocity_m_s = [{ value = 1, within = 0.1 }, 0]

[until]
impacts = 3

[ask]
k = 0.01
"#;

#[test]
fn the_good_file_is_read_exactly() {
    let scene = scene("good.toml", GOOD).expect("it is good");
    assert_eq!(scene.uncertain(), 1);
    assert_eq!(scene.corners().len(), 2);
    assert_eq!(scene.nominal().frictions()[0].to_string(), "1/5");
}

#[test]
fn every_fault_points_at_its_place() {
    for (change, with, line, message) in [
        ("friction = 0.2", "fricton = 0.2", 2, "unknown field `fricton`"),
        ("k = 0.01", "kk = 0.01", 17, "nothing is called `kk`"),
        ("k = 0.01", "k = -1", 17, "the tolerance of k is -1, but must be at least 0"),
        ("impacts = 3", "impacts = 0", 14, "impacts must be a whole number above 0"),
        ("impacts = 3", "impacts = 3\nrest = true", 13, "exactly one of impacts"),
        ("mass_kg = 1", "mass_kg = 0", 8, "mass_kg is 0, but must be above 0"),
        (
            "restitution = \"3/4\"",
            "restitution = 1.5",
            3,
            "restitution is 1.5, but must be from 0 to 1",
        ),
        ("position_m = [0, 1]", "position_m = [0, 0.05]", 10, "body 1 is inside the floor"),
        ("within = 0.1", "withn = 0.1", 11, "unknown key `withn`"),
        ("within = 0.1", "within = -0.1", 11, "must be at least 0"),
        ("radius_m = 0.1", "radius_m = \"1/0\"", 9, "radius_m cannot be 1/0"),
        ("k = 0.01", "v_x_m_s_of_2 = 0.01", 17, "there are 1 bodies"),
        (
            "friction = 0.2",
            "friction = 0.2\npoisson_ratio = 0.3\nstiffness_ratio = 1",
            3,
            "poisson_ratio and stiffness_ratio; give one of them",
        ),
        ("friction = 0.2", "friction = 0.2\nstiffness_ratio = 0", 3, "must be above 0"),
        (
            "friction = 0.2",
            "friction = { value = 0.2, within = 0.3 }",
            2,
            "an end of the range of friction",
        ),
    ] {
        let text = GOOD.replacen(change, with, 1);
        assert_ne!(text, GOOD, "{change}");
        let fault = scene("bad.toml", &text).expect_err(with);
        assert!(fault.message.contains(message), "{with}: {}", fault.message);
        assert_eq!(fault.line, line, "{with}: {fault}");
        assert!(fault.to_string().contains('^'), "{fault}");
    }
}

#[test]
fn what_may_not_be_uncertain_says_so_at_its_line() {
    let discs = GOOD.replacen(
        "[[body]]\nmass_kg = 1\nradius_m = 0.1\nposition_m = [0, 1]\nvelocity_m_s = [{ value = 1, within = 0.1 }, 0]\n",
        "[discs]\ncolumns = 2\nrows = 2\nmass_kg = 1\nradius_m = 0.1\nspacing_m = 0.3\nspeed_m_s = 1\n",
        1,
    );
    assert!(scene("discs.toml", &discs).is_ok());
    for (text, change, with, line) in [
        (discs.as_str(), "speed_m_s = 1", "speed_m_s = { value = 1, within = 0.1 }", 13),
        (discs.as_str(), "spacing_m = 0.3", "spacing_m = { value = 0.3, within = 0.1 }", 12),
        (GOOD, "mass_kg = 1", "mass_kg = { value = 1, within = 0.1 }", 8),
        (GOOD, "k = 0.01", "k = { value = 1, within = 0.1 }", 17),
    ] {
        let bad = text.replacen(change, with, 1);
        assert_ne!(bad, text, "{change}");
        let fault = scene("bad.toml", &bad).expect_err(with);
        assert!(fault.message.contains("write one number"), "{with}: {}", fault.message);
        assert_eq!(fault.line, line, "{with}: {fault}");
    }
}

#[test]
fn numbers_that_are_none_are_refused() {
    for (with, message) in [
        ("mass_kg = nan", "mass_kg cannot be nan"),
        ("mass_kg = inf", "mass_kg cannot be inf"),
        ("mass_kg = \"NaN\"", "mass_kg cannot be NaN"),
        ("mass_kg = -1", "mass_kg is -1, but must be above 0"),
        ("mass_kg = 1e999", "number overflowed"),
        ("mass_kg = \"\"", "mass_kg cannot be empty"),
        ("mass_kg = \"1 kg\"", "mass_kg cannot be 1 kg"),
        ("mass_kg = \"1e400\"", "mass_kg is 1e400, beyond the range"),
        ("mass_g = 1000", "unknown field `mass_g`"),
        ("mass_kg = true", "mass_kg cannot be"),
    ] {
        let text = GOOD.replacen("mass_kg = 1", with, 1);
        let fault = scene("bad.toml", &text).expect_err(with);
        assert!(fault.message.contains(message), "{with}: {}", fault.message);
        assert_eq!(fault.line, 8, "{with}: {fault}");
    }
    // what is missing is said of the table that lacks it
    let text = GOOD.replacen("mass_kg = 1\n", "", 1);
    let fault = scene("bad.toml", &text).expect_err("it has no mass");
    assert!(fault.message.contains("missing field `mass_kg`"), "{}", fault.message);
    assert_eq!(fault.line, 7, "{fault}");
    for (text, message) in [
        ("", "the file is empty"),
        ("\n \n", "is empty"),
        ("# soon\n", "comments alone, and no key"),
    ] {
        let fault = scene("bad.toml", text).expect_err("it says nothing");
        assert!(fault.message.contains(message), "{}", fault.message);
    }
}

#[test]
fn a_key_mistyped_gets_a_suggestion() {
    for (right, wrong, meant) in [
        ("friction", "fricton", "friction"),
        ("gravity_m_s2", "gravity", "gravity_m_s2"),
        ("mass_kg", "mass", "mass_kg"),
    ] {
        let fault = scene("bad.toml", &GOOD.replacen(right, wrong, 1)).expect_err(wrong);
        assert_eq!(fault.note.as_deref(), Some(&*format!("did you mean `{meant}`?")));
    }
    let fault = scene("bad.toml", &GOOD.replacen("k = ", "v_x = ", 1)).expect_err("no unit");
    assert!(fault.message.ends_with("did you mean `v_x_m_s`?"), "{}", fault.message);
}

#[test]
fn what_needs_a_table_says_so() {
    for (without, message) in
        [("[ask]\nk = 0.01\n", "[ask] needs a quantity"), ("[until]\nimpacts = 3\n", "[until]")]
    {
        let text = GOOD.replacen(without, "", 1);
        let fault = scene("bad.toml", &text).expect_err("something is missing");
        assert!(fault.message.contains(message), "{}", fault.message);
    }
    let two = format!(
        "{GOOD}\n[rod-tip]\nmass_kg = 1\nlength_m = 1\nhalf_tangent = 1\nvelocity_m_s = [0, -1]\n"
    );
    let fault = scene("bad.toml", &two).expect_err("two things are described");
    assert!(fault.message.contains("exactly one of"), "{}", fault.message);
}

#[test]
fn what_walls_and_contacts_may_be_is_said_at_its_place() {
    let with = |table: &str| GOOD.replacen("[[body]]", &format!("{table}\n\n[[body]]"), 1);
    let wall = "[[wall]]\nthrough_m = [0, 0]";
    for (table, message) in [
        (format!("{wall}\nangle_deg = 180"), "body 1 is inside wall 1"),
        (wall.to_owned(), "the direction is missing"),
        ("[[contact]]".to_owned(), "states neither friction nor restitution"),
        ("[[contact]]\nfriction = -1".to_owned(), "must be at least 0"),
        ("[[contact]]\nrestitution = 2".to_owned(), "must be from 0 to 1"),
        ("[[contact]]\nrestitution_at_m_s = 2".to_owned(), "a restitution is"),
        (
            "[[contact]]\nspeeds_m_s = [2, 1]\nrestitutions = [0.5, 0.4]".to_owned(),
            "speeds_m_s must grow",
        ),
        ("[[contact]]\nspeeds_m_s = [2]\nrestitutions = []".to_owned(), "the same number"),
        (
            "[[contact]]\nbetween = [\"body-1\", \"roof\"]\nfriction = 1".to_owned(),
            "between names two that can meet",
        ),
        (
            "[[contact]]\nbetween = [\"body-1\", \"body-1\"]\nfriction = 1".to_owned(),
            "between names two that can meet",
        ),
    ] {
        let text = with(&table);
        let fault = scene("bad.toml", &text).expect_err(&table);
        assert!(fault.message.contains(message), "{table}: {}", fault.message);
    }
    assert!(scene("good.toml", &with("[[contact]]\nfriction = 0.1")).is_ok());
}
