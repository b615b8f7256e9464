//! Two photographs and the step between them, and the length between two points.

use super::camera::{Camera, LARGEST_SIGMA, refused};
use crate::field::{Key, Section};
use crate::fields::{
    BASELINE, CX, CY, DISPARITY, DOFFS, FAR_WIDTH, FOCAL_LENGTH, FROM_COLUMN, FROM_DISPARITY, FROM_ROW, FY, NEAR_WIDTH, STEP, TO_COLUMN,
    TO_DISPARITY, TO_ROW, ZERO,
};
use crate::form::Inputs;
use crate::note::{Issue, Note};
use depth_core::in_image::InImage;
use depth_core::judge::{Refusal, Term, Unsolvable};
use depth_core::measured::Measured;
use depth_core::problem::Method;
use depth_core::quantity::{Length, Pixels};
use depth_core::two_points::{StereoPoint, TwoPoints, TwoPointsSolution};
use depth_core::two_shots::{TwoShots as Shots, TwoShotsSolution};

/// What two photographs say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoShots {
    /// The distances, counted from where all are, and the width.
    pub solution: TwoShotsSolution,
    /// Whether its σ is that of one pixel in each width, as none was typed: there is always one to be seen.
    pub is_one_pixel_each: bool,
    /// The focal length of the lens in the distances, where it is more than 1 % of the nearer one.
    pub added_lens: Option<Length>,
}

pub(super) fn shots(camera: &Camera<'_>) -> Result<Option<TwoShots>, Note> {
    let widths = (
        camera.measured::<Pixels>(FAR_WIDTH),
        camera.measured::<Pixels>(NEAR_WIDTH),
        camera.measured(STEP),
    );
    let (Some(mut far_width), Some(mut near_width), Some(step)) = widths else {
        return Ok(None);
    };
    let was_typed = |key| camera.reading(key).is_some_and(|reading| reading.sigma_was_typed);
    let is_one_pixel_each = match (was_typed(FAR_WIDTH), was_typed(NEAR_WIDTH)) {
        (true, true) => false,
        // Both are measured in the same way.
        (true, false) => {
            near_width.sigma = far_width.sigma;
            false
        }
        (false, true) => {
            far_width.sigma = near_width.sigma;
            false
        }
        (false, false) => {
            far_width.sigma = Pixels::new(1.0);
            near_width.sigma = Pixels::new(1.0);
            true
        }
    };
    let shots = Shots {
        far_width,
        near_width,
        step,
        focal_length: camera.fx(),
    };
    let solution = shots.solve().map_err(|error| shots_note(camera, error))?;
    // A focused lens shows widths as if it were its own focal length nearer.
    let shift = camera.solution.problem.shift().m();
    let counted = |distance: Measured<Length>| Measured::new(Length::from_m(distance.value.m() + shift), distance.sigma);
    let (far, near) = (counted(solution.far), counted(solution.near));
    if near.value.m() <= 0.0 {
        return Err(Note::error(ZERO, Issue::BehindZero));
    }
    Ok(Some(TwoShots {
        solution: TwoShotsSolution { far, near, ..solution },
        is_one_pixel_each,
        added_lens: camera.solution.notable_lens(near.value),
    }))
}

fn shots_note(camera: &Camera<'_>, error: Unsolvable) -> Note {
    let key = match error.term() {
        Some(Term::FarWidth) => FAR_WIDTH,
        Some(Term::Input(_)) => FOCAL_LENGTH,
        Some(Term::NearWidth) => NEAR_WIDTH,
        _ => STEP,
    };
    let is_positive = camera.reading(key).is_some_and(|reading| reading.value > 0.0);
    match error {
        Unsolvable::Sigma { .. } => Note::of_sigma(key, Issue::SigmaOutOfProportion { key }),
        Unsolvable::Value {
            term: Term::NearWidth,
            refusal: Refusal::Negative | Refusal::Zero,
        } if is_positive => Note::error(key, Issue::NotNearer),
        _ => refused(camera, key, error),
    }
}

