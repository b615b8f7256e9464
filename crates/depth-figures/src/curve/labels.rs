//! What is written into the plot: the monocular distance, and a tip.

use super::drawing::Drawing;
use crate::axis::LABEL_SIZE;
use crate::{Align, Fill, Ink, Point, Rect, Stroke, Words};

/// Between lines of text.
const LINE: f32 = 18.0;
/// From a tip's text to its edge.
const TIP_PADDING: f32 = 12.0;

/// A tip that has a place.
pub(super) struct Tip {
    pub rect: Rect,
    pub lines: Vec<Words>,
    /// What on the curve it is about.
    pub at: Point,
}

impl Drawing<'_> {
    /// The band of 2 σ around the monocular distance, which lies below the lines.
    pub(super) fn level_band(&mut self) {
        let Some(level) = self.model.level.as_ref().filter(|level| level.estimate.value <= self.axes.y.high) else {
            return;
        };
        let Some(two) = level.estimate.two() else { return };
        let top = two.high.map_or(self.plot.top, |high| self.y(high));
        let rect = Rect::new(self.plot.left, top, self.plot.right, self.y(two.low));
        self.figure.rect(rect, 0.0, Fill::sheer(Ink::MonocularTint, 0.7));
    }

    /// The monocular distance: a line across the plot, or an arrow where it is beyond its top.
    pub(super) fn level(&mut self) {
        let Some(level) = &self.model.level else { return };
        if let Some(ring) = self.ring {
            self.obstacles.thin_line(&[Point::new(self.plot.left, ring.y), ring]);
            self.obstacles.thin_line(&[ring, Point::new(ring.x, self.plot.bottom)]);
        }
        let text = format!("monocular {}", level.text);
        if level.estimate.value > self.axes.y.high {
            self.level_above(&text, level.x);
            return;
        }
        let y = self.y(level.estimate.value);
        let Rect { left, right, .. } = self.plot;
        let stroke = Stroke::dashed(Ink::Monocular, 2.0, [6.0, 4.0]);
        self.figure.line(Point::new(left, y), Point::new(right, y), stroke);
        let words = Words::new(text, Ink::MonocularText);
        let width = self.measure.width(&words, LABEL_SIZE);
        let lefts = [right - width, left + 8.0, f32::midpoint(left, right) - width / 2.0];
        let places = [-14.0, 14.0, -28.0, 28.0].map(|down| lefts.map(|left| (left, y + down)));
        self.label(words, width, places.as_flattened());
    }

    /// An arrow up at the disparity of the monocular distance, and what it is.
    fn level_above(&mut self, text: &str, x: Option<f64>) {
        const LENGTH: f32 = 30.0;
        const HEAD: f32 = 7.0;
        let Rect { left, top, right, .. } = self.plot;
        let x_text = x.map(|x| depth_text::number::significant(x, 2));
        let mut room_from = left + 8.0;
        if let Some(x) = x {
            let x = self.x(x).clamp(left + HEAD + 2.0, right - HEAD);
            let tip = Point::new(x, top + 1.0);
            let stroke = Stroke::new(Ink::Monocular, 2.5);
            self.figure.line(Point::new(x, top + LENGTH), tip, stroke);
            let head = vec![Point::new(x - HEAD, top + HEAD + 2.0), tip, Point::new(x + HEAD, top + HEAD + 2.0)];
            self.figure.path(head, stroke);
            let arrow = Rect::new(x - HEAD, top, x + HEAD, top + LENGTH);
            self.obstacles.rect(arrow);
            room_from = arrow.right + 8.0;
        }
        // The arrow says it already.
        let short = if x.is_some() { text.to_owned() } else { format!("↑ {text}") };
        let long = x_text.map(|x| format!("{short}, at d = {x} px"));
        for text in long.into_iter().chain([short]) {
            let words = Words::new(text, Ink::MonocularText);
            let width = self.measure.width(&words, LABEL_SIZE);
            let mut places = Vec::new();
            for row in [10.0, 28.0, 46.0] {
                let steps = (0..24_u8).map(|step| room_from + f32::from(step) * 12.0);
                places.extend(steps.chain([right - width]).map(|left| (left, top + row)));
            }
            if self.label(words, width, &places) {
                return;
            }
        }
    }

    /// Writes `words` at the first of `places`, left end and middle, that is free; `false` where none is.
    fn label(&mut self, words: Words, width: f32, places: &[(f32, f32)]) -> bool {
        let half = LABEL_SIZE / 2.0;
        let rect = |&(left, y): &(f32, f32)| Rect::new(left, y - half, left + width, y + half);
        let is_free = |place: &(f32, f32), with_thin: bool| {
            let rect = rect(place);
            let is_inside = rect.left >= self.plot.left + 4.0
                && rect.right <= self.plot.right + 0.5
                && rect.top >= self.plot.top - 1.0
                && rect.bottom <= self.plot.bottom;
            is_inside && self.obstacles.are_clear_of(rect, 2.0) && (!with_thin || self.obstacles.thin_are_clear_of(rect, 2.0))
        };
        let free = places.iter().find(|place| is_free(place, true));
        let place = free.or_else(|| places.iter().find(|place| is_free(place, false)));
        let Some(&place) = place else { return false };
        if free.is_none() {
            self.figure.rect(rect(&place), 0.0, Fill::sheer(Ink::Surface, 0.85));
        }
        self.obstacles.rect(rect(&place));
        self.figure.text(Point::new(place.0, place.1), Align::Left, words, LABEL_SIZE);
        true
    }

    /// Where a tip for `x` has room, and its lines.
    pub(super) fn place_tip(&mut self, x: f64) -> Option<Tip> {
        let lines = self.model.tip_at(x);
        let at = self.at(x, self.model.value_at(x)?);
        self.obstacles.rect(Rect::new(at.x - 6.0, at.y - 6.0, at.x + 6.0, at.y + 6.0));
        let width = lines.iter().map(|line| self.measure.width(line, LABEL_SIZE)).fold(0.0, f32::max) + 2.0 * TIP_PADDING;
        let height = f32::from(u8::try_from(lines.len()).ok()?) * LINE + TIP_PADDING;
        let all = Rect::new(self.plot.left + 4.0, self.plot.top - 9.0, self.figure.width, self.plot.bottom - 4.0);
        // The window can say elsewhere what has no room here.
        if width > all.width() || height > all.height() {
            return None;
        }
        let places = [
            (all.right - width, all.top),
            (at.x + 18.0, at.y - 16.0 - height),
            (at.x + 18.0, all.top),
            (all.right - width, at.y - 16.0 - height),
            (all.right - width, at.y - 60.0),
            (all.left + 4.0, all.bottom - height),
            (at.x - 18.0 - width, at.y + 16.0),
        ];
        let rects = places.map(|(left, top)| {
            let left = left.min(all.right - width).max(all.left);
            let top = top.min(all.bottom - height).max(all.top);
            Rect::new(left, top, left + width, top + height)
        });
        let is_free = |rect: &&Rect| self.obstacles.are_clear_of(**rect, 3.0);
        let rect = rects.iter().find(is_free).or(rects.first()).copied()?;
        self.obstacles.rect(rect);
        Some(Tip { rect, lines, at })
    }

    /// The tip, and a dot where it belongs to unless the ring is there.
    pub(super) fn tip(&mut self, tip: &Tip) {
        let Tip { rect, lines, at } = tip;
        if self.ring != Some(*at) {
            let (inside, edge) = (Fill::new(self.inks().line), Stroke::new(Ink::Surface, 1.5));
            self.figure.circle(*at, 4.5, Some(inside), Some(edge));
        }
        self.figure
            .frame(*rect, 6.0, Some(Fill::new(Ink::Tip)), Stroke::new(Ink::Border, 1.0));
        let mut y = rect.top + TIP_PADDING / 2.0 + LINE / 2.0;
        for line in lines {
            self.figure
                .text(Point::new(rect.left + TIP_PADDING, y), Align::Left, line.clone(), LABEL_SIZE);
            y += LINE;
        }
    }
}
