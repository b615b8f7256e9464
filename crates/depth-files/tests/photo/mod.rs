//! JPEGs as cameras write them, but without pixels: written by hand, from ITU-T T.81 and TIFF 6.0.

#![allow(dead_code, reason = "tests, of which each uses some of it")]

/// A value of a tag.
#[derive(Clone)]
pub enum Value {
    Short(u16),
    Shorts(Vec<u16>),
    Long(u32),
    Rational(u32, u32),
    Text(&'static str),
}

use Value::{Long, Rational, Short, Shorts, Text};

/// A photograph, with what its EXIF says.
#[derive(Clone)]
pub struct Photo {
    pub is_big_endian: bool,
    /// Width and height as the frame says them.
    pub size: [u16; 2],
    /// Tags of the first directory.
    pub first: Vec<(u16, Value)>,
    /// Tags of the EXIF directory.
    pub exif: Vec<(u16, Value)>,
}

pub const ORIENTATION: u16 = 0x0112;
pub const FOCAL_LENGTH: u16 = 0x920a;
pub const FILM: u16 = 0xa405;
pub const PLANE_X: u16 = 0xa20e;
pub const PLANE_Y: u16 = 0xa20f;
pub const PLANE_UNIT: u16 = 0xa210;
pub const TAKEN_X: u16 = 0xa002;
pub const TAKEN_Y: u16 = 0xa003;
pub const ZOOM: u16 = 0xa404;
pub const DISTANCE: u16 = 0x9206;

/// A phone of 12 megapixels that says all of it, without contradictions: pixels of 1.4 µm by an inch figure.
pub fn phone() -> Photo {
    Photo {
        is_big_endian: true,
        size: [4032, 3024],
        first: vec![(0x010f, Text("Example")), (0x0110, Text("Phone 1")), (ORIENTATION, Short(1))],
        exif: vec![
            (FOCAL_LENGTH, Rational(425, 100)),
            (TAKEN_X, Long(4032)),
            (TAKEN_Y, Long(3024)),
            (PLANE_X, Rational(181_429, 10)),
            (PLANE_Y, Rational(181_429, 10)),
            (PLANE_UNIT, Short(2)),
            (FILM, Short(26)),
        ],
    }
}

impl Photo {
    /// The same with `value` for `tag` in its EXIF directory.
    pub fn with(mut self, tag: u16, value: Value) -> Self {
        self.exif.retain(|(other, _)| *other != tag);
        self.exif.push((tag, value));
        self
    }

    /// The same without these tags.
    pub fn without(mut self, tags: &[u16]) -> Self {
        self.exif.retain(|(tag, _)| !tags.contains(tag));
        self
    }

    pub fn oriented(mut self, orientation: u16) -> Self {
        self.first.retain(|(tag, _)| *tag != ORIENTATION);
        self.first.push((ORIENTATION, Short(orientation)));
        self
    }

    pub fn sized(mut self, width: u16, height: u16) -> Self {
        self.size = [width, height];
        self
    }

    pub fn jpeg(&self) -> Vec<u8> {
        let tiff = [b"Exif\0\0".as_slice(), &self.tiff()].concat();
        jpeg(&[(0xe0, b"JFIF\0\x01\x02\0\0\x01\0\x01\0\0"), (0xe1, &tiff)], self.size)
    }

    /// The block of TIFF: a header, the first directory, the EXIF directory, and what is too long for their entries.
    pub fn tiff(&self) -> Vec<u8> {
        let mut first = self.first.clone();
        let begin = 8 + 2 + 12 * (first.len() + 1) + 4;
        first.push((0x8769, Long(u32::try_from(begin).unwrap())));
        let behind = begin + 2 + 12 * self.exif.len() + 4;
        let mut long = Vec::new();
        let mut bytes = if self.is_big_endian {
            b"MM\0\x2a".to_vec()
        } else {
            b"II\x2a\0".to_vec()
        };
        bytes.extend(self.u32(8));
        bytes.extend(self.directory(&first, behind, &mut long));
        bytes.extend(self.directory(&self.exif, behind, &mut long));
        [bytes, long].concat()
    }

    fn directory(&self, entries: &[(u16, Value)], behind: usize, long: &mut Vec<u8>) -> Vec<u8> {
        let mut bytes = self.u16(u16::try_from(entries.len()).unwrap()).to_vec();
        for (tag, value) in entries {
            let (kind, count, value) = match value {
                Short(value) => (3, 1, self.u16(*value).to_vec()),
                Shorts(values) => (3, values.len(), values.iter().flat_map(|value| self.u16(*value)).collect()),
                Long(value) => (4, 1, self.u32(*value).to_vec()),
                Rational(n, d) => (5, 1, [self.u32(*n), self.u32(*d)].concat()),
                Text(text) => (2, text.len() + 1, [text.as_bytes(), b"\0"].concat()),
            };
            bytes.extend(self.u16(*tag));
            bytes.extend(self.u16(kind));
            bytes.extend(self.u32(u32::try_from(count).unwrap()));
            if value.len() <= 4 {
                bytes.extend([value.as_slice(), &[0; 4]].concat().iter().take(4));
            } else {
                bytes.extend(self.u32(u32::try_from(behind + long.len()).unwrap()));
                long.extend(value);
            }
        }
        bytes.extend([0; 4]);
        bytes
    }

    fn u16(&self, value: u16) -> [u8; 2] {
        if self.is_big_endian {
            value.to_be_bytes()
        } else {
            value.to_le_bytes()
        }
    }

    fn u32(&self, value: u32) -> [u8; 4] {
        if self.is_big_endian {
            value.to_be_bytes()
        } else {
            value.to_le_bytes()
        }
    }
}

/// SOI, these segments, a frame of this size, the beginning of pixels, EOI.
pub fn jpeg(segments: &[(u8, &[u8])], [width, height]: [u16; 2]) -> Vec<u8> {
    let mut bytes = b"\xff\xd8".to_vec();
    let mut segment = |marker: u8, payload: &[u8]| {
        let length = u16::try_from(payload.len() + 2).unwrap();
        bytes.extend([&[0xff, marker], length.to_be_bytes().as_slice(), payload].concat());
    };
    segments.iter().for_each(|(marker, payload)| segment(*marker, payload));
    let sides = [height.to_be_bytes(), width.to_be_bytes()].concat();
    segment(0xc0, &[&[8], sides.as_slice(), b"\x03\x01\x22\0\x02\x11\x01\x03\x11\x01"].concat());
    segment(0xda, b"\x03\x01\0\x02\x11\x03\x11\0\x3f\0");
    bytes.extend(b"\x00\x01\xff\x00\x02\xff\xd9");
    bytes
}
