//! The curve of distance against disparity for the current camera, with the current point on it, which can be dragged.

use super::card::Card;
use crate::app::command::Command;
use crate::app::sentences::{Description, Hint};
use crate::app::theme;
use crate::app::widgets::{picture, plot};
use crate::core::problem::{Field, Method, Problem, Solution};
use crate::core::quantity::{Length, LengthUnit, Pixels};
use depth_text::{number, report};
use egui::accesskit::{Action, ActionData, Role};
use egui::{Align2, CursorIcon, Id, Key, Rect, Response, Sense, Stroke, Ui, pos2, vec2};
use egui_plot::{Line, PlotPoint, PlotPoints, PlotResponse};

/// State between frames: while the point is dragged, the axes do not change.
#[derive(Debug, Default)]
pub struct Curve {
    held: Option<Model>,
}

/// The camera and the range of the axes. Coordinates on the plot are fractions of the two ends, so that every magnitude can
/// be drawn. Disparities are those that enter the formula, with doffs in them.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Model {
    /// What of every disparity on the axis is doffs; `None` where there is none.
    doffs_px: Option<f64>,
    /// The depth at one pixel of disparity from the center of projection, m: fx·b/(1 px).
    depth_at_one_px_m: f64,
    /// What is added to that: the focal length of a lens, less where distances are counted from.
    shift_m: f64,
    disparity_end_px: f64,
    depth_end_m: f64,
}

impl Model {
    /// The model of the pair of cameras in `problem`, with axes that show the curve on both sides of `disparity`, or of the middle of
    /// the usual disparities. `None` unless the pair is known and every number can be drawn.
    fn new(problem: &Problem, disparity: Option<Pixels>) -> Option<Self> {
        let (low, high) = Field::Disparity.usual_range();
        let center = disparity.unwrap_or(Pixels::new((low * high).sqrt()));
        let model = Self {
            doffs_px: problem.get(Field::Doffs),
            // Taken to the point that is shown: at one pixel a zero in front of the lens may be beyond it.
            depth_at_one_px_m: (problem.depth_at(center)?.m() - problem.shift().m()) * center.px(),
            shift_m: problem.shift().m(),
            disparity_end_px: plot::round_up(center.px() * 1.6),
            depth_end_m: plot::round_up(problem.depth_at(center)?.m() * 1.6),
        };
        [model.depth_at_one_px_m, model.disparity_end_px, model.depth_end_m, center.px()]
            .iter()
            .all(|value| value.is_normal())
            .then_some(model)
    }

    /// Points of the hyperbola from the top of the picture to its right end, as fractions of the axes.
    fn points(&self) -> Vec<[f64; 2]> {
        const POINTS: u32 = 96;
        // x·y of the hyperbola in fractions of the axes; the curve enters the picture at the top, where y is 1.
        let product = self.depth_at_one_px_m / self.disparity_end_px / self.depth_end_m;
        let shift = self.shift_m / self.depth_end_m;
        let start = (product / (1.0 - shift)).clamp(f64::MIN_POSITIVE, 1.0);
        (0..=POINTS)
            .map(|i| {
                // Equal steps of ln x are equal steps of ln y: smooth at both ends.
                let x = start.powf(1.0 - f64::from(i) / f64::from(POINTS));
                [x, product / x + shift]
            })
            .collect()
    }

    /// The disparity, without doffs, at fraction `x` of the axis, rounded to what the picture, `width` points wide, can resolve.
    fn disparity_at(&self, x: f64, width: f32) -> f64 {
        let resolution = 10f64.powf((self.disparity_end_px / f64::from(width.max(1.0))).log10().floor());
        let with_doffs = (x.clamp(0.0, 1.0) * self.disparity_end_px).max(resolution);
        let doffs = self.doffs_px.unwrap_or(0.0);
        // The number that the field will show; rounding may not take it out of the picture.
        let rounded = number::rounded_to(with_doffs - doffs, resolution);
        if rounded + doffs > 0.0 { rounded } else { with_doffs - doffs }
    }

