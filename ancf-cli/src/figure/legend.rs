//! The key to the series, where it hides no data.

use super::style::Style;
use super::svg::{Anchor, Canvas, Point, Rect, fitting, text_width};
use super::{Figure, Legend};

/// Font size of the names in CSS pixels.
const SIZE: f64 = 11.5;
/// Length of the line sample before a name.
const SAMPLE: f64 = 34.0;
/// Gap between the sample and the name.
const GAP: f64 = 7.0;
/// Gap between two columns.
const BETWEEN: f64 = 24.0;
/// Height of one row.
const ROW: f64 = 18.0;
/// Space between an inner legend and the frame, and within it around the rows.
const INSET: f64 = 8.0;
const PADDING: f64 = 5.0;

/// One line of the legend.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Entry {
    pub(super) name: String,
    pub(super) style: Style,
}

impl Entry {
    pub(super) fn new(name: &str, style: Style) -> Self {
        let name = name.to_owned();
        Self { name, style }
    }
}

/// The named series of a figure, unless its legend is hidden.
pub(super) fn entries(figure: &Figure) -> Vec<Entry> {
    if figure.legend == Legend::Hidden {
        return Vec::new();
    }
    let named = figure.series.iter().filter(|s| !s.name.is_empty());
    named.map(|s| Entry::new(&s.name, s.style)).collect()
}

/// Adds the entries that are not there yet.
pub(super) fn merge(all: &mut Vec<Entry>, more: &[Entry]) {
    for entry in more {
        if !all.contains(entry) {
            all.push(entry.clone());
        }
    }
}

fn entry_width(entries: &[Entry]) -> f64 {
    let names = entries.iter().map(|e| text_width(&e.name, SIZE));
    SAMPLE + GAP + names.fold(0.0, f64::max)
}

fn columns(entries: &[Entry], width: f64) -> usize {
    let fit = ((width + BETWEEN) / (entry_width(entries) + BETWEEN)).floor();
    let fit = (fit.max(1.0) as usize).min(entries.len().max(1));
    let rows = entries.len().div_ceil(fit).max(1);
    entries.len().div_ceil(rows).max(1)
}

/// Height of the entries set in columns below a plot, with the space above them.
pub(super) fn height_below(entries: &[Entry], width: f64) -> f64 {
    if entries.is_empty() {
        return 0.0;
    }
    entries.len().div_ceil(columns(entries, width)) as f64 * ROW + 4.0
}

/// Width of the entries set in one column, with the space before them.
pub(super) fn width_right(entries: &[Entry]) -> f64 {
    if entries.is_empty() { 0.0 } else { entry_width(entries) + 14.0 }
}

/// Draws the entries in columns from the top of a band, about `centre` if they have room there.
pub(super) fn draw_below(canvas: &mut Canvas, entries: &[Entry], band: Rect, centre: f64) {
    let columns = columns(entries, band.w);
    let step = entry_width(entries) + BETWEEN;
    let width = columns as f64 * step - BETWEEN;
    let left = (centre - width / 2.0).min(band.right() - width).max(band.x);
    for (i, entry) in entries.iter().enumerate() {
        let (row, column) = (i / columns, i % columns);
        let x = left + column as f64 * step;
        draw_entry(canvas, entry, (x, band.y + (row as f64 + 0.5) * ROW), band.w);
    }
}

/// Draws the entries in one column from the top left of their place.
pub(super) fn draw_column(canvas: &mut Canvas, entries: &[Entry], (x, y): Point) {
    for (i, entry) in entries.iter().enumerate() {
        draw_entry(canvas, entry, (x, y + (i as f64 + 0.5) * ROW), f64::INFINITY);
    }
}

/// Draws the entries inside a plot on white.
pub(super) fn draw_inside(canvas: &mut Canvas, entries: &[Entry], place: Rect) {
    canvas.fill(place, "#fff");
    draw_column(canvas, entries, (place.x + PADDING, place.y + PADDING));
}

/// Draws a sample of the style, its middle at the height of the point, and the name, both within `room`.
fn draw_entry(canvas: &mut Canvas, entry: &Entry, (x, y): Point, room: f64) {
    let style = Style { width: entry.style.width.min(9.0), ..entry.style };
    if let Some(stroke) = style.stroke() {
        canvas.segments(&[((x, y), (x + SAMPLE, y))], &stroke);
    }
    style.draw_markers(canvas, &[(x + SAMPLE / 2.0, y)]);
    let at = (x + SAMPLE + GAP, y + 0.35 * SIZE);
    let size = fitting(&entry.name, SIZE, room - SAMPLE - GAP);
    canvas.text(at, &entry.name, size, Anchor::Start);
}

/// The place of a legend inside a plot: the asked-for corner, or the first one free of data.
pub(super) fn place_inside(
    entries: &[Entry],
    wish: Legend,
    plot: Rect,
    lines: &[Vec<Point>],
) -> Option<Rect> {
    if entries.is_empty() {
        return None;
    }
    let w = entry_width(entries) + 2.0 * PADDING;
    let h = entries.len() as f64 * ROW + 2.0 * PADDING;
    let (left, right) = (plot.x + INSET, plot.right() - INSET - w);
    let (top, bottom) = (plot.y + INSET, plot.bottom() - INSET - h);
    let centre = (left + right) / 2.0;
    let at = |x, y| Rect { x, y, w, h };
    match wish {
        Legend::TopLeft => Some(at(left, top)),
        Legend::TopRight => Some(at(right, top)),
        Legend::BottomLeft => Some(at(left, bottom)),
        Legend::BottomRight => Some(at(right, bottom)),
        Legend::Below | Legend::Right | Legend::Hidden => None,
        Legend::Auto if right < left || bottom < top => None,
        Legend::Auto => {
            let (x, y) = ([right, left, centre], [top, bottom]);
            let places = y.iter().flat_map(|&y| x.iter().map(move |&x| (x, y)));
            let mut places = places.map(|(x, y)| at(x, y));
            places.find(|place| is_free(place, lines))
        }
    }
}

/// Whether no line comes near a rectangle.
fn is_free(place: &Rect, lines: &[Vec<Point>]) -> bool {
    let near = place.grown(6.0);
    let mut pairs = lines.iter().flat_map(|line| line.windows(2));
    !pairs.any(|pair| near.clip(pair[0], pair[1]).is_some())
}
