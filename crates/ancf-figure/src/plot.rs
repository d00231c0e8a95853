//! Plane figures: axes, ticks and grid by `kuva`, curves and legend in the frame that it lays out.

use std::sync::Arc;

use kuva::render::axis::{add_axes_and_grid, add_labels_and_title};
use kuva::render::layout::{AxisLine, ComputedLayout, Layout, TickAlign, TickFormat, TickPos};
use kuva::render::render::{Scene, TextAnchor};
use kuva::render::render_utils::{compute_tick_step, generate_minor_ticks, generate_ticks_with_step};
use kuva::render::theme::Theme;

use super::draw::{self, Key, Point, Rect};
use super::{Axis, Dash, Figure, Legend, Marker, Scale, Series, Style};

const GRID: &str = "#e6e6e6";
const THIN: Style =
    Style { colour: 0, pale: false, dash: Dash::Solid, width: 0.8, marker: Marker::None, marker_every: 1 };

/// An axis in the numbers that are drawn: the values times `unit`, a power of ten.
///
/// On a linear axis the unit keeps the numbers at the ticks short; on a logarithmic one it keeps
/// them above one, since `kuva` draws everything below 1e-10 there.
pub(super) struct Ruler {
    range: Point,
    log: bool,
    unit: f64,
    step: Option<f64>,
    format: TickFormat,
    /// The power of ten that the numbers are to be multiplied with, if any.
    pub(super) note: String,
}

impl Ruler {
    /// Fits an axis of about `parts` steps to values, with a share of `room` free at both ends.
    pub(super) fn new(axis: &Axis, values: impl Iterator<Item = f64>, room: f64, parts: f64) -> Self {
        let log = axis.scale == Scale::Log;
        let usable = |v: &f64| v.is_finite() && (*v > 1e-300 || !log);
        let ends = |(lo, hi): Point, v: f64| (lo.min(v), hi.max(v));
        let data = values.filter(usable).fold((f64::INFINITY, f64::NEG_INFINITY), ends);
        let data = if data.0 <= data.1 { data } else { if log { (1.0, 10.0) } else { (0.0, 1.0) } };
        let fixed = axis.range.filter(|r| r.0 < r.1 && usable(&r.0) && usable(&r.1));
        let parts = parts.max(2.0);
        if log { Self::log(data, fixed, parts) } else { Self::linear(data, fixed, room, parts) }
    }

    fn linear((lo, hi): Point, fixed: Option<Point>, room: f64, parts: f64) -> Self {
        let more = if hi > lo { room * (hi - lo) } else { (0.1 * lo.abs()).max(f64::from(lo == 0.0)) };
        let start = if lo >= 0.0 { (lo - more).max(0.0) } else { lo - more };
        let (mut lo, mut hi) = fixed.unwrap_or((start, hi + more));
        let step = nice_step(lo, hi, parts);
        // An end that all but reaches a numbered tick is drawn out to it.
        let outwards = |end: f64| {
            if fixed.is_none() && (end - (end / step).round() * step).abs() < 0.01 * (hi - lo) {
                (end / step).round() * step
            } else {
                end
            }
        };
        (lo, hi) = (outwards(lo), outwards(hi));
        let most = (lo.abs().max(hi.abs()) * 1.000_001).log10().floor() as i32;
        let power = if (-2..=4).contains(&most) { 0 } else { most };
        let unit = 10f64.powi(-power);
        let (range, step) = ((lo * unit, hi * unit), step * unit);
        let places = (-(step * 1.000_001).log10().floor()).clamp(0.0, 12.0) as usize;
        let format = TickFormat::Custom(Arc::new(move |v| minus(format!("{v:.places$}"))));
        let note = if power == 0 { String::new() } else { format!("×{}", power_of_ten(power)) };
        Self { range, log: false, unit, step: Some(step), format, note }
    }

