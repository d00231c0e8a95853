use serde::Serialize;

use crate::Result;

/// Specification of a row.
#[derive(Clone, Copy, Debug)]
pub struct RowSpec {
    /// Name of the measured work.
    pub name: &'static str,
    /// Unit.
    pub unit: RowUnit,
    /// Target: maximum value; of a gain, minimum value.
    pub goal: f64,
    /// Another program and its value for the same work.
    pub peer: Option<(&'static str, f64)>,
    /// True if the work has many elements and takes long.
    pub large: bool,
}

impl RowSpec {
    /// Row of work with few elements.
    pub(super) const fn new(name: &'static str, unit: RowUnit, goal: f64) -> Self {
        Self { name, unit, goal, peer: None, large: false }
    }

    /// States that the work has many elements.
    pub(super) const fn large(self) -> Self {
        Self { large: true, ..self }
    }

    /// Adds another program with its value.
    pub(super) const fn against(self, peer: &'static str, theirs: f64) -> Self {
        Self { peer: Some((peer, theirs)), ..self }
    }
}

/// Unit of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum RowUnit {
    /// Microseconds of CPU time per element or body, or of wall-clock time per step.
    #[serde(rename = "us")]
    Microseconds,
    /// Milliseconds of CPU time per step.
    #[serde(rename = "ms")]
    Milliseconds,
    /// Seconds of CPU time.
    #[serde(rename = "s")]
    Seconds,
    /// Kilobytes per element.
    #[serde(rename = "kB")]
    Kilobytes,
    /// Megabytes.
    #[serde(rename = "MB")]
    Megabytes,
    /// Factor by which wall-clock time decreases. Larger is better.
    #[serde(rename = "x less")]
    Gain,
    /// Ratio. Smaller is better.
    #[serde(rename = "x")]
    Factor,
}

impl RowUnit {
    /// Symbol of the unit.
    pub const fn text(self) -> &'static str {
        match self {
            Self::Microseconds => "us",
            Self::Milliseconds => "ms",
            Self::Seconds => "s",
            Self::Kilobytes => "kB",
            Self::Megabytes => "MB",
            Self::Gain | Self::Factor => "x",
        }
    }
}

/// Measured value of a row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeasuredValue {
    /// Value in the unit of the row.
    pub value: f64,
    /// Conditions of the measurement; may be empty.
    pub note: String,
    /// Lower bound at the peak performance of the machine.
    pub bound: Option<LowerBound>,
}

impl MeasuredValue {
    /// Value with its conditions, without a lower bound.
    pub(super) fn new(value: f64, note: impl Into<String>) -> Self {
        Self { value, note: note.into(), bound: None }
    }
}

/// Lower bound of a row at the peak performance of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LowerBound {
    /// Value in the unit of the row.
    pub value: f64,
    /// Limiting resource.
    #[serde(rename = "bound")]
    pub resource: LimitingResource,
}

/// Resource that limits a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LimitingResource {
    /// Floating-point operations.
    Operations,
    /// Bytes to and from memory.
    Bytes,
    /// Bytes to and from the second-level cache.
    CachedBytes,
}

/// Row of the table.
#[derive(Clone, Debug, Serialize)]
pub struct TableRow {
    /// Name of the measured work.
    pub name: &'static str,
    /// Unit.
    pub unit: RowUnit,
    /// Target.
    pub goal: f64,
    /// Measured value; `None` if the row was skipped.
    pub ours: Option<f64>,
    /// Program for comparison.
    pub peer: Option<&'static str>,
    /// Value of that program.
    pub theirs: Option<f64>,
    /// Ratio of that value to the measured value.
    pub ratio: Option<f64>,
    /// Lower bound at the peak performance of the machine.
    #[serde(rename = "best")]
    pub bound: Option<LowerBound>,
    /// Ratio of the lower bound to the measured value.
    pub fraction: Option<f64>,
    /// Conditions, or the reason for skipping the row.
    pub note: String,
}

impl TableRow {
    /// Row with the result of its measurement.
    pub fn new(spec: &RowSpec, measured: Result<MeasuredValue>) -> Self {
        let RowSpec { name, unit, goal, peer, .. } = *spec;
        let (ours, note, bound) = match measured {
            Ok(MeasuredValue { value, note, bound }) => (Some(value), note, bound),
            Err(why) => (None, why, None),
        };
        let (peer, theirs) = (peer.map(|(name, _)| name), peer.map(|(_, value)| value));
        let ratio = theirs.zip(ours).map(|(theirs, ours)| theirs / ours);
        let fraction = bound.zip(ours).map(|(bound, ours)| bound.value / ours);
        Self { name, unit, goal, ours, peer, theirs, ratio, bound, fraction, note }
    }

    /// True if the target is met; `None` if the row was skipped.
    pub fn is_met(&self) -> Option<bool> {
        self.ours.map(|ours| if self.unit == RowUnit::Gain { ours >= self.goal } else { ours <= self.goal })
    }
}
