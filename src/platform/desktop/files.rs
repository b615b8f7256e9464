//! Files that the program gives out, into the folder for downloads, never over another; and files that it is given.

use crate::app::{FileContents, OpenedFile, PlatformError};
use depth_jobs::{LARGEST_FILE, MOST_FILES, is_photograph};
use std::borrow::Cow;
use std::fs::{self, File};
use std::io::{Error, ErrorKind, Read as _, Write as _};
use std::path::{Path, PathBuf};

/// Nobody has more files of one name.
const MOST: u32 = 10_000;

/// The person's folder for downloads, else the home folder.
///
/// # Errors
/// [`PlatformError::NoHomeFolder`].
pub fn folder() -> Result<PathBuf, PlatformError> {
    let folders = directories::UserDirs::new().ok_or(PlatformError::NoHomeFolder)?;
    Ok(folders.download_dir().unwrap_or_else(|| folders.home_dir()).to_owned())
}

/// What these files hold.
///
/// # Errors
/// Why one of them cannot be read: then none is.
pub fn read(paths: &[PathBuf]) -> Result<Vec<OpenedFile>, PlatformError> {
    let files = paths.iter().take(MOST_FILES + 1).map(|path| read_one(path));
    let mut opened = Vec::new();
    for file in files {
        opened.push(file?);
        if opened.len() > MOST_FILES || opened.iter().map(|file| file.bytes.len()).sum::<usize>() > LARGEST_FILE {
            return Err(PlatformError::TooManyFiles);
        }
    }
    Ok(opened)
}

fn read_one(path: &Path) -> Result<OpenedFile, PlatformError> {
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
    let refused = |error: &Error| PlatformError::FileNotOpened {
        file: name.clone(),
        reason: error.to_string(),
    };
    let mut bytes = Vec::new();
    // One byte more tells whether there is more.
    let most = u64::try_from(LARGEST_FILE).unwrap_or(u64::MAX).saturating_add(1);
    let file = File::open(path).map_err(|error| refused(&error))?;
    file.take(most).read_to_end(&mut bytes).map_err(|error| refused(&error))?;
    if bytes.len() > LARGEST_FILE && is_photograph(&bytes) {
        bytes.truncate(LARGEST_FILE);
    } else if bytes.len() > LARGEST_FILE {
        return Err(PlatformError::FileTooLarge { file: name });
    }
    Ok(OpenedFile { name, bytes })
}

/// Writes a file with this name into `folder`, or one with a number where that is taken. Returns where it is.
///
/// # Errors
/// Why it cannot be written; there is then no part of it.
pub fn save(folder: &Path, name: &str, contents: &FileContents) -> Result<PathBuf, PlatformError> {
    let bytes = match contents {
        FileContents::Picture(picture) => Cow::Owned(png(picture).map_err(|error| PlatformError::NoPng { reason: error.to_string() })?),
        FileContents::Page(text) | FileContents::Data(text) => Cow::Borrowed(text.as_bytes()),
    };
    let refused = |file: &Path, error: &Error| PlatformError::NotSaved {
        file: file.to_owned(),
        reason: error.to_string(),
    };
    fs::create_dir_all(folder).map_err(|error| refused(folder, &error))?;
    for number in 1..=MOST {
        let path = numbered(folder, name, number);
        match File::create_new(&path) {
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            Err(error) => return Err(refused(&path, &error)),
            Ok(mut file) => {
                if let Err(error) = file.write_all(&bytes) {
                    fs::remove_file(&path).ok();
                    return Err(refused(&path, &error));
                }
                return Ok(path);
            }
        }
    }
    Err(refused(&numbered(folder, name, MOST), &ErrorKind::AlreadyExists.into()))
}

/// "top-view.png", "top-view-2.png" and so on.
fn numbered(folder: &Path, name: &str, number: u32) -> PathBuf {
    match name.rsplit_once('.') {
        Some((stem, ending)) if number > 1 => folder.join(format!("{stem}-{number}.{ending}")),
        _ => folder.join(name),
    }
}

