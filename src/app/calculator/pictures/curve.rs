//! The card of the curve: the crosshair under the pointer, and the point that can be moved.

use super::handle::{self, Handle, Slider};
use crate::app::calculator::card::Card;
use crate::app::command::Command;
use crate::app::context::AppContext;
use crate::app::sentences::{Description, Hint};
use crate::app::theme;
use crate::app::widgets::{cards, chart, figure, picture};
use crate::core::quantity::{LengthUnit, Pixels};
use depth_figures::curve::{Axes, Curve, CurveModel, Shown};
use depth_text::fields;
use depth_text::{number, report};
use egui::{Id, Rect, Response, Sense, Stroke, Ui, vec2};

/// What the card of a curve keeps between frames.
#[derive(Debug, Default)]
pub struct CurveCard {
    /// The axes that were drawn last, and where they are going: they stand while the point is moved, and follow when it is let go.
    axes: Option<Moving>,
}

/// Axes on their way.
#[derive(Clone, Debug)]
struct Moving {
    drawn: Axes,
    /// What they come from, and since when, s.
    from: Option<(Axes, f64)>,
    is_held: bool,
}

/// How long axes take to follow, s.
const FOLLOWING: f64 = 0.25;

impl CurveCard {
    /// Draws the card.
    pub fn ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>, card: Card, height: f32) {
        let Some(model) = model(cx, card) else {
            self.axes = None;
            let solution = &cx.session.assessment().solution;
            let hint = if card == Card::InverseCurve {
                Hint::NoInverseCurve
            } else if solution.stereo.distance().is_some() {
                Hint::NoPixelsForCurve
            } else {
                Hint::NoCurve
            };
            picture::empty_card_ui(ui, card, card.title(), height, &hint);
            return;
        };
        let caption = model.caption();
        let frame = cards::Frame {
            title: card.title(),
            caption: &caption,
            height: Some(height),
        };
        let size = cards::inner_size(ui, height);
        frame.ui(ui, card, |ui| {
            let (rect, response) = ui.allocate_exact_size(size, Sense::CLICK);
            // Before the point on it, which a finger that explores the page finds on top.
            describe(ui, cx, card, &response);
            let axes = self.axes_of(ui, &model);
            let bare = model.layout(
                size.x,
                size.y,
                &Shown {
                    axes: Some(&axes),
                    tip: None,
                },
                &figure::Fonts(ui.painter()),
            );
            let held = self.handle_ui(ui, cx, (&model, &bare), rect);
            let tip = tip((&model, &bare), rect, &response, held.as_ref());
            let drawn = match tip {
                Some(tip) => model.layout(
                    size.x,
                    size.y,
                    &Shown {
                        axes: Some(&axes),
                        tip: Some(tip),
                    },
                    &figure::Fonts(ui.painter()),
                ),
                None => bare,
            };
            crosshair_ui(ui, &drawn, rect, tip);
            figure::paint(ui, &drawn.figure, rect.min);
            if let (Some(handle), Some(point)) = (&held, drawn.handle)
                && handle.is_active()
            {
                let color = theme::palette(ui).blue;
                let at = rect.min + vec2(point.x, point.y);
                ui.painter()
                    .circle_stroke(at, theme::HANDLE_HALO, Stroke::new(theme::THIN_LINE, color));
            }
            chart::menu_ui(&response, card.title(), cx.commands);
        });
    }

    /// The axes of this frame: those of the model, or on the way to them.
    fn axes_of(&mut self, ui: &Ui, model: &CurveModel) -> Axes {
        let wanted = model.axes().clone();
        let now = ui.input(|input| input.time);
        let lasts = if ui.style().animation_time > 0.0 { FOLLOWING } else { 0.0 };
        let Some(moving) = &mut self.axes else {
            self.axes = Some(Moving {
                drawn: wanted.clone(),
                from: None,
                is_held: false,
            });
            return wanted;
        };
        if moving.is_held {
            return moving.drawn.clone();
        }
        let Some((from, since)) = &moving.from else {
            moving.drawn = wanted.clone();
            return wanted;
        };
        let part = if lasts > 0.0 {
            ((now - since) / lasts).clamp(0.0, 1.0)
        } else {
            1.0
        };
        // Fast at first, and then slower.
        let eased = 1.0 - (1.0 - part).powi(3);
        moving.drawn = from.eased(&wanted, eased);
        if part >= 1.0 {
            moving.from = None;
        } else {
            ui.ctx().request_repaint();
        }
        moving.drawn.clone()
    }

    /// The point, where it can be moved.
    fn handle_ui(&mut self, ui: &Ui, cx: &mut AppContext<'_>, (model, curve): (&CurveModel, &Curve), rect: Rect) -> Option<Handle> {
        let point = curve.handle.filter(|_| !model.is_stale)?;
        let typed = cx.session.assessment().reading(fields::DISPARITY)?;
        let is_pixels = cx.session.assessment().solution.problem.disparity?.px().is_some();
        if !is_pixels || model.kind != depth_figures::curve::Kind::Distance {
            return None;
        }
        let doffs = model.doffs();
        let at = rect.min + vec2(point.x, point.y);
        let distance = report::length(cx.session.assessment().solution.stereo.distance(), cx.unit());
        let words = format!("{} px → {distance}", number::plain(typed.value));
        let slider = Slider {
            name: "Disparity of the point, in pixels",
            value: typed.value,
            range: [0.0 - doffs, curve.axes.x.high - doffs],
            words: &words,
        };
        let handle = handle::ui(ui, Id::unique("disparity point"), at, &slider);
        if handle.response.drag_started()
            && let Some(moving) = &mut self.axes
        {
            moving.is_held = true;
        }
        let step = curve.axes.x.high / 100.0;
        let to_x = |disparity: f64| curve.x_of(disparity + doffs);
        let wanted = if handle.steps != 0 {
            Some(to_x(typed.value + f64::from(handle.steps) * step))
        } else {
            let set = handle.set_to.map(to_x);
            set.or(handle.dragged_to.map(|pointer| pointer.x - rect.left()))
        };
        if let Some(x) = wanted {
            let moved = curve.disparity_at(x);
            if moved != typed.value {
                cx.commands.push(Command::Drag(fields::DISPARITY, moved));
            }
        }
        if handle.response.drag_stopped()
            && let Some(moving) = &mut self.axes
        {
            moving.is_held = false;
            moving.from = Some((moving.drawn.clone(), ui.input(|input| input.time)));
            ui.ctx().request_repaint();
        }
        if handle.is_settled() {
            cx.commands.push(Command::Settle);
        }
        Some(handle)
    }
}

