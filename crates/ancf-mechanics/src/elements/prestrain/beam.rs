use ancf_solver::equations::{Energy, Local, LocalMatrix, ProductColumn, Term, Weights};
use nalgebra::{Matrix3, Vector3};

use super::source::{Change, ElementPlace, Factors, Prestrain};
use super::term::{PrestrainTerm, Prestrained};
use crate::elements::beam::{add_blocks, vectors};
use crate::elements::station::{BeamStation, RelativeVectors, StationLaw, mirror};
use crate::elements::station_products::StationBlocks;
use crate::elements::{BeamElement, StrainEnergy};
use crate::kinematics::Interpolation;
use crate::sections::{
    AH, BK, CK, DH, DIRECTORS, Directors, EH, HH, KK, NO_STIFFNESS, SectionLaw, Stiffness, Strains,
    all_rates, all_strains, sum,
};

/// Prescribed strains of a beam element: the resultants are D (ε − ε⁰) + τD (ε̇ − ε̇⁰).
///
/// The section strains ε⁰ are those of an axis with the strain ε⁰ and of directors that vary by the curvature κ⁰:
///
/// r_x = (1 + ε⁰) r_x⁰,  ∂r_y/∂x = ∂r_y⁰/∂x + κ⁰ × r_y⁰,  ∂r_z/∂x = ∂r_z⁰/∂x + κ⁰ × r_z⁰.
#[derive(Clone, Debug)]
struct BeamPrestrain<const N: usize, S> {
    element: BeamElement<N, S>,
    sources: Vec<Prestrain>,
    stations: Vec<StationPrestrain>,
}

/// Prescribed strains of a station.
#[derive(Clone, Debug)]
struct StationPrestrain {
    law: SectionLaw,
    /// Reference directors in the global frame.
    g0: Directors,
    /// Changes of the directors by each source, for the value 1 of its function.
    changes: Vec<Directors>,
}

impl<const N: usize, S: Interpolation<N> + Clone + Send + Sync> Prestrained for BeamElement<N, S> {
    fn prestrained(&self, place: ElementPlace, sources: &[Prestrain]) -> Option<Box<dyn PrestrainTerm>> {
        let at = |station: &BeamStation<N>| {
            let StationLaw::Quadratic(law) = &station.law else { return None };
            let (g0, s) = (station.reference(&self.frame), place.start + station.xi * place.length);
            let changes = sources.iter().map(|source| changes(&g0, &source.at(s))).collect();
            Some(StationPrestrain { law: law.clone(), g0, changes })
        };
        let stations = self.profile.stations.iter().map(at).collect::<Option<_>>()?;
        Some(Box::new(BeamPrestrain { element: self.clone(), sources: sources.to_vec(), stations }))
    }
}

/// Returns the changes of the directors of a section by a change of shape.
fn changes(g0: &Directors, change: &Change) -> Directors {
    let (normal, second) = (g0[3].cross(&g0[4]).normalize(), g0[3].normalize());
    let curvature = Matrix3::from_columns(&[normal, second, normal.cross(&second)]) * change.curvature;
    let mut u = [Vector3::zeros(); DIRECTORS];
    (u[0], u[1], u[2]) = (g0[0] * change.strain, curvature.cross(&g0[3]), curvature.cross(&g0[4]));
    u
}

/// Returns the section strains of a change of shape, and their rates for its rate.
pub(crate) fn section_prestrains(g0: &Directors, [change, rate]: &[Change; 2]) -> [Strains; 2] {
    let [u, v] = [change, rate].map(|change| changes(g0, change));
    let moved = std::array::from_fn(|k| g0[k] + u[k]);
    [all_strains(g0, &u), all_rates(&moved, &v)].map(prescribed)
}

/// Sets the strains of the variation of r_x along an element to zero: they follow from those of its sections.
fn prescribed(mut strains: Strains) -> Strains {
    [HH, KK, DH, EH, BK, CK, AH].into_iter().for_each(|k| strains[k] = 0.0);
    strains
}

/// Section of a station with its strains ε⁰ and their rates.
struct Section<'a, const N: usize> {
    station: &'a BeamStation<N>,
    law: &'a SectionLaw,
    g0: &'a Directors,
    strains: Strains,
    rates: Strains,
}

