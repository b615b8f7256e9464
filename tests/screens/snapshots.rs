//! How the screens look.

use crate::images;
use crate::llvmpipe::{self, Painter};
use crate::machine::Machine;
use crate::program::{B, D, DESKTOP, FX, PHONE, Program, W_IMG, W_REAL, type_sigma};
use egui::accesskit::Role;
use egui::{Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use image::RgbImage;

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

const DESKTOP_LIGHT: View = view("desktop-light", DESKTOP, false);
const DESKTOP_DARK: View = view("desktop-dark", DESKTOP, true);
const PHONE_LIGHT: View = view("phone-light", PHONE, false);
const PHONE_DARK: View = view("phone-dark", PHONE, true);
const TABLET_LIGHT: View = view("tablet-light", vec2(768.0, 1024.0), false);
const WIDE_DARK: View = view("wide-dark", vec2(1920.0, 1080.0), true);

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

/// A screen with all that scrolls.
const WHOLE: [View; 4] = [DESKTOP_LIGHT, DESKTOP_DARK, PHONE_LIGHT, PHONE_DARK];
/// What a screen shows first.
const TOP: [View; 4] = [
    DESKTOP_LIGHT.only(Part::Window),
    DESKTOP_DARK.only(Part::Window),
    PHONE_LIGHT.only(Part::Window),
    PHONE_DARK.only(Part::Window),
];
/// A dialog.
const DIALOG: [View; 4] = [
    DESKTOP_LIGHT.only(Part::Middle),
    DESKTOP_DARK.only(Part::Middle),
    PHONE_LIGHT.only(Part::Window),
    PHONE_DARK.only(Part::Window),
];

/// Compares a screen in several windows. `prepare` brings the program to where it is drawn.
fn look(screen: &str, views: &[View], prepare: impl Fn(&mut Program)) {
    let mut problems = Vec::new();
    let Some(renderer) = llvmpipe::version() else { return };
    for view in views {
        let Some(painter) = Painter::new() else { return };
        let mut program = open(*view, painter.clone());
        prepare(&mut program);
        program.harness.remove_cursor();
        if matches!(view.part, Part::Whole) {
            program.grow_to_contents(view.size);
        }
        program.harness.run();
        let image = view.cut(painter.draw(&program.harness.ctx, program.harness.output()));
        problems.extend(images::compare(&image, &format!("{screen}-{}", view.name), renderer).err());
    }
    images::report(&problems, renderer);
}

/// Pixels that the widest dialog fits into.
const DIALOG_WIDTH: u32 = 600;

/// The program in a window, light or dark.
fn open(view: View, painter: Painter) -> Program {
    let builder = Harness::builder().with_size(view.size).with_pixels_per_point(1.0).renderer(painter);
    let machine = Machine {
        commit: Some("0123456789abcdef"),
        ..Machine::default()
    };
    let mut program = Program::build(machine, builder);
    // Letters in four positions between two pixels each would make the files a quarter larger.
    let all_styles = |style: &mut egui::Style| style.visuals.text_options.subpixel_binning = false;
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
        let nodes = self.harness.root().children_recursive();
        let bottoms = nodes
            .filter(|node| node.accesskit_node().raw_bounds().is_some())
            .map(|node| node.rect().bottom());
        let bottom = bottoms.fold(size.y - BARS, f32::max);
        self.harness.set_size(vec2(size.x, (bottom + BARS).ceil().min(TALL)));
        self.harness.run();
    }
}

#[test]
fn the_empty_calculator_looks_as_before() {
    look("empty", &TOP, |_| {});
}

#[test]
fn the_mug_looks_as_before() {
    let views = [&WHOLE[..], &[TABLET_LIGHT, WIDE_DARK]].concat();
    look("mug", &views, |program| {
        program.mug();
        program.blur();
    });
}

#[test]
fn both_methods_with_uncertainty_and_geometry_look_as_before() {
    look("everything", &WHOLE, |program| {
        program.mug();
        program.type_into(W_IMG, "150");
        program.type_into(W_REAL, "0.30");
        program.press("Add uncertainty");
        for (field, sigma) in [(FX, "2"), (B, "0.5"), (D, "12"), (W_IMG, "30"), (W_REAL, "0.01")] {
            type_sigma(program, field, sigma);
        }
        fill_geometry(program);
        program.blur();
        // Simulations, and what moves.
        program.harness.run_steps(60);
        assert_eq!(program.text().matches("100\u{a0}000 draws").count(), 2, "{}", program.text());
    });
}

fn fill_geometry(program: &mut Program) {
    program.press("Range, tilt, ground plane");
    for (field, text) in [
        ("Principal point cx", "640"),
        ("Principal point cy", "360"),
        ("Column of the pixel (u)", "900"),
        ("Row of the pixel (v)", "500"),
        ("Tilt of the target", "20"),
        ("Height of the camera", "1.2"),
        ("Pitch of the camera, downwards", "10"),
        ("Row of the point on the floor", "500"),
    ] {
        program.type_into(field, text);
    }
    for (field, sigma) in [
        ("Height of the camera", "0.01"),
        ("Pitch of the camera, downwards", "0.5"),
        ("Row of the point on the floor", "1"),
    ] {
        type_sigma(program, field, sigma);
    }
}

#[test]
fn errors_and_warnings_look_as_before() {
    look("errors", &WHOLE, |program| {
        program.type_into(FX, "1,000");
        program.type_into(B, "0.1");
        program.type_into(D, "abc");
        program.type_into(W_IMG, "150");
        program.press("Calculate Distance");
    });
}

#[test]
fn the_card_with_whole_notes_looks_as_before() {
    look("note", &[TOP[0], TOP[3]], |program| {
        program.press("Add uncertainty");
        program.type_into(FX, "-7,000");
        type_sigma(program, FX, "many");
    });
}

#[test]
fn solving_for_another_quantity_looks_as_before() {
    look("unknown", &WHOLE, |program| {
        program.type_into(FX, "700");
        program.type_into(B, "100");
        program.press("Solve for another quantity");
        program.type_into("Distance (D)", "1.4");
        program.blur();
    });
}

#[test]
fn the_helper_for_the_focal_length_looks_as_before() {
    look("focal-length", &DIALOG, |program| {
        program.press("from lens, FOV or Q…");
        program.type_into("Focal length of the lens", "4");
        program.type_into("Pixel pitch", "3");
        program.blur();
    });
}

#[test]
fn the_helper_for_the_disparity_looks_as_before() {
    look("disparity", &DIALOG, |program| {
        program.press("OpenCV ×16, doffs…");
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
    program.press("from lens, FOV or Q…");
    program.choose("What is known", "A Q matrix");
    program.harness.get_by_label("Q matrix").focus();
    program.harness.run();
    let matrix = "[[1. 0. 0. -610.] [0. 1. 0. -350.] [0. 0. 0. 700.] [0. 0. 0.01 0.4]]";
    program.harness.get_by_label("Q matrix").type_text(matrix);
    program.harness.run();
}

#[test]
fn learn_looks_as_before() {
    look("learn", &TOP, |program| program.press("Learn"));
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
