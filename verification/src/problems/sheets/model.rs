//! Parts of model files with a flat sheet `s` of thin or of shear-deformable shells.

use nalgebra::Vector3;

use crate::problems::shear_shells::mesh::MeshModel;

/// Kind of the elements of a sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Element {
    /// Thin shell, without transverse shear and without rotary inertia.
    Thin,
    /// Shear-deformable shell.
    Shear,
}

impl Element {
    /// Name in reports.
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Thin => "thin",
            Self::Shear => "shear-deformable",
        }
    }
}

/// Edge of a sheet.
#[derive(Clone, Copy, Debug)]
pub(super) enum Edge {
    /// u = 0.
    Left,
    /// u = 1.
    Right,
    /// v = 0.
    Front,
    /// v = 1.
    Back,
}

/// Rectangular sheet.
pub(super) struct Sheet {
    pub(super) element: Element,
    /// Corner u = v = 0.
    pub(super) corner: [f64; 3],
    /// Sides along u and v.
    pub(super) sides: [[f64; 3]; 2],
    pub(super) elements: [usize; 2],
    pub(super) thickness: f64,
    /// Material, as in a model file.
    pub(super) material: String,
    /// Further keys of the body.
    pub(super) keys: String,
}

impl Sheet {
    /// Returns the text of the material and of the body.
    pub(super) fn body(&self) -> String {
        let Self { corner, sides: [a, b], elements: [n, m], thickness, material, keys, .. } = self;
        if self.element == Element::Shear {
            return self.mesh().to_string();
        }
        format!(
            "materials.m = {{ {material} }}\n[[bodies]]\nkind = \"shell\"\nname = \"s\"\n\
             surface = {{ kind = \"flat\", corner = {corner:?}, side_u = {a:?}, side_v = {b:?} }}\n\
             elements = [{n}, {m}]\nthickness = {thickness:?}\nmaterial = \"m\"\n{keys}"
        )
    }

    fn mesh(&self) -> MeshModel {
        let Self { corner, sides: [a, b], .. } = self;
        let normal: [f64; 3] = Vector3::from(*a).cross(&Vector3::from(*b)).normalize().into();
        let place = |u: f64, v: f64| std::array::from_fn(|i| corner[i] + u * a[i] + v * b[i]);
        let mesh = MeshModel::grid(self.elements, self.thickness, self.material.clone(), |[u, v]| {
            [place(u, v), normal]
        });
        MeshModel { keys: self.keys.clone(), ..mesh }
    }

    /// Returns a node as a place of a model file.
    pub(super) fn node(&self, [i, j]: [usize; 2]) -> String {
        let [n, m] = self.elements;
        match self.element {
            Element::Thin => {
                format!("{{ body = \"s\", at = [{:?}, {:?}] }}", i as f64 / n as f64, j as f64 / m as f64)
            }
            Element::Shear => format!("{{ body = \"s\", at = {{ node = {} }} }}", j * (n + 1) + i),
        }
    }

    /// Returns a corner as a place of a model file.
    pub(super) fn corner(&self, [u, v]: [usize; 2]) -> String {
        self.node([u * self.elements[0], v * self.elements[1]])
    }

    /// Returns the name of an edge.
    pub(super) const fn edge(&self, edge: Edge) -> &'static str {
        let [thin, shear] = match edge {
            Edge::Left => ["u_start", "u0"],
            Edge::Right => ["u_end", "u1"],
            Edge::Front => ["v_start", "v0"],
            Edge::Back => ["v_end", "v1"],
        };
        match self.element {
            Element::Thin => thin,
            Element::Shear => shear,
        }
    }

    /// Support of an edge.
    pub(super) fn support(&self, edge: Edge, condition: &str) -> String {
        let edge = self.edge(edge);
        format!(
            "[[joints]]\nkind = \"support\"\nname = \"{edge}\"\na = {{ body = \"s\", at = {{ edge = \"{edge}\" }} }}\n\
             condition = \"{condition}\"\n"
        )
    }

    /// Support of an edge along global axes, hard where the shell distinguishes it.
    pub(super) fn guide(&self, edge: Edge, axes: &str) -> String {
        let hard = if self.element == Element::Shear { "hard = true\n" } else { "" };
        format!("{}axes = [{axes}]\n{hard}", self.support(edge, "guided"))
    }

    /// Support of a corner along global axes.
    pub(super) fn pin(&self, name: &str, at: [usize; 2], axes: &str) -> String {
        format!(
            "[[joints]]\nkind = \"support\"\nname = \"{name}\"\na = {}\ncondition = \"guided\"\naxes = [{axes}]\n",
            self.corner(at)
        )
    }

    /// Probe of a corner.
    pub(super) fn probe(&self, name: &str, at: [usize; 2]) -> String {
        format!("[[probes]]\nname = \"{name}\"\non = {}\n", self.corner(at))
    }

    /// Force at a node.
    pub(super) fn force(&self, at: [usize; 2], force: [f64; 3]) -> String {
        format!("[[loads]]\nkind = \"force\"\non = {}\nforce = {force:?}\n", self.node(at))
    }
}
