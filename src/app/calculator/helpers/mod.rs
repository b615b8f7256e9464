//! The helper dialogs, which compute an input from other numbers: the choice of a way, its fields, and the button that uses the result.

mod q_matrix;

use crate::app::command::{Command, Helper};
use crate::app::context::AppContext;
use crate::app::dialog::{Destination, Dialog, DialogFrame, close_button_ui};
use crate::app::saved::{Settings, Ways};
use crate::app::sentences::Hint;
use crate::app::theme;
use crate::app::widgets::field::{self, Field};
use crate::app::widgets::menu::List;
use crate::app::widgets::{common, main_button, scroll, text};
use crate::core::q_matrix::StereoGeometry;
use crate::core::quantity::LengthUnit;
use depth_text::assess::Assessment;
use depth_text::choices::MATCHING_ERRORS;
use depth_text::entry::Entry;
use depth_text::fields;
use depth_text::note::{Issue, Note};
use depth_text::number::plain;
use depth_text::reading::{self, Reading};
use depth_text::report;
use depth_text::ways::{BASELINES, DISPARITIES, FOCAL_LENGTHS, Way, WayResult};
use egui::Ui;

/// Its name in what is stored.
const fn key(helper: Helper) -> &'static str {
    match helper {
        Helper::FocalLength => "fx",
        Helper::Baseline => "b",
        Helper::Disparity => "d",
        Helper::Size => "wreal",
    }
}

const fn ways(helper: Helper) -> &'static [Way] {
    match helper {
        Helper::FocalLength => FOCAL_LENGTHS,
        Helper::Baseline => BASELINES,
        Helper::Disparity => DISPARITIES,
        Helper::Size => &[],
    }
}

/// The Q matrix is listed with the ways to a focal length, though it gives more than that.
const Q_MATRIX: &str = "A Q matrix of stereoRectify";

/// Draws the helper over the screen.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>, helper: Helper, solved: &Solved) {
    let frame = DialogFrame {
        id: "helper",
        title: helper.title(),
        max_width: theme::HELPER_WIDTH,
    };
    let cancel = Command::Help(None);
    let response = frame.ui(ui, |ui| {
        ui.spacing_mut().interact_size.y = cx.layout.control_height();
        ui.add_space(2.0 * theme::STEP);
        let height = ui.ctx().content_rect().height() - theme::HELPER_FRAME_HEIGHT;
        let mut way = None;
        scroll::up_to_ui(ui, height, |ui| {
            way = way_choice_ui(ui, helper, &mut cx.settings.ways);
            match way {
                Some(way) => way_ui(ui, cx, way, solved.of_way(way)),
                None => q_matrix::ui(ui, cx, solved.q_matrix.as_ref(), solved.square.as_ref()),
            }
            if helper == Helper::Disparity {
                typical_errors_ui(ui, cx);
            }
        });
        ui.add_space(theme::STEP);
        ui.horizontal_wrapped(|ui| {
            if let Some(way) = way {
                use_ui(ui, cx, way, solved.of_way(way));
            }
            let closes = close_button_ui(ui, cancel.text(), cx.layout);
            if helper == Helper::FocalLength {
                other_ways_ui(ui, cx);
            }
            closes
        })
        .inner
    });
    if response.inner || response.should_close() {
        cx.commands.push(cancel);
    }
}

/// The ways from here to a calibration file and to a known camera, which have the baseline too, and to all facts of a camera.
fn other_ways_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let dialogs = [
        Dialog::Presets(Destination::Calculator),
        Dialog::CameraFacts(Destination::Calculator),
    ];
    let dialogs = dialogs.map(|dialog| Command::ShowDialog(Some(dialog)));
    for open in std::iter::once(Command::ShowImport).chain(dialogs) {
        if text::link_button_ui(ui, open.text(), cx.layout).clicked() {
            cx.commands.extend([Command::Help(None), open]);
        }
    }
}

/// What can be chosen in `helper`: the keys and names of its ways, and at the end the Q matrix where it is offered.
fn choices(helper: Helper) -> Vec<(&'static str, &'static str)> {
    let named = |way: &'static Way| (way.key, way.name);
    let q_matrix = (helper == Helper::FocalLength).then_some((fields::Q_MATRIX.as_str(), Q_MATRIX));
    ways(helper).iter().map(named).chain(q_matrix).collect()
}

/// Chooses the way with this key in `helper`.
pub fn choose(made: &mut Ways, helper: Helper, way: &str) {
    made.insert(key(helper).to_owned(), way.to_owned());
}

/// The key and name of the choice in `helper`: the one made last, else the first.
fn chosen(helper: Helper, made: &Ways) -> (&'static str, &'static str) {
    let choices = choices(helper);
    let last = made.get(key(helper));
    let same = choices.iter().find(|(key, _)| last.is_some_and(|last| last == key));
    same.or(choices.first()).copied().unwrap_or_default()
}

/// The result of the way that is chosen in the open helper. The logic computes it before the frame is drawn.
#[derive(Debug, Default)]
pub struct Solved {
    /// The key of the way that was chosen.
    way: &'static str,
    result: WayResult,
    /// `None` where no matrix was typed.
    q_matrix: Option<Result<StereoGeometry, Issue>>,
    /// The size of a square of the board, where the matrix may be in squares.
    square: Option<Result<Reading, Note>>,
}

