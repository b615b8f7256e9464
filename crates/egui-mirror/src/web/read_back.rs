//! The page as text, from what the browser holds.

use egui::accesskit::Toggled;
use wasm_bindgen::JsCast as _;
use web_sys::{Element, HtmlElement, HtmlInputElement, HtmlTextAreaElement};

use crate::element::Place;
use crate::text;

/// Where an element was put.
fn place(element: &Element) -> Place {
    let style = element.dyn_ref::<HtmlElement>().map(HtmlElement::style);
    let pixels = |side: &str| {
        let text = style.as_ref().and_then(|style| style.get_property_value(side).ok());
        text.and_then(|text| text.trim_end_matches("px").parse().ok()).unwrap_or_default()
    };
    Place {
        left: pixels("left"),
        top: pixels("top"),
        width: pixels("width"),
        height: pixels("height"),
    }
}

pub(crate) fn read(parent: &Element, depth: usize, out: &mut String) {
    let children = parent.children();
    for element in (0..children.length()).filter_map(|index| children.item(index)) {
        let mut attributes: Vec<(String, String)> = element
            .get_attribute_names()
            .iter()
            .filter_map(|name| name.as_string())
            .filter(|name| name != "id" && name != "style")
            .map(|name| {
                let value = element.get_attribute(&name).unwrap_or_default();
                (name, value)
            })
            .collect();
        attributes.sort();
        let input = element.dyn_ref::<HtmlInputElement>();
        let is_box = input.is_some_and(|input| matches!(input.type_().as_str(), "checkbox" | "radio"));
        let checked = input
            .filter(|_| is_box)
            .map(|input| match (input.indeterminate(), input.checked()) {
                (true, _) => Toggled::Mixed,
                (_, true) => Toggled::True,
                (_, false) => Toggled::False,
            });
        let value = match input {
            Some(_) if is_box => None,
            Some(input) => Some(input.value()).filter(|_| input.type_() != "password"),
            None => element.dyn_ref::<HtmlTextAreaElement>().map(HtmlTextAreaElement::value),
        };
        let is_leaf = element.child_element_count() == 0;
        let inside = element.text_content().filter(|_| is_leaf).unwrap_or_default();
        out.push_str(&text::line(
            depth,
            &element.tag_name().to_ascii_lowercase(),
            attributes.iter().map(|(name, value)| (name.as_str(), value.as_str())),
            &inside,
            value.as_deref(),
            checked,
            place(&element),
        ));
        read(&element, depth + 1, out);
    }
}
