use std::borrow::Cow;

use ancf::assembly::Assembly;
use ancf::model::Analysis;
use ancf::solver::equations::{EquationsOfMotion, State};

use super::frame_label::frame_label;
use super::messages;
use super::mode_shape::DisplacedStates;
use crate::charts::positions_on_abscissa;
use crate::geometry::{Geometry, Placement};
use crate::run::{Recording, Snapshot, evenly_spaced};

/// Frames that are drawn.
pub(super) struct DrawnFrames<'a> {
    /// Positions on the abscissa of the charts.
    pub positions: Vec<f64>,
    pub labels: Option<Vec<String>>,
    /// Of each frame the index of the state with the imaginary part of its shape.
    pub imaginary: Vec<Option<usize>>,
    /// States of the frames, then those displaced by imaginary parts.
    pub states: Vec<Cow<'a, State>>,
    /// Placements of the states.
    pub placed: Vec<Placement>,
    /// State of the reference placement.
    pub reference_state: State,
    /// Placement of the undeformed state; of mode shapes, of the state about which they are computed.
    pub reference: Placement,
}

/// Frame of which it is not yet known if it can be drawn.
struct Candidate<'a> {
    position: f64,
    label: String,
    state: Cow<'a, State>,
    placed: Placement,
    imaginary: Option<(State, Placement)>,
}

impl Candidate<'_> {
    fn is_finite(&self) -> bool {
        let all = [Some(&self.placed), self.imaginary.as_ref().map(|(_, placed)| placed)];
        self.position.is_finite() && all.into_iter().flatten().all(Placement::is_finite)
    }
}

impl<'a> DrawnFrames<'a> {
    /// Selects at most `most` evenly spaced frames of a recording. Omissions are added to the messages.
    pub fn new(
        recording: &'a Recording<'_>,
        geometry: &Geometry<'_>,
        size: f64,
        most: usize,
        notes: &mut Vec<String>,
    ) -> Self {
        let assembly = recording.simulation.assembly();
        let is_modal = recording.is_modal();
        let (all, unfit): (Vec<&Snapshot>, Vec<_>) =
            recording.frames.iter().partition(|frame| fits(assembly, &frame.state));
        if !unfit.is_empty() {
            notes.push(messages::unfit(unfit.len()));
        }
        let reference_state =
            all.first().filter(|_| is_modal).map_or_else(|| assembly.initial(), |frame| frame.state.clone());
        let reference = geometry.place(&reference_state);
        let values: Vec<f64> = all.iter().map(|frame| frame.value).collect();
        let positions = positions_on_abscissa(recording, &values).unwrap_or(values);
        let picked = evenly_spaced(all.len(), most);
        if picked.len() < all.len() {
            notes.push(messages::thinned(picked.len(), all.len()));
        }
        let draw = |number: usize| {
            let frame = all[number];
            let (position, label) = (positions[number], frame_label(recording, frame));
            if !is_modal {
                let (state, placed) = (Cow::Borrowed(&frame.state), geometry.place(&frame.state));
                return Candidate { position, label, state, placed, imaginary: None };
            }
            let DisplacedStates { real, imaginary } = DisplacedStates::new(geometry, &frame.state, size);
            let imaginary = imaginary.map(|state| {
                let placed = geometry.place(&state);
                (state, placed)
            });
            let placed = geometry.place(&real);
            Candidate { position, label, state: Cow::Owned(real), placed, imaginary }
        };
        let (mut drawn, broken): (Vec<_>, Vec<_>) =
            picked.into_iter().map(draw).partition(Candidate::is_finite);
        if !broken.is_empty() {
            notes.push(messages::not_finite(broken.len()));
        }
        if drawn.is_empty() {
            notes.push(messages::EMPTY.to_owned());
            let (state, placed) = (Cow::Owned(reference_state.clone()), reference.clone());
            let label = "undeformed".to_owned();
            drawn.push(Candidate { position: 0.0, label, state, placed, imaginary: None });
        }
        Self::of(recording, drawn, (reference_state, reference))
    }

    /// True if a shape has an imaginary part.
    pub fn has_imaginary(&self) -> bool {
        self.imaginary.iter().any(Option::is_some)
    }

    /// Placements by the real part and, if any, by the imaginary part of the shape to which a state belongs.
    pub fn parts(&self, state: usize) -> Vec<&Placement> {
        let real = self.imaginary.iter().position(|part| *part == Some(state)).unwrap_or(state);
        let imaginary = self.imaginary.get(real).copied().flatten();
        [Some(real), imaginary].into_iter().flatten().map(|number| &self.placed[number]).collect()
    }

    fn of(
        recording: &Recording<'_>,
        drawn: Vec<Candidate<'a>>,
        (reference_state, reference): (State, Placement),
    ) -> Self {
        let (positions, imaginary, states, placed) = Default::default();
        let mut frames =
            Self { positions, labels: None, imaginary, states, placed, reference_state, reference };
        let (mut labels, mut parts) = (Vec::new(), Vec::new());
        let count = drawn.len();
        for Candidate { position, label, state, placed, imaginary } in drawn {
            frames.positions.push(position);
            labels.push(label);
            frames.states.push(state);
            frames.placed.push(placed);
            frames.imaginary.push(imaginary.is_some().then_some(count + parts.len()));
            parts.extend(imaginary);
        }
        for (state, placed) in parts {
            frames.states.push(Cow::Owned(state));
            frames.placed.push(placed);
        }
        // Times and load factors are shown without a label.
        let plain = matches!(recording.model.analysis, Analysis::Dynamics(_) | Analysis::Statics(_));
        frames.labels = (!plain).then_some(labels);
        frames
    }
}

/// True if a state has the dimensions of the equations of motion.
pub(crate) fn fits(assembly: &Assembly, s: &State) -> bool {
    let (n, m) = (assembly.system.coordinates(), assembly.system.multipliers());
    [&s.q, &s.v, &s.a].iter().all(|x| x.len() == n) && s.lambda.len() == m
}
