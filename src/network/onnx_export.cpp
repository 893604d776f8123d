#include "limber/network/onnx_export.hpp"

#ifdef LIMBER_HAS_ONNX
#include <onnx/onnx_pb.h>
#endif

#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/arm/names.hpp"
#include "limber/common/aligned_floats.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/safetensors.hpp"
#include "limber/common/version.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/packed_network.hpp"
#include "model_tensors.hpp"

namespace limber {

#ifdef LIMBER_HAS_ONNX

namespace {

constexpr int kOperatorSet = 11;  // old enough for every runtime of the last years
constexpr int kIrVersion = 6;     // goes with it

/// The graph: nodes are appended in order, each reading what the one before it wrote.
class OnnxGraph {
 public:
  explicit OnnxGraph(onnx::GraphProto& graph) : graph_(graph) {}

  void input(const std::string& name, Eigen::Index size) {
    describe(*graph_.add_input(), name, size);
    last_ = name;
  }

  void output(const std::string& name, Eigen::Index size) {
    describe(*graph_.add_output(), name, size);
    last_node().set_output(0, name);
  }

  /// Element by element with a constant row.
  void combine(const char* operation, const std::string& name, const Eigen::VectorXf& values) {
    add_tensor(name, vector_tensor(values));
    apply(operation, name, {last_, name});
  }

  void layer(const std::string& name, const Layer& layer) {
    add_tensor(name + ".weight", matrix_tensor(layer.weight));
    add_tensor(name + ".bias", vector_tensor(layer.bias));
    apply("Gemm", name, {last_, name + ".weight", name + ".bias"});
    onnx::AttributeProto& transpose = *last_node().add_attribute();
    transpose.set_name("transB");
    transpose.set_type(onnx::AttributeProto::INT);
    transpose.set_i(1);
  }

  void relu(const std::string& name) { apply("Relu", name, {last_}); }

  /// Any operation on results, by their names; gives its own.
  std::string apply(const char* operation, const std::string& name,
                    const std::vector<std::string>& inputs) {
    onnx::NodeProto& node = *graph_.add_node();
    node.set_op_type(operation);
    node.set_name(name + "." + operation);
    for (const std::string& input : inputs) {
      node.add_input(input);
    }
    last_ = name + ".out";
    node.add_output(last_);
    return last_;
  }

  /// source·matrix + offset for each query.
  std::string linear(const std::string& name, const std::string& source,
                     const Eigen::MatrixXf& matrix, float offset = 0.0F) {
    last_ = source;
    layer(name, {matrix.transpose(), Eigen::VectorXf::Constant(matrix.cols(), offset)});
    return last_;
  }

  /// Of a result that was made before.
  std::string combined(const char* operation, const std::string& name, const std::string& source,
                       const Eigen::VectorXf& values) {
    last_ = source;
    combine(operation, name, values);
    return last_;
  }

 private:
  static void describe(onnx::ValueInfoProto& value, const std::string& name, Eigen::Index size) {
    value.set_name(name);
    onnx::TypeProto::Tensor& type = *value.mutable_type()->mutable_tensor_type();
    type.set_elem_type(onnx::TensorProto::FLOAT);
    type.mutable_shape()->add_dim()->set_dim_param("batch");
    type.mutable_shape()->add_dim()->set_dim_value(size);
  }

  onnx::NodeProto& last_node() { return *graph_.mutable_node(graph_.node_size() - 1); }

  void add_tensor(const std::string& name, const Tensor& numbers) {
    onnx::TensorProto& tensor = *graph_.add_initializer();
    tensor.set_name(name);
    tensor.set_data_type(onnx::TensorProto::FLOAT);
    for (const std::size_t extent : numbers.shape) {
      tensor.add_dims(std::int64_t(extent));
    }
    tensor.mutable_float_data()->Add(numbers.values.begin(), numbers.values.end());
  }

