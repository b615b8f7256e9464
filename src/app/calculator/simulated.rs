//! The cards of the Monte Carlo simulation, where first order is not good enough.

use super::card::Card;
use super::pictures::tip;
use super::simulations::{self, Simulation, Simulations};
use crate::app::context::AppContext;
use crate::app::sentences::{Description, Hint};
use crate::app::theme::{self, Layout};
use crate::app::widgets::{cards, chart, figure, picture, progress, text};
use crate::core::measured::Measured;
use crate::core::monte_carlo::{Distribution, Quantiles};
use crate::core::problem::Method;
use crate::core::quantity::{Length, LengthUnit};
use depth_figures::histogram::Histogram;
use depth_figures::{Ink, Words};
use depth_text::report;
use depth_text::report::strip::Mode;
use depth_text::sentences::percent;
use depth_text::style::Style;
use egui::{Sense, Ui, vec2};

/// Draws the card of each method that is simulated.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>, simulations: &Simulations) {
    if cx.mode() != Mode::Distance {
        return;
    }
    let is_simulated = |method: &Method| !matches!(simulations.of(*method), Simulation::None);
    let mut shown: Vec<Option<Method>> = Method::ALL.into_iter().filter(is_simulated).map(Some).collect();
    if shown.is_empty() {
        return;
    }
    if cx.layout == Layout::Phone {
        for method in shown.into_iter().flatten() {
            card_ui(ui, cx, (method, simulations.of(method)));
        }
        return;
    }
    // In the columns of the pictures above.
    shown.resize(Method::ALL.len(), None);
    let gap = cx.layout.gap();
    cards::row_ui(ui, &shown, gap, |ui, method| {
        if let Some(method) = method {
            card_ui(ui, cx, (method, simulations.of(method)));
        }
    });
}

fn card_ui(ui: &mut Ui, cx: &mut AppContext<'_>, (method, simulation): (Method, &Simulation)) {
    let card = Card::Simulation(method);
    let frame = cards::Frame {
        title: card.title(),
        caption: "",
        height: None,
    };
    let unit = cx.unit();
    frame.ui(ui, card, |ui| simulation_ui(ui, cx, (method, simulation), unit));
}

/// Lengths as precise as the distance of a method.
#[derive(Clone, Copy)]
struct Precision {
    like: Measured<Length>,
    unit: LengthUnit,
}

impl Precision {
    fn of(cx: &AppContext<'_>, method: Method, unit: LengthUnit) -> Self {
        let solution = &cx.session.assessment().solution;
        let none = Length::from_m(0.0);
        let distance = solution.outcome(method).distance().unwrap_or(none);
        let sigma = solution.uncertainty(method).map_or(none, |known| known.sigma);
        Self {
            like: Measured::new(distance, sigma),
            unit,
        }
    }

    fn length(self, length: Length) -> String {
        Style::WINDOW.length_like(length, self.like, self.unit)
    }

    fn range(self, near: Length, far: Option<Length>) -> String {
        Style::WINDOW.range_like(near, far, self.like, self.unit)
    }
}

fn simulation_ui(ui: &mut Ui, cx: &mut AppContext<'_>, (method, simulation): (Method, &Simulation), unit: LengthUnit) {
    let Simulation::Done(_, distribution) = simulation else {
        let (total, percent) = (simulations::DRAWS, simulation.percent());
        text::caption_ui(ui, Hint::Simulating { total, percent }.to_string());
        progress::ui(ui, Card::Simulation(method).title(), percent);
        return;
    };
    let precision = Precision::of(cx, method, unit);
    histogram_ui(ui, cx, (method, distribution), precision.like);
    let unbounded = || report::NO_UPPER_BOUND.to_owned();
    let end = |length: Option<Length>| length.map_or_else(unbounded, |length| precision.length(length));
    let interval = |Quantiles { near, far, .. }: Quantiles| near.map_or_else(unbounded, |near| precision.range(near, far));
    super::table::pairs_ui(
        ui,
        Card::Simulation(method).title(),
        &[
            ("Median", end(distribution.median)),
            ("Middle 68 %", interval(distribution.interval_68)),
            ("Middle 95 %", interval(distribution.interval_95)),
            ("Infinitely far", percent(distribution.share_infinite)),
        ],
    );
    let draws = distribution.drawn;
    text::caption_ui(ui, Hint::Simulated { draws }.to_string());
}

fn histogram_ui(ui: &mut Ui, cx: &mut AppContext<'_>, (method, distribution): (Method, &Distribution), like: Measured<Length>) {
    let unit = cx.unit();
    let (Some(shape), Some(histogram)) = (&distribution.histogram, Histogram::new(distribution, method, like, unit)) else {
        return;
    };
    let size = vec2(ui.available_width(), theme::HISTOGRAM_HEIGHT);
    let (rect, response) = ui.allocate_exact_size(size, Sense::CLICK);
    let drawn = histogram.layout(size.x, size.y, &figure::Fonts(ui.painter()));
    figure::paint(ui, &drawn.figure, rect.min);
    let title = Card::Simulation(method).title();
    let draws = distribution.drawn;
    let description = Description::Histogram {
        histogram: shape,
        draws,
        unit,
    };
    picture::describe(ui, &response, title, &description);
    chart::menu_ui(&response, title, cx.commands);
    let stops = drawn.bars.iter().map(|bar| tip::Stop {
        hit: figure::place(bar.hit, rect.min),
        at: rect.min + vec2(bar.top.x, bar.top.y),
        lines: bar.tip.iter().map(|line| Words::new(line.as_str(), Ink::Text)).collect(),
    });
    tip::cursor_ui(ui, &response, title, tip::Start::First, stops.collect());
}
