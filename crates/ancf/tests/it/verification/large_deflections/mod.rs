//! Large static deflections of cantilevers.

mod cable_cantilever;
mod cable_chain;
mod elastica;
mod gerstmayr_irschik;
mod princeton_beam;
mod roll_up;
