//! What else a distance gives: the point in space and the range that a tape measures, the correction for a tilted target,
//! and the ground plane as a third method.

use crate::entry::{Entries, Entry};
use crate::field::Key;
use crate::fields::{CAMERA_HEIGHT, CAMERA_PITCH, CX, CY, FLOOR_ROW, PIXEL_COLUMN, PIXEL_ROW, TILT};
use crate::note::{Issue, Note};
use crate::number::plain;
use crate::reading::{self, Reading};
use depth_core::angle::Angle;
use depth_core::camera::{GroundView, PointSolution, PointView, TiltSolution, TiltedTarget};
use depth_core::judge::{Term, Unsolvable};
use depth_core::measured::Measured;
use depth_core::problem::Solution;
use depth_core::quantity::{Length, Pixels, Quantity};

/// Range, tilt and ground plane.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Geometry {
    /// The point in space; `None` while something is missing.
    pub point: Option<PointSolution>,
    /// The correction for a tilted target; `None` while something is missing.
    pub tilted: Option<(TiltedTarget, TiltSolution)>,
    /// The distance along the floor with its σ; `None` while something is missing.
    pub floor: Option<Measured<Length>>,
    /// What could be read.
    pub readings: Vec<Reading>,
    /// What is wrong with what was typed, in reading order: at most one for each value and one for each σ.
    pub notes: Vec<Note>,
}

impl Geometry {
    /// The fields of the point in space.
    pub const POINT: [Key; 4] = [CX, CY, PIXEL_COLUMN, PIXEL_ROW];
    /// The fields of the tilted target.
    pub const TILTED: [Key; 1] = [TILT];
    /// The fields of the ground plane.
    pub const GROUND: [Key; 4] = [CAMERA_HEIGHT, CAMERA_PITCH, FLOOR_ROW, CY];

    /// What follows from the texts in `entries` and from `solution`.
    pub fn assess(entries: &Entries, solution: &Solution) -> Self {
        let mut fields = Fields {
            entries,
            readings: Vec::new(),
            notes: Vec::new(),
        };
        let mut geometry = Self {
            point: point(&mut fields, solution),
            tilted: tilted(&mut fields, solution),
            floor: floor(&mut fields, solution),
            readings: Vec::new(),
            notes: Vec::new(),
        };
        geometry.readings = fields.readings;
        geometry.notes = fields.notes;
        geometry.notes.sort_by_key(|note| (note.key, note.part));
        geometry.notes.dedup_by_key(|note| (note.key, note.part));
        geometry
    }

    /// The note at the field `key`, its value first.
    pub fn note(&self, key: Key) -> Option<&Note> {
        self.notes.iter().find(|note| note.key == key)
    }
}

/// Notes the principal point in `entries`, as a Q matrix gives it.
pub fn set_principal_point(entries: &mut Entries, cx: Pixels, cy: Pixels) {
    entries.fill(CX, Entry::new(plain(cx.px()), None));
    entries.fill(CY, Entry::new(plain(cy.px()), None));
}

/// What was typed, and what is to be said about it.
struct Fields<'a> {
    entries: &'a Entries,
    readings: Vec<Reading>,
    notes: Vec<Note>,
}

impl Fields<'_> {
    /// What was read in the field `key`, with its σ where it has one.
    fn read(&mut self, key: Key) -> Option<Reading> {
        let entry = self.entries.entry(key);
        let reading = if key.has_sigma {
            reading::read_with_sigma(key, entry)
        } else {
            reading::read(key, entry)
        };
        match reading {
            Ok(reading) => {
                self.readings.extend(reading.clone());
                reading
            }
            Err(note) => {
                self.notes.push(note);
                None
            }
        }
    }

    fn pixels(&mut self, key: Key) -> Option<Pixels> {
        self.read(key).map(|reading| Pixels::new(reading.value))
    }

    fn measured<Q: Quantity>(&mut self, key: Key) -> Option<Measured<Q>> {
        self.read(key)
            .map(|reading| Measured::from_base(reading.value, reading.sigma.unwrap_or(0.0)))
    }
}

fn point(fields: &mut Fields<'_>, solution: &Solution) -> Option<PointSolution> {
    let [cx, cy, column, row] = Geometry::POINT.map(|key| fields.pixels(key));
    let fx = solution.problem.focal_length?.value;
    let view = PointView {
        fx,
        fy: fx,
        cx: cx?,
        cy: cy?,
        column: column?,
        row: row?,
        depth: solution.stereo.distance().or(solution.monocular.distance())?,
    };
    view.solve().ok()
}

