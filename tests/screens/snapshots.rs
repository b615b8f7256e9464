//! How the screens look. Longer than a file should be, as it is one list of screens.

use crate::images;
use crate::llvmpipe::{self, Painter};
use crate::machine::Machine;
use crate::program::{B, D, DESKTOP, FX, PHONE, Program, W_IMG, W_REAL, type_sigma};
use crate::rigs;
use egui::accesskit::Role;
use egui::{Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use image::RgbImage;
use std::cell::RefCell;
use std::rc::Rc;

/// How much of a screen an image shows.
#[derive(Clone, Copy)]
enum Part {
    /// What can be seen without scrolling.
    Window,
    /// What scrolls too, as if the window were high enough.
    Whole,
    /// The middle column of the window, where dialogs are.
    Middle,
}

/// A window to draw a screen in, and what of it is compared.
#[derive(Clone, Copy)]
struct View {
    name: &'static str,
    size: Vec2,
    is_dark: bool,
    part: Part,
}

const fn view(name: &'static str, size: Vec2, is_dark: bool) -> View {
    View {
        name,
        size,
        is_dark,
        part: Part::Whole,
    }
}

const TABLET: Vec2 = vec2(768.0, 1024.0);
const WIDE: Vec2 = vec2(1920.0, 1080.0);
const HUGE: Vec2 = vec2(2560.0, 1440.0);

const PHONE_LIGHT: View = view("phone-light", PHONE, false);
const PHONE_DARK: View = view("phone-dark", PHONE, true);
const TABLET_LIGHT: View = view("tablet-light", TABLET, false);
const TABLET_DARK: View = view("tablet-dark", TABLET, true);
const DESKTOP_LIGHT: View = view("desktop-light", DESKTOP, false);
const DESKTOP_DARK: View = view("desktop-dark", DESKTOP, true);
const WIDE_LIGHT: View = view("wide-light", WIDE, false);
const WIDE_DARK: View = view("wide-dark", WIDE, true);
const HUGE_LIGHT: View = view("huge-light", HUGE, false);
const HUGE_DARK: View = view("huge-dark", HUGE, true);

impl View {
    const fn only(self, part: Part) -> Self {
        Self { part, ..self }
    }

    /// What is compared of the image of the window.
    fn cut(self, mut image: RgbImage) -> RgbImage {
        let Part::Middle = self.part else { return image };
        let (left, height) = ((image.width() - DIALOG_WIDTH) / 2, image.height());
        image::imageops::crop(&mut image, left, 0, DIALOG_WIDTH, height).to_image()
    }
}

/// Every width, light and dark.
const EVERY: [View; 10] = [
    PHONE_LIGHT,
    PHONE_DARK,
    TABLET_LIGHT,
    TABLET_DARK,
    DESKTOP_LIGHT,
    DESKTOP_DARK,
    WIDE_LIGHT,
    WIDE_DARK,
    HUGE_LIGHT,
    HUGE_DARK,
];
/// What a screen shows first, where its colors are those of others.
const TOP: [View; 2] = [DESKTOP_LIGHT.only(Part::Window), PHONE_DARK.only(Part::Window)];
/// A dialog.
const DIALOG: [View; 2] = [DESKTOP_LIGHT.only(Part::Middle), PHONE_DARK.only(Part::Window)];

/// Compares a screen in several windows. `prepare` brings the program to where it is drawn.
fn look(screen: &str, views: &[View], prepare: impl Fn(&mut Program)) {
    let stored = RefCell::new(None);
    look_from(screen, views, &stored, prepare);
}

/// Compares what was typed once, in several windows; nothing has the keyboard there.
fn look_at_typed(screen: &str, views: &[View], fill: impl Fn(&mut Program)) {
    if llvmpipe::version().is_none() {
        return;
    }
    let mut typed = Program::new();
    fill(&mut typed);
    typed.blur();
    look_from(screen, views, &typed.machine.stored, |_| {});
}

/// Compares a screen in several windows, in which the program begins with what is stored.
fn look_from(screen: &str, views: &[View], stored: &RefCell<Option<String>>, prepare: impl Fn(&mut Program)) {
    let mut problems = Vec::new();
    let Some(renderer) = llvmpipe::version() else { return };
    for view in views {
        let Some(painter) = Painter::new() else { return };
        let mut program = open(*view, painter.clone(), stored.borrow().clone());
        prepare(&mut program);
        program.harness.remove_cursor();
        if matches!(view.part, Part::Whole) {
            program.grow_to_contents(view.size);
        }
        program.harness.run();
        let shapes = &program.harness.output().shapes;
        let cut = shapes.iter().flat_map(|shape| cut_texts(&shape.shape));
        problems.extend(cut.map(|text| format!("{screen}-{}: {text:?} is cut", view.name)));
        let image = view.cut(painter.draw(&program.harness.ctx, program.harness.output()));
        problems.extend(images::compare(&image, &format!("{screen}-{}", view.name), renderer).err());
    }
    images::report(&problems, renderer);
}

/// Pixels that the widest dialog fits into.
const DIALOG_WIDTH: u32 = 600;

/// The program in a window, light or dark.
fn open(view: View, painter: Painter, stored: Option<String>) -> Program {
    let builder = Harness::builder().with_size(view.size).with_pixels_per_point(1.0).renderer(painter);
    let machine = Machine {
        commit: Some("0123456789abcdef"),
        stored: Rc::new(RefCell::new(stored)),
        ..Machine::default()
    };
    let mut program = Program::build(machine, builder);
    // Letters in four positions between two pixels each would make the files a quarter larger.
    let all_styles = |style: &mut egui::Style| {
        style.visuals.text_options.subpixel_binning = false;
        style.visuals.text_cursor.blink = false;
    };
    program.harness.ctx.all_styles_mut(all_styles);
    program.press("Light or dark");
    let theme = if view.is_dark { "Dark" } else { "Light" };
    program.harness.get_by_label(theme).click();
    program.harness.run();
    program
}

impl Program {
    /// Nothing has the keyboard.
    fn blur(&mut self) {
        self.harness.ctx.memory_mut(|memory| {
            if let Some(id) = memory.focused() {
                memory.surrender_focus(id);
            }
        });
        self.harness.run();
    }

    /// Makes the window, which is `size` large at least, as high as its contents.
    fn grow_to_contents(&mut self, size: Vec2) {
        const TALL: f32 = 8000.0;
        const BARS: f32 = 80.0;
        // Scrolls everything to its top.
        self.harness.set_size(vec2(size.x, TALL));
        self.harness.run();
        self.harness.set_size(size);
        self.harness.run();
        // Pictures grow with the window, so that it may take a second time.
        for _ in 0..4 {
            let nodes = self.harness.root().children_recursive();
            // The first picture is as high as there is room.
            let bottoms = nodes
                .filter(|node| node.accesskit_node().raw_bounds().is_some())
                .filter(|node| node.accesskit_node().label().is_none_or(|name| name != "What the letters mean"))
                .map(|node| node.rect().bottom());
            let bottom = bottoms.fold(size.y - BARS, f32::max);
            if bottom + BARS <= self.harness.ctx.content_rect().height() {
                break;
            }
            self.harness.set_size(vec2(size.x, (bottom + BARS).ceil().min(TALL)));
            self.harness.run();
        }
    }
}

/// What is drawn with "…" in place of its end.
fn cut_texts(shape: &egui::Shape) -> Vec<String> {
    match shape {
        egui::Shape::Text(text) if text.galley.elided => vec![text.galley.text().to_owned()],
        egui::Shape::Vec(shapes) => shapes.iter().flat_map(cut_texts).collect(),
        _ => Vec::new(),
    }
}

/// Everything typed that a distance has, with its σ.
fn fill(program: &mut Program) {
    program.mug();
    program.type_into(W_IMG, "150");
    program.type_into(W_REAL, "0.30");
    for (field, sigma) in [(FX, "2"), (B, "0.5"), (D, "0.5"), (W_IMG, "2"), (W_REAL, "0.01")] {
        type_sigma(program, field, sigma);
    }
    program.blur();
}

#[test]
fn the_start_looks_as_before_at_every_width() {
    look("start", &EVERY, |_| {});
}

#[test]
fn both_methods_with_uncertainty_look_as_before_at_every_width() {
    look_at_typed("full", &EVERY, fill);
}

#[test]
fn distances_without_uncertainty_look_as_before() {
    look_at_typed("exact", &[DESKTOP_LIGHT], |program| {
        program.mug();
        program.type_into(W_IMG, "150");
        program.type_into(W_REAL, "0.30");
    });
}

#[test]
fn one_method_alone_looks_as_before() {
    look_at_typed("mug", &[DESKTOP_LIGHT], |program| {
        program.mug();
    });
}

#[test]
fn an_error_after_a_valid_form_looks_as_before_at_every_width() {
    look("error", &EVERY, |program| {
        fill(program);
        program.type_into(D, "−12");
    });
}

#[test]
fn errors_and_warnings_look_as_before() {
    look("errors", &[DESKTOP_LIGHT, PHONE_DARK], |program| {
        program.type_into(FX, "1,000");
        program.type_into(B, "0.1");
        program.type_into(D, "abc");
        program.type_into(W_IMG, "150");
        program.press("Calculate Distance");
    });
}

#[test]
fn methods_that_disagree_look_as_before() {
    look_at_typed("disagree", &[DESKTOP_LIGHT, PHONE_LIGHT], |program| {
        fill(program);
        program.type_into(B, "10");
    });
}

#[test]
fn a_distance_that_first_order_does_not_describe_looks_as_before() {
    look("simulated", &[DESKTOP_LIGHT], |program| {
        fill(program);
        for (field, sigma) in [(D, "12"), (W_IMG, "30")] {
            program.type_into(&format!("Uncertainty of {field}"), sigma);
        }
        program.blur();
        // Simulations, and what moves.
        program.harness.run_steps(60);
        assert_eq!(program.text().matches("100\u{a0}000 draws").count(), 2, "{}", program.text());
    });
}

#[test]
fn range_tilt_and_zero_point_look_as_before() {
    look_at_typed("refined", &[DESKTOP_LIGHT, PHONE_LIGHT], |program| {
        fill(program);
        program.press("Range, tilt, zero point");
        for (field, text) in [
            ("Principal point cx", "640"),
            ("Principal point cy", "360"),
            ("Column of the pixel (u)", "900"),
            ("Row of the pixel (v)", "500"),
            ("Tilt of the target", "20"),
        ] {
            program.type_into(field, text);
        }
    });
}

#[test]
fn the_card_with_whole_notes_looks_as_before() {
    look("note", &TOP, |program| {
        program.type_into(FX, "-7,000");
        type_sigma(program, FX, "many");
    });
}

#[test]
fn another_quantity_looks_as_before() {
    look_at_typed("quantity", &[DESKTOP_LIGHT, PHONE_LIGHT, WIDE_DARK], |program| {
        program.mug();
        for (field, sigma) in [(FX, "2"), (B, "0.5")] {
            type_sigma(program, field, sigma);
        }
        program.ask("Another quantity");
        program.type_into("Distance (D)", "1.40");
        type_sigma(program, "Distance (D)", "0.01");
    });
}

#[test]
fn the_ground_plane_looks_as_before() {
    look_at_typed("ground", &[DESKTOP_LIGHT, DESKTOP_DARK, PHONE_LIGHT, WIDE_DARK], |program| {
        program.ask("Ground plane");
        for (field, text) in [
            (FX, "700"),
            ("Principal point cx", "640"),
            ("Principal point cy", "360"),
            ("Height of the camera", "1.20 ± 0.01"),
            ("Pitch of the camera, downwards", "10 ± 0.2"),
            ("Column of the point on the floor", "1100"),
            ("Row of the point on the floor", "500 ± 1"),
        ] {
            program.type_into(field, text);
        }
    });
}

#[test]
fn two_photographs_look_as_before() {
    look_at_typed("two-photographs", &[DESKTOP_LIGHT, PHONE_DARK], |program| {
        program.ask("Two photographs and a step");
        program.type_into("Width in the first photograph", "1162 ± 3");
        program.type_into("Width in the second photograph", "1429 ± 3");
        program.type_into("Step between them", "419.1 mm");
    });
}

#[test]
fn two_points_look_as_before() {
    look_at_typed("two-points", &[DESKTOP_DARK, PHONE_LIGHT], |program| {
        program.ask("Two points");
        for (field, text) in [
            (FX, "452.9"),
            (B, "75"),
            ("Principal point cx", "298.85"),
            ("Principal point cy", "245.52"),
            ("Column of the first point", "138"),
            ("Row of the first point", "219"),
            ("Disparity of the first point", "36 ± 0.5"),
            ("Column of the second point", "264"),
            ("Row of the second point", "216"),
            ("Disparity of the second point", "30 ± 0.5"),
        ] {
            program.type_into(field, text);
        }
    });
}

/// Draws the first frame after `change` and the one that stays, and fails where they differ.
fn compare_frames(view: View, prepare: impl Fn(&mut Program), change: impl Fn(&mut Program)) {
    let Some(painter) = Painter::new() else { return };
    let mut program = open(view, painter.clone(), None);
    // egui knows that there is something to scroll from the frame before. The bar lies between the columns and moves nothing.
    program.harness.ctx.all_styles_mut(|style| {
        style.spacing.scroll.dormant_handle_opacity = 0.0;
        style.spacing.scroll.active_handle_opacity = 0.0;
    });
    prepare(&mut program);
    program.harness.remove_cursor();
    program.harness.run();
    change(&mut program);
    program.harness.step();
    let first = painter.draw(&program.harness.ctx, program.harness.output());
    program.harness.run();
    let last = painter.draw(&program.harness.ctx, program.harness.output());
    let differing = first.enumerate_pixels().filter(|(x, y, pixel)| last.get_pixel(*x, *y) != *pixel);
    let places: Vec<(u32, u32)> = differing.map(|(x, y, _)| (x, y)).collect();
    if let (Some(first_place), Some(last_place)) = (places.first(), places.last()) {
        for (name, image) in [("first", &first), ("last", &last)] {
            image
                .save(images::output_folder().join(format!("{name}-frame-{}.png", view.name)))
                .unwrap();
        }
        panic!(
            "{}: {} pixels differ, from {first_place:?} to {last_place:?}",
            view.name,
            places.len()
        );
    }
}

#[test]
fn the_first_frame_after_a_key_looks_as_the_one_that_stays() {
    for view in [PHONE_LIGHT, DESKTOP_LIGHT, WIDE_DARK] {
        let prepare = |program: &mut Program| {
            fill(program);
            program.type_into(D, "5");
            // As high as all of it: nothing is out of sight, and no scroll bar comes or goes.
            program.grow_to_contents(view.size);
            program.input(D).focus();
            program.harness.run();
            program.harness.key_press(egui::Key::End);
            program.harness.run();
        };
        compare_frames(view, prepare, |program| program.harness.event(egui::Event::Text("0".to_owned())));
    }
}

#[test]
fn the_first_frame_of_another_width_looks_as_the_one_that_stays() {
    for view in [PHONE_DARK, TABLET_LIGHT, DESKTOP_DARK, WIDE_LIGHT] {
        let change = |program: &mut Program| _ = program.harness.set_size(view.size);
        compare_frames(
            View {
                size: view.size - vec2(24.0, 0.0),
                ..view
            },
            fill,
            change,
        );
    }
}

#[test]
fn the_helper_for_the_focal_length_looks_as_before() {
    look("focal-length", &DIALOG, |program| {
        program.press("From lens, FOV or Q…");
        program.type_into("Focal length of the lens", "4");
        program.type_into("Pixel pitch", "3");
        program.blur();
    });
}

#[test]
fn the_helper_for_the_disparity_looks_as_before() {
    look("disparity", &DIALOG, |program| {
        program.press("OpenCV × 16, doffs…");
        program.choose("What is known", "OpenCV StereoBM or StereoSGBM");
        program.type_into("Stored value", "-16");
        program.type_into("minDisparity", "0");
        program.blur();
    });
}

#[test]
fn a_q_matrix_looks_as_before() {
    look("q-matrix", &DIALOG, |program| {
        type_q_matrix(program);
        program.blur();
    });
}

#[test]
fn what_a_q_matrix_filled_in_a_notice_and_a_choice_of_units_look_as_before() {
    look("doffs", &TOP, |program| {
        type_q_matrix(program);
        program.press("100 mm");
        program
            .harness
            .get_by_role_and_label(Role::ComboBox, &format!("Unit of {B}"))
            .click();
        program.harness.run();
    });
}

fn type_q_matrix(program: &mut Program) {
    program.press("From lens, FOV or Q…");
    program.choose("What is known", "A Q matrix");
    program.harness.get_by_label("Q matrix").focus();
    program.harness.run();
    let matrix = "[[1. 0. 0. -610.] [0. 1. 0. -350.] [0. 0. 0. 700.] [0. 0. 0.01 0.4]]";
    program.harness.get_by_label("Q matrix").type_text(matrix);
    program.harness.run();
}

#[test]
fn learn_looks_as_before() {
    look("learn", &TOP, |program| program.show("Learn"));
}

#[test]
fn rigs_look_as_before() {
    look("rigs", &TOP, |program| {
        rigs::open(program, Ok(vec![rigs::file("calib.txt", rigs::MIDDLEBURY)]));
        program.press("Add to rigs");
        program.press("New rig");
        program.type_into("Name", "Robot, front");
        program.type_into(FX, "1050");
        program.type_into(B, "6 cm");
        program.blur();
    });
}

#[test]
fn known_sizes_and_cameras_look_as_before() {
    look("known-sizes", &DIALOG, |program| {
        program.press("Known sizes…");
        program.type_into("Search the known sizes", "paper");
        program.blur();
    });
    look("known-cameras", &DIALOG, |program| {
        program.show("Rigs");
        program.press("Add a known camera…");
        program.blur();
    });
}

#[test]
fn another_mode_and_a_stored_depth_look_as_before() {
    look("another-mode", &DIALOG, |program| {
        rigs::open(program, Ok(vec![rigs::file("calib.txt", rigs::MIDDLEBURY)]));
        program.press("Add to rigs");
        program.press("Another mode…");
        program.type_into("Width after resizing or binning", "320");
        program.type_into("Height of the part that is kept", "200");
        program.blur();
    });
    look("stored-depth", &DIALOG, |program| {
        program.mug();
        program.press("OpenCV × 16, doffs…");
        program.choose("What is known", "Depth: steps in a meter");
        program.type_into("Stored value", "1400");
        program.type_into("Steps in a meter", "1000");
        program.blur();
    });
}

#[test]
fn camera_facts_look_as_before() {
    look("camera-facts", &TOP, |program| {
        program.press("From lens, FOV or Q…");
        program.press("Camera facts…");
        program.type_into("Width of the image", "1280");
        program.type_into("Height of the image", "800");
        program.type_into("Horizontal field of view", "71.86");
        program.type_into("Diagonal field of view", "83.76");
        program.blur();
    });
}

#[test]
fn a_calibration_looks_as_before() {
    look("import", &DIALOG, |program| {
        rigs::open(program, Ok(vec![rigs::file("stereo.yml", rigs::OPENCV_IN_SQUARES)]));
        program.choose("The baseline is", "3.2 squares of the board");
        program.blur();
    });
}

#[test]
fn what_is_no_calibration_looks_as_before() {
    look("import-refused", &DIALOG, |program| {
        rigs::open(program, Ok(vec![rigs::file("SN1234.conf", "<!DOCTYPE html><html></html>")]));
        program.blur();
    });
}

#[test]
fn the_keys_look_as_before() {
    look("keys", &DIALOG, |program| program.press("Keys"));
}

#[test]
fn about_looks_as_before() {
    look("about", &DIALOG, |program| {
        program.press("Keys");
        program.press("About Depth Calculator");
    });
}
