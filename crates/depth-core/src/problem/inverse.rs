//! [`Problem::solve_for`]: another quantity, where the distance is known.

use super::inputs::Problem;
use crate::field::Field;
use crate::in_image::InImage;
use crate::judge::{self, Refusal, Term, Unsolvable};
use crate::measured::Measured;
use crate::method::Method;
use crate::monocular;
use crate::quantity::{Length, Pixels};
use crate::setup::Object;
use crate::unknown::{Found, MonocularEquation, StereoEquation};

/// What was solved for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solved {
    /// A focal length or an extent in the image.
    InImage(InImage),
    /// The baseline or the real width.
    Length(Measured<Length>),
}

impl Solved {
    /// Its value and σ in the base unit.
    ///
    /// ```
    /// use depth_core::measured::Measured;
    /// use depth_core::problem::Solved;
    ///
    /// assert_eq!(Solved::Length(Measured::from_base(0.1, 0.001)).to_base(), Measured::new(0.1, 0.001));
    /// ```
    pub fn to_base(self) -> Measured<f64> {
        match self {
            Self::InImage(extent) => extent.to_base(),
            Self::Length(length) => length.to_base(),
        }
    }
}

impl Problem {
    /// What `field` of the equation of `method` must be for the object to be at `distance`, counted as all distances are; its σ to
    /// first order.
    ///
    /// `Ok(None)` where another input of the equation is missing.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Method, Problem};
    /// use depth_core::measured::Measured;
    ///
    /// let mut pair = Problem::default();
    /// pair.set(Field::FocalLength, Some(700.0));
    /// pair.set(Field::Baseline, Some(0.1));
    /// let disparity = pair.solve_for(Method::Stereo, Field::Disparity, Measured::from_base(2.0, 0.0))?;
    /// assert_eq!(disparity.unwrap().to_base().value, 35.0);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    ///
    /// # Errors
    /// [`Unsolvable`] says which term to look at.
    ///
    /// Source: as [`StereoEquation::solve`] and [`MonocularEquation::solve`]; of a ball as
    /// [`monocular::depth_of_disk`] and [`monocular::diameter`].
    pub fn solve_for(&self, method: Method, field: Field, distance: Measured<Length>) -> Result<Option<Solved>, Unsolvable> {
        let Some([focal_length, extent]) = self.in_image(method, field)? else {
            return Ok(None);
        };
        let in_pixels = self.answers_in_pixels(method, field);
        let from_center = distance.value.m() - self.counted_from(in_pixels).m();
        judge::value(Term::Distance, judge::positive(from_center).map_err(|_| Refusal::BehindZero))?;
        let mut given = Given {
            focal_length,
            extent,
            distance: Measured::new(Length::from_m(from_center), distance.sigma),
            length: match method {
                Method::Stereo => self.baseline,
                Method::Monocular => self.foreshortened_width(),
            },
        };
        if self.object == Object::Ball && method == Method::Monocular {
            given = given.of_disk(field)?;
        }
        let found = self.solve_equation(method, field, given)?;
        let in_unit = |pixels: Measured<Pixels>| {
            Solved::InImage(if in_pixels {
                InImage::Pixels(pixels)
            } else {
                InImage::OnSensor(Measured::from_base(pixels.value.px(), pixels.sigma.px()))
            })
        };
        Ok(found.map(|found| match found {
            Found::FocalLength(pixels) | Found::Disparity(pixels) | Found::Doffs(pixels) | Found::ImageWidth(pixels) => in_unit(pixels),
            Found::Baseline(length) | Found::Distance(length) => Solved::Length(length),
            // The equation has the width that shows.
            Found::RealWidth(width) => Solved::Length(self.turned_away(width)),
        }))
    }

    /// Focal length and extent of the equation of `method`, where it is solved for `field`, as numbers of one unit, which cancels;
    /// `Ok(None)` where one of them is missing.
    fn in_image(&self, method: Method, field: Field) -> Result<Option<[Option<Measured<Pixels>>; 2]>, Unsolvable> {
        let number = |measured: Measured<f64>| Measured::from_base(measured.value, measured.sigma);
        let [focal_length, extent] = [self.focal_length_of(method), self.extent(method)];
        match field {
            // An angle has none.
            Field::FocalLength if matches!(extent, Some(InImage::Angle(_))) => Err(Unsolvable::NotOneUnknown),
            // The offset of the principal points is in pixels.
            Field::Doffs if [focal_length, extent].into_iter().flatten().any(|one| one.px().is_none()) => Err(Unsolvable::Value {
                term: Term::Input(Field::Doffs),
                refusal: Refusal::OtherUnit,
            }),
            Field::FocalLength | Field::Disparity | Field::ImageWidth => {
                Ok(Some([focal_length, extent].map(|one| one.map(InImage::to_base).map(number))))
            }
            _ => {
                let projected = self.projected(method).transpose()?;
                Ok(projected.map(|projected| [projected.focal_length, projected.extent].map(|one| Some(number(one)))))
            }
        }
    }

