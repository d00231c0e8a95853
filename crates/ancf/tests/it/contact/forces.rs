//! Contact of bodies with obstacles and with each other: against what is known of impact, sliding, ropes and pressing.

use super::models as touching;
use super::models::{force, model, pushed};
use crate::common::solutions::{Run, distance};
use ancf::analysis::{Dynamics, Newton, Scheme, Stop};
use ancf::model::{Assembly, At, Named, Place, Probe};
use ancf::system::{State, System};
use ancf::{Model, Scales};
use nalgebra::{Rotation3, Vector3};

const GRAVITY: f64 = 9.81;
const RADIUS: f64 = 0.01;
/// ρA of the rods, 1000 kg/m³.
const LINE: f64 = 1000.0 * std::f64::consts::PI * RADIUS * RADIUS;

/// A motion by the trapezoidal rule from a state.
fn motion(assembly: &Assembly, start: State) -> Dynamics<'_, System> {
    let newton = Newton::new(assembly.system.matrix(), Stop::Energy(1e-10), 50).unwrap();
    let mut motion = Dynamics::new(&assembly.system, Scheme::newmark(0.5, 0.25), newton, 6, start);
    motion.restart(0.0).unwrap();
    motion
}

fn advance(motion: &mut Dynamics<'_, System>, steps: u32, h: f64) {
    for k in 1..=steps {
        motion.advance(f64::from(k) * h).unwrap();
    }
}

/// Of a body of length 0.1, vibrations apart.
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

/// Half a millimetre above the floor: bounces as fast as it came, to the order of the step.
#[test]
fn what_falls_on_a_plane_bounces_back() {
    let assembly = rod(FLOOR).assemble().unwrap();
    let errors = [4e-5, 2e-5].map(|h: f64| {
        let start = pushed(&assembly, &[("rod", Vector3::new(0.3, -1.0, 0.0))]);
        let mut motion = motion(&assembly, start);
        let before = motion.energy().total();
        advance(&mut motion, (4e-3 / h).round() as u32, h);
        assert_eq!(force(&assembly, motion.state(), "rod").norm(), 0.0, "it is off again");
        assert!((motion.energy().total() / before - 1.0).abs() < 1e-3);
        let v = mean_velocity(&assembly, "rod", motion.state());
        assert!((v.x - 0.3).abs() < 1e-9, "no friction, {}", v.x);
        (v.y - 1.0).abs()
    });
    assert!(errors[0] < 2e-3 && errors[1] < errors[0], "{errors:?}");
}

/// With damping and friction the books close: what is missing of the energy was dissipated, to second order in the step.
#[test]
fn what_an_impact_takes_is_in_the_books() {
    let lossy = format!("{FLOOR}\ndamping = 0.4\nfriction = 0.3\nslip_speed = 0.01");
    let assembly = rod(&lossy).assemble().unwrap();
    let errors = [4e-5, 2e-5].map(|h: f64| {
        let start = pushed(&assembly, &[("rod", Vector3::new(0.5, -1.0, 0.4))]);
        let mut motion = motion(&assembly, start);
        let before = motion.energy().total();
        advance(&mut motion, (4e-3 / h).round() as u32, h);
        let (after, lost) = (motion.energy().total(), motion.exchanged().dissipation);
        assert!(lost > 0.2 * before && lost < 0.9 * before, "{lost} of {before}");
        ((before - lost - after) / before).abs()
    });
    assert!(errors[1] < 1e-3 && errors[1] < 0.5 * errors[0], "{errors:?}");
}

/// A step from far above the floor into it is done again with what it meets there.
#[test]
fn a_step_does_not_overlook_what_it_meets() {
    let assembly = rod(&FLOOR.replace("-0.0105", "-0.06")).assemble().unwrap();
    let mut motion = motion(&assembly, pushed(&assembly, &[("rod", Vector3::new(0.0, -10.0, 0.0))]));
    advance(&mut motion, 1, 5.2e-3);
    assert!(force(&assembly, motion.state(), "rod").y > 0.0);
    assert!(motion.energy().strain > 0.0, "it is among the equations");
    let v = mean_velocity(&assembly, "rod", motion.state()).y;
    assert!(v > -9.9, "{v}");
}

/// Lengths, times and forces in other units, defaults among them.
#[test]
fn units_do_not_matter() {
    let mut model = rod(&format!("{FLOOR}\nfriction = 0.3\ndamping = 0.2"));
    model.gravity = [3.0, -GRAVITY, 1.0];
    model.probes = vec![Probe::of_motion("tip", Place::new("rod", At::Named(Named::End)))];
    let settings = model.analysis.dynamics_mut().unwrap();
    settings.duration = 0.02;
    let (a, units) = (Run::of(&model), Scales { length: 0.037, time: 13.0, force: 2.9e5 });
    let scaled = Run::of(&model.scaled(&units));
    let back: Vec<_> = scaled.vectors("tip.").iter().map(|x| x * units.length).collect();
    let apart = distance(&a.vectors("tip."), &back);
    assert!(apart < 1e-9 * RADIUS, "{apart:e}");
    assert!(a.column("dissipated").last().unwrap() > &1e-6, "it has touched");
}

