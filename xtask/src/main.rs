//! The commands that build, serve and test Depth Calculator: `cargo xtask` lists them.

mod apt;
mod architecture;
mod browsers;
mod check;
mod compress;
mod desktop;
mod dist;
mod files;
mod idle;
mod images;
mod licenses;
mod lighthouse;
mod origin;
mod package;
mod plan;
mod platforms;
mod prerequisites;
mod scripts;
mod second_module;
mod serve;
mod site;
mod size;
mod speech;
mod step;
mod table;
mod test;
mod tools;

use clap::{Parser, Subcommand, ValueEnum};
use std::process::ExitCode;

/// Builds, serves and tests Depth Calculator. Every command sets up what it needs first.
#[derive(Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask", arg_required_else_help = true)]
#[command(after_help = "The desktop program needs none of them: cargo run --release")]
struct Xtask {
    #[command(subcommand)]
    command: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Build the page and serve it on this computer
    Serve {
        /// Where it is served: http://127.0.0.1:PORT/
        #[arg(long, default_value_t = 8080, value_parser = clap::value_parser!(u16).range(1..))]
        port: u16,
    },
    /// Run all tests, or only some: in Rust, of the desktop program, of size, and in Chromium, Firefox and WebKit
    Test(test::Options),
    /// Architecture, formatting, lints, documentation, spelling, licenses, and that the mathematics builds alone
    Check {
        /// Only what has one of these words in its name
        #[arg(value_name = "WORD")]
        words: Vec<String>,
    },
    /// Build what is given away: the page into dist/, for any static host, or the archive of the desktop program
    Dist {
        #[arg(value_enum, default_value_t = What::Page)]
        what: What,
        /// Build the desktop program for another kind of computer
        #[arg(long, value_name = "TRIPLE")]
        target: Option<String>,
    },
    /// What a first visit downloads, against its budget
    Size,
    /// What Lighthouse says about the page, against its floors
    Lighthouse {
        /// Audits for each device; the median counts
        #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..))]
        runs: u32,
        #[command(flatten)]
        places: browsers::Places,
    },
    /// What the page costs while nobody does anything, against its goals: processor time in Chromium on Linux
    Idle {
        /// For how long each page is measured
        #[arg(long, default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..))]
        seconds: u32,
        #[command(flatten)]
        places: browsers::Places,
    },
    /// What a screen reader says of the page, against what it said before: Orca with Firefox and Chromium, on Linux
    Speech {
        /// Write down what is said now
        #[arg(long)]
        update: bool,
        #[command(flatten)]
        places: browsers::Places,
    },
    /// Write assets/licenses.txt anew, after the crates have changed
    Licenses,
}

#[derive(Clone, Copy, ValueEnum)]
enum What {
    /// The web page; the environment variable SITE_URL says where it will be
    Page,
    /// The desktop program
    Desktop,
}

fn main() -> ExitCode {
    let outcome = match Xtask::parse().command {
        Task::Serve { port } => serve::run(port),
        Task::Test(options) => test::run_chosen(&options),
        Task::Check { words } => check::run_chosen(&words),
        Task::Dist { what: What::Page, .. } => dist::print(),
        Task::Dist {
            what: What::Desktop,
            target,
        } => package::desktop(target.as_deref()),
        Task::Size => dist::checked_build(true).and_then(|dist| size::check(&dist)),
        Task::Lighthouse { runs, places } => lighthouse::audit(runs, &places),
        Task::Idle { seconds, places } => idle::measure(seconds, &places),
        Task::Speech { update, places } => speech::listen(update, &places),
        Task::Licenses => licenses::write(),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(sentence) => {
            eprintln!("\n{sentence}");
            ExitCode::FAILURE
        }
    }
}
