#include "limber/data/simple_model.hpp"

#include <cmath>
#include <span>

#include <gmock/gmock.h>

#include "limber/arm/no_load_model.hpp"
#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/data/recording_inspection.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

constexpr double kRate_hz = 20.0;
constexpr int kHoldFrames = 30;
constexpr double kRounding_m = 2e-6;  // single precision over a 0.7 m arm

/// Commands held for a second and a half each, nothing seen yet.
Episode commanded_episode(const ArmDescription& arm, int frames, std::uint64_t seed) {
  RandomStream random(seed, 0);
  Episode episode;
  episode.time_s = Eigen::VectorXd::LinSpaced(frames, 0.0, (frames - 1) / kRate_hz);
  episode.pressure_kpa.resize(frames, arm.segment_count());
  for (int t = 0; t < frames; ++t) {
    for (int i = 0; i < arm.segment_count(); ++i) {
      const double limit =
          arm.segments[static_cast<std::size_t>(i)].pressure_limit_kpa.largest_kpa();
      episode.pressure_kpa(t, i) = t % kHoldFrames == 0 ? float(random.uniform(-limit, limit))
                                                        : episode.pressure_kpa(t - 1, i);
    }
  }
  episode.setpoint_kpa = episode.pressure_kpa;
  episode.motion_index.assign(static_cast<std::size_t>(frames), 0);
  episode.backbone = FrameMatrix::Zero(frames, 3 * arm.point_count());
  return episode;
}

/// Episodes of an arm that is a simple model, seen with a little noise.
std::vector<Episode> episodes_of(const SimpleModel& model, const ArmDescription& arm, int count,
                                 double noise_m = 2e-4) {
  std::vector<Episode> episodes;
  for (int e = 0; e < count; ++e) {
    episodes.push_back(commanded_episode(arm, 400, static_cast<std::uint64_t>(e + 1)));
    RandomStream random(static_cast<std::uint64_t>(e + 1), 1);
    episodes.back().backbone = predict(model, arm, episodes.back());
    for (float& value : episodes.back().backbone.rightCols(3 * arm.point_count() - 3).reshaped()) {
      value += float(noise_m * random.normal());
    }
  }
  return episodes;
}

SimpleModel some_model() {
  return {{{0.8, 0.10, 1.03}, {1.2, -0.05, 0.98}, {0.6, 0.02, 1.0}}, 0.25};
}

TEST(SimpleModel, IsTheNoLoadModelWhereNothingIsFitted) {
  const ArmDescription arm = sample_arm(3);
  const Episode episode = commanded_episode(arm, 200, 1);
  const FrameMatrix expected = predict({{{}, {}, {}}, 0.0}, arm, episode);
  const NoLoadModel no_load(arm);
  Backbone backbone(arm.point_count(), 3);
  for (int t = 0; t < 200; t += 17) {
    no_load.backbone(Eigen::VectorXf(episode.pressure_kpa.row(t).transpose()), backbone);
    for (int p = 0; p < arm.point_count(); ++p) {
      EXPECT_NEAR((expected.row(t).segment<3>(3 * p) - backbone.row(p)).norm(), 0.0, kRounding_m);
    }
  }
}

TEST(SimpleModel, FollowsAStepByItsLag) {
  const ArmDescription arm = sample_arm(1);
  Episode episode = commanded_episode(arm, 60, 1);
  episode.pressure_kpa.setConstant(50.0F);
  episode.pressure_kpa.row(0).setZero();
  const Eigen::MatrixXd still = lagged_turns(arm, episode, 0.0);
  EXPECT_DOUBLE_EQ(still(1, 0), still(59, 0));
  ArmDescription straight = arm;
  straight.no_load = NoLoadKind::straight;
  const Eigen::MatrixXd late = lagged_turns(straight, episode, 0.5);
  for (int t = 1; t < 60; ++t) {
    EXPECT_NEAR(late(t, 0), 50.0 * (1.0 - std::exp(-t / kRate_hz / 0.5)), 1e-9);
  }
}

