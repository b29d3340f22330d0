"""Whether texts of a figure lie on one another, for the tests."""


def tick_texts(axis):
    """Of an axis, those inside its limits."""
    low, high = sorted(axis.get_view_interval())
    ticks = [*axis.get_major_ticks(), *axis.get_minor_ticks()]
    room = 1e-9 * (high - low)
    return [tick.label1 for tick in ticks if low - room <= tick.get_loc() <= high + room]


def shown_texts(figure):
    texts = [*figure.texts, *(text for legend in figure.legends for text in legend.get_texts())]
    for axes in figure.axes:
        texts += [*axes.texts, axes.title, axes.xaxis.label, axes.yaxis.label]
        texts += [*tick_texts(axes.xaxis), *tick_texts(axes.yaxis)]
    return [text for text in texts if text.get_visible() and text.get_text().strip()]


def overlapping(figure):
    """Pairs of texts whose boxes share more than a pixel, and texts that leave the figure."""
    figure.canvas.draw()
    boxes = [(text.get_text(), text.get_window_extent()) for text in shown_texts(figure)]
    whole = figure.bbox
    found = [
        (text, "the edge")
        for text, box in boxes
        if box.x0 < whole.x0 or box.y0 < whole.y0 or box.x1 > whole.x1 or box.y1 > whole.y1
    ]
    for k, (first, one) in enumerate(boxes):
        for second, other in boxes[k + 1 :]:
            wide = min(one.x1, other.x1) - max(one.x0, other.x0)
            high = min(one.y1, other.y1) - max(one.y0, other.y0)
            if wide > 1 and high > 1:
                found.append((first, second))
    return found
