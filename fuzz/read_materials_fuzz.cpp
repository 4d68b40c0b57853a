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
  for (const double emission : material->emission)
    Require(std::isfinite(emission) && emission >= 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  truelux::MaterialLibrary materials;
  materials.Read(bytes, "t.mtl");
  truelux::StatementReader reader(bytes);
  while (const std::optional<truelux::Statement> statement = reader.Next()) {
    if (statement->keyword != "newmtl" || statement->rest.empty()) continue;
    CheckMaterial(materials.Find(std::string(statement->rest)));
  }
  // The same once more: every material is repeated with the same Ke.
  materials.Read(bytes, "again.mtl");
  materials.Report([](const std::string& name) { return !name.empty(); });
  Require(materials.diagnostics().size() == 2);
  for (const truelux::DiagnosticList& list : materials.diagnostics()) {
    for (const truelux::Diagnostic& diagnostic : list.Sorted())
      Require(!diagnostic.message.empty());
  }
  return 0;
}
