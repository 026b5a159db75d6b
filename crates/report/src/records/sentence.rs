//! One sentence that says what a log follows.

use std::fmt::Display;

use kane_impact::Restitution as Hypothesis;
use kane_records::check::Check;
use kane_records::friction::{FrictionFit, FrictionLaw};
use kane_records::restitution::{NormalLaw, Restitution, Threshold};
use kane_records::statistics::percent;
use kane_records::study::Study;

use super::wording::{at_line, brief, factor, formats, friction};
use crate::wording::number_of;

/// What the log follows, in a sentence.
#[must_use]
pub fn headline(study: &Study) -> String {
    if study.rows == 0 {
        return match study.rejections.total() {
            0 => "The log has no impacts.".to_owned(),
            _ => "No row could be checked.".to_owned(),
        };
    }
    let mut parts = vec![normal(study)];
    parts.extend(tangential(study));
    parts.extend(below_the_cone(study));
    parts.extend(counts(study));
    parts.extend(energy(study));
    parts.extend(lever(study));
    let mut sentence = parts.join("; ");
    if let Some(first) = sentence.get(..1) {
        sentence = format!("{}{}", first.to_uppercase(), &sentence[1..]);
    }
    format!("{sentence}.")
}

/// Restitution.
fn normal(study: &Study) -> String {
    let Some(restitution) = &study.restitution else { return "nothing approaches".to_owned() };
    let [least, middle, greatest] = restitution.observed.map(brief);
    match restitution.law {
        NormalLaw::Stated => "restitution as stated".to_owned(),
        _ if other_hypothesis(study).is_some() => other_hypothesis(study).unwrap_or_default(),
        NormalLaw::Close => {
            let off = restitution.stated - restitution.consistent;
            format!(
                "restitution as stated to 0.01, off beyond rounding in {} by up to {}",
                out_of(off, restitution.stated),
                brief(restitution.worst.0)
            )
        }
        NormalLaw::Threshold(threshold) => at_threshold(&threshold),
        NormalLaw::Constant => format!("restitution is {middle} whatever is stated"),
        NormalLaw::Depends => format!(
            "restitution is not as stated in {}: e is {least} to {greatest}{}",
            out_of(restitution.stated - restitution.consistent, restitution.stated),
            depending(restitution)
        ),
        NormalLaw::Unstated if least == greatest => format!("restitution is {middle}"),
        NormalLaw::Unstated => format!(
            "restitution, which is not stated, is {least} to {greatest}{}",
            depending(restitution)
        ),
    }
}

/// A law that gives every row by another hypothesis than Newton's.
fn other_hypothesis(study: &Study) -> Option<String> {
    let fit = study.consistent_laws().find(|fit| !fit.is_newton())?;
    let hypothesis = match fit.law.info.restitution {
        Hypothesis::Poisson => "Poisson's hypothesis",
        Hypothesis::Energetic => "the energetic hypothesis",
        Hypothesis::Newton => "Newton's hypothesis about a normal that leans",
    };
    Some(format!("restitution as stated by {hypothesis} ({})", fit.law.info.id))
}

fn at_threshold(threshold: &Threshold) -> String {
    let Threshold { factor: of, between: (low, high), misses_below, instead } = threshold;
    let side = if *misses_below { "below" } else { "above" };
    format!(
        "restitution is {} instead of the stated one where {} is {side} a threshold between {} and {}",
        brief(*instead),
        factor(*of),
        brief(*low),
        brief(*high)
    )
}

fn depending(restitution: &Restitution) -> String {
    let names: Vec<&str> = restitution.depends.iter().map(|(of, _)| factor(*of)).collect();
    match names.split_last() {
        None => String::new(),
        Some((one, [])) => format!(", depending on {one}"),
        Some((last, others)) => format!(", depending on {} and {last}", others.join(", ")),
    }
}

