//! The inputs, their assessment, and their history for undo and redo.

use crate::core::problem::Method;
use depth_text::assess::Assessment;
use depth_text::fields;
use depth_text::form::Inputs;
use egui::util::undoer::{Settings, Undoer};

/// Steps of undo: nobody goes back further.
const STEPS: usize = 200;

/// The inputs, their assessment, which is computed once for each change, and the history of the inputs.
#[derive(Debug)]
pub struct Session {
    /// What is typed. After changing it, call [`Self::refresh`].
    pub inputs: Inputs,
    assessed: Inputs,
    assessment: Assessment,
    /// The last one in which nothing was lost that an input which cannot be used takes away for the moment.
    last: Assessment,
    /// The finished states. Only [`Self::settle`] adds one: when an edit is finished is known here, so egui need not guess by time.
    history: Undoer<Inputs>,
}

impl Session {
    /// A session that starts with `inputs`.
    pub fn new(inputs: Inputs) -> Self {
        let mut history = Undoer::with_settings(Settings {
            // The newest one is the current state.
            max_undos: STEPS + 1,
            ..Settings::default()
        });
        history.add_undo(&inputs);
        Self {
            assessment: inputs.assess(),
            last: inputs.assess(),
            assessed: inputs.clone(),
            history,
            inputs,
        }
    }

    /// The assessment of the inputs at the last [`Self::refresh`].
    pub const fn assessment(&self) -> &Assessment {
        &self.assessment
    }

    /// The inputs to edit, and their assessment at the last [`Self::refresh`].
    pub const fn parts(&mut self) -> (&mut Inputs, &Assessment) {
        (&mut self.inputs, &self.assessment)
    }

    /// Brings the assessment up to date. Returns whether anything had changed.
    pub fn refresh(&mut self) -> bool {
        let changed = self.inputs != self.assessed;
        if changed {
            self.assessed = self.inputs.clone();
            self.assessment = self.inputs.assess();
            self.keep();
        }
        changed
    }

    /// The answers before an input became unusable: what is still shown, dimmed, while somebody types.
    pub const fn last(&self) -> &Assessment {
        &self.last
    }

    /// The assessment that has the answer: this one, or the last that had what an unusable input takes away for the moment.
    pub fn answered(&self) -> &Assessment {
        if self.has_answer() { &self.assessment } else { &self.last }
    }

    /// Whether there is any answer.
    pub fn has_answer(&self) -> bool {
        answers(&self.assessment).contains(&true)
    }

    /// Whether there was an answer that an unusable input takes away for the moment.
    pub fn had_answer(&self) -> bool {
        answers(&self.last).contains(&true)
    }

    /// Forgets the answers before: what is typed now has nothing to do with them.
    pub fn forget(&mut self) {
        self.assessment = self.inputs.assess();
        self.assessed = self.inputs.clone();
        self.last = self.assessment.clone();
    }

    fn keep(&mut self) {
        let is_begun = [
            self.inputs.is_begun(Method::Stereo),
            self.inputs.is_begun(Method::Monocular),
            self.inputs.unknown.is_some(),
            !self.inputs.entry(fields::CAMERA_HEIGHT).is_blank(),
            self.inputs.has_two(),
            self.inputs.has_two(),
        ];
        let before = answers(&self.last).into_iter().zip(is_begun);
        let is_lost = before
            .zip(answers(&self.assessment))
            .any(|((had, begun), has)| had && begun && !has);
        if !is_lost || self.inputs.is_blank() {
            self.last = self.assessment.clone();
        }
    }

    /// Adds the inputs to the history as a finished state. Undo goes back from one finished state to the one before.
    pub fn settle(&mut self) {
        // Forgets the states to redo where there was an edit; `add_undo` alone keeps them.
        self.history.feed_state(0.0, &self.inputs);
        self.history.add_undo(&self.inputs);
    }

    /// Goes back to the finished state before. Returns whether there is one.
    pub fn undo(&mut self) -> bool {
        let before = self.history.undo(&self.inputs).cloned();
        self.replace(before)
    }

    /// Goes forward to the state that was left by [`Self::undo`]. Returns whether there is one.
    pub fn redo(&mut self) -> bool {
        let after = self.history.redo(&self.inputs).cloned();
        self.replace(after)
    }

    fn replace(&mut self, inputs: Option<Inputs>) -> bool {
        let Some(inputs) = inputs else { return false };
        self.inputs = inputs;
        true
    }
}

/// Which answers there are: by stereo, monocular, another quantity, the ground plane, two photographs, two points.
fn answers(assessment: &Assessment) -> [bool; 6] {
    let geometry = &assessment.geometry;
    [
        assessment.distance(Method::Stereo).is_some(),
        assessment.distance(Method::Monocular).is_some(),
        assessment.unknown.as_ref().is_some_and(|unknown| unknown.outcome.is_ok()),
        geometry.ground.is_some(),
        geometry.two_shots.is_some(),
        geometry.two_points.is_some(),
    ]
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
