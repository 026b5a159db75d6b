//! Each rule of the kernel: a valid use is accepted, and each part of it can be wrong.

mod bounds; // limits by bounds, and along powers of t
mod derivatives; // what is near a point
mod failures; // functions as witnesses about limits
mod forged; // what is false, in each place of a certificate
mod functions; // functions as witnesses
mod limits; // what holds along a germ, and at its end
mod normal; // pieces of expressions, relations, premises
mod oracle; // values and derivatives, worked out anew
mod points; // assume, split, positive
mod polynomials; // polynomials, fractions, Descartes
mod ranges; // what is said of constants, and what a germ owes
mod sides; // sides of a limit, and its ends
mod support; // small goals, a search for small proofs
mod witnesses; // points that satisfy a state
