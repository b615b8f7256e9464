//! The explanations.

use crate::program::{B, FX, Program, W_IMG};

#[test]
fn learn_loads_the_examples() {
    for (link, distance) in [("coffee mug", "1.400 m"), ("doorway", "4.275 m")] {
        let mut program = Program::new();
        program.press("Learn");
        program.press(&format!("Load the {link} into the calculator"));
        assert!(program.says(distance), "{link}");
    }
}

#[test]
fn an_example_of_the_explanations_sets_only_what_it_names_and_can_be_undone() {
    let mut program = Program::new();
    program.mug();
    program.press("Learn");
    program.press("Load the doorway into the calculator");
    assert_eq!((program.value(FX), program.value(B)), ("950".to_owned(), "100".to_owned()));
    assert!(program.says("4.275 m") && program.says("1.900 m"));
    program.press("Undo");
    assert_eq!((program.value(FX), program.value(W_IMG)), ("700".to_owned(), String::new()));
}
