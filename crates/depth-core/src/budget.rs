//! [`Budget`]: which input causes which part of a variance.

use crate::field::Field;
use crate::model::Model;

/// The part of the variance that one input is responsible for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// The input.
    pub source: Field,
    /// Its part of the variance, 0 to 1.
    pub share: f64,
}

/// What an input with this share of the variance makes of `sigma` alone: σ·√share.
///
/// ```
/// use depth_core::uncertainty::part_of_sigma;
///
/// assert!((part_of_sigma(0.64, 0.05) - 0.04).abs() < 1e-12);
/// ```
///
/// Source: JCGM 100:2008 (GUM), 5.1.3: u_i(y), whose squares add to that of u(y).
pub fn part_of_sigma(share: f64, sigma: f64) -> f64 {
    sigma * share.sqrt()
}

/// Which input causes which part of a variance, in reading order; the shares add to 1. Empty where every input is exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Budget {
    shares: [Share; 4],
    len: usize,
}

impl Budget {
    /// The shares, in reading order.
    ///
    /// ```
    /// # use depth_core::measured::Measured;
    /// # use depth_core::uncertainty::Model;
    /// // f known to 3 %, d to 4 %.
    /// let mug = Model::stereo(
    ///     Measured::from_base(700.0, 21.0),
    ///     Measured::from_base(0.1, 0.0),
    ///     Measured::from_base(50.0, 2.0),
    ///     Measured::from_base(0.0, 0.0),
    /// )?;
    /// // 9 % and 16 % of 25 %; the baseline is exact.
    /// let shares: Vec<f64> = mug.variance_budget().shares().iter().map(|share| (share.share * 100.0).round()).collect();
    /// assert_eq!(shares, [36.0, 0.0, 64.0]);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    pub fn shares(&self) -> &[Share] {
        self.shares.get(..self.len).unwrap_or_default()
    }
}

impl std::ops::Deref for Budget {
    type Target = [Share];

    fn deref(&self) -> &[Share] {
        self.shares()
    }
}

impl<'a> IntoIterator for &'a Budget {
    type Item = &'a Share;
    type IntoIter = std::slice::Iter<'a, Share>;

    fn into_iter(self) -> Self::IntoIter {
        self.shares().iter()
    }
}

impl Model {
    /// Which input is responsible for which part of the first-order variance. Doffs takes part where it has a σ.
    ///
    /// ```
    /// # use depth_core::measured::Measured;
    /// # use depth_core::uncertainty::Model;
    /// // f known to 3 %, d to 4 %.
    /// let mug = Model::stereo(
    ///     Measured::from_base(700.0, 21.0),
    ///     Measured::from_base(0.1, 0.0),
    ///     Measured::from_base(50.0, 2.0),
    ///     Measured::from_base(0.0, 0.0),
    /// )?;
    /// let budget = mug.variance_budget();
    /// // Doffs is exact and does not take part.
    /// assert_eq!(budget.len(), 3);
    /// // (4 %)²/(5 %)².
    /// assert!((budget[2].share - 0.64).abs() < 1e-12);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    ///
    /// Source: JCGM 100:2008 (GUM), 5.1.3: each input's own term of the sum of squares.
    pub fn variance_budget(&self) -> Budget {
        let sources = self.relative_sigmas();
        let [.., (_, of_doffs)] = sources;
        // As parts of the largest: the smallest numbers have few digits, and so has the root of the sum of their squares.
        let most = sources.iter().map(|(_, relative)| *relative).fold(0.0, f64::max);
        let part = |relative: f64| if most == 0.0 { 0.0 } else { relative / most };
        let total: f64 = sources.iter().map(|(_, relative)| part(*relative) * part(*relative)).sum();
        let shares = sources.map(|(source, relative)| Share {
            source,
            share: if most == 0.0 {
                0.0
            } else {
                part(relative) * part(relative) / total
            },
        });
        let len = match most {
            0.0 => 0,
            _ => shares.len() - usize::from(of_doffs == 0.0),
        };
        Budget { shares, len }
    }
}
