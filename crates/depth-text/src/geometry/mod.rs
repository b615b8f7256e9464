//! The point in space that a pixel shows, and the ways to a distance of their own: the ground plane, two photographs, two points.

mod camera;
mod two;

pub use two::{TwoShots, missing_for};

use camera::{Camera, LARGEST_SIGMA, refused};

use crate::field::Key;
use crate::fields::{
    CAMERA_HEIGHT, CAMERA_PITCH, CX, CY, FLOOR_ANGLE, FLOOR_COLUMN, FLOOR_ROW, FOCAL_LENGTH, FY, PIXEL_COLUMN, PIXEL_ROW, TAPED_RANGE,
    TARGET_HEIGHT,
};
use crate::note::{Issue, Note};
use crate::reading::{Reading, with_opposite_sign};
use depth_core::agreement::Comparison;
use depth_core::angle::Angle;
use depth_core::camera::{Along, BelowAxis, GroundSolution, GroundView, PointSolution, PointView, RightOfAxis};
use depth_core::judge::{Term, Unsolvable};
use depth_core::measured::Measured;
use depth_core::problem::{Method, Origin, Solution};
use depth_core::quantity::Length;
use depth_core::setup::Object;
use depth_core::two_points::TwoPointsSolution;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6};

/// The point in space and the ground plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Geometry {
    /// The point in space, and where its distance is from; `None` while something is missing.
    pub point: Option<(PointOrigin, PointSolution)>,
    /// The point on the floor; `None` while something is missing.
    pub ground: Option<GroundSolution>,
    /// What the monocular distance would be without the tilt; `None` where there is neither.
    pub facing: Option<Length>,
    /// What two photographs say; `None` while something is missing.
    pub two_shots: Option<TwoShots>,
    /// What two points say; `None` while something is missing.
    pub two_points: Option<TwoPointsSolution>,
}

/// Where the distance of a point is from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointOrigin {
    /// It was computed.
    Distance(Origin),
    /// It was given, in place of the distance of this method.
    Given(Method),
    /// The range was measured.
    Range,
}

impl Geometry {
    /// What follows from `readings` and `solution`, and what is to be said about it. `given`: the distance that was given, by which
    /// something else was solved for.
    pub(crate) fn new(readings: &[&Reading], solution: &Solution, given: Option<(Method, Measured<Length>)>) -> (Self, Vec<Note>) {
        let camera = Camera { readings, solution, given };
        let mut notes = Vec::new();
        let ground = ground(&camera).map_err(|note| notes.push(note)).ok().flatten();
        let point = point(&camera).map_err(|note| notes.push(note)).ok().flatten();
        notes.extend(point.and_then(|(origin, point)| contradiction(&camera, origin, &point)));
        notes.extend(ground.and_then(|ground| vague_ground(&camera, &ground)));
        notes.extend(point.and_then(|(_, point)| vague_range(&camera, point.z)));
        let has_distance = solution.monocular.distance().is_some();
        let facing = solution.problem.distance_if_facing().filter(|_| has_distance);
        let two_shots = two::shots(&camera).map_err(|note| notes.push(note)).ok().flatten();
        let two_points = two::points(&camera).map_err(|note| notes.push(note)).ok().flatten();
        notes.extend(two::vague(two_shots.as_ref(), two_points.as_ref()));
        notes.extend(point.and_then(|(_, point)| ball_off_axis(solution, &point)));
        let geometry = Self {
            point,
            ground,
            facing,
            two_shots,
            two_points,
        };
        (geometry, notes)
    }
}

/// How far beyond straight up or down a camera may be turned, rad: a gimbal that swings through. Farther is no pitch.
const LARGEST_TURN: f64 = FRAC_PI_6;

fn point(camera: &Camera<'_>) -> Result<Option<(PointOrigin, PointSolution)>, Note> {
    let Some((origin, view)) = point_view(camera) else {
        return Ok(None);
    };
    view.solve()
        .map(|point| Some((origin, point)))
        .map_err(|error| point_note(camera, origin, error))
}

fn point_view(camera: &Camera<'_>) -> Option<(PointOrigin, PointView)> {
    let best = camera.solution.best();
    // A taped distance counts from where all others do.
    let shift = best.map_or_else(|| camera.solution.problem.shift(), |best| best.shift);
    let (origin, along) = match (camera.measured(TAPED_RANGE), camera.given) {
        (Some(range), _) => (PointOrigin::Range, Along::Ray(range)),
        (None, Some((method, distance))) => (PointOrigin::Given(method), Along::GivenDepth(distance)),
        (None, None) => {
            let best = best?;
            // That of an angle does not grow with the focal length.
            let along = if best.has_focal_length { Along::Axis } else { Along::GivenDepth };
            (PointOrigin::Distance(best.origin), along(best.distance))
        }
    };
    let view = PointView {
        fx: camera.fx()?,
        fy: camera.fy()?,
        cx: camera.pixels(CX)?,
        cy: camera.pixels(CY)?,
        column: camera.pixels(PIXEL_COLUMN)?,
        row: camera.pixels(PIXEL_ROW)?,
        along,
        shift,
    };
    Some((origin, view))
}

