use std::ops::Deref;

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
