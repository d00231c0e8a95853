use ancf_solver::equations::{Local, LocalMatrix, Term, Weights, load_power};
use nalgebra::{SMatrix, Vector3};

use crate::functions::Function;
use crate::kinematics::{FrameValues, SectionFrame, add_section, visit_skew};

/// Moment on a section, as forces on its directors d = r_y and e = r_z.
///
/// The forces Tᵀ m of the [`SectionFrame`] have the power m·ω. For any lengths and angle of d and e,
/// d × f_d + e × f_e = m.
///
/// The moment is constant in the global frame, or as a follower in the section frame. In plane rotation, the constant
/// moment has the potential −Mθ. In space neither moment has a potential (Ziegler 1968). The derivative S(m), of a
/// follower S(m) − Tᵀ \[m\]× T, is not symmetric, and the tangent contains its symmetric part. Newton's method then
/// converges linearly, at a rate proportional to the moment. The work counts as supplied work.
#[derive(Clone, Debug)]
pub struct Moment {
    frame: SectionFrame,
    coordinates: Vec<usize>,
    direction: MomentFrame,
    function: Function,
}

/// Frame in which a moment is constant.
#[derive(Clone, Copy, Debug)]
enum MomentFrame {
    Global(Vector3<f64>),
    /// Moment with its value in the reference state.
    Section(Vector3<f64>),
}

impl Moment {
    /// Creates a moment, times a function of time, on a section.
    pub fn new(frame: &SectionFrame, moment: Vector3<f64>, function: Function) -> Self {
        let mut coordinates: Vec<usize> = frame.coordinates().collect();
        coordinates.sort_unstable();
        coordinates.dedup();
        let frame = frame.within(&coordinates);
        Self { frame, coordinates, direction: MomentFrame::Global(moment), function }
    }

    /// Creates a follower moment with the value `moment` in the reference state.
    pub fn follower(frame: &SectionFrame, moment: Vector3<f64>, function: Function) -> Self {
        Self { direction: MomentFrame::Section(moment), ..Self::new(frame, moment, function) }
    }

    /// Creates a follower moment with the given components in the section frame, times a function of time.
    pub fn in_section(frame: &SectionFrame, components: Vector3<f64>, function: Function) -> Self {
        Self::follower(frame, frame.composed(&components), function)
    }

    /// Returns the moment in a state.
    fn moment(&self, values: &FrameValues) -> Vector3<f64> {
        match self.direction {
            MomentFrame::Global(moment) => moment,
            MomentFrame::Section(moment) => values.turned(&moment),
        }
    }

    fn factor(&self, at: &Local<'_>) -> f64 {
        at.load * self.function.value(at.t)
    }
}

impl Term for Moment {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let values = self.frame.at(at.q);
        let factor = -self.factor(at);
        self.frame.add(values.forces(&self.moment(&values)).map(|force| force * factor), r);
    }

    /// The forces are of degree −1 in the directors, whose relative error is that of their parts. Skew directors
    /// amplify it.
    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (MomentFrame::Global(moment) | MomentFrame::Section(moment)) = self.direction;
        self.frame.add_errors(at.q, (self.factor(at) * moment.norm()).abs(), 0.0, floor);
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let values = self.frame.at(at.q);
        // The part −Tᵀ [m]× T of a follower is antisymmetric.
        let h: SMatrix<f64, 6, 6> = values.second_variation(&self.moment(&values));
        add_section(&self.frame, &h, -w.q * self.factor(at), k);
    }

    fn skew_stiffness(&self, at: &Local<'_>, visit: &mut dyn FnMut(usize, usize, f64)) {
        let values = self.frame.at(at.q);
        let moment = self.moment(&values);
        let mut h: SMatrix<f64, 6, 6> = values.second_variation(&moment);
        if matches!(self.direction, MomentFrame::Section(_)) {
            h -= values.turning(&moment);
        }
        visit_skew(&self.frame.directors().each_ref(), &h, -self.factor(at), visit);
    }

    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        load_power(self, at)
    }

    fn is_damped(&self) -> bool {
        false
    }
}
