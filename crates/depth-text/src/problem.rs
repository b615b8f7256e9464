//! From readings to the mathematics: the only file that fills a [`Problem`] and asks for its [`Solution`].

use crate::entry::Entry;
use crate::field::{Key, Kind};
use crate::fields;
use crate::note::{Fix, Issue, Note};
use crate::reading::{Reading, with_opposite_sign};
use crate::unit::Unit;
use depth_core::camera::field_of_view;
use depth_core::disparity::is_no_match;
use depth_core::in_image::InImage;
use depth_core::judge::{Term, Unsolvable};
use depth_core::measured::Measured;
use depth_core::problem::{Comparison, Field, Method, Outcome, Problem, Refusal, Solution, Solved, better_unit};
use depth_core::quantity::{Length, Pixels};

/// Puts the value of `reading` into `problem`, where it is an input.
pub(crate) fn set(problem: &mut Problem, reading: &Reading) {
    let Some(field) = reading.key.input else { return };
    match (reading.key.kind, reading.unit.map(Unit::base)) {
        (Kind::FocalLength | Kind::Extent, Some(Unit::Length(_))) => {
            problem.set_in_image(field, InImage::OnSensor(Measured::from_base(reading.value, 0.0)));
        }
        (Kind::Extent, Some(Unit::Angle(_))) => problem.set_in_image(field, InImage::Angle(Measured::from_base(reading.value, 0.0))),
        _ => problem.set(field, Some(reading.value)),
    }
}

/// What is to be said about lengths and pixels that do not go together: a focal length in a length belongs to extents that are
/// lengths on the sensor, and the other way round. What is solved for goes with either.
pub(crate) fn mixed_units(readings: &[Reading], unknown: Option<Key>) -> Vec<Note> {
    let of = |key: Key| readings.iter().find(|reading| reading.key == key);
    let is_length = |key: Key| of(key).is_some_and(|reading| reading.unit.is_some_and(Unit::is_length));
    let is_px = |key: Key| of(key).is_some_and(|reading| reading.unit == Some(Unit::Pixel));
    let extents = [fields::DISPARITY, fields::IMAGE_WIDTH];
    let (fx, fy) = (fields::FOCAL_LENGTH, fields::FY);
    let f_is_unknown = unknown == Some(fx);
    let is_angle = |key: Key| of(key).is_some_and(|reading| matches!(reading.unit, Some(Unit::Angle(_))));
    // Beside angles alone a focal length has nothing to go with.
    let is_idle = extents.into_iter().any(is_angle) && !extents.into_iter().any(is_px);
    let any_length = extents
        .into_iter()
        .any(|key| is_length(key) || (unknown == Some(key) && !is_px(key)));
    let goes_with_lengths = any_length && (is_length(fx) || f_is_unknown || (of(fx).is_none() && is_length(fy)));
    let length_for_pixels = |key: Key| {
        let reading = of(key)?;
        let issue = Issue::LengthForPixels {
            key,
            text: reading.text(),
            unit: reading.unit?,
        };
        Some(Note::error(key, issue))
    };
    let with_lengths = [fx, fy].into_iter().chain(extents);
    if goes_with_lengths {
        // An angle goes with everything.
        with_lengths
            .filter(|&key| is_px(key))
            .map(|key| Note::error(key, Issue::PixelsBesideLengths { key }))
            .collect()
    } else {
        let in_use = with_lengths.filter(|key| extents.contains(key) || !is_idle);
        in_use.filter(|&key| is_length(key)).filter_map(length_for_pixels).collect()
    }
}

/// The value of `key` in `problem`, in the base unit, where it is an input and can be used.
pub(crate) fn get(problem: &Problem, key: Key) -> Option<f64> {
    problem.get(key.input?)
}

/// What of the rest of the form decides whether a disparity can be used.
#[derive(Clone, Copy)]
pub(crate) struct Offset {
    /// Something was typed for doffs.
    pub(crate) is_given: bool,
    /// It is what is solved for, so that a disparity may have either sign.
    pub(crate) is_unknown: bool,
}

/// Judges the value of `key`: a refused one is removed from `problem`. Returns what is to be said about it.
pub(crate) fn judge(problem: &mut Problem, key: Key, entry: &Entry, reading: Option<&Reading>, doffs: Offset) -> Option<Note> {
    let field = key.input?;
    let is_free = doffs.is_unknown && field == Field::Disparity && problem.get(field).is_some_and(f64::is_finite);
    match problem.check(field) {
        Err(refusal) if !is_free => {
            problem.set(field, None);
            return Some(refused(key, entry, refusal, reading, doffs));
        }
        _ => {}
    }
    let is_in_px = reading.is_some_and(|reading| reading.unit == Some(Unit::Pixel));
    if field == Field::Disparity && is_in_px && reading.is_some_and(|reading| is_no_match(reading.value)) {
        let text = entry.text.trim().to_owned();
        return Some(Note::warning(key, Issue::NoMatchUsed { text }));
    }
    // What is usual of a length is so for cameras that count pixels.
    let extent = match field {
        Field::Baseline => problem.disparity,
        Field::RealWidth => problem.image_width,
        _ => None,
    };
    let is_of_pixels = extent.is_none_or(|extent| extent.px().is_some());
    (!is_free && is_of_pixels && !problem.is_usual(field)).then(|| unusual(key, field, reading))
}

