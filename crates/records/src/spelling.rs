//! How others spell the columns: the names of engines, scripts and papers.
//!
//! A name is cut into tokens (at `_`, `.`, blanks and capitals), its unit is taken off, and what is
//! left is read as a quantity with an axis, a body and a time in any order: `linvel_x_pre`,
//! `linearVelocity.x before`, `body1.vx.post`, `v1x_after` and `omega0` are all understood.

use crate::schema::{Axis, Column, Field, Side, When, Word};
use crate::slip::{has_gap, is_slip_for};
use crate::unit::take_unit;

/// What a name turned out to be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Spelled {
    /// A column.
    Known(Field),
    /// No name of a column.
    Unknown,
    /// A quantity of the schema in a unit that is not that of the schema.
    Unit(String),
    /// Not quite a name: perhaps one of these, or a slip of the pen for it.
    Near(Vec<Field>),
}

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

/// Quantities that each of two bodies has.
const HAVE_A_SIDE: [&str; 7] = ["mass", "inertia", "radius", "arm", "velocity", "spin", "shape"];

/// Letters that say nothing alone: an index, a count, a speed of anything.
const LONE: [&str; 8] = ["g", "i", "j", "n", "p", "u", "v", "w"];

/// Reads a name.
pub(crate) fn spelled(name: &str) -> Spelled {
    let exact = Column::all().into_iter().find(|column| column.name() == name);
    if let Some(column) = exact {
        return Spelled::Known(Field::Number(column));
    }
    if LONE.contains(&name) {
        return Spelled::Unknown;
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
        (Spelled::Unknown, _) => near(name, &tokens),
        // a letter too many, or one that was lost: `mu_`, `_vx_pre`, `vx__pre`
        (Spelled::Known(field), _) if has_gap(name) => Spelled::Near(vec![field]),
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

fn times(of: impl Fn(When) -> Column) -> [Column; 2] {
    [When::Pre, When::Post].map(of)
}

fn column(quantity: &str, word: &str, marks: &Marks) -> Spelled {
    let side = marks.side.unwrap_or(Side::First);
    let number = |column| Spelled::Known(Field::Number(column));
    let perhaps =
        |columns: &[Column]| Spelled::Near(columns.iter().copied().map(Field::Number).collect());
    let along = |of: &dyn Fn(Axis) -> Column| match marks.axis {
        Some(axis) => number(of(axis)),
        None => perhaps(&[Axis::X, Axis::Y].map(of)),
    };
    if marks.side.is_some() && !HAVE_A_SIDE.contains(&quantity) {
        // a coefficient of one of two bodies, an impulse on the other
        return match column(quantity, word, &Marks { side: None, ..*marks }) {
            known @ Spelled::Known(Field::Number(_))
                if quantity == "impulse" && side == Side::First =>
            {
                known
            }
            Spelled::Known(field @ Field::Number(_)) if side == Side::First => {
                Spelled::Near(vec![field])
            }
            _ => Spelled::Unknown,
        };
    }
    match (quantity, marks.when, marks.axis) {
        ("time", None, _) => number(Column::Time),
        ("dt", None, None) => number(Column::Dt),
        ("phase", None, None) => number(Column::Phase),
        ("mu", None, None) => number(Column::Friction),
        ("e", None, None | Some(Axis::Y)) => number(Column::Restitution),
        ("normal", None, _) => along(&Column::Normal),
        ("gravity", None, _) => along(&Column::Gravity),
        ("impulse", None, _) => along(&Column::Impulse),
        ("mass", None, None) => number(Column::Mass(side)),
        ("inertia", None, None | Some(Axis::Z)) => number(Column::Inertia(side)),
        // r is a radius, and with an axis an arm
        ("radius", None, None) => number(Column::Radius(side)),
        ("radius", None, Some(axis)) if word == "r" => number(Column::Arm(side, axis)),
        ("arm", None, _) => along(&|axis| Column::Arm(side, axis)),
        ("velocity", Some(when), Some(axis)) => number(Column::Velocity(side, axis, when)),
        ("velocity", ..) => {
            perhaps(&times(|when| Column::Velocity(side, marks.axis.unwrap_or(Axis::X), when)))
        }
        ("spin", Some(when), axis) => number(Column::Spin(side, axis.unwrap_or(Axis::Z), when)),
        ("spin", ..) => {
            perhaps(&times(|when| Column::Spin(side, marks.axis.unwrap_or(Axis::Z), when)))
        }
        ("id", None, None) => Spelled::Known(Field::Word(Word::Id)),
        ("pair", None, None) => Spelled::Known(Field::Word(Word::Pair)),
        ("shape", None, None) => Spelled::Known(Field::Word(Word::Shape(side))),
        _ => Spelled::Unknown,
    }
}

/// The column for whose name, or one of whose words, this is a slip of the pen.
fn near(name: &str, tokens: &[String]) -> Spelled {
    const SHORTEST: usize = 5;
    let lower = name.to_ascii_lowercase();
    let is_near = |known: &Column| {
        let known = known.name();
        known.len() >= SHORTEST && is_slip_for(&lower, &known)
    };
    if let Some(column) = Column::all().into_iter().find(is_near) {
        return Spelled::Near(vec![Field::Number(column)]);
    }
    let mut marks = Marks::default();
    let rest: String = tokens.iter().filter(|token| !marks.take(token)).cloned().collect();
    if rest.contains(|c: char| c.is_ascii_digit()) {
        // another one of the same kind, and no slip
        return Spelled::Unknown;
    }
    let words = QUANTITIES
        .iter()
        .flat_map(|(quantity, words)| words.iter().map(move |word| (*quantity, *word)));
    let mut near = words.filter(|(_, word)| word.len() >= SHORTEST && is_slip_for(&rest, word));
    let found = near.find_map(|(quantity, word)| match column(quantity, word, &marks) {
        Spelled::Known(field @ Field::Number(_)) => Some(field),
        _ => None,
    });
    found.map_or(Spelled::Unknown, |field| Spelled::Near(vec![field]))
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
        for (slip, perhaps) in [
            ("vx1_pro_m_s", "vx1_pre_m_s"),
            ("vx", "vx1_pre_m_s vx1_post_m_s"),
            ("vy2", "vy2_pre_m_s vy2_post_m_s"),
            ("normal", "normal_x normal_y"),
            ("mu_", "mu"),
            ("_vx_pre", "vx1_pre_m_s"),
            ("vx__pre", "vx1_pre_m_s"),
            ("fricton", "mu"),
            ("resitution", "e"),
            ("gravty_y", "gravity_y_m_s2"),
            ("omgea_post", "omega1_post_rad_s"),
            ("mas2_kg", "mass2_kg"),
            // of one body, and there is one for both
            ("mu1", "mu"),
            ("dt_a", "dt_s"),
        ] {
            let Spelled::Near(fields) = spelled(slip) else {
                panic!("{slip}: {:?}", spelled(slip))
            };
            let names: Vec<String> = fields.into_iter().map(Field::name).collect();
            assert_eq!(names.join(" "), perhaps, "{slip}");
        }
        for other in ["wall_s", "comment", "i", "n", "mu2", "impulse2_x", "id_b", "level", "rows"] {
            assert_eq!(spelled(other), Spelled::Unknown, "{other}");
        }
        assert_eq!(name("impulse1_x"), "impulse_x_n_s");
    }
}
