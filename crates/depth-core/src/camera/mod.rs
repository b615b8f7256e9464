//! Where a camera's numbers come from, and where a pixel lies in space.
//!
//! A pinhole camera: x to the right, y down, z along the optical axis; pixel coordinates with the origin in the center of
//! the first pixel, as OpenCV has them.
//!
//! `None` from a function here means: an input is not positive, or the result cannot be represented.

mod facts;
mod facts_solved;
mod film;
mod focal_length;
mod ground;
mod intrinsics;
mod point;
mod projection;
mod sensor;
mod tilt;

pub use facts::{CameraAnswer, CameraFacts, CameraProblem, CameraRemark, Cause, Fact};
pub use film::{FilmExtent, focal_length_under_water, focused_image_distance, focused_lens};
pub use focal_length::{
    diagonal, focal_length_from_field_of_view, focal_length_from_multiple, focal_length_from_pixel_pitch,
    focal_length_from_reference_photo, focal_length_from_sensor_width, resized_focal_length,
};
pub use ground::{BelowAxis, GroundSolution, GroundView, RightOfAxis};
pub use intrinsics::{Intrinsics, OnSensor, field_of_view, pixel_size, subtended_angle};
pub use point::{Along, PointSolution, PointView};
pub use projection::Projection;
pub use sensor::{Sensor, SensorRemark, ShortDiagonal, Side};
pub use tilt::foreshortened;
