//! How others spell the columns: the names of engines, scripts and papers.
//!
//! A name is cut into tokens (at `_`, `.`, blanks and capitals), its unit is taken off, and what is
//! left is read as a quantity with an axis, a body and a time in any order: `linvel_x_pre`,
//! `linearVelocity.x before`, `body1.vx.post`, `v1x_after` and `omega0` are all understood.

use crate::schema::{Axis, Column, Field, Side, When, Word};

/// What a name turned out to be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Spelled {
    /// A column.
    Known(Field),
    /// No name of a column.
    Unknown,
    /// A quantity of the schema in a unit that is not that of the schema.
    Unit(String),
    /// Not quite a name of the schema: probably a slip of the pen for this one.
    Near(String),
}

/// Units of the schema, as tokens.
const SI: [&[&str]; 9] = [
    &["kg", "m2"],
    &["m", "s2"],
    &["rad", "s"],
    &["n", "s"],
    &["m", "s"],
    &["kg"],
    &["m"],
    &["s"],
    &["ns"],
];

/// Units of others, which are refused rather than converted in silence.
const FOREIGN: [&[&str]; 16] = [
    &["deg", "s"],
    &["degrees", "s"],
    &["rev", "s"],
    &["mm", "s"],
    &["cm", "s"],
    &["km", "h"],
    &["ft", "s"],
    &["kg", "mm2"],
    &["g", "mm2"],
    &["deg"],
    &["rpm"],
    &["mm"],
    &["cm"],
    &["um"],
    &["ms"],
    &["gram"],
];

/// What the quantities are called, written as one word.
const QUANTITIES: [(&str, &[&str]); 17] = [
    ("time", &["time", "t", "impacttime", "timestamp"]),
    ("dt", &["dt", "timestep", "deltat", "stepsize"]),
    ("phase", &["phase", "substepphase", "stepphase"]),
    ("mu", &["mu", "friction", "frictioncoefficient", "coefficientoffriction", "cof"]),
    (
        "e",
        &[
            "e",
            "en",
            "restitution",
            "cor",
            "coefficientofrestitution",
            "restitutioncoefficient",
            "bounce",
            "bounciness",
        ],
    ),
    ("normal", &["normal", "contactnormal", "n"]),
    ("gravity", &["gravity", "g", "gravitationalacceleration"]),
    ("impulse", &["impulse", "contactimpulse", "p"]),
    ("mass", &["mass", "m"]),
    ("inertia", &["inertia", "momentofinertia", "rotationalinertia", "jc", "jzz", "izz", "j", "i"]),
    ("radius", &["radius", "r"]),
    ("arm", &["arm", "lever", "leverarm", "contactarm", "contactoffset"]),
    ("velocity", &["v", "vel", "velocity", "linvel", "linearvelocity", "lin", "linear", "u"]),
    ("spin", &["omega", "w", "angvel", "angularvelocity", "spin", "ang", "angular"]),
    ("id", &["id", "row", "index", "impact", "event"]),
    ("pair", &["pair", "material", "materials", "materialpair", "surface"]),
    ("shape", &["shape"]),
];

/// Reads a name.
pub(crate) fn spelled(name: &str) -> Spelled {
    let exact = Column::all().into_iter().find(|column| column.name() == name);
    if let Some(column) = exact {
        return Spelled::Known(Field::Number(column));
    }
    let mut tokens = tokens(name);
    let unit = take_unit(&mut tokens);
    if let Some(Err(foreign)) = unit {
        let known = !matches!(meant(&tokens), Spelled::Unknown);
        return if known { Spelled::Unit(foreign) } else { Spelled::Unknown };
    }
    match (meant(&tokens), unit) {
        (Spelled::Known(Field::Number(column)), Some(Ok(unit))) if unit != column.unit() => {
            Spelled::Unit(unit)
        }
        (Spelled::Unknown, _) => near(name),
        (meant, _) => meant,
    }
}

/// The words of a name, in small letters, digits apart.
pub(crate) fn tokens(name: &str) -> Vec<String> {
    let mut tokens: Vec<String> = Vec::new();
    let (mut token, mut before) = (String::new(), ' ');
    for c in name.chars() {
        let boundary = (c.is_ascii_uppercase() && before.is_ascii_lowercase())
            || (c.is_ascii_alphabetic() && before.is_ascii_digit());
        if !c.is_ascii_alphanumeric() || boundary {
            tokens.push(std::mem::take(&mut token));
        }
        match c {
            '\'' | '+' => tokens.push("post".to_owned()),
            'ω' => token.push_str("omega"),
            'μ' | 'µ' => token.push_str("mu"),
            c if c.is_ascii_alphanumeric() => token.push(c.to_ascii_lowercase()),
            _ => {}
        }
        before = c;
    }
    tokens.push(token);
    tokens.retain(|token| !token.is_empty());
    tokens
}

