//! The scene from above, to scale: cameras, lines of sight, object. Three parts: a pure model, a pure layout, and painting.

mod model;

use super::card::Card;
use crate::app::sentences::Hint;
use crate::app::theme::{self, Palette, top_view as size};
use crate::app::widgets::plot::round_down;
use crate::app::widgets::{picture, text};
use crate::core::quantity::{Length, LengthUnit};
use depth_text::assess::Assessment;
use depth_text::number;
use egui::{Align2, Painter, Pos2, Rect, Sense, Shape, Stroke, Ui, Vec2, pos2, vec2};
use model::{Model, Words};

/// Draws the picture.
pub fn ui(ui: &mut Ui, assessment: &Assessment, unit: LengthUnit) {
    let palette = theme::palette(ui);
    let Some(model) = Model::new(&assessment.solution) else {
        picture::empty_ui(ui, Card::TopView.title(), &Hint::NoTopView);
        return;
    };
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), theme::PICTURE_HEIGHT), Sense::hover());
    let scene = Scene::new(&model, rect.shrink(size::PADDING));
    let words = Words::new(assessment, &model, unit);
    paint(&ui.painter().with_clip_rect(rect), palette, &model, &scene, &words);
    picture::describe(ui, &response, Card::TopView.title(), &model.description(&words));
    text::caption_ui(ui, model.remark().to_string());
}

/// The layout: positions on the screen, in points.
#[derive(Clone, Debug, PartialEq)]
struct Scene {
    /// The rectangle of the picture, part of which may be scrolled out of view.
    frame: Rect,
    points_per_meter: f64,
    cameras: Vec<Pos2>,
    object: Pos2,
    /// Ends of the object's width.
    edges: Option<[Pos2; 2]>,
    inset: Option<Inset>,
}

/// The cameras enlarged.
#[derive(Clone, Debug, PartialEq)]
struct Inset {
    frame: Rect,
    cameras: [Pos2; 2],
    factor: f64,
}

impl Scene {
    fn new(model: &Model, frame: Rect) -> Self {
        let height = f64::from((frame.height() - size::BELOW_CAMERAS - size::ABOVE_OBJECT).max(1.0));
        let width = f64::from((frame.width() * 0.8).max(1.0));
        let widest = model.baseline_m.unwrap_or(0.0).max(model.width_m.unwrap_or(0.0));
        // Both axes have the same scale, the largest that fits.
        let points_per_meter = (height / model.depth_m).min(if widest > 0.0 { width / widest } else { f64::INFINITY });
        let origin = pos2(frame.center().x, frame.bottom() - size::BELOW_CAMERAS);
        let place = |x_m: f64, z_m: f64| pos2(origin.x + to_f32(x_m * points_per_meter), origin.y - to_f32(z_m * points_per_meter));
        let cameras = match model.baseline_m {
            Some(baseline) => vec![place(-baseline / 2.0, 0.0), place(baseline / 2.0, 0.0)],
            None => vec![place(0.0, 0.0)],
        };
        let object = place(0.0, model.depth_m);
        let inset = model.baseline_m.and_then(|baseline| {
            let apart = baseline * points_per_meter;
            (apart < f64::from(size::CLOSE_CAMERAS)).then(|| {
                let frame = Rect::from_min_size(
                    frame.left_bottom() - vec2(0.0, size::INSET_HEIGHT),
                    vec2((frame.width() * 0.36).min(size::INSET_WIDTH), size::INSET_HEIGHT),
                );
                let shown = frame.width() * 0.5;
                let y = frame.bottom() - size::INSET_CAMERAS_RISE;
                Inset {
                    frame,
                    cameras: [-0.5, 0.5].map(|side| pos2(frame.center().x + side * shown, y)),
                    factor: f64::from(shown) / apart,
                }
            })
        });
        Self {
            frame,
            points_per_meter,
            cameras,
            object,
            edges: model
                .width_m
                .map(|width| [place(-width / 2.0, model.depth_m), place(width / 2.0, model.depth_m)]),
            inset,
        }
    }
}

