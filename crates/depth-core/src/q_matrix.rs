//! Reading OpenCV's Q matrix, which turns a disparity into a point in space.

use crate::quantity::Pixels;

/// What a Q matrix says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StereoGeometry {
    /// f, px
    pub focal_length: Pixels,
    /// b, in whatever unit the calibration target was measured in: the matrix does not say.
    pub baseline: f64,
    /// δ = cx_right − cx_left, px: Z = f·b/(d + δ)
    pub doffs: Pixels,
    /// Column of the left principal point, px
    pub cx: Pixels,
    /// Row of the principal point, px
    pub cy: Pixels,
    /// Whether positive disparities give negative depths: left and right were swapped, or T has the wrong sign.
    pub swapped: bool,
}

/// The entry that shows that a matrix is no Q matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WrongEntry {
    /// 0 to 3
    pub row: usize,
    /// 0 to 3
    pub column: usize,
    /// The value of the entry.
    pub found: f64,
    /// What the entry of a Q matrix must be.
    pub expected: Expected,
}

/// What an entry of a Q matrix must be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Expected {
    /// This number.
    Exactly(f64),
    /// A positive number: the focal length.
    Positive,
    /// Any number but 0: −1/T.
    NotZero,
    /// A finite number.
    Finite,
}

/// Entries of the form 0 and 1 may be this far off, to allow for files with few digits.
const TOLERANCE: f64 = 1e-6;

/// The geometry in a Q matrix of a horizontal pair:
///
/// ```text
/// 1  0  0    −cx
/// 0  1  0    −cy
/// 0  0  0     f
/// 0  0  −1/T  (cx − cx')/T
/// ```
///
/// f = Q₂₃, b = 1/|Q₃₂|, δ = Q₃₃/Q₃₂, cx = −Q₀₃, cy = −Q₁₃; T is negative for a left and a right camera in this order.
/// The matrix of a vertical pair looks the same; its δ then belongs to the rows.
///
/// # Errors
/// [`WrongEntry`], the first in reading order.
///
/// Source: OpenCV, `stereoRectify` and `reprojectImageTo3D`; signs as measured with OpenCV 4.14 and 5.0.
pub fn read(q: &[[f64; 4]; 4]) -> Result<StereoGeometry, WrongEntry> {
    use Expected::{Exactly, Finite, NotZero, Positive};
    let expected = [
        [Exactly(1.0), Exactly(0.0), Exactly(0.0), Finite],
        [Exactly(0.0), Exactly(1.0), Exactly(0.0), Finite],
        [Exactly(0.0), Exactly(0.0), Exactly(0.0), Positive],
        [Exactly(0.0), Exactly(0.0), NotZero, Finite],
    ];
    for (row, (found, expected)) in q.iter().zip(expected).enumerate() {
        for (column, (&found, expected)) in found.iter().zip(expected).enumerate() {
            if !expected.is_met_by(found) {
                return Err(WrongEntry {
                    row,
                    column,
                    found,
                    expected,
                });
            }
        }
    }
    let [
        [_, _, _, minus_cx],
        [_, _, _, minus_cy],
        [_, _, _, focal_length],
        [_, _, w_per_d, w],
    ] = *q;
    // Adding zero takes the sign from a zero that was divided by a negative number.
    let doffs = w / w_per_d + 0.0;
    if !doffs.is_finite() {
        return Err(WrongEntry {
            row: 3,
            column: 3,
            found: w,
            expected: Finite,
        });
    }
    Ok(StereoGeometry {
        focal_length: Pixels::new(focal_length),
        baseline: 1.0 / w_per_d.abs(),
        doffs: Pixels::new(doffs),
        cx: Pixels::new(0.0 - minus_cx),
        cy: Pixels::new(0.0 - minus_cy),
        swapped: w_per_d < 0.0,
    })
}

/// The Q matrix that `stereoRectify` makes for `geometry`: the inverse of [`read`]. `None` where a number cannot stand in it.
///
/// ```
/// use depth_core::q_matrix::{of, read};
///
/// let q = [[1.0, 0.0, 0.0, -610.0], [0.0, 1.0, 0.0, -350.0], [0.0, 0.0, 0.0, 700.0], [0.0, 0.0, 0.01, 0.4]];
/// assert_eq!(of(&read(&q).unwrap()), Some(q));
/// ```
///
/// Source: OpenCV, `stereoRectify`.
pub fn of(geometry: &StereoGeometry) -> Option<[[f64; 4]; 4]> {
    let sign = if geometry.swapped { -1.0 } else { 1.0 };
    let w_per_d = sign / geometry.baseline;
    let matrix = [
        [1.0, 0.0, 0.0, 0.0 - geometry.cx.px()],
        [0.0, 1.0, 0.0, 0.0 - geometry.cy.px()],
        [0.0, 0.0, 0.0, geometry.focal_length.px()],
        [0.0, 0.0, w_per_d, geometry.doffs.px() * w_per_d + 0.0],
    ];
    read(&matrix).is_ok().then_some(matrix)
}

impl Expected {
    fn is_met_by(self, found: f64) -> bool {
        match self {
            Self::Exactly(number) => (found - number).abs() <= TOLERANCE,
            Self::Positive => found.is_normal() && found > 0.0,
            // The reciprocal is the baseline.
            Self::NotZero => found.is_normal() && found.recip().is_normal(),
            Self::Finite => found.is_finite(),
        }
    }
}
