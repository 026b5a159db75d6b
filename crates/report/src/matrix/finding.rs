//! What the matrix comes to: how many properties laws break, and which properties no law has together.

use kane_matrix::{Finding, Matrix, Property, Row};

/// How many cells of a law are refuted.
pub(crate) fn refuted(row: &Row) -> usize {
    row.cells.iter().filter(|cell| cell.finding == Finding::Refuted).count()
}

/// Laws by the number of properties that they break, fewest first.
pub(crate) fn sorted(matrix: &Matrix) -> Vec<&Row> {
    let mut rows: Vec<&Row> = matrix.rows.iter().collect();
    rows.sort_by_key(|row| refuted(row));
    rows
}

/// By how many laws a property is refuted, and of how many it is proved.
pub(crate) fn counts(matrix: &Matrix, column: usize) -> [usize; 2] {
    [Finding::Refuted, Finding::Proved].map(|finding| {
        let found = |row: &&Row| row.cells.get(column).is_some_and(|cell| cell.finding == finding);
        matrix.rows.iter().filter(found).count()
    })
}

/// Pairs of properties, each of which some laws are proved to have, and which no law has together: each is known to lack
/// one of the two.
pub(crate) fn exclusive(matrix: &Matrix) -> Vec<[&'static Property; 2]> {
    let is = |row: &Row, column: usize, findings: &[Finding]| {
        row.cells.get(column).is_some_and(|cell| findings.contains(&cell.finding))
    };
    let is_had = |column: usize| matrix.rows.iter().any(|row| is(row, column, &[Finding::Proved]));
    // what is not decided may be had
    let may_have =
        |row: &Row, column: usize| is(row, column, &[Finding::Proved, Finding::Undecided]);
    let mut pairs = Vec::new();
    for (i, a) in matrix.properties.iter().enumerate().filter(|(i, _)| is_had(*i)) {
        for (j, b) in matrix.properties.iter().enumerate().skip(i + 1).filter(|(j, _)| is_had(*j)) {
            if !matrix.rows.iter().any(|row| may_have(row, i) && may_have(row, j)) {
                pairs.push([*a, *b]);
            }
        }
    }
    pairs
}

/// How many properties the laws break, in a sentence without its full stop. Of laws of which not all is decided it is only
/// known that some break something.
pub(crate) fn breaking(matrix: &Matrix) -> String {
    let all = matrix.rows.len();
    let is_open = |row: &&Row| row.cells.iter().any(|cell| cell.finding == Finding::Undecided);
    let settled = || matrix.rows.iter().filter(|row| !is_open(row));
    let by_count = |n: usize| settled().filter(move |row| refuted(row) == n).count();
    let (none, one) = (by_count(0), by_count(1));
    let first = match none {
        0 if matrix.rows.iter().all(|row| refuted(row) > 0) => {
            format!("Every one of {all} laws breaks something")
        }
        0 => format!("None of {all} laws is known to break nothing"),
        1 => format!("One of {all} laws breaks nothing"),
        n => format!("{n} of {all} laws break nothing"),
    };
    let second = match one {
        0 => String::new(),
        1 => "; one breaks one property alone".to_owned(),
        n => format!("; {n} break one property alone"),
    };
    let third = match matrix.rows.iter().filter(is_open).count() {
        0 => String::new(),
        1 => "; of one not every property is decided".to_owned(),
        n => format!("; of {n} not every property is decided"),
    };
    first + &second + &third
}

/// Which properties no law has together, a sentence a pair without its full stop.
pub(crate) fn conflicts(matrix: &Matrix) -> Vec<String> {
    let pair = |[a, b]: &[&Property; 2]| {
        format!("No law has both {} ({}) and {} ({})", a.id, a.name, b.id, b.name)
    };
    exclusive(matrix).iter().map(pair).collect()
}

#[cfg(test)]
mod tests {
    use super::super::made_up::matrix;
    use super::*;

    #[test]
    fn a_pair_that_no_law_has_is_found_and_a_property_that_none_has_is_no_pair() {
        let matrix = matrix(&["yn-n", "nynn", "ny-n"]);
        let pairs: Vec<[&str; 2]> =
            exclusive(&matrix).iter().map(|pair| pair.map(|p| p.id)).collect();
        assert_eq!(pairs, [["momentum", "C1"]]);
        assert_eq!(conflicts(&matrix).len(), 1);
    }

    #[test]
    fn laws_that_break_little_come_first_and_are_counted() {
        let matrix = matrix(&["nn", "yy", "yn"]);
        let order: Vec<usize> = sorted(&matrix).into_iter().map(refuted).collect();
        assert_eq!(order, [0, 1, 2]);
        let told = "One of 3 laws breaks nothing; one breaks one property alone";
        assert_eq!(breaking(&matrix), told);
        assert_eq!((counts(&matrix, 0), counts(&matrix, 1)), ([1, 2], [2, 1]));
    }

    #[test]
    fn of_several_laws_it_is_counted_how_many_break_little() {
        let told = |rows: &[&str]| breaking(&matrix(rows));
        assert_eq!(
            told(&["n-", "nn"]),
            "Every one of 2 laws breaks something; one breaks one property alone"
        );
        assert_eq!(
            told(&["ny", "yn", "nn"]),
            "Every one of 3 laws breaks something; 2 break one property alone"
        );
        assert_eq!(told(&["yy", "y-", "nn"]), "2 of 3 laws break nothing");
    }

    #[test]
    fn what_is_undecided_is_neither_broken_nor_kept() {
        let told = |rows: &[&str]| breaking(&matrix(rows));
        let open = "of one not every property is decided";
        assert_eq!(told(&["n?", "nn"]), format!("Every one of 2 laws breaks something; {open}"));
        assert_eq!(
            told(&["y?", "nn"]),
            format!("None of 2 laws is known to break nothing; {open}")
        );
        assert_eq!(told(&["y?", "yy"]), format!("One of 2 laws breaks nothing; {open}"));
        assert_eq!(
            told(&["y?", "n?", "yn"]),
            "None of 3 laws is known to break nothing; one breaks one property alone; of 2 not every property is decided"
        );
        // a law that may have both is none that lacks one
        let pairs = |rows: &[&str]| exclusive(&matrix(rows)).len();
        assert_eq!(pairs(&["yn", "ny"]), 1);
        assert_eq!([pairs(&["yn", "ny", "y?"]), pairs(&["yn", "ny", "??"])], [0, 0]);
        assert_eq!([pairs(&["yn", "ny", "n?"]), pairs(&["yn", "ny", "?-"])], [1, 1]);
    }
}
