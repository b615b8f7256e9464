//! The AccessKit tree as text, for a test that compares it with what the browser tells assistive technology.

use egui::accesskit::{Affine, Node, NodeId, Toggled};

use crate::element::element_id;
use crate::page::Nodes;

/// Separates the nodes.
const RECORD: char = '\u{1e}';
/// Separates what is said of a node.
const UNIT: char = '\u{1f}';

/// Every node below `root`, in reading order, as egui says it: the `id` of its element, its role, label, value, description,
/// the elements that name it, its states, and its bounds (x0 y0 x1 y1) in CSS pixels on the canvas.
pub(crate) fn text(nodes: &Nodes, root: NodeId, pixels_per_point: f64) -> String {
    let mut text = String::new();
    write(nodes, root, Affine::scale(pixels_per_point), &mut text);
    text
}

fn write(nodes: &Nodes, id: NodeId, outer: Affine, text: &mut String) {
    let Some(node) = nodes.get(&id).filter(|node| !node.is_hidden()) else {
        return;
    };
    let transform = node.transform().map_or(outer, |own| outer * *own);
    let bounds = node.bounds().map(|bounds| transform.transform_rect_bbox(bounds));
    let labelled_by: Vec<String> = node.labelled_by().iter().map(|id| element_id(*id)).collect();
    let fields = [
        element_id(id),
        format!("{:?}", node.role()),
        node.label().unwrap_or_default().to_owned(),
        node.value().unwrap_or_default().to_owned(),
        node.description().unwrap_or_default().to_owned(),
        labelled_by.join(" "),
        states(node),
        bounds.map_or_else(String::new, |b| format!("{} {} {} {}", b.x0, b.y0, b.x1, b.y1)),
    ];
    for field in fields {
        text.push_str(&field);
        text.push(UNIT);
    }
    text.push(RECORD);
    for child in node.children() {
        write(nodes, *child, transform, text);
    }
}

fn states(node: &Node) -> String {
    let states = [
        ("disabled", node.is_disabled()),
        ("invalid", node.invalid().is_some()),
        ("on", node.toggled() == Some(Toggled::True)),
        ("off", node.toggled() == Some(Toggled::False)),
        ("selected", node.is_selected() == Some(true)),
    ];
    let on: Vec<&str> = states.iter().filter(|(_, on)| *on).map(|(name, _)| *name).collect();
    on.join(" ")
}
