use super::chart_groups::ChartGroup;

/// Columns that are drawn in one chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// Title.
    pub title: String,
    /// Group.
    pub group: ChartGroup,
    /// True if the ordinate is logarithmic. Numbers that are not positive are then omitted.
    pub log: bool,
    /// Curves.
    pub columns: Vec<ChartColumn>,
}

/// Curve of a chart.
#[derive(Clone, Debug, PartialEq)]
pub struct ChartColumn {
    /// Name of the column in the results.
    pub name: String,
    /// Label in the legend.
    pub label: String,
    /// Unit.
    pub unit: String,
    /// Values.
    pub values: Vec<f64>,
    /// Estimated errors of the values; empty if they were not estimated.
    pub errors: Vec<f64>,
}
