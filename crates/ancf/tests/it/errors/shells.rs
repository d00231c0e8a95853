//! Shells: ratios of errors by a second solution and true errors.

use std::f64::consts::{PI, TAU};

use ancf::estimate::{DiscretisationErrors, Resolution};

use super::{errors, of, summary};

/// Thickness of plates of length 1 with the bending stiffness 1 and ν = 0.3.
const THICKNESS: f64 = 1e-3;

/// Rectangle of quadrilaterals or triangles in the plane z = 0 with the named edges `left`, `right`, `front` and `back`.
///
/// `map` returns the places of the nodes.
fn mesh(
    [a, b]: [f64; 2],
    [n, m]: [u32; 2],
    are_triangles: bool,
    map: impl Fn([f64; 2]) -> [f64; 3],
) -> String {
    let number = |i: u32, j: u32| j * (n + 1) + i;
    let all = |n: u32, m: u32| (0..m).flat_map(move |j| (0..n).map(move |i| (i, j)));
    let nodes: Vec<_> = all(n + 1, m + 1)
        .map(|(i, j)| {
            format!("{:?}", map([a * f64::from(i) / f64::from(n), b * f64::from(j) / f64::from(m)]))
        })
        .collect();
    let elements: Vec<_> = all(n, m)
        .map(|(i, j)| {
            let [p, q, r, s] = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
            if are_triangles {
                format!("[{p}, {q}, {r}], [{p}, {r}, {s}]")
            } else {
                format!("[{p}, {q}, {r}, {s}]")
            }
        })
        .collect();
    let along = |j: u32| (0..=n).map(|i| number(i, j)).collect::<Vec<_>>();
    let across = |i: u32| (0..=m).map(|j| number(i, j)).collect::<Vec<_>>();
    format!(
        "mesh = {{ nodes = [{}], elements = [{}], groups = {{ left = {{ edges = [{:?}] }}, right = {{ edges = [{:?}] }}, \
         front = {{ edges = [{:?}] }}, back = {{ edges = [{:?}] }} }} }}",
        nodes.join(", "),
        elements.join(", "),
        across(0),
        across(n),
        along(0),
        along(m)
    )
}

/// Kind of a shell under test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Shell {
    Thin,
    Quadrilaterals,
    Triangles,
}

pub(super) use Shell::{Quadrilaterals, Thin, Triangles};

impl Shell {
    /// Rectangle a × b in the plane z = 0, named `s`.
    pub(super) fn body(self, sides: [f64; 2], elements: [u32; 2], thickness: f64) -> String {
        self.body_on(sides, elements, thickness, |[x, y]| [x, y, 0.0])
    }

    /// Rectangle a × b, named `s`. Nodes of shear-deformable shells are on a surface.
    pub(crate) fn body_on(
        self,
        [a, b]: [f64; 2],
        [n, m]: [u32; 2],
        thickness: f64,
        map: impl Fn([f64; 2]) -> [f64; 3],
    ) -> String {
        let keys = match self {
            Thin => format!(
                "kind = \"shell\"\nelements = [{n}, {m}]\n\
                 surface = {{ kind = \"flat\", corner = [0, 0, 0], side_u = [{a:?}, 0, 0], side_v = [0, {b:?}, 0] }}"
            ),
            _ => format!("kind = \"shear_shell\"\n{}", mesh([a, b], [n, m], self == Triangles, map)),
        };
        format!("[[bodies]]\nname = \"s\"\nmaterial = \"m\"\nthickness = {thickness:?}\n{keys}\n")
    }

    pub(crate) fn edge(self, name: &str) -> String {
        let thin = match name {
            "left" => "u_start",
            "right" => "u_end",
            "front" => "v_start",
            _ => "v_end",
        };
        format!("{{ edge = \"{}\" }}", if self == Thin { thin } else { name })
    }

    /// Probe at a point of the rectangle a × b.
    pub(crate) fn probe(self, [a, b]: [f64; 2], [x, y]: [f64; 2], keys: &str) -> String {
        let at =
            if self == Thin { format!("[{:?}, {:?}]", x / a, y / b) } else { format!("[{x:?}, {y:?}, 0]") };
        format!("[[probes]]\nname = \"p\"\non = {{ body = \"s\", at = {at} }}\n{keys}\n")
    }

    fn supports(self, condition: &str) -> String {
        let is_hard = if self != Thin && condition.contains("hinged") { "hard = true\n" } else { "" };
        ["left", "right", "front", "back"]
            .map(|edge| {
                format!(
                    "[[joints]]\nkind = \"support\"\nname = \"{edge}\"\na = {{ body = \"s\", at = {} }}\n{condition}\n{is_hard}",
                    self.edge(edge)
                )
            })
            .concat()
    }

