//! The uncertainty cards: the share of each input in the variance, and a Monte Carlo simulation where first order is not good enough.

use super::card::Card;
use super::simulations::{self, Simulation, Simulations};
use crate::app::context::AppContext;
use crate::app::sentences::{Description, Hint};
use crate::app::theme;
use crate::app::widgets::{cards, picture, progress, text};
use crate::core::monte_carlo::{Distribution, Quantiles};
use crate::core::problem::{Field, Method};
use crate::core::quantity::{Length, LengthUnit};
use depth_text::assess::Assessment;
use depth_text::report;
use depth_text::sentences::Statement;
use depth_text::sentences::{percent, short_name};
use egui::{Align2, Color32, Rect, Sense, Ui, Vec2, pos2, vec2};

/// Draws the cards of each method whose distance has a σ.
pub fn ui(ui: &mut Ui, cx: &AppContext<'_>, simulations: &Simulations) {
    let (columns, gap, unit) = (cx.layout.columns(), cx.layout.gap(), cx.unit());
    let assessment = cx.session.assessment();
    let methods: Vec<Method> = Method::ALL
        .into_iter()
        .filter(|&method| assessment.solution.uncertainty(method).is_some())
        .collect();
    let simulated = |method: &Method| !matches!(simulations.of(*method), Simulation::None);
    let budgets = methods.iter().copied().map(Card::Budget).collect::<Vec<_>>();
    let histograms = methods.iter().copied().filter(simulated).map(Card::Simulation).collect::<Vec<_>>();
    for row in [budgets, histograms].iter().flat_map(|cards| cards.chunks(columns.min(2))) {
        cards::row_ui(ui, row, gap, |ui, card, row| {
            cards::card_ui(ui, card, card.title(), |ui| {
                match card {
                    Card::Budget(method) => budget_ui(ui, assessment, method, unit),
                    Card::Simulation(method) => simulation_ui(ui, method, simulations.of(method), unit),
                    _ => {}
                }
                cards::fill_height_ui(ui, row);
            });
        });
    }
}

/// The color of a source of variance. No two sources of one method have the same.
fn color_of(ui: &Ui, field: Field) -> Color32 {
    let palette = theme::palette(ui);
    match field {
        Field::FocalLength | Field::Lens | Field::Fy | Field::Zero => palette.muted,
        Field::Baseline | Field::RealWidth => palette.orange,
        Field::Disparity | Field::ImageWidth => palette.blue,
        Field::Doffs | Field::Tilt => palette.amber,
    }
}

/// One bar, cut into the shares of the variance, over a line for each.
fn budget_ui(ui: &mut Ui, assessment: &Assessment, method: Method, unit: LengthUnit) {
    let palette = theme::palette(ui);
    let Some(uncertainty) = assessment.solution.uncertainty(method) else {
        return;
    };
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), theme::BUDGET_BAR_HEIGHT), Sense::hover());
    let mut x = rect.left();
    for share in &uncertainty.budget {
        let width = rect.width() * to_f32(share.share);
        let part = Rect::from_min_size(pos2(x, rect.top()), vec2(width, rect.height()));
        ui.painter().rect_filled(part, 0.0, color_of(ui, share.source));
        x += width;
        ui.painter()
            .vline(x, rect.y_range(), egui::Stroke::new(theme::STRONG_LINE, palette.surface));
    }
    let shares = report::budget(assessment, uncertainty);
    picture::describe(
        ui,
        &response,
        Card::Budget(method).title(),
        &Description::Budget { shares: &shares },
    );
    ui.add_space(theme::STEP);
    for share in uncertainty.budget.iter().filter(|share| share.share > 0.0) {
        let line = vec2(ui.available_width(), theme::LEGEND_HEIGHT);
        ui.allocate_ui_with_layout(line, egui::Layout::left_to_right(egui::Align::Center), |ui| {
            let (dot, _) = ui.allocate_exact_size(Vec2::splat(theme::LEGEND_MARK), Sense::hover());
            ui.painter().rect_filled(dot, theme::MARK_RADIUS, color_of(ui, share.source));
            ui.label(format!("{} {}", short_name(assessment.worded(share.source)), percent(share.share)));
        });
    }
    if let Some(bias) = uncertainty.notable_bias() {
        text::caption_ui(ui, Hint::Bias { bias, unit }.to_string());
    }
    if !uncertainty.model.first_order_is_good() {
        let amber = palette.amber;
        ui.label(
            egui::RichText::new(format!("⚠ {}", Statement::FirstOrderIsPoor { has_simulation: true }))
                .size(theme::SMALL_SIZE)
                .color(amber),
        );
    }
}

fn simulation_ui(ui: &mut Ui, method: Method, simulation: &Simulation, unit: LengthUnit) {
    let Simulation::Done(_, distribution) = simulation else {
        let (total, percent) = (simulations::DRAWS, simulation.percent());
        text::caption_ui(ui, Hint::Simulating { total, percent }.to_string());
        progress::ui(ui, Card::Simulation(method).title(), percent);
        return;
    };
    histogram_ui(ui, method, distribution, unit);
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

fn histogram_ui(ui: &mut Ui, method: Method, distribution: &Distribution, unit: LengthUnit) {
    let palette = theme::palette(ui);
    let Some(shape) = &distribution.histogram else { return };
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), theme::HISTOGRAM_HEIGHT), Sense::hover());
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
}

/// A share of a width on the screen.
#[expect(clippy::cast_possible_truncation, reason = "a position on the screen needs no more than an f32")]
const fn to_f32(share: f64) -> f32 {
    share as f32
}
