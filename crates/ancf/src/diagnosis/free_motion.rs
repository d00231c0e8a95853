//! Free motions of rigid bodies, and their description.

use std::fmt;

/// Largest number of free motions in a message.
pub(crate) const MAX_LISTED: usize = 20;
/// Largest number of following bodies in the description of a motion.
const MAX_DESCRIBED: usize = 8;

/// Motion of one body, as a rigid body, in a free motion. Lengths in the units of the assembly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RigidMotion {
    /// Translation.
    Translation {
        /// Direction, a unit vector.
        along: [f64; 3],
    },
    /// Rotation about an axis.
    Rotation {
        /// Point of the axis.
        through: [f64; 3],
        /// Direction of the axis, a unit vector.
        along: [f64; 3],
    },
    /// Rotation about an axis and translation along it.
    Screw {
        /// Point of the axis.
        through: [f64; 3],
        /// Direction of the axis, a unit vector.
        along: [f64; 3],
        /// Displacement per angle.
        pitch: f64,
    },
}

/// Motion of rigid bodies without constraint and without stiffness.
///
/// Text: "body `a` can rotate about the axis through (0, 0, 0) along z; with it body `b` translates along y". At most
/// eight following bodies are described.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeMotion {
    /// Names and motions of all bodies involved, the leading body first.
    pub moves: Vec<(String, RigidMotion)>,
}

impl FreeMotion {
    /// Converts lengths into other units by a factor.
    pub fn scaled(mut self, length: f64) -> Self {
        for (_, motion) in &mut self.moves {
            match motion {
                RigidMotion::Translation { .. } => {}
                RigidMotion::Rotation { through, .. } => *through = through.map(|x| x * length),
                RigidMotion::Screw { through, pitch, .. } => {
                    (*through, *pitch) = (through.map(|x| x * length), *pitch * length);
                }
            }
        }
        self
    }
}

impl fmt::Display for FreeMotion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (k, (name, motion)) in self.moves.iter().take(1 + MAX_DESCRIBED).enumerate() {
            match k {
                0 => write!(f, "body `{name}` can {}", words(motion, ""))?,
                1 => write!(f, "; with it body `{name}` {}", words(motion, "s"))?,
                _ => write!(f, ", body `{name}` {}", words(motion, "s"))?,
            }
        }
        match self.moves.len().saturating_sub(1 + MAX_DESCRIBED) {
            0 => Ok(()),
            1 => write!(f, ", and one more body moves"),
            more => write!(f, ", and {more} more bodies move"),
        }
    }
}

/// Predicate of a sentence; `s` is the ending of the verb.
fn words(motion: &RigidMotion, s: &str) -> String {
    match motion {
        RigidMotion::Translation { along } => format!("translate{s} along {}", direction(along)),
        RigidMotion::Rotation { through, along } => {
            format!("rotate{s} about the axis through {} along {}", triple(through), direction(along))
        }
        RigidMotion::Screw { through, along, pitch } => {
            let (point, along, pitch) = (triple(through), direction(along), number(*pitch));
            format!(
                "rotate{s} about the axis through {point} along {along} and move{s} {pitch} along it per radian"
            )
        }
    }
}

/// Name of a global axis, or the components.
fn direction(along: &[f64; 3]) -> String {
    let axis = (0..3).find(|&k| (0..3).all(|j| along[j] == if j == k { 1.0 } else { 0.0 }));
    axis.map_or_else(|| triple(along), |axis| ["x", "y", "z"][axis].to_owned())
}

fn triple(x: &[f64; 3]) -> String {
    format!("({}, {}, {})", number(x[0]), number(x[1]), number(x[2]))
}

/// Number with at most four digits.
pub(crate) fn number(x: f64) -> String {
    format!("{x:.3e}").parse::<f64>().map_or_else(|_| x.to_string(), |x| x.to_string())
}
