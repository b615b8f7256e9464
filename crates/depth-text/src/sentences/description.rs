//! What a row of the table of parameters means, in a few words.

use super::words::{lower, shares};
use crate::assess::Assessment;
use crate::field::Key;
use depth_core::problem::Method;
use std::fmt::{self, Display, Formatter};

/// What a row of the table of parameters means, in a few words that fit beside it.
#[derive(Clone, Debug, PartialEq)]
pub enum Description {
    /// What an input is.
    OfField(Key),
    /// A size that the others predict; `of` is the symbol of the size that takes part.
    Predicted {
        /// "w_real" or "w_img".
        of: &'static str,
        /// Whether the distance was given, so that it stands for baseline and disparity.
        is_given: bool,
    },
    /// A size that only repeats what was entered, as its distance comes from it.
    Repeated,
    /// The weights of the stereo and the monocular distance in the combined one, which add to 1.
    Weights([f64; 2]),
    /// What was typed, in quotation marks, and is no number.
    Unusable(String),
    /// No combined distance yet.
    NeedsBoth,
    /// A distance without a σ cannot be weighed.
    NeedsSigma,
    /// The two contradict each other.
    NotCombined,
}

impl Description {
    /// What w_img and w_real are that a distance predicts, where they are shown.
    pub fn of_widths(assessment: &Assessment, is_shown: bool) -> [Self; 2] {
        let has_stereo = assessment.solution.stereo.distance().is_some();
        let has_monocular = assessment.solution.monocular.distance().is_some();
        if is_shown && !has_stereo && has_monocular {
            return [Self::Repeated, Self::Repeated];
        }
        let is_given = assessment.unknown.as_ref().is_some_and(|unknown| unknown.method == Method::Stereo);
        ["w_real", "w_img"].map(|of| Self::Predicted { of, is_given })
    }

    /// How the combined distance is made, or why there is none.
    pub fn of_combined(assessment: &Assessment) -> Self {
        let solution = &assessment.solution;
        match (solution.weights(), solution.comparison) {
            (Some(weights), _) => Self::Weights(weights),
            (None, None) => Self::NeedsBoth,
            (None, Some(comparison)) if comparison.contradict() => Self::NotCombined,
            (None, Some(_)) => Self::NeedsSigma,
        }
    }
}

impl Display for Description {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::OfField(key) if key.description.is_empty() => f.write_str(&lower(key.hint)),
            Self::OfField(key) => f.write_str(key.description),
            Self::Predicted { of, is_given: false } => write!(f, "what b, d and {of} predict"),
            Self::Predicted { of, is_given: true } => write!(f, "what D and {of} predict"),
            Self::Repeated => f.write_str("repeats what was entered"),
            Self::Unusable(text) => write!(f, "{text} (not usable)"),
            Self::Weights(weights) => {
                let percent = shares(weights);
                let numbers: Vec<&str> = percent.iter().map(|share| share.trim_end_matches(" %")).collect();
                write!(f, "weights {}", numbers.join(" : "))
            }
            Self::NeedsBoth => f.write_str("needs both distances"),
            Self::NeedsSigma => f.write_str("needs ± in both distances"),
            Self::NotCombined => f.write_str("not combined: they disagree"),
        }
    }
}
