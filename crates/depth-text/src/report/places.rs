//! Where things are: a point in space, a point on the floor, two photographs, two points.

use crate::geometry::PointOrigin;
use crate::style::Style;
use depth_core::camera::{GroundSolution, PointSolution};
use depth_core::measured::Measured;
use depth_core::problem::{Method, Origin, Problem};
use depth_core::quantity::{Length, LengthUnit};
use depth_core::two_points::TwoPointsSolution;
use depth_core::two_shots::TwoShotsSolution;

/// The point in space, a name and a value each, in `unit`; of the `problem` whose zero its Z and R are counted from.
pub fn point(style: Style, problem: &Problem, point: &PointSolution, unit: LengthUnit) -> [(&'static str, String); 4] {
    let range = if problem.zero.is_some_and(|zero| zero.m() != 0.0) {
        "R, range from where the tape starts"
    } else {
        "R, range from the lens"
    };
    [
        ("X, to the right", style.measured(point.x, unit)),
        ("Y, down", style.measured(point.y, unit)),
        ("Z, depth along the axis", style.measured(point.z, unit)),
        (range, style.measured(point.range, unit)),
    ]
}

/// Where the distance of a point is from: "from the combined distance".
pub const fn point_origin(origin: PointOrigin) -> &'static str {
    match origin {
        PointOrigin::Distance(Origin::Combined) => "from the combined distance",
        PointOrigin::Distance(Origin::Method(Method::Stereo)) => "from the stereo distance",
        PointOrigin::Distance(Origin::Method(Method::Monocular)) => "from the monocular distance",
        PointOrigin::Given(_) => "from the distance that was given",
        PointOrigin::Range => "from the range",
    }
}

/// What a depth is called that a range by tape gives.
pub const DEPTH_OF_RANGE: &str = "depth along the axis, from the range";

/// What two photographs say, a name and a value each, in `unit`.
pub fn two_shots(style: Style, shots: &TwoShotsSolution, unit: LengthUnit) -> Vec<(&'static str, String)> {
    let size = shots.size.map(|size| ("Width of the object", style.measured(size, unit)));
    let distances = [
        (FROM_FIRST_PLACE, style.measured(shots.far, unit)),
        ("From the second place", style.measured(shots.near, unit)),
    ];
    distances.into_iter().chain(size).collect()
}

/// The name of the distance from where the first of two photographs was taken.
pub const FROM_FIRST_PLACE: &str = "From the first place";

/// What two points say, a name and a value each, in `unit`.
pub fn two_points(style: Style, points: &TwoPointsSolution, unit: LengthUnit) -> [(&'static str, String); 4] {
    ways_between(points).map(|(name, length)| (name, style.measured(length, unit)))
}

/// From the first point to the second: in a straight line, and which way how far. No length has a sign: its name says the way.
pub fn ways_between(points: &TwoPointsSolution) -> [(&'static str, Measured<Length>); 4] {
    let way = |[ahead, back]: [&'static str; 2], length: Measured<Length>| {
        let size = Measured::from_base(length.value.m().abs(), length.sigma.m());
        (if length.value.m() < 0.0 { back } else { ahead }, size)
    };
    [
        (BETWEEN_POINTS, points.distance),
        way(["Farther away", "Nearer"], points.dz),
        way(["To the right", "To the left"], points.dx),
        way(["Down", "Up"], points.dy),
    ]
}

/// What those ways are called before there are two points.
pub const WAYS_BETWEEN: [&str; 4] = [BETWEEN_POINTS, "Farther away", "To the right", "Down"];

/// The name of the length between two points.
pub const BETWEEN_POINTS: &str = "Between the points";

/// The name of the distance on the floor.
pub const ALONG_FLOOR: &str = "Along the floor";

/// The point on the floor, a name and a value each, in `unit`.
pub fn ground(style: Style, ground: &GroundSolution, unit: LengthUnit) -> Vec<(&'static str, String)> {
    let ahead = if ground.ahead.value.m() < 0.0 {
        let behind = Measured::from_base(-ground.ahead.value.m(), ground.ahead.sigma.m());
        ("Straight behind", behind)
    } else {
        ("Straight ahead", ground.ahead)
    };
    let right = ground.right.map(|right| {
        if right.value.m() < 0.0 {
            ("To the left", Measured::from_base(-right.value.m(), right.sigma.m()))
        } else {
            ("To the right", right)
        }
    });
    let lines = [
        Some(ahead),
        right,
        Some((ALONG_FLOOR, ground.distance)),
        Some(("Slant, from the lens", ground.slant)),
        Some(("Depth, from the lens", ground.depth)),
    ];
    lines
        .into_iter()
        .flatten()
        .map(|(name, value)| (name, style.measured(value, unit)))
        .collect()
}