  onnx::GraphProto& graph_;
  std::string last_;
};

/// B_t itself, in the layout's numbers: (5) or (16) and then (20), behind query and answer. Plain
/// layers choose, chain and take apart, so that every runtime can do it.
class BoundedNext {
 public:
  BoundedNext(OnnxGraph& graph, const CompensationModel& model)
      : graph_(graph),
        model_(model),
        gap_(gap_size(model.dimension)),
        gaps_(model.point_count - 1),
        size_(model.output.scale.size()) {}

  void add() {
    const std::string next = composed();
    const bool in_space = model_.dimension == Dimension::space;
    const std::vector<std::string> names =
        in_space ? std::vector<std::string>{"x", "y", "z", "turn", "bend_y", "bend_z"}
                 : std::vector<std::string>{"x", "y", "turn"};
    auto parts = mapped<std::string>(gap_, [&](int part) {
      return graph_.linear("step." + names[std::size_t(part)], next, steps(part));
    });
    const GapBounds& bounds = *model_.bounds;
    const int turn = position_size(model_.dimension);
    const auto begin = parts.begin();
    scale("length", {begin, begin + turn}, bounds.min_length_m, bounds.max_length_m);
    parts[std::size_t(turn)] =
        clamped("bounds.turn", parts[std::size_t(turn)], bounds.min_turn_rad, bounds.max_turn_rad);
    if (in_space) {
      scale("bend", {begin + turn + 1, parts.end()}, Eigen::VectorXf::Zero(gaps_),
            bounds.max_bend_rad);
    }
    std::string sum;
    for (int part = 0; part < gap_; ++part) {
      const std::string& name = names[std::size_t(part)];
      const std::string place = placed("next." + name, parts[std::size_t(part)], part);
      sum = part == 0 ? place : graph_.apply("Add", "next.with." + name, {sum, place});
    }
    graph_.output("next", size_);
  }

 private:
  bool of_base() const { return model_.layout == BackboneLayout::base_poses; }

  /// Scales numbers of every gap so that their length as a vector is within bounds.
  void scale(const std::string& what, std::span<std::string> parts, const Eigen::VectorXf& low,
             const Eigen::VectorXf& high) {
    // Added to the length, which may be 0 of a bend; of any other it is below rounding.
    constexpr float kShortest = 1e-12F;
    std::string square;
    for (std::string& part : parts) {
      const std::string own = graph_.apply("Mul", part + "." + what, {part, part});
      square = square.empty() ? own : graph_.apply("Add", own + ".sum", {square, own});
    }
    const std::string length = graph_.apply("Sqrt", "step." + what, {square});
    const std::string kept = clamped("bounds." + what, length, low, high);
    const std::string divisor = graph_.combined("Add", "step." + what + ".divisor", length,
                                                Eigen::VectorXf::Constant(gaps_, kShortest));
    const std::string ratio = graph_.apply("Div", "step." + what + ".ratio", {kept, divisor});
    for (std::string& part : parts) {
      part = graph_.apply("Mul", part + ".kept", {part, ratio});
    }
  }

  /// Chooses `count` numbers from `first` on.
  static Eigen::MatrixXf chosen(Eigen::Index from, Eigen::Index first, Eigen::Index count) {
    Eigen::MatrixXf matrix = Eigen::MatrixXf::Zero(from, count);
    matrix.middleRows(first, count).setIdentity();
    return matrix;
  }

  /// B̃ as the query has it, spread over the gaps where a segment's stands for all of its own.
  Eigen::MatrixXf no_load() const {
    const Eigen::Index inputs = model_.input.scale.size();
    const Eigen::Index first = 2 * model_.command_size() + size_;
    if (of_base()) {
      return chosen(inputs, first, size_);
    }
    const ArmDescription arm = read_arm_keys(model_.arm_description, "the model's arm");
    Eigen::MatrixXf matrix = Eigen::MatrixXf::Zero(inputs, size_);
    for (int g = 0; g < gaps_; ++g) {
      matrix.block(first + gap_ * arm.segment_of_gap(g), gap_ * g, gap_, gap_).setIdentity();
    }
    return matrix;
  }

