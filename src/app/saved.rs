//! The state that survives a reload and a restart, and its text form.

use super::rigs::RigList;
use super::sentences::PlatformError;
use crate::core::quantity::LengthUnit;
use depth_text::camera_sheet::CameraSheet;
use depth_text::entry::Entries;
use depth_text::field::Key;
use depth_text::form::Inputs;
use depth_text::report::strip::Mode;
use depth_text::version1;
use egui::ThemePreference;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The screens of the program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Screen {
    /// The form and its results.
    #[default]
    Calculator,
    /// Cameras and pairs of them, kept.
    Rigs,
    /// The formulas, explained.
    Learn,
}

impl Screen {
    /// Every screen, in the order of the tabs.
    pub const ALL: [Self; 3] = [Self::Calculator, Self::Rigs, Self::Learn];

    /// The text of its tab.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Calculator => "Calculator",
            Self::Rigs => "Rigs",
            Self::Learn => "Learn",
        }
    }

    /// The title of the window in which it is shown.
    pub fn title(self) -> String {
        match self {
            Self::Calculator => PROGRAM.to_owned(),
            other => format!("{} – {PROGRAM}", other.name()),
        }
    }
}

/// The name of the program.
pub const PROGRAM: &str = "Depth Calculator";

/// What a person chose, beside what was typed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Settings {
    /// The unit of the results.
    pub result_unit: LengthUnit,
    /// Light, dark, or as the system has it.
    pub theme: ThemePreference,
    /// The screen last shown.
    pub screen: Screen,
    /// What is asked for, where nothing is solved for; see [`Self::mode`].
    pub chosen_mode: Mode,
    /// Whether range, tilt and zero point are shown.
    pub shows_refinements: bool,
    /// What was typed into helpers and into range, tilt and ground plane.
    pub entries: Entries,
    /// The way chosen in each helper.
    pub ways: Ways,
    /// The rigs that are kept.
    pub rigs: RigList,
    /// What is stated of a camera.
    pub sheet: CameraSheet,
}

/// The key of the chosen way, by that of the helper.
pub type Ways = BTreeMap<String, String>;

impl Default for Settings {
    fn default() -> Self {
        Self {
            result_unit: LengthUnit::Meter,
            theme: ThemePreference::System,
            screen: Screen::Calculator,
            chosen_mode: Mode::Distance,
            shows_refinements: false,
            entries: Entries::default(),
            ways: Ways::new(),
            rigs: RigList::default(),
            sheet: CameraSheet::default(),
        }
    }
}

impl Settings {
    /// What is asked for with `inputs`: another quantity wherever one is solved for, however that came about.
    pub fn mode(&self, inputs: &Inputs) -> Mode {
        match self.chosen_mode {
            _ if inputs.unknown.is_some() => Mode::Quantity,
            Mode::Quantity => Mode::Distance,
            chosen => chosen,
        }
    }
}

/// The state that is stored.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Saved {
    /// What was typed.
    pub inputs: Inputs,
    /// What was chosen.
    pub settings: Settings,
}

/// The version of the stored text. Version 1 is still read, a text of any other is not.
const VERSION: u32 = 2;

/// The version of a stored text, which decides how the rest of it is parsed.
#[derive(Deserialize)]
struct StoredVersion {
    version: u32,
}

/// The form of the stored text. Unknown and missing fields are errors: such a text was not stored by this version.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Stored {
    version: u32,
    inputs: Inputs,
    result_unit: LengthUnit,
    theme: StoredTheme,
    screen: Screen,
    #[serde(default)]
    mode: Mode,
    #[serde(default)]
    shows_refinements: bool,
    /// What earlier programs showed beside the distance.
    #[serde(default, skip_serializing)]
    shows_geometry: bool,
    #[serde(default, skip_serializing)]
    #[allow(dead_code, reason = "an earlier program stored it")]
    shows_two: bool,
    #[serde(default)]
    entries: Entries,
    #[serde(default)]
    ways: Ways,
    #[serde(default)]
    rigs: RigList,
    #[serde(default)]
    sheet: CameraSheet,
}

