//! The greatest common divisor of odd integers, and exact quotients by odd ones, in place.
//!
//! With odd divisors everything goes from the least limb up: no quotient has to be guessed.

use std::cmp::Ordering;

use super::{Fixed, borrowing_sub, multiply_add};

/// The greatest common divisor of the odd integers of two numbers that fit. Exact.
///
/// By Euclid's algorithm on leading words (Lehmer 1938). An integer that is much longer is first shortened by a limb at a time: a + k·b with the
/// k for which 2⁶⁴ divides it (Hensel division) has the same divisors in common with b, because b is
/// odd. Words are left to differences and shifts (Stein 1967), which also help where leading words do
/// not tell a quotient.
pub(super) fn greatest_common_divisor<const LIMBS: usize>(
    a: &Fixed<LIMBS>,
    b: &Fixed<LIMBS>,
) -> Fixed<LIMBS> {
    debug_assert!(a.limbs[0] & b.limbs[0] & 1 == 1, "both are odd");
    let (mut a, mut b) = (a.magnitude(), b.magnitude());
    let (mut a, mut b) = (&mut a, &mut b);
    while a.len > 1 || b.len > 1 {
        match a.compare_magnitudes(b) {
            Ordering::Equal => return *a,
            Ordering::Less => (a, b) = (b, a),
            Ordering::Greater => {}
        }
        let much_longer = a.bits() >= b.bits() + 32;
        if !much_longer && let Some(steps) = Steps::of(a, b) {
            steps.apply(a, b);
            continue;
        }
        if (a.limbs[0] & b.limbs[0]) & 1 == 0 {
            make_odd(a);
            make_odd(b);
        } else if much_longer {
            shorten(a, b);
        } else {
            subtract_and_shift(a, b);
        }
    }
    make_odd(a);
    make_odd(b);
    Fixed::new(false, of_words(a.limbs[0], b.limbs[0]), 0)
}

/// Leaves out the powers of two, which an odd divisor does not have.
fn make_odd<const LIMBS: usize>(integer: &mut Fixed<LIMBS>) {
    if integer.limbs[0] & 1 == 0 {
        *integer = integer.odd().scaled(0);
    }
}

/// The same for words.
const fn of_words(mut a: u64, mut b: u64) -> u64 {
    while a != b {
        let difference = a.abs_diff(b);
        (a, b) = (difference >> difference.trailing_zeros(), if a < b { a } else { b });
    }
    a
}

/// Whether the words x ≥ y, which (a, b) has come to, tell a step.
fn is_certain(x: u64, y: u64, v: [u64; 3]) -> bool {
    y >= v[2] && x - y >= v[1] + v[2]
}

/// Some steps of Euclid's algorithm at once: (a, b) becomes ±(u₀·a − v₀·b, v₁·b − u₁·a), with the
/// upper sign if their number is even.
struct Steps {
    u: [u64; 2],
    v: [u64; 2],
    even: bool,
}

impl Steps {
    /// The steps that the leading words of a > b tell for certain, by the condition of Collins and
    /// Jebelean (1993); `None` if they do not tell the first. The factors stay below 2³³, because the last one times x is
    /// below 2⁶⁴, and at most y < x.
    fn of<const LIMBS: usize>(a: &Fixed<LIMBS>, b: &Fixed<LIMBS>) -> Option<Self> {
        let top = a.len - 1; // a has at least two limbs, or b would be as short as it
        let shift = a.limbs[top].leading_zeros();
        let leading = |limbs: &[u64; LIMBS]| match shift {
            0 => limbs[top],
            _ => limbs[top] << shift | limbs[top - 1] >> (64 - shift),
        };
        let (mut x, mut y) = (leading(&a.limbs), leading(&b.limbs));
        let (mut u, mut v, mut even) = ([0, 1, 0], [0, 0, 1], false);
        while is_certain(x, y, v) {
            let (quotient, rest) = (x / y, x % y);
            (x, y, even) = (y, rest, !even);
            u = [u[1], u[2], u[1] + quotient * u[2]];
            v = [v[1], v[2], v[1] + quotient * v[2]];
        }
        (v[0] != 0).then_some(Self { u: [u[0], u[1]], v: [v[0], v[1]], even })
    }

    /// Both are less than a was, and not negative.
    #[expect(clippy::cast_possible_truncation, reason = "the low word is meant")]
    #[expect(clippy::cast_sign_loss, reason = "the low word is meant")]
    fn apply<const LIMBS: usize>(&self, a: &mut Fixed<LIMBS>, b: &mut Fixed<LIMBS>) {
        let product =
            |factor: u64, limb: u64| (u128::from(factor) * u128::from(limb)).cast_signed();
        let (mut above_a, mut above_b) = (0, 0);
        for at in 0..a.len {
            let (x, y) = (a.limbs[at], b.limbs[at]);
            let next_a = product(self.u[0], x) - product(self.v[0], y);
            let next_b = product(self.v[1], y) - product(self.u[1], x);
            let (next_a, next_b) = if self.even { (next_a, next_b) } else { (-next_a, -next_b) };
            let (next_a, next_b) = (above_a + next_a, above_b + next_b);
            (a.limbs[at], b.limbs[at]) = (next_a as u64, next_b as u64);
            (above_a, above_b) = (next_a >> 64, next_b >> 64);
        }
        b.len = a.len;
        a.trim();
        b.trim();
    }
}