fn paint(painter: &Painter, palette: &Palette, model: &Model, scene: &Scene, words: &Words) {
    let sight = Stroke::new(theme::SIGHT_LINE, palette.blue);
    let frame = scene.frame;
    // One camera sees the two edges of an object of known width; two cameras each see the point itself.
    let targets: Vec<Pos2> = match (&scene.edges, model.baseline_m) {
        (Some(edges), None) => edges.to_vec(),
        _ => vec![scene.object],
    };
    for &camera in &scene.cameras {
        for &target in &targets {
            painter.extend(Shape::dashed_line(&[camera, target], sight, size::DASH, size::DASH_GAP));
        }
    }
    if let Some(edges) = scene.edges {
        painter.line_segment(edges, Stroke::new(theme::THICK_LINE, palette.orange));
    }
    if let Some((near, far)) = model.interval_m {
        let x = scene.object.x;
        let y = |depth_m: f64| scene.object.y + to_f32((model.depth_m - depth_m) * scene.points_per_meter);
        let span = Rect::from_x_y_ranges(
            x - size::SPAN_HALF_WIDTH..=x + size::SPAN_HALF_WIDTH,
            far.map_or(frame.top(), y)..=y(near),
        );
        painter.rect_filled(span, theme::SPAN_RADIUS, palette.blue.gamma_multiply(0.35));
    }
    painter.circle_filled(scene.object, size::OBJECT_RADIUS, palette.blue);
    for &camera in &scene.cameras {
        camera_body(painter, palette, camera);
    }
    let beside = scene.edges.map_or(scene.object, |[_, right]| right).max(scene.object);
    let label = Label {
        text: &words.object,
        position: beside + vec2(size::OBJECT_LABEL_GAP, 0.0),
        anchor: Align2::LEFT_CENTER,
        frame,
    };
    label.paint(painter, palette);
    if let Some(inset) = &scene.inset {
        paint_inset(painter, palette, model, inset, words);
    } else if let Some(baseline) = &words.baseline {
        let label = Label {
            text: &format!("b = {baseline}"),
            position: pos2(frame.center().x, frame.bottom() - size::BASELINE_LABEL_RISE),
            anchor: Align2::CENTER_CENTER,
            frame,
        };
        label.paint(painter, palette);
    }
    paint_scale(painter, palette, scene, words.unit);
}

fn paint_inset(painter: &Painter, palette: &Palette, model: &Model, inset: &Inset, words: &Words) {
    painter.rect(
        inset.frame,
        theme::CONTROL_RADIUS,
        palette.surface,
        Stroke::new(theme::THIN_LINE, palette.line),
        egui::StrokeKind::Inside,
    );
    let [left, right] = inset.cameras;
    // The true directions of sight: steep, as the object is many baselines away.
    let lean = to_f32(model.baseline_m.unwrap_or(0.0) / 2.0 / model.depth_m);
    let up = left.y - inset.frame.top() - size::INSET_SIGHT_DROP;
    for (camera, side) in [(left, 1.0), (right, -1.0)] {
        painter.extend(Shape::dashed_line(
            &[camera, camera + vec2(side * lean * up, -up)],
            Stroke::new(theme::SIGHT_LINE, palette.blue),
            size::DASH,
            size::DASH_GAP,
        ));
        camera_body(painter, palette, camera);
    }
    let label = |position, text: &str| {
        let label = Label {
            text,
            position,
            anchor: Align2::CENTER_CENTER,
            frame: inset.frame.shrink(size::PADDING),
        };
        label.paint(painter, palette);
    };
    let enlarged = if inset.factor < 99_999.0 {
        format!("cameras × {}", number::significant(inset.factor, 2))
    } else {
        "cameras, enlarged".to_owned()
    };
    label(inset.frame.center_top() + vec2(0.0, size::INSET_TITLE_DROP), &enlarged);
    if let Some(baseline) = &words.baseline {
        let text = format!("b = {baseline}");
        label(inset.frame.center_bottom() - vec2(0.0, size::INSET_LABEL_RISE), &text);
    }
}

/// A bar of round length, at the lower right.
fn paint_scale(painter: &Painter, palette: &Palette, scene: &Scene, unit: LengthUnit) {
    let frame = scene.frame;
    let points_per_unit = scene.points_per_meter * Length::new(1.0, unit).m();
    let longest = f64::from(frame.width() * 0.2) / points_per_unit;
    let length = round_down(longest);
    if !length.is_normal() {
        return;
    }
    let end = frame.right_bottom() - Vec2::splat(size::SCALE_MARGIN);
    let start = end - vec2(to_f32(length * points_per_unit), 0.0);
    let stroke = Stroke::new(theme::STRONG_LINE, palette.muted);
    painter.line_segment([start, end], stroke);
    for tip in [start, end] {
        painter.line_segment([tip, tip - vec2(0.0, size::SCALE_TICK)], stroke);
    }
    let text = format!("{} {}", number::plain(length), unit.symbol());
    let label = Label {
        text: &text,
        position: start.lerp(end, 0.5) - vec2(0.0, size::SCALE_LABEL_RISE),
        anchor: Align2::CENTER_CENTER,
        frame,
    };
    label.paint(painter, palette);
}

