#include "asked_problem.hpp"

namespace limber {

const Certifier& AskedProblem::certifier() {
  if (!certifier_) {
    certifier_.emplace(problem_.arm,
                       problem_.model.has_network() ? &problem_.model.compensation() : nullptr,
                       problem_.model.valves().parameters(), problem_.environment);
  }
  return *certifier_;
}

const std::string& AskedProblem::environment_hash() {
  if (environment_hash_.empty()) {
    environment_hash_ = certifier_ ? certifier_->environment_hash()
                                   : limber::environment_hash(problem_.environment);
  }
  return environment_hash_;
}

}  // namespace limber
