use super::options::Fmi;
use super::units::Unit;
use super::xml::Element;
use crate::interface::{Interface, Variable};

/// Name of the shared library in FMUs.
pub(super) const IDENTIFIER: &str = "ancf";

/// Contents of a model description.
#[derive(Debug)]
pub(super) struct Description<'a> {
    pub(super) name: &'a str,
    pub(super) title: Option<&'a str>,
    pub(super) interface: &'a Interface,
    /// Unit of time.
    pub(super) time: Option<Unit>,
    /// Units and meanings of the outputs.
    pub(super) outputs: Vec<(Option<Unit>, String)>,
    pub(super) duration: f64,
    pub(super) step: Option<f64>,
    /// True if the inputs are inputs of loads.
    pub(super) has_derivatives: bool,
}

impl Description<'_> {
    /// Text of `modelDescription.xml`.
    pub(super) fn document(&self, version: Fmi) -> std::io::Result<Vec<u8>> {
        let (number, token) = match version {
            Fmi::Two => ("2.0", "guid"),
            Fmi::Three => ("3.0", "instantiationToken"),
        };
        let root = Element::new("fmiModelDescription")
            .with("fmiVersion", number)
            .with("modelName", self.name)
            .with(token, &self.interface.token)
            .with_some("description", self.title)
            .with("generationTool", concat!("ancf ", env!("CARGO_PKG_VERSION")))
            .with("variableNamingConvention", "flat");
        let experiment = Element::new("DefaultExperiment")
            .with("startTime", 0)
            .with("stopTime", self.duration)
            .with_some("stepSize", self.step);
        root.containing([self.co_simulation(version)])
            .containing(self.units())
            .containing([categories(), experiment, self.variables(version), self.structure(version)])
            .document()
    }

    fn co_simulation(&self, version: Fmi) -> Element {
        let element = Element::new("CoSimulation")
            .with("modelIdentifier", IDENTIFIER)
            .with("canHandleVariableCommunicationStepSize", true);
        match version {
            Fmi::Two => element
                .with("canInterpolateInputs", false)
                .with("canNotUseMemoryManagementFunctions", true)
                .with("canGetAndSetFMUstate", true)
                .with("canSerializeFMUstate", true)
                .with("providesDirectionalDerivative", self.has_derivatives),
            Fmi::Three => element
                .with("canGetAndSetFMUState", true)
                .with("canSerializeFMUState", true)
                .with("providesDirectionalDerivatives", self.has_derivatives)
                .with("mightReturnEarlyFromDoStep", true),
        }
    }

    /// Definitions of the units, each once.
    fn units(&self) -> Option<Element> {
        let mut known: Vec<&Unit> = Vec::new();
        for unit in self.outputs.iter().filter_map(|(unit, _)| unit.as_ref()).chain(&self.time) {
            if !known.iter().any(|other| other.name == unit.name) {
                known.push(unit);
            }
        }
        let element = |unit: &&Unit| {
            let base = unit.base.map(|base| {
                let powers = base.powers.into_iter().filter(|(_, power)| *power != 0);
                let element = Element::new("BaseUnit");
                powers.fold(element, |one, (key, power)| one.with(key, power)).with("factor", base.factor)
            });
            Element::new("Unit").with("name", &unit.name).containing(base)
        };
        (!known.is_empty()).then(|| Element::new("UnitDefinitions").containing(known.iter().map(element)))
    }

    fn variables(&self, version: Fmi) -> Element {
        let interface = self.interface;
        let variables = interface.variables().zip(0..).map(|(variable, reference)| {
            let (name, own) = (interface.name(variable), self.attributes(variable));
            let start = own.start.map(exact);
            match version {
                Fmi::Two => {
                    let real = Element::new("Real").with_some("unit", own.unit).with_some("start", start);
                    Element::new("ScalarVariable")
                        .with("name", name)
                        .with("valueReference", reference)
                        .with_some("description", own.meaning)
                        .with("causality", own.causality)
                        .with("variability", own.variability)
                        .with_some("initial", own.initial)
                        .containing([real])
                }
                Fmi::Three => Element::new("Float64")
                    .with("name", name)
                    .with("valueReference", reference)
                    .with_some("description", own.meaning)
                    .with("causality", own.causality)
                    .with("variability", own.variability)
                    .with_some("initial", own.initial)
                    .with_some("unit", own.unit)
                    .with_some("start", start),
            }
        });
        Element::new("ModelVariables").containing(variables)
    }

    fn attributes(&self, variable: Variable) -> Attributes<'_> {
        let of = |causality, variability, initial| Attributes {
            causality,
            variability,
            initial,
            unit: None,
            start: None,
            meaning: None,
        };
        match variable {
            Variable::Time => Attributes {
                unit: self.time.as_ref().map(|unit| unit.name.as_str()),
                meaning: Some("Time"),
                ..of("independent", "continuous", None)
            },
            Variable::Input(i) => Attributes {
                start: Some(self.interface.inputs[i].start),
                meaning: Some("Input, constant until it is set again"),
                ..of("input", "continuous", None)
            },
            Variable::Parameter(i) => Attributes {
                start: Some(self.interface.parameters[i].start),
                meaning: Some("Key of the model, in the units of the model"),
                ..of("parameter", "fixed", Some("exact"))
            },
            Variable::Output(i) => Attributes {
                unit: self.outputs[i].0.as_ref().map(|unit| unit.name.as_str()),
                meaning: Some(&self.outputs[i].1),
                ..of("output", "continuous", Some("calculated"))
            },
        }
    }

    /// Outputs. Without stated dependencies, each may depend on all inputs.
    fn structure(&self, version: Fmi) -> Element {
        let outputs = self.interface.variables().zip(0..);
        let outputs = outputs.filter(|(variable, _)| matches!(variable, Variable::Output(_)));
        let outputs: Vec<u32> = outputs.map(|(_, reference)| reference).collect();
        let structure = Element::new("ModelStructure");
        match version {
            Fmi::Two => {
                let list = |name: &'static str| {
                    let unknown = |reference: &u32| Element::new("Unknown").with("index", reference + 1);
                    Element::new(name).containing(outputs.iter().map(unknown))
                };
                structure.containing([list("Outputs"), list("InitialUnknowns")])
            }
            Fmi::Three => {
                let list = |name: &'static str| {
                    outputs.iter().map(move |reference| Element::new(name).with("valueReference", reference))
                };
                structure.containing(list("Output")).containing(list("InitialUnknown"))
            }
        }
    }
}

/// Attributes of a variable.
#[derive(Debug)]
struct Attributes<'a> {
    causality: &'static str,
    variability: &'static str,
    initial: Option<&'static str>,
    unit: Option<&'a str>,
    start: Option<f64>,
    meaning: Option<&'a str>,
}

/// Shortest text from which the number is read again.
fn exact(number: f64) -> String {
    format!("{number:?}")
}

fn categories() -> Element {
    let category = |name: &str, description: &str| {
        Element::new("Category").with("name", name).with("description", description)
    };
    Element::new("LogCategories").containing([
        category("logStatusWarning", "Warnings of the model and of its steps"),
        category("logStatusDiscard", "Steps that failed"),
        category("logStatusError", "Calls that are not valid"),
    ])
}
