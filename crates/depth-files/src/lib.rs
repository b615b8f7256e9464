//! Reads calibration files: what tools for stereo cameras write, recognized by what is in them, never by their names.
//!
//! ```
//! let file = "cam0=[700 0 320; 0 700 240; 0 0 1]\ncam1=[700 0 320; 0 700 240; 0 0 1]\ndoffs=0\nbaseline=100\nwidth=640\nheight=480\n";
//! let found = depth_files::read(&[file.as_bytes()]).unwrap();
//! assert_eq!(found.baseline.unwrap().length(None).unwrap().m(), 0.1);
//! ```

mod binary;
mod carrier;
mod checks;
mod format;
mod formats;
mod found;
mod geometry;
mod node;
mod number;
mod place;
mod recognize;
mod refusal;
mod sentences;
mod text;
mod xml;
mod yaml;

pub use carrier::LARGEST;
pub use format::Format;
pub use found::{Baseline, Basis, Camera, Found, Guess, Warning};
pub use place::{Origin, Place};
pub use refusal::Refusal;

/// What `files` say together, each the bytes of one: two where a format keeps the cameras apart.
///
/// # Errors
/// A [`Refusal`] that says what was recognized, and what keeps it from being read.
pub fn read(files: &[&[u8]]) -> Result<Found, Refusal> {
    let files = files.iter().enumerate();
    let files = files
        .map(|(file, bytes)| recognize::read(bytes, file))
        .collect::<Result<Vec<_>, _>>()?;
    formats::read(&files)
}
