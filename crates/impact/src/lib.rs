//! Impact laws, written once for every number system.
