//! The cards of the Monte Carlo simulation, where first order is not good enough.

use super::card::Card;
use super::simulations::{self, Simulation, Simulations};
use crate::app::context::AppContext;
use crate::app::sentences::{Description, Hint};
use crate::app::theme;
use crate::app::widgets::{cards, chart, picture, progress, text};
use crate::core::monte_carlo::{Distribution, Quantiles};
use crate::core::problem::Method;
use crate::core::quantity::{Length, LengthUnit};
use depth_text::report;
use depth_text::report::strip::Mode;
use depth_text::sentences::percent;
use egui::{Align2, Rect, Sense, Ui, pos2, vec2};

/// Draws the card of each method that is simulated.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>, simulations: &Simulations) {
    if cx.mode() != Mode::Distance {
        return;
    }
    let unit = cx.unit();
    for method in Method::ALL {
        let simulation = simulations.of(method);
        if matches!(simulation, Simulation::None) {
            continue;
        }
        let card = Card::Simulation(method);
        let frame = cards::Frame {
            title: card.title(),
            caption: "",
            height: None,
        };
        frame.ui(ui, card, |ui| simulation_ui(ui, cx, (method, simulation), unit));
    }
}

fn simulation_ui(ui: &mut Ui, cx: &mut AppContext<'_>, (method, simulation): (Method, &Simulation), unit: LengthUnit) {
    let Simulation::Done(_, distribution) = simulation else {
        let (total, percent) = (simulations::DRAWS, simulation.percent());
        text::caption_ui(ui, Hint::Simulating { total, percent }.to_string());
        progress::ui(ui, Card::Simulation(method).title(), percent);
        return;
    };
    histogram_ui(ui, cx, (method, distribution), unit);
    let unbounded = || report::NO_UPPER_BOUND.to_owned();
    let end = |length: Option<Length>| length.map_or_else(unbounded, |length| report::length(Some(length), unit));
    let interval = |Quantiles { near, far, .. }: Quantiles| near.map_or_else(unbounded, |near| report::range(near, far, unit));
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

fn histogram_ui(ui: &mut Ui, cx: &mut AppContext<'_>, (method, distribution): (Method, &Distribution), unit: LengthUnit) {
    let palette = theme::palette(ui);
    let Some(shape) = &distribution.histogram else { return };
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), theme::HISTOGRAM_HEIGHT), Sense::CLICK);
    let plot = rect.with_max_y(rect.bottom() - theme::HISTOGRAM_LABELS_HEIGHT);
    let most = shape.counts.iter().copied().max().unwrap_or(1).max(1);
    let count = f32::from(u16::try_from(shape.counts.len()).unwrap_or(u16::MAX).max(1));
    let width = plot.width() / count;
    let color = match method {
        Method::Stereo => palette.blue,
        Method::Monocular => palette.orange,
    };
    let mut x = plot.left();
    for &draws in &shape.counts {
        let height = plot.height() * to_f32(f64::from(draws) / f64::from(most));
        let bar = Rect::from_min_max(pos2(x, plot.bottom() - height), pos2(x + width, plot.bottom()));
        ui.painter().rect_filled(bar, 0.0, color);
        x += width;
    }
    ui.painter()
        .hline(plot.x_range(), plot.bottom(), egui::Stroke::new(theme::THIN_LINE, palette.line));
    let label = |position, anchor, words: String| {
        ui.painter()
            .text(position, anchor, words, theme::regular(theme::SMALL_SIZE), palette.muted);
    };
    label(rect.left_bottom(), Align2::LEFT_BOTTOM, report::length(Some(shape.low), unit));
    label(rect.right_bottom(), Align2::RIGHT_BOTTOM, report::length(Some(shape.high), unit));
    if let Some(median) = distribution.median {
        let span = shape.high.m() - shape.low.m();
        if span > 0.0 {
            let at = plot.left() + plot.width() * to_f32((median.m() - shape.low.m()) / span);
            ui.painter()
                .vline(at, plot.y_range(), egui::Stroke::new(theme::STRONG_LINE, palette.text));
        }
    }
    picture::describe(
        ui,
        &response,
        Card::Simulation(method).title(),
        &Description::Histogram {
            histogram: shape,
            draws: distribution.drawn,
            unit,
        },
    );
    chart::menu_ui(&response, Card::Simulation(method).title(), cx.commands);
}

/// A share of a width on the screen.
#[expect(clippy::cast_possible_truncation, reason = "a position on the screen needs no more than an f32")]
const fn to_f32(share: f64) -> f32 {
    share as f32
}
