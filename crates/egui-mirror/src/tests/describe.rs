use egui::Role;
use egui::accesskit::{Affine, Node, NodeId, Rect, Toggled};

use super::{ROOT, TestTree, control, label};
use crate::element::{Place, element_id};
use crate::page::Page;

fn tags(page: &Page) -> Vec<&str> {
    page.elements().iter().map(|element| element.tag).collect()
}

fn attribute<'a>(page: &'a Page, id: NodeId, name: &str) -> Option<&'a str> {
    page.get(id)?.attributes.get(name).map(String::as_str)
}

#[test]
fn reading_order_is_the_order_of_children_through_containers_without_meaning() {
    let mut tree = TestTree::new();
    let first = tree.add(ROOT, Role::GenericContainer, |_| ());
    let second = tree.add(ROOT, Role::Pane, |_| ());
    tree.add(second, Role::Label, |node| label(node, "last"));
    tree.add(first, Role::Heading, |node| label(node, "first"));
    let named = tree.add(first, Role::GenericContainer, |node| node.set_label("a group"));
    tree.add(named, Role::Label, |node| label(node, "inside"));
    assert_eq!(
        tree.page().to_string(),
        "h2 text: \"first\" at: 0 0 1 1\ndiv aria-label=\"a group\" role=\"group\" at: 0 0 1 1\n  \
         span text: \"inside\" at: 0 0 1 1\nspan text: \"last\" at: 0 0 1 1\n"
    );
}

#[test]
fn a_label_says_its_value_once_although_its_text_runs_say_it_too() {
    let mut tree = TestTree::new();
    let id = tree.add(ROOT, Role::Label, |node| label(node, "Width"));
    tree.add(id, Role::TextRun, |node| node.set_value("Width"));
    assert_eq!(tree.page().to_string(), "span text: \"Width\" at: 0 0 1 1\n");
}

#[test]
fn a_field_is_named_by_its_label_and_described_by_its_error() {
    let mut tree = TestTree::new();
    let name = tree.add(ROOT, Role::Label, |node| label(node, "Height"));
    let error = NodeId(3);
    let field = tree.add(ROOT, Role::NumberInput, |node| {
        node.set_labelled_by([name]);
        node.set_described_by([error, NodeId(99)]);
        node.set_invalid(egui::accesskit::Invalid::True);
        node.set_value("abc");
    });
    tree.add(ROOT, Role::Label, |node| label(node, "not a number"));
    let page = tree.page();
    assert_eq!(page.get(field).unwrap().name, "Height");
    assert_eq!(attribute(&page, field, "aria-labelledby"), Some("mirror-1"));
    assert_eq!(
        attribute(&page, field, "aria-describedby"),
        Some(crate::element::about_id(field).as_str())
    );
    assert_eq!(
        page.get(field).unwrap().description.as_deref(),
        Some("not a number"),
        "a relation to nothing is left out"
    );
    assert_eq!(attribute(&page, field, "aria-invalid"), Some("true"));
}

#[test]
fn the_number_keyboard_is_asked_for_only_where_neither_a_sign_nor_a_unit_can_be_typed() {
    let mut tree = TestTree::new();
    let any = tree.add(ROOT, Role::NumberInput, |_| {});
    let signed = tree.add(ROOT, Role::SpinButton, |node| node.set_min_numeric_value(-1.0));
    let bare = tree.add(ROOT, Role::NumberInput, |node| node.set_min_numeric_value(0.0));
    let page = tree.page();
    assert_eq!(attribute(&page, any, "inputmode"), Some("text"));
    assert_eq!(attribute(&page, any, "autocapitalize"), Some("off"));
    assert_eq!(attribute(&page, signed, "inputmode"), Some("text"));
    assert_eq!(attribute(&page, bare, "inputmode"), Some("decimal"));
}

#[test]
fn the_author_chooses_the_keyboard_of_a_text_field() {
    let mut tree = TestTree::new();
    let field = tree.add(ROOT, Role::TextInput, |node| node.set_class_name("digits"));
    let page = Page::describe(&crate::Tree {
        input_mode: |node| node.class_name().map(|_| "numeric"),
        ..tree.input(ROOT)
    });
    assert_eq!(attribute(&page, field, "inputmode"), Some("numeric"));
    assert_eq!(attribute(&tree.page(), field, "inputmode"), None);
}

