//! The camera, its ray and the floor from the side.

use super::{DOTS, LINE, Model, RING, clipped, level_dimension, muted, strong};
use crate::floor::{Axes, LABEL_TEXT, Scale, grid_step, step_text, to_f32};
use crate::labels::{Label, Labels, grown};
use crate::{Align, Figure, Fill, Ink, Measure, Point, Rect, Stroke, Words};
use depth_core::quantity::Length;

/// From the floor to the lower edge.
const BELOW: f32 = 46.0;
/// Room at the left of the camera, for its body.
const LEFT: f32 = 30.0;
/// Room at the right of what is shown.
const RIGHT: f32 = 36.0;
/// Room above the highest thing.
const ABOVE: f32 = 18.0;
/// Lower than this, the height is drawn larger than it is.
const LOWEST: f64 = 70.0;
/// The radius of the arc of the angles, at most.
const ARC: f32 = 150.0;
/// How much farther out the arc of α is than that of θ, points.
const ALPHA_BEYOND: f32 = 14.0;

/// The picture from the side.
#[derive(Clone, Debug, PartialEq)]
pub struct SideView {
    /// The picture.
    pub figure: Figure,
    /// At the right of the title: "to scale, grid 0.5 m high and 1 m ahead; on the floor: ± 1 σ thick, ± 2 σ thin".
    pub caption: String,
    /// The same where there is less room: "to scale, grid 1 m".
    pub short_caption: String,
    /// The point that is seen. Dragged along the floor, it is another row.
    pub ring: Point,
    /// Where the grid is.
    pub plot: Rect,
    origin: Point,
    per_meter: f64,
}

struct Drawing<'a> {
    model: &'a Model,
    measure: &'a dyn Measure,
    plot: Rect,
    scale: Scale,
    /// The steps of the grid, ahead and up.
    steps: [f64; 2],
    scene: Figure,
    labels: Labels<'a>,
}

impl SideView {
    /// The picture of `model`, `width` and `height` points large.
    pub fn new(model: &Model, [width, height]: [f32; 2], measure: &dyn Measure) -> Self {
        let mut left = 34.0;
        let mut scale = scale_of(model, plot_of([width, height], left));
        let highest = model.height.0.max(model.target.0);
        let mut steps = [1.0, 1.0];
        // The labels at the left need room, and how much depends on the scale.
        for _ in 0..2 {
            let [per_x, per_up] = scale.per_meter;
            // Ahead there is more room than up, and fewer lines are enough.
            let ahead = grid_step(measure, 0.7 * per_x, model.unit, f64::from(width) / per_x);
            steps = [ahead, grid_step(measure, per_up, model.unit, 0.0)];
            left = crate::floor::room_for_ticks(measure, steps[1], Length::from_m(highest).in_unit(model.unit));
            scale = scale_of(model, plot_of([width, height], left));
        }
        let plot = plot_of([width, height], left);
        let drawing = Drawing {
            model,
            measure,
            plot,
            scale,
            steps,
            scene: Figure::new(width, height),
            labels: Labels::new(measure, Rect::new(plot.left, 2.0, width, height - 2.0)),
        };
        let [caption, short_caption] = drawing.captions();
        Self {
            ring: drawing.ring(),
            figure: drawing.figure([width, height]),
            caption,
            short_caption,
            plot,
            origin: scale.origin,
            per_meter: scale.per_meter[0],
        }
    }

    /// How far ahead a point is when the ring is dragged to `at`: its height stays. [`Model::row_at`] says at which row that is seen.
    pub fn ahead_at(&self, at: Point) -> Length {
        Length::from_m(f64::from(at.x - self.origin.x) / self.per_meter)
    }
}

fn plot_of([width, height]: [f32; 2], left: f32) -> Rect {
    Rect::new(left, 24.0, width, height - BELOW)
}

