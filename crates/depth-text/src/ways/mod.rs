//! The ways to a number that is not known as such: a focal length from a lens, a field of view or a photograph; a disparity
//! or doffs from what a program stored.
//!
//! A [`Way`] is a row of a table. Those that decode what is [stored](Stored) are the ones of the command line too, which has
//! [names](ENCODING_NAMES) for them.

mod camera;
mod disparity;
mod encoding_names;
mod stored;
mod way;

pub use camera::{BASELINES, FOCAL_LENGTHS};
pub use disparity::DISPARITIES;
pub use encoding_names::{ENCODING_NAMES, EncodingName};
pub use stored::{Decoded, NotStored, Stored, Values};
pub use way::{Way, WayResult};
pub(crate) use way::{degrees_or_radians, may_be_radians};
