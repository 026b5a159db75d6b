//! The program `kane`: reads the command line, runs a verb, prints what it returns.

mod cli;

/// Polynomials and their coefficients are many small pieces of memory that live briefly: a quarter of an audit was the
/// system's own allocator.
#[global_allocator]
static MEMORY: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> std::process::ExitCode {
    cli::run()
}
