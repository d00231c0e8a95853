use std::borrow::Cow;

use ancf::model::{Analysis, Assembly};
use ancf::system::{EquationsOfMotion, State};

use crate::chart::places_on;
use crate::message;
use crate::shape::displaced;
use crate::{Frame, Geometry, Placement, Recording};

/// The frames that are drawn.
pub(crate) struct Instants<'a> {
    /// Their places on the abscissa.
    pub values: Vec<f64>,
    pub labels: Option<Vec<String>>,
    pub states: Vec<Cow<'a, State>>,
    pub placed: Vec<Placement>,
    /// The state of the reference.
    pub about: State,
    /// The undeformed state; of shapes, that about which they are.
    pub reference: Placement,
}

/// A frame before it is known whether it can be drawn.
struct Drawn<'a> {
    value: f64,
    label: String,
    state: Cow<'a, State>,
    placed: Placement,
}

impl<'a> Instants<'a> {
    /// At most so many frames of a recording, evenly spaced; messages say what was left out.
    pub fn new(
        recording: &'a Recording<'_>,
        geometry: &Geometry<'_>,
        size: f64,
        most: usize,
        messages: &mut Vec<String>,
    ) -> Self {
        let assembly = recording.simulation.assembly();
        let modal = recording.is_modal();
        let (all, unfit): (Vec<&Frame>, Vec<_>) =
            recording.frames.iter().partition(|frame| fits(assembly, &frame.state));
        if !unfit.is_empty() {
            messages.push(message::unfit(unfit.len()));
        }
        let about =
            all.first().filter(|_| modal).map_or_else(|| assembly.initial(), |frame| frame.state.clone());
        let reference = geometry.place(&about);
        let values: Vec<f64> = all.iter().map(|frame| frame.value).collect();
        let places = places_on(recording, &values).unwrap_or(values);
        let picked = evenly(all.len(), most);
        if picked.len() < all.len() {
            messages.push(message::thinned(picked.len(), all.len()));
        }
        let draw = |number: usize| {
            let frame = all[number];
            let state = match modal {
                true => Cow::Owned(displaced(geometry, &frame.state, size)),
                false => Cow::Borrowed(&frame.state),
            };
            let placed = geometry.place(&state);
            Drawn { value: places[number], label: label(recording, frame), state, placed }
        };
        let (mut drawn, broken): (Vec<_>, Vec<_>) = picked
            .into_iter()
            .map(draw)
            .partition(|drawn| drawn.value.is_finite() && drawn.placed.is_finite());
        if !broken.is_empty() {
            messages.push(message::not_finite(broken.len()));
        }
        if drawn.is_empty() {
            messages.push(message::EMPTY.to_owned());
            let (state, placed) = (Cow::Owned(about.clone()), reference.clone());
            drawn.push(Drawn { value: 0.0, label: "undeformed".to_owned(), state, placed });
        }
        Self::of(recording, drawn, (about, reference))
    }

    fn of(recording: &Recording<'_>, drawn: Vec<Drawn<'a>>, (about, reference): (State, Placement)) -> Self {
        let (values, states, placed) = Default::default();
        let mut instants = Self { values, labels: None, states, placed, about, reference };
        let mut labels = Vec::new();
        for Drawn { value, label, state, placed } in drawn {
            instants.values.push(value);
            labels.push(label);
            instants.states.push(state);
            instants.placed.push(placed);
        }
        // Times and load factors speak for themselves.
        let plain = matches!(recording.model.analysis, Analysis::Dynamics(_) | Analysis::Statics(_));
        instants.labels = (!plain).then_some(labels);
        instants
    }
}

/// Whether a state has as many numbers as the equations.
pub(crate) fn fits(assembly: &Assembly, s: &State) -> bool {
    let (n, m) = (assembly.system.coordinates(), assembly.system.multipliers());
    [&s.q, &s.v, &s.a].iter().all(|x| x.len() == n) && s.lambda.len() == m
}

/// What a frame is called.
pub(crate) fn label(recording: &Recording<'_>, frame: &Frame) -> String {
    let number = frame.value;
    let of = |column: &str| {
        let (_, first) = recording.series.columns().next()?;
        let row = first.iter().position(|x| *x == number)?;
        recording.series.column(column)?.get(row).copied()
    };
    match recording.model.analysis {
        Analysis::Modes(_) => match of("frequency") {
            Some(frequency) if frequency.is_finite() => {
                let seconds = recording.model.units.as_ref().is_some_and(|units| units.time == "s");
                let unit =
                    if seconds { "Hz".to_owned() } else { recording.unit(ancf::scales::Dimension::RATE) };
                format!("mode {number}: {} {unit}", short(frequency)).trim_end().to_owned()
            }
            _ => format!("mode {number}: unstable"),
        },
        Analysis::Buckling(_) => of("factor").map_or_else(
            || format!("form {number}"),
            |factor| format!("form {number}: load factor {}", short(factor)),
        ),
        _ => format!("load factor {}", short(number)),
    }
}

/// Four digits.
fn short(x: f64) -> String {
    format!("{x:.3e}").parse::<f64>().map_or_else(|_| x.to_string(), |x| x.to_string())
}

/// At most so many numbers below `count`, evenly spaced, the first and the last among them.
pub(crate) fn evenly(count: usize, most: usize) -> Vec<usize> {
    if count <= most {
        return (0..count).collect();
    }
    let last = (most - 1).max(1);
    (0..=last).map(|k| (k * (count - 1) + last / 2) / last).collect()
}
