//! Line and marker figures for reports: SVG text through `kuva`, PNG from that SVG through `resvg`.
//!
//! The SVG holds no ids, scripts or style sheets, so any number can be inlined in one page.

mod draw;
mod plot;
mod space;
mod style;
#[cfg(test)]
mod tests;

pub use draw::FigureError;
pub use space::{SpaceFigure, SpaceSeries};
pub use style::{Dash, Marker, Style};

/// How the values of an axis are spread along it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scale {
    /// Equal steps for equal differences.
    #[default]
    Linear,
    /// Equal steps for equal ratios; values that are not positive are left out.
    Log,
}

/// One axis of a figure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Axis {
    /// What the axis shows, with its unit, e.g. `time (s)`.
    pub label: String,
    /// Linear or logarithmic.
    pub scale: Scale,
    /// Fixed lower and upper end in the unit of the data; `None` fits the data.
    pub range: Option<(f64, f64)>,
}

/// Where the legend stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Legend {
    /// Inside, in a corner free of data, or else below the plot.
    #[default]
    Auto,
    /// Below the plot, in columns.
    Below,
    /// No legend.
    Hidden,
}

/// One curve or cloud of points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// Name in the legend; a series without one is drawn but not listed.
    pub name: String,
    /// Abscissas, in the unit of the x axis.
    pub x: Vec<f64>,
    /// Ordinates, in the unit of the y axis; a value that is not finite breaks the line.
    pub y: Vec<f64>,
    /// How it is drawn.
    pub style: Style,
}

impl Series {
    /// A series in the first style, to be changed with [`Series::style`].
    #[must_use]
    pub fn new(name: impl Into<String>, x: Vec<f64>, y: Vec<f64>) -> Self {
        Self { name: name.into(), x, y, style: Style::default() }
    }

    /// A horizontal line at `y` from `x.0` to `x.1`, both in the units of the axes.
    #[must_use]
    pub fn horizontal(name: impl Into<String>, y: f64, x: (f64, f64)) -> Self {
        Self::new(name, vec![x.0, x.1], vec![y, y])
    }

    /// The same series drawn in `style`.
    #[must_use]
    pub fn style(mut self, style: Style) -> Self {
        self.style = style;
        self
    }
}

/// A figure with two axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// Heading above the plot.
    pub title: Option<String>,
    /// Words for readers who cannot see it; without them title and labels serve.
    pub alt: Option<String>,
    /// Width in CSS pixels (the PNG has twice as many).
    pub width: f64,
    /// Height in CSS pixels, legend included; `equal_aspect` may lessen it.
    pub height: f64,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// The curves; a later one is drawn over an earlier one.
    pub series: Vec<Series>,
    /// Whether one unit is equally long on both axes (for paths in a plane).
    pub equal_aspect: bool,
    /// Where the legend stands.
    pub legend: Legend,
}

impl Figure {
    /// An empty figure of 640 x 400 pixels with these axis labels.
    #[must_use]
    pub fn new(x_label: impl Into<String>, y_label: impl Into<String>) -> Self {
        let axis = |label| Axis { label, ..Axis::default() };
        Self {
            title: None,
            alt: None,
            width: 640.0,
            height: 400.0,
            x: axis(x_label.into()),
            y: axis(y_label.into()),
            series: Vec::new(),
            equal_aspect: false,
            legend: Legend::Auto,
        }
    }

    /// The same figure with one more series.
    #[must_use]
    pub fn with(mut self, series: Series) -> Self {
        self.series.push(series);
        self
    }

    fn words(&self) -> String {
        let names: Vec<&str> = self.series.iter().map(|s| s.name.as_str()).collect();
        let title = self.title.as_deref().unwrap_or("Figure");
        let words = || format!("{title}: {} against {}: {}", self.y.label, self.x.label, names.join(", "));
        self.alt.clone().unwrap_or_else(words)
    }

    /// The figure as one SVG element.
    #[must_use]
    pub fn svg(&self) -> String {
        draw::svg(&plot::scene(self, None), &self.words())
    }

    /// The figure as a PNG file on white, two pixels for each CSS pixel.
    ///
    /// # Errors
    /// If the size of the figure is zero or too large for memory.
    pub fn png(&self) -> Result<Vec<u8>, FigureError> {
        draw::png(&self.svg())
    }
}

/// Figures stacked from top to bottom, best of one width and one horizontal range.
///
/// Only the last shows the label of its horizontal axis, and where all have the same legend the
/// first shows it. The heights add up.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Panels {
    /// Heading above the first panel.
    pub title: Option<String>,
    /// Words for readers who cannot see it.
    pub alt: Option<String>,
    /// The panels, the topmost first; their own titles are not drawn.
    pub figures: Vec<Figure>,
}

impl Panels {
    /// A stack of these panels without a heading.
    #[must_use]
    pub fn new(figures: Vec<Figure>) -> Self {
        Self { figures, ..Self::default() }
    }

    /// The panels as one SVG element.
    #[must_use]
    pub fn svg(&self) -> String {
        let names = |f: &Figure| f.series.iter().map(|s| (s.name.clone(), s.style)).collect::<Vec<_>>();
        let shared = self.figures.windows(2).all(|w| names(&w[0]) == names(&w[1]));
        let (mut body, mut words, mut height) = (String::new(), Vec::new(), 0.0);
        for (i, figure) in self.figures.iter().enumerate() {
            let mut figure = Figure { title: self.title.clone().filter(|_| i == 0), ..figure.clone() };
            words.push(figure.words());
            if i + 1 < self.figures.len() {
                figure.x.label.clear();
            }
            if shared && i > 0 {
                figure.legend = Legend::Hidden;
            }
            let scene = plot::scene(&figure, None);
            body += &format!("<svg y=\"{height}\" {}", draw::bare(&scene));
            height += scene.height;
        }
        let width = self.figures.iter().map(|f| f.width).fold(0.0, f64::max);
        let size = format!("xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\"");
        let words = self.alt.clone().unwrap_or_else(|| format!("Panels. {}", words.join("; ")));
        draw::spoken(&words, (width, height), &format!("{size}>{body}</svg>"))
    }

    /// The panels as a PNG file on white, two pixels for each CSS pixel.
    ///
    /// # Errors
    /// If the size is zero or too large for memory.
    pub fn png(&self) -> Result<Vec<u8>, FigureError> {
        draw::png(&self.svg())
    }
}
