//! The list of rigs, as it is kept and as it leaves the program.

use super::rig::{MOST, Rig};
use depth_text::entry::Entry;
use depth_text::field::Key;
use serde::{Deserialize, Serialize};

/// Up to [`MOST`] rigs, and the one that is shown.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct RigList {
    /// The rigs.
    pub all: Vec<Rig>,
    /// The place of the one that is shown.
    pub shown: usize,
    /// How often rigs came to other places: what egui remembers of the fields at a place is then of another rig.
    #[serde(skip)]
    pub moves: u32,
}

/// A list of rigs as a file.
#[derive(Serialize, Deserialize)]
struct RigFile {
    /// The version of the file.
    depth_calculator_rigs: u32,
    rigs: Vec<Rig>,
}

const VERSION: u32 = 1;
/// The name of the file.
pub const FILE_NAME: &str = "depth-calculator-rigs.json";

impl RigList {
    /// Whether there is room for another.
    pub const fn has_room(&self) -> bool {
        self.all.len() < MOST
    }

    /// Adds `rig` and shows it, where there is room. What is there already is only shown.
    pub fn add(&mut self, rig: Rig) {
        if let Some(at) = self.all.iter().position(|one| *one == rig && !rig.is_blank()) {
            self.shown = at;
        } else if self.has_room() {
            self.all.push(rig);
            self.shown = self.all.len() - 1;
        }
    }

    /// The rig that is shown.
    pub fn shown(&self) -> Option<&Rig> {
        self.all.get(self.shown)
    }

    /// The rig that is shown, to be changed.
    pub fn shown_mut(&mut self) -> Option<&mut Rig> {
        self.all.get_mut(self.shown)
    }

    /// Takes what a note offered for a field of the rig that is shown.
    pub fn fix(&mut self, key: Key, entry: Entry) {
        if let Some(rig) = self.shown_mut() {
            rig.inputs.fill(key, entry);
            rig.inputs.tidy(key);
        }
    }

    /// Puts `rig` in the place of the one at `at`, which is returned.
    pub fn replace(&mut self, at: usize, rig: Rig) -> Option<Rig> {
        self.moves += 1;
        self.all.get_mut(at).map(|one| std::mem::replace(one, rig))
    }

    /// Takes out the rig at `at`.
    pub fn remove(&mut self, at: usize) -> Option<Rig> {
        self.moves += 1;
        let removed = (at < self.all.len()).then(|| self.all.remove(at));
        self.shown = self.shown.min(self.all.len().saturating_sub(1));
        removed
    }

    /// Puts `rig` back at its place.
    pub fn put_back(&mut self, at: usize, rig: Rig) {
        if self.has_room() {
            self.moves += 1;
            let at = at.min(self.all.len());
            self.all.insert(at, rig);
            self.shown = at;
        }
    }

    /// The rigs as a file (JSON).
    ///
    /// # Errors
    /// The error of the serializer, in the unlikely case that there is one.
    pub fn to_file(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string(&RigFile {
            depth_calculator_rigs: VERSION,
            rigs: self.all.clone(),
        })
    }
}

/// What a file says of rigs.
#[derive(Debug, PartialEq, Eq)]
pub enum RigsInFile {
    /// It is another file.
    None,
    /// These.
    Some(Vec<Rig>),
    /// It is a file of rigs, of another version or damaged.
    Unreadable,
}

/// The rigs of a file that [`RigList::to_file`] wrote.
pub fn from_file(bytes: &[u8]) -> RigsInFile {
    let text = std::str::from_utf8(bytes).unwrap_or_default().trim_start_matches('\u{feff}');
    match serde_json::from_str::<RigFile>(text) {
        Ok(file) if file.depth_calculator_rigs == VERSION => RigsInFile::Some(file.rigs.into_iter().map(Rig::cleaned).collect()),
        _ if text.trim_start().starts_with("{\"depth_calculator_rigs\"") => RigsInFile::Unreadable,
        _ => RigsInFile::None,
    }
}

/// How the rigs are told apart: A, B and so on.
pub fn letter(at: usize) -> char {
    ['A', 'B', 'C', 'D', 'E', 'F'].get(at).copied().unwrap_or('?')
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests {
    use super::{Entry, Rig, RigList, RigsInFile, from_file};
    use depth_text::fields;

    fn rig(name: &str) -> Rig {
        let mut rig = Rig {
            name: name.to_owned(),
            ..Rig::default()
        };
        *rig.inputs.entry_mut(fields::FOCAL_LENGTH) = Entry::new("700", None);
        *rig.inputs.entry_mut(fields::FRAME_WIDTH) = Entry::new("1280", None);
        rig
    }

    #[test]
    fn six_rigs_find_room_and_what_was_taken_out_goes_back_to_its_place() {
        let mut list = RigList::default();
        for name in ["a", "b", "c", "d", "e", "f", "g"] {
            list.add(rig(name));
        }
        assert_eq!(list.all.len(), 6);
        let before = list.clone();
        let second = list.remove(1).unwrap();
        assert_eq!(list.all.len(), 5);
        list.put_back(1, second);
        assert_eq!(list.all, before.all);
        assert!(list.remove(6).is_none());
        for _ in 0..6 {
            list.remove(0);
        }
        assert!(list.shown().is_none());
    }

    #[test]
    fn what_leaves_the_program_comes_back_and_other_files_are_told_apart() {
        let mut list = RigList::default();
        list.add(rig("Left of the robot"));
        let file = list.to_file().unwrap();
        assert_eq!(from_file(file.as_bytes()), RigsInFile::Some(list.all));
        for other in ["", "{}", "{\"fx\": 700}", "fx: 700"] {
            assert_eq!(from_file(other.as_bytes()), RigsInFile::None, "{other}");
        }
        for damaged in [file.replace(":1,", ":9,"), file.replace("\"rigs\":[", "\"rigs\":{")] {
            assert_eq!(from_file(damaged.as_bytes()), RigsInFile::Unreadable, "{damaged}");
        }
    }

    #[test]
    fn what_a_file_brings_that_no_rig_has_is_left_out() {
        let long = "x".repeat(10_000);
        let file = format!(
            "{{\"depth_calculator_rigs\":1,\"rigs\":[{{\"name\":\"a\\u0000b{long}\",\"inputs\":{{\"entries\":{{\"fx\":{{\"text\":\"700\"}},\"d\":{{\"text\":\"50\"}}}}}}}}]}}"
        );
        let RigsInFile::Some(rigs) = from_file(file.as_bytes()) else {
            panic!("{file}")
        };
        let rig = rigs.first().unwrap();
        assert!(rig.name.starts_with("abx") && rig.name.len() < 300);
        assert_eq!(rig.inputs.entry(fields::FOCAL_LENGTH).text, "700");
        assert!(rig.inputs.entry(fields::DISPARITY).is_blank());
    }
}
