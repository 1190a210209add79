// A rank above 0: it does tasks of work for rank 0, and nothing else. It writes no file and prints nothing.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "geometry/shared_work.h"
#include "parallel/channel.h"

namespace hottel {

// A job as a helper has it.
class HelperJob {
 public:
  virtual ~HelperJob() = default;
  // Returns what was found, in bytes. told: what rank 0 says of these tasks. Whatever it throws, rank 0 does them.
  virtual std::string work(const WorkRange& tasks, std::string_view told) = 0;
};

// Makes a job of its bytes; whatever it throws, rank 0 refuses the request and says why.
class HelperJobs {
 public:
  virtual ~HelperJobs() = default;
  virtual std::unique_ptr<HelperJob> make(std::string_view bytes) = 0;
};

// Works until rank 0 sends it home. Returns the exit code that it is told.
int help(Channel& channel, HelperJobs& jobs);

}  // namespace hottel
