//! Parses the arguments of a call, and puts what clap says about them into one line.

use super::arguments::{Cli, Task};
use clap::error::ErrorKind;
use clap::{CommandFactory, Parser};
use std::ffi::{OsStr, OsString};

/// What a call asks for.
pub(super) enum Call {
    Task(Task),
    /// There are no arguments.
    Nothing,
    /// Help, or the version.
    Text(String),
}

/// Parses `arguments`, of which the first is the program's name.
pub(super) fn parse(arguments: &[OsString]) -> Result<Call, String> {
    match Cli::try_parse_from(arguments) {
        Ok(Cli { command: Some(task) }) => Ok(Call::Task(task)),
        Ok(Cli { command: None }) => Ok(Call::Nothing),
        Err(error) if error.use_stderr() => Err(in_one_line(&error)),
        Err(help_or_version) => Ok(Call::Text(help_or_version.render().to_string())),
    }
}

/// Joins a value that starts with a minus sign to its option: `--doffs -2.5px` becomes `--doffs=-2.5px`.
///
/// Of clap's two ways to take such a value, `allow_negative_numbers` leaves out those with a unit, and
/// `allow_hyphen_values` takes the next option for the value where a value was forgotten.
pub(super) fn join_negative_values(arguments: impl IntoIterator<Item = OsString>) -> Vec<OsString> {
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
    if error.kind() == ErrorKind::InvalidSubcommand {
        let commands: Vec<String> = Cli::command()
            .get_subcommands()
            .map(|command| command.get_name().to_owned())
            .collect();
        line.extend(["; the commands are ", &commands.join(", ")]);
    }
    line + " (see --help)"
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
