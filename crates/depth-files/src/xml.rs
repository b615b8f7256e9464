//! XML as OpenCV writes it, and others with attributes, as a [`Node`].

use crate::node::{Node, Value};
use crate::place::Place;
use crate::refusal::Refusal;
use roxmltree::{Document, ParsingOptions};

/// What the document, the `file`th, holds below its first element. Also says what that is called.
pub(crate) fn document(text: &str, file: usize) -> Result<(String, Node), Refusal> {
    // No calibration has a document type, with which entities come that stand for more than memory holds.
    let options = ParsingOptions {
        allow_dtd: false,
        nodes_limit: 100_000,
        ..ParsingOptions::default()
    };
    let document = Document::parse_with_options(text, options).map_err(|error| Refusal::Syntax {
        what: "XML",
        place: place(file, error.pos().row),
        reason: error.to_string(),
    })?;
    let root = document.root_element();
    Ok((root.tag_name().name().to_owned(), node(root, file)))
}

fn place(file: usize, row: u32) -> Place {
    Place {
        file,
        line: usize::try_from(row).unwrap_or(1),
    }
}

fn node(element: roxmltree::Node<'_, '_>, file: usize) -> Node {
    let line = element.document().text_pos_at(element.range().start).row;
    let children = element.children().filter(roxmltree::Node::is_element);
    let place = place(file, line);
    // Those that OpenCV writes say nothing that is needed.
    let is_opencv = element.document().root_element().has_tag_name("opencv_storage");
    let attributes = element.attributes().filter(|_| !is_opencv).map(|one| {
        let value = Value::Text(one.value().to_owned());
        (one.name().to_owned(), Node { place, value })
    });
    let children = children.map(|child| (child.tag_name().name().to_owned(), node(child, file)));
    let entries: Vec<(String, Node)> = attributes.chain(children).collect();
    let value = match entries.first() {
        None => Value::Text(element.text().unwrap_or_default().trim().to_owned()),
        // A sequence of OpenCV.
        Some(_) if entries.iter().all(|(name, _)| name == "_") => Value::List(entries.into_iter().map(|(_, node)| node).collect()),
        Some(_) => Value::Map(entries),
    };
    Node { place, value }
}
