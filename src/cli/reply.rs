//! What a call is answered with, or why it is not.

use serde::Serialize;

/// An answer.
pub(super) struct Reply {
    /// For standard output, line ends included.
    pub(super) text: String,
    /// For standard error, a sentence each.
    pub(super) warnings: Vec<String>,
}

impl Reply {
    pub(super) const fn without_warnings(text: String) -> Self {
        Self {
            text,
            warnings: Vec::new(),
        }
    }
}

/// What is to be said about an option without refusing it.
#[derive(Serialize)]
pub(super) struct Warning {
    /// The option without its dashes.
    pub(super) field: String,
    pub(super) message: String,
}

/// Why there is no answer.
#[derive(Debug, PartialEq, Eq, Serialize)]
pub(super) struct Refusal {
    /// The option that is to blame, without its dashes.
    option: Option<String>,
    message: String,
    /// Both in one line, for people.
    #[serde(skip)]
    pub(super) line: String,
}

impl Refusal {
    /// A sentence that says everything, and the option that it is about, if it is about one.
    pub(super) fn sentence(option: Option<String>, sentence: impl Into<String>) -> Self {
        let message = sentence.into().replace('\n', " ");
        Self {
            option,
            line: message.clone(),
            message,
        }
    }

    /// What is wrong with the value of an option.
    pub(super) fn of_value(Warning { field, message }: Warning) -> Self {
        Self {
            line: format!("--{field}: {message}").replace('\n', " "),
            option: Some(field),
            message,
        }
    }

    /// `{"error": {"option": …, "message": …}}`, for a program to read.
    pub(super) fn json(&self) -> String {
        serde_json::json!({ "error": self }).to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::{Refusal, Warning};

    #[test]
    fn a_refusal_is_one_line_for_people_and_one_object_for_programs() {
        let of_value = Refusal::of_value(Warning {
            field: "fx".into(),
            message: "“a\nb” is not a number.".into(),
        });
        assert_eq!(of_value.line, "--fx: “a b” is not a number.");
        assert_eq!(of_value.json(), r#"{"error":{"message":"“a\nb” is not a number.","option":"fx"}}"#);
        assert_eq!(
            Refusal::sentence(None, "No distance\ncan be computed.").json(),
            r#"{"error":{"message":"No distance can be computed.","option":null}}"#
        );
    }
}