TEST(SimpleModelFit, FindsTheModelThatTheArmIs) {
  const ArmDescription arm = sample_arm(3);
  const SimpleModel truth = some_model();
  const SimpleFit fit = fit_simple_model(arm, episodes_of(truth, arm, 8));
  EXPECT_NEAR(fit.model.lag_s, truth.lag_s, 1e-9);
  for (std::size_t i = 0; i < truth.segments.size(); ++i) {
    EXPECT_NEAR(fit.model.segments[i].gain, truth.segments[i].gain, 0.005);
    EXPECT_NEAR(fit.model.segments[i].offset_rad, truth.segments[i].offset_rad, 0.005);
    EXPECT_NEAR(fit.model.segments[i].length_ratio, truth.segments[i].length_ratio, 0.01);
    EXPECT_LT(fit.segments[i].gain.low, fit.segments[i].gain.high);
    EXPECT_GT(fit.segments[i].correlation, 0.99);
    EXPECT_TRUE(fit.segments[i].moved);
  }
}

// A tenth of the frames are of another motion: least squares would be off by as much.
TEST(SimpleModelFit, IsHardlyMovedByABrokenEpisode) {
  const ArmDescription arm = sample_arm(3);
  const SimpleModel truth = some_model();
  std::vector<Episode> episodes = episodes_of(truth, arm, 10);
  episodes[4].backbone = episodes[5].backbone;
  const SimpleFit fit = fit_simple_model(arm, episodes);
  for (std::size_t i = 0; i < truth.segments.size(); ++i) {
    EXPECT_NEAR(fit.model.segments[i].gain, truth.segments[i].gain, 0.03 * truth.segments[i].gain);
  }
}

TEST(SimpleModelFit, LeavesWhatDidNotMoveAsTheArmFileHasIt) {
  const ArmDescription arm = sample_arm(3);
  std::vector<Episode> episodes = episodes_of(some_model(), arm, 4);
  RandomStream random(3, 0);
  const double noise = 0.004 * arm.limits_of_channel(1).half_width_kpa();
  for (Episode& episode : episodes) {
    for (Eigen::Index t = 0; t < episode.pressure_kpa.rows(); ++t) {  // a sensor's noise
      episode.pressure_kpa(t, 1) = float(10.0 + noise * random.normal());
    }
    episode.backbone = predict(some_model(), arm, episode);
  }
  const SimpleFit fit = fit_simple_model(arm, episodes);
  EXPECT_FALSE(fit.segments[1].moved);
  EXPECT_DOUBLE_EQ(fit.model.segments[1].gain, 1.0);
}

TEST(SimpleModelFit, NeedsNoNoLoadModel) {
  ArmDescription arm = sample_arm(2);
  arm.no_load = NoLoadKind::straight;
  const SimpleModel truth{{{0.012, 0.1, 1.0}, {-0.02, 0.0, 1.02}}, 0.1};
  const SimpleFit fit = fit_simple_model(arm, episodes_of(truth, arm, 6));
  EXPECT_NEAR(fit.model.segments[0].gain, 0.012, 1e-4);
  EXPECT_NEAR(fit.model.segments[1].gain, -0.02, 1e-4);
}

TEST(SimpleModelFit, RefusesWhatWasNeverSeen) {
  const ArmDescription arm = sample_arm(2);
  Episode episode = commanded_episode(arm, 50, 1);
  episode.tracked.assign(50, 0);
  EXPECT_THROW(fit_simple_model(arm, {episode}), InputError);
}

TEST(SimpleModelFit, SaysThatNoEpisodesWereGiven) {
  EXPECT_THAT([] { (void)fit_simple_model(sample_arm(2), {}); },
              ::testing::ThrowsMessage<InputError>(
                  ::testing::AllOf(::testing::HasSubstr("no episodes given; expected at least one"),
                                   ::testing::Not(::testing::HasSubstr("tracked")))));
}

