//! The commands that build, serve and test Depth Calculator: `cargo xtask` lists them.

mod browsers;
mod check;
mod debian;
mod desktop;
mod dist;
mod lighthouse;
mod serve;
mod site;
mod size;
mod step;
mod test;
mod tools;

use std::process::ExitCode;

const HELP: &str = "\
Builds, serves and tests Depth Calculator. Every command sets up what it needs first.

  cargo xtask serve [--port 8080]   build the page and serve it on this computer
  cargo xtask test                  all tests, also those of size and in Chromium, Firefox and WebKit
  cargo xtask check                 formatting, lints, and that the mathematics builds alone
  cargo xtask dist                  build the page into dist/, for any static host
  cargo xtask size                  what a first visit downloads, against its budget
  cargo xtask lighthouse            what Lighthouse says about the page, against its floors

The desktop program needs none of them: cargo run --release
";

const DEFAULT_PORT: u16 = 8080;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let outcome = match words.as_slice() {
        [] | ["help" | "-h" | "--help"] => {
            print!("{HELP}");
            Ok(())
        }
        ["serve"] => serve::run(DEFAULT_PORT),
        ["serve", "--port", port] => match port.parse() {
            Ok(port) => serve::run(port),
            Err(_not_a_port) => Err(format!("A port is a number from 1 to 65535, not \"{port}\".")),
        },
        ["test"] => test::run_all(),
        ["check"] => check::run_all(),
        ["dist"] => dist::print(),
        ["size"] => dist::build().and_then(|dist| size::check(&dist)),
        ["lighthouse"] => lighthouse::audit(),
        other => Err(format!("There is no command \"{}\".\n\n{HELP}", other.join(" "))),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(sentence) => {
            eprintln!("\n{sentence}");
            ExitCode::FAILURE
        }
    }
}
