//! What is wrong with numbers that can be read.

use crate::baseline::Baseline;
use crate::camera::{Basis, Camera};
use crate::format::Format;
use crate::found::Found;
use crate::place::Origin;
use crate::refusal::Refusal;
use crate::sentences::shown;
use crate::warning::{Statement, Warning};
use depth_core::quantity::{Length, Pixels};

/// A focal length lies between these parts of the width of its image: 136° to 2.9°.
const FOCAL_LENGTHS: [f64; 2] = [0.2, 20.0];
/// Baselines lie between these.
const BASELINES_M: [f64; 2] = [0.001, 5.0];
/// doffs and the principal points agree to this, in pixels.
const SAME_PX: f64 = 0.1;

/// What a file says of a camera in pixels: fx, fy, cx, cy.
pub(crate) type Pinhole = [f64; 4];

/// A camera of `[fx, fy, cx, cy]`, or a refusal where its focal length is none.
pub(crate) fn camera(
    format: Format,
    name: &str,
    pinhole: Pinhole,
    (size, basis, origin): (Option<[u32; 2]>, Basis, Origin),
) -> Result<Camera, Refusal> {
    let [fx, fy, cx, cy] = pinhole;
    for focal in [fx, fy] {
        if !focal.is_finite() || focal <= 0.0 {
            return Err(Refusal::FocalLength {
                format,
                fx: focal,
                place: origin.place(),
            });
        }
    }
    if let Some((name, value)) = [("cx", cx), ("cy", cy)].into_iter().find(|(_, value)| !value.is_finite()) {
        return Err(Refusal::NotANumber {
            format,
            name: name.to_owned(),
            place: origin.place(),
            text: value.to_string(),
        });
    }
    let [fx, fy, cx, cy] = pinhole.map(Pixels::new);
    Ok(Camera {
        name: name.to_owned(),
        size,
        fx,
        fy,
        cx,
        cy,
        basis,
        origin,
        distortion: Vec::new(),
        model: None,
        sigma: None,
    })
}

/// How many times as large one focal length may be as another of the same camera.
const FOCAL_RATIO: f64 = 3.0;

/// Whether the focal lengths of raw and of rectified images can be of one camera.
pub(crate) fn contradict(rectified: Pinhole, raw: Pinhole) -> bool {
    let ([one, ..], [other, ..]) = (rectified, raw);
    let ratio = one / other;
    raw.iter().all(|number| number.is_finite()) && !(1.0 / FOCAL_RATIO..FOCAL_RATIO).contains(&ratio)
}

/// The principal point lies so near to the middle of the image, as a part of its side.
const MIDDLE: std::ops::Range<f64> = 0.35..0.65;
/// A rectification may move and zoom by this part without another size of the images.
const SAME_SIZE: f64 = 0.25;
/// The focal length and the principal point are scaled alike to this part.
const SAME_RATIO: f64 = 0.1;

/// How many times as large the rectified images are as the raw ones, which have this size, where they have another.
pub(crate) fn resized(rectified: Pinhole, raw: Pinhole, size: [u32; 2]) -> Option<f64> {
    let ([f, _, cx, cy], [raw_f, _, raw_cx, raw_cy]) = (rectified, raw);
    let [width, height] = size.map(f64::from);
    let is_of_size = MIDDLE.contains(&(raw_cx / width)) && MIDDLE.contains(&(raw_cy / height));
    let ratio = cx / raw_cx;
    let is_alike = [f / raw_f, cy / raw_cy]
        .into_iter()
        .all(|other| (other - ratio).abs() <= SAME_RATIO * ratio);
    (is_of_size && is_alike && (ratio - 1.0).abs() > SAME_SIZE).then_some(ratio)
}

