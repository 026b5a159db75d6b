//! Formulas as MathML.

use maud::{Markup, PreEscaped, html};
use pulldown_latex::config::DisplayMode;
use pulldown_latex::{Parser, RenderConfig, Storage, mathml::push_mathml};

/// The formula, or where it is beyond the converter, its source.
pub(crate) fn math(latex: &str, mode: DisplayMode) -> Markup {
    match mathml(latex, mode) {
        Some(mathml) => PreEscaped(mathml),
        None => html! { code.tex { (latex) } },
    }
}

fn mathml(latex: &str, mode: DisplayMode) -> Option<String> {
    // The converter passes angle brackets through, in some places unescaped. Without any in its input, each in its
    // output belongs to a tag of its own or is the operator that `\lt` and `\gt` stand for.
    let latex = latex.replace(":=", "\\coloneqq ").replace('<', "\\lt ").replace('>', "\\gt ");
    let storage = Storage::new();
    let events = Parser::new(&latex, &storage).collect::<Result<Vec<_>, _>>().ok()?;
    let mut out = String::new();
    let config = RenderConfig { display_mode: mode, ..RenderConfig::default() };
    let events = events.into_iter().map(Ok::<_, std::fmt::Error>);
    push_mathml(&mut out, events, config).ok()?;
    let out = out.replace("<mo><</mo>", "<mo>&lt;</mo>").replace("<mo>></mo>", "<mo>&gt;</mo>");
    // what is the default, or holds for signs that do not stretch, need not be said
    let out = out
        .replace("<math display=\"inline\">", "<math>")
        .replace("<mo symmetric=\"false\" stretchy=\"false\">", "<mo stretchy=\"false\">")
        .replace("<mo stretchy=\"true\">(</mo>", "<mo>(</mo>")
        .replace("<mo stretchy=\"true\">)</mo>", "<mo>)</mo>")
        .replace(" width=\"0.16666667em\" />", " width=\".167em\"/>");
    // the micro sign has no slanted form in fonts for mathematics; the letter has
    Some(names(&out.replace('\u{b5}', "μ")))
}

/// Indices of several letters and digits as one name, upright, as in proofs: `y0` and not y times 0.
fn names(mathml: &str) -> String {
    const END: &str = "</mrow></msub>";
    let mut out = String::with_capacity(mathml.len());
    let mut rest = mathml;
    while let Some(end) = rest.find(END) {
        let (before, after) = (&rest[..end], &rest[end + END.len()..]);
        let name = before.rfind("<mrow>").and_then(|at| Some((at, name(&before[at + 6..])?)));
        match name {
            Some((at, name)) => {
                out.push_str(&before[..at]);
                out.push_str("<mi>");
                out.push_str(&name);
                out.push_str("</mi></msub>");
            }
            None => out.push_str(&rest[..end + END.len()]),
        }
        rest = after;
    }
    out.push_str(rest);
    out
}

/// What letters and numbers alone spell, if a letter is first.
fn name(leaves: &str) -> Option<String> {
    let mut spelt = String::new();
    let mut rest = leaves.strip_prefix("<mi>").map(|_| leaves)?;
    while !rest.is_empty() {
        let tag = ["mi", "mn"].into_iter().find(|tag| rest.starts_with(&format!("<{tag}>")))?;
        let (leaf, after) = rest.get(4..)?.split_once(&format!("</{tag}>"))?;
        if leaf.contains(['<', '&']) {
            return None;
        }
        spelt.push_str(leaf);
        rest = after;
    }
    Some(spelt)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_formula_becomes_mathml() {
        let shown = math(r"k_W := \frac{1}{2} < 1", DisplayMode::Block).into_string();
        assert!(shown.starts_with("<math display=\"block\"><msub>"), "{shown}");
        assert!(shown.contains("<mfrac>") && shown.contains("<mo>&lt;</mo>"), "{shown}");
        assert!(shown.contains('≔'), "{shown}");
    }

    #[test]
    fn an_index_of_several_letters_is_a_name() {
        let shown = |latex| math(latex, DisplayMode::Inline).into_string();
        assert_eq!(shown("v_{px0}"), "<math><msub><mi>v</mi><mi>px0</mi></msub></math>");
        assert!(shown("v_{y}").contains("<mi>y</mi></msub>"));
        for product in ["x^{2n}", "v_{i+1}", "v_{2n}", r"\frac{ab}{c_d}"] {
            let shown = shown(product);
            assert!(!shown.contains("2n") && !shown.contains("ab"), "{product} gives {shown}");
        }
    }

    #[test]
    fn what_cannot_be_converted_is_shown_as_written() {
        let shown = math(r"\unheard{x}", DisplayMode::Inline).into_string();
        assert_eq!(shown, r#"<code class="tex">\unheard{x}</code>"#);
    }

    #[test]
    fn no_markup_comes_through_a_formula() {
        for latex in [r"\operatorname{<b>}", r"\text{<img src=x>}", r"\mathrm{<b>}", "<script>"] {
            let shown = math(latex, DisplayMode::Inline).into_string();
            for tag in ["<b", "<img", "<script"] {
                assert!(!shown.contains(tag), "{latex} gives {shown}");
            }
        }
    }
}
