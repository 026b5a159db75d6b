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
        .replace(" width=\"0.16666667em\" />", " width=\".167em\"/>");
    // the micro sign has no slanted form in fonts for mathematics; the letter has
    Some(out.replace('\u{b5}', "μ"))
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
