"""behind_a_proxy.py CERTIFICATE SERVERS DOORS RECORDED LOG MONITORED MONITOR: nginx, which writes
LOG, before `serve`, `live` and `watch` (ports of each), and before a server of this file's own that
writes down what reaches it; and with a door at which MONITOR may ask for metrics."""

import base64
import hashlib
import json
import re
import socket
import ssl
import struct
import sys
import threading
import time
import urllib.parse
import warnings

from proxied import (
    LIMIT_S,
    NAME,
    ask,
    ask_plainly,
    ask_raw,
    connect,
    expect,
    hear,
    protocol,
    read_answer,
    request,
    say,
    shake_hands,
    tls,
)

SERVE, LIVE, WATCH = map(int, sys.argv[2].split())
SERVE_DOOR, LIVE_DOOR, WATCH_DOOR = map(int, sys.argv[3].split())
RECORDER, *RECORDED_DOORS = map(int, sys.argv[4].split())
LOG = sys.argv[5]
MONITORED_DOOR, MONITOR = int(sys.argv[6]), sys.argv[7]
PASSWORD = "Authorization: Basic " + base64.b64encode(b"anna:a-word-for-tests").decode()
WRONG = "Authorization: Basic " + base64.b64encode(b"anna:another-word").decode()
READING = "Authorization: Bearer read-0123456789abcdef"
WRITING = "Authorization: Bearer write-0123456789abcdef"
UNKNOWN = "Authorization: Bearer none-0123456789abcdef"
ANN = "Authorization: Bearer ann-0123456789abcdef"
SUE = "Authorization: Bearer sue-0123456789abcdef"


def requests_served():
    """That reached `serve`, by its own count; these two questions are not among them."""
    text = ask_plainly(SERVE, "/metrics").body.decode()
    counted = re.findall(r'^slackwater_http_requests_total\{route="(.*?)".*\} (\d+)$', text, re.M)
    return sum(int(count) for route, count in counted if route != "/metrics")


# --- TLS alone -----------------------------------------------------------------------------------
for door in (SERVE_DOOR, LIVE_DOOR, WATCH_DOOR):
    with socket.create_connection(("127.0.0.1", door), LIMIT_S) as link:
        link.sendall(request("/", PASSWORD, host=NAME))
        answer = read_answer(link.makefile("rb"))
        expect((answer.status, b"HTTPS port" in answer.body), (400, True), "HTTP without TLS")
    old = tls()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)
        old.minimum_version = ssl.TLSVersion.TLSv1
        old.maximum_version = ssl.TLSVersion.TLSv1_1
    old.set_ciphers("ALL:@SECLEVEL=0")
    for name, context in ((NAME, old), ("another.example.org", None)):
        try:
            connect(door, name=name, context=context).close()
        except ssl.SSLError as refused:
            wanted = "version" if context else "name"
            expect(wanted in str(refused).lower(), True, f"a handshake for {name}: {refused}")
        else:
            raise SystemExit(f"{name} at {door}: a handshake that ought to be refused")

# --- who comes in --------------------------------------------------------------------------------
before = requests_served()
for target in (
    "/",
    "/?f=html",
    "/collections",
    "/api",
    "/sites",
    "/session",
    "/sessions",
    "/sessions/far/check",
    "/sessions/far/socket",
    "/desk/page.js",
    "/nowhere",
):
    for fields in ((), (WRONG,), ("Authorization: Basic !",), ("Authorization: Bearer short",)):
        answer = ask(SERVE_DOOR, target, *fields)
        expect(answer.status, 401, f"{target} with {fields}")
        expect(answer.field("www-authenticate"), 'Basic realm="Slackwater"', target)
for fields in ((UNKNOWN,), ("Authorization: Bearer READ-0123456789ABCDEF",), (WRITING,), (ANN,)):
    expect(ask(SERVE_DOOR, "/collections", *fields).status, 401, f"a reading with {fields}")
for target in (
    "/collections/../sessions/far/check",
    "/sessions/far/%2e%2e/check",
    "//sessions/far/check",
    "/collections%2f..%2fsessions/far/check",
    "/.git/config",
):
    expect(ask(SERVE_DOOR, target, UNKNOWN).status, 400, target)
