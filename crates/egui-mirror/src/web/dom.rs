//! The page in the browser, and what it was made from.

use egui::accesskit::{self, Action, ActionData, NodeId, TextSelection, TreeUpdate};
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{Document, Element, HtmlCanvasElement, Node};

use super::agent::Agent;
use super::caret::selection;
use super::elements::Elements;
use super::host::{self, Host};
use super::options::Options;
use super::signals::{CARET_MOVED, FOCUSED, LEAVING, TOUCHED, VISITED, act, has_value_waiting, waiting_focus};
use crate::announce::{Announcement, announcements};
use crate::caret::text_position;
use crate::describe::Tree;
use crate::diff::{Edit, diff};
use crate::element::{self, element_id};
use crate::focus::{Destination, destination};
use crate::page::{Nodes, Page};

/// The page, and what it was made from.
pub(crate) struct Dom {
    ctx: egui::Context,
    document: Document,
    canvas: HtmlCanvasElement,
    agent: Option<Agent>,
    host: Host,
    elements: Elements,
    options: Options,
    nodes: Nodes,
    view: Option<View>,
    page: Page,
}

/// What the page depends on besides the nodes.
#[derive(Clone, Copy, PartialEq)]
struct View {
    focus: NodeId,
    /// Physical pixels in a CSS pixel.
    scale: f32,
    /// Is a modal dialog open?
    modal: bool,
    /// The size of the canvas, in points.
    size: egui::Vec2,
}

impl Dom {
    pub(crate) fn new(ctx: egui::Context, canvas: &HtmlCanvasElement, options: Options) -> Result<Self, JsValue> {
        let document = canvas.owner_document().ok_or("the canvas is in no document")?;
        let agent = Agent::find(canvas);
        let before: &Node = agent.as_ref().map_or(canvas, |agent| agent.element());
        let host = Host::new(&document, options.host.clone(), before)?;

        // The elements of the mirror are what Tab stops at, not the canvas as a whole.
        canvas.set_tab_index(-1);
        let defaults = [
            ("role", "group"),
            ("aria-label", &document.title()),
            ("aria-owns", &host.element().id()),
        ];
        for (name, value) in defaults {
            if !canvas.has_attribute(name) && !value.is_empty() {
                canvas.set_attribute(name, value)?;
            }
        }
        host.lay_over(canvas);
        Ok(Self {
            ctx,
            elements: Elements::new(document.clone(), host.content().clone()),
            document,
            canvas: canvas.clone(),
            agent,
            host,
            options,
            nodes: Nodes::new(),
            view: None,
            page: Page::default(),
        })
    }

    pub(crate) fn ctx(&self) -> &egui::Context {
        &self.ctx
    }

    pub(crate) fn document(&self) -> &Document {
        &self.document
    }

    pub(crate) fn canvas(&self) -> &HtmlCanvasElement {
        &self.canvas
    }

    pub(crate) fn host(&self) -> &Host {
        &self.host
    }

    pub(crate) fn page(&self) -> &Page {
        &self.page
    }

    /// Where egui's focus is, or will be when egui has had all that it was sent.
    pub(crate) fn coming_focus(&self) -> Option<NodeId> {
        waiting_focus().or_else(|| self.page.focus())
    }

    /// Is it the canvas, or what stands for it while text is edited?
    pub(crate) fn is_canvas(&self, element: &Element) -> bool {
        let canvas: &Element = &self.canvas;
        let is_agent = |agent: &Agent| element == agent.element().unchecked_ref::<Element>();
        element == canvas || self.agent.as_ref().is_some_and(is_agent)
    }

    /// Is it an element of the mirror?
    pub(crate) fn is_in_mirror(&self, element: &Element) -> bool {
        self.host.element().contains(Some(element))
    }

    /// Does the element lie where it cannot be seen on the canvas?
    pub(crate) fn is_out_of_sight(&self, id: NodeId) -> bool {
        self.elements.get(id).is_some_and(|element| self.host.hides(element))
    }

    /// The text that is selected, as what a search finds is in some browsers.
    pub(crate) fn selected(&self) -> Option<NodeId> {
        let selection = web_sys::window()?.get_selection().ok()??;
        let mut holder = selection.anchor_node().filter(|_| !selection.is_collapsed());
        while let Some(node) = holder {
            let id = node.dyn_ref::<Element>().and_then(|element| element::node_id(&element.id()));
            if id.is_some() {
                return id;
            }
            holder = node.parent_node();
        }
        None
    }

    /// The text in the middle of what the browser has scrolled to: there stands what it has found, where it does not say what that is.
    pub(crate) fn in_the_middle(&self) -> Option<NodeId> {
        let middle = |element: &Element| {
            let rect = element.get_bounding_client_rect();
            rect.top() + rect.height() / 2.0
        };
        let wanted = middle(self.host.element());
        let with_text = self.page.elements().iter().filter(|element| element.text.is_some());
        let places = with_text.filter_map(|element| Some((element.id, (middle(self.elements.get(element.id)?) - wanted).abs())));
        places.min_by(|(_, a), (_, b)| a.total_cmp(b)).map(|(id, _)| id)
    }

    /// Lays the mirror over the area that egui paints.
    pub(crate) fn lay_over_canvas(&self) {
        self.host.lay_over(&self.canvas);
    }

    /// Does what the application does with a click by itself. Returns whether it did.
    pub(crate) fn is_done_at_once(&self, id: NodeId) -> bool {
        self.nodes.get(&id).is_some_and(|node| (self.options.clicked)(node))
    }

    /// Is it a shortcut of the application?
    pub(crate) fn is_shortcut(&self, key: &str, modifiers: egui::Modifiers) -> bool {
        (self.options.is_shortcut)(key, modifiers)
    }

