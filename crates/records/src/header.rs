//! The first line of a log: which column is what.

use crate::schema::{Axis, Column, Field, Side, When, Word};
use crate::spelling::{Spelled, spelled};

/// What the columns of a log are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Header {
    /// the field of each column of the file, or `None` for one that is not read
    pub fields: Vec<Option<Field>>,
    /// columns of the file that mean nothing to the checks
    pub unread: Vec<String>,
    /// columns whose names have no unit, which are taken to be SI
    pub unitless: Vec<String>,
}

/// Why a header cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum HeaderFault {
    /// Columns are missing without which no row can be checked.
    #[error("columns are missing: {}{}; `kane check --schema` lists the names, and --map OURS=THEIRS renames", .0.join(", "), besides(.1))]
    Missing(Vec<String>, Vec<String>),
    /// Two columns mean the same.
    #[error("the columns `{0}` and `{1}` both mean {2}; choose one with --map {2}=NAME")]
    Twice(String, String, String),
    /// Two columns have one name, and mean something: their places, counted from 1.
    #[error("columns {1} and {2} are both called `{0}`: rename one of them in the file")]
    OneName(String, usize, usize),
    /// `--map` gives a column of the file to two of the schema.
    #[error("--map gives the column `{0}` of the file to both {1} and {2}; choose one of them")]
    GivenTwice(String, String, String),
    /// A unit that is not that of the schema.
    #[error("the column `{0}` is in {1}: convert it to SI units (m, kg, s, rad) first")]
    Unit(String, String),
    /// A name that is nearly one of the schema.
    #[error("what is the column `{0}`? Perhaps {1}; if so use that name or --map")]
    Near(String, String),
    /// `--map` names a column that is not in the file.
    #[error("--map {0}={1}: the file has no column `{1}`")]
    NoSuch(String, String),
    /// `--map` names a column that is not in the schema.
    #[error("--map {0}={1}: the schema has no column `{0}`; see kane check --schema")]
    NotInSchema(String, String),
}

/// The columns of the file that mean nothing, among which a missing one may be.
fn besides(unread: &[String]) -> String {
    const SHOWN: usize = 8;
    let shown: Vec<String> =
        unread.iter().take(SHOWN).map(|name| format!("`{}`", name.escape_debug())).collect();
    match (shown.is_empty(), unread.len() > SHOWN) {
        (true, _) => String::new(),
        (_, more) => {
            format!(
                " (not understood: {}{})",
                shown.join(", "),
                if more { " and others" } else { "" }
            )
        }
    }
}

impl Header {
    /// Reads the names of the columns; `map` has pairs of a name of the schema and one of the file.
    ///
    /// # Errors
    /// The first [`HeaderFault`].
    pub fn of(names: &[String], map: &[(String, String)]) -> Result<Self, HeaderFault> {
        let mut header = Self { fields: vec![None; names.len()], unread: vec![], unitless: vec![] };
        for (ours, theirs) in map {
            let not_there = || HeaderFault::NoSuch(ours.clone(), theirs.clone());
            let place = names.iter().position(|name| name == theirs).ok_or_else(not_there)?;
            let Spelled::Known(field) = spelled(ours) else {
                return Err(HeaderFault::NotInSchema(ours.clone(), theirs.clone()));
            };
            let again = names[place + 1..].iter().position(|name| name == theirs);
            if let Some(again) = again {
                return Err(HeaderFault::OneName(theirs.clone(), place + 1, place + again + 2));
            }
            match header.fields[place].replace(field) {
                Some(other) if other != field => {
                    let [first, second] = [other, field].map(Field::name);
                    return Err(HeaderFault::GivenTwice(theirs.clone(), first, second));
                }
                _ => {}
            }
        }
        let mapped: Vec<Field> = header.fields.iter().flatten().copied().collect();
        let mut slips = Vec::new();
        for (place, name) in names.iter().enumerate() {
            if header.fields[place].is_some() {
                continue;
            }
            match spelled(name) {
                // what is mapped is decided
                Spelled::Known(field) if mapped.contains(&field) => {
                    header.unread.push(name.clone())
                }
                Spelled::Known(field) => {
                    header.fields[place] = Some(field);
                    header.note_unit(name, field);
                }
                Spelled::Unknown => header.unread.push(name.clone()),
                Spelled::Unit(unit) => return Err(HeaderFault::Unit(name.clone(), unit)),
                Spelled::Near(known) => slips.push((name, known)),
            }
        }
        // where the file has what such a name may mean, it means something else
        for (name, known) in slips {
            if known.iter().any(|field| !header.fields.contains(&Some(*field))) {
                let known: Vec<String> = known.into_iter().map(Field::name).collect();
                return Err(HeaderFault::Near(name.clone(), known.join(", ")));
            }
            header.unread.push(name.clone());
        }
        header.no_field_twice(names)?;
        header.complete()?;
        Ok(header)
    }

