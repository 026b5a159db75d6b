//! The best forms as source code, one file a language.

use kane_floats::{Core, Language, Precision, emit, fpcore};
use kane_measure::certify::Account;

use super::best;

/// Files by the end of their names: Rust, C, Python, and FPCore.
#[must_use]
pub fn sources(accounts: &[Account]) -> Vec<(&'static str, String)> {
    let narrow = accounts.iter().any(|account| best(account).1 == Precision::F32);
    let in_language = |language: Language| {
        let one = |(index, account): (usize, &Account)| {
            let (form, precision) = best(account);
            emit(&called(form, &account.label, index), precision, language)
        };
        let functions: Vec<String> = accounts.iter().enumerate().map(one).collect();
        let head = match language {
            Language::Rust => "",
            Language::C => "#include <math.h>\n\n",
            Language::Python if narrow => "from math import *\nfrom numpy import float32\n\n",
            Language::Python => "from math import *\n\n",
        };
        format!("{head}{}\n", functions.join("\n\n"))
    };
    let cores: Vec<String> =
        accounts.iter().map(|account| fpcore::write(best(account).0)).collect();
    vec![
        ("rs", in_language(Language::Rust)),
        ("c", in_language(Language::C)),
        ("py", in_language(Language::Python)),
        ("fpcore", format!("{}\n", cores.join("\n\n"))),
    ]
}

/// The formula under a name of its own: two formulas may be called the same.
fn called(core: &Core, label: &str, index: usize) -> Core {
    let name = core.name.as_deref().unwrap_or(label);
    Core { name: Some(format!("{name}_{}", index + 1)), ..core.clone() }
}
