//! A small writer of SVG elements, and the widths of text.

use std::fmt::Write as _;

/// A point of the drawing, in CSS pixels from the top left.
pub(super) type Point = (f64, f64);

/// Families in the order tried; all but the last have the same widths.
const FAMILY: &str = "Arimo, 'Liberation Sans', Arial, Helvetica, sans-serif";
/// Colour of text, frame and ticks.
pub(super) const INK: &str = "#222222";

/// Advance widths of the characters 32 to 126 in thousandths of the font size.
#[rustfmt::skip]
const ADVANCE: [u16; 95] = [
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584,
];

/// Width of a text in CSS pixels at a font size.
pub(super) fn text_width(text: &str, size: f64) -> f64 {
    let width = |c: char| {
        let index = (c as usize).wrapping_sub(32);
        ADVANCE.get(index).map_or(590.0, |&w| f64::from(w))
    };
    text.chars().map(width).sum::<f64>() * size / 1000.0
}

/// The font size, at most `size`, at which a text is no wider than `room`.
pub(super) fn fitting(text: &str, size: f64, room: f64) -> f64 {
    let width = text_width(text, size);
    if width > room { (size * room / width).max(5.0) } else { size }
}

/// A rectangle of the drawing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Rect {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) w: f64,
    pub(super) h: f64,
}

impl Rect {
    pub(super) fn right(&self) -> f64 {
        self.x + self.w
    }

    pub(super) fn bottom(&self) -> f64 {
        self.y + self.h
    }

    /// The rectangle with every side moved out by `by`.
    pub(super) fn grown(&self, by: f64) -> Self {
        Self { x: self.x - by, y: self.y - by, w: self.w + 2.0 * by, h: self.h + 2.0 * by }
    }

    pub(super) fn contains(&self, (x, y): Point) -> bool {
        x >= self.x && x <= self.right() && y >= self.y && y <= self.bottom()
    }

    /// The part of a segment that lies within, if any (Liang and Barsky).
    pub(super) fn clip(&self, a: Point, b: Point) -> Option<(Point, Point)> {
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for (p, q) in
            [(-dx, a.0 - self.x), (dx, self.right() - a.0), (-dy, a.1 - self.y), (dy, self.bottom() - a.1)]
        {
            if p == 0.0 {
                if q < 0.0 {
                    return None;
                }
            } else if p < 0.0 {
                from = from.max(q / p);
            } else {
                to = to.min(q / p);
            }
        }
        let at = |t: f64| (a.0 + t * dx, a.1 + t * dy);
        (from <= to).then(|| (at(from), at(to)))
    }
}

/// How a line is drawn.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Stroke {
    pub(super) colour: String,
    pub(super) width: f64,
    /// Lengths drawn and left out in turn, in CSS pixels; empty for unbroken.
    pub(super) pattern: Vec<f64>,
}

impl Stroke {
    pub(super) fn plain(colour: &str, width: f64) -> Self {
        Self { colour: colour.to_owned(), width, pattern: Vec::new() }
    }
}

/// Where a text stands against its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// A number with at most two decimals and none to spare.
pub(super) fn number(value: f64) -> String {
    if !value.is_finite() {
        return "0".to_owned();
    }
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0" } else { text }.to_owned()
}

/// Text made safe for element content and quoted attributes.
pub(super) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

/// The elements drawn so far.
#[derive(Debug, Default)]
pub(super) struct Canvas {
    body: String,
}

impl Canvas {
    /// A filled rectangle without a border.
    pub(super) fn fill(&mut self, r: Rect, colour: &str) {
        let _ = writeln!(
            self.body,
            r#"<rect x="{}" y="{}" width="{}" height="{}" fill="{colour}"/>"#,
            number(r.x),
            number(r.y),
            number(r.w),
            number(r.h)
        );
    }

    /// A path with the data `d`; nothing if that is empty.
    pub(super) fn path(&mut self, d: &str, stroke: &Stroke, fill: &str) {
        if d.is_empty() {
            return;
        }
        let _ = write!(
            self.body,
            r#"<path d="{d}" fill="{fill}" stroke="{}" stroke-width="{}""#,
            stroke.colour,
            number(stroke.width)
        );
        if stroke.pattern.is_empty() && stroke.width <= 2.0 {
            // Round ends make a dot of a single point; wide lines would overrun the frame.
            self.body.push_str(r#" stroke-linecap="round""#);
        } else if !stroke.pattern.is_empty() {
            let pattern: Vec<String> = stroke.pattern.iter().map(|&v| number(v)).collect();
            let _ = write!(self.body, r#" stroke-dasharray="{}""#, pattern.join(" "));
        }
        self.body.push_str(" stroke-linejoin=\"round\"/>\n");
    }

    /// Many plain segments in one path.
    pub(super) fn segments(&mut self, segments: &[(Point, Point)], stroke: &Stroke) {
        let mut d = String::new();
        for &((ax, ay), (bx, by)) in segments {
            let _ = write!(d, "M{} {}L{} {}", number(ax), number(ay), number(bx), number(by));
        }
        self.path(&d, stroke, "none");
    }

    /// A text with its baseline at the point.
    pub(super) fn text(&mut self, at: Point, text: &str, size: f64, anchor: Anchor) {
        self.marked_up(at, &escape(text), size, anchor, false);
    }

    /// A text that reads upwards, its baseline at the point.
    pub(super) fn upright(&mut self, at: Point, text: &str, size: f64) {
        self.marked_up(at, &escape(text), size, Anchor::Middle, true);
    }

    /// A base with a raised exponent, after a text in front of it.
    pub(super) fn power(&mut self, at: Point, front: &str, exponent: i32, size: f64, anchor: Anchor) {
        let sign = if exponent < 0 { "\u{2212}" } else { "" };
        let text = format!(
            r#"{}10<tspan dy="{}" font-size="{}">{sign}{}</tspan>"#,
            escape(front),
            number(-0.38 * size),
            number(0.76 * size),
            exponent.unsigned_abs()
        );
        self.marked_up(at, &text, size, anchor, false);
    }

    fn marked_up(&mut self, (x, y): Point, text: &str, size: f64, anchor: Anchor, up: bool) {
        if text.is_empty() {
            return;
        }
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => r#" text-anchor="middle""#,
            Anchor::End => r#" text-anchor="end""#,
        };
        let (x, y) = (number(x), number(y));
        let turn = if up { format!(r#" transform="rotate(-90 {x} {y})""#) } else { String::new() };
        let _ = writeln!(
            self.body,
            r#"<text x="{x}" y="{y}" font-size="{}"{anchor}{turn}>{text}</text>"#,
            number(size)
        );
    }

    /// The whole SVG element on white.
    pub(super) fn finish(self, width: f64, height: f64, words: &str) -> String {
        let (w, h, words) = (number(width), number(height), escape(words));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}\" height=\"{h}\" \
             viewBox=\"0 0 {w} {h}\" role=\"img\" aria-label=\"{words}\" \
             font-family=\"{FAMILY}\" fill=\"{INK}\">\n<title>{words}</title>\n\
             <rect width=\"{w}\" height=\"{h}\" fill=\"#fff\"/>\n{}</svg>\n",
            self.body
        )
    }
}
