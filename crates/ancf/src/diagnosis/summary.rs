use std::collections::BTreeMap;
use std::fmt;

use ancf_solver::dynamics::consistent_velocities;
use ancf_solver::equations::{EquationsOfMotion, State};
use serde::Serialize;

use super::connections::Connections;
use super::free_motion::{FreeMotion, MAX_LISTED, number};
use super::warnings::model_warnings;
use crate::assembly::{Assembly, Redundant};
use crate::errors::ModelErrors;
use crate::joints::Joint;
use crate::model::{Body, Model, Origin};
use crate::reading::ValidModel;

/// Contents of a model, constraints of its joints, and free motions. Lengths in the user's units.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Diagnosis {
    /// Bodies by kind.
    pub bodies: BTreeMap<&'static str, usize>,
    /// Joints by kind.
    pub joints: BTreeMap<&'static str, usize>,
    /// Loads by kind, gravity and contacts among them.
    pub loads: BTreeMap<&'static str, usize>,
    /// Number of coordinates n.
    pub coordinates: usize,
    /// Number of constraint equations m.
    pub equations: usize,
    /// Redundant joint equations.
    pub redundant: Vec<Redundant>,
    /// Degrees of freedom of the deformable bodies: n minus the rank of the constraints.
    pub freedoms: usize,
    /// Mobility by the criterion of Grübler and Kutzbach: 6 per body, as a rigid body, and 3 per point mass, minus the degrees of
    /// freedom that joints remove.
    pub gruebler: isize,
    /// Descriptions of the free motions of rigid bodies. Their number is the mobility by rank. `None` in models too large to
    /// determine them.
    pub motions: Option<Vec<String>>,
    /// Bodies without joints.
    pub unconnected: Vec<String>,
    /// Bodies with joints, but without a chain of joints to the ground.
    pub unreached: Vec<String>,
    /// Joints with closed gaps, and the initial distances of their ends.
    pub gaps: Vec<(String, f64)>,
    /// Bodies that were moved to close gaps, and their displacements.
    pub moved: Vec<(String, f64)>,
    /// Kinetic energy of the change from the stated initial velocities to those that satisfy the constraints, relative to the
    /// kinetic energy of the stated velocities. `None` without initial velocities.
    pub projection: Option<f64>,
    /// Start of a motion that does not start from the undeformed state.
    pub start: Option<String>,
    /// Warnings of redundant constraints, corrected velocities, locking, numbers in mixed units, bodies that fall, and so on.
    pub warnings: Vec<String>,
}

/// Tolerance of the relative change of initial velocities.
const PROJECTION_TOLERANCE: f64 = 1e-12;

impl Model {
    /// Assembles the model and reports its contents, the constraints of its joints and its free motions.
    ///
    /// # Errors
    /// If the model is not valid, or its gaps cannot be closed.
    pub fn diagnose(&self) -> Result<Diagnosis, ModelErrors> {
        self.check()?;
        self.diagnosis()
    }

    /// Diagnosis of a valid model.
    fn diagnosis(&self) -> Result<Diagnosis, ModelErrors> {
        let scales = self.scales().scales;
        let model = self.scaled(&scales);
        let dynamic = model.analysis.dynamics().is_some();
        let assembly = model.assemble_scaled()?;
        let system = &assembly.system;
        let load = if dynamic { 1.0 } else { 0.0 };
        let motions = assembly.free_motions(&State { load, ..assembly.rest() });
        let text = |motion: FreeMotion| motion.scaled(scales.length).to_string();
        let connections = Connections::new(self);
        // Other starts are computed by the run, which reports their projection.
        let projection =
            if self.starts_undeformed() { assembly.projection(&assembly.start(&model)) } else { None };
        let start = dynamic.then(|| start_text(&self.initial.from)).flatten();
        let mut warnings: Vec<String> = assembly.redundant().iter().map(redundant_warning).collect();
        warnings.extend(assembly.undetermined_friction());
        warnings.extend(projection.and_then(projection_warning));
        warnings.extend(model_warnings(self));
        let lengths = |of: &[(String, f64)]| {
            of.iter().map(|(name, x)| (name.clone(), x * scales.length)).collect::<Vec<_>>()
        };
        let closed = assembly.closed();
        Ok(Diagnosis {
            bodies: count(self.bodies.iter().map(noun)),
            joints: count(self.joints.iter().map(|joint| joint.kind().noun())),
            loads: self.count_loads(),
            coordinates: system.coordinates(),
            equations: system.multipliers(),
            redundant: assembly.redundant().to_vec(),
            freedoms: (system.coordinates() + assembly.rank_deficiency())
                .saturating_sub(system.multipliers()),
            gruebler: self.gruebler(),
            motions: motions.map(|motions| motions.into_iter().map(text).collect()),
            unconnected: connections.unconnected(),
            unreached: connections.unreached(),
            gaps: closed.map(|closed| lengths(&closed.gaps)).unwrap_or_default(),
            moved: closed.map(|closed| lengths(&closed.moved)).unwrap_or_default(),
            projection,
            start,
            warnings,
        })
    }

