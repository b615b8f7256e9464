//! The form: what is asked for, the fields of that, the buttons, and what refines a distance.

use super::parts::{Part, field_ui, heading_ui, part_ui, sigma_heading_ui};
use super::{footer, unknown};
use crate::app::command::{Command, Helper};
use crate::app::context::AppContext;
use crate::app::theme;
use crate::app::widgets::field;
use crate::app::widgets::segments::{self, Segments};
use crate::app::widgets::{choice, menu, pairs};
use crate::core::setup::{Object, Pair};
use depth_text::field::{Key, Section};
use depth_text::fields;
use depth_text::report::strip::Mode;
use egui::accesskit::Role;
use egui::{Popup, Rect, Sense, Ui, UiBuilder, vec2};

/// Draws the form. With `marked`, what is missing is said at the fields too. Returns the place of the refinements, where they are shown.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>, marked: bool) -> Option<Rect> {
    let builder = UiBuilder::new().accessibility_role(Role::Form).accessibility_label("Inputs");
    let form = |ui: &mut Ui| {
        ui.set_width(ui.available_width());
        ui.spacing_mut().item_spacing.y = 0.0;
        let mode = cx.mode();
        mode_ui(ui, cx, mode);
        ui.add_space(theme::BELOW_MODES);
        match mode {
            Mode::Distance => distance_ui(ui, cx, marked),
            Mode::Quantity => unknown::ui(ui, cx, marked),
            Mode::Ground | Mode::TwoShots | Mode::TwoPoints => groups_ui(ui, cx, groups(mode)),
        }
        part_ui(ui, Part::Buttons, |ui| footer::ui(ui, cx, mode));
        let is_refined = cx.settings.shows_refinements && matches!(mode, Mode::Distance | Mode::Quantity);
        is_refined.then(|| part_ui(ui, Part::Refinements, |ui| refinements_ui(ui, cx)))
    };
    ui.scope_builder(builder, |ui| theme::card(theme::palette(ui)).show(ui, form).inner)
        .inner
}

/// What is asked for: one of three in sight, or one of the menu.
fn mode_ui(ui: &mut Ui, cx: &mut AppContext<'_>, mode: Mode) {
    let (whole, _) = ui.allocate_exact_size(vec2(ui.available_width(), field::height(ui)), Sense::hover());
    let chosen = Mode::FIRST.iter().position(|&one| one == mode);
    let is_narrow = whole.width() < theme::PAIR_WIDTH;
    let names = Mode::FIRST.map(Mode::name);
    // The way that was chosen is written out; the others make room for it.
    let written = if is_narrow && (chosen.is_none() || whole.width() < theme::NAMES_WIDTH) {
        Mode::FIRST.map(Mode::short_name)
    } else {
        names
    };
    let more = match chosen {
        Some(_) if is_narrow => "More",
        Some(_) => "More ways",
        None => mode.short_name(),
    };
    let all = Segments {
        group: "What is asked for",
        names: &[written[0], written[1], written[2], more],
        written: None,
        chosen,
    };
    let arrow = theme::ARROW_WIDTH + 2.0 * theme::STEP;
    let mut widths = all.widths(ui, whole.width() - arrow);
    if let Some(last) = widths.last_mut() {
        *last += arrow;
    }
    let cells = segments::row(whole, &widths);
    let first = Segments {
        names: &names,
        written: Some(&written),
        ..all
    };
    let now = first.ui(ui, cells.get(..3).unwrap_or_default());
    if let Some(&asked) = now.and_then(|now| Mode::FIRST.get(now)) {
        cx.commands.push(Command::Ask(asked));
    }
    if let Some(&cell) = cells.last() {
        more_ui(ui, cx, (cell, more), mode);
    }
    segments::border_ui(ui, whole, &cells);
}

/// The menu with the other ways.
fn more_ui(ui: &mut Ui, cx: &mut AppContext<'_>, (cell, name): (Rect, &str), mode: Mode) {
    let palette = theme::palette(ui);
    let response = ui.interact(cell, ui.scope_id().with("more ways"), Sense::click());
    let is_chosen = Mode::MORE.contains(&mode);
    let words = cell.with_max_x(cell.right() - theme::ARROW_WIDTH - theme::STEP);
    segments::ground_ui(ui, cell, is_chosen);
    segments::name_ui(ui, words, name, is_chosen);
    let arrow = Rect::from_center_size(cell.right_center() - vec2(theme::ARROW_INSET, 0.0), theme::ARROW);
    ui.painter().add(egui::Shape::convex_polygon(
        vec![arrow.left_top(), arrow.right_top(), arrow.center_bottom()],
        palette.text,
        egui::Stroke::NONE,
    ));
    let is_open = Popup::is_id_open(ui.ctx(), Popup::default_response_id(&response));
    let label = if is_chosen {
        format!("More ways: {}", mode.name())
    } else {
        "More ways".to_owned()
    };
    response.widget_info(|| egui::WidgetInfo::labeled(Role::Button, true, &label));
    ui.accesskit_node_builder(response.id, |node| {
        node.set_has_popup(egui::accesskit::HasPopup::Menu);
        node.set_expanded(is_open);
    });
    let entries = Mode::MORE.map(|asked| (asked.name(), None));
    let asked = menu::ui(&response, cx.layout.control_height(), &entries).and_then(|at| Mode::MORE.get(at));
    cx.commands.extend(asked.map(|&asked| Command::Ask(asked)));
    response.on_hover_cursor(egui::CursorIcon::PointingHand);
}