fn camera_body(painter: &Painter, palette: &Palette, lens: Pos2) {
    let body = Rect::from_center_size(lens + vec2(0.0, size::CAMERA_DROP), vec2(size::CAMERA_WIDTH, size::CAMERA_HEIGHT));
    painter.rect_filled(body, theme::SMALL_MARK_RADIUS, palette.blue);
    painter.add(Shape::convex_polygon(
        vec![
            lens - vec2(0.0, size::LENS_TIP),
            lens + vec2(size::LENS_BASE, size::LENS_BASE),
            lens + vec2(-size::LENS_BASE, size::LENS_BASE),
        ],
        palette.blue,
        Stroke::NONE,
    ));
}

/// A text at `position`, moved as far as needed to stay inside `frame`, on a background of its own.
struct Label<'a> {
    text: &'a str,
    position: Pos2,
    anchor: Align2,
    frame: Rect,
}

impl Label<'_> {
    fn paint(&self, painter: &Painter, palette: &Palette) {
        let frame = self.frame;
        let galley = painter.layout_no_wrap(self.text.to_owned(), theme::regular(theme::SMALL_SIZE), palette.text);
        let mut rect = self.anchor.anchor_size(self.position, galley.size());
        rect = rect.translate(vec2(
            (frame.right() - rect.right()).min(0.0),
            (frame.bottom() - rect.bottom()).min(0.0),
        ));
        rect = rect.translate(vec2((frame.left() - rect.left()).max(0.0), (frame.top() - rect.top()).max(0.0)));
        painter.rect_filled(rect.expand(size::LABEL_PADDING), theme::SMALL_MARK_RADIUS, palette.surface);
        painter.galley(rect.min, galley, palette.text);
    }
}

/// A coordinate on the screen; what is too small to see becomes zero.
#[expect(clippy::cast_possible_truncation, reason = "a position on the screen needs no more than an f32")]
const fn to_f32(points: f64) -> f32 {
    points as f32
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]
mod tests {
    use super::*;
    use depth_text::form::{Example, Inputs};

    fn scene(inputs: &Inputs) -> (Model, Scene) {
        let model = Model::new(&inputs.assess().solution).unwrap();
        let scene = Scene::new(&model, Rect::from_min_size(pos2(0.0, 0.0), vec2(390.0, theme::PICTURE_HEIGHT)));
        (model, scene)
    }

    #[test]
    fn both_axes_have_the_same_scale() {
        let mut inputs = Example::CoffeeMug.inputs();
        inputs.choose_unit(crate::core::problem::Field::Baseline, LengthUnit::Foot);
        let (model, scene) = scene(&inputs);
        let apart = f64::from(scene.cameras[1].x - scene.cameras[0].x);
        let away = f64::from(scene.cameras[0].y - scene.object.y);
        assert!((apart / model.baseline_m.unwrap() / (away / model.depth_m) - 1.0).abs() < 1e-4);
        assert_eq!(scene.object.x, f32::midpoint(scene.cameras[0].x, scene.cameras[1].x));
    }

    #[test]
    fn cameras_too_close_to_tell_apart_get_an_inset_that_says_how_much_it_enlarges() {
        let (model, mug) = scene(&Example::CoffeeMug.inputs());
        let inset = mug.inset.unwrap();
        let apart = model.baseline_m.unwrap() * mug.points_per_meter;
        assert!(apart < f64::from(size::CLOSE_CAMERAS));
        assert!((f64::from(inset.cameras[1].x - inset.cameras[0].x) / apart / inset.factor - 1.0).abs() < 1e-4);
        let mut wide = Example::CoffeeMug.inputs();
        wide.choose_unit(crate::core::problem::Field::Baseline, LengthUnit::Foot);
        wide.entry_mut(crate::core::problem::Field::Disparity).text = "5000".into();
        assert_eq!(scene(&wide).1.inset, None);
    }

    #[test]
    fn one_camera_looks_at_both_edges_of_the_object() {
        let (model, doorway) = scene(&Example::Doorway.inputs());
        assert_eq!(doorway.cameras.len(), 1);
        let [left, right] = doorway.edges.unwrap();
        assert!((f64::from(right.x - left.x) / doorway.points_per_meter / model.width_m.unwrap() - 1.0).abs() < 1e-4);
    }

    #[test]
    fn scenes_that_cannot_be_drawn_are_not_drawn() {
        let mut inputs = Example::CoffeeMug.inputs();
        inputs.entry_mut(crate::core::problem::Field::FocalLength).text = "1e200".into();
        assert_eq!(Model::new(&inputs.assess().solution), None);
    }
}
