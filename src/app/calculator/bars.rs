//! The chart of stereo distance against monocular distance.

use super::card::Card;
use crate::app::sentences::{Description, Hint};
use crate::app::theme::{self, Palette};
use crate::app::widgets::{picture, plot};
use crate::core::problem::{Method, Solution};
use crate::core::quantity::{Length, LengthUnit};
use crate::core::uncertainty::Interval;
use depth_text::names::Named as _;
use depth_text::style::Style;
use egui::{Align2, RichText, Stroke, Ui};
use egui_plot::{Bar, BarChart, GridMark, Line, PlotPoint, PlotPoints, PlotUi, Text};

/// Draws the chart.
pub fn ui(ui: &mut Ui, solution: &Solution, unit: LengthUnit) {
    let Some(model) = Model::new(solution, unit) else {
        picture::empty_ui(ui, Card::Bars.title(), &Hint::NoBars);
        return;
    };
    let top = model.top;
    let marks = plot::marks(top);
    let palette = theme::palette(ui);
    let response = plot::plot_ui(ui, "bars", -0.75..=1.75)
        .show_grid([false, true])
        .y_grid_spacer(move |_| marks.clone())
        .x_grid_spacer(|_| [0.0, 1.0].map(|value| GridMark { value, step_size: 1.0 }).to_vec())
        .x_axis_formatter(|mark, _| {
            if mark.value < 0.5 {
                Method::Stereo.name().to_owned()
            } else {
                Method::Monocular.name().to_owned()
            }
        })
        .y_axis_formatter(move |mark, _| plot::mark_label(mark, top, unit))
        .show(ui, |plot| {
            for bar in &model.bars {
                bar.paint(plot, top, unit, palette);
            }
        })
        .response;
    picture::describe(ui, &response, Card::Bars.title(), &Description::Bars { solution, unit });
}

/// The bars, and the round number at the top of the axis.
struct Model {
    bars: Vec<MethodBar>,
    top: f64,
}

/// The bar of one method.
struct MethodBar {
    method: Method,
    /// In the unit of the results.
    distance: f64,
    interval: Option<Interval>,
    label: String,
}

impl Model {
    /// The bars of the distances that can be drawn; `None` where there are none.
    fn new(solution: &Solution, unit: LengthUnit) -> Option<Self> {
        let bar = |method| {
            let distance = solution.outcome(method).distance()?.in_unit(unit);
            let uncertainty = solution.uncertainty(method);
            let label = Style::WINDOW.distance(solution, method, unit);
            distance.is_normal().then_some(MethodBar {
                method,
                distance,
                interval: uncertainty.map(|uncertainty| uncertainty.interval),
                label,
            })
        };
        let bars: Vec<_> = Method::ALL.into_iter().filter_map(bar).collect();
        let longest = bars.iter().map(|bar| bar.distance).max_by(f64::total_cmp)?;
        let top = plot::round_up(longest * 1.15);
        Some(Self { bars, top })
    }
}

impl MethodBar {
    /// Paints the bar, the whisker of its 1 σ interval, and its distance above both.
    fn paint(&self, plot: &mut PlotUi<'_>, top: f64, unit: LengthUnit, palette: &Palette) {
        let (x, color) = match self.method {
            Method::Stereo => (0.0, palette.blue),
            Method::Monocular => (1.0, palette.orange),
        };
        let bar = Bar::new(x, self.distance / top).width(0.56).fill(color).stroke(Stroke::NONE);
        plot.bar_chart(BarChart::new(self.method.name(), vec![bar]).allow_hover(false));
        if let Some(interval) = self.interval {
            let end = |length: Length| (length.in_unit(unit) / top).min(2.0);
            let (near, far) = (end(interval.near), interval.far.map_or(2.0, end));
            let whisker = |points| {
                let stroke = Stroke::new(theme::STRONG_LINE, palette.text);
                Line::new("interval", PlotPoints::from(points)).stroke(stroke).allow_hover(false)
            };
            plot.line(whisker(vec![[x, near], [x, far]]));
            for y in [near, far] {
                plot.line(whisker(vec![[x - 0.06, y], [x + 0.06, y]]));
            }
        }
        // Above the whisker, so that neither covers the other.
        let above = self
            .interval
            .and_then(|interval| interval.far)
            .map_or(self.distance, |far| far.in_unit(unit))
            .min(top * 0.92);
        let label = RichText::new(&self.label)
            .font(theme::strong(theme::SMALL_SIZE))
            .color(palette.text);
        plot.text(
            Text::new("value", PlotPoint::new(x, above / top + 0.015), label)
                .color(palette.text)
                .anchor(Align2::CENTER_BOTTOM)
                .allow_hover(false),
        );
    }
}
