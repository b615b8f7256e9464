//! How results are written: in one way, in which a window and a terminal differ only by the data of a [`Style`].

use crate::assess::Assessment;
use crate::field::Key;
use crate::names::formula;
use crate::number::{self, NO_NUMBER, Notation, TYPED_DIGITS, magnitude, with_minus};
use crate::reading::Reading;
use crate::unit::Unit;
use depth_core::in_image::InImage;
use depth_core::measured::Measured;
use depth_core::problem::{Field, Method, Solution, Solved, Uncertainty};
use depth_core::quantity::{Length, LengthUnit};

/// A number that was typed with more characters stands with fewer digits, as nobody could read it.
const LONGEST_TYPED: usize = 16;

/// Significant digits of a result without σ.
pub const DIGITS: usize = 4;

/// What is said where a range does not end.
pub const NO_UPPER_BOUND: &str = "no upper bound";

/// How results are written. Signs are those of print; a command line puts ASCII in their place.
#[derive(Clone, Copy, Debug)]
pub struct Style {
    notation: Notation,
    /// Between both ends of a range, spaces included.
    to: &'static str,
    /// Behind the near end of a range without a far one, the unit left out where it follows.
    open_end: OpenEnd,
    /// Whether a simulation is shown where σ alone would mislead.
    pub(crate) has_simulation: bool,
    /// Whether lengths that are long or short in the unit that was chosen are written in the next one.
    follows_unit: bool,
}

/// How a range ends that has no far end.
#[derive(Clone, Copy, Debug)]
enum OpenEnd {
    /// "35.00…∞ m"
    Infinity,
    /// "35.00 m or more, without an upper bound"
    Words(&'static str),
}

/// A value and its σ, written to the same decimal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WithSigma {
    /// The value.
    pub value: String,
    /// Its σ with two significant digits.
    pub sigma: String,
    /// The power of ten of both, " × 10⁻¹¹"; empty where they are written out.
    pub power: String,
}

impl WithSigma {
    /// "(1.400 ± 0.016) m", "(1.400 ± 0.016) × 10⁻¹¹ m", "(4.091 ± 0.036)°": so wherever a value stands with its σ.
    pub fn text(&self, unit: impl Into<Unit>) -> String {
        let Self { value, sigma, power } = self;
        unit.into().behind(&format!("({value} ± {sigma}){power}"))
    }

    /// "1.400" and "m ± 0.016", of which the second is written smaller.
    pub fn parts(&self, unit: impl Into<Unit>) -> [String; 2] {
        let Self { value, sigma, power } = self;
        [format!("{value}{power}"), format!("{} ± {sigma}{power}", unit.into().symbol())]
    }
}

impl Style {
    /// In the application, and in what is copied from it.
    pub const WINDOW: Self = Self {
        notation: Notation::SHORT,
        to: "…",
        open_end: OpenEnd::Infinity,
        has_simulation: true,
        follows_unit: true,
    };

    /// On the command line.
    pub const TERMINAL: Self = Self {
        notation: Notation::TERMINAL,
        to: " to ",
        open_end: OpenEnd::Words("or more, without an upper bound"),
        has_simulation: false,
        follows_unit: true,
    };

    /// The same with every length in the unit that was asked for.
    #[must_use]
    pub const fn in_unit_asked_for(self) -> Self {
        Self {
            notation: Notation::LONG,
            follows_unit: false,
            ..self
        }
    }

    /// The unit that `length` is written in: `chosen`, or where that makes it longer than five digits before the point or too short to be
    /// written out the next one of its system in which it is not. Where there is none, `chosen`: it then has a power of ten.
    pub fn unit_of(self, length: Length, chosen: LengthUnit) -> LengthUnit {
        use LengthUnit::{Foot, Inch, Kilometer, Meter, Micrometer, Mile, Millimeter, Nanometer, Yard};
        const LONGEST: f64 = 99_999.0;
        let is_metric = !matches!(chosen, Inch | Foot | Yard | Mile);
        let (larger, smaller, last): (&[LengthUnit], &[LengthUnit], LengthUnit) = if is_metric {
            (
                &[Millimeter, Meter, Kilometer],
                &[Meter, Millimeter, Micrometer, Nanometer],
                Kilometer,
            )
        } else {
            (&[Foot, Mile], &[Foot, Inch], Mile)
        };
        let size = |unit| Length::new(1.0, unit);
        let of = |unit| length.in_unit(unit).abs();
        let longest = |unit| if unit == last { 999_999.0 } else { LONGEST };
        let value = of(chosen);
        if !self.follows_unit || value == 0.0 || !value.is_finite() {
            return chosen;
        }
        let next = if value > longest(chosen) {
            larger.iter().find(|&&unit| size(unit) > size(chosen) && of(unit) <= longest(unit))
        } else if value < self.notation.smallest() {
            smaller.iter().find(|&&unit| size(unit) < size(chosen) && of(unit) >= 0.1)
        } else {
            None
        };
        next.copied().unwrap_or(chosen)
    }

