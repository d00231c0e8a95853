//! Thin shells touch each other, themselves, beams and cables.

use ancf::model::{At, Place, Probe};
use ancf::record::Series;
use ancf::{Model, Scales, simulate};

use crate::common::assertions::assert_near;

fn run_model(model: &Model) -> Series {
    let mut series = Series::new();
    let summary = simulate(model, &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    series
}

fn parse(text: &str) -> Model {
    Model::parse(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn last(series: &Series, name: &str) -> f64 {
    *series.column(name).unwrap_or_else(|| panic!("no column {name}")).last().unwrap()
}

/// A flat shell over the rectangle from a corner with sides along x and y.
fn sheet(name: &str, corner: [f64; 3], sides: [f64; 2], elements: [u32; 2], keys: &str) -> String {
    let [a, b] = sides;
    format!(
        "[[bodies]]\nkind = \"shell\"\nname = \"{name}\"\nelements = {elements:?}\n{keys}\n\
         surface = {{ kind = \"flat\", corner = {corner:?}, side_u = [{a}, 0, 0], side_v = [0, {b}, 0] }}\n"
    )
}

/// A stiff plate from −0.3 to 0.3 in both directions at z = 0, 0.02 thick and held at two edges.
fn table() -> String {
    let keys = "thickness = 0.02\nmaterial = \"stiff\"";
    let support = |edge: &str| {
        format!(
            "[[joints]]\nkind = \"support\"\nname = \"{edge}\"\na = {{ body = \"table\", at = {{ edge = \"{edge}\" }} }}\n\
             condition = \"clamped\"\n"
        )
    };
    let plate = sheet("table", [-0.3, -0.3, 0.0], [0.6, 0.6], [4, 3], keys);
    format!("{plate}{}{}", support("u_start"), support("u_end"))
}

const MATERIALS: &str = "materials.stiff = { density = 1, young = 1e12 }\n\
                         materials.soft = { density = 1000, young = 1e6, damping = { strain = 2e-3 } }\n";
const CONTACT: &str =
    "[[contacts]]\nwith = { kind = \"bodies\" }\nsurface_stiffness = 4e6\ntransition = 1e-5\n";

/// A sheet on a plate is deeper by ρ h g = k (d − δ/2), for both orders of the bodies.
#[test]
fn sheets_rest_on_a_plate() {
    let upper =
        sheet("sheet", [-0.15, -0.1, 0.0155], [0.3, 0.2], [3, 2], "thickness = 0.01\nmaterial = \"soft\"");
    for (first, second) in [(table(), upper.clone()), (upper, table())] {
        let text = format!(
            "gravity = [0, 0, -10]\n{MATERIALS}{first}{second}{CONTACT}damping = 10\n\
             [[probes]]\nname = \"p\"\non = {{ body = \"sheet\", at = [0.4, 0.7] }}\n\
             [analysis]\nkind = \"dynamics\"\nduration = 0.5\nstep = 1e-3\nscheme = {{ spectral_radius = 0.6 }}\n"
        );
        let depth = 1000.0 * 0.01 * 10.0 / 4e6 + 0.5e-5;
        assert_near("z", last(&run_model(&parse(&text)), "p.z"), 0.015 - depth, 1e-6);
    }
}

/// Without friction a sheet slides over the edges of the elements of a plate without resistance, and with friction it is
/// decelerated by μ g.
#[test]
fn sheets_slide_on_a_plate() {
    let depth = 1000.0 * 0.01 * 10.0 / 4e6 + 0.5e-5;
    let keys = "thickness = 0.01\nmaterial = \"soft\"\nmotion = { velocity = [0.6, 0.05, 0] }";
    let upper = sheet("sheet", [-0.25, -0.13, 0.015 - depth], [0.2, 0.2], [2, 2], keys);
    for (friction, duration, scheme) in [(0.0, 0.3, ""), (0.2, 0.2, ""), (0.0, 0.3, "scheme = \"energy\"\n")]
    {
        let text = format!(
            "gravity = [0, 0, -10]\n{MATERIALS}{}{upper}{CONTACT}friction = {friction}\nslip_speed = 1e-4\n\
             [[probes]]\nname = \"p\"\non = {{ body = \"sheet\", at = [0.5, 0.5] }}\n\
             [analysis]\nkind = \"dynamics\"\nduration = {duration}\nstep = 1e-3\n{scheme}",
            table()
        );
        let series = run_model(&parse(&text));
        let speed = f64::hypot(0.6, 0.05);
        let (way, factor) = (speed * duration - 0.5 * friction * 10.0 * duration * duration, 0.6 / speed);
        assert_near("x", last(&series, "p.x") + 0.15, way * factor, 1e-4 + 2e-3 * friction);
        assert_near(
            "v",
            last(&series, "p.vx"),
            (speed - friction * 10.0 * duration) * factor,
            2e-3 + 1e-2 * friction,
        );
    }
}

/// Two free sheets collide, frictionless: momentum, angular momentum and, in the energy scheme, energy are kept.
#[test]
fn collisions_keep_momentum_and_energy() {
    let keys = |velocity: &str| {
        format!("thickness = 0.01\nmaterial = \"elastic\"\nmotion = {{ velocity = {velocity} }}")
    };
    let text = format!(
        "materials.elastic = {{ density = 1000, young = 1e6 }}\n{}{}{CONTACT}\
         [output]\nmomentum = true\n[analysis]\nkind = \"dynamics\"\nduration = 0.04\nstep = 5e-4\nscheme = \"energy\"\n",
        sheet("a", [0.0, 0.0, 0.0], [0.4, 0.3], [4, 3], &keys("[0, 0, 0.5]")),
        sheet("b", [0.25, 0.11, 0.013], [0.35, 0.4], [3, 4], &keys("[0.3, -0.2, -1]")),
    );
    let series = run_model(&parse(&text));
    for column in ["px", "py", "pz", "lx", "ly", "lz"] {
        let values = series.column(column).unwrap();
        let change = values.last().unwrap() - values[0];
        assert_near(column, change, 0.0, 1e-9);
    }
    // The sheets have exchanged momentum along z.
    let pz = series.column("a.pz").unwrap();
    assert!((pz.last().unwrap() - pz[0]).abs() > 0.2, "{:?}", pz.last());
    let change = series.column("balance").unwrap().iter().map(|x| x.abs()).fold(0.0, f64::max);
    assert!(change < 1e-8, "{change:e}");
}

/// A cable on a plate lies as on the plane of its upper side.
#[test]
fn cables_lie_on_plates_as_on_planes() {
    let cable = "[[bodies]]\nkind = \"cable\"\nname = \"c\"\nfrom = [-0.25, -0.2, 0.03]\nto = [0.25, 0.21, 0.03]\nelements = 12\n\
                 section = \"r\"\nmaterial = \"soft\"\n\
                 [[joints]]\nkind = \"spherical\"\nname = \"a\"\na = { body = \"c\", at = \"start\" }\n\
                 [[joints]]\nkind = \"spherical\"\nname = \"b\"\na = { body = \"c\", at = \"end\" }\n\
                 [[probes]]\nname = \"p\"\non = { body = \"c\", at = 0.3 }\n";
    let [on_plate, on_plane] = ["kind = \"bodies\"", "kind = \"plane\", point = [0, 0, 0.01], normal = [0, 0, 1]"].map(
        |partner| {
            let (bodies, stiffness) = if partner.contains("plane") {
                (String::new(), "")
            } else {
                (table(), "surface_stiffness = 1e6\n")
            };
            let text = format!(
                "gravity = [0, 0, -10]\n{MATERIALS}sections.r = {{ kind = \"circle\", diameter = 0.01 }}\n{bodies}{cable}\
                 [[contacts]]\nwith = {{ {partner} }}\nstiffness = 1e4\n{stiffness}points = 6\ntransition = 1e-4\n\
                 [analysis]\nkind = \"statics\"\n"
            );
            run_model(&parse(&text))
        },
    );
    for column in ["p.x", "p.y", "p.z"] {
        let [a, b] = [&on_plate, &on_plane].map(|series| last(series, column));
        assert_near(column, a, b, 1e-7);
    }
    assert!(last(&on_plate, "p.z") < 0.0151, "{}", last(&on_plate, "p.z"));
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
    let text = format!(
        "{MATERIALS}{}{}{}[[probes]]\nname = \"a\"\non = {{ body = \"a\", at = [0.5, 0.5] }}\n\
         [[probes]]\nname = \"b\"\non = {{ body = \"b\", at = [0.5, 0.5] }}\n\
         [analysis]\nkind = \"dynamics\"\nduration = 0.02\nstep = 5e-4\n",
        sheet("a", [0.0, 0.0, 0.0], [0.2, 0.2], [2, 2], &keys("[0, 0, 10]")),
        sheet("b", [0.01, 0.02, 0.0323], [0.2, 0.2], [2, 2], &keys("[0, 0, -10]")),
        CONTACT.replace("4e6", "1e9"),
    );
    let series = run_model(&parse(&text));
    let [a, b] = ["a.z", "b.z"].map(|name| last(&series, name));
    assert!(b > a, "{a} {b}");
}
