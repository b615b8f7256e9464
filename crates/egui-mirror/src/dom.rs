//! The page in the browser.

use std::collections::HashMap;
use std::rc::Rc;

use egui::accesskit::{self, Action, ActionData, NodeId, TextSelection, Toggled, TreeUpdate};
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{Document, Element, FocusOptions, HtmlCanvasElement, HtmlElement, HtmlInputElement, HtmlTextAreaElement, Node};

use crate::announcer::Announcer;
use crate::diff::{self, Edit};
use crate::events::{SIGNALS, act};
use crate::model::{self, InputMode, Nodes, Page, element_id};
use crate::plugin::Options;
use crate::pointer::Gate;

/// Over the canvas, where assistive technology looks for what is under a finger; `pointer` says who gets the pointer all the
/// same, and what touches mean is for the canvas to say as well. The opacity is not zero, because what has none counts as not
/// displayed to WebDriver; a thousandth is less than half a step of an 8-bit colour, so nothing of it reaches the screen.
/// `visibility` and `display` would take the page from the accessibility tree as well, and a page clipped to nothing or moved
/// aside would not say where on the screen its elements are.
const HOST_STYLE: &str = "position:absolute;margin:0;padding:0;border:0;overflow:clip;contain:strict;touch-action:none;\
    opacity:0.001;font:16px sans-serif;color:#808080;background:none";

/// Every element lies where it is painted. The size of the text keeps phones from zooming in on a field.
const ELEMENT_STYLE: &str = "position:absolute;box-sizing:border-box;margin:0;padding:0;border:0;min-width:0;min-height:0;\
    white-space:nowrap;font:inherit;appearance:none";

/// The page, and what it was made from.
pub(crate) struct Dom {
    ctx: egui::Context,
    canvas: HtmlCanvasElement,
    /// eframe's hidden text field, which has the browser's focus while text is edited on the canvas.
    agent: Option<HtmlElement>,
    host: HtmlElement,
    content: HtmlElement,
    /// Empty places before and after the content: Tab goes on from there.
    edges: [HtmlElement; 2],
    announcer: Announcer,
    gate: Gate,
    document: Document,
    input_mode: InputMode,
    clicked: Rc<dyn Fn(&accesskit::Node) -> bool>,
    elements: HashMap<NodeId, HtmlElement>,
    nodes: Nodes,
    root: NodeId,
    page: Page,
    /// What the page depends on besides the nodes: focus, size of a point, whether a modal is open, size of the canvas.
    circumstances: Option<(NodeId, f32, bool, egui::Vec2)>,
    agent_says: [Option<String>; 4],
    made_host: bool,
}

impl Dom {
    pub(crate) fn new(ctx: egui::Context, canvas: &HtmlCanvasElement, options: Options) -> Result<Self, JsValue> {
        let document = canvas.owner_document().ok_or("the canvas is in no document")?;
        let parent = canvas.parent_node().ok_or("the canvas is in no document")?;
        let agent = canvas
            .next_element_sibling()
            .and_then(|next| next.dyn_into::<HtmlInputElement>().ok());
        let make = |tag: &str| -> Result<HtmlElement, JsValue> { Ok(document.create_element(tag)?.dyn_into()?) };

        let made_host = options.host.is_none();
        let host = match options.host {
            Some(host) => host,
            None => {
                let host = make("div")?;
                host.set_id("accessible-mirror");
                let after: &Node = agent.as_ref().map_or(canvas, |agent| agent);
                parent.insert_before(&host, after.next_sibling().as_ref())?;
                host
            }
        };
        host.style().set_css_text(HOST_STYLE);
        let content = make("div")?;
        let edges = [make("span")?, make("span")?];
        for edge in &edges {
            edge.set_tab_index(-1);
        }
        for part in [&edges[0], &content, &edges[1]] {
            host.append_child(part)?;
        }
        let announcer = Announcer::new(&document, &host)?;
        let gate = Gate::new(&host);

        // The elements of the mirror are what Tab stops at, not the canvas as a whole.
        canvas.set_tab_index(-1);
        let defaults = [("role", "group"), ("aria-label", &document.title()), ("aria-owns", &host.id())];
        for (name, value) in defaults {
            if !canvas.has_attribute(name) && !value.is_empty() {
                canvas.set_attribute(name, value)?;
            }
        }
        if let Some(agent) = &agent {
            agent.set_tab_index(-1);
        }
        let dom = Self {
            ctx,
            canvas: canvas.clone(),
            agent: agent.map(Into::into),
            host,
            content,
            edges,
            announcer,
            gate,
            document,
            input_mode: options.input_mode,
            clicked: options.clicked,
            elements: HashMap::new(),
            nodes: Nodes::new(),
            root: NodeId(0),
            page: Page::default(),
            circumstances: None,
            agent_says: [const { None }; 4],
            made_host,
        };
        dom.lay_over_canvas();
        Ok(dom)
    }

