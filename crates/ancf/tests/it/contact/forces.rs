//! Contact forces: impact, sliding, belt friction and static contact against closed forms.

use ancf::assembly::Assembly;
use ancf::model::{At, NamedPosition, Place, Probe};
use ancf::solver::dynamics::{SchemeCoefficients, TimeStepper};
use ancf::solver::equations::{State, System};
use ancf::solver::newton::{Newton, StopRule};
use ancf::{Model, Scales};
use nalgebra::{Rotation3, Vector3};

use super::models::{force, model, with_velocities};
use crate::common::solutions::{Run, distance, equilibrium};

const GRAVITY: f64 = 9.81;
const RADIUS: f64 = 0.01;
/// ρA of the rods, 1000 kg/m³.
const LINE: f64 = 1000.0 * std::f64::consts::PI * RADIUS * RADIUS;

/// Time integration by the trapezoidal rule from a state.
fn motion(assembly: &Assembly, start: State) -> TimeStepper<'_, System> {
    let newton = Newton::new(assembly.system.matrix(), StopRule::Energy(1e-10), 50).unwrap();
    let mut motion =
        TimeStepper::new(&assembly.system, SchemeCoefficients::newmark(0.5, 0.25), newton, 6, start);
    motion.restart(0.0).unwrap();
    motion
}

fn advance(motion: &mut TimeStepper<'_, System>, steps: u32, h: f64) {
    for k in 1..=steps {
        motion.advance(f64::from(k) * h).unwrap();
    }
}

/// Mean velocity of a body of length 0.1, without vibrations.
fn mean_velocity(assembly: &Assembly, body: &str, s: &State) -> Vector3<f64> {
    let mesh = assembly.mesh(body).unwrap();
    (0..50).map(|i| mesh.point(f64::from(i) * 0.002 + 0.001).sum(&s.v)).sum::<Vector3<f64>>() / 50.0
}

fn rod(contact: &str) -> Model {
    model(
        "[[bodies]]\nkind = \"beam\"\nname = \"rod\"\nfrom = [0, 0, 0]\nto = [0, 0, 0.1]\nelements = 1\n\
         formulation = \"linked\"\nsection = \"round\"\nmaterial = \"stiff\"\n",
        contact,
    )
}

const FLOOR: &str =
    "with = { kind = \"plane\", point = [0, -0.0105, 0], normal = [0, 2, 0] }\nstiffness = 1e6";

/// Elastic impact from 0.5 mm above the floor: equal speed after the impact, to the order of the step.
#[test]
fn elastic_impact_on_a_plane_reverses_the_velocity() {
    let assembly = rod(FLOOR).assemble().unwrap();
    let errors = [4e-5, 2e-5].map(|h: f64| {
        let start = with_velocities(&assembly, &[("rod", Vector3::new(0.3, -1.0, 0.0))]);
        let mut motion = motion(&assembly, start);
        let before = motion.energy().total();
        advance(&mut motion, (4e-3 / h).round() as u32, h);
        assert_eq!(force(&assembly, motion.state(), "rod").norm(), 0.0, "the contact is open");
        assert!((motion.energy().total() / before - 1.0).abs() < 1e-3);
        let v = mean_velocity(&assembly, "rod", motion.state());
        assert!((v.x - 0.3).abs() < 1e-9, "no friction, {}", v.x);
        (v.y - 1.0).abs()
    });
    assert!(errors[0] < 2e-3 && errors[1] < errors[0], "{errors:?}");
}

/// Energy balance with damping and friction: error of second order in the step.
#[test]
fn energy_balance_of_an_impact_is_of_second_order() {
    let lossy = format!("{FLOOR}\ndamping = 0.4\nfriction = 0.3\nslip_speed = 0.01");
    let assembly = rod(&lossy).assemble().unwrap();
    let errors = [4e-5, 2e-5].map(|h: f64| {
        let start = with_velocities(&assembly, &[("rod", Vector3::new(0.5, -1.0, 0.4))]);
        let mut motion = motion(&assembly, start);
        let before = motion.energy().total();
        advance(&mut motion, (4e-3 / h).round() as u32, h);
        let (after, dissipated) = (motion.energy().total(), motion.energy_exchange().dissipation);
        assert!(dissipated > 0.2 * before && dissipated < 0.9 * before, "{dissipated} of {before}");
        ((before - dissipated - after) / before).abs()
    });
    assert!(errors[1] < 1e-3 && errors[1] < 0.5 * errors[0], "{errors:?}");
}

