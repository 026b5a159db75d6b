//! Vectors in space.

use kane_number::Number;

/// x, y and z.
pub(crate) type Vector<N> = [N; 3];

/// a·b
pub(crate) fn dot<N: Number>(a: &Vector<N>, b: &Vector<N>) -> N {
    a[0].clone() * &b[0] + a[1].clone() * &b[1] + a[2].clone() * &b[2]
}

/// a·a, which on intervals is never below 0.
pub(crate) fn square<N: Number>(a: &Vector<N>) -> N {
    a[0].square() + a[1].square() + a[2].square()
}

/// a × b
pub(crate) fn cross<N: Number>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    let entry = |i: usize, j: usize| a[i].clone() * &b[j] - a[j].clone() * &b[i];
    [entry(1, 2), entry(2, 0), entry(0, 1)]
}

/// a + b
pub(crate) fn plus<N: Number>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    [0, 1, 2].map(|k| a[k].clone() + &b[k])
}

/// a − b
pub(crate) fn minus<N: Number>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    [0, 1, 2].map(|k| a[k].clone() - &b[k])
}

/// c·a
pub(crate) fn times<N: Number>(c: &N, a: &Vector<N>) -> Vector<N> {
    [0, 1, 2].map(|k| c.clone() * &a[k])
}

/// a/c
pub(crate) fn over<N: Number>(a: &Vector<N>, c: &N) -> Vector<N> {
    [0, 1, 2].map(|k| a[k].clone() / c)
}
