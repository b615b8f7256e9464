//! Where everything of the top view is, in points.

use super::model::{Model, Sight};
use super::options::Options;
use crate::floor::{LABEL_TEXT, Scale, grid_step, room_for_ticks, step_text, to_f32};
use crate::labels::Label;
use crate::{Ink, Measure, Point, Rect, Words};
use depth_core::quantity::Length;

/// Radius of the ring.
pub(super) const RING: f32 = 6.0;
/// Above the deepest thing: room for its ellipse and the dimension of the object.
const ABOVE: f32 = 36.0;
/// From the line of 0 to the lower edge.
const BELOW: f32 = 42.0;
/// At each side of a wide object: room for a dimension line.
const MARGIN: f32 = 34.0;
/// Cameras closer than this cannot be told apart.
const CLOSEST_CAMERAS: f32 = 12.0;
/// How far apart they are drawn then.
const APART: f32 = 28.0;
/// No distance is drawn shorter than this; the smaller one of two that disagree by as much as this says that it is.
const SHORTEST: [f32; 2] = [30.0, 20.0];
/// The ellipse is drawn up to this high, half of it.
const HIGHEST_ELLIPSE: f64 = 23.0;
/// The same of the bracket beside it.
const HIGHEST_BRACKET: f64 = 48.0;
/// Smaller than this it would hide behind the ring.
const LOWEST_ELLIPSE: f64 = 8.5;
/// A line is not narrower than this.
const NARROWEST_ELLIPSE: f64 = 4.5;

/// A length as it is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Span {
    /// Half of it, points.
    pub(super) half: f32,
    /// Whether it is drawn longer or shorter than it is.
    pub(super) is_broken: bool,
}

/// The error ellipse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ellipse {
    /// Half its width and half its height, points.
    pub(super) radii: [f32; 2],
    /// How many times as large it is drawn.
    pub(super) factor: f64,
}

/// Where everything is.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Fit {
    pub(super) plot: Rect,
    pub(super) scale: Scale,
    pub(super) per_meter: f64,
    /// The distance of grid lines, in the unit of the model.
    pub(super) step: f64,
    pub(super) baseline: Option<Span>,
    pub(super) object: Option<Span>,
    /// Height of the stereo and the monocular distance.
    pub(super) stereo_y: Option<f32>,
    pub(super) monocular_y: Option<f32>,
    /// Whether the nearer of both is drawn farther away than it is.
    pub(super) is_near_moved: bool,
    pub(super) ellipse: Option<Ellipse>,
}

impl Fit {
    pub(super) fn new(model: &Model, size: [f32; 2], options: Options, measure: &dyn Measure) -> Self {
        // The labels of the axis need room, and how much depends on the scale.
        let first = Self::beside(model, size, options, measure, 34.0);
        let largest = f64::from(first.scale.origin.y - first.plot.top) / first.per_meter;
        let left = room_for_ticks(measure, first.step, Length::from_m(largest).in_unit(model.unit));
        Self::beside(model, size, options, measure, left)
    }

    /// The fit with this much room for the labels at the left.
    fn beside(model: &Model, [width, height]: [f32; 2], options: Options, measure: &dyn Measure, left: f32) -> Self {
        let plot = Rect::new(left, 17.0, width, height - 19.0);
        let origin = Point::new(f32::midpoint(plot.left, plot.right), height - BELOW);
        let per_meter = options.hold.unwrap_or_else(|| points_per_meter(model, plot, origin, measure));
        let scale = Scale::even(origin, per_meter);
        let widest = (plot.width() / 2.0 - MARGIN).max(APART / 2.0);
        let baseline = model.baseline.as_ref().map(|(meters, _)| {
            let half = to_f32(meters / 2.0 * per_meter);
            let is_too_close = half < CLOSEST_CAMERAS / 2.0;
            Span {
                half: if is_too_close { APART / 2.0 } else { half.min(widest) },
                is_broken: is_too_close || half > widest + 0.5,
            }
        });
        let object = model.width.as_ref().map(|(meters, _)| {
            let half = to_f32(meters / 2.0 * per_meter);
            Span {
                half: half.min(widest),
                is_broken: half > widest + 0.5,
            }
        });
        let highest = plot.top + RING + 2.0;
        let y = |sight: &Sight| {
            let above = to_f32(sight.depth_m * per_meter);
            (origin.y - above.max(shortest(model))).max(highest)
        };
        let nearest = model.sights().map(|sight| sight.depth_m).fold(f64::INFINITY, f64::min);
        let (stereo_y, monocular_y) = (model.stereo.as_ref().map(y), model.monocular.as_ref().map(y));
        let ellipse = model.stereo.as_ref().zip(stereo_y).and_then(|(sight, y)| {
            let room = [f64::from(y - plot.top), f64::from(origin.y - y), f64::from(plot.width() / 4.0)];
            Ellipse::new(sight, model.monocular.as_ref(), per_meter, room)
        });
        Self {
            plot,
            scale,
            per_meter,
            step: grid_step(measure, per_meter, model.unit, f64::from(plot.width() / 2.0) / per_meter),
            baseline,
            object,
            stereo_y,
            monocular_y,
            is_near_moved: to_f32(nearest * per_meter) < shortest(model) - 0.5,
            ellipse,
        }
    }

