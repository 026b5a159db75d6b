//! What must hold of the house and of the documents that it ships.

mod layering; // which crate may know which, and what the kernel links
