//! The grammar of `kane laws` and `kane collide`.

use std::path::PathBuf;

use clap::Args;

use super::Format;

pub(crate) const LAWS_EXAMPLES: &str = "\
Examples:
  kane laws                               every law against every property
  kane laws --law smith-1991              one row of it
  kane laws --property energy             one column
  kane laws --explain kane-levinson:energy
                                          the proof or the witness of one cell
  kane laws --out reports                 also writes reports/laws.html, .txt, .md and .json, and
                                          the picture reports/matrix.svg with its data, .csv

A cell is proved, with certificates that the kernel accepted; or refuted, by an exact contact, or \
of a limit by a bound, which it accepted too; or not applicable, or undecided, with the reason. docs/properties.md says what \
each property asks.
";

pub(crate) const LAWS_EXIT: &str = "\
Exit codes:
  0  every cell is decided, whatever is found
  1  a cell is undecided
  2  bad input or usage";

pub(crate) const COLLIDE_EXAMPLES: &str = "\
Examples:
  kane collide --sphere 7/2 --speed 3.9 --angle 20 --mu 0.092 --e 0.98
                                    all laws, for a solid sphere at 20° from the normal
  kane collide --body hoop --vx 1/3 --vy -1 --spin 2 --mu 0.1 --e 1/2
                                    another body, exact velocities
  kane collide --sphere 7/2 --speed 3.9 --angle 20 --mu 0.092 --e 0.98 --law smith-1991
                                    one law: every quantity, exactly and in floats
  kane collide --sphere 7/2 --speed 1 --half-tangent 1/3 --mu 0.5 --e 1 --param walton.beta0=0.3
                                    an exact direction, cos = 4/5; a law's own parameter
  kane collide double-pendulum      a shipped one: Kane's puzzle
  kane collide collision.toml       other bodies, from a file; see docs/collide-format.md
";

pub(crate) const COLLIDE_EXIT: &str = "\
Exit codes:
  0  there is an answer
  1  a check of the law asked for fails
  2  bad input or usage
  3  no law has an outcome";

#[derive(Args, Debug)]
pub(crate) struct LawsArgs {
    /// Only the law of this id; may be repeated
    #[arg(long, value_name = "ID")]
    pub(crate) law: Vec<String>,

    /// Only the property of this id; may be repeated
    #[arg(long, value_name = "ID")]
    pub(crate) property: Vec<String>,

    /// How to print the report
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,

    /// Also write every form of the report, and the picture with its data, into this directory
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,

    /// Print the proof or the witness of one cell, step by step
    #[arg(long, value_name = "LAW:PROPERTY", conflicts_with_all = ["format", "law", "property", "out"])]
    pub(crate) explain: Option<String>,
}

#[derive(Args, Debug)]
pub(crate) struct CollideArgs {
    /// A collision in a file, or the name of a shipped one, instead of the flags below
    #[arg(value_name = "FILE.toml")]
    pub(crate) file: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) body: BodyArgs,

    /// Show one law, by its id in the table: every quantity, its errors in floats, source and checks
    #[arg(long, value_name = "ID", help_heading = "Report")]
    pub(crate) law: Option<String>,

    /// Give a law's own parameter another value; may be repeated
    #[arg(long, value_name = "LAW.NAME=VALUE", help_heading = "Report")]
    pub(crate) param: Vec<String>,

    /// How to print the report
    #[arg(long, value_enum, default_value_t = Format::Text, help_heading = "Report")]
    pub(crate) format: Format,

    /// Also write NAME.html, .txt, .md, .tex and .json into this directory
    #[arg(long, value_name = "DIR", help_heading = "Report")]
    pub(crate) out: Option<PathBuf>,
}

/// A round body on a fixed plane. Every value is text here, to be read as an exact number.
#[derive(Args, Debug, Default)]
#[command(next_help_heading = "A round body meets a fixed plane")]
pub(crate) struct BodyArgs {
    /// The mobility ratio j_p = 1 + m*r^2/J, above 1: 7/2 for a solid sphere
    #[arg(long, value_name = "J_P", allow_hyphen_values = true)]
    pub(crate) sphere: Option<String>,

    /// The shape in a word, instead: sphere, hollow-sphere, disc or hoop
    #[arg(long, value_name = "SHAPE")]
    pub(crate) body: Option<String>,

    /// Coulomb's coefficient of friction, at least 0
    #[arg(long, value_name = "MU", allow_hyphen_values = true)]
    pub(crate) mu: Option<String>,

    /// The coefficient of normal restitution, from 0 to 1
    #[arg(long, value_name = "E", allow_hyphen_values = true)]
    pub(crate) e: Option<String>,

    /// The speed of the centre, m/s; with --angle or --half-tangent
    #[arg(long, value_name = "V", allow_hyphen_values = true)]
    pub(crate) speed: Option<String>,

    /// Its direction from the normal, degrees between -90 and 90
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    pub(crate) angle: Option<String>,

    /// The tangent of half that angle, between -1 and 1, for an exact direction
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    pub(crate) half_tangent: Option<String>,

    /// The velocity along the plane, m/s, instead of a speed [default: 0]
    #[arg(long, value_name = "V", allow_hyphen_values = true)]
    pub(crate) vx: Option<String>,

    /// The velocity away from the plane, m/s, at most 0
    #[arg(long, value_name = "V", allow_hyphen_values = true)]
    pub(crate) vy: Option<String>,

    /// The angular velocity from x to y, rad/s; positive spin moves the contact point along x, so that the slip is vx + spin*radius [default: 0]
    #[arg(long, value_name = "W", allow_hyphen_values = true)]
    pub(crate) spin: Option<String>,

    /// kg [default: 1]
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    pub(crate) mass: Option<String>,

    /// m [default: 1]
    #[arg(long, value_name = "R", allow_hyphen_values = true)]
    pub(crate) radius: Option<String>,
}
