//! The report as a page.

mod cantilever;
mod conditioning;
mod gain;
mod iterations;
mod pendulums;
mod recovered;
mod sources;
mod summary;

use maud::{Markup, html};

use super::figures::Drawing;
use super::results::Results;
use super::table::{Table, Value};
use super::tables::Tables;
use crate::report::{Page, Section, figure};

/// The page.
pub fn page(results: &Results, tables: &Tables, drawings: &[Drawing]) -> String {
    let sections = Report { results, tables, drawings }.sections();
    Page { title: "Kim et al. (2017), reproduced", subtitle: subtitle(), sections }.into_text()
}

fn subtitle() -> Markup {
    html! {
        "Every table and figure of K.-W. Kim, J.-W. Lee, J.-S. Jang, J.-Y. Oh, J.-H. Kang, H.-R. Kim, \
        W.-S. Yoo, "
        cite { "Efficiency of non-dimensional analysis for absolute nodal coordinate formulation" }
        ", Nonlinear Dynamics 87 (2017), computed anew and set beside the printed numbers."
    }
}

/// What the page is made of.
struct Report<'a> {
    results: &'a Results,
    tables: &'a Tables,
    drawings: &'a [Drawing],
}

impl Report<'_> {
    fn sections(&self) -> Vec<Section> {
        let section = |id: &str, title: &str, body| Section::new(id, title, body);
        vec![
            section("summary", "Summary", self.summary()),
            section("cantilever", "Cantilever", self.cantilever()),
            section("revolute", "Pendulum on a revolute joint", self.revolute()),
            section("spherical", "Pendulum on a spherical joint", self.spherical()),
            section("gain", "Where the gain comes from", self.gain()),
            section("iterations", "What the iteration counts mean", self.iterations()),
            section("condition-numbers", "Conditioning", self.conditioning()),
            section("gravity", "The acceleration of gravity", self.gravity()),
            section("recovered", "Other recovered values and misprints", self.recovered()),
            section("sources", "Measurement, files, sources", self.sources()),
        ]
    }

    /// A figure under its number.
    fn figure(&self, file: &str, number: &str) -> Markup {
        let Some(drawing) = self.drawings.iter().find(|drawing| drawing.file == file) else {
            return html! {};
        };
        let caption = html! {
            strong { (number) ". " } (drawing.caption) " "
            span.files { a href={ (file) ".svg" } { "SVG" } " " a href={ (file) ".png" } { "PNG" } }
        };
        figure(file, drawing.svg(), &caption)
    }
}

/// A table with its caption.
fn table(table: &Table, caption: &Markup) -> Markup {
    let groups = table.groups();
    html! {
        div.table tabindex="0" role="region" aria-label={ "Table " (table.file) } {
            table {
                caption { span { (caption) " " span.files { a href={ (table.file) ".csv" } { "CSV" } } } }
                thead {
                    @if !groups.is_empty() {
                        tr.groups { @for (group, count) in &groups { (group_heading(group, *count)) } }
                    }
                    tr {
                        @for (i, column) in table.columns.iter().enumerate() {
                            th scope="col" class=[is_text(table, i)] { (column.heading()) }
                        }
                    }
                }
                tbody { @for row in &table.rows { (table_row(table, row)) } }
            }
        }
    }
}

fn group_heading(group: &str, columns: usize) -> Markup {
    html! {
        @if group.is_empty() { td colspan=(columns) {} }
        @else { th colspan=(columns) scope="colgroup" { (group) } }
    }
}

fn table_row(table: &Table, row: &[Value]) -> Markup {
    html! {
        tr {
            @for (i, (column, value)) in table.columns.iter().zip(row).enumerate() {
                @if i == 0 { th scope="row" class=[is_text(table, i)] { (column.show(value)) } }
                @else { td class=[is_text(table, i)] { (column.show(value)) } }
            }
        }
    }
}

/// Columns that begin with words are set to the left.
fn is_text(table: &Table, column: usize) -> Option<&'static str> {
    let first = table.rows.first().and_then(|row| row.get(column));
    matches!(first, Some(Value::Text(_))).then_some("text")
}

/// A unit of the non-dimensional form.
fn unit(letter: &str) -> Markup {
    html! { (letter) sub { "ND" } }
}

/// "a to b", or "a" if both look alike.
fn between(values: impl Iterator<Item = f64>, show: impl Fn(f64) -> String) -> String {
    let (low, high) =
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    let (low, high) = (show(low), show(high));
    if low == high { low } else { format!("{low} to {high}") }
}
