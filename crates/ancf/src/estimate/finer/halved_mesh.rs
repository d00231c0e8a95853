use std::collections::HashMap;

use nalgebra::Vector3;

use crate::model::{ElementMesh, ElementNodes, MeshGroup, ShearShell, ShellThickness, ThicknessField};

/// Division of the elements of a shear-deformable shell into four.
struct Division {
    points: Vec<Vector3<f64>>,
    directors: Vec<Vector3<f64>>,
    /// Nodes in the middle of edges, by the ends of the edge in ascending order.
    middles: HashMap<[u32; 2], u32>,
    /// Numbers at the nodes; none without a field.
    values: Vec<f64>,
}

/// Divides each element of a mesh into four. Old nodes keep their numbers, and groups their names and places.
///
/// New nodes are on the smooth surface through the nodes that is normal to the directors there. The middle of an edge is that of the cubic
/// whose end tangents are the projections of the edge. Plane meshes remain plane, with straight edges. Thicknesses at new nodes are those of
/// the shape functions of the elements.
///
/// Source: Vlachos, Peters, Boyd & Mitchell (2001).
pub(super) fn halved_mesh(shell: &ShearShell) -> (ElementMesh, ShellThickness) {
    let values = match &shell.thickness {
        ShellThickness::Varying(ThicknessField::Nodes { values }) => values.clone(),
        _ => Vec::new(),
    };
    let (points, directors) = (shell.points(), shell.unit_directors());
    let mut division = Division { points, directors, middles: HashMap::new(), values };
    let elements = shell.mesh.elements.iter().flat_map(|element| division.divide(element)).collect();
    let groups = shell.mesh.groups.iter().map(|(name, group)| (name.clone(), division.group(group)));
    let directors = if shell.mesh.directors.is_empty() { &[] } else { division.directors.as_slice() };
    let array = |vector: &Vector3<f64>| <[f64; 3]>::from(*vector);
    let mesh = ElementMesh {
        file: None,
        scale: None,
        nodes: division.points.iter().map(array).collect(),
        elements,
        directors: directors.iter().map(array).collect(),
        groups: groups.collect(),
    };
    let thickness = match &shell.thickness {
        ShellThickness::Varying(ThicknessField::Nodes { .. }) => {
            ShellThickness::Varying(ThicknessField::Nodes { values: division.values })
        }
        given => given.clone(),
    };
    (mesh, thickness)
}