    /// What the horizontal axis counts.
    const fn axis_label(&self) -> &'static str {
        match self.doffs_px {
            Some(_) => "Disparity + doffs (px)",
            None => "Disparity (px)",
        }
    }
}

impl Curve {
    /// Draws the picture; a drag of the point is added to `commands`.
    pub fn ui(&mut self, ui: &mut Ui, solution: &Solution, unit: LengthUnit, commands: &mut Vec<Command>) {
        let problem = &solution.problem;
        let disparity = problem.effective_disparity().filter(|_| solution.stereo.distance().is_some());
        let is_pair = problem.focal_length_of(Method::Stereo).is_some() && problem.baseline.is_some();
        let held = self.held.filter(|_| is_pair);
        let Some(model) = held.or_else(|| Model::new(problem, disparity)) else {
            self.held = None;
            let has_distance = solution.stereo.distance().is_some();
            let hint = if has_distance { Hint::NoPixelsForCurve } else { Hint::NoCurve };
            picture::empty_ui(ui, Card::Curve.title(), &hint);
            return;
        };
        let drawn = plot_ui(ui, model, unit);
        let typed = problem.disparity.and_then(|disparity| Some(disparity.px()?.value));
        let point = typed.zip(solution.stereo.distance());
        picture::describe(ui, &drawn.plot.response, Card::Curve.title(), &Description::Curve { point, unit });
        if let (Some((typed, distance)), Some(disparity)) = (point, disparity) {
            let point = Point {
                typed_px: typed.px(),
                ..Point::new(disparity, distance, unit)
            };
            self.point_ui(ui, &drawn, &point, commands);
        }
    }

    /// The point: painted, and moved by pointer, arrow keys and assistive technology.
    fn point_ui(&mut self, ui: &Ui, drawn: &Drawn, point: &Point, commands: &mut Vec<Command>) {
        let Drawn { model, plot } = drawn;
        let at = plot.transform.position_from_point(&PlotPoint::new(
            point.disparity_px / model.disparity_end_px,
            (point.distance_m / model.depth_end_m).min(1.0),
        ));
        let target = Rect::from_center_size(at, vec2(theme::CONTROL_HEIGHT_TOUCH, theme::CONTROL_HEIGHT_TOUCH));
        let handle = ui.interact(target, Id::unique("disparity point"), Sense::click_and_drag());
        point.describe(ui, &handle, model);
        paint_point(ui, &handle, plot.response.rect, at, &point.words());
        if handle.drag_started() {
            self.held = Some(*model);
        }
        if let Some(x) = wanted(ui, &handle, drawn, point) {
            let moved = model.disparity_at(x, plot.response.rect.width());
            if moved != point.typed_px {
                commands.push(Command::DragDisparity(moved));
            }
        }
        if handle.drag_stopped() {
            self.held = None;
        }
        if handle.drag_stopped() || handle.lost_focus() {
            commands.push(Command::Settle);
        }
        handle.on_hover_cursor(CursorIcon::Grab);
    }
}

/// The curve as it has been drawn.
struct Drawn {
    model: Model,
    plot: PlotResponse<()>,
}

/// The current point.
struct Point {
    /// As it enters the formula.
    disparity_px: f64,
    /// As it stands in the field, without doffs.
    typed_px: f64,
    distance_m: f64,
    /// The distance in the unit of the results.
    distance: String,
}

impl Point {
    fn new(disparity: Pixels, distance: Length, unit: LengthUnit) -> Self {
        Self {
            disparity_px: disparity.px(),
            typed_px: disparity.px(),
            distance_m: distance.m(),
            distance: report::length(Some(distance), unit),
        }
    }

    fn words(&self) -> String {
        format!("{} px → {}", number::plain(self.typed_px), self.distance)
    }

