//! Shear-deformable shells touch beams and themselves, at kinks of their meshes.

use ancf::record::Series;
use ancf::{Model, Scales};

use super::models::{CONTACT, Elements, clamps, last, mesh, run_model, sheet};
use crate::common::assertions::{assert_near, assert_relative};
use crate::common::models::parse;
use Elements::{Quads, Triangles};

/// A beam comes to rest in a valley between two inclined plates, one mesh with a kink: each side carries W/(2 cos α).
#[test]
fn beams_rest_in_a_valley() {
    for (kind, angle) in [(Quads, 20.0_f64), (Quads, 15.0), (Triangles, 20.0)] {
        let (sine, cosine) = angle.to_radians().sin_cos();
        let surface = |u: f64, v: f64| {
            let y = 0.4 * (v - 0.5);
            [0.4 * u, y * cosine, y.abs() * sine]
        };
        let height = 0.015 / cosine + 5e-4;
        let text = format!(
            "gravity = [0, 0, -10]\nmaterials.stiff = {{ density = 1, young = 1e12 }}\n\
             materials.soft = {{ density = 1000, young = 1e8, damping = {{ strain = 2e-3, mass = 20 }} }}\n\
             sections.r = {{ kind = \"circle\", diameter = 0.02 }}\n{}{}\
             [[bodies]]\nkind = \"beam\"\nname = \"b\"\nfrom = [0.1, 0.001, {height}]\nto = [0.3, 0.001, {height}]\nup = [0, 0, 1]\n\
             elements = 2\nsection = \"r\"\nmaterial = \"soft\"\n\
             [[contacts]]\nwith = {{ kind = \"bodies\" }}\nsurface_stiffness = 4e7\nstiffness = 1e5\ndamping = 5\ntransition = 1e-6\n\
             [[probes]]\nname = \"p\"\non = {{ body = \"b\", at = 0.1 }}\n\
             [analysis]\nkind = \"dynamics\"\nduration = 1\nstep = 2e-3\nscheme = {{ spectral_radius = 0.3 }}\n",
            mesh(kind, "v", [2, 4], "thickness = 0.01\nmaterial = \"stiff\"", surface),
            clamps("v")
        );
        let series = run_model(&parse(&text));
        let weight = 1000.0 * std::f64::consts::PI * 1e-4 * 10.0;
        let depth = 0.5 * weight / cosine / 1e5 + 0.5e-6;
        assert_near("z", last(&series, "p.z"), (0.015 - depth) / cosine, 2e-7);
        assert_near("y", last(&series, "p.y"), 0.0, 2e-5);
    }
}

/// A strip compressed by an eighth, with elements as long as its thickness, does not touch its own elements.
#[test]
fn compressed_strips_do_not_touch_themselves() {
    for kind in [Quads, Triangles] {
        let [with, without] = [true, false].map(|has_contact| {
            let keys = "thickness = 0.01\nmaterial = \"m\"";
            let contact = if has_contact { CONTACT } else { "" };
            let text = format!(
                "materials.m = {{ density = 1000, young = 1e6, poisson = 0 }}\n{}\
                 [[joints]]\nkind = \"support\"\nname = \"a\"\na = {{ body = \"s\", at = {{ edge = \"u_start\" }} }}\ncondition = \"clamped\"\n\
                 [[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = \"u_end\"\nforce = [-1200, 0, 0]\n{contact}\
                 [[probes]]\nname = \"p\"\non = {{ body = \"s\", at = {{ node = 6 }} }}\n\
                 [analysis]\nkind = \"statics\"\n",
                sheet(kind, "s", ([0.0; 3], [0.063, 0.021]), [6, 2], keys)
            );
            last(&run_model(&parse(&text)), "p.x")
        });
        assert!(with < 0.875 * 0.063, "{with}");
        assert_relative("x", with, without, 1e-10);
    }
}

/// A strip of the shape of a C is pressed together until its free edge lies on itself.
fn closing_strip(kind: Elements) -> Model {
    let r = |u: f64, v: f64| {
        let (sine, cosine) = (2.9 * u).sin_cos();
        [0.1 * sine, 0.05 * v, 0.1 - 0.1 * cosine]
    };
    let probes = (0..=20)
        .map(|k| format!("[[probes]]\nname = \"p{k}\"\non = {{ body = \"c\", at = {{ node = {k} }} }}\n"));
    parse(&format!(
        "materials.m = {{ density = 1000, young = 2e6, damping = {{ strain = 2e-2 }} }}\n{}\
         [[joints]]\nkind = \"support\"\nname = \"held\"\na = {{ body = \"c\", at = {{ edge = \"u_start\" }} }}\ncondition = \"clamped\"\n\
         [[loads]]\nkind = \"edge_force\"\nbody = \"c\"\nedge = \"u_end\"\nforce = [1, 0, -2]\ntime = {{ kind = \"ramp\", end = 0.2 }}\n\
         [[contacts]]\nwith = {{ kind = \"bodies\" }}\nsurface_stiffness = 4e7\ndamping = 2\n{}\
         [analysis]\nkind = \"dynamics\"\nduration = 0.5\nstep = 2e-3\nscheme = {{ spectral_radius = 0.6 }}\n",
        mesh(kind, "c", [20, 2], "thickness = 0.004\nmaterial = \"m\"", r),
        probes.collect::<String>()
    ))
}

/// The end of the strip never comes nearer to its first part than its thickness, up to the depth of the impact, in any units.
#[test]
fn strips_touch_themselves() {
    let of = |series: &Series, name: &str| {
        ["x", "z"].map(|axis| series.column(&format!("{name}.{axis}")).unwrap().to_vec())
    };
    let model = closing_strip(Quads);
    let series = run_model(&model);
    let end = of(&series, "p20");
    // Distance of the end from the chords of the first half.
    let mut least = f64::INFINITY;
    for k in 0..10 {
        let [a, b] = [k, k + 1].map(|k| of(&series, &format!("p{k}")));
        for t in 0..end[0].len() {
            let at = |x: &[Vec<f64>; 2]| nalgebra::Vector2::new(x[0][t], x[1][t]);
            let (edge, gap) = (at(&b) - at(&a), at(&end) - at(&a));
            let along = (gap.dot(&edge) / edge.norm_squared()).clamp(0.0, 1.0);
            least = least.min((gap - edge * along).norm());
        }
    }
    assert!(least > 0.003 && least < 0.0044, "{least}");
    let mut free = model.clone();
    free.contacts.clear();
    assert!(last(&run_model(&free), "p20.z") < last(&series, "p20.z") - 0.01);
    let units = Scales { length: 0.037, time: 13.0, force: 2.9e5 };
    let other = run_model(&model.scaled(&units));
    for column in ["p20.x", "p20.z"] {
        assert_near(column, last(&other, column) * units.length, last(&series, column), 1e-8);
    }
}
