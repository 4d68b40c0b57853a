// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds the MTL reader with any bytes: each material that is named is there,
// and its emission can be used.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "scene/diagnostic_list.h"
#include "scene/io/material_library.h"
#include "scene/io/statement.h"

namespace {

void Require(bool condition) {
  if (!condition) std::abort();
}

void CheckMaterial(const truelux::Material* material) {
  Require(material != nullptr);
  Require(material->place.starts_with("t.mtl:"));
  for (const double emission : material->emission)
    Require(std::isfinite(emission) && emission >= 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  truelux::MaterialLibrary materials;
  truelux::DiagnosticList diagnostics("t.mtl");
  materials.Read(bytes, diagnostics);
  bool has_names = false;
  truelux::StatementReader reader(bytes);
  while (const std::optional<truelux::Statement> statement = reader.Next()) {
    if (statement->keyword != "newmtl" || statement->rest.empty()) continue;
    has_names = true;
    CheckMaterial(materials.Find(statement->rest));
  }
  for (const truelux::Diagnostic& diagnostic : diagnostics.Sorted())
    Require(!diagnostic.message.empty());
  // A second time each name is taken already.
  truelux::DiagnosticList again("t.mtl");
  materials.Read(bytes, again);
  Require(again.has_errors() || !has_names);
  return 0;
}
