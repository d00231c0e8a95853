//! What the classes of Python are called, and what is special about some of them.

/// Modules of the package, what they hold, and the definitions of the schema from which that is reached. What several
/// modules need is in the first of them.
pub(super) const MODULES: [(&str, &str, &[&str]); 13] = [
    ("places", "Places on bodies.", &["End"]),
    ("functions", "Functions of time.", &["TimeFunction"]),
    ("materials", "Materials.", &["Material"]),
    ("sections", "Cross-sections.", &["Section"]),
    ("bodies", "Bodies, flexible and rigid.", &["Body"]),
    ("drives", "Drives, springs and friction of joints.", &DRIVES),
    ("joints", "Joints.", &["Joint"]),
    ("couplings", "Joints that move together.", &["Coupling"]),
    ("loads", "Loads besides gravity.", &["Load"]),
    ("contacts", "What bodies may touch.", &["Contact"]),
    ("analyses", "What is computed.", &["Analysis"]),
    ("output", "What is recorded and written.", &["Probe", "Output"]),
    ("whole", "The whole model.", &["Model"]),
];

const DRIVES: [&str; 6] =
    ["AngularDrive", "AngularSpring", "AngularFriction", "LinearDrive", "LinearSpring", "LinearFriction"];

/// Classes that are not called by the word of their form or their definition: definition, word or first key, name.
const CLASSES: [(&str, &str, &str); 17] = [
    ("Against", "bodies", "EachOther"),
    ("Body", "mass", "PointMass"),
    ("Body", "rigid", "RigidBody"),
    ("Load", "external", "ExternalForce"),
    ("ScaleChoice", "auto", "AutoScales"),
    ("ScaleChoice", "given", "GivenScales"),
    ("ScaleChoice", "none", "NoScales"),
    ("ScaleChoice", "paper", "PaperScales"),
    ("Scheme", "alpha", "HHT"),
    ("Scheme", "gamma", "Newmark"),
    ("Scheme", "spectral_radius", "GeneralizedAlpha"),
    ("Section", "general", "GeneralSection"),
    ("Step", "tolerance", "AdaptiveStep"),
    ("Stop", "energy", "EnergyStop"),
    ("Stop", "increment", "IncrementStop"),
    ("Stop", "residual", "ResidualStop"),
    ("Varying", "external", "ExternalFunction"),
];

/// The name of the class for a form of a definition.
pub(super) fn class(definition: &str, word: &str) -> String {
    let special = CLASSES.iter().find(|(of, form, _)| *of == definition && *form == word);
    special.map_or_else(|| camel(word), |(_, _, name)| (*name).to_owned())
}

fn camel(word: &str) -> String {
    let capital = |part: &str| part[..1].to_uppercase() + &part[1..];
    word.split('_').filter(|part| !part.is_empty()).map(capital).collect()
}

/// The name of the type of a definition that has several forms.
pub(super) fn alias(definition: &str) -> &str {
    // `Step` is the function of time.
    if definition == "Step" { "StepSize" } else { definition }
}

/// What a definition allows in Python besides, and what that is.
pub(super) fn besides(definition: &str) -> Option<(&'static str, &'static str)> {
    (definition == "TimeFunction").then_some((
        "Callable[[float], float | tuple[float, float, float]]",
        "Or a function of Python, which gives its value at a time, or value, rate and acceleration.",
    ))
}

/// What a key allows in Python in the place of a name, and what that is.
pub(super) fn instead(definition: &str, key: &str) -> Option<(&'static str, &'static str)> {
    match (definition, key) {
        ("Body", "section" | "section_end") => Some(("Section", "Or the section itself.")),
        ("Body", "material") => Some(("Material", "Or the material itself.")),
        ("Load", "name") => Some(("ForceFunction", "Or the function itself, F(t, x, v).")),
        _ => None,
    }
}

/// The module and the name of the class from which a class derives.
pub(super) fn base(definition: &str, class: &str) -> (&'static str, &'static str) {
    match (definition, class) {
        (_, "Beam" | "Cable") => ("ancf.axis", "Axis"),
        (_, "RigidBody") => ("ancf.axis", "Frame"),
        (_, "PointMass") => ("ancf.axis", "Point"),
        ("Model", _) => ("ancf.document", "Document"),
        ("Material" | "Section", _) => ("ancf.part", "Shared"),
        _ => ("ancf.part", "Part"),
    }
}

/// Keys that may be given without being named, in this order.
pub(super) fn positional(class: &str) -> &'static [&'static str] {
    match class {
        "Place" => &["body", "at"],
        "Expression" => &["text"],
        _ => &["name"],
    }
}

/// The table of the part that a key names.
pub(super) fn table(definition: &str, key: &str) -> Option<&'static str> {
    match instead(definition, key)? {
        ("Section", _) => Some("sections"),
        ("Material", _) => Some("materials"),
        _ => None,
    }
}

/// The attribute of a key: words of Python get an underscore.
pub(super) fn attribute(key: &str) -> String {
    const WORDS: [&str; 35] = [
        "False", "None", "True", "and", "as", "assert", "async", "await", "break", "class", "continue",
        "def", "del", "elif", "else", "except", "finally", "for", "from", "global", "if", "import", "in",
        "is", "lambda", "nonlocal", "not", "or", "pass", "raise", "return", "try", "while", "with", "yield",
    ];
    if WORDS.contains(&key) { format!("{key}_") } else { key.to_owned() }
}
