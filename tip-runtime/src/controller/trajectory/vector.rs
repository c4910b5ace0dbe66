//! Arithmetic of small vectors that neither overflows nor makes NaN of finite members.

/// Returns `a + k b`.
pub(super) fn add_scaled<const N: usize>(mut a: [f64; N], b: [f64; N], k: f64) -> [f64; N] {
    for (a, b) in a.iter_mut().zip(b) {
        *a += k * b;
    }
    a
}

/// Returns the scalar product.
pub(super) fn dot<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + a * b)
}

/// Returns the length.
pub(super) fn norm<const N: usize>(a: [f64; N]) -> f64 {
    split(a).1
}

/// Returns direction and length; a vector without length points along the first axis.
pub(super) fn split<const N: usize>(a: [f64; N]) -> ([f64; N], f64) {
    let largest = a.iter().fold(0.0_f64, |most, a| most.max(libm::fabs(*a)));
    let mut direction = [0.0; N];
    if largest == 0.0 {
        if let Some(first) = direction.first_mut() {
            *first = 1.0;
        }
        return (direction, 0.0);
    }
    for (direction, a) in direction.iter_mut().zip(a) {
        *direction = a / largest;
    }
    let length = libm::sqrt(dot(direction, direction));
    for direction in &mut direction {
        *direction /= length;
    }
    (direction, (largest * length).min(f64::MAX))
}
