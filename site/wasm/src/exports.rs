//! What JavaScript calls (`../../wasm.mjs`). Texts go in through a `room`, which the call that takes it gives back; texts
//! come out behind their length in four bytes, lowest first, until they are `done` with.
#![allow(unsafe_code)]

use crate::{Playground, trace};

/// Maximum time of a run before the page has its turn, ms.
const TURN: f64 = 8.0;

#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// The time of the page: ms.
    safe fn now() -> f64;
}

/// A playground, which is never given back.
#[unsafe(no_mangle)]
extern "C" fn begin() -> &'static mut Playground {
    Box::leak(Box::default())
}

/// Room for a text of so many bytes.
#[unsafe(no_mangle)]
extern "C" fn room(length: usize) -> *mut u8 {
    let bytes = vec![0_u8; length].into_boxed_slice();
    Box::into_raw(bytes).cast()
}

/// [`Playground::open`]; what comes out is the error, if there is one.
///
/// # Safety
/// `wanted` is from `room(length)`.
#[unsafe(no_mangle)]
unsafe extern "C" fn open(playground: &mut Playground, wanted: *mut u8, length: usize) -> *mut u8 {
    // SAFETY: as above.
    let wanted = unsafe { taken(wanted, length) };
    given(playground.open(&wanted).err().unwrap_or_default())
}

/// [`Playground::advance`], for at most one turn.
#[unsafe(no_mangle)]
extern "C" fn advance(playground: &mut Playground, elapsed: f64) {
    let end = now() + TURN;
    playground.advance(elapsed, || now() < end);
}

/// [`Playground::request`].
///
/// # Safety
/// `request` is from `room(length)`.
#[unsafe(no_mangle)]
unsafe extern "C" fn request(
    playground: &mut Playground,
    request: *mut u8,
    length: usize,
) -> *mut u8 {
    // SAFETY: as above.
    let request = unsafe { taken(request, length) };
    given(playground.request(&request).unwrap_or_default())
}

/// [`Playground::update`]; an empty text is none.
#[unsafe(no_mangle)]
extern "C" fn update(playground: &mut Playground) -> *mut u8 {
    given(playground.update().unwrap_or_default())
}

/// [`fn@trace`], or the error.
///
/// # Safety
/// `wanted` is from `room(length)`.
#[unsafe(no_mangle)]
unsafe extern "C" fn traced(wanted: *mut u8, length: usize) -> *mut u8 {
    // SAFETY: as above.
    let wanted = unsafe { taken(wanted, length) };
    given(trace(&wanted).unwrap_or_else(|error| error))
}

/// A text has been read.
///
/// # Safety
/// `text` came out of one of these functions, and `length` is what its first four bytes say.
#[unsafe(no_mangle)]
unsafe extern "C" fn done(text: *mut u8, length: usize) {
    let bytes = std::ptr::slice_from_raw_parts_mut(text, length + 4);
    // SAFETY: it is such a box, as `given` made it, and nobody uses it again.
    drop(unsafe { Box::from_raw(bytes) });
}

/// The text in a room, which is gone afterwards.
///
/// # Safety
/// `text` is from `room(length)`.
unsafe fn taken(text: *mut u8, length: usize) -> String {
    let bytes = std::ptr::slice_from_raw_parts_mut(text, length);
    // SAFETY: it is such a box, as `room` made it, and nobody uses it again.
    let bytes = unsafe { Box::from_raw(bytes) };
    String::from_utf8_lossy(&bytes).into_owned()
}

fn given(text: String) -> *mut u8 {
    let mut whole = (text.len() as u32).to_le_bytes().to_vec();
    whole.extend(text.into_bytes());
    Box::into_raw(whole.into_boxed_slice()).cast()
}
