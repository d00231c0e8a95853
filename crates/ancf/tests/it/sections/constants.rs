//! Geometric constants of cross-sections against integrals and boundary value problems of elasticity.

use std::f64::consts::{PI, TAU};
use std::path::Path;

use ancf::Model;
use ancf::mechanics::kinematics::gauss;
use ancf::mechanics::sections::SectionPoint;
use ancf::model::{Circle, Ellipse, GeneralSection, Rectangle, Section, Tube};
use ancf::units::Scales;
use nalgebra::{DMatrix, DVector};

use crate::common::assertions::assert_relative;
use crate::common::continuum;

const SOLID: [Section; 5] = [
    Section::circle(0.3),
    Section::tube(0.4, 0.25),
    Section::rectangle(0.3, 0.2),
    Section::rectangle(0.1, 0.35),
    Section::ellipse(0.2, 0.4),
];

fn integral(points: &[SectionPoint], f: impl Fn(f64, f64) -> f64) -> f64 {
    points.iter().map(|p| p.weight * f(p.y, p.z)).sum()
}

#[test]
fn moments_of_area_are_integrals() {
    for section in SOLID {
        let m = section.moments();
        let moments =
            [(0, 0, m.area), (2, 0, m.yy), (0, 2, m.zz), (4, 0, m.yyyy), (2, 2, m.yyzz), (0, 4, m.zzzz)];
        for (i, j, expected) in moments {
            let found = continuum::integrate(1.0, section.clone(), |[_, y, z]| y.powi(i) * z.powi(j));
            assert_relative(&format!("{section:?}: y^{i} z^{j}"), found, expected, 1e-14);
        }
        assert_eq!(section.mass_moments(), m);
    }
}

/// The 16 points integrate all monomials up to degree seven.
#[test]
fn points_are_exact_to_degree_seven() {
    for section in SOLID {
        let points = section.points().expect("the section has a shape");
        assert_eq!(points.len(), 16);
        for degree in 0..=7 {
            for i in 0..=degree {
                let product = |y: f64, z: f64| y.powi(i) * z.powi(degree - i);
                let expected = continuum::integrate(1.0, section.clone(), |[_, y, z]| product(y, z));
                let found = integral(&points, product);
                if i % 2 == 0 && degree % 2 == 0 {
                    assert_relative(&format!("{section:?}: degree {degree}"), found, expected, 1e-13);
                } else {
                    assert_eq!(found, 0.0, "{section:?}: an odd moment");
                }
            }
        }
    }
}

#[test]
fn tube_and_ellipse_have_the_limits_of_circle_and_thin_tube() {
    let circle = Section::circle(0.3);
    let tube = Section::tube(0.3, 1e-12);
    let ellipse = Section::ellipse(0.3, 0.3);
    for other in [tube, ellipse] {
        let (a, b) = (circle.moments(), other.moments());
        for (a, b) in [(a.area, b.area), (a.yy, b.yy), (a.zz, b.zz), (a.yyyy, b.yyyy), (a.yyzz, b.yyzz)] {
            assert_relative("moments", b, a, 1e-15);
        }
        assert_relative("torsion", other.torsion_constant(), circle.torsion_constant(), 1e-15);
        for poisson in [0.0, 0.3, -0.2] {
            let (a, b) = (circle.shear_factors(poisson), other.shear_factors(poisson));
            assert_relative("shear along y", b[0], a[0], 1e-15);
            assert_relative("shear along z", b[1], a[1], 1e-15);
        }
    }
    // Thin tube of radius r and wall thickness t: shear factor 2(1+ν)/(4+3ν) by Cowper (1966).
    let (r, t) = (1.0, 1e-9);
    let thin = Section::tube(2.0 * r + t, 2.0 * r - t);
    assert_relative("area of a thin tube", thin.moments().area, TAU * r * t, 1e-7);
    assert_relative("second moment of a thin tube", thin.moments().yy, PI * r.powi(3) * t, 1e-7);
    assert_relative("torsion of a thin tube", thin.torsion_constant(), TAU * r.powi(3) * t, 1e-7);
    assert_relative("shear of a thin tube", thin.shear_factors(0.3)[0], 2.0 * 1.3 / (4.0 + 3.0 * 0.3), 1e-9);
}

