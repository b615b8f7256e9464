//! What is to be said of facts of a camera, for the window and for the command line.

use crate::number::{Notation, rounded_to, with_minus};
use depth_core::camera::{CameraProblem, CameraRemark, Cause, SensorRemark, Side};
use depth_core::quantity::{Length, Pixels};

/// What a surface calls the things that its sentences name.
#[derive(Clone, Copy)]
pub struct CameraWords<'a> {
    /// The fact at a place, with what was typed: "--hfov 71.86".
    pub stated: &'a dyn Fn(usize) -> String,
    /// The fact at a place: "--hfov".
    pub called: &'a dyn Fn(usize) -> String,
    /// The size of a pixel.
    pub pitch: &'a str,
    /// Everything that says the size of a pixel.
    pub sensor: &'a str,
    /// The distance in focus.
    pub focus: &'a str,
    /// The diagonal of the sensor.
    pub diagonal: &'a str,
    /// Where the projection is chosen.
    pub projection: &'a str,
    /// What to do where fx was calibrated in the water.
    pub dry: &'a str,
    /// Everything that says a focal length.
    pub facts: &'a str,
}

/// More digits no data sheet has.
const DIGITS: usize = 6;

/// As a data sheet would have it.
fn number(value: f64) -> String {
    with_minus(&Notation::LONG.plain(value, DIGITS))
}

fn whole(pixels: Pixels) -> String {
    number(pixels.px().round())
}

fn micrometers(length: Length) -> String {
    format!("{} µm", number(length.m() * 1e6))
}

fn millimeters(length: Length) -> String {
    format!("{} mm", number(rounded_to(length.m() * 1000.0, 0.001)))
}

