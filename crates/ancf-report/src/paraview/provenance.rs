use ancf::model::Units;
use ancf::units::Dimension;
use serde_json::{Map, Value};
use sha2::{Digest, Sha256};

use super::array::{Array, Values};
use super::point_data::shell_dimensions;
use crate::run::Recording;

/// Names of point data and their dimensions.
const DIMENSIONS: [(&str, Dimension); 23] = [
    ("Points", Dimension::LENGTH),
    ("TimeValue", Dimension::NUMBER),
    ("s", Dimension::LENGTH),
    ("displacement", Dimension::LENGTH),
    ("shape", Dimension::LENGTH),
    ("shape_imaginary", Dimension::LENGTH),
    ("velocity", Dimension::VELOCITY),
    ("acceleration", Dimension::ACCELERATION),
    ("N", Dimension::FORCE),
    ("Qy", Dimension::FORCE),
    ("Qz", Dimension::FORCE),
    ("T", Dimension::ENERGY),
    ("My", Dimension::ENERGY),
    ("Mz", Dimension::ENERGY),
    ("bending_moment", Dimension::ENERGY),
    ("strain", Dimension::NUMBER),
    ("stress", Dimension::STRESS),
    ("largest_stress", Dimension::STRESS),
    ("von_mises", Dimension::STRESS),
    ("normal", Dimension::NUMBER),
    ("y_axis", Dimension::NUMBER),
    ("z_axis", Dimension::NUMBER),
    ("body", Dimension::NUMBER),
];

/// Field data of every file: title, program, model and units.
pub(super) fn provenance(recording: &Recording<'_>) -> Vec<Array> {
    let text = |name: &str, texts: Vec<String>| Array::new(name, 1, Values::Text(texts));
    let digest = Sha256::digest(recording.text);
    let digest = digest.iter().map(|byte| format!("{byte:02x}")).collect();
    vec![
        text("title", vec![recording.title.to_owned()]),
        text("program", vec![concat!("ancf ", env!("CARGO_PKG_VERSION")).to_owned()]),
        text("analysis", vec![recording.analysis().to_owned()]),
        text("model", vec![recording.text.to_owned()]),
        text("sha256", vec![digest]),
        text("units", vec![units(recording)]),
        text("bodies", recording.model.bodies.iter().map(|body| body.name().to_owned()).collect()),
    ]
}

/// Units of point data as JSON; dimensions in words if the model does not name its units.
fn units(recording: &Recording<'_>) -> String {
    let units = recording.model.units.clone().unwrap_or_else(Units::in_words);
    let of = |(name, dimension): (String, Dimension)| {
        let dynamic = name == "TimeValue" && recording.model.analysis.dynamics().is_some();
        let unit = units.of(if dynamic { Dimension::TIME } else { dimension });
        let unit = if unit.is_empty() { "1".to_owned() } else { unit };
        (name, Value::String(unit))
    };
    let of_shells = if recording.model.has_shells() { shell_dimensions() } else { Vec::new() };
    let all = DIMENSIONS.iter().map(|(name, dimension)| ((*name).to_owned(), *dimension)).chain(of_shells);
    Value::Object(all.map(of).collect::<Map<_, _>>()).to_string()
}
