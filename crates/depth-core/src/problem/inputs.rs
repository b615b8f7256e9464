//! [`Problem`]: what is known.

use crate::angle::Angle;
use crate::camera;
use crate::field::Field;
use crate::judge::{self, Refusal};
use crate::measured::Measured;
use crate::quantity::{Length, Pixels, Quantity};
use std::f64::consts::FRAC_PI_2;

/// What is known: the inputs with their σ (0 where none was given).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Problem {
    /// fx: focal length in pixels of the image that d and w_img are measured in.
    pub focal_length: Option<Measured<Pixels>>,
    /// b: distance between the optical centers of the two cameras.
    pub baseline: Option<Measured<Length>>,
    /// d: horizontal shift of the object between the rectified images.
    pub disparity: Option<Measured<Pixels>>,
    /// δ = cx_right − cx_left; `None` is 0.
    pub doffs: Option<Measured<Pixels>>,
    /// σ of the offset of 0 where [`doffs`](Self::doffs) is `None`: how well the principal points are known to coincide.
    pub coincidence_sigma: Pixels,
    /// w_img: width of the object in the image.
    pub image_width: Option<Measured<Pixels>>,
    /// w_real: width of the object itself.
    pub real_width: Option<Measured<Length>>,
    /// φ: by how much the object is turned away from facing the camera; `None` is 0. Taken to be exact.
    pub tilt: Option<Angle>,
}

impl Default for Problem {
    /// Nothing is known.
    fn default() -> Self {
        Self {
            focal_length: None,
            baseline: None,
            disparity: None,
            doffs: None,
            coincidence_sigma: Pixels::ZERO,
            image_width: None,
            real_width: None,
            tilt: None,
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
        match field {
            Field::FocalLength => self.focal_length = value.map(|value| Measured::from_base(value, sigma)),
            Field::Baseline => self.baseline = value.map(|value| Measured::from_base(value, sigma)),
            Field::Disparity => self.disparity = value.map(|value| Measured::from_base(value, sigma)),
            Field::Doffs => {
                self.doffs = value.map(|value| Measured::from_base(value, sigma));
                self.coincidence_sigma = if value.is_none() { Pixels::new(sigma) } else { Pixels::ZERO };
            }
            Field::ImageWidth => self.image_width = value.map(|value| Measured::from_base(value, sigma)),
            Field::RealWidth => self.real_width = value.map(|value| Measured::from_base(value, sigma)),
            Field::Tilt => self.tilt = value.map(Angle::from_radians),
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

    /// Sets σ of `field` in its base unit (px, meters or radians), 0 for none. Without a value only doffs can have one; a tilt has none.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// mug.set_sigma(Field::Disparity, 0.5);
    /// assert_eq!(mug.disparity.unwrap().sigma.px(), 0.5);
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
        match field {
            Field::FocalLength => give(&mut self.focal_length, sigma),
            Field::Baseline => give(&mut self.baseline, sigma),
            Field::Disparity => give(&mut self.disparity, sigma),
            Field::Doffs if self.doffs.is_none() => self.coincidence_sigma = Pixels::new(sigma),
            Field::Doffs => give(&mut self.doffs, sigma),
            Field::ImageWidth => give(&mut self.image_width, sigma),
            Field::RealWidth => give(&mut self.real_width, sigma),
            Field::Tilt => {}
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
            Field::FocalLength => self.focal_length.map(Measured::to_base),
            Field::Baseline => self.baseline.map(Measured::to_base),
            Field::Disparity => self.disparity.map(Measured::to_base),
            Field::Doffs => self.doffs.map(Measured::to_base),
            Field::ImageWidth => self.image_width.map(Measured::to_base),
            Field::RealWidth => self.real_width.map(Measured::to_base),
            Field::Tilt => self.tilt.map(|tilt| Measured::exact(tilt).to_base()),
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

    /// d + δ: the disparity as it enters the formula. Its sign decides whether the object is in front of the cameras.
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
        Some(Pixels::new(self.disparity?.value.px() + self.offset().value.px()))
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
        let tilt = self.tilt.unwrap_or(Angle::ZERO);
        Some(Measured::new(
            camera::foreshortened(width.value, tilt)?,
            camera::foreshortened(width.sigma, tilt)?,
        ))
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
        let of_one_meter = camera::foreshortened(Length::from_m(1.0), self.tilt.unwrap_or(Angle::ZERO));
        let cosine = of_one_meter.map_or(1.0, Length::m);
        Measured::from_base(width.value.m() / cosine, width.sigma.m() / cosine)
    }

    /// Checks that the value of `field`, if it has one, can be used: positive, finite and normal. A disparity is judged
    /// together with doffs, which itself may be any finite number; a tilt is below 90° in either direction.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// assert_eq!(mug.check(Field::Disparity), Ok(()));
    /// mug.set(Field::Doffs, Some(-50.0));
    /// assert_eq!(mug.check(Field::Disparity), Err(depth_core::problem::Refusal::Zero));
    /// ```
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn check(&self, field: Field) -> Result<(), Refusal> {
        let value = match field {
            Field::Disparity => self.effective_disparity().map(Pixels::px),
            _ => self.get(field),
        };
        match (field, value) {
            (_, None) => Ok(()),
            (Field::Doffs, Some(value)) => judge::finite(value).map(|_| ()),
            (Field::Tilt, Some(value)) => judge::finite(value).and_then(|tilt| {
                let shows_a_width = tilt.abs() < FRAC_PI_2;
                shows_a_width.then_some(()).ok_or(Refusal::TurnedAway)
            }),
            (_, Some(value)) => judge::positive(value).map(|_| ()),
        }
    }

    /// Whether the value of `field` lies in its [usual range](Field::usual_range); true where there is none.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// assert!(mug.is_usual(Field::Baseline));
    /// // 100 mm taken for meters.
    /// mug.set(Field::Baseline, Some(100.0));
    /// assert!(!mug.is_usual(Field::Baseline));
    /// ```
    pub fn is_usual(&self, field: Field) -> bool {
        let value = match field {
            Field::Disparity => self.effective_disparity().map(Pixels::px),
            _ => self.get(field),
        };
        value.is_none_or(|value| field.is_usual(value))
    }
}