#[test]
fn tables_and_lists_are_made_of_their_own_elements() {
    let mut tree = TestTree::new();
    let table = tree.add(ROOT, Role::Table, |node| node.set_label("Results"));
    for row in 0..2 {
        let row_id = tree.add(table, Role::Row, |_| ());
        let inner = tree.add(row_id, Role::GenericContainer, |_| ());
        tree.add(inner, if row == 0 { Role::ColumnHeader } else { Role::RowHeader }, |node| {
            label(node, "a")
        });
        tree.add(inner, Role::Cell, |node| label(node, "b"));
    }
    let list = tree.add(ROOT, Role::List, |_| ());
    tree.add(list, Role::ListItem, |node| label(node, "c"));
    let page = tree.page();
    assert_eq!(tags(&page), ["table", "tr", "th", "td", "tr", "th", "td", "ul", "li"]);
    let scopes: Vec<_> = page
        .elements()
        .iter()
        .filter_map(|element| element.attributes.get("scope"))
        .collect();
    assert_eq!(scopes, ["col", "row"]);
}

#[test]
fn the_words_of_a_table_are_a_sentence_for_each_row() {
    let mut tree = TestTree::new();
    let table = tree.add(ROOT, Role::Table, |_| ());
    for (first, second) in [("Enter", "Calculate"), ("Esc", "Close")] {
        let row = tree.add(table, Role::Row, |_| ());
        tree.add(row, Role::RowHeader, |node| label(node, first));
        tree.add(row, Role::Cell, |node| label(node, second));
    }
    assert_eq!(tree.page().words(table), "Enter: Calculate. Esc: Close");
}

#[test]
fn a_picture_has_a_name_and_a_description() {
    let mut tree = TestTree::new();
    let id = tree.add(ROOT, Role::Image, |node| {
        node.set_label("Speed against time");
        node.set_description("Falls from 10 m to 1 m");
    });
    let page = tree.page();
    let said = ["role", "aria-label", "aria-describedby"].map(|name| attribute(&page, id, name).unwrap());
    assert_eq!(said, ["img", "Speed against time", "about-1"]);
    assert_eq!(page.get(id).unwrap().description.as_deref(), Some("Falls from 10 m to 1 m"));
}

#[test]
fn places_are_css_pixels_relative_to_the_element_around() {
    let mut tree = TestTree::new();
    tree.nodes.get_mut(&ROOT).unwrap().set_transform(Affine::scale(3.0));
    let group = tree.add(ROOT, Role::Group, |node| node.set_label("group"));
    let bounds = |x0, y0| Rect {
        x0,
        y0,
        x1: x0 + 10.0,
        y1: y0 + 20.0,
    };
    let one = tree.add(group, Role::Button, |node| node.set_bounds(bounds(100.0, 50.0)));
    let two = tree.add(group, Role::Button, |node| node.set_bounds(bounds(120.0, 50.0)));
    // Three physical pixels to a point, two to a CSS pixel.
    let page = Page::describe(&crate::Tree {
        scale: 0.5,
        ..tree.input(ROOT)
    });
    let place = |id| page.get(id).unwrap().place;
    assert_eq!(
        place(group),
        Place {
            left: 150.0,
            top: 75.0,
            width: 45.0,
            height: 30.0
        },
        "as large as what it contains"
    );
    assert_eq!(
        place(one),
        Place {
            left: 0.0,
            top: 0.0,
            width: 15.0,
            height: 30.0
        }
    );
    assert_eq!(
        place(two),
        Place {
            left: 30.0,
            top: 0.0,
            width: 15.0,
            height: 30.0
        }
    );
}

#[test]
fn a_combo_box_knows_its_open_list_and_the_buttons_in_it_are_options() {
    let mut tree = TestTree::new();
    let combo = tree.add(ROOT, Role::ComboBox, |node| {
        control(node, "Unit");
        node.set_value("meters");
    });
    let closed = tree.page();
    assert_eq!(attribute(&closed, combo, "aria-expanded"), Some("false"));
    assert_eq!(
        closed.get(combo).unwrap().text.as_deref(),
        Some("meters"),
        "its content is its value"
    );
    let area = tree.add(combo, Role::GenericContainer, |_| ());
    let list = tree.add(area, Role::ListBox, |_| ());
    let inner = tree.add(list, Role::GenericContainer, |_| ());
    let option = tree.add(inner, Role::Button, |node| {
        control(node, "meters");
        node.set_toggled(Toggled::True);
    });
    let open = tree.page();
    assert_eq!(attribute(&open, combo, "aria-expanded"), Some("true"));
    assert_eq!(attribute(&open, combo, "aria-controls"), Some(element_id(list).as_str()));
    assert_eq!(attribute(&open, list, "aria-label"), Some("Unit"));
    assert_eq!(open.roots(), [combo, list], "a list is not inside the button that opens it");
    assert_eq!(
        (attribute(&open, option, "role"), attribute(&open, option, "aria-selected")),
        (Some("option"), Some("true"))
    );
    assert!(open.has_popup() && !closed.has_popup());
}

