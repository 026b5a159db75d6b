//! The columns of an impact record, by number, name and unit.

/// The version of the format of columns; it rises when a column is removed, renamed or changes its
/// meaning.
pub const SCHEMA_VERSION: u32 = 1;

/// An axis of the log.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// the first
    X,
    /// the second
    Y,
    /// the third, of a log in space
    Z,
}

/// One of the two bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// the body into which the normal points
    First,
    /// the other, if it is not a fixed obstacle
    Second,
}

/// Before or after the impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum When {
    /// before
    Pre,
    /// after
    Post,
}

/// A column of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Column {
    /// when the impact happened
    Time,
    /// the time step
    Dt,
    /// which part of a step lies before the contact
    Phase,
    /// μ as configured
    Friction,
    /// e as configured
    Restitution,
    /// the unit normal, out of the second body into the first
    Normal(Axis),
    /// the acceleration that acts during the step
    Gravity(Axis),
    /// the impulse on the first body as the log has it
    Impulse(Axis),
    /// m
    Mass(Side),
    /// J about the centre of mass
    Inertia(Side),
    /// the radius of a round body
    Radius(Side),
    /// from the centre of mass to the contact point
    Arm(Side, Axis),
    /// the velocity of the centre of mass
    Velocity(Side, Axis, When),
    /// the angular velocity; about Z alone in the plane
    Spin(Side, Axis, When),
}

/// A column of words.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Word {
    /// the name of the row
    Id,
    /// the pair of materials
    Pair,
    /// the shape of a round body, where its inertia is not given
    Shape(Side),
}

/// A column of either kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Field {
    /// of numbers
    Number(Column),
    /// of words
    Word(Word),
}

impl Field {
    /// Its name in the schema.
    #[must_use]
    pub fn name(self) -> String {
        match self {
            Self::Number(column) => column.name(),
            Self::Word(word) => word.name().to_owned(),
        }
    }
}

/// How many columns of numbers there are.
pub const COLUMNS: usize = 50;

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];
const SIDES: [Side; 2] = [Side::First, Side::Second];

impl Axis {
    const fn index(self) -> usize {
        match self {
            Self::X => 0,
            Self::Y => 1,
            Self::Z => 2,
        }
    }

    const fn name(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
        }
    }
}

impl Side {
    const fn index(self) -> usize {
        match self {
            Self::First => 0,
            Self::Second => 1,
        }
    }

    const fn name(self) -> &'static str {
        match self {
            Self::First => "1",
            Self::Second => "2",
        }
    }
}

impl When {
    const fn name(self) -> &'static str {
        match self {
            Self::Pre => "pre",
            Self::Post => "post",
        }
    }
}

impl Column {
    /// Its place among [`COLUMNS`].
    #[must_use]
    pub const fn index(self) -> usize {
        const fn body(side: Side, place: usize) -> usize {
            14 + 18 * side.index() + place
        }
        const fn when(when: When) -> usize {
            match when {
                When::Pre => 0,
                When::Post => 6,
            }
        }
        match self {
            Self::Time => 0,
            Self::Dt => 1,
            Self::Phase => 2,
            Self::Friction => 3,
            Self::Restitution => 4,
            Self::Normal(axis) => 5 + axis.index(),
            Self::Gravity(axis) => 8 + axis.index(),
            Self::Impulse(axis) => 11 + axis.index(),
            Self::Mass(side) => body(side, 0),
            Self::Inertia(side) => body(side, 1),
            Self::Radius(side) => body(side, 2),
            Self::Arm(side, axis) => body(side, 3 + axis.index()),
            Self::Velocity(side, axis, time) => body(side, 6 + when(time) + axis.index()),
            Self::Spin(side, axis, time) => body(side, 9 + when(time) + axis.index()),
        }
    }

    /// The column at a place.
    #[must_use]
    pub fn at(index: usize) -> Option<Self> {
        Self::all().into_iter().find(|column| column.index() == index)
    }

    /// Every column, in the order of the schema.
    #[must_use]
    pub fn all() -> Vec<Self> {
        let mut all = vec![Self::Time, Self::Dt, Self::Phase, Self::Friction, Self::Restitution];
        all.extend(AXES.map(Self::Normal));
        all.extend(AXES.map(Self::Gravity));
        all.extend(AXES.map(Self::Impulse));
        for side in SIDES {
            all.extend([Self::Mass(side), Self::Inertia(side), Self::Radius(side)]);
            all.extend(AXES.map(|axis| Self::Arm(side, axis)));
            for when in [When::Pre, When::Post] {
                all.extend(AXES.map(|axis| Self::Velocity(side, axis, when)));
                all.extend(AXES.map(|axis| Self::Spin(side, axis, when)));
            }
        }
        all
    }

