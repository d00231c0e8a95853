use std::collections::{BTreeMap, BTreeSet};

use ancf::model::{Analysis, Step};
use ancf::scales::Dimension;

use crate::Recording;
use crate::thin::thinned;

/// Columns that are drawn in one chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// Its heading.
    pub title: String,
    /// Where it belongs.
    pub group: ChartGroup,
    /// Whether its ordinate is logarithmic; numbers that are not positive are then not shown.
    pub log: bool,
    /// Its lines.
    pub columns: Vec<Column>,
}

/// Where a chart belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ChartGroup {
    /// What probes record.
    Probes,
    /// Reactions of joints.
    Reactions,
    /// Angles and displacements of joints.
    Joints,
    /// Energies.
    Energy,
    /// What the analysis says of itself.
    Solver,
}

impl ChartGroup {
    /// Its word.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Probes => "probes",
            Self::Reactions => "reactions",
            Self::Joints => "joints",
            Self::Energy => "energy",
            Self::Solver => "solver",
        }
    }
}

/// One line of a chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name of the column, as in the results.
    pub name: String,
    /// What the legend calls it.
    pub label: String,
    /// Its unit.
    pub unit: String,
    /// Its numbers.
    pub values: Vec<f64>,
}

/// What all charts are drawn over.
#[derive(Clone, Debug, PartialEq)]
pub struct Abscissa {
    /// Name of the column: time, load factor, length of the path, number of the mode.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Its numbers, in ascending order.
    pub values: Vec<f64>,
}

/// All charts of a run over one abscissa.
#[derive(Clone, Debug, PartialEq)]
pub struct Charts {
    /// What they are drawn over.
    pub abscissa: Abscissa,
    /// The charts.
    pub charts: Vec<Chart>,
}

/// Columns of one dimension that belong together: their names behind the name of their owner, and how they are shown.
struct Kin(&'static [&'static str], ChartGroup, &'static str);

/// The dimensions of the columns of a run that have one.
type Dimensions = BTreeMap<String, Dimension>;

/// Columns of probes, joints and bodies.
const OWNED: &[Kin] = &[
    Kin(&["x", "y", "z"], ChartGroup::Probes, "position"),
    Kin(&["vx", "vy", "vz"], ChartGroup::Probes, "velocity"),
    Kin(&["ax", "ay", "az"], ChartGroup::Probes, "acceleration"),
    Kin(&["e0", "e1", "e2", "e3"], ChartGroup::Probes, "rotation"),
    Kin(&["wx", "wy", "wz"], ChartGroup::Probes, "angular velocity"),
    Kin(&["N", "Qy", "Qz"], ChartGroup::Probes, "section forces"),
    Kin(&["T", "My", "Mz"], ChartGroup::Probes, "section moments"),
    Kin(&["exx", "eyy", "ezz", "exy", "exz", "eyz"], ChartGroup::Probes, "strain"),
    Kin(&["sxx", "syy", "szz", "sxy", "sxz", "syz"], ChartGroup::Probes, "stress"),
    Kin(&["fx", "fy", "fz"], ChartGroup::Reactions, "force"),
    Kin(&["mx", "my", "mz"], ChartGroup::Reactions, "moment"),
    Kin(&["angle"], ChartGroup::Joints, "angle"),
    Kin(&["rate"], ChartGroup::Joints, "rate"),
    Kin(&["displacement"], ChartGroup::Joints, "displacement"),
    Kin(&["position"], ChartGroup::Joints, "position"),
    Kin(&["length"], ChartGroup::Joints, "length"),
    Kin(&["speed"], ChartGroup::Joints, "speed"),
    Kin(&["axial", "bending", "shear", "torsion", "section", "volume"], ChartGroup::Energy, "strain energy"),
];

/// Columns of the whole.
const WHOLE: &[Kin] = &[
    Kin(&["frequency"], ChartGroup::Solver, "frequency"),
    Kin(&["factor"], ChartGroup::Solver, "critical load factor"),
    Kin(&["load"], ChartGroup::Solver, "load factor"),
    Kin(&["kinetic", "strain", "potential", "work", "dissipated"], ChartGroup::Energy, "energy"),
    Kin(&["balance"], ChartGroup::Energy, "balance of energy"),
    Kin(&["iterations"], ChartGroup::Solver, "iterations"),
    Kin(&["unstable"], ChartGroup::Solver, "unstable directions"),
    Kin(&["slope"], ChartGroup::Solver, "slope of the path"),
    Kin(&["residual", "increment", "drift", "violation"], ChartGroup::Solver, "residual"),
];

/// Heading of the chart of residuals, which is logarithmic.
const RESIDUAL: &str = "residual";

