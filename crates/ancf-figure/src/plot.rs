//! Plane figures: axes, ticks and grid by `kuva`, curves and legend in the frame that `kuva` lays out.

use kuva::render::axis::{add_axes_and_grid, add_labels_and_title};
use kuva::render::layout::{AxisLine, ComputedLayout, Layout, TickAlign, TickPos};
use kuva::render::render::{Scene, TextAnchor};
use kuva::render::theme::Theme;

use crate::axis_layout::AxisLayout;
use crate::draw;
use crate::format::svg::FAMILY;
use crate::legend::LegendBox;
use crate::polyline::{Point, Rect, clip, decimate};
use crate::style::{CurveStyle, DashPattern, MarkerShape};
use crate::types::{Figure, FigureSeries, LegendPlacement};

const GRID: &str = "#e6e6e6";
const THIN: CurveStyle = CurveStyle {
    colour: 0,
    pale: false,
    dash: DashPattern::Solid,
    width: 0.8,
    marker: MarkerShape::None,
    marker_every: 1,
};

/// Figure with its axes, frame and legend.
struct PlotLayout<'a> {
    figure: &'a Figure,
    x: AxisLayout,
    y: AxisLayout,
    layout: Layout,
    frame: ComputedLayout,
    legend: LegendBox,
}