    fn count_loads(&self) -> BTreeMap<&'static str, usize> {
        let loads = self.loads.iter().map(|load| load.kind().noun());
        let gravity = (self.gravity != [0.0; 3]).then_some("gravity");
        count(loads.chain(gravity).chain(self.contacts.iter().map(|_| "contact")))
    }

    /// 6 per body, including cables, and 3 per point mass, minus the degrees of freedom that joints remove and 1 per coupling.
    fn gruebler(&self) -> isize {
        let constrained = self.joints.iter().map(removed).sum::<usize>() + self.couplings.len();
        let free = self.bodies.iter().map(|body| if matches!(body, Body::Mass(_)) { 3 } else { 6 });
        free.sum::<isize>() - constrained as isize
    }
}

impl ValidModel {
    /// Assembles the model and reports its contents, as [`Model::diagnose`].
    ///
    /// # Errors
    /// If gaps of the model cannot be closed.
    pub fn diagnose(&self) -> Result<Diagnosis, ModelErrors> {
        self.diagnosis()
    }
}

impl Assembly {
    /// T(v' − v) / T(v) of the velocities v of a state and of the nearest velocities v' that satisfy the constraints.
    pub(crate) fn projection(&self, start: &State) -> Option<f64> {
        let kinetic = |v: Vec<f64>| self.system.energy(&State { v, ..start.clone() }).kinetic;
        let stated = kinetic(start.v.clone());
        let mut projected = start.clone();
        consistent_velocities(&self.system, &mut self.system.matrix(), &mut projected).ok()?;
        let change = projected.v.iter().zip(&start.v).map(|(after, before)| after - before).collect();
        (stated > 0.0).then(|| kinetic(change) / stated)
    }
}

/// Noun of the kind of a body.
const fn noun(body: &Body) -> &'static str {
    match body {
        Body::Beam(_) => "beam",
        Body::Cable(_) => "cable",
        Body::Shell(_) => "shell",
        Body::ShearShell(_) => "shear-deformable shell",
        Body::Rigid(_) => "rigid body",
        Body::Mass(_) => "point mass",
    }
}

/// Degrees of freedom that a joint removes between two rigid bodies, including driven ones.
fn removed(joint: &Joint) -> usize {
    joint.kind().removes() + joint.times().iter().filter(|(key, _)| !key.is_empty()).count()
}

