//! Labels and dimension lines of the top view.

use super::draw::{Drawing, Sheet, monocular_inks, stereo_ink};
use super::fit::{RING, sight_label};
use super::model::Sight;
use crate::floor::{LABEL_TEXT, broken_dimension, dimension, to_f32};
use crate::labels::{Label, Place, grown};
use crate::{Align, Ink, Point, Rect, Stroke, Words};
use depth_core::problem::Method;

/// From a thing to its label.
const GAP: f32 = 10.0;
/// From the object to its bracket.
const BRACKET: f32 = 14.0;
/// From the line of the cameras down to the dimension of the baseline.
const BASELINE_DROP: f32 = 16.5;
/// From the right edge of the plot to the dimension of the distance, where that has room.
const DEPTH_MARGIN: f32 = 84.0;

impl Drawing<'_> {
    /// Everything that is written, with its dimension lines.
    pub(super) fn labels(&self, sheet: &mut Sheet<'_>) {
        let both = (&self.model.stereo, &self.model.monocular);
        let depth = match both {
            (Some(stereo), _) => self.fit.stereo_y.map(|y| (stereo, y, stereo_ink(stereo))),
            (None, Some(alone)) => self.fit.monocular_y.map(|y| (alone, y, monocular_inks(alone)[0])),
            (None, None) => None,
        };
        // All lines first, so that no label lies on one.
        let line_x = depth.and_then(|(sight, y, ink)| self.depth_line(sheet, sight, y, ink));
        let bracket = self.bracket(sheet);
        let zero = self.zero_line(sheet);
        self.baseline_label(sheet);
        self.width_label(sheet);
        if let Some((sight, y, _)) = depth {
            self.depth_label(sheet, sight, y, line_x);
        }
        if let (Some(_), Some(monocular), Some(edge)) = (both.0, both.1, bracket) {
            self.monocular_label(sheet, monocular, edge);
        }
        self.angle_label(sheet);
        if let Some(at) = zero {
            let label = Label::line(Words::new("zero of the tape", Ink::Muted), LABEL_TEXT);
            let places = [
                (Point::new(at.x - 6.0, at.y), Align::Right),
                (Point::new(at.x - 6.0, at.y - 10.0), Align::Right),
            ];
            sheet.labels.put(&label, &places);
        }
    }

    fn width_label(&self, sheet: &mut Sheet<'_>) {
        let (Some([left, right]), Some((_, text)), Some(span)) = (self.object(), &self.model.width, self.fit.object) else {
            return;
        };
        let is_stale = self.model.monocular.as_ref().is_some_and(|sight| sight.is_stale);
        let [line, ink] = if is_stale {
            [Ink::Stale; 2]
        } else {
            [Ink::Monocular, Ink::MonocularText]
        };
        // Only an ellipse around the object itself is in the way.
        let ellipse = self.fit.ellipse.zip(self.fit.stereo_y);
        let ellipse = ellipse.filter(|(ellipse, y)| y + ellipse.radii[1] > left.y - 20.0 && *y < left.y + 20.0);
        let above_ellipse = ellipse.map_or(f32::INFINITY, |(ellipse, y)| y - ellipse.radii[1] - 11.0);
        let y = (left.y - 14.0).min(above_ellipse).max(9.0);
        let words = |rest: String| Words::default().then_symbol("w_real", ink, true).then_strong(rest, ink);
        let shown = if self.model.is_turned { " · cos φ" } else { "" };
        let symbol = words(format!("{shown} = {text}"));
        let long = words(format!("{shown} = {text}, not to scale"));
        let choices = if span.is_broken {
            vec![long, words(", not to scale".to_owned())]
        } else {
            vec![symbol]
        };
        let [left, right] = [left, right].map(|end| Point::new(end.x, y));
        self.dimensioned(
            sheet,
            [left, right],
            Dimension {
                choices,
                line,
                is_broken: span.is_broken,
            },
        );
    }

    fn baseline_label(&self, sheet: &mut Sheet<'_>) {
        let (Some(span), Some((_, text)), Some(sight)) = (self.fit.baseline, &self.model.baseline, &self.model.stereo) else {
            return;
        };
        let ink = stereo_ink(sight);
        let y = self.fit.ground() + BASELINE_DROP;
        let ends = [-1.0, 1.0].map(|side| Point::new(self.center() + side * span.half, y));
        let choices = if span.is_broken {
            vec![format!("b = {text}, not to scale"), format!("b = {text}")]
        } else {
            vec![format!("b = {text}")]
        };
        let choices = choices.into_iter().map(|text| Words::strong(text, ink)).collect();
        self.dimensioned(
            sheet,
            ends,
            Dimension {
                choices,
                line: ink,
                is_broken: span.is_broken,
            },
        );
    }

    /// A level dimension line with its label in it, where it is long enough, else beside it.
    fn dimensioned(&self, sheet: &mut Sheet<'_>, [from, to]: [Point; 2], dimension_line: Dimension) {
        let Dimension { choices, line, is_broken } = dimension_line;
        let labels: Vec<Label> = choices.into_iter().map(|words| Label::line(words, LABEL_TEXT)).collect();
        let middle = Point::new(f32::midpoint(from.x, to.x), from.y);
        let stroke = Stroke::new(line, 1.75);
        let has_room_inside = |label: &&Label| label.width(self.measure) + 60.0 <= to.x - from.x;
        if let Some(label) = labels.iter().find(has_room_inside) {
            let half = label.width(self.measure) / 2.0 + 8.0;
            for (end, inner) in [(from, middle.x - half), (to, middle.x + half)] {
                sheet.scene.line(end, Point::new(inner, end.y), stroke);
                sheet
                    .scene
                    .line(Point::new(end.x, end.y - 4.0), Point::new(end.x, end.y + 4.0), stroke);
                if is_broken {
                    sheet
                        .scene
                        .line(Point::new(inner - 2.5, end.y + 5.0), Point::new(inner + 2.5, end.y - 5.0), stroke);
                }
                let part = Rect::new(end.x.min(inner) - 4.0, end.y - 4.0, end.x.max(inner) + 4.0, end.y + 4.0);
                sheet.labels.keep_off(part);
            }
            sheet.labels.put(label, &[(middle, Align::Center)]);
            return;
        }
        if to.x - from.x >= 8.0 {
            if is_broken {
                broken_dimension(&mut sheet.scene, from, to, stroke);
            } else {
                dimension(&mut sheet.scene, from, to, stroke);
            }
            sheet.labels.keep_off(Rect::new(from.x - 2.0, from.y - 5.0, to.x + 2.0, to.y + 5.0));
        }
        let places: [Place; 2] = [
            (Point::new(to.x + GAP + 2.0, to.y), Align::Left),
            (Point::new(from.x - GAP - 2.0, from.y), Align::Right),
        ];
        let fits = |label: &&Label| places.iter().any(|place| sheet.labels.is_free_at(label, *place));
        if let Some(label) = labels.iter().find(fits).or(labels.last()) {
            sheet.labels.put(label, &places);
        }
    }

    /// The dimension line of the distance at the right. Returns where it is, if it is long enough to be drawn.
    fn depth_line(&self, sheet: &mut Sheet<'_>, sight: &Sight, y: f32, ink: Ink) -> Option<f32> {
        let zero = self.zero_y();
        if zero - y < 30.0 {
            return None;
        }
        let plot = self.fit.plot;
        let label = sight_label(sight, name(sight, self.main_method()), Ink::Text).width(self.measure);
        let beside = self.center() + self.fit.half_extent() + BRACKET;
        let x = (plot.right - (label + GAP + 6.0).max(DEPTH_MARGIN))
            .max(beside)
            .min(plot.right - 6.0);
        let ink = if sight.is_given { Ink::Text } else { ink };
        let (top, bottom) = (Point::new(x, y), Point::new(x, zero));
        dimension(&mut sheet.scene, top, bottom, Stroke::new(ink, 1.75));
        sheet.labels.keep_off(grown(Rect::new(x, y, x, zero), 5.0));
        let at_object = self.object().filter(|[_, right]| (right.y - y).abs() < 4.0);
        let from = at_object.map_or(self.center() + RING, |[_, right]| right.x.max(self.center() + RING)) + 6.0;
        if x - 8.0 > from {
            let (from, to) = (Point::new(from, y), Point::new(x - 6.0, y));
            sheet.scene.line(from, to, Stroke::dashed(Ink::Stale, 1.0, [1.5, 2.5]));
            sheet.labels.avoid_line(from, to);
        }
        Some(x)
    }

    fn depth_label(&self, sheet: &mut Sheet<'_>, sight: &Sight, y: f32, line_x: Option<f32>) {
        let (method, inks) = if self.model.stereo.is_some() {
            (Method::Stereo, stereo_ink(sight))
        } else {
            (Method::Monocular, monocular_inks(sight)[1])
        };
        let label = self.sight_label(sight, method, if sight.is_given { Ink::Text } else { inks });
        let places: Vec<Place> = match line_x {
            Some(x) => {
                let middle = f32::midpoint(y, self.zero_y());
                vec![
                    (Point::new(x + GAP, middle), Align::Left),
                    (Point::new(x - GAP, middle), Align::Right),
                ]
            }
            None => {
                let half = self.fit.half_extent().min(RING + 34.0);
                let x = self.center() + half + GAP;
                vec![(Point::new(x, y), Align::Left), (Point::new(x, y - 12.0), Align::Left)]
            }
        };
        sheet.labels.put(&label, &places);
    }

    /// The method whose distance has the dimension line.
    const fn main_method(&self) -> Method {
        if self.model.stereo.is_some() {
            Method::Stereo
        } else {
            Method::Monocular
        }
    }

    /// The name of a distance, below it the distance in its own color, and below that a word where it is drawn larger than it is.
    fn sight_label(&self, sight: &Sight, method: Method, ink: Ink) -> Label {
        let mut label = sight_label(sight, name(sight, method), ink);
        if self.fit.is_near_moved && self.is_nearer(sight) {
            label.lines.push(Words::new("not to scale", Ink::Muted));
        }
        label
    }

    fn is_nearer(&self, sight: &Sight) -> bool {
        self.model.sights().all(|other| other.depth_m >= sight.depth_m) && self.model.sights().count() > 1
    }

    /// The ± 1 σ of the monocular distance, at the left of the object, as many times as large as the ellipse. Returns where its label ends.
    fn bracket(&self, sheet: &mut Sheet<'_>) -> Option<Point> {
        let (sight, y) = (self.model.monocular.as_ref()?, self.fit.monocular_y?);
        let half = self.fit.object.map_or(RING, |span| span.half.max(RING));
        let x = self.center() - half - BRACKET;
        let factor = self.fit.ellipse.map_or(1.0, |ellipse| ellipse.factor);
        let high = to_f32(sight.sigma_m * self.fit.per_meter * factor);
        let stroke = Stroke::new(monocular_inks(sight)[0], 1.75);
        let top = (y - high).max(self.fit.plot.top);
        let bottom = (y + high).min(self.fit.ground());
        if high >= 2.0 {
            dimension(&mut sheet.scene, Point::new(x, top), Point::new(x, bottom), stroke);
        } else {
            // Shorter than its own caps are wide: a mark of where it is.
            sheet.scene.line(Point::new(x - 4.0, y), Point::new(x + 4.0, y), stroke);
        }
        sheet.labels.keep_off(grown(Rect::new(x, top, x, bottom), 5.0));
        Some(Point::new(x - GAP - 2.0, y))
    }

    fn monocular_label(&self, sheet: &mut Sheet<'_>, sight: &Sight, edge: Point) {
        let ink = if sight.is_given { Ink::Text } else { monocular_inks(sight)[1] };
        let label = self.sight_label(sight, Method::Monocular, ink);
        let lift = |dy: f32| (Point::new(edge.x, edge.y - dy), Align::Right);
        sheet
            .labels
            .put(&label, &[lift(0.0), lift(12.0), lift(-12.0), lift(24.0), lift(40.0), lift(56.0)]);
    }

    fn angle_label(&self, sheet: &mut Sheet<'_>) {
        let (Some(angle), Some(y)) = (&self.model.angle, self.fit.stereo_y) else {
            return;
        };
        let ink = self.model.stereo.as_ref().map_or(Ink::Stereo, stereo_ink);
        let label = |name: &[&str]| Label {
            lines: name
                .iter()
                .map(|line| Words::new(*line, Ink::Muted))
                .chain([Words::strong(angle.clone(), ink)])
                .collect(),
            size: LABEL_TEXT,
        };
        let place = |(gap, dy): (f32, f32)| (Point::new(self.center() - RING - gap, y + dy), Align::Right);
        let places = [(16.0, 52.0), (10.0, 52.0), (16.0, 24.0), (16.0, 0.0)].map(place);
        let wide = label(&["angle between the rays"]);
        let has_room = places.iter().any(|place| sheet.labels.is_free_at(&wide, *place));
        let label = if has_room { wide } else { label(&["angle between", "the rays"]) };
        sheet.labels.put(&label, &places);
    }

    /// The height at which distances begin, as far as it is in the picture.
    fn zero_y(&self) -> f32 {
        let above = to_f32(self.model.zero_m * self.fit.per_meter);
        self.fit.ground() - above.max(-14.0)
    }

    /// The zero of the tape, where it can be told from the line of the cameras. Returns its left end.
    fn zero_line(&self, sheet: &mut Sheet<'_>) -> Option<Point> {
        let y = self.zero_y();
        if (y - self.fit.ground()).abs() < 4.0 {
            return None;
        }
        let half = self.fit.half_extent() + BRACKET;
        let [left, right] = [-1.0, 1.0].map(|side| Point::new(self.center() + side * half, y));
        sheet.scene.line(left, right, Stroke::dashed(Ink::Muted, 1.0, [4.0, 3.0]));
        sheet.labels.avoid_line(left, right);
        Some(left)
    }
}

/// What a dimension line says.
struct Dimension {
    /// The label, in the order of preference.
    choices: Vec<Words>,
    line: Ink,
    is_broken: bool,
}

/// "D (stereo)"
const fn name(sight: &Sight, method: Method) -> &'static str {
    match method {
        _ if sight.is_given => "D (given)",
        Method::Stereo => "D (stereo)",
        Method::Monocular => "D (monocular)",
    }
}
