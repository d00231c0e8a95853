//! Tests of all kinds of sections, on their examples.

use crate::units::Scaled;
use ancf_mechanics::sections::{Moments, SectionPoint};

use super::{OutlineCurve, Section};
use crate::units::Scales;

/// Number of sides of the polygon that replaces an ellipse.
const SIDES: usize = 4096;
/// Relative error of the second moment of that polygon, below 2π²·2/(3·4096²).
const POLYGON_ERROR: f64 = 1e-6;

fn assert_near(what: &str, section: &Section, found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs() / expected.abs();
    assert!(error <= tolerance, "{what} of {section:?}: {found:e}, expected {expected:e}");
}

/// Moments as an array, with the power of length of each.
fn listed(m: Moments) -> [(f64, i32); 6] {
    [(m.area, 2), (m.yy, 4), (m.zz, 4), (m.yyyy, 6), (m.yyzz, 6), (m.zzzz, 6)]
}

fn integral(points: &[SectionPoint], f: impl Fn(f64, f64) -> f64) -> f64 {
    points.iter().map(|p| p.weight * f(p.y, p.z)).sum()
}

/// Area, ∫y² dA and ∫z² dA within a polygon, by Green's theorem.
fn polygon_moments(corners: &[[f64; 2]]) -> [f64; 3] {
    let mut moments = [0.0; 3];
    for ([y0, z0], [y1, z1]) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        let cross = y0 * z1 - y1 * z0;
        moments[0] += cross / 2.0;
        moments[1] += cross * (y0 * y0 + y0 * y1 + y1 * y1) / 12.0;
        moments[2] += cross * (z0 * z0 + z0 * z1 + z1 * z1) / 12.0;
    }
    moments
}

fn outline_moments(section: &Section) -> [f64; 3] {
    let outline = section.shape().outline();
    let outer = polygon_moments(&outline.outer.corners(SIDES));
    let bore = outline.bore.map_or([0.0; 3], |bore| polygon_moments(&bore.corners(SIDES)));
    [0, 1, 2].map(|i| outer[i] - bore[i])
}

#[test]
fn examples_cover_all_kinds() {
    let schema = schemars::schema_for!(Section).to_value();
    let kinds = schema["oneOf"].as_array().expect("one form per kind");
    for kind in kinds {
        let word = &kind["properties"]["kind"]["const"];
        let of_kind = |section: &Section| {
            let data = serde_json::to_value(section).expect("numbers only");
            data["kind"] == *word
        };
        assert!(Section::examples().iter().any(of_kind), "{word}");
    }
}

#[test]
fn files_keep_sections() {
    for section in Section::examples() {
        let text = serde_json::to_string(&section).expect("numbers only");
        assert_eq!(serde_json::from_str::<Section>(&text).expect(&text), section);
        let unknown = text.replacen('{', "{\"unknown\": 1,", 1);
        assert!(serde_json::from_str::<Section>(&unknown).is_err(), "{unknown}");
    }
}

#[test]
fn moments_and_constants_are_positive() {
    for section in Section::examples() {
        let (area, mass) = (section.moments(), section.mass_moments());
        for (moment, _) in listed(area).into_iter().chain(listed(mass)) {
            assert!(moment > 0.0, "{section:?}: {moment}");
        }
        assert_eq!(area.area, mass.area, "{section:?}");
        let torsion = section.torsion_constant();
        assert!(torsion > 0.0, "{section:?}: {torsion}");
        for poisson in [0.0, 0.3, 0.49] {
            for factor in section.shear_factors(poisson) {
                assert!(factor > 0.0 && factor <= 1.0, "{section:?}: {factor}");
            }
        }
        // A section of known geometry is no stiffer in torsion than without warping (Saint-Venant).
        if section.points().is_some() {
            assert!(torsion <= (area.yy + area.zz) * (1.0 + 1e-14), "{section:?}: {torsion}");
        }
    }
}

