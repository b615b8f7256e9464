//! What camera matrices and projection matrices say.

use crate::checks::{Pinhole, agree};
use crate::found::Found;
use crate::place::Origin;
use crate::warning::Warning;
use std::ops::RangeInclusive;

/// Two numbers as width and height, where they are some.
pub(super) fn size([width, height]: [f64; 2]) -> Option<[u32; 2]> {
    let side = |number: f64| {
        let is_side = (1.0..=100_000.0).contains(&number) && number.fract() == 0.0;
        // Exact: a whole number below 2¹⁷.
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        is_side.then_some(number as u32)
    };
    Some([side(width)?, side(height)?])
}

/// The numbers of a camera matrix, row after row, as fx, fy, cx, cy.
pub(super) const fn of_matrix([fx, _, cx, _, fy, cy, ..]: [f64; 9]) -> Pinhole {
    [fx, fy, cx, cy]
}

/// The same of one that comes column after column: its last column is then 0, 0, 1. Nothing of any other.
pub(super) fn of_columns([fx, _, zero, _, fy, other_zero, cx, cy, one]: [f64; 9]) -> Option<Pinhole> {
    let is_turned = [zero, other_zero, one - 1.0] == [0.0; 3] && cx > 1.0 && cy > 1.0;
    is_turned.then_some([fx, fy, cx, cy])
}

/// The same of a matrix that may have rows for columns, as MATLAB has it: which is said.
///
/// One whose last number is not 1 is the same camera’s where all are divided by it: which is said.
pub(super) fn read_matrix(matrix: [f64; 9], origin: &Origin, warnings: &mut Vec<Warning>) -> Pinhole {
    let [.., zero, other_zero, last] = matrix;
    if [zero, other_zero] == [0.0; 2] && SCALES.contains(&last) && (last - 1.0).abs() > SAME_SCALE {
        let origin = origin.clone();
        let warning = Warning::Scale { origin, last };
        if !warnings.contains(&warning) {
            warnings.push(warning);
        }
        return of_matrix(matrix.map(|number| number / last));
    }
    let Some(turned) = of_columns(matrix) else {
        return of_matrix(matrix);
    };
    let warning = Warning::Transposed { origin: origin.clone() };
    if !warnings.contains(&warning) {
        warnings.push(warning);
    }
    turned
}

/// A camera matrix may be multiplied by something between these.
const SCALES: RangeInclusive<f64> = 0.1..=10.0;
/// The last number of a matrix is 1 to this.
const SAME_SCALE: f64 = 1e-6;

/// Why a projection matrix cannot be used, in a few words; `None` where its last number but one is 1, as rectification makes it.
pub(super) fn scaled(projection: Projection) -> Option<String> {
    let last = projection.last;
    ((last - 1.0).abs() > SAME_SCALE).then(|| format!("the third number of its last row is {last}, not 1"))
}

/// A projection matrix that may have rows for columns: then its third column is 0, 0, 1, 0, which is said.
pub(super) fn read_projection(matrix: [f64; 12], origin: &Origin, warnings: &mut Vec<Warning>) -> Projection {
    let [fx, _, zero, _, fy, other_zero, cx, cy, one, tx, ty, last] = matrix;
    let is_turned = [zero, other_zero, one - 1.0, last] == [0.0; 4] && cx > 1.0 && cy > 1.0;
    if !is_turned {
        return Projection::new(matrix);
    }
    warnings.push(Warning::Transposed { origin: origin.clone() });
    Projection {
        pinhole: [fx, fy, cx, cy],
        shift: [tx, ty],
        last: one,
    }
}

/// A projection matrix of a rectified camera: P = K·(I | t) with t along the row or the column of the images.
///
/// Source: ROS REP 104 and `sensor_msgs/CameraInfo`: `Tx = −fx′·B`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Projection {
    pub(super) pinhole: Pinhole,
    /// `P[0][3]` and `P[1][3]`.
    pub(super) shift: [f64; 2],
    /// `P[2][2]`, which is 1.
    pub(super) last: f64,
}

impl Projection {
    pub(super) const fn new([fx, _, cx, tx, _, fy, cy, ty, _, _, last, _]: [f64; 12]) -> Self {
        Self {
            pinhole: [fx, fy, cx, cy],
            shift: [tx, ty],
            last,
        }
    }

    /// How far `right` stands to the right of this camera, and how far below, in the unit of the file.
    pub(super) fn to(self, right: Self) -> [f64; 2] {
        // Each by its own focal length, which differ in files that are stale.
        let ([fx, fy, ..], [gx, gy, ..]) = (self.pinhole, right.pinhole);
        let ([tx, ty], [ux, uy]) = (self.shift, right.shift);
        [tx / fx - ux / gx, ty / fy - uy / gy]
    }
}

/// How a baseline follows from two projection matrices: `P2[0][3] / P2[0][0]`, or from both where both have a shift.
pub(super) fn how([first, second]: [&str; 2], [left, right]: [Projection; 2]) -> String {
    let row = usize::from(is_vertical(left.to(right)));
    let shift = |one: Projection| one.shift.get(row).copied().unwrap_or_default();
    let [[one, ..], [other, ..]] = [left.pinhole, right.pinhole];
    let focal = format!("{second}[{row}][{row}]");
    let first_focal = format!("{first}[{row}][{row}]");
    match [shift(left), shift(right)].map(|shift| shift == 0.0) {
        [true, _] => format!("{second}[{row}][3] / {focal}"),
        [false, true] => format!("{first}[{row}][3] / {first_focal}"),
        _ if !agree(one, other) => format!("{first}[{row}][3] / {first_focal} - {second}[{row}][3] / {focal}"),
        _ => format!("({first}[{row}][3] - {second}[{row}][3]) / {focal}"),
    }
}

/// Whether a camera so far to the right and so far below stands below another rather than beside it.
fn is_vertical([right, down]: [f64; 2]) -> bool {
    down.abs() > right.abs()
}

/// Makes two cameras the pair, of which the second stands so far to the right of the first, and so far below. Returns the length.
pub(super) fn place_pair(found: &mut Found, [first, second]: [usize; 2], [right, down]: [f64; 2]) -> f64 {
    found.is_vertical = is_vertical([right, down]);
    let along = if found.is_vertical { down } else { right };
    found.pair = Some(if along < 0.0 { [second, first] } else { [first, second] });
    if along == 0.0 {
        found.warnings.push(Warning::ZeroBaseline);
    }
    if found.is_vertical {
        found.warnings.push(Warning::Vertical);
    }
    if along < 0.0 {
        found.warnings.push(if found.is_vertical {
            Warning::SwappedRows
        } else {
            Warning::Swapped
        });
    }
    along.abs()
}
