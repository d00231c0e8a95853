//! Plots of the verification as figures.

use ancf_figure::{AxisScale, CurveStyle, DashPattern, Figure, FigureSeries, MarkerShape};
use ancf_verification::{Mark, Plot, PlotCurve};

/// Markers of references.
const MARKERS: [MarkerShape; 5] = [
    MarkerShape::Circle,
    MarkerShape::Square,
    MarkerShape::Triangle,
    MarkerShape::Diamond,
    MarkerShape::Cross,
];
/// Maximum number of markers of a reference.
const MAX_MARKERS: usize = 60;

/// Creates a figure: lines for computed curves, markers for references. Pairs of both have one colour.
pub fn figure(plot: &Plot) -> Figure {
    let [x, y] = &plot.axes;
    let mut figure = Figure::new(x, y);
    figure.alt = Some(alt_text(plot));
    figure.equal_aspect = plot.equal;
    if plot.equal {
        figure.height = 520.0;
    }
    let scale = |logarithmic| if logarithmic { AxisScale::Log } else { AxisScale::Linear };
    (figure.x.scale, figure.y.scale) = (scale(plot.logarithmic[0]), scale(plot.logarithmic[1]));
    // Markers are drawn over lines.
    let [lines, points] = [Mark::Line, Mark::Points]
        .map(|mark| plot.curves.iter().filter(|curve| curve.mark == mark).collect::<Vec<_>>());
    let pairs = lines.len() == points.len();
    let ours = lines.iter().enumerate().map(|(k, curve)| series(curve, line(k, lines.len())));
    figure.series.extend(ours);
    let references = points.iter().enumerate().map(|(k, curve)| series(curve, marker(k, curve, pairs)));
    figure.series.extend(references);
    figure
}

fn series(curve: &PlotCurve, style: CurveStyle) -> FigureSeries {
    let [x, y] = [0, 1].map(|axis| curve.points.iter().map(|point| point[axis]).collect());
    FigureSeries::new(&curve.name, x, y).style(style)
}

/// Returns the style of line `k` of `count`. Each line is wider than the next, which may cover it.
fn line(k: usize, count: usize) -> CurveStyle {
    let above = (count - 1 - k).min(4) as f64;
    CurveStyle { width: 1.4 + 0.5 * above, ..CurveStyle::nth(colour(k)) }.dashed(CurveStyle::nth(k).dash)
}

/// Returns the style of reference `k`: the colour of its line, black without pairs.
fn marker(k: usize, curve: &PlotCurve, pairs: bool) -> CurveStyle {
    let every = curve.points.len().div_ceil(MAX_MARKERS).max(1);
    let colour = if pairs { colour(k) } else { 0 };
    CurveStyle { colour, ..CurveStyle::default() }
        .dashed(DashPattern::None)
        .marked(MARKERS[k % MARKERS.len()], every)
}

/// Returns the colour of curve `k`: blue first, black last.
const fn colour(k: usize) -> usize {
    k + 1
}

fn alt_text(plot: &Plot) -> String {
    let [x, y] = &plot.axes;
    let names: Vec<&str> = plot.curves.iter().map(|curve| curve.name.as_str()).collect();
    format!("{}: {y} against {x}: {}", plot.title, names.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_ours_and_points_are_references() {
        let curve = |name: &str, mark, count: u32| {
            let points = (1..=count).map(|k| [f64::from(k), 10f64.powi(-(k as i32))]).collect();
            PlotCurve { name: name.into(), mark, points }
        };
        let plot = Plot {
            title: "Errors".into(),
            axes: ["n".into(), "error".into()],
            equal: false,
            logarithmic: [true, true],
            curves: vec![curve("reference", Mark::Points, 130), curve("ancf", Mark::Line, 5)],
        };
        let figure = figure(&plot);
        let [ours, reference] = &figure.series[..] else { panic!("two series") };
        assert_eq!((ours.name.as_str(), ours.style.marker), ("ancf", MarkerShape::None));
        assert_eq!((reference.style.dash, reference.style.marker_every), (DashPattern::None, 3));
        assert_eq!((figure.x.scale, figure.y.scale), (AxisScale::Log, AxisScale::Log));
        assert!(figure.svg().contains("aria-label=\"Errors: error against n: reference, ancf\""));
    }
}
