//! A row of the table: what is measured, what it should be, what others need.

use serde::Serialize;

/// A row as it is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Asked {
    /// What is measured.
    pub name: &'static str,
    /// In which unit.
    pub unit: Unit,
    /// What it should be: at most, of a gain at least.
    pub goal: f64,
    /// Who needs how much for the same, in this unit.
    pub peer: Option<(&'static str, f64)>,
    /// Whether it has so many elements that it takes long.
    pub large: bool,
}

/// What a number is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Unit {
    /// Microseconds of the processor per element.
    #[serde(rename = "us")]
    Microseconds,
    /// Seconds of the processor.
    #[serde(rename = "s")]
    Seconds,
    /// Kilobytes per element.
    #[serde(rename = "kB")]
    Kilobytes,
    /// How many times less on the wall; the more the better.
    #[serde(rename = "x less")]
    Gain,
    /// How many times more.
    #[serde(rename = "x")]
    Factor,
}

impl Unit {
    /// As text.
    pub const fn text(self) -> &'static str {
        match self {
            Self::Microseconds => "us",
            Self::Seconds => "s",
            Self::Kilobytes => "kB",
            Self::Gain | Self::Factor => "x",
        }
    }
}

/// What was measured.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Measured {
    /// The number, in the unit of the row.
    pub value: f64,
    /// Conditions that tell it apart, in words; may be empty.
    pub note: String,
    /// What the machine would need at best, in the unit of the row, and whether by bytes or operations.
    pub best: Option<Best>,
}

/// The least that the machine would need.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Best {
    /// In the unit of the row.
    pub value: f64,
    /// What bounds it.
    pub bound: Bound,
}

/// What bounds a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Bound {
    /// Floating-point operations.
    Operations,
    /// Bytes to and from memory.
    Bytes,
    /// Bytes to and from the second cache.
    CachedBytes,
}

/// A row of the finished table.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// What was measured.
    pub name: &'static str,
    /// In which unit.
    pub unit: Unit,
    /// What it should be.
    pub goal: f64,
    /// What it is; nothing if it was left out.
    pub ours: Option<f64>,
    /// Who is compared with.
    pub peer: Option<&'static str>,
    /// What these need.
    pub theirs: Option<f64>,
    /// How many times more that is than ours.
    pub ratio: Option<f64>,
    /// The machine's best.
    pub best: Option<Best>,
    /// The machine's best as part of ours.
    pub fraction: Option<f64>,
    /// Conditions, or why it was left out.
    pub note: String,
}

impl Row {
    /// A row with what came of measuring it.
    pub fn new(asked: &Asked, measured: Result<Measured, String>) -> Self {
        let Asked { name, unit, goal, peer, .. } = *asked;
        let (ours, note, best) = match measured {
            Ok(Measured { value, note, best }) => (Some(value), note, best),
            Err(why) => (None, why, None),
        };
        let (peer, theirs) = (peer.map(|(name, _)| name), peer.map(|(_, value)| value));
        let ratio = theirs.zip(ours).map(|(theirs, ours)| theirs / ours);
        let fraction = best.zip(ours).map(|(best, ours)| best.value / ours);
        Self { name, unit, goal, ours, peer, theirs, ratio, best, fraction, note }
    }

    /// Whether the goal is met, if the row was measured.
    pub fn is_met(&self) -> Option<bool> {
        self.ours.map(|ours| if self.unit == Unit::Gain { ours >= self.goal } else { ours <= self.goal })
    }
}