    /// A number without σ: "1.400", or "–.–" where there is none.
    pub fn number(self, value: Option<f64>) -> String {
        value.map_or_else(
            || NO_NUMBER.to_owned(),
            |value| with_minus(&self.notation.significant(value, DIGITS)),
        )
    }

    /// A number as people read it, with at most `digits` digits and no zeros behind the last: "0.1", "14 286".
    pub fn readable(self, value: f64, digits: usize) -> String {
        self.notation.readable(value, digits)
    }

    /// A number to `decimals` places.
    pub fn to_decimals(self, value: f64, decimals: i32) -> String {
        with_minus(&self.notation.to_decimals(value, decimals))
    }

    /// `length` in `unit` or [the next one](Self::unit_of): "1.400 m", or "–.– m" where there is none.
    pub fn length(self, length: Option<Length>, unit: LengthUnit) -> String {
        self.length_parts(length, unit).join(" ")
    }

    /// [`length`](Self::length) as number and unit.
    pub fn length_parts(self, length: Option<Length>, unit: LengthUnit) -> [String; 2] {
        let unit = length.map_or(unit, |length| self.unit_of(length, unit));
        let number = self.number(length.map(|length| length.in_unit(unit)));
        [number, unit.symbol().to_owned()]
    }

    /// `value` with as many decimals as show two digits of `sigma`, and at least two digits of its own. Where the value is not written
    /// out, neither is σ: both have its power of ten.
    pub fn with_sigma(self, value: f64, sigma: f64) -> WithSigma {
        // A σ that is longer than the value has the same power of ten, too.
        let is_written_out = |number: f64| number.abs() < 1.0 || self.notation.writes_out(number);
        let exponent = if (self.notation.writes_out(value) || value == 0.0) && is_written_out(sigma) {
            0
        } else {
            magnitude(value).max(magnitude(sigma))
        };
        let scale = 10.0_f64.powi(exponent);
        // A power of ten beyond the range of numbers is taken away in two steps.
        let scaled = |number: f64| {
            if scale.is_normal() {
                number / scale
            } else {
                number / 10.0_f64.powi(exponent + 100) * 1e100
            }
        };
        let (value, sigma) = if exponent == 0 {
            (value, sigma)
        } else {
            (scaled(value), scaled(sigma))
        };
        let decimals = decimals_beside(value, sigma);
        WithSigma {
            value: with_minus(&self.notation.to_decimals(value, decimals)),
            sigma: self.notation.beside(sigma, decimals),
            power: if exponent == 0 { String::new() } else { number::power(exponent) },
        }
    }

    /// A length and its σ, both in `unit` or in [the next one](Self::unit_of), which is returned too.
    pub fn length_with_sigma(self, length: Measured<Length>, unit: LengthUnit) -> (WithSigma, LengthUnit) {
        let unit = self.unit_of(length.value, unit);
        (self.with_sigma(length.value.in_unit(unit), length.sigma.in_unit(unit)), unit)
    }

    /// A length with its σ where that is above 0: "(1.400 ± 0.016) m".
    pub fn measured(self, length: Measured<Length>, unit: LengthUnit) -> String {
        if length.sigma.m() > 0.0 {
            let (written, unit) = self.length_with_sigma(length, unit);
            written.text(unit)
        } else {
            self.length(Some(length.value), unit)
        }
    }

