// SPDX-License-Identifier: GPL-3.0-or-later
#include "gradient/gradient_run.h"

#include <array>
#include <cstddef>
#include <fmt/format.h>
#include <string>
#include <utility>

#include "run/interrupt.h"
#include "run/parallel.h"
#include "text/results.h"

namespace truelux {
namespace {

constexpr std::size_t kBlockRows = 256;

constexpr std::array<char, 3> kChannels = {'r', 'g', 'b'};

/// Rows that are worked on together.
struct Block {
  std::vector<ReceiverRow> rows;
  std::vector<Receiver> receivers;
  std::vector<Derivatives> results;
  std::vector<VertexDerivatives> vertices;  ///< if asked for
};

/// False at the end and at a defect.
bool ReadBlock(ReceiverReader& reader, Block& block,
               std::vector<Diagnostic>& defects) {
  StopIfInterrupted();
  block.rows.clear();
  while (block.rows.size() < kBlockRows) {
    ReceiverRow row;
    if (reader.Next(row, defects) != ReceiverReader::Status::kRow) break;
    block.rows.push_back(std::move(row));
    if (!reader.HasBufferedBytes()) break;
  }
  return !block.rows.empty();
}

void FindFaces(const Scene& scene, Block& block, FoundFaces& found) {
  block.receivers.clear();
  for (const ReceiverRow& row : block.rows) {
    block.receivers.push_back(row.receiver);
    SetFace(scene, row.face, block.receivers.back(), found);
  }
}

/// "face 3 edge-on", "edges 1-2 and 7-8": by the numbers of faces, and of the
/// scene's vertices in the order of the file.
std::string CauseOf(const Kink& kink) {
  if (!kink.faces.empty()) {
    std::string text = kink.faces.size() == 1 ? "face" : "faces";
    for (const int face : kink.faces)
      text += fmt::format(" {}", face);
    return text + " edge-on";
  }
  const auto name = [](const std::array<int, 2>& edge) {
    return edge[0] < 0 ? std::string("a cut")
                       : fmt::format("edge {}-{}", edge[0] + 1, edge[1] + 1);
  };
  return name(kink.edges[0]) + " and " + name(kink.edges[1]);
}

void AppendKinks(std::string& text, std::uint64_t receiver,
                 const Derivatives& derivatives) {
  for (const Kink& kink : derivatives.kinks) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      if (kink.size[channel] == 0) continue;
      text += fmt::format("{},{}", receiver, kChannels[channel]);
      for (const double number :
           {kink.normal.x, kink.normal.y, kink.normal.z, kink.size[channel]}) {
        text += ',';
        AppendNumber(text, number);
      }
      text += ',' + CauseOf(kink) + '\n';
    }
  }
}

void AppendSlope(std::string& text, const VertexSlope& slope) {
  if (slope.IsSmooth()) {
    AppendNumber(text, slope.left);
    text += ",,";
    return;
  }
  const auto append = [&text](double number, bool jumps) {
    text += ',';
    if (jumps) {
      text += "jump";
    } else {
      AppendNumber(text, number);
    }
  };
  append(slope.left, slope.left_jumps);
  append(slope.right, slope.right_jumps);
}

/// One row for every number that is not 0 on both sides.
void AppendVertices(std::string& text, std::uint64_t receiver,
                    const VertexDerivatives& derivatives) {
  constexpr std::array<char, 3> kAxes = {'x', 'y', 'z'};
  for (const VertexDerivative& vertex : derivatives.vertices) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const VertexSlope& slope = vertex.slopes[channel][axis];
        if (slope.IsSmooth() && slope.left == 0) continue;
        text += fmt::format("{},{},{},{},", receiver, kChannels[channel],
                            vertex.number, kAxes[axis]);
        AppendSlope(text, slope);
        text += '\n';
      }
    }
  }
}

/// One row for every vertex.
std::string TextOf(const VertexGradient& sum) {
  std::string text = "vertex,x,y,z\n";
  for (std::size_t i = 0; i < sum.numbers().size(); ++i) {
    text += std::to_string(sum.numbers()[i]);
    const Vector3& value = sum.values()[i];
    for (const double x : {value.x, value.y, value.z}) {
      text += ',';
      AppendNumber(text, x);
    }
    text += '\n';
  }
  return text;
}

void Count(const Block& block, GradientSummary& summary) {
  for (std::size_t i = 0; i < block.results.size(); ++i) {
    const Derivatives& d = block.results[i];
    ++summary.receivers;
    if (d.irradiance.value != Rgb{}) ++summary.lit;
    if (d.smoothness == Smoothness::kKink) ++summary.kinks;
    if (d.smoothness == Smoothness::kDiscontinuous) ++summary.discontinuous;
    summary.undecided += static_cast<std::uint64_t>(d.undecided);
    summary.statistics += d.irradiance.statistics;
    summary.sample.Take(block.receivers[i]);
  }
}

}  // namespace

GradientSummary RunGradientTask(const Oracle& oracle, ReceiverReader& reader,
                                const GradientTask& task, Progress& progress) {
  GradientSummary summary;
  const char separator = reader.separator();
  const Method method = oracle.options().method;
  if (reader.has_header()) {
    task.table->Write(
        reader.header() +
        (task.shows_faces ? separator + std::string(kOnFaceFoundColumn) : "") +
        DerivativeHeader(task.columns, method, separator) + "\n");
  }
  if (task.kinks != nullptr)
    task.kinks->Write("receiver,channel,mx,my,mz,b,cause\n");
  if (task.vertices != nullptr)
    task.vertices->Write("receiver,channel,vertex,axis,value,left,right\n");
  const bool has_vertices =
      task.vertices != nullptr || task.vertex_gradient != nullptr;
  VertexGradient sum(oracle.scene());
  const DerivativeOptions options{
      .sphere = task.columns.HasSphere(),
      .jacobian = task.columns.Has(ColumnGroup::kJacobian)};
  Block block;
  while (ReadBlock(reader, block, summary.defects)) {
    FindFaces(oracle.scene(), block, summary.faces);
    block.results.resize(block.rows.size());
    block.vertices.resize(block.rows.size());
    ForEachInParallel(
        block.rows.size(), task.threads, progress, [&](std::size_t i) {
          const Receiver& receiver = block.receivers[i];
          block.results[i] = oracle.Derivatives(receiver, options);
          if (has_vertices)
            block.vertices[i] = oracle.VertexDerivatives(receiver);
        });
    std::string rows;
    std::string kinks;
    std::string vertices;
    for (std::size_t i = 0; i < block.rows.size(); ++i) {
      rows += block.rows[i].text;
      if (task.shows_faces)
        rows += separator + std::to_string(block.receivers[i].on_face);
      AppendDerivatives(rows, block.results[i], task.columns, method,
                        separator);
      rows += '\n';
      AppendKinks(kinks, summary.receivers + i + 1, block.results[i]);
      AppendVertices(vertices, summary.receivers + i + 1, block.vertices[i]);
      if (task.vertex_gradient != nullptr) {
        const std::vector<double>& w = block.rows[i].numbers;
        sum.Add(block.vertices[i], {w[0], w[1], w[2]});
      }
    }
    task.table->Write(rows);
    if (task.kinks != nullptr) task.kinks->Write(kinks);
    if (task.vertices != nullptr) task.vertices->Write(vertices);
    Count(block, summary);
    if (!summary.defects.empty()) break;
  }
  if (task.vertex_gradient != nullptr) {
    summary.one_sided = sum.one_sided();
    task.vertex_gradient->Write(TextOf(sum));
  }
  return summary;
}

}  // namespace truelux