impl Charts {
    /// All columns of a recording, of at most about `most` rows.
    pub fn new(recording: &Recording<'_>, most: usize) -> Self {
        let mut abscissa = abscissa(recording);
        let columns = recording.simulation.columns().into_iter();
        let dimensions = columns.filter_map(|column| Some((column.name, column.dimension?))).collect();
        let mut charts = owned(recording, &dimensions);
        charts.extend(WHOLE.iter().filter_map(|kin| whole(recording, &dimensions, kin, &abscissa.name)));
        charts.extend(steps(recording));
        charts.sort_by_key(|chart| chart.group);
        let all: Vec<&[f64]> =
            charts.iter().flat_map(|chart| chart.columns.iter().map(|c| c.values.as_slice())).collect();
        let rows = thinned(&all, abscissa.values.len(), most);
        let pick = |values: &[f64]| {
            rows.iter().map(|&row| values.get(row).copied().unwrap_or(f64::NAN)).collect::<Vec<_>>()
        };
        for chart in &mut charts {
            for column in &mut chart.columns {
                column.values = pick(&column.values);
                if chart.log {
                    column.values.iter_mut().filter(|x| **x <= 0.0).for_each(|x| *x = f64::NAN);
                }
            }
        }
        abscissa.values = pick(&abscissa.values);
        Self { abscissa, charts }
    }

    /// How many columns there are.
    pub(crate) fn columns(recording: &Recording<'_>) -> usize {
        recording.series.names().count() + 1
    }
}

/// Charts of probes, joints and bodies, in the order of their columns.
fn owned(recording: &Recording<'_>, dimensions: &Dimensions) -> Vec<Chart> {
    let mut seen = BTreeSet::new();
    let mut charts = Vec::new();
    for name in recording.series.names() {
        let Some((owner, suffix)) = name.rsplit_once('.') else { continue };
        let Some((number, kin)) = OWNED.iter().enumerate().find(|(_, kin)| kin.0.contains(&suffix)) else {
            continue;
        };
        let &Kin(_, group, title) = kin;
        // Rates are zero where nothing moves.
        let rates = dimensions.get(name).is_some_and(|dimension| dimension.time != 0);
        let still = rates && recording.model.analysis.dynamics().is_none();
        if still || !seen.insert((owner, number)) {
            continue;
        }
        let title = if recording.is_modal() { "displacement" } else { title };
        let column = |label: &&str| column(recording, dimensions, &format!("{owner}.{label}"), label);
        let columns = kin.0.iter().filter_map(column).collect();
        charts.push(Chart { title: format!("{owner}: {title}"), group, log: false, columns });
    }
    charts
}

fn whole(recording: &Recording<'_>, dimensions: &Dimensions, kin: &Kin, abscissa: &str) -> Option<Chart> {
    let &Kin(names, group, title) = kin;
    let names = names.iter().filter(|name| **name != abscissa);
    let columns: Vec<_> = names.filter_map(|name| column(recording, dimensions, name, name)).collect();
    let some = columns.iter().any(|column| column.values.iter().any(|x| x.is_finite()));
    some.then(|| Chart { title: title.to_owned(), group, log: title == RESIDUAL, columns })
}

fn column(recording: &Recording<'_>, dimensions: &Dimensions, name: &str, label: &str) -> Option<Column> {
    let values = recording.series.column(name)?.to_vec();
    let unit = dimensions.get(name).map(|dimension| recording.unit(*dimension)).unwrap_or_default();
    Some(Column { name: name.to_owned(), label: label.to_owned(), unit, values })
}

/// Time between rows: the steps, if each is recorded.
fn steps(recording: &Recording<'_>) -> Option<Chart> {
    let Analysis::Dynamics(settings) = &recording.model.analysis else { return None };
    let t = recording.series.column("t")?;
    let values = std::iter::once(f64::NAN).chain(t.windows(2).map(|pair| pair[1] - pair[0])).take(t.len());
    let output = &recording.model.output;
    let each = output.every == 1 && output.interval.is_none();
    let title = if each { "step" } else { "time between rows" };
    // A step of one size needs no chart.
    if each && matches!(settings.step, Step::Fixed(_)) {
        return None;
    }
    let (name, label) = ("dt".to_owned(), "Δt".to_owned());
    let column = Column { name, label, unit: recording.unit(Dimension::TIME), values: values.collect() };
    Some(Chart { title: title.to_owned(), group: ChartGroup::Solver, log: true, columns: vec![column] })
}

/// The first column; of a path, whose load may fall, its length; numbers of rows where neither ascends.
fn abscissa(recording: &Recording<'_>) -> Abscissa {
    let first = recording.series.columns().next();
    let length = recording.series.column("length").map(|values| ("length", values));
    let of_path = matches!(recording.model.analysis, Analysis::Path(_));
    let found = if of_path { length.or(first) } else { first };
    let rows = first.map_or(0, |(_, values)| values.len());
    match found {
        Some((name, values)) if values.is_sorted() && values.iter().all(|x| x.is_finite()) => {
            let unit = if name == "t" { recording.unit(Dimension::TIME) } else { String::new() };
            Abscissa { name: name.to_owned(), unit, values: values.to_vec() }
        }
        _ => Abscissa {
            name: "row".to_owned(),
            unit: String::new(),
            values: (0..rows).map(|row| row as f64).collect(),
        },
    }
}

/// Where frames are on the abscissa, by their values in the first column.
pub(crate) fn places_on(recording: &Recording<'_>, values: &[f64]) -> Option<Vec<f64>> {
    let (_, first) = recording.series.columns().next()?;
    let abscissa = abscissa(recording).values;
    let mut row = 0;
    let place = |value: &f64| {
        row += first.get(row..)?.iter().position(|x| x == value)?;
        abscissa.get(row).copied()
    };
    values.iter().map(place).collect()
}