/// What is drawn: of the distance, or of the disparity for a distance that is given.
fn model(cx: &AppContext<'_>, card: Card) -> Option<CurveModel> {
    let (now, last, unit): (_, _, LengthUnit) = (cx.session.assessment(), cx.session.last(), cx.unit());
    if card == Card::InverseCurve {
        return CurveModel::inverse_of(cx.session.answered(), unit);
    }
    let mut model = CurveModel::new(&now.solution, Some(&last.solution), unit)?;
    if let (Some(point), Some(reading), false) = (&mut model.point, now.reading(fields::DISPARITY), model.is_stale) {
        let is_plain = reading.unit == fields::DISPARITY.kind.default_unit() && now.solution.problem.doffs.is_none();
        if is_plain && reading.number_text.chars().count() <= 8 {
            point.x_text.clone_from(&reading.number_text);
        }
    }
    Some(model)
}

/// Where a tip is shown: at the pointer, else at the point while it is in use.
fn tip((model, curve): (&CurveModel, &Curve), rect: Rect, response: &Response, held: Option<&Handle>) -> Option<f64> {
    let at_point = held
        .filter(|handle| handle.is_active())
        .and(model.point.as_ref())
        .map(|point| point.x);
    if at_point.is_some() {
        return at_point;
    }
    let hovered = response
        .hover_pos()
        .and_then(|pointer| model.crosshair(curve, pointer.x - rect.left()))
        .map(|cross| cross.x);
    hovered.or_else(|| response.has_focus().then(|| model.point.as_ref().map(|point| point.x)).flatten())
}

/// Thin lines through the place that the tip is about.
fn crosshair_ui(ui: &Ui, curve: &Curve, rect: Rect, tip: Option<f64>) {
    let Some(x) = tip else { return };
    let x = rect.left() + curve.x_of(x);
    let plot = rect.top() + curve.plot.top..=rect.top() + curve.plot.bottom;
    ui.painter()
        .vline(x, plot, Stroke::new(theme::THIN_LINE, theme::palette(ui).border));
}

fn describe(ui: &Ui, cx: &AppContext<'_>, card: Card, response: &Response) {
    let solution = &cx.session.assessment().solution;
    let typed = solution
        .problem
        .disparity
        .and_then(|disparity| Some(Pixels::new(disparity.px()?.value.px())));
    let point = typed.zip(solution.stereo.distance());
    let unit = cx.unit();
    match card {
        Card::InverseCurve => picture::describe(ui, response, card.title(), &Description::InverseCurve { point: None }),
        _ => picture::describe(ui, response, card.title(), &Description::Curve { point, unit }),
    }
}