for target in ("/metrics", "/metrics/", "/%6detrics", "/metrics?a=b"):
    for fields in ((), (PASSWORD,), (READING,), (WRITING,)):
        answer = ask(SERVE_DOOR, target, *fields)
        expect((answer.status, b"<center>nginx" in answer.body), (404, True), f"{target} from afar")
expect(requests_served() - before, 0, "requests that nginx refused and `serve` saw")
for fields in ((PASSWORD,), (READING,)):
    for target in ("/", "/collections", "/sites", "/collections/currents/locations?f=GeoJSON"):
        expect(ask(SERVE_DOOR, target, *fields).status, 200, f"{target} with {fields[0][:21]}")
expect(ask(SERVE_DOOR, "/health").status, 200, "/health without a password")
# Where Prometheus is let in by its address, as the page has it.
scraped = ask(MONITORED_DOOR, "/metrics", source=MONITOR)
expect((scraped.status, b"slackwater_http_requests_total" in scraped.body), (200, True), "metrics")
for fields in ((), (PASSWORD,), (READING,), (f"X-Forwarded-For: {MONITOR}",)):
    expect(ask(MONITORED_DOOR, "/metrics", *fields).status, 403, f"/metrics with {fields}")
expect(ask(MONITORED_DOOR, "/collections", source=MONITOR).status, 401, "the rest by a monitor")

# --- who may write -------------------------------------------------------------------------------
ASKED = b'{"made_up": "question"}'
posted = dict(method="POST", body=ASKED)
JSON = "Content-Type: application/json"


def may_write(answer, what, wanted):
    expect(answer.status != 401, wanted, f"{what}: {answer.status} {answer.body[:200]}")


may_write(ask_plainly(SERVE, "/missions", JSON, **posted), "this machine itself", True)
for forged in (
    (),
    ("X-Forwarded-For: 127.0.0.1",),
    ("X-Forwarded-For:",),
    ("X_Forwarded_For: 127.0.0.1",),
    ("Forwarded: for=127.0.0.1;host=127.0.0.1",),
    ("Connection: close, X-Forwarded-For",),
    ("Connection: keep-alive, Host",),
    ("X-Real-IP: 127.0.0.1", "X-Forwarded-Host: 127.0.0.1"),
    (f"Origin: https://{NAME}:{SERVE_DOOR}",),
):
    answer = ask(SERVE_DOOR, "/missions", PASSWORD, JSON, *forged, **posted)
    expect(
        (answer.status, answer.field("www-authenticate")), (401, "Bearer"), f"POST with {forged}"
    )
for refused in (UNKNOWN, READING):
    may_write(ask(SERVE_DOOR, "/missions", refused, JSON, **posted), refused, False)
may_write(ask(SERVE_DOOR, "/missions", WRITING, JSON, **posted), "the token of --token-file", True)
for host in ("127.0.0.1", "localhost", "evil.example"):
    answer = ask_raw(SERVE_DOOR, request("/missions", PASSWORD, JSON, host=host, **posted))
    expect(answer.status, 421, f"the host {host}")

# --- links ---------------------------------------------------------------------------------------
OURS = f"https://{NAME}:{SERVE_DOOR}"


def links_in(value):
    if isinstance(value, dict):
        for key, each in value.items():
            if key in ("href", "url", "slackwater:example") and isinstance(each, str):
                yield each
            else:
                yield from links_in(each)
    elif isinstance(value, list):
        for each in value:
            yield from links_in(each)


def own_target(link, where):
    expect(link == OURS or link.startswith(OURS + "/"), True, f"a link of {where}: {link}")
    return link[len(OURS) :] or "/"


open_ones, seen, read = ["/"], {"/"}, 0
while open_ones and read < 60:
    target = open_ones.pop(0)
    answer = ask(SERVE_DOOR, target, PASSWORD)
    expect(answer.status, 200, f"the link {target}")
    read += 1
    if "json" not in answer.field("content-type"):
        continue
    for link in links_in(answer.json()):
        if not link.startswith("http") or "{" in link or "slackwater" in link:
            continue
        if urllib.parse.urlsplit(link).hostname in (
            "www.opengis.net",
            "docs.ogc.org",
            "spdx.org",
            "doi.org",
            "creativecommons.org",
        ):
            continue
        found = own_target(link, target)
        is_query = re.search(r"/(position|area|cube|radius|corridor|trajectory)($|\?)", found)
        if found not in seen and (not is_query or "coords" in found or "bbox" in found):
            seen.add(found)
            open_ones.append(found)
