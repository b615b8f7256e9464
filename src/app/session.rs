//! What is typed, what follows from it, and the states before, for undo and redo.

use crate::formats::inputs::{Assessment, Inputs};

/// The inputs, their assessment, which is computed once for each change, and the history of the inputs.
#[derive(Debug)]
pub struct Session {
    /// What is typed. After changing it, call [`Self::refresh`].
    pub inputs: Inputs,
    assessed: Inputs,
    assessment: Assessment,
    history: History,
}

impl Session {
    /// A session that starts with `inputs`.
    pub fn new(inputs: Inputs) -> Self {
        Self {
            assessment: inputs.assess(),
            assessed: inputs.clone(),
            history: History::new(inputs.clone()),
            inputs,
        }
    }

    /// Everything that followed from the inputs when they were last refreshed.
    pub const fn assessment(&self) -> &Assessment {
        &self.assessment
    }

    /// The inputs to edit, beside the assessment they had when they were last refreshed.
    pub const fn parts(&mut self) -> (&mut Inputs, &Assessment) {
        (&mut self.inputs, &self.assessment)
    }

    /// Brings the assessment up to date. Returns whether anything had changed.
    pub fn refresh(&mut self) -> bool {
        let changed = self.inputs != self.assessed;
        if changed {
            self.assessed = self.inputs.clone();
            self.assessment = self.inputs.assess();
        }
        changed
    }

    /// Takes the inputs for a finished state: what changed since the last one is one step of undo.
    pub fn settle(&mut self) {
        self.history.settle(&self.inputs);
    }

    /// Goes back to the finished state before. Returns whether there is one.
    pub fn undo(&mut self) -> bool {
        let before = self.history.undo();
        self.replace(before)
    }

    /// Goes forward to the state that was left by [`Self::undo`]. Returns whether there is one.
    pub fn redo(&mut self) -> bool {
        let after = self.history.redo();
        self.replace(after)
    }

    fn replace(&mut self, inputs: Option<Inputs>) -> bool {
        let Some(inputs) = inputs else { return false };
        self.inputs = inputs;
        true
    }
}

/// Finished states of the inputs.
#[derive(Debug)]
struct History {
    now: Inputs,
    past: Vec<Inputs>,
    future: Vec<Inputs>,
}

impl History {
    /// Nobody goes back further.
    const DEPTH: usize = 200;

    const fn new(now: Inputs) -> Self {
        Self {
            now,
            past: Vec::new(),
            future: Vec::new(),
        }
    }

    fn settle(&mut self, inputs: &Inputs) {
        if *inputs != self.now {
            self.past.push(std::mem::replace(&mut self.now, inputs.clone()));
            self.future.clear();
            if self.past.len() > Self::DEPTH {
                self.past.remove(0);
            }
        }
    }

    fn undo(&mut self) -> Option<Inputs> {
        let before = self.past.pop()?;
        self.future.push(std::mem::replace(&mut self.now, before));
        Some(self.now.clone())
    }

    fn redo(&mut self) -> Option<Inputs> {
        let after = self.future.pop()?;
        self.past.push(std::mem::replace(&mut self.now, after));
        Some(self.now.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::core::problem::Field;

    fn typed(session: &mut Session, text: &str) {
        session.inputs.entry_mut(Field::Disparity).text = text.to_owned();
    }

    fn disparity(session: &Session) -> &str {
        &session.inputs.entry(Field::Disparity).text
    }

    #[test]
    fn all_that_was_typed_before_a_field_is_left_is_one_step() {
        let mut session = Session::new(Inputs::default());
        for text in ["5", "50"] {
            typed(&mut session, text);
        }
        session.settle();
        session.settle();
        typed(&mut session, "25");
        session.settle();
        assert!(session.undo());
        assert_eq!(disparity(&session), "50");
        assert!(session.undo());
        assert_eq!(disparity(&session), "");
        assert!(!session.undo(), "there is nothing before the first state");
        assert!(session.redo() && session.redo());
        assert_eq!(disparity(&session), "25");
        assert!(!session.redo(), "there is nothing after the last state");
    }

    #[test]
    fn an_edit_after_undo_leaves_nothing_to_redo() {
        let mut session = Session::new(Inputs::default());
        for text in ["50", "25"] {
            typed(&mut session, text);
            session.settle();
        }
        assert!(session.undo());
        typed(&mut session, "10");
        session.settle();
        assert!(!session.redo());
        assert_eq!(disparity(&session), "10");
        assert!(session.undo());
        assert_eq!(disparity(&session), "50");
    }

    #[test]
    fn two_hundred_steps_can_be_undone() {
        let mut session = Session::new(Inputs::default());
        for number in 1..=300 {
            typed(&mut session, &number.to_string());
            session.settle();
        }
        let steps = (0..1000).take_while(|_| session.undo()).count();
        assert_eq!((steps, disparity(&session)), (200, "100"));
        assert_eq!((0..1000).take_while(|_| session.redo()).count(), 200);
        assert_eq!(disparity(&session), "300");
    }
}
