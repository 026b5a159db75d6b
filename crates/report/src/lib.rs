//! Presents verdicts as text, Markdown and JSON; computes nothing.