    /// The middle of the cameras.
    pub(super) const fn center(&self) -> f32 {
        self.scale.origin.x
    }

    /// The line that the cameras stand on.
    pub(super) const fn ground(&self) -> f32 {
        self.scale.origin.y
    }

    /// Half of what the cameras and the object take, points.
    pub(super) fn half_extent(&self) -> f32 {
        let halves = [self.baseline, self.object].into_iter().flatten().map(|span| span.half);
        halves.fold(RING, f32::max)
    }

    /// "grid 0.5 m"
    pub(super) fn grid_text(&self, model: &Model) -> String {
        format!("grid {}", step_text(self.step, model.unit))
    }
}

/// The shortest that a distance is drawn: two that disagree need more room for the larger one.
fn shortest(model: &Model) -> f32 {
    let [alone, of_two] = SHORTEST;
    if model.sights().count() > 1 { of_two } else { alone }
}

/// The largest scale at which everything fits, with its labels beside it where that does not make it much smaller.
fn points_per_meter(model: &Model, plot: Rect, origin: Point, measure: &dyn Measure) -> f64 {
    let height = f64::from((origin.y - plot.top - ABOVE).max(40.0));
    let deepest = model.deepest();
    let with_sigma = model.sights().filter(|sight| sight.sigma_m < sight.depth_m);
    let with_sigma = with_sigma.map(|sight| sight.depth_m + sight.sigma_m).fold(deepest, f64::max);
    let vertical = (height / deepest).min((height + f64::from(ABOVE) - 18.0) / with_sigma);
    let lengths = [&model.baseline, &model.width].into_iter().flatten();
    let widest = lengths.map(|(meters, _)| *meters).fold(0.0, f64::max) / 2.0;
    if widest == 0.0 {
        return vertical;
    }
    let half = f64::from(plot.width() / 2.0);
    let of_labels = model
        .sights()
        .map(|sight| sight_label(sight, "D (monocular)", Ink::Text).width(measure))
        .fold(0.0, f32::max);
    let scale = |margin: f32| vertical.min((half - f64::from(margin)).max(10.0) / widest);
    let (beside, above) = (scale(of_labels + MARGIN), scale(MARGIN));
    let best = if beside >= 0.7 * above { beside } else { above };
    best.max(f64::from(SHORTEST[0]) / deepest)
}

/// "D (stereo)" above the distance.
pub(super) fn sight_label(sight: &Sight, name: &str, ink: Ink) -> Label {
    Label {
        lines: vec![Words::new(name, Ink::Muted), Words::strong(sight.text.clone(), ink)],
        size: LABEL_TEXT,
    }
}

impl Ellipse {
    /// As large as it is, or where that is too small to be seen, a round number of times as large; `None` where there is none to draw.
    /// The bracket of the monocular σ beside it is as many times as large, so that both can be compared.
    fn new(sight: &Sight, beside: Option<&Sight>, per_meter: f64, [above, below, aside]: [f64; 3]) -> Option<Self> {
        let [width, height] = [sight.across_m, sight.sigma_m].map(|sigma| sigma * per_meter);
        let bracket = beside.map_or(0.0, |beside| beside.sigma_m * per_meter);
        let most = beside.map_or(0.0, |beside| (0.4 * beside.depth_m * per_meter).min(HIGHEST_BRACKET));
        if !(height > 0.0 && height.is_finite()) {
            return None;
        }
        let factors = [100.0, 50.0, 20.0, 10.0, 5.0, 2.0];
        let factor = factors
            .into_iter()
            .find(|factor| height * factor <= HIGHEST_ELLIPSE && width * factor <= aside && bracket * factor <= most)
            .unwrap_or(1.0);
        let height = height * factor;
        let is_visible = height >= LOWEST_ELLIPSE && height <= below && height <= above + 0.5 && width * factor <= aside;
        is_visible.then(|| Self {
            radii: [(width * factor).max(NARROWEST_ELLIPSE), height].map(to_f32),
            factor,
        })
    }
}
