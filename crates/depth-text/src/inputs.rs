//! The form as typed ([`Inputs`]) and what it means ([`Assessment`]): the [`Solution`] and a note at each field that
//! needs one.

use crate::number::{self, NumberError, Unit, plain, quoted};
use depth_core::agreement::Suspect;
use depth_core::measured::Measured;
use depth_core::problem::{Field, Method, Outcome, Problem, Refusal, Solution, better_unit};
use depth_core::quantity::{Length, LengthUnit};
use depth_core::unknown::{MonocularEquation, StereoEquation};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// One field as typed.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Entry {
    /// The text in the field.
    pub text: String,
    /// The unit chosen beside it, for a length; `None` for pixels.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unit: Option<LengthUnit>,
}

impl Entry {
    /// `text` with `unit`.
    pub fn new(text: impl Into<String>, unit: Option<LengthUnit>) -> Self {
        Self { text: text.into(), unit }
    }

    /// Whether nothing was typed.
    pub fn is_blank(&self) -> bool {
        self.text.trim().is_empty()
    }
}

/// Everything typed into the form.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Inputs {
    focal_length: Entry,
    baseline: Entry,
    disparity: Entry,
    doffs: Entry,
    image_width: Entry,
    real_width: Entry,
    /// σ of each field, as typed.
    sigmas: BTreeMap<Field, String>,
    /// Whether the σ are asked for. Switched off, what was typed stays but does not count.
    pub with_uncertainty: bool,
    /// What is solved for, where it is not the distance.
    pub unknown: Option<(Method, Field)>,
    /// D, where something else is solved for.
    pub distance: Entry,
    /// σ of D as typed.
    pub distance_sigma: String,
}

impl Default for Inputs {
    /// Empty, with the baseline in millimetres and the real width in metres.
    fn default() -> Self {
        let blank = |field| Entry::new("", default_unit(field));
        Self {
            focal_length: blank(Field::FocalLength),
            baseline: blank(Field::Baseline),
            disparity: blank(Field::Disparity),
            doffs: blank(Field::Doffs),
            image_width: blank(Field::ImageWidth),
            real_width: blank(Field::RealWidth),
            sigmas: BTreeMap::new(),
            with_uncertainty: false,
            unknown: None,
            distance: Entry::new("", Some(LengthUnit::Meter)),
            distance_sigma: String::new(),
        }
    }
}

/// The unit in which a length field starts; `None` for pixels.
pub const fn default_unit(field: Field) -> Option<LengthUnit> {
    match field {
        Field::Baseline => Some(LengthUnit::Millimeter),
        Field::RealWidth => Some(LengthUnit::Meter),
        Field::FocalLength | Field::Disparity | Field::Doffs | Field::ImageWidth => None,
    }
}

/// A worked example that a button fills in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Example {
    /// 700 px, 10 cm, 50 px: 1.4 m by stereo.
    CoffeeMug,
    /// 950 px, 0.9 m, 200 px: 4.275 m by its width.
    Doorway,
}

impl Example {
    /// Both examples.
    pub const ALL: [Self; 2] = [Self::CoffeeMug, Self::Doorway];

    /// The text of its button.
    pub const fn name(self) -> &'static str {
        match self {
            Self::CoffeeMug => "Coffee mug (stereo)",
            Self::Doorway => "Doorway (monocular)",
        }
    }

    /// The form filled in. Source: the two worked examples of the page that this program reproduces.
    pub fn inputs(self) -> Inputs {
        let mut inputs = Inputs::default();
        match self {
            Self::CoffeeMug => {
                inputs.focal_length.text = "700".into();
                inputs.baseline = Entry::new("10", Some(LengthUnit::Centimeter));
                inputs.disparity.text = "50".into();
            }
            Self::Doorway => {
                inputs.focal_length.text = "950".into();
                inputs.image_width.text = "200".into();
                inputs.real_width = Entry::new("0.9", Some(LengthUnit::Meter));
            }
        }
        inputs
    }
}

impl Inputs {
    /// The entry of `field`.
    pub const fn entry(&self, field: Field) -> &Entry {
        match field {
            Field::FocalLength => &self.focal_length,
            Field::Baseline => &self.baseline,
            Field::Disparity => &self.disparity,
            Field::Doffs => &self.doffs,
            Field::ImageWidth => &self.image_width,
            Field::RealWidth => &self.real_width,
        }
    }