impl CameraWords<'_> {
    /// A remark in words.
    pub fn remark(&self, remark: &CameraRemark) -> String {
        match remark {
            CameraRemark::Sensor(remark) => self.sensor_remark(remark),
            CameraRemark::Contradiction { is_of_fy, facts, cause } => self.contradiction(*is_of_fy, facts, *cause),
            CameraRemark::Whole {
                at,
                shape: [long, short],
                focal_length,
            } => format!(
                "{} is that of the whole picture. If this image was cut from one of {long}:{short}, fx is {} px.",
                (self.stated)(*at),
                number(focal_length.px())
            ),
            CameraRemark::View(view) => format!(
                "A diagonal view of {}° is hardly that of a camera: check the units.",
                number(view.degrees())
            ),
            CameraRemark::NotSquare { fx, fy } => format!(
                "fx {} px and fy {} px differ by {} %: pixels are rarely so far from square.",
                number(fx.px()),
                number(fy.px()),
                number(((fy.px() / fx.px() - 1.0).abs() * 100.0).round())
            ),
            CameraRemark::Wide { view, as_fisheye } => {
                let others: Vec<String> = as_fisheye
                    .iter()
                    .map(|(projection, f)| format!("{} {} px", projection.name(), number(f.px())))
                    .collect();
                format!(
                    "A view of {}° is rarely that of a pinhole, and the focal length of a fisheye cannot be had from its angle this way. {} it would be: {}.",
                    number(view.degrees()),
                    self.projection,
                    others.join(", ")
                )
            }
            CameraRemark::UnderWater => format!(
                "Was fx calibrated in the water? Then {}, as it is in fx already. fx and fy are 1.333 times those in air, an approximation for a flat window (Treibitz et al., 2012): it is 7 % off where a ray comes at 30° in air, and no more than 97° of the water are seen.",
                self.dry
            ),
        }
    }

    fn sensor_remark(&self, remark: &SensorRemark) -> String {
        match *remark {
            SensorRemark::Turned => "The image stands and the sensor lies, or the other way round: its sides were exchanged.".to_owned(),
            SensorRemark::Cut {
                side,
                pitch,
                on_sensor,
                in_image,
            } => {
                let what = lines(side);
                format!(
                    "The image is not the whole sensor: with square pixels of {} it has {} {what}, of which the image has {}. So {what} were cut, which changes neither fx nor fy.",
                    micrometers(pitch),
                    whole(on_sensor),
                    whole(in_image)
                )
            }
            SensorRemark::Multiple { times, pitch } => format!(
                "The sensor has {} times as many rows and columns as the image. If the middle was cut out, the focal length is as it is said here; if pixels were binned or the image was resized, a pixel of the image is {} and the focal length {} times shorter.",
                number(times),
                micrometers(Length::from_m(pitch.m() * times)),
                number(times)
            ),
            SensorRemark::OnlyHeight => {
                "Only the height of the sensor says how large a pixel is: if rows were cut, the focal length is larger. State its width or the pixel pitch too.".to_owned()
            }
            SensorRemark::Standing => {
                "The image stands, and the width of the sensor is taken along its rows. If the sensor lies and the camera was turned, state its height instead.".to_owned()
            }
            SensorRemark::Pitch(pitch) => format!("A pixel of {} is no sensor’s: most have 0.5 to 30 µm. Check the units.", micrometers(pitch)),
            SensorRemark::Fewer {
                side,
                pitch,
                on_sensor,
                in_image,
            } => format!(
                "{} and the sensor exclude one another: with pixels of {} it has {} {}, and the image has {}. The pitch is followed.",
                self.pitch,
                micrometers(pitch),
                whole(on_sensor),
                lines(side),
                whole(in_image)
            ),
            SensorRemark::Diagonal { stated, of_sides } => format!(
                "{} and both sides exclude one another: they have one of {}, not {}. The sides are followed.",
                self.diagonal,
                millimeters(of_sides),
                millimeters(stated)
            ),
        }
    }

    fn contradiction(&self, is_of_fy: bool, facts: &[(usize, Pixels)], cause: Option<Cause>) -> String {
        let say = |(at, f): &(usize, Pixels)| format!("{} is {} px", (self.stated)(*at), number(f.px()));
        let all: Vec<String> = facts.iter().map(say).collect();
        let first = facts.first().map(|(at, _)| (self.called)(*at)).unwrap_or_default();
        format!(
            "These exclude one another: {}. {} {} follows {first}.",
            all.join(", "),
            self.cause(cause),
            if is_of_fy { "fy" } else { "fx" },
        )
    }

    fn cause(&self, cause: Option<Cause>) -> String {
        match cause {
            Some(Cause::Fisheye(projection)) => format!("They agree for an {} fisheye.", projection.name()).replace("an s", "a s"),
            Some(Cause::Cut { at, side, before, now }) => format!(
                "{} would be that of {} {}: perhaps they were cut to {}.",
                (self.stated)(at),
                whole(before),
                lines(side),
                whole(now)
            ),
            Some(Cause::Film) => "An equivalent is counted by the diagonal (CIPA) or by the width: it cannot be both.".to_owned(),
            None => "Perhaps rows or columns of the sensor were cut, or one is of the image before it was rectified or resized.".to_owned(),
        }
    }

    /// Why there is no answer; of a view with the name of the lens that cannot have it.
    pub fn problem(&self, problem: CameraProblem, projection: &str) -> String {
        match problem {
            CameraProblem::NothingStated => format!("Nothing says the focal length: add {}.", self.facts),
            CameraProblem::NoPitch(at) => format!("{} needs the size of the pixels: add {}.", (self.called)(at), self.sensor),
            CameraProblem::FocusTooNear => format!(
                "{} has to be farther away than the focal length of the lens: nearer nothing is sharp.",
                self.focus
            ),
            CameraProblem::NoSuchView(at) => format!("{}: no {projection} lens has such a view.", (self.stated)(at)),
            CameraProblem::NoFocalLength(at) => format!("{} gives no focal length.", (self.stated)(at)),
            CameraProblem::ShortDiagonal => format!("{} is shorter than a side of the sensor.", self.diagonal),
        }
    }
}

const fn lines(side: Side) -> &'static str {
    match side {
        Side::Width => "columns",
        Side::Height => "rows",
    }
}
