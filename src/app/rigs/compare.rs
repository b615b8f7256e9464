//! All rigs side by side.

use super::list::letter;
use super::rig::Rig;
use crate::app::context::AppContext;
use crate::app::theme;
use crate::app::widgets::cards;
use crate::app::widgets::table::{self, Cell};
use crate::app::widgets::text;
use depth_text::field::Key;
use depth_text::fields;
use depth_text::names::Named as _;
use depth_text::reading;
use depth_text::unit::Unit;
use egui::Ui;
use egui::accesskit::Role;
use egui::text::LayoutJob;

/// Draws the card.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let rigs = &cx.settings.rigs.all;
    let card = cards::Frame {
        title: "Side by side",
        caption: "",
        height: None,
    };
    card.ui(ui, "rigs side by side", |ui| {
        if rigs.is_empty() {
            text::paragraph_ui(
                ui,
                "Here the rigs stand side by side: the size of their images, focal lengths, principal points and baselines. Files of OpenCV, ROS, Kalibr, KITTI, Middlebury, COLMAP, ORB-SLAM, ZED, RealSense and others are recognized by what is in them.",
            );
            return;
        }
        table_ui(ui, rigs);
    });
}

fn table_ui(ui: &mut Ui, rigs: &[Rig]) {
    let palette = theme::palette(ui);
    let shares: Vec<f32> = std::iter::once(theme::RIG_HEADER_SHARE).chain(rigs.iter().map(|_| 1.0)).collect();
    let cell = |words: String, role: Role| {
        let (font, color) = match role {
            Role::Cell => (theme::regular(theme::BODY_SIZE), palette.text),
            _ => (theme::strong(theme::SMALL_SIZE), palette.muted),
        };
        Cell {
            text: LayoutJob::simple(words, font, color, 0.0),
            role,
            align_right: false,
        }
    };
    table::table_ui(ui, "Rigs side by side", |ui| {
        let names = rigs
            .iter()
            .enumerate()
            .map(|(at, rig)| format!("{} {}", letter(at), rig.shown_name()));
        let header = std::iter::once("Quantity".to_owned()).chain(names);
        table::row_ui(ui, header.map(|words| cell(words, Role::ColumnHeader)).collect(), &shares);
        let mut row_ui = |name: &str, of: &dyn Fn(&Rig) -> String| {
            let values = rigs.iter().map(|rig| cell(of(rig), Role::Cell));
            table::row_ui(
                ui,
                std::iter::once(cell(name.to_owned(), Role::RowHeader)).chain(values).collect(),
                &shares,
            );
        };
        row_ui("Images", &|rig| rig.basis.name().to_owned());
        for key in Rig::KEYS {
            // The name of the zero point is a sentence.
            let name = if key == fields::ZERO { key.label } else { key.name };
            row_ui(name, &|rig| shown(rig, key));
        }
        row_ui("Distortion", &|rig| or_dash(&rig.distortion));
        row_ui("Source", &|rig| or_dash(&rig.source));
    });
}

fn or_dash(words: &str) -> String {
    if words.trim().is_empty() {
        "–".to_owned()
    } else {
        words.to_owned()
    }
}

/// A number as it was read, with its σ; a dash where there is none, and what was typed where it cannot be read.
fn shown(rig: &Rig, key: Key) -> String {
    let entry = rig.inputs.entry(key);
    match reading::read(key, entry) {
        Ok(None) => "–".to_owned(),
        Ok(Some(read)) => {
            let sigma = entry.sigma_text();
            let sigma = if sigma.is_empty() || !key.has_sigma {
                String::new()
            } else {
                format!(" ± {sigma}")
            };
            format!("{}{sigma} {}", read.number_text, read.unit.map_or("", Unit::symbol))
        }
        Err(_) => format!("“{}”", entry.text.trim()),
    }
}
