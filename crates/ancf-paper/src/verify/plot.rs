use ancf_verification::{Curve, Mark, Plot};

use crate::figure::{Dash, Figure, Marker, Scale, Series, Style};

/// Signs of references; a figure needs no more to tell them apart.
const SIGNS: [Marker; 5] = [Marker::Circle, Marker::Square, Marker::Triangle, Marker::Diamond, Marker::Cross];
/// Points of a reference that stand apart in a figure; of more, only some are shown.
const MOST_POINTS: usize = 60;

/// A plot as a figure: lines for ours, points for references; if they are pairs, in one colour.
pub fn figure(plot: &Plot) -> Figure {
    let [x, y] = &plot.axes;
    let mut figure = Figure::new(x, y);
    figure.alt = Some(words(plot));
    figure.equal_aspect = plot.equal;
    if plot.equal {
        figure.height = 520.0;
    }
    let scale = |logarithmic| if logarithmic { Scale::Log } else { Scale::Linear };
    (figure.x.scale, figure.y.scale) = (scale(plot.logarithmic[0]), scale(plot.logarithmic[1]));
    // Points lie over lines, whatever their order.
    let [lines, points] = [Mark::Line, Mark::Points]
        .map(|mark| plot.curves.iter().filter(|curve| curve.mark == mark).collect::<Vec<_>>());
    let pairs = lines.len() == points.len();
    let ours = lines.iter().enumerate().map(|(k, curve)| series(curve, line(k, lines.len())));
    figure.series.extend(ours);
    let references = points.iter().enumerate().map(|(k, curve)| series(curve, sign(k, curve, pairs)));
    figure.series.extend(references);
    figure
}

fn series(curve: &Curve, style: Style) -> Series {
    let [x, y] = [0, 1].map(|axis| curve.points.iter().map(|point| point[axis]).collect());
    Series::new(&curve.name, x, y).style(style)
}

/// The line number `k` of so many: each is wider than the next, which may hide it.
fn line(k: usize, count: usize) -> Style {
    let above = (count - 1 - k).min(4) as f64;
    Style { width: 1.4 + 0.5 * above, ..Style::nth(colour(k)) }.dashed(Style::nth(k).dash)
}

/// The reference number `k`: in the colour of its line, or black if lines and references are no pairs.
fn sign(k: usize, curve: &Curve, pairs: bool) -> Style {
    let every = curve.points.len().div_ceil(MOST_POINTS).max(1);
    let colour = if pairs { colour(k) } else { 0 };
    Style { colour, ..Style::default() }.dashed(Dash::None).marked(SIGNS[k % SIGNS.len()], every)
}

/// Blue first, black last.
const fn colour(k: usize) -> usize {
    k + 1
}

fn words(plot: &Plot) -> String {
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
            Curve { name: name.into(), mark, points }
        };
        let plot = Plot {
            title: "Errors".into(),
            axes: ["n".into(), "error".into()],
            equal: false,
            logarithmic: [true, true],
            curves: vec![curve("reference", Mark::Points, 130), curve("ours", Mark::Line, 5)],
        };
        let figure = figure(&plot);
        let [ours, reference] = &figure.series[..] else { panic!("two series") };
        assert_eq!((ours.name.as_str(), ours.style.marker), ("ours", Marker::None));
        assert_eq!((reference.style.dash, reference.style.marker_every), (Dash::None, 3));
        assert_eq!((figure.x.scale, figure.y.scale), (Scale::Log, Scale::Log));
        assert!(figure.svg().contains("aria-label=\"Errors: error against n: reference, ours\""));
    }
}
