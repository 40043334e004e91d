"""Ratios of one run of bench/networks.py, all the larger the better, and how they compare with recorded ones."""

# What may be lost to noise on shared machines before a ratio counts as fallen.
SLACK = 0.8
# A mesh that has less of the lines' length than this, in %, lost some; the rest is rounding of coordinates.
WHOLE = 99.99
OF_GMSH = "elements a second by those of gmsh's fastest way"
OF_THREADS = "clock of one thread by that of two"
A_SECOND = "elements a second and core"
# What is wanted of each, by what is made.
WANTED = {f"quads, no clean-up: {OF_GMSH}": 20, f"quads: {OF_GMSH}": 8, f"triangles: {OF_GMSH}": 15,
          f"quads, no clean-up: {OF_THREADS}": 1.7, f"quads: {OF_THREADS}": 1.7, f"triangles: {A_SECOND}": 600000}


def rate(row):
    return row["elements"] / (row["cpu"] if "cpu" in row else row["one"]["cpu"])


def why_not_counted(row):
    """Why a row of a peer is no way to what quarry promises: elements of one kind, all valid, on all of the lines; ""
    where it is one, as far as that is known."""
    if "cpu" not in row:
        return "not finished"
    if row["kind"] == "quad" and row["triangles"]:
        return f"{row['triangles']:,} triangles left"
    if row.get("sj_min", 1) <= 0:
        return "inverted elements"
    return "lines lost" if (row.get("kept") or 100) < WHOLE else ""


def fastest(peers, network, kind, who):
    """Elements a second of the fastest way of a peer that counts; None if there is none."""
    rates = [rate(row) for row in peers if row["network"] == network and row["kind"] == kind and who == row["who"]
             and not why_not_counted(row)]
    return max(rates, default=None)


def wanted(name):
    """What is wanted of a ratio or rate by its name; None where nothing is."""
    return next((value for end, value in WANTED.items() if name.endswith(", " + end)), None)


def find_rates(ours):
    """{name: elements a second} of the rows of bench/networks.py on one thread: these go with the machine."""
    return {f"{row['network']}, {row['what']}: {A_SECOND}": rate(row) for row in ours if "error" not in row}


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
        ratios[f"{name}: {OF_THREADS}"] = row["one"]["wall"] / row["two"]["wall"]
        if row["what"] in before and not row.get("map"):
            ratios[f"{name}: time an element of {before[row['what']]['network']} by this one's"] = (
                rate(row) / rate(before[row["what"]]))
        before[row["what"]] = row
    return ratios


def failures(ours):
    """What went wrong with rows of bench/networks.py: runs that failed, other bytes on two threads, lines lost."""
    for row in ours:
        name = f"{row['network']}, {row['what']}"
        if "error" in row:
            yield f"{name}: {row['error']}"
        elif not row["same_bytes"]:
            yield f"{name}: other bytes on two threads"
        elif (row["kept"] or 100) < WHOLE:
            yield f"{name}: {row['kept']:.3f} % of the lines kept"


def compare(found, recorded, networks):
    """Prints a table of both; True unless one of these networks has fallen or is missing."""
    print("| ratio | recorded | now | |\n|---|---|---|---|")
    good = True
    for name, value in recorded.items():
        if name.split(", ")[0] in networks and name not in found:
            good = False
            print(f"| {name} | {value:.2f} | | **missing** |")
    for name, value in found.items():
        if name not in recorded:
            print(f"| {name} | | {value:.2f} | new |")
            continue
        fallen = value < SLACK * recorded[name]
        good = good and not fallen
        print(f"| {name} | {recorded[name]:.2f} | {value:.2f} | {'**fallen**' if fallen else ''} |")
    return good