  std::string composed() {
    const Eigen::Index inputs = model_.input.scale.size();
    const std::string no_load_now = graph_.linear("no_load", "query", no_load());
    if (model_.form == OutputForm::compensation) {
      return graph_.apply("Add", "composed", {no_load_now, "answer"});
    }
    const std::string previous =
        graph_.linear("previous", "query", chosen(inputs, 2 * model_.command_size(), size_));
    const std::string change = graph_.linear("change", "answer", chosen(2 * size_, 0, size_));
    const std::string gate = graph_.apply(
        "Sigmoid", "gate", {graph_.linear("gates", "answer", chosen(2 * size_, size_, size_))});
    const std::string pull =
        graph_.apply("Mul", "pull", {gate, graph_.apply("Sub", "away", {no_load_now, previous})});
    return graph_.apply("Add", "composed",
                        {graph_.apply("Add", "moved", {previous, change}), pull});
  }

  /// Number `part` of every gap's pose, or of every plate's step from the one before it.
  Eigen::MatrixXf steps(int part) const {
    Eigen::MatrixXf matrix = Eigen::MatrixXf::Zero(size_, gaps_);
    for (int g = 0; g < gaps_; ++g) {
      matrix(gap_ * (of_base() ? g + 1 : g) + part, g) = 1.0F;
      if (of_base() && g > 0) {
        matrix(gap_ * g + part, g) = -1.0F;
      }
    }
    return matrix;
  }

  /// The inverse: numbers to their places, steps chained from the origin.
  std::string placed(const std::string& name, const std::string& source, int part) {
    Eigen::MatrixXf matrix = Eigen::MatrixXf::Zero(gaps_, size_);
    for (int g = 0; g < gaps_; ++g) {
      for (int to = g; to < (of_base() ? gaps_ : g + 1); ++to) {
        matrix(g, gap_ * (of_base() ? to + 1 : to) + part) = 1.0F;
      }
    }
    return graph_.linear(name, source, matrix);
  }

  /// high − relu((high − low) − relu(source − low)): Min and Max of constants are less well known.
  std::string clamped(const std::string& name, const std::string& source,
                      const Eigen::VectorXf& low, const Eigen::VectorXf& high) {
    const Eigen::VectorXf minus = Eigen::VectorXf::Constant(low.size(), -1.0F);
    std::string value = graph_.combined("Sub", name + ".above", source, low);
    value = graph_.apply("Relu", name + ".least", {value});
    value = graph_.combined("Mul", name + ".negated", value, minus);
    value = graph_.combined("Add", name + ".below", value, high - low);
    value = graph_.apply("Relu", name + ".most", {value});
    value = graph_.combined("Mul", name + ".negated_again", value, minus);
    return graph_.combined("Add", name + ".kept", value, high);
  }

