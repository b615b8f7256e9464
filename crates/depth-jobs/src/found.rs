//! What was found in files, as it travels.

use crate::calibration::{Baseline, Calibration, Camera, Guess};
use depth_files::{Basis, Found, Origin, Warning};

/// What `found` says, of files with these names.
pub(crate) fn calibration(found: &Found, names: &[&str]) -> Calibration {
    let told = |origin: &Origin| [origin.how.clone(), origin.place().words(names)].join(", ");
    let origin = |origin: &Option<Origin>| origin.as_ref().map_or_else(String::new, told);
    let camera = |camera: &depth_files::Camera| Camera {
        name: camera.name.clone(),
        size: camera.size,
        intrinsics_px: [camera.fx, camera.fy, camera.cx, camera.cy].map(|one| one.px()),
        sigma_px: camera.sigma.map(|sigma| sigma.map(|one| one.px())),
        is_rectified: camera.basis == Basis::Rectified,
        model: camera.model.clone(),
        distortion: camera.distortion.clone(),
        origin: told(&camera.origin),
    };
    // The unit is asked for where it is needed.
    let warnings = found
        .warnings
        .iter()
        .filter(|warning| !matches!(warning, Warning::UnitUnknown { .. }));
    Calibration {
        format: found.format.title().to_owned(),
        cameras: found.cameras.iter().map(camera).collect(),
        pair: found.pair,
        is_vertical: found.is_vertical,
        baseline: found.baseline.map(baseline),
        baseline_origin: origin(&found.baseline_origin),
        doffs_px: found.doffs.map(|doffs| doffs.px()),
        doffs_origin: origin(&found.doffs_origin),
        warnings: warnings.map(ToString::to_string).collect(),
        ignored: found.ignored.clone(),
    }
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
