//! The Monte Carlo simulations, run beside the frames where first order is not good enough.
//!
//! They take a share of each frame, however long that is: on a slow screen, which draws few frames, they are done after as much time as on
//! a fast one. What comes out does not depend on how they are cut up.

use crate::core::monte_carlo::{Distribution, MonteCarlo};
use crate::core::problem::Method;
use crate::core::uncertainty::Model;
use depth_text::assess::Assessment;

/// Draws per simulation.
pub const DRAWS: u32 = 100_000;
/// Draws between two looks at the clock: half a millisecond.
const BATCH: u32 = 5_000;
/// The part of a frame that the simulations may take.
const SHARE_OF_FRAME: f64 = 1.0 / 3.0;
/// The least and the most time that they take in a frame, in seconds.
const LEAST_S: f64 = 0.001;
const MOST_S: f64 = 0.1;
/// Fixed, so that the figures are reproducible.
const SEED: u64 = 1954;

/// The simulations that the assessment asks for, one for each method.
#[derive(Debug, Default)]
pub struct Simulations {
    stereo: Simulation,
    monocular: Simulation,
}

/// The simulation of one method.
#[derive(Debug, Default)]
pub enum Simulation {
    #[default]
    None,
    Running(Model, Box<MonteCarlo>),
    Done(Model, Box<Distribution>),
}

impl Simulation {
    /// Restarts with `wanted` unless that is its model already.
    fn restart_for(&mut self, wanted: Option<Model>) {
        let current = match self {
            Self::None => None,
            Self::Running(model, _) | Self::Done(model, _) => Some(*model),
        };
        if current != wanted {
            *self = wanted.map_or(Self::None, |model| Self::Running(model, Box::new(MonteCarlo::new(model, SEED))));
        }
    }

    const fn is_running(&self) -> bool {
        matches!(self, Self::Running(..))
    }

    /// Draws the next batch. Returns whether there was anything to draw.
    fn advance(&mut self) -> bool {
        let Self::Running(model, running) = self else { return false };
        running.draw(BATCH);
        if running.drawn() >= DRAWS {
            *self = Self::Done(*model, Box::new(running.distribution()));
        }
        true
    }

    /// How much of it is done, 0 to 100.
    pub fn percent(&self) -> u16 {
        match self {
            Self::None => 0,
            Self::Running(_, running) => u16::try_from(running.drawn() / (DRAWS / 100)).unwrap_or(100),
            Self::Done(..) => 100,
        }
    }
}

/// How long a frame is, and a clock.
pub struct Time<'a> {
    /// The length of the last frame, in seconds.
    pub frame_s: f64,
    /// A clock that goes on while the program computes, in seconds.
    pub clock: &'a dyn Fn() -> f64,
}

impl Simulations {
    /// Runs the simulations that `assessment` needs for a share of the frame. Returns whether another frame is needed.
    pub fn advance(&mut self, assessment: &Assessment, time: &Time<'_>) -> bool {
        let wanted = |method| {
            let uncertainty = assessment.solution.uncertainty(method)?;
            (!uncertainty.model.first_order_is_good()).then_some(uncertainty.model)
        };
        self.stereo.restart_for(wanted(Method::Stereo));
        self.monocular.restart_for(wanted(Method::Monocular));
        if !(self.stereo.is_running() || self.monocular.is_running()) {
            return false;
        }
        let end = (time.clock)() + (time.frame_s * SHARE_OF_FRAME).clamp(LEAST_S, MOST_S);
        while self.stereo.advance() || self.monocular.advance() {
            if (time.clock)() >= end {
                break;
            }
        }
        self.stereo.is_running() || self.monocular.is_running()
    }

    /// The simulation of this method.
    pub const fn of(&self, method: Method) -> &Simulation {
        match method {
            Method::Stereo => &self.stereo,
            Method::Monocular => &self.monocular,
        }
    }
}

#[cfg(test)]
#[allow(clippy::panic, reason = "tests")]
mod tests {
    use super::*;
    use crate::core::problem::Field;
    use depth_text::form::{Example, Inputs};
    use std::cell::Cell;

    /// Both distances, too uncertain for the first order.
    fn uncertain(sigma: &str) -> Inputs {
        let mut inputs: Inputs = Example::CoffeeMug.inputs();
        inputs.entry_mut(Field::ImageWidth).text = "150".into();
        inputs.entry_mut(Field::RealWidth).text = "0.3".into();
        for field in [Field::Disparity, Field::ImageWidth] {
            inputs.set_sigma(field, sigma);
        }
        inputs
    }

    /// The frames until both simulations are done, where a frame takes `frame_s` and a batch `batch_s`, and what they find.
    fn run(frame_s: f64, batch_s: f64) -> (u32, Vec<Distribution>) {
        let now = Cell::new(7.0);
        let clock = || now.replace(now.get() + batch_s);
        let (assessment, mut simulations) = (uncertain("30 %").assess(), Simulations::default());
        let mut frames = 1;
        while simulations.advance(&assessment, &Time { frame_s, clock: &clock }) {
            frames += 1;
        }
        let found = Method::ALL.map(|method| match simulations.of(method) {
            Simulation::Done(_, distribution) => (**distribution).clone(),
            other => panic!("{other:?}"),
        });
        (frames, found.into())
    }

    #[test]
    fn where_frames_are_slow_a_simulation_takes_fewer() {
        // 40 batches: of 5.6 ms for a frame's share of 5.5 ms one fits, of 100 ms 18.
        let (fast, found) = run(1.0 / 60.0, 0.0056);
        assert_eq!(fast, 40);
        for (frame_s, batch_s, frames) in [
            (0.25, 0.0056, 3),
            (0.5, 0.0056, 3),
            (60.0, 0.0056, 3),
            (0.0, 0.0003, 10),
            (0.1, 5.0, 40),
            (0.1, 0.0, 1),
        ] {
            let (counted, same) = run(frame_s, batch_s);
            assert_eq!(counted, frames, "frames of {frame_s} s with batches of {batch_s} s");
            assert_eq!(same, found, "however they are cut up");
        }
    }

    #[test]
    fn how_much_is_done_is_known_and_a_change_starts_anew() {
        let mut simulations = Simulations::default();
        let time = Time {
            frame_s: 0.0,
            clock: &|| f64::INFINITY,
        };
        assert_eq!(simulations.of(Method::Stereo).percent(), 0);
        for percent in [5, 10, 15] {
            assert!(simulations.advance(&uncertain("30 %").assess(), &time));
            assert_eq!(simulations.of(Method::Stereo).percent(), percent);
        }
        assert!(simulations.advance(&uncertain("40 %").assess(), &time));
        assert_eq!(simulations.of(Method::Stereo).percent(), 5);
        assert!(!simulations.advance(&Inputs::default().assess(), &time));
        assert_eq!(simulations.of(Method::Stereo).percent(), 0);
    }
}
