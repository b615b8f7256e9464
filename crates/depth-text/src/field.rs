//! What a field is ([`FieldSpec`]), and its name everywhere in the program ([`Key`]). The fields themselves are the table
//! in [`fields`](crate::fields); what is looked up in it is in `lookup`.

use crate::number::{Notation, Primes};
use crate::unit::Unit;
use depth_core::problem::Field;
use depth_core::quantity::{Length, LengthUnit};
use serde::{Serialize, Serializer};
use std::hash::{Hash, Hasher};
use std::ops::Deref;

/// What a field counts, which decides the units that can be typed into it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Pixels of an image.
    Pixels,
    /// A focal length: in pixels, or a length where extents are lengths on the sensor; a bare number is in pixels.
    FocalLength,
    /// An extent in an image: in pixels, an angle, or a length on the sensor; a bare number is in pixels.
    Extent,
    /// A length with a choice of unit; a bare number is in the unit given here, unless another one is chosen.
    Length(LengthUnit),
    /// The size of a pixel: a length; a bare number is in micrometers.
    Pitch,
    /// An angle; a bare number is in degrees.
    Angle,
    /// A whole number.
    Count,
    /// A number without a unit.
    Plain,
    /// A text that is not one number and has a reader of its own.
    Text,
}

impl Kind {
    /// The unit of a bare number; `None` where there are no units.
    pub const fn default_unit(self) -> Option<Unit> {
        match self {
            Self::Pixels | Self::FocalLength | Self::Extent => Some(Unit::Pixel),
            Self::Length(unit) => Some(Unit::Length(unit)),
            Self::Pitch => Some(Unit::Length(LengthUnit::Micrometer)),
            Self::Angle => Some(Unit::DEGREE),
            Self::Count | Self::Plain | Self::Text => None,
        }
    }

    /// Whether `unit` can be typed behind a number of this kind.
    pub const fn reads(self, unit: Unit) -> bool {
        match self {
            Self::Pixels => matches!(unit, Unit::Pixel),
            Self::FocalLength => matches!(unit, Unit::Pixel | Unit::Length(_)),
            Self::Extent => matches!(unit, Unit::Pixel | Unit::Length(_) | Unit::Angle(_)),
            Self::Length(_) => matches!(unit, Unit::Length(_) | Unit::Square(_)),
            Self::Pitch => matches!(unit, Unit::Length(_)),
            Self::Angle => matches!(unit, Unit::Angle(_)),
            Self::Count | Self::Plain | Self::Text => false,
        }
    }

    /// What ′ and ″ behind a number mean.
    pub const fn primes(self) -> Primes {
        match self {
            Self::Angle | Self::Extent => Primes::Arcminutes,
            _ => Primes::FeetAndInches,
        }
    }

    /// The unit of length in which such a field starts; `None` where there is no choice.
    pub const fn length_unit(self) -> Option<LengthUnit> {
        match self {
            Self::Length(unit) => Some(unit),
            _ => None,
        }
    }

    /// The placeholder of a value in the help of the command line.
    pub const fn placeholder(self) -> &'static str {
        match self {
            Self::Pixels | Self::FocalLength => "PX",
            Self::Extent => "PX|ANGLE",
            Self::Length(_) | Self::Pitch => "LENGTH",
            Self::Angle => "ANGLE",
            Self::Count | Self::Plain => "NUMBER",
            Self::Text => "TEXT",
        }
    }
}

/// A part of the form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Section {
    /// What both methods need.
    Camera,
    /// Two cameras.
    Stereo,
    /// One camera and an object of known width.
    Monocular,
    /// A pixel, and how far away what it shows is along its ray.
    Point,
    /// An object that does not face the camera.
    Target,
    /// A camera above a level floor.
    Ground,
    /// Two photographs of one object, and the step between them.
    TwoShots,
    /// Two points that a stereo pair sees.
    TwoPoints,
}

impl Section {
    /// Every section, in reading order.
    pub const ALL: [Self; 8] = [
        Self::Camera,
        Self::Stereo,
        Self::Monocular,
        Self::Point,
        Self::Target,
        Self::Ground,
        Self::TwoShots,
        Self::TwoPoints,
    ];
    /// Those that everybody sees.
    pub const FORM: [Self; 3] = [Self::Camera, Self::Stereo, Self::Monocular];

    /// Whether it is shown only to those who ask for range, tilt and ground plane.
    pub const fn is_geometry(self) -> bool {
        matches!(self, Self::Point | Self::Target | Self::Ground)
    }

    /// Whether it is shown only to those who ask for two photographs and two points.
    pub const fn is_of_two(self) -> bool {
        matches!(self, Self::TwoShots | Self::TwoPoints)
    }

    /// Whether it is a way to a distance of its own, with σ of its own that always count.
    pub const fn is_way_of_its_own(self) -> bool {
        matches!(self, Self::Ground | Self::TwoShots | Self::TwoPoints)
    }

    /// Its heading.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Camera => "Camera",
            Self::Stereo => "Stereo",
            Self::Monocular => "Monocular",
            Self::Point => "Depth or range",
            Self::Target => "Tilted target",
            Self::Ground => "Ground plane",
            Self::TwoShots => "Two photographs and a step",
            Self::TwoPoints => "Two points",
        }
    }
}

/// An option of the command line that fills in a field. Its σ is the option `sigma-…`.
#[derive(Clone, Copy, Debug)]
pub struct CommandOption {
    /// Its name without dashes.
    pub name: &'static str,
    /// The line of help.
    pub help: &'static str,
    /// The line of help of its σ.
    pub sigma_help: &'static str,
}