    /// [`measured`](Self::measured) in two parts, of which the second is written smaller: "1.400" and "m ± 0.016".
    pub fn measured_parts(self, length: Measured<Length>, unit: LengthUnit) -> [String; 2] {
        if length.sigma.m() > 0.0 {
            let (written, unit) = self.length_with_sigma(length, unit);
            written.parts(unit)
        } else {
            self.length_parts(Some(length.value), unit)
        }
    }

    /// The distance of `method` with its σ where that is known: "(1.400 ± 0.016) m".
    pub fn distance(self, solution: &Solution, method: Method, unit: LengthUnit) -> String {
        match solution.outcome(method).distance() {
            Some(distance) => {
                let sigma = solution.uncertainty(method).map_or(Length::from_m(0.0), |known| known.sigma);
                self.measured(Measured::new(distance, sigma), unit)
            }
            None => self.length(None, unit),
        }
    }

    /// From `near` to `far`, if it ends at all: "1.373…1.429 m".
    pub fn range(self, near: Length, far: Option<Length>, unit: LengthUnit) -> String {
        let unit = self.unit_of(far.unwrap_or(near), unit);
        self.range_of(near, far, unit, |end| self.notation.significant(end, DIGITS))
    }

    /// The 1 σ interval, to the decimals of σ: "1.384…1.416 m".
    pub fn interval(self, uncertainty: &Uncertainty, unit: LengthUnit) -> String {
        let depth = Measured::new(uncertainty.model.depth(), uncertainty.sigma);
        let interval = uncertainty.interval;
        self.range_like(interval.near, interval.far, depth, unit)
    }

    /// `length` to the decimals of the σ of `like`, in the unit of that: what belongs to a measured length is written as it is.
    pub fn length_like(self, length: Length, like: Measured<Length>, unit: LengthUnit) -> String {
        let (unit, write) = self.like(like, unit);
        format!("{} {}", write(length.in_unit(unit)), unit.symbol())
    }

    /// [`range`](Self::range) to the decimals of the σ of `like`: "1.13…1.85 m".
    pub fn range_like(self, near: Length, far: Option<Length>, like: Measured<Length>, unit: LengthUnit) -> String {
        let (unit, write) = self.like(like, unit);
        self.range_of(near, far, unit, write)
    }

    /// The unit that `like` is written in, and how numbers are written that are as precise as it is.
    fn like(self, like: Measured<Length>, unit: LengthUnit) -> (LengthUnit, impl Fn(f64) -> String) {
        let unit = self.unit_of(like.value, unit);
        let (value, sigma) = (like.value.in_unit(unit), like.sigma.in_unit(unit));
        let is_written_out = self.notation.writes_out(value) && sigma > 0.0;
        let decimals = is_written_out.then(|| decimals_beside(value, sigma));
        let write = move |number: f64| match decimals {
            Some(decimals) => with_minus(&self.notation.to_decimals(number, decimals)),
            None => self.number(Some(number)),
        };
        (unit, write)
    }

    /// Value − σ to value + σ of a length, to the decimals of σ: "49.54…50.46 mm".
    pub fn ends(self, length: Measured<Length>, unit: LengthUnit) -> String {
        let unit = self.unit_of(length.value, unit);
        self.ends_in(
            Measured::new(length.value.in_unit(unit), length.sigma.in_unit(unit)),
            Unit::Length(unit),
        )
    }

    /// The same of a number of `unit`: "49.54…50.46 px".
    pub fn ends_in(self, measured: Measured<f64>, unit: Unit) -> String {
        let decimals = decimals_beside(measured.value, measured.sigma);
        let [near, far] = measured.ends().map(|end| with_minus(&self.notation.to_decimals(end, decimals)));
        unit.behind(&format!("{near}{}{far}", self.to))
    }

    fn range_of(self, near: Length, far: Option<Length>, unit: LengthUnit, write: impl Fn(f64) -> String) -> String {
        let end = |length: Length| write(length.in_unit(unit));
        match far {
            Some(far) => format!("{}{}{} {}", end(near), self.to, end(far), unit.symbol()),
            None => match self.open_end {
                OpenEnd::Infinity => format!("{}{}∞ {}", end(near), self.to, unit.symbol()),
                OpenEnd::Words(words) => format!("{} {} {words}", end(near), unit.symbol()),
            },
        }
    }