fn tilted(fields: &mut Fields<'_>, solution: &Solution) -> Option<(TiltedTarget, TiltSolution)> {
    let tilt = Angle::from_radians(fields.read(TILT)?.value);
    let apparent = solution.monocular.distance()?;
    let target = TiltedTarget { apparent, tilt };
    let solved = target.solve();
    if solved.is_err() {
        fields.notes.push(Note::error(TILT, Issue::TiltTooLarge));
    }
    Some((target, solved.ok()?))
}

fn floor(fields: &mut Fields<'_>, solution: &Solution) -> Option<Measured<Length>> {
    let height = fields.measured(CAMERA_HEIGHT);
    let pitch = fields.measured(CAMERA_PITCH);
    let row = fields.measured(FLOOR_ROW);
    let cy = fields.pixels(CY);
    let view = GroundView {
        height: height?,
        pitch: pitch?,
        row: row?,
        fy: solution.problem.focal_length?.value,
        cy: cy?,
    };
    let (key, issue) = match view.distance() {
        Ok(distance) => return Some(distance),
        Err(Unsolvable::AboveHorizon { .. }) => (FLOOR_ROW, Issue::AboveHorizon),
        Err(Unsolvable::BelowCamera { .. }) => (CAMERA_PITCH, Issue::BelowCamera),
        Err(Unsolvable::Value { term: Term::Distance, .. }) => (CAMERA_HEIGHT, Issue::GroundTooExtreme),
        Err(_) => (CAMERA_HEIGHT, Issue::UnusableGround),
    };
    fields.notes.push(Note::error(key, issue));
    None
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::form::Example;

    fn doorway(texts: &[(Key, &str)]) -> Geometry {
        let mut entries = Entries::default();
        for &(key, text) in texts {
            let (value, sigma) = text.split_once('±').unwrap_or((text, ""));
            entries.entry_mut(key).text = value.into();
            entries.entry_mut(key).sigma = sigma.into();
        }
        Geometry::assess(&entries, &Example::Doorway.inputs().assess().solution)
    }

    /// fx 950 px and a depth of 4.275 m: a triangle of 3, 4 and 5 in the plane of the rows.
    #[test]
    fn the_range_is_the_long_side_of_the_triangle() {
        let point = doorway(&[(CX, "600"), (CY, "300"), (PIXEL_COLUMN, "1312.5"), (PIXEL_ROW, "300")])
            .point
            .unwrap();
        assert!((point.x.m() - 4.275 * 0.75).abs() < 1e-12 && point.y.m() == 0.0);
        assert!((point.range.m() - 4.275 * 1.25).abs() < 1e-12);
    }

    #[test]
    fn a_target_at_60_degrees_is_half_as_far_in_whatever_unit_the_angle_is() {
        for tilt in ["60", "60°", "-60 deg", "1.0471975511965976 rad"] {
            let (_, tilted) = doorway(&[(TILT, tilt)]).tilted.unwrap();
            assert!((tilted.depth.m() - 4.275 / 2.0).abs() < 1e-12, "{tilt}");
            assert!((tilted.excess - 1.0).abs() < 1e-12, "{tilt}");
        }
        assert_eq!(doorway(&[(TILT, "90")]).note(TILT).unwrap().issue, Issue::TiltTooLarge);
        assert!(doorway(&[(TILT, "60 px")]).note(TILT).is_some());
    }

    /// A level camera 1 m above the floor sees a point 950 rows below its middle at 45°, 1 m away.
    #[test]
    fn a_sigma_that_cannot_be_read_is_a_note_and_no_zero() {
        let floor = |row: &str| doorway(&[(CAMERA_HEIGHT, "100 cm ± 1 cm"), (CAMERA_PITCH, "0"), (FLOOR_ROW, row), (CY, "300")]);
        let distance = floor("1250").floor.unwrap();
        assert!((distance.value.m() - 1.0).abs() < 1e-12 && (distance.sigma.m() - 0.01).abs() < 1e-12);
        let unread = floor("1250 ± abc");
        assert_eq!(unread.floor, None);
        assert!(unread.note(FLOOR_ROW).unwrap().message().contains("“abc” is not an uncertainty."));
        assert_eq!(floor("200").note(FLOOR_ROW).unwrap().issue, Issue::AboveHorizon);
    }

    #[test]
    fn nothing_is_said_while_something_is_missing() {
        assert_eq!(doorway(&[]), Geometry::default());
    }
}