/// Friction given the measured normal impulse: the nearest law, and those that are not told from it.
fn tangential(study: &Study) -> Option<String> {
    let best = study.friction.first()?;
    let words = friction(best.law);
    let all = best.rows;
    let most = |rows: usize| rows * 10 >= all * 9;
    let unstated = study.friction.iter().all(|fit| fit.law == FrictionLaw::None);
    if unstated && best.consistent < all {
        return Some(format!("friction's law is not told without a stated mu{}", sliding(study)));
    }
    let others = || or_others(study, |fit| format!(", in {}", fit.close));
    Some(if best.consistent == all {
        let named = or_others(study, |_| String::new());
        let fit = match study.friction.iter().filter(|fit| fit.tied).count() {
            1 => "",
            2 => ", which fits every impact as well",
            _ => ", which fit every impact as well",
        };
        format!("friction {words}{named}{fit}")
    } else if best.close == all {
        format!("friction {words}, to 0.01 of k{}", others())
    } else if most(best.close) {
        format!("friction {words}, to 0.01 of k in {}{}", out_of(best.close, all), others())
    } else if most(best.rough) {
        let which = match best.rough == all {
            true => "all impacts".to_owned(),
            false => out_of(best.rough, all),
        };
        let named = or_others(study, |fit| format!(", in {}", fit.rough));
        let close = best.close;
        format!("friction {words}, to 0.05 of k in {which}{named} and to 0.01 in {close}")
    } else if let Some(given) = of_rigid_laws(study) {
        format!("friction follows no law of friction alone; every impact is given by {given}")
    } else if best.close * 2 >= all {
        format!(
            "friction {words}, to 0.01 of k in {}{} (the nearest; no law that is known here gives all)",
            out_of(best.close, all),
            others()
        )
    } else {
        format!(
            "friction follows no law that is known here (the nearest {words}, in {}{})",
            out_of(best.close, all),
            others()
        )
    })
}

/// The laws of the whole impact that give every row, by their ids.
fn of_rigid_laws(study: &Study) -> Option<String> {
    let named = |fit: &kane_records::rigid::LawFit| match fit.fitted {
        true => format!("{} with fitted parameters", fit.law.info.id),
        false => fit.law.info.id.to_owned(),
    };
    let names: Vec<String> = study.consistent_laws().map(named).collect();
    (!names.is_empty()).then(|| names.join(" or "))
}

/// How large friction is where contacts slide on, which is μ if it is Coulomb's.
fn sliding(study: &Study) -> String {
    let told = study.fits.iter().filter_map(|fit| fit.friction.filter(|mu| mu.high.is_finite()));
    let range = told.fold(None, |range, mu| match range {
        None => Some((mu.low, mu.high)),
        Some((low, high)) => Some((mu.low.min(low), mu.high.max(high))),
    });
    match range.map(|(low, high)| [low, high].map(brief)) {
        None => String::new(),
        Some([low, high]) if low == high => format!(" (it is {low}*p_n where contacts slide on)"),
        Some([low, high]) => format!(" (it is {low} to {high} of p_n where contacts slide on)"),
    }
}

/// The other laws that are not told from the first, each with its count.
fn or_others(study: &Study, count: impl Fn(&FrictionFit) -> String) -> String {
    let others = study.friction.iter().skip(1).filter(|fit| fit.tied);
    others.map(|fit| format!(", or {}{}", friction(fit.law), count(fit))).collect()
}

/// Impacts that slide with less friction than they could have.
fn below_the_cone(study: &Study) -> Option<String> {
    let best = study.friction.first()?;
    let checked = study.checked(Check::Sticks)?;
    let said = matches!(
        best.law,
        FrictionLaw::Compression | FrictionLaw::Share(_) | FrictionLaw::Coulomb | FrictionLaw::None
    );
    (said && checked.failed > 0).then(|| {
        format!("{} below the cone", doing(checked.failed, checked.rows, ["slides", "slide"]))
    })
}

