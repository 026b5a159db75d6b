//! The four operators of a number system, from one function each.

/// Implements `Add`, `Sub`, `Mul` and `Div`, with the right operand by value and by reference,
/// from the functions `sum`, `difference`, `product` and `quotient` of the type, which take two
/// references; and `Neg` from `opposite`.
macro_rules! operators {
    ($number:ident) => {
        $crate::operators::operators!($number, Add, add, sum);
        $crate::operators::operators!($number, Sub, sub, difference);
        $crate::operators::operators!($number, Mul, mul, product);
        $crate::operators::operators!($number, Div, div, quotient);

        impl std::ops::Neg for $number {
            type Output = Self;

            fn neg(self) -> Self {
                self.opposite()
            }
        }
    };
    ($number:ident, $operator:ident, $method:ident, $function:ident) => {
        impl std::ops::$operator for $number {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Self::$function(&self, &other)
            }
        }

        impl std::ops::$operator<&$number> for $number {
            type Output = Self;

            fn $method(self, other: &Self) -> Self {
                Self::$function(&self, other)
            }
        }
    };
}

pub(crate) use operators;

/// The [`Working`](crate::Real::Working) system of a system that works in itself; its numbers are
/// copied or cloned.
macro_rules! works_in_itself {
    () => {
        type Working = Self;

        fn to_working(&self) -> Self {
            self.clone()
        }

        fn from_working(working: &Self) -> Self {
            working.clone()
        }
    };
}

pub(crate) use works_in_itself;
