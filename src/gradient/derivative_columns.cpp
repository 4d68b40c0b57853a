// SPDX-License-Identifier: GPL-3.0-or-later
#include "gradient/derivative_columns.h"

#include <cstddef>
#include <vector>

#include "text/results.h"

namespace truelux {
namespace {

constexpr std::array<char, 3> kChannels = {'r', 'g', 'b'};
constexpr std::array<char, 3> kAxes = {'x', 'y', 'z'};

/// The names of one group's columns of one channel, and in the same order their
/// values.
std::vector<std::string> NamesOf(ColumnGroup group, char channel) {
  std::vector<std::string> names;
  const auto vector = [&](const std::string& name) {
    for (const char axis : kAxes)
      names.push_back(name + '_' + channel + '_' + axis);
  };
  const auto matrix = [&](const std::string& name) {
    for (const char row : kAxes) {
      for (const char column : kAxes)
        names.push_back(name + '_' + channel + '_' + row + column);
    }
  };
  switch (group) {
    case ColumnGroup::kGradient:
      vector("grad");
      break;
    case ColumnGroup::kTangential:
      vector("tgrad");
      break;
    case ColumnGroup::kNormal:
      vector("dn");
      break;
    case ColumnGroup::kVector:
      vector("V");
      break;
    case ColumnGroup::kJacobian:
      matrix("J");
      matrix("Jsphere");
      break;
    case ColumnGroup::kSphere:
      vector("L");
      break;
    case ColumnGroup::kFlux:
      names.push_back(std::string("flux_") + channel);
      break;
  }
  return names;
}

std::vector<double> ValuesOf(ColumnGroup group, const ChannelDerivatives& d) {
  const auto vector = [](const Vector3& v) {
    return std::vector<double>{v.x, v.y, v.z};
  };
  switch (group) {
    case ColumnGroup::kGradient:
      return vector(d.gradient);
    case ColumnGroup::kTangential:
      return vector(d.tangential);
    case ColumnGroup::kNormal:
      return vector(d.normal);
    case ColumnGroup::kVector:
      return vector(d.vector);
    case ColumnGroup::kJacobian: {
      std::vector<double> values;
      for (const Matrix3* matrix : {&d.jacobian, &d.sphere_jacobian}) {
        for (const auto& row : *matrix)
          values.insert(values.end(), row.begin(), row.end());
      }
      return values;
    }
    case ColumnGroup::kSphere:
      return vector(d.sphere);
    case ColumnGroup::kFlux:
      break;
  }
  return {d.flux};
}

/// Calls visit(group, channel) for all columns that are chosen, in their order.
template <class Visit>
void ForEachColumnGroup(const ColumnChoice& columns, const Visit& visit) {
  for (const ColumnGroup group : kColumnGroups) {
    if (!columns.Has(group)) continue;
    for (std::size_t channel = 0; channel < 3; ++channel)
      visit(group, channel);
  }
}

}  // namespace

std::string_view Name(ColumnGroup group) {
  switch (group) {
    case ColumnGroup::kGradient:
      return "gradient";
    case ColumnGroup::kTangential:
      return "tangential";
    case ColumnGroup::kNormal:
      return "normal";
    case ColumnGroup::kVector:
      return "vector";
    case ColumnGroup::kJacobian:
      return "jacobian";
    case ColumnGroup::kSphere:
      return "sphere";
    case ColumnGroup::kFlux:
      return "flux";
  }
  return "";
}

std::vector<std::string> DerivativeNames(const ColumnChoice& columns,
                                         Method method) {
  std::vector<std::string> names;
  const auto append_groups = [&](const std::string& prefix) {
    ForEachColumnGroup(columns, [&](ColumnGroup group, std::size_t channel) {
      for (const std::string& name : NamesOf(group, kChannels[channel]))
        names.push_back(prefix + name);
    });
  };
  for (const char channel : kChannels)
    names.push_back(std::string("E_") + channel);
  for (const char channel : kChannels)
    names.push_back(std::string("status_") + channel);
  append_groups("");
  if (method == Method::kDouble) {
    for (const char channel : kChannels)
      names.push_back(std::string("bound_E_") + channel);
    append_groups("bound_");
  }
  return names;
}

std::string DerivativeHeader(const ColumnChoice& columns, Method method,
                             char separator) {
  std::string header;
  for (const std::string& name : DerivativeNames(columns, method))
    header += separator + name;
  return header;
}

void AppendDerivatives(std::string& text, const Derivatives& derivatives,
                       const ColumnChoice& columns, Method method,
                       char separator) {
  const auto append = [&](double number) {
    text += separator;
    AppendNumber(text, number);
  };
  const bool has_none = derivatives.smoothness == Smoothness::kDiscontinuous;
  const auto append_groups =
      [&](const std::array<ChannelDerivatives, 3>& channels) {
        ForEachColumnGroup(
            columns, [&](ColumnGroup group, std::size_t channel) {
              for (const double value : ValuesOf(group, channels[channel])) {
                if (!has_none) {
                  append(value);
                } else {
                  text += separator;
                  // Between blanks nothing is no field.
                  if (separator == ' ') text += "\"\"";
                }
              }
            });
      };
  for (const double e : derivatives.irradiance.value)
    append(e);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    text += separator;
    text += Name(derivatives.smoothness);
  }
  append_groups(derivatives.channels);
  if (method != Method::kDouble) return;
  for (const double bound : derivatives.irradiance.bound)
    append(bound);
  append_groups(derivatives.bounds);
}

}  // namespace truelux
