#include "limber/studio/studio.hpp"

#include <sys/socket.h>

#include <fmt/format.h>

#include "admission.hpp"
#include "answers.hpp"
#include "arm_requests.hpp"
#include "arm_station.hpp"
#include "connections.hpp"
#include "experiment_folder.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/version.hpp"
#include "limber/report/page_bytes.hpp"
#include "limber/report/scene_json.hpp"
#include "project_folder.hpp"
#include "scene_json.hpp"
#include "tabs.hpp"

namespace limber {

namespace {
using httplib::Request;
using httplib::Response;

constexpr double kMaxTimeLimitS = 60.0;
constexpr double kMaxE = 10.0;  // no arm of a family is so far from its middle

/// Only this machine's own program listens here: cpp-httplib would share the port with others.
void reuse_address(socket_t socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

SceneNames scene_of(const JsonReader& body) {
  return {body.at("arm").text(), body.at("model").text()};
}

std::uint64_t request_of(const JsonReader& body) {
  return body.at("request").count(kMaxRequest);
}

Eigen::VectorXf as_vector(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), Eigen::Index(numbers.size()))
      .cast<float>();
}

const char* media_type_of(std::string_view path) {
  const auto ends = [&](std::string_view ending) { return path.ends_with(ending); };
  return ends(".html")  ? "text/html; charset=utf-8"
         : ends(".js")  ? "text/javascript; charset=utf-8"
         : ends(".css") ? "text/css; charset=utf-8"
         : ends(".svg") ? "image/svg+xml"
                        : "text/plain; charset=utf-8";
}

}  // namespace

class Studio::Server {
 public:
  explicit Server(const StudioSettings& settings)
      : listen_(settings.listen),
        project_(settings.project),
        admission_(settings.listen),
        tabs_(project_),
        http_([this](const Request& request) { return admission_.shows_token(request); }) {
    if (!settings.arm.empty()) {
      first_arm_ = project_.give(ProjectItem::arm, settings.arm);
    }
    if (!settings.model.empty()) {
      first_model_ = project_.give(ProjectItem::model, settings.model);
    }
    bind(settings);
    admission_.set_port(port_);
    if (settings.driver) {
      driver_ = settings.driver;
      const auto send = [this](const std::string& kind, const std::string& json) {
        tabs_.send_to_all(kind, json);
      };
      station_.emplace(project_, first_arm_, *settings.driver, send);
    }
    add_rules();
    add_files();
    add_work();
    add_results();
    add_page();  // last: its pattern matches every path
  }

  int port() const { return port_; }
  const std::string& token() const { return admission_.token(); }
  std::string address() const {
    const bool is_v6 = listen_.find(':') != std::string::npos;
    return fmt::format("http://{}:{}/?token={}", is_v6 ? "[" + listen_ + "]" : listen_, port_,
                       token());
  }
  void serve() { http_.listen_after_bind(); }
  void stop() {
    stopping_ = true;
    http_.close_all();
  }

 private:
  void bind(const StudioSettings& settings) {
    refuse_if(listen_ == "0.0.0.0" || listen_ == "::" || listen_.empty(),
              "--listen '{}': expected one address or name of this machine, as browsers ask for it",
              listen_);
    http_.set_socket_options(reuse_address);
    port_ = settings.port;
    if (port_ == 0) {
      port_ = http_.bind_to_any_port(listen_);
    } else if (!http_.bind_to_port(listen_, port_)) {
      port_ = -1;
    }
    if (port_ <= 0) {
      throw InputError(
          settings.port == 0
              ? fmt::format("--listen {}: can't listen there; is it this machine's?", listen_)
              : fmt::format("can't listen at {} port {}: it is taken, or not this machine's; "
                            "--port 0 finds a free port",
                            listen_, settings.port));
    }
  }

  void add_rules() {
    http_.set_pre_routing_handler([this](const Request& request, Response& response) {
      response.set_header("Content-Security-Policy",
                          "default-src 'self'; img-src 'self' data:; frame-ancestors 'none'; "
                          "base-uri 'none'; form-action 'none'");
      response.set_header("X-Content-Type-Options", "nosniff");
      response.set_header("Referrer-Policy", "no-referrer");
      response.set_header("Cache-Control", "no-store");
      return admission_.admit(request, response);
    });
    // What nobody answered: a path with no such request.
    http_.set_error_handler([](const Request&, Response& response) {
      if (response.content_length_ == 0 && response.body.empty()) {
        refuse(response, response.status, "nothing is there");
      }
    });
    http_.set_exception_handler([](const Request&, Response& response, std::exception_ptr thrown) {
      try {
        std::rethrow_exception(thrown);
      } catch (const InputError& error) {
        refuse(response, kBadRequest, error.what());
      } catch (const std::exception& error) {
        refuse(response, kInternalError, error.what());
      }
    });
  }

