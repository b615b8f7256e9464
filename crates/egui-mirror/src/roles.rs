//! Which HTML element, and which ARIA role, stands for which AccessKit role.
//!
//! A real HTML element is preferred wherever one exists, because browsers and screen readers know how it is operated.
//! Source: the mappings of WAI-ARIA 1.2 and of HTML-AAM 1.0.

use egui::Role;
use egui::accesskit::{Action, Node};

/// How a person operates an element: it decides what keys and events on it mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// The browser turns both Enter and Space into a click.
    Button,
    /// A box or a radio button: the browser turns only Space into a click.
    Check,
    /// One line of text.
    Line,
    /// Several lines of text.
    Lines,
    /// One line that holds a number, with steps up and down.
    Stepper,
    /// A number on a track.
    Range,
    /// Anything else: the browser does nothing of its own.
    Other,
}

impl Kind {
    /// Is text typed into it?
    pub(crate) fn is_text(self) -> bool {
        matches!(self, Self::Line | Self::Lines | Self::Stepper)
    }
}

/// What surrounds a node, where that changes what the node is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Within {
    /// Nothing special.
    Page,
    /// A list of options: egui draws its options as buttons.
    ListBox,
    /// A menu: egui draws its items as buttons.
    Menu,
}

/// The HTML form of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Shape {
    /// The name of the element.
    pub(crate) tag: &'static str,
    /// The `type` of an `<input>` or `<button>`.
    pub(crate) input_type: Option<&'static str>,
    /// The explicit role, where the element alone does not say it, or where its position would hide it.
    pub(crate) role: Option<&'static str>,
    /// How it is operated.
    pub(crate) kind: Kind,
    /// Is its name the text inside it? Otherwise the name is an attribute.
    pub(crate) named_by_content: bool,
}

impl Shape {
    const fn new(tag: &'static str, role: Option<&'static str>, kind: Kind) -> Self {
        Self {
            tag,
            input_type: None,
            role,
            kind,
            named_by_content: false,
        }
    }

    /// A box whose name is an attribute.
    const fn part(role: &'static str) -> Self {
        Self::new("div", Some(role), Kind::Other)
    }

    /// An element whose name is the text inside it.
    const fn text(tag: &'static str, role: Option<&'static str>) -> Self {
        Self {
            named_by_content: true,
            ..Self::new(tag, role, Kind::Other)
        }
    }

    const fn button(role: Option<&'static str>) -> Self {
        Self {
            input_type: Some("button"),
            named_by_content: true,
            ..Self::new("button", role, Kind::Button)
        }
    }

    const fn input(input_type: &'static str, role: Option<&'static str>, kind: Kind) -> Self {
        Self {
            input_type: Some(input_type),
            ..Self::new("input", role, kind)
        }
    }
}

