//! The ranges as rows for spreadsheets and plotting programs.

use super::{StabilityReport, bits};

/// Every range of every formula of one input, one row each, with exact decimals for the edges.
#[must_use]
pub fn csv(report: &StabilityReport<'_>) -> String {
    let mut rows = Vec::new();
    for entry in report.entries() {
        let formula = entry.formula;
        for line in &entry.lines {
            for range in &line.ranges {
                let better = range.better.as_ref().and_then(|better| report.better(better));
                rows.push(vec![
                    formula.label.clone(),
                    formula.quantity.clone(),
                    formula.text.clone(),
                    formula.by.join(" "),
                    line.format.to_owned(),
                    range.fault.name().to_owned(),
                    range.from.text.clone(),
                    range.to.text.clone(),
                    bits(range.lost),
                    range.worst.text.clone(),
                    range.computed.clone(),
                    range.exact.clone(),
                    range.cause.clone(),
                    better.map_or_else(String::new, |better| better.text.clone()),
                ]);
            }
        }
    }
    let names = "label,quantity,formula,with,format,fault,from,to,bits_lost,worst,returns,exact,cause,better";
    crate::sheet::csv(names, rows)
}
