// Inputs of a target again, and mutants of them, without libFuzzer:
//   limber_fuzz_replay TARGET [--mutants COUNT] [--seed SEED] [FILE | FOLDER]…
// No file: the target's own, of corpus/ and regressions/, and those that limber's writers make.
//   limber_fuzz_replay TARGET --seeds FOLDER      writes what limber's writers make
//   limber_fuzz_replay                            names the targets
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/printable.hpp"
#include "mutation.hpp"
#include "target.hpp"

namespace limber::fuzz {

namespace {

namespace fs = std::filesystem;

constexpr unsigned kLongestS = 30;                // of one input, on a busy machine
constexpr rlim_t kMostMemory = rlim_t{4} << 30U;  // address space

// What the handler of a crash needs; no input is run by two threads.
std::string current;     // input
std::string kept_as;     // file that it is written to
std::string how_to_run;  // it again

void keep_input() {
  const int file = open(kept_as.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  const bool kept = file >= 0 && write(file, current.data(), current.size()) ==
                                     static_cast<ssize_t>(current.size());
  const std::string& words = kept ? how_to_run : kept_as;
  (void)!write(STDERR_FILENO, words.data(), words.size());
}

void end_at_signal(int number) {
  keep_input();
  std::signal(number, SIG_DFL);
  std::raise(number);
}

struct Options {
  std::string target;
  std::uint32_t mutants = 0;
  std::uint64_t seed = 1;
  fs::path seeds;
  std::vector<fs::path> paths;
};

Options options_of(const std::vector<std::string>& words) {
  Options options;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto value = [&] { return i + 1 < words.size() ? words[++i] : "0"; };
    if (words[i] == "--mutants") {
      options.mutants = static_cast<std::uint32_t>(std::stoul(value()));
    } else if (words[i] == "--seed") {
      options.seed = std::stoull(value());
    } else if (words[i] == "--seeds") {
      options.seeds = value();
    } else if (options.target.empty()) {
      options.target = words[i];
    } else {
      options.paths.emplace_back(words[i]);
    }
  }
  return options;
}

std::vector<std::string> inputs_at(const fs::path& path) {
  if (!fs::is_directory(path)) {
    return {read_file(path)};
  }
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(path)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> inputs;
  for (const fs::path& file : files) {
    inputs.push_back(read_file(file));
  }
  return inputs;
}

std::vector<std::string> seeds_of(const Target& target) {
  return target.seeds == nullptr ? std::vector<std::string>{} : target.seeds();
}

std::vector<std::string> own_inputs(const Target& target) {
  std::vector<std::string> inputs = seeds_of(target);
  for (const char* folder : {"corpus", "regressions"}) {
    const fs::path path = fs::path(LIMBER_SOURCE_DIR) / "fuzz" / folder / target.name;
    if (fs::exists(path)) {
      std::ranges::move(inputs_at(path), std::back_inserter(inputs));
    }
  }
  return inputs;
}

std::string run_guarded(const Target& target, std::string input) {
  current = std::move(input);
  alarm(kLongestS);
  std::string refusal = run(target, current);
  alarm(0);
  return refusal;
}

void guard(const std::string& target, const std::string& program) {
  kept_as = fs::current_path() / ("finding_" + target);
  how_to_run = fmt::format("\nfinding: {1} {2} {0}\n", kept_as, program, target);
  for (const int number : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGALRM}) {
    std::signal(number, end_at_signal);
  }
  if constexpr (LIMBER_FUZZ_SANITIZED == 0) {  // sanitizers take terabytes
    const rlimit most{kMostMemory, kMostMemory};
    setrlimit(RLIMIT_AS, &most);
  }
}

int write_seeds(const Target& target, const fs::path& folder) {
  const std::vector<std::string> seeds = seeds_of(target);
  fs::create_directories(folder);
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    write_file_atomically(folder / fmt::format("seed_{}", i), seeds[i]);
  }
  return 0;
}

int print_targets() {
  for (const Target& target : all_targets()) {
    fmt::print("{}\n", target.name);
  }
  return 0;
}

int replay(const Options& options, const std::string& program) {
  if (options.target.empty()) {
    return print_targets();
  }
  const Target target = target_named(options.target);
  if (!options.seeds.empty()) {
    return write_seeds(target, options.seeds);
  }
  guard(options.target, program);
  std::vector<std::string> inputs;
  for (const fs::path& path : options.paths) {
    std::ranges::move(inputs_at(path), std::back_inserter(inputs));
  }
  if (options.paths.empty()) {
    inputs = own_inputs(target);
  }
  std::size_t taken = 0;
  std::string refusal;
  for (const std::string& input : inputs) {
    refusal = run_guarded(target, input);
    taken += refusal.empty() ? 1 : 0;
  }
  if (inputs.size() == 1 && !refusal.empty()) {
    fmt::print("refused: {}\n", printable(refusal));
  }
  const std::vector<std::string> words = dictionary_words(source_file("fuzz/words.dict"));
  for (std::uint32_t i = 0; i < options.mutants && !inputs.empty(); ++i) {
    RandomStream random(options.seed, i);
    (void)run_guarded(target, mutant(inputs, words, random));
  }
  fmt::print("{}: {} inputs, {} of them taken, and {} mutants\n", options.target, inputs.size(),
             taken, options.mutants);
  return 0;
}

}  // namespace

}  // namespace limber::fuzz

int main(int count, char** arguments) {
  using namespace limber::fuzz;
  try {
    return replay(options_of({arguments + 1, arguments + count}), arguments[0]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    if (!kept_as.empty()) {
      keep_input();
    }
    return 1;
  }
}
