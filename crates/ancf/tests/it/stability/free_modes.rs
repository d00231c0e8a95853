//! Rigid modes of free structures: zero in all units, for fewer modes than rigid motions.

use ancf::record::Series;
use ancf::{Model, Outcome, simulate};

/// Two beams at an angle without support, of unlike formulations.
fn pair(count: u32, scales: &str, slopes: &str) -> Model {
    Model::parse(&format!(
        "scales = {scales}
        materials.m = {{ density = 2600, young = 1.4e7, poisson = 0.4 }}
        sections.a = {{ kind = \"circle\", diameter = 0.07 }}
        sections.b = {{ kind = \"ellipse\", height = 0.07, width = 0.1 }}
        bodies = [
          {{ kind = \"beam\", name = \"first\", from = [0, 0, 0], to = [0.6, 0.35, 0.1], elements = 3, formulation = \"linked\", section = \"a\", material = \"m\", slopes = \"{slopes}\" }},
          {{ kind = \"beam\", name = \"second\", from = [0, 0, 0], to = [0, 1.1, 0], elements = 4, formulation = \"enhanced\", section = \"b\", material = \"m\", slopes = \"{slopes}\" }},
        ]
        joints = [{{ kind = \"clamp\", name = \"weld\", a = {{ body = \"second\", at = \"start\" }}, b = {{ body = \"first\", at = \"start\" }} }}]
        analysis = {{ kind = \"modes\", count = {count} }}"
    ))
    .unwrap()
}

#[test]
fn free_structures_have_six_zero_frequencies() {
    let scales = [
        "{ kind = \"none\" }",
        "{ kind = \"auto\" }",
        "{ kind = \"given\", length = 0.013, force = 71, time = 37 }",
        "{ kind = \"given\", length = 42, force = 0.02, time = 0.015 }",
    ];
    for scales in scales {
        for slopes in ["gradient", "length"] {
            for count in [1, 2, 3, 5, 6, 8] {
                let mut series = Series::new();
                let summary = simulate(&pair(count, scales, slopes), &mut series).unwrap();
                let name = format!("{count} modes, {scales}, {slopes}");
                assert!(matches!(summary.outcome, Outcome::Finished), "{name}: {:?}", summary.outcome);
                let found = series.column("frequency").unwrap();
                assert_eq!(found.len(), count as usize, "{name}");
                assert!(found.iter().take(6).all(|f| *f == 0.0), "{name}: {found:?}");
                assert!(found.iter().skip(6).all(|f| *f > 1.0), "{name}: {found:?}");
            }
        }
    }
}
