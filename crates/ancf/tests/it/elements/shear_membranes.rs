//! Laws of the membrane of shear-deformable shells on distorted meshes.

use ancf::Model;

use crate::common::assertions::{assert_near, assert_relative};
use crate::common::models::parse;
use crate::common::solutions::Run;
use crate::errors::shells::Shell::{self, Quadrilaterals, Thin, Triangles};

/// Square of side 1 and thickness 0.01 with E = 3 of 3 × 3 elements with moved inner nodes, free to contract unless `width` is fixed.
/// The right and the back edge are pulled by forces per length.
pub(super) fn sheet(kind: Shell, membrane: &str, [right, back]: [f64; 2], is_width_fixed: bool) -> String {
    let distorted = |[x, y]: [f64; 2]| {
        let inner = x * (1.0 - x) * y * (1.0 - y);
        [x + (1.3 * y - 0.4) * inner, y + (0.9 - 1.7 * x) * inner, 0.0]
    };
    let support = |name: &str, condition: &str| {
        format!(
            "[[joints]]\nkind = \"support\"\nname = \"{name}\"\na = {{ body = \"s\", at = {} }}\n{condition}\n",
            kind.edge(name)
        )
    };
    let load = |edge: &str, force: [f64; 3]| {
        let edge = kind.edge(edge).replace("{ ", "").replace(" }", "");
        format!("[[loads]]\nkind = \"edge_force\"\nbody = \"s\"\n{edge}\nforce = {force:?}\n")
    };
    let axes = if is_width_fixed { "[\"y\", \"z\"]" } else { "[\"z\"]" };
    [
        "analysis = { kind = \"statics\", stop = { rule = \"energy\", tolerance = 1e-20 } }\n\
         materials.m = { density = 1, young = 3, poisson = 0.3 }\n"
            .into(),
        kind.body_on([1.0; 2], [3; 2], 0.01, distorted),
        format!("fibre_axis = [1, 0, 0]\nmembrane = {membrane}\n").replace("membrane = none\n", ""),
        support("left", "condition = \"symmetry\""),
        support("front", "condition = \"symmetry\""),
        support("right", "condition = \"guided\"\naxes = [\"z\"]"),
        support("back", &format!("condition = \"guided\"\naxes = {axes}")),
        load("right", [right, 0.0, 0.0]),
        load("back", [0.0, back, 0.0]),
        kind.probe([1.0; 2], [1.0; 2], "record = [\"motion\", \"resultants\", \"surface_stress\"]"),
    ]
    .concat()
}

const RUBBER: &str = "{ law = \"neo_hookean\" }";

/// Forces of second Piola-Kirchhoff, stretches and energy of uniform states of rubber are exact on any mesh: uniaxial tension, tension in
/// both directions, and pure shear with a fixed width.
#[test]
fn uniform_states_of_rubber_are_exact() {
    for (kind, stretch) in
        [Quadrilaterals, Triangles].into_iter().flat_map(|k| [(k, 1.1), (k, 2.0), (k, 6.0_f64)])
    {
        let force = |own: f64, other: f64| 0.01 * (own - own.powi(-3) * other.powi(-2));
        let narrow = stretch.powf(-0.5);
        for (other, back, is_width_fixed) in
            [(narrow, 0.0, false), (stretch, force(stretch, stretch), false), (1.0, 0.0, true)]
        {
            let right = force(stretch, other);
            let run = Run::of(&parse(&sheet(kind, RUBBER, [right, back], is_width_fixed)));
            let what = |name: &str| format!("{name}, {kind:?}, stretches {stretch} and {other}");
            assert_relative(&what("length"), run.last("p.x"), stretch, 1e-11);
            assert_relative(&what("width"), run.last("p.y"), other, 1e-11);
            assert_near(&what("warping"), run.last("p.z"), 0.0, 1e-12);
            assert_relative(&what("force along"), run.last("p.nuu"), right / stretch, 1e-10);
            let across = force(other, stretch) / other;
            assert!((run.last("p.nvv") - across).abs() < 1e-12, "{}", what("force across"));
            assert_relative(&what("stress"), run.last("p.suu_middle"), right / stretch / 0.01, 1e-10);
            let energy = 0.005 * (stretch.powi(2) + other.powi(2) + (stretch * other).powi(-2) - 3.0);
            assert_relative(&what("energy"), run.last("strain"), energy, 1e-10);
        }
    }
}

/// A linear law with the stated key is that without it for triangles; quadrilaterals have enhanced strains without it, which vanish in
/// uniform states.
#[test]
fn tension_fields_in_tension_are_linear() {
    for kind in [Thin, Quadrilaterals, Triangles] {
        let of = |membrane: &str| Run::of(&parse(&sheet(kind, membrane, [1e-3, 1e-3], false))).last("p.x");
        assert_relative("length", of("{ tension_field = true }"), of("none"), 1e-11);
    }
}

/// Work, momenta and energy of a free sheet of rubber that is thrown with a stretch, by the energy-momentum scheme.
#[test]
fn motions_of_rubber_preserve_energy() {
    for (kind, membrane) in [Quadrilaterals, Triangles]
        .into_iter()
        .flat_map(|kind| [RUBBER, "{ tension_field = true, slack = 0.1 }"].map(|law| (kind, law)))
    {
        let text = sheet(kind, membrane, [0.02, 0.005], false).replace(
            "kind = \"statics\", stop = { rule = \"energy\", tolerance = 1e-20 }",
            "kind = \"dynamics\", duration = 3, step = 0.05, scheme = \"energy\", stop = { rule = \"energy\", tolerance = 1e-16 }",
        );
        let run = Run::of(&parse(&text));
        assert!(run.largest("p.x") > 1.3, "{kind:?}, {membrane}: {}", run.largest("p.x"));
        assert!(run.energy_error() < 1e-10, "{kind:?}, {membrane}: {:e}", run.energy_error());
    }
}

/// The key requires one isotropic material.
#[test]
fn wrong_membranes_of_shear_deformable_shells_are_rejected() {
    let text = sheet(Quadrilaterals, RUBBER, [0.01, 0.0], false);
    for (part, other, key) in [
        ("thickness", "layers = [{ angle = 0 }, { angle = 1 }]\nthickness", "bodies[0].membrane"),
        (
            "young = 3, poisson = 0.3",
            "young = 3, poisson = 0.3, orthotropic = { young = 2, shear = 1, transverse_shear = [1, 1] }",
            "bodies[0].membrane",
        ),
        ("\"neo_hookean\"", "\"rubber\"", "bodies[0].membrane.law"),
        ("\"neo_hookean\"", "\"linear\", slack = 1e-3", "bodies[0].membrane.slack"),
        ("\"neo_hookean\"", "\"linear\", tension_field = true, slack = 0", "bodies[0].membrane.slack"),
        ("\"neo_hookean\"", "\"linear\", tension_field = true, slack = -1e-3", "bodies[0].membrane.slack"),
    ] {
        let error = Model::parse(&text.replacen(part, other, 1)).unwrap_err().to_string();
        assert!(error.contains(key), "{other}: {error}");
    }
}