/// The shear stresses of a twist have the torque G J κ and no shear force, are tangential at the outline, and have the largest value of a
/// rectangle of 2 : 1, T/(0.246 a b²) (Timoshenko & Goodier 1970, section 109).
#[test]
fn warping_is_that_of_the_torsion_constant() {
    for section in Section::examples() {
        let (shape, moments) = (section.shape(), section.moments());
        let Some(points) = section.points() else { continue };
        let shear = |y: f64, z: f64| {
            let [of_y, of_z] = shape.warping_gradient([y, z]);
            [of_y - z, of_z + y]
        };
        let torque = integral(&points, |y, z| y * shear(y, z)[1] - z * shear(y, z)[0]);
        // Half of the torque of a thin rectangle is that of its short sides, between the points.
        if moments.yy.max(moments.zz) < 10.0 * moments.yy.min(moments.zz) {
            assert_near("torque", &section, torque, section.torsion_constant(), 0.02);
        }
        for axis in [0, 1] {
            let force = integral(&points, |y, z| shear(y, z)[axis]);
            assert!(force.abs() < 1e-12 * moments.area.powf(1.5), "{section:?}: {force}");
        }
        let OutlineCurve::Polygon(corners) = shape.outline().outer else { continue };
        let [y, z] = corners.iter().fold([0.0_f64; 2], |[y, z], corner| [y.max(corner[0]), z.max(corner[1])]);
        for part in [-0.7, 0.0, 0.4] {
            let size = shear(y, 0.0)[1].abs().max(shear(0.0, z)[0].abs());
            assert!(shear(y, part * z)[0].abs() < 1e-4 * size, "{section:?}");
            assert!(shear(part * y, z)[1].abs() < 1e-4 * size, "{section:?}");
        }
    }
    for (height, width, at) in [(2.0, 1.0, [0.0, 0.5]), (1.0, 2.0, [0.5, 0.0])] {
        let section = Section::rectangle(height, width);
        let [of_y, of_z] = section.shape().warping_gradient(at);
        let largest = (of_y - at[1]).hypot(of_z + at[0]);
        assert_near("largest", &section, largest, section.torsion_constant() / (0.246 * 2.0), 2e-3);
    }
}

#[test]
fn moments_are_integrals_over_the_points() {
    for section in Section::examples() {
        let m = section.moments();
        let (points, degree) = match section.points() {
            Some(points) => (points, 4),
            None => (section.cross_section(0.3).points, 2),
        };
        let powers = [(0, 0), (2, 0), (0, 2), (4, 0), (2, 2), (0, 4)];
        for ((i, j), (moment, _)) in powers.into_iter().zip(listed(m)).filter(|((i, j), _)| i + j <= degree) {
            let found = integral(&points, |y, z| y.powi(i) * z.powi(j));
            assert_near(&format!("∫y^{i} z^{j}"), &section, found, moment, 1e-13);
        }
        for (i, j) in [(1, 0), (0, 1), (1, 1), (3, 0), (1, 2), (5, 2)] {
            assert_eq!(integral(&points, |y, z| y.powi(i) * z.powi(j)), 0.0, "{section:?}: odd moment");
        }
    }
}

#[test]
fn exact_outlines_have_the_moments() {
    for section in Section::examples().into_iter().filter(|section| section.points().is_some()) {
        let m = section.moments();
        let polygon = matches!(section.shape().outline().outer, OutlineCurve::Polygon(_));
        // The wall of a thin tube is a difference of two large areas.
        let outer = polygon_moments(&section.shape().outline().outer.corners(SIDES))[0];
        let tolerance = if polygon { 1e-14 } else { POLYGON_ERROR * outer / m.area };
        for (found, expected) in outline_moments(&section).into_iter().zip([m.area, m.yy, m.zz]) {
            assert_near("outline", &section, found, expected, tolerance);
        }
    }
}

