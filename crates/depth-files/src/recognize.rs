//! What a file is written in, by what is in it.

use crate::carrier::{File, LARGEST, of_xml, text};
use crate::format::Format;
use crate::formats::{is_bouguet, is_colmap, is_foundation_stereo, is_kitti, is_numpy, is_realsense, numpy};
use crate::refusal::Refusal;
use crate::text::lines;
use crate::yaml;

/// What `bytes` are, which are the `file`th.
pub(crate) fn read(bytes: &[u8], file: usize) -> Result<File, Refusal> {
    if is_numpy(bytes) && bytes.len() <= LARGEST {
        return Ok(File::Trees(vec![numpy(bytes, file)?]));
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
    let documents = yaml::documents(&text, file)?;
    // Prose is a text of YAML.
    if documents.iter().any(|document| document.text().is_none()) {
        Ok(File::Trees(documents))
    } else {
        Err(Refusal::Unknown)
    }
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
