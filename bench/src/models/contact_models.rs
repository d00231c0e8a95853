//! Models of soft cables in contact.

/// Time step.
const STEP: f64 = 1e-3;

/// Returns the model file of straight cables of 1 m that fall crosswise on the ground and on each other.
pub fn pile(cables: u32, elements: u32) -> String {
    let bodies = (0..cables).map(|c| {
        let (angle, z) = (2.4 * f64::from(c), 0.03 + 0.03 * f64::from(c));
        let (x, y) = (0.5 * angle.cos(), 0.5 * angle.sin());
        cable(&format!("c{c}"), [[-x, -y, z], [x, y, z]], elements)
    });
    model(&bodies.collect::<String>(), &[GROUND, BODIES])
}

/// Returns the model file of a cable that falls across another one, which is attached at both ends, with or without contact.
pub fn crossing(elements: u32, contact: bool) -> String {
    let bodies = cable("below", [[-0.5, 0.0, 0.0], [0.5, 0.0, 0.0]], elements)
        + &cable("above", [[0.0, -0.5, 0.03], [0.0, 0.5, 0.03]], elements)
        + &pinned("below", "start")
        + &pinned("below", "end");
    model(&bodies, if contact { &[BODIES] } else { &[] })
}

/// Returns the model file of a cable on a hinge that falls on a plane, with or without contact.
pub fn plane(elements: u32, contact: bool) -> String {
    let bodies = cable("rope", [[0.0, 0.0, 0.2], [1.0, 0.0, 0.2]], elements) + &pinned("rope", "start");
    model(&bodies, if contact { &[GROUND] } else { &[] })
}

const GROUND: &str = "{ kind = \"plane\", point = [0, 0, 0], normal = [0, 0, 1] }";
const BODIES: &str = "{ kind = \"bodies\" }";

fn cable(name: &str, [from, to]: [[f64; 3]; 2], elements: u32) -> String {
    format!(
        "[[bodies]]\nkind = \"cable\"\nname = \"{name}\"\nfrom = {from:?}\nto = {to:?}\nelements = {elements}\nsection = \
         \"rope\"\nmaterial = \"rope\"\n\n"
    )
}

fn pinned(body: &str, end: &str) -> String {
    format!(
        "[[joints]]\nkind = \"spherical\"\nname = \"{body} {end}\"\na = {{ body = \"{body}\", at = \"{end}\" }}\n\n"
    )
}

fn model(bodies: &str, contacts: &[&str]) -> String {
    let contacts = contacts.iter().map(|with| {
        format!("[[contacts]]\nwith = {with}\nstiffness = 1e5\nfriction = 0.3\ndamping = 0.2\nslip_speed = 0.01\n\n")
    });
    let contacts = contacts.collect::<String>();
    format!(
        "gravity = [0.0, 0.0, -9.81]\n\n[materials.rope]\ndensity = 1140\nyoung = 5e7\ndamping = {{ strain = 1e-3 }}\n\n\
         [sections.rope]\nkind = \"circle\"\ndiameter = 0.02\n\n{bodies}{contacts}[analysis]\nkind = \"dynamics\"\n\
         duration = 1.0\nstep = {STEP:?}\nscheme = {{ spectral_radius = 0.8 }}\n"
    )
}
