use std::ops::Deref;

/// Equations of motion with the active set of terms: the given equations or their latest replacement.
#[derive(Debug)]
pub(crate) struct Current<'a, E: ?Sized> {
    given: &'a E,
    own: Option<Box<E>>,
}

impl<'a, E> Current<'a, E> {
    pub(crate) fn new(given: &'a E) -> Self {
        Self { given, own: None }
    }

    pub(crate) fn replace(&mut self, by: E) {
        self.own = Some(Box::new(by));
    }
}

impl<E: ?Sized> Deref for Current<'_, E> {
    type Target = E;

    fn deref(&self) -> &E {
        self.own.as_deref().unwrap_or(self.given)
    }
}