    /// Square plate of length 1 with n × n elements and the bending stiffness 1.
    fn plate(self, n: u32, condition: &str, rest: &str) -> String {
        let young = 12.0 * (1.0 - 0.3 * 0.3) / THICKNESS.powi(3);
        format!(
            "output.errors = true\nmaterials.m = {{ young = {young:?}, poisson = 0.3, density = {:?} }}\n{}{}{}{rest}",
            1.0 / THICKNESS,
            self.body([1.0; 2], [n; 2], THICKNESS),
            self.supports(condition),
            self.probe([1.0; 2], [0.5; 2], "")
        )
    }
}

pub(super) const STATICS: &str =
    "[analysis]\nkind = \"statics\"\nstop = { rule = \"energy\", tolerance = 1e-14 }\n";

/// Load of 0.001 per area, small enough for the linear theory.
fn uniform() -> String {
    format!("[[loads]]\nkind = \"surface_force\"\nbody = \"s\"\nforce = [0, 0, 1e-3]\n{STATICS}")
}

/// Asserts that the ratio of the estimated and the true error is within 0.3 and 3.
#[track_caller]
pub(super) fn assert_effective(what: &str, [value, error]: [f64; 2], exact: f64) {
    let effectivity = error / (exact - value);
    assert!((0.3..3.0).contains(&effectivity), "{what}: {value} + {error} for {exact}: {effectivity}");
}

/// Square plates under a uniform load: w D/(q a⁴) = 0.00126531909 (clamped), 0.00406235266 (hinged) in the centre.
#[test]
fn deflection_of_square_plates() {
    for (condition, exact) in [("clamped", 0.001_265_319_09), ("hinged", 0.004_062_352_66)] {
        let key = format!("condition = \"{condition}\"");
        for (shell, n) in [(Thin, 2), (Thin, 4), (Quadrilaterals, 4), (Quadrilaterals, 8), (Triangles, 8)] {
            let found = errors(&shell.plate(n, &key, &uniform()));
            let what = format!("{condition}, {shell:?}, {n}");
            assert_eq!(found.resolution, Resolution::Good, "{what}: {}", found.sentence());
            assert_effective(&what, of(&found, "p.z"), 1e-3 * exact);
        }
    }
}

/// Frequencies of a hinged square plate: ω = (i² + j²) π² √(D/ρh)/a².
#[test]
fn frequencies_of_a_square_plate() {
    let analysis = "[analysis]\nkind = \"modes\"\ncount = 4\n";
    for (shell, n) in [(Thin, 2), (Thin, 4), (Quadrilaterals, 6), (Quadrilaterals, 12), (Triangles, 12)] {
        let found = errors(&shell.plate(n, "condition = \"hinged\"", analysis));
        for (number, square) in [(1, 2.0), (2, 5.0), (4, 8.0)] {
            let what = format!("{shell:?}, {n}, mode {number}");
            assert_effective(&what, of(&found, &format!("frequency[{number}]")), square * PI * PI / TAU);
        }
    }
}

/// Uniaxial compression of a hinged square plate: N = 4 π² D/a².
#[test]
fn buckling_of_a_square_plate() {
    for (shell, n) in [(Thin, 2), (Thin, 4), (Quadrilaterals, 8), (Quadrilaterals, 12), (Triangles, 12)] {
        let guided = shell.supports("condition = \"guided\"\naxes = [\"z\"]");
        let guided = if shell == Thin { guided } else { guided.replace("[\"z\"]", "[\"z\"]\nhard = true") };
        let held =
            [("a", [1, 0], "x"), ("b", [1, 2], "x"), ("c", [0, 1], "y")].map(|(name, [i, j], axis)| {
                let [x, y] = [i, j].map(|k| 0.5 * f64::from(k));
                let node = j * n / 2 * (n + 1) + i * n / 2;
                let at =
                    if shell == Thin { format!("[{x:?}, {y:?}]") } else { format!("{{ node = {node} }}") };
                format!(
                    "[[joints]]\nkind = \"support\"\nname = \"{name}\"\na = {{ body = \"s\", at = {at} }}\n\
                 condition = \"guided\"\naxes = [\"{axis}\"]\n"
                )
            });
        let loads = [("left", 1.0), ("right", -1.0)].map(|(edge, force)| {
            let edge = shell.edge(edge).replace("{ edge = ", "").replace(" }", "");
            format!(
                "[[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = {edge}\nforce = [{force:?}, 0, 0]\n"
            )
        });
        let rest = format!("{}{}[analysis]\nkind = \"buckling\"\ncount = 1\n", held.concat(), loads.concat());
        let text = shell.plate(n, "SUPPORTS", &rest).replace(&shell.supports("SUPPORTS"), &guided);
        let found = errors(&text);
        assert_effective(
            &format!("{shell:?}, {n}: {}", found.sentence()),
            of(&found, "factor[1]"),
            4.0 * PI * PI,
        );
    }
}

