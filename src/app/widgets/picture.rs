//! What pictures share: a name and a description for those who do not see them, an explanation while they are empty, and
//! axes with round numbers.

use crate::app::theme;
use egui::accesskit::Role;
use egui::{Align2, Response, Sense, Ui, vec2};

/// Names a picture and says in words what it shows.
pub fn describe(ui: &Ui, response: &Response, name: &str, description: &str) {
    ui.accesskit_node_builder(response.id, |node| {
        node.set_role(Role::Image);
        node.set_label(name);
        node.set_description(description);
    });
}

/// The space of a picture that has nothing to show yet, with a sentence that says what it will show and from what.
pub fn empty(ui: &mut Ui, name: &str, explanation: &str) {
    let palette = theme::palette(ui);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), theme::PICTURE_HEIGHT), Sense::hover());
    ui.painter().rect(
        rect,
        theme::CONTROL_RADIUS,
        egui::Color32::TRANSPARENT,
        egui::Stroke::new(1.0, palette.line),
        egui::StrokeKind::Inside,
    );
    let mut job = egui::text::LayoutJob::simple(
        explanation.to_owned(),
        theme::regular(theme::SMALL_SIZE),
        palette.muted,
        (rect.width() - 48.0).min(300.0),
    );
    job.halign = egui::Align::Center;
    let galley = ui.painter().layout_job(job);
    let position = Align2::CENTER_CENTER.anchor_size(rect.center(), galley.size()).center_top();
    ui.painter().galley(position, galley, palette.muted);
    describe(ui, &response, name, explanation);
}

/// Gives the axes of a plot drawn in `ui` the small and muted type of captions.
pub fn plot_type(ui: &mut Ui) {
    let palette = theme::palette(ui);
    ui.style_mut()
        .text_styles
        .insert(egui::TextStyle::Body, theme::regular(theme::SMALL_SIZE));
    ui.visuals_mut().override_text_color = Some(palette.muted);
    ui.add_space(2.0 * theme::STEP);
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
pub fn ticks(max: f64, count: u32) -> Vec<f64> {
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
