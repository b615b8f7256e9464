//! `cargo xtask test`: every test, from the formulas to a real browser.

use crate::step::{cargo, run, step};
use crate::{browsers, desktop, dist, size};

/// Runs all tests; the browsers get the page exactly as `cargo xtask dist` leaves it.
pub(crate) fn run_all() -> Result<(), String> {
    step("Tests and examples in the documentation", || {
        run(&mut cargo(&["test", "--locked", "--workspace"]))
    })?;
    desktop::test()?;
    let dist = dist::build()?;
    step("Size of the first visit", || size::check(&dist))?;
    browsers::test(&dist)
}
