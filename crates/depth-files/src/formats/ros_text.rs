//! ROS: what the calibrator prints, which is saved as ost.txt: both cameras one after the other, or one.

use super::matrix::{Projection, read_matrix, size};
use super::ros_info::{Info, of_matrices};
use crate::checks::coefficients;
use crate::format::Format;
use crate::number::numbers;
use crate::place::Place;
use crate::refusal::Refusal;
use crate::text::{Line, lines};
use crate::warning::Warning;

const FORMAT: Format = Format::Ros;

/// The cameras of the `file`th file.
pub(super) fn infos(text: &str, file: usize, warnings: &mut Vec<Warning>) -> Result<Vec<Info>, Refusal> {
    let all: Vec<Line<'_>> = lines(text)
        .map(|line| Line {
            place: Place { file, ..line.place },
            ..line
        })
        .collect();
    let mut infos = Vec::new();
    let mut size_now = [f64::NAN; 2];
    let mut name = String::new();
    let mut matrix = None;
    let mut distortion = Vec::new();
    for (index, line) in all.iter().enumerate() {
        let after = |rows: usize| {
            all.iter()
                .skip(index + 1)
                .take(rows)
                .map(|line| line.text)
                .collect::<Vec<_>>()
                .join(" ")
        };
        match line.text {
            "width" => size_now = [one(*line, &after(1), "the width")?, f64::NAN],
            "height" => {
                let [width, _] = size_now;
                size_now = [width, one(*line, &after(1), "the height")?];
            }
            "camera matrix" => {
                let numbers = line.array(&after(3), FORMAT, "the camera matrix", "9")?;
                let origin = line.place.origin("camera matrix");
                matrix = Some((read_matrix(numbers, &origin, warnings), origin));
            }
            "distortion" => distortion = coefficients(numbers(&after(1))),
            "projection" => {
                let projection = Projection::new(line.array(&after(3), FORMAT, "the projection", "12")?);
                let matrices = (Some((projection, line.place.origin("projection"))), matrix.take());
                let mut info = of_matrices(&name, size(size_now), matrices, warnings)?;
                info.camera.distortion = std::mem::take(&mut distortion);
                infos.push(info);
            }
            section if section.starts_with('[') && section != "[image]" => name = section.trim_matches(['[', ']']).to_owned(),
            _ => {}
        }
    }
    if infos.is_empty() {
        return Err(Refusal::Missing {
            format: FORMAT,
            what: "projection",
        });
    }
    Ok(infos)
}

fn one(line: Line<'_>, text: &str, name: &str) -> Result<f64, Refusal> {
    let [number] = line.array(text, FORMAT, name, "1")?;
    Ok(number)
}
