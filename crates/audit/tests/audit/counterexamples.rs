//! A point at which the hypotheses hold and the claim does not ends the search for a proof.

use kane_audit::{Audit, Options, Verdict, audit, read};

/// A struck ball that slides until it rolls; the last claim is false where it rolls from the start.
const BALL: &str = "var m > 0, r > 0, g > 0, mu >= 0, J
var v_0, omega_0
given ball: J = 2/5*m*r^2
let s_0 := v_0 - omega_0*r
let t_r := 2/7*s_0/(mu*g)
let v_r := v_0 - mu*g*t_r
let omega_r := omega_0 + 5/2*mu*g/r*t_r
let T_0 := 1/2*m*v_0^2 + 1/2*J*omega_0^2
let T_r := 1/2*m*v_r^2 + 1/2*J*omega_r^2
claim loss: T_0 - T_r = 1/7*m*s_0^2   when mu > 0   from ball
";

fn audited(last: &str) -> Audit {
    let text = format!("```kane\n{BALL}{last}\n```\n");
    let document = read("ball.md", text.as_bytes()).expect("it can be read");
    audit(document, &Options::default(), &mut |_, _| {})
}

#[test]
fn a_claim_that_fails_where_its_hypotheses_are_known_to_hold_is_refuted_without_a_search_for_a_proof()
 {
    let audit = audited("claim dissipates: T_r < T_0   when mu > 0   from loss");
    let last = audit.judgements.last().expect("it was judged");
    assert_eq!(last.verdict, Verdict::Refuted);
    // 480 million was not enough for a proof that is not there
    let work: u64 = last.links.iter().map(|link| link.work).sum();
    assert!(work < 48_000_000, "{work} operations");
}

#[test]
fn its_neighbour_that_allows_no_loss_is_proved() {
    let audit = audited("claim dissipates: T_r <= T_0   when mu > 0   from loss");
    assert_eq!(audit.judgements.last().expect("it was judged").verdict, Verdict::Proved);
}

/// Witnesses lie between a sphere and a plane that nearly touches it: √n is the greatest sum.
#[test]
fn a_claim_that_fails_between_two_boundaries_near_each_other_is_refuted() {
    for (names, most) in [
        ("a, b, c", "1732/1000"),
        ("a, b, c, s", "1999/1000"),
        ("a, b, c, s, p", "2236/1000"),
        ("a, b, c, s, p, q", "2449/1000"),
    ] {
        let range = names.replace(", ", " <= 1, 0 <= ");
        let squares = names.replace(", ", "^2 + ");
        let sum = names.replace(", ", " + ");
        let text = format!(
            "```kane\nvar 0 <= {range} <= 1\nclaim most: {sum} <= {most} when {squares}^2 <= 1\n```\n"
        );
        let document = read("sphere.md", text.as_bytes()).expect("it is well formed");
        let audit = audit(document, &Options::default(), &mut |_, _| {});
        let claim = audit.judgements.last().expect("there is a claim");
        assert_eq!(claim.verdict, Verdict::Refuted, "{text}");
    }
}
