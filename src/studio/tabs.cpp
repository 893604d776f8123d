#include "tabs.hpp"

#include "request_rules.hpp"

namespace limber {

namespace {

constexpr std::chrono::milliseconds kEventWait{200};  // how soon a closed page is noticed

}  // namespace

std::string Tabs::open() {
  const std::lock_guard lock(mutex_);
  if (tabs_.size() >= kMax) {
    return "";
  }
  const std::string id = make_token();
  auto tab = std::make_unique<Tab>(project_);
  tab->events().push("tab", nlohmann::json{{"id", id}}.dump());
  const std::lock_guard events_lock(events_mutex_);
  events_[id] = &tab->events();
  tabs_[id] = std::move(tab);
  return id;
}

void Tabs::close(const std::string& id) {
  decltype(tabs_)::node_type closed;  // joins its thread without the lock
  const std::lock_guard lock(mutex_);
  {
    const std::lock_guard events_lock(events_mutex_);
    events_.erase(id);
  }
  closed = tabs_.extract(id);
}

void Tabs::send_to_all(const std::string& kind, const std::string& json) {
  const std::lock_guard lock(events_mutex_);
  for (const auto& [id, events] : events_) {
    events->push(kind, json);
  }
}

/// Only its own stream closes a tab, so that it outlives this call.
std::string Tabs::pop_event(const std::string& id) {
  EventQueue* events = nullptr;
  with(id, [&](Tab& tab) { events = &tab.events(); });
  return events == nullptr ? "" : events->pop(kEventWait);
}

}  // namespace limber
