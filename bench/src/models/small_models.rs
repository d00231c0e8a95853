//! Model files of small models whose single steps are measured.

/// Returns the model file of an arm of 20 elements on a motor, which turns by one radian in two seconds.
pub fn arm(steps: u32, step: f64) -> String {
    let duration = f64::from(steps) * step;
    format!(
        r#"
gravity = [0.0, 0.0, -9.81]

[materials.aluminium]
density = 2700.0
young = 7e10
damping = {{ strain = 1e-3 }}

[sections.tube]
kind = "tube"
outer = 0.03
inner = 0.027

[[bodies]]
kind = "beam"
name = "arm"
formulation = "linked"
from = [0.0, 0.0, 0.0]
to = [1.0, 0.0, 0.0]
elements = 20
section = "tube"
material = "aluminium"

[[joints]]
kind = "revolute"
name = "motor"
a = {{ body = "arm", at = "start" }}
axis = [0.0, 1.0, 0.0]
drive = {{ angle = 1.0, time = {{ kind = "expression", text = "if(t < 2, (t/2)^3*(10 - 7.5*t + 1.5*t^2), 1)" }} }}

[[probes]]
name = "tip"
on = {{ body = "arm", at = "end" }}

[analysis]
kind = "dynamics"
duration = {duration:?}
step = {step:?}
scheme = {{ spectral_radius = 0.8 }}
"#
    )
}

/// Returns the model file of a soft rod that swings from the horizontal, with given steps (the text of `analysis.step`).
pub fn swing(step: &str) -> String {
    format!(
        r#"
gravity = [0.0, 0.0, -9.81]

[materials.soft]
density = 7850.0
young = 1.93e8

[sections.bar]
kind = "circle"
diameter = 0.02

[[bodies]]
kind = "cable"
name = "rod"
from = [0.0, 0.0, 0.0]
to = [1.0, 0.0, 0.0]
elements = 16
section = "bar"
material = "soft"

[[joints]]
kind = "spherical"
name = "hinge"
a = {{ body = "rod", at = "start" }}

[[probes]]
name = "tip"
on = {{ body = "rod", at = "end" }}

[analysis]
kind = "dynamics"
duration = 1.0
step = {step}
scheme = {{ spectral_radius = 0.9 }}

[output]
interval = 0.01
states = 0
"#
    )
}
