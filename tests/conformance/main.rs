//! What must hold of the house and of the documents that it ships.
