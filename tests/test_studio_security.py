"""What the studio and the command line do not let happen to files, connections and the token."""

import json
import os
import socket
import stat
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

pytest.importorskip("uvicorn", reason="the extra 'studio' is not installed")

import quintrig
from quintrig.exchange import nets
from quintrig.exchange.cad import isolated
from quintrig.studio import patient
from quintrig.support.errors import ModelError, QuintrigError
from quintrig.support.files import refuse_loss, refuse_unwritable, write_first, write_whole
from studio_server import MODEL, Running

SPHERE = 'kind = "sphere"\n'
NET = "\n".join(f"{i % 6},{i // 6},{i % 5}" for i in range(36))
pipes = pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no named pipes")


@pytest.fixture
def running(tmp_path):
    folder = tmp_path / "models"
    folder.mkdir()
    (folder / "tent.toml").write_text(MODEL)
    one = Running(folder)
    yield one
    one.stop()


@pytest.mark.parametrize(
    ("asked", "meant", "other"),
    [
        ("100%2541.toml", "100%41.toml", "100A.toml"),
        ("%252e%252e%252ftent.toml", "%2e%2e%2ftent.toml", "tent.toml"),
        ("a%252Ftoml.toml", "a%2Ftoml.toml", "a/toml.toml"),
        ("%25C3%25BC.toml", "%C3%BC.toml", "ü.toml"),
        ("%C3%BC.toml", "ü.toml", "%C3%BC.toml"),
    ],
)
def test_a_name_is_decoded_once(running, asked, meant, other):
    if "/" not in other:
        (running.folder / other).write_text(MODEL)
    (running.folder / meant).write_text(SPHERE)
    status, answer = running.json("GET", f"/api/files/{asked}")
    assert (status, answer["name"], answer["model"]["kind"]) == (200, meant, "sphere")
    body = {"text": SPHERE + "radius = 7\n", "tag": answer["tag"]}
    assert running.json("PUT", f"/api/files/{asked}", body)[0] == 200
    assert "7" in (running.folder / meant).read_text()
    if "/" not in other:
        assert (running.folder / other).read_text() == MODEL


@pytest.mark.parametrize("how", ["file", "folder"])
@pytest.mark.parametrize("several", [False, True])
def test_a_net_is_not_read_through_a_link_that_leads_out(running, how, several):
    outside = running.folder.parent / "private"
    outside.mkdir()
    (outside / "net.csv").write_text(NET)
    if how == "file":
        (running.folder / "net.csv").symlink_to(outside / "net.csv")
    else:
        (running.folder / "inner").symlink_to(outside)
    named = "net.csv" if how == "file" else "inner/net.csv"
    head = "[[patch]]\n" if several else ""
    (running.folder / "lid.toml").write_text(f'{head}kind = "tensor"\npoints = "{named}"\n')
    status, answer = running.json("GET", "/api/files/lid.toml")
    assert status == 422
    assert f"{named}: leads out of the folder" in answer["error"]


def test_a_net_beside_the_model_is_read_and_through_a_link_within_the_folder_too(running):
    (running.folder / "net.csv").write_text(NET)
    (running.folder / "same.csv").symlink_to("net.csv")
    for name in ("net.csv", "same.csv"):
        (running.folder / "lid.toml").write_text(f'kind = "tensor"\npoints = "{name}"\n')
        assert running.json("GET", "/api/files/lid.toml")[0] == 200


@pytest.mark.parametrize("mode", [0o600, 0o640, 0o664, 0o755])
def test_saving_keeps_the_permissions(running, mode):
    path = running.folder / "tent.toml"
    path.chmod(mode)
    assert running.json("PUT", "/api/files/tent.toml", {"text": SPHERE, "tag": None})[0] == 200
    assert stat.S_IMODE(path.stat().st_mode) == mode
    assert "sphere" in path.read_text()


def test_writing_through_a_link_keeps_the_link(tmp_path):
    (tmp_path / "store").mkdir()
    real, link, second = tmp_path / "store" / "a.toml", tmp_path / "a.toml", tmp_path / "b.toml"
    real.write_text("old")
    real.chmod(0o600)
    link.symlink_to("store/a.toml")
    second.symlink_to("a.toml")
    assert write_whole(second, "new") == second
    assert link.is_symlink()
    assert second.is_symlink()
    assert real.read_text() == "new"
    assert stat.S_IMODE(real.stat().st_mode) == 0o600
    dangling = tmp_path / "c.toml"
    dangling.symlink_to("store/c.toml")
    write_whole(dangling, "made")
    assert dangling.is_symlink()
    assert (tmp_path / "store" / "c.toml").read_text() == "made"
    assert sorted(path.name for path in (tmp_path / "store").iterdir()) == ["a.toml", "c.toml"]


def test_a_new_file_has_the_usual_permissions(tmp_path):
    mask = os.umask(0o027)
    try:
        write_whole(tmp_path / "a", "x")
        assert write_first(tmp_path / "b", "x")
    finally:
        os.umask(mask)
    assert {stat.S_IMODE((tmp_path / name).stat().st_mode) for name in "ab"} == {0o640}