    pub(crate) fn ctx(&self) -> &egui::Context {
        &self.ctx
    }

    pub(crate) fn page(&self) -> &Page {
        &self.page
    }

    pub(crate) fn canvas(&self) -> &HtmlCanvasElement {
        &self.canvas
    }

    pub(crate) fn gate(&self) -> &Gate {
        &self.gate
    }

    pub(crate) fn host(&self) -> &HtmlElement {
        &self.host
    }

    pub(crate) fn document(&self) -> &Document {
        &self.document
    }

    /// Does what the application does with a click by itself. Returns whether it did.
    pub(crate) fn is_done_at_once(&self, id: NodeId) -> bool {
        self.nodes.get(&id).is_some_and(|node| (self.clicked)(node))
    }

    pub(crate) fn announcer(&self) -> &Announcer {
        &self.announcer
    }

    /// Is it the canvas, or what stands for it while text is edited?
    pub(crate) fn is_canvas(&self, element: &Element) -> bool {
        let canvas: &Element = &self.canvas;
        element == canvas || self.agent.as_ref().is_some_and(|agent| element == agent.unchecked_ref::<Element>())
    }

    /// Takes over what egui says now. If nothing has changed, the browser is not called at all.
    pub(crate) fn update(&mut self, update: TreeUpdate) {
        let Some(root) = update.tree.as_ref().map(|tree| tree.root) else {
            return;
        };
        let scale = self.ctx.native_pixels_per_point().unwrap_or(1.0);
        let modal = self.ctx.memory(|memory| memory.top_modal_layer().is_some());
        let size = self.ctx.viewport_rect().size();
        let circumstances = Some((update.focus, scale, modal, size));
        let same_nodes = self.nodes.len() == update.nodes.len() && update.nodes.iter().all(|(id, node)| self.nodes.get(id) == Some(node));
        if !same_nodes || self.circumstances != circumstances {
            if self.circumstances.map(|(_, scale, _, size)| (scale, size)) != Some((scale, size)) {
                self.lay_over_canvas();
            }
            self.circumstances = circumstances;
            self.root = root;
            if !same_nodes {
                self.nodes = update.nodes.into_iter().collect();
            }
            let page = Page::describe(&self.nodes, root, update.focus, 1.0 / f64::from(scale), modal, self.input_mode);
            self.become_page(page);
        }
        self.settle_inputs();
        self.follow_caret();
    }

    fn become_page(&mut self, page: Page) {
        let edits = diff::diff(&self.page, &page);
        let moved = edits
            .iter()
            .any(|edit| matches!(edit, Edit::Remove(_) | Edit::Create(..) | Edit::Children(..)));
        // Taking the focused element away, or moving it, makes the browser forget.
        let held = SIGNALS.with(|signals| signals.focused.get());
        let held = held.and_then(|id| self.page.get(id)).cloned();
        for edit in edits {
            // One element that the browser refuses must not take the rest of the page with it.
            let _ = self.carry_out(edit);
        }
        self.announcer.announce(diff::announcements(&self.page, &page));
        let focus_before = self.page.focus;
        self.page = page;
        self.follow_focus(focus_before, held.as_ref(), moved);
        self.describe_agent();
    }

