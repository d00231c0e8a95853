//! Batches of terms (SIMD lanes) agree with single terms to rounding, for all kinds of elements, rigid bodies and joints.
//!
//! A body has a full and a partial batch.

use std::sync::Arc;

use ancf::Model;
use ancf::mechanics::batches::term_batches;
use ancf::mechanics::bodies::BeamMesh;
use ancf::model::{Body, Cable, Damping, InitialMotion, MaterialLaw, Section, Slopes};
use ancf::solver::equations::{Batch, Energy, LANES, Lanes, Level, LocalLanes, Power, Term, Weights};
use nalgebra::{DMatrix, DVector, Vector3};

use crate::common::models::beams::{BY_KIND, BeamCase, beam_cases};
use crate::common::models::{parse, rod};
use crate::common::random::Random;
use crate::common::sample::{Sample, residual, stress_prediction, tangent};

/// Elements of a body: one full batch and one of three elements.
const ELEMENTS: u32 = 11;
const TOLERANCE: f64 = 1e-13;

/// Terms and their batches, each with the indices of its terms.
struct BatchCase {
    name: String,
    terms: Vec<Arc<dyn Term>>,
    batches: Vec<(Vec<usize>, Box<dyn Batch>)>,
}

impl BatchCase {
    fn new(name: String, terms: impl IntoIterator<Item = Arc<dyn Term>>) -> Self {
        let terms: Vec<Arc<dyn Term>> = terms.into_iter().collect();
        Self { name, batches: term_batches(&terms), terms }
    }
}

fn case(name: String, model: &Model) -> BatchCase {
    let assembly = model.assemble().unwrap();
    let mesh: &BeamMesh = assembly.mesh("rod").unwrap();
    BatchCase::new(name, mesh.terms().into_iter().map(Arc::from))
}

/// Rigid bodies and point masses in a row, with joints of a kind to the next body and to the ground, at oblique places.
fn jointed(name: &str, joint: &str) -> BatchCase {
    let mut text = String::from("gravity = [0.3, -2.0, 0.7]\nbodies = [\n");
    for k in 0..ELEMENTS {
        let (x, more) = (f64::from(k), 0.1 * f64::from(k % 3));
        text += &format!(
            "  {{ kind = \"rigid\", name = \"b{k}\", center = [{x}, {more}, 0.2], mass = {}, \
             inertia = [{}, 1.5, 1.8], products = [0.1, {more}, -0.3] }},\n  \
             {{ kind = \"mass\", name = \"m{k}\", center = [{x}, 1, 0], mass = 2 }},\n",
            3.0 + more,
            2.0 + more
        );
    }
    text += "]\njoints = [\n";
    for k in 0..ELEMENTS {
        let at = format!("[{}, 0.3, 0.4]", f64::from(k) + 0.45);
        let next = k + 1;
        let end = if next < ELEMENTS {
            format!(", b = {{ body = \"b{next}\", at = {at} }}")
        } else {
            String::new()
        };
        text += &format!("  {{ name = \"j{k}\", a = {{ body = \"b{k}\", at = {at} }}{end}, {joint} }},\n");
    }
    text += "]\nanalysis = { kind = \"dynamics\", duration = 1, step = 1e-3 }\n";
    BatchCase::new(name.to_owned(), parse(&text).assemble().unwrap().system.terms().iter().cloned())
}

/// Rigid bodies with joints of all kinds that have quadratic constraints.
fn joints() -> impl Iterator<Item = BatchCase> {
    let axis = "axis = [0.48, 0.6, -0.64]";
    let kinds = [
        ("clamp", "kind = \"clamp\"".to_owned()),
        ("hinge", format!("kind = \"revolute\", {axis}")),
        ("hinge along x", "kind = \"revolute\", axis = [1, 0, 0]".to_owned()),
        ("ball joint", "kind = \"spherical\"".to_owned()),
        ("universal joint", "kind = \"universal\", axis_a = [0.6, 0.8, 0], axis_b = [0, 0, 1]".to_owned()),
        ("cylindrical joint", format!("kind = \"cylindrical\", {axis}")),
        ("prismatic joint", format!("kind = \"prismatic\", {axis}")),
        ("planar joint", "kind = \"planar\", normal = [0.48, 0.6, -0.64]".to_owned()),
    ];
    kinds.into_iter().map(|(name, joint)| jointed(name, &joint))
}

