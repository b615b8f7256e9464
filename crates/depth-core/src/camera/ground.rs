//! A camera above a flat, level floor: the distance along the floor.

use crate::angle::Angle;
use crate::arithmetic::root_sum_of_squares;
use crate::field::Field;
use crate::judge::{self, Term, Unsolvable};
use crate::measured::Measured;
use crate::quantity::{Length, Pixels};
use std::f64::consts::FRAC_PI_2;

/// A camera above a flat, level floor, looking at a point of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundView {
    /// Height of the camera above the floor.
    pub height: Measured<Length>,
    /// How far the optical axis points down from the horizontal.
    pub pitch: Measured<Angle>,
    /// Row at which the point is seen.
    pub row: Measured<Pixels>,
    /// Focal length along the columns.
    pub fy: Pixels,
    /// Row of the principal point.
    pub cy: Pixels,
}

/// What a [`GroundView`] shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundSolution {
    /// Horizontal distance to the point, along the floor.
    pub distance: Measured<Length>,
    /// The row at which the floor ends; `None` where the camera looks straight down.
    pub horizon_row: Option<Pixels>,
}

impl GroundView {
    /// The distance and where the floor ends.
    ///
    /// ```
    /// use depth_core::angle::Angle;
    /// use depth_core::camera::GroundView;
    /// use depth_core::measured::Measured;
    /// use depth_core::quantity::{Length, Pixels};
    ///
    /// let view = GroundView {
    ///     height: Measured::exact(Length::from_m(1.5)),
    ///     pitch: Measured::exact(Angle::from_degrees(0.0)),
    ///     row: Measured::exact(Pixels::new(1050.0)),
    ///     fy: Pixels::new(700.0),
    ///     cy: Pixels::new(350.0),
    /// };
    /// let floor = view.solve().unwrap();
    /// // A level camera; 700 rows below the axis at f = 700 px is a slope of 45°: as far as the camera is high.
    /// assert!((floor.distance.value.m() - 1.5).abs() < 1e-12);
    /// assert_eq!(floor.horizon_row, Some(Pixels::new(350.0)));
    /// ```
    ///
    /// # Errors
    /// As [`distance`](Self::distance).
    pub fn solve(&self) -> Result<GroundSolution, Unsolvable> {
        Ok(GroundSolution {
            distance: self.distance()?,
            horizon_row: self.horizon_row(),
        })
    }

    /// Horizontal distance to the point with its σ to first order: D = h/tan(θ + atan((v − cy)/fy)), with
    /// dD/dh = D/h, dD/dθ = −(D² + h²)/h and dD/dv = dD/dθ·fy/(fy² + (v − cy)²).
    ///
    /// ```
    /// # use depth_core::angle::Angle;
    /// # use depth_core::camera::GroundView;
    /// # use depth_core::measured::Measured;
    /// # use depth_core::quantity::{Length, Pixels};
    /// let view = GroundView {
    ///     height: Measured::new(Length::from_m(1.5), Length::from_m(0.1)),
    ///     pitch: Measured::exact(Angle::from_degrees(0.0)),
    ///     row: Measured::exact(Pixels::new(1050.0)),
    ///     fy: Pixels::new(700.0),
    ///     cy: Pixels::new(350.0),
    /// };
    /// // A slope of 45°: as far as the camera is high, and as well known.
    /// let distance = view.distance().unwrap();
    /// assert!((distance.value.m() - 1.5).abs() < 1e-12);
    /// assert!((distance.sigma.m() - 0.1).abs() < 1e-12);
    /// ```
    ///
    /// # Errors
    /// [`Unsolvable`].
    ///
    /// Source: intersection of the pixel's ray with a plane (Hartley and Zisserman, 8.1); JCGM 100:2008 (GUM), 5.1.2, for σ.
    pub fn distance(&self) -> Result<Measured<Length>, Unsolvable> {
        let below_axis = self.below_axis()?;
        let height = self.height.value.m();
        let down = self.pitch.value.radians() + below_axis.atan();
        if down <= 0.0 {
            return Err(Unsolvable::AboveHorizon {
                horizon: self.horizon_row(),
            });
        }
        if down >= FRAC_PI_2 {
            return Err(Unsolvable::BelowCamera {
                down: Angle::from_radians(down),
            });
        }
        let distance = height / down.tan();
        // (D² + h²)/h = h/sin², without squaring a length.
        let per_radian = height / down.sin() / down.sin();
        let sigma = root_sum_of_squares(&[
            self.height.sigma.m() / down.tan(),
            per_radian * self.pitch.sigma.radians(),
            per_radian * (self.row.sigma.px() / self.fy.px() / (1.0 + below_axis * below_axis)),
        ]);
        if distance.is_finite() && sigma.is_finite() {
            Ok(Measured::from_base(distance, sigma))
        } else {
            Err(Unsolvable::too_extreme(Term::Distance))
        }
    }

    /// The row at which the floor ends, v = cy − fy·tan θ; `None` where the camera looks straight down or the numbers are
    /// unusable.
    ///
    /// ```
    /// # use depth_core::angle::Angle;
    /// # use depth_core::camera::GroundView;
    /// # use depth_core::measured::Measured;
    /// # use depth_core::quantity::{Length, Pixels};
    /// let view = GroundView {
    ///     height: Measured::new(Length::from_m(1.5), Length::from_m(0.1)),
    ///     pitch: Measured::exact(Angle::from_degrees(0.0)),
    ///     row: Measured::exact(Pixels::new(1050.0)),
    ///     fy: Pixels::new(700.0),
    ///     cy: Pixels::new(350.0),
    /// };
    /// // The camera is level: the horizon goes through the principal point.
    /// assert_eq!(view.horizon_row(), Some(Pixels::new(350.0)));
    /// ```
    ///
    /// Source: the row of [`distance`](Self::distance) whose ray is horizontal.
    pub fn horizon_row(&self) -> Option<Pixels> {
        self.below_axis().ok()?;
        let row = self.cy.px() - self.fy.px() * self.pitch.value.radians().tan();
        (self.pitch.value.radians().abs() < FRAC_PI_2 && row.is_finite()).then_some(Pixels::new(row))
    }

    /// (v − cy)/fy, where every number can be used.
    fn below_axis(&self) -> Result<f64, Unsolvable> {
        judge::positive_measured(Term::CameraHeight, self.height)?;
        judge::finite_measured(Term::Pitch, self.pitch)?;
        let row = judge::finite_measured(Term::Row, self.row)?.value.px();
        let fy = judge::value(Term::Input(Field::FocalLength), judge::positive(self.fy.px()))?;
        let cy = judge::value(Term::PrincipalPoint, judge::finite(self.cy.px()))?;
        judge::value(Term::Row, judge::finite((row - cy) / fy))
    }
}