pub(super) fn points(camera: &Camera<'_>) -> Result<Option<TwoPointsSolution>, Note> {
    let Some(view) = two_points(camera) else { return Ok(None) };
    view.solve().map(Some).map_err(|error| points_note(camera, &view, error))
}

fn two_points(camera: &Camera<'_>) -> Option<TwoPoints> {
    let point = |column, row, disparity| {
        Some(StereoPoint {
            column: camera.pixels(column)?,
            row: camera.pixels(row)?,
            disparity: camera.measured(disparity)?,
        })
    };
    let problem = &camera.solution.problem;
    let is_vertical = problem.needs_fy(Method::Stereo);
    let fx = camera.fx().or_else(|| camera.fy_with_sigma())?;
    // The depths have the σ of the focal length that the disparity goes with.
    let relative = problem.focal_length_of(Method::Stereo).map_or(0.0, InImage::relative);
    Some(TwoPoints {
        fx: Measured::from_base(fx.value.px(), fx.value.px() * relative),
        fy: camera.fy()?,
        is_vertical,
        baseline: problem.baseline?,
        doffs: problem.offset(),
        cx: camera.pixels(CX)?,
        cy: camera.pixels(CY)?,
        from: point(FROM_COLUMN, FROM_ROW, FROM_DISPARITY)?,
        to: point(TO_COLUMN, TO_ROW, TO_DISPARITY)?,
    })
}

fn points_note(camera: &Camera<'_>, view: &TwoPoints, error: Unsolvable) -> Note {
    let doffs = view.doffs.value.px();
    let is_first = view.from.disparity.value.px() + doffs <= 0.0 || view.to.disparity.value.px() + doffs > 0.0;
    let of_points = |first: Key, second: Key| if is_first { first } else { second };
    let key = match error.term() {
        Some(Term::Input(field)) if Key::from(field) == BASELINE => BASELINE,
        Some(Term::Input(field)) if Key::from(field) == DOFFS => DOFFS,
        Some(Term::Input(field)) if Key::from(field) == DISPARITY => of_points(FROM_DISPARITY, TO_DISPARITY),
        Some(Term::PrincipalPoint) => CX,
        Some(Term::Column) => FROM_COLUMN,
        Some(Term::Row) => FROM_ROW,
        Some(Term::Input(_)) if camera.reading(FY).is_some() => FY,
        Some(Term::Distance) => FROM_DISPARITY,
        _ => FOCAL_LENGTH,
    };
    match error {
        Unsolvable::Sigma { .. } => Note::of_sigma(key, Issue::SigmaOutOfProportion { key }),
        _ => refused(camera, key, error),
    }
}

/// A warning where the σ of what two photographs or two points say is so large that it says little.
pub(super) fn vague(shots: Option<&TwoShots>, points: Option<&TwoPointsSolution>) -> impl Iterator<Item = Note> {
    let is_vague = |length: Measured<Length>| length.relative() > LARGEST_SIGMA;
    let shots = shots.filter(|shots| is_vague(shots.solution.far));
    let points = points.filter(|points| is_vague(points.distance));
    let of_shots = shots.map(|_| Note::warning(NEAR_WIDTH, Issue::Vague { of: "distances" }));
    let of_points = points.map(|_| Note::warning(FROM_DISPARITY, Issue::Vague { of: "length" }));
    of_shots.into_iter().chain(of_points)
}

/// The fields that a way of its own to a distance still needs, in reading order; none where nothing of it was typed.
pub fn missing_for(section: Section, inputs: &Inputs) -> Vec<Key> {
    let is_begun = section.keys().any(|key| !inputs.entry(key).is_blank());
    let with = match section {
        Section::TwoPoints => &[FOCAL_LENGTH, BASELINE, CX, CY][..],
        _ => &[],
    };
    let needed = with.iter().copied().chain(section.keys());
    let mut missing: Vec<Key> = needed.filter(|&key| is_begun && inputs.entry(key).is_blank()).collect();
    missing.sort();
    missing
}
