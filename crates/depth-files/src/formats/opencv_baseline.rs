//! The baseline of an OpenCV calibration, which may stand in it five times over: in P, in T, in Q, and under a key with a unit or without.

use super::baseline::with_unit;
use super::opencv_names::{Matrices, Part, QS, TRANSLATIONS, find, square, unit};
use crate::baseline::Baseline;
use crate::checks::agree;
use crate::format::Format;
use crate::found::Found;
use crate::geometry::length;
use crate::place::Origin;
use crate::refusal::Refusal;
use crate::sentences::shown;
use crate::units::in_file_units;
use crate::warning::{Statement, Warning};
use depth_core::q_matrix::{self, StereoGeometry};
use depth_core::quantity::{Length, LengthUnit};

const FORMAT: Format = Format::OpenCv;
type Parts<'a> = [Part<'a>];
/// doffs and the principal points agree to this, in pixels.
const SAME_PX: f64 = 0.1;

/// Q, where there is one.
pub(super) fn q<'p, 'a>(parts: &'p Parts<'a>) -> Result<Option<(&'p Part<'a>, StereoGeometry)>, Refusal> {
    let Some(part) = find(parts, &QS) else { return Ok(None) };
    let numbers: [f64; 16] = part.node.array(FORMAT, &part.name, "16")?;
    let mut rows = [[0.0; 4]; 4];
    for (row, numbers) in rows.iter_mut().zip(numbers.chunks_exact(4)) {
        row.copy_from_slice(numbers);
    }
    let geometry = q_matrix::read(&rows).map_err(|wrong| Refusal::NotQ {
        format: FORMAT,
        name: part.name.clone(),
        place: part.node.place,
        entry: [wrong.row, wrong.column],
        found: wrong.found,
    })?;
    Ok(Some((part, geometry)))
}

/// A baseline of `value`, in the unit that the file says, or in one that it does not say.
pub(super) fn in_units(value: f64, parts: &Parts<'_>) -> Baseline {
    match unit(parts) {
        Some(unit) => Baseline::Known(Length::new(value, unit)),
        None => in_file_units(value, square(parts)),
    }
}

/// What a file says of the baseline.
struct Claim {
    baseline: Baseline,
    origin: Origin,
    /// Whether its unit may be another than that of T and P.
    is_loose: bool,
}

/// Takes the baseline whose key names its unit, or one whose key does not where there is no other; says where two contradict each other.
pub(super) fn compare(found: &mut Found, parts: &Parts<'_>) -> Result<(), Refusal> {
    let mut claims: Vec<Claim> = known(parts)?.into_iter().collect();
    if let Some((baseline, origin)) = found.baseline.zip(found.baseline_origin.clone()) {
        claims.push(Claim {
            baseline,
            origin,
            is_loose: false,
        });
    }
    if !claims.is_empty() {
        claims.extend(others(found, parts)?);
    }
    claims.extend(bare(parts)?);
    let mut claims = claims.into_iter();
    let Some(used) = claims.next() else { return Ok(()) };
    found.measure(Some(used.baseline), used.origin.clone());
    for other in claims {
        // What was read of P or T may be said again.
        if other.origin != used.origin && !is_same(&used, &other, square(parts)) {
            found.warnings.push(Warning::Contradiction {
                used: used.statement(),
                other: other.statement(),
            });
        }
    }
    compare_q(found, parts)
}

/// A baseline whose key names its unit.
fn known(parts: &Parts<'_>) -> Result<Option<Claim>, Refusal> {
    let known = with_unit(parts, FORMAT)?;
    Ok(known.map(|(baseline, origin)| Claim {
        baseline,
        origin,
        is_loose: false,
    }))
}

/// A baseline whose key does not.
fn bare(parts: &Parts<'_>) -> Result<Option<Claim>, Refusal> {
    let Some(part) = find(parts, &["baseline"]) else { return Ok(None) };
    let value = part.node.number(FORMAT, &part.name)?.abs();
    Ok((value > 0.0).then(|| Claim {
        baseline: in_units(value, parts),
        origin: part.origin(),
        is_loose: true,
    }))
}

