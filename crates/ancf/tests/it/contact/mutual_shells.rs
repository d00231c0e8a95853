//! Shells touch each other, themselves, beams and cables.

use ancf::model::{At, Place, Probe};
use ancf::record::Series;
use ancf::{Model, Scales};

use super::models::{CONTACT, Elements, MATERIALS, clamps, last, mesh, middle, run_model, sheet, table};
use crate::common::assertions::assert_near;
use crate::common::models::parse;
use Elements::{Quads, Thin, Triangles};

/// A sheet on a plate is deeper by ρ h g = k (d − δ/2), for both orders of the bodies.
#[test]
fn sheets_rest_on_a_plate() {
    let keys = "thickness = 0.01\nmaterial = \"soft\"";
    let upper = sheet(Thin, "sheet", ([-0.15, -0.1, 0.0155], [0.3, 0.2]), [3, 2], keys);
    for (first, second) in [(table(Thin), upper.clone()), (upper, table(Thin))] {
        let text = format!(
            "gravity = [0, 0, -10]\n{MATERIALS}{first}{second}{CONTACT}damping = 10\n\
             [[probes]]\nname = \"p\"\non = {{ body = \"sheet\", at = [0.4, 0.7] }}\n\
             [analysis]\nkind = \"dynamics\"\nduration = 0.5\nstep = 1e-3\nscheme = {{ spectral_radius = 0.6 }}\n"
        );
        let depth = 1000.0 * 0.01 * 10.0 / 4e6 + 0.5e-5;
        assert_near("z", last(&run_model(&parse(&text)), "p.z"), 0.015 - depth, 1e-6);
    }
}

/// A sheet slides over the edges and nodes of the elements of a plate without resistance, at the depth d with ρ h g = k (d − δ/2),
/// and with friction it is decelerated by μ g.
#[test]
fn sheets_slide_on_a_plate() {
    let depth = 1000.0 * 0.01 * 10.0 / 4e6 + 0.5e-5;
    let motion = "thickness = 0.01\nmaterial = \"soft\"\nmotion = { velocity = [0.6, 0.05, 0] }";
    let energy = "scheme = \"energy\"\n";
    for (below, above, friction, scheme) in [
        (Thin, Thin, 0.0, ""),
        (Thin, Thin, 0.2, ""),
        (Thin, Thin, 0.0, energy),
        (Quads, Thin, 0.0, ""),
        (Thin, Quads, 0.0, ""),
        (Triangles, Quads, 0.0, ""),
        (Quads, Triangles, 0.2, ""),
    ] {
        let upper = sheet(above, "p", ([-0.25, -0.13, 0.015 - depth], [0.2, 0.2]), [2, 2], motion);
        let text = format!(
            "gravity = [0, 0, -10]\n{MATERIALS}{}{upper}{CONTACT}friction = {friction}\nslip_speed = 1e-4\n{}\
             [analysis]\nkind = \"dynamics\"\nduration = 0.2\nstep = 1e-3\n{scheme}",
            table(below),
            middle(above, "p")
        );
        let series = run_model(&parse(&text));
        let speed = f64::hypot(0.6, 0.05);
        let (way, factor) = (speed * 0.2 - 0.5 * friction * 10.0 * 0.04, 0.6 / speed);
        assert_near("x", last(&series, "p.x") + 0.15, way * factor, 1e-4 + 2e-3 * friction);
        let expected = (speed - friction * 2.0) * factor;
        assert_near("v", last(&series, "p.vx"), expected, 2e-3 + 1e-2 * friction);
        assert_near("z", last(&series, "p.z"), 0.015 - depth, 2e-5);
    }
}