    /// Its name, with the unit.
    #[must_use]
    pub fn name(self) -> String {
        match self {
            Self::Time => "time_s".to_owned(),
            Self::Dt => "dt_s".to_owned(),
            Self::Phase => "phase".to_owned(),
            Self::Friction => "mu".to_owned(),
            Self::Restitution => "e".to_owned(),
            Self::Normal(axis) => format!("normal_{}", axis.name()),
            Self::Gravity(axis) => format!("gravity_{}_m_s2", axis.name()),
            Self::Impulse(axis) => format!("impulse_{}_n_s", axis.name()),
            Self::Mass(side) => format!("mass{}_kg", side.name()),
            Self::Inertia(side) => format!("inertia{}_kg_m2", side.name()),
            Self::Radius(side) => format!("radius{}_m", side.name()),
            Self::Arm(side, axis) => format!("arm{}_{}_m", side.name(), axis.name()),
            Self::Velocity(side, axis, when) => {
                format!("v{}{}_{}_m_s", axis.name(), side.name(), when.name())
            }
            Self::Spin(side, Axis::Z, when) => {
                format!("omega{}_{}_rad_s", side.name(), when.name())
            }
            Self::Spin(side, axis, when) => {
                format!("omega_{}{}_{}_rad_s", axis.name(), side.name(), when.name())
            }
        }
    }

    /// The unit as it stands in names; empty for a pure number.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Time | Self::Dt => "s",
            Self::Phase | Self::Friction | Self::Restitution | Self::Normal(_) => "",
            Self::Gravity(_) => "m_s2",
            Self::Impulse(_) => "n_s",
            Self::Mass(_) => "kg",
            Self::Inertia(_) => "kg_m2",
            Self::Radius(_) | Self::Arm(..) => "m",
            Self::Velocity(..) => "m_s",
            Self::Spin(..) => "rad_s",
        }
    }

    /// What it is, in a line.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Time => "time of the impact; rows must not go back in it",
            Self::Dt => "time step; widens tolerances by what moves within it",
            Self::Phase => "fraction of a step before the contact",
            Self::Friction => "Coulomb's coefficient as configured",
            Self::Restitution => "coefficient of restitution as configured",
            Self::Normal(_) => "unit normal out of body 2 into body 1; (0, 1) if not given",
            Self::Gravity(_) => "acceleration in the step; taken off where dt_s is given",
            Self::Impulse(_) => "impulse on body 1 as logged; compared with m*dv",
            Self::Mass(Side::First) => "mass; needed",
            Self::Mass(Side::Second) => "mass; without it body 2 is a fixed obstacle",
            Self::Inertia(_) => "moment of inertia about the centre; or radius and shape",
            Self::Radius(_) => "radius of a round body; gives the arm where none is given",
            Self::Arm(..) => "from the centre of mass to the contact point",
            Self::Velocity(..) => "velocity of the centre of mass; needed",
            Self::Spin(_, Axis::Z, _) => "angular velocity, from x to y; needed",
            Self::Spin(..) => "angular velocity, of a log in space",
        }
    }
}

impl Word {
    /// Every column of words.
    pub const ALL: [Self; 4] =
        [Self::Id, Self::Pair, Self::Shape(Side::First), Self::Shape(Side::Second)];

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Id => "id",
            Self::Pair => "pair",
            Self::Shape(Side::First) => "shape1",
            Self::Shape(Side::Second) => "shape2",
        }
    }

    /// What it is, in a line.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Id => "a name of the row",
            Self::Pair => "the pair of materials; coefficients are fitted for each",
            Self::Shape(_) => "sphere, hollow-sphere, disc or hoop, in place of the inertia",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_column_has_a_place_and_a_name_of_its_own() {
        let all = Column::all();
        let mut places: Vec<_> = all.iter().map(|column| column.index()).collect();
        places.sort_unstable();
        assert_eq!(places, (0..COLUMNS).collect::<Vec<_>>());
        let names: std::collections::BTreeSet<_> = all.iter().map(|c| c.name()).collect();
        assert_eq!(names.len(), COLUMNS);
        for column in all {
            assert_eq!(Column::at(column.index()), Some(column));
            assert!(column.unit().is_empty() || column.name().ends_with(column.unit()));
        }
    }
}