/// What is odd though no check fails by it.
fn counts(study: &Study) -> Vec<String> {
    let mut parts = Vec::new();
    let rows = study.rows;
    let is_none = study.friction.first().is_some_and(|best| best.law == FrictionLaw::None);
    let none = study.energy.frictionless;
    if none > 0 && !is_none {
        let slide = doing(none, rows, ["slides", "slide"]);
        parts.push(format!("{slide} without any friction"));
    }
    let bouncy = study.energy.bouncy;
    if bouncy > 0 {
        parts.push(format!(
            "e is above 1 in {} without a gain of energy, which mechanics allows",
            out_of(bouncy, rows)
        ));
    }
    let undecided = study.checks.iter().map(|checked| checked.undecided).max().unwrap_or(0);
    if undecided > 0 {
        parts.push(format!(
            "{} undecided, since too few numbers tell whether they were rounded to {}",
            doing(undecided, rows, ["is", "are"]),
            formats(&study.precision.told)
        ));
    }
    parts
}

fn energy(study: &Study) -> Option<String> {
    let checked = study.checked(Check::Energy)?;
    let (line, finding) = checked.worst?;
    (checked.failed > 0).then(|| {
        format!(
            "energy is created in {}, {} of it at most{}",
            out_of(checked.failed, checked.rows),
            in_percent(finding.size()),
            at_line(line)
        )
    })
}

fn lever(study: &Study) -> Option<String> {
    let checked = study.checked(Check::Moment)?;
    let (middle, _) = study.arm?;
    (checked.failed > 0).then(|| {
        format!(
            "the impulse misses the stated contact point in {}, the arm being off by {} in the median",
            number_of(checked.failed, "impact"),
            in_percent(middle)
        )
    })
}

/// `1 of 1 impact`, `1 of 7 impacts`.
fn out_of(some: impl Display, all: impl Display) -> String {
    format!("{some} of {}", number_of(all, "impact"))
}

/// What some do, in the words for one and for several: `1 of 7 impacts slides`.
fn doing(some: u64, all: u64, [one, several]: [&str; 2]) -> String {
    format!("{} {}", out_of(some, all), if some == 1 { one } else { several })
}

fn in_percent(share: f64) -> String {
    format!("{} %", brief(percent(share)))
}

#[cfg(test)]
mod tests {
    use kane_records::check::{Finding, Verdict};
    use kane_records::fit::{Fitted, PairFit};
    use kane_records::restitution::Factor;
    use kane_records::tally::Checked;

    use super::super::made_up::{law_fit, of_a_log, study_of};
    use super::*;

    fn restitution(law: NormalLaw) -> Restitution {
        Restitution {
            law,
            rows: 10,
            stated: 9,
            consistent: 6,
            close: 4,
            observed: [0.25, 0.5, 0.75],
            offset: 0.0,
            worst: (0.125, 3),
            depends: Vec::new(),
            above_one: 0,
        }
    }

    #[test]
    fn restitution_is_said_to_be_as_stated_where_it_is() {
        let told = |restitution| normal(&Study { restitution, laws: Vec::new(), ..of_a_log() });
        let of = |law| told(Some(restitution(law)));
        assert_eq!(told(None), "nothing approaches");
        assert_eq!(of(NormalLaw::Stated), "restitution as stated");
        // nine are stated, and three of them are off
        assert_eq!(
            of(NormalLaw::Close),
            "restitution as stated to 0.01, off beyond rounding in 3 of 9 impacts by up to 0.125"
        );
        assert_eq!(of(NormalLaw::Constant), "restitution is 0.5 whatever is stated");
        let depends = |factors: &[Factor]| {
            let depends = factors.iter().map(|factor| (*factor, 0.5)).collect();
            told(Some(Restitution { depends, ..restitution(NormalLaw::Depends) }))
        };
        // as many as fail the check: those beyond their tolerance, be they close or not
        let off = "restitution is not as stated in 3 of 9 impacts: e is 0.25 to 0.75";
        assert_eq!(depends(&[]), off);
        assert_eq!(depends(&[Factor::Slip]), format!("{off}, depending on the slip"));
        assert_eq!(
            depends(&[Factor::Slip, Factor::Step, Factor::Speed]),
            format!("{off}, depending on the slip, the time step and the approach speed")
        );
        let unstated = restitution(NormalLaw::Unstated);
        let one = Restitution { observed: [0.5; 3], ..unstated.clone() };
        assert_eq!(told(Some(one)), "restitution is 0.5");
        let range = "restitution, which is not stated, is 0.25 to 0.75";
        assert_eq!(told(Some(unstated)), range);
    }

