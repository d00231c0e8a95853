use serde::Serialize;

use super::row::{LimitingResource, RowUnit, TableRow};
use crate::measure::Machine;

/// Table with the machine on which it was measured.
#[derive(Debug, Serialize)]
pub struct TableReport {
    /// Machine.
    pub machine: Machine,
    /// Rows.
    pub rows: Vec<TableRow>,
}

impl TableReport {
    /// Formats the table in Markdown.
    pub fn text(&self) -> String {
        let Machine { processor, cores, compiler, flops, bytes, cached } = &self.machine;
        let [flops, bytes, cached] = [flops, bytes, cached].map(|rate| 1e-9 * rate);
        let head = format!(
            "{processor}, {cores} cores, {compiler}; peak of one core: {flops:.1} Gflop/s, {bytes:.1} GB/s from memory, \
             {cached:.1} GB/s from second-level cache\n\n"
        );
        let headings = [
            "row",
            "unit",
            "target",
            "measured",
            "",
            "peer",
            "peer / measured",
            "fraction of machine peak",
            "",
        ];
        let rows: Vec<[String; 9]> = self.rows.iter().map(cells).collect();
        let widths: [usize; 9] = std::array::from_fn(|i| {
            let cells = rows.iter().map(|row| row[i].chars().count());
            cells.chain([headings[i].chars().count()]).max().unwrap_or(0)
        });
        let line = |cells: [&str; 9]| {
            let cells = cells.iter().zip(widths).map(|(cell, width)| format!(" {cell:width$} |"));
            format!("|{}\n", cells.collect::<String>())
        };
        let dashes = widths.map(|width| "-".repeat(width));
        let body = rows.iter().map(|row| line(row.each_ref().map(String::as_str)));
        let rule = line(dashes.each_ref().map(String::as_str));
        head + &line(headings) + &rule + &body.collect::<String>()
    }
}

fn cells(row: &TableRow) -> [String; 9] {
    let least = if row.unit == RowUnit::Gain { ">= " } else { "<= " };
    let met = match row.is_met() {
        Some(true) => "met",
        Some(false) => "missed",
        None => "skipped",
    };
    let peer = row.peer.zip(row.theirs).map(|(name, theirs)| format!("{} {name}", short(theirs)));
    let fraction = row.fraction.zip(row.bound).map(|(fraction, bound)| {
        let resource = match bound.resource {
            LimitingResource::Operations => "flops",
            LimitingResource::Bytes => "bytes",
            LimitingResource::CachedBytes => "bytes in cache",
        };
        format!("{} {resource}", percent(fraction))
    });
    [
        row.name.to_owned(),
        row.unit.text().to_owned(),
        format!("{least}{}", short(row.goal)),
        row.ours.map_or_else(|| "-".to_owned(), short),
        met.to_owned(),
        peer.unwrap_or_default(),
        row.ratio.map(short).unwrap_or_default(),
        fraction.unwrap_or_default(),
        row.note.clone(),
    ]
}

fn percent(fraction: f64) -> String {
    format!("{} %", short(100.0 * fraction))
}

/// Formats a number with about three digits.
fn short(x: f64) -> String {
    let decimals =
        if x.abs() < 0.995 { 3 } else { usize::from(x.abs() < 99.5) + usize::from(x.abs() < 9.95) };
    format!("{x:.decimals$}")
}
