//! The Learn screen: the texts of `assets/learn.md`.

mod markdown;

use super::command::Command;
use super::theme::{self, Layout};
use super::widgets::scroll;
use crate::formats::inputs::Inputs;
use crate::formats::link;
use egui::Ui;
use markdown::Document;

/// The text, shown here and built into the site's own page.
pub const TEXT: &str = include_str!("../../../assets/learn.md");

/// The text, taken apart once.
#[derive(Debug)]
pub struct Learn {
    document: Document,
}

impl Default for Learn {
    fn default() -> Self {
        Self {
            document: Document::parse(TEXT),
        }
    }
}

impl Learn {
    /// Draws the screen. A link to an example adds the command that opens it.
    pub fn show(&self, ui: &mut Ui, layout: Layout, commands: &mut Vec<Command>) {
        let mut followed = None;
        scroll::column(ui, "learn", |ui| {
            ui.vertical_centered(|ui| {
                ui.set_max_width(ui.available_width().min(theme::TEXT_WIDTH + 2.0 * theme::GAP));
                ui.with_layout(egui::Layout::top_down(egui::Align::Min), |ui| {
                    theme::card(theme::palette(ui)).show(ui, |ui| {
                        ui.set_width(ui.available_width());
                        followed = self.document.show(ui, layout.control_height());
                    });
                    ui.add_space(layout.gap());
                });
            });
        });
        if let Some(target) = followed {
            let mut inputs = Inputs::default();
            if link::apply(&target, &mut inputs) {
                commands.push(Command::Open(Box::new(inputs), "The example is filled in."));
            }
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn both_examples_are_linked_and_their_links_load_them() {
        let links: Vec<&str> = TEXT
            .match_indices("](#")
            .filter_map(|(at, _)| TEXT.get(at + 2..)?.split(')').next())
            .collect();
        let distances: Vec<f64> = links
            .iter()
            .filter_map(|target| {
                let mut inputs = Inputs::default();
                link::apply(target, &mut inputs).then(|| inputs.assess().solution)
            })
            .filter_map(|solution| solution.stereo.distance().or(solution.monocular.distance()))
            .map(crate::core::quantity::Length::m)
            .collect();
        assert_eq!(distances, [1.4, 4.275]);
    }

    #[test]
    fn every_topic_of_the_page_is_there() {
        for topic in [
            "Who it is for",
            "Common misconceptions",
            "Stereo: distance from disparity",
            "Monocular: distance from a known size",
            "The variables",
            "a coffee mug",
            "a doorway",
            "How to use the calculator",
            "What limits the accuracy",
            "Questions",
        ] {
            assert!(TEXT.lines().any(|line| line.starts_with("##") && line.contains(topic)), "{topic}");
        }
        let questions = TEXT.split("## Questions").nth(1).unwrap().split("\n## ").next().unwrap();
        assert_eq!(
            questions
                .lines()
                .filter(|line| line.starts_with("### ") && line.ends_with('?'))
                .count(),
            8
        );
    }
}
