// The verb doctor.
#ifndef RASTERPROOF_TOOL_DOCTOR_CMD_DOCTOR_H_
#define RASTERPROOF_TOOL_DOCTOR_CMD_DOCTOR_H_

namespace rasterproof::tool {

int RunDoctor();

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_DOCTOR_CMD_DOCTOR_H_
