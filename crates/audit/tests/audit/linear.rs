//! Linear arithmetic is complete: random systems in six variables, made so that they have a point, or
//! have none, by integers alone.

use kane_audit::{Options, Verdict, audit, read};

/// A source of chance that is the same everywhere.
struct Chance(u64);

impl Chance {
    /// An integer from −most to most.
    fn up_to(&mut self, most: i64) -> i64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33).cast_signed().rem_euclid(2 * most + 1) - most
    }
}

const VARIABLES: usize = 6;

fn sum(row: &[i64]) -> String {
    let terms = row.iter().enumerate().map(|(i, c)| format!("({c})*x{i}"));
    terms.collect::<Vec<_>>().join(" + ")
}

/// The verdict on the claim that these conditions exclude the last one, turned round.
fn verdict(conditions: &[String], claim: &str) -> Verdict {
    let names = (0..VARIABLES).map(|i| format!("x{i}")).collect::<Vec<_>>().join(", ");
    let when = conditions.join(", ");
    let text = format!("```kane\nvar {names}\nclaim c: {claim} when {when}\n```\n");
    let document = read("linear.md", text.as_bytes()).expect("it is well formed");
    audit(document, &Options::default(), &mut |_, _| {}).judgements.remove(0).verdict
}

#[test]
fn a_claim_that_fails_only_between_boundaries_in_six_variables_is_refuted() {
    let mut chance = Chance(1);
    for case in 0..12_u8 {
        let at: Vec<i64> = (0..VARIABLES).map(|_| chance.up_to(9)).collect();
        let value = |row: &[i64]| row.iter().zip(&at).map(|(a, x)| a * x).sum::<i64>();
        let mut conditions = Vec::new();
        for _ in 0..VARIABLES {
            let row: Vec<i64> = (0..VARIABLES).map(|_| chance.up_to(5)).collect();
            // A sliver of this width holds the planted point, in its inside or on its edge.
            let (width, v) = ([10, 1000, 100_000][usize::from(case % 3)], value(&row));
            conditions.push(format!("{} > {v} - 1/{width}", sum(&row)));
            conditions.push(format!("{} <= {v}", sum(&row)));
        }
        let row: Vec<i64> = (0..VARIABLES).map(|_| chance.up_to(5)).collect();
        let claim = format!("{} < {} - 1/1000", sum(&row), value(&row));
        assert_eq!(
            verdict(&conditions, &claim),
            Verdict::Refuted,
            "{case}: {claim} {conditions:?}"
        );
    }
}

#[test]
fn a_system_with_a_hidden_contradiction_is_proved_to_have_one() {
    let mut chance = Chance(2);
    for case in 0..12 {
        let (mut conditions, mut rows) = (Vec::new(), Vec::new());
        let (mut total, mut bound) = (vec![0; VARIABLES], 0);
        for _ in 0..7 {
            let (weight, least) = (1 + chance.up_to(2).abs(), chance.up_to(9));
            let row: Vec<i64> = (0..VARIABLES).map(|_| chance.up_to(5)).collect();
            total.iter_mut().zip(&row).for_each(|(t, a)| *t += weight * a);
            bound += weight * least;
            conditions.push(format!("{} >= {least}", sum(&row)));
            rows.push((row, least));
        }
        // Weighted, they add up to: total >= bound.
        let claim = match case % 3 {
            0 => format!("{} > {bound} - 1/1000000", sum(&total)),
            1 => format!("{} >= {bound}", sum(&total)),
            // Only where each is an equation does the sum have its least value.
            _ => {
                conditions.push(format!("{} != {}", sum(&rows[0].0), rows[0].1));
                format!("{} > {bound}", sum(&total))
            }
        };
        let found = verdict(&conditions, &claim);
        assert!(matches!(found, Verdict::Proved | Verdict::Vacuous), "{case}: {found} {claim}");
    }
}

#[test]
fn premises_that_only_touch_contradict_each_other_in_many_variables() {
    let pairs: Vec<String> =
        (0..VARIABLES).map(|i| format!("x{i} - x{} >= 1/7", (i + 1) % VARIABLES)).collect();
    assert_eq!(verdict(&pairs, "x0 = 17"), Verdict::Vacuous);
    assert_eq!(verdict(&pairs[1..], "x1 - x0 < 1"), Verdict::Refuted);
    assert_eq!(verdict(&pairs[1..], "x1 - x0 >= 5/7"), Verdict::Proved);
    assert_eq!(verdict(&pairs[1..], "x1 - x0 > 5/7"), Verdict::Refuted);
}
