//! The figures of the report.

mod cantilever;
mod conditioning;
mod revolute;
mod spherical;

use anyhow::{Result, anyhow};

use super::results::Results;
use super::study::Study;
use crate::figure::{Dash, Figure, Legend, Panels, SpaceFigure, Style};

/// A figure under the name of its files.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// Name of the files without the ending.
    pub file: &'static str,
    /// What it shows, for readers who see it.
    pub caption: String,
    picture: Picture,
}

/// What can be drawn.
#[derive(Clone, Debug)]
enum Picture {
    Plane(Figure),
    Stack(Panels),
    Space(SpaceFigure),
}

impl Drawing {
    fn new(file: &'static str, picture: impl Into<Picture>, caption: impl Into<String>) -> Self {
        Self { file, caption: caption.into(), picture: picture.into() }
    }

    /// The same drawing with words for readers who cannot see it.
    fn described(mut self, words: impl Into<String>) -> Self {
        let words = Some(words.into());
        match &mut self.picture {
            Picture::Plane(figure) => figure.alt = words,
            Picture::Stack(panels) => panels.alt = words,
            Picture::Space(figure) => figure.alt = words,
        }
        self
    }

    /// As an SVG element.
    pub fn svg(&self) -> String {
        match &self.picture {
            Picture::Plane(figure) => figure.svg(),
            Picture::Stack(panels) => panels.svg(),
            Picture::Space(figure) => figure.svg(),
        }
    }

    /// As a PNG file.
    ///
    /// # Errors
    /// If it cannot be drawn.
    pub fn png(&self) -> Result<Vec<u8>> {
        let png = match &self.picture {
            Picture::Plane(figure) => figure.png(),
            Picture::Stack(panels) => panels.png(),
            Picture::Space(figure) => figure.png(),
        };
        png.map_err(|error| anyhow!("{}: {error}", self.file))
    }
}

impl From<Figure> for Picture {
    fn from(figure: Figure) -> Self {
        Self::Plane(figure)
    }
}

impl From<Panels> for Picture {
    fn from(panels: Panels) -> Self {
        Self::Stack(panels)
    }
}

impl From<SpaceFigure> for Picture {
    fn from(figure: SpaceFigure) -> Self {
        Self::Space(figure)
    }
}

/// All figures, in the order of the paper.
pub fn all(study: &Study, results: &Results) -> Vec<Drawing> {
    let mut drawings = cantilever::all(study, results);
    drawings.extend(revolute::all(study, results));
    drawings.extend(spherical::all(study, results));
    drawings.push(conditioning::figure(results));
    drawings
}

/// Names in legends.
const DIM: &str = "DIM";
const NONDIM: &str = "Non-DIM";
const RIGID: &str = "rigid body";

/// Blue, unbroken.
fn dim() -> Style {
    Style::nth(1).dashed(Dash::Solid)
}

/// Vermilion, dashed, so that what lies below shows through.
fn nondim() -> Style {
    Style::nth(2).dashed(Dash::Dashed)
}

/// Pale grey, wide, below the others.
fn pale() -> Style {
    Style::nth(7).wide(5.0)
}

/// Panels of the same curves with one legend, in the first.
fn stack<const N: usize>(figures: [Figure; N]) -> Panels {
    let mut panels = Panels::new(figures.to_vec());
    for figure in panels.figures.iter_mut().skip(1) {
        figure.legend = Legend::Hidden;
    }
    panels
}

/// A column in another unit.
fn times(factor: f64, column: &[f64]) -> Vec<f64> {
    column.iter().map(|x| factor * x).collect()
}

/// Numbers of elements as abscissas.
fn elements(n: &[u32]) -> Vec<f64> {
    n.iter().copied().map(f64::from).collect()
}