/// The HTML form of `node`, or `None` when it has no meaning of its own and only its children count.
pub(crate) fn shape(node: &Node, within: Within) -> Option<Shape> {
    let shape = match (node.role(), within) {
        (Role::Button | Role::DefaultButton, Within::ListBox) => Shape::button(Some("option")),
        (Role::Button | Role::DefaultButton, Within::Menu) => Shape::button(Some("menuitem")),

        (Role::Label | Role::Paragraph | Role::Strong | Role::Emphasis | Role::Mark | Role::Abbr | Role::Legend, _) => {
            Shape::text("span", None)
        }
        (Role::Heading, _) => Shape::text(heading(node.level()), None),
        (Role::Link, _) => Shape::text("a", Some("link")),
        (Role::Caption | Role::FigureCaption, _) => Shape::text("div", Some("caption")),
        (Role::Code, _) => Shape::text("code", None),
        (Role::Blockquote, _) => Shape::text("blockquote", None),
        (Role::Time, _) => Shape::text("time", None),
        (Role::Tooltip, _) => Shape::text("div", Some("tooltip")),
        (Role::Term, _) => Shape::text("div", Some("term")),
        (Role::Definition, _) => Shape::text("div", Some("definition")),
        (Role::Note | Role::Comment, _) => Shape::text("div", Some("note")),
        (Role::Math, _) => Shape::part("math"),

        (Role::Status, _) => Shape::text("div", Some("status")),
        (Role::Alert, _) => Shape::text("div", Some("alert")),
        (Role::Log, _) => Shape::text("div", Some("log")),
        (Role::Timer, _) => Shape::text("div", Some("timer")),
        (Role::Marquee, _) => Shape::text("div", Some("marquee")),

        (Role::Button | Role::DefaultButton | Role::ColorWell | Role::DisclosureTriangle, _) => Shape::button(None),
        (Role::Tab, _) => Shape::button(Some("tab")),
        (Role::MenuItem, _) => Shape::button(Some("menuitem")),
        (Role::MenuItemCheckBox, _) => Shape::button(Some("menuitemcheckbox")),
        (Role::MenuItemRadio, _) => Shape::button(Some("menuitemradio")),
        (Role::ListBoxOption | Role::MenuListOption, _) => Shape::button(Some("option")),
        (Role::TreeItem, _) => Shape::text("div", Some("treeitem")),
        // Its content is the value; the name stands beside it.
        (Role::ComboBox, _) => Shape {
            named_by_content: false,
            ..Shape::button(Some("combobox"))
        },

        (Role::CheckBox, _) => Shape::input("checkbox", None, Kind::Check),
        (Role::Switch, _) => Shape::input("checkbox", Some("switch"), Kind::Check),
        (Role::RadioButton, _) => Shape::input("radio", None, Kind::Check),
        (Role::Slider, _) => Shape::input("range", None, Kind::Range),
        (Role::SpinButton, _) => Shape::input("text", Some("spinbutton"), Kind::Stepper),
        (Role::EditableComboBox, _) => Shape::input("text", Some("combobox"), Kind::Line),
        (Role::SearchInput, _) => Shape::input("text", Some("searchbox"), Kind::Line),
        (Role::PasswordInput, _) => Shape::input("password", None, Kind::Line),
        (Role::MultilineTextInput, _) => Shape::new("textarea", None, Kind::Lines),
        // Not the types "number", "date" and so on: they refuse text that the application accepts ("1,5", "12 mm").
        (
            Role::TextInput
            | Role::NumberInput
            | Role::EmailInput
            | Role::PhoneNumberInput
            | Role::UrlInput
            | Role::DateInput
            | Role::DateTimeInput
            | Role::WeekInput
            | Role::MonthInput
            | Role::TimeInput,
            _,
        ) => Shape::input("text", None, Kind::Line),

        (Role::ProgressIndicator, _) => Shape::part("progressbar"),
        (Role::Meter, _) => Shape::part("meter"),
        (Role::Splitter, _) => Shape::part("separator"),
        (Role::Image | Role::Canvas | Role::GraphicsObject | Role::GraphicsSymbol | Role::SvgRoot, _) => Shape::part("img"),
        (Role::Figure | Role::GraphicsDocument, _) => Shape::part("figure"),

        // The roles are repeated, because a positioned table, row or list is no longer one to every browser.
        (Role::Table | Role::ListGrid, _) => Shape::new("table", Some("table"), Kind::Other),
        (Role::Grid, _) => Shape::new("table", Some("grid"), Kind::Other),
        (Role::TreeGrid, _) => Shape::new("table", Some("treegrid"), Kind::Other),
        (Role::RowGroup, _) => Shape::new("tbody", Some("rowgroup"), Kind::Other),
        (Role::Row, _) => Shape::new("tr", Some("row"), Kind::Other),
        (Role::ColumnHeader, _) => Shape::text("th", Some("columnheader")),
        (Role::RowHeader, _) => Shape::text("th", Some("rowheader")),
        (Role::Cell, _) => Shape::text("td", Some("cell")),
        (Role::GridCell, _) => Shape::text("td", Some("gridcell")),
        (Role::List | Role::DescriptionList, _) => Shape::new("ul", Some("list"), Kind::Other),
        (Role::ListItem, _) => Shape::text("li", Some("listitem")),

        (Role::ListBox, _) => Shape::part("listbox"),
        (Role::Menu | Role::MenuListPopup, _) => Shape::part("menu"),
        (Role::MenuBar, _) => Shape::part("menubar"),
        (Role::Tree, _) => Shape::part("tree"),
        (Role::TabList, _) => Shape::part("tablist"),
        (Role::TabPanel, _) => Shape::part("tabpanel"),
        (Role::RadioGroup, _) => Shape::part("radiogroup"),
        (Role::Toolbar, _) => Shape::part("toolbar"),
        (Role::Dialog | Role::Window, _) => Shape::part("dialog"),
        (Role::AlertDialog, _) => Shape::part("alertdialog"),
        (Role::Article, _) => Shape::new("article", None, Kind::Other),
        (Role::Feed, _) => Shape::part("feed"),
        (Role::Main, _) => Shape::new("main", None, Kind::Other),
        (Role::Navigation, _) => Shape::new("nav", None, Kind::Other),
        (Role::Banner, _) => Shape::part("banner"),
        (Role::ContentInfo, _) => Shape::part("contentinfo"),
        (Role::Complementary, _) => Shape::new("aside", None, Kind::Other),
        (Role::Form, _) => Shape::part("form"),
        (Role::Search, _) => Shape::part("search"),
        (Role::Document, _) => Shape::part("document"),
        (Role::Application, _) => Shape::part("application"),
        (Role::Region | Role::Pane, _) => Shape::part("region"),
        (Role::TextRun | Role::ScrollBar | Role::Caret | Role::LineBreak | Role::ListMarker, _) => return None,
        _ => Shape::part("group"),
    };
    (!is_bare(node)).then_some(shape)
}

/// A container, or something unknown, that nobody named and nobody can operate.
fn is_bare(node: &Node) -> bool {
    let container = matches!(
        node.role(),
        Role::GenericContainer
            | Role::Group
            | Role::LayoutTable
            | Role::LayoutTableCell
            | Role::LayoutTableRow
            | Role::Pane
            | Role::Region
            | Role::RootWebArea
            | Role::ScrollView
            | Role::Section
            | Role::TitleBar
            | Role::Unknown
            | Role::Window
    );
    container
        && node.label().is_none_or(str::is_empty)
        && node.labelled_by().is_empty()
        && node.live().is_none()
        && !node.supports_action(Action::Focus)
}

fn heading(level: Option<usize>) -> &'static str {
    match level {
        Some(1) => "h1",
        Some(3) => "h3",
        Some(4) => "h4",
        Some(5) => "h5",
        Some(6..) => "h6",
        _ => "h2",
    }
}

/// The on-screen keyboard that suits a text field: a value of HTML's `inputmode`.
pub(crate) fn input_mode(role: Role) -> Option<&'static str> {
    match role {
        Role::NumberInput | Role::SpinButton => Some("decimal"),
        Role::EmailInput => Some("email"),
        Role::PhoneNumberInput => Some("tel"),
        Role::UrlInput => Some("url"),
        Role::SearchInput => Some("search"),
        _ => None,
    }
}
