//! A field for a number that is not one of the inputs of a distance: in helpers, for range, tilt and ground plane.

use super::quantity_field::length_unit_choice;
use super::text;
use crate::app::theme::{self, SIGMA_WIDTH, UNIT_WIDTH};
use crate::core::quantity::LengthUnit;
use crate::formats::inputs::Severity;
use crate::formats::number;
use egui::accesskit::Role;
use egui::{Align2, RichText, TextEdit, Ui, vec2};

/// What the number counts.
#[derive(Debug)]
pub enum Unit<'a> {
    /// A fixed unit, such as "px" or "°".
    Fixed(&'static str),
    /// A length in a unit to choose.
    Choice(&'a mut LengthUnit),
}

/// A field with its surroundings.
#[derive(Debug)]
pub struct NumberField<'a> {
    /// The name above it.
    pub name: &'static str,
    /// The sentence below it; may be empty.
    pub hint: &'static str,
    /// What is shown while it is empty.
    pub example: &'static str,
    /// What the number counts.
    pub unit: Unit<'a>,
    /// Whether it can be below zero: the number keyboards of some phones have no minus.
    pub signed: bool,
    /// The text of its σ, where one is asked for.
    pub sigma: Option<&'a mut String>,
}

impl NumberField<'_> {
    /// Draws the field for `text`. Returns whether it was left.
    pub fn show(self, ui: &mut Ui, typed: &mut String, height: f32) -> bool {
        let palette = theme::palette(ui);
        let name = ui.label(RichText::new(self.name).font(theme::strong(theme::BODY_SIZE)).color(palette.text));
        let mut left = false;
        let field = ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            ui.spacing_mut().interact_size.y = height;
            let sigma_width = if self.sigma.is_some() { SIGMA_WIDTH + 6.0 } else { 0.0 };
            let width = (ui.available_width() - UNIT_WIDTH - 6.0 - sigma_width).max(60.0);
            let text_edit = |text| {
                TextEdit::singleline(text)
                    .align(Align2::RIGHT_CENTER)
                    .margin(egui::Margin::symmetric(10, 4))
            };
            let response = text_edit(typed)
                .id(ui.scope_id().with(("number field", self.name)))
                .hint_text(RichText::new(format!("e.g. {}", self.example)).color(palette.muted))
                .desired_width(width)
                .min_size(vec2(width, height))
                .show(ui)
                .response
                .response
                .labelled_by(name.id);
            ui.accesskit_node_builder(response.id, |node| {
                if !self.signed {
                    node.set_role(Role::NumberInput);
                }
                node.set_description(match self.unit {
                    Unit::Fixed(unit) if !unit.is_empty() => format!("In {}. {}", text::spoken_unit(unit), self.hint).trim_end().to_owned(),
                    Unit::Fixed(_) | Unit::Choice(_) => self.hint.to_owned(),
                });
            });
            left |= response.lost_focus();
            let field = response.id;
            match self.unit {
                Unit::Fixed(unit) => {
                    let (rect, _) = ui.allocate_exact_size(vec2(UNIT_WIDTH, height), egui::Sense::hover());
                    ui.painter().text(
                        rect.left_center() + vec2(6.0, 0.0),
                        Align2::LEFT_CENTER,
                        unit,
                        theme::regular(theme::BODY_SIZE),
                        palette.muted,
                    );
                }
                Unit::Choice(unit) => {
                    length_unit_choice(ui, (self.name, "unit"), &format!("Unit of {}", self.name), unit, UNIT_WIDTH);
                }
            }
            if let Some(sigma) = self.sigma {
                // No number keyboard: on most phones it has no "%".
                let response = text_edit(sigma)
                    .id(ui.scope_id().with(("uncertainty", self.name)))
                    .prefix(RichText::new("±").color(palette.muted))
                    .hint_text(RichText::new("none").color(palette.muted))
                    .desired_width(SIGMA_WIDTH)
                    .min_size(vec2(SIGMA_WIDTH, height))
                    .show(ui)
                    .response
                    .response
                    .accessible_name(format!("Uncertainty of {}", self.name));
                left |= response.lost_focus();
            }
            field
        });
        if !self.hint.is_empty() {
            text::caption(ui, self.hint);
        }
        if !typed.trim().is_empty() && number::read(typed).is_err() {
            let sentence = "Type one number with a decimal point or comma.";
            text::note(ui, Severity::Error, sentence, Some(field.inner));
        }
        ui.add_space(theme::STEP);
        left
    }
}
