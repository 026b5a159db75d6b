//! `kane completions` and `kane man`: what a shell and `man` want to know, made from the grammar.

use std::io;

use clap::Command;
use clap_complete::Shell;
use clap_mangen::Man;

use super::args::{CompletionsArgs, ManArgs};
use super::delivery::{self, Written};
use super::ids::unknown;
use super::{Outcome, bad_input, help, output};

/// Prints the completions of a shell.
pub(super) fn completions(args: &CompletionsArgs) -> Outcome {
    let mut script = Vec::new();
    let mut command = help::completed();
    clap_complete::generate(args.shell, &mut command, "kane", &mut script);
    if args.shell == Shell::Fish {
        script.extend(fish_values(&command).into_bytes());
    }
    printed(&script)
}

/// What may stand without a flag, for fish: `clap_complete` tells it of flags alone.
fn fish_values(command: &Command) -> String {
    let mut out = String::new();
    for verb in command.get_subcommands() {
        for values in verb.get_positionals().map(clap::Arg::get_possible_values) {
            let names: Vec<&str> =
                values.iter().map(clap::builder::PossibleValue::get_name).collect();
            if !names.is_empty() {
                let (verb, names) = (verb.get_name(), names.join(" "));
                let asked = format!("__fish_kane_using_subcommand {verb}");
                out.push_str(&format!("complete -c kane -n \"{asked}\" -f -a \"{names}\"\n"));
            }
        }
    }
    out
}

/// Prints a page, or writes all.
pub(super) fn man(args: &ManArgs) -> Outcome {
    let pages = match pages() {
        Ok(pages) => pages,
        Err(error) => return bad_input(&format!("the pages cannot be made: {error}")),
    };
    if let Some(dir) = &args.out {
        let page = |(name, text): &(String, String)| Written::manual(format!("{name}.1"), text);
        let files: Vec<Written> = pages.iter().map(page).collect();
        return match delivery::write(dir, &[], &files) {
            Ok(()) => Outcome::AsExpected,
            Err(why) => bad_input(&why.to_string()),
        };
    }
    let wanted = args.verb.as_ref().map_or("kane".to_owned(), |verb| format!("kane-{verb}"));
    match pages.iter().find(|(name, _)| *name == wanted) {
        Some((_, text)) => printed(text.as_bytes()),
        None => {
            let verbs: Vec<&str> =
                pages.iter().filter_map(|(name, _)| name.strip_prefix("kane-")).collect();
            bad_input(&unknown("verb", args.verb.as_deref().unwrap_or_default(), &verbs))
        }
    }
}

/// Generated text, which has no colours, as it is: roff and shells need what a terminal would obey.
fn printed(text: &[u8]) -> Outcome {
    match output::to_stdout(&String::from_utf8_lossy(text)) {
        Ok(()) => Outcome::AsExpected,
        Err(error) => bad_input(&format!("cannot print: {error}")),
    }
}

/// The pages with their names, the program's first.
fn pages() -> io::Result<Vec<(String, String)>> {
    let mut command = help::command().disable_help_subcommand(true);
    command.build();
    let mut verbs: Vec<&Command> =
        command.get_subcommands().filter(|verb| !verb.is_hide_set()).collect();
    // a verb whose help is made of data has moved to the end
    verbs.sort_by_key(|verb| verb.get_display_order());
    let verbs = verbs.into_iter().map(|verb| (format!("kane-{}", verb.get_name()), verb));
    let all = std::iter::once(("kane".to_owned(), &command)).chain(verbs);
    all.map(|(name, command)| page(&name, command).map(|text| (name, text))).collect()
}

/// What every section of `clap_mangen` begins with: how an apostrophe is written.
const PREAMBLE: &str = ".ie \\n(.g .ds Aq \\(aq\n.el .ds Aq '\n";

/// One page. Of what follows the options, paragraphs are running text; what is indented are lines, as examples are.
fn page(name: &str, command: &Command) -> io::Result<String> {
    let source = concat!("kane ", env!("CARGO_PKG_VERSION"));
    let man = Man::new(command.clone()).title(name.to_uppercase()).source(source);
    let mut out = Vec::new();
    man.render_title(&mut out)?;
    man.render_name_section(&mut out)?;
    man.render_synopsis_section(&mut out)?;
    man.render_description_section(&mut out)?;
    man.render_options_section(&mut out)?;
    if command.has_subcommands() {
        man.render_subcommands_section(&mut out)?;
    }
    // each section begins with what one page needs once
    let sections = String::from_utf8_lossy(&out).replace(PREAMBLE, "");
    let mut text = format!("{PREAMBLE}{sections}");
    if let Some(notes) = command.get_after_help() {
        text.push_str(".SH NOTES\n.nf\n");
        for line in notes.to_string().lines() {
            let line_of_list = line.is_empty() || line.starts_with(' ');
            let line = escaped(line);
            text.push_str(&if line_of_list { line + "\n" } else { format!(".fi\n{line}\n.nf\n") });
        }
        text.push_str(".fi\n");
    }
    Ok(text)
}

/// A line of text as roff takes it: nothing in it is a request or an escape.
fn escaped(line: &str) -> String {
    let text = line.replace('\\', "\\e").replace('-', "\\-").replace('\'', "\\(aq");
    let text = text.replace('`', "\\(ga").replace('~', "\\(ti").replace('^', "\\(ha");
    if text.starts_with('.') { format!("\\&{text}") } else { text }
}

#[cfg(test)]
mod tests {
    use super::escaped;

    #[test]
    fn no_line_of_help_is_a_request_of_roff() {
        assert_eq!(escaped(".TH a-b"), "\\&.TH a\\-b");
        assert_eq!(escaped("'x\\y' ~`"), "\\(aqx\\ey\\(aq \\(ti\\(ga");
    }
}
