//! What a frame costs, from input to triangles (drawing them is the graphics card's): `cargo bench --bench frames`.
//!
//! The screen is the busiest: the calculator with both methods, the uncertainty of every input, and range and tilt.
//! Accessibility is switched on, as it is on the web page. Aim: at most 4 ms.
#![allow(clippy::unwrap_used, missing_docs, reason = "a measurement")]

use depth_calculator::app::{App, FileContents, Licenses, Place, Platform, PlatformError};
use depth_calculator::core::problem::Field;
use depth_text::fields;
use depth_text::form::{Example, Inputs};
use divan::Bencher;
use eframe::App as _;
use egui::accesskit::{Action, ActionRequest, Node, NodeId, Role, TreeId};
use egui::{ClippedPrimitive, Event, Key, Modifiers, Pos2, RawInput, Rect, Vec2, vec2};
use serde_json::json;

const DESKTOP: Vec2 = vec2(1280.0, 900.0);
const PHONE: Vec2 = vec2(390.0, 844.0);
/// More than the frames that a simulation takes.
const FRAMES_TO_REST: usize = 60;

fn main() {
    divan::main();
}

/// A machine that has stored `state`, and stores nothing.
struct Machine {
    state: Option<String>,
}

impl Platform for Machine {
    fn load(&self) -> Result<Option<String>, PlatformError> {
        Ok(self.state.clone())
    }
    fn save(&mut self, _text: &str) -> Result<(), PlatformError> {
        Ok(())
    }
    fn set_aside(&mut self) -> Result<Option<Place>, PlatformError> {
        Ok(None)
    }
    fn seconds(&self) -> f64 {
        0.0
    }
    fn commit(&self) -> Option<String> {
        None
    }
    fn licenses(&self) -> Licenses {
        Licenses::Text("")
    }
    fn copy(&mut self, _ctx: &egui::Context, _text: String) {}
    fn save_file(&mut self, _ctx: &egui::Context, _name: &str, _contents: FileContents) {}
    fn open_files(&mut self, _ctx: &egui::Context) {}
    fn start(&mut self, _ctx: &egui::Context, _run: depth_jobs::Run, _job: depth_jobs::Job, _attachments: Vec<depth_jobs::Attachment>) {}
    fn cancel(&mut self, _ctx: &egui::Context, _run: depth_jobs::Run) {}
    fn print(&mut self) -> bool {
        false
    }
    fn today(&self) -> String {
        "November 25, 2026".to_owned()
    }
    fn address(&self) -> String {
        "https://example.org/".to_owned()
    }
    fn events(&mut self) -> Vec<depth_calculator::app::Event> {
        Vec::new()
    }
}

/// The form filled in, each input known to `sigma`.
fn filled(sigma: &str) -> String {
    let mut inputs: Inputs = Example::CoffeeMug.inputs();
    inputs.entry_mut(Field::ImageWidth).text = "150".into();
    inputs.entry_mut(Field::RealWidth).text = "0.3".into();
    for field in Field::ALL {
        inputs.set_sigma(field, sigma);
    }
    let entries = json!({
        "cx": { "text": "640" }, "cy": { "text": "360" }, "u": { "text": "900" }, "v": { "text": "500" }, "tilt": { "text": "20" },
    });
    json!({
        "version": 2, "inputs": inputs, "result_unit": "m", "theme": "light", "screen": "calculator", "shows_refinements": true, "entries": entries,
    })
    .to_string()
}

struct Program {
    ctx: egui::Context,
    app: App,
    frame: eframe::Frame,
    size: Vec2,
    nodes: Vec<(NodeId, Node)>,
}

impl Program {
    fn start(state: Option<String>, size: Vec2) -> Self {
        let ctx = egui::Context::default();
        ctx.enable_accesskit();
        let cc = eframe::CreationContext::_new_kittest(ctx.clone());
        let app = App::new(&cc, Box::new(Machine { state }));
        Self {
            ctx,
            app,
            frame: eframe::Frame::_new_kittest(),
            size,
            nodes: Vec::new(),
        }
    }

