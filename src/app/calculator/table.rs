//! The rows of inputs and outputs, and pairs of a name and a value.

use super::card::Card;
use crate::app::theme;
use crate::app::widgets::cards;
use crate::app::widgets::table::{Cell, row_ui, table_ui};
use crate::core::quantity::LengthUnit;
use depth_text::assess::Assessment;
use depth_text::report::{self, Row};
use egui::accesskit::Role;
use egui::text::LayoutJob;
use egui::{Color32, FontId, Ui};

/// The table "Key input parameters and outputs".
pub fn ui(ui: &mut Ui, assessment: &Assessment, unit_of_results: LengthUnit) {
    cards::card_ui(ui, Card::Table, Card::Table.title(), |ui| {
        let narrow = ui.available_width() < theme::NARROW_TABLE_WIDTH;
        let shares = if narrow { [1.25, 0.8, 0.45, 1.4] } else { [1.25, 0.55, 0.5, 1.7] };
        let size = if narrow { theme::SMALL_SIZE } else { theme::BODY_SIZE };
        let palette = theme::palette(ui);
        table_ui(ui, Card::Table.title(), |ui| {
            let header = |text, align_right| Cell {
                text: LayoutJob::simple_singleline(String::from(text), theme::strong(theme::SMALL_SIZE), palette.muted),
                role: Role::ColumnHeader,
                align_right,
            };
            let headers = vec![
                header("Parameter", false),
                header("Value", true),
                header("Unit", false),
                header("Description", false),
            ];
            row_ui(ui, headers, &shares);
            for Row {
                parameter,
                value,
                unit,
                symbol,
                description,
            } in report::parameter_rows(assessment, unit_of_results)
            {
                let cells = vec![
                    cell(ui, &parameter, theme::regular(size), Role::RowHeader),
                    Cell {
                        align_right: true,
                        ..cell(ui, &value, theme::strong(size), Role::Cell)
                    },
                    cell(ui, if narrow { &symbol } else { &unit }, theme::regular(size), Role::Cell),
                    cell(ui, &description, theme::regular(size), Role::Cell),
                ];
                row_ui(ui, cells, &shares);
            }
        });
    });
}

/// A table of names and values without a header, named `title`.
pub fn pairs_ui(ui: &mut Ui, title: &str, rows: &[(&str, String)]) {
    // A value stays in one line: nobody reads one whose unit is in the next.
    let width_of = |value: &str| {
        let galley = ui
            .painter()
            .layout_no_wrap(value.to_owned(), theme::strong(theme::BODY_SIZE), Color32::PLACEHOLDER);
        galley.size().x.ceil()
    };
    let full = ui.available_width();
    let widest = rows.iter().map(|(_, value)| width_of(value)).fold(0.0, f32::max).min(full * 0.75);
    table_ui(ui, title, |ui| {
        for (name, value) in rows {
            let cells = vec![
                cell(ui, name, theme::regular(theme::BODY_SIZE), Role::RowHeader),
                Cell {
                    align_right: true,
                    ..cell(ui, value, theme::strong(theme::BODY_SIZE), Role::Cell)
                },
            ];
            row_ui(ui, cells, &[full - widest, widest]);
        }
    });
}

fn cell(ui: &Ui, text: &str, font: FontId, role: Role) -> Cell {
    Cell {
        text: LayoutJob::simple(text.to_owned(), font, theme::palette(ui).text, 0.0),
        role,
        align_right: false,
    }
}
