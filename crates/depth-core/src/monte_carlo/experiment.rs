//! The draws.

use super::distribution::{Distribution, count};
use super::random::Normal;
use crate::model::Model;

/// A random experiment that can be carried out in pieces: the same model and seed give the same draws however they are cut
/// up, and on every platform.
#[derive(Clone, Debug)]
pub struct MonteCarlo {
    model: Model,
    normal: Normal,
    /// In meters, sorted.
    finite: Vec<f64>,
    infinite: u32,
}

impl MonteCarlo {
    /// An experiment with no draws yet.
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
    /// assert_eq!(depth_core::monte_carlo::MonteCarlo::new(mug, 1).drawn(), 0);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    pub const fn new(model: Model, seed: u64) -> Self {
        Self {
            model,
            normal: Normal::new(seed),
            finite: Vec::new(),
            infinite: 0,
        }
    }

    /// Draws `n` times more.
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
    /// let mut experiment = depth_core::monte_carlo::MonteCarlo::new(mug, 1);
    /// experiment.draw(1000);
    /// assert_eq!(experiment.drawn(), 1000);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
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
    /// let mut experiment = depth_core::monte_carlo::MonteCarlo::new(mug, 1);
    /// experiment.draw(20);
    /// experiment.draw(30);
    /// assert_eq!(experiment.drawn(), 50);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    pub fn drawn(&self) -> u32 {
        count(self.finite.len()).saturating_add(self.infinite)
    }

    /// What the draws so far show.
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
    /// let mut experiment = depth_core::monte_carlo::MonteCarlo::new(mug, 1);
    /// experiment.draw(10_000);
    /// // 1.4 m with a σ of 5 %: the median of so many draws is off by less than 4 mm (four of its standard deviations).
    /// assert!((experiment.distribution().median.unwrap().m() - 1.4).abs() < 0.004);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    pub fn distribution(&self) -> Distribution {
        Distribution::of(&self.finite, self.infinite)
    }

    /// One draw in meters; `None` for infinitely far.
    fn distance(&mut self) -> Option<f64> {
        let Self { model, normal, .. } = self;
        model.draw(|term| normal.draw(term))
    }
}
