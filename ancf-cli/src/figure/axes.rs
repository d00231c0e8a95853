//! Draws one plot: grid, curves, frame, ticks and numbers.

use super::decimate;
use super::legend::Entry;
use super::style::{Dash, Marker};
use super::svg::{Anchor, Canvas, INK, Point, Rect, Stroke, fitting};
use super::ticks::{Span, TICK_SIZE, TickText, Ticks};
use super::{Axis, Figure, Legend, Series};

/// Font size of the axis labels in CSS pixels.
pub(super) const LABEL_SIZE: f64 = 12.5;
/// Length of a major tick.
const TICK: f64 = 5.0;
/// Pixels aimed at between two numbers across and upwards.
const APART: (f64, f64) = (76.0, 42.0);

/// A figure with its place in the drawing.
pub(super) struct Plot<'a> {
    pub(super) figure: &'a Figure,
    pub(super) frame: Rect,
    pub(super) x: Span,
    pub(super) y: Span,
    pub(super) x_ticks: Ticks,
    pub(super) y_ticks: Ticks,
    /// The legend inside the frame, if it has one.
    pub(super) legend: Option<(Rect, Vec<Entry>)>,
}

/// Whether a figure marks every one of its points somewhere.
fn has_full_markers(series: &[Series]) -> bool {
    let marked = |s: &Series| s.style.marker != Marker::None && s.style.marker_every <= 1;
    series.iter().any(marked)
}

/// The span of the horizontal axis for the data of all figures.
pub(super) fn x_span(figures: &[Figure], axis: &Axis) -> Span {
    let all = figures.iter().flat_map(|f| &f.series);
    let square = figures.iter().any(|f| f.equal_aspect);
    let marked = figures.iter().any(|f| has_full_markers(&f.series));
    let room = if square || marked { 0.04 } else { 0.0 };
    let values = all.flat_map(|s| s.x.iter().copied());
    Span::of(values, axis.scale, axis.range, room)
}

/// The span of a figure's vertical axis.
pub(super) fn y_span(figure: &Figure) -> Span {
    let values = figure.series.iter().flat_map(|s| s.y.iter().copied());
    Span::of(values, figure.y.scale, figure.y.range, 0.05)
}

impl<'a> Plot<'a> {
    pub(super) fn new(figure: &'a Figure, frame: Rect, x: Span, y: Span) -> Self {
        let up = if figure.equal_aspect { APART.0.min(frame.h / 3.0) } else { APART.1 };
        Self {
            figure,
            frame,
            x,
            y,
            x_ticks: x.ticks(frame.w, APART.0, true),
            y_ticks: y.ticks(frame.h, up, false),
            legend: None,
        }
    }

    /// Space the numbers and the label take left of the frame.
    pub(super) fn left_margin(&self) -> f64 {
        self.y_ticks.width() + 7.0 + LABEL_SIZE + 14.0
    }

    fn at_x(&self, value: f64) -> Option<f64> {
        let place = self.x.place(value)?;
        Some(self.frame.x + place * self.frame.w)
    }

    fn at_y(&self, value: f64) -> Option<f64> {
        let place = self.y.place(value)?;
        Some(self.frame.bottom() - place * self.frame.h)
    }

    fn at(&self, x: f64, y: f64) -> Option<Point> {
        Some((self.at_x(x)?, self.at_y(y)?))
    }

    /// The visible parts of a series' line, thinned.
    fn lines(&self, series: &Series) -> Vec<Vec<Point>> {
        let pairs = series.x.iter().zip(&series.y);
        let points: Vec<Option<Point>> = pairs.map(|(&x, &y)| self.at(x, y)).collect();
        let runs = points.split(Option::is_none).filter(|run| !run.is_empty());
        let mut parts = Vec::new();
        for run in runs {
            let run: Vec<Point> = run.iter().flatten().copied().collect();
            parts.extend(decimate::clip(&decimate::thin(&run), &self.frame));
        }
        parts
    }

    /// The marked points of the series number `index`.
    fn marked(&self, series: &Series, index: usize) -> Vec<Point> {
        if series.style.marker == Marker::None {
            return Vec::new();
        }
        let every = series.style.marker_every.max(1);
        let first = index * every / self.figure.series.len().max(1);
        let pairs = series.x.iter().zip(&series.y);
        let points = pairs.skip(first).step_by(every);
        let points = points.filter_map(|(&x, &y)| self.at(x, y));
        let within = self.frame.grown(0.01);
        points.filter(|&p| within.contains(p)).collect()
    }

    /// All that a legend must not hide.
    pub(super) fn ink(&self) -> Vec<Vec<Point>> {
        let mut ink = Vec::new();
        for (index, series) in self.figure.series.iter().enumerate() {
            if series.style.dash != Dash::None {
                ink.extend(self.lines(series));
            }
            let marked = self.marked(series, index);
            ink.extend(marked.into_iter().map(|p| vec![p, p]));
        }
        ink
    }

