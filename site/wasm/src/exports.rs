//! What JavaScript calls: `room` for a question's bytes, `ask` with them. The answer begins with its length in four
//! bytes, lowest first; `done` gives it back.
#![allow(unsafe_code)]

/// Room for so many bytes.
#[unsafe(no_mangle)]
extern "C" fn room(length: usize) -> *mut u8 {
    let bytes = vec![0_u8; length].into_boxed_slice();
    Box::into_raw(bytes).cast()
}

/// Answers the question that is in a room, which is gone afterwards.
///
/// # Safety
/// `question` is from `room(length)`.
#[unsafe(no_mangle)]
unsafe extern "C" fn ask(question: *mut u8, length: usize) -> *mut u8 {
    let bytes = std::ptr::slice_from_raw_parts_mut(question, length);
    // SAFETY: it is such a box, as `room` made it, and nobody uses it again.
    let question = unsafe { Box::from_raw(bytes) };
    let answer = crate::answer(&String::from_utf8_lossy(&question));
    let mut whole = (answer.len() as u32).to_le_bytes().to_vec();
    whole.extend(answer.into_bytes());
    Box::into_raw(whole.into_boxed_slice()).cast()
}

/// An answer has been read.
///
/// # Safety
/// `answer` is from `ask`, and `length` is what its first four bytes say.
#[unsafe(no_mangle)]
unsafe extern "C" fn done(answer: *mut u8, length: usize) {
    let bytes = std::ptr::slice_from_raw_parts_mut(answer, length + 4);
    // SAFETY: it is such a box, as `ask` made it, and nobody uses it again.
    drop(unsafe { Box::from_raw(bytes) });
}
