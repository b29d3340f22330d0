#include <vasorod/result.h>

namespace vasorod {
namespace {

const MouthReport* pointer(const std::optional<MouthReport>& mouth) {
  return mouth ? &*mouth : nullptr;
}

}  // namespace

std::optional<JoinedVessels> joined_vessels(const Result& result) {
  if (result.glenn) {
    const GlennReport& glenn = *result.glenn;
    return JoinedVessels{{glenn.svc, glenn.rpa}, &glenn.join, pointer(glenn.mouth), glenn.svc};
  }
  if (result.end_to_end) {
    const EndToEndReport& report = *result.end_to_end;
    const auto& rims = report.rims;
    return JoinedVessels{{rims[0].vessel, rims[1].vessel},
                         &report.join,
                         pointer(report.mouth),
                         rims[report.narrower == 0 ? 0 : 1].vessel};
  }
  return std::nullopt;
}

}  // namespace vasorod