  void add_page() {
    http_.Get(R"(/[\w.\-/]*)", [](const Request& request, Response& response) {
      const auto file = page_bytes().find(request.path == "/" ? "/index.html" : request.path);
      if (file == page_bytes().end()) {
        refuse(response, kNotFound, "nothing is there");
        return;
      }
      send(response, file->second, media_type_of(file->first));
    });
  }

  /// The folder's files.
  void add_files() {
    get("/api/project", [this](const Request&, Response& response) {
      answer(response, {{"version", version()},
                        {"folder", project_.folder().filename().string()},
                        {"arms", project_.names(ProjectItem::arm)},
                        {"models", project_.names(ProjectItem::model)},
                        {"families", project_.families()},
                        {"environments", project_.names(ProjectItem::environment)},
                        {"recordings", project_.names(ProjectItem::recording)},
                        {"plans", project_.names(ProjectItem::plan)},
                        {"first_arm", first_arm_},
                        {"first_model", first_model_},
                        {"driver", driver_ ? driver_->command : ""},
                        {"driver_arm", driver_ ? first_arm_ : ""},
                        {"driver_limit_scale", driver_ ? driver_->limit_scale : 1.0}});
    });
    get("/api/arm", [this](const Request& request, Response& response) {
      const ArmDescription arm = arm_named(request.get_param_value("name"));
      Json json = arm_to_json(arm);
      json["reach"] = reach_to_json(arm);
      answer(response, json);
    });
    get("/api/environment", [this](const Request& request, Response& response) {
      const ArmDescription arm = arm_named(request.get_param_value("arm"));
      answer(response,
             environment_to_json(load_environment(
                 project_.find(ProjectItem::environment, request.get_param_value("name")), arm)));
    });
    post("/api/environment", [this](const JsonReader& body, Response& response) {
      const ArmDescription arm = arm_named(body.at("arm").text());
      const Environment environment = environment_from_json(body.at("environment").value(), arm);
      save("environments", ".yaml", body, response, [&](const fs::path& path) {
        write_file_atomically(path, environment_to_yaml(environment));
      });
    });
    post("/api/plan/save", [this](const JsonReader& body, Response& response) {
      std::optional<FoundPlan> found;
      with_tab(body, response, [&](Tab& tab) {
        found = tab.found();
        require_done(why_not_shown(found, body), response);
      });
      if (response.status == -1) {
        save("plans", ".json", body, response,
             [&](const fs::path& path) { write_plan(path, found->plan); });
      }
    });
  }

  void add_work() {
    get("/api/events", [this](const Request&, Response& response) { stream_events(response); });
    post_job("/api/plan", [](const JsonReader& body) {
      PlanJob job;
      job.request = request_of(body);
      job.scene = scene_of(body);
      job.environment = body.at("environment").value();
      job.time_limit_s = body.at("time_limit_s").number(0.01, kMaxTimeLimitS);
      job.seed = body.at("seed").count(UINT32_MAX);
      job.with_tree = body.at("tree").boolean();
      job.limit_scale = body.at("limit_scale").number(kMinLimitScale, 1.0);
      if (const JsonReader margin = body.at("margin_m"); !margin.is_null()) {
        job.margin_m = margin.number();
      }
      return job;
    });
    post("/api/run", [this](const JsonReader& body, Response& response) {
      const RunJob job{request_of(body), body.at("replan").boolean(),
                       body.at("obstacle").boolean()};
      with_tab(body, response, [&](Tab& tab) {
        require_done(why_not_shown(tab.found(), body), response);
        if (response.status == -1) {
          tab.post(job);
        }
      });
    });
    post_job("/api/follow", [](const JsonReader& body) {
      return FollowJob{
          {request_of(body), scene_of(body)}, body.at("environment").value(), tip_path_in(body)};
    });
    post("/api/drive", [this](const JsonReader& body, Response& response) {
      const std::vector<double> kpa = body.at("setpoint_kpa").numbers(std::string::npos, "kPa");
      const bool restart = body.at("restart").boolean();
      const std::vector<double> e =
          body.at("e").numbers(std::string::npos, "standard deviations", -kMaxE, kMaxE);
      const DriveJob job{request_of(body), scene_of(body)};
      with_tab(body, response, [&](Tab& tab) {
        tab.target().set({as_vector(kpa), as_vector(e)});
        if (restart) {
          tab.post(job);
        }
      });
    });
    post("/api/stop", [this](const JsonReader& body, Response& response) {
      with_tab(body, response, [](Tab& tab) { tab.stop(); });
    });
    add_arm_requests(station_ ? &*station_ : nullptr, tabs_,
                     [this](const char* path, Post handle) { post(path, std::move(handle)); });
  }