/// Clamped strip of 10 × 1 × 0.1 under a dead end shear, with large rotations.
fn strip(shell: Shell, [n, m]: [u32; 2], force: f64) -> DiscretisationErrors {
    let sides = [10.0, 1.0];
    errors(&format!(
        "output.errors = true\nmaterials.m = {{ young = 1.2e6, poisson = 0.0, density = 1000 }}\n{}\
         [[joints]]\nkind = \"support\"\nname = \"root\"\na = {{ body = \"s\", at = {} }}\ncondition = \"clamped\"\n{}\
         [[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = {}\nforce = [0, 0, {force:?}]\n\
         [analysis]\nkind = \"statics\"\nfirst = 0.25\nstop = {{ rule = \"energy\", tolerance = 1e-14 }}\n",
        shell.body(sides, [n, m], 0.1),
        shell.edge("left"),
        shell.probe(sides, [10.0, 0.5], ""),
        shell.edge("right").replace("{ edge = ", "").replace(" }", ""),
    ))
}

/// End shear of 4 EI/L² bends the strip beyond 60 degrees. References are fine meshes.
#[test]
fn large_deflection_of_a_strip() {
    for (shell, meshes, fine) in [
        (Thin, [[2, 1], [4, 1]], [16, 2]),
        (Quadrilaterals, [[6, 2], [12, 2]], [96, 4]),
        (Triangles, [[8, 2], [16, 2]], [64, 8]),
    ] {
        let reference = strip(shell, fine, 4.0);
        for mesh in meshes {
            let found = strip(shell, mesh, 4.0);
            for column in ["p.x", "p.z"] {
                let [value, error] = of(&reference, column);
                let what = format!("{shell:?}, {mesh:?}, {column}: {}", found.sentence());
                assert_effective(&what, of(&found, column), value + error);
            }
        }
    }
}

/// Clamped edges of 2 × 2 elements with shear hold their only free node: the mesh does not resolve the shape.
#[test]
fn coarse_meshes_are_unresolved() {
    let model = |rest: &str| Quadrilaterals.plate(2, "condition = \"clamped\"", rest);
    for text in [model(&uniform()), model("[analysis]\nkind = \"modes\"\ncount = 1\n")] {
        let found = summary(&text);
        let own = found.errors.as_ref().unwrap();
        assert_eq!(own.resolution, Resolution::Unresolved);
        assert!(own.values.is_empty() && own.displacement.is_none() && own.eigenvalue.is_none(), "{own:?}");
        assert!(
            own.sentence().starts_with("mesh: not resolved: elements of half the size"),
            "{}",
            own.sentence()
        );
        assert!(found.warnings.contains(&own.sentence()), "{:?}", found.warnings);
    }
}

/// Quarter of the Scordelis-Lo roof under 0.001 of its weight: the free edge sinks by 0.300592 to 0.302 (MacNeal & Harder 1985).
#[test]
fn roof_between_diaphragms() {
    let half = 40.0_f64.to_radians();
    let on_cylinder = |[x, y]: [f64; 2]| [25.0 * (half * x).sin(), 25.0 * y, 25.0 * (half * x).cos()];
    for (shell, n, sag) in [(Thin, 2, 0.300_592), (Quadrilaterals, 4, 0.3013), (Quadrilaterals, 8, 0.3013)] {
        let body = if shell == Thin {
            let flat = "{ kind = \"flat\", corner = [0, 0, 0], side_u = [1.0, 0, 0], side_v = [0, 1.0, 0] }";
            let revolved = format!(
                "{{ kind = \"revolved\", from = [0, 0, 25], to = [0, 25, 25], center = [0, 0, 0], axis = [0, 1, 0], angle = {half} }}"
            );
            shell.body([1.0; 2], [n; 2], 0.25).replace(flat, &revolved)
        } else {
            shell.body_on([1.0; 2], [n; 2], 0.25, on_cylinder)
        };
        let support = |edge: &str, condition: &str| {
            let edge_of = shell.edge(edge);
            format!(
                "[[joints]]\nkind = \"support\"\nname = \"{edge}\"\na = {{ body = \"s\", at = {edge_of} }}\ncondition = {condition}\n"
            )
        };
        let [x, y, z] = on_cylinder([1.0, 0.0]);
        let at = if shell == Thin { "[1.0, 0.0]".into() } else { format!("[{x:?}, {y:?}, {z:?}]") };
        let found = errors(&format!(
            "output.errors = true\ngravity = [0, 0, -0.36]\nmaterials.m = {{ young = 4.32e8, poisson = 0.0, density = 1 }}\n{body}{}{}{}\
             [[probes]]\nname = \"p\"\non = {{ body = \"s\", at = {at} }}\n{STATICS}",
            support("left", "\"symmetry\""),
            support("front", "\"symmetry\""),
            support("back", "\"guided\"\naxes = [\"x\", \"z\"]"),
        ));
        assert_effective(&format!("{shell:?}, {n}"), of(&found, "p.z"), z - 1e-3 * sag);
    }
}
