use std::sync::Arc;

use super::plan::Plan;
use super::relative::{MixWeights, VectorLayout};
use crate::elements::{Profile, StationLaw};
use crate::kinematics::Interpolation;
use crate::lanes::LaneNumber;
use crate::sections::{STRAINS, SectionLaw, SectionMatrix};

/// Common data of the profiles of a batch: shared numbers, or one number per element.
#[derive(Clone, Debug)]
pub(crate) struct BeamLaw<const N: usize, const A: usize, const B: usize, C> {
    pub layout: VectorLayout<A, B>,
    pub stations: Vec<BatchStation<A, B, C>>,
    /// Nonzero M_ab, a ≥ b.
    pub mass: Vec<(usize, usize, C)>,
    /// First moments ∫ ρ S_a dV.
    pub first: [C; N],
    pub gravity: [f64; 3],
    pub mass_damping: f64,
    /// Retardation time of all strains; zero with viscous coefficients of the stations.
    pub retardation: f64,
}

/// Quadrature point.
#[derive(Clone, Debug)]
pub(crate) struct BatchStation<const A: usize, const B: usize, C> {
    pub weight: f64,
    pub mix: MixWeights<A, B>,
    pub plan: Arc<Plan>,
    /// Coefficients D_kl in the order of the plan.
    pub elasticity: Vec<C>,
    /// Coefficients of the viscous law if its retardation times differ.
    pub viscosity: Option<Vec<C>>,
}

impl<const N: usize, const A: usize, const B: usize, C: LaneNumber> BeamLaw<N, A, B, C> {
    /// Creates the law of profiles that differ in numbers only. Returns `None` if a law is not quadratic.
    pub fn new<S: Interpolation<N>>(profiles: &[&Profile<N>]) -> Option<Self> {
        let (layout, first) = (VectorLayout::new(&S::KINDS), profiles[0]);
        let mut stations: Vec<BatchStation<A, B, C>> = Vec::new();
        let is_uniform = first.retardation.common().is_some();
        for s in 0..first.stations.len() {
            let forms = profiles.iter().map(|profile| match &profile.stations[s].law {
                StationLaw::Quadratic(law) => Some(law.form()),
                StationLaw::Hyperelastic(_) => None,
            });
            let forms: Vec<SectionMatrix> = forms.collect::<Option<_>>()?;
            let viscous = if is_uniform { Vec::new() } else { viscous_forms(profiles, s) };
            let plan = Plan::new(&[forms.clone(), viscous.clone()].concat());
            let known = stations.iter().map(|station| &station.plan).find(|known| ***known == plan);
            let plan = known.map_or_else(|| Arc::new(plan.clone()), Arc::clone);
            let entries =
                |forms: &[SectionMatrix]| numbers(forms.iter().map(|form| plan.coefficients(form).collect()));
            let (elasticity, viscosity) = (entries(&forms), (!is_uniform).then(|| entries(&viscous)));
            let (weight, mix) = (first.stations[s].weight, mix(profiles, s, &layout));
            stations.push(BatchStation { weight, mix, plan, elasticity, viscosity });
        }
        let lower = (0..N).flat_map(|a| (0..=a).map(move |b| (a, b)));
        let of = |a: usize, b: usize| profiles.iter().map(move |profile| profile.mass[a][b]);
        let mass = lower.filter(|&(a, b)| of(a, b).any(|m| m != 0.0));
        let mass = mass.map(|(a, b)| (a, b, C::of(&of(a, b).collect::<Vec<_>>())));
        let moment = |a: usize| C::of(&profiles.iter().map(|profile| profile.first[a]).collect::<Vec<_>>());
        Some(Self {
            layout,
            stations,
            mass: mass.collect(),
            first: std::array::from_fn(moment),
            gravity: first.gravity.into(),
            mass_damping: first.mass_damping,
            retardation: first.retardation.common().unwrap_or(0.0),
        })
    }
}

/// Returns the viscous forms of the profiles at a station.
fn viscous_forms<const N: usize>(profiles: &[&Profile<N>], station: usize) -> Vec<SectionMatrix> {
    let form = |profile: &&Profile<N>| profile.stations[station].viscosity.as_ref().map(SectionLaw::form);
    profiles.iter().map(|profile| form(profile).unwrap_or([[0.0; STRAINS]; STRAINS])).collect()
}

/// Packs the numbers of each element.
fn numbers<C: LaneNumber>(elements: impl Iterator<Item = Vec<f64>>) -> Vec<C> {
    let elements: Vec<Vec<f64>> = elements.collect();
    let of = |k: usize| C::of(&elements.iter().map(|numbers| numbers[k]).collect::<Vec<_>>());
    (0..elements[0].len()).map(of).collect()
}

/// Collects the weights of the vectors of an element at a station from all profiles.
fn mix<const N: usize, const A: usize, const B: usize>(
    profiles: &[&Profile<N>],
    station: usize,
    layout: &VectorLayout<A, B>,
) -> MixWeights<A, B> {
    let weight = |vector: usize, director: usize| {
        let of = |profile: &&Profile<N>| {
            let parts = profile.stations[station].parts[vector].as_slice();
            parts.iter().find(|(other, _)| *other == director).map(|(_, weight)| *weight)
        };
        profiles.iter().find_map(of).unwrap_or(0.0)
    };
    let mut section = layout.y.map(|y| [weight(y, 3), weight(y, 1)]);
    section[0] = [section.iter().map(|[d, _]| d).sum(), 0.0];
    MixWeights { axis: layout.axis.map(|(i, _)| [0, 5, 6].map(|director| weight(i, director))), section }
}