impl<'a> PlotLayout<'a> {
    fn new(figure: &'a Figure) -> Self {
        let values = |of: fn(&FigureSeries) -> &Vec<f64>| {
            figure.series.iter().flat_map(move |s| of(s).iter().copied())
        };
        let marked =
            figure.series.iter().any(|s| s.style.marker != MarkerShape::None && s.style.marker_every <= 1);
        let margin = if marked || figure.equal_aspect { 0.04 } else { 0.0 };
        let x = AxisLayout::new(&figure.x, values(|s| &s.x), margin, (figure.width - 80.0) / 84.0);
        let mut y = AxisLayout::new(&figure.y, values(|s| &s.y), 0.05, (figure.height - 60.0) / 56.0);
        if figure.equal_aspect && !x.log && !y.log {
            let range = (y.ends().0 * x.unit, y.ends().1 * x.unit);
            y = AxisLayout { range, note: x.note.clone(), format: x.format.clone(), ..x };
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
        // Equal margins for all figures of a page, as long as the tick labels fit.
        frame.margin_left = frame.margin_left.max(72.0);
        frame.margin_top = frame.margin_top.max(if y.note.is_empty() { 10.0 } else { 20.0 });
        frame.margin_bottom -= if figure.x.label.is_empty() { 20.0 } else { 4.0 };
        let legend = LegendBox::new(figure.legend, figure.series.iter().map(|s| (&s.name, s.style)));
        let mut plot = Self { figure, x, y, layout, frame, legend };
        plot.fit_aspect();
        plot
    }

    /// Makes the scales equal: by a smaller height, otherwise by a longer x axis.
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

    /// Returns the visible parts of the line of a series.
    fn lines(&self, series: &FigureSeries) -> Vec<Vec<Point>> {
        let points: Vec<_> = series.x.iter().zip(&series.y).map(|(&x, &y)| self.at(x, y)).collect();
        let runs = points.split(Option::is_none).map(|run| run.iter().copied().flatten().collect::<Vec<_>>());
        runs.flat_map(|run| clip(&decimate(&run), self.rect())).collect()
    }

    /// Returns the visible marked points of series `index`.
    fn marked(&self, index: usize, series: &FigureSeries) -> Vec<Point> {
        let [left, top, right, bottom] = self.rect();
        let seen = |p: &Point| p.0 > left - 0.1 && p.0 < right + 0.1 && p.1 > top - 0.1 && p.1 < bottom + 0.1;
        let every = series.style.marker_every.max(1);
        let pairs = series.x.iter().zip(&series.y).skip(index * every / self.figure.series.len());
        let any = series.style.marker != MarkerShape::None;
        pairs.step_by(every).filter_map(|(&x, &y)| self.at(x, y)).filter(|p| any && seen(p)).collect()
    }

    fn data(&self) -> Vec<Vec<Point>> {
        let series = || self.figure.series.iter().enumerate();
        let points = series().flat_map(|(i, s)| self.marked(i, s)).map(|p| vec![p]);
        series().flat_map(|(_, s)| self.lines(s)).chain(points).collect()
    }

    fn minor_ticks(&self) -> Vec<Vec<Point>> {
        let ([left, top, right, bottom], long) = (self.rect(), self.frame.tick_mark_minor);
        let across = self.x.minor_ticks(self.frame.x_range).into_iter().map(|v| self.frame.map_x(v));
        let across = across.flat_map(|x| [[(x, bottom), (x, bottom - long)], [(x, top), (x, top + long)]]);
        let up = self.y.minor_ticks(self.frame.y_range).into_iter().map(|v| self.frame.map_y(v));
        let up = up.flat_map(|y| [[(left, y), (left + long, y)], [(right, y), (right - long, y)]]);
        across.chain(up).map(|tick| tick.to_vec()).collect()
    }

    fn draw(&mut self, scene: &mut Scene, labels: Option<&[EdgeLabel]>) {
        let place = self
            .legend
            .free_place(self.rect(), &self.data())
            .filter(|_| self.figure.legend == LegendPlacement::Auto);
        if place.is_none() {
            let band = self.legend.height(self.frame.width - 16.0);
            self.frame.legend_bottom_extra = band;
            self.frame.margin_bottom += band;
            self.fit_aspect();
            scene.height = self.frame.height;
        }
        let [left, top, right, bottom] = self.rect();
        if labels.is_none() {
            add_axes_and_grid(scene, &self.frame, &self.layout);
            draw::curve(scene, &self.minor_ticks(), &THIN);
            let below = bottom + self.frame.margin_bottom - self.frame.legend_bottom_extra - 6.5;
            draw::text(scene, (left, top - 6.0), &self.y.note, 11, TextAnchor::Start, None);
            draw::text(scene, (right, below), &self.x.note, 11, TextAnchor::End, None);
        }
        let below = self.frame.height - self.frame.legend_bottom_extra + 2.0;
        match place {
            Some(place) => self.legend.draw_inside(scene, place),
            None => self.legend.draw_below(scene, (left + right) / 2.0, below, self.frame.width - 16.0),
        }
        for series in &self.figure.series {
            draw::curve(scene, &self.lines(series), &series.style);
        }
        for (i, series) in self.figure.series.iter().enumerate() {
            draw::markers(scene, &self.marked(i, series), &series.style);
        }
        for label in labels.unwrap_or_default() {
            self.at(label.at.0, label.at.1).into_iter().for_each(|at| label.draw(scene, at));
        }
        add_labels_and_title(scene, &self.frame, &self.layout);
    }
}

/// Tick label or axis label at an edge of a box in space.
pub(crate) struct EdgeLabel {
    /// Position on the edge, in the units of the figure.
    pub(crate) at: Point,
    /// Direction from the edge to the text in the figure.
    pub(crate) out: Point,
    /// Distance from the edge in pixels.
    pub(crate) far: f64,
    /// Text of the label.
    pub(crate) text: String,
    /// True for the label of an axis, false for a tick label.
    pub(crate) is_axis: bool,
}

impl EdgeLabel {
    fn draw(&self, scene: &mut Scene, (x, y): Point) {
        let anchor = match self.out.0 {
            x if x < -0.35 && !(self.is_axis && self.out.1 == 0.0) => TextAnchor::End,
            x if x > 0.35 => TextAnchor::Start,
            _ => TextAnchor::Middle,
        };
        let rotate = (self.is_axis && self.out.1 == 0.0).then_some(-90.0);
        let at = |far: f64| (x + far * self.out.0, y + far * self.out.1);
        let (at, tick) = (at(self.far), vec![(x, y), at(5.0)]);
        draw::curve(scene, &[if self.is_axis { Vec::new() } else { tick }], &THIN);
        let below = if rotate.is_some() { 0.0 } else { 4.0 };
        draw::text(
            scene,
            (at.0, at.1 + below),
            &self.text,
            if self.is_axis { 13 } else { 11 },
            anchor,
            rotate,
        );
    }
}

/// Draws the figure. With `labels`, these replace the axes.
pub(crate) fn scene(figure: &Figure, labels: Option<&[EdgeLabel]>) -> Scene {
    let mut plot = PlotLayout::new(figure);
    if labels.is_some() {
        plot.frame.margin_right = 72.0;
        plot.frame.margin_bottom = 56.0;
        plot.fit_aspect();
    }
    let mut scene = Scene::new(figure.width, plot.frame.height);
    scene.font_family = Some(FAMILY.to_owned());
    plot.draw(&mut scene, labels);
    scene
}
