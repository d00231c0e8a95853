//! Data of a figure: axes, series, legend.

use crate::style::CurveStyle;

/// Scale of an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AxisScale {
    /// Linear.
    #[default]
    Linear,
    /// Logarithmic. Values that are not positive are omitted.
    Log,
}

/// Axis of a figure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FigureAxis {
    /// Label with the unit, e.g. `time (s)`.
    pub label: String,
    /// Linear or logarithmic.
    pub scale: AxisScale,
    /// Lower and upper limit in the unit of the data; `None` fits the data.
    pub range: Option<(f64, f64)>,
}

/// Placement of the legend.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LegendPlacement {
    /// In a corner of the plot that is free of data, otherwise below the plot.
    #[default]
    Auto,
    /// Below the plot, in columns.
    Below,
    /// No legend.
    Hidden,
}

/// Curve or set of points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FigureSeries {
    /// Name in the legend. A series without a name is drawn but not listed.
    pub name: String,
    /// Abscissas, in the unit of the x axis.
    pub x: Vec<f64>,
    /// Ordinates, in the unit of the y axis. A value that is not finite interrupts the line.
    pub y: Vec<f64>,
    /// Line and marker style.
    pub style: CurveStyle,
}

impl FigureSeries {
    /// Creates a series in the default style, see [`FigureSeries::style`].
    #[must_use]
    pub fn new(name: impl Into<String>, x: Vec<f64>, y: Vec<f64>) -> Self {
        Self { name: name.into(), x, y, style: CurveStyle::default() }
    }

    /// Creates a horizontal line at `y` from `x.0` to `x.1`.
    #[must_use]
    pub fn horizontal(name: impl Into<String>, y: f64, x: (f64, f64)) -> Self {
        Self::new(name, vec![x.0, x.1], vec![y, y])
    }

    /// Sets the style.
    #[must_use]
    pub fn style(mut self, style: CurveStyle) -> Self {
        self.style = style;
        self
    }
}

/// Figure with two axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// Heading above the plot.
    pub title: Option<String>,
    /// Alternative text for screen readers. Default: title, labels and names of the series.
    pub alt: Option<String>,
    /// Width in CSS pixels. The PNG has twice as many pixels.
    pub width: f64,
    /// Height in CSS pixels, including the legend. `equal_aspect` may reduce it.
    pub height: f64,
    /// Horizontal axis.
    pub x: FigureAxis,
    /// Vertical axis.
    pub y: FigureAxis,
    /// Series in drawing order.
    pub series: Vec<FigureSeries>,
    /// True for equal scales of both axes (paths in a plane).
    pub equal_aspect: bool,
    /// Placement of the legend.
    pub legend: LegendPlacement,
}

impl Figure {
    /// Creates an empty figure of 640 x 400 pixels with these axis labels.
    #[must_use]
    pub fn new(x_label: impl Into<String>, y_label: impl Into<String>) -> Self {
        let axis = |label| FigureAxis { label, ..FigureAxis::default() };
        Self {
            title: None,
            alt: None,
            width: 640.0,
            height: 400.0,
            x: axis(x_label.into()),
            y: axis(y_label.into()),
            series: Vec::new(),
            equal_aspect: false,
            legend: LegendPlacement::Auto,
        }
    }

    /// Adds a series.
    #[must_use]
    pub fn with(mut self, series: FigureSeries) -> Self {
        self.series.push(series);
        self
    }

    /// Returns the alternative text.
    pub(crate) fn alt_text(&self) -> String {
        let names: Vec<&str> = self.series.iter().map(|s| s.name.as_str()).collect();
        let title = self.title.as_deref().unwrap_or("Figure");
        let words = || format!("{title}: {} against {}: {}", self.y.label, self.x.label, names.join(", "));
        self.alt.clone().unwrap_or_else(words)
    }
}

/// Figures stacked from top to bottom, best of equal width and horizontal range.
///
/// Only the last panel shows the label of its horizontal axis. If all panels have the same legend, only the first shows it.
/// The heights add up.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FigurePanels {
    /// Heading above the first panel.
    pub title: Option<String>,
    /// Alternative text for screen readers.
    pub alt: Option<String>,
    /// Panels from top to bottom. Their own titles are not drawn.
    pub figures: Vec<Figure>,
}

impl FigurePanels {
    /// Creates a stack of panels without a heading.
    #[must_use]
    pub fn new(figures: Vec<Figure>) -> Self {
        Self { figures, ..Self::default() }
    }
}
