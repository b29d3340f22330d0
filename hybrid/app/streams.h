// The standard streams as a caller may leave them: closed, or a pipe that nobody reads.
#pragma once

namespace vasorod {

/// Makes every failed write an error that can be reported, and keeps files that are opened later
/// off the descriptors 0 to 2:
/// - a closed standard stream gets a descriptor on which its use fails, because the next file to be
///   opened, a result's, would get its number and then the program's messages;
/// - SIGPIPE and SIGXFSZ, which end the process, are ignored in favour of the error of the write.
void keep_streams_apart();

}  // namespace vasorod
