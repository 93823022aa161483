#include "sim/digest/workers.h"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <deque>
#include <stdexcept>

namespace wrinkle {
namespace {

// What a worker writes: for each frame two lines, the digest and its note; or one that begins with this.
constexpr char kFailure = '!';

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text + "\n";
}

void write_all(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = write(file, text.data() + done, text.size() - done);
    if (n <= 0) _exit(1);
    done += static_cast<std::size_t>(n);
  }
}

[[noreturn]] void work(std::span<const DigestFrame> frames, const SameConfig& group, const Engines& engines, int out) {
  try {
    // A model that only draws random frames, which are short, is sooner built than it would be fast.
    const bool optimize = std::any_of(group.begin(), group.end(), [&](std::size_t i) { return !is_random(frames[i]); });
    for (const std::size_t i : group) {
      const MeasuredFrame measured = measure(frames[i], engines, optimize);
      write_all(out, text_of(measured.line) + one_line(measured.note));
    }
  } catch (const std::exception& error) {
    write_all(out, kFailure + one_line(error.what()));
  }
  _exit(0);  // neither the exit handlers nor the buffers of the process it came from
}

struct Worker {
  pid_t process = -1;
  int in = -1;  // what it writes
  SameConfig group;
  std::size_t next = 0;  // of the group
  std::string text;      // not yet a whole frame
};

class Workers {
 public:
  Workers(std::span<const DigestFrame> frames, const Engines& engines,
          const std::function<void(std::size_t, const MeasuredFrame&)>& done)
      : frames_(frames), engines_(engines), done_(done) {}
  ~Workers() {
    for (Worker& worker : workers_) end(worker);
  }

  std::size_t running() const { return workers_.size(); }

  void start(const SameConfig& group) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe to a process can be made");
    std::fflush(nullptr);
    const pid_t process = fork();
    if (process < 0) throw std::runtime_error("no process can be started");
    if (process == 0) {
      close(ends[0]);
      work(frames_, group, engines_, ends[1]);
    }
    close(ends[1]);
    workers_.push_back({process, ends[0], group, 0, {}});
  }

  // Waits for output of any of them and takes it.
  void wait() {
    std::vector<pollfd> ready;
    for (const Worker& worker : workers_) ready.push_back({worker.in, POLLIN, 0});
    poll(ready.data(), ready.size(), -1);
    for (std::size_t i = ready.size(); i-- > 0;) {
      if (ready[i].revents == 0 || read_more(workers_[i])) continue;
      const Worker ended = workers_[i];
      workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(i));
      close(ended.in);
      waitpid(ended.process, nullptr, 0);
      if (ended.next < ended.group.size())
        throw std::runtime_error(fmt::format("{}: the process that draws it has ended before its time", name(ended)));
    }
  }

 private:
  std::string name(const Worker& worker) const {
    const DigestFrame& frame = frames_[worker.group[std::min(worker.next, worker.group.size() - 1)]];
    return frame.config_name + " " + frame.scene;
  }

  // False at the end.
  bool read_more(Worker& worker) {
    char buffer[4096];
    const ssize_t n = read(worker.in, buffer, sizeof buffer);
    if (n <= 0) return false;
    worker.text.append(buffer, static_cast<std::size_t>(n));
    while (take_frame(worker)) continue;
    return true;
  }

  bool take_frame(Worker& worker) {
    const std::size_t first = worker.text.find('\n');
    if (first == std::string::npos) return false;
    if (worker.text.front() == kFailure)
      throw std::runtime_error(name(worker) + ": " + worker.text.substr(1, first - 1));
    const std::size_t second = worker.text.find('\n', first + 1);
    if (second == std::string::npos) return false;
    const MeasuredFrame measured{parse_line(worker.text.substr(0, first), "digest", 0),
                                 worker.text.substr(first + 1, second - first - 1)};
    worker.text.erase(0, second + 1);
    done_(worker.group.at(worker.next++), measured);
    return true;
  }

  static void end(Worker& worker) {
    close(worker.in);
    kill(worker.process, SIGTERM);
    waitpid(worker.process, nullptr, 0);
  }

  std::span<const DigestFrame> frames_;
  const Engines& engines_;
  const std::function<void(std::size_t, const MeasuredFrame&)>& done_;
  std::vector<Worker> workers_;
};

}  // namespace

void measure_in_processes(std::span<const DigestFrame> frames, const std::vector<SameConfig>& groups,
                          const Engines& engines, int processes,
                          const std::function<void(std::size_t, const MeasuredFrame&)>& done) {
  Workers workers(frames, engines, done);
  std::deque<SameConfig> left(groups.begin(), groups.end());
  while (!left.empty() || workers.running() > 0) {
    while (!left.empty() && workers.running() < static_cast<std::size_t>(processes)) {
      workers.start(left.front());
      left.pop_front();
    }
    workers.wait();
  }
}

}  // namespace wrinkle
