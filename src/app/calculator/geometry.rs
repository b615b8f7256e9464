//! What else the distance gives: the point in space and the range that a tape measures, a tilted target, and the ground
//! plane as a third method.

use crate::app::context::AppContext;
use crate::app::saved::Texts;
use crate::app::widgets::number_field::{NumberField, Unit};
use crate::app::widgets::{cards, text};
use crate::core::angle::Angle;
use crate::core::camera::{self, GroundView, Intrinsics, NoGround};
use crate::core::measured::Measured;
use crate::core::quantity::{Length, Pixels};
use crate::formats::inputs::Severity;
use crate::formats::{number, report};
use egui::Ui;

const DEGREES: &str = "°";
const CX: &str = "Principal point cx";
const CY: &str = "Principal point cy";
const U: &str = "Column of the pixel (u)";
const V: &str = "Row of the pixel (v)";
const TILT: &str = "Tilt of the target";
const HEIGHT: &str = "Height of the camera";
const PITCH: &str = "Pitch of the camera, downwards";
const ROW: &str = "Row of the point on the floor";

/// Fills in the principal point, as a Q matrix gives it.
pub fn set_principal_point(texts: &mut Texts, cx: Pixels, cy: Pixels) {
    texts.insert(CX.to_owned(), number::plain(cx.px()));
    texts.insert(CY.to_owned(), number::plain(cy.px()));
}

/// Draws the three cards.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let (columns, gap) = (cx.layout.columns(), cx.layout.gap());
    let parts: [Part; 3] = [range_ui, tilt_ui, ground_ui];
    for (number, row) in parts.chunks(columns).enumerate() {
        let id = egui::Id::unique(("geometry", columns, number));
        cards::row(ui, row, gap, |ui, part| part(ui, cx, id));
    }
}

