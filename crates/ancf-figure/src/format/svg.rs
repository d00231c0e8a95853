//! SVG text of a scene, PNG of SVG text, text widths in the bundled font.

use std::sync::{Arc, LazyLock};

use kuva::backend::svg::SvgBackend;
use kuva::render::render::Scene;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

/// Arimo, reduced to Latin, Greek and mathematical characters (SIL Open Font License 1.1).
const FONT: &[u8] = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/fonts/Arimo-Subset.ttf"));
/// Metric-compatible font families, for readers without Arimo.
pub(crate) const FAMILY: &str = "Arimo, Liberation Sans, Arial, Helvetica, sans-serif";

static OPTIONS: LazyLock<Options<'static>> = LazyLock::new(|| {
    let mut options = Options { font_family: "Arimo".to_owned(), ..Options::default() };
    Arc::make_mut(&mut options.fontdb).load_font_data(FONT.to_vec());
    options
});

/// Failure of the conversion into another format.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the figure cannot be converted: {0}")]
pub struct FigureError(String);

/// Parses SVG text.
pub(crate) fn tree(svg: &str) -> Result<Tree, FigureError> {
    Tree::from_str(svg, &OPTIONS).map_err(|e| FigureError(e.to_string()))
}

/// Renders SVG text at twice its size on white.
pub(crate) fn png(svg: &str) -> Result<Vec<u8>, FigureError> {
    let tree = tree(svg)?;
    let (w, h) = ((tree.size().width() * 2.0).ceil(), (tree.size().height() * 2.0).ceil());
    let picture = Pixmap::new(w as u32, h as u32);
    let mut picture = picture.ok_or_else(|| FigureError(format!("{w} x {h} pixels")))?;
    resvg::render(&tree, Transform::from_scale(2.0, 2.0), &mut picture.as_mut());
    picture.encode_png().map_err(|e| FigureError(e.to_string()))
}

/// Returns the scene as one SVG element with an alternative text.
pub(crate) fn element(scene: &Scene, alt: &str) -> String {
    with_opening(alt, (scene.width, scene.height), &without_opening(scene))
}

/// Returns the scene as SVG without the opening of the tag.
pub(crate) fn without_opening(scene: &Scene) -> String {
    SvgBackend::new().render_scene(scene).split_off("<svg ".len())
}

/// Prepends the opening of the tag to the rest of an SVG element.
pub(crate) fn with_opening(alt: &str, (w, h): (f64, f64), rest: &str) -> String {
    let alt = escape(alt);
    format!("<svg role=\"img\" aria-label=\"{alt}\" viewBox=\"0 0 {w} {h}\" stroke-linejoin=\"round\" {rest}")
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Returns the width of a text in the bundled font.
pub(crate) fn text_width(text: &str, size: u32) -> f64 {
    let text = format!("<text y=\"50\" font-size=\"{size}\">{}</text>", escape(text));
    let svg = format!("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" height=\"9\">{text}</svg>");
    tree(&svg).map_or(0.0, |tree| tree.root().abs_bounding_box().right().into())
}
