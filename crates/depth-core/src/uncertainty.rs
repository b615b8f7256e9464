//! How sure can one be: the uncertainty of a distance that follows from the uncertainty of its inputs.
//!
//! Stereo and monocular are one equation, Z = f·L/x: a focal length f, a length L (the baseline, or the object's real
//! width) and a divisor x in pixels (the disparity plus doffs, or the object's width in the image). f and L scale the
//! distance and keep its spread symmetric; x divides, and where its σ is not small the distance has a long far side. That
//! is why [`Model::interval`] is the honest answer and [`Model::relative_sigma`] its small-σ limit.

use crate::arithmetic::{root_sum_of_squares, times_over};
use crate::field::Field;
use crate::judge::{self, Term, Unsolvable};
use crate::measured::Measured;
use crate::quantity::{Length, Pixels};

/// The relative σ of the divisor up to which the first-order σ can be trusted: 10 %.
///
/// At 10 % the far end of the exact 1 σ interval lies 1.11 σ away, the near end 0.91 σ.
pub const FIRST_ORDER_LIMIT: f64 = 0.10;

/// One distance and what it was computed from: positive inputs, possible standard deviations, a distance that can be
/// represented. Made once; everything that follows from it can then be given without a further check.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Model {
    focal_length: Measured<Pixels>,
    length: Measured<Length>,
    length_source: Field,
    pixels: Measured<Pixels>,
    pixels_source: Field,
    doffs: Measured<Pixels>,
}

/// The part of the variance that one input is responsible for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// The input.
    pub source: Field,
    /// Its part of the variance, 0 to 1.
    pub share: f64,
}

/// Which input causes which part of a variance, in reading order; the shares add to 1. Empty where every input is exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Budget {
    shares: [Share; 4],
    len: usize,
}

impl Budget {
    /// The shares, in reading order.
    pub fn shares(&self) -> &[Share] {
        self.shares.get(..self.len).unwrap_or_default()
    }
}

impl std::ops::Deref for Budget {
    type Target = [Share];

    fn deref(&self) -> &[Share] {
        self.shares()
    }
}

impl<'a> IntoIterator for &'a Budget {
    type Item = &'a Share;
    type IntoIter = std::slice::Iter<'a, Share>;

    fn into_iter(self) -> Self::IntoIter {
        self.shares().iter()
    }
}

/// An interval of distances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The near end.
    pub near: Length,
    /// The far end; `None` where there is no upper bound.
    pub far: Option<Length>,
}

impl Model {
    /// Stereo, Z = f·b/(d + δ): `focal_length`, `disparity` and `doffs` (0 where the principal points coincide) in pixels
    /// of the same image.
    ///
    /// # Errors
    /// [`Unsolvable`] names the first input that cannot be used.
    pub fn stereo(
        focal_length: Measured<Pixels>,
        baseline: Measured<Length>,
        disparity: Measured<Pixels>,
        doffs: Measured<Pixels>,
    ) -> Result<Self, Unsolvable> {
        Self {
            focal_length,
            length: baseline,
            length_source: Field::Baseline,
            pixels: disparity,
            pixels_source: Field::Disparity,
            doffs,
        }
        .checked()
    }

    /// Monocular, Z = w_real·f/w_img: `focal_length` and `image_width` in pixels of the same image.
    ///
    /// # Errors
    /// [`Unsolvable`] names the first input that cannot be used.
    pub fn monocular(
        focal_length: Measured<Pixels>,
        real_width: Measured<Length>,
        image_width: Measured<Pixels>,
    ) -> Result<Self, Unsolvable> {
        Self {
            focal_length,
            length: real_width,
            length_source: Field::RealWidth,
            pixels: image_width,
            pixels_source: Field::ImageWidth,
            doffs: Measured::exact(Pixels::new(0.0)),
        }
        .checked()
    }

    fn checked(self) -> Result<Self, Unsolvable> {
        let divisor = self.divisor();
        let pixels = Term::Input(self.pixels_source);
        judge::value(Term::Input(Field::FocalLength), judge::positive(self.focal_length.value.px()))?;
        judge::value(Term::Input(self.length_source), judge::positive(self.length.value.m()))?;
        judge::value(Term::Input(Field::Doffs), judge::finite(self.doffs.value.px()))?;
        judge::value(pixels, judge::finite(self.pixels.value.px()))?;
        judge::value(pixels, judge::positive(divisor.value.px()))?;
        for (source, relative) in self.relative_sigmas() {
            judge::relative_sigma(Term::Input(source), relative)?;
        }
        let depth = self.depth().m();
        if depth.is_normal() && (depth * self.relative_sigma()).is_finite() && divisor.sigma.px().is_finite() {
            Ok(self)
        } else {
            Err(Unsolvable::too_extreme(Term::Distance))
        }
    }

    /// The distance.
    pub fn depth(&self) -> Length {
        Length::from_m(times_over(
            self.focal_length.value.px(),
            self.length.value.m(),
            self.divisor().value.px(),
        ))
    }

    /// The distance with its first-order σ.
    pub fn depth_with_sigma(&self) -> Measured<Length> {
        let depth = self.depth().m();
        Measured::from_base(depth, depth * self.relative_sigma())
    }

    /// σ_Z/Z to first order.
    ///
    /// Stereo: (σ_Z/Z)² = (σ_f/f)² + (σ_b/b)² + (σ_d² + σ_δ²)/(d + δ)².
    /// Monocular: (σ_Z/Z)² = (σ_w/w_real)² + (σ_f/f)² + (σ_p/w_img)².
    ///
    /// Poor where [`first_order_is_good`](Self::first_order_is_good) is false.
    ///
    /// Source: JCGM 100:2008 (GUM), 5.1.6, for a product of powers ±1; without σ_f and σ_b it is the familiar
    /// ΔZ = Z²·Δd/(f·b) of ROS stereo_msgs/DisparityImage.
    pub fn relative_sigma(&self) -> f64 {
        root_sum_of_squares(&self.relative_sigmas().map(|(_, relative)| relative))
    }

