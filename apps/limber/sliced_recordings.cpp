#include "sliced_recordings.hpp"

#include <iterator>
#include <utility>

#include "limber/data/recording_part.hpp"

namespace limber {

namespace {

using Place = OutlinedRecordings::Place;

/// The episodes at these of the places, whose numbers rise: file after file.
std::vector<Episode> read_at(const std::vector<Place>& places, std::span<const int> which,
                             EpisodeReader& reader) {
  std::vector<Episode> episodes;
  for (std::size_t first = 0; first < which.size();) {
    const std::string& path = places[static_cast<std::size_t>(which[first])].path;
    std::vector<int> numbers;
    for (; first < which.size(); ++first) {
      const Place& place = places[static_cast<std::size_t>(which[first])];
      if (place.path != path) {
        break;
      }
      numbers.push_back(place.number);
    }
    std::ranges::move(reader.read_part(path, numbers), std::back_inserter(episodes));
  }
  return episodes;
}

}  // namespace

OutlinedRecordings outline_recordings(const ArmDescription& arm,
                                      const std::vector<std::string>& paths) {
  OutlinedRecordings outlines;
  for (const std::string& path : paths) {
    Recording one = read_recording_outline(path);
    require_sizes_of(one, arm, path);
    add_arms_of(one, outlines.arms);
    for (int i = 0; i < static_cast<int>(one.episodes.size()); ++i) {
      outlines.places.push_back({path, i});
    }
    outlines.all.add(path, std::move(one.episodes));
  }
  return outlines;
}

EpisodeChoice choose_sliced(OutlinedRecordings outlines, double fraction, std::uint64_t seed,
                            EpisodeReader& reader) {
  for (std::size_t i = 0; i < outlines.places.size(); ++i) {
    if (outlines.places[i].number == 0) {
      reader.note_source(outlines.places[i].path);
    }
  }
  EpisodeChoice choice;
  TrainingData& data = choice.data;
  data = hold_back_arms(std::move(outlines.all.episodes), outlines.arms, fraction, seed);
  std::vector<Place> learnt;
  auto held = data.held_back.begin();
  for (int i = 0; i < static_cast<int>(outlines.places.size()); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (held != data.held_back.end() && *held == i) {
      choice.validation.push_back(outlines.all.names[at]);
      ++held;
    } else {
      learnt.push_back(outlines.places[at]);
    }
  }
  data.validation = read_at(outlines.places, data.held_back, reader);
  for (const Episode& outline : data.training) {
    data.slices.frame_counts.push_back(outline.frame_count());
  }
  data.training.clear();
  data.slices.read = [places = std::move(learnt), &reader](std::span<const int> which) {
    return read_at(places, which, reader);
  };
  return choice;
}

}  // namespace limber
