//! The page of figures.

use super::Site;
use crate::figures::svg;
use crate::sheet::{Sheet, Words};

/// Every figure with its notes in it, and its data beside it.
pub(super) fn gallery<'a>(site: &'a Site<'_>) -> Sheet<'a> {
    let mut sheet = Sheet::new("Figures", "What the laws say", "", "kane chart --figures");
    for figure in site.figures {
        sheet.figure(figure.stem, figure.title.clone(), || svg(figure));
        let picture = format!("figures/{}.svg", figure.stem);
        let data = format!("figures/{}.csv", figure.stem);
        let words =
            Words::link("the picture alone", picture) + ", " + Words::link("its data", data);
        sheet.prose(words);
    }
    sheet
}