    /// σ_Z/Z to first order with the focal length taken to be exact: what this distance does not share with another one
    /// that was computed from the same focal length.
    pub fn own_relative_sigma(&self) -> f64 {
        root_sum_of_squares(&[self.length.relative(), self.relative_divisor_sigma()])
    }

    /// Which input is responsible for which part of the first-order variance. Doffs takes part where it has a σ.
    ///
    /// Source: JCGM 100:2008 (GUM), 5.1.3: each input's own term of the sum of squares.
    pub fn variance_budget(&self) -> Budget {
        let total = self.relative_sigma();
        let part = |relative: f64| if total == 0.0 { 0.0 } else { relative / total };
        let sources = self.relative_sigmas();
        let [.., (_, of_doffs)] = sources;
        let shares = sources.map(|(source, relative)| Share {
            source,
            share: part(relative) * part(relative),
        });
        let len = match total {
            0.0 => 0,
            _ => shares.len() - usize::from(of_doffs == 0.0),
        };
        Budget { shares, len }
    }

    /// The 1 σ interval with every uncertainty and no linearisation: all distances that the inputs do not contradict by
    /// more than 1 σ.
    ///
    /// Z·(1 ± √(rk² + rx² − rk²·rx²))/(1 − rx²) with rk the relative σ of f·L (rk² = σ_f²/f² + σ_L²/L²) and rx that of the
    /// divisor. There is no upper bound once rx ≥ 1: the divisor may then be 0. The near end is 0 once rk ≥ 1. With rk = 0
    /// it is the interval of the distances at x + σ and x − σ.
    ///
    /// Source: E. C. Fieller, Some problems in interval estimation, Journal of the Royal Statistical Society B 16 (1954),
    /// for the ratio of two independent normal variables; f·L is taken to be normal.
    pub fn interval(&self) -> Interval {
        let depth = self.depth().m();
        let rk = root_sum_of_squares(&[self.focal_length.relative(), self.length.relative()]);
        let rx = self.relative_divisor_sigma();
        // (1 − s)·(1 + s) = (1 − rk²)·(1 − rx²) turns the two roots into forms in which nothing cancels.
        let near = if rk < 1.0 {
            let rest = (1.0 - rk) * (1.0 + rk);
            depth * (rest / (1.0 + root_sum_of_squares(&[rk, rx * rest.sqrt()])))
        } else {
            0.0
        };
        let far = (rx < 1.0)
            .then(|| {
                let rest = (1.0 - rx) * (1.0 + rx);
                depth * ((1.0 + root_sum_of_squares(&[rx, rk * rest.sqrt()])) / rest)
            })
            .filter(|far| far.is_finite());
        Interval {
            near: Length::from_m(near),
            far: far.map(Length::from_m),
        }
    }

    /// The relative σ of the divisor: √(σ_d² + σ_δ²)/(d + δ), or σ_p/w_img.
    pub fn relative_divisor_sigma(&self) -> f64 {
        self.divisor().relative()
    }

    /// Whether the first-order σ can be trusted: the divisor is known to [10 %](FIRST_ORDER_LIMIT) or better.
    pub fn first_order_is_good(&self) -> bool {
        self.relative_divisor_sigma() <= FIRST_ORDER_LIMIT
    }

    /// How much too far the average of many such distances comes out, as a fraction of the distance: rx², with rx the
    /// relative σ of the divisor. The median has no such bias.
    ///
    /// `None` above rx = 1/3, where the next term of the series, 3·rx⁴, is more than a third of this one. (It is an
    /// asymptotic series: strictly the mean of 1/x does not exist for a normal x.)
    ///
    /// Source: G. Sibley, L. Matthies, G. Sukhatme, Bias reduction and filter convergence for long range stereo, ISRR
    /// 2005; second-order Taylor series of 1/x.
    pub fn relative_bias(&self) -> Option<f64> {
        let rx = self.relative_divisor_sigma();
        (rx <= 1.0 / 3.0).then_some(rx * rx)
    }

    /// [`relative_bias`](Self::relative_bias) as a length.
    pub fn bias(&self) -> Option<Length> {
        Some(Length::from_m(self.relative_bias()? * self.depth().m()))
    }

    /// f.
    pub const fn focal_length(&self) -> Measured<Pixels> {
        self.focal_length
    }

    /// The baseline or the real width, and which of the two it is.
    pub const fn length(&self) -> (Field, Measured<Length>) {
        (self.length_source, self.length)
    }

    /// The disparity (without doffs) or the width in the image, and which of the two it is.
    pub const fn pixels(&self) -> (Field, Measured<Pixels>) {
        (self.pixels_source, self.pixels)
    }

    /// What the product of focal length and length is divided by: d + δ, or w_img.
    pub fn divisor(&self) -> Measured<Pixels> {
        self.pixels.plus(self.doffs)
    }

    /// The relative σ that each input gives to the distance, in reading order.
    pub(crate) fn relative_sigmas(&self) -> [(Field, f64); 4] {
        let of_divisor = |sigma| Measured::new(self.divisor().value, sigma).relative();
        [
            (Field::FocalLength, self.focal_length.relative()),
            (self.length_source, self.length.relative()),
            (self.pixels_source, of_divisor(self.pixels.sigma)),
            (Field::Doffs, of_divisor(self.doffs.sigma)),
        ]
    }
}
