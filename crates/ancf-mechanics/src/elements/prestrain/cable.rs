use ancf_solver::equations::{Energy, Local, LocalMatrix, LocalStep, ProductColumn, Term, Weights};
use nalgebra::{Matrix3, Vector3};

use super::source::{ElementPlace, Prestrain};
use super::term::{PrestrainTerm, Prestrained};
use crate::elements::beam::add_blocks;
use crate::elements::cable_products::{AxialProduct, CableColumn};
use crate::elements::cable_profile::CableStation;
use crate::elements::cable_step::vectors;
use crate::elements::{Cable12, StrainEnergy};
use crate::kinematics::AxialStretch;

/// Prescribed axial strain ε⁰ of a cable element: N = EA (ε − ε⁰ + τ (ε̇ − ε̇⁰)).
#[derive(Clone, Debug)]
struct CablePrestrain {
    element: Cable12,
    sources: Vec<Prestrain>,
    /// Strains of the sources at each axial station, for the value 1 of their functions.
    strains: Vec<Vec<f64>>,
}

impl Prestrained for Cable12 {
    fn prestrained(&self, place: ElementPlace, sources: &[Prestrain]) -> Option<Box<dyn PrestrainTerm>> {
        let at = |xi: &f64| {
            let s = place.start + xi * place.length;
            sources.iter().map(|source| source.at(s).strain).collect()
        };
        let strains = self.profile.axial_places().iter().map(at).collect();
        Some(Box::new(CablePrestrain { element: self.clone(), sources: sources.to_vec(), strains }))
    }
}

impl CablePrestrain {
    /// Returns each axial station with ε⁰ and ε̇⁰.
    fn stations(&self, at: &Local<'_>) -> impl Iterator<Item = (&CableStation, [f64; 2])> {
        let factors = Prestrain::factors(&self.sources, at);
        self.element.profile.axial().iter().zip(&self.strains).map(move |(station, strains)| {
            let mut sum = [0.0; 2];
            for ([value, rate], strain) in factors.iter().zip(strains) {
                sum[0] += strain * value;
                sum[1] += strain * rate;
            }
            (station, sum)
        })
    }

    fn stretch(&self, station: &CableStation, q: &[Vector3<f64>; 4]) -> AxialStretch {
        AxialStretch::new(&self.element.direction, &station.first(q))
    }

    fn rigidity(&self) -> f64 {
        self.element.profile.section().axial
    }

    fn retardation(&self) -> f64 {
        self.element.profile.damping().stretch
    }

    /// Returns the part −EA (ε⁰ + τ ε̇⁰) of the axial force.
    fn force(&self, [strain, rate]: [f64; 2]) -> f64 {
        -self.rigidity() * (strain + self.retardation() * rate)
    }

    /// Adds the forces of an axial force at each station.
    fn add_forces(&self, at: &Local<'_>, force: impl Fn([f64; 2]) -> f64, r: &mut [f64]) {
        let q = vectors(at.q);
        for (station, strain) in self.stations(at) {
            add(station, &(self.stretch(station, &q).tangent * (station.weight * force(strain))), r);
        }
    }

    /// Adds the stiffness of an axial force at each station.
    fn add_stiffness(
        &self,
        at: &Local<'_>,
        force: impl Fn(&AxialStretch, [f64; 2]) -> f64,
        k: &mut LocalMatrix<'_>,
    ) {
        let q = vectors(at.q);
        let mut blocks = [[Matrix3::zeros(); 4]; 4];
        for (station, strain) in self.stations(at) {
            let stretch = self.stretch(station, &q);
            let h = stretch.stiffness(0.0, force(&stretch, strain)) * station.weight;
            for (i, row) in blocks.iter_mut().enumerate() {
                for (j, block) in row.iter_mut().enumerate().take(i + 1) {
                    *block += h * (station.first[i] * station.first[j]);
                }
            }
        }
        add_blocks(&blocks, k);
    }
}

impl PrestrainTerm for CablePrestrain {
    fn copied(&self) -> Box<dyn Term> {
        Box::new(self.clone())
    }

    fn add_elastic(&self, at: &Local<'_>, r: &mut [f64]) {
        self.add_forces(at, |[strain, _]| self.force([strain, 0.0]), r);
    }

