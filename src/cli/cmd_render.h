// truelux render: pictures of a scene, one irradiance a pixel.

#ifndef TRUELUX_CLI_CMD_RENDER_H_
#define TRUELUX_CLI_CMD_RENDER_H_

#include "cli/render_request.h"
#include "run/exit_status.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace truelux {

/// Adds the command to `app`. Parsing fills `arguments`, which must stay in
/// place until then.
void AddRenderCommand(CLI::App& app, RenderArguments& arguments);

/// Runs it. Throws UserError for bad input, and Interruption.
ExitStatus RunRender(const RenderArguments& arguments);

}  // namespace truelux

#endif  // TRUELUX_CLI_CMD_RENDER_H_
