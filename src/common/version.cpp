#include "limber/common/version.hpp"

namespace limber {

const char* version() {
  return LIMBER_VERSION;
}

}  // namespace limber