/// `picture` as PNG, without its transparency.
fn png(picture: &egui::ColorImage) -> Result<Vec<u8>, png::EncodingError> {
    let [width, height] = picture.size.map(|pixels| u32::try_from(pixels).unwrap_or(u32::MAX));
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let pixels: Vec<u8> = picture.pixels.iter().flat_map(|pixel| [pixel.r(), pixel.g(), pixel.b()]).collect();
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&pixels)?;
    writer.finish()?;
    Ok(bytes)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use egui::{Color32, ColorImage};

    /// An empty folder of this test alone.
    fn empty_folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("depth-calculator-{}-{name}", std::process::id()));
        fs::remove_dir_all(&folder).ok();
        folder
    }

    #[test]
    fn a_file_never_takes_the_place_of_another() {
        let folder = empty_folder("names");
        let page = |text: &str| FileContents::Page(text.to_owned());
        let first = save(&folder, "report.html", &page("first")).unwrap();
        let second = save(&folder, "report.html", &page("second")).unwrap();
        assert_eq!([&first, &second], [&folder.join("report.html"), &folder.join("report-2.html")]);
        assert_eq!([first, second].map(|file| fs::read_to_string(file).unwrap()), ["first", "second"]);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_picture_is_written_pixel_for_pixel() {
        let folder = empty_folder("pixels");
        let mut picture = ColorImage::filled([3, 2], Color32::WHITE);
        *picture.pixels.last_mut().unwrap() = Color32::from_rgb(1, 2, 3);
        let file = save(&folder, "chart.png", &FileContents::Picture(picture)).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(fs::read(file).unwrap()))
            .read_info()
            .unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut pixels).unwrap();
        assert_eq!((info.width, info.height), (3, 2));
        assert_eq!(pixels.last_chunk(), Some(&[1, 2, 3]));
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn files_are_read_whole_or_named() {
        let folder = empty_folder("open");
        fs::create_dir_all(&folder).unwrap();
        let [good, large] = ["calib.txt", "video.mp4"].map(|name| folder.join(name));
        fs::write(&good, "doffs=0").unwrap();
        File::create(&large)
            .unwrap()
            .set_len(u64::try_from(LARGEST_FILE).unwrap() + 1)
            .unwrap();
        let opened = read(std::slice::from_ref(&good)).unwrap();
        assert_eq!(
            opened,
            [OpenedFile {
                name: "calib.txt".into(),
                bytes: b"doffs=0".to_vec()
            }]
        );
        assert_eq!(
            read(&[good.clone(), large]).unwrap_err(),
            PlatformError::FileTooLarge { file: "video.mp4".into() }
        );
        let photo = folder.join("photo.jpg");
        File::create(&photo).unwrap().write_all(&[0xff, 0xd8, 0xff, 0xe1]).unwrap();
        let whole = u64::try_from(LARGEST_FILE).unwrap() + 100;
        File::options().write(true).open(&photo).unwrap().set_len(whole).unwrap();
        let opened = read(std::slice::from_ref(&photo)).unwrap();
        assert_eq!(
            opened.first().map(|file| file.bytes.len()),
            Some(LARGEST_FILE),
            "its head is enough"
        );
        assert_eq!(read(&vec![good.clone(); MOST_FILES + 1]).unwrap_err(), PlatformError::TooManyFiles);
        for gone in [folder.join("gone.yaml"), folder.clone()] {
            assert!(matches!(read(&[good.clone(), gone]), Err(PlatformError::FileNotOpened { .. })));
        }
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_folder_that_cannot_be_written_is_named() {
        let folder = empty_folder("file");
        fs::write(&folder, "no folder").unwrap();
        let error = save(&folder, "report.html", &FileContents::Page(String::new())).unwrap_err();
        assert!(matches!(&error, PlatformError::NotSaved { file, .. } if *file == folder), "{error}");
        fs::remove_file(folder).unwrap();
    }
}
