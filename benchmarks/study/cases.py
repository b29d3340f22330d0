"""Cases: scene files with a `study:` note {family, ratio, counted}, and their variations (mesh,
wall). A new case is a new file."""

import copy
from dataclasses import dataclass
from pathlib import Path

import yaml

FOLDER = Path(__file__).resolve().parent.parent / "cases" / "tube"


def text_of(scene):
    """The scene file of a tree, its keys in their order."""
    return yaml.safe_dump(scene, sort_keys=False, default_flow_style=None, width=150)


@dataclass(frozen=True)
class Case:
    name: str
    family: str  # stretch, twist, bend, offset, combined, curved, tapered
    # to the limit the family names: Brazier's curvature, wrinkling; for stretch the stretch itself
    ratio: float
    counted: bool  # False: beyond what the model is for; reported, not part of any mean or aim
    scene: dict

    @property
    def tube(self):
        return self.scene["vessels"][0]["tube"]

    @property
    def wall(self):
        return self.scene["vessels"][0]["wall"]

    def changed(self, *, around=None, wall=None, study_end=None):
        """The same case on another mesh (`around` points, strips in proportion, an even number) or
        with other wall entries."""
        scene = copy.deepcopy(self.scene)
        vessel = scene["vessels"][0]
        if around is not None:
            tube = vessel["tube"]
            tube["along"] = 2 * round(tube["along"] * around / tube["around"] / 2)
            tube["around"] = around
        if wall is not None:
            vessel["wall"] = {**vessel["wall"], **wall}
        if study_end is not None:
            scene["ends"][1] = {**scene["ends"][1], **study_end}
        return Case(self.name, self.family, self.ratio, self.counted, scene)

    def text(self):
        return text_of(self.scene)


def read_case(path):
    scene = yaml.safe_load(Path(path).read_text())
    note = scene.get("study")
    if not isinstance(note, dict) or set(note) != {"family", "ratio", "counted"}:
        raise SystemExit(f"{path}: study: found {note}, expected {{family, ratio, counted}}")
    if scene["scene"] != Path(path).stem:
        raise SystemExit(
            f"{path}: scene: found {scene['scene']}, expected the file's name {Path(path).stem}"
        )
    return Case(scene["scene"], note["family"], float(note["ratio"]), bool(note["counted"]), scene)


def all_cases(folder=FOLDER):
    return [read_case(path) for path in sorted(Path(folder).glob("*.yaml"))]


def case_named(name, folder=FOLDER):
    return read_case(Path(folder) / f"{name}.yaml")
