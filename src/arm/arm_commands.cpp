#include "limber/arm/arm_commands.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "arm_commands_file.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/yaml_reader.hpp"

namespace limber {

namespace {

constexpr std::size_t kMaxCommands = 256;
constexpr double kSmallestPivot = 1e-9;  // of the largest: below it, rows of S depend on each other

Eigen::MatrixXd shares_of(const std::vector<ArmCommand>& commands, int segments) {
  Eigen::MatrixXd shares(segments, Eigen::Index(commands.size()));
  for (std::size_t k = 0; k < commands.size(); ++k) {
    shares.col(Eigen::Index(k)) =
        Eigen::Map<const Eigen::VectorXd>(commands[k].shares.data(), segments);
  }
  return shares;
}

void require_size(const ArmDescription& arm, Eigen::Index found, Eigen::Index expected,
                  const char* what) {
  refuse_if(found != expected, "{} {}; arm '{}' has {}", found, what, arm.name, expected);
}

std::string read_name(const YamlReader& node, const std::vector<ArmCommand>& before) {
  const std::string name = node.text();
  if (name.empty() || name.starts_with('-') || name.find_first_of(",\"\n") != std::string::npos) {
    node.refuse(
        fmt::format("{} found; expected the name of a column in logs, without a sign, "
                    "commas or quotation marks",
                    node.found()));
  }
  if (std::ranges::any_of(before, [&](const ArmCommand& other) { return other.name == name; })) {
    node.refuse(fmt::format("'{}' is the name of another command", name));
  }
  return name;
}

/// What a channel moves.
const char* part_of(const ArmDescription& arm) {
  return arm.is_spatial() ? "chamber" : "segment";
}

/// The keys are channels, the values shares.
std::vector<double> read_shares(const YamlReader& node, const ArmDescription& arm) {
  const char* const part = part_of(arm);
  const int channels = arm.channel_count();
  std::vector<double> shares(channels, 0.0);
  for (const std::string& key : node.keys()) {
    int channel = 0;
    while (channel < channels && key != std::to_string(channel)) {
      ++channel;
    }
    if (channel == channels) {
      node.at(key).refuse(
          fmt::format("no {} '{}'; expected 0 to {}, the base first", part, key, channels - 1));
    }
    shares[std::size_t(channel)] =
        node.at(key).number(fmt::format("a share of the command in the {}'s, with sign", part));
  }
  if (std::ranges::all_of(shares, [](double share) { return share == 0.0; })) {
    node.refuse(fmt::format(
        "the command acts on nothing; expected {}s and shares, as in {{0: 1, 1: -0.5}}", part));
  }
  return shares;
}

void require_own_commands(const YamlReader& node, const std::vector<ArmCommand>& commands,
                          const ArmDescription& arm) {
  const int channels = arm.channel_count();
  const Eigen::MatrixXd shares = shares_of(commands, channels);
  for (int i = 0; i < channels; ++i) {
    if (shares.row(i).isZero(0.0)) {
      node.refuse(fmt::format("no command acts on {}; every {} has to be moved by one",
                              channel_name(arm, i), part_of(arm)));
    }
  }
  for (int i = 1; i < channels; ++i) {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> rows(shares.topRows(i + 1).transpose());
    rows.setThreshold(kSmallestPivot);
    if (rows.rank() <= i) {
      node.refuse(fmt::format(
          "{} {} can't move {} apart from the {}s before it. Where one command bends several "
          "discs, make them one segment with all their plates: its length is the sum of theirs",
          commands.size(), commands.size() == 1 ? "command" : "commands", channel_name(arm, i),
          part_of(arm)));
    }
  }
}

}  // namespace

std::vector<ArmCommand> read_arm_commands(const YamlReader& node, const ArmDescription& arm) {
  const std::vector<YamlReader> elements = node.elements();
  node.refuse_if(elements.empty() || elements.size() > kMaxCommands,
                 "{} commands found; expected 1 to {}, or no such key where each segment "
                 "has a command of its own",
                 elements.size(), kMaxCommands);
  std::vector<ArmCommand> commands;
  for (const YamlReader& element : elements) {
    element.refuse_unknown_keys({"name", "acts_on"});
    ArmCommand command;
    command.name = read_name(element.at("name"), commands);
    command.shares = read_shares(element.at("acts_on"), arm);
    commands.push_back(std::move(command));
  }
  require_own_commands(node, commands, arm);
  return commands;
}

std::string arm_commands_to_yaml(const std::vector<ArmCommand>& commands) {
  std::string text = commands.empty() ? "" : "commands:\n";
  for (const ArmCommand& command : commands) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < command.shares.size(); ++i) {
      if (command.shares[i] != 0.0) {
        parts.push_back(fmt::format("{}: {}", i, command.shares[i]));
      }
    }
    text += fmt::format("  - {{name: {}, acts_on: {{{}}}}}\n", yaml_text(command.name),
                        fmt::join(parts, ", "));
  }
  return text;
}

Eigen::MatrixXd command_shares(const ArmDescription& arm) {
  const int n = arm.channel_count();
  return arm.commands.empty() ? Eigen::MatrixXd(Eigen::MatrixXd::Identity(n, n))
                              : shares_of(arm.commands, n);
}

Eigen::VectorXd segment_commands(const ArmDescription& arm,
                                 const Eigen::Ref<const Eigen::VectorXd>& commands) {
  const Eigen::MatrixXd shares = command_shares(arm);
  require_size(arm, commands.size(), shares.cols(), "commands");
  return shares * commands;
}

Eigen::VectorXd commands_for(const ArmDescription& arm,
                             const Eigen::Ref<const Eigen::VectorXd>& segment_commands) {
  const Eigen::MatrixXd shares = command_shares(arm);
  require_size(arm, segment_commands.size(), shares.rows(), "commands of segments");
  const Eigen::MatrixXd square = shares * shares.transpose();
  return shares.transpose() * square.ldlt().solve(segment_commands);
}

std::string command_sum(const ArmDescription& arm, int segment) {
  std::string text;
  for (const ArmCommand& command : arm.commands) {
    const double share = command.shares[std::size_t(segment)];
    if (share == 0.0) {
      continue;
    }
    text += text.empty() ? (share < 0.0 ? "-" : "") : (share < 0.0 ? " - " : " + ");
    text += std::abs(share) == 1.0 ? "" : fmt::format("{:.4g} ", std::abs(share));
    text += command.name;
  }
  return text;
}

}  // namespace limber
