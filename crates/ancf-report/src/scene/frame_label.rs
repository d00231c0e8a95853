use ancf::model::Analysis;
use ancf::units::Dimension;

use crate::run::{Recording, Snapshot};

/// Label of a frame: number and frequency of a mode, critical load factor, or load factor.
pub(crate) fn frame_label(recording: &Recording<'_>, frame: &Snapshot) -> String {
    let number = frame.value;
    let of = |column: &str| {
        let (_, first) = recording.series.columns().next()?;
        let row = first.iter().position(|x| *x == number)?;
        recording.series.column(column)?.get(row).copied()
    };
    match recording.model.analysis {
        Analysis::Modes(_) => match of("frequency") {
            Some(frequency) if frequency.is_finite() => {
                let seconds = recording.model.units.as_ref().is_some_and(|units| units.time == "s");
                let unit = if seconds { "Hz".to_owned() } else { recording.unit(Dimension::RATE) };
                format!("mode {number}: {} {unit}", rounded(frequency)).trim_end().to_owned()
            }
            Some(_) => format!("mode {number}: unstable"),
            // The run recorded no rows.
            None => format!("mode {number}"),
        },
        Analysis::Buckling(_) => of("factor").map_or_else(
            || format!("buckling mode {number}"),
            |factor| format!("buckling mode {number}: load factor {}", rounded(factor)),
        ),
        _ => format!("load factor {}", rounded(number)),
    }
}

/// Formats a number with four digits.
fn rounded(x: f64) -> String {
    format!("{x:.3e}").parse::<f64>().map_or_else(|_| x.to_string(), |x| x.to_string())
}
