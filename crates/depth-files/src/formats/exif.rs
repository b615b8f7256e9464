//! EXIF of a photograph: not a calibration, but ways to its focal length, of which the most trusted is the first.

use super::exif_ways::{Change, Way, by_film, by_plane, change, film_ratio, whole, zoom};
use crate::camera::{Basis, Camera};
use crate::checks::camera;
use crate::format::Format;
use crate::found::Found;
use crate::photo::{Facts, Photo};
use crate::photo_warning::PhotoWarning;
use crate::place::Place;
use crate::refusal::Refusal;
use crate::warning::Warning;
use depth_core::camera::{FilmExtent, focused_image_distance};
use depth_core::quantity::{Length, LengthUnit, Pixels};

const FORMAT: Format = Format::Exif;
/// Two ways contradict each other where they differ by more than so many σ.
const SIGMAS: f64 = 3.0;
/// The principal point lies so far from the center, 1 σ as a part of the width.
///
/// Calibrations of phones and cameras have it within a percent or two; image stabilization moves it.
const PRINCIPAL: f64 = 0.01;
/// What is focused so near is said: fx grows by this part.
const NEAR: f64 = 0.005;
/// A shorter equivalent than this may be a fisheye: straight lenses for phones have 13 mm and more, action cameras 12 to 17 mm.
const WIDE_MM: f64 = 18.0;

pub(super) fn read(photo: &Photo) -> Result<Found, Refusal> {
    let mut found = Found::of(FORMAT);
    let refusal = |lens_mm| Refusal::Photo {
        size: photo.size,
        maker: photo.facts.as_ref().and_then(|facts| facts.maker.clone()),
        has_exif: photo.facts.is_some(),
        lens_mm,
    };
    let facts = photo.facts.as_ref().ok_or_else(|| refusal(None))?;
    let plane = by_plane(facts, photo, &mut found.ignored);
    let film = by_film(facts, photo, &mut found.ignored);
    let is_zoom_applied = plane.is_some();
    if let Some(ratio) = film_ratio(&film) {
        let size = whole(change(photo).0, photo.size);
        found.warnings.push(Warning::Photo(PhotoWarning::FilmExtents { size, ratio }));
    }
    let (ways, judgment) = in_order(plane, film, zoom(facts));
    if ways.is_empty() {
        return Err(refusal(facts.lens.and_then(|lens| lens.positive())));
    }
    let mut warnings: Vec<PhotoWarning> = judgment.into_iter().collect();
    warnings.extend(of_picture(photo, facts, is_zoom_applied));
    warnings.extend(of_lens(facts, photo, &ways));
    warnings.push(PhotoWarning::Nominal {
        maker: facts.maker.clone(),
    });
    found.warnings.splice(0..0, warnings.into_iter().map(Warning::Photo));
    for way in &ways {
        let camera = of_way(way, photo, facts)?;
        let name = camera.name.clone();
        found.warnings.push(Warning::NoPrincipalPoint { camera: name });
        found.add(camera)?;
    }
    found.warnings.push(Warning::NoBaseline { format: FORMAT });
    Ok(found)
}

/// The ways, the one that is trusted most first, and what is to be said of that.
///
/// That by the sensor depends on no convention, but is of another size where somebody scaled the photo and left the tag as it was, and some
/// cameras write it wrong. So an equivalent on film, which holds whatever the size, wins where neither is within their errors of it.
fn in_order(plane: Option<Way>, film: Vec<Way>, zoom: Option<f64>) -> (Vec<Way>, Option<PhotoWarning>) {
    let Some(plane) = plane else { return (film, None) };
    let Some(trusted) = film.first() else {
        let alone = plane.sensor.map(|sensor| PhotoWarning::PlaneAlone { sensor });
        return (vec![plane], alone);
    };
    let fx = |way: &Way| way.focal[0].px();
    let agrees_times = |way: &Way, times: f64| {
        let errors = [way.relative * fx(way) * times, plane.relative * fx(&plane)];
        (fx(way) * times - fx(&plane)).abs() <= SIGMAS * errors[0].hypot(errors[1])
    };
    let agrees = |way: &Way| agrees_times(way, 1.0);
    let apart = |way: &&Way| (fx(way) - fx(&plane)).abs();
    let nearest = film
        .iter()
        .filter(|way| agrees(way))
        .min_by(|one, other| apart(one).total_cmp(&apart(other)));
    if let Some(other) = nearest.map(|way| way.name.clone()) {
        let trusted = plane.name.clone();
        let ways = std::iter::once(plane).chain(film).collect();
        return (ways, Some(PhotoWarning::Agreement { trusted, other }));
    }
    let said = |way: &Way| (way.name.clone(), way.focal[0]);
    let warning = PhotoWarning::Contradiction {
        trusted: said(trusted),
        other: said(&plane),
        zoom: zoom.filter(|zoom| film.iter().any(|way| agrees_times(way, *zoom))),
    };
    (film.into_iter().chain([plane]).collect(), Some(warning))
}

