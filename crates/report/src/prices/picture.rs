//! Digits by time, a panel a formula.

use kane_measure::prices::{Prices, Way};

use super::{PricesReport, form_of};
use crate::chart::{Spot, panels, spot};
use crate::shorten::shorten;

/// Every formula, as SVG: decimal digits that are right at the worst input, by the time of one evaluation.
pub(super) fn picture(report: &PricesReport<'_>) -> String {
    let group = |prices: &Prices| {
        let given = prices.forms.first().map_or_else(String::new, |form| form.core.text());
        (shorten(&format!("{}: {given}", prices.label), 60), spots(prices))
    };
    let groups: Vec<(String, Vec<Spot>)> = report.all.iter().map(group).collect();
    let notes = [
        "Digits right at the worst input tried, by the time of one evaluation in a column; nothing is both faster and \
         better than the line. A bar is from the first to the third quartile."
            .to_owned(),
        report.machine.clone(),
        format!("kane {}: {}", env!("CARGO_PKG_VERSION"), report.command),
    ];
    panels(&groups, &notes, "nothing is faster and better")
}

fn spots(prices: &Prices) -> Vec<Spot> {
    let one = |way: &Way| {
        let name = shorten(&form_of(prices, way), 30);
        spot(way.system, way.worst, Some(&way.time), way.on_front, name)
    };
    prices.ways.iter().map(one).collect()
}
