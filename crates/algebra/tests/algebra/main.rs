//! Polynomials, rational functions and ideals, held against other ways to the same answer.

mod division;
mod ideal_gate;
mod notation;
mod rational;
mod squares;
