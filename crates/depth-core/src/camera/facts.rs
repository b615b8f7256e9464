//! What data sheets, photographers and simulators state of a camera, and what follows from it.

use super::film::FilmExtent;
use super::projection::Projection;
use super::sensor::{Sensor, SensorRemark, Side};
use crate::angle::Angle;
use crate::quantity::{Length, Pixels};

/// Something that says a focal length, with the size of the image and sometimes with the sensor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fact {
    /// Along the rows, `K[0][0]`.
    Fx(Pixels),
    /// Along the columns, `K[1][1]`.
    Fy(Pixels),
    /// From the left edge of the image to the right one.
    HorizontalView(Angle),
    /// From its top to its bottom.
    VerticalView(Angle),
    /// From corner to corner.
    DiagonalView(Angle),
    /// The focal length of the lens. Says the other only with the size of a pixel, and that size where another fact says the other.
    Lens(Length),
    /// The equivalent lens for 35 mm film.
    Film(FilmExtent, Length),
    /// Row 0, column 0 of an OpenGL projection matrix, 2·fx/W.
    P00(f64),
    /// Row 1, column 1 of it, 2·fy/H.
    P11(f64),
}

/// What is stated of a camera.
#[derive(Clone, Debug, PartialEq)]
pub struct CameraFacts {
    /// Width and height of the image.
    pub size: [Pixels; 2],
    /// What says the focal length, in the order in which it was stated.
    pub facts: Vec<Fact>,
    /// What is known of the sensor.
    pub sensor: Sensor,
    /// At which distance the lens is in focus; `None` for far away.
    pub focused_at: Option<Length>,
    /// How the lens projects.
    pub projection: Projection,
    /// Whether the camera is under water behind a flat window, and the facts hold in air.
    pub is_under_water: bool,
}

/// Everything that follows: under water focal lengths, views and multiples are those in the water, the lens, the sensor and the equivalents
/// those in air.
#[derive(Clone, Debug, PartialEq)]
pub struct CameraAnswer {
    /// Along the rows.
    pub fx: Pixels,
    /// Along the columns.
    pub fy: Pixels,
    /// The size of a pixel; `None` where nothing says it.
    pub pitch: Option<Length>,
    /// The focal length of the lens; `None` where the size of a pixel is not known.
    pub lens: Option<Length>,
    /// Horizontal, vertical and diagonal view; `None` of what the projection cannot show.
    pub views: [Option<Angle>; 3],
    /// The equivalent lens for 35 mm film, by the diagonal and by the width; `None` of a fisheye.
    pub film: [Option<Length>; 2],
    /// Width, height and diagonal of the part of the sensor that the image shows; `None` where the size of a pixel is not known.
    pub sensor: [Option<Length>; 3],
    /// P00 and P11 of an OpenGL projection matrix, 2·fx/W and 2·fy/H.
    pub multiples: [f64; 2],
    /// What has to be known before it is used.
    pub remarks: Vec<CameraRemark>,
}

/// What has to be known of facts of a camera before their answer is used. Facts are named by their place in [`CameraFacts::facts`].
#[derive(Clone, Debug, PartialEq)]
pub enum CameraRemark {
    /// Of the sensor.
    Sensor(SensorRemark),
    /// These exclude one another, each with the focal length that it says; the first one is followed.
    Contradiction {
        /// Whether they say fy.
        is_of_fy: bool,
        /// The places, and what each says.
        facts: Vec<(usize, Pixels)>,
        /// What would make them agree, if anything is known that would.
        cause: Option<Cause>,
    },
    /// A fact that is of the whole picture, of which this image may be a part: what the focal length would be then.
    Whole {
        /// The place of the fact.
        at: usize,
        /// The shape of the whole picture.
        shape: [u32; 2],
        /// Of this image.
        focal_length: Pixels,
    },
    /// A view that is hardly that of a camera: a unit may be wrong.
    View(Angle),
    /// Pixels that are far from square.
    NotSquare {
        /// Along the rows.
        fx: Pixels,
        /// Along the columns.
        fy: Pixels,
    },
    /// A view that is rarely a pinhole's, and what its focal length would be, were the lens a fisheye.
    Wide {
        /// The view.
        view: Angle,
        /// By each projection that has such a view.
        as_fisheye: Vec<(Projection, Pixels)>,
    },
    /// The focal lengths were multiplied for water.
    UnderWater,
}

/// What would make facts agree that exclude one another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cause {
    /// The lens is a fisheye of this kind.
    Fisheye(Projection),
    /// The view at this place is that of an image with so many more rows or columns, which were cut.
    Cut {
        /// The place of the view.
        at: usize,
        /// Along which side.
        side: Side,
        /// So many before.
        before: Pixels,
        /// So many now.
        now: Pixels,
    },
    /// The equivalent for 35 mm film is counted by the diagonal and by the width.
    Film,
}

/// Why facts give no answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CameraProblem {
    /// No fact says a focal length.
    NothingStated,
    /// The lens at this place says it only with the size of a pixel.
    NoPitch(usize),
    /// The lens is in focus nearer than where anything can be sharp.
    FocusTooNear,
    /// The projection has no such view as the one at this place.
    NoSuchView(usize),
    /// The fact at this place gives no focal length.
    NoFocalLength(usize),
    /// The diagonal of the sensor is shorter than a side.
    ShortDiagonal,
}
