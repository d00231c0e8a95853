//! Colours, dashes and markers, chosen to stay apart in grey print.

/// Okabe-Ito colours without the yellow, the dark ones first, and a grey.
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

/// The pattern of a line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dash {
    #[default]
    Solid,
    Dashed,
    Dotted,
    /// Long strokes and dots in turn.
    Chain,
    /// No line, markers only.
    None,
}

/// The sign drawn at data points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Marker {
    #[default]
    None,
    Circle,
    Square,
    Triangle,
    Diamond,
    Cross,
}

/// How one series is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// Colour by number: black, blue, vermilion, green, purple, sky, orange, grey, then anew.
    pub colour: usize,
    /// Whether the colour is thinned to a light tint, for a wide line under others.
    pub pale: bool,
    /// The pattern of the line.
    pub dash: Dash,
    /// Width of the line in CSS pixels.
    pub width: f64,
    /// The sign at the data points.
    pub marker: Marker,
    /// Every how many points a marker stands; with more than one, the series of a figure take turns.
    pub marker_every: usize,
}

impl Default for Style {
    fn default() -> Self {
        Self { colour: 0, pale: false, dash: Dash::Solid, width: 1.4, marker: Marker::None, marker_every: 1 }
    }
}

impl Style {
    /// The line style of the series number `index`: each differs in colour and, from its neighbours, in dash.
    #[must_use]
    pub fn nth(index: usize) -> Self {
        let dash = [Dash::Solid, Dash::Dashed, Dash::Chain, Dash::Dotted][index % 4];
        Self { colour: index, dash, ..Self::default() }
    }

    /// The style with a marker at every `every`-th point.
    #[must_use]
    pub fn marked(self, marker: Marker, every: usize) -> Self {
        Self { marker, marker_every: every, ..self }
    }

    /// The style as a wide pale line, `width` CSS pixels, to lie under others.
    #[must_use]
    pub fn wide(self, width: f64) -> Self {
        Self { pale: true, dash: Dash::Solid, width, ..self }
    }

    /// The style with another line pattern.
    #[must_use]
    pub fn dashed(self, dash: Dash) -> Self {
        Self { dash, ..self }
    }

    /// The colour as `#rrggbb`.
    pub(super) fn hex(&self) -> String {
        let tint = |c: u8| if self.pale { c + ((255 - c) as f64 * 0.62) as u8 } else { c };
        let [r, g, b] = PALETTE[self.colour % PALETTE.len()].map(tint);
        format!("#{r:02x}{g:02x}{b:02x}")
    }

    /// The strokes and gaps of the line, `None` for an unbroken one.
    pub(super) fn dashes(&self) -> Option<String> {
        let pattern: &[f64] = match self.dash {
            Dash::Solid | Dash::None => return None,
            Dash::Dashed => &[4.6, 2.6],
            Dash::Dotted => &[1.3, 1.9],
            Dash::Chain => &[5.4, 2.1, 1.3, 2.1],
        };
        Some(pattern.iter().map(|v| format!("{:.1} ", v * self.width.max(1.0))).collect())
    }

    /// SVG path data of the marker around a point.
    pub(super) fn outline(&self, (x, y): (f64, f64)) -> String {
        let (dx, dy, path) = match self.marker {
            Marker::None => return String::new(),
            Marker::Circle => (-3.1, 0.0, "a3.1 3.1 0 1 0 6.2 0a3.1 3.1 0 1 0-6.2 0z"),
            Marker::Square => (-2.8, -2.8, "h5.6v5.6h-5.6z"),
            Marker::Triangle => (0.0, -4.0, "l3.6 6.2h-7.2z"),
            Marker::Diamond => (0.0, -3.9, "l3.9 3.9l-3.9 3.9l-3.9-3.9z"),
            Marker::Cross => (-2.9, -2.9, "l5.8 5.8m0-5.8l-5.8 5.8"),
        };
        format!("M{:.1} {:.1}{path}", x + dx, y + dy)
    }
}
