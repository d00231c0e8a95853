/// The model of a cantilever along x that several problems share: a way to write the text of its file.
///
/// Probes are `tip` at its end, and of beams `up` beside it, at (y, z) = (`offset`, 0) of the same section.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cantilever<'a> {
    /// `"cable"` or the formulation of a beam.
    pub element: &'a str,
    /// Number of elements.
    pub elements: u32,
    /// Length.
    pub length: f64,
    /// The section, a table.
    pub section: &'a str,
    /// The material, a table.
    pub material: &'a str,
    /// Gravity along −y.
    pub gravity: f64,
    /// What acts at the end, as keys of a load.
    pub load: Option<&'a str>,
    /// Which gradients are clamped: `"all"` or `"section"`.
    pub fix: &'a str,
    /// Distance of the probe `up` from the axis.
    pub offset: f64,
    /// The settings of the statics.
    pub statics: &'a str,
}

/// The rod of Kim et al. (2017): L = 1 m, d = 20 mm, ρ = 8030 kg/m³, E = 193 GPa, ν = 0, as a beam by its numbers, with a shear
/// factor of one.
pub(super) const KIM: Cantilever<'static> = Cantilever {
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

/// The circle of that rod by its numbers, with a shear factor of one.
pub(super) const KIM_BY_NUMBERS: &str = "{ kind = \"general\", area = 3.141592653589793e-4, iy = 7.853981633974483e-9, iz = 7.853981633974483e-9 }";

/// E I of that rod, N m².
pub(super) const KIM_BENDING: f64 = 1515.818455357075;

impl Cantilever<'_> {
    /// The text of the model.
    pub fn model(&self) -> String {
        let Self { element, elements, length, section, material, gravity, fix, offset, statics, .. } = self;
        let (kind, beside) = if *element == "cable" {
            ("kind = \"cable\"".to_owned(), String::new())
        } else {
            let probe = format!(
                "[[probes]]\nname = \"up\"\non = {{ body = \"rod\", at = \"end\" }}\noffset = [{offset:?}, 0]"
            );
            (format!("kind = \"beam\"\nformulation = \"{element}\""), probe)
        };
        let load = self.load.map_or_else(String::new, |load| {
            format!("[[loads]]\n{load}\non = {{ body = \"rod\", at = \"end\" }}")
        });
        format!(
            r#"
            gravity = [0, {}, 0]
            materials.rod = {material}
            sections.rod = {section}

            [[bodies]]
            {kind}
            name = "rod"
            from = [0, 0, 0]
            to = [{length:?}, 0, 0]
            elements = {elements}
            section = "rod"
            material = "rod"

            [[joints]]
            kind = "clamp"
            name = "root"
            a = {{ body = "rod", at = "start" }}
            fix = "{fix}"

            {load}

            [[probes]]
            name = "tip"
            on = {{ body = "rod", at = "end" }}

            {beside}

            [analysis]
            kind = "statics"
            {statics}
            "#,
            -gravity
        )
    }
}
