"""The studio's server: what it serves, and to whom."""

import base64
import io
import signal
import subprocess
import sys
import time
import urllib.error
import urllib.request
import zipfile

import pytest

pytest.importorskip("uvicorn", reason="the extra 'studio' is not installed")

from quintrig.studio import server
from studio_server import MODEL, Running


@pytest.fixture
def running(tmp_path):
    (tmp_path / "tent.toml").write_text(MODEL)
    (tmp_path / "other.json").write_text('{"kind": "sphere"}')
    (tmp_path / "notes.txt").write_text("private")
    (tmp_path / "inner").mkdir()
    (tmp_path / "inner" / "deep.toml").write_text('kind = "sphere"')
    one = Running(tmp_path)
    yield one
    one.stop()


def test_the_page_its_script_and_its_policy(running):
    status, headers, page = running.ask("GET", "/")
    assert status == 200
    assert b"studio.js" in page
    policy = headers["content-security-policy"]
    assert "default-src 'none'" in policy
    assert "unsafe" not in policy
    assert "http" not in policy
    assert headers["x-content-type-options"] == "nosniff"
    assert running.ask("GET", "/studio.js")[0] == 200


def test_the_token_opens_the_page_once_and_a_cookie_keeps_it(running):
    status, headers, _ = running.ask("GET", f"/?token={running.site.token}", without=["Cookie", "Origin"])
    assert status == 200
    cookie = headers["set-cookie"]
    assert "HttpOnly" in cookie
    assert "SameSite=Strict" in cookie
    assert running.ask("GET", "/?token=wrong", without=["Cookie"])[0] == 403
    assert running.ask("GET", f"/api/model?token={running.site.token}", without=["Cookie"])[0] == 403


@pytest.mark.parametrize("path", ["/", "/studio.js", "/api/model", "/api/files", "/api/formats", "/nothing"])
def test_without_the_token_nothing_is_served(running, path):
    assert running.ask("GET", path, without=["Cookie"])[0] == 403
    wrong = {"Cookie": f"quintrig_{running.site.port}=x{running.site.token}"}
    assert running.ask("GET", path, headers=wrong)[0] == 403


@pytest.mark.parametrize("host", ["evil.example", "evil.example:{port}", "127.0.0.1", "localhost:1", "[::1", ""])
def test_another_host_name_is_refused(running, host):
    status, _, text = running.ask("GET", "/api/model", headers={"Host": host.format(port=running.site.port)})
    assert status == 421
    assert b"tent" not in text


@pytest.mark.parametrize("origin", ["http://evil.example", "null", "http://127.0.0.1:1", "https://127.0.0.1:{port}"])
def test_another_origin_is_refused(running, origin):
    headers = {"Origin": origin.format(port=running.site.port)}
    assert running.ask("GET", "/api/model", headers=headers)[0] == 403
    status, _ = running.json("PUT", "/api/files/tent.toml", {"text": 'kind = "sphere"', "tag": None}, headers=headers)
    assert status == 403
    assert (running.folder / "tent.toml").read_text() == MODEL


def test_a_change_without_an_origin_is_refused(running):
    body = {"text": 'kind = "sphere"', "tag": None}
    assert running.ask("PUT", "/api/files/new.toml", body, without=["Origin"])[0] == 403
    assert not (running.folder / "new.toml").exists()


def test_the_model_and_the_folder(running):
    status, answer = running.json("GET", "/api/model")
    assert status == 200
    assert answer["model"]["name"] == "A tent"
    assert running.json("GET", "/api/files")[1]["files"] == ["other.json", "tent.toml"]
    assert running.json("GET", "/api/files/other.json")[1]["model"]["kind"] == "sphere"


@pytest.mark.parametrize(
    "name",
    ["../secret.toml", "..%2Fsecret.toml", "inner/deep.toml", "inner%2Fdeep.toml", "%2Fetc%2Fpasswd", "notes.txt",
     ".hidden.toml", "link.toml", "a%00.toml", "..%5Csecret.toml", "..", "x" * 200 + ".toml"],
)  # fmt: skip
def test_no_file_outside_the_folder_is_read_or_written(running, name):
    secret = running.folder.parent / "secret.toml"
    secret.write_text('kind = "torus"')
    (running.folder / "link.toml").symlink_to(secret)
    assert running.ask("GET", f"/api/files/{name}")[0] in (404, 422)
    status, _, _ = running.ask("PUT", f"/api/files/{name}", {"text": 'kind = "sphere"', "tag": None})
    assert status in (404, 405, 422)
    assert secret.read_text() == 'kind = "torus"'
    assert (running.folder / "inner" / "deep.toml").read_text() == 'kind = "sphere"'


def test_saving_keeps_the_comments_and_other_keys(running):
    tag = running.json("GET", "/api/model")[1]["tag"]
    text = MODEL.replace("radius = 2 ", "radius = 2.5 ")
    status, answer = running.json("PUT", "/api/files/tent.toml", {"text": text, "tag": tag})
    assert status == 200
    assert (running.folder / "tent.toml").read_text() == text
    assert answer["tag"] != tag


