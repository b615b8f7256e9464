//! A target that does not face the camera.

use crate::angle::Angle;
use crate::judge::{self, Term, Unsolvable};
use crate::quantity::Length;
use std::f64::consts::FRAC_PI_2;

/// A target whose width is turned away from facing the camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TiltedTarget {
    /// The depth that the monocular formula computes.
    pub apparent: Length,
    /// By how much the target is turned.
    pub tilt: Angle,
}

/// The depth of a tilted target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TiltSolution {
    /// The depth of the plane of the target's middle.
    pub depth: Length,
    /// By how much the apparent depth is too long, as a fraction of the true one.
    pub excess: f64,
}

impl TiltedTarget {
    /// The true depth, and by how much the apparent one is too long: [`depth_of_tilted_target`].
    ///
    /// ```
    /// use depth_core::angle::Angle;
    /// use depth_core::camera::TiltedTarget;
    /// use depth_core::quantity::Length;
    ///
    /// let target = TiltedTarget { apparent: Length::from_m(2.0), tilt: Angle::from_degrees(60.0) };
    /// let solution = target.solve().unwrap();
    /// // cos 60° = ½: half as far, so that the apparent depth is 100 % too long.
    /// assert!((solution.depth.m() - 1.0).abs() < 1e-12);
    /// assert!((solution.excess - 1.0).abs() < 1e-12);
    /// ```
    ///
    /// # Errors
    /// [`Unsolvable::TurnedAway`] at 90° and more; [`Unsolvable`] where a number cannot be used.
    pub fn solve(&self) -> Result<TiltSolution, Unsolvable> {
        judge::value(Term::Distance, judge::positive(self.apparent.m()))?;
        judge::value(Term::Tilt, judge::finite(self.tilt.radians()))?;
        let depth = depth_of_tilted_target(self.apparent, self.tilt).ok_or(Unsolvable::TurnedAway { tilt: self.tilt })?;
        judge::value(Term::Distance, judge::positive(depth.m()))?;
        Ok(TiltSolution {
            depth,
            excess: self.apparent.m() / depth.m() - 1.0,
        })
    }
}

/// True depth of a target whose width is turned by `tilt` away from facing the camera, given the depth that the
/// monocular formula computes: Z = Z_apparent·cos φ, because the width appears cos φ as large.
///
/// `None` at 90° and more. To first order in width/depth: the exact apparent width is larger by the factor
/// 1/(1 − (w·sin φ/2Z)²), 0.25 % for a target as deep as a tenth of its distance.
///
/// ```
/// use depth_core::angle::Angle;
/// use depth_core::camera::depth_of_tilted_target;
/// use depth_core::quantity::Length;
///
/// let depth = depth_of_tilted_target(Length::from_m(2.0), Angle::from_degrees(60.0)).unwrap();
/// assert!((depth.m() - 1.0).abs() < 1e-12);
/// ```
///
/// Source: foreshortening under orthographic projection scaled by depth (weak perspective), Hartley and Zisserman, 6.3.
pub fn depth_of_tilted_target(apparent: Length, tilt: Angle) -> Option<Length> {
    (tilt.radians().abs() < FRAC_PI_2).then(|| Length::from_m(apparent.m() * tilt.radians().cos()))
}