/// Why rectified values cannot be used, in a few words; `None` where they can.
pub(crate) fn unusable([fx, fy, cx, cy]: Pinhole, size: Option<[u32; 2]>) -> Option<String> {
    if ![fx, fy, cx, cy].into_iter().all(f64::is_finite) {
        return Some("not all of it is numbers".to_owned());
    }
    if fx <= 0.0 || fy <= 0.0 {
        return Some(format!("its focal length is {fx} px"));
    }
    if cx <= 0.0 || cy <= 0.0 {
        return Some(format!("its principal point is at {cx}, {cy}"));
    }
    let [width, _] = size?.map(f64::from);
    let [least, most] = FOCAL_LENGTHS;
    if fx < least * width || fx > most * width {
        return Some(format!("its focal length is {fx} px where the image is {width} px wide"));
    }
    None
}

/// Images side by side are at least so many times as wide as high.
const SIDE_BY_SIDE: f64 = 2.2;

/// Halves the width of images that lie side by side in one: the principal point is in the middle of the left half.
pub(crate) fn split_sides(found: &mut Found) {
    let of_both = |camera: &Camera| {
        let [width, height] = camera.size?;
        let [at, down] = [camera.cx.px() / f64::from(width), camera.cy.px() / f64::from(height)];
        let is_wide = f64::from(width) > SIDE_BY_SIDE * f64::from(height) && width.is_multiple_of(2);
        (is_wide && (0.2..0.3).contains(&at) && (0.3..0.7).contains(&down)).then_some([width, height])
    };
    let sizes: Option<Vec<[u32; 2]>> = found.cameras.iter().map(of_both).collect();
    let Some(size) = sizes.and_then(|sizes| sizes.first().copied()) else {
        return;
    };
    found.warnings.push(Warning::SideBySide { size });
    for camera in &mut found.cameras {
        camera.size = camera.size.map(|[width, height]| [width / 2, height]);
    }
}

/// Adds to `found` what follows from its numbers alone, and leaves out what is said twice.
pub(crate) fn remark(found: &mut Found) {
    let mut warnings = Vec::new();
    for camera in &found.cameras {
        let Some([width, height]) = camera.size else { continue };
        let sides = [(camera.cx, width), (camera.cy, height)];
        let outside = sides.into_iter().find(|(at, side)| at.px() > f64::from(*side) || at.px() < 0.0);
        if let Some((principal, side)) = outside {
            warnings.push(Warning::SizeContradicts {
                principal: principal.px(),
                side,
            });
        }
        let [least, most] = FOCAL_LENGTHS.map(|part| part * f64::from(width));
        // Where the size is wrong, the focal length is judged by it in vain; a photograph says what lens it was.
        let is_judged = outside.is_none() && found.format != Format::Exif;
        if is_judged && (camera.fx.px() < least || camera.fx.px() > most) {
            warnings.push(Warning::FocalLength { fx: camera.fx, width });
        }
    }
    match found.baseline {
        Some(Baseline::InFileUnits { value, guess }) => warnings.push(Warning::UnitUnknown { value, guess }),
        Some(Baseline::Known(baseline)) => warnings.extend(implausible(baseline)),
        None => {}
    }
    for warning in warnings {
        if !found.warnings.contains(&warning) {
            found.warnings.push(warning);
        }
    }
}

/// That a baseline is hardly one of anything, where it is.
pub(crate) fn implausible(baseline: Length) -> Option<Warning> {
    let [least, most] = BASELINES_M;
    let is_plausible = (least..=most).contains(&baseline.m());
    (!is_plausible).then_some(Warning::Implausible { baseline })
}

/// Two numbers for the same length agree to this part of them.
const SAME_LENGTH: f64 = 0.02;

/// Whether two numbers can be of the same length.
pub(crate) fn agree(one: f64, other: f64) -> bool {
    (one - other).abs() <= SAME_LENGTH * one.abs().max(other.abs())
}

/// That two lengths in meters contradict each other, where they do.
pub(crate) fn same_length((used, origin): (f64, &Origin), (other, other_origin): (f64, &Origin)) -> Option<Warning> {
    let say = |meters: f64, origin: &Origin| Statement {
        value: format!("{} m", shown(meters)),
        origin: origin.clone(),
    };
    (!agree(used, other)).then(|| Warning::Contradiction {
        used: say(used, origin),
        other: say(other, other_origin),
    })
}

