//! The page in the browser, and what it was made from.

use egui::accesskit::{self, Action, ActionData, NodeId, TextSelection, TreeUpdate};
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{Document, Element, HtmlCanvasElement, Node};

use super::agent::Agent;
use super::caret::selection;
use super::elements::Elements;
use super::host::{self, Host};
use super::options::Options;
use super::signals::{ARRIVED, CARET_MOVED, FOCUSED, TOUCHED, TYPING, VISITED, act, has_value_waiting, waiting_focus};
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
    root: NodeId,
    page: Page,
    /// The elements of which something is kept as it was, because of the focus.
    held: Vec<NodeId>,
    /// The element that assistive technology is told of while the canvas has the focus.
    active: Option<NodeId>,
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
        let defaults = [("role", "group"), ("aria-label", &document.title())];
        for (name, value) in defaults {
            if !canvas.has_attribute(name) && !value.is_empty() {
                canvas.set_attribute(name, value)?;
            }
        }
        host.lay_over(canvas);
        Ok(Self {
            ctx,
            elements: Elements::new(document.clone(), host.content().clone(), host.abouts().clone()),
            document,
            canvas: canvas.clone(),
            agent,
            host,
            options,
            nodes: Nodes::new(),
            view: None,
            root: NodeId(0),
            page: Page::default(),
            held: Vec::new(),
            active: None,
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
        let is_let_go = self.held.iter().any(|id| FOCUSED.get() != Some(*id));
        if !same_nodes || self.view != Some(view) || is_let_go {
            if self.view.map(|view| (view.scale, view.size)) != Some((view.scale, view.size)) {
                self.lay_over_canvas();
            }
            self.view = Some(view);
            if !same_nodes {
                self.nodes = update.nodes.into_iter().collect();
            }
            self.root = root;
            news = self.describe();
        }
        ARRIVED.set(None);
        self.say_what_is_active();
        self.settle_inputs();
        self.follow_caret();
        news
    }

    /// The person has stopped typing: now what they have typed may be called wrong. Returns what is to be read aloud.
    pub(crate) fn typing_paused(&mut self) -> Vec<Announcement> {
        TYPING.set(None);
        if self.held.is_empty() { Vec::new() } else { self.describe() }
    }

    /// Makes the page what the nodes say, and returns what is to be read aloud about it.
    fn describe(&mut self) -> Vec<Announcement> {
        let Some(view) = self.view else { return Vec::new() };
        let mut page = Page::describe(&Tree {
            nodes: &self.nodes,
            root: self.root,
            focus: view.focus,
            scale: 1.0 / f64::from(view.scale),
            modal: view.modal,
            input_mode: self.options.input_mode,
        });
        let comes_to = page.focus().filter(|id| self.page.focus() != Some(*id));
        let mut held: Vec<NodeId> = FOCUSED.get().into_iter().chain(comes_to).collect();
        held.retain(|id| page.keep_description(&self.page, *id, TYPING.get() == Some(*id)));
        self.held = held;
        let news = announcements(&self.page, &page);
        self.become_page(page);
        news
    }

    fn become_page(&mut self, page: Page) {
        let edits = diff(&self.page, &page);
        let moved = edits
            .iter()
            .any(|edit| matches!(edit, Edit::Remove(_) | Edit::Create(..) | Edit::Children(..)));
        // Taking the focused element away, or moving it, makes the browser forget.
        let held = FOCUSED.get().and_then(|id| self.page.get(id)).cloned();
        // What has the focus is shut out or removed only when the focus has gone: else the browser would take it nowhere, and say so.
        let (last, first): (Vec<Edit>, Vec<Edit>) = edits.into_iter().partition(|edit| match edit {
            Edit::Attribute(_, "inert", Some(_)) => true,
            Edit::Remove(id) => page.get(*id).is_none(),
            _ => false,
        });
        for edit in first {
            // One element that the browser refuses must not take the rest of the page with it.
            let _ = self.elements.carry_out(edit);
        }
        let old = std::mem::replace(&mut self.page, page);
        match held {
            Some(held) => self.follow_focus(&old, &held, moved),
            None if old.elements().is_empty() => self.begin(),
            None => (),
        }
        for edit in last {
            let _ = self.elements.carry_out(edit);
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

    /// Where nothing else in the document has the focus, puts it on the element that egui has focused, else on the first: the canvas
    /// says nothing.
    fn begin(&self) {
        let active = self.document.active_element();
        let is_nowhere = active.is_none_or(|active| active.tag_name() == "BODY" || self.is_canvas(&active));
        let first = self.page.focus().filter(|id| self.page.can_take_focus(*id));
        if let Some(id) = first.or_else(|| self.page.tab_stops().next()).filter(|_| is_nowhere) {
            self.focus_quietly(id);
        }
    }

    /// Tells assistive technology which element has egui's focus while the canvas has the browser's.
    fn say_what_is_active(&mut self) {
        let has_focus = self.document.active_element().is_some_and(|active| self.is_canvas(&active));
        let active = self.page.focus().filter(|_| has_focus);
        if active == self.active {
            return;
        }
        self.active = active;
        let values = active.map(|id| [element_id(id), self.host.element().id()]);
        for (index, name) in ["aria-activedescendant", "aria-owns"].into_iter().enumerate() {
            let _ = match values.as_ref().and_then(|values| values.get(index)) {
                Some(value) => self.canvas.set_attribute(name, value),
                None => self.canvas.remove_attribute(name),
            };
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
