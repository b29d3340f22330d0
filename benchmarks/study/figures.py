"""Pictures of the report, each from one table."""

from pathlib import Path

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
    figure.tight_layout()
    figure.savefig(path, dpi=110, metadata={"Software": None})


def errors_picture(rows, path):
    """RMS distance per case, all models on the middle mesh, above the reference's own error."""
    plt = plotting()
    cases = sorted({row["case"] for row in rows if row["counted"]})
    figure, axis = plt.subplots(figsize=(10, 0.28 * len(cases) + 1.6))
    for model in ("skin", "paper", "coupled", "shell"):
        mine = {
            row["case"]: row["rms"]
            for row in rows
            if row["model"] == model and row["around"] in (48, None) and row["rms"] is not None
        }
        if mine:
            axis.scatter(
                [100 * mine[case] for case in cases if case in mine],
                [k for k, case in enumerate(cases) if case in mine],
                color=COLOURS[model],
                label=model,
                s=28,
                zorder=3,
            )
    floor = {row["case"]: row["u_shape"] for row in rows if row["u_shape"] is not None}
    axis.barh(
        range(len(cases)),
        [100 * floor.get(case, 0) for case in cases],
        color="#dddddd",
        label="the reference's own error",
        zorder=1,
    )
    axis.axvline(0.2, color="#2f6fb0", linestyle=":", label="aim for coupled, up to ratio 0.5")
    axis.set_yticks(range(len(cases)), cases)
    axis.set_xscale("log")
    axis.set_xlim(left=1e-3)
    axis.set_xlabel("RMS distance of material points, % of R")
    axis.legend(loc="upper center", bbox_to_anchor=(0.5, -0.13), ncol=3, fontsize=8)
    save(figure, path)
    plt.close(figure)


def limits_picture(rows, path):
    """Bland-Altman plot: signed reaction difference per case, bias and limits of agreement."""
    plt = plotting()
    models = [
        m
        for m in ("rod", "skin", "paper", "coupled")
        if any(r["model"] == m and r["reaction_signed"] is not None for r in rows)
    ]
    figure, axes = plt.subplots(
        1, len(models), figsize=(3 * len(models), 3.2), sharey=True, squeeze=False
    )
    for axis, model in zip(axes.flat, models):
        mine = [
            row
            for row in rows
            if row["model"] == model
            and row["around"] == 48
            and row["counted"]
            and row["reaction_signed"] is not None
        ]
        values = [100 * row["reaction_signed"] for row in mine]
        for family in sorted({row["family"] for row in mine}):
            points = [
                (k, v) for k, (row, v) in enumerate(zip(mine, values)) if row["family"] == family
            ]
            axis.scatter([k for k, _ in points], [v for _, v in points], s=16, label=family)
        bias, spread = agreement(values)
        axis.axhline(bias, color="#222222")
        for edge in (bias - spread, bias + spread):
            axis.axhline(edge, color="#222222", linestyle="--")
        axis.set_title(model)
        axis.set_xticks([])
    axes.flat[0].set_ylabel("reaction, model over reference - 1, %")
    axes.flat[-1].legend(fontsize=7)
    save(figure, path)
    plt.close(figure)


def agreement(values):
    """Bias and 1.96 standard deviations."""
    n = len(values)
    mean = sum(values) / n
    return mean, 1.96 * (sum((v - mean) ** 2 for v in values) / (n - 1)) ** 0.5 if n > 1 else 0.0


def sensitivity_picture(rows, path):
    """Shape variation and reaction against the factor, a column per load; the reference with its
    own error as bars."""
    plt = plotting()
    loads = [
        load
        for load in ("twist", "bend", "stretch", "offset")
        if any(row["load"] == load for row in rows)
    ]
    figure, axes = plt.subplots(4, len(loads), figsize=(3.4 * len(loads), 10), squeeze=False)
    for column, load in enumerate(loads):
        for line, (modulus, quantity) in enumerate(
            (m, q) for m in ("E", "G") for q in ("variation", "reaction")
        ):
            axis = axes[line][column]
            for model in ("skin", "paper", "coupled", "shell"):
                mine = sorted(
                    (row["factor"], row)
                    for row in rows
                    if row["load"] == load
                    and row["modulus"] == modulus
                    and row["fidelity"] == model
                    and row["force"] is not None
                )
                if not mine:
                    continue
                x = [factor for factor, _ in mine]
                if quantity == "variation":
                    y = [row["variation"] for _, row in mine]
                    bars = [row["u_shape"] or 0 for _, row in mine]
                else:
                    y = [max(row["force"], row["moment"] / 10) for _, row in mine]
                    bars = [(row["u_reaction"] or 0) * value for (_, row), value in zip(mine, y)]
                if model == "shell":
                    axis.errorbar(
                        x,
                        y,
                        yerr=bars,
                        fmt="o",
                        color=COLOURS[model],
                        label="reference (shell)",
                        capsize=3,
                        markersize=4,
                    )
                else:
                    axis.plot(x, y, color=COLOURS[model], label=model)
            axis.set_xscale("log")
            low, high = axis.get_ylim()
            if (
                quantity == "variation" and high < 1e-4
            ):  # nothing that could be seen: not rounding's shape, drawn large
                axis.set_ylim(-1e-4, 1e-3)
            elif quantity == "reaction" and high < 1.01 * low:
                axis.set_ylim(0.98 * low, 1.02 * high)
            elif quantity == "reaction":
                axis.set_yscale("log")
            axis.set_xlabel(f"factor on {modulus}")
            axis.set_ylabel(
                "variation, RMS over R" if quantity == "variation" else "reaction, max(|F|, |M|/R)"
            )
            if line == 0:
                axis.set_title(load)
    axes[0][-1].legend(fontsize=7)
    save(figure, path)
    plt.close(figure)


def trade_picture(rows, path, front):
    plt = plotting()
    figure, axis = plt.subplots(figsize=(8, 5))
    for model in dict.fromkeys(row["model"] for row in rows):
        mine = [row for row in rows if row["model"] == model]
        axis.scatter(
            [row["seconds"] for row in mine],
            [100 * row["rms"] for row in mine],
            color=COLOURS.get(model, "#7a4fa3"),
            label=model,
            s=30,
        )
        for row in mine:
            axis.annotate(
                f"{row['settings']:g}" if isinstance(row["settings"], float) else row["settings"],
                (row["seconds"], 100 * row["rms"]),
                fontsize=6,
                xytext=(3, 3),
                textcoords="offset points",
            )
    axis.plot(
        [row["seconds"] for row in front],
        [100 * row["rms"] for row in front],
        color="#222222",
        linewidth=0.8,
        label="Pareto front",
    )
    axis.set_xscale("log")
    axis.set_yscale("log")
    axis.set_xlabel("processor time of the whole program, s")
    axis.set_ylabel("RMS distance to the reference, % of R")
    axis.legend(fontsize=8)
    save(figure, path)
    plt.close(figure)
