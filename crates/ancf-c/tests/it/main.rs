//! Tests of the C interface: the header, the examples in C and C++, and errors.

mod errors;
mod header;
mod programs;