    fn note_unit(&mut self, name: &str, field: Field) {
        let Field::Number(column) = field else { return };
        let unit = column.unit();
        if !unit.is_empty() && !name.to_ascii_lowercase().ends_with(unit) {
            self.unitless.push(name.to_owned());
        }
    }

    fn no_field_twice(&self, names: &[String]) -> Result<(), HeaderFault> {
        for (place, field) in self.fields.iter().enumerate() {
            let Some(field) = field else { continue };
            let first = self.fields[..place].iter().position(|other| *other == Some(*field));
            if let Some(first) = first {
                let (a, b) = (names[first].clone(), names[place].clone());
                if a == b {
                    return Err(HeaderFault::OneName(a, first + 1, place + 1));
                }
                return Err(HeaderFault::Twice(a, b, field.name()));
            }
        }
        Ok(())
    }

    /// Whether the file has a column.
    #[must_use]
    pub fn has(&self, column: Column) -> bool {
        self.fields.contains(&Some(Field::Number(column)))
    }

    /// Whether the log is one in space.
    #[must_use]
    pub fn is_spatial(&self) -> bool {
        [When::Pre, When::Post]
            .iter()
            .any(|&when| self.has(Column::Velocity(Side::First, Axis::Z, when)))
    }

    /// Whether there is a second body.
    #[must_use]
    pub fn has_second(&self) -> bool {
        self.has(Column::Mass(Side::Second))
    }

