use std::collections::{BTreeMap, BTreeSet};

use ancf::Column;
use ancf::model::{Analysis, Step};
use ancf::units::Dimension;

use super::abscissa::Abscissa;
use super::chart::{Chart, ChartColumn};
use super::chart_groups::{ChartGroup, ColumnGroup, GLOBAL, OWNED, RESIDUAL};
use super::decimate::decimate;
use crate::run::Recording;

/// All charts of a run with their common abscissa.
#[derive(Clone, Debug, PartialEq)]
pub struct Charts {
    /// Abscissa.
    pub abscissa: Abscissa,
    /// Charts, ordered by group.
    pub charts: Vec<Chart>,
}

/// Columns of a run by name.
type RunColumns = BTreeMap<String, Column>;

impl Charts {
    /// Charts of all columns of a recording, with about `most` rows.
    pub fn new(recording: &Recording<'_>, most: usize) -> Self {
        let mut abscissa = Abscissa::of(recording);
        let columns = recording.simulation.columns().into_iter();
        let run: RunColumns = columns.map(|column| (column.name.clone(), column)).collect();
        let mut charts = owned(recording, &run);
        charts.extend(GLOBAL.iter().filter_map(|group| global(recording, &run, group, &abscissa.name)));
        charts.extend(steps(recording));
        charts.sort_by_key(|chart| chart.group);
        let all: Vec<&[f64]> =
            charts.iter().flat_map(|chart| chart.columns.iter().map(|c| c.values.as_slice())).collect();
        let rows = decimate(&all, abscissa.values.len(), most);
        let pick = |values: &[f64]| {
            rows.iter().map(|&row| values.get(row).copied().unwrap_or(f64::NAN)).collect::<Vec<_>>()
        };
        for chart in &mut charts {
            for column in &mut chart.columns {
                column.values = pick(&column.values);
                if !column.errors.is_empty() {
                    column.errors = pick(&column.errors);
                }
                if chart.log {
                    column.values.iter_mut().filter(|x| **x <= 0.0).for_each(|x| *x = f64::NAN);
                }
            }
        }
        abscissa.values = pick(&abscissa.values);
        Self { abscissa, charts }
    }

    /// Maximum number of columns, the abscissa included.
    pub(crate) fn columns(recording: &Recording<'_>) -> usize {
        recording.series.names().count() + 1
    }
}

/// Charts of probes, joints and bodies, in the order of their columns.
fn owned(recording: &Recording<'_>, run: &RunColumns) -> Vec<Chart> {
    let mut seen = BTreeSet::new();
    let mut charts = Vec::new();
    for name in recording.series.names() {
        let Some((owner, suffix)) = name.rsplit_once('.') else { continue };
        let Some((number, found)) =
            OWNED.iter().enumerate().find(|(_, columns)| columns.names.contains(&suffix))
        else {
            continue;
        };
        let &ColumnGroup { names, group, title } = found;
        // Rates are zero unless the analysis is dynamic.
        let rates =
            run.get(name).and_then(|column| column.dimension).is_some_and(|dimension| dimension.time != 0);
        let still = rates && recording.model.analysis.dynamics().is_none();
        if still || !seen.insert((owner, number)) {
            continue;
        }
        let title = if recording.is_modal() { "displacement" } else { title };
        let column = |label: &&str| column(recording, run, &format!("{owner}.{label}"), label);
        let columns = names.iter().filter_map(column).collect();
        charts.push(Chart { title: format!("{owner}: {title}"), group, log: false, columns });
    }
    charts
}

/// Chart of columns without an owner; `None` if they have no finite values.
fn global(
    recording: &Recording<'_>,
    run: &RunColumns,
    columns: &ColumnGroup,
    abscissa: &str,
) -> Option<Chart> {
    let &ColumnGroup { names, group, title } = columns;
    let names = names.iter().filter(|name| **name != abscissa);
    let columns: Vec<_> = names.filter_map(|name| column(recording, run, name, name)).collect();
    let has_values = columns.iter().any(|column| column.values.iter().any(|x| x.is_finite()));
    has_values.then(|| Chart { title: title.to_owned(), group, log: title == RESIDUAL, columns })
}

fn column(recording: &Recording<'_>, run: &RunColumns, name: &str, label: &str) -> Option<ChartColumn> {
    let values = recording.series.column(name)?.to_vec();
    let unit = recording.model.units.as_ref().and_then(|units| run.get(name)?.unit(units));
    let unit = unit.filter(|unit| unit != "1").unwrap_or_default();
    let errors = recording.series.column(&format!("{name}_error")).map(<[f64]>::to_vec).unwrap_or_default();
    Some(ChartColumn { name: name.to_owned(), label: label.to_owned(), unit, values, errors })
}

/// Chart of the time between rows, which is the step size if each step has a row. A fixed step has no chart.
fn steps(recording: &Recording<'_>) -> Option<Chart> {
    let Analysis::Dynamics(settings) = &recording.model.analysis else { return None };
    let t = recording.series.column("t")?;
    let values = std::iter::once(f64::NAN).chain(t.windows(2).map(|pair| pair[1] - pair[0])).take(t.len());
    let output = &recording.model.output;
    let each = output.every == 1 && output.interval.is_none();
    let title = if each { "step" } else { "time between rows" };
    if each && matches!(settings.step, Step::Fixed(_)) {
        return None;
    }
    let (name, label) = ("dt".to_owned(), "Δt".to_owned());
    let (unit, values) = (recording.unit(Dimension::TIME), values.collect());
    let column = ChartColumn { name, label, unit, values, errors: Vec::new() };
    Some(Chart { title: title.to_owned(), group: ChartGroup::Solver, log: true, columns: vec![column] })
}
