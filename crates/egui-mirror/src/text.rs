//! The page as text, for tests and bug reports.

use std::fmt;

use egui::accesskit::NodeId;

use crate::element::{Element, Place};
use crate::page::Page;

/// One line per element, indented by its depth: element, attributes, value, state, text and place.
impl fmt::Display for Page {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.roots().iter().try_for_each(|root| write(self, *root, 0, f))
    }
}

fn write(page: &Page, id: NodeId, depth: usize, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let Some(element) = page.get(id) else { return Ok(()) };
    write!(f, "{:1$}", "", depth * 2)?;
    write_line(element, f)?;
    element.children.iter().try_for_each(|child| write(page, *child, depth + 1, f))
}

fn write_line(element: &Element, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    f.write_str(element.tag)?;
    for (name, value) in &element.attributes {
        write!(f, " {name}={value:?}")?;
    }
    if let Some(value) = &element.value {
        write!(f, " value: {value:?}")?;
    }
    if let Some(checked) = element.checked {
        write!(f, " checked: {checked:?}")?;
    }
    if let Some(text) = &element.text {
        write!(f, " text: {text:?}")?;
    }
    let Place { left, top, width, height } = element.place;
    writeln!(f, " at: {left} {top} {width} {height}")
}
