//! Part of a state that is kept.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Part of a state that is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Keep {
    /// Complete states.
    All,
    /// Coordinates only.
    Positions,
    /// No states.
    Nothing,
}

impl Keep {
    /// Word of the parameter `states`.
    pub(crate) const fn word(self) -> &'static str {
        match self {
            Self::All => "all",
            Self::Positions => "positions",
            Self::Nothing => "none",
        }
    }

    /// Reads the word of the parameter `states`.
    pub(crate) fn from_word(word: &str) -> PyResult<Self> {
        match word {
            "all" => Ok(Self::All),
            "positions" => Ok(Self::Positions),
            "none" => Ok(Self::Nothing),
            _ => Err(PyValueError::new_err(format!(
                "states: found {word:?}, expected \"all\", \"positions\" or \"none\""
            ))),
        }
    }
}
