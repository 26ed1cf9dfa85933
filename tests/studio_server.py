"""A studio's server in a thread, for tests."""

import http.client
import json
import threading
import time
from pathlib import Path

from quintrig.studio import server

MODEL = 'name = "A tent"  # a remark\nunit = "m"\nkind = "cone"\nradius = 2  # of the base\nheight = 3\n'


class Running:
    """A server over a folder, and requests to it with any headers."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.site = server.site(folder / "tent.toml")
        self.server = server.serving(self.site)
        self.thread = threading.Thread(target=self.server.run, daemon=True)
        self.thread.start()
        while not self.server.started:
            time.sleep(0.02)
        self.own = {
            "Host": f"127.0.0.1:{self.site.port}",
            "Origin": f"http://127.0.0.1:{self.site.port}",
            "Cookie": f"quintrig_{self.site.port}={self.site.token}",
        }

    def ask(self, method, path, body=None, headers=None, without=()):
        given = {**self.own, **(headers or {})}
        for name in without:
            given.pop(name)
        connection = http.client.HTTPConnection("127.0.0.1", self.site.port, timeout=20)
        connection.putrequest(method, path, skip_host=True, skip_accept_encoding=True)
        data = body.encode() if isinstance(body, str) else json.dumps(body).encode() if body is not None else b""
        for name, value in {"Content-Length": str(len(data)), **given}.items():
            connection.putheader(name, value)
        connection.endheaders(data)
        answer = connection.getresponse()
        text = answer.read()
        connection.close()
        return answer.status, dict(answer.getheaders()), text

    def json(self, *arguments, **options):
        status, _, text = self.ask(*arguments, **options)
        return status, json.loads(text)

    def stop(self):
        self.server.should_exit = True
        self.thread.join(10)
