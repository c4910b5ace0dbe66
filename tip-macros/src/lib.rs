//! `include_tip!` and `tip!`.
