"""The figures of the pages, each from one table, as SVG with the same bytes each time."""

from pathlib import Path

from names import GROUPS, words_of

COLOURS = {
    "rod": "#8c8c8c",
    "skin": "#d08c2f",
    "paper": "#b5483f",
    "coupled": "#2f6fb0",
    "shell": "#3a8f5a",
    "solid": "#222222",
    "CalculiX S8R": "#7a4fa3",
    "CalculiX C3D20R": "#c06aa8",
}
MARKERS = {"skin": "s", "rod": "s", "paper": "D", "coupled": "o", "shell": "^", "solid": "v"}
MARKERS |= {"CalculiX S8R": "P", "CalculiX C3D20R": "X"}
NOTE = 8  # font size of what is written inside a figure


def plotting():
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    plt.rcParams.update(
        {"font.size": 9, "axes.grid": True, "grid.alpha": 0.3, "svg.hashsalt": "vasorod"}
    )
    return plt


def save(figure, path):
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, metadata={"Date": None}, facecolor="white")


def legend_below(figure, columns):
    """One legend for all panels, under them."""
    names = [name for axis in figure.axes for name in axis.get_legend_handles_labels()[1]]
    inches = 0.1 + 0.17 * -(-len(names) // columns)
    figure.legend(loc="lower center", ncol=columns, fontsize=NOTE, frameon=False)
    figure.tight_layout(rect=(0, inches / figure.get_figheight(), 1, 1))


def agreement(values):
    """Bias and 1.96 standard deviations."""
    n = len(values)
    mean = sum(values) / n
    return mean, 1.96 * (sum((v - mean) ** 2 for v in values) / (n - 1)) ** 0.5 if n > 1 else 0.0


def plain(axis):
    """Numbers as they are, 0.01 and not a power of ten."""
    axis.set_major_formatter(lambda value, _: f"{value:g}")
    axis.set_minor_formatter(lambda value, _: "")


def rows_by_load(rows, series, value, label, limits, aim, own):
    """A row per kind of load, in it a line of dots per model; every dot is a case. A value below
    the left limit stands at it. series: {model: name in the legend}."""
    plt = plotting()
    figure, axis = plt.subplots(figsize=(8, 5.6))
    groups = [g for g in GROUPS if any(words_of(row["case"])[0] == g for row in rows)]
    for k, group in enumerate(groups):
        mine = [row for row in rows if words_of(row["case"])[0] == group]
        worst = max((row[own] for row in mine if row[own] is not None), default=None)
        if worst is not None:
            axis.barh(
                -k,
                100 * worst - limits[0],
                left=limits[0],
                height=0.86,
                color="#e4e4e4",
                label="largest error of the reference" if k == 0 else None,
                zorder=1,
            )
        for line, (model, name) in enumerate(series.items()):
            found = [100 * value(row) for row in mine if row["model"] == model]
            height = -k + 0.27 - 0.54 * line / (len(series) - 1)
            axis.scatter(
                [max(limits[0], one) for one in found],
                [height] * len(found),
                color=COLOURS[model],
                marker=MARKERS[model],
                s=26,
                alpha=0.8,
                linewidths=0,
                label=name if k == 0 else None,
                zorder=3,
                clip_on=False,
            )
    axis.axvline(aim[0], color=COLOURS["coupled"], linestyle=":", label=aim[1])
    axis.set_yticks([-k for k in range(len(groups))], groups)
    axis.grid(axis="y", visible=False)
    for k in range(1, len(groups)):
        axis.axhline(0.5 - k, color="#cccccc", linewidth=0.6)
    axis.set_ylim(0.5 - len(groups), 0.5)
    axis.set_xscale("log")
    axis.set_xlim(*limits)
    plain(axis.xaxis)
    axis.set_xlabel(label)
    legend_below(figure, 3)
    return figure


def errors_figure(rows):
    """RMS distance of every counted case, 48 points around, beside the reference's own error."""
    return rows_by_load(
        [row for row in rows if row["counted"] and row["around"] == 48 and row["rms"] is not None],
        {"skin": "skin", "paper": "paper", "coupled": "coupled"},
        lambda row: row["rms"],
        "RMS distance of material points from the reference, % of the radius",
        (1e-4, 20),
        (0.2, "aim of coupled: 0.2 %"),
        "u_shape",
    )


def reactions_figure(rows):
    """The larger difference of force and moment; logarithmic, so that no case flattens the rest."""
    return rows_by_load(
        [
            row
            for row in rows
            if row["counted"] and row["around"] == 48 and row["force"] is not None
        ],
        {"rod": "rod, skin and paper", "coupled": "coupled"},
        lambda row: max(row["force"], row["moment"]),
        "difference of the reaction at the moved end from the reference, %",
        (1e-3, 100),
        (1, "aim of coupled: 1 %"),
        "u_reaction",
    )


def settings_text(value):
    return f"{value:g}" if isinstance(value, float) else str(value)


# Where the label of a run stands beside its marker: (model, settings): offset in points, alignment.
BESIDE = {
    ("skin", "24"): ((0, 6), "center"),
    ("skin", "48"): ((0, 6), "center"),
    ("skin", "96"): ((0, 6), "center"),
    ("paper", "24"): ((4, -12), "left"),
    ("paper", "48"): ((0, -12), "center"),
    ("paper", "96"): ((0, -12), "center"),
    ("coupled", "24"): ((-6, -12), "right"),
    ("coupled", "48"): ((-4, -14), "right"),
    ("coupled", "96"): ((-6, -10), "right"),
    ("shell", "p2-12x16"): ((-6, 2), "right"),
    ("shell", "p4-8x12"): ((-6, -10), "right"),
    ("shell", "p3-6x8"): ((-6, -3), "right"),
    ("CalculiX C3D20R", "36x60"): ((0, -13), "center"),
}
LABELLED = ("skin", "paper", "coupled")  # every run; of the others those of BESIDE


def cost_figure(rows, front):
    """Error against time, a line per model and order of its elements from coarse to fine."""
    plt = plotting()
    figure, axis = plt.subplots(figsize=(8, 5.4))
    axis.plot(
        [row["seconds"] for row in front],
        [100 * row["rms"] for row in front],
        color="#bbbbbb",
        linewidth=6,
        solid_capstyle="round",
        label="nothing is both faster and nearer",
        zorder=1,
    )
    for model in dict.fromkeys(row["model"] for row in rows):
        mine = [row for row in rows if row["model"] == model]
        orders = dict.fromkeys(settings_text(row["settings"]).split("-")[0] for row in mine)
        orders = [order for order in orders if order.startswith("p")] or [""]
        for k, order in enumerate(orders):
            line = [row for row in mine if settings_text(row["settings"]).startswith(order)]
            line.sort(key=lambda row: row["seconds"])
            axis.plot(
                [row["seconds"] for row in line],
                [100 * row["rms"] for row in line],
                color=COLOURS[model],
                marker=MARKERS[model],
                markersize=5,
                linewidth=0.8,
                label=model if k == 0 else None,
                zorder=3,
            )
        for row in mine:
            text = settings_text(row["settings"])
            if model in LABELLED or (model, text) in BESIDE:
                offset, side = BESIDE.get((model, text), ((5, 3), "left"))
                axis.annotate(
                    text,
                    (row["seconds"], 100 * row["rms"]),
                    fontsize=NOTE,
                    color=COLOURS[model],
                    xytext=offset,
                    textcoords="offset points",
                    ha=side,
                )
    axis.set_xscale("log")
    axis.set_yscale("log")
    plain(axis.xaxis)
    plain(axis.yaxis)
    axis.margins(0.08)
    axis.set_xticks([0.2, 0.5, 1, 2, 5, 10, 20])
    axis.set_xlabel("processor time of the whole program, s")
    axis.set_ylabel("RMS distance from the converged reference, % of the radius")
    legend_below(figure, 4)
    return figure


def reaction_of(row):
    return max(row["force"], row["moment"] / 10)


def moduli_figure(rows):
    """The two loads whose shape depends on the moduli, over the factor on E: what the shape does,
    and the distance of the reaction from the reference, where the reference converged."""
    plt = plotting()
    loads = {
        "bend": "bent to 0.5 of Brazier's curvature",
        "offset": "one end moved sideways",
    }
    figure, axes = plt.subplots(2, 2, figsize=(8, 6), sharex="col")
    for column, (load, title) in enumerate(loads.items()):
        of = {
            model: {
                f"{row['factor']:.3g}": row
                for row in sorted(rows, key=lambda row: row["factor"])
                if (row["load"], row["modulus"], row["fidelity"]) == (load, "E", model)
                and row["force"] is not None
            }
            for model in ("skin", "paper", "coupled", "shell")
        }
        shell = of.pop("shell")
        end = max((row["factor"] for row in shell.values()), default=0)
        for model, points in of.items():
            line = [row for row in points.values() if row["factor"] <= 1.001 * end]
            axes[0][column].plot(
                [row["factor"] for row in line],
                [100 * row["variation"] for row in line],
                color=COLOURS[model],
                linestyle="--" if model == "skin" else "-",
                label=model if column == 0 else None,
            )
            both = [(points[key], other) for key, other in shell.items() if key in points]
            axes[1][column].plot(
                [row["factor"] for row, _ in both],
                [100 * (reaction_of(row) / reaction_of(other) - 1) for row, other in both],
                color=COLOURS[model],
                linestyle="--" if model == "skin" else "-",
                marker=MARKERS[model],
                markersize=5 if model != "skin" else 7,
                fillstyle="none" if model == "skin" else "full",
            )
        axes[0][column].plot(
            [row["factor"] for row in shell.values()],
            [100 * row["variation"] for row in shell.values()],
            color=COLOURS["shell"],
            marker=MARKERS["shell"],
            linestyle="none",
            label="shell, the reference" if column == 0 else None,
            zorder=4,
        )
        axes[0][column].set_title(title, fontsize=9)
        axes[1][column].axhspan(-1, 1, color="#e4e4e4", label=None if column else "aim: 1 %")
        axes[1][column].set_yscale("symlog", linthresh=1, linscale=1)
        axes[1][column].set_ylim(-100, 20)
        axes[1][column].set_yticks([-100, -10, -1, 0, 1, 10])
        axes[1][column].set_xscale("log")
        axes[1][column].set_xlabel("factor on E, with G as it is")
        plain(axes[1][column].xaxis)
        plain(axes[1][column].yaxis)
    axes[0][0].set_ylabel("distance from the shape at factor 1,\nRMS, % of the radius")
    axes[1][0].set_ylabel("reaction, difference\nfrom the reference, %")
    legend_below(figure, 5)
    return figure


ENDINGS = {"converged": "#3a8f5a", "named otherwise": "#d8b365", "failed": "#b5483f"}


def endings_figure(lines):
    """How runs ended, a bar per family. lines: (name, converged, named otherwise, failed)."""
    plt = plotting()
    figure, axis = plt.subplots(figsize=(8, 0.27 * len(lines) + 1.1))
    for k, (name, *counts) in enumerate(lines):
        left, total = 0, sum(counts)
        for count, (ending, colour) in zip(counts, ENDINGS.items()):
            axis.barh(
                -k,
                100 * count / total,
                left=left,
                color=colour,
                label=ending if k == 0 else None,
                height=0.72,
            )
            left += 100 * count / total
        axis.text(101, -k, f"{counts[0]} of {total}", va="center", fontsize=NOTE)
    axis.set_yticks([-k for k in range(len(lines))], [name for name, *_ in lines])
    axis.set_xlim(0, 100)
    axis.set_ylim(0.5 - len(lines), 0.5)
    axis.grid(axis="y", visible=False)
    axis.set_xlabel("share of the runs, %; right: converged")
    legend_below(figure, 3)
    return figure
