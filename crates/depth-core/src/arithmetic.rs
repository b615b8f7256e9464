//! Products and sums of squares that neither overflow nor underflow on the way to a result that can be represented.

/// a·b/c for positive numbers, exact to rounding wherever the result itself is a normal number, even when a·b alone
/// would overflow or underflow.
pub(crate) fn times_over(a: f64, b: f64, c: f64) -> f64 {
    let product = a * b;
    if product.is_normal() {
        product / c
    } else {
        a.max(b) / c * a.min(b)
    }
}

/// a·b/c for any sign of a and b and a positive c; `None` where it cannot be represented.
pub(crate) fn signed_times_over(a: f64, b: f64, c: f64) -> Option<f64> {
    if !(a.is_finite() && b.is_finite() && c.is_finite() && c > 0.0) {
        return None;
    }
    if a == 0.0 || b == 0.0 {
        return Some(0.0);
    }
    let magnitude = times_over(a.abs(), b.abs(), c);
    magnitude.is_finite().then(|| magnitude * a.signum() * b.signum())
}

/// √(Σ x²) without overflow or underflow on the way.
///
/// Only additions, multiplications, divisions and a square root, which are the same on every platform;
/// [`f64::hypot`] is not.
pub(crate) fn root_sum_of_squares(terms: &[f64]) -> f64 {
    let largest = terms.iter().fold(0.0_f64, |largest, term| largest.max(term.abs()));
    if largest == 0.0 || largest.is_infinite() {
        return largest;
    }
    let sum: f64 = terms.iter().map(|term| (term / largest) * (term / largest)).sum();
    largest * sum.sqrt()
}

/// ln(a/b), also where a/b cannot be represented.
pub(crate) fn log_ratio(a: f64, b: f64) -> f64 {
    let ratio = a / b;
    if ratio.is_normal() { ratio.ln() } else { a.ln() - b.ln() }
}
