//! Whether a number can be used, and if not, why. The one place that decides it, and the one error of this crate.

use crate::angle::Angle;
use crate::field::Field;
use crate::measured::Measured;
use crate::quantity::{Pixels, Quantity};
use std::f64::consts::FRAC_PI_2;

/// What an error is about: a term of an equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Term {
    /// One of the inputs of a distance. [`Field::Disparity`] stands for the sum of disparity and doffs where both are
    /// given.
    Input(Field),
    /// The distance itself.
    Distance,
    /// The column at which a point is seen.
    Column,
    /// The row at which a point is seen.
    Row,
    /// The principal point.
    PrincipalPoint,
    /// The height of the camera above the floor.
    CameraHeight,
    /// The height of the target above the floor.
    TargetHeight,
    /// How far the camera looks down.
    Pitch,
    /// How far a ray points below the optical axis.
    BelowAxis,
    /// How far the camera was moved between two photographs.
    Step,
    /// The width in the photograph that was taken farther away.
    FarWidth,
    /// The width in the photograph that was taken nearer.
    NearWidth,
}

/// Why a value cannot be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// NaN.
    NotANumber,
    /// Zero. For a disparity: the object is infinitely far away.
    Zero,
    /// Below zero. For a disparity: left and right may be swapped.
    Negative,
    /// Infinite or subnormal, by itself or in the distance that would follow.
    TooExtreme,
    /// An angle of 90° or more: a target turned so far shows no width.
    TurnedAway,
    /// An angle of 180° or more: nothing in a picture subtends so much.
    TooWide,
    /// A length on the sensor beside pixels, or pixels beside lengths on the sensor: without the size of a pixel they have nothing
    /// to do with each other.
    OtherUnit,
    /// Distances are counted from a place that is as far away as the object, or farther.
    BehindZero,
}

/// Why a distance, or another unknown, cannot be computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unsolvable {
    /// The value of a term cannot be used, or (for the unknown itself) cannot be represented.
    Value {
        /// The term.
        term: Term,
        /// What is wrong with it.
        refusal: Refusal,
    },
    /// The standard deviation of a term is negative, not finite, or [out of all proportion](LARGEST_RELATIVE_SIGMA).
    Sigma {
        /// The term.
        term: Term,
    },
    /// Exactly one term of an equation must be absent.
    NotOneUnknown,
    /// The ray of a pixel never meets the level plane that the target stands on.
    MissesPlane {
        /// The row of the horizon; `None` where the camera looks straight up or down.
        horizon: Option<Pixels>,
        /// Whether it would with the opposite pitch: of two ways to count it, the other one was meant.
        meets_with_opposite_pitch: bool,
    },
}

/// A σ of more than this many times the value says nothing, and its square could not be represented.
pub const LARGEST_RELATIVE_SIGMA: f64 = 1e150;

impl Unsolvable {
    /// The term to look at; `None` for [`NotOneUnknown`](Self::NotOneUnknown).
    ///
    /// ```
    /// use depth_core::judge::{Refusal, Term, Unsolvable};
    ///
    /// let error = Unsolvable::Value { term: Term::Pitch, refusal: Refusal::NotANumber };
    /// assert_eq!(error.term(), Some(Term::Pitch));
    /// ```
    pub const fn term(self) -> Option<Term> {
        match self {
            Self::Value { term, .. } | Self::Sigma { term } => Some(term),
            Self::NotOneUnknown => None,
            Self::MissesPlane { .. } => Some(Term::Row),
        }
    }

    /// The input to look at; `None` where the error is about something else.
    ///
    /// ```
    /// use depth_core::field::Field;
    /// use depth_core::judge::{Term, Unsolvable};
    ///
    /// assert_eq!(Unsolvable::Sigma { term: Term::Input(Field::Baseline) }.field(), Some(Field::Baseline));
    /// assert_eq!(Unsolvable::Sigma { term: Term::Distance }.field(), None);
    /// ```
    pub const fn field(self) -> Option<Field> {
        match self.term() {
            Some(Term::Input(field)) => Some(field),
            _ => None,
        }
    }

