//! The card of the top view: the object and the cameras can be moved.

use super::handle::{self, Slider};
use crate::app::calculator::card::Card;
use crate::app::command::Command;
use crate::app::context::AppContext;
use crate::app::sentences::{self as words, Description, Hint};
use crate::app::theme;
use crate::app::widgets::{cards, chart, figure, picture};
use crate::core::measured::Measured;
use crate::core::problem::{Field, Method, Problem, Solved};
use crate::core::quantity::Length;
use depth_figures::top_view::{Drag, Model, Options, Source, TopView};
use depth_figures::{Ink, Words};
use depth_text::fields;
use depth_text::report::strip::Mode;
use depth_text::style::Style;
use depth_text::unit::Unit;
use depth_text::{number, report};
use egui::{Id, Rect, Sense, Ui, vec2};

/// What the card keeps between frames.
#[derive(Debug, Default)]
pub struct TopViewCard {
    /// The scale that stands while something is moved.
    held: Option<f64>,
}

impl TopViewCard {
    /// Draws the card.
    pub fn ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>, height: f32) {
        let angle = cx.angle_between_rays();
        let source = Source {
            now: cx.session.assessment(),
            before: Some(cx.session.last()),
            unit: cx.unit(),
            angle: angle.as_deref(),
        };
        let Some(model) = Model::new(source) else {
            picture::empty_card_ui(ui, Card::TopView, Card::TopView.title(), height, &Hint::NoTopView);
            return;
        };
        let size = cards::inner_size(ui, height) - vec2(0.0, theme::FIGURE_NOTE);
        let can_move = cx.mode() == Mode::Distance;
        let options = Options {
            drag: if can_move { Drag::PointerAndKeys } else { Drag::No },
            hold: self.held,
        };
        let view = TopView::new(&model, [size.x, size.y], options, &figure::Fonts(ui.painter()));
        let frame = cards::Frame {
            title: Card::TopView.title(),
            caption: &view.caption,
            height: Some(height),
        };
        frame.ui(ui, Card::TopView, |ui| {
            // As high as the empty card.
            ui.spacing_mut().item_spacing.y = 0.0;
            let (rect, response) = ui.allocate_exact_size(size, Sense::CLICK);
            figure::paint(ui, &view.figure, rect.min);
            describe(ui, cx, &response, model.is_from_side);
            chart::menu_ui(&response, Card::TopView.title(), cx.commands);
            let (line, _) = ui.allocate_exact_size(vec2(size.x, theme::FIGURE_NOTE), Sense::hover());
            figure::line_ui(ui, line, &Words::new(view.note.as_str(), Ink::Muted));
            if can_move {
                self.ring_ui(ui, cx, &view, rect);
                self.cameras_ui(ui, cx, &view, rect);
            }
        });
    }

    /// The object: moved, it has another disparity.
    fn ring_ui(&mut self, ui: &Ui, cx: &mut AppContext<'_>, view: &TopView, rect: Rect) {
        let problem = &cx.session.assessment().solution.problem;
        let Some(disparity) = problem.disparity.and_then(|disparity| Some(disparity.px()?.value.px())) else {
            return;
        };
        let Some(distance) = cx.session.assessment().solution.stereo.distance() else {
            return;
        };
        let Some(ring) = view.ring else { return };
        let at = rect.min + vec2(ring.x, ring.y);
        let words = report::length(Some(distance), cx.unit());
        let slider = Slider {
            name: "Distance of the object",
            value: distance.m(),
            range: [0.0, 10.0 * distance.m()],
            words: &words,
        };
        let handle = handle::ui(ui, Id::unique("object in the top view"), at, &slider);
        self.hold(&handle.response, view);
        let dragged = handle.dragged_to.and_then(|pointer| view.distance_at(to_figure(rect, pointer)));
        let set = handle.set_to.map(Length::from_m);
        let stepped = (handle.steps != 0).then(|| Length::from_m(distance.m() * (1.0 + f64::from(handle.steps) / 100.0)));
        if let Some(moved) = stepped.or(set).or(dragged).filter(|moved| moved.m() > 0.0)
            && let Some(px) = disparity_at(cx, moved)
            && px != disparity
        {
            cx.commands.push(Command::Drag(fields::DISPARITY, px));
        }
        if handle.is_active() {
            handle::halo(ui, at);
        }
        if handle.is_settled() {
            cx.commands.push(Command::Settle);
        }
    }

    /// The right camera: moved, it has another baseline.
    fn cameras_ui(&mut self, ui: &Ui, cx: &mut AppContext<'_>, view: &TopView, rect: Rect) {
        let Some([_, right]) = view.cameras else { return };
        let Some(reading) = cx.session.assessment().reading(fields::BASELINE).cloned() else {
            return;
        };
        let Some(Unit::Length(unit)) = reading.unit else { return };
        let at = rect.min + vec2(right.x, right.y);
        let words = reading.text();
        let slider = Slider {
            name: "Baseline of the cameras",
            value: reading.number,
            range: [0.0, 10.0 * reading.number],
            words: &words,
        };
        let handle = handle::ui(ui, Id::unique("camera in the top view"), at, &slider);
        self.hold(&handle.response, view);
        let dragged = handle.dragged_to.and_then(|pointer| view.baseline_at(to_figure(rect, pointer)));
        let dragged = dragged.map(|baseline| baseline.in_unit(unit));
        let stepped = (handle.steps != 0).then(|| reading.number * (1.0 + f64::from(handle.steps) / 100.0));
        if let Some(moved) = stepped.or(handle.set_to).or(dragged).filter(|moved| *moved > 0.0) {
            let rounded = number::rounded_to(moved, moved / 200.0);
            if rounded > 0.0 && rounded != reading.number {
                cx.commands.push(Command::Drag(fields::BASELINE, rounded));
            }
        }
        if handle.is_active() {
            handle::halo(ui, at);
        }
        if handle.is_settled() {
            cx.commands.push(Command::Settle);
        }
    }

    fn hold(&mut self, response: &egui::Response, view: &TopView) {
        if response.drag_started() {
            self.held = Some(view.per_meter);
        }
        if response.drag_stopped() {
            self.held = None;
        }
    }
}

