// A target without libFuzzer, for the tests: every input of a corpus, and then mutations of them that are always the
// same. The input at which the process ends is left in a file.
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/fuzz/fuzz.h"

// Of the sanitizers, where the program has them.
extern "C" __attribute__((weak)) void __sanitizer_set_death_callback(void (*callback)());

namespace {

namespace fs = std::filesystem;

constexpr unsigned kSeconds = 10;            // for one input
constexpr long kKilobytes = 1024L * 1024;    // the most memory the process may hold
constexpr std::size_t kLongestInput = 4096;  // of a mutation

std::vector<std::string> read_corpus(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> corpus;
  for (const fs::path& path : paths) {
    std::ifstream stream(path, std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return corpus;
}

class Mutator {
 public:
  explicit Mutator(const std::vector<std::string>& corpus) : corpus_(corpus) {}

  std::string next() {
    std::string input = corpus_[below(corpus_.size())];
    for (std::size_t i = 1 + below(4); i > 0; --i) mutate(input);
    input.resize(std::min(input.size(), kLongestInput));
    return input;
  }

 private:
  std::size_t below(std::size_t size) { return size == 0 ? 0 : static_cast<std::size_t>(random_() % size); }

  void mutate(std::string& input) {
    switch (below(6)) {
      case 0:
        return flip_bit(input);
      case 1:
        return replace_byte(input);
      case 2:
        return cut(input);
      case 3:
        return repeat(input);
      case 4:
        return splice(input);
      default:
        return replace_number(input);
    }
  }

  void flip_bit(std::string& input) {
    if (!input.empty()) input[below(input.size())] ^= static_cast<char>(1 << below(8));
  }
  void replace_byte(std::string& input) {
    if (!input.empty()) input[below(input.size())] = static_cast<char>(below(256));
  }
  void cut(std::string& input) { input.erase(below(input.size()), 1 + below(16)); }
  void repeat(std::string& input) {
    const std::string part = input.substr(below(input.size()), 1 + below(64));
    input.insert(below(input.size()), part);
  }
  void splice(std::string& input) {
    const std::string& other = corpus_[below(corpus_.size())];
    input.replace(below(input.size()), std::string::npos, other, below(other.size()));
  }
  // A decimal number of the text by one of the kind that readers trip over.
  void replace_number(std::string& input) {
    static const char* const kNumbers[] = {"0",     "-1",         "1",          "255",
                                           "65536", "2147483647", "2147483648", "4294967296",
                                           "1e-40", "1e300",      "nan",        "-9223372036854775808",
                                           "0.5",   "3",          "1e12"};
    constexpr std::string_view kDigits = "0123456789";
    const std::size_t first = input.find_first_of(kDigits, below(input.size()));
    if (first == std::string::npos) return;
    const std::size_t end = std::min(input.find_first_not_of(kDigits, first), input.size());
    input.replace(first, end - first, kNumbers[below(std::size(kNumbers))]);
  }

  const std::vector<std::string>& corpus_;
  std::mt19937_64 random_{1997};
};

// The input that is being read, for the handlers.
std::string current;
const char* kept = nullptr;

void keep_input() {
  const int file = open(kept, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file < 0 || write(file, current.data(), current.size()) < 0) return;
  close(file);
}

void keep_input_and_die(int signal) {
  keep_input();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void run(std::string input) {
  current = std::move(input);
  alarm(kSeconds);  // whose signal ends the process
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(current.data()), current.size());
  alarm(0);
}

long peak_kilobytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) {
    std::fprintf(stderr, "usage: %s CORPUS MUTATIONS FILE\n", arguments[0]);
    return 2;
  }
  const std::vector<std::string> corpus = read_corpus(arguments[1]);
  const int mutations = std::atoi(arguments[2]);
  kept = arguments[3];
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGALRM}) std::signal(signal, keep_input_and_die);
  if (__sanitizer_set_death_callback != nullptr) __sanitizer_set_death_callback(keep_input);
  if (corpus.empty()) {
    std::fprintf(stderr, "%s: no corpus\n", arguments[1]);
    return 2;
  }
  for (const std::string& input : corpus) run(input);
  Mutator mutator(corpus);
  for (int i = 0; i < mutations; ++i) run(mutator.next());
  std::printf("%zu inputs and %d mutations, %ld MB at most\n", corpus.size(), mutations, peak_kilobytes() / 1024);
  if (peak_kilobytes() > kKilobytes) {
    std::fprintf(stderr, "more than %ld MB\n", kKilobytes / 1024);
    return 1;
  }
  return 0;
}