def endless(path):
    os.mkfifo(path)
    return path


@pipes
@pytest.mark.parametrize(
    ("name", "read"),
    [
        ("a.toml", quintrig.load),
        ("a.json", quintrig.load),
        ("a.csv", lambda path: nets.model_from_net(path, {"kind": "tensor"})),
        ("a.json", lambda path: nets.model_from_net(path, {"kind": "tensor"})),
        *((f"a{suffix}", isolated.read) for suffix in isolated.CAD_SUFFIXES),
        ("a.toml", lambda path: write_whole(path, "x")),
        ("a.toml", refuse_unwritable),
    ],
)
@pytest.mark.parametrize("linked", [False, True])
def test_a_pipe_is_refused_and_not_waited_for(tmp_path, name, read, linked):
    path = endless(tmp_path / name)
    if linked:
        path = tmp_path / f"link{path.suffix}"
        path.symlink_to(name)
    told = []

    def attempt():
        try:
            read(path)
        except (ModelError, QuintrigError) as error:
            told.append(str(error))

    thread = threading.Thread(target=attempt, daemon=True)
    thread.start()
    thread.join(20)
    assert not thread.is_alive()
    assert len(told) == 1
    assert "found a pipe" in told[0]
    assert "\n" not in told[0]
    assert path.is_fifo()


@pipes
def test_a_net_that_is_a_pipe_or_a_device_is_refused(tmp_path):
    endless(tmp_path / "net.csv")
    (tmp_path / "zero.csv").symlink_to("/dev/zero")
    for name, found in (("net.csv", "a pipe"), ("zero.csv", "a device")):
        (tmp_path / "lid.toml").write_text(f'kind = "tensor"\npoints = "{name}"\n')
        with pytest.raises(ModelError, match=f"{name}.*found {found}"):
            quintrig.load(tmp_path / "lid.toml")
    refuse_loss(endless(tmp_path / "out.toml"), tmp_path / "net.csv")  # returns


@pipes
def test_the_server_goes_on_beside_pipes(running):
    endless(running.folder / "stuck.toml")
    (running.folder / "lid.toml").write_text('kind = "tensor"\npoints = "net.csv"\n')
    endless(running.folder / "net.csv")
    body = {"text": SPHERE, "tag": None}
    for tag in (None, "", "0123456789abcdef"):
        status, answer = running.json("PUT", "/api/files/stuck.toml", body | {"tag": tag})
        assert status in (409, 422)
        assert "\n" not in answer["error"]
    for name in ("stuck.toml", "lid.toml"):
        status, answer = running.json("GET", f"/api/files/{name}")
        assert status == 422
        assert "found a pipe" in answer["error"]
        assert str(running.folder) not in answer["error"]
    assert running.json("GET", "/api/files")[1]["files"] == ["lid.toml", "tent.toml"]


def begun(running, *parts, pause=0.0):
    """Send parts of a request, and return the connection."""
    one = socket.create_connection(("127.0.0.1", running.site.port), timeout=20)
    for part in parts:
        one.sendall(part.encode())
        time.sleep(pause)
    return one


def test_a_half_sent_request_is_closed_and_others_are_not(running, monkeypatch):
    monkeypatch.setattr(patient, "SECONDS", 1.0)
    head = "".join(f"{name}: {value}\r\n" for name, value in running.own.items())
    halves = {
        "nothing": (),
        "half a line": ("GET /api/fi",),
        "half a head": ("GET /api/files HTTP/1.1\r\n", head),
        "half a body": (f"POST /api/check HTTP/1.1\r\n{head}Content-Length: 100\r\n\r\n", '{"name"'),
        "a refused body": ("POST /api/check HTTP/1.1\r\nHost: x\r\nContent-Length: 100\r\n\r\n", "{"),
        "a half after a whole": (f"GET /api/files HTTP/1.1\r\n{head}\r\n", "GET /"),
    }
    for name, parts in halves.items():
        one = begun(running, *parts, pause=0.2)
        start = time.monotonic()
        while one.recv(65536):  # to the end of the connection; a timeout is an error
            assert time.monotonic() - start < 15, name
        one.close()
    # What trickles in counts from its first byte.
    one = begun(running, "GET /api/files HTTP/1.1\r\n")
    with pytest.raises(OSError):  # noqa: PT012
        for _ in range(40):
            one.sendall(b"X: y\r\n")
            time.sleep(0.1)
    one.close()
    whole = begun(running, "GET /api/files HTTP/1.1\r\n", head, "\r\n", pause=0.1)
    assert b"200 OK" in whole.recv(65536)
    whole.close()
    assert running.json("GET", "/api/files")[0] == 200


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.json", '{"kind": "sphere", "radius": 1, "radius": 2}'),
        ("a.json", '{"patch": [{"kind": "sphere", "kind": "cone"}]}'),
        ("a.toml", 'kind = "sphere"\nradius = 1\nradius = 2\n'),
    ],
)
def test_a_key_given_twice_is_refused_by_the_check_as_by_the_command(running, tmp_path, name, text):
    status, answer = running.json("POST", "/api/check", {"name": name, "text": text})
    assert status == 422
    assert "twice" in answer["error"]
    (tmp_path / name).write_text(text)
    with pytest.raises(ModelError) as error:
        quintrig.load(tmp_path / name)
    assert str(error.value).removeprefix(f"{tmp_path}/") == answer["error"]
    twice = json.dumps({"name": "a.toml", "text": SPHERE})[:-1] + ', "name": "b.toml"}'
    assert running.json("POST", "/api/check", twice)[0] == 422


