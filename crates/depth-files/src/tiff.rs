//! TIFF: the tags of an EXIF block.
//!
//! Source: TIFF 6.0, “Image File Header” and “Image File Directory”. It is read by hand, for a dozen tags: `kamadak-exif` 0.6.2 keeps every
//! entry of every directory, also where they overlap, and takes 576 MB for a block of 65 KB that was made for that.

/// A block of TIFF.
pub(crate) struct Tiff<'a> {
    bytes: &'a [u8],
    is_big: bool,
    /// Where its first directory begins.
    first: usize,
}

/// A number as it is written, n/d: d is 1 where it is a whole one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rational {
    pub(crate) numerator: f64,
    pub(crate) denominator: f64,
}

impl Rational {
    /// What it is; `None` where it is unknown, which is written as 0 or as 0/0, and where it is infinite, written as 2³² − 1.
    pub(crate) fn positive(self) -> Option<f64> {
        let is_infinite = self.numerator >= f64::from(u32::MAX);
        let value = self.numerator / self.denominator;
        (value.is_finite() && value > 0.0 && !is_infinite).then_some(value)
    }
}

/// No camera writes more tags into a directory.
const MOST_ENTRIES: usize = 1000;
/// So many letters of a name are read.
const MOST_LETTERS: usize = 64;

/// A directory, by where it begins.
#[derive(Clone, Copy)]
pub(crate) struct Directory(usize);

/// Bytes of a value of this type; `None` of one that there is not.
const fn bytes_of(kind: u16) -> Option<usize> {
    match kind {
        1 | 2 | 6 | 7 => Some(1),
        3 | 8 => Some(2),
        4 | 9 | 11 => Some(4),
        5 | 10 | 12 => Some(8),
        _ => None,
    }
}

/// The type of a value, how many there are of it, and where the first stands.
struct Entry {
    kind: u16,
    count: usize,
    at: usize,
}

impl<'a> Tiff<'a> {
    /// `None` where the bytes are not TIFF.
    pub(crate) fn of(bytes: &'a [u8]) -> Option<Self> {
        let is_big = match bytes {
            [b'I', b'I', 42, 0, ..] => false,
            [b'M', b'M', 0, 42, ..] => true,
            _ => return None,
        };
        let mut tiff = Self { bytes, is_big, first: 0 };
        tiff.first = tiff.offset(4)?;
        tiff.u16(tiff.first)?;
        Some(tiff)
    }

    pub(crate) const fn first(&self) -> Directory {
        Directory(self.first)
    }

    /// The directory to which `tag` points.
    pub(crate) fn directory(&self, directory: Directory, tag: u16) -> Option<Directory> {
        let entry = self.entry(directory, tag)?;
        self.offset(entry.at).map(Directory)
    }

    /// The number of `tag`, the first where there are several.
    pub(crate) fn number(&self, directory: Directory, tag: u16) -> Option<Rational> {
        let Entry { kind, count, at } = self.entry(directory, tag)?;
        let (numerator, denominator) = match kind {
            _ if count == 0 => return None,
            1 => (f64::from(*self.bytes.get(at)?), 1.0),
            3 => (f64::from(self.u16(at)?), 1.0),
            4 => (f64::from(self.u32(at)?), 1.0),
            5 => (f64::from(self.u32(at)?), f64::from(self.u32(at.checked_add(4)?)?)),
            9 => (f64::from(self.u32(at)?.cast_signed()), 1.0),
            10 => {
                let signed = |at| Some(f64::from(self.u32(at)?.cast_signed()));
                (signed(at)?, signed(at.checked_add(4)?)?)
            }
            _ => return None,
        };
        Some(Rational { numerator, denominator })
    }

    /// The number of `tag` where it is a whole one.
    pub(crate) fn whole(&self, directory: Directory, tag: u16) -> Option<u32> {
        let Entry { kind, count, at } = self.entry(directory, tag)?;
        match kind {
            _ if count == 0 => None,
            3 => self.u16(at).map(u32::from),
            4 => self.u32(at),
            _ => None,
        }
    }

    /// The text of `tag`, without blanks around it; `None` where there is nothing else.
    pub(crate) fn text(&self, directory: Directory, tag: u16) -> Option<String> {
        let Entry { kind: 2, count, at } = self.entry(directory, tag)? else {
            return None;
        };
        let bytes = self.bytes.get(at..at.checked_add(count)?)?;
        let bytes = bytes.split(|byte| *byte == 0).next()?;
        let text = String::from_utf8_lossy(bytes.get(..MOST_LETTERS).unwrap_or(bytes));
        let text = text.trim();
        (!text.is_empty()).then(|| text.to_owned())
    }

    fn entry(&self, directory: Directory, tag: u16) -> Option<Entry> {
        let Directory(begin) = directory;
        let count = usize::from(self.u16(begin)?).min(MOST_ENTRIES);
        let mut places = (0..count).map_while(|number| begin.checked_add(2 + 12 * number));
        let place = places.find(|at| self.u16(*at) == Some(tag))?;
        let kind = self.u16(place.checked_add(2)?)?;
        let count = self.offset(place.checked_add(4)?)?;
        let at = place.checked_add(8)?;
        let bytes = count.checked_mul(bytes_of(kind)?)?;
        // What is longer than its place stands elsewhere, and its place says where.
        let at = if bytes <= 4 { at } else { self.offset(at)? };
        Some(Entry { kind, count, at })
    }

    fn u16(&self, at: usize) -> Option<u16> {
        let two = *self.bytes.get(at..)?.first_chunk::<2>()?;
        Some(if self.is_big {
            u16::from_be_bytes(two)
        } else {
            u16::from_le_bytes(two)
        })
    }

    fn u32(&self, at: usize) -> Option<u32> {
        let four = *self.bytes.get(at..)?.first_chunk::<4>()?;
        Some(if self.is_big {
            u32::from_be_bytes(four)
        } else {
            u32::from_le_bytes(four)
        })
    }

    fn offset(&self, at: usize) -> Option<usize> {
        usize::try_from(self.u32(at)?).ok()
    }
}
