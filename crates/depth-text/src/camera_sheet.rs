//! What is typed of a camera, as a data sheet has it, and everything that follows: each field that is empty shows what it would be.

use crate::entry::Entries;
use crate::field::Key;
use crate::fields::{
    CAMERA_FX, CAMERA_FY, DIAGONAL_VIEW, FILM_DIAGONAL, FILM_WIDTH, FOCUSED_AT, FRAME_HEIGHT, FRAME_WIDTH, HORIZONTAL_VIEW, LENS, P00, P11,
    PIXEL_PITCH, SENSOR_DIAGONAL, SENSOR_HEIGHT, SENSOR_WIDTH, VERTICAL_VIEW,
};
use crate::note::{Note, Severity};
use crate::number::{Notation, with_minus};
use crate::reading::{self, Reading};
use crate::sentences::CameraWords;
use crate::unit::Unit;
use crate::ways::{degrees_or_radians, may_be_radians};
use depth_core::angle::Angle;
use depth_core::camera::{CameraAnswer, CameraFacts, Fact, FilmExtent, Projection, Sensor};
use depth_core::quantity::{Length, Pixels};
use serde::{Deserialize, Serialize};

/// What is typed of a camera.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct CameraSheet {
    /// What is in its fields.
    pub entries: Entries,
    /// The name of how its lens projects; a pinhole where it is none.
    pub projection: String,
    /// Whether it is under water, and the facts hold in air.
    pub is_under_water: bool,
}

/// What is read of a [`CameraSheet`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SolvedSheet {
    /// What could be read of its fields.
    pub readings: Vec<Reading>,
    /// What is wrong with a field.
    pub notes: Vec<Note>,
    /// What follows from all of them; `None` where something is missing or wrong.
    pub answer: Option<CameraAnswer>,
    /// The same in air, where the facts hold.
    pub in_air: Option<CameraAnswer>,
    /// What is to be said of them together.
    pub said: Vec<(Severity, String)>,
}

impl CameraSheet {
    /// Its fields in groups, each under its heading.
    pub const GROUPS: &'static [(&'static str, &'static [Key])] = &[
        ("Image", &[FRAME_WIDTH, FRAME_HEIGHT]),
        ("Focal length in pixels", &[CAMERA_FX, CAMERA_FY]),
        ("Field of view", &[HORIZONTAL_VIEW, VERTICAL_VIEW, DIAGONAL_VIEW]),
        ("35 mm equivalent", &[FILM_DIAGONAL, FILM_WIDTH]),
        (
            "Lens and sensor",
            &[LENS, FOCUSED_AT, PIXEL_PITCH, SENSOR_WIDTH, SENSOR_HEIGHT, SENSOR_DIAGONAL],
        ),
        ("Projection matrix", &[P00, P11]),
    ];

    /// How its lens projects.
    pub fn projection(&self) -> Projection {
        let all = Projection::ALL.into_iter();
        all.into_iter().find(|one| one.name() == self.projection).unwrap_or_default()
    }

    /// Reads it, and works everything out.
    pub fn solve(&self) -> SolvedSheet {
        let mut solved = self.read();
        let stated: Vec<(Key, Fact)> = solved.readings.iter().filter_map(|one| Some((one.key, fact(one)?))).collect();
        if stated.is_empty() || !solved.notes.is_empty() {
            return solved;
        }
        let [Some(width), Some(height)] = [FRAME_WIDTH, FRAME_HEIGHT].map(|key| solved.value(key).map(Pixels::new)) else {
            solved.said.push((Severity::Warning, NO_SIZE.to_owned()));
            return solved;
        };
        let facts = CameraFacts {
            size: [width, height],
            facts: stated.iter().map(|(_, fact)| *fact).collect(),
            ..self.circumstances(&solved)
        };
        let (answer, said) = self.answer(&facts, &solved, &stated);
        let dry = CameraFacts {
            is_under_water: false,
            ..facts
        };
        SolvedSheet {
            in_air: dry.solve().ok(),
            answer,
            said,
            ..solved
        }
    }

    /// Reads its fields.
    fn read(&self) -> SolvedSheet {
        let mut solved = SolvedSheet::default();
        for &key in Self::GROUPS.iter().flat_map(|(_, keys)| *keys) {
            match reading::read_positive(key, self.entries.entry(key)) {
                Ok(Some(reading)) if may_be_radians(&reading) => solved.notes.push(degrees_or_radians(&reading)),
                Ok(reading) => solved.readings.extend(reading),
                Err(note) => solved.notes.push(note),
            }
        }
        solved
    }

    /// What is stated beside the focal length.
    fn circumstances(&self, solved: &SolvedSheet) -> CameraFacts {
        let length = |key| solved.value(key).map(Length::from_m);
        CameraFacts {
            size: [Pixels::new(0.0); 2],
            facts: Vec::new(),
            sensor: Sensor {
                pitch: length(PIXEL_PITCH),
                width: length(SENSOR_WIDTH),
                height: length(SENSOR_HEIGHT),
                diagonal: length(SENSOR_DIAGONAL),
            },
            focused_at: length(FOCUSED_AT),
            projection: self.projection(),
            is_under_water: self.is_under_water,
        }
    }

    /// What follows from `facts`, each of which was stated in a field, and what is to be said of it.
    fn answer(&self, facts: &CameraFacts, solved: &SolvedSheet, stated: &[(Key, Fact)]) -> (Option<CameraAnswer>, Vec<(Severity, String)>) {
        let key_at = |at: usize| stated.get(at).map_or(CAMERA_FX, |(key, _)| *key);
        let stated_at = |at: usize| {
            let text = solved.reading(key_at(at)).map(Reading::text).unwrap_or_default();
            format!("{} {text}", key_at(at).name)
        };
        let called_at = |at: usize| key_at(at).name.to_owned();
        let words = CameraWords {
            stated: &stated_at,
            called: &called_at,
            pitch: "The pixel pitch",
            sensor: "the pixel pitch, or a side or the diagonal of the sensor",
            focus: "The distance in focus",
            diagonal: "The diagonal of the sensor",
            projection: "With a fisheye chosen",
            dry: "choose “In air”",
            facts: "a focal length, a field of view, a 35 mm equivalent, or a lens with its sensor",
        };
        match facts.solve() {
            Ok(answer) => {
                let said = answer.remarks.iter().map(|remark| (Severity::Warning, words.remark(remark)));
                let said = said.collect();
                (Some(answer), said)
            }
            Err(problem) => {
                let sentence = words.problem(problem, self.projection().name());
                (None, vec![(Severity::Error, sentence)])
            }
        }
    }
}

