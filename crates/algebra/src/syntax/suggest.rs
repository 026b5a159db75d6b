//! "Did you mean …?"

/// The candidate nearest to `word` by edit distance, if it is near enough to be a slip of the pen:
/// at most a third of the letters differ. Ties go to the first in alphabetical order.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let letters: Vec<char> = word.chars().collect();
    let limit = letters.len().div_ceil(3);
    candidates
        .into_iter()
        .filter(|candidate| candidate.chars().count().abs_diff(letters.len()) <= limit)
        .map(|candidate| (distance(&letters, candidate), candidate))
        .filter(|(d, _)| *d <= limit && *d < letters.len().max(1))
        .min()
        .map(|(_, candidate)| candidate)
}

/// The first candidate that is `word` with its unit, as `gravity_m_s2` is of `gravity`; else the nearest.
pub fn nearest_with_unit<'a>(
    word: &str,
    candidates: impl IntoIterator<Item = &'a str> + Clone,
) -> Option<&'a str> {
    let has_unit = |name: &&str| {
        name.strip_prefix(word).is_some_and(|unit| !word.is_empty() && unit.starts_with('_'))
    };
    candidates.clone().into_iter().find(has_unit).or_else(|| nearest(word, candidates))
}

/// Levenshtein's distance, except that a change of case is free.
fn distance(word: &[char], other: &str) -> usize {
    let mut row: Vec<usize> = (0..=word.len()).collect();
    for (i, c) in other.chars().enumerate() {
        let mut diagonal = i;
        let mut left = i + 1;
        for (j, w) in word.iter().enumerate() {
            let above = row.get(j + 1).copied().unwrap_or(usize::MAX);
            let change = diagonal + usize::from(!w.eq_ignore_ascii_case(&c));
            let best = change.min(left + 1).min(above + 1);
            diagonal = above;
            if let Some(cell) = row.get_mut(j) {
                *cell = left;
            }
            left = best;
        }
        if let Some(cell) = row.last_mut() {
            *cell = left;
        }
    }
    row.last().copied().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::{nearest, nearest_with_unit};

    #[test]
    fn a_name_without_its_unit_is_recognised() {
        let names = ["mass_kg", "radius_m", "v_x_m_s", "title"];
        assert_eq!(nearest_with_unit("mass", names), Some("mass_kg"));
        assert_eq!(nearest_with_unit("v_x", names), Some("v_x_m_s"));
        assert_eq!(nearest_with_unit("titel", names), Some("title"));
        assert_eq!(nearest_with_unit("ma", names), None);
        assert_eq!(nearest_with_unit("", ["_m"]), None);
    }

    #[test]
    fn a_slip_of_the_pen_is_recognised() {
        let names = ["alpha", "vx0", "vy0", "k"];
        assert_eq!(nearest("alhpa", names), Some("alpha"));
        assert_eq!(nearest("vx1", names), Some("vx0"));
        assert_eq!(nearest("K", names), Some("k"));
        assert_eq!(nearest("omega", names), None);
        assert_eq!(nearest("", names), None);
    }
}
