//! A round body on a plane, from flags.

use kane::collide::{Parameters, Question, System, direction};
use kane::impact::bodies::{Direction, Motion, Shape, SphereOnPlane};
use kane::number::{Algebraic, Rational};
use kane::report::collision::Given;

use crate::cli::args::BodyArgs;
use crate::cli::input::quoted;
use kane::scene::read::{Domain, read_in};

/// What is asked by the flags.
pub(super) fn question(args: &BodyArgs) -> Result<Question, String> {
    let mut reader = Reader { given: Vec::new(), notes: Vec::new() };
    let gyration = reader.gyration(args)?;
    let mass = reader.or("mass", "m", "kg", args.mass.as_deref(), Domain::Positive, 1)?;
    let radius = reader.or("radius", "r", "m", args.radius.as_deref(), Domain::Positive, 1)?;
    let (vx, vy) = reader.velocity(args)?;
    let omega = reader.or("spin", "omega0", "rad/s", args.spin.as_deref(), Domain::Any, 0)?;
    let friction = reader.needed("mu", "mu", args.mu.as_deref(), Domain::NotNegative, MU)?;
    let restitution = reader.needed("e", "e", args.e.as_deref(), Domain::Fraction, E)?;
    let sphere = SphereOnPlane {
        inertia: &mass * &radius * &radius * gyration,
        mass,
        radius,
        friction,
        restitution,
        before: Motion { vx, vy, omega },
    };
    let mut question = Question::new(System::Sphere(sphere), Parameters::default());
    question.given = reader.given;
    question.notes.append(&mut reader.notes);
    question.command = command(args);
    Ok(question)
}

const MU: &str = "Coulomb's coefficient of friction, at least 0";
const E: &str = "the coefficient of restitution, from 0 to 1";

/// The flags that were given, in a fixed order.
pub(super) fn pairs(args: &BodyArgs) -> Vec<(&'static str, &str)> {
    [
        ("--sphere", &args.sphere),
        ("--body", &args.body),
        ("--mass", &args.mass),
        ("--radius", &args.radius),
        ("--speed", &args.speed),
        ("--angle", &args.angle),
        ("--half-tangent", &args.half_tangent),
        ("--vx", &args.vx),
        ("--vy", &args.vy),
        ("--spin", &args.spin),
        ("--mu", &args.mu),
        ("--e", &args.e),
    ]
    .into_iter()
    .filter_map(|(flag, value)| value.as_deref().map(|value| (flag, value)))
    .collect()
}

/// The command that asks this again.
fn command(args: &BodyArgs) -> String {
    let mut command = "kane collide".to_owned();
    for (flag, value) in pairs(args) {
        command.push_str(&format!(" {flag} {}", quoted(value)));
    }
    command
}

struct Reader {
    given: Vec<Given>,
    notes: Vec<String>,
}

impl Reader {
    fn note(&mut self, symbol: &str, value: &str, unit: &'static str, assumed: bool) {
        let (symbol, value) = (symbol.to_owned(), value.to_owned());
        self.given.push(Given { symbol, value, unit, assumed });
    }

