use nalgebra::Vector3;

use crate::analysis::StepReport;
use crate::model::Assembly;
use crate::scales::{Dimension, Scales};
use crate::system::{Energy, State};

/// The columns of a run, and their values at one instant, in the user's units.
///
/// | columns | what |
/// |---|---|
/// | `t` | time |
/// | `p.x p.y p.z`, `p.vx ..`, `p.ax ..` | position, velocity and acceleration of each probe `p` |
/// | `j.fx j.fy j.fz`, `j.mx ..` | force and moment that each joint `j` exerts on its end `a` |
/// | `iterations` | Newton iterations of the step |
/// | `residual`, `increment` | their last norms, in the numbers of the solver |
/// | `drift` | the largest violation of a joint by velocities, in the numbers of the solver |
/// | `kinetic`, `strain`, `potential` | energies; the potential is zero in the reference configuration |
/// | `dissipated` | energy that the scheme has taken out since the start |
#[derive(Debug)]
pub struct Rows {
    columns: Vec<String>,
    row: Vec<f64>,
    scales: Scales,
    /// Total energy at the first instant.
    initial: Option<f64>,
}

impl Rows {
    /// Columns of an assembly whose numbers are in the given units.
    pub fn new(assembly: &Assembly, scales: Scales) -> Self {
        let mut columns = vec!["t".to_owned()];
        let mut vectors = |name: &str, prefixes: &[&str]| {
            for prefix in prefixes {
                columns.extend(["x", "y", "z"].map(|axis| format!("{name}.{prefix}{axis}")));
            }
        };
        for (name, _) in &assembly.probes {
            vectors(name, &["", "v", "a"]);
        }
        for name in assembly.joints() {
            vectors(name, &["f", "m"]);
        }
        let own =
            ["iterations", "residual", "increment", "drift", "kinetic", "strain", "potential", "dissipated"];
        columns.extend(own.map(str::to_owned));
        Self { row: Vec::with_capacity(columns.len()), columns, scales, initial: None }
    }

    /// Names of the columns.
    pub fn columns(&self) -> &[String] {
        &self.columns
    }

    /// The row of one instant.
    pub fn fill(&mut self, assembly: &Assembly, s: &State, energy: Energy, report: &StepReport) -> &[f64] {
        self.row.clear();
        self.push(s.t, Dimension::TIME);
        for (_, point) in &assembly.probes {
            self.extend(point.value(s), Dimension::LENGTH);
            self.extend(point.sum(&s.v), Dimension::VELOCITY);
            self.extend(point.sum(&s.a), Dimension::ACCELERATION);
        }
        for reaction in assembly.reactions(s) {
            self.extend(reaction.force, Dimension::FORCE);
            self.extend(reaction.moment, Dimension::ENERGY);
        }
        self.push(f64::from(report.iterations), Dimension::NUMBER);
        self.push(report.residual, Dimension::NUMBER);
        self.push(report.increment, Dimension::NUMBER);
        self.push(report.drift, Dimension::NUMBER);
        self.push(energy.kinetic, Dimension::ENERGY);
        self.push(energy.strain, Dimension::ENERGY);
        self.push(energy.potential, Dimension::ENERGY);
        let initial = *self.initial.get_or_insert(energy.total());
        self.push(initial - energy.total(), Dimension::ENERGY);
        &self.row
    }

    fn push(&mut self, value: f64, of: Dimension) {
        self.row.push(value * self.scales.unit(of));
    }

    fn extend(&mut self, value: Vector3<f64>, of: Dimension) {
        let unit = self.scales.unit(of);
        self.row.extend(value.iter().map(|x| x * unit));
    }
}
