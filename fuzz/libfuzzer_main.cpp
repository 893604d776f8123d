// clang's libFuzzer on one target, named by the first argument: limber_fuzz arm -runs=1000 corpus
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <utility>

#include "limber/common/error.hpp"
#include "target.hpp"

namespace {

constexpr const char* kVariable = "LIMBER_FUZZ_TARGET";  // for the processes that -merge starts

limber::fuzz::Target chosen{};

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  if (std::getenv(kVariable) == nullptr && *count > 1) {
    setenv(kVariable, (*arguments)[1], 1);
    std::swap((*arguments)[0], (*arguments)[1]);  // which libFuzzer takes no notice of
    ++*arguments;
    --*count;
  }
  const char* name = std::getenv(kVariable);
  try {
    chosen = limber::fuzz::target_named(name == nullptr ? "" : name);
  } catch (const limber::InputError& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    std::_Exit(2);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)limber::fuzz::run(chosen, {reinterpret_cast<const char*>(data), size});
  return 0;
}
