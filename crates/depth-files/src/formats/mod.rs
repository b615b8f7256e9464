//! A file for each format: how it is recognized, and what it means.

mod colmap;
mod euroc;
mod kalibr;
mod kitti;
mod matrix;
mod middlebury;
mod opencv;
mod opencv_baseline;
mod opencv_names;
mod orbslam;
mod realsense;
mod ros;
mod ros_window;
mod sensor;
mod zed;

use crate::carrier::File;
use crate::checks;
use crate::format::Format;
use crate::found::Found;
use crate::node::Node;
use crate::refusal::Refusal;
use crate::sentences::in_one_line;
use crate::text::lines;

pub(crate) use colmap::is_colmap;
pub(crate) use kitti::is_kitti;
pub(crate) use realsense::is_realsense;

/// What these files say together.
pub(crate) fn read(files: &[File]) -> Result<Found, Refusal> {
    let mut found = match files {
        [] => return Err(Refusal::Empty),
        [File::Lines(format, text)] => of_lines(*format, text)?,
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

fn of_lines(format: Format, text: &str) -> Result<Found, Refusal> {
    if lines(text).count() > MOST_LINES {
        return Err(Refusal::TooMuch);
    }
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
    let mut of_lines = Vec::new();
    for file in files {
        match file {
            File::Lines(format, _) => of_lines.push(*format),
            File::Trees(all) => {
                let known = all.iter().filter_map(|document| Some((format_of(document)?, document)));
                let before = documents.len();
                documents.extend(known);
                if let (true, Some(document)) = (documents.len() == before && files.len() > 1, all.first()) {
                    return Err(Refusal::Unknown.in_file(document.place.file));
                }
            }
        }
    }
    if let Some(format) = of_lines.first().copied() {
        // These have all cameras in one file.
        let mut others = of_lines.into_iter().chain(documents.iter().map(|(format, _)| *format));
        return Err(match others.find(|other| *other != format) {
            Some(other) => Refusal::Mixed { formats: [format, other] },
            None => Refusal::OneFile { format },
        });
    }
    let Some((format, first)) = documents.first().copied() else {
        return Err(Refusal::Unknown);
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