/// Makes the methods that need an optional field useless where it cannot be read: without it they would be plausible and wrong.
pub(crate) fn spoil(problem: &mut Problem, key: Key) {
    if let Some(field) = key
        .input
        .filter(|field| Method::ALL.iter().any(|method| method.optional_fields().contains(field)))
    {
        problem.set(field, Some(f64::NAN));
    }
}

/// Makes the uncertainty of the methods that need `key` unknown where its σ cannot be read: without it they would seem better
/// known than they are.
pub(crate) fn spoil_sigma(problem: &mut Problem, key: Key) {
    if let Some(field) = key.input {
        problem.set_sigma(field, f64::NAN);
    }
}

/// Sets σ of `key` in `problem`.
pub(crate) fn set_sigma(problem: &mut Problem, key: Key, sigma: Option<f64>) {
    if let Some(field) = key.input {
        problem.set_sigma(field, sigma.unwrap_or(0.0));
    }
}

/// The inputs that make a complete method useless, and why.
pub(crate) fn refusals(solution: &Solution) -> impl Iterator<Item = (Key, Refusal)> {
    Method::ALL.into_iter().filter_map(|method| match solution.outcome(method) {
        Outcome::Refused { field, refusal } => Some((field.into(), refusal)),
        Outcome::Incomplete | Outcome::Distance(_) => None,
    })
}

/// Solves the equation of `method` for `field`. The distance is missed only when nothing else is.
pub(crate) fn solve_for(method: Method, field: Field, problem: &Problem, distance: Option<Measured<Length>>) -> Result<Solved, Issue> {
    if let Some(key) = lacking(method, field, problem) {
        return Err(Issue::MissingForUnknown { key });
    }
    let distance = distance.ok_or(Issue::MissingForUnknown { key: fields::DISTANCE })?;
    match problem.solve_for(method, field, distance) {
        Ok(Some(solved)) => Ok(solved),
        Ok(None) => Err(Issue::NoSolution),
        Err(Unsolvable::NotOneUnknown) => Err(Issue::AngleHasNoFocalLength),
        Err(Unsolvable::Sigma { term }) => Err(Issue::SigmaOutOfProportion {
            key: match term {
                Term::Input(field) => field.into(),
                _ => fields::DISTANCE,
            },
        }),
        Err(Unsolvable::Value {
            refusal: Refusal::BehindZero,
            ..
        }) => Err(Issue::TooNear { key: fields::DISTANCE }),
        Err(Unsolvable::Value {
            refusal: Refusal::OtherUnit,
            ..
        }) => Err(Issue::DoffsInPixels),
        Err(_) => Err(Issue::NoSolution),
    }
}

/// The first input of the equation of `method` that is not known, `field` apart.
fn lacking(method: Method, field: Field, problem: &Problem) -> Option<Key> {
    let extent = match method {
        Method::Stereo => problem.disparity,
        Method::Monocular => problem.image_width,
    };
    let by_angle = matches!(extent, Some(InImage::Angle(_)));
    let is_known = |other: Field| match other {
        Field::FocalLength => by_angle || problem.focal_length_of(method).is_some(),
        _ => problem.get(other).is_some(),
    };
    let needed = method.fields().into_iter();
    needed
        .filter(|&other| other != field)
        .find(|&other| !is_known(other))
        .map(Key::from)
}

/// Takes the solution of the equation of `method` as the value of `field`. What the σ of its terms would give back to the distance
/// is only an echo; the focal length, which the other method needs too, keeps its own.
pub(crate) fn take(problem: &mut Problem, method: Method, field: Field, found: Solved) {
    match found {
        Solved::InImage(InImage::Pixels(_)) | Solved::Length(_) => problem.set(field, Some(found.to_base().value)),
        Solved::InImage(extent) => problem.set_in_image(field, extent),
    }
    for own in method.own_fields().into_iter().chain([method.own_optional_field()]) {
        problem.set_sigma(own, 0.0);
    }
    if field == Field::FocalLength {
        problem.set_sigma(field, found.to_base().sigma);
    }
}

/// What is to be said about the value that was found for `field`.
pub(crate) fn judge_solved(problem: &Problem, field: Field) -> Option<Note> {
    let key = field.into();
    (!problem.is_usual(field)).then(|| Note::warning(key, Issue::Unusual { key }))
}

