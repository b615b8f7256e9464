//! The ways from EXIF to a focal length in pixels, each with its error.
//!
//! Sources: CIPA DC-008-2023 (Exif 3.0), 4.6.6; CIPA DCG-001 for what is equivalent on 35 mm film; ExifTool’s documentation, “EXIF Tags”, for
//! the values that cameras write beside the standard.

use crate::number::brief;
use crate::photo::{Facts, Photo};
use crate::tiff::Rational;
use depth_core::camera::{FilmExtent, focal_length_from_pixel_pitch, resized_focal_length};
use depth_core::quantity::{Length, LengthUnit, Pixels};

/// What is nominal is so far from what is true, 1 σ as a part of it: the focal length of this very lens from that of its data sheet, and the
/// size of a pixel from what the camera writes.
///
/// Source: none that holds for all; a Canon EOS 5D Mark II writes a FocalPlaneXResolution that is 2.4 % off (photo.stackexchange.com,
/// question 56813: 0.976 for a sensor of 36 mm), which is twice this.
const NOMINAL: f64 = 0.01;
/// The size of a pixel lies between these, in meters: the smallest of phones have 0.56 µm, those of astronomy 24 µm.
const PITCHES_M: [f64; 2] = [0.3e-6, 50e-6];
/// The equivalent on 35 mm film lies between these, in meters: of fisheyes, and of the longest zoom lenses.
const EQUIVALENTS_M: [f64; 2] = [0.004, 5.0];
/// The two sides of a pixel differ by no more than this.
const SQUARE: std::ops::Range<f64> = 0.9..1.1;
/// A size that was rounded to whole pixels twice has the same shape to this.
const SAME_SHAPE_PX: f64 = 1.5;
/// Where both extents of film lead to the same focal length to this part, there is one way, not two.
const SAME_FOCAL: f64 = 0.002;

/// A focal length in pixels of the picture as it is stored.
#[derive(Clone, Debug)]
pub(super) struct Way {
    pub(super) name: String,
    /// By which tags.
    pub(super) how: String,
    /// fx and fy.
    pub(super) focal: [Pixels; 2],
    /// 1 σ, as a part of it.
    pub(super) relative: f64,
    /// How wide the part of the sensor is that the picture shows, where the way says it.
    pub(super) sensor: Option<Length>,
}

/// What became of the picture after it was taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Change {
    Same,
    /// Of this size before.
    Resized([u32; 2]),
    /// Of this size before.
    Cropped([u32; 2]),
}

/// What became of `photo` after it was taken, by PixelXDimension and PixelYDimension, and whether it was turned by a quarter since.
pub(super) fn change(photo: &Photo) -> (Change, bool) {
    let now = photo.size;
    let Some(taken) = photo.facts.as_ref().and_then(|facts| facts.taken) else {
        return (Change::Same, false);
    };
    let is_upright = |[width, height]: [u32; 2]| height > width;
    let is_turned = is_upright(taken) != is_upright(now) && taken[0] != taken[1] && now[0] != now[1];
    let before = if is_turned { [taken[1], taken[0]] } else { taken };
    let change = if before == now {
        Change::Same
    } else if has_same_shape(before, now) {
        Change::Resized(before)
    } else {
        Change::Cropped(before)
    };
    (change, is_turned)
}

fn has_same_shape(one: [u32; 2], other: [u32; 2]) -> bool {
    let ([width, height], [other_width, other_height]) = (one.map(f64::from), other.map(f64::from));
    let scale = other_width / width;
    (height * scale - other_height).abs() <= SAME_SHAPE_PX * scale.max(1.0)
}

/// The size to which the equivalent on film belongs: that of the whole picture.
pub(super) const fn whole(change: Change, now: [u32; 2]) -> [u32; 2] {
    match change {
        Change::Cropped(taken) => taken,
        Change::Same | Change::Resized(_) => now,
    }
}

/// By the focal length of the lens and the size of a pixel. What cannot be used is added to `ignored`.
pub(super) fn by_plane(facts: &Facts, photo: &Photo, ignored: &mut Vec<String>) -> Option<Way> {
    let (change, is_turned) = change(photo);
    let (lens, [x, y]) = (facts.lens?, facts.plane);
    let lens_length = Length::new(lens.positive()?, LengthUnit::Millimeter);
    let (unit, per) = unit(facts.plane_unit);
    let pitch = Length::from_m(unit.m() / x?);
    let [least, most] = PITCHES_M;
    let um = pitch.m() * 1e6;
    if !(least..=most).contains(&pitch.m()) {
        ignored.push(format!(
            "FocalPlaneXResolution {} per {per}: a pixel of {} µm, which no sensor has",
            brief(x?),
            brief(um)
        ));
        return None;
    }
    let fx = zoomed(
        resized(focal_length_from_pixel_pitch(lens_length, pitch)?, change, photo.size)?,
        facts,
    )?;
    let ratio = y.and_then(|y| Some(y / x?)).unwrap_or(1.0);
    let (fy, is_y) = if SQUARE.contains(&ratio) {
        (Pixels::new(fx.px() * ratio), ratio != 1.0)
    } else {
        ignored.push(format!(
            "FocalPlaneYResolution: {} times that of X, as of no sensor with square pixels",
            brief(ratio)
        ));
        (fx, false)
    };
    if !is_lens(FilmExtent::Diagonal.equivalent(fx, long_side_first(whole(change, photo.size)))?) {
        ignored.push(format!("FocalPlaneXResolution: fx {} px by it, which no lens has", brief(fx.px())));
        return None;
    }
    Some(Way {
        name: format!("FocalPlaneXResolution: {} mm at {} µm", brief(lens.positive()?), brief(um)),
        how: format!(
            "FocalLength, FocalPlaneXResolution{} per {per}",
            if is_y { ", FocalPlaneYResolution" } else { "" }
        ),
        focal: if is_turned { [fy, fx] } else { [fx, fy] },
        sensor: Some(Length::from_m(lens_length.m() * f64::from(photo.size[0]) / fx.px())),
        relative: (rounding(lens) / lens.positive()?).hypot(NOMINAL).hypot(NOMINAL),
    })
}

