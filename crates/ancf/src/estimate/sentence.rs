use super::discretisation_errors::{DiscretisationErrors, EigenvalueError, Resolution};
use super::value_errors::ProbeError;
use crate::errors::{percentage, short};

/// Share of the error along the displacement above which the displacement is too small or too large.
const ALONG: f64 = 0.7;
/// Relative error of a frequency or load factor above which its estimate states the order of magnitude.
const LARGE: f64 = 0.1;

impl DiscretisationErrors {
    /// Sentence for the end of a run: the error of the displacement of a probe, or what is not known.
    pub fn sentence(&self) -> String {
        match (self.resolution, &self.finer) {
            (Resolution::Unresolved, _) => self.unresolved(),
            (Resolution::Unknown, Some(finer)) => {
                format!("mesh: the error is not known: {}", finer.reason.as_deref().unwrap_or_default())
            }
            (Resolution::Unknown, None) => {
                "mesh: the error is not known: joints or moments act within elements, the tension of a coarse taut element vanishes at its \
                 end, or a critical load is near; in modes the stressed state is not resolved, in buckling the loads bend \
                 the structure"
                    .into()
            }
            (Resolution::Good | Resolution::Rough, finer) => {
                let ending = match finer {
                    Some(finer) => finer.ending(!self.bodies.is_empty()),
                    None => format!("; section law within {}", percentage(self.law)),
                };
                format!("mesh: {}{ending}", self.largest_in_words())
            }
        }
    }

    /// Largest relative error.
    fn largest_in_words(&self) -> String {
        let Self { resolution, gaps, body, elements, displacement, finer, .. } = self;
        let about = if *resolution == Resolution::Rough { "about " } else { "" };
        match (&self.eigenvalue, displacement) {
            (Some(error), _) => error.sentence(if error.relative.abs() > LARGE { "about " } else { about }),
            (None, Some(error)) => error.sentence(about),
            (None, None) if finer.is_some() => "no probe that moves records its position".into(),
            (None, None) => format!(
                "the elements of body `{body}` ({elements}) differ from the exact rod by {} rad in total",
                short(round(*gaps))
            ),
        }
    }

    /// Warning if the elements do not resolve the shape, or if a second solution does not state the error.
    pub(crate) fn warning(&self) -> Option<String> {
        let is_warning = match self.resolution {
            Resolution::Unresolved => true,
            Resolution::Unknown => self.finer.is_some(),
            Resolution::Good | Resolution::Rough => false,
        };
        is_warning.then(|| self.sentence())
    }

    fn unresolved(&self) -> String {
        let Self { gaps, body, elements, .. } = self;
        if let Some(finer) = &self.finer {
            let reason = finer.reason.as_deref().unwrap_or_default();
            return format!("mesh: not resolved: {reason}; use more elements");
        }
        format!(
            "mesh: not resolved: the {elements} elements of body `{body}` differ from the exact rod by {} rad in total; use more \
             elements",
            short(round(*gaps))
        )
    }
}

impl EigenvalueError {
    fn sentence(&self, about: &str) -> String {
        let Self { column, number, value, relative } = self;
        let (size, better) = (percentage(relative.abs()), short(value * (1.0 + relative)));
        let word = if *relative > 0.0 { "low" } else { "high" };
        let what = if column == "factor" { "load factor" } else { "frequency" };
        format!("{what} {number} {about}{size} too {word} (better: {better})")
    }
}

impl ProbeError {
    fn sentence(&self, about: &str) -> String {
        let Self { probe, relative, along, column, value, error } = self;
        let (size, better) = (percentage(*relative), short(value + error));
        if along.abs() < ALONG * relative {
            format!("{about}{size} error of the displacement of `{probe}` (better: {column} = {better})")
        } else {
            let word = if *along > 0.0 { "small" } else { "large" };
            format!("displacement of `{probe}` {about}{size} too {word} (better: {column} = {better})")
        }
    }
}

/// Rounds to two digits.
fn round(x: f64) -> f64 {
    format!("{x:.1e}").parse().unwrap_or(x)
}
