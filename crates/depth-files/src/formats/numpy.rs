//! NumPy: .npy, an array, and .npz, an archive of some with their names, which are those of OpenCV’s calibration.
//!
//! Source: NumPy’s documentation, `numpy.lib.format`. The header is read by hand: it has three keys that NumPy always writes alike, for which
//! the libraries bring a parser of Python’s literals.

use super::opencv;
use super::opencv_names::is_known;
use super::unnamed::matrices;
use crate::binary::OF_OBJECTS;
use crate::format::Format;
use crate::found::Found;
use crate::node::{Node, Value};
use crate::place::Place;
use crate::refusal::Refusal;
use crate::warning::Warning;
use miniz_oxide::inflate::{TINFLStatus, decompress_to_vec_with_limit};
use rawzip::{CompressionMethod, ZipArchive, ZipSliceArchive};

const FORMAT: Format = Format::NumPy;
const MAGIC: &[u8] = b"\x93NUMPY";
/// So much of a member is unpacked: its header and the numbers of any matrix. A map of the pixels is as well one without the rest of it.
const ENOUGH: usize = 16 << 10;
/// No matrix of a calibration has more numbers.
const MOST_NUMBERS: usize = 100;
/// No archive of a calibration has more arrays.
const MOST_ARRAYS: usize = 200;
/// What an array in a file of its own is called.
pub(super) const OTHER: &str = "an array without a name";

pub(crate) fn is_numpy(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC) || bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(b"PK\x05\x06")
}

/// The arrays of the `file`th file by their names.
pub(crate) fn document(bytes: &[u8], file: usize) -> Result<Node, Refusal> {
    let place = Place { file, line: 0 };
    let arrays = if bytes.starts_with(MAGIC) {
        vec![(OTHER.to_owned(), array(bytes)?)]
    } else {
        arrays(bytes)?
    };
    let has_objects = arrays.iter().any(|(_, array)| matches!(array, Array::Objects));
    let node = map(&arrays, place);
    if has_objects && !is_known(&node) && matrices([&node].into_iter()).is_empty() {
        return Err(Refusal::Other {
            what: "a file of NumPy with Python objects (a pickle), not with numbers",
            todo: OF_OBJECTS,
        });
    }
    Ok(node)
}

pub(super) fn read(documents: &[&Node]) -> Result<Found, Refusal> {
    let mut found = opencv::read(documents).map_err(|refusal| refusal.of(FORMAT))?;
    found.format = FORMAT;
    for warning in &mut found.warnings {
        if let Warning::Raw { format } | Warning::NoBaseline { format } = warning {
            *format = FORMAT;
        }
    }
    Ok(found)
}

/// What was understood of an array.
enum Array {
    /// Its numbers row by row, as text; whether it is more than a single number.
    Numbers { all: Vec<String>, is_list: bool },
    /// Numbers, too many for a matrix, by how many.
    Many(String),
    /// A pickle.
    Objects,
    /// Text or something else.
    Others,
}

/// The arrays as a map.
fn map(arrays: &[(String, Array)], place: Place) -> Node {
    let text = |text: &String| Node {
        place,
        value: Value::Text(text.clone()),
    };
    let entries = arrays.iter().filter_map(|(name, array)| {
        let value = match array {
            Array::Numbers { all, is_list: true } => Value::List(all.iter().map(text).collect()),
            Array::Numbers { all, .. } => Value::Text(all.concat()),
            Array::Many(count) => Value::Text(count.clone()),
            Array::Objects | Array::Others => return None,
        };
        Some((name.clone(), Node { place, value }))
    });
    let value = Value::Map(entries.collect());
    Node { place, value }
}

fn damaged(reason: impl ToString) -> Refusal {
    Refusal::Damaged {
        what: "an archive of NumPy (.npz)",
        reason: reason.to_string().trim_end_matches('.').replace('\n', " "),
    }
}

