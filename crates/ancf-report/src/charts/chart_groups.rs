/// Group of charts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ChartGroup {
    /// Quantities of probes.
    Probes,
    /// Reactions of joints.
    Reactions,
    /// Angles and displacements of joints.
    Joints,
    /// Energies.
    Energy,
    /// Quantities of the solver.
    Solver,
}

impl ChartGroup {
    /// Word in the scene.
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

/// Columns of one dimension that share a chart.
pub(super) struct ColumnGroup {
    /// Names; behind the name of the owner if the columns have one.
    pub names: &'static [&'static str],
    pub group: ChartGroup,
    pub title: &'static str,
}

const fn chart(names: &'static [&'static str], group: ChartGroup, title: &'static str) -> ColumnGroup {
    ColumnGroup { names, group, title }
}

/// Columns of probes, joints and bodies.
pub(super) const OWNED: &[ColumnGroup] = &[
    chart(&["x", "y", "z"], ChartGroup::Probes, "position"),
    chart(&["vx", "vy", "vz"], ChartGroup::Probes, "velocity"),
    chart(&["ax", "ay", "az"], ChartGroup::Probes, "acceleration"),
    chart(&["e0", "e1", "e2", "e3"], ChartGroup::Probes, "rotation"),
    chart(&["wx", "wy", "wz"], ChartGroup::Probes, "angular velocity"),
    chart(&["N", "Qy", "Qz"], ChartGroup::Probes, "section forces"),
    chart(&["T", "My", "Mz"], ChartGroup::Probes, "section moments"),
    chart(&["exx", "eyy", "ezz", "exy", "exz", "eyz"], ChartGroup::Probes, "strain"),
    chart(&["sxx", "syy", "szz", "sxy", "sxz", "syz"], ChartGroup::Probes, "stress"),
    chart(&["fx", "fy", "fz"], ChartGroup::Reactions, "force"),
    chart(&["mx", "my", "mz"], ChartGroup::Reactions, "moment"),
    chart(&["angle"], ChartGroup::Joints, "angle"),
    chart(&["rate"], ChartGroup::Joints, "rate"),
    chart(&["displacement"], ChartGroup::Joints, "displacement"),
    chart(&["position"], ChartGroup::Joints, "position"),
    chart(&["length"], ChartGroup::Joints, "length"),
    chart(&["speed"], ChartGroup::Joints, "speed"),
    chart(
        &["axial", "bending", "shear", "torsion", "section", "volume"],
        ChartGroup::Energy,
        "strain energy",
    ),
];

/// Columns of the whole model.
pub(super) const GLOBAL: &[ColumnGroup] = &[
    chart(&["frequency"], ChartGroup::Solver, "frequency"),
    chart(&["factor"], ChartGroup::Solver, "critical load factor"),
    chart(&["load"], ChartGroup::Solver, "load factor"),
    chart(&["kinetic", "strain", "potential", "work", "dissipated"], ChartGroup::Energy, "energy"),
    chart(&["balance"], ChartGroup::Energy, "energy balance"),
    chart(&["iterations"], ChartGroup::Solver, "iterations"),
    chart(&["unstable"], ChartGroup::Solver, "unstable directions"),
    chart(&["slope"], ChartGroup::Solver, "slope of the path"),
    chart(&["residual", "increment", "drift", "violation"], ChartGroup::Solver, RESIDUAL),
];

/// Title of the chart of residuals, which is logarithmic.
pub(super) const RESIDUAL: &str = "residual";
