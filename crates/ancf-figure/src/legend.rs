//! Legend of a figure.

use kuva::render::render::{Primitive, Scene, TextAnchor};

use crate::draw;
use crate::format::svg::text_width;
use crate::polyline::{Point, Rect, clip};
use crate::style::CurveStyle;
use crate::types::LegendPlacement;

/// Font size of the names.
const LEGEND_SIZE: u32 = 12;
/// Length of the line sample.
const SAMPLE: f64 = 34.0;
/// Height of an entry.
const ROW: f64 = 18.0;

/// Legend: named styles and the width of an entry.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct LegendBox {
    entries: Vec<(String, CurveStyle)>,
    width: f64,
}

impl LegendBox {
    /// Creates the legend of the named series.
    pub(crate) fn new<'a>(
        placement: LegendPlacement,
        series: impl Iterator<Item = (&'a String, CurveStyle)>,
    ) -> Self {
        let named = series.filter(|(name, _)| placement != LegendPlacement::Hidden && !name.is_empty());
        let entries: Vec<_> = named.map(|(name, style)| (name.clone(), style)).collect();
        let widths = entries.iter().map(|(name, _)| text_width(name, LEGEND_SIZE));
        let width = SAMPLE + 7.0 + widths.fold(0.0, f64::max);
        Self { entries, width }
    }

    fn columns(&self, available: f64) -> usize {
        let fit = ((available + 24.0) / (self.width + 24.0)).floor().max(1.0) as usize;
        self.entries.len().div_ceil(self.entries.len().div_ceil(fit).max(1))
    }

    /// Returns the height of the legend below a plot, in columns.
    pub(crate) fn height(&self, available: f64) -> f64 {
        if self.entries.is_empty() {
            return 0.0;
        }
        self.entries.len().div_ceil(self.columns(available)) as f64 * ROW + 8.0
    }

    /// Returns the first place inside `frame` that is free of lines and points.
    pub(crate) fn free_place(&self, frame: Rect, data: &[Vec<Point>]) -> Option<Rect> {
        let (w, h) = (self.width + 12.0, self.entries.len() as f64 * ROW + 8.0);
        let (left, right) = (frame[0] + 9.0, frame[2] - 9.0 - w);
        let (top, bottom) = (frame[1] + 9.0, frame[3] - 9.0 - h);
        let places = [top, bottom].map(|y| [right, left, (left + right) / 2.0].map(|x| [x, y, x + w, y + h]));
        let near = |p: &Rect| [p[0] - 5.0, p[1] - 5.0, p[2] + 5.0, p[3] + 5.0];
        let free = |p: &Rect| data.iter().all(|part| clip(part, near(p)).is_empty());
        let fits = right >= left && bottom >= top && !self.entries.is_empty();
        places.into_iter().flatten().find(|p| fits && free(p))
    }

    /// Draws the entries in one column on a white background.
    pub(crate) fn draw_inside(&self, scene: &mut Scene, [x, y, right, bottom]: Rect) {
        let (width, height, fill) = (right - x, bottom - y, "#fff".into());
        let (stroke, stroke_width, opacity) = (None, None, None);
        scene.add(Primitive::Rect { x, y, width, height, fill, stroke, stroke_width, opacity });
        self.draw(scene, (x + 6.0, y + 4.0), 1);
    }

    /// Draws the entries in columns, centred at `centre`, from `top` down.
    pub(crate) fn draw_below(&self, scene: &mut Scene, centre: f64, top: f64, available: f64) {
        let columns = self.columns(available);
        let width = columns as f64 * (self.width + 24.0) - 24.0;
        self.draw(scene, ((centre - width / 2.0).max(8.0), top), columns);
    }

    fn draw(&self, scene: &mut Scene, (left, top): Point, columns: usize) {
        for (i, (name, style)) in self.entries.iter().enumerate() {
            let x = left + (i % columns) as f64 * (self.width + 24.0);
            let y = top + ((i / columns) as f64 + 0.5) * ROW;
            draw::curve(scene, &[vec![(x, y), (x + SAMPLE, y)]], style);
            draw::markers(scene, &[(x + SAMPLE / 2.0, y)], style);
            draw::text(scene, (x + SAMPLE + 7.0, y + 4.2), name, LEGEND_SIZE, TextAnchor::Start, None);
        }
    }
}