#[test]
fn a_modal_dialog_shuts_out_the_rest_and_is_named_by_its_heading() {
    let mut tree = TestTree::new();
    let behind = tree.add(ROOT, Role::Button, |node| control(node, "Ask"));
    let dialog = tree.add(ROOT, Role::Dialog, |_| ());
    let heading = tree.add(dialog, Role::Heading, |node| label(node, "Really?"));
    let inside = tree.add(dialog, Role::Button, |node| control(node, "Close"));
    let page = Page::describe(&crate::Tree {
        modal: true,
        ..tree.input(ROOT)
    });
    assert!(!page.can_be_reached(behind) && page.can_be_reached(inside));
    assert_eq!(page.first_stop_in_dialog(), Some(inside));
    assert_eq!(attribute(&page, dialog, "aria-labelledby"), Some(element_id(heading).as_str()));
    assert!(tree.page().can_be_reached(behind), "a dialog that is not modal shuts out nothing");
}

#[test]
fn what_is_disabled_stays_in_the_page_but_is_no_stop_and_takes_no_click() {
    let mut tree = TestTree::new();
    let id = tree.add(ROOT, Role::Button, |node| {
        control(node, "Reset");
        node.set_disabled();
    });
    let page = tree.page();
    assert_eq!(
        (attribute(&page, id, "aria-disabled"), attribute(&page, id, "tabindex")),
        (Some("true"), Some("-1"))
    );
    assert!(!page.get(id).unwrap().allowed.click);
}

#[test]
fn a_password_is_never_in_the_page() {
    let mut tree = TestTree::new();
    let id = tree.add(ROOT, Role::PasswordInput, |node| node.set_value("••••"));
    assert_eq!(tree.page().get(id).unwrap().value, None);
}

#[test]
fn a_hidden_node_is_not_in_the_page() {
    let mut tree = TestTree::new();
    tree.add(ROOT, Role::Button, Node::set_hidden);
    assert!(tree.page().elements().is_empty());
}

#[test]
fn text_lies_in_the_page_as_it_is_painted() {
    let rect = |x0, y0, x1, y1| egui::accesskit::Rect { x0, y0, x1, y1 };
    let mut tree = TestTree::new();
    let words = tree.add(ROOT, Role::Label, |node| {
        label(node, "two lines");
        node.set_bounds(rect(10.0, 20.0, 110.0, 60.0));
    });
    for line in 0..2 {
        let y = 22.0 + 16.0 * f64::from(line);
        tree.add(words, Role::TextRun, |node| node.set_bounds(rect(14.0, y, 54.0, y + 16.0)));
    }
    let heading = tree.add(ROOT, Role::Heading, |node| {
        label(node, "one");
        node.set_bounds(rect(0.0, 0.0, 80.0, 24.0));
    });
    let page = tree.page();
    let lettering = |id| {
        page.get(id)
            .unwrap()
            .lettering
            .map(|text| (text.left, text.top, text.width, text.line, text.lines))
    };
    assert_eq!(lettering(words), Some((4.0, 2.0, 80.0, 16.0, 2)));
    assert_eq!(lettering(heading), Some((0.0, 0.0, 80.0, 24.0, 1)));
}

#[test]
fn a_field_keeps_its_description_while_somebody_is_in_it_and_its_validity_while_they_type() {
    let page = |error: Option<&str>| {
        let mut tree = TestTree::new();
        let field = tree.add(ROOT, Role::TextInput, |node| {
            node.set_label("Height");
            node.set_description("In meters.");
            node.set_described_by(vec![NodeId(7)]);
            if error.is_some() {
                node.set_invalid(egui::accesskit::Invalid::True);
            }
        });
        if let Some(error) = error {
            tree.nodes.get_mut(&ROOT).unwrap().push_child(NodeId(7));
            tree.nodes.insert(NodeId(7), {
                let mut node = egui::accesskit::Node::new(Role::Label);
                label(&mut node, error);
                node
            });
        }
        (tree.page(), field)
    };
    let said = |page: &Page, field| {
        let words = page.get(field).unwrap().description.clone().unwrap();
        (words, attribute(page, field, "aria-invalid").map(str::to_owned))
    };
    let (good, field) = page(None);
    let (bad, _) = page(Some("cannot be zero"));
    assert_eq!(said(&bad, field).0, "cannot be zero In meters.");

    let mut typed_in = bad.clone();
    assert!(typed_in.keep_description(&good, field, true));
    assert_eq!(said(&typed_in, field), ("In meters.".to_owned(), None));

    let mut paused = bad.clone();
    assert!(paused.keep_description(&good, field, false));
    assert_eq!(said(&paused, field), ("In meters.".to_owned(), Some("true".to_owned())));

    // Who mends it does not hear the rest of it again.
    let mut mended = good.clone();
    assert!(mended.keep_description(&bad, field, false));
    assert_eq!(said(&mended, field), ("cannot be zero In meters.".to_owned(), None));
}
