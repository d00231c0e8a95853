use serde::{Deserialize, Serialize};

use super::error_motion::{ComputedStep, ErrorMotion, ErrorSource};
use super::quadrature::{Defect, Quadrature};
use crate::equations::{EquationsOfMotion, State};
use crate::newton::Newton;

/// Estimated errors of a motion, exact less computed: those of the time steps and those of the mesh.
///
/// They satisfy the linearised equations of motion and are integrated with the factorised tangents of the motion. The source of the errors of the steps is the difference between the scheme and a quadrature of higher order. The source of the
/// errors of the mesh are forces that the caller sets.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct MotionErrors {
    steps: ErrorMotion,
    mesh: Option<MeshErrors>,
    quadrature: Quadrature,
    defect: Defect,
    /// Size of each coordinate.
    sizes: Vec<f64>,
    /// Working storage.
    moved: State,
    residual: Vec<f64>,
    /// Size of the last step; zero at the start.
    h: f64,
    /// False if a step of the errors had no solution.
    is_known: bool,
    /// Number of steps in which laws with kinks are not linear.
    kinked_steps: u64,
}

/// Errors of the mesh with the last two sets of forces, the latest first, and their times.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct MeshErrors {
    motion: ErrorMotion,
    times: [f64; 2],
    forces: [Vec<f64>; 2],
    /// Number of sets since the start or the last jump.
    count: u32,
    /// True if the last set was close to its extrapolation.
    is_smooth: bool,
    /// False if a step of the errors had no solution.
    is_known: bool,
    now: Vec<f64>,
}

/// Relative difference of forces from their extrapolation above which they are not extrapolated.
const ROUGH: f64 = 0.5;

impl MotionErrors {
    /// Creates the errors of a motion that starts from an exact state, for coordinates of given sizes. `has_mesh` includes errors of the mesh.
    pub(crate) fn new(start: &State, sizes: Vec<f64>, has_mesh: bool) -> Self {
        let (n, m) = (start.q.len(), start.lambda.len());
        let zeros = || vec![0.0; n];
        let mesh = || MeshErrors {
            motion: ErrorMotion::new(n, m),
            times: [start.t; 2],
            forces: [zeros(), zeros()],
            count: 0,
            is_smooth: false,
            is_known: true,
            now: zeros(),
        };
        Self {
            steps: ErrorMotion::new(n, m),
            mesh: has_mesh.then(mesh),
            quadrature: Quadrature::new(n),
            defect: Defect::new(n),
            sizes,
            moved: start.clone(),
            residual: vec![0.0; n + m],
            h: 0.0,
            is_known: true,
            kinked_steps: 0,
        }
    }

    /// Number of steps in which stops, ropes, dry friction or other laws with kinks are not linear: the errors of these steps lack it.
    pub const fn kinked_steps(&self) -> u64 {
        self.kinked_steps
    }

    /// Errors of the time steps; `None` if they are not known.
    pub fn of_steps(&self) -> Option<&State> {
        self.is_known.then_some(&self.steps.error)
    }

    /// Errors of the mesh; `None` if they are not known or not included.
    pub fn of_mesh(&self) -> Option<&State> {
        self.mesh.as_ref().filter(|mesh| mesh.is_known).map(|mesh| &mesh.motion.error)
    }

    /// Returns true if forces of the mesh were set since the start or the last jump.
    pub fn has_forces(&self) -> bool {
        self.mesh.as_ref().is_some_and(|mesh| mesh.count > 0)
    }

    /// Sets the forces of the mesh at a time. Returns their relative difference from the extrapolation, if there is one.
    pub(crate) fn set_forces(&mut self, t: f64, forces: &[f64]) -> Option<f64> {
        let mesh = self.mesh.as_mut()?;
        let forces = &forces[..mesh.now.len()];
        let has_line = mesh.count == 2;
        mesh.is_smooth = true;
        mesh.extrapolate(t);
        let (mut missed, mut total) = (0.0, 0.0);
        for ((now, force), size) in mesh.now.iter().zip(forces).zip(&self.sizes) {
            missed += (size * (now - force)).powi(2);
            total += (size * force).powi(2);
        }
        let difference = f64::sqrt(missed / total);
        mesh.is_smooth = has_line && difference < ROUGH;
        mesh.forces.swap(0, 1);
        mesh.forces[0].copy_from_slice(forces);
        mesh.times = [t, mesh.times[0]];
        mesh.count = (mesh.count + 1).min(2);
        has_line.then_some(difference)
    }

    /// Starts again at a jump of loads, or at a start whose accelerations need not satisfy the equations of motion.
    pub(crate) fn restart(&mut self, is_consistent: bool) {
        self.quadrature.restart(is_consistent);
        self.mesh.iter_mut().for_each(|mesh| mesh.count = 0);
    }

    /// Advances by an accepted step between two states.
    pub(crate) fn advance<E: EquationsOfMotion + ?Sized>(
        &mut self,
        eom: &E,
        newton: &mut Newton,
        (before, now): (&State, &State),
    ) {
        let h = now.t - before.t;
        let ratio = if self.h > 0.0 { h / self.h } else { 1.0 };
        self.h = h;
        self.quadrature.defect(before, now, &mut self.defect);
        if eom.has_kinks() && eom.law_changes(before, &State::middle_of_step(before, now), now).is_some() {
            self.kinked_steps += 1;
        }
        eom.residual(now, &mut self.residual);
        let step = ComputedStep { h, ratio, now, residual: &self.residual, sizes: &self.sizes };
        if self.is_known {
            let source = ErrorSource::Step(&self.defect);
            self.is_known = self.steps.advance(eom, newton, &step, &source, &mut self.moved);
        }
        if let Some(mesh) = self.mesh.as_mut().filter(|mesh| mesh.is_known) {
            mesh.extrapolate(now.t);
            let source = ErrorSource::Forces(&mesh.now);
            mesh.is_known = mesh.motion.advance(eom, newton, &step, &source, &mut self.moved);
        }
    }

    pub(crate) fn is_valid(&self, coordinates: usize, multipliers: usize) -> bool {
        let Self { steps, mesh, quadrature, defect, sizes, moved, h, .. } = self;
        steps.is_valid(coordinates, multipliers)
            && mesh.as_ref().is_none_or(|mesh| mesh.is_valid(coordinates, multipliers))
            && quadrature.is_valid(coordinates)
            && defect.is_valid(coordinates)
            && moved.is_valid(coordinates, multipliers)
            && sizes.len() == coordinates
            && sizes.iter().all(|size| *size > 0.0)
            && h.is_finite()
    }
}

impl MeshErrors {
    /// Extrapolates the forces to a time.
    fn extrapolate(&mut self, t: f64) {
        let Self { times: [last, earlier], forces: [forces, of_earlier], count, is_smooth, now, .. } = self;
        let ratio = if *count == 2 && *is_smooth { (t - *last) / (*last - *earlier) } else { 0.0 };
        for (now, (last, earlier)) in now.iter_mut().zip(forces.iter().zip(of_earlier)) {
            *now = last + ratio * (last - *earlier);
        }
    }

    fn is_valid(&self, coordinates: usize, multipliers: usize) -> bool {
        let Self { motion, times, forces: [first, second], now, .. } = self;
        let is_valid = |x: &Vec<f64>| x.len() == coordinates && x.iter().all(|x| x.is_finite());
        motion.is_valid(coordinates, multipliers)
            && [first, second, now].into_iter().all(is_valid)
            && times.iter().all(|t| t.is_finite())
            && (self.count < 2 || times[0] > times[1])
    }
}
