//! Every sentence that refuses, warns, hints or judges: what was typed, and what is said.
//!
//! A file in `cases` is a group of cases, and its snapshot in `snapshots` shows what is said; a new case is a few lines or a
//! new file there. After `cargo test --test sentences` has written the new snapshots, `cargo insta review` takes them over.
//!
//! A case starts with a line in brackets that says what is typed into:
//!
//! - `[form]`: `field = text`, and `± field = text` for its σ. A field is named by its key. `[form, solved for b]` solves
//!   the stereo equation for the field b, or that of one camera if it is one of its fields. `[form, to be calculated]` adds
//!   what is said when something is missing, `[form, results]` what is said of the results.
//!   `[form, strip Distance]` shows the cells of the answer to what is asked for, with what is remarked below each.
//!   `object: height` and `pair: vertical` are what is chosen.
//! - `[way KEY]`: the fields that this way to a number asks for.
//! - `[camera]`: what is stated of a camera; `[camera, equisolid]` of a fisheye, `[camera, under water]` under water.
//! - `[Q matrix]`: the text of a matrix.
//! - `[command line]`: the arguments; with `[command line, disk full]` the answer cannot be written.
#![cfg(not(target_arch = "wasm32"))]
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, missing_docs, reason = "tests")]

mod case;
mod said;

use said::Said;
use std::collections::BTreeSet;

#[test]
fn every_sentence_is_as_it_was_written() {
    let mut variants = BTreeSet::new();
    let mut command_line = String::new();
    let mut settings = insta::Settings::clone_current();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| {
        insta::glob!("cases/*.txt", |path| {
            let said = Said::of(&std::fs::read_to_string(path).unwrap());
            variants.extend(said.variants);
            command_line.push_str(&said.command_line);
            insta::assert_snapshot!("said", said.text);
        });
    });
    said::assert_complete(&variants, &command_line);
}
