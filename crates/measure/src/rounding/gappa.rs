//! Bounds on rounding errors as scripts for Gappa.

use std::fmt::Write as _;

use kane_number::{Rational, System};

use super::{Piece, RoundingBound};

impl RoundingBound {
    /// The bound on all pieces in one script for Gappa, which may give up on so many; it is asked
    /// [one at a time](Self::gappa_questions).
    #[must_use]
    pub fn gappa(&self) -> String {
        script(self, &self.pieces)
    }

    /// Scripts, one a piece, that Gappa accepts only if it finds a proof.
    #[must_use]
    pub fn gappa_questions(&self) -> Vec<String> {
        self.pieces.chunks(1).map(|piece| script(self, piece)).collect()
    }
}

fn script(bound: &RoundingBound, pieces: &[Piece]) -> String {
    let format = if bound.system == System::F32 { "ieee_32" } else { "ieee_64" };
    let last = match bound.before_last_rounding {
        true => ", before the last rounding, which adds half an ulp",
        false => "",
    };
    let mut script = format!(
        "# {quantity} of {law} from alpha in {system}, as {methods}:\n\
         # within {ulps} ulp of the exact value{last}.\n\
         # One premise a piece of the domain on which the ulp does not change.\n\n\
         @rnd = float<{format}, ne>;\n\
         a = rnd(alpha);\n{operations}\n{exact}\n\n{{\n",
        quantity = bound.quantity,
        law = bound.law,
        system = bound.system,
        methods = bound.methods.join(" and "),
        ulps = bound.ulps,
        operations = bound.operations,
        exact = bound.exact,
    );
    for (index, piece) in pieces.iter().enumerate() {
        let and = if index == 0 { "   " } else { "/\\ " };
        writeln!(script, "{and}({})", premise(bound, piece)).expect("a string takes all");
    }
    script.push_str("}\n");
    if !bound.hints.is_empty() {
        write!(script, "\n{}\n", bound.hints).expect("a string takes all");
    }
    script
}

fn premise(bound: &RoundingBound, piece: &Piece) -> String {
    let [from, to] = [&piece.from, &piece.to].map(dyadic);
    let most = dyadic(&(&bound.ulps * &piece.ulp));
    format!("a in [{from}, {to}] -> |{}| <= {most}", bound.error)
}

/// m·2^e as `mbe`; every number of a bound is one.
fn dyadic(number: &Rational) -> String {
    let halvings = number.denom().bits().saturating_sub(1);
    let doublings = number.numer().trailing_zeros().unwrap_or(0);
    let odd = number.numer() >> doublings;
    match (halvings, doublings) {
        (0, 0) => odd.to_string(),
        (0, up) => format!("{odd}b{up}"),
        (down, _) => format!("{}b-{down}", number.numer()),
    }
}
