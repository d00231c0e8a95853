//! Figure of the report with its file name and caption.

use ancf_figure::{Figure, FigurePanels, SpaceFigure};
use anyhow::{Result, anyhow};

/// Figure with its file name and caption.
#[derive(Clone, Debug)]
pub struct PaperFigure {
    /// Name of the files without the extension.
    pub file: &'static str,
    /// Caption.
    pub caption: String,
    drawing: Drawn,
}

/// Plane figure, stacked panels or figure in space.
#[derive(Clone, Debug)]
pub(super) enum Drawn {
    Plane(Figure),
    Stack(FigurePanels),
    Space(SpaceFigure),
}

impl PaperFigure {
    /// Creates a figure with its caption.
    pub(super) fn new(file: &'static str, drawing: impl Into<Drawn>, caption: impl Into<String>) -> Self {
        Self { file, caption: caption.into(), drawing: drawing.into() }
    }

    /// Sets the alternative text.
    pub(super) fn described(mut self, words: impl Into<String>) -> Self {
        let words = Some(words.into());
        match &mut self.drawing {
            Drawn::Plane(figure) => figure.alt = words,
            Drawn::Stack(panels) => panels.alt = words,
            Drawn::Space(figure) => figure.alt = words,
        }
        self
    }

    /// Returns the figure as an SVG element.
    pub fn svg(&self) -> String {
        match &self.drawing {
            Drawn::Plane(figure) => figure.svg(),
            Drawn::Stack(panels) => panels.svg(),
            Drawn::Space(figure) => figure.svg(),
        }
    }

    /// Returns the figure as a PNG file.
    ///
    /// # Errors
    /// If the figure cannot be drawn.
    pub fn png(&self) -> Result<Vec<u8>> {
        let png = match &self.drawing {
            Drawn::Plane(figure) => figure.png(),
            Drawn::Stack(panels) => panels.png(),
            Drawn::Space(figure) => figure.png(),
        };
        png.map_err(|error| anyhow!("{}: {error}", self.file))
    }
}

impl From<Figure> for Drawn {
    fn from(figure: Figure) -> Self {
        Self::Plane(figure)
    }
}

impl From<FigurePanels> for Drawn {
    fn from(panels: FigurePanels) -> Self {
        Self::Stack(panels)
    }
}

impl From<SpaceFigure> for Drawn {
    fn from(figure: SpaceFigure) -> Self {
        Self::Space(figure)
    }
}