/// Beams of all kinds except neo-Hookean ones: undamped, with strain damping, with mass damping too, with times by kind.
fn beams(gravity: Vector3<f64>) -> impl Iterator<Item = BatchCase> {
    let dampings = [(0.0, 0.0), (0.2, 0.0), (0.2, 0.7)]
        .map(|(strain, mass)| Damping { strain, mass, ..Damping::default() })
        .into_iter()
        .chain([BY_KIND]);
    let beams = beam_cases().into_iter().filter(|beam| beam.law == MaterialLaw::StVenantKirchhoff);
    let of = move |beam: BeamCase| {
        let supported = |damping: &Damping| beam.supports(damping);
        let cases = dampings.clone().filter(supported).map(|damping| BeamCase { damping, ..beam.clone() });
        cases.collect::<Vec<_>>()
    };
    beams.flat_map(of).map(move |beam| {
        let mut model = beam.model(gravity);
        rod::beam(&mut model).elements = ELEMENTS;
        case(beam.to_string(), &model)
    })
}

/// Cables along x and in space: undamped, with strain damping, with strain and mass damping.
fn cables(gravity: Vector3<f64>) -> Vec<BatchCase> {
    let mut cases = Vec::new();
    for to in [[1.4, 0.0, 0.0], [0.5, -0.9, 1.1]] {
        for (strain, bending, mass) in [(0.0, None, 0.0), (0.3, None, 0.0), (0.3, Some(0.1), 0.5)] {
            for slopes in [Slopes::Gradient, Slopes::Length] {
                let mut model = rod::free(1);
                model.gravity = gravity.into();
                let material = rod::material(&mut model);
                (material.density, material.young) = (2.0, 30.0);
                material.damping = Damping { strain, bending, mass, ..Damping::default() };
                model.sections.insert("circle".into(), Section::circle(0.3));
                let cable = Cable {
                    name: "rod".into(),
                    from: [0.0; 3],
                    to,
                    up: None,
                    elements: ELEMENTS,
                    section: "circle".into(),
                    material: "steel".into(),
                    slopes,
                    motion: InitialMotion::default(),
                };
                model.bodies = vec![Body::Cable(cable)];
                model.probes.clear();
                cases.push(case(
                    format!("cable to {to:?}, {strain}, {bending:?}, {mass}, {slopes:?}"),
                    &model,
                ));
            }
        }
    }
    cases
}

/// Random states of the terms of a batch.
fn states(terms: &[Arc<dyn Term>], random: &mut Random) -> Vec<Sample> {
    terms.iter().map(|term| Sample::random(term.as_ref(), random)).collect()
}

/// States in lanes. Lanes without a term repeat the last state.
struct Gathered([Vec<Lanes>; 4]);

impl Gathered {
    fn new(states: &[Sample]) -> Self {
        let of = |x: fn(&Sample) -> &DVector<f64>| {
            let lane = |i: usize| Lanes(std::array::from_fn(|l| x(&states[l.min(states.len() - 1)])[i]));
            (0..x(&states[0]).len()).map(lane).collect()
        };
        Self([of(|s| &s.q), of(|s| &s.v), of(|s| &s.a), of(|s| &s.lambda)])
    }

    /// View at the load factor of [`Sample::local`].
    fn at(&self) -> LocalLanes<'_> {
        let [q, v, a, lambda] = &self.0;
        LocalLanes { q, v, a, lambda, load: 0.7 }
    }
}

fn batch_residual(batch: &dyn Batch, at: &LocalLanes<'_>) -> Vec<Lanes> {
    let mut rows = vec![Lanes::default(); at.q.len() + at.lambda.len()];
    batch.residual(at, &mut rows);
    rows
}

