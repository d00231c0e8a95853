//! Lays out one or more plots, the axis label and the legend in one SVG.

use super::axes::{LABEL_SIZE, Plot, x_span, y_span};
use super::legend::{self, Entry};
use super::svg::{Anchor, Canvas, Rect, fitting};
use super::ticks::{Span, TICK_SIZE};
use super::{Figure, Legend, Scale};

/// Font size of a heading in CSS pixels.
const TITLE_SIZE: f64 = 13.5;
/// Gap between two panels.
const BETWEEN: f64 = 14.0;
/// Least space right of the frame, for half a number.
const RIGHT: f64 = 16.0;

/// The legends that stand outside the plots.
#[derive(Default)]
struct Outside {
    below: Vec<Entry>,
    right: Vec<Entry>,
}

/// Draws the figures one above the other.
pub(super) fn svg(figures: &[Figure], title: Option<&str>, alt: Option<&str>) -> String {
    let (Some(first), Some(last)) = (figures.first(), figures.last()) else {
        return Canvas::default().finish(1.0, 1.0, alt.unwrap_or("empty figure"));
    };
    let title = title.or(first.title.as_deref().filter(|_| figures.len() == 1));
    let alt = alt.or(first.alt.as_deref().filter(|_| figures.len() == 1));
    let x = x_span(figures, &last.x);
    let (plots, outside) = place(figures, x, title.is_some());
    let bottom = plots.last().map_or(0.0, |p| p.frame.bottom());
    let numbers = if last.x.label.is_empty() { 24.0 } else { 42.0 };
    let mut canvas = Canvas::default();
    for (i, plot) in plots.iter().enumerate() {
        plot.draw(&mut canvas, i + 1 == plots.len());
    }
    if let Some(plot) = plots.last() {
        let f = plot.frame;
        let middle = f.x + f.w / 2.0;
        let room = 2.0 * middle.min(first.width - middle) - 8.0;
        let mut centred = |text: &str, y: f64, size: f64| {
            let size = fitting(text, size, room);
            canvas.text((middle, y), text, size, Anchor::Middle);
        };
        let y = bottom + 5.0 + TICK_SIZE + 7.0 + LABEL_SIZE;
        centred(&last.x.label, y, LABEL_SIZE);
        centred(title.unwrap_or_default(), 20.0, TITLE_SIZE);
        let band = Rect { x: 8.0, y: bottom + numbers, w: first.width - 16.0, h: 0.0 };
        legend::draw_below(&mut canvas, &outside.below, band, f.x + f.w / 2.0);
        let at = (f.right() + 14.0, plots[0].frame.y);
        legend::draw_column(&mut canvas, &outside.right, at);
    }
    let height = bottom + numbers + legend::height_below(&outside.below, first.width - 16.0) + 4.0;
    let words = alt.map_or_else(|| describe(figures, title), str::to_owned);
    canvas.finish(first.width, height, &words)
}

/// Words for readers who cannot see the figure, from its labels.
fn describe(figures: &[Figure], title: Option<&str>) -> String {
    let x = figures.last().map_or("", |f| f.x.label.as_str());
    let plots = figures.iter().map(|f| {
        let names: Vec<String> = legend::entries(f).into_iter().map(|e| e.name).collect();
        let of = if names.is_empty() { "" } else { " of " };
        format!("{} against {x}{of}{}", f.y.label, names.join(", "))
    });
    let plots: Vec<String> = plots.collect();
    let title = title.map_or(String::new(), |t| format!("{t}: "));
    format!("{title}{}", plots.join("; "))
}

/// Whether all panels can share one legend.
fn shares_legend(figures: &[Figure]) -> bool {
    let first = figures.first().map(legend::entries);
    figures.iter().all(|f| Some(legend::entries(f)) == first)
}

/// Finds the places of plots and legends: inside first, and below for those that do not fit.
fn place(figures: &[Figure], x: Span, titled: bool) -> (Vec<Plot<'_>>, Outside) {
    let mut outside = Outside::default();
    for figure in figures {
        match figure.legend {
            Legend::Below => legend::merge(&mut outside.below, &legend::entries(figure)),
            Legend::Right => legend::merge(&mut outside.right, &legend::entries(figure)),
            _ => {}
        }
    }
    let shared = shares_legend(figures);
    loop {
        let mut plots = frames(figures, x, titled, &outside);
        let homeless = place_inside(&mut plots, &outside, shared);
        if homeless.is_empty() {
            return (plots, outside);
        }
        legend::merge(&mut outside.below, &homeless);
    }
}

