use std::fs;
use std::path::Path;

use anyhow::{Context, Result};

use super::panel::{Curve, Panel};
use super::thin::thinned;
use crate::figure::{Dash, Figure, Marker, Panels, Series, Style};

/// What a figure is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    Svg,
    Png,
}

impl Format {
    /// By the ending of a file's name.
    ///
    /// # Errors
    /// If it is no format, in words.
    pub fn of(file: &Path) -> Result<Self, String> {
        let ending = file.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            Some("svg") => Ok(Self::Svg),
            Some("png") => Ok(Self::Png),
            _ => Err(format!("{}: wanted a file that ends with .svg or .png", file.display())),
        }
    }
}

/// Pixels across, more than there are in the frame.
const COLUMNS: usize = 1280;

/// Writes the panels as one figure.
///
/// # Errors
/// If the file cannot be written.
pub fn write(panels: &[Panel], file: &Path, format: Format) -> Result<()> {
    let figures = Panels::new(panels.iter().map(figure).collect());
    let bytes = match format {
        Format::Svg => figures.svg().into_bytes(),
        Format::Png => figures.png().context("the figure cannot be drawn")?,
    };
    fs::write(file, bytes).with_context(|| format!("cannot write {}", file.display()))
}

fn figure(panel: &Panel) -> Figure {
    let y = match &panel.curves[..] {
        [_] => panel.label(),
        // The legend has the names.
        _ => panel.unit.clone(),
    };
    let mut figure = Figure::new(&panel.x, y);
    let [range, _] = panel.ranges();
    for (number, curve) in panel.curves.iter().enumerate() {
        let name = if panel.curves.len() > 1 { curve.name.as_str() } else { "" };
        let (x, y) = points(curve, range).into_iter().map(|[x, y]| (x, y)).unzip();
        // Blue first.
        let style = Style::nth(number + 1);
        let style = if panel.is_discrete {
            style.dashed(Dash::None).marked(Marker::Circle, 1)
        } else {
            style.dashed(Style::nth(number).dash)
        };
        figure.series.push(Series::new(name, x, y).style(style));
    }
    figure.alt = Some(format!("{} against {}", panel.label(), panel.x));
    figure
}

/// The points that are seen, with what is no number between the pieces.
fn points(curve: &Curve, range: [f64; 2]) -> Vec<[f64; 2]> {
    let pieces: Vec<_> = curve.pieces().iter().map(|piece| thinned(piece, range, COLUMNS)).collect();
    pieces.join(&[f64::NAN; 2])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_have_formats() {
        assert_eq!(Format::of(Path::new("a.b/tip.SVG")), Ok(Format::Svg));
        assert_eq!(Format::of(Path::new("tip.png")), Ok(Format::Png));
        assert!(Format::of(Path::new("tip")).is_err() && Format::of(Path::new("tip.pdf")).is_err());
    }

    #[test]
    fn gaps_stay_and_the_rest_is_thinned() {
        let x: Vec<f64> = (0..50_000).map(f64::from).collect();
        let y = x.iter().map(|&x| if x == 20_000.0 { f64::NAN } else { x.sin() }).collect();
        let curve = Curve { name: "a".into(), x, y };
        let points = points(&curve, [0.0, 49_999.0]);
        assert!(points.len() < 5 * COLUMNS);
        assert_eq!(points.iter().filter(|point| point[1].is_nan()).count(), 1);
    }
}