/// Outlines of general sections have only the ratio of the second moments.
#[test]
fn outlines_have_the_ratio_of_second_moments() {
    for section in Section::examples() {
        let (m, [_, yy, zz]) = (section.moments(), outline_moments(&section));
        assert_near("outline: ∫y² dA / ∫z² dA", &section, yy / zz, m.yy / m.zz, 1e-12);
    }
}

#[test]
fn round_outlines_have_the_outer_radius() {
    for section in Section::examples() {
        let shape = section.shape();
        let Some(radius) = shape.outer_radius() else {
            assert_eq!(shape.displaced_area(), None, "{section:?}");
            continue;
        };
        assert_eq!(shape.outline().outer, OutlineCurve::Ellipse([radius; 2]), "{section:?}");
        let displaced = shape.displaced_area().expect("a round section displaces its disk");
        assert_eq!(displaced, Section::circle(2.0 * radius).moments().area, "{section:?}");
    }
}

#[test]
fn constants_scale_with_powers_of_length() {
    let scales = Scales { length: 0.25, time: 3.0, force: 70.0 };
    let unit = |power: i32| scales.length.powi(power);
    for section in Section::examples() {
        let scaled = section.clone().scaled(&scales);
        let moments = |s: &Section| [listed(s.moments()), listed(s.mass_moments())].concat();
        for ((own, power), (found, _)) in moments(&section).into_iter().zip(moments(&scaled)) {
            assert_near("moment in other units", &section, found, own / unit(power), 1e-14);
        }
        let torsion = section.torsion_constant() / unit(4);
        assert_near("torsion in other units", &section, scaled.torsion_constant(), torsion, 1e-13);
        for (own, found) in section.shear_factors(0.3).into_iter().zip(scaled.shear_factors(0.3)) {
            assert_near("shear factor in other units", &section, found, own, 1e-14);
        }
        let [own, found] = [&section, &scaled].map(|s| s.shape().outline().outer.corners(24));
        for (own, found) in own.iter().zip(&found) {
            for (own, found) in own.iter().zip(found) {
                assert!((found - own / unit(1)).abs() <= 1e-15 / unit(1), "{section:?}: outline");
            }
        }
        let radius = section.shape().outer_radius().map(|radius| radius / unit(1));
        assert_eq!(scaled.shape().outer_radius(), radius, "{section:?}");
        assert_eq!(scaled.scaled(&scales.inverse()), section);
    }
}

#[test]
fn interpolation_has_its_ends() {
    for start in Section::examples() {
        for end in Section::examples() {
            let same_kind = std::mem::discriminant(&start) == std::mem::discriminant(&end);
            let towards =
                |from: &Section, to: &Section, fraction| from.towards(to, fraction).map(|s| s.moments());
            assert_eq!(towards(&start, &end, 0.0), same_kind.then(|| start.moments()));
            let Some(reached) = start.towards(&end, 1.0) else { continue };
            for ((found, _), (expected, _)) in
                listed(reached.moments()).into_iter().zip(listed(end.moments()))
            {
                assert_near("end of the interpolation", &end, found, expected, 1e-12);
            }
            // Dimensions are linear: the half of the way from either end is the same section.
            let [there, back] = [towards(&start, &end, 0.5), towards(&end, &start, 0.5)].map(Option::unwrap);
            for ((found, _), (expected, _)) in listed(there).into_iter().zip(listed(back)) {
                assert_near("middle of the interpolation", &end, found, expected, 1e-12);
            }
        }
    }
}

#[test]
fn examples_pass_their_checks_and_wide_bores_do_not() {
    for section in Section::examples() {
        assert!(section.shape().check("sections.s").is_empty(), "{section:?}");
    }
    for inner in [0.3, 0.4] {
        let findings = Section::tube(0.3, inner).shape().check("sections.s");
        let [finding] = &findings[..] else { panic!("{findings:?}") };
        assert_eq!(finding.error.path, "sections.s.inner");
        assert_eq!(finding.error.found, inner.to_string());
        assert_eq!(finding.rests_on, ["sections.s.outer"]);
    }
}
