//! The matrix as tables: laws against properties, what is asked, and what was found of each law.

use kane_matrix::{Cell, Finding, PROPERTIES, Property, Row, unmarked};

use super::{MatrixReport, caveats, mark, marked, parameters, picture, word};
use crate::sheet::{self, Column, Sheet, Table, Tone, Words, row};

const KEY: &str = "yes: proved, no: refuted, -: not applicable, ?: undecided; * for every planar contact, else W_tn = 0";

/// The report as a sheet. Its page is one of its own, [`html`](super::html).
#[must_use]
pub fn sheet<'a>(report: &'a MatrixReport<'a>) -> Sheet<'a> {
    let matrix = report.matrix;
    let headline = report.headline();
    let mut sheet = Sheet::new("Matrix", "Laws and properties", headline, &report.command);
    sheet.columns = 120;
    sheet.figure("matrix", "The matrix", || picture(report));
    let heads = matrix.properties.iter().map(|p| Column::left(p.head));
    let columns = std::iter::once(Column::left("law")).chain(heads).collect();
    let findings = |row: &Row| {
        let found = |cell: &Cell| match cell.finding {
            Finding::Refuted => Words::strong(mark(cell.finding)).toned(tone(cell.finding)),
            other => Words::from(mark(other)).toned(tone(other)),
        };
        let cells = row.cells.iter().map(found);
        sheet::Row::new(std::iter::once(marked(row).into()).chain(cells).collect())
    };
    sheet.table(Table::new(columns, matrix.rows.iter().map(findings).collect()));
    sheet.prose(KEY);
    for caveat in caveats(matrix) {
        sheet.prose(caveat);
    }
    let asked = |p: &&Property| row![p.head, Words::code(p.id), p.name, Words::code(p.template)];
    let columns = vec![
        Column::left(""),
        Column::left("id"),
        Column::left("property").detail(),
        Column::long("asked", 40),
    ];
    sheet.table(Table::new(columns, matrix.properties.iter().map(asked).collect()));
    for row in &matrix.rows {
        let with = parameters(row);
        let with = if with.is_empty() { with } else { format!(", {with}") };
        sheet.heading(row.law.info.id, format!("{}{with}", row.law.info.id));
        sheet.prose(format!("{}.", row.law.info.source));
        let found = |(property, cell): (&&Property, &Cell)| {
            // whoever asks what is wrong with a law has not asked for what is right
            row![word(cell.finding), Words::code(property.id), unmarked(&cell.reason)]
                .toned(tone(cell.finding))
                .detail(cell.finding == Finding::Proved)
        };
        let columns = vec![Column::left(""), Column::left("property"), Column::long("why", 40)];
        let cells = matrix.properties.iter().zip(&row.cells);
        sheet.table(Table::new(columns, cells.map(found).collect()));
    }
    sheet
}

const fn tone(finding: Finding) -> Tone {
    match finding {
        Finding::Proved => Tone::Good,
        Finding::Refuted => Tone::Bad,
        Finding::NotApplicable => Tone::Quiet,
        Finding::Undecided => Tone::Doubtful,
    }
}

/// The page that says what each property asks: `docs/properties.md`, from its table on.
#[must_use]
pub fn properties() -> String {
    let mut out = String::from("| column | id | property | asked of |\n|---|---|---|---|\n");
    for p in &PROPERTIES {
        let head = p.head.replace('|', "\\|");
        out += &format!("| {head} | `{}` | {} | {} |\n", p.id, p.name, unmarked(p.domain));
    }
    for p in &PROPERTIES {
        let (domain, meaning) = (unmarked(p.domain), unmarked(p.meaning));
        let Property { name, id, template, .. } = p;
        out +=
            &format!("\n## {name}\n\n`{id}`, for {domain}:\n\n```\n{template}\n```\n\n{meaning}\n");
    }
    out
}