/// Takes the unit off the end: one of the schema's, or a foreign one.
fn take_unit(tokens: &mut Vec<String>) -> Option<Result<String, String>> {
    let ends = |unit: &&[&str]| {
        tokens.len() > unit.len()
            && tokens[tokens.len() - unit.len()..].iter().zip(unit.iter()).all(|(a, b)| a == b)
    };
    let found = FOREIGN.iter().find(|unit| ends(unit)).map(|unit| (unit, false));
    let found = found.or_else(|| SI.iter().find(|unit| ends(unit)).map(|unit| (unit, true)));
    let (unit, si) = found?;
    tokens.truncate(tokens.len() - unit.len());
    let unit = unit.join("_").replace("ns", "n_s");
    Some(if si { Ok(unit) } else { Err(unit) })
}

/// The parts of a name that are not the quantity.
#[derive(Default)]
struct Marks {
    axis: Option<Axis>,
    side: Option<Side>,
    when: Option<When>,
}

impl Marks {
    /// Takes the token if it is a mark that is not there yet.
    fn take(&mut self, token: &str) -> bool {
        if token == "body" {
            // says no more than the number or letter after it
        } else if let (None, Some(when)) = (self.when, when(token)) {
            self.when = Some(when);
        } else if let (None, Some(side)) = (self.side, side(token)) {
            self.side = Some(side);
        } else if let (None, Some(axis)) = (self.axis, axis(token)) {
            self.axis = Some(axis);
        } else {
            return false;
        }
        true
    }
}

fn when(token: &str) -> Option<When> {
    match token {
        "pre" | "before" | "in" | "initial" | "old" | "0" | "minus" | "start" => Some(When::Pre),
        "post" | "after" | "out" | "final" | "new" | "plus" | "end" => Some(When::Post),
        _ => None,
    }
}

fn side(token: &str) -> Option<Side> {
    match token {
        "1" | "a" | "first" | "body1" | "bodya" => Some(Side::First),
        "2" | "b" | "second" | "other" | "body2" | "bodyb" => Some(Side::Second),
        _ => None,
    }
}

/// A tangent and a normal velocity are those of a contact whose normal is y.
fn axis(token: &str) -> Option<Axis> {
    match token {
        "x" | "t" => Some(Axis::X),
        "y" | "n" => Some(Axis::Y),
        "z" => Some(Axis::Z),
        _ => None,
    }
}

/// The column that these tokens mean.
fn meant(tokens: &[String]) -> Spelled {
    let joined = tokens.concat();
    if let Some(quantity) = quantity(&joined) {
        return column(quantity, &joined, &Marks::default());
    }
    let mut marks = Marks::default();
    let mut rest = String::new();
    for token in tokens {
        if !marks.take(token) {
            rest.push_str(token);
        }
    }
    // what is written together: vx, vx1, omega0, m1
    while quantity(&rest).is_none() {
        let Some(last) = rest.pop() else { return Spelled::Unknown };
        if rest.is_empty() || !marks.take(last.encode_utf8(&mut [0; 4])) {
            return Spelled::Unknown;
        }
    }
    quantity(&rest).map_or(Spelled::Unknown, |quantity| column(quantity, &rest, &marks))
}

fn quantity(word: &str) -> Option<&'static str> {
    QUANTITIES.iter().find(|(_, words)| words.contains(&word)).map(|(quantity, _)| *quantity)
}

