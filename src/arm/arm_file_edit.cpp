// An arm file with fitted numbers in place of its own: what people wrote beside them stays.
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/arm/characterisation.hpp"
#include "limber/common/error.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/yaml_reader.hpp"

namespace limber {

namespace {

/// So many bytes from `begin` on make way for `text`.
struct Edit {
  std::size_t begin = 0;
  std::size_t count = 0;
  std::string text;
};

/// Edits of the values in one mapping of a file.
class MappingEditor {
 public:
  MappingEditor(const std::string& yaml, const YAML::Node& mapping, std::vector<Edit>& edits)
      : yaml_(yaml), mapping_(mapping), edits_(edits) {}

  void set(const char* key, const std::string& text, double value) {
    const YAML::Node node = mapping_[key];
    if (!node) {
      add(key, text);
    } else if (!node.IsScalar() || node.as<double>() != value) {
      replace(node, text);
    }
  }

  void set(const char* key, const std::string& text) {
    const YAML::Node node = mapping_[key];
    if (node && node.Scalar() != text) {
      replace(node, text);
    }
  }

  /// @pre where the key is there, its value is a list of numbers
  void set(const char* key, const StrainPolynomial& numbers) {
    const double none = std::numeric_limits<double>::quiet_NaN();  // of what is no number
    set_list(key, fmt::format("[{}]", fmt::join(numbers, ", ")), [&](const YAML::Node& node) {
      return std::equal(node.begin(), node.end(), numbers.begin(), numbers.end(),
                        [&](const YAML::Node& a, double b) { return a.as<double>(none) == b; });
    });
  }

  /// Rows of numbers.
  void set(const char* key, const Eigen::MatrixXd& rows) {
    const auto lists = mapped<std::string>(
        rows.rowwise(), [&](const auto& row) { return fmt::format("[{}]", fmt::join(row, ", ")); });
    set_list(key, fmt::format("[{}]", fmt::join(lists, ", ")),
             [](const YAML::Node&) { return false; });
  }

  /// In front of the other keys: in braces, or on a line of its own.
  void add(const char* key, const std::string& text) {
    const auto begin = std::size_t(mapping_.Mark().pos);
    const bool braces = mapping_.Style() == YAML::EmitterStyle::Flow;
    const std::string indent(std::size_t(mapping_.Mark().column), ' ');
    edits_.push_back(
        {braces ? begin + 1 : begin, 0,
         fmt::format(fmt::runtime(braces ? "{}: {}, " : "{}: {}\n{}"), key, text, indent)});
  }

 private:
  /// @param same  whether a node has these numbers already
  template <class Same>
  void set_list(const char* key, const std::string& text, const Same& same) {
    const YAML::Node node = mapping_[key];
    if (!node) {
      add(key, text);
      return;
    }
    const auto begin = std::size_t(node.Mark().pos);
    std::size_t end = begin;
    for (int open = 0; end < yaml_.size(); ++end) {
      open += int(yaml_[end] == '[') - int(yaml_[end] == ']');
      if (open == 0) {
        break;
      }
    }
    if (yaml_[begin] == '[' && end < yaml_.size() && !same(node)) {
      edits_.push_back({begin, end + 1 - begin, text});
    }
  }

  void replace(const YAML::Node& node, const std::string& text) {
    edits_.push_back({std::size_t(node.Mark().pos), node.Scalar().size(), text});
  }

  const std::string& yaml_;
  const YAML::Node& mapping_;
  std::vector<Edit>& edits_;
};

std::vector<Edit> edits_of(const std::string& yaml, const ArmDescription& arm) {
  std::vector<Edit> edits;
  const YAML::Node root = YAML::Load(yaml);
  MappingEditor whole(yaml, root, edits);
  whole.set("no_load", to_string(arm.no_load));
  if (arm.no_load == NoLoadKind::fitted && !root["no_load"]) {
    whole.add("no_load", to_string(arm.no_load));
  }
  for (std::size_t i = 0; i < std::min(root["segments"].size(), arm.segments.size()); ++i) {
    const Segment& segment = arm.segments[i];
    const YAML::Node mapping = root["segments"][i];
    MappingEditor editor(yaml, mapping, edits);
    editor.set("length_m", fmt::format("{}", segment.length_m), segment.length_m);
    if (arm.no_load == NoLoadKind::strain_polynomial) {
      editor.set("strain_polynomial", segment.strain_polynomial);
    } else if (arm.no_load == NoLoadKind::curvature) {
      editor.set("curvature_per_unit", fmt::format("{}", segment.curvature_per_unit),
                 segment.curvature_per_unit);
    } else if (arm.no_load == NoLoadKind::fitted) {
      editor.set("shape_of_strains", segment.shape_of_strains);
    }
  }
  // From the end, so that earlier positions stay valid.
  std::ranges::stable_sort(edits, std::ranges::greater{}, &Edit::begin);
  return edits;
}

}  // namespace

std::string with_strain_polynomials(const std::string& yaml, const ArmDescription& arm) {
  read_arm(YamlReader::from_text(yaml, "the arm file"), PolynomialsOf::characterisation);
  std::string edited = yaml;
  for (const Edit& edit : edits_of(yaml, arm)) {
    if (edit.begin + edit.count <= edited.size()) {
      edited.replace(edit.begin, edit.count, edit.text);
    }
  }
  try {
    if (arm_to_yaml(read_arm(YamlReader::from_text(edited, "the edited arm"))) ==
        arm_to_yaml(arm)) {
      return edited;
    }
  } catch (const InputError&) {
    // The edit hit something else: shared anchors, a bracket in a comment.
  }
  return arm_to_yaml(arm);
}

}  // namespace limber