/// a − b without its factors of two, for a > b.
fn subtract_and_shift<const LIMBS: usize>(a: &mut Fixed<LIMBS>, b: &Fixed<LIMBS>) {
    let twos = a.limbs[0].wrapping_sub(b.limbs[0]).trailing_zeros();
    if twos == 64 {
        *a = a.subtract_magnitudes(b).odd().scaled(0);
        return;
    }
    let len = a.len;
    let (mut low, mut borrow) = borrowing_sub(a.limbs[0], b.limbs[0], false);
    for at in 1..len {
        let limb;
        (limb, borrow) = borrowing_sub(a.limbs[at], b.limbs[at], borrow);
        // twos ≥ 1, because both are odd
        a.limbs[at - 1] = low >> twos | limb << (64 - twos);
        low = limb;
    }
    a.limbs[len - 1] = low >> twos;
    a.trim();
}

/// (a + k·b)/2⁶⁴ for the k that makes this whole; shorter than a by 31 bits at least
/// where a has 32 bits more than b.
fn shorten<const LIMBS: usize>(a: &mut Fixed<LIMBS>, b: &Fixed<LIMBS>) {
    let factor = a.limbs[0].wrapping_mul(inverse(b.limbs[0])).wrapping_neg();
    let mut carry = 0;
    for at in 0..a.len {
        // b is the shorter, and zero beyond its end
        let (limb, above) = multiply_add(factor, b.limbs[at], a.limbs[at], carry);
        carry = above;
        if at > 0 {
            a.limbs[at - 1] = limb;
        }
    }
    a.limbs[a.len - 1] = carry;
    a.trim();
}

/// The quotient of an integer by an odd one that divides it, both of numbers that fit; exact, with
/// the sign and the exponent of the first.
pub(super) fn exact_quotient<const LIMBS: usize>(
    a: &Fixed<LIMBS>,
    divisor: &Fixed<LIMBS>,
) -> Fixed<LIMBS> {
    if divisor.len == 1 && divisor.limbs[0] == 1 {
        return *a;
    }
    let inverse = inverse(divisor.limbs[0]);
    let (mut rest, mut quotient) = (*a, Fixed { limbs: [0; LIMBS], ..*a });
    let len = (a.len + 1).saturating_sub(divisor.len);
    for at in 0..len {
        let digit = rest.limbs[at].wrapping_mul(inverse);
        quotient.limbs[at] = digit;
        let (mut carry, mut borrow) = (0, false);
        for (limb, part) in rest.limbs[at..a.len].iter_mut().zip(&divisor.limbs) {
            let product;
            (product, carry) = multiply_add(digit, *part, carry, 0);
            (*limb, borrow) = borrowing_sub(*limb, product, borrow);
        }
    }
    quotient.len = len;
    quotient.trim();
    quotient
}

/// The inverse of an odd number modulo 2⁶⁴: each step of Newton's doubles its right bits, of which
/// (3·a) xor 2 has five.
const fn inverse(a: u64) -> u64 {
    let mut x = a.wrapping_mul(3) ^ 2;
    let mut right = 5;
    while right < 64 {
        x = x.wrapping_mul(2_u64.wrapping_sub(a.wrapping_mul(x)));
        right *= 2;
    }
    x
}

#[cfg(test)]
mod tests {
    use num_integer::Integer as _;
    use quickcheck::{Gen, QuickCheck};

    use crate::{Fixed, Integer};

    /// An odd integer of the limbs given, of which edges are as likely as anything else.
    fn odd(limbs: &[u64]) -> Integer {
        let limb = |seed: &u64| match seed % 7 {
            0 => 0,
            1 => u64::MAX,
            2 => 1 << 63,
            _ => seed.wrapping_mul(0x9e37_79b9_7f4a_7c15),
        };
        let all = limbs.iter().map(limb).fold(Integer::ZERO, |sum, limb| (sum << 64_u32) + limb);
        (all << 1_u32) + 1
    }

    #[test]
    fn the_divisor_and_the_quotients_are_those_of_integers_of_any_size() {
        fn agrees(a: Vec<u64>, b: Vec<u64>, common: Vec<u64>) -> bool {
            let [a, b, common] = [(a, 5), (b, 5), (common, 4)]
                .map(|(limbs, most)| odd(&limbs[..limbs.len().min(most)]));
            let (a, b) = (a * &common, b * common);
            let expected = a.gcd(&b);
            let (short_a, short_b) = (Fixed::<16>::of(&a), Fixed::of(&-&b));
            let found = short_a.gcd(&short_b);
            found.to_integer() == expected
                && short_a.exact_quotient(&found).to_integer() == a / &expected
                && short_b.exact_quotient(&found).to_integer() == -b / expected
        }
        QuickCheck::new()
            .rng(Gen::from_size_and_seed(20, 0x6b61_6e65))
            .tests(5_000)
            .quickcheck(agrees as fn(_, _, _) -> bool);
    }

    #[test]
    fn equal_low_limbs_and_full_lengths_are_no_exception() {
        let one = Integer::from(1);
        let full = (&one << 1024_u32) - &one;
        let cases = [
            (full.clone(), full.clone()),
            (full.clone(), one.clone()),
            (full.clone(), (&one << 512_u32) - &one),
            (full, (&one << 1000_u32) - &one),
            ((&one << 640_u32) + &one, (&one << 192_u32) + &one),
            ((&one << 192_u32) + 7, (&one << 191_u32) + 7),
            ((&one << 129_u32) - &one, (&one << 128_u32) - &one),
            (Integer::from(u64::MAX), Integer::from(u128::MAX)),
        ];
        for (a, b) in cases {
            let found = Fixed::<16>::of(&a).gcd(&Fixed::of(&b)).to_integer();
            assert_eq!(found, a.gcd(&b), "{a}, {b}");
        }
    }
}
