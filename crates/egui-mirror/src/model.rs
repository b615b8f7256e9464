//! The accessible page that an AccessKit tree describes: pure data, without a browser.

use std::collections::{BTreeMap, HashMap};
use std::fmt::Write as _;

use egui::Role;
use egui::accesskit::{
    Action, Affine, AriaCurrent, AutoComplete, HasPopup, Invalid, Live, Node, NodeId, Orientation, Rect, SortDirection, TextPosition,
    Toggled,
};

use crate::roles::{self, Kind, Shape, Within};

/// The nodes of one AccessKit tree.
pub(crate) type Nodes = HashMap<NodeId, Node>;

/// What the author of an application may decide.
pub(crate) type InputMode = fn(&Node) -> Option<&'static str>;

/// Where an element lies, in CSS pixels, relative to the element around it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Place {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

/// What the application lets a person do with an element.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Allowed {
    pub(crate) focus: bool,
    pub(crate) click: bool,
    pub(crate) step: bool,
    pub(crate) set_value: bool,
}

/// One HTML element.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Element {
    pub(crate) id: NodeId,
    pub(crate) tag: &'static str,
    pub(crate) kind: Kind,
    pub(crate) allowed: Allowed,
    /// The accessible name in words, wherever it comes from.
    pub(crate) name: String,
    pub(crate) attributes: BTreeMap<&'static str, String>,
    /// The text inside an element that has no children.
    pub(crate) text: Option<String>,
    /// What stands in an input: a property, not an attribute.
    pub(crate) value: Option<String>,
    /// The state of a box or radio button: a property, not an attribute.
    pub(crate) checked: Option<Toggled>,
    pub(crate) place: Place,
    /// What the application wants to be said aloud when it appears or changes.
    pub(crate) live: Option<Live>,
    pub(crate) children: Vec<NodeId>,
}

/// All elements, in reading order.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Page {
    pub(crate) elements: Vec<Element>,
    pub(crate) roots: Vec<NodeId>,
    /// The element that has egui's keyboard focus.
    pub(crate) focus: Option<NodeId>,
    index: HashMap<NodeId, usize>,
}

impl Page {
    /// Describes the tree below `root`.
    ///
    /// `pixels_per_point` is the number of CSS pixels in one unit of the root's coordinates after its own transform.
    /// `modal` says that the last dialog keeps everything else from being used.
    pub(crate) fn describe(nodes: &Nodes, root: NodeId, focus: NodeId, pixels_per_point: f64, modal: bool, input_mode: InputMode) -> Self {
        let mut writer = Writer {
            nodes,
            input_mode,
            rects: HashMap::new(),
            page: Self::default(),
        };
        writer.measure(root, Affine::scale(pixels_per_point));
        writer.page.roots = writer.children(root, Rect::ZERO, Within::Page);
        writer.link_names();
        let mut page = writer.page;
        page.focus = page.get(focus).map(|element| element.id);
        if modal {
            page.shut_out_all_but_the_last_dialog();
        }
        page
    }

    pub(crate) fn get(&self, id: NodeId) -> Option<&Element> {
        self.elements.get(*self.index.get(&id)?)
    }

    fn get_mut(&mut self, id: NodeId) -> Option<&mut Element> {
        self.elements.get_mut(*self.index.get(&id)?)
    }

    /// Is something open that Escape would close: a menu, a list of options, a dialog?
    pub(crate) fn has_popup(&self) -> bool {
        self.elements.iter().any(|element| {
            matches!(
                element.attributes.get("role").map(String::as_str),
                Some("listbox" | "menu" | "dialog" | "alertdialog")
            )
        })
    }

    /// All words of an element and of what lies inside it.
    pub(crate) fn words(&self, id: NodeId) -> String {
        let Some(element) = self.get(id) else { return String::new() };
        let own = element.text.as_deref().unwrap_or(&element.name);
        let mut words = own.to_owned();
        for child in &element.children {
            let inner = self.words(*child);
            if !words.is_empty() && !inner.is_empty() {
                words.push(' ');
            }
            words.push_str(&inner);
        }
        words
    }

    /// Does the element lie inside the other one, or is it the same?
    pub(crate) fn contains(&self, outer: NodeId, id: NodeId) -> bool {
        outer == id
            || self
                .get(outer)
                .is_some_and(|outer| outer.children.iter().any(|child| self.contains(*child, id)))
    }

    /// Is the element there, and not behind a dialog?
    pub(crate) fn can_be_reached(&self, id: NodeId) -> bool {
        let mut roots = self.roots.iter().copied();
        roots.any(|root| self.contains(root, id) && self.get(root).is_some_and(|root| !root.attributes.contains_key("inert")))
    }