impl Solved {
    /// Computes the result of the way that is chosen in `helper`, with what the form knows of the cameras.
    pub fn new(helper: Helper, settings: &Settings, assessment: &Assessment) -> Self {
        let way = Way::named(ways(helper), chosen(helper, &settings.ways).0);
        // Without what is solved for: it followed from what is to be replaced.
        let unknown = assessment.unknown.as_ref();
        let form = unknown.map_or(&assessment.solution.problem, |unknown| &unknown.given);
        let matrix = settings.entries.entry(fields::Q_MATRIX);
        Self {
            way: way.map_or("", |way| way.key),
            result: way.map(|way| way.solve(&settings.entries, form)).unwrap_or_default(),
            square: reading::read(fields::SQUARE_SIZE, settings.entries.entry(fields::SQUARE_SIZE)).transpose(),
            q_matrix: (helper == Helper::FocalLength && way.is_none() && !matrix.is_blank())
                .then(|| depth_text::q_matrix::read(&matrix.text)),
        }
    }

    /// The result of `way`; empty where another way was chosen when the frame began.
    fn of_way(&self, way: &Way) -> &WayResult {
        static NOTHING: WayResult = WayResult {
            value: None,
            view: None,
            distance: None,
            depth: None,
            missing: Vec::new(),
            readings: Vec::new(),
            notes: Vec::new(),
        };
        if self.way == way.key { &self.result } else { &NOTHING }
    }
}

/// The choice among the ways of `helper`. Returns the chosen one; `None` is the Q matrix.
fn way_choice_ui(ui: &mut Ui, helper: Helper, made: &mut Ways) -> Option<&'static Way> {
    let before = chosen(helper, made);
    let all = choices(helper);
    let names: Vec<String> = all.iter().map(|choice| choice.1.to_owned()).collect();
    let list = List {
        name: "What is known",
        shown: before.1,
        width: ui.available_width(),
        names: &names,
        chosen: all.iter().position(|choice| *choice == before),
    };
    let (_, now) = list.ui(ui, ("way", key(helper)));
    let now = now.and_then(|at| all.get(at)).copied().unwrap_or(before);
    if now != before {
        made.insert(key(helper).to_owned(), now.0.to_owned());
    }
    ui.add_space(2.0 * theme::STEP);
    Way::named(ways(helper), now.0)
}

fn way_ui(ui: &mut Ui, cx: &mut AppContext<'_>, way: &Way, result: &WayResult) {
    for &key in way.asks {
        let field = Field {
            key,
            entry: cx.settings.entries.entry_mut(key),
            reading: result.readings.iter().find(|reading| reading.key == key),
            notes: result.notes.iter().filter(|note| note.key == key).collect(),
            with_sigma: false,
            helper: None,
            id: field::id(key),
            submits: false,
            following: None,
        };
        field.ui(ui, cx.commands);
        ui.add_space(theme::STEP);
        if key == fields::SENSOR_WIDTH
            && let Some(format) = common::sensor_formats_ui(ui)
        {
            *cx.settings.entries.entry_mut(key) = Entry::new(plain(format.width_mm), Some(LengthUnit::Millimeter));
        }
        if key == fields::STEPS_PER_METER
            && let Some(steps) = common::depth_scales_ui(ui)
        {
            *cx.settings.entries.entry_mut(key) = Entry::new(plain(steps), None);
        }
    }
    if let Some(view) = result.view {
        text::caption_ui(ui, Hint::View { view }.to_string());
    }
    if let Some(hint) = decoded(way, result, cx.unit()) {
        text::caption_ui(ui, hint.to_string());
    }
    text::caption_ui(ui, way.remark);
}

/// What a disparity is to the cameras of the form, or a depth in other words.
fn decoded(way: &Way, result: &WayResult, unit: LengthUnit) -> Option<Hint> {
    let disparity = result.value.map(|value| way.result_text(value));
    match (result.depth, disparity, result.distance) {
        (Some(depth), disparity, _) => Some(Hint::StoredDepth {
            depth: report::length(Some(depth), unit),
            disparity,
            missing: result.missing.clone(),
        }),
        (None, Some(disparity), Some(distance)) => Some(Hint::SeenAt {
            disparity,
            distance: report::length(Some(distance), unit),
            has_own_camera: way.own_camera().is_some(),
        }),
        _ => (!result.missing.is_empty()).then(|| Hint::NoDepthWithout {
            missing: result.missing.clone(),
        }),
    }
}

/// The button that takes what `way` has worked out.
fn use_ui(ui: &mut Ui, cx: &mut AppContext<'_>, way: &Way, result: &WayResult) {
    let symbol = way.target.symbol;
    let label = result
        .value
        .map_or_else(|| format!("Use as {symbol}"), |value| format!("Use {}", way.result_text(value)));
    if main_button::ui(ui, &label, result.value.is_some())
        && let Some(value) = result.value
    {
        let also = way.also(&cx.settings.entries);
        cx.commands.push(Command::FillIn(
            std::iter::once((way.target, way.entry(value))).chain(also).collect(),
        ));
    }
}

/// A choice among the matching errors that people state, for the σ of the disparity.
fn typical_errors_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    ui.add_space(2.0 * theme::STEP);
    text::caption_ui(ui, Hint::MatchingErrors.to_string());
    let sigma = &mut cx.session.inputs.entry_mut(fields::DISPARITY).sigma;
    let names: Vec<String> = MATCHING_ERRORS
        .iter()
        .map(|(px, source)| format!("± {} px: {source}", plain(*px)))
        .collect();
    let chosen = MATCHING_ERRORS.iter().position(|(px, _)| *sigma == plain(*px));
    let list = List {
        name: "Typical matching errors",
        shown: chosen
            .and_then(|at| names.get(at))
            .map_or("Typical matching errors…", String::as_str),
        width: ui.available_width(),
        names: &names,
        chosen,
    };
    let (_, now) = list.ui(ui, "typical matching errors");
    if let Some((px, _)) = now.and_then(|at| MATCHING_ERRORS.get(at)) {
        *sigma = plain(*px);
        cx.commands.push(Command::Settle);
    }
}
