//! Journal-style line and marker figures, written as SVG text and as PNG.
//!
//! The SVG is plain geometry: no scripts, style sheets, classes or ids, so any
//! number of figures can be inlined in one HTML page. The PNG is rendered from
//! that same SVG with a bundled font, so it needs no fonts of the system.
//!
//! ```ignore
//! let figure = Figure::new("time (s)", "tip height (m)")
//!     .with(Series::new("DIM", t.clone(), y1).style(Style::nth(0)))
//!     .with(Series::new("Non-DIM", t, y2).style(Style::nth(1)));
//! std::fs::write("tip.svg", figure.svg())?;
//! std::fs::write("tip.png", figure.png()?)?;
//! ```

mod axes;
mod compose;
mod decimate;
mod legend;
mod png;
mod scene;
mod space;
mod style;
mod svg;
#[cfg(test)]
mod tests;
mod ticks;

pub(crate) use png::FigureError;
pub(crate) use space::{SpaceFigure, SpaceSeries};
pub(crate) use style::{Dash, Marker, Style};

/// How the values of an axis are spread along it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Scale {
    /// Equal steps for equal differences.
    #[default]
    Linear,
    /// Equal steps for equal ratios; values that are not positive are left out.
    Log,
}

/// One axis of a figure.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Axis {
    /// What the axis shows, with its unit, e.g. `time (s)`.
    pub(crate) label: String,
    /// Linear or logarithmic.
    pub(crate) scale: Scale,
    /// Fixed lower and upper end in the unit of the data; `None` fits the data.
    pub(crate) range: Option<(f64, f64)>,
}

/// Where the legend stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Legend {
    /// In a part of the plot that holds no data, or else below it.
    #[default]
    Auto,
    /// Below the plot, in columns.
    Below,
    /// To the right of the plot.
    Right,
    /// Inside, at the top left, whatever the data.
    TopLeft,
    /// Inside, at the top right, whatever the data.
    TopRight,
    /// Inside, at the bottom left, whatever the data.
    BottomLeft,
    /// Inside, at the bottom right, whatever the data.
    BottomRight,
    /// No legend.
    Hidden,
}

/// One curve or cloud of points.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Series {
    /// Name in the legend; a series without one is drawn but not listed.
    pub(crate) name: String,
    /// Abscissas, in the unit of the x axis.
    pub(crate) x: Vec<f64>,
    /// Ordinates, in the unit of the y axis; a value that is not finite breaks the line.
    pub(crate) y: Vec<f64>,
    /// How it is drawn.
    pub(crate) style: Style,
}

impl Series {
    /// A series in the first style, to be changed with [`Series::style`].
    #[must_use]
    pub(crate) fn new(name: impl Into<String>, x: Vec<f64>, y: Vec<f64>) -> Self {
        let name = name.into();
        let style = Style::default();
        Self { name, x, y, style }
    }

    /// A horizontal line at `y` from `x.0` to `x.1`, both in the units of the axes.
    #[must_use]
    pub(crate) fn horizontal(name: impl Into<String>, y: f64, x: (f64, f64)) -> Self {
        Self::new(name, vec![x.0, x.1], vec![y, y])
    }

    /// The same series drawn in `style`.
    #[must_use]
    pub(crate) fn style(mut self, style: Style) -> Self {
        self.style = style;
        self
    }
}

/// A figure with two axes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Figure {
    /// Heading above the plot; journals prefer a caption, hence optional.
    pub(crate) title: Option<String>,
    /// Words for readers who cannot see it; without them title and labels serve.
    pub(crate) alt: Option<String>,
    /// Width in CSS pixels (the PNG has twice as many).
    pub(crate) width: f64,
    /// Height in CSS pixels, legend included; `equal_aspect` may lessen it.
    pub(crate) height: f64,
    /// The horizontal axis.
    pub(crate) x: Axis,
    /// The vertical axis.
    pub(crate) y: Axis,
    /// The curves; a later one is drawn over an earlier one.
    pub(crate) series: Vec<Series>,
    /// Whether one unit is equally long on both axes (for paths in a plane).
    pub(crate) equal_aspect: bool,
    /// Where the legend stands.
    pub(crate) legend: Legend,
}

impl Default for Figure {
    fn default() -> Self {
        Self {
            title: None,
            alt: None,
            width: 640.0,
            height: 400.0,
            x: Axis::default(),
            y: Axis::default(),
            series: Vec::new(),
            equal_aspect: false,
            legend: Legend::Auto,
        }
    }
}

impl Figure {
    /// An empty figure of 640 x 400 pixels with these axis labels.
    #[must_use]
    pub(crate) fn new(x_label: impl Into<String>, y_label: impl Into<String>) -> Self {
        let mut figure = Self::default();
        figure.x.label = x_label.into();
        figure.y.label = y_label.into();
        figure
    }

    /// The same figure with one more series.
    #[must_use]
    pub(crate) fn with(mut self, series: Series) -> Self {
        self.series.push(series);
        self
    }

    /// The figure as one SVG element.
    #[must_use]
    pub(crate) fn svg(&self) -> String {
        compose::svg(std::slice::from_ref(self), None, None)
    }

    /// The figure as a PNG file on white, two pixels for each CSS pixel.
    ///
    /// # Errors
    /// If the size of the figure is zero, not finite or too large for memory.
    pub(crate) fn png(&self) -> Result<Vec<u8>, FigureError> {
        png::render(&self.svg())
    }
}

/// Figures stacked from top to bottom that share one horizontal axis.
///
/// The horizontal axis is that of the last figure; its range covers the data of all.
/// The heights add up; the width is that of the first. Panels whose series have the
/// same names and styles get one legend for all of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Panels {
    /// Heading above the first panel.
    pub(crate) title: Option<String>,
    /// Words for readers who cannot see it.
    pub(crate) alt: Option<String>,
    /// The panels, the topmost first; their own titles are not drawn.
    pub(crate) figures: Vec<Figure>,
}

impl Panels {
    /// A stack of these panels without a heading.
    #[must_use]
    pub(crate) fn new(figures: Vec<Figure>) -> Self {
        Self { figures, ..Self::default() }
    }

    /// The panels as one SVG element.
    #[must_use]
    pub(crate) fn svg(&self) -> String {
        compose::svg(&self.figures, self.title.as_deref(), self.alt.as_deref())
    }

    /// The panels as a PNG file on white, two pixels for each CSS pixel.
    ///
    /// # Errors
    /// If the size of the figure is zero, not finite or too large for memory.
    pub(crate) fn png(&self) -> Result<Vec<u8>, FigureError> {
        png::render(&self.svg())
    }
}
