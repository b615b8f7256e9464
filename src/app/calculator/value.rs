//! How a distance is written.

use crate::app::theme::{self, Palette};
use depth_text::report::strip::Value;
use egui::text::{LayoutJob, TextFormat};

/// "(1.400 ± 0.016) m", as large as fits.
pub fn value_job(palette: &Palette, value: &Value, size: f32, room: f32) -> LayoutJob {
    let mut job = LayoutJob::default();
    let Value::Number {
        number,
        sigma,
        power,
        unit,
    } = value
    else {
        return job;
    };
    let characters = value.text().chars().count();
    // A number that is too long is smaller; about 0.56 of its size is the width of a sign.
    let longest = room / (0.56 * f32::from(u16::try_from(characters).unwrap_or(u16::MAX).max(1)));
    let size = size.min(longest);
    let strong = TextFormat::simple(theme::strong(size), palette.text);
    let quiet = TextFormat::simple(theme::regular(size), palette.muted);
    match sigma {
        Some(sigma) => {
            job.append("(", 0.0, quiet.clone());
            job.append(number, 0.0, strong.clone());
            job.append(&format!(" ± {sigma})"), 0.0, quiet);
        }
        None => job.append(number, 0.0, strong.clone()),
    }
    let behind = unit.map_or_else(|| power.clone(), |unit| unit.behind(power));
    job.append(&behind, 0.0, strong);
    job
}

/// "was 1.400 m"
pub fn was_job(palette: &Palette, was: &str) -> LayoutJob {
    let mut job = LayoutJob::default();
    let size = theme::RESULT_SIZE;
    job.append("was ", 0.0, TextFormat::simple(theme::regular(size), palette.stale));
    job.append(was, 0.0, TextFormat::simple(theme::strong(size), palette.stale));
    job
}
