//! Model files of large models.

/// Gravity, the first key of a model.
const GRAVITY: &str = "\ngravity = [0.0, 0.0, -9.81]\n";
/// Steel and a round bar.
const STEEL: &str = r#"
[materials.steel]
density = 7850.0
young = 2.1e11
poisson = 0.3

[sections.bar]
kind = "circle"
diameter = 0.02
"#;

/// Returns the model file of an open chain of rigid rods with hinges in turn about y and z.
pub fn chain(bodies: u32, steps: u32) -> String {
    let mut text = format!("{GRAVITY}{STEEL}{}", dynamics(steps, 0));
    for k in 0..bodies {
        let x = 0.1 * f64::from(k);
        let axis = if k.is_multiple_of(2) { "[0.0, 1.0, 0.0]" } else { "[0.0, 0.0, 1.0]" };
        let b = if k == 0 {
            String::new()
        } else {
            format!("\nb = {{ body = \"r{}\", at = [{x:?}, 0.0, 0.0] }}", k - 1)
        };
        text += &format!(
            r#"
[[bodies]]
kind = "rigid"
name = "r{k}"
mass = 0.25
inertia = [1e-5, 2e-4, 2e-4]
center = [{:?}, 0.0, 0.0]

[[joints]]
kind = "revolute"
name = "j{k}"
a = {{ body = "r{k}", at = [{x:?}, 0.0, 0.0] }}{b}
axis = {axis}
"#,
            x + 0.05
        );
    }
    text
}

/// Returns the model file of a cantilever beam of 20 elements with evenly spaced probes, which record every step.
pub fn probes(count: u32, steps: u32) -> String {
    let mut text = format!("{GRAVITY}{STEEL}{}{}", beam(20, 10.0), dynamics(steps, 0));
    for k in 0..count {
        let s = 10.0 * f64::from(k + 1) / f64::from(count + 1);
        text += &format!("\n[[probes]]\nname = \"p{k}\"\non = {{ body = \"bar\", at = {s:?} }}\n");
    }
    text
}

/// Returns the model file of a rubber plate of thin elements that swings about an edge, held at its two corners.
pub fn plate(elements: u32, steps: u32) -> String {
    let corner = |name: &str, v: u32| {
        format!(
            "[[joints]]\nkind = \"spherical\"\nname = \"{name}\"\na = {{ body = \"plate\", at = [0, {v}] }}\n\n"
        )
    };
    format!(
        r#"
gravity = [0.0, 0.0, -9.81]

[materials.rubber]
density = 1100.0
young = 5e6
poisson = 0.4
damping = {{ strain = 1e-4 }}

[[bodies]]
kind = "shell"
name = "plate"
surface = {{ kind = "flat", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, 1, 0] }}
elements = [{elements}, {elements}]
thickness = 0.01
material = "rubber"

{}{}[[probes]]
name = "corner"
on = {{ body = "plate", at = [1, 1] }}

[analysis]
kind = "dynamics"
duration = {:?}
step = 2e-3
"#,
        corner("left", 0),
        corner("right", 1),
        2e-3 * f64::from(steps)
    )
}

/// Returns the model file of a long cantilever beam with stored states.
pub fn frames(elements: u32, states: u32) -> String {
    format!("{GRAVITY}{STEEL}{}{}", beam(elements, 0.01 * f64::from(elements)), dynamics(states - 1, states))
}

/// Returns the model file of the ten lowest modes of a cantilever cable with a length of 1 m.
pub fn modes(elements: u32) -> String {
    let body = body("kind = \"cable\"", elements, 1.0);
    format!("{GRAVITY}{STEEL}{body}\n[analysis]\nkind = \"modes\"\ncount = 10\n")
}

/// Returns the model file of a slender cantilever that the force 10 EI/L² at its end bends to a hook in statics.
pub fn hook(elements: u32, slenderness: f64) -> String {
    let (length, rigidity) = (0.02 * slenderness, 2.1e11 * std::f64::consts::PI * 0.02_f64.powi(4) / 64.0);
    let force = -10.0 * rigidity / length.powi(2);
    format!(
        "{STEEL}{}\n[[loads]]\nkind = \"force\"\non = {{ body = \"bar\", at = \"end\" }}\nforce = [0.0, 0.0, {force:?}]\n\n\
         [analysis]\nkind = \"statics\"\n\n[output]\nstates = 0\n",
        beam(elements, length)
    )
}

/// Returns the model file of a cable of 100 m between supports at a distance of 90 m, straight before it sags to its catenary.
pub fn slack_cable(elements: u32) -> String {
    format!(
        r#"
gravity = [0.0, 0.0, -9.81]

[materials.rope]
density = 1140.0
young = 2e9

[sections.rope]
kind = "circle"
diameter = 0.01

[[bodies]]
kind = "cable"
name = "line"
from = [0.0, 0.0, 0.0]
to = [100.0, 0.0, 0.0]
elements = {elements}
section = "rope"
material = "rope"

[[joints]]
kind = "spherical"
name = "left"
a = {{ body = "line", at = "start" }}

[[joints]]
kind = "spherical"
name = "right"
a = {{ body = "line", at = "end" }}
b = {{ point = [90.0, 0.0, 0.0] }}

[analysis]
kind = "statics"
first = 0.1

[output]
states = 0
"#
    )
}

/// Clamped beam along x.
fn beam(elements: u32, length: f64) -> String {
    body("kind = \"beam\"\nformulation = \"linked\"", elements, length)
}

fn body(kind: &str, elements: u32, length: f64) -> String {
    format!(
        r#"
[[bodies]]
{kind}
name = "bar"
from = [0.0, 0.0, 0.0]
to = [{length:?}, 0.0, 0.0]
elements = {elements}
section = "bar"
material = "steel"

[[joints]]
kind = "clamp"
name = "root"
a = {{ body = "bar", at = "start" }}
"#
    )
}

/// Motion by steps of 1 ms, with a number of stored states.
fn dynamics(steps: u32, states: u32) -> String {
    let duration = 1e-3 * f64::from(steps);
    format!(
        r#"
[analysis]
kind = "dynamics"
duration = {duration:?}
step = 1e-3

[output]
states = {states}
"#
    )
}
