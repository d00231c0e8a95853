//! Commands that run models: `ancf run`, `resume`, `study`, `gradients`.

mod continuation;
mod gradients;
mod model_text;
mod recording;
mod requested_error;
mod resume;
mod run;
mod run_summary;
mod sequence;
mod study;
mod study_summary;

pub use gradients::{GRADIENTS_EXAMPLES, GradientsArguments};
pub use resume::{RESUME_EXAMPLES, ResumeArguments};
pub use run::{RUN_EXAMPLES, RunArguments};
pub use study::{STUDY_EXAMPLES, StudyArguments};
