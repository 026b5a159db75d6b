//! Choices of one from each of several lists, the first ones first.

/// Choices by the sum of their positions, and among those of one sum by the positions in the first lists; each is made
/// when it is asked for.
pub(super) fn diagonal<T: Clone>(
    lists: &[Vec<T>],
    most: usize,
) -> impl Iterator<Item = Vec<T>> + Clone + use<'_, T> {
    let start = lists.iter().all(|list| !list.is_empty()).then(|| vec![0; lists.len()]);
    let places = std::iter::successors(start, |at| after(lists, at));
    let chosen = |at: Vec<usize>| lists.iter().zip(at).map(|(list, i)| list[i].clone()).collect();
    places.take(most).map(chosen)
}

/// The positions after these.
fn after<T>(lists: &[Vec<T>], at: &[usize]) -> Option<Vec<usize>> {
    let mut next = at.to_vec();
    let mut behind = 0;
    for i in (0..at.len()).rev() {
        if behind > 0 && at[i] + 1 < lists[i].len() {
            next[i] += 1;
            return first(lists, &next[..=i], behind - 1);
        }
        behind += at[i];
    }
    first(lists, &[], behind + 1)
}

/// The first positions of this sum that begin so: as much as they can take is for the last ones.
fn first<T>(lists: &[Vec<T>], begin: &[usize], sum: usize) -> Option<Vec<usize>> {
    let mut out = begin.to_vec();
    let mut rest = sum;
    for list in lists[begin.len()..].iter().rev() {
        let here = rest.min(list.len() - 1);
        out.insert(begin.len(), here);
        rest -= here;
    }
    (rest == 0).then_some(out)
}

#[cfg(test)]
mod tests {
    use quickcheck::{TestResult, quickcheck};

    use super::diagonal;

    quickcheck! {
        fn choices_ascend_by_their_sums_and_none_is_left_out(lengths: Vec<u8>) -> TestResult {
            if lengths.len() > 4 {
                return TestResult::discard();
            }
            let lists: Vec<Vec<usize>> =
                lengths.iter().map(|n| (0..usize::from(*n % 5)).collect()).collect();
            let all: Vec<Vec<usize>> = diagonal(&lists, usize::MAX).collect();
            let count: usize = lists.iter().map(Vec::len).product();
            let key = |at: &Vec<usize>| (at.iter().sum::<usize>(), at.clone());
            let ascend = all.is_sorted_by(|a, b| key(a) < key(b));
            let some: Vec<Vec<usize>> = diagonal(&lists, 7).collect();
            TestResult::from_bool(ascend && all.len() == count && some[..] == all[..count.min(7)])
        }
    }
}
