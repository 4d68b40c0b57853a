// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/evaluation.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>
#include <string>
#include <utility>

#include "run/interrupt.h"
#include "run/parallel.h"
#include "text/results.h"

namespace truelux {
namespace {

/// A block ends at one of these sizes, whichever comes first.
constexpr std::size_t kBlockRows = 256;
constexpr std::size_t kBlockBytes = std::size_t{1} << 20;

/// Consecutive rows on their way through the pipeline.
struct Block {
  std::vector<CsvRecord> records;  ///< as they were read; the first row_count
  bool is_parsed = false;
  std::size_t row_count = 0;        ///< before the first defect
  std::vector<Receiver> receivers;  ///< of the rows
  std::vector<Irradiance> results;
  EvaluationCounts counts;          ///< of the rows
  std::string text;                 ///< the rows with their results
  std::vector<Diagnostic> defects;  ///< of the row after them
};

bool IsInfinite(const Irradiance& irradiance) {
  return std::any_of(irradiance.value.begin(), irradiance.value.end(),
                     [](double value) { return std::isinf(value); });
}

bool HasNoNumber(const Irradiance& irradiance) {
  return std::any_of(irradiance.value.begin(), irradiance.value.end(),
                     [](double value) { return std::isnan(value); });
}

/// Reads what the fields of the rows say, up to the first defect.
void ParseRows(const ReceiverReader& reader, const Scene& scene, Block& block) {
  block.is_parsed = true;
  block.receivers.clear();
  std::vector<Diagnostic> defects;
  for (std::size_t i = 0; i < block.row_count; ++i) {
    const auto fields = reader.Parse(block.records[i], defects);
    if (!fields) {
      block.row_count = i;
      block.defects = std::move(defects);
      return;
    }
    block.receivers.push_back(fields->receiver);
    SetFace(scene, fields->face, block.receivers.back(), block.counts.faces);
  }
}

/// First stage, serial: the next rows, of which only the ends are sought.
///
/// The blocks are owned here and used in turn, because a pipeline that is
/// stopped by an exception drops what it holds. No more than block_count are
/// on their way at once and they leave in order, so that a block is free again
/// when its turn comes.
class BlockReader {
 public:
  BlockReader(ReceiverReader& reader, const Scene& scene,
              std::size_t block_count)
      : reader_(reader), scene_(scene), blocks_(block_count) {}

  /// Null at the end, after a defect and after Stop.
  Block* Next() {
    StopIfInterrupted();
    Block& block = blocks_[turn_++ % blocks_.size()];
    block.is_parsed = false;
    block.row_count = 0;
    block.counts = {};
    block.text.clear();
    block.defects.clear();
    std::size_t bytes = 0;
    while (!ended_) {
      if (block.row_count == block.records.size()) block.records.emplace_back();
      CsvRecord& record = block.records[block.row_count];
      // Only ever set: another thread may have set it meanwhile.
      if (reader_.NextRecord(record, block.defects) !=
          ReceiverReader::Status::kRow) {
        ended_ = true;
        break;
      }
      bytes += record.text().size();
      ++block.row_count;
      // Rather a small block than to keep rows waiting for others that a pipe
      // may bring later; and none is waited for after a defect.
      if (!reader_.HasBufferedBytes()) {
        ParseRows(reader_, scene_, block);
        if (!block.defects.empty()) ended_ = true;
        break;
      }
      if (block.row_count == kBlockRows || bytes >= kBlockBytes) break;
    }
    return block.row_count == 0 && block.defects.empty() ? nullptr : &block;
  }

  /// Ends the reading. May be called by another thread.
  void Stop() { ended_ = true; }

