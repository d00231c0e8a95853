use ancf::model::{Analysis, Assembly};
use ancf::scales::{Dimension, Scales};
use ancf::system::State;
use ancf::{Field, Model};
use nalgebra::Vector3;

use crate::fibre::Fibre;
use crate::{Geometry, Placement};

/// A scalar along the bodies, by which they are coloured.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// Its name.
    pub name: &'static str,
    /// Its letter.
    pub symbol: &'static str,
    /// Its dimension.
    pub dimension: Dimension,
    /// Whether its sign matters.
    pub diverging: bool,
    /// Its values in the user's units, frame by frame and station by station; not a number where there is none.
    pub values: Vec<f32>,
}

/// The quantities along the bodies of frames that are pushed one by one.
///
/// | name | what |
/// |---|---|
/// | axial force, torque, bending moment y, z | N, T, My, Mz of the section; of cables no bending about an axis |
/// | shear force, bending moment | √(Qy² + Qz²), √(My² + Mz²) |
/// | axial stress | the largest abs(N/A + My z/I_y − Mz y/I_z) over the outline |
/// | strain | Green's strain E_xx on the axis |
/// | speed | of the axis |
/// | displacement | from the reference |
#[derive(Debug)]
pub struct Quantities<'a> {
    all: Vec<Quantity>,
    sections: Vec<Option<Fibre>>,
    assembly: &'a Assembly,
    scales: Scales,
    moves: bool,
    modal: bool,
}

/// Place of the first quantity that comes from the motion alone.
const MOTION: usize = 8;

impl<'a> Quantities<'a> {
    /// None yet, of a model in the user's units.
    pub fn new(model: &Model, assembly: &'a Assembly, scales: Scales, geometry: &Geometry<'_>) -> Self {
        let of = |name, symbol, dimension, diverging| Quantity {
            name,
            symbol,
            dimension,
            diverging,
            values: Vec::new(),
        };
        let all = vec![
            of("axial force", "N", Dimension::FORCE, true),
            of("shear force", "Q", Dimension::FORCE, false),
            of("torque", "T", Dimension::ENERGY, true),
            of("bending moment", "M", Dimension::ENERGY, false),
            of("bending moment y", "My", Dimension::ENERGY, true),
            of("bending moment z", "Mz", Dimension::ENERGY, true),
            of("axial stress", "σ", Dimension::STRESS, false),
            of("strain", "ε", Dimension::NUMBER, true),
            of("speed", "v", Dimension::VELOCITY, false),
            of("displacement", "u", Dimension::LENGTH, false),
        ];
        let modal = matches!(model.analysis, Analysis::Modes(_) | Analysis::Buckling(_));
        let moves = model.analysis.dynamics().is_some();
        Self { all, sections: Fibre::all(model, geometry), assembly, scales, moves, modal }
    }

    /// Adds the values of a state at its placement, with displacements from a reference. Of shapes, which have no size of their
    /// own, displacements are all there is; speeds are those of motions.
    pub fn push(&mut self, geometry: &Geometry<'_>, s: &State, placed: &Placement, reference: &Placement) {
        if !self.modal {
            let forces = geometry.read(Field::SectionForces, s);
            for (k, forces) in forces.chunks_exact(6).enumerate() {
                let values = self.of_section(geometry, k, s, forces);
                let (sections, _) = self.all.split_at_mut(MOTION);
                sections.iter_mut().zip(values).for_each(|(quantity, x)| quantity.values.push(x as f32));
            }
        }
        if self.moves {
            let speeds = geometry.read(Field::Velocity, s);
            let speed = |v: &[f64]| Vector3::from_column_slice(v).norm() as f32;
            self.all[MOTION].values.extend(speeds.chunks_exact(3).map(speed));
        }
        let moved = placed.centres.iter().zip(&reference.centres);
        self.all[MOTION + 1].values.extend(moved.map(|(x, from)| (x - from).norm() as f32));
    }

    fn of_section(&self, geometry: &Geometry<'_>, k: usize, s: &State, forces: &[f64]) -> [f64; MOTION] {
        let station = &geometry.fields.stations()[k];
        let (Some(fibre), Some(mesh)) = (&self.sections[k], self.assembly.body_of(station.body).mesh())
        else {
            return [f64::NAN; MOTION];
        };
        let &[n, qy, qz, t, my, mz] = forces else { return [f64::NAN; MOTION] };
        let stress = fibre.largest_stress([n, qy, qz, t, my, mz]);
        let [strain, _] = mesh.strain_and_stress(s, station.s / self.scales.length, [0.0; 2]);
        let axes = if fibre.beam { [my, mz] } else { [f64::NAN; 2] };
        [n, qy.hypot(qz), t, my.hypot(mz), axes[0], axes[1], stress, strain[(0, 0)]]
    }

    /// Those of them that have a value somewhere.
    pub fn into_all(self) -> Vec<Quantity> {
        let has_values = |quantity: &Quantity| quantity.values.iter().any(|x| x.is_finite());
        self.all.into_iter().filter(has_values).collect()
    }

    /// How many there may be.
    pub(crate) const fn most(modal: bool) -> usize {
        if modal { 1 } else { MOTION + 2 }
    }
}