    /// The entry of `field`, to be changed.
    pub const fn entry_mut(&mut self, field: Field) -> &mut Entry {
        match field {
            Field::FocalLength => &mut self.focal_length,
            Field::Baseline => &mut self.baseline,
            Field::Disparity => &mut self.disparity,
            Field::Doffs => &mut self.doffs,
            Field::ImageWidth => &mut self.image_width,
            Field::RealWidth => &mut self.real_width,
        }
    }

    /// σ of `field` as typed: a number, with a unit, or in % of the value.
    pub fn sigma(&self, field: Field) -> &str {
        self.sigmas.get(&field).map_or("", String::as_str)
    }

    /// Sets σ of `field` as typed. A blank one is none.
    pub fn set_sigma(&mut self, field: Field, text: impl Into<String>) {
        let text = text.into();
        if text.is_empty() {
            self.sigmas.remove(&field);
        } else {
            self.sigmas.insert(field, text);
        }
    }

    /// Whether the field for doffs is shown: once there is one, or a σ of one, or it is solved for.
    pub fn shows_doffs(&self) -> bool {
        let solved_for = self.unknown.is_some_and(|(_, field)| field == Field::Doffs);
        !self.entry(Field::Doffs).is_blank() || !self.sigma(Field::Doffs).is_empty() || solved_for
    }

    /// Whether nothing was typed anywhere.
    pub fn is_blank(&self) -> bool {
        Field::ALL.iter().all(|&field| self.entry(field).is_blank()) && self.sigmas.values().all(|text| text.trim().is_empty())
    }

    /// The unit that holds for a length `field`: the one typed behind the number, else the one chosen beside it.
    pub fn unit(&self, field: Field) -> Option<LengthUnit> {
        let default = default_unit(field)?;
        let entry = self.entry(field);
        match number::read(&entry.text) {
            Ok(number::Typed {
                unit: Some(Unit::Length(unit)),
                ..
            }) => Some(unit),
            _ => Some(entry.unit.unwrap_or(default)),
        }
    }

    /// The number typed into `field`, in the unit typed or chosen; `None` where there is none.
    pub fn number(&self, field: Field) -> Option<f64> {
        number::read(&self.entry(field).text).ok().map(|typed| typed.number)
    }

    /// Moves a unit typed behind the number into the choice beside it. What cannot be read is left as it is.
    pub fn tidy(&mut self, field: Field) {
        let unit = self.unit(field);
        let entry = self.entry_mut(field);
        let Ok(typed) = number::read(&entry.text) else { return };
        match typed.unit {
            Some(Unit::Length(_)) if unit.is_some() => {
                *entry = Entry::new(typed.number_text, unit);
            }
            Some(Unit::Pixel) if unit.is_none() => entry.text = typed.number_text.to_owned(),
            _ => {}
        }
    }

    /// Chooses `unit` for `field` and keeps the typed number: the person corrects the unit, the number is what they read.
    pub fn choose_unit(&mut self, field: Field, unit: LengthUnit) {
        self.tidy(field);
        self.entry_mut(field).unit = Some(unit);
    }

    /// Counts the last typed digit of `field` up or down by `steps`: 700 goes to 701, 0.30 to 0.31. An empty field starts at
    /// its example. Stays above zero by going on in smaller digits (1 down to 0.9). A text that is not a positive number is
    /// left as it is.
    pub fn step(&mut self, field: Field, steps: i32) {
        if self.entry(field).is_blank() {
            self.entry_mut(field).text = example_text(field).to_owned();
            return;
        }
        self.tidy(field);
        let entry = self.entry_mut(field);
        let Ok(typed) = number::read(&entry.text) else { return };
        if let Some(text) = stepped(typed, steps) {
            entry.text = text;
        }
    }