/// A baseline of so many meters; `None` where both cameras stand at the same place.
pub(crate) fn in_meters(meters: f64, warnings: &mut Vec<Warning>) -> Option<Baseline> {
    if meters > 0.0 && meters.is_finite() {
        return Some(Baseline::Known(Length::from_m(meters)));
    }
    warnings.push(Warning::ZeroBaseline);
    None
}

/// Fills in the offset of the principal points of the rectified pair, along its baseline; where the file has one of its own, that counts.
pub(crate) fn read_doffs(found: &mut Found, of_file: Option<(f64, Origin)>) {
    compare_rectified(found);
    let (of_file, file_origin) = of_file.map(|(px, origin)| (Pixels::new(px), origin)).unzip();
    let of_points = of_points(found);
    if let (Some(of_file), Some((of_points, _))) = (of_file, &of_points)
        && (of_file.px() - of_points.px()).abs() > SAME_PX
    {
        let of_points = *of_points;
        found.warnings.push(Warning::Doffs { of_file, of_points });
    }
    let (of_points, points_origin) = of_points.unzip();
    found.doffs = of_file.or(of_points);
    found.doffs_origin = file_origin.or(points_origin);
}

/// The focal lengths of a rectified pair agree to this part of them.
const SAME_FOCAL: f64 = 0.01;

/// Says where the cameras of a rectified pair cannot be of one rectification.
fn compare_rectified(found: &mut Found) {
    let Some([one, other]) = rectified_pair(found) else { return };
    let ([f, g], mut said) = ([one, other].map(|camera| camera.fx.px()), Vec::new());
    if let Some(sizes) = different_sizes(one, other) {
        said.push(Warning::Sizes { sizes });
    }
    if (f - g).abs() > SAME_FOCAL * f.max(g) {
        let say = |camera: &Camera| Statement {
            value: format!("{} px", shown(camera.fx.px())),
            origin: camera.origin.clone(),
        };
        let (one, other) = (say(one), say(other));
        said.push(Warning::FocalLengths { one, other });
    }
    found.warnings.append(&mut said);
}

fn different_sizes(one: &Camera, other: &Camera) -> Option<[[u32; 2]; 2]> {
    let (one, other) = one.size.zip(other.size)?;
    (one != other).then_some([one, other])
}

/// The two cameras of the pair, where both are rectified.
fn rectified_pair(found: &Found) -> Option<[&Camera; 2]> {
    let pair = found.pair?.map(|at| found.cameras.get(at));
    let [Some(one), Some(other)] = pair else { return None };
    [one, other]
        .iter()
        .all(|camera| camera.basis == Basis::Rectified)
        .then_some([one, other])
}

fn of_points(found: &Found) -> Option<(Pixels, Origin)> {
    let [first, second] = found.pair?;
    let (first, second) = (found.cameras.get(first)?, found.cameras.get(second)?);
    if different_sizes(first, second).is_some() {
        return None;
    }
    let along = |camera: &Camera| if found.is_vertical { camera.cy.px() } else { camera.cx.px() };
    let center = if found.is_vertical { "cy" } else { "cx" };
    let names = if first.origin.how == second.origin.how {
        [&first.name, &second.name]
    } else {
        [&first.origin.how, &second.origin.how]
    };
    let [one, other] = names;
    let how = format!("{center} of {other} - {center} of {one}");
    Some((Pixels::new(along(second) - along(first)), second.origin.place().origin(how)))
}

/// No model of a lens has more coefficients: OpenCV’s has 14, COLMAP’s 16.
const MOST_COEFFICIENTS: usize = 16;

/// The coefficients of a distortion, with which nothing here is computed: none where one of them is no number.
pub(crate) fn coefficients(all: Option<Vec<f64>>) -> Vec<f64> {
    let are_some = |all: &Vec<f64>| all.len() <= MOST_COEFFICIENTS && all.iter().all(|one| one.is_finite());
    all.filter(are_some).unwrap_or_default()
}