    /// Makes a slider of `handle` for assistive technology.
    fn describe(&self, ui: &Ui, handle: &Response, model: &Model) {
        ui.accesskit_node_builder(handle.id, |node| {
            node.set_role(Role::Slider);
            node.set_label("Disparity of the point, in pixels");
            let doffs = model.doffs_px.unwrap_or(0.0);
            node.set_numeric_value(self.typed_px);
            node.set_min_numeric_value(0.0 - doffs);
            node.set_max_numeric_value(model.disparity_end_px - doffs);
            node.add_action(Action::SetValue);
            node.set_value(self.words());
            node.add_action(Action::Increment);
            node.add_action(Action::Decrement);
        });
    }
}

/// Where on the axis of disparities, as a fraction of it, the person wants the point; `None` where it is to stay.
fn wanted(ui: &Ui, handle: &Response, drawn: &Drawn, point: &Point) -> Option<f64> {
    let Drawn { model, plot } = drawn;
    // All three are read, as reading consumes keys and requests. The keyboard has priority.
    let dragged = handle.dragged().then(|| handle.interact_pointer_pos()).flatten();
    let dragged = dragged.map(|pointer| plot.transform.value_from_position(pointer).x);
    let set = asked_for(ui, handle).map(|disparity| (disparity + model.doffs_px.unwrap_or(0.0)) / model.disparity_end_px);
    let steps = steps(ui, handle);
    let stepped = (steps != 0).then(|| point.disparity_px / model.disparity_end_px + f64::from(steps) / 100.0);
    stepped.or(set).or(dragged)
}

/// The disparity, in pixels, that assistive technology asks for.
fn asked_for(ui: &Ui, handle: &Response) -> Option<f64> {
    ui.input(|input| {
        let requests = input.accesskit_action_requests(handle.id, Action::SetValue);
        let numbers = requests.filter_map(|request| match request.data {
            Some(ActionData::NumericValue(number)) => Some(number),
            _ => None,
        });
        numbers.last()
    })
}

/// Hundredths of the axis that the keyboard or assistive technology asks to move the point by.
fn steps(ui: &Ui, handle: &Response) -> i32 {
    let asked = |input: &egui::InputState, action| i32::try_from(input.num_accesskit_action_requests(handle.id, action)).unwrap_or(0);
    let mut steps = ui.input(|input| asked(input, Action::Increment) - asked(input, Action::Decrement));
    if handle.has_focus() {
        let arrows = egui::EventFilter {
            horizontal_arrows: true,
            vertical_arrows: true,
            ..Default::default()
        };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(handle.id, arrows));
        ui.input_mut(|input| {
            for (key, sign) in [(Key::ArrowRight, 1), (Key::ArrowUp, 1), (Key::ArrowLeft, -1), (Key::ArrowDown, -1)] {
                for (modifiers, size) in [(egui::Modifiers::SHIFT, 10), (egui::Modifiers::NONE, 1)] {
                    steps += sign * size * i32::try_from(input.count_and_consume_key(modifiers, key)).unwrap_or(0);
                }
            }
        });
    }
    steps
}

fn paint_point(ui: &Ui, handle: &Response, frame: Rect, at: egui::Pos2, words: &str) {
    let palette = theme::palette(ui);
    let held = handle.hovered() || handle.dragged() || handle.has_focus();
    let color = if held { palette.text } else { palette.blue };
    ui.painter().circle(
        at,
        theme::CURVE_POINT_RADIUS,
        palette.surface,
        Stroke::new(theme::THICK_LINE, color),
    );
    label(ui, frame, at, words);
}

/// Writes `text` beside `at`, on the side where there is room.
fn label(ui: &Ui, frame: Rect, at: egui::Pos2, text: &str) {
    let palette = theme::palette(ui);
    let galley = ui
        .painter()
        .layout_no_wrap(text.to_owned(), theme::regular(theme::SMALL_SIZE), palette.text);
    let fits_right = at.x + theme::CURVE_LABEL_GAP + galley.size().x < frame.right();
    let x = if fits_right {
        at.x + theme::CURVE_LABEL_GAP
    } else {
        (at.x - theme::CURVE_LABEL_GAP - galley.size().x).max(frame.left())
    };
    let y = (at.y - theme::CURVE_LABEL_RISE - galley.size().y).clamp(frame.top(), frame.bottom() - galley.size().y);
    let rect = Align2::LEFT_TOP.anchor_size(pos2(x, y), galley.size());
    ui.painter()
        .rect_filled(rect.expand(theme::CURVE_LABEL_PADDING), theme::MARK_RADIUS, palette.surface);
    ui.painter().galley(rect.min, galley, palette.text);
}

