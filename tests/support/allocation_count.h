// Counts every allocation of the process, whoever makes it, so that a test can show that a piece
// of code makes none. Linking allocation_count.cpp is what switches it on.
#pragma once

namespace support {

// So far. Always 0 under a sanitizer, which wants malloc for itself.
long allocation_count();

}  // namespace support
