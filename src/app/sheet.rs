//! What is typed and what follows from it, kept together so that the second is computed once for each change of the first.

use crate::formats::inputs::{Assessment, Inputs};

/// The inputs and their assessment.
#[derive(Debug)]
pub struct Sheet {
    /// What is typed. After changing it, call [`Self::refresh`].
    pub inputs: Inputs,
    assessed: Inputs,
    assessment: Assessment,
}

impl Sheet {
    /// `inputs` and their assessment.
    pub fn new(inputs: Inputs) -> Self {
        Self {
            assessment: inputs.assess(),
            assessed: inputs.clone(),
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
}
