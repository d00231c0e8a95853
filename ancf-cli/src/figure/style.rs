//! Colours, dashes and markers, chosen to stay apart in grey print.

use super::svg::{Canvas, Point, Stroke};

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
pub(crate) enum Dash {
    /// Unbroken.
    #[default]
    Solid,
    /// Long strokes.
    Dashed,
    /// Dots.
    Dotted,
    /// Long strokes and dots in turn.
    Chain,
    /// No line, markers only.
    None,
}

/// The sign drawn at data points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Marker {
    /// No sign.
    #[default]
    None,
    /// A circle.
    Circle,
    /// A square.
    Square,
    /// An upright triangle.
    Triangle,
    /// A diamond.
    Diamond,
    /// A slanting cross.
    Cross,
}

/// How one series is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Style {
    /// Colour by number: black, blue, vermilion, green, purple, sky, orange, grey, then anew.
    pub(crate) colour: usize,
    /// Whether the colour is thinned to a light tint, for a wide line under others.
    pub(crate) pale: bool,
    /// The pattern of the line.
    pub(crate) dash: Dash,
    /// Width of the line in CSS pixels.
    pub(crate) width: f64,
    /// The sign at the data points.
    pub(crate) marker: Marker,
    /// Every how many points a marker stands; with more than one, the series of a figure take turns.
    pub(crate) marker_every: usize,
}

impl Default for Style {
    fn default() -> Self {
        Self { colour: 0, pale: false, dash: Dash::Solid, width: 1.4, marker: Marker::None, marker_every: 1 }
    }
}

impl Style {
    /// The line style of the series number `index`: each differs in colour and, from its neighbours, in dash.
    #[must_use]
    pub(crate) fn nth(index: usize) -> Self {
        let dashes = [Dash::Solid, Dash::Dashed, Dash::Chain, Dash::Dotted];
        Self { colour: index, dash: dashes[index % dashes.len()], ..Self::default() }
    }

    /// The style with a marker at every `every`-th point.
    #[must_use]
    pub(crate) fn marked(mut self, marker: Marker, every: usize) -> Self {
        self.marker = marker;
        self.marker_every = every;
        self
    }

    /// The style as a wide pale line, `width` CSS pixels, to lie under others.
    #[must_use]
    pub(crate) fn wide(mut self, width: f64) -> Self {
        self.pale = true;
        self.dash = Dash::Solid;
        self.width = width;
        self
    }

    /// The style with another line pattern.
    #[must_use]
    pub(crate) fn dashed(mut self, dash: Dash) -> Self {
        self.dash = dash;
        self
    }

    /// The style as a thin line of its projection on a floor.
    pub(super) fn shadow(self) -> Self {
        Self { pale: true, dash: Dash::Solid, width: 0.9, marker: Marker::None, ..self }
    }

    /// The colour as `#rrggbb`.
    pub(super) fn hex(&self) -> String {
        let [r, g, b] = PALETTE[self.colour % PALETTE.len()];
        let tint = |c: u8| {
            let c = f64::from(c);
            if self.pale { c + (255.0 - c) * 0.62 } else { c }
        };
        format!("#{:02x}{:02x}{:02x}", tint(r) as u8, tint(g) as u8, tint(b) as u8)
    }

    /// The line, or nothing where the style has none.
    pub(super) fn stroke(&self) -> Option<Stroke> {
        let u = self.width.max(1.0);
        let pattern = match self.dash {
            Dash::None => return None,
            Dash::Solid => Vec::new(),
            Dash::Dashed => vec![4.6 * u, 2.6 * u],
            Dash::Dotted => vec![1.3 * u, 1.9 * u],
            Dash::Chain => vec![5.4 * u, 2.1 * u, 1.3 * u, 2.1 * u],
        };
        Some(Stroke { colour: self.hex(), width: self.width, pattern })
    }

    /// Draws this style's markers at these points.
    pub(super) fn draw_markers(&self, canvas: &mut Canvas, points: &[Point]) {
        if self.marker == Marker::None || points.is_empty() {
            return;
        }
        let mut path = String::new();
        for &(x, y) in points {
            path.push_str(&self.outline(x, y));
        }
        let width = if self.marker == Marker::Cross { 1.5 } else { 1.2 };
        let stroke = Stroke { colour: self.hex(), width, pattern: Vec::new() };
        let fill = match self.marker {
            Marker::Cross => "none",
            _ => "#fff",
        };
        canvas.path(&path, &stroke, fill);
    }

    /// The path of one marker around a point.
    fn outline(&self, x: f64, y: f64) -> String {
        match self.marker {
            Marker::None => String::new(),
            Marker::Circle => format!("M{:.1} {y:.1}a3.1 3.1 0 1 0 6.2 0a3.1 3.1 0 1 0-6.2 0z", x - 3.1),
            Marker::Square => format!("M{:.1} {:.1}h5.6v5.6h-5.6z", x - 2.8, y - 2.8),
            Marker::Triangle => format!("M{x:.1} {:.1}l3.6 6.2h-7.2z", y - 4.0),
            Marker::Diamond => format!("M{x:.1} {:.1}l3.9 3.9l-3.9 3.9l-3.9-3.9z", y - 3.9),
            Marker::Cross => {
                format!("M{:.1} {:.1}l5.8 5.8M{:.1} {:.1}l5.8-5.8", x - 2.9, y - 2.9, x - 2.9, y + 2.9)
            }
        }
    }
}
