//! A camera above a level floor: where the ray of a pixel meets it, or the level plane that a target stands out to.

mod ray;

use crate::angle::Angle;
use crate::arithmetic::root_sum_of_squares;
use crate::field::Field;
use crate::judge::{self, Refusal, Term, Unsolvable};
use crate::measured::Measured;
use crate::quantity::{Length, Pixels};
use ray::{Partials, Ray, Sigmas, along_floor};
use std::f64::consts::FRAC_PI_2;

/// How far below the optical axis a point is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BelowAxis {
    /// At this row of the image.
    Row {
        /// The row, v.
        row: Measured<Pixels>,
        /// Row of the principal point.
        cy: Pixels,
        /// Focal length along the columns. Its σ is that of [`RightOfAxis::fx`] too: they scale together.
        fy: Measured<Pixels>,
    },
    /// At this angle below the axis, in the plane of the axis and the vertical.
    Angle(Measured<Angle>),
}

/// How far to the right of the optical axis a point is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RightOfAxis {
    /// The column, u.
    pub column: Pixels,
    /// Column of the principal point.
    pub cx: Pixels,
    /// Focal length along the rows.
    pub fx: Measured<Pixels>,
}

/// A camera above a level floor, without roll, looking at a point of known height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundView {
    /// Height of the camera above the floor.
    pub height: Measured<Length>,
    /// Height of the point above the floor: 0 for one on the floor. It may be above the camera.
    pub target_height: Length,
    /// How far the optical axis points down from the horizontal.
    pub pitch: Measured<Angle>,
    /// Where the point is seen, up and down.
    pub below_axis: BelowAxis,
    /// Where it is seen, left and right; `None` where that is not asked for: straight ahead.
    pub right_of_axis: Option<RightOfAxis>,
}

/// Where the point is, seen from the floor below the camera, with first-order σ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundSolution {
    /// Along the floor, √(ahead² + right²).
    pub distance: Measured<Length>,
    /// In the direction in which the camera looks; negative behind it.
    pub ahead: Measured<Length>,
    /// To the right of that; `None` without a column.
    pub right: Option<Measured<Length>>,
    /// From the lens to the point.
    pub slant: Measured<Length>,
    /// The row at which the floor ends; `None` without rows, or where the camera looks straight up or down.
    pub horizon_row: Option<Pixels>,
    /// The term behind most of the σ of the distance; `None` where it has none.
    pub main_cause: Option<Term>,
    /// How far below the optical axis the point is seen, α.
    pub below_axis: Angle,
    /// How far it is along the optical axis: what its column is counted at.
    pub depth: Measured<Length>,
    /// How many columns it is to the right of the principal point, u − cx; `None` without a column.
    pub aside: Option<Pixels>,
    /// What each term has of the variance of [`ahead`](Self::ahead), 0 to 1; they add to 1, or are 0 where all is exact.
    pub ahead_shares: [(Term, f64); 4],
    /// The same of [`right`](Self::right).
    pub right_shares: [(Term, f64); 4],
    /// The same of [`distance`](Self::distance).
    pub distance_shares: [(Term, f64); 4],
}