fn column(quantity: &str, word: &str, marks: &Marks) -> Spelled {
    let side = marks.side.unwrap_or(Side::First);
    let number = |column| Spelled::Known(Field::Number(column));
    let along = |of: &dyn Fn(Axis) -> Column, name: &str| match marks.axis {
        Some(axis) => number(of(axis)),
        None => Spelled::Near(name.to_owned()),
    };
    match (quantity, marks.when, marks.axis) {
        ("time", None, _) => number(Column::Time),
        ("dt", None, None) => number(Column::Dt),
        ("phase", None, None) => number(Column::Phase),
        ("mu", None, None) => number(Column::Friction),
        ("e", None, None | Some(Axis::Y)) => number(Column::Restitution),
        ("normal", None, _) => along(&Column::Normal, "normal_x, normal_y"),
        ("gravity", None, _) => along(&Column::Gravity, "gravity_x_m_s2, gravity_y_m_s2"),
        ("impulse", None, _) => along(&Column::Impulse, "impulse_x_n_s, impulse_y_n_s"),
        ("mass", None, None) => number(Column::Mass(side)),
        ("inertia", None, None | Some(Axis::Z)) => number(Column::Inertia(side)),
        // r is a radius, and with an axis an arm
        ("radius", None, None) => number(Column::Radius(side)),
        ("radius", None, Some(axis)) if word == "r" => number(Column::Arm(side, axis)),
        ("arm", None, _) => along(&|axis| Column::Arm(side, axis), "arm1_x_m, arm1_y_m"),
        ("velocity", Some(when), Some(axis)) => number(Column::Velocity(side, axis, when)),
        ("velocity", ..) => Spelled::Near("vx1_pre_m_s, vx1_post_m_s".to_owned()),
        ("spin", Some(when), axis) => number(Column::Spin(side, axis.unwrap_or(Axis::Z), when)),
        ("spin", ..) => Spelled::Near("omega1_pre_rad_s, omega1_post_rad_s".to_owned()),
        ("id", None, None) => Spelled::Known(Field::Word(Word::Id)),
        ("pair", None, None) => Spelled::Known(Field::Word(Word::Pair)),
        ("shape", None, None) => Spelled::Known(Field::Word(Word::Shape(side))),
        _ => Spelled::Unknown,
    }
}

/// The column whose name differs by one letter.
fn near(name: &str) -> Spelled {
    let lower = name.to_ascii_lowercase();
    let names = Column::all().into_iter().map(Column::name);
    match names.filter(|known| known.len() > 4).find(|known| distance_is_one(known, &lower)) {
        Some(known) => Spelled::Near(known),
        None => Spelled::Unknown,
    }
}

/// Whether one letter more, less or changed makes one word of the other.
fn distance_is_one(a: &str, b: &str) -> bool {
    let (a, b) = if a.len() < b.len() { (b, a) } else { (a, b) };
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let head = a.iter().zip(b).take_while(|(a, b)| a == b).count();
    match a.len() - b.len() {
        0 => head < a.len() && a[head + 1..] == b[head + 1..],
        1 => a[head + 1..] == b[head..],
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name(spelling: &str) -> String {
        match spelled(spelling) {
            Spelled::Known(Field::Number(column)) => column.name(),
            Spelled::Known(Field::Word(word)) => word.name().to_owned(),
            other => format!("{other:?}"),
        }
    }

    #[test]
    fn a_name_of_the_schema_is_itself() {
        for column in Column::all() {
            assert_eq!(name(&column.name()), column.name());
        }
        for word in Word::ALL {
            assert_eq!(name(word.name()), word.name());
        }
    }

    #[test]
    fn the_spellings_of_engines_and_papers_are_understood() {
        for (theirs, ours) in [
            ("vx_pre", "vx1_pre_m_s"),
            ("omega_post", "omega1_post_rad_s"),
            ("restitution", "e"),
            ("mass", "mass1_kg"),
            ("inertia", "inertia1_kg_m2"),
            ("radius", "radius1_m"),
            ("dt", "dt_s"),
            ("linvel_y_after", "vy1_post_m_s"),
            ("linearVelocity.x before", "vx1_pre_m_s"),
            ("angularVelocity2_post", "omega2_post_rad_s"),
            ("bodyB.vx.post", "vx2_post_m_s"),
            ("v1x_after", "vx1_post_m_s"),
            ("omega0", "omega1_pre_rad_s"),
            ("v_n'", "vy1_post_m_s"),
            ("rx", "arm1_x_m"),
            ("arm_y", "arm1_y_m"),
            ("r2", "radius2_m"),
            ("nx", "normal_x"),
            ("g_y", "gravity_y_m_s2"),
            ("m2", "mass2_kg"),
            ("material", "pair"),
            ("μ", "mu"),
            ("e_n", "e"),
            ("vz_pre", "vz1_pre_m_s"),
            ("angvel_x_pre", "omega_x1_pre_rad_s"),
        ] {
            assert_eq!(name(theirs), ours, "{theirs}");
        }
    }

    #[test]
    fn other_units_are_refused_and_slips_of_the_pen_are_seen() {
        assert_eq!(spelled("omega_pre_deg_s"), Spelled::Unit("deg_s".to_owned()));
        assert_eq!(spelled("radius_mm"), Spelled::Unit("mm".to_owned()));
        assert_eq!(spelled("vx1_pre_m"), Spelled::Unit("m".to_owned()));
        assert_eq!(spelled("vx1_pro_m_s"), Spelled::Near("vx1_pre_m_s".to_owned()));
        assert_eq!(spelled("wall_s"), Spelled::Unknown);
        assert_eq!(spelled("comment"), Spelled::Unknown);
        assert!(matches!(spelled("vx"), Spelled::Near(_)));
    }
}
