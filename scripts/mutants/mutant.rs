//! Which mutant is on, by `KANE_MUTANT`; with `KANE_MUTANTS_REACHED` the numbers of those that are reached are added to
//! that file.

use std::io::Write as _;
use std::sync::LazyLock;
use std::sync::atomic::{AtomicBool, Ordering};

static ON: LazyLock<u32> =
    LazyLock::new(|| std::env::var("KANE_MUTANT").ok().and_then(|n| n.parse().ok()).unwrap_or(0));
static REACHED: LazyLock<Option<std::path::PathBuf>> =
    LazyLock::new(|| std::env::var_os("KANE_MUTANTS_REACHED").map(Into::into));
static SEEN: [AtomicBool; 65_536] = [const { AtomicBool::new(false) }; 65_536];

pub(crate) fn is(n: u32) -> bool {
    if let Some(path) = &*REACHED
        && !SEEN[n as usize].swap(true, Ordering::Relaxed)
    {
        let mut file = std::fs::OpenOptions::new().append(true).create(true).open(path).expect("a file to write to");
        file.write_all(format!("{n}\n").as_bytes()).expect("a file to write to");
    }
    *ON == n
}

/// None of these is on.
pub(crate) fn off(numbers: &[u32]) -> bool {
    numbers.iter().filter(|n| is(**n)).count() == 0
}

/// What a function gives that says only `impl Trait`.
pub(crate) enum Either<M, N> {
    Mutant(M),
    Normal(N),
}

impl<T, M: Iterator<Item = T>, N: Iterator<Item = T>> Iterator for Either<M, N> {
    type Item = T;

    fn next(&mut self) -> Option<T> {
        match self {
            Self::Mutant(m) => m.next(),
            Self::Normal(n) => n.next(),
        }
    }
}

impl<T, M: DoubleEndedIterator<Item = T>, N: DoubleEndedIterator<Item = T>> DoubleEndedIterator for Either<M, N> {
    fn next_back(&mut self) -> Option<T> {
        match self {
            Self::Mutant(m) => m.next_back(),
            Self::Normal(n) => n.next_back(),
        }
    }
}
