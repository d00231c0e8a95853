//! Kim et al. (2017): results, units and misprints of the paper.

mod cantilever;
mod forms;
mod misprints;
mod pendulum;
mod scales;
mod static_tips;