/// A viewer shows the picture with its width for its height.
fn is_turned(facts: &Facts) -> Option<f64> {
    facts.orientation.filter(|one| [5.0, 6.0, 7.0, 8.0].contains(one))
}

/// What was done with the picture.
fn of_picture(photo: &Photo, facts: &Facts, is_applied: bool) -> Vec<PhotoWarning> {
    let now = photo.size;
    let changed = match change(photo).0 {
        Change::Same => None,
        Change::Resized(taken) => Some(PhotoWarning::Resized { taken, now }),
        Change::Cropped(taken) => Some(PhotoWarning::Cropped { taken, now }),
    };
    let zoomed = zoom(facts).map(|ratio| PhotoWarning::DigitalZoom { ratio, is_applied });
    let turned = is_turned(facts).map(|orientation| PhotoWarning::Turned {
        orientation,
        size: [now[1], now[0]],
    });
    [changed, zoomed, turned].into_iter().flatten().collect()
}

/// What is to be said of the lens.
fn of_lens(facts: &Facts, photo: &Photo, ways: &[Way]) -> Vec<PhotoWarning> {
    let millimeters = |value| Length::new(value, LengthUnit::Millimeter);
    let near = || {
        let lens = millimeters(facts.lens?.positive()?);
        let distance = Length::from_m(facts.distance_m?);
        let ratio = focused_image_distance(lens, distance)?.m() / lens.m();
        (ratio > 1.0 + NEAR && ratio < 2.0).then_some(PhotoWarning::Near { distance, ratio })
    };
    let wide = || {
        let size = whole(change(photo).0, photo.size).map(|side| Pixels::new(f64::from(side)));
        let by_fx = || FilmExtent::Diagonal.equivalent(ways.first()?.focal[0], size);
        let equivalent = facts.film.map(millimeters).or_else(by_fx)?;
        (equivalent.in_unit(LengthUnit::Millimeter) < WIDE_MM).then_some(PhotoWarning::Wide { equivalent })
    };
    [near(), wide()].into_iter().flatten().collect()
}

/// So many columns and rows were cut off, of the picture as people see it: nobody knows on which side.
fn cropped_off(photo: &Photo, facts: &Facts) -> [f64; 2] {
    let Change::Cropped([width, height]) = change(photo).0 else {
        return [0.0; 2];
    };
    let [now_width, now_height] = photo.size;
    let [columns, rows] = [width.saturating_sub(now_width), height.saturating_sub(now_height)].map(f64::from);
    if is_turned(facts).is_some() {
        [rows, columns]
    } else {
        [columns, rows]
    }
}

/// A way as a camera, of the picture as people see it.
fn of_way(way: &Way, photo: &Photo, facts: &Facts) -> Result<Camera, Refusal> {
    let ([mut fx, mut fy], [mut width, mut height]) = (way.focal.map(Pixels::px), photo.size);
    if is_turned(facts).is_some() {
        (fx, fy) = (fy, fx);
        (width, height) = (height, width);
    }
    let [cx, cy] = [width, height].map(|side| f64::from(side) / 2.0);
    let place = Place { file: photo.file, line: 0 };
    let at_center = PRINCIPAL * f64::from(width.max(height));
    let [across, down] = cropped_off(photo, facts).map(|off| at_center.hypot(off / 12_f64.sqrt()));
    let sigma = [way.relative * fx, way.relative * fy, across, down];
    let size = Some([width, height]);
    let camera = camera(
        FORMAT,
        &way.name,
        [fx, fy, cx, cy],
        (size, Basis::Raw, place.origin(way.how.clone())),
    )?;
    Ok(Camera {
        sigma: Some(sigma.map(Pixels::new)),
        ..camera
    })
}
