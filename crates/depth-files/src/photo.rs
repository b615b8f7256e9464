//! A photograph: how large it is, and what its EXIF says of the camera.

use crate::jpeg::{Jpeg, segments};
use crate::refusal::Refusal;
use crate::tiff::{Rational, Tiff};

/// A JPEG.
#[derive(Debug)]
pub(crate) struct Photo {
    /// Which of the files it is.
    pub(crate) file: usize,
    /// Width and height in pixels, as they are stored.
    pub(crate) size: [u32; 2],
    /// `None` where there is no EXIF.
    pub(crate) facts: Option<Facts>,
}

/// What EXIF says of a camera, each number as it is written.
#[derive(Debug, Default)]
pub(crate) struct Facts {
    /// Make and Model.
    pub(crate) maker: Option<String>,
    /// How a viewer turns the picture: 5 to 8 with its width for its height.
    pub(crate) orientation: Option<f64>,
    /// FocalLength, in millimeters.
    pub(crate) lens: Option<Rational>,
    /// FocalLengthIn35mmFilm, in millimeters.
    pub(crate) film: Option<f64>,
    /// FocalPlaneXResolution and FocalPlaneYResolution, in pixels for a unit.
    pub(crate) plane: [Option<f64>; 2],
    /// FocalPlaneResolutionUnit.
    pub(crate) plane_unit: Option<f64>,
    /// PixelXDimension and PixelYDimension: the size as the photograph was taken.
    pub(crate) taken: Option<[u32; 2]>,
    /// DigitalZoomRatio.
    pub(crate) zoom: Option<f64>,
    /// SubjectDistance, in meters.
    pub(crate) distance_m: Option<f64>,
}

/// The photograph in `bytes`, which are the `file`th.
pub(crate) fn photo(bytes: &[u8], file: usize) -> Result<Photo, Refusal> {
    let damaged = |reason: &str| Refusal::Damaged {
        what: "a photograph (JPEG)",
        reason: reason.to_owned(),
    };
    let Jpeg { size, exif } = segments(bytes);
    let size = size.ok_or_else(|| damaged("it ends before it says how large the picture is"))?;
    let facts = exif.map(|exif| Tiff::of(exif).map(|tiff| facts(&tiff)));
    match facts {
        Some(None) => Err(damaged("its EXIF cannot be read")),
        facts => Ok(Photo {
            file,
            size,
            facts: facts.flatten(),
        }),
    }
}

/// Source: CIPA DC-008-2023 (Exif 3.0), 4.6.4 and 4.6.6, where each of these tags has its number.
fn facts(tiff: &Tiff<'_>) -> Facts {
    let first = tiff.first();
    let of_first = |tag| tiff.number(first, tag).and_then(Rational::positive);
    let maker = maker(tiff.text(first, 0x010f), tiff.text(first, 0x0110));
    let orientation = of_first(0x0112);
    let Some(exif) = tiff.directory(first, 0x8769) else {
        return Facts {
            maker,
            orientation,
            ..Facts::default()
        };
    };
    let positive = |tag| tiff.number(exif, tag).and_then(Rational::positive);
    let [width, height] = [0xa002, 0xa003].map(|tag| tiff.whole(exif, tag).filter(|side| *side > 0));
    Facts {
        maker,
        orientation,
        lens: tiff.number(exif, 0x920a).filter(|lens| lens.positive().is_some()),
        film: positive(0xa405),
        plane: [0xa20e, 0xa20f].map(positive),
        plane_unit: positive(0xa210),
        taken: width.zip(height).map(|(width, height)| [width, height]),
        zoom: positive(0xa404),
        distance_m: positive(0x9206),
    }
}

/// Make and Model, the make once where the model begins with it.
fn maker(make: Option<String>, model: Option<String>) -> Option<String> {
    let (Some(make), Some(model)) = (&make, &model) else {
        return make.or(model);
    };
    let first = |text: &str| text.split_whitespace().next().unwrap_or_default().to_ascii_lowercase();
    Some(if first(make) == first(model) {
        model.clone()
    } else {
        format!("{make} {model}")
    })
}