/// A general section has the given constants; defaults are those of the moments of area.
#[test]
fn general_section_has_the_given_constants() {
    let ellipse = Section::ellipse(0.2, 0.4);
    let m = ellipse.moments();
    let (area, iy, iz) = (m.area, m.zz, m.yy);
    let general = Section::General(GeneralSection {
        area,
        iy,
        iz,
        j: None,
        ky: 1.0,
        kz: 1.0,
        mass_iy: None,
        mass_iz: None,
    });
    assert_eq!(general.moments(), m);
    assert_eq!(general.mass_moments(), m);
    assert_eq!(general.torsion_constant(), iy + iz);
    assert_eq!(general.points(), None);
    let general = Section::General(GeneralSection {
        area,
        iy,
        iz,
        j: Some(7.0),
        ky: 0.5,
        kz: 2.0,
        mass_iy: Some(10.0),
        mass_iz: Some(20.0),
    });
    assert_eq!(general.moments(), m);
    assert_eq!((general.mass_moments().zz, general.mass_moments().yy), (10.0, 20.0));
    assert_eq!((general.torsion_constant(), general.shear_factors(0.3)), (7.0, [0.5, 2.0]));
}

/// Constants scale with powers of the unit of length.
#[test]
fn constants_scale_with_the_unit_of_length() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/models/good/sections.toml");
    let model = Model::read(path).expect("the model is valid");
    let scaled = model.scaled(&Scales { length: 0.25, time: 3.0, force: 70.0 });
    assert_eq!(model.sections.len(), 6);
    for (name, section) in &model.sections {
        let other = &scaled.sections[name];
        let (m, n) = (section.moments(), other.moments());
        let (mass, other_mass) = (section.mass_moments(), other.mass_moments());
        let pairs = [
            (m.area, n.area, 2),
            (m.yy, n.yy, 4),
            (m.zz, n.zz, 4),
            (m.yyzz, n.yyzz, 6),
            (mass.yy, other_mass.yy, 4),
            (mass.zz, other_mass.zz, 4),
            (section.torsion_constant(), other.torsion_constant(), 4),
        ];
        for (own, other, power) in pairs {
            assert_relative(name, other, own / 0.25_f64.powi(power), 1e-14);
        }
        for (own, other) in section.shear_factors(0.3).iter().zip(other.shear_factors(0.3)) {
            assert_relative(name, other, *own, 1e-14);
        }
    }
}

/// Height is measured along y: it determines ∫y² dA and the shear factor for forces along y.
#[test]
fn height_is_measured_along_y() {
    for section in [Section::rectangle(2.0, 1.0), Section::ellipse(2.0, 1.0)] {
        assert!(section.moments().yy > section.moments().zz);
        let points = section.points().expect("the section has a shape");
        assert!(integral(&points, |y, _| y * y) > integral(&points, |_, z| z * z));
    }
    let [ky, kz] = Section::ellipse(2.0, 1.0).shear_factors(0.3);
    assert!(ky > kz, "{ky} along the longer axis, {kz} along the shorter");
}

/// J = k a b³ with k by Timoshenko & Goodier (1970), table 11 (k₁).
///
/// Values of eq. (160) there with 20 000 terms in 30 digits (mpmath).
#[test]
fn torsion_of_rectangles_equals_the_tables() {
    let table = [
        (1.0, 0.1406),
        (1.2, 0.166),
        (1.5, 0.196),
        (2.0, 0.229),
        (2.5, 0.249),
        (3.0, 0.263),
        (4.0, 0.281),
        (5.0, 0.291),
        (10.0, 0.312),
    ];
    for (ratio, k) in table {
        for (height, width) in [(ratio, 1.0), (1.0, ratio)] {
            let found = Section::rectangle(height, width).torsion_constant() / ratio;
            assert!((found - k).abs() < 6e-4, "{ratio}: {found} and {k}");
        }
    }
    let digits = [
        (1.0, 1.0, 0.140_577_014_955_153_7),
        (0.05, 0.005, 1.952_031_484_107_533_7e-9),
        (3.2024, 12.377, 113.399_529_560_885_51),
    ];
    for (height, width, expected) in digits {
        assert_relative("torsion", Section::rectangle(height, width).torsion_constant(), expected, 1e-15);
    }
    let thin = Section::rectangle(1e6, 1.0).torsion_constant();
    assert_relative("very thin strip", thin, 1e6 / 3.0, 1e-6);
}

/// Navier series J = (256/π⁶) a³b³ Σ 1/(m²n²(m²b² + n²a²)) over odd m, n.
#[test]
fn torsion_of_rectangles_equals_the_double_series() {
    for (a, b) in [(1.0, 1.0), (3.0, 2.0), (12.377, 3.2024)] {
        let odd = || (0..1000).map(|k| f64::from(2 * k + 1).powi(2));
        let inner = |m: f64| odd().map(|n| 1.0 / (m * n * (m * b * b + n * a * a))).sum::<f64>();
        let sum: f64 = odd().map(inner).sum();
        let expected = 256.0 / PI.powi(6) * (a * b).powi(3) * sum;
        let found = Section::rectangle(a, b).torsion_constant();
        assert_relative(&format!("{a} x {b}"), found, expected, 1e-9);
    }
}