    /// The unknown cannot be represented.
    pub(crate) const fn too_extreme(term: Term) -> Self {
        Self::Value {
            term,
            refusal: Refusal::TooExtreme,
        }
    }
}

/// A finite number of either sign, or 0.
///
/// ```
/// use depth_core::judge::{Refusal, finite};
///
/// assert_eq!(finite(-40.0), Ok(-40.0));
/// assert_eq!(finite(f64::INFINITY), Err(Refusal::TooExtreme));
/// ```
///
/// # Errors
/// [`Refusal::NotANumber`] or [`Refusal::TooExtreme`].
pub const fn finite(value: f64) -> Result<f64, Refusal> {
    if value.is_nan() {
        Err(Refusal::NotANumber)
    } else if value.is_infinite() {
        Err(Refusal::TooExtreme)
    } else {
        Ok(value)
    }
}

/// A positive, finite and normal number.
///
/// ```
/// use depth_core::judge::{Refusal, positive};
///
/// assert_eq!(positive(50.0), Ok(50.0));
/// assert_eq!(positive(0.0), Err(Refusal::Zero));
/// assert_eq!(positive(-50.0), Err(Refusal::Negative));
/// ```
///
/// # Errors
/// [`Refusal`].
pub const fn positive(value: f64) -> Result<f64, Refusal> {
    if value.is_nan() {
        Err(Refusal::NotANumber)
    } else if value == 0.0 {
        Err(Refusal::Zero)
    } else if value < 0.0 {
        Err(Refusal::Negative)
    } else if value.is_normal() {
        Ok(value)
    } else {
        Err(Refusal::TooExtreme)
    }
}

/// The number that `judged` lets pass, or the error about `term`.
pub(crate) fn value(term: Term, judged: Result<f64, Refusal>) -> Result<f64, Unsolvable> {
    judged.map_err(|refusal| Unsolvable::Value { term, refusal })
}

/// A [finite] quantity with a standard deviation of 0 or more.
pub(crate) fn finite_measured<Q: Quantity>(term: Term, given: Measured<Q>) -> Result<Measured<Q>, Unsolvable> {
    value(term, finite(given.value.to_base()))?;
    sigma(term, given)
}

/// A [positive] quantity with a standard deviation of 0 or more and not [out of all proportion](LARGEST_RELATIVE_SIGMA).
pub(crate) fn positive_measured<Q: Quantity>(term: Term, given: Measured<Q>) -> Result<Measured<Q>, Unsolvable> {
    value(term, positive(given.value.to_base()))?;
    let given = sigma(term, given)?;
    relative_sigma(term, given.relative())?;
    Ok(given)
}

/// A [finite] angle with a standard deviation from 0 to 90°: one that could point anywhere says nothing.
pub(crate) fn angle_measured(term: Term, given: Measured<Angle>) -> Result<Measured<Angle>, Unsolvable> {
    let given = finite_measured(term, given)?;
    if given.sigma.radians() <= FRAC_PI_2 {
        Ok(given)
    } else {
        Err(Unsolvable::Sigma { term })
    }
}

/// A quantity whose standard deviation is finite and 0 or more.
fn sigma<Q: Quantity>(term: Term, given: Measured<Q>) -> Result<Measured<Q>, Unsolvable> {
    if (0.0..=f64::MAX).contains(&given.sigma.to_base()) {
        Ok(given)
    } else {
        Err(Unsolvable::Sigma { term })
    }
}

/// Checks a standard deviation as a fraction of what it belongs to.
pub(crate) fn relative_sigma(term: Term, relative: f64) -> Result<(), Unsolvable> {
    if (0.0..=LARGEST_RELATIVE_SIGMA).contains(&relative) {
        Ok(())
    } else {
        Err(Unsolvable::Sigma { term })
    }
}