    fn log(data: Point, fixed: Option<Point>, parts: f64) -> Self {
        let one_two_five = |v: f64, up: bool| {
            let decade = 10f64.powf(v.log10().floor());
            let mut nice = [1.0, 2.0, 5.0, 10.0].map(|m| m * decade).into_iter();
            let best = if up { nice.find(|n| *n >= v * 0.999) } else { nice.rfind(|n| *n <= v * 1.001) };
            best.unwrap_or(v)
        };
        let (lo, hi) = fixed.unwrap_or((one_two_five(data.0 / 1.1, false), one_two_five(data.1 * 1.1, true)));
        let shift = -lo.log10().floor() as i32;
        let decades = (hi / lo).log10();
        let every = (0.6 * decades / parts).ceil().max(1.0) as i32;
        let plain = lo > 0.9e-3 && hi < 1.1e4;
        let format = move |v: f64| {
            let raised = (v.log10() + 1e-9).floor() as i32;
            let (digit, power) = ((v / 10f64.powi(raised)).round(), raised - shift);
            match digit as i32 {
                1 if power.rem_euclid(every) != 0 => String::new(),
                2.. if decades > 2.0 => String::new(),
                _ if plain => format!("{:.*}", (-power).max(0) as usize, digit * 10f64.powi(power)),
                1 => power_of_ten(power),
                _ => format!("{digit}·{}", power_of_ten(power)),
            }
        };
        let unit = 10f64.powi(shift);
        let format = TickFormat::Custom(Arc::new(format));
        Self { range: (lo * unit, hi * unit), log: true, unit, step: None, format, note: String::new() }
    }

    /// The value in the numbers that are drawn, if it can be drawn.
    fn at(&self, value: f64) -> Option<f64> {
        let drawn = value * self.unit;
        (drawn.is_finite() && (drawn > 0.0 || !self.log)).then_some(drawn)
    }

    /// Both ends in the unit of the data.
    pub(super) fn ends(&self) -> Point {
        (self.range.0 / self.unit, self.range.1 / self.unit)
    }

    /// The places, in the unit of the data, and the texts of the numbers on a linear axis.
    pub(super) fn numbers(&self) -> Vec<(f64, String)> {
        let step = self.step.unwrap_or(f64::NAN);
        let drawn = generate_ticks_with_step(self.range.0, self.range.1, step);
        drawn.into_iter().map(|v| (v / self.unit, self.format.format(v))).collect()
    }

    /// The short ticks between the long ones, from `lo` to `hi` in the numbers that are drawn.
    fn minor(&self, (lo, hi): Point) -> Vec<f64> {
        let (long, parts) = match self.step {
            Some(step) => {
                let two = (step.log10().rem_euclid(1.0) - 2f64.log10()).abs() < 1e-6;
                (generate_ticks_with_step(lo - step, hi + step, step), if two { 4 } else { 5 })
            }
            None => ((0..=hi.log10().ceil() as i32).map(|e| 10f64.powi(e)).collect(), 9),
        };
        generate_minor_ticks(&long, parts).into_iter().filter(|v| (lo..=hi).contains(v)).collect()
    }
}

/// One, two or five times a power of ten, for about `parts` steps.
fn nice_step(lo: f64, hi: f64, parts: f64) -> f64 {
    let step = compute_tick_step(lo, hi, parts as usize);
    let digit = step / 10f64.powf(step.log10().floor());
    if (digit - 2.5).abs() < 1e-6 { 0.8 * step } else { step }
}

/// A power of ten in superscript digits.
fn power_of_ten(exponent: i32) -> String {
    let raised = |c: char| c.to_digit(10).and_then(|d| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(d as usize)).unwrap_or('⁻');
    format!("10{}", exponent.to_string().chars().map(raised).collect::<String>())
}

/// A number with a true minus sign, and none before nought.
fn minus(number: String) -> String {
    let nought = !number.contains(|c: char| ('1'..='9').contains(&c));
    number.replace('-', if nought { "" } else { "\u{2212}" })
}

/// One figure with its frame.
struct Plot<'a> {
    figure: &'a Figure,
    x: Ruler,
    y: Ruler,
    layout: Layout,
    frame: ComputedLayout,
    key: Key,
}

