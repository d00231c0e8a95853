//! Thickness and fibre directions that vary over shells of both kinds.

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::solutions::{Run, assert_same_columns};

/// Kind of the elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Thin,
    Quads,
    Triangles,
}

pub(super) const KINDS: [Kind; 3] = [Kind::Thin, Kind::Quads, Kind::Triangles];

/// Flat sheet `s` of the sides [a, b] in the plane z = 0 of a frame with a given origin.
pub(super) struct Sheet {
    pub(super) kind: Kind,
    pub(super) origin: [f64; 3],
    pub(super) sides: [f64; 2],
    pub(super) elements: [usize; 2],
}

impl Sheet {
    /// Unit square without a shift.
    pub(super) fn unit(kind: Kind, elements: [usize; 2]) -> Self {
        Self { kind, origin: [0.0; 3], sides: [1.0, 1.0], elements }
    }

    /// Text of the body with its keys.
    pub(super) fn body(&self, keys: &str) -> String {
        let Self { origin: [x, y, z], sides: [a, b], elements: [n, m], .. } = self;
        if self.kind == Kind::Thin {
            return format!(
                "[[bodies]]\nkind = \"shell\"\nname = \"s\"\nelements = [{n}, {m}]\nmaterial = \"m\"\n{keys}\n\
                 surface = {{ kind = \"flat\", corner = [{x:?}, {y:?}, {z:?}], side_u = [{a:?}, 0, 0], side_v = [0, {b:?}, 0] }}\n"
            );
        }
        let node = |i: usize, j: usize| j * (n + 1) + i;
        let places = (0..=*m).flat_map(|j| (0..=*n).map(move |i| [i, j]));
        let at = |[i, j]: [usize; 2]| [x + a * i as f64 / *n as f64, y + b * j as f64 / *m as f64, *z];
        let nodes: Vec<_> = places.map(at).collect();
        let cells = (0..*m).flat_map(|j| (0..*n).map(move |i| (i, j)));
        let faces: Vec<Vec<usize>> = cells
            .flat_map(|(i, j)| {
                let [a, b, c, d] = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
                if self.kind == Kind::Quads {
                    vec![vec![a, b, c, d]]
                } else {
                    vec![vec![a, b, c], vec![a, c, d]]
                }
            })
            .collect();
        let column = |i: usize| (0..=*m).map(|j| node(i, j)).collect::<Vec<_>>();
        format!(
            "[[bodies]]\nkind = \"shear_shell\"\nname = \"s\"\nmaterial = \"m\"\n{keys}\n\
             mesh = {{ nodes = {nodes:?}, elements = {faces:?}, groups = {{ u_start = {{ edges = [{:?}] }}, u_end = {{ edges = [{:?}] }} }} }}\n",
            column(0),
            column(*n)
        )
    }

    /// Place of a corner.
    pub(super) fn corner(&self, [u, v]: [usize; 2]) -> String {
        let [n, m] = self.elements;
        match self.kind {
            Kind::Thin => format!("{{ body = \"s\", at = [{u}, {v}] }}"),
            _ => format!("{{ body = \"s\", at = {{ node = {} }} }}", v * m * (n + 1) + u * n),
        }
    }
}

pub(super) const MATERIAL: &str = "materials.m = { density = 3, young = 1e6, poisson = 0 }\n";

pub(super) const CLAMP: &str = "[[joints]]\nkind = \"support\"\nname = \"c\"\na = { body = \"s\", at = { edge = \"u_start\" } }\ncondition = \"clamped\"\n";

/// Cantilever of the length 1 with a field as its thickness and a small transverse force per length at its end.
fn cantilever(sheet: &Sheet, thickness: &str) -> String {
    format!(
        "analysis = {{ kind = \"statics\" }}\n{MATERIAL}{}{CLAMP}\
         [[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = \"u_end\"\nforce = [0, 0, 1e-6]\n\
         [[probes]]\nname = \"p\"\non = {}\nrecord = [\"motion\"]\n",
        sheet.body(&format!("thickness = {thickness}")),
        sheet.corner([1, 0])
    )
}

/// Deflection 12 F/E ∫ (1 − x)²/h³ dx, and F/(5/6 G) ∫ dx/h by shear, of a strip with h = h₀ (1 − c x).
fn deflection([h0, c]: [f64; 2], with_shear: bool) -> f64 {
    let parts = 4000;
    let sum: f64 = (0..parts)
        .map(|k| {
            let x = (f64::from(k) + 0.5) / f64::from(parts);
            let h = h0 * (1.0 - c * x);
            let shear = if with_shear { 1.0 / (5.0 / 12.0 * 1e6 * h) } else { 0.0 };
            12.0 / 1e6 * (1.0 - x).powi(2) / h.powi(3) + shear
        })
        .sum();
    1e-6 * sum / f64::from(parts)
}

