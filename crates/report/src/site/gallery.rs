//! The page of figures.

use super::Site;
use super::form::Form;
use crate::figures::{Figure, csv, svg};
use crate::sheet::{Sheet, Words};

/// Every figure with its notes in it, and its data beside it.
pub(super) fn gallery<'a>(site: &'a Site<'_>) -> Sheet<'a> {
    let mut sheet = Sheet::new("Figures", "What the laws say", "", "kane chart --figures");
    for figure in site.figures {
        sheet.figure(figure.stem, figure.title.clone(), || svg(figure));
        let picture = format!("figures/{}.svg", figure.stem);
        let data = data(figure).link();
        let words = Words::link("the picture alone", picture)
            + ", "
            + Words::link(data.words, format!("figures/{}", data.to));
        sheet.prose(words);
    }
    sheet
}

/// The data of a figure.
pub(super) fn data(figure: &Figure) -> Form {
    Form::new("its data", format!("figures/{}.csv", figure.stem), csv(figure))
}
