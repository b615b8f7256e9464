//! The chart of stereo distance against monocular distance.

use crate::app::theme;
use crate::app::widgets::picture;
use crate::core::problem::{Method, Solution};
use crate::core::quantity::{Length, LengthUnit};
use crate::formats::{number, report};
use egui::{Align2, RichText, Ui};
use egui_plot::{Bar, BarChart, GridMark, Line, Plot, PlotPoint, PlotPoints, Text};

pub const TITLE: &str = "Stereo against monocular";

/// Draws the chart.
pub fn show(ui: &mut Ui, solution: &Solution, unit: LengthUnit) {
    let palette = theme::palette(ui);
    let bars: Vec<(f64, Method, f64)> = [(0.0, Method::Stereo), (1.0, Method::Monocular)]
        .into_iter()
        .filter_map(|(x, method)| Some((x, method, solution.outcome(method).distance()?.in_unit(unit))))
        .filter(|(_, _, value)| value.is_normal())
        .collect();
    let Some(longest) = bars.iter().map(|&(_, _, value)| value).max_by(f64::total_cmp) else {
        picture::empty(
            ui,
            TITLE,
            "The distances of both methods side by side, as soon as one of them is known.",
        );
        return;
    };
    // Heights are fractions of the axis, so that distances of any magnitude can be drawn.
    let top = picture::round_up(longest * 1.15);
    let ticks = picture::ticks(top, 4);
    let marks: Vec<GridMark> = ticks
        .iter()
        .map(|tick| GridMark {
            value: tick / top,
            step_size: 1.0,
        })
        .collect();
    picture::plot_type(ui);
    let response = Plot::new("bars")
        .height(theme::PICTURE_HEIGHT)
        .allow_drag(false)
        .allow_scroll(false)
        .allow_zoom(false)
        .allow_boxed_zoom(false)
        .allow_double_click_reset(false)
        .show_x(false)
        .show_y(false)
        .show_background(false)
        .sense(egui::Sense::hover())
        .set_margin_fraction(egui::Vec2::ZERO)
        .default_x_bounds(-0.75, 1.75)
        .default_y_bounds(0.0, 1.0)
        .auto_bounds(false)
        .grid_color(palette.line)
        .grid_fade(0.0)
        .show_grid([false, true])
        .y_grid_spacer(move |_| marks.clone())
        .x_grid_spacer(|_| [0.0, 1.0].map(|value| GridMark { value, step_size: 1.0 }).to_vec())
        .x_axis_formatter(|mark, _| {
            if mark.value < 0.5 {
                "Stereo distance".to_owned()
            } else {
                "Monocular distance".to_owned()
            }
        })
        .y_axis_formatter(move |mark, _| {
            if mark.value == 0.0 {
                "0".to_owned()
            } else {
                format!("{} {}", number::plain(mark.value * top), unit.symbol())
            }
        })
        .show(ui, |plot| {
            for &(x, method, value) in &bars {
                let color = match method {
                    Method::Stereo => palette.blue,
                    Method::Monocular => palette.orange,
                };
                let bar = Bar::new(x, value / top).width(0.56).fill(color).stroke(egui::Stroke::NONE);
                plot.bar_chart(BarChart::new(method.name(), vec![bar]).allow_hover(false));
                let known = solution.uncertainty(method);
                if let Some(known) = known {
                    let end = |length: Length| (length.in_unit(unit) / top).min(2.0);
                    let (near, far) = (end(known.interval.near), known.interval.far.map_or(2.0, end));
                    let whisker = |points| {
                        let stroke = egui::Stroke::new(1.5, palette.text);
                        Line::new("interval", PlotPoints::from(points)).stroke(stroke).allow_hover(false)
                    };
                    plot.line(whisker(vec![[x, near], [x, far]]));
                    for y in [near, far] {
                        plot.line(whisker(vec![[x - 0.06, y], [x + 0.06, y]]));
                    }
                }
                let label = match known {
                    Some(known) => report::with_sigma(Length::new(value, unit), known.sigma, unit).text(unit),
                    None => format!("{} {}", number::significant(value, report::DIGITS), unit.symbol()),
                };
                // Above the whisker, so that neither covers the other.
                let above = known
                    .and_then(|known| known.interval.far)
                    .map_or(value, |far| far.in_unit(unit))
                    .min(top * 0.92);
                plot.text(
                    Text::new(
                        "value",
                        PlotPoint::new(x, above / top + 0.015),
                        RichText::new(label).font(theme::strong(theme::SMALL_SIZE)).color(palette.text),
                    )
                    .color(palette.text)
                    .anchor(Align2::CENTER_BOTTOM)
                    .allow_hover(false),
                );
            }
        })
        .response;
    let said: Vec<String> = Method::ALL
        .into_iter()
        .map(|method| {
            let distance = solution.outcome(method).distance();
            let words = match (distance, solution.uncertainty(method)) {
                (Some(distance), Some(known)) => format!(
                    "{}, from {}",
                    report::with_sigma(distance, known.sigma, unit).text(unit),
                    report::interval(known, unit)
                ),
                _ => report::length(distance, unit),
            };
            format!("{} distance {words}", method.name())
        })
        .collect();
    picture::describe(ui, &response, TITLE, &format!("Bar chart. {}.", said.join(", ")));
}
