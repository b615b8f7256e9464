//! How good are the first-order σ and the exact interval? Both ends of the 1 σ interval of a distance of 1.4 m, by the first
//! order (Z ± σ), by Fieller's formula and by a million random draws, the more uncertain the disparity the worse:
//!
//! ```text
//! cargo run --release -p depth-core --example accuracy
//! ```
//!
//! The last two columns are what matters: how far each is off the draws, in σ.

use depth_core::judge::Unsolvable;
use depth_core::measured::Measured;
use depth_core::monte_carlo::MonteCarlo;
use depth_core::quantity::Length;
use depth_core::uncertainty::Model;

const DRAWS: u32 = 1_000_000;

fn main() -> Result<(), Unsolvable> {
    println!("f 700 px ± 1 %, b 100 mm ± 1 %, d 50 px ± the first column; lengths in meters");
    println!("      |   first order   |      exact      |      draws      | off the draws, σ");
    println!("   ±d |   near     far  |   near     far  |   near     far  | 1st order  exact");
    for percent in [0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0, 50.0, 80.0] {
        let model = Model::stereo(
            Measured::from_base(700.0, 7.0),
            Measured::from_base(0.1, 0.001),
            Measured::from_base(50.0, percent / 100.0 * 50.0),
            Measured::from_base(0.0, 0.0),
        )?;
        println!("{}", row(percent, &model));
    }
    Ok(())
}

/// A line of the table.
fn row(percent: f64, model: &Model) -> String {
    let Measured { value, sigma } = model.depth_with_sigma().to_base();
    let exact = model.interval();
    let mut experiment = MonteCarlo::new(*model, 1);
    experiment.draw(DRAWS);
    let drawn = experiment.distribution().interval_68;

    let first_order = [Some(value - sigma), Some(value + sigma)];
    let exact = [Some(exact.near.m()), exact.far.map(Length::m)];
    let drawn = [drawn.near.map(Length::m), drawn.far.map(Length::m)];
    let columns = [first_order, exact, drawn].map(|[near, far]| format!("{} {}", meters(near), meters(far)));
    format!(
        "{percent:4} % | {} | {:9.3} {:6.3}",
        columns.join(" | "),
        worst(first_order, drawn, sigma),
        worst(exact, drawn, sigma)
    )
}

/// "1.400", or "∞" without an upper bound.
fn meters(end: Option<f64>) -> String {
    end.map_or_else(|| format!("{:>7}", "∞"), |end| format!("{end:7.4}"))
}

/// By how many σ the worse of the two ends is off.
fn worst(claimed: [Option<f64>; 2], drawn: [Option<f64>; 2], sigma: f64) -> f64 {
    claimed
        .into_iter()
        .zip(drawn)
        .map(|ends| match ends {
            (Some(claimed), Some(drawn)) => (claimed - drawn).abs() / sigma,
            (None, None) => 0.0,
            _ => f64::INFINITY,
        })
        .fold(0.0, f64::max)
}
