//! A file for each format: how it is recognized, and what it means.

mod baseline;
mod bouguet;
mod colmap;
mod depth_ai;
mod euroc;
mod exif;
mod exif_ways;
mod foundation_stereo;
mod ftc;
mod intrinsics;
mod intrinsics_names;
mod kalibr;
mod kitti;
mod kitti_extrinsics;
mod matrix;
mod middlebury;
mod numpy;
mod opencv;
mod opencv_baseline;
mod opencv_names;
mod orbslam;
mod realsense;
mod ros;
mod ros_info;
mod ros_text;
mod ros_window;
mod sensor;
mod transforms;
mod unnamed;
mod vins;
mod zed;

use crate::carrier::{FTC_ROOT, File};
use crate::checks;
use crate::format::Format;
use crate::found::Found;
use crate::node::Node;
use crate::refusal::Refusal;
use crate::sentences::in_one_line;
use crate::text::lines;

pub(crate) use bouguet::is_bouguet;
pub(crate) use colmap::is_colmap;
pub(crate) use foundation_stereo::is_foundation_stereo;
pub(crate) use kitti::is_kitti;
pub(crate) use numpy::{document as numpy, is_numpy};
pub(crate) use realsense::is_realsense;

/// What these files say together.
pub(crate) fn read(files: &[File]) -> Result<Found, Refusal> {
    let mut found = match files {
        [] => return Err(Refusal::Empty),
        [File::Lines(format, text)] => of_lines(*format, text)?,
        [File::Photo(photo)] => exif::read(photo)?,
        [File::Lines(Format::Ros, one), File::Lines(Format::Ros, other)] => {
            are_not_too_much(one)?;
            are_not_too_much(other)?;
            ros::read_texts(&[one, other])?
        }
        _ => of_trees(files)?,
    };
    if found.cameras.is_empty() {
        let format = found.format;
        return Err(Refusal::Missing { format, what: "camera" });
    }
    let cameras = found.cameras.len();
    found.pair = found.pair.filter(|pair| pair.iter().all(|at| *at < cameras));
    for camera in &mut found.cameras {
        camera.name = in_one_line(&camera.name);
        camera.model = camera.model.as_deref().map(in_one_line);
        camera.origin.how = in_one_line(&camera.origin.how);
    }
    checks::split_sides(&mut found);
    found.complete();
    checks::remark(&mut found);
    Ok(found)
}

/// No calibration has more: `rs-enumerate-devices` prints 10 000.
const MOST_LINES: usize = 100_000;

fn are_not_too_much(text: &str) -> Result<(), Refusal> {
    if lines(text).count() > MOST_LINES {
        return Err(Refusal::TooMuch);
    }
    Ok(())
}

fn of_lines(format: Format, text: &str) -> Result<Found, Refusal> {
    are_not_too_much(text)?;
    match format {
        Format::Middlebury => middlebury::read(text),
        Format::Kitti => kitti::read(text),
        Format::Colmap => colmap::read(text),
        Format::Zed => zed::read(text),
        Format::RealSense => realsense::read(text),
        Format::Ros => ros::read_texts(&[text]),
        Format::FoundationStereo => foundation_stereo::read(text),
        Format::Bouguet => bouguet::read(text),
        _ => Err(Refusal::Unknown),
    }
}

type Documents<'a> = Vec<(Format, &'a Node)>;

