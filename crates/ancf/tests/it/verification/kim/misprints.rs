//! Misprints of Kim et al. (2017): each test holds for the corrected formula and fails for the printed one.
//!
//! Tests of S₂ and Ŝ₆ of eqs (5) and (12) are in `src/mechanics/shape.rs`.

use std::sync::Arc;

use ancf::Model;
use ancf::mechanics::elements::{Beam24, Profile};
use ancf::mechanics::kinematics::BeamShape;
use ancf::model::{Material, ScaleChoice, Section, Slopes};
use ancf::solver::dynamics::SchemeCoefficients;
use ancf::solver::equations::{EquationsOfMotion, Local, State, Term, Weights};
use ancf::units::Scales;
use nalgebra::{DMatrix, Matrix3, Vector3};

use crate::common::assertions::assert_near;
use crate::common::continuum::{deformation_gradient, green_strain, integrate, shape_gradients};
use crate::common::models::rod;
use crate::common::solutions::equilibrium;

const LENGTH: f64 = 0.7;
const SECTION: Section = Section::rectangle(0.3, 0.2);
const MATERIAL: Material = Material::elastic(2.0, 30.0, 0.3);
/// Displacement gradient without symmetry.
const GRADIENT: Matrix3<f64> = Matrix3::new(0.2, -0.1, 0.3, 0.4, -0.3, 0.15, -0.2, 0.1, 0.25);

fn mass(model: &Model) -> DMatrix<f64> {
    let system = model.assemble().unwrap().system;
    let (n, mut k) = (system.coordinates(), system.matrix());
    let rest = State::rest(n, system.multipliers());
    system.tangent(&rest, Weights { q: 0.0, v: 0.0, a: 1.0 }, &mut k);
    let dense = k.dense();
    DMatrix::from_fn(n, n, |i, j| dense[i][j])
}

/// Eqs (18), (19): kinetic energy in units of F L is ½ ė*ᵀ M* ė* with M* = M / (F T²/L).
///
/// Corrected: (1/A*) ∫ ŜᵀŜ dV* with A* = A/L². Printed: ∫ ŜᵀŜ dV*. With the unit of time of eq. (7) the density is
/// ρ* = 1/A*; the printed matrix with ρ* = 1 has another unit of time.
#[test]
fn eqs_18_19_mass_matrix() {
    let mut model = rod::free(2);
    rod::beam(&mut model).slopes = Slopes::Length;
    model.scales = ScaleChoice::Paper;
    let Scales { length, time, force } = model.scales().scales;
    let scaled = model.scaled(&model.scales().scales);
    let area = model.sections["circle"].moments().area / length.powi(2);
    let right = mass(&model) / (force * time.powi(2) / length);
    assert!((mass(&scaled) - &right).amax() < 1e-14 * right.amax());
    assert!((scaled.materials["steel"].density * area - 1.0).abs() < 1e-14);

    let mut unit_density = scaled;
    rod::material(&mut unit_density).density = 1.0;
    let printed = mass(&unit_density);
    assert!(
        (&printed - &right * area).amax() < 1e-14 * printed.amax(),
        "printed: mass too small by A* = {area:.1e}"
    );
}

/// Energy density with variable factors of the cross terms of λ and of the shear terms of G.
fn energy_density(e: &Matrix3<f64>, cross: f64, shear: f64) -> f64 {
    let (lame, d) = (MATERIAL.lame(), e.diagonal());
    let products = d.x * d.y + d.x * d.z + d.y * d.z;
    let shears = e.m12 * e.m12 + e.m13 * e.m13 + e.m23 * e.m23;
    0.5 * ((lame.lambda + 2.0 * lame.shear) * d.norm_squared()
        + cross * lame.lambda * products
        + shear * lame.shear * shears)
}