/// Why there is no point.
fn point_note(camera: &Camera<'_>, origin: PointOrigin, error: Unsolvable) -> Note {
    if let Unsolvable::Sigma { term } = error {
        let key = if term == Term::Distance { TAPED_RANGE } else { FOCAL_LENGTH };
        return Note::of_sigma(key, Issue::SigmaOutOfProportion { key });
    }
    let problem = &camera.solution.problem;
    if error.term() == Some(Term::Distance) && origin == PointOrigin::Range && (problem.zero.is_some() || problem.lens.is_some()) {
        return Note::error(TAPED_RANGE, Issue::TooNear { key: TAPED_RANGE });
    }
    let key = match error.term() {
        Some(Term::PrincipalPoint) => CX,
        Some(Term::Column) => PIXEL_COLUMN,
        Some(Term::Row) => PIXEL_ROW,
        Some(Term::Input(_)) if camera.reading(FY).is_some() => FY,
        Some(Term::Distance) if origin == PointOrigin::Range => TAPED_RANGE,
        _ => FOCAL_LENGTH,
    };
    refused(camera, key, error)
}

/// A warning where a ball is so far from the middle of the image that its outline is no circle to speak of.
fn ball_off_axis(solution: &Solution, point: &PointSolution) -> Option<Note> {
    let is_ball = solution.problem.object == Object::Ball && solution.monocular.distance().is_some();
    let aside = point.x.value.m().hypot(point.y.value.m());
    (is_ball && aside > LARGEST_SLOPE * point.z.value.m()).then(|| Note::warning(PIXEL_COLUMN, Issue::BallOffAxis))
}

/// The slope of the ray to a ball from which on its outline is wider by 1 %: at an angle θ from the axis it is by about 1/cos θ − 1.
const LARGEST_SLOPE: f64 = 0.1;

/// A warning where the σ of the depth of a range is so large that it says little, at the field that has most of it.
fn vague_range(camera: &Camera<'_>, depth: Measured<Length>) -> Option<Note> {
    let range = camera.measured::<Length>(TAPED_RANGE)?;
    let is_of_range = range.relative() >= depth.relative() / 2.0_f64.sqrt();
    let key = if is_of_range { TAPED_RANGE } else { FOCAL_LENGTH };
    (depth.relative() > LARGEST_SIGMA).then(|| Note::warning(key, Issue::Vague { of: "depth" }))
}

/// A warning where the σ of a ground distance is so large that first order describes it poorly, at the field that has most of it.
fn vague_ground(camera: &Camera<'_>, ground: &GroundSolution) -> Option<Note> {
    let is_vague = ground.distance.sigma.m() > LARGEST_SIGMA * ground.slant.value.m();
    let cause = ground.main_cause.filter(|_| is_vague)?;
    Some(Note::warning(key_of(camera, cause), Issue::Vague { of: "ground distance" }))
}

/// The field that a term of the ground plane is typed into.
fn key_of(camera: &Camera<'_>, term: Term) -> Key {
    match term {
        Term::Pitch => CAMERA_PITCH,
        Term::TargetHeight => TARGET_HEIGHT,
        Term::Row => FLOOR_ROW,
        Term::Column => FLOOR_COLUMN,
        Term::BelowAxis => FLOOR_ANGLE,
        Term::PrincipalPoint => CX,
        Term::Input(_) if camera.fx().is_none() => FY,
        Term::Input(_) => FOCAL_LENGTH,
        Term::FarWidth | Term::NearWidth | Term::Step | Term::CameraHeight | Term::Distance => CAMERA_HEIGHT,
    }
}

/// A warning where a range by tape and the distance that was computed cannot both be right.
fn contradiction(camera: &Camera<'_>, origin: PointOrigin, point: &PointSolution) -> Option<Note> {
    let range = camera.measured::<Length>(TAPED_RANGE).filter(|_| origin == PointOrigin::Range)?;
    // Of the relative σ of the focal length the depth of a range has 1 − Z²/R². A computed distance, which grows with it, has all of
    // it, so that Z²/R² is left between the two; one that was given has none.
    let slope = (point.z.value.m() / range.value.m()).min(1.0);
    let (other, of_focal_length) = match camera.given {
        Some((_, given)) => (given, 1.0 - slope * slope),
        None => (camera.solution.best()?.distance, slope * slope),
    };
    let of_focal_length = of_focal_length * camera.fx().map_or(0.0, Measured::relative);
    let with = |value: Length, relative: f64| Measured::new(value, Length::from_m(value.m() * relative));
    let other = with(other.value, other.relative().hypot(of_focal_length));
    let comparison = Comparison::of_independent(with(point.z.value, range.relative()), other);
    let times = comparison.ratio?;
    let is_given = camera.given.is_some();
    comparison
        .contradict()
        .then(|| Note::warning(TAPED_RANGE, Issue::RangeContradicts { times, is_given }))
}

