//! How large the pixels of a sensor are, from what a data sheet says of it.

use super::focal_length::diagonal;
use crate::judge;
use crate::quantity::{Length, Pixels};

/// What is known of a sensor. Its sides are those of the part that has pixels, without a frame around it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sensor {
    /// From the center of a pixel to that of the next.
    pub pitch: Option<Length>,
    /// Along the rows.
    pub width: Option<Length>,
    /// Along the columns.
    pub height: Option<Length>,
    /// From corner to corner.
    pub diagonal: Option<Length>,
}

/// A side of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Its columns lie side by side along it.
    Width,
    /// Its rows lie side by side along it.
    Height,
}

/// What a person has to know of the sides of a sensor and of its image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SensorRemark {
    /// The sensor lies, and the image stands, or the other way round: its sides were exchanged.
    Turned,
    /// With square pixels the sensor has more of them along `side` than the image: the rest was cut, which changes no focal length.
    Cut {
        /// Along which side.
        side: Side,
        /// The size of a pixel.
        pitch: Length,
        /// Pixels of the sensor.
        on_sensor: Pixels,
        /// Pixels of the image.
        in_image: Pixels,
    },
    /// With pixels of this size the sensor has fewer of them along `side` than the image.
    Fewer {
        /// Along which side.
        side: Side,
        /// The size of a pixel, which is followed.
        pitch: Length,
        /// Pixels of the sensor.
        on_sensor: Pixels,
        /// Pixels of the image.
        in_image: Pixels,
    },
    /// The sensor has `times` as many pixels along both sides as the image: they were binned or the image was resized, or its middle was cut out.
    Multiple {
        /// So many times.
        times: f64,
        /// The size of a pixel of the sensor, which is followed.
        pitch: Length,
    },
    /// Only the height of the sensor says how large a pixel is: rows that were cut would be taken for larger pixels.
    OnlyHeight,
    /// Only the width of the sensor does, and the image stands: that of a sensor that lies is along the columns.
    Standing,
    /// A pixel of a size that no sensor has.
    Pitch(Length),
    /// Both sides of the sensor give another diagonal than the one that was stated, which is not used.
    Diagonal {
        /// The one that was stated.
        stated: Length,
        /// That of both sides.
        of_sides: Length,
    },
}

/// The diagonal of a sensor is shorter than one of its sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShortDiagonal;

/// So much may two sides of a sensor, or two facts, differ: data sheets round.
pub(super) const TOLERANCE: f64 = 0.02;

impl Sensor {
    /// The size of a pixel, and what is to be said of it: the stated one, or that of the sides over an image of `size`. Pixels are square:
    /// where rows or columns were cut, the other side decides. `None` where nothing says it.
    ///
    /// ```
    /// use depth_core::camera::{Sensor, SensorRemark, Side};
    /// use depth_core::quantity::{Length, Pixels};
    ///
    /// // 9.6 × 7.2 mm have 1600 × 1200 pixels, of which 1600 × 800 were kept.
    /// let [width, height] = [0.0096, 0.0072].map(|m| Some(Length::from_m(m)));
    /// let sensor = Sensor { width, height, ..Sensor::default() };
    /// let (pitch, remarks) = sensor.pitch([Pixels::new(1600.0), Pixels::new(800.0)]).unwrap();
    /// assert!((pitch.unwrap().m() - 6e-6).abs() < 1e-12);
    /// assert!(matches!(remarks[..], [SensorRemark::Cut { side: Side::Height, .. }]));
    /// ```
    ///
    /// # Errors
    /// [`ShortDiagonal`].
    pub fn pitch(self, size: [Pixels; 2]) -> Result<(Option<Length>, Vec<SensorRemark>), ShortDiagonal> {
        let mut remarks = Vec::new();
        let mut sides = self.sides(&mut remarks)?;
        if is_turned(sides, size) {
            sides.reverse();
            remarks.push(SensorRemark::Turned);
        }
        let [width, height] = size;
        let over = |side: Option<Length>, pixels: Pixels| side.map(|side| side.m() / pixels.px());
        let [across, down] = sides;
        let by_sides = [over(across, width), over(down, height)].into_iter().flatten().reduce(f64::min);
        let stated = self.pitch.map(Length::m);
        let pitch = stated.or(by_sides).or_else(|| over(self.diagonal, diagonal(width, height)));
        let Some(pitch) = pitch.filter(|pitch| judge::positive(*pitch).is_ok()).map(Length::from_m) else {
            return Ok((None, remarks));
        };
        remarks.extend(self.of_one_side(size));
        let [least, most] = PITCHES_M;
        if !(least..=most).contains(&pitch.m()) {
            remarks.push(SensorRemark::Pitch(pitch));
        }
        if let [Some(across), Some(down)] = sides.map(|side| side.map(|side| side.m() / pitch.m()))
            && let Some(times) = same_multiple(across / width.px(), down / height.px())
        {
            remarks.push(SensorRemark::Multiple { times, pitch });
            return Ok((Some(pitch), remarks));
        }
        for (side, length, in_image) in [(Side::Height, down, height), (Side::Width, across, width)] {
            let Some(on_sensor) = length.map(|length| Pixels::new(length.m() / pitch.m())) else {
                continue;
            };
            let ratio = on_sensor.px() / in_image.px();
            if ratio > 1.0 + TOLERANCE {
                remarks.push(SensorRemark::Cut {
                    side,
                    pitch,
                    on_sensor,
                    in_image,
                });
            } else if ratio < 1.0 - TOLERANCE {
                remarks.push(SensorRemark::Fewer {
                    side,
                    pitch,
                    on_sensor,
                    in_image,
                });
            }
        }
        Ok((Some(pitch), remarks))
    }