/// The arrays of an archive.
fn arrays(bytes: &[u8]) -> Result<Vec<(String, Array)>, Refusal> {
    let archive = ZipArchive::from_slice(bytes).map_err(damaged)?;
    let mut entries = archive.entries();
    let mut all = Vec::new();
    while let Some(entry) = entries.next_entry().map_err(damaged)? {
        let name = String::from_utf8_lossy(entry.file_path().as_ref()).into_owned();
        let Some(name) = name.strip_suffix(".npy") else { continue };
        if all.len() >= MOST_ARRAYS {
            return Err(damaged(format!("it has more than {MOST_ARRAYS} arrays")));
        }
        let beginning = beginning(&archive, &entry)?;
        all.push((name.to_owned(), array(&beginning)?));
    }
    if all.is_empty() {
        return Err(Refusal::Binary {
            what: Some("an archive without arrays of NumPy"),
            todo: "Unpack it and give the calibration that is in it.",
        });
    }
    Ok(all)
}

/// What a member of the archive begins with; where that is all of it, its checksum is right.
fn beginning(archive: &ZipSliceArchive<&[u8]>, entry: &rawzip::ZipFileHeaderRecord<'_>) -> Result<Vec<u8>, Refusal> {
    let packed = archive.get_entry(entry.wayfinder()).map_err(damaged)?.data();
    let bytes = match entry.compression_method() {
        CompressionMethod::STORE => packed.get(..ENOUGH).unwrap_or(packed).to_vec(),
        CompressionMethod::DEFLATE => decompress_to_vec_with_limit(packed, ENOUGH).or_else(|error| match error.status {
            TINFLStatus::HasMoreOutput => Ok(error.output),
            _ => Err(damaged("its data do not unpack")),
        })?,
        _ => return Err(damaged("it is compressed in a way that NumPy does not use")),
    };
    let is_whole = u64::try_from(bytes.len()) == Ok(entry.uncompressed_size_hint());
    if is_whole && rawzip::crc32(&bytes) != entry.crc32() {
        return Err(damaged("a checksum is wrong"));
    }
    Ok(bytes)
}

/// What the header of an array says.
struct Header {
    /// As `<f8`; empty for a list of columns.
    kind: String,
    is_fortran: bool,
    shape: Vec<usize>,
}

/// An array of which `bytes` are the beginning.
fn array(bytes: &[u8]) -> Result<Array, Refusal> {
    let broken = |reason: &str| Refusal::Damaged {
        what: "an array of NumPy",
        reason: reason.to_owned(),
    };
    let (header, data) = split(bytes).ok_or_else(|| broken("it has no header"))?;
    let Header { kind, is_fortran, shape } = self::header(header).ok_or_else(|| broken("its header cannot be read"))?;
    if kind.ends_with('O') {
        return Ok(Array::Objects);
    }
    let Some((is_big, code)) = number_kind(&kind) else {
        return Ok(Array::Others);
    };
    let count = shape.iter().try_fold(1_usize, |count, side| count.checked_mul(*side));
    let Some(count) = count.filter(|count| *count <= MOST_NUMBERS) else {
        let sides: Vec<String> = shape.iter().map(ToString::to_string).collect();
        return Ok(Array::Many(format!("{} numbers", sides.join(" × "))));
    };
    let size = usize::from(code.1 - b'0');
    let all: Option<Vec<String>> = (0..count)
        .map(|index| {
            let at = if is_fortran { fortran(index, &shape) } else { index };
            let from = at.checked_mul(size)?;
            number(data.get(from..from.checked_add(size)?)?, is_big, code)
        })
        .collect();
    let all = all.ok_or_else(|| broken("it ends before its last number"))?;
    let is_list = !shape.is_empty();
    Ok(Array::Numbers { all, is_list })
}

