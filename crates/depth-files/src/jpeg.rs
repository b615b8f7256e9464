//! JPEG: the segments before the pixels, which say how large the picture is, and hold its EXIF. The pixels are not looked at.
//!
//! Source: ITU-T T.81 (JPEG), annex B; CIPA DC-008 (Exif), 4.7.2: EXIF is in an APP1, which begins with `Exif` and two zeros.

/// What the segments say.
pub(crate) struct Jpeg<'a> {
    /// Width and height in pixels, as they are stored.
    pub(crate) size: Option<[u32; 2]>,
    /// EXIF, a block of TIFF.
    pub(crate) exif: Option<&'a [u8]>,
}

const EXIF: &[u8] = b"Exif\0";

/// Whether a file that begins so is a JPEG. What it says of its camera stands before its pixels: of one larger than
/// [`LARGEST`](crate::LARGEST) the beginning is enough.
pub fn is_jpeg(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\xff\xd8\xff")
}

/// What the segments of `bytes` say up to the pixels, or to where they end too early.
pub(crate) fn segments(bytes: &[u8]) -> Jpeg<'_> {
    let mut found = Jpeg { size: None, exif: None };
    let mut rest = bytes.get(2..).unwrap_or_default();
    while let Some((marker, payload, behind)) = next(rest) {
        match marker {
            0xe1 if found.exif.is_none() => {
                // Some write another byte than a zero as the second.
                found.exif = payload.strip_prefix(EXIF).and_then(|exif| exif.get(1..));
            }
            0xc0..=0xcf if ![0xc4, 0xc8, 0xcc].contains(&marker) && found.size.is_none() => found.size = size(payload),
            _ => {}
        }
        rest = behind;
    }
    found
}

/// The marker of a segment, what is in it and what is behind it; `None` where the pixels begin, or the bytes end.
fn next(mut rest: &[u8]) -> Option<(u8, &[u8], &[u8])> {
    loop {
        // Bytes that belong to no segment are skipped, as libjpeg does.
        let at = rest.iter().position(|byte| *byte == 0xff)?;
        rest = rest.get(at + 1..)?;
        let marker = *rest.first()?;
        match marker {
            // Filled with 0xff, and markers that stand alone.
            0xff => {}
            0x00 | 0x01 | 0xd0..=0xd8 => rest = rest.get(1..)?,
            0xd9 | 0xda => return None,
            _ => break,
        }
    }
    let [marker, high, low, payload @ ..] = rest else { return None };
    let length = usize::from(u16::from_be_bytes([*high, *low])).checked_sub(2)?;
    let (payload, behind) = payload.split_at_checked(length)?;
    Some((*marker, payload, behind))
}

/// Precision, height and width. A height of zero is said behind the pixels, which no camera does.
fn size(frame: &[u8]) -> Option<[u32; 2]> {
    let [_, a, b, c, d, ..] = frame else { return None };
    let size = [[*c, *d], [*a, *b]].map(|side| u32::from(u16::from_be_bytes(side)));
    (!size.contains(&0)).then_some(size)
}