    #[test]
    fn restitution_by_another_hypothesis_than_newton_s_is_told_with_its_law() {
        use kane_impact::Restitution as Hypothesis;
        use kane_records::rigid::LawFit;
        let fit = |hypothesis, consistent| {
            let law = kane_impact::laws().iter().find(|law| law.info.restitution == hypothesis);
            law_fit(law.expect("there is one"), false, consistent)
        };
        let told = |law, fit: &LawFit| {
            let restitution = Some(restitution(law));
            normal(&Study { restitution, laws: vec![fit.clone()], ..of_a_log() })
        };
        for (hypothesis, words) in [
            (Hypothesis::Poisson, "Poisson's hypothesis"),
            (Hypothesis::Energetic, "the energetic hypothesis"),
        ] {
            let gives = fit(hypothesis, 10);
            let expected = format!("restitution as stated by {words} ({})", gives.law.info.id);
            assert_eq!(told(NormalLaw::Constant, &gives), expected);
            assert_eq!(told(NormalLaw::Close, &gives), expected);
            // where e is as stated, no other hypothesis is needed
            assert_eq!(told(NormalLaw::Stated, &gives), "restitution as stated");
            // nine of ten rows are not all
            let misses = fit(hypothesis, 9);
            assert_eq!(told(NormalLaw::Constant, &misses), "restitution is 0.5 whatever is stated");
        }
    }

    #[test]
    fn a_log_of_a_rigid_law_is_not_told_to_follow_no_law() {
        let law = kane_impact::law("garwin").expect("it is known");
        let garwin = |consistent, fitted| law_fit(law, fitted, consistent);
        let coulomb = FrictionFit {
            law: FrictionLaw::Coulomb,
            rows: 10,
            consistent: 0,
            close: 0,
            rough: 0,
            worst: 1.5,
            median: 1.5,
            worst_line: 2,
            tied: true,
        };
        let told = |fit| {
            let friction = vec![coulomb.clone()];
            tangential(&Study { friction, laws: vec![fit], ..of_a_log() }).expect("a sentence")
        };
        let given = "friction follows no law of friction alone; every impact is given by garwin";
        assert_eq!(told(garwin(10, false)), given);
        assert_eq!(told(garwin(10, true)), format!("{given} with fitted parameters"));
        assert!(told(garwin(9, false)).starts_with("friction follows no law that is known here"));
    }

    #[test]
    fn a_threshold_is_told_with_the_side_on_which_restitution_is_not_as_stated() {
        let told = |misses_below| {
            at_threshold(&Threshold {
                factor: Factor::Speed,
                between: (0.5, 1.0),
                misses_below,
                instead: 0.0,
            })
        };
        let what = "restitution is 0 instead of the stated one where the approach speed is";
        assert_eq!(told(true), format!("{what} below a threshold between 0.5 and 1"));
        assert_eq!(told(false), format!("{what} above a threshold between 0.5 and 1"));
    }

    /// A law with the numbers of impacts, of twenty, that it gives within tolerance, to 0.01 and to 0.05.
    fn fit(law: FrictionLaw, [consistent, close, rough]: [usize; 3], tied: bool) -> FrictionFit {
        let (worst, median, worst_line) = (0.0, 0.0, 0);
        FrictionFit { law, rows: 20, consistent, close, rough, worst, median, worst_line, tied }
    }

