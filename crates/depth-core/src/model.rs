//! [`Model`]: one distance with the inputs that it was computed from.
//!
//! Stereo and monocular are one equation, P = f·L/x: a focal length f, a length L (the baseline, or the object's real
//! size) and a divisor x (the disparity plus doffs, or the object's size in the image). f and x are both in pixels or both lengths
//! on the sensor; of an angle, f is 1 and x is 2·tan(α/2).
//!
//! P is the depth of what faces the camera, counted from the center of projection. On it follow, where they are asked for: the way
//! to the center of a ball, the focal length of the lens, and where distances are counted from.

use crate::angle::Angle;
use crate::arithmetic::{root_sum_of_squares, times_over};
use crate::field::Field;
use crate::in_image::InImage;
use crate::judge::{self, Refusal, Term, Unsolvable};
use crate::measured::Measured;
use crate::method::Method;
use crate::monocular;
use crate::projected::Projected;
use crate::quantity::{Length, Pixels};
use std::f64::consts::PI;

/// One distance and what it was computed from: positive inputs, possible standard deviations, a distance that can be
/// represented. Made once; everything that follows from it can then be given without a further check.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Model {
    focal_length: Measured<f64>,
    focal_length_source: Field,
    length: Measured<Length>,
    length_source: Field,
    extent: Measured<f64>,
    extent_source: Field,
    doffs: Measured<f64>,
    /// The extent, where it was measured as an angle.
    angle: Option<Measured<Angle>>,
    is_in_pixels: bool,
    is_ball: bool,
    lens: Length,
    zero: Length,
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
        let with_doffs = Self::unchecked(
            Method::Stereo,
            Projected::new(InImage::Pixels(focal_length), InImage::Pixels(disparity), Field::Disparity)?,
            baseline,
        );
        Self {
            doffs: doffs.to_base(),
            ..with_doffs
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
        let projected = Projected::new(InImage::Pixels(focal_length), InImage::Pixels(image_width), Field::ImageWidth)?;
        Self::unchecked(Method::Monocular, projected, real_width).checked()
    }

    /// Either method from extents in any unit, `doffs` left out.
    pub(crate) fn unchecked(method: Method, projected: Projected, length: Measured<Length>) -> Self {
        let [length_source, extent_source] = match method {
            Method::Stereo => [Field::Baseline, Field::Disparity],
            Method::Monocular => [Field::RealWidth, Field::ImageWidth],
        };
        Self {
            focal_length: projected.focal_length,
            focal_length_source: Field::FocalLength,
            length,
            length_source,
            extent: projected.extent,
            extent_source,
            doffs: Measured::exact(0.0),
            angle: projected.angle,
            is_in_pixels: projected.is_in_pixels,
            is_ball: false,
            lens: Length::from_m(0.0),
            zero: Length::from_m(0.0),
        }
    }

    /// With δ, in the unit of the extent.
    pub(crate) const fn with_doffs(self, doffs: Measured<f64>) -> Self {
        Self { doffs, ..self }
    }

    /// Of a ball whose outline is as wide as the extent.
    pub(crate) const fn of_ball(self) -> Self {
        Self { is_ball: true, ..self }
    }

    /// With a lens focused on the object, whose own focal length is added, and distances counted from `zero` in front of it.
    pub(crate) const fn counted(self, lens: Length, zero: Length) -> Self {
        Self { lens, zero, ..self }
    }

    pub(crate) fn checked(self) -> Result<Self, Unsolvable> {
        let divisor = self.divisor();
        let extent = Term::Input(self.extent_source);
        judge::value(Term::Input(Field::FocalLength), judge::positive(self.focal_length.value))?;
        judge::value(Term::Input(self.length_source), judge::positive(self.length.value.m()))?;
        judge::value(Term::Input(Field::Doffs), judge::finite(self.doffs.value))?;
        judge::value(extent, judge::finite(self.extent.value))?;
        judge::value(extent, judge::positive(divisor.value))?;
        for (source, relative) in self.relative_sigmas() {
            judge::relative_sigma(Term::Input(source), relative)?;
        }
        let depth = self.optical_depth().m();
        if !(depth.is_normal() && (depth * self.relative_sigma()).is_finite() && divisor.sigma.is_finite()) {
            return Err(Unsolvable::too_extreme(Term::Distance));
        }
        let counted = self.depth().m();
        if counted.is_normal() && counted > 0.0 {
            Ok(self)
        } else {
            Err(Unsolvable::Value {
                term: Term::Input(Field::Zero),
                refusal: Refusal::BehindZero,
            })
        }
    }

    /// The distance: along the optical axis, from where distances are counted.
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
        self.counted_from_zero(self.projected_depth())
    }

    /// P, of a ball to its center: what the relative σ are of.
    pub(crate) fn projected_depth(&self) -> Length {
        self.center_behind(self.facing_depth(), self.length.value)
    }

    /// P with the focal length of the lens: the distance from the lens, wherever distances are counted from.
    pub(crate) fn optical_depth(&self) -> Length {
        Length::from_m(self.projected_depth().m() + self.lens.m())
    }

    /// f·L/x.
    pub(crate) fn facing_depth(&self) -> Length {
        Length::from_m(times_over(self.focal_length.value, self.length.value.m(), self.divisor().value))
    }

    /// A depth of what faces the camera as one to the center, where it is the outline of a ball `length` wide.
    pub(crate) fn center_behind(&self, facing: Length, length: Length) -> Length {
        if self.is_ball {
            monocular::depth_of_center(facing, length)
        } else {
            facing
        }
    }

    /// A depth from the center of projection as it is counted.
    pub(crate) fn counted_from_zero(&self, depth: Length) -> Length {
        Length::from_m(depth.m() + self.lens.m() - self.zero.m())
    }

    /// Where distances are counted from, in front of the lens.
    pub(crate) const fn zero(&self) -> Length {
        self.zero
    }

    /// Whose σ the focal length has, fx or fy; `None` for an angle, which has none. Only what has the same shares it.
    pub(crate) fn calibration(&self) -> Option<Field> {
        self.angle.is_none().then_some(self.focal_length_source)
    }

    /// With a focal length along the columns whose σ is its own.
    pub(crate) const fn with_fy(self) -> Self {
        Self {
            focal_length_source: Field::Fy,
            ..self
        }
    }

    /// Whether f and x are in pixels.
    pub(crate) const fn is_in_pixels(&self) -> bool {
        self.is_in_pixels
    }

    /// σ_P/P to first order, P being the distance from the center of projection.
    ///
    /// Stereo: (σ_P/P)² = (σ_f/f)² + (σ_b/b)² + (σ_d² + σ_δ²)/(d + δ)².
    /// Monocular: (σ_P/P)² = (σ_w/w_real)² + (σ_f/f)² + (σ_p/w_img)².
    /// Of a ball those of f and w_img count 1/(1 + (w_img/2f)²) times.
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

    /// f, in the unit of the [divisor](Self::divisor): 1 for an angle.
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
    /// assert_eq!(mug.focal_length().value, 700.0);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    pub const fn focal_length(&self) -> Measured<f64> {
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

    /// The disparity (without doffs) or the width in the image, and which of the two it is: in pixels, meters on the sensor, or of an
    /// angle 2·tan(α/2).
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
    /// let (source, extent) = mug.extent();
    /// assert_eq!((source, extent.value), (depth_core::field::Field::Disparity, 50.0));
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    pub const fn extent(&self) -> (Field, Measured<f64>) {
        (self.extent_source, self.extent)
    }

    /// What the product of focal length and length is divided by, d + δ or w_img, in the unit of the [extent](Self::extent).
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
    /// assert_eq!(mug.divisor().value, 50.0);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    pub fn divisor(&self) -> Measured<f64> {
        self.extent.plus(self.doffs)
    }

    /// The extent, where it was measured as an angle.
    pub(crate) const fn angle(&self) -> Option<Measured<Angle>> {
        self.angle
    }

    /// How much more of the relative σ of f/x than of that of L the distance has: 1, of a near ball less.
    fn share_of_projection(&self) -> f64 {
        if !self.is_ball {
            return 1.0;
        }
        let half = self.divisor().value / (2.0 * self.focal_length.value);
        1.0 / (1.0 + half * half)
    }

    /// The relative σ that each input gives to the distance, in reading order.
    pub(crate) fn relative_sigmas(&self) -> [(Field, f64); 4] {
        let share = self.share_of_projection();
        let of_divisor = |sigma| Measured::new(self.divisor().value, sigma).relative() * share;
        [
            (self.focal_length_source, self.focal_length.relative() * share),
            (self.length_source, self.length.relative()),
            (self.extent_source, of_divisor(self.extent.sigma)),
            (Field::Doffs, of_divisor(self.doffs.sigma)),
        ]
    }

    /// One distance with f, L and x drawn at random by `normal`, in m; `None` for infinitely far.
    pub(crate) fn draw(&self, mut normal: impl FnMut(Measured<f64>) -> f64) -> Option<f64> {
        let focal_length = normal(self.focal_length);
        let length = normal(self.length.to_base());
        let divisor = match self.angle {
            None => normal(self.divisor()),
            // Nothing is nearer than what fills half of the world.
            Some(angle) => (normal(angle.to_base()).min(PI) / 2.0).tan() * 2.0,
        };
        if divisor <= 0.0 {
            return None;
        }
        if focal_length <= 0.0 || length <= 0.0 {
            return Some(0.0);
        }
        let facing = Length::from_m(times_over(focal_length, length, divisor));
        let depth = self.counted_from_zero(self.center_behind(facing, Length::from_m(length))).m();
        Some(depth.max(0.0)).filter(|depth| depth.is_finite())
    }
}