/// A step from far above the floor into it is repeated with the new contact.
#[test]
fn large_steps_find_new_contacts() {
    let assembly = rod(&FLOOR.replace("-0.0105", "-0.06")).assemble().unwrap();
    let mut motion = motion(&assembly, with_velocities(&assembly, &[("rod", Vector3::new(0.0, -10.0, 0.0))]));
    advance(&mut motion, 1, 5.2e-3);
    assert!(force(&assembly, motion.state(), "rod").y > 0.0);
    assert!(motion.energy().strain > 0.0, "the contact stores energy");
    let v = mean_velocity(&assembly, "rod", motion.state()).y;
    assert!(v > -9.9, "{v}");
}

/// Lengths, times and forces in other units, including default values.
#[test]
fn units_do_not_change_contact() {
    let mut model = rod(&format!("{FLOOR}\nfriction = 0.3\ndamping = 0.2"));
    model.gravity = [3.0, -GRAVITY, 1.0];
    model.probes = vec![Probe::of_motion("tip", Place::new("rod", At::Named(NamedPosition::End)))];
    let settings = model.analysis.dynamics_mut().unwrap();
    settings.duration = 0.02;
    let (a, units) = (Run::of(&model), Scales { length: 0.037, time: 13.0, force: 2.9e5 });
    let scaled = Run::of(&model.scaled(&units));
    let back: Vec<_> = scaled.vectors("tip.").iter().map(|x| x * units.length).collect();
    let error = distance(&a.vectors("tip."), &back);
    assert!(error < 1e-9 * RADIUS, "{error:e}");
    assert!(a.last("dissipated") > 1e-6, "contact occurs");
}

/// At rest the contact force is the weight, and the pressure at the depth is the weight per length.
#[test]
fn floor_carries_the_weight_at_rest() {
    let mut model = rod(FLOOR);
    model.gravity = [0.0, -GRAVITY, 0.0];
    model.materials.get_mut("stiff").unwrap().damping.mass = 3000.0;
    let assembly = model.assemble().unwrap();
    let mut motion = motion(&assembly, with_velocities(&assembly, &[("rod", Vector3::new(0.0, -0.1, 0.0))]));
    advance(&mut motion, 1000, 1e-3);
    let up = force(&assembly, motion.state(), "rod");
    let weight = LINE * 0.1 * GRAVITY;
    assert!((up - Vector3::y() * weight).norm() < 1e-6 * weight, "{up}");
    let y = assembly.mesh("rod").unwrap().point(0.05).value(motion.state()).y;
    let (k, delta): (f64, f64) = (1e6, 0.02 * RADIUS);
    // Within the transition: p = k d²/2δ.
    let depth = (2.0 * delta * LINE * GRAVITY / k).sqrt();
    assert!(depth < delta && (y + 0.0005 + depth).abs() < 1e-3 * depth, "{y}");
}

/// Acceleration g (sin − μ cos) on a slope of 30°, or creep by the regularised friction law.
#[test]
fn rod_on_a_slope_slides_or_creeps() {
    for friction in [0.3, 0.8] {
        let slope = format!(
            "with = {{ kind = \"plane\", point = [0, 0, 0], normal = [0.5, 0.8660254037844386, 0] }}\n\
             stiffness = 1e6\ndamping = 0.5\nfriction = {friction}\nslip_speed = 1e-3"
        );
        let mut model = rod(&slope);
        model.gravity = [0.0, -GRAVITY, 0.0];
        let assembly = model.assemble().unwrap();
        let (sin, cos) = (0.5, 0.75_f64.sqrt());
        let delta = 0.02 * RADIUS;
        let depth = (2.0 * delta * LINE * GRAVITY * cos / 1e6).sqrt();
        let mut start = assembly.rest();
        for vector in assembly.mesh("rod").unwrap().vectors(&assembly.rest()).filter(|v| v.is_position()) {
            let lift = Vector3::new(sin, cos, 0.0) * (RADIUS - depth);
            start.q[vector.first..vector.first + 3].copy_from_slice(lift.as_slice());
        }
        let mut motion = motion(&assembly, start);
        advance(&mut motion, 400, 5e-4);
        let v = assembly.mesh("rod").unwrap().point(0.05).sum(&motion.state().v);
        let down = v.dot(&Vector3::new(cos, -sin, 0.0));
        if friction < sin / cos {
            let expected = GRAVITY * (sin - friction * cos) * 0.2;
            assert!((down / expected - 1.0).abs() < 0.02, "{down} for {expected}");
        } else {
            let creep = 1e-3 * sin / ((friction * cos).powi(2) - sin * sin).sqrt();
            assert!((down / creep - 1.0).abs() < 1e-3, "{down} for {creep}");
        }
    }
}

