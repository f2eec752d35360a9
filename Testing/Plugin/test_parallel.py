"""Sort-last pictures of several ranks are that of one: test_parallel.py MPIEXEC PVBATCH OUTPUT"""

import os
import subprocess
import sys

import numpy
import session


def draw(mpiexec, pvbatch, ranks, shade, output):
    file = os.path.join(output, "Parallel%d_%d.png" % (ranks, shade))
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "draw_parallel.py")
    # This process is an MPI program itself, whose variables are not for others.
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("OMPI_", "PMIX_"))}
    environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    names = ("DISPLAY", "XAUTHORITY", "FLATBLOCK_PLUGIN", "PYTHONPATH")
    exports = [word for name in names if name in environment for word in ("-x", name)]
    subprocess.run([mpiexec, "--oversubscribe", *exports, "-n", str(ranks), pvbatch,
        "--force-offscreen-rendering", script, file, str(shade)], check=True, env=environment,
        timeout=200)
    return session.read(file)


def main(mpiexec, pvbatch, output):
    for shade in (0, 1):
        serial = draw(mpiexec, pvbatch, 1, shade, output)
        assert serial.std() > 20.0
        for ranks in (2, 4):
            apart = abs(draw(mpiexec, pvbatch, ranks, shade, output) - serial).max(axis=2)
            beyond = numpy.count_nonzero(apart > 2.0)
            print("%d ranks, shade %d: at most %.0f, %d pixels beyond 2" %
                (ranks, shade, apart.max(), beyond))
            assert apart.max() <= 8.0
            # Those at the borders of partitions, where these come to the surface.
            assert beyond <= (60 if shade else 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
    session.end()