fn of_trees(files: &[File]) -> Result<Found, Refusal> {
    let (of_lines, mut documents) = known(files)?;
    if let Some(format) = of_lines.first().copied() {
        // These have all cameras in one file.
        let mut others = of_lines.into_iter().chain(documents.iter().map(|(format, _)| *format));
        return Err(match others.find(|other| *other != format) {
            Some(other) => Refusal::Mixed { formats: [format, other] },
            None => Refusal::OneFile { format },
        });
    }
    let is_without_matrix =
        |(format, document): &(Format, &Node)| matches!(format, Format::OpenCv | Format::NumPy) && !opencv_names::has_matrix(document);
    let unnamed = if documents.iter().all(is_without_matrix) {
        unnamed::matrices(all_documents(files))
    } else {
        Vec::new()
    };
    documents.extend(unnamed.iter().map(|document| (opencv_format(document), document)));
    if documents.iter().any(|(format, _)| *format == Format::OpenCv) {
        // Arrays of NumPy have the same names.
        let arrays = documents.iter_mut().filter(|(format, _)| *format == Format::NumPy);
        arrays.for_each(|(format, _)| *format = Format::OpenCv);
    }
    let Some((format, first)) = documents.first().copied() else {
        return Err(unknown(files));
    };
    if let Some((other, _)) = documents.iter().find(|(other, _)| *other != format) {
        return Err(Refusal::Mixed { formats: [format, *other] });
    }
    let are_several = documents.iter().any(|(_, document)| document.place.file != first.place.file);
    if are_several && matches!(format, Format::Kalibr | Format::OrbSlam) {
        return Err(Refusal::OneFile { format });
    }
    let documents: Vec<&Node> = documents.into_iter().map(|(_, document)| document).collect();
    match format {
        Format::Euroc => euroc::read(&documents),
        Format::Kalibr => kalibr::read(&documents),
        Format::OrbSlam => orbslam::read(&documents),
        Format::Ros => ros::read(&documents),
        Format::Ftc => ftc::read(first),
        Format::Vins => vins::read(&documents),
        Format::DepthAi => depth_ai::read(first),
        Format::Transforms => transforms::read(first),
        Format::Intrinsics => intrinsics::read(&documents),
        Format::NumPy => numpy::read(&documents),
        _ => opencv::read(&documents),
    }
}

/// The formats of the files of lines, and the documents of the others with their formats.
fn known(files: &[File]) -> Result<(Vec<Format>, Documents<'_>), Refusal> {
    let mut documents = Documents::new();
    let mut of_lines = Vec::new();
    for file in files {
        match file {
            File::Lines(format, _) => of_lines.push(*format),
            File::Photo(_) => of_lines.push(Format::Exif),
            File::Trees(all) => {
                let known = all.iter().filter_map(|document| Some((format_of(document)?, document)));
                let before = documents.len();
                documents.extend(known);
                // An array in a file of its own says nothing by itself.
                let is_array = |document: &Node| opencv_format(document) == Format::NumPy;
                let may_belong = all.iter().any(is_array) || !unnamed::matrices(all.iter()).is_empty();
                let is_unknown = documents.len() == before && files.len() > 1 && !may_belong;
                if let (true, Some(document)) = (is_unknown, all.first()) {
                    return Err(Refusal::Unknown.in_file(document.place.file));
                }
            }
        }
    }
    Ok((of_lines, documents))
}

/// Whose file a document is, by what only they write.
fn format_of(document: &Node) -> Option<Format> {
    let has = |key: &str| document.get(key).is_some();
    if has(FTC_ROOT) {
        return Some(Format::Ftc);
    }
    if depth_ai::is_depth_ai(document) {
        return Some(Format::DepthAi);
    }
    if vins::is_vins(document) {
        return Some(Format::Vins);
    }
    if transforms::is_transforms(document) {
        return Some(Format::Transforms);
    }
    if has("T_BS") || has("sensor_type") {
        return Some(Format::Euroc);
    }
    if kalibr::cameras(document).next().is_some() {
        return Some(Format::Kalibr);
    }
    if has("Camera.fx") || has("Camera1.fx") {
        return Some(Format::OrbSlam);
    }
    if intrinsics::is_intrinsics(document) {
        return Some(Format::Intrinsics);
    }
    if has("projection_matrix") || has("distortion_model") || has("rectification_matrix") {
        return Some(Format::Ros);
    }
    opencv_names::is_known(document).then_some(opencv_format(document))
}

/// Arrays of NumPy have no lines.
const fn opencv_format(document: &Node) -> Format {
    if document.place.line == 0 { Format::NumPy } else { Format::OpenCv }
}

fn all_documents(files: &[File]) -> impl Iterator<Item = &Node> {
    files.iter().flat_map(|file| match file {
        File::Lines(..) | File::Photo(_) => &[],
        File::Trees(all) => all.as_slice(),
    })
}

fn unknown(files: &[File]) -> Refusal {
    if all_documents(files).any(|document| document.get(numpy::OTHER).is_some()) {
        return Refusal::Other {
            what: "an array of NumPy that is no camera matrix",
            todo: "Give the one of 3 × 3 numbers, whose last row is 0 0 1.",
        };
    }
    Refusal::Unknown
}
