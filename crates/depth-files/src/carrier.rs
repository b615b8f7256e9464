//! What the bytes of a file are: text, XML, or something that is known and no calibration.

use crate::binary;
use crate::format::Format;
use crate::formats::FTC_ROOT;
use crate::node::{Node, Value};
use crate::refusal::Refusal;
use crate::xml;

/// No calibration is larger: one with hundreds of cameras has a hundredth of it.
pub const LARGEST: usize = 16 << 20;

/// What a file is written in.
pub(crate) enum File {
    /// Lines of a format that has no other structure.
    Lines(Format, String),
    /// YAML, JSON or XML: each document; or arrays of NumPy.
    Trees(Vec<Node>),
}

/// What a document of XML is, the `file`th.
pub(crate) fn of_xml(text: &str, file: usize) -> Result<File, Refusal> {
    let (root, node) = xml::document(text, file)?;
    let names = |name: &str| node.get(name).is_some();
    match root.as_str() {
        "opencv_storage" if names("imagelist") || names("images") => Err(Refusal::Other {
            what: "a list of images for OpenCV’s calibration, not a calibration",
            todo: "Give the file that the calibration wrote.",
        }),
        "opencv_storage" => Ok(File::Trees(vec![node])),
        FTC_ROOT => {
            let place = node.place;
            let value = Value::Map(vec![(root, node)]);
            Ok(File::Trees(vec![Node { place, value }]))
        }
        _ => Err(Refusal::Unknown),
    }
}

/// The text in `bytes`, with `\n` at the end of each line.
pub(crate) fn text(bytes: &[u8]) -> Result<String, Refusal> {
    if bytes.len() > LARGEST {
        return Err(Refusal::TooLarge);
    }
    if bytes.is_empty() {
        return Err(Refusal::Empty);
    }
    if let Some(refusal) = binary::refusal(bytes) {
        return Err(refusal);
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    Ok(String::from_utf8_lossy(bytes).replace("\r\n", "\n").replace('\r', "\n"))
}