impl<'a> Plot<'a> {
    fn new(figure: &'a Figure) -> Self {
        let values =
            |of: fn(&Series) -> &Vec<f64>| figure.series.iter().flat_map(move |s| of(s).iter().copied());
        let marked =
            figure.series.iter().any(|s| s.style.marker != Marker::None && s.style.marker_every <= 1);
        let room = if marked || figure.equal_aspect { 0.04 } else { 0.0 };
        let x = Ruler::new(&figure.x, values(|s| &s.x), room, (figure.width - 80.0) / 84.0);
        let mut y = Ruler::new(&figure.y, values(|s| &s.y), 0.05, (figure.height - 60.0) / 56.0);
        if figure.equal_aspect && !x.log && !y.log {
            let range = (y.ends().0 * x.unit, y.ends().1 * x.unit);
            y = Ruler { range, note: x.note.clone(), format: x.format.clone(), ..x };
        }
        let mut layout = Layout::new(x.range, y.range)
            .with_width(figure.width)
            .with_height(figure.height)
            .with_theme(Theme { grid_color: GRID.to_owned(), ..Theme::light() })
            .with_axis_line(AxisLine::Box)
            .with_tick_align(TickAlign::Inside)
            .with_tick_pos(TickPos::Both)
            .with_axis_line_width(0.8)
            .with_tick_width(0.8)
            .with_grid_line_width(0.7)
            .with_title_size(14)
            .with_label_size(13)
            .with_tick_size(11)
            .with_x_label(&figure.x.label)
            .with_y_label(&figure.y.label)
            .with_x_tick_format(x.format.clone())
            .with_y_tick_format(y.format.clone());
        (layout.log_x, layout.log_y) = (x.log, y.log);
        (layout.x_tick_step, layout.y_tick_step) = (x.step, y.step);
        layout.title.clone_from(&figure.title);
        let mut frame = ComputedLayout::from_layout(&layout);
        // The same for all figures of one page, as far as the numbers have room there.
        frame.margin_left = frame.margin_left.max(72.0);
        frame.margin_top = frame.margin_top.max(if y.note.is_empty() { 10.0 } else { 20.0 });
        frame.margin_bottom -= if figure.x.label.is_empty() { 20.0 } else { 4.0 };
        let key = Key::new(figure.legend, figure.series.iter().map(|s| (&s.name, s.style)));
        let mut plot = Self { figure, x, y, layout, frame, key };
        plot.fit_aspect();
        plot
    }

    /// Makes units equally long: by a lower picture, or else by a longer x axis.
    fn fit_aspect(&mut self) {
        let frame = &mut self.frame;
        (frame.x_range, frame.y_range) = (self.x.range, self.y.range);
        frame.equal_aspect = self.figure.equal_aspect && !self.x.log && !self.y.log;
        if frame.equal_aspect {
            let ratio = (frame.y_range.1 - frame.y_range.0) / (frame.x_range.1 - frame.x_range.0);
            let height = (frame.plot_width() * ratio).max(100.0);
            frame.height -= (frame.plot_height() - height).max(0.0);
        }
        frame.recompute_transforms();
    }

    fn rect(&self) -> Rect {
        let f = &self.frame;
        [f.margin_left, f.margin_top, f.width - f.margin_right, f.height - f.margin_bottom]
    }

    fn at(&self, x: f64, y: f64) -> Option<Point> {
        Some((self.frame.map_x(self.x.at(x)?), self.frame.map_y(self.y.at(y)?)))
    }

    /// The visible parts of a series' line.
    fn lines(&self, series: &Series) -> Vec<Vec<Point>> {
        let points: Vec<_> = series.x.iter().zip(&series.y).map(|(&x, &y)| self.at(x, y)).collect();
        let runs = points.split(Option::is_none).map(|run| run.iter().copied().flatten().collect::<Vec<_>>());
        runs.flat_map(|run| draw::clip(&draw::thin(&run), self.rect())).collect()
    }

    /// The visible marked points of the series number `index`.
    fn marked(&self, index: usize, series: &Series) -> Vec<Point> {
        let [left, top, right, bottom] = self.rect();
        let seen = |p: &Point| p.0 > left - 0.1 && p.0 < right + 0.1 && p.1 > top - 0.1 && p.1 < bottom + 0.1;
        let every = series.style.marker_every.max(1);
        let pairs = series.x.iter().zip(&series.y).skip(index * every / self.figure.series.len());
        let any = series.style.marker != Marker::None;
        pairs.step_by(every).filter_map(|(&x, &y)| self.at(x, y)).filter(|p| any && seen(p)).collect()
    }

    fn data(&self) -> Vec<Vec<Point>> {
        let series = || self.figure.series.iter().enumerate();
        let points = series().flat_map(|(i, s)| self.marked(i, s)).map(|p| vec![p]);
        series().flat_map(|(_, s)| self.lines(s)).chain(points).collect()
    }

