//! Floor 4: the command line. The same `Inputs -> Problem -> Solution` as the screens, answered as text or JSON.

mod calculate;
mod digits;
mod json;
mod manual;
mod options;
mod reply;
mod text;
mod warning;

use crate::formats::sentences::CommandLine;

use clap::{CommandFactory, Parser, Subcommand};
use clap_complete::Shell;
use options::Calculate;
use reply::Reply;
use std::ffi::{OsStr, OsString};
use std::io::{ErrorKind, Write};
use std::process::ExitCode;

const NAME: &str = "depth-calculator";

/// Status of a call that is not answered; 1 is left for an answer that could not be written.
const REFUSED: u8 = 2;

#[cfg(feature = "app")]
const LONG_ABOUT: &str = "\
How far away is it, and how sure can I be?

Without arguments the program opens its window. With `calculate` it answers here and needs no display.";
#[cfg(not(feature = "app"))]
const LONG_ABOUT: &str = "\
How far away is it, and how sure can I be?

This is the command line alone: it was built without the window.";

/// How far away is it, and how sure can I be?
#[derive(Debug, Parser)]
#[command(name = NAME, version, about, long_about = LONG_ABOUT)]
struct Cli {
    #[command(subcommand)]
    command: Option<Task>,
}

#[derive(Debug, Subcommand)]
enum Task {
    /// Compute the distance from a disparity (two cameras), from a known size (one camera), or both
    #[command(after_long_help = options::MORE_HELP)]
    Calculate(Box<Calculate>),
    /// Print the completions of a shell, to be stored where it looks for them
    #[command(after_long_help = COMPLETIONS_HELP)]
    Completions {
        /// The shell
        shell: Shell,
    },
    /// Print the manual page, in the format of man
    #[command(after_long_help = MAN_HELP)]
    Man,
}

const COMPLETIONS_HELP: &str = "\
Examples:
  depth-calculator completions bash \\
      > ~/.local/share/bash-completion/completions/depth-calculator
  depth-calculator completions zsh > ~/.zfunc/_depth-calculator
      where ~/.zfunc is a folder of fpath
  depth-calculator completions fish \\
      > ~/.config/fish/completions/depth-calculator.fish
  depth-calculator completions powershell >> $PROFILE";

const MAN_HELP: &str = "\
Examples:
  depth-calculator man > ~/.local/share/man/man1/depth-calculator.1
  depth-calculator man | man -l -";

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
    // What cannot be said on standard error can be said nowhere.
    let reply = match Cli::try_parse_from(join_negative_values(arguments)) {
        Ok(Cli { command: Some(task) }) => task.reply(),
        Ok(Cli { command: None }) => {
            let _ = writeln!(err, "{}", Cli::command().render_help());
            Err(CommandLine::NoCommand.to_string())
        }
        Err(error) if error.use_stderr() => Err(in_one_line(&error)),
        Err(help_or_version) => Ok(Reply::without_warnings(help_or_version.render().to_string())),
    };
    match reply {
        Ok(reply) => {
            let status = written(&reply.text, out, err);
            for warning in reply.warnings {
                let _ = writeln!(err, "{NAME}: warning: {warning}");
            }
            status
        }
        Err(reason) => {
            let _ = writeln!(err, "{NAME}: {}", reason.replace('\n', " "));
            ExitCode::from(REFUSED)
        }
    }
}

impl Task {
    /// The answer, or one sentence that says why there is none.
    fn reply(&self) -> Result<Reply, String> {
        match self {
            Self::Calculate(calculate) => calculate.reply(),
            Self::Completions { shell } => Ok(Reply::without_warnings(completions(*shell))),
            Self::Man => manual::page().map(Reply::without_warnings).map_err(|error| error.to_string()),
        }
    }
}

/// The script that makes `shell` complete the command line.
fn completions(shell: Shell) -> String {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), NAME, &mut script);
    // For bash clap writes the hyphen of the name in two ways, so that nothing behind a command is completed:
    // https://github.com/clap-rs/clap/issues/6421
    String::from_utf8_lossy(&script).replace("depth__subcmd__calculator", "depth__calculator")
}

/// Joins a value that starts with a minus sign to its option: `--doffs -2.5px` becomes `--doffs=-2.5px`.
///
/// Of clap's two ways to take such a value, `allow_negative_numbers` leaves out those with a unit, and
/// `allow_hyphen_values` takes the next option for the value where a value was forgotten.
fn join_negative_values(arguments: impl IntoIterator<Item = OsString>) -> Vec<OsString> {
    let root = Cli::command();
    let options: Vec<String> = root
        .get_subcommands()
        .flat_map(clap::Command::get_arguments)
        .filter(|argument| argument.get_action().takes_values())
        .filter_map(|argument| Some(format!("--{}", argument.get_long()?)))
        .collect();
    let mut joined: Vec<OsString> = Vec::new();
    for argument in arguments {
        match joined.last_mut() {
            Some(last) if starts_with_minus(&argument) && options.iter().any(|option| *last == **option) => {
                last.push("=");
                last.push(argument);
            }
            _ => joined.push(argument),
        }
    }
    joined
}

/// Whether `argument` starts with one minus sign and is not the only option that does.
fn starts_with_minus(argument: &OsStr) -> bool {
    argument
        .to_str()
        .and_then(|text| text.strip_prefix('-'))
        .is_some_and(|rest| !rest.is_empty() && !rest.starts_with('-') && rest != "h")
}

/// What clap says in several lines, with its tips and without the usage, in one.
fn in_one_line(error: &clap::Error) -> String {
    let text = error.render().to_string();
    let mut line = String::new();
    let reason = text
        .lines()
        .map(str::trim)
        .take_while(|part| !part.starts_with("Usage:") && !part.starts_with("For more information"));
    for part in reason.filter(|part| !part.is_empty()) {
        match (part.strip_prefix("tip: "), line.as_str()) {
            (_, "") => line.push_str(part.trim_start_matches("error: ")),
            (Some(tip), _) => line.extend(["; ", tip]),
            (None, _) => line.extend([" ", part]),
        }
    }
    line + " (see --help)"
}

/// Writes `text` to the end. A reader that went away (a closed pipe) wanted no more; nothing is wrong then.
fn written(text: &str, out: &mut dyn Write, err: &mut dyn Write) -> ExitCode {
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            let reason = error.to_string();
            let reason = reason.split(" (os error").next().unwrap_or_default();
            let sentence = CommandLine::NotWritten { reason: reason.to_owned() };
            let _ = writeln!(err, "{NAME}: {sentence}");
            ExitCode::FAILURE
        }
        _ => ExitCode::SUCCESS,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_parser_is_sound() {
        Cli::command().debug_assert();
    }

    #[test]
    fn only_a_value_that_starts_with_one_minus_is_joined_to_its_option() {
        for (typed, joined) in [
            ("x calculate --doffs -2.5 --json", "x calculate --doffs=-2.5 --json"),
            ("x calculate --doffs -.5px", "x calculate --doffs=-.5px"),
            ("x calculate --unit -5", "x calculate --unit=-5"),
            ("x calculate --fx --baseline 100", "x calculate --fx --baseline 100"),
            ("x calculate --fx -h", "x calculate --fx -h"),
            ("x calculate --fx - 5", "x calculate --fx - 5"),
            ("x calculate --json -5", "x calculate --json -5"),
            ("x calculate --fx 7 -5", "x calculate --fx 7 -5"),
        ] {
            let words = |text: &str| text.split(' ').map(OsString::from).collect::<Vec<_>>();
            assert_eq!(join_negative_values(words(typed)), words(joined), "{typed}");
        }
    }
}
