//! The point in space that a pixel shows, and its range.

use super::intrinsics::{offset_from_axis, range_of};
use crate::arithmetic::root_sum_of_squares;
use crate::field::Field;
use crate::judge::{self, Refusal, Term, Unsolvable};
use crate::measured::Measured;
use crate::quantity::{Length, Pixels};

/// How far away the point is, and along what.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Along {
    /// Along the optical axis: the depth Z, with its σ but for what the focal length has in it
    /// ([`own_relative_sigma`](crate::uncertainty::Model::own_relative_sigma)).
    Axis(Measured<Length>),
    /// Along the optical axis, measured by other means, so that the focal length has no part in its σ.
    GivenDepth(Measured<Length>),
    /// Along the ray of the pixel: the range R, as a tape measure or a laser shows it.
    Ray(Measured<Length>),
}

/// A pixel, and how far away what is seen there is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointView {
    /// Focal length along the rows.
    pub fx: Measured<Pixels>,
    /// Focal length along the columns; equals `fx` for square pixels. Their ratio is taken to be exact.
    pub fy: Pixels,
    /// Column of the principal point.
    pub cx: Pixels,
    /// Row of the principal point.
    pub cy: Pixels,
    /// Column at which the point is seen, u.
    pub column: Pixels,
    /// Row at which the point is seen, v.
    pub row: Pixels,
    /// How far away it is.
    pub along: Along,
    /// What of its depth is no distance from the center of projection: the focal length of a lens that was added, less how far in
    /// front of it distances are counted from. Nearly always 0. Taken to be exact.
    pub shift: Length,
}

/// Where a point is, with first-order σ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointSolution {
    /// How far it is to the right of the optical axis.
    pub x: Measured<Length>,
    /// How far it is below the optical axis.
    pub y: Measured<Length>,
    /// Its depth along the optical axis.
    pub z: Measured<Length>,
    /// How far it is from the camera, as a tape measure or a laser shows it.
    pub range: Measured<Length>,
}

