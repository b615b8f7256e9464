//! [`Problem`]: what is known.

use crate::angle::Angle;
use crate::camera;
use crate::field::Field;
use crate::in_image::InImage;
use crate::measured::Measured;
use crate::method::Method;
use crate::quantity::{Length, Pixels, Quantity};
use crate::setup::{Object, Pair};

/// What is known: the inputs with their σ (0 where none was given).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Problem {
    /// fx: focal length, in pixels of the image that d and w_img are measured in, or as they a length. Not needed for angles.
    pub focal_length: Option<InImage>,
    /// The focal length of the lens that fx was computed from, where it was: then the lens is taken to be focused on the object, and
    /// its own focal length is added to the distance. Taken to be exact. Has no part in what is no number of pixels.
    pub lens: Option<Length>,
    /// fy, in the unit of fx: the focal length of heights and of vertical pairs; `None` is fx. Its ratio to fx is taken to be exact.
    pub fy: Option<InImage>,
    /// How the cameras stand.
    pub pair: Pair,
    /// b: distance between the optical centers of the two cameras.
    pub baseline: Option<Measured<Length>>,
    /// d: shift of the object between the rectified images, along the baseline.
    pub disparity: Option<InImage>,
    /// δ = cx_right − cx_left; `None` is 0.
    pub doffs: Option<Measured<Pixels>>,
    /// σ of the offset of 0 where [`doffs`](Self::doffs) is `None`: how well the principal points are known to coincide.
    pub coincidence_sigma: Pixels,
    /// What of the object is measured: "width" stands for it in the names here.
    pub object: Object,
    /// w_img: width of the object in the image.
    pub image_width: Option<InImage>,
    /// w_real: width of the object itself.
    pub real_width: Option<Measured<Length>>,
    /// φ: by how much the object is turned away from facing the camera; `None` is 0. Taken to be exact.
    pub tilt: Option<Angle>,
    /// How far in front of the lens distances are counted from; `None` is 0. It is taken from every distance, and added to every one
    /// that is given. Taken to be exact.
    pub zero: Option<Length>,
}

impl Default for Problem {
    /// Nothing is known.
    fn default() -> Self {
        Self {
            focal_length: None,
            lens: None,
            fy: None,
            pair: Pair::Horizontal,
            baseline: None,
            disparity: None,
            doffs: None,
            coincidence_sigma: Pixels::ZERO,
            object: Object::Width,
            image_width: None,
            real_width: None,
            tilt: None,
            zero: None,
        }
    }
}

impl Problem {
    /// The value of `field` in its base unit (px, meters or radians).
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// assert_eq!(mug.get(Field::Disparity), Some(50.0));
    /// assert_eq!(mug.get(Field::RealWidth), None);
    /// ```
    pub fn get(&self, field: Field) -> Option<f64> {
        self.measured(field).map(|input| input.value)
    }

    /// Sets `field` to `value` in its base unit (px, meters or radians). Its σ stays; without a value there is none, but that of doffs.
    /// What is measured in the image stays in its unit, and is in pixels where it had none: see [`set_in_image`](Self::set_in_image).
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// mug.set(Field::Disparity, None);
    /// assert_eq!(mug.disparity, None);
    /// ```
    pub fn set(&mut self, field: Field, value: Option<f64>) {
        let sigma = self.sigma(field);
        if let Some(in_image) = self.in_image_mut(field) {
            let unit = in_image.unwrap_or(InImage::from_px(0.0));
            *in_image = value.map(|value| unit.with_base(Measured::new(value, sigma)));
            return;
        }
        match field {
            Field::FocalLength | Field::Fy | Field::Disparity | Field::ImageWidth => {}
            Field::Lens => self.lens = value.map(Length::from_m),
            Field::Zero => self.zero = value.map(Length::from_m),
            Field::Baseline => self.baseline = value.map(|value| Measured::from_base(value, sigma)),
            Field::Doffs => {
                self.doffs = value.map(|value| Measured::from_base(value, sigma));
                self.coincidence_sigma = if value.is_none() { Pixels::new(sigma) } else { Pixels::ZERO };
            }
            Field::RealWidth => self.real_width = value.map(|value| Measured::from_base(value, sigma)),
            Field::Tilt => self.tilt = value.map(Angle::from_radians),
        }
    }