  /// What was made before: experiments, models and recordings.
  void add_results() {
    get("/api/model", [this](const Request& request, Response& response) {
      answer(response, family_to_json(read_model(
                           project_.find(ProjectItem::model, request.get_param_value("name")))));
    });
    get("/api/experiment", [this](const Request&, Response& response) {
      const std::optional<ExperimentFolder> newest = ExperimentFolder::newest(project_);
      answer(response, {{"folder", newest ? newest->name() : ""},
                        {"rows", newest ? newest->rows() : Json::array()}});
    });
    post("/api/experiment/runs", [this](const JsonReader& body, Response& response) {
      const std::uint64_t row = body.at("row").count(ExperimentFolder::kMaxRows);
      answer(response, {{"runs", ExperimentFolder(project_, body.at("folder").text()).runs(row)}});
    });
    post_job("/api/plan/open", [](const JsonReader& body) {
      return OpenJob{{request_of(body), scene_of(body)}, body.at("plan").text()};
    });
    post_job("/api/fit", [](const JsonReader& body) {
      return FitJob{request_of(body), scene_of(body)};
    });
    post_job("/api/measure", [](const JsonReader& body) {
      return MeasureJob{{request_of(body), scene_of(body)}, body.at("recording").text()};
    });
  }

  void stream_events(Response& response) {
    const std::string id = tabs_.open();
    if (id.empty()) {
      refuse(
          response, kTooManyRequests,
          fmt::format("{} studio tabs are open: close one, then load this one again", Tabs::kMax));
      return;
    }
    if (station_) {
      station_->tell([&](const std::string& kind, const std::string& json) {
        tabs_.with(id, [&](Tab& tab) { tab.events().push(kind, json); });
      });
    }
    response.set_chunked_content_provider(
        "text/event-stream",
        [this, id](std::size_t, httplib::DataSink& sink) {
          const std::string event = tabs_.pop_event(id);
          // A beat shows each side whether the other one is there.
          const std::string piece = event.empty() ? "event: beat\ndata: {}\n\n" : event;
          return !stopping_ && sink.write(piece.data(), piece.size());
        },
        [this, id](bool) { tabs_.close(id); });
  }

  using Get = std::function<void(const Request&, Response&)>;
  void get(const char* path, Get handle) { http_.Get(path, std::move(handle)); }

  using Post = std::function<void(const JsonReader&, Response&)>;
  void post(const char* path, Post handle) {
    http_.Post(path, [handle = std::move(handle)](const Request& request, Response& response) {
      const nlohmann::json body = parse_json_object(request.body, "request");
      handle(JsonReader(body, "request"), response);
      if (response.status == -1) {
        answer(response, Json::object());
      }
    });
  }

  /// The job that `job_in` makes of the request is the tab's next one.
  template <class JobIn>
  void post_job(const char* path, JobIn job_in) {
    post(path, [this, job_in](const JsonReader& body, Response& response) {
      Job job = job_in(body);
      with_tab(body, response, [&](Tab& tab) { tab.post(std::move(job)); });
    });
  }

  template <class Use>
  void with_tab(const JsonReader& body, Response& response, Use&& use) {
    if (!tabs_.with(body.at("tab").text(), use)) {
      refuse(response, kConflict, "tab: this page has lost its connection; load it again");
    }
  }

  template <class Write>
  void save(const char* folder, const char* ending, const JsonReader& body, Response& response,
            Write&& write) {
    const fs::path path = project_.to_save(folder, body.at("name").text(), ending);
    if (fs::exists(path) && !body.at("overwrite").boolean()) {
      refuse(response, kIsThere, fmt::format("{} is there already", project_.name_of(path)));
      return;
    }
    refuse_to_overwrite(path, true);
    write(path);
    answer(response, {{"name", project_.name_of(path)}});
  }

  ArmDescription arm_named(const std::string& name) const {
    ArmDescription arm = load_arm(project_.find(ProjectItem::arm, name));
    require_planar(arm, "limber studio");
    return arm;
  }

  std::string listen_;
  ProjectFolder project_;
  Admission admission_;
  std::string first_arm_;
  std::string first_model_;
  int port_ = 0;
  std::optional<ProcessDriverSettings> driver_;  // none: no arm
  std::atomic<bool> stopping_ = false;
  Tabs tabs_;
  std::optional<ArmStation> station_;
  GuardedServer http_;
};

Studio::Studio(const StudioSettings& settings) : server_(std::make_unique<Server>(settings)) {}
Studio::~Studio() = default;
int Studio::port() const {
  return server_->port();
}
const std::string& Studio::token() const {
  return server_->token();
}
std::string Studio::address() const {
  return server_->address();
}
void Studio::serve() {
  server_->serve();
}
void Studio::stop() {
  server_->stop();
}

}  // namespace limber
