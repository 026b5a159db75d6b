//! The methods. A new form is one line here, and runs in every number system.

use std::cell::RefCell;
use std::hint::black_box;

use kane_impact::batch::{self, Batched, Columns};
use kane_impact::laws::{
    GarwinCapped, Smith1991, Walton, WangSuLi, WhittakerStop, WhittakerUncapped,
};
use kane_impact::{Alpha, ImpactLaw, Ratios};
use kane_number::{DoubleDouble, Interval, Lane as _, Rational, System};

use super::method::{Answer, Form, FormNumber, Method, repeatedly};

/// α runs from 2 to the power of the first to that of the second, where a form says nothing else.
pub const DOMAIN: (i32, i32) = (-30, 30);

/// A small integer of a form.
fn n<N: FormNumber>(integer: u8) -> N {
    N::small(integer)
}

/// What a law itself says.
fn law<N: FormNumber, L: ImpactLaw>(law: &L, alpha: &N) -> Option<Ratios<N>> {
    law.ratios(&Alpha::Finite(alpha.clone()))
}

/// k of the paper's law, by (16).
fn k16<N: FormNumber>(a: &N) -> Option<N> {
    (n::<N>(1) - a).quotient(&(n::<N>(1) + a))
}

macro_rules! registry {
    ($($id:ident: $law:literal $quantity:literal $name:literal $text:literal
        [$k:literal, $is_law:literal, $least:expr] |$a:ident| $body:expr;)*) => {
        $( fn $id<N: FormNumber>($a: &N) -> Option<N> { $body } )*

        /// Every form in every number system, by law and quantity, and then the kernels over
        /// columns, which have floats alone.
        #[must_use]
        pub fn registry() -> Vec<Method> {
            let mut all = Vec::new();
            $(
                let form = Form {
                    law: $law, quantity: $quantity, name: $name, text: $text, k: $k,
                    is_law: $is_law, least: $least,
                };
                registry!(@systems all form $id: f32, f64, DoubleDouble, Interval, Rational);
            )*
            all.extend(columns());
            all
        }
    };
    (@systems $all:ident $form:ident $id:ident: $($system:ty),*) => { $(
        $all.push(Method::new(
            $form,
            <$system>::SYSTEM,
            |alpha| $id::<$system>(&<$system>::of(alpha))?.answer(),
            |alphas| repeatedly::<$system>(alphas, $id::<$system>),
        ));
    )* };
}