    /// Sets `field`, which is measured in the image, with its unit and σ. Other fields stay as they are.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// use depth_core::angle::{Angle, AngleUnit};
    /// use depth_core::in_image::InImage;
    /// use depth_core::measured::Measured;
    ///
    /// // 10 in at 0.75 mrad, without a focal length.
    /// let mut target = Problem::default();
    /// target.set(Field::RealWidth, Some(0.254));
    /// let angle = Angle::new(0.75, AngleUnit::Milliradian);
    /// target.set_in_image(Field::ImageWidth, InImage::Angle(Measured::exact(angle)));
    /// assert!((target.solve().monocular.distance().unwrap().m() - 338.667).abs() < 1e-3);
    /// ```
    pub fn set_in_image(&mut self, field: Field, extent: InImage) {
        if let Some(in_image) = self.in_image_mut(field) {
            *in_image = Some(extent);
        }
    }

    const fn in_image_mut(&mut self, field: Field) -> Option<&mut Option<InImage>> {
        match field {
            Field::FocalLength => Some(&mut self.focal_length),
            Field::Fy => Some(&mut self.fy),
            Field::Disparity => Some(&mut self.disparity),
            Field::ImageWidth => Some(&mut self.image_width),
            _ => None,
        }
    }

    /// σ of `field` in its base unit (px, meters or radians): 0 where none was given. That of doffs without a value belongs to an
    /// offset of 0.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// assert_eq!(mug.sigma(Field::Disparity), 0.0);
    /// ```
    pub fn sigma(&self, field: Field) -> f64 {
        match (field, self.measured(field)) {
            (_, Some(input)) => input.sigma,
            (Field::Doffs, None) => self.coincidence_sigma.px(),
            (_, None) => 0.0,
        }
    }

    /// Sets σ of `field` in its base unit (px, meters or radians), 0 for none. Without a value only doffs can have one; lens, tilt and zero
    /// have none, and fy has that of fx.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// mug.set_sigma(Field::Disparity, 0.5);
    /// assert_eq!(mug.disparity.unwrap().to_base().sigma, 0.5);
    /// // A real width that is not known has no σ either.
    /// mug.set_sigma(Field::RealWidth, 0.01);
    /// assert_eq!(mug.sigma(Field::RealWidth), 0.0);
    /// ```
    pub fn set_sigma(&mut self, field: Field, sigma: f64) {
        fn give<Q: Quantity>(input: &mut Option<Measured<Q>>, sigma: f64) {
            if let Some(input) = input {
                input.sigma = Q::from_base(sigma);
            }
        }
        if let Some(in_image) = self.in_image_mut(field) {
            *in_image = in_image.map(|extent| extent.with_base(Measured::new(extent.to_base().value, sigma)));
            return;
        }
        match field {
            Field::Baseline => give(&mut self.baseline, sigma),
            Field::Doffs if self.doffs.is_none() => self.coincidence_sigma = Pixels::new(sigma),
            Field::Doffs => give(&mut self.doffs, sigma),
            Field::RealWidth => give(&mut self.real_width, sigma),
            _ => {}
        }
    }

    /// The same inputs, taken to be exact.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// mug.set_sigma(Field::Disparity, 0.5);
    /// assert_eq!(mug.without_sigmas().sigma(Field::Disparity), 0.0);
    /// ```
    #[must_use]
    pub fn without_sigmas(mut self) -> Self {
        for field in Field::ALL {
            self.set_sigma(field, 0.0);
        }
        self
    }

    /// The value of `field` with its σ, in its base unit (px, meters or radians).
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// mug.set_sigma(Field::Baseline, 0.0005);
    /// assert_eq!(mug.measured(Field::Baseline), Some(depth_core::measured::Measured::new(0.1, 0.0005)));
    /// ```
    pub fn measured(&self, field: Field) -> Option<Measured<f64>> {
        match field {
            Field::FocalLength => self.focal_length.map(InImage::to_base),
            Field::Lens => self.lens.map(|lens| Measured::exact(lens).to_base()),
            Field::Fy => self.fy.map(InImage::to_base),
            Field::Baseline => self.baseline.map(Measured::to_base),
            Field::Disparity => self.disparity.map(InImage::to_base),
            Field::Doffs => self.doffs.map(Measured::to_base),
            Field::ImageWidth => self.image_width.map(InImage::to_base),
            Field::RealWidth => self.real_width.map(Measured::to_base),
            Field::Tilt => self.tilt.map(|tilt| Measured::exact(tilt).to_base()),
            Field::Zero => self.zero.map(|zero| Measured::exact(zero).to_base()),
        }
    }

