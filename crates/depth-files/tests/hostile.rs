//! Whatever the bytes are: an answer or a sentence, and never a focal length that none is.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

mod judge;

use depth_files::read;
use proptest::prelude::*;
use std::fs;
use std::path::Path;

/// Every small file of the quirks.
fn files() -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/quirks");
    let mut paths: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let files = paths.iter().map(|path| fs::read(path).unwrap());
    files.filter(|bytes| bytes.len() < 6_000).collect()
}

fn holds(bytes: &[u8]) {
    assert_eq!(judge::judge(&read(&[bytes])), Ok(()));
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
        let mut bytes = which.get(&all).clone();
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