  OnnxGraph& graph_;
  const CompensationModel& model_;
  int gap_;  ///< numbers of each; of planar base poses, those of a step from plate to plate
  int gaps_;
  Eigen::Index size_;
};

void add_metadata(onnx::ModelProto& file, const std::string& key, const std::string& value) {
  onnx::StringStringEntryProto& entry = *file.add_metadata_props();
  entry.set_key(key);
  entry.set_value(value);
}

}  // namespace

std::string onnx_version() {
  return fmt::format("IR {}, protobuf {}", int(onnx::IR_VERSION), GOOGLE_PROTOBUF_VERSION);
}

void write_onnx(const fs::path& path, const CompensationModel& model) {
  validate(model, path.string());
  require_one_arm(model, "ONNX");
  onnx::ModelProto file;
  file.set_ir_version(kIrVersion);
  file.set_producer_name("limber");
  file.set_producer_version(version());
  file.set_doc_string("compensation network of limber; docs/formats.md describes query and answer");
  file.add_opset_import()->set_version(kOperatorSet);
  add_metadata(file, "schema", "limber/onnx/1");
  add_metadata(file, "arm_name", model.arm_name);
  add_metadata(file, "arm_hash", model.arm_hash);
  add_metadata(file, "layout", to_string(model.layout));
  add_metadata(file, "output_form", to_string(model.form));
  add_metadata(file, "reads_velocity", model.reads_velocity ? "yes" : "no");
  add_metadata(file, "segment_count", std::to_string(model.segment_count));
  add_metadata(file, "point_count", std::to_string(model.point_count));
  if (model.dimension == Dimension::space) {
    add_metadata(file, "dimension", std::to_string(position_size(model.dimension)));
    add_metadata(file, "chamber_count", std::to_string(model.chamber_count));
    add_metadata(file, "past_commands", fmt::format("{}", fmt::join(model.past_commands, ",")));
  }
  add_metadata(file, "preset", model.preset);
  add_metadata(file, "learnt_from", commands_are(model.learnt_from_setpoints));
  file.mutable_graph()->set_name("compensation");
  OnnxGraph graph(*file.mutable_graph());
  graph.input("query", model.input.offset.size());
  graph.combine("Sub", "input.offset", model.input.offset);
  graph.combine("Mul", "input.scale", model.input.scale);
  for (std::size_t l = 0; l < model.layers.size(); ++l) {
    const std::string name = fmt::format("layers.{}", l);
    graph.layer(name, model.layers[l]);
    if (l + 1 < model.layers.size()) {
      graph.relu(name + ".relu");
    }
  }
  // Gate arguments, behind the changes, are not normalised.
  const Eigen::Index size = model.layers.back().bias.size();
  const Eigen::Index normalised = model.output.offset.size();
  Eigen::VectorXf scale = Eigen::VectorXf::Ones(size);
  Eigen::VectorXf offset = Eigen::VectorXf::Zero(size);
  scale.head(normalised) = model.output.scale;
  offset.head(normalised) = model.output.offset;
  graph.combine("Div", "output.scale", scale);
  graph.combine("Add", "output.offset", offset);
  graph.output("answer", size);
  if (model.bounds && !model.arm_description.empty()) {
    BoundedNext(graph, model).add();
  }
  write_file_atomically(path, file.SerializeAsString());
}

#else

std::string onnx_version() {
  return {};
}

void write_onnx(const fs::path& path, const CompensationModel&) {
  throw InputError(
      fmt::format("{}: this limber was built without ONNX; install libonnx-dev and "
                  "libprotobuf-dev, and build it again",
                  path.string()));
}

#endif

std::string reference_queries_csv(const CompensationModel& model, int count, std::uint64_t seed) {
  const PackedNetwork network(model, cpu_level());
  RandomStream random(seed, 0);
  std::string text;
  for (int i = 0; i < network.input_size(); ++i) {
    text += fmt::format("{}query_{}", i > 0 ? "," : "", i);
  }
  for (int i = 0; i < network.output_size(); ++i) {
    text += fmt::format(",answer_{}", i);
  }
  text += "\n";
  AlignedFloats query(std::size_t(network.input_size()));
  AlignedFloats scratch(std::size_t(2 * network.padded_width()));
  for (int k = 0; k < count; ++k) {
    for (int i = 0; i < network.input_size(); ++i) {
      query[i] = model.input.offset[i] + float(random.uniform(-1.0, 1.0)) / model.input.scale[i];
      text += fmt::format("{}{:.9g}", i > 0 ? "," : "", query[i]);
    }
    const float* answer = network.evaluate(query.data(), scratch.data());
    for (int i = 0; i < network.output_size(); ++i) {
      text += fmt::format(",{:.9g}", answer[i]);
    }
    text += "\n";
  }
  return text;
}

}  // namespace limber
