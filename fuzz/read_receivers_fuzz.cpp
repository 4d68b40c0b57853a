// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds the reader of receivers tables with any bytes. What it accepts must be
// a receiver, what it refuses needs a reason, and how the bytes arrive must not
// matter.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/scene.h"

#include "text/byte_source.h"
#include "text/face_choice.h"
#include "text/receivers.h"

namespace {

constexpr int kFaces = 7;

void Require(bool condition) {
  if (!condition) std::abort();
}

/// A text that comes in pieces of some bytes, as from a pipe.
class PiecewiseSource : public truelux::ByteSource {
 public:
  PiecewiseSource(std::string_view text, std::size_t piece)
      : rest_(text), piece_(piece) {}

  std::size_t Read(std::span<char> buffer) override {
    const std::size_t n =
        rest_.copy(buffer.data(), std::min(piece_, buffer.size()));
    rest_.remove_prefix(n);
    return n;
  }

 private:
  std::string_view rest_;
  std::size_t piece_;
};

void CheckReceiver(const truelux::Receiver& receiver) {
  const auto& [position, normal, on_face] = receiver;
  for (const double x :
       {position.x, position.y, position.z, normal.x, normal.y, normal.z}) {
    Require(std::isfinite(x));
  }
  Require(normal.x != 0 || normal.y != 0 || normal.z != 0);
  Require(on_face >= 0 && on_face <= kFaces);
}

void CheckDefects(const std::vector<truelux::Diagnostic>& defects) {
  Require(!defects.empty());
  for (const truelux::Diagnostic& defect : defects) {
    Require(defect.file == "t.csv");
    Require(!defect.message.empty());
  }
}

/// kFaces faces, of which some have a name.
truelux::Scene FuzzedScene() {
  truelux::SceneBuilder builder;
  for (int i = 0; i < kFaces; ++i) {
    if (i == 3) builder.SetGroup("wall");
    builder.AddFace({{0, 0, 1.0 * i}, {1, 0, 1.0 * i}, {0, 1, 1.0 * i}});
  }
  return *builder.Build().value;
}

/// The rows that a table has, and the texts of its defects, in their order.
std::vector<std::string> RowsOf(truelux::ByteSource& source) {
  using Status = truelux::ReceiverReader::Status;
  static const truelux::Scene scene = FuzzedScene();
  truelux::FaceWords faces(scene);
  truelux::FoundFaces found;
  truelux::ReceiverReader reader(source, "t.csv", faces);
  std::vector<std::string> rows;
  std::vector<truelux::Diagnostic> defects;
  const auto note_defects = [&] {
    CheckDefects(defects);
    for (const truelux::Diagnostic& defect : defects)
      rows.push_back(defect.Text());
    defects.clear();
  };
  if (!reader.ReadHeader(defects)) {
    note_defects();
    return rows;
  }
  truelux::ReceiverRow row;
  for (;;) {
    const Status status = reader.Next(row, defects);
    if (status == Status::kEnd) return rows;
    if (status == Status::kDefect) {
      note_defects();
      continue;
    }
    Require(defects.empty());
    truelux::SetFace(scene, row.face, row.receiver, found);
    CheckReceiver(row.receiver);
    rows.push_back(row.text);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  truelux::TextSource whole(bytes);
  const std::vector<std::string> rows = RowsOf(whole);
  for (const std::size_t piece : {std::size_t{1}, std::size_t{7}}) {
    PiecewiseSource source(bytes, piece);
    Require(RowsOf(source) == rows);
  }
  return 0;
}
