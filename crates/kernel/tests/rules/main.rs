//! Each rule of the kernel: a valid use is accepted, and each part of it can be wrong.

mod derivatives; // what is near a point
mod forged; // what is false, in each place of a certificate
mod functions; // functions as witnesses
mod limits; // sides, germs, ends
mod normal; // pieces of expressions, relations, premises
mod oracle; // values and derivatives, worked out anew
mod points; // assume, split, positive
mod polynomials; // polynomials, fractions, Descartes
mod support; // small goals, a search for small proofs
mod witnesses; // points that satisfy a state
