use std::ops::Deref;

use super::error::SolveError;
use super::newton_method::Newton;
use crate::equations::{EquationsOfMotion, State};
use crate::sparse::SparseMatrix;

/// Equations of motion with the active set of terms: the given equations or their latest replacement.
#[derive(Debug)]
pub(crate) struct ActiveSet<'a, E: ?Sized> {
    given: Given<'a, E>,
    replacement: Option<Box<E>>,
}

#[derive(Debug)]
enum Given<'a, E: ?Sized> {
    Borrowed(&'a E),
    Owned(Box<E>),
}

impl<E> ActiveSet<'static, E> {
    /// Creates a set that owns the equations.
    pub(crate) fn owned(given: E) -> Self {
        Self { given: Given::Owned(Box::new(given)), replacement: None }
    }
}

impl<'a, E> ActiveSet<'a, E> {
    pub(crate) fn new(given: &'a E) -> Self {
        Self { given: Given::Borrowed(given), replacement: None }
    }

    pub(crate) fn replace(&mut self, by: E) {
        self.replacement = Some(Box::new(by));
    }
}

impl<E: EquationsOfMotion> ActiveSet<'_, E> {
    /// Includes the terms that may become active soon after a state. Returns true if there were any.
    pub(crate) fn include_near_terms(&mut self, newton: &mut Newton, s: &State) -> Result<bool, SolveError> {
        self.include(self.with_near_terms(s), newton)
    }

    /// Includes the terms that are active in a state. Returns true if there were any: solutions without them are wrong.
    pub(crate) fn include_active_terms(
        &mut self,
        newton: &mut Newton,
        s: &State,
    ) -> Result<bool, SolveError> {
        self.include(self.with_active_terms(s), newton)
    }

    fn include(
        &mut self,
        extended: Option<(E, SparseMatrix)>,
        newton: &mut Newton,
    ) -> Result<bool, SolveError> {
        let Some((eom, matrix)) = extended else { return Ok(false) };
        self.replace(eom);
        newton.replace_matrix(matrix).map(|()| true)
    }
}

impl<E: ?Sized> Deref for ActiveSet<'_, E> {
    type Target = E;

    fn deref(&self) -> &E {
        let given: &E = match &self.given {
            Given::Borrowed(given) => given,
            Given::Owned(given) => given,
        };
        self.replacement.as_deref().unwrap_or(given)
    }
}
