//! What is no text: what it is, and how its numbers come into a file that can be read.

use crate::refusal::Refusal;

/// What to do with a pickle. Whoever loads one runs what is in it.
const OF_PICKLE: &str = "If you made it yourself, write it as JSON: \
    python3 -c \"import json,pickle;print(json.dumps(pickle.load(open('calibration.pkl','rb')),default=lambda a:a.tolist()))\" > calibration.json.";
/// What to do with objects in files of NumPy, which are pickles too.
pub(crate) const OF_OBJECTS: &str = "If you made it yourself, write it as JSON: \
    python3 -c \"import json,numpy;a=numpy.load('FILE',allow_pickle=True);\
    print(json.dumps(dict(a) if hasattr(a,'files') else a.item(),default=lambda a:a.tolist()))\" > calibration.json.";
const OF_MATLAB: &str = "In MATLAB write its numbers as JSON: \
    writelines(jsonencode(struct('K1',K1,'K2',K2,'T',T)),'calibration.json'), where for stereoParams \
    K1 is stereoParams.CameraParameters1.K, K2 is stereoParams.CameraParameters2.K and T is stereoParams.PoseCamera2.Translation, \
    and for Bouguet’s toolbox K1 is KK_left and K2 is KK_right.";
const OF_PICTURE: &str = "Give the file that the calibration wrote, or the JPEG as the camera made it, whose EXIF says a focal length.";
const OF_HEIC: &str = "Export it as JPEG with its metadata: its EXIF says a focal length. An iPhone takes JPEGs where Settings, Camera, Formats is \
    Most Compatible.";
/// The brands of HEIF.
///
/// Source: ISO/IEC 23008-12, and the registry of MP4RA.
const HEIF: [&[u8; 4]; 8] = [b"heic", b"heix", b"hevc", b"heim", b"heis", b"mif1", b"msf1", b"avif"];
const UNPACK: &str = "Unpack it and give the calibration that is in it.";
const EXPORT: &str = "Write its numbers into a text file, such as JSON.";

/// Why these bytes cannot be read as text, if they are none.
pub(crate) fn refusal(bytes: &[u8]) -> Option<Refusal> {
    let known = |what, todo| Some(Refusal::Binary { what: Some(what), todo });
    match bytes {
        [0x80, 2..=5, ..] => return known("a pickle of Python", OF_PICKLE),
        [0x1f, 0x8b, ..] => return known("a compressed archive, as calibrationdata.tar.gz of ROS", UNPACK),
        [0x89, b'P', b'N', b'G', ..] => return known("a picture (PNG)", OF_PICTURE),
        [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => return known("a picture (WebP)", OF_PICTURE),
        [b'I', b'I', 42, 0, ..] | [b'M', b'M', 0, 42, ..] => return known("a picture (TIFF, or raw of a camera)", OF_PICTURE),
        [_, _, _, _, b'f', b't', b'y', b'p', brand @ ..] if HEIF.iter().any(|known| brand.starts_with(*known)) => {
            return known("a photograph in HEIC or AVIF", OF_HEIC);
        }
        [0x89, b'H', b'D', b'F', ..] => return known("an HDF5 file, as MATLAB also writes", OF_MATLAB),
        // The number of cameras, of 64 bits.
        [_, _, 0, 0, 0, 0, 0, 0, _, ..] => {
            return known(
                "cameras.bin of COLMAP, its binary form",
                "Export it as text: colmap model_converter --output_type TXT.",
            );
        }
        _ => {}
    }
    if [&b"MATLAB 5.0 MAT-file"[..], b"MATLAB 7.3 MAT-file"]
        .iter()
        .any(|start| bytes.starts_with(start))
    {
        return known("a file of MATLAB", OF_MATLAB);
    }
    // The oldest kind of pickle is made of letters.
    let old = [&b"(dp"[..], b"(lp", b"(cnumpy", b"cnumpy.", b"ccopy_reg\n", b"(ccopy_reg\n"];
    if old.iter().any(|start| bytes.starts_with(start)) {
        return Some(Refusal::Other {
            what: "a pickle of Python",
            todo: OF_PICKLE,
        });
    }
    bytes.contains(&0).then_some(Refusal::Binary { what: None, todo: EXPORT })
}
