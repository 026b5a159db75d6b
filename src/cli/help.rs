//! The parts of `--help` that are made of data: the laws' parameters and the names of models.

use clap::{Command, CommandFactory as _};

use kane::impact::laws;
use kane::scene::model_names;

use super::args::{COLLIDE_EXAMPLES, COLLIDE_EXIT, Cli, SCENE_EXAMPLES, SCENE_EXIT};

/// The grammar with all of its help.
pub(super) fn command() -> Command {
    let collide = format!("{COLLIDE_EXAMPLES}\n{}\n{COLLIDE_EXIT}", parameters());
    let scene = format!("{SCENE_EXAMPLES}\n{}\n{SCENE_EXIT}", models());
    Cli::command()
        .mut_subcommand("collide", |verb| verb.after_help(collide))
        .mut_subcommand("scene", |verb| verb.after_help(scene))
}

/// A line for every parameter of every law.
fn parameters() -> String {
    let mut out = String::from(
        "Numbers are exact: 0.092 is 23/250, and 1/3 is a third. Parameters of laws:\n",
    );
    for law in laws() {
        for parameter in law.info.parameters {
            let name = format!("{}.{} = {}", law.info.id, parameter.name, parameter.default());
            let (meaning, domain) = (parameter.meaning, parameter.domain());
            out.push_str(&format!("  {name:<32}{meaning}, {domain}\n"));
        }
    }
    out
}

/// The names of the models.
fn models() -> String {
    format!(
        "Models, from the least:\n  {}\neach in f64, or as in routh-newton/rational in f32, f64, double-double or rational.\n",
        model_names(laws()).join(", ")
    )
}
