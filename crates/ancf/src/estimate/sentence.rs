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
        let Self { resolution, gaps, body, elements, law, displacement, .. } = self;
        match resolution {
            Resolution::Unresolved => self.unresolved(),
            Resolution::Unknown => {
                "mesh: the error is not known: joints act within elements, the tension of a coarse taut element vanishes at its \
                 end, or a critical load is near; in modes the stressed state is not resolved, in buckling the loads bend \
                 the structure"
                    .into()
            }
            Resolution::Good | Resolution::Rough => {
                let about = if *resolution == Resolution::Rough { "about " } else { "" };
                let end = format!("; section law within {}", percentage(*law));
                if let Some(error) = &self.eigenvalue {
                    let about = if error.relative.abs() > LARGE { "about " } else { about };
                    return format!("mesh: {}{end}", error.sentence(about));
                }
                match displacement {
                    Some(error) => format!("mesh: {}{end}", error.sentence(about)),
                    None => format!(
                        "mesh: the elements of body `{body}` ({elements}) differ from the exact rod by {} rad in total{end}",
                        short(round(*gaps))
                    ),
                }
            }
        }
    }

    /// Warning if the elements do not resolve the shape.
    pub(crate) fn warning(&self) -> Option<String> {
        (self.resolution == Resolution::Unresolved).then(|| self.unresolved())
    }

    fn unresolved(&self) -> String {
        let Self { gaps, body, elements, .. } = self;
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
