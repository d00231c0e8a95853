//! Curves in space in parallel projection, inside a box with tick labels.
//!
//! `kuva` has such a box, but at half of all view angles (its default included) it shows a mirror image.

use crate::axis_layout::AxisLayout;
use crate::format::svg::{self, FigureError};
use crate::plot::{self, EdgeLabel};
use crate::polyline::Point;
use crate::style::{CurveStyle, DashPattern, MarkerShape};
use crate::types::{Figure, FigureAxis, FigureSeries, LegendPlacement};

type Vector = [f64; 3];

/// Curve in space.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SpaceCurve {
    /// Name in the legend. A curve without a name is drawn but not listed.
    pub name: String,
    /// Points x, y, z in the units of the axes. A point that is not finite interrupts the line.
    pub points: Vec<Vector>,
    /// Line and marker style.
    pub style: CurveStyle,
}

impl SpaceCurve {
    /// Creates a curve through points, in the units of the axes.
    #[must_use]
    pub fn new(name: impl Into<String>, points: Vec<Vector>, style: CurveStyle) -> Self {
        Self { name: name.into(), points, style }
    }
}

/// Figure of curves in space, z upwards.
#[derive(Clone, Debug, PartialEq)]
pub struct SpaceFigure {
    /// Heading above the box.
    pub title: Option<String>,
    /// Alternative text for screen readers. Default: labels and names of the curves.
    pub alt: Option<String>,
    /// Width in CSS pixels. The PNG has twice as many pixels.
    pub width: f64,
    /// Height in CSS pixels, including the legend.
    pub height: f64,
    /// Labels of x, y and z, with their units.
    pub labels: [String; 3],
    /// Curves in drawing order.
    pub curves: Vec<SpaceCurve>,
    /// Azimuth of the viewer in degrees, from x towards y.
    pub azimuth: f64,
    /// Elevation of the viewer above the x-y plane in degrees.
    pub elevation: f64,
    /// True for equal scales of all axes. Otherwise the box is a cube.
    pub equal_aspect: bool,
    /// Placement of the legend.
    pub legend: LegendPlacement,
}

impl Default for SpaceFigure {
    fn default() -> Self {
        Self {
            title: None,
            alt: None,
            width: 640.0,
            height: 440.0,
            labels: ["x", "y", "z"].map(str::to_owned),
            curves: Vec::new(),
            azimuth: -55.0,
            elevation: 24.0,
            equal_aspect: true,
            legend: LegendPlacement::Auto,
        }
    }
}

impl SpaceFigure {
    /// Returns the figure as one SVG element.
    #[must_use]
    pub fn svg(&self) -> String {
        let view = View::new(self);
        let mut figure = Figure {
            title: self.title.clone(),
            width: self.width,
            height: self.height,
            equal_aspect: true,
            legend: self.legend,
            ..Figure::new("", "")
        };
        let mut add = |name: &str, points: &[Vector], style: CurveStyle| {
            let (x, y) = points.iter().map(|p| view.project(*p)).unzip();
            figure.series.push(FigureSeries { name: name.to_owned(), x, y, style });
        };
        let plain = CurveStyle { width: 0.8, ..CurveStyle::default() };
        let grey = CurveStyle { colour: 7, pale: true, width: 0.5, ..plain };
        view.walls().iter().for_each(|line| add("", line, grey));
        view.edges.iter().for_each(|(_, line, _)| add("", line, plain));
        for s in &self.curves {
            let floor: Vec<_> = s.points.iter().map(|p| [p[0], p[1], view.back[2]]).collect();
            add(
                "",
                &floor,
                CurveStyle {
                    pale: true,
                    marker: MarkerShape::None,
                    dash: DashPattern::Solid,
                    width: 0.9,
                    ..s.style
                },
            );
            add(&s.name, &s.points, s.style);
        }
        let names: Vec<&str> = self.curves.iter().map(|s| s.name.as_str()).collect();
        let words = || format!("{} in space: {}", self.labels.join(", "), names.join(", "));
        let scene = plot::scene(&figure, Some(&view.edge_labels(&self.labels)));
        svg::element(&scene, &self.alt.clone().unwrap_or_else(words))
    }

    /// Returns the figure as a PNG file on white, two pixels per CSS pixel.
    ///
    /// # Errors
    /// If the size of the figure is zero or too large for memory.
    pub fn png(&self) -> Result<Vec<u8>, FigureError> {
        svg::png(&self.svg())
    }
}