/// The deflection of a tapered strip converges to that of the beam: with the fourth power of the size of thin elements, the second of others.
#[test]
fn tapered_strips_deflect_as_beams() {
    for (kind, meshes, limit, order) in [
        (Kind::Thin, [4, 8, 16], 1e-5, 3.5),
        (Kind::Quads, [8, 16, 32], 2e-3, 1.9),
        (Kind::Triangles, [8, 16, 32], 6e-3, 1.7),
    ] {
        let exact = deflection([0.02, 0.6], kind != Kind::Thin);
        let errors = meshes.map(|n| {
            let sheet = Sheet { sides: [1.0, 0.25], ..Sheet::unit(kind, [n, n / 4]) };
            let text = cantilever(&sheet, "{ kind = \"expression\", text = \"0.02*(1 - 0.6*x)\" }");
            (Run::of(&parse(&text)).last("p.z") / exact - 1.0).abs()
        });
        assert!(errors[2] < limit, "{kind:?}: {errors:?}");
        let found = (errors[1] / errors[2]).log2();
        assert!(found > order, "{kind:?}: order {found}, {errors:?}");
    }
}

/// Motion of a loaded square with gravity, with resultants and stresses in the middle.
fn motion(kind: Kind, material: &str, keys: &str) -> Run {
    let sheet = Sheet::unit(kind, [2, 2]);
    let middle = if kind == Kind::Thin { "[0.5, 0.5]" } else { "{ node = 4 }" };
    Run::of(&parse(&format!(
        "gravity = [0, 0, -2]\nanalysis = {{ kind = \"dynamics\", duration = 0.02, step = 0.004 }}\n{material}{}{CLAMP}\
         [[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = \"u_end\"\nforce = [500, 30, 1]\n\
         [[probes]]\nname = \"p\"\non = {{ body = \"s\", at = {middle} }}\nrecord = [\"motion\", \"resultants\", \"surface_stress\"]\n",
        sheet.body(keys)
    )))
}

fn assert_equal(what: &str, runs: [&Run; 2]) {
    let excluded = ["iterations", "residual", "increment", "drift"];
    assert_same_columns(what, runs, &excluded, 1e-6, 1e-7);
}

const FIBRES: &str = "materials.m = { density = 3, young = 1e6, poisson = 0.3, orthotropic = { young = 2e5, shear = 1e5, transverse_shear = 8e4 } }\n";

/// A field that is constant gives the numbers of the constant thickness: for laminates with coupling and for rubber membranes.
#[test]
fn constant_fields_are_numbers() {
    let layers = "fibre_axis = [1, 0.2, 0]\nlayers = [{ angle = 0.2 }, { angle = 1.2 }]";
    let parts =
        "fibre_axis = [1, 0.2, 0]\nlayers = [{ angle = 0.2, thickness = 7 }, { angle = 1.2, thickness = 7 }]";
    let rubber = "membrane = { law = \"neo_hookean\" }";
    for (kind, material, keys, others) in [
        (Kind::Thin, FIBRES, layers, parts),
        (Kind::Quads, FIBRES, layers, parts),
        (Kind::Triangles, FIBRES, layers, parts),
        (Kind::Thin, MATERIAL, rubber, rubber),
    ] {
        let whole = motion(kind, material, &format!("thickness = 0.05\n{keys}"));
        for field in ["text = \"0.05\"", "text = \"0.05 + 0*x*y*z\"", "text = \"50 + 0*x\", unit = 0.001"] {
            let keys = format!("thickness = {{ kind = \"expression\", {field} }}\n{others}");
            assert_equal(&format!("{kind:?}, {field}"), [&whole, &motion(kind, material, &keys)]);
        }
    }
}

/// The angle turns all plies, as the axis does: as a number, as a field, and by an axis that is a field. Plies at 0.2 and 1.2 are those at
/// −0.1 and 0.9 turned by 0.3.
#[test]
fn turned_fibres_are_turned_plies() {
    for kind in KINDS {
        let plies = |angles: [f64; 2], keys: &str| {
            let [a, b] = angles;
            let keys =
                format!("thickness = 0.05\nlayers = [{{ angle = {a:?} }}, {{ angle = {b:?} }}]\n{keys}");
            motion(kind, FIBRES, &keys)
        };
        let whole = plies([0.2, 1.2], "fibre_axis = [1, 0, 0]");
        for keys in [
            "fibre_axis = [1, 0, 0]\nfibre_angle = 0.3",
            "fibre_axis = [1, 0, 0]\nfibre_angle = { kind = \"expression\", text = \"0.3 + 0*x\" }",
            "fibre_axis = { kind = \"expression\", text = [\"2*cos(0.3)\", \"2*sin(0.3)\", \"x\"] }",
            "fibre_axis = { kind = \"expression\", text = [\"1\", \"0\", \"0\"] }\nfibre_angle = 0.3",
        ] {
            // Stresses keep the frame of the fixed axis, which is x by default for this mesh.
            assert_equal(&format!("{kind:?}, {keys}"), [&whole, &plies([-0.1, 0.9], keys)]);
        }
    }
}