    fn frame(&mut self, events: Vec<Event>) -> Vec<ClippedPrimitive> {
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, self.size)),
            events,
            ..Default::default()
        };
        let ctx = self.ctx.clone();
        let output = ctx.run_ui(input, |ui| {
            self.app.logic(ui.ctx(), &mut self.frame);
            self.app.ui(ui, &mut self.frame);
        });
        let triangles = ctx.tessellate(output.shapes, output.pixels_per_point);
        self.nodes = output.platform_output.accesskit_update.unwrap().nodes;
        triangles
    }

    /// The field that the label `name` belongs to.
    fn field(&self, name: &str) -> Option<&(NodeId, Node)> {
        let labels: Vec<NodeId> = self
            .nodes
            .iter()
            .filter(|(_, node)| node.value() == Some(name))
            .map(|(id, _)| *id)
            .collect();
        let named = |node: &Node| node.label() == Some(name) || node.labelled_by().iter().any(|label| labels.contains(label));
        let is_field = |node: &Node| matches!(node.role(), Role::NumberInput | Role::TextInput);
        self.nodes.iter().find(|(_, node)| is_field(node) && named(node))
    }

    fn disparity(&self) -> (NodeId, Option<String>) {
        let (id, node) = self.field(fields::DISPARITY.name).unwrap();
        (*id, node.value().map(str::to_owned))
    }

    /// At rest with everything shown.
    fn busy(sigma: &str, size: Vec2) -> Self {
        let mut program = Self::start(Some(filled(sigma)), size);
        for _ in 0..FRAMES_TO_REST {
            program.frame(Vec::new());
        }
        assert!(program.field(fields::TILT.name).is_some(), "the refinements are shown");
        program
    }

    /// With the disparity under the keyboard.
    fn typing(sigma: &str, size: Vec2) -> Self {
        let mut program = Self::busy(sigma, size);
        let request = ActionRequest {
            action: Action::Focus,
            target_tree: TreeId::ROOT,
            target_node: program.disparity().0,
            data: None,
        };
        program.frame(vec![Event::AccessKitActionRequest(request)]);
        program.frame(Vec::new());
        let before = program.disparity();
        program.step(true);
        program.frame(Vec::new());
        assert_ne!(program.disparity(), before, "the key changes the disparity");
        program
    }

    /// A frame in which the disparity becomes larger (`up`) or smaller by one step.
    fn step(&mut self, up: bool) -> Vec<ClippedPrimitive> {
        let event = Event::Key {
            key: if up { Key::ArrowUp } else { Key::ArrowDown },
            physical_key: None,
            pressed: true,
            repeat: false,
            modifiers: Modifiers::NONE,
        };
        self.frame(vec![event])
    }
}

/// Nothing has changed since the frame before.
#[divan::bench(args = ["desktop", "phone"])]
fn unchanged(bencher: Bencher, screen: &str) {
    let mut program = Program::busy("1 %", size(screen));
    bencher.bench_local(|| program.frame(Vec::new()));
}

/// The disparity changes, and with it every number and picture.
#[divan::bench(args = ["desktop", "phone"])]
fn changed(bencher: Bencher, screen: &str) {
    let mut program = Program::typing("1 %", size(screen));
    let mut up = false;
    bencher.bench_local(|| {
        up = !up;
        program.step(up)
    });
}

/// The same where the distances are so uncertain that two simulations start anew and go on.
#[divan::bench(args = ["desktop", "phone"])]
fn changed_and_simulated(bencher: Bencher, screen: &str) {
    let mut program = Program::typing("20 %", size(screen));
    let mut up = false;
    let mut frames = 0_u32;
    bencher.bench_local(|| {
        frames += 1;
        if frames.is_multiple_of(FRAMES_OF_A_STEP) {
            up = !up;
            program.step(up)
        } else {
            program.frame(Vec::new())
        }
    });
}

/// Time for both simulations to end, and a few frames of rest.
const FRAMES_OF_A_STEP: u32 = 50;

/// From nothing to the first frame, fonts and all: what starting costs besides downloading and compiling.
#[divan::bench(args = ["empty", "filled"])]
fn start_to_first_frame(bencher: Bencher, form: &str) {
    bencher
        .with_inputs(|| (form == "filled").then(|| filled("1 %")))
        .bench_local_values(|state| {
            let mut program = Program::start(state, DESKTOP);
            (program.frame(Vec::new()), program)
        });
}

fn size(screen: &str) -> Vec2 {
    if screen == "phone" { PHONE } else { DESKTOP }
}
