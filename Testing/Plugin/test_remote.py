"""A server's picture is that of the client by itself: test_remote.py PVSERVER OUTPUT"""

import os
import socket
import subprocess
import sys

from paraview import simple

import session


def draw(output, name):
    view = session.make_view()
    view.RemoteRenderThreshold = 0.0
    display = session.show(session.make_wavelet(), view)
    session.look(view)
    picture = session.draw(view, os.path.join(output, "Remote" + name + ".png"))
    return picture, session.get_status(display)


def free_port():
    with socket.socket() as server:
        server.bind(("localhost", 0))
        return server.getsockname()[1]


def wait_for(server):
    """Until it accepts a client."""
    for line in server.stdout:
        if "Accepting connection" in line:
            return


def main(pvserver, output):
    session.load_plugin()
    local, _ = draw(output, "Local")
    assert local.std() > 20.0
    port = free_port()
    server = subprocess.Popen([pvserver, "--force-offscreen-rendering", "--server-port=%d" % port],
        stdout=subprocess.PIPE, text=True)
    try:
        wait_for(server)
        simple.Connect("localhost", port)
        session.load_plugin(remote=True)
        remote, status = draw(output, "Remote")
        print(status)
        assert session.difference(remote, local) <= 2.0
        assert "Visible blocks: 8" in status, status
    finally:
        server.kill()


if __name__ == "__main__":
    main(*sys.argv[1:])
    session.end()