// An arm file that says what the arm does leaves nothing to fit.
TEST(WithSimpleModel, AnArmOfTheFitNeedsNoFurtherFit) {
  const ArmDescription arm = sample_arm(3);
  const SimpleModel truth{{{0.8, 0.0, 1.03}, {1.2, 0.0, 0.98}, {0.6, 0.0, 1.0}}, 0.1};
  const std::vector<Episode> episodes = episodes_of(truth, arm, 8, 0.0);
  const ArmDescription fitted = fitted_arm(arm, fit_simple_model(arm, episodes), episodes);
  const SimpleFit again = fit_simple_model(fitted, episodes);
  for (const SimpleSegment& segment : again.model.segments) {
    EXPECT_NEAR(segment.gain, 1.0, 0.002);
    EXPECT_NEAR(segment.length_ratio, 1.0, 0.005);
  }
}

// An arm that gets longer under pressure: what the arm file calls its length is that at rest.
TEST(WithSimpleModel, ASegmentIsAsLongAsItIsAtRest) {
  const ArmDescription arm = sample_arm(2);
  std::vector<Episode> episodes = episodes_of({{{1.0, 0.0, 1.06}, {1.0, 0.0, 1.06}}, 0.0}, arm, 6);
  for (const Episode& rest : episodes_of({{{1.0, 0.0, 1.0}, {1.0, 0.0, 1.0}}, 0.0}, arm, 1)) {
    Episode vented = rest;
    vented.pressure_kpa.setZero();
    vented.setpoint_kpa.setZero();
    const FrameMatrix straight =
        predict(SimpleModel{{SimpleSegment{}, SimpleSegment{}}, 0.0}, arm, vented);
    vented.backbone = straight;
    episodes.push_back(vented);
  }
  const SimpleFit fit = fit_simple_model(arm, episodes);
  EXPECT_NEAR(fit.model.segments[0].length_ratio, 1.06, 0.01);
  const ArmDescription fitted = with_simple_model(arm, fit);
  for (std::size_t i = 0; i < arm.segments.size(); ++i) {
    EXPECT_NEAR(fitted.segments[i].length_m, arm.segments[i].length_m,
                0.002 * arm.segments[i].length_m);
  }
}

TEST(WithSimpleModel, GivesAStraightArmCurvatures) {
  ArmDescription arm = sample_arm(2);
  arm.no_load = NoLoadKind::straight;
  const SimpleModel truth{{{0.012, 0.0, 1.0}, {-0.02, 0.0, 1.0}}, 0.0};
  const ArmDescription fitted =
      with_simple_model(arm, fit_simple_model(arm, episodes_of(truth, arm, 6)));
  EXPECT_EQ(fitted.no_load, NoLoadKind::curvature);
  EXPECT_NEAR(fitted.segments[0].curvature_per_unit * fitted.segments[0].length_m, 0.012, 2e-4);
  EXPECT_NEAR(fitted.segments[1].curvature_per_unit * fitted.segments[1].length_m, -0.02, 2e-4);
}

TEST(WithSimpleModel, RefusesASegmentThatBendsToTheOtherSide) {
  const ArmDescription arm = sample_arm(2);
  const SimpleModel turned{{{0.8, 0.0, 1.0}, {-0.9, 0.0, 1.0}}, 0.0};
  EXPECT_THAT(
      [&] { (void)with_simple_model(arm, fit_simple_model(arm, episodes_of(turned, arm, 6))); },
      ::testing::ThrowsMessage<InputError>(::testing::AllOf(
          ::testing::HasSubstr("segment 1"), ::testing::HasSubstr("bends to the other side"))));
}