/// The stored text of version 1, which kept texts by the English labels of their fields.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StoredVersion1 {
    version: u32,
    inputs: version1::StoredInputs,
    result_unit: LengthUnit,
    theme: StoredTheme,
    screen: Screen,
    #[serde(default)]
    shows_geometry: bool,
    #[serde(default)]
    texts: BTreeMap<String, String>,
}

impl From<StoredVersion1> for Stored {
    fn from(stored: StoredVersion1) -> Self {
        Self {
            version: stored.version,
            inputs: stored.inputs.into(),
            result_unit: stored.result_unit,
            theme: stored.theme,
            screen: stored.screen,
            mode: Mode::Distance,
            shows_refinements: false,
            shows_geometry: stored.shows_geometry,
            shows_two: false,
            rigs: RigList::default(),
            sheet: CameraSheet::default(),
            ways: version1::ways(&stored.texts),
            entries: version1::entries(stored.texts),
        }
    }
}

#[derive(Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum StoredTheme {
    System,
    Light,
    Dark,
}

impl Saved {
    /// The text to store (JSON).
    ///
    /// # Errors
    /// The error of the serializer, in the unlikely case that there is one.
    pub fn to_text(&self) -> Result<String, PlatformError> {
        serde_json::to_string(&Stored {
            version: VERSION,
            inputs: self.inputs.clone(),
            result_unit: self.settings.result_unit,
            theme: match self.settings.theme {
                ThemePreference::System => StoredTheme::System,
                ThemePreference::Light => StoredTheme::Light,
                ThemePreference::Dark => StoredTheme::Dark,
            },
            screen: self.settings.screen,
            mode: self.settings.chosen_mode,
            shows_refinements: self.settings.shows_refinements,
            shows_geometry: false,
            shows_two: false,
            entries: self.settings.entries.clone(),
            ways: self.settings.ways.clone(),
            rigs: self.settings.rigs.clone(),
            sheet: self.settings.sheet.clone(),
        })
        .map_err(|error| PlatformError::NotSerialized { reason: error.to_string() })
    }

    /// What was stored as `text`; `None` where it is corrupt or of another version.
    pub fn from_text(text: &str) -> Option<Self> {
        let StoredVersion { version } = serde_json::from_str(text).ok()?;
        match version {
            1 => serde_json::from_str::<StoredVersion1>(text)
                .ok()
                .map(|stored| Stored::from(stored).into()),
            VERSION => serde_json::from_str::<Stored>(text).ok().map(Self::from),
            _ => None,
        }
    }
}