/// Matrix of a lane from the entries that `evaluate` sets.
fn batch_matrix(
    batch: &dyn Batch,
    n: usize,
    lane: usize,
    evaluate: impl FnOnce(&mut [Lanes]),
) -> DMatrix<f64> {
    let lower = || (0..n as u8).flat_map(|j| (j..n as u8).map(move |i| [i, j])).collect();
    let entries = batch.entries().map_or_else(lower, <[[u8; 2]]>::to_vec);
    let mut values = vec![Lanes([f64::NAN; LANES]); entries.len()];
    evaluate(&mut values);
    let mut matrix = DMatrix::zeros(n, n);
    for ([i, j], value) in entries.iter().map(|entry| entry.map(usize::from)).zip(values) {
        matrix[(i, j)] = value.0[lane];
        matrix[(j, i)] = value.0[lane];
    }
    matrix
}

fn each_batch(case: &BatchCase, mut visit: impl FnMut(&[Arc<dyn Term>], &dyn Batch)) {
    let count: usize = case.batches.iter().map(|(_, batch)| batch.count()).sum();
    assert_eq!(count, case.terms.len(), "{}: every term is in a batch", case.name);
    for (terms, batch) in &case.batches {
        let terms: Vec<_> = terms.iter().map(|&term| Arc::clone(&case.terms[term])).collect();
        visit(&terms, batch.as_ref());
    }
}

fn assert_close(what: &str, a: f64, b: f64, size: f64) {
    assert!((a - b).abs() <= TOLERANCE * size, "{what}: {a:e} and {b:e}");
}

/// Asserts that forces, energies, powers and tangents of batches are those of the single elements.
fn assert_same(case: &BatchCase, random: &mut Random, amplitude: f64) {
    let name = &case.name;
    each_batch(case, |terms, batch| {
        let mut states = states(terms, random);
        states.iter_mut().for_each(|s| s.q *= amplitude);
        let gathered = Gathered::new(&states);
        let at = gathered.at();
        let rows = batch_residual(batch, &at);
        let (mut energy, mut power) = (Energy::default(), Power::default());
        for (lane, (term, s)) in terms.iter().zip(&states).enumerate() {
            let expected = residual(term.as_ref(), s);
            let found = DVector::from_fn(rows.len(), |i, _| rows[i].0[lane]);
            let error = (&found - &expected).amax() / expected.amax();
            assert!(error <= TOLERANCE, "{name}: force of lane {lane}: {error:e}");
            for level in [Level::Position, Level::Velocity, Level::Acceleration] {
                let m = at.lambda.len();
                let (mut found, mut expected) = (vec![Lanes::default(); m], DVector::zeros(m));
                batch.constraints(&at, level, &mut found);
                term.constraints(&s.local(), level, expected.as_mut_slice());
                let error = (DVector::from_fn(m, |k, _| found[k].0[lane]) - &expected).amax();
                assert!(error <= 10.0 * TOLERANCE, "{name}: {level:?} of lane {lane}: {error:e}");
            }
            energy += term.energy(&s.local());
            power += term.power(&s.local());
        }
        let found = batch.energy(&at);
        let size = energy.kinetic + energy.strain + energy.potential.abs();
        assert_close(&format!("{name}: kinetic"), found.kinetic, energy.kinetic, energy.kinetic);
        assert_close(&format!("{name}: strain"), found.strain, energy.strain, size);
        assert_close(&format!("{name}: potential"), found.potential, energy.potential, size);
        let found = batch.power(&at);
        let force = rows.iter().flat_map(|row| row.0).fold(0.0_f64, |size, x| size.max(x.abs()));
        assert_close(
            &format!("{name}: dissipation"),
            found.dissipation,
            power.dissipation,
            force.max(power.dissipation),
        );
        assert_eq!(found.work, 0.0);
        let before: Vec<Sample> = states.iter().map(|s| Sample { q: &s.q * 0.8, ..s.clone() }).collect();
        let from = Gathered::new(&before);
        for (lane, (term, (s, before))) in terms.iter().zip(states.iter().zip(&before)).enumerate() {
            let expected =
                tangent(term.as_ref(), s, Weights::STIFFNESS) + stress_prediction(term.as_ref(), s, before);
            let found =
                batch_matrix(batch, rows.len(), lane, |k| batch.predicted_stiffness(&at, &from.0[0], k));
            let error = (found - &expected).amax() / expected.amax().max(1e-300);
            assert!(error <= TOLERANCE, "{name}: predicted stiffness of lane {lane}: {error:e}");
        }
        let mixed = Weights { q: 1.3, v: random.number(), a: 0.7 };
        for w in [Weights::STIFFNESS, Weights::MASS, Weights { q: 0.0, v: 1.0, a: 0.0 }, mixed] {
            for (lane, (term, s)) in terms.iter().zip(&states).enumerate() {
                let expected = tangent(term.as_ref(), s, w);
                let found = batch_matrix(batch, rows.len(), lane, |k| batch.tangent(&at, w, k));
                let error = (found - &expected).amax() / expected.amax().max(1e-300);
                assert!(error <= TOLERANCE, "{name}: tangent of lane {lane}: {error:e}");
            }
        }
    });
}