/// What T and Q say beside P: those that can be read, and that were made by the run of which the cameras are.
fn others(found: &Found, parts: &Parts<'_>) -> Result<Vec<Claim>, Refusal> {
    let mut claims = Vec::new();
    let claim = |value: f64, origin: Origin| Claim {
        baseline: in_units(value, parts),
        origin,
        is_loose: false,
    };
    let translation = find(parts, &TRANSLATIONS).filter(|_| found.cameras.len() == 2);
    if let Some(part) = translation
        && let Ok(vector) = part.node.array::<3>(FORMAT, "T", "3")
        && length(vector) > 0.0
    {
        claims.push(claim(length(vector), part.node.place.origin(format!("|{}|", part.name))));
    }
    if let Some((part, geometry)) = q(parts).unwrap_or(None)
        && found.is_rectified()
        && geometry.baseline.is_finite()
    {
        let how = format!("1 / {}[3][2]", part.name);
        claims.push(claim(geometry.baseline, part.node.place.origin(how)));
    }
    Ok(claims)
}

/// Where Q says another focal length or another doffs than P.
fn compare_q(found: &mut Found, parts: &Parts<'_>) -> Result<(), Refusal> {
    let Some((part, geometry)) = q(parts).unwrap_or(None) else {
        return Ok(());
    };
    let (Some(_), Some(first)) = (
        Matrices::projections(parts).second.filter(|_| found.is_rectified()),
        found.cameras.first(),
    ) else {
        return Ok(());
    };
    let px = |value: f64, origin: Origin| Statement {
        value: format!("{} px", shown(value)),
        origin,
    };
    let mut said = Vec::new();
    let (of_p, of_q) = (first.fx.px(), geometry.focal_length.px());
    if !agree(of_p, of_q) {
        let used = px(of_p, first.origin.place().origin(format!("{}[0][0]", first.origin.how)));
        let other = px(of_q, part.node.place.origin(format!("{}[2][3]", part.name)));
        said.push(Warning::Contradiction { used, other });
    }
    let sign = if geometry.swapped { -1.0 } else { 1.0 };
    if let Some((doffs, origin)) = found.doffs.zip(found.doffs_origin.clone())
        && (doffs.px() - sign * geometry.doffs.px()).abs() > SAME_PX
    {
        let used = px(doffs.px(), origin);
        let how = format!("{0}[3][3] / {0}[3][2]", part.name);
        let other = px(sign * geometry.doffs.px() + 0.0, part.node.place.origin(how));
        said.push(Warning::Contradiction { used, other });
    }
    found.warnings.append(&mut said);
    Ok(())
}

/// Whether two claims can be of the same length: in the same unit, or in whatever unit, where one has another than the other.
fn is_same(one: &Claim, other: &Claim, square: Option<f64>) -> bool {
    let value = |claim: &Claim| match claim.baseline {
        Baseline::Known(length) => length.m(),
        Baseline::InFileUnits { value, .. } => value,
    };
    let is_known = |claim: &Claim| matches!(claim.baseline, Baseline::Known(_));
    let (a, b) = (value(one), value(other));
    if is_known(one) == is_known(other) && !one.is_loose && !other.is_loose {
        return agree(a, b);
    }
    let meters =
        [LengthUnit::Millimeter, LengthUnit::Centimeter, LengthUnit::Meter, LengthUnit::Inch].map(|unit| Length::new(1.0, unit).m());
    // A unit of the file may also be a square, whose own unit is one of these.
    let units: Vec<f64> = meters.iter().flat_map(|unit| [*unit, unit * square.unwrap_or(1.0)]).collect();
    let ratios = units.iter().flat_map(|unit| units.iter().map(move |other| unit / other));
    let mut ratios = units
        .iter()
        .copied()
        .filter(|_| is_known(one))
        .chain(ratios.filter(|_| !is_known(one)));
    ratios.any(|ratio| agree(a, b * ratio))
}

impl Claim {
    fn statement(&self) -> Statement {
        let value = match self.baseline {
            Baseline::Known(length) => format!("{} m", shown(length.m())),
            Baseline::InFileUnits { value, .. } => shown(value).to_string(),
        };
        let origin = self.origin.clone();
        Statement { value, origin }
    }
}