/// Rope over half of a rotating drum: ratio of the tensions exp(μπ) (Euler, Eytelwein).
#[test]
fn rope_on_a_drum_obeys_the_belt_equation() {
    let drum = "with = { kind = \"cylinder\", point = [0, 0, 0], axis = [0, 0, 1], radius = 0.098, on = { body = \
                \"axle\", at = \"start\" } }\nbodies = [\"rope\"]\nstiffness = 1e6\nfriction = 0.3\nslip_speed = 1e-3";
    let model = model(
        "[sections.thin]\nkind = \"circle\"\ndiameter = 0.004\n\n[[bodies]]\nkind = \"beam\"\nname = \"rope\"\nfrom = [-0.1, 0, 0]\n\
         to = [0.1, 0, 0]\nshape = { kind = \"arc\", through = [0, 0.1, 0] }\nelements = 10\nformulation = \
         \"linked\"\nsection = \"thin\"\nmaterial = \"soft\"\n\n[[bodies]]\nkind = \"beam\"\nname = \"axle\"\nfrom = [0, 0, \
         -0.05]\nto = [0, 0, 0.05]\nelements = 1\nformulation = \"linked\"\nsection = \"round\"\nmaterial = \
         \"soft\"\n\n[[joints]]\nkind = \"spherical\"\nname = \"hook\"\na = { body = \"rope\", at = \"start\" }\n\n[[joints]]\n\
         kind = \"drive\"\nname = \"motor\"\na = { body = \"axle\", at = \"start\" }\naxis = [0, 0, 1]\nangle = -5\ntime = { \
         kind = \"expression\", text = \"t\" }\n\n[[loads]]\nkind = \"force\"\non = { body = \"rope\", at = \"end\" }\nforce = \
         [0, -1, 0]\n",
        drum,
    );
    let assembly = model.assemble().unwrap();
    // In steps of 0.5 ms, this scheme without damping lets the tension alternate about the same mean value.
    let mut motion = motion(&assembly, assembly.rest());
    advance(&mut motion, 400, 2.5e-4);
    let (hook, motor) = {
        let mut reactions = assembly.reactions(motion.state());
        (reactions.next().unwrap(), reactions.next().unwrap())
    };
    let (tension, expected) = (hook.force.norm(), (0.3 * std::f64::consts::PI).exp());
    assert!((tension / expected - 1.0).abs() < 0.03, "{tension} for {expected}");
    // Motor torque: difference of the tensions at the radius of the axis of the rope.
    let torque = (tension - 1.0) * 0.1;
    assert!((motor.moment.z + torque).abs() < 0.03 * torque, "{} for {torque}", motor.moment.z);
}

/// Elastic impact of two equal parallel rods with two and three elements.
#[test]
fn equal_rods_exchange_their_velocities() {
    let of = |name: &str, y: f64, elements: u32| {
        format!(
            "[[bodies]]\nkind = \"beam\"\nname = \"{name}\"\nfrom = [0, {y}, 0]\nto = [0.1, {y}, 0]\nelements = {elements}\n\
             formulation = \"linked\"\nsection = \"round\"\nmaterial = \"stiff\"\n\n"
        )
    };
    let contact = "with = { kind = \"bodies\" }\nstiffness = 1e6";
    let model = model(&(of("still", 0.0, 2) + &of("fast", 0.021, 3)), contact);
    let assembly = model.assemble().unwrap();
    let mut motion = motion(&assembly, with_velocities(&assembly, &[("fast", Vector3::new(0.0, -1.0, 0.0))]));
    let before = motion.energy().total();
    advance(&mut motion, 300, 2e-5);
    let [still, fast] = ["still", "fast"].map(|name| mean_velocity(&assembly, name, motion.state()).y);
    assert!((still + fast + 1.0).abs() < 1e-3, "momentum: {still}, {fast}");
    assert!((still + 1.0).abs() < 0.02 && fast.abs() < 0.02, "{still}, {fast}");
    assert!((motion.energy().total() / before - 1.0).abs() < 1e-2);
}

