//! What scenes, collisions and flags have in common: exact numbers, and the bodies made of them.

use std::ops::Range;

use kane_impact::bodies::{Direction, Motion, Shape};
use kane_number::{Algebraic, Rational};
use toml::Spanned;

use super::angle::direction;
use super::bodies::{Pendulum, Rod};
use super::number::Domain;
use super::source::{Fault, Number, Source};
use super::stated::{Stated, stated};
use crate::collide::Given;
use crate::tip::TipBody;

/// What a given value is called: the key that faults name, then symbol and unit for reports.
#[derive(Clone, Copy, Debug)]
pub struct Name<'a> {
    /// as in the file
    pub key: &'a str,
    /// as in formulas
    pub symbol: &'a str,
    /// empty for a pure number
    pub unit: &'static str,
}

/// A name.
#[must_use]
pub const fn name<'a>(key: &'a str, symbol: &'a str, unit: &'static str) -> Name<'a> {
    Name { key, symbol, unit }
}

/// Reads numbers as they are written, and keeps what was given or assumed.
#[derive(Debug)]
pub struct Reader<'a> {
    source: Source<'a>,
    /// Whether a number may be uncertain.
    uncertain: bool,
    /// The values, in the order in which they were read.
    pub given: Vec<Given>,
    /// What stands for an angle in degrees.
    pub notes: Vec<String>,
}

impl<'a> Reader<'a> {
    /// A reader of numbers that are known exactly.
    #[must_use]
    pub const fn new(source: Source<'a>) -> Self {
        Self { source, uncertain: false, given: Vec::new(), notes: Vec::new() }
    }

    /// A reader of numbers that may be uncertain.
    pub(super) fn of_uncertain(source: Source<'a>) -> Self {
        Self { uncertain: true, ..Self::new(source) }
    }

    pub(super) fn fault(&self, span: Range<usize>, message: impl Into<String>) -> Fault {
        self.source.fault(span, message)
    }

    fn note(&mut self, symbol: &str, value: String, unit: &'static str, assumed: bool) {
        self.given.push(Given { symbol: symbol.to_owned(), value, unit, assumed });
    }

    /// The number as written.
    ///
    /// # Errors
    /// That it is no number, or outside the domain.
    pub fn number(
        &mut self,
        number: &Number,
        name: Name<'_>,
        domain: Domain,
    ) -> Result<Rational, Fault> {
        let value = self.source.number(number, name.key, domain)?;
        self.note(name.symbol, self.source.written(number), name.unit, false);
        Ok(value)
    }

    /// The number as written, or the integer that is assumed where there is none.
    ///
    /// # Errors
    /// As [`number`](Self::number).
    pub fn number_or(
        &mut self,
        number: Option<&Number>,
        name: Name<'_>,
        domain: Domain,
        default: u8,
    ) -> Result<Rational, Fault> {
        match number {
            Some(number) => self.number(number, name, domain),
            None => {
                self.note(name.symbol, default.to_string(), name.unit, true);
                Ok(Rational::from_integer(default.into()))
            }
        }
    }

    /// The same where the value may be uncertain.
    pub(super) fn stated(
        &mut self,
        number: &Number,
        name: Name<'_>,
        domain: Domain,
    ) -> Result<Stated, Fault> {
        if self.uncertain && number.get_ref().is_table() {
            return stated(self.source, number, name.key, domain);
        }
        Ok(self.number(number, name, domain)?.into())
    }

    pub(super) fn pair(
        &mut self,
        pair: &[Number; 2],
        key: &str,
        symbols: [&str; 2],
        unit: &'static str,
        domain: Domain,
    ) -> Result<[Stated; 2], Fault> {
        let [a, b] = pair;
        let [first, second] = symbols.map(|symbol| name(key, symbol, unit));
        Ok([self.stated(a, first, domain)?, self.stated(b, second, domain)?])
    }

    /// Velocity and spin; the tag stands behind the symbols.
    pub(super) fn motion(
        &mut self,
        velocity: &[Number; 2],
        spin: Option<&Number>,
        tag: &str,
    ) -> Result<Motion<Stated>, Fault> {
        let [x, y, omega] = ["v_x", "v_y", "omega"].map(|symbol| format!("{symbol}{tag}"));
        let [vx, vy] = self.pair(velocity, "velocity_m_s", [&x, &y], "m/s", Domain::Any)?;
        let omega = match spin {
            Some(spin) => self.stated(spin, name("spin_rad_s", &omega, "rad/s"), Domain::Any)?,
            None => {
                self.note(&omega, "0".to_owned(), "rad/s", true);
                Stated::default()
            }
        };
        Ok(Motion { vx, vy, omega })
    }

    /// The direction of an angle in degrees: a pair of floats, which is noted.
    ///
    /// # Errors
    /// As [`number`](Self::number).
    pub fn degrees(
        &mut self,
        degrees: &Number,
        name: Name<'_>,
        domain: Domain,
    ) -> Result<Direction<Rational>, Fault> {
        let direction = direction(&self.number(degrees, name, domain)?);
        let float = |x: &Rational| Algebraic::from(x.clone()).to_f64();
        self.notes.push(format!(
            "{}: the direction is the float pair cos = {}, sin = {}, taken exactly.",
            name.symbol,
            float(&direction.cos),
            float(&direction.sin)
        ));
        Ok(direction)
    }

