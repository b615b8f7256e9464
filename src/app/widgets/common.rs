//! Choices among common numbers for the field above.

use super::menu::List;
use crate::app::theme;
use depth_text::choices::{DEPTH_SCALES, SENSOR_FORMATS, SensorFormat};
use depth_text::number::plain;
use egui::Ui;

/// Draws the choice among the formats of sensors. Returns the one that was chosen now.
pub fn sensor_formats_ui(ui: &mut Ui) -> Option<&'static SensorFormat> {
    let name = |format: &SensorFormat| format!("{}: {} × {} mm", format.name, plain(format.width_mm), plain(format.height_mm));
    let names: Vec<String> = SENSOR_FORMATS.iter().map(name).collect();
    let now = list_ui(ui, ["Common sensor formats", "Common formats…"], &names);
    now.and_then(|at| SENSOR_FORMATS.get(at))
}

/// Draws the choice among the scales of depth. Returns the steps in a meter of the one that was chosen now.
pub fn depth_scales_ui(ui: &mut Ui) -> Option<f64> {
    let name = |(steps, of): &(f64, &str)| format!("{}: {of}", plain(*steps));
    let names: Vec<String> = DEPTH_SCALES.iter().map(name).collect();
    let now = list_ui(ui, ["Common depth scales", "Common scales…"], &names);
    now.and_then(|at| DEPTH_SCALES.get(at)).map(|(steps, _)| *steps)
}

/// A list named `name`, which says `shown` while it is closed. Returns the place of what was chosen now.
fn list_ui(ui: &mut Ui, [name, shown]: [&str; 2], names: &[String]) -> Option<usize> {
    let list = List {
        name,
        shown,
        width: theme::COMMON_WIDTH,
        names,
        chosen: None,
    };
    let (_, now) = list.ui(ui, name);
    ui.add_space(2.0 * theme::STEP);
    now
}
