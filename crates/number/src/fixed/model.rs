//! Every operation of a number of three limbs, against integers that have room.

use std::cmp::Ordering;

use num_bigint::Sign;
use num_integer::Integer as _;
use num_traits::Signed as _;

use crate::{Fixed, Integer};

const LIMBS: usize = 3;
/// The bits that there is room for.
const ROOM: u64 = 64 * LIMBS as u64;

type Short = Fixed<LIMBS>;

/// All integers of at most three limbs each of which is at an edge, with both signs.
fn integers() -> Vec<Integer> {
    let edges = [0, 1, 6, u64::MAX, 1 << 63];
    let mut all = vec![Integer::ZERO];
    for _ in 0..LIMBS {
        let longer = all.iter().flat_map(|rest| edges.map(|limb| (rest << 64_u32) + limb));
        all = longer.collect();
    }
    let opposite: Vec<Integer> = all.iter().map(|n| -n).collect();
    all.into_iter().chain(opposite).collect()
}

/// What there is room for, with limbs that are not in use zero, and none at the top that is in use.
fn assert_is(found: &Short, integer: &Integer, exponent: i64, what: &str) {
    assert!(found.fits(), "{what} has room");
    assert_eq!((&found.to_integer(), found.exponent()), (integer, exponent), "{what}");
    let (limbs, negative, _) = found.integer();
    assert!(limbs.last() != Some(&0), "{what}: a limb at the top is zero");
    assert!(found.limbs[limbs.len()..].iter().all(|limb| *limb == 0), "{what}: beyond its end");
    assert_eq!(negative, integer.is_negative(), "{what}: the sign");
    assert_eq!(u64::from(found.bits()), integer.bits(), "{what}: the bits");
    assert_eq!(found.is_zero(), integer.sign() == Sign::NoSign, "{what}: zero");
    assert_eq!(found.is_unit(), integer.magnitude() == &1_u32.into(), "{what}: a unit");
    assert_eq!(found.sign(), Some(integer.cmp(&Integer::ZERO)), "{what}: its order");
}

/// Whether the result of an operation is as it should be: right where the integer has room, and lost where not.
fn assert_has_room(found: &Short, integer: &Integer, exponent: i64, room: bool, what: &str) {
    if room {
        assert_is(found, integer, exponent, what);
    } else {
        assert!(!found.fits() && found.sign().is_none(), "{what} has no room");
    }
}

#[test]
fn what_one_integer_gives_is_as_of_integers_with_room() {
    let mut shifted = 0;
    for n in integers() {
        let short = Short::of(&n).scaled(5);
        assert_is(&short, &n, 5, &format!("{n}"));
        assert_is(&short.abs(), &n.abs(), 5, &format!("|{n}|"));
        assert_is(&short.negated(), &-&n, 5, &format!("−{n}"));
        let doubled = short.doubled();
        let expected = if n.sign() == Sign::NoSign { 5 } else { 6 };
        assert_is(&doubled, &n, expected, &format!("2·{n}"));
        for down in [0, 1, 7, 63, 64, 65, 127, 128, 129, 191, 192, 193] {
            let longer: Integer = &n << down;
            let room = longer.bits() <= ROOM;
            let moved = i64::from(down);
            let found = short.with_exponent(5 - moved);
            assert_has_room(&found, &longer, 5 - moved, room, &format!("{n} from {down} below"));
            shifted += u32::from(room);
        }
        let higher = short.with_exponent(6);
        assert_eq!(higher.fits(), short.is_zero(), "{n} is no integer of a greater power");
        let twos = n.trailing_zeros().unwrap_or(0);
        let exponent =
            if n.sign() == Sign::NoSign { 0 } else { 5 + i64::try_from(twos).expect("few") };
        assert_is(&short.odd(), &(&n >> twos), exponent, &format!("{n} made odd"));
        let limbs = n.magnitude().iter_u64_digits().len();
        let cut: Fixed<2> = short.resized();
        assert_eq!(cut.fits(), limbs <= 2, "{n} in two limbs");
        assert!(!cut.fits() || cut.to_integer() == n && cut.exponent() == 5, "{n} in two limbs");
        let wide: Fixed<5> = short.resized();
        assert_eq!((wide.fits(), wide.to_integer(), wide.exponent()), (true, n, 5));
    }
    assert!(shifted > 500, "{shifted} shifts have room");
    for n in [Integer::from(1) << 192_u32, -(Integer::from(1) << 192_u32)] {
        let lost = Short::of(&n);
        assert!(!lost.fits() && !lost.odd().fits() && !lost.resized::<9>().fits(), "{n}");
    }
}

#[test]
fn what_two_integers_give_is_as_of_integers_with_room() {
    let integers = integers();
    for n in &integers {
        for m in integers.iter().step_by(3) {
            let (a, b) = (Short::of(n).scaled(-7), Short::of(m).scaled(2));
            let lengths = [n, m].map(|n| n.magnitude().iter_u64_digits().len());
            let unit = [n, m].iter().any(|n| n.bits() <= 1);
            let zero = [n, m].iter().any(|n| n.sign() == Sign::NoSign);
            let room = unit || lengths.iter().sum::<usize>() <= LIMBS;
            let exponent = if zero { 0 } else { -5 };
            let product = n * m;
            assert_has_room(&a.times(&b), &product, exponent, room, &format!("{n}·{m}"));
            for apart in [0_i64, 1, 64] {
                let b = Short::of(m).scaled(apart - 7);
                let higher = m << apart;
                for (found, sum, what) in [
                    (a.plus(&b), n + &higher, "+"),
                    (a.minus(&b), n - &higher, "−"),
                    (b.minus(&a), &higher - n, "less, the other way"),
                ] {
                    let what = format!("{n} {what} {m}·2^{apart}");
                    if zero || sum.sign() == Sign::NoSign {
                        // one of them as it is, or zero
                        let value = found.to_integer()
                            << u64::try_from(found.exponent().max(-7) + 7).unwrap_or(0);
                        assert!(found.fits() && value == sum, "{what}");
                        continue;
                    }
                    let room = higher.bits() <= ROOM && sum.bits() <= ROOM;
                    assert_has_room(&found, &sum, -7, room, &what);
                }
            }
            if n.is_odd() && m.is_odd() {
                let divisor = n.gcd(m);
                assert_is(&a.gcd(&b), &divisor, 0, &format!("gcd({n}, {m})"));
                let quotient = a.exact_quotient(&Short::of(&divisor));
                assert_is(&quotient, &(n / &divisor), -7, &format!("{n}/{divisor}"));
            }
        }
    }
}

#[test]
fn what_is_lost_stays_lost() {
    let lost = Short::of(&(Integer::from(1) << 192_u32));
    for other in [Short::ZERO, Short::ONE, lost] {
        for result in [
            lost.plus(&other),
            other.plus(&lost),
            lost.minus(&other),
            other.minus(&lost),
            lost.times(&other),
            other.times(&lost),
            lost.negated(),
            lost.abs(),
            lost.doubled(),
        ] {
            assert!(!result.fits() && result.sign().is_none(), "{result:?}");
        }
    }
    assert_eq!(Short::new(true, 3, 0).sign(), Some(Ordering::Less));
    assert_eq!(Short::new(true, 0, 0).sign(), Some(Ordering::Equal), "there is one zero");
}
