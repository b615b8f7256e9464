//! What holds of every answer, whatever the bytes were.

use depth_files::{Found, Refusal};

/// Err: what does not hold.
pub fn judge(answer: &Result<Found, Refusal>) -> Result<(), String> {
    match answer {
        Ok(found) => {
            of_found(found)?;
            for pair in &found.pairs {
                of_found(&found.choose(&pair.cameras).ok_or("a pair cannot be chosen")?)?;
            }
            for at in 0..found.cameras.len().min(8) {
                of_found(&found.choose(&[at]).ok_or("a camera cannot be chosen")?)?;
            }
            Ok(())
        }
        Err(refusal) => is_sentence(&refusal.to_string()),
    }
}

fn of_found(found: &Found) -> Result<(), String> {
    let holds = |holds: bool, what: &str| if holds { Ok(()) } else { Err(format!("{what}: {found:?}")) };
    holds(!found.cameras.is_empty(), "nothing is found")?;
    for camera in &found.cameras {
        let all = [camera.fx, camera.fy, camera.cx, camera.cy].map(|one| one.px());
        holds(all.iter().all(|one| one.is_finite()), "a number is none")?;
        holds(camera.fx.px() > 0.0 && camera.fy.px() > 0.0, "a focal length is none")?;
        holds(camera.distortion.iter().all(|one| one.is_finite()), "a coefficient is none")?;
        holds(!camera.origin.how.is_empty(), "a camera comes from nowhere")?;
        holds(camera.size.is_none_or(|size| !size.contains(&0)), "a size is none")?;
    }
    let length = found.baseline.and_then(|one| one.length(None)).map_or(1.0, |one| one.m());
    holds(length.is_finite() && length > 0.0, "a baseline is none")?;
    holds(
        found.baseline.is_some() == found.baseline_origin.is_some(),
        "a baseline comes from nowhere",
    )?;
    holds(found.doffs.is_some() == found.doffs_origin.is_some(), "doffs comes from nowhere")?;
    holds(found.doffs.is_none_or(|doffs| doffs.px().is_finite()), "doffs is none")?;
    let places = found.pair.into_iter().chain(found.pairs.iter().map(|pair| pair.cameras));
    let are_there = |[one, other]: [usize; 2]| one != other && one.max(other) < found.cameras.len();
    holds(places.into_iter().all(are_there), "a pair is not there")?;
    found.warnings.iter().try_for_each(|warning| is_sentence(&warning.to_string()))
}

fn is_sentence(text: &str) -> Result<(), String> {
    if text.ends_with(['.', '?']) && !text.contains('\n') {
        Ok(())
    } else {
        Err(format!("not a sentence: {text}"))
    }
}