/// Leaves out of `solution` what would only repeat that the distance of `method` was `given`: its σ, and what follows from that.
/// What was given is compared with the distance by the other method.
pub(crate) fn forget_echo(solution: &mut Solution, method: Method, given: Measured<Length>) {
    let other = match method {
        Method::Stereo => Method::Monocular,
        Method::Monocular => Method::Stereo,
    };
    let computed = solution.outcome(other).distance().map(|distance| {
        let sigma = solution
            .uncertainty(other)
            .map_or(Length::from_m(0.0), |uncertainty| uncertainty.sigma);
        Measured::new(distance, sigma)
    });
    match method {
        Method::Stereo => solution.stereo_uncertainty = None,
        Method::Monocular => solution.monocular_uncertainty = None,
    }
    solution.combined = None;
    solution.comparison = computed.map(|computed| match method {
        Method::Stereo => Comparison::of_independent(given, computed),
        Method::Monocular => Comparison::of_independent(computed, given),
    });
}

/// The note on a value that cannot be used.
pub(crate) fn refused(key: Key, entry: &Entry, refusal: Refusal, reading: Option<&Reading>, doffs: Offset) -> Note {
    let text = entry.text.clone();
    let is_disparity = key == fields::DISPARITY;
    let issue = match refusal {
        Refusal::NotANumber => Issue::NotANumber { key, text },
        Refusal::TurnedAway => Issue::TiltTooLarge,
        Refusal::TooWide => Issue::ExtentTooWide { key },
        Refusal::BehindZero => Issue::BehindZero,
        Refusal::OtherUnit if key == fields::DOFFS => Issue::DoffsInPixels,
        Refusal::OtherUnit => Issue::PixelsBesideLengths { key },
        Refusal::Zero | Refusal::Negative if is_disparity && reading.is_some_and(|reading| is_no_match(reading.value)) => Issue::NoMatch {
            text: text.trim().to_owned(),
        },
        Refusal::Zero | Refusal::Negative if is_disparity && doffs.is_given => Issue::DisparityWithDoffs,
        Refusal::Zero if is_disparity => Issue::ZeroDisparity,
        Refusal::Negative if is_disparity => Issue::NegativeDisparity,
        Refusal::Zero => Issue::Zero { key },
        Refusal::Negative if key == fields::BASELINE => Issue::NegativeBaseline,
        Refusal::Negative => Issue::Negative { key },
        Refusal::TooExtreme => Issue::TooExtreme { key, text },
    };
    let fixes = if matches!(issue, Issue::NegativeDisparity | Issue::NegativeBaseline) {
        reading.map(with_opposite_sign).into_iter().collect()
    } else {
        Vec::new()
    };
    Note::error(key, issue).with_fixes(fixes)
}

fn unusual(key: Key, field: Field, reading: Option<&Reading>) -> Note {
    if matches!(field, Field::FocalLength | Field::Fy)
        && let Some(reading) = reading.filter(|reading| reading.value < LARGEST_MULTIPLE)
    {
        return multiple_of_width(key, reading);
    }
    let slip = reading.filter(|reading| !reading.unit_was_typed).and_then(|reading| {
        let unit = reading.unit?.length()?;
        Some((reading, unit, better_unit(field, reading.number, unit)?))
    });
    let Some((reading, unit, better)) = slip else {
        return Note::warning(key, Issue::Unusual { key });
    };
    let number = reading.number_text.clone();
    let fix = Fix::new(format!("{number} {}", better.symbol()), Entry::new(number.clone(), Some(better)));
    if field == Field::Baseline && may_be_squares(reading.number) {
        let squares = Fix::new("squares of … mm".to_owned(), Entry::new(format!("{number} squares of "), None));
        return Note::warning(key, Issue::UnusualUnitOrSquares { number, unit, better }).with_fixes(vec![fix, squares]);
    }
    Note::warning(key, Issue::UnusualUnit { key, number, unit, better }).with_fixes(vec![fix])
}

/// A focal length below this is no number of pixels but a multiple of the width of the image, or of half of it.
const LARGEST_MULTIPLE: f64 = 10.0;

/// Asks whether a focal length is a multiple of the width of the image or of half of it.
fn multiple_of_width(key: Key, reading: &Reading) -> Note {
    let view = |width: f64| field_of_view(Pixels::new(reading.value), Pixels::new(width / 2.0), Pixels::new(width));
    let (of_width, of_half) = (view(1.0), view(2.0));
    let number = reading.number_text.clone();
    let fixes = [
        ("Multiply by the width…", "multiple-of-width"),
        ("Multiply by half of it…", "multiple-of-half-width"),
    ];
    let fixes = fixes.map(|(label, way)| Fix {
        way: Some(way),
        ..Fix::new(label.to_owned(), Entry::new(number.clone(), None))
    });
    Note::warning(key, Issue::MultipleOfWidth { number, of_width, of_half }).with_fixes(fixes.into())
}

/// Whether a baseline looks like OpenCV's translation in squares of the board: a few, and not a whole number of them.
fn may_be_squares(number: f64) -> bool {
    (0.3..30.0).contains(&number) && number.fract() != 0.0
}
