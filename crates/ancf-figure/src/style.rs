//! Colours, dash patterns and markers that remain distinguishable in greyscale print.

/// Okabe-Ito palette without yellow, dark colours first, and a grey.
const PALETTE: [[u8; 3]; 8] = [
    [0x00, 0x00, 0x00],
    [0x00, 0x72, 0xb2],
    [0xd5, 0x5e, 0x00],
    [0x00, 0x9e, 0x73],
    [0xcc, 0x79, 0xa7],
    [0x56, 0xb4, 0xe9],
    [0xe6, 0x9f, 0x00],
    [0x80, 0x80, 0x80],
];

/// Dash pattern of a line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DashPattern {
    /// Continuous line.
    #[default]
    Solid,
    /// Dashes.
    Dashed,
    /// Dots.
    Dotted,
    /// Alternating long dashes and dots.
    Chain,
    /// No line, markers only.
    None,
}

/// Marker drawn at data points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MarkerShape {
    /// No marker.
    #[default]
    None,
    /// Circle.
    Circle,
    /// Square.
    Square,
    /// Upright triangle.
    Triangle,
    /// Diamond.
    Diamond,
    /// Diagonal cross.
    Cross,
}

/// Line and marker style of one series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveStyle {
    /// Colour index: black, blue, vermilion, green, purple, sky blue, orange, grey, then cyclic.
    pub colour: usize,
    /// True for a light tint of the colour, for a wide line below others.
    pub pale: bool,
    /// Dash pattern of the line.
    pub dash: DashPattern,
    /// Line width in CSS pixels.
    pub width: f64,
    /// Marker at the data points.
    pub marker: MarkerShape,
    /// Number of points per marker. If it is above one, the series of a figure are offset against each other.
    pub marker_every: usize,
}

impl Default for CurveStyle {
    fn default() -> Self {
        Self {
            colour: 0,
            pale: false,
            dash: DashPattern::Solid,
            width: 1.4,
            marker: MarkerShape::None,
            marker_every: 1,
        }
    }
}

impl CurveStyle {
    /// Returns the line style of series `index`. Colours differ, and so do the dash patterns of neighbours.
    #[must_use]
    pub fn nth(index: usize) -> Self {
        let dash =
            [DashPattern::Solid, DashPattern::Dashed, DashPattern::Chain, DashPattern::Dotted][index % 4];
        Self { colour: index, dash, ..Self::default() }
    }

    /// Sets a marker at every `every`-th point.
    #[must_use]
    pub fn marked(self, marker: MarkerShape, every: usize) -> Self {
        Self { marker, marker_every: every, ..self }
    }

    /// Makes the line pale, solid and `width` CSS pixels wide, to be drawn below others.
    #[must_use]
    pub fn wide(self, width: f64) -> Self {
        Self { pale: true, dash: DashPattern::Solid, width, ..self }
    }

    /// Sets the dash pattern.
    #[must_use]
    pub fn dashed(self, dash: DashPattern) -> Self {
        Self { dash, ..self }
    }

    /// Returns the colour as `#rrggbb`.
    pub(crate) fn hex(&self) -> String {
        let tint = |c: u8| if self.pale { c + ((255 - c) as f64 * 0.62) as u8 } else { c };
        let [r, g, b] = PALETTE[self.colour % PALETTE.len()].map(tint);
        format!("#{r:02x}{g:02x}{b:02x}")
    }

    /// Returns the lengths of dashes and gaps, `None` for a solid line.
    pub(crate) fn dashes(&self) -> Option<String> {
        let pattern: &[f64] = match self.dash {
            DashPattern::Solid | DashPattern::None => return None,
            DashPattern::Dashed => &[4.6, 2.6],
            DashPattern::Dotted => &[1.3, 1.9],
            DashPattern::Chain => &[5.4, 2.1, 1.3, 2.1],
        };
        Some(pattern.iter().map(|v| format!("{:.1} ", v * self.width.max(1.0))).collect())
    }

    /// Returns the SVG path data of the marker at a point.
    pub(crate) fn outline(&self, (x, y): (f64, f64)) -> String {
        let (dx, dy, path) = match self.marker {
            MarkerShape::None => return String::new(),
            MarkerShape::Circle => (-3.1, 0.0, "a3.1 3.1 0 1 0 6.2 0a3.1 3.1 0 1 0-6.2 0z"),
            MarkerShape::Square => (-2.8, -2.8, "h5.6v5.6h-5.6z"),
            MarkerShape::Triangle => (0.0, -4.0, "l3.6 6.2h-7.2z"),
            MarkerShape::Diamond => (0.0, -3.9, "l3.9 3.9l-3.9 3.9l-3.9-3.9z"),
            MarkerShape::Cross => (-2.9, -2.9, "l5.8 5.8m0-5.8l-5.8 5.8"),
        };
        format!("M{:.1} {:.1}{path}", x + dx, y + dy)
    }
}
