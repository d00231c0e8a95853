//! Figures of a study: convergence, curves and scatter plots, histograms.

use ancf_figure::{AxisScale, CurveStyle, DashPattern, Figure, FigureSeries, MarkerShape};
use ancf_study::{Convergence, RecordedColumn};

/// Width and height of a figure in CSS pixels.
const SIZE: [f64; 2] = [640.0, 340.0];

/// Objective over a parameter: a curve if each value occurs once, otherwise points.
pub fn dependence(parameter: &RecordedColumn, objective: &RecordedColumn) -> Figure {
    let mut points: Vec<[f64; 2]> =
        parameter.numbers.iter().zip(&objective.numbers).map(|(x, y)| [*x, *y]).collect();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let is_curve = points.windows(2).all(|pair| pair[0][0] < pair[1][0]) && points.len() <= 50;
    let dash = if is_curve { DashPattern::Solid } else { DashPattern::None };
    let mut figure = sized(&parameter.name, &objective.name);
    figure.x.scale = scale(&parameter.numbers);
    let (x, y) = points.into_iter().map(|[x, y]| (x, y)).unzip();
    figure.with(FigureSeries::new("", x, y).style(style().dashed(dash).marked(MarkerShape::Circle, 1)))
}

/// Error against the limit over the size, with a line of the last observed order.
pub fn error_over_size(
    found: &Convergence,
    parameter: &RecordedColumn,
    objective: &RecordedColumn,
) -> Option<Figure> {
    let limit = found.limit?;
    let order = found.orders.iter().copied().rfind(|order| order.is_finite())?;
    let points = found.sizes.iter().zip(&found.values).map(|(h, f)| (*h, (f - limit).abs()));
    let (x, y): (Vec<f64>, Vec<f64>) = points.filter(|(_, error)| *error > 0.0).unzip();
    let (last, error) = (*x.last()?, *y.last()?);
    let line: Vec<f64> = x.iter().map(|h| error * (h / last).powf(order)).collect();
    let label = if parameter.is_integer { format!("1/{}", parameter.name) } else { parameter.name.clone() };
    let mut figure = sized(&label, &format!("error of {}", objective.name));
    (figure.x.scale, figure.y.scale) = (AxisScale::Log, AxisScale::Log);
    let slope = CurveStyle::nth(7).dashed(DashPattern::Dashed);
    Some(
        figure
            .with(FigureSeries::new(format!("order {order:.2}"), x.clone(), line).style(slope))
            .with(FigureSeries::new("cases", x, y).style(style().marked(MarkerShape::Circle, 1))),
    )
}

/// Histogram with a number of bins by the rule of Freedman and Diaconis (1981), at least 5 and at most 60.
pub fn histogram(objective: &RecordedColumn) -> Option<Figure> {
    let mut sorted: Vec<f64> = objective.numbers.iter().copied().filter(|x| x.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    let (low, high) = (*sorted.first()?, *sorted.last()?);
    if high <= low {
        return None;
    }
    let quartile = |part: f64| sorted[(part * (sorted.len() - 1) as f64) as usize];
    let width = 2.0 * (quartile(0.75) - quartile(0.25)) / (sorted.len() as f64).cbrt();
    let bins = ((high - low) / width.max((high - low) / 60.0)).ceil().clamp(5.0, 60.0) as usize;
    let mut counts = vec![0.0; bins];
    for x in &sorted {
        let bin = ((x - low) / (high - low) * bins as f64) as usize;
        counts[bin.min(bins - 1)] += 1.0;
    }
    let edge = |k: usize| low + (high - low) * k as f64 / bins as f64;
    let (mut x, mut y) = (vec![low], vec![0.0]);
    for (k, count) in counts.iter().enumerate() {
        x.extend([edge(k), edge(k + 1), edge(k + 1)]);
        y.extend([*count, *count, 0.0]);
    }
    let mut figure = sized(&objective.name, "cases");
    figure.alt = Some(format!("Histogram of {}", objective.name));
    Some(figure.with(FigureSeries::new("", x, y).style(style())))
}

fn sized(x: &str, y: &str) -> Figure {
    let [width, height] = SIZE;
    Figure { width, height, ..Figure::new(x, y) }
}

/// Blue.
fn style() -> CurveStyle {
    CurveStyle::nth(1).dashed(DashPattern::Solid)
}

/// Logarithmic scale for positive values over more than a factor of 30.
fn scale(values: &[f64]) -> AxisScale {
    let (least, largest) =
        values.iter().fold((f64::INFINITY, 0.0), |(a, b): (f64, f64), x| (a.min(*x), b.max(*x)));
    if least > 0.0 && largest > 30.0 * least { AxisScale::Log } else { AxisScale::Linear }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(numbers: Vec<f64>) -> RecordedColumn {
        RecordedColumn { name: "y".into(), numbers, ..RecordedColumn::default() }
    }

    /// The bins contain all cases; a constant has no histogram.
    #[test]
    fn histograms_count_all_cases() {
        let figure = histogram(&column((0..200).map(|k| f64::from(k % 17)).collect())).unwrap();
        let counted: f64 = figure.series[0].y.chunks(3).map(|bin| bin.get(1).copied().unwrap_or(0.0)).sum();
        assert_eq!(counted, 200.0);
        assert_eq!(histogram(&column(vec![2.0; 9])), None);
    }

    /// Sampled values are points, few distinct values are a curve.
    #[test]
    fn distinct_values_are_a_curve() {
        let objective = column(vec![3.0, 1.0, 2.0]);
        let curve = dependence(&column(vec![3.0, 1.0, 2.0]), &objective);
        assert_eq!(
            (curve.series[0].x.as_slice(), curve.series[0].style.dash),
            (&[1.0, 2.0, 3.0][..], DashPattern::Solid)
        );
        let points = dependence(&column(vec![1.0, 1.0, 2.0]), &objective);
        assert_eq!(points.series[0].style.dash, DashPattern::None);
    }
}
