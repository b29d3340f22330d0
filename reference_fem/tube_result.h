// Converts a solved tube to the result folder's data: mid-wall surface, centerline with directors
// and strains, section metrics.
#pragma once

#include <vasorod/result.h>

#include "reference_fem/mid_wall.h"
#include "reference_fem/tube.h"

namespace vasorod::fem {

/// In the scene's units. A section's centre moves with the mean of its mid-wall ring; its directors
/// are the rotation nearest to the ring's motion. Strains are those of the screw between
/// neighbouring sections, averaged to the stations. `unit`: length per dimensionless length. In the
/// rows of an open slit the ring's first point is that of one lip.
VesselResult vessel_result(const std::string& name, const TubeShape& shape, double unit,
                           const MidWall& wall);

/// flattening = 1 - smallest distance of opposite mid-wall points over their rest distance, the
/// largest value of all stations. Open stations are left out: there the mouth is measured.
VesselMetrics vessel_metrics(const TubeShape& shape, double unit, const MidWall& wall,
                             const VesselResult& vessel);

}  // namespace vasorod::fem
