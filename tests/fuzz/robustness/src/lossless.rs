//! Lines: every byte of a file can be given back.

use tipc::source::Source;

/// The file that `source` was decoded from, put together from its lines.
pub(crate) fn given_back(source: &Source) -> Vec<u8> {
    let mut bytes = source.mark().to_vec();
    for line in source.lines() {
        bytes.extend_from_slice(source.original(line.span));
        bytes.extend_from_slice(source.original(line.end));
    }
    bytes.extend_from_slice(source.tail());
    bytes
}
