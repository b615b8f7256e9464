//! The state that survives a reload and a restart, and its text form.

use crate::core::quantity::LengthUnit;
use crate::formats::inputs::Inputs;
use egui::ThemePreference;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The screens of the program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Screen {
    /// The form and its results.
    #[default]
    Calculator,
    /// What the numbers mean.
    Learn,
}

impl Screen {
    /// Every screen, in the order of the tabs.
    pub const ALL: [Self; 2] = [Self::Calculator, Self::Learn];

    /// The text of its tab.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Calculator => "Calculator",
            Self::Learn => "Learn",
        }
    }
}

/// What a person chose, beside what was typed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Settings {
    /// The unit of the results.
    pub result_unit: LengthUnit,
    /// Light, dark, or as the system has it.
    pub theme: ThemePreference,
    /// The screen last shown.
    pub screen: Screen,
    /// Whether range, tilt and ground plane are shown.
    pub shows_geometry: bool,
    /// What was typed into helpers and into range, tilt and ground plane, by name.
    pub texts: Texts,
}

/// Texts by the name of the field that they were typed into.
pub type Texts = BTreeMap<String, String>;

impl Default for Settings {
    fn default() -> Self {
        Self {
            result_unit: LengthUnit::Metre,
            theme: ThemePreference::System,
            screen: Screen::Calculator,
            shows_geometry: false,
            texts: Texts::new(),
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

/// The version of the stored text. A text of another version is not read.
const VERSION: u32 = 1;

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
    shows_geometry: bool,
    #[serde(default)]
    texts: Texts,
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
    pub fn to_text(&self) -> Result<String, String> {
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
            shows_geometry: self.settings.shows_geometry,
            texts: self.settings.texts.clone(),
        })
        .map_err(|error| error.to_string())
    }

    /// What was stored as `text`; `None` where it is corrupt or of another version.
    pub fn from_text(text: &str) -> Option<Self> {
        let stored: Stored = serde_json::from_str(text).ok()?;
        (stored.version == VERSION).then_some(Self {
            inputs: stored.inputs,
            settings: Settings {
                result_unit: stored.result_unit,
                theme: match stored.theme {
                    StoredTheme::System => ThemePreference::System,
                    StoredTheme::Light => ThemePreference::Light,
                    StoredTheme::Dark => ThemePreference::Dark,
                },
                screen: stored.screen,
                shows_geometry: stored.shows_geometry,
                texts: stored.texts,
            },
        })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::formats::inputs::Example;

    #[test]
    fn what_is_stored_comes_back() {
        let saved = Saved {
            inputs: Example::Doorway.inputs(),
            settings: Settings {
                result_unit: LengthUnit::Foot,
                theme: ThemePreference::Dark,
                screen: Screen::Learn,
                shows_geometry: true,
                texts: Texts::from([("lens".into(), "4".into())]),
            },
        };
        assert_eq!(Saved::from_text(&saved.to_text().unwrap()), Some(saved));
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
            &good.replace("\"version\":1", "\"version\":0"),
            &good.replace("\"m\"", "\"parsec\""),
        ] {
            assert_eq!(Saved::from_text(bad), None, "{bad}");
        }
    }
}
