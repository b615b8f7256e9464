//! Whether a part of the tests can run on this computer, said before minutes are spent on the others.

use std::fmt;

/// What will become of a part.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Plan {
    /// It will run; the words, if any, say with what.
    Run(String),
    /// It will run after something is installed or built: a sentence saying what.
    RunAfter(String),
    /// It will be left out: a sentence saying why.
    LeaveOut(String),
}

impl fmt::Display for Plan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Run(with) if with.is_empty() => write!(f, "will run"),
            Self::Run(with) => write!(f, "will run with {with}"),
            Self::RunAfter(what) => write!(f, "will run. {what}"),
            Self::LeaveOut(why) => write!(f, "will be left out. {why}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Plan;

    #[test]
    fn a_plan_says_whether_a_part_will_run_and_why_not() {
        assert_eq!(Plan::Run(String::new()).to_string(), "will run");
        assert_eq!(Plan::Run("Firefox 153".into()).to_string(), "will run with Firefox 153");
        assert_eq!(
            Plan::RunAfter("There is no Xvfb; it will be installed.".into()).to_string(),
            "will run. There is no Xvfb; it will be installed."
        );
        assert_eq!(
            Plan::LeaveOut("AT-SPI exists on Linux only.".into()).to_string(),
            "will be left out. AT-SPI exists on Linux only."
        );
    }
}
