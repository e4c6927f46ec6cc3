// The JSON writer's name in this namespace; goes when tool/cmd_survey.cc, cmd_sweep.cc and
// report/catalogue.cc include io/json_writer.h.
#ifndef RASTERPROOF_REPORT_JSON_WRITER_H_
#define RASTERPROOF_REPORT_JSON_WRITER_H_

#include "io/json_writer.h"

namespace rasterproof::report {

using io::JsonWriter;

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_JSON_WRITER_H_
