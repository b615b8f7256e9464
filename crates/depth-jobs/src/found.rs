//! What was found in files, as it travels.

use crate::calibration::{Baseline, Calibration, Camera, Choice, Guess};
use depth_files::{Basis, Format, Found, Origin, Warning};

/// What `found` says, of files with these names.
pub(crate) fn calibration(found: &Found, names: &[&str]) -> Calibration {
    let pairs = found.pair.into_iter().chain(found.pairs.iter().map(|pair| pair.cameras));
    let mut sets: Vec<Vec<usize>> = Vec::new();
    for set in pairs.map(Vec::from).chain((0..found.cameras.len()).map(|at| vec![at])) {
        let is_new = |other: &Vec<usize>| other.len() != set.len() || set.iter().any(|at| !other.contains(at));
        if sets.iter().all(is_new) {
            sets.push(set);
        }
    }
    let choices = sets.iter().filter_map(|set| {
        let cameras: Vec<&str> = set.iter().filter_map(|at| Some(found.cameras.get(*at)?.name.as_str())).collect();
        // Those of a photograph are ways to the focal length of one camera.
        let is_of_many = found.cameras.len() > 1 && found.format != Format::Exif;
        let name = if set.len() == 1 && is_of_many {
            format!("{} alone", cameras.concat())
        } else {
            cameras.join(" and ")
        };
        choice(&found.choose(set)?, name, names)
    });
    Calibration {
        format: found.format.title().to_owned(),
        choices: choices.collect(),
        ignored: found.ignored.clone(),
    }
}

/// What is left of a file where one camera or pair of it was chosen.
fn choice(found: &Found, name: String, names: &[&str]) -> Option<Choice> {
    let told = |origin: &Origin| {
        let parts = [origin.how.clone(), origin.place().words(names)];
        parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ")
    };
    let origin = |origin: &Option<Origin>| origin.as_ref().map_or_else(String::new, told);
    let camera = found.cameras.get(found.pair.map_or(0, |[first, _]| first))?;
    // The unit is asked for where it is needed; and who chooses knows that there are several.
    let is_said = |warning: &&Warning| !matches!(warning, Warning::UnitUnknown { .. } | Warning::Many { .. });
    Some(Choice {
        name,
        camera: Camera {
            name: camera.name.clone(),
            size: camera.size,
            intrinsics_px: [camera.fx, camera.fy, camera.cx, camera.cy].map(|one| one.px()),
            sigma_px: camera.sigma.map(|sigma| sigma.map(|one| one.px())),
            is_rectified: camera.basis == Basis::Rectified,
            model: camera.model.clone(),
            distortion: camera.distortion.clone(),
            origin: told(&camera.origin),
        },
        is_vertical: found.is_vertical,
        baseline: found.baseline.map(baseline),
        baseline_origin: origin(&found.baseline_origin),
        doffs_px: found.doffs.map(|doffs| doffs.px()),
        doffs_origin: origin(&found.doffs_origin),
        warnings: found
            .warnings
            .iter()
            .filter(is_said)
            .map(|warning| warning.sentence(names))
            .collect(),
    })
}

const fn baseline(baseline: depth_files::Baseline) -> Baseline {
    match baseline {
        depth_files::Baseline::Known(length) => Baseline::Meters(length.m()),
        depth_files::Baseline::InFileUnits { value, guess } => Baseline::InFileUnits {
            value,
            guess: match guess {
                depth_files::Guess::Unit(unit) => Guess::Unit(unit),
                depth_files::Guess::Squares { size } => Guess::Squares { size },
            },
        },
    }
}