    fn parts(&self, at: &Local<'_>) -> StrainEnergy {
        StrainEnergy { axial: self.energy(at).strain, ..StrainEnergy::default() }
    }
}

impl Term for CablePrestrain {
    fn coordinates(&self) -> &[usize] {
        self.element.coordinates()
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.add_forces(at, |strain| self.force(strain), r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let q = vectors(at.q);
        for (station, strain) in self.stations(at) {
            let length = self.stretch(station, &q).length;
            let [error, _] = station.rounding(&q);
            let bound = station.weight * self.force(strain).abs() * (error / length + 4.0 * f64::EPSILON);
            for (row, floor) in floor.iter_mut().enumerate() {
                *floor += bound * station.first[row / 3].abs();
            }
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        if w.q != 0.0 {
            self.add_stiffness(at, |_, strain| w.q * self.force(strain), k);
        }
    }

    fn stiffness_products(&self, at: &Local<'_>, columns: &mut [ProductColumn]) {
        let q = vectors(at.q);
        let mut columns: Vec<_> = columns.iter_mut().map(CableColumn::new).collect();
        for (station, strain) in self.stations(at) {
            let h = self.stretch(station, &q).stiffness(0.0, self.force(strain)) * station.weight;
            let h = AxialProduct::new(h);
            columns.iter_mut().for_each(|column| column.add_axial(station, &h));
        }
        columns.into_iter().for_each(CableColumn::finish);
    }

    /// Adds the forces with the direction 2 r′_m/(|r′₀| + |r′₁|), along which Δε is the product with Δr′.
    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        let [from, middle, to] = [step.from, step.middle, step.to].map(|at| vectors(at.q));
        for (station, strain) in self.stations(&step.middle) {
            let length = 0.5 * (self.stretch(station, &from).length + self.stretch(station, &to).length);
            let a = self.element.direction + station.first(&middle);
            add(station, &(a * (station.weight * self.force(strain) / length)), r);
        }
    }

    /// First-order response of the prescribed strains to the increment of the load factor.
    fn stress_stiffness(&self, at: &Local<'_>, by: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let by = Local { load: by.load, ..*at };
        self.add_stiffness(&by, |_, [strain, _]| -self.rigidity() * strain, k);
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let q = vectors(at.q);
        let of = |(station, [fixed, _]): (&CableStation, [f64; 2])| {
            station.weight * fixed * (0.5 * fixed - self.stretch(station, &q).strain)
        };
        let strain = self.rigidity() * self.stations(at).map(of).sum::<f64>();
        Energy { strain, ..Energy::default() }
    }

    /// Returns −ε̇⁰ EA (ε − ε⁰) + ε̇ EA τ ε̇⁰ of all stations.
    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        let (q, v) = (vectors(at.q), vectors(at.v));
        let of = |(station, [fixed, rate]): (&CableStation, [f64; 2])| {
            let stretch = self.stretch(station, &q);
            let strain_rate = stretch.tangent.dot(&station.first(&v));
            station.weight * rate * (fixed - stretch.strain + self.retardation() * strain_rate)
        };
        self.rigidity() * self.stations(at).map(of).sum::<f64>()
    }

    fn is_damped(&self) -> bool {
        false
    }

    /// Returns EA τ (ε̇⁰ − 2ε̇) ε̇⁰: with the damping of the element it is the dissipated power EA τ (ε̇ − ε̇⁰)².
    fn flow_power(&self, at: &Local<'_>) -> f64 {
        let (q, v) = (vectors(at.q), vectors(at.v));
        let of = |(station, [_, rate]): (&CableStation, [f64; 2])| {
            let strain_rate = self.stretch(station, &q).tangent.dot(&station.first(&v));
            station.weight * rate * (rate - 2.0 * strain_rate)
        };
        self.rigidity() * self.retardation() * self.stations(at).map(of).sum::<f64>()
    }
}

/// Adds a force on r′ of a station to the rows of the element.
fn add(station: &CableStation, force: &Vector3<f64>, r: &mut [f64]) {
    for (i, rows) in r.chunks_exact_mut(3).enumerate().take(4) {
        rows.iter_mut().zip(force.iter()).for_each(|(row, force)| *row += force * station.first[i]);
    }
}