    fn read(
        &mut self,
        (flag, symbol, unit): (&str, &str, &'static str),
        text: &str,
        domain: Domain,
    ) -> Result<Rational, String> {
        let value = read_in(text, domain).map_err(|error| format!("--{flag} {error}"))?;
        self.note(symbol, text, unit, false);
        Ok(value)
    }

    /// A flag with a default.
    fn or(
        &mut self,
        flag: &str,
        symbol: &str,
        unit: &'static str,
        text: Option<&str>,
        domain: Domain,
        default: u8,
    ) -> Result<Rational, String> {
        match text {
            Some(text) => self.read((flag, symbol, unit), text, domain),
            None => {
                self.note(symbol, &default.to_string(), unit, true);
                Ok(Rational::from_integer(default.into()))
            }
        }
    }

    /// A flag without one.
    fn needed(
        &mut self,
        flag: &str,
        symbol: &str,
        text: Option<&str>,
        domain: Domain,
        meaning: &str,
    ) -> Result<Rational, String> {
        match text {
            Some(text) => self.read((flag, symbol, ""), text, domain),
            None => Err(format!("--{flag} is missing: {meaning}")),
        }
    }

    /// J/(m·r²).
    fn gyration(&mut self, args: &BodyArgs) -> Result<Rational, String> {
        match (&args.sphere, &args.body) {
            (Some(_), Some(_)) => Err(
                "--sphere and --body say the same in two ways; give one of them".to_owned(),
            ),
            (Some(text), None) => {
                if text.parse::<Shape>().is_ok() {
                    return Err(format!(
                        "--sphere takes the mobility ratio, as in --sphere 7/2; for a word, write --body {text}"
                    ));
                }
                let ratio = self.read(("sphere", "j_p", ""), text, Domain::AboveOne)?;
                Ok((ratio - Rational::from_integer(1.into())).recip())
            }
            (None, Some(word)) => {
                let shape: Shape = word.parse().map_err(|error| format!("--body: {error}"))?;
                self.note("body", shape.name(), "", false);
                self.note("j_p", &shape.mobility_ratio().to_string(), "", false);
                Ok(shape.gyration())
            }
            (None, None) => Err(
                "what collides? Give --sphere J_P (7/2 for a solid sphere), --body SHAPE, or a FILE.toml; see kane collide --help".to_owned(),
            ),
        }
    }

    /// v_x0 and v_y0.
    fn velocity(&mut self, args: &BodyArgs) -> Result<(Rational, Rational), String> {
        let along = args.vx.is_some() || args.vy.is_some();
        let polar = args.speed.is_some() || args.angle.is_some() || args.half_tangent.is_some();
        match (along, polar) {
            (true, true) => {
                Err("give either --speed with its direction, or --vx and --vy".to_owned())
            }
            (false, false) => {
                Err("how fast? Give --speed with --angle (or --half-tangent), or --vx and --vy"
                    .to_owned())
            }
            (true, false) => {
                let vx = self.or("vx", "v_x0", "m/s", args.vx.as_deref(), Domain::Any, 0)?;
                let Some(vy) = &args.vy else {
                    return Err(
                        "--vy is missing: the velocity into the plane, at least 0".to_owned()
                    );
                };
                let vy = self
                    .read(("vy", "v_y0", "m/s"), vy, Domain::NotNegative)
                    .map_err(|error| match vy.starts_with('-') && error.contains("at least") {
                        true => format!("{error}: y points into the plane, and a body that moves away does not collide"),
                        false => error,
                    })?;
                Ok((vx, vy))
            }
            (false, true) => {
                let Some(speed) = &args.speed else {
                    return Err(
                        "--speed is missing: the speed of the centre, at least 0".to_owned()
                    );
                };
                let speed = self.read(("speed", "v", "m/s"), speed, Domain::NotNegative)?;
                let Direction { cos, sin } = self.direction(args)?;
                Ok((&speed * sin, speed * cos))
            }
        }
    }

    fn direction(&mut self, args: &BodyArgs) -> Result<Direction<Rational>, String> {
        match (&args.angle, &args.half_tangent) {
            (Some(_), Some(_)) => {
                Err("--angle and --half-tangent are both directions; give one of them".to_owned())
            }
            (None, None) => Err(
                "--angle is missing: the direction of the speed from the normal, in degrees (or --half-tangent)"
                    .to_owned(),
            ),
            (Some(text), None) => {
                let degrees = self.read(("angle", "angle", "°"), text, Domain::Within(90))?;
                let direction = direction(&degrees);
                self.notes.push(of_floats(&direction, "angle"));
                Ok(direction)
            }
            (None, Some(text)) => {
                let name = ("half-tangent", "tan(angle/2)", "");
                let tangent = self.read(name, text, Domain::Within(1))?;
                Ok(Direction::of_half_tangent(&tangent))
            }
        }
    }
}

/// Says what stands for an angle in degrees.
pub(super) fn of_floats(direction: &Direction<Rational>, angle: &str) -> String {
    let float = |x: &Rational| Algebraic::from(x.clone()).to_f64();
    format!(
        "{angle}: the direction is the float pair cos = {}, sin = {}, taken exactly.",
        float(&direction.cos),
        float(&direction.sin)
    )
}
