//! Cantilever under gravity or a load at its tip.

use super::blocks::{ROD, Rod, clamp, end_probe};

/// Cantilever along x, and the text of its model.
///
/// The probe `tip` is at its end. A beam has the probe `up` in the same section, at (y, z) = (`offset`, 0).
#[derive(Clone, Copy, Debug)]
pub(in crate::problems) struct Cantilever<'a> {
    /// `"cable"` or the formulation of a beam.
    pub element: &'a str,
    /// Number of elements.
    pub elements: u32,
    /// Length.
    pub length: f64,
    /// Section, a table.
    pub section: &'a str,
    /// Material, a table.
    pub material: &'a str,
    /// Gravity along −y.
    pub gravity: f64,
    /// Load at the end, as keys of a load.
    pub load: Option<&'a str>,
    /// Clamped gradients: `"all"` or `"section"`.
    pub fix: &'a str,
    /// Distance of the probe `up` from the axis.
    pub offset: f64,
    /// Settings of the statics.
    pub statics: &'a str,
}

/// Rod of Kim et al. (2017): L = 1 m, d = 20 mm, ρ = 8030 kg/m³, E = 193 GPa, ν = 0.
pub(in crate::problems) const KIM: Cantilever<'static> = Cantilever {
    element: "continuum",
    elements: 1,
    length: 1.0,
    section: "{ kind = \"circle\", diameter = 0.02 }",
    material: "{ density = 8030, young = 193e9 }",
    gravity: 9.81,
    load: None,
    fix: "section",
    offset: 0.01,
    statics: "first = 1.0",
};

/// Section of that rod by its numbers, with a shear factor of one.
pub(in crate::problems) const KIM_BY_NUMBERS: &str = "{ kind = \"general\", area = 3.141592653589793e-4, iy = \
    7.853981633974483e-9, iz = 7.853981633974483e-9 }";

/// Bending stiffness E I of that rod, N m².
pub(in crate::problems) const KIM_BENDING: f64 = 1515.818455357075;

/// Area of the section of that rod, m².
pub(in crate::problems) const KIM_AREA: f64 = 3.141592653589793e-4;

impl Cantilever<'_> {
    /// Returns the text of the model.
    pub fn model(&self) -> String {
        let Self { element, elements, length, section, material, gravity, fix, offset, statics, .. } = self;
        let rod = Rod { element, elements: *elements, to: [*length, 0.0, 0.0], ..ROD };
        let beside = match *element {
            "cable" => String::new(),
            _ => end_probe("up", "rod") + &format!("offset = [{offset:?}, 0]\n"),
        };
        let load = self.load.map_or_else(String::new, |load| {
            format!("[[loads]]\n{load}\non = {{ body = \"rod\", at = \"end\" }}")
        });
        format!(
            r#"
            gravity = [0, {}, 0]
            materials.material = {material}
            sections.section = {section}
            {rod}{root}fix = "{fix}"
            {load}
            {tip}{beside}
            [analysis]
            kind = "statics"
            {statics}
            "#,
            -gravity,
            root = clamp("root", "rod", "\"ground\""),
            tip = end_probe("tip", "rod"),
        )
    }
}
