//! The table "Key input parameters and outputs" for each of the things that can be asked for.

use super::places::{WAYS_BETWEEN, ways_between};
use super::strip::{Mode, Shown, extent_of};
use super::table::{Cells, INTERMEDIATE, Row, all_rows, typed_row};
use crate::assess::{Assessment, Unknown};
use crate::field::{Key, Section};
use crate::fields;
use crate::form::Inputs;
use crate::sentences::Phrase;
use crate::unit::Unit;
use depth_core::angle::AngleUnit;
use depth_core::camera::subtended_angle;
use depth_core::disparity::as_stored_by_opencv;
use depth_core::in_image::InImage;
use depth_core::measured::Measured;
use depth_core::problem::{Field, Method, Solved};
use depth_core::quantity::{Length, LengthUnit};

/// A part of the table: its rows below a heading.
struct Part {
    heading: Option<&'static str>,
    rows: Vec<Row>,
}

/// The heading of the point in space.
const POINT: &str = "Point and range";
/// The heading of what was solved for.
const SOLVED: &str = "Solved";
/// The heading of the results of the other ways.
const DISTANCES: &str = "Distances";

/// The rows for what `mode` asks for. There is a row for every result, known or not, so that none moves another.
pub fn mode_rows(mode: Mode, shown: &Shown<'_>) -> Vec<Row> {
    let table = Table {
        inputs: shown.inputs,
        assessment: shown.assessment,
        unit: shown.unit,
    };
    let with_heading = |part: Part| {
        let heading = part.heading;
        part.rows.into_iter().enumerate().map(move |(index, row)| Row {
            heading: row.heading.or(heading.filter(|_| index == 0)),
            ..row
        })
    };
    table.parts(mode).into_iter().flat_map(with_heading).collect()
}

/// What the table is made of.
#[derive(Clone, Copy)]
struct Table<'a> {
    inputs: &'a Inputs,
    assessment: &'a Assessment,
    unit: LengthUnit,
}

impl Table<'_> {
    fn parts(self, mode: Mode) -> Vec<Part> {
        let Self { assessment, unit, .. } = self;
        let camera = || Section::Camera.keys().chain([fields::CX, fields::CY]);
        match mode {
            Mode::Distance => {
                let rows = all_rows(self.inputs, assessment, unit);
                std::iter::once(Part { heading: None, rows })
                    .chain(point(assessment, unit))
                    .collect()
            }
            Mode::Quantity => self.of_quantity(),
            Mode::Ground => vec![self.given(camera().chain(Section::Ground.keys())), floor(assessment, unit)],
            Mode::TwoShots => {
                let keys = Section::TwoShots.keys().chain([fields::FOCAL_LENGTH]);
                vec![self.given(keys), shots(assessment, unit)]
            }
            Mode::TwoPoints => {
                let pair = Section::Stereo.keys().filter(|key| *key != Field::Disparity);
                let keys = camera().chain(pair).chain(Section::TwoPoints.keys());
                vec![self.given(keys), points(assessment, unit)]
            }
        }
    }

    fn of_quantity(self) -> Vec<Part> {
        let Some(unknown) = &self.assessment.unknown else {
            return vec![Part {
                heading: None,
                rows: all_rows(self.inputs, self.assessment, self.unit),
            }];
        };
        let fields = unknown.method.fields().into_iter().chain(unknown.method.optional_fields());
        let given = fields.map(Key::from).filter(|key| *key != unknown.field);
        vec![
            self.given(std::iter::once(fields::DISTANCE).chain(given)),
            Part {
                heading: Some(SOLVED),
                rows: vec![typed_row(self.inputs, self.assessment, unknown.field.into(), self.unit)],
            },
            Part {
                heading: Some(INTERMEDIATE),
                rows: around_quantity(self.assessment, unknown, self.unit),
            },
        ]
    }

    /// Those of the inputs `keys` that everybody has or that something was typed into.
    fn given(self, keys: impl Iterator<Item = Key>) -> Part {
        // The center and fy are optional for a distance; a row or an angle is enough, and no way needs both.
        let is_of_way = |key: &Key| matches!(key.section, Some(section) if section.is_way_of_its_own()) && *key != fields::FLOOR_ANGLE;
        let is_given = |key: &Key| !key.is_optional || is_of_way(key) || !self.inputs.entry(*key).is_blank();
        Part {
            heading: None,
            rows: keys
                .filter(is_given)
                .map(|key| typed_row(self.inputs, self.assessment, key, self.unit))
                .collect(),
        }
    }
}

