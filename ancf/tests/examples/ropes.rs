//! Ropes, moorings, strings and belts.
