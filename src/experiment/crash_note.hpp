// Crash note: which job took the program down.
//
// A job that crashes (a segmentation fault, say, not an exception) ends the whole run, and would end every run that
// takes it up again. So the last act of a crashing thread is to note its job in a file beside the results; a job noted
// twice is recorded as crashed and not tried again. What ends a run from outside (kill -9, the machine) notes nothing.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace waybreaker::experiment {

// While it exists, crashes of threads that have set their job are noted. At most one at a time in a program.
class CrashNote {
  public:
    explicit CrashNote(const std::string& path);
    ~CrashNote();
    CrashNote(const CrashNote&) = delete;
    CrashNote& operator=(const CrashNote&) = delete;
};

// Sets the job of the current thread while it exists.
class CurrentJob {
  public:
    explicit CurrentJob(std::uint64_t job);
    ~CurrentJob();
    CurrentJob(const CurrentJob&) = delete;
    CurrentJob& operator=(const CurrentJob&) = delete;
};

// How often each job was noted. No file, no crashes.
std::map<std::uint64_t, int> noted_crashes(const std::string& path);

}  // namespace waybreaker::experiment
