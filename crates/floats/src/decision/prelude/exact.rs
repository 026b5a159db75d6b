/// An exact number: digits in base 2^32, the least first, times 2^exponent. Nothing of it is rounded.
#[derive(Clone, Debug)]
struct Exact {
    sign: i32,
    exponent: i64,
    digits: Vec<u32>,
}

impl Exact {
    fn new(sign: i32, exponent: i64, mut digits: Vec<u32>) -> Self {
        while digits.last() == Some(&0) {
            digits.pop();
        }
        let sign = if digits.is_empty() { 0 } else { sign };
        Exact { sign, exponent, digits }
    }

    /// The value of a finite float.
    fn of(x: f64) -> Self {
        let bits = x.to_bits();
        let field = (bits >> 52 & 0x7ff) as i64;
        let fraction = bits & ((1 << 52) - 1);
        let whole = if field == 0 { fraction } else { fraction | 1 << 52 };
        let sign = if bits >> 63 == 0 { 1 } else { -1 };
        Exact::new(sign, field.max(1) - 1075, vec![whole as u32, (whole >> 32) as u32])
    }

    fn integer(sign: i32, digits: &[u32]) -> Self {
        Exact::new(sign, 0, digits.to_vec())
    }

    /// The digits of the number over 2^exponent, for an exponent that is not above its own.
    fn over(&self, exponent: i64) -> Vec<u32> {
        let by = (self.exponent - exponent) as u64;
        let mut digits = vec![0; (by / 32) as usize];
        let mut carry = 0_u64;
        for digit in &self.digits {
            carry |= u64::from(*digit) << (by % 32);
            digits.push(carry as u32);
            carry >>= 32;
        }
        digits.push(carry as u32);
        digits
    }

    fn signed_sum(&self, other: &Self, other_sign: i32) -> Self {
        if self.sign == 0 || other_sign == 0 {
            let (one, sign) = if self.sign == 0 { (other, other_sign) } else { (self, self.sign) };
            return Exact::new(sign, one.exponent, one.digits.clone());
        }
        let exponent = self.exponent.min(other.exponent);
        let (mut a, mut b) = (self.over(exponent), other.over(exponent));
        let count = a.len().max(b.len()) + 1;
        a.resize(count, 0);
        b.resize(count, 0);
        let mut sign = self.sign;
        if sign != other_sign && a.iter().rev().lt(b.iter().rev()) {
            std::mem::swap(&mut a, &mut b);
            sign = other_sign;
        }
        let mut carry = 0_i64;
        for (digit, other) in a.iter_mut().zip(&b) {
            let other = if self.sign == other_sign { i64::from(*other) } else { -i64::from(*other) };
            carry += i64::from(*digit) + other;
            *digit = carry as u32;
            carry >>= 32;
        }
        Exact::new(sign, exponent, a)
    }

    fn sum(&self, other: &Self) -> Self {
        self.signed_sum(other, other.sign)
    }

    fn difference(&self, other: &Self) -> Self {
        self.signed_sum(other, -other.sign)
    }

    fn product(&self, other: &Self) -> Self {
        let mut digits = vec![0_u32; self.digits.len() + other.digits.len()];
        for (at, a) in self.digits.iter().enumerate() {
            let mut carry = 0_u64;
            for (digit, b) in digits[at..].iter_mut().zip(other.digits.iter().chain(&[0])) {
                carry += u64::from(*digit) + u64::from(*a) * u64::from(*b);
                *digit = carry as u32;
                carry >>= 32;
            }
        }
        Exact::new(self.sign * other.sign, self.exponent + other.exponent, digits)
    }
}

/// The sign of a + b*sqrt(c), of those of a, b and a^2 - b^2*c.
fn root_sign(a: i32, b: i32, norm: i32) -> i32 {
    if b == 0 || a == b {
        a
    } else if norm > 0 {
        a
    } else if norm < 0 {
        b
    } else {
        0
    }
}

/// Half an ulp of 1; more than a few roundings of a bound lose; more than a few underflows.
const HALF: f64 = 1.1102230246251565e-16;
const MORE: f64 = 1.0000000000000036;
const TINY: f64 = 1e-310;
