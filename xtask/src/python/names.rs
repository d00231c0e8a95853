//! Names of the Python modules and classes, and the exceptions to the naming rule.

/// A generated module of the package `ancf.model`.
pub(super) struct Module {
    /// Path below `ancf.model`, with dots.
    pub(super) path: &'static str,
    /// Docstring.
    pub(super) summary: &'static str,
    /// Definitions of the schema from which the contents are reached.
    pub(super) roots: &'static [&'static str],
}

const fn module(path: &'static str, summary: &'static str, roots: &'static [&'static str]) -> Module {
    Module { path, summary, roots }
}

/// Generated modules. A definition that several modules need belongs to the first of them.
pub(super) const MODULES: [Module; 12] = [
    module("base.places", "Places on bodies.", &["End"]),
    module("base.functions", "Functions of time.", &["TimeFunction"]),
    module("sections", "Cross-sections and materials.", &["Material", "Section"]),
    module("bodies", "Flexible and rigid bodies.", &["Body"]),
    module("drives", "Drives, springs, friction and couplings of joints.", &DRIVES),
    module("connectors", "Joints between two points: rods, springs and bushings.", &[]),
    module("joints", "Joints.", &["Joint"]),
    module("loads", "Loads in addition to gravity, and inputs.", &["Load", "Input"]),
    module("contacts", "Contact between bodies and with obstacles.", &["Contact"]),
    module("analyses", "Analyses and their solver settings.", &["Analysis", "Initial"]),
    module("output", "Probes and output.", &["Probe", "Output"]),
    module("whole", "The whole model.", &["Model"]),
];

/// Modules of single forms that are not in the module of their definition: definition, word, module.
const FORM_MODULES: [(&str, &str, &str); 3] = [
    ("Joint", "bushing", "connectors"),
    ("Joint", "distance", "connectors"),
    ("Joint", "spring", "connectors"),
];

/// The module of a form, if it is not the module of its definition.
pub(super) fn form_module(definition: &str, word: &str) -> Option<&'static str> {
    FORM_MODULES.iter().find(|(of, form, _)| *of == definition && *form == word).map(|(.., module)| *module)
}

const DRIVES: [&str; 10] = [
    "AngularDrive",
    "AngularSpring",
    "AngularFriction",
    "LinearDrive",
    "LinearSpring",
    "LinearFriction",
    "AngularStops",
    "LinearStops",
    "JointLaw",
    "Coupling",
];

/// Names of classes that differ from the word of their form: definition, word or first required key, name.
const CLASSES: [(&str, &str, &str); 40] = [
    ("Analysis", "path", "EquilibriumPath"),
    ("AngleField", "expression", "AngleFormula"),
    ("AxisField", "expression", "AxisFormula"),
    ("Body", "mass", "PointMass"),
    ("Body", "rigid", "RigidBody"),
    ("ContactSurface", "bodies", "MutualContact"),
    ("DisplayShape", "box", "DisplayBox"),
    ("DisplayShape", "cylinder", "DisplayCylinder"),
    ("DisplayShape", "mesh", "DisplayMesh"),
    ("DisplayShape", "sphere", "DisplaySphere"),
    ("Joint", "drive", "PrescribedMotion"),
    ("Joint", "slide", "SlidingJoint"),
    ("JointLaw", "expression", "ForceExpression"),
    ("JointLaw", "external", "ExternalForceLaw"),
    ("Load", "external", "ExternalForce"),
    ("Load", "fluid", "FluidLoad"),
    ("ScaleChoice", "auto", "AutoScales"),
    ("ScaleChoice", "given", "GivenScales"),
    ("ScaleChoice", "none", "NoScales"),
    ("ScaleChoice", "paper", "PaperScales"),
    ("Scheme", "alpha", "HHT"),
    ("Scheme", "gamma", "Newmark"),
    ("Scheme", "spectral_radius", "GeneralizedAlpha"),
    ("Section", "general", "GeneralSection"),
    ("ShellSurface", "flat", "FlatSurface"),
    ("ShellSurface", "lofted", "LoftedSurface"),
    ("ShellSurface", "revolved", "RevolvedSurface"),
    ("ShellSurface", "sphere", "SphericalSurface"),
    ("ShellSurface", "swept", "SweptSurface"),
    ("ShellSurface", "twisted", "TwistedSurface"),
    ("Step", "tolerance", "AdaptiveStep"),
    ("Stop", "energy", "EnergyCriterion"),
    ("Stop", "increment", "IncrementCriterion"),
    ("Stop", "residual", "ResidualCriterion"),
    ("ThicknessField", "expression", "ThicknessFormula"),
    ("ThicknessField", "nodes", "NodalThickness"),
    ("Varying", "external", "ExternalFunction"),
    ("Varying", "input", "InputFunction"),
    ("Varying", "step", "StepFunction"),
    ("Varying", "table", "TimeTable"),
];