/// Boundary point and outward normal.
type Edge = ([f64; 2], [f64; 2]);

/// Points and weights of a fine rule on a section.
fn fine(section: Section) -> Vec<([f64; 2], f64)> {
    let cells = |n: u32| {
        let cell = move |k: u32| gauss().map(|(x, w)| ((f64::from(k) + x) / f64::from(n), w / f64::from(n)));
        (0..n).flat_map(cell).collect::<Vec<_>>()
    };
    let (u, v) = (cells(12), cells(12));
    let pairs = u.iter().flat_map(|&(x, w)| v.iter().map(move |&(y, q)| (x, y, w * q)));
    let rings = |height: f64, width: f64, m: f64, (x, angle, w): (f64, f64, f64)| {
        let r = m + (1.0 - m) * x;
        let (sin, cos) = (TAU * angle).sin_cos();
        ([0.5 * height * r * cos, 0.5 * width * r * sin], 0.25 * TAU * height * width * (1.0 - m) * r * w)
    };
    match section {
        Section::Rectangle(Rectangle { height, width }) => {
            pairs.map(|(y, z, w)| ([height * (y - 0.5), width * (z - 0.5)], height * width * w)).collect()
        }
        Section::Circle(Circle { diameter }) => pairs.map(|p| rings(diameter, diameter, 0.0, p)).collect(),
        Section::Ellipse(Ellipse { height, width }) => pairs.map(|p| rings(height, width, 0.0, p)).collect(),
        Section::Tube(Tube { outer, inner }) => {
            pairs.map(|p| rings(outer, outer, inner / outer, p)).collect()
        }
        Section::General(_) | Section::Custom(_) => panic!("the section has no known shape"),
    }
}

/// Boundary points with y, z > 0; the others follow by symmetry.
fn edges(section: Section) -> Vec<Edge> {
    let n = 200;
    let parts = (0..n).map(|k| (f64::from(k) + 0.5) / f64::from(n));
    let ellipse = |height: f64, width: f64, sign: f64| {
        parts.clone().map(move |part| {
            let (sin, cos) = (0.25 * TAU * part).sin_cos();
            let normal = [sign * cos / height, sign * sin / width];
            let size = normal[0].hypot(normal[1]);
            ([0.5 * height * cos, 0.5 * width * sin], normal.map(|x| x / size))
        })
    };
    match section {
        Section::Rectangle(Rectangle { height: h, width: w }) => {
            let top = parts.clone().map(|x| ([0.5 * h, 0.5 * w * x], [1.0, 0.0]));
            top.chain(parts.clone().map(|x| ([0.5 * h * x, 0.5 * w], [0.0, 1.0]))).collect()
        }
        Section::Circle(Circle { diameter }) => ellipse(diameter, diameter, 1.0).collect(),
        Section::Ellipse(Ellipse { height, width }) => ellipse(height, width, 1.0).collect(),
        Section::Tube(Tube { outer, inner }) => {
            ellipse(outer, outer, 1.0).chain(ellipse(inner, inner, -1.0)).collect()
        }
        Section::General(_) | Section::Custom(_) => panic!("the section has no known shape"),
    }
}

/// Returns Re (y + iz)^k and its gradient.
fn harmonic(k: i32, [y, z]: [f64; 2]) -> (f64, [f64; 2]) {
    let (r, angle) = (y.hypot(z), z.atan2(y));
    let power =
        |k: i32| (r.powi(k) * (f64::from(k) * angle).cos(), -r.powi(k) * (f64::from(k) * angle).sin());
    let (re, im) = power(k - 1);
    (power(k).0, [f64::from(k) * re, f64::from(k) * im])
}

/// Solves a linear least-squares problem, given its rows and right-hand sides.
fn fit(rows: &[(Vec<f64>, f64)]) -> DVector<f64> {
    let matrix = DMatrix::from_fn(rows.len(), rows[0].0.len(), |i, j| rows[i].0[j]);
    let right = DVector::from_fn(rows.len(), |i, _| rows[i].1);
    let scale: Vec<f64> = matrix.column_iter().map(|column| column.norm()).collect();
    let scaled = DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)] / scale[j]);
    let solution = scaled.svd(true, true).solve(&right, 1e-14).expect("both singular matrices are computed");
    solution.map_with_location(|i, _, x| x / scale[i])
}

