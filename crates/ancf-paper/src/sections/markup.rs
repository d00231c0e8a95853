//! Tables, units and ranges as HTML.

use maud::{Markup, html};

use crate::tables::{CellValue, PaperTable};

/// Returns a table with its caption.
pub(super) fn table(table: &PaperTable, caption: &Markup) -> Markup {
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

fn table_row(table: &PaperTable, row: &[CellValue]) -> Markup {
    html! {
        tr {
            @for (i, (column, value)) in table.columns.iter().zip(row).enumerate() {
                @if i == 0 { th scope="row" class=[is_text(table, i)] { (column.show(value)) } }
                @else { td class=[is_text(table, i)] { (column.show(value)) } }
            }
        }
    }
}

/// Returns the class of columns that begin with text. They are aligned to the left.
fn is_text(table: &PaperTable, column: usize) -> Option<&'static str> {
    let first = table.rows.first().and_then(|row| row.get(column));
    matches!(first, Some(CellValue::Text(_))).then_some("text")
}

/// Returns a unit of the non-dimensional form.
pub(super) fn unit(letter: &str) -> Markup {
    html! { (letter) sub { "ND" } }
}

/// Formats a range: "a to b", or "a" if both texts are equal.
pub(super) fn between(values: impl Iterator<Item = f64>, show: impl Fn(f64) -> String) -> String {
    let (low, high) =
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    let (low, high) = (show(low), show(high));
    if low == high { low } else { format!("{low} to {high}") }
}