/// What a person needs who does not type five numbers in a row: drawn, and so in the order of the focus, behind the fields, each in the
/// line that was left for it.
enum Late {
    /// How the cameras stand, or what of the object is measured.
    Setup(Section),
    Helper(Helper),
}

fn distance_ui(ui: &mut Ui, cx: &mut AppContext<'_>, marked: bool) {
    let mut late = Vec::new();
    for section in Section::FORM {
        part_ui(ui, Part::Section(section), |ui| {
            late.push((Late::Setup(section), heading_ui(ui, section.name(), Some(section))));
            for key in section.keys() {
                // Most rigs have no doffs, so the field is hidden until there is one. fy belongs to a point in space, too.
                if !cx.session.inputs.shows(key) {
                    continue;
                }
                part_ui(ui, Part::Field(key.as_str()), |ui| {
                    let line = field_ui(ui, cx, key, marked);
                    let helper = key.input.and_then(Helper::at).filter(|helper| helper.comes_last());
                    late.extend(helper.map(|helper| (Late::Helper(helper), line)));
                });
                ui.add_space(theme::FIELD_GAP);
            }
        });
        ui.add_space(theme::ABOVE_HEADING - theme::FIELD_GAP);
    }
    part_ui(ui, Part::Late, |ui| {
        for (what, line) in late {
            match what {
                Late::Setup(section) => setup_ui(ui, cx, section, line),
                Late::Helper(helper) => field::helper_ui(ui, line, helper, cx.commands),
            }
        }
    });
}

/// What is chosen in a section, how the cameras stand or what of the object is measured, in the `line` of its heading.
fn setup_ui(ui: &mut Ui, cx: &mut AppContext<'_>, section: Section, line: Rect) {
    let inputs = &mut cx.session.inputs;
    let changed = match section {
        Section::Stereo => choice::ui(ui, line, "Cameras", &Pair::ALL, &mut inputs.pair),
        Section::Monocular => choice::ui(ui, line, "Measured", &Object::ALL, &mut inputs.object),
        _ => {
            sigma_heading_ui(ui, line, false);
            false
        }
    };
    if changed {
        cx.commands.push(Command::Settle);
    }
}

/// Fields that belong together: their heading, and their keys.
type Group = (&'static str, &'static [Key]);

/// The fields of the ways that have a form of their own.
const fn groups(mode: Mode) -> &'static [Group] {
    match mode {
        Mode::Ground => &[
            ("Camera", &[fields::FOCAL_LENGTH, fields::FY, fields::CX, fields::CY]),
            ("Where it stands", &[fields::CAMERA_HEIGHT, fields::CAMERA_PITCH]),
            (
                "Point in the image",
                &[fields::FLOOR_COLUMN, fields::FLOOR_ROW, fields::TARGET_HEIGHT, fields::FLOOR_ANGLE],
            ),
        ],
        Mode::TwoShots => &[
            ("The same object, twice", &[fields::FAR_WIDTH, fields::NEAR_WIDTH, fields::STEP]),
            ("For the width of the object", &[fields::FOCAL_LENGTH]),
        ],
        Mode::TwoPoints => &[
            ("Cameras", &[fields::FOCAL_LENGTH, fields::BASELINE, fields::CX, fields::CY]),
            ("First point", &[fields::FROM_COLUMN, fields::FROM_ROW, fields::FROM_DISPARITY]),
            ("Second point", &[fields::TO_COLUMN, fields::TO_ROW, fields::TO_DISPARITY]),
        ],
        Mode::Distance | Mode::Quantity => &[
            (
                "Where the object stands in the image",
                &[fields::CX, fields::CY, fields::PIXEL_COLUMN, fields::PIXEL_ROW, fields::FY],
            ),
            ("What a tape measures", &[fields::TAPED_RANGE, fields::ZERO]),
            ("How it is turned", &[fields::TILT]),
        ],
    }
}

/// Draws groups of fields, two side by side.
fn groups_ui(ui: &mut Ui, cx: &mut AppContext<'_>, groups: &[Group]) {
    for (index, (name, keys)) in groups.iter().enumerate() {
        if index > 0 {
            ui.add_space(theme::ABOVE_HEADING - theme::FIELD_GAP);
        }
        let line = heading_ui(ui, name, None);
        if index == 0 {
            sigma_heading_ui(ui, line, ui.available_width() >= theme::PAIR_WIDTH);
        }
        pairs::ui(ui, keys, |ui, key| {
            part_ui(ui, Part::Field(key.as_str()), |ui| field_ui(ui, cx, key, false));
        });
    }
    ui.add_space(theme::ABOVE_HEADING - theme::FIELD_GAP);
}

/// Draws what refines a distance. Returns its place.
fn refinements_ui(ui: &mut Ui, cx: &mut AppContext<'_>) -> Rect {
    let top = ui.cursor().min;
    ui.add_space(theme::BELOW_MODES);
    groups_ui(ui, cx, groups(Mode::Distance));
    Rect::from_min_max(top, ui.min_rect().max)
}
