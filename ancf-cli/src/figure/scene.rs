//! The box of a figure in space: its projection, edges, numbers and curves.

use super::axes::{LABEL_SIZE, draw_number};
use super::space::{SpaceFigure, SpaceSeries};
use super::style::Marker;
use super::svg::{Anchor, Canvas, INK, Point, Rect, Stroke, text_width};
use super::ticks::{Span, TICK_SIZE, Ticks};
use super::{Scale, decimate};

/// Share of the longest side that every side of a true-to-scale box has at least.
const LEAST_SIDE: f64 = 0.3;

/// The box and its projection to the picture.
pub(super) struct Scene<'a> {
    figure: &'a SpaceFigure,
    /// The part of the picture it fills.
    pub(super) area: Rect,
    spans: [Span; 3],
    /// Lengths of the sides of the box, the longest 1.
    sides: [f64; 3],
    /// Directions of the picture's x (right) and y (down) in space.
    across: [f64; 3],
    down: [f64; 3],
    /// For each axis the place (0 or 1) of the face that lies at the back.
    back: [f64; 3],
    scale: f64,
    middle: Point,
}

/// One numbered edge of the box.
struct Edge {
    axis: usize,
    /// Places 0 or 1 of the edge on all axes; that of its own axis does not count.
    at: [f64; 3],
    /// Unit vector of the picture that leads away from the box.
    out: Point,
    ticks: Ticks,
}

impl<'a> Scene<'a> {
    pub(super) fn new(figure: &'a SpaceFigure, area: Rect) -> Self {
        let spans = spans(figure);
        let sides = if figure.equal_aspect {
            let lengths = spans.map(|s| s.hi - s.lo);
            let longest = lengths.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
            lengths.map(|l| l / longest)
        } else {
            [1.0, 1.0, 0.8]
        };
        let (sa, ca) = figure.azimuth.to_radians().sin_cos();
        let elevation = figure.elevation.clamp(5.0, 85.0);
        let (se, ce) = elevation.to_radians().sin_cos();
        let back = [ca, sa, 1.0].map(|toward| if toward > 0.0 { 0.0 } else { 1.0 });
        let mut scene = Self {
            figure,
            area,
            spans,
            sides,
            across: [-sa, ca, 0.0],
            down: [se * ca, se * sa, -ce],
            back,
            scale: 1.0,
            middle: (0.0, 0.0),
        };
        scene.fit();
        scene
    }

    /// Chooses scale and middle so that the box and its numbers fill the area.
    fn fit(&mut self) {
        let extent = |direction: [f64; 3]| {
            let parts = direction.iter().zip(self.sides);
            parts.map(|(d, side)| (d * side).abs()).sum::<f64>()
        };
        let (w, h) = (extent(self.across), extent(self.down));
        let (left, right, top, bottom) = (66.0, 40.0, 14.0, 44.0);
        let (free_w, free_h) = (self.area.w - left - right, self.area.h - top - bottom);
        self.scale = (free_w / w).min(free_h / h).max(1.0);
        self.area.h = self.area.h.min(self.scale * h + top + bottom);
        let x = self.area.x + left + free_w / 2.0;
        self.middle = (x, self.area.y + top + self.scale * h / 2.0);
    }

    /// The picture of a place in the box, 0 to 1 on each axis.
    fn project(&self, place: [f64; 3]) -> Point {
        let along = |direction: [f64; 3]| -> f64 {
            let axes = (0..3).map(|i| (place[i] - 0.5) * self.sides[i] * direction[i]);
            axes.sum::<f64>() * self.scale
        };
        let (x, y) = self.middle;
        (x + along(self.across), y + along(self.down))
    }

    fn see(&self, p: [f64; 3]) -> Option<Point> {
        let place = |i: usize| self.spans[i].place(p[i]);
        Some(self.project([place(0)?, place(1)?, place(2)?]))
    }

    fn lines(&self, points: &[[f64; 3]]) -> Vec<Vec<Point>> {
        let seen: Vec<Option<Point>> = points.iter().map(|&p| self.see(p)).collect();
        let runs = seen.split(Option::is_none).filter(|run| !run.is_empty());
        let runs = runs.map(|run| run.iter().flatten().copied().collect::<Vec<_>>());
        runs.map(|run| decimate::thin(&run)).collect()
    }