impl GroundView {
    /// Where the ray meets the level plane at the height of the point.
    ///
    /// With h the height of the camera above the point, θ its pitch, y = (v − cy)/fy and x = (u − cx)/fx: the ray (x, y, 1)
    /// meets the plane at its multiple s = h/(sin θ + y·cos θ), which is its depth; ahead s·(cos θ − y·sin θ), right s·x, slant s·√(1 + x² + y²).
    ///
    /// ```
    /// use depth_core::angle::Angle;
    /// use depth_core::camera::{BelowAxis, GroundView};
    /// use depth_core::measured::Measured;
    /// use depth_core::quantity::{Length, Pixels};
    ///
    /// let view = GroundView {
    ///     height: Measured::new(Length::from_m(1.5), Length::from_m(0.1)),
    ///     target_height: Length::from_m(0.0),
    ///     pitch: Measured::exact(Angle::from_degrees(0.0)),
    ///     below_axis: BelowAxis::Row {
    ///         row: Measured::exact(Pixels::new(1050.0)),
    ///         cy: Pixels::new(350.0),
    ///         fy: Measured::exact(Pixels::new(700.0)),
    ///     },
    ///     right_of_axis: None,
    /// };
    /// let floor = view.solve().unwrap();
    /// // A level camera; 700 rows below the axis at f = 700 px is a slope of 45°: as far as the camera is high, and as well known.
    /// assert!((floor.distance.value.m() - 1.5).abs() < 1e-12);
    /// assert!((floor.distance.sigma.m() - 0.1).abs() < 1e-12);
    /// assert_eq!(floor.horizon_row, Some(Pixels::new(350.0)));
    /// ```
    ///
    /// # Errors
    /// [`Unsolvable`].
    ///
    /// Source: intersection of the pixel's ray with a plane (Hartley and Zisserman, 8.1); JCGM 100:2008 (GUM), 5.1.2, for σ.
    pub fn solve(&self) -> Result<GroundSolution, Unsolvable> {
        let ray = self.ray()?;
        let (ahead, right, slant) = (ray.ahead(), ray.right(), ray.slant());
        let distance = along_floor(&ahead, &right);
        let measured = |of: &Partials| ray.measured(of);
        let main_cause = self.main_cause(ray.shares(&distance));
        let sigma = ray.measured(&distance)?.sigma.m() / slant.value;
        judge::relative_sigma(main_cause.unwrap_or(Term::Distance), sigma)?;
        Ok(GroundSolution {
            distance: measured(&distance)?,
            ahead: measured(&ahead)?,
            right: self.right_of_axis.map(|_| measured(&right)).transpose()?,
            slant: measured(&slant)?,
            horizon_row: self.horizon_row(),
            main_cause,
            below_axis: Angle::from_radians(ray.y.atan()),
            depth: measured(&ray.depth())?,
            aside: self.right_of_axis.map(|right| Pixels::new(right.column.px() - right.cx.px())),
            ahead_shares: self.of_variance(ray.shares(&ahead)),
            right_shares: self.of_variance(ray.shares(&right)),
            distance_shares: self.of_variance(ray.shares(&distance)),
        })
    }

    /// What has a σ, in the order of the [shares](Ray::shares).
    const fn terms(&self) -> [Term; 4] {
        let below_axis = match self.below_axis {
            BelowAxis::Row { .. } => Term::Row,
            BelowAxis::Angle(_) => Term::BelowAxis,
        };
        [Term::CameraHeight, Term::Pitch, below_axis, Term::Input(Field::FocalLength)]
    }

    /// The parts of the variance that these [shares](Ray::shares) of σ are.
    fn of_variance(&self, shares: [f64; 4]) -> [(Term, f64); 4] {
        let total = root_sum_of_squares(&shares);
        let mut parts = self.terms().map(|term| (term, 0.0));
        for ((_, part), share) in parts.iter_mut().zip(shares) {
            *part = if total > 0.0 { (share / total) * (share / total) } else { 0.0 };
        }
        parts
    }

    /// The term with the largest of these [shares](Ray::shares).
    fn main_cause(&self, shares: [f64; 4]) -> Option<Term> {
        let shares = self.terms().into_iter().zip(shares.map(f64::abs));
        let largest = shares.max_by(|(_, a), (_, b)| a.total_cmp(b));
        largest.filter(|(_, share)| *share > 0.0).map(|(term, _)| term)
    }

    /// The ray, where it meets the plane.
    fn ray(&self) -> Result<Ray, Unsolvable> {
        let height = judge::positive_measured(Term::CameraHeight, self.height)?;
        judge::value(Term::TargetHeight, judge::finite(self.target_height.m()))?;
        let pitch = judge::angle_measured(Term::Pitch, self.pitch)?;
        let y = self.slope_down()?;
        let x = self.slope_right()?;
        let h = height.value.m() - self.target_height.m();
        if h == 0.0 {
            // The plane of the target goes through the lens and is seen from its edge.
            return Err(Unsolvable::Value {
                term: Term::TargetHeight,
                refusal: Refusal::Zero,
            });
        }
        let (sin, cos) = sin_cos(pitch.value);
        let down = sin + y.value * cos;
        // What is left of a horizontal ray by rounding is none of its own.
        let down = if down.abs() <= 4.0 * f64::EPSILON * (1.0 + y.value.abs()) {
            0.0
        } else {
            down
        };
        let s = h / down;
        if s.is_infinite() && down != 0.0 {
            return Err(Unsolvable::too_extreme(Term::Distance));
        }
        if !(s.is_finite() && s > 0.0) {
            let with_opposite_pitch = h / (y.value * cos - sin);
            return Err(Unsolvable::MissesPlane {
                horizon: self.horizon_row(),
                meets_with_opposite_pitch: down != 0.0 && with_opposite_pitch.is_finite() && with_opposite_pitch > 0.0,
            });
        }
        let focal_length = self.relative_sigma_of_focal_length();
        let is_row = matches!(self.below_axis, BelowAxis::Row { .. });
        Ok(Ray {
            x,
            y: y.value,
            h,
            cos,
            down,
            forward: cos - y.value * sin,
            s,
            sigmas: Sigmas {
                height: height.sigma.m(),
                pitch: pitch.sigma.radians(),
                slope: y.sigma,
                // A longer focal length makes both slopes smaller; an angle does not depend on it.
                focal_slope: if is_row { y.value * focal_length } else { 0.0 },
                focal_slope_right: x * focal_length,
            },
        })
    }

