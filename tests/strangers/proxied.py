"""A client of nginx and of the servers behind it, for behind_a_proxy.py: bytes as they are
written, on connections of their own."""

import base64
import hashlib
import json
import os
import socket
import ssl
import struct
import sys

NAME = "ocean.example.org"
CERTIFICATE = sys.argv[1]
LIMIT_S = 30  # generous: sanitizers, two cores


def expect(found, wanted, what):
    if found != wanted:
        raise SystemExit(f"{what}: found {found!r}, expected {wanted!r}")


def tls():
    return ssl.create_default_context(cafile=CERTIFICATE)


def connect(door, source="127.0.0.1", name=NAME, context=None):
    plain = socket.create_connection(("127.0.0.1", door), LIMIT_S, (source, 0))
    return (context or tls()).wrap_socket(plain, server_hostname=name)


class Answer:
    def __init__(self, status, fields, body):
        self.status, self.fields, self.body = status, fields, body

    def field(self, name):
        return ", ".join(value for key, value in self.fields if key == name.lower())

    def json(self):
        return json.loads(self.body)


def read_answer(stream, method="GET"):
    status = int(stream.readline().split()[1])
    fields = []
    while (line := stream.readline().strip()) != b"":
        key, value = line.decode("latin-1").split(":", 1)
        fields.append((key.strip().lower(), value.strip()))
    answer = Answer(status, fields, b"")
    if status == 101 or method == "HEAD":
        return answer
    if answer.field("transfer-encoding") == "chunked":
        while (size := int(stream.readline().split(b";")[0], 16)) > 0:
            answer.body += stream.read(size)
            stream.readline()
        stream.readline()
    else:
        answer.body = stream.read(int(answer.field("content-length") or 0))
    return answer


def ask_raw(door, raw, source="127.0.0.1"):
    """What nginx answers to these bytes."""
    with connect(door, source) as link:
        link.sendall(raw)
        return read_answer(link.makefile("rb"))


def request(target, *fields, method="GET", body=b"", host=None):
    lines = [f"{method} {target} HTTP/1.1", *fields]
    if host is not None:
        lines.insert(1, f"Host: {host}")
    if body or method == "POST":
        lines.append(f"Content-Length: {len(body)}")
    return ("\r\n".join(lines) + "\r\n\r\n").encode("latin-1") + body


def ask(door, target, *fields, method="GET", body=b"", source="127.0.0.1"):
    return ask_raw(
        door, request(target, *fields, method=method, body=body, host=f"{NAME}:{door}"), source
    )


def ask_plainly(port, target, *fields, method="GET", body=b""):
    """Of a server itself, without nginx."""
    with socket.create_connection(("127.0.0.1", port), LIMIT_S) as link:
        link.sendall(request(target, *fields, method=method, body=body, host=f"127.0.0.1:{port}"))
        return read_answer(link.makefile("rb"))


def shake_hands(door, session, *fields, origin=None, source="127.0.0.1"):
    """The link and the status of its handshake."""
    link = connect(door, source)
    key = base64.b64encode(os.urandom(16)).decode()
    link.sendall(
        request(
            f"/sessions/{session}/socket",
            "Connection: Upgrade",
            "Upgrade: websocket",
            "Sec-WebSocket-Version: 13",
            f"Sec-WebSocket-Key: {key}",
            f"Origin: {origin or f'https://{NAME}:{door}'}",
            *fields,
            host=f"{NAME}:{door}",
        )
    )
    stream = link.makefile("rb")
    answer = read_answer(stream)
    if answer.status == 101:
        wanted = hashlib.sha1((key + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11").encode()).digest()
        expect(
            answer.field("sec-websocket-accept"), base64.b64encode(wanted).decode(), "the handshake"
        )
    return link, stream, answer


def say(link, message):
    text, mask = json.dumps(message).encode(), os.urandom(4)
    length = (
        struct.pack("!BB", 0x81, 0x80 | len(text))
        if len(text) < 126
        else struct.pack("!BBH", 0x81, 0xFE, len(text))
    )
    link.sendall(length + mask + bytes(c ^ mask[i % 4] for i, c in enumerate(text)))


def hear(stream):
    first, length = stream.read(2)
    if length == 126:
        (length,) = struct.unpack("!H", stream.read(2))
    elif length == 127:
        (length,) = struct.unpack("!Q", stream.read(8))
    return first & 15, stream.read(length)


def protocol(token=None):
    return "Sec-WebSocket-Protocol: slackwater.session.v1" + (f", bearer.{token}" if token else "")