    fn minor_ticks(&self) -> Vec<Vec<Point>> {
        let ([left, top, right, bottom], long) = (self.rect(), self.frame.tick_mark_minor);
        let across = self.x.minor(self.frame.x_range).into_iter().map(|v| self.frame.map_x(v));
        let across = across.flat_map(|x| [[(x, bottom), (x, bottom - long)], [(x, top), (x, top + long)]]);
        let up = self.y.minor(self.frame.y_range).into_iter().map(|v| self.frame.map_y(v));
        let up = up.flat_map(|y| [[(left, y), (left + long, y)], [(right, y), (right - long, y)]]);
        across.chain(up).map(|tick| tick.to_vec()).collect()
    }

    fn draw(&mut self, scene: &mut Scene, notes: Option<&[Note]>) {
        let place =
            self.key.free_place(self.rect(), &self.data()).filter(|_| self.figure.legend == Legend::Auto);
        if place.is_none() {
            let band = self.key.height(self.frame.width - 16.0);
            self.frame.legend_bottom_extra = band;
            self.frame.margin_bottom += band;
            self.fit_aspect();
            scene.height = self.frame.height;
        }
        let [left, top, right, bottom] = self.rect();
        if notes.is_none() {
            add_axes_and_grid(scene, &self.frame, &self.layout);
            draw::curve(scene, &self.minor_ticks(), &THIN);
            let below = bottom + self.frame.margin_bottom - self.frame.legend_bottom_extra - 6.5;
            draw::text(scene, (left, top - 6.0), &self.y.note, 11, TextAnchor::Start, None);
            draw::text(scene, (right, below), &self.x.note, 11, TextAnchor::End, None);
        }
        let below = self.frame.height - self.frame.legend_bottom_extra + 2.0;
        match place {
            Some(place) => self.key.draw_inside(scene, place),
            None => self.key.draw_below(scene, (left + right) / 2.0, below, self.frame.width - 16.0),
        }
        for series in &self.figure.series {
            draw::curve(scene, &self.lines(series), &series.style);
        }
        for (i, series) in self.figure.series.iter().enumerate() {
            draw::markers(scene, &self.marked(i, series), &series.style);
        }
        for note in notes.unwrap_or_default() {
            self.at(note.at.0, note.at.1).into_iter().for_each(|at| note.draw(scene, at));
        }
        add_labels_and_title(scene, &self.frame, &self.layout);
    }
}

/// A number at a tick, or the label of an axis, beside an edge of a box in space.
pub(super) struct Note {
    /// Where the edge is, in the units of the figure.
    pub(super) at: Point,
    /// The way from the edge to the text in the picture, and how far, in pixels.
    pub(super) out: Point,
    pub(super) far: f64,
    pub(super) text: String,
    pub(super) label: bool,
}

impl Note {
    fn draw(&self, scene: &mut Scene, (x, y): Point) {
        let anchor = match self.out.0 {
            x if x < -0.35 && !(self.label && self.out.1 == 0.0) => TextAnchor::End,
            x if x > 0.35 => TextAnchor::Start,
            _ => TextAnchor::Middle,
        };
        let rotate = (self.label && self.out.1 == 0.0).then_some(-90.0);
        let at = |far: f64| (x + far * self.out.0, y + far * self.out.1);
        let (at, tick) = (at(self.far), vec![(x, y), at(5.0)]);
        draw::curve(scene, &[if self.label { Vec::new() } else { tick }], &THIN);
        let below = if rotate.is_some() { 0.0 } else { 4.0 };
        draw::text(scene, (at.0, at.1 + below), &self.text, if self.label { 13 } else { 11 }, anchor, rotate);
    }
}

/// The figure as a drawing, with these notes in place of axes if there are any.
pub(super) fn scene(figure: &Figure, notes: Option<&[Note]>) -> Scene {
    let mut plot = Plot::new(figure);
    if notes.is_some() {
        plot.frame.margin_right = 72.0;
        plot.frame.margin_bottom = 56.0;
        plot.fit_aspect();
    }
    let mut scene = Scene::new(figure.width, plot.frame.height);
    scene.font_family = Some(draw::FAMILY.to_owned());
    plot.draw(&mut scene, notes);
    scene
}