/// The same on both axes; where the point is so far away that the camera would stand on the floor, heights a round number of times as
/// large.
fn scale_of(model: &Model, plot: Rect) -> Scale {
    let highest = model.height.0.max(model.target.0).max(0.0);
    let lowest = model.target.0.min(0.0);
    let room = f64::from((plot.height() - ABOVE).max(20.0));
    let [near, far] = range(model);
    let vertical = room / (highest - lowest);
    let horizontal = f64::from((plot.width() - LEFT - RIGHT).max(40.0)) / (far - near);
    let per_meter = vertical.min(horizontal);
    let drawn = (highest - lowest) * per_meter;
    let mut up = per_meter;
    if drawn < LOWEST.min(room / 2.0) {
        let power = 10.0_f64.powf((room / drawn).log10().floor());
        let factor = [5.0, 2.0, 1.0]
            .into_iter()
            .map(|digit| digit * power)
            .find(|factor| drawn * factor <= room);
        up = per_meter * factor.unwrap_or(1.0);
    }
    let x = plot.left + LEFT - to_f32(near * per_meter);
    Scale {
        origin: Point::new(x, plot.bottom + to_f32(lowest * up)),
        per_meter: [per_meter, up],
    }
}

/// What is shown along the floor, m: the camera, the point and its 2 σ as far as those are no longer than the way to it.
fn range(model: &Model) -> [f64; 2] {
    let ahead = model.ahead.value.m();
    let spread = (2.0 * model.ahead.sigma.m()).min(0.5 * ahead.abs());
    let least = 0.2 * model.height.0;
    [(ahead - spread).min(0.0), (ahead + spread).max(least)]
}