fn plot_ui(ui: &mut Ui, model: Model, unit: LengthUnit) -> Drawn {
    let color = theme::palette(ui).blue;
    let depth_end = Length::from_m(model.depth_end_m).in_unit(unit);
    let disparity_end = model.disparity_end_px;
    let (x_marks, y_marks) = (plot::marks(disparity_end), plot::marks(depth_end));
    let plot = plot::plot_ui(ui, "curve", 0.0..=1.0)
        .x_axis_label(model.axis_label())
        .x_grid_spacer(move |_| x_marks.clone())
        .y_grid_spacer(move |_| y_marks.clone())
        .x_axis_formatter(move |mark, _| number::plain(mark.value * disparity_end))
        .y_axis_formatter(move |mark, _| plot::mark_label(mark, depth_end, unit))
        .show(ui, |plot| {
            let line = Line::new("distance", PlotPoints::from(model.points()));
            plot.line(line.color(color).width(theme::CURVE_LINE).allow_hover(false));
        });
    Drawn { model, plot }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    fn model(focal_length_px: f64, baseline_m: f64, disparity_px: Option<f64>) -> Option<Model> {
        let mut problem = Problem::default();
        problem.set(Field::FocalLength, Some(focal_length_px));
        problem.set(Field::Baseline, Some(baseline_m));
        Model::new(&problem, disparity_px.map(Pixels::new))
    }

    fn mug() -> Model {
        model(700.0, 0.1, Some(50.0)).unwrap()
    }

    #[test]
    fn the_axes_hold_the_current_point_with_room_around_it() {
        let model = mug();
        assert_eq!((model.disparity_end_px, model.depth_end_m), (100.0, 2.5));
    }

    #[test]
    fn every_point_of_the_curve_obeys_the_formula_and_lies_in_the_picture() {
        let model = mug();
        for [x, y] in model.points() {
            let (disparity, depth) = (x * model.disparity_end_px, y * model.depth_end_m);
            assert!((disparity * depth / 70.0 - 1.0).abs() < 1e-9);
            assert!((0.0..=1.000_001).contains(&x) && (0.0..=1.000_001).contains(&y));
        }
    }

    #[test]
    fn a_drag_gives_round_disparities_above_zero() {
        let model = mug();
        assert_eq!(model.disparity_at(0.6, 350.0), 60.0);
        assert_eq!(model.disparity_at(-3.0, 350.0), 0.1);
        assert!((model.disparity_at(0.333_33, 350.0) - 33.3).abs() < 1e-9);
    }

    /// 700 px · 0.1 m / (50 px + 40 px): the point lies on the curve, and a drag sets the disparity without doffs.
    #[test]
    fn doffs_is_part_of_the_axis_and_not_of_what_is_dragged() {
        let mut problem = Problem::default();
        for (field, value) in [
            (Field::FocalLength, 700.0),
            (Field::Baseline, 0.1),
            (Field::Disparity, 50.0),
            (Field::Doffs, 40.0),
        ] {
            problem.set(field, Some(value));
        }
        let disparity = problem.effective_disparity().unwrap();
        let model = Model::new(&problem, Some(disparity)).unwrap();
        let on_curve = model.depth_at_one_px_m / disparity.px();
        assert!((on_curve - problem.solve().stereo.distance().unwrap().m()).abs() < 1e-12);
        let x = disparity.px() / model.disparity_end_px;
        assert!((model.disparity_at(x, 350.0) - 50.0).abs() < 1.0);
        assert!(model.disparity_at(0.0, 350.0) + 40.0 > 0.0);
    }

    #[test]
    fn extreme_cameras_have_no_curve_rather_than_a_broken_one() {
        assert_eq!(model(1e300, 1e300, None), None);
        assert!(model(1e150, 1e-150, None).is_some());
    }
}
