//! Photographs that are damaged, large, or say nothing: a sentence with what to do.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

mod judge;
mod photo;

use depth_files::{Found, read};
use photo::Value::{Short, Shorts};
use photo::{FILM, FOCAL_LENGTH, PLANE_UNIT, PLANE_X, PLANE_Y, Photo, jpeg, phone};

const PLANE: [u16; 3] = [PLANE_X, PLANE_Y, PLANE_UNIT];

fn found(photo: &Photo) -> Found {
    read(&[&photo.jpeg()]).unwrap()
}

fn refused(bytes: &[u8]) -> String {
    read(&[bytes]).unwrap_err().to_string()
}

#[test]
fn a_photo_without_a_focal_length_is_refused_with_what_it_is() {
    let said = refused(&jpeg(&[], [640, 480]));
    assert!(
        said.contains("a JPEG of 640 × 480 pixels") && said.contains("without EXIF, which messengers"),
        "{said}"
    );
    let said = refused(&phone().without(&PLANE).without(&[FOCAL_LENGTH, FILM]).jpeg());
    assert!(
        said.contains("by Example Phone 1, a JPEG of 4032 × 3024 pixels, but its EXIF has no focal length"),
        "{said}"
    );
    let said = refused(&phone().without(&PLANE).without(&[FILM]).jpeg());
    assert!(said.contains("the lens has 4.25 mm"), "{said}");
}

#[test]
fn one_photograph_is_read_at_a_time() {
    let (one, other) = (phone().jpeg(), phone().with(FILM, Short(52)).jpeg());
    let said = read(&[&one, &other]).unwrap_err().to_string();
    assert!(said.contains("give one at a time"), "{said}");
    let calibration = br#"{"K": [[700,0,320],[0,700,240],[0,0,1]]}"#.as_slice();
    for files in [[one.as_slice(), calibration], [calibration, one.as_slice()]] {
        let said = read(&files).unwrap_err().to_string();
        assert!(said.contains("do not go together"), "{said}");
    }
    assert_eq!(read(&[&one, &one]).unwrap().cameras.len(), 3, "twice the same");
}

#[test]
fn every_beginning_of_a_photo_is_answered() {
    for is_big_endian in [true, false] {
        let bytes = Photo { is_big_endian, ..phone() }.jpeg();
        for length in 0..bytes.len() {
            assert_eq!(judge::judge(&read(&[&bytes[..length]])), Ok(()), "{length}");
        }
        let tiff = phone().tiff();
        for length in 0..tiff.len() {
            let exif = [b"Exif\0\0", &tiff[..length]].concat();
            assert_eq!(judge::judge(&read(&[&jpeg(&[(0xe1, &exif)], [4032, 3024])])), Ok(()), "{length}");
        }
    }
    let said = refused(&phone().jpeg()[..40]);
    assert!(said.contains("truncated or damaged"), "{said}");
    let said = refused(&jpeg(&[(0xe1, b"Exif\0\0neither")], [640, 480]));
    assert!(said.contains("its EXIF cannot be read"), "{said}");
}

#[test]
fn a_photo_larger_than_any_calibration_is_read_by_its_head() {
    let mut bytes = phone().jpeg();
    bytes.resize(40 << 20, 0x55);
    assert_eq!(read(&[&bytes]).unwrap(), found(&phone()));
}

#[test]
fn of_several_numbers_the_first_is_read_wherever_they_stand() {
    for is_big_endian in [true, false] {
        let one = Photo { is_big_endian, ..phone() };
        let three = one.clone().with(FILM, Shorts(vec![26, 5, 7]));
        assert_eq!(read(&[&three.jpeg()]).unwrap(), found(&one), "{is_big_endian}");
    }
}

#[test]
fn segments_that_no_standard_has_in_front_of_exif_are_skipped() {
    let tiff = [b"Exif\0\xff".as_slice(), &phone().tiff()].concat();
    let xmp = b"http://ns.adobe.com/xap/1.0/\0<x/>";
    let mut bytes = jpeg(&[(0xe1, xmp), (0xe1, &tiff), (0xe2, b"MPF\0")], [4032, 3024]);
    // Filled, and with bytes that belong to nothing.
    bytes.splice(2..2, *b"\x00\x07\xff\xff\xff\xfe\x00\x03a");
    bytes.splice(2..2, *b"\xff");
    assert_eq!(read(&[&bytes]).unwrap(), found(&phone()));
}

#[test]
fn other_pictures_are_refused_with_what_to_do() {
    for (start, what, todo) in [
        (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR".as_slice(), "PNG", "the JPEG as the camera made it"),
        (b"\0\0\0\x18ftypheic\0\0\0\0mif1heic", "HEIC", "Most Compatible"),
        (b"RIFF\0\0\0\0WEBPVP8 ", "WebP", "JPEG"),
        (b"II\x2a\0\x08\0\0\0\0\0", "TIFF", "JPEG"),
        (b"MM\0\x2a\0\0\0\x08\0\0", "TIFF", "JPEG"),
    ] {
        let said = refused(start);
        assert!(said.contains(what) && said.contains(todo), "{said}");
    }
}