def test_a_file_that_changed_meanwhile_is_not_overwritten(running):
    tag = running.json("GET", "/api/model")[1]["tag"]
    (running.folder / "tent.toml").write_text('kind = "torus"')
    status, answer = running.json("PUT", "/api/files/tent.toml", {"text": MODEL, "tag": tag})
    assert status == 409
    assert "changed" in answer["error"]
    assert (running.folder / "tent.toml").read_text() == 'kind = "torus"'
    assert running.json("PUT", "/api/files/tent.toml", {"text": MODEL, "tag": None})[0] == 200
    assert running.json("PUT", "/api/files/other.json", {"text": MODEL, "tag": ""})[0] == 409


def test_a_bad_model_gets_the_message_of_the_command_line(running):
    from quintrig import ModelError, load

    bad = running.folder / "bad.toml"
    bad.write_text('kind = "cone"\nradius = "wide"\n')
    with pytest.raises(ModelError) as told:
        load(bad)
    expected = str(told.value).replace(str(bad), "bad.toml")
    assert running.json("POST", "/api/check", {"name": "bad.toml", "text": bad.read_text()}) == (
        422,
        {"error": expected},
    )
    assert running.json("GET", "/api/files/bad.toml") == (422, {"error": expected})
    status, _ = running.json("PUT", "/api/files/tent.toml", {"text": bad.read_text(), "tag": None})
    assert status == 422
    assert (running.folder / "tent.toml").read_text() == MODEL


@pytest.mark.parametrize("body", ["", "[]", "{}", "nonsense", '{"text": 5, "name": "a.toml"}', "[" * 200_000])
def test_a_bad_request_is_answered_in_one_line(running, body):
    status, answer = running.json("POST", "/api/check", body)
    assert status == 422
    assert "\n" not in answer["error"]


def test_deep_and_large_models_are_refused(running):
    deep = '{"kind": "tensor", "points": ' + "[" * 100_000 + "]" * 100_000 + "}"
    assert running.json("POST", "/api/check", {"name": "deep.json", "text": deep})[0] == 422
    status, _, text = running.ask("POST", "/api/check", headers={"Content-Length": str(10**9)})
    assert status == 413
    assert b"24 MB" in text


def test_the_command_serves_until_it_is_interrupted(tmp_path):
    (tmp_path / "tent.toml").write_text(MODEL)
    command = [sys.executable, "-c", "from quintrig.cli import main; main()", "view", "tent.toml", "--no-browser"]
    process = subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        address = process.stdout.readline().split()[-1]
        for _ in range(200):
            try:
                with urllib.request.urlopen(address) as answer:
                    assert answer.status == 200
                break
            except urllib.error.URLError:
                time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        out, errors = process.communicate(timeout=20)
    finally:
        process.kill()
    assert process.returncode == 0
    assert "Stopped." in out
    assert errors == ""


def test_the_port_stays_the_same_for_a_model(tmp_path):
    assert server.site(tmp_path / "a.toml").port == server.site(tmp_path / "a.toml").port


def order(suffix, text=MODEL):
    """What the page sends for an export."""
    return {"text": text, "suffix": suffix, "patch": "A tent", "colour": ""}


def test_exports_are_those_of_the_exchange_package(running):
    from quintrig.exchange import export
    from quintrig.exchange.formats import FAMILIES, FORMATS, suffixes
    from quintrig.exchange.pattern import flatten

    assert {*export.EXPORT_SUFFIXES, *flatten.PATTERN_SUFFIXES} == {*suffixes(*FAMILIES)}
    listed = running.json("GET", "/api/formats")[1]["formats"]
    assert [one["suffix"] for one in listed] == [one.suffix for one in FORMATS if one.family != "model"]
    offered = [one["suffix"] for one in listed if not one["reason"]]
    assert offered == [one.suffix for one in FORMATS if one.installed and one.family != "model"]
    assert {".stl", ".obj", ".ply", ".glb", ".svg", ".csv"} <= set(offered)
    for suffix in offered:
        status, answer = running.json("POST", "/api/export", order(suffix, MODEL.replace('"m"', '"mm"')))
        if status == 200:
            assert base64.b64decode(answer["content"])
            assert answer["name"] == f"a_tent{suffix}"
        else:  # a net of control points is all that this kind may lack
            assert suffix == ".csv"
            assert "no control points" in answer["error"]


@pytest.mark.parametrize("suffix", ["nonsense", "", ".toml", "../x.stl", ".stl/../../x"])
def test_an_unknown_format_is_refused_in_one_line(running, suffix):
    status, answer = running.json("POST", "/api/export", order(suffix))
    assert status == 422
    assert "\n" not in answer["error"]
    assert "offered" in answer["error"]


def test_what_cannot_be_exported_says_why_without_our_folder(running):
    status, answer = running.json("POST", "/api/export", order(".svg", 'kind = "sphere"'))
    assert status == 422
    assert answer["error"].startswith("SVG drawing: ")
    assert "quintrig-" not in answer["error"]


def test_several_files_are_one_archive(running):
    pair = 'kind = "ruled"\nfirst = [[0,0,0],[1,0,0],[2,0,0],[3,0,0],[4,0,0],[5,0,0]]\n'
    text = pair + "second = [[0,1,0],[1,1,0],[2,1,0],[3,1,0],[4,1,0],[5,1,1]]\n"
    status, answer = running.json("POST", "/api/export", order(".csv", text))
    assert status == 200
    with zipfile.ZipFile(io.BytesIO(base64.b64decode(answer["content"]))) as archive:
        assert sorted(archive.namelist()) == ["ruled-first.csv", "ruled-second.csv"]
    assert answer["notes"][0].startswith("2 files in one ZIP")
