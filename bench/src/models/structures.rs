//! Model files of structures of many bodies.

use std::collections::BTreeMap;

/// Nylon ropes of 10 mm, steel bars of 20 mm, own weight along −z.
const HEAD: &str = r#"
gravity = [0.0, 0.0, -9.81]
materials.rope = { density = 1140.0, young = 2e9 }
materials.steel = { density = 7850.0, young = 2.1e11, poisson = 0.3 }
sections.rope = { kind = "circle", diameter = 0.01 }
sections.bar = { kind = "circle", diameter = 0.02 }
output = { every = 1000000, states = 0, parquet = false }
"#;

/// Number of elements of a cable of the platform.
const CABLE: u32 = 10;

/// Bodies and joints of a model file.
#[derive(Default)]
struct StructureFile {
    bodies: Vec<String>,
    joints: Vec<String>,
}

impl StructureFile {
    fn cable(&mut self, name: &str, [from, to]: [[f64; 3]; 2], elements: u32) {
        self.bodies.push(format!(
            r#"{{ kind = "cable", name = "{name}", from = {from:?}, to = {to:?}, elements = {elements}, section = "rope", material = "rope" }}"#
        ));
    }

    /// Adds a joint of a point with another one or with the ground. A point is a body and a place.
    fn joint(&mut self, kind: &str, (a, at): (&str, &str), b: Option<(&str, &str)>) {
        let number = self.joints.len();
        let b = b.map(|(body, at)| format!(r#", b = {{ body = "{body}", at = {at} }}"#)).unwrap_or_default();
        let a = format!(r#"a = {{ body = "{a}", at = {at} }}"#);
        self.joints.push(format!(r#"{{ kind = "{kind}", name = "j{number}", {a}{b} }}"#));
    }

    /// Returns the text with a number of steps of a size in seconds.
    fn text(&self, steps: u32, step: f64) -> String {
        let duration = f64::from(steps) * step;
        let scheme = "scheme = { spectral_radius = 0.8 }";
        let [bodies, joints] = [&self.bodies, &self.joints].map(|list| list.join(",\n  "));
        format!(
            "{HEAD}bodies = [\n  {bodies},\n]\njoints = [\n  {joints},\n]\n\
             analysis = {{ kind = \"dynamics\", duration = {duration:?}, step = {step:?}, {scheme} }}\n"
        )
    }
}

const START: &str = "\"start\"";
const END: &str = "\"end\"";

/// Returns the model file of a rigid platform on cables from the ground, with steps of 2 ms.
pub fn platform(cables: u32, steps: u32) -> String {
    let mut file = StructureFile::default();
    let (mass, inertia) = (5.0 * f64::from(cables), [2.0 * f64::from(cables); 3]);
    file.bodies.push(format!(
        r#"{{ kind = "rigid", name = "deck", center = [0.0, 0.0, 0.0], mass = {mass:?}, inertia = {inertia:?} }}"#
    ));
    let wide = f64::from(cables).sqrt().ceil();
    for c in 0..cables {
        let place = |number: f64| 10.0 * (number / wide - 0.5);
        let (x, y) = (place(f64::from(c) % wide), place((f64::from(c) / wide).floor()));
        let name = format!("c{c}");
        file.cable(&name, [[1.3 * x, 1.3 * y, 6.0], [x, y, 0.0]], CABLE);
        file.joint("spherical", (&name, START), None);
        file.joint("spherical", (&name, END), Some(("deck", &format!("{:?}", [x, y, 0.0]))));
    }
    file.text(steps, 2e-3)
}

/// Returns the model file of beams of two elements along the edges of n³ cubes of 1 m, with steps of 1 ms. Beams are
/// clamped to each other at the corners and to the ground at the feet.
pub fn lattice(cells: u32, steps: u32) -> String {
    let mut file = StructureFile::default();
    let mut first: BTreeMap<[u32; 3], (String, &str)> = BTreeMap::new();
    let n = cells + 1;
    for number in 0..3 * n * n * n {
        let (corner, along) = (number / 3, (number % 3) as usize);
        let start = [corner / (n * n), corner / n % n, corner % n];
        let mut end = start;
        end[along] += 1;
        if end[along] > cells || (along < 2 && start[2] == 0) {
            continue;
        }
        let name = format!("b{}", file.bodies.len());
        let [from, to] = [start, end].map(|corner| corner.map(f64::from));
        file.bodies.push(format!(
            r#"{{ kind = "beam", name = "{name}", from = {from:?}, to = {to:?}, elements = 2, formulation = "linked", section = "bar", material = "steel" }}"#
        ));
        for (corner, at) in [(start, START), (end, END)] {
            match first.get(&corner) {
                _ if corner[2] == 0 => file.joint("clamp", (&name, at), None),
                Some((other, there)) => file.joint("clamp", (&name, at), Some((other, *there))),
                None => _ = first.insert(corner, (name.clone(), at)),
            }
        }
    }
    file.text(steps, 1e-3)
}

/// Returns the model file of a square net of cables with a node and a spherical joint at each knot, with steps of 2 ms.
/// Every fifth cable of one direction is supported at its ends.
pub fn net(knots: u32, steps: u32) -> String {
    let mut file = StructureFile::default();
    let last = f64::from(knots - 1);
    for c in 0..knots {
        let side = f64::from(c);
        file.cable(&format!("x{c}"), [[0.0, side, 0.0], [last, side, 0.0]], knots - 1);
        file.cable(&format!("y{c}"), [[side, 0.0, 0.0], [side, last, 0.0]], knots - 1);
    }
    let at = |k: u32| match k {
        0 => START.to_owned(),
        k if k + 1 == knots => END.to_owned(),
        k => format!("{:?}", f64::from(k)),
    };
    for (i, j) in (0..knots).flat_map(|i| (0..knots).map(move |j| (i, j))) {
        let (x, y) = (format!("x{j}"), format!("y{i}"));
        file.joint("spherical", (&x, &at(i)), Some((&y, &at(j))));
    }
    for c in (0..knots).step_by(5) {
        for end in [START, END] {
            file.joint("spherical", (&format!("x{c}"), end), None);
        }
    }
    file.text(steps, 2e-3)
}
