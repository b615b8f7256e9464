//! The point in space that a pixel shows, and its range.

use super::intrinsics::{offset_from_axis, range_of};
use crate::field::Field;
use crate::judge::{self, Term, Unsolvable};
use crate::quantity::{Length, Pixels};

/// A pixel, and the depth of what is seen there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointView {
    /// Focal length along the rows.
    pub fx: Pixels,
    /// Focal length along the columns; equals `fx` for square pixels.
    pub fy: Pixels,
    /// Column of the principal point.
    pub cx: Pixels,
    /// Row of the principal point.
    pub cy: Pixels,
    /// Column at which the point is seen, u.
    pub column: Pixels,
    /// Row at which the point is seen, v.
    pub row: Pixels,
    /// Its depth along the optical axis.
    pub depth: Length,
}

/// Where a point is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointSolution {
    /// How far it is to the right of the optical axis.
    pub x: Length,
    /// How far it is below the optical axis.
    pub y: Length,
    /// Its depth along the optical axis.
    pub z: Length,
    /// How far it is from the camera, as a tape measure or a laser shows it.
    pub range: Length,
}

impl PointView {
    /// The point and its range: X = (u − cx)·Z/fx, Y = (v − cy)·Z/fy, R = √(X² + Y² + Z²).
    ///
    /// ```
    /// use depth_core::camera::PointView;
    /// use depth_core::quantity::{Length, Pixels};
    ///
    /// let px = Pixels::new;
    /// let view = PointView { fx: px(500.0), fy: px(1000.0), cx: px(100.0), cy: px(100.0), column: px(600.0), row: px(1100.0), depth: Length::from_m(2.0) };
    /// let point = view.solve().unwrap();
    /// // A ray of (2, 2, 2) m.
    /// assert_eq!((point.x.m(), point.y.m(), point.z.m()), (2.0, 2.0, 2.0));
    /// assert!((point.range.m() - 12.0_f64.sqrt()).abs() < 1e-12);
    /// ```
    ///
    /// # Errors
    /// [`Unsolvable`].
    ///
    /// Source: inverse of the pinhole projection; Point Grey knowledge base article 10102.
    pub fn solve(&self) -> Result<PointSolution, Unsolvable> {
        let focal_length = Term::Input(Field::FocalLength);
        judge::value(focal_length, judge::positive(self.fx.px()))?;
        judge::value(focal_length, judge::positive(self.fy.px()))?;
        judge::value(Term::PrincipalPoint, judge::finite(self.cx.px()))?;
        judge::value(Term::PrincipalPoint, judge::finite(self.cy.px()))?;
        judge::value(Term::Column, judge::finite(self.column.px()))?;
        judge::value(Term::Row, judge::finite(self.row.px()))?;
        judge::value(Term::Distance, judge::positive(self.depth.m()))?;
        let x = offset_from_axis(self.column, self.cx, self.depth, self.fx).ok_or(Unsolvable::too_extreme(Term::Column))?;
        let y = offset_from_axis(self.row, self.cy, self.depth, self.fy).ok_or(Unsolvable::too_extreme(Term::Row))?;
        let range = range_of(x, y, self.depth).ok_or(Unsolvable::too_extreme(Term::Distance))?;
        Ok(PointSolution {
            x,
            y,
            z: self.depth,
            range,
        })
    }
}