    /// Reads every field and solves.
    pub fn assess(&self) -> Assessment {
        let mut problem = Problem::default();
        let mut notes = Vec::new();
        let free = self.unknown.map(|(_, field)| field);
        for field in Field::ALL {
            if self.entry(field).is_blank() || free == Some(field) {
                continue;
            }
            match self.read(field) {
                Ok(value) => problem.set(field, Some(value)),
                Err(note) => notes.push(note),
            }
        }
        for field in Field::ALL {
            if let Err(refusal) = problem.check(field) {
                notes.push(self.refused(field, refusal));
                problem.set(field, None);
            } else if !problem.is_usual(field) {
                notes.push(self.unusual(field));
            }
            if self.with_uncertainty && free != Some(field) {
                match self.read_sigma(field, problem.get(field)) {
                    Ok(sigma) => problem.set_sigma(field, sigma.unwrap_or(0.0)),
                    Err(note) => notes.push(note),
                }
            }
        }
        let unknown = self.unknown.map(|(method, field)| self.solve_for(method, field, &problem));
        if let Some(Unknown {
            field, outcome: Ok(found), ..
        }) = &unknown
        {
            problem.set(*field, Some(found.value));
            // The uncertainty asked for is that of the unknown; what it would give back to the distance is only an echo.
            problem = problem.without_sigmas();
        }
        let solution = problem.solve();
        let mut suspects = solution.suspects();
        // Of all slips of the unit that would explain a disagreement, only one from the unit in use can have happened.
        suspects.retain(|suspect| match suspect {
            Suspect::Unit { source, taken, .. } => self.unit(*source) == Some(*taken),
            _ => true,
        });
        for method in Method::ALL {
            if let Outcome::Refused { field, refusal } = solution.outcome(method) {
                notes.retain(|note| (note.field, note.part, note.severity) != (field, Part::Value, Severity::Warning));
                if !notes.iter().any(|note| (note.field, note.part) == (field, Part::Value)) {
                    notes.push(self.refused(field, refusal));
                }
            }
        }
        if let Some(field) = solution.unusable_sigma {
            notes.push(Note::of_sigma(
                field,
                "This uncertainty is out of all proportion to the value, so nothing can be said. Type a smaller one.".to_owned(),
            ));
        }
        notes.sort_by_key(|note| (note.field, note.part));
        Assessment {
            solution,
            suspects,
            notes,
            unknown,
        }
    }

    /// Solves the equation of `method` for `field`, with the distance as an input.
    fn solve_for(&self, method: Method, field: Field, problem: &Problem) -> Unknown {
        let lacking = || {
            let fields = method.fields();
            let lacking = fields.iter().find(|&&other| other != field && problem.get(other).is_none())?;
            Some(format!("{} is missing.", capital(lacking.noun())))
        };
        let outcome = lacking().map_or_else(|| self.read_distance(), Err).and_then(|distance| {
            let solved = match method {
                Method::Stereo => StereoEquation {
                    focal_length: problem.focal_length.filter(|_| field != Field::FocalLength),
                    baseline: problem.baseline.filter(|_| field != Field::Baseline),
                    disparity: problem.disparity.filter(|_| field != Field::Disparity),
                    doffs: (field != Field::Doffs).then(|| problem.offset()),
                    distance: Some(distance),
                }
                .solve(),
                Method::Monocular => MonocularEquation {
                    focal_length: problem.focal_length.filter(|_| field != Field::FocalLength),
                    real_width: problem.real_width.filter(|_| field != Field::RealWidth),
                    image_width: problem.image_width.filter(|_| field != Field::ImageWidth),
                    distance: Some(distance),
                }
                .solve(),
            };
            match solved {
                Ok(found) => Ok(found.to_base()),
                Err(_) => Err("With these numbers there is no answer that a computer can represent.".to_owned()),
            }
        });
        Unknown { method, field, outcome }
    }

