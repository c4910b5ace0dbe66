
pub mod hardware;
