//! What the size gate of the Gröbner library promises: random systems at its edge end soon.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use kane_algebra::ring::{IDEAL_GATE, Ideal, within_gate};
use kane_kernel::Poly;

/// Generous for a loaded machine in the dev profile; the release figure is some hundred times less.
const BOUND: Duration = Duration::from_secs(20);

#[test]
fn systems_at_the_edge_of_the_gate_end_soon() {
    let mut state = 88_172_645_463_325_252u64;
    let mut next = move |below: u64| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state % below
    };
    for (count, vars, degree, terms, bits) in IDEAL_GATE {
        let mut worst = Duration::ZERO;
        for _ in 0..20 {
            let mut system = Vec::new();
            for _ in 0..count {
                let mut p = Poly::default();
                while p.len() < terms {
                    let mut monomial = BTreeMap::new();
                    for _ in 0..next(u64::from(degree) + 1) {
                        let v = usize::try_from(next(vars as u64)).expect("a small index");
                        *monomial.entry(v).or_insert(0u32) += 1;
                    }
                    // Two bits less than allowed: like terms may meet a few times.
                    let size = i64::try_from(next(1 << (bits - 2))).expect("a small coefficient");
                    p = p.add(&Poly::term(
                        monomial.into_iter().collect(),
                        (size - (1 << (bits - 3))).into(),
                    ));
                }
                system.push(p);
            }
            let system: Vec<&Poly> = system.iter().collect();
            assert!(within_gate(&system, &[]), "the system is within the gate");
            let start = Instant::now();
            let lift = Ideal::new(&system, &[]).and_then(|ideal| ideal.lift(&Poly::one()));
            std::hint::black_box(lift);
            worst = worst.max(start.elapsed());
        }
        println!("{count} equations in {vars} variables of degree {degree}: at most {worst:?}");
        assert!(worst < BOUND, "{worst:?} for {count} equations");
    }
}