    /// What one pixel of disparity more or less makes of the stereo distance: "1.373…1.429 m". It stands in for the σ of the
    /// disparity; `None` where there is one.
    pub fn one_pixel_range(self, solution: &Solution, unit: LengthUnit) -> Option<String> {
        // Without a distance that was computed there is nothing that a pixel could change.
        let has_sigma = |field| solution.problem.sigma(field) > 0.0;
        if has_sigma(Field::Disparity) || has_sigma(Field::Doffs) {
            return None;
        }
        let (near, far) = solution.one_pixel_range()?;
        Some(self.range(near, far, unit))
    }

    /// The right side of the formula of `method` with the current numbers, as they were typed, or `None` while one is missing:
    /// "700 px · 10 cm / 50 px".
    pub fn numbers_in_formula(self, assessment: &Assessment, method: Method) -> Option<String> {
        let problem = &assessment.solution.problem;
        let value = |key: Key| {
            let value = problem.get(key.input?)?;
            let typed = assessment.reading(key).filter(|_| !assessment.is_solved_for(key));
            Some(match typed {
                Some(reading) => self.typed(reading),
                None => {
                    let unit = unit_of_solved(assessment)
                        .filter(|_| assessment.is_solved_for(key))
                        .or(key.kind.default_unit())?;
                    unit.behind(&self.number(Some(unit.from_base(value))))
                }
            })
        };
        let formula = formula(problem, method);
        let symbols = formula.trim_start_matches("D = ");
        let numbers: Option<Vec<String>> = symbols
            .split(' ')
            .map(|word| {
                // Behind "tan(" and before ")²".
                let start = word.rfind('(').map_or(0, |at| at + 1);
                let end = word.find(')').unwrap_or(word.len());
                let symbol = word.get(start..end).unwrap_or_default();
                match Key::form().find(|key| key.symbol == symbol && key.input.is_some()) {
                    Some(key) => Some(word.replace(symbol, &value(key)?)),
                    None => Some(word.to_owned()),
                }
            })
            .collect();
        let numbers = numbers?.join(" ");
        let without_double_signs = [("+ -", "− "), ("+ −", "− "), ("− -", "+ "), ("− −", "+ ")];
        Some(
            without_double_signs
                .into_iter()
                .fold(numbers, |text, (signs, sign)| text.replace(signs, sign)),
        )
    }

    /// A number as it was typed with its unit, "10 cm", or with fewer digits where nobody could read them.
    pub fn typed(self, reading: &Reading) -> String {
        if reading.number_text.len() <= LONGEST_TYPED {
            return reading.text();
        }
        self.behind_typed(reading, &self.typed_number(reading))
    }

    /// [`typed`](Self::typed) without its unit.
    pub fn typed_number(self, reading: &Reading) -> String {
        if reading.number_text.len() <= LONGEST_TYPED {
            return reading.number_text.clone();
        }
        self.notation.plain(reading.number, TYPED_DIGITS)
    }

    /// [`typed`](Self::typed) with its σ in the unit of the value, where there is one: "(100 ± 0.5) mm", "700 px".
    pub fn typed_with_sigma(self, reading: &Reading) -> String {
        match reading.sigma_text() {
            Some(sigma) => self.behind_typed(reading, &format!("({} ± {sigma})", self.typed_number(reading))),
            None => self.typed(reading),
        }
    }

    fn behind_typed(self, reading: &Reading, number: &str) -> String {
        match reading.unit {
            Some(Unit::Square(_)) if !reading.unit_text.is_empty() => format!("{number} {}", reading.unit_text),
            Some(unit) => unit.behind(number),
            None => number.to_owned(),
        }
    }
}

/// The unit of what was solved for, where that is measured in the image.
fn unit_of_solved(assessment: &Assessment) -> Option<Unit> {
    let solved = assessment.unknown.as_ref()?.outcome.as_ref().ok()?;
    match solved {
        Solved::InImage(InImage::OnSensor(_)) => Some(Unit::Length(LengthUnit::Millimeter)),
        _ => None,
    }
}

/// The decimals that show two digits of `sigma`, and at least two of `value`.
fn decimals_beside(value: f64, sigma: f64) -> i32 {
    // As many digits as a number has.
    (1 - magnitude(sigma)).max(1 - magnitude(value)).min(11 - magnitude(value))
}
