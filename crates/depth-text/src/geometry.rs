//! What else a distance gives: the point in space and the range that a tape measures, the correction for a tilted target,
//! and the ground plane as a third method.

use crate::entry::{Entries, Entry};
use crate::field::Key;
use crate::fields::{CAMERA_HEIGHT, CAMERA_PITCH, CX, CY, FLOOR_ROW, PIXEL_COLUMN, PIXEL_ROW, TILT};
use crate::note::{Issue, Note};
use crate::number::plain;
use crate::reading::{self, Reading};
use depth_core::angle::Angle;
use depth_core::camera::{self, GroundView, Intrinsics, NoGround};
use depth_core::measured::Measured;
use depth_core::problem::Solution;
use depth_core::quantity::{Length, Pixels};

/// Range, tilt and ground plane.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Geometry {
    /// The point in space; `None` while something is missing.
    pub point: Option<Point>,
    /// The correction for a tilted target; `None` while something is missing.
    pub tilted: Option<Tilted>,
    /// The distance along the floor with its σ, m; `None` while something is missing.
    pub floor: Option<Measured>,
    /// What is wrong with what was typed, in reading order: at most one for each value and one for each σ.
    pub notes: Vec<Note>,
}

/// A point in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// To the right of the optical axis.
    pub x: Length,
    /// Below the optical axis.
    pub y: Length,
    /// Along the optical axis.
    pub depth: Length,
    /// From the lens.
    pub range: Length,
}

/// The monocular distance to a target that is turned away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tilted {
    /// As computed for a target that faces the camera.
    pub apparent: Length,
    /// Corrected for the tilt.
    pub depth: Length,
}

impl Tilted {
    /// How much too long the distance is without the correction, as a fraction.
    pub fn excess(&self) -> f64 {
        self.apparent.m() / self.depth.m() - 1.0
    }
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
            notes: Vec::new(),
        };
        let mut geometry = Self {
            point: point(&mut fields, solution),
            tilted: tilted(&mut fields, solution),
            floor: floor(&mut fields, solution),
            notes: Vec::new(),
        };
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
        reading.unwrap_or_else(|note| {
            self.notes.push(note);
            None
        })
    }

    fn pixels(&mut self, key: Key) -> Option<Pixels> {
        self.read(key).map(|reading| Pixels::new(reading.value))
    }

    fn measured(&mut self, key: Key) -> Option<Measured> {
        self.read(key)
            .map(|reading| Measured::new(reading.value, reading.sigma.unwrap_or(0.0)))
    }
}

fn point(fields: &mut Fields<'_>, solution: &Solution) -> Option<Point> {
    let [cx, cy, u, v] = Geometry::POINT.map(|key| fields.pixels(key));
    let (cx, cy, u, v) = (cx?, cy?, u?, v?);
    let fx = solution.problem.focal_length?;
    let depth = solution.stereo.distance().or(solution.monocular.distance())?;
    // The size of the image does not matter here.
    let camera = Intrinsics {
        fx,
        fy: fx,
        cx,
        cy,
        width: fx,
        height: fx,
    };
    let (x, y) = camera.point(u, v, depth)?;
    let range = camera.range(u, v, depth)?;
    Some(Point { x, y, depth, range })
}

fn tilted(fields: &mut Fields<'_>, solution: &Solution) -> Option<Tilted> {
    let tilt = Angle::from_radians(fields.read(TILT)?.value);
    let apparent = solution.monocular.distance()?;
    let depth = camera::depth_of_tilted_target(apparent, tilt);
    if depth.is_none() {
        fields.notes.push(Note::error(TILT, Issue::TiltTooLarge));
    }
    Some(Tilted { apparent, depth: depth? })
}

fn floor(fields: &mut Fields<'_>, solution: &Solution) -> Option<Measured> {
    let height = fields.measured(CAMERA_HEIGHT);
    let pitch = fields.measured(CAMERA_PITCH);
    let row = fields.measured(FLOOR_ROW);
    let cy = fields.pixels(CY);
    let view = GroundView {
        height: height?,
        pitch: pitch?,
        row: row?,
        fy: solution.problem.focal_length?,
        cy: cy?,
    };
    let (key, issue) = match view.distance() {
        Ok(distance) => return Some(distance),
        Err(NoGround::AboveHorizon) => (FLOOR_ROW, Issue::AboveHorizon),
        Err(NoGround::BelowCamera) => (CAMERA_PITCH, Issue::BelowCamera),
        Err(NoGround::Unusable) => (CAMERA_HEIGHT, Issue::UnusableGround),
        Err(NoGround::TooExtreme) => (CAMERA_HEIGHT, Issue::GroundTooExtreme),
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
            let tilted = doorway(&[(TILT, tilt)]).tilted.unwrap();
            assert!((tilted.depth.m() - 4.275 / 2.0).abs() < 1e-12, "{tilt}");
            assert!((tilted.excess() - 1.0).abs() < 1e-12, "{tilt}");
        }
        assert_eq!(doorway(&[(TILT, "90")]).note(TILT).unwrap().issue, Issue::TiltTooLarge);
        assert!(doorway(&[(TILT, "60 px")]).note(TILT).is_some());
    }

    /// A level camera 1 m above the floor sees a point 950 rows below its middle at 45°, 1 m away.
    #[test]
    fn a_sigma_that_cannot_be_read_is_a_note_and_no_zero() {
        let floor = |row: &str| doorway(&[(CAMERA_HEIGHT, "100 cm ± 1 cm"), (CAMERA_PITCH, "0"), (FLOOR_ROW, row), (CY, "300")]);
        let distance = floor("1250").floor.unwrap();
        assert!((distance.value - 1.0).abs() < 1e-12 && (distance.sigma - 0.01).abs() < 1e-12);
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
