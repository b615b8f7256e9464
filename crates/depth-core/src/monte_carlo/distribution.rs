//! What the draws show: quantiles and a histogram.

use crate::quantity::Length;

/// What an experiment found. Ends and median are `None` where they fall among the infinitely distant draws (or, before the
/// first draw, altogether).
#[derive(Clone, Debug, PartialEq)]
pub struct Distribution {
    /// The number of draws.
    pub drawn: u32,
    /// Half of the draws are nearer.
    pub median: Option<Length>,
    /// The middle 68.27 % of the draws: the quantiles 15.866 % and 84.134 %, those of ±1 σ of a normal variable.
    pub interval_68: Quantiles,
    /// The middle 95 % of the draws: the quantiles 2.5 % and 97.5 %.
    pub interval_95: Quantiles,
    /// The part of the draws that are infinitely far away, 0 to 1.
    pub share_infinite: f64,
    /// The part of the draws at distance 0, 0 to 1.
    pub share_zero: f64,
    /// The shape; `None` where no draw is finite.
    pub histogram: Option<Histogram>,
}

/// The two ends of an interval; `None` where an end is infinitely far away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantiles {
    /// The near end.
    pub near: Option<Length>,
    /// The far end.
    pub far: Option<Length>,
}

/// Counts of draws in bins of equal width over the part of the distribution that is worth drawing.
///
/// It reaches from the 0.5 % to the 99.5 % quantile of the finite draws, but no further above the median than five times
/// the way down to the 2.5 % quantile, lest a long far side flatten the rest. `below`, `counts` and `beyond` add to the
/// number of draws.
#[derive(Clone, Debug, PartialEq)]
pub struct Histogram {
    /// Lower edge of the first bin.
    pub low: Length,
    /// Upper edge of the last bin (part of it).
    pub high: Length,
    /// Draws in each bin; one bin only where `low` equals `high`.
    pub counts: Vec<u32>,
    /// Draws nearer than `low`.
    pub below: u32,
    /// Draws farther than `high`, the infinite ones among them.
    pub beyond: u32,
}

/// Bins of a [`Histogram`].
pub const BINS: u32 = 64;

impl Distribution {
    /// Of the `sorted` finite draws in meters and the number of those infinitely far away.
    pub(super) fn of(sorted: &[f64], infinite: u32) -> Self {
        let drawn = count(sorted.len()).saturating_add(infinite);
        let share = |part: u32| f64::from(part) / f64::from(drawn.max(1));
        let at = |quantile| quantile_of(sorted, drawn, quantile).map(Length::from_m);
        Self {
            drawn,
            median: at(50_000),
            interval_68: Quantiles {
                near: at(15_866),
                far: at(84_134),
            },
            interval_95: Quantiles {
                near: at(2_500),
                far: at(97_500),
            },
            share_infinite: share(infinite),
            share_zero: share(count(sorted.partition_point(|&z| z <= 0.0))),
            histogram: histogram(sorted, infinite),
        }
    }
}

/// The quantile of `drawn` draws of which the finite ones are `sorted` and the rest lie above them; `quantile` in
/// 1/100 000. Interpolates between neighbors (definition 7 of R. J. Hyndman, Y. Fan, Sample quantiles in statistical
/// packages, The American Statistician 50, 1996).
fn quantile_of(sorted: &[f64], drawn: u32, quantile: u32) -> Option<f64> {
    const WHOLE: u64 = 100_000;
    // In whole numbers, because the position must not depend on rounding.
    let position = u64::from(drawn.checked_sub(1)?) * u64::from(quantile);
    let index = usize::try_from(position / WHOLE).ok()?;
    let below = *sorted.get(index)?;
    let remainder = u32::try_from(position % WHOLE).ok()?;
    if remainder == 0 {
        return Some(below);
    }
    let above = *sorted.get(index + 1)?;
    Some(below + (above - below) * (f64::from(remainder) / 100_000.0))
}

fn histogram(sorted: &[f64], infinite: u32) -> Option<Histogram> {
    let finite = count(sorted.len());
    let at = |quantile| quantile_of(sorted, finite, quantile);
    let (low, median) = (at(500)?, at(50_000)?);
    let high = at(99_500)?.min(median + 5.0 * (median - at(2_500)?)).max(low);
    let nearer_than = |edge: f64| count(sorted.partition_point(|&z| z < edge));
    let up_to_high = count(sorted.partition_point(|&z| z <= high));
    let bins = if low < high { BINS } else { 1 };
    let mut counts = Vec::new();
    let mut counted = nearer_than(low);
    for bin in 1..=bins {
        let edge = low + (high - low) * (f64::from(bin) / f64::from(bins));
        let up_to_edge = if bin == bins { up_to_high } else { nearer_than(edge) };
        counts.push(up_to_edge - counted);
        counted = up_to_edge;
    }
    Some(Histogram {
        low: Length::from_m(low),
        high: Length::from_m(high),
        counts,
        below: nearer_than(low),
        beyond: (finite - up_to_high).saturating_add(infinite),
    })
}

/// A number of draws; [`Distribution::drawn`] is a u32, and so is every part of it.
pub(super) fn count(n: usize) -> u32 {
    u32::try_from(n).unwrap_or(u32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_count_infinite_draws_at_the_far_end() {
        let sorted = [1.0, 2.0, 3.0];
        assert_eq!(quantile_of(&sorted, 3, 50_000), Some(2.0));
        assert_eq!(quantile_of(&sorted, 5, 50_000), Some(3.0));
        assert_eq!(quantile_of(&sorted, 5, 50_001), None, "half way to infinity is infinity");
        assert_eq!(quantile_of(&sorted, 2, 50_000), Some(1.5));
        assert_eq!(quantile_of(&[], 0, 50_000), None);
    }
}