/// What the picture shows, in words.
fn describe(ui: &Ui, cx: &AppContext<'_>, response: &egui::Response, is_from_side: bool) {
    let (assessment, unit) = (cx.session.assessment(), cx.unit());
    let solution = &assessment.solution;
    let Some(best) = solution.best() else { return };
    let typed = |key| assessment.reading(key).map(|reading| Style::WINDOW.typed(reading));
    let has_stereo = solution.stereo.distance().is_some();
    let baseline = typed(fields::BASELINE).filter(|_| has_stereo);
    let width = typed(fields::REAL_WIDTH);
    let both = has_stereo && solution.monocular.distance().is_some();
    let description = Description::TopView(words::TopView {
        baseline: baseline.as_deref(),
        distance: &report::length(Some(best.distance.value), unit),
        origin: Some(best.origin).filter(|_| both),
        interval: solution.best_interval().map(|interval| (interval.near, interval.far)),
        is_from_side,
        width: width.as_deref(),
        unit,
    });
    picture::describe(ui, response, Card::TopView.title(), &description);
}

/// The disparity, px and without doffs, at which the stereo distance is `distance`, rounded to what a pointer can tell apart.
fn disparity_at(cx: &AppContext<'_>, distance: Length) -> Option<f64> {
    let problem = &cx.session.assessment().solution.problem;
    let without = Problem {
        disparity: None,
        ..*problem
    };
    match without.solve_for(Method::Stereo, Field::Disparity, Measured::exact(distance)) {
        Ok(Some(Solved::InImage(found))) => {
            let px = found.px()?.value.px();
            Some(number::rounded_to(px, px.abs() / 500.0))
        }
        _ => None,
    }
}

fn to_figure(rect: Rect, at: egui::Pos2) -> depth_figures::Point {
    depth_figures::Point::new(at.x - rect.left(), at.y - rect.top())
}
