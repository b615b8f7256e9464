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

/// Which input causes which part of a variance, in reading order; the shares add to 1. Empty where every input is exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Budget {
    shares: [Share; 4],
    len: usize,
}

impl Budget {
    /// The shares, in reading order.
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
    /// Source: JCGM 100:2008 (GUM), 5.1.3: each input's own term of the sum of squares.
    pub fn variance_budget(&self) -> Budget {
        let total = self.relative_sigma();
        let part = |relative: f64| if total == 0.0 { 0.0 } else { relative / total };
        let sources = self.relative_sigmas();
        let [.., (_, of_doffs)] = sources;
        let shares = sources.map(|(source, relative)| Share {
            source,
            share: part(relative) * part(relative),
        });
        let len = match total {
            0.0 => 0,
            _ => shares.len() - usize::from(of_doffs == 0.0),
        };
        Budget { shares, len }
    }
}