expect(read > 30, True, f"documents that were read: {read}")
servers = ask(SERVE_DOOR, "/api", PASSWORD).json()["servers"]
expect([each["url"] for each in servers], [OURS], "the servers of /api")
page = ask(SERVE_DOOR, "/collections?f=html", PASSWORD)
for link in re.findall(rb'href="(https?:[^"]*)"', page.body):
    own_target(link.decode(), "a page")
print(f"{read} documents behind nginx, and each of their links leads through it")

# --- pages keep their fields ---------------------------------------------------------------------
for door, target in (
    (SERVE_DOOR, "/?f=html"),
    (SERVE_DOOR, "/session"),
    (LIVE_DOOR, "/session"),
    (WATCH_DOOR, "/session"),
    (SERVE_DOOR, "/collections?f=html"),
):
    answer = ask(door, target, PASSWORD)
    expect(answer.status, 200, target)
    expect(answer.field("x-content-type-options"), "nosniff", target)
    expect(answer.field("content-security-policy").startswith("default-src 'none'"), True, target)
    expect(answer.field("strict-transport-security"), "max-age=31536000", target)

# --- a large answer, to a slow reader ------------------------------------------------------------
LARGE = (
    "/collections/currents-members/area?coords=POLYGON((2.3%2057.1,2.6%2057.1,2.6%2057.3,"
    "2.3%2057.3,2.3%2057.1))&resolution-x=50&resolution-y=50&f=CoverageJSON"
)
whole = ask_plainly(SERVE, LARGE)
expect(whole.status, 200, f"a large answer: {whole.body[:300]}")
behind = ask(SERVE_DOOR, LARGE, PASSWORD)
own_words = re.compile(rb"https?://[a-z0-9.]*:\d+")
same = lambda body: hashlib.sha256(own_words.sub(b"", body)).hexdigest()
expect(same(behind.body), same(whole.body), "a large answer behind nginx")
with connect(SERVE_DOOR) as link:
    link.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 18)
    link.sendall(request(LARGE, PASSWORD, "Connection: close", host=f"{NAME}:{SERVE_DOOR}"))
    stream = link.makefile("rb")
    for _ in range(50):
        expect(
            len(stream.read(len(whole.body) // 50)), len(whole.body) // 50, "a slow reader's bytes"
        )
        time.sleep(0.1)
    stream.read()
# status, seconds until the client had it, seconds until nginx had it, target
time.sleep(0.2)
with open(LOG) as log:
    taken = [line.split() for line in log if LARGE in line][-1]
for_client_s, for_nginx_s = float(taken[1]), float(taken[2])
expect(
    for_client_s > 2.5 and for_nginx_s < for_client_s - 1.5,
    True,
    f"a slow reader's seconds {for_client_s}, of which nginx held the server {for_nginx_s}",
)
print(
    f"{len(whole.body) / 1e6:.1f} MB come the same through nginx; of the {for_client_s:.1f} s of a "
    f"slow reader `serve` saw {for_nginx_s:.1f} s"
)


# --- WebSockets ----------------------------------------------------------------------------------
def take_part(door, session, name, token, *fields):
    """A welcome, and pictures of the run after it."""
    link, stream, answer = shake_hands(door, session, protocol(token), *fields)
    with link:
        expect(answer.status, 101, f"a seat at {session}: {answer.body[:300]}")
        say(link, {"do": "hello", "id": 1, "name": name})
        found, frames = None, 0
        while found is None or frames < 3:
            kind, body = hear(stream)
            if kind == 2:
                frames += 1
                number = struct.unpack("<I", body[4:8])[0] if len(body) >= 8 else 0
                say(link, {"do": "saw", "id": 10 + frames, "frame": number})
            elif kind == 1 and json.loads(body).get("is") == "welcome":
                found = json.loads(body)
                if token is None:
                    say(link, {"do": "play", "id": 2, "rate": 1})
            elif kind == 8:
                raise SystemExit(f"{session} closed: {body}")
        return found


live = ask(LIVE_DOOR, "/sessions", PASSWORD).json()["sessions"][0]["id"]
expect(ask(LIVE_DOOR, "/sessions").status, 401, "the list of sessions without a password")
expect(ask(LIVE_DOOR, f"/sessions/{live}/check", ANN).status, 204, "a seat by its own token")
expect(ask(LIVE_DOOR, f"/sessions/{live}/check", UNKNOWN).status, 401, "a seat by none")
expect(take_part(LIVE_DOOR, live, "Ann", "ann-0123456789abcdef")["role"], "operator", "a role")
for what, wanted, arguments in (
    ("no token", 401, dict(fields=(protocol(),))),
    ("a token of nobody", 401, dict(fields=(protocol("none-0123456789abcdef"),))),
    (
        "another origin",
        403,
        dict(fields=(protocol("ann-0123456789abcdef"),), origin="https://evil.example"),
    ),
):
    link, _, answer = shake_hands(LIVE_DOOR, live, *arguments.pop("fields"), **arguments)
    expect(answer.status, wanted, f"a handshake with {what}")
    link.close()

# A session that a supervisor begins at `serve`.
answer = ask(SERVE_DOOR, "/sessions", ANN, JSON, method="POST", body=b'{"begin": "far"}')
expect(answer.status, 403, "an operator begins a session")
answer = ask(SERVE_DOOR, "/sessions", SUE, JSON, method="POST", body=b'{"begin": "far"}')
expect(answer.status, 201, f"a supervisor begins a session: {answer.body[:300]}")
for _ in range(100):
    if ask(SERVE_DOOR, "/sessions/far/check", SUE).status == 204:
        break
    time.sleep(0.2)
expect(take_part(SERVE_DOOR, "far", "Sue", "sue-0123456789abcdef")["role"], "supervisor", "a role")

# A log: nobody but with the password, and from a page of its own door.
expect(ask(WATCH_DOOR, "/sessions", PASSWORD).json()["sessions"][0]["id"], "log", "a log")
for fields in ((), (ANN,), (READING,)):
    for target in ("/sessions", "/sessions/log/check", "/sessions/log/actions", "/session"):
        expect(ask(WATCH_DOOR, target, *fields).status, 401, f"{target} of a log with {fields}")
    link, _, answer = shake_hands(WATCH_DOOR, "log", protocol("ann-0123456789abcdef"), *fields)
    expect(answer.status, 401, f"a log with {fields}")
    link.close()
link, _, answer = shake_hands(
    WATCH_DOOR, "log", protocol(), PASSWORD, origin="https://evil.example"
)
expect(answer.status, 403, "a log for a page of another origin")
link.close()
expect(take_part(WATCH_DOOR, "log", "", None, PASSWORD)["role"], "spectator", "who watches a log")
print("sessions of `live` and `serve`, and a log, pass as WebSockets; strangers do not")

# --- each address has its share ------------------------------------------------------------------
held = []
statuses = []
for _ in range(52):
    link, _, answer = shake_hands(WATCH_DOOR, "log", protocol(), PASSWORD, source="127.0.0.2")
    statuses.append(answer.status)
    held.append(link)
expect(statuses, [101] * 48 + [429] * 4, "what one address is given")
link, _, answer = shake_hands(WATCH_DOOR, "log", protocol(), PASSWORD, source="127.0.0.3")
expect(answer.status, 101, "another address meanwhile")
for each in (*held, link):
    each.close()
half = []
for _ in range(200):
    link = connect(SERVE_DOOR, "127.0.0.2")
    link.sendall(b"GET / HTTP/1.1\r\nHost: ")
    half.append(link)
connections = int(
    re.search(
        r"^slackwater_http_connections (\d+)", ask_plainly(SERVE, "/metrics").body.decode(), re.M
    )[1]
)
expect(connections < 20, True, f"connections of 200 half requests at `serve`: {connections}")
took = []
for _ in range(20):
    begun = time.monotonic()
    expect(ask(SERVE_DOOR, "/collections", PASSWORD).status, 200, "others, beside half requests")
    took.append(time.monotonic() - begun)
for link in half:
    link.close()
print(
    f"200 half requests: {connections} connections at `serve`, others answered within "
    f"{max(took) * 1e3:.0f} ms"
)


# --- what reaches a server -----------------------------------------------------------------------
class Recorder(threading.Thread):
    """Answers everything with 204 and keeps the heads as they came."""

    def __init__(self):
        super().__init__(daemon=True)
        self.heads, self.door = [], socket.create_server(("127.0.0.1", RECORDER))

    def run(self):
        while True:
            link, _ = self.door.accept()
            threading.Thread(target=self.serve, args=(link,), daemon=True).start()

    def serve(self, link):
        stream = link.makefile("rb")
        while line := stream.readline():
            head = [line.decode("latin-1").strip()]
            while (field := stream.readline().strip()) != b"":
                head.append(field.decode("latin-1"))
            length = [int(f.split(":")[1]) for f in head if f.lower().startswith("content-length:")]
            stream.read(sum(length))
            self.heads.append(head)
            link.sendall(b"HTTP/1.1 204 No Content\r\n\r\n")


recorder = Recorder()
recorder.start()


def fields_of(head, name):
    return [f.split(":", 1)[1].strip() for f in head[1:] if f.split(":", 1)[0].lower() == name]


def reached(door, raw):
    """The heads that come of these bytes."""
    seen_before = len(recorder.heads)
    answer = ask_raw(door, raw)
    return answer, recorder.heads[seen_before:]


serve_door, live_door, watch_door = RECORDED_DOORS
for door, own_host in (
    (serve_door, f"{NAME}:{serve_door}"),
    (live_door, f"{NAME}:{live_door}"),
    (watch_door, "127.0.0.1"),
):
    answer, heads = reached(
        door,
        request(
            "/x",
            PASSWORD,
            "X-Forwarded-For: 10.9.8.7",
            "x-forwarded-for: 127.0.0.1",
            "X_Forwarded_For: 1",
            "Forwarded: for=127.0.0.1",
            "Connection: X-Forwarded-For, Upgrade, Host, HTTP2-Settings",
            "Upgrade: h2c",
            "HTTP2-Settings: AAMAAABkAAQAAP__",
            host=f"{NAME}:{door}",
        ),
    )
    expect((answer.status, len(heads)), (204, 1), "a request with forged fields")
    expect(fields_of(heads[0], "host"), [own_host], "Host")
    expect(fields_of(heads[0], "x-forwarded-for"), ["127.0.0.1"], "X-Forwarded-For: who it was")
    for gone in ("forwarded", "x_forwarded_for", "upgrade", "connection"):
        expect(fields_of(heads[0], gone), [], gone)
    # The target names a host of its own: it counts, and the field does not.
    answer, heads = reached(
        door, request(f"https://{NAME}:{door}/x", PASSWORD, host="evil.example")
    )
    expect(
        [fields_of(head, "host") for head in heads],
        [[own_host]],
        "Host beside a target with a host",
    )
    answer, heads = reached(
        door, request("https://evil.example/x", PASSWORD, host=f"{NAME}:{door}")
    )
    expect((answer.status, heads), (421, []), "a target with another host")
    tail = request("/smuggled", host=f"{NAME}:{door}")
    chunked = b"0\r\n\r\n" + tail
    for what, raw in {
        "two hosts": request("/x", PASSWORD, "Host: evil.example", host=f"{NAME}:{door}"),
        "length and chunks": request(
            "/x",
            PASSWORD,
            f"Content-Length: {len(chunked)}",
            "Transfer-Encoding: chunked",
            host=f"{NAME}:{door}",
        )
        + chunked,
        "two lengths": request(
            "/x",
            PASSWORD,
            "Content-Length: 0",
            f"Content-Length: {len(tail)}",
            host=f"{NAME}:{door}",
        )
        + tail,
        "two codings": request(
            "/x", PASSWORD, "Transfer-Encoding: chunked, chunked", host=f"{NAME}:{door}"
        )
        + chunked,
        "a name with a space": request(
            "/x", PASSWORD, "Transfer-Encoding : chunked", host=f"{NAME}:{door}"
        )
        + chunked,
        "a line feed in the target": "GET /x%0d%0aHost:%20evil.example HTTP/1.1\r\n"
        f"Host: {NAME}:{door}\r\n"
        f"{PASSWORD}\r\n\r\n".encode(),
    }.items():
        answer, heads = reached(door, raw)
        expect([head for head in heads if "smuggled" in head[0]], [], what)
        expect(len(heads) <= 1, True, what)
        for head in heads:
            expect(fields_of(head, "host"), [own_host], what)
            expect("evil" in "".join(head[1:]), False, what)
        if what in ("two hosts", "length and chunks", "two lengths"):
            expect(answer.status, 400, what)
print(f"{len(recorder.heads)} requests with forged fields reached a server, each as nginx wrote it")
