//! The choice among the formats of sensors.

use super::menu::List;
use crate::app::theme;
use depth_text::choices::{SENSOR_FORMATS, SensorFormat};
use depth_text::number::plain;
use egui::Ui;

/// Draws it. Returns the format that was chosen now.
pub fn ui(ui: &mut Ui) -> Option<&'static SensorFormat> {
    let name = |format: &SensorFormat| format!("{}: {} × {} mm", format.name, plain(format.width_mm), plain(format.height_mm));
    let names: Vec<String> = SENSOR_FORMATS.iter().map(name).collect();
    let list = List {
        name: "Common sensor formats",
        shown: "Common formats…",
        width: theme::SENSOR_FORMATS_WIDTH,
        names: &names,
        chosen: None,
    };
    let (_, now) = list.ui(ui, "sensor formats");
    ui.add_space(2.0 * theme::STEP);
    now.and_then(|at| SENSOR_FORMATS.get(at))
}
