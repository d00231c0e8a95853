//! Panels as an SVG, PNG or PDF file.

use std::fs;
use std::path::Path;

use ancf_figure::{CurveStyle, DashPattern, Figure, FigurePanels, FigureSeries, MarkerShape};
use anyhow::{Context, Result};

use super::decimate::decimated;
use super::figure_format::FigureFormat;
use super::panel::{PanelCurve, PlotPanel};

/// Pixel columns of the decimation, more than the plot has.
const COLUMNS: usize = 1280;

/// Writes the panels as one figure.
///
/// # Errors
/// If the file cannot be written.
pub fn write(panels: &[PlotPanel], title: Option<&str>, file: &Path, format: FigureFormat) -> Result<()> {
    let mut figures = FigurePanels::new(panels.iter().map(figure).collect());
    figures.title = title.map(str::to_owned);
    let bytes = match format {
        FigureFormat::Svg => figures.svg().into_bytes(),
        FigureFormat::Png => figures.png().context("the figure cannot be drawn")?,
        FigureFormat::Pdf => figures.pdf().context("the figure cannot be drawn")?,
    };
    fs::write(file, bytes).with_context(|| format!("cannot write {}", file.display()))
}

fn figure(panel: &PlotPanel) -> Figure {
    let y = match &panel.curves[..] {
        [_] => panel.label(),
        // The names are in the legend.
        _ => panel.unit.clone(),
    };
    let mut figure = Figure::new(&panel.x, y);
    let [range, _] = panel.ranges();
    for (number, curve) in panel.curves.iter().enumerate() {
        let name = if panel.curves.len() > 1 { curve.name.as_str() } else { "" };
        let (x, y) = points(curve, range).into_iter().map(|[x, y]| (x, y)).unzip();
        // The first colour is blue.
        let style = CurveStyle::nth(number + 1);
        let style = if panel.is_discrete {
            style.dashed(DashPattern::None).marked(MarkerShape::Circle, 1)
        } else {
            style.dashed(CurveStyle::nth(number).dash)
        };
        figure.series.push(FigureSeries::new(name, x, y).style(style));
    }
    figure.alt = Some(format!("{} against {}", panel.label(), panel.x));
    figure
}

/// Returns the decimated points, with NaN between the pieces.
fn points(curve: &PanelCurve, range: [f64; 2]) -> Vec<[f64; 2]> {
    let pieces: Vec<_> = curve.pieces().iter().map(|piece| decimated(piece, range, COLUMNS)).collect();
    pieces.join(&[f64::NAN; 2])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_remain_and_the_rest_is_decimated() {
        let x: Vec<f64> = (0..50_000).map(f64::from).collect();
        let y = x.iter().map(|&x| if x == 20_000.0 { f64::NAN } else { x.sin() }).collect();
        let curve = PanelCurve { name: "a".into(), x, y };
        let points = points(&curve, [0.0, 49_999.0]);
        assert!(points.len() < 5 * COLUMNS);
        assert_eq!(points.iter().filter(|point| point[1].is_nan()).count(), 1);
    }
}
