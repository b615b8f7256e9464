//! Reads calibration files: what tools for stereo cameras write, recognized by what is in them, never by their names. And photographs,
//! whose EXIF says a focal length.
//!
//! ```
//! let file = "cam0=[700 0 320; 0 700 240; 0 0 1]\ncam1=[700 0 320; 0 700 240; 0 0 1]\ndoffs=0\nbaseline=100\nwidth=640\nheight=480\n";
//! let found = depth_files::read(&[file.as_bytes()]).unwrap();
//! assert_eq!(found.baseline.unwrap().length(None).unwrap().m(), 0.1);
//! ```

mod baseline;
mod binary;
mod camera;
mod carrier;
mod checks;
mod choose;
mod format;
mod formats;
mod found;
mod geometry;
mod jpeg;
mod mismatches;
mod node;
mod number;
mod pair;
mod photo;
mod photo_warning;
mod place;
mod recognize;
mod refusal;
mod remarks;
mod sentences;
mod text;
mod tiff;
mod units;
mod warning;
mod xml;
mod yaml;

pub use baseline::{Baseline, Guess};
pub use camera::{Basis, Camera};
pub use carrier::LARGEST;
pub use format::Format;
pub use found::Found;
pub use jpeg::is_jpeg;
pub use pair::Pair;
pub use photo_warning::PhotoWarning;
pub use place::{Origin, Place};
pub use refusal::Refusal;
pub use warning::{Statement, Warning};

/// What `files` say together, each the bytes of one: two where a format keeps the cameras apart.
///
/// # Errors
/// A [`Refusal`] that says what was recognized, and what keeps it from being read.
pub fn read(files: &[&[u8]]) -> Result<Found, Refusal> {
    let mut twice = Vec::new();
    let mut all = Vec::new();
    for (file, bytes) in files.iter().enumerate() {
        if let Some(first) = files.iter().take(file).position(|other| other == bytes) {
            twice.push(Warning::SameFile { files: [first, file] });
            continue;
        }
        let read = recognize::read(bytes, file, &mut twice);
        all.push(read.map_err(|refusal| if files.len() > 1 { refusal.in_file(file) } else { refusal })?);
    }
    let mut found = formats::read(&all)?;
    twice.append(&mut found.warnings);
    found.warnings = twice;
    Ok(found)
}