    /// D with its σ, or a sentence that says what is wrong with it.
    fn read_distance(&self) -> Result<Measured<Length>, String> {
        const EXAMPLE: &str = "Type a distance above zero, such as 1.4 m.";
        if self.distance.is_blank() {
            return Err(format!("The distance (D) is missing. {EXAMPLE}"));
        }
        let in_unit = |text: &str| -> Result<(f64, f64), String> {
            let typed = number::read(text).map_err(|_| format!("{} is not a distance. {EXAMPLE}", quoted(text)))?;
            let unit = match typed.unit {
                Some(Unit::Length(unit)) => unit,
                Some(Unit::Pixel) => return Err(format!("A distance is not a number of pixels. {EXAMPLE}")),
                None => self.distance.unit.unwrap_or(LengthUnit::Meter),
            };
            Ok((typed.number, Length::new(typed.number, unit).m()))
        };
        let (_, value) = in_unit(&self.distance.text)?;
        if !value.is_normal() || value < 0.0 {
            return Err(format!("{} is not a distance. {EXAMPLE}", quoted(&self.distance.text)));
        }
        let text = self.distance_sigma.trim().trim_start_matches('±').trim();
        let sigma = match text.strip_suffix('%') {
            _ if text.is_empty() || !self.with_uncertainty => 0.0,
            Some(percent) => in_unit(percent)?.0 / 100.0 * value,
            None => in_unit(text)?.1,
        };
        if !sigma.is_finite() || sigma < 0.0 {
            return Err(format!("{} is not an uncertainty.", quoted(text)));
        }
        Ok(Measured::from_base(value, sigma))
    }

    /// σ of `field` in px or metres, or the note that says why it cannot be used. A σ in % needs the value.
    fn read_sigma(&self, field: Field, value: Option<f64>) -> Result<Option<f64>, Note> {
        let text = self.sigma(field).trim().trim_start_matches('±').trim();
        if text.is_empty() {
            return Ok(None);
        }
        let example = if field.is_length() { "0.5 mm or 1 %" } else { "0.5 or 1 %" };
        let wrong = |what: &str| {
            Note::of_sigma(
                field,
                format!("{} {what} Type one standard deviation, such as {example}.", quoted(text)),
            )
        };
        let (number_text, percent) = text.strip_suffix('%').map_or((text, false), |number| (number, true));
        let typed = number::read(number_text).map_err(|error| match error {
            NumberError::Ambiguous { .. } => wrong("could mean more than one number."),
            NumberError::UnknownUnit(_) => wrong("has a unit that is not known here."),
            NumberError::NotANumber | NumberError::TooExtreme => wrong("is not an uncertainty."),
        })?;
        if typed.number < 0.0 {
            return Err(wrong("is negative, which an uncertainty cannot be."));
        }
        let sigma = match (typed.unit, self.unit(field)) {
            (None, _) if percent => match value {
                Some(value) => typed.number / 100.0 * value.abs(),
                None => return Ok(None),
            },
            (Some(_), _) if percent => return Err(wrong("has a unit and a percent sign.")),
            (Some(Unit::Length(unit)), Some(_)) | (None, Some(unit)) => Length::new(typed.number, unit).m(),
            (Some(Unit::Pixel) | None, None) => typed.number,
            (Some(_), _) => return Err(wrong("has the wrong kind of unit.")),
        };
        if sigma.is_finite() {
            Ok(Some(sigma))
        } else {
            Err(wrong("is too large."))
        }
    }

    /// What is still missing of each method that was touched (or, if none was, of both), field by field with a sentence.
    ///
    /// A field with something unreadable in it is not missing: it has a note of its own.
    pub fn missing(&self) -> Vec<Note> {
        let free = self.unknown.map(|(_, field)| field);
        // What is solved for is not missing.
        let blank = |field: &Field| self.entry(*field).is_blank() && free != Some(*field);
        let touched = |method: &Method| method.own_fields().iter().any(|field| !blank(field));
        let mut missing: Vec<Note> = Vec::new();
        let any_touched = Method::ALL.iter().any(touched);
        for method in Method::ALL.iter().filter(|method| touched(method)) {
            for field in method.fields().iter().filter(|field| blank(field)) {
                if !missing.iter().any(|note| note.field == *field) {
                    missing.push(Note::error(
                        *field,
                        format!(
                            "{} is missing for the {} distance. {}",
                            capital(field.noun()),
                            method.name().to_lowercase(),
                            type_something(*field)
                        ),
                    ));
                }
            }
        }
        if !any_touched {
            let field = if blank(&Field::FocalLength) {
                Field::FocalLength
            } else {
                Field::Baseline
            };
            missing.push(Note::error(
                field,
                match field {
                    Field::FocalLength => "Start with the focal length in pixels, such as 700.".to_owned(),
                    _ => "Add a baseline and a disparity for two cameras, or the two widths for one camera.".to_owned(),
                },
            ));
        }
        missing.sort_by_key(|note| note.field);
        missing
    }

