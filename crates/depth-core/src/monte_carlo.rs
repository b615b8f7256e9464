//! The distribution of a distance by drawing its inputs at random: what the formulas of [`uncertainty`](super::uncertainty)
//! approximate, without an approximation.
//!
//! Two kinds of draw have no distance of their own, and leaving them out would bend the answer, so both are counted:
//!
//! - A divisor (d + δ, or w_img) of 0 or less: the object is **infinitely far** away. Going down through 0 is the limit of
//!   ever farther distances, so these draws belong at the far end.
//! - A focal length, baseline or real width of 0 or less, though none can be: the distance shrinks to **zero** with each of
//!   them, so these draws belong at the near end, at 0. (Only a σ of a quarter of the value or more makes them.)
//!
//! Both ends keep the order of the draws, so that every quantile is right; the mean and the standard deviation of such a
//! distance do not exist, and none is given.

use crate::arithmetic::times_over;
use crate::measured::Measured;
use crate::quantity::{Length, Quantity};
use crate::uncertainty::Model;

/// A random experiment that can be carried out in pieces: the same model and seed give the same draws however they are cut
/// up, and on every platform.
#[derive(Clone, Debug)]
pub struct MonteCarlo {
    model: Model,
    normal: Normal,
    /// In metres, sorted.
    finite: Vec<f64>,
    infinite: u32,
}

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

impl MonteCarlo {
    /// An experiment with no draws yet.
    pub const fn new(model: Model, seed: u64) -> Self {
        Self {
            model,
            normal: Normal::new(seed),
            finite: Vec::new(),
            infinite: 0,
        }
    }

    /// Draws `n` times more.
    pub fn draw(&mut self, n: u32) {
        for _ in 0..n {
            match self.distance() {
                Some(distance) => self.finite.push(distance),
                None => self.infinite = self.infinite.saturating_add(1),
            }
        }
        // Sorted in each piece, no piece takes long: the stable sort finds what is in order already and merges it.
        self.finite.sort_by(f64::total_cmp);
    }

    /// The number of draws so far.
    pub fn drawn(&self) -> u32 {
        count(self.finite.len()).saturating_add(self.infinite)
    }

    /// What the draws so far show.
    pub fn distribution(&self) -> Distribution {
        let drawn = self.drawn();
        let share = |part: u32| f64::from(part) / f64::from(drawn.max(1));
        let at = |quantile| quantile_of(&self.finite, drawn, quantile).map(Length::from_m);
        Distribution {
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
            share_infinite: share(self.infinite),
            share_zero: share(count(self.finite.partition_point(|&z| z <= 0.0))),
            histogram: histogram(&self.finite, self.infinite),
        }
    }

    /// One draw in metres; `None` for infinitely far.
    fn distance(&mut self) -> Option<f64> {
        let focal_length = self.normal.draw(self.model.focal_length());
        let length = self.normal.draw(self.model.length().1);
        let divisor = self.normal.draw(self.model.divisor());
        if divisor <= 0.0 {
            None
        } else if focal_length <= 0.0 || length <= 0.0 {
            Some(0.0)
        } else {
            Some(times_over(focal_length, length, divisor)).filter(|z| z.is_finite())
        }
    }
}

/// The quantile of `drawn` draws of which the finite ones are `sorted` and the rest lie above them; `quantile` in
/// 1/100 000. Interpolates between neighbours (definition 7 of R. J. Hyndman, Y. Fan, Sample quantiles in statistical
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

/// A number of draws; [`MonteCarlo::drawn`] is a u32, and so is every part of it.
fn count(n: usize) -> u32 {
    u32::try_from(n).unwrap_or(u32::MAX)
}

/// Normally distributed random numbers by the ratio of uniforms.
///
/// Chosen over Box–Muller and the inverse distribution function because all it computes with is + − × ÷, which every
/// platform rounds alike. The one logarithm decides, in 1 % of the trials, whether a number is kept; only if two platforms'
/// last bits differed just where the two sides are equal would it decide differently.
///
/// Source: J. L. Leva, A fast normal random number generator, ACM Transactions on Mathematical Software 18 (1992).
#[derive(Clone, Debug)]
struct Normal {
    bits: SplitMix64,
}

