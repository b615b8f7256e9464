//! From an AccessKit tree to the page.

use std::collections::HashMap;

use egui::Role;
use egui::accesskit::{Affine, Node, NodeId, Rect};

use crate::element::{Element, InputMode, Lettering, Place, about_id, element_id};
use crate::page::{Nodes, Page};
use crate::roles::{self, Kind, Within};

/// An AccessKit tree, and what else the page depends on.
#[derive(Clone, Copy, Debug)]
pub struct Tree<'a> {
    /// The nodes by their ids.
    pub nodes: &'a Nodes,
    /// The node that contains all others.
    pub root: NodeId,
    /// The node that has the keyboard focus.
    pub focus: NodeId,
    /// The number of CSS pixels in one unit of the root's coordinates, after the root's own transform.
    pub scale: f64,
    /// Does the last dialog keep everything else from being used?
    pub modal: bool,
    /// The on-screen keyboard that the application wants for a text field.
    pub input_mode: InputMode,
}

impl Page {
    /// The page that stands for `tree`.
    #[must_use]
    pub fn describe(tree: &Tree<'_>) -> Self {
        let mut writer = Writer {
            nodes: tree.nodes,
            input_mode: tree.input_mode,
            rects: HashMap::new(),
            page: Self::default(),
        };
        writer.measure(tree.root, Affine::scale(tree.scale));
        writer.page.roots = writer.children(tree.root, Rect::ZERO, Within::Page);
        writer.link_elements();
        let mut page = writer.page;
        page.focus = page.get(tree.focus).map(|element| element.id);
        if tree.modal {
            page.shut_out_all_but_the_last_dialog();
        }
        page
    }

    fn shut_out_all_but_the_last_dialog(&mut self) {
        let is_dialog = |id: &&NodeId| self.get(**id).is_some_and(Element::is_dialog);
        let Some(dialog) = self.roots.iter().rev().find(is_dialog).copied() else {
            return;
        };
        let outside: Vec<NodeId> = self.roots.iter().copied().filter(|id| *id != dialog).collect();
        for id in outside {
            if let Some(element) = self.get_mut(id) {
                element.attributes.insert("inert", String::new());
            }
        }
        if let Some(element) = self.get_mut(dialog) {
            element.attributes.insert("aria-modal", "true".to_owned());
        }
    }
}

/// In CSS pixels: two lines of the smallest type are higher than this, and one of the largest is not.
const LINES_MIN_HEIGHT: f64 = 30.0;

struct Writer<'a> {
    nodes: &'a Nodes,
    input_mode: InputMode,
    /// Where each node lies on the canvas, in CSS pixels. A container without bounds is as large as what it contains.
    rects: HashMap<NodeId, Rect>,
    page: Page,
}

