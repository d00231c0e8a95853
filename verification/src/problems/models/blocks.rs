//! Tables of a model file that several problems share.

use std::fmt;

/// Straight beam or cable of the section `section` and the material `material`.
#[derive(Clone, Copy, Debug)]
pub(in crate::problems) struct Rod<'a> {
    /// Name of the body.
    pub name: &'a str,
    /// `"cable"` or the formulation of a beam.
    pub element: &'a str,
    /// Start of the axis.
    pub from: [f64; 3],
    /// End of the axis.
    pub to: [f64; 3],
    /// Number of elements.
    pub elements: u32,
    /// Further keys of the body.
    pub keys: &'a str,
}

/// Continuum beam of one element, from the origin to x = 1.
pub(in crate::problems) const ROD: Rod<'static> =
    Rod { name: "rod", element: "continuum", from: [0.0; 3], to: [1.0, 0.0, 0.0], elements: 1, keys: "" };

impl fmt::Display for Rod<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, element, from, to, elements, keys } = self;
        let kind = match *element {
            "cable" => "kind = \"cable\"".to_owned(),
            formulation => format!("kind = \"beam\"\nformulation = \"{formulation}\""),
        };
        write!(
            f,
            r#"
            [[bodies]]
            {kind}
            name = "{name}"
            from = {from:?}
            to = {to:?}
            elements = {elements}
            section = "section"
            material = "material"
            {keys}
            "#
        )
    }
}

/// Clamp `root` at the start of a body.
pub(in crate::problems) fn clamped(body: &str) -> String {
    clamp("root", body, "\"ground\"")
}

/// Clamp `root` at the start of a body that fixes the section only.
pub(in crate::problems) fn clamped_section(body: &str) -> String {
    clamped(body) + "fix = \"section\"\n"
}

/// Clamp of the start of a body to `to`, a table or `"ground"`.
pub(in crate::problems) fn clamp(name: &str, body: &str, to: &str) -> String {
    joint("clamp", name, &format!("{{ body = \"{body}\", at = \"start\" }}")) + &format!("b = {to}\n")
}

/// Revolute joint about z at the `at` of a body.
pub(in crate::problems) fn hinge(name: &str, body: &str, at: &str) -> String {
    joint("revolute", name, &format!("{{ body = \"{body}\", at = \"{at}\" }}")) + "axis = [0, 0, 1]\n"
}

/// Joint with its end `a`, a table. Keys may follow.
pub(in crate::problems) fn joint(kind: &str, name: &str, a: &str) -> String {
    format!(
        r#"
        [[joints]]
        kind = "{kind}"
        name = "{name}"
        a = {a}
        "#
    )
}

/// Force at the end of a body. Keys may follow.
pub(in crate::problems) fn tip_load(body: &str, force: [f64; 3]) -> String {
    format!(
        r#"
        [[loads]]
        kind = "force"
        on = {{ body = "{body}", at = "end" }}
        force = {force:?}
        "#
    )
}

/// Probe at the end of a body. Keys may follow.
pub(in crate::problems) fn end_probe(name: &str, body: &str) -> String {
    format!(
        r#"
        [[probes]]
        name = "{name}"
        on = {{ body = "{body}", at = "end" }}
        "#
    )
}

/// Cantilever: a rod, clamped at its start, with a force and the probe `tip` at its end.
pub(in crate::problems) fn cantilever(rod: &Rod<'_>, force: [f64; 3]) -> String {
    let body = rod.name;
    format!("{rod}{}{}{}", clamped(body), tip_load(body, force), end_probe("tip", body))
}
