//! Comparing an image with the one in `snapshots/`, where `renderer.txt` says what drew them.

use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{Rgb, RgbImage};
use std::path::{Path, PathBuf};

/// How far a red, green or blue of 0 to 255 may be off: 1 is another processor's rounding, 2 is another color.
const TOLERANCE: u8 = 1;
/// In it stands what drew the images.
const RENDERER: &str = "renderer.txt";
const HOW_TO_ACCEPT: &str = "If the screens should look like this now: UPDATE_SNAPSHOTS=1 cargo test --locked --test screens look";

fn is_updating() -> bool {
    std::env::var_os("UPDATE_SNAPSHOTS").is_some_and(|value| !value.is_empty() && value != "0")
}

/// Compares what `renderer` drew with the image of that name, or puts it in its place if that is asked for. Err: what is
/// different, and where to look.
pub fn compare(new: &RgbImage, name: &str, renderer: &str) -> Result<(), String> {
    let file = snapshots().join(format!("{name}.png"));
    let [new_file, marked_file] = ["new", "marked"].map(|kind| output_folder().join(format!("{name}.{kind}.png")));
    for old_output in [&new_file, &marked_file] {
        let _ = std::fs::remove_file(old_output);
    }
    let problem = match image::open(&file) {
        Err(error) => format!("it cannot be read: {error}"),
        Ok(old) => match differences(&old.to_rgb8(), new) {
            Ok((0, _)) => return Ok(()),
            Ok((count, marked)) => {
                save(&marked, &marked_file);
                format!("{count} pixels differ, marked in {}", marked_file.display())
            }
            Err(sizes) => sizes,
        },
    };
    if is_updating() {
        save(new, &file);
        std::fs::write(snapshots().join(RENDERER), format!("{renderer}\n")).unwrap();
        return Ok(());
    }
    save(new, &new_file);
    Err(format!("{name}: {problem}. New: {}", new_file.display()))
}

/// How many pixels differ, and the old image, faint, with these in red. Err: the sizes, where they differ.
fn differences(old: &RgbImage, new: &RgbImage) -> Result<(usize, RgbImage), String> {
    if old.dimensions() != new.dimensions() {
        return Err(format!("it was {:?} large and is {:?}", old.dimensions(), new.dimensions()));
    }
    let mut count = 0;
    let mut marked = old.clone();
    for (marked, new) in marked.pixels_mut().zip(new.pixels()) {
        let differs = marked.0.iter().zip(new.0).any(|(old, new)| old.abs_diff(new) > TOLERANCE);
        count += usize::from(differs);
        *marked = if differs {
            Rgb([255, 0, 0])
        } else {
            Rgb(marked.0.map(|value| 192 + value / 4))
        };
    }
    Ok((count, marked))
}

/// Fails with all that [`compare`] found in what `renderer` drew.
pub fn report(problems: &[String], renderer: &str) {
    if problems.is_empty() {
        return;
    }
    let drew = std::fs::read_to_string(snapshots().join(RENDERER)).unwrap_or_default();
    let drew = drew.trim();
    let versions = if drew == renderer {
        String::new()
    } else {
        format!("The images to compare with were drawn by {drew}, the new ones by {renderer}.\n")
    };
    panic!("\n{}\n{versions}{HOW_TO_ACCEPT}", problems.join("\n"));
}

/// Writes a small file: for flat areas and letters no filter is the best one.
fn save(image: &RgbImage, file: &Path) {
    let to = std::io::BufWriter::new(std::fs::File::create(file).unwrap());
    let encoder = PngEncoder::new_with_quality(to, CompressionType::Best, FilterType::NoFilter);
    image.write_with_encoder(encoder).unwrap();
}

fn snapshots() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/screens/snapshots")
}

/// Where it is left what differs.
pub fn output_folder() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("screens");
    std::fs::create_dir_all(&folder).unwrap();
    folder
}
