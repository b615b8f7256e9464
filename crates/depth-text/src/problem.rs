//! From readings to the mathematics: the only file that fills a [`Problem`] and asks for its [`Solution`].

use crate::entry::Entry;
use crate::field::Key;
use crate::fields;
use crate::note::{Fix, Issue, Note};
use crate::reading::Reading;
use depth_core::measured::Measured;
use depth_core::problem::{Field, Method, Outcome, Problem, Refusal, Solution, better_unit};
use depth_core::quantity::Length;
use depth_core::unknown::{MonocularEquation, StereoEquation};

/// Puts the value of `reading` into `problem`, where it is an input.
pub(crate) fn set(problem: &mut Problem, reading: &Reading) {
    if let Some(field) = reading.key.input {
        problem.set(field, Some(reading.value));
    }
}

/// The value of `key` in `problem`, in the base unit, where it is an input and can be used.
pub(crate) fn get(problem: &Problem, key: Key) -> Option<f64> {
    problem.get(key.input?)
}

/// Judges the value of `key`: a refused one is removed from `problem`. Returns what is to be said about it.
pub(crate) fn judge(problem: &mut Problem, key: Key, entry: &Entry, reading: Option<&Reading>, has_doffs: bool) -> Option<Note> {
    let field = key.input?;
    if let Err(refusal) = problem.check(field) {
        problem.set(field, None);
        return Some(refused(key, entry, refusal, has_doffs));
    }
    (!problem.is_usual(field)).then(|| unusual(key, field, reading))
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

/// Solves the equation of `method` for `field`. The distance is asked for only when nothing else is missing.
pub(crate) fn solve_for(
    method: Method,
    field: Field,
    problem: &Problem,
    distance: impl FnOnce() -> Result<Measured<Length>, Issue>,
) -> Result<Measured<f64>, Issue> {
    let needed = method.fields().into_iter();
    if let Some(lacking) = needed.into_iter().find(|&other| other != field && problem.get(other).is_none()) {
        return Err(Issue::MissingForUnknown { key: lacking.into() });
    }
    let distance = distance()?;
    let solved = match method {
        Method::Stereo => StereoEquation {
            focal_length: problem.focal_length.filter(|_| field != Field::FocalLength),
            baseline: problem.baseline.filter(|_| field != Field::Baseline),
            disparity: problem.disparity.filter(|_| field != Field::Disparity),
            doffs: (field != Field::Doffs).then(|| problem.offset()),
            distance: Some(distance),
        }
        .solve(),
        Method::Monocular => MonocularEquation {
            focal_length: problem.focal_length.filter(|_| field != Field::FocalLength),
            real_width: problem.real_width.filter(|_| field != Field::RealWidth),
            image_width: problem.image_width.filter(|_| field != Field::ImageWidth),
            distance: Some(distance),
        }
        .solve(),
    };
    solved.map(|found| found.to_base()).map_err(|_| Issue::NoSolution)
}

/// Takes the solution of an equation as the value of `field`. The uncertainty asked for is that of the unknown; what it
/// would give back to the distance is only an echo.
pub(crate) fn take(problem: &mut Problem, field: Field, found: Measured<f64>) {
    problem.set(field, Some(found.value));
    *problem = problem.without_sigmas();
}

/// The distance and its σ.
pub(crate) fn distance(reading: &Reading) -> Measured<Length> {
    Measured::from_base(reading.value, reading.sigma.unwrap_or(0.0))
}

/// The note on a value that cannot be used. `has_doffs`: something was typed for doffs.
pub(crate) fn refused(key: Key, entry: &Entry, refusal: Refusal, has_doffs: bool) -> Note {
    let text = entry.text.clone();
    let is_disparity = key == fields::DISPARITY;
    let issue = match refusal {
        Refusal::NotANumber => Issue::NotANumber { key, text },
        Refusal::Zero | Refusal::Negative if is_disparity && has_doffs => Issue::DisparityWithDoffs,
        Refusal::Zero if is_disparity => Issue::ZeroDisparity,
        Refusal::Negative if is_disparity => Issue::NegativeDisparity,
        Refusal::Zero => Issue::Zero { key },
        Refusal::Negative => Issue::Negative { key },
        Refusal::TooExtreme => Issue::TooExtreme { key, text },
    };
    let fixes = if issue == Issue::NegativeDisparity {
        let positive = entry.text.trim().trim_start_matches(['-', '−']).to_owned();
        vec![Fix {
            value: positive.clone(),
            entry: Entry::new(positive, entry.unit),
        }]
    } else {
        Vec::new()
    };
    Note::error(key, issue).with_fixes(fixes)
}

fn unusual(key: Key, field: Field, reading: Option<&Reading>) -> Note {
    let slip = reading.and_then(|reading| {
        let unit = reading.unit?.length()?;
        Some((reading, unit, better_unit(field, reading.number, unit)?))
    });
    let Some((reading, unit, better)) = slip else {
        return Note::warning(key, Issue::Unusual { key });
    };
    let number = reading.number_text.clone();
    let fix = Fix {
        value: format!("{number} {}", better.symbol()),
        entry: Entry::new(number.clone(), Some(better)),
    };
    Note::warning(key, Issue::UnusualUnit { key, number, unit, better }).with_fixes(vec![fix])
}