    /// The row at which the floor ends, v = cy − fy·tan θ; `None` without rows, or where the camera looks straight down or the
    /// numbers are unusable.
    ///
    /// ```
    /// # use depth_core::angle::Angle;
    /// # use depth_core::camera::{BelowAxis, GroundView};
    /// # use depth_core::measured::Measured;
    /// # use depth_core::quantity::{Length, Pixels};
    /// let view = GroundView {
    ///     height: Measured::exact(Length::from_m(1.5)),
    ///     target_height: Length::from_m(0.0),
    ///     pitch: Measured::exact(Angle::from_degrees(0.0)),
    ///     below_axis: BelowAxis::Row { row: Measured::exact(Pixels::new(1050.0)), cy: Pixels::new(350.0), fy: Measured::exact(Pixels::new(700.0)) },
    ///     right_of_axis: None,
    /// };
    /// // The camera is level: the horizon goes through the principal point.
    /// assert_eq!(view.horizon_row(), Some(Pixels::new(350.0)));
    /// ```
    ///
    /// Source: the row of [`solve`](Self::solve) whose ray is horizontal.
    pub fn horizon_row(&self) -> Option<Pixels> {
        let BelowAxis::Row { cy, fy, .. } = self.below_axis else {
            return None;
        };
        self.slope_down().ok()?;
        let row = cy.px() - fy.value.px() * self.pitch.value.radians().tan();
        (self.pitch.value.radians().abs() < FRAC_PI_2 && row.is_finite()).then_some(Pixels::new(row))
    }

    fn relative_sigma_of_focal_length(&self) -> f64 {
        let of_rows = match self.below_axis {
            BelowAxis::Row { fy, .. } => fy.relative(),
            BelowAxis::Angle(_) => 0.0,
        };
        self.right_of_axis.map_or(of_rows, |right| right.fx.relative().max(of_rows))
    }

    /// y with its σ without that of the focal length: (v − cy)/fy, or the tangent of the angle.
    fn slope_down(&self) -> Result<Measured<f64>, Unsolvable> {
        match self.below_axis {
            BelowAxis::Row { row, cy, fy } => {
                let row = judge::finite_measured(Term::Row, row)?;
                let fy = judge::positive_measured(Term::Input(Field::FocalLength), fy)?.value.px();
                let cy = judge::value(Term::PrincipalPoint, judge::finite(cy.px()))?;
                let slope = judge::value(Term::Row, judge::finite((row.value.px() - cy) / fy))?;
                Ok(Measured::new(slope, row.sigma.px() / fy))
            }
            BelowAxis::Angle(angle) => {
                let angle = judge::angle_measured(Term::BelowAxis, angle)?;
                if angle.value.radians().abs() >= FRAC_PI_2 {
                    return Err(Unsolvable::Value {
                        term: Term::BelowAxis,
                        refusal: Refusal::TurnedAway,
                    });
                }
                let slope = angle.value.radians().tan();
                Ok(Measured::new(slope, angle.sigma.radians() * (1.0 + slope * slope)))
            }
        }
    }

    /// x, (u − cx)/fx; 0 without a column.
    fn slope_right(&self) -> Result<f64, Unsolvable> {
        let Some(RightOfAxis { column, cx, fx }) = self.right_of_axis else {
            return Ok(0.0);
        };
        let column = judge::value(Term::Column, judge::finite(column.px()))?;
        let cx = judge::value(Term::PrincipalPoint, judge::finite(cx.px()))?;
        let fx = judge::positive_measured(Term::Input(Field::FocalLength), fx)?.value.px();
        judge::value(Term::Column, judge::finite((column - cx) / fx))
    }
}

/// Sine and cosine, the latter 0 at 90°: the number nearest to a right angle is up to 1.1e-16 rad away from it.
fn sin_cos(angle: Angle) -> (f64, f64) {
    let (sin, cos) = angle.radians().sin_cos();
    (sin, if cos.abs() < f64::EPSILON { 0.0 } else { cos })
}