fn ground(camera: &Camera<'_>) -> Result<Option<GroundSolution>, Note> {
    if camera.reading(FLOOR_ROW).is_some() && camera.reading(FLOOR_ANGLE).is_some() {
        return Err(Note::error(FLOOR_ANGLE, Issue::RowAndAngle));
    }
    if camera
        .reading(CAMERA_PITCH)
        .is_some_and(|pitch| pitch.value.abs() > FRAC_PI_2 + LARGEST_TURN)
    {
        return Err(Note::error(CAMERA_PITCH, Issue::PitchTooLarge));
    }
    let Some(view) = ground_view(camera) else { return Ok(None) };
    view.solve().map(Some).map_err(|error| ground_note(camera, error))
}

fn ground_view(camera: &Camera<'_>) -> Option<GroundView> {
    let below_axis = match camera.measured::<Angle>(FLOOR_ANGLE) {
        Some(angle) => BelowAxis::Angle(angle),
        None => BelowAxis::Row {
            row: camera.measured(FLOOR_ROW)?,
            cy: camera.pixels(CY)?,
            fy: camera.fy_with_sigma()?,
        },
    };
    let right_of_axis = match camera.pixels(FLOOR_COLUMN) {
        Some(column) => Some(RightOfAxis {
            column,
            cx: camera.pixels(CX)?,
            fx: camera.fx()?,
        }),
        None => None,
    };
    Some(GroundView {
        height: camera.measured(CAMERA_HEIGHT)?,
        target_height: Length::from_m(camera.reading(TARGET_HEIGHT).map_or(0.0, |reading| reading.value)),
        pitch: camera.measured(CAMERA_PITCH)?,
        below_axis,
        right_of_axis,
    })
}

fn ground_note(camera: &Camera<'_>, error: Unsolvable) -> Note {
    if let Unsolvable::Sigma { term } = error {
        let key = key_of(camera, term);
        return Note::of_sigma(key, Issue::SigmaOutOfProportion { key });
    }
    if let Unsolvable::MissesPlane {
        meets_with_opposite_pitch: true,
        ..
    } = error
        && let Some(pitch) = camera.reading(CAMERA_PITCH)
    {
        let height = |key| camera.reading(key).map_or(0.0, |reading| reading.value);
        let issue = if height(TARGET_HEIGHT) > height(CAMERA_HEIGHT) {
            Issue::LooksDownAtHigherTarget
        } else {
            Issue::PitchCountsDownwards
        };
        return Note::error(CAMERA_PITCH, issue).with_fixes(vec![with_opposite_sign(pitch)]);
    }
    let place = if camera.reading(FLOOR_ANGLE).is_some() {
        FLOOR_ANGLE
    } else {
        FLOOR_ROW
    };
    let (key, issue) = match error {
        Unsolvable::MissesPlane { .. } => (place, Issue::MissesPlane),
        Unsolvable::Value {
            term: Term::TargetHeight, ..
        } => (TARGET_HEIGHT, Issue::TargetAtCameraHeight),
        Unsolvable::Value { term: Term::BelowAxis, .. } => (FLOOR_ANGLE, Issue::AngleTooLarge),
        Unsolvable::Value { term: Term::Distance, .. } => (CAMERA_HEIGHT, Issue::GroundTooExtreme),
        Unsolvable::Value { term: Term::Input(_), .. } => {
            let key = if camera.reading(FY).is_some() { FY } else { FOCAL_LENGTH };
            return refused(camera, key, error);
        }
        _ => return refused(camera, CAMERA_HEIGHT, error),
    };
    Note::error(key, issue)
}

/// The fields that the ground plane needs and that are not there, in reading order; none where nothing of it was typed.
pub fn missing_for_ground(is_blank: impl Fn(Key) -> bool) -> Vec<Key> {
    let by_angle = !is_blank(FLOOR_ANGLE);
    let mut needed = vec![CAMERA_HEIGHT, CAMERA_PITCH];
    if !by_angle {
        needed.extend([FLOOR_ROW, CY]);
    }
    if !is_blank(FLOOR_COLUMN) {
        needed.push(CX);
    }
    if (!by_angle && is_blank(FY)) || !is_blank(FLOOR_COLUMN) {
        needed.push(FOCAL_LENGTH);
    }
    needed.retain(|&key| is_blank(key));
    needed.sort();
    needed
}
