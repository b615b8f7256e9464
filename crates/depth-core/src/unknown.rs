//! Any one unknown of an equation, from all the others: the disparity to expect at a distance, the baseline that a pair
//! must have had, the focal length from one photograph at a known distance.

use crate::field::Field;
use crate::judge::{self, Term, Unsolvable};
use crate::measured::{Measured, measured_times_over as times_over};
use crate::quantity::{Length, Pixels, Quantity};

/// The unknown of an equation with its σ to first order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Found {
    /// f
    FocalLength(Measured<Pixels>),
    /// b
    Baseline(Measured<Length>),
    /// d
    Disparity(Measured<Pixels>),
    /// δ
    Doffs(Measured<Pixels>),
    /// w_img
    ImageWidth(Measured<Pixels>),
    /// w_real
    RealWidth(Measured<Length>),
    /// Z
    Distance(Measured<Length>),
}

impl Found {
    /// Which term it is.
    ///
    /// ```
    /// use depth_core::judge::Term;
    /// use depth_core::measured::Measured;
    /// use depth_core::unknown::Found;
    ///
    /// assert_eq!(Found::Distance(Measured::from_base(1.4, 0.0)).term(), Term::Distance);
    /// ```
    pub const fn term(self) -> Term {
        match self {
            Self::FocalLength(_) => Term::Input(Field::FocalLength),
            Self::Baseline(_) => Term::Input(Field::Baseline),
            Self::Disparity(_) => Term::Input(Field::Disparity),
            Self::Doffs(_) => Term::Input(Field::Doffs),
            Self::ImageWidth(_) => Term::Input(Field::ImageWidth),
            Self::RealWidth(_) => Term::Input(Field::RealWidth),
            Self::Distance(_) => Term::Distance,
        }
    }

    /// Its value and σ in the base unit (px or meters).
    ///
    /// ```
    /// use depth_core::measured::Measured;
    /// use depth_core::unknown::Found;
    ///
    /// assert_eq!(Found::Distance(Measured::from_base(1.4, 0.1)).to_base(), Measured::new(1.4, 0.1));
    /// ```
    pub fn to_base(self) -> Measured<f64> {
        match self {
            Self::FocalLength(pixels) | Self::Disparity(pixels) | Self::Doffs(pixels) | Self::ImageWidth(pixels) => pixels.to_base(),
            Self::Baseline(length) | Self::RealWidth(length) | Self::Distance(length) => length.to_base(),
        }
    }
}

/// Z·(d + δ) = f·b; `None` for what is asked for. All pixels are those of one image.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StereoEquation {
    /// f
    pub focal_length: Option<Measured<Pixels>>,
    /// b
    pub baseline: Option<Measured<Length>>,
    /// d
    pub disparity: Option<Measured<Pixels>>,
    /// δ = cx_right − cx_left: exactly 0 where the principal points coincide
    pub doffs: Option<Measured<Pixels>>,
    /// Z
    pub distance: Option<Measured<Length>>,
}

/// Z·w_img = f·w_real; `None` for what is asked for. All pixels are those of one image.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MonocularEquation {
    /// f
    pub focal_length: Option<Measured<Pixels>>,
    /// w_real
    pub real_width: Option<Measured<Length>>,
    /// w_img
    pub image_width: Option<Measured<Pixels>>,
    /// Z
    pub distance: Option<Measured<Length>>,
}

impl StereoEquation {
    /// The unknown and its value, with its σ to first order.
    ///
    /// ```
    /// use depth_core::measured::Measured;
    /// use depth_core::unknown::{Found, StereoEquation};
    ///
    /// // At what disparity does something 2 m away appear?
    /// let found = StereoEquation {
    ///     focal_length: Some(Measured::from_base(700.0, 0.0)),
    ///     baseline: Some(Measured::from_base(0.1, 0.0)),
    ///     disparity: None,
    ///     doffs: Some(Measured::from_base(0.0, 0.0)),
    ///     distance: Some(Measured::from_base(2.0, 0.0)),
    /// }
    /// .solve()?;
    /// assert_eq!(found, Found::Disparity(Measured::from_base(35.0, 0.0)));
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    ///
    /// # Errors
    /// [`Unsolvable`] says which term to look at.
    ///
    /// Source: the Middlebury 2014 calibration format's Z = f·b/(d + doffs), rearranged; JCGM 100:2008 (GUM), 5.1.
    pub fn solve(&self) -> Result<Found, Unsolvable> {
        let focal_length = positive(self.focal_length, Term::Input(Field::FocalLength))?;
        let baseline = positive(self.baseline, Term::Input(Field::Baseline))?;
        let disparity = finite(self.disparity, Term::Input(Field::Disparity))?;
        let doffs = finite(self.doffs, Term::Input(Field::Doffs))?;
        let distance = positive(self.distance, Term::Distance)?;
        match (focal_length, baseline, disparity, doffs, distance) {
            (None, Some(b), Some(d), Some(o), Some(z)) => found(times_over(z, divisor(d, o)?, b), Found::FocalLength),
            (Some(f), None, Some(d), Some(o), Some(z)) => found(times_over(z, divisor(d, o)?, f), Found::Baseline),
            (Some(f), Some(b), None, Some(o), Some(z)) => found(shift(f, b, z).map(|shift| shift.minus(o)), Found::Disparity),
            (Some(f), Some(b), Some(d), None, Some(z)) => found(shift(f, b, z).map(|shift| shift.minus(d)), Found::Doffs),
            (Some(f), Some(b), Some(d), Some(o), None) => found(times_over(f, b, divisor(d, o)?), Found::Distance),
            _ => Err(Unsolvable::NotOneUnknown),
        }
    }
}

