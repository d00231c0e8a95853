//! Turns SVG text into a PNG file with the bundled font.

use std::sync::Arc;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb};

/// Arimo, cut down to Latin, Greek and mathematical signs (SIL Open Font License 1.1).
const FONT: &[u8] = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/fonts/Arimo-Subset.ttf"));
/// PNG pixels for each CSS pixel.
const SCALE: f32 = 2.0;

/// Why a figure could not be turned into a PNG.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub(crate) enum FigureError {
    /// The SVG could not be read back; the text says where.
    Parse(String),
    /// A picture of this many pixels (width, height) cannot be made.
    Size(u32, u32),
    /// The PNG could not be written; the text says why.
    Encode(String),
}

impl std::fmt::Display for FigureError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Parse(why) => write!(f, "the figure's SVG cannot be read: {why}"),
            Self::Size(w, h) => write!(f, "a picture of {w} x {h} pixels cannot be made"),
            Self::Encode(why) => write!(f, "the figure's PNG cannot be written: {why}"),
        }
    }
}

impl std::error::Error for FigureError {}

/// Draws SVG text at twice its size on white.
pub(super) fn render(svg: &str) -> Result<Vec<u8>, FigureError> {
    let mut fonts = fontdb::Database::new();
    fonts.load_font_data(FONT.to_vec());
    fonts.set_sans_serif_family("Arimo");
    let options = Options { font_family: "Arimo".to_owned(), fontdb: Arc::new(fonts), ..Options::default() };
    let tree = Tree::from_str(svg, &options).map_err(|e| FigureError::Parse(e.to_string()))?;
    let width = (tree.size().width() * SCALE).ceil() as u32;
    let height = (tree.size().height() * SCALE).ceil() as u32;
    let mut picture = Pixmap::new(width, height).ok_or(FigureError::Size(width, height))?;
    let scale = Transform::from_scale(SCALE, SCALE);
    resvg::render(&tree, scale, &mut picture.as_mut());
    picture.encode_png().map_err(|e| FigureError::Encode(e.to_string()))
}