    #[test]
    fn friction_is_told_as_exactly_as_the_nearest_law_gives_it() {
        let told = |friction: Vec<FrictionFit>| {
            tangential(&Study { friction, fits: Vec::new(), ..of_a_log() })
        };
        let of = |counts| {
            let smith = fit(FrictionLaw::Smith, [1, 2, 3], true);
            let other = fit(FrictionLaw::WangSuLi, [0; 3], false);
            told(vec![fit(FrictionLaw::Coulomb, counts, true), smith, other])
                .expect("a law is nearest")
        };
        let coulomb = "is Coulomb's, which stops the slip";
        let smith = "or is Smith's mean of the slips before and after";
        let wanted = [
            ([20, 20, 20], format!("friction {coulomb}, {smith}, which fits every impact as well")),
            ([19, 20, 20], format!("friction {coulomb}, to 0.01 of k, {smith}, in 2")),
            (
                [0, 18, 20],
                format!("friction {coulomb}, to 0.01 of k in 18 of 20 impacts, {smith}, in 2"),
            ),
            (
                [0, 17, 20],
                format!(
                    "friction {coulomb}, to 0.05 of k in all impacts, {smith}, in 3 and to 0.01 in 17"
                ),
            ),
            (
                [0, 5, 18],
                format!(
                    "friction {coulomb}, to 0.05 of k in 18 of 20 impacts, {smith}, in 3 and to 0.01 in 5"
                ),
            ),
            (
                [0, 10, 17],
                format!(
                    "friction {coulomb}, to 0.01 of k in 10 of 20 impacts, {smith}, in 2 (the nearest; no law \
                     that is known here gives all)"
                ),
            ),
            (
                [0, 9, 17],
                format!(
                    "friction follows no law that is known here (the nearest {coulomb}, in 9 of 20 impacts, \
                     {smith}, in 2)"
                ),
            ),
        ];
        for (counts, wanted) in wanted {
            assert_eq!(of(counts), wanted);
        }
        let all = |law, tied| fit(law, [20; 3], tied);
        let (a, b, c) = (FrictionLaw::Coulomb, FrictionLaw::Smith, FrictionLaw::WangSuLi);
        let alone = told(vec![all(a, true), all(b, false)]);
        assert_eq!(alone, Some(format!("friction {coulomb}")));
        let three = told(vec![all(a, true), all(b, true), all(c, true)]).expect("a law");
        assert!(three.ends_with(", which fit every impact as well"), "{three}");
        assert_eq!(told(Vec::new()), None);
    }

    #[test]
    fn without_a_stated_friction_it_is_told_how_large_it_is_where_contacts_slide() {
        let told = |bounds: &[(f64, f64)]| {
            let pair = |(low, high): (f64, f64)| PairFit {
                pair: 0,
                stated: [None; 2],
                rows: 1,
                restitution: None,
                friction: Some(Fitted { low, high, rows: 1, one_value: true }),
                rebound: None,
            };
            let fits = bounds.iter().copied().map(pair).collect();
            let friction = vec![fit(FrictionLaw::None, [0; 3], true)];
            tangential(&Study { friction, fits, ..of_a_log() }).expect("a sentence")
        };
        let not_told = "friction's law is not told without a stated mu";
        assert_eq!(told(&[]), not_told);
        // without an upper bound
        assert_eq!(told(&[(0.5, f64::INFINITY)]), not_told);
        assert_eq!(
            told(&[(0.5, 0.5), (0.5, 0.5)]),
            format!("{not_told} (it is 0.5*p_n where contacts slide on)")
        );
        assert_eq!(
            told(&[(0.5, 0.75), (0.25, 0.5)]),
            format!("{not_told} (it is 0.25 to 0.75 of p_n where contacts slide on)")
        );
    }

