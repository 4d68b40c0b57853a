// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cmd_isolux.h"

#include <cstddef>
#include <deque>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "truelux/irradiance.h"
#include "truelux/isolux.h"
#include "truelux/isomesh.h"

#include "cli/isolux_request.h"
#include "cli/loading.h"
#include "cli/output_paths.h"
#include "isolux/extrema_run.h"
#include "isolux/isolux_run.h"
#include "isomesh/iso_mesh_run.h"
#include "plan/mesh_files.h"
#include "plan/mesh_notes.h"
#include "plan/plan_dxf.h"
#include "plan/plan_json.h"
#include "plan/plan_notes.h"
#include "plan/plan_objects.h"
#include "plan/plan_subject.h"
#include "plan/plan_svg.h"
#include "plan/plan_tables.h"
#include "run/interrupt.h"
#include "run/messages.h"
#include "run/output_file.h"
#include "run/user_error.h"
#include "run/watch.h"
#include "scene/emitters.h"
#include "scene/group_selection.h"

namespace truelux {
namespace {

/// The arguments of the search are options here.
template <class F>
auto ByOptions(const F& f) {
  try {
    return f();
  } catch (const std::invalid_argument& error) {
    throw UserError(std::string("--") + error.what());
  }
}

PlanSubject SubjectOf(const Scene& scene, const Isolux& isolux,
                      const IsoluxRequest& request) {
  PlanSubject subject;
  subject.scene = std::filesystem::path(request.scene.path).filename().string();
  subject.surface = request.surface;
  subject.channel =
      !request.wishes.channel && IsGrey(scene)
          ? "all"
          : Name(request.wishes.channel.value_or(ScalarChannel::kLuminance));
  subject.options = request.options;
  subject.vertex_numbers = VertexNumbers(scene);
  subject.objects =
      PlanObjectsOf(scene, GroupsNamed(scene, request.surface), isolux);
  return subject;
}

/// mesh: with its triangles if a file has them.
std::string FileText(PlanFormat format, const IsoMesh& mesh,
                     const PlanSubject& subject) {
  const Isolux& isolux = mesh.isolux;
  switch (format) {
    case PlanFormat::kCsv:
      break;
    case PlanFormat::kJson:
      return PlanJson(isolux, subject);
    case PlanFormat::kSvg:
      return PlanSvg(isolux, subject);
    case PlanFormat::kDxf:
      return PlanDxf(isolux);
    case PlanFormat::kObj:
      return MeshObj(mesh, subject);
    case PlanFormat::kPly:
      return MeshPly(mesh, subject);
    case PlanFormat::kVtu:
      return MeshVtu(mesh);
  }
  return ContourCsv(isolux);
}

/// What is asked for of it: the lines alone, contours without a mesh, or all.
IsoMesh Find(const Oracle& oracle, const IsoluxRequest& request) {
  IsoMesh found;
  if (request.has_mesh) {
    IsoMeshOptions wishes = request.mesh_wishes;
    wishes.contours = request.wishes;
    return FindIsoMesh(oracle, request.surface, wishes, UserAtTerminal());
  }
  if (request.has_contours) {
    found.isolux =
        FindIsolux(oracle, request.surface, request.wishes, UserAtTerminal());
  } else if (request.has_lines) {
    found.isolux.lines =
        FindSurfaceLines(oracle, request.surface, UserAtTerminal());
  }
  return found;
}

void PrintNotes(const IsoMesh& mesh, const IsoluxRequest& request) {
  const Isolux& isolux = mesh.isolux;
  Print(isolux.lines.notes);
  if (request.has_contours) {
    for (const std::string& note : PlanNotes(isolux))
      PrintNote(note);
    if (request.has_mesh) {
      for (const std::string& note : MeshNotes(mesh))
        PrintNote(note);
    }
    PrintNote(WorkNote(isolux));
  } else if (request.has_lines) {
    for (const std::string& note : LineNotes(isolux.lines))
      PrintNote(note);
  }
}

SurfaceExtrema FindExtrema(const Oracle& oracle, const IsoluxRequest& request) {
  ExtremaOptions wishes;
  wishes.channel = request.wishes.channel;
  wishes.threads = request.wishes.threads;
  SurfaceExtrema extrema =
      FindExtrema(oracle, request.surface, wishes, UserAtTerminal());
  // The same notes as of the contours, if there are some.
  if (!request.has_contours && !request.has_lines) Print(extrema.notes);
  for (const std::string& note : ExtremaNotes(extrema))
    PrintNote(note);
  return extrema;
}

}  // namespace

ExitStatus RunIsolux(const IsoluxArguments& arguments) {
  const IsoluxRequest request = ParseIsoluxRequest(arguments);
  CheckOutputs(request.outputs);
  // Opened before the long work, so that a bad path is known at once.
  std::deque<OutputFile> files;
  for (const OutputPath& output : request.outputs)
    files.emplace_back(output.path);

  const Oracle oracle(LoadScene(request.scene, request.outputs),
                      request.options);
  const IsoMesh mesh = ByOptions([&] { return Find(oracle, request); });
  PrintNotes(mesh, request);
  std::string extrema;
  if (request.has_extrema) {
    extrema =
        ExtremaCsv(ByOptions([&] { return FindExtrema(oracle, request); }));
  }

  const PlanSubject subject = SubjectOf(oracle.scene(), mesh.isolux, request);
  for (std::size_t i = 0; i < request.formats.size(); ++i) {
    StopIfInterrupted();
    files[i].Write(FileText(request.formats[i], mesh, subject));
  }
  std::size_t next = request.formats.size();
  if (request.has_lines) {
    files[next++].Write(
        SurfaceLineCsv(mesh.isolux.lines, subject.vertex_numbers));
  }
  if (request.has_extrema) files[next].Write(extrema);
  // Names are given at the very end, when nothing can fail but the naming.
  for (OutputFile& file : files)
    file.Finish();
  StopIfInterrupted();
  for (OutputFile& file : files)
    file.Commit();
  return ExitStatus::kDone;
}

}  // namespace truelux
