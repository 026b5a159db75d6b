//! Slips of the pen in names.

/// Whether a separator stands at an end of the name or beside another one, where a letter was lost or is too many.
pub(crate) fn has_gap(name: &str) -> bool {
    let separates = |c: char| matches!(c, '_' | '.' | '-');
    let twice = name.chars().zip(name.chars().skip(1)).any(|(a, b)| separates(a) && separates(b));
    twice || name.starts_with(separates) || name.ends_with(separates)
}

/// Whether one letter more, less or changed, or two neighbours exchanged, make one word of the other.
pub(crate) fn is_slip_for(written: &str, word: &str) -> bool {
    let (a, b) = if written.len() < word.len() { (word, written) } else { (written, word) };
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let head = a.iter().zip(b).take_while(|(a, b)| a == b).count();
    match a.len() - b.len() {
        0 => {
            let exchanged = || {
                a[head] == b[head + 1] && a[head + 1] == b[head] && a[head + 2..] == b[head + 2..]
            };
            head < a.len() && (a[head + 1..] == b[head + 1..] || head + 1 < a.len() && exchanged())
        }
        1 => a[head + 1..] == b[head..],
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_letter_or_two_neighbours_are_a_slip() {
        for slip in ["omgea", "omga", "omegaa", "omeha", "mega", "oemga", "omeag"] {
            assert!(is_slip_for(slip, "omega") && is_slip_for("omega", slip), "{slip}");
        }
        for other in ["omega", "omg", "omage", "alpha", "egamo", ""] {
            assert!(!is_slip_for(other, "omega"), "{other}");
        }
    }

    #[test]
    fn a_gap_is_at_an_end_or_between_separators() {
        for name in ["mu_", "_mu", "vx__pre", "-vx", "v._x"] {
            assert!(has_gap(name), "{name}");
        }
        for name in ["mu", "vx_pre", "body2.mass", "v_n'", ""] {
            assert!(!has_gap(name), "{name}");
        }
    }
}
