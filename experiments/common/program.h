#pragma once

#include <string_view>

namespace cirque {

/// What a program of the project returns where the machine fails it (memory, disk, a closed
/// output), as where its input is bad; see also ExitStatus.
constexpr int kProgramFailed = 2;

/// Runs `body`, a whole program, and returns what `main` shall: body's status, or kProgramFailed
/// with one line on stderr where
///  - an exception leaves it, in whatever thread: lack of memory, of threads, or a fault of ours;
///  - what it printed could not be written (a full disk, a closed pipe).
/// Around it stands what every program needs: descriptors 0 to 2 are open, so that no file becomes
/// standard output; a closed pipe is an error of writing and not the end; children can be waited
/// for whatever the parent ignored; one BLAS thread and one heap; of libraries' logs only errors.
int RunMain(std::string_view name, int argc, char** argv, int (*body)(int argc, char** argv));

}  // namespace cirque
