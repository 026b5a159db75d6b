//! The program `kane`: reads the command line, runs a verb, prints what it returns.

mod cli;

fn main() -> std::process::ExitCode {
    cli::run()
}