/// Box around the data and its projection.
struct View {
    axes: [AxisLayout; 3],
    /// Projection of one unit of each axis to the right.
    right: Vector,
    /// Projection of one unit of each axis upwards.
    up: Vector,
    /// Corner behind the data.
    back: Vector,
    /// Opposite corner.
    front: Vector,
    /// Edges with tick labels: axis, end points, and a point inside the box next to the first end.
    edges: [(usize, [Vector; 2], Vector); 3],
}

impl View {
    fn new(figure: &SpaceFigure) -> Self {
        let values = |i: usize| figure.curves.iter().flat_map(move |s| s.points.iter().map(move |p| p[i]));
        let axis = |i, parts| AxisLayout::new(&FigureAxis::default(), values(i), 0.04, parts);
        let lengths = [0, 1, 2].map(|i| axis(i, 2.0).ends()).map(|(lo, hi)| hi - lo);
        let longest = lengths.into_iter().fold(0.0, f64::max);
        let share = |i: usize| if figure.equal_aspect { lengths[i] / longest } else { 1.0 };
        let axes = [0, 1, 2].map(|i| axis(i, 3.5 * share(i)));
        let (sa, ca) = figure.azimuth.to_radians().sin_cos();
        let (se, ce) = figure.elevation.clamp(5.0, 85.0).to_radians().sin_cos();
        let unit = |i: usize| share(i) / (axes[i].ends().1 - axes[i].ends().0);
        let (right, up) =
            ([-sa * unit(0), ca * unit(1), 0.0], [-se * ca * unit(0), -se * sa * unit(1), ce * unit(2)]);
        let ends = |i: usize, behind: bool| match axes[i].ends() {
            (lo, hi) if behind => (lo, hi),
            (lo, hi) => (hi, lo),
        };
        let ((bx, fx), (by, fy), (floor, top)) = (ends(0, ca > 0.0), ends(1, sa > 0.0), ends(2, true));
        let along = |x: f64, y: f64| ([x, y, floor], [x, y, top]);
        let (one, other) = (along(fx, by), along(bx, fy));
        let leftmost = if right[0] * (fx - bx) < right[1] * (fy - by) { one } else { other };
        let edges = [
            (0, [[bx, fy, floor], [fx, fy, floor]], [bx, by, floor]),
            (1, [[fx, by, floor], [fx, fy, floor]], [bx, by, floor]),
            (2, [leftmost.0, leftmost.1], leftmost.0),
        ];
        Self { axes, right, up, back: [bx, by, floor], front: [fx, fy, top], edges }
    }

    fn project(&self, p: Vector) -> Point {
        let dot = |a: Vector| a[0] * p[0] + a[1] * p[1] + a[2] * p[2];
        (dot(self.right), dot(self.up))
    }

    /// Returns the grid lines on the three walls behind the data.
    fn walls(&self) -> Vec<[Vector; 2]> {
        let mut lines = Vec::new();
        for (wall, i) in [(0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1)] {
            let along = 3 - wall - i;
            for v in
                self.axes[i].tick_labels().into_iter().map(|(v, _)| v).chain([self.back[i], self.front[i]])
            {
                let (mut from, mut to) = (self.back, self.back);
                (from[i], to[i], to[along]) = (v, v, self.front[along]);
                lines.push([from, to]);
            }
        }
        lines
    }

    /// Returns the tick labels and axis labels at the edges.
    fn edge_labels(&self, axis_labels: &[String; 3]) -> Vec<EdgeLabel> {
        let mut labels = Vec::new();
        for (i, [from, to], inside) in self.edges {
            let (a, b) = (self.project(from), self.project(inside));
            let length = (a.0 - b.0).hypot(a.1 - b.1);
            let out = if i == 2 { (-1.0, 0.0) } else { ((a.0 - b.0) / length, (b.1 - a.1) / length) };
            let mut widest = 0.0_f64;
            for (v, text) in self.axes[i].tick_labels() {
                let mut at = from;
                at[i] = v;
                widest = widest.max(svg::text_width(&text, 11));
                labels.push(EdgeLabel { at: self.project(at), out, far: 11.0, text, is_axis: false });
            }
            let at = self.project([0, 1, 2].map(|k| (from[k] + to[k]) / 2.0));
            let far = if i == 2 { widest + 20.0 } else { 24.0 + widest * out.0.abs() };
            let text = [axis_labels[i].as_str(), &self.axes[i].note].join(" ");
            labels.push(EdgeLabel { at, out, far, text, is_axis: true });
        }
        labels
    }
}