/// Legs of a hairpin that move towards each other: they cross without self-contact only.
#[test]
fn loop_does_not_penetrate_itself() {
    let smallest_gap = |contact: &str| {
        let model = model(
            "[[bodies]]\nkind = \"beam\"\nname = \"hairpin\"\nfrom = [0, 0.05, 0]\nto = [0, -0.05, 0]\nshape = { kind = \
             \"spline\", through = [[0.2, 0.06, 0], [0.3, 0, 0], [0.2, -0.06, 0]] }\nelements = 12\nformulation = \
             \"linked\"\nsection = \"round\"\nmaterial = \"soft\"\n",
            contact,
        );
        let assembly = model.assemble().unwrap();
        let mesh = assembly.mesh("hairpin").unwrap();
        let mut start = assembly.rest();
        for vector in mesh.vectors(&assembly.rest()).filter(|vector| vector.is_position()) {
            start.v[vector.first + 1] = -50.0 * vector.value.y;
        }
        let mut motion = motion(&assembly, start);
        let mut smallest = f64::INFINITY;
        for k in 1..=500 {
            motion.advance(f64::from(k) * 2e-4).unwrap();
            let y = |s: f64| mesh.point(s).value(motion.state()).y;
            smallest = smallest.min(y(0.0) - y(mesh.length()));
        }
        smallest
    };
    assert!(smallest_gap("") < 0.0, "the legs cross without contact");
    let gap = smallest_gap("with = { kind = \"bodies\" }\nstiffness = 1e7");
    assert!(gap > 1.5 * RADIUS, "{gap}");
}

/// Two crossed rods with clamped ends and a load in the middle of the upper one.
fn crossed(turn: Rotation3<f64>, names: [&str; 2]) -> Model {
    let at = |x: f64, y: f64, z: f64| {
        let r = turn * Vector3::new(x, y, z);
        format!("[{:.17}, {:.17}, {:.17}]", r.x, r.y, r.z)
    };
    let body = |name: &str| match name {
        "lower" => (at(-0.5, 0.0, 0.0), at(0.5, 0.0, 0.0)),
        _ => (at(0.0, -0.5, 0.02), at(0.0, 0.5, 0.02)),
    };
    let mut text = String::new();
    for name in names {
        let (from, to) = body(name);
        text += &format!(
            "[[bodies]]\nkind = \"beam\"\nname = \"{name}\"\nfrom = {from}\nto = {to}\nup = {}\nelements = 8\n\
             formulation = \"linked\"\nsection = \"round\"\nmaterial = \"stiff\"\n\n",
            at(0.0, 0.0, 1.0)
        );
    }
    for (name, end) in names.iter().flat_map(|name| [(name, "start"), (name, "end")]) {
        text += &format!(
            "[[joints]]\nkind = \"clamp\"\nname = \"{name} {end}\"\na = {{ body = \"{name}\", at = \"{end}\" }}\n\n"
        );
    }
    text += &format!(
        "[[loads]]\nkind = \"force\"\non = {{ body = \"upper\", at = 0.5 }}\nforce = {}\n",
        at(0.0, 0.0, -2.0)
    );
    let mut model = model(&text, "with = { kind = \"bodies\" }\nstiffness = 1e8\npoints = 100");
    model.analysis = ancf::model::Analysis::Statics(ancf::model::Statics::default());
    model
}

/// Each rod carries half of the load. The forces are opposite, independent of the frame and the order of the rods.
#[test]
fn crossed_rods_share_the_load() {
    let middles = |turn: Rotation3<f64>, names| {
        let model = crossed(turn, names);
        let (assembly, s) = equilibrium(&model, 10);
        let [lower, upper] = ["lower", "upper"].map(|name| turn.inverse() * force(&assembly, &s, name));
        assert!((lower + upper).norm() < 1e-12 * lower.norm(), "action is reaction: {lower}, {upper}");
        let deflections = ["lower", "upper"].map(|name| {
            let point = assembly.mesh(name).unwrap().point(0.5);
            (turn.inverse() * point.sum(&s.q)).z
        });
        (lower, deflections)
    };
    let (force, [lower, upper]) = middles(Rotation3::identity(), ["lower", "upper"]);
    let stiffness = 192.0 * 2e9 * std::f64::consts::PI * RADIUS.powi(4) / 4.0;
    assert!((force.z / (stiffness * lower) - 1.0).abs() < 0.01, "{} for {}", force.z, stiffness * lower);
    let rest = -2.0 - force.z;
    assert!((rest / (stiffness * upper) - 1.0).abs() < 0.01, "{rest} for {}", stiffness * upper);
    // The difference of the deflections is the penetration depth.
    let depth = lower - upper;
    assert!(depth > 0.0 && depth < 0.05 * RADIUS && (force.z + 1.0).abs() < 0.2, "{depth}, {}", force.z);

    let (other, sunk) = middles(Rotation3::from_euler_angles(0.4, -1.1, 2.3), ["upper", "lower"]);
    assert!((other - force).norm() < 1e-6 * force.norm(), "{other} for {force}");
    assert!((sunk[0] - lower).abs() < 1e-8 * depth.max(RADIUS), "{} for {lower}", sunk[0]);
}
