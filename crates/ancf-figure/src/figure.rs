//! SVG, PNG and PDF of plane figures and of stacked panels.

use crate::format::pdf;
use crate::format::svg::{self, FigureError};
use crate::plot;
use crate::types::{Figure, FigurePanels, LegendPlacement};

impl Figure {
    /// Returns the figure as one SVG element.
    #[must_use]
    pub fn svg(&self) -> String {
        svg::element(&plot::scene(self, None), &self.alt_text())
    }

    /// Returns the figure as a PNG file on white, two pixels per CSS pixel.
    ///
    /// # Errors
    /// If the size of the figure is zero or too large for memory.
    pub fn png(&self) -> Result<Vec<u8>, FigureError> {
        svg::png(&self.svg())
    }

    /// Returns the figure as a PDF file with one page.
    ///
    /// # Errors
    /// If the size of the figure is zero.
    pub fn pdf(&self) -> Result<Vec<u8>, FigureError> {
        pdf::page(&self.svg())
    }
}

impl FigurePanels {
    /// Returns the panels as one SVG element.
    #[must_use]
    pub fn svg(&self) -> String {
        let names = |f: &Figure| f.series.iter().map(|s| (s.name.clone(), s.style)).collect::<Vec<_>>();
        let shared = self.figures.windows(2).all(|w| names(&w[0]) == names(&w[1]));
        let (mut body, mut words, mut height) = (String::new(), Vec::new(), 0.0);
        for (i, figure) in self.figures.iter().enumerate() {
            let mut figure = Figure { title: self.title.clone().filter(|_| i == 0), ..figure.clone() };
            words.push(figure.alt_text());
            if i + 1 < self.figures.len() {
                figure.x.label.clear();
            }
            if shared && i > 0 {
                figure.legend = LegendPlacement::Hidden;
            }
            let scene = plot::scene(&figure, None);
            body += &format!("<svg y=\"{height}\" {}", svg::without_opening(&scene));
            height += scene.height;
        }
        let width = self.figures.iter().map(|f| f.width).fold(0.0, f64::max);
        let size = format!("xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\"");
        let words = self.alt.clone().unwrap_or_else(|| format!("Panels. {}", words.join("; ")));
        svg::with_opening(&words, (width, height), &format!("{size}>{body}</svg>"))
    }

    /// Returns the panels as a PNG file on white, two pixels per CSS pixel.
    ///
    /// # Errors
    /// If the size is zero or too large for memory.
    pub fn png(&self) -> Result<Vec<u8>, FigureError> {
        svg::png(&self.svg())
    }

    /// Returns the panels as a PDF file with one page.
    ///
    /// # Errors
    /// If the size is zero.
    pub fn pdf(&self) -> Result<Vec<u8>, FigureError> {
        pdf::page(&self.svg())
    }
}