const NO_SIZE: &str = "Fill in the width and the height of the image: nothing follows without them.";

/// What a field states of the focal length; `None` of one that only helps.
fn fact(reading: &Reading) -> Option<Fact> {
    let (value, length) = (reading.value, Length::from_m(reading.value));
    let view = Angle::from_radians(value);
    let all = [
        (CAMERA_FX, Fact::Fx(Pixels::new(value))),
        (CAMERA_FY, Fact::Fy(Pixels::new(value))),
        (HORIZONTAL_VIEW, Fact::HorizontalView(view)),
        (VERTICAL_VIEW, Fact::VerticalView(view)),
        (DIAGONAL_VIEW, Fact::DiagonalView(view)),
        (FILM_DIAGONAL, Fact::Film(FilmExtent::Diagonal, length)),
        (FILM_WIDTH, Fact::Film(FilmExtent::Width, length)),
        (LENS, Fact::Lens(length)),
        (P00, Fact::P00(value)),
        (P11, Fact::P11(value)),
    ];
    all.into_iter().find(|(key, _)| *key == reading.key).map(|(_, fact)| fact)
}

impl SolvedSheet {
    /// What was read of the field `key`.
    pub fn reading(&self, key: Key) -> Option<&Reading> {
        self.readings.iter().find(|reading| reading.key == key)
    }

    /// What is stated, such as "diagonal field of view 78°".
    pub fn stated(&self) -> String {
        let helps = [FRAME_WIDTH, FRAME_HEIGHT];
        let stated = self.readings.iter().filter(|reading| !helps.contains(&reading.key));
        let all: Vec<String> = stated.map(|reading| format!("{} {}", reading.key.name, reading.text())).collect();
        all.join(", ")
    }

    /// Whether nothing but the lens says the focal length, so that distances count from it: the lens is added to them.
    pub fn is_of_lens(&self) -> bool {
        let mut facts = self.readings.iter().filter(|reading| fact(reading).is_some()).peekable();
        // What is in focus near has the whole distance to the image in fx.
        facts.peek().is_some() && facts.all(|reading| reading.key == LENS) && self.reading(FOCUSED_AT).is_none()
    }

    fn value(&self, key: Key) -> Option<f64> {
        self.reading(key).map(|reading| reading.value)
    }

    /// What the field `key` would be in air, as a number in its own unit; `None` where that does not follow.
    pub fn following(&self, key: Key) -> Option<String> {
        let answer = self.in_air.as_ref()?;
        let [across, down, diagonal] = answer.views.map(|view| view.map(Angle::radians));
        let [by_diagonal, by_width] = answer.film.map(|lens| lens.map(Length::m));
        let [width, height, corners] = answer.sensor.map(|side| side.map(Length::m));
        let [p00, p11] = answer.multiples.map(Some);
        let all = [
            (CAMERA_FX, Some(answer.fx.px())),
            (CAMERA_FY, Some(answer.fy.px())),
            (HORIZONTAL_VIEW, across),
            (VERTICAL_VIEW, down),
            (DIAGONAL_VIEW, diagonal),
            (FILM_DIAGONAL, by_diagonal),
            (FILM_WIDTH, by_width),
            (LENS, answer.lens.map(Length::m)),
            (PIXEL_PITCH, answer.pitch.map(Length::m)),
            (SENSOR_WIDTH, width),
            (SENSOR_HEIGHT, height),
            (SENSOR_DIAGONAL, corners),
            (P00, p00),
            (P11, p11),
        ];
        let (_, value) = all.into_iter().find(|(one, _)| *one == key)?;
        let value = value.filter(|value| value.is_finite())?;
        let value = key.kind.default_unit().map_or(value, |unit: Unit| unit.from_base(value));
        Some(with_minus(&Notation::SHORT.plain(value, SHOWN_DIGITS)))
    }
}

/// More digits no data sheet has.
const SHOWN_DIGITS: usize = 5;