    /// Can the browser's focus be put on it?
    pub(crate) fn can_take_focus(&self, id: NodeId) -> bool {
        self.get(id).is_some_and(|element| element.attributes.contains_key("tabindex")) && self.can_be_reached(id)
    }

    /// What is now what `before` was: the element with its name, or else the one with its node. egui numbers most widgets
    /// by their position, so when something appears above them, they can get another number and theirs another widget.
    pub(crate) fn heir(&self, before: &Element) -> Option<NodeId> {
        let is_it = |element: &&Element| {
            element.tag == before.tag && element.name == before.name && !before.name.is_empty() && self.can_take_focus(element.id)
        };
        let same_node = self.get(before.id);
        let heir = same_node.filter(is_it).or_else(|| self.elements.iter().find(is_it));
        let is_same_kind = |element: &&Element| element.tag == before.tag && self.can_take_focus(element.id);
        heir.or_else(|| same_node.filter(is_same_kind)).map(|element| element.id)
    }

    /// The first stop of the Tab key inside the dialog that keeps everything else from being used.
    pub(crate) fn first_stop_in_dialog(&self) -> Option<NodeId> {
        let mut elements = self.elements.iter();
        let dialog = elements.find(|element| element.attributes.contains_key("aria-modal"))?;
        self.stops().find(|stop| self.contains(dialog.id, *stop))
    }

    /// What Tab stops at, in its order.
    pub(crate) fn stops(&self) -> impl DoubleEndedIterator<Item = NodeId> {
        let is_stop = |element: &&Element| element.attributes.get("tabindex").is_some_and(|index| index == "0");
        let stops = self.elements.iter().filter(is_stop).map(|element| element.id);
        stops.filter(|id| self.can_be_reached(*id))
    }

