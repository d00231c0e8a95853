//! Kim et al. (2017).

mod cantilever;
mod forms;
mod misprints;
mod pendulum;
mod scales;
mod static_tips;
