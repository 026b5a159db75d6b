//! The best forms as source code, one file a language.

use kane_floats::decision::{certified, function_name, prelude};
use kane_floats::{Core, Language, Precision, emit, fpcore, gappa};
use kane_measure::certify::{Account, Certified};

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
        let mut functions: Vec<String> = accounts.iter().enumerate().map(one).collect();
        let decided: Vec<String> = accounts
            .iter()
            .enumerate()
            .filter_map(|(index, account)| {
                let (form, precision) = best(account);
                certified(&called(form, &account.label, index), precision, language)
            })
            .collect();
        if !decided.is_empty() {
            functions.insert(0, prelude(language).trim_end().to_owned());
            functions.extend(decided);
        }
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

/// The bounds as questions to Gappa, by the end of their names: the number of the formula and the format. What Gappa
/// cannot be asked is left out.
#[must_use]
pub fn questions(accounts: &[Account]) -> Vec<(String, String)> {
    let one = |(index, account): (usize, &Account)| {
        let asked = |found: &Certified| {
            let bound = found.absolute.bound;
            let script = match found.precision {
                Precision::F32 => gappa::<f32>(&account.core, bound),
                Precision::F64 => gappa::<f64>(&account.core, bound),
            };
            Some((format!("{}-{}.g", index + 1, found.precision.name()), script?))
        };
        account.formats.iter().flatten().filter_map(asked).collect::<Vec<_>>()
    };
    accounts.iter().enumerate().flat_map(one).collect()
}

/// What the certified version of a comparison of a formula is called in these files, by their places.
pub(super) fn function(account: &Account, index: usize, comparison: usize) -> String {
    let name = called(best(account).0, &account.label, index).name.unwrap_or_default();
    function_name(&name, comparison)
}

/// The formula under a name of its own: two formulas may be called the same.
fn called(core: &Core, label: &str, index: usize) -> Core {
    let name = core.name.as_deref().unwrap_or(label);
    Core { name: Some(format!("{name}_{}", index + 1)), ..core.clone() }
}