/// Names of type aliases, and of classes of a single form, that differ from their definition. The word of a key in a model file
/// is often too general for a name of the package.
const DEFINITIONS: [(&str, &str); 15] = [
    ("About", "LinearizationState"),
    ("At", "Position"),
    ("Coupled", "CoupledJoint"),
    ("End", "JointEnd"),
    ("Initial", "InitialState"),
    ("Origin", "InitialOrigin"),
    ("Quantity", "ProbeQuantity"),
    ("Sense", "LoadDirection"),
    ("Shape", "AxisShape"),
    ("Slopes", "SlopeCoordinates"),
    ("Start", "InitialAccelerations"),
    ("Step", "StepSize"),
    ("Stop", "ConvergenceCriterion"),
    ("Unstable", "InstabilityAction"),
    ("Varying", "VaryingFunction"),
];

/// Returns the name of the class of a form of a definition.
pub(super) fn class(definition: &str, word: &str) -> String {
    let special = CLASSES.iter().find(|(of, form, _)| *of == definition && *form == word);
    special.map_or_else(|| camel(word), |(_, _, name)| (*name).to_owned())
}

fn camel(word: &str) -> String {
    let capital = |part: &str| part[..1].to_uppercase() + &part[1..];
    word.split('_').filter(|part| !part.is_empty()).map(capital).collect()
}

/// Returns the name of the type alias of a definition, or of its class if it has a single form.
pub(super) fn alias(definition: &str) -> &str {
    DEFINITIONS.iter().find(|(of, _)| *of == definition).map_or(definition, |(_, name)| name)
}

/// Returns a type that Python accepts in addition to the schema, and its description.
pub(super) fn besides(definition: &str) -> Option<(&'static str, &'static str)> {
    (definition == "TimeFunction").then_some((
        "Callable[[float], float | tuple[float, float, float]]",
        "Or a Python function of time that returns the value, or value, rate and acceleration.",
    ))
}

/// Returns the type that Python accepts instead of a name, and its description.
pub(super) fn instead(definition: &str, class: &str, key: &str) -> Option<(&'static str, &'static str)> {
    match (definition, class, key) {
        ("Body", _, "section" | "section_end") => Some(("Section", "Or the section itself.")),
        ("Body" | "Layer", _, "material") => Some(("Material", "Or the material itself.")),
        ("JointLaw", _, "name") => Some(("LawFunction", "Or the function itself, f(t, x, v).")),
        ("Load", "ExternalForce", "name") => Some(("ForceFunction", "Or the function itself, F(t, x, v).")),
        _ => None,
    }
}

/// Returns the base class of a class.
pub(super) fn base(definition: &str, class: &str) -> &'static str {
    match (definition, class) {
        (_, "Beam" | "Cable") => "Axis",
        (_, "RigidBody") => "Frame",
        (_, "Shell") => "Surface",
        (_, "PointMass") => "Point",
        ("Model", _) => "Document",
        ("Material" | "Section", _) => "Shared",
        _ => "Part",
    }
}

/// Returns the module of a name that is not generated.
pub(super) fn imported_from(name: &str) -> &'static str {
    match name {
        "Callable" | "Mapping" | "Sequence" => "collections.abc",
        "dataclass" | "field" => "dataclasses",
        "ClassVar" | "Literal" | "TypeAlias" => "typing",
        "Axis" | "Frame" | "Point" | "Surface" => "ancf.model.base.axis",
        "checked_arguments" => "ancf.model.base.arguments",
        "Document" => "ancf.model.document",
        _ => "ancf.model.base.part",
    }
}

/// Returns the keys that are positional arguments, in order.
pub(super) fn positional(class: &str) -> &'static [&'static str] {
    match class {
        "Place" => &["body", "at"],
        "Expression" | "ForceExpression" => &["text"],
        _ => &["name"],
    }
}

/// Returns the table of the model to which a key refers by name.
pub(super) fn table(definition: &str, key: &str) -> Option<&'static str> {
    match instead(definition, "", key)? {
        ("Section", _) => Some("sections"),
        ("Material", _) => Some("materials"),
        _ => None,
    }
}

/// Returns the attribute of a key: Python keywords get a trailing underscore.
pub(super) fn attribute(key: &str) -> String {
    const KEYWORDS: [&str; 35] = [
        "False", "None", "True", "and", "as", "assert", "async", "await", "break", "class", "continue",
        "def", "del", "elif", "else", "except", "finally", "for", "from", "global", "if", "import", "in",
        "is", "lambda", "nonlocal", "not", "or", "pass", "raise", "return", "try", "while", "with", "yield",
    ];
    if KEYWORDS.contains(&key) { format!("{key}_") } else { key.to_owned() }
}
