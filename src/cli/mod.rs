//! The command line. The same `Inputs -> Problem -> Solution` as the screens, answered as text or JSON.

mod arguments;
mod ascii;
mod between;
mod calculate;
mod calibration;
mod camera;
mod camera_facts;
mod completions;
mod decode;
mod file;
mod fill;
mod ground;
mod help;
mod import;
mod json;
mod manual;
mod options;
mod parse;
mod presets;
mod q;
mod reply;
mod sizes;
mod step;
mod text;
mod typed;
mod warning;

use depth_text::sentences::CommandLine;

use arguments::{Cli, NAME, Task};
use clap::CommandFactory;
use parse::Call;
use reply::Reply;
use std::ffi::OsString;
use std::io::{ErrorKind, Write};
use std::process::ExitCode;

/// Status of a call that is not answered; 1 is left for an answer that could not be written.
const REFUSED: u8 = 2;

/// Whether the arguments of the process ask for anything. `--` alone only says that there are none.
pub fn is_asked() -> bool {
    std::env::args_os().skip(1).any(|argument| argument != "--")
}

/// Reads the arguments of the process and answers on its standard output.
pub fn main() -> ExitCode {
    run(std::env::args_os(), &mut std::io::stdout().lock(), &mut std::io::stderr().lock())
}

/// Answers `arguments` (the program's name first) on `out`, or says on `err` in one line why not.
///
/// Status 0 with an answer, also when one method is complete and the other is not; 2 without one; 1 where `out` could not
/// be written.
pub fn run(arguments: impl IntoIterator<Item = OsString>, out: &mut dyn Write, err: &mut dyn Write) -> ExitCode {
    let arguments = parse::join_negative_values(arguments);
    let reply = match parse::parse(&arguments) {
        Ok(Call::Task(task)) => answer(&task),
        Ok(Call::Text(text)) => Ok(Reply::without_warnings(text)),
        Ok(Call::Nothing) => Err(nothing_asked(err)),
        Err(refusal) => Err(refusal),
    };
    match reply {
        Ok(reply) => {
            let status = match write(&reply.text, out) {
                Ok(()) => ExitCode::SUCCESS,
                Err(refusal) => say(&refusal, err, ExitCode::FAILURE),
            };
            for warning in reply.warnings {
                let _ = writeln!(err, "{NAME}: warning: {warning}");
            }
            status
        }
        Err(refusal) => say(&refusal, err, ExitCode::from(REFUSED)),
    }
}

/// Says why there is no answer. Returns `status`.
fn say(refusal: &str, err: &mut dyn Write, status: ExitCode) -> ExitCode {
    // What cannot be said on standard error can be said nowhere.
    let _ = writeln!(err, "{NAME}: {}", refusal.replace('\n', " "));
    status
}

fn answer(task: &Task) -> Result<Reply, String> {
    match task {
        Task::Calculate(calculate) => calculate.reply(),
        Task::Ground(ground) => ground.reply(),
        Task::Step(step) => step.reply(),
        Task::Between(between) => between.reply(),
        Task::Import(import) => import.reply(),
        Task::Q(q) => q.reply(),
        Task::Camera(camera) => camera.reply(),
        Task::Presets(presets) => presets.reply(),
        Task::Sizes(sizes) => sizes.reply(),
        Task::Decode(decode) => decode.reply(),
        Task::Completions { shell } => Ok(Reply::without_warnings(completions::script(*shell))),
        Task::Man => {
            let page = manual::page().map_err(|error| error.to_string());
            page.map(Reply::without_warnings)
        }
    }
}

/// Prints the help, and returns why that is no answer.
fn nothing_asked(err: &mut dyn Write) -> String {
    let _ = writeln!(err, "{}", Cli::command().render_help());
    CommandLine::NoCommand.to_string()
}

/// Writes `text` to the end. A reader that went away (a closed pipe) wanted no more; nothing is wrong then.
fn write(text: &str, out: &mut dyn Write) -> Result<(), String> {
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            let reason = error.to_string();
            let reason = reason.split(" (os error").next().unwrap_or_default().to_owned();
            Err(CommandLine::NotWritten { reason }.to_string())
        }
        _ => Ok(()),
    }
}
