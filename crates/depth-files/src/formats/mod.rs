//! A file for each format: how it is recognized, and what it means.

mod colmap;
mod euroc;
mod kalibr;
mod kitti;
mod matrix;
mod middlebury;
mod opencv;
mod opencv_names;
mod orbslam;
mod realsense;
mod ros;
mod zed;

use crate::carrier::File;
use crate::checks;
use crate::format::Format;
use crate::found::Found;
use crate::node::Node;
use crate::refusal::Refusal;

pub(crate) use colmap::is_colmap;
pub(crate) use kitti::is_kitti;

/// What these files say together.
pub(crate) fn read(files: &[File]) -> Result<Found, Refusal> {
    let mut found = match files {
        [] => return Err(Refusal::Empty),
        [File::Lines(format, text)] => of_lines(*format, text)?,
        _ => of_trees(files)?,
    };
    checks::remark(&mut found);
    Ok(found)
}

fn of_lines(format: Format, text: &str) -> Result<Found, Refusal> {
    match format {
        Format::Middlebury => middlebury::read(text),
        Format::Kitti => kitti::read(text),
        Format::Colmap => colmap::read(text),
        Format::Zed => zed::read(text),
        Format::RealSense => realsense::read(text),
        Format::Ros => ros::read_text(text),
        _ => Err(Refusal::Unknown),
    }
}

fn of_trees(files: &[File]) -> Result<Found, Refusal> {
    let mut documents: Vec<(Format, &Node)> = Vec::new();
    for file in files {
        match file {
            File::Lines(format, _) => {
                // The others of the files are of another kind, or of one that knows a single file.
                return Err(Refusal::Mixed {
                    formats: [*format, documents.first().map_or(*format, |(format, _)| *format)],
                });
            }
            File::Trees(all) => {
                for document in all {
                    let format = format_of(document);
                    documents.extend(format.map(|format| (format, document)));
                }
            }
        }
    }
    let Some((format, _)) = documents.first().copied() else {
        return Err(Refusal::Unknown);
    };
    if let Some((other, _)) = documents.iter().find(|(other, _)| *other != format) {
        return Err(Refusal::Mixed { formats: [format, *other] });
    }
    let documents: Vec<&Node> = documents.into_iter().map(|(_, document)| document).collect();
    match format {
        Format::Euroc => euroc::read(&documents),
        Format::Kalibr => kalibr::read(&documents),
        Format::OrbSlam => orbslam::read(&documents),
        Format::Ros => ros::read(&documents),
        _ => opencv::read(&documents),
    }
}

/// Whose file a document is, by what only they write.
fn format_of(document: &Node) -> Option<Format> {
    let has = |key: &str| document.get(key).is_some();
    if has("T_BS") || has("sensor_type") {
        return Some(Format::Euroc);
    }
    if kalibr::cameras(document).next().is_some() {
        return Some(Format::Kalibr);
    }
    if has("Camera.fx") || has("Camera1.fx") {
        return Some(Format::OrbSlam);
    }
    if has("projection_matrix") || has("distortion_model") || has("rectification_matrix") {
        return Some(Format::Ros);
    }
    opencv_names::is_known(document).then_some(Format::OpenCv)
}
