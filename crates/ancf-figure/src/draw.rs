//! What plane and space figures share: curves, markers, legends, and the way to SVG and PNG.

use std::sync::{Arc, LazyLock};

use kuva::backend::svg::SvgBackend;
use kuva::render::render::{PathData, Primitive, Scene, TextAnchor};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

use super::{Dash, Legend, Marker, Style};

pub(super) type Point = (f64, f64);
/// Left, top, right and bottom of a rectangle.
pub(super) type Rect = [f64; 4];

/// Arimo, cut down to Latin, Greek and mathematical signs (SIL Open Font License 1.1).
const FONT: &[u8] = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/fonts/Arimo-Subset.ttf"));
/// The same widths under the names that readers' machines have.
pub(super) const FAMILY: &str = "Arimo, Liberation Sans, Arial, Helvetica, sans-serif";
const LEGEND_SIZE: u32 = 12;
const SAMPLE: f64 = 34.0;
const ROW: f64 = 18.0;

static OPTIONS: LazyLock<Options<'static>> = LazyLock::new(|| {
    let mut options = Options { font_family: "Arimo".to_owned(), ..Options::default() };
    Arc::make_mut(&mut options.fontdb).load_font_data(FONT.to_vec());
    options
});

/// Why a figure could not be turned into a PNG.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the figure cannot be drawn as PNG: {0}")]
pub struct FigureError(String);

/// Draws SVG text at twice its size on white.
pub(super) fn png(svg: &str) -> Result<Vec<u8>, FigureError> {
    let tree = Tree::from_str(svg, &OPTIONS).map_err(|e| FigureError(e.to_string()))?;
    let (w, h) = ((tree.size().width() * 2.0).ceil(), (tree.size().height() * 2.0).ceil());
    let picture = Pixmap::new(w as u32, h as u32);
    let mut picture = picture.ok_or_else(|| FigureError(format!("{w} x {h} pixels")))?;
    resvg::render(&tree, Transform::from_scale(2.0, 2.0), &mut picture.as_mut());
    picture.encode_png().map_err(|e| FigureError(e.to_string()))
}

/// The scene as one SVG element with a text for readers who cannot see it.
pub(super) fn svg(scene: &Scene, alt: &str) -> String {
    spoken(alt, (scene.width, scene.height), &bare(scene))
}

/// The scene as SVG without the opening of the tag.
pub(super) fn bare(scene: &Scene) -> String {
    SvgBackend::new().render_scene(scene).split_off("<svg ".len())
}

/// Puts the opening of the tag before the rest of an SVG element.
pub(super) fn spoken(alt: &str, (w, h): Point, rest: &str) -> String {
    let alt = escape(alt);
    format!("<svg role=\"img\" aria-label=\"{alt}\" viewBox=\"0 0 {w} {h}\" stroke-linejoin=\"round\" {rest}")
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

pub(super) fn text(
    scene: &mut Scene,
    (x, y): Point,
    text: &str,
    size: u32,
    anchor: TextAnchor,
    rotate: Option<f64>,
) {
    if !text.is_empty() {
        let content = text.to_owned();
        scene.add(Primitive::Text { x, y, content, size, anchor, rotate, bold: false, color: None });
    }
}

/// Width of a text in the bundled font.
pub(super) fn text_width(text: &str, size: u32) -> f64 {
    let text = format!("<text y=\"50\" font-size=\"{size}\">{}</text>", escape(text));
    let svg = format!("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" height=\"9\">{text}</svg>");
    Tree::from_str(&svg, &OPTIONS).map_or(0.0, |tree| tree.root().abs_bounding_box().right().into())
}

/// Draws polylines in a style.
pub(super) fn curve(scene: &mut Scene, parts: &[Vec<Point>], style: &Style) {
    if style.dash == Dash::None {
        return;
    }
    let mut d = String::new();
    for part in parts {
        for (i, (x, y)) in part.iter().enumerate() {
            d.push_str(&format!("{}{x:.2} {y:.2}", if i == 0 { "M" } else { "L" }));
        }
    }
    path(scene, d, style, style.width, None, style.dashes());
}

/// Draws a style's markers at these points.
pub(super) fn markers(scene: &mut Scene, points: &[Point], style: &Style) {
    let d = points.iter().map(|p| style.outline(*p)).collect();
    let fill = (style.marker != Marker::Cross).then_some("#fff");
    path(scene, d, style, 1.3, fill, None);
}

fn path(scene: &mut Scene, d: String, style: &Style, width: f64, fill: Option<&str>, dashes: Option<String>) {
    if !d.is_empty() {
        let (fill, stroke) = (fill.map(Into::into), style.hex().into());
        let (stroke_width, stroke_dasharray, opacity) = (width, dashes, None);
        let data = PathData { d, fill, stroke, stroke_width, opacity, stroke_dasharray };
        scene.add(Primitive::Path(Box::new(data)));
    }
}

/// The named styles of a figure and the room they take.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Key {
    entries: Vec<(String, Style)>,
    width: f64,
}

