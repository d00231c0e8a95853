//! Modes of a beam on a rigid body that is clamped to the ground.

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::random::Random;
use crate::common::solutions::Run;

/// Tapered beam from the ground, or from a body with a mass and a factor of its inertia.
fn beam(body: Option<[f64; 2]>) -> Run {
    let hub = body.map_or_else(String::new, |[mass, factor]| {
        let [x, y, z] = [0.00714, 0.00673, 0.0126].map(|inertia| inertia * factor);
        format!(
            "[[bodies]]\nkind = \"rigid\"\nname = \"hub\"\ncenter = [0, 0.07724, 0]\nmass = {mass}\ninertia = [{x}, {y}, {z}]\n\
             [[joints]]\nkind = \"clamp\"\nname = \"hub\"\na = {{ body = \"hub\", at = [0, 0, 0] }}\n"
        )
    });
    let to = if body.is_some() { "b = { body = \"hub\", at = \"center\" }\n" } else { "" };
    Run::of(&parse(&format!(
        "materials.m = {{ density = 2717, young = 26280000, poisson = 0.45 }}\n\
         sections.a = {{ kind = \"rectangle\", height = 0.08611, width = 0.0471 }}\n\
         sections.b = {{ kind = \"rectangle\", height = 0.06121, width = 0.03348 }}\n{hub}\
         [[bodies]]\nkind = \"beam\"\nname = \"b\"\nfrom = [0, 0.07724, 0]\nto = [-0.2377, 0.13967, 0.2202]\nelements = 1\n\
         formulation = \"continuum\"\nslopes = \"length\"\nsection = \"a\"\nsection_end = \"b\"\nmaterial = \"m\"\n\
         [[joints]]\nkind = \"clamp\"\nname = \"root\"\na = {{ body = \"b\", at = \"start\" }}\n{to}\
         [analysis]\nkind = \"modes\"\ncount = 4\n"
    )))
}

/// The body is ground. The pivots of its position are those of its mass alone, which are small: for one body in five, a single
/// correction of the constraints left errors of 1e-6.
#[test]
fn a_clamped_body_is_ground() {
    let (reference, mut random) = (beam(None), Random(5));
    for _ in 0..20 {
        let body = [2.0 + 1.5 * random.number(), 1.25 + 0.75 * random.number()];
        let found = beam(Some(body));
        for k in 0..4 {
            let [own, expected] = [&found, &reference].map(|run| run.column("squared")[k]);
            assert_relative(&format!("{body:?}: squared {k}"), own, expected, 1e-10);
        }
        let largest = found.column("residual").iter().fold(0.0_f64, |a, b| a.max(*b));
        assert!(largest < 1e-9, "{body:?}: {largest:e}");
    }
}