/// Gives the plots their inner legends; returns the entries for which there is no room.
fn place_inside(plots: &mut [Plot<'_>], outside: &Outside, shared: bool) -> Vec<Entry> {
    let mut homeless = Vec::new();
    for plot in plots {
        let mut entries = legend::entries(plot.figure);
        entries.retain(|e| !outside.below.contains(e) && !outside.right.contains(e));
        match plot.place_legend(&entries) {
            Some(at) => {
                plot.legend = Some((at, entries));
                if shared {
                    return Vec::new();
                }
            }
            None => legend::merge(&mut homeless, &entries),
        }
    }
    homeless
}

/// The plots with their frames, given the legends outside.
fn frames<'a>(figures: &'a [Figure], x: Span, titled: bool, outside: &Outside) -> Vec<Plot<'a>> {
    let width = figures.first().map_or(0.0, |f| f.width);
    let total: f64 = figures.iter().map(|f| f.height).sum();
    let labelled = figures.last().is_some_and(|f| !f.x.label.is_empty());
    let below = legend::height_below(&outside.below, width - 16.0) + 4.0;
    let below = below + if labelled { 42.0 } else { 24.0 };
    let spans: Vec<Span> = figures.iter().map(y_span).collect();
    let head = |i: usize| {
        let factor = spans[i].ticks(200.0, 42.0, false).factor != 0;
        let above = if i == 0 { 10.0 } else { BETWEEN };
        above + if factor { 12.0 } else { 0.0 } + if titled && i == 0 { 20.0 } else { 0.0 }
    };
    let heads: f64 = (0..figures.len()).map(head).sum();
    let room = (total - heads - below).max(40.0);
    let mut top = 0.0;
    let mut plots = Vec::new();
    for (i, figure) in figures.iter().enumerate() {
        top += head(i);
        let frame =
            Rect { x: 0.0, y: top, w: (width - 80.0).max(40.0), h: room * figure.height / total.max(1.0) };
        top = frame.bottom();
        plots.push(Plot::new(figure, frame, x, spans[i]));
    }
    let margins = plots.iter().map(Plot::left_margin);
    let left = margins.fold(0.0, f64::max);
    let numbers = plots.iter().map(|p| p.x_ticks.width() / 2.0 + 6.0);
    let w = (width - left - numbers.fold(RIGHT, f64::max) - legend::width_right(&outside.right)).max(40.0);
    let place = |p: Plot<'a>| {
        let frame = Rect { x: left, w, ..p.frame };
        if p.figure.equal_aspect && figures.len() == 1 && linear(p.figure) {
            return square(p.figure, frame, p.x, p.y);
        }
        Plot::new(p.figure, frame, p.x, p.y)
    };
    plots.into_iter().map(place).collect()
}

/// A plot with one scale on both axes: a smaller frame, and wider spans if it got too small.
fn square(figure: &Figure, frame: Rect, mut x: Span, mut y: Span) -> Plot<'_> {
    let least = 0.4;
    let scale = (frame.w / (x.hi - x.lo)).min(frame.h / (y.hi - y.lo));
    let widen = |span: &mut Span, length: f64| {
        let more = length * least / scale - (span.hi - span.lo);
        if more > 0.0 {
            span.lo -= more / 2.0;
            span.hi += more / 2.0;
        }
        (span.hi - span.lo) * scale
    };
    let w = widen(&mut x, frame.w).min(frame.w);
    let h = widen(&mut y, frame.h).min(frame.h);
    let frame = Rect { x: frame.x + (frame.w - w) / 2.0, y: frame.y, w, h };
    Plot::new(figure, frame, x, y)
}

/// Whether neither axis is logarithmic.
fn linear(figure: &Figure) -> bool {
    figure.x.scale == Scale::Linear && figure.y.scale == Scale::Linear
}