fn count(kinds: impl Iterator<Item = &'static str>) -> BTreeMap<&'static str, usize> {
    let mut counts = BTreeMap::new();
    kinds.for_each(|kind| *counts.entry(kind).or_default() += 1);
    counts
}

/// "2 beams, 1 cable".
fn counted(counts: &BTreeMap<&'static str, usize>) -> String {
    let one = |(kind, count): (&&str, &usize)| match (*kind, *count) {
        ("gravity", _) => "gravity".to_owned(),
        (kind, 1) => format!("1 {kind}"),
        (kind, count) => format!("{count} {}", plural(kind)),
    };
    let all: Vec<String> = counts.iter().map(one).collect();
    if all.is_empty() { "none".to_owned() } else { all.join(", ") }
}

fn plural(kind: &str) -> String {
    match kind {
        "rigid body" => "rigid bodies".into(),
        "gas" => "gases".into(),
        "point mass" => "point masses".into(),
        "force per length" => "forces per length".into(),
        "moment per length" => "moments per length".into(),
        "point on a line" => "points on lines".into(),
        kind => format!("{kind}s"),
    }
}

fn quoted(names: &[String]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// Start of a motion from another state than the undeformed one.
fn start_text(from: &Origin) -> Option<String> {
    match from {
        Origin::Undeformed => None,
        Origin::Folder(folder) => Some(format!("state of the results folder `{folder}`")),
        Origin::Equilibrium => {
            Some("equilibrium under the loads and drives at t = 0, computed by the run".to_owned())
        }
    }
}

fn redundant_warning(one: &Redundant) -> String {
    format!("redundant: {one}; they share the constraint force")
}

/// Warning of initial velocities that violate constraints, by the relative kinetic energy of their correction.
pub(crate) fn projection_warning(change: f64) -> Option<String> {
    (change > PROJECTION_TOLERANCE).then(|| {
        let percent = number(100.0 * change);
        format!(
            "initial velocities violate constraints of joints: their correction has {percent} % of the kinetic energy"
        )
    })
}

impl Diagnosis {
    /// Mobility as text, with the meaning of each number.
    fn mobility(&self) -> String {
        let Self { gruebler, motions, freedoms, .. } = self;
        let rank = motions.as_ref().map(Vec::len);
        let difference = rank.map_or(0, |rank| rank as isize - gruebler);
        let redundant = match difference {
            1 => "; 1 constraint is redundant for rigid bodies".to_owned(),
            2.. => format!("; {difference} constraints are redundant for rigid bodies"),
            _ => String::new(),
        };
        let free = match rank {
            Some(1) => "1 free motion".to_owned(),
            Some(rank) => format!("{rank} free motions"),
            None => "unknown number of free motions".to_owned(),
        };
        format!(
            "mobility:  {gruebler} by Grübler's formula for rigid bodies, which counts every joint\n           \
             {free} of the bodies if they are rigid, by the rank of the constraints{redundant}\n           \
             {freedoms} degrees of freedom with the deformation of the bodies\n"
        )
    }
}

impl fmt::Display for Diagnosis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "bodies:    {}", counted(&self.bodies))?;
        writeln!(f, "joints:    {}", counted(&self.joints))?;
        writeln!(f, "loads:     {}", counted(&self.loads))?;
        let Self { coordinates, equations, .. } = self;
        let redundant = self.redundant.len();
        writeln!(
            f,
            "equations: {coordinates} coordinates, {equations} constraints, {redundant} of them redundant"
        )?;
        write!(f, "{}", self.mobility())?;
        let motions = self.motions.as_deref().unwrap_or_default();
        for motion in motions.iter().take(MAX_LISTED) {
            writeln!(f, "free:      {motion}")?;
        }
        if motions.len() > MAX_LISTED {
            writeln!(
                f,
                "           and {} more free motions, in `ancf check --json`",
                motions.len() - MAX_LISTED
            )?;
        }
        if !self.unconnected.is_empty() {
            writeln!(f, "no joints: {}", quoted(&self.unconnected))?;
        }
        if !self.unreached.is_empty() {
            writeln!(f, "no ground: {}, not connected to the ground by joints", quoted(&self.unreached))?;
        }
        for (joint, apart) in &self.gaps {
            writeln!(f, "closed:    gap of joint `{joint}`, {}", number(*apart))?;
        }
        for (body, by) in &self.moved {
            writeln!(f, "moved:     body `{body}`, by up to {}", number(*by))?;
        }
        if let Some(start) = &self.start {
            writeln!(f, "start:     {start}")?;
        }
        self.warnings.iter().try_for_each(|warning| writeln!(f, "warning:   {warning}"))
    }
}
