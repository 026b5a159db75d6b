//! The laws from outside: what they refuse, and what their catalogue says. One program.

mod catalogue;
mod inputs;
