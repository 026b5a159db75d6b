//! What must hold of the house and of the documents that it ships.

mod documents; // the documents and pages that are shipped
mod layering; // which crate may know which, and what the kernel links