    /// The three numbered edges: two at the front of the floor, one upright at the left.
    fn edges(&self) -> [Edge; 3] {
        let [bx, by, bz] = self.back;
        let x_edge = [0.5, 1.0 - by, bz];
        let y_edge = [1.0 - bx, 0.5, bz];
        let corners = [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0)];
        let left = |c: &(f64, f64)| self.project([c.0, c.1, 0.5]).0;
        let most = corners.iter().min_by(|a, b| left(a).total_cmp(&left(b)));
        let (zx, zy) = most.copied().unwrap_or((bx, by));
        let edge = |axis: usize, at: [f64; 3], out: Point| {
            let (mut a, mut b) = (at, at);
            (a[axis], b[axis]) = (0.0, 1.0);
            let (a, b) = (self.project(a), self.project(b));
            let length = (a.0 - b.0).hypot(a.1 - b.1);
            let ticks = self.spans[axis].ticks(length, if axis == 2 { 34.0 } else { 46.0 }, axis < 2);
            Edge { axis, at, out, ticks }
        };
        let away = |at: [f64; 3], across: [f64; 3]| {
            let (a, b) = (self.project(at), self.project(across));
            let (dx, dy) = (a.0 - b.0, a.1 - b.1);
            let length = dx.hypot(dy).max(1e-9);
            (dx / length, dy / length)
        };
        [
            edge(0, x_edge, away(x_edge, [0.5, by, bz])),
            edge(1, y_edge, away(y_edge, [bx, 0.5, bz])),
            edge(2, [zx, zy, 0.5], (-1.0, 0.0)),
        ]
    }

    /// The lines a legend must not hide.
    pub(super) fn ink(&self) -> Vec<Vec<Point>> {
        let mut ink = self.grid();
        for edge in self.edges() {
            let [mut a, mut b] = [edge.at; 2];
            (a[edge.axis], b[edge.axis]) = (0.0, 1.0);
            let out = |p: Point| (p.0 + 40.0 * edge.out.0, p.1 + 40.0 * edge.out.1);
            ink.push(vec![out(self.project(a)), out(self.project(b))]);
        }
        for series in &self.figure.series {
            ink.extend(self.lines(&series.points));
        }
        ink
    }

    /// The lines on the three faces at the back, their borders included.
    fn grid(&self) -> Vec<Vec<Point>> {
        let mut lines = Vec::new();
        let edges = self.edges();
        for face in 0..3 {
            for run in (0..3).filter(|&axis| axis != face) {
                let other = 3 - face - run;
                let inner = edges[other].ticks.major.iter();
                let inner = inner.filter_map(|(v, _)| self.spans[other].place(*v));
                for place in inner.chain([0.0, 1.0]) {
                    let mut a = [0.0; 3];
                    a[face] = self.back[face];
                    a[other] = place;
                    let mut b = a;
                    b[run] = 1.0;
                    lines.push(vec![self.project(a), self.project(b)]);
                }
            }
        }
        lines
    }

    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let grid = self.grid();
        let segments: Vec<(Point, Point)> = grid.iter().map(|l| (l[0], l[1])).collect();
        canvas.segments(&segments, &Stroke::plain("#e2e2e2", 0.7));
        if self.figure.floor_shadow {
            let floor = self.spans[2].lo;
            for series in &self.figure.series {
                let flat = series.points.iter().map(|p| [p[0], p[1], floor + 0.0 * p[2]]);
                let lines = self.lines(&flat.collect::<Vec<_>>());
                if let Some(stroke) = series.style.shadow().stroke() {
                    canvas.path(&decimate::path_data(&lines), &stroke, "none");
                }
            }
        }
        for edge in self.edges() {
            self.draw_edge(canvas, &edge);
        }
        for (index, series) in self.figure.series.iter().enumerate() {
            self.draw_series(canvas, series, index);
        }
    }

    fn draw_series(&self, canvas: &mut Canvas, series: &SpaceSeries, index: usize) {
        if let Some(stroke) = series.style.stroke() {
            let d = decimate::path_data(&self.lines(&series.points));
            canvas.path(&d, &stroke, "none");
        }
        if series.style.marker != Marker::None {
            let every = series.style.marker_every.max(1);
            let first = index * every / self.figure.series.len().max(1);
            let points = series.points.iter().skip(first).step_by(every);
            let points: Vec<Point> = points.filter_map(|&p| self.see(p)).collect();
            series.style.draw_markers(canvas, &points);
        }
    }

    fn draw_edge(&self, canvas: &mut Canvas, edge: &Edge) {
        let at = |place: f64| {
            let mut p = edge.at;
            p[edge.axis] = place;
            self.project(p)
        };
        let move_out = |p: Point, by: f64| (p.0 + by * edge.out.0, p.1 + by * edge.out.1);
        let mut segments = vec![(at(0.0), at(1.0))];
        let marks = edge.ticks.major.iter();
        let marks = marks.filter_map(|(v, t)| Some((at(self.spans[edge.axis].place(*v)?), t)));
        for (point, text) in marks {
            segments.push((point, move_out(point, 4.5)));
            let (x, y) = move_out(point, 9.0);
            let (anchor, fall) = beside(edge.out, TICK_SIZE);
            // The lowest number upwards makes room for the first one on the floor.
            let low = edge.axis == 2 && point.1 > at(0.0).1 - 5.0;
            let fall = if low { fall - 4.0 } else { fall };
            draw_number(canvas, (x, y + fall), text, anchor);
        }
        canvas.segments(&segments, &Stroke::plain(INK, 0.9));
        self.draw_label(canvas, edge, at(0.5));
    }

    fn draw_label(&self, canvas: &mut Canvas, edge: &Edge, middle: Point) {
        let label = &self.figure.labels[edge.axis];
        let wide = edge.ticks.width();
        let (x, y) = middle;
        let factor = edge.ticks.factor;
        if edge.axis == 2 {
            canvas.upright((x - wide - 22.0, y), label, LABEL_SIZE);
            if factor != 0 {
                let mut top = edge.at;
                top[2] = 1.0;
                let (x, y) = self.project(top);
                canvas.power((x, y - 6.0), "\u{d7}", factor, TICK_SIZE, Anchor::End);
            }
            return;
        }
        let by = 15.0 + wide * edge.out.0.abs() + TICK_SIZE * edge.out.1.abs() + 4.0;
        let (x, y) = (x + by * edge.out.0, y + by * edge.out.1);
        let (anchor, fall) = beside(edge.out, LABEL_SIZE);
        let full = text_width(label, LABEL_SIZE);
        let x = match anchor {
            Anchor::Start => x.min(self.area.right() - full),
            _ => x.max(self.area.x + if anchor == Anchor::End { full } else { 0.0 }),
        };
        if factor == 0 {
            canvas.text((x, y + fall), label, LABEL_SIZE, anchor);
        } else {
            let front = format!("{label} \u{d7} ");
            canvas.power((x, y + fall), &front, factor, LABEL_SIZE, anchor);
        }
    }
}

/// How a text stands at a point that lies in this direction from what it names.
fn beside(out: Point, size: f64) -> (Anchor, f64) {
    let anchor = match out.0 {
        x if x < -0.4 => Anchor::End,
        x if x > 0.4 => Anchor::Start,
        _ => Anchor::Middle,
    };
    (anchor, (0.35 + 0.4 * out.1) * size)
}

/// The range of each axis.
fn spans(figure: &SpaceFigure) -> [Span; 3] {
    let mut spans = [0, 1, 2].map(|axis| {
        let points = figure.series.iter().flat_map(|s| &s.points);
        let finite = points.filter(|p| p.iter().all(|v| v.is_finite()));
        Span::of(finite.map(|p| p[axis]), Scale::Linear, None, 0.04)
    });
    if figure.equal_aspect {
        let longest = spans.iter().map(|s| s.hi - s.lo).fold(0.0, f64::max);
        for span in &mut spans {
            let more = (LEAST_SIDE * longest - (span.hi - span.lo)).max(0.0);
            span.lo -= more / 2.0;
            span.hi += more / 2.0;
        }
    }
    spans
}
