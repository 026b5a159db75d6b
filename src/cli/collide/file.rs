//! Other bodies, from a TOML file; the format is documented in `docs/collide-format.md`.

use std::ops::Range;
use std::path::Path;

use serde::Deserialize;
use toml::Spanned;

use kane::collide::{Parameters, Question, System, direction};
use kane::impact::bodies::{
    Collision, Direction, DoublePendulum, Motion, PlanarBody, Shape, SphereOnPlane,
};
use kane::number::{Algebraic, Rational};
use kane::report::collision::Given;
use kane::scene::read::{Domain, Number, Pendulum, Rod, Source, load};

use super::Fault;
use super::flags::{of_floats, pairs};
use crate::cli::args::BodyArgs;
use crate::cli::input::quoted;

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct File {
    title: Option<String>,
    friction: Number,
    restitution: Number,
    sphere: Option<Sphere>,
    rod_tip: Option<Rod>,
    ellipse: Option<Ellipse>,
    planar: Option<Planar>,
    two_spheres: Option<TwoSpheres>,
    double_pendulum: Option<Pendulum>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Sphere {
    mass_kg: Number,
    radius_m: Number,
    shape: Option<Spanned<String>>,
    mobility_ratio: Option<Number>,
    velocity_m_s: [Number; 2],
    spin_rad_s: Option<Number>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TwoSpheres {
    first: Sphere,
    second: Sphere,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Ellipse {
    mass_kg: Number,
    half_axes_m: [Number; 2],
    angle_deg: Option<Number>,
    half_tangent: Option<Number>,
    velocity_m_s: [Number; 2],
    spin_rad_s: Option<Number>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Body {
    mass_kg: Number,
    inertia_kg_m2: Number,
    arm_m: [Number; 2],
    velocity_m_s: [Number; 2],
    spin_rad_s: Option<Number>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Planar {
    body: Body,
    other: Option<Body>,
}

/// What is asked by a file.
pub(super) fn question(path: &Path, flags: &BodyArgs) -> Result<Question, Fault> {
    if let Some((flag, _)) = pairs(flags).first() {
        return Err(Fault::Message(format!(
            "{flag} and {} describe two collisions; give one of them",
            path.display()
        )));
    }
    let name = path.display().to_string();
    let text = load(path).map_err(|error| format!("cannot read {name}: {error}"))?;
    let source = Source { name: &name, text: &text };
    let file: File = source.parse()?;
    let mut reader = Reader { source, given: Vec::new(), notes: Vec::new() };
    let system = reader.system(&file)?;
    let mut question = Question::new(system, Parameters::default());
    question.given = reader.given;
    question.notes.append(&mut reader.notes);
    if let Some(title) = file.title {
        question.title = title.split_whitespace().collect::<Vec<_>>().join(" ");
    }
    question.command = format!("kane collide {}", quoted(&name));
    Ok(question)
}

/// Reads exact numbers out of the file's text and keeps what was given.
struct Reader<'a> {
    source: Source<'a>,
    given: Vec<Given>,
    notes: Vec<String>,
}

impl Reader<'_> {
    fn fault(&self, span: Range<usize>, message: impl Into<String>) -> Fault {
        self.source.fault(span, message).into()
    }

    /// A fault of no place in particular.
    fn lacks(&self, message: &str) -> Fault {
        Fault::Message(format!("{}: {message}", self.source.name))
    }

    /// The number as written: TOML's own floats would not be exact.
    fn number(
        &mut self,
        number: &Number,
        (symbol, unit): (&str, &'static str),
        domain: Domain,
    ) -> Result<Rational, Fault> {
        let value = self.source.number(number, symbol, domain)?;
        let written = self.source.written(number);
        self.given.push(Given { symbol: symbol.to_owned(), value: written, unit, assumed: false });
        Ok(value)
    }

    fn pair(
        &mut self,
        pair: &[Number; 2],
        symbols: [&str; 2],
        unit: &'static str,
        domain: Domain,
    ) -> Result<[Rational; 2], Fault> {
        let [a, b] = pair;
        Ok([
            self.number(a, (symbols[0], unit), domain)?,
            self.number(b, (symbols[1], unit), domain)?,
        ])
    }

    fn motion(
        &mut self,
        velocity: &[Number; 2],
        spin: Option<&Number>,
        tag: &str,
    ) -> Result<Motion<Rational>, Fault> {
        let names = [format!("v_x{tag}"), format!("v_y{tag}"), format!("omega{tag}")];
        let [vx, vy] = self.pair(velocity, [&names[0], &names[1]], "m/s", Domain::Any)?;
        let omega = match spin {
            Some(spin) => self.number(spin, (&names[2], "rad/s"), Domain::Any)?,
            None => {
                let value = "0".to_owned();
                let [.., symbol] = names;
                self.given.push(Given { symbol, value, unit: "rad/s", assumed: true });
                Rational::default()
            }
        };
        Ok(Motion { vx, vy, omega })
    }

    /// A direction from degrees or from half a tangent.
    fn direction(
        &mut self,
        degrees: Option<&Number>,
        tangent: Option<&Number>,
        tag: &str,
    ) -> Result<Direction<Rational>, Fault> {
        match (degrees, tangent) {
            (Some(degrees), None) => {
                let symbol = format!("angle{tag}");
                // one turn and a bit: nobody means more
                let degrees = self.number(degrees, (&symbol, "°"), Domain::Within(u8::MAX))?;
                let direction = direction(&degrees);
                self.notes.push(of_floats(&direction, &symbol));
                Ok(direction)
            }
            (None, Some(tangent)) => {
                let symbol = format!("tan(angle{tag}/2)");
                let tangent = self.number(tangent, (&symbol, ""), Domain::Any)?;
                Ok(Direction::of_half_tangent(&tangent))
            }
            (Some(both), Some(_)) => {
                Err(self.fault(both.span(), "an angle in degrees and half a tangent; give one"))
            }
            (None, None) => Err(self.lacks("the direction is missing: angle_deg or half_tangent")),
        }
    }

    fn system(&mut self, file: &File) -> Result<System<Rational>, Fault> {
        let bodies = [
            file.sphere.is_some(),
            file.rod_tip.is_some(),
            file.ellipse.is_some(),
            file.planar.is_some(),
            file.two_spheres.is_some(),
            file.double_pendulum.is_some(),
        ];
        if bodies.iter().filter(|given| **given).count() != 1 {
            return Err(self.lacks(
                "exactly one of [sphere], [rod-tip], [ellipse], [planar.body], [two-spheres.first] with [two-spheres.second], and [double-pendulum] must be there",
            ));
        }
        let friction = self.number(&file.friction, ("mu", ""), Domain::NotNegative)?;
        let restitution = self.number(&file.restitution, ("e", ""), Domain::Fraction)?;
        let mut other = None;
        let body = if let Some(sphere) = &file.sphere {
            let (mass, radius, gyration) = self.round(sphere, "")?;
            let before = self.motion(&sphere.velocity_m_s, sphere.spin_rad_s.as_ref(), "0")?;
            let inertia = &mass * &radius * &radius * gyration;
            return Ok(System::Sphere(SphereOnPlane {
                mass,
                radius,
                inertia,
                friction,
                restitution,
                before,
            }));
        } else if let Some(rod) = &file.rod_tip {
            let mass = self.number(&rod.mass_kg, ("m", "kg"), Domain::Positive)?;
            let length = self.number(&rod.length_m, ("l", "m"), Domain::Positive)?;
            let direction =
                self.direction(rod.angle_deg.as_ref(), rod.half_tangent.as_ref(), "")?;
            let before = self.motion(&rod.velocity_m_s, rod.spin_rad_s.as_ref(), "0")?;
            PlanarBody::rod_tip(mass, length, &direction, before)
        } else if let Some(ellipse) = &file.ellipse {
            self.ellipse(ellipse)?
        } else if let Some(planar) = &file.planar {
            let two = planar.other.is_some();
            other = planar.other.as_ref().map(|body| self.planar(body, "2")).transpose()?;
            self.planar(&planar.body, if two { "1" } else { "0" })?
        } else if let Some(TwoSpheres { first, second }) = &file.two_spheres {
            let first = self.ball(first, "1", false)?;
            other = Some(self.ball(second, "2", true)?);
            first
        } else if let Some(pendulum) = &file.double_pendulum {
            return Ok(System::Pendulum(self.pendulum(pendulum, friction, restitution)?));
        } else {
            return Err(self.lacks("no body is there"));
        };
        Ok(System::Planar(Collision { body, other, friction, restitution }))
    }

    /// Mass, radius and J/(m·r²) of a round body.
    fn round(&mut self, body: &Sphere, tag: &str) -> Result<(Rational, Rational, Rational), Fault> {
        let mass = self.number(&body.mass_kg, (&format!("m{tag}"), "kg"), Domain::Positive)?;
        let radius = self.number(&body.radius_m, (&format!("r{tag}"), "m"), Domain::Positive)?;
        let gyration = match (&body.shape, &body.mobility_ratio) {
            (Some(word), None) => {
                let shape: Shape = word
                    .get_ref()
                    .parse()
                    .map_err(|error| self.fault(word.span(), format!("{error}")))?;
                let value = shape.name().to_owned();
                let symbol = format!("shape{tag}");
                self.given.push(Given { symbol, value, unit: "", assumed: false });
                shape.gyration()
            }
            (None, Some(ratio)) => {
                let symbol = format!("j_p{tag}");
                let ratio = self.number(ratio, (&symbol, ""), Domain::AboveOne)?;
                (ratio - Rational::from_integer(1.into())).recip()
            }
            (Some(word), Some(_)) => {
                return Err(self.fault(word.span(), "shape and mobility_ratio; give one of them"));
            }
            (None, None) => {
                let symbol = format!("shape{tag}");
                let value = Shape::Sphere.name().to_owned();
                self.given.push(Given { symbol, value, unit: "", assumed: true });
                Shape::Sphere.gyration()
            }
        };
        Ok((mass, radius, gyration))
    }

    /// One of two round bodies; the second lies below, so that its contact point is above it.
    fn ball(
        &mut self,
        ball: &Sphere,
        tag: &str,
        below: bool,
    ) -> Result<PlanarBody<Rational>, Fault> {
        let (mass, radius, gyration) = self.round(ball, tag)?;
        let before = self.motion(&ball.velocity_m_s, ball.spin_rad_s.as_ref(), tag)?;
        let inertia = &mass * &radius * &radius * gyration;
        let height = if below { radius } else { -radius };
        Ok(PlanarBody { mass, inertia, arm: [Rational::default(), height], before })
    }

    fn planar(&mut self, body: &Body, tag: &str) -> Result<PlanarBody<Rational>, Fault> {
        let name = |symbol: &str| match tag {
            "0" => symbol.to_owned(),
            tag => format!("{symbol}{tag}"),
        };
        let mass = self.number(&body.mass_kg, (&name("m"), "kg"), Domain::Positive)?;
        let inertia = self.number(&body.inertia_kg_m2, (&name("J"), "kg·m²"), Domain::Positive)?;
        let arms = [name("arm_x"), name("arm_y")];
        let arm = self.pair(&body.arm_m, [&arms[0], &arms[1]], "m", Domain::Any)?;
        let before = self.motion(&body.velocity_m_s, body.spin_rad_s.as_ref(), tag)?;
        Ok(PlanarBody { mass, inertia, arm, before })
    }

    /// An ellipse; where the root in its height is irrational, its arm is rounded to floats.
    fn ellipse(&mut self, ellipse: &Ellipse) -> Result<PlanarBody<Rational>, Fault> {
        let mass = self.number(&ellipse.mass_kg, ("m", "kg"), Domain::Positive)?;
        let axes = self.pair(&ellipse.half_axes_m, ["a", "b"], "m", Domain::Positive)?;
        let direction =
            self.direction(ellipse.angle_deg.as_ref(), ellipse.half_tangent.as_ref(), "")?;
        let before = self.motion(&ellipse.velocity_m_s, ellipse.spin_rad_s.as_ref(), "0")?;
        let body = PlanarBody::ellipse(mass.clone(), axes.clone(), &direction, before.clone());
        if let Some(body) = body {
            return Ok(body);
        }
        let root = |exact: &Rational| Algebraic::from(exact.clone());
        let body = PlanarBody::ellipse(
            root(&mass),
            [root(&axes[0]), root(&axes[1])],
            &direction.map(root),
            before.map(root),
        )
        .ok_or_else(|| self.lacks("the ellipse has no height above the obstacle"))?;
        let rounded = |number: &Algebraic| kane::number::decode(number.to_f64()).ok();
        let arm = match (rounded(&body.arm[0]), rounded(&body.arm[1])) {
            (Some(x), Some(y)) => [x, y],
            _ => return Err(self.lacks("the ellipse's arm is beyond the range of f64")),
        };
        self.notes.push(
            "The height of the centre is irrational: the arm of the contact point is the pair of nearest floats, taken exactly."
                .to_owned(),
        );
        let [a, b] = axes;
        let inertia = (&a * &a + &b * &b) * &mass / Rational::from_integer(4.into());
        Ok(PlanarBody { mass, inertia, arm, before })
    }

    fn pendulum(
        &mut self,
        pendulum: &Pendulum,
        friction: Rational,
        restitution: Rational,
    ) -> Result<DoublePendulum<Rational>, Fault> {
        let mass = self.number(&pendulum.mass_kg, ("m", "kg"), Domain::Positive)?;
        let length = self.number(&pendulum.length_m, ("l", "m"), Domain::Positive)?;
        let (degrees, tangents) = (&pendulum.angles_deg, &pendulum.half_tangents);
        let mut angle = |index: usize, tag: &str| {
            let degrees = degrees.as_ref().map(|pair| &pair[index]);
            self.direction(degrees, tangents.as_ref().map(|pair| &pair[index]), tag)
        };
        let angles = [angle(0, "1")?, angle(1, "2")?];
        let speeds = &pendulum.angular_velocities_rad_s;
        let before = self.pair(speeds, ["u1", "u2"], "rad/s", Domain::Any)?;
        Ok(DoublePendulum { mass, length, angles, before, friction, restitution })
    }
}
