//! The parts of `--help` that are made of data: the laws' parameters, ids and the names of models.

use std::ffi::OsString;

use clap::builder::{PossibleValue, PossibleValuesParser, StyledStr};
use clap::error::{ContextKind, ContextValue, Error};
use clap::{Command, CommandFactory as _, ValueHint};

use kane::algebra::syntax::visible;
use kane::impact::laws;
use kane::scene::model_names;

use super::args::{
    COLLIDE_EXAMPLES, COLLIDE_EXIT, Cli, LAWS_EXAMPLES, LAWS_EXIT, SCENE_EXAMPLES, SCENE_EXIT,
};
use super::carried::{COLLISIONS, Document, SCENES};
use super::ids::{law_ids, parameter_ids, property_ids};

/// The grammar with all of its help.
pub(super) fn command() -> Command {
    let shipped = shipped("collisions", &COLLISIONS);
    let collide = format!("{COLLIDE_EXAMPLES}\n{shipped}\n{}\n{COLLIDE_EXIT}", parameters());
    let laws = format!("{LAWS_EXAMPLES}\n{}\n{LAWS_EXIT}", rows_and_columns());
    let shipped = self::shipped("scenes", &SCENES);
    let scene = format!("{SCENE_EXAMPLES}\n\n{shipped}\n{}\n{SCENE_EXIT}", models());
    Cli::command()
        .mut_subcommand("collide", |verb| verb.after_help(collide))
        .mut_subcommand("laws", |verb| verb.after_help(laws))
        .mut_subcommand("scene", |verb| verb.after_help(scene))
}

/// The same grammar for the completions of a shell, which offer what the program knows: ids of laws,
/// properties, parameters and models, shapes, and directories after `--out`. What is typed is still
/// read by [`command`], whose messages say more than that a value is not in a list.
pub(super) fn completed() -> Command {
    let ids = |ids: Vec<&'static str>| PossibleValuesParser::new(ids);
    let parameters: Vec<&'static str> =
        parameter_ids().into_iter().map(|id| &*format!("{id}=").leak()).collect();
    let mut command = command();
    let verbs = command.get_subcommands().map(|verb| &*verb.get_name().to_owned().leak());
    let verbs: Vec<&'static str> = verbs.collect();
    for &verb in &verbs {
        command = command.mut_subcommand(verb, |verb| {
            verb.mut_args(|arg| match arg.get_id().as_str() {
                "out" => arg.value_hint(ValueHint::DirPath),
                "files" | "file" | "log" | "baseline" => arg.value_hint(ValueHint::FilePath),
                _ => arg,
            })
        });
    }
    command
        .mut_subcommand("laws", |verb| {
            verb.mut_arg("law", |arg| arg.value_parser(ids(law_ids())))
                .mut_arg("property", |arg| arg.value_parser(ids(property_ids())))
        })
        .mut_subcommand("collide", |verb| {
            verb.mut_arg("law", |arg| arg.value_parser(ids(law_ids())))
                .mut_arg("param", |arg| arg.value_parser(ids(parameters)))
                .mut_arg("body", |arg| {
                    arg.value_parser(ids(vec!["sphere", "hollow-sphere", "disc", "hoop"]))
                })
        })
        .mut_subcommand("man", |verb| verb.mut_arg("verb", |arg| arg.value_parser(ids(verbs))))
        .mut_subcommand("scene", |verb| {
            verb.mut_arg("model", |arg| arg.value_parser(ids(model_names(laws()))))
        })
}

/// The error with a better tip where a form of report that the verb has was asked for as if it were a flag, as
/// `--json`.
pub(super) fn with_format(
    mut error: Error,
    mut arguments: impl Iterator<Item = OsString>,
) -> Error {
    let asked = match error.get(ContextKind::InvalidArg) {
        Some(ContextValue::String(asked)) => asked.strip_prefix("--"),
        _ => None,
    };
    let command = command();
    let verb = arguments.find_map(|word| command.find_subcommand(word));
    let format =
        verb.and_then(|verb| verb.get_arguments().find(|arg| arg.get_long() == Some("format")));
    let forms = format.map(clap::Arg::get_possible_values).unwrap_or_default();
    if let Some(form) = forms.iter().map(PossibleValue::get_name).find(|form| asked == Some(*form))
    {
        let tip = StyledStr::from(format!("the form of a report is `--format {form}`"));
        error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![tip]));
    }
    error
}

/// The error with what was typed on one line, and all of it seen: a workflow reads lines as commands.
pub(super) fn seen(mut error: Error) -> Error {
    let text = |text: &String| visible(text).into_owned();
    let tip = |tip: &StyledStr| {
        let plain = tip.to_string();
        if visible(&plain) == plain { tip.clone() } else { text(&plain).into() }
    };
    let typed = error.context().filter_map(|(kind, value)| {
        let value = match value {
            ContextValue::String(one) => ContextValue::String(text(one)),
            ContextValue::Strings(all) => ContextValue::Strings(all.iter().map(text).collect()),
            ContextValue::StyledStrs(all) => {
                ContextValue::StyledStrs(all.iter().map(tip).collect())
            }
            _ => return None,
        };
        Some((kind, value))
    });
    for (kind, value) in typed.collect::<Vec<_>>() {
        error.insert(kind, value);
    }
    error
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
        "Models, from the least:\n{}Each is in f64, or as in routh-newton/rational in f32, f64, double-double or rational.\n",
        list(&model_names(laws()))
    )
}

/// The ids of the laws and of the properties.
fn rows_and_columns() -> String {
    format!("Laws:\n{}Properties:\n{}", list(&law_ids()), list(&property_ids()))
}

/// The shipped files that go by their names.
fn shipped(what: &str, documents: &[Document]) -> String {
    let names: Vec<&str> = documents.iter().map(|document| document.stem).collect();
    format!("Shipped {what}, which go by their names:\n{}", list(&names))
}

/// Names in lines of the width of the other help.
fn list(names: &[&str]) -> String {
    let (mut out, mut line) = (String::new(), String::from(" "));
    for (at, name) in names.iter().enumerate() {
        let comma = if at + 1 < names.len() { "," } else { "" };
        if line.len() + name.len() > 94 {
            out.push_str(&format!("{line}\n"));
            line = String::from(" ");
        }
        line.push_str(&format!(" {name}{comma}"));
    }
    out + &line + "\n"
}
