//! The baseline under a name of its own.

use super::opencv_names::{Part, find};
use crate::baseline::Baseline;
use crate::format::Format;
use crate::place::Origin;
use crate::refusal::Refusal;
use crate::units::in_file_units;
use crate::warning::Warning;
use depth_core::quantity::{Length, LengthUnit};

/// How keys begin that name the baseline, in small letters without `_`.
const STEMS: [&str; 3] = ["baseline", "stereobaseline", "baselinelength"];
const UNITS: [(&str, LengthUnit); 10] = [
    ("mm", LengthUnit::Millimeter),
    ("millimeters", LengthUnit::Millimeter),
    ("inmm", LengthUnit::Millimeter),
    ("cm", LengthUnit::Centimeter),
    ("centimeters", LengthUnit::Centimeter),
    ("incm", LengthUnit::Centimeter),
    ("m", LengthUnit::Meter),
    ("meters", LengthUnit::Meter),
    ("metres", LengthUnit::Meter),
    ("inm", LengthUnit::Meter),
];

/// A baseline whose key names its unit, as `baseline_mm`; nothing where it is zero.
pub(super) fn with_unit(parts: &[Part<'_>], format: Format) -> Result<Option<(Baseline, Origin)>, Refusal> {
    for stem in STEMS {
        for (end, unit) in UNITS {
            if let Some(part) = find(parts, &[&format!("{stem}{end}")]) {
                let value = part.node.number(format, &part.name)?.abs();
                return Ok((value > 0.0).then(|| (Baseline::Known(Length::new(value, unit)), part.origin())));
            }
        }
    }
    Ok(None)
}

/// A baseline whose key is that word alone, in a unit that the file does not say.
pub(super) fn bare(parts: &[Part<'_>], format: Format, warnings: &mut Vec<Warning>) -> Result<Option<(Baseline, Origin)>, Refusal> {
    let Some(part) = find(parts, &STEMS) else { return Ok(None) };
    let value = part.node.number(format, &part.name)?;
    if value == 0.0 {
        warnings.push(Warning::ZeroBaseline);
    }
    if value < 0.0 {
        warnings.push(Warning::NegativeBaseline);
    }
    Ok((value != 0.0).then(|| (in_file_units(value.abs(), None), part.origin())))
}
