//! How far away is it, and how sure can I be?
//!
//! # Where things are
//!
//! Each module uses only those above it in this list:
//!
//! | module | what |
//! |---|---|
//! | [`core`], the crate `depth-core` | the mathematics: quantities with their unit in the type, and pure functions, every formula with its source |
//! | [`depth_text`] | what people type and read: numbers, fields and what is wrong with them, links, the report |
//! | `depth_files` | calibration files, each format in a file |
//! | `depth_jobs` | work beside the window: what is asked, what is answered, and the module that does it in a browser |
//! | `egui_mirror` | an accessible page beside an egui canvas; knows nothing of this program |
//! | `app` | the egui application, the same in a browser, in a window and under test |
//! | `cli` | the command line, one subcommand a file; builds without `app` |
//! | `platform` | the entry points of the web page and the desktop program, and what only one of them has |
//!
//! # How data flows
//!
//! What a person types is [`Inputs`](depth_text::form::Inputs). [`Inputs::assess`](depth_text::form::Inputs::assess) reads it once, into
//! an [`Assessment`](depth_text::assess::Assessment): a note for each field that needs one, and the
//! [`Solution`](core::problem::Solution) of the [`Problem`](core::problem::Problem). Pictures, text and the report are made from that.
//!
//! # A frame of the application
//!
//! `app::App` is drawn by `app/ui.rs`. A screen is a folder with a function `ui(&mut self, ui: &mut Ui, cx: &mut AppContext)`: it draws
//! what `cx` holds and adds commands to it. Of the events that have happened since, it gets those up to the first that can move the
//! focus; `app/batches.rs` keeps the others for the next frame. Before the next frame `app/logic.rs` carries the commands out, the one
//! place where they take effect, then handles the events of the platform, and saves what changed.
//!
//! # To change something
//!
//! | what | where |
//! |---|---|
//! | a formula | [`core`], with its source and a golden test |
//! | what is said about an input | [`depth_text::sentences`], and a case in `tests/sentences/` |
//! | what the application says besides | `app/sentences/`, with an example in the test of its file |
//! | a field | a row of [`depth_text::fields`]: form, link, report, command line and stored state have it then |
//! | a button, a menu entry, a key | `app/command.rs` for its text and its keys, `app/logic.rs` for what it does |
//! | a dialog | `app/dialog.rs`, and a file like `app/about.rs` |
//! | a picture | `crates/depth-figures`: a pure model and a pure layout that give shapes; `app/calculator/pictures/` for pointer and keys |
//! | a calibration format | `crates/depth-files/src/formats/` |
//! | long work | a `Job` and its `Outcome` in `crates/depth-jobs`, a `Work` in its `engine.rs` |
//! | a screen | `Screen` in `app/saved.rs`, a folder like `app/learn/`, and its line in `app/ui.rs` |
//! | a color, a size, a font | `app/theme/` |
//! | what the program needs from the machine | `app/platform.rs`, then both platforms and the tests' |
//!
//! # Without a window
//!
//! ```
//! use depth_calculator::core::in_image::InImage;
//! use depth_calculator::core::measured::Measured;
//! use depth_calculator::core::problem::Problem;
//! use depth_calculator::core::quantity::{Length, LengthUnit};
//!
//! let mug = Problem {
//!     focal_length: Some(InImage::from_px(700.0)),
//!     baseline: Some(Measured::exact(Length::new(10.0, LengthUnit::Centimeter))),
//!     disparity: Some(InImage::from_px(50.0)),
//!     ..Problem::default()
//! };
//! assert_eq!(mug.solve().stereo.distance(), Some(Length::from_m(1.4)));
//! ```

#[cfg(feature = "app")]
pub mod app;
#[cfg(all(feature = "cli", not(target_arch = "wasm32")))]
pub mod cli;
#[cfg(feature = "app")]
pub mod platform;

pub use depth_core as core;