/// The point in space, where the pixel that it is seen at was typed; with the range.
fn point(assessment: &Assessment, unit: LengthUnit) -> Option<Part> {
    let (origin, point) = assessment.geometry.point?;
    let from = super::point_origin(origin);
    let names = super::point(super::STYLE, &assessment.solution.problem, &point, unit).map(|(name, _)| name);
    let values = [point.x, point.y, point.z, point.range];
    let rows = names
        .into_iter()
        .zip(values)
        .map(|(name, value)| length_row(name, Some(value), unit, from));
    Some(Part {
        heading: Some(POINT),
        rows: rows.collect(),
    })
}

/// What is worth knowing around a quantity that was solved for.
fn around_quantity(assessment: &Assessment, unknown: &Unknown, unit: LengthUnit) -> Vec<Row> {
    let solution = &assessment.solution;
    let mut rows = Vec::new();
    if let Ok(Solved::InImage(InImage::Pixels(disparity))) = unknown.outcome
        && unknown.method == Method::Stereo
    {
        let cells = Cells::of(as_stored_by_opencv(disparity), None);
        rows.push(cells.row("Disparity × 16 (OpenCV)", Phrase::AsOpenCvReturns.to_string()));
    }
    let disparity = solution
        .problem
        .disparity
        .and_then(InImage::px)
        .filter(|_| unknown.method == Method::Stereo);
    if let Some(disparity) = disparity {
        for shift in [-1.0, 1.0] {
            let at = Unit::Pixel.behind(&super::STYLE.readable(disparity.value.px() + shift, 4));
            let distance = solution.problem.stereo_distance_if(shift).map(Measured::exact);
            rows.push(length_row(&format!("Object distance at {at}"), distance, unit, "one pixel away"));
        }
    }
    let extent = extent_of(assessment, unknown);
    let angle = extent
        .zip(unknown.distance)
        .and_then(|(extent, distance)| subtended_angle(extent, distance));
    let name = match unknown.method {
        Method::Stereo => "Angle between the rays",
        Method::Monocular => "Angle that the object spans",
    };
    let degree = Some(Unit::Angle(AngleUnit::Degree));
    let cells = angle.map_or(Cells::none(degree), |angle| {
        Cells::of(Measured::new(angle.value.degrees(), angle.sigma.degrees()), degree)
    });
    rows.push(cells.row(name, String::new()));
    rows
}

/// The angle between both lines of sight as it is written, where something else than the distance of a pair is asked for:
/// "(4.091 ± 0.036)°".
pub fn angle_between_rays(assessment: &Assessment) -> Option<String> {
    let unknown = assessment.unknown.as_ref().filter(|unknown| unknown.method == Method::Stereo)?;
    unknown.outcome.as_ref().ok()?;
    let angle = subtended_angle(extent_of(assessment, unknown)?, unknown.distance?)?;
    let [value, sigma] = [angle.value.degrees(), angle.sigma.degrees()];
    Some(if sigma > 0.0 {
        super::STYLE.with_sigma(value, sigma).text(Unit::DEGREE)
    } else {
        Unit::DEGREE.behind(&super::STYLE.number(Some(value)))
    })
}

fn floor(assessment: &Assessment, unit: LengthUnit) -> Part {
    let ground = assessment.geometry.ground.as_ref();
    let rows = [
        (
            "Straight ahead",
            ground.map(|ground| ground.ahead),
            "in the direction of the camera",
        ),
        ("To the right", ground.and_then(|ground| ground.right), "square to that"),
        ("Along the floor", ground.map(|ground| ground.distance), "from below the camera"),
        ("Slant, from the lens", ground.map(|ground| ground.slant), "along the ray"),
        ("Depth, from the lens", ground.map(|ground| ground.depth), "along the optical axis"),
    ];
    results(rows, unit)
}

