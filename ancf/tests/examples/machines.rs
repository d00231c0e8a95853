//! Mechanisms, shafts and springs.