registry! {
    // law, quantity, where it stands, the form; k where it is used, whether it is code, least α
    k_16: "wang-su-li" "k" "(16)" "(1 - alpha)/(1 + alpha)" ["", false, -30]
        |a| (n::<N>(1) - a).quotient(&(n::<N>(1) + a));
    k_b: "wang-su-li" "k" "k_b" "2/(1 + alpha) - 1" ["", false, -30]
        |a| Some(n::<N>(2).quotient(&(n::<N>(1) + a))? - n::<N>(1));
    k_c: "wang-su-li" "k" "k_c" "1 - 2*alpha/(1 + alpha)" ["", false, -30]
        |a| Some(n::<N>(1) - (n::<N>(2) * a).quotient(&(n::<N>(1) + a))?);
    k_law: "wang-su-li" "k" "law" "(1 - alpha)/(1 + alpha)" ["", true, -30]
        |a| Some(law(&WangSuLi, a)?.k);
    i_17: "wang-su-li" "i_x" "(17)" "1/(1 + alpha)" ["", false, -30]
        |a| n::<N>(1).quotient(&(n::<N>(1) + a));
    i_9: "wang-su-li" "i_x" "(9)" "1/(2*alpha)*(1 - k)" ["(1 - alpha)/(1 + alpha)", false, -30]
        |a| Some(n::<N>(1).quotient(&(n::<N>(2) * a))? * (n::<N>(1) - k16(a)?));
    i_15: "wang-su-li" "i_x" "(15)" "1/2*(k + 1)" ["(1 - alpha)/(1 + alpha)", false, -30]
        |a| Some(n::<N>(1).quotient(&n::<N>(2))? * (k16(a)? + n::<N>(1)));
    i_law: "wang-su-li" "i_x" "law" "1/(1 + alpha)" ["", true, -30]
        |a| Some(law(&WangSuLi, a)?.impulse);
    e_19: "wang-su-li" "Delta_e" "(19)" "-1/(4*alpha)*(1 - k^2)"
        ["(1 - alpha)/(1 + alpha)", false, -30]
        |a| {
            let k = k16(a)?;
            let factor = n::<N>(1).quotient(&(n::<N>(4) * a))?;
            Some(-(factor * (n::<N>(1) - k.clone() * &k)))
        };
    e_19x: "wang-su-li" "Delta_e" "(19x)" "-1/(1 + alpha)^2" ["", false, -30]
        |a| {
            let sum = n::<N>(1) + a;
            Some(-n::<N>(1).quotient(&(sum.clone() * &sum))?)
        };
    e_a: "wang-su-li" "Delta_e" "e_a" "-(1/(1 + alpha))^2" ["", false, -30]
        |a| {
            let share = n::<N>(1).quotient(&(n::<N>(1) + a))?;
            Some(-(share.clone() * &share))
        };
    e_law: "wang-su-li" "Delta_e" "law" "-1/(1 + alpha)^2" ["", true, -30]
        |a| Some(law(&WangSuLi, a)?.energy);
    w_22: "whittaker-uncapped" "k" "(22)" "-2*alpha + 1" ["", false, -30]
        |a| Some(-(n::<N>(2) * a) + n::<N>(1));
    w_law: "whittaker-uncapped" "k" "law" "-2*alpha + 1" ["", true, -30]
        |a| Some(law(&WhittakerUncapped, a)?.k);
    s_a: "smith-1991" "k" "s_a" "(1/alpha - 2)/(1 + sqrt(1 + (2 - 1/alpha)/alpha))" ["", false, 0]
        |a| {
            let inverse = n::<N>(1).quotient(a)?;
            let radicand = n::<N>(1) + (n::<N>(2) - &inverse).quotient(a)?;
            (inverse - n::<N>(2)).quotient(&(n::<N>(1) + radicand.root()?))
        };
    s_b: "smith-1991" "k" "s_b" "(1 - 2*alpha)/(alpha + sqrt(alpha^2 + 2*alpha - 1))"
        ["", false, 0]
        |a| {
            let twice = n::<N>(2) * a;
            let radicand = a.clone() * a + &twice - n::<N>(1);
            (n::<N>(1) - twice).quotient(&(a.clone() + radicand.root()?))
        };
    s_c: "smith-1991" "k" "s_c" "alpha - sqrt(alpha^2 + 2*alpha - 1)" ["", false, 0]
        |a| {
            let radicand = a.clone() * a + n::<N>(2) * a - n::<N>(1);
            Some(a.clone() - radicand.root()?)
        };
    s_law: "smith-1991" "k" "law" "alpha - sqrt(alpha^2 + 2*alpha - 1)" ["", true, 0]
        |a| Some(law(&Smith1991, a)?.k);
}

/// Gives k, `i_x` and Δe by the law's kernel, in this order.
fn evaluate<L: Batched + Default>(alpha: &[f64], [k, impulse, energy]: &mut [Vec<f64>; 3]) {
    batch::evaluate(&L::default(), alpha, Columns { k, impulse, energy });
}

/// One quantity at α.
fn in_columns<L: Batched + Default, const QUANTITY: usize>(alpha: f64) -> Option<Answer> {
    let mut out = [vec![0.0], vec![0.0], vec![0.0]];
    evaluate::<L>(&[alpha], &mut out);
    out.get(QUANTITY)?.first()?.answer()
}

/// A pass over a column; a row gives all three quantities.
fn over_columns<L: Batched + Default + 'static>(alphas: &[f64]) -> Box<dyn Fn()> {
    let alphas = alphas.to_vec();
    let rows = || vec![1.0; alphas.len()];
    let out = RefCell::new([rows(), rows(), rows()]);
    Box::new(move || {
        evaluate::<L>(black_box(&alphas), &mut out.borrow_mut());
        black_box(&out);
    })
}

/// A kernel for one quantity: `text` is what it is equal to, with `k` where that is used.
fn column<L: Batched + Default + 'static, const QUANTITY: usize>(
    text: &'static str,
    k: &'static str,
    least: i32,
) -> Method {
    let quantity = ["k", "i_x", "Delta_e"][QUANTITY];
    let law = L::default().id();
    let form = Form { law, quantity, name: "columns", text, k, is_law: true, least };
    Method::new(form, System::F64, in_columns::<L, QUANTITY>, over_columns::<L>)
}