/// By the equivalent on 35 mm film: by the diagonal, and by the width where that is another focal length.
///
/// It is rounded to whole millimeters: σ is 0.5 mm/√3.
pub(super) fn by_film(facts: &Facts, photo: &Photo, ignored: &mut Vec<String>) -> Vec<Way> {
    let Some(millimeters) = facts.film else { return Vec::new() };
    let equivalent = Length::new(millimeters, LengthUnit::Millimeter);
    if !is_lens(equivalent) {
        ignored.push(format!("FocalLengthIn35mmFilm {} mm: no lens has that", brief(millimeters)));
        return Vec::new();
    }
    let size = long_side_first(whole(change(photo).0, photo.size));
    let way = |extent: FilmExtent, by: &str| {
        let focal = extent.focal_length(equivalent, size)?;
        Some(Way {
            name: format!("35 mm equivalent {} mm{by}", brief(millimeters)),
            how: format!("FocalLengthIn35mmFilm{by}"),
            focal: [focal; 2],
            sensor: None,
            relative: (0.5 / 3_f64.sqrt() / millimeters).hypot(NOMINAL),
        })
    };
    let ways = [
        way(FilmExtent::Diagonal, " by the diagonal"),
        way(FilmExtent::Width, " by the width"),
    ];
    let ways: Vec<Way> = ways.into_iter().flatten().collect();
    match film_ratio(&ways) {
        Some(_) => ways,
        // At 3:2, the shape of the film.
        None => way(FilmExtent::Diagonal, "").into_iter().collect(),
    }
}

/// How many times as large the focal length by the diagonal is as that by the width, where they differ.
pub(super) fn film_ratio(ways: &[Way]) -> Option<f64> {
    let [diagonal, width] = ways else { return None };
    let ratio = diagonal.focal[0].px() / width.focal[0].px();
    ((ratio - 1.0).abs() > SAME_FOCAL).then_some(ratio)
}

/// 1 σ of a focal length in millimeters that was rounded to its last digit, step/√12.
///
/// The last digit is that of the coarsest of 1, 0.1, 0.01 and 0.001 mm with which the number is written; where its denominator shows that
/// tenths could have been written, a whole number of millimeters is one of tenths. So 50/1 is 50 ± 0.29 mm, 350/10 is 35.0 ± 0.029 mm, and
/// 425/100 is 4.25 ± 0.0029 mm.
fn rounding(lens: Rational) -> f64 {
    let Rational { numerator, denominator } = lens;
    let steps = [1.0, 10.0, 100.0, 1000.0];
    let is_written = |per_mm: &f64| {
        let count = numerator / denominator * per_mm;
        (count - count.round()).abs() < 1e-3
    };
    let per_mm = steps.into_iter().find(is_written).unwrap_or(1000.0);
    let per_mm = if denominator >= 10.0 { per_mm.max(10.0) } else { per_mm };
    1.0 / per_mm / 12_f64.sqrt()
}

/// FocalPlaneResolutionUnit: 2 is an inch, also where it is not said, 3 a centimeter. Beside the standard 4 is a millimeter and 5 a
/// micrometer; 1 is none, for which an inch is taken.
fn unit(value: Option<f64>) -> (Length, &'static str) {
    let unit = |unit| Length::new(1.0, unit);
    match value {
        Some(3.0) => (unit(LengthUnit::Centimeter), "centimeter"),
        Some(4.0) => (unit(LengthUnit::Millimeter), "millimeter"),
        Some(5.0) => (Length::from_m(1e-6), "micrometer"),
        _ => (unit(LengthUnit::Inch), "inch"),
    }
}

/// FocalPlaneXResolution is of the picture as it was taken.
fn resized(fx: Pixels, change: Change, now: [u32; 2]) -> Option<Pixels> {
    let Change::Resized(taken) = change else { return Some(fx) };
    let [before, after] = [taken[0], now[0]].map(|side| Pixels::new(f64::from(side)));
    resized_focal_length(fx, before, after)
}

/// The digital zoom cuts out the middle and enlarges it, of which lens and sensor know nothing.
fn zoomed(fx: Pixels, facts: &Facts) -> Option<Pixels> {
    let ratio = zoom(facts).unwrap_or(1.0);
    resized_focal_length(fx, Pixels::new(1.0), Pixels::new(ratio))
}

/// DigitalZoomRatio, where it is one.
pub(super) fn zoom(facts: &Facts) -> Option<f64> {
    const MOST: f64 = 200.0;
    facts.zoom.filter(|ratio| *ratio > 1.0 && *ratio <= MOST)
}

fn is_lens(equivalent: Length) -> bool {
    let [least, most] = EQUIVALENTS_M;
    (least..=most).contains(&equivalent.m())
}

/// The longer side of a picture is that of the film: who holds a camera upright holds its film upright.
fn long_side_first([width, height]: [u32; 2]) -> [Pixels; 2] {
    [width.max(height), width.min(height)].map(|side| Pixels::new(f64::from(side)))
}
