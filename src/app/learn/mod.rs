//! The Learn screen: the texts of `assets/learn.md`.

mod document;

use super::command::Command;
use super::context::AppContext;
use super::dialog::Dialog;
use super::navigation;
use super::theme;
use super::widgets::text;
use document::DOCUMENT;
use egui::Ui;

/// Draws the screen. A link to an example adds the command to follow it.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let mut followed = None;
    navigation::column_ui(ui, cx, "learn", |ui, cx| {
        ui.vertical_centered(|ui| {
            ui.set_max_width(ui.available_width().min(theme::TEXT_WIDTH + 2.0 * theme::GAP));
            ui.with_layout(egui::Layout::top_down(egui::Align::Min), |ui| {
                theme::card(theme::palette(ui)).show(ui, |ui| {
                    ui.set_width(ui.available_width());
                    followed = document::ui(ui, DOCUMENT, cx.layout.control_height());
                    let about = Command::ShowDialog(Some(Dialog::About));
                    if text::link_button_ui(ui, about.text(), cx.layout).clicked() {
                        cx.commands.push(about);
                    }
                });
                ui.add_space(cx.layout.gap());
            });
        });
    });
    cx.commands.extend(followed.map(|target| Command::Follow(target.to_owned())));
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::document::{Block, Span};
    use super::*;
    use depth_text::form::Inputs;
    use depth_text::link;

    const TEXT: &str = include_str!("../../../assets/learn.md");

    /// Everything that the blocks say, in order.
    fn words_of(blocks: &[Block], said: &mut String) {
        let say = |spans: &[Span], said: &mut String| {
            said.extend(spans.iter().map(|span| span.text));
            said.push('\n');
        };
        for block in blocks {
            match block {
                Block::Heading(_, title) => said.push_str(&format!("{title}\n")),
                Block::Paragraph(spans) => say(spans, said),
                Block::List { items, .. } => items.iter().for_each(|item| words_of(item, said)),
                Block::Quote(inside) => words_of(inside, said),
                Block::Formula(lines) => said.push_str(&format!("{}\n", lines.join("\n"))),
                Block::Table { header, rows } => {
                    let rows = std::iter::once(header).chain(rows.iter());
                    rows.flat_map(|row| row.iter()).for_each(|cell| say(cell, said));
                }
            }
        }
    }

    fn words(text: &str) -> Vec<&str> {
        text.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).collect()
    }

    #[test]
    fn the_screen_has_every_word_of_the_markdown_in_its_order() {
        let mut said = String::new();
        words_of(DOCUMENT, &mut said);
        let mut expected = String::new();
        for line in TEXT.lines().filter(|line| !line.starts_with("```")) {
            // Strip the Markdown syntax: the number of an item, the target of a link.
            let item = line.trim_start();
            let text = item.trim_start_matches(|c: char| c.is_ascii_digit());
            let mut rest = if text.starts_with(". ") { text } else { item };
            while let Some((before, link)) = rest.split_once("](") {
                expected.push_str(before);
                rest = link.split_once(')').unwrap().1;
            }
            expected.push_str(rest);
            expected.push('\n');
        }
        assert_eq!(words(&said), words(&expected));
    }

    #[test]
    fn the_blocks_are_of_the_kinds_that_the_markdown_has() {
        let count = |is: fn(&Block) -> bool| DOCUMENT.iter().filter(|block| is(block)).count();
        let lines = |starts: fn(&str) -> bool| TEXT.lines().filter(|line| starts(line)).count();
        assert_eq!(
            count(|block| matches!(block, Block::Heading(1, _))),
            lines(|line| line.starts_with("# "))
        );
        assert_eq!(
            count(|block| matches!(block, Block::Heading(2, _))),
            lines(|line| line.starts_with("## "))
        );
        assert_eq!(
            count(|block| matches!(block, Block::Heading(3, _))),
            lines(|line| line.starts_with("### "))
        );
        assert_eq!(count(|block| matches!(block, Block::Formula(_))), lines(|line| line == "```math"));
        assert_eq!(
            count(|block| matches!(block, Block::Table { .. })),
            lines(|line| line.starts_with("|--"))
        );
        assert!(count(|block| matches!(block, Block::Quote(_))) > 0);
        assert!(count(|block| matches!(block, Block::List { first: Some(1), .. })) > 0);
        assert!(count(|block| matches!(block, Block::List { first: None, .. })) > 0);
    }

    #[test]
    fn every_example_is_linked_and_its_link_loads_it() {
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
        let expected = [1.4, 4.275, 338.667, 739.138];
        assert_eq!(distances.len(), expected.len());
        for (distance, expected) in distances.iter().zip(expected) {
            assert!((distance - expected).abs() < 1e-3, "{distances:?}");
        }
    }

    #[test]
    fn every_topic_is_there() {
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
            10
        );
    }
}
