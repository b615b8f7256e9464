//! Where the caret of a text field is: from the browser's count to AccessKit's.

use egui::Role;
use egui::accesskit::{NodeId, TextPosition};

use crate::page::Nodes;

/// The place before the character `index` of a text field, as AccessKit counts it: a run of text, and a place in it.
pub(crate) fn text_position(nodes: &Nodes, field: NodeId, mut index: usize) -> Option<TextPosition> {
    let runs = nodes.get(&field)?.children().iter().copied();
    let mut position = None;
    for run in runs {
        let node = nodes.get(&run).filter(|node| node.role() == Role::TextRun)?;
        let length = node.character_lengths().len();
        position = Some(TextPosition {
            node: run,
            character_index: index.min(length),
        });
        if index < length {
            break;
        }
        index -= length;
    }
    position
}

/// The number of characters in the first `units` units of UTF-16 of a text, which is what a browser counts in.
pub(crate) fn characters(text: &str, units: u32) -> usize {
    let mut left = usize::try_from(units).unwrap_or(usize::MAX);
    text.chars()
        .take_while(|c| {
            let fits = left > 0;
            left = left.saturating_sub(c.len_utf16());
            fits
        })
        .count()
}
