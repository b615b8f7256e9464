//! Normally distributed random numbers, the same on every platform.

use crate::measured::Measured;
use crate::quantity::Quantity;

/// Normally distributed random numbers by the ratio of uniforms.
///
/// Chosen over Box–Muller and the inverse distribution function because all it computes with is + − × ÷, which every
/// platform rounds alike. The one logarithm decides, in 1 % of the trials, whether a number is kept; only if two platforms'
/// last bits differed just where the two sides are equal would it decide differently.
///
/// Source: J. L. Leva, A fast normal random number generator, ACM Transactions on Mathematical Software 18 (1992).
#[derive(Clone, Debug)]
pub(super) struct Normal {
    bits: SplitMix64,
}

impl Normal {
    pub(super) const fn new(seed: u64) -> Self {
        Self { bits: SplitMix64(seed) }
    }

    /// A number with the mean and standard deviation of `quantity`, in its base unit.
    pub(super) fn draw<Q: Quantity>(&mut self, quantity: Measured<Q>) -> f64 {
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
    use super::super::distribution::count;
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
}