impl Normal {
    const fn new(seed: u64) -> Self {
        Self { bits: SplitMix64(seed) }
    }

    /// A number with the mean and standard deviation of `quantity`, in its base unit.
    fn draw<Q: Quantity>(&mut self, quantity: Measured<Q>) -> f64 {
        let quantity = quantity.to_base();
        (quantity.value + quantity.sigma * self.standard()).clamp(-f64::MAX, f64::MAX)
    }

    /// A number with mean 0 and standard deviation 1.
    fn standard(&mut self) -> f64 {
        loop {
            let u = 1.0 - self.bits.uniform();
            let v = 1.7156 * (self.bits.uniform() - 0.5);
            let x = u - 0.449_871;
            let y = v.abs() + 0.386_595;
            let q = x * x + y * (0.196_00 * y - 0.254_72 * x);
            if q < 0.275_97 || (q <= 0.278_46 && v * v <= -4.0 * u.ln() * u * u) {
                return v / u;
            }
        }
    }
}

/// Random bits: a counter, scrambled. Passes BigCrush, and its period of 2⁶⁴ is ample here.
///
/// Source: G. L. Steele, D. Lea, C. H. Flood, Fast splittable pseudorandom number generators, OOPSLA 2014.
#[derive(Clone, Debug)]
struct SplitMix64(u64);

impl SplitMix64 {
    const fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// From 0 (included) to 1 (not), in steps of 2⁻⁵².
    const fn uniform(&mut self) -> f64 {
        // 52 random bits as the fraction of a number from 1 to 2.
        f64::from_bits(0x3ff0_0000_0000_0000 | (self.next() >> 12)) - 1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_are_those_of_the_published_generator() {
        let mut bits = SplitMix64(1_234_567);
        let first = [(); 5].map(|()| bits.next());
        // From the reference implementation in C by S. Vigna.
        let published = [
            6_457_827_717_110_365_317,
            3_203_168_211_198_807_973,
            9_817_491_932_198_370_423,
            4_593_380_528_125_082_431,
            16_408_922_859_458_223_821,
        ];
        assert_eq!(first, published);
    }

    /// Φ(x) for a few x, from tables of the normal distribution.
    const PHI: [(f64, f64); 7] = [
        (-3.0, 0.001_349_898),
        (-2.0, 0.022_750_132),
        (-1.0, 0.158_655_254),
        (0.0, 0.5),
        (0.5, 0.691_462_461),
        (1.5, 0.933_192_799),
        (2.5, 0.993_790_335),
    ];

    #[test]
    fn normal_numbers_follow_the_normal_distribution() {
        let n = 1_000_000_u32;
        let mut normal = Normal::new(42);
        let draws: Vec<f64> = (0..n).map(|_| normal.standard()).collect();
        for (x, phi) in PHI {
            let below = f64::from(count(draws.iter().filter(|&&draw| draw <= x).count())) / f64::from(n);
            let deviation = (phi * (1.0 - phi) / f64::from(n)).sqrt();
            assert!((below - phi).abs() < 4.0 * deviation, "{x}: {below} is not {phi} ± {deviation}");
        }
        let moment = |power| draws.iter().map(|draw| draw.powi(power)).sum::<f64>() / f64::from(n);
        // The variances of the sample moments are (E[x²ᵏ] − E[xᵏ]²)/n: 1, 2, 15 and 96 over n.
        for (power, expected, variance) in [(1, 0.0, 1.0_f64), (2, 1.0, 2.0), (3, 0.0, 15.0), (4, 3.0, 96.0)] {
            let deviation = (variance / f64::from(n)).sqrt();
            assert!(
                (moment(power) - expected).abs() < 4.0 * deviation,
                "moment {power}: {}",
                moment(power)
            );
        }
    }

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
