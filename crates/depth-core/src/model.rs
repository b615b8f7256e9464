//! [`Model`]: one distance with the inputs that it was computed from.
//!
//! Stereo and monocular are one equation, Z = f·L/x: a focal length f, a length L (the baseline, or the object's real
//! width) and a divisor x in pixels (the disparity plus doffs, or the object's width in the image).

use crate::arithmetic::{root_sum_of_squares, times_over};
use crate::field::Field;
use crate::judge::{self, Term, Unsolvable};
use crate::measured::Measured;
use crate::quantity::{Length, Pixels};

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

impl Model {
    /// Stereo, Z = f·b/(d + δ): `focal_length`, `disparity` and `doffs` (0 where the principal points coincide) in pixels
    /// of the same image.
    ///
    /// ```
    /// use depth_core::measured::Measured;
    /// use depth_core::uncertainty::Model;
    ///
    /// let model = Model::stereo(
    ///     Measured::from_base(700.0, 2.0),
    ///     Measured::from_base(0.1, 0.0005),
    ///     Measured::from_base(50.0, 0.5),
    ///     Measured::from_base(0.0, 0.0),
    /// )?;
    /// assert_eq!(model.depth().m(), 1.4);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
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
    /// ```
    /// use depth_core::measured::Measured;
    /// use depth_core::uncertainty::Model;
    ///
    /// let model = Model::monocular(
    ///     Measured::from_base(950.0, 2.0),
    ///     Measured::from_base(0.9, 0.01),
    ///     Measured::from_base(200.0, 2.0),
    /// )?;
    /// assert_eq!(model.depth().m(), 4.275);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
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
    ///
    /// ```
    /// # use depth_core::measured::Measured;
    /// # use depth_core::uncertainty::Model;
    /// // f known to 3 %, d to 4 %.
    /// let mug = Model::stereo(
    ///     Measured::from_base(700.0, 21.0),
    ///     Measured::from_base(0.1, 0.0),
    ///     Measured::from_base(50.0, 2.0),
    ///     Measured::from_base(0.0, 0.0),
    /// )?;
    /// assert_eq!(mug.depth().m(), 1.4);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    pub fn depth(&self) -> Length {
        Length::from_m(times_over(
            self.focal_length.value.px(),
            self.length.value.m(),
            self.divisor().value.px(),
        ))
    }

    /// σ_Z/Z to first order.
    ///
    /// Stereo: (σ_Z/Z)² = (σ_f/f)² + (σ_b/b)² + (σ_d² + σ_δ²)/(d + δ)².
    /// Monocular: (σ_Z/Z)² = (σ_w/w_real)² + (σ_f/f)² + (σ_p/w_img)².
    ///
    /// Poor where [`first_order_is_good`](Self::first_order_is_good) is false.
    ///
    /// ```
    /// # use depth_core::measured::Measured;
    /// # use depth_core::uncertainty::Model;
    /// // f known to 3 %, d to 4 %.
    /// let mug = Model::stereo(
    ///     Measured::from_base(700.0, 21.0),
    ///     Measured::from_base(0.1, 0.0),
    ///     Measured::from_base(50.0, 2.0),
    ///     Measured::from_base(0.0, 0.0),
    /// )?;
    /// // √(3² + 4²) = 5.
    /// assert!((mug.relative_sigma() - 0.05).abs() < 1e-12);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    ///
    /// Source: JCGM 100:2008 (GUM), 5.1.6, for a product of powers ±1; without σ_f and σ_b it is the familiar
    /// ΔZ = Z²·Δd/(f·b) of ROS stereo_msgs/DisparityImage.
    pub fn relative_sigma(&self) -> f64 {
        root_sum_of_squares(&self.relative_sigmas().map(|(_, relative)| relative))
    }

    /// f.
    ///
    /// ```
    /// # use depth_core::measured::Measured;
    /// # use depth_core::uncertainty::Model;
    /// // f known to 3 %, d to 4 %.
    /// let mug = Model::stereo(
    ///     Measured::from_base(700.0, 21.0),
    ///     Measured::from_base(0.1, 0.0),
    ///     Measured::from_base(50.0, 2.0),
    ///     Measured::from_base(0.0, 0.0),
    /// )?;
    /// assert_eq!(mug.focal_length().value.px(), 700.0);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    pub const fn focal_length(&self) -> Measured<Pixels> {
        self.focal_length
    }

    /// The baseline or the real width, and which of the two it is.
    ///
    /// ```
    /// # use depth_core::measured::Measured;
    /// # use depth_core::uncertainty::Model;
    /// // f known to 3 %, d to 4 %.
    /// let mug = Model::stereo(
    ///     Measured::from_base(700.0, 21.0),
    ///     Measured::from_base(0.1, 0.0),
    ///     Measured::from_base(50.0, 2.0),
    ///     Measured::from_base(0.0, 0.0),
    /// )?;
    /// let (source, length) = mug.length();
    /// assert_eq!((source, length.value.m()), (depth_core::field::Field::Baseline, 0.1));
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    pub const fn length(&self) -> (Field, Measured<Length>) {
        (self.length_source, self.length)
    }

    /// The disparity (without doffs) or the width in the image, and which of the two it is.
    ///
    /// ```
    /// # use depth_core::measured::Measured;
    /// # use depth_core::uncertainty::Model;
    /// // f known to 3 %, d to 4 %.
    /// let mug = Model::stereo(
    ///     Measured::from_base(700.0, 21.0),
    ///     Measured::from_base(0.1, 0.0),
    ///     Measured::from_base(50.0, 2.0),
    ///     Measured::from_base(0.0, 0.0),
    /// )?;
    /// let (source, pixels) = mug.pixels();
    /// assert_eq!((source, pixels.value.px()), (depth_core::field::Field::Disparity, 50.0));
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    pub const fn pixels(&self) -> (Field, Measured<Pixels>) {
        (self.pixels_source, self.pixels)
    }

    /// What the product of focal length and length is divided by: d + δ, or w_img.
    ///
    /// ```
    /// # use depth_core::measured::Measured;
    /// # use depth_core::uncertainty::Model;
    /// // f known to 3 %, d to 4 %.
    /// let mug = Model::stereo(
    ///     Measured::from_base(700.0, 21.0),
    ///     Measured::from_base(0.1, 0.0),
    ///     Measured::from_base(50.0, 2.0),
    ///     Measured::from_base(0.0, 0.0),
    /// )?;
    /// assert_eq!(mug.divisor().value.px(), 50.0);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
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
