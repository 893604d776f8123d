#include "limber/report/speed_report.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/json.hpp"
#include "limber/common/mapped.hpp"

namespace limber {

namespace {

constexpr double kMinShown = 100.0;  // queries/s: a bar's foot, below the paper's figures
constexpr double kMaxShown = 2e8;

Json to_json(const QueryRate& rate) {
  return {
      {"size", rate.batch_size}, {"threads", rate.threads}, {"queries_per_s", rate.queries_per_s}};
}

Json to_json(const std::vector<QueryRate>& rates) {
  return mapped<Json>(rates, [&](const QueryRate& rate) { return to_json(rate); });
}

Json to_json(const NetworkSpeed& speed) {
  Json batch = to_json(speed.batch);
  batch["fraction_of_fma_peak"] = speed.fraction_of_fma_peak;
  return {{"layout", speed.shape},
          {"backbone_layout", speed.layout},
          {"single", {{"queries_per_s", speed.single.queries_per_s}}},
          {"batch", batch},
          {"batches", to_json(speed.batches)}};
}

std::string line(const std::string& what, const QueryRate& rate) {
  return fmt::format("{:<34} {:>6} {:>8} {:>13.0f} {:>9.0f}\n", what, rate.batch_size, rate.threads,
                     rate.queries_per_s, 1e9 / rate.queries_per_s);
}

std::string network_lines(const std::string& name, const NetworkSpeed& speed) {
  std::string text = line(name + " " + speed.shape, speed.single);
  for (const QueryRate& rate : speed.batches) {
    if (rate.batch_size > 1) {
      text += line("", rate);
    }
  }
  return text;
}

// Largest and smallest lead over a peer, over the batch sizes that both were measured at.
std::string lead_over(const PeerSpeed& peer, const NetworkSpeed& network) {
  double min_lead = 1e30;
  double max_lead = 0.0;
  for (std::size_t i = 0; i < peer.batches.size() && i < network.batches.size(); ++i) {
    const double lead = network.batches[i].queries_per_s / peer.batches[i].queries_per_s;
    min_lead = std::min(min_lead, lead);
    max_lead = std::max(max_lead, lead);
  }
  return fmt::format("{:.1f} to {:.1f} times as fast as {}, {:.1f} times for single queries\n",
                     min_lead, max_lead, peer.name,
                     network.single.queries_per_s / peer.single.queries_per_s);
}

}  // namespace

Json to_json(const SpeedReport& report) {
  Json json = {{"cpu", report.cpu},
               {"cpu_level", report.cpu_level},
               {"threads", report.threads},
               {"queries", report.queries},
               {"clock_ghz", report.clock_ghz},
               {"fma_peak_gmac_per_s", report.fma_peak_gmac_per_s},
               {"fma_peak_difference", report.fma_peak_difference},
               {"no_load",
                {{"single", {{"queries_per_s", report.no_load_single.queries_per_s}}},
                 {"batch", to_json(report.no_load_batch)}}},
               {"network", to_json(report.paper_shape)},
               {"peers", Json::array()}};
  if (!report.model.empty()) {
    json["model"] = to_json(report.model.front());
  }
  for (const PeerSpeed& peer : report.peers) {
    json["peers"].push_back({{"name", peer.name},
                             {"single", {{"queries_per_s", peer.single.queries_per_s}}},
                             {"batches", to_json(peer.batches)}});
  }
  json["paper"] = {{"no_load", {{"queries_per_s", kPaperNoLoadQueriesPerS}}},
                   {"network", {{"queries_per_s", kPaperNetworkQueriesPerS}}}};
  return json;
}

std::string to_text(const SpeedReport& report) {
  std::string text = fmt::format("{}, {} kernels, {} queries a measurement\n\n", report.cpu,
                                 report.cpu_level, report.queries);
  text += fmt::format("{:<34} {:>6} {:>8} {:>13} {:>9}\n", "", "batch", "threads", "queries/s",
                      "ns/query");
  text += line("no load", report.no_load_single);
  text += line("", report.no_load_batch);
  text += network_lines("network", report.paper_shape);
  for (const NetworkSpeed& model : report.model) {
    text += network_lines("model", model);
  }
  for (const PeerSpeed& peer : report.peers) {
    text += line("peer: " + peer.name, peer.single);
    for (std::size_t i = 1; i < peer.batches.size(); ++i) {
      text += line("", peer.batches[i]);
    }
  }
  text += line("paper: no load", {1, 1, kPaperNoLoadQueriesPerS});
  text += line("paper: network", {1, 1, kPaperNetworkQueriesPerS});
  text += fmt::format(
      "\nFMA peak of one core {:.1f} GMAC/s = {:.2f} GHz × {} lanes × {:.2f} units ({:.1f} % apart "
      "before and after); the hidden layers reach {:.1f} % of it\n",
      report.fma_peak_gmac_per_s, report.clock_ghz, report.lanes,
      report.fma_peak_gmac_per_s / (report.clock_ghz * report.lanes),
      100.0 * report.fma_peak_difference, 100.0 * report.paper_shape.fraction_of_fma_peak);
  for (const PeerSpeed& peer : report.peers) {
    text += lead_over(peer, report.paper_shape);
  }
  return text;
}

Chart speed_chart(const SpeedReport& report) {
  std::vector<std::string> names;
  std::vector<double> single, batch;
  const auto group = [&](std::string name, const QueryRate& one, const QueryRate& many) {
    names.push_back(std::move(name));
    single.push_back(one.queries_per_s);
    batch.push_back(many.queries_per_s);
  };
  const QueryRate none{1, 1, kMinShown};  // the paper asks one query at a time
  group("no load: the paper", {1, 1, kPaperNoLoadQueriesPerS}, none);
  group("limber", report.no_load_single, report.no_load_batch);
  group("network: the paper", {1, 1, kPaperNetworkQueriesPerS}, none);
  for (const PeerSpeed& peer : report.peers) {
    group(peer.name, peer.single, fastest_batch(peer.batches));
  }
  group("limber", report.paper_shape.single, report.paper_shape.batch);
  for (const NetworkSpeed& model : report.model) {
    group("limber, " + model.shape, model.single, model.batch);
  }
  Chart chart("Forward model queries per second");
  chart.y_axis("queries per second").logarithmic_y().y_range(kMinShown, kMaxShown);
  chart.size_px(860, 440);
  chart.bars(names, "one query", single).bars(names, "batch", batch);
  chart.note(report.cpu + ", one core; the paper's figures as printed there");
  return chart;
}

}  // namespace limber
