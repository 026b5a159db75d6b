//! What a statement rests on through all that it cites, and which citations say no more than others do.

/// Bits of a word.
const BITS: usize = u64::BITS as usize;

/// For each statement, all those above it that it rests on, as bits.
pub(crate) struct Reach {
    above: Vec<Vec<u64>>,
}

impl Reach {
    /// Of statements by what each cites. Only what stands above a statement counts.
    pub(crate) fn of<'a>(cites: impl Iterator<Item = &'a [usize]>) -> Self {
        let mut above: Vec<Vec<u64>> = Vec::new();
        for cited in cites {
            let mut all = vec![0; above.len().div_ceil(BITS)];
            for &i in cited {
                let Some(further) = above.get(i) else { continue };
                for (word, more) in all.iter_mut().zip(further) {
                    *word |= more;
                }
                all[i / BITS] |= 1 << (i % BITS);
            }
            above.push(all);
        }
        Self { above }
    }

    /// Whether a statement rests on another.
    pub(crate) fn rests(&self, statement: usize, on: usize) -> bool {
        let word = self.above.get(statement).and_then(|all| all.get(on / BITS));
        word.is_some_and(|word| word >> (on % BITS) & 1 == 1)
    }

    /// Whether a citation is the only way from a statement to what it cites.
    pub(crate) fn is_direct(&self, cited: usize, cites: &[usize]) -> bool {
        !cites.iter().any(|&other| other != cited && self.rests(other, cited))
    }

    /// How many statements rest on each.
    pub(crate) fn weights(&self) -> Vec<usize> {
        let count = |on| (on + 1..self.above.len()).filter(|s| self.rests(*s, on)).count();
        (0..self.above.len()).map(count).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_others_imply_is_not_direct_and_everything_that_rests_on_a_statement_counts() {
        // 1 cites 0; 2 cites 1 and, needlessly, 0; 3 stands alone; 100 cites 2
        let mut cites: Vec<Vec<usize>> = vec![Vec::new(); 101];
        (cites[1], cites[2], cites[100]) = (vec![0], vec![0, 1], vec![2]);
        let reach = Reach::of(cites.iter().map(Vec::as_slice));
        assert!(reach.rests(2, 0) && reach.rests(100, 0) && !reach.rests(0, 2));
        assert!(reach.is_direct(1, &cites[2]) && !reach.is_direct(0, &cites[2]));
        let weights = reach.weights();
        assert_eq!((weights[0], weights[1], weights[2], weights[3]), (3, 2, 1, 0));
    }
}
