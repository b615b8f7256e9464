//! How results are written: in one way, in which a window and a terminal differ only by the data of a [`Style`].

use crate::assess::Assessment;
use crate::field::Key;
use crate::names::formula;
use crate::number::{NO_NUMBER, Notation, TYPED_DIGITS, magnitude};
use crate::reading::Reading;
use crate::unit::Unit;
use depth_core::measured::Measured;
use depth_core::problem::{Field, Method, Solution, Uncertainty};
use depth_core::quantity::{Length, LengthUnit};

/// Significant digits of a result without σ.
pub const DIGITS: usize = 4;

/// What is said where a range does not end.
pub const NO_UPPER_BOUND: &str = "no upper bound";

/// How results are written. Signs are those of print; a command line puts ASCII in their place.
#[derive(Clone, Copy, Debug)]
pub struct Style {
    notation: Notation,
    /// Between both ends of a range.
    to: &'static str,
    /// Behind the near end of a range without a far one.
    open_end: [&'static str; 2],
    /// Whether a simulation is shown where σ alone would mislead.
    pub(crate) has_simulation: bool,
}

/// A value and its σ, written to the same decimal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WithSigma {
    /// The value.
    pub value: String,
    /// Its σ with two significant digits.
    pub sigma: String,
}

impl WithSigma {
    /// "1.400 ± 0.016 m".
    pub fn text(&self, unit: impl Into<Unit>) -> String {
        format!("{} ± {} {}", self.value, self.sigma, unit.into().symbol())
    }
}

impl Style {
    /// In the application, and in what is copied from it.
    pub const WINDOW: Self = Self {
        notation: Notation::SHORT,
        to: "…",
        open_end: ["…", NO_UPPER_BOUND],
        has_simulation: true,
    };

    /// On the command line.
    pub const TERMINAL: Self = Self {
        notation: Notation::LONG,
        to: "to",
        open_end: ["or more,", "without an upper bound"],
        has_simulation: false,
    };

    /// A number without σ: "1.400", or "–.–" where there is none.
    pub fn number(self, value: Option<f64>) -> String {
        value.map_or_else(|| NO_NUMBER.to_owned(), |value| self.notation.significant(value, DIGITS))
    }

    /// `length` in `unit`: "1.400 m", or "–.– m" where there is none.
    pub fn length(self, length: Option<Length>, unit: LengthUnit) -> String {
        format!("{} {}", self.number(length.map(|length| length.in_unit(unit))), unit.symbol())
    }

    /// `value` with as many decimals as show two digits of `sigma`, and at least two digits of its own.
    pub fn with_sigma(self, value: f64, sigma: f64) -> WithSigma {
        WithSigma {
            value: self.notation.to_decimals(value, decimals_beside(value, sigma)),
            sigma: self.notation.significant(sigma, 2),
        }
    }

    /// A length with its σ where that is above 0: "1.400 ± 0.016 m".
    pub fn measured(self, length: Measured<Length>, unit: LengthUnit) -> String {
        if length.sigma.m() > 0.0 {
            self.with_sigma(length.value.in_unit(unit), length.sigma.in_unit(unit)).text(unit)
        } else {
            self.length(Some(length.value), unit)
        }
    }

    /// The distance of `method` with its σ where that is known: "1.400 ± 0.016 m".
    pub fn distance(self, solution: &Solution, method: Method, unit: LengthUnit) -> String {
        let distance = solution.outcome(method).distance();
        match (distance, solution.uncertainty(method)) {
            (Some(distance), Some(uncertainty)) => self.with_sigma(distance.in_unit(unit), uncertainty.sigma.in_unit(unit)).text(unit),
            _ => self.length(distance, unit),
        }
    }

    /// From `near` to `far`, if it ends at all: "1.373 … 1.429 m".
    pub fn range(self, near: Length, far: Option<Length>, unit: LengthUnit) -> String {
        self.range_of(near, far, unit, |end| self.notation.significant(end, DIGITS))
    }

    /// The 1 σ interval, to the decimals of σ: "1.384 … 1.416 m".
    pub fn interval(self, uncertainty: &Uncertainty, unit: LengthUnit) -> String {
        let decimals = decimals_beside(uncertainty.model.depth().in_unit(unit), uncertainty.sigma.in_unit(unit));
        let interval = uncertainty.interval;
        self.range_of(interval.near, interval.far, unit, |end| self.notation.to_decimals(end, decimals))
    }

    fn range_of(self, near: Length, far: Option<Length>, unit: LengthUnit, write: impl Fn(f64) -> String) -> String {
        let end = |length: Length| write(length.in_unit(unit));
        match far {
            Some(far) => format!("{} {} {} {}", end(near), self.to, end(far), unit.symbol()),
            None => format!("{} {} {}", end(near), unit.symbol(), self.open_end.join(" ")),
        }
    }

    /// What one pixel of disparity more or less makes of the stereo distance: "1.373 … 1.429 m". It stands in for the σ of the
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
                    let unit = key.kind.default_unit()?;
                    format!("{} {unit}", self.number(Some(unit.from_base(value))))
                }
            })
        };
        let symbols = formula(method, problem.get(method.optional_field()).is_some()).trim_start_matches("D = ");
        let numbers: Option<Vec<String>> = symbols
            .split(' ')
            .map(|word| {
                let symbol = word.trim_matches(['(', ')']);
                match Key::form().find(|key| key.symbol == symbol) {
                    Some(key) => Some(word.replace(symbol, &value(key)?)),
                    None => Some(word.to_owned()),
                }
            })
            .collect();
        Some(numbers?.join(" ").replace("+ -", "− ").replace("+ −", "− "))
    }

    /// A number as it was typed with its unit, "10 cm", or with fewer digits where nobody could read them.
    pub fn typed(self, reading: &Reading) -> String {
        const LONGEST: usize = 16;
        if reading.number_text.len() <= LONGEST {
            return reading.text();
        }
        let unit = reading.unit.map_or_else(String::new, |unit| format!(" {unit}"));
        format!("{}{unit}", self.notation.plain(reading.number, TYPED_DIGITS))
    }
}

/// The decimals that show two digits of `sigma`, and at least two of `value`.
fn decimals_beside(value: f64, sigma: f64) -> i32 {
    // As many digits as a number has.
    (1 - magnitude(sigma)).max(1 - magnitude(value)).min(11 - magnitude(value))
}
