//! Parts of model files with one shear-deformable shell `s` of a material `m`.

use std::fmt::{self, Write};

/// Shear-deformable shell of a model.
pub(in crate::problems) struct MeshModel {
    pub(in crate::problems) nodes: Vec<[f64; 3]>,
    pub(in crate::problems) elements: Vec<Vec<usize>>,
    pub(in crate::problems) directors: Vec<[f64; 3]>,
    /// Groups, as in a model file.
    pub(in crate::problems) groups: String,
    pub(in crate::problems) thickness: f64,
    /// Further keys of the shell.
    pub(in crate::problems) keys: String,
    /// Material, as in a model file.
    pub(in crate::problems) material: String,
}

/// Point and normal of a surface as a function of its parameters.
pub(in crate::problems) type Map<'a> = dyn Fn([f64; 2]) -> [[f64; 3]; 2] + 'a;

/// Isotropic material: Young's modulus, Poisson's ratio and density.
pub(in crate::problems) fn isotropic([young, poisson, density]: [f64; 3]) -> String {
    format!("young = {young:e}, poisson = {poisson:?}, density = {density:e}")
}

impl MeshModel {
    /// Mesh of n × m elements of a map of the unit square, with the groups `u0`, `u1`, `v0` and `v1` of its edges and the points `p00`,
    /// `p10`, `p11` and `p01` of its corners, `middle`, and `end` in the middle of `u1`. The map returns points and normals.
    pub(in crate::problems) fn grid(
        [n, m]: [usize; 2],
        thickness: f64,
        material: String,
        map: impl Fn([f64; 2]) -> [[f64; 3]; 2],
    ) -> Self {
        let node = |i: usize, j: usize| j * (n + 1) + i;
        let places = (0..=m).flat_map(|j| (0..=n).map(move |i| [i as f64 / n as f64, j as f64 / m as f64]));
        let (nodes, directors) =
            places.map(|at| map(at).into()).map(|(r, d): ([f64; 3], [f64; 3])| (r, d)).unzip();
        let element =
            |i: usize, j: usize| vec![node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
        let elements = (0..m).flat_map(|j| (0..n).map(move |i| (i, j))).map(|(i, j)| element(i, j)).collect();
        let row = |j: usize| (0..=n).map(|i| node(i, j)).collect::<Vec<_>>();
        let column = |i: usize| (0..=m).map(|j| node(i, j)).collect::<Vec<_>>();
        let edges = [("u0", column(0)), ("u1", column(n)), ("v0", row(0)), ("v1", row(m))];
        let points = [
            ("p00", node(0, 0)),
            ("p10", node(n, 0)),
            ("p11", node(n, m)),
            ("p01", node(0, m)),
            ("middle", node(n / 2, m / 2)),
            ("end", node(n, m / 2)),
        ];
        let mut groups = String::new();
        for (name, chain) in edges {
            let _ = writeln!(groups, "groups.{name} = {{ edges = [{chain:?}] }}");
        }
        for (name, node) in points {
            let _ = writeln!(groups, "groups.{name} = {{ nodes = [{node}] }}");
        }
        Self { nodes, elements, directors, groups, thickness, keys: String::new(), material }
    }

    /// Mesh of grids of n × n elements that share their common nodes, without groups.
    pub(in crate::problems) fn patches(n: usize, thickness: f64, material: String, maps: &[&Map]) -> Self {
        let mut mesh = Self {
            nodes: Vec::new(),
            elements: Vec::new(),
            directors: Vec::new(),
            groups: String::new(),
            thickness,
            keys: String::new(),
            material,
        };
        for map in maps {
            let grid = Self::grid([n, n], thickness, String::new(), map);
            let mut numbers = Vec::new();
            for (&node, director) in grid.nodes.iter().zip(grid.directors) {
                numbers.push(mesh.number(node).unwrap_or(mesh.nodes.len()));
                if mesh.number(node).is_none() {
                    mesh.nodes.push(node);
                    mesh.directors.push(director);
                }
            }
            let renumbered = |element: Vec<usize>| element.into_iter().map(|k| numbers[k]).collect();
            mesh.elements.extend(grid.elements.into_iter().map(renumbered));
        }
        mesh
    }

    /// Number of the node at a point.
    fn number(&self, at: [f64; 3]) -> Option<usize> {
        self.nodes.iter().position(|node| node.iter().zip(at).all(|(a, b)| (a - b).abs() < 1e-9))
    }

    /// Adds the edge through all nodes with a coordinate along it.
    pub(in crate::problems) fn with_edge(
        mut self,
        name: &str,
        coordinate: impl Fn([f64; 3]) -> Option<f64>,
    ) -> Self {
        let nodes = self.nodes.iter().enumerate();
        let mut chain: Vec<(f64, usize)> =
            nodes.filter_map(|(k, &node)| coordinate(node).map(|s| (s, k))).collect();
        chain.sort_by(|a, b| a.0.total_cmp(&b.0));
        let chain: Vec<usize> = chain.into_iter().map(|(_, k)| k).collect();
        self.groups += &format!("groups.{name} = {{ edges = [{chain:?}] }}\n");
        self
    }

    /// Names the node at a point.
    pub(in crate::problems) fn with_point(mut self, name: &str, at: [f64; 3]) -> Self {
        let nodes = Vec::from_iter(self.number(at));
        self.groups += &format!("groups.{name} = {{ nodes = {nodes:?} }}\n");
        self
    }

    /// Divides chosen quadrilaterals into two triangles.
    pub(in crate::problems) fn divided(self, is_divided: impl Fn(usize) -> bool) -> Self {
        let parts = |(k, element): (usize, Vec<usize>)| match element[..] {
            [a, b, c, d] if is_divided(k) => vec![vec![a, b, c], vec![a, c, d]],
            _ => vec![element],
        };
        let elements = self.elements.into_iter().enumerate().flat_map(parts).collect();
        Self { elements, ..self }
    }

    /// Flat rectangular plate in the plane x, y.
    pub(in crate::problems) fn plate(
        elements: [usize; 2],
        [a, b]: [f64; 2],
        thickness: f64,
        material: String,
    ) -> Self {
        Self::grid(elements, thickness, material, |[u, v]| [[a * u, b * v, 0.0], [0.0, 0.0, 1.0]])
    }
}

impl fmt::Display for MeshModel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { nodes, elements, directors, groups, thickness, keys, material } = self;
        writeln!(f, "materials.m = {{ {material} }}")?;
        writeln!(
            f,
            "[[bodies]]\nkind = \"shear_shell\"\nname = \"s\"\nthickness = {thickness:?}\nmaterial = \"m\"\n{keys}"
        )?;
        writeln!(f, "[bodies.mesh]\nnodes = {nodes:?}\nelements = {elements:?}")?;
        writeln!(f, "directors = {directors:?}\n{groups}")
    }
}