    /// The value of `field` in px or metres, or the note that says why it cannot be used.
    fn read(&self, field: Field) -> Result<f64, Note> {
        let entry = self.entry(field);
        let typed = number::read(&entry.text).map_err(|error| self.unreadable(field, error))?;
        let value = match (typed.unit, self.unit(field)) {
            (Some(Unit::Length(unit)), None) => {
                return Err(Note::error(
                    field,
                    format!(
                        "{} is a length, but {} is counted in pixels. {}",
                        quoted(&entry.text),
                        field.noun(),
                        pixels_hint(field, unit)
                    ),
                ));
            }
            (Some(Unit::Pixel), Some(_)) => {
                return Err(Note::error(
                    field,
                    format!(
                        "{} is a length, not a number of pixels. Use mm, cm, m, in or ft.",
                        capital(field.noun())
                    ),
                ));
            }
            (_, Some(unit)) => {
                let length = Length::new(typed.number, unit).m();
                // A number that only the change of unit pushes out of range is too extreme, not zero.
                if typed.number != 0.0 && !length.is_normal() {
                    return Err(self.refused(field, Refusal::TooExtreme));
                }
                length
            }
            (_, None) => typed.number,
        };
        Ok(value)
    }

    fn unreadable(&self, field: Field, error: NumberError) -> Note {
        let entry = self.entry(field);
        let text = quoted(&entry.text);
        match error {
            NumberError::NotANumber => Note::error(field, format!("{text} is not a number. {}", type_something(field))),
            NumberError::TooExtreme => self.refused(field, Refusal::TooExtreme),
            NumberError::UnknownUnit(unit) => {
                let units = if field.is_length() {
                    "Use mm, cm, m, in or ft."
                } else {
                    "Type only a number of pixels."
                };
                Note::error(field, format!("{} is not a unit known here. {units}", quoted(&unit)))
            }
            NumberError::Ambiguous { readings } => {
                let question = match readings.as_slice() {
                    [] => format!(
                        "{text} has several separators and could mean different things. Type it with one decimal point, such as 1000.5."
                    ),
                    [one] => format!("{text} has separators that mean different things in different countries. Is it {one}?"),
                    [many, few, ..] => format!("{text} could mean {many} or {few}. Which one is it?"),
                };
                Note {
                    fixes: readings
                        .into_iter()
                        .map(|reading| Fix {
                            label: format!("Use {reading}"),
                            entry: Entry::new(reading, entry.unit),
                        })
                        .collect(),
                    ..Note::error(field, question)
                }
            }
        }
    }

    fn refused(&self, field: Field, refusal: Refusal) -> Note {
        let entry = self.entry(field);
        match refusal {
            Refusal::NotANumber => Note::error(field, format!("{} is not a number. {}", quoted(&entry.text), type_something(field))),
            Refusal::Zero | Refusal::Negative if field == Field::Disparity && !self.entry(Field::Doffs).is_blank() => Note::error(
                field,
                "Disparity and doffs together must be above zero: at zero the object is infinitely far away, below zero left and right may be swapped. Check the sign of doffs.".to_owned(),
            ),
            Refusal::Zero if field == Field::Disparity => Note::error(
                field,
                "A disparity of zero means that the object is infinitely far away. Type a disparity above 0 px.".to_owned(),
            ),
            Refusal::Negative if field == Field::Disparity => {
                let positive = entry.text.trim().trim_start_matches(['-', '−']).to_owned();
                Note {
                    fixes: vec![Fix {
                        label: format!("Use {positive}"),
                        entry: Entry::new(positive, entry.unit),
                    }],
                    ..Note::error(
                        field,
                        "A negative disparity usually means that the left and the right image are swapped. Swap them, or type it without the minus.".to_owned(),
                    )
                }
            }
            Refusal::Zero => Note::error(field, format!("{} cannot be zero. {}", capital(field.noun()), type_something(field))),
            Refusal::Negative => Note::error(
                field,
                format!("{} cannot be negative. {}", capital(field.noun()), type_something(field)),
            ),
            Refusal::TooExtreme => Note::error(
                field,
                format!(
                    "With {} there is no distance that a computer can represent. {}",
                    quoted(&entry.text),
                    type_something(field)
                ),
            ),
        }
    }

