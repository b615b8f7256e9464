//! Text in and out: numbers as people type them, the form as a whole, links, and the report that is copied.

pub mod inputs;
pub mod link;
pub mod number;
pub mod q_matrix;
pub mod report;
