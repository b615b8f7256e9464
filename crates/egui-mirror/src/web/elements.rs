//! The elements of the page in the browser.

use std::collections::HashMap;

use egui::accesskit::{NodeId, Toggled};
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{Document, Element, HtmlElement, HtmlInputElement, HtmlTextAreaElement, Node};

use super::host;
use super::lettering::Measure;
use super::signals::{COMPOSING, QUIET, has_value_waiting};
use crate::diff::{Edit, in_order};
use crate::element::{Place, about_id, element_id, node_id};

/// Every element lies where it is painted. The size of the text keeps phones from zooming in on a field.
const STYLE: &str = "position:absolute;box-sizing:border-box;margin:0;padding:0;border:0;min-width:0;min-height:0;\
    white-space:nowrap;font:inherit;appearance:none;background:none;outline:none;color:inherit;text-decoration:none;list-style:none";
/// What a person types into shows its own caret and selection, which egui paints already. Not zero: see the style of the host.
const UNSEEN: &str = ";opacity:0.001";

/// The elements by their nodes.
pub(crate) struct Elements {
    document: Document,
    /// What contains them all.
    content: HtmlElement,
    by_node: HashMap<NodeId, HtmlElement>,
    /// What contains the descriptions, which are referred to, and read nowhere else.
    abouts: HtmlElement,
    about: HashMap<NodeId, Element>,
    measure: Option<Measure>,
}

impl Elements {
    pub(crate) fn new(document: Document, content: HtmlElement, abouts: HtmlElement) -> Self {
        Self {
            measure: Measure::new(&document),
            document,
            content,
            by_node: HashMap::new(),
            abouts,
            about: HashMap::new(),
        }
    }

    pub(crate) fn get(&self, id: NodeId) -> Option<&HtmlElement> {
        self.by_node.get(&id)
    }

    /// Makes one change.
    pub(crate) fn carry_out(&mut self, edit: Edit) -> Result<(), JsValue> {
        match edit {
            Edit::Remove(id) => {
                if let Some(element) = self.by_node.remove(&id) {
                    element.remove();
                }
                self.set_about(id, None)?;
            }
            Edit::About(id, words) => self.set_about(id, words)?,
            Edit::Create(id, tag) => {
                let element: HtmlElement = self.document.create_element(tag)?.dyn_into()?;
                element.set_id(&element_id(id));
                let is_typed_into = matches!(tag, "input" | "textarea");
                element
                    .style()
                    .set_css_text(&[STYLE, if is_typed_into { UNSEEN } else { "" }].concat());
                self.by_node.insert(id, element);
            }
            Edit::Attribute(id, name, value) => {
                let Some(element) = self.get(id) else { return Ok(()) };
                match value {
                    Some(value) => element.set_attribute(name, &value)?,
                    None => element.remove_attribute(name)?,
                }
            }
            Edit::Text(id, text) => {
                let Some(element) = self.get(id) else { return Ok(()) };
                element.set_text_content(Some(&text));
            }
            Edit::Value(id, value) => self.set_value(id, &value),
            Edit::Checked(id, checked) => self.set_checked(id, checked),
            Edit::Place(id, place) => self.set_place(id, place)?,
            Edit::Lettering(id, lettering) => {
                if let (Some(element), Some(measure)) = (self.get(id), &self.measure) {
                    measure.fit(element, lettering)?;
                }
            }
            Edit::Children(parent, children) => self.set_children(parent, &children)?,
        }
        Ok(())
    }

    /// Sets what the page says about an element.
    fn set_about(&mut self, id: NodeId, words: Option<String>) -> Result<(), JsValue> {
        let Some(words) = words else {
            if let Some(about) = self.about.remove(&id) {
                about.remove();
            }
            return Ok(());
        };
        let about = match self.about.get(&id) {
            Some(about) => about.clone(),
            None => {
                let about = self.document.create_element("span")?;
                about.set_id(&about_id(id));
                self.abouts.append_child(&about)?;
                self.about.insert(id, about.clone());
                about
            }
        };
        about.set_text_content(Some(&words));
        Ok(())
    }

    /// Replaces the content of an input, unless it is that already.
    pub(crate) fn set_value(&self, id: NodeId, value: &str) {
        // Writing into a field in the middle of a composition would end it. And what a person has typed that egui has yet to hear of
        // must not be replaced by what egui had before.
        if COMPOSING.get() == Some(id) || has_value_waiting(id) {
            return;
        }
        let Some(element) = self.get(id) else { return };
        if let Some(input) = element.dyn_ref::<HtmlInputElement>() {
            if input.value() != value {
                input.set_value(value);
            }
        } else if let Some(area) = element.dyn_ref::<HtmlTextAreaElement>()
            && area.value() != value
        {
            area.set_value(value);
        }
    }

    fn set_checked(&self, id: NodeId, checked: Toggled) {
        if let Some(input) = self.get(id).and_then(|element| element.dyn_ref::<HtmlInputElement>()) {
            input.set_indeterminate(checked == Toggled::Mixed);
            input.set_checked(checked == Toggled::True);
        }
    }

    fn set_place(&self, id: NodeId, place: Place) -> Result<(), JsValue> {
        let Some(element) = self.get(id) else { return Ok(()) };
        let style = element.style();
        let Place { left, top, width, height } = place;
        for (side, pixels) in [("left", left), ("top", top), ("width", width), ("height", height)] {
            style.set_property(side, &format!("{pixels}px"))?;
        }
        Ok(())
    }

    /// Puts the children into an element, or into the page itself, and moves as few as possible of those that are there: the browser
    /// takes the focus and the selection from what is moved.
    fn set_children(&self, parent: Option<NodeId>, children: &[NodeId]) -> Result<(), JsValue> {
        let parent: &Node = match parent {
            Some(id) => match self.get(id) {
                Some(element) => element,
                None => return Ok(()),
            },
            None => &self.content,
        };
        let mut places: HashMap<NodeId, usize> = HashMap::new();
        let mut there = parent.first_child();
        while let Some(child) = there {
            if let Some(id) = child.dyn_ref::<Element>().and_then(|element| node_id(&element.id())) {
                places.insert(id, places.len());
            }
            there = child.next_sibling();
        }
        let before: Vec<Option<usize>> = children.iter().map(|id| places.get(id).copied()).collect();
        let mut next: Option<&Node> = None;
        for (id, stays) in children.iter().zip(in_order(&before)).rev() {
            let Some(child) = self.get(*id) else { continue };
            if !stays {
                parent.insert_before(child, next)?;
            }
            next = Some(child);
        }
        Ok(())
    }

    /// Focuses an element without telling egui, which knows.
    pub(crate) fn focus_quietly(&self, id: NodeId) {
        let Some(element) = self.get(id) else { return };
        if self.document.active_element().as_deref() == Some(element.unchecked_ref::<Element>()) {
            return;
        }
        QUIET.set(true);
        host::focus(element);
        QUIET.set(false);
    }
}