#[test]
fn beam_batches_equal_single_beams() {
    let mut random = Random(1642);
    for case in beams(Vector3::new(0.3, -2.0, 0.7)) {
        assert_same(&case, &mut random, 1.0);
    }
}

#[test]
fn cable_batches_equal_single_cables() {
    let mut random = Random(1687);
    for case in cables(Vector3::new(0.3, -2.0, 0.7)) {
        assert_same(&case, &mut random, 0.1);
    }
}

#[test]
fn batches_of_rigid_bodies_and_joints_equal_single_terms() {
    let mut random = Random(1687);
    for case in joints() {
        assert_same(&case, &mut random, 1.0);
    }
}

/// Both evaluations find the same inverted element (det J <= 0) first.
#[test]
fn batches_find_the_first_inverted_element() {
    let mut random = Random(7);
    for case in beams(Vector3::zeros()).chain(joints().take(1)) {
        each_batch(&case, |terms, batch| {
            let mut states = states(terms, &mut random);
            let amplitude = if terms[0].multipliers().is_empty() { 0.2 } else { 1.0 };
            states.iter_mut().for_each(|s| s.q *= amplitude);
            let inverted =
                terms.iter().zip(&states).position(|(term, s)| term.inadmissibility(&s.local()).is_some());
            assert_eq!(batch.inadmissible(&Gathered::new(&states).at()), inverted, "{}", case.name);
        });
    }
}

/// Positions enter by their differences: forces of a translation are exactly zero.
#[test]
fn translations_cause_no_force() {
    for case in beams(Vector3::zeros()).chain(cables(Vector3::zeros())) {
        each_batch(&case, |terms, batch| {
            let rest = Sample::rest(terms[0].as_ref());
            let moved = |far: f64| Sample { q: translation(terms[0].as_ref(), far), ..rest.clone() };
            let states: Vec<Sample> = (0..terms.len()).map(|lane| moved(1e3 * lane as f64 + 0.1)).collect();
            let gathered = Gathered::new(&states);
            let rows = batch_residual(batch, &gathered.at());
            assert!(rows.iter().all(|row| row.0 == [0.0; LANES]), "{}: force of a translation", case.name);
            assert_eq!(batch.energy(&gathered.at()).strain, 0.0, "{}", case.name);
        });
    }
}

/// Coordinates of a translation; the position coordinates of a node are its first three.
fn translation(term: &dyn Term, far: f64) -> DVector<f64> {
    let n = term.coordinates().len();
    let stride = if n == 27 { 9 } else { n / 2 };
    DVector::from_fn(n, |i, _| if i % stride < 3 { far * (1.0 + 0.3 * (i % 3) as f64) } else { 0.0 })
}
