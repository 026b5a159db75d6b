//! Medians, ranges and shares of a variance.

/// Numbers of which the median and the worst are asked.
#[derive(Clone, Debug, Default)]
pub struct Spread {
    values: Vec<f64>,
    worst: Option<(f64, u64)>,
}

impl Spread {
    /// Adds the number of a line.
    pub fn add(&mut self, value: f64, line: u64) {
        self.values.push(value);
        if self.worst.is_none_or(|(worst, _)| value > worst) {
            self.worst = Some((value, line));
        }
    }

    /// How many.
    #[must_use]
    pub fn count(&self) -> usize {
        self.values.len()
    }

    /// The greatest, with its line.
    #[must_use]
    pub const fn worst(&self) -> Option<(f64, u64)> {
        self.worst
    }

    /// The median; zero without numbers.
    #[must_use]
    pub fn median(&self) -> f64 {
        median(self.values.clone()).unwrap_or(0.0)
    }
}

/// A share in percent.
#[must_use]
pub fn percent(share: f64) -> f64 {
    share * 100.0
}

/// The lower median.
#[must_use]
pub fn median(mut values: Vec<f64>) -> Option<f64> {
    if values.is_empty() {
        return None;
    }
    let middle = (values.len() - 1) / 2;
    let (_, median, _) = values.select_nth_unstable_by(middle, f64::total_cmp);
    Some(*median)
}

/// The classes of a quantity: its own values where they are few, else twelve of equal count.
#[must_use]
pub fn classes(values: &[f64]) -> Vec<usize> {
    const MOST: usize = 24;
    const PARTS: usize = 12;
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.dedup();
    if sorted.len() <= MOST {
        return values.iter().map(|value| sorted.partition_point(|x| x < value)).collect();
    }
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let edges: Vec<f64> = (1..PARTS).map(|part| sorted[part * sorted.len() / PARTS]).collect();
    values.iter().map(|value| edges.partition_point(|edge| edge <= value)).collect()
}

/// The sum of squares about the means of groups; numbers alone in a group are left out. Also how
/// many numbers were in groups.
#[must_use]
pub fn within_groups(values: &[f64], groups: &[Vec<usize>]) -> (f64, usize) {
    let mut sums: std::collections::BTreeMap<&[usize], (f64, f64, f64)> = Default::default();
    for (value, group) in values.iter().zip(groups) {
        let (count, mean, squares) = sums.entry(group.as_slice()).or_insert((0.0, 0.0, 0.0));
        // Welford's update, which does not cancel
        *count += 1.0;
        let step = value - *mean;
        *mean += step / *count;
        *squares += step * (value - *mean);
    }
    let mut inside = (0.0, 0);
    for (count, _, squares) in sums.values() {
        if *count > 1.0 {
            inside.0 += squares;
            #[allow(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a count of rows in memory"
            )]
            let count = *count as usize;
            inside.1 += count;
        }
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lower_median_is_one_of_the_numbers() {
        assert_eq!(median(vec![3.0, 1.0, 2.0, 9.0]), Some(2.0));
        assert_eq!(median(vec![]), None);
    }

    #[test]
    fn groups_explain_what_varies_between_them() {
        let values = [1.0, 1.0, 5.0, 5.0, 7.0];
        let groups = [0, 0, 1, 1, 2].map(|group| vec![group]);
        assert_eq!(within_groups(&values, &groups), (0.0, 4));
        let one: Vec<_> = values.iter().map(|_| vec![0]).collect();
        assert!((within_groups(&values, &one).0 - 28.8).abs() < 1e-12);
    }

    #[test]
    fn classes_are_values_or_parts() {
        assert_eq!(classes(&[0.5, 0.0, 0.5]), [1, 0, 1]);
        let many: Vec<f64> = (0..120).map(f64::from).collect();
        let classes = classes(&many);
        assert_eq!((classes[0], classes[9], classes[10], classes[119]), (0, 0, 1, 11));
    }
}
