//! What the audit makes of documents: one program, so that both cores have something to do until the end; what is held to a
//! time or to room is alone in `budget` and `reader`.

mod contacts;
mod counterexamples;
mod dollars;
mod inequalities;
mod linear;
#[path = "../../../../tests/shared/many.rs"]
#[expect(dead_code, reason = "here are no random statements")]
mod many;
mod memo;
mod powers;
mod sides;
mod small_places;
mod summands;
mod telling;
mod written_out;
