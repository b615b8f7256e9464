//! `sizes`: objects whose size is known, and what `calculate --known` fills in of one.

use super::reply::Reply;
use super::typed::Typed;
use crate::core::quantity::Length;
use crate::core::setup::Object;
use clap::Args;
use depth_presets::{SIZES, Size};
use depth_text::field::Key;
use depth_text::fields;
use depth_text::note::Part;
use depth_text::number::{Notation, TYPED_DIGITS};
use serde::Serialize;

/// What was given to `sizes`.
#[derive(Debug, Args)]
pub(super) struct Sizes {
    /// One of them; without it all are listed
    name: Option<String>,
    /// Answer in JSON: lengths in meters, null for what is unknown
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Answer {
    name: &'static str,
    label: &'static str,
    size_m: f64,
    sigma_m: Option<f64>,
    source: &'static str,
}

impl From<&Size> for Answer {
    fn from(size: &Size) -> Self {
        Self {
            name: size.name,
            label: size.label,
            size_m: size.size.m(),
            sigma_m: size.sigma.map(|sigma| sigma.m()),
            source: size.source,
        }
    }
}

impl Sizes {
    /// The answer, or one sentence that says why there is none.
    pub(super) fn reply(&self) -> Result<Reply, String> {
        let one = self.name.as_deref().map(find).transpose()?;
        match (one, self.json) {
            (Some(size), true) => Reply::json(&Answer::from(size)),
            (Some(size), false) => Ok(Reply::without_warnings(format!(
                "{}: {}\n{}\n",
                size.label,
                in_words(size),
                size.source
            ))),
            (None, true) => Reply::json(&SIZES.iter().map(Answer::from).collect::<Vec<_>>()),
            (None, false) => Ok(Reply::without_warnings(list())),
        }
    }
}

/// Fills in the real width with the size `name`, and how uncertain it is, where they were not typed. Returns what of the object that is, and what is to be said of it.
/// Err: a sentence, where there is no such size.
pub(super) fn fill(name: &str, typed: &mut Typed, unknown: Option<Key>) -> Result<(Object, String), String> {
    let size = find(name)?;
    let key = fields::REAL_WIDTH;
    if typed.is_given(key, Part::Value) || unknown == Some(key) {
        let why = if unknown == Some(key) { "is solved for" } else { "was typed" };
        let said = format!("Nothing of {} is used: the real width {why}.", size.label);
        return Ok((size.object, said));
    }
    let millimeters = |length: Length| format!("{} mm", number(length.m() * 1000.0));
    typed.typed.push((key, Part::Value, millimeters(size.size)));
    if let Some(sigma) = size.sigma.filter(|_| !typed.is_given(key, Part::Sigma)) {
        typed.typed.push((key, Part::Sigma, millimeters(sigma)));
    }
    Ok((size.object, format!("{}: {}; {}.", size.label, in_words(size), size.source)))
}

fn find(name: &str) -> Result<&'static Size, String> {
    Size::named(name).ok_or_else(|| {
        let names: Vec<&str> = SIZES.iter().map(|size| size.name).collect();
        format!("No size is called “{name}”: there are {}.", names.join(", "))
    })
}

fn number(value: f64) -> String {
    Notation::LONG.plain(value, TYPED_DIGITS)
}

fn in_words(size: &Size) -> String {
    let value = number(size.size.m() * 1000.0);
    match size.sigma {
        Some(sigma) => format!("({value} +/- {}) mm", number(sigma.m() * 1000.0)),
        None => format!("{value} mm"),
    }
}

fn list() -> String {
    let width = SIZES.iter().map(|size| size.name.len()).max().unwrap_or_default();
    let line = |size: &Size| format!("{:<width$}  {:<22}  {}\n", size.name, in_words(size), size.label);
    SIZES.iter().map(line).collect()
}
