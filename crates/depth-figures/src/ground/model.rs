//! What is known of a camera above a floor, and what is written about it.

use depth_core::angle::{Angle, AngleUnit};
use depth_core::measured::Measured;
use depth_core::quantity::{Length, LengthUnit};
use depth_text::assess::Assessment;
use depth_text::field::Key;
use depth_text::fields::{CAMERA_HEIGHT, CAMERA_PITCH, CX, CY, FLOOR_ANGLE, FLOOR_COLUMN, FLOOR_ROW, TARGET_HEIGHT};
use depth_text::number;
use depth_text::style::Style;

/// A camera above a floor, and a point that it sees: on the floor, or level above it.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// Height of the lens above the floor, m, and how it is written.
    pub height: (f64, String),
    /// Height of the point above the floor, m, and how it is written where it is not 0.
    pub target: (f64, Option<String>),
    /// How far the optical axis points down, rad, and how that is written.
    pub pitch: (f64, String),
    /// How far below the optical axis the point is seen, rad, and how that is written.
    pub below_axis: (f64, String),
    /// How far ahead the point is.
    pub ahead: Measured<Length>,
    /// How far to the right; `None` where that was not asked for.
    pub right: Option<Measured<Length>>,
    /// Both together.
    pub distance: Measured<Length>,
    /// The image; `None` where the point was given by its angle.
    pub eye: Option<Eye>,
    /// The unit of the results.
    pub unit: LengthUnit,
}

/// The image of the camera, px.
#[derive(Clone, Debug, PartialEq)]
pub struct Eye {
    /// Focal lengths along rows and columns; that along the rows where it is known.
    pub focal: [f64; 2],
    /// The principal point; its column is that of a 4:3 image where it is not known.
    pub center: [f64; 2],
    /// Where the point is; its column only where it was typed.
    pub column: Option<(f64, String)>,
    /// Its row, and how that is written.
    pub row: (f64, String),
    /// The row at which the floor ends.
    pub horizon: Option<f64>,
}

impl Model {
    /// What `assessment` says about the ground plane; `None` while it says nothing.
    pub fn new(assessment: &Assessment, unit: LengthUnit) -> Option<Self> {
        let ground = assessment.geometry.ground?;
        let value = |key: Key| assessment.reading(key).map(|reading| reading.value);
        let typed = |reading| number::with_minus(&Style::WINDOW.typed(reading));
        let text = |key: Key| assessment.reading(key).map_or_else(String::new, typed);
        let degrees = |radians: f64| {
            let degrees = Angle::from_radians(radians).in_unit(AngleUnit::Degree);
            format!("{}°", number::with_minus(&number::significant(degrees, 4)))
        };
        let eye = Eye::new(assessment, &text, ground.horizon_row.map(|row| row.px()));
        let below = match (&eye, value(FLOOR_ANGLE)) {
            (_, Some(angle)) => (angle, text(FLOOR_ANGLE)),
            (Some(eye), None) => {
                let angle = eye.slope_down(eye.row.0).atan();
                (angle, degrees(angle))
            }
            (None, None) => return None,
        };
        let target_m = value(TARGET_HEIGHT).unwrap_or(0.0);
        let model = Self {
            height: (value(CAMERA_HEIGHT)?, text(CAMERA_HEIGHT)),
            target: (target_m, (target_m != 0.0).then(|| text(TARGET_HEIGHT))),
            pitch: (value(CAMERA_PITCH)?, text(CAMERA_PITCH)),
            below_axis: below,
            ahead: ground.ahead,
            right: ground.right,
            distance: ground.distance,
            eye,
            unit: Style::WINDOW.unit_of(ground.distance.value, unit),
        };
        let drawable = |length: f64| length == 0.0 || (1e-12..1e12).contains(&length.abs());
        let lengths = [model.height.0, model.target.0, model.ahead.value.m(), model.right_m()];
        lengths.into_iter().all(drawable).then_some(model)
    }

    /// How far to the right, m; 0 where that was not asked for.
    pub(super) fn right_m(&self) -> f64 {
        self.right.map_or(0.0, |right| right.value.m())
    }

    /// A length without its sign and with the digits that its σ leaves: "3.08 m".
    pub(super) fn length(&self, length: Measured<Length>) -> String {
        let size = Measured::new(Length::from_m(length.value.m().abs()), length.sigma);
        Style::WINDOW.length_like(size.value, size, self.unit)
    }

    /// The row at which a point as high as this one and `ahead` is seen, px; `None` without an image, and where it is not in front of
    /// the camera.
    pub fn row_at(&self, ahead: Length) -> Option<f64> {
        let eye = self.eye.as_ref()?;
        let down = (self.height.0 - self.target.0).atan2(ahead.m()) - self.pitch.0;
        let is_in_front = down.abs() < std::f64::consts::FRAC_PI_2;
        is_in_front.then(|| eye.center[1] + eye.focal[1] * down.tan())
    }

    /// Where the ray of these slopes to the right of the axis and below it meets the floor, m to the right and ahead.
    pub(super) fn on_floor(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        let (sin, cos) = self.pitch.0.sin_cos();
        let down = sin + y * cos;
        let s = self.height.0 / down;
        (down > 0.0 && s.is_finite()).then_some([s * x, s * (cos - y * sin)])
    }
}

impl Eye {
    fn new(assessment: &Assessment, text: &dyn Fn(Key) -> String, horizon: Option<f64>) -> Option<Self> {
        let value = |key: Key| assessment.reading(key).map(|reading| reading.value);
        let problem = &assessment.solution.problem;
        let px = |length: Option<depth_core::in_image::InImage>| length.and_then(|length| length.px()).map(|length| length.value.px());
        let fx = px(problem.focal_length);
        let fy = px(problem.fy).or(fx)?;
        let row = value(FLOOR_ROW)?;
        let cy = value(CY)?;
        let cx = value(CX).unwrap_or(cy * 4.0 / 3.0);
        Some(Self {
            focal: [fx.unwrap_or(fy), fy],
            center: [cx, cy],
            column: value(FLOOR_COLUMN).map(|column| (column, text(FLOOR_COLUMN))),
            row: (row, text(FLOOR_ROW)),
            horizon,
        })
    }

    /// The tangent of the angle below the axis at which `row` is seen.
    pub(super) fn slope_down(&self, row: f64) -> f64 {
        (row - self.center[1]) / self.focal[1]
    }

    /// Width and height of an image whose middle the principal point is, px.
    pub fn size(&self) -> [f64; 2] {
        self.center.map(|center| 2.0 * center)
    }
}
