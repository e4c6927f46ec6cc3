// The module's exports. A text goes in by rasterproof_room(), which gives the place to write it to;
// what comes out lies at the returned place, rasterproof_length() bytes of it, until the next call.
// One check at a time. What throws ends the instance: rasterproof_message() says why.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "exact/edge.h"
#include "web/engine/open.h"
#include "web/engine/oracle.h"
#include "web/engine/session.h"
#include "web/engine/throwing.h"

namespace rasterproof::web {
namespace {

std::string given;
std::string result;
std::unique_ptr<Session> session;

const char* Say(std::string text) {
  result = std::move(text);
  return result.data();
}

Session& Current() {
  if (session == nullptr) throw InputError("check", "was not opened", "call open() first");
  return *session;
}

}  // namespace
}  // namespace rasterproof::web

namespace web = rasterproof::web;

#define RASTERPROOF_EXPORT(name) extern "C" [[clang::export_name("rasterproof_" #name)]]

RASTERPROOF_EXPORT(room) char* Room(std::size_t size) {
  web::given.assign(size, '\0');
  return web::given.data();
}
RASTERPROOF_EXPORT(length) std::size_t Length() { return web::result.size(); }
RASTERPROOF_EXPORT(message) const char* Message() { return web::LastMessage(); }

RASTERPROOF_EXPORT(open) void Open() {
  rasterproof::exact::RequireHonestEnvironment();
  web::session = std::make_unique<web::Session>(web::OpenedFrom(web::given));
}
RASTERPROOF_EXPORT(next) const char* Next() { return web::Say(web::Current().Next()); }
RASTERPROOF_EXPORT(answer) bool Answer() { return web::Current().Answer(web::given); }
RASTERPROOF_EXPORT(progress) const char* Progress() { return web::Say(web::Current().Progress()); }
RASTERPROOF_EXPORT(save) const char* Save() { return web::Say(web::Current().Save()); }
RASTERPROOF_EXPORT(load) void Load() { web::Current().Load(web::given); }
RASTERPROOF_EXPORT(result) const char* Result() { return web::Say(web::Current().Result()); }

RASTERPROOF_EXPORT(covers) const char* CoversOf() { return web::Say(web::Covers(web::given)); }
RASTERPROOF_EXPORT(draw) const char* DrawOf() { return web::Say(web::Draw(web::given)); }
RASTERPROOF_EXPORT(methods) const char* MethodsOf() { return web::Say(web::Methods()); }