/// Values at nodes are the linear formula on a mesh of parallelograms and triangles; a finer mesh has the mean values.
#[test]
fn nodal_values_are_linear() {
    for kind in [Kind::Quads, Kind::Triangles] {
        let sheet = Sheet { sides: [1.0, 0.5], ..Sheet::unit(kind, [3, 2]) };
        let values: Vec<f64> = (0..3)
            .flat_map(|j| (0..4).map(move |i| 0.02 + 0.01 * f64::from(i) / 3.0 - 0.004 * f64::from(j)))
            .collect();
        let [formula, nodes] = [
            "{ kind = \"expression\", text = \"0.02 + 0.01*x - 0.016*y\" }".to_owned(),
            format!("{{ kind = \"nodes\", values = {values:?} }}"),
        ]
        .map(|field| {
            let text =
                cantilever(&sheet, &field).replacen("[[probes]]", "[output]\nerrors = true\n[[probes]]", 1);
            Run::of(&parse(&text))
        });
        for column in ["p.z", "p.z_error"] {
            let [formula, nodes] = [&formula, &nodes].map(|run| run.last(column));
            assert_relative(&format!("{kind:?}, {column}"), nodes, formula, 1e-6);
        }
    }
}

/// Neither the origin, nor the exchange of u and v, nor the units change the deflection.
#[test]
fn fields_are_independent_of_frame_and_units() {
    for kind in KINDS {
        let sheet = Sheet { sides: [1.0, 0.25], ..Sheet::unit(kind, [3, 2]) };
        let whole =
            Run::of(&parse(&cantilever(&sheet, "{ kind = \"expression\", text = \"0.02*(1 - 0.6*x)\" }")));
        let shifted =
            Sheet { origin: [70.0, -30.0, 5.0], ..Sheet { sides: [1.0, 0.25], ..Sheet::unit(kind, [3, 2]) } };
        let text = "{ kind = \"expression\", text = \"2*(1 - 0.006*(x - 7000))\", unit = 0.01 }";
        let moved = Run::of(&parse(&cantilever(&shifted, text)));
        assert_relative(&format!("{kind:?}"), moved.last("p.z") - 5.0, whole.last("p.z"), 1e-6);
        let text = cantilever(&sheet, "{ kind = \"expression\", text = \"0.02*(1 - 0.6*x)\" }");
        for scales in ["{ kind = \"auto\" }", "{ kind = \"given\", length = 0.03, force = 7 }"] {
            let run = Run::of(&parse(&format!("scales = {scales}\n{text}")));
            assert_relative(&format!("{kind:?}, {scales}"), run.last("p.z"), whole.last("p.z"), 1e-7);
        }
    }
    let text = cantilever(
        &Sheet { sides: [1.0, 0.25], ..Sheet::unit(Kind::Thin, [3, 2]) },
        "{ kind = \"expression\", text = \"0.02*(1 - 0.6*u)*(1 + 0.3*v)\" }",
    );
    let swapped = text
        .replace("side_u = [1.0, 0, 0], side_v = [0, 0.25, 0]", "side_v = [1.0, 0, 0], side_u = [0, 0.25, 0]")
        .replace("[3, 2]", "[2, 3]")
        .replace("0.6*u", "0.6*w")
        .replace("0.3*v", "0.3*u")
        .replace("0.6*w", "0.6*v")
        .replace("u_start", "v_start")
        .replace("\"u_end", "\"v_end")
        .replace("at = [1, 0]", "at = [0, 1]");
    let [a, b] = [text, swapped].map(|text| Run::of(&parse(&text)).last("p.z"));
    assert_relative("exchange of u and v", a, b, 1e-9);
}

