"""Section 4: time and size of the computation."""

import json
import platform

import scenes
from work import Number, Panel


def processor():
    try:
        with open("/proc/cpuinfo") as lines:
            for line in lines:
                if line.startswith("model name"):
                    return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()


def runs(quick):
    return [scenes.glenn_run("infant"), scenes.models_run()]


def panel(work):
    run, models = scenes.glenn_run("infant"), scenes.models_run()
    folder = work.solved(run)
    result = f"{folder}/result/result.json"
    work.write("section4_machine.json", json.dumps({"processor": processor()}) + "\n")
    return Panel(
        identity="section4",
        title="Section 4: time and number of vertices",
        paper="10 s for 24,393 vertices on a 2.33 GHz Core 2 Duo.",
        reproduced=f"The same kind of prediction at the paper's energies, on: {processor()}.",
        missing="The paper's CT data and its surfaces are not public.",
        differs=(
            "The anatomy is drawn, of the same size; the time contains reading the files, the fit"
            " of the rods, the operation, contact with the aorta, and pictures. One thread. Other"
            " programs on the machine make the wall time longer, the processor time less so."
        ),
        numbers=[
            Number(
                "vertices of the three vessels before the operation",
                f"{work.solved(models)}/result/result.json",
                "model/vertices",
                paper="24,393",
            ),
            Number("vertices of the deformed model, with the heart", result, "model/vertices"),
            Number("wall time of the prediction", result, "seconds/total", "s", paper="10"),
            Number("of this the surfaces", result, "seconds/solve", "s"),
            Number(
                "processor time of the whole program",
                f"{folder}/record.json",
                "processor_seconds",
                "s",
            ),
            Number("memory at its peak", f"{folder}/record.json", "peak_bytes", "MB", 1e-6),
        ],
    )