/// At rest the floor bears the weight, at the depth at which the pressure is the weight per length.
#[test]
fn the_floor_bears_what_rests_on_it() {
    let mut model = rod(FLOOR);
    model.gravity = [0.0, -GRAVITY, 0.0];
    model.materials.get_mut("stiff").unwrap().damping.mass = 3000.0;
    let assembly = model.assemble().unwrap();
    let mut motion = motion(&assembly, pushed(&assembly, &[("rod", Vector3::new(0.0, -0.1, 0.0))]));
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

/// On a slope of 30° it slides with g (sin − μ cos), or creeps as slowly as the law says.
#[test]
fn what_is_on_a_slope_slides_or_creeps() {
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
            let wanted = GRAVITY * (sin - friction * cos) * 0.2;
            assert!((down / wanted - 1.0).abs() < 0.02, "{down} for {wanted}");
        } else {
            let creep = 1e-3 * sin / ((friction * cos).powi(2) - sin * sin).sqrt();
            assert!((down / creep - 1.0).abs() < 1e-3, "{down} for {creep}");
        }
    }
}

/// A rope over half of a turning drum bears exp(μπ) times the load: Euler's and Eytelwein's law.
#[test]
fn a_rope_on_a_drum_holds_by_friction() {
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
    let mut motion = motion(&assembly, assembly.rest());
    advance(&mut motion, 200, 5e-4);
    let (hook, motor) = {
        let mut reactions = assembly.reactions(motion.state());
        (reactions.next().unwrap(), reactions.next().unwrap())
    };
    let (held, wanted) = (hook.force.norm(), (0.3 * std::f64::consts::PI).exp());
    assert!((held / wanted - 1.0).abs() < 0.03, "{held} for {wanted}");
    // The motor turns the drum against the difference of the pulls at the radius of the rope's axis.
    let torque = (held - 1.0) * 0.1;
    assert!((motor.moment.z + torque).abs() < 0.03 * torque, "{} for {torque}", motor.moment.z);
}

/// Two equal parallel rods, of two and of three elements: the one that is hit takes over the whole velocity.
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
    let mut motion = motion(&assembly, pushed(&assembly, &[("fast", Vector3::new(0.0, -1.0, 0.0))]));
    let before = motion.energy().total();
    advance(&mut motion, 300, 2e-5);
    let [still, fast] = ["still", "fast"].map(|name| mean_velocity(&assembly, name, motion.state()).y);
    assert!((still + fast + 1.0).abs() < 1e-3, "momentum: {still}, {fast}");
    assert!((still + 1.0).abs() < 0.02 && fast.abs() < 0.02, "{still}, {fast}");
    assert!((motion.energy().total() / before - 1.0).abs() < 1e-2);
}

/// The legs of a hairpin that are thrown at each other do not pass through each other, as they do without contact.
#[test]
fn a_loop_does_not_pass_through_itself() {
    let least = |contact: &str| {
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
        let mut least = f64::INFINITY;
        for k in 1..=500 {
            motion.advance(f64::from(k) * 2e-4).unwrap();
            let y = |s: f64| mesh.point(s).value(motion.state()).y;
            least = least.min(y(0.0) - y(mesh.length()));
        }
        least
    };
    assert!(least("") < 0.0, "the legs would cross");
    let apart = least("with = { kind = \"bodies\" }\nstiffness = 1e7");
    assert!(apart > 1.5 * RADIUS, "{apart}");
}

/// Two crossed rods with clamped ends, loaded in the middle of the upper one.
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

/// Each bears half of the load, and the force on one is that on the other; whatever the frame and the order.
#[test]
fn crossed_rods_share_a_load() {
    let middles = |turn: Rotation3<f64>, names| {
        let model = crossed(turn, names);
        let assembly = model.assemble_static().unwrap();
        let s = touching::equilibrium(&assembly);
        let [lower, upper] = ["lower", "upper"].map(|name| turn.inverse() * force(&assembly, &s, name));
        assert!((lower + upper).norm() < 1e-12 * lower.norm(), "action is reaction: {lower}, {upper}");
        let deep = ["lower", "upper"].map(|name| {
            let point = assembly.mesh(name).unwrap().point(0.5);
            (turn.inverse() * point.sum(&s.q)).z
        });
        (lower, deep)
    };
    let (force, [lower, upper]) = middles(Rotation3::identity(), ["lower", "upper"]);
    let stiffness = 192.0 * 2e9 * std::f64::consts::PI * RADIUS.powi(4) / 4.0;
    assert!((force.z / (stiffness * lower) - 1.0).abs() < 0.01, "{} for {}", force.z, stiffness * lower);
    let borne = -2.0 - force.z;
    assert!((borne / (stiffness * upper) - 1.0).abs() < 0.01, "{borne} for {}", stiffness * upper);
    // What one yields more than the other is the depth.
    let depth = lower - upper;
    assert!(depth > 0.0 && depth < 0.05 * RADIUS && (force.z + 1.0).abs() < 0.2, "{depth}, {}", force.z);

    let (other, sunk) = middles(Rotation3::from_euler_angles(0.4, -1.1, 2.3), ["upper", "lower"]);
    assert!((other - force).norm() < 1e-6 * force.norm(), "{other} for {force}");
    assert!((sunk[0] - lower).abs() < 1e-8 * depth.max(RADIUS), "{} for {lower}", sunk[0]);
}