/// Torsion constant J = 2∫φ dA by Prandtl's stress function, ∇²φ = −2 and φ = 0 on the boundary, in harmonic polynomials.
fn torsion_by_prandtl(section: Section) -> f64 {
    let powers: Vec<i32> = (0..20).map(|k| 2 * k).collect();
    let row = |&(at, _): &Edge| {
        let values = powers.iter().map(|&k| harmonic(k, at).0).collect();
        (values, 0.5 * (at[0] * at[0] + at[1] * at[1]))
    };
    let weights = fit(&edges(section.clone()).iter().map(row).collect::<Vec<_>>());
    let stress = |at: [f64; 2]| {
        let harmonic: f64 = powers.iter().zip(&weights).map(|(&k, w)| w * harmonic(k, at).0).sum();
        harmonic - 0.5 * (at[0] * at[0] + at[1] * at[1])
    };
    2.0 * fine(section).iter().map(|&(at, w)| w * stress(at)).sum::<f64>()
}

#[test]
fn torsion_constant_solves_prandtls_problem() {
    let sections = [
        (Section::circle(0.3), 1e-12),
        (Section::ellipse(0.2, 0.4), 1e-12),
        (Section::ellipse(0.5, 0.1), 1e-12),
        (Section::rectangle(0.3, 0.3), 1e-6),
        (Section::rectangle(0.3, 0.2), 1e-6),
        (Section::rectangle(0.1, 0.3), 1e-5),
    ];
    for (section, tolerance) in sections {
        let (found, expected) = (section.torsion_constant(), torsion_by_prandtl(section.clone()));
        assert_relative(&format!("{section:?}"), found, expected, tolerance);
    }
}

/// Cowper's shear coefficient for a force along y from the flexure function χ of the section.
///
/// K = 2(1+ν)I / [½ν(I' − I) − (A/I) ∫ y(χ + y z²) dA] with I = ∫y² dA, I' = ∫z² dA, where ∇²χ = 0 inside and
/// ∂χ/∂n = −n_y[½νy² + (1−½ν)z²] − n_z(2+ν)yz on the boundary (Love 1927, section 229; Cowper 1966).
fn shear_by_flexure(section: Section, poisson: f64) -> f64 {
    let hollow = matches!(section, Section::Tube(_));
    let powers: Vec<i32> =
        if hollow { vec![1, 3, 5, -1, -3, -5] } else { (0..20).map(|k| 2 * k + 1).collect() };
    let row = |&([y, z], [ny, nz]): &Edge| {
        let slope = |k: i32| harmonic(k, [y, z]).1;
        let values = powers.iter().map(|&k| slope(k)[0] * ny + slope(k)[1] * nz).collect();
        let pull = 0.5 * poisson * y * y + (1.0 - 0.5 * poisson) * z * z;
        (values, -ny * pull - nz * (2.0 + poisson) * y * z)
    };
    let weights = fit(&edges(section.clone()).iter().map(row).collect::<Vec<_>>());
    let chi = |at| powers.iter().zip(&weights).map(|(&k, w)| w * harmonic(k, at).0).sum::<f64>();
    let m = section.moments();
    let warped: f64 = fine(section).iter().map(|&([y, z], w)| w * y * (chi([y, z]) + y * z * z)).sum();
    2.0 * (1.0 + poisson) * m.yy / (0.5 * poisson * (m.zz - m.yy) - m.area / m.yy * warped)
}

#[test]
fn shear_factors_solve_the_flexure_problem() {
    for (section, tolerance) in SOLID.into_iter().zip([1e-12, 1e-12, 1e-5, 1e-5, 1e-12]) {
        let (y, z) = match section {
            Section::Rectangle(Rectangle { height, width }) => {
                (section.clone(), Section::rectangle(width, height))
            }
            Section::Ellipse(Ellipse { height, width }) => (section.clone(), Section::ellipse(width, height)),
            ref round => (round.clone(), round.clone()),
        };
        for poisson in [0.0, 0.3, 0.45, -0.2] {
            let [ky, kz] = section.shear_factors(poisson);
            assert_relative(
                &format!("{section:?} along y, {poisson}"),
                ky,
                shear_by_flexure(y.clone(), poisson),
                tolerance,
            );
            assert_relative(
                &format!("{section:?} along z, {poisson}"),
                kz,
                shear_by_flexure(z.clone(), poisson),
                tolerance,
            );
        }
    }
}