    /// Takes over what egui says now, and returns what is to be read aloud about it. If nothing has changed, the browser is not
    /// called at all.
    pub(crate) fn update(&mut self, update: TreeUpdate) -> Vec<Announcement> {
        let Some(root) = update.tree.as_ref().map(|tree| tree.root) else {
            return Vec::new();
        };
        let view = View {
            focus: update.focus,
            scale: self.ctx.native_pixels_per_point().unwrap_or(1.0),
            modal: self.ctx.memory(|memory| memory.top_modal_layer().is_some()),
            size: self.ctx.viewport_rect().size(),
        };
        let same_nodes = self.nodes.len() == update.nodes.len() && update.nodes.iter().all(|(id, node)| self.nodes.get(id) == Some(node));
        let mut news = Vec::new();
        if !same_nodes || self.view != Some(view) {
            if self.view.map(|view| (view.scale, view.size)) != Some((view.scale, view.size)) {
                self.lay_over_canvas();
            }
            self.view = Some(view);
            if !same_nodes {
                self.nodes = update.nodes.into_iter().collect();
            }
            let page = Page::describe(&Tree {
                nodes: &self.nodes,
                root,
                focus: view.focus,
                scale: 1.0 / f64::from(view.scale),
                modal: view.modal,
                input_mode: self.options.input_mode,
            });
            news = announcements(&self.page, &page);
            self.become_page(page);
        }
        self.settle_inputs();
        self.follow_caret();
        news
    }

    fn become_page(&mut self, page: Page) {
        let edits = diff(&self.page, &page);
        let moved = edits
            .iter()
            .any(|edit| matches!(edit, Edit::Remove(_) | Edit::Create(..) | Edit::Children(..)));
        // Taking the focused element away, or moving it, makes the browser forget.
        let held = FOCUSED.get().and_then(|id| self.page.get(id)).cloned();
        for edit in edits {
            // One element that the browser refuses must not take the rest of the page with it.
            let _ = self.elements.carry_out(edit);
        }
        let old = std::mem::replace(&mut self.page, page);
        self.say_what_is_active(&old);
        if let Some(held) = held {
            self.follow_focus(&old, &held, moved);
        }
        if let Some(agent) = &mut self.agent {
            let focused = self.page.focus().and_then(|id| self.page.get(id));
            agent.describe(focused.filter(|element| element.kind.is_text()));
        }
    }

    /// Where the application did not take what was typed, puts back what it has.
    fn settle_inputs(&self) {
        let (waiting, settled): (Vec<_>, Vec<_>) = TOUCHED.take().into_iter().partition(|id| has_value_waiting(*id));
        TOUCHED.set(waiting);
        for id in settled {
            if let Some(value) = self.page.get(id).and_then(|element| element.value.as_deref()) {
                self.elements.set_value(id, value);
            }
        }
    }

    /// Tells assistive technology which element has egui's focus while the canvas has the browser's.
    fn say_what_is_active(&self, old: &Page) {
        if let Some(id) = self.page.focus() {
            if Some(id) != old.focus() {
                LEAVING.set(false);
                let _ = self.canvas.set_attribute("aria-activedescendant", &element_id(id));
            }
        } else if old.focus().is_some() {
            let _ = self.canvas.remove_attribute("aria-activedescendant");
        }
    }

    /// Puts the browser's focus, which was on `held`, where it belongs now, and never leaves it nowhere.
    fn follow_focus(&self, old: &Page, held: &element::Element, moved: bool) {
        // The person is ahead of egui, which has yet to come to where they are.
        if waiting_focus() == Some(held.id) && self.page.can_take_focus(held.id) {
            if moved {
                self.focus_quietly(held.id);
            }
            return;
        }
        match destination(old, &self.page, held, &VISITED.with_borrow(Vec::clone)) {
            Destination::FollowEgui(id) => self.focus_quietly(id),
            Destination::LeadEgui(id) => {
                if moved || id != held.id {
                    self.focus_quietly(id);
                }
                if id != held.id {
                    act(&self.ctx, id, Action::Focus, None);
                }
            }
            Destination::Canvas => {
                FOCUSED.set(None);
                host::focus(&self.canvas);
            }
        }
    }

    /// Focuses an element without telling egui, which knows.
    pub(crate) fn focus_quietly(&self, id: NodeId) {
        self.elements.focus_quietly(id);
    }

    /// Focuses the first or last element without telling egui, for the browser to go on from, out of the mirror. (The empty
    /// places beyond them will not do: from there Firefox goes round.)
    pub(crate) fn focus_outermost(&self, last: bool) {
        let mut stops = self.page.tab_stops();
        match if last { stops.next_back() } else { stops.next() } {
            Some(id) => self.focus_quietly(id),
            None => self.host.focus_edge(last),
        }
    }

    /// Moves egui's caret and selection to where they are in the field that is being edited.
    fn follow_caret(&self) {
        if !CARET_MOVED.take() {
            return;
        }
        let Some(id) = FOCUSED.get().filter(|id| self.page.focus() == Some(*id)) else {
            return;
        };
        let Some((anchor, focus)) = self.elements.get(id).and_then(selection) else {
            return;
        };
        let position = |index| text_position(&self.nodes, id, index);
        let (Some(anchor), Some(focus)) = (position(anchor), position(focus)) else {
            return;
        };
        let wanted = TextSelection { anchor, focus };
        if self.nodes.get(&id).and_then(accesskit::Node::text_selection) != Some(&wanted) {
            act(&self.ctx, id, Action::SetTextSelection, Some(ActionData::SetTextSelection(wanted)));
        }
    }
}