impl PointView {
    /// The point and its range: X = (u − cx)·Z/fx, Y = (v − cy)·Z/fy, R = √(X² + Y² + Z²).
    ///
    /// With r_f the relative σ of the focal length and r that of what is given without it: from a depth, which grows with f,
    /// X and Y do not depend on f, so that σ_X/X = σ_Y/Y = r, σ_Z/Z = √(r² + r_f²) and σ_R/R = √(r² + (r_f·Z²/R²)²). From a
    /// depth that is known apart from f σ_X/X = σ_Y/Y = √(r² + r_f²), σ_Z/Z = r and σ_R/R = √(r² + (r_f·(1 − Z²/R²))²). From a
    /// range σ_Z/Z = √(r² + (r_f·(1 − Z²/R²))²) and σ_X/X = σ_Y/Y = √(r² + (r_f·Z²/R²)²).
    ///
    /// ```
    /// use depth_core::camera::{Along, PointView};
    /// use depth_core::measured::Measured;
    /// use depth_core::quantity::{Length, Pixels};
    ///
    /// let px = Pixels::new;
    /// let at = |along| PointView { fx: Measured::from_base(500.0, 0.0), fy: px(1000.0), cx: px(100.0), cy: px(100.0), column: px(600.0), row: px(1100.0), along, shift: Length::from_m(0.0) };
    /// let point = at(Along::Axis(Measured::from_base(2.0, 0.1))).solve().unwrap();
    /// // A ray of (2, 2, 2) m, all of it known to 5 %.
    /// assert_eq!((point.x.value.m(), point.y.value.m(), point.z.value.m()), (2.0, 2.0, 2.0));
    /// assert!((point.range.value.m() - 12.0_f64.sqrt()).abs() < 1e-12);
    /// assert!((point.x.sigma.m() - 0.1).abs() < 1e-12);
    ///
    /// // And back.
    /// let back = at(Along::Ray(point.range)).solve().unwrap();
    /// assert!((back.z.value.m() - 2.0).abs() < 1e-12);
    /// ```
    ///
    /// # Errors
    /// [`Unsolvable`].
    ///
    /// Source: inverse of the pinhole projection; Point Grey knowledge base article 10102; JCGM 100:2008 (GUM), 5.1, for σ.
    pub fn solve(&self) -> Result<PointSolution, Unsolvable> {
        let focal_length = Term::Input(Field::FocalLength);
        judge::positive_measured(focal_length, self.fx)?;
        judge::value(focal_length, judge::positive(self.fy.px()))?;
        judge::value(Term::PrincipalPoint, judge::finite(self.cx.px()))?;
        judge::value(Term::PrincipalPoint, judge::finite(self.cy.px()))?;
        judge::value(Term::Column, judge::finite(self.column.px()))?;
        judge::value(Term::Row, judge::finite(self.row.px()))?;
        let given = match self.along {
            Along::Axis(length) | Along::GivenDepth(length) | Along::Ray(length) => judge::positive_measured(Term::Distance, length)?,
        };
        let depth = match self.along {
            Along::Axis(depth) | Along::GivenDepth(depth) => depth.value,
            Along::Ray(range) => self.depth_at(range.value)?,
        };
        let from_center = judge::value(Term::Distance, judge::positive(depth.m() - self.shift.m())).map(Length::from_m)?;
        let x = offset_from_axis(self.column, self.cx, from_center, self.fx.value).ok_or(Unsolvable::too_extreme(Term::Column))?;
        let y = offset_from_axis(self.row, self.cy, from_center, self.fy).ok_or(Unsolvable::too_extreme(Term::Row))?;
        let range = range_of(x, y, depth).ok_or(Unsolvable::too_extreme(Term::Distance))?;
        // All as multiples of the range, which neither overflow nor underflow.
        let [center, z] = [from_center, depth].map(|length| length.m() / range.m());
        let aside = root_sum_of_squares(&[x.m() / range.m(), y.m() / range.m()]);
        let (sigma, rf) = (given.sigma.m(), self.fx.relative());
        let with = |value: Length, own: f64, of_focal_length: f64| {
            let terms = [own * sigma, of_focal_length * rf * range.m()];
            Measured::new(value, Length::from_m(root_sum_of_squares(&terms)))
        };
        let [right, down] = [x, y].map(|offset| (offset.m() / range.m()).abs());
        // dR/dP, the derivative of the range along the ray.
        let along_ray = (aside * aside + z * center) / center;
        Ok(match self.along {
            Along::Axis(_) => PointSolution {
                x: with(x, right / center, 0.0),
                y: with(y, down / center, 0.0),
                z: with(depth, 1.0, center),
                range: with(range, along_ray, z * center),
            },
            Along::GivenDepth(_) => PointSolution {
                x: with(x, right / center, right),
                y: with(y, down / center, down),
                z: with(depth, 1.0, 0.0),
                range: with(range, along_ray, aside * aside),
            },
            Along::Ray(range) => PointSolution {
                x: with(x, right / (center * along_ray), right * z / along_ray),
                y: with(y, down / (center * along_ray), down * z / along_ray),
                z: with(depth, 1.0 / along_ray, aside * aside / along_ray),
                range,
            },
        })
    }

    /// Z from R² = ρ²·P² + (P + t)², with P the depth from the center of projection, ρ the slope of the ray against the axis and t the
    /// [shift](Self::shift); without a shift Z = R/√(1 + ρ²).
    fn depth_at(&self, range: Length) -> Result<Length, Unsolvable> {
        let right = (self.column.px() - self.cx.px()) / self.fx.value.px();
        let down = (self.row.px() - self.cy.px()) / self.fy.px();
        let slope = root_sum_of_squares(&[1.0, right, down]);
        let shift = self.shift.m();
        // P·(1 + ρ²) + t is the root of what is left of the square.
        let rest = root_sum_of_squares(&[right, down]) * shift / slope;
        let foot = shift / (slope * slope);
        let depth = if shift == 0.0 {
            range.m() / slope
        } else if rest.abs() < range.m() {
            ((range.m() - rest) * (range.m() + rest)).sqrt() / slope - foot + shift
        } else {
            return judge::value(Term::Distance, Err(Refusal::BehindZero)).map(Length::from_m);
        };
        judge::value(Term::Distance, judge::positive(depth)).map(Length::from_m)
    }
}
