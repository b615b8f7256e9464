//! The picture with what is written beside it, and what a drag in it stands for.

use super::draw::Drawing;
use super::fit::{Fit, Span};
use super::model::{Model, Sight};
use super::options::{Drag, Options};
use crate::{Figure, Measure, Point, Rect, below};
use depth_core::quantity::Length;

/// The picture, what is written beside it, and where things are that can be dragged.
#[derive(Clone, Debug, PartialEq)]
pub struct TopView {
    /// The picture.
    pub figure: Figure,
    /// At the right of the title: "to scale, grid 0.5 m".
    pub caption: String,
    /// Below the picture: "Ellipse: 1 σ, drawn 10 × as large. The ring can be dragged."
    pub note: String,
    /// Where the grid is.
    pub plot: Rect,
    /// The object at its stereo distance; `None` without one. Dragged, it is another disparity.
    pub ring: Option<Point>,
    /// The left and the right camera of the stereo distance. Dragged, they are another baseline.
    pub cameras: Option<[Point; 2]>,
    /// Points per meter.
    pub per_meter: f64,
    depth_m: f64,
    zero_m: f64,
    baseline_m: f64,
    pub(super) ground: Point,
}

impl TopView {
    /// The picture of `model`, `width` and `height` points large.
    pub fn new(model: &Model, [width, height]: [f32; 2], options: Options, measure: &dyn Measure) -> Self {
        let fit = Fit::new(model, [width, height], options, measure);
        let center = fit.center();
        let cameras = fit
            .baseline
            .map(|span| [-1.0, 1.0].map(|side| Point::new(center + side * span.half, fit.ground())));
        let main = model.stereo.as_ref().or(model.monocular.as_ref());
        let drawing = Drawing { model, fit: &fit, measure };
        Self {
            figure: drawing.figure([width, height]),
            caption: caption(model, &fit),
            note: note(model, &fit, options.drag, width, measure),
            plot: fit.plot,
            ring: fit.stereo_y.map(|y| Point::new(center, y)),
            cameras,
            per_meter: fit.per_meter,
            depth_m: main.map_or(0.0, |sight| sight.depth_m),
            zero_m: model.zero_m,
            baseline_m: model.baseline.as_ref().map_or(0.0, |(meters, _)| *meters),
            ground: fit.scale.origin,
        }
    }

    /// The distance that the ring stands for when it is dragged to `at`, counted from where distances are counted; `None` without a
    /// ring, and at the cameras or behind them.
    pub fn distance_at(&self, at: Point) -> Option<Length> {
        let drawn = f64::from(self.ground.y - self.ring?.y);
        // A ring that is drawn farther away than it is moves in proportion.
        let depth = f64::from(self.ground.y - at.y) / drawn * self.depth_m;
        (depth > 0.0 && depth > self.zero_m).then(|| Length::from_m(depth - self.zero_m))
    }

    /// The baseline that the cameras stand for when one of them is dragged to `at`; `None` without two of them.
    pub fn baseline_at(&self, at: Point) -> Option<Length> {
        let [left, right] = self.cameras?;
        let drawn = f64::from(right.x - left.x);
        let apart = 2.0 * f64::from((at.x - self.ground.x).abs());
        (apart > 0.0).then(|| Length::from_m(apart / drawn * self.baseline_m))
    }
}

/// "to scale but for b and ±, grid 0.5 m"
fn caption(model: &Model, fit: &Fit) -> String {
    let is_broken = |span: Option<Span>| span.is_some_and(|span| span.is_broken);
    let not = [
        (is_broken(fit.baseline), "b"),
        (is_broken(fit.object), "w_real"),
        (fit.ellipse.is_some_and(|ellipse| ellipse.factor > 1.0), "±"),
    ];
    let not: Vec<&str> = not.into_iter().filter_map(|(is_not, what)| is_not.then_some(what)).collect();
    let but = if not.is_empty() {
        String::new()
    } else {
        format!(" but for {}", not.join(", "))
    };
    format!("to scale{but}, {}", fit.grid_text(model))
}

/// The line below the picture.
fn note(model: &Model, fit: &Fit, drag: Drag, width: f32, measure: &dyn Measure) -> String {
    let is_stale = |sight: &Option<Sight>| sight.as_ref().is_some_and(|sight| sight.is_stale);
    let mut sentences = Vec::new();
    match (is_stale(&model.stereo), is_stale(&model.monocular)) {
        (true, true) => sentences.push("Gray: the last valid distances.".to_owned()),
        (true, false) => sentences.push("Gray: the last valid stereo distance.".to_owned()),
        (false, true) => sentences.push("Gray: the last valid monocular distance.".to_owned()),
        (false, false) => match fit.ellipse {
            Some(ellipse) => {
                let has_bracket = model.monocular.as_ref().is_some_and(|sight| sight.sigma_m > 0.0);
                let what = if has_bracket { "Ellipse, bracket" } else { "Ellipse" };
                sentences.push(if ellipse.factor > 1.0 {
                    format!("{what}: 1 σ, drawn {:.0} × as large.", ellipse.factor)
                } else {
                    format!("{what}: 1 σ.")
                });
            }
            None if model.stereo.is_none() && model.monocular.as_ref().is_some_and(|sight| sight.sigma_m > 0.0) => {
                sentences.push("Bracket: ± 1 σ.".to_owned());
            }
            None => {}
        },
    }
    if model.is_aside {
        sentences.push("Drawn straight ahead.".to_owned());
    }
    if model.is_from_side {
        sentences.push("Seen from the side.".to_owned());
    }
    let so_far = sentences.join(" ");
    let with_keys = "The ring can be dragged, or moved with the arrow keys.";
    if model.stereo.is_some() && drag != Drag::No {
        let has_room = drag == Drag::PointerAndKeys && below::fits(&format!("{so_far} {with_keys}"), width, measure);
        sentences.push(if has_room { with_keys } else { "The ring can be dragged." }.to_owned());
    }
    below::fitted(&sentences, width, measure)
}
