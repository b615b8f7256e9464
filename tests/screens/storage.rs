//! What is stored and comes back, and links.

use crate::machine::Machine;
use crate::program::{B, D, DESKTOP, FX, Program};

#[test]
fn what_was_entered_survives_a_restart() {
    let machine = Machine::default();
    let mut program = Program::on(machine.clone(), DESKTOP);
    program.mug();
    program.choose("Unit of the results", "feet");
    let again = Program::on(machine, DESKTOP);
    assert_eq!(
        (again.value(FX).as_str(), again.value(B).as_str(), again.value(D).as_str()),
        ("700", "100", "50")
    );
    assert!(again.says("4.593 ft"));
}

#[test]
fn a_corrupt_or_older_state_starts_fresh_and_says_so() {
    for text in ["{\"version\":0}", "not json", "{\"version\":1,\"inputs\":{\"focal_length\":7}}"] {
        let machine = Machine::default();
        *machine.stored.borrow_mut() = Some(text.to_owned());
        let program = Program::on(machine, DESKTOP);
        assert!(program.says("starts fresh"), "{text}");
        assert_eq!(program.value(FX), "");
    }
}

#[test]
fn a_followed_link_sets_only_what_it_names_and_can_be_undone() {
    let machine = Machine::default();
    let mut program = Program::on(machine.clone(), DESKTOP);
    program.mug();
    *machine.link.borrow_mut() = Some("#d=25".into());
    program.harness.run();
    assert!(program.says("2.800 m"));
    program.press("Undo");
    assert!(program.says("1.400 m"));
}

#[test]
fn a_state_that_cannot_be_read_is_set_aside_and_its_place_is_named() {
    let machine = Machine::default();
    *machine.stored.borrow_mut() = Some("{\"version\":999}".into());
    let mut program = Program::on(machine.clone(), DESKTOP);
    assert!(program.says("starts fresh. The old text is kept in the file shelf.json."));
    program.mug();
    assert_eq!(*machine.set_aside.borrow(), ["{\"version\":999}"]);
    assert!(machine.stored.borrow().as_deref().unwrap().contains("700"));
}

#[test]
fn a_state_that_cannot_be_set_aside_is_not_overwritten_either() {
    let machine = Machine::default();
    *machine.stored.borrow_mut() = Some("{\"version\":999}".into());
    machine.is_full.set(true);
    let mut program = Program::on(machine.clone(), DESKTOP);
    assert!(program.says("starts fresh. This browser could not set it aside: Storage is full. The program works, but forgets"));
    program.mug();
    assert_eq!(machine.stored.borrow().as_deref(), Some("{\"version\":999}"));

    machine.is_full.set(false);
    program.type_into(D, "100");
    assert!(program.says("The old text is kept in the file shelf.json."));
    assert_eq!(*machine.set_aside.borrow(), ["{\"version\":999}"]);
    assert!(machine.stored.borrow().as_deref().unwrap().contains("700"));
}