    fn unusual(&self, field: Field) -> Note {
        let entry = self.entry(field);
        let mut note = Note {
            severity: Severity::Warning,
            ..Note::error(
                field,
                format!(
                    "Unusual for {}: most lie between {}. Is it right?",
                    field.noun(),
                    usual_range_text(field)
                ),
            )
        };
        if let (Ok(typed), Some(unit)) = (number::read(&entry.text), self.unit(field))
            && let Some(better) = better_unit(field, typed.number, unit)
        {
            note.message = format!(
                "{} {} is unusual for {}: most lie between {}. Did you mean {} {}?",
                typed.number_text,
                unit.symbol(),
                field.noun(),
                usual_range_text(field),
                typed.number_text,
                better.symbol()
            );
            note.fixes.push(Fix {
                label: format!("Use {} {}", typed.number_text, better.symbol()),
                entry: Entry::new(typed.number_text, Some(better)),
            });
        }
        note
    }
}

/// How bad a note is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// Used, but looks like a slip.
    Warning,
    /// Cannot be used.
    Error,
}

/// What of a field a note is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// The value.
    Value,
    /// Its uncertainty.
    Sigma,
}

/// Something to say at a field.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// Where.
    pub field: Field,
    /// At the value or at its σ.
    pub part: Part,
    /// How bad.
    pub severity: Severity,
    /// What is wrong and what to type.
    pub message: String,
    /// Corrections that one click makes.
    pub fixes: Vec<Fix>,
}

impl Note {
    const fn error(field: Field, message: String) -> Self {
        Self {
            field,
            part: Part::Value,
            severity: Severity::Error,
            message,
            fixes: Vec::new(),
        }
    }

    fn of_sigma(field: Field, message: String) -> Self {
        Self {
            part: Part::Sigma,
            ..Self::error(field, message)
        }
    }
}

/// A correction offered beside a note.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// The text of its button.
    pub label: String,
    /// What the field becomes.
    pub entry: Entry,
}

/// What the form means.
#[derive(Clone, Debug, PartialEq)]
pub struct Assessment {
    /// Everything that could be computed.
    pub solution: Solution,
    /// What to look at where both distances disagree, likeliest first.
    pub suspects: Vec<Suspect>,
    /// What to say at the fields, in reading order, at most one for each value and one for each σ.
    pub notes: Vec<Note>,
    /// What was solved for, where it was not the distance.
    pub unknown: Option<Unknown>,
}

/// A quantity that was solved for.
#[derive(Clone, Debug, PartialEq)]
pub struct Unknown {
    /// The equation.
    pub method: Method,
    /// The quantity.
    pub field: Field,
    /// Its value with σ in px or metres, or a sentence that says what is lacking.
    pub outcome: Result<Measured<f64>, String>,
}

impl Assessment {
    /// The note at the value of `field`.
    pub fn note(&self, field: Field) -> Option<&Note> {
        self.notes.iter().find(|note| (note.field, note.part) == (field, Part::Value))
    }

    /// The note at the σ of `field`.
    pub fn sigma_note(&self, field: Field) -> Option<&Note> {
        self.notes.iter().find(|note| (note.field, note.part) == (field, Part::Sigma))
    }
}

/// What is shown in an empty field as an example.
pub const fn example_text(field: Field) -> &'static str {
    match field {
        Field::FocalLength => "700",
        Field::Baseline => "100",
        Field::Disparity => "50",
        Field::Doffs => "0",
        Field::ImageWidth => "150",
        Field::RealWidth => "0.30",
    }
}

/// The sentence under a field.
pub const fn hint(field: Field) -> &'static str {
    match field {
        Field::FocalLength => "Focal length of the camera in pixels.",
        Field::Baseline => "Distance between the two cameras.",
        Field::Disparity => "Horizontal shift of the object between the left and right image.",
        Field::Doffs => "cx of the right camera minus cx of the left one; added to the disparity.",
        Field::ImageWidth => "Width of the object in the image.",
        Field::RealWidth => "Actual physical width of the object.",
    }
}

/// `text` with a capital first letter.
pub fn capital(text: &str) -> String {
    let mut chars = text.chars();
    chars
        .next()
        .map_or_else(String::new, |first| first.to_uppercase().chain(chars).collect())
}

