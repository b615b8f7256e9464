//! What is to be said of a focal length that comes from a photograph.

use crate::number::brief;
use depth_core::quantity::{Length, LengthUnit, Pixels};
use std::fmt;

/// What somebody has to know of a focal length from EXIF before they use it. The sentence is its `Display`.
#[derive(Clone, Debug, PartialEq)]
pub enum PhotoWarning {
    /// The focal length is what the maker says of this kind of camera.
    Nominal {
        /// Who made it.
        maker: Option<String>,
    },
    /// Two ways lead to the same focal length.
    Agreement {
        /// The name of the way that is trusted most.
        trusted: String,
        /// The name of the other.
        other: String,
    },
    /// Two ways lead to different focal lengths.
    Contradiction {
        /// The name of the way that is trusted, and what fx is by it.
        trusted: (String, Pixels),
        /// The same of the other.
        other: (String, Pixels),
        /// The digital zoom, where they differ by so many times.
        zoom: Option<f64>,
    },
    /// Nothing else says whether the size of a pixel is that of this picture.
    PlaneAlone {
        /// How wide the sensor is by it.
        sensor: Length,
    },
    /// An equivalent on 35 mm film is meant in one of two ways.
    FilmExtents {
        /// Of the photograph, as it was taken.
        size: [u32; 2],
        /// How many times as large fx is by the diagonal as by the width.
        ratio: f64,
    },
    /// The photograph has another size than it was taken with, of the same shape.
    Resized {
        /// As it was taken.
        taken: [u32; 2],
        /// As it is.
        now: [u32; 2],
    },
    /// The photograph has another shape than it was taken with.
    Cropped {
        /// As it was taken.
        taken: [u32; 2],
        /// As it is.
        now: [u32; 2],
    },
    /// The camera cut the middle out of its image and enlarged it.
    DigitalZoom {
        /// So many times.
        ratio: f64,
        /// Whether fx of one of the ways was multiplied by it.
        is_applied: bool,
    },
    /// A viewer exchanges width and height.
    Turned {
        /// The tag, 5 to 8.
        orientation: f64,
        /// As people see it.
        size: [u32; 2],
    },
    /// The lens was focused near.
    Near {
        /// So far away.
        distance: Length,
        /// How many times as large fx is as for what is far away.
        ratio: f64,
    },
    /// A lens that may be a fisheye.
    Wide {
        /// On 35 mm film.
        equivalent: Length,
    },
}

impl fmt::Display for PhotoWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Nominal { maker } => {
                let maker = maker.as_ref().map_or_else(String::new, |maker| format!(" ({maker})"));
                write!(
                    f,
                    "EXIF has the nominal focal length of such a camera{maker}, not that of this one: it may be a few percent off, and more after \
                     digital stabilization. The picture is not undistorted. A calibration is better, or a photo of something of known size and distance."
                )
            }
            Self::Agreement { trusted, other } => write!(
                f,
                "“{trusted}” and “{other}” agree within their errors. The first is trusted most, as it does not depend on how an equivalent is counted."
            ),
            Self::Contradiction { trusted, other, zoom } => {
                let why = zoom.map_or_else(
                    || {
                        ": an equivalent holds whatever the photo was scaled to, and FocalPlaneXResolution often stays that of another size.".to_owned()
                    },
                    |zoom| format!(", but they differ by the digital zoom, {}, which may be missing in the first.", brief(zoom)),
                );
                write!(
                    f,
                    "“{}” leads to fx {} px, but “{}” to {} px, which is more than their errors allow. The first is trusted{why}",
                    trusted.0,
                    brief(trusted.1.px()),
                    other.0,
                    brief(other.1.px())
                )
            }
            Self::PlaneAlone { sensor } => write!(
                f,
                "FocalPlaneXResolution often stays that of another size when a photo is resized, and nothing else here says so. By it the sensor is {} mm \
                 wide: if that of this camera is wider, fx is smaller in the same measure.",
                brief(rounded(sensor.in_unit(LengthUnit::Millimeter)))
            ),
            Self::FilmExtents { size, ratio } => write!(
                f,
                "A 35 mm equivalent is counted by the diagonal (CIPA) or by the width, and EXIF does not say which: at {} fx by the diagonal is {:.1} % \
                 {}. It is trusted more.",
                sides(*size),
                100.0 * (ratio - 1.0).abs(),
                if *ratio > 1.0 { "larger" } else { "smaller" }
            ),
            Self::DigitalZoom { ratio, is_applied } => zoom(f, *ratio, *is_applied),
            Self::Resized { .. } | Self::Cropped { .. } | Self::Turned { .. } | Self::Near { .. } | Self::Wide { .. } => self.of_size(f),
        }
    }
}

impl PhotoWarning {
    fn of_size(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Resized { taken, now } => {
                let ([before, ..], [after, ..]) = (taken, now);
                write!(
                    f,
                    "The photo was taken with {} pixels and has {} now: it was resized, and fx is scaled with it. If it was cropped to the same shape \
                     instead, fx is {} times as large.",
                    sides(*taken),
                    sides(*now),
                    brief(f64::from(*before) / f64::from(*after))
                )
            }
            Self::Cropped { taken, now } => write!(
                f,
                "The photo was taken with {} pixels and has {} now, another shape: it was cropped. fx is that of the uncropped photo, which holds unless it \
                 was resized as well; where cx and cy are is not known.",
                sides(*taken),
                sides(*now)
            ),
            Self::Turned { orientation, size } => write!(
                f,
                "Viewers turn this photo by its Orientation {orientation}: the size is {}, as people see it. A program that does not turn it has width \
                 and height the other way round.",
                sides(*size)
            ),
            Self::Near { distance, ratio } => write!(
                f,
                "The lens was focused at {} m (SubjectDistance). One that moves as a whole then has an fx that is {:.1} % larger than for what is far \
                 away, which is not in the numbers.",
                brief(distance.m()),
                100.0 * (ratio - 1.0)
            ),
            Self::Wide { equivalent } => write!(
                f,
                "{} mm on 35 mm film is very wide: if it is a fisheye, as in action cameras, fx holds only in the middle. Undistort the photo first.",
                brief(equivalent.in_unit(LengthUnit::Millimeter))
            ),
            _ => Ok(()),
        }
    }
}

/// To a tenth.
fn rounded(millimeters: f64) -> f64 {
    (millimeters * 10.0).round() / 10.0
}

fn zoom(f: &mut fmt::Formatter<'_>, ratio: f64, is_applied: bool) -> fmt::Result {
    let ratio = brief(ratio);
    let applied = if is_applied {
        ": fx by FocalPlaneXResolution is multiplied by it"
    } else {
        ""
    };
    write!(
        f,
        "DigitalZoomRatio is {ratio}{applied}. The 35 mm equivalent is taken as it is, as most cameras write it with the zoom in it: where it is not, \
         fx by it is {ratio} times as large."
    )
}

fn sides([width, height]: [u32; 2]) -> String {
    format!("{width} × {height}")
}