 private:
  ReceiverReader& reader_;
  const Scene& scene_;
  std::vector<Block> blocks_;
  std::size_t turn_ = 0;
  std::atomic<bool> ended_ = false;
};

void CountBehindFaces(const Scene& scene, Block& block) {
  for (std::size_t i = 0; i < block.receivers.size(); ++i) {
    const Receiver& receiver = block.receivers[i];
    const bool is_behind = block.results[i].value == Rgb{} &&
                           receiver.on_face == 0 &&
                           scene.IsBehindFace(receiver);
    if (is_behind) ++block.counts.behind_faces;
  }
}

std::string FaceHeader(char separator) {
  return separator + std::string(kOnFaceFoundColumn);
}

/// Appends the field of on_face_found.
void AppendFace(std::string& text, int face, char separator) {
  text += separator;
  if (face > 0) {
    text += std::to_string(face);
  } else if (separator == ' ') {
    text += "\"\"";  // between blanks nothing is no field
  }
}

/// Second stage, parallel between blocks and within one: what the rows say, and
/// their results.
void EvaluateBlock(const Oracle& oracle, const ReceiverReader& reader,
                   bool shows_faces, Block& block, Progress& progress) {
  const char separator = reader.separator();
  if (!block.is_parsed) ParseRows(reader, oracle.scene(), block);
  block.counts.receivers = block.row_count;
  block.results.resize(block.row_count);
  // Isolated: a thread that waits for the rest of its block must not take up
  // the first stage meanwhile and wait there for input.
  tbb::this_task_arena::isolate([&] {
    EvaluateShares(oracle, block.receivers, progress,
                   [&](std::size_t i, const Irradiance& irradiance) {
                     block.results[i] = irradiance;
                   });
  });
  CountBehindFaces(oracle.scene(), block);
  for (const Irradiance& irradiance : block.results) {
    if (irradiance.value != Rgb{}) ++block.counts.lit;
    if (IsInfinite(irradiance)) ++block.counts.overflowing;
    if (HasNoNumber(irradiance)) ++block.counts.unanswered;
  }
  for (std::size_t i = 0; i < block.row_count; ++i) {
    block.text += block.records[i].text();
    if (shows_faces)
      AppendFace(block.text, block.receivers[i].on_face, separator);
    AppendResult(block.text, block.results[i], oracle.options().method,
                 separator);
    block.text += '\n';
  }
}

/// Third stage, serial and in order. What comes after a defect is not written.
void WriteBlock(Block& block, RowSink& sink, EvaluationSummary& summary,
                BlockReader& reader) {
  if (!summary.defects.empty()) return;
  if (block.row_count > 0) sink.Take(block.text, block.counts);
  summary += block.counts;
  for (const Irradiance& irradiance : block.results)
    summary.statistics += irradiance.statistics;
  for (const Receiver& receiver : block.receivers)
    summary.sample.Take(receiver);
  if (block.defects.empty()) return;
  summary.defects = std::move(block.defects);
  reader.Stop();
}

/// Passes over what an earlier run has done.
void SkipRows(ReceiverReader& reader, Progress& progress,
              EvaluationSummary& summary) {
  ReceiverRow row;
  for (std::uint64_t i = 0; i < summary.receivers; ++i) {
    StopIfInterrupted();
    const auto status = reader.Next(row, summary.defects);
    if (status != ReceiverReader::Status::kRow) return;
    summary.sample.Take(row.receiver);
    progress.Advance();
  }
}

}  // namespace

EvaluationCounts& EvaluationCounts::operator+=(const EvaluationCounts& other) {
  receivers += other.receivers;
  lit += other.lit;
  overflowing += other.overflowing;
  unanswered += other.unanswered;
  behind_faces += other.behind_faces;
  faces += other.faces;
  return *this;
}

EvaluationSummary Evaluate(const Oracle& oracle, ReceiverReader& reader,
                           RowSink& sink, const EvaluationTask& task,
                           Progress& progress) {
  EvaluationSummary summary;
  if (task.done) {
    static_cast<EvaluationCounts&>(summary) = *task.done;
    SkipRows(reader, progress, summary);
    if (!summary.defects.empty()) return summary;
  } else if (reader.has_header()) {
    sink.Take(reader.header() +
                  (task.shows_faces ? FaceHeader(reader.separator()) : "") +
                  ResultHeader(oracle.options().method, reader.separator()) +
                  "\n",
              {});
  }
  const std::size_t block_count = 2 * static_cast<std::size_t>(task.threads);
  BlockReader blocks(reader, oracle.scene(), block_count);
  const auto read = [&blocks](tbb::flow_control& control) {
    Block* block = blocks.Next();
    if (block == nullptr) control.stop();
    return block;
  };
  const auto evaluate = [&](Block* block) {
    EvaluateBlock(oracle, reader, task.shows_faces, *block, progress);
    return block;
  };
  const auto write = [&](Block* block) {
    WriteBlock(*block, sink, summary, blocks);
  };
  WithThreads(task.threads, [&] {
    tbb::parallel_pipeline(block_count,
                           tbb::make_filter<void, Block*>(
                               tbb::filter_mode::serial_in_order, read) &
                               tbb::make_filter<Block*, Block*>(
                                   tbb::filter_mode::parallel, evaluate) &
                               tbb::make_filter<Block*, void>(
                                   tbb::filter_mode::serial_in_order, write));
  });
  return summary;
}

}  // namespace truelux