    fn carry_out(&mut self, edit: Edit) -> Result<(), JsValue> {
        match edit {
            Edit::Remove(id) => {
                if let Some(element) = self.elements.remove(&id) {
                    element.remove();
                }
            }
            Edit::Create(id, tag) => {
                let element: HtmlElement = self.document.create_element(tag)?.dyn_into()?;
                element.set_id(&element_id(id));
                element.style().set_css_text(ELEMENT_STYLE);
                self.elements.insert(id, element);
            }
            Edit::Attribute(id, name, value) => {
                let Some(element) = self.elements.get(&id) else { return Ok(()) };
                match value {
                    Some(value) => element.set_attribute(name, &value)?,
                    None => element.remove_attribute(name)?,
                }
            }
            Edit::Text(id, text) => {
                let Some(element) = self.elements.get(&id) else { return Ok(()) };
                element.set_text_content(Some(&text));
            }
            Edit::Value(id, value) => self.set_value(id, &value),
            Edit::Checked(id, checked) => self.set_checked(id, checked),
            Edit::Place(id, place) => {
                let Some(element) = self.elements.get(&id) else { return Ok(()) };
                let style = element.style();
                style.set_property("left", &format!("{}px", place.left))?;
                style.set_property("top", &format!("{}px", place.top))?;
                style.set_property("width", &format!("{}px", place.width))?;
                style.set_property("height", &format!("{}px", place.height))?;
            }
            Edit::Children(parent, children) => {
                let parent: &Node = match parent {
                    Some(id) => match self.elements.get(&id) {
                        Some(element) => element,
                        None => return Ok(()),
                    },
                    None => &self.content,
                };
                let mut next = parent.first_child();
                for child in children.iter().filter_map(|id| self.elements.get(id)) {
                    let child: &Node = child;
                    if next.as_ref() == Some(child) {
                        next = child.next_sibling();
                    } else {
                        parent.insert_before(child, next.as_ref())?;
                    }
                }
            }
        }
        Ok(())
    }

    fn set_value(&self, id: NodeId, value: &str) {
        // Writing into a field in the middle of a composition would end it.
        if SIGNALS.with(|signals| signals.composing.get()) == Some(id) {
            return;
        }
        let Some(element) = self.elements.get(&id) else { return };
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
        if let Some(input) = self.elements.get(&id).and_then(|element| element.dyn_ref::<HtmlInputElement>()) {
            input.set_indeterminate(checked == Toggled::Mixed);
            input.set_checked(checked == Toggled::True);
        }
    }

    /// Where the application did not take what was typed, puts back what it has.
    fn settle_inputs(&self) {
        let touched = SIGNALS.with(|signals| signals.touched.take());
        for id in touched {
            if let Some(value) = self.page.get(id).and_then(|element| element.value.clone()) {
                self.set_value(id, &value);
            }
        }
    }

    /// Puts the browser's focus where egui's went, if it was in the mirror (`held`), and never leaves it nowhere.
    fn follow_focus(&self, before: Option<NodeId>, held: Option<&model::Element>, moved: bool) {
        let now = self.page.focus;
        if let Some(id) = now {
            if now != before {
                SIGNALS.with(|signals| signals.leaving.set(false));
                let _ = self.canvas.set_attribute("aria-activedescendant", &element_id(id));
            }
        } else if before.is_some() {
            let _ = self.canvas.remove_attribute("aria-activedescendant");
        }
        let Some(held) = held else { return };
        if let Some(id) = now.filter(|id| now != before && *id != held.id && self.page.can_take_focus(*id)) {
            self.focus_quietly(id);
        } else if let Some(id) = self.page.heir(held).or_else(|| self.way_back()) {
            if moved || id != held.id {
                self.focus_quietly(id);
            }
            if id != held.id {
                act(&self.ctx, id, Action::Focus, None);
            }
        } else {
            SIGNALS.with(|signals| signals.focused.set(None));
            focus(&self.canvas);
        }
    }

