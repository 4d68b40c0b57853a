// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds the reader of candidates with any bytes: irradiances, one column for
// all channels, form factors, gradients. Rows and values belong together, and what is
// refused needs a reason.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "truelux/scene.h"

#include "compare/candidates.h"
#include "text/byte_source.h"
#include "text/face_choice.h"

namespace {

void Require(bool condition) {
  if (!condition) std::abort();
}

truelux::Scene FuzzedScene() {
  truelux::SceneBuilder builder;
  builder.AddFace({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}});
  return *builder.Build().value;
}

void Read(std::string_view bytes, const truelux::CandidateRules& rules) {
  using Status = truelux::CandidateReader::Status;
  static const truelux::Scene scene = FuzzedScene();
  truelux::FaceWords faces(scene);
  truelux::TextSource source(bytes);
  truelux::CandidateReader reader(source, "t.csv", rules, faces);
  std::vector<truelux::Diagnostic> defects;
  if (!reader.ReadHeader(defects)) {
    Require(!defects.empty());
    return;
  }
  Require(!reader.channels().empty());
  const bool is_gradient = reader.quantity() == truelux::Quantity::kGradient;
  Require(reader.channels().size() * (is_gradient ? 3 : 1) ==
          reader.value_names().size());
  truelux::CandidateRow row;
  for (;;) {
    defects.clear();
    const Status status = reader.Next(row, defects);
    if (status == Status::kEnd) return;
    Require(defects.empty() == (status == Status::kRow));
    if (status != Status::kRow) continue;
    Require(row.line > 0 && std::isfinite(row.receiver.position.x));
    for (std::size_t c = reader.channels().size(); c < row.values.size(); ++c)
      Require(row.values[c] == 0 && row.gradient[c].x == 0);
    if (is_gradient) Require(row.values[0] == 0);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  Read(bytes, {});
  Read(bytes, {.is_grey = true});
  Read(bytes, {.channel = 1});
  Read(bytes, {.quantity = truelux::Quantity::kFormFactor});
  Read(bytes, {.quantity = truelux::Quantity::kGradient, .is_grey = true});
  return 0;
}
