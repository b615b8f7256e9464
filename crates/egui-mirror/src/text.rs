//! The page as text, for tests and bug reports.

use std::fmt::{self, Write as _};

use egui::accesskit::{NodeId, Toggled};

use crate::element::Place;
use crate::page::Page;

/// One line per element: depth, element, attributes, value, state, text and place. The browser's side writes the same.
impl fmt::Display for Page {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fn write(page: &Page, id: NodeId, depth: usize, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            let Some(element) = page.get(id) else { return Ok(()) };
            let attributes = element.attributes.iter().map(|(name, value)| (*name, value.as_str()));
            let is_password = element.attributes.get("type").is_some_and(|kind| kind == "password");
            let line = line(
                depth,
                element.tag,
                attributes,
                element.text.as_deref().unwrap_or_default(),
                element.value.as_deref().filter(|_| !is_password),
                element.checked,
                element.place,
            );
            f.write_str(&line)?;
            element.children.iter().try_for_each(|child| write(page, *child, depth + 1, f))
        }
        self.roots.iter().try_for_each(|root| write(self, *root, 0, f))
    }
}

/// One line of the page as text.
pub(crate) fn line<'a>(
    depth: usize,
    tag: &str,
    attributes: impl Iterator<Item = (&'a str, &'a str)>,
    text: &str,
    value: Option<&str>,
    checked: Option<Toggled>,
    place: Place,
) -> String {
    let mut line = format!("{:1$}{tag}", "", depth * 2);
    for (name, value) in attributes {
        let _ = write!(line, " {name}={value:?}");
    }
    if let Some(value) = value {
        let _ = write!(line, " value: {value:?}");
    }
    if let Some(checked) = checked {
        let _ = write!(line, " checked: {checked:?}");
    }
    if !text.is_empty() {
        let _ = write!(line, " text: {text:?}");
    }
    if place != Place::default() {
        let Place { left, top, width, height } = place;
        let _ = write!(line, " at: {left} {top} {width} {height}");
    }
    line.push('\n');
    line
}
