//! Painting a figure of shapes.

use super::symbols;
use crate::app::theme::{self, Palette};
use depth_figures::{Align, Figure, Fill, Ink, Measure, Point, Shape, Words};
use egui::epaint::{PathShape, PathStroke};
use egui::{Color32, Painter, Pos2, Rect, Stroke, StrokeKind, Ui, pos2, vec2};

/// The color of `ink`.
pub fn color(palette: &Palette, ink: Ink) -> Color32 {
    match ink {
        Ink::Text => palette.text,
        Ink::Muted => palette.muted,
        Ink::Stale => palette.stale,
        Ink::StaleTint => palette.stale_tint,
        Ink::Line => palette.line,
        Ink::Border => palette.border,
        Ink::Surface | Ink::Tip => palette.surface,
        Ink::Band => palette.highlight,
        Ink::Stereo => palette.blue,
        Ink::StereoTint => palette.blue_tint,
        // Opaque: the pieces of a band touch, and a translucent seam would show.
        Ink::StereoBand => palette.surface.lerp_to_gamma(palette.blue, 0.3),
        Ink::OnStereo => palette.on_blue,
        Ink::Monocular => palette.orange,
        Ink::MonocularText => palette.orange_text,
        Ink::MonocularTint => palette.orange_tint,
        Ink::Error => palette.red,
        Ink::ShareFirst => palette.shares[0],
        Ink::ShareSecond => palette.shares[1],
        Ink::ShareThird => palette.shares[2],
        Ink::ShareRest => palette.shares[3],
    }
}

/// How wide text is in the fonts of the window.
pub struct Fonts<'a>(pub &'a Painter);

impl Measure for Fonts<'_> {
    fn width(&self, words: &Words, size: f32) -> f32 {
        let job = symbols::of_words(words, size, |_| Color32::PLACEHOLDER);
        self.0.layout_job(job).size().x
    }
}

/// A part of a figure whose upper left corner is at `at`, on the screen.
pub fn place(part: depth_figures::Rect, at: Pos2) -> Rect {
    Rect::from_min_max(pos2(part.left, part.top), pos2(part.right, part.bottom)).translate(at.to_vec2())
}

/// Paints `figure` with its upper left corner at `at`.
pub fn paint(ui: &Ui, figure: &Figure, at: Pos2) {
    let room = Rect::from_min_size(at, vec2(figure.width, figure.height)).expand(theme::THIN_LINE);
    let painter = ui.painter().with_clip_rect(ui.clip_rect().intersect(room));
    let brush = Brush {
        painter: &painter,
        palette: theme::palette(ui),
        at,
    };
    for shape in &figure.shapes {
        brush.shape(shape);
    }
}

/// Writes a line of small text into `line`, cut where it does not fit.
pub fn line_ui(ui: &mut Ui, line: Rect, words: &Words) {
    let palette = theme::palette(ui);
    let mut job = symbols::of_words(words, theme::SMALL_SIZE, |ink| color(palette, ink));
    job.wrap = egui::text::TextWrapping::truncate_at_width(line.width());
    let layout = egui::Layout::left_to_right(egui::Align::Center);
    let mut inside = ui.new_child(egui::UiBuilder::new().id_salt("line").max_rect(line).layout(layout));
    inside.add(egui::Label::new(job).truncate());
}

struct Brush<'a> {
    painter: &'a Painter,
    palette: &'a Palette,
    at: Pos2,
}

impl Brush<'_> {
    fn point(&self, point: Point) -> Pos2 {
        pos2(self.at.x + point.x, self.at.y + point.y)
    }

    fn rect(&self, rect: depth_figures::Rect) -> Rect {
        Rect::from_min_max(
            self.point(Point::new(rect.left, rect.top)),
            self.point(Point::new(rect.right, rect.bottom)),
        )
    }

    fn fill(&self, fill: Option<Fill>) -> Color32 {
        fill.map_or(Color32::TRANSPARENT, |fill| {
            color(self.palette, fill.ink).gamma_multiply(fill.opacity)
        })
    }

    fn stroke(&self, stroke: Option<depth_figures::Stroke>) -> Stroke {
        stroke.map_or(Stroke::NONE, |stroke| Stroke::new(stroke.width, color(self.palette, stroke.ink)))
    }

    fn shape(&self, shape: &Shape) {
        match shape {
            Shape::Path {
                points,
                is_closed,
                fill,
                stroke,
            } => self.path(
                points.iter().map(|&point| self.point(point)).collect(),
                *is_closed,
                (*fill, *stroke),
            ),
            Shape::Rect {
                rect,
                radius,
                fill,
                stroke,
            } => {
                let (fill, stroke) = (self.fill(*fill), self.stroke(*stroke));
                self.painter.rect(self.rect(*rect), *radius, fill, stroke, StrokeKind::Middle);
            }
            Shape::Circle {
                center,
                radius,
                fill,
                stroke,
            } => {
                let (fill, stroke) = (self.fill(*fill), self.stroke(*stroke));
                self.painter.circle(self.point(*center), *radius, fill, stroke);
            }
            Shape::Text { at, align, words, size } => self.text(self.point(*at), *align, words, *size),
        }
    }

    fn path(&self, points: Vec<Pos2>, closed: bool, (fill, stroke): (Option<Fill>, Option<depth_figures::Stroke>)) {
        let dash = stroke.and_then(|stroke| stroke.dash);
        if let Some([dash, gap]) = dash {
            self.painter
                .extend(egui::Shape::dashed_line(&points, self.stroke(stroke), dash, gap));
            return;
        }
        let stroke = self.stroke(stroke);
        self.painter.add(PathShape {
            points,
            closed,
            fill: self.fill(fill),
            stroke: PathStroke::new(stroke.width, stroke.color),
        });
    }

    fn text(&self, at: Pos2, align: Align, words: &Words, size: f32) {
        let job = symbols::of_words(words, size, |ink| color(self.palette, ink));
        let galley = self.painter.layout_job(job);
        let left = match align {
            Align::Left => at.x,
            Align::Center => at.x - galley.size().x / 2.0,
            Align::Right => at.x - galley.size().x,
        };
        let place = pos2(left, at.y - galley.size().y / 2.0);
        self.painter.galley(place, galley, self.palette.text);
    }
}