impl Key {
    pub(super) fn new<'a>(legend: Legend, series: impl Iterator<Item = (&'a String, Style)>) -> Self {
        let named = series.filter(|(name, _)| legend != Legend::Hidden && !name.is_empty());
        let entries: Vec<_> = named.map(|(name, style)| (name.clone(), style)).collect();
        let widths = entries.iter().map(|(name, _)| text_width(name, LEGEND_SIZE));
        let width = SAMPLE + 7.0 + widths.fold(0.0, f64::max);
        Self { entries, width }
    }

    fn columns(&self, room: f64) -> usize {
        let fit = ((room + 24.0) / (self.width + 24.0)).floor().max(1.0) as usize;
        self.entries.len().div_ceil(self.entries.len().div_ceil(fit).max(1))
    }

    /// Height of the entries set in columns below a plot.
    pub(super) fn height(&self, room: f64) -> f64 {
        if self.entries.is_empty() {
            return 0.0;
        }
        self.entries.len().div_ceil(self.columns(room)) as f64 * ROW + 8.0
    }

    /// The first place inside `frame` that no line and no point comes near.
    pub(super) fn free_place(&self, frame: Rect, data: &[Vec<Point>]) -> Option<Rect> {
        let (w, h) = (self.width + 12.0, self.entries.len() as f64 * ROW + 8.0);
        let (left, right) = (frame[0] + 9.0, frame[2] - 9.0 - w);
        let (top, bottom) = (frame[1] + 9.0, frame[3] - 9.0 - h);
        let places = [top, bottom].map(|y| [right, left, (left + right) / 2.0].map(|x| [x, y, x + w, y + h]));
        let near = |p: &Rect| [p[0] - 5.0, p[1] - 5.0, p[2] + 5.0, p[3] + 5.0];
        let free = |p: &Rect| data.iter().all(|part| clip(part, near(p)).is_empty());
        let fits = right >= left && bottom >= top && !self.entries.is_empty();
        places.into_iter().flatten().find(|p| fits && free(p))
    }

    /// Draws the entries in one column on white.
    pub(super) fn draw_inside(&self, scene: &mut Scene, [x, y, right, bottom]: Rect) {
        let (width, height, fill) = (right - x, bottom - y, "#fff".into());
        let (stroke, stroke_width, opacity) = (None, None, None);
        scene.add(Primitive::Rect { x, y, width, height, fill, stroke, stroke_width, opacity });
        self.draw(scene, (x + 6.0, y + 4.0), 1);
    }

    /// Draws the entries in columns around `centre`, from `top` down.
    pub(super) fn draw_below(&self, scene: &mut Scene, centre: f64, top: f64, room: f64) {
        let columns = self.columns(room);
        let width = columns as f64 * (self.width + 24.0) - 24.0;
        self.draw(scene, ((centre - width / 2.0).max(8.0), top), columns);
    }

    fn draw(&self, scene: &mut Scene, (left, top): Point, columns: usize) {
        for (i, (name, style)) in self.entries.iter().enumerate() {
            let x = left + (i % columns) as f64 * (self.width + 24.0);
            let y = top + ((i / columns) as f64 + 0.5) * ROW;
            curve(scene, &[vec![(x, y), (x + SAMPLE, y)]], style);
            markers(scene, &[(x + SAMPLE / 2.0, y)], style);
            text(scene, (x + SAMPLE + 7.0, y + 4.2), name, LEGEND_SIZE, TextAnchor::Start, None);
        }
    }
}

/// The parts of a polyline within a rectangle (Liang and Barsky); a lone point counts as a line.
pub(super) fn clip(points: &[Point], [left, top, right, bottom]: Rect) -> Vec<Vec<Point>> {
    let mut parts: Vec<Vec<Point>> = Vec::new();
    let lone = if let [p] = points { vec![*p, *p] } else { Vec::new() };
    for pair in points.windows(2).chain(lone.windows(2)) {
        let ((ax, ay), (bx, by)) = (pair[0], pair[1]);
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for (a, d, low, high) in [(ax, bx - ax, left, right), (ay, by - ay, top, bottom)] {
            let (t0, t1) = ((low - a) / d, (high - a) / d);
            if d == 0.0 {
                to = if (low..=high).contains(&a) { to } else { -1.0 };
            } else {
                (from, to) = (from.max(t0.min(t1)), to.min(t0.max(t1)));
            }
        }
        if from > to {
            continue;
        }
        let at = |t: f64| (ax + t * (bx - ax), ay + t * (by - ay));
        match parts.last_mut() {
            Some(part) if from == 0.0 && part.last() == Some(&(ax, ay)) => part.push(at(to)),
            _ => parts.push(vec![at(from), at(to)]),
        }
    }
    parts
}

/// A polyline with fewer points that looks the same.
///
/// Where it never runs back, the first, lowest, highest and last point of every half pixel stay;
/// elsewhere the points that are a third of a pixel apart; of these, those not on a straight line.
pub(super) fn thin(points: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::new();
    let mut keep = |p: Point| {
        if let [.., a, b] = kept[..] {
            let (dx, dy, bx, by) = (p.0 - a.0, p.1 - a.1, b.0 - a.0, b.1 - a.1);
            let (length, between) = (dx.hypot(dy), (0.0..=dx * dx + dy * dy).contains(&(dx * bx + dy * by)));
            if between && (dx * by - dy * bx).abs() <= 0.004 * length {
                kept.pop();
            }
        }
        kept.push(p);
    };
    let rising = points.is_sorted_by(|a, b| a.0 <= b.0);
    let cell = |p: &Point| {
        if rising { ((p.0 * 2.0).floor(), 0.0) } else { ((p.0 * 3.0).floor(), (p.1 * 3.0).floor()) }
    };
    for group in points.chunk_by(|a, b| cell(a) == cell(b)) {
        let by_height = |i: &usize, j: &usize| group[*i].1.total_cmp(&group[*j].1);
        let (low, high) = ((0..group.len()).min_by(by_height), (0..group.len()).max_by(by_height));
        let mut chosen = vec![0, low.unwrap_or(0), high.unwrap_or(0), group.len() - 1];
        chosen.sort_unstable();
        chosen.dedup();
        chosen.into_iter().for_each(|i| keep(group[i]));
    }
    kept
}
