//! What the bytes of a file are: text, XML, or something that is known and no calibration.

use crate::binary;
use crate::format::Format;
use crate::node::{Node, Value};
use crate::photo::Photo;
use crate::refusal::Refusal;
use crate::xml;

/// No file is larger in which somebody keeps a calibration, whatever else is in it. A photograph may be: only what is before its pixels is
/// looked at.
pub const LARGEST: usize = 16 << 20;
/// No calibration in text is larger: one with hundreds of cameras has a tenth of it.
const LARGEST_TEXT: usize = 4 << 20;

const TOO_LARGE: Refusal = Refusal::TooLarge {
    megabytes: LARGEST_TEXT >> 20,
};

/// The first element of a file of FTC.
pub(crate) const FTC_ROOT: &str = "Calibrations";

/// What a file is written in.
pub(crate) enum File {
    /// Lines of a format that has no other structure.
    Lines(Format, String),
    /// YAML, JSON or XML: each document; or arrays of NumPy.
    Trees(Vec<Node>),
    /// A photograph with EXIF.
    Photo(Photo),
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
        return Err(Refusal::TooLarge { megabytes: LARGEST >> 20 });
    }
    if bytes.is_empty() {
        return Err(Refusal::Empty);
    }
    if let Some(text) = utf_16(bytes)? {
        return Ok(with_plain_ends(text));
    }
    if let Some(refusal) = binary::refusal(bytes) {
        return Err(refusal);
    }
    if bytes.len() > LARGEST_TEXT {
        return Err(TOO_LARGE);
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    Ok(with_plain_ends(String::from_utf8_lossy(bytes).into_owned()))
}

fn with_plain_ends(text: String) -> String {
    if text.contains('\r') {
        text.replace("\r\n", "\n").replace('\r', "\n")
    } else {
        text
    }
}

/// The text of a file that says by its first two bytes that it is in UTF-16, as PowerShell and Notepad write.
fn utf_16(bytes: &[u8]) -> Result<Option<String>, Refusal> {
    let (pair, rest): (fn([u8; 2]) -> u16, _) = match bytes {
        [0xff, 0xfe, rest @ ..] => (u16::from_le_bytes, rest),
        [0xfe, 0xff, rest @ ..] => (u16::from_be_bytes, rest),
        _ => return Ok(None),
    };
    if rest.len() > 2 * LARGEST_TEXT {
        return Err(TOO_LARGE);
    }
    let (units, _) = rest.as_chunks::<2>();
    let text: String = char::decode_utf16(units.iter().map(|unit| pair(*unit)))
        .map(|one| one.unwrap_or(char::REPLACEMENT_CHARACTER))
        .collect();
    Ok(Some(text).filter(|text| !text.contains('\0')))
}