    /// What may be wrong where only one side says how large a pixel is.
    fn of_one_side(self, [width, height]: [Pixels; 2]) -> Option<SensorRemark> {
        let is_alone = self.pitch.is_none() && self.diagonal.is_none();
        match (self.width, self.height) {
            (None, Some(_)) if is_alone => Some(SensorRemark::OnlyHeight),
            (Some(_), None) if is_alone && height.px() > width.px() => Some(SensorRemark::Standing),
            _ => None,
        }
    }

    /// Width and height, one of them from the diagonal where it was not stated.
    fn sides(self, remarks: &mut Vec<SensorRemark>) -> Result<[Option<Length>; 2], ShortDiagonal> {
        let Some(stated) = self.diagonal else {
            return Ok([self.width, self.height]);
        };
        let other = |one: Length| {
            let square = stated.m() * stated.m() - one.m() * one.m();
            (square > 0.0).then(|| Length::from_m(square.sqrt())).ok_or(ShortDiagonal)
        };
        match (self.width, self.height) {
            (Some(width), Some(height)) => {
                let of_sides = Length::from_m(width.m().hypot(height.m()));
                if (of_sides.m() / stated.m() - 1.0).abs() > TOLERANCE {
                    remarks.push(SensorRemark::Diagonal { stated, of_sides });
                }
                Ok([Some(width), Some(height)])
            }
            (Some(width), None) => Ok([Some(width), Some(other(width)?)]),
            (None, Some(height)) => Ok([Some(other(height)?), Some(height)]),
            (None, None) => Ok([None, None]),
        }
    }
}

/// The pixels of sensors lie between these, in meters: those of phones begin at 0.56 µm, those of astronomy end at 24 µm.
const PITCHES_M: [f64; 2] = [0.3e-6, 100e-6];

/// The whole number from 2 on that both ratios are, where they are.
fn same_multiple(across: f64, down: f64) -> Option<f64> {
    let times = across.round();
    let is_near = |ratio: f64| (ratio / times - 1.0).abs() <= TOLERANCE;
    (times >= 2.0 && is_near(across) && is_near(down)).then_some(times)
}

/// Whether the sides fit an image of `size` only the other way round: a phone was held upright.
fn is_turned(sides: [Option<Length>; 2], [width, height]: [Pixels; 2]) -> bool {
    let [Some(across), Some(down)] = sides else { return false };
    let (sensor, image) = (across.m() / down.m(), width.px() / height.px());
    let fits = |ratio: f64| (ratio / image - 1.0).abs() <= TOLERANCE;
    fits(1.0 / sensor) && !fits(sensor)
}