fn shots(assessment: &Assessment, unit: LengthUnit) -> Part {
    let shots = assessment.geometry.two_shots.as_ref().map(|shots| &shots.solution);
    let rows = [
        (super::FROM_FIRST_PLACE, shots.map(|shots| shots.far), "the farther one"),
        ("From the second place", shots.map(|shots| shots.near), "a step nearer"),
        ("Width of the object", shots.and_then(|shots| shots.size), "needs fx"),
    ];
    results(rows, unit)
}

fn points(assessment: &Assessment, unit: LengthUnit) -> Part {
    let points = assessment.geometry.two_points.as_ref();
    let ways = points.map_or(WAYS_BETWEEN.map(|name| (name, None)), |points| {
        ways_between(points).map(|(name, length)| (name, Some(length)))
    });
    let rows = ways.map(|(name, length)| {
        let words = if name == super::BETWEEN_POINTS {
            "in a straight line"
        } else {
            "from the first to the second"
        };
        (name, length, words)
    });
    results(rows, unit)
}

fn results<const N: usize>(rows: [(&str, Option<Measured<Length>>, &str); N], unit: LengthUnit) -> Part {
    Part {
        heading: Some(DISTANCES),
        rows: rows
            .into_iter()
            .map(|(name, length, words)| length_row(name, length, unit, words))
            .collect(),
    }
}

fn length_row(name: &str, length: Option<Measured<Length>>, unit: LengthUnit, description: &str) -> Row {
    Cells::of_length(length, unit).row(name, description.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::form::Example;

    fn rows(mode: Mode, inputs: &Inputs, assessment: &Assessment) -> Vec<Row> {
        let shown = Shown {
            inputs,
            assessment,
            unit: LengthUnit::Meter,
            was: None,
        };
        mode_rows(mode, &shown)
    }

    /// 0.1 m at 1.4 m: 2·atan(0.05/1.4) = 4.0909°.
    #[test]
    fn a_disparity_that_was_solved_for_has_what_is_around_it() {
        let mut inputs = Example::Parcel.inputs();
        inputs.unknown = Some((Method::Stereo, depth_core::problem::Field::Disparity));
        inputs.entry_mut(fields::DISTANCE).text = "1.40".into();
        inputs.set_sigma(fields::DISTANCE, "0.01");
        let assessment = inputs.assess();
        let rows = rows(Mode::Quantity, &inputs, &assessment);
        let said: Vec<String> = rows
            .iter()
            .map(|row| format!("{} {} {:?}", row.label, row.value, row.sigma))
            .collect();
        for wanted in [
            "Object distance 1.40 Some(\"0.01\")",
            "Disparity 50.00 Some(\"0.46\")",
            "Disparity × 16 (OpenCV) 800.0 Some(\"7.3\")",
            "Object distance at 49 px 1.429 None",
            "Angle between the rays 4.091 Some(\"0.036\")",
        ] {
            assert!(said.iter().any(|row| row == wanted), "{wanted}: {said:#?}");
        }
        assert_eq!(angle_between_rays(&assessment).as_deref(), Some("(4.091 ± 0.036)°"));
    }

    #[test]
    fn the_mast_has_its_inputs_and_five_distances() {
        let inputs = Example::Mast.inputs();
        let rows = rows(Mode::Ground, &inputs, &inputs.assess());
        let at = rows.iter().position(|row| row.heading == Some(DISTANCES));
        assert_eq!((rows.len(), at), (14, Some(9)));
        let along: Vec<_> = rows.iter().skip(9).map(|row| (row.value.as_str(), row.sigma.as_deref())).collect();
        assert_eq!(
            along,
            [
                ("3.08", Some("0.15")),
                ("2.13", Some("0.10")),
                ("3.74", Some("0.18")),
                ("3.93", Some("0.19")),
                ("3.24", Some("0.15"))
            ]
        );
    }
}
