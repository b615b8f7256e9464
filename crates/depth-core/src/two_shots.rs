//! [`TwoShots`]: two photographs of one object and the step between them, without its size.

use crate::arithmetic::root_sum_of_squares;
use crate::field::Field;
use crate::judge::{self, Refusal, Term, Unsolvable};
use crate::measured::Measured;
use crate::quantity::{Length, Pixels};

/// The same camera twice, the second time straight towards the object by a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoShots {
    /// How wide the object is in the photograph from farther away.
    pub far_width: Measured<Pixels>,
    /// How wide it is in the one from nearer.
    pub near_width: Measured<Pixels>,
    /// How far the camera was moved between them, along its optical axis.
    pub step: Measured<Length>,
    /// The focal length, to get the size of the object as well.
    pub focal_length: Option<Measured<Pixels>>,
}

/// Where the object is, and how wide it is, with first-order σ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoShotsSolution {
    /// From the first place, the farther one.
    pub far: Measured<Length>,
    /// From the second place.
    pub near: Measured<Length>,
    /// The width of the object; `None` without a focal length.
    pub size: Option<Measured<Length>>,
}

impl TwoShots {
    /// Z₁ = s·p₂/(p₂ − p₁) from the farther place, Z₂ = s·p₁/(p₂ − p₁) from the nearer one, and W = s·p₁·p₂/(f·(p₂ − p₁)).
    ///
    /// An error of a pixel counts about Z/s times as much as in a distance from a known size: the difference of both widths is all
    /// that is known.
    ///
    /// ```
    /// use depth_core::measured::Measured;
    /// use depth_core::two_shots::TwoShots;
    ///
    /// // Half as wide again after a step of 1 m: from 3 m to 2 m.
    /// let shots = TwoShots {
    ///     far_width: Measured::from_base(100.0, 0.0),
    ///     near_width: Measured::from_base(150.0, 0.0),
    ///     step: Measured::from_base(1.0, 0.0),
    ///     focal_length: Some(Measured::from_base(600.0, 0.0)),
    /// };
    /// let solution = shots.solve()?;
    /// assert_eq!((solution.far.value.m(), solution.near.value.m()), (3.0, 2.0));
    /// assert_eq!(solution.size.unwrap().value.m(), 0.5);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    ///
    /// # Errors
    /// [`Unsolvable`]; about the nearer width with [`Refusal::Negative`] or [`Refusal::Zero`] where it is not the larger one.
    ///
    /// Source: two pinhole projections of one width, p₁·Z₁ = p₂·Z₂ with Z₁ − Z₂ = s (distance from looming); JCGM 100:2008 (GUM), 5.1.2,
    /// for σ.
    pub fn solve(&self) -> Result<TwoShotsSolution, Unsolvable> {
        let far = judge::positive_measured(Term::FarWidth, self.far_width)?;
        let near = judge::positive_measured(Term::NearWidth, self.near_width)?;
        let step = judge::positive_measured(Term::Step, self.step)?;
        let focal_length = self
            .focal_length
            .map(|f| judge::positive_measured(Term::Input(Field::FocalLength), f));
        let focal_length = focal_length.transpose()?;
        let (p1, p2) = (far.value.px(), near.value.px());
        // The part of the nearer width by which it grew: exact where both are close.
        let growth = (p2 - p1) / p2;
        let refused = |refusal| {
            Err(Unsolvable::Value {
                term: Term::NearWidth,
                refusal,
            })
        };
        if growth <= 0.0 {
            return refused(if growth < 0.0 { Refusal::Negative } else { Refusal::Zero });
        }
        let z1 = step.value.m() / growth;
        let z2 = z1 * (p1 / p2);
        // d ln(p₂ − p₁) is what both pixels give: (dp₂ − dp₁)/(p₂ − p₁).
        let by_far = far.relative() * (p1 / p2) / growth;
        let by_near = near.relative() * (p1 / p2) / growth;
        let of = |value: f64, terms: &[f64]| measured(value, root_sum_of_squares(terms));
        let solution = TwoShotsSolution {
            // d ln Z₁ = d ln s + d ln p₂ − d ln(p₂ − p₁), with p₁/(p₂ − p₁) = (p₁/p₂)/growth.
            far: of(z1, &[step.relative(), by_far, by_near])?,
            near: of(z2, &[step.relative(), far.relative() / growth, near.relative() / growth])?,
            size: match focal_length {
                None => None,
                Some(f) => {
                    let size = z1 * (p1 / f.value.px());
                    let of_far = far.relative() / growth;
                    let of_near = near.relative() * (p1 / p2) / growth;
                    Some(of(size, &[step.relative(), f.relative(), of_far, of_near])?)
                }
            },
        };
        Ok(solution)
    }
}

/// A length with its relative σ, where both can be represented.
fn measured(value: f64, relative: f64) -> Result<Measured<Length>, Unsolvable> {
    let sigma = value * relative;
    if value.is_normal() && sigma.is_finite() {
        Ok(Measured::from_base(value, sigma))
    } else {
        Err(Unsolvable::too_extreme(Term::Distance))
    }
}