impl Writer<'_> {
    fn measure(&mut self, id: NodeId, outer: Affine) -> Option<Rect> {
        let node = self.nodes.get(&id)?;
        if node.is_hidden() || self.rects.contains_key(&id) {
            return None;
        }
        let transform = node.transform().map_or(outer, |own| outer * *own);
        let own = node
            .bounds()
            .map(|bounds| transform.transform_rect_bbox(bounds))
            .filter(is_drawable);
        self.rects.insert(id, own.unwrap_or(Rect::ZERO));
        let mut inside: Option<Rect> = None;
        for child in node.children() {
            if let Some(rect) = self.measure(*child, transform) {
                inside = Some(inside.map_or(rect, |union| union.union(rect)));
            }
        }
        let rect = own.or(inside)?;
        self.rects.insert(id, rect);
        Some(rect)
    }

    fn children(&mut self, id: NodeId, parent: Rect, within: Within) -> Vec<NodeId> {
        let Some(node) = self.nodes.get(&id) else { return Vec::new() };
        let mut elements = Vec::new();
        for child in node.children() {
            self.element(*child, parent, within, &mut elements);
        }
        elements
    }

    fn element(&mut self, id: NodeId, parent: Rect, within: Within, siblings: &mut Vec<NodeId>) {
        let Some(node) = self.nodes.get(&id) else { return };
        if node.is_hidden() || node.role() == Role::TextRun || self.page.get(id).is_some() {
            return;
        }
        let Some(shape) = roles::shape(node, within) else {
            siblings.extend(self.children(id, parent, within));
            return;
        };
        let rect = self.rects.get(&id).copied().unwrap_or(Rect::ZERO);
        let mut element = Element::new(id, node, shape, within, self.input_mode);
        element.place = place(rect, parent);
        if element.text.is_some() {
            element.lettering = self.lettering(node, rounded(rect));
        }
        self.page.push(element);
        siblings.push(id);

        if shape.kind == Kind::Other {
            let children = self.children(id, rounded(rect), inside(node));
            if let Some(element) = self.page.get_mut(id) {
                if !children.is_empty() && element.text.take().is_some() && !element.name.is_empty() {
                    element.attributes.insert("aria-label", element.name.clone());
                }
                element.children = children;
            }
        } else {
            // No control contains another one. What egui hangs below it, its menu for one, follows it.
            let before = self.page.elements().len();
            siblings.extend(self.children(id, parent, Within::Page));
            self.link_popup(id, before);
        }
    }

    /// How the text of `node`, which lies in `rect`, is painted: egui describes each line by a run of text. Where there is none, a heading
    /// or label that is too low for two lines is as large as its text.
    fn lettering(&self, node: &Node, rect: Rect) -> Option<Lettering> {
        let is_run = |id: &&NodeId| self.nodes.get(*id).is_some_and(|node| node.role() == Role::TextRun);
        let runs = || node.children().iter().filter(is_run).filter_map(|id| self.rects.get(id));
        let Some(first) = runs().next() else {
            let is_line = matches!(node.role(), Role::Heading | Role::Label) && rect.height() < LINES_MIN_HEIGHT;
            return is_line.then_some(Lettering {
                left: 0.0,
                top: 0.0,
                width: rect.width(),
                line: rect.height(),
                lines: 1,
            });
        };
        Some(Lettering {
            left: (first.x0 - rect.x0).round() + 0.0,
            top: (first.y0 - rect.y0).round() + 0.0,
            width: runs().map(Rect::width).sum::<f64>().round(),
            line: first.height().round(),
            lines: runs().count(),
        })
    }

    /// Tells a control about the list, menu or dialog that it has opened: the first of the elements from `first_below` on.
    fn link_popup(&mut self, owner: NodeId, first_below: usize) {
        let popup = self.page.elements().iter().skip(first_below).find_map(|element| {
            let role = element.role().filter(|role| matches!(*role, "listbox" | "menu" | "dialog"))?;
            Some((element.id, role.to_owned()))
        });
        let Some(owner) = self.page.get_mut(owner) else { return };
        let (owner_id, owner_name) = (owner.id, owner.name.clone());
        if let Some((id, role)) = popup {
            owner.attributes.insert("aria-expanded", "true".to_owned());
            owner.attributes.insert("aria-controls", element_id(id));
            owner.attributes.insert("aria-haspopup", role);
            if let Some(popup) = self.page.get_mut(id).filter(|popup| popup.name.is_empty()) {
                // Not by the owner as a whole where it can be helped: to a browser that would be the value that it shows.
                if owner_name.is_empty() {
                    popup.attributes.insert("aria-labelledby", element_id(owner_id));
                } else {
                    popup.attributes.insert("aria-label", owner_name);
                }
            }
        } else if owner.role() == Some("combobox") {
            owner.attributes.entry("aria-expanded").or_insert_with(|| "false".to_owned());
            owner.attributes.entry("aria-haspopup").or_insert_with(|| "listbox".to_owned());
        }
    }

    /// Sets the relations between elements, now that it is known which nodes became one.
    fn link_elements(&mut self) {
        let ids: Vec<NodeId> = self.page.elements().iter().map(|element| element.id).collect();
        for id in ids {
            let Some(node) = self.nodes.get(&id) else { continue };
            let mut links = self.links(node);
            if self.page.get(id).is_some_and(|element| element.kind.is_text()) {
                self.describe_in_words(id, node);
                links.retain(|(attribute, _)| *attribute != "aria-describedby");
            }
            let mut name = None;
            if node.label().is_none() && !node.labelled_by().is_empty() {
                let words: Vec<String> = node.labelled_by().iter().map(|id| self.page.words(*id)).collect();
                name = Some(words.join(" "));
            } else if let Some(heading) = self.heading_of_nameless_dialog(id) {
                links.push(("aria-labelledby", element_id(heading)));
                name = Some(self.page.words(heading));
            }
            if let Some(element) = self.page.get_mut(id) {
                element.attributes.extend(links);
                if element.has_about() {
                    let described = element.attributes.entry("aria-describedby").or_default();
                    let gap = if described.is_empty() { "" } else { " " };
                    *described = format!("{described}{gap}{}", about_id(id));
                }
                if let Some(name) = name {
                    element.name = name;
                }
                if element.kind.is_text() && element.has_about() && !element.name.is_empty() {
                    // For checkers that take a label which is scrolled out of sight for none; browsers go by the label.
                    element.attributes.insert("aria-label", element.name.clone());
                }
            }
        }
    }

    /// Describes a field by words of its own, instead of by the elements that describe it: what is wrong, then what is always so. The words
    /// can be kept as they are while somebody is in the field, whatever becomes of those elements.
    fn describe_in_words(&mut self, id: NodeId, node: &Node) {
        let wrong: Vec<String> = node.described_by().iter().map(|id| self.page.words(*id)).collect();
        for about in node.described_by() {
            if let Some(element) = self.page.get_mut(*about) {
                element.describes = Some(id);
            }
        }
        let Some(element) = self.page.get_mut(id) else { return };
        let all: Vec<String> = wrong
            .into_iter()
            .chain(element.description.take())
            .filter(|words| !words.is_empty())
            .collect();
        element.description = (!all.is_empty()).then(|| all.join(" "));
    }

    /// The attributes that lead from a node to other elements. What became no element is left out.
    fn links(&self, node: &Node) -> Vec<(&'static str, String)> {
        let relations: [(&'static str, &[NodeId]); 6] = [
            ("aria-labelledby", if node.label().is_none() { node.labelled_by() } else { &[] }),
            ("aria-describedby", node.described_by()),
            ("aria-controls", node.controls()),
            ("aria-details", node.details()),
            ("aria-flowto", node.flow_to()),
            ("aria-owns", node.owns()),
        ];
        let mut links: Vec<(&'static str, String)> = Vec::new();
        for (attribute, targets) in relations {
            let present: Vec<String> = targets
                .iter()
                .filter(|id| self.page.get(**id).is_some())
                .map(|id| element_id(*id))
                .collect();
            if !present.is_empty() {
                links.push((attribute, present.join(" ")));
            }
        }
        if let Some(error) = node.error_message().filter(|id| self.page.get(*id).is_some()) {
            links.push(("aria-errormessage", element_id(error)));
        }
        links
    }

    fn heading_of_nameless_dialog(&self, id: NodeId) -> Option<NodeId> {
        let dialog = self.page.get(id)?;
        if !dialog.is_dialog() || !dialog.name.is_empty() {
            return None;
        }
        let mut headings = self
            .page
            .elements()
            .iter()
            .filter(|element| matches!(element.tag, "h1" | "h2" | "h3" | "h4" | "h5" | "h6"));
        headings
            .find(|heading| self.page.contains(id, heading.id))
            .map(|heading| heading.id)
    }
}

/// What the role of a node makes of the nodes below it.
fn inside(node: &Node) -> Within {
    match node.role() {
        Role::ListBox => Within::ListBox,
        Role::Menu | Role::MenuListPopup => Within::Menu,
        _ => Within::Page,
    }
}

fn is_drawable(rect: &Rect) -> bool {
    [rect.x0, rect.y0, rect.x1, rect.y1].iter().all(|edge| edge.abs() < 1.0e7)
}

/// Whole pixels: an element does not move for less.
fn rounded(rect: Rect) -> Rect {
    Rect::new(rect.x0.round(), rect.y0.round(), rect.x1.round(), rect.y1.round())
}

fn place(rect: Rect, parent: Rect) -> Place {
    let rect = rounded(rect);
    Place {
        // Not minus zero, which is written in another way.
        left: rect.x0 - parent.x0 + 0.0,
        top: rect.y0 - parent.y0 + 0.0,
        // An element without size is not there for a browser.
        width: rect.width().max(1.0),
        height: rect.height().max(1.0),
    }
}
