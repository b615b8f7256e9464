//! Whatever the bytes are: an answer or a sentence, and never a focal length that none is.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

mod judge;

use depth_files::read;
use proptest::prelude::*;
use std::fs;
use std::path::Path;

/// Every small file of the formats, with its name.
fn files() -> Vec<(String, Vec<u8>)> {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    let folders = fs::read_dir(data).unwrap().map(|entry| entry.unwrap().path());
    let paths = folders.flat_map(|folder| fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()));
    let mut paths: Vec<_> = paths.collect();
    paths.sort();
    let files = paths.iter().map(|path| (path.display().to_string(), fs::read(path).unwrap()));
    files.filter(|(_, bytes)| bytes.len() < 6_000).collect()
}

fn holds(bytes: &[u8]) {
    assert_eq!(judge::judge(&read(&[bytes])), Ok(()));
}

/// Of the quirks some beginnings are read by their own test.
#[test]
fn every_beginning_of_every_file_is_answered() {
    let all = files();
    assert!(all.len() > 80, "{}", all.len());
    for (_, bytes) in all.iter().filter(|(name, _)| !name.contains("quirks")) {
        (0..bytes.len()).for_each(|length| holds(bytes.get(..length).unwrap()));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn arbitrary_bytes_are_answered(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        holds(&bytes);
    }

    #[test]
    fn arbitrary_text_is_answered(text in "[-\\[\\]{}:,.#%&*!<>\"'a-zP0-9 \n\t]{0,300}") {
        holds(text.as_bytes());
    }

    #[test]
    fn a_file_of_which_some_bytes_are_others_is_answered(
        which in any::<prop::sample::Index>(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0..3_u8), 1..12),
    ) {
        let all = files();
        let (_, mut bytes) = which.get(&all).clone();
        for (at, byte, what) in changes {
            if bytes.is_empty() {
                break;
            }
            let at = at.index(bytes.len());
            match what {
                0 => bytes[at] = byte,
                1 => bytes.insert(at, byte),
                _ => _ = bytes.remove(at),
            }
        }
        holds(&bytes);
    }
}
