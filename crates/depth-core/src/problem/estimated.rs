//! How well the widths are known that a distance predicts.

use super::inputs::Problem;
use super::solution::Solution;
use crate::arithmetic::root_sum_of_squares;
use crate::field::Field;
use crate::in_image::InImage;
use crate::measured::Measured;
use crate::method::Method;
use crate::quantity::{Length, Pixels};

/// The step of a difference quotient, as a part of the input: half of the digits of a number are left to it.
const STEP: f64 = 1e-6;

impl Solution {
    /// [`estimated_width_px`](Self::estimated_width_px) with its σ, px: 0 where no input has one that counts. The focal length is in the
    /// distance and in the width, so that its own cancels.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// let inputs = [(Field::FocalLength, 700.0, 70.0), (Field::Baseline, 0.1, 0.0), (Field::Disparity, 50.0, 1.5), (Field::RealWidth, 0.3, 0.012)];
    /// for (field, value, sigma) in inputs {
    ///     mug.set(field, Some(value));
    ///     mug.set_sigma(field, sigma);
    /// }
    /// // w_real·d/b: 3 % and 4 % are 5 %; the 10 % of fx are in both.
    /// let width = mug.solve().estimated_width_px_with_sigma().unwrap();
    /// assert!((width.value.px() - 150.0).abs() < 1e-9 && (width.sigma.px() - 7.5).abs() < 1e-6);
    /// ```
    ///
    /// Source: JCGM 100:2008 (GUM), 5.1.2, with difference quotients for the derivatives (5.1.3, note 2).
    pub fn estimated_width_px_with_sigma(&self) -> Option<Measured<Pixels>> {
        let value = self.estimated_width_px?;
        let sigma = self.problem.sigma_of(|solution| Some(solution.estimated_width_px?.px()))?;
        Some(Measured::new(value, Pixels::new(sigma)))
    }

    /// [`estimated_width`](Self::estimated_width) with its σ, m: as
    /// [`estimated_width_px_with_sigma`](Self::estimated_width_px_with_sigma).
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// let inputs = [(Field::FocalLength, 700.0, 70.0), (Field::Baseline, 0.1, 0.003), (Field::Disparity, 50.0, 0.0), (Field::ImageWidth, 150.0, 6.0)];
    /// for (field, value, sigma) in inputs {
    ///     mug.set(field, Some(value));
    ///     mug.set_sigma(field, sigma);
    /// }
    /// // w_img·b/d: 3 % and 4 % are 5 %.
    /// let width = mug.solve().estimated_width_with_sigma().unwrap();
    /// assert!((width.value.m() - 0.3).abs() < 1e-12 && (width.sigma.m() - 0.015).abs() < 1e-8);
    /// ```
    pub fn estimated_width_with_sigma(&self) -> Option<Measured<Length>> {
        let value = self.estimated_width?;
        let sigma = self.problem.sigma_of(|solution| Some(solution.estimated_width?.m()))?;
        Some(Measured::new(value, Length::from_m(sigma)))
    }
}

impl Problem {
    /// σ to first order of what `result` takes from the solution; `None` where that has no derivative or is not finite.
    fn sigma_of(&self, result: impl Fn(&Solution) -> Option<f64>) -> Option<f64> {
        let exact = self.without_sigmas();
        let mut parts = Vec::new();
        for field in Field::ALL {
            let sigma = self.sigma(field);
            // That of fx is that of an fy without one of its own.
            if sigma == 0.0 {
                continue;
            }
            let value = exact.get(field).unwrap_or(0.0);
            let scale = if value == 0.0 {
                exact.get(Field::Disparity)?.abs()
            } else {
                value.abs()
            };
            let step = scale * STEP;
            let at = |shift: f64| result(&exact.with_shift(self, field, value + shift).solve());
            let derivative = (at(step)? - at(-step)?) / (2.0 * step);
            parts.push(derivative * sigma);
        }
        Some(root_sum_of_squares(&parts)).filter(|sigma| sigma.is_finite())
    }

    /// What each input and the distance (`None`) have of the variance of what `method` is solved for, 0 to 1, to first order; they add to
    /// 1. Empty where all is exact, or without a solution.
    ///
    /// ```
    /// # use depth_core::measured::Measured;
    /// # use depth_core::problem::{Field, Method, Problem};
    /// let mut pair = Problem::default();
    /// for (field, value, sigma) in [(Field::FocalLength, 700.0, 21.0), (Field::Baseline, 0.1, 0.0)] {
    ///     pair.set(field, Some(value));
    ///     pair.set_sigma(field, sigma);
    /// }
    /// // d = fx·b/D: 3 % of fx and 4 % of D are 5 % of d.
    /// let shares = pair.shares_of_solved(Method::Stereo, Field::Disparity, Measured::from_base(1.4, 0.056));
    /// let percent: Vec<_> = shares.iter().map(|(source, share)| (*source, (share * 100.0).round())).collect();
    /// assert_eq!(percent, [(None, 64.0), (Some(Field::FocalLength), 36.0)]);
    /// ```
    ///
    /// Source: JCGM 100:2008 (GUM), 5.1.3, with difference quotients for the derivatives.
    pub fn shares_of_solved(&self, method: Method, field: Field, distance: Measured<Length>) -> Vec<(Option<Field>, f64)> {
        let mut exact = self.without_sigmas();
        exact.set(field, None);
        let solved = |problem: &Self, distance: f64| {
            let found = problem.solve_for(method, field, Measured::exact(Length::from_m(distance))).ok()??;
            Some(found.to_base().value)
        };
        let at = distance.value.m();
        let quotient = |of: &dyn Fn(f64) -> Option<f64>, step: f64| Some((of(step)? - of(-step)?) / (2.0 * step));
        let of_distance = quotient(&|shift| solved(&exact, at + shift), at * STEP).map(|slope| (None, slope * distance.sigma.m()));
        let of_inputs = Field::ALL
            .into_iter()
            .filter(|&input| input != field && self.sigma(input) > 0.0)
            .filter_map(|input| {
                let value = exact.get(input).unwrap_or(0.0);
                let step = if value == 0.0 { STEP } else { value.abs() * STEP };
                let slope = quotient(&|shift| solved(&exact.with_shift(self, input, value + shift), at), step)?;
                Some((Some(input), slope * self.sigma(input)))
            });
        let parts: Vec<(Option<Field>, f64)> = of_distance.into_iter().chain(of_inputs).filter(|(_, part)| *part != 0.0).collect();
        let total = root_sum_of_squares(&parts.iter().map(|(_, part)| *part).collect::<Vec<_>>());
        let share = |part: f64| (part / total) * (part / total);
        parts
            .into_iter()
            .map(|(source, part)| (source, share(part)))
            .filter(|(_, share)| share.is_finite())
            .collect()
    }

    /// The same with `field` at `value`; an fy without a σ in `original` scales with fx.
    fn with_shift(mut self, original: &Self, field: Field, value: f64) -> Self {
        if field == Field::FocalLength
            && let (Some(fx), Some(fy)) = (self.get(field), self.get(Field::Fy))
            && original.fy.map_or(0.0, InImage::relative) == 0.0
        {
            self.set(Field::Fy, Some(fy * (value / fx)));
        }
        self.set(field, Some(value));
        self
    }
}
