//! Elements that are evaluated side by side are what they are one by one: the same numbers but for rounding, for every kind
//! of element, in batches that are full and one that is not.

use crate::common::models::beams;
use crate::common::models::beams::makes;
use crate::common::models::rod;
use crate::common::sample::{Random, Sample, residual, tangent};
use ancf::Model;
use ancf::mechanics::BeamMesh;
use ancf::model::{Body, Cable, Damping, InitialMotion, MaterialLaw, Section, Slopes};
use ancf::system::{Batch, Energy, LANES, Lanes, LocalLanes, Power, Term, Weights};
use nalgebra::{DMatrix, DVector, Vector3};

/// A full batch and one of three.
const ELEMENTS: u32 = 11;
const TOLERANCE: f64 = 1e-13;

/// The batches of a body, each with its terms, and what it is.
struct Case {
    name: String,
    terms: Vec<Box<dyn Term>>,
    batches: Vec<(usize, Box<dyn Batch>)>,
}

fn case(name: String, model: &Model) -> Case {
    let assembly = model.assemble().unwrap();
    let mesh: &BeamMesh = assembly.mesh("rod").unwrap();
    Case { name, terms: mesh.terms(), batches: mesh.batches() }
}

/// Beams of every kind but those of neo-Hookean material, without damping, with one and with both kinds.
fn beams(gravity: Vector3<f64>) -> impl Iterator<Item = Case> {
    let dampings = [(0.0, 0.0), (0.2, 0.0), (0.2, 0.7)].map(|(strain, mass)| Damping { strain, mass });
    let makes = makes().into_iter().filter(|make| make.law == MaterialLaw::StVenantKirchhoff);
    makes.flat_map(move |make| dampings.map(|damping| beams::Make { damping, ..make })).map(move |make| {
        let mut model = make.model(gravity);
        rod::beam(&mut model).elements = ELEMENTS;
        case(make.to_string(), &model)
    })
}

/// Cables along x and in space, undamped, retarded, and with both kinds of damping.
fn cables(gravity: Vector3<f64>) -> Vec<Case> {
    let mut cases = Vec::new();
    for to in [[1.4, 0.0, 0.0], [0.5, -0.9, 1.1]] {
        for (strain, mass) in [(0.0, 0.0), (0.3, 0.0), (0.3, 0.5)] {
            for slopes in [Slopes::Gradient, Slopes::Length] {
                let mut model = rod::free(1);
                model.gravity = gravity.into();
                let material = rod::material(&mut model);
                (material.density, material.young, material.damping) = (2.0, 30.0, Damping { strain, mass });
                model.sections.insert("circle".into(), Section::Circle { diameter: 0.3 });
                let cable = Cable {
                    name: "rod".into(),
                    from: [0.0; 3],
                    to,
                    elements: ELEMENTS,
                    section: "circle".into(),
                    material: "steel".into(),
                    slopes,
                    motion: InitialMotion::default(),
                };
                model.bodies = vec![Body::Cable(cable)];
                model.probes.clear();
                cases.push(case(format!("cable to {to:?}, {strain}, {mass}, {slopes:?}"), &model));
            }
        }
    }
    cases
}

/// States of the terms of a batch, at random.
fn states(terms: &[Box<dyn Term>], random: &mut Random) -> Vec<Sample> {
    terms.iter().map(|term| Sample::random(term.as_ref(), random)).collect()
}

/// The same side by side; lanes without a term repeat the last one.
struct Gathered([Vec<Lanes>; 3]);

impl Gathered {
    fn new(states: &[Sample]) -> Self {
        let of = |x: fn(&Sample) -> &DVector<f64>| {
            let lane = |i: usize| Lanes(std::array::from_fn(|l| x(&states[l.min(states.len() - 1)])[i]));
            (0..states[0].q.len()).map(lane).collect()
        };
        Self([of(|s| &s.q), of(|s| &s.v), of(|s| &s.a)])
    }

    /// With the load factor of [`Sample::local`].
    fn at(&self) -> LocalLanes<'_> {
        let [q, v, a] = &self.0;
        LocalLanes { q, v, a, load: 0.7 }
    }
}

fn batch_residual(batch: &dyn Batch, at: &LocalLanes<'_>) -> Vec<Lanes> {
    let mut rows = vec![Lanes::default(); at.q.len()];
    batch.residual(at, &mut rows);
    rows
}

fn batch_tangent(batch: &dyn Batch, at: &LocalLanes<'_>, w: Weights, lane: usize) -> DMatrix<f64> {
    let n = at.q.len();
    let mut lower = vec![Lanes([f64::NAN; LANES]); n * (n + 1) / 2];
    batch.tangent(at, w, &mut lower);
    let place = |i: usize, j: usize| j * n - j * (j + 1) / 2 + i;
    DMatrix::from_fn(n, n, |i, j| {
        let at = if i >= j { place(i, j) } else { place(j, i) };
        lower[at].0[lane]
    })
}