    fn shut_out_all_but_the_last_dialog(&mut self) {
        let is_dialog = |id: &NodeId| {
            self.get(*id)
                .and_then(|element| element.attributes.get("role"))
                .is_some_and(|role| role.contains("dialog"))
        };
        let Some(dialog) = self.roots.iter().rev().find(|id| is_dialog(id)).copied() else {
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

/// One line per element: depth, element, attributes, value, state, text and place. The browser's side writes the same.
impl std::fmt::Display for Page {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        fn write(page: &Page, id: NodeId, depth: usize, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
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

/// The place before the character `index` of a text field, as AccessKit counts it: a run of text, and a place in it.
pub(crate) fn text_position(nodes: &Nodes, field: NodeId, mut index: usize) -> Option<TextPosition> {
    let runs = nodes.get(&field)?.children().iter().copied();
    let mut position = None;
    for run in runs {
        let node = nodes.get(&run).filter(|node| node.role() == Role::TextRun)?;
        let length = node.character_lengths().len();
        position = Some(TextPosition {
            node: run,
            character_index: index.min(length),
        });
        if index < length {
            break;
        }
        index -= length;
    }
    position
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

/// The `id` of the element that stands for a node.
pub(crate) fn element_id(id: NodeId) -> String {
    format!("mirror-{:x}", id.0)
}

/// The node of an element's `id`.
pub(crate) fn node_id(element_id: &str) -> Option<NodeId> {
    u64::from_str_radix(element_id.strip_prefix("mirror-")?, 16).ok().map(NodeId)
}

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

    fn children(&mut self, id: NodeId, around: Rect, within: Within) -> Vec<NodeId> {
        let Some(node) = self.nodes.get(&id) else { return Vec::new() };
        let mut elements = Vec::new();
        for child in node.children() {
            self.element(*child, around, within, &mut elements);
        }
        elements
    }

    fn element(&mut self, id: NodeId, around: Rect, within: Within, siblings: &mut Vec<NodeId>) {
        let Some(node) = self.nodes.get(&id) else { return };
        if node.is_hidden() || node.role() == Role::TextRun || self.page.index.contains_key(&id) {
            return;
        }
        let Some(shape) = roles::shape(node, within) else {
            siblings.extend(self.children(id, around, within));
            return;
        };
        let rect = self.rects.get(&id).copied().unwrap_or(Rect::ZERO);
        let index = self.page.elements.len();
        self.page.index.insert(id, index);
        self.page
            .elements
            .push(describe(id, node, shape, within, self.input_mode, place(rect, around)));
        siblings.push(id);

        if shape.kind == Kind::Other {
            let within = match node.role() {
                Role::ListBox => Within::ListBox,
                Role::Menu | Role::MenuListPopup => Within::Menu,
                _ => Within::Page,
            };
            let children = self.children(id, rounded(rect), within);
            if let Some(element) = self.page.elements.get_mut(index) {
                if !children.is_empty() && element.text.take().is_some() && !element.name.is_empty() {
                    element.attributes.insert("aria-label", element.name.clone());
                }
                element.children = children;
            }
        } else {
            // No control contains another one. What egui hangs below it, its menu for one, follows it.
            siblings.extend(self.children(id, around, Within::Page));
            self.link_popup(index);
        }
    }

    /// Tells a control about the list, menu or dialog that it has opened and that was described right after it.
    fn link_popup(&mut self, owner: usize) {
        let mut after = self.page.elements.iter().skip(owner + 1);
        let popup = after.find_map(|element| {
            let role = element
                .attributes
                .get("role")
                .filter(|role| matches!(role.as_str(), "listbox" | "menu" | "dialog"));
            Some((element.id, role?.clone()))
        });
        let Some(owner) = self.page.elements.get_mut(owner) else { return };
        let is_combo_box = owner.attributes.get("role").is_some_and(|role| role == "combobox");
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
        } else if is_combo_box {
            owner.attributes.entry("aria-expanded").or_insert_with(|| "false".to_owned());
            owner.attributes.entry("aria-haspopup").or_insert_with(|| "listbox".to_owned());
        }
    }

    /// Sets the relations between elements, now that it is known which nodes became one.
    fn link_names(&mut self) {
        for index in 0..self.page.elements.len() {
            let Some(id) = self.page.elements.get(index).map(|element| element.id) else {
                continue;
            };
            let Some(node) = self.nodes.get(&id) else { continue };
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
            let mut name = None;
            if node.label().is_none() && !node.labelled_by().is_empty() {
                let words: Vec<String> = node.labelled_by().iter().map(|id| self.page.words(*id)).collect();
                name = Some(words.join(" "));
            } else if let Some(heading) = self.heading_of_nameless_dialog(id) {
                links.push(("aria-labelledby", element_id(heading)));
                name = Some(self.page.words(heading));
            }
            if let Some(element) = self.page.elements.get_mut(index) {
                element.attributes.extend(links);
                if let Some(name) = name {
                    element.name = name;
                }
            }
        }
    }

    fn heading_of_nameless_dialog(&self, id: NodeId) -> Option<NodeId> {
        let dialog = self.page.get(id)?;
        let is_dialog = dialog.attributes.get("role").is_some_and(|role| role.contains("dialog"));
        if !is_dialog || !dialog.name.is_empty() {
            return None;
        }
        let is_heading = |element: &&Element| matches!(element.tag, "h1" | "h2" | "h3" | "h4" | "h5" | "h6");
        let mut headings = self.page.elements.iter().filter(is_heading);
        headings
            .find(|heading| self.page.contains(id, heading.id))
            .map(|heading| heading.id)
    }
}

fn is_drawable(rect: &Rect) -> bool {
    [rect.x0, rect.y0, rect.x1, rect.y1].iter().all(|edge| edge.abs() < 1.0e7)
}

/// Whole pixels: an element does not move for less.
fn rounded(rect: Rect) -> Rect {
    Rect::new(rect.x0.round(), rect.y0.round(), rect.x1.round(), rect.y1.round())
}

fn place(rect: Rect, around: Rect) -> Place {
    let rect = rounded(rect);
    Place {
        // Not minus zero, which is written in another way.
        left: rect.x0 - around.x0 + 0.0,
        top: rect.y0 - around.y0 + 0.0,
        // An element without size is not there for a browser.
        width: rect.width().max(1.0),
        height: rect.height().max(1.0),
    }
}

fn describe(id: NodeId, node: &Node, shape: Shape, within: Within, input_mode: InputMode, place: Place) -> Element {
    let value = node.value().unwrap_or_default();
    let is_value_its_name = shape.named_by_content && node.label().is_none();
    let name = node.label().unwrap_or(if is_value_its_name { value } else { "" }).to_owned();
    let disabled = node.is_disabled();
    let allowed = Allowed {
        focus: node.supports_action(Action::Focus),
        click: node.supports_action(Action::Click) && !disabled,
        step: node.supports_action(Action::Increment) || node.supports_action(Action::Decrement),
        set_value: node.supports_action(Action::SetValue) && !disabled && !node.is_read_only(),
    };
    let mut attributes = Attributes::default();
    attributes.set("type", shape.input_type);
    attributes.set("role", shape.role);
    if !shape.named_by_content {
        attributes.set("aria-label", Some(name.as_str()).filter(|name| !name.is_empty()));
    }
    attributes.set("aria-description", node.description().filter(|words| *words != name));
    attributes.set("tabindex", tab_index(shape.kind, allowed, disabled));
    states(&mut attributes, node, shape, within);
    if shape.kind.is_text() {
        let mode = input_mode(node).or_else(|| roles::input_mode(node.role()));
        attributes.set("inputmode", mode);
        attributes.set("placeholder", node.placeholder().filter(|hint| !hint.is_empty()));
        attributes.set("autocomplete", Some("off"));
        attributes.set("spellcheck", Some("false"));
        if disabled || node.is_read_only() {
            attributes.set("readonly", Some(""));
        }
    }
    numbers(&mut attributes, node, shape.kind);

    let text = match shape.kind {
        Kind::Other if shape.named_by_content => Some(name.clone()),
        Kind::Button => Some(if shape.named_by_content { name.clone() } else { value.to_owned() }),
        _ => None,
    };
    Element {
        id,
        tag: shape.tag,
        kind: shape.kind,
        allowed,
        attributes: attributes.0,
        text: text.filter(|text| !text.is_empty()),
        value: match shape.kind {
            // egui tells only how long a password is. What is typed stays where it is typed, until egui clears it.
            Kind::Line if node.role() == Role::PasswordInput => value.is_empty().then(String::new),
            Kind::Line | Kind::Lines => Some(value.to_owned()),
            Kind::Stepper => Some(bare_number(value).to_owned()),
            Kind::Range => node.numeric_value().map(|number| number.to_string()),
            _ => None,
        },
        checked: (shape.kind == Kind::Check).then(|| node.toggled().unwrap_or(Toggled::False)),
        name,
        place,
        live: node.live(),
        children: Vec::new(),
    }
}

/// In the Tab order is what egui has in its own. Something disabled keeps its place in the page and in the reading
/// order and does not lose the focus it has (`aria-disabled`, not `disabled`), but Tab passes it by.
fn tab_index(kind: Kind, allowed: Allowed, disabled: bool) -> Option<&'static str> {
    match (kind, allowed.focus && !disabled) {
        (Kind::Other, true) => Some("0"),
        (Kind::Other, false) if allowed.focus => Some("-1"),
        (Kind::Other, false) => None,
        // Safari leaves buttons and boxes out of the Tab order unless they ask.
        (_, true) => Some("0"),
        (_, false) => Some("-1"),
    }
}

#[derive(Default)]
struct Attributes(BTreeMap<&'static str, String>);

impl Attributes {
    fn set(&mut self, name: &'static str, value: Option<impl Into<String>>) {
        if let Some(value) = value {
            self.0.insert(name, value.into());
        }
    }

    fn flag(&mut self, name: &'static str, on: bool) {
        self.set(name, on.then_some("true"));
    }

    fn number(&mut self, name: &'static str, number: Option<impl ToString>) {
        self.set(name, number.map(|number| number.to_string()));
    }
}

fn states(attributes: &mut Attributes, node: &Node, shape: Shape, within: Within) {
    attributes.flag("aria-disabled", node.is_disabled());
    attributes.flag("aria-required", node.is_required());
    attributes.flag("aria-readonly", node.is_read_only() && !shape.kind.is_text());
    attributes.flag("aria-busy", node.is_busy());
    attributes.flag("aria-modal", node.is_modal());
    attributes.flag("aria-multiselectable", node.is_multiselectable());
    attributes.flag("aria-atomic", node.is_live_atomic());
    // What is live otherwise is said by the announcer.
    attributes.set("aria-live", node.live().filter(|live| *live == Live::Off).map(|_| "off"));
    attributes.set("aria-expanded", node.is_expanded().map(|expanded| expanded.to_string()));
    attributes.set("aria-invalid", node.invalid().map(invalid));
    attributes.set("aria-orientation", node.orientation().map(orientation));
    attributes.set("aria-haspopup", node.has_popup().map(has_popup));
    attributes.set("aria-sort", node.sort_direction().map(sort));
    attributes.set("aria-current", node.aria_current().map(current));
    attributes.set("aria-autocomplete", node.auto_complete().map(auto_complete));
    attributes.set("aria-keyshortcuts", node.keyboard_shortcut());
    attributes.set("aria-roledescription", node.role_description());
    attributes.set("lang", node.language());
    attributes.set("href", node.url().filter(|_| shape.tag == "a"));
    attributes.number("aria-setsize", node.size_of_set());
    attributes.number("aria-posinset", node.position_in_set());
    attributes.number("aria-rowcount", node.row_count());
    attributes.number("aria-colcount", node.column_count());
    attributes.number("aria-rowindex", node.row_index());
    attributes.number("aria-colindex", node.column_index());
    attributes.number("rowspan", node.row_span());
    attributes.number("colspan", node.column_span());
    match node.role() {
        Role::ColumnHeader => attributes.set("scope", Some("col")),
        Role::RowHeader => attributes.set("scope", Some("row")),
        Role::Heading => attributes.number("aria-level", node.level().filter(|level| *level > 6)),
        _ => attributes.number("aria-level", node.level()),
    }

    let on = node.toggled();
    match (shape.role, shape.kind) {
        (_, Kind::Check) => (),
        (Some("menuitemcheckbox" | "menuitemradio"), _) => attributes.set("aria-checked", on.map(toggled)),
        (Some("option" | "tab" | "row" | "treeitem" | "gridcell"), _) => {
            let chosen = node.is_selected().or_else(|| on.map(|on| on == Toggled::True));
            attributes.set("aria-selected", chosen.map(|chosen| chosen.to_string()));
        }
        // A menu item that egui draws as a button can be on or off.
        (Some("menuitem"), _) if within == Within::Menu && on.is_some() => {
            attributes.set("role", Some("menuitemcheckbox"));
            attributes.set("aria-checked", on.map(toggled));
        }
        (_, Kind::Button) => attributes.set("aria-pressed", on.map(toggled)),
        _ => attributes.set("aria-selected", node.is_selected().map(|chosen| chosen.to_string())),
    }
}

fn numbers(attributes: &mut Attributes, node: &Node, kind: Kind) {
    let (min, max, now) = (node.min_numeric_value(), node.max_numeric_value(), node.numeric_value());
    if kind == Kind::Range {
        attributes.number("min", min);
        attributes.number("max", max);
        // Without it only whole numbers could be shown.
        attributes.set("step", Some("any"));
    } else if !kind.is_text() || kind == Kind::Stepper {
        attributes.number("aria-valuemin", min);
        attributes.number("aria-valuemax", max);
        attributes.number("aria-valuenow", now);
    } else {
        return;
    }
    if now.is_some() {
        attributes.set("aria-valuetext", node.value());
    }
}

/// The number in a text such as "1400 px", so that it can be edited without its unit: the longest run of characters
/// that a number is made of, or the whole text if that run is no number.
pub(crate) fn bare_number(text: &str) -> &str {
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '.' | ',' | '-' | '−' | '+' | 'e' | 'E');
    let longest = text.split(|c: char| !is_part(c)).max_by_key(|run| run.len()).unwrap_or(text);
    if number(longest).is_some() { longest } else { text }
}

/// A number as people write it: with a point or a comma, with a hyphen or a minus sign.
pub(crate) fn number(text: &str) -> Option<f64> {
    text.trim()
        .replace(',', ".")
        .replace('−', "-")
        .parse::<f64>()
        .ok()
        .filter(|number| number.is_finite())
}

fn invalid(invalid: Invalid) -> &'static str {
    match invalid {
        Invalid::True => "true",
        Invalid::Grammar => "grammar",
        Invalid::Spelling => "spelling",
    }
}

fn orientation(orientation: Orientation) -> &'static str {
    match orientation {
        Orientation::Horizontal => "horizontal",
        Orientation::Vertical => "vertical",
    }
}

fn has_popup(popup: HasPopup) -> &'static str {
    match popup {
        HasPopup::Menu => "menu",
        HasPopup::Listbox => "listbox",
        HasPopup::Tree => "tree",
        HasPopup::Grid => "grid",
        HasPopup::Dialog => "dialog",
    }
}

fn sort(direction: SortDirection) -> &'static str {
    match direction {
        SortDirection::Ascending => "ascending",
        SortDirection::Descending => "descending",
        SortDirection::Other => "other",
    }
}

fn current(current: AriaCurrent) -> &'static str {
    match current {
        AriaCurrent::False => "false",
        AriaCurrent::True => "true",
        AriaCurrent::Page => "page",
        AriaCurrent::Step => "step",
        AriaCurrent::Location => "location",
        AriaCurrent::Date => "date",
        AriaCurrent::Time => "time",
    }
}

fn auto_complete(auto_complete: AutoComplete) -> &'static str {
    match auto_complete {
        AutoComplete::Inline => "inline",
        AutoComplete::List => "list",
        AutoComplete::Both => "both",
    }
}

fn toggled(toggled: Toggled) -> &'static str {
    match toggled {
        Toggled::False => "false",
        Toggled::True => "true",
        Toggled::Mixed => "mixed",
    }
}
