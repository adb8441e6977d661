"""sbom.py FILE IN_MEMORY SOURCE: FILE (CycloneDX) against the libraries in the memory of a running
program, dpkg, package-lock.json, and the schema as cyclonedx-python-lib carries it."""

import copy
import json
import os
import re
import subprocess
import sys
import urllib.parse
from pathlib import Path

FILE, IN_MEMORY, SOURCE = sys.argv[1], sys.argv[2], Path(sys.argv[3])
LOCKS = ["api/web/desk", "api/web/session", "api/web/hands", "api/show/report"]
PURL = re.compile(r"^pkg:(deb/debian|npm)/((?:%40[^/]+/)?[^@/]+)@([^?]+)(\?.*)?$")


class Wrong(Exception):
    pass


def expect(is_so, what):
    if not is_so:
        raise Wrong(what)


def installed(packages):
    lines = subprocess.run(
        ["dpkg-query", "-W", "-f", "${Package} ${Version}\n", *packages],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    return dict(line.split() for line in lines.splitlines())


def owner_of(place):
    """By dpkg, which knows some libraries by /lib."""
    for name in (
        place,
        os.path.realpath(place),
        place.removeprefix("/usr"),
        os.path.realpath(place).removeprefix("/usr"),
    ):
        found = subprocess.run(["dpkg", "-S", name], capture_output=True, text=True, check=False)
        if found.returncode == 0:
            return found.stdout.split(":")[0].split(",")[0]
    return None


IN_PROGRAM = {place: owner_of(place) for place in Path(IN_MEMORY).read_text().split()}


def used_as(component):
    return {p["value"] for p in component["properties"] if p["name"] == "slackwater:used"}


def check(bill):
    components = bill["components"]
    debian = {c["name"]: c for c in components if c.get("purl", "").startswith("pkg:deb/")}
    npm = {c["purl"]: c for c in components if c.get("purl", "").startswith("pkg:npm/")}

    expect(len(IN_PROGRAM) > 50, f"{len(IN_PROGRAM)} libraries in memory are few")
    for place, package in IN_PROGRAM.items():
        listed = debian.get(package)
        expect(listed is not None, f"{place} of {package} is in the program and not listed")
        expect("loaded" in used_as(listed), f"{package} is not said to be loaded")
    versions = installed(sorted(debian))
    for name, component in debian.items():
        expect(
            component["version"] == versions[name],
            f"{name}: found {component['version']}, dpkg has {versions[name]}",
        )
    for name in (
        "libeigen3-dev",
        "nlohmann-json3-dev",
        "libcli11-dev",
        "libboost1.74-dev",
        "libflatbuffers-dev",
    ):
        expect("headers" in used_as(debian[name]), f"{name} is compiled in")
    expect("linked" in used_as(debian["libceres-dev"]), "Ceres is linked in")
    expect("libgtest-dev" not in debian, "what tests alone use is listed")

    for folder in LOCKS:
        lock = json.loads((SOURCE / folder / "package-lock.json").read_text())["packages"]
        for wanted in json.loads((SOURCE / folder / "package.json").read_text())["dependencies"]:
            fact = lock[f"node_modules/{wanted}"]
            purl = f"pkg:npm/{urllib.parse.quote(wanted, safe='/')}@{fact['version']}"
            expect(purl in npm, f"{purl} of {folder} is not listed")
    for purl, component in npm.items():
        expect(component["hashes"][0]["alg"] == "SHA-512", f"{purl} has no integrity")
        expect(len(component["hashes"][0]["content"]) == 128, f"{purl} has another integrity")

    silent = []
    for component in components:
        expect(component["licenses"], f"{component['name']} says nothing of its licence")
        for each in component["licenses"]:
            said = each.get("expression") or next(iter(each["license"].values()))
            expect(said, f"{component['name']} says nothing of its licence")
            if said == "NOASSERTION":
                silent.append(component["name"])
        if "purl" in component:
            parts = PURL.match(component["purl"])
            expect(parts is not None, f"{component['purl']} is no purl")
            expect(urllib.parse.unquote(parts[2]) == component["name"], component["purl"])
            expect(urllib.parse.unquote(parts[3]) == component["version"], component["purl"])
    refs = [c["bom-ref"] for c in components]
    expect(len(set(refs)) == len(refs), "a bom-ref stands twice")
    expect(sorted(bill["dependencies"][0]["dependsOn"]) == sorted(refs), "dependencies are others")
    return silent


def schema_check():
    """Of a bill, by the schema; None where that cannot be had."""
    try:
        import importlib.util
        import jsonschema
        from referencing import Registry, Resource

        found = importlib.util.find_spec("cyclonedx")
        folder = Path(found.origin).parent / "schema/_res"
        whole, *parts = (
            (name, json.loads((folder / name).read_text()))
            for name in (
                "bom-1.5.SNAPSHOT.schema.json",
                "spdx.SNAPSHOT.schema.json",
                "jsf-0.82.SNAPSHOT.schema.json",
            )
        )
    except (ImportError, AttributeError, OSError) as missing:
        print(f"the schema cannot be had: {missing}")
        return None
    # The schema names the other two from the place where it says that it lies.
    place = whole[1]["$id"].rsplit("/", 1)[0]
    registry = Registry().with_resources(
        [(f"{place}/{name}", Resource.from_contents(part)) for name, part in parts]
        + [(name, Resource.from_contents(part)) for name, part in parts]
    )
    validator = jsonschema.Draft7Validator(whole[1], registry=registry)

    def valid(bill):
        problem = next(validator.iter_errors(bill), None)
        expect(problem is None, f"the schema: {problem and problem.message[:300]}")

    return valid


def must_fail(check_of, bill, what, spoil):
    spoilt = copy.deepcopy(bill)
    spoil(spoilt)
    try:
        check_of(spoilt)
    except (Wrong, KeyError):
        return
    raise SystemExit(f"nobody noticed: {what}")


bill = json.loads(Path(FILE).read_text())
named = lambda some, name: next(c for c in some["components"] if c["name"] == name)
silent = check(bill)
must_fail(
    check,
    bill,
    "a library is left out",
    lambda some: some["components"].remove(named(some, "libnetcdf19")),
)
must_fail(check, bill, "another version", lambda some: named(some, "libproj25").update(version="1"))
must_fail(check, bill, "no licence", lambda some: named(some, "libssl3").update(licenses=[]))
must_fail(
    check,
    bill,
    "a page's package is left out",
    lambda some: some["components"].remove(named(some, "three")),
)
print(
    f"{len(bill['components'])} components; {len(IN_PROGRAM)} libraries in memory, all listed; "
    f"no licence known of {len(silent)}: {', '.join(silent) or 'none'}"
)
valid = schema_check()
if valid is None:
    print("skipped: the schema of CycloneDX (PyPI)")
    sys.exit(77)
valid(bill)
must_fail(
    valid,
    bill,
    "a licence that is none of SPDX",
    lambda some: named(some, "libdate-tz3").update(licenses=[{"license": {"id": "MITT"}}]),
)
must_fail(
    valid, bill, "a kind that there is not", lambda some: named(some, "three").update(type="lib")
)
print("CycloneDX 1.5, by its schema")