    /// Where the person goes when what had the focus is gone: back to where they were, or into the dialog that is open.
    fn way_back(&self) -> Option<NodeId> {
        let visited = SIGNALS.with(|signals| signals.visited.borrow().clone());
        let back = visited.iter().rev().copied().find(|id| self.page.can_take_focus(*id));
        back.or_else(|| self.page.first_stop_in_dialog())
    }

    /// Focuses an element without telling egui, which knows.
    pub(crate) fn focus_quietly(&self, id: NodeId) {
        let Some(element) = self.elements.get(&id) else { return };
        if self.document.active_element().as_deref() == Some(element.unchecked_ref::<Element>()) {
            return;
        }
        SIGNALS.with(|signals| signals.quiet.set(true));
        focus(element);
        SIGNALS.with(|signals| signals.quiet.set(false));
    }

    /// Focuses the first or last element without telling egui, for the browser to go on from, out of the mirror. (The empty
    /// places beyond them will not do: from there Firefox goes round.)
    pub(crate) fn focus_outermost(&self, last: bool) {
        let mut stops = self.page.stops();
        match if last { stops.next_back() } else { stops.next() } {
            Some(id) => self.focus_quietly(id),
            None => self.focus_edge(last),
        }
    }

    /// Focuses the empty place before or after all elements, for the browser to go on from, into the mirror.
    pub(crate) fn focus_edge(&self, after: bool) {
        let [first, last] = &self.edges;
        focus(if after { last } else { first });
    }

    /// Tells phones and screen readers what is edited in eframe's text field.
    fn describe_agent(&mut self) {
        let Some(agent) = &self.agent else { return };
        let field = self
            .page
            .focus
            .and_then(|id| self.page.get(id))
            .filter(|element| element.kind.is_text());
        let attribute = |name: &str| field.and_then(|field| field.attributes.get(name).cloned());
        let says = [
            field.map(|field| field.name.clone()).filter(|name| !name.is_empty()),
            attribute("inputmode"),
            attribute("role"),
            // Without a field to edit it is a receiver of keys, which has nothing to say.
            field.is_none().then(|| "true".to_owned()),
        ];
        for ((name, value), said) in ["aria-label", "inputmode", "role", "aria-hidden"]
            .iter()
            .zip(&says)
            .zip(&self.agent_says)
        {
            if value != said {
                let _ = match value {
                    Some(value) => agent.set_attribute(name, value),
                    None => agent.remove_attribute(name),
                };
            }
        }
        self.agent_says = says;
    }

    /// Moves egui's caret and selection to where they are in the field that is being edited.
    fn follow_caret(&self) {
        if !SIGNALS.with(|signals| signals.caret_moved.take()) {
            return;
        }
        let Some(id) = SIGNALS
            .with(|signals| signals.focused.get())
            .filter(|id| self.page.focus == Some(*id))
        else {
            return;
        };
        let Some((anchor, focus)) = self.elements.get(&id).and_then(selection) else {
            return;
        };
        let (Some(anchor), Some(focus)) = (
            model::text_position(&self.nodes, id, anchor),
            model::text_position(&self.nodes, id, focus),
        ) else {
            return;
        };
        let wanted = TextSelection { anchor, focus };
        if self.nodes.get(&id).and_then(accesskit::Node::text_selection) != Some(&wanted) {
            act(&self.ctx, id, Action::SetTextSelection, Some(ActionData::SetTextSelection(wanted)));
        }
    }

