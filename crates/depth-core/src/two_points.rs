//! [`TwoPoints`]: the length between two points that a stereo pair sees.

use crate::arithmetic::root_sum_of_squares;
use crate::field::Field;
use crate::judge::{self, Term, Unsolvable};
use crate::measured::Measured;
use crate::quantity::{Length, Pixels};
use crate::stereo;

/// A point as a stereo pair sees it: its pixel in the left image, and its disparity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StereoPoint {
    /// Its column, u.
    pub column: Pixels,
    /// Its row, v.
    pub row: Pixels,
    /// Its disparity.
    pub disparity: Measured<Pixels>,
}

/// A calibrated pair and two points that it sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoPoints {
    /// Focal length along the rows.
    pub fx: Measured<Pixels>,
    /// Focal length along the columns; equals `fx` for square pixels. Their ratio is taken to be exact.
    pub fy: Pixels,
    /// Whether the cameras stand one above the other: the disparity then belongs to fy.
    pub is_vertical: bool,
    /// The baseline.
    pub baseline: Measured<Length>,
    /// δ, added to both disparities.
    pub doffs: Measured<Pixels>,
    /// Column of the principal point.
    pub cx: Pixels,
    /// Row of the principal point.
    pub cy: Pixels,
    /// The first point.
    pub from: StereoPoint,
    /// The second one.
    pub to: StereoPoint,
}

/// From the first point to the second one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoPointsSolution {
    /// The length between them, with its first-order σ.
    pub distance: Measured<Length>,
    /// To the right, with its first-order σ.
    pub dx: Measured<Length>,
    /// Down, with its first-order σ.
    pub dy: Measured<Length>,
    /// Away from the camera: the difference of their depths, with its first-order σ.
    pub dz: Measured<Length>,
}

/// The coordinates of a point, m, and the relative change of all of them for one pixel of disparity.
#[derive(Clone, Copy)]
struct Placed {
    at: [f64; 3],
    per_pixel: f64,
    sigma: f64,
}

impl TwoPoints {
    /// |P₂ − P₁| with P = b/(d + δ)·(u − cx, (v − cy)·fx/fy, fx); for a vertical pair with fy in place of fx and the columns
    /// multiplied by fy/fx.
    ///
    /// σ from both disparities, doffs, which moves both points alike, the baseline, which scales everything, and the focal length, which
    /// scales the depths.
    ///
    /// ```
    /// use depth_core::measured::Measured;
    /// use depth_core::quantity::{Length, Pixels};
    /// use depth_core::two_points::{StereoPoint, TwoPoints};
    ///
    /// let px = Pixels::new;
    /// let at = |column, disparity| StereoPoint { column: px(column), row: px(240.0), disparity: Measured::from_base(disparity, 0.0) };
    /// let pair = TwoPoints {
    ///     fx: Measured::from_base(500.0, 0.0),
    ///     fy: px(500.0),
    ///     is_vertical: false,
    ///     baseline: Measured::from_base(0.1, 0.0),
    ///     doffs: Measured::from_base(0.0, 0.0),
    ///     cx: px(320.0),
    ///     cy: px(240.0),
    ///     from: at(320.0, 50.0),
    ///     to: at(620.0, 10.0),
    /// };
    /// // From (0, 0, 1) m to (3, 0, 5) m: 3-4-5.
    /// assert!((pair.solve()?.distance.value.m() - 5.0).abs() < 1e-12);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    ///
    /// # Errors
    /// [`Unsolvable`].
    ///
    /// Source: inverse of the pinhole projection (OpenCV, `reprojectImageTo3D`); JCGM 100:2008 (GUM), 5.1.2, for σ.
    pub fn solve(&self) -> Result<TwoPointsSolution, Unsolvable> {
        let focal_length = Term::Input(Field::FocalLength);
        judge::positive_measured(focal_length, self.fx)?;
        judge::value(focal_length, judge::positive(self.fy.px()))?;
        judge::positive_measured(Term::Input(Field::Baseline), self.baseline)?;
        judge::finite_measured(Term::Input(Field::Doffs), self.doffs)?;
        judge::value(Term::PrincipalPoint, judge::finite(self.cx.px()))?;
        judge::value(Term::PrincipalPoint, judge::finite(self.cy.px()))?;
        let (from, to) = (self.place(&self.from)?, self.place(&self.to)?);
        let [x1, y1, z1] = from.at;
        let [x2, y2, z2] = to.at;
        let difference = [x2 - x1, y2 - y1, z2 - z1];
        let [_, _, dz] = difference;
        let distance = root_sum_of_squares(&difference);
        let (rb, rf) = (self.baseline.relative(), self.fx.relative());
        let sigma_doffs = self.doffs.sigma.px();
        // What moving a point by all of its coordinates does to the length, per part of them.
        let toward = |placed: Placed| {
            let dot: f64 = placed.at.iter().zip(difference).map(|(at, side)| at * (side / distance)).sum();
            if distance == 0.0 { root_sum_of_squares(&placed.at) } else { dot }
        };
        let sigma = root_sum_of_squares(&[
            toward(from) * from.per_pixel * from.sigma,
            toward(to) * to.per_pixel * to.sigma,
            (toward(to) * to.per_pixel - toward(from) * from.per_pixel) * sigma_doffs,
            distance * rb,
            if distance == 0.0 { 0.0 } else { dz * (dz / distance) * rf },
        ]);
        // The difference of one coordinate, of which a part `scale` is as uncertain as the focal length.
        let side = |first: f64, second: f64, scale: f64| {
            let difference = second - first;
            let sigma = root_sum_of_squares(&[
                first * from.per_pixel * from.sigma,
                second * to.per_pixel * to.sigma,
                (second * to.per_pixel - first * from.per_pixel) * sigma_doffs,
                difference * rb,
                difference * scale * rf,
            ]);
            Measured::from_base(difference, sigma)
        };
        // Sideways a longer focal length takes away from the angle what it adds to the depth.
        let solution = TwoPointsSolution {
            distance: Measured::from_base(distance, sigma),
            dx: side(x1, x2, 0.0),
            dy: side(y1, y2, 0.0),
            dz: side(z1, z2, 1.0),
        };
        let all = [solution.distance, solution.dx, solution.dy, solution.dz];
        if !all
            .iter()
            .all(|length| length.value.m().is_finite() && length.sigma.m().is_finite())
        {
            return Err(Unsolvable::too_extreme(Term::Distance));
        }
        Ok(solution)
    }

    fn place(&self, point: &StereoPoint) -> Result<Placed, Unsolvable> {
        judge::value(Term::Column, judge::finite(point.column.px()))?;
        judge::value(Term::Row, judge::finite(point.row.px()))?;
        let divisor = point.disparity.plus(self.doffs).value;
        judge::positive_measured(Term::Input(Field::Disparity), Measured::new(divisor, point.disparity.sigma))?;
        let f = if self.is_vertical { self.fy } else { self.fx.value };
        let depth = stereo::depth(f, self.baseline.value, divisor);
        judge::value(Term::Distance, judge::positive(depth.m()))?;
        let aside = |pixel: Pixels, center: Pixels, f: f64| (pixel.px() - center.px()) * (depth.m() / f);
        Ok(Placed {
            at: [
                aside(point.column, self.cx, self.fx.value.px()),
                aside(point.row, self.cy, self.fy.px()),
                depth.m(),
            ],
            per_pixel: 1.0 / divisor.px(),
            sigma: point.disparity.sigma.px(),
        })
    }
}