fn type_something(field: Field) -> String {
    if field == Field::Doffs {
        return "Type a number of pixels, such as 0 or 131.1.".to_owned();
    }
    let unit = default_unit(field).map_or("px", LengthUnit::symbol);
    format!("Type a number above zero, such as {} {unit}.", example_text(field))
}

fn pixels_hint(field: Field, unit: LengthUnit) -> String {
    match field {
        Field::FocalLength => format!("Divide the focal length in {0} by the width of one pixel in {0}.", unit.symbol()),
        _ => "Type how many pixels it is in the image.".to_owned(),
    }
}

fn usual_range_text(field: Field) -> &'static str {
    match field {
        Field::FocalLength => "50 and 20000 px",
        Field::Baseline => "5 mm and 5 m",
        Field::Disparity => "0.5 and 1000 px",
        Field::Doffs => "−1000 and 1000 px",
        Field::ImageWidth => "5 and 5000 px",
        Field::RealWidth => "5 mm and 50 m",
    }
}

fn stepped(typed: number::Typed<'_>, steps: i32) -> Option<String> {
    const MOST_DECIMALS: usize = 12;
    if typed.number <= 0.0 {
        return None;
    }
    if typed.number_text.contains(['e', 'E']) {
        // The last digit of 1e3 is a thousand: too coarse a step, so count hundredths of the number.
        let value = typed.number * (1.0 + f64::from(steps) * 0.01);
        return (value.is_normal() && value > 0.0).then(|| plain(value));
    }
    let typed_decimals = typed.number_text.rsplit_once(['.', ',']).map_or(0, |(_, decimals)| decimals.len());
    (typed_decimals..=MOST_DECIMALS).find_map(|decimals| {
        let last_digit = format!("1e-{decimals}").parse::<f64>().ok()?;
        let value = typed.number + f64::from(steps) * last_digit;
        // Half a digit above zero would print as zero.
        (value > last_digit / 2.0).then(|| format!("{value:.decimals$}"))
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests {
    use super::*;
    use LengthUnit::{Centimeter, Meter, Millimeter};

    fn with(field: Field, text: &str) -> Inputs {
        let mut inputs = Inputs::default();
        inputs.entry_mut(field).text = text.into();
        inputs
    }

    fn note(inputs: &Inputs, field: Field) -> Note {
        inputs
            .assess()
            .note(field)
            .cloned()
            .unwrap_or_else(|| panic!("no note at {field:?}"))
    }

    #[test]
    fn the_examples_give_the_distances_of_the_page() {
        let mug = Example::CoffeeMug.inputs().assess();
        assert_eq!(mug.solution.stereo, Outcome::Distance(Length::from_m(1.4)));
        assert_eq!(mug.notes, []);
        let doorway = Example::Doorway.inputs().assess();
        assert_eq!(doorway.solution.monocular, Outcome::Distance(Length::from_m(4.275)));
        assert_eq!(doorway.notes, []);
    }

    #[test]
    fn a_typed_unit_holds_at_once_and_moves_beside_the_field_when_tidied() {
        let mut inputs = with(Field::Baseline, "10 cm");
        assert_eq!(inputs.unit(Field::Baseline), Some(Centimeter));
        assert_eq!(inputs.assess().solution.problem.get(Field::Baseline), Some(0.1));
        inputs.tidy(Field::Baseline);
        assert_eq!(inputs.entry(Field::Baseline), &Entry::new("10", Some(Centimeter)));
    }

    #[test]
    fn choosing_a_unit_keeps_the_typed_number() {
        let mut inputs = with(Field::Baseline, "10 cm");
        inputs.choose_unit(Field::Baseline, Meter);
        assert_eq!(inputs.entry(Field::Baseline), &Entry::new("10", Some(Meter)));
    }

    #[test]
    fn pixels_where_a_length_belongs_and_the_reverse_are_refused() {
        let fx = note(&with(Field::FocalLength, "4 mm"), Field::FocalLength);
        assert!(fx.message.contains("one pixel in mm"), "{}", fx.message);
        let b = note(&with(Field::Baseline, "4 px"), Field::Baseline);
        assert!(b.message.contains("mm, cm, m, in or ft"), "{}", b.message);
    }

    #[test]
    fn zero_disparity_is_infinity_and_a_negative_one_a_swap() {
        let zero = note(&with(Field::Disparity, "0"), Field::Disparity);
        assert!(zero.message.contains("infinitely far"), "{}", zero.message);
        let negative = note(&with(Field::Disparity, "−50"), Field::Disparity);
        assert!(negative.message.contains("swapped"), "{}", negative.message);
        assert_eq!(negative.fixes.first().unwrap().entry.text, "50");
    }

    #[test]
    fn a_slip_of_the_unit_is_offered_the_right_one() {
        let b = note(&with(Field::Baseline, "0.1"), Field::Baseline);
        assert_eq!(b.severity, Severity::Warning);
        assert_eq!(b.fixes.first().unwrap().entry, Entry::new("0.1", Some(Meter)));
        let mut inputs = with(Field::Baseline, "100");
        inputs.choose_unit(Field::Baseline, Meter);
        assert_eq!(
            note(&inputs, Field::Baseline).fixes.first().unwrap().entry,
            Entry::new("100", Some(Millimeter))
        );
    }

    #[test]
    fn one_bad_field_leaves_the_other_method_alone() {
        let mut inputs = Example::Doorway.inputs();
        inputs.entry_mut(Field::Disparity).text = "0".into();
        inputs.entry_mut(Field::Baseline).text = "x".into();
        let assessment = inputs.assess();
        assert_eq!(assessment.solution.monocular, Outcome::Distance(Length::from_m(4.275)));
        assert_eq!(assessment.notes.len(), 2);
    }

    #[test]
    fn an_overflowing_distance_is_refused_at_the_strangest_field() {
        let mut inputs = Example::CoffeeMug.inputs();
        inputs.entry_mut(Field::FocalLength).text = "1e308".into();
        inputs.entry_mut(Field::Disparity).text = "1e-5".into();
        let assessment = inputs.assess();
        assert_eq!(assessment.solution.stereo.distance(), None);
        assert_eq!(assessment.note(Field::FocalLength).unwrap().severity, Severity::Error);
        // Only a conversion pushes this one out of range.
        assert_eq!(note(&with(Field::Baseline, "1e-306"), Field::Baseline).severity, Severity::Error);
    }

    #[test]
    fn missing_names_what_a_half_filled_method_lacks_and_nothing_of_an_untouched_one() {
        let fields = |inputs: &Inputs| inputs.missing().iter().map(|note| note.field).collect::<Vec<_>>();
        assert_eq!(fields(&Inputs::default()), [Field::FocalLength]);
        assert_eq!(fields(&with(Field::FocalLength, "700")), [Field::Baseline]);
        assert_eq!(fields(&with(Field::Disparity, "50")), [Field::FocalLength, Field::Baseline]);
        assert_eq!(fields(&Example::CoffeeMug.inputs()), []);
        let mut both = Example::CoffeeMug.inputs();
        both.entry_mut(Field::RealWidth).text = "1".into();
        assert_eq!(fields(&both), [Field::ImageWidth]);
    }

    #[test]
    fn what_is_solved_for_is_not_missing() {
        let mut inputs = with(Field::FocalLength, "700");
        inputs.entry_mut(Field::Disparity).text = "50".into();
        inputs.unknown = Some((Method::Stereo, Field::Baseline));
        inputs.distance.text = "1.4".into();
        assert_eq!(inputs.missing(), []);
        let found = inputs.assess().unknown.unwrap().outcome.unwrap();
        assert!((found.value - 0.1).abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn stepping_counts_the_last_typed_digit_and_never_reaches_zero() {
        let stepped = |text: &str, steps: i32| {
            let mut inputs = with(Field::Disparity, text);
            inputs.step(Field::Disparity, steps);
            inputs.entry(Field::Disparity).text.clone()
        };
        for (text, steps, expected) in [
            ("50", 1, "51"),
            ("50", -1, "49"),
            ("50", 10, "60"),
            ("50.3", 1, "50.4"),
            ("0,30", 1, "0.31"),
            ("5", -10, "4.0"),
            ("1", -1, "0.9"),
            ("1e3", 1, "1010"),
            ("3 px", 1, "4"),
            ("", 1, "50"),
            ("abc", 1, "abc"),
            ("-3", 1, "-3"),
        ] {
            assert_eq!(stepped(text, steps), expected, "{text:?} by {steps}");
        }
    }
}
