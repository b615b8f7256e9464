//! A case as it stands in its file.

use depth_calculator::core::problem::Method;
use depth_calculator::core::setup::{Object, Pair};
use depth_text::entry::Entries;
use depth_text::field::Key;
use depth_text::form::Inputs;

pub struct Case<'a> {
    /// What stands in brackets before a comma: "form", "way kitti".
    pub typed_into: &'a str,
    /// What stands behind the comma.
    pub how: &'a str,
    /// What is typed: the lines below.
    pub typed: &'a str,
}

/// The cases in the text of a file. Lines before the first are a remark for whoever reads it.
pub fn cases(text: &str) -> Vec<Case<'_>> {
    text.split("\n[")
        .skip(1)
        .map(|case| {
            let (head, typed) = case.split_once(']').unwrap();
            let (typed_into, how) = head.split_once(", ").unwrap_or((head, ""));
            Case {
                typed_into,
                how,
                typed: typed.trim(),
            }
        })
        .collect()
}

impl Case<'_> {
    pub fn entries(&self) -> Entries {
        let mut entries = Entries::default();
        for line in self.typed.lines().filter(|line| self.choice(line).is_none()) {
            let (name, text) = line.split_once('=').unwrap_or_else(|| panic!("{line:?} is not: field = text"));
            let text = text.trim().to_owned();
            let (is_sigma, name) = name.trim().strip_prefix("± ").map_or((false, name.trim()), |name| (true, name));
            let entry = entries.entry_mut(Key::named(name).unwrap_or_else(|| panic!("there is no field {name}")));
            *(if is_sigma { &mut entry.sigma } else { &mut entry.text }) = text;
        }
        entries
    }

    /// What is chosen in a line "object: height".
    fn choice<'b>(&self, line: &'b str) -> Option<(&'b str, &'b str)> {
        let (name, chosen) = line.split_once(": ")?;
        ["object", "pair"].contains(&name).then_some((name, chosen))
    }

    fn chosen(&self, name: &str) -> Option<&str> {
        let mut choices = self.typed.lines().filter_map(|line| self.choice(line));
        choices.find(|(choice, _)| *choice == name).map(|(_, chosen)| chosen)
    }

    pub fn inputs(&self) -> Inputs {
        let unknown = self.how.strip_prefix("solved for ").map(|name| {
            let field = Key::named(name).unwrap().input.unwrap();
            let is_monocular = Method::Monocular.own_fields().contains(&field);
            (if is_monocular { Method::Monocular } else { Method::Stereo }, field)
        });
        Inputs {
            entries: self.entries(),
            unknown,
            object: Object::ALL
                .into_iter()
                .find(|one| self.chosen("object") == Some(one.key()))
                .unwrap_or_default(),
            pair: Pair::ALL
                .into_iter()
                .find(|one| self.chosen("pair") == Some(one.key()))
                .unwrap_or_default(),
        }
    }
}
