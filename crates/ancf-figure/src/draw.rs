//! Texts, polylines and markers in a scene.

use kuva::render::render::{PathData, Primitive, Scene, TextAnchor};

use crate::polyline::Point;
use crate::style::{CurveStyle, DashPattern, MarkerShape};

/// Draws a text. An empty one is omitted.
pub(crate) fn text(
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

/// Draws polylines in a style.
pub(crate) fn curve(scene: &mut Scene, parts: &[Vec<Point>], style: &CurveStyle) {
    if style.dash == DashPattern::None {
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

/// Draws the markers of a style at these points.
pub(crate) fn markers(scene: &mut Scene, points: &[Point], style: &CurveStyle) {
    let d = points.iter().map(|p| style.outline(*p)).collect();
    let fill = (style.marker != MarkerShape::Cross).then_some("#fff");
    path(scene, d, style, 1.3, fill, None);
}

fn path(
    scene: &mut Scene,
    d: String,
    style: &CurveStyle,
    width: f64,
    fill: Option<&str>,
    dashes: Option<String>,
) {
    if !d.is_empty() {
        let (fill, stroke) = (fill.map(Into::into), style.hex().into());
        let (stroke_width, stroke_dasharray, opacity) = (width, dashes, None);
        let data = PathData { d, fill, stroke, stroke_width, opacity, stroke_dasharray };
        scene.add(Primitive::Path(Box::new(data)));
    }
}
