//! Placeholder of the first slices; see ARCHITECTURE.md.
