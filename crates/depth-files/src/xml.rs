//! XML as OpenCV writes it, and others with attributes, as a [`Node`].

use crate::node::{Node, Value};
use crate::place::Place;
use crate::refusal::Refusal;
use roxmltree::{Document, ParsingOptions};

/// No calibration nests deeper.
const DEEPEST: usize = 64;
/// Matrices are texts in XML: a file of hundreds of cameras has a tenth of it.
const MOST_NODES: u32 = 100_000;
/// OpenCV has one for each matrix.
const MOST_ATTRIBUTES: usize = 10_000;

/// What the document, the `file`th, holds below its first element. Also says what that is called.
pub(crate) fn document(text: &str, file: usize) -> Result<(String, Node), Refusal> {
    // No calibration has a document type, with which entities come that stand for more than memory holds.
    let options = ParsingOptions {
        allow_dtd: false,
        nodes_limit: MOST_NODES,
        ..ParsingOptions::default()
    };
    // The parser takes memory for all nodes and attributes before it counts them, and compares the attributes of an element with each other.
    let count = |sign: u8| text.bytes().filter(|byte| *byte == sign).count();
    let most = usize::try_from(MOST_NODES).unwrap_or(usize::MAX);
    if count(b'<') > 2 * most || count(b'=') > MOST_ATTRIBUTES {
        return Err(Refusal::TooMuch);
    }
    let document = Document::parse_with_options(text, options).map_err(|error| Refusal::Syntax {
        what: "XML",
        place: place(file, error.pos().row),
        reason: error.to_string(),
    })?;
    let root = document.root_element();
    let mut lines = Lines {
        text,
        file,
        at: 0,
        line: 1,
    };
    Ok((root.tag_name().name().to_owned(), lines.node(root, 0)?))
}

fn place(file: usize, row: u32) -> Place {
    Place {
        file,
        line: usize::try_from(row).unwrap_or(1),
    }
}

/// Counts lines on the way through a document.
struct Lines<'a> {
    text: &'a str,
    file: usize,
    at: usize,
    line: usize,
}

impl Lines<'_> {
    /// The line of a place that is not before the last one that was asked for.
    fn line(&mut self, at: usize) -> usize {
        let between = self.text.as_bytes().get(self.at..at).unwrap_or_default();
        self.line += between.iter().filter(|byte| **byte == b'\n').count();
        self.at = self.at.max(at);
        self.line
    }

    fn node(&mut self, element: roxmltree::Node<'_, '_>, depth: usize) -> Result<Node, Refusal> {
        if depth > DEEPEST {
            return Err(Refusal::TooDeep);
        }
        let place = Place {
            file: self.file,
            line: self.line(element.range().start),
        };
        // Those that OpenCV writes say nothing that is needed.
        let is_opencv = element.document().root_element().has_tag_name("opencv_storage");
        let attributes = element.attributes().filter(|_| !is_opencv).map(|one| {
            let value = Value::Text(one.value().to_owned());
            (one.name().to_owned(), Node { place, value })
        });
        let mut entries: Vec<(String, Node)> = attributes.collect();
        for child in element.children().filter(roxmltree::Node::is_element) {
            entries.push((child.tag_name().name().to_owned(), self.node(child, depth + 1)?));
        }
        let value = match entries.first() {
            None => Value::Text(element.text().unwrap_or_default().trim().to_owned()),
            // A sequence of OpenCV.
            Some(_) if entries.iter().all(|(name, _)| name == "_") => Value::List(entries.into_iter().map(|(_, node)| node).collect()),
            Some(_) => Value::Map(entries),
        };
        Ok(Node { place, value })
    }
}
