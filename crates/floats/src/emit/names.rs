//! Names in source code: those that a file makes up keep out of the way of all others.

use std::collections::{HashMap, HashSet};

use crate::Core;

/// Words of Rust, C and Python, and what the code around formulas calls something: an argument of that name would not
/// compile, or be taken for what it is not. Names in capitals are left out here.
const TAKEN: &str = "\
    abs abstract alignas alignof and ArithmeticError as assert async auto await become bool box break case char \
    class const constexpr continue crate def default del do double dyn elif else enum Err Exact exact_sign except \
    extern f32 f64 fabs fabsf False false final finally float float32 fma fmaf fmax fmaxf fmin fminf fn for \
    Fraction from gen global goto if impl import in inf inline int is isfinite kd ke kpool lambda let linux long \
    loop macro main match max min mod move mut None nonlocal not nullptr Ok or override pass priv pub raise ref \
    register restrict return root_sign Self self short signed sizeof Some sqrt sqrtf static static_assert struct \
    super switch thread_local trait True true try type typedef typeof typeof_unqual uint32_t union unix unsafe \
    unsigned unsized use ValueError virtual void volatile where while with yield";

/// A name that all three languages take, and that is none of what the code around it calls something.
pub(crate) fn identifier(name: &str) -> String {
    let mut text: String =
        name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    if !text.starts_with(|c: char| c.is_ascii_alphabetic()) {
        text.insert(0, 'v');
    }
    // temporaries are one of these and a number
    let temporary = ["t", "kt", "ke", "kn"].iter().any(|start| {
        text.strip_prefix(start).is_some_and(|rest| rest.bytes().all(|b| b.is_ascii_digit()))
    });
    let library = text.starts_with("kane_");
    if temporary || library || TAKEN.split(' ').any(|taken| taken == text) {
        text.push('_');
    }
    text
}

/// The same for an argument: what is in capitals is a constant or a macro, and taken, too.
fn argument(name: &str) -> String {
    let text = identifier(name);
    let capitals = text.bytes().filter(u8::is_ascii_uppercase).count();
    if capitals > 2 && !text.bytes().any(|b| b.is_ascii_lowercase()) { text + "_" } else { text }
}

/// What the arguments of a formula are called: no two alike.
pub(crate) fn arguments(core: &Core) -> Vec<String> {
    let mut known = HashSet::new();
    // of each name, the last number that was tried
    let mut numbers: HashMap<String, usize> = HashMap::new();
    let mut name = |of: &crate::Argument| {
        let first = argument(&of.name);
        let number = numbers.entry(first.clone()).or_insert(1);
        let mut name = first.clone();
        while !known.insert(name.clone()) {
            *number += 1;
            name = format!("{first}_{number}");
        }
        name
    };
    core.arguments.iter().map(&mut name).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::decision::certified;
    use crate::{Language, Precision, emit, fpcore};

    /// The names in a code, but for those of comments, of methods and of what stands in a path.
    fn named(code: &str) -> BTreeSet<&str> {
        let lines = code.lines().filter(|line| !line.starts_with(['#', '/']));
        let is_inside = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let mut found = BTreeSet::new();
        for line in lines {
            let mut before = ' ';
            for word in line.split_inclusive(|c| !is_inside(c)) {
                let name = word.trim_end_matches(|c| !is_inside(c));
                let is_number = name.starts_with(|c: char| c.is_ascii_digit());
                if !name.is_empty() && !is_number && !matches!(before, '.' | ':' | '>') {
                    found.insert(name);
                }
                before = word.chars().next_back().unwrap_or(' ');
            }
        }
        found
    }

    #[test]
    fn no_argument_is_called_as_the_code_around_it_calls_something() {
        let text = "(FPCore (x9 y9) :name \"f9\" (if (or (and (< (* x9 y9) 1e400) (not (<= (sqrt x9) (fabs y9)))) \
            (== (fmin x9 (/ y9 3)) (fmax (fma x9 y9 0.1) (- y9 x9)))) (sqrt (fabs (fma x9 y9 (fmin x9 y9)))) \
            (if (< (* x9 x9) (fmax y9 x9)) 1e400 (- 1e400))))";
        let core = fpcore::read("t.fpcore", text).expect("it is well formed").remove(0);
        let mut seen = 0;
        for language in Language::ALL {
            for precision in Precision::ALL {
                let certified = certified(&core, precision, language).expect("it compares");
                for code in [emit(&core, precision, language), certified] {
                    for name in named(&code).into_iter().filter(|name| !name.contains('9')) {
                        seen += 1;
                        assert_ne!(argument(name), name, "{language:?}: {code}");
                    }
                }
            }
        }
        assert!(seen > 200, "{seen}");
    }

    #[test]
    fn no_two_arguments_are_called_alike() {
        let text = "(FPCore (a-b a+b a_b_2 kt1 kt1_ t2 t2_ HALF) (+ a-b a+b))";
        let core = fpcore::read("t.fpcore", text).expect("it is well formed").remove(0);
        let names = ["a_b", "a_b_2", "a_b_2_2", "kt1_", "kt1__2", "t2_", "t2__2", "HALF_"];
        assert_eq!(arguments(&core), names);
    }
}