    #[test]
    fn what_is_odd_is_counted_and_what_is_not_is_passed_over() {
        let plain = || {
            let friction = vec![fit(FrictionLaw::Coulomb, [20; 3], true)];
            Study { rows: 10, friction, checks: Vec::new(), ..of_a_log() }
        };
        let sticks = |failed| {
            let checks = vec![Checked { failed, rows: 7, ..Checked::none(Check::Sticks) }];
            Study { checks, ..plain() }
        };
        assert_eq!(below_the_cone(&sticks(0)), None);
        let below = Some("3 of 7 impacts slide below the cone".to_owned());
        assert_eq!(below_the_cone(&sticks(3)), below);
        // laws that say so of themselves
        let smith = vec![fit(FrictionLaw::Smith, [20; 3], true)];
        assert_eq!(below_the_cone(&Study { friction: smith, ..sticks(3) }), None);

        let mut study = plain();
        (study.energy.frictionless, study.energy.bouncy) = (0, 0);
        assert_eq!(counts(&study), Vec::<String>::new());
        study.energy.frictionless = 2;
        assert_eq!(counts(&study), ["2 of 10 impacts slide without any friction"]);
        study.energy.bouncy = 4;
        assert_eq!(
            counts(&study)[1],
            "e is above 1 in 4 of 10 impacts without a gain of energy, which mechanics allows"
        );
        study.friction = vec![fit(FrictionLaw::None, [20; 3], true)];
        assert_eq!(counts(&study).len(), 1, "where friction is absent that is no news");
        let checks = vec![
            Checked { undecided: 5, ..Checked::none(Check::Cone) },
            Checked { undecided: 3, ..Checked::none(Check::Energy) },
        ];
        let undecided = &counts(&Study { checks, ..study })[1];
        let begins = "5 of 10 impacts are undecided, since too few numbers tell whether";
        assert!(undecided.starts_with(begins), "{undecided}");
    }

    #[test]
    fn one_impact_is_one_whether_all_of_a_log_or_some_of_it() {
        let of = |some, all| doing(some, all, ["slides", "slide"]);
        assert_eq!(of(1, 1), "1 of 1 impact slides");
        assert_eq!(of(1, 7), "1 of 7 impacts slides");
        assert_eq!(of(2, 7), "2 of 7 impacts slide");
        let checks = vec![Checked { undecided: 1, rows: 1, ..Checked::none(Check::Cone) }];
        let mut study = Study { checks, rows: 1, ..of_a_log() };
        (study.energy.frictionless, study.energy.bouncy) = (0, 1);
        let told = counts(&study);
        assert!(told[0].starts_with("e is above 1 in 1 of 1 impact without"), "{told:?}");
        assert!(told[1].starts_with("1 of 1 impact is undecided"), "{told:?}");
    }

    fn finding(residual: f64, scale: f64) -> Finding {
        Finding { residual, scale, tolerance: 0.5, verdict: Verdict::Fails }
    }

    #[test]
    fn what_fails_is_told_with_how_often_and_by_how_much() {
        let with = |check, failed, arm| {
            let worst = Some((3, finding(0.25, 2.0)));
            let checks = vec![Checked { failed, rows: 7, worst, ..Checked::none(check) }];
            Study { checks, arm, ..of_a_log() }
        };
        assert_eq!(energy(&with(Check::Energy, 0, None)), None);
        let created = "energy is created in 2 of 7 impacts, 12.5 % of it at most (line 3)";
        assert_eq!(energy(&with(Check::Energy, 2, None)).as_deref(), Some(created));
        assert_eq!(lever(&with(Check::Moment, 0, Some((0.25, 1.0)))), None);
        assert_eq!(lever(&with(Check::Moment, 2, None)), None);
        let missed = "the impulse misses the stated contact point in 2 impacts, the arm being off by 25 % in the median";
        assert_eq!(lever(&with(Check::Moment, 2, Some((0.25, 1.0)))).as_deref(), Some(missed));
    }

    #[test]
    fn a_log_without_a_row_says_whether_there_was_one_to_check() {
        let head = "mass,radius,inertia,mu,restitution,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post\n";
        assert_eq!(headline(&study_of(head)), "The log has no impacts.");
        let broken = study_of(&format!("{head}1,1,0.4,0.3,0.5,2,-1,0,x,0.5,-1.125\n"));
        assert_eq!(headline(&broken), "No row could be checked.");
        let whole = headline(&Study {
            restitution: Some(restitution(NormalLaw::Stated)),
            friction: vec![fit(FrictionLaw::None, [20; 3], true)],
            checks: Vec::new(),
            ..of_a_log()
        });
        assert!(whole.starts_with("Restitution as stated; friction is absent"), "{whole}");
        assert!(whole.ends_with('.'), "{whole}");
    }
}