/// A field: what the form, links, reports, the command line and the accessible tree need to know of it.
#[derive(Clone, Copy, Debug)]
pub struct FieldSpec {
    /// Its name in links and in what is stored. Never changes.
    pub key: &'static str,
    /// The name people look for.
    pub name: &'static str,
    /// The symbol in formulas.
    pub symbol: &'static str,
    /// The field in the middle of a sentence.
    pub noun: &'static str,
    /// What it counts.
    pub kind: Kind,
    /// Numbers to type, without unit: the first is shown in the empty field, all of them where a number is asked for.
    pub examples: &'static [&'static str],
    /// The σ to type beside the first example, in its unit: shown in the empty field of the σ; empty where there is none.
    pub sigma_example: &'static str,
    /// The label above the field, without its symbol, which stands behind it; never its name for assistive technology.
    pub label: &'static str,
    /// The line under the field: where the number is found, what it is from and to, or how good it usually is. At most 56 characters.
    pub hint: &'static str,
    /// The same where two fields share the width, at most 27 characters; empty where that is [`hint`](Self::hint).
    pub hint_in_pair: &'static str,
    /// What is left of the hint behind the value read back in another unit, its comma included: ", from lens center to lens center".
    /// Where it is empty, a value that was typed in the unit of the field is not read back.
    pub behind_reading: &'static str,
    /// What it means, in the table of parameters; may be empty.
    pub description: &'static str,
    /// Whether it can be below zero: the number keyboards of some phones have no minus.
    pub signed: bool,
    /// Whether it has an uncertainty.
    pub has_sigma: bool,
    /// The input of a distance that it fills.
    pub input: Option<Field>,
    /// Where it stands in the form.
    pub section: Option<Section>,
    /// Whether the form, the report and the table leave it out as long as nothing is in it.
    pub is_optional: bool,
    /// The option of the command line.
    pub option: Option<CommandOption>,
}

impl FieldSpec {
    /// What a table of fields starts from.
    pub(crate) const BLANK: Self = Self {
        key: "",
        name: "",
        symbol: "",
        noun: "",
        kind: Kind::Plain,
        examples: &[],
        sigma_example: "",
        label: "",
        hint: "",
        hint_in_pair: "",
        behind_reading: "",
        description: "",
        signed: false,
        has_sigma: false,
        input: None,
        section: None,
        is_optional: false,
        option: None,
    };

    /// What is shown in the empty field.
    pub fn example(&self) -> &'static str {
        self.examples.first().copied().unwrap_or_default()
    }

    /// An example of this field, which is in its own unit, in the one that was chosen: "300" for 0.30 in millimeters.
    ///
    /// ```
    /// use depth_core::quantity::LengthUnit;
    /// use depth_text::fields;
    ///
    /// let width = fields::REAL_WIDTH;
    /// assert_eq!(width.in_unit(width.example(), Some(LengthUnit::Millimeter)), "300");
    /// assert_eq!(width.in_unit(width.example(), Some(LengthUnit::Meter)), "0.30");
    /// ```
    pub fn in_unit(&self, example: &str, chosen: Option<LengthUnit>) -> String {
        let units = self.kind.length_unit().zip(chosen).filter(|(own, chosen)| own != chosen);
        match (units, example.parse()) {
            (Some((own, chosen)), Ok(number)) => Notation::SHORT.readable(Length::new(number, own).in_unit(chosen), 4),
            _ => example.to_owned(),
        }
    }

    /// The line under the field where nothing is to be read back: [`hint`](Self::hint), or where two fields share the width
    /// [`hint_in_pair`](Self::hint_in_pair).
    pub const fn hint_for(&self, in_pair: bool) -> &'static str {
        if in_pair && !self.hint_in_pair.is_empty() {
            self.hint_in_pair
        } else {
            self.hint
        }
    }

    /// Whether its symbol stands behind its label: only where there is one that formulas use.
    pub fn shows_symbol(&self) -> bool {
        !self.symbol.is_empty()
            && self.section.is_some() | (self.key == "distance")
            && !(self.symbol.len() > 2 && self.label.to_ascii_lowercase().contains(self.symbol))
    }

    /// The unit symbol of a bare number: "px", or empty.
    pub fn unit_symbol(&self) -> &'static str {
        self.kind.default_unit().map_or("", Unit::symbol)
    }

    /// The range outside which a value deserves a warning, in the base unit; `None` where there is none.
    pub fn usual_range(&self) -> Option<(f64, f64)> {
        self.input.map(Field::usual_range)
    }
}

/// The name of a field, by which everything is kept: entries, notes, readings, links, options and ids.
///
/// There is a key for each field of the [table](crate::fields::TABLE), and of some a second one in [other words](Key::worded), which is
/// the same key; it is as good as the [`FieldSpec`] itself.
#[derive(Clone, Copy)]
pub struct Key(&'static FieldSpec);

impl Key {
    pub(crate) const fn of(spec: &'static FieldSpec) -> Self {
        Self(spec)
    }

    /// The key as it is written in links and in what is stored.
    pub const fn as_str(self) -> &'static str {
        self.0.key
    }

    /// What the field is, for as long as the program runs.
    pub const fn spec(self) -> &'static FieldSpec {
        self.0
    }

    /// Whether the field is a length with a choice of unit.
    pub const fn is_length(self) -> bool {
        matches!(self.0.kind, Kind::Length(_))
    }
}

impl Deref for Key {
    type Target = FieldSpec;

    fn deref(&self) -> &FieldSpec {
        self.0
    }
}

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        self.0.key == other.0.key
    }
}

impl Eq for Key {}

impl PartialEq<Field> for Key {
    fn eq(&self, field: &Field) -> bool {
        self.0.input == Some(*field)
    }
}

impl Hash for Key {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.key.hash(state);
    }
}

impl std::fmt::Debug for Key {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Key({})", self.0.key)
    }
}

impl Serialize for Key {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.0.key)
    }
}