/// The kernels over columns, a line for each quantity that is no constant.
fn columns() -> Vec<Method> {
    const FADING: &str = "(1 - alpha)/(1 + alpha)";
    const STOP: &str = "max(0, 1 - 2*alpha)";
    const WALTON: &str = "max(-11/25, 1 - 2*alpha)";
    const GARWIN: &str = "max(-1, 1 - 2*alpha)";
    const WEIGHTED: &str = "alpha - sqrt(alpha^2 + 2*alpha - 1)";
    const LOSS: &str = "-(1 - k^2)/(4*alpha)";
    vec![
        column::<WangSuLi, 0>(FADING, "", -30),
        column::<WangSuLi, 1>("1/(1 + alpha)", "", -30),
        column::<WangSuLi, 2>("-1/(1 + alpha)^2", "", -30),
        column::<WhittakerUncapped, 0>("-2*alpha + 1", "", -30),
        column::<WhittakerUncapped, 2>("alpha - 1", "", -30),
        column::<WhittakerStop, 0>(STOP, "", -30),
        column::<WhittakerStop, 1>("min(1, 1/(2*alpha))", "", -30),
        column::<WhittakerStop, 2>(LOSS, STOP, -30),
        column::<Walton, 0>(WALTON, "", -30),
        column::<Walton, 1>("min(1, 18/25/alpha)", "", -30),
        column::<Walton, 2>(LOSS, WALTON, -30),
        column::<GarwinCapped, 0>(GARWIN, "", -30),
        column::<GarwinCapped, 1>("min(1, 1/alpha)", "", -30),
        column::<GarwinCapped, 2>(LOSS, GARWIN, -30),
        column::<Smith1991, 0>(WEIGHTED, "", 0),
        column::<Smith1991, 1>("(1 - k)/(2*alpha)", WEIGHTED, 0),
        column::<Smith1991, 2>(LOSS, WEIGHTED, 0),
    ]
}

#[cfg(test)]
mod tests {
    use kane_number::decode;

    use super::super::accuracy::{inputs, program};
    use super::super::method::Answer;
    use super::*;
    use crate::Plain;

    /// What is timed is what the text says, operation by operation.
    #[test]
    fn the_code_of_a_form_is_its_text_bit_by_bit() {
        let mut compared = 0;
        for method in registry().iter().filter(|method| !method.is_law) {
            let program = program(method).expect("the text of a form is well formed");
            for alpha in inputs(method) {
                let written = match method.system {
                    System::F32 => {
                        let value = program.value(&Plain::new(), &[f32::of(alpha)]).unwrap();
                        decode(value).ok()
                    }
                    System::F64 => decode(program.value(&Plain::new(), &[alpha]).unwrap()).ok(),
                    _ => continue,
                };
                let coded = method.answer(alpha).map(|answer| match answer {
                    Answer::Number(x) | Answer::Between(x, _) => x,
                });
                assert_eq!(coded, written, "{} at {alpha:e}", method.text);
                compared += 1;
            }
        }
        assert!(compared > 10_000);
    }

    /// The bounds that the kernels state, in ulp, where they state one in relative terms.
    #[test]
    fn columns_keep_the_bounds_of_their_kernels_over_the_domain() {
        // hundredths of log₂: 9/4, 3/2, 4, 1/2, 6, 5 and 10 ulp
        let bound = |law: &str, quantity: &str| match (law, quantity) {
            ("wang-su-li", "k") => Some(117),
            ("wang-su-li", "Delta_e") => Some(200),
            (_, "k") if law != "smith-1991" => Some(-100),
            ("whittaker-uncapped", "Delta_e") => Some(-100),
            ("smith-1991", "k") => Some(259),
            ("smith-1991", "i_x") => Some(233),
            ("smith-1991", "Delta_e") => Some(333),
            (_, "i_x") => Some(59),
            _ => None, // sliding loses Δe to within an absolute bound
        };
        for method in columns() {
            let found = super::super::accuracy(&method).expect("columns have an answer everywhere");
            assert!(found.worst > 1000, "{} {}: {found:?}", method.law, method.quantity);
            if let (Some(bound), Some(ulps)) = (bound(method.law, method.quantity), found.ulps) {
                assert!(ulps <= bound, "{} {}: {found:?}", method.law, method.quantity);
            }
        }
    }
}
