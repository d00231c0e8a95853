use std::ops::Deref;

/// Equations of motion with the active set of terms: the given equations or their latest replacement.
#[derive(Debug)]
pub(crate) struct ActiveSet<'a, E: ?Sized> {
    given: &'a E,
    replacement: Option<Box<E>>,
}

impl<'a, E> ActiveSet<'a, E> {
    pub(crate) fn new(given: &'a E) -> Self {
        Self { given, replacement: None }
    }

    pub(crate) fn replace(&mut self, by: E) {
        self.replacement = Some(Box::new(by));
    }
}

impl<E: ?Sized> Deref for ActiveSet<'_, E> {
    type Target = E;

    fn deref(&self) -> &E {
        self.replacement.as_deref().unwrap_or(self.given)
    }
}
