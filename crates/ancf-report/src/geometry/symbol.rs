use ancf::mechanics::kinematics::{Attachment, BodyVector};
use ancf::model::{Load, Probe, Quantity};
use ancf::solver::equations::State;
use ancf::{Model, Simulation};

use super::attachments::Attachments;

/// Symbol at the point of a joint, a probe or a load.
#[derive(Clone, Debug)]
pub struct Symbol {
    /// Name of the joint, probe or external force; of other loads, their path in the model.
    pub name: String,
    /// Kind of object.
    pub kind: SymbolKind,
    /// Kind of the joint, quantities that the probe records, or kind of the load.
    pub detail: String,
    point: BodyVector,
    length: f64,
}

/// Kind of object that a symbol stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SymbolKind {
    /// Joint, at its end `a`.
    Joint,
    /// Probe.
    Probe,
    /// Force or moment.
    Load,
}

impl SymbolKind {
    /// Word in the scene.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Joint => "joint",
            Self::Probe => "probe",
            Self::Load => "load",
        }
    }
}

/// Symbols of a model.
#[derive(Clone, Debug, Default)]
pub struct Symbols {
    /// Symbols of joints, probes and loads, in this order.
    pub all: Vec<Symbol>,
    /// Index of the symbol of each joint, in the order of the model.
    pub of_joints: Vec<Option<usize>>,
}

/// Returns the symbols of a model that is stated in the user's units.
pub fn symbols(model: &Model, simulation: &Simulation) -> Symbols {
    Symbols::new(Attachments::new(&model.scaled(&simulation.scales()), simulation))
}

impl Symbol {
    fn new(name: String, kind: SymbolKind, detail: String, at: Attachment, length: f64) -> Self {
        Self { name, kind, detail, point: at.point, length }
    }

    /// Position in a state, in the user's units.
    pub fn position(&self, state: &State) -> [f64; 3] {
        (self.point.value(state) * self.length).into()
    }

    /// Position in the undeformed state, in the user's units.
    pub fn reference(&self) -> [f64; 3] {
        (self.point.reference() * self.length).into()
    }
}

impl Symbols {
    pub(crate) fn new(attachments: Attachments<'_>) -> Self {
        let (model, length) = (attachments.model, attachments.length);
        let mut symbols = Self::default();
        for joint in &model.joints {
            let at = attachments.of(joint.ends().0);
            symbols.of_joints.push(at.is_some().then_some(symbols.all.len()));
            let (name, detail) = (joint.name().to_owned(), joint.kind().word().to_owned());
            symbols.all.extend(at.map(|at| Symbol::new(name, SymbolKind::Joint, detail, at, length)));
        }
        for probe in &model.probes {
            let (name, detail) = (probe.name.clone(), recorded(probe));
            let at = attachment_of_probe(attachments, probe);
            symbols.all.extend(at.map(|at| Symbol::new(name, SymbolKind::Probe, detail, at, length)));
        }
        for (number, load) in model.loads.iter().enumerate() {
            let at = load.on().and_then(|place| attachments.of(place));
            let (name, detail) = name_and_kind_of_load(number, load);
            symbols.all.extend(at.map(|at| Symbol::new(name, SymbolKind::Load, detail, at, length)));
        }
        symbols
    }
}

/// Attachment of a probe as assembled, or of its place if it has no columns.
fn attachment_of_probe(attachments: Attachments<'_>, probe: &Probe) -> Option<Attachment> {
    // All quantities of a probe are recorded at the same place.
    let measure = attachments.assembly.recorded_quantities.iter().find(|measure| measure.name == probe.name);
    measure.map(|measure| measure.place.clone()).or_else(|| attachments.of(&probe.on))
}

fn recorded(probe: &Probe) -> String {
    let words = probe.record.iter().map(|quantity| match quantity {
        Quantity::Motion => "motion",
        Quantity::Rotation => "rotation",
        Quantity::InertialSensor => "inertial sensor",
        Quantity::SectionForces => "section forces",
        Quantity::Strain => "strain",
        Quantity::Stress => "stress",
        Quantity::Resultants => "resultants",
        Quantity::SurfaceStress => "surface stress",
    });
    words.collect::<Vec<_>>().join(", ")
}

fn name_and_kind_of_load(number: usize, load: &Load) -> (String, String) {
    let name = load.kind().name().map_or_else(|| format!("loads[{number}]"), str::to_owned);
    (name, load.kind().label().to_owned())
}
