//! What curves and charts share: a frame that stays as it is drawn, small type, and axes with round numbers. Coordinates are
//! fractions of the axes, so that every magnitude can be drawn.

use crate::app::theme;
use crate::core::quantity::LengthUnit;
use depth_text::number;
use egui::{Sense, Ui, Vec2};
use egui_plot::{GridMark, Plot};

/// A plot in the colors of the theme and the type of captions, which neither moves nor zooms, over y from 0 to 1 and `x`.
pub fn plot_ui<'a>(ui: &mut Ui, id: &str, x: std::ops::RangeInclusive<f64>) -> Plot<'a> {
    let palette = theme::palette(ui);
    ui.style_mut()
        .text_styles
        .insert(egui::TextStyle::Body, theme::regular(theme::SMALL_SIZE));
    ui.visuals_mut().override_text_color = Some(palette.muted);
    ui.add_space(2.0 * theme::STEP);
    Plot::new(id)
        .height(theme::PICTURE_HEIGHT)
        .allow_drag(false)
        .allow_scroll(false)
        .allow_zoom(false)
        .allow_boxed_zoom(false)
        .allow_double_click_reset(false)
        .show_x(false)
        .show_y(false)
        .show_background(false)
        .sense(Sense::hover())
        .set_margin_fraction(Vec2::ZERO)
        .default_x_bounds(*x.start(), *x.end())
        .default_y_bounds(0.0, 1.0)
        .auto_bounds(false)
        .grid_color(palette.line)
        .grid_fade(0.0)
}

/// Marks at round numbers on an axis that ends at `end`.
pub fn marks(end: f64) -> Vec<GridMark> {
    let mark = |tick| GridMark {
        value: tick / end,
        step_size: 1.0,
    };
    ticks(end, 4).into_iter().map(mark).collect()
}

/// The label of a mark on an axis that ends at `end` of `unit`.
pub fn mark_label(mark: GridMark, end: f64, unit: LengthUnit) -> String {
    if mark.value == 0.0 {
        "0".to_owned()
    } else {
        format!("{} {}", number::plain(mark.value * end), unit.symbol())
    }
}

/// The smallest of 1, 2, 2.5, 5 times a power of ten that is not below `value` (positive).
pub fn round_up(value: f64) -> f64 {
    let power = 10f64.powf(value.log10().floor());
    [1.0, 2.0, 2.5, 5.0, 10.0]
        .into_iter()
        .map(|digit| digit * power)
        .find(|&candidate| candidate >= value * (1.0 - 1e-12))
        .unwrap_or(value)
}

/// The largest of 1, 2, 5 times a power of ten that is not above `value` (positive).
pub fn round_down(value: f64) -> f64 {
    let power = 10f64.powf(value.log10().floor());
    [5.0, 2.0, 1.0]
        .into_iter()
        .map(|digit| digit * power)
        .find(|&candidate| candidate <= value * (1.0 + 1e-12))
        .unwrap_or(value)
}

/// Round numbers from 0 to `max`, about `count` of them.
fn ticks(max: f64, count: u32) -> Vec<f64> {
    let step = round_up(max / f64::from(count.max(1)));
    (0..=2 * count.max(1))
        .map(|i| f64::from(i) * step)
        .take_while(|&tick| tick <= max * (1.0 + 1e-9))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_end_on_round_numbers_and_hold_what_they_show() {
        for (value, expected) in [
            (80.0, 100.0),
            (2.24, 2.5),
            (100.0, 100.0),
            (0.011, 0.02),
            (1e-300, 1e-300),
            (3e300, 5e300),
        ] {
            let got = round_up(value);
            assert!((got / expected - 1.0).abs() < 1e-9, "{value}: {got}");
        }
        for (value, expected) in [(0.7, 0.5), (0.5, 0.5), (1.9e300, 1e300)] {
            assert!((round_down(value) / expected - 1.0).abs() < 1e-9, "{value}");
        }
        assert_eq!(ticks(2.5, 5), [0.0, 0.5, 1.0, 1.5, 2.0, 2.5]);
        assert_eq!(ticks(100.0, 5).len(), 6);
    }
}