/// Point of the unit disc for a point of the square −1 ≤ x, y ≤ 1.
pub(in crate::problems) fn on_disc([x, y]: [f64; 2]) -> [f64; 2] {
    [x * (1.0 - 0.5 * y * y).sqrt(), y * (1.0 - 0.5 * x * x).sqrt()]
}

/// Support of an edge.
pub(in crate::problems) fn edge(edge: &str, condition: &str) -> String {
    format!(
        "[[joints]]\nkind = \"support\"\nname = \"{edge}\"\na = {{ body = \"s\", at = {{ edge = \"{edge}\" }} }}\n\
         condition = {condition}\n"
    )
}

/// Support of a point against displacements along global axes.
pub(in crate::problems) fn node(point: &str, axes: &str) -> String {
    format!(
        "[[joints]]\nkind = \"support\"\nname = \"{point} {}\"\na = {{ body = \"s\", at = {{ point = \"{point}\" }} }}\n\
         condition = \"guided\"\naxes = [{axes}]\n",
        axes.replace(['"', ','], "")
    )
}

/// Force at a point.
pub(super) fn force(point: &str, force: [f64; 3]) -> String {
    format!(
        "[[loads]]\nkind = \"force\"\non = {{ body = \"s\", at = {{ point = \"{point}\" }} }}\nforce = {force:?}\n"
    )
}

/// Load per length of an edge, of kind `edge_force` or `edge_moment`.
pub(super) fn edge_load(kind: &str, edge: &str, key: &str, load: [f64; 3]) -> String {
    format!("[[loads]]\nkind = \"{kind}\"\nbody = \"s\"\nedge = \"{edge}\"\n{key} = {load:?}\n")
}

/// Probe of a point.
pub(in crate::problems) fn probe(name: &str, point: &str) -> String {
    format!("[[probes]]\nname = \"{name}\"\non = {{ body = \"s\", at = {{ point = \"{point}\" }} }}\n")
}
