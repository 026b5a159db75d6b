//! The forms of a sheet: the one that is printed, and all of them as files.

use kane::report::{Page, Sheet};

use super::args::Format;
use super::delivery::Written;
use super::output;

/// The sheet in the form that is asked for.
pub(super) fn printed(format: Format, sheet: &Sheet<'_>, json: impl FnOnce() -> String) -> String {
    match format {
        Format::Text => sheet.text(output::page()),
        Format::Markdown => sheet.markdown(),
        Format::Json => json(),
    }
}

/// The sheet in every form, and its drawings.
pub(super) fn files(stem: &str, sheet: &Sheet<'_>, json: String) -> Vec<Written> {
    files_with_page(stem, sheet, sheet.html(), json)
}

/// The same with a page that is more than the sheet.
pub(super) fn files_with_page(
    stem: &str,
    sheet: &Sheet<'_>,
    page: String,
    json: String,
) -> Vec<Written> {
    let forms = [
        ("txt", sheet.text(Page::default())),
        ("md", sheet.markdown()),
        ("html", page),
        ("tex", sheet.latex()),
        ("json", json),
    ];
    let forms = forms.map(|(ending, text)| Written::new(format!("{stem}.{ending}"), text));
    let mut files = forms.to_vec();
    for (name, svg) in sheet.drawings() {
        let place = match stem {
            // the picture of all laws has the name of its data
            "laws" => name.to_owned(),
            // what a file is called after need not be said twice
            stem if stem.ends_with(name) => stem.to_owned(),
            stem => format!("{stem}-{name}"),
        };
        files.push(Written::picture(format!("{place}.svg"), &svg));
    }
    files
}