impl Division {
    /// Elements of a quarter of the size, with the orientation and the first corners of the element.
    fn divide(&mut self, element: &ElementNodes) -> Vec<ElementNodes> {
        match *element {
            ElementNodes::Quad([a, b, c, d]) => {
                let [ab, bc, cd, da] = [[a, b], [b, c], [c, d], [d, a]].map(|edge| self.middle(edge));
                let centre = self.centre([a, b, c, d], [ab, bc, cd, da]);
                [[a, ab, centre, da], [ab, b, bc, centre], [centre, bc, c, cd], [da, centre, cd, d]]
                    .map(ElementNodes::Quad)
                    .to_vec()
            }
            ElementNodes::Triangle([a, b, c]) => {
                let [ab, bc, ca] = [[a, b], [b, c], [c, a]].map(|edge| self.middle(edge));
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]].map(ElementNodes::Triangle).to_vec()
            }
        }
    }

    /// Adds a node between others.
    fn add(&mut self, point: Vector3<f64>, director: Vector3<f64>, between: &[u32]) -> u32 {
        if !self.values.is_empty() {
            let sum: f64 = between.iter().map(|node| self.values[*node as usize]).sum();
            self.values.push(sum / between.len() as f64);
        }
        self.points.push(point);
        self.directors.push(director.normalize());
        (self.points.len() - 1) as u32
    }

    /// Node in the middle of an edge.
    fn middle(&mut self, [a, b]: [u32; 2]) -> u32 {
        let key = [a.min(b), a.max(b)];
        if let Some(&node) = self.middles.get(&key) {
            return node;
        }
        let [x, y] = key.map(|node| self.points[node as usize]);
        let [n, m] = key.map(|node| self.directors[node as usize]);
        let edge = y - x;
        let point = (x + y) * 0.5 + (m * edge.dot(&m) - n * edge.dot(&n)) * 0.125;
        // Quadratic normals, whose middle is the mean reflected at the plane across the edge.
        let sum = n + m;
        let across = (sum - edge * (2.0 * edge.dot(&sum) / edge.norm_squared())).normalize();
        let node = self.add(point, sum * 0.25 + across * 0.5, &key);
        self.middles.insert(key, node);
        node
    }

    /// Node in the middle of a quadrilateral, on the patch of Coons between its edges.
    fn centre(&mut self, corners: [u32; 4], middles: [u32; 4]) -> u32 {
        let blend = |vectors: &[Vector3<f64>]| {
            let sum =
                |nodes: [u32; 4]| nodes.iter().map(|node| vectors[*node as usize]).sum::<Vector3<f64>>();
            sum(middles) * 0.5 - sum(corners) * 0.25
        };
        let (point, director) = (blend(&self.points), blend(&self.directors));
        self.add(point, director, &corners)
    }

    /// The same nodes, edges and elements on the divided mesh.
    fn group(&self, group: &MeshGroup) -> MeshGroup {
        let chain = |chain: &Vec<u32>| {
            let pairs = chain.windows(2).flat_map(|pair| {
                let middle = self.middles.get(&[pair[0].min(pair[1]), pair[0].max(pair[1])]);
                [Some(pair[0]), middle.copied()].into_iter().flatten()
            });
            pairs.chain(chain.last().copied()).collect()
        };
        MeshGroup {
            nodes: group.nodes.clone(),
            edges: group.edges.iter().map(chain).collect(),
            elements: group
                .elements
                .iter()
                .flat_map(|element| (0..4).map(move |k| 4 * element + k))
                .collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::InitialMotion;

    fn shell(mesh: ElementMesh) -> ShearShell {
        ShearShell {
            name: "s".into(),
            mesh,
            crease: 0.7,
            thickness: 0.01.into(),
            material: "m".into(),
            layers: Vec::new(),
            fibre_axis: None,
            fibre_angle: None,
            membrane: None,
            motion: InitialMotion::default(),
        }
    }

    /// Quarter of a cylinder of radius 1 about y, of n × 1 quadrilaterals.
    fn cylinder(n: u32) -> ElementMesh {
        let node = |k: u32| {
            let (sin, cos) = (f64::from(k % (n + 1)) / f64::from(n) * std::f64::consts::FRAC_PI_2).sin_cos();
            [sin, f64::from(k / (n + 1)), cos]
        };
        let quad = |k: u32| ElementNodes::Quad([k, k + 1, k + n + 2, k + n + 1]);
        ElementMesh {
            nodes: (0..2 * (n + 1)).map(node).collect(),
            elements: (0..n).map(quad).collect(),
            ..ElementMesh::default()
        }
    }

    /// New nodes are on the cylinder, with an error of fourth order if the directors are exact.
    #[test]
    fn nodes_are_on_the_smooth_surface() {
        let distance = |n: u32, is_exact: bool| {
            let mut mesh = cylinder(n);
            if is_exact {
                mesh.directors = mesh.nodes.iter().map(|[x, _, z]| [*x, 0.0, *z]).collect();
            }
            let (halved, _) = halved_mesh(&shell(mesh));
            let far = halved.nodes.iter().map(|[x, _, z]| (x.hypot(*z) - 1.0).abs()).fold(0.0, f64::max);
            let turned = halved.directors.iter().zip(&halved.nodes);
            let turn = turned.map(|([a, _, c], [x, _, z])| (a * z - c * x).abs()).fold(0.0, f64::max);
            assert!(turn < 1e-12, "directors of {n}: {turn:e}");
            far
        };
        for n in [3, 6, 12] {
            // The middle of the cubic is at cos φ + ½ sin² φ cos φ = 1 − ⅜ φ⁴ + ..., with half the angle φ of the edge.
            let (found, angle) = (distance(n, true), std::f64::consts::FRAC_PI_4 / f64::from(n));
            assert!((found / (0.375 * angle.powi(4)) - 1.0).abs() < 0.05, "{n}: {found:e}");
        }
        // The directors at the free edges are extrapolated.
        let [coarse, fine] = [4, 8].map(|n| distance(n, false));
        let chord = |n: f64| 1.0 - (std::f64::consts::FRAC_PI_4 / n).cos();
        assert!(coarse < 0.1 * chord(4.0) && fine < 0.1 * chord(8.0), "{coarse:e}, {fine:e}");
    }

    /// Areas, groups and orientations of a plane mesh of a quadrilateral and a triangle.
    #[test]
    fn plane_meshes_keep_their_area_and_groups() {
        let group = |nodes: &[u32], edges: &[u32], elements: &[u32]| MeshGroup {
            nodes: nodes.to_vec(),
            edges: if edges.is_empty() { Vec::new() } else { vec![edges.to_vec()] },
            elements: elements.to_vec(),
        };
        let mesh = ElementMesh {
            nodes: vec![[0.0, 0.0, 2.0], [1.0, 0.0, 2.0], [1.3, 1.0, 2.0], [0.0, 0.8, 2.0], [2.0, 0.4, 2.0]],
            elements: vec![ElementNodes::Quad([0, 1, 2, 3]), ElementNodes::Triangle([1, 4, 2])],
            groups: [
                ("corner".to_owned(), group(&[4], &[], &[])),
                ("round".to_owned(), group(&[], &[0, 1, 4, 2, 3, 0], &[])),
                ("end".to_owned(), group(&[], &[], &[1])),
            ]
            .into(),
            ..ElementMesh::default()
        };
        let (given, halved) = (shell(mesh.clone()), shell(halved_mesh(&shell(mesh)).0));
        assert_eq!((halved.mesh.nodes.len(), halved.mesh.elements.len()), (12, 8));
        assert!((halved.area() - given.area()).abs() < 1e-14 && halved.defect().is_none());
        assert!(halved.mesh.nodes.iter().all(|node| node[2] == 2.0));
        let groups = &halved.mesh.groups;
        assert_eq!(groups["corner"].nodes, [4]);
        assert_eq!(
            (groups["end"].elements.as_slice(), groups["round"].edges[0].len()),
            (&[4, 5, 6, 7][..], 11)
        );
        let length = |shell: &ShearShell| -> f64 {
            let points = shell.points();
            let chain = &shell.mesh.groups["round"].edges[0];
            chain.windows(2).map(|pair| (points[pair[1] as usize] - points[pair[0] as usize]).norm()).sum()
        };
        assert!((length(&halved) - length(&given)).abs() < 1e-14);
    }
}