    /// The direction of the tangent of half an angle, exactly.
    ///
    /// # Errors
    /// As [`number`](Self::number).
    pub fn half_tangent(
        &mut self,
        tangent: &Number,
        name: Name<'_>,
        domain: Domain,
    ) -> Result<Direction<Rational>, Fault> {
        Ok(Direction::of_half_tangent(&self.number(tangent, name, domain)?))
    }

    /// A direction from degrees or from half a tangent.
    pub(super) fn heading(
        &mut self,
        degrees: Option<&Number>,
        tangent: Option<&Number>,
        tag: &str,
    ) -> Result<Direction<Rational>, Fault> {
        match (degrees, tangent) {
            (Some(degrees), None) => {
                // one turn and a bit: nobody means more
                let domain = Domain::Within(u8::MAX);
                self.degrees(degrees, name("angle_deg", &format!("angle{tag}"), "°"), domain)
            }
            (None, Some(tangent)) => {
                let symbol = format!("tan(angle{tag}/2)");
                self.half_tangent(tangent, name("half_tangent", &symbol, ""), Domain::Any)
            }
            (Some(both), Some(_)) => {
                Err(self.fault(both.span(), "an angle in degrees and half a tangent; give one"))
            }
            (None, None) => {
                Err(self.fault(0..0, "the direction is missing: angle_deg or half_tangent"))
            }
        }
    }

    /// A shape by its word.
    ///
    /// # Errors
    /// That no shape is called so.
    pub fn shape(&mut self, word: &Spanned<String>, symbol: &str) -> Result<Shape, Fault> {
        let shape = word.get_ref().parse::<Shape>();
        let shape = shape.map_err(|error| self.fault(word.span(), error.to_string()))?;
        self.note(symbol, shape.name().to_owned(), "", false);
        Ok(shape)
    }

    /// J/(m·r²) from the mobility ratio 1 + m·r²/J.
    ///
    /// # Errors
    /// As [`number`](Self::number).
    pub fn gyration(&mut self, ratio: &Number, symbol: &str) -> Result<Rational, Fault> {
        let ratio = self.number(ratio, name("mobility_ratio", symbol, ""), Domain::AboveOne)?;
        Ok((ratio - Rational::from_integer(1.into())).recip())
    }

    /// Mass, radius and moment of inertia of a round body: a sphere, if nothing else is said.
    pub(super) fn round(
        &mut self,
        [mass, radius]: [&Number; 2],
        shape: Option<&Spanned<String>>,
        ratio: Option<&Number>,
        tag: &str,
    ) -> Result<[Rational; 3], Fault> {
        let [m, r, j, word] = ["m", "r", "j_p", "shape"].map(|symbol| format!("{symbol}{tag}"));
        let mass = self.number(mass, name("mass_kg", &m, "kg"), Domain::Positive)?;
        let radius = self.number(radius, name("radius_m", &r, "m"), Domain::Positive)?;
        let gyration = match (shape, ratio) {
            (Some(shape), None) => self.shape(shape, &word)?.gyration(),
            (None, Some(ratio)) => self.gyration(ratio, &j)?,
            (Some(shape), Some(_)) => {
                return Err(self.fault(shape.span(), "shape and mobility_ratio; give one of them"));
            }
            (None, None) => {
                self.note(&word, Shape::Sphere.name().to_owned(), "", true);
                Shape::Sphere.gyration()
            }
        };
        let inertia = &mass * &radius * &radius * gyration;
        Ok([mass, radius, inertia])
    }

    pub(super) fn rod_tip(&mut self, rod: &Rod) -> Result<TipBody<Stated>, Fault> {
        Ok(TipBody::Rod {
            mass: self.number(&rod.mass_kg, name("mass_kg", "m", "kg"), Domain::Positive)?.into(),
            length: self
                .number(&rod.length_m, name("length_m", "l", "m"), Domain::Positive)?
                .into(),
            direction: self.heading(rod.angle_deg.as_ref(), rod.half_tangent.as_ref(), "")?,
            motion: self.motion(&rod.velocity_m_s, rod.spin_rad_s.as_ref(), "0")?,
        })
    }

    pub(super) fn hinged(&mut self, pendulum: &Pendulum) -> Result<TipBody<Stated>, Fault> {
        let Pendulum { mass_kg, length_m, angles_deg, half_tangents, .. } = pendulum;
        let mass = self.number(mass_kg, name("mass_kg", "m", "kg"), Domain::Positive)?;
        let length = self.number(length_m, name("length_m", "l", "m"), Domain::Positive)?;
        let mut angle = |index: usize, tag: &str| {
            let degrees = angles_deg.as_ref().map(|pair| &pair[index]);
            self.heading(degrees, half_tangents.as_ref().map(|pair| &pair[index]), tag)
        };
        let angles = [angle(0, "1")?, angle(1, "2")?];
        let (key, speeds) = ("angular_velocities_rad_s", &pendulum.angular_velocities_rad_s);
        let speeds = self.pair(speeds, key, ["u1", "u2"], "rad/s", Domain::Any)?;
        Ok(TipBody::Pendulum { mass: mass.into(), length: length.into(), angles, speeds })
    }
}