impl From<Stored> for Saved {
    fn from(mut stored: Stored) -> Self {
        // Once the fields of range, tilt and ground plane were no part of the form.
        for key in Key::form() {
            if let Some(entry) = stored.entries.remove(key) {
                *stored.inputs.entry_mut(key) = entry;
            }
        }
        Self {
            inputs: stored.inputs,
            settings: Settings {
                result_unit: stored.result_unit,
                theme: match stored.theme {
                    StoredTheme::System => ThemePreference::System,
                    StoredTheme::Light => ThemePreference::Light,
                    StoredTheme::Dark => ThemePreference::Dark,
                },
                screen: stored.screen,
                chosen_mode: stored.mode,
                shows_refinements: stored.shows_refinements || stored.shows_geometry,
                entries: stored.entries,
                ways: stored.ways,
                rigs: stored.rigs,
                sheet: stored.sheet,
            },
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::app::rigs::Rig;
    use depth_text::entry::Entry;
    use depth_text::field::Key;
    use depth_text::fields;
    use depth_text::form::Example;

    fn entries(typed: &[(Key, &str, &str)]) -> Entries {
        let mut entries = Entries::default();
        for &(key, text, sigma) in typed {
            entries.entry_mut(key).text = text.into();
            entries.entry_mut(key).sigma = sigma.into();
        }
        entries
    }

    #[test]
    fn what_is_stored_comes_back() {
        let saved = Saved {
            inputs: Example::Doorway.inputs(),
            settings: Settings {
                result_unit: LengthUnit::Foot,
                theme: ThemePreference::Dark,
                screen: Screen::Learn,
                chosen_mode: Mode::TwoShots,
                shows_refinements: true,
                entries: entries(&[(fields::LENS, "4", "")]),
                ways: Ways::from([("d".into(), "kitti".into())]),
                sheet: CameraSheet::default(),
                rigs: RigList {
                    all: vec![Rig {
                        name: "Robot".into(),
                        inputs: Example::CoffeeMug.inputs(),
                        ..Rig::default()
                    }],
                    shown: 0,
                    moves: 0,
                },
            },
        };
        assert_eq!(Saved::from_text(&saved.to_text().unwrap()), Some(saved));
    }

    /// As the program wrote it when its fields had no keys.
    const VERSION_1: &str = r#"{"version":1,"inputs":{"focal_length":{"text":"700"},"baseline":{"text":"10","unit":"cm"},"disparity":{"text":""},"doffs":{"text":""},"image_width":{"text":"150"},"real_width":{"text":"","unit":"m"},"sigmas":{"FocalLength":"2","Baseline":"0.5 %"},"with_uncertainty":true,"unknown":["Stereo","Disparity"],"distance":{"text":"1.4","unit":"ft"},"distance_sigma":"1 %"},"result_unit":"in","theme":"dark","screen":"learn","shows_geometry":true,"texts":{"Principal point cx":"640","Pitch of the camera, downwards":"10","σ of Pitch of the camera, downwards":"0,5","Focal length of the lens":"4","Q matrix":"1 0 0","way: FocalLength":"Lens and sensor width","way: Disparity":"KITTI, 16-bit image","Of nothing known":"7"}}"#;

    #[test]
    fn what_version_1_stored_is_read() {
        use crate::core::problem::{Field, Method};
        let saved = Saved::from_text(VERSION_1).unwrap();
        let sigma = |entry: Entry, sigma: &str| Entry {
            sigma: sigma.into(),
            ..entry
        };
        for (key, entry) in [
            (fields::FOCAL_LENGTH, sigma(Entry::new("700", None), "2")),
            (fields::BASELINE, sigma(Entry::new("10", Some(LengthUnit::Centimeter)), "0.5 %")),
            (fields::DISPARITY, Entry::new("", None)),
            (fields::IMAGE_WIDTH, Entry::new("150", None)),
            (fields::DISTANCE, sigma(Entry::new("1.4", Some(LengthUnit::Foot)), "1 %")),
        ] {
            assert_eq!(saved.inputs.entry(key), &entry, "{key:?}");
        }
        assert_eq!(saved.inputs.unknown, Some((Method::Stereo, Field::Disparity)));
        assert_eq!(
            (saved.settings.result_unit, saved.settings.theme, saved.settings.screen),
            (LengthUnit::Inch, ThemePreference::Dark, Screen::Learn)
        );
        // Range, tilt and ground plane are part of the form now.
        assert_eq!(saved.inputs.entry(fields::CX), &Entry::new("640", None));
        assert_eq!(saved.inputs.entry(fields::CAMERA_PITCH), &sigma(Entry::new("10", None), "0,5"));
        let typed = [(fields::LENS, "4", ""), (fields::Q_MATRIX, "1 0 0", "")];
        assert_eq!(saved.settings.entries, entries(&typed));
        let ways = [("d".to_owned(), "kitti".to_owned()), ("fx".to_owned(), "sensor-width".to_owned())];
        assert_eq!(saved.settings.ways, Ways::from(ways));
        // From now on it is stored as every other text.
        let text = saved.to_text().unwrap();
        assert!(text.starts_with("{\"version\":2,"), "{text}");
        assert_eq!(Saved::from_text(&text), Some(saved));
    }

    #[test]
    fn corrupt_and_older_texts_are_not_read() {
        let good = Saved::default().to_text().unwrap();
        for bad in [
            "",
            "null",
            "{}",
            "[1,2",
            "\u{0}",
            &good.replace("\"version\":2", "\"version\":0"),
            &good.replace("\"version\":2", "\"version\":3"),
            &VERSION_1.replace("\"in\"", "\"parsec\""),
            &good.replace("\"m\"", "\"parsec\""),
        ] {
            assert_eq!(Saved::from_text(bad), None, "{bad}");
        }
    }
}