impl MonocularEquation {
    /// The unknown and its value, with its σ to first order.
    ///
    /// ```
    /// use depth_core::measured::Measured;
    /// use depth_core::unknown::{Found, MonocularEquation};
    ///
    /// // A photograph of 0.5 m at 2 m, 175 px wide: f = 175 px · 2 m / 0.5 m.
    /// let found = MonocularEquation {
    ///     focal_length: None,
    ///     real_width: Some(Measured::from_base(0.5, 0.0)),
    ///     image_width: Some(Measured::from_base(175.0, 0.0)),
    ///     distance: Some(Measured::from_base(2.0, 0.0)),
    /// }
    /// .solve()?;
    /// assert_eq!(found, Found::FocalLength(Measured::from_base(700.0, 0.0)));
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    ///
    /// # Errors
    /// [`Unsolvable`] says which term to look at.
    ///
    /// Source: pinhole projection by similar triangles, rearranged; JCGM 100:2008 (GUM), 5.1.6.
    pub fn solve(&self) -> Result<Found, Unsolvable> {
        let focal_length = positive(self.focal_length, Term::Input(Field::FocalLength))?;
        let real_width = positive(self.real_width, Term::Input(Field::RealWidth))?;
        let image_width = positive(self.image_width, Term::Input(Field::ImageWidth))?;
        let distance = positive(self.distance, Term::Distance)?;
        match (focal_length, real_width, image_width, distance) {
            (None, Some(w), Some(p), Some(z)) => found(times_over(z, p, w), Found::FocalLength),
            (Some(f), None, Some(p), Some(z)) => found(times_over(z, p, f), Found::RealWidth),
            (Some(f), Some(w), None, Some(z)) => found(times_over(f, w, z), Found::ImageWidth),
            (Some(f), Some(w), Some(p), None) => found(times_over(f, w, p), Found::Distance),
            _ => Err(Unsolvable::NotOneUnknown),
        }
    }
}

/// A term that is given must be positive.
fn positive<Q: Quantity>(given: Option<Measured<Q>>, term: Term) -> Result<Option<Measured<Q>>, Unsolvable> {
    given.map(|given| judge::positive_measured(term, given)).transpose()
}

/// A term that is given may have either sign.
fn finite<Q: Quantity>(given: Option<Measured<Q>>, term: Term) -> Result<Option<Measured<Q>>, Unsolvable> {
    given.map(|given| judge::finite_measured(term, given)).transpose()
}

/// d + δ, which must be positive.
fn divisor(disparity: Measured<Pixels>, doffs: Measured<Pixels>) -> Result<Measured<Pixels>, Unsolvable> {
    judge::positive_measured(Term::Input(Field::Disparity), disparity.plus(doffs))
}

/// d + δ that belongs to a distance, f·b/Z.
fn shift(f: Measured<Pixels>, b: Measured<Length>, z: Measured<Length>) -> Option<Measured<Pixels>> {
    times_over(f, b, z)
}

/// `value` as the `unknown`, where it can be represented.
fn found<Q: Quantity>(value: Option<Measured<Q>>, unknown: fn(Measured<Q>) -> Found) -> Result<Found, Unsolvable> {
    let term = unknown(Measured::exact(Q::ZERO)).term();
    let value = value.filter(|&value| judge::finite_measured(term, value).is_ok());
    value.map(unknown).ok_or(Unsolvable::too_extreme(term))
}
