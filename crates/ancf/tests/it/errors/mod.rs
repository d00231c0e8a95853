//! Estimates of the discretisation error.

mod effectivities;
mod eigenvalues;
mod linear_problems;
mod motions;
mod shell_motions;
mod shell_statements;
pub(crate) mod shells;
mod statements;

use ancf::estimate::DiscretisationErrors;
use ancf::record::Series;
use ancf::{Summary, simulate};

use crate::common::models::parse;

/// Runs a static analysis to its end.
fn summary(text: &str) -> Summary {
    let mut series = Series::new();
    let summary = simulate(&parse(text), &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    summary
}

/// Runs a static analysis and returns its estimated errors.
fn errors(text: &str) -> DiscretisationErrors {
    summary(text).errors.expect("a static analysis of a flexible body has an estimate")
}

/// Value and error of a column.
fn of(errors: &DiscretisationErrors, column: &str) -> [f64; 2] {
    let found = errors.values.iter().find(|value| value.column == column);
    let found = found.unwrap_or_else(|| panic!("no estimate of {column}: {errors:?}"));
    [found.value, found.error]
}

/// Straight beam of length 1 along x with a square section of 0.02 and E = 1e9, ν = 0.3. E I = 13.3333.
fn beam(body: &str, elements: u32, rest: &str) -> String {
    format!(
        r#"{rest}
        materials.m = {{ density = 1000, young = 1e9, poisson = 0.3 }}
        sections.s = {{ kind = "rectangle", height = 0.02, width = 0.02 }}
        [[bodies]]
        {body}
        name = "b"
        from = [0, 0, 0]
        to = [1, 0, 0]
        elements = {elements}
        section = "s"
        material = "m"
        [[probes]]
        name = "tip"
        on = {{ body = "b", at = "end" }}
        [analysis]
        kind = "statics"
        stop = {{ rule = "energy", tolerance = 1e-12 }}
        "#
    )
}

/// Bodies of all formulations.
const BODIES: [&str; 5] = [
    "kind = \"beam\"\nformulation = \"continuum\"",
    "kind = \"beam\"\nformulation = \"enhanced\"",
    "kind = \"beam\"\nformulation = \"linked\"",
    "kind = \"beam\"\nformulation = \"quadratic\"",
    "kind = \"cable\"",
];

const CLAMPED: &str = r#"joints = [{ kind = "clamp", name = "root", a = { body = "b", at = "start" } }]"#;
