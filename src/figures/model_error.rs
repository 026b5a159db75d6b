//! How far rigid laws and simpler processes are from the elastic half-space.

use kane_report::figures::{Axis, Content, Figure, Kind, Series};

pub(super) fn figure(table: &str) -> Figure {
    let mut rows = super::rows(table);
    let names = rows.next().unwrap_or_default();
    let rows: Vec<Vec<f64>> =
        rows.map(|row| row.into_iter().map(super::number).collect()).collect();
    let laws = kane_impact::laws::law_ids();
    let series = |(column, name): (usize, &&str)| Series {
        names: vec![match *name {
            "error" => "the half-space's own error, estimated".to_owned(),
            name => name.to_owned(),
        }],
        kind: if laws.contains(name) { Kind::Law } else { Kind::Process },
        points: rows
            .iter()
            .filter_map(|row| Some((*row.first()?, row.get(column).copied())))
            .collect(),
        bars: Vec::new(),
        decimals: 4,
    };
    // alpha and k itself are no differences
    let mut series: Vec<Series> = names.iter().enumerate().skip(2).map(series).collect();
    series.sort_by_key(|one| one.kind);
    let origin = table.lines().find_map(|line| line.strip_prefix("# ")).unwrap_or_default();
    Figure {
        stem: "model-error",
        title: "By how much k exceeds that of the elastic half-space, over α".to_owned(),
        notes: vec![format!("{}.", origin.replace("nu =", "ν ="))],
        x: super::alpha(0.1, 100.0),
        y: Axis {
            symbol: "difference",
            label: "k − k of the half-space (dimensionless)".to_owned(),
            range: (-1.5, 1.0),
            ticks: vec![-1.5, -1.0, -0.5, 0.0, 0.5, 1.0],
            is_logarithmic: false,
        },
        content: Content::Curves { series, zones: Vec::new() },
    }
}