fn element() -> (Beam24, [Vector3<f64>; 8]) {
    let shape = BeamShape { length: LENGTH, slope: LENGTH };
    let profile = Profile::new(shape, MATERIAL.lame(), MATERIAL.density, SECTION.moments(), Vector3::zeros());
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let beam = Beam24::new(0..24, [x, y, z], Arc::new(profile));
    let slopes = [x, y, z].map(|axis| axis * LENGTH);
    let [sx, sy, sz] = slopes;
    (beam, [Vector3::zeros(), sx, sy, sz, x * LENGTH, sx, sy, sz])
}

/// Elastic forces and strain energy at coordinates e.
fn forces(beam: &Beam24, reference: &[Vector3<f64>; 8], e: &[Vector3<f64>; 8]) -> ([Vector3<f64>; 8], f64) {
    let q: Vec<f64> = e.iter().zip(reference).flat_map(|(e, e0)| (e - e0).data.0[0]).collect();
    let at = Local { q: &q, v: &[0.0; 24], a: &[0.0; 24], lambda: &[], t: 0.0, load: 1.0 };
    let mut r = [0.0; 24];
    beam.residual(&at, &mut r);
    (std::array::from_fn(|k| Vector3::from_column_slice(&r[3 * k..3 * k + 3])), beam.energy(&at).strain)
}

/// Coordinates e of a bent, twisted, sheared and stretched element.
fn deformed(reference: &[Vector3<f64>; 8]) -> [Vector3<f64>; 8] {
    std::array::from_fn(|k| {
        let turn = Matrix3::from_fn(|i, j| ((3 * i + j + 2 * k) as f64).sin() * 0.3);
        reference[k] + (GRADIENT + turn) * reference[k]
    })
}

/// Eq. (27), corrected: factor 2 of the λ cross terms, 4G for shear strains. Printed: factor 1 and 2G.
#[test]
fn eq_27_strain_energy() {
    let (beam, reference) = element();
    let e = deformed(&reference);
    let energy = |cross: f64, shear: f64| {
        integrate(LENGTH, SECTION, |x| {
            let strain = green_strain(&deformation_gradient(&e, &shape_gradients(LENGTH, LENGTH, x)));
            energy_density(&strain, cross, shear)
        })
    };
    let exact = forces(&beam, &reference, &e).1;
    assert!((exact / energy(2.0, 4.0) - 1.0).abs() < 1e-13);
    assert!((exact / energy(1.0, 2.0) - 1.0).abs() > 0.01, "printed: λ and 2G");
    assert!((exact / energy(1.0, 4.0) - 1.0).abs() > 0.01, "printed: λ");
    assert!((exact / energy(2.0, 2.0) - 1.0).abs() > 0.01, "printed: 2G");
}

/// Eq. (31): K(e) e. The printed form is correct and agrees with the corrected eqs (27) and (28).
fn forces_of_eq_31(e: &[Vector3<f64>; 8], cross: f64, shear: f64) -> [Vector3<f64>; 8] {
    let lame = MATERIAL.lame();
    let component = |a: usize, i: usize| {
        integrate(LENGTH, SECTION, |x| {
            let s = shape_gradients(LENGTH, LENGTH, x);
            let j = deformation_gradient(e, &s);
            let metric = j.transpose() * j;
            let mut sum = 0.0;
            for alpha in 0..3 {
                for beta in 0..3 {
                    // Row a of S_αᵀ S_β e is S_{a,α} times column β of J.
                    let row = |alpha: usize, beta: usize| s[a][alpha] * j[(i, beta)];
                    let normal = 0.5 * row(alpha, alpha) * (metric[(beta, beta)] - 1.0);
                    sum += if alpha == beta {
                        (lame.lambda + 2.0 * lame.shear) * normal
                    } else {
                        cross * lame.lambda * normal
                            + shear * lame.shear * row(alpha, beta) * metric[(alpha, beta)]
                    };
                }
            }
            sum
        })
    };
    std::array::from_fn(|a| Vector3::from_fn(|i, _| component(a, i)))
}