/// The header and what follows it.
fn split(bytes: &[u8]) -> Option<(&str, &[u8])> {
    let (length, rest) = match bytes.strip_prefix(MAGIC)? {
        [1, _, a, b, rest @ ..] => (u32::from(u16::from_le_bytes([*a, *b])), rest),
        [2 | 3, _, a, b, c, d, rest @ ..] => (u32::from_le_bytes([*a, *b, *c, *d]), rest),
        _ => return None,
    };
    let (header, data) = rest.split_at_checked(usize::try_from(length).ok()?)?;
    Some((std::str::from_utf8(header).ok()?, data))
}

/// `{'descr': '<f8', 'fortran_order': False, 'shape': (3, 3), }`.
fn header(text: &str) -> Option<Header> {
    let after = |key: &str| text.split_once(key).map(|(_, rest)| rest.trim_start());
    let kind = after("'descr':")?;
    let kind = kind.strip_prefix('\'').and_then(|rest| rest.split('\'').next()).unwrap_or_default();
    let is_fortran = after("'fortran_order':")?.starts_with("True");
    let shape = after("'shape':")?.strip_prefix('(')?.split_once(')')?.0;
    let sides = shape.split(',').map(str::trim).filter(|side| !side.is_empty());
    // Python 2 wrote long numbers with an L.
    let shape = sides
        .map(|side| side.trim_end_matches('L').parse().ok())
        .collect::<Option<Vec<usize>>>()?;
    let kind = kind.to_owned();
    Some(Header { kind, is_fortran, shape })
}

/// Whether the bytes of a number begin with the highest, and its letter with the digit of how many they are.
fn number_kind(kind: &str) -> Option<(bool, (u8, u8))> {
    match kind.as_bytes() {
        [order @ (b'<' | b'>' | b'|' | b'='), letter, digit] => {
            let is_known = matches!(
                (letter, digit),
                (b'f', b'4' | b'8') | (b'i' | b'u', b'1' | b'2' | b'4' | b'8') | (b'b', b'1')
            );
            is_known.then_some((*order == b'>', (*letter, *digit)))
        }
        _ => None,
    }
}

/// Where the number stands column by column that is the `index`th row by row.
fn fortran(mut index: usize, shape: &[usize]) -> usize {
    let strides = shape.iter().scan(1, |stride, side| {
        let now = *stride;
        *stride *= side;
        Some(now)
    });
    let strides: Vec<usize> = strides.collect();
    let mut at = 0;
    for (side, stride) in shape.iter().zip(strides).rev() {
        at += index % side * stride;
        index /= side;
    }
    at
}

/// A number as text, exactly.
fn number(bytes: &[u8], is_big: bool, code: (u8, u8)) -> Option<String> {
    let mut all = bytes.to_vec();
    if is_big {
        all.reverse();
    }
    let text = match (code, all.as_slice()) {
        ((b'f', _), &[a, b, c, d]) => f64::from(f32::from_le_bytes([a, b, c, d])).to_string(),
        ((b'f', _), &[a, b, c, d, e, f, g, h]) => f64::from_le_bytes([a, b, c, d, e, f, g, h]).to_string(),
        ((b'i', _), &[a]) => i8::from_le_bytes([a]).to_string(),
        ((b'i', _), &[a, b]) => i16::from_le_bytes([a, b]).to_string(),
        ((b'i', _), &[a, b, c, d]) => i32::from_le_bytes([a, b, c, d]).to_string(),
        ((b'i', _), &[a, b, c, d, e, f, g, h]) => i64::from_le_bytes([a, b, c, d, e, f, g, h]).to_string(),
        (_, &[a]) => a.to_string(),
        (_, &[a, b]) => u16::from_le_bytes([a, b]).to_string(),
        (_, &[a, b, c, d]) => u32::from_le_bytes([a, b, c, d]).to_string(),
        (_, &[a, b, c, d, e, f, g, h]) => u64::from_le_bytes([a, b, c, d, e, f, g, h]).to_string(),
        _ => return None,
    };
    Some(text)
}
