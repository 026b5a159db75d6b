//! What is said of logs.

#![allow(clippy::float_arithmetic, reason = "logs are made of floats")]

mod alarms;
mod attribution;
mod engines;
mod faults;
mod laws;
mod measured;
mod pyramid;
mod rows;
mod table;
