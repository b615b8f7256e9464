//! The Rigs screen: the list of rigs, the editor of one, and all of them side by side.

mod compare;
mod editor;
mod list;
mod overview;
mod rig;
mod sensor_mode;

pub use list::{FILE_NAME, RigList, RigsInFile, from_file};
pub use rig::{MOST, Rig, number};
pub use sensor_mode::{KEYS as MODE_KEYS, OtherMode, other_mode};

use super::context::AppContext;
use super::navigation;
use super::theme::{self, Layout};
use super::widgets::scroll;
use depth_text::assess::Assessment;
use depth_text::form::Inputs;
use egui::{Align, Rect, Ui, UiBuilder, pos2};

/// State of the screen between frames, beside the list.
#[derive(Debug, Default)]
pub struct Rigs {
    /// What was typed into the rig that is shown, and what it means.
    assessed: Option<(Inputs, Assessment)>,
}

impl Rigs {
    /// Draws the screen: the list and the editor beside the comparison, or on a phone above it.
    pub fn ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>) {
        let gap = cx.layout.gap();
        if cx.layout == Layout::Phone {
            navigation::column_ui(ui, cx, "rigs", |ui, cx| {
                ui.spacing_mut().item_spacing.y = gap;
                self.form_ui(ui, cx);
                compare::ui(ui, cx);
                ui.add_space(gap);
            });
            return;
        }
        let all = ui.available_rect_before_wrap();
        let form_right = all.left() + cx.layout.form_width();
        let mut column_ui = |left: f32, right: f32, id: &str, add_contents: &mut dyn FnMut(&mut Ui)| {
            let rect = Rect::from_min_max(pos2(left, all.top()), pos2(right, all.bottom()));
            let top_down = egui::Layout::top_down(Align::Min);
            ui.scope_builder(UiBuilder::new().max_rect(rect).layout(top_down), |ui| {
                scroll::column_ui(ui, id, |ui| {
                    ui.spacing_mut().item_spacing.y = gap;
                    add_contents(ui);
                });
            });
        };
        column_ui(all.left(), form_right, "rigs", &mut |ui| self.form_ui(ui, cx));
        column_ui(form_right + gap, all.right(), "comparison", &mut |ui| compare::ui(ui, cx));
    }

    fn form_ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>) {
        let builder = UiBuilder::new()
            .accessibility_role(egui::accesskit::Role::Form)
            .accessibility_label("Rigs");
        ui.scope_builder(builder, |ui| {
            theme::card(theme::palette(ui)).show(ui, |ui| {
                ui.set_width(ui.available_width());
                overview::ui(ui, cx);
                if cx.settings.rigs.shown().is_some() {
                    self.refresh(cx.settings.rigs.shown().map(|rig| &rig.inputs));
                    ui.add_space(theme::ABOVE_HEADING);
                    let assessment = self.assessed.as_ref().map(|(_, assessment)| assessment);
                    editor::ui(ui, cx, assessment);
                }
            });
        });
    }

    fn refresh(&mut self, inputs: Option<&Inputs>) {
        let is_known = self.assessed.as_ref().map(|(inputs, _)| inputs) == inputs;
        if !is_known {
            self.assessed = inputs.map(|inputs| (inputs.clone(), inputs.assess()));
        }
    }
}
