//! What the audit makes of documents: one program, so that both cores have something to do until the end.

mod counterexamples;
mod inequalities;
mod linear;
mod memo;
mod reader;
mod small_places;
mod summands;
mod telling;