impl Drawing<'_> {
    fn ring(&self) -> Point {
        self.scale.at(self.model.ahead.value.m(), self.model.target.0)
    }

    fn lens(&self) -> Point {
        self.scale.at(0.0, self.model.height.0)
    }

    /// How many times as large heights are drawn.
    fn exaggeration(&self) -> f64 {
        let [ahead, up] = self.scale.per_meter;
        (up / ahead).round().max(1.0)
    }

    fn captions(&self) -> [String; 2] {
        let [ahead, up] = self.steps.map(|step| step_text(step, self.model.unit));
        let factor = self.exaggeration();
        let is_even = factor < 1.5;
        let scale = if is_even {
            "to scale".to_owned()
        } else {
            format!("heights drawn {factor:.0} × as large")
        };
        let grid = if is_even && ahead == up {
            format!("grid {ahead}")
        } else {
            format!("grid {up} high and {ahead} ahead")
        };
        let has_sigma = self.model.ahead.sigma.m() > 0.0;
        let sigma = if has_sigma {
            "; on the floor: ± 1 σ thick, ± 2 σ thin"
        } else {
            ""
        };
        let short = if is_even && ahead == up {
            format!("{scale}, {grid}")
        } else {
            scale.clone()
        };
        [format!("{scale}, {grid}{sigma}"), short]
    }

    fn figure(mut self, [width, height]: [f32; 2]) -> Figure {
        let mut figure = Figure::new(width, height);
        let name_width = self
            .measure
            .width(&Words::new(format!("Ahead ({})", self.model.unit.symbol()), Ink::Muted), 12.0);
        // Below the ticks, or where the dimension ends there, in line with them.
        let is_clear = self.ring().x.max(self.lens().x) + 90.0 < width - name_width;
        let axes = Axes {
            plot: self.plot,
            scale: self.scale,
            unit: self.model.unit,
            steps: self.steps,
            up: "Height",
            below: height - BELOW + 14.0,
            across: (
                "Ahead",
                Point::new(width, height - if is_clear { 12.0 } else { BELOW - 14.0 }),
                Align::Right,
            ),
        };
        for text in axes.draw(&mut figure, self.measure) {
            self.labels.keep_off(text);
        }
        self.lines();
        self.spread();
        self.camera();
        let ring = self.ring();
        self.scene
            .circle(ring, RING, Some(Fill::new(Ink::Surface)), Some(Stroke::new(Ink::Text, 2.25)));
        self.labels.keep_off(grown(Rect::new(ring.x, ring.y, ring.x, ring.y), RING + 2.0));
        let radii = self.arcs();
        self.write(radii, height);
        self.labels.finish(&mut figure, self.scene);
        figure
    }

    /// Height, level, optical axis and ray.
    fn lines(&mut self) {
        let (lens, ring, plot) = (self.lens(), self.ring(), self.plot);
        let foot = Point::new(lens.x, self.scale.origin.y);
        self.scene.line(lens, foot, LINE);
        self.scene
            .line(Point::new(foot.x - 4.0, foot.y), Point::new(foot.x + 4.0, foot.y), LINE);
        self.labels.avoid_line(lens, foot);
        self.scene.line(lens, Point::new(plot.right, lens.y), DOTS);
        self.labels.avoid_line(lens, Point::new(plot.right, lens.y));
        let end = self.towards(self.model.pitch.0, 4000.0);
        if let Some([from, to]) = clipped(lens, end, grown(plot, 0.01)) {
            self.scene.line(from, to, Stroke::dashed(Ink::Muted, 1.4, [7.0, 4.0]));
            self.labels.avoid_line(from, to);
        }
        self.scene.line(lens, ring, Stroke::new(Ink::Text, 2.0));
        self.labels.keep_off_line(lens, ring);
        let floor = self.scale.origin.y;
        if (ring.y - floor).abs() > 10.0 {
            self.scene.line(ring, Point::new(ring.x, floor), DOTS);
            self.labels.avoid_line(ring, Point::new(ring.x, floor));
        }
        self.labels.avoid_line(Point::new(plot.left, floor), Point::new(plot.right, floor));
    }

    /// As far from the lens, this angle below level, as `length` points along the floor would be.
    fn towards(&self, angle: f64, length: f32) -> Point {
        let [per_x, per_up] = self.scale.per_meter;
        let (sin, cos) = angle.sin_cos();
        let (x, y) = (to_f32(cos), to_f32(sin * per_up / per_x));
        let size = x.hypot(y).max(1e-6);
        let lens = self.lens();
        Point::new(lens.x + length * x / size, lens.y + length * y / size)
    }

    /// ± 1 σ and ± 2 σ, at the height of the point.
    fn spread(&mut self) {
        let (ahead, up) = (self.model.ahead, self.model.target.0);
        for (times, width) in [(2.0, 2.0), (1.0, 6.0)] {
            let half = times * ahead.sigma.m();
            let [from, to] = [-half, half].map(|by| self.scale.at(ahead.value.m() + by, up));
            let inside = |point: Point| Point::new(point.x.clamp(self.plot.left, self.plot.right), point.y);
            if half > 0.0 {
                self.scene.line(inside(from), inside(to), Stroke::new(Ink::Text, width));
                self.labels
                    .keep_off(Rect::new(inside(from).x, from.y - 3.0, inside(to).x, to.y + 3.0));
            }
        }
    }

    /// Its body behind the lens, turned as it looks.
    fn camera(&mut self) {
        let lens = self.lens();
        let ahead = self.towards(self.model.pitch.0, 1.0);
        let (x, y) = (ahead.x - lens.x, ahead.y - lens.y);
        let at = |along: f32, aside: f32| Point::new(lens.x + along * x - aside * y, lens.y + along * y + aside * x);
        let body = vec![at(-25.0, -8.0), at(-9.0, -8.0), at(-9.0, 8.0), at(-25.0, 8.0)];
        let cone = vec![at(-11.0, 0.0), at(0.0, -5.5), at(0.0, 5.5)];
        for area in [body, cone] {
            let bounds = area.iter().fold(Rect::new(lens.x, lens.y, lens.x, lens.y), |rect, point| {
                Rect::new(
                    rect.left.min(point.x),
                    rect.top.min(point.y),
                    rect.right.max(point.x),
                    rect.bottom.max(point.y),
                )
            });
            self.labels.keep_off(bounds);
            self.scene.area(area, Fill::new(Ink::Text), None);
        }
    }

    /// An arc for each angle: θ from level to the optical axis, α from there to the ray, a little farther out. Returns their radii.
    fn arcs(&mut self) -> [f32; 2] {
        let (lens, ring) = (self.lens(), self.ring());
        let far = (ring.x - lens.x).hypot(ring.y - lens.y);
        let wanted = ARC.min(0.45 * far).min(self.plot.right - lens.x - 40.0).max(24.0);
        let (pitch, ray) = (self.model.pitch.0, self.model.pitch.0 + self.model.below_axis.0);
        let radii = [wanted, wanted.min(0.6 * (self.scale.origin.y - lens.y)), 16.0];
        let theta = self.arc([0.0, pitch], &radii);
        let alpha = self.arc([pitch, ray], &radii.map(|radius| radius + ALPHA_BEYOND));
        [theta, alpha]
    }

    /// An arc around the lens between two angles, with the first of `radii` that fits into the plot, which is returned.
    fn arc(&mut self, [from, to]: [f64; 2], radii: &[f32; 3]) -> f32 {
        let points = |radius: f32| -> Vec<Point> {
            let angles = (0..=24_u8).map(|step| from + (to - from) * f64::from(step) / 24.0);
            angles.map(|angle| self.towards(angle, radius)).collect()
        };
        let plot = grown(self.plot, 4.0);
        let is_inside = |point: &Point| (plot.left..=plot.right).contains(&point.x) && (plot.top..=plot.bottom).contains(&point.y);
        let found = radii
            .iter()
            .map(|&radius| (radius, points(radius)))
            .find(|(_, points)| points.iter().all(is_inside));
        let Some((radius, points)) = found else { return radii[0] };
        for (start, end) in points.iter().zip(points.iter().skip(1)) {
            self.labels.avoid_line(*start, *end);
        }
        self.scene.path(points, Stroke::new(Ink::Text, 1.4));
        radius
    }

    /// Everything that is written.
    fn write(&mut self, [theta_radius, alpha_radius]: [f32; 2], height: f32) {
        let (lens, ring, model) = (self.lens(), self.ring(), self.model);
        let floor = self.scale.origin.y;
        let side = if model.ahead.value.m() < 0.0 { "behind" } else { "ahead" };
        let label = strong(format!("{} {side}", model.length(model.ahead)));
        let y = height - 12.0;
        let width = label.width(self.measure);
        level_dimension(
            &mut self.scene,
            &mut self.labels,
            [Point::new(lens.x, y), Point::new(ring.x, y)],
            &label,
            width,
        );
        let (pitch, below) = (model.pitch.0, model.below_axis.0);
        let beside = |angle: f64, radius: f32, more: f32| (self.towards(angle, radius + more), Align::Left);
        let theta: Vec<_> = [8.0, 24.0, 60.0].map(|more| beside(pitch / 2.0, theta_radius, more)).into();
        let alpha: Vec<_> = [8.0, 24.0, 60.0].map(|more| beside(pitch + below / 2.0, alpha_radius, more)).into();
        let h = Point::new(lens.x + 12.0, f32::midpoint(lens.y, floor));
        self.labels.put(
            &strong(format!("H = {}", model.height.1)),
            &[(h, Align::Left), (Point::new(lens.x - 10.0, h.y), Align::Right)],
        );
        self.labels.put_here(&strong(format!("θ = {}", model.pitch.1)), &theta);
        self.labels.put_here(&strong(format!("α = {}", model.below_axis.1)), &alpha);
        if let Some(text) = &model.target.1 {
            let at = Point::new(ring.x + 12.0, f32::midpoint(ring.y, floor));
            self.labels.put(
                &strong(format!("h = {text}")),
                &[(at, Align::Left), (Point::new(ring.x - 12.0, at.y), Align::Right)],
            );
        }
        self.optional(&muted("level"), Point::new(self.plot.right, lens.y - 10.0));
        let end = self.towards(pitch, 4000.0);
        if let Some([_, to]) = clipped(lens, end, self.plot) {
            let back = Point::new(to.x - 0.09 * (to.x - lens.x), to.y - 0.09 * (to.y - lens.y));
            for dy in [-14.0, 14.0, -24.0, 24.0] {
                if self.optional(&muted("optical axis"), Point::new(back.x, back.y + dy)) {
                    break;
                }
            }
        }
    }

    /// Writes a name that can be done without, where it has room.
    fn optional(&mut self, label: &Label, right_end: Point) -> bool {
        let place = (right_end, Align::Right);
        let is_free = self.labels.is_free_at(label, place);
        if is_free {
            self.labels.put(label, &[place]);
        }
        debug_assert!(label.size <= LABEL_TEXT, "a small label");
        is_free
    }
}