impl<const N: usize> Section<'_, N> {
    /// Returns the elastic resultants D ε⁰.
    fn elastic(&self) -> Strains {
        self.law.resultants(&self.strains)
    }

    /// Returns the resultants D ε⁰ + τD ε̇⁰.
    fn resultants(&self) -> Strains {
        let mut n = self.elastic();
        if let Some(law) = &self.station.viscosity {
            n.iter_mut().zip(law.resultants(&self.rates)).for_each(|(n, viscous)| *n += viscous);
        }
        n
    }

    /// Returns ε̇⁰ τD ε̇ for rates of the strains.
    fn viscous_power(&self, rates: &Strains) -> f64 {
        self.station.viscosity.as_ref().map_or(0.0, |law| dot(&law.resultants(&self.rates), rates))
    }

    /// Computes all blocks of −Σ n_k ∂²ε_k for resultants n.
    fn stiffness(&self, n: &Strains) -> Stiffness {
        let mut h = NO_STIFFNESS;
        self.law.add_geometric(n, -1.0, &mut h);
        mirror(&mut h, DIRECTORS);
        h
    }
}

fn dot(a: &Strains, b: &Strains) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl<const N: usize, S: Interpolation<N>> BeamPrestrain<N, S> {
    /// Returns the sections of all stations in a state.
    fn sections(&self, at: &Local<'_>) -> impl Iterator<Item = Section<'_, N>> {
        self.sections_of(Prestrain::factors(&self.sources, at))
    }

    /// Returns the sections of all stations for factors of the sources and their rates.
    fn sections_of(&self, factors: Factors) -> impl Iterator<Item = Section<'_, N>> {
        self.element.profile.stations.iter().zip(&self.stations).map(move |(station, own)| {
            let [mut u, mut rate] = [[Vector3::zeros(); DIRECTORS]; 2];
            for (change, [value, speed]) in own.changes.iter().zip(&factors) {
                for i in 0..DIRECTORS {
                    u[i] += change[i] * *value;
                    rate[i] += change[i] * *speed;
                }
            }
            let StationPrestrain { law, g0, .. } = own;
            let strains = prescribed(all_strains(g0, &u));
            Section { station, law, g0, strains, rates: prescribed(all_rates(&sum(g0, &u), &rate)) }
        })
    }

    /// Adds the stiffness −Σ n_k ∂²ε_k of sections with resultants n.
    fn add_stiffness<'a>(
        sections: impl Iterator<Item = Section<'a, N>>,
        resultants: impl Fn(&Section<'a, N>) -> Strains,
        k: &mut LocalMatrix<'_>,
    ) {
        let mut blocks = [[Matrix3::zeros(); N]; N];
        for section in sections {
            section.station.distribute_stiffness(&section.stiffness(&resultants(&section)), &mut blocks);
        }
        add_blocks(&blocks, k);
    }

    /// Subtracts the forces of resultants of the sections.
    fn subtract_forces(
        &self,
        at: &Local<'_>,
        resultants: impl Fn(&Section<'_, N>) -> Strains,
        r: &mut [f64],
    ) {
        let (q, mut force) = (RelativeVectors::new::<S>(&vectors(at.q)), [Vector3::zeros(); N]);
        for section in self.sections(at) {
            let g = sum(section.g0, &section.station.directors::<S>(&q));
            section.station.distribute(&section.law.of_resultants(&resultants(&section), &g), &mut force);
        }
        for (row, force) in r.iter_mut().zip(force.iter().flatten()) {
            *row -= force;
        }
    }

    /// Sums a function of the sections, of their directors and of the rates of these, times the lengths of the stations.
    fn integral(&self, at: &Local<'_>, of: impl Fn(&Section<'_, N>, &Directors, &Directors) -> f64) -> f64 {
        let [q, v] = [at.q, at.v].map(|x| RelativeVectors::new::<S>(&vectors(x)));
        let of_section = |section: Section<'_, N>| {
            let [u, rate] = [&q, &v].map(|x| section.station.directors::<S>(x));
            section.station.weight * of(&section, &u, &rate)
        };
        self.sections(at).map(of_section).sum()
    }
}

impl<const N: usize, S: Interpolation<N> + Clone + Send + Sync> PrestrainTerm for BeamPrestrain<N, S> {
    fn copied(&self) -> Box<dyn Term> {
        Box::new(self.clone())
    }

