#include "subjects/process/channels.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <istream>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "subjects/process/npy.h"
#include "subjects/process/protocol.h"
#include "subjects/process/request_errors.h"

namespace rasterproof::subjects {
namespace {

template <class Table>
std::string_view WordOf(const Table& table, const typename Table::value_type::first_type& value) {
  return std::ranges::find(table, value, [](const auto& entry) { return entry.first; })->second;
}

// Reads a word of the table; returns whether it is one.
template <class Table, class T>
bool ReadWord(WordReader& words, const Table& table, T& value) {
  const auto* const found =
      std::ranges::find(table, words.Word(), [](const auto& entry) { return entry.second; });
  if (found == table.end()) return false;
  value = found->first;
  return true;
}

bool IsTheSame(const Channel& a, const Channel& b) {
  const std::size_t bytes = a.values.size() * sizeof(double);
  return a.name == b.name && a.interpolation == b.interpolation && a.at == b.at &&
         a.values.size() == b.values.size() &&
         (bytes == 0 || std::memcmp(a.values.data(), b.values.data(), bytes) == 0);
}

}  // namespace

bool HaveTheSameChannels(const Scene& a, const Scene& b) {
  return &a == &b || std::ranges::equal(a.channels, b.channels, IsTheSame);
}

void AddChannels(TextWriter& text, const std::vector<Channel>& channels, bool as_arrays) {
  for (const Channel& channel : channels) {
    text.Add(channel.name);
    text.Add(' ');
    text.Add(WordOf(kInterpolationNames, channel.interpolation));
    text.Add(' ');
    text.Add(WordOf(kEvaluatedAtNames, channel.at));
    const bool has_numbers = channel.interpolation != Interpolation::kInverseW;
    for (std::size_t n = 0; has_numbers && !as_arrays && n < channel.values.size(); ++n) {
      text.Add(' ');
      text.AddNumber(channel.values[n]);
    }
    text.Add('\n');
    if (has_numbers && as_arrays) text.Add(NpyOf(channel.values, 1));
  }
}

// The target with the vertices and channels that follow, or those of the request before.
std::shared_ptr<const Scene> RequestReader::SceneFor(Scene target, const Lists& lists) {
  const bool has_own_channels = lists.channels.value_or(0) != 0;
  if (!lists.vertices && last_ == nullptr) {
    Malformed("request " + std::to_string(lists.id),
              "vertices: there is no request before it to have the same");
  }
  if (!lists.channels && (lists.vertices || last_->channels.empty())) {
    Malformed("request " + std::to_string(lists.id),
              "channels=N: no request of these vertices before it had channels");
  }
  if (!lists.vertices && !has_own_channels && target.width == last_->width &&
      target.height == last_->height && target.clip_space == last_->clip_space) {
    return last_;
  }
  target.vertices = lists.vertices ? NextVertices(*lists.vertices, lists) : last_->vertices;
  if (has_own_channels) {
    for (std::size_t n = 0; n < *lists.channels; ++n)
      target.channels.push_back(NextChannel(n, target.vertices.size(), lists));
  } else if (!lists.vertices) {
    target.channels = last_->channels;
  }
  return std::make_shared<const Scene>(std::move(target));
}

Channel RequestReader::NextChannel(std::size_t index, std::size_t vertices, const Lists& lists) {
  std::string where = "request " + std::to_string(lists.id) + ", channel " + std::to_string(index);
  if (!std::getline(in_, line_)) line_.clear();
  WordReader words(line_);
  Channel channel;
  channel.name = words.Word();
  if (channel.name.empty() || !ReadWord(words, kInterpolationNames, channel.interpolation) ||
      !ReadWord(words, kEvaluatedAtNames, channel.at)) {
    Malformed(where, "NAME flat|linear|perspective|inverse-w sample|centre|centroid");
  }
  where += " (" + channel.name + ")";
  if (channel.interpolation == Interpolation::kInverseW) {
    if (!words.AtEnd()) Malformed(where, "no numbers: it is computed from w alone");
    return channel;
  }
  if (lists.as_arrays) {
    if (!words.AtEnd()) Malformed(where, "its numbers as an array after the line, as npy says");
    channel.values = OfArray(lists.id, "channel " + channel.name, [&] {
      return ReadNpyDoubles(vertices, 1, [&](std::size_t n) { return NextBytesOf(n); });
    });
    return channel;
  }
  double number = 0;
  while (!words.AtEnd() && channel.values.size() < vertices && words.Number(number))
    channel.values.push_back(number);
  if (channel.values.size() < vertices || !words.AtEnd())
    Malformed(where, std::to_string(vertices) + " numbers, one a vertex");
  return channel;
}

}  // namespace rasterproof::subjects
