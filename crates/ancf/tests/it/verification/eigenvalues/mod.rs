//! Buckling loads and natural frequencies.

mod buckling;
mod timoshenko_modes;
mod vibration;
