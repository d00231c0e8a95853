//! Quantities along the bodies.

use ancf::solver::equations::State;
use ancf::units::Dimension;
use ancf::{Field, Fields, Simulation};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Components of a symmetric tensor: xx, yy, zz, xy, xz, yz, as in the columns of probes.
const ENTRIES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// Quantity that is computed at each station.
#[derive(Clone, Copy, Debug)]
pub(crate) enum StationQuantity {
    Field(Field),
    /// Green-Lagrange strain at an offset (y, z) of the section, in the user's unit of length.
    Strain([f64; 2]),
    /// Second Piola-Kirchhoff stress at an offset (y, z) of the section.
    Stress([f64; 2]),
}

impl StationQuantity {
    /// Returns the quantity with a name.
    ///
    /// # Errors
    /// If the name is not known.
    pub(crate) fn from_name(name: &str, offset: [f64; 2]) -> PyResult<Self> {
        if let Some((_, field)) = Field::ALL.into_iter().find(|(own, _)| *own == name) {
            return Ok(Self::Field(field));
        }
        match name {
            "strain" => Ok(Self::Strain(offset)),
            "stress" => Ok(Self::Stress(offset)),
            _ => {
                let names = Field::ALL.iter().map(|(name, _)| *name).chain(["strain", "stress"]);
                let names: Vec<_> = names.map(|name| format!("{name:?}")).collect();
                let text = format!("field: found {name:?}, expected one of {}", names.join(", "));
                Err(PyValueError::new_err(text))
            }
        }
    }

    /// True if the quantity depends on positions only.
    pub(crate) fn is_positional(self, simulation: &Simulation) -> bool {
        match self {
            Self::Field(field) => {
                matches!(field, Field::Position | Field::Displacement | Field::Directors)
            }
            Self::Strain(_) => true,
            Self::Stress(_) => !simulation.has_damped_strains(),
        }
    }

    /// True if the quantity is a rate of the position.
    pub(crate) const fn is_rate(self) -> bool {
        matches!(self, Self::Field(Field::Velocity | Field::Acceleration))
    }

    /// Number of components.
    pub(crate) const fn width(self) -> usize {
        match self {
            Self::Field(field) => field.width(),
            Self::Strain(_) | Self::Stress(_) => ENTRIES.len(),
        }
    }

    /// Appends the values in a state, station by station, in the user's units. Rigid bodies have no strain: NaN.
    pub(crate) fn fill(self, simulation: &Simulation, fields: &Fields<'_>, s: &State, to: &mut Vec<f64>) {
        let (offset, which, dimension) = match self {
            Self::Field(field) => return fields.fill(field, s, to),
            Self::Strain(offset) => (offset, 0, Dimension::NUMBER),
            Self::Stress(offset) => (offset, 1, Dimension::STRESS),
        };
        let scales = simulation.scales();
        let (length, unit) = (scales.unit(Dimension::LENGTH), scales.unit(dimension));
        let offset = offset.map(|x| x / length);
        for station in fields.stations() {
            match simulation.assembly().body_of(station.body).mesh() {
                None => to.extend([f64::NAN; ENTRIES.len()]),
                Some(mesh) => {
                    let at = station.s / length;
                    let warping = simulation.warping_gradient(station.body, at, offset);
                    let tensor = mesh.strain_and_stress(s, at, (offset, warping))[which];
                    to.extend(ENTRIES.map(|entry| tensor[entry] * unit));
                }
            }
        }
    }
}
