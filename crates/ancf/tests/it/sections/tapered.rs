//! Tapered beams with general sections.

use ancf::record::Series;
use ancf::{Model, simulate};

const YOUNG: f64 = 2e11;
const LENGTH: f64 = 1.5;
const FORCE: f64 = 4.0;

/// Deflection of a cantilever under a force at its tip, F ∫ (L − x)²/(E I(x)) dx with I linear in x, without shear.
#[test]
fn constants_of_general_sections_vary_linearly() {
    let [first, last] = [8e-9, 2e-9];
    let text = format!(
        r#"
        materials.steel = {{ density = 7850, young = {YOUNG} }}
        sections.root = {{ kind = "general", area = 4e-4, iy = 3e-9, iz = {first}, ky = 1e4, kz = 1e4 }}
        sections.tip = {{ kind = "general", area = 2e-4, iy = 1e-9, iz = {last}, j = 2e-9, ky = 1e4, kz = 1e4 }}
        bodies = [{{ kind = "beam", name = "blade", from = [0, 0, 0], to = [{LENGTH}, 0, 0], elements = 40, formulation = "quadratic", section = "root", section_end = "tip", material = "steel" }}]
        joints = [{{ kind = "clamp", name = "hub", a = {{ body = "blade", at = "start" }} }}]
        loads = [{{ kind = "force", on = {{ body = "blade", at = "end" }}, force = [0, {FORCE}, 0] }}]
        probes = [{{ name = "tip", on = {{ body = "blade", at = "end" }} }}]
        analysis = {{ kind = "statics" }}
        "#
    );
    let mut series = Series::new();
    let summary = simulate(&Model::parse(&text).unwrap(), &mut series).unwrap();
    assert!(summary.outcome.is_finished());
    let found = *series.column("tip.y").unwrap().last().unwrap();
    let flexibility = |x: f64| (LENGTH - x).powi(2) / (YOUNG * (first + (last - first) * x / LENGTH));
    // Simpson's rule.
    let cells = 1000;
    let width = LENGTH / f64::from(cells);
    let cell = |k: u32| {
        let x = width * f64::from(k);
        (flexibility(x) + 4.0 * flexibility(x + 0.5 * width) + flexibility(x + width)) * width / 6.0
    };
    let exact = FORCE * (0..cells).map(cell).sum::<f64>();
    assert!((found / exact - 1.0).abs() < 1e-3, "{found} and {exact}");
    let prismatic = FORCE * LENGTH.powi(3) / (3.0 * YOUNG * first);
    assert!(exact > 1.1 * prismatic, "the taper matters");
}

/// Mass of the frustum of a cone, ρ π L (D² + D d + d²)/12, by the model and as the weight that the clamp supports.
#[test]
fn mass_of_a_tapered_beam_is_that_of_the_frustum() {
    let [wide, narrow, density, gravity] = [0.06_f64, 0.02, 2700.0, 9.81];
    let text = format!(
        r#"
        gravity = [0, 0, -{gravity}]
        materials.alloy = {{ density = {density}, young = 7e10 }}
        sections.root = {{ kind = "circle", diameter = {wide} }}
        sections.tip = {{ kind = "circle", diameter = {narrow} }}
        bodies = [{{ kind = "beam", name = "horn", from = [0, 0, 0], to = [0, 0, {LENGTH}], elements = 3, formulation = "linked", section = "root", section_end = "tip", material = "alloy" }}]
        joints = [{{ kind = "clamp", name = "foot", a = {{ body = "horn", at = "start" }} }}]
        analysis = {{ kind = "statics" }}
        "#
    );
    let model = Model::parse(&text).unwrap();
    let exact =
        density * std::f64::consts::PI * LENGTH * (wide.powi(2) + wide * narrow + narrow.powi(2)) / 12.0;
    assert!((model.mass() / exact - 1.0).abs() < 1e-14, "{} and {exact}", model.mass());
    let mut series = Series::new();
    assert!(simulate(&model, &mut series).unwrap().outcome.is_finished());
    let reaction = series.column("foot.fz").unwrap().last().unwrap();
    assert!((reaction / (exact * gravity) - 1.0).abs() < 1e-9, "{reaction} and {}", exact * gravity);
}
