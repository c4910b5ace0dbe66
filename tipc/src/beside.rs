//! Two things at once.

/// Whether anything is done at once: the playground has no threads, and no room for code that starts them.
pub(crate) const HAS_THREADS: bool = cfg!(not(target_family = "wasm"));

/// A program of fewer lines, statements or steps is not worth a second thread.
pub(crate) const FEW: usize = 2000;

/// Does both, side by side if a thread can be started.
#[cfg(not(target_family = "wasm"))]
pub(crate) fn beside<A, B: Send>(one: impl FnOnce() -> A, other: impl Fn() -> B + Sync) -> (A, B) {
    std::thread::scope(|scope| {
        let beside = std::thread::Builder::new().spawn_scoped(scope, &other);
        let one = one();
        let other = match beside {
            Ok(beside) => beside
                .join()
                .unwrap_or_else(|panic| std::panic::resume_unwind(panic)),
            Err(_) => other(),
        };
        (one, other)
    })
}

/// Does both, one after the other.
#[cfg(target_family = "wasm")]
pub(crate) fn beside<A, B>(one: impl FnOnce() -> A, other: impl Fn() -> B) -> (A, B) {
    (one(), other())
}