/// A sheet slides down a plate whose half thickness e rises by s per length: its surface has the angle θ with sin θ = s to the middle surface.
/// The acceleration is g sin θ along the slope, and the depth that under ρ h g cos θ.
#[test]
fn sheets_slide_down_wedges() {
    let (s, thickness) = (0.1, 0.004);
    let cos = f64::sqrt(1.0 - s * s);
    let depth = 1000.0 * thickness * 10.0 * cos / 4e6 + 0.5e-5;
    let height = |x: f64| (0.01 + s * (x + 0.3) + 0.5 * thickness - depth) / cos;
    let wedge =
        "thickness = { kind = \"expression\", text = \"2*(0.01 + 0.1*(x + 0.3))\" }\nmaterial = \"stiff\"";
    let keys = format!("thickness = {thickness}\nmaterial = \"soft\"");
    for (below, above) in [(Thin, Thin), (Quads, Thin), (Thin, Quads), (Triangles, Quads), (Quads, Triangles)]
    {
        let ([x, y], [a, b]) = ([-0.03, -0.13], [0.2, 0.2]);
        let upper = match above {
            Thin => format!(
                "[[bodies]]\nkind = \"shell\"\nname = \"p\"\nelements = [2, 2]\n{keys}\n\
                 surface = {{ kind = \"flat\", corner = [{x}, {y}, {}], side_u = [{}, 0, {}], side_v = [0, {b}, 0] }}\n",
                height(x),
                a * cos,
                a * s
            ),
            _ => mesh(above, "p", [2, 2], &keys, |u, v| {
                let x = x + a * cos * u;
                [x, y + b * v, height(x)]
            }),
        };
        let lower = sheet(below, "table", ([-0.3, -0.3, 0.0], [0.6, 0.6]), [4, 3], wedge) + &clamps("table");
        let text = format!(
            "gravity = [0, 0, -10]\n{MATERIALS}{lower}{upper}{CONTACT}{}\
             [analysis]\nkind = \"dynamics\"\nduration = 0.2\nstep = 1e-3\n",
            middle(above, "p")
        );
        let series = run_model(&parse(&text));
        let x = series.column("p.x").unwrap();
        let way = 0.5 * 10.0 * s * 0.04;
        let what = format!("{below:?}, {above:?}");
        assert_near(&format!("x, {what}"), x.last().unwrap() - x[0], -way * cos, 1e-4);
        assert_near(&format!("z, {what}"), last(&series, "p.z"), height(*x.last().unwrap()), 2e-5);
    }
}

/// Two free sheets collide, frictionless: momentum, angular momentum and, in the energy scheme, energy are kept.
#[test]
fn collisions_keep_momentum_and_energy() {
    let keys = |velocity: &str| {
        format!("thickness = 0.01\nmaterial = \"elastic\"\nmotion = {{ velocity = {velocity} }}")
    };
    for (below, above) in [(Thin, Thin), (Quads, Quads), (Triangles, Thin)] {
        let text = format!(
            "materials.elastic = {{ density = 1000, young = 1e6 }}\n{}{}{CONTACT}\
             [output]\nmomentum = true\n[analysis]\nkind = \"dynamics\"\nduration = 0.03\nstep = 5e-4\nscheme = \"energy\"\n",
            sheet(below, "a", ([0.0, 0.0, 0.0], [0.4, 0.3]), [4, 3], &keys("[0, 0, 0.5]")),
            sheet(above, "b", ([0.25, 0.11, 0.013], [0.35, 0.4]), [3, 4], &keys("[0.3, -0.2, -1]")),
        );
        let series = run_model(&parse(&text));
        for column in ["px", "py", "pz", "lx", "ly", "lz"] {
            let values = series.column(column).unwrap();
            assert_near(column, values.last().unwrap() - values[0], 0.0, 1e-9);
        }
        let pz = series.column("a.pz").unwrap();
        assert!((pz.last().unwrap() - pz[0]).abs() > 0.2, "{:?}", pz.last());
        let change = series.column("balance").unwrap().iter().map(|x| x.abs()).fold(0.0, f64::max);
        let tolerance = if below == Thin { 1e-8 } else { 1e-6 };
        assert!(change < tolerance, "{below:?} {above:?}: {change:e}");
    }
}

/// A cable on a plate lies as on the plane of its upper side.
#[test]
fn cables_lie_on_plates_as_on_planes() {
    let cable = "[[bodies]]\nkind = \"cable\"\nname = \"c\"\nfrom = [-0.25, -0.2, 0.03]\nto = [0.25, 0.21, 0.03]\nelements = 12\n\
                 section = \"r\"\nmaterial = \"soft\"\n\
                 [[joints]]\nkind = \"spherical\"\nname = \"a\"\na = { body = \"c\", at = \"start\" }\n\
                 [[joints]]\nkind = \"spherical\"\nname = \"b\"\na = { body = \"c\", at = \"end\" }\n\
                 [[probes]]\nname = \"p\"\non = { body = \"c\", at = 0.3 }\n";
    let on = |partner: &str, bodies: &str| {
        let text = format!(
            "gravity = [0, 0, -10]\n{MATERIALS}sections.r = {{ kind = \"circle\", diameter = 0.01 }}\n{bodies}{cable}\
             [[contacts]]\nwith = {{ {partner} }}\nstiffness = 1e4\npoints = 6\ntransition = 1e-4\n{}\
             [analysis]\nkind = \"statics\"\n",
            if bodies.is_empty() { "" } else { "surface_stiffness = 1e6\n" }
        );
        run_model(&parse(&text))
    };
    let on_plane = on("kind = \"plane\", point = [0, 0, 0.01], normal = [0, 0, 1]", "");
    assert!(last(&on_plane, "p.z") < 0.0151, "{}", last(&on_plane, "p.z"));
    for kind in [Thin, Quads, Triangles] {
        let on_plate = on("kind = \"bodies\"", &table(kind));
        for column in ["p.x", "p.y", "p.z"] {
            assert_near(column, last(&on_plate, column), last(&on_plane, column), 1e-7);
        }
    }
}