/// Mass, and moment of inertia ρ ∫ h x² dA, by the kinetic energies of a translation and of a rotation.
#[test]
fn wedge_has_mass_and_inertia() {
    for kind in KINDS {
        let energy = |motion: &str| {
            let keys = format!(
                "thickness = {{ kind = \"expression\", text = \"0.01*(1 - 0.5*x)\" }}\nmotion = {motion}"
            );
            let model = parse(&format!(
                "analysis = {{ kind = \"dynamics\", duration = 1e-7, step = 1e-7 }}\n{MATERIAL}{}",
                Sheet::unit(kind, [2, 2]).body(&keys)
            ));
            assert_relative(&format!("{kind:?}, mass"), model.mass(), 0.03 * 0.75, 1e-12);
            Run::of(&model).column("kinetic")[0]
        };
        assert_relative(
            &format!("{kind:?}, translation"),
            energy("{ velocity = [0, 0, 2] }"),
            0.5 * 4.0 * 0.03 * 0.75,
            1e-12,
        );
        let inertia = 0.03 * (1.0 / 3.0 - 0.5 / 4.0);
        // Rotary inertia ρ h³/12 of shear-deformable shells.
        let rotary =
            if kind == Kind::Thin { 0.0 } else { 3.0 * 1e-6 / 12.0 * (1.0 - 0.5_f64.powi(4)) / (4.0 * 0.5) };
        let found = energy("{ spin = [0, 2, 0], about = [0, 0, 0] }");
        assert_relative(&format!("{kind:?}, rotation"), found, 0.5 * 4.0 * (inertia + rotary), 2e-6);
    }
}

/// A wedge of the density of the fluid has no weight in it.
#[test]
fn buoyancy_balances_the_weight() {
    for kind in KINDS {
        let sheet = Sheet::unit(kind, [3, 2]);
        let fluid =
            "[[loads]]\nkind = \"surface_fluid\"\nbody = \"s\"\ndensity = 3\ndrag = [0, 0]\n[[probes]]";
        let text = cantilever(&sheet, "{ kind = \"expression\", text = \"0.01*(1 - 0.5*x)\" }");
        let text =
            format!("gravity = [0, 0, -10]\n{}", text.replace("force = [0, 0, 1e-6]", "force = [0, 0, 0]"));
        let sag = Run::of(&parse(&text)).last("p.z");
        let afloat = Run::of(&parse(&text.replacen("[[probes]]", fluid, 1))).last("p.z");
        assert!(sag < -1e-2 && afloat.abs() < 1e-10, "{kind:?}: {sag} and {afloat}");
    }
}

/// A held wedge whose thicker half reaches into a plane: the force is k times the volume of the overlap, k ∫ 0.01 x dA.
#[test]
fn wedges_touch_planes_by_their_thickness() {
    for kind in KINDS {
        let sheet = Sheet::unit(kind, [1, 1]);
        let text = format!(
            "analysis = {{ kind = \"statics\" }}\n{}{}{CLAMP}{}\
             [[contacts]]\nsurface_stiffness = 1000\ntransition = 1e-9\n\
             with = {{ kind = \"plane\", point = [0, 0, -0.05], normal = [0, 0, 1] }}\n[[probes]]\nname = \"p\"\non = {}\n",
            MATERIAL.replace("1e6", "1e9"),
            sheet.body("thickness = { kind = \"expression\", text = \"0.1 + 0.02*x\" }"),
            CLAMP.replace("u_start", "u_end").replace("\"c\"", "\"d\""),
            sheet.corner([0, 0])
        );
        let run = Run::of(&parse(&text));
        assert_relative(&format!("{kind:?}"), run.last("c.fz") + run.last("d.fz"), -5.0, 1e-6);
    }
}

/// The stress at the face of a tapered strip under a moment is 6 m/h² of its place. The curvature at the nodes of thin elements of the
/// size Δ has the relative error Δ² κ''/(12 κ) = 4.4e-3 of cubic functions. Triangles have the stresses of their centroids, here at the
/// distance Δ/3: 2 Δ h'/(3 h) = 4.4e-2.
#[test]
fn stresses_have_the_local_thickness() {
    for (kind, tolerance) in [(Kind::Thin, 5e-3), (Kind::Quads, 2e-2), (Kind::Triangles, 5e-2)] {
        let sheet = Sheet { sides: [1.0, 0.1], ..Sheet::unit(kind, [10, 1]) };
        let text = cantilever(&sheet, "{ kind = \"expression\", text = \"0.02*(1 - 0.5*x)\" }")
            .replace("edge_force", "edge_moment")
            .replace("force = [0, 0, 1e-6]", "moment = [0, 1e-4, 0]");
        let middle = if kind == Kind::Thin { "[0.5, 0]" } else { "{ node = 5 }" };
        let text = format!(
            "{text}[[probes]]\nname = \"m\"\non = {{ body = \"s\", at = {middle} }}\nrecord = [\"surface_stress\"]\n"
        );
        let run = Run::of(&parse(&text));
        let found = run.last("m.suu_top");
        assert_relative(&format!("{kind:?}"), found.abs(), 6e-4 / 0.015_f64.powi(2), tolerance);
    }
}