type Part = fn(&mut Ui, &mut AppContext<'_>, egui::Id);

fn range_ui(ui: &mut Ui, cx: &mut AppContext<'_>, row: egui::Id) {
    let unit = cx.unit();
    let (solution, texts) = (&cx.session.assessment().solution, &mut cx.settings.texts);
    cards::card(ui, "Depth or range", |ui| {
        let numbers = [(CX, "640"), (CY, "360"), (U, "900"), (V, "500")].map(|(name, example)| ask(ui, texts, name, example, "px"));
        let depth = solution.stereo.distance().or(solution.monocular.distance());
        let answer = match (solution.problem.focal_length, depth, numbers) {
            (Some(fx), Some(depth), [Some(cx), Some(cy), Some(u), Some(v)]) => {
                let (cx, cy) = (Pixels::new(cx), Pixels::new(cy));
                let camera = Intrinsics {
                    fx,
                    fy: fx,
                    cx,
                    cy,
                    width: fx,
                    height: fx,
                };
                let (u, v) = (Pixels::new(u), Pixels::new(v));
                camera
                    .point(u, v, depth)
                    .zip(camera.range(u, v, depth))
                    .map(|((x, y), range)| (x, y, depth, range))
            }
            _ => None,
        };
        if let Some((x, y, z, range)) = answer {
            let length = |length: Length| report::length(Some(length), unit);
            super::table::pairs(
                ui,
                "Point and range",
                &[
                    ("X, to the right", length(x)),
                    ("Y, down", length(y)),
                    ("Z, depth along the axis", length(z)),
                    ("R, range from the lens", length(range)),
                ],
            );
        }
        text::caption(
            ui,
            "The distance of this program is the depth Z along the optical axis. A tape held at the lens measures the range R, which is longer away from the middle of the image.",
        );
        cards::fill_height(ui, row);
    });
}

fn tilt_ui(ui: &mut Ui, cx: &mut AppContext<'_>, row: egui::Id) {
    let unit = cx.unit();
    let (solution, texts) = (&cx.session.assessment().solution, &mut cx.settings.texts);
    cards::card(ui, "Tilted target", |ui| {
        let tilt = ask(ui, texts, TILT, "20", DEGREES);
        if let (Some(tilt), Some(apparent)) = (tilt, solution.monocular.distance()) {
            match camera::depth_of_tilted_target(apparent, Angle::from_degrees(tilt)) {
                Some(depth) => {
                    let share = number::significant((apparent.m() / depth.m() - 1.0) * 100.0, 2);
                    super::table::pairs(
                        ui,
                        "Tilted target",
                        &[
                            ("Monocular distance as computed", report::length(Some(apparent), unit)),
                            ("Corrected for the tilt", report::length(Some(depth), unit)),
                            ("Too long without it by", format!("{share} %")),
                        ],
                    );
                }
                None => problem_ui(ui, "A target tilted by 90° or more shows no width. Type an angle below 90°."),
            }
        }
        text::caption(
            ui,
            "A target turned away by an angle looks narrower by its cosine, so the monocular method puts it too far away. The distance is that to the plane of the target’s middle, along the optical axis.",
        );
        cards::fill_height(ui, row);
    });
}

fn ground_ui(ui: &mut Ui, cx: &mut AppContext<'_>, row: egui::Id) {
    let unit = cx.unit();
    let (solution, texts) = (&cx.session.assessment().solution, &mut cx.settings.texts);
    cards::card(ui, "Ground plane, a third method", |ui| {
        let camera_height = ask_measured(ui, texts, HEIGHT, "1.2", "m");
        let pitch = ask_measured(ui, texts, PITCH, "10", DEGREES);
        let point = ask_measured(ui, texts, ROW, "500", "px");
        let cy = ask(ui, texts, CY, "360", "px");
        if let (Some(fx), Some(camera_height), Some(pitch), Some(row), Some(cy)) =
            (solution.problem.focal_length, camera_height, pitch, point, cy)
        {
            let radians = |degrees: f64| Angle::from_degrees(degrees).radians();
            let view = GroundView {
                height: camera_height,
                pitch: Measured::new(radians(pitch.value), radians(pitch.sigma)),
                row,
                fy: fx,
                cy: Pixels::new(cy),
            };
            match view.distance() {
                Ok(distance) => {
                    let words = if distance.sigma > 0.0 {
                        report::with_sigma(Length::from_m(distance.value), Length::from_m(distance.sigma), unit).text(unit)
                    } else {
                        report::length(Some(Length::from_m(distance.value)), unit)
                    };
                    super::table::pairs(ui, "Ground plane", &[("Distance along the floor", words)]);
                }
                Err(NoGround::AboveHorizon) => problem_ui(
                    ui,
                    "This row is at the horizon or above it: its ray never meets the floor. Use a lower row.",
                ),
                Err(NoGround::BelowCamera) => problem_ui(ui, "This ray goes straight down or backwards. Check pitch and row."),
                Err(NoGround::Unusable) => problem_ui(ui, "Height and focal length must be above zero, and no uncertainty below it."),
                Err(NoGround::TooExtreme) => problem_ui(ui, "With these numbers there is no distance that a computer can represent."),
            }
        }
        text::caption(
            ui,
            "D = h / tan(θ + atan((v − cy) / fy)): where the ray of an image row meets a level floor. fy is taken to be fx. Needs neither a second camera nor a known size.",
        );
        cards::fill_height(ui, row);
    });
}

fn problem_ui(ui: &mut Ui, sentence: &str) {
    text::note(ui, Severity::Error, sentence, None);
}

fn ask(ui: &mut Ui, texts: &mut Texts, name: &'static str, example: &'static str, unit: &'static str) -> Option<f64> {
    let typed = texts.entry(name.to_owned()).or_default();
    ui.push_id(name, |ui| {
        NumberField {
            name,
            hint: "",
            example,
            unit: Unit::Fixed(unit),
            signed: unit == DEGREES,
            sigma: None,
        }
        .ui(ui, typed);
    });
    read(typed)
}

fn ask_measured(ui: &mut Ui, texts: &mut Texts, name: &'static str, example: &'static str, unit: &'static str) -> Option<Measured> {
    let sigma_name = format!("σ of {name}");
    let mut sigma = texts.get(&sigma_name).cloned().unwrap_or_default();
    let typed = texts.entry(name.to_owned()).or_default();
    NumberField {
        name,
        hint: "",
        example,
        unit: Unit::Fixed(unit),
        signed: unit == DEGREES,
        sigma: Some(&mut sigma),
    }
    .ui(ui, typed);
    let value = read(typed);
    let sigma_value = read(&sigma).unwrap_or(0.0);
    texts.insert(sigma_name, sigma);
    value.map(|value| Measured::new(value, sigma_value))
}

fn read(text: &str) -> Option<f64> {
    number::read(text).ok().map(|typed| typed.number)
}