ORDER = {"text": SPHERE, "suffix": ".stl", "patch": "", "colour": ""}
MISTAKES = [
    ("POST", "/api/export", ORDER | {"suffix": ".nothing"}),
    ("POST", "/api/export", ORDER | {"colour": "nothing"}),
    ("POST", "/api/export", ORDER | {"colour": "normal"}),
    ("POST", "/api/export", ORDER | {"patch": "nothing", "suffix": ".svg"}),
    ("POST", "/api/export", ORDER | {"text": "nonsense"}),
    ("POST", "/api/export", ORDER | {"text": ""}),
    ("POST", "/api/export", ORDER | {"suffix": ".csv"}),
    ("POST", "/api/export", []),
    ("POST", "/api/check", {"name": "\ud800.toml", "text": SPHERE}),
    ("POST", "/api/check", {"name": "a.toml", "text": 'kind = "sphere"\nname = "\ud800"'}),
    ("POST", "/api/check", {"name": "a.json", "text": '{"kind": "sphere", "name": "\\ud800"}'}),
    ("POST", "/api/check", {"name": "a.json", "text": '{"\\ud800": 1}'}),
    ("POST", "/api/check", {"name": "a.json", "text": '{"kind": "sphere", "radius": 1e999}'}),
    ("POST", "/api/check", {"name": "a.json", "text": '{"kind": "sphere", "radius": ' + "9" * 400 + "}"}),
    ("POST", "/api/check", {"name": "a.json", "text": "9" * 9000}),
    ("PUT", "/api/files/%00.toml", {"text": SPHERE, "tag": None}),
    ("PUT", "/api/files/folder.toml", {"text": SPHERE, "tag": None}),
    ("PUT", "/api/files/folder.toml", {"text": SPHERE, "tag": "x"}),
    ("PUT", "/api/files/" + "a" * 300 + ".toml", {"text": SPHERE, "tag": None}),
    ("PUT", "/api/files/" + "%F0%9F%9A%97" * 70 + ".toml", {"text": SPHERE, "tag": ""}),
    ("GET", "/api/files/" + "%F0%9F%9A%97" * 70 + ".toml", None),
    ("GET", "/api/files/folder.toml", None),
    ("GET", "/api/files/%ff%fe.toml", None),
    ("GET", "/api/files/%ED%A0%80.toml", None),
]  # fmt: skip


@pytest.mark.parametrize("mistake", MISTAKES, ids=range(len(MISTAKES)))
def test_a_mistake_is_told_in_one_line_and_not_as_a_fault_of_the_server(running, mistake):
    (running.folder / "folder.toml").mkdir()
    method, path, body = mistake
    status, answer = running.json(method, path, body)
    assert 400 <= status < 500
    assert answer["error"]
    assert "\n" not in answer["error"]
    assert str(running.folder) not in answer["error"]


def test_the_token_is_in_no_command_line(tmp_path):
    """The browser is a script here, which notes how it was started and what mode the file had that it was given."""
    (tmp_path / "tent.toml").write_text(MODEL)
    note, browser = tmp_path / "note.json", tmp_path / "browser.py"
    browser.write_text(
        f"#!{sys.executable}\n"
        "import json, os, pathlib, sys, urllib.parse, urllib.request\n"
        "path = urllib.parse.unquote(urllib.parse.urlsplit(sys.argv[1]).path)\n"
        "told = {'arguments': sys.argv, 'path': path, 'text': pathlib.Path(path).read_text(),\n"
        "        'modes': [os.stat(path).st_mode & 0o777, os.stat(os.path.dirname(path)).st_mode & 0o777]}\n"
        f"pathlib.Path({str(note)!r}).write_text(json.dumps(told))\n"
    )
    browser.chmod(0o755)
    command = [sys.executable, "-c", "from quintrig.cli import main; main()", "view", "tent.toml"]
    environment = os.environ | {"BROWSER": str(browser)}
    process = subprocess.Popen(
        command, cwd=tmp_path, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    try:
        address = process.stdout.readline().split()[-1]
        for _ in range(600):
            if note.exists() and note.read_text():
                break
            time.sleep(0.05)
        told = json.loads(note.read_text())
        assert told["arguments"][1].startswith("file://")
        token = address.partition("token=")[2]
        assert len(token) > 20
        assert not any(token in part for part in told["arguments"])
        assert address in told["text"]
        assert told["modes"] == [0o600, 0o700]
        process.send_signal(2)
        process.communicate(timeout=20)
    finally:
        process.kill()
    assert process.returncode == 0
    assert not Path(told["path"]).parent.exists()