/// Eq. (28), printed: half of the cross and shear terms, in contradiction to eq. (31).
#[test]
fn eq_28_elastic_forces() {
    let (beam, reference) = element();
    let e = deformed(&reference);
    let exact = forces(&beam, &reference, &e).0;
    let error = |other: [Vector3<f64>; 8]| {
        let largest = |x: &[Vector3<f64>]| x.iter().map(Vector3::amax).fold(0.0, f64::max);
        let difference: [_; 8] = std::array::from_fn(|k| other[k] - exact[k]);
        largest(&difference) / largest(&exact)
    };
    assert!(error(forces_of_eq_31(&e, 1.0, 1.0)) < 1e-12);
    assert!(error(forces_of_eq_31(&e, 0.5, 0.5)) > 0.01, "printed");
}

/// Eq. (24), corrected: σ_ii = λ tr ε + 2G ε_ii, no sum. Printed: σ_ij for all j, with λ tr ε in shear stresses.
///
/// In a homogeneous deformation J the end faces carry A J σ e_x; the forces on r₁ and r₂ measure σ.
#[test]
fn eq_24_stress() {
    let (beam, reference) = element();
    let j = Matrix3::identity() + GRADIENT;
    let end = forces(&beam, &reference, &reference.map(|e| j * e)).0[4];
    let (lame, strain) = (MATERIAL.lame(), green_strain(&j));
    let volume = lame.lambda * strain.trace();
    let face = |sigma: Matrix3<f64>| j * sigma.column(0) * SECTION.moments().area;
    let right = face(Matrix3::identity() * volume + strain * (2.0 * lame.shear));
    assert!((end - right).norm() < 1e-13 * right.norm());
    let printed = face(Matrix3::from_element(volume) + strain * (2.0 * lame.shear));
    assert!((end - printed).norm() > 0.01 * right.norm());
}

/// Eq. (36), corrected: eₙ₊₁ = eₙ + h vₙ + ... Printed: h vₙ₊₁, with an error g h t of free fall.
#[test]
fn eq_36_newmark() {
    let (h, steps, g) = (0.01, 100, -rod::GRAVITY);
    let mut s = State { q: vec![0.0], v: vec![0.0], a: vec![g], ..State::rest(1, 0) };
    let mut printed = [0.0, 0.0];
    for _ in 0..steps {
        SchemeCoefficients::ADAMS.predict(&mut s, &[g], h);
        s.add(&[0.0], SchemeCoefficients::ADAMS.weights(h)); // constant acceleration g
        printed[1] += h * g;
        printed[0] += h * printed[1] + 0.5 * h * h * g;
    }
    let t = h * f64::from(steps);
    assert_near("free fall", s.q[0], 0.5 * g * t * t, 1e-12);
    assert_near("free fall as printed", printed[0], 0.5 * g * t * t + g * h * t, 1e-12);
}

fn static_tip(model: &Model) -> f64 {
    let (assembly, state) = equilibrium(model, 1);
    1e3 * assembly.probes[0].1.value(&state).y
}

/// Table 2 prints a diameter of 0.20 m. With 0.02 m eq. (34) gives −2.040 mm and table 5 −2.037 mm.
#[test]
fn table_2_diameter() {
    let mut model = rod::cantilever(20);
    assert_near("0.02 m", static_tip(&model), -2.040, 1e-3);
    model.sections.insert("circle".into(), Section::circle(0.2));
    assert_near("0.20 m as printed", static_tip(&model), -0.0204, 5e-4);
}

/// Table 2 has no Poisson ratio. Table 5 converges to −2.037 mm, as with ν = 0; with ν = 0.3 the element locks.
#[test]
fn table_2_poisson_ratio() {
    let mut model = rod::cantilever(20);
    assert_near("nu = 0", static_tip(&model), -2.037, 5e-3);
    rod::material(&mut model).poisson = 0.3;
    assert_near("nu = 0.3", static_tip(&model), -1.515269895, 1e-7);
}