    fn add_elastic(&self, at: &Local<'_>, r: &mut [f64]) {
        self.subtract_forces(at, |section| section.elastic(), r);
    }

    fn parts(&self, at: &Local<'_>) -> StrainEnergy {
        let q = RelativeVectors::new::<S>(&vectors(at.q));
        let mut parts = StrainEnergy::default();
        for Section { station, law, g0, strains, .. } in self.sections(at) {
            let total = all_strains(g0, &station.directors::<S>(&q));
            let share = |strains: &Strains| {
                let n = law.resultants(strains);
                std::array::from_fn(|k| 0.5 * n[k] * strains[k])
            };
            let elastic: Strains = share(&std::array::from_fn(|k| total[k] - strains[k]));
            let without: Strains = share(&total);
            let added = std::array::from_fn(|k| elastic[k] - without[k]);
            parts += StrainEnergy::of_shares(&added) * station.weight;
        }
        parts
    }
}

impl<const N: usize, S: Interpolation<N> + Clone + Send + Sync> Term for BeamPrestrain<N, S> {
    fn coordinates(&self) -> &[usize] {
        self.element.coordinates()
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.subtract_forces(at, |section| section.resultants(), r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let vectors = vectors::<N>(at.q);
        let (q, sizes) = (RelativeVectors::new::<S>(&vectors), vectors.map(|q| q.norm()));
        let mut bound = [0.0; N];
        for section in self.sections(at) {
            let station = section.station;
            let errors = station.director_rounding(&sizes);
            let g = sum(section.g0, &station.directors::<S>(&q));
            let size = std::array::from_fn(|i| Vector3::x() * (errors[i] + 4.0 * f64::EPSILON * g[i].norm()));
            let p = section.law.of_resultants(&section.resultants().map(f64::abs), &size);
            for (bound, parts) in bound.iter_mut().zip(&station.parts) {
                for &(director, weight) in parts.as_slice() {
                    *bound += station.weight * p[director].norm() * weight.abs();
                }
            }
        }
        for (row, floor) in floor.iter_mut().enumerate() {
            *floor += bound[row / 3];
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        if w.q != 0.0 {
            Self::add_stiffness(self.sections(at), |section| section.resultants().map(|n| w.q * n), k);
        }
    }

    fn stiffness_products(&self, at: &Local<'_>, columns: &mut [ProductColumn]) {
        let relative: Vec<_> = columns.iter().map(|column| vectors::<N>(&column.x)).collect();
        for section in self.sections(at) {
            let (station, h) = (section.station, section.stiffness(&section.resultants()));
            let blocks = StationBlocks::new(station, &h);
            for (column, x) in columns.iter_mut().zip(&relative) {
                blocks.add_product::<N, S>(station, x, column);
            }
        }
    }

    /// First-order response of the prescribed strains to the increment of the load factor.
    fn stress_stiffness(&self, at: &Local<'_>, by: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let [mut factors, increments] =
            [at.load, by.load].map(|load| Prestrain::factors(&self.sources, &Local { load, ..*at }));
        factors.iter_mut().zip(increments).for_each(|(factor, [increment, _])| factor[1] = increment);
        Self::add_stiffness(self.sections_of(factors), |section| section.law.resultants(&section.rates), k);
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let strain = self.integral(at, |section, u, _| {
            let n = section.elastic();
            0.5 * dot(&n, &section.strains) - dot(&n, &all_strains(section.g0, u))
        });
        Energy { strain, ..Energy::default() }
    }

    /// Returns −ε̇⁰ D (ε − ε⁰) + ε̇ τD ε̇⁰ of all stations.
    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        self.integral(at, |section, u, rate| {
            let n = section.law.resultants(&section.rates);
            let rates = all_rates(&sum(section.g0, u), rate);
            dot(&n, &section.strains) - dot(&n, &all_strains(section.g0, u)) + section.viscous_power(&rates)
        })
    }

    fn is_damped(&self) -> bool {
        false
    }

    /// Returns ε̇⁰ τD (ε̇⁰ − 2ε̇): with the damping of the element it is the dissipated power of ε̇ − ε̇⁰.
    fn flow_power(&self, at: &Local<'_>) -> f64 {
        self.integral(at, |section, u, rate| {
            let rates = all_rates(&sum(section.g0, u), rate);
            section.viscous_power(&section.rates) - 2.0 * section.viscous_power(&rates)
        })
    }
}