TEST(WithSimpleModel, PutsLinesWhereNothingWasCharacterised) {
  ArmDescription arm = sample_arm(2);
  arm.segments[1].strain_polynomial = {};
  const ArmDescription filled = with_lines_for_missing_polynomials(arm);
  EXPECT_EQ(filled.segments[0].strain_polynomial, arm.segments[0].strain_polynomial);
  EXPECT_NEAR(filled.segments[1].strain_polynomial[0], 0.002, 1e-12);
}

TEST(EpisodeErrors, FlagNothingWhereAllAreAlike) {
  const ArmDescription arm = sample_arm(3);
  const EpisodeErrors errors = episode_errors(arm, episodes_of(some_model(), arm, 40));
  EXPECT_THAT(errors.outliers(), ::testing::IsEmpty());
  EXPECT_EQ(to_text(errors), "");
  EXPECT_GT(errors.episodes[3].correlation, 0.98);
}

TEST(EpisodeErrors, NameTheBrokenOne) {
  const ArmDescription arm = sample_arm(3);
  std::vector<Episode> episodes = episodes_of(some_model(), arm, 40, 2e-3);
  episodes[17].backbone = episodes[18].backbone;  // the log of another trial
  const EpisodeErrors errors = episode_errors(arm, episodes);
  EXPECT_THAT(errors.outliers(), ::testing::ElementsAre(17));
  EXPECT_LT(errors.episodes[17].correlation, 0.6);
  EXPECT_GT(errors.episodes[17].tip_cm, errors.limit_cm);
  EXPECT_THAT(to_text(errors), ::testing::HasSubstr("episode 17"));
}

// Friction and long lags leave all episodes far off; an error alone does not stand out then.
TEST(EpisodeErrors, NameOneThatDoesNothingOfWhatItWasToldAmongLargeErrors) {
  const ArmDescription arm = sample_arm(3);
  std::vector<Episode> episodes = episodes_of(some_model(), arm, 40, 2e-3);
  for (Episode& rest : std::span(episodes).first(3)) {
    rest.pressure_kpa.rowwise() = Eigen::RowVectorXf(rest.pressure_kpa.row(0));
    rest.backbone = predict(some_model(), arm, rest);
  }
  episodes[17].backbone = episodes[18].backbone;
  for (std::size_t i = 3; i < episodes.size(); ++i) {
    FrameMatrix& backbone = episodes[i].backbone;
    backbone.col(backbone.cols() - 2).array() += 0.3F + 0.1F * std::sin(float(i));  // [m]
  }
  const EpisodeErrors errors = episode_errors(arm, episodes);
  EXPECT_LT(errors.episodes[17].tip_cm, errors.limit_cm);
  EXPECT_LT(errors.episodes[0].correlation, 0.4) << "it was told nothing, and does nothing";
  EXPECT_THAT(errors.outliers(), ::testing::ElementsAre(17));
}

// A tracker that was lost late: what was filled in then is a guess.
TEST(EpisodeErrors, FramesThatWereNotSeenAreNotComparedWithWhatWasTold) {
  constexpr int kSeen = 2 * kHoldFrames;
  const ArmDescription arm = sample_arm(3);
  std::vector<Episode> episodes = episodes_of(some_model(), arm, 40, 2e-3);
  const int lost = episodes[20].frame_count() - kSeen;
  Episode other = episodes[20];
  other.pressure_kpa *= -1.0F;
  episodes[20].backbone.bottomRows(lost) = predict(some_model(), arm, other).bottomRows(lost);
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    FrameMatrix& backbone = episodes[i].backbone;
    backbone.col(backbone.cols() - 2).array() += 0.3F + 0.1F * std::sin(float(i));  // [m]
  }
  EXPECT_THAT(episode_errors(arm, episodes).outliers(), ::testing::ElementsAre(20));
  episodes[20].tracked.assign(std::size_t(kSeen), 1);
  episodes[20].tracked.resize(std::size_t(kSeen + lost), 0);
  const EpisodeErrors errors = episode_errors(arm, episodes);
  EXPECT_THAT(errors.outliers(), ::testing::IsEmpty());
  EXPECT_GT(errors.episodes[20].correlation, 0.9);
  EXPECT_GT(errors.episodes[20].tip_cm, errors.median_cm);
  episodes[20].tracked.assign(std::size_t(kSeen + lost), 0);
  episodes[20].tracked[0] = 1;
  EXPECT_TRUE(std::isnan(episode_errors(arm, episodes).episodes[20].correlation));
}

