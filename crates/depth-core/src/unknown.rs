//! Any one unknown of an equation, from all the others: the disparity to expect at a distance, the baseline that a pair
//! must have had, the focal length from one photograph at a known distance.

use crate::field::Field;
use crate::measured::Measured;

/// A term of the equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Term {
    /// One of the inputs of a distance.
    Input(Field),
    /// The distance itself, in metres.
    Distance,
}

/// Why an equation cannot be solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unsolvable {
    /// Exactly one term must be absent.
    NotOneUnknown,
    /// This term is not finite, not positive (for a disparity: together with doffs), or its σ is negative.
    Unusable(Term),
    /// The solution or its σ is too large or too small to be represented.
    TooExtreme(Term),
}

/// Z·(d + δ) = f·b; `None` for what is asked for. Lengths in metres, the others in pixels of one image.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StereoEquation {
    /// f, px
    pub focal_length: Option<Measured>,
    /// b, m
    pub baseline: Option<Measured>,
    /// d, px
    pub disparity: Option<Measured>,
    /// δ = cx_right − cx_left, px: exactly 0 where the principal points coincide
    pub doffs: Option<Measured>,
    /// Z, m
    pub distance: Option<Measured>,
}

/// Z·w_img = f·w_real; `None` for what is asked for. Lengths in metres, the others in pixels of one image.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MonocularEquation {
    /// f, px
    pub focal_length: Option<Measured>,
    /// w_real, m
    pub real_width: Option<Measured>,
    /// w_img, px
    pub image_width: Option<Measured>,
    /// Z, m
    pub distance: Option<Measured>,
}

impl StereoEquation {
    /// The unknown and its value, with its σ to first order.
    ///
    /// # Errors
    /// [`Unsolvable`] says which term to look at.
    ///
    /// Source: the Middlebury 2014 calibration format's Z = f·b/(d + doffs), rearranged; JCGM 100:2008 (GUM), 5.1.
    pub fn solve(&self) -> Result<(Term, Measured), Unsolvable> {
        let focal_length = positive(self.focal_length, Term::Input(Field::FocalLength))?;
        let baseline = positive(self.baseline, Term::Input(Field::Baseline))?;
        let disparity = possible(self.disparity, Term::Input(Field::Disparity))?;
        let doffs = possible(self.doffs, Term::Input(Field::Doffs))?;
        let distance = positive(self.distance, Term::Distance)?;
        match (focal_length, baseline, disparity, doffs, distance) {
            (None, Some(b), Some(d), Some(o), Some(z)) => solution(Field::FocalLength, Measured::times_over(z, divisor(d, o)?, b)),
            (Some(f), None, Some(d), Some(o), Some(z)) => solution(Field::Baseline, Measured::times_over(z, divisor(d, o)?, f)),
            (Some(f), Some(b), None, Some(o), Some(z)) => solution(Field::Disparity, difference(Measured::times_over(f, b, z), o)),
            (Some(f), Some(b), Some(d), None, Some(z)) => solution(Field::Doffs, difference(Measured::times_over(f, b, z), d)),
            (Some(f), Some(b), Some(d), Some(o), None) => distance_of(Measured::times_over(f, b, divisor(d, o)?)),
            _ => Err(Unsolvable::NotOneUnknown),
        }
    }
}

impl MonocularEquation {
    /// The unknown and its value, with its σ to first order.
    ///
    /// # Errors
    /// [`Unsolvable`] says which term to look at.
    ///
    /// Source: pinhole projection by similar triangles, rearranged; JCGM 100:2008 (GUM), 5.1.6.
    pub fn solve(&self) -> Result<(Term, Measured), Unsolvable> {
        let focal_length = positive(self.focal_length, Term::Input(Field::FocalLength))?;
        let real_width = positive(self.real_width, Term::Input(Field::RealWidth))?;
        let image_width = positive(self.image_width, Term::Input(Field::ImageWidth))?;
        let distance = positive(self.distance, Term::Distance)?;
        match (focal_length, real_width, image_width, distance) {
            (None, Some(w), Some(p), Some(z)) => solution(Field::FocalLength, Measured::times_over(z, p, w)),
            (Some(f), None, Some(p), Some(z)) => solution(Field::RealWidth, Measured::times_over(z, p, f)),
            (Some(f), Some(w), None, Some(z)) => solution(Field::ImageWidth, Measured::times_over(f, w, z)),
            (Some(f), Some(w), Some(p), None) => distance_of(Measured::times_over(f, w, p)),
            _ => Err(Unsolvable::NotOneUnknown),
        }
    }
}

fn positive(given: Option<Measured>, term: Term) -> Result<Option<Measured>, Unsolvable> {
    match given {
        Some(measured) if !measured.is_positive() => Err(Unsolvable::Unusable(term)),
        given => Ok(given),
    }
}

fn possible(given: Option<Measured>, term: Term) -> Result<Option<Measured>, Unsolvable> {
    match given {
        Some(measured) if !measured.is_possible() => Err(Unsolvable::Unusable(term)),
        given => Ok(given),
    }
}

/// d + δ, which must be positive.
fn divisor(disparity: Measured, doffs: Measured) -> Result<Measured, Unsolvable> {
    let sum = disparity.plus(doffs);
    if sum.is_positive() {
        Ok(sum)
    } else {
        Err(Unsolvable::Unusable(Term::Input(Field::Disparity)))
    }
}

fn difference(whole: Option<Measured>, part: Measured) -> Option<Measured> {
    whole.map(|whole| whole.plus(Measured::new(-part.value, part.sigma)))
}

fn solution(source: Field, value: Option<Measured>) -> Result<(Term, Measured), Unsolvable> {
    found(Term::Input(source), value)
}

fn distance_of(value: Option<Measured>) -> Result<(Term, Measured), Unsolvable> {
    found(Term::Distance, value)
}

fn found(term: Term, value: Option<Measured>) -> Result<(Term, Measured), Unsolvable> {
    value
        .filter(|measured| measured.is_possible())
        .map(|measured| (term, measured))
        .ok_or(Unsolvable::TooExtreme(term))
}