    fn complete(&self) -> Result<(), HeaderFault> {
        let mut missing = Vec::new();
        let axes: &[Axis] =
            if self.is_spatial() { &[Axis::X, Axis::Y, Axis::Z] } else { &[Axis::X, Axis::Y] };
        let spins: &[Axis] = if self.is_spatial() { axes } else { &[Axis::Z] };
        let sides: &[Side] =
            if self.has_second() { &[Side::First, Side::Second] } else { &[Side::First] };
        let mut need = |column: Column| {
            if !self.has(column) {
                missing.push(column.name());
            }
        };
        for &side in sides {
            need(Column::Mass(side));
            for when in [When::Pre, When::Post] {
                axes.iter().for_each(|&axis| need(Column::Velocity(side, axis, when)));
                spins.iter().for_each(|&axis| need(Column::Spin(side, axis, when)));
            }
        }
        for &side in sides {
            let shape = self.fields.contains(&Some(Field::Word(Word::Shape(side))));
            let round = self.has(Column::Radius(side));
            let known = self.has(Column::Inertia(side)) || round && shape;
            if !known {
                let radius = Column::Radius(side).name();
                let shape = Word::Shape(side).name();
                missing.push(format!("{} (or {radius} and {shape})", Column::Inertia(side).name()));
            }
            let arms = axes.iter().all(|&axis| self.has(Column::Arm(side, axis)));
            if !arms && !round {
                let arm = |axis| Column::Arm(side, axis).name();
                let radius = Column::Radius(side).name();
                missing.push(format!("{} and {} (or {radius})", arm(Axis::X), arm(Axis::Y)));
            }
        }
        if missing.is_empty() {
            Ok(())
        } else {
            Err(HeaderFault::Missing(missing, self.unread.clone()))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLAIN: &str = "mass,radius,inertia,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post";

    fn header(names: &str, map: &[(&str, &str)]) -> Result<Header, HeaderFault> {
        let names: Vec<String> = names.split(',').map(str::to_owned).collect();
        let owned = |(a, b): &(&str, &str)| ((*a).to_owned(), (*b).to_owned());
        Header::of(&names, &map.iter().map(owned).collect::<Vec<_>>())
    }

    #[test]
    fn a_plain_header_is_complete_and_its_units_are_assumed() {
        let header = header(&format!("{PLAIN},wall_s"), &[]).expect("it is complete");
        assert_eq!((header.unread, header.unitless.len()), (vec!["wall_s".to_owned()], 9));
    }

    #[test]
    fn what_is_missing_is_named_all_at_once() {
        let fault = header("mass,vx_pre,vy_pre", &[]).expect_err("much is missing").to_string();
        for name in ["omega1_pre_rad_s", "vx1_post_m_s", "inertia1_kg_m2 (or", "arm1_x_m and"] {
            assert!(fault.contains(name), "{fault}");
        }
    }

    #[test]
    fn a_map_renames_and_says_what_is_not_there() {
        let names = PLAIN.replace("vx_pre", "foo");
        assert!(matches!(header(&names, &[]), Err(HeaderFault::Missing(..))));
        assert!(header(&names, &[("vx_pre", "foo")]).is_ok());
        assert!(matches!(header(&names, &[("vx_pre", "no")]), Err(HeaderFault::NoSuch(..))));
        assert!(matches!(header(&names, &[("zeal", "foo")]), Err(HeaderFault::NotInSchema(..))));
    }

    #[test]
    fn a_slip_of_the_pen_is_asked_about_unless_the_file_has_what_it_may_mean() {
        for (slip, perhaps) in
            [("mu_", "mu"), ("fricton", "mu"), ("restituton", "e"), ("mu1", "mu")]
        {
            let fault = header(&format!("{PLAIN},{slip}"), &[]).expect_err("it is a slip");
            assert_eq!(fault, HeaderFault::Near(slip.to_owned(), perhaps.to_owned()));
            let both = header(&format!("{PLAIN},{slip},{perhaps}"), &[]).expect("it is no slip");
            assert_eq!(both.unread, [slip]);
            assert!(header(&format!("{PLAIN},{slip}"), &[(perhaps, slip)]).is_ok());
        }
    }

    #[test]
    fn two_columns_for_one_thing_are_no_choice() {
        let twice = header(&format!("{PLAIN},vx_before"), &[]);
        assert!(matches!(twice, Err(HeaderFault::Twice(..))), "{twice:?}");
        // the one that is chosen decides
        assert!(header(&format!("{PLAIN},vx_before"), &[("vx_pre", "vx_before")]).is_ok());
    }

    #[test]
    fn two_columns_of_one_name_are_told_by_their_places() {
        let told =
            |names: &str, map: &[(&str, &str)]| header(names, map).map_err(|e| e.to_string());
        let twice = told(&format!("{PLAIN},vx_pre"), &[]).expect_err("which is it?");
        assert!(twice.starts_with("columns 4 and 10 are both called `vx_pre`"), "{twice}");
        // what is not read may have any names, but if a map asks for one of them
        let names = format!("{PLAIN},foo,bar,foo");
        assert!(told(&names, &[]).is_ok());
        let asked = told(&names, &[("time", "foo")]).expect_err("which is it?");
        assert!(asked.starts_with("columns 10 and 12 are both called `foo`"), "{asked}");
        let both = told(&names, &[("time", "bar"), ("phase", "bar")]).expect_err("it is one");
        assert!(both.contains("`bar`") && both.contains("time_s and phase"), "{both}");
    }
}
