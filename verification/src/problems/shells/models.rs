//! Parts of model files with one shell `s` of a material `m`.

use std::fmt;

use crate::SolvedModel;

/// Shell of a model.
pub(in crate::problems) struct ShellModel<'a> {
    /// Surface, as in a model file.
    pub(in crate::problems) surface: &'a str,
    pub(in crate::problems) elements: [u32; 2],
    pub(in crate::problems) thickness: f64,
    /// Young's modulus, Poisson's ratio and density.
    pub(in crate::problems) material: [f64; 3],
}

impl fmt::Display for ShellModel<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { surface, elements: [n, m], thickness, material: [young, poisson, density] } = self;
        writeln!(f, "materials.m = {{ young = {young:e}, poisson = {poisson:?}, density = {density:?} }}")?;
        writeln!(f, "[[bodies]]\nkind = \"shell\"\nname = \"s\"\nsurface = {{ {surface} }}")?;
        writeln!(f, "elements = [{n}, {m}]\nthickness = {thickness:?}\nmaterial = \"m\"")
    }
}

/// Support of an edge.
pub(in crate::problems) fn edge(edge: &str, condition: &str) -> String {
    format!(
        "[[joints]]\nkind = \"support\"\nname = \"{edge}\"\na = {{ body = \"s\", at = {{ edge = \"{edge}\" }} }}\n\
         condition = {condition}\n"
    )
}

/// Support of a node against displacements along global axes.
pub(in crate::problems) fn node(name: &str, at: [f64; 2], axes: &str) -> String {
    format!(
        "[[joints]]\nkind = \"support\"\nname = \"{name}\"\na = {{ body = \"s\", at = {at:?} }}\n\
         condition = \"guided\"\naxes = [{axes}]\n"
    )
}

/// Force at a point.
pub(super) fn force(at: [f64; 2], force: [f64; 3]) -> String {
    format!("[[loads]]\nkind = \"force\"\non = {{ body = \"s\", at = {at:?} }}\nforce = {force:?}\n")
}

/// Load per length of an edge, of kind `edge_force` or `edge_moment`.
pub(super) fn edge_load(kind: &str, edge: &str, key: &str, load: [f64; 3]) -> String {
    format!("[[loads]]\nkind = \"{kind}\"\nbody = \"s\"\nedge = \"{edge}\"\n{key} = {load:?}\n")
}

/// Force per area.
pub(super) fn surface_force(force: [f64; 3]) -> String {
    format!("[[loads]]\nkind = \"surface_force\"\nbody = \"s\"\nforce = {force:?}\n")
}

/// Probe of a point.
pub(in crate::problems) fn probe(name: &str, at: [f64; 2]) -> String {
    format!("[[probes]]\nname = \"{name}\"\non = {{ body = \"s\", at = {at:?} }}\n")
}

/// Numbers of increments and Newton iterations of a solution.
pub(super) fn increments(solved: &SolvedModel) -> String {
    format!("{} and {}", solved.summary.steps, solved.summary.iterations)
}