// Logs that begin with rest: the errors of half of the episodes are next to none.
TEST(EpisodeErrors, OfEpisodesThatRestSayNothingOfWhatIsUsual) {
  const ArmDescription arm = sample_arm(3);
  std::vector<Episode> episodes = episodes_of(some_model(), arm, 40, 2e-3);
  for (std::size_t i = 0; i < episodes.size(); i += 2) {
    episodes[i].pressure_kpa.rowwise() = Eigen::RowVectorXf(episodes[i].pressure_kpa.row(0));
    episodes[i].backbone = predict(some_model(), arm, episodes[i]);
  }
  episodes[17].backbone = episodes[19].backbone;
  const EpisodeErrors errors = episode_errors(arm, episodes);
  EXPECT_FALSE(errors.episodes[0].moves);
  EXPECT_THAT(errors.outliers(), ::testing::ElementsAre(17));
  EXPECT_LT(errors.limit_cm, 3.0 * errors.median_cm);
  EXPECT_THAT(errors.episodes[17].why, ::testing::HasSubstr("cm at the tip, more than"));
  EXPECT_EQ(leave_out_broken(arm, episodes).outliers(), errors.outliers());
  EXPECT_EQ(episodes.size(), 39U);
}

// None of them errs by so much that the error alone would stand out.
TEST(EpisodeErrors, SayWhatALogMovesLike) {
  const ArmDescription arm = sample_arm(3);
  std::vector<Episode> episodes = episodes_of(some_model(), arm, 40, 2e-3);
  episodes[5].pressure_kpa.col(0).swap(episodes[5].pressure_kpa.col(2));
  episodes[9].pressure_kpa.col(1) *= -1.0F;
  constexpr int kLate = 30;  // frames, 1.5 s
  const FrameMatrix in_time = episodes[20].pressure_kpa;
  for (int t = 0; t < episodes[20].frame_count(); ++t) {
    episodes[20].pressure_kpa.row(t) = in_time.row(std::max(0, t - kLate));
  }
  const EpisodeErrors errors = episode_errors(arm, episodes);
  EXPECT_THAT(errors.outliers(), ::testing::ElementsAre(5, 9, 20));
  EXPECT_EQ(errors.episodes[5].why,
            "moves as if the columns of segment 0 and segment 2 were exchanged");
  EXPECT_EQ(errors.episodes[9].why, "moves as if segment 1's column had the other sign");
  EXPECT_EQ(errors.episodes[20].why, "moves as if its commands were logged about 1.5 s too late");
}

TEST(EpisodeErrors, NameTheLogThatAnEpisodeCameFrom) {
  const ArmDescription arm = sample_arm(3);
  std::vector<Episode> episodes = episodes_of(some_model(), arm, 40, 2e-3);
  episodes[17].backbone = episodes[18].backbone;
  episodes[17].log = "trial_17.csv";
  EXPECT_THAT(to_text(episode_errors(arm, episodes)),
              ::testing::StartsWith("episode 17 (trial_17.csv): "));
}

TEST(EpisodeErrors, FlagNoneOfTooFew) {
  const ArmDescription arm = sample_arm(3);
  std::vector<Episode> episodes = episodes_of(some_model(), arm, 4);
  episodes[1].backbone = episodes[2].backbone;
  EXPECT_THAT(episode_errors(arm, episodes).outliers(), ::testing::IsEmpty());
}

}  // namespace
}  // namespace limber
