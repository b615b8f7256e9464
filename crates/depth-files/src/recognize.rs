//! What a file is written in, by what is in it.

use crate::carrier::{File, LARGEST, of_xml, text};
use crate::format::Format;
use crate::formats::{is_bouguet, is_colmap, is_foundation_stereo, is_kitti, is_numpy, is_realsense, numpy};
use crate::jpeg::is_jpeg;
use crate::photo::photo;
use crate::refusal::Refusal;
use crate::text::lines;
use crate::warning::Warning;
use crate::yaml;

/// What `bytes` are, which are the `file`th. What is to be said of them is added to `warnings`.
pub(crate) fn read(bytes: &[u8], file: usize, warnings: &mut Vec<Warning>) -> Result<File, Refusal> {
    if is_numpy(bytes) && bytes.len() <= LARGEST {
        return Ok(File::Trees(vec![numpy(bytes, file)?]));
    }
    if is_jpeg(bytes) {
        return photo(bytes, file).map(File::Photo);
    }
    let text = text(bytes)?;
    let start = text.trim_start();
    if start.is_empty() {
        return Err(Refusal::Empty);
    }
    let lower: String = start.chars().take(200).collect::<String>().to_ascii_lowercase();
    if lower.starts_with("<!doctype html") || lower.starts_with("<html") {
        return Err(Refusal::Other {
            what: "a web page, not a calibration",
            todo: "Download the file itself.",
        });
    }
    if lower.contains("no device detected") {
        return Err(Refusal::Other {
            what: "what rs-enumerate-devices prints without a device",
            todo: "Plug the camera in and run it again.",
        });
    }
    if start.starts_with('<') {
        return of_xml(start, file);
    }
    if let Some(format) = of_lines(&text) {
        return Ok(File::Lines(format, text));
    }
    let documents = yaml::documents(&text, file, warnings).map_err(|refusal| match refusal {
        // Of a text about something else it is not said which line of it is no YAML.
        Refusal::Syntax { .. } if !may_be_calibration(&text) => Refusal::Unknown,
        refusal => refusal,
    })?;
    // Prose is a text of YAML.
    if documents.iter().any(|document| document.text().is_none()) {
        Ok(File::Trees(documents))
    } else {
        Err(Refusal::Unknown)
    }
}

/// What stands in every calibration in some spelling.
const WORDS: [&str; 12] = [
    "cam",
    "matri",
    "intrinsic",
    "distort",
    "baseline",
    "data",
    "fx",
    "focal",
    "width",
    "proj",
    "opencv",
    "extrinsic",
];

/// Whether a key is that of a matrix, such as K or M1, or of a part of one.
fn is_letter(key: &str) -> bool {
    key.len() <= 2 && (key.starts_with(['k', 'd', 'p', 'r', 't', 'q', 'f', 'm']) || ["cx", "cy"].contains(&key))
}

/// Whether a line begins with a key that a calibration may have.
fn may_be_calibration(text: &str) -> bool {
    let is_key = |line: &str| {
        let Some((key, _)) = line.split_once([':', '=']) else {
            return false;
        };
        let key = key.trim_matches(|one: char| !one.is_ascii_alphanumeric()).to_ascii_lowercase();
        let is_word = !key.contains(char::is_whitespace);
        is_word && !key.is_empty() && (is_letter(&key) || WORDS.iter().any(|word| key.contains(word)))
    };
    text.trim_start().starts_with(['{', '[', '%']) || text.lines().any(is_key)
}

/// The format of a file of lines, by the first line that only it has.
fn of_lines(text: &str) -> Option<Format> {
    let all = lines(text).map(|line| line.text);
    let begins = |starts: &dyn Fn(&str) -> bool| all.clone().any(starts);
    // What tells formats apart stands at the beginning.
    let compact = |line: &str| {
        line.chars()
            .filter(|one| *one != ' ')
            .take(20)
            .collect::<String>()
            .to_ascii_lowercase()
    };
    if is_realsense(text) {
        return Some(Format::RealSense);
    }
    if begins(&|line| line.starts_with("# oST version")) {
        return Some(Format::Ros);
    }
    if begins(&|line| compact(line).starts_with("[left_cam_") || compact(line).starts_with("[right_cam_")) {
        return Some(Format::Zed);
    }
    if begins(&|line| compact(line).starts_with("cam0=[")) {
        return Some(Format::Middlebury);
    }
    if is_kitti(text) {
        return Some(Format::Kitti);
    }
    if is_foundation_stereo(text) {
        return Some(Format::FoundationStereo);
    }
    if is_bouguet(text) {
        return Some(Format::Bouguet);
    }
    is_colmap(text).then_some(Format::Colmap)
}
