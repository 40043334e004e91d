"""Ratios of one run of bench/networks.py, all the larger the better, and how they compare with recorded ones."""

# What may be lost to noise on shared machines before a ratio counts as fallen.
SLACK = 0.8


def rate(row):
    return row["elements"] / (row["cpu"] if "cpu" in row else row["one"]["cpu"])


def fastest(peers, network, kind, who=None):
    """Elements a second of the fastest peer that ended with elements of that kind alone; None if there is none."""
    rates = [rate(row) for row in peers if row["network"] == network and row["kind"] == kind and "cpu" in row
             and who in (None, row["who"]) and (kind != "quad" or row["triangles"] == 0)]
    return max(rates, default=None)


def find_ratios(ours, peers):
    """{name: ratio} of the rows of bench/networks.py."""
    ratios, before = {}, {}
    for row in ours:
        if "error" in row:
            continue
        name = f"{row['network']}, {row['what']}"
        kind = "triangle" if row["what"] == "triangles" else "quad"
        for who in ("gmsh", "netgen"):
            peer = fastest(peers, row["network"], kind, who)
            if peer:
                ratios[f"{name}: elements a second by those of {who}'s fastest way"] = rate(row) / peer
        ratios[f"{name}: clock of one thread by that of two"] = row["one"]["wall"] / row["two"]["wall"]
        if row["what"] in before:
            ratios[f"{name}: time an element of {before[row['what']]['network']} by this one's"] = (
                rate(row) / rate(before[row["what"]]))
        before[row["what"]] = row
    return ratios


def compare(found, recorded):
    """Prints a table of both; True unless one has fallen."""
    print("| ratio | recorded | now | |\n|---|---|---|---|")
    good = True
    for name, value in found.items():
        if name not in recorded:
            print(f"| {name} | | {value:.2f} | new |")
            continue
        fallen = value < SLACK * recorded[name]
        good = good and not fallen
        print(f"| {name} | {recorded[name]:.2f} | {value:.2f} | {'**fallen**' if fallen else ''} |")
    return good