    /// Lays the host over the area that egui paints.
    pub(crate) fn lay_over_canvas(&self) {
        let padding = |side: &str| {
            let style = web_sys::window().and_then(|window| window.get_computed_style(&self.canvas).ok()?);
            let text = style.and_then(|style| style.get_property_value(side).ok()).unwrap_or_default();
            text.trim_end_matches("px").parse::<f64>().unwrap_or(0.0)
        };
        let (left, right) = (padding("padding-left"), padding("padding-right"));
        let (top, bottom) = (padding("padding-top"), padding("padding-bottom"));
        let canvas = &self.canvas;
        let sides = [
            ("left", f64::from(canvas.offset_left() + canvas.client_left()) + left),
            ("top", f64::from(canvas.offset_top() + canvas.client_top()) + top),
            ("width", f64::from(canvas.client_width()) - left - right),
            ("height", f64::from(canvas.client_height()) - top - bottom),
        ];
        for (side, pixels) in sides {
            let _ = self.host.style().set_property(side, &format!("{pixels}px"));
        }
    }

    /// Does the element lie where it cannot be seen on the canvas?
    pub(crate) fn is_out_of_sight(&self, id: NodeId) -> bool {
        let Some(element) = self.elements.get(&id) else { return false };
        let (element, host) = (element.get_bounding_client_rect(), self.host.get_bounding_client_rect());
        element.top() < host.top() || element.bottom() > host.bottom() || element.left() < host.left() || element.right() > host.right()
    }

    /// The AccessKit tree that the page was made from, as [`crate::tree::text`] writes it.
    pub(crate) fn tree(&self) -> String {
        let scale = self.circumstances.map_or(1.0, |(_, scale, _, _)| scale);
        crate::tree::text(&self.nodes, self.root, 1.0 / f64::from(scale))
    }

    /// The page as text, from what the browser holds.
    pub(crate) fn read_back(&self) -> String {
        let mut text = String::new();
        read(&self.content, 0, &mut text);
        text
    }
}

impl Drop for Dom {
    fn drop(&mut self) {
        if self.made_host {
            self.host.remove();
        } else {
            self.host.set_text_content(None);
        }
    }
}

fn focus(element: &HtmlElement) {
    let options = FocusOptions::new();
    options.set_prevent_scroll(true);
    let _ = element.focus_with_options(&options);
}

/// The selection in a field: where it began and where it ends, in characters.
fn selection(element: &HtmlElement) -> Option<(usize, usize)> {
    let (text, start, end, direction) = if let Some(input) = element.dyn_ref::<HtmlInputElement>() {
        (
            input.value(),
            input.selection_start().ok()??,
            input.selection_end().ok()??,
            input.selection_direction().ok()?,
        )
    } else {
        let area = element.dyn_ref::<HtmlTextAreaElement>()?;
        (
            area.value(),
            area.selection_start().ok()??,
            area.selection_end().ok()??,
            area.selection_direction().ok()?,
        )
    };
    // The browser counts in units of UTF-16.
    let characters = |units: u32| {
        let mut left = usize::try_from(units).unwrap_or(usize::MAX);
        text.chars()
            .take_while(|c| {
                let fits = left > 0;
                left = left.saturating_sub(c.len_utf16());
                fits
            })
            .count()
    };
    let (start, end) = (characters(start), characters(end));
    Some(if direction.as_deref() == Some("backward") {
        (end, start)
    } else {
        (start, end)
    })
}

/// Where an element was put.
fn place(element: &Element) -> model::Place {
    let style = element.dyn_ref::<HtmlElement>().map(HtmlElement::style);
    let pixels = |side: &str| {
        let text = style.as_ref().and_then(|style| style.get_property_value(side).ok());
        text.and_then(|text| text.trim_end_matches("px").parse().ok()).unwrap_or_default()
    };
    model::Place {
        left: pixels("left"),
        top: pixels("top"),
        width: pixels("width"),
        height: pixels("height"),
    }
}

fn read(parent: &Element, depth: usize, text: &mut String) {
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
        text.push_str(&model::line(
            depth,
            &element.tag_name().to_ascii_lowercase(),
            attributes.iter().map(|(name, value)| (name.as_str(), value.as_str())),
            &inside,
            value.as_deref(),
            checked,
            place(&element),
        ));
        read(&element, depth + 1, text);
    }
}