    /// δ with its σ, as it enters the formula: 0 where none was given.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// assert_eq!(mug.offset().value.px(), 0.0);
    /// mug.set(Field::Doffs, Some(40.0));
    /// assert_eq!(mug.offset().value.px(), 40.0);
    /// ```
    pub fn offset(&self) -> Measured<Pixels> {
        self.doffs.unwrap_or(Measured::new(Pixels::ZERO, self.coincidence_sigma))
    }

    /// d + δ: the disparity as it enters the formula, where it is in pixels. Its sign decides whether the object is in front of the
    /// cameras.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// mug.set(Field::Doffs, Some(40.0));
    /// assert_eq!(mug.effective_disparity().unwrap().px(), 90.0);
    /// ```
    pub fn effective_disparity(&self) -> Option<Pixels> {
        Some(Pixels::new(self.disparity?.px()?.value.px() + self.offset().value.px()))
    }

    /// The focal length that the extents of `method` belong to: fy for a height and for a vertical pair, where it has no σ with
    /// that of fx, as they scale together; else fx.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Method, Problem};
    /// use depth_core::setup::Object;
    ///
    /// let mut person = Problem { object: Object::Height, ..Problem::default() };
    /// person.set(Field::FocalLength, Some(600.0));
    /// person.set(Field::Fy, Some(853.0));
    /// assert_eq!(person.focal_length_of(Method::Monocular).unwrap().to_base().value, 853.0);
    /// assert_eq!(person.focal_length_of(Method::Stereo).unwrap().to_base().value, 600.0);
    /// ```
    pub fn focal_length_of(&self, method: Method) -> Option<InImage> {
        if !self.needs_fy(method) {
            return self.focal_length;
        }
        let Some(fy) = self.fy else { return self.focal_length };
        let own = fy.relative();
        let relative = if own > 0.0 {
            own
        } else {
            self.focal_length.map_or(0.0, InImage::relative)
        };
        let value = fy.to_base().value;
        Some(fy.with_base(Measured::new(value, value * relative)))
    }

    /// Whether the extents of `method` are counted in rows.
    ///
    /// ```
    /// # use depth_core::problem::{Method, Problem};
    /// assert!(!Problem::default().needs_fy(Method::Stereo));
    /// ```
    pub fn needs_fy(&self, method: Method) -> bool {
        match method {
            Method::Stereo => self.pair == Pair::Vertical,
            Method::Monocular => self.object == Object::Height,
        }
    }

    /// w_real·cos φ: the width that the object shows to the camera.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut door = Problem::default();
    /// door.set(Field::RealWidth, Some(0.9));
    /// door.set(Field::Tilt, Some(60_f64.to_radians()));
    /// assert!((door.foreshortened_width().unwrap().value.m() - 0.45).abs() < 1e-12);
    /// ```
    pub fn foreshortened_width(&self) -> Option<Measured<Length>> {
        let width = self.real_width?;
        let tilt = self.tilt_that_counts();
        Some(Measured::new(
            camera::foreshortened(width.value, tilt)?,
            camera::foreshortened(width.sigma, tilt)?,
        ))
    }

    /// φ; a ball looks the same from every side.
    fn tilt_that_counts(&self) -> Angle {
        self.tilt.filter(|_| self.object != Object::Ball).unwrap_or(Angle::ZERO)
    }

    /// The width of which `width` is what shows to the camera, w/cos φ: the inverse of
    /// [`foreshortened_width`](Self::foreshortened_width).
    ///
    /// ```
    /// # use depth_core::measured::Measured;
    /// # use depth_core::problem::{Field, Problem};
    /// let mut door = Problem::default();
    /// door.set(Field::Tilt, Some(60_f64.to_radians()));
    /// assert!((door.turned_away(Measured::from_base(0.45, 0.0)).value.m() - 0.9).abs() < 1e-12);
    /// ```
    #[must_use]
    pub fn turned_away(&self, width: Measured<Length>) -> Measured<Length> {
        let of_one_meter = camera::foreshortened(Length::from_m(1.0), self.tilt_that_counts());
        let cosine = of_one_meter.map_or(1.0, Length::m);
        Measured::from_base(width.value.m() / cosine, width.sigma.m() / cosine)
    }
}
