#include "image/pixel_table.h"

#include <fmt/format.h>

#include "text/receivers.h"
#include "text/results.h"

namespace truelux {

std::string PixelReceiverHeader() {
  return fmt::format("{},{},px,py", fmt::join(kReceiverColumns, ","),
                     kOnFaceColumn);
}

void AppendPixelReceiver(std::string& text, int x, int y,
                         const Receiver& receiver) {
  const Point3& p = receiver.position;
  const Vector3& n = receiver.normal;
  for (const double number : {p.x, p.y, p.z, n.x, n.y, n.z}) {
    AppendNumber(text, number);
    text += ',';
  }
  text += fmt::format("{},{},{}\n", receiver.on_face, x, y);
}

std::string PixelValueHeader(Method method) {
  return fmt::format("px,py{}", ResultHeader(method));
}

void AppendPixelValue(std::string& text, int x, int y, const Rgb& value,
                      const Rgb& bound, Method method) {
  text += fmt::format("{},{}", x, y);
  Irradiance irradiance;
  irradiance.value = value;
  irradiance.bound = bound;
  AppendResult(text, irradiance, method);
  text += '\n';
}

}  // namespace truelux