    /// Where the figure asks for its legend, with a corner found if it may be anywhere.
    pub(super) fn place_legend(&self, entries: &[Entry]) -> Option<Rect> {
        let ink = if self.figure.legend == Legend::Auto { self.ink() } else { Vec::new() };
        super::legend::place_inside(entries, self.figure.legend, self.frame, &ink)
    }

    /// Draws everything but the label of the horizontal axis.
    pub(super) fn draw(&self, canvas: &mut Canvas, with_numbers_below: bool) {
        self.draw_grid(canvas);
        if let Some((place, entries)) = &self.legend {
            super::legend::draw_inside(canvas, entries, *place);
        }
        self.draw_ticks(canvas);
        canvas.path(&outline(self.frame), &Stroke::plain(INK, 0.8), "none");
        for series in &self.figure.series {
            if let Some(stroke) = series.style.stroke() {
                let d = decimate::path_data(&self.lines(series));
                canvas.path(&d, &stroke, "none");
            }
        }
        for (index, series) in self.figure.series.iter().enumerate() {
            let points = self.marked(series, index);
            series.style.draw_markers(canvas, &points);
        }
        if with_numbers_below {
            self.draw_numbers_below(canvas);
        }
        self.draw_numbers_left(canvas);
    }

    fn draw_grid(&self, canvas: &mut Canvas) {
        let f = self.frame;
        let mut lines = Vec::new();
        let within = |v: f64, a: f64, b: f64| v > a + 1.0 && v < b - 1.0;
        for x in self.x_ticks.major.iter().filter_map(|t| self.at_x(t.0)) {
            if within(x, f.x, f.right()) {
                lines.push(((x, f.y), (x, f.bottom())));
            }
        }
        for y in self.y_ticks.major.iter().filter_map(|t| self.at_y(t.0)) {
            if within(y, f.y, f.bottom()) {
                lines.push(((f.x, y), (f.right(), y)));
            }
        }
        canvas.segments(&lines, &Stroke::plain("#e7e7e7", 0.7));
    }

    /// Ticks that point inwards on all four sides.
    fn draw_ticks(&self, canvas: &mut Canvas) {
        let f = self.frame;
        let mut lines = Vec::new();
        let lengths = |ticks: &Ticks| {
            let major: Vec<(f64, f64)> = ticks.major.iter().map(|t| (t.0, TICK)).collect();
            let minor = ticks.minor.iter().map(|&v| (v, TICK * 0.5));
            major.into_iter().chain(minor).collect::<Vec<_>>()
        };
        for (value, length) in lengths(&self.x_ticks) {
            if let Some(x) = self.at_x(value) {
                lines.push(((x, f.bottom()), (x, f.bottom() - length)));
                lines.push(((x, f.y), (x, f.y + length)));
            }
        }
        for (value, length) in lengths(&self.y_ticks) {
            if let Some(y) = self.at_y(value) {
                lines.push(((f.x, y), (f.x + length, y)));
                lines.push(((f.right(), y), (f.right() - length, y)));
            }
        }
        canvas.segments(&lines, &Stroke::plain(INK, 0.8));
    }

    fn draw_numbers_below(&self, canvas: &mut Canvas) {
        let y = self.frame.bottom() + 5.0 + TICK_SIZE;
        for (value, text) in &self.x_ticks.major {
            if let Some(x) = self.at_x(*value) {
                draw_number(canvas, (x, y), text, Anchor::Middle);
            }
        }
        if self.x_ticks.factor != 0 {
            let at = (self.frame.right(), y + TICK_SIZE + 4.0);
            let factor = self.x_ticks.factor;
            canvas.power(at, "\u{d7}", factor, TICK_SIZE, Anchor::End);
        }
    }

    fn draw_numbers_left(&self, canvas: &mut Canvas) {
        let f = self.frame;
        for (value, text) in &self.y_ticks.major {
            if let Some(y) = self.at_y(*value) {
                let at = (f.x - 6.0, y + 0.35 * TICK_SIZE);
                draw_number(canvas, at, text, Anchor::End);
            }
        }
        if self.y_ticks.factor != 0 {
            let at = (f.x, f.y - 5.0);
            let factor = self.y_ticks.factor;
            canvas.power(at, "\u{d7}", factor, TICK_SIZE, Anchor::Start);
        }
        if !self.figure.y.label.is_empty() {
            let x = f.x - self.y_ticks.width() - 7.0 - 9.0;
            let at = (x, f.y + f.h / 2.0);
            let label = &self.figure.y.label;
            canvas.upright(at, label, fitting(label, LABEL_SIZE, f.h + 10.0));
        }
    }
}

/// The path of a rectangle.
fn outline(r: Rect) -> String {
    let number = super::svg::number;
    format!("M{} {}h{}v{}h{}z", number(r.x), number(r.y), number(r.w), number(r.h), number(-r.w))
}

/// Draws the number of a tick.
pub(super) fn draw_number(canvas: &mut Canvas, at: Point, text: &TickText, anchor: Anchor) {
    match text {
        TickText::Plain(text) => canvas.text(at, text, TICK_SIZE, anchor),
        TickText::Power(n) => canvas.power(at, "", *n, TICK_SIZE, anchor),
    }
}
