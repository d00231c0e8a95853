use nalgebra::{DMatrix, DVector};

use super::record::RecordedColumn;

/// Sensitivity of an objective y to the numeric parameters x that vary.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensitivity {
    /// Parameters in the order of the study.
    pub parameters: Vec<ParameterSensitivity>,
    /// Fraction of the variance of y that the linear regression explains.
    pub explained: f64,
}

/// Sensitivity of an objective to one parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterSensitivity {
    /// Path of the parameter.
    pub name: String,
    /// Standardised coefficient of the linear regression on all parameters. Its square is the fraction of the variance of y due
    /// to x, if y is linear and the parameters are independent.
    pub regression: f64,
    /// Rank correlation (Spearman 1904): 1 or −1 if y is a monotonic function of x alone.
    pub rank: f64,
}

/// Estimates the sensitivity of an objective. `None` with fewer than two cases more than parameters, or if the objective is constant.
pub fn sensitivity(parameters: &[&RecordedColumn], objective: &RecordedColumn) -> Option<Sensitivity> {
    let kept: Vec<usize> =
        (0..objective.numbers.len()).filter(|&k| objective.numbers[k].is_finite()).collect();
    let (n, count) = (kept.len(), parameters.len());
    if count == 0 || n < count + 2 {
        return None;
    }
    let values = |column: &RecordedColumn| kept.iter().map(|&k| column.numbers[k]).collect::<Vec<_>>();
    let columns: Vec<Vec<f64>> = parameters.iter().map(|column| values(column)).collect();
    let fit = linear_fit(&columns, &values(objective))?;
    let one = |k: usize| ParameterSensitivity {
        name: parameters[k].name.clone(),
        regression: fit.coefficients[k],
        rank: fit.ranks[k],
    };
    Some(Sensitivity { parameters: (0..count).map(one).collect(), explained: fit.explained })
}

/// Linear regression of values y on columns of numbers x, and rank correlations.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearFit {
    /// Standardised coefficients.
    pub coefficients: Vec<f64>,
    /// Rank correlations of each column with the values (Spearman 1904).
    pub ranks: Vec<f64>,
    /// Fraction of the variance of y that the regression explains.
    pub explained: f64,
}

/// Fits finite values by columns of the same length. `None` if the values or a column are constant.
pub fn linear_fit(columns: &[Vec<f64>], values: &[f64]) -> Option<LinearFit> {
    let y = standardised(values)?;
    let x = columns.iter().map(|column| standardised(column)).collect::<Option<Vec<_>>>()?;
    let x = DMatrix::from_fn(y.len(), columns.len(), |row, column| x[column][row]);
    let coefficients = x.clone().svd(true, true).solve(&y, 1e-12).ok()?;
    let residual = &y - &x * &coefficients;
    let ranks_of_y = standardised(&ranks(values))?;
    let rank =
        |column: &Vec<f64>| standardised(&ranks(column)).map_or(f64::NAN, |ranks| ranks.dot(&ranks_of_y));
    Some(LinearFit {
        coefficients: coefficients.iter().copied().collect(),
        ranks: columns.iter().map(rank).collect(),
        explained: 1.0 - residual.norm_squared() / y.norm_squared(),
    })
}

/// Deviations from the mean, as a unit vector; `None` for equal values.
fn standardised(values: &[f64]) -> Option<DVector<f64>> {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let deviations = DVector::from_iterator(values.len(), values.iter().map(|x| x - mean));
    let norm = deviations.norm();
    let largest = values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    (norm > 1e-14 * largest).then(|| deviations / norm)
}

/// Ranks from 1, the mean rank for equal values.
fn ranks(values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|&a, &b| values[a].total_cmp(&values[b]));
    let mut ranks = vec![0.0; values.len()];
    let mut first = 0;
    for equal in order.chunk_by(|&a, &b| values[a] == values[b]) {
        let mean = first as f64 + 0.5 * (equal.len() as f64 + 1.0);
        equal.iter().for_each(|&k| ranks[k] = mean);
        first += equal.len();
    }
    ranks
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(name: &str, numbers: Vec<f64>) -> RecordedColumn {
        RecordedColumn { name: name.into(), numbers, ..RecordedColumn::default() }
    }

    /// y = 3 a − b of a full factorial design: a has 9/10 of the variance.
    #[test]
    fn a_linear_objective_is_explained() {
        let grid: Vec<(f64, f64)> =
            (0..5).flat_map(|i| (0..5).map(move |j| (f64::from(i), f64::from(j)))).collect();
        let a = column("a", grid.iter().map(|(a, _)| *a).collect());
        let b = column("b", grid.iter().map(|(_, b)| 1e6 * b).collect());
        let y = column("y", grid.iter().map(|(a, b)| 7.0 + 3.0 * a - b).collect());
        let found = sensitivity(&[&a, &b], &y).unwrap();
        let [of_a, of_b] = [0, 1].map(|k| found.parameters[k].regression);
        assert!((of_a.powi(2) - 0.9).abs() < 1e-12 && of_a > 0.0, "{of_a}");
        assert!((of_b.powi(2) - 0.1).abs() < 1e-12 && of_b < 0.0, "{of_b}");
        assert!((found.explained - 1.0).abs() < 1e-12);
    }

    /// A monotonic function of one parameter has the rank correlation 1; equal values have mean ranks.
    #[test]
    fn ranks_are_those_of_monotonic_functions() {
        let a = column("a", (0..8).map(f64::from).collect());
        let y = column("y", (0..8).map(|k| f64::from(k).powi(5)).collect());
        let found = sensitivity(&[&a], &y).unwrap();
        assert!((found.parameters[0].rank - 1.0).abs() < 1e-12 && found.explained < 0.9);
        assert_eq!(ranks(&[3.0, 1.0, 3.0, 2.0]), [3.5, 1.0, 3.5, 2.0]);
        assert_eq!(sensitivity(&[&a], &column("constant", vec![2.0; 8])), None);
    }
}
