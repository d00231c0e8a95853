//! Combinations of features: rigid bodies in closed loops, couplings, drives, gaps.

use ancf::Model;

use crate::common::models::parse;
use crate::common::solutions::Run;

/// Four-bar linkage of rigid bodies with parallel hinges: three redundant equations.
fn four_bar(hinge: &str, analysis: &str) -> Model {
    let text = format!(
        "bodies = [
  {{ kind = \"rigid\", name = \"crank\", center = [0.05, 0.25, 0], mass = 1, inertia = [0.02, 0.003, 0.02] }},
  {{ kind = \"rigid\", name = \"coupler\", center = [0.6, 0.7, 0], mass = 2, inertia = [0.02, 0.2, 0.2] }},
  {{ kind = \"rigid\", name = \"rocker\", center = [1.15, 0.45, 0], mass = 1.5, inertia = [0.1, 0.01, 0.1] }},
]
joints = [
  {{ kind = \"revolute\", name = \"o\", a = {{ body = \"crank\", at = [0, 0, 0] }}, axis = [0, 0, 1], {hinge} }},
  {{ kind = \"revolute\", name = \"a\", a = {{ body = \"coupler\", at = [0.1, 0.5, 0] }},
    b = {{ body = \"crank\", at = [0.1, 0.5, 0] }}, axis = [0, 0, 1] }},
  {{ kind = \"revolute\", name = \"b\", a = {{ body = \"rocker\", at = [1.1, 0.9, 0] }},
    b = {{ body = \"coupler\", at = [1.1, 0.9, 0] }}, axis = [0, 0, 1] }},
  {{ kind = \"revolute\", name = \"c\", a = {{ body = \"rocker\", at = [1.2, 0, 0] }}, axis = [0, 0, 1] }},
]
analysis = {{ {analysis} }}
"
    );
    parse(&text)
}

/// One mode is left with as many equations as coordinates, of which three are redundant.
#[test]
fn overconstrained_linkage_has_one_mode() {
    let found = Run::of(&four_bar("spring = { stiffness = 50 }", "kind = \"modes\", count = 4"));
    // Angular velocities for that of the crank equal to 1; the coupler rotates about its instantaneous centre.
    let (coupler, rocker) = (0.148_936_170_212_766, 0.489_361_702_127_66);
    let (c, reach) = ([0.6 - 0.771_428_571_428_571, 0.7 - 3.857_142_857_142_857], [-0.05, 0.45]);
    let square = |r: [f64; 2]| r[0] * r[0] + r[1] * r[1];
    let inertia = 0.02
        + square([0.05, 0.25])
        + coupler * coupler * (0.2 + 2.0 * square(c))
        + rocker * rocker * (0.1 + 1.5 * square(reach));
    let squared = found.column("squared");
    assert_eq!(squared.len(), 1);
    assert!((squared[0] * inertia / 50.0 - 1.0).abs() < 1e-9, "{squared:?} {}", 50.0 / inertia);
}

fn gears(hinges: [&str; 2], couplings: &str) -> String {
    let [one, two] = hinges;
    format!(
        "bodies = [
  {{ kind = \"rigid\", name = \"w1\", center = [0, 0, 0], mass = 1, inertia = [0.01, 0.01, 0.01] }},
  {{ kind = \"rigid\", name = \"w2\", center = [1, 0, 0], mass = 1, inertia = [0.01, 0.01, 0.01] }},
]
joints = [
  {{ kind = \"revolute\", name = \"h1\", a = {{ body = \"w1\", at = \"center\" }}, axis = [0, 0, 1]{one} }},
  {{ kind = \"revolute\", name = \"h2\", a = {{ body = \"w2\", at = \"center\" }}, axis = [0, 0, 1]{two} }},
]
couplings = [{couplings}]
analysis = {{ kind = \"dynamics\", duration = 0.5, step = 5e-3, scheme = {{ spectral_radius = 0.8 }} }}
"
    )
}

const GEAR: &str =
    "{ name = \"gear\", joints = [{ joint = \"h1\", factor = 1 }, { joint = \"h2\", factor = 1 }] }";

/// A coupling of two driven hinges is redundant or contradicts the drives.
#[test]
fn redundant_and_contradicting_couplings_are_named() {
    let drive = |rate: f64| format!(", drive = {{ rate = {rate} }}");
    let agree = gears([&drive(1.0), &drive(-1.0)], GEAR);
    let model = parse(&agree);
    let words = |model: &Model| -> Vec<String> {
        model.diagnose().unwrap().redundant.iter().map(ToString::to_string).collect()
    };
    assert_eq!(words(&model), ["coupling `gear`, follows from `h1` and `h2`"]);
    // The shared forces decrease below the smallest normal number.
    assert!((Run::of(&model).last("h1.angle") - 0.5).abs() < 1e-12);
    let again = GEAR.replace("\"gear\"", "\"again\"");
    let twice = parse(&gears([&drive(1.0), ""], &format!("{GEAR}, {again}")));
    assert_eq!(words(&twice), ["coupling `again`, follows from `gear`"]);
    assert!((Run::of(&twice).last("h2.angle") + 0.5).abs() < 1e-12);
    let errors = Model::parse(&gears([&drive(1.0), &drive(1.0)], GEAR)).unwrap_err().to_string();
    assert!(
        errors.contains("couplings[0]: found equations that contradict `h1`, `h2`: coupling"),
        "{errors}"
    );
}

/// The number of unknowns of a term is limited.
#[test]
fn coupling_of_too_many_joints_is_rejected() {
    let part = "{ joint = \"h1\", factor = 1 }";
    let many = format!("{{ name = \"train\", joints = [{}] }}", [part; 96].join(", "));
    let errors = Model::parse(&gears(["", ""], &many)).unwrap_err().to_string();
    assert!(errors.contains("couplings[0].joints: found 96 joints, expected at most 95"), "{errors}");
}

/// A drive that stops suddenly removes the kinetic energy of the body.
#[test]
fn velocity_jump_is_in_the_energy_balance() {
    let text =
        "bodies = [{ kind = \"rigid\", name = \"m\", center = [0, 0, 0], mass = 2, inertia = [1, 2, 2.5] }]
joints = [{ kind = \"drive\", name = \"d\", a = { body = \"m\", at = \"center\" }, displacement = [0.1, 0, 0],
  time = { kind = \"ramp\", end = 0.5 } }]
analysis = { kind = \"dynamics\", duration = 1, step = 5e-3, scheme = { spectral_radius = 0.8 } }
";
    let run = Run::of(&parse(text));
    let [kinetic, work] = ["kinetic", "work"].map(|column| run.column(column));
    assert!((kinetic[0] - 0.04).abs() < 1e-12);
    assert!(kinetic.last().unwrap().abs() < 1e-12);
    assert!((work.last().unwrap() + 0.04).abs() < 1e-12);
    assert!(run.column("balance").iter().all(|balance| balance.abs() < 1e-12));
}

/// Joints that cannot close gaps report them.
#[test]
fn joints_that_cannot_close_gaps_are_rejected() {
    let model = |joint: &str, beam: &str| {
        let text = format!(
            "assemble = true
materials.steel = {{ density = 7850, young = 2.1e11 }}
sections.round = {{ kind = \"circle\", diameter = 0.02 }}
bodies = [
  {{ kind = \"rigid\", name = \"w\", center = [0, 0, 0], mass = 1, inertia = [0.01, 0.01, 0.01] }},
  {beam}
]
joints = [{{ {joint}, name = \"j\", a = {{ body = \"w\", at = \"center\" }}, b = {{ body = \"p\", at = \"start\" }} }}]
analysis = {{ kind = \"dynamics\", duration = 0.1, step = 5e-3, scheme = {{ spectral_radius = 0.8 }} }}
"
        );
        Model::parse(&text)
    };
    let beam = "{ kind = \"beam\", name = \"p\", from = [0, 0.1, 0], to = [1, 0.1, 0], elements = 2, section = \"round\", material = \"steel\" }";
    for joint in [
        "kind = \"prismatic\", axis = [1, 0, 0]",
        "kind = \"cylindrical\", axis = [1, 0, 0]",
        "kind = \"universal\", axis_a = [1, 0, 0], axis_b = [0, 1, 0]",
        "kind = \"planar\", normal = [0, 1, 0]",
        "kind = \"point_on_line\", axis = [1, 0, 0]",
        "kind = \"slide\"",
        "kind = \"bushing\", stiffness = [1, 1, 1, 1, 1, 1]",
    ] {
        let errors = model(joint, beam).unwrap_err().to_string();
        assert!(errors.contains("closes gaps of clamps, hinges and ball joints only"), "{joint}: {errors}");
    }
    assert!(model("kind = \"spherical\"", beam).is_ok());
}

/// Names of the equations of guides and axes.
#[test]
fn equations_of_guides_have_names_in_the_diagnosis() {
    let text =
        "bodies = [{ kind = \"rigid\", name = \"m\", center = [0, 0, 0], mass = 2, inertia = [1, 2, 2.5] }]
joints = [
  { kind = \"clamp\", name = \"held\", a = { body = \"m\", at = \"center\" } },
  { kind = \"prismatic\", name = \"slot\", a = { body = \"m\", at = \"center\" }, axis = [1, 0, 0] },
]
analysis = { kind = \"dynamics\", duration = 0.1, step = 5e-3, scheme = { spectral_radius = 0.8 } }
";
    let found = parse(text).diagnose().unwrap().redundant;
    let words: Vec<&str> = found.iter().map(|one| one.equation.as_str()).collect();
    assert_eq!(
        words,
        [
            "guide, first equation",
            "guide, second equation",
            "axis, first equation",
            "axis, second equation",
            "rotation about the axis"
        ]
    );
}

/// Bodies joined by closing a gap exert no contact forces on each other.
#[test]
fn bodies_joined_by_closing_a_gap_have_no_contact() {
    let text = |contact: &str| {
        format!(
            "assemble = true
materials.steel = {{ density = 7850, young = 2.1e11 }}
sections.round = {{ kind = \"circle\", diameter = 0.02 }}
bodies = [
  {{ kind = \"cable\", name = \"a\", from = [0, 0, 0], to = [1, 0, 0], elements = 2, section = \"round\", material = \"steel\" }},
  {{ kind = \"cable\", name = \"b\", from = [1.05, 0, 0], to = [2, 0, 0], elements = 2, section = \"round\", material = \"steel\" }},
]
joints = [
  {{ kind = \"spherical\", name = \"o\", a = {{ body = \"a\", at = \"start\" }} }},
  {{ kind = \"spherical\", name = \"j\", a = {{ body = \"b\", at = \"start\" }}, b = {{ body = \"a\", at = \"end\" }} }},
]
contacts = [{contact}]
analysis = {{ kind = \"dynamics\", duration = 0.01, step = 1e-3, scheme = {{ spectral_radius = 0.8 }} }}
"
        )
    };
    let contact = "{ with = { kind = \"bodies\" }, stiffness = 1e8 }";
    let [with, without] = [contact, ""].map(|contact| {
        let run = Run::of(&parse(&text(contact)));
        [run.column("strain")[0], run.last("kinetic")]
    });
    assert!(
        (with[0] - without[0]).abs() <= 1e-9 && (with[1] - without[1]).abs() <= 1e-9,
        "{with:?} {without:?}"
    );
}