/// A strip of the shape of a C is pressed together until its free edge lies on itself.
fn closing_strip() -> Model {
    parse(
        r#"
        materials.m = { density = 1000, young = 2e6, damping = { strain = 2e-2 } }
        [[bodies]]
        kind = "shell"
        name = "c"
        thickness = 0.004
        material = "m"
        elements = [8, 1]
        surface = { kind = "revolved", from = [0, 0, 0], to = [0, 0.05, 0], center = [0, 0, 0.1], axis = [0, -1, 0], angle = 2.9 }
        [[joints]]
        kind = "support"
        name = "held"
        a = { body = "c", at = { edge = "u_start" } }
        condition = "clamped"
        [[loads]]
        kind = "edge_force"
        body = "c"
        edge = "u_end"
        force = [1, 0, -2]
        time = { kind = "ramp", end = 0.2 }
        [[contacts]]
        with = { kind = "bodies" }
        surface_stiffness = 4e6
        damping = 2
        [[probes]]
        name = "end"
        on = { body = "c", at = [1, 0.5] }
        [analysis]
        kind = "dynamics"
        duration = 0.5
        step = 2e-3
        scheme = { spectral_radius = 0.6 }
        "#,
    )
}

/// The end of the strip never comes nearer to its first part than its thickness, up to the depth of the impact.
#[test]
fn strips_touch_themselves() {
    let mut model = closing_strip();
    model.contacts[0].surface_stiffness = Some(4e7);
    for k in 0..=40 {
        let at = At::Surface([0.01 * f64::from(k), 0.5]);
        model.probes.push(Probe::of_motion(&format!("p{k}"), Place::new("c", at)));
    }
    let distance = |series: &Series| {
        let of =
            |name: &str| ["x", "z"].map(|axis| series.column(&format!("{name}.{axis}")).unwrap().to_vec());
        let end = of("end");
        let between = |other: [Vec<f64>; 2]| {
            let each =
                (0..end[0].len()).map(|t| f64::hypot(other[0][t] - end[0][t], other[1][t] - end[1][t]));
            each.fold(f64::INFINITY, f64::min)
        };
        (0..=40).map(|k| between(of(&format!("p{k}")))).fold(f64::INFINITY, f64::min)
    };
    let series = run_model(&model);
    assert!(distance(&series) > 0.0034 && distance(&series) < 0.0044, "{}", distance(&series));
    model.contacts.clear();
    let free = run_model(&model);
    assert!(last(&free, "end.z") < last(&series, "end.z") - 0.02);
}

/// Lengths, times and forces in other units, including default values.
#[test]
fn units_do_not_change_the_contact_of_shells() {
    let mut model = closing_strip();
    model.analysis.dynamics_mut().unwrap().duration = 0.3;
    let units = Scales { length: 0.037, time: 13.0, force: 2.9e5 };
    let (a, b) = (run_model(&model), run_model(&model.scaled(&units)));
    for column in ["end.x", "end.z"] {
        assert_near(column, last(&b, column) * units.length, last(&a, column), 1e-8);
    }
}

/// A sheet that flies towards another one by several thicknesses in a step does not pass through it.
#[test]
fn fast_sheets_do_not_pass_through() {
    let keys = |velocity: &str| {
        format!("thickness = 0.002\nmaterial = \"soft\"\nmotion = {{ velocity = {velocity} }}")
    };
    for (below, above) in [(Thin, Thin), (Quads, Triangles), (Thin, Quads)] {
        let text = format!(
            "{MATERIALS}{}{}{}{}{}[analysis]\nkind = \"dynamics\"\nduration = 0.012\nstep = 5e-4\n",
            sheet(below, "a", ([0.0, 0.0, 0.0], [0.2, 0.2]), [2, 2], &keys("[0, 0, 10]")),
            sheet(above, "b", ([0.01, 0.02, 0.0323], [0.2, 0.2]), [2, 2], &keys("[0, 0, -10]")),
            CONTACT.replace("4e6", "1e9"),
            middle(below, "a"),
            middle(above, "b")
        );
        let series = run_model(&parse(&text));
        let [a, b] = ["a.z", "b.z"].map(|name| last(&series, name));
        assert!(b > a, "{a} {b}");
    }
}