fn each_batch(case: &Case, mut visit: impl FnMut(&[Box<dyn Term>], &dyn Batch)) {
    let count: usize = case.batches.iter().map(|(_, batch)| batch.count()).sum();
    assert_eq!(count, case.terms.len(), "{}: all terms are in batches", case.name);
    for (first, batch) in &case.batches {
        visit(&case.terms[*first..first + batch.count()], batch.as_ref());
    }
}

fn assert_near(what: &str, a: f64, b: f64, size: f64) {
    assert!((a - b).abs() <= TOLERANCE * size, "{what}: {a:e} and {b:e}");
}

fn agrees(case: &Case, random: &mut Random, reach: f64) {
    let name = &case.name;
    each_batch(case, |terms, batch| {
        let mut states = states(terms, random);
        states.iter_mut().for_each(|s| s.q *= reach);
        let gathered = Gathered::new(&states);
        let at = gathered.at();
        let rows = batch_residual(batch, &at);
        let (mut energy, mut power) = (Energy::default(), Power::default());
        for (lane, (term, s)) in terms.iter().zip(&states).enumerate() {
            let expected = residual(term.as_ref(), s);
            let found = DVector::from_fn(rows.len(), |i, _| rows[i].0[lane]);
            let error = (&found - &expected).amax() / expected.amax();
            assert!(error <= TOLERANCE, "{name}: force of lane {lane}: {error:e}");
            energy += term.energy(&s.local());
            power += term.power(&s.local());
        }
        let found = batch.energy(&at);
        let size = energy.kinetic + energy.strain + energy.potential.abs();
        assert_near(&format!("{name}: kinetic"), found.kinetic, energy.kinetic, energy.kinetic);
        assert_near(&format!("{name}: strain"), found.strain, energy.strain, size);
        assert_near(&format!("{name}: potential"), found.potential, energy.potential, size);
        let found = batch.power(&at);
        let force = rows.iter().flat_map(|row| row.0).fold(0.0_f64, |size, x| size.max(x.abs()));
        assert_near(
            &format!("{name}: loss"),
            found.dissipation,
            power.dissipation,
            force.max(power.dissipation),
        );
        assert_eq!(found.work, 0.0);
        let mixed = Weights { q: 1.3, v: random.number(), a: 0.7 };
        for w in [Weights::STIFFNESS, Weights::MASS, Weights { q: 0.0, v: 1.0, a: 0.0 }, mixed] {
            for (lane, (term, s)) in terms.iter().zip(&states).enumerate() {
                let expected = tangent(term.as_ref(), s, w);
                let found = batch_tangent(batch, &at, w, lane);
                let error = (found - &expected).amax() / expected.amax().max(1e-300);
                assert!(error <= TOLERANCE, "{name}: tangent of lane {lane}: {error:e}");
            }
        }
    });
}

#[test]
fn beams_side_by_side_are_beams() {
    let mut random = Random(1642);
    for case in beams(Vector3::new(0.3, -2.0, 0.7)) {
        agrees(&case, &mut random, 1.0);
    }
}

#[test]
fn cables_side_by_side_are_cables() {
    let mut random = Random(1687);
    for case in cables(Vector3::new(0.3, -2.0, 0.7)) {
        agrees(&case, &mut random, 0.1);
    }
}

/// Turned inside out, the same one is found first.
#[test]
fn the_first_that_is_inside_out_is_found() {
    let mut random = Random(7);
    for case in beams(Vector3::zeros()) {
        each_batch(&case, |terms, batch| {
            let mut states = states(terms, &mut random);
            states.iter_mut().for_each(|s| s.q *= 0.2);
            let wrong = terms.iter().zip(&states).position(|(term, s)| !term.is_admissible(&s.local()));
            assert_eq!(batch.inadmissible(&Gathered::new(&states).at()), wrong, "{}", case.name);
        });
    }
}

/// Positions enter by their differences: a translation has no force at all, however far.
#[test]
fn translations_have_no_force() {
    for case in beams(Vector3::zeros()).chain(cables(Vector3::zeros())) {
        each_batch(&case, |terms, batch| {
            let rest = Sample::rest(terms[0].as_ref());
            let moved = |far: f64| Sample { q: translation(terms[0].as_ref(), far), ..rest.clone() };
            let states: Vec<Sample> = (0..terms.len()).map(|lane| moved(1e3 * lane as f64 + 0.1)).collect();
            let gathered = Gathered::new(&states);
            let rows = batch_residual(batch, &gathered.at());
            assert!(rows.iter().all(|row| row.0 == [0.0; LANES]), "{}: a force", case.name);
            assert_eq!(batch.energy(&gathered.at()).strain, 0.0, "{}", case.name);
        });
    }
}

/// Coordinates of a node's position are its first three.
fn translation(term: &dyn Term, far: f64) -> DVector<f64> {
    let n = term.coordinates().len();
    let stride = if n == 27 { 9 } else { n / 2 };
    DVector::from_fn(n, |i, _| if i % stride < 3 { far * (1.0 + 0.3 * (i % 3) as f64) } else { 0.0 })
}
