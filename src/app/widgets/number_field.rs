//! A field for a number that is not one of the inputs of a distance: in helpers, for range, tilt and ground plane.

use super::quantity_field::length_unit_choice;
use super::text;
use crate::app::theme::{self, SIGMA_WIDTH, UNIT_WIDTH};
use crate::core::quantity::LengthUnit;
use crate::formats::inputs::Severity;
use crate::formats::number;
use egui::accesskit::Role;
use egui::{Align2, Id, Response, RichText, TextEdit, Ui, vec2};

/// What the number counts.
#[derive(Debug)]
pub enum Unit<'a> {
    /// A fixed unit, such as "px" or "°".
    Fixed(&'static str),
    /// A length in a unit to choose.
    Choice(&'a mut LengthUnit),
}

/// A field with its name, unit, hint and error.
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
    /// Draws the field for `typed`, as high as the controls of `ui`. Returns whether it was left.
    pub fn ui(mut self, ui: &mut Ui, typed: &mut String) -> bool {
        let palette = theme::palette(ui);
        let name = ui.label(RichText::new(self.name).font(theme::strong(theme::BODY_SIZE)).color(palette.text));
        let mut left = false;
        let field = ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            let field = self.text_ui(ui, typed, name.id);
            left |= field.lost_focus();
            self.unit_ui(ui);
            left |= self.sigma_ui(ui).is_some_and(|sigma| sigma.lost_focus());
            field.id
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

    fn text_ui(&self, ui: &mut Ui, typed: &mut String, name: Id) -> Response {
        let palette = theme::palette(ui);
        let sigma_width = if self.sigma.is_some() { SIGMA_WIDTH + 6.0 } else { 0.0 };
        let width = (ui.available_width() - UNIT_WIDTH - 6.0 - sigma_width).max(60.0);
        let response = text_edit(typed)
            .id(ui.scope_id().with(("number field", self.name)))
            .hint_text(RichText::new(format!("e.g. {}", self.example)).color(palette.muted))
            .desired_width(width)
            .min_size(vec2(width, ui.spacing().interact_size.y))
            .show(ui)
            .response
            .response
            .labelled_by(name);
        ui.accesskit_node_builder(response.id, |node| {
            if !self.signed {
                node.set_role(Role::NumberInput);
            }
            node.set_description(match self.unit {
                Unit::Fixed(unit) if !unit.is_empty() => format!("In {}. {}", text::spoken_unit(unit), self.hint).trim_end().to_owned(),
                Unit::Fixed(_) | Unit::Choice(_) => self.hint.to_owned(),
            });
        });
        response
    }

    fn unit_ui(&mut self, ui: &mut Ui) {
        match &mut self.unit {
            Unit::Fixed(unit) => {
                let size = vec2(UNIT_WIDTH, ui.spacing().interact_size.y);
                let (rect, _) = ui.allocate_exact_size(size, egui::Sense::hover());
                ui.painter().text(
                    rect.left_center() + vec2(6.0, 0.0),
                    Align2::LEFT_CENTER,
                    *unit,
                    theme::regular(theme::BODY_SIZE),
                    theme::palette(ui).muted,
                );
            }
            Unit::Choice(unit) => {
                length_unit_choice(ui, (self.name, "unit"), &format!("Unit of {}", self.name), unit, UNIT_WIDTH);
            }
        }
    }

    fn sigma_ui(&mut self, ui: &mut Ui) -> Option<Response> {
        let palette = theme::palette(ui);
        let sigma = self.sigma.as_deref_mut()?;
        // Not `Role::NumberInput`: the number keyboard of most phones has no "%".
        let output = text_edit(sigma)
            .id(ui.scope_id().with(("uncertainty", self.name)))
            .prefix(RichText::new("±").color(palette.muted))
            .hint_text(RichText::new("none").color(palette.muted))
            .desired_width(SIGMA_WIDTH)
            .min_size(vec2(SIGMA_WIDTH, ui.spacing().interact_size.y))
            .show(ui);
        Some(output.response.response.accessible_name(format!("Uncertainty of {}", self.name)))
    }
}

fn text_edit(text: &mut String) -> TextEdit<'_> {
    TextEdit::singleline(text)
        .align(Align2::RIGHT_CENTER)
        .margin(egui::Margin::symmetric(10, 4))
}
