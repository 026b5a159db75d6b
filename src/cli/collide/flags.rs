//! A round body on a plane, from flags.

use kane::collide::{Given, Question, System};
use kane::impact::bodies::{Direction, Motion, Shape, SphereOnPlane};
use kane::number::Rational;
use kane::scene::read::{Domain, Flags, Reader, TURNED, name, of_the_paper};

use super::Fault;
use crate::cli::args::BodyArgs;
use crate::cli::input::quoted;

/// What is asked by the flags.
pub(super) fn question(args: &BodyArgs) -> Result<Question, Fault> {
    let flags = Flags::new(&pairs(args));
    let mut reader = Reader::new(flags.source());
    let gyration = gyration(&mut reader, &flags)?;
    let (m, r) = (name("", "m", "kg"), name("", "r", "m"));
    let mass = reader.number_or(flags.get("--mass"), m, Domain::Positive, 1)?;
    let radius = reader.number_or(flags.get("--radius"), r, Domain::Positive, 1)?;
    let (vx, vy) = velocity(&mut reader, &flags)?;
    let spin = name("", "omega0", "rad/s");
    let omega = reader.number_or(flags.get("--spin"), spin, Domain::Any, 0)?;
    let mu = flags.get("--mu").ok_or_else(|| format!("--mu is missing: {MU}"))?;
    let friction = reader.number(mu, name("", "mu", ""), Domain::NotNegative)?;
    let e = flags.get("--e").ok_or_else(|| format!("--e is missing: {E}"))?;
    let restitution = reader.number(e, name("", "e", ""), Domain::Fraction)?;
    let sphere = SphereOnPlane {
        inertia: &mass * &radius * &radius * gyration,
        mass,
        radius,
        friction,
        restitution,
        before: of_the_paper(Motion { vx, vy, omega }),
    };
    let mut question = Question::new(System::Sphere(sphere));
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

/// J/(m·r²).
fn gyration(reader: &mut Reader<'_>, flags: &Flags) -> Result<Rational, Fault> {
    match (flags.get("--sphere"), flags.word("--body")) {
        (Some(_), Some(_)) => {
            Err("--sphere and --body say the same in two ways; give one of them".to_owned().into())
        }
        (Some(ratio), None) => {
            let text = ratio.get_ref().as_str().unwrap_or_default();
            if text.parse::<Shape>().is_ok() {
                return Err(Fault::Message(format!(
                    "--sphere takes the mobility ratio, as in --sphere 7/2; for a word, write --body {text}"
                )));
            }
            Ok(reader.gyration(ratio, "j_p")?)
        }
        (None, Some(word)) => {
            let shape = reader.shape(&word, "body")?;
            let value = shape.mobility_ratio().to_string();
            reader.given.push(Given { symbol: "j_p".to_owned(), value, unit: "", assumed: false });
            Ok(shape.gyration())
        }
        (None, None) => Err(Fault::Message(
            "what collides? Give --sphere J_P (7/2 for a solid sphere), --body SHAPE, or a FILE.toml; see kane collide --help".to_owned(),
        )),
    }
}

/// v_x0 and v_y0.
fn velocity(reader: &mut Reader<'_>, flags: &Flags) -> Result<(Rational, Rational), Fault> {
    let given = |names: &[&str]| names.iter().any(|name| flags.get(name).is_some());
    let polar = given(&["--speed", "--angle", "--half-tangent"]);
    match (given(&["--vx", "--vy"]), polar) {
        (true, true) => {
            Err("give either --speed with its direction, or --vx and --vy".to_owned().into())
        }
        (false, false) => Err(Fault::Message(
            "how fast? Give --speed with --angle (or --half-tangent), or --vx and --vy".to_owned(),
        )),
        (true, false) => {
            let along = name("", "v_x0", "m/s");
            let vx = reader.number_or(flags.get("--vx"), along, Domain::Any, 0)?;
            let missing =
                || "--vy is missing: the velocity away from the plane, at most 0".to_owned();
            let given = flags.get("--vy").ok_or_else(missing)?;
            let vy = reader.number(given, name("", "v_y0", "m/s"), Domain::Any)?;
            if vy > Rational::default() {
                let value = given.get_ref().as_str().unwrap_or_default();
                return Err(Fault::Message(format!("--vy is {value}, but {TURNED}")));
            }
            Ok((vx, vy))
        }
        (false, true) => {
            let missing = || "--speed is missing: the speed of the centre, at least 0".to_owned();
            let speed = flags.get("--speed").ok_or_else(missing)?;
            let speed = reader.number(speed, name("", "v", "m/s"), Domain::NotNegative)?;
            let Direction { cos, sin } = direction(reader, flags)?;
            Ok((&speed * sin, -(speed * cos)))
        }
    }
}

fn direction(reader: &mut Reader<'_>, flags: &Flags) -> Result<Direction<Rational>, Fault> {
    match (flags.get("--angle"), flags.get("--half-tangent")) {
        (Some(_), Some(_)) => Err(Fault::Message(
            "--angle and --half-tangent are both directions; give one of them".to_owned(),
        )),
        (None, None) => Err(Fault::Message(
            "--angle is missing: the direction of the speed from the normal, in degrees (or --half-tangent)"
                .to_owned(),
        )),
        (Some(degrees), None) => {
            Ok(reader.degrees(degrees, name("", "angle", "°"), Domain::Within(90))?)
        }
        (None, Some(tangent)) => {
            let symbol = name("", "tan(angle/2)", "");
            Ok(reader.half_tangent(tangent, symbol, Domain::Within(1))?)
        }
    }
}