    /// Whether what is found for `field` of the image is in pixels: as what is given there is.
    fn answers_in_pixels(&self, method: Method, field: Field) -> bool {
        let given = if field == Self::extent_of(method) {
            self.focal_length_of(method)
        } else {
            self.extent(method)
        };
        given.is_none_or(|given| given.px().is_some())
    }

    const fn extent_of(method: Method) -> Field {
        match method {
            Method::Stereo => Field::Disparity,
            Method::Monocular => Field::ImageWidth,
        }
    }

    fn extent(&self, method: Method) -> Option<InImage> {
        match method {
            Method::Stereo => self.disparity,
            Method::Monocular => self.image_width,
        }
    }

    fn solve_equation(&self, method: Method, field: Field, given: Given) -> Result<Option<Found>, Unsolvable> {
        let Given {
            focal_length,
            extent,
            distance,
            length,
        } = given;
        let is_missing = |source: Field, given: bool| source != field && !given;
        let [_, second, third] = method.fields();
        let (length_source, extent_source) = match method {
            Method::Stereo => (second, third),
            Method::Monocular => (third, second),
        };
        if is_missing(Field::FocalLength, focal_length.is_some())
            || is_missing(length_source, length.is_some())
            || is_missing(extent_source, extent.is_some())
        {
            return Ok(None);
        }
        let found = match method {
            Method::Stereo => StereoEquation {
                focal_length: focal_length.filter(|_| field != Field::FocalLength),
                baseline: length.filter(|_| field != Field::Baseline),
                disparity: extent.filter(|_| field != Field::Disparity),
                doffs: (field != Field::Doffs).then(|| self.offset()),
                distance: Some(distance),
            }
            .solve(),
            Method::Monocular => MonocularEquation {
                focal_length: focal_length.filter(|_| field != Field::FocalLength),
                real_width: length.filter(|_| field != Field::RealWidth),
                image_width: extent.filter(|_| field != Field::ImageWidth),
                distance: Some(distance),
            }
            .solve(),
        };
        found.map(Some)
    }
}

/// The terms of an equation; f and x as numbers of one unit, which cancels.
struct Given {
    focal_length: Option<Measured<Pixels>>,
    extent: Option<Measured<Pixels>>,
    distance: Measured<Length>,
    length: Option<Measured<Length>>,
}

impl Given {
    /// The same for a disk that looks as wide as the ball, where `field` is asked for.
    ///
    /// With P the depth of the disk and D that of the center: of the relative σ of D and L the other unknowns have (D/P)² times as
    /// much as in the equation of the disk. L itself follows from f/x by D²/P² = 1 + (x/2f)².
    fn of_disk(self, field: Field) -> Result<Self, Unsolvable> {
        let center = self.distance.value;
        let disk = match (field, self.length, self.focal_length, self.extent) {
            (Field::RealWidth, _, Some(focal_length), Some(extent)) => {
                let diameter = monocular::diameter(focal_length.value, extent.value, center);
                monocular::depth_of_disk(center, diameter)
            }
            (_, Some(length), _, _) => monocular::depth_of_disk(center, length.value),
            _ => Some(center),
        };
        let inside = Unsolvable::Value {
            term: Term::Distance,
            refusal: Refusal::BehindZero,
        };
        let disk = disk.ok_or(inside)?;
        let steeper = (center.m() / disk.m()).powi(2);
        let scaled = |measured: Measured<f64>, times: f64| Measured::new(measured.value, measured.sigma * times);
        if field == Field::RealWidth {
            // dL/L = dD/D + (P/D)² · d(x/f)/(x/f)
            let gentler = |pixels: Measured<Pixels>| {
                let Measured { value, sigma } = scaled(pixels.to_base(), 1.0 / steeper);
                Measured::from_base(value, sigma)
            };
            return Ok(Self {
                focal_length: self.focal_length.map(gentler),
                extent: self.extent.map(gentler),
                distance: Measured::new(disk, Length::from_m(disk.m() * self.distance.relative())),
                ..self
            });
        }
        Ok(Self {
            distance: Measured::new(disk, Length::from_m(disk.m() * self.distance.relative() * steeper)),
            length: self
                .length
                .map(|length| Measured::new(length.value, Length::from_m(length.sigma.m() * steeper))),
            ..self
        })
    }
}
